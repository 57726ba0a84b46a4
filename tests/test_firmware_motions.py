"""Plans, feedforward, shapers, gains and laws on the Cortex-M7: what `make firmware` measures; what is past a limit."""

import sys

import pytest
from conftest import require_tool
from helpers import ROOT

sys.path.insert(0, str(ROOT / "firmware"))

import motions
import outcome

FOUND = {
    "flash": {"plan": 10_000, "feedforward": 46_000, "shaper": 15_000, "gains": 10_700, "law": 30_000},
    "sizes": {"plan": 136, "feedforward": 8_000, "shaper": 4_500, "gains": 136, "law": 320},
    "stacks": {"plan": 120, "feedforward": 3_000, "shaper": 480, "gains": 40, "law": 1_700},
    "counts": {"plan": [500, 600], "feedforward": [14_000], "shaper": [2_300], "gains": [380], "law": [27_900]},
    "apart": 1e-14,
}


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({}, []),
        ({"apart": float("nan")}, ["numbers on the target and in Python are nan apart"]),
        ({"apart": 1e-11}, ["numbers on the target and in Python are 1.0e-11 apart"]),
        ({"flash": FOUND["flash"] | {"law": 131_072}}, ["flash: 131,072, the limit is 131,072"]),
        ({"counts": FOUND["counts"] | {"feedforward": [100_001]}}, ["feedforward: 100,001, the limit is 100,000"]),
    ],
)
def test_what_they_may_take_on_the_target(changed, said):
    assert motions.failures(motions.Result(**FOUND | changed)) == said


def test_recording_leaves_the_other_sections_of_the_table(tmp_path):
    table = tmp_path / "TABLE.md"
    table.write_text("# ELLA\n\nnotes\n\n## First\n\nold\n\n## Second\n\nkept\n")
    for _ in range(2):
        outcome.write_section(table, "First", "new", [("flash", "1 B")])
        first = "## First\n\nnew.\n\n| figure | value |\n|---|---|\n| flash | 1 B |\n"
        assert table.read_text() == f"# ELLA\n\nnotes\n\n## Second\n\nkept\n\n{first}"


@pytest.mark.long
def test_on_the_cortex_m7():
    """In double under QEMU, as `make firmware` measures it."""
    for tool in ("cc", "arm-none-eabi-gcc", "qemu-system-arm"):
        require_tool(tool)
    motions.OUT.mkdir(exist_ok=True)
    found = motions.measure()
    assert motions.failures(found) == []
    assert {len(found.counts[name]) for name in motions.INSTRUCTIONS} == {1201, 1200}
