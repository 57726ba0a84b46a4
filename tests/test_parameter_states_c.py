"""The filter of parameters in generated C: beside that in NumPy, on a payload that is picked up, in failure."""

import subprocess
from functools import cache

import numpy as np
import pytest
from conformance.c_warnings import WARNINGS
from conftest import require_tool
from helpers import QUICK, arm, example_file, model_of, unfolded
from test_parameter_estimator import (
    PAYLOAD,
    STIFFNESS,
    UPPER,
    ella_picks_up,
    filtered,
    picked_up,
    rod,
    stopped,
    swung,
    tip_error,
)

from screwgen.backends.c.project import CProject
from screwgen.cli.main import main
from screwgen.errors import UsageError
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.runtime.parameter_states import ParameterState
from screwgen.simulation.parameter_estimator import ParameterEstimator

LENGTH, TOLD = "rod.length", ["encoder", "strain"]
STATES = [ParameterState(PAYLOAD, 0.02, 0.02), ParameterState(LENGTH, 1e-3), ParameterState(STIFFNESS, 0.5)]


@cache
def motion(until):
    return tuple(picked_up(rod(), swung, [-1.5, 0.0], {PAYLOAD: 0.9}, 0.4, until, 4e-3))


def compiled(model, states, told=TOLD, **more):
    return CompiledEstimator(model, flags=QUICK, measurements=told, states=states, **more)


def test_thousand_samples_are_those_of_the_filter_in_numpy():
    """To 1e-12: values, mean and covariance; with a length, of which the gauge's number follows.

    A coordinate of 1.5 rad is measured to 1e-4 rad: of the innovation's square four digits less are left.
    """
    model, (q, v, tau) = rod(), motion(4.0)
    filters = compiled(model, STATES), ParameterEstimator(model, STATES, measurements=TOLD)
    errors = np.zeros(4)
    for _ in zip(*(filtered(e, q, v, tau, 4e-3) for e in filters), strict=True):
        (one, P), (other, R) = (([*e.values.values(), *np.hstack(e.state)], e.covariance) for e in filters)
        sizes, sd = np.abs(other), np.sqrt(np.diag(R))
        sizes[len(STATES) :] = np.maximum(sizes[len(STATES) :], 0.1)
        off = np.abs(np.subtract(one, other)) / sizes
        apart = np.subtract(*(e.consistency.squared for e in filters)) / max(1.0, filters[1].consistency.squared)
        now = off[: len(STATES)].max(), off.max(), (np.abs(P - R) / np.outer(sd, sd)).max(), abs(apart)
        errors = np.maximum(errors, now)
    assert len(q) == 1001 and max(errors[:3]) < 1e-12 and errors[3] < 1e-10, errors
    assert list(filters[0].values) == [name for name in model.parameter_names if name in filters[0].values]
    assert abs(filters[0].values[PAYLOAD] / 0.9 - 1.0) < 0.02


@pytest.mark.parametrize("single", [False, True])
def test_ella_finds_its_payload_in_a_second(single):
    """One kilogram more: within 1 % and 0.4 mm at the tip, in double and in float."""
    model, (q, v, tau), state = ella_picks_up()
    found = compiled(model, [state], single=single)
    for _ in filtered(found, q, v, tau, 2e-3):
        pass
    assert found.values[state.parameter] == pytest.approx(3.1, rel=0.01)
    assert found.deviations[state.parameter] < 0.01 * 3.1
    assert tip_error(model, found, q[-1]) < 0.4e-3


def test_values_stay_within_their_bounds():
    model, (q, v, tau) = rod(), motion(1.4)
    found = compiled(model, [ParameterState(PAYLOAD, 0.02, 0.02, lower=0.4, upper=0.6)])
    values = [found.values[PAYLOAD] for _ in filtered(found, q, v, tau, 4e-3)]
    assert max(values) == 0.6 and min(values) >= 0.4


