"""A beam that is spun up and a beam that swings, both bending far, against Exudyn's geometrically exact beams.

    python bench/exact_swings.py [--elements 32,64] [--modes 4:2:1,2:2:2] [--record FILE]

In the plane. `spin_up`: 10 m without weight, its base turned to 6 rad/s in 15 s. `pendulum`: hinged at its base,
released level and straight; it bends by some 9 % of its length. --modes lists bending modes of a piece, order (1, 2
or exact) and pieces. --record writes the finest mesh's tips, against which a test holds the modes without Exudyn. Some
minutes.
"""

from __future__ import annotations

import argparse
import json
import sys
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import casadi as ca
import numpy as np

import screwgen

SHEAR = 1e7
"""Stiffness in N where the modes have none to give way; elements of one integration point do not lock."""


class Case(NamedTuple):
    """A beam (m, kg/m, N·m², N) along x whose base turns about z; weight along -y."""

    name: str
    length: float
    rhoA: float
    EI: float
    EA: float
    gravity: float
    end: float
    """s"""
    step: float
    """Exudyn's, s."""
    driven: bool
    """Whether `angle` states the turning of the base; otherwise the base is a hinge."""

    def angle(self, t, maths=np):
        """Of the driven base, with its first two rates: rad, rad/s, rad/s²; to 6 rad/s in 15 s."""
        T, rate = 15.0, 6.0
        w, s = 2 * np.pi / T, maths.fmin(t, T)
        turned = rate / T * (s**2 / 2 + (maths.cos(w * s) - 1) / w**2) + rate * (t - s)
        return turned, rate / T * (s - maths.sin(w * s) / w), rate / T * (1 - maths.cos(w * s))


CASES = {
    "spin_up": Case("spin_up", 10.0, 1.2, 1.4e4, 2.8e7, 0.0, 20.0, 5e-3, True),
    "pendulum": Case("pendulum", 1.0, 1.0, 1.5, 1e5, 9.81, 1.0, 2.5e-4, False),
}
SAMPLES = 40


def times(case: Case) -> np.ndarray:
    return np.linspace(0.0, case.end, SAMPLES + 1)


# --------------------------------------------------------------------------------------------- screwgen


def rod(case: Case, modes: int, order: int | str, pieces: int) -> screwgen.Robot:
    """The beam in welded pieces, each with so many bending modes and one in stretching."""
    section = {"rhoA": case.rhoA, "EA": case.EA, "EIz": case.EI, "rhoIp": 1e-6}
    shape = {"basis": "polynomial", "axial": 1, "bending_y": modes}
    links = [
        {"name": f"piece{k}", "length": case.length / pieces, "section": section, "modes": shape}
        | {"joint": {"axes": ["z"] if k == 0 else []}}
        for k in range(pieces)
    ]
    robot = {"name": case.name, "gravity": [0.0, -case.gravity, 0.0], "order": order, "links": links}
    return screwgen.Robot.model_validate(robot)


def modes_run(case: Case, modes: int, order: int | str, pieces: int = 1) -> np.ndarray:
    """The tip (SAMPLES, 2) by CasADi's functions and CVODES, m."""
    model = screwgen.derive(rod(case, modes, order, pieces))
    functions, p, n = model.casadi(), model.parameter_values, model.nq
    q, v, t = ca.MX.sym("q", n), ca.MX.sym("v", n), ca.MX.sym("t")
    free = ca.DM.zeros(6, pieces)
    if case.driven:
        angle, rate, rise = case.angle(t, ca)
        at, moving = ca.vertcat(angle, q[1:]), ca.vertcat(rate, v[1:])
        M, h = functions["mass_matrix"](at, p), functions["bias"](at, moving, free, p)
        vdot = ca.vertcat(0, ca.solve(M[1:, 1:], -h[1:] - M[1:, 0] * rise))
    else:
        at, vdot = q, functions["forward_dynamics"](q, v, 0, 0, p)[0]
    system = {"x": ca.vertcat(q, v), "t": t, "ode": ca.vertcat(v, vdot)}
    options = {"reltol": 1e-8, "abstol": 1e-10, "max_num_steps": 100000}
    solver = ca.integrator("motion", "cvodes", system, 0.0, times(case)[1:], options)
    states = solver(x0=np.zeros(2 * n))["xf"].full()
    place = ca.Function("place", [t, q], [functions["tip_pose"](at, p)[1]])
    return np.array([place(at, x[:n]).full()[:2, 0] for at, x in zip(times(case)[1:], states.T, strict=True)])


# ----------------------------------------------------------------------------------------------- Exudyn


