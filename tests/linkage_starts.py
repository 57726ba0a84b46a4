"""Postures that `assemble` finds from random starts, of every linkage of tests/mechanisms.py.

    python tests/linkage_starts.py 500

divides so many starts among the linkages, or among those that are named behind the number, and prints a table: how many
starts end with closed loops, by the motions that the linkage has there, how many are refused, and how many end with a
loop that is open by the definition of its joint. The last must be none.
"""

import sys
from collections import Counter

import numpy as np
from helpers import model_of
from mechanisms import MECHANISMS

from screwgen import OpenLoopError, assemble
from screwgen.model import Model

CLOSED = 1e-10
RANK = 1e-6
"""Of the rates of the loops' frames, as a part of the largest: below it a motion of the joints opens no loop."""


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


def motions(model: Model, q: np.ndarray) -> int:
    """How many motions at `q` keep the loops closed at first, by differences of the frames' poses."""
    step, columns = 1e-5, []
    for e in np.eye(model.nq):
        there, before = (np.concatenate([_demanded(*pose) for pose in poses(model, q + s * step * e)]) for s in (1, -1))
        columns.append((there - before) / (2 * step))
    sizes = np.linalg.svd(np.array(columns), compute_uv=False)
    return model.nq - int(np.sum(sizes > RANK * sizes[0]))


def _demanded(screws, turned: np.ndarray, apart: np.ndarray) -> np.ndarray:
    slides = np.array([s.axis for s in screws if not s.turn]).reshape(-1, 3)
    turns = [np.array(s.axis) for s in screws if s.turn]
    rest = apart - slides.T @ np.linalg.lstsq(slides.T, apart, rcond=None)[0]
    bent = [turned.ravel(), turned @ turns[0] if turns else [], [turns[0] @ turned @ turns[-1]] if turns else [], []]
    return np.concatenate([rest, bent[min(len(turns), 3)]])


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


def main(count: int, names: list[str]) -> None:
    print(f"{'linkage':26} {'closed':>7} {'refused':>8} {'open':>5} {'worst':>9}  motions there")
    each = -(-count // len(names))
    for k, name in enumerate(names):
        model, rng = model_of(MECHANISMS[name]()), np.random.default_rng(k)
        ends = [found(model, rng) for _ in range(each)]
        closed = [q for q in ends if q is not None]
        worst = [openings(model, q) for q in closed]
        kinds = Counter(motions(model, q) for q in closed)
        shown = ", ".join(f"{n}: {times}" for n, times in sorted(kinds.items()))
        bad = sum(not w < CLOSED for w in worst)
        counts = f"{len(closed):7} {each - len(closed):8} {bad:5}"
        print(f"{name:26} {counts} {max(worst, default=0.0):9.1e}  {shown}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2:] or list(MECHANISMS))
