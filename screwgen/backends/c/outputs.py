"""The functions of a robot that its C has besides the dynamics, in two files that hold functions of the same kind.

``<robot>_outputs.c`` has what runs report at every sample, such as energies; ``<robot>_sensors.c`` what is measured at
markers, for those who ask.
"""

from __future__ import annotations

from collections.abc import Callable
from math import prod

from ...algorithms.gauges import strain_names
from ...algorithms.robot_function import RobotFunction, shape
from ...algorithms.robot_functions import in_file
from ...algorithms.signals import Signal
from ...spec.parameters import coordinate_names
from ...topology.chain import Chain
from .code import Place
from .pieces import piece_place, pieces

INPUTS = {"state": ("q", "v"), "input": ("tau", "w_ext")}
"""The structs that hold the arguments of functions."""


def content(chain: Chain, part: str, baked: bool, place: Place) -> dict:
    """The context of the templates of a file, ``part``; ``place`` is that of the fused function."""
    made = [_function(row, chain, baked, place) for row in in_file(part, chain)]
    return {"part": part, "functions": made, "kept": max(one["kept"] for one in made)}


def sensor_names(chain: Chain) -> dict:
    """What stands in the head of ``<robot>_sensors.h``: names of markers, of strains with their units, of cylinders."""
    return {
        "markers": [m.name for m in chain.markers],
        "cylinders": [coordinate_names(chain.robot).tau[k] for k in chain.cylinders],
        "strains": [f"{x} ({u})" for x, u in strain_names(chain).items()],
    }


def _function(row: RobotFunction, chain: Chain, baked: bool, place: Place) -> dict:
    given = [struct for struct, names in INPUTS.items() if not set(names).isdisjoint(row.names)]
    own = {name: _result(name, signal) for name, signal in row.results.items()}
    placed = piece_place(chain, "kept", own | {"gravity": lambda k: f"c->gravity[{k}]"}, place)
    program = row.program(chain, "baked" if baked else "constants")
    results, first = [], 0
    for name, signal in row.results.items():
        sizes = {"size": count(signal), "scalar": not signal.shape, "first": first}
        results.append({"name": name, "comment": signal.comment, **sizes})
        first += prod(shape(signal, chain))
    shown = {"name": row.name, "about": row.about, "given": given, "results": results, "length": length_of(row)}
    shown["more"] = ""
    made = pieces(program, placed, ("c", *given, "kept", *row.results), fail=_singular)
    pointers = [f"!{name}" for name in ("c", *given, "work", *row.results)]
    return made | shown | {"pointers": pointers}


def _result(name: str, signal: Signal) -> Callable[[int], str]:
    return (lambda k: f"{name}[{k}]") if signal.shape else (lambda k: f"*{name}")


def _singular(test: str, _: int) -> str:
    """The statement of a guard: a posture in which a result is not finite."""
    return f"if ({test}) {{ return $$_SINGULAR; }}"


def length_of(row: RobotFunction) -> str:
    """The number of entries of all results, as C has it."""
    return " + ".join(map(count, row.results.values()))


def count(signal: Signal) -> str:
    """The number of entries of a result, as C has it."""
    return " * ".join(f"$$_{n}" if isinstance(n, str) else str(n) for n in signal.shape) or "1"
