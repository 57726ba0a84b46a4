"""Identification says what the data do not determine, and what is wrong with a log, in a line each."""

import json
from dataclasses import replace

import numpy as np
import pytest
from identified_arms import SENSORS, TRUE, elsewhere, logged, pendulum, swing, torque

import screwgen
from screwgen.errors import UsageError
from screwgen.identification.logs import Log
from screwgen.spec.columns import Column, Columns

DRIVE = ("rotor_inertia", "friction.coulomb", "friction.viscous")
ROTOR, COULOMB, VISCOUS = (f"rod.joint.drives[0].{x}" for x in DRIVE)
HEAVY = TRUE | {ROTOR: 1000.0, COULOMB: 1e-6, VISCOUS: 1e-6}
GIVEN = Columns(columns=SENSORS.columns[1:])
SIDE = Column(name="side", measures="strain[1]", unit="microstrain", numbers={"fibre": 0.01})
WEIGHED = "load the link along z with a known weight"
LEVEL = (0.0, 0.0, 0.0)
STEP, NOISE = 2e-3, 1e-3


def driven(model, controller, q0=0.0, seconds=1.5, noise=NOISE) -> Log:
    """A log of a pendulum that begins at rest."""
    return logged(model, controller, seconds, STEP, noise, q0=screwgen.equilibrium(model, q=[q0]).q)


def one_way():
    """A joint that turns one way, faster and faster."""
    model = pendulum(gravity=LEVEL)
    return model, driven(model, lambda t, q, v: np.array([2.0 + t]), noise=0.05).part(0.3, 1.5)


def steady():
    """A joint that turns at one rate."""
    model = pendulum(gravity=LEVEL)
    log = driven(model, lambda t, q, v: np.array([0.7 + 20 * (2.0 - v[0])]), seconds=2.5, noise=0.05)
    return model, log.part(1.5, 2.5)


def heavy():
    """A rotor beside which the rod is nothing."""
    model = pendulum(HEAVY, gravity=LEVEL)
    return model, driven(model, lambda t, q, v: np.array([600 * np.sin(4 * t) + 400 * np.sin(11 * t)]), noise=0.05)


def hanging():
    """A pendulum that swings about one posture, a little."""
    model = pendulum(actuation="motion")
    return model, driven(model, lambda t, q, v: np.array([0.16 * np.cos(4 * t)]), -0.6, noise=0.2)


def pulled():
    """A pendulum under one torque."""
    model = pendulum()
    return model, driven(model, lambda t, q, v: np.array([2.0]), -1.5, noise=0.01)


def bent():
    """A pendulum that is moved so slowly that it only bends: of twice the stiffness twice the scale reads the same."""
    model = pendulum(actuation="motion")
    slowly = lambda t, q, v: np.array([0.15 * np.sin(1.5 * t) ** 3])  # noqa: E731
    return model, driven(model, slowly, -0.6, 2.0, {"angle": 1e-6, "gauge": 0.2})


def swung():
    """A pendulum that does all that it can."""
    return pendulum(), swing(2.0, STEP, NOISE)


def across():
    """A pendulum that also bends across the plane of its swing, where nothing moves it and nothing reads it."""
    model = pendulum(across={"EIy": 30.0})
    return model, logged(model, torque, 2.0, STEP, 0.01, q0=(-1.5, 0.0, 0.0, 0.0))


def read_across():
    """It with a gauge there, which reads noise."""
    model, log = across()
    return model, replace(log, columns=log.columns | {"side": np.random.default_rng(2).standard_normal(len(log))})


UNDETERMINED = {
    "ratio": (heavy, ["motor.gain", ROTOR], f"{ROTOR} and motor.gain are known only as a ratio (+1.00)"),
    "scale": (swung, ["motor.gain", "*.EIz", ROTOR, COULOMB, VISCOUS, "*.mass", "rod.rhoA"], "can all grow together"),
    "gauge": (
        bent,
        ["rod.EIz", "gauge.scale"],
        "rod.EIz and gauge.scale are known only as a ratio (+0.95); log a free vib",
    ),
    "bias": (one_way, ["motor.bias", COULOMB], f"only together are known {COULOMB} and motor.bias"),
    "gain": (pulled, ["motor.gain", "motor.bias"], "only together are known motor.gain and motor.bias"),
    "trace": (swung, ["rod.EIz", "gravity[2]"], "gravity[2] leaves hardly a trace in the data; level the base"),
    "friction": (steady, [COULOMB, VISCOUS], f"{COULOMB} and {VISCOUS}"),
    "plane": (across, ["*.EIy", "*.EIz"], f"rod.EIy leaves hardly a trace in the data; {WEIGHED}"),
    "quiet": (read_across, ["*.EIy", "*.EIz"], f"rod.EIy leaves hardly a trace in the data; {WEIGHED}"),
    "tilt": (hanging, ["gravity[0]", "gauge.offset"], "only together are known gauge.offset and gravity[0]"),
}


