"""The batch of the generated C: the scalar step in every lane, bit for bit; failures."""

import ctypes
import math

import numpy as np
import pytest
from batch_c import ROBOTS, STRICT, WIDTHS, batch, model, one_by_one, scalar, scenarios, stepped, written
from conftest import swept
from helpers import model_of

from screwgen.algorithms import fused
from screwgen.backends.c import batch as c_batch
from screwgen.backends.c import pieces as c_pieces
from screwgen.errors import ScrewgenError, SingularError
from screwgen.integrators import METHODS
from screwgen.ir.replay import run
from screwgen.ir.split import KEPT, split
from screwgen.runtime.batch import NONFINITE, OK, SINGULAR, CompiledBatch, _Batch
from screwgen.runtime.compiled import Compiled
from screwgen.runtime.memory import pointer

BAD_ARGUMENT = 3

# -------- the same operations: the same bits


@pytest.mark.parametrize("width", swept(WIDTHS, 0, 32))
def test_lanes_of_every_width_step_bit_for_bit_as_the_scalar_code(width, name="ella"):
    given = scenarios(name, 19)
    for method in METHODS:
        path, status, _, done = stepped(batch(name, width), *given, method, hold=3)
        assert not status.any() and (done == 3).all()
        assert np.array_equal(path[:, -1], one_by_one(scalar(name), *given, method, 3)), method


@pytest.mark.parametrize(
    "name", ["rigid", "torsion, mount, body", "many modes", "welded", "tapered", "second order", "exact", "drives"]
)
def test_robots_of_every_kind_step_bit_for_bit(name):
    given = scenarios(name, 5)
    for method in ("rk4", "modal_midpoint"):
        path, status, *_ = stepped(batch(name), *given, method)
        assert not status.any()
        assert np.array_equal(path[:, -1], one_by_one(scalar(name), *given, method)), method


def test_single_precision_steps_bit_for_bit():
    given = scenarios("ella", 7)
    path, status, *_ = stepped(batch("ella", single=True), *given)
    assert path.dtype == np.float32 and not status.any()
    assert np.array_equal(path[:, -1], one_by_one(scalar("ella", True), *given))


def test_wide_turns_of_sections_take_the_long_series_and_the_closed_form():
    """Tip sections turned by 0.1, 0.6, 1.9, 2.1 and 3 radians, side by side in one register."""
    x, tau, w_ext = (a.copy() for a in scenarios("torsion, mount, body", 5))
    x[0, 1:] = 0
    x[0, 2] = np.array([0.1, 0.6, 1.9, 2.1, 3.0]) / 2**0.5
    path, status, *_ = stepped(batch("torsion, mount, body", 64), x, tau, w_ext)
    assert not status.any()
    assert np.array_equal(path[:, -1], one_by_one(scalar("torsion, mount, body"), x, tau, w_ext))


def test_polynomial_sine_and_cosine_change_the_step_by_rounding_only():
    given = scenarios("ella", 200)
    exact, other = (stepped(batch("ella", 32, libm), *given)[0][:, -1] for libm in (True, False))
    scale = np.abs(exact).max(axis=2, keepdims=True)
    assert 0 < np.max(np.abs(exact - other) / scale) < 1e-13


def test_long_chains_are_cut_into_pieces():
    """Eleven links: the scalar code is modular, the batch is not; another order of operations."""
    given = scenarios("eleven links", 5)
    b, c = batch("eleven links"), scalar("eleven links")
    path, status, *_ = stepped(b, *given)
    expected = one_by_one(c, *given)
    assert not status.any() and c.project.layout == "modular"
    assert "dynamics_2(" in written("eleven links")["arm_batch.c"]
    scale = np.abs(expected).max(axis=2, keepdims=True)
    assert np.max(np.abs(path[:, -1] - expected) / scale) < 1e-11


def test_pieces_are_the_program(monkeypatch):
    """ELLA in pieces of some 300 operations, and whole."""
    monkeypatch.setattr(c_batch, "LONGEST", 10)
    monkeypatch.setattr(c_pieces, "PIECE", 300)
    options = ("-DELLA_LANE_BYTES=16", "-DELLA_BATCH_LIBM", *STRICT)
    given = scenarios("ella", 4)
    fresh = CompiledBatch(model_of(ROBOTS["ella"]), flags=options)
    path, *_ = stepped(fresh, *given)
    assert np.array_equal(path, stepped(batch("ella"), *given)[0])


