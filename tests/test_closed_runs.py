"""Loops over runs: open starts, loops that open on the way, steps that get the energy wrong, and parameters."""

import warnings

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of, quick, quick_batch
from mechanisms import bennett, sarrus, slider_crank

from screwgen import LoopWarning, OpenedError, ScrewgenError, SingularError, UsageError, assemble, rollout, simulate
from screwgen.backends.numpy.closing import moving
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation import rollout_loops
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.hits import LimitWarning
from screwgen.simulation.loop_watch import LoopWatch


def moving_off(model, fast: float) -> np.ndarray:
    """Rates that keep the loops closed at q = 0, the largest of them `fast`."""
    v = moving(model.numpy(), np.zeros(model.nq), np.arange(1, model.nv + 1) ** 1.5)
    return v * fast / np.max(np.abs(v))


def four_bar() -> dict:
    """A linkage in the x-z plane; three rows of its hinge are no motion's."""
    bars = [link("crank", 0.3, "y", 2.0), link("coupler", 0.9, "y", 1.5)]
    rocker = link("rocker", 0.6, "y", 1.8, parent="world")
    rocker["joint"]["mount"] = {"xyz": [0.8, 0.0, 0.0]}
    hinge = {"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}
    return arm(*bars, rocker) | {"loops": [hinge]}


# ------------------------------------------------------------------------------ half a turn


@pytest.mark.parametrize("kind", ["guide", "weld"])
def test_frames_half_a_turn_apart_are_open(kind):
    """The piston of a slider-crank, turned over: all rows of its loop vanish."""
    model = model_of(slider_crank(kind))
    q = np.zeros(model.nq)
    q[-1] = np.pi
    assert np.max(np.abs(model.numpy().gaps(q, None)[0])) < 1e-12
    assert np.allclose(model.numpy().mismatch(q), [[0.0, 2.0]], atol=1e-12)
    for options in ({}, {"backend": "numpy"}, {"form": "dae"}):
        with pytest.raises(UsageError, match=r"^q0: loop\[0\] is open by 2 rad; start from"):
            simulate(model, 0.01, 1e-3, q0=q, **options)
    found = assemble(model, q + 0.02, hold=["crank.joint[0]"])
    assert np.max(model.numpy().mismatch(found)) < 1e-10


def test_hinges_with_antiparallel_axes_are_open():
    """A hinge turned over about an axis at right angles to its own: cosines to both normals vanish."""
    rod = link("rod", 0.4, ["y", "x"], 1.0)
    far = {"name": "bearing", "parent": "world", "bodies": [{"at": "base", "mass": 0.0}]}
    far["joint"] = {"axes": [], "mount": {"xyz": [0.4, 0.0, 0.0]}}
    hinge = {"between": ["rod.tip", "bearing.tip"], "joint": {"axes": ["y"]}}
    model = model_of(arm(rod, far) | {"loops": [hinge]})
    assert np.allclose(model.numpy().mismatch([0.0, np.pi]), [[0.0, 2.0]], atol=1e-12)
    assert not model.numpy().mismatch([0.0, 0.0]).any()


# ------------------------------------------------------------------------------ on the way


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_a_step_through_a_fold_that_gets_the_energy_wrong_is_said(backend):
    """Equal arms: at a right angle of the crank the rod covers it, and rows of the loop depend on each other."""
    model = model_of(slider_crank("weld", 0.5, 0.5))
    start = dict(q0=np.zeros(model.nq), v0=moving_off(model, 6.0), backend=backend)
    with pytest.warns(LoopWarning, match=r"at t = \S+ s a step gets the energy wrong by \d\d % of the largest"):
        run = simulate(model, 0.72 if backend == "numpy" else 1.2, 1e-3, **start)
    assert np.ptp(run.energy.sum(axis=1)) > 0.05 * run.energy[:, 0].max()
    with warnings.catch_warnings():
        warnings.simplefilter("error", LoopWarning)
        run = simulate(model, 0.72, 1e-3, integrator="rk4", **start)
    assert np.ptp(run.energy.sum(axis=1)) < 1e-4 * run.energy[:, 0].max()


def test_a_run_ends_where_a_loop_opens():
    """Sarrus' linkage, whose arms fold flat, at a step that is too long for it; in C and NumPy alike."""
    model = model_of(sarrus())
    said = []
    for backend in ("c", "numpy"):
        with pytest.raises(OpenedError, match=r"^t = \S+ s: loop\[0\] has opened by 0\.\d+ m; take a smaller") as info:
            simulate(model, 1.0, 1e-3, q0=np.zeros(5), v0=moving_off(model, 3.0), backend=backend)
        said.append(str(info.value))
    assert said[0] == said[1]


def test_an_overconstrained_linkage_stays_on_its_mechanism():
    """Bennett's, with the method and step that once left it: opposite angles stay opposite, energy stays."""
    model = model_of(bennett())
    run = simulate(model, 2.0, 1e-3, q0=np.zeros(3), v0=moving_off(model, 3.0), integrator="modal_midpoint")
    assert np.max(np.abs(run.q[:, 0] + run.q[:, 2])) < 1e-5
    assert np.ptp(run.energy.sum(axis=1)) < 1e-4 * run.energy[:, 0].max()
    assert max(np.max(model.numpy().mismatch(q)) for q in run.q[::100]) < 1e-5


def test_the_energy_of_a_step_is_judged_by_the_efforts_that_it_holds(monkeypatch):
    """An effort far beyond its limit works no more than that: no step is run a second time, in C as in NumPy."""
    robot = four_bar()
    robot["links"][0]["joint"]["limits"] = [{"effort": 2.0}]
    model, seen = model_of(robot), []
    monkeypatch.setattr(LoopWatch, "warn", lambda watch: seen.append(watch.seen.sum))
    q = assemble(model, [-0.4, 0.0, -1.0], hold=["crank.joint[0]"])
    for backend in ("c", "numpy"):
        with pytest.warns(LimitWarning, match="held at the limit of its effort"):
            simulate(model, 0.05, 1e-3, q0=q, controller=[80.0, 0.0, 0.0], backend=backend)
    assert seen == [0.0, 0.0]


# ------------------------------------------------------------------------------ parameters


@pytest.fixture(scope="module")
def planar():
    return model_of(four_bar())


def test_parameters_that_open_a_loop_are_refused(planar):
    """In the direction that no joint moves: by NumPy at the start, by the C when constants are prepared."""
    q = assemble(planar, [-0.4, 0.0, -1.0], hold=["crank.joint[0]"])
    off = {"rocker.joint.mount.xyz[1]": 0.1}
    with pytest.raises(UsageError, match=r"^q0: loop\[0\] is open by 0\.1 m"):
        simulate(planar, 0.01, 1e-3, q0=q, parameters=off, form="dae")
    with pytest.raises(UsageError, match=r"^parameters: no robot has these; .* no loop may be opened by them$"):
        simulate(planar, 0.01, 1e-3, q0=q, parameters=off)
    compiled = quick(planar)
    p = planar.chain.parameters.vector(off)
    with pytest.raises(ScrewgenError, match="bad argument"):
        compiled.fresh(p)
    compiled.fresh(planar.chain.parameters.vector({"rocker.joint.mount.xyz[0]": 0.81}))


def test_the_c_says_how_far_loops_are_from_closed(planar):
    """Beside NumPy: a closed posture, an open one, and a piston turned over."""
    turned = model_of(slider_crank("guide"))
    for model, q in ((planar, [0.4, -0.3, 0.2]), (turned, [0.0, 0.0, np.pi]), (turned, np.zeros(3))):
        assert np.allclose(quick(model).loop_mismatch(q), model.numpy().mismatch(q), rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("size", [1e155, 1e200])
def test_a_mismatch_that_is_no_number_is_refused_in_c(size):
    """Places whose squares are infinite: nothing that compares the mismatch with a bound would see it."""
    slider = link("slider", 0.1, [{"slide": "x"}], parent="world")
    hinge = {"between": ["rod.tip", "slider.tip"], "joint": {"axes": ["y"]}}
    library = quick(model_of(arm(link("crank", 0.3, "y"), link("rod", 0.7, "y"), slider, loops=[hinge])))
    assert np.all(library.loop_mismatch([0.0, 0.0, 1.0]) < 1.0)
    with pytest.raises(ScrewgenError, match="finite"):
        library.loop_mismatch([0.0, 0.0, size])


PULLED = {
    "section": {"EIy": 50.0, "EIz": 50.0},
    "modes": {"bending_z": 1},
    "tendons": [{"name": "cord", "at": [[0.0, 0.0, 0.01]] * 2}],
}
LEVER = {"drives": [{"transmission": {"crank": 0.1, "base": 0.3, "angle": 1.2}}]}


@pytest.mark.parametrize(("backend", "form"), [("c", "joint"), ("casadi", "joint"), ("casadi", "dae")])
def test_the_work_of_cylinders_and_tensions_is_that_of_their_travels(backend, form, monkeypatch):
    """So no step is made again: none changes the energy by a ten-thousandth more than they give."""
    links = [link("crank", 0.3, "y", 2.0, joint=LEVER), link("coupler", 0.7, "y", 1.5, **PULLED)]
    links += [link("rocker", 0.6, "y", 2.0, parent="world", joint={"mount": {"xyz": [0.8, 0.0, 0.0]}})]
    loops = [{"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}]
    model, watches = model_of(arm(*links, gravity=(0.0, 0.0, 0.0)) | {"loops": loops}), []
    init = LoopWatch.__init__
    monkeypatch.setattr(LoopWatch, "__init__", lambda self, *given: (watches.append(self), init(self, *given))[1])
    tau, q = np.array([40.0, 0.0, 0.0, 20.0]), assemble(model, [-1.0, 1.2, -1.5])
    run = simulate(model, 0.02, 2e-4, q, None, tau, None, "rk4", form, backend=backend)
    given = np.trapezoid(run.drive_power.sum(axis=1), run.t)
    assert np.ptp(run.energy.sum(axis=1)) == pytest.approx(abs(given), rel=1e-3)
    assert [watch.seen.sum for watch in watches] == [0.0]


# ------------------------------------------------------------------------------ rollouts


def test_scenarios_with_open_loops_stop_alone(planar):
    """An open start, a parameter that opens the loop in a direction of its joints, and the piston turned over."""
    q = assemble(planar, [-0.4, 0.0, -1.0], hold=["crank.joint[0]"])
    states = np.hstack([np.array([q, q + np.array([0.0, 1e-3, 0.0]), q]), np.zeros((3, 3))])
    quick_batch(planar)
    run = rollout(planar, states, step=1e-3, steps=5, parameters={"rocker.joint.mount.xyz[0]": [0.8, 0.8, 0.81]})
    assert run.status.tolist() == [0, 4, 4] and run.completed.tolist() == [5, 0, 0]
    assert np.array_equal(run.q[1:], np.repeat(states[1:, None, :3], 6, axis=1)) and np.ptp(run.q[0]) > 0
    assert "scenario 1 stopped at t = 0 s: a loop is open" in run.report()[0]
    turned = model_of(slider_crank("guide"))
    quick_batch(turned)
    states = np.zeros((2, 6))
    states[1, 2] = np.pi
    assert rollout(turned, states, step=1e-3, steps=3).status.tolist() == [0, 4]


def test_scenarios_that_open_their_loop_keep_their_last_closed_state():
    """Sarrus' linkage without weight, whose arms fold flat; the last scenario rests.

    Where the arms lie in a plane rounding decides whether a step opens the loop: of several rates some do.
    """
    model = model_of(sarrus() | {"gravity": [0.0, 0.0, 0.0]})
    quick_batch(model)
    states = np.zeros((8, 2 * model.nq))
    states[:-1, model.nq :] = [moving_off(model, -rate) for rate in range(24, 31)]
    run = rollout(model, states, step=1e-3, steps=600)
    stopped = run.status == 4
    assert stopped.any() and not run.status[~stopped].any() and not stopped[-1]
    assert np.all((run.completed < 600) == stopped)
    for q, k in zip(run.q, run.completed, strict=True):
        assert np.array_equal(q[k], q[-1])
        assert max(np.max(model.numpy().mismatch(at)) for at in q[max(0, k - 3) : k + 1]) < 0.01


def test_few_samples_of_closed_scenarios_are_looked_at_and_the_first_open_one_is_found(planar, monkeypatch):
    """Of a thousand samples; one scenario opens between those that are looked at."""
    looked = []
    open_ = rollout_loops._open
    monkeypatch.setattr(rollout_loops, "_open", lambda *given: looked.append(given[2].shape[:2]) or open_(*given))
    q = np.tile(assemble(planar, [-0.4, 0.0, -1.0], hold=["crank.joint[0]"]), (3, 1000, 1))
    q[1, 700:, 1] += 0.1
    assert rollout_loops.opened(planar, np.array([planar.parameter_values]), q).tolist() == [1000, 700, 1000]
    assert looked[1:] == [(1, 1000)] and looked[0][1] < 20


# ------------------------------------------------------------------------------ filters


def test_filters_refuse_a_start_half_a_turn_away():
    """All rows vanish there, so that the correction that closes them finds nothing to do."""
    model, noise = model_of(slider_crank("guide")), Noise(1.0)
    turned = np.array([0.0, 0.0, np.pi])
    compiled = CompiledEstimator(model, flags=QUICK)
    for filter_ in (Estimator(model), compiled):
        filter_.start(np.zeros(3), np.zeros(3), 0.1, 0.1, noise)
        with pytest.raises(SingularError, match="loops do not close"):
            filter_.start(turned, np.zeros(3), 0.1, 0.1, noise)
