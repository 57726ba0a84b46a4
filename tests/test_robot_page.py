"""docs/robot.md: its tables are those of the classes that read a robot file, and its example has every key."""

import re
import tomllib
from pathlib import Path
from xml.etree import ElementTree

import pytest

from docs.tools import robot_page
from screwgen.elements import KINDS
from screwgen.interactions import KINDS as INTERACTIONS

DOCS = Path(__file__).resolve().parents[1] / "docs"
PAGE = robot_page.PAGE.read_text(encoding="utf-8")
WITHOUT_UNIT = set(
    """name section_rotation links section modes damping joint bodies basis axial bending_y bending_z torsion
    shear_y shear_z frequencies ratio axes mount at order stations between segments profile tube rod box nu body sid npz
    interface base tip parent drives friction load memory stribeck bend transmission four_bar branch limits elements
    loops couplings axis of markers points tendons from to actuated actuation brake forces pushes rest
    dahl ductility base_acceleration""".split()
) | set(INTERACTIONS)
"""Keys that are no physical quantity in some table."""
IN_PLACES = {"slide", "screw", "pitch", "world"}
"""Keys of axes, which have a table of their own, as elements have, and of a point of the world."""


def keys(part) -> list[str]:
    fields = (field.alias or name for name, field in part.model_fields.items() if not field.exclude)
    return [*fields, *getattr(part, "other_keys", ())]


@pytest.mark.parametrize("page", [robot_page.PAGE, robot_page.MOTIONS], ids=lambda page: page.stem)
def test_the_tables_are_current(page):
    """`python docs/tools/robot_page.py` writes them."""
    text = page.read_text(encoding="utf-8")
    assert robot_page.tables(text) == text and "<!-- keys of " in text


@pytest.mark.parametrize("part", robot_page.PARTS, ids=lambda part: part.__name__)
def test_every_key_is_explained_with_unit_and_default(part):
    table = PAGE.split(f"<!-- keys of {part.__name__} -->\n")[1].strip().split("\n\n")[0].splitlines()[2:]
    rows = [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in table]
    assert [row[0] for row in rows] == [f"`{key}`" for key in keys(part)]
    for key, unit, default, what in rows:
        assert default and len(what) > 5, key
        assert (unit != "–") or key.strip("`") in WITHOUT_UNIT, f"{key} has no unit"


def test_the_examples_have_every_key():
    """The one of the page, and those with files of the page on bodies."""
    text = PAGE + (DOCS / "elements.md").read_text(encoding="utf-8")
    examples = [tomllib.loads(block) for block in re.findall(r'```toml title="[^"]+"\n(.*?)```', text, re.DOTALL)]
    shown = set(_keys([example for example in examples if "links" in example]))
    elements = {key for kind, own in KINDS.items() for key in (kind, *own.table())}
    elements |= {key for own in INTERACTIONS.values() for key in (*own.table(), *own.choices())}
    listed = {key for part in robot_page.PARTS for key in keys(part)}
    assert shown - IN_PLACES == listed | elements


def _keys(value):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield key
            yield from _keys(inner)
    elif isinstance(value, list):
        for entry in value:
            yield from _keys(entry)


def test_the_drawing_of_the_frames_is_an_image_of_its_own_for_light_and_dark():
    text = (DOCS / "frames.svg").read_text(encoding="utf-8")
    names = " ".join(t.strip() for t in ElementTree.fromstring(text).itertext() if t.strip())
    assert all(word in names for word in ("joint point", "frame_at", "mount.xyz", "length", "tip frame", "gravity"))
    assert "prefers-color-scheme: dark" in text and "http" not in text.replace("http://www.w3.org/2000/svg", "")
    assert "](frames.svg)" in PAGE
