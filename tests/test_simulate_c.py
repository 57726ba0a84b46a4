"""Runs that are stepped in C: the same as in NumPy, in every way that they are asked for; what a stopped run keeps."""

import os
import shutil
import signal
import subprocess
import sys
import time
import warnings
from dataclasses import astuple
from itertools import pairwise

import numpy as np
import pytest
from conftest import require_tool
from helpers import model_of
from test_simulate import START, soft, soft_dict

from screwgen import PD, SingularError, UsageError
from screwgen.runtime.compiled import Compiled
from screwgen.simulation import compiled_runs
from screwgen.simulation.integrate import DivergedError
from screwgen.simulation.simulate import simulate

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LAW = PD((40.0, 40.0, 20.0), (15.0, 15.0, 4.0), (0.3, -0.2, 0.4), duration=0.05, tau_max=(9.0, 30.0, 9.0))
WRENCH = np.arange(12.0).reshape(2, 6)


@pytest.fixture(autouse=True)
def _compiler():
    require_tool("cc")


def assert_same(a, b, tolerance=1e-9):
    assert astuple(a)[0] == astuple(b)[0]
    assert list(a.arrays) == list(b.arrays)
    for name, x in a.arrays.items():
        y = b.arrays[name]
        assert x.shape == y.shape
        assert np.abs(x - y).max(initial=0.0) <= tolerance * max(1.0, np.abs(y).max(initial=0.0)), name


WAYS = {
    "nothing": {},
    "torques": {"controller": [1.0, -2.0, 0.5]},
    "a law": {"controller": LAW},
    "a law without path or limit": {"controller": PD((40.0,) * 3, (5.0,) * 3, (0.3, -0.2, 0.4))},
    "a function": {"controller": lambda t, q, v: -q[:3] - [t, v[0], 0.0]},
    "wrenches": {"w_ext": WRENCH, "controller": LAW},
    "a function of wrenches": {"w_ext": lambda t, q, v: (1 + t) * WRENCH, "controller": LAW},
    "parameters": {"parameters": {"fore.bodies[0].mass": 2.5, "upper.length": 0.7, "gravity[0]": 1.0}},
    "a shorter last step": {"duration": 0.0995, "controller": LAW},
    "some samples": {"every": 7, "controller": LAW},
    "some samples and the end": {"every": 50, "controller": lambda t, q, v: [t, t, t]},
    "one step": {"duration": 1e-4},
}


@pytest.mark.parametrize("way", WAYS)
def test_c_and_casadi_make_the_same_run(way):
    given = {"duration": 0.1, "step": 1e-3} | START | WAYS[way]
    a, b = (simulate(soft(), **given, backend=backend) for backend in ("c", "casadi"))
    assert_same(a, b)


def test_a_law_in_c_is_the_law_in_python():
    """Also a class of one's own, which is called."""

    class Mine(PD):
        def __call__(self, t, q, v):
            return super().__call__(t, q, v)

    mine = Mine(*(getattr(LAW, name) for name in ("kp", "kd", "q_des", "duration", "tau_max")))
    runs = [simulate(soft(), 0.1, 1e-3, controller=law, **START) for law in (LAW, mine)]
    assert_same(*runs, tolerance=1e-11)
    law = LAW.starting_at(START["q0"])
    expected = [law(t, q, v) for t, q, v in zip(runs[0].t, runs[0].q, runs[0].v, strict=True)]
    assert np.allclose(runs[0].tau, expected, rtol=1e-12, atol=1e-12)
    assert (np.abs(runs[0].tau[:, 0]) == 9.0).any() and np.ptp(runs[0].tau[:, 1]) > 1.0


def test_samples_are_those_of_the_whole_run():
    whole, some = (simulate(soft(), 0.1, 1e-3, controller=LAW, every=n, **START) for n in (1, 30))
    places = [0, 30, 60, 90, 100]
    for name, values in some.arrays.items():
        assert np.array_equal(values, whole.arrays[name][places])


