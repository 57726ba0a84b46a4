"""The JAX back end: precisions, second gradients, batches, refusals, examples; its functions: `conformance/`."""

import sys

import numpy as np
import pytest
from conftest import package
from helpers import EPS, ROOT, example, example_file, model_of

from screwgen import UsageError
from screwgen.algorithms.fused import modal_dynamics
from screwgen.backends.numpy.python import compiled
from screwgen.ir.adjoint import adjoint, only

jax = package("jax")
sys.path.insert(0, str(ROOT / "bench"))

from jax_scenarios import measured  # noqa: E402
from jax_table import ROBOTS, row, state  # noqa: E402

jnp = jax.numpy
LINK = {"length": 0.5, "section": {"rhoA": 2.0, "EIz": 40.0, "rhoIp": 0.01}, "bodies": [{"at": "tip", "mass": 1.5}]}
LINK |= {"modes": {"bending_y": 1}, "damping": {"ratio": 0.02}}
ARM = {"name": "small", "gravity": [0.0, 0.0, -9.81], "links": [{"name": "a", "joint": {"axes": ["z", "y"]}, **LINK}]}
GIVEN = ("q", "v", "tau", "w_ext", "p")


@pytest.fixture(autouse=True)
def doubles():
    with jax.enable_x64(True):
        yield


@pytest.fixture(scope="module")
def model():
    return model_of(ARM)


def off(a, b) -> float:
    a, b = np.asarray(a), np.asarray(b)
    return float(np.max(np.abs(a.reshape(b.shape) - b)) / np.max(np.abs(b)))


def test_single_precision():
    """A cylinder, a four-bar linkage, dry friction, stops and two modes."""
    digger = example("bucket")
    x = state(digger)
    found = digger.jax("single")["forward_dynamics"](*(x[k] for k in GIVEN))
    expected = digger.numpy().forward_dynamics(*(x[k] for k in GIVEN[:4]))
    assert found[0].dtype == jnp.float32 and off(found[0], expected[0]) < 1e-4


@pytest.mark.examples
def test_second_gradients_and_forward_mode(model):
    """The Hessian of the energy, by the adjoint's adjoint and by single operations in forward mode."""
    x = state(model)
    of = lambda f: lambda q: sum(f["energy"](q, x["v"], x["p"]))  # noqa: E731
    twice = jax.jacrev(jax.grad(of(model.jax())))(x["q"])
    assert off(twice, jax.hessian(of(model.jax(forward_mode=True)))(jnp.array(x["q"]))) < 1e-10
    backwards = of(model.jax())
    for refused in (jax.jacfwd(backwards), jax.hessian(backwards), jax.jit(jax.jacfwd(backwards))):
        with pytest.raises(UsageError, match=r"take model.jax\(forward_mode=True\)"):
            refused(x["q"])
    with pytest.raises(UsageError, match=r"take model.jax\(forward_mode=True\)"):
        jax.jvp(jax.jit(backwards), (jnp.array(x["q"]),), (jnp.ones(model.nq),))


@pytest.mark.examples
def test_batches_in_scans_have_the_values_of_single_scenarios(model):
    """130 scenarios, more than stand side by side; the payload differs, the torques are common; nested vmap too."""
    x, step = state(model), model.jax()["step_modal_midpoint"]
    q = x["q"] + 0.01 * np.random.default_rng(1).normal(size=(130, model.nq))
    p = x["p"] * np.linspace(1.0, 1.5, 130)[:, None]

    def run(q, p):
        body = lambda s, _: (step(*s, x["tau"], x["w_ext"], p, 1e-3), None)  # noqa: E731
        return jax.lax.scan(body, (q, jnp.array(x["v"])), None, length=3)[0]

    many = jax.jit(jax.vmap(run))(q, p)
    nested = jax.jit(jax.vmap(jax.vmap(run)))(q.reshape(2, 65, -1), p.reshape(2, 65, -1))
    one = [jax.jit(run)(q[k], p[k]) for k in (0, 77, 129)]
    for a, b, c in zip(many, nested, zip(*one, strict=True), strict=True):
        assert off(b.reshape(a.shape), a) < 1e-14 and off(a[jnp.array([0, 77, 129])], np.array(c)) < 1e-14
    slopes = jax.jit(jax.vmap(jax.grad(lambda q, p: run(q, p)[0][0])))(q, p)
    assert off(slopes[77], jax.jit(jax.grad(lambda q, p: run(q, p)[0][0]))(q[77], p[77])) < 1e-12


