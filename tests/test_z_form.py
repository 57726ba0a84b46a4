"""The Z-form: its coordinates, its assembled system and its Cauchy form, against the oracle."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
import random_robots as rr
import sympy as sp
from helpers import arm, case_of, example, example_dict, flat, link, model_of, relative
from latex_documents import robot as document_robot
from oracle import part_error
from scipy.integrate import solve_ivp
from z_form_cases import Placed, placed, series

from screwgen.algebra.components import components
from screwgen.algebra.expression import Symbol
from screwgen.algebra.rate import rate
from screwgen.chain.scope import common
from screwgen.emit import latex
from screwgen.emit.latex_layout import PAGE, width

SEEDS = range(700, 708)
every_robot = pytest.mark.parametrize("seed", SEEDS)
NAMES = {
    "exponential": (["theta"], ["R", "J", "J_inverse"]),
    "cauchy_state": (["q", "v", "p"], ["x_c"]),
    "z_form": (["x_c", "q", "p"], ["T_gamma", "Gamma_star", "h_Ms", "M_dyn", "h_dyn"]),
    "assemble_z": (["x_c", "q", "tau", "w_ext", "p"], ["M_sys", "H_sys", "W_sys"]),
    "cauchy": (["x_c", "q", "tau", "w_ext", "p"], ["A_c", "g_c", "qdot", "wrench"]),
}


def solved(at: Placed) -> np.ndarray:
    M, H, W = at.call("assemble_z")
    return np.linalg.solve(M, W - H)[:, 0]


# -------- the assembled system


@every_robot
def test_solution_equals_lagrange(seed):
    """Joint wrenches, Zdot and etaddot of the Z system against the oracle, which knows neither twist form nor Z."""
    at = placed(seed)
    errors = at.errors(solved(at))
    assert max(errors.values()) <= at.case.tolerance, errors


@every_robot
def test_solution_is_that_of_the_twist_form(seed):
    """Vdot = (I + T_gamma) Zdot + gamma* takes one solution to the other, and the joint form has the same."""
    at = placed(seed)
    T, star = at.change
    M, H, W = at.call("assemble")
    twist_form, mapped = np.linalg.solve(M, W - H)[:, 0], T @ solved(at) + star
    vdot, wrench = at.call("forward_dynamics")
    a, b = (np.hsplit(z[: 12 * at.n].reshape(at.n, 12), 4) for z in (twist_form, mapped))
    for part, companion in ((0, 1), (1, 0), (2, 3), (3, 2)):  # tau and F, angular and linear accelerations
        assert part_error(a[part], b[part], a[companion]) <= at.case.tolerance
    assert part_error(vdot[at.m :, 0], mapped[12 * at.n :], a[2]) <= at.case.tolerance
    assert part_error(wrench.T, np.hstack(b[:2]), wrench) <= at.case.tolerance


@every_robot
def test_system_in_z_is_the_twist_form_times_the_change(seed):
    """M_sys (I + T_gamma), H_sys + M_sys Gamma*, W_sys: the paper's (MsPsi) and (HMs) over all rows."""
    at = placed(seed)
    T, star = at.change
    M, H, W = at.call("assemble")
    M_z, H_z, W_z = at.call("assemble_z")
    assert relative(M_z, M @ T) <= 1e-12
    assert relative(H_z[:, 0], H[:, 0] + M @ star) <= 1e-12
    assert relative(W_z, W) <= 1e-12


@every_robot
def test_pieces_are_those_of_the_paper(seed):
    """T_gamma and Gamma* of the definitions; h_Ms = (M_s + M_DPsi) Gamma*; M_dyn and h_dyn the rows of the system."""
    at = placed(seed)
    T, star = at.change
    size = 12 * at.n
    M, H, _ = at.call("assemble")
    T_gamma, Gamma_star, h_Ms, M_dyn, h_dyn = at.call("z_form")
    assert relative(T_gamma, (T - np.eye(len(T)))[:size, :size]) <= 1e-12
    rounding = 1e-13 * max(1.0, np.abs(at.omega).max()) ** 2  # a link that turns about the origin has no Gamma*
    assert np.abs(Gamma_star[:, 0] - star[:size]).max() <= rounding
    assert np.abs(h_Ms[:, 0] - M[:size, :size] @ star[:size]).max() <= rounding * np.abs(M).max()
    assert relative(M_dyn, M[:size, :size] @ T[:size, :size]) <= 1e-12
    assert relative(h_dyn, h_Ms + H[:size]) <= 1e-12


