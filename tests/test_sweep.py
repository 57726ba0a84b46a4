"""Rollouts on executors and sweeps into a store: equal bits, stopped and gone on with, refusals."""

import os
import subprocess
import sys
import sysconfig
from concurrent.futures import Future, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest
from conftest import package, require_tool
from helpers import ROOT, model_of

from screwgen import UsageError, rollout, sweep
from screwgen.simulation.rollout import Rollout
from screwgen.simulation.rollout_validity import ParameterWarning

LINK = {"length": 0.5, "section": {"rhoA": 2.0, "EIz": 400.0}, "bodies": [{"at": "tip", "mass": 1.5}]}
LINK |= {"modes": {"bending_y": 1}, "joint": {"axes": ["z"]}}
ARM = {"name": "swept", "gravity": [0.0, -9.81, 0.0], "links": [{"name": "a", **LINK}]}
MANIFESTS = {"npy": "part.chunks", "zarr": "part.zarr.chunks"}
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


@pytest.fixture(params=["npy", "zarr"])
def format(request) -> str:
    if request.param == "zarr":
        package("zarr")
    return request.param


def bits(values) -> bytes:
    return np.asarray(values).tobytes()


def test_results_do_not_depend_on_the_executor(model, tmp_path):
    alone = sweep(model, drawn, 50, tmp_path / "one.npy", **HOW)
    assert alone.values.shape == (50, 4) and alone.ok.all()
    rng = np.random.default_rng([0, 1])
    mine = rollout(model, **drawn(rng, 8), step=1e-3, steps=3)
    assert np.array_equal(alone.values[8:16], mine.x[:, -1])
    with ThreadPoolExecutor(2) as threads:
        for name, executor in (("two", threads), ("lossy", Losing())):
            other = sweep(model, drawn, 50, tmp_path / f"{name}.npy", **HOW, executor=executor)
            assert bits(alone.values) == bits(other.values), name
            assert bits(alone.status) == bits(other.status), name


def test_rollouts_of_arrays_on_executors(model, monkeypatch):
    monkeypatch.setattr("screwgen.simulation.chunks.CHUNK", 16)
    given = drawn(np.random.default_rng(0), 50) | {"step": 1e-3, "steps": 3}
    alone = rollout(model, **given)
    with ThreadPoolExecutor(2) as threads:
        for executor in (threads, Losing()):
            run = rollout(model, **given, executor=executor)
            assert isinstance(run, Rollout) and np.array_equal(run.x, alone.x)
            assert np.array_equal(run.validity.values, alone.validity.values) or run.validity.values.shape == (1, 4)


def test_a_zarr_store_opens_as_any_other(model, tmp_path):
    zarr = package("zarr")
    found = sweep(model, unlucky, 50, tmp_path / "s.zarr", **HOW, keep=marked, executor=Losing())
    there = zarr.open_group(tmp_path / "s.zarr", mode="r")
    assert there["values"].chunks == (8, 4) and there["values"].dtype == np.float32
    assert bits(there["values"]) == bits(sweep(model, unlucky, 50, tmp_path / "s.npy", **HOW, keep=marked).values)
    assert np.array_equal(there["status"][:], found.status) and not found.ok[::8].any() and found.ok.sum() == 43


def unlucky(rng, n: int) -> dict:
    given = drawn(rng, n)
    given["x0"][0] = np.nan
    return given


def impossible(rng, n: int) -> dict:
    given = drawn(rng, n)
    given["parameters"]["a.bodies[0].mass"][-1] = -1.0
    return given


def test_what_is_wrong_with_parameters_is_said_once(model, tmp_path):
    said = r"scenario 7 did not run \(status 3\): .*mass.*; 2 more such: see status"
    with pytest.warns(ParameterWarning, match=said) as told:
        found = sweep(model, impossible, 20, tmp_path / "s.npy", **HOW, executor=Losing())
    assert len(told) == 1 and np.flatnonzero(found.status == 3).tolist() == [7, 15, 19]


