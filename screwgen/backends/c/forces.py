"""Forces between frames in generated C, and wrenches in the axes of the world; all empty for a robot without them."""

from __future__ import annotations

from typing import NamedTuple

from ...algorithms import tip_programs
from ...algorithms.force_programs import energy, quantities, wrenches
from ...spec.parameters import Parameter, of_forces
from ...topology.chain import Chain
from .code import Place, literal, singular
from .parameters import ascii_unit, place
from .pieces import piece_place, pieces

FORCES = ("forces",)
"""What they write in the files of every robot, as :class:`..template_places.TemplatePlaces` finds it."""
IN_TREE = ("forces_in_tree",)
"""What they write besides where no loops close the tree, whose rows take them along."""


class ForceStruct(NamedTuple):
    """The numbers of one force, as the header declares them."""

    name: str
    members: list[tuple[str, str]]
    """Declarator and comment."""
    values: list[str]
    """Of the members, as an initialiser has them."""


def files(chain: Chain) -> tuple[str, ...]:
    """The files that they add, without the robot's name."""
    return ("forces.c",) if chain.acts_on_tips or chain.n_force_states else ()


def features(chain: Chain) -> tuple[str, ...]:
    """What they write."""
    return (FORCES + IN_TREE * (not chain.closing.rows)) if chain.acts_on_tips else ()


def content(chain: Chain, baked: bool, at: Place) -> dict[str, object]:
    """The templates' context; ``at``: the places of the fused function."""
    if not chain.acts_on_tips:
        return {"forces": None}
    own = {"acted": lambda k: f"work->input.w_ext[{k // 6}][{k % 6}]"}
    program = tip_programs.acting_wrenches(chain, "baked" if baked else "constants")
    made = pieces(program, piece_place(chain, "work->kept", own, at), ("c", "state", "input", "work"), fail=singular)
    numbers = list(of_forces(chain.robot))
    return {
        "forces": made
        | {
            "count": len(numbers),
            "places": [place(p) for p in numbers],
            "refused": [_refused(p) for p in numbers if p.sign != "any"],
            "quantities": [f"{name} ({ascii_unit(x.unit)})" for name, x in chain.force_quantities.items()],
            "groups": _groups(chain, numbers),
            "turned_links": list(chain.turned_wrenches),
            "chosen": chain.chooses_forces,
            "turned": [chain.names[i] for i in chain.turned_wrenches],
        }
    }


def switches(chain: Chain) -> bool:
    """Whether any law of a force, its energy or what runs report of it calls `on`."""
    made = (wrenches, energy, quantities)
    return any("on" in make(force.shape).operations for force in chain.forces for make in made)


def scratch(chain: Chain, content: dict) -> dict[str, int]:
    """How many structs of a name a call keeps, and of numbers under an empty name."""
    if not chain.acts_on_tips or chain.closing.rows:
        return {}
    return {"input": 1, "state": 1, "": 1 + content["forces"]["kept"]}


def _refused(p: Parameter) -> str:
    return f"!(p->{place(p)} {'>' if p.sign == 'positive' else '>='} 0)"


def _groups(chain: Chain, stated: list[Parameter]) -> list[ForceStruct]:
    out = []
    for force in chain.robot.acting_forces:
        own = [p for p in stated if p.name.startswith(f"{force.name}.")]
        members, values = [], []
        for field in dict.fromkeys(p.field for p in own):
            entries = [p for p in own if p.field == field]
            name, first, numbers = field.rpartition(".")[2], entries[0], [literal(p.value) for p in entries]
            units = ", ".join(dict.fromkeys(ascii_unit(p.unit) for p in entries))
            about, _, _ = first.description.rpartition(", ") if first.index else (first.description, "", "")
            of = f" [{', '.join(p.description.rpartition(', ')[2] for p in entries)}]" if first.index else ""
            members.append((f"{name}[{len(entries)}]" if first.index else name, f"{units}: {about}{of}"))
            values.append(f"{{ {', '.join(numbers)} }}" if first.index else numbers[0])
        if members:  # C has no struct without any
            out.append(ForceStruct(force.name, members, values))
    return out