def differential(at: Placed, M: np.ndarray) -> np.ndarray:
    """Rows and columns of the links' accelerations and of the modes, (Msys_diff)."""
    size = 12 * at.n
    keep = [k for k in range(len(M)) if k >= size or k % 12 >= 6]
    return M[np.ix_(keep, keep)]


@every_robot
def test_symmetric_only_with_the_rows_changed_too(seed):
    """E26: rows dual to V with unknowns Zdot are not symmetric where r_i is not zero; (I + T_gamma)^T M is."""
    at = placed(seed)
    T, _ = at.change
    M = at.call("assemble_z")[0]
    block = differential(at, T.T @ M)
    assert np.abs(block - block.T).max() <= 1e-12 * np.abs(block).max()
    plain = differential(at, M)
    skew = np.abs(plain - plain.T).max() / np.abs(plain).max()
    assert (skew > 1e-3) == (np.abs(at.r).max() > 1e-3), (skew, at.r)


def test_a_frame_at_the_origin_needs_no_change():
    """The other half of E26: with r_1 = 0 the twist and Z form of the block are one, and symmetric as it is."""
    case = case_of(robot := arm(link("only", 0.8, ["y", "z"])), rr.random_state(np.random.default_rng(5), robot))
    at = Placed(case)
    assert np.abs(at.r).max() < 1e-15
    plain = differential(at, at.call("assemble_z")[0])
    assert np.array_equal(plain, differential(at, at.call("assemble")[0]))
    assert np.abs(plain - plain.T).max() == 0


# -------- the state


def test_angles_lie_between_zero_and_half_a_turn():
    """A joint that turns on and on: theta is its angle less whole turns, and jumps in sign at half a turn."""
    model = model_of(arm(link("only", 1.0, "z")))
    for angle in np.linspace(-10, 10, 81):
        theta = flat(model.casadi()["cauchy_state"]([angle], [0.0], model.parameter_values))[:3]
        wrapped = (angle + np.pi) % (2 * np.pi) - np.pi
        assert np.allclose(theta, [0, 0, wrapped], atol=1e-14)
    half = flat(model.casadi()["cauchy_state"]([np.pi], [0.0], model.parameter_values))[:3]
    assert np.isclose(abs(half[2]), np.pi, rtol=1e-15)


@every_robot
def test_state_is_that_of_the_motion(seed):
    """exp(theta_i), r_i, Z_i against the oracle's poses and twists; eta and etadot in their places."""
    at = placed(seed)
    x, n, r = at.x_c, at.n, len(at.q) - at.m
    poses, Z = x[: 6 * n].reshape(n, 6), x[6 * n + r : 12 * n + r].reshape(n, 6)
    for i in range(n):
        assert np.linalg.norm(poses[i, :3]) <= np.pi + 1e-12
        assert np.allclose(series(poses[i, :3])[0], at.R[i], rtol=0, atol=1e-12)
    assert relative(poses[:, 3:], at.r) <= 1e-11
    assert relative(Z, np.c_[at.omega, at.rdot]) <= 1e-11
    assert np.array_equal(x[6 * n : 6 * n + r], at.q[at.m :]) and np.array_equal(x[12 * n + r :], at.v[at.m :])


def test_names_follow_the_state():
    model = example("ella")
    names = model.cauchy_names
    pose = ("theta_x", "theta_y", "theta_z", "r_x", "r_y", "r_z")
    assert names["x_c"][:7] == [*(f"upper_arm.{c}" for c in pose), "forearm.theta_x"]
    assert names["x_c"][12:18] == model.q_names[3:] and names["x_c"][-6:] == model.v_names[3:]
    assert names["x_c"][18:24] == [
        f"upper_arm.{c}" for c in ("omega_x", "omega_y", "omega_z", "rdot_x", "rdot_y", "rdot_z")
    ]
    assert names["q_sys"][6] == "upper_arm.omega_x_rate" and names["q_sys"][21] == "forearm.rdot_x_rate"
    assert len(names["q_sys"]) == len(model.dae_names["z"]) == 30
    for name in ("x_c", "q_sys"):
        assert len(set(names[name])) == len(names[name])


# -------- the Cauchy form


