"""Limits of efforts: steps hold what is within them, runs record it, the arm moves as under torques cut off there."""

import warnings

import numpy as np
import pytest
from helpers import arm, link, model_of, quick, quick_batch, relative
from oracle import Oracle
from scipy.integrate import solve_ivp

from screwgen import PD, LimitWarning, Robot, RobotFileError, ScrewgenError, UsageError, equilibrium, rollout, simulate
from screwgen.algorithms.robot_programs import held_inputs
from screwgen.integrators import METHODS
from screwgen.plotting.demands import bounds_of
from screwgen.spec.parameters import parameters

SOFT = {"modes": {"bending_y": 1}, "section": {"EIy": 60.0}}
MOST = np.array([2.0, 6.0, 0.3])
GEAR = {"ratio": 15.0, "rotor_inertia": 1e-3, "stiffness": 90.0, "damping": 0.4}


def robot(most=MOST):
    """A link of two axes that bends, and one behind an elastic gear, whose limit is that of the motor."""
    tables = [{} if np.isinf(x) else {"effort": float(x)} for x in most]
    first = link("upper", 0.6, ("z", "y"), joint={"limits": tables[:2]}, **SOFT)
    return arm(first, link("fore", 0.4, ("y",), joint={"limits": tables[2:], "drives": [GEAR]}))


MODEL, FREE = model_of(robot()), model_of(robot(np.full(3, np.inf)))
Q0 = np.array([0.1, -0.3, 0.2, 3.0, 0.01])


def law(t, q, v):
    """More than the drives can give, now and then."""
    asked = np.array([6.0 * np.cos(30 * t), -9.0, 1.5 * np.sin(40 * t)])
    return asked - np.array([4.0, 4.0, 0.02]) * v[[0, 1, 3]]


def beside(h, count):
    """Lagrange's equations under torques that are cut off and held over every step, to 1e-12."""
    oracle, n = Oracle(robot()), len(Q0)
    x = np.append(Q0, np.zeros(n))

    def rates(_, x, tau):
        return np.append(x[n:], oracle.forward_dynamics(x[:n], x[n:], tau, np.zeros((2, 6)))[0])

    for k in range(count):
        tau = np.clip(law(k * h, x[:n], x[n:]), -MOST, MOST)
        x = solve_ivp(rates, (0.0, h), x, "DOP853", rtol=1e-12, atol=1e-13, args=(tau,)).y[:, -1]
    return x


@pytest.fixture(scope="module")
def exact():
    return {count: beside(0.06 / count, count) for count in (24, 48)}


@pytest.mark.filterwarnings("ignore::screwgen.LimitWarning", "ignore::screwgen.ModelValidityWarning")
@pytest.mark.parametrize("form", ["joint", "dae"])
@pytest.mark.parametrize("method", ["semi_implicit", "modal_midpoint", "rk4"])
def test_runs_are_those_of_torques_that_are_cut_off(method, form, exact):
    """To the method's order: half the step, and the error falls by 2 to that power."""
    errors = []
    for count, want in exact.items():
        run = simulate(MODEL, 0.06, 0.06 / count, Q0, None, law, integrator=method, form=form)
        errors.append(np.abs(np.append(run.q[-1], run.v[-1]) - want).max())
        asked = np.array([law(t, q, v) for t, q, v in zip(run.t, run.q, run.v, strict=True)])
        assert np.array_equal(run.tau, np.clip(asked, -MOST, MOST)) and (run.tau != asked).any(axis=0).all()
    assert errors[0] / errors[1] > 0.75 * 2 ** METHODS[method].order, errors


def test_a_run_says_once_for_each_axis_when_and_how_often():
    with pytest.warns(LimitWarning) as said:
        run = simulate(MODEL, 0.05, 1e-3, Q0, None, law)
    asked = np.array([law(t, q, v) for t, q, v in zip(run.t, run.q, run.v, strict=True)])
    for name, given, held in zip(MODEL.tau_names, asked.T, run.tau.T, strict=True):
        (text,) = (str(x.message) for x in said if name in str(x.message))
        other = given != held
        assert f"in {100 * other.mean():.3g} % of the samples, first at t = {run.t[other][0]:.6g} s" in text
    assert np.array_equal(bounds_of(run, MODEL, law), MOST)  # which figures draw
    with warnings.catch_warnings():
        warnings.simplefilter("error", LimitWarning)
        simulate(MODEL, 0.01, 1e-3, Q0, None, MOST)  # at the limits, not beyond


