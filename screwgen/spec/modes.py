"""The mode shapes of a link: how many in each direction, of which basis."""

from collections.abc import Callable, Iterable
from typing import Annotated, Any, Self

from pydantic import Field, PlainValidator, model_validator

from ..bases import BASES, DEFAULT, NATURAL, ORDER, Basis, Shapes, shapes
from .frequencies import Frequencies
from .part import Part
from .values import choice, count, gauss_points, quoted, refuse

DIRECTIONS = tuple(ORDER)
"""The directions of deflection, in the order of the modal coordinates."""

NEEDS = {  # direction of deflection: its stiffness, then what else of the section it cannot do without
    "axial": ("EA",),
    "bending_y": ("EIz",),
    "bending_z": ("EIy",),
    "torsion": ("GJ", "rhoIp"),
    "shear_y": ("GAy",),
    "shear_z": ("GAz",),
}
SHEARED = {"shear_y": ("bending_y", "rhoIz"), "shear_z": ("bending_z", "rhoIy")}
"""Direction of shear: that of bending in its plane, and the inertia of the sections that turn there."""


def basis(value: Any) -> str | Basis:
    """The name of a basis, or in Python a function `(count, order) -> Shapes`."""
    return value if callable(value) else choice(*BASES)(value)


def named(basis: str | Basis) -> str:
    """A basis as messages call it."""
    return quoted(basis) if isinstance(basis, str) else "of one's own"


Count = Annotated[int, PlainValidator(count)]
BasisName = Annotated[str | Callable, PlainValidator(basis)]


def points_for(counts: Iterable[int], bases: Iterable[str | Basis]) -> int:
    """The Gauss points of a link of order "exact": two more than the most modes of a direction.

    Shapes that are no polynomials take more to have their inertia to eight digits.
    """
    most = max(counts)
    return most + 2 if set(bases) <= {"", DEFAULT} else 2 * most + 4


class Modes(Part):
    """How many mode shapes describe a link's deflection in each direction, 0 to 32 each.

    `basis` names the shapes. Modal coordinates are in metres, those of torsion in radians. Polynomials, the default,
    converge fast from two bending modes, one axial and one torsion mode on; one alone in bending is too stiff.
    `shear_y` and `shear_z` make the rod one of Timoshenko: shear displaces its sections and does not turn them.
    `frequencies` (Hz) of the bare clamped link, if measured, take the place of the section's stiffness; those
    directions have the link's natural modes, `clamped_free`, as shapes.
    """

    basis: BasisName = Field(DEFAULT, description=f"the shapes' family, {' or '.join(map(quoted, BASES))}")
    axial: Count = Field(0, description="number of modes of stretching; needs EA")
    bending_y: Count = Field(0, description="number of modes of bending that deflect in y; needs EIz")
    bending_z: Count = Field(0, description="number of modes of bending that deflect in z; needs EIy")
    torsion: Count = Field(0, description="number of modes of twisting; needs GJ and rhoIp")
    shear_y: Count = Field(0, description="number of modes of shear that deflect in y; needs GAy")
    shear_z: Count = Field(0, description="number of modes of shear that deflect in z; needs GAz")
    points: Annotated[int, PlainValidator(gauss_points)] | None = Field(
        None,
        description='points of integration along a link of order "exact"; without it two more than modes, of '
        "other bases twice as many, and one more for each quarter of a turn at rest",
    )
    frequencies: Frequencies | None = Field(None, description="measured natural frequencies in place of stiffness")

    @model_validator(mode="before")
    @classmethod
    def _natural_modes_of_measured_bending(cls, given: Any) -> Any:
        """Where bending frequencies are stated and no basis, the basis is the one that they belong to."""
        frequencies = given.get("frequencies") if isinstance(given, dict) else None
        stated = dict(frequencies) if isinstance(frequencies, dict | Frequencies) else {}
        bends = stated.get("bending_y") or stated.get("bending_z")
        return {"basis": NATURAL} | given if bends else given

    @model_validator(mode="after")
    def _points_for_the_modes(self) -> Self:
        """With fewer points than that even a straight link would have the wrong inertia."""
        least = max(self.counts) + 1
        if self.points is not None and self.points < least:
            raise refuse(f"is {self.points}; it must be at least {least}, one more than modes", at=("points",))
        return self

    @model_validator(mode="after")
    def _one_frequency_per_mode(self) -> Self:
        for direction, values in self.frequencies or ():
            if values is not None and len(values) != getattr(self, direction):
                count = f"modes.{direction} = {getattr(self, direction)}"
                what = f"has length {len(values)}; it must hold one frequency per mode, {count}"
                raise refuse(what, at=("frequencies", direction))
        return self

    @model_validator(mode="after")
    def _frequencies_of_natural_modes(self) -> Self:
        for direction in self.measured:
            if direction.startswith("bending") and self.basis != NATURAL:
                why = f"is stated with basis {named(self.basis)}, whose shapes are not the link's natural modes"
                what = f'{why}; use basis "clamped_free", or state {NEEDS[direction][0]} in the section'
                raise refuse(what, at=("frequencies", direction))
        return self

    @property
    def measured(self) -> tuple[str, ...]:
        """The directions whose stiffness is stated by frequencies."""
        return tuple(self.frequencies.stated) if self.frequencies else ()

    def basis_of(self, direction: str) -> str | Basis:
        """The basis of a direction's shapes."""
        return NATURAL if direction in self.measured else self.basis

    def shapes(self, direction: str) -> Shapes:
        """The mode shapes of a direction."""
        return shapes(self.basis_of(direction), direction, getattr(self, direction))

    def alike(self, direction: str, more: int = 0) -> int:
        """How many combinations of shear and of bending in its plane turn sections alone, with so many `more` of each.

        Polynomials of shear from the second on displace the centreline as those of bending do. So their difference
        leaves it in place, and only an inertia of the turning sections, or what the tip carries, resists it.
        """
        shears, bends = (getattr(self, name) + more for name in (direction, SHEARED[direction][0]))
        return max(0, min(shears - 1, bends)) if self.basis == DEFAULT else 0

    @property
    def counts(self) -> tuple[int, ...]:
        """The numbers of modes in the order of the modal coordinates, `DIRECTIONS`; without shear the first four."""
        shears = (self.shear_y, self.shear_z)
        return (self.axial, self.bending_y, self.bending_z, self.torsion, *(shears if any(shears) else ()))

    @property
    def total(self) -> int:
        """The number of modal coordinates of the link."""
        return sum(self.counts)