@every_robot
def test_cauchy_form_is_the_rate_of_the_state(seed):
    """A_c x_c + g_c against the derivative of cauchy_state along the oracle's motion: by differentiation, which
    reaches rounding, and by Richardson's central differences, which share nothing with it.
    """
    at = placed(seed)
    A, g, qdot, wrench = at.call("cauchy")
    x_c, p = at.x_c, at.model.parameter_values
    given = A @ x_c + g[:, 0]
    state, n, r = at.model.casadi()["cauchy_state"], at.n, len(at.q) - at.m
    exact = flat(state.jacobian()(at.q, at.v, p, 0)[0] @ at.v + state.jacobian()(at.q, at.v, p, 0)[1] @ at.vdot)
    h = 1e-3 / np.sqrt(1 + np.abs(at.vdot).max())
    along = lambda t: flat(state(at.q + t * at.v + t * t / 2 * at.vdot, at.v + t * at.vdot, p))  # noqa: E731
    coarse, fine = ((along(s) - along(-s)) / (2 * s) for s in (h, h / 2))
    differences = (4 * fine - coarse) / 3
    parts = {"poses": slice(0, 6 * n), "modes": slice(6 * n, 6 * n + r), "Z": slice(6 * n + r, 12 * n + r)}
    for part in (*parts.values(), slice(12 * n + r, None)):
        assert relative(given[part], exact[part]) <= 10 * at.case.tolerance
        assert relative(given[part], differences[part]) <= 1e-5
    assert relative(qdot[:, 0], at.v[: at.m]) <= 1e-10
    assert part_error(at.wrench, wrench.T, at.wrench) <= at.case.tolerance
    assert not np.any(A[:, : 6 * n + r]) and not np.any(A[6 * n + r :]) and not np.any(g[: 6 * n + r])


def test_printed_jacobian_fails():
    """E18 in numbers: with J in place of its inverse A_c misses the rate of theta by a good part of it."""
    at = placed(703)
    last, r = at.n - 1, len(at.q) - at.m
    A = at.call("cauchy")[0]
    theta, omega = at.x_c[6 * last : 6 * last + 3], at.omega[last]
    J = series(theta)[1]
    thetadot = (A @ at.x_c)[6 * last : 6 * last + 3]
    assert np.allclose(J @ thetadot, omega, atol=1e-11)
    assert np.linalg.norm(theta) > 0.3 and np.linalg.norm(J @ omega - thetadot) > 0.1 * np.linalg.norm(thetadot)
    assert np.array_equal(A[3:6, 6 * at.n + r + 3 : 6 * at.n + r + 6], np.eye(3))


SOFT = {"EIy": 80.0, "EIz": 60.0, "GJ": 40.0}
SKEW = arm(
    link("shoulder", 0.7, [[0.2, 0.9, 0.3], "z"], frame_at=0.3, modes={"bending_y": 1, "bending_z": 1}, section=SOFT),
    link("elbow", 0.5, ["y", [0.1, 0.3, 1.0]], modes={"torsion": 1, "bending_z": 1}, section=SOFT),
)


@pytest.mark.parametrize("name", ["ella", "skew"])
def test_cauchy_form_integrates_to_the_joint_forms_state(name):
    """0.2 s by one adaptive integrator of order eight: both forms end in one state."""
    model = example("ella") if name == "ella" else model_of(SKEW)
    functions, p, m = model.casadi(), model.parameter_values, model.n_joints
    rng = np.random.default_rng(7)
    robot = example_dict("ella") if name == "ella" else SKEW
    state = rr.random_state(rng, robot, angle=0.8, rate=1.0, modal=0.1)
    q, v, tau = (np.array(state[k]) for k in ("q", "v", "tau"))
    w_ext, size = np.array(state["w_ext"]).T, len(model.cauchy_names["x_c"])

    x, y = ca.MX.sym("x", size + m), ca.MX.sym("y", 2 * len(q))
    A, g, qdot, _ = functions["cauchy"](x[:size], x[size:], tau, w_ext, p)
    vdot, _ = functions["forward_dynamics"](*ca.vertsplit(y, len(q)), tau, w_ext, p)
    cauchy = ca.Function("cauchy", [x], [ca.vertcat(A @ x[:size] + g, qdot)])
    joint = ca.Function("joint", [y], [ca.vertcat(y[len(q) :], vdot)])

    def run(rates, begin):
        options = {"method": "DOP853", "rtol": 1e-9, "atol": 1e-11}
        return solve_ivp(lambda _, state: rates(state).full()[:, 0], (0, 0.2), begin, **options).y[:, -1]

    start = np.r_[flat(functions["cauchy_state"](q, v, p)), q[:m]]
    end, reached = np.split(run(joint, np.r_[q, v]), 2), run(cauchy, start)
    expected = flat(functions["cauchy_state"](*end, p))
    assert np.abs(end[0] - q).max() > 0.05
    scale = np.maximum(1.0, np.abs(expected))
    assert np.max(np.abs(reached[:size] - expected) / scale) <= 1e-6
    assert np.allclose(reached[size:], end[0][:m], atol=1e-6)


