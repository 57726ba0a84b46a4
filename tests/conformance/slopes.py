"""Checks of derivatives: exact ones against differences of the functions that they belong to."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import mpmath
import numpy as np

from conformance.cases import DIFFERENCE, STEP, Case
from conformance.numbers import near
from conformance.uses import closed
from screwgen.algorithms import fused
from screwgen.algorithms.functions import Functions
from screwgen.backends.numpy.closing import closed as shut
from screwgen.backends.numpy.closing import jacobian
from screwgen.integrators import METHODS
from screwgen.ir.replay import run

OUTPUTS = ("tip_position", "tip_velocity", "tip_acceleration", "wrenches", "base_strain")


def smooth(case: Case) -> float:
    """What differences leave, relative to the largest entry: their error, and rounding over the step."""
    return 3e-7 + case.tolerance / DIFFERENCE


def accelerations_by_c(case: Case) -> Callable[..., np.ndarray]:
    """The accelerations by C, which in the state are NumPy's: differences need thousands, over which NumPy is slow."""
    c = case.c(derivatives=True)
    near(c.accelerations(*case.given), case.model.numpy().forward_dynamics(*case.given)[0], case.solved, "C's")
    return c.accelerations


def dynamics(case: Case) -> None:
    """Accelerations with q, v and tau, in NumPy and in C."""
    w_ext, f, accelerations = case.given[3], case.model.numpy(), accelerations_by_c(case)
    expected = case.differences(lambda q, v, tau: accelerations(q, v, tau, w_ext))
    for c in case.differentiated:
        _, *compiled = c.linearise(*case.given)
        for found, wanted, exact, by in zip(compiled, expected, f.derivatives(*case.given), "qvu", strict=True):
            near(found, wanted, smooth(case), f"accelerations with {by}")
            near(exact, found, case.tolerance, f"NumPy's beside C's, with {by}")


def wrenches(case: Case) -> None:
    """Joint wrenches with q, v and tau, in C."""
    w_ext, first = case.given[3], case.c(derivatives=True)
    expected = case.differences(lambda q, v, tau: first.forward_dynamics(q, v, tau, w_ext)[1])
    for c in case.differentiated:
        _, *compiled = c.linearise_wrenches(*case.given)
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

        by_q, by_v, by_tau = case.differences(moved, 3e-3)
        # beside what inputs within their limits do: beyond these rounding may be all that is left
        within = c.step_derivatives(q, v, case.acting, w_ext, STEP, method)[-1]
        for found, wanted, most in ((A[:, :nv], by_q, by_q), (A[:, nv:], by_v, by_v), (B, by_tau, within)):
            for half in (slice(None, nv), slice(nv, None)):
                size = np.abs(most[half]).max(initial=0.0)
                pair = (np.append(x[half], size) for x in (found, wanted))
                near(*pair, smooth(case), f"a step of {method}")


def exact_dynamics(case: Case, p: list) -> np.ndarray:
    """Accelerations and joint wrenches at parameters with 50 digits."""
    chain, given = case.model.chain, [[mpmath.mpf(float(x)) for x in np.ravel(x)] for x in case.given]
    links = fused.prepared(chain, p, lambda _, program, values: run(program, values, fused.precise)[0])
    apply = lambda _, __, program, values: run(program, values, fused.precise, mpmath.mpf(10) ** -45)[0]  # noqa: E731
    vdot, wrench = Functions(chain, links, fused.world(chain, p), apply).forward_dynamics(*given)
    return np.array([*vdot, *wrench])