def marked(run) -> np.ndarray:
    """Values whose bits are easily lost: what is not a number, and zeros with a sign."""
    return np.where(run.x[:, -1] > 0.5, np.float32(-0.0), run.x[:, -1].astype(np.float32))


def test_a_stopped_sweep_goes_on(model, tmp_path, format):
    whole, seen, store = sweep(model, drawn, 50, tmp_path / "whole.npy", **HOW), [], tmp_path / f"part.{format}"

    def stop(done, count):
        seen.append(done)
        if len(seen) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep(model, drawn, 50, store, **HOW, progress=stop)
    with open(tmp_path / MANIFESTS[format], "ab") as manifest:
        manifest.write(b"6")  # a line that was cut off does not count
    again = []
    rest = sweep(model, drawn, 50, store, **HOW, progress=lambda done, _: again.append(done))
    assert bits(rest.values) == bits(whole.values) and len(again) == 4 and again[-1] == 50
    sweep(model, drawn, 50, store, **HOW, progress=lambda *_: pytest.fail("all chunks were done"))


def test_a_sweep_that_was_stopped_before_its_first_chunk_was_listed(model, tmp_path, format):
    store, manifest = tmp_path / f"part.{format}", tmp_path / MANIFESTS[format]
    whole = bits(sweep(model, drawn, 20, store, **HOW).values)
    manifest.write_bytes(manifest.read_bytes().splitlines(keepends=True)[0])
    assert bits(sweep(model, drawn, 20, store, **HOW).values) == whole


def test_a_store_that_lost_a_chunk_is_refused(model, tmp_path):
    package("zarr")
    store = tmp_path / "part.zarr"
    sweep(model, drawn, 50, store, **HOW)
    (store / "values" / "c" / "2" / "0").unlink()
    with pytest.raises(UsageError, match="lacks chunks that its manifest lists"):
        sweep(model, drawn, 50, store, **HOW)


def test_a_sweep_that_was_stopped_before_it_made_its_tables(model, tmp_path, format):
    """Its manifest is empty, or ends within its header, or with it and without the newline."""
    store, manifest = tmp_path / f"part.{format}", tmp_path / MANIFESTS[format]
    sweep(model, drawn, 10, store, **HOW)
    header = manifest.read_bytes().splitlines()[0]
    for k, kept in enumerate((b"", header[:1], header[:-1], header)):
        folder = tmp_path / str(k)
        folder.mkdir()
        (folder / MANIFESTS[format]).write_bytes(kept)
        assert sweep(model, drawn, 10, folder / f"part.{format}", **HOW).ok.all()
    manifest.write_bytes(header)
    with pytest.raises(UsageError, match="no sweep that was stopped"):
        sweep(model, drawn, 10, store, **HOW)
    assert manifest.read_bytes() == header


def test_stores_of_something_else_are_refused(model, tmp_path, format):
    store = tmp_path / f"part.{format}"
    sweep(model, drawn, 10, store, **HOW)
    heavier = model_of(ARM | {"gravity": [0.0, -9.0, 0.0]})
    for other, more in ((heavier, {}), (model, {"seed": 1}), (model, {"substeps": 2})):
        with pytest.raises(UsageError, match="another robot, other arguments"):
            sweep(other, drawn, 10, store, **HOW, **more)
    kept = store.rename(tmp_path / "elsewhere")
    with pytest.raises(UsageError, match="cannot be read"):
        sweep(model, drawn, 10, store, **HOW)
    kept.rename(store)
    (tmp_path / MANIFESTS[format]).unlink()
    with pytest.raises(UsageError, match="no sweep that was stopped"):
        sweep(model, drawn, 10, store, **HOW)


