"""Motions that excite what is sought: within limits, playable, and better than random ones in simulated fits."""

import numpy as np
import pytest
from helpers import arm, link, model_of
from identified_arms import SENSORS, TRUE, elsewhere, fits_of, pendulum

import screwgen
from screwgen.cli.main import main
from screwgen.errors import UsageError
from screwgen.identification.excited_motions import MotionMaker, Motions, RestingArm
from screwgen.identification.fourier import FourierSeries
from screwgen.planning.limits import motion_limits
from screwgen.simulation.named_controllers import read_controller

FREE = ["rod.EIz", "rod.damping.ratio", "*.rotor_inertia", "*.coulomb", "*.viscous", "*.mass"]
LIMITS = {"lower": [-3.0], "upper": [0.0], "rates": [3.0], "efforts": [8.0]}
SECONDS, STEP = 2.0, 1e-3
FITS = 6


def excited():
    """The motion that is sought for the pendulum."""
    return screwgen.excite(
        pendulum(),
        free=FREE,
        sensors=SENSORS,
        limits=LIMITS,
        time=SECONDS,
        start=[-1.5],
        bandwidth=5.0,
        window=0.5,
        generations=15,
    )


@pytest.fixture(scope="module")
def found():
    return excited()


def test_series_begin_and_end_at_rest_and_have_the_rates_of_their_values():
    series = FourierSeries(SECONDS, STEP, 6.0)
    factors = np.random.default_rng(0).standard_normal(series.size)
    q, v, a = (basis @ factors for basis in (series.values, series.rates, series.accelerations))
    for curve in (q, v, a):
        assert np.abs(curve[[0, -1]]).max() < 1e-12 * np.abs(curve).max()
    assert np.gradient(q, STEP)[1:-1] == pytest.approx(v[1:-1], abs=1e-3 * np.abs(v).max())
    assert np.gradient(v, STEP)[1:-1] == pytest.approx(a[1:-1], abs=1e-3 * np.abs(a).max())


def test_a_motion_that_diverged_is_beyond_its_limits_though_nothing_limits_efforts():
    model = pendulum()
    limits = motion_limits(model, {}, None, 1.0)
    assert np.isinf(limits.efforts).all()
    begin = RestingArm(np.zeros(model.nq), np.zeros(1), (0,))
    maker = MotionMaker(model, FourierSeries(SECONDS, STEP, 6.0), begin, limits, np.array(model.parameter_values))
    still = np.zeros((2, 5, model.nq))
    made = Motions(still, still, np.repeat([0.0, np.inf], 5).reshape(2, 5, 1), np.zeros((2, 3, 5, 1)))
    assert maker.share_taken(made).tolist() == [0.0, np.inf]


def test_series_whose_time_is_no_whole_number_of_steps_end_at_rest():
    series = FourierSeries(1.0, 3e-3, 6.0)
    for basis in (series.values, series.rates, series.accelerations):
        assert np.abs(basis[[0, -1]]).max() < 1e-12 * np.abs(basis).max()


@pytest.mark.parametrize(
    ("stated", "words"),
    [
        (
            {"bandwidth": 3000.0},
            "bandwidth: is 3000 Hz, and samples are 0.001 s apart; state a tenth of the sample rate",
        ),
        ({"time": 0.01}, "time: is 0.01 s; a motion takes 20 steps at least, 0.02 s"),
    ],
)
def test_frequencies_that_samples_do_not_show_are_refused(stated, words):
    with pytest.raises(UsageError, match=words):
        screwgen.excite(pendulum(), free=FREE, limits=LIMITS, start=[-1.5], **stated)


def test_what_no_motion_tells_is_not_determined():
    """Two masses at one point add up: no motion tells them apart."""
    joint = {"axes": ["z"], "drives": [{"friction": {"viscous": 0.2}}]}
    bodies = [{"at": "tip", "mass": 0.5}, {"at": "tip", "mass": 0.3}]
    model = model_of(arm({"name": "rod", "length": 1.0, "joint": joint, "bodies": bodies}))
    free = ["*.mass", "*.viscous"]
    found = screwgen.excite(model, free=free, limits=LIMITS, time=1.0, start=[-1.5], generations=0)
    of = dict(zip((one.name for one in found.unknowns), found.deviation, strict=True))
    assert [np.isinf(x) for x in of.values()] == ["viscous" not in name for name in of]
    assert np.isnan(found.narrower) and len(found.undetermined) == 1
    lines = found.summary().splitlines()
    assert sum("not determined, by a random motion not determined" in x for x in lines) == 2
    assert lines[-1] == "of 3 numbers 2 are not determined, by a random motion 2"


def test_the_widest_interval_is_three_times_narrower_than_by_a_random_motion_in_fits(found):
    """The fits start 30 % off; of both motions their errors are as large as the intervals say."""
    own, other = (
        fits_of(found, plan, pendulum(), elsewhere(), TRUE, FITS).error for plan in (found.plan, found.random)
    )
    assert found.narrower > 3.0
    for got, said in ((own, found.deviation), (other, found.deviation_of_random)):
        assert 0.6 < np.sqrt(np.mean((got / said) ** 2)) < 1.5
    assert np.sqrt(np.mean(other**2, axis=0)).max() > 3.0 * np.sqrt(np.mean(own**2, axis=0)).max()


def test_the_run_of_a_motion_keeps_its_limits_and_uses_them(found):
    run = found.run
    assert LIMITS["lower"][0] <= run.q[:, 0].min() and run.q[:, 0].max() <= LIMITS["upper"][0]
    shares = np.abs(run.v[:, 0]).max() / LIMITS["rates"][0], np.abs(run.tau).max() / LIMITS["efforts"][0]
    assert max(shares) <= 1.0 and max(shares) > 0.7


