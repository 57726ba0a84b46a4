"""The LaTeX of a matrix expression."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from .expression import (
    Block,
    Constant,
    Diagonal,
    Expression,
    Hat,
    Integral,
    Negative,
    Product,
    Root,
    Rotation,
    Stumpff,
    Sum,
    Symbol,
    Trace,
    Transpose,
)


def latex(e: Expression) -> str:
    """The LaTeX of an expression in the paper's notation."""
    return _LATEX[type(e)](e)


def _factor(e: Expression) -> str:
    text = latex(e)
    return rf"\left({text}\right)" if isinstance(e, Sum | Negative | Integral) else text


def _sum_latex(e: Sum) -> str:
    first, *rest = e.terms
    out = latex(first)
    for t in rest:
        out += f" - {_term(t.arg)}" if isinstance(t, Negative) else f" + {latex(t)}"
    return out


def _term(e: Expression) -> str:
    return rf"\left({latex(e)}\right)" if isinstance(e, Sum) else latex(e)


def _product_latex(e: Product) -> str:
    return rf"{_factor(e.left)}\,{_factor(e.right)}"


def _hat_latex(e: Hat) -> str:
    if isinstance(e.arg, Symbol | Constant):
        return rf"\widetilde{{{latex(e.arg)}}}"
    return rf"\left({latex(e.arg)}\right)^{{\sim}}"


def _block_latex(e: Block) -> str:
    rows = r" \\ ".join(" & ".join(latex(x) for x in row) for row in e.rows)
    return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"


def axis_latex(axis: Sequence[sp.Expr]) -> str:
    for i in range(3):
        if list(axis) == [sp.S(int(i == j)) for j in range(3)]:
            return rf"\mathbf{{e}}_{'xyz'[i]}"
    return rf"\left[{', '.join(f'{float(a):.4g}' for a in axis)}\right]^{{\top}}"


def _rotation_latex(e: Rotation) -> str:
    return rf"\exp\!\left(\widetilde{{{axis_latex(e.axis)}}}\,{latex(e.angle)}\right)"


def _integral_latex(e: Integral) -> str:
    weight = "" if e.weight is None else latex(e.weight) + r"\,"
    return rf"\int_{{a}}^{{c}} {weight}{_factor(e.integrand)}\,d\xi"


_LATEX: dict[type, Callable] = {
    Symbol: lambda e: e.display,
    Constant: lambda e: e.display,
    Sum: _sum_latex,
    Product: _product_latex,
    Negative: lambda e: f"-{_term(e.arg)}",
    Transpose: lambda e: rf"{_factor(e.arg)}^{{\top}}",
    Hat: _hat_latex,
    Trace: lambda e: rf"\operatorname{{tr}}\left({latex(e.arg)}\right)",
    Diagonal: lambda e: rf"\operatorname{{diag}}\left({latex(e.arg)}\right)",
    Block: _block_latex,
    Rotation: _rotation_latex,
    Stumpff: lambda e: rf"c_{{{e.order}}}\left({latex(e.arg)}\right)",
    Root: lambda e: rf"\sqrt{{{latex(e.arg)}}}",
    Integral: _integral_latex,
}
