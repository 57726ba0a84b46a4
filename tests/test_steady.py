"""Vibrations about steady rotations and under gravity: published numbers, pendulums, and eigenvalues of `linearise`."""

import numpy as np
import pytest
import random_robots as rr
from helpers import arm, link, model_of

from screwgen import UsageError, natural_frequencies
from screwgen.studies.convergence import convergence
from screwgen.studies.modes import mode_shapes, movable
from screwgen.studies.steady import oscillations

SPEEDS = (0, 2, 4, 6, 8, 10, 12)
FLAP = (
    (3.51602, 4.13732, 5.58500, 7.36037, 9.25684, 11.20233, 13.17015),
    (22.03449, 22.61492, 24.27335, 26.80908, 29.99538, 33.64037, 37.60311),
)


def cantilever(modes: int, direction="bending_z"):
    """A rod of order 2 and of unit length, mass per length and stiffness on a hub that turns about z."""
    rod = link("rod", 1.0, "z", 1.0, {direction: modes}, section={"EIy": 1.0, "EIz": 1.0, "EA": 1e4})
    return model_of(arm(rod, gravity=(0, 0, 0), order=2))


@pytest.mark.parametrize("joints", ["locked", "free"])
def test_a_rotating_cantilever(joints):
    """Flapwise; a hub without inertia that is free to turn about its axis changes nothing."""
    flap = cantilever(8)
    for k, rate in enumerate(SPEEDS):
        found = mode_shapes(flap, joints=joints, rates=[rate])
        assert found.rigid == (joints == "free")
        assert np.allclose(2 * np.pi * found.frequencies[:2], [FLAP[0][k], FLAP[1][k]], rtol=2e-6, atol=0)


def test_lagwise_the_squared_frequency_is_less_by_the_squared_rate():
    flap, lag = (natural_frequencies(cantilever(3, d), rates=[12.0]) for d in ("bending_z", "bending_y"))
    assert np.allclose(lag**2, flap**2 - (12.0 / (2 * np.pi)) ** 2, rtol=1e-9)


def turning_arm(order: int):
    """A hub about z with an arm that leans out of its plane, offset tip mass: bending in two planes and torsion."""
    section = {"EIy": 30.0, "EIz": 50.0, "EA": 1e5, "GJ": 20.0, "rhoIp": 1e-4}
    modes = {"bending_y": 1, "bending_z": 1, "torsion": 1}
    body = {"at": "tip", "mass": 0.4, "com": [0.02, 0.05, -0.03], "inertia": [1e-3, 1e-3, 2e-3, 0.0, 0.0, 0.0]}
    first = link("inner", 0.8, "z", 0.5, modes, section=section, bodies=[body])
    second = link("outer", 0.6, "y", 0.4, modes, section=section)
    return model_of(arm(first, second, gravity=(0.0, 0.0, -9.81), order=order))


@pytest.mark.parametrize("order, loaded", [(1, False), (2, True)])
def test_eigenvalues_are_those_of_the_linear_model(order, loaded):
    """CasADi's derivatives of the accelerations, the joints' rows and columns left out, at the same steady state."""
    model, m = turning_arm(order), 2
    p = (
        np.array(model.parameter_values)
        * np.r_[(1.0 if loaded else 0.0) * np.ones(3), np.ones(len(model.parameter_values) - 3)]
    )
    rates, q = [4.0, 0.0], np.r_[0.3, 0.5, np.zeros(model.nq - m)]
    found = mode_shapes(model, q, rates=rates, loaded=loaded)
    about = found_at(model, q, rates, loaded)
    v = np.r_[rates, np.zeros(model.nq - m)]
    force = model.numpy(p).inverse_dynamics(about.q, v, np.zeros(model.nq), None)
    assert np.max(np.abs(force[m:])) < 1e-9 * np.max(np.abs(force))
    M = model.numpy(p).mass_matrix(about.q)
    A = model.linearise(about.q, v, force[:m], parameters=p).A
    K, C = (-(M @ A[model.nq :, part])[m:, m:] for part in (slice(0, model.nq), slice(model.nq, None)))
    n = len(K)
    state = np.block([[np.zeros((n, n)), np.eye(n)], [-np.linalg.solve(M[m:, m:], np.hstack([K, C]))]])
    poles = np.linalg.eigvals(state)
    expected = np.sort(poles.imag[poles.imag > 0])
    assert np.max(np.abs(poles.real)) < 1e-7 * expected[-1]
    assert np.allclose(2 * np.pi * found.frequencies, expected, rtol=1e-8)
    assert not found.growth.any() and found.shapes.shape == (model.nq, n)


def found_at(model, q, rates, loaded):
    from screwgen.studies.steady import steady

    values = np.array(model.parameter_values)
    return steady(model, q, rates, loaded, values, movable(model, "locked", q, values))


def test_without_rates_and_gravity_nothing_changes():
    model = turning_arm(1)
    q = [0.3, 0.5]
    for joints in ("locked", "free"):
        known = mode_shapes(model, q, joints)
        found = mode_shapes(model, q, joints, rates=[0.0, 0.0])
        assert found.rigid == known.rigid
        assert np.allclose(found.frequencies, known.frequencies, rtol=1e-8)
        signs = np.sign(np.sum(found.shapes * known.shapes, axis=0))
        assert np.allclose(found.shapes * signs, known.shapes, atol=1e-6 * np.max(np.abs(known.shapes)))