@pytest.mark.parametrize("case", UNDETERMINED)
def test_what_the_data_do_not_determine_is_said(case):
    """One sentence each, and not all intervals claim to know these numbers."""
    make, free, words = UNDETERMINED[case]
    model, log = make()
    sensors = SENSORS if model.tau_names[0] == "rod.torque[0]" else GIVEN
    if "side" in log.columns:
        sensors = Columns(columns=(*sensors.columns, SIDE))
    found = screwgen.identify(model, log, free=free, sensors=sensors, window=0.5)
    (said,) = found.undetermined
    assert words in said
    assert not all(one.determined for one in found.estimates)


def test_numbers_that_are_hard_to_tell_apart_are_named_as_pairs():
    """The scale of a gauge and the stiffness of its rod; with one known the other's interval narrows."""
    (model, log), free = swung(), ["rod.EIz", "gauge.scale"]
    both, alone = (screwgen.identify(model, log, free=names, sensors=SENSORS, window=0.5) for names in (free, free[:1]))
    (pair,) = both.pairs
    assert {pair.first, pair.second} == set(free) and 0.7 < pair.correlation < 1 and not both.undetermined
    wide, narrow = (found["rod.EIz"].high - found["rod.EIz"].low for found in (both, alone))
    assert wide / narrow == pytest.approx(pair.better, rel=0.2)
    assert pair.remedy in both.report() and json.loads(both.to_json())["pairs"][0]["first"] == pair.first
    assert not alone.pairs and "hard to tell apart" not in alone.report()


# ------------------------------------------------------------------------------ logs


@pytest.fixture(scope="module")
def log() -> Log:
    return swing(1.0, STEP, NOISE)


def with_column(log, name, change):
    values = log.columns[name].copy()
    return replace(log, columns=log.columns | {name: change(values)})


def without_gauge(log):
    return replace(log, columns={name: log.columns[name] for name in ("angle", "motor")})


def put(at, value):
    def change(values):
        values[at] = value
        return values

    return change


WRONG = {
    "row 11: t is no finite number": lambda x: replace(x, t=put(10, np.nan)(x.t.copy())),
    "row 11: t is 0.018 s; it must be later than in the row before": lambda x: replace(x, t=put(10, 0.018)(x.t.copy())),
    "row 251: the step is 0.102 s, others are 0.002 s": lambda x: replace(x, t=x.t + 0.1 * (np.arange(len(x)) >= 250)),
    "row 11: motor is no finite number; an input must be known": lambda x: with_column(x, "motor", put(10, np.nan)),
    "gauge lacks 301 of 501 readings": lambda x: with_column(x, "gauge", put(slice(200, None), np.nan)),
    "gauge is 3 throughout and says nothing": lambda x: with_column(x, "gauge", put(slice(None), 3.0)),
    "has no column 'gauge'; it has angle, motor; wanted are motor, angle, gauge": without_gauge,
    "has 10 rows; 20 at least are needed": lambda x: Log(x.name, x.t[:10], {k: y[:10] for k, y in x.columns.items()}),
}


@pytest.mark.parametrize("fault", WRONG)
def test_a_log_that_cannot_be_used_gets_a_line(log, fault):
    with pytest.raises(UsageError) as caught:
        screwgen.identify(elsewhere(["rod.EIz"]), WRONG[fault](log), free=["rod.EIz"], sensors=SENSORS)
    assert str(caught.value).startswith(f"swing.csv: {fault}") and "\n" not in str(caught.value)


ODD = {
    "gauge lacks 2 of 501 readings; the others are used": ("gauge", put([5, 99], np.nan)),
    "readings of angle vary 0.0": ("angle", np.radians),
    "readings of gauge vary 0.00": ("gauge", lambda y: y / 1000),
    "gauge seems saturated at 1500": ("gauge", lambda y: np.minimum(y, 1500.0)),
}


@pytest.mark.parametrize("fault", ODD)
def test_a_log_that_is_odd_is_used_and_it_is_said(log, fault):
    """Missing readings, radians for degrees, a factor of 1000, a gauge at the end of its range."""
    odd = with_column(log, *ODD[fault])
    notes = screwgen.identify(pendulum(), odd, free=["rod.damping.ratio"], sensors=SENSORS, window=0.25).notes
    assert sum(fault in note for note in notes) == 1, notes


def test_a_file_without_a_column_is_named(tmp_path):
    path = tmp_path / "log.csv"
    path.write_text("t,angle\n0,1\n")
    with pytest.raises(UsageError) as caught:
        screwgen.identify(pendulum(), path, free=["rod.EIz"], sensors=SENSORS)
    said = "log.csv: has no column 'motor'; it has t, angle; wanted are t, motor, angle, gauge: name them so"
    assert said in str(caught.value)


