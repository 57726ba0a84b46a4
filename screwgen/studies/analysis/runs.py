"""The validity measures of a stored run."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...bodies.validity import MEASURES
from ...errors import UsageError
from ...files import sound
from ...robot_model import RobotModel
from ...simulation.integrate import CasadiEvaluator
from ...simulation.runs import run_arrays
from ...simulation.validity import Validity, Watch
from ...spec.load import one_line

NEEDED = ("t", "q", "v", "tau", "wrench")
SAME = 1e-6
"""Relative difference of joint wrenches up to which a run is the robot's, without wrenches on its tips."""


def read_motion(path: str, model: RobotModel) -> dict[str, np.ndarray]:
    """`t` (N,), `q`, `v` (N, nq), `tau` (N, n_joints) and `wrench` (N, n, 6) of a .npz run; raises UsageError."""
    shown = one_line(path)
    with run_arrays(path) as arrays:
        found = {name: arrays.numbers(name) for name in NEEDED}
    if found["t"].ndim != 1:
        raise UsageError(f"{shown}: t has the shape {found['t'].shape}; it must be a list of times")
    count = len(found["t"])
    sizes = {"q": (model.nq,), "v": (model.nv,), "tau": (model.n_tau,), "wrench": (model.n_links, 6)}
    for name, size in sizes.items():
        if found[name].shape != (count, *size):
            raise UsageError(f"{shown}: {name} has the shape {found[name].shape}; this robot's is {(count, *size)}")
        if not sound(found[name]):
            raise UsageError(f"{shown}: {name} holds numbers that are not finite; simulate again")
    return found


def run_validity(model: RobotModel, motion: Mapping[str, np.ndarray]) -> Validity:
    """The largest measures over the samples of a run without wrenches on its tips; raises UsageError."""
    functions, p = model.casadi(), np.array(model.parameter_values)
    evaluate, dynamics = CasadiEvaluator(functions["validity"]), CasadiEvaluator(functions["forward_dynamics"])
    watch, none = Watch(model.chain.names), np.zeros((model.n_links, 6))
    for t, q, v, tau, wrench in zip(*(motion[name] for name in NEEDED), strict=True):
        own = dynamics(q, v, tau, none, p)[1]
        if not np.allclose(own, wrench.ravel(), rtol=SAME, atol=SAME * max(1.0, float(np.abs(wrench).max()))):
            raise UsageError(
                f"t = {t:.6g} s: the joint wrenches of the run are not those of this robot under its torques alone; "
                "wrenches on the tips are not in a run's file: take run.validity of simulate in Python instead"
            )
        watch(t, evaluate(q, v, tau, none, p)[0].reshape(-1, len(MEASURES)))
    return watch.validity()
