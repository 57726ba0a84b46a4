"""The derivatives of the integrators' steps, for the C templates: how the stages' changes follow from one another."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from ...integrators.method import Method
from ...integrators.plan import Evaluate, Operation
from ...integrators.pose_slopes import move_slopes, pose_slopes, rate_slopes
from ...ir.program import Program
from ...joints.kind import JointKind
from ...topology.chain import Chain
from ...topology.joint_coordinates import JointPlace
from .code import Writer, literal, trimmed, with_unused
from .curved import kinds, plus, stem, turns
from .steps import LONGEST, Steps


class StepSlopes(Steps):
    """The operations of a method, and of every move the terms that its change consists of."""

    def evaluated(self, op: Operation) -> int:
        """The number of the stage, from 1, whose accelerations an operation makes or uses."""
        done = self.operations[: [x is op for x in self.operations].index(True) + 1]
        return [x.number for x in done if isinstance(x, Evaluate)][-1]

    def change(self, number: int | None) -> dict:
        """The change of a state, that of a stage from 1, or the end's, None.

        ``reach``: the length of the step to it; ``terms``: for every stage with a part in it the stage, from 0, and
        what its accelerations are multiplied by in coordinates and in rates. For poses ``turning`` says whether the
        rates of stages move them; then ``turns`` are the stages on the way and what these rates are multiplied by.
        ``twist``: the multiple of the twist at the start.
        """
        i = len(self.method.stages) if number is None else number - 1
        move, place = (*self.method.stages, self.method.end)[i], self.method.places[i]
        pairs = enumerate(zip(place.coordinates, place.rates, strict=True))
        turning, curved = move.moved == "stages", [bool(stage.terms) for stage in self.method.stages]
        twist = sum((w for j, w in move.terms if not curved[j]), Fraction(0)) if turning else place.reach
        return {
            "reach": _part(place.reach, "dt"),
            "terms": [(j, _part(x, "dt * dt"), _part(w, "dt")) for j, (x, w) in pairs if x or w],
            "turning": turning,
            "turns": [(j, _part(w, "dt")) for j, w in move.terms if turning and curved[j]],
            "twist": _part(twist, "dt"),
        }

    @property
    def products(self) -> int:
        """The products of two matrices."""
        return sum(len(self.change(i)["terms"]) for i in range(1, len(self.method.stages) + 1))


def _part(part: Fraction, step: str) -> str:
    """A number times a power of the step, in C."""
    if not part:
        return "0"
    if part.denominator > LONGEST:
        return f"{literal(float(part))} * {step}"
    times = f"{abs(part.numerator)} * " * (abs(part.numerator) > 1)
    return f"{'-' * (part < 0)}{times}{step}" + f" / {part.denominator}" * (part.denominator > 1)


def content(chain: Chain, methods: Mapping[str, Method], per_stage: int, implicit: int) -> dict:
    """The templates' context; ``per_stage``: the operations of an acceleration's derivatives, the solver's included;
    ``implicit``: those of an implicit stage."""
    steps = [StepSlopes(method) for method in methods.values()]
    product = 2 * chain.nv**2 * (2 * chain.nv + chain.n_tau)
    stages = lambda m: sum(implicit if stage.implicit else per_stage for stage in m.method.stages)  # noqa: E731
    count = lambda m: stages(m) + m.products * product  # noqa: E731
    return {
        "steps": [(m, f"{round(count(m), -2):,}".replace(",", " ")) for m in steps],
        "stages": max(len(m.method.stages) for m in steps),
        "coupled": chain.coupled,
        "pose": _pose() if chain.base_v else [],
        "by_sum": _by_sum(chain),
    } | _moved(chain)


def _by_sum(chain: Chain) -> str:
    """What ``by_q`` is, in C, of the coordinate with the rate k: moves take the part of what does not add up."""
    if not chain.curved:
        return "by_q"
    alone = len(chain.curved) == 1 and chain.base_v
    return f"({'k < $$_NTWIST' if alone else 'MOVED[k]'} ? 0 : by_q)"


def _moved(chain: Chain) -> dict[str, object]:
    """Joints whose coordinates do not add up: their rows, which are those of v, their kinds, and the sizes of both."""
    sizes = list(dict.fromkeys(part.joint.nv for part in chain.curved))
    of_size = {n: "" if n == POSE else f"_{n}" for n in sizes}
    rows = [k for part in chain.curved for k in range(part.v.start, part.v.stop)]
    return {
        "moved": [int(k in rows) for k in range(chain.nv)],
        "turning": turns(chain),
        "sizes": [(n, f"turn_rows{end}", f"add_turned{end}") for n, end in of_size.items()],
        "curved": [_place(chain, part, of_size[part.joint.nv]) for part in chain.curved],
        "kinds": [_kind(joint, of_size[joint.nv]) for joint in kinds(chain)],
    }


POSE = 6
"""The rates of a pose."""


def _place(chain: Chain, part: JointPlace, end: str) -> dict[str, object]:
    """One of them as the templates print it."""
    joint, first = part.joint, part.v.start
    names = {"name": joint.name, "stem": stem(joint), "link": chain.names[part.link], "product": f"add_turned{end}"}
    places = {"first": first, "end": part.v.stop, "count": joint.nv, "q": plus(part.q.start), "v": plus(first)}
    return names | places | {"base": joint.in_space}


def _kind(joint: JointKind, end: str) -> dict[str, object]:
    """The functions of a kind."""
    move, rate = _body(move_slopes(joint), joint.nv), _body(rate_slopes(joint), joint.nv)
    return {
        "name": joint.name,
        "stem": stem(joint),
        "nv": joint.nv,
        "rows": f"turn_rows{end}",
        "move": move,
        "rate": rate,
    }


def _body(program: Program, size: int) -> list[str]:
    """The body of a function of vectors that finds matrices of ``size`` columns."""
    own = lambda name, k: f"{name}[{k}]" if name in program.inputs else f"{name}[{k // size}][{k % size}]"  # noqa: E731
    return with_unused(program.inputs, trimmed(Writer(program, own, None, {*program.inputs, *program.outputs}).lines()))


def _pose() -> list[str]:
    """The body of the function that finds the changes of a pose."""
    own = lambda name, k: f"u[{k}]" if name == "u" else f"{name}[{k // 6}][{k % 6}]"  # noqa: E731
    return trimmed(Writer(pose_slopes(), own, None, {"u", "turned", "carried"}, apart=True).lines())
