"""`clamped_free`: the vibration modes of a uniform clamped-free beam, in bending and as a rod.

They carry neither force nor moment at the tip, so they converge slowly where a link carries another one, a body or
a load. The paper uses them, and measured frequencies belong to them.
"""

from __future__ import annotations

from ..lazily import mpmath
from .closed_form import ClosedForm
from .shapes import Family, Shapes, latex_number, tabulate, working_digits
from .sine import sine

FAMILY = Family(
    name="clamped_free",
    title="clamped-free beam modes",
    formula=r"\psi_k(s) = \cosh\bar{\lambda}_k s - \cos\bar{\lambda}_k s"
    r" - \sigma_k(\sinh\bar{\lambda}_k s - \sin\bar{\lambda}_k s),\quad "
    r"\sigma_k = \frac{\sinh\bar{\lambda}_k - \sin\bar{\lambda}_k}{\cosh\bar{\lambda}_k + \cos\bar{\lambda}_k}",
    condition=r"\cos\bar{\lambda}_k\cosh\bar{\lambda}_k = -1",
    order=2,
    about=r"with the roots $\bar{\lambda}_k$ of the last equation in ascending order; $\psi_k(1)$ is 2, $-2$, 2 …",
)


def clamped_free(count: int, order: int = 2) -> Shapes:
    """The first `count` modes: of a beam (order 2; psi_k(1) = 2, -2, 2, ..., stiffness lambda_k^4) or of a rod (1)."""
    if order == 1:
        return sine(count)
    with mpmath.workdps(working_digits(count)):
        roots = [_root(k) for k in range(1, count + 1)]
        return tabulate(FAMILY, [_mode(root) for root in roots], roots, [_latex(root) for root in roots])


def _root(k: int) -> mpmath.mpf:
    """The k-th root of cos x + 1 / cosh x = 0, by Newton's method from (2k - 1) pi / 2."""
    x = (2 * k - 1) * mpmath.pi / 2
    for _ in range(mpmath.mp.prec.bit_length() + 2):  # correct bits double with every iteration
        x += (mpmath.cos(x) + mpmath.sech(x)) / (mpmath.sin(x) + mpmath.sech(x) * mpmath.tanh(x))
    return x


def _growth(root: mpmath.mpf) -> mpmath.mpf:
    """1 - sigma, in a form without cancellation: it is as small as 2 exp(-lambda)."""
    cos, sin = mpmath.cos_sin(root)
    return (cos + sin + mpmath.exp(-root)) / (mpmath.cosh(root) + cos)


def _mode(root: mpmath.mpf) -> ClosedForm:
    """psi_k in exponentials: all terms stay of order one on [0, 1], so nothing cancels for large lambda."""
    growth = _growth(root)
    swing = mpmath.mpc(-1, growth - 1) / 2
    return ClosedForm(
        {
            root: [growth / 2],
            -root: [1 - growth / 2],
            mpmath.mpc(0, root): [swing],
            mpmath.mpc(0, -root): [mpmath.conj(swing)],
        }
    )


def _latex(root: mpmath.mpf) -> str:
    x = latex_number(root) + r"\,s"
    sigma = latex_number(1 - _growth(root))
    return rf"\cosh {x} - \cos {x} - {sigma}\,(\sinh {x} - \sin {x})"
