"""The functions of the DAE form: its state, its rates, its projection, and the assembled system.

State ``x = [pose_1; ...; pose_n; theta; eta; V_1; ...; V_n; thetadot; etadot; q; z]`` with poses
``(w, x, y, z, px, py, pz)``, (109), the angles of the rotors of elastic drives, and internal states z; unknowns
``z = [w_1; Vdot_1; ...; w_n; Vdot_n; etaddot]``, (67) and (100).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..errors import UsageError
from ..ir.program import Value
from ..spec.base import TWIST
from ..spec.parameters import coordinate_names
from ..topology.chain import Chain
from .functions import ASSEMBLY, DAE_FORWARD, DAE_RATES, PLACEMENT, PROJECTION, ROTORS, Functions
from .joint_moves import coordinate_rates
from .schedule import Algorithm
from .station_names import edge_name

POSE = ("qw", "qx", "qy", "qz", "px", "py", "pz")

RATES = {
    "quaternion": "quaternion_rate",
    "position": "position_rate",
    "theta": "thetadot",
    "eta": "etadot",
    "twist": "Vdot",
    "thetadot": "thetaddot",
    "etadot": "etaddot",
    "q": "qrate",
    "z": "zdot",
}
"""The name of the signal with the rate of each part of the state."""

PLACED = {"quaternion": "new_quaternion", "position": "new_position", "twist": "new_twist"}
"""The name of the signal with each part of the state after forward kinematics."""

Entries = dict[tuple[int, int], Value]


def state_size(chain: Chain) -> int:
    """The length of x."""
    return 13 * chain.n + 2 * chain.n_inner + chain.n_redundant + chain.n_internal


def unknown_size(chain: Chain) -> int:
    """The length of z, which is the number of rows of M_sys."""
    return 12 * chain.n + chain.n_modes


def dae_names(chain: Chain) -> dict[str, list[str]]:
    """The names of the entries of ``x`` and ``z``."""
    links, names = chain.names, coordinate_names(chain.robot)
    inner = list(names.q[chain.eta_q - chain.n_added :])
    rates, internal = list(names.v[chain.eta_v - chain.n_added : chain.nv]), list(names.v[chain.nv :])
    poses = [f"{link}.{p}" for link in links for p in POSE]
    twists = [f"{link}.{t}" for link in links for t in TWIST]
    unknowns = link_unknowns(chain, TWIST)
    x = poses + inner + twists + rates + list(names.q[chain.base_q : chain.q_offset[-1]]) + internal
    modal = rates[chain.n_added :]
    return {"x": x, "z": unknowns + [name.replace("eta_rate", "eta_acceleration") for name in modal]}


def link_unknowns(chain: Chain, twist: Sequence[str]) -> list[str]:
    """The names of the unknowns of all links: the joint's wrench and the rates of ``twist``, link by link."""
    wrench, out = coordinate_names(chain.robot).wrench, []
    for i, link in enumerate(chain.names):
        out += [*wrench[6 * i : 6 * i + 6], *(f"{link}.{t}_rate" for t in twist)]
    return out


