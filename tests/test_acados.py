"""The export to acados: the fields of AcadosModel, index 1, and numbers of the oracle; acados itself is not needed."""

from dataclasses import FrozenInstanceError
from functools import cache
from types import SimpleNamespace

import casadi as ca
import numpy as np
import pytest
from helpers import arm, case_of, drawn, example, example_dict, link, relative
from random_robots import random_state

from screwgen import UsageError

FORMS = ("joint", "dae")
RIGID = arm(link("a", axes="zy"), link("b", axes="y"))
WELDED = arm(link("a", axes=[], modes={"bending_y": 1, "axial": 1}))
CASES = ("ella", "rigid", "welded", 3)
BOUND = [*((which, "runtime") for which in CASES), ("ella", "baked"), (3, "baked")]


@cache
def case(which):
    """An example, or a random robot by its seed, in a random state with tip wrenches, and its oracle."""
    if isinstance(which, int):
        return drawn(which, 1 + which % 3)
    robot = {"rigid": RIGID, "welded": WELDED}.get(which) or example_dict(which)
    return case_of(robot, random_state(np.random.default_rng(1), robot))


def state(export, form, case) -> np.ndarray:
    """x of the export in the case's state."""
    q, v, _, _ = case.inputs
    return np.r_[q, v] if form == "joint" else case.model.numpy().dae_state(q, v)


def residual(export):
    """F and its Jacobian with [xdot; z], as a function of x, [xdot; z], u and p."""
    unknowns = ca.vertcat(export.xdot, export.z)
    outputs = [export.f_impl_expr, ca.jacobian(export.f_impl_expr, unknowns)]
    return ca.Function("F", [export.x, unknowns, export.u, export.p], outputs)


def equilibrated(J: np.ndarray) -> np.ndarray:
    """Rows and columns scaled to about one: wrenches and accelerations differ by their units."""
    for _ in range(10):
        J = J / np.sqrt(np.abs(J).max(axis=1, keepdims=True))
        J = J / np.sqrt(np.abs(J).max(axis=0, keepdims=True))
    return J


def solved(export, x, u, p) -> tuple[np.ndarray, np.ndarray]:
    """xdot and z from F = 0, which is linear in them."""
    size = export.xdot.numel() + export.z.numel()
    F, J = (y.full() for y in residual(export)(x, np.zeros(size), u, p))
    found = np.linalg.solve(J, -F[:, 0])
    found -= np.linalg.solve(J, residual(export)(x, found, u, p)[0].full()[:, 0])
    return np.split(found, [export.xdot.numel()])


# -------- structure


@pytest.mark.parametrize("w_ext", [False, True])
@pytest.mark.parametrize("binding", ["runtime", "baked"])
@pytest.mark.parametrize("form", FORMS)
def test_fields_are_those_of_acados(form, binding, w_ext):
    model = example("ella")
    e = model.acados(form, binding, w_ext)
    nx, nz = (18, 0) if form == "joint" else (len(model.dae_names["x"]), len(model.dae_names["z"]))
    np_ = (len(model.parameter_names) if binding == "runtime" else 0) + (12 if w_ext else 0)
    assert e.name == "ella"
    assert all(isinstance(getattr(e, k), ca.SX) for k in ("x", "xdot", "u", "z", "p", "f_impl_expr"))
    assert [s.shape for s in (e.x, e.xdot, e.u, e.z, e.p)] == [(nx, 1), (nx, 1), (3, 1), (nz, 1), (np_, 1)]
    assert e.f_impl_expr.shape == (nx + nz, 1) and e.f_impl_expr.is_dense()
    assert e.f_expl_expr is None if form == "dae" else e.f_expl_expr.shape == (nx, 1)
    assert (len(e.x_labels), len(e.u_labels), len(e.z_labels), len(e.p_labels)) == (nx, 3, nz, np_)
    assert len(e.parameter_values) == np_
    with pytest.raises(FrozenInstanceError):
        e.name = "other"


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("which", ["ella", 3])
def test_symbols_are_those_declared(which, form):
    """Every declared symbol once; no expression has another."""
    e = case(which).model.acados(form, w_ext=True)
    declared = [s for part in (e.x, e.xdot, e.u, e.z, e.p) for s in ca.vertsplit(part) if part.numel()]
    assert all(s.is_symbolic() for s in declared) and len({hash(s) for s in declared}) == len(declared)
    ca.Function("F", [e.x, e.xdot, e.u, e.z, e.p], [e.f_impl_expr])  # refuses free symbols
    used = {hash(s) for s in ca.symvar(e.f_impl_expr)}
    assert {hash(s) for part in (e.xdot, e.u, e.z) for s in ca.vertsplit(part) if part.numel()} <= used
    if form == "joint":
        ca.Function("f", [e.x, e.u, e.p], [e.f_expl_expr])


def test_labels_and_values():
    model = example("ella")
    joint, dae = model.acados(), model.acados("dae", "baked", w_ext=True)
    assert joint.x_labels == (*model.q_names, *model.v_names) and joint.u_labels == tuple(model.tau_names)
    assert joint.p_labels == tuple(model.parameter_names) and joint.parameter_values == tuple(model.parameter_values)
    assert (list(dae.x_labels), list(dae.z_labels)) == (model.dae_names["x"], model.dae_names["z"])
    assert dae.p_labels[6:8] == ("forearm.w_ext.tau_x", "forearm.w_ext.tau_y") and not any(dae.parameter_values)
    assert repr(joint) == "<AcadosExport of ella: x 18, u 3, z 0, p 17>"


