"""What a robot of the matrix must do, by Lagrange's equations of an oracle that shares no code with the product.

The oracle knows chains and trees of links whose joints turn and slide. What it does not know is brought to that: a
segment is a link, a ball joint three turns, a floating base three slides and three turns; couplings and loops are rows
with multipliers, springs and tendons potentials; for what acts on sections see `conformance.outer`. The states and
forces of both are mapped by the kinematics of these.
"""

from __future__ import annotations

from functools import cached_property
from types import SimpleNamespace

import casadi as ca
import numpy as np
import scipy.linalg
from mixed_loops import Loops
from oracle import Oracle, part_error
from oracle_floating import column_rates, columns
from scipy.spatial.transform import Rotation

from conformance.braked import Brake, brakes_of
from conformance.bristles import Bristles
from conformance.limited import DriveLimits
from conformance.outer import Outer
from conformance.tendons import tendon_length
from conformance.twin import ACCELERATION, axes_of, first_piece

CONDITION = 1e8
DEFINITE = 1e-5
"""The least eigenvalue of a mass matrix whose diagonal is scaled to one."""
QUICK = 1e5
"""The largest acceleration of a joint, rad/s^2 or m/s^2: a run of 6 ms moves it by 1.8."""
RUN = 6e-3
"""s: as long as runs of the checks take."""
PARTS = ("base", "joints", "rotors", "modes", "internal")


