"""Vibrations and linear models of robots with floating bases: published beams, two bodies, differences on SE(3)."""

import numpy as np
import pytest
from floating_robots import SATELLITE, TAU, start
from helpers import arm, link, model_of
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

from screwgen import natural_frequencies
from screwgen.plotting.mode_plot import displaced
from screwgen.studies.convergence import convergence, enriched
from screwgen.studies.modes import mode_shapes

FREE = np.array([22.3733, 61.6728, 120.9034])
"""(βl)² of a beam without supports, in every handbook."""


def beam(modes: int):
    """A floating beam with EI = ρA = l = 1."""
    own = link("beam", 1.0, [], 1.0, {"bending_z": modes}, section={"EIy": 1.0, "rhoIp": 0.01})
    return model_of(arm(own, gravity=[0.0, 0.0, 0.0]) | {"base": "floating"})


def test_a_free_beam_has_the_published_frequencies():
    found = mode_shapes(beam(9))
    assert found.rigid == 6 and 2 * np.pi * found.frequencies[:2] == pytest.approx(FREE[:2], rel=1e-5)
    assert natural_frequencies(beam(3), joints="free")[:6].tolist() == [0.0] * 6


def test_one_more_mode_of_a_free_beam_is_what_a_model_with_one_more_mode_has():
    few = beam(3)
    now, then = natural_frequencies(few)[6:], natural_frequencies(type(few)(enriched(few.robot)))[6:9]
    assert convergence(few).total == pytest.approx(then / now - 1, abs=1e-9)


def test_two_bodies_on_a_spring_turn_against_each_other():
    """A hull and a rotor on an axis through both centres: `ω² = k (1/I + 1/J)`, wherever the hull is."""
    body = lambda i: {"at": "base", "mass": 5.0, "inertia": [i, i, i, 0.0, 0.0, 0.0]}  # noqa: E731
    links = [{"name": "hull", "joint": {"axes": []}, "bodies": [body(2.0)]}]
    links += [{"name": "rotor", "joint": {"axes": ["z"], "stiffness": [6.0]}, "bodies": [body(0.5)]}]
    model = model_of(arm(*links, gravity=[0.0, 0.0, 0.0]) | {"base": "floating"})
    q = [1.0, 2.0, 3.0, *Rotation.random(random_state=1).as_quat(scalar_first=True), 0.3]
    found = mode_shapes(model, q, "free")
    assert found.rigid == 6 and 2 * np.pi * found.frequencies == pytest.approx([np.sqrt(6.0 * (1 / 2.0 + 1 / 0.5))])
    shape = found.shapes[:, 0] / found.shapes[-1, 0]
    assert shape == pytest.approx([0.0, 0.0, -0.2, 0.0, 0.0, 0.0, 1.0], abs=1e-12)
    assert len(natural_frequencies(model, q)) == 6  # locked: one rigid body


@pytest.fixture(scope="module")
def satellite():
    return model_of(SATELLITE)


def twist_matrix(x: np.ndarray) -> np.ndarray:
    """The matrix (4, 4) of a twist [angular; linear], whose exponential is a motion."""
    return np.block([[np.cross(np.eye(3), x[:3]), x[3:, None]], [np.zeros((1, 4))]])


def test_the_linear_model_is_that_of_differences(satellite):
    """In rotations and displacements along the axes of the moving hull, by differences along the group."""
    q, v = start(satellite)
    linear = satellite.linearise(q, v, TAU, outputs=["base_pose", "tip_position", "tip_velocity"])
    n, h, judge = satellite.nv, 1e-6, satellite.numpy()
    changed = lambda d: displaced(satellite, q, d)  # noqa: E731

    def tip(q, v) -> np.ndarray:
        twist = np.array(satellite.casadi()["tip_jacobian"](q, satellite.parameter_values)) @ v
        return np.concatenate([q[:7], judge.tip_pose(q)[1], twist[3:]])

    for k, e in enumerate(np.eye(n)):
        for column, near in ((k, lambda s, e=e: (changed(s * e), v)), (n + k, lambda s, e=e: (q, v + s * e))):
            ends = [near(s * h) for s in (1, -1)]
            slope = np.subtract(*(judge.forward_dynamics(*end, TAU, None)[0] for end in ends)) / (2 * h)
            assert np.allclose(linear.A[n:, column], slope, rtol=0, atol=1e-6 * np.max(np.abs(linear.A[n:])))
            slope = np.subtract(*(tip(*end) for end in ends)) / (2 * h)
            assert np.allclose(linear.C[:, column], slope, rtol=0, atol=1e-6)
    assert np.array_equal(linear.A[6:n], np.eye(2 * n)[n + 6 : 2 * n])
    # A neighbour whose twist differs drifts from the hull by what the two poses say, in axes of the hull.
    rng, t = np.random.default_rng(5), 1e-4
    delta, twist = 1e-4 * rng.normal(size=6), 1e-4 * rng.normal(size=6)
    near = expm(twist_matrix(delta))
    assert np.allclose(
        twist_matrix(np.array([1.0, 2.0, 3.0, 0.0, 0.0, 0.0]))[:3, :3] @ np.array([4.0, 5.0, 6.0]), [-3.0, 6.0, -3.0]
    )
    apart = expm(-t * twist_matrix(v[:6])) @ near @ expm(t * twist_matrix(v[:6] + twist)) - expm(twist_matrix(delta))
    rate = linear.A[:6] @ np.concatenate([delta, np.zeros(n - 6), twist, np.zeros(n - 6)])
    found = apart @ np.linalg.inv(near) / t
    assert np.allclose(found, twist_matrix(rate), rtol=0, atol=1e-7)


def test_names_units_and_the_point_of_a_floating_linear_model(satellite):
    q, v = start(satellite)
    linear = satellite.linearise(q, v, TAU, outputs=["joint_angles", "base_twist"])
    assert linear.state_names[:7] == (
        *(f"base.rotation_{axis}" for axis in "xyz"),
        *(f"base.displacement_{axis}" for axis in "xyz"),
        "left.joint[0]",
    )
    assert linear.state_units[:7] == (*["rad"] * 3, *["m"] * 3, "rad")
    n = satellite.nv
    assert linear.state_names[n : n + 6] == tuple(satellite.v_names[:6])
    assert linear.state_units[n : n + 6] == (*["rad/s"] * 3, *["m/s"] * 3)
    assert np.array_equal(linear.x, [*np.zeros(6), *q[7:], *v]) and linear.output_units[-1] == "m/s"
    assert np.array_equal(linear.y, [*q[7:11], *v[:6]])
    home = satellite.linearise([0.1, 0.2, 0.3, 0.4], outputs=["base_pose", "joint_angles"])  # the joints alone
    assert home.y.tolist() == [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.1, 0.2, 0.3, 0.4]
