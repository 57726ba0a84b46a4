"""What filters measure: every sensor by its name, against functions of the robot, differences and the textbook."""

from functools import cache

import numpy as np
import pytest
from floating_robots import rod
from helpers import QUICK, arm, link, model_of
from scipy.spatial.transform import Rotation
from sensors import strains

from screwgen import UsageError
from screwgen.algorithms.measurement_names import measurement
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.cli.main import main
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator

SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
TENDON = [{"name": "cable", "at": [[0.0, 0.01, 0.02], [0.0, 0.01, 0.02]]}]
CYLINDER = {"transmission": {"crank": 0.4, "base": 1.2, "angle": -1.5}}
LUG = [{"name": "lug", "at": 0.4}]
ROBOTS = {
    "crane": arm(
        link("boom", 1.0, "y", markers=LUG, tendons=TENDON, joint={"drives": [CYLINDER]}, **SOFT),
        link("hand", 0.5, "z"),
    ),
    "free": {
        "name": "free",
        "gravity": [0.0, 0.0, -2.0],
        "links": [rod("arm", ["y"]), rod("fore", "ball", markers=LUG)],
    },
}
SENSORS = {
    "crane": (
        "cylinder_length tendon_length strain strain@boom.lug gyro@boom.lug accelerometer@boom.lug marker_range "
        "marker_position@hand.tip marker_velocity@hand.tip marker_attitude@boom.lug marker_range@hand.tip acceleration "
        "point_position@hand.tip"
    ).split(),
    "free": (
        "gyro@fore.lug accelerometer@arm.tip marker_position@fore.tip marker_velocity@fore.lug"
        " marker_attitude@fore.lug marker_range@fore.lug point_position@fore.lug"
    ).split(),
}


@cache
def model(name):
    return model_of(ROBOTS[name])


@cache
def state(name):
    robot, rng = model(name), np.random.default_rng(3)
    sizes = np.where(np.arange(robot.nv) < robot.chain.eta_v, 0.4, 4e-3)
    q = np.array(robot.chain.integrate(np.array(robot.chain.home), sizes * rng.uniform(0.3, 1.0, robot.nv), SERIES))
    return q, sizes * rng.normal(size=robot.nv), rng.normal(size=robot.n_tau), 0.1 * rng.normal(size=(robot.n_links, 6))


def value(robot, name, q, v, tau, w_ext) -> np.ndarray:
    """What a sensor reads by the functions of the robot; of an attitude the rotation."""
    f, (kind, _, place) = robot.numpy(), name.partition("@")
    if kind == "strain":
        found = dict(zip(robot.strain_names, f.strain(q), strict=True))
        section = f"{place}.strain.bending" if place else "base_strain.bending"
        return -0.02 * np.array([x for key, x in found.items() if section in key])
    if kind == "acceleration":
        return f.accelerometer(q, v, tau, w_ext)[-1]
    at = robot.marker_names.index(place) if place else slice(None)
    if kind in ("gyro", "marker_velocity"):
        return getattr(f, kind)(q, v)[at]
    if kind == "accelerometer":
        return f.accelerometer(q, v, tau, w_ext)[at]
    if kind == "marker_range":  # every number that a sensor has is 0.02
        return np.linalg.norm(np.atleast_2d(f.marker_pose(q)[1][at]) - 0.02, axis=1)
    if kind == "point_position":
        R, r = f.marker_pose(q)
        return r[at] + R[at] @ np.full(3, 0.02)
    if kind.startswith("marker"):
        return f.marker_pose(q)[kind == "marker_position"][at]
    return getattr(f, kind)(q)


