"""Checks of the command line and of files that other programs read."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pinocchio
from every_command import DONE, GCC, REFUSED, TCC, called
from random_robots import to_toml

from conformance.cases import STEP, Case
from conformance.numbers import near
from conformance.twin import first_piece
from conformance.uses import closed
from screwgen import ScrewgenError


def written(case: Case) -> Path:
    """Robot and states as the files that commands read."""
    folder = case.folder
    (folder / "robot.toml").write_text(to_toml(case.robot), encoding="utf-8")
    q, v, tau, w_ext = case.given
    state = {"q": q, "v": v, "tau": tau, "w_ext": w_ext[case.model.chain.lasts]}
    (folder / "state.json").write_text(json.dumps({k: np.asarray(x).tolist() for k, x in state.items()}))
    (folder / "rest.json").write_text(json.dumps({"q": closed(case)[0].tolist()}))
    return folder


def lines(folder: Path) -> dict[str, list[str]]:
    """Command lines by their names."""
    robot, state, rest = (str(folder / name) for name in ("robot.toml", "state.json", "rest.json"))
    at = ["--state", state]
    run = ["simulate", robot, "--duration", "0.004", "--step", str(STEP), *at, "--quiet"]
    commands = {
        "simulate": [*run, "-o", str(folder / "joint.npz"), "--plot", str(folder / "joint.png")],
        "simulate dae": [*run, "-o", str(folder / "dae.csv"), "--form", "dae"],
        "view": ["view", str(folder / "joint.npz"), "-o", str(folder / "run.html")],
        "modes": ["modes", robot, "--posture", rest],
        "analyse": ["analyse", robot, "--state", rest, "--samples", "1"],
        "latex": ["latex", robot, "-o", str(folder / "equations.html")],
    }
    targets = ["--target", "casadi", "--target", "latex"]
    commands["generate"] = ["generate", robot, "-o", str(folder / "out"), *targets]
    for backend in ("numpy", "casadi", "c"):
        for form in ("joint", "dae"):
            commands[f"evaluate {backend} {form}"] = [*("evaluate", robot, *at, "--backend", backend, "--form", form)]
    return commands


def every_command(case: Case) -> None:
    """Every command ends well, with nothing but what it should print."""
    os.environ["CC"] = TCC
    commands = lines(written(case))
    if "four-bar" in case.features:
        del commands["analyse"]  # it samples postures, some of which a linkage that cannot turn round does not reach
    for name, line in commands.items():
        found = called(line)
        assert found.said == DONE, f"{name}: {found.said}: {found.why}"


def units(case: Case) -> None:
    """A mock-up unit steps as the C does, from the same state under the same inputs."""
    from fmi_units import Unit

    os.environ["CC"] = GCC
    (q, v), tau, model = closed(case), case.given[2], case.model
    make = lambda: case.robot  # noqa: E731
    unit = Unit("fmu3", "cs", make).ready(**dict(zip(model.q_names + model.v_names, [*q, *v], strict=True)))
    start = unit.get(unit.states)
    near(start, np.concatenate([q, v]), 1e-9, "the start")
    unit.set(dict(zip(model.tau_names, tau, strict=True)))
    unit.step(0.0, STEP)
    after = case.c().step(start[: model.nq], start[model.nq :], tau, None, STEP, "modal_implicit")
    near(unit.get(unit.states), np.concatenate(after), case.agreement, "a step of the unit")


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
