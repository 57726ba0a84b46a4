"""The structs of the generated C: their members, with unit, frame and meaning."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from ...algorithms.schedule import COLUMNS
from ...algorithms.scope import derived
from ...algorithms.signals import NODE, STORE
from ...ir.block import Signal
from ...ir.program import Program
from ...spec.link_class import LinkClass
from ...spec.parameters import Parameter, parameters
from ...spec.robot import Robot
from ...spec.section import Section
from ...topology.chain import Chain
from ...topology.parameters import label
from .code import literal


@dataclass(frozen=True)
class Field:
    """One member of a struct; ``size`` 0 is a scalar."""

    name: str
    size: int
    comment: str

    @property
    def declarator(self) -> str:
        return f"{self.name}[{self.size}]" if self.size else self.name

    @property
    def reals(self) -> int:
        return self.size or 1


PATTERNS = (
    (r"mount_(xyz|rpy)_([xyz])", lambda m: f"joint.mount_{m[1]}[{'xyz'.index(m[2])}]"),
    (r"armature_(\d+)", lambda m: f"joint.armature[{int(m[1]) - 1}]"),
    (r"joint_(damping|stiffness)_(\d+)", lambda m: f"joint.{m[1]}[{int(m[2]) - 1}]"),
    (r"((?:frequencies|section)_\w+)_(\d+)", lambda m: f"{m[1]}[{int(m[2]) - 1}]"),
    (r"body(\d+)_mass", lambda m: f"bodies[{m[1]}].mass"),
    (r"body(\d+)_com_([xyz])", lambda m: f"bodies[{m[1]}].com[{'xyz'.index(m[2])}]"),
    (r"body(\d+)_inertia_(\d)", lambda m: f"bodies[{m[1]}].inertia[{int(m[2]) - 1}]"),
)


def parameter_member(name: str) -> str:
    """The member of ``ella_link_parameters`` that holds the parameter of a label."""
    for pattern, place in PATTERNS:
        match = re.fullmatch(pattern, name)
        if match:
            return place(match)
    return name


def parameter_structs(robot, read: Sequence[frozenset[str]]) -> dict[str, list[Field]]:
    """The members of the link, joint and body structs: the parameters that any link of the robot states.

    ``read`` has, for every link, the labels of the parameters that its constants depend on. Members that no link's
    constants depend on are marked.
    """
    live = {_member(parameter_member(name))[:2] for names in read for name in names}
    groups: dict[str, dict[str, Field]] = {"link": {}, "joint": {}, "body": {}}
    for p in parameters(robot):
        if p.link is None:
            continue
        group, name, size = _member(parameter_member(label(p)))
        known = groups[group].get(name)
        size = max(size, known.size if known else 0)
        unused = "" if (group, name) in live else "; this model does not use it"
        groups[group][name] = Field(name, size, ascii_unit(f"{p.unit}: {_general(p)}{unused}"))
    return {group: list(fields.values()) for group, fields in groups.items()}


def changing_parameter(robot) -> dict[str, str]:
    """The parameter of the README's example: a mass at the last tip, else the last link's mass per length."""
    own = [p for p in parameters(robot) if p.link == len(robot.links) - 1]
    masses = [p for p in own if label(p).endswith("_mass")]
    p = (masses or [p for p in own if label(p) in ("rhoA", "section_rhoA_1")])[-1]
    return {"member": parameter_member(label(p)), "value": repr(p.value), "unit": ascii_unit(p.unit)}


def _member(place: str) -> tuple[str, str, int]:
    """Struct, member and minimal array size of a place such as ``bodies[0].com[2]``."""
    head, _, rest = place.rpartition(".")
    group = "joint" if head == "joint" else "body" if head else "link"
    match = re.fullmatch(r"(\w+)(?:\[(\d+)\])?", rest)
    return group, match[1], int(match[2]) + 1 if match[2] else 0


def ascii_unit(text: str) -> str:
    """A unit in ASCII."""
    return text.replace("·", "*").replace("²", "^2").replace("−", "-")


def _general(p: Parameter) -> str:
    """The description without the component's own name."""
    parts = p.description.split(", ")
    return ", ".join(
        x for x in parts if x not in ("x", "y", "z", "roll", "pitch", "yaw", "xx", "yy", "zz", "xy", "xz", "yz")
    )


def body_count(robot) -> int:
    return max((len(link.bodies) for link in robot.links), default=0)


def constant_fields(chain: Chain, labels: Iterable[str]) -> list[Field]:
    """The members of ``ella_link_constants``, documented by the steps that define them."""
    signals = _signals_of_labels(chain.classes)
    return [Field(name, 0, _constant_comment(signals.get(name))) for name in sorted(labels)]


def _signals_of_labels(classes: Sequence[LinkClass]) -> dict[str, Signal]:
    """The signal that every label of the classes' blocks belongs to; the first that has it."""
    out: dict[str, Signal] = {}
    for block in (block for key in classes for block in derived(key).values()):
        for step in block.steps.values():
            for symbol, _ in step.assignments:
                out.setdefault(symbol.name, step.signal)
        for signal in block.inputs.values():
            for _, text in signal.labels():
                out.setdefault(text, signal)
    return out


