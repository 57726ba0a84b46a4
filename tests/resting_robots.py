"""Random robots brought to rest by `equilibrium`, and judged by their energy: `python tests/resting_robots.py 0 500`.

With `balls` behind these numbers they have ball joints. The robots are those of :mod:`mixed_arms` on fixed bases,
small, with rods of all orders, and besides with tendons. A third has its joints held, a quarter wrenches that turn
with the tips, the others dead loads alone. The judge is the oracle's potential energy and that of forces between
frames, less the work of torques and tensions: at the posture found its gradient vanishes along what may move, its
Hessian there has the signs of the verdict, and no lower minimum is beside it.
"""

from __future__ import annotations

import sys
import time
import warnings
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import casadi as ca
import numpy as np
import scipy.linalg
from helpers import model_of
from mixed_arms import LIMITS, Mixed, described, drawn
from pydantic import ValidationError
from random_features import with_tendons
from scipy.spatial.transform import Rotation

from screwgen import Equilibrium, Model, ScrewgenError, equilibrium
from screwgen.studies.held_joints import joint_names

RESTING = LIMITS | {"max_modes": 1, "exact": 0.25, "no_section_rotation": 0.0, "armature": 0.2, "soft": 0.2}
BALLS = {"max_axes": 1, "balls": 0.5}
"""One in two joints is a ball joint."""
LINKS = 4
BALANCED, SAME, FLAT = 1e-7, 1e-9, 1e-7
"""The gradient left over, an energy that differs, an eigenvalue that is zero: all relative to what they are made of."""


class Case(NamedTuple):
    """A robot, where its search begins, and its loads."""

    mixed: Mixed
    model: Model
    start: np.ndarray
    tau: np.ndarray
    w_ext: np.ndarray
    hold: bool


def case_of(seed: int, folder: Path, balls: bool = False) -> Case:
    """The case of a seed, of robots with ball joints or without; what the robot file refuses of tendons is left out."""
    rng, number = np.random.default_rng([15, seed]), seed * 1000
    limits = RESTING | (BALLS if balls else {})
    mixed = drawn(number, folder, LINKS, **limits)
    while mixed.floating or bool(mixed.model.chain.curved) != balls:
        number += 1
        mixed = drawn(number, folder, LINKS, **limits)
    try:
        model = model_of(with_tendons(rng, mixed.robot, 0.25))
    except ValidationError:
        model = mixed.model
    start = np.array(model.chain.home) if mixed.loops is None else np.array(mixed.given[0])
    w_ext = np.zeros((model.n_links, 6))
    if rng.random() < 0.25:
        outer = mixed.judge.outer
        tips = np.where(rng.random((len(outer.links), 1)) < 0.5, rng.uniform(-2, 2, (len(outer.links), 6)), 0.0)
        w_ext = outer.laid(tips, np.zeros((len(outer.rows), 6)))
    hold = bool(rng.random() < 1 / 3)
    return Case(mixed, model, start, loads(rng, model, hold), w_ext, hold)


def loads(rng, model: Model, hold: bool) -> np.ndarray:
    """Torques (n_tau,): on axes with springs, or small ones, where joints are free; tensions."""
    springs = np.array([value > 0 for value in joint_stiffness(model)])
    torques = np.where(springs, rng.uniform(-2, 2, model.n_joints), 0.0)
    torques[list(model.chain.travels)] = 0.0
    torques = torques * (rng.random() < 0.5) * (not hold)
    tensions = rng.uniform(0.0, 3.0, model.n_tau - model.n_joints) * (rng.random() < 0.8)
    return np.append(torques, tensions)


def joint_stiffness(model: Model) -> list[float]:
    values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    return [
        values.get(f"{link.name}.joint.stiffness[{k}]", 0.0)
        for link in model.robot.links
        for k in range(link.joint.kind.torques)
    ]


