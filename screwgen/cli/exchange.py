"""Commands that bring robots in from other tools and out to them: import and export."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import Annotated

import typer

from .options import NoNotes, RobotFile


def register(app: typer.Typer, epilog: str) -> None:
    """Add the commands to the command line."""
    app.command("import", short_help="Make a robot file from a URDF.", epilog=epilog)(import_)
    app.command("export", short_help="Write a rigid URDF for viewers.", epilog=epilog)(export)


def import_(
    context: typer.Context,
    urdf: Annotated[str, typer.Argument(metavar="URDF", help="The URDF.")],
    output: Annotated[str, typer.Option("-o", "--output", metavar="FILE", help="The robot file, robot.toml.")],
    flexible: Annotated[
        str | None, typer.Option(metavar="FILE", help="Which links are flexible: TOML with keys of a robot file.")
    ] = None,
    keep_fixed: Annotated[
        bool, typer.Option("--keep-fixed", help="Keep fixed joints as welded links, instead of merging them.")
    ] = False,
    floating: Annotated[
        bool, typer.Option("--floating", help="The root link floats, instead of being the world.")
    ] = False,
    mimic: Annotated[
        str, typer.Option(metavar="HOW", help="Joints that mimic others: couple, free (both move), weld or refuse.")
    ] = "couple",
    tip: Annotated[
        str | None, typer.Option(metavar="LINK", help="The link that comes last, though it be fixed: the tip.")
    ] = None,
    nearest_inertia: Annotated[
        bool, typer.Option("--nearest-inertia", help="Replace inertias that no body has by the nearest that one has.")
    ] = False,
    density: Annotated[
        float | None, typer.Option(metavar="KG/M3", help="Links without an inertial weigh what their shapes do.")
    ] = None,
    total_mass: Annotated[
        float | None,
        typer.Option("--total-mass", metavar="KG", help="As --density, of all links of the URDF together."),
    ] = None,
    quiet: NoNotes = False,
) -> None:
    """Write the robot file of a URDF. What is left out or changed is said on stderr and in the file's header."""
    from ..interchange.load import import_urdf
    from ..interchange.tree import Options
    from ..model import derive
    from ..simulation.runs import check_output, outputs
    from ..studies.light_joints import light_joints
    from .output import notes, say

    check_output(output, (".toml",))
    options = Options(keep_fixed, floating, mimic, tip, nearest_inertia, density, total_mass)
    found = import_urdf(urdf, flexible, options)
    found = replace(found, notes=(*found.notes, *light_joints(derive(found.robot))))
    with outputs(output) as (stream,):
        stream.write(found.text(os.path.dirname(os.path.abspath(output))).encode())
    quiet = quiet or context.obj
    notes(urdf, found.notes, quiet)
    say(f"{output}\n{found.summary()}", quiet)


def export(
    context: typer.Context,
    robot: RobotFile,
    output: Annotated[str, typer.Option("-o", "--output", metavar="FILE", help="The URDF, robot.urdf.")],
    quiet: NoNotes = False,
) -> None:
    """Write a robot as a URDF of rigid links, for viewers and other tools; what it leaves out is said on stderr."""
    from ..interchange.urdf_write import export_urdf
    from ..progress import busy
    from ..simulation.runs import check_output, outputs
    from ..spec.load import one_line
    from .output import load_robot, notes, say

    check_output(output, (".urdf",))
    quiet = quiet or context.obj
    loaded = load_robot(robot, quiet)
    with busy("writing", quiet):
        found = export_urdf(loaded, one_line(robot))
    with outputs(output) as (stream,):
        stream.write(found.text.encode())
    notes(robot, found.notes, quiet)
    say(output, quiet)
