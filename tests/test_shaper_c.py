"""The C of a scheduled shaper: it gives what Python gives, and refuses what Python refuses."""

import ctypes
import subprocess
from dataclasses import replace

import numpy as np
import pytest
from conftest import require_tool
from random_plans import ella, rod, shaper_of_ella

import screwgen
from screwgen import UsageError
from screwgen.simulation.shaped import Shaped

STRICT = "-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror -O2".split()
OK, OUTSIDE, SKIPPED, BAD_ARGUMENT, NONFINITE, NOT_STARTED, CLOCK_JUMPED = range(7)
STEP = 1e-3
NAN = float("nan")


@pytest.fixture(scope="module")
def of_ella():
    return shaper_of_ella()


class Compiled:
    """A shaper's C, compiled and loaded."""

    def __init__(self, made, folder, precision="double"):
        self.real = ctypes.c_float if precision == "float" else ctypes.c_double
        for name, text in made.c(STEP).items():
            (folder / name).write_text(text)
        defines = ["-DELLA_REAL_FLOAT"] if precision == "float" else []
        command = [require_tool("gcc"), *STRICT, *defines, "-shared", "-fPIC", "-o", "s.so", "ella_shaper.c", "-lm"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, "")
        library, n = ctypes.CDLL(str(folder / "s.so")), len(made.joints)
        rows = self.real * n * made.sampled(STEP).length
        fields = [("latest", ctypes.c_double), ("newest", ctypes.c_int), ("mark", ctypes.c_int)]
        fields += [("kept", rows), ("rate", rows)]
        self.state = type("State", (ctypes.Structure,), {"_fields_": fields})()
        self._start = library.ella_shaper_start
        self._sample = getattr(library, f"ella_shaper_sample{'_float' * bool(defines)}")
        self.out, self.rates = (self.real * n)(), (self.real * n)()

    def start(self, t, reference):
        reference = (self.real * len(reference))(*reference)
        return self._start(ctypes.byref(self.state), ctypes.c_double(t), reference)

    def sample(self, t, reference, place, rate=(0.0, 0.0, 0.0)):
        given = ((self.real * len(x))(*x) for x in (reference, rate, place))
        return self._sample(ctypes.byref(self.state), ctypes.c_double(t), *given, self.out, self.rates)


@pytest.mark.parametrize(("precision", "error"), [("double", 1e-12), ("float", 1e-5)])
@pytest.mark.parametrize(("kind", "modes"), [("zv", 1), ("zvd", 2), ("ei", 3)])
def test_c_gives_what_python_gives(kind, modes, precision, error, tmp_path):
    made = screwgen.shape(ella(), [0.0, -1.0, -2.0], [0.0, 1.0, 2.0], kind=kind, modes=modes, degree=3)
    own, python = Compiled(made, tmp_path, precision), made.sampled(STEP)
    rng, reference = np.random.default_rng(3), np.array([0.1, -0.3, 0.5])
    python.start(reference)
    assert own.start(5.0, reference) == OK
    for k in range(1, 1500):
        reference = reference + rng.normal(size=3) * 1e-2
        place, rate = 0.9 * np.sin([1e-2 * k, 2e-3 * k]), rng.normal(size=3)
        assert own.sample(5.0 + k * STEP, reference, place, rate) == OK
        wanted = python(reference, rate, place)
        assert np.abs(np.array([own.out, own.rates]) - wanted).max() < error * 3.0


class EvenlyAccelerated(screwgen.PD):
    """A law whose references begin at rest and accelerate evenly: between samples their rates are straight lines."""

    def reference(self, t):
        t, a = max(t, 0.0), np.array(self.q_des)
        return a * t * t / 2, a * t


class ShapedEvenly(Shaped, EvenlyAccelerated):
    """Shaped by its parent, from the references of the other."""


@pytest.mark.parametrize(("kind", "modes"), [("zv", 1), ("zvd", 2), ("ei", 1)])
def test_c_gives_the_references_and_rates_of_a_shaped_law(kind, modes, tmp_path):
    """To rounding where the cubics between samples are exact; of least jerk as close as their error allows."""
    made = screwgen.shape(ella(), [-1.0, -1.0, -2.0], [1.0, 1.0, 2.0], kind=kind, modes=modes, degree=2)
    own, gains = Compiled(made, tmp_path), ((1.0,) * 3, (1.0,) * 3)
    smooth, way = screwgen.PD(*gains, (0.8, -0.5, 0.9), duration=1.0), 0.9
    exact = ShapedEvenly(*gains, (0.8, -0.7, 1.5), shaper=made)
    for law, plain, apart in (
        (exact, EvenlyAccelerated(*gains, exact.q_des), (1e-12, 1e-12)),
        (Shaped.of(smooth, made), smooth, (360 * way * STEP**4 / 384 + 1e-13, 60 * way * STEP**2 / 8)),
    ):
        assert own.start(0.0, plain.reference(0.0)[0]) == OK
        for k in range(1, 1300):
            t = k * STEP
            q, v = plain.reference(t)
            assert own.sample(t, q, law.place(q), v) == OK
            for found, wanted, most in zip((own.out, own.rates), law.reference(t), apart, strict=True):
                assert np.abs(np.array(found) - wanted).max() < most


