"""Where generated C computes a step: the function and its lines, found by the headings that the C's printer writes.

Every section of generated C has the title of its step as a comment, ``/* S_0: first moment, undeformed (27) */``, and
ends with an empty line. The page looks these headings up in the very text of the files, in the functions that the
printer made for the link.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from ...algorithms.scope import derived
from ...ir.lower import title
from ...topology.chain import Chain
from ...version import __version__
from ..c.project import CProject
from ..c.runs import RUNS
from ..numpy.reference import Case
from .steps import StepView

FUNCTION = re.compile(r"[A-Za-z_][^;={}]*?(\w+)\(")
"""The first line of a function's definition, which begins in the first column."""
HEADING = re.compile(r"\s+/\* ")
PREPARE, FUSED, OUTPUTS = "prepare", "joint_dynamics", "outputs"
CASADI = {
    FUSED: "forward_dynamics",
    "assembly": "assemble",
    "inverse": "inverse_dynamics",
    "measuring": "validity",
    "motion_of": "link_pose",
}
"""The function of CasADi that runs the same phases as a run of the C."""
SHOWN = 24
"""Of more lines than that only the first are shown: a page has hundreds of such pieces."""


@dataclass(frozen=True)
class CodeLines:
    """Lines of a C file, numbered from 1, of one function, with the heading that they begin with."""

    file: str
    function: str
    first: int
    last: int
    title: str
    text: tuple[str, ...]
    casadi: str = ""

    @property
    def shown(self) -> str:
        """The lines without their indentation, the first ones if they are many."""
        more = max(len(self.text) - SHOWN, 0)
        more = more if more > 1 else 0
        kept = [line.removeprefix("    ") for line in self.text[: len(self.text) - more]]
        return "\n".join([*kept, f"… {more} more lines"] if more else kept)


class Unchecked(CProject):
    """A project whose files have no self-check: its states take most of the time, and no step stands there."""

    @cached_property
    def check(self) -> dict[str, object]:
        return {}

    @property
    def reference(self) -> list[dict[str, list[str]]]:
        return []

    @property
    def _cases(self) -> list[Case]:
        return []


@dataclass(frozen=True)
class GeneratedC:
    """The lines of a robot's C by link and title; of functions that have the same title, of the one used most."""

    links: tuple[dict[str, CodeLines], ...]
    sections: tuple[tuple[CodeLines, ...], ...]
    """All sections of the functions of each link, those of the function used most last."""
    names: tuple[str, ...]
    """The links as identifiers of C."""
    titles: frozenset[str]
    """The titles of all steps."""

    def of_step(self, link: int, step: StepView) -> CodeLines | None:
        """The lines of a step of a link: the section of that title, or the lines that assign what has its name."""
        if (found := self.links[link].get(step_title(step))) is not None:
            return found
        assigned = re.compile(
            rf"\s*(?:const \w+ )?(?:\w+->)?{re.escape(step.name)}(?:_{self.names[link]})?"
            r"(?:_[a-z]{1,3}|_[xyz]?\d+|\[\d+\])? \+?= "
        )
        for lines in reversed(self.sections[link]):
            places = [k for k, line in enumerate(lines.text) if step.name in line and assigned.match(line)]
            if places:
                return _part(lines, places)
        return None

    def between(self, link: int, casadi: str) -> list[CodeLines]:
        """The sections of a function of CasADi that are no step's, in their order."""
        own = (lines for title, lines in self.links[link].items() if title not in self.titles)
        return sorted((x for x in own if x.casadi == casadi and x.title != OUTPUTS), key=lambda x: (x.file, x.first))


def step_title(step: StepView) -> str:
    """The title of a step's section, as the C's printer writes it."""
    return f"{step.name}: {step.meaning}" + (f" ({step.equation})" if step.equation else "")


