"""A sensor that the product does not contain, in one row: the inclination of an axis of every marker, by atan2.

It is a function of the robot in every back end, an output of runs, mock-up units and linear models, and what filters
and searches are told. Its judge is the arc cosine.
"""

from dataclasses import replace
from functools import cache

import casadi as ca
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from fmi_units import Unit, written
from fmpy.validation import validate_fmu
from helpers import QUICK, arm, flat, link, model_of, quick, relative

import screwgen
from screwgen import Robot, RobotFileError, UsageError, dump
from screwgen.algorithms.marker_functions import PLACED
from screwgen.algorithms.measurement import AtMarkers, Measurement, SensorNumber, Told, atan2, root
from screwgen.backends.c.project import CProject
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.identification.logs import Log
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator
from screwgen.spec.columns import Column, Columns


def inclined(f, q, axis):
    """The angles from gravity to an axis of each marker, from 0 to half a turn."""
    R, g, out = f.marker_poses(q)[0], f.gravity, []
    for k in range(len(f.chain.markers)):
        own = axis[3 * k : 3 * k + 3]
        a = [sum(R[9 * k + 3 * i + j] * own[j] for j in range(3)) for i in range(3)]
        c = [a[1] * g[2] - a[2] * g[1], a[2] * g[0] - a[0] * g[2], a[0] * g[1] - a[1] * g[0]]
        out.append(atan2(root(sum(x * x for x in c)), sum(x * y for x, y in zip(a, g, strict=True))))
    return out


INCLINATION = Measurement(
    "inclination",
    "q",
    inclined,
    AtMarkers(),
    unit="rad",
    about="angle from gravity to an axis of the marker",
    algorithms=(PLACED,),
    numbers=(
        SensorNumber(
            "inclination_axis",
            lambda chain: 3 * len(chain.markers),
            "1: in the marker's axes",
            (1.0, 0.2, -0.3),
            role="axis",
        ),
    ),
    told=Told("angle", "angle from gravity to an axis of every marker", "What inclinometers at the markers read."),
    noise=2e-3,
)
AXIS = np.array([1.0, 0.2, -0.3])
G = np.array([0.0, -3.0, -6.0])
SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}


def robot(sensors=(INCLINATION,)) -> dict:
    upper = link("upper", 0.7, ("z", "y"), markers=[{"name": "box", "at": 0.5}], **SOFT)
    return arm(upper, link("fore", 0.4, "y", **SOFT), gravity=G, sensors=sensors) | {"name": "inclined"}


MODEL = model_of(robot())
POSTURES = [(0.4, 1.2, 0.3), (0.4, -1.2, 0.3), (2.0, 0.7, -2.2), (-2.5, -0.4, 2.9)]
"""In which the axes point upwards and downwards."""


def state(posture=POSTURES[0]):
    q, v = 0.01 * np.cos(np.arange(MODEL.nq)), 0.6 * np.cos(np.arange(MODEL.nv))
    q[:3] = posture
    return q, v, np.array([0.4, -0.3, 0.2]), np.zeros((MODEL.n_links, 6))


def judged(q, axis=AXIS, model=MODEL) -> np.ndarray:
    """By the arc cosine, of all markers."""
    R, down = model.numpy().marker_pose(q)[0], G / np.linalg.norm(G)
    return np.arccos(R @ axis @ down / np.linalg.norm(axis))


# -------- a function of the robot


@pytest.mark.parametrize("posture", POSTURES)
def test_every_back_end_has_the_function(posture):
    q = state(posture)[0]
    expected = judged(q)
    assert expected.shape == (3,) and np.ptp(expected) > 0.02
    with jax.enable_x64(True):
        in_jax = MODEL.jax()["inclination"](jnp.array(q), jnp.array(MODEL.parameter_values))
    found = {
        "NumPy": MODEL.numpy().inclination(q),
        "CasADi": flat(MODEL.casadi()["inclination"](q, MODEL.parameter_values)),
        "JAX": in_jax,
        "C, fused": quick(MODEL, layout="fused").inclination(q),
        "C, modular": quick(MODEL, layout="modular").inclination(q),
        "C, baked": quick(MODEL, parameters="baked").inclination(q),
    }
    assert all(np.abs(x - expected).max() < 1e-13 for x in found.values()), found
    assert np.abs(quick(MODEL, single=True).inclination(q) - expected).max() < 2e-6


