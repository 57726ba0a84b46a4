"""The C of a functional mock-up unit: the robot's library, its answers' derivatives, and the functions of FMI."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from ...algorithms.response import POINT, Response
from ...algorithms.robot_functions import SENSED, SENSORS
from ...ir.program import Program
from ...spec.parameters import parameters
from ...topology.chain import Chain
from ..c.columns import written
from ..c.derivatives import LIMIT
from ..c.fields import fused_place
from ..c.pieces import piece_place, pieces
from ..c.project import CProject
from ..c.stumpff_slopes import slopes
from ..numpy.closing import OPENED, extent
from ..numpy.numeric import Numeric
from ..templates import folder, render
from .variables import METHOD, STEP, Variable, first_references, groups

HEADERS = {
    2: ("fmi2TypesPlatform.h", "fmi2FunctionTypes.h", "fmi2Functions.h"),
    3: ("fmi3PlatformTypes.h", "fmi3FunctionTypes.h", "fmi3Functions.h"),
}
"""The files of the standard, which are passed on as they are."""

TOKEN = "<token>"
POINTERS = ("c", "p", "state", "input", "x", "kept", "y")


def sources(project: CProject, version: int, variables: list[Variable], programs: dict) -> dict[str, str]:
    """The C files of a unit by name: the library of ``project`` and what FMI needs besides; ``programs``: `content`.

    In place of the token stands ``TOKEN``.
    """
    answers = programs["answers"]
    values = (
        project.context
        | programs
        | {
            "fmi": version,
            "token": TOKEN,
            "first": first_references(answers, variables),
            "count": len(variables),
            "groups": [name for name in groups(answers) if name not in SENSED or name in answers.rows],
            "default_step": repr(STEP),
            "default_method": list(project.methods).index(METHOD) + 1,
            "start": [repr(x.start) for x in variables if x.group == "q"],
            "nominals": [repr(x.nominal or 1.0) for x in variables if x.group in ("q", "v")],
            "n_parameters": len(parameters(project.chain.robot)) if project.baked is None else 0,
            "segment_names": project.chain.names,
            "opened": partial(_opened, project.chain),
        }
    )
    files = {f"{project.name}_response.{end}": f"response.{end}" for end in "hc"}
    files[f"fmu{version}.c"] = f"fmu{version}.c"
    made = {name: written(render(f"fmi/{file}.jinja", **values), project.name) for name, file in files.items()}
    given = {name: (folder() / "fmi" / "headers" / name).read_text(encoding="utf-8") for name in HEADERS[version]}
    return {**project.files(), **made, **given}


def _opened(chain: Chain) -> tuple[str, str]:
    """The mismatch of a loop, in m and rad, at which a unit stops, as C literals."""
    return f"{OPENED * extent(Numeric(chain), chain.home):.3g}", f"{OPENED:.3g}"


def content(project: CProject) -> dict:
    """The programs of :class:`...algorithms.response.Response` as the templates print them, of a project with outputs.

    Without derivatives, in ``derived``, where they would take too long to compile.
    """
    constants = "baked" if project.baked is not None else "constants"
    answers = Response(project.chain, SENSORS in project.reports)
    programs = {name: getattr(answers, name)(constants) for name in ("observation", "tangent", "adjoint")}
    derived = max(program.operation_count for program in programs.values()) <= LIMIT
    programs = programs if derived else {"observation": programs["observation"]}
    printed = {name: _printed(project, answers, program) for name, program in programs.items()}
    return {
        "derived": derived,
        "programs": printed,
        "answers": answers,
        "response": answers.sizes,
        "reports": answers.reports,
        "tips": project.chain.lasts,
        "slopes_of_stumpff": slopes(programs.values()),
    }


def _printed(project: CProject, answers: Response, program: Program) -> dict:
    fail = lambda test, link: f"if ({test}) {{ return $$_SINGULAR; }}"  # noqa: E731
    return pieces(program, piece_place(project.chain, "kept", _own(answers), fused_place), POINTERS, fail=fail)


def _own(answers: Response) -> dict[str, Callable[[int], str]]:
    """The places of directions and answers: their entries one after the other."""
    own: dict[str, Callable[[int], str]] = {"gravity": lambda k: f"c->gravity[{k}]"}
    parts = {"q": "state", "v": "state", "tau": "input", "w_ext": "input"}
    for names, along, against in ((POINT, "x", "y"), (answers.answers, "y", "x")):
        first = 0
        for name in names:
            own[f"d_{name}"] = partial(_entry, along, first)
            own[f"b_{name}"] = partial(_entry, against, first)
            if name not in parts:
                own[name] = partial(_entry, "y", first)
            first += answers.sizes[name]
    return own


def _entry(array: str, first: int, k: int) -> str:
    return f"{array}[{first + k}]"