def test_a_law_in_the_c_of_a_run_is_cut_off_too():
    """The PD law of a run stays in the C, which records and counts by itself."""
    pd = PD([50.0, 90.0, 40.0], [3.0, 3.0, 1.0], [0.9, 0.4, -0.5])
    runs = []
    for backend in ("c", "casadi"):
        with pytest.warns(LimitWarning, match="held at the limit of its effort") as said:
            run = simulate(MODEL, 0.05, 1e-3, Q0, None, pd, backend=backend)
        runs.append((run.tau, run.q, [str(x.message) for x in said if x.category is LimitWarning]))
    assert relative(runs[0][0], runs[1][0]) < 1e-9 and relative(runs[0][1], runs[1][1]) < 1e-12
    assert runs[0][2] == runs[1][2] and (np.abs(runs[0][0]).max(axis=0) == MOST)[:2].all()


def test_a_number_that_is_none_is_no_limited_input():
    """Of two scenarios within the limits one has a NaN: that fails, and nothing is said of limits."""
    tau = np.full((2, 8, 3), 0.1)
    tau[1, 4, 0] = np.nan
    quick_batch(MODEL)
    with warnings.catch_warnings():
        warnings.simplefilter("error", LimitWarning)
        run = rollout(MODEL, np.tile(np.append(Q0, np.zeros(5)), (2, 1)), tau, step=1e-3, steps=8)
    assert run.ok.tolist() == [True, False]


