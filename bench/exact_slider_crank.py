"""A slider-crank whose connecting rod bends, against Exudyn's geometrically exact beams.

    python bench/exact_slider_crank.py [--elements 32,64,128] [--modes 3:1:2,2:2:2,3:2:2] [--record FILE]

The mechanism of the literature (Jonker; Meijaard): a rigid crank of 0.15 m at 150 rad/s, a steel rod of 0.3 m and 6 mm
diameter, a slider of half the rod's mass, no weight, no damping. It starts stretched and straight with the rates of
rigid links. A flywheel on the crank keeps its rate, the same on both sides. Two turns. --modes lists bending modes of a
piece, order and pieces. --record writes the finest mesh's motion, against which a test holds the modes without Exudyn.
"""

from __future__ import annotations

import argparse
import json
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np

import screwgen

CRANK, ROD, DIAMETER, E, DENSITY, RATE = 0.15, 0.3, 6e-3, 2e11, 7870.0, 150.0
"""m, m, m, Pa, kg/m³, rad/s."""
AREA, INERTIA = np.pi * DIAMETER**2 / 4, np.pi * DIAMETER**4 / 64
SLIDER = DENSITY * AREA * ROD / 2
"""kg"""
FLYWHEEL = 100.0
"""kg·m², about the crank's bearing, all of the crank included."""
SHEAR = 1e8
"""Stiffness in N where the modes have none to give way."""
END, SAMPLES, STEP = 4 * np.pi / RATE, 80, 5e-6
"""s, samples, and Exudyn's step in s, which divides a sample."""


def steps(longest: float) -> int:
    """Steps of a sample, none longer than this."""
    return int(np.ceil(END / SAMPLES / longest))


# --------------------------------------------------------------------------------------------- screwgen


def robot(modes: int, order: int, pieces: int) -> screwgen.Robot:
    """The mechanism in the x-y plane; so many bending modes and one of stretching to a piece of the rod."""
    section = {"density": DENSITY, "area": AREA, "E": E, "Iy": INERTIA, "Iz": INERTIA}
    shape = {"basis": "polynomial", "axial": 1, "bending_y": modes}
    light = {"rhoA": 1e-6}
    crank = {"name": "crank", "length": CRANK, "section": light, "joint": {"axes": ["z"], "armature": [FLYWHEEL]}}
    rod = {"name": "rod", "length": ROD, "section": section, "modes": shape, "order": order, "segments": pieces}
    slider = {"name": "slider", "parent": "world", "bodies": [{"at": "base", "mass": SLIDER}]}
    slider["joint"] = {"axes": [{"slide": "x"}], "mount": {"xyz": [CRANK + ROD, 0.0, 0.0]}}
    hinge = {"between": ["rod.tip", "slider.tip"], "joint": {"axes": ["z"]}}
    links = [crank, rod | {"joint": {"axes": ["z"]}}, slider]
    return screwgen.Robot.model_validate(
        {"name": "slider_crank", "gravity": [0.0, 0.0, 0.0], "links": links, "loops": [hinge]}
    )


