"""The report in words and tables."""

from __future__ import annotations

import numpy as np
from ella.document import Document

from .arms import ARMATURE, LIMIT
from .loop import RATE_GAIN
from .ocp import TOLERANCE, Form
from .plan import SHARE
from .task import BAND, BANDS, CONTROLLERS, LATE, Results, numbers
from .timing import MARKS

MM = [f"{1e3 * band:g} mm" for band in BANDS]
HEAD = ("controller", *MM)


def report(r: Results) -> Document:
    n, out = numbers(r), Document("ELLA under model-predictive control")
    against = n["headline"]["against"]
    mpc, pd = (seconds(n["settling"][name][BAND]) for name in ("mpc", against))
    out.text(
        f"**The tip is within {MM[BAND]} of its goal, for good, after {mpc} s under MPC and after {pd} s under PD:",
        f"{ratio(n['headline']['faster'])} times as fast**, at equal torque limits, with a payload 30 % heavier than",
        "the one that both were designed with, and with the same estimate of it.",
    )
    if r.bounds:
        hindsight, most = n["faster"]["hindsight"][BAND], n["settling"]["hindsight"][BAND] / n["lower_bounds"][BAND]
        out.text(
            f"Beside the best of {len(r.extent.grid)} PDs, chosen in hindsight on the plant itself, it is",
            f"{ratio(hindsight)} times as fast; {ratio(most)} times is what the torque limits allow any controller",
            "there.",
        )
    task_and_plant(out, n)
    settling(out, r, n)
    if r.bounds:
        lower_bound(out, r, n)
    horizon(out, r, n)
    latencies(out, n)
    late_samples(out, r, n)
    bounded(out, n)
    return out


def task_and_plant(out: Document, n: dict) -> None:
    out.heading("Task")
    out.text(
        "The arm of `examples/ella_paper.toml` moves from rest, straight and horizontal, to where its tip rests when",
        f"its joints are at the paper's set points. All controllers have the same torque limits, {listed(LIMIT)} N·m,",
        f"by saturation. Added to the file: rotor inertias of {listed(ARMATURE)} kg·m² at the joints, in plant and",
        "models, of the size that geared joints of such torques have; without any, no loop of 1 kHz can damp a joint.",
    )
    out.text(
        "**Plant**: generated C, three polynomial bending modes per plane and an axial mode in each link, modal",
        "midpoint at 1 ms, no modal damping, payload 2.73 kg. **Model** of the MPC: two polynomial bending modes per",
        "plane and link (one clamped-free mode would miss the frequencies by a tenth), payload 2.1 kg. **Measured**:",
        "joint angles and rates, and the deflections of the links at eight stations, from which modal coordinates",
        "follow by least squares. **Payload**: the torques that hold the arm before it moves tell the MPC, by least",
        f"squares, that {n['payload_found']:+.2f} kg are to be added to its model's.",
    )


def settling(out: Document, r: Results, n: dict) -> None:
    out.heading("Settling")
    bounds = [("*fastest possible motion*", *map(seconds, n["lower_bounds"]))] if r.bounds else []
    out.text("Time (s) after which the tip stays within a band **about the goal**; –: it does not.")
    ghost = [("*IPOPT in every sample, recorded*", *map(seconds, n["ghost"]["settling"]))]
    out.table(HEAD, rows(n["settling"], seconds) + ghost + bounds)
    out.text("How many times as fast the MPC is, about the goal, beside each PD:")
    out.table(HEAD, rows(n["faster"], ratio))
    out.figure(
        "settling.png", f"Settling time against band; dotted: {MM[BAND]}. A curve ends where a tip never settles."
    )
    out.text(
        f"The band of the headline is {MM[BAND]}: what a gripper can still catch, and about as far as the payload's",
        "error moves the tip of the resting arm by sag alone. Within 20 mm the tip arrives with the joints, and",
        "vibration hardly counts.",
    )
    knowledge(out, r, n)
    out.text(
        "**About what.** A task that grips at a given place asks when the tip is there: that is judged about the",
        "goal, as settling time is in control. How soon the arm stands still, wherever that is, as ISO 9283 judges",
        f"stabilisation about the attained pose, is judged about the tip's mean over the last {LATE:g} s. Time (s),",
        "and how many times as fast the MPC is:",
    )
    out.table(HEAD, rows(n["settling_about_own_rest"], seconds))
    out.table(HEAD, rows(n["faster_about_own_rest"], ratio))
    out.figure("closed_loop.png", f"The tip's distance from its goal (dotted: {MM[BAND]}); torques with their limits.")
    mm = lambda what, name: f"{1e3 * n[what][name]:.2f}"  # noqa: E731
    peaks = {name: listed(np.round(n["peak"][name])) for name in CONTROLLERS}
    table = [(CONTROLLERS[c], mm("offset", c), mm("residual", c), peaks[c]) for c in CONTROLLERS]
    out.table(("controller", "offset (mm)", "residual vibration (mm)", "torque peaks (N·m)"), table)
    out.text(
        f"**Offset**: the tip's mean over the last {LATE:g} s of the run ({r.extent.duration:g} s under MPC,",
        f"{r.extent.pd_duration:g} s under PD) from the goal. **Residual**: largest distance from that mean in that",
        "time.",
    )


