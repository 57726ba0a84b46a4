"""The JAX back end: against NumPy, CasADi and the compiled C; gradients, batches, refusals."""

import subprocess
import sys

import numpy as np
import pytest
from helpers import EPS, ROOT, example, model_of

from screwgen import UsageError
from screwgen.algorithms.fused import modal_dynamics
from screwgen.backends.numpy.python import compiled
from screwgen.ir.adjoint import adjoint, only

jax = pytest.importorskip("jax")
jnp = jax.numpy
LINK = {"length": 0.5, "section": {"rhoA": 2.0, "EIz": 40.0, "rhoIp": 0.01}, "bodies": [{"at": "tip", "mass": 1.5}]}
LINK |= {"modes": {"bending_y": 1}, "damping": {"ratio": 0.02}}
ARM = {"name": "small", "gravity": [0.0, 0.0, -9.81], "links": [{"name": "a", "joint": {"axes": ["z", "y"]}, **LINK}]}
NAMES = (
    "forward_dynamics",
    "inverse_dynamics",
    "mass_matrix",
    "bias",
    "energy",
    "tip_pose",
    "tip_jacobian",
    "validity",
)


@pytest.fixture(autouse=True)
def doubles():
    with jax.enable_x64(True):
        yield


@pytest.fixture(scope="module")
def model():
    return model_of(ARM)


def state(model, seed=0) -> dict:
    rng = np.random.default_rng(seed)
    sizes = {"q": model.nq, "v": model.nv, "vdot": model.nv, "tau": model.n_tau}
    out = {name: 0.3 * rng.normal(size=n) for name, n in sizes.items()}
    out["q"][model.nq - model.chain.n_modes :] *= 0.02
    return out | {"w_ext": rng.normal(size=(model.n_links, 6)), "p": np.array(model.parameter_values), "h": 1e-4}


def off(a, b) -> float:
    a, b = np.asarray(a), np.asarray(b)
    return float(np.max(np.abs(a.reshape(b.shape) - b)) / np.max(np.abs(b)))


def casadi(model, name: str, x: dict) -> list[np.ndarray]:
    f = model.casadi()[name]
    found = f(*(x[f.name_in(i)].T if f.name_in(i) == "w_ext" else x[f.name_in(i)] for i in range(f.n_in())))
    return [np.array(y.full()) for y in (found if isinstance(found, tuple) else (found,))]


def asked(name: str) -> list[str]:
    first = {"inverse_dynamics": "q v vdot w_ext p", "mass_matrix": "q p", "bias": "q v w_ext p", "energy": "q v p"}
    return first.get(name, "q p" if name.startswith("tip") else "q v tau w_ext p").split()


@pytest.mark.parametrize("name", NAMES)
def test_functions_are_those_of_casadi(model, name):
    x = state(model)
    found = model.jax()[name](*(x[k] for k in asked(name)))
    for ours, theirs in zip(found if isinstance(found, tuple) else (found,), casadi(model, name, x), strict=True):
        matrix = name in ("forward_dynamics", "validity") and theirs.shape[1:] == (model.n_links,)
        assert off(ours, theirs.T if matrix and theirs.shape[0] in (4, 6) else theirs) < 1e-12


def test_steps_are_those_of_the_compiled_c(model):
    x, c = state(model), model.compile()
    for method in ("modal_midpoint", "rk4"):
        found = model.jax()[f"step_{method}"](*(x[k] for k in "q v tau w_ext h p".split()))
        run = c.step(x["q"], x["v"], x["tau"], x["w_ext"], x["h"], method)
        assert max(map(off, found, run)) < 1e-12, method


def test_single_precision(model):
    x = state(model)
    found = model.jax("single")["forward_dynamics"](*(x[k] for k in asked("")))
    assert found[0].dtype == jnp.float32 and off(found[0], casadi(model, "forward_dynamics", x)[0]) < 1e-4


