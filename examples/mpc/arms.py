"""The task, the plant and the model that the controller has of it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import casadi as ca
import numpy as np

import screwgen
from screwgen import Model, Modes, Robot
from screwgen.compiled import Compiled
from screwgen.motion import displacements, modal_columns, tip_position

FILE = Path(__file__).resolve().parents[1] / "ella.toml"
GOAL = np.array([-0.4928, 0.6922, 0.4270])
"""rad: where the joints shall rest; they start at 0, the arm straight and horizontal."""
LIMIT = np.array([300.0, 150.0, 70.0])
"""N·m: of every motor, for every controller."""
ARMATURE = (1.0, 1.0, 0.4)
"""kg·m²: rotor inertias seen at the joints. The paper's arm has none: then no loop of 1 kHz can damp a joint."""
RATE_GAIN = np.array([100.0, 100.0, 40.0])
"""N·m·s/rad: of the drives' rate loop under the MPC, 1 kHz; damping of the joints in the MPC's model."""
PAYLOAD = "forearm.bodies[0].mass"
ERROR = 1.3
"""The plant's payload over the model's."""
STEP = 1e-3
"""s: of the plant, and of PD and rate loop."""
STATIONS = np.linspace(0.125, 1.0, 8)
"""Where along a link its deflection is known, as s in [0, 1]."""


def arm(modes: Modes, damping=None) -> Robot:
    """ELLA with rotors, these modes in each link, and joint damping (3,) if given."""
    robot, at, links = screwgen.load(FILE), 0, []
    for link in robot.links:
        part = slice(at, at := at + len(link.joint.axes))
        joint = {"armature": ARMATURE[part]} | (
            {} if damping is None else {"damping": tuple(map(float, damping[part]))}
        )
        links.append(link.model_copy(update={"modes": modes, "joint": link.joint.model_copy(update=joint)}))
    return robot.model_copy(update={"links": tuple(links)})


@dataclass(frozen=True)
class Arms:
    """Plant and model; made once."""

    @cached_property
    def plant(self) -> Model:
        """Two polynomial bending modes per plane and an axial mode in each link: 13 coordinates."""
        return screwgen.derive(arm(Modes(basis="polynomial", axial=1, bending_y=2, bending_z=2)))

    @cached_property
    def model(self) -> Model:
        """One clamped-free bending mode per plane and link, and the rate loop as joint damping: 7 coordinates."""
        return screwgen.derive(arm(Modes(bending_y=1, bending_z=1), RATE_GAIN))

    @cached_property
    def p(self) -> np.ndarray:
        """The plant's parameters: the payload is heavier than the model's."""
        p = np.array(self.plant.parameter_values)
        p[self.plant.parameter_names.index(PAYLOAD)] *= ERROR
        return p

    @cached_property
    def compiled(self) -> Compiled:
        """The plant in generated C."""
        out = Compiled(self.plant, flags=("-O1",))
        out.prepare(self.p)
        return out

    @cached_property
    def projection(self) -> np.ndarray:
        """(7, 13): the model's coordinates from the plant's.

        Joint coordinates are measured. The modal ones fit, by least squares, the deflections that the plant's links
        have at `STATIONS`; rates alike. Axial deflection is left out.
        """
        T = np.zeros((self.model.nq, self.plant.nq))
        T[:3, :3] = np.eye(3)
        for link in range(2):
            for k, direction in ((1, "bending_y"), (2, "bending_z")):
                to, of = (modal_columns(m, link, direction) for m in (self.model, self.plant))
                shapes = [
                    displacements(m, np.eye(m.nq)[columns], link, STATIONS)[:, :, k].T
                    for m, columns in ((self.model, to), (self.plant, of))
                ]
                T[np.ix_(to, of)] = np.linalg.lstsq(*shapes, rcond=None)[0]
        return T

    def rest(self, joints) -> tuple[np.ndarray, np.ndarray]:
        """The plant's coordinates (13,) at rest with these joint angles (3,), and the torques (3,) that hold it."""
        return at_rest(self.plant, joints, self.p)

    def tip(self, q: np.ndarray) -> np.ndarray:
        """The plant's tip (N, 3), m, inertial frame."""
        return tip_position(self.plant, q, self.p)


def at_rest(model: Model, joints, p) -> tuple[np.ndarray, np.ndarray]:
    """Coordinates (nq,) and torques (3,) of the arm at rest: the modes sag until the bias vanishes."""
    n, bias = model.nq, model.casadi()["bias"]
    eta = ca.SX.sym("eta", n - 3)
    h = bias(ca.vertcat(ca.DM(joints), eta), np.zeros(n), np.zeros((6, 2)), p)
    find = ca.rootfinder("rest", "newton", {"x": eta, "g": h[3:]}, {"max_iter": 30})
    q = np.append(joints, np.array(find(x0=np.zeros(n - 3))["x"]).ravel())
    return q, np.array(bias(q, np.zeros(n), np.zeros((6, 2)), p)).ravel()[:3]
