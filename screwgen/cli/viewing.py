"""The command `view`: runs as a page that plays them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

ViewFile = Annotated[
    str | None, typer.Option(metavar="FILE", help="Also write a page that plays it, as .html.", show_default=False)
]


def view(
    context: typer.Context,
    runs: Annotated[
        list[str],
        typer.Argument(metavar="RUN...", help="run.npz; a second one is drawn as a ghost.", show_default=False),
    ],
    output: Annotated[
        str, typer.Option("-o", "--output", metavar="FILE", help="The page, run.html.", show_default=False)
    ],
    robot: Annotated[
        str | None,
        typer.Option(metavar="FILE", help="The robot file of runs that do not hold their robot.", show_default=False),
    ] = None,
    frames: Annotated[
        str | None, typer.Option(metavar="FILE", help="Not available: films are not written.", hidden=True)
    ] = None,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No progress and no summary.")] = False,
) -> None:
    """Write one HTML file that plays runs: the arm as it bends, energy, tip and torques. It needs no network."""
    from ..errors import UsageError
    from ..simulation.runs import check_output
    from ..viewer.page import SUFFIXES
    from ..viewer.view import MOST_RUNS, read_run
    from ..viewer.view import view as viewed
    from .output import busy, load_robot, say

    quiet = quiet or context.obj
    if frames is not None:
        raise UsageError("--frames: films are not written; record the page in a browser, or draw --plot of simulate")
    if len(runs) > MOST_RUNS:
        raise UsageError(f"there are {len(runs)} runs to view; give one, or two to have the second as a ghost")
    check_output(output, SUFFIXES)
    stated = None if robot is None else load_robot(robot, quiet)
    with busy("drawing", quiet):
        found = [read_run(path, stated) for path in runs]
        viewed(*found, labels=[Path(path).name for path in runs]).save(output)
    say(output, quiet)
