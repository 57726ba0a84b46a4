"""The command line: options, help texts and exit status. The work is done in `commands`.

Exit status: 0 done; 2 a request that cannot be met, nothing written; 1 a computation that failed: a singular
posture, a method that diverged; 130 interrupted. Errors are one line on stderr. Heavy modules are imported by
the commands that need them, so that help is quick.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from copy import copy
from typing import Annotated

import typer
from typer.core import TyperGroup

from ..errors import ScrewgenError, UsageError
from ..plugins import declared, plugins
from . import exchange, gaining, identifying, motions, running, shaping
from .options import Form, Json, Quiet, RobotFile, StateFile, ViewFile
from .process import guarded, prepare
from .viewing import view

EPILOG = (
    "Exit status: 0 done; 2 a request that cannot be met (one line says why, nothing is written); "
    "1 a computation that failed, such as a singular posture; 130 interrupted."
)
app = typer.Typer(name="screwgen", rich_markup_mode=None, pretty_exceptions_enable=False, epilog=EPILOG)


def _version(asked: bool) -> None:
    if asked:
        from .. import __version__

        typer.echo(f"screwgen {__version__}")
        raise typer.Exit()


@app.callback(no_args_is_help=False)
def screwgen(
    context: typer.Context,
    quiet: Quiet = False,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    """Equations of motion of flexible robot arms, derived once: as CasADi functions, standalone C and LaTeX."""
    context.obj = quiet


@app.command(short_help="Write a folder of generated code.", epilog=EPILOG)
def generate(
    context: typer.Context,
    robot: RobotFile,
    output: Annotated[str, typer.Option("-o", "--output", metavar="DIR", help="The folder to write.")],
    target: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME", help="c, casadi, latex, fmu2, fmu3, feedforward; again: more. Without: the first three."
        ),
    ] = None,
    parameters: Annotated[
        str,
        typer.Option(metavar="HOW", help="runtime: the robot's numbers stay variables of the code; baked: constants."),
    ] = "runtime",
    layout: Annotated[
        str,
        typer.Option(metavar="HOW", help="fused: C in one piece, fast for few links; modular: small; auto chooses."),
    ] = "auto",
    batch: Annotated[
        bool, typer.Option("--batch", help="Also C that steps many scenarios at once, for hosts with vector registers.")
    ] = False,
    derivatives: Annotated[
        bool, typer.Option("--derivatives", help="Also C of derivatives: of accelerations, steps and joint wrenches.")
    ] = False,
    estimator: Annotated[bool, typer.Option("--estimator", help="Also a Kalman filter, with --derivatives.")] = False,
    measure: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="What the filter is told, as gyro@boom.tip; again: more.")
    ] = None,
    estimate: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="A parameter that the filter finds, too; again: more.")
    ] = None,
    outputs: Annotated[
        bool, typer.Option("--outputs", help="Also C of what runs report, such as energies, and sensors measure.")
    ] = False,
    by_p: Annotated[list[str] | None, typer.Option(metavar="NAME", help="Also C of derivatives by parameters.")] = None,
    mpc: Annotated[
        str | None, typer.Option(metavar="FILE", help="Also C of the predictive controller of FILE, TOML.")
    ] = None,
    functions: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME",
            help="A CasADi function to save, or all; may be given again. Without: dynamics, energy and poses.",
        ),
    ] = None,
    quiet: Quiet = False,
) -> None:
    """Write a folder of generated code: C99 without heap, CasADi functions, LaTeX equations.

    The folder is written whole or not at all; one that holds files of other origin is refused.
    """
    from .commands import run_generate

    more = {"batch": batch, "derivatives": derivatives, "estimator": estimator, "outputs": outputs}
    said = {"measure": measure or (), "mpc": mpc, "functions": functions or None, "by_p": by_p or ()}
    said["estimate"] = estimate or ()
    run_generate(robot, output, target, parameters, layout, quiet or context.obj, **said, **more)


running.register(app, EPILOG)


@app.command(short_help="Print the dynamics at a state, as JSON.", epilog=EPILOG)
def evaluate(
    robot: RobotFile,
    state: StateFile = None,
    backend: Annotated[
        str, typer.Option(metavar="NAME", help="numpy, casadi or c, which compiles the generated code.")
    ] = "numpy",
    form: Form = "joint",
    formulation: Annotated[
        str, typer.Option(metavar="NAME", help="consistent, or another that a plug-in adds.")
    ] = "consistent",
) -> None:
    """Print accelerations, joint wrenches, tip pose and energies at a state, as JSON."""
    from .commands import run_evaluate

    run_evaluate(robot, state, backend, form, formulation)


@app.command(short_help="Print natural frequencies.", epilog=EPILOG)
def modes(
    robot: RobotFile,
    posture: Annotated[
        str | None, typer.Option(metavar="FILE", help="A state file, of which q is read; zero without.")
    ] = None,
    joints: Annotated[str, typer.Option(metavar="HOW", help="locked, springs and all, or free.")] = "locked",
    rates: Annotated[
        str | None, typer.Option(metavar="NUMBERS", help="Joint rates, rad/s or m/s, of an arm that turns steadily.")
    ] = None,
    loaded: Annotated[bool, typer.Option("--loaded", help="Under gravity: bent by it, stiffened or softened.")] = False,
    json: Annotated[bool, typer.Option("--json", help='Print {"frequencies_hz": […], …}.')] = False,
    plot: Annotated[str | None, typer.Option(metavar="FILE", help="Draw the mode shapes, as .png.")] = None,
    view: ViewFile = None,
) -> None:
    """Print the natural frequencies in Hz, and how far one more mode would move them: at rest without gravity, or
    with --rates and --loaded about a steady motion and the deflection under its loads, the joints held by torques.
    """
    from .linear import run_modes

    run_modes(robot, posture, joints, rates, loaded, json, plot, view)


@app.command(short_help="Find where the arm rests under gravity.", epilog=EPILOG)
def equilibrium(
    robot: RobotFile,
    q: Annotated[
        str | None,
        typer.Option(
            metavar="NUMBERS",
            help="Joint angles, rad (slides: m), as 0.1,-0.2: those held, or where the search starts. Zero without.",
        ),
    ] = None,
    tau: Annotated[
        str | None,
        typer.Option(
            metavar="NUMBERS",
            help="Joint torques that act, N·m (slides: N), of held joints 0; behind them tensions, N. Zero without.",
        ),
    ] = None,
    tensions: Annotated[
        str | None, typer.Option(metavar="NUMBERS", help="Tensions of tendons alone, N, as 5,0. Zero without.")
    ] = None,
    hold: Annotated[bool, typer.Option("--hold", help="Hold joints without springs; the torques follow.")] = False,
    hold_all: Annotated[bool, typer.Option("--hold-all", help="Hold joints with springs too.")] = False,
    hold_only: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="Hold this link's joint, or coordinate; may be repeated.")
    ] = None,
    free: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="Hold all but this one; may be repeated.")
    ] = None,
    state: StateFile = None,
    json: Json = False,
) -> None:
    """Find the posture in which the arm rests under gravity: angles and bending, torques, wrenches, and its stability.
    Joints are free under torques and springs, or held, but for passive ones on springs: all with --hold, else those
    named by --hold-only or not named by --free. --state gives q, tau, w_ext.
    """
    from .linear import HoldOptions, run_equilibrium

    holding = HoldOptions(hold, hold_all, tuple(hold_only or ()), tuple(free or ()))
    run_equilibrium(robot, state, q, tau, tensions, holding, json)


@app.command(short_help="Find a posture with closed loops.", epilog=EPILOG)
def assemble(
    robot: RobotFile,
    q: Annotated[
        str | None, typer.Option(metavar="NUMBERS", help="Where the search starts: joint coordinates. Zero without.")
    ] = None,
    hold: Annotated[
        list[str] | None, typer.Option(metavar="NAME", help="A coordinate that stays; may be given again.")
    ] = None,
    state: StateFile = None,
) -> None:
    """Print the coordinates nearest to --q with which the loops are closed, as JSON that --state reads. Links bend only
    where the loops do not close otherwise; a --state gives the modes that they start from.
    """
    from .linear import run_assemble

    run_assemble(robot, state, q, hold or [])


app.command(short_help="Write a page in which runs play.", epilog=EPILOG)(view)


@app.command(short_help="Analyse well-posedness, spectrum and steps.", epilog=EPILOG)
def analyse(
    context: typer.Context,
    robot: RobotFile,
    state: Annotated[
        list[str] | None, typer.Option(metavar="FILE", help="A state, or a run.npz: its limits; may be given again.")
    ] = None,
    samples: Annotated[
        int | None,
        typer.Option(metavar="N", min=0, max=10000, help="Random states besides; 20 if no --state is given."),
    ] = None,
    seed: Annotated[int, typer.Option(metavar="N", min=0, help="Of the random states.")] = 0,
    step: Annotated[float, typer.Option(metavar="S", help="The time step whose growth is reported.")] = 1e-3,
    controller: Annotated[
        str | None, typer.Option(metavar="KIND:FILE", help="pd:gains.toml: closes the loop, torques held.")
    ] = None,
    plot: Annotated[str | None, typer.Option(metavar="FILE", help="Draw the structure of M_sys, as .png.")] = None,
    json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Report whether the equations are well posed: rank and condition of M_sys, definiteness, spectrum, step limits."""
    from .commands import run_analyse

    run_analyse(robot, state or [], samples, seed, step, controller, plot, json, quiet or context.obj)


