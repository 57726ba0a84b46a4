"""A class name stands once in the package, so that a reader who meets it knows which class is meant."""

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1] / "screwgen"


def classes() -> Iterator[tuple[str, str]]:
    """The classes of the package with the module that defines each."""
    for file in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                yield node.name, file.relative_to(PACKAGE).as_posix()


def test_a_class_name_stands_once():
    homes: dict[str, list[str]] = defaultdict(list)
    for name, home in classes():
        homes[name].append(home)
    assert len(homes) > 100, "the package was not found"
    assert {name: places for name, places in homes.items() if len(places) > 1} == {}
