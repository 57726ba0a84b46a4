"""The LaTeX of a matrix expression, in the paper's notation."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from ..digits import telling
from ..lazily import sp
from .expression import (
    BlockMatrix,
    Constant,
    Diagonal,
    Expression,
    Hat,
    Integral,
    Inverse,
    Negative,
    Product,
    Root,
    Rotation,
    Stumpff,
    Sum,
    Symbol,
    Trace,
    Transpose,
    is_identity,
    is_zero,
    product,
    transpose,
)

TRANSPOSED = r"^{\top}"

HEAD = re.compile(r"(\\(?:mathbf|boldsymbol|dot|ddot)\{(?:[^{}]|\{[^{}]*\})*\}|[A-Za-z])(.*)", re.DOTALL)
"""The letter of a symbol with its accents, and its scripts."""


def latex(e: Expression) -> str:
    """The LaTeX of an expression; TypeError for a type of node that has none."""
    if (write := _LATEX.get(type(e))) is None:
        raise TypeError(f"no LaTeX for {type(e).__name__}")
    return write(e)


def terms(e: Expression) -> list[str]:
    """The LaTeX of the terms of a sum, each with its sign, between which a long line may be broken."""
    first, *rest = e.terms if isinstance(e, Sum) else (e,)
    return [latex(first)] + [f"{'-' if negative else '+'} {_term(t)}" for negative, t in map(_signed, rest)]


def number(value: sp.Expr, digits: int = 6) -> str:
    """A number with at most so many significant digits, or a multiple of π: 0.3, not 0.29999999999999999."""
    if value.has(sp.pi):
        return sp.latex(value)
    if value.is_Rational:
        sign, top, below = "-" if value < 0 else "", abs(value.p), value.q
        return f"{sign}{top}" if below == 1 else rf"{sign}\tfrac{{{top}}}{{{below}}}"
    x = float(value)
    mantissa, _, exponent = f"{x:.{telling(x, digits)}g}".partition("e")
    return mantissa + (rf"\times 10^{{{int(exponent)}}}" if exponent else "")


def symbol(display: str) -> str:
    """The LaTeX of a symbol: the dot of a rate sits on the letter, not on its index."""
    return re.sub(r"\\dot\{(\\mathrm\{\w\}|[A-Za-z])_(\w+|\{\w+\})\}", r"\\dot{\1}_\2", display)


def tilde(display: str) -> str:
    """The skew-symmetric matrix of a symbol: the tilde sits on the letter, not on its index."""
    match = HEAD.fullmatch(display)
    return rf"\tilde{{{match[1]}}}{match[2]}" if match else rf"\widetilde{{{display}}}"


def axis_latex(axis: Sequence[sp.Expr]) -> str:
    """A fixed unit axis: ``e_x`` or its components."""
    for i in range(3):
        if list(axis) == [sp.S(int(i == j)) for j in range(3)]:
            return rf"\mathbf{{e}}_{'xyz'[i]}"
    entries = r",\ ".join(f"{float(a):.4g}" for a in axis)
    return rf"\left[{entries}\right]^{{\top}}"


# ------------------------------------------------------------------------------------- sums, products


def _bracketed(e: Expression) -> str:
    return rf"\left({latex(e)}\right)"


def _signed(e: Expression) -> tuple[bool, Expression]:
    """Whether ``e`` has a minus sign, that of its number too, and ``e`` without its signs."""
    negative = False
    while isinstance(e, Negative):
        negative, e = not negative, e.arg
    positive = _positive(e)
    return (negative, e) if positive is None else (not negative, positive)


def _positive(e: Expression) -> Expression | None:
    """A negative number, or a product that has one, without the minus sign; None of others."""
    if isinstance(e, Constant) and e.shape == (1, 1) and e.rows[0][0].is_negative:
        return Constant(((-e.rows[0][0],),), e.shape, "")
    if isinstance(e, Product):
        if (left := _positive(e.left)) is not None:
            return product(left, e.right)
        if (right := _positive(e.right)) is not None:
            return product(e.left, right)
    return None


def _negative(e: Negative) -> str:
    negative, inner = _signed(e)
    return f"-{_term(inner)}" if negative else latex(inner)


def _term(e: Expression) -> str:
    return _bracketed(e) if isinstance(e, Sum) else latex(e)


def _product(e: Product) -> str:
    """Factors side by side, scalars first; equal neighbours as a power, a squared length as a norm."""
    parts = _factors(e) if e.shape == (1, 1) else sorted(_factors(e), key=lambda f: not _is_scalar(f))
    if e.shape == (1, 1) and len(parts) == 2 and isinstance(parts[1], Sum) and parts[0] == transpose(parts[1]):
        return rf"\left\| {latex(parts[1])} \right\|^{{2}}"
    out, i = [], 0
    while i < len(parts):
        n = 1
        while i + n < len(parts) and parts[i + n] == parts[i] and _may_be_squared(parts[i]):
            n += 1
        last = i + n == len(parts)
        out.append(_factor(parts[i], last) if n == 1 else _power(parts[i], n))
        i += n
    return r"\,".join(out)


def _is_scalar(e: Expression) -> bool:
    """Whether a reader sees a scalar: a vector of one entry is bold."""
    bold = isinstance(e, Symbol) and re.search(r"\\mathbf|\\boldsymbol", e.display)
    return e.shape == (1, 1) and isinstance(e, Symbol | Constant | Stumpff) and not bold


def _factors(e: Expression) -> list[Expression]:
    return [*_factors(e.left), *_factors(e.right)] if isinstance(e, Product) else [e]


def _factor(e: Expression, last: bool = False) -> str:
    bracket = isinstance(e, Sum | Negative) or (isinstance(e, Integral) and not last)
    return _bracketed(e) if bracket else latex(e)


def _may_be_squared(e: Expression) -> bool:
    return isinstance(e, Diagonal | Hat | Symbol | Sum) and e.shape[0] == e.shape[1]


def _power(e: Expression, n: int) -> str:
    text = latex(e)
    return rf"\left({text}\right)^{{{n}}}" if "^" in text or isinstance(e, Sum) else rf"{text}^{{{n}}}"


def _transpose(e: Transpose) -> str:
    if isinstance(e.arg, Rotation):
        return _rotation(e.arg, "-")
    text = _factor(e.arg)
    if isinstance(e.arg, Symbol) and text.endswith(TRANSPOSED):
        return text.removesuffix(TRANSPOSED)
    if isinstance(e.arg, Symbol) and text.endswith("^{+}"):
        return rf"{text.removesuffix('^{+}')}^{{+\top}}"
    scripted = ("^" in text or "'" in text) and not text.endswith(")")
    return rf"\left({text}\right)^{{\top}}" if scripted else rf"{text}^{{\top}}"


# --------------------------------------------------------------------------------------- other nodes


def _constant(e: Constant) -> str:
    if e.shape == (1, 1):
        return number(e.rows[0][0])
    if is_zero(e):
        return r"\mathbf{0}"
    return rf"\mathbf{{I}}_{{{e.shape[0]}}}" if is_identity(e) else e.display


def _hat(e: Hat) -> str:
    return tilde(latex(e.arg)) if isinstance(e.arg, Symbol | Constant) else rf"\widetilde{{{latex(e.arg)}}}"


def _block(e: BlockMatrix) -> str:
    rows = r" \\ ".join(" & ".join(latex(x) for x in row) for row in e.rows)
    return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"


def _rotation(e: Rotation, sign: str = "") -> str:
    return rf"\exp\left({sign}{tilde(axis_latex(e.axis))}\,{latex(e.angle)}\right)"


def _inverse(e: Inverse) -> str:
    """``A^{-1}``, and ``A^{-T}`` of a transpose; of a scalar symbol, a fraction."""
    if isinstance(e.arg, Symbol) and e.shape == (1, 1):
        return rf"\frac{{1}}{{{latex(e.arg)}}}"
    text = _factor(e.arg.arg if isinstance(e.arg, Transpose) else e.arg)
    script = r"-\top" if isinstance(e.arg, Transpose) else "-1"
    return rf"\left({text}\right)^{{{script}}}" if "^" in text and not text.endswith(")") else rf"{text}^{{{script}}}"


ALONG = r"(\xi)"
"""The end of the LaTeX of a quantity that varies along the link: it stands under the integral."""


def _integral(e: Integral) -> str:
    weight = "" if e.weight is None else latex(e.weight)
    under = weight if weight.endswith(ALONG) else ""
    integrand = "" if is_identity(e.integrand) else _factor(e.integrand, True)
    inside = "".join(rf"{part}\," for part in (under, integrand) if part)
    return rf"{weight.removesuffix(under)}\int_{{a_{e.index}}}^{{c_{e.index}}} {inside}d\xi"


_LATEX: dict[type, Callable] = {
    Symbol: lambda e: symbol(e.display.removesuffix(TRANSPOSED) if e.shape == (1, 1) else e.display),
    Constant: _constant,
    Sum: lambda e: " ".join(terms(e)),
    Product: _product,
    Negative: _negative,
    Transpose: _transpose,
    Hat: _hat,
    Trace: lambda e: rf"\operatorname{{tr}}\left({latex(e.arg)}\right)",
    Diagonal: lambda e: rf"\operatorname{{diag}}\left({latex(e.arg)}\right)",
    BlockMatrix: _block,
    Rotation: _rotation,
    Stumpff: lambda e: rf"\mathrm{{c}}_{{{e.order}}}\left({latex(e.arg)}\right)",
    Inverse: _inverse,
    Root: lambda e: rf"\sqrt{{{latex(e.arg)}}}",
    Integral: _integral,
}
