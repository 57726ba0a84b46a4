"""Robots, models and measures that several test files use."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
import random_robots as rr
from oracle import Oracle, part_error

from screwgen import Model, Robot, load
from screwgen.runtime.batch import CompiledBatch
from screwgen.runtime.compiled import Compiled

ROOT = Path(__file__).resolve().parents[1]
EPS, EPS32 = float(np.finfo(np.float64).eps), float(np.finfo(np.float32).eps)
COMPANION = {"qdd": "etadd", "etadd": "qdd", "tau": "F", "F": "tau", "thetadd": "qdd"}
QUICK = ("-O0",)
G = 9.81


class Case(NamedTuple):
    """A random robot in a random state, with its judge."""

    robot: dict
    state: dict
    oracle: Oracle
    model: Model

    @property
    def inputs(self) -> tuple:
        """q, v, tau, w_ext: what every forward dynamics takes."""
        return tuple(np.array(self.state[name]) for name in ("q", "v", "tau", "w_ext"))

    @property
    def tolerance(self) -> float:
        """What double precision allows: the larger of 1e-10 and 50 eps cond."""
        return self.oracle.tolerance(self.state["q"])

    @property
    def agreement(self) -> float:
        """How well two back ends agree in double precision: the larger of 1e-12 and 50 eps cond."""
        return max(1e-12, 50 * EPS * self.oracle.condition(self.state["q"]))


class QuickModel(Model):
    """A model whose C, also that of its runs, is compiled without optimisation, in a fifth of the time."""

    compiler_flags = QUICK


def model_of(robot: dict) -> Model:
    """The model of a robot given as a plain dict."""
    return QuickModel(Robot.model_validate(robot))


FILES = {"ella": "ella_paper", "converged": "ella"}


def example_file(name: str) -> Path:
    """The robot file of an example: `ella` is the paper's arm, which has few modes, `converged` that of ella.toml."""
    return ROOT / "examples" / (FILES.get(name, name) + ".toml")


@cache
def example(name: str) -> Model:
    return QuickModel(load(example_file(name)))


def example_dict(name: str) -> dict:
    """An example robot as the oracle takes it."""
    return tomllib.loads(example_file(name).read_text(encoding="utf-8"))


def drawn(seed: int, n_links: int | None = None, **limits) -> Case:
    """A random robot with a regular mass matrix; see random_robots.draw_regular."""
    robot, state, oracle = rr.draw_regular(np.random.default_rng(seed), n_links, **limits)
    return Case(robot, state, oracle, model_of(robot))


def case_of(robot: dict, state: dict) -> Case:
    return Case(robot, state, Oracle(robot), model_of(robot))


def quick(model: Model, **options) -> Compiled:
    """The generated C, compiled without optimisation; the same C is compiled once, whichever tests need it."""
    return Compiled(model, flags=QUICK, cache=True, **options)


def quick_batch(model: Model, single=False) -> None:
    """Compile the batch of a model without optimisation before its first rollout."""
    model.once(("batch", single), lambda: CompiledBatch(model, single, flags=QUICK))


def casadi_forward(model: Model, q, v, tau, w_ext) -> tuple[np.ndarray, np.ndarray]:
    """Forward dynamics by CasADi in the shapes of the others: (nq,) and (n, 6)."""
    vdot, wrench = model.casadi()["forward_dynamics"](q, v, tau, np.reshape(w_ext, (-1, 6)).T, model.parameter_values)
    return flat(vdot), np.array(wrench).T


def unfolded(folder: Path, files: dict[str, str] | dict[str, bytes]) -> list[str]:
    """Files of a robot's C written into a folder, and those below it; the names of the library's sources."""
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data if isinstance(data, bytes) else data.encode())
    return sorted(n for n in files if n.endswith(".c") and "/" not in n and n not in ("main.c", "check.c"))


def flat(value) -> np.ndarray:
    return np.array(value).ravel(order="F")


def relative(value, reference) -> float:
    """Largest error over the reference's largest entry; absolute where the reference vanishes."""
    value, reference = np.asarray(value, float), np.asarray(reference, float)
    scale = np.max(np.abs(reference), initial=0.0)
    return float(np.max(np.abs(value - reference), initial=0.0) / (scale or 1.0))


def disagreement(oracle: Oracle, expected: tuple, given: tuple) -> float:
    """The worst of the four parts of two forward dynamics, measured as Oracle.errors does."""
    a, b = oracle.parts(*expected), oracle.parts(*given)
    return max(part_error(a[k], b[k], a[other]) for k, other in COMPANION.items() if k in a)


def link(
    name="arm", length=1.0, axes=("z",), rhoA=1.0, modes=None, bodies=None, joint=None, section=None, **more
) -> dict:
    """One `[[links]]` table: rigid unless `modes` are given; all stiffnesses that modes need are 1 or `section`'s."""
    stiff = {"EA": 1.0, "EIy": 1.0, "EIz": 1.0, "GJ": 1.0, "rhoIp": 1e-2} if modes else {"rhoIp": 1e-2}
    table = {"name": name, "length": length, "section": {"rhoA": rhoA, **stiff, **(section or {})}}
    table |= {"joint": {"axes": list(axes), **(joint or {})}, **more}
    return table | ({"modes": modes} if modes else {}) | ({"bodies": bodies} if bodies else {})


def arm(*links, gravity=(0.0, 0.0, -G), **more) -> dict:
    return {"name": "arm", "gravity": list(gravity), "links": list(links), **more}


def loaded_boom(section=None, modes=2, gravity=0.0, **keys) -> dict:
    """One link with a rotor, about z, that bends in the plane of gravity, along y, and carries 1 kg at its tip."""
    section = {"rhoA": 0.5, "EIy": 60.0, "EIz": 60.0, **(section or {})}
    own = {"modes": {"bending_y": modes}, "joint": {"armature": [0.3]}, "bodies": [{"at": "tip", "mass": 1.0}]}
    return arm(link("rod", section=section, **(own | keys)), gravity=(0.0, gravity, 0.0)) | {"name": "boom"}


def equal_links(count: int, classes: int = 1) -> dict:
    """A chain of flexible links that belong to one, two or three link classes by turns."""
    soft = {"EIy": 60.0, "EIz": 90.0, "rhoIp": 1e-3}
    kinds = [{"bending_y": 1}, {"bending_z": 1}, {"bending_y": 1, "bending_z": 1}][:classes]
    return arm(*(link(f"link{i}", 0.3, "y", modes=kinds[i % classes], section=soft) for i in range(count)))


def rotation_of(quaternion) -> np.ndarray:
    """The matrix of a unit quaternion (w, x, y, z), by the textbook formula."""
    w, x, y, z = quaternion
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip
