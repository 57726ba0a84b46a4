"""The formulation as printed: where its pieces sit, what each of them does to an arm, and that the rest is derived."""

import json

import numpy as np
import pytest

import screwgen
from screwgen.algebra.expression import hat, identity
from screwgen.cli.main import main
from screwgen.errors import UsageError
from screwgen.paper import appendix_b, link
from screwgen.paper.arm import MASSES, ella
from screwgen.paper.arm_state import ArmState
from screwgen.paper.evaluate import evaluate
from screwgen.paper.locked_joints import frequencies_without_wrenches
from screwgen.paper.printed import PRINTED, PrintedModel
from screwgen.paper.printed_system import L, System, at_point
from screwgen.paper.register import equations


def bare(**rest):
    """The paper's arm without bodies; two modes in each plane."""
    robot = ella(2, **rest)
    return robot.model_copy(update={"links": tuple(l.model_copy(update={"bodies": ()}) for l in robot.links)})


def drawn(model, seed=0):
    random = np.random.default_rng(seed)
    q, v = random.normal(size=(2, model.nq)) * 0.5
    q[model.n_joints :] *= 0.02
    return q, v, random.normal(size=model.n_joints)


@pytest.mark.parametrize("robot", [ella(), bare(), ella(0, axial=0)], ids=["arm", "bare", "rigid"])
@pytest.mark.parametrize("seed", range(3))
def test_with_nothing_printed_it_is_the_consistent_model(robot, seed):
    printed = PrintedModel(robot, ())
    consistent = screwgen.derive(robot.model_copy(update={"section_rotation": False})).numpy()
    q, v, tau = drawn(printed.model, seed)
    for own, other in zip(
        printed.forward_dynamics(q, v, tau), consistent.forward_dynamics(q, v, tau, np.zeros((2, 6))), strict=True
    ):
        assert np.abs(own - other).max() <= 1e-10 * np.abs(other).max()


@pytest.fixture(scope="module")
def system():
    """The derived system of the bare arm in a random state."""
    model = screwgen.derive(bare(section_rotation=False))
    q, v, tau = drawn(model, 4)
    x, numeric = model.numpy().dae_state(q, v), model.numpy()
    return System(model.chain, ArmState(model, x), *numeric.assemble(x, tau, np.zeros((2, 6))))


@pytest.mark.parametrize("k", [0, 1])
def test_the_derived_pieces_sit_where_the_printed_ones_go(system, k):
    """Mass, modal columns, bias and rows of modes: the register's derived formulas are the system's own entries."""
    view, acc, modes, s = system.views[k], system.accelerations(k), system.modes(k), system.scale(k)
    close = lambda a, b: np.allclose(a, b, rtol=1e-9, atol=1e-9 * np.abs(b).max())  # noqa: E731
    M_D = np.vstack([evaluate(row[0], view) for row in appendix_b.DERIVED_M_D.rows[2:4]])
    assert close(system.M[acc, modes], M_D * s)
    rows = [[evaluate(x, view) for x in row[2:4]] for row in appendix_b.DERIVED_M_DPSI.rows[2:4]]
    M_star = evaluate(L.M_star @ (identity(6) + L.T_gamma), view)
    spin = np.zeros((6, 6))
    spin[0, 0] = 2.15e-4 * system.state.links[k].length  # rhoIp, which the paper does not have
    assert close(system.M[acc, acc], M_star + np.block(rows) + spin)
    coriolis = hat(L.omega) @ L.rdot_xi
    h_MD = np.vstack([evaluate(L.integral(x, L.rhoA), view) for x in (hat(L.r_ib) @ coriolis, coriolis)])
    v = system.values(k)
    spin_bias = 2.15e-4 * system.state.links[k].length * v["omega"][0, 0] * np.cross(v["omega"].ravel(), [1.0, 0, 0])
    h_s = evaluate(link.DERIVED_H_STAR, view)
    h_s[:3, 0] += spin_bias
    assert close(system.h_s[k], h_s)
    bias = h_s + h_MD + (twist_columns(view, rows) @ v["gamma_star"])
    assert close(system.H[acc].reshape(6, 1), bias)


def twist_columns(view, rows):
    """The columns of ``Vdot`` in a link's rows: those of ``Zdot`` without the change of coordinates."""
    change = np.eye(6) + view.values["T_gamma:i"]
    return (view.values["M_star:i"] @ change + np.block(rows)) @ np.linalg.inv(change)


