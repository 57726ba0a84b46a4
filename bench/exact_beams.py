"""ELLA under PD against Exudyn's geometrically exact beams: how far tip and joint moments of its modes are off.

    python bench/exact_beams.py [--elements 8,16,32] [--modes polynomial:2,polynomial:2:2,clamped_free:1]
                                [--softer 9] [--step MS] [--record FILE]

The arm of examples/ella.toml, torsion rigid on both sides, rests under gravity and PD with its reference at zero; then
the reference moves to the set points of `MOTION` by minimum jerk. --modes lists basis, modes per plane and, where they
are not 1, order (1, 2 or exact) and pieces of a link; --softer divides the bending stiffness on both sides. --record
writes the finest mesh's motion, against which a test holds the modes without Exudyn. Some minutes.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
import warnings
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import casadi as ca
import numpy as np

import screwgen

ELLA = Path(__file__).resolve().parents[1] / "examples" / "ella.toml"
MOTION = {
    "kp": [15000.0, 15000.0, 5000.0],
    "kd": [600.0, 600.0, 150.0],
    "q_des": [-0.4928, 0.6922, 0.4270],
    "duration": 1.2,
}
"""N·m/rad, N·m·s/rad, rad, s."""
END, SAMPLE, RECORDED = 2.5, 0.01, 0.1
"""The run's length, and between samples and recorded samples, s."""
EA = 4.38e7
"""Axial stiffness in N, which ella.toml leaves out: stretching is rigid there."""
DEFAULTS = ("1", "1")
"""Of --modes: order and pieces."""
SHEAR, TWIST = 1e9, 1e8
"""Stiffness in N and N·m² where the modes have none to give way: at the tip they give less than a micrometre."""


class Samples(NamedTuple):
    """A run: time (n,) in s, tip (n, 3) in the inertial frame in m, moments of base and elbow (n, 2, 3), F_i, N·m."""

    t: np.ndarray
    tip: np.ndarray
    moments: np.ndarray

    def off(self, judge: Samples) -> tuple[float, np.ndarray]:
        """The largest distance of the tips in m, and of the moments (2,) in N·m."""
        moments = np.linalg.norm(self.moments - judge.moments, axis=2).max(axis=0)
        return float(np.linalg.norm(self.tip - judge.tip, axis=1).max()), moments

    def peaks(self) -> np.ndarray:
        """The largest moments (2,), N·m."""
        return np.linalg.norm(self.moments, axis=2).max(axis=0)


# --------------------------------------------------------------------------------------------- screwgen


def softened(softer: float) -> screwgen.Robot:
    """ELLA, its bending stiffness divided by `softer`."""
    robot, links = screwgen.load(ELLA), []
    for link in robot.links:
        section = link.section.model_copy(update={k: getattr(link.section, k) / softer for k in ("EIy", "EIz")})
        links.append(link.model_copy(update={"section": section}))
    return robot.model_copy(update={"links": tuple(links)})


def arm(basis: str, bending: int, order: int | str = 1, softer: float = 1.0) -> screwgen.Robot:
    """ELLA with so many bending modes per plane, else rigid; PD's gains `kp` are springs of its joints."""
    robot, links, gains = softened(softer), [], list(MOTION["kp"])
    modes = screwgen.Modes(basis=basis, bending_y=bending, bending_z=bending)
    for link in robot.links:
        springs = tuple(gains.pop(0) for _ in link.joint.axes)
        joint = link.joint.model_copy(update={"stiffness": springs})
        links.append(link.model_copy(update={"modes": modes, "joint": joint}))
    return robot.model_copy(update={"links": tuple(links), "order": order})


def pieced(robot: screwgen.Robot, count: int) -> screwgen.Robot:
    """The arm with every link cut into so many welded pieces."""
    links = []
    for link in robot.links:
        for k in range(count):
            own = {"name": f"{link.name}_{k + 1}", "length": link.length / count}
            own["bodies"] = tuple(b for b in link.bodies if b.at == "tip" and k == count - 1)
            own |= {} if k == 0 else {"joint": screwgen.Joint(axes=[])}
            links.append(link.model_copy(update=own))
    return robot.model_copy(update={"links": tuple(links)})


