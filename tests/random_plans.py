"""Random tasks for plans on five robots, and what becomes of each: `python tests/random_plans.py 0 100` prints all,
`python tests/random_plans.py 0 20 geared` those of an arm with elastic drives.
"""

from __future__ import annotations

import re
import sys
import time
from functools import cache
from typing import NamedTuple

import numpy as np
from helpers import arm, example_dict, link, model_of

import screwgen
from screwgen import UsageError
from screwgen.planning.members import Still
from screwgen.planning.scheduled_shaper import ScheduledShaper

LIMITS = {"efforts": ("efforts",), "rates": ("rates",), "joint ranges": ("lower", "upper")}
"""By what a refusal calls them."""
STEP = 2.5e-4


class Planned(NamedTuple):
    """A robot with a law, and what tasks of it are drawn from."""

    model: screwgen.Model
    kp: tuple[float, ...]
    kd: tuple[float, ...]
    reach: tuple[float, ...]
    """The largest coordinates at ends, of either sign."""
    slow: float
    """s: about the period of its slowest vibration."""
    idle: tuple[int, ...] = ()
    """Joints without a drive, which start and end at zero."""


def ella(order: int | str = 1, modes: int = 2) -> screwgen.Model:
    """The example with rotors, of another order and number of modes per plane."""
    robot = {**example_dict("converged"), "order": order}
    for row, rotors in zip(robot["links"], ([0.2, 0.2], [0.1]), strict=True):
        row["modes"] = {"bending_y": modes, "bending_z": modes, "torsion": 1}
        row["joint"] = {**row["joint"], "armature": rotors}
    return model_of(robot)


@cache
def shaper_of_ella() -> ScheduledShaper:
    """ZV for two modes, joints locked."""
    return screwgen.shape(ella(), [-1.0, -1.0, -2.0], [1.0, 1.0, 2.0], kind="zv", modes=2)


def rod() -> screwgen.Model:
    """One flexible link in a plane, which gravity loads."""
    section = {"rhoA": 0.6, "EIy": 60.0, "EIz": 60.0}
    joint = {"axes": ["z"], "armature": [0.3]}
    bodies = [{"at": "tip", "mass": 1.0}]
    row = {"name": "rod", "length": 1.2, "section": section, "modes": {"bending_y": 2}, "joint": joint}
    return model_of(arm(row | {"bodies": bodies, "order": 2}, gravity=[0.0, -9.81, 0.0]))


def cart() -> screwgen.Model:
    """A cart with a load on a rope that no drive moves."""
    hook = link("cart", axes=[{"slide": "y"}], length=0.1, modes={}, section={"rhoA": 0.1})
    rope = link("rope", axes=["z"], length=1.0, modes={}, section={"rhoA": 0.05}, bodies=[{"at": "tip", "mass": 2.0}])
    return model_of(arm({**hook, "bodies": [{"at": "tip", "mass": 5.0}]}, rope, gravity=[9.81, 0.0, 0.0]))


def two_links() -> screwgen.Model:
    """Two flexible links, drawn at random, whose first joint is a ball of two axes."""
    rng = np.random.default_rng(5)
    rows = []
    for name, axes in (("inner", ["z", "y"]), ("outer", ["y"])):
        section = {"rhoA": float(rng.uniform(0.4, 1.5)), "GJ": 200.0, "rhoIp": 1e-3}
        section |= {key: float(rng.uniform(200.0, 900.0)) for key in ("EIy", "EIz")}
        joint = {"axes": axes, "armature": rng.uniform(0.1, 0.4, len(axes)).tolist()}
        bodies = [{"at": "tip", "mass": float(rng.uniform(0.5, 2.0))}]
        modes = {"bending_y": 1, "bending_z": 1, "torsion": 1}
        rows.append({"name": name, "length": 0.8, "section": section, "modes": modes, "joint": joint, "bodies": bodies})
    return model_of(arm(*rows))


