"""Controllers: functions `(t, q, v) -> tau`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import Numbers
from ..backends.numpy.travel_numbers import ahead_of_joints, efforts
from ..errors import SingularError, UsageError
from ..robot_model import RobotModel
from ..spec.ranges import within
from .mobility import closing, stated_joints
from .state import refusals, sized

if TYPE_CHECKING:
    from ..topology.chain import Chain

Controller = Callable[[float, np.ndarray, np.ndarray], Numbers]

UNITS = {
    "kp": "N·m/rad (slides: N/m)",
    "kd": "N·m·s/rad (slides: N·s/m)",
    "q_des": "rad (slides: m)",
    "tau_max": "N·m (slides: N)",
}
SUMMED = {"ki": "N·m/(rad·s) (slides: N/(m·s))"}


class Holding:
    """The torques that hold an arm at rest at given joint angles: against gravity, and against joint springs.

    They are computed for the model's nominal parameters, with the modes at equilibrium. The only sensors that they need
    are encoders. Where there are loops they are those of the joints that :func:`.mobility.stated_joints` names
    in the first posture; the others follow without torque.
    """

    TOLERANCE, SETTLED, STEPS = 1e-12, 1e-9, 30

    def __init__(self, model: RobotModel, parameters: Numbers | None = None):
        model.chain.refuse_quaternion_joints("torque that holds it against gravity", "leave out gravity compensation")
        model.chain.refuse_floating_base("torque that holds it against gravity", "leave out gravity compensation")
        self.model, self.statics, self.count, self.chain = model, model.statics, model.n_joints, model.chain
        self.p = np.array(model.parameter_values if parameters is None else parameters, float)
        self.still = np.zeros((6, model.n_links))
        self.stated: np.ndarray | None = None

    def __call__(self, q: Numbers) -> np.ndarray:
        """The torques (n_tau,), N·m, where they act, at the joint angles `q` (n_joints,), rad."""
        m, rows = self.count, len(self.chain.closing.rows)
        x, forces = self.chain.with_inner(np.asarray(q, float)[:m], self.p), np.zeros(rows)
        if self.stated is None:
            self.stated = stated_joints(self.model, x, self.p)
        i = np.append(np.flatnonzero(~self.stated), np.arange(m, len(x)))
        for _ in range(self.STEPS):
            _, force, K, *_ = map(np.array, self.statics(x, self.still, self.p))
            gap, J, _, bend, _ = map(np.array, closing(self.model)(x, np.zeros(len(x)), forces, self.p))
            force, K, gap = force[:, 0] - J.T @ forces, K - bend, gap[:, 0]
            A = np.block([[K[np.ix_(i, i)], -J[:, i].T], [J[:, i], np.zeros((rows, rows))]])
            step = self._solved(A, -np.append(force[i], gap))
            moved, changed = np.split(step, [len(i)])
            x[i] += moved
            forces += changed
            settled = np.abs(moved).max(initial=0.0) <= self.TOLERANCE * np.abs(x[i]).max(initial=0.0)
            if settled and np.abs(changed).max(initial=0.0) <= self.SETTLED * np.abs(forces).max(initial=0.0):
                break
        torques = self.chain.at_efforts(np.where(self.stated, force[:m], 0.0), self.p)
        return self.chain.with_idle_inputs(efforts(self.chain, torques, x[:m], self.p))

    def _solved(self, A: np.ndarray, b: np.ndarray) -> np.ndarray:
        if self.chain.closing.overconstrained:  # rows share what they bear, so their forces are not unique
            return np.linalg.lstsq(A, b, rcond=1e-8)[0]
        try:
            return np.linalg.solve(A, b)
        except np.linalg.LinAlgError:
            raise SingularError("gravity compensation: the loops are singular in this posture; leave it out") from None


@dataclass(frozen=True)
class PD:
    """A proportional-derivative law about a reference, one entry per joint coordinate.

    `tau = kp (q_ref − q) + kd (v_ref − v) + gravity(q)`, limited to `±tau_max` where that is given. `kp` in N·m/rad,
    `kd` in N·m·s/rad, `q_des` in rad; of a slide N/m, N·s/m and m. With `duration` (s) the reference travels from
    `q_start` to `q_des` along a minimum-jerk path; without, it is `q_des` at rest. A run fills `q_start` in through
    `starting_at`.

    `waypoints`: pairs of a time (s), ascending, and joint angles (rad), which the reference reaches at rest one after
    the other on such paths; `q_des` is the last and `duration` its time. `gravity`: a function from the measured joint
    angles (n_joints,) to the torques that hold the arm there, such as `Holding(model)`; without, nothing is added.

    Gains, limits and angles are those of the joints. Where these stand in the `q` and `v` of a robot a run says by
    `through`: behind a floating base; of an elastic drive the law measures the rotor's angle over the ratio in place of
    the joint's, and its torque acts on the rotor, less by the ratio. A cylinder is given the force that exerts the
    torque; its limit in `tau_max` is that of the force, N. So is a crank the torque at its pivot, N·m. Behind an
    elastic gear the law measures the joint where a rigid one would have it.
    Other inputs stay zero, so tendons slack: `through` counts them.
    Raises UsageError where gains are negative, limits or the duration not positive, or the lengths differ.
    """

    kp: tuple[float, ...]
    kd: tuple[float, ...]
    q_des: tuple[float, ...]
    duration: float | None = None
    tau_max: tuple[float, ...] | None = None
    q_start: tuple[float, ...] | None = None
    waypoints: tuple[tuple[float, tuple[float, ...]], ...] = ()
    gravity: Callable[[np.ndarray], np.ndarray] | None = None
    driven: tuple[int, ...] | None = None
    ahead: int = 0
    ratios: tuple[float, ...] | None = None
    efforts: Callable[[np.ndarray, np.ndarray], np.ndarray] | None = None
    ahead_of_joints: Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]] | None = None
    idle: int = 0

    def __post_init__(self) -> None:
        for name in ("kd", "kp", "tau_max", "q_start"):
            value = getattr(self, name)
            if value is not None and np.size(value) != np.size(self.q_des):
                raise UsageError(
                    f"PD: {name} has length {np.size(value)}; q_des has {np.size(self.q_des)}, one per joint"
                )
        with refusals("PD"):
            for name in (*UNITS, "q_start"):
                value = getattr(self, name)
                if value is not None:
                    object.__setattr__(self, name, joint_numbers(name, value, np.size(self.q_des), (name,)))
            if self.duration is not None:
                object.__setattr__(self, "duration", within("duration")(self.duration, at=("duration",)))
        if self.waypoints and (self.duration, self.q_des) != self.waypoints[-1]:
            raise UsageError("PD: the last of the waypoints is not (duration, q_des); make it so")

    def starting_at(self, q: Numbers) -> PD:
        """The same law for a run that starts at `q` (nq,)."""
        q = np.asarray(q, float)
        return replace(self, q_start=tuple(self.seen(q, np.zeros(len(q)))[0].tolist()))

    def through(self, chain: Chain, p: Numbers) -> PD:
        """The same law for a robot's coordinates and through its elastic drives, at its parameters `p`.

        Raises UsageError where the law has another number of joints than the robot.
        """
        chain.refuse_quaternion_joints("PD law of its joints", "give a function of t, q and v")
        if len(self.q_des) != chain.n_joints:
            what = f"q_des has length {len(self.q_des)}; the robot has {chain.n_joints} joint coordinates"
            raise UsageError(f"PD: {what}")
        ratios, ahead = 1.0 / chain.at_efforts(np.ones(chain.n_joints), p), chain.base_q - chain.base_v
        through = partial(_efforts, chain, p) if chain.travels else None
        driven = tuple(chain.effort_places)
        ahead_of = partial(ahead_of_joints, chain, p=p) if chain.elastic_travels else None
        return replace(
            self,
            driven=driven,
            ahead=ahead,
            ratios=tuple(ratios.tolist()),
            efforts=through,
            ahead_of_joints=ahead_of,
            idle=chain.n_tau - chain.n_joints,
        )

    def seen(self, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The coordinates and rates of joints, (n_joints,) each, that the law measures in `q` (nq,) and `v` (nv,)."""
        there, rates = self.measured(q, self.ahead), self.measured(v)
        if self.ahead_of_joints is None:
            return there, rates
        further, faster = self.ahead_of_joints(q, v)
        return there + further, rates + faster

    @property
    def own_ratios(self) -> np.ndarray:
        """The ratios of elastic drives (n_joints,), 1 for the others."""
        return np.ones(len(self.q_des)) if self.ratios is None else np.array(self.ratios)

    def measured(self, x: np.ndarray, ahead: int = 0) -> np.ndarray:
        """The joints' part of `v` as the drives see it, or that of `q`, whose entries are so many places further on."""
        return x[: len(self.q_des)] if self.driven is None else x[np.array(self.driven, int) + ahead] / self.own_ratios

    @property
    def bounds(self) -> np.ndarray | None:
        """The limits of the torques where they act; None without limits."""
        return None if self.tau_max is None else np.array(self.tau_max) / self.own_ratios

    def scaled(self, name: str, power: int) -> np.ndarray | None:
        """Gains, angles or limits in terms of what the torques act on: times a power of the ratios."""
        value = getattr(self, name)
        return None if value is None else np.array(value, float) * self.own_ratios**power

    @property
    def plain(self) -> bool:
        """Whether the law has gains, one goal and limits only, and no drive has a transmission."""
        return not self.waypoints and self.gravity is None and self.efforts is None

    @property
    def proportional(self) -> bool:
        """Whether joints are fed back by its gains; not if the law has a model of its own for that."""
        return True

    @property
    def set_points(self) -> tuple[tuple[float, tuple[float, ...]], ...]:
        """Times (s), ascending, and angles (rad) at which the reference is at rest, from its start to its goal."""
        if self.duration is None or self.q_start is None:
            return ((0.0, self.q_des),)
        return ((0.0, self.q_start), *(self.waypoints or ((self.duration, self.q_des),)))

    def reference(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Joint coordinates (rad, of slides m) and rates that the law follows at the time `t` (s)."""
        points = self.set_points
        k = next((k for k in range(1, len(points)) if t < points[k][0]), None)
        if k is None:
            return np.array(points[-1][1], float), np.zeros(len(self.q_des))
        (begin, start), (end, goal) = ((x, np.array(q, float)) for x, q in points[k - 1 : k + 1])
        s = max((t - begin) / (end - begin), 0.0)
        place, rate = s**3 * (10 - 15 * s + 6 * s**2), 30 * (s * (1 - s)) ** 2 / (end - begin)
        return start + place * (goal - start), rate * (goal - start)

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The torques, N·m, of slides forces, N, where they act."""
        tau, most = self.unlimited(t, q, v), self.bounds
        if most is not None:
            tau[: len(most)] = np.clip(tau[: len(most)], -most, most)
        return tau

    def unlimited(self, t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        """The torques that the law would give if drives had no limits."""
        q_ref, v_ref = self.reference(t)
        there, rate = self.seen(q, v)
        tau = (np.array(self.kp) * (q_ref - there) + np.array(self.kd) * (v_ref - rate)) / self.own_ratios
        if self.efforts is not None:
            tau = self.efforts(tau, there)
        tau = np.append(tau, np.zeros(self.idle))
        return tau if self.gravity is None else tau + self.gravity(there)


def _efforts(chain: Chain, p: Numbers, torques: np.ndarray, q: np.ndarray) -> np.ndarray:
    return efforts(chain, torques, q, p)


def joint_numbers(key: str, value: Any, n: int, at: tuple) -> tuple[float, ...]:
    """One number for each joint, of the unit and the range of a key."""
    check = within("q" if key.startswith("q_") else key)
    return tuple(sized(value, at, n, f"numbers, one per joint, {(UNITS | SUMMED).get(key, UNITS['q_des'])}", check))
