"""`base_acceleration = true`: an arm with entries a moves as the same one does where free fall is g - a."""

from functools import cache

import jax
import numpy as np
import pytest
from conformance.checks import CHECKS
from document_reader import accelerations_from_document
from extending.outside import Outside
from helpers import arm, casadi_forward, example_dict, link, model_of, quick, relative
from pydantic import ValidationError
from test_document_reader import state

import screwgen
from screwgen.backends.numpy.closing import moving
from screwgen.cli.main import main
from screwgen.plotting.run_panels import panels

A = np.array([0.7, -1.3, 2.1])
NAMES = [f"base.acceleration_{axis}" for axis in "xyz"]
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
ROD = link("rod", 0.8, ("z", "y"), modes={"bending_y": 2, "bending_z": 2, "torsion": 1}, order="exact",
           section={"rhoIp": 1e-2, "EIy": 30.0, "EIz": 20.0, "GJ": 10.0})  # fmt: skip
ROBOTS = {
    "flexible": arm(link("upper", 0.7, "zy", **SOFT), link("fore", 0.4, "y", **SOFT), gravity=(0.4, -3.0, -6.0)),
    "loop": example_dict("crane_loop"),
    "exact": arm(ROD, gravity=(0.4, -3.0, -6.0)),
    "winch, brake, tendon": arm(
        link("upper", 0.7, ("z", "y"), joint={"brake": [True, False]},
             tendons=[{"name": "left", "at": [[0.0, 0.02, 0.01], [0.0, 0.01, 0.0]]}], **SOFT),
        forces=[{"name": "rope", "between": [{"world": [0.3, 0.4, -0.5]}, "upper.tip"],
                 "line": {"stiffness": 400.0, "rest": 0.2, "damping": 8.0, "winch": True}}],
    ),
}  # fmt: skip
every_robot = pytest.mark.parametrize("name", ROBOTS)


class Pair:
    """The robot with the key, the same one where free fall is another, and a state of both."""

    def __init__(self, name):
        robot = ROBOTS[name]
        self.model = model_of(robot | {"base_acceleration": True})
        self.other = model_of(robot | {"gravity": [float(x) for x in np.array(robot["gravity"]) - A]})
        self.q, self.v, self.tau, self.w_ext = state(self.other)
        self.tau[[".brake[" in x for x in self.other.tau_names]] = 0.4
        if self.other.robot.loops:
            self.q = screwgen.assemble(self.other)
            self.v = moving(self.other.numpy(), self.q, self.v)
        self.places = [self.model.tau_names.index(x) for x in NAMES]
        self.wanted = self.other.numpy().forward_dynamics(self.q, self.v, self.tau, self.w_ext)

    def with_a(self, tau, a=A):
        return np.insert(tau, self.places[0], a)

    @property
    def given(self):
        return self.q, self.v, self.with_a(self.tau), self.w_ext


pair = cache(Pair)


def alike(pair, found, tolerance=1e-12):
    assert max(relative(np.asarray(x), y) for x, y in zip(found, pair.wanted, strict=True)) <= tolerance


@every_robot
def test_it_moves_as_where_free_fall_is_another(name):
    one = pair(name)
    assert [x for x in one.model.tau_names if x not in one.other.tau_names] == NAMES
    q, v, tau, w_ext = one.given
    alike(one, one.model.numpy().forward_dynamics(*one.given))
    alike(one, casadi_forward(one.model, *one.given))
    with jax.enable_x64(True):
        alike(one, one.model.jax()["forward_dynamics"](q, v, tau, w_ext, np.array(one.model.parameter_values)))
    for layout in ("fused", "modular"):
        for form in ("joint", "dae"):
            alike(one, quick(one.model, layout=layout).forward_dynamics(*one.given, form=form))
    alike(one, accelerations_from_document(one.model, *one.given), 1e-10)


