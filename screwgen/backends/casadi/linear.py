"""Exact first derivatives: of the dynamics with its measurable outputs, of loops and of the statics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import casadi as ca

from ...algorithms import fused
from ...algorithms import linear_model as linear_models
from ...algorithms.functions import Functions
from ...topology.chain import Chain
from .expressions import expressions
from .functions import coordinate_rates, function, symbols


def linear_model(chain: Chain) -> ca.Function:
    """The program :func:`..algorithms.linear_model.changes`; where directions have columns the results have them."""
    program = linear_models.changes(chain)
    given = symbols(chain, "q v tau w_ext p") | {n: ca.SX.sym(n, k) for n, k in program.inputs.items() if n[:2] == "d_"}
    return function("linear_model", given, **expressions(program, given))


def closing(chain: Chain) -> ca.Function:
    """``(q, v, forces, p) -> (gap, J, J_v, bend, wrench)`` of the loops, with δ (nv) as above.

    ``gap`` (rows); ``J`` (rows x nv) is its derivative with δ, ``J_v`` that of ``J v``; ``bend`` (nv x nv) is that of
    ``Jᵀ forces``; ``wrench`` (6 x n): what forces of the rows exert on the tips, in the tip frames.
    """
    rows = len(chain.closures)
    given = symbols(chain, "q v") | {"forces": ca.SX.sym("forces", rows)} | symbols(chain, "p")

    def body(f: Functions, x: Mapping[str, Sequence]) -> fused.Outputs:
        gap, loads = f.loops_at(x["q"], x["forces"])
        return {"gap": gap, "wrench": loads.w_ext}

    found = expressions(fused.fuse(chain, "closing", {"q": chain.nq, "forces": rows}, body), given)
    q, v, qdot = given["q"], given["v"], coordinate_rates(chain, given["q"], given["v"], given["p"])
    rate, moving = along(found["gap"], q, qdot), ca.jacobian(qdot, v)
    J = ca.jacobian(rate, v)
    return function(
        "closing",
        given,
        gap=found["gap"],
        J=J,
        J_v=ca.jacobian(rate, q) @ moving,
        bend=ca.jacobian(J.T @ given["forces"], q) @ moving,
        wrench=ca.reshape(found["wrench"], 6, chain.n),
    )


def along(f: ca.SX, q: ca.SX, direction: ca.SX) -> ca.SX:
    """The derivative of f along a direction of q; zero without q."""
    return ca.jtimes(f, q, direction) if q.numel() else ca.SX.zeros(*f.shape)


def statics(chain: Chain) -> ca.Function:
    """``(q, w_ext, p) -> (potential, force, stiffness, weight, wrench, tip)`` at rest.

    ``force`` (nq) is what must act on the coordinates to keep the arm there, springs included; ``stiffness`` its
    derivative with q; ``weight`` (nq x 3) its derivative with gravity; ``wrench`` the joint wrenches (6 x n);
    ``tip`` the last tip's position (3). Of a robot with loops all but ``tip`` is that of the open tree.
    """
    chain.needs_sums("statics", "simulate it with dampers")
    chain.needs_fixed("equilibrium", "simulate it with dampers, or with PD control")

    def body(f: Functions, x: Mapping[str, Sequence]) -> fused.Outputs:
        rest = [0.0] * chain.nv
        force, wrench = f.statics(x["q"], x["w_ext"])
        energy, tip = f.energy(x["q"], rest)[1], f.poses(x["q"])[1][chain.last][1]
        return {"force": force, "wrench": wrench, "potential": [energy], "tip": tip}

    given = symbols(chain, "q w_ext p")
    found = expressions(fused.fuse(chain, "statics", fused.inputs(chain, "q w_ext"), body), given)
    return function(
        "statics",
        given,
        potential=found["potential"],
        force=found["force"],
        stiffness=ca.jacobian(found["force"], given["q"]),
        weight=ca.jacobian(found["force"], given["p"])[:, :3],
        wrench=ca.reshape(found["wrench"], 6, chain.n),
        tip=found["tip"],
    )
