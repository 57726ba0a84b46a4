"""Nonlinear model predictive control in real time with acados: ELLA, and the published arm with two flexible links.

The published arm runs on the generated C of `model.mpc` as well, in the same loop.

    make acados                                  # once: acados from PyPI into build/acados
    python examples/nmpc_acados.py               # both tasks, some minutes; figures and numbers in build/nmpc_acados
    python examples/nmpc_acados.py --short       # less of both, without figures

Times are of one thread's processor time, so that other work on the machine does not count.
"""

import argparse
import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from ella_paper import Stage, shown
from mpc.arms import LIMIT as ELLA_LIMIT
from mpc.arms import Arms
from mpc.loop import Controller
from mpc.ocp import Form
from mpc.task import BANDS, settling
from with_acados import arm, generated, show
from with_acados.ella import RealTime
from with_acados.install import Missing, acados_template

FOLDER = Path(__file__).resolve().parents[1] / "build" / "nmpc_acados"
OFF = 0.02
"""rad: how far off the plan the states are from which acados and IPOPT are compared."""


def main() -> int:
    parser = argparse.ArgumentParser(prog="nmpc_acados.py", description=__doc__.splitlines()[0])
    parser.add_argument("task", nargs="?", choices=("both", "ella", "flexible_arm"), default="both")
    parser.add_argument("--short", action="store_true", help="less of both, without figures")
    parser.add_argument("-o", "--output", type=Path, default=FOLDER, help="folder (default: build/nmpc_acados)")
    given, stage = parser.parse_args(), Stage()
    try:
        acados_template()
        results = {}
        for name, task, picture in (("ella", ella, "ella.png"), ("flexible_arm", flexible_arm, "flexible_arm.png")):
            if given.task in ("both", name):
                results[name], draw = task(given.short, stage)
                given.output.mkdir(parents=True, exist_ok=True)
                if not given.short:
                    (given.output / picture).write_bytes(draw())
        (given.output / "results.json").write_text(json.dumps(results, indent=1) + "\n")
    except (Missing, OSError, RuntimeError) as error:
        stage.clear()
        print(f"nmpc_acados: error: {error}", file=sys.stderr)
        return 1
    stage.clear()
    for name, numbers in results.items():
        summary(name, numbers)
    print(f"results         {shown(given.output)}")
    missed = [claim for name, numbers in results.items() for claim in shortfalls(name, numbers)]
    for claim in missed:
        print(f"nmpc_acados: does not hold: {claim}", file=sys.stderr)
    return 1 if missed else 0


def times(parts: dict[str, np.ndarray]) -> dict[str, dict[str, float]]:
    """ms: of the samples of a closed loop, and their sum."""
    parts = parts | {"sample": sum(parts.values())}
    marks = {"median": 50, "p99": 99, "p99.9": 99.9, "max": 100}
    return {
        name: {"mean": float(1e3 * np.mean(t))} | {k: float(1e3 * np.percentile(t, q)) for k, q in marks.items()}
        for name, t in parts.items()
    }


def ella(short: bool, stage: Callable[[str], None]) -> tuple[dict, Callable[[], bytes]]:
    """The task of `make mpc`; numbers, and what draws them."""
    stage("ELLA: derive the arm, compile the plant")
    arms = Arms()
    arms.compiled.prepare(arms.p)
    stage("ELLA: the fastest motion as plan, then code of acados")
    mpc = RealTime(arms, Form(), 36)
    tick = lambda t: stage(f"ELLA: closed loop, {t:.1f} s")  # noqa: E731
    motion, solutions = mpc.run(1.0 if short else 2.4, tick)
    stage("ELLA: beside IPOPT")
    off = differences(mpc, (0.0, 0.3))
    cold = from_rest(mpc)
    timed = solutions[1:]
    parts = ("references", "preparation", "feedback")
    numbers = {
        "samples": len(timed),
        "solved": all(s.converged for s in solutions),
        "times_ms": times({name: np.array([getattr(s, name) for s in timed]) for name in parts}),
        "bands_m": BANDS,
        "settling_s": [settling(motion, arms.goal, band) for band in BANDS],
        "peak_over_limit": float((np.abs(motion.tau) / ELLA_LIMIT).max()),
        "torque_beside_ipopt": off,
        "cold_start": cold,
    }
    return numbers, lambda: show.ella(motion, arms.goal, timed)


def differences(mpc: RealTime, at) -> float:
    """Of converged torques, acados beside IPOPT, over the limits: the largest at states `OFF` the plan."""
    judge, largest = Controller.stated(mpc, mpc.form), 0.0
    for t in at:
        x = mpc.plan.states(t)
        x[:3] += OFF
        mpc.begun = False
        ours, theirs = mpc.solve(mpc.problem, x, t), Controller.solve(mpc, judge, x, t)
        if not (ours.converged and theirs.converged):
            return float("inf")
        largest = max(largest, float((np.abs(ours.u - theirs.u) / ELLA_LIMIT).max()))
    return largest


def from_rest(mpc: RealTime) -> float:
    """A cold start from the straight posture, with no plan as guess: the last change of torque over its limit."""
    (x, u), form, h = mpc.ends[0], mpc.problem.problem, mpc.form.h
    t = h * np.arange(form.N + 1)
    states, torques = mpc.plan.states(t), mpc.plan.torques(t[:-1], h)
    mpc.problem.refer(np.hstack([states[:-1], torques]), states[-1])
    mpc.problem.guess(np.tile(x, (form.N + 1, 1)), np.tile(u, (form.N, 1)))
    return mpc.problem.settle(x, 10)