@every_robot
@pytest.mark.parametrize("more", [{}, {"backend": "casadi"}, {"form": "dae"}], ids=["C", "Python", "DAE"])
def test_so_do_runs(name, more):
    one = pair(name)
    rest, tau = np.zeros(one.other.n_tau), one.with_a(np.zeros(one.other.n_tau))
    rest[:2], tau[:2] = 0.3, 0.3
    how = {"q0": one.q if one.other.robot.loops else None, **more}
    found, wanted = (
        screwgen.simulate(m, 0.02, 1e-3, controller=x, **how) for m, x in ((one.model, tau), (one.other, rest))
    )
    assert relative(found.q, wanted.q) < 1e-11 and relative(found.v, wanted.v) < 1e-10
    heads = {panel.title: panel for panel in panels(found)}
    assert heads["Acceleration of the base"].unit == "m/s²"
    assert {*NAMES, *(f"{x}.power" for x in NAMES)} <= set(found.columns)
    assert len(set(found.columns)) == len(found.columns)
    assert [curve.label for curve in heads["Acceleration of the base"].lines] == NAMES
    assert [curve.label for curve in heads["Power of an accelerated base"].lines] == NAMES


@pytest.mark.parametrize("check", [
    "derivatives", "derivatives of wrenches", "derivatives of steps", "linear model", "lanes", "C folder",
    "mock-up unit", "acados", "acados, DAE form", "estimator", "predictive control", "commands", "robot file",
])  # fmt: skip
@pytest.mark.parametrize("name", ["flexible", "loop"])
def test_it_goes_on_to(name, check):
    one = pair(name)
    if (name, check) == ("loop", "predictive control"):
        return  # of robots with loops it is refused
    out = Outside(one.model, one.given, *one.wanted)
    out.robot = ROBOTS[name] | {"base_acceleration": True}
    CHECKS[check].run(out)


@every_robot
def test_it_is_written_and_read_again(name, tmp_path):
    robot = pair(name).model.robot
    (tmp_path / "again.toml").write_text(screwgen.dump(robot), encoding="utf-8")
    again = screwgen.load(tmp_path / "again.toml")
    assert again == robot and again.base_acceleration and "base_acceleration = true" in screwgen.dump(robot)
    given = pair(name).given
    found, wanted = (m.numpy().forward_dynamics(*given) for m in (screwgen.derive(again), pair(name).model))
    assert all(np.array_equal(x, y) for x, y in zip(found, wanted, strict=True))


@every_robot
def test_false_is_the_robot_as_before(name):
    plain, false = (model_of(ROBOTS[name] | more) for more in ({}, {"base_acceleration": False}))
    assert plain.robot == false.robot and "base_acceleration" not in screwgen.dump(false.robot)
    assert plain.tau_names == false.tau_names


@pytest.mark.parametrize("base", ["floating", "moving"])
def test_a_base_that_floats_or_is_moving_refuses_it(base, tmp_path, capsys):
    hull = {
        "name": "hull",
        "joint": {"axes": []},
        "bodies": [{"at": "base", "mass": 4.0, "inertia": [1, 1, 1, 0, 0, 0]}],
    }
    robot = {"name": "boat", "gravity": [0.0, 0.0, -9.81], "base": base, "links": [hull]}
    file = tmp_path / "boat.toml"
    file.write_text(
        screwgen.dump(screwgen.Robot.model_validate(robot)).replace("base =", "base_acceleration = true\nbase =")
    )
    with pytest.raises(ValidationError):
        screwgen.Robot.model_validate(robot | {"base_acceleration": True})
    assert main(["latex", str(file), "-o", str(tmp_path / "boat.tex")]) == 2
    said = capsys.readouterr().err.strip()
    assert len(said.splitlines()) == 1
    assert all(x in said for x in ("boat.toml: base_acceleration", f'base = "{base}"', "leave it out"))


def test_a_urdf_leaves_it_out_and_says_so(tmp_path, capsys):
    (tmp_path / "arm.toml").write_text(screwgen.dump(pair("flexible").model.robot), encoding="utf-8")
    assert main(["export", str(tmp_path / "arm.toml"), "-o", str(tmp_path / "arm.urdf")]) == 0
    assert "base_acceleration is left out" in capsys.readouterr().err
