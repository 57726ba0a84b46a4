"""The Z-form in CasADi: ``exponential``, ``cauchy_state``, ``z_form``, ``assemble_z`` and ``cauchy``.

``x_c`` is the state of (109), in the order of ``model.cauchy_names``; ``q`` holds the joint coordinates as memory.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache

import casadi as ca

from ..algorithms.dae_functions import unknown_size
from ..backends.casadi.expressions import expressions
from ..backends.casadi.functions import function, symbols
from ..topology.chain import Chain
from . import z_functions as z
from .z_form import FULL_TURN

SMALL = 1e-2
TERMS = 12
"""The series of the arc tangent below that squared slope, and its length."""

Parts = dict[str, ca.SX]


def z_functions(chain: Chain) -> dict[str, Callable[[], ca.Function]]:
    """What makes the functions of the Z-form, by name.

    ``exponential (theta) -> (R, J, J_inverse)``: 3, rad -> 3 x 3; ``R`` takes F_i to inertial components,
    ``omega = J thetadot`` in F_i, (jacobian); ``J_inverse`` is infinite from ``|theta| = 2 pi`` on.
    ``cauchy_state (q, v, p) -> (x_c)``, (109): 12 n + 2 sum(r); rad, m, rad/s, m/s in F_i, all coordinates as input.
    ``z_form (x_c, q, p) -> (T_gamma, Gamma_star, h_Ms, M_dyn, h_dyn)``, (MsPsi), (HMs), (97): 12 n (square), sparse;
    of ``(x_c, q, tau, p)`` where inputs change free fall.
    ``assemble_z (x_c, q, tau, w_ext, p) -> (M_sys, H_sys, W_sys)``, (98)-(100): 12 n + sum(r) (square), sparse, the
    unknowns ``[w_1; Zdot_1; ...; w_n; Zdot_n; etaddot]``.
    ``cauchy (x_c, q, tau, w_ext, p) -> (A_c, g_c, qdot, wrench)``, (110), (111) with E18: ``x_c``'s rate is
    ``A_c x_c + g_c``; ``qdot`` is the rate of the memory ``q``, ``wrench`` 6 x n, N m and N.
    """
    given = {"x_c": ca.SX.sym("x_c", z.cauchy_size(chain)), "q": ca.SX.sym("q", chain.n_joints)}
    given |= symbols(chain, "tau w_ext p")
    placed = symbols(chain, "q v p")
    short = {name: given[name] for name in ("x_c", "q", *["tau"] * chain.falls, "p")}
    assembled = cache(lambda: _assembled(chain, given))
    return {
        "exponential": _exponential,
        "cauchy_state": lambda: function("cauchy_state", placed, x_c=_cauchy_state(chain, placed)),
        "z_form": lambda: function("z_form", short, **assembled()[0]),
        "assemble_z": lambda: function("assemble_z", given, **assembled()[1]),
        "cauchy": lambda: function("cauchy", given, **_cauchy(chain, given)),
    }


def _exponential() -> ca.Function:
    """``theta -> (R, J, J_inverse)``; from a full turn on ``J_inverse`` is infinite."""
    theta = ca.SX.sym("theta", 3)
    out = expressions(z.exponential(), {"theta": theta})
    R, J, J_inverse = (ca.reshape(out[name], 3, 3).T for name in ("R", "J", "J_inverse"))
    return function(
        "exponential", {"theta": theta}, R=R, J=J, J_inverse=_ending(J_inverse, FULL_TURN - ca.sumsqr(theta))
    )


def _ending(J_inverse: ca.SX, margin: ca.SX) -> ca.SX:
    """Infinite where exponential coordinates have ended: never a wrong number."""
    return ca.if_else(margin > 0, J_inverse, ca.inf)


def rotation_vector(quaternion: ca.SX) -> ca.SX:
    """The rotation vector of a quaternion (w, x, y, z) of any length, its angle in [0, pi].

    Regular at rest.  At half a turn ``theta`` and ``-theta`` are one rotation: the sign of the quaternion decides,
    and a motion through it makes ``theta`` jump.
    """
    Q = ca.if_else(quaternion[0] < 0, -quaternion, quaternion)
    w, u = Q[0], Q[1:]
    s2 = ca.sumsqr(u)
    near = s2 < SMALL * w**2
    slope2 = ca.if_else(near, s2 / ca.if_else(near, w**2, 1), 0)
    series = ca.SX(0)
    for k in reversed(range(TERMS)):
        series = 1 / (2 * k + 1) - slope2 * series
    s = ca.sqrt(ca.if_else(near, 1, s2))
    return 2 * u * ca.if_else(near, series / ca.if_else(near, w, 1), ca.atan2(s, w) / s)


def _cauchy_state(chain: Chain, given: Mapping[str, ca.SX]) -> ca.SX:
    parts = expressions(z.z_placement(chain), given)
    turns, places = ca.vertsplit(parts["quaternion"], 4), ca.vertsplit(parts["r"], 3)
    poses = [x for Q, r in zip(turns, places, strict=True) for x in (rotation_vector(Q), r)]
    return ca.vertcat(*poses, parts["eta"], parts["Z"], parts["etadot"])


def _assembled(chain: Chain, given: Mapping[str, ca.SX]) -> tuple[Parts, Parts]:
    """The pieces of the dynamic rows, and the whole system."""
    program, places = z.z_assembly(chain)
    parts, size, dynamic = expressions(program, given), unknown_size(chain), 12 * chain.n
    M = ca.SX.triplet([i for i, _ in places], [j for _, j in places], parts["M"], size, size)
    pieces = {
        "T_gamma": _stacked_T(chain, parts["T_gamma"]),
        "Gamma_star": _at_twists(ca.vertsplit(parts["gamma_star"], 6)),
        "h_Ms": parts["h_Ms"],
        "M_dyn": M[:dynamic, :dynamic],
        "h_dyn": parts["H"][:dynamic],
    }
    return pieces, {"M_sys": M, "H_sys": parts["H"], "W_sys": parts["W"]}


def _stacked_T(chain: Chain, entries: ca.SX) -> ca.SX:
    """``diag(0, T_gamma_1, ..., 0, T_gamma_n)``."""
    blocks = [ca.sparsify(ca.reshape(e, 6, 6).T) for e in ca.vertsplit(entries, 36)]
    return ca.diagcat(*(x for block in blocks for x in (ca.SX(6, 6), block)))


def _at_twists(columns: Sequence[ca.SX]) -> ca.SX:
    """Columns at the places of ``Zdot``, nothing at those of the wrenches."""
    return ca.vertcat(*(x for column in columns for x in (ca.SX(6, 1), ca.sparsify(column))))


def _cauchy(chain: Chain, given: Mapping[str, ca.SX]) -> Parts:
    """``A_c`` and ``g_c`` of (111), with the inverse Jacobian (E18); rates of the memory and the joint wrenches."""
    parts = expressions(z.z_dynamics(chain), given)
    n, r = chain.n, chain.n_modes
    rows = zip(ca.vertsplit(parts["J_inverse"], 9), ca.vertsplit(parts["margin"]), strict=True)
    J = [ca.diagcat(_ending(ca.reshape(e, 3, 3).T, margin), ca.SX.eye(3)) for e, margin in rows]
    A_c = ca.SX(z.cauchy_size(chain), z.cauchy_size(chain))
    A_c[: 6 * n, 6 * n + r : 12 * n + r] = ca.diagcat(*J)
    A_c[6 * n : 6 * n + r, 12 * n + r :] = ca.SX.eye(r)
    g_c = ca.vertcat(ca.SX(6 * n + r, 1), parts["Zdot"], parts["etaddot"])
    return {"A_c": A_c, "g_c": g_c, "qdot": parts["qdot"], "wrench": ca.reshape(parts["wrench"], 6, n)}
