"""The tables of docs/robot.md and docs/motions.md: every key of a file with its unit and default, from the classes
that read it.

    python docs/tools/robot_page.py      # writes the tables anew; a test compares them

A table stands below its mark, `<!-- keys of Link -->`, those of elements and forces below their heads; the rest is
written by hand.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path

from pydantic.fields import FieldInfo

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from screwgen.elements import KINDS  # noqa: E402
from screwgen.interactions import KINDS as INTERACTIONS  # noqa: E402
from screwgen.spec import (  # noqa: E402  # noqa: E402
    brake,
    couplings,
    drive,
    forces,
    four_bar,
    joint,
    limit,
    loop_joint,
    loops,
    markers,
    modes,
    plan,
    profile,
    reduced,
    rest,
    section,
    stations,
    tendons,
    tip_path,
)
from screwgen.spec import robot as spec  # noqa: E402
from screwgen.spec.part import Part  # noqa: E402

PAGE, MOTIONS = (ROOT / "docs" / name for name in ("robot.md", "motions.md"))
TABLE = re.compile(r"<!-- keys of (\w+) -->\n+(?:\|.*\n)*\n*")
ELEMENTS = re.compile(r"(\| element \| key \|.*\n\|[-|]+\n)(?:\|.*\n)*")
FORCES = re.compile(r"(\| force \| key \|.*\n\|[-|]+\n)(?:\|.*\n)*")
SIGNS = {"positive": ", > 0", "non-negative": ", ≥ 0", "any": ""}
HEAD = "| key | unit | default | what |\n|---|---|---|---|\n"
CODE = re.compile(r"(\{ [^}]* \}|\[\[\w+\]\]|\[[^\]]*\]|\"\w+\"|\b(?:EA|EI[yz]|GJ|GA[yz]|rhoA|rhoI[pyz]|I[yz]|J)\b)")
"""What a file holds, within a description."""
ATOM = r"(?:kg|rad|Hz|Pa|N|m|s)[²³⁴]?"
UNIT = re.compile(rf", ({ATOM}(?:[·/]{ATOM})*)(?=$|[ ,;:)])")
PARTS = (
    *(
        spec.Robot,
        spec.Link,
        section.Section,
        stations.Stations,
        profile.Profile,
        profile.Tube,
        profile.Rod,
        profile.Box,
    ),
    *(modes.Modes, modes.Frequencies, spec.Damping, joint.Joint, joint.Mount, drive.Drive),
    *(drive.Friction, *drive.FRICTION_TABLES.values(), drive.Transmission),
    rest.RestCurvature,
    *(four_bar.FourBar, limit.Limit, brake.Brake, spec.Body, reduced.Reduced),
    *(loops.Loop, loop_joint.LoopJoint, couplings.Coupling, forces.Force, forces.Push, markers.Marker, tendons.Tendon),
)
"""Of a robot file."""
OF_MOTIONS = (plan.PlanFile, plan.PlanLimits, tip_path.TipPathFile, tip_path.CircularPath, tip_path.StraightPath)


def tables(text: str) -> str:
    """The page with its tables as the classes have them."""
    parts = {part.__name__: part for part in (*PARTS, *OF_MOTIONS)}
    text = ELEMENTS.sub(lambda m: m[1] + "".join(_element_rows()), text)
    text = FORCES.sub(lambda m: m[1] + "".join(_force_rows()), text)
    return TABLE.sub(lambda m: f"<!-- keys of {m[1]} -->\n\n{HEAD}{''.join(_rows(parts[m[1]]))}\n", text)


def _element_rows() -> Iterator[str]:
    """A row for each key of each kind of element; its name stands beside the first."""
    for kind in KINDS.values():
        names = [f"`{kind.KIND}`", *[""] * len(kind.table())]
        for name, (key, own) in zip(names, kind.table().items(), strict=False):
            yield f"| {name} | `{key}` | {own.unit} (of a slide {own.sliding}) | {own.meaning}{SIGNS[own.sign]} |\n"


def _force_rows() -> Iterator[str]:
    """A row for each key of each kind of force; its name stands beside the first."""
    for kind in INTERACTIONS.values():
        rows = [(key, own.unit, own.meaning, SIGNS[own.sign], own.entries) for key, own in kind.table().items()]
        rows += [(key, "–", meaning, "", ()) for key, meaning in kind.choices().items()]
        for name, (key, unit, meaning, sign, entries) in zip([f"`{kind.KIND}`", *[""] * len(rows)], rows, strict=False):
            several = f"; an array: {', '.join(entries)}" if entries else ""
            default = "`false`" if key in kind.choices() else "–" if hasattr(kind, key) else "required"
            yield f"| {name} | `{key}` | {unit} | {default} | {meaning}{sign}{several} |\n"


def _rows(part: type[Part]) -> list[str]:
    stated = {field.alias or name: field for name, field in part.model_fields.items() if not field.exclude}
    fields = [_row(name, field.description, _default(field)) for name, field in stated.items()]
    others = [_row(name, text, "–") for name, text in getattr(part, "other_keys", {}).items()]
    return fields + others


def _row(name: str, description: str, default: str) -> str:
    """A line of the table; the unit moves out of the description into a column of its own."""
    unit = UNIT.search(description)
    what = CODE.sub(r"`\1`", UNIT.sub("", description, count=1))
    return f"| `{name}` | {unit[1] if unit else '–'} | {default} | {what} |\n"


def _default(field: FieldInfo) -> str:
    if field.is_required():
        return "required"
    match field.default:
        case None | () | Part():
            return "–"
        case bool():
            return f"`{str(field.default).lower()}`"
        case str():
            return f'`"{field.default}"`'
        case tuple():
            return f"`{list(field.default)}`"
        case float():
            return f"`{round(field.default, 3)}`"
    return f"`{field.default}`"


if __name__ == "__main__":
    for page in (PAGE, MOTIONS):
        page.write_text(tables(page.read_text(encoding="utf-8")), encoding="utf-8")
