"""Random robots with everything at once, held against the oracle: `python tests/mixed_arms.py 0 300`.

Trees of up to eight links that are carried at tips or along their parents, mixed joints, stops, cylinders, four-bar
linkages, rigid and elastic drives with friction, modes of all orders, sections that vary, shear, bodies from files,
segments, damping of the material, fixed and floating bases, couplings, up to two loops. What the robot file refuses is
counted and drawn without. Where loops or couplings close the tree, the judge is the oracle's mass matrix and bias with
Lagrange multipliers.
"""

from __future__ import annotations

import copy
import sys
import time
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import flexible_robots as fr
import numpy as np
import random_robots as rr
from helpers import EPS, casadi_forward, model_of, quick
from mixed_loops import Loops, bridged
from oracle import Oracle, part_error
from oracle_floating import ANGLE, coordinates, floating, twin
from pydantic import ValidationError
from test_couplings import coupled, names
from test_loops import JOINTS

from screwgen import Model
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
LAYOUTS = ("auto", "modular")
STATE = ("q", "v", "tau", "w_ext")
Results = tuple[np.ndarray, ...]


class Mixed(NamedTuple):
    """A robot in a state: `given` as the package takes them, `state` and `oracle` of the robot without segments whose
    base, if it floats, has six axes. `refused`: what the file's draw had besides."""

    robot: dict
    model: Model
    oracle: Oracle
    loops: Loops | None
    state: dict
    given: tuple
    refused: tuple[str, ...]

    @property
    def floating(self) -> bool:
        return "base" in self.robot

    @property
    def tolerance(self) -> float:
        """The larger of 1e-10 and 50 eps cond, of the mass matrix or of the equations with multipliers."""
        q = self.state["q"]
        return self.oracle.tolerance(q) if self.loops is None else max(1e-10, 50 * EPS * self.loops.condition(q))

    def expected(self) -> Results:
        """Rates of v, joint wrenches, and the wrenches of loops on the tips."""
        vdot, loads = self.loops.forward_dynamics(**self.state) if self.loops else (None, 0.0)
        state = self.state | {"w_ext": self.state["w_ext"] + loads}
        vdot = self.oracle.forward_dynamics(**state)[0] if vdot is None else vdot
        wrench = self.oracle.wrenches(state["q"], state["v"], vdot, state["w_ext"])
        if self.floating:
            twist = self.oracle.link_twist_rates(state["q"], state["v"], vdot)[0]
            vdot, wrench = np.append(twist, vdot[6:]), np.vstack([np.zeros(6), wrench[1:]])
        return (vdot, wrench, loads) if self.loops else (vdot, wrench)

    def errors(self, expected: Results, found: Results) -> dict[str, float]:
        """Errors of each part over its largest entry; of one that all but vanishes, over 1e-4 of its kind."""
        ends = np.cumsum([6 * self.floating, self.oracle.n_joint - 6 * self.floating, self.oracle.n_rotor])
        names = ("base", "joints", "rotors", "modes")
        cut = lambda x: dict(zip(names, np.split(np.ravel(x), ends), strict=True))  # noqa: E731
        both = [(cut(expected[0]), cut(found[0]), expected[0])]
        for name, a, b in zip(("", "loop "), expected[1:], found[1:], strict=False):
            halves = [{f"{name}tau": x[:, :3], f"{name}F": x[:, 3:]} for x in (a, np.reshape(b, (-1, 6)))]
            both.append((*halves, a))
        return {k: part_error(a[k], b[k], whole) for a, b, whole in both for k in a}

    def densely(self, expected: np.ndarray) -> Results:
        """The rows of CasADi's DAE form by a dense LU, with what of `expected` is none of their unknowns."""
        q, v, tau, w_ext = self.given
        functions, p, n = self.model.casadi(), self.model.parameter_values, self.model.n_links
        M, H, W = (x.full() for x in functions["assemble"](functions["dae_state"](q, v, p), tau, w_ext.T, p))
        z = np.linalg.solve(M, W - H)[:, 0]
        links = z[: 12 * n].reshape(n, 12)
        vdot = np.append(expected[: self.model.chain.eta_v], z[12 * n :])
        if self.floating:
            vdot[:6] = links[0, 6:]
        return vdot, links[:, :6]

    def judged(self, compiled: str | None = None) -> dict[str, float]:
        """The worst error of every back end and form; `compiled`: a layout of the C."""
        numeric, expected = self.model.numpy(), self.expected()
        found = {
            "NumPy": numeric.forward_dynamics(*self.given),
            "NumPy DAE": numeric.dae_forward_dynamics(*self.given),
            "CasADi": casadi_forward(self.model, *self.given),
            "CasADi DAE": self.densely(expected[0]),
        }
        if self.loops:
            found["NumPy"] += (numeric.loop_wrenches(*self.given),)
        if compiled:
            library = quick(self.model, layout=compiled)
            found |= {f"C {form}": library.forward_dynamics(*self.given, form=form) for form in ("joint", "dae")}
        return {who: max(self.errors(expected, x).values()) for who, x in found.items()}


# ------------------------------------------------------------------------------------------------- drawing


