"""The command that runs a robot: its options and help."""

from __future__ import annotations

from typing import Annotated

import typer

from .options import Form, Quiet, RobotFile, StateFile, ViewFile


def register(app: typer.Typer, epilog: str) -> None:
    """Add the command to the command line."""
    app.command("simulate", short_help="Simulate and store the run.", epilog=epilog)(simulate)


def simulate(
    context: typer.Context,
    robot: RobotFile,
    duration: Annotated[float, typer.Option(metavar="S", help="How long, in seconds.")],
    step: Annotated[float, typer.Option(metavar="S", help="The time step in seconds; the last may be shorter.")],
    output: Annotated[str, typer.Option("-o", "--output", metavar="FILE", help="run.npz or run.csv.")],
    state: StateFile = None,
    controller: Annotated[
        str | None,
        typer.Option(
            metavar="KIND:FILE",
            help="pd:gains.toml: kp, kd, q_des or waypoints, duration, tau_max, gravity. "
            "lqg:law.npz. plan:plan.npz. feedforward:gains.toml: with the efforts of its path. shaper:shaper.toml. "
            "csv:inputs.csv: t, torques and tensions by name, over time. Without: the state's tau.",
        ),
    ] = None,
    motion: Annotated[
        str | None,
        typer.Option(metavar="FILE", help="motion.csv: t, and by name the coordinates of given axes or a moving base."),
    ] = None,
    form: Form = "joint",
    integrator: Annotated[
        str | None,
        typer.Option(
            metavar="NAME", help="Joint form: euler, semi_implicit, modal_implicit, modal_midpoint (its default), rk4."
        ),
    ] = None,
    plot: Annotated[str | None, typer.Option(metavar="FILE", help="Also draw the run, as .png.")] = None,
    panel: Annotated[
        list[str] | None,
        typer.Option(metavar="WORD", help="Of --plot only panels with WORD in their title; may be given again."),
    ] = None,
    view: ViewFile = None,
    every: Annotated[int, typer.Option(metavar="N", min=1, help="Store every N-th step, and the end.")] = 1,
    keep: Annotated[
        bool, typer.Option("--keep", help="Store while it runs: a stopped run leaves run.part.npy or run.part.csv.")
    ] = False,
    quiet: Quiet = False,
) -> None:
    """Simulate the robot and store t, q, v, tau, wrench, tip_position and energy at every step."""
    from .simulating import run_simulate

    quiet, pictures = quiet or context.obj, (plot, view, panel or [])
    acting = state, controller, motion
    run_simulate(robot, duration, step, output, acting, form, integrator, pictures, every, keep, quiet)
