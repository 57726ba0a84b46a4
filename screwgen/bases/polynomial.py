"""`polynomial`: the Ritz modes of the clamped beam in span{s^2, ..., s^(r+1)}.

Two modes and more are exact for static forces and moments at the tip, which no sum of clamped-free modes is:
those carry neither shear nor bending moment there. So the polynomials converge far faster under a payload.
"""

from __future__ import annotations

from math import comb

import mpmath
from mpmath import mpf

from screwgen.bases.functions import ClosedForm, inner, polynomial_form
from screwgen.bases.shapes import Family, Shapes, latex_number, tabulate, working_digits

FAMILY = Family(
    name="polynomial",
    title="polynomial Ritz modes",
    formula=r"\psi_k(s) = \sum_{j=0}^{r-1} Q_{jk}\,\sqrt{2j+5}\,s^2 P_j^{(0,4)}(2s-1),\quad Q^{\top}Q = I",
    condition=r"\int_0^1 \psi_k''\,\psi_l''\,ds = \Lambda_k\,\delta_{kl}",
    eigenvalue_symbol=r"\Lambda_k",
    order=2,
)


def polynomial(count: int) -> Shapes:
    """The `count` Ritz modes, ascending in stiffness, psi_k(1) > 0; all of them change with `count`."""
    with mpmath.workdps(working_digits(count)):
        jacobi = [_jacobi(n) for n in range(count)]
        stiffness, vectors = _ritz(jacobi) if jacobi else ([], [])
        modes = [_combination(vector, jacobi) for vector in vectors]
        return tabulate(FAMILY, modes, stiffness, [_latex(mode) for mode in modes])


def _jacobi(n: int) -> ClosedForm:
    """sqrt(2n + 5) s^2 P_n^(0,4)(2s - 1): orthonormal on [0, 1]; the Jacobi coefficients are integers."""
    jacobi = [(-1) ** (n - j) * comb(n, j) * comb(n + 4 + j, n) for j in range(n + 1)]
    return polynomial_form([mpf(0), mpf(0), *map(mpf, jacobi)]).scaled(mpmath.sqrt(2 * n + 5))


def _ritz(forms: list[ClosedForm]) -> tuple[list[mpf], list[list[mpf]]]:
    """Eigenvalues (ascending) and orthonormal eigenvectors of the stiffness matrix of `forms`."""
    curvatures = [form.derivative(2) for form in forms]
    size = range(len(forms))
    stiffness = mpmath.matrix(len(forms))
    for k in size:
        for l in range(k + 1):
            stiffness[k, l] = stiffness[l, k] = inner(curvatures[k], curvatures[l])
    eigenvalues, vectors = mpmath.eigsy(stiffness)
    return list(eigenvalues), [[vectors[j, k] for j in size] for k in size]


def _combination(vector: list[mpf], forms: list[ClosedForm]) -> ClosedForm:
    """sum_j vector_j form_j, its sign chosen so that the tip value is positive."""
    mode = polynomial_form([])
    for factor, form in zip(vector, forms, strict=True):
        mode += form.scaled(factor)
    return mode if mode(1) > 0 else mode.scaled(mpf(-1))


def _latex(mode: ClosedForm) -> str:
    (coefficients,) = mode.terms.values()
    terms = (f"{latex_number(c)}\\,s^{{{n}}}" for n, c in enumerate(coefficients) if c)
    return " + ".join(terms).replace("+ -", "- ")
