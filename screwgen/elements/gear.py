"""The gear between a rotor and its axis, rigid or elastic, and the spring and damper of the axis itself.

The rotor of an elastic gear has the angle ``theta``, inertia ``J`` and ratio ``N``; the gear has stiffness ``k`` and
damping ``d`` at the joint. With ``tau_J = k (theta/N - q) + d (thetadot/N - qdot)`` the equations are
``J thetaddot = tau - tau_J/N - friction`` for the rotor, whose energy is that of its own spin alone, and ``tau_J``
takes the place of the torque in the joint's rows. Along a transmission the coordinate is how far the rotor is ahead of
the travel, so that spring and damper of the gear act on it alone, and the posture couples it with the axis
(:mod:`.travel`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from . import friction
from .added import Added, Linear, Stated, Terms
from .travel import Travel

ROTOR = Added("theta", "rad", "Rotor angles", "θ")


def added_by(travel: Travel | None) -> Added:
    """The coordinate that an elastic gear adds: the rotor's angle, or how far it is ahead of a travel."""
    return ROTOR if travel is None else travel.ADDED


def travelling(stated: Stated) -> Any:
    """The inertia of a rotor as what it drives feels it, an axis or the travel of a transmission."""
    return stated("ratio") * stated("ratio") * stated("rotor_inertia")


RIGID = Linear(Terms(travelling, damping=lambda stated: stated("viscous")))
"""A rotor that turns with its axis, and viscous friction there."""

ELASTIC = Linear(
    axis=Terms(stiffness=lambda stated: stated("stiffness"), damping=lambda stated: stated("damping")),
    added=Terms(
        inertia=lambda stated: stated("rotor_inertia"),
        stiffness=lambda stated: stated("stiffness") / (stated("ratio") * stated("ratio")),
        damping=lambda stated: stated("damping") / (stated("ratio") * stated("ratio")) + stated("viscous"),
    ),
    between=Terms(
        stiffness=lambda stated: -(stated("stiffness") / stated("ratio")),
        damping=lambda stated: -(stated("damping") / stated("ratio")),
    ),
)
"""A rotor behind an elastic gear."""

ALONG_TRAVEL = Linear(added=Terms(travelling, lambda stated: stated("stiffness"), lambda stated: stated("damping")))
"""An elastic gear between a rotor and the travel that it drives."""


def linear(elastic: bool, travel: Travel | None) -> Linear:
    """What the gear of a drive is, beside the transmission if it has one; ``ratio`` is 1 where it is not stated."""
    if travel is None:
        return ELASTIC if elastic else RIGID
    return ALONG_TRAVEL if elastic else Linear()


LETTERS = {"ratio": "N", "rotor_inertia": "J_r", "stiffness": "k", "damping": "d"}
"""The letters of the keys of a drive in formulas."""

SYMBOLS = (
    (r"\vartheta", "angle of the rotor of an elastic drive", "rad", True),
    (r"\tau_q", "what acts on an axis, of slides a force; one of the entries of τ_{q,i}", "N*m", True),
    (r"\tau_J", "torque that the gear passes on, of slides a force", "N*m", True),
    (r"N", "ratio of the gear, of slides in rad/m", "-", False),
    (r"J_r", "inertia of the rotor", "kg*m^2", False),
    (r"k, d", "stiffness and damping of the gear at the joint", "N*m/rad, N*m*s/rad", False),
)
TRAVEL_SYMBOLS = (
    (r"e", "travel by which a rotor behind an elastic gear is ahead, of linkages in rad", "m", True),
    (r"F_g", "force of the gear along it, of linkages a torque; so are its k and d", "N", True),
)
"""Symbol, meaning, unit of what documents name, and whether it is a state; without, and with a transmission."""

EQUATIONS = (
    r"""
A drive whose gear is elastic has the angle $\vartheta$ of its rotor as a coordinate of its own, and its torque $\tau$
acts on the rotor, whose kinetic energy is that of its own spin alone:

$$
J_r\,\ddot{\vartheta} &= \tau - \frac{\tau_J}{N} - \tau_f, & \quad \tau_J &= k\,\left( \frac{\vartheta}{N} - q"""
    r""" \right) + d\,\left( \frac{\dot{\vartheta}}{N} - \dot{q} \right), & \quad \tau_f &= FRICTION
$$

with the gear's stiffness $k$ and damping $d$ at the joint and friction at the rate $w$ of what the torque acts on, here
$w = \dot{\vartheta}$. What a drive does not state is zero, but $N = 1$CONSTANT. In the joint's rows the gear's $k$
and $d$ are part of $\mathbf{K}_q$ and $\mathbf{D}_q$, and what acts on the axis is

$$
\tau_q &= \frac{k\,\vartheta + d\,\dot{\vartheta}}{N}, & \quad k_q &\leftarrow k_q + k, & \quad d_q &\leftarrow d_q + d
$$

A rigid gear adds to the armature, and its torque and friction act on the joint, at the rate $w = \dot{q}$:

$$
\tau_q &= \tau - \tau_f, & \quad j_m &\leftarrow j_m + J_r\,N^2
$$
"""
)


def equations(size: friction.Size, bends: bool) -> str:
    """The section of drives in documents; ``size``, ``bends``: see :func:`.friction.formula`."""
    text = EQUATIONS.replace("FRICTION", friction.formula(size, bends))
    return text.replace("CONSTANT", friction.unstated(size))


def travel_equations(kinds: Sequence[Travel]) -> str:
    """That of elastic gears behind transmissions, in the letters of the first kind."""
    first, *others = (kind.LETTERS for kind in kinds)
    place = "stand in the place of ${}$ and ${}$.".format(*first)
    words = zip(kinds[1:], others, strict=True)
    end = "".join(f"\n\nOf a {kind.SHORT} ${travel}$ and ${effort}$ {place}" for kind, (travel, effort) in words)
    return TRAVEL_EQUATIONS.replace("TRAVEL", first[0]).replace("EFFORT", first[1]) + end


TRAVEL_EQUATIONS = (
    r"""
Where the gear of such a drive is elastic, its rotor is ahead of the travel $TRAVEL$ that the posture demands by $e$, a
coordinate of its own in the place of $\vartheta = N\,(TRAVEL + e)$. Its rotor is then no part of $\mathbf{J}_m$, and on
the axis acts the force of the gear alone:

$$
J_r\,N^2\,\left( TRAVEL'\,\ddot{q} + TRAVEL''\,\dot{q}^2 + \ddot{e} \right) &= EFFORT - \tau_f - F_g, & \quad"""
    r""" F_g &= k\,e + d\,\dot{e}, & \quad \tau_q &= TRAVEL'\,F_g, & \quad w &= TRAVEL'\,\dot{q} + \dot{e}
$$
"""
)