def flexible_arm(short: bool, stage: Callable[[str], None]) -> tuple[dict, Callable[[], bytes]]:
    """The published task; numbers, and what draws them."""
    stage("flexible arm: derive it, code of acados")
    task = arm.Task(modes=2) if short else arm.Task()
    solver, place = arm.begun(task), task.reference()[1][-3:]
    stage("flexible arm: closed loop on its own model")
    own = arm.closed_loop(task, solver, arm.SamePlant(task), 1.2 if short else 1.5)
    runs = [own]
    if not short:
        stage("flexible arm: closed loop on a richer plant")
        runs.append(arm.closed_loop(task, arm.begun(task), arm.RicherPlant(task), 1.5))
    stage("flexible arm: beside IPOPT")
    judged = arm.judged(task, own, 150 if short else 20)
    numbers = {"states": task.problem.export.x.numel(), "N": task.N}
    numbers |= figures(task, runs, place) | {"beside_ipopt": judged}
    patterns = [generated.CHOSEN] if short else list(generated.PATTERNS)
    numbers["generated"] = {name: in_c(task, name, short, stage) for name in patterns}
    return numbers, lambda: show.arm(*runs, place)


def figures(task: arm.Task, runs: list[arm.Run], place) -> dict:
    """Of closed loops on the model itself and, where it was run, on the richer plant."""
    rates = slice(task.model.nq, task.model.nq + 3)
    joined = lambda part: np.concatenate([getattr(run, part) for run in runs])  # noqa: E731
    return {
        "samples": len(joined("u")),
        "solved": all(run.failed == 0 for run in runs),
        "times_ms": times({part: joined(part) for part in ("preparation", "feedback")}),
        "iterations": float(joined("iterations").mean()),
        "bands_m": [0.01, 0.005],
        "settling_s": [arm.settled(runs[-1], place, band) for band in (0.01, 0.005)],
        "peak_over_limit": float((np.abs(joined("u")) / arm.LIMIT).max()),
        "rate_over_bound": [float((np.abs(run.x[:, rates]) / arm.FASTEST).max()) for run in runs],
    }


def in_c(task: arm.Task, pattern: str, short: bool, stage: Callable[[str], None]) -> dict:
    """The same loops with the generated C, its torques constant over blocks."""
    stage(f"flexible arm: generated C with {pattern} blocks")
    place, chosen = task.reference()[1][-3:], pattern == generated.CHOSEN
    own = generated.closed_loop(task, generated.controller(task, pattern), arm.SamePlant(task), 1.2 if short else 1.5)
    runs = [own]
    if chosen and not short:
        richer = arm.RicherPlant(task)
        runs.append(generated.closed_loop(task, generated.controller(task, pattern), richer, 1.5))
    stage(f"flexible arm: generated C with {pattern} blocks beside IPOPT")
    judged = arm.judged(task, own, 150 if short else 20 if chosen else 60)
    return figures(task, runs, place) | {"beside_ipopt": judged}


def summary(name: str, n: dict) -> None:
    print(name)
    for part, t in n["times_ms"].items():
        print(f"  {part:12}  " + ", ".join(f"{k} {v:.2f}" for k, v in t.items()) + " ms")
    bands = zip(n["bands_m"], n["settling_s"], strict=True)
    print("  settled       " + ", ".join(f"{1e3 * b:g} mm: {'–' if t is None else f'{t:.3f} s'}" for b, t in bands))
    if name == "ella":
        print(f"  converged     torques {n['torque_beside_ipopt']:.1e} of their limits beside IPOPT")
        print(f"  cold start    changes {n['cold_start']:.1e} in the last of ten iterations")
    else:
        off = n["beside_ipopt"]
        print(f"  one iteration torques within {max(off['torque']):.4f} of their limits beside converged IPOPT,")
        print(f"                {np.median(off['torque']):.4f} in the median; predicted tips within", end=" ")
        print(f"{1e3 * max(off['tip']):.1f} mm")
        plants = zip(n["rate_over_bound"], ("the model itself", "a richer plant"), strict=False)
        print("  joint rates   of their bounds: " + ", ".join(f"{rate:.2f} on {plant}" for rate, plant in plants))
    for pattern, inner in n.get("generated", {}).items():
        summary(f"{name}, generated C with {pattern} blocks", inner)


def shortfalls(name: str, n: dict) -> list[str]:
    """What these figures do not bear out; times depend on the machine and are no claim of the short form."""
    claims = {
        "every QP is solved": n["solved"],
        "the tip settles within 10 mm": n["settling_s"][0 if name != "ella" else 1] is not None,
        "torques keep to their limits": n["peak_over_limit"] <= 1 + 1e-6,
    }
    if name == "ella":
        claims["the tip settles within 5 mm in 0.61 s, as with IPOPT"] = (n["settling_s"][2] or 9.0) <= 0.61
        claims["converged torques are IPOPT's to 1e-3 of the limits"] = n["torque_beside_ipopt"] <= 1e-3
        claims["a cold start converges"] = n["cold_start"] <= 1e-6
    else:
        off = n["beside_ipopt"]
        claims["IPOPT converges"] = all(off["converged"])
        claims["torques are within a tenth of their limits of IPOPT's"] = max(off["torque"]) <= 0.1
        claims["joint rates keep to their bounds on the own model, but for a tenth"] = n["rate_over_bound"][0] <= 1.1
    missed = [f"{name}: {claim}" for claim, holds in claims.items() if not holds]
    inner = n.get("generated", {}).items()
    return missed + [m for pattern, found in inner for m in shortfalls(f"{name}, {pattern} blocks in C", found)]


if __name__ == "__main__":
    sys.exit(main())
