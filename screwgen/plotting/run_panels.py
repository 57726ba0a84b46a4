"""What figures and pages show of a run over time: panels of curves, each with its unit, and whose they are."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

from ..algorithms.entry_names import PARTS, unit_text
from ..algorithms.robot_functions import BY_NAME
from ..elements import ROTOR
from ..errors import UsageError, one_line
from ..robot_model import RobotModel
from ..simulation.motion import modal_columns, tip_deflections, twist
from ..simulation.runs import Run, segments
from ..spec.inputs import OTHERS, WORD, input_units, places
from ..spec.modes import DIRECTIONS
from ..spec.reduced import ELASTIC
from ..spec.segments import owner
from ..spec.tendons import TENSIONS
from .curves import AXIS_CURVES, NOTHING, AxisCurves
from .demands import axis_word, bounds_of, place_names, set_points

TIPS = (
    ("Deflection of tips in y", "y", ("bending_y", "shear_y", ELASTIC)),
    ("Deflection of tips in z", "z", ("bending_z", "shear_z", ELASTIC)),
    ("Elongation", "x", ("axial", ELASTIC)),
)
"""Title, axis of the link, and the directions of modes that move the tip along it."""
FORCES, NONE = "force_quantities", np.empty((0, 0))
"""The function whose entries have units of their own, and what a run has of it that has no forces."""


class PanelCurve(NamedTuple):
    """A curve over time, and the goal and the bound that are drawn with it."""

    values: np.ndarray
    owner: int | str
    """The number of its link, whose colour it has; of what is no link's, such as ``x`` and ``total``, the name."""
    label: str
    number: int = 0
    """Which of its link's it is: the first, the second, … has dashes of its own."""
    goal: np.ndarray | None = None
    bound: float = np.inf
    """The limit of a drive's effort, infinite where there is none."""
    ends: Sequence[float] = ()
    """The limits of a joint axis, infinite where there is none."""


class Panel(NamedTuple):
    """One set of axes over time."""

    title: str
    symbol: str
    unit: str
    lines: list[PanelCurve]

    @property
    def largest(self) -> float:
        """The largest magnitude of all, in SI units."""
        return max(float(np.abs(line.values).max()) for line in self.lines)


def panels(run: Run, controller: Any = None, model: RobotModel | None = None) -> list[Panel]:
    """The panels over time, link by link within each; a unit lacks its prefix, which depends on the size."""
    goals, bounds = set_points(run, model, controller), bounds_of(run, model, controller)
    return [*motion_panels(run, model, goals, bounds), *_wrenches(run)]


def chosen(found: Sequence[Panel], only: Sequence[str]) -> list[Panel]:
    """The panels whose titles have one of the words; all where there are no words."""
    for word in only:
        if not any(word.lower() in panel.title.lower() for panel in found):
            titles = ", ".join(dict.fromkeys(panel.title for panel in found if panel.lines))
            raise UsageError(f"panel: no title has '{one_line(word)}'; there are {titles}")
    return [x for x in found if not only or any(word.lower() in x.title.lower() for word in only)]


def motion_panels(
    run: Run, model: RobotModel | None, goals: np.ndarray | None = None, bounds: np.ndarray | None = None
) -> list[Panel]:
    """Those of motion, drives and energy; `goals` (n_joints, N): set points, `bounds` (n_tau,): limits of drives."""
    kinetic, potential = run.energy.T
    energy = _named(("kinetic", "potential", "total"), (kinetic, potential, kinetic + potential))
    beside = {"goal": goals, "bound": bounds, "ends": None if model is None else model.chain.limits}
    titles = _titles(run, model)
    return [
        *_base(run),
        *(
            Panel(titles.get(x.title, x.title), x.symbol, x.unit, _of_axes(run, model, x, beside))
            for x in AXIS_CURVES
            if x.array in run.arrays
        ),
        *_other_inputs(run),
        *(_tips(run, model) if model else _modes(partial(_lines, run, model, run.q, run.q_names))),
        Panel("Energy", "E", "J", energy),
        *_of_forces(run),
        *_reported(run),
        Panel("Tip, inertial frame", "r", "m", _named("xyz", run.tip_position.T)),
    ]


