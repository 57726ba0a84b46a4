"""The analysis of robots with loops: against robots written as trees, and linear models."""

import json

import numpy as np
import pytest
from helpers import arm, link, model_of
from test_linear_loops import BALL, GEAR, HINGE, linkage
from test_loops import angles

import screwgen
from screwgen import UsageError
from screwgen.backends.numpy.closing import moving
from screwgen.simulation.linearised import Linearised
from screwgen.simulation.linearised_loops import LinearisedWithLoops
from screwgen.simulation.stable_steps import LinearisedMotions
from screwgen.studies.analysis.analyse import first_state, sample_states
from screwgen.studies.analysis.spectrum import step_map

LENGTH, SPRING = 0.7, {"axes": ["y"], "stiffness": [900.0], "damping": [4.0], "armature": [0.5]}


def parallelogram(stabilisation: float):
    """Two equal bars on the ground, and a coupler as long as the ground that they keep level."""
    bars = [link("crank", LENGTH, "y", 2.0), link("coupler", 0.5, "y", 1.5), link("rocker", LENGTH, "y", 2.0)]
    bars[0]["joint"] = SPRING
    bars[2] |= {"parent": "world", "joint": {"axes": ["y"], "mount": {"xyz": [0.5, 0.0, 0.0]}}}
    return model_of(arm(*bars) | {"loops": [HINGE | {"stabilisation": stabilisation}]})


def one_bar():
    """The same motion as one bar: both bars in one, and the coupler, which never turns, as a mass at its tip."""
    bar = link("bar", LENGTH, "y", 4.0, bodies=[{"at": "tip", "mass": 0.75}])
    bar["joint"] = SPRING
    return model_of(arm(bar))


@pytest.fixture(scope="module")
def pair():
    """One that moves under a load."""
    q, rate, tau = 0.4, 0.3, 30.0
    shut = {"q": [q, -q, q], "v": [rate, -rate, rate], "tau": [tau, 0.0, 0.0]}
    return (
        screwgen.analyse(parallelogram(20.0), [shut]),
        screwgen.analyse(one_bar(), [{"q": [q], "v": [rate], "tau": [tau]}]),
    )


def test_a_parallelogram_has_the_motions_of_one_bar(pair):
    shut, tree = (a.states[0] for a in pair)
    assert [m.kind for m in shut.motions] == [m.kind for m in tree.motions] == ["oscillates"]
    assert shut.motions[0].eigenvalue == pytest.approx(tree.motions[0].eigenvalue, rel=1e-9)
    assert shut.motions[0].coordinate == "crank.joint[0]"
    assert shut.acceleration == pytest.approx(tree.acceleration, rel=1e-9)


def test_its_steps_grow_alike_and_are_bounded_by_the_stabilisation_besides(pair):
    """That is explicit: `4 − 4 h c − h² c² = 0` of a semi-implicit step."""
    shut, tree = ({x.method: x for x in a.states[0].limits} for a in pair)
    for method in shut:
        assert shut[method].rate == pytest.approx(tree[method].rate, rel=1e-7)
    for method in ("euler", "rk4"):
        assert shut[method].limit == pytest.approx(tree[method].limit, rel=1e-4)
    for method in ("semi_implicit", "modal_implicit", "modal_midpoint"):
        assert shut[method].limit == pytest.approx((np.sqrt(8) - 2) / 20.0, rel=1e-4)
        assert tree[method].limit is None or tree[method].limit > 0.07


@pytest.fixture(scope="module")
def bent():
    """A linkage in space whose coupler bends, with an elastic gear, dampers and modes that are damped."""
    bending = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.5, "EIy": 300.0, "EIz": 300.0}}
    return linkage(BALL, {"joint": {"drives": [GEAR]}}, bending | {"damping": {"ratio": 0.02}})


@pytest.fixture(scope="module")
def running(bent):
    q = screwgen.equilibrium(bent, angles(0.4), hold=True).q
    v = moving(bent.numpy(), q, np.r_[-3.0, np.zeros(bent.nv - 1)])
    return q, v, np.array([5.0, 0.0, 0.0])


