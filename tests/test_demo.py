"""`make demo` runs, over what it left before."""

import subprocess
import sys

import pytest
from conftest import require_tool
from helpers import ROOT, arm, link, model_of

pytestmark = pytest.mark.examples


def test_demo_runs_over_an_older_folder():
    """Of another arm of the same name: the folder is replaced."""
    require_tool("make")
    require_tool("cc")
    header = ROOT / "build" / "ella" / "c" / "ella.h"
    model_of(arm(link()) | {"name": "ella"}).write(ROOT / "build" / "ella", targets=("c",))
    before = header.read_text()
    done = subprocess.run([sys.executable, ROOT / "examples" / "demo.py"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "set points" in done.stdout and (ROOT / "build" / "ella.png").exists()
    assert header.read_text() != before