def modes_run(robot: screwgen.Robot, sample: float = SAMPLE) -> Samples:
    """The motion by modes: CasADi's forward dynamics under PD, by CVODES, so that no step spoils the comparison."""
    model = screwgen.derive(robot)
    functions, p, n = model.casadi(), model.parameter_values, model.n_joints
    q, v, t = ca.SX.sym("q", model.nq), ca.SX.sym("v", model.nv), ca.SX.sym("t")
    angles, rates = zip(*(reference(t, k) for k in range(n)), strict=True)
    tau = ca.DM(MOTION["kp"]) * ca.vertcat(*angles) + ca.DM(MOTION["kd"]) * (ca.vertcat(*rates) - v[:n])
    vdot, wrench = functions["forward_dynamics"](q, v, tau, 0, p)
    x, times = ca.vertcat(q, v), np.linspace(0.0, END, round(END / sample) + 1)
    system = {"x": x, "t": t, "ode": ca.vertcat(v, vdot)}
    start = np.append(screwgen.equilibrium(model).q, np.zeros(model.nq))
    solver = ca.integrator("motion", "cvodes", system, 0.0, times[1:], {"reltol": 1e-8, "abstol": 1e-10})
    states = np.column_stack([start, solver(x0=start)["xf"].full()])
    watch = ca.Function("watch", [t, x], [wrench[:3, :], functions["tip_pose"](q, p)[1]])
    moments, tips = zip(*(watch(*at) for at in zip(times, states.T, strict=True)), strict=True)
    elbow = len(robot.links) // 2
    moments = np.array([m.full().T[[0, elbow]] for m in moments])
    return Samples(times, np.array([m.full()[:, 0] for m in tips]), moments)


def order_of(text: str) -> int | str:
    """As robot files write it: a number, or "exact"."""
    return int(text) if text.isdigit() else text


def reference(t, axis: int):
    """Angle (rad) and rate (rad/s) that PD follows; `t` in s, a number or a CasADi expression."""
    s, goal = ca.fmin(t / MOTION["duration"], 1.0), MOTION["q_des"][axis]
    return goal * s**3 * (10 - 15 * s + 6 * s**2), goal * 30 * (s * (1 - s)) ** 2 / MOTION["duration"]


# ----------------------------------------------------------------------------------------------- Exudyn


def exact_run(elements: int, step: float, softer: float) -> Samples:
    """The motion by so many elements per link. The generalised-α method; moments are those of the joints."""
    try:
        import exudyn as exu
    except ImportError as error:
        raise SystemExit(f"exact_beams: the Python package 'exudyn' is not installed ({error})") from None
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = ExactArm(exu, elements, softer)
        model.settle()
        return model.move(step)


