"""Derivatives by chosen parameters in C: how the constants change, once for new parameters, and what that changes.

``<robot>_by_p.c`` has functions of the kind of those in ``<robot>_outputs.c``, with one further argument.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from ...algorithms.estimated_parameters import gaps
from ...algorithms.functions import MEASURING
from ...algorithms.measurement import Measurement
from ...algorithms.parameter_slopes import BY_P, ConstantSlopes, Differentiable
from ...algorithms.robot_function import RobotFunction
from ...algorithms.robot_functions import BY_NAME, reported
from ...algorithms.schedule import Algorithm
from ...errors import UsageError
from ...integrators.method import Method
from ...integrators.traced import step
from ...spec.parameters import parameters
from ...topology.chain import Chain
from ..numpy.estimated import check_estimated
from .code import Place, entries
from .derivatives import say_time
from .outputs import count
from .parameters import place as place_of
from .pieces import piece_place, pieces
from .stumpff_slopes import slopes as stumpff
from .written import once

FILES = ("by_p.h", "by_p.c")
"""The files that they add, without the robot's name; their templates have the same names."""
STEPS = ("modal_implicit", "modal_midpoint")
"""The steps that have such C; those of more stages are as many dynamics long."""
AFTER = {"q_next": ("$$_NQ", "coordinates after the step"), "v_next": ("$$_NV", "their rates")}
SLOPES = "constant_slopes"
"""The struct of the constants' derivatives, and its name as an argument."""
GIVEN = (SLOPES, "state", "input")


def rows(chain: Chain) -> tuple[RobotFunction, ...]:
    """The functions of a robot that have such C: the dynamics, and what runs report."""
    return BY_NAME["forward_dynamics"], *reported(chain)


@dataclass(frozen=True)
class ParameterDerivatives:
    """The parameters by which there are derivatives, and of what.

    ``chosen``: their places; ``reported``: of dynamics, outputs and steps; ``measured``: what a filter is told that
    finds these parameters, and needs the derivatives of accelerations alone; None where there is no such filter.
    """

    chosen: tuple[int, ...]
    reported: bool
    measured: tuple[Measurement, ...] | None

    @property
    def estimated(self) -> bool:
        """Whether a filter finds them."""
        return self.measured is not None

    @property
    def features(self) -> tuple[str, ...]:
        """What they write in the files of a filter, as :class:`..template_places.TemplatePlaces` finds it."""
        return ("parameter_states",) * self.estimated


def algorithms(chain: Chain, asked: ParameterDerivatives) -> tuple[Algorithm, ...]:
    """Those that the functions run which are differentiated; none where no parameter is chosen.

    A filter alone asks for no measure of the model's validity: of two equal stiffnesses the softer has no slope.
    """
    if not asked.chosen:
        return ()
    whole = rows(chain) if asked.reported else rows(chain)[:1]
    told = (a for row in asked.measured or () for a in row.algorithms)
    found = (*(a for row in whole for a in Differentiable.of(chain, row).algorithms), *told)
    return tuple(dict.fromkeys(a for a in found if asked.reported or a is not MEASURING))


def slopes(chain: Chain, asked: ParameterDerivatives) -> ConstantSlopes:
    """The derivatives of all constants that are read, and of numbers of sensors."""
    derived = {n.name: n.start for row in asked.measured or () for n in row.numbers if callable(n.start)}
    return ConstantSlopes.of(chain, asked.chosen, algorithms(chain, asked), derived)


def asked(
    chain: Chain,
    by_p: str | Sequence[str],
    estimate: str | Sequence[str],
    measured: tuple[Measurement, ...],
    baked: bool,
) -> ParameterDerivatives:
    """What names or patterns of parameters ask for: ``by_p`` for derivatives, ``estimate`` for a filter of them.

    Raises UsageError where these are two sets, or no filter finds them, or parameters are baked.
    """
    chosen, found = chain.parameters.chosen(by_p), chain.parameters.chosen(estimate)
    if baked and (chosen or found):
        raise UsageError('derivatives by parameters need parameters at run time; give parameters="runtime"')
    if chosen and found and chosen != found:
        raise UsageError("by_p and estimate stand for different parameters; name the same ones, or leave by_p out")
    if found:
        check_estimated(chain, found)
    return ParameterDerivatives(found or chosen, bool(chosen), measured if found else None)


