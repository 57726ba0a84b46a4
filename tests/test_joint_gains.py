"""Joint laws: their bounds, margins and integral, each judged by the loop itself or by a run of the arm."""

import numpy as np
import pytest
from helpers import arm, link, loaded_boom, model_of
from robot_toml import to_toml

import screwgen
from screwgen import PID, UsageError
from screwgen.cli.main import main
from screwgen.planning.joint_gains import margin_words
from screwgen.planning.loop_margins import loop_margins
from screwgen.planning.members import Still
from screwgen.planning.sampled_loop import LoopGains, SampledLoop, noise_torques
from screwgen.simulation.controller_files import read_pd

STEP, BOOM = 1e-3, loaded_boom(gravity=-9.81)


def rotor(inertia=0.4, **keys):
    """A rotor alone about a vertical axis."""
    rod = link("rod", axes=["z"], length=1.0, section={"rhoA": 1e-6}, modes={}, joint={"armature": [inertia]})
    return {**arm({**rod, **keys}), "name": "boom", "gravity": [0.0, 0.0, 0.0]}


def two_springs():
    """A loop of two joints with a mode between them, which the file of no robot says."""
    M = np.array([[1.0, 0.3, 0.4], [0.3, 0.6, 0.2], [0.4, 0.2, 0.5]])
    K = np.diag([0.0, 0.0, 900.0])
    return SampledLoop.of_matrices(M, 1e-3 * K, K, 2, STEP)


LAW = LoopGains(np.array([60.0, 40.0]), np.array([14.0, 8.0]), np.array([90.0, 50.0]))


def grows(closed, factors):
    """Whether a loop grows whose torques are multiplied by (complex) factors."""
    return np.abs(np.linalg.eigvals(closed.A - closed.B @ (np.asarray(factors)[:, None] * closed.G))).max() > 1


@pytest.mark.parametrize("ki", [None, LAW.ki])
def test_gain_margins_are_where_poles_leave_the_circle(ki):
    closed = two_springs().closed(LAW._replace(ki=ki))
    for j, margin in enumerate(loop_margins(closed, STEP)):
        factor = lambda x, j=j: [x if k == j else 1.0 for k in range(2)]  # noqa: E731
        assert not grows(closed, factor(0.999 * margin.upper)) and grows(closed, factor(1.001 * margin.upper))
        if ki is not None:
            assert not grows(closed, factor(1.001 * margin.lower)) and grows(closed, factor(0.999 * margin.lower))


def test_a_disk_of_complex_factors_is_borne_and_no_larger_one():
    closed, turns = two_springs().closed(LAW), np.exp(2j * np.pi * np.linspace(0, 1, 721))
    for j, margin in enumerate(loop_margins(closed, STEP)):
        fates = []
        for size in (0.99, 1.01):
            inside = (1 + size * margin.disk / 2 * turns) / (1 - size * margin.disk / 2 * turns)
            fates.append(any(grows(closed, [x if k == j else 1.0 for k in range(2)]) for x in inside))
        assert fates == [False, True]


def test_a_loop_that_grows_where_a_sample_is_late_is_said():
    closed, fates = two_springs().closed(LAW.times(60.0)), []
    for j in range(2):
        B, G = closed.B[:, [j]], closed.G[[j]]
        late = np.block([[closed.transition + B @ G, -B], [G, np.zeros((1, 1))]])
        fates.append(np.abs(np.linalg.eigvals(late)).max() > 1)
    said = ["less than a sample of 1 ms" in margin_words(x, STEP) for x in loop_margins(closed, STEP)]
    assert fates == said == [True, False]