class DaeFunctions(Functions):
    """The functions of the DAE form, on values of any algebra."""

    def unpack(self, x: Sequence[Value]) -> list[dict[str, list]]:
        """The state, split into one mapping per link."""
        c, o, t = self.chain, self.chain.eta_offset, self.chain.theta_offset
        at_theta, at_twist = 7 * c.n, 7 * c.n + c.n_inner
        at_rate, at_q = at_twist + 6 * c.n, at_twist + 6 * c.n + c.n_inner
        at_eta, at_etadot = at_theta + c.n_added, at_rate + c.n_added
        redundant, at_z = [max(k - c.base_q, 0) for k in c.q_offset], at_q + c.n_redundant
        return [
            {
                "quaternion": list(x[7 * i : 7 * i + 4]),
                "position": list(x[7 * i + 4 : 7 * i + 7]),
                "eta": list(x[at_eta + o[i] : at_eta + o[i + 1]]),
                "twist": list(x[at_twist + 6 * i : at_twist + 6 * i + 6]),
                "etadot": list(x[at_etadot + o[i] : at_etadot + o[i + 1]]),
                "theta": list(x[at_theta + t[i] : at_theta + t[i + 1]]),
                "thetadot": list(x[at_rate + t[i] : at_rate + t[i + 1]]),
                "q": list(x[at_q + redundant[i] : at_q + redundant[i + 1]]),
                "z": list(x[at_z + c.z_offset[i] : at_z + c.z_offset[i + 1]]),
            }
            for i in range(c.n)
        ]

    def pack(self, links: Sequence[Mapping[str, list]], names: Mapping[str, str] | None = None) -> list:
        """The inverse of :meth:`unpack`; ``names`` says under which name a part is found."""
        named = lambda part: (names or {}).get(part, part)  # noqa: E731
        optional = ("theta", "thetadot", "z")
        get = lambda link, part: link.get(named(part), ()) if part in optional else link[named(part)]  # noqa: E731
        gather = lambda *parts: [v for link in links for part in parts for v in get(link, part)]  # noqa: E731
        inner, rates = gather("theta") + gather("eta"), gather("thetadot") + gather("etadot")
        jointed = (link for link, key in zip(links, self.chain.keys, strict=True) if not key.floats)
        redundant = [v for link in jointed for v in get(link, "q")]
        return [*gather("quaternion", "position"), *inner, *gather("twist"), *rates, *redundant, *gather("z")]

    def _moving(self, state: Sequence[Mapping], kinematics: Algorithm) -> list[dict[str, list]]:
        """The state with inertias and forces of modes and sprung joints; joint rates are taken from the twists."""
        if self.chain.has_axis_forces and self.given is None:
            found, _ = self._run(kinematics, state)
            state = [dict(x) | {"qdot": link["qdot"]} for x, link in zip(state, found, strict=True)]
        return self._with_terms(state)

    def _gravity(self) -> list[dict[str, list]]:
        return [{"gravity": list(self.gravity)}] * self.chain.n

    def place(self, q: Sequence, v: Sequence) -> list:
        """A state that satisfies the joint constraints: x from coordinates and rates."""
        links, _ = self._run(PLACEMENT, self._stated(self._state(q, v)))
        return self.pack(links, PLACED) + self.remembered(v)

    def _stated(self, links: Sequence[dict[str, list]]) -> Sequence[dict[str, list]]:
        """Joint coordinates and rates as this form states them: of a floating base as pose and twist."""
        if self.chain.floating:
            base = links[0]
            base |= {"position": base["q"][:3], "quaternion": base["q"][3:], "twist": base["qdot"]}
        return links

    def _of_joints(self, links: Sequence[dict[str, list]]) -> Sequence[dict[str, list]]:
        """The inverse."""
        if self.chain.floating:
            base = links[0]
            base |= {"q": [*base["position"], *base["quaternion"]], "qdot": base["twist"]}
        return links

    def _solve(self, x: Sequence, tau: Sequence, w_ext: Sequence) -> list[dict[str, list]]:
        tau, w_ext = self._borne(x, tau, w_ext)
        state = self._moving(self.unpack(x), DAE_FORWARD[:1])
        falling = self.falling(tau)
        return falling._run(DAE_FORWARD, state, self.of_links(tau), self._wrenches(w_ext), falling._gravity())[0]

    def _borne(self, x: Sequence, tau: Sequence, w_ext: Sequence) -> tuple[Sequence, Sequence]:
        """Torques and wrenches on the tips, those of the loops and of forces between frames included."""
        acted = self.chain.closing.rows or self.acts
        return self.with_loops(*self.coordinates(x), tau, w_ext) if acted else (tau, w_ext)

    def joint_rates(self, x: Sequence) -> list:
        """The joint rates that follow from the twists."""
        links, _ = self._run(DAE_FORWARD[:1], self.unpack(x))
        return [rate for link in links for rate in link["qdot"]]

    def rates(self, x: Sequence, tau: Sequence, w_ext: Sequence) -> tuple[list, list, list]:
        """``xdot``, ``vdot`` of the joint form, and the joint wrenches, by block elimination.

        Where forces are given the rates of internal states are zero in ``xdot`` and left out of ``vdot``: the
        integrator that gives them finds these.
        """
        links = self._solve(x, tau, w_ext)
        wrench = [w for link in links for w in link["wrench"]]
        xdot, vdot = self.under_inputs(tau)._state_rates(x, links), self.chain.join(links, "qddot", "etaddot")
        return xdot, vdot + (xdot[len(xdot) - self.chain.n_internal :] if self.given is None else []), wrench

    def _state_rates(self, x: Sequence, links: Sequence[Mapping[str, list]]) -> list:
        state = self.unpack(x)
        poses, _ = self._run(DAE_RATES, state)
        found = zip(self._redundant_rates(state, links), poses, self._internal_rates(state, links), strict=True)
        packed = self.pack([a | b | c for a, b, c in found], RATES)
        if self.given is not None or not self.chain.n_force_states:
            return packed + [0.0] * self.chain.n_force_states
        return packed + self.force_rates(*self.coordinates(x), self._of_forces(x), 0.0)

    def _of_forces(self, x: Sequence) -> list:
        """The internal states of forces between frames, the last entries of x."""
        return list(x[len(x) - self.chain.n_force_states :])

    def _internal_rates(self, state: Sequence[Mapping[str, list]], links: Sequence[Mapping[str, list]]) -> list[dict]:
        """The rates of the internal states, at the joint rates that the links have."""
        if self.given is not None:
            return [{"zdot": [0.0] * len(key.internal)} for key in self.chain.keys]
        return self.link_internal_rates([dict(a) | {"qdot": b["qdot"]} for a, b in zip(state, links, strict=True)])

    def _redundant_rates(self, state: Sequence[Mapping[str, list]], links: Sequence[Mapping[str, list]]) -> list[dict]:
        """The links with the rates of joint coordinates, which those of joints are but for quaternions."""
        out = [dict(link) | {"qrate": link["qdot"]} for link in links]
        for i, joint in ((part.link, part.joint) for part in self.chain.curved if not part.joint.in_space):
            given = {"q": state[i]["q"], "v": links[i]["qdot"]}
            out[i]["qrate"] = self.apply(i, 0, coordinate_rates(joint), given)["rates"]
        return out

    def kinematic_rates(self, x: Sequence, z: Sequence, tau: Sequence = ()) -> list:
        """``xdot`` when the accelerations are given: the differential equations of the DAE.

        ``tau`` acts on the rotors of elastic drives, whose accelerations are no unknowns, and on internal states.
        Raises UsageError where transmissions have elastic gears, whose accelerations need those of the joints.
        """
        if self.chain.elastic_travels:
            what = "has an elastic gear behind a transmission, for which the DAE has no differential equations"
            raise UsageError(f"robot '{self.chain.robot.name}' {what}; use dae_dynamics, or the joint form")
        links, _ = self._run(DAE_FORWARD[:1], self.unpack(x))
        if self.chain.n_added:
            moving = self._with_terms([a | {"qdot": b["qdot"]} for a, b in zip(self.unpack(x), links, strict=True)])
            added, _ = self._run(ROTORS, moving, self.of_links(tau))
            links = [a | {k: v for k, v in b.items() if k == "thetaddot"} for a, b in zip(links, added, strict=True)]
        n, o = self.chain.n, self.chain.eta_offset
        given = [
            {"Vdot": list(z[12 * i + 6 : 12 * i + 12]), "etaddot": list(z[12 * n + o[i] : 12 * n + o[i + 1]])}
            for i in range(n)
        ]
        return self.under_inputs(tau)._state_rates(x, [a | b for a, b in zip(links, given, strict=True)])

    def project(self, x: Sequence) -> list:
        """The state projected onto the joint constraints."""
        links, _ = self._run(PROJECTION, self.unpack(x))
        projected = self.pack(links, PLACED | {"q": "new_q"}) + self._of_forces(x)
        return self.place(*self.close(*self.coordinates(projected))) if self.chain.closing.rows else projected

    def coordinates(self, x: Sequence) -> tuple[list, list]:
        """``q`` and ``v`` of a state."""
        links, _ = self._run(DAE_FORWARD[:1], state := self.unpack(x))
        join, found = self.chain.join, self._of_joints([a | b for a, b in zip(state, links, strict=True)])
        return join(found, "q", "eta"), join(found, "qdot", "etadot") + self._of_forces(x)

    def assemble(self, x: Sequence, tau: Sequence, w_ext: Sequence) -> tuple[Entries, list, list]:
        """``M_sys`` by entries, ``H_sys`` and ``W_sys``: rows and columns in the order of z.

        The wrenches of loops on the tips are part of ``W_sys``.
        """
        tau, w_ext = self._borne(x, tau, w_ext)
        state = self._with_terms(self.unpack(x), "eta")
        falling = self.falling(tau)
        links, _ = falling._run(ASSEMBLY, state, self.of_links(tau), self._wrenches(w_ext), falling._gravity())
        return self._stacked(links)

    def _stacked(self, links: Sequence[Mapping[str, Any]]) -> tuple[Entries, list, list]:
        """The blocks of all links, each at its rows and columns."""
        M: Entries = {}
        for i, link in enumerate(links):
            own = block_places(self.chain, i), link
            for blocks, values in (own, (edge_places(self.chain, i), link["edge"])) if "edge" in link else (own,):
                for name, (row, col, _, cols) in blocks.items():
                    for k, value in enumerate(values[name]):
                        if not (isinstance(value, float) and value == 0.0):
                            M[row + k // cols, col + k % cols] = value
        twelve = lambda end: [v for link in links for v in (*link[f"joint_{end}"], *link[f"V_{end}"])]  # noqa: E731
        modal = lambda end: [v for link in links for v in link[f"eta_{end}"]]  # noqa: E731
        return M, twelve("H") + modal("H"), twelve("W") + modal("W")


def block_places(chain: Chain, i: int) -> dict[str, tuple[int, int, int, int]]:
    """Row, column, and size of every block of M_sys that link i contributes."""
    r = chain.keys[i].modes
    modal = 12 * chain.n + chain.eta_offset[i]
    joint, link = 12 * i, 12 * i + 6
    places = {
        "joint_w": (joint, joint, 6, 6),
        "joint_V": (joint, link, 6, 6),
        "V_w": (link, joint, 6, 6),
        "V_V": (link, link, 6, 6),
        "V_eta": (link, modal, 6, r),
        "eta_V": (modal, link, r, 6),
        "eta_eta": (modal, modal, r, r),
    }
    own = {name: place for name, place in places.items() if place[3]}
    for where, node in chain.tree.places(i).items():
        if where != "base" and (carried := chain.tree.children[node]):
            own |= edge_places(chain, carried[-1])
    return own


def edge_places(chain: Chain, child: int) -> dict[str, tuple[int, int, int, int]]:
    """Row, column, and size of the blocks of M_sys that couple a link with the one that carries it."""
    i = chain.tree.parents[child]
    r, modal = chain.keys[i].modes, 12 * chain.n + chain.eta_offset[i]
    joint, link = 12 * child, 12 * i + 6
    places = {
        "next_V": (joint, link, 6, 6),
        "next_eta": (joint, modal, 6, r),
        "V_next": (link, joint, 6, 6),
        "eta_next": (modal, joint, r, 6),
    }
    station = chain.tree.at(child)
    return {edge_name(name, station): place for name, place in places.items() if place[2] * place[3]}
