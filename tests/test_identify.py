"""Identification: numbers are found again from logs of a robot that has them."""

import json
import re

import numpy as np
import pytest
from helpers import arm, example_file, model_of
from identified_arms import SENSORS, TRUE, elsewhere, logged, pendulum, swing, torque

import screwgen
from screwgen.cli.main import main
from screwgen.identification.beside import how_of
from screwgen.identification.logs import Log
from screwgen.identification.problem import Problem
from screwgen.identification.signals import signal
from screwgen.identification.solve import Fit
from screwgen.identification.unknowns import FreeNumber, Unknowns
from screwgen.simulation.rollout_loops import ARRAYS
from screwgen.spec.columns import Column, load_columns


@pytest.fixture(scope="module")
def log() -> Log:
    return swing()


def test_numbers_thirty_percent_off_are_found_again(log):
    """1 % of noise on all sensors: each within 1 %, damping within 5 %, and within its interval twice as wide."""
    found = screwgen.identify(elsewhere(), log, free=list(TRUE), sensors=SENSORS)
    assert found.tried["stopped"] == "converged" and found.tried["iterations"] <= 10
    for name, true in TRUE.items():
        one = found[name]
        assert one.value == pytest.approx(true, rel=0.05 if "damping" in name else 0.01), name
        assert one.determined and abs(one.value - true) < one.high - one.low < 0.2 * true, name
    assert min(found.explained[0].share("whole").values()) > 0.99
    assert max(abs(x) for x in found.whiteness.values()) < 0.1 and not found.undetermined and not found.notes


def test_a_command_writes_the_robot_with_its_comments(tmp_path, capsys):
    """From a run of `simulate` with other numbers; what the file says besides stays, intervals are added."""
    text = screwgen.dump(elsewhere(["rod.EIz"]).robot)
    robot, log, out, page = (tmp_path / x for x in ("robot.toml", "log.csv", "identified.toml", "report.html"))
    robot.write_text(f"# of the sheet\n{text}")
    run = screwgen.simulate(pendulum(), 2.0, 1e-3, q0=[-1.5, 0.0, 0.0])
    run.save(log)
    table = tmp_path / "columns.toml"
    asked = [
        "-o",
        str(out),
        "--sensors-output",
        str(table),
        "--free",
        "rod.EIz",
        "--check",
        f"{log}@1.5:2",
        "--report",
        str(page),
    ]
    assert main(["identify", str(robot), f"{log}@0:1.5", *asked]) == 0
    assert "rod.EIz: 26 -> 20" in capsys.readouterr().out
    before, after = (path.read_text().splitlines() for path in (robot, out))
    (changed,) = [new for old, new in zip(before, after, strict=True) if old != new]
    assert "EIz = 20" in changed and "# ±" in changed
    found = screwgen.load(out).links[0].section.EIz
    assert found == pytest.approx(20.0, rel=1e-4)
    text, numbers = page.read_text(), json.loads(page.with_suffix(".json").read_text())
    assert text.count("<section>") == 7 and "rod.EIz" in text and "@1.5:2" in text
    assert text.count("data:image/png") == 4 and "://" not in text
    assert load_columns(table).sensors[0].name == "rod.joint[0]"
    assert numbers["estimates"][0]["value"] == pytest.approx(20.0, rel=1e-4)
    assert [x["held_out"] for x in numbers["explained"]] == [False, True]


def test_a_run_is_compared_without_what_a_planar_arm_has_across_its_plane():
    """No table says what its columns are, and the tip's z is 0 throughout."""
    run = screwgen.simulate(pendulum(), 0.5, 2e-3, q0=[-1.5, 0.0, 0.0])
    (found,) = screwgen.compare(pendulum(), run, window=0.25)
    assert "tip_position.z" not in found.sensors and min(found.share("whole").values()) > 0.999


def test_joints_that_are_given_move_the_links_alone(log):
    """Driven by motion: the angle moves the axis, the gauge says what the link does, and no friction matters."""
    model = elsewhere(["rod.EIz", "rod.damping.ratio"], actuation="motion")
    columns = SENSORS.model_copy(update={"columns": SENSORS.columns[1:]})
    clean = Log(log.name, log.t, swing(noise=1e-4).columns)
    found = screwgen.identify(model, clean, free=["rod.EIz", "rod.damping.ratio"], sensors=columns)
    assert found["rod.EIz"].value == pytest.approx(20.0, rel=0.01)
    assert found["rod.damping.ratio"].value == pytest.approx(0.02, rel=0.05)
    assert list(found.explained[0].share("whole")) == ["gauge"]


