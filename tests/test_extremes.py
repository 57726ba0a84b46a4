"""Robots and states at the edge: exact zeros, tiny and huge angles, no modes, many modes, many links, heavy loads."""

import numpy as np
import pytest
import random_robots as rr
from conftest import swept
from helpers import EPS, Case, arm, casadi_forward, case_of, drawn, equal_links, flat, link, model_of, quick

MODES = {"basis": "clamped_free", "bending_y": 1, "bending_z": 1}
SLOPE = 2.7530
"""Tip slope of the first clamped-free mode over its length of 1 m."""

SOFT = {"EA": 5e3, "EIy": 30.0, "EIz": 50.0, "GJ": 20.0, "rhoIp": 2e-3}


def results(case: Case, layout="fused") -> dict[str, tuple]:
    """The robot's forward dynamics by every back end, both forms."""
    numeric, compiled = case.model.numpy(), quick(case.model, layout=layout)
    return {
        "NumPy": numeric.forward_dynamics(*case.inputs),
        "NumPy, DAE": numeric.dae_forward_dynamics(*case.inputs),
        "CasADi": casadi_forward(case.model, *case.inputs),
        "C": compiled.forward_dynamics(*case.inputs),
        "C, DAE": compiled.forward_dynamics(*case.inputs, form="dae"),
    }


def check(case: Case, layout="fused", state=None, tolerance=None) -> None:
    """All are right to the usual tolerance, or to `tolerance` where the state itself says so."""
    case = case if state is None else case._replace(state=state)
    tolerance = case.tolerance if tolerance is None else tolerance
    errors = {who: max(case.oracle.errors(case.state, *r).values()) for who, r in results(case, layout).items()}
    assert max(errors.values()) <= tolerance, (errors, tolerance)


# -------- states


@pytest.mark.parametrize("layout", swept(["fused", "modular"], "fused"))
def test_modal_state_exactly_zero(layout):
    """The undeformed arm in motion; then everything zero."""
    case = drawn(700, 2, states=rr.undeformed_state)
    for state in (case.state, rr.rest_state(case.robot)):
        check(case, layout, state)


def test_tiny_states():
    """Squares of the smallest angles underflow to zero; nothing divides by them."""
    case = drawn(710, 2)
    for size in (1e-3, 1e-9, 1e-20, 1e-160, 1e-300):
        check(case, state=rr.tiny_state(np.random.default_rng(710), case.robot, size))


def test_huge_joint_angles():
    """After a million radians an angle is known to eps * angle only: so is everything that follows from it.

    The derivative of the accelerations by the angles turns that into a tolerance.
    """
    case = drawn(720, 2)
    m, f, p = case.model.n_joints, case.model.casadi()["forward_dynamics"], case.model.parameter_values
    for angle in (1e3, 1e6):
        state = rr.huge_angle_state(np.random.default_rng(3), case.robot, angle)
        q, v, tau, w_ext = (np.array(x) for x in state.values())
        given = dict(zip(f.name_in(), (q, v, tau, w_ext.T, p), strict=True))
        vdot, J = flat(f(**given)["vdot"]), f.jacobian()(**given, out_vdot=0, out_wrench=0)
        growth = max(
            relative_slope(J[f"jac_{y}_q"].full()[:, :m], x)
            for y, x in (("vdot", vdot), ("wrench", flat(f(**given)["wrench"])))
        )
        check(case, state=state, tolerance=case.oracle.tolerance(q) + 4 * EPS * angle * growth)


def relative_slope(J: np.ndarray, value: np.ndarray) -> float:
    return float(np.abs(J).sum(axis=1).max() / np.abs(value).max())


def test_large_section_rotations():
    """Tip sections turned by up to three radians: beyond the model's worth, not beyond its formulas."""
    table = link(
        axes=["z"], modes=MODES | {"torsion": 1}, section=SOFT, bodies=[{"at": "tip", "mass": 1.0, "com": [0.1, 0, 0]}]
    )
    robot = arm(table, link("second", 0.5, "y"))
    state = rr.random_state(np.random.default_rng(1), robot)
    case = case_of(robot, state)
    for theta in (0.49, 0.51, 1.9, 2.1, 3.0):  # the series gets more terms at 1/2, the closed form starts at 2
        state["q"][1:4] = [-0.3 * theta / SLOPE, 0.4 * theta / SLOPE, 0.86 * theta / np.sqrt(2)]
        check(case, state=state)


