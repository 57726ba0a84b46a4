"""Rollouts: their motions against the simulation's, shapes, parameters, failures, refusals."""

import os
import signal
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from feature_robots import model_with
from helpers import arm, example, link, model_of, quick_batch

import screwgen
from screwgen import ScrewgenError, UsageError, rollout
from screwgen.algorithms.robot_functions import offered
from screwgen.runtime.batch import compiled_batch
from screwgen.simulation.rollout_validity import ParameterWarning

STEP = 1e-3


@pytest.fixture(scope="module")
def ella():
    return example("ella")


def states(model, count: int, seed=0) -> np.ndarray:
    """Random postures at rest, (count, 2 nq)."""
    x = np.zeros((count, 2 * model.nq))
    x[:, : model.n_joints] = np.random.default_rng(seed).uniform(-1, 1, (count, model.n_joints))
    return x


def torques(count: int, steps: int, joints=3) -> np.ndarray:
    return np.random.default_rng(1).uniform(-20, 20, (count, steps, joints))


# -------- motions


def test_what_a_run_tells_of_its_samples_a_rollout_tells_of_all(ella):
    """The motion, wrenches, tips and energies, with torques, loads and payloads that differ; strains beside the linear
    model's. The simulation runs another implementation of the method."""
    x0, tau = states(ella, 3), torques(3, 4)
    w_ext, masses = np.random.default_rng(2).normal(size=(3, 4, 2, 6)), np.array([1.0, 2.0, 3.0])
    x0[:, ella.n_joints : ella.nq] = 1e-3
    given = {"forearm.bodies[0].mass": masses}
    run = rollout(ella, x0, tau, w_ext=w_ext, parameters=given, step=STEP)
    period = lambda t: min(round(t / STEP), 3)  # noqa: E731
    for k, mass in enumerate(masses):
        p = {"forearm.bodies[0].mass": mass}
        other = screwgen.simulate(
            *(ella, 4 * STEP, STEP),
            q0=x0[k, : ella.nq],
            controller=lambda t, q, v, k=k: tau[k, period(t)],
            w_ext=lambda t, q, v, k=k: w_ext[k, period(t)],
            parameters=p,
        )
        for name in ("q", "v", "wrench", "tip_position", "energy"):
            wanted = getattr(other, name)
            assert np.max(np.abs(getattr(run, name)[k] - wanted)) < 1e-9 * np.max(np.abs(wanted)), name
        linear = ella.linearise(run.q[k, 2], parameters=p, outputs="base_strain")
        assert np.allclose(run.base_strain[k, 2], linear.y, rtol=1e-12, atol=0)
    alone = rollout(ella, x0, tau, step=STEP)
    linear = ella.linearise(alone.q[1, 3], outputs="base_strain")
    assert np.allclose(alone.base_strain[1, 3], linear.y, rtol=1e-12, atol=0)


@pytest.mark.parametrize("feature", ["floating", "exact station", "tendons"])
def test_what_follows_from_states_alone_is_what_the_reference_says(feature):
    """By lanes of which some are idle, for more samples than constants are loaded for at once, one robot or many."""
    model, rng = model_with(feature), np.random.default_rng(3)
    quick_batch(model)
    x0 = np.array([np.concatenate((model.chain.home, np.zeros(model.chain.nvz)))] * 11)
    x0[:, model.nq :] = rng.normal(0, 0.3, (11, model.chain.nvz))
    many = np.array(model.parameter_values) * rng.uniform(0.9, 1.1, (11, 1))
    for p in (None, many):
        run = rollout(model, x0, step=STEP, steps=66, parameters=p)
        assert run.ok.all()
        rows = [row for row in offered(model.chain) if set(row.names) <= {"q", "v"} and row.c_file]
        for k, j in ((0, 0), (10, 66), (3, 64)):
            numeric, state = model.numpy(None if p is None else p[k]), {"q": run.q[k, j], "v": run.v[k, j]}
            assert np.allclose(run.tip_position[k, j], numeric.tip_pose(state["q"])[1], rtol=1e-9, atol=1e-12)
            for row in rows:
                found, wanted = getattr(run, row.name), getattr(numeric, row.name)(*(state[x] for x in row.names))
                several = isinstance(found, tuple)
                ours = np.concatenate([np.ravel(x[k, j]) for x in (found if several else (found,))])
                theirs = np.concatenate([np.ravel(x) for x in (wanted if isinstance(wanted, tuple) else (wanted,))])
                assert np.allclose(ours, theirs, rtol=1e-9, atol=1e-11), row.name


