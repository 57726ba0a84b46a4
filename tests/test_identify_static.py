"""Identification from static shapes: rows at rest in place of samples in time; numbers of the robot file."""

import re
from dataclasses import replace

import numpy as np
import pytest
from helpers import arm, model_of

import screwgen
from screwgen.cli.main import main
from screwgen.errors import UsageError
from screwgen.identification.logs import Log
from screwgen.spec.columns import Column, Columns, load_columns

LENGTH, EI, LOAD = 0.8, 6.0, 0.5
BEAM = """name = "beam"
gravity = [0.0, -9.81, 0.0]

[[links]]
name = "rod"
length = 0.8
order = 1
profile = { box = { height = 0.02, breadth = 0.002 }, E = 150e9, density = 2700.0 } # a guess
modes = { bending_y = 2 }
joint = { axes = ["z"] }
bodies = [{ at = "tip", mass = 0.3 }]
"""
TRUE = {"E": 70e9, "density": 2500.0}
COLUMNS = Columns(
    static=True,
    columns=(
        Column(name="angle", measures="rod.joint[0]", unit="deg"),
        *(Column(name=x, measures=f"marker_position@rod.tip[{k}]", unit="mm") for k, x in enumerate("xy")),
        Column(name="gauge", measures="strain[0]", unit="microstrain", numbers={"fibre": (0.001,)}),
    ),
)


def beam(E=150e9, density=2700.0):
    from screwgen.spec.load import loads

    return screwgen.derive(loads(BEAM.replace("150e9", repr(E)).replace("2700.0", repr(density)), "beam.toml"))


def rests(model, angles, noise=0.0) -> Log:
    """The tip and the gauge of a beam whose joint is held at angles."""
    rng, rows = np.random.default_rng(2), []
    for angle in angles:
        q = screwgen.equilibrium(model, q=[angle], hold=True).q
        strain = -0.001 * model.numpy().strain(q)[0]
        rows.append([np.degrees(angle), *(1e3 * model.numpy().tip_pose(q)[1][:2]), 1e6 * strain])
    table = np.array(rows)
    table[:, 1:] *= 1 + noise * rng.standard_normal((len(rows), 3))
    return Log("rests.csv", np.zeros(0), dict(zip(("angle", "x", "y", "gauge"), table.T, strict=True)))


def test_a_material_is_found_from_shapes_at_rest(tmp_path, capsys):
    """The joint is held where its encoder says; E and density follow from what sags, and stand in the profile."""
    log = rests(beam(**TRUE), np.radians(np.linspace(-70, 80, 12)), noise=1e-4)
    table = np.column_stack(list(log.columns.values()))
    robot, shapes, sensors, out = (tmp_path / x for x in ("beam.toml", "rests.csv", "sensors.toml", "out.toml"))
    robot.write_text(BEAM)
    np.savetxt(shapes, table, "%.6f", ",", header=",".join(log.columns), comments="")
    found = screwgen.identify(beam(), shapes, free=["*.E", "*.density"], sensors=COLUMNS, robot_file=robot)
    sensors.write_text(found.sensors_text())
    assert load_columns(sensors) == COLUMNS
    free = ["--free", "rod.profile.E", "--free", "rod.profile.density", "--sensors", str(sensors)]
    assert main(["identify", str(robot), f"{shapes}@0:9", "--check", f"{shapes}@9:12", "-o", str(out), *free]) == 0
    told = capsys.readouterr().out
    assert re.search(r"rests.csv@9:12 \(held out\), variance explained at rest: marker_position 100.0 %, strain", told)
    text = out.read_text()
    assert re.search(r"breadth = 0.002 }, E = [67]\S+, density = 2\S+ } # a guess; ± \S+; ± \S+$", text, re.M)
    for name, true in TRUE.items():
        one = found[f"rod.profile.{name}"]
        assert one.value == pytest.approx(true, rel=0.02) and abs(one.value - true) < one.high - one.low, name
    stiffness = dict(zip(beam().parameter_names, beam(**TRUE).parameter_values, strict=True))["rod.EIz"]
    assert found.parameters["rod.EIz"] == pytest.approx(stiffness, rel=0.02)


def test_a_cantilever_sags_as_in_the_textbook():
    """A weightless beam under a weight at its tip: y = m g L³ / (3 EI), from which EI follows in closed form."""
    rod = {"name": "rod", "length": LENGTH, "section": {"rhoA": 1e-9, "EIz": 2.0}, "modes": {"bending_y": 2}}
    rod |= {"order": 1, "joint": {"axes": []}, "bodies": [{"at": "tip", "mass": LOAD}]}
    model = model_of(arm(rod, gravity=[0.0, -9.81, 0.0]))
    sag = LOAD * 9.81 * LENGTH**3 / (3 * EI)
    log = Log("sag.csv", np.zeros(0), {"y": np.full(3, -sag)})
    columns = Columns(static=True, columns=(Column(name="y", measures="tip_position.y", noise=1e-6),))
    found = screwgen.identify(model, log, free="rod.EIz", sensors=columns)
    assert found["rod.EIz"].value == pytest.approx(EI, rel=1e-6)


def test_what_shapes_cannot_say_is_said():
    """Stiffness and weight of a beam that bends under its own weight: known as a ratio."""
    log = rests(beam(**TRUE), np.radians([-50, 0, 50]))
    model = screwgen.derive(beam().robot)
    found = screwgen.identify(model, log, free=["rod.EIz", "gravity[1]", "rod.rhoA"], sensors=COLUMNS)
    (said,) = found.undetermined
    assert "rod.EIz" in said and ("rod.rhoA" in said or "gravity[1]" in said)


def test_wrong_shapes_and_numbers_are_refused(tmp_path):
    log, robot = rests(beam(), [0.0, 0.3]), tmp_path / "beam.toml"
    robot.write_text(BEAM)
    gone = replace(log, columns=log.columns | {"angle": np.array([0.0, np.nan])})
    other = tmp_path / "other.toml"
    other.write_text(BEAM.replace("0.3", "0.4"))
    for change, free, more, words in (
        (gone, "rod.EIz", {}, "rests.csv: angle lacks 1 of 2 readings"),
        (log, "*.EI* together", {}, "rod.EIz is "),
        (log, ["*.E", "rod.profile.E in 1e9..1e12"], {"robot_file": other}, "other.toml: states other numbers"),
        (log, ["*.E together", "rod.profile.E"], {"robot_file": robot}, "rod.profile.E is free twice"),
        (Log("none.csv", np.zeros(0), {}), "rod.EIz", {}, "none.csv: has no rows"),
    ):
        with pytest.raises(UsageError) as caught:
            screwgen.identify(beam(), change, free=free, sensors=COLUMNS, **more)
        assert words in str(caught.value) and "\n" not in str(caught.value), words
    with pytest.raises(Exception, match="filter: belongs to samples in time"):
        Columns(static=True, columns=({"name": "a", "measures": "strain[0]", "filter": {"cutoff": 1.0}},))