class Energy:
    """The oracle's potential energy with that of springs between frames, less the work of torques and tensions, and the
    rows that stay zero."""

    def __init__(self, case: Case):
        oracle, model, m = case.mixed.oracle, case.model, case.model.n_joints
        q = oracle.q
        places = model.chain.held_places
        outer = case.mixed.judge.outer
        idle = ca.SX.zeros(6, len(outer.rows)), ca.SX(outer.winches), ca.SX(outer.relaxed)
        added = outer.acting(q, ca.SX.zeros(oracle.nv), *idle)[1]
        added -= sum(float(t) * q[k] for t, k in zip(case.tau, places, strict=False) if t)
        if case.tau[m:].any():
            robot_q = ca.SX(ca.DM(model.chain.home))
            robot_q[model.chain.flat_q.tolist()] = q[model.chain.flat_v.tolist()]
            added -= model.tendon_work(robot_q, case.tau[m:], model.parameter_values)[0]
        energy = oracle.potential + added
        loops = case.mixed.loops
        gap = ca.SX.zeros(0, 1) if loops is None else loops.rows(q, ca.SX.zeros(oracle.nv))[0]
        forces = ca.SX.sym("forces", gap.shape[0])
        hessian, gradient = ca.hessian(energy, q)
        bend = ca.SX.zeros(hessian.shape) if loops is None else ca.hessian(ca.dot(gap, forces), q)[0]
        self._at = ca.Function("at", [q], [energy, gradient, hessian, ca.jacobian(gap, q)])
        self.added = ca.Function("added", [q], [ca.gradient(added, q)])
        self._bend = ca.Function("bend", [q, forces], [bend])

    def at(self, q) -> list[np.ndarray]:
        """Energy, gradient, Hessian, and slopes of the rows."""
        return [x.full() for x in self._at(q)]

    def curvature(self, q, moving: np.ndarray) -> tuple[float, np.ndarray, float]:
        """What is left of the gradient, over what it is made of, the eigenvalues of the scaled Hessian, and by how much
        the energy is lower where a step of Newton's leads, J."""
        _, g, H, J = self.at(q)
        J, g = J[:, moving], g[moving, 0]
        D = np.sqrt(np.maximum(np.abs(np.diag(H)[moving]), 1e-9 * np.max(np.abs(H))) + 1e-12)
        A = J / D
        forces = scipy.linalg.lstsq(A.T, g / D, cond=1e-9)[0] if len(A) else np.zeros(0)
        left = g / D - A.T @ forces
        made = np.abs(H[moving]) @ np.abs(q) / D + np.abs(A.T) @ np.abs(forces) + np.abs(g / D)
        # where nothing loads the robot rounding is left, also along what no stiffness resists: of the stiffest at 1 m
        made += np.finfo(float).eps / BALANCED * np.max(np.abs(H)) / D
        K = (H - self._bend(q, forces).full())[np.ix_(moving, moving)] / np.outer(D, D)
        Z = scipy.linalg.null_space(A, rcond=1e-9) if len(A) else np.eye(len(moving))
        share = float(np.max(np.abs(left), initial=0.0) / (np.max(made, initial=0.0) or 1.0))
        values, ways = np.linalg.eigh(Z.T @ K @ Z) if Z.size else (np.zeros(0), np.zeros((0, 0)))
        pulls = ways.T @ Z.T @ left if Z.size else values
        steep = values > FLAT
        return share, values, float(np.sum(pulls[steep] ** 2 / values[steep]) / 2)


class Judged(NamedTuple):
    """What the judge says of a posture: `faults` in words, and the energy that a lower minimum has less, relative."""

    faults: list[str]
    lower: float


def turns_of(case: Case, q: np.ndarray) -> np.ndarray:
    """The coordinates (nv,) of the oracle, whose ball joints are turns about z, y and x."""
    chain = case.model.chain
    out = chain.flat(q)
    for part in chain.curved:
        w, *u = q[part.q]
        out[part.v] = Rotation.from_quat([*u, w]).as_euler("ZYX")
    return out