def test_what_follows_from_a_rollout_is_there_after_executors_and_in_sweeps(ella, tmp_path):
    x0 = states(ella, 3)
    with ThreadPoolExecutor(2) as threads:
        run = rollout(ella, x0, step=STEP, steps=2, executor=threads)
    assert np.array_equal(run.energy, rollout(ella, x0, step=STEP, steps=2).energy)
    keep, draw = (lambda run: run.tip_position[:, -1]), (lambda _, n: {"x0": x0[:n]})
    kept = screwgen.sweep(ella, draw, 3, tmp_path / "a.npy", step=STEP, steps=2, keep=keep)
    assert np.array_equal(kept.values, run.tip_position[:, -1])


def test_a_scenario_without_dynamics_has_samples_that_are_no_numbers(ella):
    x0 = states(ella, 2)
    x0[1, 0] = np.inf
    run = rollout(ella, x0, step=STEP, steps=2)
    assert np.isfinite(run.wrench[0]).all() and np.isnan(run.wrench[1]).all() and np.isnan(run.energy[1]).all()


def test_substeps_divide_a_sample_over_which_inputs_are_held(ella):
    x0, tau, w_ext = states(ella, 5), torques(5, 6), np.random.default_rng(2).normal(size=(5, 6, 2, 6))
    run = rollout(ella, x0, tau, step=STEP, substeps=4, w_ext=w_ext, integrator="rk4")
    fine = [np.repeat(a, 4, axis=1) for a in (tau, w_ext)]
    whole = rollout(ella, x0, fine[0], step=STEP / 4, w_ext=fine[1], integrator="rk4")
    assert np.array_equal(run.x, whole.x[:, ::4]) and (run.completed == 6).all()
    assert np.allclose(run.t, np.arange(7) * STEP)


def test_threads_change_no_bit(ella):
    x0, tau = states(ella, 50), torques(50, 10)
    one, two = (rollout(ella, x0, tau, step=STEP, threads=n) for n in (1, 2))
    assert np.array_equal(one.x, two.x)


def test_threads_after_a_fork(ella):
    """A process that had threads may fork, as executors do; the child has threads of its own."""
    x0 = states(ella, 50)
    expected = rollout(ella, x0, step=STEP, steps=2, threads=2)
    child = os.fork()
    if child == 0:
        run = rollout(ella, x0, step=STEP, steps=2, threads=2)
        os._exit(0 if np.array_equal(run.x, expected.x) else 1)
    until = time.monotonic() + 30
    while (ended := os.waitpid(child, os.WNOHANG)) == (0, 0) and time.monotonic() < until:
        time.sleep(0.01)
    if ended == (0, 0):
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
    assert ended == (child, 0)


# -------- shapes


def test_arguments_are_broadcast_to_one_batch(ella):
    x0, tau = states(ella, 3), torques(3, 5)
    full = rollout(ella, np.tile(x0[0], (3, 1)), tau, step=STEP)
    assert np.array_equal(rollout(ella, x0[0], tau, step=STEP).x, full.x)
    same = rollout(ella, x0, np.tile(tau[0], (3, 1, 1)), step=STEP)
    assert np.array_equal(rollout(ella, x0, tau[0], step=STEP).x, same.x)
    held = rollout(ella, x0, np.tile(tau[0, 0], (3, 5, 1)), step=STEP)
    assert np.array_equal(rollout(ella, x0, tau[0, 0], step=STEP, steps=5).x, held.x)
    assert np.array_equal(rollout(ella, x0, tau[0, :1], step=STEP, steps=5).x, held.x)
    pushed = rollout(ella, x0, step=STEP, steps=5, w_ext=np.ones((2, 6)))
    assert np.array_equal(pushed.x, rollout(ella, x0, step=STEP, w_ext=np.ones((3, 5, 2, 6))).x)
    alone = rollout(ella, x0[1], tau[1], step=STEP)
    assert alone.q.shape == (1, 6, ella.nq) and np.array_equal(alone.x[0], rollout(ella, x0, tau, step=STEP).x[1])


