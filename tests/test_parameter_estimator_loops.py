"""The filter of parameters for robots with loops: beside differences, a tree, its C; a payload that is not known."""

import subprocess
from functools import cache

import numpy as np
import pytest
from conformance.c_warnings import WARNINGS
from conftest import require_tool
from helpers import QUICK, unfolded
from test_analyse_loops import one_bar, parallelogram
from test_identify_loops import START, Held, four_bar, torque

import screwgen
from screwgen.backends.c.project import CProject
from screwgen.errors import SingularError, UsageError
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.runtime.parameter_states import ParameterState
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.parameter_estimator import ParameterEstimator

PAYLOAD, LENGTH, STEP, FIBRE = "coupler.bodies[0].mass", "coupler.length", 4e-3, 0.01
MOUNT, TOLD = "rocker.joint.mount.xyz[0]", ["encoder", "strain"]


@cache
def run():
    """States and efforts of the four-bar linkage, by another method at finer steps; efforts are held over samples."""
    model, law = four_bar(), Held(torque, STEP)
    q0 = screwgen.equilibrium(model, q=START, hold=True).q
    found = screwgen.simulate(model, 2.0, STEP / 20, q0=q0, controller=law, integrator="rk4", backend="c")
    return found.q[::20], found.v[::20], found.tau[::20]


@cache
def readings():
    """All encoders and the gauge of that run with 1 % of noise, and the deviations of that noise."""
    q, _, _ = run()
    strain = -FIBRE * q[:, 3:] @ four_bar().numpy().strain_slopes()[0]
    both = np.column_stack([q[:, :3], strain])
    sizes = 0.01 * both.std(axis=0)
    return both + sizes * np.random.default_rng(0).standard_normal(both.shape), sizes


DENSITY = np.array([1e-3, 1e-3, 1e-3, 1e-2, 1e-2])
DEVIATION = np.array([0.02, 0.05, 0.05, 1e-3, 1e-4])


def followed(filters, samples=None, told=(0,)):
    """Filters that are told of the joints `told` and the gauge of that run, sample by sample."""
    (q, v, tau), (read, sizes), rest = run(), readings(), np.zeros((3, 6))
    noise = Noise(DENSITY, encoder=sizes[:3], strain=sizes[3:], fibre=FIBRE)
    for e in filters:
        e.start(q[0], v[0], DEVIATION, 0.05, noise)
    for k in range(1, 1 + (samples or len(q) - 1)):
        for e in filters:
            e.predict(tau[k - 1], rest, STEP)
            encoder = np.where(np.isin(range(3), told), read[k, :3], np.nan)
            e.update(tau[k], rest, encoder=encoder, strain=read[k, 3:])
        yield k


def compiled(states, off=None, model=None):
    return CompiledEstimator(model or four_bar(), off, flags=QUICK, measurements=TOLD, states=states)


def numpy_of(states, off=None):
    return ParameterEstimator(four_bar(), states, off, TOLD)


# ------------------------------------------------------------------------------ what it finds


def test_a_payload_that_is_30_percent_off_is_found_within_1_percent():
    """In a closed four-bar linkage, from the crank's encoder and a gauge with 1 % of noise, in two seconds."""
    found = compiled([ParameterState(PAYLOAD, 0.3)], {PAYLOAD: 0.7 * 0.8})
    for _ in followed([found]):
        pass
    assert found.values[PAYLOAD] == pytest.approx(0.8, rel=0.01)
    assert abs(found.values[PAYLOAD] - 0.8) < 3 * found.deviations[PAYLOAD] < 0.03 * 0.8


def test_a_length_that_is_off_is_found_and_the_loops_close_at_what_is_found():
    found = compiled([ParameterState(LENGTH, 0.03)], {LENGTH: 0.93})
    for _ in followed([found], told=(0, 1, 2)):
        pass
    assert found.values[LENGTH] == pytest.approx(0.9, rel=2e-3)
    assert abs(found.values[LENGTH] - 0.9) < 3 * found.deviations[LENGTH]
    assert np.max(np.abs(np.hstack(at(found.values).gaps(*found.state)))) < 1e-11


