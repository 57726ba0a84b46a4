"""Identification of robots with loops: windows begin with closed loops, and numbers are found again."""

import numpy as np
import pytest
from helpers import arm, model_of

import screwgen
from screwgen.errors import UsageError
from screwgen.identification.beside import cases_of, how_of
from screwgen.identification.logs import Log
from screwgen.identification.problem import Problem
from screwgen.identification.unknowns import unknowns_of_logs
from screwgen.spec.columns import Column, Columns

TRUE = {
    "coupler.EIy": 150.0,
    "coupler.bodies[0].mass": 0.8,
    "crank.joint.damping[0]": 0.4,
    "rocker.bodies[0].mass": 0.5,
}
OFF = (1.3, 0.7, 1.3, 0.7)
COLUMNS = Columns(
    columns=(
        Column(name="motor", drives="crank.torque[0]"),
        Column(name="angle", measures="crank.joint[0]", unit="deg"),
        Column(name="gauge", measures="strain[0]", unit="microstrain", numbers={"fibre": (0.01,)}),
    )
)
START = [-0.4, 0.0, 0.0]


def four_bar(values=TRUE, rocker_length=0.6) -> screwgen.Model:
    """Bars in the x-z plane on the ground, between a crank and a rocker a flexible coupler with a mass on its tip."""
    EI, load, damping, mass = values.values()
    bar = {"order": 1, "joint": {"axes": ["y"]}}
    crank = bar | {"name": "crank", "length": 0.3, "section": {"rhoA": 2.0}}
    crank["joint"] = {"axes": ["y"], "damping": [damping], "armature": [0.02]}
    section, modes = {"rhoA": 0.6, "EIy": EI}, {"bending_z": 2}
    coupler = bar | {"name": "coupler", "length": 0.9, "section": section, "modes": modes, "damping": {"ratio": 0.02}}
    coupler["bodies"] = [{"at": "tip", "mass": load, "com": [-0.4, 0.0, 0.0]}]
    rocker = bar | {"name": "rocker", "length": rocker_length, "section": {"rhoA": 1.2}, "parent": "world"}
    rocker["joint"] = {"axes": ["y"], "mount": {"xyz": [0.8, 0.0, 0.0]}}
    rocker["bodies"] = [{"at": "tip", "mass": mass}]
    hinge = {"between": ["coupler.tip", "rocker.tip"], "joint": {"axes": ["y"]}}
    return model_of(arm(crank, coupler, rocker, gravity=[0.0, 0.0, -9.81]) | {"loops": [hinge]})


def elsewhere() -> screwgen.Model:
    return four_bar({name: x * off for (name, x), off in zip(TRUE.items(), OFF, strict=True)})


def torque(t, q, v):
    return np.array([4 * np.sin(3 * t) + 3 * np.sin(29 * t + 1) - 2.2 + 12 * (-0.4 - q[0]), 0.0, 0.0])


class Held:
    """A controller whose torques are held over samples of the log, however fine the steps are."""

    def __init__(self, law, step):
        self.law, self.step, self.sample, self.tau = law, step, -1, None

    def __call__(self, t, q, v):
        if (sample := int(t / self.step + 1e-6)) != self.sample:
            self.sample, self.tau = sample, self.law(t, q, v)
        return self.tau


def logged(model, law, seconds, step, finer, q0, measured, columns, parameters=None):
    """A log of a run by Runge and Kutta at steps that are finer, with 1 % of noise on every sensor."""
    q0 = screwgen.equilibrium(model, q=q0, hold=True, parameters=parameters).q
    controller = Held(law, step)
    given = {"q0": q0, "controller": controller, "parameters": parameters, "integrator": "rk4", "backend": "c"}
    run, rng = screwgen.simulate(model, seconds, step / finer, **given), np.random.default_rng(1)
    made = {name: values[::finer] for name, values in measured(run).items()}
    noisy = {name: x + 0.01 * x.std() * rng.standard_normal(len(x)) for name, x in made.items()}
    inputs = {c.name: run.tau[::finer, model.tau_names.index(str(c.drives))] for c in columns.inputs}
    return Log("loops.csv", run.t[::finer], noisy | inputs)


@pytest.fixture(scope="module")
def log() -> Log:
    measured = lambda run: {"angle": np.degrees(run.q[:, 0]), "gauge": -0.01e6 * run.strain[:, 0]}  # noqa: E731
    return logged(four_bar(), torque, 1.5, 1e-3, 5, START, measured, COLUMNS)


def windows(model, log, free):
    asked = unknowns_of_logs(model, COLUMNS, free, [log], None)
    cases = cases_of(model, log, COLUMNS, 0.5, model.chain.parameters.values)
    return cases, Problem(model, [cases], asked, how_of("modal_midpoint", 2, 1))


