"""A number of the robot file, or an array of some, stated once: what it is, its unit, its range, its meaning."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any, get_args

from pydantic import BaseModel, GetCoreSchemaHandler, PlainValidator
from pydantic_core import CoreSchema

from .ranges import RANGES, several, within
from .values import positive


@dataclass(frozen=True)
class Stated:
    """What a key of a robot file holds, as the annotation of its field: `EIz: Annotated[float, Stated("EIz", …)]`.

    `quantity`: a key of :data:`.ranges.RANGES`, which has range and units; `meaning`: what generated code and tables
    say; `more`: what the table of keys adds to it; `sliding`: its meaning on an axis that slides, where it has another;
    `components`: the names of the entries of an array of that size; `several`: whether it is an array of any size;
    `check`: in place of the range alone.
    """

    quantity: str
    meaning: str
    more: str = ""
    sliding: str = ""
    components: tuple[str, ...] = ()
    several: bool = False
    check: Callable[[Any], Any] | None = None

    @property
    def unit(self) -> str:
        """Its unit; on a joint axis that of one that turns."""
        return RANGES[self.quantity].units[0]

    @property
    def sign(self) -> str:
        """Which numbers are allowed: ``positive``, ``non-negative`` or ``any``."""
        return RANGES[self.quantity].sign_name

    @property
    def on_slide(self) -> tuple[str, str]:
        """Unit and meaning on an axis that slides."""
        return RANGES[self.quantity].units[-1], self.sliding or self.meaning

    @property
    def text(self) -> str:
        """What the table of keys says."""
        unit, slide = ("" if self.unit == "1" else f", {self.unit}"), self.on_slide[0]
        above = ", > 0" if RANGES[self.quantity].sign is positive else ""
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
