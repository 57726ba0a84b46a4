"""Natural frequencies: springs without digits to spare, what does not vibrate, and what is refused."""

import numpy as np
import pytest
from helpers import arm, link, model_of
from oracle import Oracle
from test_published import SETPOINTS, ella

from screwgen import SingularError, UsageError
from screwgen.studies.convergence import convergence
from screwgen.studies.modes import natural_frequencies


def posture(model, joints=SETPOINTS):
    return np.append(joints, np.zeros(model.nq - len(joints)))


def test_free_joints_give_exact_zeros_and_springs_do_not():
    robot = ella()
    model = model_of(robot)
    free = natural_frequencies(model, posture(model), "free")
    assert free[:3].tolist() == [0.0, 0.0, 0.0] and free[3] > 1.0
    robot["links"][1]["joint"]["stiffness"] = [40.0]
    sprung, oracle = model_of(robot), Oracle(robot)
    found = natural_frequencies(sprung, posture(sprung), "free")
    assert found[:2].tolist() == [0.0, 0.0] and found[2] > 0.1
    assert np.allclose(found[2:], oracle.frequencies(posture(sprung), "free")[2:], rtol=1e-8)


@pytest.mark.parametrize("stiffness", [1e10, 1e16, 1e20, 1e24])
def test_a_joint_of_any_stiffness_leaves_the_other_frequencies_their_digits(stiffness):
    """A very stiff joint is a weld: the same arm with its elbow welded at that angle has the other frequencies."""
    sprung, welded = ella(), ella()
    sprung["links"][1]["joint"]["stiffness"] = [stiffness]
    welded["links"][1]["joint"] = {"axes": [], "mount": {"rpy": [0.0, 0.0, SETPOINTS[2]]}}
    stiff, fixed = model_of(sprung), model_of(welded)
    found, expected = (natural_frequencies(m, posture(m, SETPOINTS[: m.n_joints]), "free") for m in (stiff, fixed))
    assert np.allclose(found[:-1], expected, rtol=1e5 / stiffness + 1e-9, atol=0)
    own = np.sqrt(stiffness * np.linalg.inv(stiff.numpy().mass_matrix(posture(stiff)))[2, 2]) / (2 * np.pi)
    assert np.isclose(found[-1], own, rtol=1e-4)


def test_springs_leave_the_mass_matrix_alone():
    robot = ella()
    expected = model_of(robot).numpy().mass_matrix(posture(model_of(robot)))
    robot["links"][1]["joint"]["stiffness"] = [1e20]
    assert np.array_equal(model_of(robot).numpy().mass_matrix(posture(model_of(robot))), expected)


def test_nothing_that_vibrates_is_said_at_once(monkeypatch):
    """No mass matrix of a thousand links is made to say that there are no modes."""
    model = model_of(arm(*(link(f"link{i}", 0.3, "y") for i in range(1000))))
    monkeypatch.setattr(type(model), "numpy", lambda *_: pytest.fail("computed"))
    assert natural_frequencies(model).size == 0 and convergence(model).total.size == 0


def test_locked_rigid_arm_has_no_frequencies():
    robot = ella()
    for table in robot["links"]:
        del table["modes"]
    model = model_of(robot)
    assert natural_frequencies(model).size == 0
    assert natural_frequencies(model, joints="free").tolist() == [0.0, 0.0, 0.0]


def test_parameters_take_the_place_of_the_files():
    model = model_of(ella())
    factors = [4.0 if ".EI" in name or ".EA" in name else 1.0 for name in model.parameter_names]
    p = np.multiply(factors, model.parameter_values)
    q = posture(model)
    assert np.allclose(natural_frequencies(model, q, parameters=p), 2 * natural_frequencies(model, q), rtol=1e-12)


def test_a_free_joint_without_inertia_is_named():
    bare = {"name": "spit", "length": 1.0, "section": {"rhoA": 1.0}, "joint": {"axes": ["x"]}}
    model = model_of(arm(bare))
    with pytest.raises(SingularError, match="spit"):
        natural_frequencies(model, joints="free")


def test_unknown_joints_are_refused():
    with pytest.raises(UsageError, match="locked or free"):
        natural_frequencies(model_of(ella()), joints="welded")


def test_joints_alone_leave_the_modes_at_zero():
    model = model_of(ella())
    alone, whole = (natural_frequencies(model, q, "free") for q in (SETPOINTS, posture(model)))
    assert np.array_equal(alone, whole)


@pytest.mark.parametrize("q", [[0.1], [0.1, np.nan, 0.0], "abc"])
def test_a_posture_of_another_length_or_without_numbers_is_refused(q):
    with pytest.raises(UsageError, match=r"^q: "):
        natural_frequencies(model_of(ella()), q)
