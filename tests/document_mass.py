"""A robot's mass matrix by the formulas that its document prints, block by block, and by nothing else."""

from __future__ import annotations

import re

import numpy as np
from document_axes import LETTERS
from document_reader import Env, reading
from document_state import Link, State
from document_symbols import plain, sized
from latex_formula import Value, plus, value

SUM = r" + \sum\limits_k "


def of_j(name: str) -> str:
    """A symbol of link k as that of link j."""
    return re.sub(r"([_,])k(\}?)$", r"\1j\2", name)


def mass_matrix_from_document(model, q) -> np.ndarray:
    """(nv, nv)."""
    rest = np.zeros(model.chain.nvz), np.zeros(model.n_tau), np.zeros((model.n_links, 6))
    return Blocks(State(reading(model), np.asarray(q, float), *rest)).whole()


class Blocks:
    """The formulas of the section "Mass matrix" in a posture."""

    def __init__(self, state: State):
        self.state, self.links = state, state.links
        self.lines = {
            left: right for p in state.reading.document.sections["Mass matrix"] for left, _, right in p.equations
        }
        for axis in state.reading.axes:
            axis.prepare()
        self.envs: list[Env] = [{} for _ in self.links]
        placed = plain(r"\bar{\mathbf{S}}_k") in self.lines or r"\bar" in self.lines[plain(r"\mathbf{M}_{q_jq_j}")]
        self.subspace = r"\bar{\mathbf{S}}_j" if placed else r"\mathbf{S}_j"
        for link in self.links:
            self._transport(link)
        for link in reversed(self.links) if plain(r"\mathbf{M}^c_j") in self.lines else ():
            sizes = {r"\mathbf{M}^c_j": 6, r"\mathbf{U}_{q,j}": link.sizes[1], r"\mathbf{U}_{\eta,j}": link.sizes[2]}
            for name, size in sizes.items():
                found = self._summed(link, self.lines[plain(name)])
                self.envs[link.number][plain(name)] = sized(found, (6, size))

    def _known(self, link: Link):
        """The symbols of link j or k: what lines have defined, then those of its class."""
        scope, env = self.state.scopes[link.number], self.envs[link.number]

        def known(name: str):
            name = of_j(plain(name))
            if name in env:
                return env[name]
            own = plain(re.sub(r",[jk]\}", ",i}", re.sub(r"_j$", "_i", name)))
            return scope(plain(own.replace("_{B,i}", "_B")))

        return known

    def _transport(self, link: Link) -> None:
        if link.floats:
            self.envs[link.number] |= {plain(self.subspace): np.eye(6)}
            return
        known, section = self._known(link), self.state.scopes[link.number].parent
        modes = 0 if link.parent < 0 else self.links[link.parent].sizes[2]
        of_section = {plain(r"\mathbf{J}_{TV}"): (6, 6), plain(r"\mathbf{J}_{T\eta}"): (6, modes)}
        for letter in ("Y", "Z", r"\bar"):
            left = plain({"Y": r"\mathbf{Y}_k", "Z": r"\mathbf{Y}_{\eta,k}"}.get(letter, r"\bar{\mathbf{S}}_k"))
            if left in self.lines and (link.parent >= 0 or letter == r"\bar"):
                at = lambda n: sized(section(n), of_section[plain(n)]) if plain(n) in of_section else known(n)  # noqa: E731
                self.envs[link.number][of_j(left)] = value(self.lines[left], at)

    def _summed(self, link: Link, right: str) -> Value:
        first, _, each = right.partition(SUM)
        total = value(first, self._known(link))
        for child in self.links if each else ():
            if child.parent == link.number:
                total = plus(total, value(each, self._known(child)))
        return total

    def _own(self, link: Link) -> dict[tuple[str, str], np.ndarray]:
        names = {("q", "q"): r"\mathbf{M}_{q_jq_j}", ("q", "e"): r"\mathbf{M}_{q_j\eta_j}"}
        names[("e", "e")] = r"\mathbf{M}_{\eta_j\eta_j}"
        self.envs[link.number][r"\mathbf{J}_m"] = self._armature(link)
        return {pair: self._summed(link, self.lines[plain(name)]) for pair, name in names.items()}

    def _armature(self, link: Link) -> np.ndarray:
        own, nv = self.state.scopes[link.number].given["parameters"], link.sizes[1]
        out = [own.get(f"j_{{m,{k + 1}}}", 0.0) for k in range(nv)]
        for axis in link.axes if not link.floats else ():
            out[axis.number] += axis.effort()[1]
        return np.diag(out)

    def _carried(self, below: list[Link], link: Link) -> dict[tuple[str, str], np.ndarray]:
        """The blocks of link i, the first carrier in ``below`` = [i, k, …, j], with link j."""
        first, *way = below
        env, at = self.envs[link.number], self.envs[way[0].number]
        product = np.eye(6)
        for other in way[1:]:
            product = self.envs[other.number][plain(r"\mathbf{Y}_j")] @ product
        out = {}
        for x, own in (("q", r"\mathbf{U}_{q,j}"), ("e", r"\mathbf{U}_{\eta,j}")):
            given = {plain(r"\mathbf{Y}_{jk}"): product, plain(r"\mathbf{U}_{x,j}"): env[plain(own)]}
            given |= {n: at[of_j(n)] for n in (r"\mathbf{Y}_k", r"\mathbf{Y}_{\eta,k}")}
            given[plain(self.subspace.replace("_j", "_i"))] = self._known(first)(self.subspace)
            for y, name in (("q", r"\mathbf{M}_{q_ix_j}"), ("e", r"\mathbf{M}_{\eta_ix_j}")):
                out[y, x] = value(self.lines[plain(name)], lambda n, g=given: g[plain(n)])
        return out

    def whole(self) -> np.ndarray:
        sizes = [link.sizes for link in self.links]
        added = [axis for axis in self.state.reading.axes if axis.elastic]
        joints = np.cumsum([0, *(s[1] for s in sizes)])
        modes = joints[-1] + len(added) + np.cumsum([0, *(s[2] for s in sizes)])
        M = np.zeros((modes[-1], modes[-1]))
        place = lambda x, i: slice((joints, modes)[x == "e"][i], (joints, modes)[x == "e"][i + 1])  # noqa: E731
        for link in self.links:
            j = link.number
            for (y, x), block in self._own(link).items():
                M[place(y, j), place(x, j)] = block
                M[place(x, j), place(y, j)] = block.T
            below = [link]
            while below[0].parent >= 0:
                below.insert(0, self.links[below[0].parent])
                i = below[0].number
                for (y, x), block in self._carried(below, link).items():
                    M[place(y, i), place(x, j)] = block
                    M[place(x, j), place(y, i)] = block.T
        for k, axis in enumerate(added, joints[-1]):
            self._rotor(M, k, axis, joints)
        return M

    def _rotor(self, M: np.ndarray, k: int, axis, joints: np.ndarray) -> None:
        """What a rotor behind an elastic gear adds."""
        M[k, k] = axis.numbers["J_r"]
        if axis.transmission:
            link = next(x for x in self.links if axis in x.axes)
            j, inertia = joints[link.number] + axis.number, axis.numbers["J_r"] * axis.read("N", {}) ** 2
            slope = axis.known[LETTERS[axis.transmission][0] + "'"]
            M[k, k], M[j, k], M[k, j] = inertia, inertia * slope, inertia * slope
            M[j, j] += inertia * slope**2
