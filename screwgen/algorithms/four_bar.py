"""The four-bar linkage as a transmission: the crank's angle by the posture of the link that it drives.

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

import math

from ..ir.program import Tracer, Value

IN_LINE = 0.05
"""rad: so far before its dead centre a linkage ends behind an elastic gear, as the joint would run into it."""


def slopes(
    s: int,
    t: Tracer,
    q: Value,
    ground: Value,
    crank: Value,
    coupler: Value,
    rocker: Value,
    angle: Value,
    elastic: bool = False,
) -> tuple[Value, Value, Value]:
    """``psi'``, ``psi''``, and what must be > 0: ``sin^2 mu``, less the rounding, times ``4 c^2 k^2``.

    ``elastic``: less ``sin^2 IN_LINE``, and the derivatives themselves are no numbers where that is negative.
    ``far = (c + k)^2 - D^2`` and ``near = D^2 - (c - k)^2`` lose no digits where the linkage folds flat.
    """
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
    spare = room - math.sin(IN_LINE) ** 2 * product * product if elastic else room
    H = t.call("sqrt", spare) * t.call("sqrt", room / spare) if elastic else t.call("sqrt", room)
    along, aside = 0.5 * W / square, 0.5 * s * H / square
    b_x, b_y = along * d_x - aside * across, along * across + aside * d_x
    turn, inner = A_x * b_y - across * (b_x + ground), A_x * b_x + across * b_y
    slope = 2.0 * s * turn / H
    curve = 2.0 * s * (2.0 * slope * inner - (inner + ground * A_x) - 0.5 * (slope * slope) * W) / H
    return slope, curve, spare - 64.0 * t.epsilon() * product * product


def turn(s: int, q: float, ground: float, crank: float, coupler: float, rocker: float, angle: float) -> float:
    """``psi``, rad: the direction of d and an angle of the triangle P, A, B; without leaps as q goes round.

    Raises ValueError where the linkage does not reach the link.
    """
    u = q + angle
    if ground > rocker:
        way = -s * math.pi - math.atan2(rocker * math.sin(u), ground - rocker * math.cos(u))
    else:
        way = u + math.atan2(ground * math.sin(u), rocker - ground * math.cos(u))
    gap, span, apart, total = ground - rocker, ground + rocker, crank - coupler, crank + coupler
    high, low = (4.0 * ground * rocker * f(u / 2) ** 2 for f in (math.sin, math.cos))
    room = ((total - span) * (total + span) + low) * ((gap - apart) * (gap + apart) + high)
    return way + s * math.atan2(math.sqrt(room), gap * gap + high + apart * total)
