"""Scalar functions that sympy lacks."""

from __future__ import annotations

from typing import Any

from ..lazily import sp


class stumpff(sp.Function):
    """The Stumpff function ``c_k(x) = sum_j (-x)^j / (k + 2 j)!`` (dimensionless, ``k >= 0``).

    ``exp(hat(theta)) = I + c_1 hat(theta) + c_2 hat(theta)^2`` and the left Jacobian is
    ``J_l = I + c_2 hat(theta) + c_3 hat(theta)^2``, both at ``x = theta . theta``.  The family is
    closed under differentiation, ``c_k' = (k c_{k+2} - c_{k+1}) / 2``, and regular at ``x = 0``.
    """

    @classmethod
    def eval(cls, k: sp.Expr, x: sp.Expr) -> sp.Expr | None:
        if x.is_zero:
            return 1 / sp.factorial(k)
        return None

    def fdiff(self, argindex: int = 2) -> sp.Expr:
        k, x = self.args
        if argindex != 2:
            raise sp.ArgumentIndexError(self, argindex)
        return (k * stumpff(k + 2, x) - stumpff(k + 1, x)) / 2

    def _latex(self, printer: Any, exp: str | None = None) -> str:
        k, x = (printer._print(a) for a in self.args)
        return rf"c_{{{k}}}\left({x}\right)" + (rf"^{{{exp}}}" if exp else "")
