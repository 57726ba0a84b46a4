"""Random robots with everything at once, held against the oracle: `python tests/mixed_arms.py 0 300 [--dress]`.

Trees of up to eight links that are carried at tips or along their parents, mixed joints, stops, cylinders, four-bar
linkages, rigid and elastic drives with friction, modes of all orders, sections that vary, shear, bodies from files,
segments, damping of the material, fixed and floating bases, couplings, up to two loops, springs and ropes between
frames, pushes; those that are dressed have ball joints, springs, tendons and markers besides. With `--by-p` it is
derivatives by a parameter of each that are judged, by differences in 50 digits. What the robot file refuses is counted
and drawn without. Where loops or couplings close the tree, the judge is the oracle's mass matrix and bias with Lagrange
multipliers.
"""

from __future__ import annotations

import copy
import sys
import time
from collections import Counter
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory

import flexible_robots as fr
import numpy as np
import random_robots as rr
from conformance import numbers, slopes
from conformance.cases import Case
from conformance.judge import Judge
from conformance.twin import as_turns, first_piece
from mixed_forces import with_forces
from mixed_loops import JOINTS, Loops, bridged, coupled, names
from oracle import Oracle
from oracle_floating import ANGLE, floating
from pydantic import ValidationError
from random_features import dressed, with_balls

from screwgen.elements import CYLINDER, STOP, FourBarLinkage

LIMITS = {
    "branching": 0.4,
    "sliding": 0.25,
    "drives": 0.4,
    "cylinders": 0.15,
    "linkages": 0.5,
    "stops": 0.25,
    "second_order": 0.25,
    "exact": 0.3,
    "curved": 0.4,
    "time": 0.3,
    "stations": 0.15,
    "shear": 0.2,
    "max_axes": 2,
}
COUPLED = 0.3
"""Of the robots, where two axes are free."""
LINKS = 8
CONDITION = 1e8
EVERY = 8
"""One robot in so many is compiled."""
STEPS, LEAP = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7), 3.0
"""Steps, s, and how much more than at their beginning rates may change in one."""
LAYOUTS = ("auto", "modular")
STATE = ("q", "v", "tau", "w_ext")


class Mixed(Case):
    """A random robot in a state, as a case for the checks of the matrix. `refused`: what its draw had besides."""

    def __init__(self, judge: Judge, folder: Path, refused: tuple[str, ...] = ()):
        super().__init__({})
        self.judge, self.folder, self.refused = judge, folder, refused

    @property
    def oracle(self) -> Oracle:
        return self.judge.oracle

    @property
    def loops(self) -> Loops | None:
        return self.judge.rows

    @property
    def floating(self) -> bool:
        return "base" in self.judge.robot

    @cached_property
    def step(self) -> float:
        """A millisecond, or the longest of its tenths in which Runge–Kutta's method does not begin to diverge."""
        q, v, tau, w_ext = self.given
        step, most = self.model.casadi()["step_rk4"], LEAP * np.max(np.abs(self.judge.vdot), initial=0.0)
        at = lambda h: step(q, v, tau, w_ext.T, self.model.parameter_values, h)[1].full()[:, 0]  # noqa: E731
        return next(h for h in STEPS if np.max(np.abs(at(h) - v), initial=0.0) <= max(h * most, 1.0))


def case_of(robot: dict, state: dict, folder: Path = Path()) -> Mixed:
    """A robot on a fixed base, in a state, for the checks of the matrix."""
    twin = as_turns(robot)
    return Mixed(Judge(robot, twin, Oracle(twin), state), folder)


# ------------------------------------------------------------------------------------------------- drawing


def with_segments(rng, robot: dict) -> dict:
    """The robot with some of its uniform flexible links in pieces."""
    robot = copy.deepcopy(robot)
    for link in robot["links"]:
        whole = "cloud" in link or "'at'" in str(link["section"]) or "frame_at" in link
        if not whole and any(isinstance(n, int) and n for n in link.get("modes", {}).values()) and rng.random() < 0.15:
            link["segments"] = 2
    return robot


