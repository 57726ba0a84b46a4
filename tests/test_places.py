"""Places in templates, where the features of a robot write: what stands there, and that none is misspelled."""

import re
from pathlib import Path

import pytest

from screwgen.backends.templates import folder, render

TAG = re.compile(r"\{% (?:added|replaced) (\w+) %\}")
MACRO = re.compile(r"\{% macro (\w+)\(")
FOLDERS = sorted(path.parent for path in folder().glob("*/features"))


@pytest.fixture
def written(tmp_path):
    """The text of a template with features, of which `tides` and `winds` have files."""
    (tmp_path / "features").mkdir()
    files = {
        "sea": "sea\n{% added lines %}\n({% replaced words %}{{ name }}{% endreplaced %})\n"
        "{% for k in range(2) %}{% added ends %}{% endfor %}\n",
        "features/tides": "{% macro lines() %}\ntides of {{ name }}\n{% endmacro %}"
        "{% macro ends() %}{{ k }}{% endmacro %}",
        "features/winds": "{% macro lines() %}\nwinds\n{% endmacro %}{% macro words() %}<{{ caller() }}>{% endmacro %}",
        "features/storms": "{% macro words() %}{% replaced force %}9{% endreplaced %}{% endmacro %}",
        "features/gusts": "{% macro force() %}{{ caller() }} of {{ name }}{% endmacro %}",
    }
    for name, text in files.items():
        (tmp_path / f"{name}.jinja").write_text(text)
    return lambda *features: render("sea.jinja", tmp_path, features=features, name="x")


def test_a_place_has_what_features_write_in_their_order(written):
    assert written() == "sea\n(x)\n"
    assert written("tides") == "sea\ntides of x\n(x)\n01"
    assert written("winds", "tides") == "sea\nwinds\ntides of x\n(<x>)\n01"
    assert written("none", "tides") == written("tides")


def test_what_a_feature_writes_has_places_for_others(written):
    assert written("storms") == "sea\n(9)\n"
    assert written("storms", "gusts") == "sea\n(9 of x)\n"


@pytest.mark.parametrize("below", FOLDERS, ids=lambda path: path.name)
def test_places_and_what_is_written_there_have_the_same_names(below: Path):
    found = lambda names, pattern: {x for name in below.glob(names) for x in pattern.findall(name.read_text())}  # noqa: E731
    places = found("*.jinja", TAG) | found("features/*.jinja", TAG)  # what a feature writes may have places too
    assert places == found("features/*.jinja", MACRO) != set()
