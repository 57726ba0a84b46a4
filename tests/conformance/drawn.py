"""The state of a robot of the matrix, at random."""

from __future__ import annotations

import copy

import flexible_robots as fr
import numpy as np
import random_robots as rr
from mixed_loops import bridge_of
from oracle import Oracle
from oracle_floating import ANGLE

from conformance.arms import EFFORT, LOOPS
from conformance.features import Row
from conformance.judge import Judge
from conformance.twin import as_turns, axes_of, first_piece


def drawn(row: Row, robot: dict, seed: int = 0) -> Judge:
    """The robot of a row in a random state that is regular; a bridge that is as long as is needed closes a loop.

    What is derived of the robot without that bridge is derived once for all draws.
    """
    oracle, before = Oracle(as_turns(robot)), None
    for attempt in range(200):
        rng = np.random.default_rng([seed, attempt])
        found = _drawn(rng, row, copy.deepcopy(robot), oracle, before)
        if found.regular:
            return found
        before = None if row["closing"] in LOOPS else found
    raise RuntimeError(f"no regular state of {dict(row)} in 200 draws")


def _drawn(rng, row: Row, robot: dict, oracle: Oracle, before: Judge | None) -> Judge:
    """``before``: a judge of the same robot in another state, whose functions are this one's too."""
    twin = oracle.robot
    draw = fr.random_state if any("cloud" in x for x in twin["links"]) else rr.random_state
    state = {name: np.array(x, float) for name, x in draw(rng, twin).items()}
    if row["order"] == "second order":  # whose mass matrix is definite only where links bend little
        for name in ("q", "v"):
            state[name][oracle.n_joint + oracle.n_rotor :] *= 0.3
    _mild(rng, row, robot, oracle, state)
    if row["closing"] in LOOPS:
        _close(rng, row, robot, oracle, state)
        twin = as_turns(robot)
        oracle = Oracle(twin)
    judge = Judge(robot, twin, oracle, state, before and before.rows)
    if before:
        judge.acting, judge.outer.acting = before.acting, before.outer.acting
    judge.tensions = rng.uniform(5.0, 30.0, len(judge.tendon_lengths))
    judge.closed = rng.uniform(0.2, 0.7, len(judge.brakes))
    judge.pushes = 4.0 * rng.normal(size=judge.pushes.shape)
    judge.outer.winches = rng.uniform(-0.3, 0.3, judge.outer.winches.shape)
    judge.outer.relaxed = rng.uniform(-0.2, 0.2, len(judge.outer.relaxed))
    judge.bristles.z = rng.uniform(-0.04, 0.04, len(judge.bristles.z))
    judge.limits.z = rng.uniform(-4.0, 4.0, len(judge.limits.z))
    return judge


def _mild(rng, row: Row, robot: dict, oracle: Oracle, state: dict) -> None:
    """Postures that transmissions reach, couplings keep and Euler angles have."""
    q, tau, names = state["q"], state["tau"], [x["name"] for x in oracle.robot["links"]]
    floating = "base" in robot
    if floating:
        q[3:6] = rng.uniform(-ANGLE, ANGLE, 3)
        tau[:6] *= row["base"] == "moving"
    for i, link in enumerate(robot["links"]):
        own = oracle.joint_slices[names.index(first_piece(link))]
        if i == 0 and floating:
            continue
        if link["joint"]["axes"] == "ball":
            q[own] = rng.uniform(-ANGLE, ANGLE, 3)
        elif row["turn"] == "slide" and link["name"] == "boom":
            q[own] = rng.uniform(-0.3, 0.3, 1)
        elif link["name"] in ("fore", "mast"):
            before = q[own].copy()
            q[own] = rng.uniform(0.25, 0.5, 1) * rng.choice([-1, 1])
            _geared(oracle, state, own, before)
            if row["axis"] in ("limited", "limited rate"):
                tau[own] = rng.choice([-1, 1]) * rng.uniform(1.5, 3.0, 1) * EFFORT
    if row["closing"] == "coupling":
        coupling, places = robot["couplings"][0], axes_of(oracle.robot)
        q[places[coupling["axis"]]] = coupling["ratio"] * q[places[coupling["of"]]] + coupling["offset"]


def _geared(oracle: Oracle, state: dict, own: slice, before: np.ndarray) -> None:
    """Let the rotor of an elastic gear follow its axis."""
    for place, axis in enumerate(oracle.drives.rotors):
        drive = [d for link in oracle.links for d in link.drives][axis]
        if axis == own.start and "transmission" not in drive:
            state["q"][oracle.n_joint + place] += drive.get("ratio", 1.0) * (state["q"][own] - before)[0]


def _close(rng, row: Row, robot: dict, oracle: Oracle, state: dict) -> None:
    names = [x["name"] for x in oracle.robot["links"]]
    bridge, loop = bridge_of(oracle, state, names.index("fore"), names.index("post"), LOOPS[row["closing"]])
    bridge["section"]["rhoIp"] = 1e-3
    robot["links"].append(bridge)
    robot["loops"] = [loop]
    state["w_ext"] = np.vstack([state["w_ext"], rng.normal(size=6)])