@pytest.mark.parametrize(("name", "sensor"), [(name, x) for name in SENSORS for x in SENSORS[name]])
def test_a_row_says_what_the_function_says_and_its_slopes_are_differences(name, sensor):
    robot, (q, v, tau, w_ext) = model(name), state(name)
    e, nv = Estimator(robot, measurements=[sensor]), robot.nv
    fibres = [number.name for row in e.measurements for number in row.numbers if number.stated]
    e.start(q, v, 1.0, 1.0, Noise(0.0, sensors=dict.fromkeys(fibres, 0.02)))
    (row,), read = e.measurements, lambda q, v: value(robot, sensor, q, v, tau, w_ext)
    here, turned = read(q, v), row.group == 3
    told = Rotation.from_matrix(here).as_quat(scalar_first=True) * -2.0 if turned else here
    H, rest = e.compared(row, told, tau, w_ext)
    assert np.max(np.abs(rest)) < 1e-12 * max(1.0, np.max(np.abs(here)))

    def at(u):
        found = read(np.array(robot.chain.integrate(q, u[:nv], SERIES)), v + u[nv:])
        return Rotation.from_matrix(here.T @ found).as_rotvec() if turned else found

    sizes = np.tile(np.where(np.arange(nv) < robot.chain.eta_v, 2e-3, 4e-5), 2)
    thirds = [(8 * (at(u) - at(-u)) - at(2 * u) + at(-2 * u)) / 12 for u in np.diag(sizes)]
    slopes = [x / h for x, h in zip(thirds, sizes, strict=True)]
    assert np.max(np.abs(H - np.transpose(slopes))) < 1e-8 * max(1.0, np.max(np.abs(H)))


def test_an_attitude_of_a_marker_is_off_by_twice_the_vector_part():
    robot, (q, v, tau, w_ext) = model("crane"), state("crane")
    e, turn = Estimator(robot, measurements=["marker_attitude@boom.lug"]), np.array([0.5, -1.1, 0.7])
    e.put(q, v, np.eye(2 * robot.nv))
    R = Rotation.from_matrix(robot.numpy().marker_pose(q)[0][robot.marker_names.index("boom.lug")])
    told = (R * Rotation.from_rotvec(turn)).as_quat(scalar_first=True)
    size = np.linalg.norm(turn)
    for sign in (1.0, -3.0):
        rest = e.compared(e.measurements[0], sign * told, tau, w_ext).rest
        assert np.allclose(rest, 2 * np.sin(size / 2) * turn / size, rtol=1e-12)


# ------------------------------------------------------------------------------ both filters


def begun(kind, robot, noise, measurements, start):
    e = kind(robot, measurements=measurements, **({"flags": QUICK} if kind is CompiledEstimator else {}))
    e.start(*start, 1e-2, 1e-1, noise)
    return e


FILTERS = [CompiledEstimator, Estimator]
SOME = ["encoder", "strain@boom.lug", "gyro@boom.lug calibrated", "cylinder_length gated", "marker_attitude@boom.lug"]


def test_both_filters_are_told_of_scales_offsets_and_own_gates():
    """A reading that is scaled and shifted is as the plain one with its noise; a gate of its own refuses alone."""
    robot, (q, v, tau, w_ext) = model("crane"), state("crane")
    noise = {"encoder": 1e-3, "strain_boom_lug": 1e-5, "fibre_boom_lug": 0.02, "cylinder_length": 1e-4}
    noise |= {"gyro_boom_lug": 2e-2, "gyro_boom_lug_scale": 2.0, "gyro_boom_lug_offset": [0.1, 0.2, 0.3]}
    noise |= {"marker_attitude_boom_lug": 1e-2, "cylinder_length_gate": 3.0}
    filters = [begun(kind, robot, Noise(1.0, sensors=noise), SOME, (q, v)) for kind in FILTERS]
    turning = robot.numpy().gyro(q, v)[robot.marker_names.index("boom.lug")] + 0.05
    length, still = robot.numpy().cylinder_length(q), Rotation.from_matrix(robot.numpy().marker_pose(q)[0][-2])
    for e in filters:
        e.update(tau, w_ext, gyro_boom_lug=2 * turning + np.array([0.1, 0.2, 0.3]), cylinder_length=length + 1.0)
        assert e.innovations["gyro_boom_lug"].value == pytest.approx([0.1] * 3)
        assert e.innovations["cylinder_length"].refused.all() and e.consistency.entries == 3
    plain = begun(Estimator, robot, Noise(1.0, gyro_boom_lug=1e-2), ["gyro@boom.lug"], (q, v))
    plain.update(tau, w_ext, turning)
    for e in filters:
        assert np.allclose(np.concatenate(e.state), np.concatenate(plain.state), rtol=1e-12, atol=1e-14)
        e.update(tau, w_ext, marker_attitude_boom_lug=-still.as_quat(scalar_first=True), strain_boom_lug=[1e-4, -2e-4])
    assert np.allclose(*(np.concatenate(e.state) for e in filters), rtol=1e-9, atol=1e-12)
    assert filters[0].consistency.squared == pytest.approx(filters[1].consistency.squared, rel=1e-9)


