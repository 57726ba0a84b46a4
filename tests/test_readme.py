"""The README's blocks do what they say, run as a reader would run them."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import require_tool

pytestmark = pytest.mark.examples

ROOT = Path(__file__).resolve().parents[1]
README = (ROOT / "README.md").read_text()


def console_block() -> tuple[str, str]:
    """The shell script of the console block, and what the last command is said to print."""
    block = re.search(r"```console\n(.*?)```", README, re.DOTALL)[1]
    commands, current = [], None
    for line in block.splitlines():
        if line.startswith("$ "):
            current = [line[2:]]
            commands.append(current)
        elif current is not None:
            current.append(line)
    script = ["\n".join(c) if "<<" in c[0] else c[0] for c in commands]
    return "\n".join(script), "\n".join(commands[-1][1:])


def environment(folder: Path) -> dict[str, str]:
    """A PATH in which `screwgen` is this package."""
    shim = folder / "bin" / "screwgen"
    shim.parent.mkdir()
    shim.write_text(f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" -m screwgen "$@"\n')
    shim.chmod(0o755)
    return os.environ | {"PATH": f"{shim.parent}:{os.environ['PATH']}"}


def test_from_robot_file_to_c_call(tmp_path):
    """The console block runs as it stands and prints what it says; then the Python block runs in its folder."""
    require_tool("cc")
    script, printed = console_block()
    env = environment(tmp_path)
    done = subprocess.run(["bash", "-e", "-c", script], cwd=tmp_path, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip().splitlines()[-1] == printed
    python = re.search(r"```python\n(.*?)```", README, re.DOTALL)[1]
    code = [sys.executable, "-c", python]
    done = subprocess.run(code, cwd=tmp_path, env=env | {"PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "run.npz").exists()


def test_files_named_in_the_readme_exist():
    """Every relative link leads somewhere."""
    prose = re.sub(r"```.*?```", "", README, flags=re.DOTALL)
    for target in re.findall(r"\]\(([^)#:]+)\)", prose):
        assert (ROOT / target).exists(), target
