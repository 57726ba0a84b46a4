"""Formulas of the LaTeX document parsed back: on random numbers they are what the steps of the program are."""

from __future__ import annotations

import re

import numpy as np
from latex_documents import robot, tex

from screwgen.algorithms.scope import derived
from screwgen.backends.latex.symbols import written
from screwgen.topology.chain import Chain

LONG = re.compile(r"\\step\{([^}]*)\}\{[^\n]*\n\\begin\{alignat\*\}\{\d+\}\n(.*?)\\end\{alignat", re.DOTALL)
BRIEF = re.compile(r"\\brief\{([^}]*)\}\{[^\n]*%\n\{(.*)\}\n")


def skew(a):
    x, y, z = a.ravel()
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


class Parser:
    """Sums, products, transposes, powers and skew-symmetric matrices of known symbols; KeyError for all else."""

    def __init__(self, text, known):
        self.text, self.known = text.strip(), known
        self.names = sorted(known, key=len, reverse=True)

    def take(self, *options):
        self.text = self.text.lstrip()
        for option in options:
            if self.text.startswith(option):
                self.text = self.text[len(option) :]
                return option
        return ""

    def sum(self):
        sign = -1 if self.take("-") else 1
        total = sign * self.product()
        while sign := self.take("+", "-"):
            total = total + (1 if sign == "+" else -1) * self.product()
        return total

    def product(self):
        value = self.factor()
        while True:
            self.take(r"\,")
            if not self.text.strip() or self.text.lstrip().startswith(("+", "-", r"\right")):
                return value
            other = self.factor()
            scalar = 1 in (np.size(value), np.size(other))
            value = value * other if scalar else value @ other

    def factor(self):
        value = self.atom()
        if self.take(r"^{\top}"):
            value = value.T
        if self.take("^{2}"):
            value = value @ value
        return value

    def atom(self):
        if self.take(r"\left("):
            value = self.sum()
            assert self.take(r"\right)")
            return value
        if half := self.take(r"\tfrac{1}{2}"):
            return np.full((1, 1), 0.5 if half else 1.0)
        if match := re.match(r"\d+(?:\.\d+)?", self.text):
            self.text = self.text[match.end() :]
            return np.full((1, 1), float(match[0]))
        if match := re.match(r"\\mathbf\{I\}_\{(\d)\}", self.text):
            self.text = self.text[match.end() :]
            return np.eye(int(match[1]))
        if name := self.take(*self.names):
            return self.known[name]
        for name in self.names:
            head = re.fullmatch(r"(\\(?:mathbf|boldsymbol)\{\\?\w+\})(.*)", name)
            if head and self.take(rf"\tilde{{{head[1]}}}{head[2]}"):
                return skew(self.known[name])
        raise KeyError(self.text)


def values(block, generator):
    """Random inputs, and what the steps of the program make of them, by the LaTeX of their symbols."""
    numbers, found = {}, {}
    for signal in block.inputs.values():
        value = generator.uniform(0.5, 1.5, signal.shape)
        found[signal.name] = value
        numbers |= {label: value[index] for index, label in signal.labels()}
    for name, step in block.steps.items():
        for symbol, expression in step.assignments:
            numbers[symbol.name] = float(expression.subs({s: numbers[s.name] for s in expression.free_symbols}))
        at = np.vectorize(lambda e: float(e.subs({s: numbers[s.name] for s in e.free_symbols})), otypes=[float])
        found[name] = at(np.vectorize(lambda e: e + 0 * e, otypes=[object])(block.values[name]))
    return found


def steps_that_come_back(name):
    """The steps of a block of the first link whose printed formula parses; each has the program's value."""
    block = derived(Chain(robot("ella")).classes[0])[name]
    found = values(block, np.random.default_rng(1))
    signals = {**block.inputs, **{name: step.signal for name, step in block.steps.items()}}
    known = {written(signal): found[name] for name, signal in signals.items()}
    text = tex("ella").split(r"\section{Link class 1}")[1].split(r"\section{")[0]
    for step, formula in [*LONG.findall(text), *BRIEF.findall(text)]:
        step = step.replace(r"\_", "_")
        right = re.sub(r"\\\\\n.*?& \\quad|\n", " ", formula).partition(" = ")[2].split(" = ")[0]
        if step not in block.steps or "&" in right:
            continue
        try:
            parsed = Parser(right, {k: v for k, v in known.items() if k != written(signals[step])}).sum()
        except (KeyError, AssertionError):
            continue
        np.testing.assert_allclose(parsed, found[step], rtol=1e-10, atol=1e-10, err_msg=step)
        yield step


def test_ten_steps_come_back():
    back = {(name, step) for name in ("link", "tip_body", "energy") for step in steps_that_come_back(name)}
    assert len(back) >= 10, back