def test_a_delay_margin_is_borne_by_samples_that_come_late():
    closed = two_springs().closed(LAW)
    n = len(closed.A)
    for j, margin in enumerate(loop_margins(closed, STEP)):
        fates, whole = [], int(margin.delay / STEP)
        for late in (whole, whole + 1):
            others = closed.A - np.delete(closed.B, j, 1) @ np.delete(closed.G, j, 0)
            A = np.zeros((n + late, n + late))
            A[:n, :n], A[:n, -1] = others, -closed.B[:, j]
            A[n, :n] = closed.G[j]
            A[range(n + 1, n + late), range(n, n + late - 1)] = 1.0
            fates.append(np.abs(np.linalg.eigvals(A)).max() > 1)
        assert late > 1 and fates == [False, True]


def test_noise_of_torques_is_that_of_a_long_sequence():
    loop, noise = two_springs(), np.array([[1e-3, 2e-3], [1e-2, 3e-2]])
    rng, x, z, found = np.random.default_rng(3), np.zeros(6), np.zeros(2), []
    for q, v in zip(*(rng.normal(size=(2, 60000, 2)) * noise[:, None]), strict=True):
        lack = -(x[:2] + q)
        tau = LAW.kp * lack - LAW.kd * (x[3:5] + v) + LAW.ki * z
        z = z + STEP * lack
        x = loop.A @ x + loop.B @ tau
        found.append(tau)
    assert noise_torques(loop, LAW, noise) == pytest.approx(np.std(found[2000:], axis=0), rel=0.03)


def test_efforts_after_a_jump_are_those_of_a_run():
    model = model_of(loaded_boom())
    law = screwgen.gains(model, [[0.0]], bounds={"jump": [0.05], "efforts": [1.5]})
    run = screwgen.simulate(model, 3.0, STEP, [0.0], controller=screwgen.PD(law.kp, law.kd, (0.05,)))
    assert np.abs(run.tau).max() == pytest.approx(law.jump_efforts[0], rel=1e-3)
    assert law.jump_efforts[0] <= 1.5 * (1 + 1e-4)
    freely = screwgen.gains(model, [[0.0]])
    assert law.kp < freely.kp and law.decay < freely.decay


def test_an_integral_leaves_no_error_under_a_load_and_does_not_wind_up():
    """A constant torque that nobody knows of, and a drive that gives little."""
    model = model_of(loaded_boom())
    found = screwgen.gains(model, [[0.0]], integral=True)
    push = np.array([[0.0, 0.0, 0.0, 0.0, 2.0, 0.0]])
    ends = {}
    for name, law in (
        ("pd", screwgen.PD(found.kp, found.kd, (0.0,))),
        ("pid", PID(found.kp, found.kd, (0.0,), ki=found.ki)),
    ):
        ends[name] = screwgen.simulate(model, 6.0, STEP, controller=law, w_ext=push).q[-1, 0]
    assert ends["pd"] == pytest.approx(2.0 / found.kp[0], rel=1e-3) and abs(ends["pid"]) < 1e-4 * ends["pd"]
    weak, summed = PID(found.kp, found.kd, (1.0,), tau_max=(2.0,), ki=found.ki), [0.0]

    def winding_up(t, q, v):
        summed[0] += found.ki[0] * STEP * (1.0 - q[0])
        return np.clip(found.kp * (1.0 - q[:1]) - found.kd * v[:1] + summed[0], -2.0, 2.0)

    run, wound = (screwgen.simulate(model, 8.0, STEP, controller=law) for law in (weak, winding_up))
    assert np.abs(run.tau).max() <= 2.0 and (np.abs(run.tau) == 2.0).sum() > 300
    assert run.q[-1, 0] == pytest.approx(1.0, abs=1e-4)
    assert run.q[:, 0].max() - 1 < 0.7 * (wound.q[:, 0].max() - 1)
    again = screwgen.simulate(model, 8.0, STEP, controller=weak)
    assert np.array_equal(again.q, run.q), "a run starts the integral anew"


