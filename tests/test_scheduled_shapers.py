"""Scheduled shapers: they know what vibrates, leave what theory says, and are played in runs."""

import numpy as np
import pytest
from helpers import arm, link, model_of
from random_plans import ella, rod, shaper_of_ella
from robot_toml import to_toml
from scipy.interpolate import CubicSpline

import screwgen
from screwgen import UsageError
from screwgen.cli.main import main
from screwgen.planning.shaper_files import shaper_text
from screwgen.simulation.integral_law import PID
from screwgen.simulation.shaped import Shaped, read_shaped
from screwgen.simulation.validity import ModelValidityWarning

STEP = 1e-3
LAW = screwgen.PD((60.0,), (14.0,), (0.0,))
NAN = float("nan")


@pytest.fixture(scope="module")
def of_ella():
    return shaper_of_ella()


def test_locked_joints_leave_the_frequencies_of_modes_under_weight(of_ella):
    """A study of its own has them at a posture, loaded."""
    q = [0.3, -0.4, 0.9]
    expected = screwgen.natural_frequencies(ella(), q, loaded=True)[:2]
    assert of_ella.vibrations(q)[0] == pytest.approx(expected, rel=3e-3)
    assert "joints locked" in of_ella.vibrates


def test_under_a_law_the_poles_of_its_loop_vibrate():
    model = rod()
    made = screwgen.shape(model, [-1.0], [1.0], gains=LAW, kind="zvd")
    rest = screwgen.equilibrium(model, [0.4], hold="all")
    linear = model.linearise(rest.q, tau=rest.tau)
    A = linear.A - linear.B[:, :1] @ np.array([[60.0, *[0.0] * 2, 14.0, *[0.0] * 2]])
    poles = np.linalg.eigvals(A)
    slow = min((s for s in poles if s.imag > 0 and -s.real < 0.5 * abs(s)), key=abs)
    f, z = made.vibrations([0.4])
    assert f[0] == pytest.approx(abs(slow) / (2 * np.pi), rel=1e-3)
    assert z[0] == pytest.approx(-slow.real / abs(slow), rel=1e-2)
    assert "closed loop" in made.vibrates


def test_over_fifty_postures_of_ella_little_is_left(of_ella):
    assert len(of_ella.table) == 50 and of_ella.residual == of_ella.table[:, -1].max() < 2e-3
    middle = screwgen.shaper(of_ella.vibrations([0.0, 0.0, 0.0])[0], 0.0, "zv")  # one that does not follow
    fixed = [float(middle.residual(of_ella.vibrations(row[:-1])[0][0])) for row in of_ella.table]
    assert max(fixed) > 50 * of_ella.residual


def test_a_payload_is_a_variable():
    model, name = rod(), "rod.bodies[0].mass"
    made = screwgen.shape(model, [0.0], [0.0], payload=(name, 0.5, 2.0), kind="ei")
    assert made.variables == (name,) and made.residual < 0.052
    for mass in (0.6, 1.7):
        own = screwgen.natural_frequencies(model, [0.0], parameters={name: mass}, loaded=True)[0]
        assert made.vibrations([mass])[0][0] == pytest.approx(own, rel=2e-3)


# ------------------------------------------------------------------------------ theory


@pytest.mark.parametrize("kind", ["zv", "zvd", "ei"])
def test_one_link_is_left_with_what_theory_says(kind):
    """Its joint moves along a shaped reference; EI from 0.6 to 1.4; within 0.1 percentage points of the closed form."""
    section = {"rhoA": 0.4, "EIy": 30.0, "EIz": 30.0}
    joint = {"axes": ["z"], "actuation": "motion"}
    bodies = [{"at": "tip", "mass": 0.8}]
    boom = {"name": "boom", "length": 1.0, "section": section, "modes": {"bending_y": 1}, "joint": joint}
    model = model_of(arm(boom | {"bodies": bodies}, gravity=[0.0, 0.0, 0.0]))
    f = screwgen.natural_frequencies(model)[0]
    own = screwgen.shaper(f, 0.0, kind)
    end, way = 0.25, 1e-3

    def path(t):
        s = np.clip(np.asarray(t) / end, 0.0, 1.0)
        return way * s**3 * (10 - 15 * s + 6 * s**2)

    t = np.arange(0.0, 2.2, 2.5e-3)
    references = path(t), sum(a * path(t - s) for s, a in zip(own.times, own.amplitudes, strict=True))
    for factor in (0.6, 0.8, 1.0, 1.2, 1.4):
        left = []
        for values in references:
            curve = CubicSpline(t, values, bc_type="clamped")
            parameters = {"boom.EIz": 30.0 * factor}
            run = screwgen.simulate(
                model, 2.1, 5e-4, motion={"boom.joint[0]": curve}, parameters=parameters, integrator="rk4"
            )
            behind = run.t > 0.3 + own.delay
            w = 2 * np.pi * f * np.sqrt(factor)
            left.append(np.hypot(run.q[behind, 1], run.v[behind, 1] / w).mean())
        x = np.cos(np.pi / 2 * np.sqrt(factor))
        theory = {"zv": np.abs(x), "zvd": x**2, "ei": np.abs(x**2 * 0.95 + 0.05 * (2 * x**2 - 1))}[kind]
        assert left[1] / left[0] == pytest.approx(theory, abs=1e-3)