def _constant_comment(signal: Signal | None) -> str:
    return f"{signal.unit}: {signal.meaning}" if signal else "of the joint, as stated"


def columns(chain: Chain, i: int, text: Callable[[str, str, int], str]) -> str:
    """Call arguments for a link's columns; those of its joint are on a separate line.

    ``text`` of a column's name, of the robot's column that holds it, and of its place there.
    """
    out = ""
    for part, span in chain.given(i).items():
        arguments = [text(own, name, span.start) for own, name in zip(COLUMNS[part], COLUMNS["eta"], strict=True)]
        if span.stop > span.start:
            out += (",\n        " if part == "q" else ", ") + ", ".join(arguments)
    return out


def given_coordinates(chain: Chain) -> dict[str, object]:
    """Sizes and places of the coordinates whose inertia and force an integrator gives, for the templates.

    ``coupled``: row and column, among all modes, of the entries below the diagonal of the modes' matrices.
    """
    NAME, below = chain.robot.name.upper(), chain.below_offset[-1]
    n_given = f"{NAME}_{'NV' if chain.sprung else 'NMODES'}"
    modes = zip(chain.eta_offset, chain.keys, strict=False)
    return {
        "n_given": n_given,
        "n_inertia": f"{n_given} + {below}" if below else n_given,
        "first_given": "" if chain.sprung else f" + {NAME}_NTAU",
        "modal": f" + {NAME}_NTAU" if chain.sprung else "",
        "coupled": [(e + i, e + j) for e, key in modes for i, j in key.coupled],
        "below": "; at the end the entries below the diagonal, of coupled modes" if below else "",
        "below_offset": chain.below_offset[:-1],
    }


def node_fields(programs: Iterable[Program]) -> list[Field]:
    """The members of a node that the programs read or write."""
    return [Field(n, s, NODE[n].comment) for n, s in _signals(programs, ("base.", "tip.")).items()]


def store_fields(programs: Iterable[Program]) -> list[Field]:
    """The members of a link's store."""
    return [Field(n, s, STORE[n].comment) for n, s in _signals(programs, ("w.",)).items()]


def _signals(programs: Iterable[Program], prefixes: Sequence[str]) -> dict[str, int]:
    """Name without prefix and largest size of the signals in these places, in order of appearance."""
    out: dict[str, int] = {}
    for program in programs:
        for name, size in [*program.inputs.items(), *((n, len(v)) for n, v in program.outputs.items())]:
            if name.startswith(tuple(prefixes)):
                short = name.partition(".")[2]
                out[short] = max(size, out.get(short, 0))
    return dict(sorted(out.items()))


def fused_place(name: str, k: int) -> str:
    """The C expressions of the fused function's inputs and outputs."""
    link, _, what = name.partition(":")
    if what:
        return f"c->links[{link}].{what[2:]}"
    table = {
        "gravity": f"c->gravity[{k}]",
        "q": f"state->q[{k}]",
        "v": f"state->v[{k}]",
        "tau": f"input->tau[{k}]",
        "w_ext": f"input->w_ext[{k // 6}][{k % 6}]",
        "m_eta": f"m_eta[{k}]",
        "f_eta": f"work->f_eta[{k}]",
        "vdot": f"output->vdot[{k}]",
        "wrench": f"output->wrench[{k // 6}][{k % 6}]",
        "motion": f"work->motion[{k // 4}][{k % 4}]",
        "tip_rotation": f"output->tip_rotation[{k // 3}][{k % 3}]",
        "tip_position": f"output->tip_position[{k}]",
    }
    return table[name]


def stumpff_terms(order: int, count=14) -> list[str]:
    """The coefficients ``1 / (order + 2 j)!`` of a Stumpff function."""
    return [literal(1 / math.factorial(order + 2 * j)) for j in range(count)]


def index_type(count: int) -> str:
    """The smallest C type for the numbers below ``count``."""
    return "short" if count <= 2**15 else "int"


def rows(numbers: list[int], width: int = 20) -> list[str]:
    """Numbers of a table, a few per line."""
    return [", ".join(map(str, numbers[i : i + width])) + "," for i in range(0, len(numbers), width)]


def limits(robot: Robot) -> list[str]:
    """Conditions on which a link's parameters are refused; members that no link states have none."""
    sections = [link.section for link in robot.links]
    uniform = [section if isinstance(section, Section) else None for section in sections]
    stated = {"length": [link.length for link in robot.links], "rhoA": [s and s.rhoA for s in uniform]}
    tests = [_limit(name, values) for name, values in stated.items() if any(v is not None for v in values)]
    return tests + ["link->rhoIp < 0"] * any(s and s.rhoIp is not None for s in uniform)


def _limit(name: str, values: Sequence[float | None]) -> str:
    """A length or mass must be positive, or not negative if some link does not state it."""
    return f"link->{name} < 0" if None in values else f"!(link->{name} > 0)"
