"""generated/ is what the tool writes now, byte for byte, from whatever folder it runs in.

Files whose bytes depend on the version of another package are compared by digest where that version is installed, and
functions always by signature and value.
"""

import json
import os
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest
from helpers import ROOT

EXAMPLES = ("ella", "six_link")
LEFT_OUT = "left_out.json"
MANIFEST = "MANIFEST.sha256"
PACKAGES = {".casadi": "casadi", ".html": None}
"""By the suffix of files that are left out: the package on whose version their bytes depend, if any."""
LARGEST = 2.2e6


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


@pytest.fixture(scope="module")
def committed():
    return tree(ROOT / "generated")


def same_version(committed, suffix: str) -> bool:
    """Whether the package on which the bytes of a kind of file depend is installed in the committed version."""
    package = PACKAGES.get(suffix)
    return package is None or json.loads(committed[LEFT_OUT])["versions"][package] == version(package)


@pytest.mark.parametrize("name", EXAMPLES)
def test_committed_output_is_current(written, committed, name):
    """If this fails, look at the difference and run `make generated`."""
    fresh, kept = ({k: v for k, v in t.items() if k.startswith(f"{name}/")} for t in (written, committed))
    assert sorted(fresh) == sorted(kept)
    assert [k for k in fresh if fresh[k] != kept[k] and not k.endswith(MANIFEST)] == []
    changed = set(fresh[f"{name}/{MANIFEST}"].splitlines()) ^ set(kept[f"{name}/{MANIFEST}"].splitlines())
    assert [x for x in changed if same_version(committed, Path(x.decode()).suffix)] == []


def test_left_out_files_are_current(written, committed):
    """Digests and sizes where the versions are the same; signatures and values of the functions always."""
    fresh, kept = (json.loads(t[LEFT_OUT])["files"] for t in (written, committed))
    assert sorted(fresh) == sorted(kept)
    for name, now in fresh.items():
        before, suffix = kept[name], Path(name).suffix
        if same_version(committed, suffix):
            assert (now["sha256"], now["bytes"]) == (before["sha256"], before["bytes"]), name
        if suffix == ".casadi":
            assert (now["inputs"], now["outputs"]) == (before["inputs"], before["outputs"]), name
            assert now["norms"] == pytest.approx(before["norms"], rel=1e-8, abs=1e-12), name


def test_left_out_files_are_those_of_the_manifests(committed):
    """What a manifest lists is there in full or left out, with the same digest."""
    left_out = json.loads(committed[LEFT_OUT])["files"]
    for name in EXAMPLES:
        lines = committed[f"{name}/{MANIFEST}"].decode().splitlines()
        listed = {f"{name}/{file}": digest for digest, file in (line.split("  ", 1) for line in lines)}
        own = {k: v["sha256"] for k, v in left_out.items() if k.startswith(f"{name}/")}
        assert {k: v for k, v in listed.items() if k not in committed} == own
        assert {Path(k).suffix for k in own} == set(PACKAGES)


def test_it_is_small(committed):
    assert sum(map(len, committed.values())) < LARGEST


def test_nothing_personal(written):
    """No dates, paths or machine names."""
    for name, data in written.items():
        text = data.decode()
        for word in ("/home/", "/root", "/tmp", "/work", os.uname().nodename):
            assert word not in text, name
