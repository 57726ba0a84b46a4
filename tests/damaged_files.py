"""Damaged files: each is refused in one line, or read; nothing crashes, and no memory beyond a bound is taken.

    python tests/damaged_files.py FIRST LAST [--workers N]

makes one damaged file per seed from FIRST to LAST, of every kind that screwgen reads, and prints what became of them.
A few processes read them, each with a limit on its memory; one that dies or hangs is begun anew.
"""

from __future__ import annotations

import argparse
import io
import json
import os
import resource
import select
import subprocess
import sys
import tempfile
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import NamedTuple

import damages
import numpy as np
from helpers import ROOT

SPARE = 500 * 2**20
"""Bytes that reading may take beyond those of the interpreter with its imports."""
PATIENCE = 60.0
"""Seconds until a process is taken to hang."""
GOOD, BAD = ("refused", "accepted"), ("traceback", "signal", "over memory", "too slow")

EXAMPLES = ("balanced_arm", "bucket", "crane_loop", "elastic_joint", "gantry", "space_arm")

ROBOT = """
name = "bot"
gravity = [0.0, 0.0, -9.81]

[[links]]
name = "upper"
length = 0.5
section = { rhoA = 1.0, EA = 1e7, EIy = 1e3, EIz = 1e3, GJ = 1e3, rhoIp = 1e-3 }
modes = { bending_y = 1, bending_z = 1 }
damping = { ratio = 0.01 }
bodies = [ { at = "tip", mass = 2.0, com = [0.0, 0.0, 0.1], inertia = [1.0, 2.0, 2.5, 0.0, 0.0, 0.0] } ]
joint = { axes = ["y", [0.0, 0.0, 1.0]], armature = [0.1, 0.2], mount = { xyz = [0.0, 0.0, 0.1] } }
"""
LAW = """
kp = [40.0, 30.0]
kd = [4.0, 3.0]
waypoints = [{ t = 0.5, q = [0.1, 0.2] }, { t = 1.0, q = [0.3, -0.2] }]
tau_max = [50.0, 40.0]
gravity = true
"""
CONTROLLER = """
[horizon]
intervals = 6
step = 0.02
substeps = 2
blocks = [1, 2, 3]
[goal]
joints = [0.3, 0.2]
[cost]
joints = [10.0, 5.0]
torques = 1e-4
terminal = { riccati = true }
[bounds]
torques = [60.0, 12.0]
"""
STATE = '{"q": [0.1, -0.2, 1e-3, 2e-3], "v": [0.0, 0.1],\n "tau": [1.5, -2.0],\n "w_ext": [[0, 0, 0, 1.0, 0, -3.5]]}\n'


class Kind(NamedTuple):
    """A kind of file: its good contents, how it may be damaged, and what reads it."""

    suffix: str
    contents: tuple[bytes, ...]
    ways: list[Callable]
    read: Callable[[Path], object]


# ------------------------------------------------------------------------------ good files


@cache
def model():
    import screwgen
    from screwgen.spec.load import loads

    return screwgen.derive(loads(ROBOT, "bot.toml"))


def _run() -> bytes:
    import screwgen
    from screwgen.simulation.runs import write_npz

    out = io.BytesIO()
    write_npz(screwgen.simulate(model(), 0.004, 1e-3, backend="casadi"), out)
    return out.getvalue()


def _mesh() -> bytes:
    from test_finite_elements import beam_elements, write

    out = io.BytesIO()
    write(out, beam_elements(6, 0.8, 2.0, 300.0, 4e5, 200.0, 0.02), point_tip=[0.8, 0.0, 0.0])
    return out.getvalue()


def _sid(folder: Path) -> bytes:
    from screwgen.reduction.finite_elements import load_npz
    from screwgen.reduction.sid import sid_text
    from screwgen.reduction.standard import sid_of

    (folder / "good.npz").write_bytes(_mesh())
    return sid_text(sid_of(load_npz(folder / "good.npz", 1))).encode()


def _solid() -> bytes:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "<f4")
    sides = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
    faces = b"".join(bytes(12) + corners[list(side)].tobytes() + bytes(2) for side in sides)
    return bytes(80) + np.uint32(4).tobytes() + faces


