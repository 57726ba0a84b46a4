"""The task, the plant and the model that the controllers are designed with."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import casadi as ca
import numpy as np

import screwgen
from screwgen import Model, Modes, Robot
from screwgen.runtime.compiled import Compiled
from screwgen.simulation.motion import displacements, modal_columns, tip_position

FILE = Path(__file__).resolve().parents[1] / "ella_paper.toml"
GOAL = np.array([-0.4928, 0.6922, 0.4270])
"""rad: the paper's set points; the joints start at 0, the arm straight and horizontal."""
LIMIT = np.array([300.0, 150.0, 70.0])
"""N·m: of every motor, for every controller."""
ARMATURE = (1.0, 1.0, 0.4)
"""kg·m²: rotor inertias seen at the joints, of the size that geared joints of such torques have.

The paper's arm has none: then no loop of 1 kHz can damp a joint.
"""
PAYLOAD = "forearm.bodies[0].mass"
ERROR = 1.3
"""The plant's payload over the one that all controllers are designed with."""
STEP = 1e-3
"""s: of the plant, and of PD and rate loop."""
STATIONS = np.linspace(0.125, 1.0, 8)
"""Where along a link its deflection is known, as s in [0, 1]."""


def arm(modes: Modes) -> Robot:
    """ELLA with rotors and these modes in each link."""
    robot, at, links = screwgen.load(FILE), 0, []
    for link in robot.links:
        part = slice(at, at := at + len(link.joint.axes))
        joint = link.joint.model_copy(update={"armature": ARMATURE[part]})
        links.append(link.model_copy(update={"modes": modes, "joint": joint}))
    return robot.model_copy(update={"links": tuple(links)})


@dataclass(frozen=True)
class Arms:
    """Plant and model; made once."""

    @cached_property
    def plant(self) -> Model:
        """Three polynomial bending modes per plane and an axial mode in each link: 17 coordinates."""
        return screwgen.derive(arm(Modes(basis="polynomial", axial=1, bending_y=3, bending_z=3)))

    @cached_property
    def model(self) -> Model:
        """Two polynomial bending modes per plane and link: 11 coordinates."""
        return screwgen.derive(arm(Modes(basis="polynomial", bending_y=2, bending_z=2)))

    @cached_property
    def p(self) -> np.ndarray:
        """The plant's parameters: the payload is heavier than the file's."""
        return self.parameters((ERROR - 1) * self.nominal[self.plant.parameter_names.index(PAYLOAD)])

    @cached_property
    def nominal(self) -> np.ndarray:
        """The parameters that the file states."""
        return np.array(self.plant.parameter_values)

    def parameters(self, extra: float) -> np.ndarray:
        """The file's, with `extra` kg of payload."""
        p = self.nominal.copy()
        p[self.plant.parameter_names.index(PAYLOAD)] += extra
        return p

    @cached_property
    def compiled(self) -> Compiled:
        """The plant in generated C."""
        return self.prepared(self.p)

    @cached_property
    def rehearsal(self) -> Compiled:
        """The same C with the file's payload, on which the gains of the PD are chosen."""
        return self.prepared(self.nominal)

    def prepared(self, p) -> Compiled:
        out = Compiled(self.plant, flags=("-O1",), cache=True)
        out.prepare(p)
        return out

    @cached_property
    def goal(self) -> np.ndarray:
        """(3,) m: where the tip shall be, which is where the arm of the file rests with its joints at `GOAL`."""
        return tip_position(self.plant, at_rest(self.plant, GOAL, self.nominal)[0][None], self.nominal)[0]

    @cached_property
    def projection(self) -> np.ndarray:
        """(11, 17): the model's coordinates from the plant's.

        Joint coordinates are measured. The modal ones fit, by least squares, the deflections that the plant's links
        have at `STATIONS`; rates alike. Axial deflection is left out.
        """
        return projected(self.model, self.plant, {"bending_y": 1, "bending_z": 2})

    def rest(self, joints) -> tuple[np.ndarray, np.ndarray]:
        """The plant's coordinates (17,) at rest with these joint angles (3,), and the torques (3,) that hold it."""
        return at_rest(self.plant, joints, self.p)

    def tip(self, q: np.ndarray) -> np.ndarray:
        """The plant's tip (N, 3), m, inertial frame."""
        return tip_position(self.plant, q, self.p)


def projected(model: Model, plant: Model, directions: dict[str, int]) -> np.ndarray:
    """(nq, nq of the plant): what `Arms.projection` says, for modes of these directions and their axes."""
    T, m = np.zeros((model.nq, plant.nq)), model.n_joints
    T[:m, :m] = np.eye(m)
    for link in range(model.n_links):
        for direction, k in directions.items():
            to, of = (modal_columns(a, link, direction) for a in (model, plant))
            shapes = [
                displacements(a, np.eye(a.nq)[columns], link, STATIONS)[:, :, k].T
                for a, columns in ((model, to), (plant, of))
            ]
            T[np.ix_(to, of)] = np.linalg.lstsq(*shapes, rcond=None)[0]
    return T


def at_rest(model: Model, joints, p) -> tuple[np.ndarray, np.ndarray]:
    """Coordinates (nq,) and torques (3,) of the arm at rest: the modes sag until the bias vanishes."""
    n, bias = model.nq, model.casadi()["bias"]
    eta = ca.SX.sym("eta", n - 3)
    h = bias(ca.vertcat(ca.DM(joints), eta), np.zeros(n), np.zeros((6, 2)), p)
    find = ca.rootfinder("rest", "newton", {"x": eta, "g": h[3:]}, {"max_iter": 30})
    q = np.append(joints, np.array(find(x0=np.zeros(n - 3))["x"]).ravel())
    return q, held(model, q, p)


def at_rest_there(model: Model, place, p) -> tuple[np.ndarray, np.ndarray]:
    """Coordinates (nq,) and torques (3,) of the arm at rest with its tip at `place` (3,), near the joints' `GOAL`."""
    n, functions = model.nq, model.casadi()
    q = ca.SX.sym("q", n)
    h = functions["bias"](q, np.zeros(n), np.zeros((6, 2)), p)
    off = functions["tip_pose"](q, p)[1] - ca.DM(place)
    find = ca.rootfinder("rest", "newton", {"x": q, "g": ca.vertcat(h[3:], off)}, {"max_iter": 30})
    found = np.array(find(x0=at_rest(model, GOAL, p)[0])["x"]).ravel()
    return found, held(model, found, p)


def held(model: Model, q, p) -> np.ndarray:
    """(3,) N·m: the torques that hold the arm."""
    return np.array(model.casadi()["bias"](q, np.zeros(model.nq), np.zeros((6, 2)), p)).ravel()[:3]
