"""The command `gains`: gains of the joints, or a law with its filter over a grid, as a controller's file."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Annotated, Any

import typer

from .destinations import check_destination, write_c
from .options import Quiet, RobotFile

Postures = Annotated[
    list[str] | None,
    typer.Option(
        "--at", metavar="Q,...", help="A posture of the joints, rad or m; may be given again. Zero, if not given."
    ),
]
Factors = Annotated[
    list[str] | None,
    typer.Option(
        "--model",
        metavar="PATTERN=FACTOR,...",
        help="A further model by factors of its parameters, as '*.bodies[0].mass=1.3'; may be given again.",
    ),
]
Bounds = Annotated[
    list[str] | None,
    typer.Option(
        "--bound",
        metavar="KEY=X,...",
        help="decay or damping wanted; per joint the largest kp, kd, ki; a jump of references and the largest efforts "
        "after it; noise_q, noise_v of sensors and the largest noise_efforts. May be given again.",
    ),
]
Grids = Annotated[
    list[str] | None,
    typer.Option(
        metavar="NAME=X,...",
        help="Values of a scheduling variable: a joint coordinate, or a pattern of parameters with their factors; may "
        "be given again.",
    ),
]


def register(app: typer.Typer, epilog: str) -> None:
    """Add the command to the command line."""
    app.command("gains", short_help="Find gains of the joints.", epilog=epilog)(gains)


def gains(
    context: typer.Context,
    robot: RobotFile,
    output: Annotated[
        str, typer.Option("-o", "--output", metavar="FILE", help="gains.toml, of --lqg gains.npz; or a folder.")
    ],
    at: Postures = None,
    model: Factors = None,
    integral: Annotated[bool, typer.Option("--integral", help="Also sum up what joints lack, with gains ki.")] = False,
    bound: Bounds = None,
    lqg: Annotated[bool, typer.Option("--lqg", help="A linear-quadratic law with filter over a --grid.")] = False,
    grid: Grids = None,
    target: Annotated[
        str | None, typer.Option(metavar="c", help="Write the law as C, into the folder after -o.")
    ] = None,
    step: Annotated[float, typer.Option(metavar="S", help="Between the samples of the clock.")] = 1e-3,
    quiet: Quiet = False,
) -> None:
    """Write joint gains under which what is slowest decays fastest, and print the figures of the sampled loop."""
    from ..errors import UsageError
    from ..model import derive
    from ..planning.joint_gains import gains as found_gains
    from ..progress import busy
    from ..simulation.runs import outputs
    from .output import load_robot, say, stoppable
    from .stated_numbers import joint_coordinates

    quiet = quiet or context.obj
    models, bounds = [_factors(text) for text in model or []], dict(map(_bound, bound or []))
    if lqg:
        _write_lqg(robot, output, target, (at or [], models, bounds, grid or []), step, quiet)
        return
    if grid:
        raise UsageError("--grid: is that of a law with a filter; add --lqg, or leave it out")
    check_destination(output, target, (".toml",), "a law")
    arm = derive(load_robot(robot, quiet))
    postures = [joint_coordinates(text, arm, "at") for text in at or ["0 " * arm.chain.n_redundant]]
    with nullcontext([None]) if target else outputs(output) as (stream,):
        with busy("seeking gains", quiet), stoppable():
            law = found_gains(arm, postures, models=models, step=step, integral=integral, bounds=bounds)
        stated = {"kp": law.kp, "kd": law.kd, "ki": law.ki, "q_des": postures[0]}
        rows = [f"# {line}\n" for line in law.lines]
        rows += [f"{name} = {values.tolist()}\n" for name, values in stated.items() if values is not None]
        if stream is not None:
            stream.write("".join(rows).encode())
    files = [output] if target is None else write_c(output, law.c())
    say("\n".join([*files, *law.lines]), quiet)


def _write_lqg(
    robot: str, output: str, target: str | None, asked: tuple[Any, Any, Any, Any], step: float, quiet: bool
) -> None:
    """Find a law with its filter and write it; `asked`: postures, models, bounds and grid of the command line."""
    from ..errors import UsageError
    from ..model import derive
    from ..planning.lqg_files import write_lqg
    from ..planning.lqg_make import lqg as found_lqg
    from ..progress import busy
    from ..simulation.runs import outputs
    from .output import load_robot, say, stoppable
    from .stated_numbers import joint_coordinates

    at, models, bounds, grid = asked
    if set(bounds) - {"efforts"}:
        raise UsageError(
            f"--bound: of a law with a filter there is efforts alone, not {min(set(bounds) - {'efforts'})}"
        )
    if not grid:
        raise UsageError("--grid: is missing; give names with values, as 'arm.joint[0]=-1,0,1'")
    check_destination(output, target, (".npz", ".toml") if target else (".npz",), "a law")
    arm = derive(load_robot(robot, quiet))
    postures = [joint_coordinates(text, arm, "at") for text in at]
    over = dict(map(_values, grid))
    with nullcontext([None]) if target else outputs(output) as (stream,):
        with busy("seeking a law", quiet), stoppable():
            law = found_lqg(arm, over, postures=postures, models=models, step=step, efforts=bounds.get("efforts"))
        if stream is not None:
            write_lqg(law, stream)
    files = [output] if target is None else write_c(output, law.c())
    say("\n".join([*files, *law.lines]), quiet)


def _values(text: str) -> tuple[str, list[float]]:
    """Values of a grid by the name of their variable."""
    name, values = _split("--grid", text)
    return name, [_number("--grid", text, x) for x in values.split(",")]


def _factors(text: str) -> dict[str, float]:
    """Factors of parameters by names or patterns."""
    pairs = [_split("--model", part) for part in text.split(",")]
    return {name: _number("--model", text, x) for name, x in pairs}


def _bound(text: str) -> tuple[str, Any]:
    """A bound by its name: a number, or one for each joint."""
    from ..planning.gain_bounds import SCALARS

    name, values = _split("--bound", text)
    found = [_number("--bound", text, x) for x in values.split(",")]
    return name, found[0] if name in SCALARS and len(found) == 1 else found


def _split(option: str, text: str) -> tuple[str, str]:
    from ..errors import UsageError
    from ..spec.load import one_line

    name, sign, value = text.rpartition("=")
    if not (sign and name.strip() and value.strip()):
        raise UsageError(f"{option}: '{one_line(text)}' is no NAME=NUMBER; write a name, = and a number")
    return name.strip(), value.strip()


def _number(option: str, text: str, word: str) -> float:
    from ..errors import UsageError
    from ..spec.load import one_line

    try:
        return float(word)
    except ValueError:
        raise UsageError(f"{option}: '{one_line(text)}' has '{one_line(word)}', which is no number") from None
