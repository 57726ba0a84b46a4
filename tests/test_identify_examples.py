"""Examples are identified from synthetic logs: eight numbers, 30 % off at the start, 1 % of noise on every sensor."""

import pytest
from synthetic_logs import logged

import screwgen

DAMPED = ("damping.ratio", "drives[0].damping")
"""What is known within 5 %."""


@pytest.mark.parametrize(
    ("name", "seconds", "step"),
    [
        ("gantry", 4.0, 2e-3),
        ("space_arm", 2.0, 2e-3),
        pytest.param("elastic_joint", 10.0, 1e-3, marks=pytest.mark.long),
        pytest.param("gantry", 10.0, 1e-3, marks=pytest.mark.long),
        pytest.param("space_arm", 10.0, 1e-3, marks=pytest.mark.long),
    ],
)
@pytest.mark.filterwarnings("ignore::screwgen.ModelValidityWarning")
def test_eight_numbers_are_found_again(name, seconds, step):
    """Within 1 %, damping within 5 %, ratios from ten seconds; the base of one floats, gears of one are elastic."""
    model, log, columns, true = logged(name, seconds, step)
    found = screwgen.identify(model, log, free=list(true), sensors=columns, window=0.5)
    for number, value in true.items():
        one = found[number]
        if "ratio" in number and seconds < 10:
            assert one.low < value < one.high, number
        else:
            assert one.value == pytest.approx(value, rel=0.05 if any(x in number for x in DAMPED) else 0.01), number
    assert not found.undetermined and not found.notes
