"""A four-bar linkage as a transmission: the crank's angle by the posture of the link that it drives.

In the plane of the joint, with the ground line from the joint axis to the crank's pivot ``P = (g, 0)``, the pin of the
rocker is ``A = r (cos u, sin u)`` with ``u = q + angle``, that of the crank ``B = P + b`` with
``b = c (cos psi, sin psi)``. The coupler keeps ``|B - A| = k``, which is Freudenstein's equation. With ``d = A - P``
and ``D = |d|``

    W = 2 b.d = D^2 + c^2 - k^2        H = 2 |d x b| = sqrt(((c + k)^2 - D^2) (D^2 - (c - k)^2))

so ``b = (W d + s H J d) / (2 D^2)``, with ``J`` a quarter turn and ``s = 1`` where B is left of the line from P to A.
The constraint differentiated once and twice gives

    psi' = 2 s (A x B) / H        psi'' = 2 s (2 psi' A.b - A.B - psi'^2 W / 2) / H

``H = 2 c k |sin mu|`` with mu between crank and coupler: where both are in line ``psi'`` is infinite, and beyond it
nothing is real.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import acos, atan2, cos, inf, pi, remainder, sin, sqrt
from typing import Any, ClassVar

from .added import Added
from .law import Key, Value
from .travel import Travel, TravelSlopes

IN_LINE = 0.05
"""rad: so far before its dead centre a linkage ends behind an elastic gear, as the joint would run into it."""
ROUND = 1e-9
"""A cosine so near to ±1 counts as that: the linkage folds flat there."""


def _length(meaning: str, symbol: str) -> Key:
    return Key("m", "m", meaning, symbol, "positive")


@dataclass(frozen=True)
class FourBarLinkage(Travel):
    """The travel is the angle psi of the crank, rad, its effort the torque there, N·m.

    ``side``: 1 where the crank's pin is left of the line from its pivot to the rocker's pin, else -1.
    """

    side: int

    TABLE = "four_bar."
    KEYS: ClassVar = {
        "ground": _length("distance of the crank's pivot from the joint axis", "g_0"),
        "crank": _length("length of the crank", "a_0"),
        "coupler": _length("length of the rod between crank and link", "k_0"),
        "rocker": _length("distance of the coupler's pin on the link from the joint axis", "r_0"),
        "angle": Key("rad", "rad", "angle from the ground line to the rocker at q = 0", r"\beta_0"),
    }
    WORD, PLURAL, SHORT, PART = "four-bar linkage", "four-bar linkages", "linkage", "crank"
    EFFORT, EFFORT_NAME, EFFORT_UNIT = "torque at the crank", "torque", "N·m"
    EFFORTS = "torques at cranks where linkages drive joints"
    EFFORT_NOTE = "; at the crank where a linkage drives it"
    LEVER_UNIT = "1"
    ADDED = Added("gear", "rad", "Rotors ahead of their cranks", "e")
    UNITS: ClassVar = {
        "joint.drives.ratio": ("1", "turns of the rotor per turn of the crank"),
        "joint.drives.stiffness": ("N·m/rad", "stiffness of the gear along the travel of its transmission"),
        "joint.drives.damping": ("N·m·s/rad", "damping of the gear along the travel of its transmission"),
    }
    LETTERS = (r"\psi", r"\tau_c")
    SYMBOLS = (
        (r"\psi", "angle of the crank that drives an axis; primes are derivatives with q", "rad", True),
        (r"\tau_c", "torque at the crank", "N*m", True),
        (r"g_0, a_0, k_0, r_0", "lengths of ground, crank, coupler, rocker of its linkage", "m", False),
        (r"\beta_0", "angle from the ground line to the rocker at q = 0", "rad", False),
    )
    EQUATIONS = (
        r"""
A four-bar linkage joins its axis with a crank of length $a_0$, whose pivot on the carrier is at the distance $g_0$ from
the joint axis, by a coupler of length $k_0$ to a pin on the link, at the distance $r_0$ from the joint axis. With the
rocker's angle $u = q + \beta_0$ and the crank's angle $\psi(q)$, both from the ground line, Freudenstein's equation

$$
k_0^2 &= g_0^2 + a_0^2 + r_0^2 + 2\,g_0\,a_0\cos\psi - 2\,g_0\,r_0\cos u"""
        r""" - 2\,a_0\,r_0\cos\left( \psi - u \right)
$$

holds in every posture. Of its two solutions the sign $\sigma$ in the table of transmissions chooses one, and its
derivatives with $q$ follow: with $x_0 = r_0\cos u - g_0$ and $y_0 = r_0\sin u$, from the crank's pivot to the rocker's
pin,

