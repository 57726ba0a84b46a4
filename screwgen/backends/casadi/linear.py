"""Exact first derivatives by CasADi: of the dynamics with its measurable outputs, and of the statics."""

from __future__ import annotations

import casadi as ca

from ...algorithms import fused
from ...algorithms.functions import Functions
from ...bodies.markers import strains
from ...spec.parameters import parameters
from ...topology.chain import Chain
from .functions import expressions, function


def linearisation(chain: Chain) -> ca.Function:
    """``(q, v, tau, w_ext, p) -> (vdot, y, vdot_x, vdot_u, y_x, y_u)`` with x = [q; v], u = [tau; vec(w_ext)].

    y stacks q, v, the last tip's position, velocity and acceleration in the inertial frame (m, m/s, m/s²), the joint
    wrenches link by link (6 n) and the strains of :func:`base_strains`.
    """
    chain.needs_fixed_tree("linear model", "differentiate casadi()['step']")
    sizes = {"q": (chain.nq, 1), "v": (chain.nv, 1), "tau": (chain.n_tau, 1), "w_ext": (6, chain.n)}
    given = {name: ca.SX.sym(name, *size) for name, size in sizes.items()} | parameter_symbols(chain)
    q, v, p = given["q"], given["v"], given["p"]
    dynamics = expressions(fused.forward_dynamics(chain), given)
    vdot, position = dynamics["vdot"], expressions(fused.poses(chain), given)["tip_position"][-3:]
    velocity = along(position, q, v)
    acceleration = along(velocity, q, v) + along(position, q, vdot)
    y = ca.vertcat(q, v, position, velocity, acceleration, dynamics["wrench"], base_strains(chain, q, p))
    x, u = ca.vertcat(q, v), ca.vertcat(given["tau"], ca.vec(given["w_ext"]))
    slopes = {f"{n}_{m}": ca.jacobian(f, s) for n, f in (("vdot", vdot), ("y", y)) for m, s in (("x", x), ("u", u))}
    return function("linearisation", given, vdot=vdot, y=y, **slopes)


def along(f: ca.SX, q: ca.SX, direction: ca.SX) -> ca.SX:
    """The derivative of f along a direction of q; zero without q."""
    return ca.jtimes(f, q, direction) if q.numel() else ca.SX.zeros(*f.shape)


def parameter_symbols(chain: Chain) -> dict[str, ca.SX]:
    return {"p": ca.SX.sym("p", len(parameters(chain.robot)))}


def statics(chain: Chain) -> ca.Function:
    """``(q, w_ext, p) -> (potential, force, stiffness, weight, wrench, tip)`` at rest.

    ``force`` (nq) is what must act on the coordinates to keep the arm there, springs included; ``stiffness`` its
    derivative with q; ``weight`` (nq x 3) its derivative with gravity; ``wrench`` the joint wrenches (6 x n);
    ``tip`` the last tip's position (3).
    """
    chain.needs_fixed_tree("equilibrium", "simulate it with dampers, or with PD control")

    def body(f: Functions, x):
        rest = [0.0] * chain.nv
        force, wrench = f.statics(x["q"], x["w_ext"])
        energy, tip = f.energy(x["q"], rest)[1], f.poses(x["q"])[1][chain.last][1]
        return {"force": force, "wrench": wrench, "potential": [energy], "tip": tip}

    given = {"q": ca.SX.sym("q", chain.nq), "w_ext": ca.SX.sym("w_ext", 6, chain.n)} | parameter_symbols(chain)
    found = expressions(fused.fuse(chain, "statics", {"q": chain.nq, "w_ext": 6 * chain.n}, body), given)
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