def test_a_loop_with_an_integral_moves_as_runs_do():
    model = model_of(loaded_boom())
    found = screwgen.gains(model, [[0.0]], integral=True)
    gains = LoopGains(found.kp, found.kd, found.ki)
    run = screwgen.simulate(model, 3.0, STEP, [0.02], controller=PID(*gains[:2], (0.0,), ki=gains.ki))
    still = Still(model, np.array(model.parameter_values))
    closed = SampledLoop.of(still, still.held(np.zeros(1)), STEP).closed(gains)
    x, q = np.zeros(len(closed.A)), []
    x[0] = 0.02
    for _ in run.t:
        q.append(x[0])
        x = closed.transition @ x
    assert np.abs(run.q[:, 0] - q).max() < 2e-3 * 0.02


def test_a_wanted_decay_is_had_with_smaller_gains():
    model = model_of(loaded_boom())
    freely = screwgen.gains(model, [[0.0]])
    slower = screwgen.gains(model, [[0.0]], bounds={"decay": 0.5 * freely.decay})
    assert 0.49 * freely.decay <= slower.decay and slower.kp[0] * slower.kd[0] < 0.5 * freely.kp[0] * freely.kd[0]


@pytest.mark.parametrize("decay", [2.0, 5.0, 8.0])
def test_a_wanted_decay_is_not_missed_by_rounding(decay):
    """Where two real poles meet decay is steep in the gains: three digits miss it by up to 3 %."""
    assert decay <= screwgen.gains(model_of(loaded_boom()), [[0.0]], bounds={"decay": decay}).decay < 1.01 * decay


@pytest.mark.parametrize(
    ("bounds", "said"),
    [
        ({"decay": 80.0}, r"bounds: decay: 80 is wanted, [\d.]+ was found; ask for less"),
        ({"kp": [0.0]}, r"bounds: kp: all are 0; state the largest gains"),
        ({"kd": [-1.0]}, r"bounds: kd: must be >= 0: the largest gains"),
        ({"kp": [1.0, 2.0]}, r"bounds: kp: has 2 numbers; it must have 1"),
        ({"damping": 1.5}, r"bounds: damping is 1.5; it must be less than 1"),
        ({"speed": 1.0}, r"bounds: there is no 'speed'; choose of decay, "),
        ({"efforts": [1.0]}, r"bounds: efforts is stated without jump"),
        ({"noise_efforts": [1.0]}, r"bounds: noise_efforts is stated without noise"),
    ],
)
def test_bounds_that_cannot_be_met_are_one_line(bounds, said):
    with pytest.raises(UsageError, match=said) as caught:
        screwgen.gains(model_of(loaded_boom()), [[0.0]], bounds=bounds)
    assert "\n" not in str(caught.value)


def test_postures_beyond_limits_and_arms_that_efforts_do_not_hold_are_refused():
    limited = loaded_boom(joint={"armature": [0.3], "limits": [{"lower": -1.0, "upper": 1.0}]})
    with pytest.raises(UsageError, match=r"postures: rod\.joint\[0\] is 2; its limits are -1 and 1; choose one"):
        screwgen.gains(model_of(limited), [[2.0]])
    hanging = loaded_boom(gravity=-9.81)
    with pytest.raises(UsageError, match=r"bounds: efforts: entry 0 is 5, and holding the arm takes 12\.\d+"):
        screwgen.gains(model_of(hanging), [[0.0]], bounds={"jump": [0.1], "efforts": [5.0]})


def test_further_modes_are_stated_and_count():
    found = screwgen.gains(model_of(loaded_boom()), [[0.0]])
    assert found.further is not None and found.further.margin >= -2e-4
    assert any(line.startswith("with the next two modes per plane: slowest decay") for line in found.lines)
    rigid = screwgen.gains(model_of(rotor()), [[0.0]])
    assert rigid.further is None and np.isfinite(rigid.decay)