def exact_run(case: Case, elements: int) -> np.ndarray:
    """The tip (SAMPLES, 2) by so many elements in the plane, m. The generalised-α method."""
    import exudyn as exu
    from exudyn import itemInterface as items

    container = exu.SystemContainer()
    mbs, h = container.AddSystem(), case.length / elements
    nodes = [mbs.AddNode(items.NodeRigidBody2D(referenceCoordinates=[h * k, 0, 0])) for k in range(elements + 1)]
    stiff = {"bendingStiffness": case.EI, "axialStiffness": case.EA, "shearStiffness": SHEAR}
    inertia = {"massPerLength": case.rhoA, "crossSectionInertia": 1e-9 * case.rhoA * case.length**2}
    for pair in pairwise(nodes):
        beam = items.ObjectBeamGeometricallyExact2D(nodeNumbers=list(pair), length=h, **stiff, **inertia)
        mbs.AddObject(beam)
    for k, node in enumerate(nodes):
        weight = case.rhoA * h * case.gravity * (0.5 if k in (0, elements) else 1.0)
        marker = mbs.AddMarker(items.MarkerNodePosition(nodeNumber=node))
        mbs.AddLoad(items.Force(markerNumber=marker, loadVector=[0, -weight, 0]))
    ground = mbs.AddNode(items.NodePointGround())
    fixed = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    for k in range(3 if case.driven else 2):
        marker = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=k))
        law = {}
        if k == 2:
            law = {"offsetUserFunction": lambda mbs, t, *_: float(case.angle(t)[0])}
            law |= {"offsetUserFunction_t": lambda mbs, t, *_: float(case.angle(t)[1])}
        mbs.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[fixed, marker], **law))
    position = exu.OutputVariableType.Position
    tip = mbs.AddSensor(items.SensorNode(nodeNumber=nodes[-1], outputVariableType=position, storeInternal=True))
    mbs.Assemble()
    s = exu.SimulationSettings()
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = case.end, round(case.end / case.step)
    s.timeIntegration.verboseMode, s.solution.file.write = 0, False
    s.timeIntegration.newton.useModifiedNewton = True
    s.timeIntegration.newton.relativeTolerance, s.timeIntegration.newton.absoluteTolerance = 1e-6, 1e-5
    s.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    s.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
    s.solution.sensors.writePeriod = case.end / SAMPLES
    s.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    mbs.SolveDynamic(s)
    return np.array(mbs.GetSensorStoredData(tip))[1:, 1:3]


# ------------------------------------------------------------------------------------------------ table


def off(run: np.ndarray, judge: np.ndarray, case: Case) -> tuple[float, float]:
    """The largest distance of the tips in m, and over the tip's travel, its largest distance from the start."""
    apart = float(np.linalg.norm(run - judge, axis=1).max())
    return apart, apart / float(np.linalg.norm(judge - [case.length, 0.0], axis=1).max())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--elements", default="32,64,128")
    parser.add_argument(
        "--modes", default="2:2:1,4:2:1,2:2:2,3:2:2,2:2:4,3:exact:1,4:exact:1", help="bending modes, order, pieces"
    )
    parser.add_argument("--record", type=Path, help="a JSON file for the tips of the finest mesh")
    args = parser.parse_args()
    meshes, exact, record = [int(n) for n in args.elements.split(",")], {}, {}
    for case in CASES.values():
        exact[case.name] = {n: exact_run(case, n) for n in meshes}
        recipe = (
            f"bench/exact_swings.py: Exudyn, {meshes[-1]} geometrically exact beams, steps of {1e3 * case.step:g} ms"
        )
        tip = exact[case.name][meshes[-1]].round(7).tolist()
        record[case.name] = {"recipe": recipe, "t": times(case)[1:].round(6).tolist(), "tip": tip}
    if args.record:
        args.record.write_text(json.dumps(record).replace("}, ", "},\n") + "\n", encoding="utf-8")
    for name, runs in exact.items():
        for n in meshes[:-1]:
            report(f"{name}, {n} elements", off(runs[n], runs[meshes[-1]], CASES[name]))
        for modes, order, pieces in (m.split(":") for m in args.modes.split(",") if m):
            modes, order, pieces = int(modes), int(order) if order.isdigit() else order, int(pieces)
            title = f"{name}, {modes} modes, order {order}, {pieces} pieces"
            try:
                report(title, off(modes_run(CASES[name], modes, order, pieces), runs[meshes[-1]], CASES[name]))
            except RuntimeError:
                print(f"{title:42} CVODES finds no way on", flush=True)
    return 0


def report(title: str, found: tuple[float, float]) -> None:
    print(f"{title:42} {1e3 * found[0]:10.3f} mm {100 * found[1]:8.4f} % of its travel", flush=True)


if __name__ == "__main__":
    sys.exit(main())
