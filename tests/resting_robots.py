"""Random robots brought to rest by `equilibrium`, and judged by their energy: `python tests/resting_robots.py 0 500`.

The robots are those of :mod:`mixed_arms` on fixed bases, small, with rods of all orders, and besides with tendons and
couplings. A third has its joints held, a quarter wrenches that turn with the tips, the others dead loads alone. The
judge is the oracle's potential energy, less the work of torques and tensions: at the posture found its gradient
vanishes along what may move, its Hessian there has the signs of the verdict, and a minimum that SciPy finds from a
posture beside it is not lower.
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
import flexible_robots as fr
import numpy as np
import scipy.linalg
from helpers import model_of
from mixed_arms import LIMITS, Mixed, described, drawn
from pydantic import ValidationError
from scipy.optimize import minimize

from screwgen import Equilibrium, Model, ScrewgenError, equilibrium

RESTING = LIMITS | {"max_modes": 1, "exact": 0.25, "no_section_rotation": 0.0, "armature": 0.2, "soft": 0.2}
LINKS = 4
BALANCED, SAME, FLAT = 1e-7, 1e-9, 1e-7
"""The gradient left over, an energy that differs, an eigenvalue that is zero: all relative to what they are made of."""
BESIDE = 1e-3
"""How far beside the posture found the judge begins, in units of about one rad."""


class Case(NamedTuple):
    """A robot, where its search begins, and its loads."""

    mixed: Mixed
    model: Model
    couplings: list[dict]
    start: np.ndarray
    tau: np.ndarray
    w_ext: np.ndarray
    hold: bool


def case_of(seed: int, folder: Path) -> Case:
    """The case of a seed; what the robot file refuses of tendons and couplings is left out."""
    rng, number = np.random.default_rng([15, seed]), seed * 1000
    mixed = drawn(number, folder, LINKS, **RESTING)
    while mixed.floating:
        number += 1
        mixed = drawn(number, folder, LINKS, **RESTING)
    robot = with_couplings(rng, with_tendons(rng, mixed.robot))
    try:
        model = model_of(fr.with_files(robot, folder))
    except ValidationError:
        robot = with_tendons(np.random.default_rng(0), mixed.robot)
        model = mixed.model
    start = np.zeros(model.nq) if mixed.loops is None else np.array(mixed.given[0])
    w_ext = np.zeros((model.n_links, 6))
    if rng.random() < 0.25:
        w_ext = np.where(rng.random((model.n_links, 1)) < 0.5, rng.uniform(-2, 2, (model.n_links, 6)), 0.0)
    hold = bool(rng.random() < 1 / 3)
    couplings = robot.get("couplings", []) if model is not mixed.model else []
    return Case(mixed, model, couplings, start, loads(rng, model, hold), w_ext, hold)


def with_tendons(rng, robot: dict) -> dict:
    """The robot with a tendon along some of its flexible links, or two that pull against each other."""
    links = []
    for link in robot["links"]:
        bends = any(link.get("modes", {}).get(d) for d in ("bending_y", "bending_z"))
        if bends and "cloud" not in link and "segments" not in link and rng.random() < 0.25:
            y, z = rng.uniform(0.005, 0.02, 2).tolist()
            own = [{"name": f"cord_{link['name']}", "at": [[0.0, y, z], [0.0, y, 0.5 * z]]}]
            if rng.random() < 0.5:
                own.append({"name": f"against_{link['name']}", "at": [[0.0, -y, -z], [0.0, -y, -0.5 * z]]})
            link = link | {"tendons": own}
        links.append(link)
    return robot | {"links": links}


def with_couplings(rng, robot: dict) -> dict:
    """The robot with one axis that follows another, in some robots without loops."""
    axes = [
        f"{link['name']}.joint[{k}]"
        for link in robot["links"]
        for k, axis in enumerate(link["joint"]["axes"])
        if not isinstance(axis, dict) and not link["joint"].get("drives")
    ]
    if "loops" in robot or len(axes) < 2 or rng.random() > 0.3:
        return robot
    first, second = rng.choice(len(axes), 2, replace=False)
    ratio = float(rng.choice([-1, 1]) * rng.uniform(0.4, 2.0))
    return robot | {"couplings": [{"axis": axes[second], "of": axes[first], "ratio": ratio}]}


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
        for k in range(len(link.joint.axes))
    ]


def descended(value, start: np.ndarray, slope, curve, least: float):
    """What SciPy finds downhill; its method for Hessians may divide by a step of zero, and then another goes on."""
    try:
        options = {"gtol": least, "maxiter": 500}
        return minimize(value, start, jac=slope, hess=curve, method="trust-exact", options=options)
    except ValueError:
        return minimize(value, start, jac=slope, method="BFGS", options={"gtol": least})


class Energy:
    """The oracle's potential energy less the work of torques and tensions, and the rows that stay zero."""

    def __init__(self, case: Case):
        oracle, model, m = case.mixed.oracle, case.model, case.model.n_joints
        q, rows = oracle.q, []
        places = model.chain.held_places
        energy = oracle.potential - sum(float(t) * q[k] for t, k in zip(case.tau, places, strict=False) if t)
        if case.tau[m:].any():
            work = model.tendon_work(q, case.tau[m:], model.parameter_values)[0]
            energy = energy - work
        if case.mixed.loops is not None:
            rows.append(case.mixed.loops.rows(q, ca.SX.zeros(oracle.nv))[0])
        for coupling in case.couplings:
            a, b = (model.q_names.index(coupling[end]) for end in ("axis", "of"))
            rows.append(q[a] - coupling["ratio"] * q[b])
        gap = ca.vertcat(*rows) if rows else ca.SX.zeros(0, 1)
        forces = ca.SX.sym("forces", gap.shape[0])
        hessian, gradient = ca.hessian(energy, q)
        bend = ca.hessian(ca.dot(gap, forces), q)[0] if rows else ca.SX.zeros(hessian.shape)
        self._at = ca.Function("at", [q], [energy, gradient, hessian, gap, ca.jacobian(gap, q)])
        self._bend = ca.Function("bend", [q, forces], [bend])

    def at(self, q) -> list[np.ndarray]:
        return [x.full() for x in self._at(q)]

    def curvature(self, q, moving: np.ndarray) -> tuple[float, np.ndarray]:
        """What is left of the gradient, over what it is made of, and the eigenvalues of the scaled Hessian."""
        _, g, H, _, J = self.at(q)
        J, g = J[:, moving], g[moving, 0]
        D = self._sizes(H, moving)
        A = J / D
        forces = scipy.linalg.lstsq(A.T, g / D, cond=1e-9)[0] if len(A) else np.zeros(0)
        left = g / D - A.T @ forces
        made = np.abs(H[moving]) @ np.abs(q) / D + np.abs(A.T) @ np.abs(forces) + np.abs(g / D)
        K = (H - self._bend(q, forces).full())[np.ix_(moving, moving)] / np.outer(D, D)
        Z = scipy.linalg.null_space(A, rcond=1e-9) if len(A) else np.eye(len(moving))
        share = float(np.max(np.abs(left), initial=0.0) / (np.max(made, initial=0.0) or 1.0))
        return share, np.linalg.eigvalsh(Z.T @ K @ Z) if Z.size else np.zeros(0)

    def minimum(self, q: np.ndarray, moving: np.ndarray, beside: np.ndarray) -> tuple[float, float]:
        """The energy at `q`, and the lowest that SciPy finds from beside it."""
        here, _, H, _, J = self.at(q)
        D = self._sizes(H, moving)
        whole = lambda x: self._whole(q, moving, x / D)  # noqa: E731
        value = lambda x: float(self.at(whole(x))[0][0, 0] - here[0, 0])  # noqa: E731
        slope = lambda x: self.at(whole(x))[1][moving, 0] / D  # noqa: E731
        curve = lambda x: self.at(whole(x))[2][np.ix_(moving, moving)] / np.outer(D, D)  # noqa: E731
        step = beside * D
        if not len(J):
            found = descended(value, step, slope, curve, 1e-10)
            return float(here[0, 0]), min(found.fun, 0.0)
        Z = scipy.linalg.null_space(J[:, moving] / D, rcond=1e-9)
        rows = {
            "type": "eq",
            "fun": lambda x: self.at(whole(x))[3][:, 0],
            "jac": lambda x: self.at(whole(x))[4][:, moving] / D,
        }
        options = {"ftol": 1e-14, "maxiter": 200}
        found = minimize(value, Z @ (Z.T @ step), jac=slope, method="SLSQP", constraints=[rows], options=options)
        closed = np.max(np.abs(rows["fun"](found.x))) < 1e-9
        return float(here[0, 0]), min(found.fun, 0.0) if closed else 0.0

    def resting(self, start: np.ndarray, moving: np.ndarray) -> np.ndarray | None:
        """Where SciPy comes to rest from `start`, of a robot whose coordinates are independent; None: nowhere."""
        D = self._sizes(self.at(start)[2], moving)
        whole = lambda x: self._whole(start, moving, x / D)  # noqa: E731
        slope = lambda x: self.at(whole(x))[1][moving, 0] / D  # noqa: E731
        curve = lambda x: self.at(whole(x))[2][np.ix_(moving, moving)] / np.outer(D, D)  # noqa: E731
        value = lambda x: float(self.at(whole(x))[0][0, 0])  # noqa: E731
        found = descended(value, np.zeros(len(moving)), slope, curve, 1e-9)
        q = whole(found.x)
        return q if found.success and self.curvature(q, moving)[0] < BALANCED else None

    @staticmethod
    def _sizes(H: np.ndarray, moving: np.ndarray) -> np.ndarray:
        """(moving,): roots of the stiffness of each coordinate, of one without by far smaller than any."""
        return np.sqrt(np.maximum(np.abs(np.diag(H)[moving]), 1e-9 * np.max(np.abs(H))) + 1e-12)

    @staticmethod
    def _whole(q: np.ndarray, moving: np.ndarray, change: np.ndarray) -> np.ndarray:
        out = q.copy()
        out[moving] += change
        return out


