"""The steps of a rotation's exponential: squared angle, Stumpff functions of it, squared skew matrix."""

from __future__ import annotations

from ..algebra.expression import Stumpff, Symbol, hat
from ..ir.block import Block


def angle_steps(
    b: Block, theta: Symbol, x: str, index: str, what: str
) -> tuple[Symbol, Symbol, Symbol, Symbol, Symbol]:
    """The steps ``x = theta . theta``, ``c1``, ``c2``, ``c3`` (the Stumpff functions at x) and ``theta_hat2``.

    ``x`` is the LaTeX of the squared angle, ``index`` the index of the rotation vector, ``what`` the rotated body.
    ``exp(hat(theta)) = I + c1 hat(theta) + c2 theta_hat2``; the left Jacobian is ``I + c2 hat(theta) + c3 theta_hat2``,
    the right one has ``-c2``.
    """
    squared = b.step("x", theta.T @ theta, x, unit="rad^2", meaning=f"squared angle of the {what}")
    c1, c2, c3 = (
        b.step(f"c{k}", Stumpff(k, squared), f"c_{k}", unit="-", meaning=f"Stumpff function of order {k}")
        for k in (1, 2, 3)
    )
    square = b.step(
        "theta_hat2",
        hat(theta) @ hat(theta),
        rf"\tilde{{\boldsymbol{{\theta}}}}_{index}^{{2}}",
        unit="rad^2",
        meaning="square of the rotation vector's skew matrix",
        symmetric=True,
    )
    return squared, c1, c2, c3, square
