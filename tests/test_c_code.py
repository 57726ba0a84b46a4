"""The generated C: no forbidden construct, honest sizes, the same bytes every time."""

import hashlib
import os
import re
import subprocess
import sys
from functools import cache

import pytest
from conftest import require_tool, swept
from helpers import ROOT, arm, equal_links, example, example_file, link, model_of, unfolded

from screwgen import __version__, load
from screwgen.backends.c.project import CProject
from screwgen.ir.program import Program
from screwgen.spec.parameters import parameters

SOFT = {"EA": 5e3, "EIy": 30.0, "EIz": 50.0, "GJ": 20.0}
MANY = {"axial": 2, "bending_y": 4, "bending_z": 3, "torsion": 2}
BEND = {"bending_y": 1, "bending_z": 1}
TIP = [{"at": "tip", "mass": 1.0, "com": [0.1, 0.0, 0.02], "inertia": [0.01, 0.02, 0.02, 0.0, 0.0, 0.0]}]
OWN = {
    "rigid": arm(link("a", axes="z"), link("b", axes=["x", [1, 2, 3]], bodies=TIP), link("c", axes="y")),
    "welded": arm(
        link("a", axes=[], modes=BEND, section=SOFT), link("b", axes=[], modes=BEND, section=SOFT, bodies=TIP)
    ),
    "bare": arm(link("a", axes=[]), gravity=(0, 0, 0)),
    "many": arm(
        link("a", axes="yz", modes=MANY, section=SOFT, frame_at=0.3), link("b", axes="y", modes=MANY, section=SOFT)
    ),
}
KINDS = [(layout, binding) for layout in ("fused", "modular") for binding in ("runtime", "baked")]
BY_TURNS = [("bare", KINDS[0]), ("six_link", KINDS[1]), ("many", KINDS[2]), ("rigid", KINDS[3]), ("welded", KINDS[0])]
BOTH = (KINDS[0], KINDS[3])
BUILT = [("ella", kind) for kind in BOTH] + BY_TURNS
"""Robots and kinds whose C is looked at in `make test`."""
every_kind = pytest.mark.parametrize("kind", swept(KINDS, *BOTH), ids="-".join)


@cache
def project(robot: str, layout="fused", binding="runtime") -> CProject:
    model = model_of(OWN[robot]) if robot in OWN else example(robot)
    return CProject(model.chain, model.version, binding, layout)


@cache
def files(robot: str, layout="fused", binding="runtime") -> dict[str, str]:
    return project(robot, layout, binding).files()


def build(compiler: str, folder, *arguments) -> subprocess.CompletedProcess:
    return subprocess.run([require_tool(compiler), *arguments], cwd=folder, capture_output=True, text=True)


def code(text: str) -> str:
    """A C source without its comments and strings."""
    return re.sub(r'/\*.*?\*/|//[^\n]*|"[^"\n]*"', " ", text, flags=re.DOTALL)


# -------- constructs


@every_kind
@pytest.mark.parametrize("robot", swept(("ella", "many"), "ella"))
def test_no_forbidden_construct(robot, kind):
    """No heap, no input or output, no jumps, no loop but counted ones with constant bounds."""
    for name, text in files(robot, *kind).items():
        if not name.endswith((".c", ".h")) or name in ("main.c", "check.c"):
            continue
        text = code(text)
        assert not re.search(
            r"\b(malloc|calloc|realloc|free|alloca|printf|goto|while|do|setjmp|longjmp|errno)\b", text
        ), name
        loops = re.findall(r"\bfor\s*\(([^;]*);([^;]*);([^)]*)\)", text)
        assert len(loops) == len(re.findall(r"\bfor\b", text))
        for _, condition, _ in loops:
            bound = re.fullmatch(r"\s*\w+(?: \+ \d+)? (?:<=?|>=?) ([\w ]+?)(?: && status == \w+)?\s*", condition)
            assert bound and re.fullmatch(r"[A-Z_]+[A-Z0-9_]*( \+ 1)?|\d+|n|whole", bound[1]), condition


def call_graph(texts: dict[str, str]) -> dict[str, set[str]]:
    """Which of the project's functions call which, from the bodies of their definitions."""
    graph: dict[str, set[str]] = {}
    for text in map(code, texts.values()):
        for match in re.finditer(r"\b(\w+)\s*\(([^(){};]*)\)\s*\{", text):
            if match[1] not in ("if", "for", "switch", "while"):
                graph[match[1]] = set(re.findall(r"\b(\w+)\s*\(", body_at(text, match.end())))
    return {name: calls & graph.keys() for name, calls in graph.items()}


