"""The contract of a link's body: the flexible-body invariants that the equations of a link are written in.

The equations (:mod:`.link`) are written in a body's moments of mass, its modal momenta, inertia and stiffness, and the
integrals of products of its fields. A body declares the parameters of these invariants and states them as steps of the
link's block. :class:`.rod.RodBody` has integrals in closed form, :class:`.reduced.ReducedBody` has numbers, and
:class:`.rigid.RigidBody` has no modes.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

from ..algebra.expression import Expression, Symbol
from ..ir.block import Block
from .moments import Moments

Moments6 = tuple[Expression, Expression, Expression]
"""Mass (kg), first moment (3, 1) (kg·m) and second moment ``∫ r r^T dm`` (3, 3) (kg·m²) about one point, in F_i."""


class RigidMoments(Protocol):
    """A rigid body on a link. It is part of the link class, so it must be hashable and compare by value."""

    def moments(self, b: Block) -> Moments6:
        """About the joint point, in F_i axes; parameters and steps may be declared in the block."""


class RotaryInertia(NamedTuple):
    """The inertia of a body's sections about an axis of F_i, with the energy ``1/2 ∫ρI (omega + thetadot)^2 dξ``.

    ``theta = shapes eta`` is their turn by the modes, of first order.
    """

    axis: int
    """0, 1, 2 for x, y, z."""
    density: Symbol
    """Inertia per length, kg·m."""
    inertia: Symbol
    """``∫ρI dξ``, kg·m²."""
    shapes: Expression
    """(1, r): the turn of a section by each mode."""
    momentum: Expression
    """(1, r): ``∫ρI shapes dξ``."""


class LinkBody(Protocol):
    """The body of a link class, in the link's block."""

    @property
    def rhoA(self) -> Symbol:
        """Mass per length: the weight of the integrals over the body."""

    @property
    def fields(self) -> Moments:
        """The rule that integrates."""

    @property
    def r_b(self) -> Expression:
        """(3, 1), m: the place of an element of the undeformed body, from the origin of F_i."""

    @property
    def u(self) -> Expression:
        """(3, 1), m: its elastic displacement."""

    @property
    def udot_modal(self) -> Expression:
        """(3, 1), m/s: the rate of that, by the modal rates."""

    @property
    def phi_row(self) -> Expression:
        """A row of the shapes whose products the integrals over the body need."""

    @property
    def moved(self) -> Expression:
        """(3, r): the displacement of an element by each mode."""

    @property
    def bend(self) -> Expression:
        """(3, 1): the acceleration of an element at constant modal rates, less that of its place's turning."""

    @property
    def stiffness(self) -> Expression:
        """The (r, r) stiffness of the modes."""

    @property
    def resistance(self) -> Expression:
        """Their (r, r) damping."""

    @property
    def turnings(self) -> list[RotaryInertia]:
        """The axes about which sections have an inertia of their own; known from ``modal`` on."""

    def declare(self, start: Expression) -> None:
        """Declare the fields; ``start`` (m) is the place of the joint on the centreline of F_i."""

    def moments(self) -> Moments6:
        """The moments of the undeformed body about the origin of F_i."""

    def spin(self) -> Expression:
        """(3, 3), kg·m²: the sections' own inertia, about the centreline and across it."""

    def displaced(self, eta: Symbol, etadot: Symbol) -> tuple[Expression, Expression]:
        """``∫ρA u dξ`` (3, 1) of the elastic displacement, and its rate."""

    def own_energy(self, omega: Symbol, etadot: Symbol) -> Expression:
        """Twice the kinetic energy of the body that the motion of its elements' points does not have, J."""

    def modal(self) -> None:
        """State ``sigma``, ``M_Wphi``, ``M_eta``, ``K`` and ``D``, and name the moments of the mode shapes.

        Where modes are coupled (``LinkClass.coupled``) also ``M_below``, ``K_below`` and ``D_below``.
        """
