"""What sensors at the markers of a robot measure, by the oracle: poses, twists and accelerations by differentiation."""

from __future__ import annotations

import copy
from pathlib import Path

import casadi as ca
import flexible_robots as fr
import numpy as np
from helpers import model_of
from mixed_arms import Mixed, drawn
from oracle_shapes import DIRECTIONS, clamped_free, polynomial, tabulate

from screwgen import Model

ORDER = dict.fromkeys(DIRECTIONS, 1) | {"bending_y": 2, "bending_z": 2}


def marked(robot: dict, rng) -> dict:
    """The robot with two more markers on every link that has a length, one of them at its base."""
    robot = copy.deepcopy(robot)
    for link in robot["links"]:
        if "length" in link and "cloud" not in link:
            places = {"root": 0.0, "sensor": float(rng.uniform(0.1, 0.9))}
            link["markers"] = [*link.get("markers", []), *({"name": k, "at": s} for k, s in places.items())]
    return robot


def measuring(seed: int, folder: Path) -> tuple[Mixed, dict, Model]:
    """A random case, its robot with markers, and the model of that."""
    case = drawn(seed, folder, 5)
    robot = marked(case.robot, np.random.default_rng([28, seed]))
    return case, robot, model_of(fr.with_files(robot, folder))


def places(robot: dict) -> list[tuple[str, str, float]]:
    """Name, piece and place along it of every marker: of each link its tip, then those that it declares."""
    out = []
    for link in robot["links"]:
        k, name = link.get("segments", 1), link["name"]
        for marker in ({"name": "tip", "at": 1.0}, *link.get("markers", [])):
            i = min(int(marker["at"] * k), k - 1)
            out.append((f"{name}.{marker['name']}", name if i == k - 1 else f"{name}_part{i}", marker["at"] * k - i))
    return out


def expected(case: Mixed, robot: dict) -> dict[str, np.ndarray]:
    """Rotation, position, twist and acceleration against free fall of every marker."""
    oracle, state = case.oracle, case.state
    vdot = (case.loops or oracle).forward_dynamics(**state)[0]
    names = [link["name"] for link in oracle.robot["links"]]
    out: dict[str, list] = {name: [] for name in ("R", "position", "twist", "acceleration")}
    for _, piece, s in places(robot):
        i = names.index(piece)
        pose = list(oracle.section(i, oracle.clouds[i], s))
        rates = oracle.along_motion(pose)
        second = oracle.along_motion(rates)
        motion = ca.Function("motion", [oracle.q, oracle.v, oracle.a], [*pose, *rates, *second])
        R, r, Rd, rd, Rdd, rdd = (x.full() for x in motion(state["q"], state["v"], vdot))
        out["R"].append(R)
        out["position"].append(r[:, 0])
        turning, bend = R.T @ Rd, R.T @ Rdd - (R.T @ Rd) @ (R.T @ Rd)
        out["twist"].append([*axial(turning), *(R.T @ rd)[:, 0]])
        out["acceleration"].append([*axial(bend), *(R.T @ (rdd[:, 0] - oracle.gravity))])
    return {name: np.array(x) for name, x in out.items()}


def axial(W: np.ndarray) -> list[float]:
    """The vector of a skew matrix."""
    return [W[2, 1], W[0, 2], W[1, 0]]


def strains(robot: dict, model: Model, q) -> list[float]:
    """The strains at bases, then at declared markers: derivatives of the oracle's own shapes, times the modes."""
    eta = dict(zip(model.q_names, q, strict=True))
    at_bases = [x for link in robot["links"] for x in _strains(link, eta, 0.0)]
    declared = [(link, marker["at"]) for link in robot["links"] for marker in link.get("markers", [])]
    return at_bases + [x for link, s in declared for x in _strains(link, eta, s)]


def _strains(link: dict, eta: dict[str, float], s: float) -> list[float]:
    modes, k = link.get("modes", {}), link.get("segments", 1)
    basis, i = modes.get("basis", "polynomial"), min(int(s * k), k - 1)
    out = []
    for direction in DIRECTIONS:
        if count := modes.get(direction, 0):
            owner = f"{link['name']}[{i}]" if k > 1 else link["name"]
            own = [eta[f"{owner}.eta.{direction}[{n}]"] for n in range(count)]
            derivatives = _derivatives(direction, basis, count, s * k - i)
            out.append(derivatives @ own / (link["length"] / k) ** ORDER[direction])
    return out


def _derivatives(direction: str, basis: str, count: int, s: float) -> np.ndarray:
    """Of the order that stores energy, of all shapes at s."""
    order = ORDER[direction]
    if order == 1 and basis == "clamped_free":
        wave = (2 * np.arange(1, count + 1) - 1) * np.pi / 2
        return np.sqrt(2) * wave * np.cos(wave * s)
    functions = clamped_free(count) if basis == "clamped_free" else polynomial(count, order)
    return tabulate(functions, [max(s, 1e-40)])[order, :, 0]
