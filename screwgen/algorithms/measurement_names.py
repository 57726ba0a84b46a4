"""How a caller chooses the measurements of a filter: by name, at a marker, with what a sensor has of its own."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

from ..arguments import choice
from ..errors import UsageError
from ..topology.chain import Chain
from ..topology.markers import PlacedMarker
from .gauges import gauges
from .measurement import AtMarkers, Attitude, Measurement, SensorNumber
from .measurements import AT_MARKERS, FURTHER, ROWS, strain_row

_Row = TypeVar("_Row", bound=Measurement)
TAKEN = "tau w_ext sensors density_q density_v gate doubt patience state P innovations squared taken refused".split()
"""Names that arguments and members of filters have."""


def measurement(chain: Chain, said: str) -> Measurement:
    """The row that is called so: ``encoder``, ``gyro@boom.tip``, ``tendon_length calibrated``.

    Behind a name stand the marker, and whether the sensor has a scale and an offset, and a gate of its own (``gated``).
    Raises UsageError for what is none.
    """
    if not said.strip():
        raise UsageError("a measurement has no name; name one, such as 'encoder'")
    (name, at, place), *options = said.split()[0].partition("@"), *said.split()[1:]
    row = _at_marker(chain, name, place) if at else _of_robot(chain, name)
    for option in options:
        choice(option, ("calibrated", "gated"), f"{said}: there is no option")
    row = replace(row, gated="gated" in options)
    return row.calibrated if "calibrated" in options else row


def _at_marker(chain: Chain, name: str, place: str) -> Measurement:
    makers: Mapping[str, Callable[[Chain, PlacedMarker], Measurement]]
    rows = (row for row in _rows(chain).values() if isinstance(row.labels, AtMarkers))
    makers = {"strain": _strain_at, **{row.name: partial(_at, row) for row in rows}}
    by_name = {marker.name: marker for marker in chain.markers}
    marker = by_name[choice(place, by_name, f"{name}@{place}: there is no marker")]
    row = makers[choice(name, makers, "at markers there is no measurement")](chain, marker)
    return _offered(row, chain, f"{name}@{place}")


def _of_robot(chain: Chain, name: str) -> Measurement:
    rows = _rows(chain)
    return _offered(rows[choice(name, rows, "there is no measurement")], chain, name)


def _rows(chain: Chain) -> dict[str, Measurement]:
    """The rows by name, those that a `Robot` of Python holds behind the product's."""
    rows = {row.name: row for row in (*ROWS, *AT_MARKERS, *FURTHER)}
    if twice := [row.name for row in chain.robot.sensors if row.name in rows]:
        raise UsageError(f"sensors: '{twice[0]}' is a sensor that the product has; take another name")
    return rows | {row.name: row for row in chain.robot.sensors}


def _offered(row: Measurement, chain: Chain, said: str) -> Measurement:
    if not row.offered(chain):
        raise UsageError(f"{said}: robot '{chain.robot.name}' has {row.missing or 'no such thing'}; leave it out")
    return row


def chosen(chain: Chain, asked: bool | Sequence[str | Measurement] = True) -> tuple[Measurement, ...]:
    """The rows of a filter: those that are asked for, by name or as they are, or all of ``ROWS`` that the robot has."""
    if isinstance(asked, bool):
        return tuple(row for row in ROWS if asked and row.offered(chain))
    rows = tuple(measurement(chain, one) if isinstance(one, str) else one for one in asked)
    if not rows:
        raise UsageError("measurements: there are none; name one at least, such as 'encoder'")
    names = [name for row in rows for name in (row.name, *(number.name for number in row.numbers))]
    for k, name in enumerate(names):
        if name in names[:k]:
            raise UsageError(f"measurements: '{name}' is there twice; leave one of them out")
        if not re.fullmatch("[a-z][a-z0-9_]*", name, re.IGNORECASE) or name in TAKEN:
            raise UsageError(f"measurements: '{name}' cannot be a name; take another of letters, digits and '_'")
    return rows


# ------------------------------------------------------------------------------ at a marker


def _strain_at(chain: Chain, marker: PlacedMarker) -> Measurement:
    place = [(marker.segment, marker.at)]
    if marker.is_tip or not gauges(chain, place):
        raise UsageError(f"strain@{marker.name}: nothing bends there; choose a marker along a link that bends")
    return strain_row(_at_name("strain", marker), lambda chain: gauges(chain, place), f"at {marker.name}")


def _at(row: _Row, chain: Chain, marker: PlacedMarker) -> _Row:
    """The row at one marker alone, with its share of the sensor's numbers."""
    place, count, name = chain.markers.index(marker), len(chain.markers), _at_name(row.name, marker)

    def own(value: Callable[..., Sequence[Any]], *given: Any, **more: Any) -> Sequence[Any]:
        shares = {number.keyword for number in row.numbers}
        found = value(*given, **{key: [*x] * count if key in shares else x for key, x in more.items()})
        size = len(found) // count
        return found[place * size : (place + 1) * size]

    def share(number: SensorNumber) -> SensorNumber:
        size = lambda chain: number.size(chain) // count  # noqa: E731
        return replace(number, name=name + number.name.removeprefix(row.name), size=size, role=number.keyword)

    more: dict[str, Any] = {"turning": partial(own, row.turning)} if isinstance(row, Attitude) else {}
    more["numbers"] = tuple(map(share, row.numbers))
    value, labels = partial(own, row.value), partial(own, row.labels)
    return replace(row, name=name, value=value, labels=labels, told=None, **more)


def _at_name(name: str, marker: PlacedMarker) -> str:
    return f"{name}_{marker.name.replace('.', '_')}"
