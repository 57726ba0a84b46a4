"""The parameters in the generated C: the members that hold them, and the conditions that they must meet."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import NamedTuple

from ...spec.fields import FIELDS, SLIDING
from ...spec.parameters import BODY_FRAMES, Parameter, parameters, travels
from ...spec.robot import Robot
from ...spec.section import Section
from ...topology.parameters import label
from .code import literal
from .fields import StructMember

FEW = 6
"""The largest number of links that a comment names one by one."""

SLIDING_UNITS = [unit for unit, _ in SLIDING.values()]


NESTED = {"tendons.at": "[tendon][begin, end][x, y, z]"}
"""The fields whose arrays have several indices, and what these are."""


class Member(NamedTuple):
    """The place of a parameter: a member of the struct of links, joints or bodies, perhaps an entry of an array."""

    struct: str
    name: str
    body: int | None
    entry: tuple[int, ...]

    def __str__(self) -> str:
        owner = {"link": "", "joint": "joint.", "body": f"bodies[{self.body}]."}[self.struct]
        return owner + self.name + "".join(f"[{k}]" for k in self.entry)


def member(p: Parameter) -> Member:
    """The member of ``<robot>_link_parameters`` that holds a parameter of a link."""
    head, _, rest = p.field.partition(".")
    struct = {"joint": "joint", "bodies": "body"}.get(head, "link")
    name = (p.field if struct == "link" else rest).replace(".", "_")
    body, entry = (p.index[0], p.index[1:]) if struct == "body" else (None, p.index)
    return Member(struct, name, body, entry if p.field in NESTED else entry[:1])


def place(p: Parameter) -> str:
    """The C expression of a parameter in ``<robot>_parameters``."""
    if p.field == "gravity":
        return f"gravity[{p.index[0]}]"
    return f"forces.{p.name}" if p.link is None else f"links[{p.link}].{member(p)}"


def members(robot: Robot, link: int) -> dict[str, Member]:
    """The members of a link's parameters, by the labels that its blocks know them by."""
    return {label(p): member(p) for p in parameters(robot) if p.link == link}


def defaults(robot: Robot) -> list[str]:
    """The assignments of the robot file's values."""
    return [f"{place(p)} = {literal(p.value)};" for p in parameters(robot)]


def parameter_structs(robot: Robot, read: Sequence[frozenset[str]]) -> dict[str, list[StructMember]]:
    """The members of the link, joint and body structs: the parameters that any link of the robot states.

    ``read`` has, for every link, the labels of the parameters that its constants depend on. Members that no link's
    constants depend on are marked.
    """
    own = [(p.link, p) for p in parameters(robot) if p.link is not None]
    live = {member(p)[:2] for link, p in own if label(p) in read[link]}
    structs: dict[str, dict[str, StructMember]] = {"link": {}, "joint": {}, "body": {}}
    same: dict[tuple[str, str], list[Parameter]] = defaultdict(list)
    for _, p in own:
        struct, name, _, entry = member(p)
        known = structs[struct].get(name)
        shape = tuple(k + 1 for k in entry)
        unused = "" if (struct, name) in live else "; this model does not use it"
        same[struct, name].append(p)
        comment = f"{described(robot, same[struct, name])}{unused}"
        structs[struct][name] = StructMember(name, _joined(shape, known.shape) if known else shape, comment)
    return {struct: list(fields.values()) for struct, fields in structs.items()}


def described(robot: Robot, same: Sequence[Parameter]) -> str:
    """Units and meaning of parameters that stand in one member, of axes that turn first."""
    along = dict.fromkeys(kind.PLURAL for kind in travels(robot) if kind.ADDED.unit == "m")
    meanings = {p.unit: _general(p) for p in same}
    units = sorted(meanings, key=SLIDING_UNITS.count)
    sliding = " and ".join(["slides", *along])
    return ascii_unit(f"{f', of {sliding} '.join(units)}: {meanings[units[0]]}")


def comments(robot: Robot) -> dict[str, str]:
    """Units and meanings of the parameters of links, by the labels that blocks and phases know them by."""
    same: dict[str, list[Parameter]] = defaultdict(list)
    for p in parameters(robot):
        if p.link is not None:
            same[label(p)].append(p)
    return {name: described(robot, own) for name, own in same.items()}


def _joined(shape: tuple[int, ...], other: tuple[int | str, ...]) -> tuple[int, ...]:
    """The shape of an array that has the entries of both."""
    return tuple(max(a, b) for a, b in zip(shape, other, strict=True) if isinstance(b, int))


def changing_parameter(robot: Robot) -> dict[str, str]:
    """The README's example: a mass at the last tip, else the last link's mass per length, else gravity."""
    own = [p for p in parameters(robot) if p.link == len(robot.links) - 1]
    masses = [p for p in own if p.field == "bodies.mass"] or [p for p in own if p.field in ("rhoA", "section.rhoA")]
    if not masses:
        return {"place": "gravity[2]", "value": repr(robot.gravity[2]), "unit": "m/s^2"}
    last = masses[-1]
    place = f"links[$$_LINK_{robot.links[-1].name.upper()}].{member(last)}"
    return {"place": place, "value": repr(last.value), "unit": ascii_unit(last.unit)}


def ascii_unit(text: str) -> str:
    """A unit in ASCII."""
    return text.translate({ord(a): b for a, b in (("·", "*"), ("²", "^2"), ("³", "^3"), ("⁴", "^4"), ("−", "-"))})


def _general(p: Parameter) -> str:
    """The description for all links, with the order of the components."""
    if p.field in NESTED:
        return f"{FIELDS[p.field].description}, {NESTED[p.field]}"
    parts = FIELDS[p.field].components if p.field in FIELDS else ()
    frames = [x for frame in BODY_FRAMES.values() for x in frame]
    shared = [x for x in p.description.split(", ") if x not in (*parts, *frames)]
    return ", ".join(shared + [f"[{', '.join(parts)}]"] * bool(parts))


def body_places(robot: Robot) -> str:
    """Which body of a link stands where: in the order of the robot file."""
    places = {link.name: ", ".join(f"[{k}] at the {b.at}" for k, b in enumerate(link.bodies)) for link in robot.links}
    stated = {name: text for name, text in places.items() if text}
    if len(set(stated.values())) > 1 and len(stated) <= FEW:
        return "in the order of the robot file: " + "; ".join(f"{name} {text}" for name, text in stated.items())
    alike = f": {next(iter(stated.values()))}" if len(set(stated.values())) == 1 else ""
    return f"in the order of the robot file{alike}"


def bodies(robot: Robot) -> dict[str, object]:
    """How many bodies a link has at most, and where they stand, for the templates."""
    return {"n_bodies": max((len(link.bodies) for link in robot.links), default=0), "bodies": body_places(robot)}


def limits(robot: Robot) -> list[str]:
    """Conditions on which a link's parameters are refused; members that no link states have none."""
    sections = [link.section if isinstance(link.section, Section) else None for link in robot.links]
    lengths, masses = [link.length for link in robot.links], [s.rhoA if s else None for s in sections]
    stated: dict[str, Sequence[float | None]] = {"length": lengths, "rhoA": masses}
    tests = [_limit(name, values) for name, values in stated.items() if any(v is not None for v in values)]
    inertias = ("rhoIp", "rhoIy", "rhoIz")
    return tests + [f"link->{name} < 0" for name in inertias if any(s and s.states(name) for s in sections)]


def _limit(name: str, values: Sequence[float | None]) -> str:
    """A length or mass must be positive, or not negative if some link does not state it."""
    return f"link->{name} < 0" if None in values else f"!(link->{name} > 0)"
