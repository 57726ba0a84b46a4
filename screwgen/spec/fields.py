"""The kinds of parameters that a robot file states: names, units and meanings."""

from collections.abc import Mapping
from typing import NamedTuple

from ..elements import TRAVELS
from .joint import Joint
from .section import Section


class Field(NamedTuple):
    """A kind of parameter: the pattern of its names below the link's, unit, meaning, names of components."""

    pattern: str
    unit: str
    description: str
    components: tuple[str, ...] = ()


XYZ = ("x", "y", "z")
RPY = ("roll", "pitch", "yaw")
TENSOR = ("xx", "yy", "zz", "xy", "xz", "yz")
MEASURED = "natural frequency of the bare link clamped at its base:"

OF_AXES = {
    "armature": ("kg·m²", "rotor inertia seen at the joint axis", "kg", "drive's inertia seen along the joint axis"),
    "damping": ("N·m·s/rad", "viscous damping about the joint axis", "N·s/m", "viscous damping along the joint axis"),
    "stiffness": ("N·m/rad", "stiffness about the joint axis", "N/m", "stiffness along the joint axis"),
    "drives.ratio": (
        "1",
        "turns of the rotor per turn of the joint",
        "rad/m",
        "turn of the rotor per travel of the joint",
    ),
    "drives.rotor_inertia": ("kg·m²", "inertia of the rotor", "kg", "mass that moves with the drive"),
    "drives.stiffness": ("N·m/rad", "stiffness of the gear at the joint", "N/m"),
    "drives.damping": ("N·m·s/rad", "damping of the gear at the joint", "N·s/m"),
    "drives.friction.coulomb": ("N·m", "dry friction", "N"),
    "drives.friction.viscous": ("N·m·s/rad", "viscous friction", "N·s/m"),
    "drives.friction.velocity": ("rad/s", "rate over which dry friction changes its sign", "m/s"),
    "limits.lower": ("rad", "least coordinate of the joint", "m"),
    "limits.upper": ("rad", "largest coordinate of the joint", "m"),
    "limits.stiffness": ("N·m/rad", "stiffness of the stops at the limits", "N/m"),
    "limits.damping": ("N·m·s/rad", "damping of the stops at the limits", "N·s/m"),
}
"""Unit and meaning of the parameters of an axis that turns, and of one that slides its unit, and where it has another
its meaning."""
SLIDING = {f"joint.{name}": (unit, (other or [meaning])[0]) for name, (_, meaning, unit, *other) in OF_AXES.items()}
"""Unit and meaning of a slide's parameters, in place of those of a joint that turns."""


def _pattern(name: str) -> str:
    """The pattern of such a parameter's name: `drives.ratio` is `joint.drives[{}].ratio`."""
    table, dot, key = name.partition(".")
    return f"joint.{table}[{{}}]{dot}{key}"


FIELDS = {
    "gravity": Field("gravity[{}]", "m/s²", "acceleration of free fall, inertial frame", XYZ),
    "length": Field("length", "m", "length of the undeformed centreline"),
    "frame_at": Field("frame_at", "m", "distance from the link's base to its frame's origin"),
    "rhoA": Field("rhoA", "kg/m", "mass per length"),
    "EA": Field("EA", "N", "axial stiffness"),
    "EIy": Field("EIy", "N·m²", "bending stiffness about y"),
    "EIz": Field("EIz", "N·m²", "bending stiffness about z"),
    "GJ": Field("GJ", "N·m²", "torsional stiffness"),
    "rhoIp": Field("rhoIp", "kg·m", "spin inertia per length about the centreline"),
    "GAy": Field("GAy", "N", "shear stiffness along y"),
    "GAz": Field("GAz", "N", "shear stiffness along z"),
    "rhoIy": Field("rhoIy", "kg·m", "rotary inertia per length about y"),
    "rhoIz": Field("rhoIz", "kg·m", "rotary inertia per length about z"),
    "frequencies.axial": Field("frequencies.axial[{}]", "Hz", f"{MEASURED} axial mode"),
    "frequencies.bending_y": Field("frequencies.bending_y[{}]", "Hz", f"{MEASURED} bending in y"),
    "frequencies.bending_z": Field("frequencies.bending_z[{}]", "Hz", f"{MEASURED} bending in z"),
    "frequencies.torsion": Field("frequencies.torsion[{}]", "Hz", f"{MEASURED} torsion"),
    "damping.ratio": Field("damping.ratio", "1", "damping ratio of each mode"),
    "joint.mount.xyz": Field("joint.mount.xyz[{}]", "m", "joint point from the parent's tip, tip frame", XYZ),
    "joint.mount.rpy": Field("joint.mount.rpy[{}]", "rad", "turn of the joint, Rz(y) Ry(p) Rx(r)", RPY),
    **{f"joint.{name}": Field(_pattern(name), unit, meaning) for name, (unit, meaning, *_) in OF_AXES.items()},
    **{
        f"joint.drives.transmission.{kind.TABLE}{name}": Field(
            _pattern(f"drives.transmission.{kind.TABLE}{name}"), key.unit, key.meaning
        )
        for kind in TRAVELS
        for name, key in kind.KEYS.items()
    },
    "bodies.mass": Field("bodies[{}].mass", "kg", "mass of the body"),
    "bodies.com": Field("bodies[{}].com[{}]", "m", "centre of mass", XYZ),
    "bodies.inertia": Field("bodies[{}].inertia[{}]", "kg·m²", "inertia about the centre of mass", TENSOR),
}

FIELDS |= {  # of a section that is stated at stations
    f"section.{name}": FIELDS[name]._replace(
        pattern=f"section[{{}}].{name}", description=f"{FIELDS[name].description}, at a station"
    )
    for name in Section.model_fields
}


def of_axis(field: str, joint: Joint, axis: int) -> tuple[str, str] | None:
    """Unit and meaning of a parameter of an axis where they are others than in `FIELDS`: of a slide, of a transmission.

    Friction on a rotor has those of a joint that turns, and so has a rotor's inertia where a ratio is stated.
    """
    drive, rotor = joint.driven[axis], field.endswith(".rotor_inertia")
    units: Mapping[str, tuple[str, str]] = {} if joint.screws[axis].turn else SLIDING
    units = drive.travel.UNITS if drive.travel else units
    on_rotor = drive.elastic and not drive.travel
    turns = on_rotor or (rotor and drive.ratio is not None)
    return None if turns and (rotor or ".friction." in field) else units.get(field)