def knowledge(out: Document, r: Results, n: dict) -> None:
    used = {c: described(n["gains"][c][BAND if c == "hindsight" else 0]) for c in ("told", "hindsight", "plan")}
    out.text(
        "**Who knows what.** *PD, as designed*: gravity compensation and set points for the payload of the file;",
        f"gains chosen on the arm of the file as those that settle first within {MM[BAND]}, out of",
        f"{len(r.extent.grid)} sets of frequency, damping and duration of a minimum-jerk reference; then run on the",
        f"plant as they are ({used['told']}). Its tip rests {1e3 * n['offset']['pd']:.1f} mm from the goal. *PD, told",
        "the payload*: the same choice of gains, but gravity compensation, set points and inertias for the payload",
        "that the MPC found, so that it rests at the goal. Both controllers then know the same; the headline is",
        "against this one. *Best gains in hindsight*: told, and for each band the set that does best on the plant",
        f"itself, which nobody can know beforehand ({used['hindsight']} for {MM[BAND]}). *PD along the MPC's plan*:",
        "told, with the MPC's plan as reference and its torques fed forward, which is what the plan gives without the",
        f"receding horizon; the best in hindsight of {len(r.extent.soft)} sets of gains ({used['plan']}).",
        f"Beside it the MPC is {ratio(n['faster']['plan'][BAND])} times as fast within {MM[BAND]} and",
        f"{ratio(n['faster']['plan'][-1])} times within {MM[-1]}: that is what the receding horizon adds.",
    )


def lower_bound(out: Document, r: Results, n: dict) -> None:
    least, hindsight, at = n["lower_bounds"], n["settling"]["hindsight"], n["settling"]["mpc"][BAND]
    most = ", ".join(f"{h / b:.2f} within {mm}" for h, b, mm in zip(hindsight, least, MM, strict=True) if h)
    out.text(
        "**What cannot be beaten**: the shortest time in which the torque limits let the model, its payload known,",
        f"enter the band for good (free end time; torque held over {r.extent.intervals} intervals; then {LATE:g} s",
        f"inside, until it rests). Into {MM[BAND]} that is {least[BAND]:.3f} s; the MPC takes {at / least[BAND]:.2f}",
        "times as long. Beside the PD with its best gains in hindsight, no controller at all could be faster by more",
        f"than: {most}.",
    )


def horizon(out: Document, r: Results, n: dict) -> None:
    form, count, ghost = Form(), n["qp_iterations"], n["ghost"]["solve_ms"]
    out.heading("Receding horizon")
    out.text(
        f"**Plan**, once, before the motion: the fastest from rest to rest within {100 * SHARE:g} % of the torque",
        f"limits, free end time, {r.extent.intervals} intervals, a small weight on steps of torque, which would",
        f"excite the modes from 80 Hz on: {r.plan.duration:.3f} s long, found in {r.plan.seconds:.0f} s of one core.",
    )
    out.text(
        f"**Sample**, every {1e3 * form.h:g} ms: the generated controller of `examples/mpc/mpc.toml`, one real-time",
        f"iteration on {form.N} intervals of as much, torques held and within their limits. Weighed are the distance",
        "of the tip, coordinates, rates and torques from the plan's; at the end the cost-to-go of the linear quadratic",
        "regulator at the goal. The controller predicts the state one interval ahead and acts from then on: the delay",
        f"is simulated. Between samples a rate loop at 1 kHz, {listed(RATE_GAIN)} N·m·s/rad, holds the joint rates to",
        "the predicted ones, and an observer runs the model beside the plant: sampled every 20 ms without it, the",
        "plant's undamped mode at 502 Hz looks like a motion at 1.7 Hz, and the controller follows that.",
    )
    out.text(
        f"{n['samples']} samples, {'all' if n['solved'] else 'NOT all'} solved; {count['median']:g} iterations of the",
        f"quadratic program in the median, {count['max']} at most. **Cold start**: the first plan comes from the",
        "straight posture at rest with the torques that hold it, not from the fastest motion. *MPC without a plan* has",
        "the goal alone as its reference, from the first sample on.",
    )
    out.text(
        "*IPOPT in every sample* is a recording (`mpc_ella.py --ghost`): the same loop with collocation at two Radau",
        f"points, converged to {TOLERANCE:g} in CasADi's virtual machine, {ghost['median']:.0f} ms of one core in the",
        f"median and {ghost['max']:.0f} ms at most.",
    )


