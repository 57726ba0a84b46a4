"""A robot's accelerations by what its document prints, and by nothing else: the judge of complete equations.

`accelerations_from_document(model, q, v, tau, w_ext)` makes the document of the robot and reads it: steps with their
definitions, formulas as LaTeX, tables with their numbers. The equations that have accelerations, wrenches and forces of
loops are linear in these, so they are those that fulfil them all. A symbol that nothing in the document defines is an
error, `Undefined`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

import numpy as np
from document_loops import Loops
from document_points import pull
from document_state import Link, Reading, State
from document_symbols import Printed, Scope, Undefined, plain, sized
from latex_formula import Value, plus, value

from screwgen import Model
from screwgen.backends.latex import document as latex

LINK_ROWS = r"\mathbf{M}_i\,\dot{\boldsymbol{\nu}}_i + \mathbf{h}_i"
ON_LINK = r"\begin{bmatrix} \boldsymbol{\mathcal{W}}^*_i \\ \mathbf{f}^*_i \end{bmatrix}"
JOINT_ROWS = r"\mathbf{J}_B\,\dot{\mathbf{V}}_i"
AXIS_ROWS = (r"\mathbf{S}_i^{\top}\,\mathbf{w}_i", r"\mathbf{A}_i^{\top}\,\boldsymbol{\tau}_{w,i}")
FAR = 1e8
"""An unknown so large that what does not depend on it is lost beside it."""
TENSION = r" - \sum\limits_c T_c"
JOINT_MOTION = re.compile(
    r"\+ (?:\\begin\{bmatrix\} \\mathbf\{A\}_i.*?\\end\{bmatrix\} |\\mathbf\{S\}_i\\,)\\ddot\{\\mathbf\{q\}\}_i"
)


def accelerations_from_document(model: Model, q, v, tau, w_ext) -> tuple[np.ndarray, np.ndarray]:
    """`vdot` (nv,) and the joint wrenches (n, 6), in the orders of NOTATION."""
    given = (np.asarray(x, float) for x in (q, v, tau))
    return System(State(reading(model), *given, np.reshape(np.asarray(w_ext, float), (-1, 6)))).solved()


def reading(model: Model) -> Reading:
    """The document of a robot, made and read once."""
    return model.once(("document",), lambda: Reading(Printed(latex.content(model.robot))))


class System:
    """The equations of a state, and what is unknown in them."""

    def __init__(self, state: State):
        self.state, self.links, self.document = state, state.links, state.reading.document
        self.theory = [eq for eq in self.document.theory if eq[1] == "="]
        self.places: dict[str, slice] = {}
        self.size = 0
        for link in self.links:
            i, (_, nv, r) = link.number, link.sizes
            self._unknown(f"V{i}", 6)
            self._unknown(f"eta{i}", r)
            self._unknown(f"w{i}", 0 if link.floats else 6)
            self._unknown(f"q{i}", 0 if link.floats else nv)
        for n, axis in enumerate(state.reading.axes):
            axis.prepare()
            self._unknown(f"added{n}", int(axis.elastic))
        self.loops = Loops(self.document, state.scopes, state.reading.axes)
        self._unknown("lambda", len(self.loops.gaps))
        self.efforts = {(a.name, a.number): a.effort() for a in state.reading.axes}
        self.pulls = [self._pulls(link) for link in self.links]

    def _unknown(self, name: str, count: int) -> None:
        self.places[name] = slice(self.size, self.size + count)
        self.size += count

    def _right(self, left: str) -> str:
        found = next((right for x, _, right in self.theory if x == plain(left)), None)
        if found is None:
            raise Undefined(f"the document has no equation for {left}")
        return found

    def solved(self) -> tuple[np.ndarray, np.ndarray]:
        start = self.residual(np.zeros(self.size))
        A = np.array([(self.residual(FAR * x) - start) / FAR for x in np.eye(self.size)]).T
        x = np.zeros(self.size)
        for _ in range(3):
            x = x + self._solution(A, -(start + A @ x))
        part = lambda name: x[self.places[name]]  # noqa: E731
        joints = [part(f"V{k.number}") if k.floats else part(f"q{k.number}") for k in self.links]
        added = [part(f"added{n}") for n in range(len(self.state.reading.axes))]
        etas = [part(f"eta{k.number}") for k in self.links]
        wrenches = [np.zeros(6) if k.floats else part(f"w{k.number}") for k in self.links]
        return np.concatenate([*joints, *added, *etas]), np.array(wrenches)

    def _solution(self, A: np.ndarray, b: np.ndarray) -> np.ndarray:
        """The unknowns; forces of loops whose rows depend on each other are shared as the document says."""
        n = len(self.loops.gaps)
        if not n:
            return balanced(A, b)
        K, B, C = A[:-n, :-n], A[:-n, -n:], A[-n:, :-n]
        answers = np.array([balanced(K, column) for column in B.T]).T
        S, rest = -C @ answers, b[-n:] - C @ balanced(K, b[:-n])
        weights = np.sqrt(np.diag(S) + np.trace(S) / 1000) if self.loops.shared else np.sqrt(np.diag(S))
        forces = np.linalg.lstsq(S / weights / weights[:, None], rest / weights, rcond=1e-9)[0] / weights
        return np.append(balanced(K, b[:-n]) - answers @ forces, forces)

    # --------------------------------------------------------------------------------- residuals

    def residual(self, x: np.ndarray) -> np.ndarray:
        """What is left of all equations with unknowns x."""
        part = lambda name: x[self.places[name]].reshape(-1, 1)  # noqa: E731
        tips = [self._tip(link, part) for link in self.links]
        loads, torques = self.loops.loads(x[self.places["lambda"]])
        out = [self._link_rows(link, part, loads) for link in self.links]
        for link in self.links:
            if not link.floats:
                out += [self._joint_rows(link, part), self._axis_rows(link, part, torques)]
        for n, axis in enumerate(self.state.reading.axes):
            if axis.elastic:
                out.append(self._rotor(n, axis, x))
        axes = dict(
            enumerate(a for k in self.links if not k.floats for a in x[self.places[f"q{k.number}"]][: len(k.axes)])
        )
        out.append(self.loops.rates(dict(enumerate(tips)), axes))
        return np.concatenate([np.ravel(o) for o in out])

    def _with(self, scope: Scope, more: Mapping[str, Value]) -> Callable[[str], Value]:
        own = {plain(name): x for name, x in more.items()}
        return lambda name: own[plain(name)] if plain(name) in own else scope(name)

    def _tip(self, link: Link, part, scope: Scope | None = None) -> np.ndarray:
        """The rate of the twist of the tip section, or of another."""
        scope = scope or self.state.scopes[link.number]
        nu = np.vstack([part(f"V{link.number}"), part(f"eta{link.number}")])
        return value(self._right(r"\dot{\mathbf{V}}_T"), self._with(scope, {r"\dot{\boldsymbol{\nu}}_i": nu}))

    def _link_rows(self, link: Link, part, loads: list[np.ndarray]) -> np.ndarray:
        i, scope, r = link.number, self.state.scopes[link.number], link.sizes[2]
        nu, w = np.vstack([part(f"V{i}"), part(f"eta{i}")]), np.zeros((6, 1)) if link.floats else part(f"w{i}")
        M, h = (updated(scope, name) for name in (r"\mathbf{M}_i", r"\mathbf{h}_i"))
        if not any(x == plain(LINK_ROWS) for x, _, _ in self.theory):
            raise Undefined(LINK_ROWS)
        left = M @ nu + sized(h, (6 + r, 1))
        none = {r"\mathbf{w}_i": np.zeros((6, 1)), r"\boldsymbol{\mathcal{W}}_{ext,i}": np.zeros((6, 1))}
        none |= {r"\mathbf{X}_{i+1}": np.eye(6), r"\mathbf{w}_{i+1}": np.zeros((6, 1))}
        text = self._right(ON_LINK)
        body, _, tensions = text.partition(TENSION)
        own = none | {r"\mathbf{w}_i": w, r"\boldsymbol{\mathcal{W}}_{ext,i}": self.state.w_ext[i][:, None] + loads[i]}
        right = self._sized_rows(body, scope, own, r)
        for child in self.links:
            if child.parent == i:
                at = self.state.scopes[child.number].parent
                more = none | {r"\mathbf{X}_{i+1}": self._X(child), r"\mathbf{w}_{i+1}": part(f"w{child.number}")}
                right = right + self._sized_rows(body, at, more, r)
        for c, pulled in self.pulls[i]:
            known = {"T_c": np.full((1, 1), self.state.tensions[c]), r"\partial\boldsymbol{\ell}_c": pulled}
            nothing = r"\begin{bmatrix} \mathbf{0} \\"
            assert nothing in tensions, tensions
            modal = value("T_c" + tensions.replace(nothing, r"\begin{bmatrix}"), self._with(scope, known))
            right = right - np.vstack([np.zeros((6, 1)), modal])
        return left - right

    def _sized_rows(self, text: str, scope: Scope, more: Mapping[str, Value], r: int) -> np.ndarray:
        """The rows that act on a link; J_B^T w_i has no modal part."""
        first, _, rest = text.partition(" + ")
        moved = value(r"\mathbf{J}_B^{\top}\,\mathbf{w}_i", self._with(scope, more))
        assert first == r"\begin{bmatrix} \mathbf{J}_B^{\top}\,\mathbf{w}_i \\ \mathbf{0} \end{bmatrix}", first
        return np.vstack([moved, np.zeros((r, 1))]) + value(rest, self._with(scope, more))

    def _X(self, link: Link) -> np.ndarray:
        return sized(self.state.scopes[link.number](r"\mathbf{X}_i"), (6, 6))

    def _joint_rows(self, link: Link, part) -> np.ndarray:
        i, scope = link.number, self.state.scopes[link.number]
        known = {r"\dot{\mathbf{V}}_i": part(f"V{i}"), r"\ddot{\mathbf{q}}_i": part(f"q{i}")}
        carried = np.zeros((6, 1)) if link.parent < 0 else self._tip(self.links[link.parent], part, scope.parent)
        known[r"\dot{\mathbf{V}}_{T,i-1}"] = carried
        left, right = JOINT_ROWS, self._right(JOINT_ROWS)
        if not link.sizes[1]:
            right = JOINT_MOTION.sub("", right)
        return difference(left, right, self._with(scope, known))

    def _axis_rows(self, link: Link, part, torques: Mapping) -> np.ndarray:
        i, nv = link.number, link.sizes[1]
        if not nv:
            return np.zeros(0)
        scope, left = self.state.scopes[i], next(x for x in AXIS_ROWS if any(plain(x) == y for y, _, _ in self.theory))
        own = scope.given["parameters"]
        base = {s: [own.get(f"{s}_{{{'m' if s == 'j' else 'q'},{k + 1}}}", 0.0) for k in range(nv)] for s in "jsd"}
        effort = np.zeros(nv)
        for axis in link.axes:
            k = axis.number
            total, inertia, stiffness, damping = self.efforts[axis.name, k]
            effort[k] = total + torques.get(self.state.reading.axes.index(axis), 0.0)
            base["j"][k] += inertia
            base["s"][k] += stiffness
            base["d"][k] += damping
        names = {"j": r"\mathbf{j}_m", "s": r"\mathbf{s}_q", "d": r"\mathbf{d}_q"}
        known = {names[s]: np.reshape(base[s], (-1, 1)) for s in base}
        known |= {r"\boldsymbol{\tau}_{q,i}": effort[:, None], r"\boldsymbol{\tau}_i": effort[:, None]}
        known |= {r"\ddot{\mathbf{q}}_i": part(f"q{i}"), r"\mathbf{w}_i": part(f"w{i}")}
        known[r"\boldsymbol{\tau}_{w,i}"] = part(f"w{i}")[:3]
        diagonals = {
            rf"\mathbf{{{a}}}": value(self._right(rf"\mathbf{{{a}}}"), self._with(scope, known))
            for a in ("J}_{m", "D}_{q", "S}_{q")
        }
        known |= {plain(name): x for name, x in diagonals.items()}
        if link.sizes[0] != nv:  # a ball joint has no springs
            known[r"\mathbf{q}_i"] = np.zeros((nv, 1))
        return difference(left, self._right(left), self._with(scope, known))

    def _rotor(self, n: int, axis, x: np.ndarray) -> np.ndarray:
        own = x[self.places[f"added{n}"]][0]
        if axis.transmission:
            link = next(k for k in self.links if axis in k.axes)
            return np.array([axis.ahead(x[self.places[f"q{link.number}"]][axis.number], own)])
        return np.array([own - axis.rotor()])

    def _pulls(self, link: Link) -> list[tuple[int, np.ndarray]]:
        name, (k, count) = link.name.partition("[")[0], link.segment
        cut = (k / count, (k + 1) / count)
        out = []
        for row in self.document.table("tension"):
            if row[2].strip("`") == name and link.sizes[2]:
                c = int(re.search(r"T_\{?(\d+)", row[0])[1]) - 1
                out.append((c, pull(self.state.scopes[link.number], link.parts, row, cut)))
        return out


def balanced(A: np.ndarray, b: np.ndarray) -> np.ndarray:
    """`A x = b` with rows and columns of one size."""
    columns = np.linalg.norm(A, axis=0)
    rows = np.linalg.norm(A / columns, axis=1)
    return np.linalg.solve(A / columns / rows[:, None], b / rows) / columns


def difference(left: str, right: str, known: Callable[[str], Value]) -> np.ndarray:
    return sized(plus(value(left, known), value(right, known), -1.0), (6, 1))


def updated(scope: Scope, name: str) -> np.ndarray:
    """A symbol of a link with what bodies at its tip add; what the tip carries is another equation."""
    total = value(scope.theory[plain(name)], scope)
    for text in scope.updates.get(plain(name), []):
        if "Lambda" not in text:
            before = total
            total = value(text, lambda n, b=before: b if plain(n) == plain(name) else scope(n))
    return total