def test_nothing_to_do_is_done(ella):
    empty = rollout(ella, np.zeros((0, 2 * ella.nq)), step=STEP, steps=3)
    assert empty.q.shape == (0, 4, ella.nq) and empty.status.shape == (0,) and empty.report() == []
    still = rollout(ella, states(ella, 2), step=STEP, steps=0)
    assert np.array_equal(still.x[:, 0], states(ella, 2)) and still.ok.all()
    assert rollout(ella, states(ella, 2), torques(2, 0), step=STEP).q.shape == (2, 1, ella.nq)


def test_an_arm_without_joints_or_modes():
    model = model_of(arm(link("post", axes=())))
    run = rollout(model, np.zeros((4, 0)), step=STEP, steps=2)
    assert run.q.shape == (4, 3, 0) and run.ok.all()


def test_the_inputs_are_left_alone(ella):
    x0, tau = states(ella, 3), torques(3, 4)
    before = x0.copy(), tau.copy()
    rollout(ella, x0, tau, step=STEP)
    assert np.array_equal(x0, before[0]) and np.array_equal(tau, before[1])


# -------- parameters


def test_parameters_by_name_and_as_vectors(ella):
    name, masses = "forearm.bodies[0].mass", np.array([0.5, 2.1, 5.0])
    x0, tau = states(ella, 3), torques(3, 20)
    run = rollout(ella, x0, tau, step=STEP, parameters={name: masses, "gravity[2]": -3.7})
    p = np.tile(ella.parameter_values, (3, 1))
    p[:, ella.parameter_names.index(name)] = masses
    p[:, ella.parameter_names.index("gravity[2]")] = -3.7
    assert np.array_equal(run.x, rollout(ella, x0, tau, step=STEP, parameters=p).x)
    assert np.array_equal(run.x[[2]], rollout(ella, x0[2], tau[2], step=STEP, parameters=p[2]).x)
    assert not np.allclose(run.q[0, -1], rollout(ella, x0, tau, step=STEP).q[0, -1], rtol=1e-3)


# -------- failures


def test_failed_scenarios_are_reported_and_the_others_go_on(ella):
    x0, tau = states(ella, 6), torques(6, 8)
    good = rollout(ella, x0, tau, step=STEP)
    tau[2, 5, 1], x0[4, 3] = np.nan, np.inf
    run = rollout(ella, x0, tau, step=STEP)
    assert list(run.ok) == [True, True, False, True, False, True] and list(run.completed) == [8, 8, 5, 8, 0, 8]
    assert np.array_equal(run.x[run.ok], good.x[run.ok])
    assert np.array_equal(run.x[2, :6], good.x[2, :6]) and (run.x[2, 6:] == good.x[2, 5]).all()
    lines = run.report()
    assert lines[0] == "scenario 2 stopped at t = 0.005 s: its state or a result is not finite"
    assert lines[1].startswith("scenario 4 stopped at t = 0 s") and len(lines) == 2
    assert repr(run) == "<Rollout of 6 scenarios, 8 steps to 0.008 s, 2 stopped: see report()>"
    assert repr(good) == "<Rollout of 6 scenarios, 8 steps to 0.008 s>"


@pytest.mark.parametrize("single", [False, True])
def test_parameters_that_no_robot_has_stop_their_scenario_alone(ella, single):
    x0, rhoA = states(ella, 4), np.array([2.0, -1.0, 2.1, np.inf])
    with pytest.warns(ParameterWarning) as warned:
        run = rollout(ella, x0, step=STEP, steps=3, parameters={"forearm.rhoA": rhoA}, single=single)
    said = (
        "scenario 1 did not run (status 3): parameters: forearm.rhoA is -1; it must be > 0; 1 more such: see report()"
    )
    assert [str(x.message) for x in warned] == [said] and warned[0].filename == __file__
    good = rollout(ella, x0[::2], step=STEP, steps=3, parameters={"forearm.rhoA": rhoA[::2]}, single=single)
    assert list(run.status) == [0, 3, 0, 3] and list(run.completed) == [3, 0, 3, 0]
    assert np.array_equal(run.x[::2], good.x) and np.allclose(run.x[1], x0[1], atol=1e-7)
    assert run.report()[0] == "scenario 1 stopped at t = 0 s: parameters: forearm.rhoA is -1; it must be > 0"
    with ThreadPoolExecutor(1) as executor, pytest.warns(ParameterWarning):
        again = rollout(
            ella, x0, step=STEP, steps=3, parameters={"forearm.rhoA": rhoA}, single=single, executor=executor
        )
    assert again.report() == run.report() and np.array_equal(again.x, run.x)


