"""The do-mpc example runs in its short form, and its own assertions hold."""

import os
import subprocess
import sys

import pytest
from conftest import require_tool
from helpers import ROOT

pytestmark = pytest.mark.examples


def test_do_mpc_closes_the_loop_on_ella():
    require_tool("cc")
    command = [sys.executable, str(ROOT / "examples" / "do_mpc_ella.py"), "--short"]
    env = os.environ | {"PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1"}
    done = subprocess.run(command, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert not done.stderr, done.stderr
    assert "do-mpc and generated C" in done.stdout