class Judged(NamedTuple):
    """What the judge says of a posture: `faults` in words, and the energy that a lower minimum has less, relative."""

    faults: list[str]
    lower: float


def moving_in(case: Case, e: Equilibrium) -> np.ndarray:
    """The coordinates that may move: not those that drives hold."""
    names = case.model.q_names
    held = [case.model.chain.held_places[names.index(name)] for name in e.held_joints]
    return np.setdiff1d(np.arange(case.model.nq), held)


def judged(case: Case, e: Equilibrium, rng) -> Judged:
    """The posture under dead loads, held against the energy of the oracle."""
    faults, energy, moving = [], Energy(case), moving_in(case, e)
    if not len(moving):
        return Judged([], 0.0)
    left, values = energy.curvature(e.q, moving)
    if left > BALANCED:
        faults.append(f"unbalanced by {left:.1e}")
    lowest = float(values[0]) if len(values) else 1.0
    said = {"stable": lowest > -FLAT, "neutral": lowest > -1e-5, "unstable": lowest < FLAT}[e.stability]
    if not said:
        faults.append(f"{e.stability}, and the Hessian has {lowest:.1e}")
    if e.stability != "stable" or e.validity.buckled:
        return Judged(faults, 0.0)
    size = 1.0 + float(np.sum(np.abs(e.q))) * BESIDE
    beside = BESIDE * size * rng.uniform(-1, 1, len(moving))
    modal = moving >= case.model.chain.eta_q
    beside[modal] = 0.1 * rng.uniform(-1, 1, np.count_nonzero(modal)) * np.abs(e.q[moving][modal])
    here, less = energy.minimum(e.q, moving, beside)
    size = max(abs(here), np.max(np.abs(np.diag(energy.at(e.q)[2])) * e.q**2), 1e-6)
    if -less > SAME * size:
        faults.append(f"a lower minimum is beside it, by {-less:.1e} of {size:.1e} J")
    return Judged(faults, -less / size)


