"""Plug-ins: packages that extend screwgen and are found by their entry points.

A plug-in is an object of :class:`Plugin`, declared as an entry point of the group ``screwgen.plugins``::

    [project.entry-points."screwgen.plugins"]
    mine = "mypackage.plugin:PLUGIN"

Every hook may be left out.  Hooks import what they need when they are called, so that a plug-in costs nothing before.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from .errors import ScrewgenError

if TYPE_CHECKING:
    import numpy as np
    import typer

    from .arguments import Loads, Numbers
    from .ir.block import Block
    from .spec.link_class import LinkClass
    from .spec.robot import Robot
    from .topology.chain import Chain

GROUP = "screwgen.plugins"
CHECKOUT = Path(__file__).resolve().parents[1] / "pyproject.toml"
T = TypeVar("T")


class PluginChapter(Protocol):
    """What a plug-in adds to a document, made of :mod:`.backends.latex.content`."""

    @property
    def sections(self) -> tuple[Any, ...]:
        """The sections."""

    @property
    def views(self) -> tuple[tuple[Block, Any], ...]:
        """The blocks that they show, each with its view."""

    @property
    def symbols(self) -> tuple[Any, ...]:
        """The symbols of their text."""


class Formulation(Protocol):
    """A robot's equations in another formulation, beside the model that is derived."""

    @property
    def model(self) -> Any:
        """The derived :class:`screwgen.Model` with the same coordinates, kinematics and energies."""

    def forward_dynamics(
        self, q: Numbers, v: Numbers, tau: Loads, w_ext: Loads = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """``vdot`` (nq,) and the joint wrenches (n, 6) at ``q``, ``v`` (nq,), torques and tip wrenches (n, 6)."""

    def record(self) -> dict:
        """What is said of the formulation beside its results, as JSON takes it."""


def _nothing(_: object) -> dict:
    return {}


@dataclass(frozen=True)
class Plugin:
    """What a package adds to the product."""

    commands: Callable[[typer.Typer], object] = _nothing
    """Adds commands to the command line."""
    formulations: Mapping[str, Callable[[Robot], Formulation]] = field(default_factory=dict)
    """What ``derive(robot, formulation=name)`` gives."""
    attributes: Mapping[str, Callable[[Any], Any]] = field(default_factory=dict)
    """Attributes of a model."""
    blocks: Callable[[LinkClass], Mapping[str, Block]] = _nothing
    """Blocks of a link class; documents show them behind those of the product."""
    common: Callable[[], Mapping[str, Block]] = dict
    """Blocks that are the same for every link."""
    casadi: Callable[[Chain], Mapping[str, Callable[[], Any]]] = _nothing
    """What makes CasADi functions, by name."""
    casadi_notes: str = ""
    """What the README of the CasADi functions says of them, in Markdown."""
    chapter: Callable[[Chain], PluginChapter | None] = lambda _: None
    """What a robot's document says, before its link classes."""
    trees: bool = True
    """Whether documents of robots that are no chains have its blocks and its chapter."""


def plugins() -> tuple[Plugin, ...]:
    """The plug-ins that are installed, in the order of their names.

    One that is declared but whose module is not there is left out: its folder may be deleted.  Raises ScrewgenError
    for one that is there and cannot be imported.
    """
    found = (_loaded(entry) for _, entry in sorted(declared().items()))
    return tuple(plugin for plugin in found if plugin is not None)


def declared() -> dict[str, EntryPoint]:
    """The plug-ins that are declared, by name, whether or not their modules are there.

    Those of a checkout replace what its metadata says.  Raises ScrewgenError where two packages take one name.
    """
    own = {entry.name: entry for entry in _of_checkout()}
    found: dict[str, EntryPoint] = {}
    for entry in entry_points(group=GROUP):
        if found.setdefault(entry.name, entry).value != entry.value and entry.name not in own:
            raise ScrewgenError(f"two packages have a plug-in '{entry.name}': {found[entry.name].value}, {entry.value}")
    return found | own


def _of_checkout() -> list[EntryPoint]:
    """What the pyproject.toml of a checkout declares: an editable installation keeps the metadata of its first day."""
    if not CHECKOUT.is_file():
        return []
    project = tomllib.loads(CHECKOUT.read_text(encoding="utf-8")).get("project", {})
    table = project.get("entry-points", {}).get(GROUP, {}) if project.get("name") == "screwgen" else {}
    return [EntryPoint(name, value, GROUP) for name, value in table.items()]


def _loaded(entry: EntryPoint) -> Plugin | None:
    """The plug-in, or None where its module is not there."""
    try:
        return entry.load()
    except ModuleNotFoundError as error:
        if f"{entry.module}.".startswith(f"{error.name}."):
            return None
        raise ScrewgenError(f"the plug-in '{entry.name}' cannot be imported: {error}") from error
    except (ImportError, AttributeError) as error:
        raise ScrewgenError(f"the plug-in '{entry.name}' cannot be imported: {error}") from error


def merged(what: str, *parts: Mapping[str, T]) -> dict[str, T]:
    """All parts as one mapping.  Raises ScrewgenError for a name that two of them have."""
    out: dict[str, T] = {}
    for part in parts:
        if twice := out.keys() & part.keys():
            raise ScrewgenError(f"two plug-ins, or a plug-in and the product, have the {what} '{min(twice)}'")
        out |= part
    return out
