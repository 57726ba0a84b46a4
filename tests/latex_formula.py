"""Formulas of a document read as LaTeX: `value(text, known)` is what a formula is, with what `known` says of symbols.

Values are arrays of two dimensions. A symbol is meant by its LaTeX with scripts; `known` raises KeyError for others.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import reduce

import numpy as np

GROUP = r"\{(?:[^{}]|\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\})*\}"
LETTER = rf"(?:\\(?:mathbf|boldsymbol|mathcal|mathrm|bar|hat|dot|ddot){GROUP}|\\partial\\(?:mathbf|boldsymbol){GROUP}"
WORDS = "left|right|frac|tfrac|sqrt|sum|cos|sin|exp|max|begin|end|times|quad|operatorname"
LETTER += rf"|\\partial\\ell|\\(?!{WORDS})[a-zA-Z]+|[a-zA-Z])"
SCRIPT = r"(?:\{[^{}]*\}|\\[a-zA-Z]+|[a-zA-Z0-9])"
SYMBOL = re.compile(
    rf"(?P<tilde>\\tilde\{{)?(?P<letter>{LETTER})(?(tilde)\}})'*(?:_{SCRIPT})?(?:\^[*APacf])?(?:_{SCRIPT})?"
)
NUMBER = re.compile(r"(?:(\d+(?:\.\d+)?)\\times )?10\^\{(-?\d+)\}|\d+(?:\.\d+)?")
POWER = re.compile(r"\^(?:\{(\d+)\}|(\d))")
SKIP = re.compile(r"(?:\\,|\\;|\\ |\\quad|~|\s)+")
ENDS = ("+", "-", r"\right", r"\end", ")", "]", "}", "&", r"\\", ",", ";", "=")
AXES = {rf"\mathbf{{e}}_{x}": np.eye(3)[:, [k]] for k, x in enumerate("xyz")}


def skew(a: np.ndarray) -> np.ndarray:
    x, y, z = np.ravel(a)
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


class Zero:
    """A zero of the size that its place asks for."""


ZERO = Zero()
Value = np.ndarray | Zero


def plus(a: Value, b: Value, sign: float = 1.0) -> Value:
    if isinstance(b, Zero):
        return a
    if isinstance(a, Zero):
        return sign * b
    if a.shape != b.shape:
        raise ValueError(f"a sum of shapes {a.shape} and {b.shape}")
    return a + sign * b


def times(a: Value, b: Value) -> Value:
    if isinstance(a, Zero) or isinstance(b, Zero):
        return ZERO
    return a * b if 1 in (a.size, b.size) and (1, 1) in (a.shape, b.shape) else a @ b


def blocks(rows: list[list[Value]]) -> Value:
    """A matrix of blocks; the size of zeros follows from their neighbours."""
    if all(isinstance(x, Zero) for row in rows for x in row):
        return ZERO
    heights = _filled([next((x.shape[0] for x in row if not isinstance(x, Zero)), None) for row in rows])
    columns = list(zip(*rows, strict=True))
    widths = _filled([next((x.shape[1] for x in column if not isinstance(x, Zero)), None) for column in columns])
    whole = lambda x, i, j: np.zeros((heights[i], widths[j])) if isinstance(x, Zero) else x  # noqa: E731
    return np.block([[whole(x, i, j) for j, x in enumerate(row)] for i, row in enumerate(rows)])


def _filled(sizes: list[int | None]) -> list[int]:
    """Sizes of rows; one of zeros alone is as large as the largest. A link without modes has columns of size 0."""
    largest = max(size or 0 for size in sizes) or 1
    return [largest if size is None else size for size in sizes]


class Reader:
    """A formula from left to right."""

    def __init__(self, text: str, known: Callable[[str], Value]):
        self.text, self.known = text, known

    def skip(self) -> None:
        if match := SKIP.match(self.text):
            self.text = self.text[match.end() :]

    def take(self, *options: str) -> str:
        self.skip()
        for option in options:
            if self.text.startswith(option):
                self.text = self.text[len(option) :]
                return option
        return ""

    def need(self, *options: str) -> None:
        if not self.take(*options):
            raise SyntaxError(f"{options} expected at {self.text!r}")

    def sum(self) -> Value:
        total: Value = times(np.full((1, 1), -1.0), self.product()) if self.take("-") else self.product()
        while sign := self.take("+", "-"):
            total = plus(total, self.product(), 1.0 if sign == "+" else -1.0)
        return total

    def product(self) -> Value:
        value = self.factor()
        while True:
            if self.take(r"\times"):
                value = skew(value) @ self.factor()
                continue
            if self.take("/"):
                value = value / self.factor()
                continue
            self.skip()
            if not self.text or self.text.startswith(ENDS):
                return value
            value = times(value, self.factor())

    def factor(self) -> Value:
        value = self.atom()
        while self.text.startswith("^"):
            if self.take(r"^{\top}"):
                value = value if isinstance(value, Zero) else value.T
            elif power := POWER.match(self.text):
                self.text = self.text[power.end() :]
                value = reduce(times, [value] * int(power[1] or power[2]))
            elif self.take("^{-1}"):
                value = np.linalg.inv(value)
            elif self.take(r"^{-\top}"):
                value = np.linalg.inv(value).T
            else:
                raise SyntaxError(self.text)
        return value

    def group(self) -> Value:
        self.need("{")
        value = self.sum()
        self.need("}")
        return value

    def atom(self) -> Value:
        self.skip()
        if self.take(r"\left(", "("):
            value = self.sum()
            self.need(r"\right)", ")")
            return value
        if self.take(r"\frac", r"\tfrac"):
            above, below = self.group(), self.group()
            return above / below
        if self.take(r"\sqrt"):
            return np.sqrt(self.group())
        if self.take(r"\left|"):
            value = np.abs(self.sum())
            self.need(r"\right|")
            return value
        if name := self.take(r"\cos", r"\sin", r"\exp"):
            return getattr(np, name[1:])(self.factor())
        if self.take(r"\max\left("):
            first = self.sum()
            self.need(",")
            second = self.sum()
            self.need(r"\right)")
            return np.maximum(first, second)
        if self.take(r"\operatorname{atan2}("):
            first = self.sum()
            self.need(",")
            second = self.sum()
            self.need(")")
            return np.arctan2(first, second)
        if self.take(r"\mathrm{H}"):
            return (self.factor() > 0).astype(float)
        if self.take(r"\operatorname{tr}"):
            return np.full((1, 1), np.trace(self.atom()))
        if self.take(r"\mathrm{diag}("):
            value = self.sum()
            self.need(")")
            return np.diag(np.ravel(value))
        if self.take(r"\begin{bmatrix}"):
            return self.matrix()
        if self.take("["):
            return self.stack()
        if self.text.startswith("{"):
            return self.group()
        return self.plain()

    def matrix(self) -> Value:
        rows: list[list[Value]] = [[self.sum()]]
        while end := self.take("&", r"\\", r"\end{bmatrix}"):
            if end == r"\end{bmatrix}":
                return blocks(rows)
            if end == "&":
                rows[-1].append(self.sum())
            else:
                rows.append([self.sum()])
        raise SyntaxError(self.text)

    def stack(self) -> Value:
        parts = [[self.sum()]]
        while self.take(";", ","):
            parts.append([self.sum()])
        self.need("]")
        return blocks(parts)

    def plain(self) -> Value:
        if match := NUMBER.match(self.text):
            self.text = self.text[match.end() :]
            return np.full((1, 1), float(f"{match[1] or 1}e{match[2]}" if match[2] else match[0]))
        if match := re.match(r"\\mathbf\{I\}_(?:\{(\d)\}|(\d))", self.text):
            self.text = self.text[match.end() :]
            return np.eye(int(match[1] or match[2]))
        if match := re.match(r"\\mathbf\{0\}|0(?!\d)", self.text):
            self.text = self.text[match.end() :]
            return ZERO
        match = SYMBOL.match(self.text)
        if match is None:
            raise SyntaxError(self.text)
        self.text = self.text[match.end() :]
        if match["tilde"]:
            found = self.known(match[0].replace(r"\tilde{" + match["letter"] + "}", match["letter"], 1))
            return found if isinstance(found, Zero) else skew(found)
        return AXES[match[0]] if match[0] in AXES else self.known(match[0])


def value(text: str, known: Callable[[str], Value]) -> Value:
    """What a formula is; SyntaxError where it is none that can be read, KeyError where it has an unknown symbol."""
    reader = Reader(text.strip(), known)
    found = reader.sum()
    reader.skip()
    if reader.text:
        raise SyntaxError(f"{reader.text!r} is left of {text!r}")
    return found
