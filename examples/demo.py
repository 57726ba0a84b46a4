"""ELLA, the paper's arm with modes that converge, from robot file to motion: derive, generate, compile, step, plot.

Writes build/ella, build/ella.png and build/ella.html, in which the motion plays, and prints a short summary. The motion
goes to the paper's set points under PD torques with gravity compensation; the gains are ours, the paper gives none.
"""

import re
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import numpy as np

import screwgen
from screwgen.plotting import plot
from screwgen.runtime.stepper import CompiledStepper
from screwgen.simulation.controllers import PD
from screwgen.simulation.simulate import simulate

ROOT = Path(__file__).resolve().parents[1]
FOLDER = ROOT / "build" / "ella"
SET_POINTS = (-0.4928, 0.6922, 0.4270)
LAW = PD((400.0, 400.0, 120.0), (28.0, 28.0, 12.0), SET_POINTS, duration=1.7, q_start=(0.0,) * 3)
PLOT, PAGE = ROOT / "build" / "ella.png", ROOT / "build" / "ella.html"
DURATION, STEP = 2.0, 1e-3
ROTORS = ((0.2, 0.2), (0.1,))
"""kg·m²: of the motors, seen at the joints. The paper states none; but without any a joint would feel the masses alone
that are stiffly tied to it, a few grams, which no loop of 1 kHz can damp."""


def main() -> None:
    print("ELLA: two flexible links, universal base joint, elbow motor 3.3 kg, payload 2.1 kg")
    stated = ", ".join(f"{x:g}" for rotors in ROTORS for x in rotors)
    print(f"rotors in its joints    {stated} kg·m², which ella.toml does not state: a loop of 1 kHz needs some")
    clock = time.perf_counter()
    model = screwgen.derive(with_rotors(screwgen.load(ROOT / "examples" / "ella.toml")))
    files = model.write(FOLDER)
    print(f"derived and generated   {time.perf_counter() - clock:6.2f} s  {len(files)} files in {short(FOLDER)}")
    clock = time.perf_counter()
    checks = make(FOLDER / "c")
    print(f"compiled and checked    {time.perf_counter() - clock:6.2f} s  {checks}")
    compiled = model.compile()
    clock = time.perf_counter()
    rest = screwgen.equilibrium(model, [0.0, 0.0, 0.0], hold=True)
    law, form = controller(model), partial(CompiledStepper, compiled)
    run = simulate(model, DURATION, STEP, q0=rest.q, controller=law, form=form, integrator="modal_midpoint")
    print(f"stepped {DURATION:g} s of motion    {time.perf_counter() - clock:6.2f} s  controller in Python, arm in C")
    summary(model, compiled, run)
    plot.save(run, PLOT, model, LAW)
    print(f"plot                    {short(PLOT)}")
    screwgen.view(run, labels=["PD to the paper's set points"]).save(PAGE)
    print(f"to be played            {short(PAGE)}, in any browser")


def with_rotors(robot: screwgen.Robot) -> screwgen.Robot:
    """The robot with motors of `ROTORS` in its joints."""
    joints = [link.joint.model_copy(update={"armature": a}) for link, a in zip(robot.links, ROTORS, strict=True)]
    links = [link.model_copy(update={"joint": joint}) for link, joint in zip(robot.links, joints, strict=True)]
    return robot.model_copy(update={"links": tuple(links)})


def short(path: Path) -> str:
    return str(path.relative_to(ROOT))


def make(folder: Path) -> str:
    """Build and check the generated C as its README says, in a copy: the folder stays as generated.

    Nothing is optimised here, since that takes six times as long; what makes the steps is compiled apart.
    """
    build = folder.parent.parent / "ella-c"
    subprocess.run(["rm", "-rf", build], check=True)
    subprocess.run(["cp", "-r", folder, build], check=True)
    done = subprocess.run(["make", "-s", "-j", "CFLAGS=-O0", "check"], cwd=build, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"the generated C does not pass its self-check:\n{done.stdout}{done.stderr}")
    deviations = re.findall(r"deviation (\S+)", done.stdout)
    return f"self-check: deviation {deviations[0]} in double, {deviations[1]} in float"


def controller(model):
    """PD about a minimum-jerk path of 1.7 s, plus the torque that holds the arm in its posture."""
    bias, p = model.casadi()["bias"], model.parameter_values
    rest, free = np.zeros(model.nq), np.zeros((6, model.n_links))

    def torque(t, q, v):
        return LAW(t, q, v) + np.array(bias(q, rest, free, p))[:3, 0]

    return torque


def summary(model, compiled, run) -> None:
    header = (FOLDER / "c" / "ella.h").read_text()
    operations = re.search(r"tip pose: (\d+) operations", header)[1]
    scratch = re.search(r"ella_work (\d+) bytes", header)[1]
    mechanical = run.energy.sum(axis=1)
    power = np.sum(run.tau[:-1] * np.diff(run.q[:, :3], axis=0), axis=1)
    balance = mechanical - mechanical[0] - np.concatenate([[0.0], np.cumsum(power)])
    worst = np.linalg.norm(run.wrench[:, :, 3:], axis=2)
    torque = np.linalg.norm(run.wrench[:, :, :3], axis=2)
    link = model.robot.links[int(np.argmax(worst.max(axis=0)))].name
    error = np.abs(run.q[-1, :3] - SET_POINTS).max()
    print(
        f"model                   {model.nq} coordinates, {len(model.parameter_values)} parameters, "
        f"{operations} operations per forward dynamics, scratch {scratch} bytes"
    )
    print(
        f"time in C               {timing(compiled, run):6.2f} µs per step of 1 ms "
        "(modal midpoint rule: two forward dynamics)"
    )
    print(f"set points              reached within {error * 1e3:.2f} mrad after {DURATION:g} s")
    print(
        f"energy                  largest kinetic {run.energy[:, 0].max():.2f} J, motors' work {power.sum():+.2f} J; "
        f"balance open by at most {np.abs(balance).max() * 1e3:.1f} mJ"
    )
    print("                        (what the time step of 1 ms leaves; the torque is held over it)")
    print(f"largest joint wrench    {worst.max():.1f} N at the joint of {link}, torque {torque.max():.1f} N·m")


def timing(compiled, run) -> float:
    """Microseconds per step, the best of several batches from the middle of the motion."""
    k = len(run.t) // 2
    best = np.inf
    for _ in range(20):
        clock = time.perf_counter()
        compiled.step(run.q[k], run.v[k], run.tau[k], np.zeros((2, 6)), STEP, "modal_midpoint", count=200)
        best = min(best, (time.perf_counter() - clock) / 200)
    return best * 1e6


if __name__ == "__main__":
    main()