def missed(case: Case) -> bool:
    """Whether SciPy finds rest, within the limits of the model, where `equilibrium` refuses under dead loads."""
    model, m = case.model, case.model.n_joints
    if case.w_ext.any() or model.chain.closing.rows:
        return False
    held = case.hold & (np.array(joint_stiffness(model)) == 0)
    moving = np.setdiff1d(np.arange(model.nq), np.array(model.chain.held_places)[held])
    q = Energy(case).resting(case.start, moving)
    if q is None or np.max(np.abs(q[:m]), initial=0.0) > 20:
        return False
    small = [key.order != "exact" for key in model.chain.keys for _ in range(key.modes)]
    return not (np.abs(q[model.chain.eta_q :])[small] > 0.3).any()


def bias_left(case: Case, e: Equilibrium) -> float:
    """Under wrenches that turn with the tips: the oracle's forces that are left over, over the largest."""
    oracle, moving = case.mixed.oracle, moving_in(case, e)
    rest = np.zeros(oracle.nv)
    force = oracle.bias(e.q, rest, case.w_ext)
    _, g0, _, _, J = Energy(case).at(e.q)
    _, g1, *_ = Energy(case._replace(tau=np.zeros_like(case.tau))).at(e.q)
    force = force + (g0 - g1)[:, 0]
    forces = scipy.linalg.lstsq(J[:, moving].T, force[moving], cond=1e-9)[0] if len(J) else np.zeros(0)
    left = force[moving] - J[:, moving].T @ forces
    made = (oracle.K @ e.q, g0, case.w_ext)
    return float(np.max(np.abs(left), initial=0.0) / max(np.max(np.abs(x)) for x in made))


