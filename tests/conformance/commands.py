"""Checks of the command line and of files that other programs read."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from unittest import mock

import numpy as np
import pinocchio
from every_command import DONE, GCC, REFUSED, TCC, called
from random_robots import to_toml

from conformance.cases import STEP, Case
from conformance.numbers import near
from conformance.refusals import REFUSALS
from conformance.twin import first_piece
from conformance.uses import closed
from screwgen import Model, ScrewgenError, model
from screwgen.planning.tip_path import eased


def written(case: Case) -> Path:
    """Robot and states as the files that commands read."""
    folder = case.folder
    (folder / "robot.toml").write_text(to_toml(case.robot), encoding="utf-8")
    q, v, tau, w_ext = case.given
    chain, state = case.model.chain, {"q": q, "v": v, "tau": tau}
    wrenches = w_ext[chain.lasts].tolist()
    if case.robot.get("pushes"):
        wrenches = {name: w_ext[row].tolist() for name, row in chain.wrench_rows.items()}
    stated = {k: np.asarray(x).tolist() for k, x in state.items()} | {"w_ext": wrenches}
    (folder / "state.json").write_text(json.dumps(stated))
    np.savetxt(folder / "path.csv", small_path(case), "%.15g", ",", header="t,x,y,z", comments="")
    (folder / "rest.json").write_text(json.dumps({"q": closed(case)[0].tolist()}))
    return folder


def small_path(case: Case) -> np.ndarray:
    """(21, 4): over times where the tip of the robot is while its joints, unbent, go by 0.05."""
    chain, q = case.model.chain, case.given[0].copy()
    q[chain.eta_q :] = 0.0
    s, ways = np.linspace(0.0, 1.0, 21), np.where(case.sizes == 1.0, 0.05, 0.0)
    return np.array(
        [[2 * t, *case.model.numpy().tip_pose(case.moved(q, x * ways))[1]] for t, x in zip(s, eased(s), strict=True)]
    )


def lines(folder: Path, case: Case) -> dict[str, list[str]]:
    """Command lines by their names."""
    robot, state, rest = (str(folder / name) for name in ("robot.toml", "state.json", "rest.json"))
    at = ["--state", state]
    run = ["simulate", robot, "--duration", "0.004", "--step", str(STEP), *at, "--quiet"]
    commands = {
        "simulate": [*run, "-o", str(folder / "joint.npz"), "--plot", str(folder / "joint.png")],
        "simulate dae": [*run, "-o", str(folder / "dae.csv"), "--form", "dae"],
        "view": ["view", str(folder / "joint.npz"), "-o", str(folder / "run.html")],
        "modes": ["modes", robot, "--posture", rest],
        "modes free": ["modes", robot, "--posture", rest, "--joints", "free", "--json"],
        "modes loaded": ["modes", robot, "--posture", rest, "--loaded"],
        "equilibrium": ["equilibrium", robot, "--hold", "--json"],
        "analyse": ["analyse", robot, "--state", rest, "--samples", "1"],
        "latex": ["latex", robot, "-o", str(folder / "equations.html")],
    }
    joints = slice(case.model.chain.base_q, case.model.chain.base_q + case.model.chain.n_redundant)
    begin = ",".join(map(str, case.given[0][joints]))
    commands["track"] = ["track", robot, str(folder / "path.csv"), "-o", str(folder / "plan.npz"), "--near=" + begin]
    commands["track"] += ["--spacing", "2e-2"]
    targets = ["--target", "casadi", "--target", "latex"]
    commands["generate"] = ["generate", robot, "-o", str(folder / "out"), *targets]
    for backend in ("numpy", "casadi", "c"):
        for form in ("joint", "dae"):
            commands[f"evaluate {backend} {form}"] = [*("evaluate", robot, *at, "--backend", backend, "--form", form)]
    return commands


LOADED = ("modes loaded", "equilibrium")
"""What bears the robot's weight, which may be too much for it."""
STRAINED = ("modes", "modes free")
"""What bears the forces between its frames, which may be so too, in the words of `refusals`."""
UNTRACKED = (
    *(
        "for which there is no tip path",
        "joints cannot move the tip in",
        "is out of reach",
        "leaves out",
        "its limits are",
    ),
    *("no motion was found whose tip is on the path", "no rest was found", "whose limit is"),
)
"""Why tips of such robots follow no path: their joints do not move it so, or what hangs on them swings on."""
OF_MODES = [refusal for refusal in REFUSALS if refusal.check == "modes"]


