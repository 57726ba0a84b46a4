"""Rigid chains: forward dynamics and their derivatives beside Pinocchio, steps beside MuJoCo."""

from __future__ import annotations

import ctypes
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import robots
from contenders import Missing
from native import COMMON, LEVELS
from rigid import compiled, toolchain
from table import Row
from turns import rows_of

import screwgen
from screwgen.backends.c.project import CProject
from screwgen.runtime import library

HERE = Path(__file__).resolve().parent
COUNTS = (6, 12, 24, 48)
KINDS = ("dynamics", "derivatives")
SAME = 1e-9
"""The largest difference between two sides' results, over the largest of their entries."""
STEP, STEPS = 1e-4, 20_000

PINOCCHIO = (
    "{what} of {count} rigid links, {level}: accelerations alone, their derivatives by q, v and tau, dense;\n"
    "Pinocchio {version} in C++ with the headers of its wheel, both compiled by GCC with the same flags"
)
MUJOCO = (
    "six rigid links, a semi-implicit Euler step of 0.1 ms, loops in C: mj_step of MuJoCo {version} from its wheel\n"
    "without contacts, limits and sensors; screwgen's C at -O3, its lanes on one core with 256 scenarios"
)
Loop = Callable[[int], float]
"""Processor seconds of so many calls."""


def pinocchio(store: Path, level: str) -> list[Row]:
    """Forward dynamics and derivatives at all lengths; raises Missing."""
    import pinocchio as pin

    compiler, flags, _ = toolchain()
    flags = ["-shared", "-fPIC", *LEVELS[level], *flags]  # a minute or two for the first time
    theirs = ctypes.CDLL(str(compiled(store, "pinocchio_slopes.cpp", flags, compiler, ".so")))
    rows: list[Row] = []
    for count in COUNTS:
        robot = robots.rigid(f"rigid{count}", count)
        given = [np.random.default_rng(0).uniform(-1.0, 1.0, count) for _ in range(3)]
        own, other = _ours(robot, level, given), _theirs(theirs, robot, given)
        for what in KINDS:
            heading = PINOCCHIO.format(count=count, what=what, level=f"-{level}", version=pin.__version__)
            rows += rows_of(heading, {"screwgen": own(what), "Pinocchio": other(what)})
        _compare(own.results(), other.results())
    return rows


class _Side:
    """One library with its loops over `dynamics` and `derivatives`, and the results of the last call."""

    def __init__(self, library: ctypes.CDLL, first: Sequence, given: Sequence[np.ndarray]):
        self.library, self.first, self.count = library, first, len(given[0])
        self.given = [np.ascontiguousarray(x).ctypes.data_as(ctypes.c_void_p) for x in given]
        self.kept = given

    def __call__(self, what: str) -> Loop:
        call = getattr(self.library, f"peer_{what}")
        call.restype = ctypes.c_double
        return lambda calls: call(*self.first, *self.given, ctypes.c_long(calls))

    def results(self) -> list[np.ndarray]:
        """vdot and its three matrices."""
        out = [np.zeros(self.count), *(np.zeros((self.count, self.count)) for _ in range(3))]
        self.library.peer_results(*self.first, *(x.ctypes.data_as(ctypes.c_void_p) for x in out))
        return out


def _ours(robot: screwgen.Robot, level: str, given: Sequence[np.ndarray]) -> _Side:
    model = screwgen.derive(robot)
    files = CProject(model.chain, model.version, derivatives=True).files()
    name = robot.name
    defines = (f"-DROBOT={name}", f"-DROBOT_UPPER={name.upper()}", f'-DHEADER="{name}_derivatives.h"')
    flags = (*(x for x in COMMON if x != "-std=c99"), *LEVELS[level], *defines)
    made = library.load(files | {"own_slopes.c": (HERE / "own_slopes.c").read_text(encoding="utf-8")}, flags, "gcc")
    return _Side(made, (), given)


def _theirs(made: ctypes.CDLL, robot: screwgen.Robot, given: Sequence[np.ndarray]) -> _Side:
    joints = np.array(robots.rigid_joints(robot))
    made.peer_chain.restype = ctypes.c_void_p
    chain = made.peer_chain(len(joints), joints.ctypes.data_as(ctypes.c_void_p))
    return _Side(made, (ctypes.c_void_p(chain),), given)


def _compare(own: Sequence[np.ndarray], other: Sequence[np.ndarray]) -> None:
    for a, b in zip(own, other, strict=True):
        off = np.abs(a - b).max() / np.abs(b).max()
        if not off < SAME:
            raise SystemExit(f"peers: screwgen and Pinocchio differ by {off:.1e}")


def mujoco() -> list[Row]:
    """Steps of six links; raises Missing."""
    try:
        import mujoco as mj
    except ImportError as error:
        raise Missing(f"the Python package 'mujoco' is not installed ({error})") from None
    robot = robots.rigid("rigid6", 6)
    world = mj.MjModel.from_xml_string(mjcf(robot))
    start = 0.3 * np.ones(6)
    data, states = mj.MjData(world), {}

    def theirs(calls: int) -> float:
        mj.mj_resetData(world, data)
        data.qpos[:] = start
        clock = time.process_time()
        mj.mj_step(world, data, nstep=calls)
        seconds, states["MuJoCo"] = time.process_time() - clock, np.array(data.qpos)
        return seconds

    model = screwgen.derive(robot)
    c = model.compile(flags=("-O3",))

    def ours(calls: int) -> float:
        clock = time.process_time()
        states["screwgen"] = c.step(start, np.zeros(6), None, None, STEP, "semi_implicit", calls)[0]
        return time.process_time() - clock

    def lanes(calls: int, single: bool = False) -> float:
        starts = np.hstack([np.outer(np.linspace(0.5, 1.0, 256), start), np.zeros((256, 6))])
        more = {"step": 100 * STEP, "substeps": 100, "steps": 2, "integrator": "semi_implicit", "single": single}
        clock = time.process_time()
        screwgen.rollout(model, starts, **more)
        return (time.process_time() - clock) / (256 * 200) * calls

    sides = {"screwgen": ours, "screwgen, lanes": lanes, "screwgen, lanes in float": lambda n: lanes(n, True)}
    rows = rows_of(MUJOCO.format(version=mj.__version__), sides | {"MuJoCo": theirs}, STEPS)
    off = np.abs(states["screwgen"] - states["MuJoCo"]).max()
    if not off < 1e-6:
        raise SystemExit(f"peers: screwgen and MuJoCo are {off:.1e} rad apart after {STEPS} steps")
    return rows


def mjcf(robot: screwgen.Robot) -> str:
    """The rigid chain as MuJoCo reads it: no contacts, nothing that damps."""
    flags = '<flag contact="disable" constraint="disable" eulerdamp="disable"/>'
    text = f'<mujoco><option timestep="{STEP}" integrator="Euler">{flags}</option><worldbody>'
    for i, (axis, offset, m, com, *inertia) in enumerate(robots.rigid_joints(robot)):
        direction = " ".join("1" if k == axis else "0" for k in range(3))
        moments = " ".join(map(repr, inertia))
        text += f'<body name="b{i}" pos="{offset} 0 0"><joint type="hinge" axis="{direction}"/>'
        text += f'<inertial pos="{com} 0 0" mass="{m}" diaginertia="{moments}"/>'
    return text + "</body>" * len(robot.links) + "</worldbody></mujoco>"