def test_the_spectrum_of_a_moving_linkage_is_that_of_its_linear_model(bent, running):
    """CasADi's derivatives of another program."""
    motion, expected = LinearisedWithLoops(bent, *running), bent.linearise(*running)
    assert np.allclose(motion.jacobian, expected.A, rtol=1e-9, atol=1e-9 * np.abs(expected.A).max())
    assert tuple(motion.names) == expected.state_names[: len(motion.names)]


@pytest.mark.parametrize("method", ["modal_midpoint", "rk4"])
def test_a_step_map_is_the_derivative_of_the_step_at_rest(bent, method):
    """Of NumPy's stepper, with heavier modes and the rows' forces: at rest it is exact."""
    from screwgen.simulation.integrate import JointStepper

    rest = screwgen.equilibrium(bent, angles(0.4), hold=True)
    found = step_map(bent, method, rest.q, np.zeros(bent.nv), 1e-3, rest.tau)
    stepper, x, w_ext = (
        JointStepper(bent, method, bent.parameter_values),
        np.r_[rest.q, np.zeros(bent.nv)],
        np.zeros((3, 6)),
    )
    step = lambda x: np.concatenate(stepper.step(stepper.initial(*np.split(x, 2)), rest.tau, w_ext, 1e-3))  # noqa: E731
    expected = np.array([(step(x + 1e-5 * e) - step(x - 1e-5 * e)) / 2e-5 for e in np.eye(len(x))]).T
    assert np.abs(found - expected).max() < 1e-6 * np.abs(expected).max()
    shut = LinearisedWithLoops(bent, rest.q, np.zeros(bent.nv), rest.tau)
    own = np.linalg.eigvals(shut.step_map(method, 1e-3))
    both = np.append(own, shut.closing_factors(method, 1e-3))
    assert np.allclose(np.poly(both), np.poly(found), rtol=0, atol=1e-7 * np.abs(np.poly(both)).max())


def test_held_by_constant_forces_the_modes_are_heavier_within_the_loops(bent):
    """At rest, where the two ways to the slopes over a step must agree: by `M_h` and the rows, and differentiated."""
    rest = screwgen.equilibrium(bent, angles(0.4), hold=True)
    motion = Linearised(bent, rest.q, np.zeros(bent.nv), rest.tau)
    free, held = motion.slopes(2e-3), motion.trimmed().slopes(2e-3)
    for one, other in zip(free, held, strict=True):
        assert np.allclose(one, other, rtol=1e-7, atol=1e-7 * np.abs(one).max())
    looped = LinearisedWithLoops(bent, rest.q, np.zeros(bent.nv), rest.tau)
    assert LinearisedMotions(looped.trimmed()).bears("modal_midpoint", 1e-3)


def test_the_report_says_what_loops_leave(bent, running):
    q, v, tau = running
    a = screwgen.analyse(bent, {"moving": {"q": q, "v": v, "tau": tau}})
    state = a.states[0]
    assert a.well_posed and state.loops.regular and state.loops.size == len(bent.chain.closing.rows) == bent.nv - 3
    text = " ".join(a.text().split())
    assert f"Loops: their {state.loops.size} rows are independent in all;" in text
    assert f"3 coordinates of {bent.nv} move independently: the spectrum is theirs." in text
    assert json.loads(a.to_json())["states"][0]["loops"]["rank"] == state.loops.size
    with pytest.raises(UsageError, match=r"^q: loop\[0\] is open by .*; start from what `screwgen assemble`"):
        screwgen.analyse(bent, [{"q": q + 0.01}])


def test_samples_are_closed_and_stay_so():
    model = linkage()
    a = screwgen.analyse(model, first_state(model) | sample_states(model, 2))
    assert [s.label for s in a.states] == ["closed", "sample 1", "sample 2"]
    assert all(s.well_posed and s.loops.rank == 2 and s.motions for s in a.states)


def test_a_linkage_in_line_is_singular(bent):
    a = screwgen.analyse(bent, [{}])
    assert not a.well_posed and "singular" in a.states[0].singular and not a.states[0].loops.regular
    assert "depend on each other in 1 of 1 state" in a.text()