$$
D &= x_0^2 + y_0^2, & \quad W &= D + a_0^2 - k_0^2, & \quad H &= \sqrt{4\,D\,a_0^2 - W^2}
a_0\,\cos\psi &= \frac{W\,x_0 - \sigma\,H\,y_0}{2\,D}, & \quad a_0\,\sin\psi &= \frac{W\,y_0 + \sigma\,H\,x_0}{2\,D}
\psi' &= \frac{r_0}{a_0}\,\frac{g_0\,\sin u + a_0\,\sin\left( u - \psi \right)}{g_0\,\sin\psi"""
        r""" - r_0\,\sin\left( \psi - u \right)}
\psi'' &= \frac{2\,\sigma}{H}\,\left( a_0\,r_0\,(2\,\psi' - 1)\,\cos\left( \psi - u \right) -"""
        r""" g_0\,r_0\,\cos u - \tfrac{1}{2}\,\psi'^2\,W \right)
\tau_q &= \psi'\,(\tau_c - \tau_f) - J_r\,N^2\,\psi'\,\psi''\,\dot{q}^2, & \quad w &= \psi'\,\dot{q}, & \quad j_m"""
        r""" &\leftarrow j_m + J_r\,N^2\,\psi'^2
$$

Here $\tau_c$ is the torque at the crank, which is the input of the axis. The rotor turns by $N$ per turn of the crank.
"""
    )

    def slopes(self, t: Any, q: Value, *numbers: Value, elastic: bool = False) -> TravelSlopes:
        """The room is ``sin² mu``, less the rounding, times ``4 c² k²``.

        ``elastic``: less ``sin² IN_LINE``, and the derivatives themselves are no numbers where that is negative.
        ``far = (c + k)² - D²`` and ``near = D² - (c - k)²`` lose no digits where the linkage folds flat.
        """
        ground, crank, coupler, rocker, angle = numbers
        half = 0.5 * (q + angle)
        sine, cosine = t.call("sin", half), t.call("cos", half)
        chord, across = 2.0 * rocker * (sine * sine), 2.0 * rocker * (sine * cosine)
        A_x, d_x, gap, span = rocker - chord, (rocker - ground) - chord, ground - rocker, ground + rocker
        area = 4.0 * ground * rocker
        high = area * (sine * sine)
        square = gap * gap + high
        total, apart, product = crank + coupler, crank - coupler, 2.0 * crank * coupler
        W = square + apart * total
        far = (total - span) * (total + span) + area * (cosine * cosine)
        near = (gap - apart) * (gap + apart) + high
        room = far * near
        spare = room - sin(IN_LINE) ** 2 * product * product if elastic else room
        H = t.call("sqrt", spare) * t.call("sqrt", room / spare) if elastic else t.call("sqrt", room)
        along, aside = 0.5 * W / square, 0.5 * self.side * H / square
        b_x, b_y = along * d_x - aside * across, along * across + aside * d_x
        turn, inner = A_x * b_y - across * (b_x + ground), A_x * b_x + across * b_y
        slope = 2.0 * self.side * turn / H
        curve = 2.0 * self.side * (2.0 * slope * inner - (inner + ground * A_x) - 0.5 * (slope * slope) * W) / H
        return TravelSlopes(slope, curve, spare - 64.0 * t.epsilon() * product * product)

    def travel(self, q: float, *numbers: float) -> float:
        """``psi``: the direction of d and an angle of the triangle P, A, B; without leaps as q goes round."""
        ground, crank, coupler, rocker, angle = numbers
        u = q + angle
        if ground > rocker:
            way = -self.side * pi - atan2(rocker * sin(u), ground - rocker * cos(u))
        else:
            way = u + atan2(ground * sin(u), rocker - ground * cos(u))
        gap, span, apart, total = ground - rocker, ground + rocker, crank - coupler, crank + coupler
        high, low = (4.0 * ground * rocker * f(u / 2) ** 2 for f in (sin, cos))
        room = ((total - span) * (total + span) + low) * ((gap - apart) * (gap + apart) + high)
        return way + self.side * atan2(sqrt(room), gap * gap + high + apart * total)

    def reach(self, *numbers: float) -> tuple[float, float]:
        """The coordinates between which crank and coupler reach the link from its posture at q = 0.

        Ends are dead centres, in which crank and coupler are in line; infinite where the link can go round. Empty, with
        the upper end below the lower, where they do not reach it at q = 0.
        """
        ground, crank, coupler, rocker, angle = numbers
        start = remainder(angle, 2 * pi)
        cosine = lambda apart: (ground**2 + rocker**2 - apart**2) / (2 * ground * rocker)  # noqa: E731
        near, far = cosine(abs(crank - coupler)), cosine(crank + coupler)
        least = acos(min(max(near, -1.0), 1.0)) if near < 1 + ROUND else -inf
        most = acos(max(min(far, 1.0), -1.0)) if far > -1 - ROUND else inf
        if not least < abs(start) < most:
            return inf, -inf
        if least < 0:
            return -most - start, most - start
        outer = 2 * pi - least if most == inf else most
        return (least - start, outer - start) if start > 0 else (-outer - start, -least - start)

    def limit(self, elastic: bool) -> str:
        said = "out of the reach of its four-bar linkage, which ends where crank and coupler are in line"
        return said + f", with an elastic gear {IN_LINE:g} rad before that" * elastic
