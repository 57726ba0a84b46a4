"""Scales, units and thinning of curves over time."""

import numpy as np
import pytest

from screwgen.plotting.curves import MOST_POINTS, number, prefixed, scale, thin

T = np.linspace(0.0, 2.0, 2001)


def spiked(size: float) -> np.ndarray:
    """A force of some newtons that begins with one sample of `size`."""
    out = 20 + 10 * np.sin(5 * T)
    out[1] = size
    return out


def test_a_spike_at_the_start_does_not_flatten_the_rest_and_is_told():
    for size in (812.0, -1.48e6):
        found = scale(T, [spiked(size), np.zeros_like(T)], "N")
        assert found.unit == "N" and -10 < found.low < 0.1 and 30 < found.high < 45
        assert found.note == f"start off scale: {number(size)} N at 0.001 s"
    assert number(-1.48e6) == "−1.48·10⁶"


def test_what_happens_later_is_never_cut_off():
    pulse = spiked(20.0)
    pulse[1000] = 800.0
    found = scale(T, [pulse], "N")
    assert found.high > 800 and not found.note


@pytest.mark.parametrize("values", [np.full(2001, 1.88), np.exp(-200 * T), np.r_[5.0, np.full(2000, 3.0)]])
def test_constants_and_starts_that_die_out_for_good_are_shown_whole(values):
    found = scale(T, [values], "N")
    assert found.low < values.min() * found.factor and values.max() * found.factor < found.high and not found.note


def test_two_samples_and_nothing():
    found = scale(np.array([0.0, 1e-3]), [np.array([0.0, 7.0])], "N·m")
    assert found.low < 0 and 7 < found.high < 8
    still = scale(T, [np.zeros_like(T)], "m")
    assert still.low < 0 < still.high


def test_limits_are_on_the_scale_where_they_leave_it_half_to_the_curves():
    near = scale(T, [30 * np.sin(T)], "N·m", [40.0])
    assert near.low < -40 and near.high > 40 and not near.note
    far = scale(T, [30 * np.sin(T)], "N·m", [500.0, 40.0])
    assert 40 < far.high < 60 and far.note == "limits off scale: from ±500 N·m"


def test_units_suit_the_size():
    sizes = [(1.9, "m"), (0.012, "m"), (3e-8, "m"), (4e-4, "rad"), (1.48e6, "N"), (9000.0, "N·m"), (9e4, "rad")]
    assert [prefixed(*x)[1] for x in sizes] == ["m", "mm", "nm", "mrad", "kN", "N·m", "rad"]
    assert all(factor * size < 2e4 or unit == "rad" for size, unit in sizes for factor in prefixed(size, unit)[:1])
    assert scale(T, [0.0123 * np.sin(T)], "m").high == pytest.approx(12.3 * 1.05, rel=0.01)


def test_thinning_keeps_every_peak():
    t, x = np.linspace(0, 10, 100_000), np.zeros(100_000)
    x[[7, 54_321, 99_998]] = 3.0, -2.0, 1.0
    short_t, short_x = thin(t, x)
    assert len(short_t) <= MOST_POINTS + 2 and (np.diff(short_t) > 0).all() and short_t[-1] == t[-1]
    assert {*short_x} == {0.0, 3.0, -2.0, 1.0}
    assert thin(T, T) == (pytest.approx(T), pytest.approx(T))