def test_the_axes_point_both_ways():
    angles = np.array([judged(state(posture)[0]) for posture in POSTURES])
    assert (angles > np.pi / 2).any() and (angles < np.pi / 2).any()


SIZES = np.where(np.arange(MODEL.nv) < 3, 1e-3, 3e-5)


def slopes_of(at, sizes=SIZES) -> np.ndarray:
    """Differences of the fourth order, a column for each size."""
    thirds = [(8 * (at(u) - at(-u)) - at(2 * u) + at(-2 * u)) / 12 for u in np.diag(sizes)]
    return np.transpose([x / h for x, h in zip(thirds, sizes, strict=True)])


@pytest.mark.parametrize("posture", POSTURES)
def test_its_derivatives_are_differences(posture):
    """With coordinates in CasADi, JAX and the linear model, with parameters in NumPy and CasADi."""
    q, v, tau, _ = state(posture)
    p = np.array(MODEL.parameter_values)
    expected = slopes_of(lambda u: judged(q + u))
    x = ca.SX.sym("q", MODEL.nq)
    in_casadi = ca.Function("J", [x], [ca.jacobian(ca.vec(MODEL.casadi()["inclination"](x, p)), x)])(q).full()
    with jax.enable_x64(True):
        in_jax = jax.jacrev(MODEL.jax()["inclination"])(jnp.array(q), jnp.array(p))
    linear = MODEL.linearise(q, v, tau, outputs=["inclination", "joint_angles"])
    for found in (in_casadi, in_jax, linear.C[:3, : MODEL.nv]):
        assert np.abs(found - expected).max() < 1e-9
    assert not linear.C[:3, MODEL.nv :].any() and not linear.D.any()
    assert linear.output_names[:4] == (*(f"{m}.inclination.angle" for m in MODEL.marker_names), "upper.joint[0]")
    assert linear.output_units[:3] == ("rad",) * 3 and relative(linear.y[:3], judged(q)) < 1e-14
    alone = MODEL.linearise(q, v, tau, outputs="fore.tip.inclination")
    assert relative(alone.C, linear.C[[MODEL.marker_names.index("fore.tip")]]) < 1e-14
    k = [MODEL.parameter_names.index(name) for name in ("gravity[1]", "upper.length")]
    by_p = MODEL.numpy().inclination_by_p(q, of=[MODEL.parameter_names[i] for i in k])
    h = 1e-4 * p[k]
    other = lambda u: MODEL.numpy(p + u).inclination(q)  # noqa: E731
    full = np.zeros((2, len(p)))
    full[[0, 1], k] = h
    thirds = [(8 * (other(u) - other(-u)) - other(2 * u) + other(-2 * u)) / 12 for u in full]
    assert np.abs(by_p - np.transpose(thirds) / h).max() < 1e-9
    in_casadi = MODEL.casadi(by_p=["gravity[1]", "upper.length"])["inclination_by_p"](q, p)
    assert np.abs(np.array(in_casadi) - by_p).max() < 1e-12


def test_other_outputs_of_linear_models_stay():
    q, v, tau, _ = state()
    plain = model_of(robot(())).linearise(q, v, tau, outputs=["tip_acceleration", "modes", "upper.eta"])
    same = MODEL.linearise(q, v, tau, outputs=["tip_acceleration", "modes", "upper.eta"])
    assert plain.output_names == same.output_names and np.array_equal(plain.C, same.C)
    both = MODEL.linearise(q, v, tau, outputs=["gyro", "tip_velocity", "inclination", "accelerometer"])
    assert relative(both.y[:9], MODEL.numpy().gyro(q, v).ravel()) < 1e-13
    assert relative(both.y[9:12], MODEL.linearise(q, v, tau, outputs="tip_velocity").y) < 1e-13
    assert relative(both.y[15:], MODEL.numpy().accelerometer(q, v, tau).ravel()) < 1e-12


def test_runs_and_rollouts_have_it():
    q, v, *_ = state()
    run = screwgen.simulate(MODEL, 0.02, 1e-3, q0=q, v0=v)
    assert np.abs(run.inclination - [judged(x) for x in run.q]).max() < 1e-13
    many = screwgen.rollout(MODEL, np.r_[q, v], step=1e-3, steps=20)
    assert np.abs(many.inclination[0] - [judged(x) for x in many.q[0]]).max() < 1e-13
    with pytest.raises(AttributeError, match="'Run' has no attribute 'inclinations'"):
        _ = run.inclinations
    with pytest.raises(AttributeError, match="'Rollout' has no attribute 'inclinations'"):
        _ = many.inclinations


