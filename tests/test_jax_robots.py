"""The JAX back end on the example robots: against the compiled C in double and single precision, and CasADi."""

import pytest
from conftest import package, swept

jax = package("jax")

from jax_table import INPUTS, ROBOTS, STEP, by_c, named, row, state, worst  # noqa: E402

METHODS = ("modal_midpoint", "rk4")


@pytest.fixture(autouse=True)
def doubles():
    with jax.enable_x64(True):
        yield


def off(model) -> float:
    """The accelerations, the wrenches and two steps, in one compilation, beside the C."""
    f, x = model.jax(), state(model)

    def everything(x):
        vdot, wrench = f["forward_dynamics"](*(x[k] for k in INPUTS))
        ends = {name: f[f"step_{name}"](*(x[k] for k in STEP.split())) for name in METHODS}
        steps = {f"{name} {k}": y for name, pair in ends.items() for k, y in zip("qv", pair, strict=True)}
        return {"vdot": vdot, "wrench": wrench} | steps

    found = jax.jit(everything)(x)
    values, steps = by_c(model, x, methods=METHODS)
    return worst(found, {k: v for k, v in (values | steps).items() if k in found})


@pytest.mark.examples
@pytest.mark.parametrize("name", swept(ROBOTS, "crane", "ella_paper", "elastic_joint", "parallelogram", "space_arm"))
def test_every_example_is_that_of_the_c(name):
    assert off(named(name)) < 1e-12


@pytest.mark.long
@pytest.mark.parametrize("name", ROBOTS)
def test_rows_of_the_table(name):
    """Errors relative to the largest entry. In double: values and steps beside the C, gradients beside CasADi's.

    In single, values and steps beside the C in double: below 1e-4, or 1.5 times the C's own error in single where that
    is larger, then also below 3 times what rounding the mass matrix to single changes the accelerations by. Tracing and
    compiling the gradient of a motion takes less than a minute of CPU time.
    """
    found = row(name)
    assert max(found.values, found.steps, found.gradient, found.motion) < 1e-12
    for ours, theirs in ((found.values_single, found.values_c_single), (found.steps_single, found.steps_c_single)):
        assert ours < max(1e-4, min(1.5 * theirs, 3 * found.rounded))
    assert found.seconds < 60
