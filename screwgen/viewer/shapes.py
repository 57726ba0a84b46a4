"""What the modes do to the sections of a link, to the order of its model: as columns that a shader sums up.

The pose of a section is linear in the modes and, at order 2, in products of two of them; a product counts as one more
coordinate, so one table serves both. Of exact rods the page and films integrate the strains by each mode.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..bases import ORDER
from ..bodies import markers
from ..bodies.collocation import collocation
from ..spec.link_class import AXIS, LinkClass

DENSE = np.linspace(0.0, 1.0, 2001)
"""Places at which strains are evaluated to integrate their products."""
FINE = 4
"""Steps from section to section in which the strains of an exact rod are integrated."""
NOTHING = 1e-14
"""A product whose columns are smaller than this, over the largest, is left out."""


class Sections(NamedTuple):
    """The sections at `places` (S,) along a link: `columns` (S, C, 6) of displacement, m, and rotation vector, rad.

    In F_i components. The first columns are those of a unit of each mode, the others those of the product of the two
    modes in the rows of `pairs` (P, 2).
    """

    places: np.ndarray
    columns: np.ndarray
    pairs: np.ndarray


def sections(key: LinkClass, length: float, places: np.ndarray) -> Sections:
    """The sections of a link, or of a segment, of that length in m, at places s in [0, 1]."""
    linear = np.concatenate([markers.displacement(key, tuple(places)), _turns(key, length, places)], axis=1)
    pairs, quadratic = np.empty((0, 2), int), np.empty((len(places), 0, 6))
    if key.order == 2 and key.modes:
        whole = _from_file(key, places) if key.elastic is not None else _of_rod(key, length, places)
        first, second = np.triu_indices(key.modes)
        both = whole[:, :, first, second] + whole[:, :, second, first]
        both[:, :, first == second] /= 2
        kept = np.abs(both).max(axis=(0, 1)) > NOTHING * max(np.abs(both).max(), NOTHING)
        pairs, quadratic = np.column_stack([first, second])[kept], both[:, :, kept].swapaxes(1, 2)
    return Sections(places, np.concatenate([linear.swapaxes(1, 2), quadratic], axis=1), pairs)


def strains(key: LinkClass, length: float, places: np.ndarray) -> np.ndarray:
    """(FINE (S - 1), r, 6): stretch and curvature, 1/m, of an exact rod by each mode, in the middle of every step."""
    steps = np.diff(places)[:, None] * (np.arange(FINE) + 0.5) / FINE
    _, bend, strain = _slopes(key, length, (places[:-1, None] + steps).ravel())
    return np.concatenate([strain, bend], axis=1).swapaxes(1, 2)


def at_rest(key: LinkClass, rest: Sequence[float], places: np.ndarray) -> np.ndarray:
    """(FINE (S - 1), 6): the same at rest, by the numbers of the curvature at rest, 1/m."""
    steps = np.diff(places)[:, None] * (np.arange(FINE) + 0.5) / FINE
    rod, middles = collocation(key), (places[:-1, None] + steps).ravel()
    bend = np.array([rod.curvature(s)[:, key.modes :] @ np.array(rest) for s in middles.tolist()])
    return np.concatenate([np.zeros_like(bend), bend], axis=1)


def _turns(key: LinkClass, length: float, places: np.ndarray) -> np.ndarray:
    """(S, 3, r): the rotation vector by each mode; of a body from a file that of its tip, growing from the base."""
    if key.elastic is not None:
        return places[:, None, None] * key.elastic.tip.psi
    return _slopes(key, length, places)[0]


def _slopes(key: LinkClass, length: float, places: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """``psi``, ``kappa`` and ``gamma`` (S, 3, r) of a rod by each mode: turn, and strains per metre."""
    turn, bend, strain = (np.zeros((len(places), 3, key.modes)) for _ in range(3))
    for direction in dict.fromkeys(d for d, _ in key.directions):
        modes = [k for k, (d, _) in enumerate(key.directions) if d == direction]
        at = lambda order, d=direction: np.array(key.shapes(d).evaluate(list(places), order)).T / length**order  # noqa: E731
        if direction == "torsion":
            turn[:, 0, modes], bend[:, 0, modes] = at(0), at(1)
        elif ORDER[direction] == 2:
            row, sign = (2, 1) if AXIS[direction] == 1 else (1, -1)
            turn[:, row, modes], bend[:, row, modes] = sign * at(1), sign * at(2)
        else:
            strain[:, AXIS[direction], modes] = at(1)
    return turn, bend, strain


def _of_rod(key: LinkClass, length: float, places: np.ndarray) -> np.ndarray:
    """(S, 6, r, r): ``u_2 = ∫∫ψ×(κ×e_x) + ∫ψ×γ`` and ``θ_2 = ½∫ψ×κ`` by the products of two modes."""
    turn, bend, strain = _slopes(key, length, DENSE)
    tilt = np.cross(bend, [1.0, 0.0, 0.0], axisa=1, axisb=0, axisc=1)
    product = lambda a, b: np.cross(a[:, :, :, None], b[:, :, None, :], axis=1)  # noqa: E731
    place = _integral(_integral(product(turn, tilt), length) + product(turn, strain), length)
    whole = np.concatenate([place, _integral(product(turn, bend) / 2, length)], axis=1)
    first = np.clip((places * (len(DENSE) - 1)).astype(int), 0, len(DENSE) - 2)
    share = (places * (len(DENSE) - 1) - first)[:, None, None, None]
    return (1 - share) * whole[first] + share * whole[first + 1]


def _integral(values: np.ndarray, length: float) -> np.ndarray:
    """The integral along the link from its base to each of the places `DENSE`."""
    steps = length / (len(DENSE) - 1) * (values[1:] + values[:-1]) / 2
    return np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(steps, axis=0)])


def _from_file(key: LinkClass, places: np.ndarray) -> np.ndarray:
    """The same of a body from a file: its tip's, growing from the base as the deflection of a beam does."""
    assert key.elastic is not None
    tip = key.elastic.tip
    return np.concatenate([tip.phi2, tip.psi2])[None] * (places**2)[:, None, None, None] / 2
