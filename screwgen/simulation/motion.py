"""Quantities derived from a motion: link poses and twists, displacement fields, tip deformation, spectra.

Every function takes the coordinates of N samples, as a run holds them: `q`, `v` (N, nq).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ..arguments import Numbers
from ..backends.numpy.rest_shape import bent_line, line_at_rest
from ..bodies import markers
from ..errors import UsageError
from ..lazily import transform
from ..robot_model import RobotModel
from ..spec.link_class import EXACT, LinkClass
from ..spec.parameters import coordinate_names
from ..spec.reduced import end, reach
from ..spec.segments import owner


class Screws(NamedTuple):
    """Poses and twists of n links or segments at N samples, in body-fixed components."""

    theta: np.ndarray
    """(N, n, 3) rad: exponential coordinates of R_oi, the rotation vector that turns the inertial axes to F_i."""
    r: np.ndarray
    """(N, n, 3) m: origin of F_i from the inertial origin, in F_i components, `R_oi^T p_i`."""
    omega: np.ndarray
    """(N, n, 3) rad/s: angular velocity of F_i, in F_i components."""
    v: np.ndarray
    """(N, n, 3) m/s: velocity of the origin of F_i, in F_i components."""


def screws(model: RobotModel, q: np.ndarray, v: np.ndarray, parameters: Numbers | None = None) -> Screws:
    """Exponential coordinates and twists of all links, (5) and (twist)."""
    q, v = _samples(model, q, "q"), _samples(model, v, "v")
    n, r = model.n_links, model.chain.n_inner
    x = mapped(model.casadi()["dae_state"], q, v, _values(model, parameters))
    poses = x[:, : 7 * n].reshape(-1, n, 7)
    twists = x[:, 7 * n + r : 13 * n + r].reshape(-1, n, 6)
    turns = transform.Rotation.from_quat(poses[..., :4].reshape(-1, 4), scalar_first=True)
    theta, place = turns.as_rotvec(), turns.inv().apply(poses[..., 4:].reshape(-1, 3))
    return Screws(theta.reshape(-1, n, 3), place.reshape(-1, n, 3), twists[..., :3], twists[..., 3:])


def displacements(model: RobotModel, q: np.ndarray, link: int, points: Numbers) -> np.ndarray:
    """The elastic displacement `r_xi = phi eta` (N, points, 3) of a link's centreline, m, in F_i components, (72).

    `points`: places along the link as s in [0, 1], base to tip. `link`: its number in the robot. Of a link with
    segments the displacement from the link at rest in the axes of its first segment, however large.
    """
    first, points = model.chain.firsts[link], np.asarray(points, float)
    if model.chain.segments[first].count == 1:
        return _bent(model, q, first, points)
    if model.chain.keys[first].rest:
        return _lines(model, q, link, points) - _lines(model, np.array([model.chain.home]), link, points)
    out = _lines(model, q, link, points)
    out[..., 0] -= (model.robot.links[link].length or 0.0) * points
    return out


def _lines(model: RobotModel, q: np.ndarray, link: int, points: np.ndarray) -> np.ndarray:
    """The centreline (N, points, 3) of a link in the axes of its first segment, m."""
    (R, r), first = _poses(model, q), model.chain.firsts[link]
    return (_centreline(model, q, R, r, link, points) - r[:, None, first]) @ R[:, first]


def tip_deflections(model: RobotModel, q: np.ndarray) -> dict[int, np.ndarray]:
    """By how much the tips of flexible links are displaced, (N, 3) m in F_i components, by the number of the link.

    From the tip of the undeformed link, as `displacements` is, whose axes they have: elongation, then across the link.
    """
    flexible = [i for i, first in enumerate(model.chain.firsts) if model.chain.keys[first].modes]
    return {i: displacements(model, q, i, [1.0])[:, 0] for i in flexible}


def twist(model: RobotModel, q: np.ndarray, link: int, points: Numbers) -> np.ndarray:
    """The torsion angle (N, points) of a link's sections about its x axis, rad; arguments as of `displacements`.

    With segments the sum of those from the base to the section.
    """
    first, points = model.chain.firsts[link], np.asarray(points, float)
    out = np.zeros((len(_samples(model, q, "q")), len(points)))
    for i in range(first, model.chain.lasts[link] + 1):
        local = np.clip(model.chain.segments[i].count * points - (i - first), 0.0, 1.0)
        out += modal(model, q, i) @ markers.twist(model.chain.keys[i], tuple(local)).T
    return out


def _bent(model: RobotModel, q: np.ndarray, i: int, points: np.ndarray) -> np.ndarray:
    """The displacements of a segment."""
    key = model.chain.keys[i]
    if key.order == EXACT:
        return bent_rod(key, own_length(model, i), own_rest(model, i), modal(model, q, i), tuple(points.tolist()))
    shapes = markers.displacement(model.chain.keys[i], tuple(points))
    return np.einsum("nr,pkr->npk", modal(model, q, i), shapes)


def _rest(model: RobotModel, i: int, points: np.ndarray) -> np.ndarray:
    """The places (points, 3) of the centreline of a segment at rest from its base, m."""
    key, link = model.chain.keys[i], model.robot.links[model.chain.segments[i].link]
    if key.rest:
        return line_at_rest(key, own_length(model, i), own_rest(model, i), points.tolist())
    return points[:, None] / link.pieces * end(link)


def bent_rod(
    key: LinkClass, length: float, rest: Sequence[float], eta: np.ndarray, points: tuple[float, ...]
) -> np.ndarray:
    """Those (N, points, 3) of a rod of order EXACT at modal coordinates (N, r), by the program of its line.

    `rest`: the numbers of its curvature at rest.
    """
    lines = [bent_line(key, length, rest, one, points) for one in eta]
    return np.reshape(lines, (len(lines), len(points), 3)) - line_at_rest(key, length, rest, points)


def own_length(model: RobotModel, i: int) -> float:
    """That of a segment, m."""
    link = model.robot.links[model.chain.segments[i].link]
    return reach(link) / link.pieces


def own_rest(model: RobotModel, i: int) -> tuple[float, ...]:
    """The numbers of the curvature at rest of the link of a segment, 1/m; none where it is straight."""
    rest = model.robot.links[model.chain.segments[i].link].rest
    return rest.numbers if rest else ()


def modal(model: RobotModel, q: np.ndarray, i: int) -> np.ndarray:
    """The modal coordinates (N, r) of a segment."""
    first = model.chain.eta_q + model.chain.eta_offset[i]
    return _samples(model, q, "q")[:, first : first + model.chain.keys[i].modes]


def centrelines(model: RobotModel, q: np.ndarray, points: Numbers) -> np.ndarray:
    """The centrelines (n, points, 3) of the robot's n links at the coordinates `q` (nq,), inertial frame, m."""
    (R, r), points = model.numpy().link_pose(q), np.asarray(points, float)
    lines = (_centreline(model, q[None], R[None], r[None], i, points) for i in range(len(model.robot.links)))
    return np.array([line[0] for line in lines])


