"""The command `view`: runs as a page that plays them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .options import Quiet

if TYPE_CHECKING:
    from ..viewer.meshes import Looks


def view(
    context: typer.Context,
    runs: Annotated[list[str], typer.Argument(metavar="RUN...", help="run.npz; a second one is drawn as a ghost.")],
    output: Annotated[str | None, typer.Option("-o", "--output", metavar="FILE", help="The page, run.html.")] = None,
    robot: Annotated[
        str | None, typer.Option(metavar="FILE", help="The robot file of runs that do not hold their robot.")
    ] = None,
    meshes: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="The URDF of the robot, whose visuals are drawn; ROS_PACKAGE_PATH says where package:// lies.",
        ),
    ] = None,
    frames: Annotated[
        str | None, typer.Option(metavar="FILE", help="Write a film: run.gif, run.mp4, or a folder of .png.")
    ] = None,
    fps: Annotated[float | None, typer.Option(help="Frames per second of the film; 25.")] = None,
    size: Annotated[str | None, typer.Option(metavar="WxH", help="Pixels of the film; 800x600.")] = None,
    speed: Annotated[float | None, typer.Option(help="Seconds of the run in a second of the film; 1.")] = None,
    magnify: Annotated[float | None, typer.Option(help="Factor of the bending in the film; 1.")] = None,
    quiet: Quiet = False,
) -> None:
    """Write one HTML file that plays runs, the arm as it bends, energy, tip and torques; or a film of them."""
    from ..errors import UsageError
    from ..progress import bar, busy
    from ..simulation.runs import check_output
    from ..viewer.page import SUFFIXES
    from ..viewer.view import MOST_RUNS, read_run
    from ..viewer.view import view as viewed
    from .output import load_robot, notes, say

    quiet = quiet or context.obj
    if output is None and frames is None:
        raise UsageError("there is nothing to write; name the page by -o run.html, or a film by --frames run.gif")
    of_films: dict[str, Any] = {"fps": fps, "size": size, "speed": speed, "magnify": magnify}
    options = {name: value for name, value in of_films.items() if value is not None}
    if options and frames is None:
        name = next(iter(options))
        raise UsageError(f"--{name}: is of films; add --frames run.gif, or leave it out")
    if len(runs) > MOST_RUNS:
        raise UsageError(f"there are {len(runs)} runs to view; give one, or two to have the second as a ghost")
    if output is not None:
        check_output(output, SUFFIXES)
    stated = None if robot is None else load_robot(robot, quiet)
    looks = None if meshes is None else _looks(meshes, quiet)
    found, labels = [read_run(path, stated) for path in runs], [Path(path).name for path in runs]
    if frames is not None:
        from ..viewer.frames import film, read_size

        if size is not None:
            options["size"] = read_size(size)
        with bar("drawing", 1, quiet) as progress:
            film(*found, path=frames, labels=labels, **options, meshes=looks, progress=progress)
        say(frames, quiet)
    if output is not None:
        with busy("drawing", quiet):
            viewed(*found, labels=labels, meshes=looks).save(output)
        say(output, quiet)
        if looks:
            notes(output, [f"{Path(output).stat().st_size / 1e6:.1f} MB"], quiet)


def _looks(path: str, quiet: bool) -> Looks:
    """The visuals of a URDF, with notes on stderr on how much they are and what cannot be read."""
    from ..progress import busy
    from ..viewer.meshes import read_looks
    from .output import notes

    with busy("reading meshes", quiet):
        found = read_looks(path)
    notes(path, [f"{found.triangles} triangles of {found.count} visuals", *found.notes], quiet)
    return found