def body_at(text: str, start: int) -> str:
    depth = 1
    for end in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if depth == 0:
            return text[start:end]
    raise ValueError("unbalanced braces")


@pytest.mark.parametrize("layout", ["fused", "modular"])
def test_no_recursion(layout):
    texts = {
        n: t
        for n, t in files("ella", layout).items()
        if n.endswith((".c", "real.h")) and n not in ("main.c", "check.c")
    }
    graph = call_graph(texts)
    assert {"ella_step_rk4", "ella_dae_step_rk4", "ella_c4"} <= graph.keys() and graph["ella_step_rk4"]

    def visit(name: str, trail: tuple) -> None:
        assert name not in trail, trail
        for other in graph[name]:
            visit(other, (*trail, name))

    for name in graph:
        visit(name, ())


@every_kind
@pytest.mark.parametrize("robot", swept(("ella", "welded"), "welded"))
def test_objects_hold_no_variables(tmp_path, robot, kind):
    """Nothing writable in any object; of the outside world only libm, the compiler's memory functions and its question
    what processor this is."""
    sources, level = unfolded(tmp_path, files(robot, *kind)), "-O1" if robot == "ella" else "-O0"
    assert build("gcc", tmp_path, "-std=c99", level, "-c", *sources).returncode == 0
    objects = [s.replace(".c", ".o") for s in sources]
    lines = subprocess.run(
        [require_tool("nm"), *objects], cwd=tmp_path, capture_output=True, text=True, check=True
    ).stdout
    symbols = [line.split()[-2:] for line in lines.splitlines() if len(line.split()) > 1]
    assert not [name for kind_, name in symbols if kind_ in "dDbBCsS"]
    defined = {name for kind_, name in symbols if kind_ != "U"}
    outside = {name for kind_, name in symbols if kind_ == "U"} - defined
    assert outside <= {
        "sin",
        "cos",
        "sqrt",
        "sincos",
        "memcpy",
        "memset",
        "memmove",
        "__stack_chk_fail",
        "_GLOBAL_OFFSET_TABLE_",
        "__cpu_indicator_init",
        "__cpu_model",
    }


# -------- what the header says


@every_kind
@pytest.mark.parametrize("robot", swept(("ella", "bare", "welded", "many"), "ella", "welded"))
def test_header_states_the_sizes_of_the_scratch(tmp_path, robot, kind):
    sources, name = unfolded(tmp_path, files(robot, *kind)), project(robot).name
    (tmp_path / "sizes.c").write_text(
        f'#include <stdio.h>\n#include "{name}.h"\n'
        f'int main(void) {{ printf("%zu %zu", sizeof({name}_work), sizeof({name}_dae_work)); return 0; }}\n'
    )
    assert sources
    sizes = []
    for define in ([], [f"-D{name.upper()}_REAL_FLOAT"]):
        assert build("gcc", tmp_path, *define, "-o", "sizes", "sizes.c").returncode == 0
        sizes.append(tuple(map(int, subprocess.check_output([str(tmp_path / "sizes")]).split())))
    header = files(robot, *kind)[f"{name}.h"]
    stated = tuple(int(re.search(rf"{name}_{work} (\d+) bytes", header)[1]) for work in ("work", "dae_work"))
    assert stated == sizes[0]
    assert all(half <= whole / 2 for whole, half in zip(*sizes, strict=True))


def test_header_states_version_and_operations():
    for layout in ("fused", "modular"):
        header = files("ella", layout)["ella.h"]
        assert f"screwgen {__version__}" in header and f"layout {layout}" in header
        total, *parts = map(
            int,
            re.search(r"(\d+) operations\s+\*\s+\((\d+) \*, (\d+) \+ and -, (\d+) /, (\d+) others", header).groups(),
        )
        assert total == sum(parts) and 1000 < total < 20000
    whole = project("ella").fused
    asked = {name: values for name, values in whole.outputs.items() if name != "motion"}  # of what validity reads
    alone = Program(whole.name, whole.inputs, asked, whole.guards, whole.sections, whole.origins)
    header = files("ella")["ella.h"]
    assert f"{alone.operation_count} operations" in header and alone.operation_count < whole.operation_count


