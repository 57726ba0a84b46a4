"""JAX against the compiled C and CasADi on the example robots, as the table of docs/jax.md.

    python tests/jax_table.py [ROBOT]...

Every number is the largest difference of any entry, over the largest entry of what is compared. Values: forward and
inverse dynamics, mass matrix, energy and pose of the tip. Steps: one of every integrator. Both against the C of the
same precision, in single at inputs that are single precision numbers. C, single: what the C in single is off the C
in double there, values and steps. M rounded: what the accelerations change by in double arithmetic, if the entries of
the mass matrix alone are rounded to single. Gradients, in double against CasADi: of the accelerations with every
input, and of a weighted end of three steps. About five minutes.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable

import casadi as ca
import jax
import jax.numpy as jnp
import numpy as np
from helpers import ROOT, quick, relative
from step_judges import point

from screwgen import Model, load
from screwgen.integrators import METHODS

ROBOTS = tuple(sorted(x.stem for x in (ROOT / "examples").glob("*.toml") if not x.stem.endswith("_law")))
ARGUMENTS = {
    "forward_dynamics": "q v tau w_ext p",
    "inverse_dynamics": "q v vdot w_ext p",
    "mass_matrix": "q p",
    "energy": "q v p",
    "tip_pose": "q p",
}
INPUTS = ("q", "v", "tau", "w_ext", "p")
STEP = "q v tau w_ext p dt"
H, COUNT = 2.0**-13, 3
"""The step, s, and how many make a motion."""
HEAD = (
    "| robot | nv | cond(M) | values | steps | values, single | steps, single | C, single | M rounded "
    "| gradient | of three steps |"
)


SHOWN = {"robot": "", "nv": "", "condition": ".0e", "values": ".0e", "steps": ".0e", "values, single": ".0e"}
SHOWN |= {"steps, single": ".0e", "C, single": ".1e", "steps of C, single": ".1e", "M rounded": ".1e"}
SHOWN |= {"gradient": ".0e", "motion": ".0e"}
"""What is compared, in the order of the table, and how it is written; the two of C, single, share a cell."""


def shown(row: dict) -> str:
    """A line of the table."""
    cells = [format(row[name], how) for name, how in SHOWN.items()]
    both = list(SHOWN).index("C, single")
    cells[both : both + 2] = [", ".join(cells[both : both + 2])]
    return "| " + " | ".join(cells) + " |"


def named(name: str) -> Model:
    return Model(load(ROOT / "examples" / f"{name}.toml"))


def state(model, rounded=False) -> dict:
    """A general state, rounded to single precision or not."""
    x = dict(zip("q v tau w_ext".split(), point(model, angle=0.3, modal=1e-4), strict=True))
    x |= {"vdot": np.random.default_rng(1).normal(size=model.nv), "p": np.array(model.parameter_values), "dt": H}
    return {k: np.float32(a).astype(float) if rounded else a for k, a in x.items()}


def by_c(model, x: dict, single=False, methods: Iterable[str] = METHODS) -> tuple[dict, dict]:
    """Values and steps by the compiled C."""
    c, given = quick(model, single=single), tuple(x[k] for k in INPUTS[:4])
    c.prepare(x["p"])
    vdot, wrench, R, position = c.complete_dynamics(*given)
    force = np.asarray(c.inverse_dynamics(x["q"], x["v"], x["vdot"], x["w_ext"])[0])
    values = {"vdot": vdot, "wrench": wrench, "force": force, "M": c.mass_matrix(x["q"])}
    values |= {"energy": np.array(c.energy(x["q"], x["v"])), "R": R, "position": position}
    ends = {name: c.step(*given, H, name) for name in methods}
    return values, {f"{name} {k}": y for name, pair in ends.items() for k, y in zip("qv", pair, strict=True)}


def by_jax(model, x: dict, precision="double", methods: Iterable[str] = METHODS) -> tuple[dict, dict]:
    """The same by JAX."""
    f = model.jax(precision)
    found = {name: f[name](*(x[k] for k in names.split())) for name, names in ARGUMENTS.items()}
    values = dict(zip(("vdot", "wrench"), found["forward_dynamics"], strict=True))
    values |= {"force": found["inverse_dynamics"], "M": found["mass_matrix"], "energy": np.array(found["energy"])}
    values |= dict(zip(("R", "position"), found["tip_pose"], strict=True))
    ends = {name: f[f"step_{name}"](*(x[k] for k in STEP.split())) for name in methods}
    return values, {f"{name} {k}": y for name, pair in ends.items() for k, y in zip("qv", pair, strict=True)}


def worst(found: dict, expected: dict) -> float:
    """NaN wherever an entry is."""
    return float(np.max([relative(found[name], x) for name, x in expected.items()]))


def rounded_inertia(values: dict) -> float:
    """What the accelerations change by where the entries of M are rounded to single, and all else is in double."""
    M, vdot = values["M"], values["vdot"]
    return relative(np.linalg.solve(np.float32(M).astype(float), M @ vdot), vdot)


# -------- gradients


def gradient(model, x: dict) -> float:
    """The Jacobian of the accelerations, each input's block beside its own largest entry."""
    f, wanted = model.jax()["forward_dynamics"], model.casadi()["forward_dynamics"]
    ours = jax.jit(jax.jacrev(lambda *given: f(*given)[0], argnums=range(5)))(*(x[k] for k in INPUTS))
    symbols = [ca.SX.sym(k, *wanted.size_in(k)) for k in INPUTS]
    slopes = [ca.jacobian(wanted(*symbols)[0], s) for s in symbols]
    theirs = ca.Function("slopes", symbols, slopes)(*(x[k].T if k == "w_ext" else x[k] for k in INPUTS))
    pairs = zip(ours, theirs, strict=True)
    return float(np.max([relative(np.reshape(a, b.shape), b.full()) for a, b in pairs]))


