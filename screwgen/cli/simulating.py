"""The work of the command `simulate`: a run, its pictures, and what remains of a run that fails."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any, BinaryIO

from ..errors import ScrewgenError, UsageError
from ..model import Model, derive
from ..progress import bar, busy
from ..simulation.state import state_in
from ..spec.load import one_line
from .commands import check_choice
from .output import load_robot, say, stoppable


def run_simulate(
    robot: str,
    duration: float,
    step: float,
    output: str,
    acting: tuple[str | None, str | None, str | None],
    form: str,
    integrator: str | None,
    drawn: tuple[str | None, str | None, Sequence[str]],
    every: int,
    keep: bool,
    quiet: bool,
) -> None:
    """Simulate and store; the run and its pictures appear together or not at all, unless a stopped run is kept.

    `acting`: the files of --state, --controller and --motion; `drawn`: those of --plot and --view, and the words of
    --panel. What a run that fails had until then is in `run.failed.npz`, and so on.
    """
    from ..simulation.hits import lines
    from ..simulation.motion_table import read_motion
    from ..simulation.named_controllers import read_controller
    from ..simulation.runs import FORMATS, check_output, failed_name, outputs
    from ..simulation.simulate import FORMS as known_forms
    from ..simulation.simulate import simulate, step_count

    (state, controller, motion), (*pictures, only) = acting, drawn
    if only and pictures[0] is None:
        raise UsageError("--panel: is given without --plot, whose panels it chooses; give both, or none")
    check_output(output, FORMATS)
    check_choice("--form", form, known_forms)
    for path, end in zip(pictures, (".png", ".html"), strict=True):
        if path is not None:
            check_output(path, (end,))
    steps = step_count(duration, step)
    model = derive(load_robot(robot, quiet))
    start = state_in(state, model)
    torque = read_controller(controller, model) if controller is not None else start.tau
    if controller is not None and start.tau.any():
        raise UsageError(f"{state}: tau: is given beside --controller; leave one of them out")
    ways: dict[str, Any] = {"integrator": integrator, "form": form, "every": every, "store": output if keep else None}
    ways["motion"] = read_motion(motion, model) if motion is not None else None
    wanted = (None if keep else output, *pictures)
    try:
        with outputs(*filter(None, wanted)) as streams:
            with bar("simulating", steps, quiet) as progress, stoppable():
                q0 = start.q if state is not None else None
                run = simulate(model, duration, step, q0, start.v, torque, start.w_ext, progress=progress, **ways)
            with busy("drawing", quiet):
                _write((run, model, torque, output), wanted, streams, only)
    except ScrewgenError as error:
        if error.run is None:
            raise
        failed = [None if path is None else failed_name(path) for path in (output, *pictures)]
        with outputs(*filter(None, failed)) as streams:
            _write((error.run, model, torque, failed_name(output)), failed, streams, only)
        raise type(error)(f"{error}; {one_line(', '.join(filter(None, failed)))}: the run until then") from None
    say("\n".join(filter(None, (output, *pictures, *lines(run.hits)))), quiet)


def _write(
    made: tuple[Any, Model, Any, str], paths: Sequence[str | None], streams: Iterable[BinaryIO], only: Sequence[str]
) -> None:
    """Write a run, its plot and its page, as far as they have a path; `made`: run, model, torques, and its file."""
    run, model, torque, name = made
    drawn, viewed = (lambda: _drawn(run, model, torque, only)), (lambda: _viewed(run, model, torque, name))
    writers: tuple[Callable[[], bytes], ...] = (drawn, viewed)
    each = iter(streams)
    if paths[0] is not None:
        run.write(next(each), name)
    for path, picture in zip(paths[1:], writers, strict=True):
        if path is not None:
            next(each).write(picture())


def _drawn(run: Any, model: Model, torque: Any, only: Sequence[str]) -> bytes:
    from ..plotting.plot import png

    return png(run, model, torque, only)


def _viewed(run: Any, model: Model, torque: Any, name: str) -> bytes:
    from ..plotting.demands import set_points
    from ..viewer.page import run_page

    return run_page([(run, model, Path(name).name)], goals=set_points(run, model, torque)).html.encode()
