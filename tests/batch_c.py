"""Robots, scenarios and steps for the tests of the generated C's batch."""

from functools import cache

import numpy as np
import random_robots as rr
from drive_robots import MIXED
from helpers import arm, equal_links, example_dict, link, model_of, unfolded
from varying_robots import tapered_arm

from screwgen.backends.c.project import CProject
from screwgen.runtime.batch import CompiledBatch
from screwgen.runtime.compiled import Compiled

STRICT = ("-O0", "-ffp-contract=off")
WIDTHS = (0, 16, 32, 64)
"""Sizes of registers in bytes; what the machine lacks the compiler takes apart."""

SOFT = {"EA": 1e5, "EIy": 60.0, "EIz": 90.0, "GJ": 40.0, "rhoIp": 1e-3}
STIFF = {"mount": {"xyz": [0.1, 0.0, 0.2], "rpy": [0.3, -0.2, 0.5]}, "armature": [0.05]}
STIFF |= {"damping": [0.2], "stiffness": [40.0]}
BODY = {"at": "tip", "mass": 0.7, "com": [0.02, 0.01, -0.03], "inertia": [0.01, 0.02, 0.015, 0.001, 0.0, 0.002]}
ROBOTS = {
    "ella": example_dict("ella"),
    "rigid": arm(link("one", axes="yz"), link("two", axes="xyz")),
    "torsion, mount, body": arm(
        link("rod", axes="y", modes={"bending_y": 1, "torsion": 1}, section=SOFT, joint=STIFF, bodies=[BODY])
    ),
    "many modes": arm(link("rod", axes="yz", modes={"bending_y": 5, "bending_z": 5}, section=SOFT)),
    "welded": arm(link("rod", axes=(), modes={"bending_y": 2, "axial": 1}, section=SOFT)),
    "tapered": tapered_arm() | {"links": tapered_arm()["links"][:1]},
    "second order": arm(
        link("one", axes="z", modes={"axial": 1, "bending_y": 1}, section=SOFT, joint=STIFF),
        link("two", axes="y", modes={"bending_z": 2, "torsion": 1}, section=SOFT, bodies=[BODY]),
        order=2,
    ),
    "rods": arm(*(link(n, axes=a) | {"section": {"rhoA": 1.0}} for n, a in (("rod", "x"), ("blade", "z")))),
    "exact": arm(
        link("rod", axes="yz", modes={"bending_y": 1, "bending_z": 1}, section=SOFT, bodies=[BODY]), order="exact"
    ),
    "eleven links": equal_links(11),
    "drives": MIXED | {"links": MIXED["links"][:2]},
}


@cache
def model(name: str):
    return model_of(ROBOTS[name])


@cache
def batch(name: str, width=16, libm=False, single=False, flags=STRICT) -> CompiledBatch:
    """A batch with registers of a size; ``libm``: with its sine and cosine."""
    upper = ROBOTS[name]["name"].upper()
    options = [f"-D{upper}_LANE_BYTES={width}", "-Wno-psabi", *([f"-D{upper}_LIBM"] if libm else [])]
    return CompiledBatch(model(name), single, (*flags, *options))


@cache
def written(name: str, binding="runtime") -> dict[str, str]:
    return CProject(model(name).chain, "", binding, batch=True).files()


def write_into(folder, name: str, binding="runtime") -> dict[str, str]:
    unfolded(folder, written(name, binding))
    return written(name, binding)


@cache
def scalar(name: str, single=False) -> Compiled:
    return Compiled(model(name), single=single, flags=STRICT)


@cache
def scenarios(name: str, count: int):
    """States (2, nq, count), torques (1, n_joints, count) and wrenches (1, 6 n, count)."""
    states = [rr.random_state(np.random.default_rng(i), ROBOTS[name], modal=0.3) for i in range(count)]
    x = np.array([[s["q"], s["v"]] for s in states]).transpose(1, 2, 0)
    tau, w_ext = (np.array([np.ravel(s[key]) for s in states]).T[None] for key in ("tau", "w_ext"))
    return np.ascontiguousarray(x), np.ascontiguousarray(tau), np.ascontiguousarray(w_ext)


def stepped(b: CompiledBatch, x, tau, w_ext, method="rk4", p=None, periods=1, hold=1, dt=1e-5, threads=1):
    """Paths (2, periods + 1, nq, count) of q and v; status, fault and steps done of the scenarios."""
    path = np.zeros((2, periods + 1, *x.shape[1:]), b.real)
    path[:, 0] = x
    constants = b.constants(np.atleast_2d(b.model.parameter_values if p is None else p))
    inputs = [np.ascontiguousarray(a, b.real) for a in (tau, w_ext)]
    return path, *b.run(*path, *inputs, constants, dt, hold, method, threads)


def one_by_one(c: Compiled, x, tau, w_ext, method="rk4", count=1, dt=1e-5) -> np.ndarray:
    """The states (2, nq, scenarios) after steps of the scalar code."""
    every = range(x.shape[2])
    ends = [c.step(*x[:, :, i], tau[0, :, i], w_ext[0, :, i], dt, method, count) for i in every]
    return np.array(ends).transpose(1, 2, 0)