@pytest.mark.parametrize("pieces", [1, 2, 7, 100])
def test_split_programs_give_what_the_whole_gives(pieces):
    program = fused.forward_dynamics(model("rigid").chain, "baked")
    rng = np.random.default_rng(0)
    inputs = {name: list(rng.normal(size=size)) for name, size in program.inputs.items()}
    unary = lambda op, x: -x if op == "neg" else getattr(math, op)(x)  # noqa: E731
    whole, guards = run(program, inputs, unary)
    parts, size = split(program, pieces)
    kept, found, checked = [None] * size, {name: {} for name in whole}, []
    for part in parts:
        assert part.operation_count <= len(program.nodes) / pieces + 1
        out, positive = run(part, inputs | {KEPT: kept}, unary)
        checked += positive
        for name, values in out.items():
            kind, _, first = name.partition(":")
            for k, value in enumerate(values):
                if kind == KEPT:
                    kept[int(first) + k] = value
                elif value is not None:
                    found[name][k] = value
    assert {name: [values[k] for k in sorted(values)] for name, values in found.items()} == whole
    assert sorted(checked) == sorted(guards)
    assert sum(part.operation_count for part in parts) == program.operation_count


# -------- batches


def test_batches_of_every_size_give_the_same_numbers():
    """0 to 1000 scenarios: remainders of registers, and every scenario independent of the others."""
    b = batch("ella", flags=("-O2", "-ffp-contract=off"))
    x, tau, w_ext = (np.resize(a, (*a.shape[:-1], 1000)) for a in scenarios("ella", 50))
    whole = stepped(b, x, tau, w_ext, "semi_implicit")[0]
    for size in range(1001):
        part = [np.ascontiguousarray(a[..., :size]) for a in (x, tau, w_ext)]
        path, status, fault, done = stepped(b, *part, "semi_implicit")
        assert np.array_equal(path, whole[..., :size])
        assert (status == OK).all() and (fault == -1).all() and (done == 1).all() and len(done) == size


def test_periods_hold_their_inputs_and_leave_a_path():
    x, *_ = scenarios("ella", 11)
    rng = np.random.default_rng(1)
    tau, w_ext = rng.normal(size=(4, 3, 11)), rng.normal(size=(4, 12, 11))
    path, _, _, done = stepped(batch("ella"), x, tau, w_ext, "modal_midpoint", periods=4, hold=5, dt=1e-4)
    assert (done == 20).all()
    for k in range(4):
        x = one_by_one(scalar("ella"), x, tau[k : k + 1], w_ext[k : k + 1], "modal_midpoint", 5, 1e-4)
        assert np.array_equal(path[:, k + 1], x)


def test_scenarios_may_have_parameters_of_their_own():
    given, m, c = scenarios("ella", 6), model("ella"), Compiled(model("ella"), flags=STRICT)
    p = np.tile(m.parameter_values, (6, 1))
    p[:, m.parameter_names.index("forearm.bodies[0].mass")] = np.linspace(0.5, 4, 6)
    path, *_ = stepped(batch("ella"), *given, p=p)
    for i in range(6):
        c.prepare(p[i])
        assert np.array_equal(path[:, -1, :, [i]].transpose(1, 2, 0), one_by_one(c, *(a[..., [i]] for a in given)))


def test_openmp_changes_no_bit():
    given = scenarios("ella", 50)
    alone = stepped(batch("ella"), *given, periods=3)
    parallel = batch("ella", flags=(*STRICT, "-fopenmp"))
    for threads in (1, 2, 5):
        parallel.library.omp_set_num_threads(threads)
        several = stepped(parallel, *given, periods=3)
        assert all(np.array_equal(a, b) for a, b in zip(alone, several, strict=True))


# -------- failures


@pytest.mark.parametrize("method", METHODS)
def test_a_failing_scenario_is_frozen_and_its_neighbours_go_on(method):
    x, tau, w_ext = (a.copy() for a in scenarios("ella", 9))
    good = stepped(batch("ella", 64), x, tau, w_ext, method, periods=3)[0]
    x[0, 0, 2], x[1, 4, 3], tau[0, 1, 5], w_ext[0, 7, 8] = np.nan, 1e200, np.inf, -np.inf
    bad = [2, 3, 5, 8]
    path, status, fault, done = stepped(batch("ella", 64), x, tau, w_ext, method, periods=3)
    fine = [i for i in range(9) if i not in bad]
    assert (status[bad] == NONFINITE).all() and not status[fine].any() and (fault == -1).all()
    assert (done[bad] == 0).all() and (done[fine] == 3).all()
    assert np.array_equal(path[..., fine], good[..., fine])
    assert all(np.array_equal(path[:, k][..., bad], x[..., bad], equal_nan=True) for k in range(4))