def moving_in(case: Case, e: Equilibrium) -> np.ndarray:
    """The coordinates that may move: not those that drives hold."""
    names = joint_names(case.model)
    held = [case.model.chain.held_places[names.index(name)] for name in e.held_joints]
    return np.setdiff1d(np.arange(case.model.nv), held)


def judged(case: Case, e: Equilibrium) -> Judged:
    """The posture under dead loads, held against the energy of the oracle."""
    faults, energy, moving = [], Energy(case), moving_in(case, e)
    if not len(moving):
        return Judged([], 0.0)
    q = turns_of(case, e.q)
    left, values, less = energy.curvature(q, moving)
    if left > BALANCED:
        faults.append(f"unbalanced by {left:.1e}")
    lowest = float(values[0]) if len(values) else 1.0
    said = {"stable": lowest > -FLAT, "neutral": lowest > -1e-5, "unstable": lowest < FLAT}[e.stability]
    if not said:
        faults.append(f"{e.stability}, and the Hessian has {lowest:.1e}")
    here, _, H, _ = energy.at(q)
    size = max(abs(here[0, 0]), np.max(np.abs(np.diag(H)) * q**2), 1e-6)
    if e.stability == "stable" and less > SAME * size:
        faults.append(f"a lower minimum is beside it, by {less:.1e} of {size:.1e} J")
    return Judged(faults, less / size if e.stability == "stable" else 0.0)


def bias_left(case: Case, e: Equilibrium) -> float:
    """Under wrenches that turn with the tips: the oracle's forces that are left over, over the largest."""
    oracle, moving = case.mixed.oracle, moving_in(case, e)
    rest = np.zeros(oracle.nv)
    energy = Energy(case)
    q = turns_of(case, e.q)
    _, g0, _, J = energy.at(q)
    force = oracle.bias(q, rest, case.w_ext[case.mixed.judge.outer.links]) + energy.added(q).full()[:, 0]
    forces = scipy.linalg.lstsq(J[:, moving].T, force[moving], cond=1e-9)[0] if len(J) else np.zeros(0)
    left = force[moving] - J[:, moving].T @ forces
    made = (oracle.K @ q, g0, case.w_ext)
    return float(np.max(np.abs(left), initial=0.0) / max(np.max(np.abs(x)) for x in made))


def outcome(seed: int, balls: bool = False) -> tuple[str, str, float]:
    """What came of a seed: found, refused or FAILS; in words; and by how much a minimum beside it is lower."""
    with TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        case = case_of(seed, Path(folder), balls)
        tensions = case.model.n_tau - case.model.n_joints
        kind = f"{described(case.mixed)} tendons {tensions}{' held' * case.hold}"
        tau = case.tau[case.model.n_joints :] if case.hold else case.tau
        try:
            e = equilibrium(case.model, case.start, tau, case.w_ext, case.hold)
        except ScrewgenError as error:
            return "refused", f"{kind}: {type(error).__name__}: {error}", 0.0
        if case.w_ext.any():
            left = bias_left(case, e)
            return ("found" if left < BALANCED else "FAILS"), f"{kind} turning loads: {left:.1e} left", 0.0
        said = judged(case, e)
        return ("FAILS" if said.faults else "found"), f"{kind} {e.stability}: {'; '.join(said.faults)}", said.lower


def main() -> int:
    first, last, balls = int(sys.argv[1]), int(sys.argv[2]), "balls" in sys.argv
    counts, worst = Counter(), 0.0
    for seed in range(first, last):
        start = time.time()
        try:
            said, text, lower = outcome(seed, balls)
        except Exception as error:  # the sweep goes on; what was raised is a failure
            said, text, lower = "RAISES", f"{type(error).__name__}: {error}", 0.0
        counts[said], worst = counts[said] + 1, max(worst, lower)
        print(f"{seed} {said} {text} {lower:.1e} ({time.time() - start:.0f} s)", flush=True)
    print(dict(counts), f"largest lower energy {worst:.1e}")
    return int(bool(set(counts) - {"found", "refused"}))


if __name__ == "__main__":
    sys.exit(main())