def _other_inputs(run: Run) -> Iterator[Panel]:
    """The inputs that are no axis', a panel for each of their units, and their power."""
    names = run.tau_names
    units = dict(zip(names, input_units(run.robot), strict=True)) if run.robot is not None else {}
    of_axes = {x.word.strip(".[") for x in AXIS_CURVES}
    for row in (*(row for row in OTHERS if row.kinds and not of_axes & {*row.kinds}), None):
        kept = places(names, row)
        title, letter = (row.title or row.words.capitalize(), row.letter) if row else ("Other inputs", "u")
        of = {k: units.get(names[k], "") for k in kept}
        for unit in dict.fromkeys(of.values()):
            yield _panel_of_inputs(run, title, letter, unit, "tau", [k for k, own in of.items() if own == unit])
        for array in ("drive_power", "effort_power"):
            if kept and array in run.arrays:
                yield _panel_of_inputs(run, f"Power of {row.words if row else 'other inputs'}", "P", "W", array, kept)


def _panel_of_inputs(run: Run, title: str, symbol: str, unit: str, array: str, kept: Sequence[int]) -> Panel:
    pairs = zip(run.arrays[array][:, kept].T, _names(run, kept), strict=True)
    return Panel(title, symbol, unit, [PanelCurve(x, k, name) for k, (x, name) in enumerate(pairs)])


def _names(run: Run, kept: Sequence[int]) -> list[str]:
    """The names of inputs without the words of their kind, where those tell nothing apart."""
    return [WORD.sub("", run.tau_names[k]) for k in kept]


def _reported(run: Run) -> Iterator[Panel]:
    """What functions of the robot report, where it is no quantity of axes: a panel for each result."""
    links, pieces = link_names(run), segments(run.wrench_names)
    for name in sorted(set(run.told) - {x.array for x in AXIS_CURVES} - {FORCES}):
        rows, first = run.told[name].reshape(len(run.t), -1).T, 0
        for result, signal in BY_NAME[name].results.items():
            of_links = signal.shape == ("NLINKS",)
            tendons = _names(run, places(run.tau_names, TENSIONS))
            shape, whole = signal.shape, {("NLINKS",): pieces, ("NTENDONS",): tendons}
            labels = whole[shape] if shape in whole else [part.lstrip("._") or result for part in PARTS[shape]]
            own = rows[first : first + len(labels)]
            whose = lambda k, a: links.index(owner(a)) if of_links else a if a in "xyz" else k  # noqa: E731, B023
            lines = [PanelCurve(x, whose(k, a), a) for k, (x, a) in enumerate(zip(own, labels, strict=True))]
            first += len(labels)
            title = signal.meaning[0].upper() + signal.meaning[1:]
            yield Panel(title, result, unit_text(signal.unit), lines)


def _of_forces(run: Run) -> Iterator[Panel]:
    """What forces between frames report: a panel for each quantity, whose curves are the forces that have it."""
    kinds: dict[tuple[str, str], list[PanelCurve]] = {}
    for values, (name, unit) in zip(run.told.get(FORCES, NONE).T, run.quantity_units.items(), strict=True):
        force, _, quantity = name.partition(".")
        lines = kinds.setdefault((quantity, unit), [])
        lines.append(PanelCurve(values, len(lines), force))
    for (quantity, unit), lines in kinds.items():
        yield Panel(f"{quantity.replace('_', ' ').capitalize()} of forces between frames", quantity, unit, lines)


def _named(names: Sequence[str], values: Iterable[np.ndarray]) -> list[PanelCurve]:
    """Curves that are no link's."""
    return [PanelCurve(x, name, name) for name, x in zip(names, values, strict=True)]


def _titles(run: Run, model: RobotModel | None) -> dict[str, str]:
    """Other titles of panels: torques and forces of a robot whose drives act on its joints directly."""
    kinds = model.chain.travel_kinds if model else []
    behind = any(f".{ROTOR.name}[" in name for name in run.q_names) or any(x.EFFORT_UNIT == "N·m" for x in kinds)
    turned = {name.replace(".force[", ".joint[") for name in run.tau_names if ".force[" in name} & set(run.q_names)
    direct = {"Torques": "Joint torques"} if not behind else {}
    return direct | ({} if turned else {"Forces of drives": "Forces on slides"})


def _of_axes(run: Run, model: RobotModel | None, x: AxisCurves, beside: dict[str, Any]) -> list[PanelCurve]:
    """The curves of a panel of axes, with set points, bounds or limits of the axes."""
    names = run.names_of(x.array)
    out = _lines(run, model, run.arrays[x.array], names, x.word, axes=True)
    of_axes = [name for name in names if x.kind != "goal" or ".joint[" in name or ".slide[" in name]
    chosen = np.array([x.word in name for name in of_axes], bool)
    for field in {"goal": ("goal", "ends"), "bound": ("bound",)}.get(x.kind, ()):
        out = _with(out, field, beside[field], chosen)
    return out


