"""Programs as Python functions on floats: the reference implementation for the other back ends."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

from ...ir.program import Node, Program, Value
from ...ir.replay import BINARY

Function = Callable[[Mapping[str, Sequence[float]], float], tuple[dict[str, list[float]], list[float]]]
"""Of inputs and the spacing of numbers: the outputs, and the values of the guards."""

SYMBOL = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
LIMIT = 4.0
"""Below this squared angle the Stumpff functions are summed, above they are written with sine and cosine."""

TERMS = 14


def c4(x: float) -> float:
    """``c_4(x) = sum_j (-x)^j / (4 + 2 j)!``; NaN of an angle that is not finite, where Python's cosine raises."""
    if not x < math.inf:
        return math.nan
    return series(4, x) if x < LIMIT else (math.cos(math.sqrt(x)) - 1.0 + x / 2.0) / (x * x)


def c5(x: float) -> float:
    """``c_5(x) = sum_j (-x)^j / (5 + 2 j)!``."""
    if not x < math.inf:
        return math.nan
    if x < LIMIT:
        return series(5, x)
    s = math.sqrt(x)
    return (math.sin(s) - s + s * x / 6.0) / (x * x * s)


def following(order: int, lower: Callable[[float], float]) -> Callable[[float], float]:
    """The Stumpff function of an order from that two orders below, if there is no cancellation."""
    first = 1.0 / math.factorial(order - 2)
    return lambda x: series(order, x) if x < LIMIT else (first - lower(x)) / x


def series(order: int, x: float) -> float:
    """The Stumpff series of an order by Horner's rule."""
    total = 1.0
    for j in reversed(range(1, TERMS)):
        total = 1.0 - x / ((order + 2 * j - 1) * (order + 2 * j)) * total
    return total / math.factorial(order)


NAMESPACE: dict[str, Callable[..., float]] = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "exp": math.exp,
    "atan2": math.atan2,
}
NAMESPACE |= {"c4": c4, "c5": c5}
for order in range(6, 10):
    NAMESPACE[f"c{order}"] = following(order, NAMESPACE[f"c{order - 2}"])
NAMESPACE["on"] = lambda x: float(x > 0.0)


def compiled(program: Program) -> Function:
    """A Python function of the program's inputs, returning its outputs and the values of its guards."""
    lines = ["def function(inputs, epsilon):"]
    lines += [f"    i_{k} = inputs[{name!r}]" for k, name in enumerate(program.inputs)]
    number = {name: k for k, name in enumerate(program.inputs)}
    lines += [f"    v{n.id} = {_expression(n, number)}" for n in program.nodes]
    entries = ", ".join(f"{name!r}: [{_list(values)}]" for name, values in program.outputs.items())
    lines.append(f"    return {{{entries}}}, [{_list(program.guards)}]")
    scope: dict = dict(NAMESPACE)
    exec(compile("\n".join(lines), f"<{program.name}>", "exec"), scope)
    return scope["function"]


def _list(values: Iterable[Value]) -> str:
    return ", ".join(_value(v) for v in values)


def _value(v: Value) -> str:
    return f"v{v.id}" if isinstance(v, Node) else repr(float(v))


def _expression(node: Node, number: Mapping[str, int]) -> str:
    if node.op == "input":
        return f"i_{number[node.args[0]]}[{node.args[1]}]"
    if node.op == "epsilon":
        return "epsilon"
    args = [_value(a) for a in node.args]
    if node.op in BINARY:
        return f"{args[0]} {SYMBOL[node.op]} {args[1]}"
    return f"-{args[0]}" if node.op == "neg" else f"{node.op}({', '.join(args)})"