def by_parameters(case: Case) -> None:
    """Accelerations and wrenches with a parameter at random; a step with it, alike in all back ends."""
    model, f, (q, v, tau, w_ext) = case.model, case.model.numpy(), case.given
    k = int(np.random.default_rng(case.seed).choice(len(model.parameter_names)))
    name, number = model.parameter_names[k], model.parameter_values[k]
    found, whole = f.forward_dynamics_by_p(*case.given, of=name), f.forward_dynamics(*case.given)
    with mpmath.workdps(50):
        h = mpmath.mpf(10) ** -15 * (abs(number) or 1)
        ends = ([mpmath.mpf(x) + (j == k) * way * h for j, x in enumerate(model.parameter_values)] for way in (1, -1))
        up, down = (exact_dynamics(case, p) for p in ends)
        expected = np.split(((up - down) / (2 * h)).astype(float), [model.chain.nvz])
    least = [_least(values, number) for values in whole]
    for x, wanted, size in zip(found, expected, least, strict=True):
        error = np.abs(np.ravel(x) - wanted).max(initial=0.0)
        assert error <= 1e-9 * max(np.abs(wanted).max(initial=0.0), size), f"{name}: {error}"
    c, functions, after = case.c(by_p=(name,)), model.casadi(by_p=name), f.step_by_p(*case.given, STEP, of=name)
    stated = q, v, tau, w_ext.T, model.parameter_values
    stepped = [_least(values, number) for values in (q, v)]
    pairs = [*zip(c.forward_dynamics_by_p(*case.given), found, least, strict=True)]
    pairs += [(functions["forward_dynamics_by_p"](*stated)[0], found[0], least[0])]
    pairs += [*zip(c.step_by_p(*case.given, STEP), after, stepped, strict=True)]
    pairs += [*zip(functions["step_by_p"](*stated, STEP), after, stepped, strict=True)]
    for one, other, size in pairs:
        near(one, other, case.tolerance, f"by {name}", size)


def _least(values: np.ndarray, number: float) -> float:
    """The size of a slope by a number that hardly matters: one that changes nothing leaves the rounding of others."""
    return 1e-4 * np.abs(values).max(initial=0.0) / max(abs(number), 1e-3)


def kinematic(case: Case, q: np.ndarray, v: np.ndarray, h: float = 1e-4) -> np.ndarray:
    """(nv, 2 nv): the rates of small changes of coordinates, with these and with changes of rates, by differences."""
    v = v[: case.model.nv]

    def after(x, t):
        there = case.moved(case.moved(q, x[: len(v)]), t * (v + x[len(v) :]))
        return case.change(case.moved(q, t * v), there)

    rate = lambda x: (after(x, h) - after(x, -h)) / (2 * h)  # noqa: E731
    return np.array([(rate(h * e) - rate(-h * e)) / (2 * h) for e in np.eye(2 * len(v))]).T


def linear(case: Case) -> None:
    """The linear model, whose lower rows are the accelerations' slopes, with all inputs named, and its outputs."""
    q, v, tau, w_ext = case.given
    nv, model = case.model.nv, case.model
    q, v = closed(case)
    linear = model.linearise(q, v, tau, w_ext, outputs=OUTPUTS, inputs=("torques", "wrenches_on_tips"))
    _, by_q, by_v, by_tau = case.c(derivatives=True).linearise(q, v, tau, w_ext)
    A, B = np.asarray(linear.A), np.asarray(linear.B)
    assert list(linear.input_names[: len(tau)]) == model.tau_names
    if model.chain.closing.rows:
        return independent(case, linear, q, v)
    near(A[:nv, : 2 * nv], kinematic(case, q, v), 1e-7, "rates of changes")
    near(A[nv:, :nv], by_q, case.tolerance, "A by coordinates")
    near(A[nv:, nv:], by_v, case.tolerance, "A by rates")
    near(B[nv:, : len(tau)], by_tau, case.tolerance, "B")
    outputs(case, linear, q, v)