def _base(run: Run) -> list[Panel]:
    """Where a base that is not fixed is, and how it has turned since the start: rotation vectors in inertial axes."""
    if not place_names(run):
        return []
    turns = Rotation.from_quat(run.q[:, 3:7], scalar_first=True)
    turned = (turns * turns[0].inv()).as_rotvec()
    place, turn = _named("xyz", run.q[:, :3].T), _named("xyz", turned.T)
    return [Panel("Base, inertial frame", "r", "m", place), Panel("Turn of the base", "θ", "rad", turn)]


def sift(given: list[Panel]) -> tuple[list[Panel], list[str]]:
    """The panels with something to show, and the titles of those that are zero throughout."""
    full = [panel for panel in given if panel.lines]
    return [p for p in full if p.largest > NOTHING], [p.title.lower() for p in full if p.largest <= NOTHING]


def link_names(run: Run) -> list[str]:
    """The names of the links, base to tip."""
    return list(dict.fromkeys(map(owner, run.wrench_names)))


def _lines(
    run: Run, model: RobotModel | None, values: np.ndarray, names: tuple[str, ...], part: str, axes: bool = False
) -> list[PanelCurve]:
    """The columns whose name has `part` after the link's; `axes`: of joint axes, whose letters the labels have."""
    links, given = link_names(run), {x.name: x for x in model.robot.links} if model else {}
    found: list[tuple] = [(k, *name.split(part)) for k, name in enumerate(names) if part in name]
    out = []
    for k, link, member in found:
        i, own, number = links.index(owner(link)), owner(link), int(member[:-1])
        word = axis_word(given[own], number) if axes and own in given else str(number + 1) if number else ""
        out.append(PanelCurve(values[:, k], i, f"{own} {word}".strip(), number))
    return out


def _modes(q: Callable[[str], list[PanelCurve]]) -> list[Panel]:
    """The modal coordinates of a run whose model is not at hand."""
    titles = {d: f"Modes, {d.replace('_', ' in ')}" for d in DIRECTIONS} | {ELASTIC: "Modes of bodies from files"}
    units = {"torsion": "rad"}
    return [Panel(title, "η", units.get(d, "m"), q(f".eta.{d}[")) for d, title in titles.items()]


def _tips(run: Run, model: RobotModel) -> list[Panel]:
    """How far the tips of flexible links are from those of the undeformed links, and how far they are twisted."""
    tips, names = tip_deflections(model, run.q), [x.name for x in model.robot.links]
    has = lambda i, kinds: any(modal_columns(model, i, kind) for kind in kinds)  # noqa: E731
    named = lambda i, values: PanelCurve(values, i, names[i])  # noqa: E731
    moved = [
        Panel(title, f"$u_{axis}$", "m", [named(i, u[:, "xyz".index(axis)]) for i, u in tips.items() if has(i, kinds)])
        for title, axis, kinds in TIPS
    ]
    twisted = [named(i, twist(model, run.q, i, [1.0])[:, 0]) for i in tips if has(i, ("torsion",))]
    return [*moved, Panel("Twist of tips", "φ", "rad", twisted)]


def _wrenches(run: Run) -> list[Panel]:
    """The forces and moments at the bases of links, each along an axis of its link, with their signs."""
    joints = [i for i, name in enumerate(run.wrench_names[::6]) if owner(name) == name.rpartition(".")[0]]
    names = link_names(run)
    return [
        Panel(f"Joint {what}s in {axis}", f"${letter}_{axis}$", unit, [
            PanelCurve(run.wrench[:, i, row + k], j, names[j]) for j, i in enumerate(joints)
        ])
        for what, letter, unit, row in (("force", "F", "N", 3), ("moment", "M", "N·m", 0))
        for k, axis in enumerate("xyz")
    ]  # fmt: skip


def _with(lines: list[PanelCurve], field: str, values: np.ndarray | None, chosen: np.ndarray) -> list[PanelCurve]:
    """The lines with one field each from the `chosen` ones of `values`, one per joint axis, if there are any."""
    if values is None or len(values) != len(chosen):
        return lines
    return [line._replace(**{field: value}) for line, value in zip(lines, values[chosen], strict=True)]
