"""What acts on sections from outside the tree, on the oracle's coordinates: springs along lines, ropes, pushes.

Springs act by the slopes of their energy, dampers by those of the length, pushes by their virtual work. For the balance
of momentum of a link, what acts at one of its sections is equivalent to a wrench at its tip.
"""

from __future__ import annotations

from functools import cached_property
from math import ceil
from typing import NamedTuple

import casadi as ca
import numpy as np
from oracle import Oracle
from oracle_cloud import rates
from oracle_stations import named


class Place(NamedTuple):
    """A section of a link of the oracle's robot."""

    link: int
    s: float


class Row(NamedTuple):
    """A row of the product's wrenches that is no link's: of a section, with the axes in which it is stated."""

    place: Place
    axes: str
    own: bool
    """Whether it is a push's alone, so that forces between frames act beside it."""


class Outer:
    """``rows``: those of the product that are not of links; ``links``: where the others stand among all."""

    def __init__(self, robot: dict, twin: dict, oracle: Oracle):
        self.robot, self.oracle = robot, oracle
        self.names = [link["name"] for link in twin["links"]]
        self.rows: list[Row] = []
        self.links: list[int] = []
        joined = [end for loop in robot.get("loops", []) for end in loop["between"]]
        joined += [end for force in robot.get("forces", []) for end in force["between"] if isinstance(end, str)]
        for link in robot["links"]:
            at = lambda marker, link=link: marker.split(".")[0] == link["name"]  # noqa: E731
            first = len(self.links) + len(self.rows)
            self.links += range(first, first + link.get("segments", 1))
            inner = dict.fromkeys(place for place in map(self.place, filter(at, joined)) if place.s != 1.0)
            self.rows += [Row(place, "marker", False) for place in inner]
            pushes = [push for push in robot.get("pushes", []) if at(push["at"])]
            self.rows += [Row(self.place(push["at"]), push.get("axes", "world"), True) for push in pushes]

    def place(self, marker: str) -> Place:
        """Where a marker of the robot is; the end of a segment, not the beginning of the next."""
        name, own = marker.split(".")
        link = next(x for x in self.robot["links"] if x["name"] == name)
        count, s = link.get("segments", 1), named(link, own)
        piece = max(ceil(s * count - 1e-12) - 1, 0)
        return Place(self.names.index(name) - (count - 1) + piece, s * count - piece)

    def laid(self, of_links, of_rows) -> np.ndarray:
        """(n, 6): the rows of links and the others as the product has them."""
        out = np.zeros((len(self.links) + len(self.rows), 6))
        others = np.setdiff1d(np.arange(len(out)), self.links)
        out[self.links], out[others] = of_links, np.reshape(of_rows, (-1, 6))
        return out

    @cached_property
    def acting(self) -> ca.Function:
        """(q, v, pushes (6, rows)) -> the generalised forces (nv,), the energy of springs, what is equivalent on the
        tips (6, n), in their axes, and what the welds of the rows transmit (6, rows).
        """
        q, v, W = self.oracle.q, self.oracle.v, ca.SX.sym("pushes", 6, len(self.rows))
        force, energy = ca.SX.zeros(self.oracle.nv), ca.SX(0)
        on_tips, on_rows = ca.SX.zeros(6, self.oracle.n), ca.SX.zeros(6, len(self.rows))
        for stated in self.robot.get("forces", []):
            law, ends = stated["line"], [self._end(x) for x in stated["between"]]
            line = ends[1][1] - ends[0][1]
            length = ca.norm_2(line)
            stretch, rate = length - law.get("rest", 0.0), rates([length], q, v)[0]
            pull, damped = law["stiffness"] * stretch + law.get("damping", 0.0) * rate, law.get("damping", 0.0) * rate
            taut = ca.logic_and(stretch > 0, pull > 0) if law.get("slack") else ca.SX(1)
            stored = law["stiffness"] * stretch**2 / 2 * ((stretch > 0) if law.get("slack") else 1)
            force -= taut * (ca.gradient(stored, q) + damped * ca.gradient(length, q))
            energy += stored
            for end, sign in zip(stated["between"], (1, -1), strict=True):
                if isinstance(end, str):
                    load, place = sign * taut * pull * line / length, self.place(end)
                    on_tips += self._on_tip(place, ca.SX.zeros(3), load)
                    on_rows += self._on_row(place, load)
        for k, row in enumerate(self.rows):
            R, r = self._section(row.place)
            spin, speed = self._spin(R), rates([r], q, v)[0]
            axes = R if row.axes == "marker" else ca.SX.eye(3)
            torque, load = axes @ W[:3, k], axes @ W[3:, k]
            force += ca.gradient(ca.dot(torque, spin) + ca.dot(load, speed), v)
            on_tips += self._on_tip(row.place, torque, load)
            on_rows[:, k] += ca.vertcat(R.T @ torque, R.T @ load)
        found = [force, energy, on_tips, -on_rows]
        return ca.Function("outer", [q, v, W], [ca.densify(x) for x in found])

    def _section(self, place: Place) -> tuple[ca.SX, ca.SX]:
        return self.oracle.section(place.link, self.oracle.clouds[place.link], place.s)

    def _end(self, end: str | dict) -> tuple[ca.SX, ca.SX]:
        if isinstance(end, dict):
            return ca.SX.eye(3), ca.SX(end["world"])
        return self._section(self.place(end))

    def _spin(self, R: ca.SX) -> ca.SX:
        """The angular velocity in inertial axes."""
        turn = rates([R], self.oracle.q, self.oracle.v)[0] @ R.T
        return ca.vertcat(turn[2, 1], turn[0, 2], turn[1, 0])

    def _on_tip(self, place: Place, torque: ca.SX, load: ca.SX) -> ca.SX:
        """(6, n): the equivalent on the tip of the link."""
        cloud, out = self.oracle.clouds[place.link], ca.SX.zeros(6, self.oracle.n)
        moment = torque + ca.cross(self._section(place)[1] - cloud.tip_point, load)
        out[:, place.link] = ca.vertcat(cloud.tip_R.T @ moment, cloud.tip_R.T @ load)
        return out

    def _on_row(self, place: Place, load: ca.SX) -> ca.SX:
        """(6, rows): the force of a spring on the row at its end, if one is there."""
        out = ca.SX.zeros(6, len(self.rows))
        for k, row in enumerate(self.rows):
            if row.place == place and not row.own:
                out[3:, k] = self._section(place)[0].T @ load
        return out
