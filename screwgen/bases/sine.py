"""`sine`: the clamped-free modes of a uniform rod, the axial and torsion modes of the basis `clamped_free`."""

from __future__ import annotations

from ..lazily import mpmath
from .closed_form import ClosedForm
from .shapes import Family, Shapes, tabulate, working_digits

FAMILY = Family(
    name="sine",
    title="clamped-free rod modes",
    formula=r"\psi_k(s) = \sqrt{2}\,\sin\bar{\lambda}_k s",
    condition=r"\bar{\lambda}_k = (2k-1)\,\frac{\pi}{2}",
    order=1,
    about=r"with the numbers $\bar{\lambda}_k$",
)


def sine(count: int) -> Shapes:
    """The first `count` modes; psi_k(1) = sqrt 2 times 1, -1, 1, ..., stiffness lambda_k^2."""
    odd = range(1, 2 * count, 2)
    with mpmath.workdps(working_digits(count)):
        frequencies = [n * mpmath.pi / 2 for n in odd]
        modes = [_mode(frequency) for frequency in frequencies]
        return tabulate(FAMILY, modes, frequencies, [_latex(n) for n in odd])


def _mode(frequency: mpmath.mpf) -> ClosedForm:
    """sqrt 2 sin(frequency s)."""
    half = mpmath.mpc(0, mpmath.sqrt(2) / 2)
    return ClosedForm({mpmath.mpc(0, frequency): [-half], mpmath.mpc(0, -frequency): [half]})


def _latex(n: int) -> str:
    return rf"\sqrt{{2}}\,\sin\tfrac{{{n if n > 1 else ''}\pi}}{{2}}s"