def test_sensors_are_identified_with_the_robot(log, tmp_path):
    """Offset, delay, filter and gain of a logger and a drive that do more than they say."""
    from screwgen.identification.sensing import Start, readings

    step, gauge = log.step, log.columns["gauge"]
    numbers = {name: np.array([x]) for name, x in dict(scale=1.0, offset=30.0, delay=0.0, cutoff=8.0).items()}
    filtered = readings(gauge[None], numbers, step, Start(gauge[:1] + 30.0, np.zeros(1)))[0]
    other = Log(log.name, log.t, log.columns | {"gauge": filtered, "motor": log.columns["motor"] / 1.2})
    told = [c.model_dump(exclude_unset=True) for c in SENSORS.columns]
    told[0]["gain"], told[2]["filter"] = 1.0, {"cutoff": 11.0}
    columns = type(SENSORS)(columns=told)
    free = ["motor.gain", "gauge.offset", "gauge.cutoff", "rod.EIz"]
    found = screwgen.identify(elsewhere(["rod.EIz"]), other, free=free, sensors=columns)
    assert found["motor.gain"].value == pytest.approx(1.2, rel=0.01)
    assert found["gauge.offset"].value == pytest.approx(30.0, abs=2.0)
    assert found["gauge.cutoff"].value == pytest.approx(8.0, rel=0.02)
    assert found["rod.EIz"].value == pytest.approx(20.0, rel=0.01)
    path = tmp_path / "sensors.toml"
    path.write_text(found.sensors_text())
    assert load_columns(path) == found.columns and found.columns.inputs[0].gain == found["motor.gain"].value


def test_a_gauge_by_its_name_is_the_entry_of_that_link(log):
    """Also where other strains stand between them in the list of all."""
    model = screwgen.derive(screwgen.load(example_file("ella")))
    named = [name for name in model.strain_names if ".base_strain.bending" in name]
    assert 0 < len(named) < len(model.strain_names)
    for k, name in enumerate(named):
        entry, word = (
            signal(model, Column(name="a", measures=x, numbers={"fibre": (0.01,)})) for x in (f"strain[{k}]", name)
        )
        assert (entry.place, entry.row) == (word.place, word.row)


def test_shorter_windows_lead_to_numbers_that_long_ones_miss():
    """A stiff rod that hardly damps: over two seconds it vibrates as often as no step of twice its stiffness sees."""
    stiff = TRUE | {"rod.EIz": 400.0, "rod.damping.ratio": 0.001}
    log = logged(pendulum(stiff), torque, 2.0)
    start = pendulum(stiff | {"rod.EIz": 800.0, "rod.joint.drives[0].rotor_inertia": 0.2})
    found = screwgen.identify(start, log, free=["rod.EIz", "*.mass", "*.rotor_inertia"], sensors=SENSORS, window=2.0)
    assert found["rod.EIz"].value == pytest.approx(400.0, rel=1e-3)
    assert found["rod.bodies[0].mass"].value == pytest.approx(0.4, rel=1e-3)


def test_a_number_that_the_file_states_with_others_is_refused_before_the_fit(tmp_path, capsys):
    """A tube states all that follows from its radii."""
    robot, log = str(example_file("ella_paper")), tmp_path / "log.csv"
    log.write_text("t,upper_arm.joint[0]\n" + "".join(f"{1e-3 * k},0.0\n" for k in range(3)))
    assert (
        main(["identify", robot, str(log), "-o", str(tmp_path / "out.toml"), "--free", "forearm.EIz", "--quiet"]) == 2
    )
    told = capsys.readouterr().err
    assert "forearm.EIz is stated together with others; state it by a number of its own" in told
    assert not (tmp_path / "out.toml").exists()


def test_a_gear_is_identified_though_nothing_measures_its_rotor():
    """Windows begin with the rotor where the gear bears the joint, not at zero."""
    drive = {"ratio": 50.0, "rotor_inertia": 1e-4, "stiffness": 900.0, "damping": 1.0, "friction": {"viscous": 1e-3}}
    rod = {"name": "rod", "length": 0.5, "bodies": [{"at": "tip", "mass": 2.0}]}
    model = model_of(arm({**rod, "joint": {"axes": ["z"], "drives": [drive]}}, gravity=[0.0, -9.81, 0.0]))
    true = {"rod.joint.drives[0].stiffness": 700.0, "rod.bodies[0].mass": 2.5}
    q0, torque = (
        model.chain.with_inner([0.7], model.parameter_values),
        lambda t, q, v: [0.2 * np.sin(9 * t) - v[1] / 99],
    )
    run = screwgen.simulate(model, 2.0, 1e-3, q0=q0, controller=torque, parameters=true)
    log = Log("gear.csv", run.t, {"rod.joint[0]": run.q[:, 0], "rod.torque[0]": run.tau[:, 0]})
    found = screwgen.identify(model, log, free=list(true))
    for name, value in true.items():
        assert found[name].value == pytest.approx(value, rel=2e-3), name


