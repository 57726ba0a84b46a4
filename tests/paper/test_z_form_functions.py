"""The Z-form as users meet it: its CasADi functions, its derivation and its documents."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from conftest import swept
from helpers import arm, example, flat, link, model_of
from latex_documents import PLUGINS, WHOLE, page, tex

from screwgen.algebra.components import components
from screwgen.algebra.expression import Symbol
from screwgen.algebra.rate import rate
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.layout import PAGE, width
from screwgen.paper.z_form_blocks import z_form_block

NAMES = {
    "exponential": (["theta"], ["R", "J", "J_inverse"]),
    "cauchy_state": (["q", "v", "p"], ["x_c"]),
    "z_form": (["x_c", "q", "p"], ["T_gamma", "Gamma_star", "h_Ms", "M_dyn", "h_dyn"]),
    "assemble_z": (["x_c", "q", "tau", "w_ext", "p"], ["M_sys", "H_sys", "W_sys"]),
    "cauchy": (["x_c", "q", "tau", "w_ext", "p"], ["A_c", "g_c", "qdot", "wrench"]),
}


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


def test_a_full_turn_is_not_passed_in_silence():
    """A_c is infinite where a link's exponential coordinates have ended, and there alone."""
    model, q = example("ella"), np.array([0.3, -0.2, 0.5, *[1e-3] * 6])
    x_c = flat(model.casadi()["cauchy_state"](q, np.full(9, 0.1), model.parameter_values))
    x_c[:3] = [0.0, 6.3, 0.0]
    A_c = model.casadi()["cauchy"](x_c, q[:3], np.ones(3), np.ones((6, 2)), model.parameter_values)[0].full()
    assert np.all(np.isinf(A_c[:3, 18:21])) and np.all(np.isfinite(A_c[3:]))


# -------- the derivation and its documents


def test_relation_of_the_rates_is_the_derivative_of_the_twist():
    """d/dt of the block's V by the product rule is the block's Vdot, entry by entry; and back again."""
    block = z_form_block()
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


@pytest.mark.parametrize("name", swept(["ella", "six_link", "strange"], "ella"))
def test_documents_have_the_section(name):
    text = tex(name)
    section = text.split(r"\section{The Z-form}")[1].split(r"\section{")[0].replace(" & = ", " = ")
    for formula in (
        r"\mathbf{J}(\boldsymbol{\theta}_i) = \mathbf{I}_{3} - \mathrm{c}_2\,\tilde{\boldsymbol{\theta}}_i",
        r"\kappa = \tfrac{1}{4}\,\mathrm{c}_{1}\left(y_i\right)^{-1}\,\left(\mathrm{c}_{2}\left(y_i\right) -",
        r"\dot{\boldsymbol{\theta}}_i = \mathbf{J}(\boldsymbol{\theta}_i)^{-1}\,\boldsymbol{\omega}_i",
        r"\mathbf{T}_{\gamma_i} = \begin{bmatrix} \mathbf{0} & \mathbf{0} \\ -\tilde{\mathbf{r}}_i & \mathbf{0}",
        r"\left(\mathbf{I}_{6} + \mathbf{T}_{\gamma_i}\right)\,\dot{\mathbf{Z}}_i + \boldsymbol{\gamma}_i^{*}",
        r"\mathbf{M}_{dyn} = (\mathbf{M}_s + \mathbf{M}_{D\Psi})\,(\mathbf{I} + \mathbf{T}_{\gamma})",
        r"\mathbf{A}_c = \begin{bmatrix}",
    ):
        assert formula in section, formula
    assert "The Z-form" in page(name) and "Rows of the Z-form" in text


@pytest.mark.parametrize(("count", "modes"), [(1, None), (2, None), (3, {"bending_y": 1}), (9, {"bending_y": 1})])
def test_pattern_shows_the_robots_links_while_they_fit(count, modes):
    """A row for each joint, link and flexible link; long arms show the first two links; nothing is too wide."""
    model = model_of(arm(*(link(f"l{i}", 0.3, "y", modes=modes) for i in range(count))))
    section = latex.document(model.robot, PLUGINS, WHOLE).split(r"\section{The Z-form}")[1].replace(" & = ", " = ")
    pattern = section.split(r"\mathbf{M}_{sys}^{Z} = \begin{bmatrix}")[-1].split(r"\end{bmatrix}")[0]
    assert pattern.count(r"\\") + 1 == {1: 2, 2: 4, 3: 9, 9: 7}[count]
    assert ("ddots" in pattern) == ("in the same way" in section) == (count == 9)
    assert width(r"\begin{bmatrix}" + pattern + r"\end{bmatrix}") < PAGE
    sizes = {len(row.split("&")) for row in pattern.split(r"\\")}
    assert sizes == {{1: 2, 2: 4, 3: 9, 9: 7}[count]}