def test_a_singular_scenario_names_the_link():
    bare = [link("rod", axes="x"), link("blade", axes="z")]
    for table in bare:
        table["section"] = {"rhoA": 1.0}
    model = model_of(arm(*bare))
    run = rollout(model, [[0.1, angle, 0.0, 0.0] for angle in (0.7, 0.0, -0.4)], step=STEP, steps=3)
    assert list(run.status) == [0, 2, 0] and list(run.fault) == [-1, 0, -1]
    assert "scenario 1 stopped at t = 0 s: link 'rod'" in run.report()[0]


# -------- refusals

REFUSED = {
    "x0 is of the wrong length": ({"x0": np.zeros(5)}, "x0 has the shape (5,)"),
    "x0 has an axis too many": ({"x0": np.zeros((2, 3, 18))}, "x0 has the shape (2, 3, 18)"),
    "x0 is ragged": ({"x0": [[1.0], [1.0, 2.0]]}, "x0 is not an array of numbers"),
    "x0 is words": ({"x0": "upright"}, "x0 is not an array of numbers"),
    "too few torques": ({"tau": np.zeros((4, 2))}, "tau has the shape (4, 2)"),
    "wrenches": ({"w_ext": np.zeros((4, 6))}, "w_ext has the shape (4, 6)"),
    "batches differ": ({"x0": np.zeros((3, 18)), "tau": np.zeros((2, 5, 3))}, "scenarios differ: x0 3, tau 2"),
    "sequences differ": ({"tau": np.zeros((5, 3)), "w_ext": np.zeros((4, 2, 6))}, "steps differ: tau 5, w_ext 4"),
    "steps differ": ({"tau": np.zeros((5, 3)), "steps": 4}, "steps is 4, but tau has 5"),
    "one step of five": ({"tau": np.zeros((5, 3)), "steps": 1}, "steps is 1, but tau has 5"),
    "no steps": ({"steps": None}, "nothing says how many steps"),
    "a negative step": ({"step": -1e-3}, "step is -0.001"),
    "a step that is none": ({"step": float("nan")}, "step is nan"),
    "a step in words": ({"step": "short"}, "step is 'short'"),
    "half a step": ({"steps": 2.5}, "steps is 2.5"),
    "no substeps": ({"substeps": 0}, "substeps is 0"),
    "no threads": ({"threads": 0}, "threads is 0"),
    "another method": ({"integrator": "leapfrog"}, "no integrator 'leapfrog'"),
    "an unknown parameter": ({"parameters": {"mass": 1.0}}, "no 'mass'"),
    "a vector too short": ({"parameters": [1.0, 2.0]}, "parameters has the shape (2,)"),
    "a parameter of another batch": ({"x0": np.zeros((3, 18)), "parameters": {"gravity[2]": [1, 2]}}, "parameters 2"),
    "a negative mass for all": ({"parameters": {"forearm.rhoA": -1.0}}, "parameters: forearm.rhoA is -1; it must be"),
    "more than memory": ({"x0": np.zeros((1000, 18)), "steps": 10**6}, "would take 144 GB"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_makes_no_sense_is_refused_in_one_line(ella, name):
    given, said = REFUSED[name]
    arguments = {"x0": np.zeros(18), "step": STEP, "steps": 3} | ({"steps": None} if "tau" in given else {}) | given
    with pytest.raises(UsageError) as caught:
        rollout(ella, arguments.pop("x0"), arguments.pop("tau", None), **arguments)
    assert said in str(caught.value) and "\n" not in str(caught.value)


def test_without_a_compiler_one_line_says_so(monkeypatch):
    monkeypatch.setenv("CC", "no-such-cc")
    with pytest.raises(ScrewgenError, match="no C compiler 'no-such-cc'"):
        rollout(model_of(arm(link("rod"))), np.zeros(2), step=STEP, steps=1)


def test_a_model_is_compiled_once(ella):
    assert compiled_batch(ella, False) is compiled_batch(ella, False)
