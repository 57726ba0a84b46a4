"""Rods of order "exact" and tendons as a document says them: sums over Gauss points of what its steps have of one."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise

import mpmath as mp
import numpy as np
from document_symbols import Part, Scope, Undefined, number, plain, sized, vector
from latex_formula import skew
from oracle_shapes import clamped_free, polynomial, tabulate

FINE, NEAR = 24, 1e-60
AXIS = {"axial": 0, "shear y": 1, "shear z": 2}
TURN = {"torsion": (0, 1.0), "bending z": (1, -1.0), "bending y": (2, 1.0)}


def gauss(n: int) -> tuple[np.ndarray, np.ndarray]:
    x, w = np.polynomial.legendre.leggauss(n)
    return (x + 1) / 2, w / 2


@cache
def functions(direction: str, basis: str, count: int) -> list:
    """The shapes of a direction, s -> (ψ, ψ', ψ'')."""
    bends = direction.startswith("bending")
    if basis == "polynomial":
        return polynomial(count, 2 if bends else 1)
    if bends:
        return clamped_free(count)
    waves = [(2 * k - 1) * mp.pi / 2 for k in range(1, count + 1)]
    root = mp.sqrt(2)
    return [
        lambda s, w=w: (root * mp.sin(w * s), root * w * mp.cos(w * s), -root * w * w * mp.sin(w * s)) for w in waves
    ]


class Rod:
    """The shapes of a class of links, from its table of shapes and what is said of their families."""

    def __init__(self, parts: list[Part], segment: tuple[int, int] = (0, 1)):
        self.segment = segment
        field = next(p for p in parts if p.title == "Kinematic field")
        self.text = field.text
        rows = next(t for t in field.tables if t.head[0] == "shape" and t.head[1] == "direction").rows
        self.modes = [(row[1].replace(" in ", " "), int(row[2]) - 1) for row in rows]
        counts = {d: sum(x == d for x, _ in self.modes) for d, _ in self.modes}
        self.shapes = {d: functions(d, self._family(d), n) for d, n in counts.items()}
        self.rest = self._rest()
        self.points = int(re.search(r"(\d+) Gauss points", self.text)[1])
        self.s, self.w = gauss(self.points)

    def _family(self, direction: str) -> str:
        """The family whose paragraph names a direction."""
        named = (re.fullmatch(r"([a-z ]+): (.*)", line) for line in self.text.lower().split("\n"))
        wanted = direction.replace(" ", " in ")
        said = next(match[2] for match in named if match and wanted in match[1].split(" and "))
        return "polynomial" if "polynomial" in said else "clamped_free"

    def _rest(self) -> list[tuple[np.ndarray, list[float], int]]:
        """Of each number at rest its column, the stations along the whole link, and the number of its own."""
        said = re.search(
            r"columns of \$[^$]*\$ that are (.*?)(?:, each times .*? stations \$([^$]*)\$ .*?)?\. In \(R2\)", self.text
        )
        if said is None:
            return []
        signs = [(m[2], -1.0 if m[1] else 1.0) for m in re.finditer(r"\$(-?)\\mathbf\{e\}_([xyz])\$", said[1])]
        axes = [sign * np.eye(3)["xyz".index(letter)] for letter, sign in signs]
        places = [number(x) for x in said[2].split(",")] if said[2] else []
        return [(axis, places, k) for axis in axes for k in range(len(places) or 1)]

    def resting(self, s: float) -> np.ndarray:
        """(3, p): the columns of the curvature at rest at s, along the segment."""
        whole = (self.segment[0] + s) / self.segment[1]
        at = lambda places, k: np.interp(whole, places, np.eye(len(places))[k]) if places else 1.0  # noqa: E731
        return np.array([at(places, k) * axis for axis, places, k in self.rest]).reshape(-1, 3).T

    def kinks(self, a: float, b: float) -> list[float]:
        """From a to b, with the stations of the curvature at rest between them."""
        places = {x * self.segment[1] - self.segment[0] for _, own, _ in self.rest for x in own}
        return [a, *sorted(s for s in places if a + 1e-12 < s < b - 1e-12), b]

    def at(self, s: float) -> list[np.ndarray]:
        """Value, first and second derivative of each mode's shape, (3, r)."""
        return _at(self, float(s))

    def stretch(self, s: float) -> np.ndarray:
        out, table = np.zeros((3, len(self.modes))), self.at(s)
        for m, (d, _) in enumerate(self.modes):
            if d in AXIS:
                out[AXIS[d], m] = table[1][m]
        return out

    def turned(self, s: float, derivative: int) -> np.ndarray:
        """(3, r): by each mode the turn of the section at s of a rod of unit length, or the curvature there."""
        out, table = np.zeros((3, len(self.modes))), self.at(s)
        for m, (d, _) in enumerate(self.modes):
            if d in TURN:
                axis, sign = TURN[d]
                out[axis, m] = sign * table[derivative + (d != "torsion")][m]
        return np.hstack([out, self.resting(s) if derivative else self._integral(s)]) if self.rest else out

    def _integral(self, s: float) -> np.ndarray:
        """(3, p): the integral of the columns at rest from the base, which are linear between stations."""
        ends = pairwise(self.kinks(0.0, s))
        return sum(((b - a) * self.resting((a + b) / 2) for a, b in ends), np.zeros((3, len(self.rest))))

    def reach(self, s: float) -> np.ndarray:
        """The integrals from 0 to s of the Lagrange polynomials of the points."""
        if s == 1.0:
            return self.w
        x, w = gauss(self.points)
        out = []
        for k in range(self.points):
            others = [j for j in range(self.points) if j != k]
            values = [np.prod([(s * y - self.s[j]) / (self.s[k] - self.s[j]) for j in others]) for y in x]
            out.append(s * np.dot(w, values))
        return np.array(out)


_TABLES: dict = {}


def _at(rod: Rod, s: float) -> list[np.ndarray]:
    key = (id(rod), s)
    if key not in _TABLES:
        own = {d: tabulate(f, [max(s, NEAR)])[:, :, 0] for d, f in rod.shapes.items()}
        _TABLES[key] = (rod, [np.array([own[d][n][k] for d, k in rod.modes]) for n in range(3)])
    return _TABLES[key][1]


def scale(rod: Rod, length: float) -> np.ndarray:
    return np.diag([1.0 if d == "torsion" else 1.0 / length for d, _ in rod.modes])


def parted(rod: Rod, a: float, b: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Gauss points from a to b and their weights, so many between stations of the curvature at rest."""
    x, w = gauss(count)
    parts = [(c + (d - c) * x, (d - c) * w) for c, d in pairwise(rod.kinks(a, b))]
    return tuple(np.concatenate(values) for values in zip(*parts, strict=True))


def column(x) -> np.ndarray:
    return np.reshape(x, (-1, 1))


def turn(rod: Rod, a: float, b: float, zeta, rate) -> dict[str, np.ndarray]:
    """(R2) from the section at a to that at b, with its derivative and its rates."""
    modes, still = len(rate), np.zeros((len(zeta) - len(rate), 1))
    rate = np.vstack([rate, still])
    y, w = parted(rod, a, b, FINE)
    start, end = rod.turned(a, 0), rod.turned(b, 0)
    psi = [rod.turned(x, 0) - start for x in y]
    kappa = [rod.turned(x, 1) for x in y]
    cross = lambda u, v: skew(u) @ v  # noqa: E731
    half = 0.5
    total, by, bend = (end - start) @ zeta, end - start, np.zeros((3, 1))
    by = by + half * sum(v * (skew(p @ zeta) @ k - skew(k @ zeta) @ p) for v, p, k in zip(w, psi, kappa, strict=True))
    total = total + half * sum(v * cross(p @ zeta, k @ zeta) for v, p, k in zip(w, psi, kappa, strict=True))
    bend = 2 * half * sum(v * cross(p @ rate, k @ rate) for v, p, k in zip(w, psi, kappa, strict=True))
    return {"theta": total, "by": by[:, :modes], "rate": by @ rate, "bend": bend}


def run(scope: Scope, part: Part, local: dict) -> dict:
    """All steps of a part for one point; symbols without a step there are zero."""
    found = dict(local)
    for name, definition in part.steps.items():
        found[name] = scope.step(definition, found)
    return found


def exact_rod(scope: Scope, parts: list[Part], s: float = 1.0, segment: tuple[int, int] = (0, 1)) -> dict:
    """The sums along a rod, and its section at s, by the LaTeX of their symbols in the equations of the link."""
    rod, named = Rod(parts, segment), {p.title: p for p in parts}
    length, r = float(scope("l_i").item()), len(rod.modes)
    Z = scale(rod, length)
    zeta, rate = Z @ scope(r"\boldsymbol{\eta}_i"), Z @ scope(r"\dot{\boldsymbol{\eta}}_i")
    whole = np.vstack([zeta, scope(r"\boldsymbol{\zeta}_0")]) if rod.rest else zeta
    none, before, place, at = np.zeros((3, r)), None, 0.0, []

    def section(to: float, stretch: np.ndarray) -> dict:
        return _section(
            scope, named["Section of the rod"], turn(rod, place, to, whole, rate), stretch, before, length, zeta, rate
        )

    end = None
    for x in rod.s:
        if end is None and s < x:
            end = section(s, none)
        before = section(x, rod.stretch(x))
        at.append(before)
        place = x
    end = end or section(s, none)
    out = _section_symbols(scope, rod, at, end, s, Z)
    return out | _sums(scope, parts, rod, at, Z)


def _section(scope, part, turned, stretch, before, length, zeta, rate) -> dict:
    r = len(zeta)
    old = before or {
        r"\mathbf{R}_k": np.eye(3),
        r"\mathbf{W}_k": np.zeros((3, r)),
        r"\boldsymbol{\omega}_{s,k}": np.zeros((3, 1)),
    }
    local = {
        r"\boldsymbol{\Omega}_k": turned["theta"],
        r"\partial\boldsymbol{\Omega}_k": turned["by"],
        r"\dot{\boldsymbol{\Omega}}_k": turned["rate"],
        r"\ddot{\boldsymbol{\Omega}}_k": turned["bend"],
        r"\mathbf{R}_{k-1}": old[r"\mathbf{R}_k"],
        r"\mathbf{W}_{k-1}": old[r"\mathbf{W}_k"],
        r"\boldsymbol{\omega}_{s,k-1}": old[r"\boldsymbol{\omega}_{s,k}"],
        r"\boldsymbol{\alpha}_{s,k-1}": old.get(r"\boldsymbol{\alpha}_{s,k}", np.zeros((3, 1))),
        r"\boldsymbol{\gamma}_k": stretch @ zeta,
        r"\partial\boldsymbol{\gamma}_k": stretch,
        r"\dot{\boldsymbol{\gamma}}_k": stretch @ rate,
        r"\ddot{\boldsymbol{\gamma}}_k": np.zeros((3, 1)),
    }
    return run(scope, part, local)


def _section_symbols(scope, rod, at, end, s, Z) -> dict:
    a = rod.reach(s)
    sum_of = lambda name: sum(w * sized(x[name], x[name].shape) for w, x in zip(a, at, strict=True))  # noqa: E731
    start = sized(scope("a_i"), (1, 1)) * np.eye(3)[:, [0]]
    return {
        r"\mathbf{R}_T": end[r"\mathbf{R}_k"],
        r"\boldsymbol{\Psi}_c": end[r"\mathbf{W}_k"] @ Z,
        r"\mathbf{J}_l": np.eye(3),
        r"\boldsymbol{\omega}_s": end[r"\boldsymbol{\omega}_{s,k}"],
        r"\boldsymbol{\alpha}_s": end[r"\boldsymbol{\alpha}_{s,k}"],
        r"\mathbf{r}_T": start + sum_of(r"\mathbf{t}_k"),
        r"\boldsymbol{\phi}_c": sum_of(r"\partial\mathbf{t}_k") @ Z,
        r"\dot{\mathbf{u}}_T": sum_of(r"\dot{\mathbf{t}}_k"),
        r"\ddot{\mathbf{r}}_T": sum_of(r"\ddot{\mathbf{t}}_k"),
    }


def _masses(scope, rod) -> tuple[list[np.ndarray], list[float], np.ndarray]:
    """Weights of the tangents in the place of each mass, its share, and the weights of the centre."""
    if "Cholesky" in rod.text:
        x, w = gauss(FINE)
        a = np.array([rod.reach(y) for y in x])
        factor = np.linalg.cholesky(a.T @ (w[:, None] * a))
        return list(factor.T), [1.0] * rod.points, w @ a
    count, ends = re.search(r"the (\d+) Gauss points of each piece between \$s = ([^$]*)\$", rod.text).groups()
    bounds, (x, _) = [number(e) for e in ends.split(",")], gauss(int(count))
    places = [a + (b - a) * y for a, b in pairwise(bounds) for y in x]
    shares = np.ravel(scope(r"\mathrm{d}\mathbf{m}/\mu"))
    return [rod.reach(p) for p in places], shares.tolist(), np.ravel(scope(r"\mathbf{c}"))


def _sums(scope, parts, rod, at, Z) -> dict:
    named = {p.title: p for p in parts}
    omega, mu = scope(r"\boldsymbol{\omega}_i"), float(scope(r"\mu_i").item())
    Omega = skew(omega) @ skew(omega)
    t, ds = [x[r"\mathbf{t}_k"] for x in at], [x[r"\dot{\mathbf{t}}_k"] for x in at]
    a_t = [Omega @ u + 2 * skew(omega) @ d + x[r"\ddot{\mathbf{t}}_k"] for u, d, x in zip(t, ds, at, strict=True)]
    u_t = [skew(omega) @ u + d for u, d in zip(t, ds, strict=True)]
    by = [x[r"\partial\mathbf{t}_k"] for x in at]
    mean = lambda c, xs: sum(w * x for w, x in zip(c, xs, strict=True))  # noqa: E731
    rows, shares, centre = _masses(scope, rod)
    total = {r"\bar{\mathbf{r}}": mean(centre, t), r"\bar{\mathbf{P}}": mean(centre, by) @ Z}
    total |= {r"\bar{\mathbf{a}}": mean(centre, a_t), r"\bar{\mathbf{u}}": mean(centre, u_t)}
    a_0 = scope(r"\mathbf{a}_r") if scope.has(r"\mathbf{a}_r") else scope(r"\mathbf{a}_0")
    force = [w * a_0 for w in centre]
    summed = dict.fromkeys(("J", "C", "M", "tau"), 0.0)
    letters = {
        "J": r"\mathbf{J}_{\mu m}",
        "C": r"\mathbf{C}_{\mu m}",
        "M": r"\mathbf{M}_{\mu m}",
        "tau": r"\boldsymbol{\tau}_{\mu m}",
    }
    for c, share in zip(rows, shares, strict=True):
        own = {
            r"\mathrm{d}m_m/\mu": np.full((1, 1), share),
            r"\mathbf{r}_{\mu m}": mean(c, t),
            r"\mathbf{P}_{\mu m}": mean(c, by),
        }
        own |= {r"\mathbf{a}_{\mu m}": mean(c, a_t), r"\mathbf{u}_{\mu m}": mean(c, u_t)}
        found = run(scope, named["Mass of the rod"], own)
        summed = {n: summed[n] + found[letters[n]] for n in summed}
        force = [f + w * share * own[r"\mathbf{a}_{\mu m}"] for f, w in zip(force, c, strict=True)]
    total |= {r"\sum_m\mathbf{J}_{\mu m}": summed["J"], r"\sum_m\mathbf{C}_{\mu m}": summed["C"] @ Z}
    total |= {r"\sum_m\mathbf{M}_{\mu m}": Z @ summed["M"] @ Z, r"\sum_m\boldsymbol{\tau}_{\mu m}": summed["tau"]}
    moments = [np.zeros((3, 1)) for _ in at]
    if "Inertia of a section" in named:
        spun = {"I": 0.0, "C": 0.0, "M": 0.0}
        for k, x in enumerate(at):
            local = dict(x) | {
                rf"\mathrm{{d}}I_{{{a}k}}": scope.entry(rf"\mathrm{{d}}\mathbf{{I}}_{a}", k) for a in "xyz"
            }
            local |= {r"\boldsymbol{\alpha}_i": np.zeros((3, 1))}
            found = run(scope, named["Inertia of a section"], local)
            moments[k] = found[r"\boldsymbol{\tau}_{s,k}"]
            spun = {n: spun[n] + found[rf"\mathbf{{{n}}}_{{s,k}}"] for n in spun}
        total |= {r"\sum_k\mathbf{I}_{s,k}": spun["I"], r"\sum_k\mathbf{C}_{s,k}": spun["C"] @ Z}
        total |= {r"\sum_k\mathbf{M}_{s,k}": Z @ spun["M"] @ Z, r"\sum_k\boldsymbol{\tau}_{s,k}": sum(moments)}
    load, moment = 0.0, np.zeros((3, 1))
    for x, f, tau in zip(at[::-1], force[::-1], moments[::-1], strict=True):
        local = dict(x) | {r"\mathbf{m}_{s,k+1}": moment, r"\mathbf{f}_{t,k}": mu * f, r"\boldsymbol{\tau}_{s,k}": tau}
        found = run(scope, named["Load of a section on the modes"], local)
        moment, load = found[r"\mathbf{m}_{s,k}"], load + found[r"\mathbf{h}_{\eta k}"]
    return total | {r"\sum_k\mathbf{h}_{\eta k}": Z @ load}


def pull(scope: Scope, parts: list[Part], row: tuple[str, ...], cut: tuple[float, float]) -> np.ndarray:
    """(r, 1): the derivative of the length of a piece of a tendon, a row of its table, with the modes of a link.

    ``cut``: where the link, or its segment, begins and ends along the link of the row.
    """
    count = round(1 / (cut[1] - cut[0]))
    rod, part = Rod(parts, (round(cut[0] * count), count)), next(p for p in parts if p.title.startswith("Tendon at"))
    s_0, s_1, d_0, d_1 = number(row[3]), number(row[4]), vector(row[5]), vector(row[6])
    first, last = max(s_0, cut[0]), min(s_1, cut[1])
    if first >= last:
        return np.zeros((len(rod.modes), 1))
    d = lambda s: d_0 + (s - s_0) / (s_1 - s_0) * (d_1 - d_0)  # noqa: E731
    begin, end, own = d(first), d(last), cut[1] - cut[0]
    s_0, s_1 = (first - cut[0]) / own, (last - cut[0]) / own
    length = float(scope("l_i").item())
    Z = scale(rod, length)
    zeta = Z @ scope(r"\boldsymbol{\eta}_i")
    if "At order 1 the length is linear" in rod.text:
        zeta = 0 * zeta
    whole, total = np.vstack([zeta, scope(r"\boldsymbol{\zeta}_0")]) if rod.rest else zeta, 0.0
    for s, w in zip(*parted(rod, s_0, s_1, rod.points), strict=True):
        x, stretch, curvature = (s - s_0) / (s_1 - s_0), rod.stretch(s), rod.turned(s, 1)
        local = {
            "w_{c,k}": np.full((1, 1), w),
            r"\mathbf{d}_{c,k}": ((1 - x) * begin + x * end) / length,
            r"\mathbf{d}'": (end - begin) / (length * (s_1 - s_0)),
            r"\boldsymbol{\gamma}_k": stretch @ zeta,
            r"\boldsymbol{\kappa}_k": curvature @ whole,
            r"\partial\boldsymbol{\gamma}_k": stretch,
            r"\partial\boldsymbol{\kappa}_k": curvature[:, : len(zeta)],
        }
        total = total + run(scope, part, local)[plain(r"\partial\ell_k")]
    return length * Z @ total


__all__ = ["Undefined", "exact_rod", "pull"]
