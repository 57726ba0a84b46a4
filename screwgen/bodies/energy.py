"""The energy block of a link."""

from __future__ import annotations

from ..algebra.expression import zeros
from ..ir.block import Block
from ..lazily import sp
from ..spec.link_class import LinkClass
from .exact import link_block


def energy_block(key: LinkClass) -> Block:
    """Kinetic energy of a link with its base bodies, its strain energy, and its mass moments for gravity.

    ``kinetic = 1/2 ∫ rho A |v + omega x rho + udot|^2 dξ + 1/2 ∫ (omega + thetadot)^T rho I (omega + thetadot) dξ``,
    ``stress = 1/2 eta^T K eta``; the gravitational potential is ``-g . (m r + R S)``.
    """
    b = link_block(key)
    b.name, b.title = "energy", "Energy"
    kinetic = b.twice_kinetic()
    half = sp.Rational(1, 2)
    b.step("kinetic", half * kinetic)
    stress = b.eta.T @ (b.body.stiffness @ b.eta) if key.modes else zeros(1)
    b.step("stress", half * stress)
    return b
