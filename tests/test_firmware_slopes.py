"""A step with its derivatives on the Cortex-M7: what `make firmware` measures; what is past a limit."""

import sys

import pytest
from conftest import require_tool
from helpers import ROOT

sys.path.insert(0, str(ROOT / "firmware"))

import slopes

COUNTS = {"slopes": 25_000, "step": 3_500}
ONE = {"flash": 60_000, "step": 22_000, "ram": 15_000, "stack": 3_000, "counts": COUNTS, "apart": 1e-13}


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({}, []),
        ({"apart": 1e-10}, ["modular, double: numbers are 1.0e-10 apart, the limit is 1e-11"]),
        ({"apart": float("nan")}, ["modular, double: numbers are nan apart, the limit is 1e-11"]),
        ({"stack": 8_192}, ["modular, double: stack: 8,192, the limit is 8,192"]),
        ({"counts": COUNTS | {"slopes": 0}}, ["modular, double: slopes: 0, the limit is 100,000"]),
    ],
)
def test_what_a_step_with_derivatives_may_take_on_the_target(changed, said):
    found = {kind: slopes.Result(**ONE) for kind in slopes.KINDS}
    found["modular", "double"] = slopes.Result(**ONE | changed)
    assert slopes.failures(found) == said


def test_rows_have_both_precisions():
    found = {kind: slopes.Result(**ONE) for kind in slopes.KINDS}
    assert dict(slopes.rows(found))["fused, over a step alone"] == "7.1; 7.1"


@pytest.mark.long
def test_on_the_cortex_m7():
    """In double and float under QEMU, as `make firmware` measures it."""
    for tool in ("cc", "arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    slopes.OUT.mkdir(exist_ok=True)
    found = slopes.measure()
    assert slopes.failures(found) == []
    assert all(r.counts["slopes"] < 9 * r.counts["step"] for r in found.values())
