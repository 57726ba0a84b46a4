"""The files that each target of a model consists of: names, relative to the target's folder, and contents."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from typing import Any

from .errors import PrecisionWarning
from .plugins import Plugin
from .robot_model import RobotModel
from .spec.robot import Robot
from .version import __version__ as VERSION


def c_files(model: RobotModel, mpc: str | os.PathLike | None, *given: Any, **options: Any) -> dict[str, bytes]:
    """Of C, as :meth:`screwgen.Model.c_files` says; the rest as :class:`~screwgen.backends.c.project.CProject`."""
    from .studies import predictive

    project = predictive.project(model, mpc, *given, **options)
    files = {name: text.encode() for name, text in project.files().items()}
    if lost := project.check["lost"]:
        said = f"robot '{model.robot.name}': the C is of no use in float: rounding may change results by {lost}"
        warnings.warn(f"{said}; compile it as double", PrecisionWarning, stacklevel=3)
    return files


def casadi_files(
    model: RobotModel, plugins: Sequence[Plugin], functions: str | Sequence[str] | None
) -> dict[str, bytes]:
    """Of CasADi: the saved functions, and a README."""
    from .backends.casadi.functions import casadi_files

    notes = {p.casadi_notes: tuple(p.casadi(model.chain)) for p in plugins if p.casadi_notes}
    return casadi_files(model.robot, model.casadi(), functions, model.parameter_names, VERSION, notes)


def latex_files(robot: Robot, plugins: Sequence[Plugin]) -> dict[str, bytes]:
    """Of the documents, in LaTeX and HTML."""
    from .backends.latex import document as latex

    shown = latex.content(robot, plugins)
    made = {".tex": latex.tex(shown), ".html": latex.page(shown, latex.extras(latex.chain_of(robot)))}
    return {f"{robot.name}{end}": text.encode() for end, text in made.items()}


def unit_files(model: RobotModel, target: str, **options: Any) -> dict[str, bytes]:
    """Of a functional mock-up unit; options as :func:`screwgen.runtime.fmu.unit_files` takes them."""
    from .runtime import fmu

    return fmu.unit_files(model, target, **options)


def feedforward_files(model: RobotModel, **options: Any) -> dict[str, bytes]:
    """Of the C of a feedforward: a robot whose axes all move as given, and the efforts of its motion."""
    from .backends.c.feedforward import FeedforwardProject
    from .simulation.feedforward import METHOD, moved_model

    own = moved_model(model)
    options |= {"binding": options.pop("parameters"), "methods": (*options["methods"], METHOD)}
    project = FeedforwardProject(own.chain, own.version, **options)
    return {name: text.encode() for name, text in project.files().items()}
