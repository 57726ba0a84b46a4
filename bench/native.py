"""Compiling contenders into one program, running it, counting its instructions."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import threading
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from contenders import Contender, Library, has_avx

HERE = Path(__file__).resolve().parent
COMMON = ("-std=c99", "-ffunction-sections", "-fdata-sections", "-w")
LEVELS = {
    "O2": ("-O2",),
    "O3": ("-O3",),
    "native": ("-O3", "-march=native", "-ffp-contract=fast"),
}
COUNTABLE = ("O2", "O3")
TOLERANCE = 1e-8
PROCESSES = 11
PEAK_LIBRARY = Library("peak", {}, (), (), operations=2 * 12 * 200)
PEAK = Contender("peak", "multiplications and additions", PEAK_LIBRARY, "peak.c", "", exact=False)
SCALAR = ("-fno-tree-vectorize", "-fno-tree-slp-vectorize")


class BenchError(Exception):
    """Something the benchmark needs failed; one line."""


def command(*words) -> str:
    """Standard output of a command; a failure is one line."""
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    if done.returncode:
        said = (done.stderr or done.stdout).strip().splitlines()[:3]
        raise BenchError(f"{Path(str(words[0])).name} failed: {' | '.join(said)}")
    return done.stdout


@dataclass(frozen=True)
class Compiler:
    """A C compiler at a level of optimisation that keeps what it has compiled: large functions take minutes."""

    name: str
    level: str
    store: Path

    def compile(self, folder: Path, source: str, defines: Sequence[str]) -> Path:
        """The object of a source in ``folder``; from the store if source, headers, flags and compiler are the same."""
        flags = (*COMMON, *LEVELS[self.level], *defines)
        key = hashlib.sha256(" ".join((self.version, *flags)).encode())
        for file in sorted([folder / source, *folder.glob("*.h")]):
            key.update(file.read_bytes())
        out = self.store / f"{key.hexdigest()[:24]}.o"
        if not out.exists():
            self.store.mkdir(parents=True, exist_ok=True)
            partial = out.with_suffix(f".{os.getpid()}.{threading.get_ident()}.part")  # others may compile the same
            command(self.name, *flags, "-c", folder / source, "-o", partial)
            partial.replace(out)
        return out

    @property
    def version(self) -> str:
        """The first line that the compiler says about itself."""
        return command(self.name, "--version").splitlines()[0]


@dataclass
class Program:
    """The driver with the contenders of one group, and with the kernel that measures the machine's peak."""

    folder: Path
    contenders: Sequence[Contender]
    compiler: Compiler

    def __post_init__(self):
        self.contenders = [*self.contenders, PEAK]
        self.libraries = {c.library.name: c.library for c in self.contenders if c.library.sources}
        self.objects: dict[str, list[Path]] = {}

    def build(self, data: Mapping[str, str], progress: Callable[[str], None]) -> None:
        """Compile every library and adapter and link them with the driver; ``data``: headers of states by name."""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        for name, text in data.items():
            (self.folder / f"{name}_data.h").write_text(text)
        for library in self.libraries.values():
            (self.folder / library.name).mkdir()
            for name, text in library.files.items():
                (self.folder / library.name / name).write_text(text)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            sources = [(x, s) for x in self.libraries.values() for s in x.sources]
            sources.sort(key=lambda job: -len(job[0].files[job[1]]))
            jobs = [(x, pool.submit(self._compile_source, x, s, progress)) for x, s in sources]
            for library, job in jobs:
                self.objects.setdefault(library.name, []).append(job.result())
            list(pool.map(self._compile_adapter, self.contenders))
        self._link()

    def jobs(self) -> int:
        """How many sources there are to compile."""
        return sum(len(x.sources) for x in self.libraries.values())

    def _compile_source(self, library: Library, source: str, progress: Callable[[str], None]) -> Path:
        out = self.compiler.compile(self.folder / library.name, source, library.defines)
        progress(f"{library.name}/{source}")
        return out

    def _compile_adapter(self, c: Contender) -> None:
        adapter, whole = self.folder / f"{c.name}.adapter.o", self.folder / f"{c.name}.o"
        flags = [*COMMON, *LEVELS[self.compiler.level], *(SCALAR if c is PEAK else ())]
        flags += [*c.library.defines, *c.defines, f"-DVARIANT={c.symbol}"]
        flags += [f'-DDATA="{self.folder / c.data}_data.h"', "-I", HERE, "-I", self.folder / c.library.name]
        command(self.compiler.name, *flags, "-c", HERE / c.adapter, "-o", adapter)
        self._partial(whole, (c.symbol,), [adapter, *self.objects.get(c.library.name, [])])
        command("objcopy", f"--keep-global-symbol={c.symbol}", f"--keep-global-symbol={c.symbol}_call", whole)

    def _partial(self, out: Path, entries: Sequence[str], objects: Sequence[Path]) -> None:
        """Objects as one, without what the entries do not reach; no group of sections stands for another's."""
        keep = ["-Wl,--force-group-allocation", *(f"-Wl,-u,{entry}" for entry in entries)]
        command(self.compiler.name, "-r", "-nostdlib", "-Wl,--gc-sections", *keep, "-o", out, *objects)

    def _link(self) -> None:
        first = {c.data: i for i, c in reversed(list(enumerate(self.contenders)))}
        (self.folder / "list.h").write_text("".join(f"X({c.symbol}, {first[c.data]})\n" for c in self.contenders))
        objects = [self.folder / f"{c.name}.o" for c in self.contenders]
        foreign = list(dict.fromkeys(o for c in self.contenders for o in c.library.objects))
        files = [f'-DLIST="{self.folder / "list.h"}"', "-DRESULTS=4096", "-I", HERE]
        main = self.folder / "driver.o"
        command(self.compiler.name, *COMMON, "-O2", *files, "-c", HERE / "driver.c", "-o", main)
        runtime = ["-lstdc++"] if foreign else []
        command(self.compiler.name, main, *objects, *foreign, "-Wl,-z,now", *runtime, "-lm", "-o", self.driver)

    @property
    def driver(self) -> Path:
        return self.folder / "driver"

    # measurements -------------------------------------------------------------------------------

    def verify(self) -> float:
        """The largest deviation of a contender in double; raises where they do not compute the same."""
        exact = {c.symbol for c in self.contenders if c.exact}
        found = dict(line.split()[1:] for line in command(self.driver, "verify").splitlines())
        worst = max((float(found[name]), name) for name in exact)
        if not worst[0] < TOLERANCE:
            name = worst[1].removeprefix("run_")
            raise BenchError(f"{name} does not agree with the others of its robot: deviation {worst[0]:g}")
        return worst[0]

    def times(self, rounds: int, batch: float, progress: Callable[[str], None]) -> dict[str, list[float]]:
        """Nanoseconds per call of every contender in every round, at least ``rounds`` of them.

        The rounds are spread over processes, each from a copy of the driver of its own: where the pages of the code lie
        in memory is drawn once per file, and an unlucky place makes one contender or another half as slow again.
        """
        out: dict[str, list[float]] = defaultdict(list)
        copies = [self.folder / f"driver{number}" for number in range(PROCESSES)]
        for copy in copies:
            shutil.copy(self.driver, copy)
            lines = command(copy, "time", -(-rounds // PROCESSES), batch).splitlines()
            for name, value in (line.split()[2:] for line in lines):
                out[name.removeprefix("run_")].append(float(value))
            progress(copy.name)
        for copy in copies:  # not earlier: the next copy would be given the same pages
            copy.unlink()
        return out

    def instructions(self, calls: int) -> dict[str, float]:
        """Instructions per call by callgrind; empty where it is missing or does not know the machine's instructions."""
        tools = [shutil.which(tool) for tool in ("valgrind", "callgrind_annotate")]
        if self.compiler.level not in COUNTABLE or not all(tools):
            return {}
        out = self.folder / "callgrind.out"
        command("valgrind", "-q", "--tool=callgrind", f"--callgrind-out-file={out}", self.driver, "count")
        text = command("callgrind_annotate", "--inclusive=yes", "--threshold=100", out)
        found = re.findall(r"^\s*([\d,]+) .*?[:/]run_(\w+)_call(?: |$)", text, re.MULTILINE)
        return {name: int(count.replace(",", "")) / calls for count, name in found}

    def text_size(self, c: Contender) -> int | None:
        """Bytes of code and constants that the entries of a contender's library need on this machine's processor."""
        if not c.library.sources:
            return None
        out = self.folder / f"{c.name}.reachable.o"
        self._partial(out, c.library.entries, self.objects[c.library.name])
        symbols = [line.split() for line in command("nm", "-S", out).splitlines()]
        idle = sum(int(s[1], 16) for s in symbols if s[-1].endswith(".default")) if has_avx() else 0
        return int(command("size", out).splitlines()[1].split()[0]) - idle
