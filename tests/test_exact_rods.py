"""Rods of order "exact": their limits, and what they keep."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from helpers import arm, link, model_of, quick, relative
from oracle import Oracle
from scipy.integrate import solve_ivp

from screwgen import Screw
from screwgen.bodies.collocation import collocation

# ------------------------------------------------------------------------------------ small bends

ALL = {"axial": 1, "bending_y": 2, "bending_z": 2, "torsion": 1, "shear_y": 1, "shear_z": 1}
SECTION = {"EIy": 3.0, "EIz": 2.0, "GAy": 1e3, "GAz": 1e3}
SCALE = np.array([0.3, 1.0, 0.3, 0.8, 0.2, 1.0, 0.3, 0.2])
"""Modal coordinates of `ALL` in the proportions of a bent link."""


@cache
def rod(order, basis: str, points=None, gravity=(0.0, 0.0, -9.81)):
    """A link with all directions flexible and a body at its tip."""
    modes = {"basis": basis, **ALL} | ({"points": points} if points else {})
    body = {"at": "tip", "mass": 0.7, "com": [0.1, 0.02, 0.03], "inertia": [0.02, 0.03, 0.04, 0.0, 0.0, 0.0]}
    table = link("rod", 0.8, "y", modes=modes, section=SECTION, bodies=[body])
    return model_of(arm(table, order=order, gravity=gravity)).numpy()


def straight(order, basis: str, points=None) -> tuple[np.ndarray, ...]:
    """At rest, straight, under weight and a torque: mass matrix, forces that hold it, and accelerations."""
    numeric, q = rod(order, basis, points), np.append(0.4, np.zeros(8))
    free = np.zeros((1, 6))
    held = numeric.inverse_dynamics(q, 0 * q, 0 * q, free)
    return numeric.mass_matrix(q), held, numeric.forward_dynamics(q, 0 * q, np.array([0.3]), free)[0]


def test_a_straight_rod_of_polynomials_is_that_of_order_1():
    """Mass matrix and forces to 1e-14; of the accelerations, which solve with that matrix, as its condition allows."""
    (M, held, vdot), (M1, held1, vdot1) = straight("exact", "polynomial"), straight(1, "polynomial")
    assert relative(M, M1) < 1e-14 and relative(held, held1) < 1e-14
    assert relative(vdot, vdot1) < np.finfo(float).eps * np.linalg.cond(M1)


def test_a_straight_rod_of_clamped_free_modes_tends_to_that_of_order_1():
    """Those shapes are no polynomials: each point takes the error of the mass matrix down, eight leave 1e-8."""
    errors = [relative(straight("exact", "clamped_free", n)[0], straight(1, "clamped_free")[0]) for n in (4, 6, 8)]
    assert errors[0] < 2e-3 and errors[1] < 1e-5 and errors[2] < 1e-8


def test_the_stiffness_of_a_straight_rod_is_that_of_order_1():
    """Without weight: the mass matrix times the slopes of the accelerations, as its condition allows."""
    q, found = np.append(0.4, np.zeros(8)), []
    for order in ("exact", 1):
        numeric = rod(order, "polynomial", gravity=(0.0, 0.0, 0.0))
        slope = numeric.derivatives(q, 0 * q, np.zeros(1), np.zeros((1, 6)))[0]
        found.append(numeric.mass_matrix(q) @ slope)
    assert relative(*found) < np.finfo(float).eps * np.linalg.cond(numeric.mass_matrix(q))


def test_weight_softens_a_straight_rod_as_at_order_2():
    """Central differences of the forces that hold the rod at rest."""
    q, steps, found = np.append(0.4, np.zeros(8)), 1e-5 * np.eye(9), []
    for order in ("exact", 2, 1):
        numeric = rod(order, "polynomial")
        held = lambda at, numeric=numeric: numeric.inverse_dynamics(at, 0 * q, 0 * q, np.zeros((1, 6)))  # noqa: E731
        found.append(np.array([held(q + e) - held(q - e) for e in steps]) / 2e-5)
    assert relative(found[0], found[1]) < 1e-8 < 1e-6 < relative(found[0], found[2])


def unlike(size: float) -> np.ndarray:
    """What orders exact and 2 differ by where bends and rates are so large: place (m) and turn of the tip, potential
    energy (J), torque of the joint (N m), forces of the modes (N, N m)."""
    q, v = np.append(0.4, size * SCALE), np.append(0.6, 0.8 * size * SCALE[::-1])
    exact, graded = (rod(order, "polynomial") for order in ("exact", 2))
    (R, r), (R2, r2) = exact.tip_pose(q), graded.tip_pose(q)
    forces = [x.inverse_dynamics(q, v, 0 * v, np.zeros((1, 6))) for x in (exact, graded)]
    apart = np.abs(forces[0] - forces[1])
    energies = [x.energy(q, v)[1] for x in (exact, graded)]
    return np.array(
        [np.abs(r - r2).max(), np.abs(R - R2).max(), abs(np.subtract(*energies)), apart[0], apart[1:].max()]
    )


def test_order_2_leaves_out_the_third_order():
    """Order 2 has the rows of twists to degree two, those of modes to degree one."""
    slopes = np.log2(unlike(0.02) / unlike(0.005)) / 2
    assert np.all(abs(slopes[:4] - 3) < 0.2) and abs(slopes[4] - 2) < 0.1


# ------------------------------------------------------------------------------------ large bends

SOFT = {"rhoA": 1.0, "EA": 400.0, "EIy": 2.0, "EIz": 1.0, "GJ": 1.0, "rhoIp": 0.02}
BENT = {"bending_y": 2, "bending_z": 2, "torsion": 1}
FREE = {"axes": [Screw(tuple(axis), turn=False, travel=1.0) for axis in np.eye(3).tolist()]}
"""The joint of a carriage that is free along the axes of the inertial frame."""


def in_space(gravity) -> dict:
    """Two soft rods, the first free in space on a light carriage about which it turns by yaw, pitch and roll."""
    more = {"section": SOFT, "modes": BENT, "order": "exact"}
    carriage = {"name": "carriage", "length": 0.1, "section": {"rhoA": 1e-9}, "joint": FREE}
    carriage["bodies"] = [{"at": "tip", "mass": 0.5}]
    hub = [{"at": "base", "mass": 0.3, "inertia": [0.03, 0.03, 0.02, 0.0, 0.0, 0.0]}]
    rods = link("first", 1.0, "zyx", bodies=hub, **more), link("second", 0.8, "y", **more)
    return arm(carriage, *rods, gravity=gravity)


@cache
def motion(gravity: tuple):
    """The oracle, the model, and q and v (samples, nq) of a second of motion from rods bent by more than a radian."""
    robot = in_space(gravity)
    model = model_of(robot)
    compiled, free = quick(model), (np.zeros(model.n_joints), np.zeros((model.n_links, 6)))
    slope = lambda _, x: np.append(x[model.nq :], compiled.forward_dynamics(*np.split(x, 2), *free)[0])  # noqa: E731
    eta = np.array([0.4, 0.03, 0.25, -0.02, 0.5, 0.2, -0.02, 0.3, 0.02, -0.4])
    q, v = np.concatenate([[0, 0, 0, 0.3, 0.4, -0.2, 0.5], eta]), np.zeros(model.nq)
    v[:7] = 0.3, -0.2, 0.1, 0.8, -0.5, 0.6, 0.7
    times = np.linspace(0, 1, 11)
    run = solve_ivp(slope, (0, 1), np.append(q, v), method="DOP853", rtol=1e-12, atol=1e-13, t_eval=times)
    assert run.success, run.message
    return Oracle(robot), model, *np.split(run.y.T, 2, axis=1)


def test_soft_rods_that_swing_keep_their_energy():
    _, model, q, v = motion((0.0, 0.0, -9.81))
    numeric = model.numpy()
    energies = np.array([numeric.energy(*at) for at in zip(q, v, strict=True)])
    total, most = energies.sum(axis=1), energies[:, 0].max()
    assert np.ptp(energies[:, 0]) > 0.1 * most and abs(total - total[0]).max() <= 1e-10 * most


@pytest.mark.long
def test_soft_rods_in_space_keep_their_momentum():
    """Linear and angular, summed by the oracle over the elements of the rods."""
    oracle, _, q, v = motion((0.0, 0.0, 0.0))
    momenta = [np.concatenate(oracle.momentum(*at)) for at in zip(q, v, strict=True)]
    assert abs(v - v[0]).max(axis=0).min() > 0.1
    for momentum in np.split(np.array(momenta), 2, axis=1):
        assert abs(momentum - momentum[0]).max() <= 1e-10 * np.linalg.norm(momentum[0])


def bends(rng, model, modes: dict, count: int) -> np.ndarray:
    """(count, nq): random shapes whose slopes in each plane, and twists, come up to 3 rad somewhere along the rod."""
    columns, places = [], tuple(np.linspace(0.0, 1.0, 21))
    for direction, n in modes.items():
        turned = model.chain.keys[0].shapes(direction).evaluate(places, 0 if direction == "torsion" else 1)
        eta = rng.normal(size=(count, n)) / (1.0 + np.arange(n)) ** 2
        most = abs(eta @ np.array(turned, float)).max(axis=1)
        columns.append(eta * (rng.uniform(0, 3, count) / most)[:, None])
    return np.hstack(columns)


TAPERED = {"uniform": (1.0, 1.0), "tapered": (1.0, 0.5), "stepped": (1.0, 0.4, 0.3)}
"""Masses per length at the stations 0, 0.3 and 1, or 0 and 1."""


@pytest.mark.parametrize("kind", TAPERED)
def test_weight_and_inertia_of_a_circle_converge_with_the_points(kind):
    """To those of the integrals along it: (sin ks)/k and (1 - cos ks)/k are where one mode puts its sections."""
    values, at = TAPERED[kind], [0.0, 1.0] if len(TAPERED[kind]) == 2 else [0.0, 0.3, 1.0]
    section = [{"at": s, "rhoA": m, "EIz": 1.0} for s, m in zip(at, values, strict=True)]
    table = {"name": "a", "length": 1.0, "order": "exact", "joint": {"axes": ["z"]}}
    table["section"] = {"rhoA": 1.0, "EIz": 1.0} if kind == "uniform" else section
    made = lambda n: model_of(arm(table | {"modes": {"bending_y": 1, "points": n}}, gravity=(0.0, -1.0, 0.0)))  # noqa: E731
    k, q = 6.0, np.zeros(2)
    q[1] = k / made(4).chain.keys[0].shapes("bending_y").evaluate([0.5], 2)[0][0]
    s, w = np.polynomial.legendre.leggauss(60)
    parts = [(a + (b - a) * (s + 1) / 2, (b - a) / 2 * w) for a, b in pairwise(at)]
    s, w = (np.concatenate(x) for x in zip(*parts, strict=True))
    dm = w * np.interp(s, at, values)
    weight, inertia = dm @ np.sin(k * s) / k, dm @ (2 - 2 * np.cos(k * s)) / k**2
    errors = []
    for n in (6, 12):
        numeric = made(n).numpy()
        held = numeric.inverse_dynamics(q, 0 * q, 0 * q, None)[0]
        errors.append((abs(held - weight) + abs(numeric.mass_matrix(q)[0, 0] - inertia)) / inertia)
    assert errors[0] < 2e-3 and errors[1] < 2e-8 and (kind == "stepped" or errors[1] < 1e-11)


def test_sections_turn_with_their_whole_inertia_where_it_has_a_kink_and_a_step():
    """Straight, an exact rod has the mass matrix of order 1, whose integrals along the stations are closed forms."""
    turned = {"rhoIp": 0.02, "rhoIy": 0.01, "rhoIz": 0.015}
    stiff = {"rhoA": 1.2, "EIy": 9.0, "EIz": 8.0, "GJ": 3.0}
    ends = ((0.0, 1.0), (0.3, 1.0), (0.3, 0.1), (1.0, 0.3))
    section = [{"at": s, **stiff, **{key: x * value for key, value in turned.items()}} for s, x in ends]
    modes = {"bending_y": 1, "bending_z": 1, "torsion": 1}
    table = {"name": "a", "length": 0.7, "section": section, "modes": modes, "joint": {"axes": ["z", "y", "x"]}}
    first, exact = (model_of(arm(table, order=order)).numpy().mass_matrix(np.zeros(6)) for order in (1, "exact"))
    assert np.max(np.abs(exact - first)) < 1e-14


@pytest.mark.parametrize("count", [20, 21, 40])
def test_a_uniform_rod_has_its_inertia_with_as_many_points_as_a_file_can_state(count):
    """That of the straight rod about its base is a third."""
    key = replace(model_of(arm(link(modes={"bending_y": 1}), order="exact")).chain.keys[0], points=count)
    assert np.sum(collocation(key).uniform.sum(axis=1) ** 2) == pytest.approx(1 / 3, rel=1e-12)


@pytest.mark.parametrize("count", [500, pytest.param(10_000, marks=pytest.mark.long)])
@pytest.mark.parametrize("kind", ["uniform", "stations"])
def test_the_mass_matrix_is_definite_at_any_bend(kind, count):
    """Its lowest eigenvalue, over that of the straight rod; rods on a clamp, whose slopes come up to 3 rad."""
    modes = {"bending_y": 3, "bending_z": 3, "torsion": 2}
    more = {"rhoIy": 1e-3, "rhoIz": 1e-3}
    stations = [{"at": s, **SOFT, **more, "rhoA": mass} for s, mass in ((0.0, 1.5), (0.4, 1.0), (1.0, 0.3))]
    table = link("rod", 1.0, [], modes=modes) | {"section": stations if kind == "stations" else SOFT | more}
    model = model_of(arm(table, order="exact"))
    compiled = quick(model)
    lowest = lambda q: np.linalg.eigvalsh(compiled.mass_matrix(q))[0]  # noqa: E731
    found = min(lowest(q) for q in bends(np.random.default_rng(5), model, modes, count))
    assert found > 0.01 * lowest(np.zeros(model.nq))