def test_a_singular_posture_is_nan_with_its_gradient():
    """A universal joint turned by a right angle, its first axis along the link that has no inertia about it."""
    links = [{"name": "a", "length": 1.0, "joint": {"axes": ["x", "y"]}, "bodies": [{"at": "tip", "mass": 1.0}]}]
    singular = model_of({"name": "gimbal", "gravity": [0.0, 0.0, -9.81], "links": links})
    x, f = state(singular) | {"q": np.zeros(2)}, singular.jax()

    def everything(q, v, tau, w_ext, p):
        first = lambda q: f["forward_dynamics"](q, v, tau, w_ext, p)[0][0]  # noqa: E731
        return *jax.value_and_grad(first)(q), *f["step_euler"](q, v, tau, w_ext, p, 1e-3)

    vdot, slope, *end = jax.jit(everything)(*(x[k] for k in GIVEN))
    assert np.isnan(vdot) and np.isnan(slope).any() and np.isnan(np.concatenate(end)).all()


def test_adjoints_of_every_operation_are_the_tangents(model):
    """Of a program in plain Python: one direction forwards, one backwards."""
    program = only(modal_dynamics(model.chain), ["vdot"])
    rng = np.random.default_rng(3)
    given = {name: list(rng.uniform(0.1, 1.0, size)) for name, size in program.inputs.items()}
    seed = {f"adjoint of {name}": list(rng.normal(size=len(out))) for name, out in program.outputs.items()}
    back = adjoint(program, program.inputs, program.outputs)
    slopes = compiled(back)(given | seed, EPS)[0]
    way = {name: rng.normal(size=size) for name, size in program.inputs.items()}
    value = lambda t: np.array(  # noqa: E731
        compiled(program)({k: list(np.array(v) + t * way[k]) for k, v in given.items()}, EPS)[0]["vdot"]
    )
    finite = (value(1e-6) - value(-1e-6)) / 2e-6 @ seed["adjoint of vdot"]
    exact = sum(np.dot(slopes[f"gradient of {name}"], way[name]) for name in program.inputs)
    assert abs(finite - exact) < 1e-6 * abs(exact)


def test_refusals(model):
    f = model.jax()
    x = state(model)
    with pytest.raises(UsageError, match=r"q has the shape \(5,\)"):
        f["mass_matrix"](np.zeros(5), x["p"])
    with pytest.raises(UsageError, match=r"the arguments are \(q, p\)"):
        f["mass_matrix"](x["q"])
    with pytest.raises(UsageError, match="not an array of numbers"):
        f["mass_matrix"]("abc", x["p"])
    with pytest.raises(UsageError, match="there is no function 'mass'"):
        f["mass"]
    with pytest.raises(UsageError, match="there is no precision 'half'"):
        model.jax("half")
    with jax.enable_x64(False), pytest.raises(UsageError, match="jax_enable_x64"):
        model_of(ARM).jax()


def test_without_jax_there_is_one_line(monkeypatch):
    for name in [name for name in sys.modules if name.startswith("screwgen.backends.jax")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "jax", None)
    with pytest.raises(UsageError, match=r"^JAX is not installed; pip install 'screwgen\[jax\]'$"):
        model_of(ARM).jax()


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
    assert max(found[x] for x in ("values", "steps", "gradient", "motion")) < 1e-12
    assert max(found[x] for x in ("values, single", "steps, single")) < 1e-4
    assert found["seconds"] < 60
