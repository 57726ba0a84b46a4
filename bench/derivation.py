"""Processor seconds to derive, generate and compile, each in a process of its own so that nothing is derived yet.

python derivation.py sympy | screwgen ROBOT TARGET…     prints JSON
"""

from __future__ import annotations

import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import robots
from contenders import Missing, screwgen_library
from native import COMMON, BenchError, Compiler
from table import Row, spread

import screwgen

HEADING = "derivation and compilation, processor time; ratio: time / screwgen, or budget / time"
ROUNDS = 3
LONG = 64
BUDGETS = (
    ("screwgen, ella, all targets", ("ella", "c", "casadi", "latex"), 5.0),
    (f"screwgen, {LONG} equal links, C", (f"equal{LONG}", "c"), 15.0),
)
COMPILING = 10.0


def planar(modes: int = 2) -> screwgen.Robot:
    """Two links that move in the plane x, y, with two bending modes each."""
    section = {"rhoA": 1.6302, "EIz": 3.67e3}
    shapes = {"basis": "clamped_free", "bending_y": modes}
    base = {"length": 0.9, "section": section, "modes": shapes, "joint": {"axes": ["z"]}}
    links = [base | {"name": name} for name in ("upper", "lower")]
    planar_gravity = {"name": "planar", "gravity": [0.0, -9.81, 0.0], "links": links}
    return screwgen.Robot.model_validate(planar_gravity)


def rows(folder: Path, compiler: Compiler, progress) -> tuple[list[Row], list[str]]:
    """sympy against screwgen in turns, then what has a budget."""
    progress.stage("derivation: sympy and screwgen")
    pairs = [(seconds("screwgen", "planar", "c"), seconds("sympy")) for _ in range(ROUNDS)]
    own, other = [a for a, _ in pairs], [b for _, b in pairs]
    ratio = statistics.median(b / a for a, b in pairs)
    what = "planar 2 links, 2 modes"
    out = [
        Row(HEADING, f"screwgen, {what}, C", statistics.median(own), 1.0, spread(own)),
        Row(HEADING, "sympy.physics.mechanics, same arm", statistics.median(other), ratio, spread(other)),
    ]
    for title, words, budget in BUDGETS:
        progress.stage(f"derivation: {title}")
        times = [seconds("screwgen", *words) for _ in range(ROUNDS)]
        middle = statistics.median(times)
        out.append(Row(HEADING, title, middle, budget / middle, spread(times), (1.0, None)))
    progress.stage("derivation: compiling fused code")
    for robot in (robots.example("ella"), robots.example("six_link"), longest_fused()):
        t = compile_time(robot, folder, compiler)
        out.append(Row(HEADING, f"cc -O2, fused {robot.name}", t, COMPILING / t, target=(1.0, None)))
    return out, []


def longest_fused() -> screwgen.Robot:
    """The longest chain of up to 16 equal links that is written in one piece."""
    for n in reversed(range(1, 17)):
        try:
            robot = robots.equal_chain(f"equal{n}", n)
            screwgen_library(screwgen.derive(robot), "fused", "runtime", robot.name)
            return robot
        except Missing:
            continue
    raise BenchError("no chain is written in one piece")


def seconds(*words: str) -> float:
    """Processor seconds that a process of its own reports."""
    command = [sys.executable, str(Path(__file__).resolve()), *words]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise BenchError(f"derivation of {' '.join(words)} failed: {done.stderr.strip().splitlines()[-1:]}")
    return json.loads(done.stdout)


def compile_time(robot, folder: Path, compiler: Compiler) -> float:
    """Processor seconds of the compiler at -O2 for the fused dynamics."""
    library = screwgen_library(screwgen.derive(robot), "fused", "runtime", robot.name)
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in library.files.items():
        (folder / name).write_text(text)
    before = _children()
    source = f"{robot.name}_dynamics.c"
    subprocess.run([compiler.name, *COMMON, "-O2", "-c", source, "-o", f"{source}.o"], cwd=folder, check=True)
    return _children() - before


def _children() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


# ---------------------------------------------------------------------------- in a process of its own


def generate(robot: screwgen.Robot, targets: list[str]) -> float:
    """Derive and write the targets."""
    clock = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        screwgen.derive(robot).write(Path(folder) / "out", targets)
    return time.process_time() - clock


def named(name: str) -> screwgen.Robot:
    if name.startswith("equal"):
        return robots.equal_chain(name, int(name.removeprefix("equal")))
    return planar() if name == "planar" else robots.example(name)


def sympy_equations(robot: screwgen.Robot):
    """Lagrange's equations of a planar arm by sympy.physics.mechanics: the method, torques τ_i as symbols."""
    import sympy as sp
    from lagrangian import integrals
    from sympy.physics.mechanics import LagrangesMethod, ReferenceFrame, dynamicsymbols

    t, g, n = dynamicsymbols._t, robot.gravity[1], len(robot.links)
    theta, tau = dynamicsymbols(f"theta:{n}"), sp.symbols(f"tau:{n}")
    etas = [sp.Matrix(dynamicsymbols(f"eta{i}_:{link.modes.bending_y}")) for i, link in enumerate(robot.links)]
    inertial, loads, L = ReferenceFrame("N"), [], sp.Integer(0)
    angle, place = sp.Integer(0), sp.zeros(2, 1)

    def torque(value) -> None:
        frame = ReferenceFrame(f"A{len(loads)}")
        frame.set_ang_vel(inertial, angle.diff(t) * inertial.z)
        loads.append((frame, value * inertial.z))

    for i, (link, eta) in enumerate(zip(robot.links, etas, strict=True)):
        if i:
            torque(-tau[i])
        x, angle = integrals(link), angle + theta[i]
        torque(tau[i])
        R = sp.Matrix([[sp.cos(angle), -sp.sin(angle)], [sp.sin(angle), sp.cos(angle)]])
        S, X, G = sp.Matrix([x.S[1]]), sp.Matrix([x.X[0, 1]]), sp.Matrix(x.G[1, 1])
        rate, w, velocity = eta.diff(t), angle.diff(t), place.diff(t)
        first = sp.Matrix([x.first[0], (S * eta)[0]])
        flow = sp.Matrix([-w * first[1], w * first[0] + (S * rate)[0]])
        L += x.m * velocity.dot(velocity) / 2 + velocity.dot(R * flow) + (rate.T * G * rate)[0] / 2
        L += (x.second[0, 0] + (eta.T * G * eta)[0]) * w**2 / 2 + w * (X * rate)[0]
        L -= sum(k * e**2 for k, e in zip(x.K, eta, strict=True)) / 2 - g * (x.m * place + R * first)[1]
        place += R * sp.Matrix([link.length, (sp.Matrix([x.tip[1]]) * eta)[0]])
        angle += (sp.Matrix([x.slope[2]]) * eta)[0]
    coordinates = [*theta, *(e for eta in etas for e in eta)]
    method = LagrangesMethod(L, coordinates, forcelist=loads, frame=inertial)
    method.form_lagranges_equations()
    return method, tau


def main() -> None:
    kind, *words = sys.argv[1:]
    if kind == "screwgen":
        print(json.dumps(generate(named(words[0]), words[1:])))
        return
    import sympy.physics.mechanics  # noqa: F401  (its import is not the derivation's)

    robot, clock = planar(), time.process_time()
    method, _ = sympy_equations(robot)
    _ = method.mass_matrix, method.forcing
    print(json.dumps(time.process_time() - clock))


if __name__ == "__main__":
    main()