def test_strains_are_limits_too():
    free = screwgen.excite(pendulum(), free=FREE, sensors=SENSORS, limits=LIMITS, time=1.0, start=[-1.5], generations=0)
    most = 0.5 * np.abs(free.run.strain).max()
    bent = screwgen.excite(
        pendulum(), free=FREE, sensors=SENSORS, limits=LIMITS, time=1.0, start=[-1.5], generations=0, strain=most
    )
    assert np.abs(bent.run.strain).max() <= most


def test_a_motion_of_an_elastic_drive_is_that_of_its_rotor():
    """Limits are those of the rotor over the ratio, and of its torque times it; the run keeps them and uses them."""
    friction = {"coulomb": 0.02, "viscous": 1e-3, "velocity": 0.5}
    drive = {"ratio": 50.0, "rotor_inertia": 2e-4, "stiffness": 900.0, "damping": 2.0, "friction": friction}
    rod = link("rod", length=0.8, rhoA=0.1, bodies=[{"at": "tip", "mass": 2.0}], joint={"drives": drive})
    model = model_of(arm(rod, gravity=[0.0, -9.81, 0.0]))
    free = ["*.stiffness", "*.drives[0].damping", "*.viscous", "*.coulomb", "*.mass"]
    limits = {"lower": [-2.5], "upper": [-0.5], "rates": [3.0], "efforts": [30.0]}
    found = screwgen.excite(
        model, free=free, limits=limits, time=1.0, start=[-1.5], bandwidth=6.0, window=0.5, generations=6
    )
    run, angle = found.run, found.run.q[:, 1] / 50.0
    assert [column.measures for column in found.columns.sensors] == ["rod.theta[0]"]
    assert limits["lower"][0] <= angle.min() and angle.max() <= limits["upper"][0]
    assert angle[0] == pytest.approx(-1.5) and np.abs(run.q[:, 0] - angle).max() > 1e-2
    most = np.abs(run.v[:, 1]).max() / 50.0 / 3.0, 50.0 * np.abs(run.tau).max() / 30.0
    assert 0.7 < max(most) <= 1.0 and found.narrower > 2.0


def test_files_of_a_motion_play_its_run(found, tmp_path):
    model = pendulum()
    for name in ("motion.csv", "motion.npz"):
        with (tmp_path / name).open("wb") as stream:
            found.write(stream, tmp_path / name)
    inputs = read_controller(f"csv:{tmp_path / 'motion.csv'}", model)
    again = screwgen.simulate(model, SECONDS, STEP, q0=found.run.q[0], controller=inputs)
    assert np.abs(again.q - found.run.q).max() < 1e-9
    played = screwgen.simulate(
        model, SECONDS, STEP, controller=read_controller(f"plan:{tmp_path / 'motion.npz'}", model)
    )
    assert np.array_equal(played.q, found.run.q)


def test_the_command_writes_a_motion_and_prints_the_intervals(tmp_path, capsys):
    robot, limits, motion = (tmp_path / name for name in ("arm.toml", "limits.toml", "motion.csv"))
    robot.write_text(screwgen.dump(pendulum().robot))
    limits.write_text("free = ['rod.EIz']\nstart = [-1.5]\ntime = 1.0\nrates = [3.0]\nefforts = [8.0]\n")
    assert main(["excite", str(robot), "-o", str(motion), "--limits", str(limits), "--generations", "1"]) == 0
    said = capsys.readouterr().out.splitlines()
    assert said[0] == str(motion) and said[1].startswith("rod.EIz: ± ") and "by a random motion" in said[2]
    assert motion.read_text().startswith("t,rod.torque[0]\n") and len(motion.read_text().splitlines()) == 1002


WRONG = {
    "rates = [1.0]": "limits.toml: free: ",
    "free = ['rod.EIz']": "ranges and rates leave a joint free to go any way; state rates",
    "free = ['rod.EIz']\nrates = [-1.0]": "limits.toml: rates[0]: ",
    "free = ['rod.EIz']\nrates = [1.0]\nuper = [1.0]": "limits.toml: uper: ",
    "free = ['rod.EIx']\nrates = [1.0]": "free: there is no 'rod.EIx'",
    "free = ['rod.EIz']\nrates = [1.0]\nefforts = [1.0]": "no motion about the start is within them",
    "free = ['rod.EIz']\nrates = [1.0]\nupper = [-1.0]": "start: [",
}


@pytest.mark.parametrize("text", WRONG)
def test_limits_that_make_no_sense_get_a_line_and_nothing_is_written(text, tmp_path, capsys):
    robot, limits, motion = (tmp_path / name for name in ("arm.toml", "limits.toml", "motion.csv"))
    robot.write_text(screwgen.dump(pendulum().robot))
    limits.write_text(text + ("\nstart = [0.0]\n" if "efforts" in text or "upper" in text else "\n"))
    assert main(["excite", str(robot), "-o", str(motion), "--limits", str(limits), "--quiet"]) == 2
    assert WRONG[text] in capsys.readouterr().err and not motion.exists()


def test_a_run_that_breaks_a_limit_is_refused_with_its_name():
    """A law whose sampled loop is not stable: the joint shakes within the limit of its effort."""
    wild = screwgen.PD(kp=[3e5], kd=[0.0], q_des=[0.0])
    with pytest.raises(
        UsageError, match=r"limits: the rate rod\.joint_rate\[0\] reaches .* in a run of the motion under its law"
    ):
        screwgen.excite(pendulum(), free=FREE, limits=LIMITS, time=1.0, start=[-1.5], generations=0, gains=wild)
