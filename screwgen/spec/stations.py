"""A section that varies along the link, stated at stations."""

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated, Any, Self, TypeVar

import numpy as np
from pydantic import BaseModel, Field, PlainValidator, SerializeAsAny, ValidationError, WrapValidator, model_validator

from ..bases.weighted import LINEAR, POLYNOMIAL
from .messages import first_error, reason
from .part import Part
from .section import LineProperties, Section
from .values import Path, array, choice, number, refuse, shown

MOST, SAMPLES = 64, 200
MOST_POLYNOMIAL = 9


Validated = TypeVar("Validated", bound=BaseModel)


def place(value: Any, *, at: Path = ()) -> float:
    """A place s along the link, 0 at its base and 1 at its tip."""
    result = number(value, at=at)
    if not 0 <= result <= 1:
        raise refuse(f"is {shown(value)}; it must be from 0 at the base to 1 at the tip", at)
    return result


class Station(LineProperties):
    """The line properties of a link's section at one place."""

    at: Annotated[float, PlainValidator(place)] = Field(description="the place, s from 0 at the base to 1 at the tip")


class Stations(Part):
    """The section of a link at stations from base to tip, at least two; all state the same properties.

    `between` the stations every property is linear in s, or "polynomial": the polynomial through all of its values.
    Where it is linear, two stations at one place are a step. The places are part of the link's structure, the
    properties are runtime parameters.
    """

    stations: tuple[Station, ...] = Field(description="at least two stations, from at = 0.0 to at = 1.0")
    between: Annotated[str, PlainValidator(choice(LINEAR, POLYNOMIAL))] = Field(
        LINEAR, description="how properties are interpolated between stations"
    )

    @property
    def places(self) -> tuple[float, ...]:
        """Where the stations are."""
        return tuple(station.at for station in self.stations)

    def states(self, name: str) -> bool:
        """Whether a line property is stated; all stations state the same."""
        return getattr(self.stations[0], name) is not None

    def values(self, name: str) -> tuple[float, ...]:
        """A line property at the stations."""
        return tuple(getattr(station, name) for station in self.stations) if self.states(name) else ()

    def least(self, name: str) -> float | None:
        """The smallest value of a line property at the stations; None where it is not stated."""
        return min(self.values(name), default=None)

    @model_validator(mode="after")
    def _from_base_to_tip(self) -> Self:
        check_places(self.places, self.between)
        return self

    @model_validator(mode="after")
    def _same_properties(self) -> Self:
        check_alike(self.stations, tuple(LineProperties.model_fields))
        return self

    @model_validator(mode="after")
    def _nowhere_negative(self) -> Self:
        for name in LineProperties.model_fields if self.between == POLYNOMIAL else ():
            if not (values := self.values(name)):
                continue
            s = (np.arange(SAMPLES) + 0.5) / SAMPLES
            found = lagrange(self.places, values, s)
            if (below := np.flatnonzero(found < 0)).size:
                what = f"the polynomial through {name} is {found[below[0]]:.3g} at s = {s[below[0]]:.3g}"
                raise refuse(f'is "polynomial", but {what}; state more stations, or "linear"', at=("between",))
        return self


def check_places(s: tuple[float, ...], between: str = LINEAR) -> None:
    """Refuse stations that do not lead from base to tip."""
    most = MOST if between == LINEAR else MOST_POLYNOMIAL
    if not 2 <= len(s) <= most:
        raise refuse(f"has {len(s)} stations; it must have from 2 to {most}", at=("stations",))
    for k, end, name in ((0, 0.0, "first"), (len(s) - 1, 1.0, "last")):
        if s[k] != end:
            raise refuse(f"is {s[k]}; the {name} station must be at {end}", at=("stations", k, "at"))
    for k in range(1, len(s)):
        if s[k] < s[k - 1] or (s[k] == s[k - 1] and between == POLYNOMIAL):
            relation = "not be before" if between == LINEAR else "be beyond"
            what = f"is {s[k]}; it must {relation} the station before it, {s[k - 1]}"
            raise refuse(what, at=("stations", k, "at"))
        if (s[k - 1] == s[min(k + 1, len(s) - 1)] and k + 1 < len(s)) or (s[k] == s[k - 1] and s[k] in (0.0, 1.0)):
            raise refuse(f"is {s[k]} again; a step has two stations, between base and tip", at=("stations", k, "at"))


def check_alike(stations: Sequence[Part], names: Sequence[str]) -> None:
    """Refuse stations of which only some state one of these numbers."""
    for name in names:
        stated = [getattr(station, name) is not None for station in stations]
        if any(stated) and not all(stated):
            what = f"is missing; station {stated.index(True)} states it, so all stations must"
            raise refuse(what, at=("stations", stated.index(False), name))


def lagrange(places: tuple[float, ...], values: tuple[float, ...], s: Any) -> Any:
    """At `s`, a number or an array, the polynomial that has these values at these places."""
    total: Any = 0.0
    for place, value in zip(places, values, strict=True):
        others = (other for other in places if other != place)
        total += value * math.prod((s - other) / (place - other) for other in others)
    return total


def section_or_stations(value: Any, handler: Any) -> Any:
    """A section: a table, an array of stations, or a table of `stations` and `between`."""
    if value is None or isinstance(value, Section | Stations):
        return value
    listed = isinstance(value, list | tuple)
    if not listed and not (isinstance(value, dict) and "stations" in value):
        return handler(value)
    data = {"stations": list(array(value, "an array of stations"))} if listed else value
    return checked(Stations, data, (), 1 if listed else 0)


def checked(model: type[Validated], data: Any, at: Path, skipped: int = 0, context: Any = None) -> Validated:
    """`data` as a `model`, or its first error as one at the path `at`, less the first keys of its own path."""
    try:
        return model.model_validate(data, context=context)
    except ValidationError as error:
        record = first_error(error)
        path = (*record["loc"], *record.get("ctx", {}).get("at", ()))
        raise refuse(reason(record, model), at=(*at, *path[skipped:])) from None


if TYPE_CHECKING:
    AnySection = Section | Stations
else:
    AnySection = Annotated[SerializeAsAny[Section], WrapValidator(section_or_stations)]