@pytest.mark.parametrize(("target", "kind"), [("fmu2", "me"), ("fmu3", "cs")])
def test_mock_up_units_have_it(target, kind):
    assert validate_fmu(str(written(target, robot, True)[1])) == []
    unit = Unit(target, kind, robot, True).ready()
    q, v, *_ = state()
    unit.set(dict(zip(unit.states, [*q, *v], strict=True))) if kind == "me" else None
    q = q if kind == "me" else unit.get(unit.model.q_names)
    names = [f"{marker}.inclination.angle" for marker in MODEL.marker_names]
    assert np.abs(unit.get(names) - judged(q)).max() < 1e-13
    assert {x.unit for x in unit.description.modelVariables if x.name in names} == {"rad"}
    assert not [x for x in Unit(target, kind, robot).references if "inclination" in x]


# -------- what a filter is told

FILTERS = [CompiledEstimator, Estimator]
NAMES = ["encoder", "inclination@fore.tip calibrated", "inclination"]


def begun(kind, noise, measurements, posture=POSTURES[0]):
    e = kind(MODEL, measurements=measurements, **({"flags": QUICK} if kind is CompiledEstimator else {}))
    q, v, *_ = state(posture)
    rigid = np.arange(MODEL.nv) < MODEL.chain.eta_v
    e.start(q, v, np.where(rigid, 0.03, 1e-4), np.where(rigid, 0.1, 1e-3), noise)
    return e


@pytest.mark.parametrize("posture", POSTURES)
def test_its_row_is_the_difference_of_what_it_measures(posture):
    q, _, tau, w_ext = state(posture)
    e = begun(Estimator, Noise(0.0), ["inclination"], posture)
    found = e.compared(e.measurements[0], np.zeros(3), tau, w_ext)
    assert np.abs(found.rest + judged(q)).max() < 1e-14
    at = lambda u: judged(np.array(MODEL.chain.integrate(q, u, SERIES)))  # noqa: E731
    assert np.abs(found.H[:, : MODEL.nv] - slopes_of(at)).max() < 1e-9
    assert not found.H[:, MODEL.nv :].any()


@pytest.mark.parametrize("posture", POSTURES)
def test_both_filters_take_it(posture):
    """NumPy and C to 1e-12, with axes of their own at one marker; the noise of the rest is that of the row."""
    place, axis = MODEL.marker_names.index("fore.tip"), np.array([0.1, 0.9, 0.4])
    noise = {"encoder": 1e-2, "inclination_fore_tip": 1e-3, "inclination_fore_tip_offset": 0.05}
    noise |= {"inclination_fore_tip_axis": axis}
    filters = [begun(kind, Noise(1e-3, 1e-6, sensors=noise), NAMES, posture) for kind in FILTERS]
    q, _, tau, w_ext = state(posture)
    true = q + np.where(np.arange(MODEL.nq) < 3, [0.02, -0.01, 0.03, 0.0, 0.0, 0.0, 0.0], 0.0)
    told, own = judged(true), judged(true, axis)[place] + 0.05
    for _ in range(3):
        for e in filters:
            e.predict(tau, w_ext, 1e-4)
            e.update(tau, w_ext, inclination_fore_tip=[own], inclination=told)
        (a, b), (c, d) = (e.state for e in filters)
        assert relative(np.r_[a, b], np.r_[c, d]) < 1e-12
        assert relative(filters[0].covariance, filters[1].covariance) < 1e-9
    assert filters[0].innovations["inclination"].normalised == pytest.approx(
        filters[1].innovations["inclination"].normalised, rel=1e-6
    )
    left = judged(filters[1].state[0]) - told
    assert np.abs(left).max() < 0.3 * np.abs(judged(q) - told).max()


