"""Compiling contenders into one program, running it, counting its instructions."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections import defaultdict
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from contenders import Contender, Library, prepare_folder

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


class BenchError(Exception):
    """Something the benchmark needs failed; one line."""


@dataclass
class Program:
    """The driver of one robot with its contenders at the given levels of optimisation."""

    folder: Path
    contenders: Sequence[Contender]
    levels: Sequence[str]
    compiler: str

    def build(self, data: str, progress: Callable[[str], None]) -> None:
        """Compile every library and adapter at every level and link them with the driver."""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        (self.folder / "data.h").write_text(data)
        libraries = {c.library.name: c.library for c in self.contenders}
        for library in libraries.values():
            prepare_folder(self.folder / library.name, library)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            jobs = [
                pool.submit(self._compile_source, x, s, level, progress)
                for x in libraries.values()
                for s in x.sources
                for level in self.levels
            ]
            for job in jobs:
                job.result()
            adapters = [(c, level) for c in self.contenders for level in self.levels]
            list(pool.map(lambda job: self._compile_adapter(*job), adapters))
        self._link()

    def jobs(self) -> int:
        """How many sources there are to compile."""
        libraries = {c.library.name: c.library for c in self.contenders}
        return sum(len(x.sources) for x in libraries.values()) * len(self.levels)

    def _compile_source(self, library: Library, source: str, level: str, progress: Callable[[str], None]) -> None:
        folder = self.folder / library.name
        out = folder / f"{Path(source).stem}.{level}.o"
        self._run(self.compiler, *COMMON, *LEVELS[level], *library.defines, "-c", folder / source, "-o", out)
        progress(f"{library.name}/{source} {level}")

    def _objects(self, library: Library, level: str) -> list[Path]:
        return [self.folder / library.name / f"{Path(s).stem}.{level}.o" for s in library.sources]

    def _compile_adapter(self, c: Contender, level: str) -> None:
        symbol = f"{c.name}_{level}"
        adapter, whole = self.folder / f"{symbol}.adapter.o", self.folder / f"{symbol}.o"
        defines = [*c.library.defines, *c.defines, f"-DVARIANT={symbol}", f'-DDATA="{self.folder / "data.h"}"']
        places = ["-I", HERE, "-I", self.folder / c.library.name]
        self._run(self.compiler, *COMMON, *LEVELS[level], *defines, *places, "-c", HERE / c.adapter, "-o", adapter)
        self._partial(whole, (symbol,), [adapter, *self._objects(c.library, level)])
        self._run("objcopy", f"--keep-global-symbol={symbol}", f"--keep-global-symbol={symbol}_call", whole)

    def _partial(self, out: Path, entries: Sequence[str], objects: Sequence[Path]) -> None:
        """Objects as one, without what the entries do not reach."""
        keep = [f"-Wl,-u,{entry}" for entry in entries]
        self._run(self.compiler, "-r", "-nostdlib", "-Wl,--gc-sections", *keep, "-o", out, *objects)

    def _link(self) -> None:
        lines = [f"X({c.name}_{x}, {int(x in COUNTABLE)})" for c in self.contenders for x in self.levels]
        (self.folder / "list.h").write_text("\n".join(lines) + "\n")
        objects = [self.folder / f"{c.name}_{x}.o" for c in self.contenders for x in self.levels]
        files = [f'-DDATA="{self.folder / "data.h"}"', f'-DLIST="{self.folder / "list.h"}"', "-I", HERE]
        sources = [HERE / "driver.c", *objects]
        self._run(self.compiler, *COMMON, "-O2", *files, *sources, "-Wl,-z,now", "-lm", "-o", self.driver)

    @property
    def driver(self) -> Path:
        return self.folder / "driver"

    # measurements -------------------------------------------------------------------------------

    def verify(self) -> float:
        """The largest deviation between contenders in double; raises where they do not compute the same."""
        exact = {f"{c.name}_{x}" for c in self.contenders for x in self.levels if c.exact}
        found = dict(line.split()[1:] for line in self._run(self.driver, "verify").splitlines())
        worst = max((float(found[name]), name) for name in exact)
        if not worst[0] < TOLERANCE:
            raise BenchError(f"{worst[1]} does not agree with {self.contenders[0].name}: deviation {worst[0]:g}")
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
            lines = self._run(copy, "time", -(-rounds // PROCESSES), batch).splitlines()
            for name, value in (line.split()[2:] for line in lines):
                out[name].append(float(value))
            progress(copy.name)
        for copy in copies:  # not earlier: the next copy would be given the same pages
            copy.unlink()
        return out

    def instructions(self, calls: int) -> dict[str, float]:
        """Instructions per call of every countable contender, by callgrind; empty where it is missing."""
        if not (shutil.which("valgrind") and shutil.which("callgrind_annotate")):
            return {}
        out = self.folder / "callgrind.out"
        self._run("valgrind", "-q", "--tool=callgrind", f"--callgrind-out-file={out}", self.driver, "count")
        text = self._run("callgrind_annotate", "--inclusive=yes", "--threshold=100", out)
        found = re.findall(r"^\s*([\d,]+) .*?[:/](\w+)_call(?: |$)", text, re.MULTILINE)
        return {name: int(count.replace(",", "")) / calls for count, name in found}

    def text_size(self, library: Library, level: str) -> int:
        """Bytes of code and constants that the entries of a library need."""
        out = self.folder / library.name / f"reachable.{level}.o"
        self._partial(out, library.entries, self._objects(library, level))
        return int(self._run("size", out).splitlines()[1].split()[0])

    def _run(self, *command) -> str:
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
        if done.returncode:
            said = (done.stderr or done.stdout).strip().splitlines()[:3]
            raise BenchError(f"{Path(str(command[0])).name} failed: {' | '.join(said)}")
        return done.stdout