def latencies(out: Document, n: dict) -> None:
    found = n["latency"]
    out.heading("Latency")
    out.text(
        f"{found['samples']['warm']:,} samples: those of the closed loop again and again, in C, `clock_gettime` around",
        "the calls; the references' copy counts as preparation. *Processor* is the thread's own time; *wall* also has",
        "what other work on the machine took. *Cold*: 8 MiB of other memory are walked through between samples. The",
        f"thread is {'bound to one core' if found['bound_to_a_core'] else 'not bound to a core'}. {found['machine']}.",
    )
    table = [
        (f"{phase}, {what}, {caches}", *(f"{found[f'{caches}_{what}'][phase][m]:.3f}" for m in MARKS))
        for caches in ("warm", "cold")
        for what in ("cpu", "wall")
        for phase in ("preparation", "feedback", "sum")
    ]
    table = [(row[0].replace("cpu", "processor"), *row[1:]) for row in table]
    out.table(("ms", *MARKS), table)
    out.figure("latency.png", "Left: median and range over all repetitions. Dotted: the time between two samples.")


def late_samples(out: Document, r: Results, n: dict) -> None:
    out.heading("When a sample is late")
    out.text(
        "A sample is late if its preparation is not done when the measurement comes. `feedback` is called all the",
        "same: it moves the plan on by an interval, returns the plan's torque for it, within the limits, and says",
        "`BAD_ARGUMENT`; the rate loop follows the states of that plan. A measurement that is not finite does the same",
        "with `NONFINITE`, a quadratic program at its limit of iterations with the outcome `LIMITED`. The next",
        "preparation that is in time goes on from there. Here preparations are dropped on purpose; settling (s):",
    )
    out.table(("late samples", *MM), [(name, *map(seconds, times)) for name, times in n["late"].items()])
    out.figure("late.png", f"Tip and torque where samples are late; dotted: {MM[BAND]}, and the torque's limits.")


def bounded(out: Document, n: dict) -> None:
    out.heading("A bounded joint wrench")
    w, free, inside = n["wrench"], n["wrench"]["plant"]["free"], n["wrench"]["plant"]["bounded"]
    out.text(
        f"No motor acts on the elbow's bending moment {w['component']}, so no torque limit bounds it.",
        "`examples/mpc/mpc_wrench.toml` has one line that does, a horizon of 0.24 s with blocks of torques, and the",
        f"goal alone as its reference. The plant shall keep to {w['bound']:g} N·m; since it has modes that the model",
        "has not, the file says less. In the plant, by `forward_dynamics` in C each ms: at most",
        f"**{inside:.1f} N·m, a margin of {w['margin']:.1f} N·m**; without that line {free:.1f} N·m. Settling (s):",
    )
    names = {"bounded": "bounded moment", "free": "the same without the bound"}
    out.table(("controller", *MM), [(name, *map(seconds, w["settling"][k])) for k, name in names.items()])
    out.figure("wrench.png", "The plant's moment in the two motions; dotted: the bound.")


def rows(table: dict, cell) -> list[tuple[str, ...]]:
    return [(CONTROLLERS[name], *map(cell, values)) for name, values in table.items()]


def listed(values) -> str:
    return ", ".join(f"{x:g}" for x in values)


def described(gains: dict) -> str:
    move = f", minimum jerk in {gains['move']:g} s" if gains["move"] else ""
    return f"{gains['frequency']:g} Hz, damping {gains['damping']:g}{move}"


def seconds(time: float | None) -> str:
    return "–" if time is None else f"{time:.3f}"


def ratio(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f}"
