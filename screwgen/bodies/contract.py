"""The contract of a link's body: the flexible-body invariants that the equations of a link are written in.

The equations (:mod:`.link`) know a body by its moments of mass, its modal momenta, inertia and stiffness, and by the
integrals of products of its fields. A provider declares the parameters that these follow from and states them as steps
of the link's block. :class:`.rod.Rod` has integrals in closed form, :class:`.rigid.Rigid` has no modes.
"""

from __future__ import annotations

from typing import Protocol

from ..algebra.expression import Expression, Symbol
from ..ir.block import Block
from .moments import Moments

FRAME = "F_i"
Moments6 = tuple[Expression, Expression, Expression]
"""Mass (kg), first moment (3, 1) (kg·m) and second moment ``∫ r r^T dm`` (3, 3) (kg·m²) about one point, in F_i."""


class RigidMoments(Protocol):
    """A rigid body on a link. It is part of the key of a derivation, so it is hashable and compares by value."""

    def moments(self, b: Block) -> Moments6:
        """About the joint point, in F_i axes; parameters and steps may be declared in the block."""
        ...


class Body(Protocol):
    """The body of a link class, in the link's block."""

    rhoA: Symbol
    """Mass per length: the weight of the integrals over the body."""
    fields: Moments
    """The rule that integrates."""

    def declare(self, start: Expression) -> None:
        """Declare the fields; ``start`` (m) is the place of the joint on the centreline of F_i."""
        ...

    def moments(self) -> Moments6:
        """The undeformed body's own, about the origin of F_i."""
        ...

    def spin(self) -> Expression:
        """(3, 3), kg·m²: the sections' own inertia about the centreline."""
        ...

    def modal(self) -> None:
        """State ``sigma``, ``M_Wphi``, ``M_eta``, ``K`` and ``D``, and name the moments of the mode shapes."""
        ...
