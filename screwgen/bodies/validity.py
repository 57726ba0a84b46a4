"""The validity block: how far a link is from the limits of the first-order model.

The model assumes small deflections and neglects foreshortening, hence centrifugal stiffening and the P-delta effect.
Four numbers measure the neglected effects for a slender link clamped at its base. Each is a load over the load at
which the link would buckle, or stiffen by its own size.

``deflection``  transverse displacement of the tip over the length
``slope``       rotation of the tip section about the transverse axes, rad
``axial_load``  axial force over the buckling load, compression positive: ``4 l^2 N / (pi^2 EI)`` of the force at the
                tip and ``q l^3 / (7.837 EI)`` of the link's own mass, ``q = rhoA a_x``
``rotation``    ``Omega^2 rhoA l^4 / EI`` of the angular velocity about the transverse axes

EI is the smaller of the planes that have modes. Of a section that varies, EI is the smallest and rhoA the largest at
its stations, so that the measures are not too small. If frequencies are stated, it is that of the uniform beam with the
first of them. The force at the tip is the joint's axial force less the inertial force of the link and its base bodies.
Approximations: the link's own axial load is uniform, apart from ``rotation``; the axis is that of the straight link;
the next links are a mass at the tip. Where modes shear, EI is that of the rod without shear which buckles under the
same force at its tip, Haringx's ``P (1 + P/GA) = pi^2 EI / 4 l^2``.
"""

from __future__ import annotations

import numpy as np

from ..algebra.expression import Expression, Inverse, Root, Symbol, number
from ..ir.block import Block
from ..lazily import sp
from ..reduction.invariants import Invariants
from ..spec.link_class import LinkClass
from .fields import Fields, length
from .reduced import numeral, numerals
from .varying_rod import acting

OWN_WEIGHT = 7.8373474
"""``q l^3 / EI`` at which a cantilever buckles under its own weight: 9/4 of the squared first zero of J_(-1/3)."""
PLANES = {"bending_y": "EIz", "bending_z": "EIy"}
SHEAR = {"bending_y": ("shear_y", "GAy"), "bending_z": ("shear_z", "GAz")}
BOUNDS = {"deflection": 0.1, "slope": 0.35, "axial_load": 0.02, "rotation": 0.2}
"""The steps of the measures, in the order of all back ends, each with its bound: the value at which the error is about
1 % of the tip deflection (``36/35 deflection^2``, ``slope^2/12``, from the elastica under a tip force and a tip
moment) or of the lowest frequency (``sqrt(1 - axial_load)``, ``sqrt(1 + 1.193 rotation / 12.362)``)."""
MEASURES = tuple(BOUNDS)


def validity_block(key: LinkClass) -> Block:
    """The measures of a link; a link without bending modes has none, and its block no steps.

    Of a body from a file deflection and slope are measured, across the line from base to tip. Its file does not say
    which loads buckle or stiffen it.
    """
    b = Block("validity", "Limits of the model")
    if key.elastic is not None and key.bends:
        _tip(b, key, number(numeral(key.elastic.reach)), across(key.elastic))
    elif key.bends:
        l = length(b, key)
        fields = Fields(key, b.values[l.name].item(), 0)
        _tip(b, key, l, (fields.tip()[1:], fields.rotation()[1:]))
        if key.lacks_geometric_stiffness:
            _loads(b, key, l)
    return b


def across(body: Invariants) -> tuple[np.ndarray, np.ndarray]:
    """(2, r) each: displacement and rotation of the tip by each mode across the line from base to tip."""
    line = body.tip.origin - body.base.origin
    normal = np.linalg.svd(line[None])[2][1:]
    phi, psi = (np.array([numerals(row) for row in normal @ x], dtype=object) for x in (body.tip.phi, body.tip.psi))
    return phi, psi


def _tip(b: Block, key: LinkClass, length: Expression, shapes: tuple[np.ndarray, np.ndarray]) -> None:
    """Displacement over length and slope of the tip section, of whose shapes two rows are given."""
    eta = b.input("eta", (key.modes, 1))
    fields = (r"\boldsymbol{\phi}_i(c_i)", r"\boldsymbol{\Psi}_i(c_i)")
    for name, rows, field in zip(("deflection", "slope"), shapes, fields, strict=True):
        tip = b.step(f"{name}_T", b.field(f"{name}_shapes", rows, field) @ eta)
        size: Expression = Root(b.step(f"{name}_2", tip.T @ tip))
        b.step(name, Inverse(length) @ size if name == "deflection" else size)


def _tip_load() -> sp.Expr:
    """``N l^2 / EI`` at which a cantilever buckles under a force at its tip."""
    return sp.pi**2 / 4


