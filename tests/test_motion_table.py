"""Given motions from a table: runs as splines of SciPy give them, and one line for a table that makes no sense."""

from __future__ import annotations

import numpy as np
import pytest
from helpers import arm, link, model_of
from scipy.interpolate import CubicSpline

import screwgen
from screwgen import UsageError
from screwgen.simulation.motion_table import read_motion

T = np.linspace(0.0, 0.5, 26)
BOB = {"at": "tip", "mass": 0.7, "com": [0.0, 0.0, -0.8]}
CART = {
    "name": "cart",
    "joint": {"axes": [{"slide": "x"}], "actuation": "motion"},
    "bodies": [{"at": "tip", "mass": 2}],
}
TURN = 3.5 * np.sin(4 * T)
SEA = np.array([0.1 * np.sin(5 * T), 0 * T, 0.2 * T**2, TURN, 0.1 * T, 0 * T]).T


def afloat() -> screwgen.Model:
    hull = {
        "name": "hull",
        "joint": {"axes": []},
        "bodies": [{"at": "base", "mass": 9.0, "inertia": [1, 1, 1, 0, 0, 0]}],
    }
    return model_of(arm(hull, CART | {"parent": "hull"}, link("bob", 0.8, "y", bodies=[BOB]), base="moving"))


def written(path, head: str, *columns: np.ndarray) -> str:
    np.savetxt(path, np.column_stack(columns), "%.15g", ",", header=head, comments="")
    return str(path)


def test_a_table_of_a_base_and_an_axis_gives_the_run_of_their_splines(tmp_path):
    model, x = afloat(), 0.2 * T**2
    table = written(tmp_path / "m.csv", "t,base.x,base.y,base.z,base.rx,base.ry,base.rz,cart.slide[0]", T, SEA, x)
    curves = {"base": CubicSpline(T, SEA), "cart.slide[0]": CubicSpline(T, x)}
    runs = [screwgen.simulate(model, 0.5, 1e-3, motion=way) for way in (read_motion(table, model), curves)]
    assert np.abs(runs[0].q - runs[1].q).max() < 1e-12


def test_a_run_is_a_table_whatever_the_signs_of_its_quaternions(tmp_path):
    model = afloat()
    given = {"base": CubicSpline(T, SEA)}
    run = screwgen.simulate(model, 0.5, 1e-3, motion=given)
    pose = run.q[:, :7].copy()
    pose[::2, 3:] *= -1.0
    table = written(tmp_path / "m.csv", ",".join(["t", *model.q_names[:7]]), run.t, pose)
    again = screwgen.simulate(model, 0.5, 1e-3, motion=read_motion(table, model))
    turns = np.abs(np.einsum("ij,ij->i", run.q[:, 3:7], again.q[:, 3:7]))
    assert np.abs(turns - 1).max() < 1e-9 and np.abs(run.q[:, 7:] - again.q[:, 7:]).max() < 1e-6


@pytest.mark.parametrize(
    "head, said",
    [
        ("t,cart.slid[0]", "known here: t, cart.slide[0], base.x"),
        ("t,base.x", "of the base it has base.x; give all of base.x, base.y, base.z, base.qw"),
        ("t,bob.joint[0]", "known here: t, cart.slide[0], base.x"),
    ],
)
def test_other_columns_are_refused(tmp_path, head, said):
    with pytest.raises(UsageError) as caught:
        read_motion(written(tmp_path / "m.csv", head, T, T), afloat())
    assert said in str(caught.value) and "\n" not in str(caught.value)


def test_a_rotation_vector_that_jumps_by_a_turn_is_refused(tmp_path):
    """A base that turns on, whose angle is kept between -pi and pi."""
    sea = SEA.copy()
    sea[:, 3], sea[:, 4:] = (8.0 * T + np.pi) % (2 * np.pi) - np.pi, 0.0
    head = "t,base.x,base.y,base.z,base.rx,base.ry,base.rz"
    said = r"m\.csv: base\.rx, base\.ry, base\.rz change by 6\.12 rad from row 20 to the next, more than half a turn"
    with pytest.raises(UsageError, match=said):
        read_motion(written(tmp_path / "m.csv", head, T, sea), afloat())


def test_a_robot_that_is_driven_by_torques_has_no_given_motion(tmp_path):
    with pytest.raises(UsageError, match=r"m\.csv: nothing of this robot moves as is given"):
        read_motion(written(tmp_path / "m.csv", "t,bob.joint[0]", T, T), model_of(arm(link("bob", 0.8, "y"))))


def test_a_table_that_ends_before_the_run_is_refused(tmp_path):
    table = written(tmp_path / "m.csv", "t,cart.slide[0]", T, T)
    with pytest.raises(UsageError, match=r"cart.slide\[0\] is a spline from 0 to 0.5 s; the run goes from 0 to 0.6 s"):
        screwgen.simulate(afloat(), 0.6, 1e-3, motion=read_motion(table, afloat()))