# -------- what users do


@pytest.mark.parametrize("name", ["ella", "six_link"])
def test_names_and_shapes(name):
    model = example(name)
    n, r, m, np_ = model.n_links, model.nq - model.n_joints, model.n_joints, len(model.parameter_values)
    nx, nz = 12 * n + 2 * r, 12 * n + r
    shapes = {"x_c": (nx, 1), "q": (m, 1), "tau": (m, 1), "w_ext": (6, n), "p": (np_, 1), "theta": (3, 1)}
    shapes |= {"T_gamma": (12 * n, 12 * n), "Gamma_star": (12 * n, 1), "h_Ms": (12 * n, 1), "M_dyn": (12 * n, 12 * n)}
    shapes |= {"h_dyn": (12 * n, 1), "M_sys": (nz, nz), "H_sys": (nz, 1), "W_sys": (nz, 1), "A_c": (nx, nx)}
    shapes |= {"g_c": (nx, 1), "qdot": (m, 1), "wrench": (6, n), "R": (3, 3), "J": (3, 3), "J_inverse": (3, 3)}
    for key, (inputs, outputs) in NAMES.items():
        f = model.casadi()[key]
        assert (f.name(), f.name_in(), f.name_out()) == (key, inputs, outputs)
        if key != "cauchy_state":
            assert [f.size_in(i) for i in range(f.n_in())] == [shapes[i] for i in inputs]
        assert [f.size_out(i) for i in range(f.n_out())] == [shapes[o] for o in outputs]
    functions = model.casadi()
    assert functions["cauchy"].nnz_out("A_c") == 12 * n + r
    assert functions["assemble_z"].nnz_out("M_sys") < 0.4 * nz**2
    assert functions["z_form"].nnz_out("T_gamma") == 6 * n


def arguments(name: str) -> dict[str, np.ndarray]:
    model = example(name)
    robot = example_dict(name)
    state = rr.random_state(np.random.default_rng(3), robot)
    q, v = (np.array(state[k]) for k in ("q", "v"))
    p = np.array(model.parameter_values)
    x_c = flat(model.casadi()["cauchy_state"](q, v, p))
    return {"x_c": x_c, "q": q[: model.n_joints], "q_all": q, "v": v, "p": p, "theta": np.array([0.3, 0.2, -0.9])} | {
        "tau": np.array(state["tau"]),
        "w_ext": np.array(state["w_ext"]).T,
    }


def inputs_of(function: ca.Function, given: dict) -> list[np.ndarray]:
    return [given["q_all" if (name, function.name()) == ("q", "cauchy_state") else name] for name in function.name_in()]


@pytest.mark.parametrize("kind", [ca.SX, ca.MX])
def test_functions_take_symbols_and_survive_a_file(kind, tmp_path):
    given, functions = arguments("ella"), example("ella").casadi()
    for name in NAMES:
        f = functions[name]
        symbols = [kind.sym(n, *f.size_in(n)) for n in f.name_in()]
        again = ca.Function("again", symbols, f.call(symbols))
        f.save(str(tmp_path / name))
        values = [ca.DM(x) for x in inputs_of(f, given)]
        expected = f.call(values)
        for other in (again, ca.Function.load(str(tmp_path / name))):
            assert all(np.array_equal(a.full(), b.full()) for a, b in zip(other.call(values), expected, strict=True))


def test_a_full_turn_is_not_passed_in_silence():
    """A_c is infinite where a link's exponential coordinates have ended, and there alone."""
    given, cauchy = arguments("ella"), example("ella").casadi()["cauchy"]
    given["x_c"][:3] = [0.0, 6.3, 0.0]
    A_c = cauchy.call([ca.DM(x) for x in inputs_of(cauchy, given)])[0].full()
    assert np.all(np.isinf(A_c[:3, 18:21])) and np.all(np.isfinite(A_c[3:]))


def test_rates_differentiate():
    """The Jacobian of A_c x_c + g_c in x_c by automatic differentiation against central differences."""
    given, f = arguments("ella"), example("ella").casadi()["cauchy"]
    x = ca.MX.sym("x", len(given["x_c"]))
    A, g, *_ = f(x, *(given[k] for k in ("q", "tau", "w_ext", "p")))
    value = ca.Function("rate", [x], [A @ x + g])
    slope = ca.Function("slope", [x], [ca.jacobian(A @ x + g, x)])(given["x_c"]).full()
    h, x_c = 1e-4, given["x_c"]
    at = lambda y: flat(value(y))  # noqa: E731
    steps = h * np.eye(len(x_c))
    columns = [8 * (at(x_c + e) - at(x_c - e)) - (at(x_c + 2 * e) - at(x_c - 2 * e)) for e in steps]
    assert relative(np.array(columns).T / (12 * h), slope) <= 1e-6


