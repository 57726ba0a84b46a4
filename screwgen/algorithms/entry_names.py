"""The names and units of the entries of what functions of a robot report, in files of runs and in mock-up units."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from ..spec.inputs import OTHERS, WORD, places
from ..spec.parameters import coordinate_names
from ..spec.tendons import TENSIONS
from ..topology.chain import Chain
from .robot_function import RobotFunction, shape
from .signals import Signal

PARTS: dict[tuple, list[str]] = {
    (): [""],
    (3,): [f".{x}" for x in "xyz"],
    (6,): [f".{part}_{x}" for part in ("omega", "v") for x in "xyz"],
    (3, 3): [f"[{row},{column}]" for row in range(3) for column in range(3)],
}
"""The ends of the names of entries of vectors, twists and matrices, of the robot or of a marker; see `parts`."""
QUANTITIES = ("NQUANTITIES",)
"""The shape of what forces between frames report."""
OWN = {kind: row.own for row in OTHERS for kind in row.kinds}
"""What names begin with behind that of the link, by the word of the input that something belongs to."""
SIGNS = str.maketrans("-*23", "1·²³")
"""Signs of units in comments of C, and what stands for them elsewhere."""


def parts(signal: Signal, own: tuple[int | str, ...]) -> list[str]:
    """The ends of the names of entries of a result, of the shape ``own`` of one owner."""
    if signal.parts:
        return [f".{part}" for part in signal.parts]
    return PARTS[own] if own in PARTS else [f"[{k}]" for k in range(math.prod(int(n) for n in own))]


def names_in(function: RobotFunction, chain: Chain) -> tuple[str, ...]:
    """The names of the entries of what a robot reports."""
    drives, markers = coordinate_names(chain.robot).tau, [marker.name for marker in chain.markers]
    pieces = [segment.name for segment in chain.segments]
    return entry_names(function, drives, markers, pieces, chain.cylinders, chain.force_quantities)


def entry_names(
    function: RobotFunction,
    drives: Sequence[str],
    markers: Sequence[str] = (),
    links: Sequence[str] = (),
    cylinders: Sequence[int] = (),
    quantities: Iterable[str] = (),
) -> tuple[str, ...]:
    """The names of the entries of what is reported: `energy.kinetic`, `arm.power[0]` for the drive `arm.torque[0]`,
    of the tendon `left.tension` it is `left.power`, and its length `left.length`;
    `arm.tip.gyro.omega.x` and `arm.tip.marker_pose.R[0,1]` for a marker, `momentum.linear.x` of a vector of the robot,
    `arm.effort.torque` of a link, `boom[1].effort.torque` of a segment of one that is divided.

    ``cylinders``: which of the drives are some, `arm.cylinder_length[0]` is that of `arm.force[0]`; ``quantities``: the
    names of what forces between frames report.
    """
    out: list[str] = []
    of_drives = {"NTAU": drives, "NTENDONS": [drives[k] for k in places(drives, TENSIONS)]}
    of_drives["NCYLINDERS"] = [drives[k] for k in cylinders]
    for name, signal in function.results.items():
        what = f"{function.name}.{name}"
        if len(signal.shape) == 1 and signal.shape[0] in of_drives:
            out += [of_input(drive, name) for drive in of_drives[str(signal.shape[0])]]
        elif signal.shape == QUANTITIES:
            out += quantities
        elif signal.shape[:1] in (("NMARKERS",), ("NLINKS",)):
            owners = markers if signal.shape[0] == "NMARKERS" else links
            out += [f"{owner}.{what}{part}" for owner in owners for part in parts(signal, signal.shape[1:])]
        else:
            out += [what + part for part in parts(signal, signal.shape)]
    return tuple(out)


def of_input(name: str, what: str) -> str:
    """The name of what belongs to an input: `arm.power[0]` of `arm.torque[0]`, `base.yaw.power` of `base.yaw`.

    Of a brake `arm.brake_power[0]`.
    """
    told, count = WORD.subn(lambda found: f".{OWN.get(found[1], '')}{what}", name)
    return told if count else f"{name}.{what}"


def unit_text(unit: str) -> str:
    """A unit of a signal as people write it: `kg·m²/s` of `kg*m^2/s`."""
    return unit.translate(SIGNS).replace("^", "")


def entry_meanings(function: RobotFunction, chain: Chain) -> list[str]:
    """What these entries mean."""
    out: list[str] = []
    for of in function.results.values():
        own = chain.force_quantities.values() if of.shape == QUANTITIES else ()
        out += [x.meaning for x in own] or [of.meaning] * math.prod(shape(of, chain))
    return out


def entry_units(function: RobotFunction, chain: Chain) -> list[str]:
    """The units of these entries, as mock-up units have them."""
    out: list[str] = []
    for of in function.results.values():
        if of.shape == QUANTITIES:
            out += [quantity.unit for quantity in chain.force_quantities.values()]
            continue
        count, units = math.prod(shape(of, chain)), unit_text(of.unit).split(", ")
        last = of.shape[-1] if of.shape else 1
        each = last // len(units) if isinstance(last, int) and last % len(units) == 0 else 0
        out += [units[k % last // each] if each and isinstance(last, int) else units[0] for k in range(count)]
    return out