def content(chain: Chain, asked: ParameterDerivatives, place: Place, methods: Mapping[str, Method]) -> dict | None:
    """The templates' context, None without parameters; ``place`` is that of the fused function."""
    if not asked.chosen:
        return None
    by, own = By(chain, asked.chosen, once(slopes, chain, asked), place), parameters(chain.robot)
    made = _reported(by, methods) if asked.reported else []
    made += _estimated(by) if asked.estimated else []
    say_time(chain, "derivatives by parameters", sum(one["operations"] for one in made))
    placed = lambda name, k: f"p->{place_of(own[k])}" if name == "p" else f"{SLOPES}->slope[{k}]"  # noqa: E731
    return {
        "part": "by_p",
        "functions": made,
        "kept": max(one["kept"] for one in made),
        "prepare": pieces(by.slopes.program, piece_place(chain, f"{SLOPES}->kept", {}, placed), ("p", SLOPES)),
        "count": max(by.slopes.count, 1),
        "filled": by.slopes.count,
        "names": [own[k].name for k in asked.chosen],
        "stumpff": stumpff([one["program"] for one in made]),
    }


def _reported(by: By, methods: Mapping[str, Method]) -> list[dict]:
    """The derivatives of dynamics, of what runs report and of steps."""
    chain = by.chain
    after = AFTER | ({"v_next": ("$$_NVZ", "rates and internal states")} if chain.n_internal else {})
    return [
        *(by.function(Differentiable.of(chain, row), _said(chain, row), row.about) for row in rows(chain)),
        *(by.function(step(chain, methods[name]), after, f"A step of {name}.") for name in STEPS),
    ]


def _estimated(by: By) -> list[dict]:
    """The derivatives that a filter needs: of the accelerations alone, and of what closes loops."""
    row, rows = BY_NAME["forward_dynamics"], str(len(by.chain.closing.rows))
    whole, said = Differentiable.of(by.chain, row), _said(by.chain, row)
    what = replace(whole, name="accelerations", results={"vdot": whole.results["vdot"]})
    made = [by.function(what, {"vdot": said["vdot"]}, "The accelerations under the inputs as they are given.")]
    if not by.chain.closing.rows:
        return made
    of_rows = {"gap": (rows, "gaps of the loops' rows, m or of cosines"), "rate": (rows, "their rates")}
    return [*made, by.function(gaps(by.chain), of_rows, "How far the loops are open.")]


def _said(chain: Chain, row: RobotFunction) -> dict[str, tuple[str, str]]:
    rates = "$$_NVZ" if chain.n_internal else "$$_NV"
    return {name: (count(signal).replace("$$_NVZ", rates), signal.comment) for name, signal in row.results.items()}


@dataclass(frozen=True)
class By:
    """What makes the functions of a robot's derivatives by chosen parameters."""

    chain: Chain
    chosen: Sequence[int]
    slopes: ConstantSlopes
    place: Place

    def function(self, what: Differentiable, said: Mapping[str, tuple[str, str]], about: str) -> dict:
        """One of them, as the templates print it; ``said``: length and comment of its results."""
        program = self.slopes.by_parameters(self.chain, what, self.chosen)
        results, first = [], 0
        for name, (size, comment) in said.items():
            sizes = {"size": f"{size} * $$_NBY_P", "scalar": False, "first": first}
            results.append({"name": name + BY_P, "comment": f"derivatives of: {comment}", **sizes})
            first += what.sizes()[name] * len(self.chosen)
        own = {name + BY_P: entries(name + BY_P) for name in said}
        placed = {"slope": entries(f"{SLOPES}->slope"), "dt": lambda _: "dt", "gravity": entries("c->gravity")}
        pointers = ("c", *GIVEN, "kept", *own)
        fail = lambda test, _: f"if ({test}) {{ return $$_SINGULAR; }}"  # noqa: E731
        made = pieces(program, piece_place(self.chain, "kept", own | placed, self.place), pointers, fail=fail)
        shown = {"name": what.name + BY_P, "about": about, "given": GIVEN, "results": results, "program": program}
        checked = [f"!{name}" for name in ("c", *GIVEN, "work", *own)]
        return made | shown | {"more": ", $_real dt" if "dt" in what.inputs else "", "pointers": checked}