def _loads(b: Block, key: LinkClass, length: Symbol) -> None:
    """Axial load over buckling load, and the dimensionless square of the angular velocity."""
    rhoA = _largest_mass(b, key)
    omega = b.input("omega_t", (2, 1))
    a_x = b.input("a_x", (1, 1))
    F_x = b.input("F_x", (1, 1))
    F_own = b.input("F_own", (1, 1))
    softness = length @ length @ _compliance(b, key, length, rhoA)
    per_force = b.step("per_force", (1 / _tip_load()) * softness)
    mass = rhoA @ length
    weight = (1 / sp.Float(OWN_WEIGHT)) * (mass @ softness)
    per_a = b.step("per_acceleration", weight)
    per_turn = b.step("per_turn", mass @ length @ softness)
    square = omega.T @ omega
    Omega_2 = b.step("Omega_2", square)
    a_B: Expression = a_x
    if key.frame_at:
        frame_at = b.parameter("frame_at", (1, 1))
        a_B = a_x + frame_at @ Omega_2
    load = per_force @ (F_x - F_own) + per_a @ a_B
    b.step("axial_load", load)
    b.step("rotation", per_turn @ Omega_2)


def _compliance(b: Block, key: LinkClass, length: Symbol, rhoA: Symbol) -> Expression:
    """``1/EI`` of the softer plane that has modes, as ``(1 + r + |1 - r|) / (2 EI)`` with r the ratio of the two."""
    planes = [d for d in PLANES if key.counts[1 + list(PLANES).index(d)]]
    stiff = [EI for d in planes for EI in _stiffness(b, key, d, length, rhoA)]
    if len(stiff) == 1:
        return Inverse(stiff[0])
    larger: Expression = number(1)
    for k, EI in enumerate(stiff[1:]):
        tag = str(k + 1) if len(stiff) > 2 else ""
        what = "bending stiffness, y over z" if not tag else f"first bending stiffness over number {k + 2}"
        ratio = b.step(f"EI_ratio{tag}", stiff[0] @ Inverse(EI), "r_i", unit="-", meaning=what)
        larger = _larger(b, larger, ratio, f"EI_gap{tag}", "(1-r_i)^2", "relative difference of EIy and EIz, squared")
        if tag:
            larger = b.step(f"EI_bound{tag}", larger, "r_i", unit="-", meaning="largest of the ratios so far")
    return b.step("compliance", larger @ Inverse(stiff[0]))


def _larger(b: Block, first: Expression, second: Symbol, gap: str, display: str, meaning: str) -> Expression:
    """The larger of two positive numbers, ``(a + b + sqrt((a - b)^2)) / 2``."""
    square = (first - second) @ (first - second)
    root = Root(b.step(gap, square, display, unit="-", meaning=meaning))
    return sp.Rational(1, 2) * (first + second + root)


def _largest_mass(b: Block, key: LinkClass) -> Symbol:
    """Mass per length; the largest at the stations of a section that varies."""
    if not key.stations:
        return b.parameter("rhoA", (1, 1))
    first, *others = acting(b, key, "rhoA")
    largest: Expression = number(1)
    for k, rhoA in enumerate(others):
        ratio = b.step(
            f"mass_ratio{k + 1}", rhoA @ Inverse(first), "m_i", unit="-", meaning="mass per length, relative"
        )
        bound = _larger(b, largest, ratio, f"mass_gap{k + 1}", "(1-m_i)^2", "relative difference of rhoA, squared")
        largest = b.step(f"mass_bound{k + 1}", bound, "m_i", unit="-", meaning="largest of the ratios so far")
    return b.step("rhoA_max", largest @ first, r"\rho_iA_i", unit="kg/m", meaning="largest mass per length")


def _stiffness(b: Block, key: LinkClass, direction: str, length: Symbol, rhoA: Symbol) -> list[Symbol]:
    """EI of a plane, at every station where it varies; smaller where modes shear.

    If frequencies are stated it is ``rhoA (2 pi f_1)^2 l^4 / lambda_1^4`` of the first.
    """
    name, (shear, resisting) = PLANES[direction], SHEAR[direction]
    if direction not in key.measured:
        values = lambda x: acting(b, key, x) if key.stations else [b.parameter(x, (1, 1))]  # noqa: E731
        if not any(d == shear for d, _ in key.directions) or shear in key.measured:
            return values(name)
        pairs = zip(values(name), values(resisting), strict=True)
        return [_sheared(b, f"{name}_sheared{k or ''}", EI, GA, length) for k, (EI, GA) in enumerate(pairs)]
    count = key.counts[1 + list(PLANES).index(direction)]
    f = b.parameter(f"frequencies_{direction}", (count, 1))
    first, own = b.entries(f)[0], rhoA @ length @ length @ length @ length
    factor = 4 * sp.pi**2 / sp.Float(float(key.shapes(direction).stiffness[0]))
    return [b.step(f"{name}_first", factor * (own @ first @ first))]


def _sheared(b: Block, name: str, EI: Symbol, GA: Symbol, length: Symbol) -> Symbol:
    """``2 EI / (1 + sqrt(1 + 4 P/GA))`` of Euler's load P: with it Euler's load is Haringx's."""
    quotient = (4 * _tip_load()) * (EI @ Inverse(length @ length @ GA))
    share = number(2) @ Inverse(number(1) + Root(number(1) + quotient))
    meaning = "bending stiffness of the rod without shear that buckles at the same load"
    return b.step(name, share @ EI, r"EI_{\gamma,i}", unit="N*m^2", meaning=meaning)
