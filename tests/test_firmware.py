"""The firmware measurements: a short run against the budgets, and that the measuring itself can be trusted."""

import csv
import subprocess
import sys

import pytest
from conftest import require_tool
from helpers import ROOT

sys.path.insert(0, str(ROOT / "firmware"))

import budget_table as table
import cross
import emulate
import stack
import targets

QUICK = {("fused", "baked"), ("modular", "runtime")}


@pytest.mark.long
def test_on_the_cortex_m4f():
    """What `make firmware` does for all targets.

    Self-check, 1,000 steps and budgets of float, fused and modular; the exit status says whether all of it holds.
    """
    for tool in ("cc", "arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    command = [sys.executable, ROOT / "firmware" / "firmware.py", "--quick"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stderr.count("all checks passed") == len(QUICK)
    assert "all within budget" in done.stdout
    with (ROOT / "build" / "firmware.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert {(r["layout"], r["parameters"]) for r in rows} == QUICK
    for row in rows:
        assert 0 < int(row["stack_painted"]) <= int(row["stack"])
        assert 1e-9 < float(row["tip_error"]) < 1e-5, "float that is as good as double was not float"
        assert int(row["step_rk4"]) > 3 * int(row["step_euler"])
        owned = ("constants", "state", "input", "output", "work")
        assert int(row["ram"]) >= sum(int(row[f"sizeof_{name}"]) for name in owned)


# -------- budgets


def row_of(name: str = "m4f_float_fused_baked", **figures) -> table.Row:
    variant = next(v for v in targets.variants([targets.TARGETS["m4f"]]) if v.name == name)
    sizes = dict.fromkeys(table.SIZES, 1000) | {k: v for k, v in figures.items() if k in table.SIZES}
    counts = {"forward_dynamics": 1000} | {k: v for k, v in figures.items() if k not in table.SIZES}
    return table.Row(variant, sizes, counts, {"angle": 1e-7, "tip": figures.pop("tip", 1e-7)})


def verdict(row: table.Row, compiler: str = "gcc 1", **changes) -> table.Verdict:
    given = {
        "tolerance": 0.02,
        "limits": table.budgets()["limits"],
        "columns": ["flash", "forward_dynamics"],
        "compilers": {"m4f": "gcc 1"},
        "recorded": {row.variant.name: [1000, 1000]},
    }
    return table.judge([row], given | changes, {"m4f": compiler})


@pytest.mark.parametrize("name", ["flash", "forward_dynamics"])
def test_a_regression_beyond_the_tolerance_fails(name):
    assert verdict(row_of(**{name: 1020})) == table.Verdict([], [], [])
    assert verdict(row_of(**{name: 1021})).failures == [f"m4f_float_fused_baked: {name} 1,021, budget 1,000 and 2%"]
    assert verdict(row_of(**{name: 979})).better == [f"m4f_float_fused_baked: {name} 979, budget 1,000"]


def test_limits_hold_with_every_compiler():
    """Recorded figures are compared for the compiler that they belong to; the limits always are."""
    other = verdict(row_of(forward_dynamics=5999), "gcc 2")
    assert not other.failures and "another compiler" in other.remarks[0]
    assert "the limit is 6,000" in verdict(row_of(forward_dynamics=6001), "gcc 2").failures[0]
    assert "the limit is 24,576" in verdict(row_of("m4f_float_modular_baked", flash=24577), "gcc 2").failures[0]
    assert not verdict(row_of("m4f_float_fused_baked", flash=24577), "gcc 2").failures
    assert "tip_error" in verdict(row_of(tip=1e-4)).failures[0]


def test_a_row_without_a_budget_fails():
    assert verdict(row_of(), recorded={}).failures == ["m4f_float_fused_baked: no budget is recorded"]


def test_every_row_has_its_budget():
    """Every variant of every target, and a figure for every column."""
    given = table.budgets()
    assert set(given["recorded"]) == {v.name for v in targets.variants(list(targets.TARGETS.values()))}
    assert {len(figures) for figures in given["recorded"].values()} == {len(given["columns"])}


# -------- instruments


def counted(**counts) -> emulate.Findings:
    return emulate.Findings(counts={"known": [2002, 4002], "empty": [2], "call": [102]} | counts)


def test_a_counter_that_errs_is_refused():
    found = counted()
    emulate.check_counter(found)
    assert found.counts == {"call": [100]}
    with pytest.raises(cross.FirmwareError, match="the counter errs"):
        emulate.check_counter(counted(known=[2002, 4001]))


def test_a_program_that_stops_early_is_refused():
    with pytest.raises(cross.FirmwareError, match="stopped early"):
        emulate.read_findings("size state 72\nfailed\n")
    with pytest.raises(cross.FirmwareError, match="deeper than"):
        emulate.read_findings(f"stack step_rk4 {emulate.PAINTED}\ndone\n")


@pytest.mark.parametrize(
    "text, taken",
    [
        ("   16: \tpush\t{r4, r5, r6, lr}", 16),
        ("   16: \tstmdb\tsp!, {r4, r5, r6, r7, r8, r9, sl, fp, lr}", 36),
        ("   16: \tvpush\t{d8-d15}", 64),
        ("   16: \tvpush\t{s16}", 4),
        ("   16: \tsub\tsp, #364\t@ 0x16c", 364),
        ("   16: \tsub.w\tsp, sp, #612\t@ 0x264", 612),
        ("   16: \tsubw\tsp, sp, #1204\t@ 0x4b4", 1204),
        ("   16: \tstr.w\tlr, [sp, #-4]!", 4),
        ("   16: \tadd.w\tsp, sp, #612\t@ 0x264", 0),
        ("   16: \tvstr\ts0, [sp, #12]", 0),
    ],
)
def test_what_arm_instructions_take_from_the_stack(text, taken):
    assert stack.arm_bytes(text) == taken


def test_calls_are_read_from_the_disassembly():
    """Calls and tail calls to the beginning of a function count, branches inside one do not."""
    for text, found in (
        ("   16: \tbl\t98b4 <cosf>", ["98b4"]),
        ("   16: \tb.w\t98b4 <cosf>", ["98b4"]),
        ("   16: \tbne.n\t98c0 <cosf+0xc>", []),
        ("   16: \tcbz\tr0, 98b4 <cosf>", ["98b4"]),
        ("   16: \tbx\tlr", []),
    ):
        assert stack.ARM_CALL.findall(text) == found, text
    for text, found in (
        ("80001bca:\tjal\t80001098 <call_of>", ["80001098"]),
        ("80001bca:\tjal\tra,80001098 <call_of>", ["80001098"]),
        ("80001bca:\tj\t80001098 <call_of>", ["80001098"]),
        ("80001bca:\tjalr\t-44(ra) # 80001098 <call_of>", ["80001098"]),
        ("80001bca:\tbeqz\ta0,8000a76e <forward+0x1a>", []),
        ("80001bca:\tflw\tfa4,48(a6) # 8000f030 <table>", []),
    ):
        assert stack.RISC_V_CALL.findall(text) == found, text