class ExactArm:
    """Exudyn's model. The universal joint is two revolute ones with a body of no weight between them."""

    def __init__(self, exu, elements: int, softer: float):
        from exudyn import itemInterface

        self.exu, self.items, self.robot = exu, itemInterface, softened(softer)
        model = screwgen.derive(self.robot)
        self.values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
        self.container, self.moving = exu.SystemContainer(), False
        self.mbs = self.container.AddSystem()
        ends, x = [], 0.0
        for link in self.robot.links:
            nodes = self._beam(link, x, elements)
            ends.append((nodes[0], nodes[-1]))
            x += link.length
        self.tip = ends[-1][1]
        self._joints(ends)
        self._sensors()
        self.mbs.Assemble()

    def _node(self, x: float) -> int:
        return self.mbs.AddNode(self.items.NodeRigidBodyEP(referenceCoordinates=[x, 0, 0, 1, 0, 0, 0]))

    def _rigid(self, node: int) -> int:
        return self.mbs.AddMarker(self.items.MarkerNodeRigid(nodeNumber=node))

    def _beam(self, link, x: float, elements: int) -> list[int]:
        """The nodes of a link, its weight shared among them, and the point mass at its tip."""
        rhoA, EIy, EIz, rhoIp = (self.values[f"{link.name}.{key}"] for key in ("rhoA", "EIy", "EIz", "rhoIp"))
        section, h = self.exu.BeamSection(), link.length / elements
        section.massPerLength = rhoA
        section.inertia = np.diag([rhoIp, rhoIp * EIy / (EIy + EIz), rhoIp * EIz / (EIy + EIz)])
        section.stiffnessMatrix = np.diag([EA, SHEAR, SHEAR, TWIST, EIy, EIz])
        nodes = [self._node(x + h * k) for k in range(elements + 1)]
        for pair in pairwise(nodes):
            beam = self.items.ObjectBeamGeometricallyExact(nodeNumbers=list(pair), length=h, sectionData=section)
            self.mbs.AddObject(beam)
        (body,) = link.bodies
        self.mbs.AddObject(self.items.ObjectRigidBody(mass=body.mass, inertia=[0.0] * 6, nodeNumber=nodes[-1]))
        for k, node in enumerate(nodes):
            mass = rhoA * h * (0.5 if k in (0, elements) else 1.0) + (body.mass if k == elements else 0.0)
            load = [mass * g for g in self.robot.gravity]
            self.mbs.AddLoad(self.items.Force(markerNumber=self._rigid(node), loadVector=load))
        return nodes

    def _joints(self, ends: list[tuple[int, int]]) -> None:
        """Revolute joints about y, z and z, each with PD as the law of a spring."""
        items, about_y = self.items, np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
        light = {"mass": 1e-6, "inertia": [1e-6] * 3 + [0.0] * 3}
        between = self.mbs.AddObject(items.ObjectRigidBody(**light, nodeNumber=self._node(0.0)))
        bodies = self.mbs.AddObject(items.ObjectGround()), between
        turned = self.exu.HT(rotation=about_y, translation=[0, 0, 0])
        first = [self.mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=b, localHT=turned)) for b in bodies]
        second = [self.mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=between)), self._rigid(ends[0][0])]
        third = [self._rigid(ends[0][1]), self._rigid(ends[1][0])]
        self.joints, self.springs = [], []
        for axis, markers in enumerate((first, second, third)):
            self.joints.append(self.mbs.AddObject(items.ObjectJointRevoluteZ(markerNumbers=markers)))
            spring = items.ObjectConnectorTorsionalSpringDamper(
                markerNumbers=markers,
                stiffness=MOTION["kp"][axis],
                damping=MOTION["kd"][axis],
                springTorqueUserFunction=self._law(axis),
            )
            self.springs.append(self.mbs.AddObject(spring))

    def _law(self, axis: int):
        def torque(mbs, t, item, angle, rate, kp, kd, offset):
            angle_ref, rate_ref = map(float, reference(t, axis)) if self.moving else (0.0, 0.0)
            return kp * (angle - angle_ref) + kd * (rate - rate_ref)

        return torque

    def _sensors(self) -> None:
        kind = self.exu.OutputVariableType
        wanted = [(self.items.SensorNode, {"nodeNumber": self.tip}, kind.Position)]
        wanted += [(self.items.SensorObject, {"objectNumber": j}, kind.TorqueLocal) for j in self.joints[1:]]
        wanted += [(self.items.SensorObject, {"objectNumber": s}, kind.TorqueLocal) for s in self.springs[1:]]
        self.sensors = [self.mbs.AddSensor(s(**at, outputVariableType=v, storeInternal=True)) for s, at, v in wanted]

    def settle(self) -> None:
        """The static rest becomes the initial state."""
        s = self._settings()
        s.staticSolver.numberOfLoadSteps, s.staticSolver.verboseMode = 4, 0
        s.staticSolver.newton.relativeTolerance, s.staticSolver.newton.absoluteTolerance = 1e-7, 1e-6
        self.mbs.SolveStatic(s)
        data, start = self.mbs.systemData, self.exu.ConfigurationType.Initial
        data.SetODE2Coordinates(data.GetODE2Coordinates(), start)
        data.SetODE2Coordinates_t(0 * data.GetODE2Coordinates(), start)

    def move(self, step: float) -> Samples:
        """The motion from rest; raises Exudyn's error where it does not converge."""
        s, self.moving = self._settings(), True
        s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = END, round(END / step)
        s.timeIntegration.verboseMode = 0
        s.timeIntegration.newton.useModifiedNewton = True
        s.timeIntegration.newton.relativeTolerance, s.timeIntegration.newton.absoluteTolerance = 1e-7, 1e-4
        s.timeIntegration.generalizedAlpha.spectralRadius = 0.8
        s.timeIntegration.generalizedAlpha.computeInitialAccelerations = False
        s.solutionSettings.sensorsWritePeriod = SAMPLE
        self.mbs.SolveDynamic(s)
        tip, base, elbow, at_base, at_elbow = (np.array(self.mbs.GetSensorStoredData(k)) for k in self.sensors)
        # A revolute joint lists its reactions as [τ_y, −τ_x] of the second marker; PD's spring resists.
        moments = [np.array([-c[:, 2], c[:, 1], -d[:, 1]]).T for c, d in ((base, at_base), (elbow, at_elbow))]
        return Samples(tip[:, 0], tip[:, 1:], np.stack(moments, axis=1))

    def _settings(self):
        s = self.exu.SimulationSettings()
        s.solutionSettings.writeSolutionToFile = False
        s.linearSolverType = self.exu.LinearSolverType.EigenSparse
        return s