def geared() -> screwgen.Model:
    """Two links whose drives are elastic and have dry friction; the outer one bends."""
    rows, friction = [], {"coulomb": 0.01, "viscous": 1e-4, "velocity": 0.5}
    for name, mass, ratio in (("inner", 1.0, 100.0), ("outer", 1.5, 80.0)):
        drive = {"ratio": ratio, "rotor_inertia": 3e-5, "stiffness": 3000.0, "damping": 2.0, "friction": friction}
        section, bends = {"rhoA": 0.8, "EIy": 300.0, "EIz": 300.0}, {"bending_z": 1} if name == "outer" else {}
        bodies = [{"at": "tip", "mass": mass}]
        rows.append(link(name, 0.6, ["y"], section=section, modes=bends, bodies=bodies, joint={"drives": drive}))
    return model_of(arm(*rows))


@cache
def elastic() -> Planned:
    """The arm with elastic drives: one beside the five."""
    return Planned(geared(), (300.0, 120.0), (40.0, 15.0), (1.2, 1.5), 0.35)


@cache
def robots() -> dict[str, Planned]:
    """The five."""
    return {
        "rod": Planned(rod(), (60.0,), (14.0,), (1.5,), 0.5),
        "cart": Planned(cart(), (300.0, 0.0), (90.0, 0.0), (1.0, 0.0), 1.6, (1,)),
        "two links": Planned(two_links(), (120.0, 120.0, 60.0), (30.0, 30.0, 10.0), (1.0, 1.0, 1.2), 0.3),
        "gantry": Planned(
            model_of(example_dict("gantry")),
            (9e3, 4e3, 4e3, 60.0),
            (2.5e3, 1e3, 900.0, 25.0),
            (1.5, 1.0, 0.5, 1.2),
            0.6,
        ),
        "ella": Planned(ella(), (300.0, 300.0, 120.0), (60.0, 60.0, 20.0), (0.9, 0.9, 0.9), 0.35),
    }


def planned_of(name: str) -> Planned:
    """A robot by its name."""
    return elastic() if name == "geared" else robots()[name]


class Asked(NamedTuple):
    """A task as `screwgen.plan` takes it."""

    robot: str
    start: np.ndarray
    goal: np.ndarray
    time: float
    limits: dict[str, np.ndarray]

    def relaxed(self, names: tuple[str, ...]) -> Asked:
        """The same with limits left out; where no drive moves a joint its effort stays 0."""
        kept = {key: x for key, x in self.limits.items() if key not in names}
        if "efforts" in names:
            idle = np.zeros(len(self.start), bool)
            idle[list(planned_of(self.robot).idle)] = True
            kept["efforts"] = np.where(idle, 0.0, np.inf)
        return self._replace(limits=kept)

    def plan(self) -> screwgen.MotionPlan:
        planned = planned_of(self.robot)
        law = screwgen.PD(planned.kp, planned.kd, tuple(0.0 for _ in planned.kp))
        limits = {key: x for key, x in self.limits.items() if np.isfinite(x).any()}
        return screwgen.plan(planned.model, self.start, self.goal, self.time, gains=law, limits=limits)


def drawn(seed: int, name: str = "") -> Asked:
    """A task, of the robot that is named or of one of the five: some of them their limits forbid."""
    rng = np.random.default_rng([seed, 44])
    name = name or list(robots())[seed % len(robots())]
    planned = planned_of(name)
    reach, idle = np.array(planned.reach), list(planned.idle)
    start, goal = (rng.uniform(-1.0, 1.0, len(reach)) * reach for _ in range(2))
    period = planned.slow * float(np.exp(rng.uniform(np.log(1.5), np.log(5.0))))
    limits = {}
    still = Still(planned.model, np.array(planned.model.parameter_values))
    held = [still.held(q) for q in (start, goal)]
    inertia = np.abs(np.diag(still.rigid_inertia(held[0].q)))
    way = np.abs(goal - start)
    if rng.random() < 0.7:
        rigid = np.max([np.abs(x.effort) for x in held], axis=0) + 6.0 * inertia * way / period**2
        limits["efforts"] = rigid * rng.uniform(0.8, 3.0) + 1e-3
    if rng.random() < 0.5:
        limits["rates"] = way / period * rng.uniform(0.9, 3.0) + 1e-3
    if rng.random() < 0.5:
        low, high, spare = np.minimum(start, goal), np.maximum(start, goal), 0.2 * reach * rng.uniform(-0.05, 1.0)
        limits |= {"lower": low - spare, "upper": high + spare}
    for j in idle:
        limits.setdefault("efforts", np.full(len(reach), np.inf))[j] = 0.0
        for key, x in (("rates", np.inf), ("lower", -np.inf), ("upper", np.inf)):
            if key in limits:
                limits[key][j] = x
    return Asked(name, start, goal, period, limits)


