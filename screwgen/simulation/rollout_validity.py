"""Validity of rollouts: all samples are checked for deflection and slope, some for the loads."""

from __future__ import annotations

import warnings
from collections.abc import Mapping

import numpy as np

from ..bodies.validity import MEASURES
from ..robot_model import RobotModel
from ..spec.reduced import reach
from .integrate import CasadiEvaluator
from .validity import Validity, Watch

SPREAD = 32
"""Samples, evenly spaced, whose axial loads and rotations are evaluated, besides those at which a link bends most and
the joints turn fastest."""


def watched(
    model: RobotModel, given: Mapping[str, np.ndarray], t: np.ndarray, q: np.ndarray, v: np.ndarray, settling: float
) -> Validity:
    """The largest measures of a batch of motions `q` (batch, samples, nq), `v` (.., nv) at the times `t` (samples,).

    `given`: `tau`, `w_ext` (batch or 1, periods or 1, numbers), `parameters` (batch or 1, n); `settling`: as of
    :meth:`.Method.settling`, s, by which stiff rows bear what the motion needs.
    """
    watch = Watch(model.chain.names)
    count, samples, _ = q.shape
    if not count or samples < 2:
        return watch.validity()
    chosen = set(np.linspace(0, count * samples - 1, min(SPREAD, count * samples)).astype(int).tolist())
    chosen.add(int(np.argmax(np.abs(v[..., : model.chain.base_v + model.n_joints]).sum(axis=2))))
    bending = [_bending(model, i, given["parameters"], q) for i in range(model.n_links)]
    chosen |= {int(np.argmax(size)) for sizes in bending for size in sizes}
    evaluate = CasadiEvaluator(model.casadi()["validity"])
    settled = CasadiEvaluator(model.modal_functions["settled_rows"]) if model.chain.compliant and settling else None
    at = lambda name, k, j: _of(given[name], k, min(j, samples - 2))  # noqa: E731
    for k, j in sorted((divmod(c, samples) for c in chosen), key=lambda place: place[1]):
        state, p, w_ext = (q[k, j], v[k, j], at("tau", k, j)), _of(given["parameters"], k), at("w_ext", k, j)
        if settled is not None:
            w_ext = settled(*state, w_ext, np.array(settling), p)[0]
        watch(t[j], evaluate(*state, w_ext, p)[0].reshape(-1, len(MEASURES)))
    return watch.validity()


class ParameterWarning(UserWarning):
    """Scenarios that did not run, since no robot has their parameters."""


def warn_refused(refused: Mapping[int, str], count: int, where: str) -> None:
    """Say of the first scenario of status 3 what is wrong with its parameters, and where all ``count`` are listed."""
    if refused:
        first = min(refused)
        more = f"; {count - 1} more such: see {where}" if count > 1 else ""
        warnings.warn(
            f"scenario {first} did not run (status 3): {refused[first]}{more}", ParameterWarning, stacklevel=3
        )


def _of(values: np.ndarray, *place: int) -> np.ndarray:
    """The entry at a place; an axis of length 1 applies to all."""
    for k in place:
        values = values[max(k, 0) if len(values) > 1 else 0]
    return values


def _bending(model: RobotModel, i: int, p: np.ndarray, q: np.ndarray) -> list[np.ndarray]:
    """Deflection over length and slope of a link, (batch, samples) each; none for a link that cannot bend."""
    values, offset = model.blocks(i)["validity"].values, model.chain.eta_q + model.chain.eta_offset[i]
    if f"{MEASURES[0]}_shapes" not in values:
        return []
    segment = model.chain.segments[i]
    named = model.parameter_names.index(f"{segment.owner}.length") if "length" in values else None
    length = reach(model.robot.links[segment.link]) if named is None else p[:, named][:, None] / segment.count
    unit = dict.fromkeys(np.ravel(values.get("segment", values.get("length", ()))), 1)
    eta = q[..., offset : offset + model.chain.keys[i].modes]
    shapes = (values[f"{name}_shapes"] for name in MEASURES[:2])
    rows = (np.array([[float(x.subs(unit)) for x in row] for row in shape]) for shape in shapes)
    with np.errstate(invalid="ignore"):  # a scenario that stopped may hold an infinite state
        return [np.linalg.norm(eta @ row.T, axis=2) / length for row in rows]
