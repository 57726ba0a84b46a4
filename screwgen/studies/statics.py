"""Statics: the balance of forces of an arm at rest, and the search for an equilibrium posture."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..backends.numpy.dae_step import SERIES
from ..backends.numpy.travel_numbers import travels
from ..errors import SingularError
from ..lazily import optimize
from ..robot_model import RobotModel
from ..spec.link_class import EXACT
from ..spec.reduced import reach, sizes
from .no_equilibrium import overbent, unbalanced
from .static_scales import carried, largest_loads, step_units, turns
from .stiffness import from_travels, stiffness

RESIDUAL = 1e-10
"""What no residual of an equilibrium exceeds."""
ITERATIONS, MOST_TURN, FAR = 300, 0.5, 8 * np.pi
"""Steps at most; rad that one of them turns or bends; rad at which a loaded joint without spring is given up. Of slides
in m."""
FARTHEST = 1.0
"""Modal coordinate over its link's length (torsion: rad) at which small deflections are out of the question."""
NEUTRAL = 1e-10
"""Scaled stiffness of a direction along which no step is made where forces are all but balanced."""
PARTS = np.linspace(0.1, 1.0, 10)
"""Of a load that grows."""
NONE = np.zeros(0)


@dataclass(frozen=True, eq=False)
class Balance:
    """An arm at rest at `q` (nq,), which may move along the rates of the numbers `moving`.

    Of a ball joint these are turns about the axes of its link.
    """

    q: np.ndarray
    energy: float
    """Potential energy less the work of the torques, J."""
    force: np.ndarray
    """(nv,): the residual generalised forces, N·m and N: zero in equilibrium."""
    stiffness: np.ndarray
    """(nv, nv): the derivative of `force` with a change of the posture along the rates."""
    scale: np.ndarray
    """(nv,): the forces beside which residuals are nothing, see `Statics.scales`."""
    wrench: np.ndarray
    """(n, 6): joint wrenches."""
    tip: np.ndarray
    """(3,): the last tip in the inertial frame, m."""
    moving: np.ndarray

    @property
    def shares(self) -> np.ndarray:
        """(nv,): the unbalanced forces over the loads, zero for held coordinates."""
        out = np.zeros(len(self.force))
        out[self.moving] = np.abs(self.force / self.scale)[self.moving]
        return out

    @property
    def residual(self) -> float:
        return float(np.max(self.shares, initial=0.0))


