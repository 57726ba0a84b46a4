"""Programs of what acts on the tips of a tree: loops and forces between frames, as :mod:`.fused` makes them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.program import Program
from ..topology.chain import Chain
from .dae_functions import DaeFunctions
from .functions import Functions
from .fused import Outputs, fuse, inputs, program


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


def row_terms(chain: Chain, constants: str = "parameters", dae: bool = False) -> Program:
    """``(q, v) -> (terms)``: of the rows that give way, see :mod:`.compliant_functions`.

    ``dae``: of a state ``x`` of the DAE form in place of ``q`` and ``v``.
    """

    def body(f: Functions, x: Mapping[str, Sequence]) -> Outputs:
        return {"terms": f.row_terms(*_state(f, x))}

    return fuse(
        chain, "row_terms", inputs(chain, "x" if dae else "q v"), body, constants, DaeFunctions if dae else Functions
    )


def row_wrenches(chain: Chain, constants: str = "parameters", dae: bool = False) -> Program:
    """``(q, v, tau, w_ext, m_eta, f_eta, terms, h, ahead) -> (acted)``: wrenches with what they bear besides."""

    def body(f: Functions, x: Mapping[str, Sequence]) -> Outputs:
        f.given = (x["m_eta"], x["f_eta"])
        q, v = _state(f, x)
        return {"acted": f.with_rows(q, v, x["tau"], x["w_ext"], x["terms"], x["h"][0], x["ahead"][0])}

    given = inputs(chain, f"{'x' if dae else 'q v'} tau w_ext m_eta f_eta")
    given = {**given, "terms": 2 * len(chain.compliant), "h": 1, "ahead": 1}
    return fuse(chain, "row_wrenches", given, body, constants, DaeFunctions if dae else Functions)


def settled_rows(chain: Chain, constants: str = "parameters") -> Program:
    """``(q, v, tau, w_ext, h) -> (acted)``: what a run of steps of ``h`` reports under, :meth:`.settled`."""

    def body(f: Functions, x: Mapping[str, Sequence]) -> Outputs:
        return {"acted": f.settled(x["q"], x["v"], x["tau"], x["w_ext"], x["h"][0])}

    return fuse(chain, "settled_rows", inputs(chain, "q v tau w_ext") | {"h": 1}, body, constants)


COMPLIANT = (row_terms, row_wrenches)
"""What implicit stages run before their dynamics where loops or lines give way: at the start, and at their states."""


def _state(f: Functions, x: Mapping[str, Sequence]) -> tuple[Sequence, Sequence]:
    """Coordinates and rates, of the state of either form."""
    return f.coordinates(x["x"]) if isinstance(f, DaeFunctions) else (x["q"], x["v"])


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
