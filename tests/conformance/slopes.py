"""Checks of derivatives: exact ones against differences of the functions that they belong to."""

from __future__ import annotations

import numpy as np

from conformance.cases import DIFFERENCE, STEP, Case
from conformance.numbers import near
from conformance.uses import closed
from screwgen.integrators import METHODS


def smooth(case: Case) -> float:
    """What differences leave, relative to the largest entry: their error, and rounding over the step."""
    return 3e-7 + case.tolerance / DIFFERENCE


def dynamics(case: Case) -> None:
    """Accelerations with q, v and tau, in NumPy and in C."""
    w_ext, f = case.given[3], case.model.numpy()
    expected = case.differences(lambda q, v, tau: f.forward_dynamics(q, v, tau, w_ext)[0])
    _, *compiled = case.c(derivatives=True).linearise(*case.given)
    for found, wanted, exact, by in zip(compiled, expected, f.derivatives(*case.given), "qvu", strict=True):
        near(found, wanted, smooth(case), f"accelerations with {by}")
        near(exact, found, case.tolerance, f"NumPy's beside C's, with {by}")


def wrenches(case: Case) -> None:
    """Joint wrenches with q, v and tau, in C."""
    w_ext, c = case.given[3], case.c(derivatives=True)
    _, *compiled = c.linearise_wrenches(*case.given)
    expected = case.differences(lambda q, v, tau: c.forward_dynamics(q, v, tau, w_ext)[1])
    for found, wanted, by in zip(compiled, expected, "qvu", strict=True):
        near(np.reshape(found, wanted.shape), wanted, smooth(case), f"wrenches with {by}")


def steps(case: Case) -> None:
    """The state after a step of every method, with that before and the inputs, in C."""
    (q, v, tau, w_ext), c, nv = case.given, case.c(derivatives=True), case.model.nv
    for method in METHODS:
        after, rates, A, B = c.step_derivatives(q, v, tau, w_ext, STEP, method)
        there = c.step(q, v, tau, w_ext, STEP, method)
        near(np.concatenate([after, rates]), np.concatenate(there), case.agreement, method)

        def moved(q, v, tau, method=method, after=after):
            there, rates = c.step(q, v, tau, w_ext, STEP, method)
            return np.concatenate([case.change(after, there), rates])

        by_q, by_v, by_tau = case.differences(moved)
        for found, wanted in ((A[:, :nv], by_q), (A[:, nv:], by_v), (B, by_tau)):
            for half in (slice(None, nv), slice(nv, None)):
                near(found[half], wanted[half], smooth(case), f"a step of {method}")


def kinematic(case: Case, q: np.ndarray, v: np.ndarray, h: float = 1e-4) -> np.ndarray:
    """(nv, 2 nv): the rates of small changes of coordinates, with these and with changes of rates, by differences."""

    def after(x, t):
        there = case.moved(case.moved(q, x[: len(v)]), t * (v + x[len(v) :]))
        return case.change(case.moved(q, t * v), there)

    rate = lambda x: (after(x, h) - after(x, -h)) / (2 * h)  # noqa: E731
    return np.array([(rate(h * e) - rate(-h * e)) / (2 * h) for e in np.eye(2 * len(v))]).T


def linear(case: Case) -> None:
    """The linear model, whose lower rows are the accelerations' slopes, with all inputs named."""
    q, v, tau, w_ext = case.given
    nv, model = case.model.nv, case.model
    q, v = closed(case)
    linear = model.linearise(q, v, tau, w_ext)
    _, by_q, by_v, by_tau = case.c(derivatives=True).linearise(q, v, tau, w_ext)
    if model.chain.closing.rows:
        assert len(linear.A) < 2 * nv
        return
    A, B = np.asarray(linear.A), np.asarray(linear.B)
    near(A[:nv], kinematic(case, q, v), 1e-7, "rates of changes")
    near(A[nv:, :nv], by_q, case.tolerance, "A by coordinates")
    near(A[nv:, nv:], by_v, case.tolerance, "A by rates")
    near(B[nv:, : len(tau)], by_tau, case.tolerance, "B")
    assert list(linear.input_names[: len(tau)]) == model.tau_names
