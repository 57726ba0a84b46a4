"""The inputs of a run: torques and wrenches from functions, constants or nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import Numbers, fits, real_numbers
from ..errors import ScrewgenError, UsageError
from ..robot_model import RobotModel

if TYPE_CHECKING:
    from .prescribed_motion import GivenMotion


def started(
    controller: Any, q0: np.ndarray, model: RobotModel | None = None, p: Any = None, step: float | None = None
) -> Any:
    """The controller at the start of a run: the result of its `starting_at(q)` if it has that method.

    One that has `through(chain, p)` learns before where the joints stand and of the gears that it works through. One
    that has `sampled_every(step)` learns for how long its torques are held.
    """
    if step is not None and hasattr(controller, "sampled_every"):
        controller = controller.sampled_every(step)
    if model is not None and hasattr(controller, "through"):
        controller = controller.through(model.chain, model.parameter_values if p is None else p)
    return controller.starting_at(q0) if hasattr(controller, "starting_at") else controller


def coordinates(values: Numbers | None, name: str, model: RobotModel, p: Numbers | None = None) -> np.ndarray:
    """`values` of `q` as (nq,), or of `v` as (nv,); the joints alone leave the rest at zero or at home.

    Gears are then without load, with the ratios in `p`.
    """
    given = np.ravel(floats([] if values is None else values, name))
    found = model.chain.complete(given, model.parameter_values if p is None else p, rates=name[0] == "v")
    if isinstance(found, str):
        raise UsageError(f"{name} {found}")
    return found


class Inputs:
    """Torques (n_tau,) and tip wrenches (n, 6) at an instant, from functions, constants or nothing.

    Wrenches may be a mapping from names of links and pushes. `motion`: that of axes that is given, whose accelerations
    stand in place of their torques.
    """

    def __init__(self, model: RobotModel, controller: Any, w_ext: Any, motion: GivenMotion | None = None):
        self.motion = motion
        self.torques_vary, self.wrenches_vary = callable(controller), callable(w_ext)
        self.shape = (model.n_links, 6)
        rows = lambda x: model.chain.tip_wrenches(x, "w_ext:") if isinstance(x, Mapping) else x  # noqa: E731
        wrenches = (lambda t, q, v: rows(w_ext(t, q, v))) if callable(w_ext) else rows(w_ext)
        self.sources = (
            _source(controller, "the controller", (model.n_tau,)),
            _source(wrenches, "w_ext", self.shape),
        )

    @property
    def constant_wrenches(self) -> np.ndarray | None:
        """The tip wrenches (n, 6) where they are constant; None where a function gives them."""
        return None if self.wrenches_vary else self.sources[1](0.0, None, None)

    def wrenches(self, count: int) -> np.ndarray:
        """Room for the tip wrenches (count, n, 6) at samples: filled where they are constant."""
        held = self.constant_wrenches
        return np.empty((count, *self.shape)) if held is None else np.broadcast_to(held, (count, *self.shape))

    def __call__(self, t: float, q: np.ndarray, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        torque, wrench = self.sources
        tau = torque(t, q, v)
        if self.motion is not None:
            tau = tau.copy()
            tau[self.motion.axes] = self.motion.accelerations(t)
        return tau, wrench(t, q, v)

    def place(self, t: float, q: np.ndarray, v: np.ndarray) -> None:
        """Put axes whose motion is given where they are at a time."""
        if self.motion is not None:
            self.motion.place(t, q, v)


def _source(given: Any, name: str, shape: tuple[int, ...]) -> Callable:
    if callable(given):
        return lambda t, q, v: _shaped(given(t, q.copy(), v.copy()), name, shape)
    constant = np.zeros(shape) if given is None else _shaped(given, name, shape)
    return lambda t, q, v: constant


def _shaped(values: Any, name: str, shape: tuple[int, ...]) -> np.ndarray:
    out = floats(values, name)
    if not fits(out.shape, shape):
        raise UsageError(f"{name} gives an array of shape {out.shape}; it must give {shape}")
    return out.reshape(shape)


def floats(values: Any, name: str) -> np.ndarray:
    """An array of finite numbers; raises UsageError."""
    out = real_numbers(values)
    if out is None:
        raise UsageError(f"{name} gives something else than numbers; it must give an array of numbers")
    if not np.isfinite(out).all():
        raise UsageError(f"{name} gives a NaN or an infinity; it must give finite numbers")
    return out


class at_time:
    """Puts the time in front of an error inside."""

    def __init__(self, t: float):
        self.t = t

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: type | None, error: BaseException | None, _: object) -> None:
        if isinstance(error, ScrewgenError):
            timed = type(error)(f"t = {self.t:.6g} s: {error}")
            timed.at = self.t
            raise timed from None
