"""Derivatives by chosen parameters in C: how the constants change, once for new parameters, and what that changes.

``<robot>_by_p.c`` has functions of the kind of those in ``<robot>_outputs.c``, with one further argument.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...algorithms.parameter_slopes import BY_P, ConstantSlopes, Differentiable
from ...algorithms.robot_function import RobotFunction
from ...algorithms.robot_functions import BY_NAME, reported
from ...algorithms.schedule import Algorithm
from ...errors import UsageError
from ...integrators.method import Method
from ...integrators.traced import step
from ...spec.parameters import parameters
from ...topology.chain import Chain
from .code import Place, entries
from .derivatives import say_time
from .outputs import count
from .parameters import place as place_of
from .pieces import piece_place, pieces
from .stumpff_slopes import slopes as stumpff

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


def algorithms(chain: Chain, chosen: Sequence[int]) -> tuple[Algorithm, ...]:
    """Those that they run; none where no parameter is chosen."""
    return (
        ()
        if not chosen
        else tuple(dict.fromkeys(a for row in rows(chain) for a in Differentiable.of(chain, row).algorithms))
    )


def content(
    chain: Chain, chosen: Sequence[int], baked: bool, place: Place, methods: Mapping[str, Method]
) -> dict | None:
    """The templates' context, None without parameters; ``place`` is that of the fused function."""
    if not chosen:
        return None
    if baked:
        raise UsageError('derivatives by parameters need parameters at run time; give parameters="runtime"')
    slopes, own = ConstantSlopes.of(chain, chosen, algorithms(chain, chosen)), parameters(chain.robot)
    by = By(chain, chosen, slopes, place)
    made = [by.function(Differentiable.of(chain, row), _said(chain, row), row.about) for row in rows(chain)]
    after = AFTER | ({"v_next": ("$$_NVZ", "rates and internal states")} if chain.n_internal else {})
    made += [by.function(step(chain, methods[name]), after, f"A step of {name}.") for name in STEPS]
    say_time(chain, "derivatives by parameters", sum(one["operations"] for one in made))
    placed = lambda name, k: f"p->{place_of(own[k])}" if name == "p" else f"{SLOPES}->slope[{k}]"  # noqa: E731
    return {
        "part": "by_p",
        "functions": made,
        "kept": max(one["kept"] for one in made),
        "prepare": pieces(slopes.program, piece_place(chain, f"{SLOPES}->kept", {}, placed), ("p", SLOPES)),
        "count": max(slopes.count, 1),
        "filled": slopes.count,
        "names": [own[k].name for k in chosen],
        "stumpff": stumpff([one["program"] for one in made]),
    }


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
