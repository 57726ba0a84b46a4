"""Libraries of generated C: built once, kept, checked before they are loaded, and what goes wrong with compilers."""

import copy
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from conftest import require_tool
from helpers import ROOT, arm, example, link

from screwgen import Robot, ScrewgenError, derive
from screwgen.integrators import METHODS
from screwgen.joints.ball import BALL
from screwgen.runtime import asked, library
from screwgen.runtime.compiled import Compiled
from screwgen.runtime.lean import RuntimeProject


@pytest.fixture(autouse=True)
def _compiler():
    require_tool("cc")


SMALL = {"one.c": "int answer(void) { return 42; }\n"}


def answer(folder, files=SMALL, flags=("-O0",)) -> int:
    return library.load(files, flags, cache=folder).answer()


def answer_elsewhere(folder) -> int:
    """The answer in a process of its own: this one keeps what it has loaded from a path."""
    script = "import sys; from screwgen.runtime.library import load\n"
    script += f"print(load({SMALL!r}, ('-O0',), cache=sys.argv[1]).answer())"
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", script, str(folder)], env=environment, capture_output=True, text=True, check=True
    )
    return int(done.stdout)


def entries(folder) -> list[str]:
    return sorted(os.listdir(folder))


def test_the_same_is_built_once_and_anything_else_anew(tmp_path, monkeypatch):
    assert answer(tmp_path) == 42
    (first,) = entries(tmp_path)
    with monkeypatch.context() as m:
        m.setattr(library, "_compiled", lambda *_: pytest.fail("built again"))
        assert answer(tmp_path) == 42
    assert answer(tmp_path, {"one.c": "int answer(void) { return 43; }\n"}) == 43
    assert answer(tmp_path, flags=("-O1",)) == 42
    assert len(entries(tmp_path)) == 3 and first in entries(tmp_path)