def outputs(case: Case, linear, q: np.ndarray, v: np.ndarray) -> None:
    """Places, velocities and accelerations of the tip are each the next one's integral; C and D along a direction."""
    (_, _, tau, w_ext), model, f, nv = case.given, case.model, case.model.numpy(), case.model.nv
    vdot, y, along = f.forward_dynamics(q, v, tau, w_ext)[0], linear.y, linear.C[:6] @ np.append(v[:nv], linear.vdot)
    near(y[:3], f.tip_pose(q)[1], case.agreement, "place of the tip")
    near(along[:3], y[3:6], case.agreement, "velocity of the tip")
    near(along[3:], y[6:9], case.tolerance, "acceleration of the tip")
    rng = np.random.default_rng(6)
    push = rng.normal(size=w_ext.shape)
    sizes = np.concatenate([case.sizes, case.sizes, np.full(len(v) - nv, 0.05)])
    x, u = rng.normal(size=len(sizes)) * sizes, rng.normal(size=len(tau))
    pushed = f.forward_dynamics(q, v, tau, w_ext + push)[0] - vdot
    near(linear.B[nv:, len(tau) :] @ push.ravel(), pushed, 10 * case.tolerance, "B by wrenches")

    def at(t: float) -> np.ndarray:
        there = case.moved(q, t * x[:nv]), v + t * x[nv:], tau + t * u, w_ext + t * push
        return model.linearise(*there, outputs=OUTPUTS).y

    steps = [(at(t) - at(-t)) / (2 * t) for t in (DIFFERENCE, DIFFERENCE / 2, DIFFERENCE / 4)]
    once = [(4 * fine - coarse) / 3 for coarse, fine in itertools.pairwise(steps)]
    expected, found = (16 * once[1] - once[0]) / 15, linear.C @ x + linear.D @ np.append(u, push)
    for unit in set(linear.output_units):
        own = [k for k, name in enumerate(linear.output_units) if name == unit]
        near(found[own], expected[own], 3 * smooth(case), f"outputs in {unit}")


def independent(case: Case, linear, q: np.ndarray, v: np.ndarray, h: float = 1e-5) -> None:
    """The slopes of independent accelerations by differences along motions that keep the loops closed.

    Near a posture where a loop is singular these bend sharply, and end: there the differences are shorter; of three
    extrapolations the last of the two that differ least counts.
    """
    (_, _, tau, w_ext), model, f, found = case.given, case.model, case.model.numpy(), accelerations_by_c(case)
    internal = model.v_names[model.nv :]
    half = (len(linear.A) - len(internal)) // 2
    own = [model.v_names.index(name) for name in linear.state_names[half : 2 * half]]
    assert list(linear.state_names[2 * half :]) == internal
    others = np.setdiff1d(np.arange(model.nv), own)
    held = np.isin(np.arange(model.nq), [k for k in range(model.nq) if k - model.nq + model.nv in own])
    h *= min(1.0, 10 * np.linalg.svd(jacobian(f, q)[:, others], compute_uv=False)[-1]) if len(others) else 1.0

    def accelerations(x: np.ndarray) -> np.ndarray:
        """Where these changes of independent coordinates and rates lead; the others follow."""
        change, rates = np.zeros((2, model.nv))
        change[own] = x[:half]
        there = shut(f, case.moved(q, change), held)
        J = jacobian(f, there)
        rates[own] = v[own] + x[half : 2 * half]
        rates[others] = -np.linalg.lstsq(J[:, others], J[:, own] @ rates[own])[0]
        whole = np.append(rates, v[model.nv :] + x[2 * half :])
        return found(there, whole, tau, w_ext)[[*own, *range(model.nv, len(v))]]

    steps = [
        np.array([(accelerations(t * e) - accelerations(-t * e)) / (2 * t) for e in np.eye(len(linear.A))]).T
        for t in (h, h / 4, h / 16, h / 64)
    ]
    once = [(16 * fine - coarse) / 15 for coarse, fine in itertools.pairwise(steps)]
    settled = min(itertools.pairwise(once), key=lambda pair: np.abs(pair[1] - pair[0]).max())[1]
    near(linear.A[half:], settled, max(1e-6, case.tolerance / h), "A")