def test_numpy_and_c_are_the_same():
    """With a mass, a length and a mount, of which the last two move coordinates."""
    states = [ParameterState(PAYLOAD, 0.1, 0.02), ParameterState(LENGTH, 0.01, 1e-5), ParameterState(MOUNT, 0.01)]
    filters = compiled(states, {PAYLOAD: 0.7}), numpy_of(states, {PAYLOAD: 0.7})
    for _ in followed(filters, 25):
        (one, P), (other, R) = (([*np.hstack(e.state), *e.values.values()], e.covariance) for e in filters)
        sd = np.sqrt(np.diag(R))
        assert np.max(np.abs(np.subtract(one, other)) / sd) < 1e-8
        assert np.max(np.abs(P - R) / np.outer(sd, sd)) < 1e-8
    assert filters[0].values[PAYLOAD] != 0.7 and filters[0].values[MOUNT] != 0.8


def test_a_parallelogram_finds_what_one_bar_finds():
    """The coupler never turns, so the bar has its mass at the tip; one encoder there is worth the three here."""
    shut, bar, sd, rng = parallelogram(20.0), one_bar(), 2e-3, np.random.default_rng(0)
    found = ParameterEstimator(shut, [ParameterState("coupler.rhoA", 0.3)], measurements=["encoder"])
    other = ParameterEstimator(bar, [ParameterState("bar.bodies[0].mass", 0.15)], measurements=["encoder"])
    found.start([0.4, -0.4, 0.4], [0.5, -0.5, 0.5], 0.05, 0.4, Noise(0.0, encoder=sd))
    size = 1 / np.sqrt(3)
    other.start([0.4], [0.5], 0.05 * size, 0.4 * size, Noise(0.0, encoder=sd * size))
    for _ in range(12):
        found.predict([20.0, 0.0, 0.0], None, STEP)
        other.predict([20.0], None, STEP)
        z = 0.41 + sd * rng.normal(size=3)
        found.update([20.0, 0.0, 0.0], None, encoder=z * [1, -1, 1])
        other.update([20.0], None, encoder=[z.mean()])
    mass, its = (next(iter(x.values())) for x in (other.values, other.deviations))
    assert abs(mass - 0.75) > 1e-6
    assert abs(0.5 * found.values["coupler.rhoA"] - mass) < 1e-8 * its
    assert 0.5 * found.deviations["coupler.rhoA"] == pytest.approx(its, rel=1e-8)
    own = found.covariance[np.ix_([0, 3, 6], [0, 3, 6])] * np.outer([1, 1, 0.5], [1, 1, 0.5])
    spread = np.sqrt(np.diag(other.covariance))
    assert np.max(np.abs(own - other.covariance) / np.outer(spread, spread)) < 1e-8


# ------------------------------------------------------------------------------ derivatives


def at(values: dict):
    """The four-bar linkage with other parameters, in NumPy."""
    model = four_bar()
    return model.numpy(model.chain.parameters.vector(values))


def started(deviation: float = 1e-2) -> ParameterEstimator:
    """A filter of two lengths, whose joints give way where these are others."""
    found = numpy_of([ParameterState(LENGTH, deviation), ParameterState(MOUNT, deviation)])
    q, v, _ = run()
    found.start(q[100], v[100], [0.01, 0.1, 0.1, 1e-3, 1e-3], 0.1, Noise(0.0, encoder=1e-3, strain=1e-6, fibre=FIBRE))
    return found