@pytest.mark.parametrize("part", ["5:9", "2:1"])
def test_a_part_outside_of_the_log_is_refused_in_a_line(tmp_path, part):
    t = np.linspace(0.0, 1.0, 101)
    names = ",".join(["t", *(column.name for column in SENSORS.columns)])
    np.savetxt(tmp_path / "log.csv", np.column_stack([t, t, t, t]), delimiter=",", header=names, comments="")
    with pytest.raises(screwgen.UsageError, match=r"log\.csv: has 0 samples from"):
        screwgen.identify(pendulum(), f"{tmp_path / 'log.csv'}@{part}", free=["rod.EIz"], sensors=SENSORS)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "has no column that the robot names, as {name}.*; it is empty; say with sensors"),
        ("t,angle\n0,1\n", "has no column that the robot names, as {name}.*; it has t, angle; say with sensors"),
        ("t,{name}\n", "has no rows; give one at least"),
        ("t;{name}\n0;1\n", "has semicolons between its columns; write commas"),
    ],
)
def test_a_log_without_numbers_is_refused_in_a_line(tmp_path, text, said):
    model, path = pendulum(), tmp_path / "log.csv"
    path.write_text(text.format(name=model.q_names[0]))
    with pytest.raises(screwgen.UsageError, match=r"log\.csv: " + said.format(name=re.escape(model.q_names[0]))):
        screwgen.identify(model, path, free=["rod.EIz"])


class Astray:
    """Readings of ``exp(p) - 1`` and ``arsinh(200 x)`` in windows that begin at some x each.

    From x far from zero a whole step of Newton's leads ever farther away.
    """

    names, stated, states, step = ["y"], np.array([1e-3]), np.zeros(1, int), 1e-3

    def __init__(self, starts):
        self.x, self.compared = np.array(starts, float), np.zeros((len(starts), 2, 1))

    spread = np.ones(1)

    def differences(self, problem, window, sought, shift):
        x, p = self.x[window] + shift[:, 0], sought[:, 0]
        return -np.stack([np.exp(p) - 1, np.arcsinh(200 * x)], axis=1)[..., None]

    def continued(self, problem, sought, shift):
        return shift

    def linearised(self, problem, sought, shift):
        every = np.arange(len(self.x))
        x = self.x + shift[:, 0]
        by_p, by_x = np.zeros((len(x), 2, 1, 1)), np.zeros((len(x), 2, 1, 1))
        by_p[:, 0], by_x[:, 1, 0, 0] = -np.exp(sought[0]), -200 / np.sqrt(1 + (200 * x) ** 2)
        return self.differences(problem, every, np.tile(sought, (len(x), 1)), shift), by_p, by_x


def test_a_window_that_goes_astray_does_not_end_the_search():
    """The start of one window of five lies where whole steps lead away; the number is found all the same."""
    group, one = Astray([0.0, 0.01, 0.4, -0.01, 0.02]), FreeNumber("p", "parameter", 3.0, "", False, 1.0)
    fit = Fit(Problem(None, [group], Unknowns([one]), how_of("modal_midpoint", 1, 1)), robust=False)
    at = fit.run(40, np.array([0.5]))
    assert not at.stopped and abs(at.sought[0]) < 1e-6
    assert np.abs(group.x + at.shift[0][:, 0]).max() < 1e-3
    assert fit.begun(np.zeros(1)).cost < fit.start(np.zeros(1)).cost


@pytest.mark.filterwarnings("ignore::screwgen.ModelValidityWarning")
def test_a_stiff_mode_that_a_column_reads_may_ring():
    """Eight samples a turn, from a stretch a hundred times that under the load of bending: a mass is found."""
    section = {"rhoA": 0.5, "EA": 5e5, "EIz": 20.0}
    rod = {"section": section, "modes": {"axial": 1, "bending_y": 1}, "bodies": [{"at": "tip", "mass": 0.4}]}
    model = model_of(arm({"name": "rod", "length": 1.0, "joint": {"axes": ["z"]}} | rod))
    more = {"parameters": {"rod.bodies[0].mass": 0.44}, "integrator": "modal_midpoint"}
    run = screwgen.simulate(model, 0.04, 1e-3, q0=[-1.5, 5e-3, 0.01], **more)
    found = screwgen.identify(model, run, free=["rod.bodies[0].mass"])
    assert found["rod.bodies[0].mass"].value == pytest.approx(0.44, rel=1e-6)


@pytest.mark.parametrize("name", ARRAYS)
def test_functions_of_arrays_give_arrays_of_numbers(name):
    """Objects would be no argument of a root of them."""
    given = [np.array([[0.3, 0.4]])] * (1 + (name == "atan2"))
    assert ARRAYS[name](*given).dtype.kind in "fi"
