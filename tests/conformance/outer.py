"""What acts on sections from outside the tree, on the oracle's coordinates: springs, ropes, contacts, drag, pushes.

Springs act by the slopes of their energy, dampers by those of what they measure, pushes by their virtual work. For the
balance of momentum of a link, what acts at one of its sections is equivalent to a wrench at its tip.
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

from conformance.touching import Body, Touch, dragged, pressed


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


class Acting(NamedTuple):
    """A force between frames: generalised forces (nv,), energy, and the wrench on the second end in inertial axes."""

    force: ca.SX
    energy: ca.SX
    torque: ca.SX
    load: ca.SX


Frame = tuple[ca.SX, ca.SX]
"""Rotation and place in the inertial frame."""


class Outer:
    """``rows``: those of the product that are not of links; ``links``: where the others stand among all; ``winches``:
    the line that each has paid out, and the rate of that; ``relaxed``: the stretch of springs that relax."""

    def __init__(self, robot: dict, twin: dict, oracle: Oracle):
        self.robot, self.oracle = robot, oracle
        self.relaxed = np.zeros(sum("relaxation" in x.get("line", {}) for x in robot.get("forces", [])))
        self.winches = np.zeros((sum("winch" in x.get("line", {}) for x in robot.get("forces", [])), 2))
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
        """(q, v, pushes (6, rows), winches, relaxed) -> the generalised forces (nv,), the energy of springs, what is
        equivalent on the tips (6, n), in their axes, what the welds of the rows transmit (6, rows), and the rates of
        what is relaxed.
        """
        q, v, W = self.oracle.q, self.oracle.v, ca.SX.sym("pushes", 6, len(self.rows))
        force, energy, wound = ca.SX.zeros(self.oracle.nv), ca.SX(0), ca.SX.sym("wound", *self.winches.shape)
        winches = iter(ca.vertsplit(wound) if wound.numel() else ())
        z, changing = ca.SX.sym("z", len(self.relaxed)), ca.SX(0, 1)
        on_tips, on_rows = ca.SX.zeros(6, self.oracle.n), ca.SX.zeros(6, len(self.rows))
        giving_way = [x for x in self.robot.get("loops", []) if "stiffness" in x["joint"]]
        for stated in [*self.robot.get("forces", []), *giving_way]:
            ends = [self._end(x) for x in stated["between"]]
            drum = ca.horzsplit(next(winches)) if "winch" in stated.get("line", {}) else (0.0, 0.0)
            line = "line" in stated
            if "joint" in stated:
                own = self._joint(stated["joint"], *ends)
            elif "contact" in stated:
                own = self._touching(pressed(stated["contact"], *map(self._body, ends)), *ends)
            elif "drag" in stated:
                own = self._touching(dragged(stated["drag"], *map(self._body, ends)), *ends)
            else:
                own = self._line(stated["line"], *ends, *drum) if line else self._bushing(stated["bushing"], *ends)
            if "relaxation" in stated.get("line", {}):
                own, rate = self._relaxing(stated["line"], own, *ends, z[changing.numel()])
                changing = ca.vertcat(changing, rate)
            force, energy, point = force + own.force, energy + own.energy, ends[1][1]
            for end, sign in zip(stated["between"], (-1, 1), strict=True):
                if isinstance(end, str):
                    on_tips += self._on_tip(self.place(end), sign * own.torque, sign * own.load, point)
                    on_rows += self._on_row(self.place(end), sign * own.torque, sign * own.load, point)
        for k, row in enumerate(self.rows):
            R, r = self._section(row.place)
            spin, speed = self._spin(R), rates([r], q, v)[0]
            axes = R if row.axes == "marker" else ca.SX.eye(3)
            torque, load = axes @ W[:3, k], axes @ W[3:, k]
            force += ca.gradient(ca.dot(torque, spin) + ca.dot(load, speed), v)
            on_tips += self._on_tip(row.place, torque, load, r)
            on_rows[:, k] += ca.vertcat(R.T @ torque, R.T @ load)
        found = [force, energy, on_tips, -on_rows, changing]
        return ca.Function("outer", [q, v, W, wound, z], [ca.densify(x) for x in found])

    def _section(self, place: Place) -> Frame:
        return self.oracle.section(place.link, self.oracle.clouds[place.link], place.s)

    def _end(self, end: str | dict) -> Frame:
        if isinstance(end, dict):
            return ca.SX.eye(3), ca.SX(end["world"])
        return self._section(self.place(end))

    def _spin(self, R: ca.SX) -> ca.SX:
        """The angular velocity in inertial axes."""
        turn = rates([R], self.oracle.q, self.oracle.v)[0] @ R.T
        return ca.vertcat(turn[2, 1], turn[0, 2], turn[1, 0])

    def _line(self, law: dict, first: Frame, second: Frame, paid_out: float, speed: float) -> Acting:
        """A spring and a damper along a line, or a rope."""
        q, line, slack = self.oracle.q, second[1] - first[1], law.get("slack", False)
        length = ca.norm_2(line)
        stretch = length - law.get("rest", 0.0) - paid_out
        damped = law.get("damping", 0.0) * (rates([length], q, self.oracle.v)[0] - speed)
        pull = law["stiffness"] * stretch + damped
        taut = ca.logic_and(stretch > 0, pull > 0) if slack else 1
        energy = law["stiffness"] * stretch**2 / 2 * ((stretch > 0) if slack else 1)
        force = -taut * (ca.gradient(energy, q) + damped * ca.gradient(length, q))
        return Acting(force, energy, ca.SX.zeros(3), -taut * pull * line / length)

    def _relaxing(self, law: dict, own: Acting, first: Frame, second: Frame, z: ca.SX) -> tuple[Acting, ca.SX]:
        """A line with another spring beside it, of the stretch z, in series with a damper; the rate of z."""
        q, line = self.oracle.q, second[1] - first[1]
        length, pull = ca.norm_2(line), law["relaxation"] * z
        rate = rates([length], q, self.oracle.v)[0] - z / law["relaxation_time"]
        force, load = own.force - pull * ca.gradient(length, q), own.load - pull * line / length
        return Acting(force, own.energy + pull * z / 2, own.torque, load), rate

    def _bushing(self, law: dict, first: Frame, second: Frame) -> Acting:
        """Springs and dampers along and about the axes of the first frame; the torque by the slope of the energy."""
        q, v, (R_a, a), (R_b, b) = self.oracle.q, self.oracle.v, first, second
        R, d, turn = R_a.T @ R_b, R_a.T @ (b - a), ca.SX.sym("turn", 3)
        K, C = ca.DM(law["stiffness"]), ca.DM(law.get("damping", [0.0] * 6))

        def wound(R: ca.SX) -> ca.SX:
            e = ca.vertcat(R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]) / (2 * ca.sqrt(1 + ca.trace(R)))
            return 2 * ca.dot(K[3:], e**2)

        energy = ca.dot(K[:3], d**2) / 2 + wound(R)
        rate = ca.vertcat(rates([d], q, v)[0], self._spin(R))
        force = -ca.gradient(energy, q) - ca.jtimes(rate, v, C * rate, True)
        slope = ca.gradient(wound((ca.SX.eye(3) + ca.skew(turn)) @ R), turn)
        torque = -ca.substitute(slope, turn, ca.SX.zeros(3)) - C[3:] * rate[3:]
        return Acting(force, energy, R_a @ torque, -R_a @ (K[:3] * d + C[:3] * rate[:3]))

    def _joint(self, law: dict, first: Frame, second: Frame) -> Acting:
        """A joint that leaves a slide and a turn free and gives way in all else: across the slide, and by the sine of
        the angle between the axis of the turn in both frames."""
        (slide, axis), (R_a, a), (R_b, b) = law["axes"], first, second
        along, about = ca.DM(slide["slide"]), ca.DM([float(x == axis) for x in "xyz"])
        k, c = (ca.DM([x] * 3 + [y] * 3) for x, y in (law["stiffness"], law["damping"]))
        turn = ca.SX.sym("turn", 3)
        across = lambda n, x: x - n * ca.dot(n, x)  # noqa: E731
        d, R = across(along, R_a.T @ (b - a)), R_a.T @ R_b
        tilted = lambda turned: across(about, (ca.SX.eye(3) + ca.skew(turned)) @ R @ about)  # noqa: E731
        off = tilted(ca.SX.zeros(3))
        gap = ca.vertcat(d, off)
        rate = rates([gap], self.oracle.q, self.oracle.v)[0]
        stress = k * gap + c * rate
        force = -ca.jtimes(gap, self.oracle.q, stress, True)
        torque = -ca.substitute(ca.jtimes(tilted(turn), turn, stress[3:], True), turn, ca.SX.zeros(3))
        return Acting(force, ca.dot(k, gap**2) / 2, R_a @ torque, -R_a @ stress[:3])

    def _body(self, frame: Frame) -> Body:
        return Body(*frame, self._spin(frame[0]), rates([frame[1]], self.oracle.q, self.oracle.v)[0])

    def _touching(self, touch: Touch, first: Frame, second: Frame) -> Acting:
        """What acts at one point of both frames, by what their material there moves."""
        held = ca.SX.sym("force", 3)
        power = ca.dot(held, self._body(first).moving(touch.point) - self._body(second).moving(touch.point))
        force = ca.substitute(ca.gradient(power, self.oracle.v), held, touch.force)
        return Acting(force, touch.energy, -ca.cross(touch.point - second[1], touch.force), -touch.force)

    def _on_tip(self, place: Place, torque: ca.SX, load: ca.SX, point: ca.SX) -> ca.SX:
        """(6, n): the equivalent on the tip of the link of what acts at a point of the section."""
        cloud, out = self.oracle.clouds[place.link], ca.SX.zeros(6, self.oracle.n)
        moment = torque + ca.cross(point - cloud.tip_point, load)
        out[:, place.link] = ca.vertcat(cloud.tip_R.T @ moment, cloud.tip_R.T @ load)
        return out

    def _on_row(self, place: Place, torque: ca.SX, load: ca.SX, point: ca.SX) -> ca.SX:
        """(6, rows): the wrench of a spring on the row at its end, if one is there."""
        out = ca.SX.zeros(6, len(self.rows))
        for k, row in enumerate(self.rows):
            if row.place == place and not row.own:
                R, r = self._section(place)
                out[:, k] = ca.vertcat(R.T @ (torque + ca.cross(point - r, load)), R.T @ load)
        return out
