"""The derivatives of the joint form as one program of the whole robot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..ir.program import Program, Value
from ..topology.chain import Chain
from .brakes import ROWS
from .functions import Functions
from .fused import fuse, inputs
from .linearise import closed_slopes, slopes
from .loops import Loads


def linearisation(chain: Chain, constants: str = "constants", own: bool = True) -> Program:
    """``(q, v, tau, w_ext, m_eta, f_eta) -> (vdot, M, f_q, f_v)`` in one program; ``own``: see :func:`slopes`.

    ``M`` is the lower triangle row by row, ``f_q`` and ``f_v`` are (nv, nv), row by row.  Forward dynamics and
    its guards are included, so common operations are computed once.  Where loops close the tree: also the forces
    ``row`` (rows,) of its rows, ``J`` and the derivatives ``J_q`` and ``J_v`` of ``J vdot + drift``, (rows, nv) each.
    Where rows share forces: also the accelerations of gaps ``wanted`` of these, (rows,).
    With other inputs than torques: also ``exerted``, the generalised forces per unit of each, (inputs, nv). With
    internal states of forces between frames: also ``f_z`` (states, nv). With brakes: the ``ROWS`` that they act on.
    """

    def body(f: Functions, x: Mapping[str, Sequence[Value]]) -> dict[str, list[Value]]:
        f.given = (x["m_eta"], x["f_eta"])
        given = x["q"], x["v"], x["tau"], x["w_ext"]
        rows: dict[str, list[Value]] = {}
        if chain.closing.rows:
            vdot, found, closing = closed_slopes(f, *given, own)
            rows = {"row": list(closing.forces), "J": list(closing.J.flat)}
            rows |= {"J_q": list(closing.by_q.flat), "J_v": list(closing.by_v.flat)}
            if chain.closing.overconstrained:
                loads = Loads(x["tau"], f.under_inputs(x["tau"]).with_forces(x["q"], x["v"], x["w_ext"]))
                rows["wanted"] = f.wanted(x["q"], x["v"], loads)[1]
        else:
            vdot, _ = f.forward_dynamics(*given)
            found = slopes(f, x["q"], x["v"], vdot, x["w_ext"], x["tau"], own)
        lower = [found.M[i, j] for i in range(chain.nv) for j in range(i + 1)]
        exerted = f.exerted(x["q"], x["v"], x["tau"]) if chain.other_inputs else []
        rows |= {"exerted": [x for force in exerted for x in force]} if chain.other_inputs else {}
        if chain.braked:
            braked = f.braked_rows(x["q"], x["v"], vdot, x["tau"], x["w_ext"])
            rows |= dict(zip(ROWS, braked, strict=True))
        states = np.arange(chain.n_internal)[chain.force_states.start - chain.nv :]
        rows |= {"f_z": list(found.f_z[:, states].T.flat)} if chain.n_force_states else {}
        return {"vdot": vdot, "M": lower, "f_q": list(found.f_q.flat), "f_v": list(found.f_v.flat)} | rows

    return fuse(chain, "linearisation", inputs(chain, "q v tau w_ext m_eta f_eta"), body, constants)