def test_rows_of_other_types_are_refused(model, tmp_path, format):
    """The file would hold them as numbers of the first type."""
    seen = []

    def changing(run):
        seen.append(run)
        return run.q[:, -1] if len(seen) < 3 else run.q[:, -1].astype(np.float32)

    with pytest.raises(UsageError, match=r"rows \(2,\) of float\d\d of chunk \d, \(2,\) of float\d\d before"):
        sweep(model, drawn, 50, tmp_path / f"part.{format}", **HOW, keep=changing)


def test_without_zarr(model, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(UsageError, match=r"pip install 'screwgen\[zarr\]'"):
        sweep(model, drawn, 10, tmp_path / "s.zarr", **HOW)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"store": "x.txt"}, "must end in .npy or .zarr"),
        ({"store": "none/x.npy"}, "there is no folder"),
        ({"count": 0}, "count is 0"),
        ({"chunk": 0}, "chunk is 0"),
        ({"draw": lambda rng, n: {"tau": np.zeros(1)}}, "missing is 'x0'"),
        ({"draw": lambda rng, n: {"x0": np.zeros((n + 1, 4))}}, "both must be of 8"),
        ({"draw": lambda rng, n: {"x0": np.zeros((n, 3))}}, "x0 has the shape"),
        ({"keep": lambda run: run.q[:3]}, "both must be of 8"),
        ({"keep": lambda run: run.x[:, -1].astype(object)}, "keep gave object; it must give"),
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


def started(*command) -> subprocess.CompletedProcess:
    """A program of this folder, run to its end."""
    env = os.environ | {"PYTHONPATH": os.pathsep.join([str(ROOT), str(ROOT / "tests"), *sys.path])}
    return subprocess.run([*map(str, command)], env=env, capture_output=True, text=True, timeout=300)


@pytest.mark.examples
def test_a_worker_of_dask_is_killed_midway(tmp_path):
    package("dask.distributed")
    import dask_sweep

    done = started(sys.executable, ROOT / "tests" / "dask_sweep.py", tmp_path / "dask.npy")
    assert "complete True, killed 1 of 2" in done.stdout, done.stdout + done.stderr
    here = sweep(model_of(dask_sweep.ARM), dask_sweep.drawn, dask_sweep.COUNT, tmp_path / "here.npy", **dask_sweep.HOW)
    assert np.array_equal(np.load(tmp_path / "dask.npy"), here.values)


@pytest.mark.examples
def test_a_worker_of_mpi_is_killed_midway(tmp_path):
    """MPI ends the whole job; the next one makes what is missing."""
    package("mpi4py")
    zarr = package("zarr")
    import mpi_sweep

    mpiexec = require_tool(os.path.join(sysconfig.get_path("scripts"), "mpiexec"))
    command = [mpiexec, "-n", 3, sys.executable, "-m", "mpi4py.futures", ROOT / "tests" / "mpi_sweep.py"]
    killed = started(*command, tmp_path / "mpi.zarr", "kill")
    assert killed.returncode and "complete" not in killed.stdout, killed.stdout + killed.stderr
    done = started(*command, tmp_path / "mpi.zarr")
    assert "complete True, 2 workers" in done.stdout, done.stdout + done.stderr
    assert int(done.stdout.split()[-1]) >= mpi_sweep.COUNT // 4, "the chunks of the killed job are kept"
    how = mpi_sweep.HOW | {"count": mpi_sweep.COUNT, "store": tmp_path / "here.npy"}
    here = sweep(model_of(mpi_sweep.ARM), mpi_sweep.drawn, **how)
    assert bits(zarr.open_group(tmp_path / "mpi.zarr", mode="r")["values"]) == bits(here.values)


@pytest.mark.examples
def test_the_monte_carlo_example():
    command = [sys.executable, str(ROOT / "examples" / "monte_carlo.py"), "--short"]
    done = subprocess.run(command, env=os.environ | {"PYTHONPATH": str(ROOT)}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "2000 scenarios in" in done.stdout