def test_the_command_takes_payloads_bounds_and_an_integral(tmp_path, capsys):
    robot, file = tmp_path / "boom.toml", tmp_path / "gains.toml"
    robot.write_text(to_toml(loaded_boom()))
    asked = ["gains", str(robot), "-o", str(file), "--at", "0.2", "--model", "*.bodies[0].mass=1.3,rod.EIz=0.9"]
    assert main([*asked, "--integral", "--bound", "kp=50", "--bound", "decay=1"]) == 0
    printed, model = capsys.readouterr().out, model_of(loaded_boom())
    assert "at 0.2: joint 0: gain" in printed and "with the next two modes per plane" in printed
    law = read_pd(file, model)
    models = [{"*.bodies[0].mass": 1.3, "rod.EIz": 0.9}]
    found = screwgen.gains(model, [[0.2]], models=models, integral=True, bounds={"kp": [50.0], "decay": 1.0})
    assert isinstance(law, PID) and (law.kp, law.kd, law.ki) == tuple(map(tuple, (found.kp, found.kd, found.ki)))
    assert law.kp[0] <= 50.0
    run = ["simulate", str(robot), "--duration", "0.1", "--step", "1e-3", "-o", str(tmp_path / "run.npz")]
    assert main([*run, "--controller", f"pd:{file}", "--quiet"]) == 0


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (["--model", "mass"], "--model: 'mass' is no NAME=NUMBER"),
        (["--model", "*.mass=heavy"], "--model: '*.mass=heavy' has 'heavy', which is no number"),
        (["--model", "*.colour=2"], "parameters: there is no '*.colour'"),
        (["--bound", "kp=1,x"], "--bound: 'kp=1,x' has 'x', which is no number"),
        (["--bound", "stiffness=1"], "bounds: there is no 'stiffness'"),
        (["--bound", "kp=nan"], "bounds: kp: holds a number that is not finite"),
    ],
)
def test_the_command_refuses_in_one_line(tmp_path, capsys, given, said):
    robot = tmp_path / "boom.toml"
    robot.write_text(to_toml(loaded_boom()))
    assert main(["gains", str(robot), "-o", str(tmp_path / "gains.toml"), *given]) == 2
    error = capsys.readouterr().err
    assert said in error and error.count("\n") == 1 and not (tmp_path / "gains.toml").exists()


def planar(limit: float = 40.0) -> screwgen.Model:
    """Two rigid links in a plane, whose torques move each other."""
    links = [link(name, axes=["z"], length=0.6, bodies=[{"at": "tip", "mass": 1.0}]) for name in ("upper", "fore")]
    for one in links:
        one["joint"] |= {"armature": [0.1], "limits": [{"effort": limit}]}
    return model_of(arm(*links, gravity=[0.0, 0.0, 0.0]))


@pytest.mark.parametrize("most", [0.05, 0.5])
def test_a_jump_of_one_joint_is_borne_by_all(most):
    """The torque of the other joint is that of a simulated jump, within its bound."""
    model = planar()
    law = screwgen.gains(model, [[0.0, 0.4]], bounds={"jump": [0.05, 0.0], "efforts": [40.0, most]})
    pd = screwgen.PD(tuple(law.kp), tuple(law.kd), (0.05, 0.4))
    run = screwgen.simulate(model, 3.0, 1e-3, q0=[0.0, 0.4], controller=pd)
    told = np.abs(run.tau).max(axis=0)
    assert told[1] < 1.05 * most and told == pytest.approx(law.jump_efforts, rel=0.05)


@pytest.mark.parametrize(
    "friction", [{"coulomb": 5.0, "velocity": 0.01}, {"bend": {"friction": 5.0, "velocity": 0.01}}]
)
def test_dry_friction_is_no_damping_of_a_design(friction):
    """Its slope at rest would be 500 N·m·s/rad."""
    rod = {"name": "rod", "length": 1.0, "bodies": [{"at": "tip", "mass": 1.0}], "section": {"rhoA": 0.5, "EIz": 60.0}}
    rod |= {"modes": {"bending_y": 1}}
    laws = []
    for drive in ({"rotor_inertia": 0.1, "friction": friction}, {"rotor_inertia": 0.1}):
        joint = {"axes": ["z"], "drives": [drive]}
        laws.append(screwgen.gains(model_of(arm(rod | {"joint": joint}, gravity=[0.0, 0.0, 0.0])), [[0.0]]))
    assert np.allclose(laws[0].kp, laws[1].kp, rtol=1e-2) and np.allclose(laws[0].kd, laws[1].kd, rtol=1e-2)