@pytest.mark.parametrize("axis", range(3))
def test_a_marker_upside_down_is_a_false_sample_of_its_own(axis):
    """Half a turn and nearly so: refused, and what else was measured counts."""
    robot, given = model("crane"), state("crane")
    q, v, tau, w_ext = given
    still = Rotation.from_matrix(robot.numpy().marker_pose(q)[0][-2])
    noise = Noise(1.0, gate=5.0, encoder=1e-3, marker_attitude_boom_lug=1e-2)
    for kind in FILTERS:
        for angle in (np.pi, np.pi - 1e-9, -np.pi + 1e-5, 3.0):
            e = begun(kind, robot, noise, ["marker_attitude@boom.lug", "encoder"], (q, v))
            turned = still * Rotation.from_rotvec(angle * np.eye(3)[axis])
            e.update(tau, w_ext, turned.as_quat(scalar_first=True), q[: robot.n_joints] + 1e-4)
            found = e.innovations["marker_attitude_boom_lug"]
            assert found.refused.all() and e.consistency.entries == robot.n_joints
            expected = np.zeros(3)
            expected[axis] = 2 * np.sin(angle / 2)
            assert np.allclose(np.abs(found.value), np.abs(expected), atol=1e-7)


def test_both_filters_find_a_tip_by_its_range_from_a_beacon():
    """Beacon and range come by the names in C; the estimate goes to where the beacon sees the tip."""
    robot, (q, v, tau, w_ext) = model("crane"), state("crane")
    beacon, tip = np.array([2.5, -0.4, 0.8]), robot.marker_names.index("hand.tip")
    far = lambda q: np.linalg.norm(robot.numpy().marker_pose(q)[1][tip] - beacon)  # noqa: E731
    noise = Noise(1e-3, marker_range_hand_tip=1e-5, marker_range_hand_tip_beacon=beacon)
    filters = [begun(kind, robot, noise, ["marker_range@hand.tip"], (q, v)) for kind in FILTERS]
    for e in filters:
        for _ in range(3):
            e.update(tau, w_ext, marker_range_hand_tip=[far(q) + 1e-3])
        assert far(e.state[0]) == pytest.approx(far(q) + 1e-3, abs=1e-5)
    assert np.allclose(*(np.concatenate(e.state) for e in filters), rtol=1e-11, atol=1e-13)


@pytest.mark.parametrize("kind", FILTERS)
def test_the_normalised_innovation_squared_is_the_textbooks(kind):
    """Of all entries of an update together, whose innovations depend on each other: ν S⁻¹ ν."""
    robot, (q, v, tau, w_ext) = model("crane"), state("crane")
    noise = Noise(1.0, encoder=1e-3, strain=1e-5, acceleration=0.1, fibre=0.02)
    e, judge = begun(kind, robot, noise, None, (q, v)), Estimator(robot)
    P, told = e.covariance, {"encoder": q[:2] + 2e-3, "strain": strains(robot, q, 0.02) + np.full(2, 3e-5)}
    told["acceleration"] = robot.numpy().accelerometer(q, v, tau, w_ext)[-1] + 0.4
    judge.start(q, v, 1.0, 1.0, noise)
    e.update(tau, w_ext, **told)
    rows = [judge.compared(measurement(robot.chain, name), np.array(x), tau, w_ext) for name, x in told.items()]
    H, rest = np.vstack([x.H for x in rows]), np.concatenate([x.rest for x in rows])
    R = np.repeat([1e-3, 1e-5, 0.1], [2, 2, 3]) ** 2
    assert e.consistency.squared == pytest.approx(rest @ np.linalg.solve(H @ P @ H.T + np.diag(R), rest), rel=1e-6)
    assert e.consistency.entries == 7


