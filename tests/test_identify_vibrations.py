"""Identification from measured natural frequencies and damping ratios, as of a hammer test."""

import json

import numpy as np
import pytest
from helpers import arm, model_of
from identified_arms import SENSORS, TRUE, elsewhere, swing

import screwgen
from screwgen.cli.main import main
from screwgen.errors import UsageError
from screwgen.identification.vibration_tests import vibrations
from screwgen.spec.vibrations import Vibrations

LENGTH, RHO_A, EI, RATIO = 0.7, 0.4, 12.0, 0.015
ROOTS = np.array([1.87510407, 4.69409113, 7.85475744])
"""β l of a clamped beam: the roots of cos x cosh x = -1."""
HZ = ROOTS**2 / (2 * np.pi * LENGTH**2) * np.sqrt(EI / RHO_A)


def beam(EIz=EI, ratio=RATIO):
    rod = {"name": "rod", "length": LENGTH, "section": {"rhoA": RHO_A, "EIz": EIz}, "modes": {"bending_y": 6}}
    return model_of(arm(rod | {"order": 1, "joint": {"axes": ["z"]}, "damping": {"ratio": ratio}}))


def hammer(**test):
    return Vibrations(tests=(test,))


def test_the_stiffness_of_a_cantilever_follows_from_its_frequencies():
    """Those of the textbook, from a stiffness 40 % off: each is paired with the nearest mode."""
    found = screwgen.identify(beam(1.4 * EI), free="rod.EIz", vibrations=hammer(frequencies=HZ[[0, 2]].tolist()))
    one = found["rod.EIz"]
    assert one.value == pytest.approx(EI, rel=1e-3)
    assert [x.mode for x in found.vibrations] == [1, 3]
    assert one.low < EI < one.high
    only = screwgen.identify(beam(1.4 * EI), free="rod.EIz", vibrations=hammer(frequencies=[HZ[0]], noise=0.01))[
        "rod.EIz"
    ]
    assert (only.high - only.low) / EI > 4 * 0.01, "the noise of a frequency is that of the root of a stiffness"


def test_damping_ratios_and_loads_count():
    """The ratio of every own mode of a rod is the stated one; masses beside stiffness leave a ratio."""
    told = hammer(frequencies=HZ.tolist(), damping=[RATIO] * 3, noise=1e-4)
    found = screwgen.identify(beam(1.2 * EI, 0.04), free=["rod.EIz", "rod.damping.ratio"], vibrations=told)
    assert found["rod.damping.ratio"].value == pytest.approx(RATIO, rel=1e-3)
    loose = screwgen.identify(beam(1.2 * EI), free=["rod.EIz", "rod.rhoA"], vibrations=told)
    (said,) = loose.undetermined
    assert "rod.EIz and rod.rhoA are known only as a ratio (+1.00)" in said or "rod.rhoA and rod.EIz" in said


def test_frequencies_stand_beside_a_log():
    """A log that cannot tell stiffness and its scale apart from forces, and a frequency that can."""
    true = screwgen.natural_frequencies(screwgen.derive(elsewhere([]).robot), parameters=TRUE)
    told = hammer(frequencies=true.tolist(), noise=1e-3)
    free = ["rod.EIz", "*.rotor_inertia", "*.mass"]
    found = screwgen.identify(elsewhere(["rod.EIz"]), swing(1.0, 2e-3), free=free, sensors=SENSORS, vibrations=told)
    assert found["rod.EIz"].value == pytest.approx(TRUE["rod.EIz"], rel=0.01)
    assert [x.found for x in found.vibrations] == pytest.approx(true, rel=2e-3)
    assert set(found.whiteness) == {"angle", "gauge"}


def test_the_command_takes_a_table_alone(tmp_path, capsys):
    robot, table, out, page = (tmp_path / x for x in ("beam.toml", "hammer.toml", "out.toml", "page.html"))
    robot.write_text(screwgen.dump(beam(1.3 * EI).robot))
    table.write_text(f"[[tests]]\nfrequencies = [{HZ[0]:.5f}]\nposture = {{ 'rod.joint[0]' = 0.4 }}\n")
    asked = [
        "identify",
        str(robot),
        "--vibrations",
        str(table),
        "-o",
        str(out),
        "--free",
        "rod.EIz",
        "--report",
        str(page),
    ]
    assert main(asked) == 0
    assert f"hammer.toml: {HZ[0]:.4g} Hz is mode 1" in capsys.readouterr().out
    assert screwgen.load(out).links[0].section.EIz == pytest.approx(EI, rel=1e-3)
    assert "Measured vibrations" in page.read_text()
    assert json.loads(page.with_suffix(".json").read_text())["vibrations"][0]["mode"] == 1
    table.write_text("[[tests]]\nfrequencies = [1.0, 2.0]\nmodes = [1, 1]\n")
    assert main(asked) == 2 and "hammer.toml: tests[0].modes: names a mode twice" in capsys.readouterr().err


def test_dry_friction_is_no_damping_of_vibrations_and_viscous_friction_is():
    def free(**friction):
        rod = {"name": "rod", "length": LENGTH, "section": {"rhoA": RHO_A, "EIz": EI}, "modes": {"bending_y": 2}}
        joint = {"axes": ["z"], "drives": [{"friction": {"viscous": 0.01} | friction}]}
        model = model_of(arm(rod | {"joint": joint, "damping": {"ratio": RATIO}}))
        test = hammer(frequencies=[1.0], damping=[RATIO], joints="free").tests[0]
        return vibrations(model, test, np.array(model.chain.home, float), np.array(model.parameter_values))

    plain = free()
    falls = {"stribeck": {"static": 5.0, "velocity": 0.1}}
    remembers = {"memory": {"stiffness": 1e-9, "damping": 2.0}}
    for dry in ({"velocity": 0.01}, {"velocity": 0.01} | falls, remembers):
        assert free(coulomb=3.0, **dry) == pytest.approx(plain, rel=1e-6)
    assert free(viscous=0.1)[0, 1] > 1.1 * plain[0, 1]


@pytest.mark.parametrize(
    ("factor", "unit"), [(1.0, ""), (2 * np.pi, "rad/s"), (1e3, "mHz"), (60.0, "per minute"), (1e-3, "kHz")]
)
def test_frequencies_in_another_unit_are_suspected(factor, unit):
    """Though a start is 40 % off; with the right unit nothing is said.

    Without `modes` also where no other modes come as near; the first of a clamped beam in rad/s is its second in Hz.
    """
    for modes in ({"modes": [1, 3]}, *([{}] if factor in (1.0, 1e3, 1e-3) else [])):
        told = hammer(frequencies=(factor * HZ[[0, 2]]).tolist(), **modes)
        notes = screwgen.identify(beam(1.4 * EI), free="rod.EIz", vibrations=told).notes
        said = "vibrations: frequencies are not those of the model, but would be if they were"
        assert [x for x in notes if "frequencies are" in x] == [f"{said} {unit}: state them in Hz"] * bool(unit)


@pytest.mark.parametrize(
    ("test", "words"),
    [
        ({"frequencies": [1.0] * 7}, "mode 7 is asked for; the robot has 6 with joints locked"),
        ({"frequencies": [1.0], "posture": {"rod.joint[1]": 0.0}}, "'rod.joint[1]' is no coordinate of the robot"),
    ],
)
def test_wrong_tests_are_refused(test, words):
    with pytest.raises(UsageError) as caught:
        screwgen.identify(beam(), free="rod.EIz", vibrations=hammer(**test))
    assert words in str(caught.value) and "\n" not in str(caught.value)