def test_after_a_new_start_it_is_at_the_first_values_again():
    model, (q, v, tau) = rod(), motion(1.4)
    found, runs = compiled(model, STATES), []
    for _ in range(2):
        runs.append([tuple(found.values.values()) for _ in filtered(found, q, v, tau, 4e-3)])
    assert runs[0] == runs[1] and runs[0][-1] != runs[0][0]


def test_an_update_whose_parameters_no_robot_has_changes_nothing():
    """A hard push back from the stop says that it begins below the other one: not a byte of the filter changes."""
    found, other = (compiled(stopped(), [ParameterState(UPPER, 0.1)], ["acceleration"]) for _ in range(2))
    for e in (found, other):
        e.start([1.1], [0.0], 1e-3, 1e-3, Noise(1e-3, acceleration=1e-3))
    before = [*found.state, found.covariance, found.values]
    with pytest.raises(UsageError, match=r"the update leads to parameters that no robot has; give the states bounds"):
        found.update([0.0], np.zeros((1, 6)), acceleration=[0.0, -80.0, 9.81])
    assert all(np.array_equal(a, b) for a, b in zip(before[:3], [*found.state, found.covariance], strict=True))
    assert found.values == before[3]
    for e in (found, other):
        e.update([0.0], np.zeros((1, 6)), acceleration=[0.0, -22.0, 9.81])
        e.predict([0.0], np.zeros((1, 6)), 1e-3)
    assert np.array_equal(found.covariance, other.covariance) and found.values == other.values
    assert found.values[UPPER] < before[3][UPPER]


def test_a_filter_of_parameters_is_not_put():
    found = compiled(rod(), STATES)
    with pytest.raises(UsageError, match="a filter of parameters is not put into a state; start it there"):
        found.put(np.zeros(2), np.zeros(2), np.zeros((4, 4)))


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_the_folder_compiles_without_a_warning(tmp_path, compiler):
    """With a gauge's numbers, accelerations, attitudes and gravity among the parameters; beside other derivatives."""
    told = [*TOLD, "acceleration", "marker_attitude@rod.tip"]
    names = ["gravity[1]", LENGTH, PAYLOAD]
    files = CProject(rod().chain, "0", estimator=told, estimate=names, by_p=names).files()
    sources = unfolded(tmp_path, files)
    for define in ([], ["-DARM_REAL_FLOAT"]):
        command = [require_tool(compiler), *WARNINGS, *define, "-fsyntax-only", *sources]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0 and not done.stderr, done.stderr[:2000]
    assert "`rod.length`" in files["README.md"] and "arm_step_modal_midpoint_by_p" in files["arm_by_p.h"]


PROGRAM = r"""
#include <stdio.h>
#include <string.h>
#include "arm_estimator.h"
static arm_parameters p;
static arm_constants c, c0;
static arm_estimator e, e0;
static arm_estimator_work work;
static arm_state x, deviation;
static arm_input u;
static arm_measurement z;
static void say(int status)
{
    printf("%d %d ", status, !memcmp(&e, &e0, sizeof e) && !memcmp(&c, &c0, sizeof c));
}
int main(void)
{
    const arm_real deviation_p[ARM_NBY_P] = { (arm_real)0.1 }, wrong[ARM_NBY_P] = { -1 };
    arm_parameters_default(&p);
    printf("%d ", arm_prepare(&p, &c));
    x.q[0] = (arm_real)1.1;
    deviation.q[0] = deviation.v[0] = (arm_real)1e-3;
    printf("%d %d ", arm_estimator_init(&p, &x, &deviation, &e, 0), arm_estimator_init(&p, &x, &deviation, &e, wrong));
    printf("%d ", arm_estimator_init(&p, &x, &deviation, &e, deviation_p));
    e.acceleration_variance[1] = (arm_real)1e-6;
    z.has_acceleration[1] = 1;
    e0 = e, c0 = c;
    z.acceleration[1] = -80;
    say(arm_estimator_update(&c, &e, &u, &z, &work));
    e.lower[0] = e.upper[0] = e0.lower[0] = e0.upper[0] = 1;
    say(arm_estimator_update(&c, &e, &u, &z, &work));
    e.lower[0] = e0.lower[0] = (arm_real)0.95;
    e.upper[0] = e0.upper[0] = 2;
    e.density_p[0] = e0.density_p[0] = -1;
    say(arm_estimator_predict(&c, &e, &u, (arm_real)1e-3, &work));
    say(arm_estimator_update(&c, &e, &u, &z, &work));
    printf("%g ", (double)e.parameters.links[0].joint.limits_upper[0]);
    c0 = c;
    printf("%d ", arm_prepare(&e.parameters, &c0));
    printf("%d ", !memcmp(&c, &c0, sizeof c));
    printf("%d ", arm_estimator_init(&e.parameters, &x, &deviation, &e, deviation_p));
    printf("%g\n", (double)e.parameters.links[0].joint.limits_upper[0]);
    return 0;
}
"""


