"""The Kalman filter as it is generated: its folder, the command, the example, a Cortex-M4F."""

import subprocess
import sys

import pytest
from conformance.c_warnings import WARNINGS
from conftest import require_tool
from helpers import ROOT, arm, link, model_of
from test_estimator import model

from screwgen.backends.c.project import CProject
from screwgen.cli.main import main


@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("binding", ["runtime", "baked"])
@pytest.mark.parametrize("name", ["skew", "rigid"])
def test_folder_compiles_without_a_warning(tmp_path, compiler, binding, name):
    robot = model_of(arm(link("a", axes="y"))) if name == "rigid" else model(name)
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
    assert "covariance about 8019 multiplications; an update takes about 2187 of them, and about 324" in header


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


@pytest.mark.examples
def test_example():
    """In a short form; it asserts its own figures."""
    sys.path.insert(0, str(ROOT / "examples"))
    import ekf_ella

    errors = ekf_ella.main(["--duration", "0.3"])
    assert errors["encoders, base strain"] < 0.1 * errors["open-loop model"]
    assert ekf_ella.PLOT.stat().st_size > 10_000


sys.path.insert(0, str(ROOT / "firmware"))
import estimate  # noqa: E402

FOUND = {
    "flash": 1,
    "flash_alone": 1,
    "ram": 9000,
    "stack": 2000,
    "counts": {"predict": 60_000, "update": 30_000},
    "errors": {"filter": 1e-4, "open_loop": 2e-3},
    "errors_on_host": {"filter": 1e-4, "open_loop": 2e-3},
}


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({}, []),
        ({"stack": 4096}, ["stack: 4,096, the limit is 4,096"]),
        ({"ram": 20_000}, ["RAM: 20,000, the limit is 16,384"]),
        ({"counts": {"predict": 100_000, "update": 30_000}}, ["predict: 100,000, the limit is 100,000"]),
        ({"counts": {"predict": 60_000, "update": 0}}, ["update: 0, the limit is 50,000"]),
        ({"errors": {"filter": 1.1e-4, "open_loop": 2e-3}}, ["filter: the error in float is 1.100e-04 m"]),
        ({"errors": {"filter": float("nan"), "open_loop": 2e-3}}, ["the filter's error is nan%", "filter: the error"]),
        (
            {"errors": {"filter": 1e-4, "open_loop": 1e-3}, "errors_on_host": {"filter": 1e-4, "open_loop": 1e-3}},
            ["the filter's error is 10.0%"],
        ),
    ],
)
def test_what_the_filter_may_take_on_the_target(changed, said):
    found = estimate.failures(estimate.Result(**FOUND | changed))
    assert len(found) == len(said) and all(a.startswith(b) for a, b in zip(found, said, strict=True)), found


@pytest.mark.long
def test_on_the_cortex_m4f():
    """In float under QEMU, as `make firmware` measures it."""
    for tool in ("cc", "arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    estimate.OUT.mkdir(exist_ok=True)
    found = estimate.measure()
    assert estimate.failures(found) == []
    assert "filter over open loop" in estimate.text(found)