# ------------------------------------------------------------------------------ readers


def _view(path: Path) -> object:
    from screwgen.viewer.view import read_run, view

    return view(read_run(path))


def _analyse(path: Path) -> object:
    from screwgen.studies.analysis.runs import read_motion, run_validity

    return run_validity(model(), read_motion(os.fspath(path), model()))


def _mapped(path: Path) -> object:
    from screwgen.errors import UsageError
    from screwgen.files import ArrayFileError, mapped_array

    try:
        return bool(mapped_array(path).astype(complex).any())  # every number is read; a sum of damaged ones overflows
    except (ArrayFileError, OSError) as error:
        raise UsageError(f"{path}: {error}") from None


def _store(path: Path) -> object:
    """The manifest of a sweep beside its tables."""
    from screwgen.simulation.store import Store

    for name, rows in (("s.npy", np.zeros((8, 3))), ("s.status.npy", np.zeros(8, np.uint8))):
        (path.parent / name).write_bytes(damages.npy(rows))
    store = Store(path.parent / "s.npy", "digest", 8, 4)
    os.replace(path, store.manifest)
    with store:
        return store.result() if store.done else None


def _visuals(path: Path) -> object:
    from screwgen.viewer.meshes import read_looks

    shape = f'<visual><geometry><mesh filename="{path.name}"/></geometry></visual>'
    urdf = path.with_name("looks.urdf")
    urdf.write_text(f'<robot name="a"><link name="b">{shape}</link></robot>')
    return read_looks(urdf)


def kinds(folder: Path) -> dict[str, Kind]:
    """All kinds of files, by name."""
    from conformance.arms import arm_of
    from conformance.arrays import random_rows
    from random_robots import to_toml
    from random_urdfs import random_urdf

    import screwgen
    from screwgen.reduction.finite_elements import load_npz
    from screwgen.reduction.standard import load_sid
    from screwgen.simulation.controller_files import read_pd
    from screwgen.simulation.state import read_state
    from screwgen.spec.load import load
    from screwgen.spec.mpc import load_mpc

    run, text, members = _run(), damages.TEXT, damages.MEMBERS
    robots = [ROBOT.encode(), *((ROOT / "examples" / f"{name}.toml").read_bytes() for name in EXAMPLES)]
    robots += [to_toml(arm_of(row)).encode() for row in random_rows(12) if row["fore"] != "elements"]
    manifest = json.dumps({"sweep": "digest", "count": 8, "chunk": 4}) + "\n0\n1\n"
    return {
        "run, view": Kind(".npz", (run,), members, _view),
        "run, analyse": Kind(".npz", (run,), members, _analyse),
        "mesh": Kind(".npz", (_mesh(),), members, lambda path: load_npz(path, 2)),
        "array": Kind(".npy", (damages.npy(np.eye(7)),), [damages.one_array, *damages.BYTES], _mapped),
        "SID": Kind(".sid", (_sid(folder),), text, load_sid),
        "URDF": Kind(".urdf", tuple(random_urdf(k, 5).encode() for k in range(3)), text, screwgen.load),
        "robot": Kind(".toml", tuple(robots), text, load),
        "mpc": Kind(".toml", (CONTROLLER.encode(),), text, load_mpc),
        "gains": Kind(".toml", (LAW.encode(),), text, lambda path: read_pd(path, model())),
        "state": Kind(".json", (STATE.encode(),), text, lambda path: read_state(path, model())),
        "sweep": Kind(".chunks", (manifest.encode(),), text, _store),
        "visual": Kind(".stl", (_solid(),), damages.BYTES, _visuals),
    }


# ------------------------------------------------------------------------------ a worker


def outcome(kind: Kind, path: Path) -> tuple[str, str]:
    """What became of a file, and the line or the end of the traceback."""
    from screwgen.errors import ScrewgenError

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        warnings.simplefilter("error", RuntimeWarning)
        warnings.simplefilter("error", np.exceptions.ComplexWarning)
        try:
            kind.read(path)
        except ScrewgenError as error:
            line = str(error)
            return ("refused" if line.isprintable() and 0 < len(line) < 2000 else "traceback"), line
        except MemoryError:
            return "over memory", traceback.format_exc()
        except BaseException:
            return "traceback", traceback.format_exc()
    return "accepted", ""