def test_gradients_are_those_of_casadi(model):
    """Of a weighted sum of the accelerations with every input; `p` is where lengths and masses are."""
    x, f, weights = state(model), model.casadi()["forward_dynamics"], np.arange(1.0, model.nv + 1)
    names = asked("")
    cost = lambda *given: weights @ model.jax()["forward_dynamics"](*given)[0]  # noqa: E731
    ours = jax.jit(jax.grad(cost, argnums=range(len(names))))(*(x[k] for k in names))
    given = [x[k].T if k == "w_ext" else x[k] for k in names]
    jacobian = f.jacobian()(*given, *f(*given))
    for k, (name, slope) in enumerate(zip(names, ours, strict=True)):
        theirs = weights @ np.array(jacobian[k].full())
        assert off(slope.ravel(), theirs) < 1e-10, name


@pytest.mark.examples
def test_second_gradients_and_forward_mode(model):
    """The Hessian of the energy, by the adjoint's adjoint and by single operations in forward mode."""
    x = state(model)
    of = lambda f: lambda q: sum(f["energy"](q, x["v"], x["p"]))  # noqa: E731
    twice = jax.jacrev(jax.grad(of(model.jax())))(x["q"])
    assert off(twice, jax.hessian(of(model.jax(forward_mode=True)))(jnp.array(x["q"]))) < 1e-10
    with pytest.raises(TypeError, match="forward-mode"):
        jax.jacfwd(of(model.jax()))(x["q"])


@pytest.mark.examples
def test_batches_in_scans_have_the_values_of_single_scenarios(model):
    """130 scenarios, more than stand side by side; the payload differs, the torques are common; nested vmap too."""
    x, step = state(model), model.jax()["step_modal_midpoint"]
    q = x["q"] + 0.01 * np.random.default_rng(1).normal(size=(130, model.nq))
    p = x["p"] * np.linspace(1.0, 1.5, 130)[:, None]

    def run(q, p):
        body = lambda s, _: (step(*s, x["tau"], x["w_ext"], 1e-3, p), None)  # noqa: E731
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
    x = state(singular) | {"q": np.zeros(2)}
    f = singular.jax()["forward_dynamics"]
    given = [x[k] for k in asked("")]
    assert np.isnan(f(*given)[0]).all() and np.isnan(jax.grad(lambda q: f(q, *given[1:])[0][0])(given[0])).any()
    assert np.isnan(np.concatenate(singular.jax()["step_euler"](*given[:4], 1e-3, x["p"]))).all()


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


def test_without_jax_there_is_one_line():
    code = "import sys; sys.modules['jax'] = None; import screwgen as s; s.derive(s.load(sys.argv[1])).jax()"
    file = str(ROOT / "examples" / "ella.toml")
    done = subprocess.run([sys.executable, "-c", code, file], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 1 and "pip install 'screwgen[jax]'" in done.stderr.splitlines()[-1]


@pytest.mark.examples
@pytest.mark.parametrize(
    "name", ["ella", "space_arm", "crane", "crane_loop", "elastic_joint", "gantry", "parallelogram"]
)
def test_examples_equal_the_c(name):
    model = example(name)
    x, c = state(model), model.compile()
    if model.chain.floating:
        x["q"][3:7] /= np.linalg.norm(x["q"][3:7])
    given = [x[k] for k in asked("")]
    bound = 1e-12 * max(1.0, np.linalg.cond(np.asarray(model.jax()["mass_matrix"](x["q"], x["p"]))) * 1e-3)
    wanted = c.forward_dynamics(*given[:4])[0]
    assert off(model.jax()["forward_dynamics"](*given)[0], wanted) < bound
    assert (
        off(
            model.jax()["step_modal_midpoint"](*given[:4], 1e-4, x["p"])[1],
            c.step(*given[:4], 1e-4, "modal_midpoint")[1],
        )
        < bound
    )


@pytest.mark.examples
def test_the_tuning_example():
    done = subprocess.run(
        [sys.executable, "examples/jax_tuning.py", "--short"], capture_output=True, text=True, cwd=ROOT
    )
    assert done.returncode == 0, done.stderr
    assert "JAX and the C" in done.stdout
