"""The commands `modes`, `equilibrium` and `assemble`: vibrations about a posture, rest, and closed loops."""

from __future__ import annotations

import json as json_format
import sys
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..errors import SingularError, UsageError
from ..model import Model, derive
from ..simulation.state import state_in
from ..spec.inputs import effort_names, effort_units, input_units
from ..spec.load import one_line
from ..spec.parameters import coordinate_units
from .output import load_robot
from .stated_numbers import joint_coordinates, numbers

if TYPE_CHECKING:
    from ..studies.convergence import Convergence
    from ..studies.equilibrium import Equilibrium
    from ..studies.modes import Changed, ModeShapes


def run_modes(
    robot: str,
    posture: str | None,
    joints: str,
    rates: str | None,
    loaded: bool,
    json: bool,
    plot: str | None,
    view: str | None,
) -> None:
    """Print natural frequencies, one a line or as JSON, and draw the shapes."""
    from ..simulation.runs import check_output, outputs
    from ..studies.convergence import convergence
    from ..studies.modes import changed_by_gravity, closed_posture, mode_shapes

    if plot is not None:
        check_output(plot, (".png",))
    if view is not None:
        check_output(view, (".html",))
    model = derive(load_robot(robot))
    values = np.array(model.parameter_values)
    q = closed_posture(model, None if posture is None else state_in(posture, model).q, values)
    turning = None if rates is None else numbers("v", rates, model.n_joints, "joint rates in rad/s or m/s", "rates")
    found = mode_shapes(model, q, joints, rates=turning, loaded=loaded)
    found.validity.warn()
    more = None
    try:
        more = convergence(model, q, joints, rates=turning, loaded=loaded)
    except SingularError as error:
        print(f"screwgen: note: how far one more mode would move them is not known: {error}", file=sys.stderr)
    if plot is not None:
        from ..plotting.mode_plot import png

        with outputs(plot) as (stream,):
            stream.write(png(model, q, found))
    if view is not None:
        from ..viewer.view import view_modes

        view_modes(model, q, found).save(view)
    if not loaded and turning is None and (changed := changed_by_gravity(model, q, joints, found)):
        print(f"screwgen: note: {gravity_note(changed)}", file=sys.stderr)
    if json:
        print(json_format.dumps(modes_record(found, more), allow_nan=False))
        return
    print("\n".join(modes_table(found, more)) or NO_MODES[joints])
    if joints == "locked":
        for note in lock_notes(model, q):
            print(f"screwgen: note: --joints locked {note}", file=sys.stderr)


def gravity_note(changed: Changed) -> str:
    """What a frequency without gravity leaves out."""
    which = f"frequency {changed.number} is"
    if changed.growth:
        there = f"unstable, it grows as exp({changed.growth:.4g}/s t)"
    else:
        there = f"{changed.loaded:.4g} Hz, not {changed.without:.4g} Hz"
    return f"gravity is left out; with --loaded, which takes it in, {which} {there}"


def lock_notes(model: Model, q: np.ndarray) -> list[str]:
    """What --joints locked does that needs saying: to springs, and to joints that follow loops."""
    from ..simulation.mobility import stated_joints
    from ..studies.stiffness import stiffness

    first, stated = model.chain.base_v, stated_joints(model, q, model.parameter_values)
    names = model.chain.axis_names
    springs = stiffness(model)[first : first + model.n_joints]
    sprung = [name for name, k, s in zip(names, springs, stated, strict=True) if k > 0 and s]
    out = [f"also locks the springs of {', '.join(sprung)}; --joints free lets them act"] if sprung else []
    if not stated.all():
        locked, others = (
            [name for name, s in zip(names, stated, strict=True) if s == which] for which in (True, False)
        )
        out.append(f"locks {', '.join(locked) or 'nothing'}; {', '.join(others)} follow the loops")
    return out


def modes_record(found: ModeShapes, more: Convergence | None) -> dict:
    """What `modes --json` prints; zeros and nulls first, for the motions that no spring resists.

    Without an answer of the convergence study, ``one_more_mode`` and ``short_of`` are null.
    """
    count = range(len(found.frequencies))
    return {
        "frequencies_hz": [*found.rigid * [0.0], *found.frequencies.tolist()],
        "growth_per_s": [*found.rigid * [0.0], *found.growth.tolist()],
        "one_more_mode": more and [*found.rigid * [0.0], *(more.total + 0.0).tolist()],
        "short_of": more and [*found.rigid * [None], *(more.short(k) for k in count)],
        "validity": found.validity.record(),
    }


def modes_table(found: ModeShapes, more: Convergence | None) -> list[str]:
    """One line per frequency: Hz, its change by one more mode per direction in %, the direction that needs it most.

    Without an answer of the convergence study, a question mark stands for the change.
    """
    lines = [f"{0:<12g} Hz" for _ in range(found.rigid)]
    for k, (f, growth) in enumerate(zip(found.frequencies, found.growth, strict=True)):
        moved, wanted = (percent(more.total[k]), more.short(k)) if more else ("?", None)
        change = f"unstable, grows as exp({growth:.4g}/s t)" if growth else f"{moved:>14}"
        lines.append(f"{f:<12.6g} Hz {change}   {wanted or ''}".rstrip())
    head = f"{'frequency':15} {'one more mode':>14}   wanted most in"
    return [head, *lines] if lines else []