def test_numbers_of_a_four_bar_linkage_are_found_again(log):
    """From 30 % off: each within 1 %, damping within 5 %; of three joints one is measured."""
    found = screwgen.identify(elsewhere(), log, free=list(TRUE), sensors=COLUMNS, window=0.5, substeps=2)
    for name, true in TRUE.items():
        one = found[name]
        assert one.value == pytest.approx(true, rel=0.05 if "damping" in name else 0.01), name
        assert abs(one.value - true) < one.high - one.low < 0.2 * true, name
    assert min(found.explained[0].share("whole").values()) > 0.99
    assert max(abs(x) for x in found.whiteness.values()) < 0.1 and not found.undetermined


def test_accelerometers_tell_numbers_of_a_linkage():
    """At the tip of the flexible coupler, beside the crank's encoder, in windows of a few vibrations."""
    model = four_bar()
    place = [marker.name for marker in model.chain.markers].index("coupler.tip")
    sensors = [Column(name=f"tip_{k}", measures=f"accelerometer@coupler.tip[{k}]", unit="g") for k in (0, 2)]
    columns = Columns(columns=(*COLUMNS.columns[:2], *sensors))

    def measured(run):
        found = run.accelerometer[:, place] / 9.80665
        return {"angle": np.degrees(run.q[:, 0]), "tip_0": found[:, 0], "tip_2": found[:, 2]}

    log = logged(model, torque, 0.5, 1e-3, 5, START, measured, columns)
    found = screwgen.identify(elsewhere(), log, free=list(TRUE), sensors=columns, window=0.1, substeps=2)
    for name, true in TRUE.items():
        assert found[name].value == pytest.approx(true, rel=0.02), name
        assert found[name].low < true < found[name].high, name


def test_windows_begin_with_closed_loops_whatever_is_free(log):
    """Lengths are free too: each lane closes its loop with its own. Gaps in closed form, their rates by differences."""
    model = elsewhere()
    cases, _ = windows(model, log, [*TRUE, "coupler.length", "rocker.length"])
    rng = np.random.default_rng(2)
    window = np.array([0, 1, 2, 1])
    p = np.tile(model.chain.parameters.values, (4, 1))
    lengths = [model.parameter_names.index(f"{name}.length") for name in ("crank", "coupler", "rocker")]
    p[:, lengths[1:]] *= 1 + 0.01 * rng.standard_normal((4, 2))
    x0 = cases.x0(window, rng.standard_normal((4, len(cases.states))), p)
    assert len(cases.states) == 2 * (1 + 2)

    def gap(q, p):
        numeric = model.numpy(p)
        poses = dict(zip(("crank", "coupler", "rocker"), numeric.tip_poses(q)[1], strict=True))
        return (poses["coupler"] - poses["rocker"])[[0, 2]]

    for x, own in zip(x0, p, strict=True):
        q, v, h = x[: model.nq], x[model.nq :], 1e-6
        assert np.abs(gap(q, own)).max() < 1e-10
        assert np.abs(gap(q + h * v, own) - gap(q - h * v, own)).max() / (2 * h) < 1e-8


def test_slopes_of_windows_with_loops_are_those_of_differences(log):
    """Central ones, of steps a thousand times as long, of numbers of the robot, of a length, and of states."""
    model = elsewhere()
    cases, problem = windows(model, log, [*TRUE, "rocker.length"])
    k, n = len(problem.unknowns), len(cases.states)
    sought, shift = np.zeros(k), np.zeros((len(cases.first), n))
    _, by_p, by_x = cases.linearised(problem, sought, shift)
    every = np.arange(len(cases.first))

    def change(of_p, of_x):
        both = [
            cases.differences(problem, every, np.tile(s * of_p, (len(every), 1)), shift + s * of_x) for s in (1, -1)
        ]
        return both[0] - both[1]

    size = np.abs(by_p).max(axis=(0, 1))
    for j in range(k):
        found = change(1e-4 * np.eye(k)[j], np.zeros(n)) / 2e-4
        assert (np.abs(found - by_p[..., j]).max(axis=(0, 1)) < 1e-3 * size[:, j]).all()
    for j in range(n):
        found = change(np.zeros(k), 1e-3 * np.eye(n)[j]) / 2e-3
        assert np.abs(found - by_x[..., j]).max() < 5e-3 * np.abs(by_x[..., j]).max()


def test_loops_that_windows_cannot_begin_with_are_refused(log):
    """A crank angle to which a short rocker cannot reach is said with the log's name."""
    far = Log("far.csv", log.t, log.columns | {"angle": log.columns["angle"] + 90.0})
    with pytest.raises(UsageError) as caught:
        screwgen.identify(four_bar(rocker_length=0.1), far, free=list(TRUE), sensors=COLUMNS, window=0.5)
    assert "far.csv: where its readings begin" in str(caught.value) and "\n" not in str(caught.value)