@pytest.mark.parametrize("k", [0, 1])
def test_the_rows_of_the_joints_have_the_sign_and_frame_that_corrections_assume(system, k):
    v = system.values(k)
    inertial = -np.kron(np.eye(2), v["R"]) @ system.M[system.joint(k), system.accelerations(k)]
    expected = -at_point_value(system, k) @ (np.eye(6) + v["T_gamma"])
    assert np.allclose(v["P"] @ inertial, v["P"] @ expected, atol=1e-12)


def at_point_value(system, k):
    return evaluate(at_point(L, L.r_b_a + L.r_xi_a), system.views[k])


@pytest.mark.parametrize("label", PRINTED)
def test_every_printed_equation_changes_the_accelerations(label):
    robot = ella(bending=1)
    q, v, tau = drawn(PrintedModel(robot, ()).model, 7)
    derived = PrintedModel(robot, ()).forward_dynamics(q, v, tau)[0]
    printed = PrintedModel(robot, (label,)).forward_dynamics(q, v, tau)[0]
    assert np.abs(printed - derived).max() > 1e-6 * np.abs(derived).max()


def test_what_can_be_run_is_in_the_register():
    failing = {e.label for e in equations() if e.derived} | {"26"}
    assert set(PRINTED) <= failing


def test_without_h_s_the_base_does_not_feel_the_weight():
    robot = ella(0, axial=0)
    at_rest = np.zeros(3)
    hold = np.zeros(3)
    weight = 9.81 * (1.6302 * 1.88 + sum(MASSES))
    wrench = lambda labels: PrintedModel(robot, labels).forward_dynamics(at_rest, at_rest, hold)[1]  # noqa: E731
    assert np.abs(wrench(("97",))).max() < 1e-9
    assert np.abs(wrench(())).max() > 0.01 * weight


def test_without_wrenches_in_the_modal_rows_the_arm_is_two_bare_beams():
    """(85) alone, joints locked, masses beyond the joints: the frequencies of E16."""
    model = PrintedModel(ella(locked=True, gravity=(0, 0, 0), bodies_beyond=True), ("85",))
    n = model.model.nq
    still = np.zeros(n)
    columns = [model.forward_dynamics(1e-6 * e, still, still[:0])[0] / 1e-6 for e in np.eye(n)]
    found = np.sqrt(np.sort(-np.linalg.eigvals(np.array(columns).T).real)) / (2 * np.pi)
    assert np.allclose(found, frequencies_without_wrenches(), rtol=1e-4)
    assert np.allclose(found[:4], [22.4, 23.3, 29.4, 30.7], atol=0.06)


def test_a_run_as_printed_diverges_and_the_derived_one_does_not():
    robot = ella(axial=0)
    run = PrintedModel(robot, ()).simulate(0.02)
    assert np.isfinite(run.q).all() and len(run.t) == 21
    with pytest.raises(screwgen.DivergedError, match="diverged at t = "):
        PrintedModel(robot).simulate(2.0)


def test_the_formulation_is_chosen_by_name(tmp_path, capsys):
    robot = ella()
    assert isinstance(screwgen.derive(robot, formulation="printed"), PrintedModel)
    assert isinstance(screwgen.derive(robot), screwgen.Model)
    with pytest.raises(UsageError, match="no formulation 'wrong'; choose consistent or printed"):
        screwgen.derive(robot, formulation="wrong")
    with pytest.raises(UsageError, match=r"\(27\) changes no number"):
        PrintedModel(robot, ("27",))
    assert main(["evaluate", "examples/ella_paper.toml", "--formulation", "printed"]) == 0
    out = json.loads(capsys.readouterr().out)
    assert out["as_printed"] == list(PRINTED)
    assert len(out["vdot"]) == 9 and len(out["wrench"]) == 2
    assert main(["evaluate", "examples/ella_paper.toml", "--formulation", "printed", "--backend", "c"]) == 2
    assert main(["evaluate", "examples/ella_paper.toml", "--formulation", "other"]) == 2


def test_torsion_is_refused():
    robot = ella()
    first = robot.links[0]
    section = first.section.model_copy(update={"GJ": 100.0})
    modes = first.modes.model_copy(update={"torsion": 1})
    twisting = first.model_copy(update={"section": section, "modes": modes})
    with pytest.raises(UsageError, match="no torsion modes"):
        PrintedModel(robot.model_copy(update={"links": (twisting, robot.links[1])}))
