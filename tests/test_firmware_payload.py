"""A filter that finds a payload on the Cortex-M7: what `make firmware` measures; what is past a limit."""

import sys

import pytest
from conftest import require_tool
from helpers import ROOT

sys.path.insert(0, str(ROOT / "firmware"))

import payload

COUNTS, ERRORS = {"predict": 60_000, "update": 30_000}, {"payload": 4e-3, "tip": 6e-5}
ONE = {"flash": 60_000, "ram": 20_000, "stack": 2_000, "counts": COUNTS, "errors": ERRORS}


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({}, []),
        ({"errors": ERRORS | {"tip": 4.1e-4}}, ["float: the error of the tip is 4.1e-04, the limit is 0.0004"]),
        ({"errors": ERRORS | {"payload": -0.011}}, ["float: the error of the payload is 1.1e-02, the limit is 0.01"]),
        ({"errors": ERRORS | {"payload": float("nan")}}, ["float: the error of the payload is nan, the limit is 0.01"]),
        ({"stack": 8_192}, ["float: stack: 8,192, the limit is 8,192"]),
        ({"counts": COUNTS | {"update": 0}}, ["float: update: 0, the limit is 100,000"]),
    ],
)
def test_what_the_filter_may_take_on_the_target(changed, said):
    found = {(kind, precision): payload.Result(**ONE) for kind in payload.OPTIONS for precision in payload.PRECISIONS}
    found["payload", "float"] = payload.Result(**ONE | changed)
    assert payload.failures(found, ERRORS) == said


def test_the_target_finds_what_this_machine_finds():
    found = {(kind, precision): payload.Result(**ONE) for kind in payload.OPTIONS for precision in payload.PRECISIONS}
    assert payload.failures(found, ERRORS | {"tip": 1e-4}) == [
        "tip: the error is 6.000e-05 on the target and 1.000e-04 on this machine"
    ]


@pytest.mark.long
def test_on_the_cortex_m7():
    """In double and float under QEMU, as `make firmware` measures it."""
    for tool in ("cc", "arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    payload.OUT.mkdir(exist_ok=True)
    found, host = payload.measure()
    assert payload.failures(found, host) == []
    assert dict(payload.rows(found, host))["payload after one second, error"].count("%") == 2
