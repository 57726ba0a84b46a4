"""The command that makes a scheduled shaper."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

import typer

from .destinations import check_destination, write_c
from .options import Quiet, RobotFile


def register(app: typer.Typer, epilog: str) -> None:
    """Add the command to the command line."""
    app.command("shape", short_help="Find a shaper for references.", epilog=epilog)(shape)


def shape(
    context: typer.Context,
    robot: RobotFile,
    output: Annotated[str, typer.Option("-o", "--output", metavar="FILE", help="shaper.toml, or a folder.")],
    lower: Annotated[str, typer.Option("--from", metavar="Q,...", help="The least joint coordinates, rad or m.")],
    upper: Annotated[str, typer.Option("--to", metavar="Q,...", help="The largest joint coordinates.")],
    law: Annotated[
        str | None, typer.Option("--gains", metavar="FILE", help="The joint law. Without: joints follow exactly.")
    ] = None,
    free: Annotated[
        list[int] | None, typer.Option(metavar="JOINT", help="Without a law: a joint that no drive moves, from 0.")
    ] = None,
    payload: Annotated[
        str | None, typer.Option(metavar="NAME=LOW:HIGH", help="A parameter, and its least and largest value.")
    ] = None,
    kind: Annotated[str, typer.Option(metavar="zv|zvd|ei", help="The kind of shaper.")] = "zv",
    modes: Annotated[int, typer.Option(metavar="N", help="How many of the slowest motions.")] = 1,
    degree: Annotated[int, typer.Option(metavar="N", help="Of the polynomials.")] = 4,
    target: Annotated[
        str | None, typer.Option(metavar="c", help="Write the shaper as C, into the folder after -o.")
    ] = None,
    step: Annotated[float, typer.Option(metavar="S", help="Of the clock that runs the C.")] = 1e-3,
    quiet: Quiet = False,
) -> None:
    """Find what vibrates over postures and payloads, and write a shaper that follows it."""
    from ..model import derive
    from ..planning.shape import shape as made
    from ..planning.shaper_files import shaper_text
    from ..progress import busy
    from ..simulation.controller_files import read_pd
    from ..simulation.runs import outputs
    from .output import load_robot, say, stoppable
    from .stated_numbers import joint_coordinates

    quiet = quiet or context.obj
    check_destination(output, target, (".toml",), "a shaper")
    model = derive(load_robot(robot, quiet))
    low, high = (joint_coordinates(text, model, key) for key, text in (("from", lower), ("to", upper)))
    ways: dict[str, Any] = {"kind": kind, "modes": modes, "degree": degree, "free": free or ()}
    ways |= {"gains": None if law is None else read_pd(law, model), "payload": _payload(payload)}
    with busy("seeking what vibrates", quiet), stoppable():
        found = made(model, low, high, **ways)
    if law is not None:
        found = replace(found, law=os.path.relpath(law, Path(output).parent))
    if target is None:
        with outputs(output) as (stream,):
            stream.write(shaper_text(found).encode())
        files = [output]
    else:
        files = write_c(output, found.c(step))
    say("\n".join([*files, found.line]), quiet)


def _payload(text: str | None) -> tuple[str, float, float] | None:
    from ..errors import UsageError
    from ..spec.load import one_line

    if text is None:
        return None
    name, _, values = text.partition("=")
    try:
        low, high = map(float, values.split(":"))
    except ValueError:
        raise UsageError(f"--payload: is '{one_line(text)}'; write NAME=LOW:HIGH") from None
    return name.strip(), low, high
