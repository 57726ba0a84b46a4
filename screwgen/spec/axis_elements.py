"""The elements of joint axes: `elements` of a joint, kinds and keys of :data:`screwgen.elements.KINDS`."""

from collections.abc import Iterator, Sequence
from typing import Any

from ..elements import KINDS, AxisElement, Key
from .messages import unknown
from .ranges import range_of
from .values import Path, array, refuse, shown

OfAxis = tuple[AxisElement, ...]


def axis_elements(value: Any) -> tuple[OfAxis, ...]:
    """The elements of each axis, from tables or from objects made in Python."""
    entries = array(value, "an array with a table for each axis; an empty one is no element")
    return tuple(_of_axis(entry, (axis,)) for axis, entry in enumerate(entries))


def _of_axis(entry: Any, at: Path) -> OfAxis:
    if isinstance(entry, AxisElement):
        entry = (entry,)
    if isinstance(entry, dict):
        return tuple(_element(kind, numbers, (*at, kind)) for kind, numbers in entry.items())
    if not isinstance(entry, Sequence) or not all(isinstance(one, AxisElement) for one in entry):
        raise refuse(f"is {shown(entry)}; it must be a table of {', '.join(KINDS)}", at)
    kinds = [one.KIND for one in entry]
    if twice := next((kind for kind in kinds if kinds.count(kind) > 1), None):
        raise refuse(f"has two elements '{twice}'; an axis has one of each kind, so add their numbers", at)
    return tuple(_checked(one, at) for one in entry)


def _element(kind: str, numbers: Any, at: Path) -> AxisElement:
    if kind not in KINDS:
        raise refuse(unknown(kind, tuple(KINDS)), at)
    keys = KINDS[kind].table()
    if not isinstance(numbers, dict):
        raise refuse(f"is {shown(numbers)}; it must be a table of {', '.join(keys)}", at)
    for name in numbers:
        if name not in keys:
            raise refuse(unknown(name, tuple(keys)), (*at, name))
    defaults = {name: field.default for name, field in KINDS[kind].__dataclass_fields__.items()}
    for name, key in keys.items():
        if name not in numbers and not isinstance(defaults[name], float):
            raise refuse(f"is missing; state the {key.meaning}, {key.unit}", (*at, name))
    return KINDS[kind](**{name: range_of(keys[name]).check(x, at=(*at, name)) for name, x in numbers.items()})


def _checked(element: AxisElement, at: Path) -> AxisElement:
    """An element made in Python with its numbers checked."""
    values = zip(element.table().items(), element.values, strict=True)
    return type(element)(**{name: range_of(key).check(x, at=(*at, element.KIND, name)) for (name, key), x in values})


def stated(given: tuple[OfAxis, ...] | None) -> list[dict[str, dict[str, float]]] | None:
    """The tables of a robot file."""
    table = lambda one: dict(zip(one.table(), one.values, strict=True))  # noqa: E731
    return None if given is None else [{one.KIND: table(one) for one in own} for own in given]


def known_to_files(given: tuple[OfAxis, ...] | None) -> bool:
    """Whether a robot file can state them."""
    return all(KINDS.get(one.KIND) is type(one) for own in given or () for one in own)


def numbers_of(given: tuple[OfAxis, ...] | None) -> Iterator[tuple[int, AxisElement, str, Key, float]]:
    """Every number: its axis, its element, the name of its key, the key, its value."""
    for axis, own in enumerate(given or ()):
        for one in own:
            for (name, key), value in zip(one.table().items(), one.values, strict=True):
                yield axis, one, name, key, value
