"""What a rod of order "exact" is bent and twisted by where nothing loads it: by numbers, or by numbers at stations."""

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self

from pydantic import Field, PlainValidator, SerializeAsAny, WrapValidator, model_validator

from .modes import DIRECTIONS as OF_MODES
from .modes import points_for
from .part import Part
from .stated import Stated, stated_numbers
from .stations import check_alike, check_places, checked, place
from .values import MAX_POINTS, Path, array, refuse

if TYPE_CHECKING:
    from .robot import Link

BENT = "curvature at rest, > 0 where the rod bends towards +{}"


class RestCurvature(Part):
    """The curvature and the twist per length of a rod at rest, by the directions of its modes."""

    places: ClassVar[tuple[float, ...]] = ()

    bending_y: Annotated[float, Stated("rest curvature", BENT.format("y"))] | None = None
    bending_z: Annotated[float, Stated("rest curvature", BENT.format("z"))] | None = None
    torsion: Annotated[float, Stated("rest twist", "twist of the sections at rest, about x, per length")] | None = None

    @model_validator(mode="after")
    def _of_one_direction_at_least(self) -> Self:
        if not self.directions:
            raise refuse("states nothing; state bending_y, bending_z or torsion, or leave rest out")
        return self

    @property
    def directions(self) -> tuple[str, ...]:
        """Those that are stated."""
        return tuple(name for name in DIRECTIONS if getattr(self, name) is not None)

    def values(self, direction: str) -> float | None:
        """The number of a direction."""
        return getattr(self, direction)

    @property
    def numbers(self) -> tuple[float, ...]:
        """All that are stated."""
        return tuple(getattr(self, name) for name in self.directions)

    def turn(self, first: float = 0.0, last: float = 1.0) -> float:
        """How far the rod turns at most between two places, over the length of the link, 1/m."""
        return (last - first) * math.hypot(*self.numbers)


DIRECTIONS = tuple(name for name, _ in stated_numbers(RestCurvature))
"""The directions in which a rod may be bent at rest, in the order of the modal coordinates."""


class RestStation(RestCurvature):
    """The same at one place."""

    at: Annotated[float, PlainValidator(place)] = Field(description="the place, s from 0 at the base to 1 at the tip")


class RestStations(Part):
    """The same at stations from base to tip, linear in s between them.

    Two stations at one place are a step, which only a place where segments meet can be.
    """

    stations: tuple[RestStation, ...] = Field(description="at least two stations, from at = 0.0 to at = 1.0")

    @model_validator(mode="after")
    def _from_base_to_tip(self) -> Self:
        check_places(self.places)
        check_alike(self.stations, DIRECTIONS)
        return self

    @property
    def places(self) -> tuple[float, ...]:
        """Where the stations are."""
        return tuple(station.at for station in self.stations)

    @property
    def directions(self) -> tuple[str, ...]:
        """The directions that all stations state."""
        return self.stations[0].directions

    def values(self, direction: str) -> tuple[float, ...]:
        """The numbers of a direction at the stations."""
        return tuple(getattr(station, direction) for station in self.stations)

    @property
    def numbers(self) -> tuple[float, ...]:
        """All of them, direction by direction."""
        return tuple(x for name in self.directions for x in self.values(name))

    def turn(self, first: float = 0.0, last: float = 1.0) -> float:
        """How far the rod turns at most between two places, over the length of the link, 1/m."""
        cut = ((a, b, max(a.at, first), min(b.at, last)) for a, b in pairwise(self.stations))
        return math.fsum((end - start) * _mean(a, b, start, end) for a, b, start, end in cut if end > start)


def _mean(a: RestStation, b: RestStation, start: float, end: float) -> float:
    """The mean of the curvatures at two places between stations, 1/m."""
    shares = ((s - a.at) / (b.at - a.at) for s in (start, end))
    pairs = list(zip(a.numbers, b.numbers, strict=True))
    return math.fsum(math.hypot(*((1 - x) * u + x * v for u, v in pairs)) for x in shares) / 2


def rest_or_stations(value: Any, handler: Any) -> Any:
    """A table, an array of stations, or a table of `stations`."""
    if value is None or isinstance(value, RestCurvature | RestStations):
        return value
    listed = isinstance(value, list | tuple)
    if not listed and not (isinstance(value, dict) and "stations" in value):
        return handler(value)
    data = {"stations": list(array(value, "an array of stations"))} if listed else value
    return checked(RestStations, data, (), 1 if listed else 0)


if TYPE_CHECKING:
    AnyRest = RestCurvature | RestStations
else:
    AnyRest = Annotated[SerializeAsAny[RestCurvature], WrapValidator(rest_or_stations)]


def gauss_points(link: "Link") -> int:
    """The points of a link of order "exact" that its file asks for; 0: by the number of its modes.

    Where the link is bent at rest they are one more for each quarter of a turn of it, or of the segment that turns
    most.
    """
    modes = link.modes
    if modes.points or not link.rest:
        return modes.points or 0
    own = {modes.basis_of(d) for d, count in zip(OF_MODES, modes.counts, strict=False) if count}
    most = max(link.rest.turn(k / link.pieces, (k + 1) / link.pieces) for k in range(link.pieces))
    return min(points_for(modes.counts, own) + math.ceil(2 * most * (link.length or 0.0) / math.pi), MAX_POINTS)


def refuse_rest(link: "Link", order: int | str, at: Path) -> None:
    """Refuse curvature at rest of a link whose model has no place for it; `order`: that of its shape."""
    if link.rest is None:
        return
    if not link.modes.total:
        raise refuse("is stated for a rigid link; state modes with it, or leave it out", at=at)
    if order != "exact":
        what = f"is stated of a link of order {order}, whose shape is that of a straight rod"
        raise refuse(f'{what}; state order = "exact", or leave it out', at=at)
    s = link.rest.places
    for k in range(1, len(s)):
        if s[k] == s[k - 1] and not math.isclose(round(s[k] * link.segments), s[k] * link.segments, rel_tol=1e-12):
            what = f"is {s[k]} again, a step within a segment of the link"
            raise refuse(f"{what}; state segments that meet there, or stations apart", at=(*at, k, "at"))
    if link.frame_at is not None:
        what = "is stated beside frame_at, but the frame of a curved link is at its base"
        raise refuse(f"{what}; leave one of them out", at=at)
    if link.modes.measured:
        what = "is stated beside modes.frequencies, but measured frequencies are those of a straight rod"
        raise refuse(f"{what}; state the stiffness in the section, or leave rest out", at=at)
