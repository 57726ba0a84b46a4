"""A robot's accelerations by what its document prints, and by nothing else: the judge of complete equations.

`accelerations_from_document(model, q, v, tau, w_ext)` makes the document of the robot and follows its section
"Algorithm" line by line: steps with their definitions, formulas as LaTeX, tables with their numbers. The derivation and
the other forms of the equations are not read. A symbol that nothing there defines is an error, `Undefined`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

import numpy as np
from document_forces import Acting
from document_loops import Loops
from document_points import pull
from document_state import Link, Reading, State
from document_symbols import Printed, Scope, plain, sized
from latex_formula import Value, value

from screwgen import Model
from screwgen.backends.latex import document as latex
from screwgen.backends.latex.content import Document

HELD = r"\boldsymbol{\sigma}_{b,i}", r"\mathbf{j}_{b,i}", r"\ddot{\mathbf{q}}_{b,i}"
MOTION, INWARD, ACCELERATIONS = "Outward: motion", "Inward: elimination", "Outward: accelerations"
"""The passes of the algorithm by their headings."""
TENSION = r" + \sum\limits_c T_c"
CARRIED = r" + \sum\limits_j "
FREE_LINKS = r"\dot{\mathbf{V}}_1", r"\mathbf{w}_1"
BEFORE = plain(r"\dot{\mathbf{V}}_{T,i-1}")


def accelerations_from_document(model: Model, q, v, tau, w_ext) -> tuple[np.ndarray, np.ndarray]:
    """`vdot` (nvz,) and the joint wrenches (n, 6), in the orders of NOTATION."""
    given = (np.asarray(x, float) for x in (q, v, tau))
    return Run(State(reading(model), *given, np.reshape(np.asarray(w_ext, float), (-1, 6)))).solved()


def reading(model: Model) -> Reading:
    """The document of a robot, made and read once."""
    return model.once(("document",), lambda: Reading(Printed(content_of(model))))


def content_of(model: Model) -> Document:
    """The document of a robot, made once."""
    return model.once(("content",), lambda: latex.content(model.robot))


Env = dict[str, Value]
"""What the lines have assigned of a link."""


class Run:
    """The passes of the algorithm in a state."""

    def __init__(self, state: State):
        self.state, self.links, self.document = state, state.links, state.reading.document
        self.lines = {p.title: p.equations for p in self.document.sections["Algorithm"]}
        self.axes = state.reading.axes
        for axis in self.axes:
            axis.prepare()
        self.efforts = {(axis.name, axis.number): axis.effort() for axis in self.axes}
        self.loops = Loops(self.document, state.scopes, self.axes)
        self.acting = Acting(self.document, state)
        self.pulls = [self._pulls(link) for link in self.links]

    def solved(self) -> tuple[np.ndarray, np.ndarray]:
        """`vdot` and the wrenches, with the forces that close loops."""
        envs = self.passed(forces := np.zeros(len(self.loops.gaps)))
        if len(forces):
            start = self._open(envs)
            S = np.array([self._open(self.passed(unit)) - start for unit in np.eye(len(forces))]).T
            weights = np.sqrt(np.diag(S) + np.trace(S) / 1000) if self.loops.shared else np.sqrt(np.diag(S))
            inverse = np.linalg.pinv(S / weights / weights[:, None], rcond=1e-9) / weights / weights[:, None]
            for _ in range(3):  # the last ones mend rounding
                forces = forces - inverse @ self._open(envs)
                envs = self.passed(forces)
        rates = [self._rates(link, env) for link, env in zip(self.links, envs, strict=True)]
        added = [np.ravel(self._rotor(axis, envs)) for axis in self.axes if axis.elastic]
        etas = [np.ravel(env[r"\ddot{\boldsymbol{\eta}}_i"]) for env in envs]
        wrenches = [
            np.ravel(e.get(r"\mathbf{w}_i", np.zeros(6)) if k.floats else e[r"\mathbf{w}_i"])
            for k, e in zip(self.links, envs, strict=True)
        ]
        internal = [self._internal_rate(owner, kind) for owner, kind in self.state.internal]
        return np.concatenate([*rates, *added, *etas, internal]), np.array(wrenches)

    def _internal_rate(self, owner, kind: str) -> float:
        """Of a law of an axis, or of a force between frames."""
        return self.acting.rates[owner, kind] if isinstance(owner, str) else owner.rates[kind]

    @staticmethod
    def _rates(link: Link, env: Env) -> np.ndarray:
        return np.ravel(env[plain(r"\dot{\mathbf{V}}_i" if link.floats else r"\ddot{\mathbf{q}}_i")])

    def _open(self, envs: list[Env]) -> np.ndarray:
        """`g̈ + 2 c ġ + c² g` of the rows."""
        tips = {k: env[plain(r"\dot{\mathbf{V}}_T")] for k, env in enumerate(envs)}
        turning = [x for k in self.links if not k.floats for x in self._rates(k, envs[k.number])[: len(k.axes)]]
        return self.loops.rates(tips, dict(enumerate(turning)))

    # ------------------------------------------------------------------------------------- passes

    def passed(self, forces: np.ndarray) -> list[Env]:
        """What the lines assign for every link, with forces of the rows."""
        loads, torques = self.loops.loads(forces)
        envs = [self._given(link, loads, torques) for link in self.links]
        for link in reversed(self.links):
            for left, _, right in self.lines[INWARD]:
                self._assign(link, envs, left, right)
        for link in self.links:
            for left, _, right in self.lines[ACCELERATIONS]:
                self._assign(link, envs, left, right)
        return envs

    def _given(self, link: Link, loads: list[np.ndarray], torques: Mapping) -> Env:
        """The external wrench, the bias of the link with tensions, and what acts on its axes."""
        scope = self.state.scopes[link.number]
        env = {plain(r"\boldsymbol{\mathcal{W}}_{ext,i}"): self.acting.wrenches[link.number] + loads[link.number]}
        right = next(right for left, _, right in self.lines[INWARD] if left == plain(r"\mathbf{h}^A_i"))
        tensions = right.partition(TENSION)[2].partition(CARRIED)[0].partition(" = ")[0]
        h = sized(scope(r"\mathbf{h}_i"), (6 + link.sizes[2], 1))
        for c, pulled in self.pulls[link.number]:
            known = {"T_c": np.full((1, 1), self.state.tensions[c]), plain(r"\partial\boldsymbol{\ell}_c"): pulled}
            nothing = r"\begin{bmatrix} \mathbf{0} \\"
            assert nothing in tensions, tensions
            modal = value("T_c" + tensions.replace(nothing, r"\begin{bmatrix}"), self._known(scope, known))
            h = h + np.vstack([np.zeros((6, 1)), modal])
        return env | {plain(r"\mathbf{h}_i"): h} | self._on_axes(link, torques)

    def _on_axes(self, link: Link, torques: Mapping) -> Env:
        nv, own = link.sizes[1], self.state.scopes[link.number].given["parameters"]
        base = {s: [own.get(f"{s}_{{{'m' if s == 'j' else 'q'},{k + 1}}}", 0.0) for k in range(nv)] for s in "jkd"}
        effort, told, given, held = np.zeros(nv), np.zeros(nv), np.zeros(nv), np.tile([1.0, 0.0, 0.0], (nv, 1))
        for axis in link.axes:
            k = axis.number
            held[k] = axis.held()
            told[k], given[k] = axis.tau, axis.given and not axis.elastic
            total, inertia, stiffness, damping = self.efforts[axis.name, k]
            effort[k] = total + torques.get(self.axes.index(axis), 0.0)
            base["j"][k] += inertia
            base["k"][k] += stiffness
            base["d"][k] += damping
        names = {"j": r"\mathbf{j}_m", "k": r"\mathbf{k}_q", "d": r"\mathbf{d}_q"}
        out = {plain(names[s]): np.reshape(base[s], (-1, 1)) for s in base}
        if link.sizes[0] != nv:  # a ball joint has no springs
            out[r"\mathbf{q}_i"] = np.zeros((nv, 1))
        out |= {plain(r"\mathbf{E}_i"): np.diag(given), plain(r"\bar{\mathbf{E}}_i"): np.diag(1 - given)}
        out |= {plain(name): held[:, [k]] for k, name in enumerate(HELD)}
        acting = {plain(r"\boldsymbol{\tau}_{q,i}"): effort[:, None], plain(r"\boldsymbol{\tau}_i"): effort[:, None]}
        return out | acting | ({plain(r"\boldsymbol{\tau}_i"): told[:, None]} if given.any() else {})

    def _known(self, scope: Scope, env: Env) -> Callable[[str], Value]:
        return lambda name: env[plain(name)] if plain(name) in env else scope(name)

    def _assign(self, link: Link, envs: list[Env], left: str, right: str) -> None:
        """One line of a link; a symbol that it needs and no line before has is an error."""
        env, scope = envs[link.number], self.state.scopes[link.number]
        if left in map(plain, FREE_LINKS):
            if link.floats:
                env[left.replace("_1", "_i")] = value(right.replace("_1", "_i"), self._known(scope, env))
            return
        if link.floats and not self._of_free(left):
            return
        known = dict(env)
        if r"\dot{\mathbf{V}}_{T,i-1}" in right:
            at_rest = link.parent < 0
            known[BEFORE] = np.zeros((6, 1)) if at_rest else self._tip_rate(link, envs[link.parent])
        body, *names = right.split(" = ")
        body, _, summed = body.partition(CARRIED)
        body = body.partition(TENSION)[0]  # what tensions do is in the bias already
        total = value(body, self._known(scope, known))
        for child in self.links if summed else ():
            if child.parent == link.number:
                own = {plain(x.replace("_i", "_j")): y for x, y in envs[child.number].items() if x.endswith("_i")}
                total = total + value(summed, self._known(self.state.scopes[child.number].parent, own))
        env[left] = total
        for name in names:
            self._split(env, name, total)

    @staticmethod
    def _of_free(left: str) -> bool:
        """Whether a line is one of those of a link that floats: those without its joint."""
        return left.startswith((r"\mathbf{M}^A", r"\mathbf{h}^A", r"\hat", r"\ddot{\boldsymbol", r"\dot{\mathbf{V}}_T"))

    def _tip_rate(self, link: Link, before: Env) -> np.ndarray:
        """The rate of the twist of the section that carries a link, by the line of tips."""
        right = next(right for left, _, right in self.lines[ACCELERATIONS] if left == plain(r"\dot{\mathbf{V}}_T"))
        return value(right, self._known(self.state.scopes[link.number].parent, before))

    @staticmethod
    def _split(env: Env, name: str, whole: Value) -> None:
        """The blocks of a matrix by their names."""
        rows = [
            row.split("&") for row in name.removeprefix(r"\begin{bmatrix}").removesuffix(r"\end{bmatrix}").split(r"\\")
        ]
        for k, row in enumerate(rows):
            for m, cell in enumerate(row):
                columns = slice(None) if len(row) == 1 else (slice(0, 6), slice(6, None))[m]
                env[plain(cell)] = whole[(slice(0, 6), slice(6, None))[k], columns]

    def _rotor(self, axis, envs: list[Env]) -> float:
        """The acceleration of the coordinate that an elastic gear adds."""
        if not axis.transmission:
            return axis.rotor()
        link = next(k for k in self.links if axis in k.axes)
        qddot = self._rates(link, envs[link.number])[axis.number]
        return -axis.ahead(qddot, 0.0) / (axis.ahead(qddot, 1.0) - axis.ahead(qddot, 0.0))

    def _pulls(self, link: Link) -> list[tuple[int, np.ndarray]]:
        name, (k, count) = link.name.partition("[")[0], link.segment
        cut = (k / count, (k + 1) / count)
        out = []
        for row in self.document.table("tension"):
            if row[2].strip("`") == name and link.sizes[2]:
                c = int(re.search(r"T_\{?(\d+)", row[0])[1]) - 1
                out.append((c, pull(self.state.scopes[link.number], link.parts, row, cut)))
        return out
