"""Arguments and options that several commands have."""

from __future__ import annotations

from typing import Annotated

import typer

RobotFile = Annotated[str, typer.Argument(metavar="ROBOT", help="The robot file, TOML.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="No progress and no summary.")]
NoNotes = Annotated[bool, typer.Option("--quiet", "-q", help="No notes and no summary.")]
StateFile = Annotated[
    str | None,
    typer.Option(
        "--state",
        metavar="FILE",
        help="JSON of q, v, tau, w_ext; zero where left out. What equilibrium prints with --json is one.",
    ),
]
Form = Annotated[str, typer.Option(metavar="NAME", help="joint or dae.")]
Json = Annotated[bool, typer.Option("--json", help="Print the numbers as JSON.")]
ViewFile = Annotated[str | None, typer.Option(metavar="FILE", help="Also write a page that plays it, as .html.")]