def percent(change: float) -> str:
    """A relative change in %, to two digits and no finer than 0.01 %."""
    size = 100 * abs(change)
    return "0 %" if size < 0.005 else f"−{size:.2g} %" if size < 9.95 else f"−{size:.0f} %"


NO_MODES = {
    "locked": "no modes: every link is rigid, and --joints locked locks every joint",
    "free": "no modes: every link is rigid and welded",
}


# ------------------------------------------------------------------------------ equilibrium


class HoldOptions(NamedTuple):
    """The options that say which joints are held."""

    all_without_springs: bool = False
    all: bool = False
    only: tuple[str, ...] = ()
    free: tuple[str, ...] = ()

    @property
    def hold(self) -> bool | str | tuple[str, ...]:
        """What `equilibrium` takes as `hold`; refuses options that contradict each other."""
        every = "--hold-all" if self.all else "--hold" if self.all_without_springs else "--free" if self.free else ""
        if self.only and every:
            raise UsageError(f"--hold-only and {every} both say which joints are held; leave one of them out")
        return self.only or ("all" if self.all else bool(every))


def run_equilibrium(
    robot: str,
    state: str | None,
    q: str | None,
    tau: str | None,
    tensions: str | None,
    holding: HoldOptions,
    json: bool,
) -> None:
    """Print the equilibrium, as a report or as JSON."""
    from ..studies.equilibrium import equilibrium

    hold, model = holding.hold, derive(load_robot(robot))
    given = state_in(state, model)
    if given.v.any():
        print(f"screwgen: note: {one_line(str(state))}: v: is left out; an arm at rest has none", file=sys.stderr)
    start = given.q if q is None else joint_coordinates(q, model)
    efforts = given.tau if tau is None else given_efforts(model, tau)
    if tensions is not None:
        efforts = with_tensions(model, efforts, tensions, tau)
    if tau is None and hold:
        efforts = without_held(model, efforts, holding, f"{one_line(str(state))}: tau")
    found = equilibrium(model, start, efforts, given.w_ext, hold, free=holding.free)
    acting = {"w_ext": given.w_ext.tolist()} if given.w_ext.any() else {}
    print(json_format.dumps(record(found) | acting, allow_nan=False) if json else text(model, found))


def given_efforts(model: Model, tau: str) -> np.ndarray:
    """The torques and tensions (n_tau,) of --tau, which may leave the tensions out."""
    loads = "joint forces" if model.chain.sliding else "joint torques in N·m"
    if model.n_tau > model.n_joints and len(tau.replace(",", " ").split()) != model.n_joints:
        return numbers("tau", tau, model.n_tau, f"{loads}, and tensions in N behind them")
    return model.chain.with_idle_inputs(numbers("tau", tau, model.n_joints, loads))


def with_tensions(model: Model, efforts: np.ndarray, tensions: str, tau: str | None) -> np.ndarray:
    """Torques and tensions (n_tau,) with the tensions of --tensions."""
    if model.n_tau == model.n_joints:
        raise UsageError(f"--tensions: robot '{model.robot.name}' has no tendons; leave it out")
    if tau is not None and len(tau.replace(",", " ").split()) == model.n_tau:
        raise UsageError("--tau and --tensions both give tensions; leave one of them out")
    pulled = numbers("tau", tensions, model.n_tau - model.n_joints, "tensions in N", "tensions")
    return np.append(efforts[: model.n_joints], pulled)


def without_held(model: Model, efforts: np.ndarray, holding: HoldOptions, where: str) -> np.ndarray:
    """The efforts (n_tau,) of a state without those of joints that are held, which follow; a note says so."""
    from ..studies.held_joints import asked
    from ..studies.stiffness import stiffness

    first, m = model.chain.base_v, model.n_joints
    held = asked(model, holding.hold, holding.free, stiffness(model)[first : first + m] > 0).held
    out = efforts * ~np.append(held, np.zeros(model.n_tau - m, bool))
    if (out != efforts).any():
        print(f"screwgen: note: {where}: torques of held joints follow, those given are left out", file=sys.stderr)
    return out


def run_assemble(robot: str, state: str | None, q: str | None, hold: list[str]) -> None:
    """Print a posture with closed loops as the JSON of a state, and notes on its rows and on links that it bends."""
    from ..studies.assemble import assemble, bent, redundant

    model = derive(load_robot(robot))
    for row in redundant(model):
        print(f"screwgen: note: {row}: follows from the other rows and is left out", file=sys.stderr)
    start = state_in(state, model).q
    if q is not None:
        start = joint_coordinates(q, model)
    found = assemble(model, start, hold)
    print(json_format.dumps({"q": found.tolist()}))
    if names := bent(model, start, found):
        print(f"screwgen: note: loops close with bent links alone: {', '.join(names)} moved", file=sys.stderr)


