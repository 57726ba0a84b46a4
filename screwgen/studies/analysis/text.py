"""The report of an analysis for a terminal, the most important results first."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from textwrap import fill
from typing import TYPE_CHECKING

import numpy as np

from ...simulation.collocated import LeftOut
from ...simulation.integrate import DEFAULT
from ...simulation.linearised import TOLERANCE
from ...simulation.stable_steps import shown_time
from ...simulation.validity import Validity
from ...spec.segments import owner
from .step_limits import StepLimit

if TYPE_CHECKING:
    from .findings import Findings, StateAnalysis
    from .spectrum import LinearMotion

WIDTH = 96
MOST_MOTIONS, MOST_FAULTS = 24, 6
SHOWN = 3
"""Of how many states the whole spectrum is shown; the rest is in the JSON."""
RESTLESS = 1e-6
"""Accelerations up to this, SI, count as none."""


def report(a: Findings) -> str:
    """The whole report."""
    parts = [
        _wrapped(_stability(a)),
        _verdict(a),
        _systems(a),
        _loops(a),
        _blocks(a),
        _structure(a),
        *_spectra(a),
        _limits(a),
        *_validity(a),
    ]
    return "\n\n".join(part for part in parts if part)


def _stability(a: Findings) -> str:
    """Whether what is near the states stays there, as motion and in steps of the default method, and the reason."""
    found = _named(a) if a.well_posed else []
    if not found:
        return ""
    loop = "controller's loop closed" if a.closed_loop else "torques held"
    pairs = [(m, s) for s in found for m in s.motions if m.kind in ("grows", "falls")]
    if pairs:
        m, s = max(pairs, key=lambda pair: pair[0].eigenvalue.real)
        return f"UNSTABLE ({loop}): {_where(s)} {m.coordinate} {GROWS[m.kind]}, {_motion_rate(m)}"
    late = [(x.limit or 0.0, s) for s in found for x in s.limits if x.method == DEFAULT and not x.borne]
    if late:
        limit, s = min(late, key=lambda pair: pair[0])
        most = f"bears {shown_time(limit)}" if limit else "bears no step"
        text = f"UNSTABLE in steps of {shown_time(a.step)} ({loop}): {_where(s)} {DEFAULT} {most}"
        return f"{text}; the motion itself is stable"
    loose = dict.fromkeys(m.coordinate for s in found for m in s.motions if m.kind == "free")
    but = f"; {_count(len(loose), 'coordinate')} free" if loose else ""
    where = _where(found[0]) if len(found) == 1 else f"at {len(found)} states"
    steps = f"; {DEFAULT} bears {shown_time(a.step)}" if any(s.limits for s in found) else ""
    return f"STABLE ({loop}): {where} no motion grows{steps}{but}"


def _where(s: StateAnalysis) -> str:
    moves = s.acceleration is not None and s.acceleration > RESTLESS
    return f"at '{s.label}'{', no equilibrium,' if moves else ''}"


def _motion_rate(m: LinearMotion) -> str:
    rate = f"{m.eigenvalue.real:+.3g}/s"
    return rate if m.kind == "falls" else f"{rate} at {m.frequency_hz:.4g} Hz"


def _named(a: Findings) -> list[StateAnalysis]:
    """The states with a spectrum that were given, or the samples where there are no others."""
    known = [s for s in a.states if s.motions]
    return [s for s in known if not s.label.startswith("sample ")] or known


def _verdict(a: Findings) -> str:
    states = _count(len(a.states), "state")
    links, coordinates = _count(len(set(map(owner, a.links))), "link"), _count(a.coordinates, "coordinate")
    head = f"{a.robot}: {links}, {coordinates}; {states}"
    bad = [s for s in a.states if not s.well_posed]
    if not bad:
        size, worst = a.structure.size, max(s.system.condition_scaled for s in a.states if s.system)
        rank = f"M_sys has full rank, {size}, in {'the only state' if len(a.states) == 1 else f'all {states}'}"
        text = f"WELL POSED: {rank}; condition {worst:.1e} at worst, equilibrated. {_definiteness(a)}"
        return f"{head}\n\n{_wrapped(text)}"
    lines = [_wrapped(f"- {s.label}: {s.singular}", "  ") for s in bad[:MOST_FAULTS]]
    lines += [f"  - and {len(bad) - MOST_FAULTS} more"] * (len(bad) > MOST_FAULTS)
    text = f"NOT WELL POSED: in {len(bad)} of {states} accelerations and wrenches are not unique:"
    return "\n".join([head, "", text, *lines])


def _definiteness(a: Findings) -> str:
    if all(block.definite for state in a.states for block in state.blocks):
        return "The differential-modal block (Msys_diff) is positive definite in each."
    return "Yet the differential-modal block (Msys_diff) is only semidefinite, see below."


# ------------------------------------------------------------------------------ the system


def _systems(a: Findings) -> str:
    head = ("state", "rank", "cond", "min σ", "cond eq.", "min σ eq.", "zero σ, P alone", "max |dv/dt|")
    rows = [(s.label, *_system(s)) for s in a.states]
    notes = "cond, min σ: in SI; eq.: rows and columns equilibrated, since SI mixes units."
    missing = {s.projectors.size - s.projectors.rank for s in a.states if s.projectors and s.well_posed}
    if missing == {a.axes}:
        notes += (
            f" With the paper's projectors P alone, without the motors' rows, M_sys has {a.axes} zero singular"
            f" {'value' if a.axes == 1 else 'values'}, one per joint axis (E17)."
        )
    return "\n".join(["The assembled system M_sys", *_table(head, rows), _wrapped(notes)])


def _system(s: StateAnalysis) -> tuple[str, ...]:
    if s.system is None or s.projectors is None:
        return ("-",) * 7
    r = s.system
    numbers = [f"{x:.1e}" for x in (r.condition, r.smallest, r.condition_scaled, r.smallest_scaled)]
    acceleration = "-" if s.acceleration is None else f"{s.acceleration:.1e}"
    return (f"{r.rank}/{r.size}", *numbers, str(s.projectors.size - s.projectors.rank), acceleration)


def _loops(a: Findings) -> str:
    """Of robots with loops their rows, and what the numbers above and below are those of."""
    found = [s.loops for s in a.states if s.loops]
    if not found:
        return ""
    worst, rows, all_ = max(x.condition_scaled for x in found), found[0].size, len(found)
    bad, most = sum(not x.regular for x in found), max(x.rank for x in found)
    rank = f"depend on each other in {bad} of {_count(all_, 'state')}" if bad else "are independent in all"
    rank += f"; condition of J M⁻¹ Jᵀ {worst:.1e} at worst, equilibrated"
    if any(s.loops and not s.loops.regular and s.well_posed for s in a.states):
        rank = f"have rank {most} and share what they bear"
    left = a.coordinates - most
    text = (
        f"Loops: their {_count(rows, 'row')} {rank}."
        f" {_count(left, 'coordinate')} of {a.coordinates} {'moves' if left == 1 else 'move'} independently: the"
        " spectrum is theirs. M_sys and its blocks are those of the open tree. Steps must bear the loops'"
        " stabilisation, which no method takes implicitly."
    )
    return _wrapped(text)


def _blocks(a: Findings) -> str:
    head = ("link", "min λ", "max λ", "min λ eq.", "asymmetry", "rank M*", "verdict")
    rows: list = []
    nulls: dict = {}
    for link in dict.fromkeys(map(owner, a.links)):
        found = [block for s in a.states for block in s.blocks if owner(block.link) == link]
        if found:
            worst = min(found, key=lambda b: b.smallest_scaled)
            definite = all(b.definite for b in found)
            nulls |= {b.null: None for b in found if b.null}
            least, most = min(b.smallest for b in found), max(b.largest for b in found)
            values = [_number(x) for x in (least, most, worst.smallest_scaled, max(b.asymmetry for b in found))]
            rows.append((link, *values, str(worst.rank_M_star), "definite" if definite else "ONLY SEMIDEFINITE"))
    if not rows:
        return ""
    lines = ["The differential-modal block (Msys_diff), link by link, worst of the states", *_table(head, rows)]
    lines += [_wrapped(f"- {null}", "  ") for null in nulls]
    if any(row[5] != "6" for row in rows):
        lines.append(_wrapped("M* of a bare straight centreline has rank 5, not 6 (E29): no inertia about its axis."))
    return "\n".join(lines)


def _structure(a: Findings) -> str:
    s, modes = a.structure, a.structure.size - 12 * len(a.links)
    border = f"; bordered by {_count(modes, 'modal row')} and {_count(modes, 'column')}" if modes else ""
    text = (
        f"Structure: {s.nonzeros} of {s.size} x {s.size} entries are structurally nonzero ({100 * s.fill:.1f} %);"
        f" wrench and twist rows are block tridiagonal: {_count(s.block_bandwidth, 'block')} of six from the diagonal,"
        f" {_count(s.bandwidth, 'entry', 'entries')}{border}."
    )
    return _wrapped(text)


def _validity(a: Findings) -> list[str]:
    """The limits of the model at the states that are named."""
    shown = [s for s in a.states if s.measures and not s.label.startswith("sample ")][:SHOWN]
    return [limits_of_model(f"state '{s.label}'", Validity(a.links, np.array(s.measures)), s.left_out) for s in shown]


def limits_of_model(what: str, v: Validity, rods: Sequence[LeftOut] = ()) -> str:
    """The table of a state or a run, the measures past their bounds, and what points of exact rods leave out."""
    notes = [_wrapped(f"- {f.text()}; {f.remedy()}", "  ") for f in v.findings]
    if rods:
        errors = ", ".join(f"{x.link} {x.error:.1g} ({x.section}, {_count(x.points, 'point')})" for x in rods)
        notes.append(_wrapped(f"Error of the sections of exact links by their points, over the length: {errors}"))
        notes += [_wrapped(f"- {x.text()}", "  ") for x in rods if x.past]
    return "\n".join([f"Limits of the model, {what}; * is past its bound", v.table(), *notes])


# ------------------------------------------------------------------------------ the spectrum


def _spectra(a: Findings) -> list[str]:
    shown = _named(a)[:SHOWN]
    parts = [_spectrum(s, a.closed_loop) for s in shown]
    rest = [s for s in a.states if s.motions and s not in shown]
    if rest:
        fastest = [max(m.frequency_hz for m in s.motions) for s in rest]
        slowest = [min((m.frequency_hz for m in s.motions if m.frequency_hz), default=0.0) for s in rest]
        text = f"Spectrum of {_count(len(rest), 'more state')}: oscillations from {min(slowest):.4g} Hz to"
        parts.append(_wrapped(f"{text} {max(fastest):.4g} Hz; all are in the JSON."))
    return parts


def _spectrum(s: StateAnalysis, closed_loop: bool) -> str:
    loop = ", the controller's loop closed" if closed_loop else ", torques held"
    rows = [_motion(m) for m in s.motions[:MOST_MOTIONS]]
    lines = [f"Spectrum at '{s.label}'{loop}", *_table(("motion", "Hz", "damping", "1/s", "mostly"), rows)]
    if len(s.motions) > MOST_MOTIONS:
        lines.append(f"  … and {len(s.motions) - MOST_MOTIONS} faster ones, to {s.motions[-1].frequency_hz:.5g} Hz")
    if s.acceleration is not None and s.acceleration > RESTLESS:
        note = "The state is no equilibrium: these are frozen coefficients, valid while the motion stays near it."
        lines.append(_wrapped(note))
    return "\n".join(lines)


GROWS = {"grows": "swings ever wider", "falls": "falls away"}
KINDS = {
    "oscillates": "oscillation",
    "grows": "growing oscillation",
    "falls": "falls away",
    "decays": "decays",
    "free": "free, nothing drives it back",
}


def _motion(m: LinearMotion) -> tuple[str, ...]:
    name = KINDS[m.kind]
    if m.kind in ("oscillates", "grows"):
        damping = 0.0 if abs(m.damping) < 1e-9 else m.damping
        return (name, f"{m.frequency_hz:.5g}", f"{damping:.4f}", "", m.coordinate)
    return (name, "", "", "" if m.kind == "free" else f"{m.eigenvalue.real:+.4g}", m.coordinate)


# ------------------------------------------------------------------------------ the step


def _limits(a: Findings) -> str:
    found = [s for s in a.states if s.limits]
    if not found:
        return ""
    head = ("integrator", "largest step", "in state", f"growth rate at {a.step:g} s", "in state", f"{a.step:g} s is")
    rows = [_limit(k, found) for k in range(len(found[0].limits))]
    own = max((m.eigenvalue.real for s in found for m in s.motions), default=0.0)
    loop = "Torques are those of the step's start, held." if a.closed_loop else "Torques are held."
    rule = (
        f"Largest step: up to it no oscillation grows, by no more than {TOLERANCE:g} of its amplitude a radian, and"
        f" twice its own growth where it has any; each method's amplification matrix about the state, held there by"
        f" constant forces. Where joints turn, oscillations that last longer than a turn by a radian are left out: the"
        f" state does not stay frozen that long. {loop} Growth rate: log of the spectral radius over the step, 1/s,"
        f" frozen coefficients; the motion itself has up to {_number(max(own, 0.0))}/s."
    )
    lines = ["Steps that the integrators bear, worst of the states", *_table(head, rows), _wrapped(rule)]
    turning = max(s.turning for s in found)
    if turning > 0:
        text = f"Joints turn at up to {_number(turning)} rad/s, {_number(turning * a.step)} rad in a step: no method"
        text += " takes the turning itself implicitly, so a step should be short against it, some 0.02 rad."
        lines.append(_wrapped(text))
    if a.paper_bound is not None:
        bound = shown_time(a.paper_bound)
        text = f"The paper's (stability), 2/ω_max = 2 l²/(1.8751² n²) √(ρA/EI): {bound} for this robot."
        lines.append(_wrapped(f"{text} It does not hold, for forward Euler least of all (E19)."))
    return "\n".join(lines)


def _limit(k: int, states: Sequence[StateAnalysis]) -> tuple[str, ...]:
    def least(s: StateAnalysis) -> float:
        limit = s.limits[k].limit
        return float("inf") if limit is None else limit

    worst, fastest = min(states, key=least), max(states, key=lambda s: s.limits[k].rate)
    limit: StepLimit = worst.limits[k]
    found = shown_time(limit.limit) if limit.limit else "none"
    text = f"any (to {limit.tried:.3g} s)" if limit.limit is None else found
    where = "" if limit.limit is None else worst.label
    borne = "borne" if all(s.limits[k].borne for s in states) else "TOO LONG"
    rate = fastest.limits[k].rate
    return (limit.method, text, where, _number(rate), fastest.label if rate > 0 else "", borne)


# ------------------------------------------------------------------------------ words and columns


def _number(x: float) -> str:
    return "0" if abs(x) < 1e-300 else f"{x:.3g}" if 0.01 <= abs(x) < 1e5 else f"{x:.1e}"


def _count(n: int, one: str, many: str | None = None) -> str:
    return f"{n} {one if n == 1 else many or one + 's'}"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Lines of aligned columns, the first and words to the left, numbers to the right."""
    rows = [tuple(head), *rows]
    columns = list(zip(*rows, strict=True))
    widths = [max(map(len, column)) for column in columns]
    left = [k == 0 or not any(x[:1].isdigit() for x in column[1:]) for k, column in enumerate(columns)]
    align = [str.ljust if flag else str.rjust for flag in left]
    lines = ["  ".join(f(x, w) for f, x, w in zip(align, row, widths, strict=True)) for row in rows]
    return [("  " + line).rstrip() for line in lines]


def _wrapped(text: str, indent: str = "") -> str:
    more = indent + "  "
    return fill(
        text, WIDTH, initial_indent=indent, subsequent_indent=more, break_on_hyphens=False, break_long_words=False
    )
