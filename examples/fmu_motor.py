"""ELLA as a functional mock-up unit: beside a controller's unit in a co-simulation, and alone in fmpy.

The arm's unit is what `screwgen generate --target fmu2` writes; the controller is a unit of its own, made from
`fmu_controller.py` by pythonfmu. A small master moves both, a millisecond at a time. Then fmpy alone lets the arm
fall, by co-simulation and by model exchange with CVODE. Draws build/fmu_motor.png and build/fmu_fall.png and ends in
assertions about its figures.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Slave
from pythonfmu.builder import FmuBuilder

import screwgen
from screwgen.integrators import METHODS
from screwgen.plotting.look import canvas, png, styled

ROOT = Path(__file__).resolve().parents[1]
STEP = 1e-3
JOINTS = ("upper_arm.joint[0]", "upper_arm.joint[1]", "forearm.joint[0]")
RATES = tuple(name.replace("joint[", "joint_rate[") for name in JOINTS)
TORQUES = tuple(name.replace("joint[", "torque[") for name in JOINTS)
GOAL = np.array([-0.4928, 0.6922, 0.4270])
TIP = tuple(f"forearm.tip.position.{x}" for x in "xyz")


class Unit:
    """An instance for co-simulation, whose real variables are known by their names."""

    def __init__(self, path: Path):
        description = read_model_description(str(path))
        name = description.coSimulation.modelIdentifier
        self.references = {x.name: x.valueReference for x in description.modelVariables}
        self.fmu = FMU2Slave(
            guid=description.guid, unzipDirectory=extract(str(path)), modelIdentifier=name, instanceName=name
        )
        self.fmu.instantiate()
        self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def get(self, names) -> list[float]:
        return self.fmu.getReal([self.references[name] for name in names])

    def set(self, names, values) -> None:
        self.fmu.setReal([self.references[name] for name in names], [float(x) for x in values])


def units(folder: Path) -> tuple[Path, Path]:
    """The arm's unit and the controller's."""
    folder.mkdir(parents=True, exist_ok=True)
    screwgen.derive(screwgen.load(ROOT / "examples" / "ella_paper.toml")).write(folder / "arm", targets=("fmu2",))
    script = ROOT / "examples" / "fmu_controller.py"
    FmuBuilder.build_FMU(script, dest=folder)
    return folder / "arm" / "fmu2" / "ella.fmu", folder / "MotorController.fmu"


def co_simulate(arm: Unit, controller: Unit, duration: float) -> dict[str, np.ndarray]:
    """Both units in turns: what the arm measures goes to the controller, whose torques are held over a step."""
    rows = []
    for k in range(round(duration / STEP) + 1):
        t, q = k * STEP, arm.get(JOINTS)
        controller.set([f"q{i}" for i in range(3)], q)
        controller.set([f"v{i}" for i in range(3)], arm.get(RATES))
        controller.fmu.doStep(t, STEP)
        tau = controller.get([f"tau{i}" for i in range(3)])
        arm.set(TORQUES, tau)
        rows.append([t, *q, *tau, *arm.get(TIP), *controller.get([f"current{i}" for i in range(3)])])
        arm.fmu.doStep(t, STEP)
    table = np.array(rows)
    return {
        "t": table[:, 0],
        "q": table[:, 1:4],
        "tau": table[:, 4:7],
        "tip": table[:, 7:10],
        "current": table[:, 10:],
    }


def fall(path: Path, duration: float) -> dict[str, np.ndarray]:
    """The arm let go, in fmpy: by its own steps, and by CVODE."""
    outputs = [*TIP, "energy.kinetic", "energy.potential"]
    ways: dict = {"co-simulation": {"fmi_type": "CoSimulation"}, "model exchange": {"fmi_type": "ModelExchange"}}
    common = {"stop_time": duration, "output_interval": 5e-3, "output": outputs, "relative_tolerance": 1e-8}
    fine = {"solver.step": 2e-5, "solver.method": list(METHODS).index("rk4") + 1}
    ways["co-simulation"]["start_values"] = fine
    return {name: simulate_fmu(str(path), **way, **common) for name, way in ways.items()}


@styled
def draw(found: dict[str, np.ndarray]) -> bytes:
    figure = canvas(8.0, 6.0, "ELLA and its controller, two units")
    angles, currents, tip = figure.subplots(3, 1, sharex=True)
    for k, name in enumerate(JOINTS):
        line = angles.plot(found["t"], found["q"][:, k], label=name)[0]
        angles.axhline(GOAL[k], color=line.get_color(), linewidth=0.7, linestyle=":")
        currents.plot(found["t"], found["current"][:, k])
    for k, axis in enumerate("xyz"):
        tip.plot(found["t"], found["tip"][:, k], label=axis)
    for axes, label in ((angles, "joints, rad"), (currents, "currents, A"), (tip, "tip, m")):
        axes.set_ylabel(label)
    angles.legend(loc="center right")
    tip.legend(loc="center right")
    tip.set_xlabel("t, s")
    return png(figure)


@styled
def draw_fall(found: dict[str, np.ndarray]) -> bytes:
    figure = canvas(8.0, 4.6, "ELLA let go: its unit in fmpy")
    height, energy = figure.subplots(2, 1, sharex=True)
    for (name, run), style in zip(found.items(), ("-", ":"), strict=True):
        height.plot(run["time"], run[TIP[2]], style, label=name, linewidth=1.2 if style == "-" else 2.2)
        energy.plot(run["time"], run["energy.kinetic"] + run["energy.potential"], style)
    height.set_ylabel("height of the tip, m")
    energy.set_ylabel("energy, J")
    energy.set_xlabel("t, s")
    height.legend(loc="upper right")
    return png(figure)


def main(arguments=None) -> dict[str, float]:
    """Run, print, draw; returns the figures."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--short", action="store_true", help="shorter runs, for tests")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "build", help="folder of units and pictures")
    given = parser.parse_args(arguments)
    arm, controller = units(given.output / "fmu_motor")
    found = co_simulate(Unit(arm), Unit(controller), 3.0)
    fallen = fall(arm, 0.2 if given.short else 0.6)
    (given.output / "fmu_motor.png").write_bytes(draw(found))
    (given.output / "fmu_fall.png").write_bytes(draw_fall(fallen))
    ends = np.array([[run[name][-1] for name in TIP] for run in fallen.values()])
    figures = {
        "miss": float(np.abs(found["q"][-1] - GOAL).max()),
        "current": float(np.abs(found["current"]).max()),
        "apart": float(np.abs(ends[0] - ends[1]).max()),
    }
    print(f"joints at the end of the motion: {1e3 * figures['miss']:.1f} mrad from the goal at most")
    print(f"largest current: {figures['current']:.1f} A")
    print(f"tip of the falling arm: {1e6 * figures['apart']:.2f} um between co-simulation and CVODE")
    assert figures["miss"] < 0.01 and figures["current"] < 20.0 and figures["apart"] < 1e-5, figures
    return figures


if __name__ == "__main__":
    main()
