"""The commands `identify`, from logs to a robot file with identified numbers, and `excite`, a motion for such logs."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from .options import Quiet, RobotFile


def register(app: typer.Typer, epilog: str) -> None:
    """Add the commands to the command line."""
    app.command("identify", short_help="Identify a robot's numbers from logs.", epilog=epilog)(identify)
    app.command("excite", short_help="Find a motion that tells a robot's numbers.", epilog=epilog)(excite)


def identify(
    context: typer.Context,
    robot: Annotated[str, typer.Argument(metavar="ROBOT", help="The robot file, TOML: where the search starts.")],
    output: Annotated[str, typer.Option("-o", "--output", metavar="FILE", help="The identified robot file, .toml.")],
    free: Annotated[
        list[str],
        typer.Option(
            metavar="PATTERN",
            help="What is free, as arm.EIz or gauge.offset, * is any text; 'arm.EIz = 2 ± 0.3' is a prior, "
            "'arm.EIz in 1..3' has bounds, '*.profile.E together' is one number; may be given again.",
        ),
    ],
    logs: Annotated[
        list[str] | None,
        typer.Argument(metavar="LOG...", help="Logs, CSV or npz; log.csv@0:10 is a part, in seconds, or in rows."),
    ] = None,
    sensors: Annotated[
        str | None, typer.Option(metavar="FILE", help="What the columns are, TOML. Without: named as in runs.")
    ] = None,
    sensors_output: Annotated[
        str | None, typer.Option(metavar="FILE", help="Also the table of columns with identified numbers, .toml.")
    ] = None,
    check: Annotated[
        list[str] | None, typer.Option(metavar="LOG", help="A log that is held out; may be given again.")
    ] = None,
    vibrations: Annotated[
        str | None, typer.Option(metavar="FILE", help="Measured natural frequencies and damping ratios, TOML.")
    ] = None,
    report: Annotated[
        str | None, typer.Option(metavar="FILE", help="Also a report, .html, and its numbers beside it, .json.")
    ] = None,
    window: Annotated[float, typer.Option(metavar="S", help="About how long windows are, in seconds.")] = 1.0,
    substeps: Annotated[int, typer.Option(metavar="N", min=1, help="Steps of a motion per sample of the log.")] = 1,
    integrator: Annotated[
        str, typer.Option(metavar="NAME", help="Of motions: modal_midpoint, modal_implicit, semi_implicit, rk4.")
    ] = "modal_midpoint",
    robust: Annotated[bool, typer.Option("--robust", help="Count outliers by their size, not by its square.")] = False,
    iterations: Annotated[int, typer.Option(metavar="N", min=1, help="Iterations at most.")] = 40,
    quiet: Quiet = False,
) -> None:
    """Identify numbers of a robot, its sensors and inputs from logs, and write its file anew with them: comments stay,
    intervals stand behind the numbers. What is odd of logs and fit is said on stderr. Ctrl-C keeps the best so far.
    """
    from ..identification.file_numbers import file_numbers
    from ..identification.identify import identify as identified
    from ..identification.robot_text import check_stated
    from ..identification.unknowns import free_parameters
    from ..model import derive
    from ..progress import told
    from ..simulation.runs import check_output, outputs
    from .output import load_robot, notes, say

    check_output(output, (".toml",))
    if sensors_output is not None:
        check_output(sensors_output, (".toml",))
    if report is not None:
        check_output(report, (".html",))
    quiet = quiet or context.obj
    model = derive(load_robot(robot, quiet))
    check_stated(robot, free_parameters(model, free, file_numbers(robot, model)))
    more: dict[str, Any] = {"sensors": sensors, "held_out": check or (), "window": window, "substeps": substeps}
    more |= {
        "vibrations": vibrations,
        "robot_file": robot,
        "integrator": integrator,
        "robust": robust,
        "iterations": iterations,
    }
    with told("identifying", quiet) as progress:
        found = identified(model, logs or (), free=free, progress=progress, **more)
    texts = {output: found.robot_text(robot)}
    if sensors_output is not None:
        texts[sensors_output] = found.sensors_text()
    if report is not None:
        texts |= {report: found.report(), str(Path(report).with_suffix(".json")): found.to_json()}
    with outputs(*texts) as streams:
        for stream, text in zip(streams, texts.values(), strict=True):
            stream.write(text.encode())
    notes(robot, (*(f"undetermined: {line}" for line in found.undetermined), *found.notes), quiet=False)
    say("\n".join([*texts, found.summary(notes=False)]), quiet)
    sys.stdout.flush()


def excite(
    context: typer.Context,
    robot: RobotFile,
    output: Annotated[
        str, typer.Option("-o", "--output", metavar="FILE", help="motion.csv, the inputs, or motion.npz, a plan.")
    ],
    limits: Annotated[
        str, typer.Option(metavar="FILE", help="What is sought, how it is measured, and limits of the motion, TOML.")
    ],
    generations: Annotated[int, typer.Option(metavar="N", min=0, help="Rounds of the search at most.")] = 40,
    seed: Annotated[int, typer.Option(metavar="N", min=0, help="Of the random motions and of the search.")] = 0,
    quiet: Quiet = False,
) -> None:
    """Find a motion of the joints within limits whose log makes best known what is known worst, run it on the model,
    and print the intervals that a fit is to have, beside those of a random motion of equal limits and time. Ctrl-C ends
    the search with the best so far.
    """
    from ..identification.excitation import FORMATS
    from ..identification.excite import excite as found_motion
    from ..model import derive
    from ..progress import told
    from ..simulation.controller_files import read_pd
    from ..simulation.runs import check_output, outputs
    from ..spec.excitation import read_excitation
    from .output import load_robot, notes, say

    check_output(output, FORMATS)
    asked = read_excitation(limits)
    quiet = quiet or context.obj
    model = derive(load_robot(robot, quiet))
    stated = asked.model_dump(exclude_none=True)
    more: dict[str, Any] = {key: stated.pop(key) for key in ("lower", "upper", "rates", "efforts") if key in stated}
    if asked.gains is not None:
        stated["gains"] = read_pd(asked.gains, model)
    with outputs(output) as (stream,):
        with told("exciting", quiet) as progress:
            found = found_motion(model, limits=more, generations=generations, seed=seed, progress=progress, **stated)
        found.write(stream, output)
    notes(robot, (*(f"undetermined: {line}" for line in found.undetermined), *found.notes), quiet=False)
    say(f"{output}\n{found.summary()}", quiet)
    sys.stdout.flush()