@pytest.mark.parametrize(
    "ask",
    [
        lambda model, changed: screwgen.plan(model, [0.0, 0.0], [1.0, 0.0], 1.0, parameters=changed),
        lambda model, changed: screwgen.gains(model, [[0.0, 0.0]], parameters=changed),
        lambda model, _: screwgen.gains(model, [[0.0, 0.0]], models=[{"*.effort": 0.1}]),
        lambda model, changed: screwgen.inverse_kinematics(model, [0.6, 0.6, 0.0], parameters=changed),
        lambda model, _: screwgen.lqg(model, {"upper.joint.limits[0].effort": [0.5, 1.0]}),
        lambda model, changed: screwgen.shape(model, [0.0, 0.0], [0.5, 0.0], parameters=changed),
    ],
)
def test_limits_that_parameters_change_are_refused(ask):
    with pytest.raises(UsageError, match=r"parameters: upper.joint.limits\[0\].effort is \S+, in the file 40"):
        ask(planar(), {"upper.joint.limits[0].effort": 4.0})


@pytest.mark.parametrize(
    ("limits", "said"),
    [
        ({"upper": [np.nan, 1.0]}, "limits: upper: holds nan"),
        ({"lower": [0.5, 0.0], "upper": [-0.5, 1.0]}, "lower 0.5 of upper.joint[0] is above upper -0.5"),
    ],
)
def test_limits_that_are_none_are_named(limits, said):
    with pytest.raises(UsageError) as caught:
        screwgen.plan(planar(), [0.0, 0.0], [1.0, 0.0], 1.0, limits=limits)
    assert said in str(caught.value)


@pytest.mark.parametrize("angle", [1.2, -1.2])
def test_an_integral_stands_still_at_the_limit_on_either_side_of_a_crank(angle):
    """On one side of it the joint turns on when the cylinder pushes, on the other when it pulls."""
    crank = {"crank": 0.3, "base": 1.0, "angle": angle}
    joint = {"drives": {"rotor_inertia": 0.5, "transmission": crank}}
    rod = link("rod", axes=["z"], length=1.0, section={"rhoA": 0.6, "EIy": 900.0, "EIz": 900.0}, joint=joint)
    rod["bodies"] = [{"at": "tip", "mass": 5.0}]
    goal = np.sign(angle) * 0.5
    law = PID((200.0,), (60.0,), (goal,), tau_max=(12.0,), ki=(150.0,))
    run = screwgen.simulate(model_of({**arm(rod), "gravity": [0.0, 0.0, 0.0]}), 12.0, 2e-3, controller=law)
    assert np.abs(run.q[:, 0]).max() < 0.8


def test_a_joint_that_no_drive_moves_has_no_gains():
    """A load on a rope below a trolley: its sway decays by what the trolley does."""
    cart = {
        "name": "cart",
        "joint": {"axes": [{"slide": "x"}], "armature": [5.0]},
        "bodies": [{"at": "tip", "mass": 5.0}],
    }
    rope = {"name": "rope", "joint": {"axes": ["y"]}, "bodies": [{"at": "tip", "mass": 2.0, "com": [0.0, 0.0, -1.0]}]}
    model = model_of(arm(cart, rope, gravity=[0.0, 0.0, -9.81]))
    law = screwgen.gains(model, [[0.0, 0.0]], bounds={"kp": [1e4, 0.0], "kd": [1e4, 0.0]})
    assert law.kp[1] == law.kd[1] == 0.0 and sum("joint 1" in line for line in law.lines) == 0
    pd = screwgen.PD(tuple(law.kp), tuple(law.kd), (0.0, 0.0))
    run = screwgen.simulate(model, 8.0 / law.decay, 1e-3, q0=[0.0, 0.1], controller=pd)
    assert np.abs(run.q[-1]).max() < 0.1 * np.exp(-6)
