"""Mobility: which coordinates the loops of a robot leave independent, and how the others follow these."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..algorithms.loops import LEAST
from ..arguments import Numbers
from ..backends.numpy.numeric import Numeric
from ..errors import UsageError
from ..robot_model import RobotModel
from ..topology.chain import Chain

CLEAR, RANK = 0.05, 1e-7
"""The part of a column of the gaps' Jacobian that must be new: where there is a choice, and where there is none."""
OPEN = 1e-6
"""The mismatch (m or rad), or the rate of a row, at which a loop counts as open."""
Kinds = Sequence[Sequence[Sequence[int]]]
"""Coordinates in the order in which they are made dependent: those of a kind before the next one's, and among them, as
far as their columns are clearly new, those of a tier before the next one's."""


class Mobility(NamedTuple):
    """What the rows of the loops, `J v = 0`, leave of n coordinates."""

    independent: np.ndarray
    """(d,): the numbers of the coordinates that move freely."""
    dependent: np.ndarray
    """(n − d,): of the others."""
    follow: np.ndarray
    """(n, d): N of `v = N v_independent`."""


def mobility(J: np.ndarray, kinds: Kinds) -> Mobility:
    """The coordinates that the gaps' Jacobian `J` (rows, n) leaves independent; those in no kind always are."""
    rest, largest, chosen = np.array(J, float), np.max(np.abs(J), initial=0.0), []
    sizes, ends = np.linalg.norm(J, axis=0), []
    for tiers in kinds:
        for least in (CLEAR, RANK):
            for k in (k for tier in tiers for k in tier if k not in chosen):
                size = np.linalg.norm(rest[:, k])
                if size > least * sizes[k] and size > RANK * largest:
                    direction = rest[:, k] / size
                    for _ in range(2):  # twice, because of rounding
                        rest -= np.outer(direction, direction @ rest)
                    chosen.append(k)
        ends.append(len(chosen))
    independent = np.setdiff1d(np.arange(J.shape[1]), chosen)
    N = np.zeros((J.shape[1], len(independent)))
    N[independent, np.arange(len(independent))] = 1.0
    N[chosen] = -np.linalg.lstsq(J[:, chosen], J[:, independent], rcond=None)[0]
    for tiers, end in zip(kinds, ends, strict=True):  # what closes a gap does not need the kinds behind it
        same = np.isin(independent, [k for tier in tiers for k in tier])
        N[np.ix_(np.array(chosen[end:], int), np.flatnonzero(same))] = 0.0
    return Mobility(independent, np.array(chosen, int), N)


def by_effort(chain: Chain, kept: Numbers | None = None) -> Kinds:
    """Joints without a drive first, those with one (`armature` or `drives` and no spring) next, modes last.

    Among the joints the last of the file comes first. `kept` (n_joints,) of bool: joints that come behind the others.
    """
    driven = [chain.base_v + k for k in chain.moved_joints]
    every = range(chain.base_v, chain.base_v + chain.n_joints)
    others = [k for k in every if k not in driven]
    last = [] if kept is None else [chain.base_v + int(k) for k in np.flatnonzero(kept)]
    tiers = [[k for k in tier[::-1] if (k in last) == late] for late in (False, True) for tier in (others, driven)]
    return [tiers, [range(chain.eta_v, chain.nv)]]


def by_spring(J: np.ndarray, springs: np.ndarray) -> Kinds:
    """Coordinates without springs first; of the others those that move the gaps most."""
    sprung = np.flatnonzero(springs)
    sizes = np.linalg.norm(J[:, sprung], axis=0)
    return [[np.flatnonzero(springs == 0)[::-1].tolist()], [sprung[np.argsort(-sizes, kind="stable")].tolist()]]


def closing(model: RobotModel) -> Callable[..., Any]:
    """The CasADi function of the loops, :func:`..backends.casadi.linear.closing`, made once for a model.

    Of a robot without loops what gives its results, all of them empty or zero.
    """
    if not model.chain.closing.rows:
        n = model.nv
        nothing = tuple(map(np.zeros, ((0, 1), (0, n), (0, n), (n, n), (6, model.n_links))))
        return lambda *_: nothing
    from ..backends.casadi.linear import closing as made

    function = model.once("closing", lambda: made(model.chain))
    return lambda q, v, *more: function(q, model.chain.with_internal(v), *more)


