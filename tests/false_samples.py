"""Predictive control of six robots under false samples; run as a script for all cases, --sanitize with sanitizers.

tests/c/false_samples.c closes the loop around generated C and says what must hold.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

from c_robots import DRIVERS
from c_tools import SANITIZERS
from conftest import require_tool
from helpers import arm, link, model_of, unfolded

from screwgen.studies.predictive import project

SOFT = {"rhoA": 1.2, "EIy": 500.0, "EIz": 500.0}
LOAD = [{"at": "tip", "mass": 1.0}]
BENDS = {"section": SOFT, "modes": {"bending_y": 2}, "damping": {"ratio": 0.02}}


def turning(name: str, length: float, inertia: float, axes="z", **more) -> dict:
    joint = more.pop("joint", {})
    return link(name, length, axes=axes, joint={"armature": [inertia]} | joint, **more)


def rubbing(coulomb: float) -> dict:
    """Friction that remembers."""
    memory = {"stiffness": 2e3 * coulomb, "damping": 20.0 * coulomb}
    falling = {"static": 1.5 * coulomb, "velocity": 0.02}
    return {"drives": [{"friction": {"coulomb": coulomb, "viscous": 0.2, "memory": memory, "stribeck": falling}}]}


LIMITED = {
    "limits": {"lower": -1.0, "upper": 1.0, "stiffness": 500.0},
    "drives": [{"friction": {"coulomb": 0.5, "velocity": 0.05}}],
}
ROBOTS = {
    "flexible": arm(turning("up", 0.6, 0.2, **BENDS), turning("fore", 0.5, 0.1, **BENDS, bodies=LOAD)),
    "rigid": arm(turning("up", 0.6, 0.2), turning("fore", 0.5, 0.1, bodies=LOAD)),
    "hanging": arm(
        turning("up", 0.6, 0.3, **BENDS),
        turning("fore", 0.5, 0.2, "y", **BENDS, bodies=LOAD),
        gravity=[0.0, 0.0, -9.81],
    ),
    "slide": arm(link("cart", 0.3, axes=[{"slide": "y"}]), turning("mast", 0.8, 0.1, **BENDS, bodies=LOAD)),
    "bristles": arm(
        turning("up", 0.6, 0.2, joint=rubbing(1.5)), turning("fore", 0.5, 0.1, bodies=LOAD, joint=rubbing(0.8))
    ),
    "stops": arm(turning("up", 0.6, 0.2, **BENDS, joint=LIMITED), turning("fore", 0.5, 0.1, bodies=LOAD)),
}
CONTROL = """
[horizon]
intervals = 5
step = 0.02
substeps = {substeps}
{blocks}
[goal]
joints = [-0.4, 0.6]
[cost]
joints = 100.0
joint_rates = 20.0
modes = 1.0
mode_rates = 0.2
torques = 1e-5
terminal = {{ riccati = true }}
[bounds]
torques = [300.0, 150.0]
joint_rates = 2.0
{bounds}
[solver]
iterations = 30
delay = {delay}
"""
OTHERWISE = {
    "hanging": {"delay": 1, "bounds": "torque_rates = 20000.0", "blocks": "blocks = [1, 1, 1, 2]"},
    "slide": {"delay": 0, "bounds": "", "blocks": "blocks = [1, 1, 3]"},
}


def program(name: str, folder: Path, *flags: str, driver="false_samples") -> Path:
    """The closed loop of a robot, or another driver, compiled in a folder."""
    file, out = folder / "mpc.toml", folder / driver
    file.write_text(
        CONTROL.format(**({"delay": 1, "bounds": "", "blocks": "", "substeps": 2} | OTHERWISE.get(name, {})))
    )
    texts = project(model_of(ROBOTS[name] | {"name": "robot"}), file).files()
    sources = [name for name in unfolded(folder, texts) if name.startswith("robot_")]
    options = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function", "-DSAMPLE=0.02", "-I.", *flags)
    command = [require_tool("gcc"), *options, "-o", out, DRIVERS / f"{driver}.c", *sources, "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[:3000]
    return out


def main(*arguments: str) -> int:
    flags = ("-O1", *SANITIZERS) if "--sanitize" in arguments else ("-O2",)
    stride = "7" if "--sanitize" in arguments else "1"
    failed = 0
    for name in [a for a in arguments if a in ROBOTS] or ROBOTS:
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([program(name, Path(folder), *flags), stride], capture_output=True, text=True)
        print(f"{name}\n{done.stdout}{done.stderr}", flush=True)
        failed += done.returncode != 0
    return failed


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