def record(e: Equilibrium) -> dict:
    """What `--json` prints."""
    lists = ("q", "tau", "stiffness", "wrench", "tip_position", "tip_deflection", "deflections")
    words = {name: getattr(e, name) for name in ("held", "residual", "stability")}
    words |= {name: list(getattr(e, name)) for name in ("held_joints", "loose", "passive")}
    words["validity"] = e.validity.record()
    if e.following:
        words["following"] = list(e.following)
    if e.loop_wrench.any():
        words["loop_wrench"] = (e.loop_wrench + 0.0).tolist()
    return {name: (getattr(e, name) + 0.0).tolist() for name in lists} | words


WORDS = ("joint angles", "torques")
"""Of a robot without slides: what its joint coordinates are, and their forces."""
FORCES = "torques and forces"


def text(model: Model, e: Equilibrium) -> str:
    """The report."""
    from ..studies.held_joints import joint_names

    joints = slice(model.chain.base_q, model.chain.base_q + model.chain.n_redundant)
    coordinates, torques = ("joint coordinates", FORCES) if model.chain.sliding else WORDS
    coordinates = "joint coordinates" if model.chain.curved else coordinates
    torques = FORCES if "N" in input_units(model.robot) else torques
    every = set(joint_names(model)) == {*e.held_joints, *e.passive, *e.following}
    angles = coordinates + ", held" * (e.held and every)
    torques += " that hold them" if e.held and every else " given" if not e.held else ""
    lines = [f"{model.robot.name} at rest: {stability(e)}; residual {e.residual:.1e} of the loads", ""]
    named = zip(model.q_names[joints], coordinate_units(model.robot)[joints], strict=True)
    told = dict.fromkeys(e.following, ", follows the loops") | dict.fromkeys(e.passive, ", on its spring")
    if e.held and not every:
        told |= dict.fromkeys(e.held_joints, ", held")
    told |= {f"{name.removesuffix('[0]')}.q{x}": said for name, said in told.items() for x in "wxyz"}
    units = [unit + told.get(name, "") for name, unit in named]
    lines += table(angles, model.q_names[joints], e.q[joints], units)
    lines += table(torques, effort_names(model.robot), e.effort, effort_units(model.robot))
    lines += [f"{'tip in the inertial frame':29}" + heads(1)]
    lines += [f"{'  position, m':29}" + row(e.tip_position), f"{'  deflection, mm':29}" + row(1e3 * e.tip_deflection)]
    titles = ("deflection of its tip, mm", "joint moment, N·m", "joint force, N")
    lines += ["", f"{'links, components in F_i':29}" + "".join(f"{title:>36}" for title in titles)]
    lines += [" " * 29 + heads(3)]
    small = float(np.max(np.abs(e.wrench)))
    for link, moved, wrench in zip(model.robot.links, e.deflections, e.wrench, strict=True):
        lines.append(f"  {link.name:27}" + row(1e3 * moved) + row(wrench[:3], small) + row(wrench[3:], small))
    if e.loop_wrench.any():
        lines += [
            "",
            f"{'loops, in the tip frames':29}"
            + "".join(f"{on:>36}" for on in ("moment on the tip, N·m", "force on the tip, N")),
        ]
        lines += [" " * 29 + heads(2)]
        small = float(np.max(np.abs(e.loop_wrench)))
        ends = {end.removesuffix(".tip") for loop in model.robot.rigid_loops.values() for end in loop.between}
        for link, wrench in zip(model.robot.links, e.loop_wrench, strict=True):
            if link.name in ends:
                lines.append(f"  {link.name:27}" + row(wrench[:3], small) + row(wrench[3:], small))
    return "\n".join(lines)


def table(title: str, names: list[str], values: np.ndarray, units: list[str]) -> list[str]:
    rows = [f"  {name:27}{tidy(value, 1.0):>12} {u}" for name, value, u in zip(names, values, units, strict=True)]
    return [title, *rows, ""] if rows else []


def heads(count: int) -> str:
    """x, y, z over columns."""
    return "".join(f"{axis:>12}" for axis in "xyz" * count)


def row(values: np.ndarray, size: float = 0.0) -> str:
    """Three numbers side by side; those negligible relative to the largest, or to `size`, are zero."""
    size = max(size, float(np.max(np.abs(values))))
    return "".join(f"{tidy(x, size):>12}" for x in values)


def tidy(value: float, size: float) -> str:
    """A number to five digits; rounding errors beside a number of that size as 0."""
    return "0" if abs(value) <= 1e-12 * max(size, 1e-3) else f"{value:.5g}"


def stability(e: Equilibrium) -> str:
    names = ", ".join(e.loose)
    past = ", ".join(e.validity.buckled)
    return {
        "stable": f"stable to first order, but beyond the buckling load of {past}" if past else "stable",
        "neutral": f"neutral, nothing resists a motion of {names}",
        "unstable": f"unstable, it gives way with {names}",
        "flutter": "unstable, it flutters under the wrenches that turn with the tips",
    }[e.stability]
