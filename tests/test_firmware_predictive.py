"""Predictive control on the Cortex-M7: what `make firmware` measures, and that a figure past its limit is said."""

import sys

import pytest
from conftest import require_tool
from helpers import ROOT

sys.path.insert(0, str(ROOT / "firmware"))

import budget_table
import cross
import predictive
import stack

COUNTS = {"start": [50_000_000], "preparation": [4_000_000, 4_400_000], "feedback": [200_000, 100_000]}
FOUND = {
    "flash": 200_000,
    "flash_alone": 30_000,
    "ram": 140_000,
    "controller": 130_000,
    "stack": 6_000,
    "painted": 5_000,
    "counts": COUNTS,
    "unsolved": 0,
    "iterations": 12,
    "miss": 0.03,
    "apart": 1e-9,
}


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({}, []),
        ({"unsolved": 2}, ["2 samples had no solution"]),
        ({"miss": 0.06}, ["the tip ends 60.0 mm from its goal"]),
        ({"apart": float("nan")}, ["torques on the target and on this machine are nan"]),
        ({"apart": 1e-5}, ["torques on the target and on this machine are 1.0e-05"]),
        ({"stack": 12_288, "ram": 0}, ["RAM: 0, the limit", "stack: 12,288, the limit is 12,288"]),
        ({"counts": COUNTS | {"preparation": [4_000_000, 6_000_000]}}, ["sample: 6,100,000, the limit is 6,000,000"]),
    ],
)
def test_what_the_controller_may_take_on_the_target(changed, said):
    found = predictive.failures(predictive.Result(**FOUND | changed))
    assert len(found) == len(said) and all(a.startswith(b) for a, b in zip(found, said, strict=True)), found


def test_the_clock_is_that_of_the_longest_sample():
    result = predictive.Result(**FOUND)
    assert result.samples == [4_200_000, 4_500_000]
    assert result.clock(2.0) == pytest.approx(450.0)
    assert "225 MHz at 1 cycles" in predictive.text(result)


def test_recording_replaces_the_section_of_the_table(tmp_path, monkeypatch):
    monkeypatch.setattr(budget_table, "TABLE", tmp_path / "TABLE.md")
    budget_table.TABLE.write_text("# ELLA\n\nnotes\n")
    predictive.record(predictive.Result(**FOUND))
    once = budget_table.TABLE.read_text()
    predictive.record(predictive.Result(**FOUND | {"stack": 7_000}))
    assert "| stack: worst | 6,000 B |" in once
    assert budget_table.TABLE.read_text() == once.replace("6,000 B", "7,000 B")


RECURSIVE = """
__attribute__((noinline)) int leaf(int n) { volatile int a[8]; a[n & 7] = n; return a[0]; }
__attribute__((noinline)) int other(int n);
__attribute__((noinline)) int again(int n)
{
    volatile int a[16];
    a[n & 15] = n;
    return n > 0 ? other(n - 1) + a[1] : leaf(n);
}
__attribute__((noinline)) int other(int n) { volatile int a[4]; a[n & 3] = n; return again(n) + a[1]; }
int main(void) { return again(3); }
"""


def test_a_recursion_is_counted_as_often_as_stated_and_refused_otherwise(tmp_path):
    """Both functions of the cycle; what a cycle calls is counted once."""
    require_tool("arm-none-eabi-gcc")
    (tmp_path / "a_main.c").write_text(RECURSIVE)
    build = cross.Build(predictive.VARIANT, cross.Sources("a", tmp_path), tmp_path)
    options = ("-fstack-usage", "-ffreestanding", "-nostdlib", "-nostartfiles", "-Wl,-e,main")
    cross.run(build.compiler, *build.flags, "-c", "-fstack-usage", tmp_path / "a_main.c", "-o", tmp_path / "a_main.o")
    cross.run(build.compiler, *build.flags, *options, tmp_path / "a_main.o", "-o", tmp_path / "a.elf")
    frame = {
        x.split(":")[-1].split()[0]: int(x.split("\t")[1]) for x in (tmp_path / "a_main.su").read_text().splitlines()
    }
    build.__dict__["objects"] = [tmp_path / "a_main.o"]
    found = stack.worst_stacks(build, tmp_path / "a.elf", ["main"], {"again": 4})["main"]
    assert found == frame["main"] + 4 * (frame["again"] + frame["other"]) + frame["leaf"]
    with pytest.raises(cross.FirmwareError, match="calls itself: its stack has no bound"):
        stack.worst_stacks(build, tmp_path / "a.elf", ["main"])


@pytest.mark.long
def test_on_the_cortex_m7():
    """In double under QEMU, as `make firmware` measures it."""
    for tool in ("cc", "arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    predictive.OUT.mkdir(exist_ok=True)
    found = predictive.measure()
    assert predictive.failures(found) == []
    assert 0 < found.painted <= found.stack and len(found.samples) == 59
