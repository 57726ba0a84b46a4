"""The work of the commands. Arguments arrive as the user typed them; errors are raised as ScrewgenError."""

from __future__ import annotations

import json as json_format
import sys
import warnings
from collections.abc import Callable, Iterable, Sequence
from contextlib import nullcontext
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ..algorithms.robot_functions import reported
from ..errors import SingularError, TargetWarning, UsageError
from ..model import CONSISTENT, FURTHER, TARGETS, UNITS, Model, derive, formulations
from ..plugins import Formulation
from ..progress import bar, busy
from ..simulation.state import State, state_in
from ..spec.load import one_line
from ..studies.light_joints import light_joints
from .output import load_robot, notes, say, stoppable

if TYPE_CHECKING:
    pass


def check_choice(option: str, given: str, known: Iterable[str]) -> None:
    """Refuse names that are not in `known`."""
    if given not in known:
        raise UsageError(f"{option}: there is no '{one_line(given)}'; choose {' or '.join(known)}")


# ------------------------------------------------------------------------------ generate

PARAMETERS = ("runtime", "baked")
LAYOUTS = ("auto", "fused", "modular")


def run_generate(
    robot: str,
    output: str,
    targets: Sequence[str] | None,
    parameters: str,
    layout: str,
    quiet: bool,
    **more: Any,
) -> None:
    """Write the folder and list its files; ``more``: further options, as :meth:`screwgen.Model.write` has them."""
    for target in targets or ():
        check_choice("--target", target, (*TARGETS, *FURTHER))
    check_choice("--parameters", parameters, PARAMETERS)
    check_choice("--layout", layout, LAYOUTS)
    for name, asked in more.items():
        what, target = ("CasADi files", "casadi") if name == "functions" else ("C", "c")
        served = (target, *UNITS) if name == "outputs" else (target,)
        if asked and targets and not set(served) & set(targets):
            option = f"--{name.replace('_', '-')}"
            said = f"{option} adds to the {what}, which --target leaves out"
            raise UsageError(f"{said}; add --target {target} or leave {option} out")
    if measure := more.pop("measure", ()):
        more["estimator"] = measure
    if not output:
        raise UsageError("the folder after -o has no name; name one to write")
    model = derive(load_robot(robot, quiet))
    wanted = tuple(t for t in (*TARGETS, *FURTHER) if t in (targets or TARGETS))
    documents = model.documents_beside() if "latex" in wanted and len(wanted) > 1 else nullcontext()
    noting = warnings.catch_warnings(record=True, action="always", category=TargetWarning)
    with stoppable(), documents, busy("generating", quiet), noting as noted:
        files = model.write(output, targets=wanted, parameters=parameters, layout=layout, **more)
    for note in noted:
        print(f"screwgen: warning: {robot}: {note.message}", file=sys.stderr)
    notes(robot, light_joints(model), quiet)
    say("\n".join(str(Path(output) / name) for name in files), quiet)


# ------------------------------------------------------------------------------ evaluate

Evaluation = tuple[np.ndarray, np.ndarray]


def _casadi_joint(model: Model, s: State) -> Evaluation:
    out = model.casadi()["forward_dynamics"](s.q, s.v, s.tau, s.w_ext.T, model.parameter_values)
    return np.array(out[0])[:, 0], np.array(out[1]).T


def _casadi_dae(model: Model, s: State) -> Evaluation:
    from ..backends.casadi.functions import modal_functions
    from ..backends.numpy.own_forces import CoordinateForces

    functions, p = modal_functions(model.chain), model.parameter_values
    x = model.casadi()["dae_state"](s.q, s.v, p)
    own = CoordinateForces.of_columns(model.chain, [np.array(x)[:, 0] for x in functions["modal_properties"].call([p])])
    own = own.over(s.q, s.v)
    force = own.force_of(s.q, s.v, 0.0)
    _, vdot, wrench = functions["dae_dynamics"](x, s.tau, s.w_ext.T, own.M, force, p)
    rates = np.array(vdot)[:, 0]
    vdot = np.append(rates, own.internal_rates(rates))
    if states := model.chain.n_force_states:
        found = functions["dae_force_rates"](x, s.tau, np.array(x)[-states:], 0.0, p)
        vdot[-states:] = np.array(found)[:, 0]
    return vdot, np.array(wrench).T


EVALUATIONS: dict[tuple[str, str], Callable[[Model, State], Evaluation]] = {
    ("numpy", "joint"): lambda model, s: model.numpy().forward_dynamics(*s),
    ("numpy", "dae"): lambda model, s: model.numpy().dae_forward_dynamics(*s),
    ("casadi", "joint"): _casadi_joint,
    ("casadi", "dae"): _casadi_dae,
    ("c", "joint"): lambda model, s: model.compile().forward_dynamics(s.q, s.v, s.tau, s.w_ext),
    ("c", "dae"): lambda model, s: model.compile().forward_dynamics(s.q, s.v, s.tau, s.w_ext, "dae"),
}
"""Accelerations (nq,) and joint wrenches (n, 6) by backend and form."""

BACKENDS = ("numpy", "casadi", "c")
FORMS = ("joint", "dae")


