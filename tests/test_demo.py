"""`make demo` runs, over what it left before."""

import os
import subprocess
import sys

from conftest import require_tool
from helpers import ROOT, arm, link, model_of


def test_demo_runs_over_an_older_folder():
    """Of another arm of the same name: the folder is replaced. Its own Makefile is told not to optimise."""
    require_tool("make")
    require_tool("cc")
    header = ROOT / "build" / "ella" / "c" / "ella.h"
    model_of(arm(link()) | {"name": "ella"}).write(ROOT / "build" / "ella", targets=("c",))
    before = header.read_text()
    command, env = [sys.executable, ROOT / "examples" / "demo.py"], os.environ | {"CFLAGS": "-O0"}
    done = subprocess.run(command, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "set points" in done.stdout and (ROOT / "build" / "ella.png").exists()
    assert header.read_text() != before
