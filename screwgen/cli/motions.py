"""The commands for motions that end at rest: plan and track."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..errors import UsageError, one_line
from .destinations import C, check_destination, write_c
from .options import Quiet, RobotFile

if TYPE_CHECKING:
    from ..planning.plan import MotionPlan
    from ..robot_model import RobotModel

FORMATS = (".npz", ".csv")
"""Of files of plans."""
PlanOutput = Annotated[str, typer.Option("-o", "--output", metavar="FILE", help="plan.npz, plan.csv, or a folder.")]
PlanTarget = Annotated[str | None, typer.Option(metavar="c", help="Write the plan as C, into the folder after -o.")]
RowStep = Annotated[float, typer.Option(metavar="S", help="Between the rows of a .csv file.")]
PlanReportFile = Annotated[
    str | None,
    typer.Option("--report", metavar="FILE", help="Also a report, .html: what is left, limits, wrong payloads."),
]


def register(app: typer.Typer, epilog: str) -> None:
    """Add the commands to the command line."""
    app.command("plan", short_help="Plan a motion that ends at rest.", epilog=epilog)(plan)
    app.command("track", short_help="Plan a motion whose tip is on a path.", epilog=epilog)(track)


def plan(
    context: typer.Context,
    robot: RobotFile,
    task: Annotated[str, typer.Argument(metavar="PLAN", help="What is to be planned, TOML.")],
    output: PlanOutput,
    target: PlanTarget = None,
    step: RowStep = 1e-3,
    fast: Annotated[
        bool, typer.Option("--fast", help="Polynomials by least squares: limits are checked, not sought with.")
    ] = False,
    report: PlanReportFile = None,
    quiet: Quiet = False,
) -> None:
    """Plan a motion of the joints from rest to rest that leaves nothing vibrating, with its torques."""
    from ..model import derive
    from ..planning.make import plan as made
    from ..planning.tip_goals import inverse_kinematics
    from ..progress import bar
    from ..simulation.controller_files import read_pd
    from ..spec.plan import PlanFile, read_task
    from .output import load_robot, say, stoppable
    from .stated_numbers import note_degrees

    quiet = quiet or context.obj
    check_destination(output, target, FORMATS, "a plan")
    _check_report(report)
    model = derive(load_robot(robot, quiet))
    asked, law = read_task(task)
    for key, joints in (("start", asked.start), ("goal", asked.goal or ())):
        note_degrees(joints, model, f"{one_line(task)}: {key}")
    ways: dict[str, Any] = {"intervals": asked.intervals, "models": asked.models, "through": asked.through}
    ways["limits"] = {key: x for key, x in asked.limits.model_dump().items() if x is not None}
    ways["gains"] = None if law is None else read_pd(law, model)
    keys = {x: x for x in PlanFile.model_fields} | {"tip": "goal_tip", "near": "start"}
    with _in_file(task, keys):
        goal = asked.goal or inverse_kinematics(model, asked.goal_tip or (), asked.start)
    with _reported(report) as page, stoppable(), _in_file(task, keys):
        with destination(output, target, step) as write:
            with bar("planning", 80, quiet) as progress:
                found = made(model, asked.start, goal, asked.time, **ways, fast=fast, progress=progress)
            files = write(found)
        files += page(model, found, quiet, models=ways["models"], limits=ways["limits"])
    figures = f"{found.time:.4g} s, {found.said['iterations']} iterations, torques up to {found.effort.max():.4g}"
    say("\n".join([*files, figures + _bare(found)]), quiet)


def track(
    context: typer.Context,
    robot: RobotFile,
    path: Annotated[
        str, typer.Argument(metavar="PATH", help="Where the tip is to be: a .csv of t, x, y, z, or a shape, TOML.")
    ],
    output: PlanOutput,
    target: PlanTarget = None,
    near: Annotated[
        str | None,
        typer.Option(metavar="Q,...", help="Joints from where the posture of the start is sought, rad or m."),
    ] = None,
    law: Annotated[
        str | None, typer.Option("--gains", metavar="FILE", help="The joint law under which the plan is played.")
    ] = None,
    preview: Annotated[
        float, typer.Option(metavar="S", help="How much earlier joints begin, and later end, than the tip.")
    ] = 0.1,
    spacing: Annotated[float, typer.Option(metavar="S", help="Between the points of the plan.")] = 1e-3,
    step: RowStep = 1e-3,
    report: PlanReportFile = None,
    quiet: Quiet = False,
) -> None:
    """Plan the motion of the joints, with its torques, in which the tip of the bent arm is on a path."""
    from ..model import derive
    from ..planning.track import track as made
    from ..progress import bar
    from ..simulation.controller_files import read_pd
    from ..simulation.path_table import read_path
    from .output import load_robot, say, stoppable
    from .stated_numbers import joint_coordinates, note_angle

    quiet = quiet or context.obj
    check_destination(output, target, FORMATS, "a plan")
    _check_report(report)
    asked, model = read_path(path), derive(load_robot(robot, quiet))
    note_angle(asked.turn, "angle", f"{one_line(path)}: circle")
    ways: dict[str, Any] = {"preview": preview, "step": spacing, "gains": None if law is None else read_pd(law, model)}
    ways["near"] = None if near is None else joint_coordinates(near, model, "near")
    with _reported(report) as page, stoppable(), _in_file(path, {"path": "path"}):
        with destination(output, target, step) as write:
            with bar("planning", 15, quiet) as progress:
                found = made(model, asked, asked.time, **ways, progress=progress)
            files = write(found)
        files += page(model, found, quiet, path=lambda t: asked(t - preview))
    say("\n".join([*files, *_followed(found)]), quiet)


@contextmanager
def _in_file(file: str, keys: Mapping[str, str]) -> Iterator[None]:
    """Put the name of a file before faults of what it states; `keys`: its keys by words that faults begin with."""
    try:
        yield
    except UsageError as error:
        word, colon, rest = str(error).partition(":")
        name, bracket, index = word.partition("[")
        if not colon or name not in keys:
            raise
        raise UsageError(f"{one_line(file)}: {keys[name]}{bracket}{index}:{rest}") from None


def _followed(found: MotionPlan) -> list[str]:
    """What a plan of a path does, in lines: a table of its joints."""
    said = found.said
    begun = f"{found.time:.4g} s, {said['preview']:.4g} s of it before the tip moves and as much after; "
    lines = [
        f"{begun}{said['iterations']} iterations{_bare(found)}",
        f"tip off its path by {said['off']:.2g} m at most",
    ]
    lines.append(f"  {'joint':27}" + "".join(f"{head:>12}" for head in ("least", "largest", "rate", "effort", "limit")))
    reached = (found.q.min(axis=0), found.q.max(axis=0), abs(found.v).max(axis=0), found.effort)
    for name, *sizes, most in zip(found.joints, *reached, found.tau_max, strict=True):
        limit = "none" if most == float("inf") else f"{most:.4g}"
        lines.append(f"  {name:27}" + "".join(f"{x:>12.4g}" for x in sizes) + f"{limit:>12}")
    return lines


def _bare(found: MotionPlan) -> str:
    """What is missing where a plan has no law."""
    return "" if found.kp.any() else "; without gains nothing corrects what the model does not know"


def _check_report(report: str | None) -> None:
    """Refuses the name of a file that is no page."""
    from ..simulation.runs import check_output

    if report is not None:
        check_output(report, (".html",))


@contextmanager
def _reported(report: str | None) -> Iterator[Callable[..., list[str]]]:
    """What writes the report of a plan, if one is asked for, and names its file, which is opened before.

    The plan itself is written first: it is kept where its runs go wrong.
    """
    from ..simulation.runs import outputs

    def write(model: RobotModel, found: MotionPlan, quiet: bool, **ways: Any) -> list[str]:
        from ..plotting.plan_report import plan_report
        from ..progress import bar

        for page in pages:
            with bar("playing", 1, quiet) as progress:
                page.write(plan_report(model, found, **ways, progress=progress).html().encode())
        return beside

    beside = [] if report is None else [report]
    with outputs(*beside) as pages:
        yield write


@contextmanager
def destination(output: str, target: str | None, step: float) -> Iterator[Callable[[MotionPlan], list[str]]]:
    """What writes a plan and names the files; a file is opened before the plan is sought."""
    from ..planning.plan_files import write_csv, write_npz
    from ..simulation.runs import outputs, suffix

    def folder(plan: MotionPlan) -> list[str]:
        return write_c(output, plan.c())

    def file(plan: MotionPlan) -> list[str]:
        if suffix(output) == ".csv":
            write_csv(plan, stream, step)
        else:
            write_npz(plan, stream)
        return [output]

    if target == C:
        yield folder
    else:
        with outputs(output) as (stream,):
            yield file
