"""Damaged and hostile files: one line for each, no crash, and no more memory than the file deserves."""

import io
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import damaged_files
import damages
import numpy as np
import pytest

from screwgen import RobotFileError
from screwgen.cli.main import main
from screwgen.files import ArrayFileError, mapped_array, open_arrays
from screwgen.reduction.finite_elements import load_npz
from screwgen.reduction.standard import load_sid

INDEFINITE = 50_414
"""A mesh whose mass matrix is indefinite for the static shapes of its tip alone."""


def test_a_sample_of_damaged_files_is_refused_or_read():
    """Every kind of file that is read; `python tests/damaged_files.py FIRST LAST` makes more."""
    found = list(damaged_files.results(iter([*range(10_000, 10_120), INDEFINITE]), 1))
    assert [x for x in found if x[2] not in damaged_files.GOOD] == []
    assert {x[1] for x in found} >= {"mesh", "run, view", "SID", "URDF", "state"}
    assert {x[2] for x in found} == set(damaged_files.GOOD)


@pytest.fixture(scope="module")
def run() -> bytes:
    return damaged_files._run()


def refused(capsys, *command) -> str:
    assert main([*map(os.fspath, command)]) == 2
    said = capsys.readouterr()
    *notes, error = said.err.splitlines()
    assert said.out == "" and error.startswith("screwgen: error: ")
    assert all(note.startswith("screwgen: note: ") for note in notes)
    return error


def changed(run: bytes, name: str, content: bytes, how: int = zipfile.ZIP_STORED) -> bytes:
    return damages.packed([(n, content if n == name else x) for n, x in damages._members(run)], how)


HEADS = {
    "a size of 745 GiB": (damages.header("'<f8'", "(100000000000,)"), "'q': its header promises 800000000000 bytes"),
    "an unclosed bracket": (damages.header("'<f8'", "(3,"), "'q' is damaged"),
    "an unclosed text": (damages.header("'''", "(3,)"), "'q' is damaged"),
    "a negative size": (damages.header("'<f8'", "(-3,)"), "'q': it has the shape (-3,)"),
    "objects": (damages.header("'|O'", "(3,)"), "'q'"),
    "nesting": (damages.header("'<f8'", "(" * 4000), "'q'"),
    "nothing": (b"", "'q' is damaged"),
    "complex numbers": (damages.npy(np.zeros(3, complex)), "'q' holds complex128; it must hold numbers"),
    "no numbers": (damages.npy(np.array([np.nan])), "q has the shape (1,)"),
}