def test_c_is_taken_where_it_can_be(monkeypatch):
    calls = []
    real = compiled_runs.CompiledRuns.__call__
    monkeypatch.setattr(compiled_runs.CompiledRuns, "__call__", lambda self, *a: calls.append(1) or real(self, *a))
    simulate(soft(), 0.01, 1e-3)
    assert calls == [1]
    simulate(soft(), 0.01, 1e-3, backend="casadi")
    simulate(soft(), 0.01, 1e-3, form="dae")
    monkeypatch.setenv("CC", "no-such-compiler")
    fallen_back = simulate(model_of(soft_dict()), 0.01, 1e-3)
    assert calls == [1] and len(fallen_back.t) == 11
    for arguments, message in (
        ({"backend": "c", "form": "dae"}, "'c' steps the joint form, not 'dae'"),
        ({"backend": "fortran"}, "c or casadi"),
        ({"every": 0}, "every is 0"),
        ({"store": "run.txt"}, "suffix"),
    ):
        with pytest.raises(UsageError, match=message):
            simulate(soft(), 0.01, 1e-3, **arguments)


def test_a_compiler_that_fails_is_said_once_and_done_without(monkeypatch):
    model = model_of(soft_dict())
    for CC, message in (("false", "false failed"), ("cc 'x", r"is no command \(No closing quotation\); mend")):
        monkeypatch.setenv("CC", CC)
        with pytest.warns(UserWarning, match=f"goes on in NumPy: .*{message}"):
            run = simulate(model, 0.005, 1e-3)
        assert len(run.t) == 6
    monkeypatch.setenv("CC", "false")
    with pytest.raises(Exception, match="false failed"):
        simulate(model, 0.005, 1e-3, backend="c")


def test_the_earlier_name_of_a_back_end_is_taken():
    runs = [simulate(soft(), 0.005, 1e-3, backend=name, **START) for name in ("numpy", "casadi")]
    assert np.array_equal(runs[0].q, runs[1].q)


@pytest.mark.parametrize("backend", ["c", "casadi"])
def test_what_goes_wrong_is_said_alike(backend):
    stiff = model_of(soft_dict() | {"links": [dict(soft_dict()["links"][0], modes={"bending_z": 4})]})
    with pytest.raises(DivergedError, match=r"^t = 0\.\d+ s: the integrator 'euler' diverged; .*modal_midpoint$"):
        simulate(stiff, 1.0, 1e-3, integrator="euler", backend=backend)
    with pytest.raises(
        DivergedError, match=r"^t = 0(\.\d+)? s: the motion diverged: with these gains .* unstable at a step of 10 ms"
    ):
        simulate(soft(), 1.0, 1e-2, controller=PD((1e5,) * 3, (1e3,) * 3, (1.0,) * 3), backend=backend)
    with pytest.raises(UsageError, match=r"^t = 0\.005 s: the controller gives a NaN"):
        simulate(
            soft(), 0.01, 1e-3, controller=lambda t, q, v: [0.0, 0.0, 0.0 / (t < 0.0045) if t < 0.0045 else np.nan]
        )
    with pytest.raises(UsageError, match=r"^t = 0 s: the controller gives an array of shape \(2,\)"):
        simulate(soft(), 0.01, 1e-3, controller=lambda t, q, v: [0.0, 0.0], backend=backend)
    with pytest.raises(UsageError, match=r"^PD: q_des has length 2; the robot has 3 joint coordinates$"):
        simulate(soft(), 0.01, 1e-3, controller=PD((1.0,) * 2, (1.0,) * 2, (0.0,) * 2), backend=backend)


def test_a_singular_posture_on_the_way_names_the_link():
    wrist = {
        "name": "wrist",
        "length": 0.5,
        "section": {"rhoA": 1.0, "rhoIp": 0.01},
        "joint": {"axes": ["x", "z", "x"]},
    }
    model = model_of({"name": "ball", "gravity": [0.0, 0.0, 0.0], "links": [wrist]})
    for backend in ("c", "casadi"):
        with pytest.raises(SingularError, match=r"^t = 0 s: the joint of link 'wrist' is singular"):
            simulate(model, 0.01, 1e-3, backend=backend)
    with pytest.raises(SingularError, match=r"^t = 0\.01 s: the joint of link 'wrist' is singular"):
        simulate(model, 0.02, 1e-2, q0=[0.0, 1.0, 0.0], v0=[0.0, -100.0, 0.0], integrator="euler", backend="c")