# -------- the derivation and its documents


def test_relation_of_the_rates_is_the_derivative_of_the_twist():
    """d/dt of the block's V by the product rule is the block's Vdot, entry by entry; and back again."""
    block = common()["z_form"]
    vector = lambda name: Symbol(name, block.signal(name).shape, name)  # noqa: E731
    Zdot = block.values["Zdot"]
    rates = {"omega": "alpha", "rdot": "rddot", "r": "rdot"}
    values = block.values | {"alpha": Zdot[:3], "rddot": Zdot[3:]}
    symbols = {k: Symbol(v, (3, 1), v) for k, v in rates.items()}
    made = {s: e for step in block.steps.values() for s, e in step.assignments}
    rate_of = lambda name: components(rate(block.steps[name].expression, symbols), values)  # noqa: E731
    expected = rate_of("Z") + rate_of("gamma")
    Vdot = components(block.steps["Vdot"].expression, block.values)
    resolve = lambda e: sp.expand(sp.sympify(e).subs(made))  # noqa: E731
    assert all(resolve(a - b) == 0 for a, b in zip(expected.flat, Vdot.flat, strict=True))
    solution = components(block.steps["Zdot_solved"].expression, block.values | {"Vdot_solved": Vdot})
    assert all(resolve(a - b) == 0 for a, b in zip(solution.flat, Zdot.flat, strict=True))
    assert vector("V").shape == (6, 1)


@pytest.mark.parametrize("name", ["ella", "six_link", "strange"])
def test_documents_have_the_section(name):
    text = latex.document(document_robot(name))
    section = text.split(r"\section{The Z-form}")[1].split(r"\section{")[0]
    for formula in (
        r"\mathbf{J}(\boldsymbol{\theta}_i) & = \mathbf{I}_{3} - c_2\,\tilde{\boldsymbol{\theta}}_i",
        r"\kappa & = \tfrac{1}{4}\,c_{1}\left(y_i\right)^{-1}\,\left(c_{2}\left(y_i\right) - c_{3}",
        r"\dot{\boldsymbol{\theta}}_i & = \mathbf{J}(\boldsymbol{\theta}_i)^{-1}\,\boldsymbol{\omega}_i",
        r"\mathbf{T}_{\gamma_i} & = \begin{bmatrix} \mathbf{0} & \mathbf{0} \\ -\tilde{\mathbf{r}}_i & \mathbf{0}",
        r"\left(\mathbf{I}_{6} + \mathbf{T}_{\gamma_i}\right)\,\dot{\mathbf{Z}}_i + \boldsymbol{\gamma}_i^{*}",
        r"\mathbf{M}_{dyn} & = (\mathbf{M}_s + \mathbf{M}_{D\Psi})\,(\mathbf{I} + \mathbf{T}_{\gamma})",
        r"\mathbf{A}_c & = \begin{bmatrix}",
    ):
        assert formula in section, formula
    assert "The Z-form" in latex.html(document_robot(name)) and "Rows of the Z-form" in text


@pytest.mark.parametrize(("count", "modes"), [(1, None), (2, None), (3, {"bending_y": 1}), (9, {"bending_y": 1})])
def test_pattern_shows_the_robots_links_while_they_fit(count, modes):
    """A row for each joint, link and flexible link; long arms show the first two links; nothing is too wide."""
    model = model_of(arm(*(link(f"l{i}", 0.3, "y", modes=modes) for i in range(count))))
    section = latex.document(model.robot).split(r"\section{The Z-form}")[1]
    pattern = section.split(r"\mathbf{M}_{sys}^{Z} & = \begin{bmatrix}")[-1].split(r"\end{bmatrix}")[0]
    assert pattern.count(r"\\") + 1 == {1: 2, 2: 4, 3: 9, 9: 7}[count]
    assert ("ddots" in pattern) == ("in the same way" in section) == (count == 9)
    assert width(r"\begin{bmatrix}" + pattern + r"\end{bmatrix}") < PAGE
    sizes = {len(row.split("&")) for row in pattern.split(r"\\")}
    assert sizes == {{1: 2, 2: 4, 3: 9, 9: 7}[count]}
