"""Pinocchio's reading of a URDF beside ours: mass matrix and inverse dynamics in random states, joints by name."""

import numpy as np
import pinocchio as pin

from screwgen.interchange.load import import_urdf
from screwgen.interchange.tree import Options
from screwgen.model import derive


def physical(body: pin.Inertia) -> pin.Inertia:
    """The nearest inertia that a body has: the second moments of its mass about its centre, without negative ones."""
    J = body.inertia
    w, U = np.linalg.eigh(0.5 * np.trace(J) * np.eye(3) - J)
    if w[0] >= 0:
        return body
    second = U @ np.diag(np.clip(w, 0.0, None)) @ U.T
    return pin.Inertia(body.mass, body.lever, np.trace(second) * np.eye(3) - second)


class Pair:
    """One URDF in both tools."""

    def __init__(self, path, flexible=None, **options):
        self.found = import_urdf(path, flexible, Options(**options))
        self.model = derive(self.found.robot)
        self.floating = self.found.robot.floating
        free = (pin.JointModelFreeFlyer(),) if self.floating else ()
        self.pin = pin.buildModelFromUrdf(str(path), *free)
        self.pin.gravity.linear = np.array(self.found.robot.gravity)
        if options.get("nearest_inertia"):
            for i in range(1, self.pin.njoints):
                self.pin.inertias[i] = physical(self.pin.inertias[i])
        self.data = self.pin.createData()
        self.rows, self.columns = self._names()

    def _names(self) -> tuple[list[int], list[int]]:
        """Where our rates are, and Pinocchio's, in the same order."""
        ours, theirs = ([3, 4, 5, 0, 1, 2], list(range(6))) if self.floating else ([], [])
        rates = [name.replace("_rate", "") for name in self.model.v_names]
        for joint, names in self.found.joints.items():
            first = self.pin.joints[self.pin.getJointId(joint)].idx_v
            ours += [rates.index(name) for name in names]
            theirs += range(first, first + len(names))
        return ours, theirs

    def state(self, rng) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """q, v and vdot of both; modes are at rest."""
        q, theirs = np.zeros(self.model.nq), pin.neutral(self.pin)
        v, a = np.zeros((2, self.model.nv))
        v[self.rows], a[self.rows] = rng.normal(size=(2, len(self.rows)))
        if self.floating:
            turn = rng.normal(size=4)
            q[:3], q[3:7] = rng.normal(size=3), turn / np.linalg.norm(turn)
            theirs[:7] = [*q[:3], *q[4:7], q[3]]
        for joint, names in self.found.joints.items():
            model = self.pin.joints[self.pin.getJointId(joint)]
            for k, name in enumerate(names):
                at = self.model.q_names.index(name)
                q[at] = rng.uniform(-2, 2)
                if model.nq == 2 and model.nv == 1:
                    theirs[model.idx_q : model.idx_q + 2] = np.cos(q[at]), np.sin(q[at])
                else:
                    theirs[model.idx_q + k] = q[at]
        rates = np.zeros((2, self.pin.nv))
        rates[0, self.columns], rates[1, self.columns] = v[self.rows], a[self.rows]
        return q, v, a, theirs, *rates

    def misfit(self, seed: int = 0, states: int = 2) -> float:
        """The largest error of mass matrix and forces, in units in which each coordinate has the inertia 1."""
        rng, worst, numpy = np.random.default_rng(seed), 0.0, self.model.numpy()
        no_force = np.zeros((self.model.n_links, 6))
        for _ in range(states):
            q, v, a, their_q, their_v, their_a = self.state(rng)
            upper = np.triu(pin.crba(self.pin, self.data, their_q))
            M = (upper + np.triu(upper, 1).T)[np.ix_(self.columns, self.columns)]
            tau = pin.rnea(self.pin, self.data, their_q, their_v, their_a)[self.columns]
            tau += self.resistance(v[self.rows])
            size = np.sqrt(np.diag(M))
            ours = numpy.mass_matrix(q)[np.ix_(self.rows, self.rows)]
            worst = np.maximum(worst, np.max(np.abs(ours - M) / np.outer(size, size)))
            ours = numpy.inverse_dynamics(q, v, a, no_force)[self.rows]
            worst = np.maximum(worst, np.max(np.abs(ours - tau) / size) / np.max(np.abs(tau) / size))
        return worst

    def resistance(self, v: np.ndarray) -> np.ndarray:
        """Damping and dry friction, by the numbers that Pinocchio has read."""
        damping, dry = (np.array(x)[self.columns] for x in (self.pin.damping, self.pin.friction))
        rate = np.array([0.001 if "slide" in self.model.v_names[i] else 0.01 for i in self.rows])
        return damping * v + dry * v / np.sqrt(v * v + rate * rate)