class Judge:
    """A robot in a state: `given` (q, v, tau, w_ext) as the product takes them, `state` those of the oracle.

    `twin` is the oracle's robot; where its loops are closed, so are their rates. `rows`: its loops, if known already.
    """

    def __init__(self, robot: dict, twin: dict, oracle: Oracle, state: dict, rows: Loops | None = None):
        self.robot, self.twin, self.oracle = robot, twin, oracle
        self.state = {name: np.array(x, float) for name, x in state.items()}
        self.rows = rows or (Loops(oracle, twin) if {"loops", "couplings"} & set(twin) else None)
        if self.rows is not None:
            self.state["v"] = self.rows.moving(self.state["q"], self.state["v"])
        self.bristles = Bristles(robot, axes_of(twin), oracle.drives)
        self.tensions, self.outer = np.zeros(len(self.tendon_lengths)), Outer(robot, twin, oracle)
        self.closed, self.limits = np.zeros(len(self.brakes)), DriveLimits(robot)
        self.pushes = np.zeros((len(self.outer.rows), 6))

    # ------------------------------------------------------------------------------------ regularity, tolerance

    @property
    def regular(self) -> bool:
        """Whether a run can start here: what is solved for is well determined, nothing is quick, and links of second
        order do not bend too far on the way."""
        q, v = self.state["q"], self.state["v"]
        if not self._definite(q) or np.linalg.cond(self.oracle.mass_matrix(q)) >= CONDITION:
            return False
        if self.rows is not None and self.rows.condition(q) >= CONDITION:
            return False
        if np.abs(self.vdot[: self.oracle.n_joint]).max(initial=0.0) >= QUICK:
            return False
        return all(self._definite(q + t * v + t**2 / 2 * self.motion[0]) for t in RUN * np.linspace(0.25, 1.0, 4))

    def _definite(self, q: np.ndarray) -> bool:
        """Whether the mass matrix is positive definite there."""
        M = self.oracle.mass_matrix(q)
        sizes = np.sqrt(np.abs(np.diag(M)))
        scaled = M / np.outer(sizes, sizes)  # not a number where a transmission is out of reach
        return bool(np.isfinite(scaled).all() and np.linalg.eigvalsh(scaled)[0] > DEFINITE)

    @cached_property
    def condition(self) -> float:
        """Of the equations that are solved for the accelerations: the mass matrix, and that with the loops' rows."""
        q = self.state["q"]
        return max(self.oracle.condition(q), 0.0 if self.rows is None else self.rows.condition(q))

    @property
    def tolerance(self) -> float:
        """The larger of 1e-10 and 50 eps cond, of a state that has a solution."""
        assert self.condition < 100 * CONDITION, "the judge's rows depend on each other: draw another robot"
        return max(1e-10, 50 * np.finfo(float).eps * self.condition)

    # ------------------------------------------------------------------------------------ what the oracle lacks

    @cached_property
    def tendon_lengths(self) -> dict[str, ca.SX]:
        """The length of every tendon, m, of the oracle's coordinates; linear in the modes of links of order 1."""
        out: dict[str, ca.SX] = {}
        for link, table, modal in zip(self.oracle.links, self.twin["links"], self.oracle.modal_slices, strict=True):
            for tendon in table.get("tendons", []):
                if tendon.get("actuated", True):
                    length = tendon_length(link, self.twin | table, tendon, self.oracle.q[modal])
                    out[tendon["name"]] = out.get(tendon["name"], 0) + length
        return out

    @cached_property
    def acting(self) -> ca.Function:
        """(q, tensions) -> (nv,): the generalised forces of springs on axes and of tendons, and their energy."""
        q, tension = self.oracle.q, ca.SX.sym("tension", len(self.tendon_lengths))
        energy, places = ca.SX(0), axes_of(self.twin)
        for link in self.twin["links"]:
            owner = link["name"].removesuffix("_0") + "."
            for k, element in enumerate(link["joint"].get("elements", [])):
                if spring := element.get("spring"):
                    at = next(p for name, p in places.items() if name.startswith(owner) and name[-2] == str(k))
                    energy += spring["stiffness"] * (q[at] - spring["rest"]) ** 2 / 2
        force = -ca.gradient(energy, q) if q.numel() else ca.SX.zeros(0)
        lengths = ca.vertcat(ca.SX(0, 1), *self.tendon_lengths.values())
        force -= ca.jtimes(lengths, q, tension, True)
        return ca.Function("acting", [q, tension], [ca.densify(force), energy, lengths, ca.jacobian(lengths, q)])

    @cached_property
    def acted(self) -> tuple[np.ndarray, ...]:
        """What acts on sections in the state, as `Outer.acting` has it."""
        return self._acted(self.outer.winches)

    def _acted(self, winches: np.ndarray) -> tuple[np.ndarray, ...]:
        given = self.state["q"], self.state["v"], self.pushes.T, winches, self.outer.relaxed
        return tuple(x.full() for x in self.outer.acting(*given))

    @property
    def internal(self) -> np.ndarray:
        """The internal states: bristles of friction, lines that relax, then efforts that limits of rates follow."""
        return np.concatenate([self.bristles.z, self.outer.relaxed, self.limits.z])

    def _forces(self, q, tau) -> np.ndarray:
        """Those of drives, springs on axes, tendons, and of what acts on sections."""
        own = self.acting(q, self.tensions)[0].full()[:, 0] + self.acted[0][:, 0]
        return self.oracle._force(tau, q) + own + self.bristles.forces(self.state["v"])

    # ------------------------------------------------------------------------------------ results, of the oracle

    @cached_property
    def motion(self) -> tuple[np.ndarray, np.ndarray]:
        """The oracle's accelerations, and the wrenches (n, 6) of loops on the tips."""
        q, v, tau, w_ext = (self.state[name] for name in ("q", "v", "tau", "w_ext"))
        oracle = SimpleNamespace(
            nv=self.oracle.nv,
            mass_matrix=self.oracle.mass_matrix,
            inverse_dynamics=self.oracle.inverse_dynamics,
            _force=lambda tau, q: self._forces(q, tau),
        )
        if self.rows is not None:
            self.rows.oracle = oracle
            return self.rows.forward_dynamics(q, v, tau, w_ext)
        return self.open_motion, np.zeros_like(w_ext)

    @cached_property
    def open_motion(self) -> np.ndarray:
        """(nv,): the oracle's accelerations without the forces of loops and couplings."""
        q, v, tau, w_ext = (self.state[name] for name in ("q", "v", "tau", "w_ext"))
        vdot, factors = np.zeros(self.oracle.nv), scipy.linalg.lu_factor(self.oracle.mass_matrix(q))
        for _ in range(3):
            left = self._forces(q, tau) - self.oracle.inverse_dynamics(q, v, vdot, w_ext)
            vdot = vdot + scipy.linalg.lu_solve(factors, left)
        return vdot

    @cached_property
    def taken(self) -> np.ndarray:
        """(nv,): the accelerations of the open tree that the forces of loops and couplings take away."""
        return np.zeros(self.oracle.nv) if self.rows is None else self.map @ (self.open_motion - self.motion[0])

    # ------------------------------------------------------------------------------------ mapped to the product's

    @cached_property
    def _kinds(self) -> list[tuple[str, slice, int]]:
        """By joint of the oracle's robot: free, ball or plain; its coordinates there; its link."""
        out = []
        balls = {link["name"] for link in self.robot["links"] if link["joint"]["axes"] == "ball"}
        first = {first_piece(link) for link in self.robot["links"] if link.get("segments", 1) > 1}
        for i, (own, link) in enumerate(zip(self.oracle.joint_slices, self.twin["links"], strict=True)):
            name = link["name"].removesuffix("_0") if link["name"] in first else link["name"]
            ball = name in balls and len(link["joint"]["axes"]) == 3
            free = i == 0 and "base" in self.robot
            out.append(("free" if free else "ball" if ball else "plain", own, i))
        return out

    @cached_property
    def map(self) -> np.ndarray:
        """(nv, nv): the oracle's rates to those of the product."""
        q, unit = self.state["q"], np.eye(self.oracle.nv)
        out = unit.copy()
        for kind, own, i in self._kinds:
            if kind == "ball":
                out[own, own] = columns(q[own])
            if kind == "free":
                for k in range(6):
                    out[own, k] = self.oracle.link_twists(q, unit[k])[i]
        return out

    @cached_property
    def prescribed(self) -> dict[int, int]:
        """The axes whose motion is given, by their numbers; their places among rates, of elastic drives the rotor's."""
        out, axis, rotor = {}, 0, self.oracle.n_joint
        for link in self.robot["links"]:
            joint = link["joint"]
            count = 3 if joint["axes"] == "ball" else len(joint["axes"])
            said = joint.get("actuation", [])
            for k in range(count):
                elastic = "stiffness" in (joint.get("drives") or [{}] * count)[k]
                if (said if isinstance(said, str) else said[k : k + 1]) in ("motion", ["motion"]):
                    out[axis + k] = rotor if elastic else 6 * ("base" in self.robot) + axis + k
                rotor += elastic
            axis += count
        return out

    @cached_property
    def brakes(self) -> list[Brake]:
        """Those of all axes, in order."""
        return brakes_of(self.robot, self.oracle.n_joint)

    @cached_property
    def reactions(self) -> np.ndarray:
        """(n_brakes,): what the brakes exert."""
        v = self.state["v"]
        pairs = zip(self.brakes, self.closed, strict=True)
        return np.array([one.effort(b, self.vdot[one.place], v[one.place]) for one, b in pairs])

    @cached_property
    def efforts(self) -> np.ndarray:
        """(n_tau,): what the drives exert, also those whose motion is given."""
        out, tau = self.given[2].copy(), self.state["tau"]
        for axis in self.prescribed:
            out[axis] = tau[6 * ("base" in self.robot) + axis]
        out[self._first_brake :][: len(self.brakes)] = self.reactions
        if self.led:
            borne = np.linalg.solve(self.map[:6, :6].T, tau[:6])
            out[self._first_brake + len(self.brakes) :][:6] = borne
        return out

    @property
    def led(self) -> bool:
        """Whether the motion of the base is given; in the oracle efforts of its six axes move it."""
        return self.robot.get("base") == "moving"

    @property
    def _first_brake(self) -> int:
        return self.oracle.n_joint - 6 * ("base" in self.robot) + len(self.tensions)

    @cached_property
    def given(self) -> tuple[np.ndarray, ...]:
        """q, v, tau, w_ext of the product."""
        q, v, tau, w_ext = (self.state[name] for name in ("q", "v", "tau", "w_ext"))
        Q, tau_out = [], []
        force = np.zeros(self.oracle.nv)
        force[: len(tau)] = tau
        for kind, own, i in self._kinds:
            if kind == "ball":
                Q.append(Rotation.from_euler("ZYX", q[own]).as_quat(scalar_first=True))
                tau_out.append(np.linalg.solve(columns(q[own]).T, tau[own]))
            elif kind == "free":
                poses = self.oracle.poses(q)
                Q += [poses["origin"][i], Rotation.from_matrix(poses["R"][i]).as_quat(scalar_first=True)]
            else:
                Q.append(q[own])
                tau_out.append(tau[own])
        q_out, torques = np.concatenate([*Q, q[self.oracle.n_joint :]]), np.concatenate([*tau_out, []])
        for axis, place in self.prescribed.items():
            torques[axis] = self.vdot[place]
        for one, reaction in zip(self.brakes, self.reactions, strict=True):  # what they exert drives do in the oracle
            unit = np.eye(len(tau))[one.axis + 6 * ("base" in self.robot)]
            lever = (self.oracle._force(tau + unit, q) - self.oracle._force(tau, q))[one.place]
            torques[one.axis] -= reaction / lever
        rates = np.append(self.map @ v, self.internal)
        base = ACCELERATION if "base_acceleration" in self.robot else self.vdot[: 6 * self.led]
        inputs = np.concatenate([torques, self.tensions, self.closed, base, self.outer.winches.ravel()])
        return q_out, rates, inputs, self.outer.laid(w_ext, self.pushes)

    @cached_property
    def vdot(self) -> np.ndarray:
        """(nvz,): the rates of v."""
        q, v, a = self.state["q"], self.state["v"], self.motion[0]
        out = self.map @ a
        for kind, own, i in self._kinds:
            if kind == "ball":
                out[own] += column_rates(self.map[own, own], v[own])
            if kind == "free":
                out[own] = self.oracle.link_twist_rates(q, v, a)[i]
        torques = self.state["tau"][6 * ("base" in self.robot) :]
        return np.concatenate([out, self.bristles.rates(v), self.acted[4][:, 0], self.limits.rates(torques)])

    @cached_property
    def at_rest(self) -> Oracle:
        """The oracle of a base that inputs do not accelerate."""
        own = self.twin | {"gravity": self.robot["gravity"]}
        return Oracle(own) if own != self.twin else self.oracle

    @cached_property
    def forces(self) -> np.ndarray:
        """(nv,): the generalised forces of the motion in the open tree without inputs, those of springs among them."""
        q, v, w_ext = (self.state[name] for name in ("q", "v", "w_ext"))
        own = self.acting(q, np.zeros(len(self.tensions)))[0].full()[:, 0]
        own = own + self._acted(0 * self.outer.winches)[0][:, 0]
        own = own + self.bristles.forces(v)
        found = self.at_rest.inverse_dynamics(q, v, self.motion[0], w_ext) - own
        return np.linalg.solve(self.map.T, found)

    @cached_property
    def wrench(self) -> np.ndarray:
        """(n, 6): the joint wrenches, and those of the welds of rows that are no link's."""
        vdot, loads = self.motion
        q, v, w_ext = (self.state[name] for name in ("q", "v", "w_ext"))
        out = self.oracle.wrenches(q, v, vdot, w_ext + loads + self.acted[2].T)
        for kind, _, i in self._kinds:
            if kind == "free" and not self.led:
                out[i] = 0.0
        return self.outer.laid(out, self.acted[3].T)

    @property
    def loop_wrenches(self) -> np.ndarray:
        """(n, 6): those of loops on the product's rows."""
        return self.outer.laid(self.motion[1], 0 * self.pushes)

    @cached_property
    def energy(self) -> tuple[float, float]:
        """Kinetic and potential, J, up to the constant of gravity."""
        kinetic, potential = self.at_rest.energy(self.state["q"], self.state["v"])
        acting = float(self.acting(self.state["q"], self.tensions)[1]) + self.acted[1].item()
        return kinetic, potential + acting + self.bristles.energy

    @cached_property
    def mass_matrix(self) -> np.ndarray:
        """(nv, nv), of the product's rates, of the open tree."""
        back = np.linalg.inv(self.map)
        return back.T @ self.oracle.mass_matrix(self.state["q"]) @ back

    def errors(self, vdot, wrench=None) -> dict[str, float]:
        """Errors of base, joints, rotors, modes, moments and forces, each over the largest entry of its kind.

        In a robot that its loops lock nothing but rounding is left of the accelerations that these take away: there
        the largest of those counts.
        """
        n, free = self.oracle.n_joint, 6 * ("base" in self.robot)
        ends = np.cumsum([free, n - free, self.oracle.n_rotor, self.oracle.nv - n - self.oracle.n_rotor])
        cut = lambda x: dict(zip(PARTS, np.split(np.ravel(x), ends), strict=True))  # noqa: E731
        assert np.size(vdot) == np.size(self.vdot), "accelerations and rates of internal states"
        expected, found = cut(self.vdot), cut(vdot)
        taken = cut(np.append(self.taken, 0 * self.internal))
        out = {k: part_error(expected[k], found[k], self.vdot, taken[k]) for k in PARTS if len(expected[k])}
        if wrench is not None:
            W, given = self.wrench, np.reshape(wrench, (-1, 6))
            out |= {k: part_error(W[:, s], given[:, s], W) for k, s in (("tau", np.s_[:3]), ("F", np.s_[3:]))}
        return out
