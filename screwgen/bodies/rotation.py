"""The steps of a rotation's exponential: squared angle, Stumpff functions of it, squared skew matrix; and its rates."""

from __future__ import annotations

from collections.abc import Sequence

from ..algebra.expression import Expression, Stumpff, Symbol, hat
from ..algebra.rate import rate
from ..ir.block import Block


def angle_steps(
    b: Block, theta: Symbol, x: str, square: str, what: str, orders: Sequence[int] = (1, 2, 3)
) -> tuple[Symbol, ...]:
    """The steps ``x = theta . theta``, ``c1``, ``c2``, ``c3`` (the Stumpff functions at x) and ``theta_hat2``.

    Of the Stumpff functions those of some ``orders``. ``x`` and ``square`` are the LaTeX of the squared angle and the
    squared skew matrix, ``what`` is the rotated body.
    ``exp(hat(theta)) = I + c1 hat(theta) + c2 theta_hat2``; the left Jacobian is ``I + c2 hat(theta) + c3 theta_hat2``,
    the right one has ``-c2``.
    """
    squared = b.step("x", theta.T @ theta, x, unit="rad^2", meaning=f"squared angle of the {what}")
    stumpff = [
        b.step(f"c{k}", Stumpff(k, squared), rf"\mathrm{{c}}_{k}", unit="-", meaning=f"Stumpff function of order {k}")
        for k in orders
    ]
    squared_hat = b.step(
        "theta_hat2",
        hat(theta) @ hat(theta),
        square,
        unit="rad^2",
        meaning="square of the rotation vector's skew matrix",
        symmetric=True,
    )
    return squared, *stumpff, squared_hat


def turning(b: Block, theta: Symbol, thetadot: Expression) -> Expression:
    """The angular velocity ``J_l thetadot`` of ``exp(hat(theta))``, after :func:`angle_steps`."""
    c2, c3 = b.symbol("c2"), b.symbol("c3")
    return thetadot + c2 @ (hat(theta) @ thetadot) + c3 @ (hat(theta) @ (hat(theta) @ thetadot))


def rate_of_turning(b: Block, theta: Symbol, thetadot: Symbol, turned: Expression) -> Expression:
    """The rate of ``J_l thetadot``, which is ``turned``, while ``thetadot`` is constant; its own steps before it."""
    xdot = b.step("xdot", 2 * (theta.T @ thetadot))
    slopes: dict[str, Expression] = {f"c{k}": _step_rate(b, f"c{k}", {"x": xdot}) for k in (2, 3)}
    return rate(turned, {theta.name: thetadot, **slopes})


def _step_rate(b: Block, name: str, rates: dict) -> Symbol:
    """The time derivative of an earlier step, as a step of its own."""
    step = b.steps[name]
    return b.step(
        f"{name}dot",
        rate(step.expression, rates),
        rf"\dot{{{step.signal.display}}}",
        unit="1/s",
        meaning=f"rate of {name}",
    )
