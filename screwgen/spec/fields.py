"""The kinds of parameters that a robot file states: names, units and meanings."""

from collections.abc import Mapping
from typing import NamedTuple

from ..elements import TRAVELS
from .brake import Brake
from .drive import FRICTION_TABLES, Drive, Friction
from .frequencies import Frequencies
from .joint import Joint, Mount
from .limit import OF_LAWS, Limit
from .part import Part
from .rest import RestCurvature
from .robot import Body, Damping, Link, Robot
from .section import Section
from .stated import stated_numbers


class Field(NamedTuple):
    """A kind of parameter: the pattern of its names below the link's, unit, meaning, sign, names of components.

    `sign`: ``positive``, ``non-negative`` or ``any``, from the range of the quantity.
    """

    pattern: str
    unit: str
    description: str
    sign: str
    components: tuple[str, ...] = ()


def _numbers(part: type[Part], table: str = "", place: str = "") -> dict[str, Field]:
    """The numbers of a table of the file, by their names without what brackets hold: `joint.drives.ratio`.

    `place`: the table as names of parameters have it, `joint.drives[{}].`.
    """
    return {
        f"{table}{name}": Field(
            f"{place or table}{name}{'[{}]' * bool(x.several or x.components)}", x.unit, x.meaning, x.sign, x.components
        )
        for name, x in stated_numbers(part)
    }


OF_AXES: dict[str, tuple[type[Part], str]] = {
    "joint.": (Joint, "joint."),
    "joint.drives.": (Drive, "joint.drives[{}]."),
    "joint.drives.friction.": (Friction, "joint.drives[{}].friction."),
    **{
        f"joint.drives.friction.{table}.": (part, f"joint.drives[{{}}].friction.{table}.")
        for table, part in FRICTION_TABLES.items()
    },
    "joint.limits.": (Limit, "joint.limits[{}]."),
    "joint.brake.": (Brake, "joint.brake[{}]."),
}
"""The tables with numbers of axes."""
SLIDING = {f"{table}{name}": x.on_slide for table, (part, _) in OF_AXES.items() for name, x in stated_numbers(part)}
"""Unit and meaning of a slide's parameters, in place of those of a joint that turns."""

FIELDS = {
    **_numbers(Robot),
    **_numbers(Link),
    **_numbers(Section),
    **_numbers(Frequencies, "frequencies."),
    **_numbers(RestCurvature, "rest."),
    **_numbers(Damping, "damping."),
    **_numbers(Mount, "joint.mount."),
    **{name: x for table, (part, place) in OF_AXES.items() for name, x in _numbers(part, table, place).items()},
    **{
        f"joint.drives.transmission.{kind.TABLE}{name}": Field(
            f"joint.drives[{{}}].transmission.{kind.TABLE}{name}", key.unit, key.meaning, key.sign
        )
        for kind in TRAVELS
        for name, key in kind.KEYS.items()
    },
    **_numbers(Body, "bodies.", "bodies[{}]."),
    "tendons.at": Field("tendons[{}].at[{}][{}]", "m", "offset of the tendon from the centreline", "any"),
}

FIELDS |= {  # of a section that is stated at stations
    f"section.{name}": FIELDS[name]._replace(
        pattern=f"section[{{}}].{name}", description=f"{FIELDS[name].description}, at a station"
    )
    for name in Section.model_fields
}

FIELDS |= {  # of a curvature at rest that is stated at stations
    f"rest_at.{name}": FIELDS[f"rest.{name}"]._replace(
        pattern=f"rest[{{}}].{name}", description=f"{FIELDS[f'rest.{name}'].description}, at a station"
    )
    for name in RestCurvature.model_fields
}


def of_axis(field: str, joint: Joint, axis: int) -> tuple[str, str] | None:
    """Unit and meaning of a parameter of an axis where they are others than in `FIELDS`: of a slide, of a transmission.

    Limits of an input have units by its own. Friction on a rotor has those of a joint that turns, and so has a rotor's
    inertia where a ratio is stated; along a cylinder friction has those of a slide.
    """
    drive, rotor = joint.driven[axis], field.endswith(".rotor_inertia")
    if limit := OF_LAWS.get(field.removeprefix("joint.limits.")):
        return limit.sliding if drive.effort(joint.screws[axis])[1] == "N" else limit.unit, limit.meaning
    units: Mapping[str, tuple[str, str]] = {} if joint.screws[axis].turn else SLIDING
    rubs = ".friction." in field
    if drive.travel:
        units = SLIDING if rubs and drive.travel.IS_LENGTH else drive.travel.UNITS
    on_rotor = drive.elastic and not drive.travel
    turns = on_rotor or (rotor and drive.ratio is not None)
    return None if turns and (rotor or rubs) else units.get(field)
