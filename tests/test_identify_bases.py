"""Identification of robots whose base moves as a log says, or floats where loops close."""

from dataclasses import replace

import numpy as np
import pytest
from helpers import arm, model_of
from test_identify_loops import Held

import screwgen
from screwgen.errors import UsageError
from screwgen.identification.beside import cases_of
from screwgen.identification.logs import Log
from screwgen.spec.columns import Column, Columns

STEP = 2e-3
TRUE = {"rod.EIz": 30.0, "rod.bodies[0].mass": 0.4, "rod.joint.damping[0]": 0.1}
OFF = (1.3, 0.7, 1.3)
AXES = ["x", "y", "z", "qw", "qx", "qy", "qz"]
GAUGE = Column(name="gauge", measures="strain[0]", unit="microstrain", numbers={"fibre": (0.01,)})
ENCODER = Column(name="angle", measures="rod.joint[0]", unit="deg")
POSE = tuple(Column(name=x, measures=f"base.{x}") for x in AXES)


def boat(values=TRUE, off=False, **keys) -> screwgen.Model:
    """A flexible rod with a mass at its tip that hangs from a mast and swings about the axis along the hull."""
    EI, mass, damping = (x * (factor if off else 1.0) for x, factor in zip(values.values(), OFF, strict=True))
    hull = {
        "name": "hull",
        "joint": {"axes": []},
        "bodies": [{"at": "base", "mass": 9.0, "inertia": [4, 9, 9, 0, 0, 0]}],
    }
    rod = {"name": "rod", "length": 1.2, "section": {"rhoA": 0.3, "EIz": EI}, "modes": {"bending_y": 1}}
    mount = {"xyz": [0.0, 0.0, 2.0], "rpy": [0.0, np.pi / 2, 0.0]}
    rod |= {"order": 2, "damping": {"ratio": 0.02}, "bodies": [{"at": "tip", "mass": mass}]}
    rod["joint"] = {"axes": ["z"], "mount": mount, "damping": [damping]}
    robot = arm({**hull, **keys}, rod, gravity=[0.0, 0.0, -9.81])
    return model_of(robot if keys else robot | {"base": "moving"})


def heave(t):
    return 0.3 * np.sin(1.5 * t) + 0.02 * np.sin(9.0 * t), 0.45 * np.cos(1.5 * t) + 0.18 * np.cos(9.0 * t)


def roll(t):
    return 0.5 * np.sin(2.0 * t) + 0.05 * np.sin(8.0 * t), np.cos(2.0 * t) + 0.4 * np.cos(8.0 * t)


@pytest.fixture(scope="module")
def log() -> Log:
    """Of the same arm on two axes of a fixed base, whose motion is given; the pose of the hull in closed form."""
    model = boat(joint={"axes": [{"slide": "z"}, "x"], "actuation": ["motion", "motion"]})
    curves = dict(zip(model.q_names[:2], (heave, roll), strict=True))
    run, rng = (
        screwgen.simulate(model, 4.0, STEP / 4, q0=[0.0, 0.0, 0.3, 0.0], motion=curves, every=4),
        np.random.default_rng(1),
    )
    turn, none = roll(run.t)[0] / 2, np.zeros(len(run.t))
    sign = np.where(run.t < 1.3, 1.0, -1.0)  # as an attitude reference may have it
    pose = [none, none, heave(run.t)[0], sign * np.cos(turn), sign * np.sin(turn), none, none]
    made = {"angle": np.degrees(run.q[:, 2]), "gauge": -0.01e6 * run.strain[:, 0]}
    noisy = {name: x + 0.01 * x.std() * rng.standard_normal(len(x)) for name, x in made.items()}
    noisy |= {name: x + 1e-5 * rng.standard_normal(len(x)) for name, x in zip(AXES, pose, strict=True)}
    return Log("boat.csv", run.t, noisy)


def test_a_base_moves_as_its_measured_pose_says(log):
    """Numbers are found within 1 %, damping within 5 %; poses are no readings that are compared."""
    columns = Columns(columns=(*POSE, ENCODER, GAUGE))
    found = screwgen.identify(boat(off=True), log, free=list(TRUE), sensors=columns)
    for name, true in TRUE.items():
        one = found[name]
        assert one.value == pytest.approx(true, rel=0.05 if "damping" in name else 0.01), name
        assert one.low < true < one.high, name
    whole = found.explained[0].share("whole")
    assert list(whole) == ["angle", "gauge"] and min(whole.values()) > 0.99
    assert not any("no column drives" in x and "twist_rate" in x for x in found.notes)


def test_windows_of_a_base_and_of_given_axes_begin_where_their_readings_are(log):
    """Every window has its own first sample."""
    columns = Columns(columns=(*POSE, ENCODER, GAUGE))
    model = boat()
    cases = cases_of(model, log, columns, 0.5, model.chain.parameters.values)
    assert not {*range(6), *range(model.nv, model.nv + 6)} & set(cases.states)
    for first, begin in zip(cases.first, cases.begin, strict=True):
        z, rate = heave(log.t[first])
        angle, turned = roll(log.t[first])
        assert begin.x[:3] == pytest.approx([0.0, 0.0, z], abs=3e-4)
        assert np.abs(begin.x[3:7]) == pytest.approx(np.abs([np.cos(angle / 2), np.sin(angle / 2), 0, 0]), abs=3e-4)
        along = [rate * np.sin(angle), rate * np.cos(angle)]  # in axes of the hull
        assert begin.x[model.nq : model.nq + 6] == pytest.approx([turned, 0, 0, 0, *along], abs=3e-3)
    other = boat(joint={"axes": [{"slide": "z"}, "x"], "actuation": ["motion", "motion"]})
    own = replace(log, columns=log.columns | {"up": heave(log.t)[0], "tilt": roll(log.t)[0]})
    moves = (Column(name=x, measures=y) for x, y in zip(("up", "tilt"), other.q_names[:2], strict=True))
    columns = Columns(columns=(*moves, ENCODER, GAUGE))
    cases = cases_of(other, own, columns, 0.5, other.chain.parameters.values)
    for first, begin in zip(cases.first, cases.begin, strict=True):
        (z, rate), (angle, turned) = heave(log.t[first]), roll(log.t[first])
        assert begin.x[:2] == pytest.approx([z, angle], abs=1e-3)
        assert begin.x[other.nq : other.nq + 2] == pytest.approx([rate, turned], abs=1e-3)


