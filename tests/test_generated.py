"""generated/ is what the tool writes now, byte for byte, from whatever folder it runs in."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES = ("ella", "six_link")


def tree(folder: Path) -> dict[str, bytes]:
    return {f.relative_to(folder).as_posix(): f.read_bytes() for f in sorted(folder.rglob("*")) if f.is_file()}


def regenerate(folder: Path, cwd: Path, seed: str) -> None:
    env = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, str(ROOT / "examples" / "regenerate.py"), str(folder)]
    subprocess.run(command, cwd=cwd, env=env, check=True, capture_output=True)


@pytest.fixture(scope="module")
def two_runs(tmp_path_factory):
    """The examples written twice: from two folders, with two orders of hashing."""
    first, second = tmp_path_factory.mktemp("first"), tmp_path_factory.mktemp("second") / "deeper" / "place"
    second.mkdir(parents=True)
    regenerate(first, first, "1")
    regenerate(second, second, "2")
    return tree(first), tree(second)


def test_same_bytes_twice(two_runs):
    assert two_runs[0] == two_runs[1]


@pytest.mark.parametrize("name", EXAMPLES)
def test_committed_output_is_current(two_runs, name):
    """If this fails, look at the difference and run `make generated`."""
    fresh = {k: v for k, v in two_runs[0].items() if k.startswith(f"{name}/")}
    committed = {f"{name}/{k}": v for k, v in tree(ROOT / "generated" / name).items()}
    assert sorted(fresh) == sorted(committed)
    assert [k for k in fresh if fresh[k] != committed[k]] == []


def test_nothing_personal(two_runs):
    """No dates, paths or machine names."""
    for name, data in two_runs[0].items():
        text = data.decode()
        for word in ("/home/", "/root", "/tmp", "/work", os.uname().nodename):
            assert word not in text, name
