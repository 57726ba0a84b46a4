"""Stops of the judge: the potential of their springs and what their dampers take, from the tables of the robot file."""

from __future__ import annotations

import casadi as ca


class Stops:
    """The stops of all axes. `limits`: the table of each axis, in the order of q."""

    def __init__(self, limits: list[dict]):
        self.found = []
        for axis, table in enumerate(limits):
            for side, name in ((-1, "lower"), (1, "upper")):
                if "stiffness" in table and name in table:
                    self.found.append((axis, side, table[name], table["stiffness"], table.get("damping", 0.0)))

    def potential(self, q):
        """J: of springs that are pressed."""
        return sum((k * ca.fmax(side * (q[axis] - at), 0) ** 2 / 2 for axis, side, at, k, _ in self.found), 0.0)

    def losses(self, q, v):
        """(nv,): the forces besides those of the potential: of the dampers, and the springs' where they are let go."""
        out = type(v).zeros(v.shape[0])
        for axis, side, at, k, d in self.found:
            depth, rate = side * (q[axis] - at), side * v[axis]
            out[axis] += ca.if_else(depth > 0, side * ca.fmax(d * rate, -k * depth), 0)
        return out
