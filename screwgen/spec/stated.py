"""A number of the robot file, or an array of some, stated once: what it is, its unit, its range, its meaning."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any, get_args

from pydantic import BaseModel, GetCoreSchemaHandler, PlainValidator
from pydantic_core import CoreSchema

from ..elements import Key
from .ranges import RANGES, Range, range_of, several, within
from .values import positive


@dataclass(frozen=True)
class Stated:
    """What a key of a robot file holds, as the annotation of its field: `EIz: Annotated[float, Stated("EIz", …)]`.

    `quantity`: its range with units, or the name of that in :data:`.ranges.RANGES`; `meaning`: what generated code and
    tables say; `more`: what the table of keys adds to it; `sliding`: its meaning on an axis that slides, where it has
    another; `components`: the names of the entries of an array of that size; `several`: whether it is an array of any
    size; `check`: in place of the range alone.
    """

    quantity: str | Range
    meaning: str
    more: str = ""
    sliding: str = ""
    components: tuple[str, ...] = ()
    several: bool = False
    check: Callable[[Any], Any] | None = None

    @classmethod
    def of(cls, key: Key, more: str = "") -> Stated:
        """That of a class of :mod:`screwgen.elements`."""
        return cls(range_of(key), key.meaning, more)

    @property
    def range(self) -> Range:
        """Which numbers it may be, and in which units."""
        return RANGES[self.quantity] if isinstance(self.quantity, str) else self.quantity

    @property
    def unit(self) -> str:
        """Its unit; on a joint axis that of one that turns."""
        return self.range.units[0]

    @property
    def sign(self) -> str:
        """Which numbers are allowed: ``positive``, ``non-negative`` or ``any``."""
        return self.range.sign_name

    @property
    def on_slide(self) -> tuple[str, str]:
        """Unit and meaning on an axis that slides."""
        return self.range.units[-1], self.sliding or self.meaning

    @property
    def text(self) -> str:
        """What the table of keys says."""
        unit, slide = ("" if self.unit == "1" else f", {self.unit}"), self.on_slide[0]
        above = ", > 0" if self.range.sign is positive else ""
        return f"{self.meaning}{unit}{f' (of a slide {slide})' if slide != self.unit else ''}{above}{self.more}"

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """The check of the field."""
        size = len(self.components) or None
        check = several(self.quantity, size) if self.several or size else within(self.quantity)
        return PlainValidator(self.check or check).__get_pydantic_core_schema__(source, handler)


@cache
def stated_numbers(part: type[BaseModel]) -> tuple[tuple[str, Stated], ...]:
    """The keys of a table that hold numbers."""
    said = ((name, (*x.metadata, *_inside(x.annotation))) for name, x in part.model_fields.items())
    return tuple((name, one) for name, found in said for one in found if isinstance(one, Stated))


def _inside(annotation: Any) -> Iterator[Any]:
    """What is annotated inside `Annotated[float, …] | None`."""
    for part in get_args(annotation):
        yield from getattr(part, "__metadata__", ())