def crane() -> screwgen.Model:
    """A trolley, and a load that hangs on a hoist's rope; a slide lets it down."""
    trolley = link("trolley", axes=[{"slide": "y"}], length=0.1, modes={}, section={"rhoA": 0.1})
    trolley = trolley | {"bodies": [{"at": "base", "mass": 20.0}]}
    hoist = {"name": "hoist", "joint": {"axes": ["z", {"slide": "x"}]}, "bodies": [{"at": "base", "mass": 3.0}]}
    return model_of(arm(trolley, hoist, gravity=[9.81, 0.0, 0.0]))


class Published:
    """ZV on the frequency of a rope of the current length, `sqrt(g / l)`, as is published for cranes."""

    joints, variables = ("trolley.slide[0]", "hoist.joint[0]", "hoist.slide[0]"), ("hoist.slide[0]",)

    @staticmethod
    def outside(place):
        return None

    @staticmethod
    def at(place):
        return screwgen.shaper(np.sqrt(9.81 / place[0]) / (2 * np.pi))


class MeanLength(Published):
    """The same at a length of 1.2 m."""

    @staticmethod
    def at(place):
        return Published.at([1.2])


@pytest.mark.parametrize(
    ("lengths", "time", "left", "fixed"),
    [((0.8, 0.8), 2.0, 0.02, 4), ((1.6, 1.6), 2.0, 0.02, 4), ((0.8, 1.6), 5.0, 0.09, 0)],
)
def test_a_load_on_a_rope_sways_as_little_as_under_the_published_shaper(lengths, time, left, fixed):
    """It is found from the model here. Over the sway without; at one length, and while the rope lengthens slowly."""
    model, (begin, end) = crane(), lengths
    law = screwgen.PD((9e3, 0.0, 9e3), (1.5e3, 0.0, 1.5e3), (2.0, 0.0, end), time, q_start=(0.0, 0.0, begin))
    made = screwgen.shape(model, [0.0, 0.0, 0.7], [0.0, 0.0, 1.7], free=[1])
    for length in (0.8, 1.2, 1.6):
        assert made.vibrations([length])[0][0] == pytest.approx(np.sqrt(9.81 / length) / (2 * np.pi), rel=1e-3)
    sway = []
    for control in (law, *(Shaped.of(law, shaper) for shaper in (made, Published, MeanLength))):
        run = screwgen.simulate(model, time + 6.0, 2e-3, [0.0, 0.0, begin], controller=control)
        sway.append(np.abs(run.q[run.t > time + 2.0, 1]).max())
    assert sway[1] < left * sway[0] and sway[1] == pytest.approx(sway[2], abs=2e-3 * sway[0])
    assert sway[3] > fixed * sway[1]


# ------------------------------------------------------------------------------ files and runs


def test_a_refused_sample_leaves_a_shaper_as_it_was(of_ella):
    own = of_ella.sampled(STEP)
    with pytest.raises(UsageError, match=r"reference: .*not finite"):
        own.start([NAN, 0.0, 0.0])
    own.start([0.1, 0.2, 0.3])
    none, bad = [0.0] * 3, [NAN, 0.0, 0.0]
    for given in ((bad, none, none), (none, bad, none), ([1.0, 0.0, 0.0], none, bad)):
        before = own.memory.copy(), own.newest
        with pytest.raises(UsageError):
            own(*given)
        assert np.array_equal(own.memory, before[0]) and own.newest == before[1]


def test_a_run_beyond_the_bounds_of_a_shaper_says_so_once():
    model = rod()
    shaped = Shaped.of(screwgen.PD((60.0,), (14.0,), (0.5,), 0.1), screwgen.shape(model, [-0.2], [0.2], degree=0))
    with pytest.warns(ModelValidityWarning, match=r"the law was made for -0.2 to 0.2") as caught:
        screwgen.simulate(model, 0.12, 1e-3, controller=shaped)
    assert sum("the law was made for" in str(x.message) for x in caught) == 1