def run_evaluate(robot: str, state: str | None, backend: str, form: str, formulation: str) -> None:
    """Print the JSON of an evaluation."""
    check_choice("--formulation", formulation, formulations())
    check_choice("--backend", backend, BACKENDS)
    check_choice("--form", form, FORMS)
    if formulation != CONSISTENT and (backend, form) != ("numpy", "joint"):
        raise UsageError(
            f"--formulation {formulation} is evaluated by NumPy in the joint form; leave out --backend and --form"
        )
    loaded = load_robot(robot)
    if formulation == CONSISTENT:
        model = derive(loaded)
        found = evaluation(model, state_in(state, model), backend, form)
    else:
        found = _formulated(cast("Formulation", derive(loaded, formulation)), state)
    print(json_format.dumps(found, allow_nan=False))


def _formulated(other: Formulation, state: str | None) -> dict:
    """An evaluation in another formulation: its dynamics, and the rest as derived."""
    s = state_in(state, other.model)
    vdot, wrench = other.forward_dynamics(*s)
    dynamics = {"vdot": (vdot + 0.0).tolist(), "wrench": (wrench[other.model.chain.firsts] + 0.0).tolist()}
    return evaluation(other.model, s) | dynamics | other.record()


def evaluation(model: Model, s: State, backend: str = "numpy", form: str = "joint") -> dict:
    """Accelerations and joint wrenches by a backend and a form, with the tip pose and energies, as lists.

    Raises SingularError: NumPy's dynamics, which knows the joint, comes first.
    """
    reference = model.numpy()
    reference.forward_dynamics(*s)
    vdot, wrench = EVALUATIONS[backend, form](model, s)
    if not (np.isfinite(vdot).all() and np.isfinite(wrench).all()):
        raise SingularError(f"the backend '{backend}' gives no finite accelerations in this state")
    valid = model.validity(*s)
    valid.warn()
    R, position = reference.tip_pose(s.q)
    told: dict = {}
    for row in reported(model.chain):
        found = getattr(reference, row.name)(*(getattr(s, name) for name in row.names))
        values = found if len(row.results) > 1 else (found,)
        told |= {name: (np.asarray(x) + 0.0).tolist() for name, x in zip(row.results, values, strict=True)}
    loops = reference.loop_wrenches(*s) if model.chain.closing.rows else None
    return {
        "vdot": (np.ravel(vdot) + 0.0).tolist(),
        "wrench": (np.reshape(wrench, (model.n_links, 6))[model.chain.firsts] + 0.0).tolist(),
        "tip_position": position.tolist(),
        "tip_rotation": R.tolist(),
        **told,
        "validity": valid.record(),
        "links": [link.name for link in model.robot.links],
        **({} if loops is None else {"loop_wrenches": (loops + 0.0).tolist(), "loops": _loops(model)}),
    }


def _loops(model: Model) -> list[dict]:
    """Every loop's markers, and their rows among the loops' wrenches."""
    ends = {row.loop: [row.first, row.second] for row in model.chain.closing.rows}
    return [{"between": list(loop.between), "rows": ends.get(k, [])} for k, loop in model.robot.rigid_loops.items()]


# ------------------------------------------------------------------------------ analyse


def run_analyse(
    robot: str,
    states: Sequence[str],
    samples: int | None,
    seed: int,
    step: float,
    controller: str | None,
    plot: str | None,
    json: bool,
    quiet: bool,
) -> None:
    """Print the report or the JSON, and draw the structure; of runs the limits of the model alone."""
    from ..simulation.linearised import check_step
    from ..simulation.named_controllers import read_controller
    from ..simulation.runs import check_output, outputs, suffix
    from ..studies.analysis import SAMPLES, analyse, first_state, sample_states

    check_step(step)
    if any(suffix(path) == ".npz" for path in states):
        _analyse_runs(robot, states, json)
        return
    if plot is not None:
        check_output(plot, (".png",))
    count = (0 if states else SAMPLES) if samples is None else samples
    model = derive(load_robot(robot, quiet))
    law = read_controller(controller, model) if controller is not None else None
    given = {one_line(path): state_in(path, model) for path in states} or first_state(model)
    for path, state in given.items():
        if law is not None and state.tau.any():
            raise UsageError(f"{path}: tau: is given beside --controller; leave one of them out")
    given |= sample_states(model, count, seed, hold=law is None)
    with outputs(*filter(None, (plot,))) as streams:
        with bar("analysing", len(given), quiet) as progress:
            found = analyse(model, given, step, law, progress)
        if plot is not None:
            from ..plotting.structure import png

            streams[0].write(png(found.structure, model.robot.name))
    print(found.to_json() if json else found.text())


def _analyse_runs(robot: str, paths: Sequence[str], json: bool) -> None:
    """Print how far runs went from the limits of the model."""
    from ..simulation.collocated import left_out
    from ..studies.analysis.runs import read_motion, run_validity
    from ..studies.analysis.text import limits_of_model

    model = derive(load_robot(robot))
    runs = {one_line(path): read_motion(path, model) for path in paths}
    found = {path: (run_validity(model, run), left_out(model, run["q"])) for path, run in runs.items()}
    if json:
        records = {path: v.record() | {"left_out": [asdict(x) for x in rods]} for path, (v, rods) in found.items()}
        print(json_format.dumps(records, allow_nan=False))
    else:
        print("\n\n".join(limits_of_model(path, *both) for path, both in found.items()))