def test_a_posture_that_a_drive_cannot_hold_says_so():
    """7.848 N·m at the shoulder, of which the drive has 6: the equilibrium names both, and the remedy."""
    boom = link("boom", 1.0, ("y",), joint={"limits": [{"effort": 6.0}]}, section={"rhoA": 2.0})
    heavy = model_of(arm(boom, gravity=[0.0, 0.0, -7.848]))
    said = r"boom.torque\[0\] is -?7.848 in this posture, and -?6 as a step holds it; state a stronger drive"
    with pytest.warns(LimitWarning, match=said):
        equilibrium(heavy, [0.0], hold=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error", LimitWarning)
        equilibrium(heavy, [0.8], hold=True)


def test_inputs_far_beyond_are_held_at_the_limit_exactly():
    c, far = quick(MODEL), np.array([1e20, -1e300, 7.0])
    v, w_ext = np.zeros(5), np.zeros((2, 6))
    assert MODEL.numpy().held_inputs(Q0, v, far).tolist() == [2.0, -6.0, 0.3]
    for a, b in zip(c.step(Q0, v, far, w_ext, 1e-3), c.step(Q0, v, MOST * np.sign(far), w_ext, 1e-3), strict=True):
        assert np.array_equal(a, b)
    for bad in (np.nan, np.inf):
        with pytest.raises(ScrewgenError):
            c.step(Q0, v, np.array([bad, 0.0, 0.0]), w_ext, 1e-3)


def test_the_slope_is_one_up_to_the_limit_and_zero_beyond():
    c = quick(MODEL, derivatives=True)
    given = Q0, np.full(5, 0.2)
    at = lambda tau: c.step_derivatives(*given, tau, np.zeros((2, 6)), 1e-3)[-1]  # noqa: E731
    assert relative(at(MOST), at(MOST * (1 - 1e-12))) < 1e-9 and np.abs(at(-MOST)).max(axis=0).all()
    assert not at(MOST * (1 + 1e-9)).any()
    free = quick(FREE, derivatives=True).step_derivatives(*given, MOST, np.zeros((2, 6)), 1e-3)[-1]
    assert relative(at(MOST), free) < 1e-13


def test_they_are_parameters():
    names = [name for name in MODEL.parameter_names if name.endswith("effort")]
    assert names == [f"upper.joint.limits[{k}].effort" for k in range(2)] + ["fore.joint.limits[0].effort"]
    c, v, tau, w_ext = quick(MODEL), np.zeros(5), np.array([9.0, -9.0, 9.0]), np.zeros((2, 6))
    c.prepare({names[0]: 5.0})
    want = quick(FREE).step(Q0, v, np.array([5.0, -6.0, 0.3]), w_ext, 1e-3)
    assert relative(np.concatenate(c.step(Q0, v, tau, w_ext, 1e-3)), np.concatenate(want)) < 1e-13
    for bad in (0.0, -1.0):
        with pytest.raises(ScrewgenError):
            c.prepare({names[0]: bad})


def test_what_is_no_step_takes_what_it_is_given():
    v, tau, w_ext = np.zeros(5), np.array([9.0, -9.0, 9.0]), np.zeros((2, 6))
    for one, other in ((MODEL.numpy(), FREE.numpy()), (quick(MODEL), quick(FREE))):
        found, want = (x.forward_dynamics(Q0, v, tau, w_ext)[0] for x in (one, other))
        assert relative(found, want) < 1e-14
    assert relative(equilibrium(MODEL, Q0[:3]).tau, equilibrium(FREE, Q0[:3]).tau) < 1e-12


def test_an_axis_costs_ten_operations_and_one_without_none():
    assert held_inputs(MODEL.chain, "constants").operation_count == 3 * 11
    one = model_of(robot(np.array([2.0, np.inf, np.inf])))
    assert held_inputs(one.chain, "constants").operation_count == 11
    assert not FREE.chain.holds and "held" not in FREE.casadi()


@pytest.mark.parametrize(
    ("joint", "unit"),
    [
        ({"axes": ["z"]}, "N·m"),
        ({"axes": [{"slide": "x"}]}, "N"),
        ({"axes": [{"slide": "x"}], "drives": [GEAR]}, "N·m"),
        ({"axes": ["y"], "drives": {"transmission": {"base": 0.5, "crank": 0.2, "angle": 1.1}}}, "N"),
    ],
)
def test_the_unit_is_that_of_the_input(joint, unit):
    robot = Robot(**arm(link(joint=joint | {"limits": {"effort": 3.0}})))
    (own,) = (x for x in parameters(robot) if x.name.endswith("effort"))
    assert own.unit == unit


def test_what_is_no_limit_is_refused():
    stated = lambda table: Robot(**arm(link(joint={"limits": table})))  # noqa: E731
    for bad in (0.0, -5.0, float("nan"), 1e16, "strong"):
        with pytest.raises(RobotFileError, match=r"joint\.limits\[0\]\.effort .link arm.: is .*; it must be"):
            stated({"effort": bad})


MPC = """
[horizon]
intervals = 4
step = 0.02
[goal]
joints = [0.1, 0.2]
[cost]
torques = 1e-3
joints = 1.0
[bounds]
"""


def test_predictive_control_is_bounded_by_them(tmp_path):
    """Unless its file states tighter bounds; where all axes have limits the file need state none."""
    from screwgen.studies.predictive import fitted

    def bounds(text, most=(5.0, 7.0)):
        (tmp_path / "mpc.toml").write_text(MPC + text)
        joint = {"limits": [{} if x is None else {"effort": x} for x in most]}
        found = fitted(model_of(arm(link(axes="zy", joint=joint))), tmp_path / "mpc.toml").bounds
        return found["torque_lower"], found["torque_upper"]

    assert bounds("") == ([-5.0, -7.0], [5.0, 7.0])
    assert bounds("torques = [6.0, 3.0]") == ([-5.0, -3.0], [5.0, 3.0])
    assert bounds("torques = { lower = [-1.0, -9.0], upper = 8.0 }", (5.0, None)) == ([-1.0, -9.0], [5.0, 8.0])
    with pytest.raises(UsageError, match=r"bounds\.torques: is missing; .* arm\.torque\[1\] has none"):
        bounds("", (5.0, None))
    with pytest.raises(UsageError, match=r"bounds\.torques\[0\]: leaves nothing within the limit of the effort, 5"):
        bounds("torques = { lower = 6.0, upper = 8.0 }")