def test_header_says_which_body_stands_where_and_in_which_order_tensors_are():
    inertia = [0.1, 0.2, 0.2, 0.0, 0.0, 0.0]
    tip, base = {"at": "tip", "mass": 1.0}, {"at": "base", "mass": 2.0, "com": [0.1, 0.0, 0.0], "inertia": inertia}
    several = model_of(arm(link("upper", bodies=[tip, base]), link("fore", bodies=[tip]), link("hand")))
    header = " ".join(CProject(several.chain, several.version).files()["arm.h"].split())
    assert "/* in the order of the robot file: upper [0] at the tip, [1] at the base; fore [0] at the tip */" in header
    assert "inertia[6]; /* kg*m^2: inertia about the centre of mass, [xx, yy, zz, xy, xz, yz] */" in header
    assert "com[3]; /* m: centre of mass, [x, y, z] */" in header
    assert "at the base in F_i axes from the joint point, at the tip in tip-frame axes from the tip point" in header
    assert "moment of the bodies at the base about the joint point" in header
    assert ": their" not in header


def test_header_has_the_inertia_of_drives_in_their_units():
    """A mass that moves with a rod where no ratio is stated, else the inertia of what turns."""
    units = {p.name: (p.unit, p.description) for p in parameters(load(ROOT / "examples" / "bucket.toml"))}
    rotors = {name: unit for name, unit in units.items() if name.endswith("rotor_inertia")}
    assert sorted(unit for unit, _ in rotors.values()) == ["kg", "kg·m²"]
    header = files("bucket")["bucket.h"]
    assert "drives_rotor_inertia[1]; /* kg*m^2, of slides and cylinders kg: inertia of the rotor */" in header


# -------- the same bytes


DIGEST = """
import hashlib, sys
import screwgen
from screwgen import __version__, load
from screwgen.backends.c.project import CProject
for path in sys.argv[1:]:
    model = screwgen.derive(screwgen.load(path))
    for layout in ("fused", "modular"):
        for name, text in sorted(CProject(model.chain, model.version, "runtime", layout).files().items()):
            print(layout, name, hashlib.sha256(text.encode()).hexdigest())
"""


def test_same_bytes_from_every_folder_and_process(tmp_path):
    """Another folder, another hash seed, a small cache of sympy, no other robot before: what this process writes."""
    names = ("ella",)
    robots = [str(example_file(name)) for name in names]
    seed = "1" if os.environ.get("PYTHONHASHSEED") != "1" else "77"
    environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT), "SYMPY_CACHE_SIZE": "1000"}
    command = [sys.executable, "-c", DIGEST, *robots]
    found = subprocess.check_output(command, cwd=tmp_path, env=environment, text=True)
    own = [
        f"{layout} {name} {hashlib.sha256(text.encode()).hexdigest()}"
        for layout in ("fused", "modular")
        for robot in names
        for name, text in files(robot, layout).items()
    ]
    assert sorted(found.splitlines()) == sorted(own) and len(own) == 34


@pytest.mark.parametrize(("robot", "kind"), BUILT)
def test_no_dates_no_paths_no_machines(robot, kind):
    for name, text in files(robot, *kind).items():
        assert not re.search(r"\b20\d\d[-/]\d\d|__DATE__|__TIME__|/home/|/work/|/tmp/|/usr/", text), name
        assert os.uname().nodename not in text
        assert not re.search(r"[ \t]+$", text, re.MULTILINE), f"{name}: spaces at the end of a line"
        assert text.endswith("\n") and "\r" not in text and "\t" not in text.replace("\n\t", ""), name


# -------- size


def size_of_links(robot: dict) -> int:
    """Lines of code of the chain's functions, tables left out."""
    model = model_of(robot)
    text = code(CProject(model.chain, model.version, "runtime", "modular").files()["arm_links.c"])
    text = re.sub(r"static const int \w+\[[^]]*\] = \{.*?\};", "", text, flags=re.DOTALL)
    return len([line for line in text.splitlines() if line.strip()])


def test_modular_code_does_not_grow_with_equal_links():
    """Eight links or twelve of one class: the same functions, up to names; three classes need about twice as many."""
    eight, twelve = size_of_links(equal_links(8)), size_of_links(equal_links(12))
    assert abs(twelve - eight) <= 0.01 * eight
    mixed, more = size_of_links(equal_links(9, classes=3)), size_of_links(equal_links(12, classes=3))
    assert abs(more - mixed) <= 0.01 * mixed
    assert 1.5 * eight < mixed < 3 * eight


def test_links_that_carry_others_at_different_numbers_of_places():
    """A constant of the second place has the comment of a class with two places, not of the first that has any."""
    base, pole = link("base", 0.5, "z"), link("pole", 0.2, "y", at={"s": 0.5})
    children = link("a", 0.2, "z", parent="boom", at={"s": 0.3}), link("b", 0.2, "y", parent="boom", at={"s": 0.6})
    files = CProject(model_of(arm(base, pole, link("boom", 0.5, "y", parent="base"), *children)).chain, "").files()
    assert re.search(r" at1_\w+; /\* .*: .*; of a station \*/", files["arm.h"])