def motion_gradient(model, x: dict) -> tuple[float, float]:
    """Of a weighted end of ``COUNT`` steps; and the CPU seconds of tracing and compiling."""
    weights = np.random.default_rng(2).normal(size=model.nq + model.nv)
    step = model.jax()["step"]

    def cost(q, v, tau, w_ext, p):
        period = lambda now, _: (step(*now, tau, w_ext, p, H), None)  # noqa: E731
        end = jax.lax.scan(period, (q, v), None, length=COUNT)[0]
        return weights @ jnp.concatenate(end)

    given = [jnp.asarray(x[k]) for k in INPUTS]
    clock = time.process_time()
    compiled = jax.jit(jax.grad(cost, argnums=range(5))).lower(*given).compile()
    seconds = time.process_time() - clock
    theirs = _by_casadi(model, weights)(*(x[k].T if k == "w_ext" else x[k] for k in INPUTS))
    pairs = zip(compiled(*given), theirs, strict=True)
    return float(np.max([relative(np.ravel(a), b.full().ravel(order="F")) for a, b in pairs])), seconds


def _by_casadi(model, weights) -> ca.Function:
    """``(q, v, tau, w_ext, p) -> gradients``."""
    step = model.casadi()["step"]
    symbols = [ca.MX.sym(k, *step.size_in(k)) for k in INPUTS]
    q, v, tau, w_ext, p = symbols
    for _ in range(COUNT):
        q, v = step(q, v, tau, w_ext, p, H)
    cost = ca.dot(weights, ca.vertcat(q, v))
    return ca.Function("slope", symbols, [ca.gradient(cost, s) for s in symbols])


# -------- the table


def row(name: str) -> dict:
    """The figures of a robot under the names of `SHOWN`, and the CPU seconds of compiling a gradient."""
    model = named(name)
    x, rounded = state(model), state(model, rounded=True)
    c, reference, single = by_c(model, x), by_c(model, rounded), by_c(model, rounded, single=True)
    pairs = (by_jax(model, x), c), (by_jax(model, rounded, "single"), single), (single, reference)
    found = [name, model.nv, float(np.linalg.cond(c[0]["M"]))]
    found += [worst(a, b) for given, expected in pairs for a, b in zip(given, expected, strict=True)]
    found += [rounded_inertia(reference[0]), gradient(model, x), *motion_gradient(model, x)]
    return dict(zip((*SHOWN, "seconds"), found, strict=True))


def main(names: list[str]) -> None:
    jax.config.update("jax_enable_x64", True)
    print(HEAD + "\n|" + "---|" * (HEAD.count("|") - 1))
    for name in names or ROBOTS:
        print(shown(row(name)), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
