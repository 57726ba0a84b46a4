"""The curves below the picture of a page: what the figure of a run shows, without the wrenches of its joints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..model import Model
from ..plotting.run_panels import PanelCurve, motion_panels, sift
from ..simulation.runs import Run
from .pack import curve

COLORS = 8
"""Of links, in templates/view/style.css."""


def panels(run: Run, model: Model, goals: np.ndarray | None = None) -> list[dict[str, Any]]:
    """The panels of a run that show anything; `goals` (n_joints, N): set points of its joints."""
    return [
        {"title": x.title, "unit": x.unit, "curves": [part for line in x.lines for part in _drawn(line, run.t)]}
        for x in sift(motion_panels(run, model, goals))[0]
    ]


def _drawn(line: PanelCurve, t: np.ndarray) -> Iterator[dict[str, Any]]:
    label, color = (
        line.label.replace("_", " "),
        line.owner if isinstance(line.owner, str) else f"c{line.owner % COLORS}",
    )
    if line.goal is not None:
        yield curve(f"{label}, set point", t, line.goal, color, goal=True)
    yield curve(label, t, line.values, color, line.number)