class Outcome(NamedTuple):
    """What became of a task: `found` with its figures, `refused` and by what, or `failed` and why."""

    kind: str
    words: str
    iterations: int
    seconds: float


def outcome(asked: Asked) -> Outcome:
    """A plan is played, a refusal is tried without the limit that it names."""
    began = time.perf_counter()
    try:
        plan = asked.plan()
    except UsageError as error:
        took, said = time.perf_counter() - began, str(error)
        names = named(said)
        if not names:
            return Outcome("failed", said, 0, took)
        try:
            asked.relaxed(names).plan()
        except UsageError as again:
            if named(str(again)) and not set(named(str(again))) & set(names):
                return Outcome("refused", f"{said} | {again}", 0, took)
            return Outcome("failed", f"{said} | {again}", 0, took)
        return Outcome("refused", said, 0, took)
    wrong, words = faults(asked, plan)
    return Outcome("failed" if wrong else "found", f"{words} {wrong}", plan.said["iterations"], plan.said["seconds"])


def named(said: str) -> tuple[str, ...]:
    """The limits that a refusal names."""
    if found := re.search(r"the limits of (.*?)(?: forbid it|: )", said):
        return tuple(key for name in found[1].split(" and ") for key in LIMITS[name])
    for words, keys in (("its limits are", ("lower", "upper")), ("to rest there takes", ("efforts",))):
        if words in said:
            return keys
    return ("rates",) if "with a rate of" in said else ()


def faults(asked: Asked, plan: screwgen.MotionPlan) -> tuple[str, str]:
    """What a plan does that was not asked for, played on its own model; and its figures."""
    arrived = screwgen.play(planned_of(asked.robot).model, plan, step=STEP)
    tip = arrived.run.tip_position
    share = arrived.residual / float(np.linalg.norm(np.ptp(tip, axis=0)))
    fine = plan.reference(np.linspace(0.0, plan.time, 2000))
    broken = [f"residual {share:.1e}"] if share > 1e-3 else []
    broken += [f"{arrived.saturated} saturated"] if arrived.saturated else []
    way = np.ptp(fine[0], axis=0)
    way[way == 0.0] = 1.0
    for name, values, size in (("rates", np.abs(fine[1]), None), ("upper", fine[0], way), ("lower", -fine[0], way)):
        if name in asked.limits:
            bound = -asked.limits[name] if name == "lower" else asked.limits[name]
            excess = ((values - bound) / (bound if size is None else size)).max(initial=-1.0, where=np.isfinite(bound))
            broken += [f"{name} exceeded by {excess:.1e} of their size"] if excess > 1e-3 else []
    return ", ".join(broken), f"{share:.1e} of the way, {plan.time:.2f} s, {arrived.line}"


if __name__ == "__main__":
    counts: dict[str, int] = {}
    for seed in range(*map(int, sys.argv[1:3])):
        asked = drawn(seed, *sys.argv[3:4])
        result = outcome(asked)
        counts[result.kind] = counts.get(result.kind, 0) + 1
        figures = f"{result.iterations:3d} it {result.seconds:5.1f} s"
        print(f"{seed:3d} {asked.robot:9s} {result.kind:7s} {figures}  {result.words}", flush=True)
    print(counts)