@pytest.mark.parametrize("kind", FILTERS)
def test_it_shows_a_payload_that_nobody_told(kind):
    """A beam that carries 100 kg more than its model knows: hundreds of times the mean of the right model, one."""
    payload = lambda mass: [{"at": "tip", "mass": mass}]  # noqa: E731
    light, heavy = (model_of(arm(link("a", 1.0, "z", bodies=payload(m)))) for m in (1.0, 101.0))
    still, rng, means = np.zeros((1, 6)), np.random.default_rng(0), []
    for truth in (light, heavy):
        vdot = truth.numpy().forward_dynamics([0.0], [0.0], [20.0], still)[0][0]
        e, found = begun(kind, light, Noise(1e-4, encoder=1e-5), ["encoder"], ([0.0], [0.0])), []
        for k in range(1, 101):
            e.predict([20.0], still, 1e-3)
            e.update([20.0], still, [vdot * (1e-3 * k) ** 2 / 2 + 1e-5 * rng.normal()])
            found.append(e.consistency.squared / e.consistency.entries)
        means.append(np.mean(found))
    assert means[0] < 1.5 and means[1] > 300


# ------------------------------------------------------------------------------ what is none


WRONG = [
    ("gyroo", "there is no measurement 'gyroo'; .*did you mean 'gyro'"),
    ("gyro@boom.hook", "gyro@boom.hook: there is no marker 'boom.hook'; choose boom.tip or boom.lug or hand.tip"),
    (
        "encoder@boom.lug",
        "at markers there is no measurement 'encoder'; choose .*strain",
    ),
    ("strain@hand.tip", "strain@hand.tip: nothing bends there; choose a marker along a link that bends"),
    ("base_rate", "base_rate: robot 'arm' has a fixed base; leave it out"),
    ("gyro calibrate", "gyro calibrate: there is no option 'calibrate'; choose calibrated or gated"),
    ("marker_attitude calibrated", "marker_attitude: an attitude has neither scale nor offset; leave 'calibrated' out"),
    ("", "a measurement has no name"),
    (None, "measurements: there are none; name one at least, such as 'encoder'"),
]


@pytest.mark.parametrize(("asked", "said"), WRONG)
def test_a_name_that_is_none_is_refused_in_a_line(asked, said):
    with pytest.raises(UsageError, match=f"^{said}"):
        Estimator(model("crane"), measurements=[asked] if asked is not None else [])


@pytest.mark.parametrize("kind", FILTERS)
def test_values_by_position_are_those_of_the_measurements_in_order(kind):
    robot, (q, v, tau, w_ext) = model("crane"), state("crane")
    noise = Noise(1.0, encoder=1e-3, cylinder_length=1e-3)
    e = begun(kind, robot, noise, ["cylinder_length", "encoder"], (q, v))
    e.update(tau, w_ext, robot.numpy().cylinder_length(q), q[:2])
    assert all(np.max(np.abs(x.value)) < 1e-14 for x in e.innovations.values()) and e.consistency.entries == 3
    for values, named in (([[0.1], q[:2], [0.0]], {}), ([[0.1]], {"cylinder_length": [0.1]})):
        with pytest.raises(UsageError, match=r"^update: more values .* in order they are cylinder_length, encoder$"):
            e.update(tau, w_ext, *values, **named)


def test_the_command_line_names_measurements(tmp_path):
    from screwgen import dump

    (tmp_path / "crane.toml").write_text(dump(model("crane").robot))
    asked = ["--measure", "encoder", "--measure", "gyro@boom.lug calibrated"]
    command = ["generate", str(tmp_path / "crane.toml"), "-o", str(tmp_path / "o"), "--target", "c", "-q", *asked]
    assert main(command) == 0
    header = (tmp_path / "o" / "c" / "arm_estimator.h").read_text()
    assert "arm_real gyro_boom_lug_scale[3]; /* factor of readings */" in header and "has_strain" not in header