def make(seed: int, known: dict[str, Kind], folder: Path) -> tuple[str, Path]:
    """The damaged file of a seed."""
    (name, kind), rng = list(known.items())[seed % len(known)], np.random.default_rng([7, seed])
    path = folder / f"{name.replace(', ', '_')}{kind.suffix}"
    good = kind.contents[rng.integers(len(kind.contents))]
    path.write_bytes(damages.damage(good, kind.ways, rng))
    return name, path


def work() -> None:
    """Read seeds from stdin, answer on stdout, one line each."""
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        known = kinds(folder)
        for kind in known.values():  # whatever is imported or compiled late is there
            path = folder / f"good{kind.suffix}"
            for content in kind.contents:
                path.write_bytes(content)
                if (found := outcome(kind, path))[0] != "accepted":
                    raise AssertionError(f"a good file is {found[0]}: {found[1]}")
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        print("ready", file=answers)
        for line in sys.stdin:
            name, path = make(int(line), known, folder)
            size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
            resource.setrlimit(resource.RLIMIT_AS, (size + SPARE, resource.RLIM_INFINITY))
            found = outcome(known[name], path)
            resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
            print(json.dumps([name, *found]), file=answers)


# ------------------------------------------------------------------------------ the driver


class Worker:
    """A process that reads files."""

    def __init__(self) -> None:
        command = [sys.executable, __file__, "--work"]
        env = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        self.process = subprocess.Popen(command, stdin=-1, stdout=-1, stderr=subprocess.DEVNULL, text=True, env=env)
        self.seed: int | None = None
        self.since = time.monotonic()

    def give(self, seed: int) -> None:
        self.seed, self.since = seed, time.monotonic()
        self.process.stdin.write(f"{seed}\n")
        self.process.stdin.flush()

    def end(self) -> int:
        self.process.stdin.close()  # which ends one that is well
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(1.0)
        self.process.kill()
        self.process.stdout.close()
        return self.process.wait()


def results(seeds: Iterator[int], count: int) -> Iterator[tuple[int, str, str, str]]:
    """Seed, kind, outcome and text of every file."""
    workers, left = [Worker() for _ in range(count)], iter(seeds)
    try:
        while workers:
            streams = {w.process.stdout: w for w in workers}
            ready = [streams[x] for x in select.select(list(streams), [], [], 1.0)[0]]
            hung = [w for w in workers if w not in ready and time.monotonic() - w.since > PATIENCE]
            for worker in (*ready, *hung):
                line = "" if worker in hung else worker.process.stdout.readline()
                if line.startswith("["):
                    yield worker.seed, *json.loads(line)
                elif not line:
                    status = worker.end()
                    if worker.seed is None:
                        raise RuntimeError("a worker does not start; run damaged_files.py --work to see why")
                    why = "too slow" if worker in hung else "signal"
                    yield worker.seed, "?", why, f"exit status {status}"
                    workers[workers.index(worker)] = worker = Worker()
                    continue
                if (seed := next(left, None)) is None:
                    worker.end()
                    workers.remove(worker)
                else:
                    worker.give(seed)
    finally:
        for worker in workers:
            worker.end()


def main(first: int, last: int, count: int) -> int:
    table: dict[str, Counter] = {}
    for seed, kind, what, text in results(iter(range(first, last + 1)), count):
        table.setdefault(kind, Counter())[what] += 1
        if what not in GOOD:
            print(f"seed {seed} ({kind}): {what}\n{text[-1500:]}", flush=True)
    print(f"{'':14}" + "".join(f"{x:>13}" for x in GOOD + BAD))
    total: Counter = sum(table.values(), Counter())
    for kind, counts in [*sorted(table.items()), ("all", total)]:
        print(f"{kind:14}" + "".join(f"{counts[x]:13}" for x in GOOD + BAD))
    return int(any(total[x] for x in BAD))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int, nargs="?", default=0)
    parser.add_argument("last", type=int, nargs="?", default=99)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--work", action="store_true", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.work:
        work()
    else:
        sys.exit(main(given.first, given.last, given.workers))
