"""The export to acados of robots with loops: index 1, and the accelerations and forces of the loops."""

import casadi as ca
import numpy as np
import pytest
from dual_arm import dual_arm
from dual_arm import start as flying
from helpers import model_of, relative
from test_acados import equilibrated, residual, solved
from test_linear_loops import BALL, HINGE, linkage
from test_loop_derivatives import moved

from screwgen.simulation.mobility import closing


def robot(name: str):
    """A model, and a state of it with open loops."""
    if name == "floating":
        model = model_of(dual_arm())
        q, v = flying(model)
        return model, (q + 0.01 * (np.arange(model.nq) >= 7), v, *moved(model, q)[2:])
    bending = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"rhoA": 1.5, "EIy": 300.0, "EIz": 300.0}}
    model = linkage(BALL if name == "ball" else HINGE, None, bending)
    return model, moved(model, model.chain.home)


@pytest.mark.parametrize("name", ["ball", "floating"])
def test_the_joint_form_has_the_forces_of_the_rows_as_algebraic_unknowns(name):
    model, (q, v, tau, w_ext) = robot(name)
    export, numeric = model.acados(w_ext=True), model.numpy()
    rows, x, p = len(model.chain.closing.rows), np.append(q, v), np.append(model.parameter_values, w_ext)
    assert export.z.numel() == rows and export.f_impl_expr.numel() == len(x) + rows
    assert export.z_labels[:2] == ("loop[0].force[0]", "loop[0].force[1]")
    J = residual(export)(x, np.ones(len(x) + rows), tau, p)[1].full()
    singular = np.linalg.svd(equilibrated(J), compute_uv=False)
    assert singular[-1] > 1e-8 * singular[0]
    xdot, forces = solved(export, x, tau, p)
    explicit = ca.Function("f", [export.x, export.u, export.p], [export.f_expl_expr])(x, tau, p).full()[:, 0]
    vdot, _ = numeric.forward_dynamics(q, v, tau, w_ext)
    assert relative(xdot[len(q) :], vdot) < 1e-10 and relative(explicit, xdot) < 1e-10
    assert relative(on_tips(model, q, forces), numeric.loop_wrenches(q, v, tau, w_ext)) < 1e-10


def on_tips(model, q, forces) -> np.ndarray:
    """The wrenches (n, 6) on the tips of forces of the rows."""
    return np.array(closing(model)(q, np.zeros(model.nv), forces, model.parameter_values)[4]).T


def test_the_dae_form():
    """Its forces of the loops are not unknowns: they are functions of the state."""
    model, (q, v, tau, w_ext) = robot("hinge")
    export, numeric = model.acados("dae", w_ext=True), model.numpy()
    x, p = numeric.dae_state(q, v), np.append(model.parameter_values, w_ext)
    xdot, _ = solved(export, x, tau, p)
    assert relative(xdot, numeric.dae_rates(x, tau, w_ext)[0]) < 1e-10
