"""Forces between two frames of a robot, or one of them and the world; and places where a wrench acts from outside.

A spring of 400 N/m between the tip of a boom and a hook 2 m above the base:

    [[forces]]
    name = "spring"
    between = ["boom.tip", { world = [0.0, 0.0, 2.0] }]
    line = { stiffness = 400.0, rest = 0.5 }
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, NamedTuple

from pydantic import Field, PlainSerializer, PlainValidator, model_serializer, model_validator

from ..interactions import KINDS, Interaction, Number
from .input import Input, InputLine
from .loops import Loop, marked
from .markers import ENDS
from .messages import unknown
from .names import link_name
from .parents import WORLD
from .part import Part
from .ranges import range_of, within
from .values import Path, array, boolean, choice, numbers, quoted, refuse, shown

if TYPE_CHECKING:
    from .robot import Link, Robot

MARKER = 'the name of a link with that of its marker, as "boom.tip"'
END = f"{MARKER}, or a point as {{ world = [0.0, 0.0, 2.0] }}"
AXES = ("world", "marker")
"""The axes in which a wrench from outside is meant."""
POINT = "force.world"
"""The field of the entries of a point of the world."""


class WorldPoint(NamedTuple):
    """A point that does not move, in the inertial frame, m."""

    x: float
    y: float
    z: float


def end(value: Any, at: Path = ()) -> str | WorldPoint:
    """One end of a force."""
    if isinstance(value, WorldPoint):
        return value
    if value == WORLD:
        return WorldPoint(0.0, 0.0, 0.0)
    if isinstance(value, dict):
        if list(value) != [WORLD]:
            raise refuse(f"has the keys {', '.join(map(quoted, value)) or 'of no place'}; it must be {END}", at)
        point = numbers(value[WORLD], 3, at=(*at, WORLD))
        return WorldPoint(*(within("position")(x, at=(*at, WORLD, k)) for k, x in enumerate(point)))
    if not _is_marker(value):
        raise refuse(f"is {shown(value)}; it must be {END}", at)
    if value.partition(".")[0] == WORLD:
        raise refuse(f"is {shown(value)}; state a point of the world as {{ world = [0.0, 0.0, 2.0] }}", at)
    return str(value)


def ends(value: Any) -> tuple[str | WorldPoint, str | WorldPoint]:
    """Both ends of a force, of which the world may be one."""
    stated = array(value, f"an array of two places, each {END}")
    if len(stated) != 2:
        raise refuse(f"has {len(stated)} entries; it must have two, each {END}")
    first, second = (end(x, (k,)) for k, x in enumerate(stated))
    if isinstance(first, WorldPoint) and isinstance(second, WorldPoint):
        raise refuse("joins the world with itself; name a marker of a link")
    return first, second


def written_ends(value: Sequence[str | WorldPoint]) -> list[Any]:
    """Both ends as a robot file states them."""
    return [{WORLD: list(x)} if isinstance(x, WorldPoint) else x for x in value]


def interaction(value: Any) -> Interaction:
    """What acts between two frames: an object made in Python, or the table of its kind, under its name."""
    if isinstance(value, Interaction):
        found = {name: getattr(value, name) for name in (*value.table(), *value.choices())}
        return _checked(type(value), {name: x for name, x in found.items() if x is not None}, (value.KIND,))
    ((kind, table),) = value.items()
    keys = (*KINDS[kind].table(), *KINDS[kind].choices())
    if not isinstance(table, dict):
        raise refuse(f"is {shown(table)}; it must be a table of {', '.join(keys)}", (kind,))
    for name in table:
        if name not in keys:
            raise refuse(unknown(name, keys), (kind, name))
    return _checked(KINDS[kind], table, (kind,))


def _checked(kind: type[Interaction], given: dict[str, Any], at: Path) -> Interaction:
    """An interaction with its numbers in their ranges."""
    found: dict[str, Any] = {}
    for name, one in kind.table().items():
        if name in given:
            found[name] = _number(one, given[name], (*at, name))
        elif not hasattr(kind, name):
            raise refuse(f"is missing; state the {one.meaning}, {one.unit}", (*at, name))
    for name in kind.choices():
        if name in given:
            if not isinstance(given[name], bool):
                raise refuse(f"is {shown(given[name])}; it must be true or false", (*at, name))
            found[name] = boolean(given[name])
    if shared := kind.QUANTITIES.keys() & {*kind.table(), *kind.choices()}:
        raise refuse(f"reports {min(shared)}, which is one of its numbers too; choose another name", at)
    if shared := kind.INPUTS.keys() & {*kind.QUANTITIES, *kind.table(), *kind.choices()}:
        raise refuse(f"has the input {min(shared)}, a name that it has otherwise too; choose another name", at)
    out = kind(**found)
    if out.fault is not None:
        key, said = out.fault
        raise refuse(said, (*at, key) if key else at)
    return out


def _number(one: Number, value: Any, at: Path) -> Any:
    """A number in its range, or as many as it has entries."""
    check = range_of(one).check
    if not one.entries:
        return check(value, at=at)
    return tuple(check(x, at=(*at, k)) for k, x in enumerate(numbers(value, len(one.entries), at=at)))


def _about(kind: type[Interaction]) -> str:
    """What a kind is, in the words of its class."""
    text = " ".join((kind.__doc__ or kind.WORDS).partition(".")[0].split())
    return text[:1].lower() + text[1:]


class Force(Part):
    """A force between two frames, as that of a spring: each is a section at a marker, or a point of the world.

    One kind is stated, under its name, as `line = { stiffness = 400.0 }`. Its numbers are run-time parameters. In
    Python `law` may be an :class:`screwgen.interactions.Interaction` of one's own.
    """

    other_keys: ClassVar = {kind: _about(one) for kind, one in KINDS.items()}

    name: Annotated[str, PlainValidator(link_name)] = Field(description="the force's name, a C identifier")
    between: Annotated[tuple, PlainValidator(ends), PlainSerializer(written_ends)] = Field(
        description='the two ends: markers as "boom.tip", or a point as { world = [0.0, 0.0, 2.0] }, m'
    )
    law: Annotated[Any, PlainValidator(interaction)] = Field(exclude=True)

    @model_validator(mode="before")
    @classmethod
    def _law_under_its_name(cls, data: Any) -> Any:
        if not isinstance(data, dict) or isinstance(data.get("law"), Interaction):
            return data
        known, kinds = ("name", "between", *KINDS), [kind for kind in KINDS if kind in data]
        one_of = f"state one of {', '.join(f'{kind} = {{ … }}' for kind in KINDS)}"
        if "law" in data:
            raise refuse(f"is {shown(data['law'])}; it must be an object made in Python; in a file {one_of}", ("law",))
        for key in data:
            if key not in known:
                raise refuse(unknown(key, known), (key,))
        if len(kinds) != 1:
            said = f"states {' and '.join(kinds)}" if kinds else "does not state what acts"
            raise refuse(f"{said}; {one_of}")
        rest = {key: value for key, value in data.items() if key != kinds[0]}
        return rest | {"law": interaction({kinds[0]: data[kinds[0]]})}

    @model_serializer(mode="wrap")
    def _with_law(self, handler: Any) -> dict[str, Any]:
        chosen = {name: True for name, on in self.law.shape.chosen if on}
        return handler(self) | {self.law.KIND: self.law.numbers | chosen}

    @property
    def known_to_files(self) -> bool:
        """Whether a robot file can state it."""
        return KINDS.get(self.law.KIND) is type(self.law)

    @property
    def point(self) -> WorldPoint | None:
        """The end in the world, if one is there."""
        return next((x for x in self.between if isinstance(x, WorldPoint)), None)

    @property
    def values(self) -> Iterator[tuple[str, float, str, str, str, tuple[int, ...]]]:
        """Its numbers in order: field, value, unit, meaning, sign, index; the point of the world last."""
        for name, value in self.law.numbers.items():
            one = self.law.table()[name]
            stated = f"force.{self.law.KIND}.{name}"
            if not one.entries:
                yield stated, value, one.unit, one.meaning, one.sign, ()
            for k, entry in enumerate(one.entries):
                yield stated, value[k], one.unit_of(k), f"{one.meaning}, {entry}", one.sign, (k,)
        for k, value in enumerate(self.point or ()):
            yield POINT, value, "m", f"end in the world, inertial frame, {'xyz'[k]}", "any", (k,)


class InputsOfForces(Input):
    """What a controller chooses of forces between frames, as the line that a winch pays out."""

    words = "inputs of forces between frames"
    quantity = "force_input"
    said = r"Inputs of these act in their laws alone; their columns of $\mathbf{B}_u$ are zero."

    def names(self, robot: Robot) -> list[str]:
        return [f"{force.name}.{name}" for force in robot.acting_forces for name in force.law.shape.inputs]

    def units(self, robot: Robot) -> list[str]:
        return [entry.unit for force in robot.acting_forces for entry in force.law.shape.inputs.values()]

    def lines(self, chain: Any, first: int) -> list[InputLine]:
        pairs = ((f.name, one) for f in chain.robot.acting_forces for one in f.law.shape.inputs.values())
        return [InputLine(one.symbol, f"`{name}`: {one.meaning}") for name, one in pairs]


FORCE_INPUTS = InputsOfForces()


class Push(Part):
    """A place where a wrench acts from outside: six inputs, a row of `w_ext`, behind those of the links' tips."""

    name: Annotated[str, PlainValidator(link_name)] = Field(description="the push's name, a C identifier")
    at: Annotated[str, PlainValidator(lambda x: _marker(x))] = Field(
        description='the marker at which it acts, as "boom.tip"'
    )
    axes: Annotated[str, PlainValidator(choice(*AXES))] = Field(
        "world", description='the axes in which it is stated: "world", or "marker" of the section there'
    )


