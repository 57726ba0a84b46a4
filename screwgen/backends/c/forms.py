"""The sources of each form: most callers need the joint form alone, and compilers work longest on the DAE form."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from .columns import rendered

if TYPE_CHECKING:
    from .project import CProject

DAE_RUNS = frozenset({"dae_dynamics", "projection", "placement", "assembly"})
"""The runs of :mod:`.links` that belong to the DAE form alone."""

SHARED = ("real.c", "parameters.c", "forces.c", "loops.c", "rows.c")
"""Sources, without the robot's name, that the DAE form needs besides its own."""


def split(project: CProject, files: Mapping[str, str]) -> tuple[dict[str, str], dict[str, str]]:
    """The files of a library, with its shims, as those of the joint form and those of the DAE form."""
    of = lambda name: f"{project.name}_{name}"  # noqa: E731
    links, own = of("links.c"), {of("dae.c"), "dae_shim.c"}
    joint = {name: text for name, text in files.items() if name not in own} | {links: _links(project, False)}
    kept = own | set(map(of, SHARED))
    dae = {name: text for name, text in files.items() if name.endswith(".h") or name in kept}
    return joint, dae | {links: _links(project, True)}


def _links(project: CProject, dae: bool) -> str:
    """The phases and loops over the links that a form calls."""
    links = project.links
    forms: dict[bool, list[dict]] = {False: [], True: []}
    for name in links.runs:
        forms[name in DAE_RUNS] += links.parts(name)
    phases = {form: [phase for part in parts for phase in part["phases"]] for form, parts in forms.items()}
    called = {form: {id(f) for phase in own for f in phase["classes"]} for form, own in phases.items()}
    others = called[not dae] - called[dae]
    programs = [f for f in links.functions.values() if id(f) not in others]
    own = {
        "algorithms": forms[dae],
        "phases": phases[dae],
        "programs": programs,
        "routines": links.routines.called_by(f.program for f in programs),
        "accelerating": any(part["accelerating"] for part in forms[dae]),
    }
    return rendered("links.c", **project.context | own)