def test_a_hanging_rigid_pendulum_swings_and_a_standing_one_falls():
    rigid = {"name": "rod", "length": 1.0, "joint": {"axes": ["y"]}, "bodies": [{"at": "tip", "mass": 2.0}]}
    model = model_of({"name": "pendulum", "gravity": [-9.81, 0.0, 0.0], "links": [rigid]})
    standing = mode_shapes(model, [0.0], "free", loaded=True)
    assert standing.frequencies.tolist() == [0.0]
    assert standing.growth == pytest.approx([np.sqrt(9.81)], rel=1e-12)
    with pytest.raises(UsageError, match=r"1 of 1 vibrations grow, the fastest as exp\(3.132/s t\)"):
        natural_frequencies(model, [0.0], "free", loaded=True)
    hanging = natural_frequencies(model, [np.pi], "free", loaded=True)
    assert hanging == pytest.approx([np.sqrt(9.81) / (2 * np.pi)], rel=1e-12)


@pytest.mark.parametrize("critical, mass", [(7.837347, 0.0), (np.pi**2 / 4e6, 1e6)])
@pytest.mark.parametrize("share, grows", [(0.999, False), (1.001, True)])
def test_a_column_buckles_under_its_weight_and_under_a_load(critical, mass, share, grows):
    """ρA g l³/EI = 7.837347 is critical, or a mass on its tip of π²/4 EI/l²."""
    bodies = [{"at": "tip", "mass": mass}] if mass else None
    rod = link("column", 1.0, "y", 1.0, {"bending_z": 5}, bodies, section={"EIy": 1.0})
    model = model_of(arm(rod, gravity=(-critical * share, 0.0, 0.0), order=2))
    found = mode_shapes(model, loaded=True)
    assert bool(found.growth.any()) is grows
    still = mode_shapes(model).frequencies[0]
    assert max(found.frequencies[0], found.growth[0] / (2 * np.pi)) < 0.05 * still


def test_a_whirling_shaft_is_unstable_between_its_two_critical_speeds():
    """Two springs across the axis of a turning mass: k_y < mΩ² < k_z gives divergence in the turning frame."""
    M, G = np.eye(2), 2 * 3.0 * np.array([[0.0, -1.0], [1.0, 0.0]])
    found = oscillations(M, G, np.diag([4.0, 16.0]) - 9.0 * np.eye(2))
    # λ⁴ + (k_y + k_z − 2Ω² + 4Ω²) λ² + (k_y − Ω²)(k_z − Ω²) = 0
    squares = np.sort(np.roots([1.0, 20.0 + 18.0, -35.0]))
    assert found.omega == pytest.approx([0.0, np.sqrt(-squares[0])], rel=1e-12)
    assert found.growth == pytest.approx([np.sqrt(squares[1]), 0.0], rel=1e-12)
    beyond = oscillations(M, 5 / 3 * G, np.diag([4.0, 16.0]) - 25.0 * np.eye(2))
    assert not beyond.growth.any() and len(beyond.omega) == 2


def test_one_more_mode_converges_from_above():
    few, more = (cantilever(k) for k in (1, 2))
    first = [natural_frequencies(m, rates=[6.0])[0] for m in (few, more)]
    assert first[0] > first[1] > FLAP[0][SPEEDS.index(6)] / (2 * np.pi)
    told = convergence(few, rates=[6.0]).alone["bending_z"][0]
    assert told == pytest.approx(first[1] / first[0] - 1, rel=1e-6)


def test_what_is_not_steady_is_refused():
    model = turning_arm(1)
    with pytest.raises(UsageError, match="no steady motion at these rates; turn one joint about the vertical"):
        natural_frequencies(model, rates=[2.0, 1.0])
    with pytest.raises(UsageError, match="no steady motion"):
        natural_frequencies(model, rates=[0.0, 1.0], loaded=True)
    with pytest.raises(UsageError, match="rates: has 1 numbers; it must have 2"):
        natural_frequencies(model, rates=[2.0])


@pytest.mark.parametrize("seed", range(2))
def test_random_arms_under_gravity(seed):
    """The stiffness of loaded arms is the second derivative of their potential energy."""
    robot, state, _ = rr.draw_regular(np.random.default_rng(seed), limit=1e6, max_links=3)
    model = model_of(robot)
    about = found_at(model, state["q"], None, True)
    numeric, h = model.numpy(), 1e-4
    V = lambda q: numeric.energy(q, np.zeros(model.nq))[1]  # noqa: E731
    E = h * np.eye(model.nq)
    for a in range(model.nq):
        for b in range(a, model.nq):
            corners = [V(about.q + s * E[a] + t * E[b]) for s in (1, -1) for t in (1, -1)]
            second = (corners[0] - corners[1] - corners[2] + corners[3]) / (4 * h * h)
            scale = np.sqrt(abs(about.K[a, a] * about.K[b, b])) + abs(V(about.q))
            assert abs(second - about.K[a, b]) <= 1e-5 * scale


def test_a_soft_vibration_of_a_stiff_light_arm_is_no_rigid_motion():
    """A unit mass on a light beam that is 3e6 times as stiff along itself."""
    rod = link("rod", 1.0, "z", 1e-4, {"axial": 2, "bending_y": 3}, section={"EIz": 1e-3, "EA": 1e7})
    rod |= {"bodies": [{"at": "tip", "mass": 1.0}]}
    model = model_of(arm(rod, gravity=(0.0, 0.0, -9.81)))
    found = natural_frequencies(model, rates=[0.0])
    assert found[0] == pytest.approx(np.sqrt(3e-3) / (2 * np.pi), rel=1e-4)
    assert mode_shapes(model, joints="free", rates=[0.0]).rigid == 1