# -------- robots


@pytest.mark.parametrize("seed", swept(range(2), 0))
def test_heavy_payloads(seed):
    check(drawn(730 + seed, 2, robots=rr.heavy_payload_robot))


def test_slender_links():
    check(drawn(740, 2, robots=rr.slender_robot), "modular")


def test_zero_gravity():
    check(drawn(750, 2, no_gravity=1.0))


def test_no_modes_at_all():
    check(drawn(751, 3, rigid=1.0))


def test_welded_chain():
    """No joint coordinate at all: a structure; its wrenches are those of a statically loaded, vibrating frame."""
    tables = [
        link(f"l{i}", 0.5, [], modes=MODES, section=SOFT, joint={"mount": {"rpy": [0, 0.7 * i, 0.4]}}) for i in range(3)
    ]
    robot = arm(*tables)
    check(case_of(robot, rr.random_state(np.random.default_rng(2), robot)), "modular")


def test_welded_and_rigid_has_nothing_to_solve():
    """No coordinates: only wrenches are left, and they are the weights."""
    robot = arm(link("a", 0.5, [], rhoA=2.0), link("b", 0.5, [], rhoA=4.0))
    case = case_of(robot, rr.rest_state(robot))
    for vdot, wrench in results(case).values():
        assert vdot.shape == (0,)
        assert np.allclose(wrench[:, 5], [3.0 * 9.81, 2.0 * 9.81], rtol=1e-14)


@pytest.mark.parametrize("basis", swept(["clamped_free", "polynomial"], "clamped_free"))
def test_different_counts_in_y_and_z(basis):
    """Then y and z share no functions (polynomial) or only some (clamped_free): full products of shapes."""
    counts = {"basis": basis, "axial": 2, "bending_y": 3, "bending_z": 1, "torsion": 1}
    robot = arm(link(axes=["y", "z"], modes=counts, section=SOFT), link("second", 0.7, "y", modes=counts, section=SOFT))
    check(case_of(robot, rr.random_state(np.random.default_rng(4), robot)))


@pytest.mark.parametrize(
    ("basis", "count"),
    [
        ("polynomial", 16),
        pytest.param("clamped_free", 16, marks=pytest.mark.long),
        pytest.param("polynomial", 32, marks=pytest.mark.long),
    ],
)
def test_many_modes(basis, count):
    """The O(r) elimination. The slopes of so many polynomials at the tip make cond M too large for its tolerance."""
    table = link(length=0.8, axes=["y", "z"], modes={"basis": basis, "bending_y": count}, section=SOFT)
    robot = arm(table, link("second", 0.5, "z"))
    state = rr.random_state(np.random.default_rng(5), robot)
    case = case_of(robot, state)
    check(case, "modular", tolerance=min(case.tolerance, 1e-6))


# -------- many links


def test_forty_equal_links():
    """One class, forty links: both forms agree, and a short motion keeps its energy."""
    model = model_of(equal_links(40))
    compiled, numeric = quick(model, layout="modular"), model.numpy()
    rng = np.random.default_rng(0)
    q, v = 0.3 * rng.normal(size=model.nq), np.zeros(model.nq)
    q[model.n_joints :] = 1e-3 * rng.normal(size=40)
    tau, w_ext = np.zeros(40), np.zeros((40, 6))
    joint, dae = (compiled.forward_dynamics(q, v, tau, w_ext, form)[0] for form in ("joint", "dae"))
    assert np.allclose(joint, numeric.forward_dynamics(q, v, tau, w_ext)[0], rtol=0, atol=1e-9 * np.abs(joint).max())
    assert np.allclose(joint, dae, rtol=0, atol=1e-9 * np.abs(joint).max())
    before = numeric.energy(q, v)
    q, v = compiled.step(q, v, tau, w_ext, 1e-5, "rk4", 200)
    after = numeric.energy(q, v)
    assert after[0] > 1e-3 and abs(sum(after) - sum(before)) <= 1e-8 * after[0]