def test_laws_with_more_than_their_gains_are_not_cut_down():
    model, more = rod(), PID((60.0,), (14.0,), (0.5,), ki=(30.0,))
    shaper = screwgen.shape(model, [-1.0], [1.0], degree=0)
    calls = [lambda: screwgen.shape(model, [-1.0], [1.0], gains=more), lambda: Shaped.of(more, shaper)]
    calls += [lambda: screwgen.plan(model, [0.0], [0.5], 0.9, gains=more)]
    calls += [lambda: screwgen.FeedforwardPD.of(more, model)]
    calls += [lambda: Shaped.of(screwgen.FeedforwardPD.of(LAW, model), shaper)]
    for call in calls:
        with pytest.raises(UsageError, match=r"which would be left out; give a"):
            call()


def test_a_command_writes_a_shaper_that_a_run_plays(tmp_path, capsys):
    model = rod()
    (tmp_path / "robot.toml").write_text(to_toml(model.robot.model_dump(exclude_unset=True)))
    (tmp_path / "gains.toml").write_text("kp = [60.0]\nkd = [1.0]\nq_des = [0.5]\nduration = 0.3\ngravity = true\n")
    robot, gains, file, run = (str(tmp_path / x) for x in ("robot.toml", "gains.toml", "shaper.toml", "run.npz"))
    assert main(["shape", robot, "-o", file, "--from=-1", "--to", "1", "--gains", gains]) == 0
    assert "poles of the closed loop" in capsys.readouterr().out
    made = screwgen.read_shaper(file)
    written = (tmp_path / "shaper.toml").read_text()
    assert made.law == "gains.toml" and shaper_text(made).splitlines()[1:] == written.splitlines()[1:]
    swing = []
    for control in (f"pd:{gains}", f"shaper:{file}"):
        words = ["simulate", robot, "--duration", "3", "--step", "1e-3", "-o", run, "--controller", control, "--quiet"]
        assert main(words) == 0
        with np.load(run) as arrays:
            swing.append(np.ptp(arrays["tip_position"][arrays["t"] > 1.6], axis=0).max())
    assert swing[1] < 0.3 * swing[0]
    assert main(["shape", robot, "-o", str(tmp_path / "c"), "--from=-1", "--to", "1", "--target", "c", "--quiet"]) == 0
    assert (tmp_path / "c" / "arm_shaper.c").exists()


def test_what_is_no_shaper_is_one_line(tmp_path):
    model = rod()
    text = shaper_text(screwgen.shape(model, [-1.0], [1.0]))
    for old, new, said in (
        ('kind = "zv"', 'kind = "zx"', "there is no kind 'zx'"),
        ('vibrates = "', 'vibrates = "*/', "vibrates must be one of"),
        ("powers = [[0]", "powers = [[0.5]", "powers must be whole numbers from 0 to 12"),
        ("powers = [[0]", "powers = [[300]", "powers must be whole numbers from 0 to 12"),
        ("lower = [-1.0]", "lower = [2.0]", "lower < upper"),
        ("powers = ", "power = ", "'powers' is missing"),
    ):
        (tmp_path / "bad.toml").write_text(text.replace(old, new))
        with pytest.raises(UsageError, match=rf"bad\.toml: cannot be read as a shaper \(.*{said}"):
            screwgen.read_shaper(tmp_path / "bad.toml")
    (tmp_path / "s.toml").write_text(text)
    with pytest.raises(UsageError, match=r"law: names no file of a joint law"):
        read_shaped(tmp_path / "s.toml", model)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"modes": 3}, "3 motions are asked for, there are 2"),
        ({"kind": "ramp"}, "kind: there is no 'ramp'"),
        ({"payload": ("rod.mas", 1.0, 2.0)}, r"payload: there is no parameter 'rod\.mas'"),
        ({"gains": screwgen.PD((0.5,), (0.1,), (0.0,)), "lower": [1.3], "upper": [1.7]}, "a motion grows"),
        ({"degree": 13}, "degree"),
        (
            {"lower": [1.0]},
            r"lower, upper \(--from, --to\): 1 of rod\.joint\[0\] is above 0\.5; give the lesser one first",
        ),
    ],
)
def test_what_cannot_be_shaped_is_one_line(more, said):
    with pytest.raises(UsageError, match=said) as caught:
        screwgen.shape(rod(), **({"lower": [-1.0], "upper": [0.5]} | more))
    assert "\n" not in str(caught.value)
