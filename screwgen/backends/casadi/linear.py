"""Exact first derivatives by CasADi: of the dynamics with its measurable outputs, and of the statics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import casadi as ca

from ...algorithms import fused
from ...algorithms.functions import Functions
from ...bodies.markers import strains
from ...spec.parameters import parameters
from ...topology.chain import Chain
from .expressions import expressions
from .functions import coordinate_rates, function, symbols


def linearisation(chain: Chain) -> ca.Function:
    """``(q, v, tau, w_ext, p) -> (vdot, y, vdot_x, vdot_u, y_x, y_u)`` with x = [δ; v], u = [tau; vec(w_ext)].

    δ (nv) are small changes of q: those of its entries, but of a floating base the rotation vector and the displacement
    in axes of F_1. y stacks q, v, the last tip's position, velocity and acceleration in the inertial frame (m, m/s,
    m/s²), the joint wrenches link by link (6 n) and the strains of :func:`base_strains`.
    """
    given = symbols(chain, "q v tau w_ext p")
    q, v, p = given["q"], given["v"], given["p"]
    qdot = coordinate_rates(chain, q, v, p)
    dynamics = expressions(fused.forward_dynamics(chain), given)
    vdot, position = dynamics["vdot"], expressions(fused.poses(chain), given)["tip_position"][-3:]
    velocity = along(position, q, qdot)
    acceleration = along(velocity, q, qdot) + along(velocity, v, vdot)
    y = ca.vertcat(q, v, position, velocity, acceleration, dynamics["wrench"], base_strains(chain, q, p))
    u, moving = ca.vertcat(given["tau"], ca.vec(given["w_ext"])), ca.jacobian(qdot, v)
    slopes = {}
    for name, f in (("vdot", vdot), ("y", y)):
        slopes[f"{name}_x"] = ca.horzcat(ca.jacobian(f, q) @ moving, ca.jacobian(f, v))
        slopes[f"{name}_u"] = ca.jacobian(f, u)
    return function("linearisation", given, vdot=vdot, y=y, **slopes)


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


def strain_function(chain: Chain) -> ca.Function:
    """The CasADi function ``(q, p) -> (strain)`` of :func:`base_strains`."""
    q, p = ca.SX.sym("q", chain.nq), ca.SX.sym("p", len(parameters(chain.robot)))
    return ca.Function("base_strains", [q, p], [base_strains(chain, q, p)], ["q", "p"], ["strain"])


def base_strains(chain: Chain, q: ca.SX, p: ca.SX) -> ca.SX:
    """The strains of the beam at the base section of every link, one for each of its directions that has modes.

    Axial: u_x' (1); bending: the curvatures u_y'' and u_z'' (1/m); torsion: the twist θ_x' (rad/m);
    shear: γ_y and γ_z (1).
    """
    names = [x.name for x in parameters(chain.robot)]
    rows = []
    for i in chain.firsts:
        segment, first = chain.segments[i], chain.eta_q + chain.eta_offset[i]
        for strain in strains(chain.keys[i], 0.0):
            length = p[names.index(f"{segment.owner}.length")] / segment.count
            eta = q[[first + k for k in strain.modes]]
            rows.append(ca.dot(ca.DM(strain.weights), eta) / length**strain.order)
    return ca.vertcat(ca.SX(0, 1), *rows)