CELLS = {
    "row 3: motor is no finite number; an input must be known at every sample": {3: "0.004,1.0,2.0,stopped"},
    "row 1: t is no finite number; give every row its time": {1: "s,deg,microstrain,Nm"},
    "row 2 has 3 columns, the head 4; give every row as many, and write decimals with points": {2: "0.002,1.0,2.0"},
    "row 1 has 8 columns, the head 4; give every row as many, and write": {1: "0,002,1,0,2,0,3,0"},
}


@pytest.mark.parametrize("fault", CELLS)
def test_a_cell_that_is_no_number_is_named(fault, log, tmp_path):
    """Text where a number lacks, a row of units, a row that is cut off, decimals with commas."""
    path, table = tmp_path / "log.csv", np.column_stack([log.t, *(log.columns[x] for x in ("angle", "gauge", "motor"))])
    rows = ["t,angle,gauge,motor", *(",".join(f"{x:.9g}" for x in row) for row in table[:60])]
    for row, text in CELLS[fault].items():
        rows[row] = text
    path.write_text("\n".join(rows))
    with pytest.raises(UsageError) as caught:
        screwgen.identify(pendulum(), path, free=["rod.EIz"], sensors=SENSORS)
    assert str(caught.value).startswith(f"{path}: {fault}") and "\n" not in str(caught.value)


@pytest.mark.parametrize("factor", [57.2958, 1e-3])
def test_an_input_in_another_unit_is_suspected(log, factor):
    """Also if its gain is free, and where what is free could make good for it."""
    other = with_column(log, "motor", lambda y: factor * y)
    notes = screwgen.identify(pendulum(), other, free=["*.coulomb"], sensors=SENSORS, window=0.5, iterations=2).notes
    (note,) = (x for x in notes if "motor" in x)
    assert note.startswith(f"swing.csv: {1 / factor:.3g} times motor explains the readings much better")
    free = screwgen.identify(pendulum(), log, free=["motor.gain"], sensors=SENSORS, window=0.5).notes
    assert not any("motor" in x for x in free)


def test_an_input_with_which_no_motion_lasts_is_suspected_in_the_refusal(log):
    """As torques in mN·m that are taken for N·m."""
    other = with_column(log, "motor", lambda y: 1e3 * y)
    with pytest.raises(UsageError, match=r"cannot be made: .*; swing.csv: 0.001 times motor explains .*: is its unit"):
        screwgen.identify(pendulum(), other, free="rod.damping.ratio", sensors=SENSORS, window=0.25)


def test_times_in_milliseconds_are_suspected(log):
    """Samples would be further apart than the arm vibrates."""
    with pytest.raises(UsageError, match=r"swing.csv: samples are 2 s apart, and the slowest .*: are times in ms\?"):
        screwgen.identify(pendulum(), replace(log, t=1e3 * log.t), free=["rod.EIz"], sensors=SENSORS)


def test_a_long_log_is_read_in_part(log, tmp_path, monkeypatch):
    """Rows are read in pieces, so that a file may be larger than what it says of a part."""
    from screwgen.identification import logs

    path = tmp_path / "long.csv"
    table = np.column_stack([log.t, *log.columns.values()])
    np.savetxt(path, table, "%.9g", ",", header=",".join(["t", *log.columns]), comments="")
    monkeypatch.setattr(logs, "CHUNK", 50)
    whole, part = (logs.read_log(path, SENSORS, span) for span in (None, (0.2, 0.4)))
    assert len(whole) == len(log) and whole.columns["gauge"] == pytest.approx(log.columns["gauge"], rel=1e-8)
    assert part.part(0.2, 0.4).t == pytest.approx(log.part(0.2, 0.4).t) and len(part) < 110
    monkeypatch.setattr(logs, "MOST_ROWS", 300)
    with pytest.raises(UsageError, match=r"long.csv: has more than 300 rows, .* name a part, as .*long.csv@0:10"):
        screwgen.identify(pendulum(), path, free=["rod.EIz"], sensors=SENSORS)
    assert len(logs.read_log(path, SENSORS, (0.2, 0.4))) == len(part)


def test_a_model_that_lacks_the_friction_of_the_data_is_not_trusted(log):
    """What is left is no noise, and that is said."""
    frictionless = pendulum(TRUE | {COULOMB: 1e-9, VISCOUS: 1e-9})
    found = screwgen.identify(frictionless, log, free=["rod.EIz", ROTOR], sensors=SENSORS, window=0.25)
    (note,) = found.notes
    assert "residuals of angle, gauge are no noise" in note and min(found.whiteness.values()) > 0.9
    assert all(one.lacking and one.interval.endswith("if the model lacks nothing") for one in found.estimates)
