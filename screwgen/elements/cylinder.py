"""A cylinder from an eye on the carrier, at the distance ``base`` from the joint axis, to one on the link.

``l² = (base - crank)² + 4 base crank sin²(u / 2)`` with ``u = q + angle`` loses no digits where it is short.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

from .added import Added
from .law import Key, Value
from .travel import Travel, TravelSlopes


@dataclass(frozen=True)
class Cylinder(Travel):
    """The travel is its length, m, its effort the force that extends it, N; at zero length nothing is finite."""

    TABLE = ""
    KEYS: ClassVar = {
        "crank": Key("m", "m", "distance of the cylinder's eye on the link from the joint axis", "c_0", "positive"),
        "base": Key("m", "m", "distance of the cylinder's eye on the carrier from the joint axis", "b_0", "positive"),
        "angle": Key("rad", "rad", "angle between the eyes of the cylinder at q = 0", r"\alpha_0"),
    }
    WORD, PLURAL, SHORT, PART = "cylinder", "cylinders", "cylinder", "cylinder"
    EFFORT, EFFORT_NAME, EFFORT_UNIT = "force", "force", "N"
    EFFORTS = "forces of cylinders"
    EFFORT_NOTE = "; N where a cylinder drives it"
    LEVER_UNIT = "m"
    ADDED = Added("stretch", "m", "Rotors ahead of their cylinders", "e")
    UNITS: ClassVar = {
        "joint.drives.ratio": ("rad/m", "turn of the rotor per travel of the cylinder"),
        "joint.drives.rotor_inertia": ("kg", "mass that moves with the drive"),
        "joint.drives.stiffness": ("N/m", "stiffness of the gear along the travel of its transmission"),
        "joint.drives.damping": ("N·s/m", "damping of the gear along the travel of its transmission"),
    }
    IS_LENGTH = True
    LETTERS = ("l", "F")
    SYMBOLS = (
        (r"l", "length of the cylinder that drives an axis; primes are derivatives with q", "m", True),
        (r"F", "force of the cylinder, positive where it extends it", "N", True),
        (r"b_0, c_0", "distances of the cylinder's eyes on carrier and link from the joint axis", "m", False),
        (r"\alpha_0", "angle between the eyes at q = 0", "rad", False),
    )
    EQUATIONS = (
        r"""
A cylinder of length $l(q)$ between an eye on the carrier, at the distance $b_0$ from the joint axis, and one on the
link, at the distance $c_0$, acts on its joint through the lever $l' = \partial l/\partial q$:

$$
l &= \sqrt{b_0^2 + c_0^2 - 2\,b_0\,c_0\,\cos(q + \alpha_0)}, & \quad l' &="""
        r""" \frac{b_0\,c_0\,\sin(q + \alpha_0)}{l}, & \quad l'' &= \frac{b_0\,c_0\,\cos(q + \alpha_0) - l'^2}{l}
\tau_q &= l'\,(F - \tau_f) - J_r\,N^2\,l'\,l''\,\dot{q}^2, & \quad w &= l'\,\dot{q}, & \quad j_m &\leftarrow j_m +"""
        r""" J_r\,N^2\,l'^2
$$

Here $F$ is the force of the cylinder, positive where it extends it, which is the input of the axis. The rotor turns by
$N$ per travel.
"""
    )

    def length(self, t: Any, q: Value, *numbers: Value) -> Value:
        return self._triangle(t, q, *numbers)[-1]

    @staticmethod
    def _triangle(t: Any, q: Value, crank: Value, base: Value, angle: Value) -> tuple[Value, Value, Value, Value]:
        """Sine and cosine of half the angle between the eyes, the product of their distances, and the length."""
        half = 0.5 * (q + angle)
        sine, cosine = t.call("sin", half), t.call("cos", half)
        area, gap = base * crank, base - crank
        return sine, cosine, area, t.call("sqrt", gap * gap + 4.0 * area * (sine * sine))

    def slopes(self, t: Any, q: Value, *numbers: Value, elastic: bool = False) -> TravelSlopes:
        sine, cosine, area, length = self._triangle(t, q, *numbers)
        slope = 2.0 * area * (sine * cosine) / length
        return TravelSlopes(slope, (area * (1.0 - 2.0 * (sine * sine)) - slope * slope) / length, 1.0)

    def travel(self, q: float, *numbers: float) -> float:
        crank, base, angle = numbers
        return math.hypot(base - crank * math.cos(q + angle), crank * math.sin(q + angle))


CYLINDER = Cylinder()
