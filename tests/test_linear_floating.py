"""Vibrations and linear models of robots with floating bases: published beams, two bodies, differences on SE(3)."""

import numpy as np
import pytest
from floating_robots import SATELLITE, TAU, start
from helpers import arm, link, model_of
from scipy.spatial.transform import Rotation

from screwgen import UsageError, natural_frequencies
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


def two_bodies(first, second: object, mass=5.0, other=2.0, stiffness=80.0) -> dict:
    """Two bodies of which one slides along the other, with a spring between them."""
    bodies = [{"at": "base", "mass": m, "inertia": [0.1, 0.1, 0.1, 0.0, 0.0, 0.0]} for m in (mass, other)]
    links = [
        {"name": "hull", "joint": {"axes": []}, "bodies": bodies[:1]},
        {"name": "bob", "parent": "hull", "joint": {"axes": [{"slide": "x"}]}, "bodies": bodies[1:]},
    ]
    spring = {"name": "strut", "between": [first, second], "line": {"stiffness": stiffness, "rest": 0.3}}
    return {"name": "pair", "base": "floating", "gravity": [0.0, 0.0, 0.0], "links": links, "forces": [spring]}


def test_two_bodies_on_a_spring_swing_about_their_centre_of_mass():
    """With the stiffness k and the reduced mass m1 m2 / (m1 + m2); the other six motions are rigid."""
    model = model_of(two_bodies("hull.tip", "bob.tip"))
    q = np.append(model.chain.home[:7], 0.3)
    found = mode_shapes(model, q, "free")
    assert found.rigid == 6 and not found.growth.any()
    assert np.allclose(2 * np.pi * found.frequencies, np.sqrt(80.0 * (1 / 5.0 + 1 / 2.0)), rtol=1e-9)


def test_a_spring_to_the_world_pulls_a_base_that_floats():
    model = model_of(two_bodies({"world": [1.0, 0.2, 0.0]}, "bob.tip"))
    with pytest.raises(UsageError, match="'pair' has a floating base, which forces between it and the world pull"):
        mode_shapes(model, np.append(model.chain.home[:7], 0.3), "free")
