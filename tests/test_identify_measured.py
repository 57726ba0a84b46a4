"""Identification of the measured arm of examples/quanser, from its maker's numbers."""

from pathlib import Path

import pytest

import screwgen
from screwgen.spec.columns import Columns, load_columns
from screwgen.spec.load import loads

FOLDER = Path(__file__).parent.parent / "examples" / "quanser"
ARM, CURRENTS = FOLDER / "arm.toml", FOLDER / "currents.npz"
DRIVES = ("*.coulomb", "*.viscous", "*.bend.*", "*.rotor_inertia", "current_1.gain")
LINKS = ("*.EIz", "*.damping.ratio", "blade2.bodies[0].mass", "gravity[0]", "gravity[1]")
FREE = (*DRIVES, *LINKS, "gauge*.offset")


def percent(explained, of):
    return [100 * x for x in explained.share(of).values()]


@pytest.fixture(scope="module")
def arm() -> screwgen.Model:
    return screwgen.derive(screwgen.load(ARM))


def test_currents_alone_predict_the_held_out_half(arm):
    """Eighteen numbers from 10 s: angles and gauges of the next 10 s, which are said to be much the same motion."""
    more = {"sensors": FOLDER / "sensors.toml", "held_out": f"{CURRENTS}@10:20"}
    found = screwgen.identify(arm, f"{CURRENTS}@0:10", free=FREE, **more)
    assert found.tried["iterations"] <= 10 and len(found.estimates) == 18
    held_out = found.explained[1]
    assert min(percent(held_out, "before")[2:]) < 0
    for of, least in ("whole", (99.8, 98.0, 98.5, 95.5)), ("windows", (99.9, 98.5, 98.8, 96.0)):
        assert all(x >= y for x, y in zip(percent(held_out, of), least, strict=True)), (of, percent(held_out, of))
    assert found["blade1.EIz"].value == pytest.approx(1.6, rel=0.1)
    assert found["blade2.EIz"].value == pytest.approx(0.29, rel=0.1)
    assert "@10:20, held out, repeats the fit: 100.0 %" in found.notes[-1] and len(found.notes) == 2
    assert found.notes[0].startswith("residuals of theta_1, theta_2, gauge_1, gauge_2 are no noise")


def test_joints_that_are_given_judge_the_blades_alone():
    """Two runs of steps without currents, another held out; what damps is the gears, not the blades, and it is said."""
    text = ARM.read_text().replace('axes = ["z"]\n', 'axes = ["z"]\nactuation = "motion"\n')
    model = screwgen.derive(loads(text, "arm.toml"))
    steps = [FOLDER / f"steps_{k}.npz" for k in (1, 2, 3)]
    free = ["*.EIz", "gauge*.offset", "gravity[0]", "gravity[1]"]
    found = screwgen.identify(model, steps[:2], free=free, sensors=FOLDER / "joints.toml", held_out=steps[2])
    assert min(percent(found.explained[2], "windows")) >= 98.0
    assert found["blade1.EIz"].value == pytest.approx(1.6, rel=0.1)
    assert found["blade2.EIz"].value == pytest.approx(0.29, rel=0.1)
    alone = screwgen.compare(model, steps[2], sensors=found.columns)[0]
    assert max(percent(alone, "windows")) < 90


def test_a_filter_that_is_taken_for_the_truth_is_suspected(arm):
    """The gauges as they were logged, their filter not stated: blades would damp as none does."""
    logged = load_columns(FOLDER / "logged.toml")
    silent = [{k: x for k, x in c.model_dump(exclude_unset=True).items() if k != "filter"} for c in logged.columns]
    free = [*DRIVES, *LINKS]
    found = screwgen.identify(arm, f"{CURRENTS}@0:4", free=free, sensors=Columns(columns=tuple(silent)))
    (note,) = (x for x in found.notes if "filter" in x)
    assert "blade1.damping.ratio damps" in note and "state its filter" in note