@app.command(short_help="Write the equations as .tex, .pdf or .html.", epilog=EPILOG)
def latex(
    context: typer.Context,
    robot: RobotFile,
    output: Annotated[str, typer.Option("-o", "--output", metavar="FILE", help="equations.tex, .pdf or .html.")],
    scalar: Annotated[bool, typer.Option("--scalar", help="Of a small robot: M, C, g entry by entry.")] = False,
    about: Annotated[
        str | None, typer.Option(metavar="Q,...", help="With --scalar: also linear about rest in this posture.")
    ] = None,
    documentclass: Annotated[
        str | None, typer.Option(metavar="NAME[OPTIONS]", help="The class of the LaTeX document, as 'report[11pt]'.")
    ] = None,
    fragment: Annotated[
        bool, typer.Option("--fragment", help="LaTeX for \\input; the packages that it needs stand at its top.")
    ] = False,
    notation: Annotated[
        str | None, typer.Option(metavar="NAME|FILE", help="Letters: paper, featherstone, or a TOML table of your own.")
    ] = None,
    at: Annotated[str | None, typer.Option(metavar="FILE", help="Of a page: a state, for its mass matrix.")] = None,
    whole: Annotated[
        bool, typer.Option("--all", help="Of .tex and .pdf: also the derivation and further forms of the equations.")
    ] = False,
    quiet: Quiet = False,
) -> None:
    """Write the robot's equations as LaTeX, as a PDF or as a page for the browser."""
    from .typesetting import run_latex

    run_latex(robot, output, scalar, about, documentclass, fragment, notation, at, whole, quiet=quiet or context.obj)


