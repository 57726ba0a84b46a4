"""Elastic gears between a rotor and the transmission that it drives.

The rotor is ahead of what the posture demands by ``e``, in units of the travel: ``theta / N = l(q) + e``. This e is a
coordinate that stands where other elastic drives have theta. The gear's spring ``k e`` and damper ``d edot`` are
columns like those of a mode, so every method takes them as it takes modes. The rotor's energy
``J_r N^2 (l' qdot + edot)^2 / 2`` couples e with the axis by the inertia ``J_r N^2 l'``; friction acts at the rate
``l' qdot + edot``. The effort F acts on the rotor, and so F on e and ``l' F`` on the axis. No value of ``l`` is needed,
a dead centre with ``l' = 0`` is a posture like others, and ``k -> inf`` is the rigid gear.

With ``F_g = k e + d edot`` the same equations are ``J_r N^2 (l + e)'' = F - F_g - friction`` for the rotor, and
``l' F_g`` on the axis: the lever turns with the posture, and ``l'' F_g`` is the geometric stiffness of the gear.
"""

from __future__ import annotations

from ..ir.derivative import columns
from ..ir.program import Array, Value
from ..spec.link_class import LinkClass
from . import matrices as mx
from .scope import Scope
from .travels import INERTIA, Cranks, cranks, kept, of_axis, rubs


def condensed(s: Scope, axis: int, effort: Value, m: Value, f: Value, inverse: Value) -> tuple[Value, ...]:
    """Eliminate the acceleration of an elastic gear: W and w in ``eddot = w - W qddot``, inertia and force of the axis.

    ``m``: the given inertia of e, ``J_r N^2`` and what an implicit method adds; ``inverse`` is 1 / m. Written with what
    is added, since the rotor's inertia drops out of the axis where nothing is.
    """
    own, found = s.constant(f"rotor_inertia_{axis + 1}"), kept(s)
    slope, share, rest = found.slope[axis], own * inverse, (m - own) * inverse
    pushed = effort - found.bias[axis]
    inertia = s.read("m_q")[axis] + own * rest * slope * slope
    force = slope * (pushed * rest + share * f) - s.read("f_q")[axis]
    return share * slope, (pushed - f) * inverse, inertia, force


def _couplings(s: Scope, slope: Array) -> Array:
    """The inertia (t,) that couples the gears of transmissions with their axes, 0 for other rotors."""
    of = lambda axis: s.constant(f"rotor_inertia_{axis + 1}") * slope[axis]  # noqa: E731
    return mx.array([of(axis) if axis in s.key.elastic_travels else 0.0 for axis in s.key.added_axes])


def carrying_along(s: Scope) -> Array:
    """The force (m,) on the axes by the accelerations of their elastic gears."""
    out, coupling = mx.zeros(s.key.joints), _couplings(s, kept(s).slope)
    for k, axis in enumerate(s.key.added_axes):
        if axis in s.key.elastic_travels:
            out[axis] = coupling[k] * s.read("thetaddot")[k]
    return out


def carried_along(s: Scope, qddot: Array) -> Array:
    """The force (t,) on elastic gears by the accelerations of their axes and by what acts along the travel."""
    found = kept(s)
    coupling = _couplings(s, found.slope)
    parts = [(coupling[k] * qddot[axis], found.bias[axis]) for k, axis in enumerate(s.key.added_axes)]
    return mx.array(
        [a + b if axis in s.key.elastic_travels else 0.0 for (a, b), axis in zip(parts, s.key.added_axes, strict=True)]
    )


def passed_on(s: Scope, axis: int, k: int, q: Array) -> Value:
    """The torque of an axis by the spring and the damper of its elastic gear, the motor ``k`` of the joint."""
    force = s.constant(f"rotor_stiffness_{axis + 1}") * s.read("theta")[k]
    if s.key.drives[axis].damping:
        force = force + s.constant(f"rotor_damping_{axis + 1}") * s.read("thetadot")[k]
    return of_axis(s, axis, q)[0] * force


# ------------------------------------------------------------------------------------ derivatives

GEAR_SLOPES = ("gear_M", "gear_q", "gear_qdot", "gear_back", "gear_own")
"""What elastic gears of transmissions add to the rows and columns of their coordinates, (t,) each."""


def slope_names(key: LinkClass) -> list[str]:
    """What transmissions add to the slopes of a link, see :func:`answers`."""
    return [INERTIA] * key.has_travelling_inertia + list(GEAR_SLOPES) * bool(key.elastic_travels)


def _gear_answers(s: Scope, coupling: Array, found: Cranks, asked: Array) -> None:
    """The inertia that couples e with the axis, and the derivatives of e's row with q, qdot and edot, and of the
    axis' with edot."""
    rows: list[list[Value]] = []
    for k, axis in enumerate(s.key.added_axes):
        if axis not in s.key.elastic_travels:
            rows.append([0.0] * len(GEAR_SLOPES))
            continue
        row = coupling[k] * s.read("qddot")[axis] + found.bias[axis]
        of = lambda y, name, at: columns([y], s.read(name)[at : at + 1])[0][0]  # noqa: E731
        by = [of(row, "q", axis), of(row, "qdot", axis)]
        rate = (of(asked[axis], "thetadot", k), of(row, "thetadot", k)) if rubs(s, axis) else (0.0, 0.0)
        rows.append([coupling[k], *by, *rate])
    for name, values in zip(GEAR_SLOPES, zip(*rows, strict=True), strict=True):
        s.write(f"w.{name}", mx.array(list(values)))


def answers(s: Scope) -> tuple[Array, Array]:
    """The derivatives (m, m) of what the transmissions ask of the joint, less their efforts, with q and with qdot."""
    m, q, qdot = s.key.joints, s.read("q"), s.read("qdot")
    if not s.key.travels:
        return mx.zeros(m, m), mx.zeros(m, m)
    found = cranks(s, q, qdot)
    s.write(f"w.{INERTIA}", found.inertia)
    asked = found.inertia * s.read("qddot") + found.force - found.slope * s.read("tau")
    if s.key.elastic_travels:
        coupling = _couplings(s, found.slope)
        for k, axis in enumerate(s.key.added_axes):
            asked[axis] = asked[axis] + coupling[k] * s.read("thetaddot")[k]
        _gear_answers(s, coupling, found, asked)
    both = (columns([asked[k] if k in s.key.travels else 0.0 for k in range(m)], x) for x in (q, qdot))
    with_q, with_qdot = (mx.array(x, (m, m)).T for x in both)
    return with_q, with_qdot