@pytest.mark.parametrize("name", HEADS)
@pytest.mark.parametrize("command", [("view", "-o", "run.html"), ("analyse", "bot.toml", "--state")])
def test_a_damaged_array_of_a_run(name, command, run, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    content, said = HEADS[name]
    Path("bot.toml").write_text(damaged_files.ROBOT)
    Path("run.npz").write_bytes(changed(run, "q.npy", content))
    assert said in refused(capsys, *command, "run.npz")
    assert sorted(os.listdir()) == ["bot.toml", "run.npz"]


def test_an_encrypted_member_and_unknown_packing(run, tmp_path, capsys):
    packed = bytearray(damages.packed(damages._members(run), zipfile.ZIP_DEFLATED))
    at = packed.index(b"PK\1\2")
    packed[at + 8] |= 1
    (tmp_path / "run.npz").write_bytes(packed)
    assert "'t' is encrypted" in refused(capsys, "view", tmp_path / "run.npz", "-o", tmp_path / "a.html")
    packed[at + 8] &= 254
    packed[at + 10] = 12
    (tmp_path / "run.npz").write_bytes(packed)
    assert "'t' is packed in an unusual way" in refused(capsys, "view", tmp_path / "run.npz", "-o", tmp_path / "a.html")


LIMITED = """
import resource, sys
import numpy as np
from screwgen.files import ArrayFileError, open_arrays
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + 100 * 2**20,) * 2)
with open_arrays(sys.argv[1]) as arrays:
    assert arrays.numbers("small").sum() == 3.0
    try:
        arrays["large"]
    except ArrayFileError as error:
        print(error)
"""


def test_what_unpacks_to_a_thousand_times_its_size_is_left_packed(tmp_path):
    """What is beside it is read, in 100 MB."""
    path = tmp_path / "a.npz"
    path.write_bytes(damages.bomb("large.npy"))
    with zipfile.ZipFile(path, "a") as file:
        file.writestr("small.npy", damages.npy(np.ones(3)))
    assert path.stat().st_size < 5e6
    done = subprocess.run([sys.executable, "-c", LIMITED, path], capture_output=True, text=True, timeout=20)
    assert (
        done.stdout == "'large' would unpack to 0.734 GB, too much for a file of this size; write it with numpy.savez\n"
    )


def test_sizes_are_summed_before_anything_is_read(tmp_path):
    path, members = tmp_path / "a.npz", [(f"{name}.npy", damages.npy(np.ones(3))) for name in "ab"]
    out = bytearray(damages.packed(members))
    for at in (out.index(b"PK\1\2"), out.rindex(b"PK\1\2")):
        out[at + 24 : at + 28] = (2**32 - 2).to_bytes(4, "little")
    path.write_bytes(out)
    with pytest.raises(ArrayFileError, match=r"its arrays would take 8\.59 GB; at most"), open_arrays(path):
        pass


def test_packed_and_ordered_arrays_are_those_that_were_written(tmp_path):
    given = {"a": np.arange(6.0).reshape(2, 3).T, "b": np.array("text"), "c": np.zeros((0, 3)), "d": np.array([True])}
    given |= {"e": np.arange(3, dtype=">i4"), "f": np.array(["x", "yz"], ">U2"), "g": np.float32(3)}
    for save in (np.savez, np.savez_compressed):
        save(tmp_path / "a.npz", **given)
        with open_arrays(tmp_path / "a.npz") as arrays:
            assert list(arrays) == list(given)
            for name, values in given.items():
                assert np.array_equal(arrays[name], values) and arrays[name].dtype == np.asarray(values).dtype
            assert arrays.texts("f") == ("x", "yz") and arrays.texts("b") == ("text",)


@pytest.mark.parametrize("where", ["indices", "indptr"])
@pytest.mark.parametrize("value", [50, -1, 2**31 - 1])
def test_indices_outside_a_matrix_are_refused(where, value, tmp_path):
    """One index of a column that there is not: SciPy would write through it."""
    with np.load(io.BytesIO(damaged_files._mesh())) as data:
        stored = dict(data)
    stored[f"M_{where}"][3] = value
    np.savez(tmp_path / "mesh.npz", **stored)
    with pytest.raises(RobotFileError, match=r"mesh\.npz: M is no sparse matrix"):
        load_npz(tmp_path / "mesh.npz", 2)


def test_a_mesh_may_have_its_entries_in_any_order(tmp_path):
    with np.load(io.BytesIO(damaged_files._mesh())) as data:
        stored = dict(data)
    np.savez(tmp_path / "a.npz", **stored)
    rows = np.repeat(np.arange(len(stored["K_indptr"]) - 1), np.diff(stored["K_indptr"]))
    order = np.lexsort((-stored["K_indices"], rows))
    np.savez(tmp_path / "b.npz", **stored | {name: stored[name][order] for name in ("K_data", "K_indices")})
    a, b = (load_npz(tmp_path / name, 2) for name in ("a.npz", "b.npz"))
    assert np.array_equal(a.stiffness, b.stiffness)


def test_matrices_of_a_sid_are_bounded(tmp_path):
    text = damaged_files._sid(tmp_path).decode()
    head = "order = 1\n nrow = 10000\n ncol = 10000\n nq = 10000\n nqn = 0\n structure = 3\n m0( 1, 1) = 1.0\n"
    start = text.index("order")
    (tmp_path / "a.sid").write_text(text[:start] + head + text[start:])
    with pytest.raises(RobotFileError, match=r"a\.sid: line \d+: .* has 10000 x 10000 numbers"):
        load_sid(tmp_path / "a.sid")


def test_a_table_that_is_shorter_than_its_head_says_is_not_mapped(tmp_path):
    path = tmp_path / "a.npy"
    path.write_bytes(damages.npy(np.ones((4, 3)))[:-8])
    with pytest.raises(ArrayFileError, match="its header promises 96 bytes, but there are 88"):
        mapped_array(path)