@pytest.mark.parametrize("width", WIDTHS)
def test_a_singular_scenario_is_blamed_on_its_link_as_by_the_scalar_code(width):
    """A rod that spins about its own axis without spin inertia carries another: singular where that is in line."""
    angles = np.array([0.5, 0.0, -1.2, 0.0, 0.9])
    x = np.zeros((2, 2, 5))
    x[0, 1] = angles
    x[1, 0, 3] = np.nan
    path, status, fault, done = stepped(batch("rods", width), x, np.ones((1, 2, 5)), np.zeros((1, 12, 5)))
    assert list(status) == [OK, SINGULAR, OK, NONFINITE, OK]
    assert list(fault) == [-1, 0, -1, -1, -1] and list(done) == [1, 0, 1, 0, 1]
    assert np.array_equal(path[:, 1, :, 1], x[:, :, 1])


def test_a_motion_that_diverges_is_frozen_where_the_scalar_code_stops():
    """Explicit Euler far beyond its step: every scenario ends, each at its own time, in a finite state."""
    given = scenarios("ella", 9)
    path, status, _, done = stepped(batch("ella"), *given, "euler", periods=40, dt=3e-4)
    assert (status != OK).all() and len(set(done)) > 1 and np.isfinite(path).all()
    for i, k in enumerate(done):
        one = [a[..., [i]] for a in given]
        assert np.array_equal(path[:, k, :, [i]], path[:, -1, :, [i]])
        assert np.array_equal(path[:, k, :, i], one_by_one(scalar("ella"), *one, "euler", int(k), 3e-4)[..., 0])
        with pytest.raises(SingularError if status[i] == SINGULAR else ScrewgenError):
            one_by_one(scalar("ella"), *one, "euler", int(k) + 1, 3e-4)


def test_scenarios_that_have_failed_before_are_left_alone():
    b, (x, tau, w_ext) = batch("ella"), scenarios("ella", 5)
    status, q, v = np.array([0, 1, 0, 2, 7], np.int32), x[0].copy(), x[1].copy()
    given = _Batch(count=5, stride=5, q=pointer(q), v=pointer(v), tau=pointer(tau), w_ext=pointer(w_ext))
    given.status = pointer(status)
    assert call(b, given) == OK
    moved = stepped(b, x, tau, w_ext)[0][:, -1]
    assert np.array_equal(np.array([q, v])[..., ::2][..., :2], moved[..., [0, 2]])
    assert np.array_equal(np.array([q, v])[..., [1, 3, 4]], x[..., [1, 3, 4]]) and list(status) == [0, 1, 0, 2, 7]


def call(b: CompiledBatch, given, constants=..., dt=1e-5, periods=1) -> int:
    c = b.constants(np.atleast_2d(b.model.parameter_values)) if constants is ... else constants
    where = None if c is None else pointer(c)
    place = None if given is None else ctypes.byref(given)
    step = getattr(b.library, f"{b.model.robot.name}_step_batch_rk4")
    return step(where, place, ctypes.c_double(dt), periods)


def test_bad_arguments_are_refused_and_nothing_is_done():
    b, (x, *_) = batch("ella"), scenarios("ella", 5)
    q, v, status = x[0].copy(), x[1].copy(), np.zeros(5, np.int32)

    def given(**other):
        good = {"count": 5, "stride": 5, "q": pointer(q), "v": pointer(v), "status": pointer(status)}
        return _Batch(**(good | other))

    refused = [given(**{name: value}) for name, value in (("count", -1), ("stride", 4), ("hold", -1))]
    refused += [given(**{name: None}) for name in ("q", "v", "status")]
    assert [call(b, x) for x in refused] == [BAD_ARGUMENT] * 6
    assert [call(b, given(), dt=dt) for dt in (0.0, -1e-3, 5e-324, math.nan, math.inf)] == [BAD_ARGUMENT] * 5
    assert [call(b, None), call(b, given(), None), call(b, given(), periods=-1)] == [BAD_ARGUMENT] * 3
    assert np.array_equal([q, v], x) and not status.any()
    assert call(b, given(count=0, q=None, v=None, status=None)) == call(b, given(), periods=0) == OK
    assert np.array_equal([q, v], x)