def in_pieces(robot: dict) -> dict:
    """The robot with a link for each segment."""
    links = []
    for link in robot["links"]:
        k = link.get("segments", 1)
        own = {key: value for key, value in link.items() if key != "segments"}
        if k == 1:
            links.append(own)
            continue
        ends = {at: [b for b in link.get("bodies", []) if b["at"] == at] for at in ("base", "tip")}
        for i in range(k):
            piece = {x: copy.deepcopy(own[x]) for x in own if x not in ("bodies", "parent", "at", "joint")}
            piece |= {"length": link["length"] / k, "joint": link["joint"] if i == 0 else {"axes": []}}
            piece |= {x: link[x] for x in ("parent", "at") if i == 0 and x in link}
            piece["bodies"] = ends["base"] * (i == 0) + ends["tip"] * (i == k - 1)
            piece["name"] = link["name"] if i == k - 1 else f"{link['name']}_part{i}"
            links.append(piece)
    return robot | {"links": links}


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


def drawn(seed: int, folder: Path, most: int = LINKS, **limits) -> Mixed:
    """A robot of `most` links or fewer whose equations are regular in its state.

    What the file refuses is left out and kept as `refused`.
    """
    rng, refused = np.random.default_rng([14, seed]), []
    count, wanted = int(rng.integers(1, most + 1)), int(rng.integers(0, 3))
    free, files = bool(rng.random() < 0.35), bool(rng.random() < 0.25)
    limits = LIMITS | {"max_modes": 1 + (count < 4)} | limits
    for attempt in range(200):
        if attempt % 20 == 19:
            wanted = max(wanted - 1, 0)
        tree = max(count - wanted, 1)
        base = fr.random_arm(rng, tree, **limits) if files else rr.random_robot(rng, tree, **limits)
        base = with_places(rng, with_segments(rng, floating(base) if free else base))
        case = _case(rng, base, wanted, folder, refused)
        if case is not None:
            return case
        free = free and not any("floating" in x for x in refused)
    raise RuntimeError("no regular robot in 200 draws")


def _case(rng, base: dict, wanted: int, folder: Path, refused: list[str]) -> Mixed | None:
    free = "base" in base
    pieces = in_pieces(base)
    judged = twin(pieces) if free else pieces
    state = fr.random_state(rng, judged) if any("cloud" in x for x in judged["links"]) else rr.random_state(rng, judged)
    if free:
        state["q"][3:6], state["tau"][:6] = rr.numbers(rng.uniform(-ANGLE, ANGLE, 3)), [0.0] * 6
    for number in range(wanted):
        oracle = Oracle(judged)
        spare = oracle.nv - 6 * free - sum(6 - len(x["joint"]["axes"]) for x in judged.get("loops", []))
        joints = [x for x in JOINTS if 6 - len(x) < spare]
        if joints and oracle.n > 1:
            judged, state = bridged(rng, judged, state, oracle, joints[rng.integers(len(joints))], number)
    base = base | {"links": [*base["links"], *(x for x in judged["links"] if x["name"].startswith("bridge"))]}
    judged = with_coupling(rng, base, judged, state)
    base |= {key: judged[key] for key in ("loops", "couplings") if key in judged}
    oracle = Oracle(judged)
    loops = Loops(oracle, judged) if {"loops", "couplings"} & set(judged) else None
    state = {name: np.array(x, float) for name, x in state.items()}
    M = oracle.mass_matrix(state["q"])
    if np.linalg.cond(M) > CONDITION or np.linalg.eigvalsh(M)[0] <= 0:
        return None
    if loops is not None:
        if loops.condition(state["q"]) > CONDITION:
            return None
        state["v"] = loops.moving(state["q"], state["v"])
    try:
        model = model_of(fr.with_files(base, folder))
    except ValidationError as error:
        refused.append(message(error))
        return None
    given = tuple(state[name] for name in STATE)
    if free:
        q, v = coordinates(oracle, state["q"], state["v"])
        given = q, v, state["tau"][6:], state["w_ext"]
    return Mixed(base, model, oracle, loops, state, given, tuple(refused))


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
        "files": sum(k.elastic is not None for k in keys),
        "loops": len(case.robot.get("loops", [])),
        "couplings": len(case.robot.get("couplings", [])),
        "rows": len(chain.closing.rows),
        "floating": int(case.floating),
        "tree": int(not chain.tree.is_chain),
        "stops": len(chain.acted(STOP)),
        "cylinders": sum(x == CYLINDER for x in chain.travels.values()),
        "linkages": sum(isinstance(x, FourBarLinkage) for x in chain.travels.values()),
        "places": sum(map(len, (k.stations_at for k in keys))),
    }
    return " ".join(f"{k} {n}" for k, n in parts.items() if n)


def main() -> int:
    first, last = int(sys.argv[1]), int(sys.argv[2])
    worst, counts, refused = 0.0, Counter(), Counter()
    for seed in range(first, last):
        start = time.time()
        try:
            with TemporaryDirectory() as folder:
                case = drawn(seed, Path(folder))
            layout = LAYOUTS[seed // EVERY % 2] if seed % EVERY == 0 else None
            found = case.judged(layout)
            refused.update(set(case.refused))
            share = max(found.values()) / case.tolerance
            worst, said = max(worst, share), "holds" if share <= 1 else "FAILS"
            text = f"{described(case)}: {max(found.values()):.1e} of {case.tolerance:.1e}"
            text += f" {found}" if share > 1 else ""
        except Exception as error:  # the sweep goes on; what was raised is a failure
            said, text = "RAISES", f"{type(error).__name__}: {error}"
        counts[said] += 1
        print(f"{seed} {said} {text} ({time.time() - start:.0f} s)", flush=True)
    print(dict(counts), f"largest share of the tolerance {worst:.1e}")
    for why, times in refused.items():
        print(f"refused in {times} draws: {why}")
    return int(set(counts) != {"holds"})


if __name__ == "__main__":
    sys.exit(main())
