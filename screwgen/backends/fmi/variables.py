"""The variables of a functional mock-up unit: names, units, start values and value references.

A value reference is a variable's place in the list, so groups of variables are ranges of references.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...algorithms.entry_names import entry_meanings, entry_units, names_in
from ...algorithms.gauges import strain_names
from ...algorithms.response import OWN, REPORTED, Response
from ...algorithms.robot_functions import SENSED
from ...bodies.validity import MEASURES
from ...errors import UsageError
from ...spec.base import POSE
from ...spec.inputs import input_units
from ...spec.parameters import WRENCH, coordinate_names, coordinate_units, parameters, rate_units
from ...topology.chain import Chain

STEP, METHOD = 1e-3, "modal_implicit"
"""The internal step of co-simulation, s, and its integrator, until others are set."""

MODE_NOMINAL, RATE_NOMINAL = 1e-2, 1e-1
"""Nominal values of modal coordinates (m, torsion: rad) and of their rates; those of all other states are 1."""

WRENCH_UNITS = {part: "N" if part.startswith("F") else "N·m" for part in WRENCH}
MEASURE_UNITS = {"slope": "rad"}
AXES = ("x", "y", "z")

JOINT = "coordinate of the joint"
TWISTS = {True: "twist of the base, in its own axes", False: "angular velocity over the carrier, in axes of the link"}
"""What rates are that are not those of coordinates: of joints in space, and of others."""


@dataclass(frozen=True)
class Variable:
    """One scalar variable; ``derivative``: the place of the state whose rate it is, in the list of variables."""

    group: str
    name: str
    unit: str
    description: str
    causality: str
    variability: str = "continuous"
    initial: str | None = None
    start: float | None = None
    derivative: int | None = None
    nominal: float | None = None
    items: tuple[str, ...] = ()
    """The values of an enumeration, which are numbered from 1."""


def variables(answers: Response, methods: Sequence[str], baked: bool) -> list[Variable]:
    """All variables, group by group; parameters that are folded into the code are none."""
    chain = answers.chain
    tunable = ("parameter", "tunable", "exact")
    start, names = list(methods).index(METHOD) + 1, tuple(methods)
    out: list[Variable] = [
        Variable("time", "time", "s", "time", "independent"),
        Variable("solver", "solver.step", "s", "longest internal step of co-simulation", *tunable, STEP),
        Variable("solver", "solver.method", "", "integrator of co-simulation", *tunable, start, items=names),
    ]
    for p in () if baked else parameters(chain.robot):
        name = p.name.replace("][", ",")  # the naming convention knows one bracket of indices, "at[0,2]"
        out.append(Variable("parameters", name, p.unit, p.description, *tunable, p.value))
    first = len(out)
    out += _states(chain)
    out += _inputs(chain)
    out += _rates(out[first : first + chain.nq + chain.nvz], first, chain.nq)
    out += _outputs(answers)
    twice = {x.name for x in out if sum(y.name == x.name for y in out) > 1}
    if twice:
        raise UsageError(f"robot '{chain.robot.name}': two variables would be called '{min(twice)}'; rename the link")
    return out


def groups(answers: Response) -> tuple[str, ...]:
    """The groups of variables, in the order of their value references; those of sensors are empty where none asks."""
    reported = dict.fromkeys((*REPORTED, *SENSED, *answers.reports))
    return ("time", "solver", "parameters", "q", "v", "tau", "w_ext", *OWN, *reported, "measures")


def first_references(answers: Response, found: Sequence[Variable]) -> dict[str, int]:
    """The first value reference of every group; of an empty one that of the group behind it."""
    own = groups(answers)
    counts = {group: sum(x.group == group for x in found) for group in own}
    return {group: sum(counts[g] for g in own[:k]) for k, group in enumerate(own)}


def _states(chain: Chain) -> Iterator[Variable]:
    names, values = coordinate_names(chain.robot), [p.value for p in parameters(chain.robot)]
    start = chain.complete(np.zeros(0), values)
    if isinstance(start, str):
        raise UsageError(f"robot '{chain.robot.name}': there is no state to start in: {start}")
    quaternions = {k for part in chain.curved for k in range(part.q.start, part.q.stop)}
    turning = {k: TWISTS[part.joint.in_space] for part in chain.curved for k in range(part.v.start, part.v.stop)}
    for k, (name, unit) in enumerate(zip(names.q, coordinate_units(chain.robot), strict=True)):
        nominal = MODE_NOMINAL if k >= chain.eta_q else None
        meaning = "modal coordinate" if nominal else "of the joint's quaternion" if k in quaternions else JOINT
        yield Variable(
            "q", name, unit, _pose(name) or meaning, "output", initial="exact", start=float(start[k]), nominal=nominal
        )
    for k, (name, unit) in enumerate(zip(names.v, rate_units(chain.robot), strict=True)):
        nominal = None if k < chain.eta_v else RATE_NOMINAL if k < chain.nv else MODE_NOMINAL
        meaning = "rate of the coordinate" if k < chain.nv else "internal state"
        yield Variable(
            "v",
            name,
            unit,
            turning.get(k, meaning),
            "output",
            initial="exact",
            start=0.0,
            nominal=nominal,
        )


def _pose(name: str) -> str:
    """What a coordinate of a floating base is."""
    if not name.startswith("base.") or name.removeprefix("base.") not in POSE:
        return ""
    return "unit quaternion of the base" if name.startswith("base.q") else "position of the base, inertial frame"


def _inputs(chain: Chain) -> Iterator[Variable]:
    names = coordinate_names(chain.robot).tau
    for name, unit in zip(names, input_units(chain.robot), strict=True):
        yield Variable("tau", name, unit, "what the drive exerts", "input", initial=None, start=0.0)
    for segment in chain.segments:
        for part, unit in WRENCH_UNITS.items():
            name = f"{segment.tipped}.w_ext.{part}"
            axes = "inertial frame" if segment.pushed == "world" else "tip frame"
            yield Variable("w_ext", name, unit, f"external wrench on the tip section, {axes}", "input", start=0.0)


def _rates(states: Sequence[Variable], first: int, nq: int) -> Iterator[Variable]:
    for k, state in enumerate(states):
        group = "qdot" if k < nq else "vdot"
        unit = state.unit.removesuffix("/s") + "/s²" if state.unit.endswith("/s") else f"{state.unit}/s"
        yield Variable(
            group,
            f"der({state.name})",
            unit,
            f"rate of {state.name}",
            "local",
            initial="calculated",
            derivative=first + k,
        )


def _outputs(answers: Response) -> Iterator[Variable]:
    """What is calculated, in the order of the answers, then the measures of the model's validity."""
    chain = answers.chain

    def of(group: str, name: str, unit: str, description: str) -> Variable:
        return Variable(group, name, unit, description, "output", initial="calculated")

    links = [chain.segments[i].owner for i in chain.lasts]
    for link in links:
        for axis in AXES:
            yield of("position", f"{link}.tip.position.{axis}", "m", "tip point, inertial frame")
    for link in links:
        for row in range(3):
            for column in range(3):
                name = f"{link}.tip.rotation[{row},{column}]"
                yield of("rotation", name, "1", "rotation of the tip frame, in the inertial frame")
    for k, name in enumerate(coordinate_names(chain.robot).wrench):
        yield of("wrench", name, WRENCH_UNITS[WRENCH[k % 6]], "of the joint on the link, at the joint point, in F_i")
    for name, unit in strain_names(chain).items():
        yield of("strain", name, unit, "strain of the centreline at the link's base, or at its marker")
    for told in answers.rows.values():
        for entry in zip(names_in(told, chain), entry_units(told, chain), entry_meanings(told, chain), strict=True):
            yield of(told.name, *entry)
    for segment in chain.segments:
        for measure in MEASURES:
            name, unit = f"{segment.name}.validity.{measure}", MEASURE_UNITS.get(measure, "1")
            yield Variable("measures", name, unit, "how near to a limit of the model", "local", initial="calculated")
