"""Rods that are curved and twisted at rest, beside Castigliano's beams, rings and springs; what holds of any rod."""

from functools import cache

import numpy as np
import pytest
from helpers import arm, link, model_of, quick, relative
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import screwgen
from screwgen.backends.numpy.rest_shape import section_at_rest
from screwgen.paper.printed import PrintedModel
from screwgen.plotting import mode_plot
from screwgen.spec.load import loads
from screwgen.studies.modes import mode_shapes

UNIT = {"rhoA": 1.0, "EIy": 1.0, "EIz": 1.0, "GJ": 0.8, "rhoIp": 1e-2}
NONE = (0.0, 0.0, 0.0)
QUARTER = np.pi / 2


@cache
def quarter():
    """A clamped quarter of a circle of unit radius, from x to y."""
    return rod(QUARTER, {"bending_y": 4, "bending_z": 4, "torsion": 4}, {"bending_y": 1.0})


def rod(length: float, modes: dict, rest, axes=(), gravity=NONE, **more):
    """A rod of unit stiffness."""
    table = link("rod", length, list(axes), modes=modes, section=UNIT, rest=rest, **more)
    return model_of(arm(table, gravity=gravity, order="exact"))


def compliance(model, load: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Displacement and turn of the tip, (3,) each, by a unit of a small force and moment there, (6,) in world axes."""
    numeric, still, h = model.numpy(), np.zeros(model.nq), 1e-5
    R, _ = numeric.tip_pose(still)
    turned = np.concatenate([R.T @ load[:3], R.T @ load[3:]])[None]
    ends = []
    for size in (h, -h):
        q = screwgen.equilibrium(model, still, w_ext=size * turned).q
        ends.append(numeric.tip_pose(q))
    (R1, r1), (R2, r2) = ends
    return (r1 - r2) / (2 * h), Rotation.from_matrix(R1 @ R2.T).as_rotvec() / (2 * h)


# ------------------------------------------------------------------------------- arcs, rings, springs

ARC = {  # of a unit force at the tip of a quarter of a circle of unit radius, from x to y
    "out of the plane": ([0, 0, 1], {2: QUARTER / 2 + (3 * QUARTER / 2 - 2) / 0.8}),
    "towards the centre": ([0, 1, 0], {0: 0.5 - 1.0, 1: 3 * QUARTER / 2 - 2}),
    "along the base": ([1, 0, 0], {0: QUARTER / 2, 1: 0.5 - 1.0}),
}
"""Castigliano: bending sin t and torsion 1 - cos t out of the plane; bending 1 - sin t and cos t in it."""


@pytest.mark.parametrize("way", ARC)
def test_a_quarter_of_a_circle_is_that_of_castigliano(way):
    """In one piece, to 0.01 %."""
    force, wanted = ARC[way]
    model = quarter()
    assert model.numpy().tip_pose(np.zeros(12))[1] == pytest.approx([1.0, 1.0, 0.0], abs=1e-9)
    moved, turned = compliance(model, np.array([0, 0, 0, *force], float))
    for axis, value in wanted.items():
        assert moved[axis] == pytest.approx(value, rel=1e-4)
    if way == "out of the plane":  # by a unit moment at the tip about x, which bends as cos t and twists as sin t
        about_x, _ = compliance(model, np.array([1.0, 0, 0, 0, 0, 0]))
        assert turned[0] == pytest.approx(about_x[2], rel=1e-4)
        assert turned[0] == pytest.approx(0.5 + (1 - 0.5) / 0.8, rel=1e-4)


def test_a_pinched_ring_gives_way_as_published():
    """A load P across a ring that loops close: P R^3/EI (pi/4 - 2/pi) along it, P R^3/EI (2/pi - 1/2) across."""
    ring = link("ring", 2 * np.pi, [], modes={"bending_y": 4}, section=UNIT, rest={"bending_y": 1.0}, segments=4)
    post = link("post", 1.0, [], parent="world")
    robot = arm(ring, post, gravity=NONE, order="exact")
    robot["loops"] = [{"between": ["ring.tip", "post.base"], "joint": {"axes": []}}]
    model, load = model_of(robot), np.zeros((6, 6))
    numeric, h, ends = model.numpy(), 1e-4, []
    across = numeric.tip_poses(np.zeros(model.nq))
    for size in (h, -h):
        load[1, 3:] = across[0][1].T @ [0.0, size, 0.0]
        ends.append(
            numeric.tip_poses(screwgen.equilibrium(model, np.zeros(model.nq), w_ext=load[: model.n_links]).q)[1]
        )
    moved = (ends[0] - ends[1]) / (2 * h)
    assert moved[1][1] == pytest.approx(np.pi / 4 - 2 / np.pi, rel=1e-4)
    assert moved[0][0] - moved[2][0] == pytest.approx(-(2 / np.pi - 0.5), rel=1e-4)


@pytest.mark.parametrize("degrees", [3.0, 20.0])
def test_a_helical_spring_has_its_published_stiffness(degrees):
    """Four turns of one piece, loaded along its axis: L R^2 (cos^2/GJ + sin^2/EI) by its pitch angle.

    Of small pitch angles that is the one of close coils, 2 pi n R^3/GJ.
    """
    pitch, turns, radius = np.radians(degrees), 4, 0.5
    length = 2 * np.pi * turns * radius / np.cos(pitch)
    rest = {"bending_y": np.cos(pitch) ** 2 / radius, "torsion": np.sin(pitch) * np.cos(pitch) / radius}
    model = rod(length, {"bending_y": 1, "torsion": 1}, rest)
    axis, centre = np.array([np.sin(pitch), 0.0, np.cos(pitch)]), np.array([0.0, radius, 0.0])
    R, r = model.numpy().tip_pose(np.zeros(2))
    assert r == pytest.approx(2 * np.pi * turns * radius * np.tan(pitch) * axis, abs=1e-6)
    lever = R @ centre
    load = np.concatenate([np.cross(lever, axis), axis])
    moved, turned = compliance(model, load)
    found = (moved + np.cross(turned, lever)) @ axis
    assert found == pytest.approx(length * radius**2 * (np.cos(pitch) ** 2 / 0.8 + np.sin(pitch) ** 2), rel=1e-4)
    close = 2 * np.pi * turns * radius**3 / 0.8
    assert abs(found / close - 1) < pitch**2


# ------------------------------------------------------------------------------------ any curved rod

MODES = {"bending_y": 2, "bending_z": 2, "torsion": 1}
STATIONS = [
    {"at": 0.0, "bending_y": 0.5, "bending_z": -0.4, "torsion": 0.6},
    {"at": 1.0, "bending_y": 1.4, "bending_z": 0.9, "torsion": -0.8},
]
RAMP = [{"at": 0.0, "bending_y": 0.0}, {"at": 0.5, "bending_y": 0.0}, {"at": 0.5, "bending_y": 2.0}]
RAMP += [{"at": 1.0, "bending_y": 1.0}]


def centreline(rest: list, length: float, s: float) -> tuple[np.ndarray, np.ndarray]:
    """Rotation and place of the section at s, by a solver of R' = R hat(kappa), r' = R e_x."""
    at = [x["at"] for x in rest]
    of = lambda name, s: np.interp(s, at, [x.get(name, 0.0) for x in rest])  # noqa: E731

    def slope(s, y):
        R, kappa = y[:9].reshape(3, 3), np.array([of("torsion", s), -of("bending_z", s), of("bending_y", s)])
        return length * np.append(R @ np.cross(np.eye(3), kappa), R[:, 0])  # rows e_i x kappa: hat(kappa)

    start = np.append(np.eye(3), np.zeros(3))
    y = solve_ivp(slope, (0, s), start, method="DOP853", rtol=1e-12, atol=1e-13, max_step=0.01).y[:, -1]
    return y[:9].reshape(3, 3), y[9:]


@pytest.mark.parametrize("rest, segments, bound", [(STATIONS, 1, 3e-5), (STATIONS, 3, 1e-6), (RAMP, 2, 1e-9)])
def test_stations_put_the_tip_where_their_curvature_leads(rest, segments, bound):
    """A step is exact where segments meet; twist beside bending is so to the order of turns between points."""
    model = rod(0.8, MODES, rest, segments=segments)
    R, r = model.numpy().tip_pose(np.zeros(model.nq))
    wanted = centreline(rest, 0.8, 1.0)
    assert np.abs(R - wanted[0]).max() < bound and np.abs(r - wanted[1]).max() < bound


def test_rest_is_rest():
    """Without loads nothing accelerates, strains and energy are zero, wherever the joints are."""
    model = rod(0.8, MODES, STATIONS, axes="zy")
    numeric, q = model.numpy(), np.array([0.4, -0.7, 0, 0, 0, 0, 0])
    vdot, wrench = numeric.forward_dynamics(q, 0 * q, np.zeros(2), None)[:2]
    assert np.abs(vdot).max() < 1e-13 and np.abs(wrench).max() < 1e-13
    assert not np.any(numeric.strain(q)) and np.allclose(numeric.energy(q, 0 * q), 0.0, atol=1e-15)


def test_a_rest_of_zero_is_a_straight_rod():
    """The same functions, at any bend."""
    zero = {"bending_y": 0.0, "bending_z": 0.0, "torsion": 0.0}
    rng, found = np.random.default_rng(1), []
    q, v, tau = 0.2 * rng.normal(size=7), rng.normal(size=7), rng.normal(size=2)
    for rest in (None, zero, [{"at": s, **zero} for s in (0.0, 0.4, 1.0)]):
        numeric = rod(0.8, MODES, rest, axes="zy", gravity=(0, 0, -9.81)).numpy()
        parts = (numeric.mass_matrix(q), *numeric.forward_dynamics(q, v, tau, None), *numeric.tip_pose(q))
        found.append(np.concatenate([np.ravel(x) for x in parts]))
    assert relative(found[1], found[0]) < 1e-13 and relative(found[2], found[0]) < 1e-13


def test_numbers_at_rest_are_parameters():
    """Those of the file, or others at run time: the robot is that whose file has them."""
    one, other = ([{**x, "bending_y": x["bending_y"] + more} for x in STATIONS] for more in (0.0, 0.2))
    model, wanted = (rod(0.8, MODES, rest, axes="zy", gravity=(0, 0, -9.81)) for rest in (one, other))
    q, v = 0.1 * np.ones(7), np.linspace(-1, 1, 7)
    p = np.array(model.parameter_values)
    p[[k for k, name in enumerate(model.parameter_names) if name.endswith("].bending_y")]] += 0.2
    found = model.numpy(p).inverse_dynamics(q, v, 0 * v, None)
    assert relative(found, wanted.numpy().inverse_dynamics(q, v, 0 * v, None)) < 1e-13
    assert "rod.rest[1].torsion" in model.parameter_names


def test_a_curved_rod_that_swings_keeps_its_energy():
    """Half a second from a bend of a radian, by a solver of high order."""
    model = rod(0.8, MODES, STATIONS, axes="zy", gravity=(0, 0, -9.81))
    compiled, tau = quick(model), np.zeros(2)
    slope = lambda _, x: np.append(x[7:], compiled.forward_dynamics(x[:7], x[7:], tau, None)[0])  # noqa: E731
    start = np.zeros(14)
    start[[0, 2, 4, 6, 7]] = 0.3, 0.3, 0.2, 0.4, 1.0
    run = solve_ivp(slope, (0, 0.5), start, method="DOP853", rtol=1e-11, atol=1e-12, t_eval=np.linspace(0, 0.5, 6))
    energies = np.array([model.numpy().energy(x[:7], x[7:]) for x in run.y.T])
    total = energies.sum(axis=1)
    assert np.ptp(energies[:, 0]) > 0.1 and np.abs(total - total[0]).max() < 1e-9 * energies[:, 0].max()


def test_what_a_curved_rod_carries_sits_on_its_curve():
    """A link on a station, a marker, and the section that pictures use are one place and one rotation."""
    table = link("rod", 0.8, [], modes=MODES, section=UNIT, rest=STATIONS, markers=[{"name": "eye", "at": 0.3}])
    model = model_of(arm(table, link("arm", 0.2, [], parent="rod", at={"s": 0.3}), order="exact"))
    R, r = model.numpy().link_pose(np.zeros(model.nq))
    turn, place = section_at_rest(model.chain.keys[0], 0.8, model.robot.links[0].rest.numbers, 0.3)
    wanted = centreline(STATIONS, 0.8, 0.3)
    assert np.abs(R[1] - turn).max() < 1e-14 and np.abs(r[1] - place).max() < 1e-14
    assert np.abs(turn - wanted[0]).max() < 1e-4 and np.abs(place - wanted[1]).max() < 1e-4


def test_a_curved_rod_that_can_only_stretch_turns_what_it_carries():
    """No mode turns its sections, the shape at rest does: a quarter of a circle, twisted by 0.3 rad before its end."""
    wire = {**link("wire", QUARTER, ["z"], section=UNIT | {"EA": 50.0}, rest={"bending_y": 1.0}), "modes": {"axial": 1}}
    twisted = {**link("twisted", 0.6, [], section=UNIT | {"EA": 50.0}, rest={"torsion": 0.5}), "modes": {"axial": 1}}
    model = model_of(arm(wire, twisted, gravity=NONE, order="exact"))
    R, r = model.numpy().tip_pose([0.0] * model.nq)
    assert np.abs(R - Rotation.from_euler("ZX", [QUARTER, 0.3]).as_matrix()).max() < 1e-14
    assert np.abs(r - [1.0, 1.6, 0.0]).max() < 1e-7  # of the Gauss points
    spin, _ = model.numpy().tip_pose([0.4] + [0.0] * (model.nq - 1))
    assert np.abs(spin - Rotation.from_euler("z", 0.4).as_matrix() @ R).max() < 1e-14


@pytest.mark.parametrize(
    "does, said",
    [
        (lambda robot: robot.without("bending_y", "bending_z", "torsion"), "would be straight without modes"),
        (lambda robot: screwgen.write_sid(robot.links[0], "rod.sid"), "data of straight rods alone are written"),
        (lambda robot: PrintedModel(robot), "the paper's links are straight at rest"),
    ],
)
def test_what_knows_straight_links_alone_says_so(does, said):
    robot = rod(0.8, MODES, STATIONS, axes="z").robot
    assert robot.without("torsion").links[0].rest == robot.links[0].rest
    with pytest.raises(screwgen.UsageError, match=said) as error:
        does(robot)
    assert "\n" not in str(error.value)


def test_shapes_of_modes_are_drawn_across_the_curve():
    """Of a quarter of a circle, whose tip lies across its base: no square is without a side."""
    model = rod(QUARTER, {"bending_y": 1, "bending_z": 1, "torsion": 1}, {"bending_y": 1.0})
    found = mode_shapes(model, np.zeros(3))
    with np.errstate(all="raise"):
        assert mode_plot.png(model, np.zeros(3), found).startswith(b"\x89PNG")


@pytest.mark.parametrize("rest", [{"bending_y": 0.5}, STATIONS, RAMP])
def test_a_file_that_is_written_is_the_same_robot(rest):
    robot = rod(0.8, MODES, rest, segments=2).robot
    assert loads(screwgen.dump(robot), "arm.toml", ".") == robot