def test_parameters_that_no_robot_has_are_refused():
    with pytest.raises(UsageError, match=r"^parameters: fore.length is -1; it must be > 0"):
        simulate(soft(), 0.01, 1e-3, parameters={"fore.length": -1.0}, backend="c")


def test_progress_and_interruption_come_between_calls():
    seen = []
    simulate(soft(), 400.0, 1e-3, progress=lambda done, steps: seen.append((done, time.perf_counter())), every=1000)
    counts = [done for done, _ in seen]
    assert counts[0] == 0 and counts[-1] == 400_000 and counts == sorted(set(counts)) and len(counts) > 5
    assert max(b - a for (_, a), (_, b) in pairwise(seen)) < 1.0

    def stop(done, steps):
        if done:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        simulate(soft(), 400.0, 1e-3, progress=stop, every=1000)


# -------- what is stored meanwhile


@pytest.mark.parametrize("backend", ["c", "casadi"])
@pytest.mark.parametrize("suffix", [".npz", ".csv"])
def test_a_stored_run_is_the_saved_one(tmp_path, suffix, backend):
    given = {"duration": 0.0105, "step": 1e-3, "controller": LAW, "every": 2, "backend": backend} | START
    run = simulate(soft(), **given, store=tmp_path / f"a{suffix}")
    run.save(tmp_path / f"b{suffix}")
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()
    assert sorted(os.listdir(tmp_path)) == [f"a{suffix}", f"b{suffix}"]


def read(folder, suffix):
    """What a stopped run left: all columns."""
    if suffix == ".csv":
        return np.loadtxt(folder / "run.part.csv", delimiter=",", skiprows=1)
    part = np.load(folder / "run.part.npy")
    return np.column_stack([part[name].reshape(len(part), -1) for name in part.dtype.names])


@pytest.mark.parametrize("backend", ["c", "casadi"])
@pytest.mark.parametrize("suffix", [".npz", ".csv"])
def test_a_run_that_fails_or_is_stopped_keeps_what_it_had(tmp_path, suffix, backend):
    def controller(t, q, v):
        if t > 0.00755:
            raise stop
        return LAW(t, q, v)

    (tmp_path / f"run{suffix}").write_text("an older run")
    given = {"step": 1e-3, "controller": controller, "backend": backend} | START
    left = f"run.part{'.npy' if suffix == '.npz' else suffix}"
    for stop in (KeyboardInterrupt(), UsageError("no torque")):
        with pytest.raises(type(stop), match=f"(interrupted|no torque); {left} keeps the run until then$"):
            simulate(soft(), 0.02, store=tmp_path / f"run{suffix}", **given)
        assert np.array_equal(read(tmp_path, suffix), simulate(soft(), 0.007, **given).table)
        assert sorted(os.listdir(tmp_path)) == sorted([f"run{suffix}", left])
        assert (tmp_path / f"run{suffix}").read_text() == "an older run"
        with pytest.raises(UsageError, match=f"{left}: is there already: it keeps a run .*; move it away"):
            simulate(soft(), 0.007, store=tmp_path / f"run{suffix}", step=1e-3, backend=backend)
        assert np.array_equal(read(tmp_path, suffix), simulate(soft(), 0.007, **given).table)
        (tmp_path / left).unlink()
    simulate(soft(), 0.007, store=tmp_path / f"run{suffix}", **given)
    assert os.listdir(tmp_path) == [f"run{suffix}"]


@pytest.mark.parametrize("suffix", [".npz", ".csv"])
def test_a_stored_run_follows_no_planted_link(tmp_path, suffix):
    part = tmp_path / f"run.part{'.npy' if suffix == '.npz' else suffix}"
    for target in ("precious", "none"):
        (tmp_path / "precious").write_text("mine")
        part.symlink_to(target)
        with pytest.raises(UsageError, match="is there already"):
            simulate(soft(), 0.005, 1e-3, store=tmp_path / f"run{suffix}")
        assert (tmp_path / "precious").read_text() == "mine" and part.is_symlink()
        part.unlink()
    assert os.listdir(tmp_path) == ["precious"]


