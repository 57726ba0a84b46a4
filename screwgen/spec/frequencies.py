"""Measured natural frequencies of a link, in place of the stiffness of its section."""

from typing import Annotated, Any

from .part import Part
from .ranges import within
from .stated import Stated
from .values import array, refuse, shown


def ascending(value: Any) -> tuple[float, ...]:
    """Any number of frequencies > 0, each greater than the one before it."""
    entries = array(value, "an array of numbers, one for each mode")
    numbers = tuple(within("frequency")(entry, at=(k,)) for k, entry in enumerate(entries))
    for k in range(1, len(numbers)):
        if numbers[k] <= numbers[k - 1]:
            what = f"is {shown(entries[k])}; it must be greater than the frequency before it, {numbers[k - 1]}"
            raise refuse(what, at=(k,))
    return numbers


PerMode = tuple[float, ...]


def _measured(mode: str) -> Stated:
    meaning = f"natural frequency of the bare link clamped at its base: {mode}"
    return Stated("frequency", meaning, several=True, check=ascending)


class Frequencies(Part):
    """Measured natural frequencies in Hz, ascending, one for each mode of a direction: its stiffness.

    They are those of the *bare link*: clamped at its base, free at its tip, no body mounted, no other link. Each
    gives its mode the stiffness `K_kk = M_kk (2π f_k)²`, `M_kk = ρA l` (torsion: `ρI_p l`), which is the paper's
    wavenumber identification, `β_n² = 2π f_n √(ρA/EI)`, solved for EI mode by mode. A direction takes its
    stiffness from here or from the section, never from both.

    Limits. With a motor, a payload or the rest of an arm on the link other frequencies are measured: those must
    not be put here, the model adds the bodies itself. The frequencies fix K alone; the shapes, and so the
    inertia, stay those of the uniform beam. Higher modes of a link that is not uniform are then met in
    frequency, not in shape. The shapes are those of `clamped_free`: they alone are the link's modes.
    `equivalent_stiffness` tells how far the link is from a uniform beam.
    """

    axial: Annotated[PerMode, _measured("axial mode")] | None = None
    bending_y: Annotated[PerMode, _measured("bending in y")] | None = None
    bending_z: Annotated[PerMode, _measured("bending in z")] | None = None
    torsion: Annotated[PerMode, _measured("torsion")] | None = None

    @property
    def stated(self) -> dict[str, tuple[float, ...]]:
        """The frequencies of every direction that has some."""
        return {direction: values for direction, values in self if values}
