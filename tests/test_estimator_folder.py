"""The Kalman filter as it is generated: its folder, the command, the example, a Cortex-M4F."""

import subprocess
import sys

import pytest
from conftest import require_tool
from helpers import ROOT, relative
from test_c_code import WARNINGS
from test_estimator import model

from screwgen.backends.c.project import CProject
from screwgen.cli.main import main


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("binding", ["runtime", "baked"])
def test_folder_compiles_without_a_warning(tmp_path, compiler, binding):
    robot = model("skew")
    for name, text in CProject(robot.chain, robot.version, binding, estimator=True).files().items():
        (tmp_path / name).write_text(text)
    for define in ([], ["-DARM_REAL_FLOAT"]):
        command = [require_tool(compiler), *WARNINGS, *define, "-fsyntax-only", "arm_estimator.c"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0 and not done.stderr, done.stderr[:2000]
    for name in ("Makefile", "CMakeLists.txt", "README.md"):
        text = (tmp_path / name).read_text()
        assert "arm_estimator" in text and "arm_derivatives" in text


def test_the_header_says_what_it_costs():
    """And nothing of the process that wrote it."""
    header = CProject(model("ella").chain, "0", estimator=True).files()["ella_estimator.h"]
    assert "covariance about 8019 multiplications; an entry of a measurement takes about 486 of them" in header


def test_only_on_request():
    files = CProject(model("ella").chain, "0", derivatives=True).files()
    assert not any("estimator" in name or "estimator.h" in text for name, text in files.items())


def test_command_line(tmp_path):
    def generate(folder, target):
        robot = str(ROOT / "examples" / "ella_paper.toml")
        return main(["generate", robot, "-o", str(tmp_path / folder), "--target", target, "--estimator", "-q"])

    assert generate("o", "c") == 0
    names = {path.name for path in (tmp_path / "o" / "c").iterdir()}
    assert {"ella_estimator.h", "ella_estimator.c", "ella_derivatives.c"} <= names
    assert generate("p", "latex") == 2
    assert not (tmp_path / "p").exists()


# -------- the example, and the target


def test_example():
    """In a short form; it asserts its own figures."""
    sys.path.insert(0, str(ROOT / "examples"))
    import ekf_ella

    errors = ekf_ella.main(["--duration", "0.3"])
    assert errors["encoders, base strain"] < 0.1 * errors["open-loop model"]
    assert ekf_ella.PLOT.stat().st_size > 10_000


def test_on_the_cortex_m4f():
    """In float under QEMU: the figure is that of double on this machine."""
    for tool in ("cc", "arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    sys.path.insert(0, str(ROOT / "firmware"))
    import estimate

    estimate.OUT.mkdir(exist_ok=True)
    found = estimate.measure()
    assert found.part < estimate.LIMIT
    for name, error in found.errors.items():
        assert relative(error, found.errors_on_host[name]) < 0.05
    assert 0 < found.stack < 4096 and found.ram < 16_384
    assert found.counts["predict"] < 100_000 and found.counts["update"] < 50_000
    assert "filter over open loop" in estimate.text(found)