# ------------------------------------------------------------------------------------------------ table


def thinned(run: Samples, every: int = 1) -> Samples:
    """Every so many samples, without the start: there the joints' reactions are not known yet."""
    return Samples(*(x[every::every] for x in run))


def record(path: Path, elements: int, step: float, softer: float, run: Samples) -> None:
    """What the test reads, with the recipe that made it."""
    recipe = f"bench/exact_beams.py: Exudyn, {elements} geometrically exact beams per link, steps of {1e3 * step:g} ms"
    few = thinned(run, round(RECORDED / SAMPLE))
    data = {"recipe": recipe, "motion": MOTION, "softer": softer, "t": few.t.round(6).tolist()}
    data["peaks"] = thinned(run).peaks().round(4).tolist()
    data |= {"tip": few.tip.round(7).tolist(), "moments": few.moments.round(4).tolist()}
    path.write_text(json.dumps(data).replace("], [[", "],\n [[").replace('"tip"', '\n"tip"') + "\n", encoding="utf-8")


def report(name: str, run: Samples, judge: Samples, seconds: float) -> None:
    tip, moments = thinned(run).off(thinned(judge))
    base, elbow = 100 * moments / thinned(judge).peaks()
    print(f"{name:24} {1e3 * tip:9.3f} {base:9.3f} {elbow:9.3f} {seconds:8.0f} s", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--elements", default="8,16,32")
    parser.add_argument(
        "--modes", default="polynomial:2,polynomial:3,polynomial:2:2,polynomial:3:2,polynomial:3:exact,clamped_free:1"
    )
    parser.add_argument("--softer", type=float, default=1.0, help="what the bending stiffness is divided by")
    parser.add_argument("--step", type=float, default=2.0, help="Exudyn's, in ms")
    parser.add_argument("--record", type=Path, help="a JSON file for the motion of the finest mesh")
    args = parser.parse_args()
    meshes, runs = [int(n) for n in args.elements.split(",")], {}
    for n in meshes:
        clock = time.perf_counter()
        runs[n] = exact_run(n, args.step / 1e3, args.softer), time.perf_counter() - clock
    finest = runs[meshes[-1]][0]
    if args.record:
        record(args.record, meshes[-1], args.step / 1e3, args.softer, finest)
    sag = -1e3 * finest.tip[1, 2]
    print(f"{'against ' + str(meshes[-1]) + ' elements':24} {'tip, mm':>9} {'base, %':>9} {'elbow, %':>9}")
    print(f"the tip hangs {sag:.2f} mm below the base at rest; modes: count and basis, order, pieces", flush=True)
    for n in meshes[:-1]:
        report(f"{n} elements", runs[n][0], finest, runs[n][1])
    for text in filter(None, args.modes.split(",")):
        basis, count, order, pieces = (*text.split(":"), *DEFAULTS[text.count(":") - 1 :])
        clock, robot = time.perf_counter(), arm(basis, int(count), order_of(order), args.softer)
        own = modes_run(pieced(robot, int(pieces)))
        report(f"{count} {basis}, {order}, {pieces}", own, finest, time.perf_counter() - clock)
    return 0


if __name__ == "__main__":
    sys.exit(main())