@contextmanager
def derived_once(case: Case) -> Iterator[None]:
    """Commands that read the robot of the case from its file share its model, of which other checks have derived much.

    Where they read another robot, its model is derived from what they read.
    """
    own = lambda robot: case.model if robot == case.model.robot else Model(robot)  # noqa: E731
    with mock.patch.object(model, "Model", own):
        yield


def every_command(case: Case) -> None:
    """Every command ends well, with nothing but what it should print; those under weight, or under forces
    between frames, may say what these are too much for.
    """
    os.environ["CC"] = TCC
    commands, strained = lines(written(case), case), STRAINED * bool(case.model.chain.forces)
    with derived_once(case):
        outcomes = {name: called(line) for name, line in commands.items()}
    for name, found in outcomes.items():
        known = name in LOADED or (name in strained and any(x.words in found.why for x in OF_MODES))
        known |= name == "track" and any(words in found.why for words in UNTRACKED)
        assert found.said == DONE or (known and found.said == REFUSED), f"{name}: {found.said}: {found.why}"


def units(case: Case) -> None:
    """A mock-up unit of FMI 2 or 3, by turns: fmpy has no findings, it steps as the C does, its slopes, if it has
    them, are those of its values along a direction.
    """
    from fmi_units import Unit, written
    from fmpy.validation import validate_fmu

    os.environ["CC"] = GCC
    (q, v), tau, model, target = closed(case), case.given[2], case.model, f"fmu{2 + case.seed % 2}"
    make = lambda: model  # noqa: E731
    assert validate_fmu(str(written(target, make)[1])) == []
    start = dict(zip(model.q_names + model.v_names, [*q, *v], strict=True))
    unit = Unit(target, "cs", make).ready(**start)
    begun = unit.get(unit.states)
    near(begun, np.concatenate([q, v]), 1e-9, "the start")
    unit.set(dict(zip(model.tau_names, tau, strict=True)))
    unit.step(0.0, STEP)
    after = case.c().step(begun[: model.nq], begun[model.nq :], tau, None, STEP, "modal_implicit")
    near(unit.get(unit.states), np.concatenate(after), case.agreement, "a step of the unit")
    unit = Unit(target, "me", make).ready(**start)
    unit.set(dict(zip(model.tau_names, tau, strict=True)))
    stated = unit.description.modelExchange
    if not (stated.providesDirectionalDerivative or stated.providesAdjointDerivatives):
        return  # they would take too long to compile
    knowns, h = unit.states + unit.inputs, 1e-6
    here, way = unit.get(knowns), np.random.default_rng(case.seed).normal(size=len(knowns))
    way *= [0.05 if ".eta." in name else 1.0 for name in knowns]

    def at(t):
        unit.set(dict(zip(knowns, here + t * way, strict=True)))
        return unit.get(unit.unknowns)

    expected = (at(h) - at(-h)) / (2 * h)
    at(0.0)
    found = unit.fmu.getDirectionalDerivative(unit.of(unit.unknowns), unit.of(knowns), list(way))
    near(found, expected, 1e-6 + case.tolerance / h, "slopes")


def urdf(case: Case) -> None:
    """Pinocchio reads what is exported: the mass of all, and where the links are; and it can be imported again."""
    path = written(case) / "robot.urdf"
    found = called(["export", str(case.folder / "robot.toml"), "-o", str(path)])
    if found.said == REFUSED:
        raise ScrewgenError(found.why)
    assert found.said == DONE, found
    again = called(["import", str(path), "-o", str(case.folder / "imported.toml")])
    assert again.said == DONE, again
    base = (pinocchio.JointModelFreeFlyer(),) if "base" in case.robot else ()
    rigid, oracle = pinocchio.buildModelFromUrdf(str(path), *base), case.judge.oracle
    masses = sum(float(np.sum(cloud.masses)) for cloud in oracle.clouds)
    assert abs(pinocchio.computeTotalMass(rigid) - masses) < 1e-9 * masses
    data, poses = rigid.createData(), oracle.poses(np.zeros(oracle.nv))
    pinocchio.framesForwardKinematics(rigid, data, pinocchio.neutral(rigid))
    names = [x["name"] for x in case.judge.twin["links"]]
    for link in case.robot["links"]:
        first = names.index(first_piece(link))
        frame = data.oMf[rigid.getFrameId(link["name"])]
        near(frame.rotation, poses["R"][first], 1e-9, link["name"])
        assert np.max(np.abs(frame.translation - poses["joint_point"][first])) < 1e-9, link["name"]
