"""Results of integrators and other functions for the self-check of generated code, as weighted sums.

The arithmetic is that of doubles, and functions are rounded once from many digits: the same on every machine.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from ...algorithms import fused
from ...algorithms.dae_functions import DaeFunctions
from ...algorithms.functions import HOLD, Functions
from ...bodies.validity import BOUNDS
from ...errors import SingularError
from ...integrators.method import Method, Motion
from ...integrators.methods import METHODS
from ...lazily import mpmath
from ...spec.parameters import parameters
from ...topology.chain import Chain
from .dae_step import DaeDynamics, HeldDae, space_of
from .numeric import EPSILON
from .own_forces import CoordinateForces
from .reference import Case, evaluation

LONGEST = 0.05
SHORTEST = 1e-9
"""The longest step and the shortest, s."""

SHARE = 0.3
"""A step is so short that no joint moves further, rad or m, and that accelerations change by about that share."""

FASTEST = 1.0
"""The radians by which the stiffest mode swings in LONGEST. Stiffer modes would hide what else a step does."""

FULL_TURN = 6.28

HASTE = 3.0
"""The factor of the case's rates, which makes terms of higher order visible."""

FAR, NEARER, STIFFEST = 0.03, 0.5, 1e6
"""How far loads may bend a mode where rest is sought, m or rad; the largest share of a round's motion by which the next
may move the modes; and the largest factor of their stiffness."""

DEFECT, SLIGHT = 0.01, 1e-4
"""The largest defect; and that of rows that share forces, which depend on each other where loops are closed: farther
from there the projection multiplies rounding."""


class Sums(NamedTuple):
    """Weighted sums of results at a case, inputs held.

    A step takes `dt` seconds from the case's coordinates at HASTE times its rates, with every stiffness multiplied by
    `softness` squared and every damping by `softness`. That of the DAE form starts with `defect` added to all poses and
    twists, so that the projection has something to do. `joint` and `dae`: the results of each method, in the one form
    four sums for joint coordinates, modal coordinates and the rates of both; in the other six for quaternions,
    positions, eta, twists, etadot and q. `poses`: rotations and positions of all links, then of all tips. `measures`:
    those of validity, and their bounds.
    """

    dt: float
    defect: float
    softness: float
    joint: list[list[float]]
    dae: list[list[float]]
    poses: list[float]
    measures: list[float]