def _part(lines: CodeLines, places: list[int]) -> CodeLines:
    """The lines from the first of some places as far as they follow each other."""
    last = places[0]
    for place in places[1:]:
        if place > last + 2:
            break
        last = place
    text = lines.text[places[0] : last + 1]
    first = lines.first + places[0]
    return replace(lines, first=first, last=first + len(text) - 1, text=text)


def generated(chain: Chain) -> GeneratedC:
    """What ``screwgen generate`` writes for the robot without options, with the lines of every step."""
    project = Unchecked(chain, __version__)
    sections: dict[str, dict[str, CodeLines]] = {}
    for file, template in project.library.items():
        if file.endswith(("_links.c", "_parameters.c", "_dynamics.c")):
            for lines in found(file, project.text(template)):
                sections.setdefault(lines.function, {}).setdefault(lines.title, lines)
    of_links = tuple(tuple(_of_link(project, sections, i)) for i in range(chain.n))
    by_title = tuple({lines.title: lines for lines in own} for own in of_links)
    steps = (step for key in chain.classes for block in derived(key).values() for step in block.steps.values())
    return GeneratedC(by_title, of_links, tuple(chain.identifiers), frozenset(map(title, steps)))


def _of_link(project: CProject, sections: Mapping[str, Mapping[str, CodeLines]], i: int) -> Iterator[CodeLines]:
    """The sections of a link, of those of functions by title; what comes later replaces what came before."""
    chain, functions = project.chain, _functions(project, i)
    prefixes = {name: "" for name, _ in functions} | ({_whole(project): f"{chain.identifiers[i]}, "})
    for function, run in [*functions, (_whole(project), FUSED), (_preparing(project, i), PREPARE)]:
        prefix = prefixes.get(function, "")
        for heading, lines in sections.get(function, {}).items():
            if heading.startswith(prefix):
                own = heading.removeprefix(prefix)
                yield replace(lines, title=own, casadi=CASADI.get(run, ""))


def _functions(project: CProject, i: int) -> list[tuple[str, str]]:
    """The functions of the phases of a link and what they call, with their runs: those of the joint form last."""
    order = sorted(project.links.runs, key=lambda run: list(RUNS).index(run), reverse=True)
    order.sort(key=lambda run: ("assembly", FUSED).index(run) if run in ("assembly", FUSED) else -1)
    out = []
    for run in order:
        for phase in project.links.phases(run):
            function = phase["classes"][phase["of_link"][i]]
            called = project.links.routines.called_by([function.program])
            out += [(name, run) for name in (*(routine.c_name for routine in called), function.name)]
    return out


def _whole(project: CProject) -> str:
    """The function that has the joint form of all links, in the fused layout."""
    return f"{project.name}_dynamics" if project.layout == "fused" else ""


def _preparing(project: CProject, i: int) -> str:
    """The function that prepares the constants of a link's class."""
    keys = project.seen.keys
    return f"constants_of_{project.seen.identifiers[keys.index(keys[i])]}"


def found(file: str, text: str) -> Iterator[CodeLines]:
    """The sections of a file of C that have a heading."""
    lines, function, number = text.split("\n"), "", 0
    while number < len(lines):
        line = lines[number]
        if (start := FUNCTION.match(line)) and not line.rstrip().endswith(";"):
            function = start[1]
        if HEADING.match(line) and function:
            heading, below = _heading(lines, number)
            last = below
            while last + 1 < len(lines) and lines[last + 1].strip() and lines[last + 1] != "}":
                last += 1
            if last > below:
                yield CodeLines(file, function, number + 1, last + 1, heading, tuple(lines[number : last + 1]))
            number = below
        number += 1


def _heading(lines: list[str], number: int) -> tuple[str, int]:
    """The text of a comment that begins in a line, and the line in which it ends."""
    last = number
    while "*/" not in lines[last]:
        last += 1
    whole = " ".join(line.strip().removeprefix("* ") for line in lines[number : last + 1])
    return whole.removeprefix("/* ").removesuffix("*/").strip(), last