def _marker(value: Any) -> str:
    if value == WORLD or isinstance(value, dict | WorldPoint) or (_is_marker(value) and value.startswith(f"{WORLD}.")):
        raise refuse('is a place of the world; name a marker of a link, as "boom.tip"')
    if not _is_marker(value):
        raise refuse(f"is {shown(value)}; it must be {MARKER}")
    return str(value)


def _is_marker(value: Any) -> bool:
    """Whether a value reads as the name of a link with that of its marker."""
    return isinstance(value, str) and value.count(".") == 1 and all(value.split("."))


def refuse_forces(robot: Robot) -> None:
    """Refuse forces at no marker of the robot, between a link's section and itself, and names that occur twice."""
    taken = {link.name.upper(): f"the name of a link, {link.name}" for link in robot.links}
    for own in forces_of_loops(robot.loops):
        if said := taken.get(own.name.upper()):
            which: Path = ("loops", int(own.name.rpartition("_")[2]))
            raise refuse(f"has the name {own.name} in generated code, {said}; choose another name for the link", which)
        taken[own.name.upper()] = "the name of a loop whose joint gives way"
    for table in ("forces", "pushes"):
        for k, one in enumerate(getattr(robot, table)):
            at: Path = (table, k)
            if said := taken.get(one.name.upper()):
                raise refuse(f"is {quoted(one.name)}, {said}; choose another name", (*at, "name"))
            taken[one.name.upper()] = "the name of an earlier one"
            if isinstance(one, Push):
                _refuse_push(robot.links[marked(robot.links, one.at, (*at, "at"))[0]], one, at)
                continue
            places = [marked(robot.links, x, (*at, "between", n)) for n, x in _markers(one)]
            if len(places) == 2 and places[0] == places[1]:
                raise refuse("joins a place with itself; name two places", (*at, "between"))


def _refuse_push(link: Link, push: Push, at: Path) -> None:
    """Refuse a push with the name of a marker of its link, which stands beside that name in code and tables."""
    taken = {name.upper() for name in (*ENDS, *(marker.name for marker in link.markers))}
    if push.name.upper() in taken:
        raise refuse(f"is {quoted(push.name)}, a marker of {link.name}; choose another name", (*at, "name"))


def _markers(force: Force) -> Iterator[tuple[int, str]]:
    return ((n, x) for n, x in enumerate(force.between) if isinstance(x, str))


def marked_ends(robot: Robot) -> Iterator[str]:
    """The markers at which forces act, in the order of the file."""
    return (x for force in robot.forces for _, x in _markers(force))


def forces_of_loops(loops: Sequence[Loop]) -> Iterator[Force]:
    """The loops whose joints give way, as forces between their markers."""
    for k, loop in enumerate(loops):
        if (law := loop.joint.law) is not None:
            yield Force.model_construct(name=f"loop_{k}", between=loop.between, law=law)


def links_of(links: Sequence[Link], force: Force) -> list[int]:
    """The numbers of the links that a force joins."""
    return [marked(links, x)[0] for _, x in _markers(force)]
