"""The architecture, read from the sources: imports run one way, and each outside library has its place."""

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[1] / "screwgen"
LAYERS = [
    {"errors", "files", "look", "methods", "notebook", "pace", "sympy_cache", "version"},
    {"curves"},
    {"bases", "algebra"},
    {"spec"},
    {"arguments"},
    {"derive"},
    {"lower"},
    {"chain"},
    {"emit"},
    {"folder", "library", "linear", "validity"},
    {"compiled", "memory"},
    {"build"},
    {"controllers", "inputs", "state", "runs", "dae", "integrate", "modes", "motion", "plot", "recording"},
    {"loop"},
    {"simulation"},
    {"batch", "estimator", "rollout", "rollout_validity", "statics"},
    {"convergence", "equilibrium", "mode_plot"},
    {"analysis"},
    {"paper"},
    {"formulation"},
    {"__init__"},
    {"cli", "cli_commands", "cli_paper", "cli_linear", "cli_output", "cli_process", "__main__"},
]
"""From bottom to top; a module imports from lower layers and from its own."""

MODULES = sorted(p.relative_to(PACKAGE) for p in PACKAGE.rglob("*.py"))


def room(path: Path) -> str:
    """The part of the package a file belongs to: a folder, or a module of the top."""
    return path.parts[0] if len(path.parts) > 1 else path.stem


def layer(name: str) -> int:
    found = [i for i, names in enumerate(LAYERS) if name in names]
    assert found, f"'{name}' has no layer: give it one in tests/test_imports.py"
    return found[0]


def imports(path: Path) -> set[tuple[str, ...]]:
    """All that a file imports, as dotted names from the top; relative imports are resolved."""
    found = set()
    here = ("screwgen", *path.with_suffix("").parts)
    for node in ast.walk(ast.parse((PACKAGE / path).read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {tuple(alias.name.split(".")) for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = here[: len(here) - node.level] if node.level else ()
            module = (*base, *(node.module or "").split(".")) if node.module else base
            inside = {(*module, alias.name) for alias in node.names}
            found |= inside if module == base or is_package(module) else {tuple(module)}
    return found


def is_package(module: tuple[str, ...]) -> bool:
    return module[0] == "screwgen" and (PACKAGE / Path(*module[1:]) / "__init__.py").exists()


def modules_of(name: tuple[str, ...]) -> str | None:
    """The module of the package that a dotted name is in, as `chain.phases`."""
    for end in range(len(name), 0, -1):
        path = PACKAGE.joinpath(*name[1:end])
        if path.with_suffix(".py").exists() and end > 1:
            return ".".join(name[1:end])
        if (path / "__init__.py").exists():
            return ".".join([*name[1:end], "__init__"])
    return None


def inside(path: Path) -> set[str]:
    return {m for name in imports(path) if name[0] == "screwgen" and (m := modules_of(name))}


@pytest.mark.parametrize("path", MODULES, ids=str)
def test_no_import_goes_up(path):
    own = layer(room(path))
    upward = {m for m in inside(path) if layer(m.split(".")[0]) > own}
    assert not upward


def test_no_import_cycles():
    graph = {".".join(p.with_suffix("").parts): inside(p) for p in MODULES}
    done: set[str] = set()

    def visit(module: str, trail: tuple[str, ...]) -> None:
        assert module not in trail, " -> ".join([*trail[trail.index(module) :], module])
        if module not in done:
            for other in graph.get(module, ()):
                visit(other, (*trail, module))
            done.add(module)

    for module in graph:
        visit(module, ())


@pytest.mark.parametrize(
    ("library", "rooms"),
    [
        ("casadi", {"emit/casadi*.py"}),
        ("jinja2", {"emit/templates.py"}),
        ("sympy", {"algebra/*", "derive/*", "lower/block.py", "emit/latex*.py", "paper/*"}),
        ("pydantic", {"spec/*"}),
        ("matplotlib", {"look.py", "curves.py", "plot.py", "mode_plot.py", "analysis/structure_plot.py"}),
    ],
)
def test_libraries_stay_in_their_rooms(library, rooms):
    users = {p for p in MODULES if any(name[0] == library for name in imports(p))}
    astray = {str(p) for p in users if not any(p.match(room) for room in rooms)}
    assert users and not astray


def test_the_two_halves_share_only_the_block():
    """Of the physics the code half sees the derived blocks; how they are made is none of its business."""
    for path in MODULES:
        if room(path) == "lower":
            assert {m for m in inside(path) if m.startswith("derive")} <= {"derive.block"}


@pytest.mark.parametrize("path", MODULES, ids=str)
def test_files_are_short(path):
    assert len((PACKAGE / path).read_text(encoding="utf-8").splitlines()) <= 350
