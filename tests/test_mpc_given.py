"""Predictive control where some inputs are given: brakes, lines of winches, motions of axes and of a base."""

from functools import cache

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of
from mpc_judge import Problem, off_the_dense_program
from test_mpc import PLAIN, TIP, WHOLE

import screwgen

SOFT = {"EIy": 300.0, "EIz": 500.0}
BENDS = {"bending_y": 1, "bending_z": 1}
BOOM = {"axes": ["y", "z"], "modes": BENDS, "section": SOFT, "bodies": TIP}
FORE = {"axes": ["z"], "modes": {"bending_y": 1}, "section": SOFT, "bodies": TIP}
HULL = link(
    "hull", length=0.3, axes=[], bodies=[{"at": "base", "mass": 50.0, "inertia": [3.0, 3.0, 3.0, 0.0, 0.0, 0.0]}]
)
RELAXING = {"stiffness": 5.0, "rest": 1.4, "relaxation": 10.0, "relaxation_time": 0.1}
LINE = {"stiffness": 20.0, "rest": 1.5, "damping": 1.0, "winch": True}
ROPE = {"name": "hoist", "between": ["b.tip", {"world": [0.5, 0.0, 1.5]}]}


def two(boom=None, fore=None, **more) -> dict:
    links = (
        link("a", **BOOM, joint={"armature": [0.5, 0.5], **(boom or {})}),
        link("b", **FORE, joint={"armature": [0.2], **(fore or {})}),
    )
    first = more.pop("first", ())
    return arm(*first, *links, **more)


ROBOTS = {
    "brakes": two({"brake": [False, True]}, {"brake": [{"time": 0.05}]}),
    "winch": two(forces=[ROPE | {"line": LINE}]),
    "relaxing line": two(forces=[ROPE | {"line": LINE}, ROPE | {"name": "band", "line": RELAXING}]),
    "given axis": two({"actuation": ["motion", "torque"]}),
    "moving base": two(first=[HULL], base="moving"),
}
"""Each with the inputs that are given."""
NUMBERS = {"brakes": [0.3, 0.5], "winch": [0.2, 0.0], "relaxing line": [0.2, 0.0], "given axis": [0.7]}
NUMBERS["moving base"] = [0.4, -0.3, 0.2, 0.5, -1.0, 0.8]


@cache
def model(robot):
    return model_of(ROBOTS[robot])


def of(robot: str, text: str) -> str:
    """A file's numbers for the torques that are left to choose, of a given axis one fewer."""
    if robot != "given axis":
        return text
    text = text.replace("torques = [60.0, 12.0, 4.0]", "torques = [12.0, 4.0]")
    return text.replace("{ lower = [-50.0, -30.0, -20.0], upper = [60.0, 30.0, 20.0] }", "30.0")


@pytest.fixture(scope="module")
def controllers(tmp_path_factory):
    folder = tmp_path_factory.mktemp("mpc")

    @cache
    def made(robot, text):
        file = folder / f"mpc{abs(hash((robot, text)))}.toml"
        file.write_text(of(robot, text))
        return model(robot).mpc(file, flags=QUICK)

    return made


@cache
def start(robot):
    return screwgen.equilibrium(model(robot), [0.0, 0.0, 0.0], hold="all").q


def give(c, robot, rng):
    """Given inputs that differ from stage to stage."""
    for stage in c.reference:
        stage["tau"][c.fitted.given] = NUMBERS[robot] * rng.uniform(0.5, 1.5, len(c.fitted.given))


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_program_is_the_dense_one(controllers, robot):
    """Also about given inputs that differ from stage to stage, and from a base that is where nobody expected it."""
    c, m = controllers(robot, WHOLE), model(robot)
    give(c, robot, np.random.default_rng(1))
    sizes = np.full(m.chain.n_changes, 0.01)
    sizes[: m.chain.base_v] = 1e-4
    assert off_the_dense_program(c, m, start(robot), sizes) <= 1e-9


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_fixed_point(controllers, robot):
    c, m = controllers(robot, PLAIN), model(robot)
    judge = Problem(m, c.said, c.options, c.reference)
    give(c, robot, np.random.default_rng(2))
    c.initialise(start(robot), np.zeros(m.nv))
    assert c.converged
    torques, cost = judge.solve(c.states[0], c.inner["acting"], c.inner["tau"])
    reach = c.options["torque_upper"] - c.options["torque_lower"]
    print(robot, np.abs((c.inner["tau"] - torques) / reach).max(), c.inner["cost"][0] / cost - 1)
    assert np.abs((c.inner["tau"] - torques) / reach).max() <= 1e-6
    assert c.inner["cost"][0] == pytest.approx(cost, rel=1e-8)
