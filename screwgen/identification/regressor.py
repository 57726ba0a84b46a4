"""The regressor: efforts of a motion as a matrix times the parameters in which they are linear, and base parameters.

Which parameters these are is found, not listed: forces are linear in those whose second derivatives have no entry. A
law that acts at some rates or beyond a limit alone has its entries in all states. Those of bodies may cancel, so where
a number of a body takes part they are looked at in random states. Two that multiply each other, as gravity and a mass,
cannot both be among them: gravity and numbers of forces are left out first, then those that multiply most others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..arguments import Given, Loads, Numbers, array, matching
from ..backends.casadi.regressor import BODY, forces_by_parameters, linear_parameters
from ..lazily import linalg
from ..robot_model import RobotModel
from ..spec.parameters import Parameter

STATES, SEED = 12, 0
"""Random states in which second derivatives with numbers of bodies are looked at."""
BENT = 1e-9
"""The largest second derivative, over the largest change of forces, that counts as none."""
MORE = 3
"""Rows of the matrix of random states from which base parameters follow, over the number of parameters."""
RANK = 1e-9
"""The share of the largest column that is left of one which follows from others."""
EMPTY = 1e-13
"""The share of the largest force that is rounding: a parameter that changes forces by less changes none."""
ANGLE, BEND, RATE = 2.0, 0.05, 1.5
"""The largest coordinates of joints and of modes, and rates and accelerations, in random states."""


@dataclass(frozen=True)
class BaseParameter:
    """A combination of parameters that motions tell: the sum of values times factors, by name."""

    factors: Mapping[str, float]

    @property
    def name(self) -> str:
        """The combination in words, as ``arm.rhoA + 0.5 hand.bodies[0].mass``."""
        said = ""
        for name, factor in self.factors.items():
            sign = (" - " if said else "-") if factor < 0 else " + " if said else ""
            size = "" if abs(abs(factor) - 1.0) < RANK else f"{abs(factor):.6g} "
            said += f"{sign}{size}{name}"
        return said


class Regressor:
    """``Y`` and ``rest`` of a motion, such that its generalised forces are ``Y @ values + rest``.

    Forces are those of :meth:`.Numeric.inverse_dynamics`: of joints, then of modes, where they are zero in a motion.
    """

    def __init__(self, model: RobotModel, of: str | Sequence[str] = "*"):
        chain = model.chain
        chain.refuse_loops("regressor", "take its tree alone")
        own = linear_parameters(chain)
        asked = matching(of, [one.name for one in own], "regressor: there is no parameter")
        self.model, self._random = model, RandomStates(model)
        _, bends = forces_by_parameters(chain, model.casadi(), asked)
        chosen, self.left_out = _linear(own, asked, self._bent(bends, own, asked))
        self.function, _ = forces_by_parameters(chain, model.casadi(), chosen)
        self._parameters = [own[k] for k in chosen]

    def _bent(self, bends: Any, own: Sequence[Parameter], asked: Sequence[int]) -> np.ndarray:
        """(k, k): whether there is a second derivative of forces by each two parameters."""
        stored = np.zeros((len(asked), len(asked)), bool)
        stored[bends.sparsity_out(0).get_triplet()] = True
        of_body = np.array([own[k].field in BODY for k in asked])
        cancels = self._random.second_derivatives(bends, own, asked) <= BENT
        return stored & ~(cancels & (of_body | of_body[:, None]))

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters, in the order of the columns of ``Y``."""
        return tuple(one.name for one in self._parameters)

    @property
    def values(self) -> np.ndarray:
        """Their values in the robot file."""
        return np.array([one.value for one in self._parameters])

    def __call__(
        self, q: Numbers, v: Numbers, vdot: Numbers, w_ext: Loads = None, parameters: Given = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """``Y`` (nv, k) and ``rest`` (nv,) in a state ``q`` (nq,), ``v`` (nv,) with accelerations ``vdot`` (nv,).

        ``w_ext`` (n, 6): wrenches on tips; ``parameters``: of those that are not among ``names`` the values count.
        """
        n, chain = self.model.nv, self.model.chain
        given = [array(x, name, (size,)) for x, name, size in ((q, "q", chain.nq), (v, "v", n), (vdot, "vdot", n))]
        loads = np.zeros((6, chain.n)) if w_ext is None else array(w_ext, "w_ext", (chain.n, 6)).T
        Y, rest = self.function(*given, loads, chain.parameters.vector(parameters))
        return np.array(Y), np.array(rest).ravel()

    @cached_property
    def base_parameters(self) -> tuple[BaseParameter, ...]:
        """The combinations that motions tell, of which no fewer give all forces: QR with pivoting in random states."""
        factors, _ = self._base
        names = np.array(self.names)
        return tuple(BaseParameter(dict(zip(names[row != 0], row[row != 0].tolist(), strict=True))) for row in factors)

    @property
    def base_columns(self) -> tuple[int, ...]:
        """The columns of ``Y`` that belong to the base parameters: forces are ``Y[:, columns] @ base + rest``."""
        return tuple(self._base[1])

    @property
    def base_matrix(self) -> np.ndarray:
        """(base, k): the base parameters are ``base_matrix @ values``."""
        return self._base[0].copy()

    @cached_property
    def _base(self) -> tuple[np.ndarray, list[int]]:
        count = len(self.names)
        states = self._random.states(-(-MORE * max(count, 1) // max(self.model.nv, 1)))
        stacked = np.vstack([self(*state)[0] for state in states])
        share = np.abs(stacked * np.where(self.values == 0.0, 1.0, self.values)).max(axis=0, initial=0.0)
        stacked[:, share <= EMPTY * share.max(initial=0.0)] = 0.0
        size = np.linalg.norm(stacked, axis=0)
        size[size == 0.0] = 1.0
        _, R, order = linalg.qr(stacked / size, mode="economic", pivoting=True)
        diagonal = np.abs(np.diag(R))
        rank = int(np.sum(diagonal > RANK * diagonal[0])) if stacked.any() else 0
        rows = np.zeros((rank, count))
        rows[:, order] = R[:rank]
        columns = _first_independent(rows)
        factors = np.linalg.solve(rows[:, columns], rows) if rank else rows
        factors[np.abs(factors) <= RANK**0.75] = 0.0
        return factors * size / size[columns, None], columns


def _first_independent(rows: np.ndarray) -> list[int]:
    """The columns that do not follow from those before them, which name base parameters."""
    found: list[int] = []
    for k in range(rows.shape[1]):
        singular = np.linalg.svd(rows[:, [*found, k]], compute_uv=False)
        if len(found) < len(rows) and singular[-1] > RANK**0.75 * singular[0]:
            found.append(k)
    return found


class RandomStates:
    """States of a robot and accelerations at random, the same ones each time."""

    def __init__(self, model: RobotModel):
        self.model = model

    def states(self, count: int) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """``q``, ``v`` and ``vdot``."""
        chain, rng, out = self.model.chain, np.random.default_rng(SEED), []
        wide = np.full(chain.nq, BEND)
        wide[: chain.nq - chain.n_modes] = ANGLE
        for _ in range(count):
            q = chain.unit(np.array(chain.home, float) + wide * rng.uniform(-1, 1, chain.nq))
            out.append((q, *(RATE * rng.uniform(-1, 1, (2, chain.nv)))))
        return out

    def second_derivatives(self, bends: Any, own: Sequence[Parameter], asked: Sequence[int]) -> np.ndarray:
        """(k, k): the largest second derivatives of forces, over the forces, of changes of parameters by themselves."""
        chain, rng, out = self.model.chain, np.random.default_rng(SEED), np.zeros((len(asked), len(asked)))
        p, still = np.asarray(chain.parameters.values), np.zeros((6, chain.n))
        size = np.array([abs(own[k].value) or 1.0 for k in asked])
        force = self.model.casadi()["inverse_dynamics"]
        for state in self.states(STATES):
            weights = rng.choice([-1.0, 1.0], chain.nv) / np.maximum(
                np.abs(np.array(force(*state, still, p)).ravel()), 1e-9
            )
            H = np.array(bends(*state, still, p, weights))
            out = np.maximum(out, np.abs(H) * np.outer(size, size))
        return out


def _linear(own: Sequence[Parameter], asked: Sequence[int], bent: np.ndarray) -> tuple[list[int], dict[str, str]]:
    """The parameters in which forces are linear together, and why others are not among them."""
    left = {own[asked[k]].name: "forces are not linear in it" for k in range(len(asked)) if bent[k, k]}
    there = [k for k in range(len(asked)) if not bent[k, k]]
    of_world = np.array([own[k].link is None for k in asked])
    while (number := bent[np.ix_(there, there)].sum(axis=1)).any():
        worst = there[int(np.argmax(number * (1 + len(asked) * of_world[there])))]
        other = next(k for k in there if bent[worst, k])
        left[own[asked[worst]].name] = f"it multiplies {own[asked[other]].name}"
        there.remove(worst)
    return [asked[k] for k in there], left