def modes_run(modes: int, order: int, pieces: int = 2, longest: float = 1e-5, derive=screwgen.derive) -> np.ndarray:
    """(SAMPLES, 2): places of the slider and deflections of the rod's middle from its chord, m; `pieces` even."""
    model = derive(robot(modes, order, pieces))
    v0 = np.zeros(model.nv)
    v0[:2] = RATE, -RATE * (1 + CRANK / ROD)
    every = steps(longest)
    step = END / SAMPLES / every
    run = screwgen.simulate(model, END, step, v0=v0, every=every, integrator="modal_midpoint")
    places = np.array([model.numpy().tip_poses(q)[1] for q in run.q[1:]])
    return deflected(places[:, 0, :2], places[:, pieces // 2, :2], places[:, pieces, :2])


def deflected(base: np.ndarray, middle: np.ndarray, tip: np.ndarray) -> np.ndarray:
    """(n, 2): x of the tip, and the middle's distance from the chord, m."""
    chord = tip - base
    across = np.stack([-chord[:, 1], chord[:, 0]], axis=1) / np.linalg.norm(chord, axis=1)[:, None]
    return np.stack([tip[:, 0], np.sum((middle - base) * across, axis=1)], axis=1)


# ----------------------------------------------------------------------------------------------- Exudyn


def exact_run(elements: int) -> np.ndarray:
    """The same by so many elements (an even number) in the plane. The generalised-α method."""
    import exudyn as exu
    from exudyn import itemInterface as items

    container = exu.SystemContainer()
    mbs, h = container.AddSystem(), ROD / elements
    turn = -RATE * CRANK / ROD
    nodes = [
        mbs.AddNode(
            items.NodeRigidBody2D(
                referenceCoordinates=[CRANK + h * k, 0, 0],
                initialVelocities=[0, RATE * CRANK * (1 - k / elements), turn],
            )
        )
        for k in range(elements + 1)
    ]
    stiff = {"bendingStiffness": E * INERTIA, "axialStiffness": E * AREA, "shearStiffness": SHEAR}
    inertia = {"massPerLength": DENSITY * AREA, "crossSectionInertia": 1e-3 * DENSITY * INERTIA}
    for pair in pairwise(nodes):
        mbs.AddObject(items.ObjectBeamGeometricallyExact2D(nodeNumbers=list(pair), length=h, **stiff, **inertia))
    mbs.AddObject(items.ObjectRigidBody2D(nodeNumber=nodes[-1], physicsMass=SLIDER, physicsInertia=0.0))
    bearing = mbs.AddNode(items.NodeRigidBody2D(initialVelocities=[0, 0, RATE]))
    crank = mbs.AddObject(items.ObjectRigidBody2D(nodeNumber=bearing, physicsMass=1.0, physicsInertia=FLYWHEEL))
    ground = mbs.AddNode(items.NodePointGround())
    fixed = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    for node, k in ((bearing, 0), (bearing, 1), (nodes[-1], 1)):
        marker = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
        mbs.AddObject(items.ObjectConnectorCoordinate(markerNumbers=[fixed, marker]))
    pin = mbs.AddMarker(items.MarkerBodyPosition(bodyNumber=crank, localPosition=[CRANK, 0, 0]))
    end = mbs.AddMarker(items.MarkerNodePosition(nodeNumber=nodes[0]))
    mbs.AddObject(items.ObjectJointRevolute2D(markerNumbers=[pin, end]))
    position = exu.OutputVariableType.Position
    watched = [
        mbs.AddSensor(items.SensorNode(nodeNumber=nodes[k], outputVariableType=position, storeInternal=True))
        for k in (0, elements // 2, elements)
    ]
    mbs.Assemble()
    s = exu.SimulationSettings()
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = END, SAMPLES * steps(STEP)
    s.timeIntegration.verboseMode, s.solution.file.write = 0, False
    s.timeIntegration.newton.useModifiedNewton = True
    s.timeIntegration.newton.relativeTolerance, s.timeIntegration.newton.absoluteTolerance = 1e-6, 1e-5
    s.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    s.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
    s.solution.sensors.writePeriod = END / SAMPLES / steps(STEP)
    s.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    mbs.SolveDynamic(s)
    return deflected(*(np.array(mbs.GetSensorStoredData(x))[:: steps(STEP), 1:3][1:] for x in watched))


# ------------------------------------------------------------------------------------------------ table


def off(run: np.ndarray, judge: np.ndarray) -> tuple[float, float]:
    """The largest errors of the slider, over its travel, and of the middle, over its largest deflection."""
    apart = np.abs(run - judge).max(axis=0)
    return float(apart[0] / (2 * CRANK)), float(apart[1] / np.abs(judge[:, 1]).max())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--elements", default="32,64,128")
    parser.add_argument("--modes", default="3:1:2,2:2:2,3:2:2,2:2:4", help="bending modes, order, pieces")
    parser.add_argument("--record", type=Path, help="a JSON file for the motion of the finest mesh")
    args = parser.parse_args()
    meshes = [int(n) for n in args.elements.split(",")]
    exact = {n: exact_run(n) for n in meshes}
    judge = exact[meshes[-1]]
    if args.record:
        recipe = (
            f"bench/exact_slider_crank.py: Exudyn, {meshes[-1]} geometrically exact beams, steps of {1e6 * STEP:g} us"
        )
        record = {"recipe": recipe, "slider": judge[:, 0].round(8).tolist(), "middle": judge[:, 1].round(9).tolist()}
        args.record.write_text(json.dumps(record).replace("], ", "],\n") + "\n", encoding="utf-8")
    print(f"the middle deflects by {np.abs(judge[:, 1]).max() / ROD:.5f} of the rod's length")
    for n in meshes[:-1]:
        report(f"{n} elements", off(exact[n], judge))
    for modes, order, pieces in (map(int, m.split(":")) for m in args.modes.split(",") if m):
        report(f"{modes} modes, order {order}, {pieces} pieces", off(modes_run(modes, order, pieces), judge))
    return 0


def report(title: str, found: tuple[float, float]) -> None:
    print(f"{title:30} slider {found[0]:.1e} of its travel, middle {found[1]:.1e} of its deflection", flush=True)


if __name__ == "__main__":
    sys.exit(main())
