"""`make demo` runs, and runs again over what it left."""

import os
import subprocess
import sys
from pathlib import Path

from conftest import require_tool

ROOT = Path(__file__).resolve().parents[1]


def test_demo_runs_twice():
    require_tool("make")
    require_tool("cc")
    command = [sys.executable, str(ROOT / "examples" / "demo.py")]
    for more in ({}, {"MAKEFLAGS": "CFLAGS=-O0"}):  # compiled as users do, then quickly
        done = subprocess.run(command, env=os.environ | more, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        assert "set points" in done.stdout and (ROOT / "build" / "ella.png").exists()