def test_c_says_what_is_wrong_and_changes_nothing(of_ella, tmp_path):
    own, place, reference = Compiled(of_ella, tmp_path), (0.0, 0.0, 0.0), (0.1, 0.2, 0.3)
    assert own.sample(0.0, reference, place) == NOT_STARTED
    assert own.start(NAN, reference) == own.start(0.0, (NAN, 0.0, 0.0)) == NONFINITE
    assert own.start(2.0, reference) == OK and own.sample(2.001, reference, place) == OK
    assert np.allclose(own.out, reference, atol=1e-15)
    before = bytes(own.state)
    assert own.sample(2.001, reference, place) == own.sample(1.0, reference, place) == CLOCK_JUMPED
    for t, q, x in ((NAN, reference, place), (2.002, (NAN, 0, 0), place), (2.002, reference, (0, NAN, 0))):
        assert own.sample(t, q, x) == NONFINITE
    assert own.sample(2.002, reference, place, (0.0, NAN, 0.0)) == NONFINITE
    assert own._sample(ctypes.byref(own.state), ctypes.c_double(3.0), None, None, None, own.out, None) == BAD_ARGUMENT
    assert bytes(own.state) == before
    assert own.sample(2.002, reference, (9.0, 0.0, 0.0)) == OUTSIDE
    assert own.sample(2.008, (0.4, 0.2, 0.3), place) == SKIPPED
    assert own.sample(1e9, (1.0, 1.0, 1.0), place) == SKIPPED
    assert own.sample(1e9 + 1e-3, (1.0, 1.0, 1.0), place) == OK


@pytest.mark.parametrize("late", [0.4, 0.89, 1.11, 1.4, 2.6])
def test_c_refuses_a_clock_between_its_steps(of_ella, tmp_path, late):
    own, place = Compiled(of_ella, tmp_path), (0.0, 0.0, 0.0)
    assert own.start(2.0, (0.1, 0.2, 0.3)) == OK
    before = bytes(own.state)
    assert own.sample(2.0 + late * STEP, (0.1, 0.2, 0.3), place) == CLOCK_JUMPED and bytes(own.state) == before
    assert own.sample(2.0 + 1.05 * STEP, (0.1, 0.2, 0.3), place) == OK


def test_c_fills_a_long_gap_with_a_straight_line(of_ella, tmp_path):
    """The ring holds the last part of it, as if all had been given."""
    own, place = Compiled(of_ella, tmp_path), (0.0, 0.0, 0.0)
    python, steps = of_ella.sampled(STEP), 3 * of_ella.sampled(STEP).length
    own.start(0.0, (0.0,) * 3)
    python.start([0.0] * 3)
    rate = (1.0 / (steps * STEP),) * 3
    for k in range(1, steps + 1):
        wanted = python([k / steps] * 3, rate, place)
    assert own.sample(steps * STEP, (1.0,) * 3, place, rate) == SKIPPED
    assert np.abs(np.array([own.out, own.rates]) - wanted).max() < 1e-12


def test_c_refuses_references_that_measure_nothing(of_ella, tmp_path):
    own, place = Compiled(of_ella, tmp_path), (0.0, 0.0, 0.0)
    assert own.start(0.0, (1.5e308, 0.0, 0.0)) == NONFINITE and own.start(0.0, (0.0,) * 3) == OK
    before = bytes(own.state)
    assert own.sample(STEP, (-1.5e308, 0.0, 0.0), place) == NONFINITE and bytes(own.state) == before


def test_the_header_has_bounds_as_numbers():
    header = screwgen.shape(rod(), [-1.0], [0.5], degree=0).c(STEP)["arm_shaper.h"]
    assert "joint[0], from -1.0 to 0.5\n" in header and "_REAL(" not in header


def test_c_holds_no_text_of_a_file_but_names():
    made = replace(screwgen.shape(rod(), [-1.0], [1.0], degree=0), vibrates="*/ int injected = 1; /*")
    with pytest.raises(UsageError, match="vibrates: must be one of"):
        made.c(STEP)
