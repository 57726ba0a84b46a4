"""Equations in scalars of the textbook robots: size as traced and as written, and time.

    python bench/scalars.py

"traced": the entries of M and of the bias force as the programs give them on symbols of sympy, nothing simplified;
"written": all entries of M, C, D, K and g of the form that is chosen. Operations and characters of both, and seconds.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import sympy as sp

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent / "tests")]

from textbook_robots import TEXTBOOKS  # noqa: E402

import screwgen  # noqa: E402
from screwgen.algorithms import fused  # noqa: E402
from screwgen.ir.replay import run  # noqa: E402
from screwgen.spec.robot import Robot  # noqa: E402


def unary(op: str, x: sp.Expr) -> sp.Expr:
    """The primitives of programs in sympy; Stumpff functions by name."""
    if op == "neg":
        return -x
    return getattr(sp, op)(x) if op in ("sin", "cos", "sqrt") else sp.Function(op)(x)


def traced(model: screwgen.Model) -> tuple[int, int]:
    """Operations and characters of the entries as the programs give them."""
    given = {}
    for program in (fused.inertial_force(model.chain), fused.bias(model.chain)):
        given[program.name] = {name: sp.symbols(f"{name}:{size}") for name, size in program.inputs.items()}
    entries = []
    for program in (fused.inertial_force(model.chain), fused.bias(model.chain)):
        found, _ = run(program, given[program.name], unary, literal=lambda x: sp.nsimplify(x) if x == int(x) else x)
        entries += [sp.sympify(x) for values in found.values() for x in values]
    return sum(int(e.count_ops()) for e in entries), sum(len(str(e)) for e in entries)


def main() -> None:
    """Print the table."""
    print(f"{'robot':20}{'traced':>8}{'chars':>9}{'written':>9}{'chars':>7}{'seconds':>9}")
    for name, make in TEXTBOOKS.items():
        model = screwgen.derive(Robot(**make().robot))
        before = traced(model)
        start = time.perf_counter()
        equations = model.equations()
        seconds = time.perf_counter() - start
        characters = sum(map(len, str(equations).splitlines()[1:]))
        print(f"{name:20}{before[0]:8}{before[1]:9}{equations.operations:9}{characters:7}{seconds:9.2f}")


if __name__ == "__main__":
    main()
