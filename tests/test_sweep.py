"""Rollouts on executors and sweeps into a store: equal bits, stopped and gone on with, refusals."""

import os
import subprocess
import sys
from concurrent.futures import Future, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest
from helpers import ROOT, model_of

from screwgen import UsageError, rollout, sweep
from screwgen.simulation.rollout import Rollout

LINK = {"length": 0.5, "section": {"rhoA": 2.0, "EIz": 400.0}, "bodies": [{"at": "tip", "mass": 1.5}]}
LINK |= {"modes": {"bending_y": 1}, "joint": {"axes": ["z"]}}
ARM = {"name": "swept", "gravity": [0.0, -9.81, 0.0], "links": [{"name": "a", **LINK}]}
HOW = {"step": 1e-3, "steps": 3, "chunk": 8}


@pytest.fixture(scope="module")
def model():
    return model_of(ARM)


def drawn(rng, n: int) -> dict:
    x0 = np.zeros((n, 4))
    x0[:, 0] = rng.uniform(-1, 1, n)
    return {"x0": x0, "parameters": {"a.bodies[0].mass": rng.uniform(1, 2, n)}}


class Losing:
    """An executor that loses every third chunk once, and calls the rest at once."""

    def __init__(self):
        self.calls = 0

    def submit(self, call, *args):
        out, self.calls = Future(), self.calls + 1
        if self.calls % 3 == 0:
            out.set_exception(ConnectionError("the worker is gone"))
        else:
            try:
                out.set_result(call(*args))
            except Exception as error:
                out.set_exception(error)
        return out


def test_results_do_not_depend_on_the_executor(model, tmp_path):
    alone = sweep(model, drawn, 50, tmp_path / "one.npy", **HOW)
    assert alone.values.shape == (50, 4) and alone.ok.all()
    rng = np.random.default_rng([0, 1])
    mine = rollout(model, **drawn(rng, 8), step=1e-3, steps=3)
    assert np.array_equal(alone.values[8:16], mine.x[:, -1])
    with ThreadPoolExecutor(2) as threads:
        for name, executor in (("two", threads), ("lossy", Losing())):
            other = sweep(model, drawn, 50, tmp_path / f"{name}.npy", **HOW, executor=executor)
            assert np.array_equal(alone.values, other.values), name


def test_rollouts_of_arrays_on_executors(model, monkeypatch):
    monkeypatch.setattr("screwgen.simulation.chunks.CHUNK", 16)
    given = drawn(np.random.default_rng(0), 50) | {"step": 1e-3, "steps": 3}
    alone = rollout(model, **given)
    with ThreadPoolExecutor(2) as threads:
        for executor in (threads, Losing()):
            run = rollout(model, **given, executor=executor)
            assert isinstance(run, Rollout) and np.array_equal(run.x, alone.x)
            assert np.array_equal(run.validity.values, alone.validity.values) or run.validity.values.shape == (1, 4)


def test_a_stopped_sweep_goes_on(model, tmp_path):
    whole, seen, store = sweep(model, drawn, 50, tmp_path / "whole.npy", **HOW), [], tmp_path / "part.npy"

    def stop(done, count):
        seen.append(done)
        if len(seen) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep(model, drawn, 50, store, **HOW, progress=stop)
    with open(tmp_path / "part.chunks", "ab") as manifest:
        manifest.write(b"6")  # a line that was cut off does not count
    again = []
    rest = sweep(model, drawn, 50, store, **HOW, progress=lambda done, _: again.append(done))
    assert np.array_equal(rest.values, whole.values) and len(again) == 4 and again[-1] == 50
    sweep(model, drawn, 50, store, **HOW, progress=lambda *_: pytest.fail("all chunks were done"))


def test_stores_of_something_else_are_refused(model, tmp_path):
    store = tmp_path / "s.npy"
    sweep(model, drawn, 10, store, **HOW)
    heavier = model_of(ARM | {"gravity": [0.0, -9.0, 0.0]})
    for other, more in ((heavier, {}), (model, {"seed": 1}), (model, {"substeps": 2})):
        with pytest.raises(UsageError, match="another robot, other arguments"):
            sweep(other, drawn, 10, store, **HOW, **more)
    (tmp_path / "s.chunks").unlink()
    with pytest.raises(UsageError, match="no sweep that was stopped"):
        sweep(model, drawn, 10, store, **HOW)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"store": "x.txt"}, "must end in .npy"),
        ({"count": 0}, "count is 0"),
        ({"chunk": 0}, "chunk is 0"),
        ({"draw": lambda rng, n: {"tau": np.zeros(1)}}, "missing is 'x0'"),
        ({"draw": lambda rng, n: {"x0": np.zeros((n + 1, 4))}}, "both must be of 8"),
        ({"draw": lambda rng, n: {"x0": np.zeros((n, 3))}}, "x0 has the shape"),
        ({"keep": lambda run: run.q[:3]}, "both must be of 8"),
    ],
)
def test_refusals(model, tmp_path, change, said):
    given = {"draw": drawn, "count": 16, "store": "x.npy"} | HOW | change
    with pytest.raises(UsageError, match=said) as refused:
        sweep(model, store=tmp_path / given.pop("store"), **given)
    assert "\n" not in str(refused.value) and not list(tmp_path.iterdir())


def test_processes(model, tmp_path):
    """Each derives and loads the robot once; functions go by name."""
    with ProcessPoolExecutor(1) as pool:
        there = sweep(model, drawn, 20, tmp_path / "p.npy", **HOW, executor=pool)
        with pytest.raises(UsageError, match="cannot be sent"):
            sweep(model, lambda rng, n: drawn(rng, n), 20, tmp_path / "l.npy", **HOW, executor=pool)
    assert np.array_equal(there.values, sweep(model, drawn, 20, tmp_path / "t.npy", **HOW).values)


@pytest.mark.examples
def test_a_worker_of_dask_is_killed_midway(tmp_path):
    pytest.importorskip("dask.distributed")
    import dask_sweep

    command = [sys.executable, str(ROOT / "tests" / "dask_sweep.py"), str(tmp_path / "dask.npy")]
    env = os.environ | {"PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "tests"), *sys.path])}
    done = subprocess.run(command, env=env, capture_output=True, text=True, timeout=300)
    assert "complete True, killed 1 of 2" in done.stdout, done.stdout + done.stderr
    here = sweep(model_of(dask_sweep.ARM), dask_sweep.drawn, dask_sweep.COUNT, tmp_path / "here.npy", **dask_sweep.HOW)
    assert np.array_equal(np.load(tmp_path / "dask.npy"), here.values)


@pytest.mark.examples
def test_the_monte_carlo_example():
    command = [sys.executable, str(ROOT / "examples" / "monte_carlo.py"), "--short"]
    done = subprocess.run(command, env=os.environ | {"PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "2000 scenarios in" in done.stdout