@pytest.mark.parametrize("real", ["double", "float"])
def test_statuses_and_what_they_leave(tmp_path, real):
    """Refused calls change no byte of filter and constants; others prepare the constants for what they find."""
    files = CProject(stopped().chain, "0", estimator=["acceleration"], estimate=[UPPER]).files()
    sources = [x for x in unfolded(tmp_path, files | {"main.c": PROGRAM}) if x != "main.c"]
    define = ["-DARM_REAL_FLOAT"] * (real == "float")
    sanitize = ["-fsanitize=address,undefined", "-fno-sanitize-recover"]
    command = [require_tool("gcc"), "-std=c99", "-g", *sanitize, *define, "-o", "arm", "main.c", *sources, "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    said = subprocess.run([tmp_path / "arm"], capture_output=True, text=True, check=True).stdout.split()
    bad = "3"
    assert said[:4] == ["0", bad, bad, "0"], said
    assert said[4:10] == [bad, "1", bad, "1", bad, "1"], said
    assert said[10:12] == ["0", "0"] and said[12] == "0.95", said
    assert said[13:] == ["0", "1", "0", "0.95"], said


def test_the_command(tmp_path, capsys):
    def generate(*more):
        robot = example_file("ella_paper")
        return main(["generate", str(robot), "-o", str(tmp_path / "o"), "--target", "c", "-q", *more])

    assert generate("--estimate", "forearm.bodies*.mass", "--measure", "encoder") == 0
    text = (tmp_path / "o" / "c" / "ella_by_p.h").read_text()
    assert "0: forearm.bodies[0].mass" in text and "ella_accelerations_by_p" in text and "energy_by_p" not in text
    assert "lower[ELLA_NBY_P]" in (tmp_path / "o" / "c" / "ella_estimator.h").read_text()
    assert generate("--estimate", "forearm.mass") == 2
    assert "there is no 'forearm.mass'" in capsys.readouterr().err


REFUSED = {
    'give parameters="runtime"': dict(binding="baked", estimate=PAYLOAD),
    "by_p and estimate stand for different parameters": dict(by_p=LENGTH, estimate=PAYLOAD),
}


@pytest.mark.parametrize("words", REFUSED)
def test_what_does_not_fit_gets_a_line(words):
    with pytest.raises(UsageError, match=words):
        CProject(rod().chain, "0", **REFUSED[words])


def test_limits_of_efforts_are_refused():
    limits = {"joint": {"axes": ["z"], "limits": [{"effort": 3.0}]}, "bodies": [{"at": "tip", "mass": 1.0}]}
    with pytest.raises(UsageError, match="it decides what a step holds of its inputs"):
        CProject(model_of(arm({"name": "rod", "length": 0.5} | limits)).chain, "0", estimate="*.effort")