def jacobian(model: RobotModel, q: np.ndarray, p: Numbers) -> np.ndarray:
    """(rows, nv): the rates of the gaps by the rates of the coordinates."""
    return np.array(closing(model)(q, np.zeros(model.nv), np.zeros(len(model.chain.closing.rows)), p)[1])


def motions(
    model: RobotModel, q: np.ndarray, v: np.ndarray, p: Numbers, kept: Numbers | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """The numbers (d,) of independent coordinates, and T (2 nv, 2 d): all changes [δ; δv] by those of these.

    Where `J δv + (∂(J v)/∂δ) δ = 0` rates change with the posture, as loops make them. `kept` (n_joints,) of bool:
    joints that depend on others only where these do not suffice.
    """
    chain = model.chain
    if not chain.closing.rows:
        return np.arange(chain.nv), np.eye(2 * chain.nv)
    _, J, J_v, *_ = (np.array(x) for x in closing(model)(q, v, np.zeros(len(chain.closing.rows)), p))
    check_closed(model.numpy(p), "q", q)
    check_staying_closed(chain, "v", J @ v[: chain.nv])
    own, D, N = mobility(J, by_effort(chain, kept))
    turned = np.zeros_like(N)
    turned[D] = -np.linalg.lstsq(J[:, D], J_v @ N)[0]
    return own, np.block([[N, np.zeros_like(N)], [turned, N]])


def stated_joints(model: RobotModel, q: np.ndarray, p: Numbers, preferred: Numbers | None = None) -> np.ndarray:
    """(n_joints,) of bool: the joints whose coordinates may be stated, as many as the loops leave; all without loops.

    Those that are `preferred` (n_joints,) come first, then those with drives before others, and then those that come
    first in the file. The others follow them. Raises SingularError where rows of the loops depend on each other in this
    posture that do not in others.
    """
    out, J = np.ones(model.n_joints, bool), jacobian(model, q, p)
    dependent = mobility(J, by_effort(model.chain, preferred)).dependent - model.chain.base_v
    if len(dependent) < len(J) and not model.chain.closing.overconstrained:
        raise model.chain.singular_loops()
    out[dependent[dependent < model.n_joints]] = False
    return out


def check_closed(numeric: Numeric, name: str, q: np.ndarray) -> None:
    """Raise UsageError, about the argument `name`, where a loop is open in the posture `q` (nq,)."""
    apart = numeric.mismatch(q)
    if apart.size and not np.max(apart) < OPEN:
        loop, kind = divmod(int(np.argmax(apart)), 2)
        what = f"{numeric.chain.closing.junctions[loop].name} is open by {apart[loop, kind]:.3g} {('m', 'rad')[kind]}"
        raise UsageError(f"{name}: {what}; start from what `screwgen assemble` or screwgen.assemble gives")


def check_staying_closed(chain: Chain, name: str, rates: np.ndarray) -> None:
    """Raise UsageError, about the argument `name`, where a loop opens: `rates` (rows,) of the gaps."""
    worst = int(np.argmax(np.abs(rates))) if len(rates) else 0
    if len(rates) and not abs(rates[worst]) < OPEN:
        what = f"{chain.closing.rows[worst].name} opens by {abs(rates[worst]):.3g}"
        raise UsageError(f"{name}: {what}; start at rest, or with rates that keep it closed")


def sharing(model: RobotModel, q: np.ndarray, J: np.ndarray, p: Numbers) -> np.ndarray:
    """(rows,): factors s such that forces s·y of rows which depend on each other are those of the dynamics, out of all
    that act alike, where y is the shortest; ones where all rows are independent."""
    if not model.chain.closing.overconstrained:
        return np.ones(len(J))
    own = np.sum(J.T * np.linalg.solve(model.numpy(p).mass_matrix(q), J.T), axis=0)
    return 1 / np.sqrt(own + LEAST * np.sum(own))


def loads_of_loops(model: RobotModel, q: np.ndarray, p: Numbers) -> np.ndarray | None:
    """The wrenches (n, 6) of the loops on the tips at rest in a posture `q` whose stated joints are held; None without.

    The joints that follow bear no torque.
    """
    if not model.chain.closing.rows:
        return None
    J, rest = jacobian(model, q, p), np.zeros(model.nv)
    D, shares = mobility(J, by_effort(model.chain)).dependent, sharing(model, q, J, p)
    forces = shares * np.linalg.lstsq(shares * J[:, D].T, model.numpy(p).bias(q, rest, None)[D])[0]
    return np.array(closing(model)(q, rest, forces, p)[4]).T
