"""The JAX back end: against NumPy, CasADi and the compiled C; gradients, batches, refusals."""

import subprocess
import sys

import numpy as np
import pytest
from helpers import ROOT, example, model_of

from screwgen import UsageError
from screwgen.algorithms.fused import modal_dynamics
from screwgen.backends.numpy.python import compiled

jax = pytest.importorskip("jax")
jnp = jax.numpy
LINK = {"length": 0.5, "section": {"rhoA": 2.0, "EIz": 40.0, "rhoIp": 0.01}, "bodies": [{"at": "tip", "mass": 1.5}]}
LINK |= {"modes": {"bending_y": 1}, "damping": {"ratio": 0.02}}
ARM = {"name": "small", "gravity": [0.0, 0.0, -9.81], "links": [{"name": "a", "joint": {"axes": ["z", "y"]}, **LINK}]}
NAMES = ("forward_dynamics", "inverse_dynamics", "mass_matrix", "bias", "energy", "tip_pose", "tip_jacobian", "validity")


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
        q, v = model.jax()[f"step_{method}"](*(x[k] for k in "q v tau w_ext h p".split()))
        c.set_state(x["q"], x["v"]) if hasattr(c, "set_state") else None
        run = c.step(x["q"], x["v"], x["tau"], x["h"], w_ext=x["w_ext"], method=method)
        assert max(off(q, run[0]), off(v, run[1])) < 1e-12, method
