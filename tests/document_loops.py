"""What closes the tree of a robot, by the formulas and tables of its document."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from document_symbols import Printed, Scope, number, plain, sized, vector
from latex_formula import Value, value


@dataclass
class Gap:
    """A row that closes a loop or a coupling."""

    rate: float
    ends: tuple[int, int] = (-1, -1)
    """The links of A and B."""
    directions: dict[str, np.ndarray] | None = None
    """`n`, or `x` and `y`, in axes of the tips."""
    cosine: float = 0.0
    axes: tuple[int, int] = (-1, -1)
    """The numbers of the axes b and a of a coupling."""
    ratio: float = 0.0
    offset: float = 0.0


def gaps(document: Printed) -> list[Gap]:
    """In the order of their forces."""
    loops = {row[0]: row for row in document.table("loop")}
    couplings = {row[0]: row for row in document.table("coupling")}
    return [
        _of_loop(row, loops[row[1]]) if row[1] in loops else _coupling(couplings[row[1]])
        for row in document.table("force")
    ]


def _of_loop(row: tuple[str, ...], loop: tuple[str, ...]) -> Gap:
    a, b = (int(re.search(r"link (\d+)", cell)[1]) - 1 for cell in loop[1:3])
    parts = re.split(r"\$\\mathbf\{([nxy])\} =\$", row[2])
    found = {letter: vector(text) for letter, text in zip(parts[1::2], parts[2::2], strict=True)}
    cosine = number(row[2].rpartition("$c =$")[2]) if "y" in found else 0.0
    return Gap(number(loop[4]), (a, b), found, cosine)


def _coupling(row: tuple[str, ...]) -> Gap:
    b, a = (int(re.match(r"\$q_\{?(\d+)", cell)[1]) - 1 for cell in row[1:3])
    return Gap(number(row[5]), axes=(b, a), ratio=number(row[3]), offset=number(row[4]))


class Loops:
    """The rows of a robot's loops and couplings in a state."""

    def __init__(self, document: Printed, scopes: list[Scope], axes: list):
        self.gaps, self.scopes, self.axes = gaps(document), scopes, axes
        parts = [p for p in document.sections["Algorithm"] if p.title in ("Loops", "Couplings")]
        self.printed = [eq for part in parts for eq in part.equations]
        self.shared = any("share what they bear" in part.text for part in parts)
        self.units = [self._unit(g) for g in self.gaps]

    def formulas(self, left: str) -> list[str]:
        return [right for x, sign, right in self.printed if x == plain(left)]

    def _tips(self, gap: Gap, rates: dict[int, np.ndarray] | None = None) -> dict[str, Value]:
        """Places, velocities and directions of the tips A and B, in inertial axes."""
        known: dict[str, Value] = {}
        for letter, i in zip("AB", gap.ends, strict=True):
            scope = self.scopes[i]
            R, twist = scope(r"\mathbf{R}_{oT}"), sized(scope(r"\mathbf{V}_T"), (6, 1))
            known[rf"\mathbf{{r}}_{{o{letter}}}"] = sized(scope(r"\mathbf{r}_{oT}"), (3, 1))
            known[rf"\boldsymbol{{\omega}}_{letter}"] = R @ twist[:3]
            known[rf"\dot{{\mathbf{{r}}}}_{{o{letter}}}"] = R @ twist[3:]
            if rates is not None:
                known[rf"\dot{{\boldsymbol{{\omega}}}}_{letter}"] = R @ rates[i][:3]
                turning = np.cross(twist[:3].T, twist[3:].T).T
                known[rf"\ddot{{\mathbf{{r}}}}_{{o{letter}}}"] = R @ (rates[i][3:] + turning)
            for name, own in gap.directions.items():
                if letter == ("B" if name == "y" else "A"):
                    known[rf"\mathbf{{{name}}}"] = R @ own
        return known | {"c": np.full((1, 1), gap.cosine)}

    def _unit(self, gap: Gap) -> dict[str, np.ndarray]:
        """W_A and W_B of a row."""
        if gap.directions is None:
            return {}
        known = self._lookup(self._tips(gap))
        first = [x.rpartition(" = ")[2] for x in self.formulas(r"\mathbf{W}_A")]
        if "n" in gap.directions:
            return {"A": value(first[0], known), "B": value(self.formulas(r"\mathbf{W}_B")[0], known)}
        on_a = value(first[-1], known)
        return {"A": on_a, "B": -on_a}

    @staticmethod
    def _lookup(known: dict[str, Value]) -> Callable[[str], Value]:
        own = {plain(name): x for name, x in known.items()}
        return lambda name: own[plain(name)]

    def loads(self, forces: np.ndarray) -> tuple[list[np.ndarray], dict[int, float]]:
        """The wrenches on all tips, in their axes, and the torques on axes."""
        wrenches, torques = [np.zeros((6, 1)) for _ in self.scopes], {}
        for gap, unit, force in zip(self.gaps, self.units, forces, strict=True):
            for letter, i in zip(unit, gap.ends, strict=False):
                R = self.scopes[i](r"\mathbf{R}_{oT}")
                wrenches[i] = wrenches[i] + force * np.vstack([R.T @ unit[letter][:3], R.T @ unit[letter][3:]])
            if not unit:
                for letter, axis in zip("ba", gap.axes, strict=True):
                    name = rf"\tau_{{q,{letter}}}"
                    known = {name: np.full((1, 1), torques.get(axis, 0.0)), r"\lambda": np.full((1, 1), force)}
                    known["r"] = np.full((1, 1), gap.ratio)
                    torques[axis] = float(value(self.formulas(name)[0], self._lookup(known)).item())
        return wrenches, torques

    def rates(self, tips: dict[int, np.ndarray], axes: dict[int, float]) -> np.ndarray:
        """`g̈ + 2 c ġ + c² g` of all rows, with the rates of the tips' twists and the accelerations of axes."""
        return np.array([self._rate(g, u, tips, axes) for g, u in zip(self.gaps, self.units, strict=True)])

    def _rate(self, gap: Gap, unit, tips, axes) -> float:
        if gap.directions is None:
            (b, a), r = gap.axes, gap.ratio
            g = self.axes[b].q - r * self.axes[a].q - gap.offset
            rate = self.axes[b].qdot - r * self.axes[a].qdot
            return axes[b] - r * axes[a] + 2 * gap.rate * rate + gap.rate**2 * g
        known = self._tips(gap, tips) | {rf"\mathbf{{W}}_{x}": unit[x] for x in "AB"}
        kind = 0 if "n" in gap.directions else -1
        known[r"\gamma"] = value(self.formulas(r"\gamma")[kind], self._lookup(known))
        own = {
            "g": self.formulas("g")[kind],
            r"\dot{g}": self.formulas(r"\dot{g}")[0],
            r"\ddot{g}": self.formulas(r"\ddot{g}")[0],
        }
        g, rate, second = (float(value(text, self._lookup(known)).item()) for text in own.values())
        return second + 2 * gap.rate * rate + gap.rate**2 * g