def test_a_part_of_a_pose_and_wrong_quaternions_get_a_line(log):
    def refused(columns, log=log):
        with pytest.raises(UsageError) as caught:
            screwgen.identify(boat(), log, free="rod.EIz", sensors=Columns(columns=columns))
        assert "\n" not in str(caught.value)
        return str(caught.value)

    some = refused((*POSE[:3], ENCODER, GAUGE))
    assert "of the base's pose columns measure base.x, base.y, base.z; measure all of base.x, " in some
    half = replace(log, columns=log.columns | {"qw": 0.5 * log.columns["qw"]})
    assert "boat.csv: row 1: the base has a quaternion (w, x, y, z) of length 0.5" in refused(
        (*POSE, ENCODER, GAUGE), half
    )
    gone = replace(log, columns=log.columns | {"z": np.where(log.t == log.t[7], np.nan, log.columns["z"])})
    assert "boat.csv: z moves the base and lacks readings" in refused((*POSE, ENCODER, GAUGE), gone)


def test_a_base_that_nothing_moves_is_said(log):
    found = screwgen.identify(boat(), log, free="rod.EIz", sensors=Columns(columns=(ENCODER, GAUGE)), iterations=1)
    assert any("no column drives" in x and "base.twist_rate[0]" in x for x in found.notes)


# ------------------------------------------------------------------------------ loops

LINKAGE = {"coupler.EIy": 150.0, "coupler.bodies[0].mass": 0.8, "hull.bodies[0].mass": 6.0}


def afloat(values=LINKAGE) -> screwgen.Model:
    """A four-bar linkage with a flexible coupler in the x-z plane, on a hull that floats; no weight."""
    EI, load, mass = values.values()
    hull = {"name": "hull", "joint": {"axes": []}}
    hull["bodies"] = [{"at": "base", "mass": mass, "inertia": [0.6, 0.6, 0.6, 0, 0, 0]}]
    bar = {"order": 1, "joint": {"axes": ["y"]}}
    crank = bar | {"name": "crank", "length": 0.3, "section": {"rhoA": 2.0}}
    crank["joint"] = {"axes": ["y"], "damping": [0.4], "armature": [0.02]}
    section, modes = {"rhoA": 0.6, "EIy": EI}, {"bending_z": 2}
    coupler = bar | {"name": "coupler", "length": 0.9, "section": section, "modes": modes, "damping": {"ratio": 0.02}}
    coupler["bodies"] = [{"at": "tip", "mass": load, "com": [-0.4, 0.0, 0.0]}]
    rocker = bar | {"name": "rocker", "length": 0.6, "section": {"rhoA": 1.2}, "parent": "hull"}
    rocker["joint"] = {"axes": ["y"], "mount": {"xyz": [0.8, 0.0, 0.0]}}
    hinge = {"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}
    return model_of(arm(hull, crank, coupler, rocker, gravity=[0.0, 0.0, 0.0]) | {"base": "floating", "loops": [hinge]})


def test_numbers_of_a_linkage_on_a_floating_base_are_found_again():
    """From 10 % off, each within 1 %. The crank alone is measured; it turns so far that other joints may fall over."""
    model, step = afloat(), 1e-3
    law = lambda t, q, v: np.array([4 * np.sin(5 * t) + 2 * np.sin(29 * t + 1) + 6 * (-0.4 - q[7]), 0.0, 0.0])  # noqa: E731
    near = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -0.4, *np.zeros(model.nq - 8)]
    q0 = screwgen.assemble(model, near, hold=["crank.joint[0]"])
    run = screwgen.simulate(model, 1.0, step / 4, q0=q0, controller=Held(law, step), integrator="rk4", every=4)
    rng = np.random.default_rng(1)
    made = dict(zip(AXES, run.q[:, :7].T, strict=True)) | {"angle": run.q[:, 7], "gauge": -0.01e6 * run.strain[:, 0]}
    noisy = {name: x + 0.01 * x.std() * rng.standard_normal(len(x)) for name, x in made.items()}
    log = Log("hull.csv", run.t, noisy | {"motor": run.tau[:, 0]})
    moved = [x for x in POSE if made[x.name].std() > 1e-6]
    crank = Column(name="angle", measures="crank.joint[0]")
    columns = Columns(columns=(Column(name="motor", drives="crank.torque[0]"), *moved, crank, GAUGE))
    start = afloat({name: x * off for (name, x), off in zip(LINKAGE.items(), (1.1, 0.9, 1.1), strict=True)})
    found = screwgen.identify(start, log, free=list(LINKAGE), sensors=columns, window=0.25, substeps=2)
    for name, true in LINKAGE.items():
        one = found[name]
        assert one.value == pytest.approx(true, rel=0.01), name
        assert abs(one.value - true) < one.high - one.low, name
    assert min(found.explained[0].share("windows").values()) > 0.99