class Statics:
    """The forces on an arm at rest under torques `load` (nv,), `others` of its inputs, wrenches, weight and springs."""

    straight = True
    """Whether the directions in which it moves stay the same on the way."""

    def __init__(
        self,
        model: RobotModel,
        p: np.ndarray,
        load: np.ndarray,
        w_ext: np.ndarray,
        moving: np.ndarray,
        others: np.ndarray = NONE,
    ):
        self.model, self.p, self.load, self.w_ext, self.moving = model, p, load, w_ext, moving
        self.others = others
        self.springs = stiffness(model, p)
        self.turning = turns(model)
        self.bending = ~(self.turning | (np.arange(model.nv) < model.chain.eta_v))
        self.follows = np.isin(np.arange(model.nv), model.chain.flat_v, invert=True)

    def at(self, q: np.ndarray) -> Balance:
        """The balance at `q`."""
        energy, force, slope, weight, wrench, tip = self._functions(q, self.w_ext)
        work, load, softening = self.driven(q)
        force, scale = force[:, 0], self.scales(q, weight, load, slope - softening)
        force, slope = self._from_travels(q, force, slope) if self.model.chain.elastic_travels else (force, slope)
        places = {"wrench": wrench.T, "tip": tip[:, 0], "moving": self.moving}
        return Balance(q, energy.item() - work, force - load, slope - softening, scale, **places)

    def driven(self, q: np.ndarray) -> tuple[float, np.ndarray, np.ndarray | float]:
        """The work of the torques and tensions up to `q`, their generalised forces (nv,), and the derivative of these.

        The effort of a transmission does work along its travel, and what it exerts on its joint depends on the posture.
        Behind an elastic gear it acts on the rotor's travel, see :meth:`_from_travels`.
        """
        tensions = self.others[: self.model.chain.n_tensions]  # other inputs stand in the parameters
        if tensions.any():
            work, force, own = (x.full() for x in self.model.tendon_work(q, tensions, self.p))
            rest = self._by_drives(q)
            return rest[0] + work.item(), rest[1] + force[:, 0], rest[2] + own
        return self._by_drives(q)

    def _by_drives(self, q: np.ndarray) -> tuple[float, np.ndarray, np.ndarray | float]:
        chain, m = self.model.chain, self.model.n_joints
        along, load, slope = chain.flat(q), self.load.copy(), np.zeros(len(self.load))
        if not chain.travels:
            return self.load @ along, self.load, 0.0
        along[:m], ratio, slope[:m] = travels(chain, chain.of_joints(q), self.p)
        along[list(chain.elastic_travels.values())] += along[list(chain.elastic_travels)]
        load[:m] *= ratio
        return self.load @ along, load, np.diag(self.load * slope)

    def _from_travels(self, q: np.ndarray, force: np.ndarray, K: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Forces and stiffness with the travels of rotors in the place of how far these are ahead of transmissions.

        So a drive that is held leaves its joint to move on the gear: `e = s - l(q)` with the travel s of the rotor.
        """
        chain, T = self.model.chain, from_travels(self.model, q, self.p)
        own, bend = list(chain.elastic_travels), travels(chain, chain.of_joints(q), self.p)[2]
        turned = T.T @ K @ T
        turned[own, own] -= bend[own] * force[list(chain.elastic_travels.values())]
        return T.T @ force, turned

    def _functions(self, q: np.ndarray, w_ext: np.ndarray) -> list[np.ndarray]:
        return [np.array(x) for x in self.model.statics(q, w_ext.T, self.p)]

    def scales(self, q: np.ndarray, weight: np.ndarray, load: np.ndarray, K: np.ndarray) -> np.ndarray:
        """(nv,): for every coordinate the force beside which an unbalanced one is nothing.

        That is the force which does as much work on it as the largest load does on any, springs among the loads; or
        the sum of what the springs of its own row exert, where they are stiffer, as stops are.
        """
        gravity = np.linalg.norm(self.p[:3]) * np.linalg.norm(weight, axis=1)
        x = self.model.chain.flat(q)
        loads = self.largest + gravity + np.abs(self.springs * x) + np.abs(load)
        largest = np.max((loads / self.units)[self.moving], initial=0.0) or 1.0
        return np.maximum(self.units * largest, np.abs(K) @ np.abs(x))

    def bent(self, q: np.ndarray) -> float:
        """The largest modal coordinate over its link's length, of links whose deflections are to be small."""
        small = [key.order != EXACT for key in self.model.chain.keys for _ in range(key.modes)]
        return float(
            np.max(np.abs(self.model.chain.flat(q) / self.reach)[self.model.chain.eta_v :][small], initial=0.0)
        )

    @cached_property
    def reach(self) -> np.ndarray:
        """(nv,): the scale that makes a coordinate an angle: a link's length, or 1; larger for wound springs."""
        links = self.model.robot.links
        deflections = [(reach(link) or 1.0) / size for link in links for size in link.pieces * sizes(link)]
        wound = np.abs(self.load) / np.where(self.springs > 0, self.springs, np.inf)
        own = np.append(np.ones(self.model.chain.eta_v), deflections)
        return np.where(self.bending, own, np.maximum(1.0, wound / (2 * np.pi)))

    @cached_property
    def largest(self) -> np.ndarray:
        """(nv,): the loads before they cancel, see :func:`.static_scales.largest_loads`."""
        return largest_loads(self.model, self.p, self.w_ext, self.others, carried(self.model, self.p, self.reach))

    @cached_property
    def units(self) -> np.ndarray:
        """(nv,): D, such that D q has stiffnesses about one."""
        return step_units(self.model, self.p, self.largest)

    def scaled(self, b: Balance) -> tuple[np.ndarray, np.ndarray]:
        """Force and stiffness of the free coordinates, in the coordinates D q."""
        i, D = self.moving, self.units[self.moving]
        return b.force[i] / D, b.stiffness[np.ix_(i, i)] / np.outer(D, D)

    def directions(self, b: Balance) -> np.ndarray:
        """(moving, d): what the entries of `scaled` and of steps move, in the coordinates D q."""
        return np.eye(len(self.moving))

    def moved(self, b: Balance, step: np.ndarray) -> Balance:
        """The balance after `step` (d,) from `b`."""
        return self.at(self.displaced(b, step))

    def displaced(self, b: Balance, step: np.ndarray) -> np.ndarray:
        """The posture (nq,) after `step` (d,) from `b`."""
        change = np.zeros(self.model.nv)
        change[self.moving] = self.directions(b) @ step / self.units[self.moving]
        return self.near(self.model.chain.integrate(b.q, change, SERIES))

    def near(self, q: np.ndarray) -> np.ndarray:
        """The posture next to `q` (nq,) that the robot can take."""
        return q

    def borne(self, b: Balance) -> np.ndarray:
        """(n, 6): the wrenches on the tips, those of loops included."""
        return self.w_ext

    def wrenches(self, b: Balance) -> np.ndarray:
        """(n, 6): the joint wrenches."""
        return b.wrench

    def share(self, part: float, wrenches: float) -> Statics:
        """The same with a part of gravity and torques, and one of wrenches and of what acts on ball joints."""
        p = np.concatenate([part * self.p[:3], self.p[3:]])
        load = np.where(self.follows, wrenches, part) * self.load
        return type(self)(self.model, p, load, wrenches * self.w_ext, self.moving, part * self.others)

    def bounded(self, b: Balance, step: np.ndarray) -> np.ndarray:
        """`step` made so short that it turns, slides and bends nothing by more than `MOST_TURN`."""
        return step * min(1.0, MOST_TURN / max(np.max(self.turned(b, step), initial=0.0), 1e-300))

    def turned(self, b: Balance, step: np.ndarray) -> np.ndarray:
        """(moving, ...): how far a step (d, ...) turns, slides or bends each coordinate, in units of about one rad."""
        return np.abs(((self.directions(b) @ step).T / (self.units * self.reach)[self.moving]).T)

    def wandered(self, q: np.ndarray, start: np.ndarray) -> np.ndarray:
        """The axes that turn and turn under a torque from `start` on, or slide and slide: nothing holds them."""
        unsprung, away = np.flatnonzero((self.springs == 0) & (self.load != 0)), self.model.chain.flat(q - start)
        return unsprung[np.abs(away[unsprung]) > FAR]

    @property
    def turn_along(self) -> bool:
        """Whether loads turn with what they act on, wrenches or torques of ball joints; they have no potential."""
        return bool(self.w_ext.any() or self.load[self.follows].any())


# ------------------------------------------------------------------------------ the search


def search(statics: Statics, start: np.ndarray) -> Balance:
    """The equilibrium that the search from `start` (nq,) ends in; raises NoEquilibriumError."""
    first = statics.at(start)
    b = polished(statics, downhill(statics, first) if not statics.turn_along else rooted(statics, first))
    if statics.bent(b.q) > FARTHEST:
        raise overbent(statics, b)
    if b.residual > RESIDUAL:
        raise unbalanced(statics, b, start)
    return b


def downhill(statics: Statics, b: Balance) -> Balance:
    """Newton steps down the potential energy, along negative curvature too; by steps that the joints bear.

    Each direction has its own bound, so that one of next to no stiffness neither holds the others up nor waits.
    """
    start = b.q
    for _ in range(ITERATIONS):
        if b.residual <= RESIDUAL or statics.wandered(b.q, start).size or statics.bent(b.q) > 3 * FARTHEST:
            break
        force, K = statics.scaled(b)
        curvature, modes = np.linalg.eigh((K + K.T) / 2)
        own = (modes.T @ force) / np.maximum(np.abs(curvature), NEUTRAL)
        most = MOST_TURN / np.maximum(np.max(statics.turned(b, modes), axis=0, initial=0.0), 1e-300)
        step = -modes @ np.clip(own, -most, most)
        there = shortened(statics, b, statics.bounded(b, step), force, bool((curvature > 0).all()))
        if there is None:
            break
        b = there
    return b


def shortened(statics: Statics, b: Balance, step: np.ndarray, force: np.ndarray, convex: bool) -> Balance | None:
    """The balance after `step` or a part of it that lowers the energy, near a minimum the forces; None: none does."""
    for _ in range(40):
        there, slope = within_reach(statics, b, step), float(force @ step)
        falls = there and there.energy <= b.energy + 1e-4 * slope
        if there and (falls or (convex and there.residual < 0.5 * b.residual)):
            return there
        step = step / 2
    return None


def within_reach(statics: Statics, b: Balance, step: np.ndarray) -> Balance | None:
    """The balance after `step`; None where that leads beyond the reach of a linkage."""
    try:
        return statics.moved(b, step)
    except SingularError:
        return None


def rooted(statics: Statics, first: Balance) -> Balance:
    """Where all forces vanish, wrenches without potential among them; `first` itself if they do.

    By least squares with the wrenches growing from where the arm rests without them; from `first`; and from there
    with all loads growing.
    """
    best = first
    for attempt in (_wrenches_growing, least, _loads_growing):
        if best.residual <= RESIDUAL:
            break
        best = min(best, attempt(statics, first.q), key=lambda x: x.residual)
    return best


def _wrenches_growing(statics: Statics, q: np.ndarray) -> Balance:
    bare = statics.share(1.0, 0.0)
    q = polished(bare, downhill(bare, bare.at(q))).q
    for part in PARTS:
        q = least(statics.share(1.0, part), q).q
    return statics.at(q)


def _loads_growing(statics: Statics, q: np.ndarray) -> Balance:
    for part in PARTS:
        q = least(statics.share(part, part), q).q
    return statics.at(q)


def least(statics: Statics, q: np.ndarray) -> Balance:
    """The balance of the least forces near `q`."""
    here = statics.at(q)
    none = np.zeros(len(statics.moving))
    if not (statics.straight and none.size):
        return polished(statics, here)
    at = lambda step: statics.scaled(statics.moved(here, step))  # noqa: E731
    step = optimize.least_squares(lambda s: at(s)[0], none, lambda s: at(s)[1], xtol=1e-15, ftol=1e-15, gtol=1e-15).x
    return polished(statics, statics.moved(here, step))


def polished(statics: Statics, b: Balance) -> Balance:
    """Newton steps while they help, along directions with stiffness alone."""
    while b.residual > 0 and b.moving.size:
        there = within_reach(statics, b, newton_step(statics, b))
        if there is None or not there.residual < 0.9 * b.residual:
            break
        b = there
    return b


def newton_step(statics: Statics, b: Balance) -> np.ndarray:
    """The step (d,) of Newton's from `b`, along directions with stiffness alone."""
    force, K = statics.scaled(b)
    if not len(force):
        return force
    left, sizes, right = np.linalg.svd(K)
    resisted = sizes > NEUTRAL * max(1.0, sizes[0])
    return np.asarray(-right[resisted].T @ (left[:, resisted].T @ force / sizes[resisted]))
