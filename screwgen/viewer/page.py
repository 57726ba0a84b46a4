"""The page: motions of robots, packed, in one HTML file that needs nothing else."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np

from ..backends.templates import folder, markup, render
from ..model import Model
from ..simulation.runs import Run, check_output, outputs
from .meshes import Looks, packed, placed
from .pack import kept, rounded
from .panels import panels
from .scene import scene

SUFFIXES = (".html",)
PARTS = ("kinematics.js", "plots.js", "drawing.js", "actuators.js", "player.js", "controls.js")
"""The page's own script, in this order."""
FINE = 1e-4
"""How far a joint may be off, rad, or a displacement over the size of the robot."""
FINER = 1e-5
"""The same of modes, which can be magnified."""


@dataclass(frozen=True)
class View:
    """A page, as text; notebooks show it."""

    html: str

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the page as an .html file, which replaces an existing one at once. Raises UsageError."""
        check_output(path, SUFFIXES)
        with outputs(path) as (stream,):
            stream.write(self.html.encode())

    def _repr_html_(self) -> str:
        """The page in a frame of its own."""
        style = "width:100%;height:640px;border:1px solid #8884;border-radius:8px"
        return f'<iframe srcdoc="{escape(self.html)}" style="{style}" title="screwgen viewer"></iframe>'


def page(
    title: str, scenes: Sequence[dict], clips: Sequence[dict], ghost: int | None = None, kind: str = "run"
) -> View:
    """The page of `clips`, each of one of the `scenes`; `ghost`: the clip that is drawn translucent."""
    data = {"title": title, "kind": kind, "scenes": scenes, "clips": clips, "ghost": ghost}
    text = json.dumps(data, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    here = folder() / "view"
    read = lambda name: markup((here / name).read_text(encoding="utf-8"))  # noqa: E731
    shown = {"style": read("style.css"), "three": read("three/three.min.js"), "licence": read("three/LICENSE")}
    script = markup("\n".join((here / name).read_text(encoding="utf-8") for name in PARTS))
    return View(render("view/page.html.jinja", title=title, data=markup(text), script=script, **shown))


def clip_of(run: Run, model: Model, number: int, label: str, goals: np.ndarray | None = None) -> dict[str, Any]:
    """A run for the page, of scene `number`; `goals` (n_joints, N): set points of its joints."""
    size = scene_size(model)
    tolerance = np.full(model.nq, FINE)
    tolerance[model.chain.eta_q :] = FINER * size
    forces = np.column_stack([run.wrench.reshape(len(run.t), -1), run.tau])
    width = 2 * (model.nq + forces.shape[1])
    rows, error = kept(run.t, run.q, tolerance, width)
    coarse = np.maximum(np.abs(forces).max(axis=0) * 1e-3, 1e-9)
    return {
        "label": label,
        "scene": number,
        "samples": [len(rows), len(run.t)],
        "within": error,
        "t": rounded(run.t[rows, None], np.array([1e-6])),
        "q": rounded(run.q[rows], tolerance),
        "forces": rounded(forces[rows], coarse),
        "panels": panels(run, model, goals),
    }


def mode_clip(label: str, t: np.ndarray, q: np.ndarray) -> dict[str, Any]:
    """A vibration over a period, or a posture; `t` in periods."""
    exact = np.zeros(q.shape[1])
    return {"label": label, "scene": 0, "t": rounded(t[:, None], exact[:1]), "q": rounded(q, exact)}


def scene_size(model: Model) -> float:
    """A length to which displacements compare, m."""
    return sum(link.length or 0.0 for link in model.robot.links) or 1.0


def run_page(
    runs: Sequence[tuple[Run, Model, str]], looks: Looks | None = None, goals: np.ndarray | None = None
) -> View:
    """The page of a run, and of a second one as its ghost; each with its model and what it is called.

    `looks`: the visuals that they wear; `goals` (n_joints, N): the set points of the first one's joints.
    """
    scenes = [scene(model, run.parameters, run.q[0]) for run, model, _ in runs]
    if looks is not None:
        dressed = [
            placed(looks, model, x, label, run.parameters) for x, (run, model, label) in zip(scenes, runs, strict=True)
        ]
        for x, parts in zip(scenes, dressed, strict=True):
            x["meshes"] = [packed(k, solid, scenes[0]["size"]) for k, solid in parts]
        for x in scenes[1:]:
            if x["meshes"] == scenes[0]["meshes"]:
                x["meshes"] = "as the first"
    clips = [clip_of(run, model, k, label, None if k else goals) for k, (run, model, label) in enumerate(runs)]
    return page(runs[0][1].robot.name, scenes, clips, 1 if len(runs) > 1 else None)
