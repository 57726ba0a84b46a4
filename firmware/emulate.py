"""Running programs under QEMU, with and without counting."""

from __future__ import annotations

import re
import struct
import subprocess
from dataclasses import dataclass, field
from pathlib import Path
from threading import Lock

from cross import Build, FirmwareError, run
from targets import HERE, Target

LIMIT = 600.0
"""Seconds that a program may run."""
VERSIONS = range(1, 7)
"""Of QEMU's plugin interface; what the counter uses is the same in all."""
PAINTED = 16384
"""Bytes of painted stack in instruments.h."""


@dataclass
class Findings:
    """What measure.c or estimate.c printed."""

    sizes: dict[str, int] = field(default_factory=dict)
    stacks: dict[str, int] = field(default_factory=dict)
    samples: list[list[float]] = field(default_factory=list)
    intervals: list[str] = field(default_factory=list)
    """The names of the counted intervals, in the order in which they were counted."""
    counts: dict[str, list[int]] = field(default_factory=dict)
    figures: dict[str, int] = field(default_factory=dict)
    singular: int | None = None
    """The step of the simulation in which the model was singular."""


def read_findings(text: str) -> Findings:
    out = Findings()
    for line in text.splitlines():
        match line.split():
            case ["size", name, value]:
                out.sizes[name] = int(value)
            case ["stack", name, value]:
                out.stacks[name] = max(out.stacks.get(name, 0), int(value))
            case ["count", name, times]:
                out.intervals += [name] * int(times)
            case ["figure", name, value]:
                out.figures[name] = int(value)
            case ["singular", step]:
                out.singular = int(step)
            case ["sample", _, *bits]:
                out.samples.append([struct.unpack(">d", bytes.fromhex(b))[0] for b in bits])
    if text.split()[-1:] != ["done"]:
        raise FirmwareError(f"the measuring program stopped early: {text.strip().splitlines()[-1:]}")
    deepest = max(out.stacks.values(), default=0)
    if deepest >= PAINTED:
        raise FirmwareError(f"the stack is deeper than the {PAINTED} painted bytes")
    return out


def emulate(target: Target, program: Path, *options: str) -> tuple[int, str]:
    """Exit status of a program and what it printed: QEMU has the console of some cores in its standard error."""
    console = ("-display", "none", "-monitor", "none", "-serial", "none", "-semihosting-config")
    command = [target.emulator, *target.machine, *console, "enable=on,target=native", *options, "-kernel", program]
    try:
        done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=LIMIT, input="")
    except subprocess.TimeoutExpired:
        raise FirmwareError(f"{target.emulator}: {program.name} did not end within {LIMIT:.0f} s") from None
    return done.returncode, done.stdout + done.stderr


def self_check(build: Build) -> str:
    """The line of the self-check; raises where it fails."""
    status, out = emulate(build.variant.target, build.check())
    if status or "all checks passed" not in out:
        raise FirmwareError(f"{build.variant.name}: self-check: {out.strip() or f'status {status}'}")
    return out.strip()


@dataclass
class Counter:
    """Counts executed instructions by a plugin of QEMU's translator."""

    folder: Path
    versions: dict[str, int] = field(default_factory=dict)
    """Of the plugin interface, by emulator, as far as known."""
    lock: Lock = field(default_factory=Lock)

    def _library(self, version: int) -> Path:
        out = self.folder / f"count{version}.so"
        options = ("-std=c99", "-O2", "-shared", "-fPIC", "-fvisibility=hidden", f"-DPLUGIN_VERSION={version}")
        with self.lock:
            self.folder.mkdir(parents=True, exist_ok=True)
            if not out.exists():
                run("cc", *options, HERE / "counter" / "count.c", "-o", out)
        return out

    def run(self, build: Build, program: Path) -> Findings:
        """The findings of the measuring program with its counts, each without the two instructions around it."""
        begin, end = (address(build, program, name) for name in ("count_begin", "count_end"))
        result = program.with_suffix(".counts")
        target = build.variant.target
        known = self.versions.get(target.emulator)
        for version in VERSIONS if known is None else (known,):
            arguments = f"{self._library(version)},begin={begin:#x},end={end:#x},out={result}"
            status, out = emulate(target, program, "-plugin", arguments)
            if "API version" not in out:
                break
        if status:
            raise FirmwareError(f"{build.variant.name}: {out.strip()[-200:]}")
        self.versions[target.emulator] = version
        found = read_findings(out)
        numbers = [int(line) for line in result.read_text().split()]
        if len(numbers) != len(found.intervals):
            raise FirmwareError(f"{len(numbers)} intervals were counted where {len(found.intervals)} were announced")
        for name, number in zip(found.intervals, numbers, strict=True):
            found.counts.setdefault(name, []).append(number)
        check_counter(found)
        return found


def check_counter(found: Findings) -> None:
    """Takes off what an empty interval counts; a loop of two instructions must count two per turn, exactly."""
    turns = 1000
    once, twice = found.counts.pop("known")
    if twice - once != 2 * turns:
        raise FirmwareError(f"the counter errs: {twice - once} instructions in a loop that has {2 * turns}")
    (empty,) = found.counts.pop("empty")
    found.counts = {name: [n - empty for n in numbers] for name, numbers in found.counts.items()}


def address(build: Build, program: Path, symbol: str) -> int:
    """Where a function begins."""
    found = re.search(rf"^(\w+) \w {symbol}$", run(build.tool("nm"), program), re.MULTILINE)
    if not found:
        raise FirmwareError(f"{program.name} has no symbol {symbol}")
    return int(found[1], 16) & ~1
