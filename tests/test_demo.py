"""`make demo` runs, over what it left before."""

import subprocess
import sys

from conftest import require_tool
from helpers import ROOT, example


def test_demo_runs_over_an_older_folder():
    """Of an arm without rotors: the folder is replaced, and compiled as users do."""
    require_tool("make")
    require_tool("cc")
    header = ROOT / "build" / "ella" / "c" / "ella.h"
    example("converged").write(ROOT / "build" / "ella", targets=("c",))
    before = header.read_text()
    done = subprocess.run([sys.executable, ROOT / "examples" / "demo.py"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "set points" in done.stdout and (ROOT / "build" / "ella.png").exists()
    assert header.read_text() != before
