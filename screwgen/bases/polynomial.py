"""`polynomial`: the Ritz modes of the clamped beam in span{s^2, ..., s^(r+1)}, of the clamped rod in span{s, ..., s^r}.

They are exact for static forces and moments at the tip, in bending from two modes on, in stretching and torsion from
one: no sum of clamped-free modes is, since those carry no load there. So they converge far faster in a link that
carries something.
"""

from __future__ import annotations

from math import comb

from ..lazily import mpmath
from .closed_form import ClosedForm, inner, polynomial_form
from .shapes import Family, Shapes, latex_number, tabulate, working_digits

BEAM = Family(
    name="polynomial",
    title="polynomial Ritz modes",
    formula=r"\psi_k(s) = \sum_{j=0}^{r-1} Q_{jk}\,\sqrt{2j+5}\,s^2 P_j^{(0,4)}(2s-1),\quad Q^{\top}Q = I",
    condition=r"\int_0^1 \psi_k''\,\psi_l''\,ds = \bar{\lambda}_k\,\delta_{kl}",
    order=2,
    changes=True,
    about=r"with the Jacobi polynomials $P_j^{(0,4)}$, the orthogonal matrix $Q$ that fulfils the last condition, the "
    r"eigenvalues $\bar{\lambda}_k$ in ascending order, and $\psi_k(1) > 0$; $r$ is the number of shapes",
)

ROD = Family(
    name="polynomial rod",
    title="polynomial Ritz modes of a rod",
    formula=r"\psi_k(s) = \sum_{j=0}^{r-1} Q_{jk}\,\sqrt{2j+3}\,s\,P_j^{(0,2)}(2s-1),\quad Q^{\top}Q = I",
    condition=r"\int_0^1 \psi_k'\,\psi_l'\,ds = \bar{\lambda}_k\,\delta_{kl}",
    order=1,
    changes=True,
    about=r"with the Jacobi polynomials $P_j^{(0,2)}$, the orthogonal matrix $Q$ that fulfils the last condition, the "
    r"eigenvalues $\bar{\lambda}_k$ in ascending order, and $\psi_k(1) > 0$; $r$ is the number of shapes",
)


def polynomial(count: int, order: int = 2) -> Shapes:
    """The `count` Ritz modes, ascending in stiffness, psi_k(1) > 0; all of them change with `count`.

    `order`: 2 for bending, 1 for stretching and torsion.
    """
    with mpmath.workdps(working_digits(count)):
        jacobi = [_jacobi(n, order) for n in range(count)]
        stiffness, vectors = _ritz(jacobi, order) if jacobi else ([], [])
        modes = [_combination(vector, jacobi) for vector in vectors]
        return tabulate(BEAM if order == 2 else ROD, modes, stiffness, [polynomial_latex(mode) for mode in modes])


def _jacobi(n: int, order: int) -> ClosedForm:
    """sqrt(2n + 2m + 1) s^m P_n^(0,2m)(2s - 1), m the order: orthonormal on [0, 1], with integer coefficients."""
    jacobi = [(-1) ** (n - j) * comb(n, j) * comb(n + 2 * order + j, n) for j in range(n + 1)]
    return polynomial_form([mpmath.mpf(0)] * order + [mpmath.mpf(c) for c in jacobi]).scaled(
        mpmath.sqrt(2 * n + 2 * order + 1)
    )


def _ritz(forms: list[ClosedForm], order: int) -> tuple[list[mpmath.mpf], list[list[mpmath.mpf]]]:
    """Eigenvalues (ascending) and orthonormal eigenvectors of the stiffness matrix of `forms`."""
    strains = [form.derivative(order) for form in forms]
    size = range(len(forms))
    stiffness = mpmath.matrix(len(forms))
    for k in size:
        for l in range(k + 1):
            stiffness[k, l] = stiffness[l, k] = inner(strains[k], strains[l])
    eigenvalues, vectors = mpmath.eigsy(stiffness)
    return list(eigenvalues), [[vectors[j, k] for j in size] for k in size]


def _combination(vector: list[mpmath.mpf], forms: list[ClosedForm]) -> ClosedForm:
    """sum_j vector_j form_j, its sign chosen so that the tip value is positive."""
    mode = polynomial_form([])
    for factor, form in zip(vector, forms, strict=True):
        mode += form.scaled(factor)
    return mode if mode(1) > 0 else mode.scaled(mpmath.mpf(-1))


def polynomial_latex(mode: ClosedForm, digits: int = 7) -> str:
    """The LaTeX of a polynomial that vanishes at 0, its coefficients with so many digits."""
    (coefficients,) = mode.terms.values()
    terms = (
        f"{latex_number(mpmath.mpf(float(c)), digits)}\\,s" + (f"^{{{n}}}" if n > 1 else "")
        for n, c in enumerate(coefficients)
        if c
    )
    return " + ".join(terms).replace("+ -", "- ")
