"""The JAX back end on the example robots: against the compiled C in double and single precision, and CasADi."""

import sys

import pytest
from conftest import package, swept
from helpers import ROOT, example_file

jax = package("jax")
sys.path.insert(0, str(ROOT / "bench"))

from jax_scenarios import measured  # noqa: E402
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


@pytest.mark.examples
def test_the_bench_times_equal_motions():
    *rates, apart = measured(example_file("flexible_arm"), scenarios=3, steps=4, rounds=1)
    assert min(rates) > 0 and apart < 1e-12


@pytest.mark.long
@pytest.mark.parametrize("name", ROBOTS)
def test_rows_of_the_table(name):
    """Errors relative to the largest entry: of values and steps beside the C of the same precision, of gradients beside
    CasADi's. Tracing and compiling the gradient of a motion takes less than a minute of CPU time.
    """
    found = row(name)
    assert max(found.values, found.steps, found.gradient, found.motion) < 1e-12
    assert max(found.values_single, found.steps_single) < 1e-4
    assert found.seconds < 60