def test_generated_c_starts_with_the_numbers_of_the_row():
    files = CProject(MODEL.chain, "0", estimator=NAMES).files()
    source, header = files["inclined_estimator.c"], files["inclined_estimator.h"]
    for k, x in enumerate([1, 0.2, -0.3] * 3):
        assert f"e->inclination_axis[{k}] = {x if x == 1 else f'INCLINED_REAL({x})'};" in source
    assert "e->inclination_variance[k] = INCLINED_REAL(4e-06);" in source and "e->encoder_variance[k] =" not in source
    assert "e->inclination_fore_tip_variance[k] =" not in source
    assert "inclination_axis[9]; /* 1: in the marker's axes; 1, 0.2, -0.3 by init */" in header
    assert "inclination_variance[3]; /* rad^2; 4e-06 by init */" in header
    assert "for scales, which are 1, what is said to be otherwise by init, the patience" in header
    plain = CProject(MODEL.chain, "0", estimator=["encoder"], outputs=True).files()
    assert (
        "by init, the" not in plain["inclined_estimator.h"] and "inclined_inclination(" in plain["inclined_sensors.h"]
    )


# -------- identification


@cache
def swing(mass=0.6):
    rod = link("rod", 1.0, "y", section={"rhoA": 0.5}, bodies=[{"at": "tip", "mass": mass}], joint={"damping": [0.05]})
    return model_of(arm(rod, gravity=(0.0, 0.0, -9.81), sensors=(INCLINATION,)))


def test_an_offset_and_a_mass_are_found_again():
    """In degrees, off by three of them, beside an encoder; the search begins without an offset, with less mass."""
    run = screwgen.simulate(swing(), 2.0, 2e-3, q0=[0.4], controller=lambda t, q, v: [3 * np.sin(4 * t)])
    true = np.degrees(run.inclination[:, 0]) + 3.0
    measured = true + 0.02 * np.random.default_rng(1).normal(size=len(true))
    encoder = run.q[:, 0] + 1e-3 * np.random.default_rng(2).normal(size=len(true))
    columns = Columns(
        columns=(
            Column(name="motor", drives="rod.torque[0]"),
            Column(name="encoder", measures="rod.joint[0]"),
            Column(name="box", measures="inclination@rod.tip", unit="deg", numbers={"axis": tuple(AXIS)}),
        )
    )
    log = Log("log", run.t, {"motor": run.tau[:, 0], "box": measured, "encoder": encoder})
    found = screwgen.identify(swing(0.4), log, free=["box.offset", "rod.bodies[0].mass"], sensors=columns)
    for name, value in (("box.offset", 3.0), ("rod.bodies[0].mass", 0.6)):
        assert found[name].value == pytest.approx(value, rel=2e-3) and found[name].low < value < found[name].high
    assert not found.notes


# -------- what is none


def test_what_is_said_wrongly_of_it_is_refused_in_a_line():
    given = robot(())
    for sensors, said in (
        ((3.0,), r"sensors\[0\]: is 3.0; it must be a screwgen.algorithms.measurement.Measurement"),
        ((INCLINATION, INCLINATION), r"sensors\[1\]: is called .*inclination.* again; take another name"),
        ((replace(INCLINATION, name="my tilt"),), r"sensors\[0\]: is called .*my tilt.*; take a name of letters"),
    ):
        with pytest.raises(RobotFileError, match=said):
            Robot(**given | {"sensors": sensors})
    with pytest.raises(UsageError, match="sensors are objects made in Python; a robot file cannot state them"):
        dump(MODEL.robot)
    q = state()[0]
    for name, told, said in (
        ("gyro", INCLINATION.told, "sensors: 'gyro' is a function that the product has; take another name"),
        (
            "tilt",
            INCLINATION.told._replace(c_file="outputs"),
            "tilt: what runs report at every sample is the product.s own",
        ),
    ):
        model = model_of(robot((replace(INCLINATION, name=name, told=told),)))
        with pytest.raises(UsageError, match=said):
            getattr(model.numpy(), name)(q)
    with pytest.raises(UsageError, match="sensors: 'encoder' is a sensor that the product has; take another name"):
        Estimator(model_of(robot((replace(INCLINATION, name="encoder", told=None),))), measurements=["gyro"])
    modes = model_of(robot((replace(INCLINATION, name="modes"),)))
    with pytest.raises(UsageError, match="sensors: 'modes' is a group of outputs of linear models; take another name"):
        modes.linearise(q)
    odd = replace(INCLINATION, numbers=(replace(INCLINATION.numbers[0], start=(1.0,) * 7),))
    with pytest.raises(UsageError, match="inclination_axis: starts as 7 numbers, and there are 9; start one, or each"):
        model_of(robot((odd,))).numpy().inclination(q)
    with pytest.raises(AttributeError, match="'Numeric' has no attribute 'inclination'"):
        model_of(given).numpy().inclination(q)
