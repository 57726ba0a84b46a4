"""Postures that `assemble` finds from random starts, judged by the poses of the tips alone."""

import numpy as np

from screwgen import OpenLoopError, assemble
from screwgen.model import Model

CLOSED = 1e-10


def openings(model: Model, q: np.ndarray) -> float:
    """How far the worst loop is open, m or rad: what is left of the pose of one frame in the other one's without the
    slides and turns of the joint, by the poses of the tips alone."""
    return max(_opening(*pose) for pose in poses(model, q))


def poses(model: Model, q: np.ndarray) -> list[tuple]:
    """Of every loop: its screws, and rotation and place of its second frame in axes of the first."""
    (R, r), ends = model.numpy().tip_poses(q), [(j.first, j.second) for j in model.chain.closing.junctions]
    joints = [loop.joint.screws for loop in model.robot.loops]
    return [(x, R[a].T @ R[b], R[a].T @ (r[b] - r[a])) for x, (a, b) in zip(joints, ends, strict=True)]


def _opening(screws, turned: np.ndarray, apart: np.ndarray) -> float:
    slides = np.array([s.axis for s in screws if not s.turn]).reshape(-1, 3)
    turns = [np.array(s.axis) for s in screws if s.turn]
    rest = apart - slides.T @ np.linalg.lstsq(slides.T, apart, rcond=None)[0]
    if len(turns) == 0:
        bent = np.linalg.norm(turned - np.eye(3))
    elif len(turns) == 1:
        bent = np.linalg.norm(turned @ turns[0] - turns[0])
    else:
        bent = abs(turns[0] @ turned @ turns[1] - turns[0] @ turns[1]) if len(turns) == 2 else 0.0
    return float(max(np.linalg.norm(rest), bent))


def start(model: Model, rng) -> np.ndarray:
    """Coordinates all round, of slides half a metre to either side."""
    wide = [0.5 if ".slide[" in name else np.pi for name in model.q_names]
    return np.array(wide) * rng.uniform(-1.0, 1.0, model.nq)


def found(model: Model, rng) -> np.ndarray | None:
    """Where `assemble` ends from a random start; None where it refuses."""
    try:
        return assemble(model, start(model, rng))
    except OpenLoopError:
        return None
