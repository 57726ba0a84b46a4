"""Wild calls of every public function of generated C under sanitizers: no fault, no OK without finite results."""

import subprocess

import pytest
from c_tools import SANITIZERS
from conformance.c_wild import program
from conftest import require_tool, swept
from feature_robots import CONTROL, FEATURES, WITHOUT_CONTROL, write

EXAMPLES = ("main.c", "check.c", "mpc_main.c")


@pytest.mark.parametrize("feature", swept(FEATURES, "elastic gear", "loop", "stiff rows"))
def test_wild_calls(tmp_path, feature):
    control = None if feature in WITHOUT_CONTROL else CONTROL
    write(tmp_path, feature, "runtime", "fused", control)
    (tmp_path / "wild.c").write_text(program(tmp_path, "robot"))
    sources = sorted(path.name for path in tmp_path.glob("*.c") if path.name not in EXAMPLES)
    command = [require_tool("gcc"), "-std=c99", "-O0", *SANITIZERS, "-o", "wild", *sources, "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    done = subprocess.run([tmp_path / "wild", "10000", "1"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr[:2000]