def outcome(seed: int) -> tuple[str, str, float]:
    """What came of a seed: found, refused or FAILS; in words; and by how much a minimum beside it is lower."""
    with TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        case, rng = case_of(seed, Path(folder)), np.random.default_rng([16, seed])
        tensions = case.model.n_tau - case.model.n_joints
        kind = f"{described(case.mixed)} tendons {tensions} couplings {len(case.couplings)}"
        kind += f" exact {sum(k.order == 'exact' for k in case.model.chain.keys)}{' held' * case.hold}"
        tau = case.tau[case.model.n_joints :] if case.hold else case.tau
        try:
            e = equilibrium(case.model, case.start, tau, case.w_ext, case.hold)
        except ScrewgenError as error:
            return ("MISSED" if missed(case) else "refused"), f"{kind}: {type(error).__name__}: {error}", 0.0
        if case.w_ext.any():
            left = bias_left(case, e)
            return ("found" if left < BALANCED else "FAILS"), f"{kind} turning loads: {left:.1e} left", 0.0
        said = judged(case, e, rng)
        return ("FAILS" if said.faults else "found"), f"{kind} {e.stability}: {'; '.join(said.faults)}", said.lower


def main() -> int:
    first, last = int(sys.argv[1]), int(sys.argv[2])
    counts, worst = Counter(), 0.0
    for seed in range(first, last):
        start = time.time()
        try:
            said, text, lower = outcome(seed)
        except Exception as error:  # the sweep goes on; what was raised is a failure
            said, text, lower = "RAISES", f"{type(error).__name__}: {error}", 0.0
        counts[said], worst = counts[said] + 1, max(worst, lower)
        print(f"{seed} {said} {text} {lower:.1e} ({time.time() - start:.0f} s)", flush=True)
    print(dict(counts), f"largest lower energy {worst:.1e}")
    return int(bool(set(counts) - {"found", "refused"}))


if __name__ == "__main__":
    sys.exit(main())