@pytest.mark.parametrize("damage", ["cut", "empty", "changed", "text"])
def test_a_damaged_entry_is_built_again(tmp_path, damage):
    assert answer(tmp_path) == 42
    path = tmp_path / entries(tmp_path)[0]
    data = path.read_bytes()
    flipped = data[:100] + bytes([data[100] ^ 1]) + data[101:]
    path.unlink()
    path.write_bytes({"cut": data[: len(data) // 2], "empty": b"", "changed": flipped, "text": b"no library"}[damage])
    assert answer(tmp_path) == 42
    assert path.read_bytes() == data or len(path.read_bytes()) == len(data)


def test_an_entry_under_the_name_of_another_is_built_again(tmp_path):
    """Copied whole, with its own digest: it is a library, but not that of these sources."""
    other = tmp_path / "other"
    assert answer(tmp_path / "own") == 42 and answer(other, {"one.c": "int answer(void) { return 43; }\n"}) == 43
    (mine,), (theirs,) = (list(folder.iterdir()) for folder in (tmp_path / "own", other))
    mine.unlink()
    shutil.copy(theirs, mine)
    assert answer_elsewhere(tmp_path / "own") == 42


def test_two_processes_at_once_both_succeed(tmp_path):
    code = f"""
import sys
from screwgen import Robot, derive
model = derive(Robot.model_validate({arm(link("a", axes="z"), link("b", axes="yz"))!r}))
print("ready", flush=True)
sys.stdin.readline()
print(model.compile(flags=("-O0",)).forward_dynamics([0.1] * 3, [0.0] * 3)[0].tolist())
"""
    settings = os.environ | {"SCREWGEN_CACHE": str(tmp_path)}
    start = dict(
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=settings, cwd=ROOT
    )
    both = [subprocess.Popen([sys.executable, "-c", code], **start) for _ in range(2)]
    assert [p.stdout.readline() for p in both] == ["ready\n"] * 2
    for p in both:
        p.stdin.write("\n")
        p.stdin.flush()
    said = [p.communicate(timeout=120) for p in both]
    assert [p.returncode for p in both] == [0, 0], said
    assert said[0][0] == said[1][0] and said[0][0].count(",") == 2
    assert sorted(Path(name).suffix for name in entries(tmp_path)) == [".key", ".so"]


def test_a_cache_that_cannot_be_written_is_done_without(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("in the way")
    for place in (tmp_path / "file", tmp_path / "file" / "below", "/proc/none"):
        assert answer(place) == 42
    assert entries(tmp_path) == ["file"]
    assert answer(False) == 42
    monkeypatch.setenv("SCREWGEN_CACHE", str(tmp_path / "file"))
    assert answer(True) == 42


def test_where_the_cache_is(tmp_path, monkeypatch):
    monkeypatch.setenv("SCREWGEN_CACHE", str(tmp_path / "own"))
    assert answer(True) == 42 and len(entries(tmp_path / "own")) == 1
    monkeypatch.delenv("SCREWGEN_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert library.cache_folder() == tmp_path / "screwgen"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path))
    assert library.cache_folder() == tmp_path / ".cache" / "screwgen"


def test_a_library_that_others_can_plant_is_not_loaded(tmp_path, monkeypatch):
    """A cache where others may write, or an entry that they own or may change: built anew, elsewhere, with a line."""
    folder = tmp_path / "shared"
    assert answer(folder) == 42 and folder.stat().st_mode & 0o777 == 0o700
    entry = folder / entries(folder)[0]
    planted = library._compiled(tmp_path, {"one.c": "int answer(void) { return 666; }\n"}, ["cc"], ()).read_bytes()
    plant = lambda: entry.unlink() or entry.write_bytes(planted + library._seal(entry.stem, planted))  # noqa: E731
    plant()
    assert answer_elsewhere(folder) == 666  # the digest does not tell who wrote it
    for place, mode in ((entry, 0o720), (entry, 0o702)):
        place.chmod(mode)
        assert answer_elsewhere(folder) == 42 and entry.stat().st_mode & 0o777 == 0o700
        plant()
    for mode in (0o777, 0o1777, 0o770):
        folder.chmod(mode)
        with pytest.warns(
            UserWarning, match=r"shared is no cache .*; chmod go-w it, or name another .* SCREWGEN_CACHE"
        ):
            assert answer(folder) == 42
    folder.chmod(0o700)
    monkeypatch.setattr(library.os, "geteuid", lambda: entry.stat().st_uid + 1)
    monkeypatch.setattr(library, "ROOT", -1)
    with pytest.warns(UserWarning, match="or own it"):
        assert answer(folder) == 42
    assert entry.read_bytes().startswith(planted)


def test_a_pipe_in_the_cache_is_no_entry(tmp_path):
    answer(tmp_path)
    entry = tmp_path / entries(tmp_path)[0]
    entry.unlink()
    os.mkfifo(entry)
    assert answer(tmp_path) == 42 and entry.is_file()


def test_the_cache_forgets_what_is_old(tmp_path, monkeypatch):
    monkeypatch.setattr(library, "MAX_ENTRIES", 2)
    for number in range(4):
        assert answer(tmp_path, {"one.c": f"int answer(void) {{ return {number}; }}\n"}) == number
        for age, name in enumerate(entries(tmp_path)):
            os.utime(tmp_path / name, (1e9 + number - age, 1e9 + number - age))
    (tmp_path / "building-abandoned").mkdir()
    os.utime(tmp_path / "building-abandoned", (1e9, 1e9))
    assert answer(tmp_path, {"one.c": "int answer(void) { return 9; }\n"}) == 9
    assert len(entries(tmp_path)) == 2


def test_the_library_follows_the_environment_and_says_what_is_missing(tmp_path, monkeypatch):
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(ScrewgenError, match=r"no C compiler 'no-such-compiler'; install gcc .* CC$") as caught:
        example("ella").compile()
    assert "\n" not in str(caught.value)
    monkeypatch.setenv("CC", f"{shutil.which('cc')} -DANSWER=7")
    assert answer(tmp_path, {"one.c": "int answer(void) { return ANSWER; }\n"}) == 7
    monkeypatch.setenv("CC", "cc")
    with pytest.raises(ScrewgenError, match=r"^cc failed on the generated C: .*error") as caught:
        answer(tmp_path, {"one.c": "int answer(void) { return x; }\n"})
    assert "\n" not in str(caught.value) and len(entries(tmp_path)) == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"#!/bin/sh\nprintf 'error: d\\351faut\\n' >&2\nexit 1\n", "failed on the generated C: error: d\ufffdfaut$"),
        (b"no program", "cannot be run: Exec format error; name another one in CC$"),
        (None, "is no command .*; mend the quotes in CC$"),
    ],
    ids=["latin-1", "no program", "quotes"],
)
def test_a_compiler_that_is_none_is_one_line(tmp_path, text, message):
    """Nothing of it is blamed on a file that is being written."""
    compiler = tmp_path / "compiler"
    compiler.write_bytes(text or b"")
    compiler.chmod(0o755)
    with pytest.raises(ScrewgenError, match=message) as caught:
        library.load(SMALL, (), str(compiler) if text else f"{compiler} 'x", cache=tmp_path / "cache")
    assert "\n" not in str(caught.value)


@pytest.mark.skipif("avx" not in Path("/proc/cpuinfo").read_text(), reason="the processor has no AVX")
def test_functions_are_compiled_once_unless_the_caller_names_a_processor(monkeypatch):
    """GCC for x86-64 alone compiles them twice otherwise."""
    require_tool("gcc")
    assert library._once(("gcc",), ("-O2",)) == ("-mavx",)
    assert library._once(("gcc",), ("-O2", "-march=x86-64")) == ()
    used, compiled = [], library._compiled
    monkeypatch.setattr(library, "_compiled", lambda *given: used.append(given[3]) or compiled(*given))
    library.load({"a.c": "int a(void) { return 1; }\n"}, ["-O2"], "gcc", False)
    assert used == [("-O2", "-mavx")]


def test_nothing_is_left_in_the_folder_of_work(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    c = Compiled(example("ella"), flags=("-O0",))
    assert np.isfinite(c.forward_dynamics(np.zeros(9), np.zeros(9))[0]).all() and os.listdir() == []


# ------------------------------------------------------------------------------ asked for by name

TWO = arm(link("a", axes="z", joint={"damping": [0.1]}), link("b", axes="y"))


@dataclass(frozen=True)
class OwnSpring:
    """A part of a robot whose lines may change under its name."""

    stiffness: float = 1.0


class OwnBall(type(BALL)):
    """A kind of joint of the user's own, along whose axes there are the rates of the product's."""


def test_what_was_asked_for_is_found_before_anything_is_written(tmp_path, monkeypatch):
    made = derive(Robot.model_validate(TWO)).compile(flags=("-O0",), cache=tmp_path)
    names = [name for name in entries(tmp_path) if name.endswith(".key")]
    assert len(names) == 1
    monkeypatch.setattr(RuntimeProject, "__init__", lambda *_, **__: pytest.fail("written again"))
    found = derive(Robot.model_validate(TWO)).compile(flags=("-O0",), cache=tmp_path)
    given = [0.1, 0.2], [0.3, 0.4], [0.5, 0.6]
    assert np.array_equal(made.forward_dynamics(*given)[0], found.forward_dynamics(*given)[0])


@pytest.mark.parametrize("change", ["number", "axis", "option", "flag", "method", "version", "package", "line"])
def test_what_differs_is_built_anew(tmp_path, monkeypatch, change):
    """One number, one axis, one option, one flag of the compiler, one version; one line of the product."""
    robot, how = copy.deepcopy(TWO), {"flags": ("-O0",), "cache": tmp_path}
    derive(Robot.model_validate(robot)).compile(**how)
    match change:
        case "number":
            robot["links"][0]["joint"]["damping"] = [0.1 + 1e-16]
        case "axis":
            robot["links"][0]["joint"]["axes"] = ["x"]
        case "option":
            how["parameters"] = "baked"
        case "flag":
            how["flags"] = ("-O0", "-DNOTHING")
        case "method":
            how["methods"] = (replace(METHODS["rk4"], name="mine"),)
        case "package":
            monkeypatch.setattr(asked, "version", lambda name: "0")
        case "version" | "line":
            name = "version.py" if change == "version" else "algorithms/phases.py"
            folder = shutil.copytree(ROOT / "screwgen", tmp_path / "screwgen", ignore=shutil.ignore_patterns("paper"))
            with (folder / name).open("a") as stream:
                stream.write("# another line\n")
            monkeypatch.setattr(asked, "PACKAGE", folder)
    asked.product.cache_clear()
    before = entries(tmp_path)
    derive(Robot.model_validate(robot)).compile(**how)
    asked.product.cache_clear()
    more = [name for name in entries(tmp_path) if name not in before]
    assert [name for name in more if name.endswith(".key")]


def test_names_are_the_same_in_every_process_and_robots_in_a_user_class_have_none():
    robot = Robot.model_validate(TWO)
    script = f"from screwgen import Robot; from screwgen.runtime.asked import digest\nprint(digest(Robot(**{TWO!r})))"
    environment = os.environ | {"PYTHONPATH": str(ROOT), "PYTHONHASHSEED": "7"}
    done = subprocess.run([sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == asked.digest(robot) != ""
    assert asked.digest(robot, OwnSpring()) == ""


def test_a_name_that_is_damaged_or_stands_for_another_is_not_believed(tmp_path):
    """A name copied over another, and half of one: both would give the library of other sources."""

    def answer_of(name, value):
        source = {"one.c": f"int answer(void) {{ return {value}; }}\n"}
        return library.load(source, ("-O0",), None, tmp_path, name).answer()

    assert [answer_of("first", 1), answer_of("second", 2), answer_of("first", 3)] == [1, 2, 1]
    one, other = (tmp_path / name for name in entries(tmp_path) if name.endswith(".key"))
    shutil.copy(one, other)
    assert sorted([answer_of("first", 4), answer_of("second", 5)]) in ([1, 5], [2, 4])
    for path in (one, other):
        path.write_text(path.read_text()[:80])
    assert answer_of("first", 6) == 6