class _Soft:
    """The functions of a robot in doubles, with inertia, stiffness and damping (n_inertia,) of softened modes."""

    def __init__(self, chain: Chain, case: Case):
        world = fused.world(chain, [p.value for p in parameters(chain.robot)])
        apply = evaluation(chain, _rounded, EPSILON)
        self.chain, self.functions = chain, DaeFunctions(chain, fused.baked(chain), world, apply)
        self.holding = Functions(chain, fused.baked(chain, (HOLD,)), world, apply)
        self.given, self.w_ext = case["tau"], case["w_ext"]
        self.tau = self.given
        M, K, D, *laws = (np.array(column) for column in fused.columns(chain, self.functions.constants).values())
        modes = slice(chain.n_given - chain.n_inner, chain.n_given)
        fastest = np.sqrt(max(K[modes] / M[modes], default=0.0))
        self.softness = min(1.0, float(FASTEST / (LONGEST * fastest))) if fastest else 1.0
        self.columns = M, K * self.softness**2, D * self.softness, *laws
        self.own = CoordinateForces.of_columns(chain, self.columns)

    def explicit(self, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return self.implicit(q, v, 0.0)

    def implicit(self, q: np.ndarray, v: np.ndarray, h: float, there: Motion | None = None) -> np.ndarray:
        at_q, at_v = there or (q, v)
        own = self.own.over(q, v, h, at_v)
        self.functions.given = (own.inertia(h).tolist(), own.force_of(q, v, h).tolist())
        f, moved = self.functions, (at_q.tolist(), at_v.tolist())
        w_ext: Sequence = self.w_ext
        if self.chain.compliant and h:
            ahead = float(at_q is not q)
            w_ext = f.with_rows(*moved, self.tau, w_ext, f.row_terms(q.tolist(), v.tolist()), h, ahead)
        vdot = np.array(f.forward_dynamics(*moved, self.tau, w_ext)[0])
        out = np.append(vdot, own.internal_rates(vdot))
        if self.chain.n_force_states:
            of_forces, start = self.functions.under_inputs(self.tau), v[self.chain.force_states].tolist()
            out[self.chain.force_states] = of_forces.force_rates(at_q.tolist(), at_v.tolist(), start, h)
        return out

    def step(self, method: Method, q: np.ndarray, v: np.ndarray, dt: float) -> Motion:
        """A step of the joint form."""
        self.hold(q, v)
        q, v = method.step(self, q, v, dt, space_of(self.chain))
        return self.chain.unit(q), v

    def hold(self, q: np.ndarray, v: np.ndarray) -> list[float]:
        """The inputs that a step from here holds."""
        if self.chain.holds:
            self.tau = self.holding.held(q.tolist(), v.tolist(), self.given)
        return self.tau

    def parts(self, q: np.ndarray, v: np.ndarray) -> list[np.ndarray]:
        """Coordinates, modal ones apart, and rates likewise."""
        return [*np.split(q, [self.chain.eta_q]), *np.split(v, [self.chain.eta_v])]

    def dae(self) -> DaeDynamics:
        """The DAE form of the same functions."""
        f = self.functions

        def solve(
            x: np.ndarray, tau: np.ndarray, w_ext: np.ndarray, inertia: np.ndarray, force: np.ndarray
        ) -> list[np.ndarray]:
            f.given = (inertia.tolist(), force.tolist())
            return [np.array(y) for y in f.rates(x.tolist(), tau.tolist(), w_ext.tolist())]

        def project(x: np.ndarray) -> tuple[np.ndarray]:
            return (np.array(f.project(x.tolist())),)

        def joint_rates(x: np.ndarray) -> tuple[np.ndarray]:
            return (np.array(f.joint_rates(x.tolist())),)

        def memory(x: np.ndarray, tau: np.ndarray, start: np.ndarray, h: float) -> tuple[np.ndarray]:
            given, under = f.coordinates(x.tolist()), f.under_inputs(tau.tolist())
            return (np.array(under.force_rates(*given, start.tolist(), h)),)

        def terms(x: np.ndarray) -> tuple[np.ndarray]:
            return (np.array(f.row_terms(*f.coordinates(x.tolist()))),)

        def wrenches(
            x: np.ndarray,
            tau: np.ndarray,
            w_ext: np.ndarray,
            inertia: np.ndarray,
            force: np.ndarray,
            own: np.ndarray,
            *over: float,
        ) -> tuple[np.ndarray]:
            f.given, held = (inertia.tolist(), force.tolist()), (tau.tolist(), w_ext.tolist(), own.tolist())
            return (np.array(f.with_rows(*f.coordinates(x.tolist()), *held, *over)),)

        own = memory if self.chain.n_force_states else None
        rows = (terms, wrenches) if self.chain.compliant else ()
        return DaeDynamics(self.chain, self.columns, solve, project, joint_rates, own, rows)


def sums(chain: Chain, case: Case, methods: Sequence[Method]) -> Sums:
    """The sums of a case, with a step of every method, all of which stay where the robot can be.

    Raises SingularError where no step is so short.
    """
    with mpmath.workdps(fused.DIGITS), np.errstate(all="ignore"):
        soft = _Soft(chain, case)
        q, v = np.array(case["q"]), HASTE * np.array(case["v"])
        found, dt, defect = None, _length(soft, q, v), SLIGHT if soft.chain.closing.overconstrained else DEFECT
        while found is None:
            found = _steps(soft, methods, q, v, dt, defect)
            dt, defect = (dt, defect) if found else (dt / 4, defect / 4)
            if dt < SHORTEST:
                raise soft.chain.singular(0)
        f = soft.functions
        f.given = None
        return Sums(dt, defect, soft.softness, *found, _poses(f, case), _measures(f, case))


Ends = list[list[float]]


def _steps(
    soft: _Soft, methods: Sequence[Method], q: np.ndarray, v: np.ndarray, dt: float, defect: float
) -> tuple[Ends, Ends] | None:
    """The sums after a step of every method in either form; None where one leaves the postures that are possible."""
    dae, start = soft.dae(), np.array(soft.functions.place(q.tolist(), v.tolist()))
    start[dae.pose] += defect
    start[dae.twist] += defect
    rates = v.copy()
    rates[dae.joints] = dae.joint_rates(start)[0]
    try:
        joint = [[weighted_sum(part) for part in soft.parts(*soft.step(x, q, v, dt))] for x in methods]
        held = np.array(soft.hold(q, rates)), np.array(soft.w_ext)
        ends = [_sums(dae, dae.project(HeldDae(dae, start, *held, dt).step(x))) for x in methods]
    except SingularError:
        return None
    return (joint, ends) if np.isfinite(joint).all() and np.isfinite(ends).all() else None


def stiffer(chain: Chain, case: Case) -> float:
    """The factor of the modes' stiffness with which the search for rest in the posture of a case comes near it; 1 if
    that of their own will do.

    With it no mode bends beyond FAR, and the second of the search's rounds moves them by half of the first or less.
    Where they bend by metres, or what lines and tendons do changes more than the stress of modes, the search goes
    astray: every round multiplies what is left, and the rounding of what is multiplied.
    """
    constants, modes = fused.baked(chain), slice(chain.n_given - chain.n_modes, chain.n_given)
    world = fused.world(chain, [p.value for p in parameters(chain.robot)])
    functions = Functions(chain, constants, world, evaluation(chain, _rounded, EPSILON))
    stiffness = np.array(fused.columns(chain, constants)["K"])[:, None]
    K = chain.modal_product(stiffness, np.eye(chain.n_given))[modes, modes]

    def moved(eta: np.ndarray) -> np.ndarray:
        """By how much the search would move modes that are bent so, had they the stiffness of their own."""
        force = functions.statics([*case["q"][: chain.eta_q], *eta.tolist()], case["w_ext"])[0][chain.eta_v :]
        return -np.linalg.solve(K, np.array(force, float))

    with mpmath.workdps(fused.DIGITS):
        bent = moved(np.zeros(chain.n_modes))
        largest = np.abs(bent).max(initial=0.0)
        factor = max(1.0, float(f"{largest / FAR:.0e}"))
        while largest and factor < STIFFEST:
            with contextlib.suppress(SingularError):
                there = bent / factor
                if np.abs(moved(there) - (factor - 1) * there).max() <= NEARER * largest:
                    break
            factor *= 2
    return factor


def _poses(f: Functions, case: Case) -> list[float]:
    links, tips = (zip(*places, strict=True) for places in f.poses(case["q"]))
    return [weighted_sum(x for part in parts for x in part) for parts in (*links, *tips)]


def _measures(f: Functions, case: Case) -> list[float]:
    _, wrench, motion = f.watched_dynamics(case["q"], case["v"], case["tau"], case["w_ext"])
    return [weighted_sum(f.measures(case["q"], wrench, motion)), weighted_sum(BOUNDS.values())]


def _length(soft: _Soft, q: np.ndarray, v: np.ndarray) -> float:
    """LONGEST, halved until neither joints move far nor accelerations change much."""
    dt, m = LONGEST, soft.chain.eta_q
    soft.hold(q, v)
    start = soft.explicit(q, v)
    while dt > SHORTEST:
        with contextlib.suppress(SingularError):
            there = soft.step(METHODS["semi_implicit"], q, v, dt)
            change = np.abs(soft.explicit(*there) - start).max(initial=0.0)
            far = np.abs(there[0] - q)[:m].max(initial=0.0)
            if change <= SHARE * np.abs(start).max(initial=0.0) and far <= SHARE:
                break
        dt /= 2
    return dt


def _sums(dae: DaeDynamics, x: np.ndarray) -> list[float]:
    """The sums of the parts of a state of the DAE form."""
    pose = x[dae.pose].reshape(-1, 7)
    parts = [pose[:, :4], pose[:, 4:], x[dae.eta], x[dae.twist], x[dae.etadot], x[dae.q]]
    parts += [x[dae.z]] * (dae.chain.n_internal > 0)
    return [weighted_sum(part.ravel()) for part in parts]


def weighted_sum(x: Iterable) -> float:
    """The sum of all entries with weights from 1 to 2, which differ for any 97 entries in a row."""
    return float(sum((1 + 7 * k % 97 / 97) * float(value) for k, value in enumerate(x)))


def _rounded(op: str, x: float, *more: float) -> float:
    """A function of numbers, rounded once; NaN where it has no value, or is that of a section beyond a full turn."""
    if op == "neg":
        return -x
    if not all(map(math.isfinite, (x, *more))):
        return math.nan
    if (op == "sqrt" and x < 0) or (op[0] == "c" and op != "cos" and not abs(x) < FULL_TURN**2):
        return math.nan
    return float(fused.precise(op, *map(mpmath.mpf, (x, *more))))