@pytest.mark.parametrize("form", FORMS)
def test_fills_a_model_of_acados(form):
    """An object with AcadosModel's defaults; what the export does not speak of stays."""
    target = SimpleNamespace(name=None, x=None, xdot=None, u=None, z=[], p=[], t=[], f_impl_expr=None, con_h_expr=1)
    export = example("ella").acados(form)
    assert export.into(target) is target
    for field in ("name", "x", "xdot", "u", "z", "p", "f_expl_expr", "f_impl_expr"):
        assert getattr(target, field) is getattr(export, field)
    assert target.x_labels == list(export.x_labels) and target.u_labels == list(export.u_labels)
    assert target.t == [] and target.con_h_expr == 1 and not hasattr(target, "z_labels")
    assert target.z.is_empty() == (form == "joint")


def test_unknown_choices_are_refused():
    model = example("ella")
    with pytest.raises(UsageError, match="no form 'cauchy'; choose joint or dae"):
        model.acados("cauchy")
    with pytest.raises(UsageError, match="no binding of the parameters 'const'; choose runtime or baked"):
        model.acados(parameters="const")


# -------- index and numbers


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("which", CASES)
def test_index_one(which, form):
    """dF/d(xdot, z) is square, regular, and free of xdot and z; of the joint form it is diag(1, M)."""
    c = case(which)
    e = c.model.acados(form, w_ext=True)
    size, rng = e.xdot.numel() + e.z.numel(), np.random.default_rng(2)
    x, tau = state(e, form, c), np.array(c.state["tau"])
    p = np.r_[c.model.parameter_values, np.ravel(c.state["w_ext"])]
    J, again = (residual(e)(x, rng.normal(size=size), tau, p)[1].full() for _ in range(2))
    assert J.shape == (size, size) and np.array_equal(J, again)
    singular = np.linalg.svd(equilibrated(J), compute_uv=False)
    assert singular[-1] > 1e3 * size * np.finfo(float).eps * singular[0]
    if form == "joint":
        nq = c.model.nq
        M = c.oracle.mass_matrix(c.state["q"])
        assert relative(J, np.block([[np.eye(nq), np.zeros((nq, nq))], [np.zeros((nq, nq)), M]])) <= c.tolerance


@pytest.mark.parametrize(("which", "binding"), BOUND)
def test_both_forms_equal_the_oracle(which, binding):
    """Joint form, explicit and implicit: xdot = [v; vdot]. DAE form, z: joint wrenches, the rates of the links' twists
    and the modal accelerations; xdot: what follows from them.
    """
    c = case(which)
    joint, dae = (c.model.acados(form, binding, w_ext=True) for form in FORMS)
    q, v, tau, w_ext = c.inputs
    p = np.r_[c.model.parameter_values if binding == "runtime" else [], w_ext.ravel()]
    vdot, wrench = c.oracle.forward_dynamics(q, v, tau, w_ext)
    explicit = ca.Function("f", [joint.x, joint.u, joint.p], [joint.f_expl_expr])(np.r_[q, v], tau, p).full()[:, 0]
    for found in (explicit, solved(joint, np.r_[q, v], tau, p)[0]):
        assert relative(found[: len(q)], v) <= 1e-15
        assert max(c.oracle.errors(c.state, found[len(q) :], wrench).values()) <= c.tolerance
    xdot, z = solved(dae, state(dae, "dae", c), tau, p)
    n, m, r = c.model.n_links, c.model.n_joints, c.model.nq - c.model.n_joints
    links = z[: 12 * n].reshape(n, 12)
    found = np.r_[vdot[:m], z[12 * n :]]
    assert max(c.oracle.errors(c.state, found, links[:, :6]).values()) <= c.tolerance
    assert relative(links[:, 6:], c.oracle.link_twist_rates(q, v, vdot)) <= c.tolerance
    ends = np.cumsum([7 * n, r, 6 * n, r])
    _, etadot, twist_rates, etaddot, qdot = np.split(xdot, ends)
    assert relative(etadot, v[m:]) <= 1e-12 and relative(qdot, v[:m]) <= c.tolerance
    assert relative(twist_rates, links[:, 6:].ravel()) <= 1e-12 and relative(etaddot, z[12 * n :]) <= 1e-12
    assert relative(xdot, c.model.numpy().dae_rates(state(dae, "dae", c), tau, w_ext)[0]) <= c.tolerance


def test_parameters_and_wrenches_are_live():
    """Other parameters give another motion, that of a model with these; without tip wrenches they are zero."""
    model = example("ella")
    q, v, tau = np.array([0.3, -0.2, 0.5, *[1e-3] * 6]), np.full(9, 0.1), np.array([5.0, -3.0, 1.0])
    p = np.array(model.parameter_values) * np.linspace(0.8, 1.2, len(model.parameter_values))
    e = model.acados()
    f = ca.Function("f", [e.x, e.u, e.p], [e.f_expl_expr])
    expected = model.numpy(p).forward_dynamics(q, v, tau, np.zeros((2, 6)))[0]
    assert relative(f(np.r_[q, v], tau, p).full()[9:, 0], expected) <= 1e-11
    assert relative(f(np.r_[q, v], tau, e.parameter_values).full()[9:, 0], expected) > 1e-3