def _centreline(
    model: RobotModel, q: np.ndarray, R: np.ndarray, r: np.ndarray, link: int, points: np.ndarray
) -> np.ndarray:
    """That of one link, (N, points, 3), from the poses of all segments, (N, n, 3, 3) and (N, n, 3)."""
    own, first = model.robot.links[link], model.chain.firsts[link]
    out, number = np.empty((len(q), len(points), 3)), np.minimum((own.pieces * points).astype(int), own.pieces - 1)
    for k in np.unique(number):
        i, at, local = first + k, number == k, own.pieces * points[number == k] - k
        place = _bent(model, q, i, local)
        place += _rest(model, i, local) - [own.frame_at or 0.0, 0.0, 0.0]
        out[:, at] = r[:, None, i] + place @ R[:, i].transpose(0, 2, 1)
    return out


def _poses(model: RobotModel, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rotations (N, n, 3, 3) and positions (N, n, 3) of all segments' frames."""
    given = model.casadi()["link_pose"], _samples(model, q, "q"), _values(model, None)
    R, r = (mapped(*given, output=k).reshape(len(q), model.n_links, *shape) for k, shape in enumerate(((3, 3), (3,))))
    return R.transpose(0, 1, 3, 2), r


def modal_columns(model: RobotModel, link: int, direction: str) -> list[int]:
    """The columns of `q` with the modal coordinates of a link in one of `DIRECTIONS`."""
    name, part = model.robot.links[link].name, f".eta.{direction}["
    return [k for k, x in enumerate(coordinate_names(model.robot).q) if owner(x) == name and part in x]


def undeformed(model: RobotModel, q: np.ndarray) -> np.ndarray:
    """The coordinates (N, nq) of the same joint angles with links at rest."""
    out = np.zeros_like(_samples(model, q, "q"))
    out[:, : model.chain.eta_q] = q[:, : model.chain.eta_q]
    return out


def tip_deformation(model: RobotModel, q: np.ndarray, parameters: Numbers | None = None) -> np.ndarray:
    """The displacement (N, 3), m, of the last tip from its place with undeformed links at the same joint angles.

    In inertial components. It includes the rotation of later links by the slope of a link's tip.
    """
    return tip_position(model, q, parameters) - tip_position(model, undeformed(model, q), parameters)


def tip_position(model: RobotModel, q: np.ndarray, parameters: Numbers | None = None) -> np.ndarray:
    """The last tip (N, 3), m, in the inertial frame."""
    return mapped(model.casadi()["tip_pose"], _samples(model, q, "q"), _values(model, parameters), output=1)


def amplitude_spectrum(t: np.ndarray, x: np.ndarray, taper: bool = True) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies (K,) in Hz and amplitudes (K, m) of even samples `x` (N, m) at `t` (N,), in the unit of `x`.

    The mean is removed. A sine of amplitude a on a grid frequency has the amplitude a. With `taper` a Hann window is
    applied: it reduces the leakage of strong lines, but also weakens motion near the ends of the interval.
    """
    x = np.reshape(np.asarray(x, float), (len(t), -1))
    step = (t[-1] - t[0]) / max(len(t) - 1, 1)
    if len(t) < 4 or np.abs(np.diff(t) - step).max() > 1e-6 * step:
        raise UsageError("a spectrum needs at least four samples at even distances in time")
    window = np.ones(len(t))
    if taper:
        window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(len(t)) / len(t))
    weighted = window[:, None] * (x - np.average(x, axis=0, weights=window))
    return np.fft.rfftfreq(len(t), step), 2 * np.abs(np.fft.rfft(weighted, axis=0)) / window.sum()


def _values(model: RobotModel, p: Numbers | None) -> np.ndarray:
    return np.array(model.parameter_values if p is None else p, float)


def _samples(model: RobotModel, x: np.ndarray, name: str) -> np.ndarray:
    x = np.asarray(x, float)
    if x.ndim != 2 or x.shape[1] != model.nq:
        raise UsageError(f"{name} has shape {x.shape}; it must be (samples, {model.nq})")
    return x


def mapped(function: Any, *rows: np.ndarray, output: int = 0) -> np.ndarray:
    """An output of a CasADi function for every sample (N, …); the last argument, `p`, is the same for all."""
    *varying, p = rows
    count = len(varying[0])
    out = function.map(count)(*(x.T for x in varying), np.tile(p, (count, 1)).T)
    return np.array(out[output] if isinstance(out, tuple) else out).T
