"""Mass, centre of mass and momentum of the whole robot: phases that add up those of its links, and the functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from ..errors import SingularError
from ..ir.program import Array, Value
from ..topology.chain import Chain
from . import matrices as mx
from . import motions as mo
from .schedule import OUTWARD, Algorithm, Phase
from .scope import Scope


def mass_moment(s: Scope) -> None:
    """Mass and first moment of one link with its bodies, about the origin of the inertial frame, in its axes."""
    m, S = s.lower("link", _state(s, mx.zeros(6), mx.zeros(s.key.modes)), "m", "S")
    m_T, S_T, _ = _tip_bodies(s)
    at_frame = m.item() * s.read("r") + mx.multiply(s.read("R"), S)
    s.write("mass", [m.item() + m_T])
    s.write("mass_moment", at_frame + m_T * s.read("tip.r") + mx.multiply(s.read("tip.R"), S_T))


def momentum(s: Scope) -> None:
    """Angular momentum of one link with its bodies about the origin of the inertial frame, and linear momentum."""
    twist, etadot = s.kept("twist"), s.read("etadot")
    m, S, I, M_D = s.lower("link", _state(s, twist, etadot), "m", "S", "I", "M_D")
    own = mx.multiply(_inertia(m.item(), S, I), twist) + mx.multiply(M_D, etadot)
    V_T = np.concatenate([s.read("tip.omega_T"), s.read("tip.v_T")])
    of_tip = mx.multiply(_inertia(*_tip_bodies(s)), V_T)
    s.write("momentum", _moved(s.read("R"), s.read("r"), own) + _moved(s.read("tip.R"), s.read("tip.r"), of_tip))


def _state(s: Scope, twist: Array, etadot: Array) -> dict[str, Array]:
    """The state of the link block, in which nothing weighs."""
    return {"omega": twist[:3], "v": twist[3:], "g": mx.zeros(3), "eta": s.read("eta"), "etadot": etadot}


def _tip_bodies(s: Scope) -> tuple[Value, Array, Array]:
    """Mass, first moment and inertia of the bodies at the tip, about its point, in its axes."""
    rest = {"omega_T": mx.zeros(3), "v_T": mx.zeros(3), "g_T": mx.zeros(3)}
    m, S, I = s.lower("tip_body", rest, "m_T", "S_T", "I_T")
    return m.item(), S, I


def _inertia(m: Value, S: Array, I: Array) -> Array:
    """The spatial inertia (6, 6) of a body with mass, first moment and inertia."""
    return mx.blocks(I, mx.hat(S), mx.identity(3) * m)


def _moved(R: Array, r: Array, momentum: Array) -> Array:
    """A momentum (6,) about the point ``r`` in the axes R as that about the origin in inertial axes."""
    angular, linear = mx.multiply(R, momentum[:3]), mx.multiply(R, momentum[3:])
    return np.concatenate([angular + mx.cross(r, linear), linear])


CENTRED: Algorithm = (Phase(mo.poses, OUTWARD), Phase(mass_moment, OUTWARD))
MOMENTUM: Algorithm = (Phase(mo.velocities, OUTWARD), Phase(mo.poses, OUTWARD), Phase(momentum, OUTWARD))


class MomentumFunctions:
    """What :class:`.functions.Functions` has besides for the whole mass; the attributes are set there."""

    chain: Chain
    _run: Callable[..., tuple[list, list]]
    motion: Callable[..., list[dict[str, list]]]

    def centre_of_mass(self, q: Sequence) -> tuple[Value, list]:
        """The mass of the robot, and the place (3) of its centre in the inertial frame."""
        links, _ = self._run(CENTRED, self.chain.split(q, "q", "eta"))
        (mass,) = _sum(links, "mass")
        return mass, [x / self._not_zero(mass) for x in _sum(links, "mass_moment")]

    def momentum(self, q: Sequence, v: Sequence) -> list:
        """The angular momentum of the robot about the origin of the inertial frame, and its linear momentum (6)."""
        return _sum(self._run(MOMENTUM, self.motion(q, v))[0], "momentum")

    def centre_of_mass_jacobian(self, q: Sequence) -> list:
        """(3, nv), row by row: the velocity of the centre of mass per unit of each entry of v."""
        units = np.eye(self.chain.nv).tolist()
        mass = self._not_zero(self.centre_of_mass(q)[0])
        columns = [self.momentum(q, unit)[3:] for unit in units]
        return [x / mass for row in zip(*columns, strict=True) for x in row]

    def _not_zero(self, mass: Value) -> Value:
        if isinstance(mass, float | int) and not mass > 0:
            raise SingularError(f"robot '{self.chain.robot.name}' has no mass, so that it has no centre of mass")
        return mass


def _sum(links: Sequence[Mapping[str, list]], name: str) -> list:
    """The sum over all links of what each computed."""
    total = list(links[0][name])
    for link in links[1:]:
        total = [a + b for a, b in zip(total, link[name], strict=True)]
    return total