def test_changes_of_the_covariance_keep_loops_closed_as_differences_say():
    """Gaps and their rates along columns of the covariance, parameters moved with the state."""
    found, h = started(), 1e-6
    (q, v), P, start = found.state, found.covariance, found.values

    def open_by(d):
        values = {name: x + s for (name, x), s in zip(start.items(), d[10:], strict=True)}
        return np.hstack(at(values).gaps(q + d[:5], v + d[5:10]))

    sd = np.sqrt(np.diag(P))
    for weights in np.random.default_rng(3).normal(size=(2, 12)):
        column = P / sd @ weights
        size = np.abs(column).max()
        slope = (open_by(h * column / size) - open_by(-h * column / size)) / (2 * h)
        assert np.max(np.abs(slope)) < 1e-7
    assert np.min(np.max(np.abs(P[:5, 10:]) / np.outer(sd[:5], sd[10:]), axis=0)) > 0.1


def test_a_step_carries_what_is_not_known_of_lengths_as_steps_with_other_lengths_say():
    """Of closed states along one direction of the covariance; the rule and the step are of second order in h."""
    found, rest, errors = started(), np.zeros((3, 6)), []
    (q, v), P, start, size = found.state, found.covariance, found.values, 1e-5
    way = P[:, 10] / P[10, 10]

    def after(s, h):
        values = {name: x + s * way[10 + k] for k, (name, x) in enumerate(start.items())}
        e = Estimator(four_bar(), values, TOLD)
        e.start(q + s * way[:5], v + s * way[5:10], 0.0, 0.0, Noise(0.0))
        e.predict([1.0, 0.0, 0.0], rest, h)
        return np.hstack(e.state)

    for h in (2e-3, 1e-3):
        found = started()
        found.predict([1.0, 0.0, 0.0], rest, h)
        column = found.covariance[:, 10] / found.covariance[10, 10]
        slope = (after(size, h) - after(-size, h)) / (2 * size)
        errors.append(np.abs(column[:10] - slope) / np.maximum(1.0, np.abs(slope)))
    assert np.max(errors[1]) < 1e-3 and np.max(errors[1]) < np.max(errors[0]) / 3


# ------------------------------------------------------------------------------ what users see


def test_a_mount_that_no_motion_follows_is_refused():
    """A planar linkage out of its plane: in Python, C and where the C is written."""
    said = r"does not find rocker\.joint\.mount\.xyz\[1\]: it opens loops, and no motion closes them again"
    for make in (numpy_of, compiled):
        with pytest.raises(UsageError, match=said):
            make([ParameterState(MOUNT.replace("[0]", "[1]"), 0.01)])
    with pytest.raises(UsageError, match=said):
        CProject(four_bar().chain, "0", estimate=MOUNT.replace("[0]", "[1]"))


@pytest.mark.parametrize("make", [numpy_of, compiled])
def test_an_update_that_leads_astray_changes_nothing(make):
    """A length at which the linkage cannot close."""
    (q, v, _), rest = run(), np.zeros((3, 6))
    found = make([ParameterState(LENGTH, 1.0)])
    found.start(q[0], v[0], 1.0, 1e-2, Noise(1.0, 0.0, encoder=1e-6))
    before = [*found.state, found.covariance]
    with pytest.raises(SingularError, match=r"loops do not close|singular"):
        found.update([0.0] * 3, rest, encoder=[2.5, -4.0, 3.0])
    assert all(np.array_equal(a, b) for a, b in zip(before, [*found.state, found.covariance], strict=True))
    assert found.values == {LENGTH: 0.9}
    found.predict([0.0] * 3, rest, STEP)


@pytest.mark.parametrize("define", [[], ["-DARM_REAL_FLOAT"]])
def test_the_folder_compiles_without_a_warning(tmp_path, define):
    files = CProject(four_bar().chain, "0", estimator=TOLD, estimate=[LENGTH, PAYLOAD]).files()
    sources = unfolded(tmp_path, files)
    command = [require_tool("gcc"), *WARNINGS, *define, "-fsyntax-only", *sources]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0 and not done.stderr, done.stderr[:2000]
    assert "arm_gaps_by_p" in files["arm_by_p.h"]