for group in (exchange, identifying, gaining, motions, shaping):
    group.register(app, EPILOG)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command line (default: this process's) and return its exit status."""
    if arguments is None:
        prepare()
    return guarded(lambda: _command(sys.argv[1:] if arguments is None else list(arguments)))


def application() -> TyperGroup:
    """The product's commands with those that plug-ins add.  Raises ScrewgenError if two have one name."""
    whole = copy(app)
    whole.registered_commands, whole.registered_groups = list(app.registered_commands), list(app.registered_groups)
    for plugin in plugins():
        plugin.commands(whole)
    found = typer.main.get_command(whole)
    assert isinstance(found, TyperGroup), "the product has commands"
    if len(found.commands) < len(whole.registered_commands) + len(whole.registered_groups):
        raise ScrewgenError("two plug-ins, or a plug-in and the product, have commands of one name")
    return found


def _command(arguments: list[str]) -> int:
    command = application()
    if arguments and arguments[0] not in command.commands and arguments[0] in declared():
        raise UsageError(f"the command '{arguments[0]}' is that of a plug-in which is not installed")
    status = command.main(arguments, prog_name="screwgen", standalone_mode=False)
    if status == 130:
        raise KeyboardInterrupt
    sys.stdout.flush()
    return status if isinstance(status, int) else 0