@pytest.mark.parametrize("suffix", [".npz", ".csv"])
def test_an_output_keeps_the_mode_of_what_it_replaces(tmp_path, suffix):
    """Also while it grows, and where it is saved in one go; a new one has that of any new file."""
    path = tmp_path / f"run{suffix}"
    (tmp_path / "any").touch()
    modes = []

    def controller(t, q, v):
        modes.extend(entry.stat().st_mode & 0o777 for entry in tmp_path.glob("run.part.*"))
        return (0.0,) * 3

    simulate(soft(), 0.003, 1e-3, store=path, controller=controller)
    assert {path.stat().st_mode, *((0o100000 | mode) for mode in modes)} == {(tmp_path / "any").stat().st_mode}
    path.chmod(0o600)
    modes.clear()
    simulate(soft(), 0.003, 1e-3, store=path, controller=controller).save(path)
    assert modes and set(modes) == {0o600} and path.stat().st_mode & 0o777 == 0o600


def test_a_run_that_never_began_leaves_nothing(tmp_path):
    for bad in ({"q0": [1.0]}, {"controller": lambda t, q, v: None}, {"integrator": "heun"}):
        with pytest.raises(UsageError):
            simulate(soft(), 0.01, 1e-3, store=tmp_path / "run.npz", **bad)
        assert os.listdir(tmp_path) == []


ENDLESS = """
import sys
sys.path.insert(0, "tests")
from test_simulate import soft, START
from screwgen import simulate
simulate(soft(), 4e3, 1e-3, store=sys.argv[1], every=int(sys.argv[2]), **START)
"""


@pytest.mark.parametrize(("suffix", "every"), [(".npz", 1), pytest.param(".csv", 10, marks=pytest.mark.long)])
def test_a_killed_run_leaves_a_file_that_can_be_read(tmp_path, monkeypatch, suffix, every):
    """Killed at once, in the middle of its work, and read while it runs; its bits are those of the same compiler."""
    monkeypatch.setenv("CC", shutil.which("cc"))
    path = tmp_path / f"run{suffix}"
    part = tmp_path / f"run.part{'.npy' if suffix == '.npz' else suffix}"
    given = [sys.executable, "-c", ENDLESS, str(path), str(every)]
    with subprocess.Popen(given, cwd=ROOT) as p:
        for _ in range(600):
            time.sleep(0.1)
            long = part.exists() and part.stat().st_size > 100_000
            if long and (suffix == ".csv" or len(np.load(part, mmap_mode="r"))):  # the header counts rows behind them
                break
        if suffix == ".npz":
            growing = len(read(tmp_path, suffix))
        p.kill()
    assert p.returncode == -signal.SIGKILL and os.listdir(tmp_path) == [part.name]
    if suffix == ".csv":
        whole, _, _ = part.read_text().rpartition("\n")
        part.write_text(whole + "\n")
    found = read(tmp_path, suffix)
    expected = simulate(model_of(soft_dict()), found[-1, 0] + 0.1, 1e-3, every=every, **START).table[: len(found)]
    assert len(found) > 100 and np.array_equal(found, expected)
    assert suffix == ".csv" or 0 < growing <= len(found)


def test_runs_in_threads_keep_apart():
    from concurrent.futures import ThreadPoolExecutor

    masses = np.linspace(0.5, 2.0, 6)
    run = lambda m: simulate(soft(), 1.0, 1e-3, parameters={"fore.bodies[0].mass": m}, **START).q  # noqa: E731
    alone = [run(m) for m in masses]
    with ThreadPoolExecutor(4) as pool:
        assert all(np.array_equal(a, b) for a, b in zip(pool.map(run, masses), alone, strict=True))


def test_no_warning_and_no_second_compilation(monkeypatch):
    model = model_of(soft_dict())
    simulate(model, 0.005, 1e-3)
    monkeypatch.setattr(Compiled, "__init__", lambda *a, **k: pytest.fail("compiled again"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        simulate(model, 0.005, 1e-3)
