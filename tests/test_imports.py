"""The architecture: imports run one way, and each outside library has its place."""

import ast
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from conftest import require_tool
from helpers import arm, link
from importlinter.cli import EXIT_STATUS_SUCCESS, lint_imports
from robot_toml import to_toml

import screwgen

PACKAGE = Path(__file__).resolve().parents[1] / "screwgen"
MODULES = sorted(p.relative_to(PACKAGE) for p in PACKAGE.rglob("*.py"))


@cache
def imports(path: Path) -> set[tuple[str, ...]]:
    """All that a file imports, as dotted names from the top; relative imports are resolved."""
    found = set()
    here = ("screwgen", *path.with_suffix("").parts)
    for node in run(ast.parse((PACKAGE / path).read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {tuple(alias.name.split(".")) for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = here[: len(here) - node.level] if node.level else ()
            module = (*base, *(node.module or "").split(".")) if node.module else base
            inside = {(*module, alias.name) for alias in node.names}
            found |= inside if module == base or is_package(module) else {tuple(module)}
    return found


def run(node: ast.AST) -> Iterator[ast.AST]:
    """All nodes but those that only a type checker sees."""
    for child in ast.iter_child_nodes(node):
        if not (isinstance(child, ast.If) and ast.unparse(child.test) == "TYPE_CHECKING"):
            yield child
            yield from run(child)


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


def test_imports_run_one_way():
    """The layers of pyproject.toml."""
    assert lint_imports(no_cache=True) == EXIT_STATUS_SUCCESS


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
        ("casadi", {"backends/casadi/*", "paper/z_casadi.py", "planning/*"}),
        ("jinja2", {"backends/templates.py", "backends/template_places.py"}),
        (
            "sympy",
            {
                "algebra/*",
                "bodies/*",
                "joints/*",
                "ir/block.py",
                "ir/lower.py",
                "backends/latex/*",
                "backends/equations/*",
                "paper/*",
                "lazily.py",
            },
        ),
        ("pydantic", {"spec/*"}),
        ("matplotlib", {"plotting/*"}),
    ],
)
def test_libraries_stay_in_their_rooms(library, rooms):
    users = {p for p in MODULES if any(name[0] == library for name in imports(p)) or lazily(p, library)}
    astray = {str(p) for p in users if not any(p.match(room) for room in rooms)}
    assert users and not astray


def lazily(path: Path, library: str) -> bool:
    """Whether a file takes sympy as `lazily` has it, which imports it later."""
    text = (PACKAGE / path).read_text(encoding="utf-8")
    return library == "sympy" and bool(re.search(r"^from \.+lazily import .*\bsp\b", text, re.MULTILINE))


@pytest.mark.parametrize("path", MODULES, ids=str)
def test_files_are_short(path):
    assert len((PACKAGE / path).read_text(encoding="utf-8").splitlines()) <= 350


def test_importing_leaves_the_environment_as_it_is():
    modules = [".".join(("screwgen", *p.with_suffix("").parts)) for p in MODULES if p.name != "__main__.py"]
    script = f"""
import contextlib, importlib, os
with contextlib.suppress(ModuleNotFoundError):
    import jax  # an extra, which sets variables of its own
before = dict(os.environ)
for name in {modules}:
    importlib.import_module(name)
assert dict(os.environ) == before, set(os.environ.items()) ^ set(before.items())
"""
    subprocess.run([sys.executable, "-c", script], check=True, cwd=PACKAGE.parent)


def test_the_stub_names_what_the_package_offers():
    """`screwgen/__init__.pyi` is for type checkers; the package imports its names when they are asked for."""
    stub = ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8"))
    imported = [node for node in stub.body if isinstance(node, ast.ImportFrom)]
    homes = {alias.name: node.module for node in imported for alias in node.names}
    assert homes == screwgen.HOMES and "Model" in homes
    assert all(getattr(screwgen, name) is not None for name in screwgen.__all__)


HEAVY = ("casadi", "jinja2", "matplotlib", "mpmath", "scipy.linalg", "scipy.spatial", "sympy")


@pytest.mark.parametrize(
    "arguments, unused",
    [
        (["--help"], ("numpy", "pydantic", *HEAVY)),
        (["simulate", "{robot}", "--duration", "0.01", "--step", "1e-3", "-o", "{folder}/run.npz"], HEAVY),
    ],
    ids=["help", "simulate"],
)
def test_a_command_imports_what_it_uses(tmp_path, arguments, unused):
    """A run whose C is in the cache needs neither the derivation nor what other commands use."""
    require_tool("cc")
    (tmp_path / "robot.toml").write_text(to_toml(arm(link("a", modes={"bending_y": 1}), link("b", axes="y"))))
    given = [x.format(robot=tmp_path / "robot.toml", folder=tmp_path) for x in arguments]
    script = f"import sys\nfrom screwgen.cli.main import main\nstatus = main({given})\n"
    script += f"print([name for name in {unused} if name in sys.modules], file=sys.stderr)\nsys.exit(status)"
    settings = os.environ | {"SCREWGEN_CACHE": str(tmp_path / "cache")}
    for _ in range(2):
        done = subprocess.run(
            [sys.executable, "-c", script], env=settings, cwd=PACKAGE.parent, capture_output=True, text=True
        )
        assert done.returncode == 0, done.stderr
    assert done.stderr.splitlines()[-1] == "[]"