def with_places(rng, robot: dict) -> dict:
    """The robot with some links carried at a place along their parent, or at its base."""
    names = [link["name"] for link in robot["links"]]
    for i, link in enumerate(robot["links"][1:], 1):
        parent = robot["links"][names.index(link.get("parent", names[i - 1]))] if link.get("parent") != "world" else {}
        if "length" in parent and not {"cloud", "segments"} & set(parent) and rng.random() < 0.2:
            link["at"] = "base" if rng.random() < 0.3 else {"s": float(rng.uniform(0.1, 0.9))}
    return robot


def with_coupling(rng, base: dict, judged: dict, state: dict) -> dict:
    """The judged robot, perhaps with a coupling of two axes of links in one piece, which are named alike in `base`."""
    whole = {link["name"] for link in base["links"] if "segments" not in link}
    free = [name for name in names(base) if name.partition(".")[0] in whole]
    return coupled(rng, judged, state, among=free) if len(free) > 1 and rng.random() < COUPLED else judged


def drawn(seed: int, folder: Path, most: int = LINKS, dress: bool = False, balls: float = 0.0, **limits) -> Mixed:
    """A robot of `most` links or fewer whose equations are regular in its state; `dress`: it is dressed.

    `balls`: of its joints how many are balls, beside which it has no loops.

    What the file refuses is left out and kept as `refused`.
    """
    rng, refused = np.random.default_rng([14, seed]), []
    count, wanted = int(rng.integers(1, most + 1)), int(rng.integers(0, 3)) * (not balls)
    free, files = bool(rng.random() < 0.35), bool(rng.random() < 0.25)
    limits = LIMITS | {"max_modes": 1 + (count < 4)} | limits
    for attempt in range(200):
        if attempt % 20 == 19:
            wanted = max(wanted - 1, 0)
        tree = max(count - wanted, 1)
        base = fr.random_arm(rng, tree, **limits) if files else rr.random_robot(rng, tree, **limits)
        base = with_places(rng, with_segments(rng, floating(base) if free else base))
        if dress:
            base = dressed([seed, attempt], base)
        if balls:
            base = with_balls(np.random.default_rng([17, seed, attempt]), base, balls)
        case = _case(rng, base, wanted, folder, refused, [40, seed, attempt])
        if case is not None:
            return case
        free = free and not any("floating" in x for x in refused)
    raise RuntimeError("no regular robot in 200 draws")


def _case(rng, base: dict, wanted: int, folder: Path, refused: list[str], forces: list[int]) -> Mixed | None:
    free, judged = "base" in base, as_turns(base)
    state = fr.random_state(rng, judged) if any("cloud" in x for x in judged["links"]) else rr.random_state(rng, judged)
    if free:
        state["q"][3:6], state["tau"][:6] = rr.numbers(rng.uniform(-ANGLE, ANGLE, 3)), [0.0] * 6
    _turn_balls(rng, base, judged, state)
    among = [x["name"] for x in base["links"]]
    for number in range(wanted):
        oracle = Oracle(judged)
        spare = oracle.nv - 6 * free - sum(6 - len(x["joint"]["axes"]) for x in judged.get("loops", []))
        joints, name = [x for x in JOINTS if 6 - len(x) < spare], f"bridge{number}"
        if joints and oracle.n > 1:
            joint = joints[rng.integers(len(joints))]
            judged, state = bridged(rng, joint, judged, state, oracle, name=name, among=[*among, "bridge0"])
    base = base | {"links": [*base["links"], *(x for x in judged["links"] if x["name"].startswith("bridge"))]}
    judged = with_coupling(rng, base, judged, state)
    base |= {key: judged[key] for key in ("loops", "couplings") if key in judged}
    base = with_forces(forces, base, judged, np.array(state["q"]))
    judge = Judge(base, judged, Oracle(judged), state)
    judge.tensions = rng.uniform(5.0, 30.0, len(judge.tendon_lengths)) if judge.tendon_lengths else judge.tensions
    judge.pushes = np.random.default_rng(forces).normal(size=judge.pushes.shape)
    M = judge.oracle.mass_matrix(judge.state["q"])
    if np.linalg.cond(M) > CONDITION or np.linalg.eigvalsh(M)[0] <= 0:
        return None
    if judge.rows is not None and judge.rows.condition(judge.state["q"]) > CONDITION:
        return None
    case = Mixed(judge, folder, tuple(refused))
    try:
        case.model  # noqa: B018
    except ValidationError as error:
        refused.append(message(error))
        return None
    return case


