"""Files of laws with a filter, .npz."""

from __future__ import annotations

import os
from typing import BinaryIO

import numpy as np

from ..files import sound
from ..spec.array_files import arrays_of, check_numbers, check_shapes
from .lqg import Lqg
from .lqg_design import LqgGains
from .scheduling import MOST, Grid

TEXTS = ("robot", "joints", "variables", "lines")
NUMBERS = ("step", "tau_max", "q_des", "scheduled")


def write_lqg(law: Lqg, stream: BinaryIO) -> None:
    """All of a law."""
    grid = law.grid
    arrays = {"step": np.array(law.step), "tau_max": law.tau_max, "q_des": law.q_des}
    arrays |= {"robot": np.array(law.robot), "joints": np.array(law.joints), "lines": np.array(law.lines)}
    arrays |= {"variables": np.array(grid.names), "scheduled": np.array(grid.joints)}
    arrays |= {f"grid_{k}": values for k, values in enumerate(grid.values)}
    np.savez(stream, allow_pickle=False, **arrays, **law.tables._asdict())


def read_lqg(path: str | os.PathLike[str]) -> Lqg:
    """The law in a .npz file; raises UsageError, one line."""
    with arrays_of(path, "a law", "a .npz of gains --lqg") as arrays:
        texts = {name: arrays.texts(name) for name in TEXTS}
        found = {name: arrays.numbers(name) for name in (*NUMBERS, *LqgGains._fields)}
        values = tuple(arrays.numbers(f"grid_{k}") for k in range(len(texts["variables"])))
        check_numbers(found)
        if not values or any(x.ndim != 1 or len(x) < 2 or not sound(x) or not (np.diff(x) > 0).all() for x in values):
            raise ValueError("a grid's values do not ascend")
        m, V = len(texts["joints"]), int(np.prod([len(x) for x in values]))
        n = found["M"].shape[-1] if found["M"].ndim else 0
        shapes: dict[str, tuple[int, ...]] = {"M": (V, n, n), "S": (V, n, n), "D": (V, n, n), "K": (V, m, 2 * n)}
        shapes |= {"Kz": (V, m, m), "L": (V, 2 * n, m), "modes": (V, n - m), "hold": (V, m)}
        shapes |= {"step": (), "tau_max": (m,), "q_des": (m,), "scheduled": (len(values),)}
        check_shapes(found, shapes)
        if V > MOST:
            raise ValueError(f"its grid has {V} vertices; {MOST} are allowed")
        if not (found["scheduled"] % 1 == 0).all():
            raise ValueError("scheduled holds something else than whole numbers")
        scheduled = tuple(int(x) for x in found["scheduled"])
        if not found["step"] > 0 or not (found["tau_max"] > 0).all() or any(not -1 <= j < m for j in scheduled):
            raise ValueError("its step, limits or variables make no sense")
    tables = LqgGains(*(found[name] for name in LqgGains._fields))
    grid = Grid(texts["variables"], scheduled, values)
    step, limits, goal = found["step"].item(), found["tau_max"], found["q_des"]
    return Lqg(texts["robot"][0], texts["joints"], step, grid, tables, limits, goal, texts["lines"])
