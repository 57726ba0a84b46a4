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


@pytest.fixture(scope="module")
def written(tmp_path_factory) -> dict[str, bytes]:
    """The examples written from a folder, in an order of hashing, that the committed ones were not written with."""
    folder = tmp_path_factory.mktemp("first") / "deeper" / "place"
    folder.mkdir(parents=True)
    env = os.environ | {"PYTHONHASHSEED": "1", "PYTHONPATH": str(ROOT)}
    command = [sys.executable, str(ROOT / "examples" / "regenerate.py"), str(folder)]
    subprocess.run(command, cwd=folder, env=env, check=True, capture_output=True)
    return tree(folder)


@pytest.mark.parametrize("name", EXAMPLES)
def test_committed_output_is_current(written, name):
    """If this fails, look at the difference and run `make generated`."""
    fresh = {k: v for k, v in written.items() if k.startswith(f"{name}/")}
    committed = {f"{name}/{k}": v for k, v in tree(ROOT / "generated" / name).items()}
    assert sorted(fresh) == sorted(committed)
    assert [k for k in fresh if fresh[k] != committed[k]] == []


def test_nothing_personal(written):
    """No dates, paths or machine names."""
    for name, data in written.items():
        text = data.decode()
        for word in ("/home/", "/root", "/tmp", "/work", os.uname().nodename):
            assert word not in text, name
