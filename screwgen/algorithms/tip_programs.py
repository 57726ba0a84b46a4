"""Programs of what acts on the tips of a tree: loops and forces between frames, as :mod:`.fused` makes them."""

from __future__ import annotations

from collections.abc import Sequence

from .functions import Functions
from .fused import Outputs, program


@program("q v tau w_ext m_eta f_eta")
def loop_wrenches(f: Functions, **x: Sequence) -> Outputs:
    """``(q, v, tau, w_ext, m_eta, f_eta) -> (closed)``: the wrenches on all tips, those of the loops included.

    With couplings also ``closed_tau``, the torques of all axes with those of couplings, and ``borne``, the latter on
    axes whose motion is given.
    """
    f.given = (x["m_eta"], x["f_eta"])
    given = x["q"], x["v"], x["tau"], x["w_ext"]
    found = f.with_loops(*given)
    if not f.chain.closing.couplings:
        return {"closed": found.w_ext}
    torques = f.coupling_torques(*given) if f.chain.prescribed else ()
    return {"closed": found.w_ext, "closed_tau": found.tau, "borne": [torques[k] for k in f.chain.prescribed]}


@program("q v (tau) w_ext")
def acting_wrenches(f: Functions, q: Sequence, v: Sequence, w_ext: Sequence, tau: Sequence = ()) -> Outputs:
    """``(q, v, w_ext) -> (acted)``: the wrenches on all tips in their frames, those of forces included."""
    return {"acted": f.under_inputs(tau).with_forces(q, v, w_ext)}


@program("q v")
def correction(f: Functions, q: Sequence, v: Sequence) -> Outputs:
    """``(q, v) -> (new_q, new_v)``: one correction of the gaps of the loops and of their rates."""
    return dict(zip(("new_q", "new_v"), f.correct(q, v), strict=True))


@program("q")
def openings(f: Functions, q: Sequence) -> Outputs:
    """``(q) -> (openings)``: the squares of how far each loop is from closed, of distance and angle."""
    return {"openings": f.openings(q)}


@program("q")
def gaps(f: Functions, q: Sequence) -> Outputs:
    """``(q) -> (gap)`` of every row of loops."""
    return {"gap": f.gaps(q, [0.0] * f.chain.nv)[0]}


@program("")
def idle_gaps(f: Functions) -> Outputs:
    """The ``gaps`` of the rows of loops that no motion changes."""
    return {"gaps": f.idle_gaps()}