def _turn_balls(rng, robot: dict, judged: dict, state: dict) -> None:
    """Euler angles of ball joints that stay away from the singular ones."""
    balls, first = {first_piece(x) for x in robot["links"] if x["joint"]["axes"] == "ball"}, 0
    for link in judged["links"]:
        count = len(link["joint"]["axes"])
        if link["name"] in balls:
            state["q"][first : first + count] = rr.numbers(rng.uniform(-ANGLE, ANGLE, count))
        first += count


def message(error: ValidationError) -> str:
    """Where the first fault is, without numbers, and what it is."""
    first = error.errors()[0]
    where = ".".join(str(x) for x in first["loc"] if not isinstance(x, int))
    return f"{where} {first['msg']}"


# ---------------------------------------------------------------------------------------------- the sweep


def described(case: Mixed) -> str:
    keys, chain = case.model.chain.keys, case.model.chain
    parts = {
        "links": len(case.robot["links"]),
        "nv": chain.nv,
        "gears": case.oracle.n_rotor,
        "order 2": sum(k.order == 2 for k in keys),
        "exact": sum(k.order == "exact" for k in keys),
        "curved": sum(bool(k.rest) for k in keys),
        "files": sum(k.elastic is not None for k in keys),
        "loops": len(case.robot.get("loops", [])),
        "couplings": len(case.robot.get("couplings", [])),
        "forces": len(case.robot.get("forces", [])),
        "pushes": len(case.robot.get("pushes", [])),
        "rows": len(chain.closing.rows),
        "floating": int(case.floating),
        "tree": int(not chain.tree.is_chain),
        "stops": len(chain.acted(STOP)),
        "cylinders": sum(x == CYLINDER for x in chain.travels.values()),
        "linkages": sum(isinstance(x, FourBarLinkage) for x in chain.travels.values()),
        "balls": sum(x["joint"]["axes"] == "ball" for x in case.robot["links"]),
        "springs": sum("spring" in x for y in case.robot["links"] for x in y["joint"].get("elements", [])),
        "tendons": chain.n_tensions,
        "markers": sum(len(x.get("markers", [])) for x in case.robot["links"]),
        "places": sum(map(len, (k.stations_at for k in keys))),
    }
    return " ".join(f"{k} {n}" for k, n in parts.items() if n)


def layout_of(seed: int) -> str | None:
    """The layout of the C of a seed, which most have not."""
    return LAYOUTS[seed // EVERY % 2] if seed % EVERY == 0 else None


def judged(case: Mixed, layout: str | None = None) -> None:
    """Every back end and form; `layout`: of the C, which is left out without one."""
    for check in (numbers.judge, numbers.numpy_dae, numbers.casadi):
        check(case)
    if layout:
        numbers.c_functions(case, layout)


def main() -> int:
    first, last, dress = int(sys.argv[1]), int(sys.argv[2]), "--dress" in sys.argv
    counts, refused = Counter(), Counter()
    for seed in range(first, last):
        start, text = time.time(), ""
        try:
            with TemporaryDirectory() as folder:
                case = drawn(seed, Path(folder), dress=dress)
            refused.update(set(case.refused))
            said, text = "holds", described(case)
            judged(case, layout_of(seed)) if "--by-p" not in sys.argv else slopes.by_parameters(case)
        except AssertionError as error:
            said, text = "FAILS", f"{text}: {error}"
        except Exception as error:  # the sweep goes on; what was raised is a failure
            said, text = "RAISES", f"{type(error).__name__}: {error}"
        counts[said] += 1
        print(f"{seed} {said} {text} ({time.time() - start:.0f} s)", flush=True)
    print(dict(counts))
    for why, times in refused.items():
        print(f"refused in {times} draws: {why}")
    return int(set(counts) != {"holds"})


if __name__ == "__main__":
    sys.exit(main())
