"""The worst stack of a function: frames summed along the deepest path of calls.

The calls are read from the disassembly of the linked program, so those into libm and into the compiler's own arithmetic
are seen. Frames are the compiler's figures (-fstack-usage); for functions that came compiled, the sum of all that
their instructions take from the stack pointer.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from cross import Build, FirmwareError, run

HEAD = re.compile(r"^([0-9a-f]+) <([^>]+)>:$")
ARM_CALL = re.compile(r"\t(?:bl|b[a-z]{0,2}(?:\.[wn])?|cbn?z)\t(?:\w+, )?([0-9a-f]+) <[^>+]+>")
RISC_V_CALL = re.compile(r"\t(?:jal|j|jalr|jr|tail|call|b\w+)\t.*\b([0-9a-f]+) <[^>+]+>")
ARM_INDIRECT = re.compile(r"\tblx\t[a-z]")
UNBOUNDED = re.compile(r"\tsub(?:\.w)?\tsp, ?(?:sp, ?)?(?!sp)[a-z]")
RISC_V_INDIRECT = re.compile(r"\tjalr\t[a-z]\w*$")


@dataclass
class Function:
    """A function of the linked program."""

    names: list[str]
    calls: set[int] = field(default_factory=set)
    taken: int = 0
    """Bytes that its instructions take from the stack pointer, all together."""
    unbounded: bool = False
    """Whether it takes a number of bytes that stands in a register."""
    indirect: bool = False


def arm_bytes(text: str) -> int:
    """Bytes that an instruction takes from sp."""
    if found := re.search(r"\tsubw?(?:\.w)?\tsp, (?:sp, )?#(\d+)", text):
        return int(found[1])
    if found := re.search(r"\t(?:push|vpush|stmdb|vstmdb)(?:\.w)?\t(?:sp!, )?\{(.*?)\}", text):
        return sum(register_bytes(part.strip()) for part in found[1].split(","))
    if found := re.search(r"\[sp, #-(\d+)\]!", text):
        return int(found[1])
    return 0


def register_bytes(part: str) -> int:
    """Bytes of `r4`, `r4-r7` or `d8-d15`."""
    first, _, last = part.partition("-")
    count = int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count * (8 if first[0] == "d" else 4)


def risc_v_bytes(text: str) -> int:
    found = re.search(r"\taddi?\tsp,sp,-(\d+)", text)
    return int(found[1]) if found else 0


def functions(build: Build, program: Path) -> dict[int, Function]:
    """Every function of a program by its address: static functions of two files may share a name."""
    risc_v = build.variant.target.prefix.startswith("riscv")
    call, indirect = (RISC_V_CALL, RISC_V_INDIRECT) if risc_v else (ARM_CALL, ARM_INDIRECT)
    taken = risc_v_bytes if risc_v else arm_bytes
    out: dict[int, Function] = {}
    for line in run(build.tool("objdump"), "-d", "--no-show-raw-insn", program).splitlines():
        if head := HEAD.match(line):
            place = int(head[1], 16)
            current = out.setdefault(place, Function([]))
        elif ":\t" in line:
            own = set() if "\tbl\t" in line else {place}  # a branch to the beginning is a loop
            current.calls |= {int(found, 16) for found in call.findall(line)} - own
            current.taken += taken(line)
            current.unbounded |= bool(UNBOUNDED.search(line))
            current.indirect |= bool(indirect.search(line))
    for place, name in symbols(build, program):
        if place in out:
            out[place].names.append(name)
    return out


def symbols(build: Build, program: Path) -> list[tuple[int, str]]:
    """Address and name of every function; equal functions are one, with several names."""
    lines = (line.split() for line in run(build.tool("nm"), program).splitlines())
    return [(int(x[0], 16) & ~1, x[2]) for x in lines if len(x) == 3 and x[1] in "tTwW"]


def frames(build: Build) -> dict[str, int]:
    """The frames of the model's functions, by the compiler."""
    out: dict[str, int] = {}
    for path in build.objects:
        for line in path.with_suffix(".su").read_text(encoding="utf-8").splitlines():
            place, size, kind = line.split("\t")
            if kind not in ("static", "dynamic,bounded"):
                raise FirmwareError(f"{place}: a frame of unknown size")
            out[place.rpartition(":")[2]] = max(out.get(place.rpartition(":")[2], 0), int(size))
    return out


def covered_stacks(
    build: Build, program: Path, painted: dict[str, int], turns: dict[str, int] | None = None
) -> dict[str, int]:
    """The worst stack of each call of the model; raises where more of it was found painted."""
    name = build.sources.name
    worst = worst_stacks(build, program, [f"{name}_{call}" for call in painted], turns)
    for call, seen in painted.items():
        if seen > worst[f"{name}_{call}"]:
            raise FirmwareError(f"{build.variant.name}: {call} used {seen} bytes of stack, more than its call graph")
    return {call: worst[f"{name}_{call}"] for call in painted}


def worst_stacks(
    build: Build, program: Path, entries: list[str], turns: dict[str, int] | None = None
) -> dict[str, int]:
    """Bytes below the caller's stack pointer of each entry; raises where the calls do not bound them.

    ``turns``: functions that call themselves, also through others, at most so many times.
    """
    known, of_model, turns = functions(build, program), frames(build), turns or {}
    places = {name: place for place, f in known.items() for name in f.names}

    def frame(f: Function) -> int:
        stated = [of_model[n] for n in f.names if n in of_model]
        if f.indirect or (f.unbounded and not stated):
            raise FirmwareError(f"{f.names[0]}: its stack has no bound that the program shows")
        return max(stated) if stated else f.taken

    @cache
    def reached(place: int) -> frozenset[int]:
        found, new = set(), set(known[place].calls)
        while new := {c for c in new if c in known} - found:
            found |= new
            new = {c for place in new for c in known[place].calls}
        return frozenset(found)

    @cache
    def depth(place: int) -> int:
        """A function that calls itself is counted with all that call it back, each so many times as stated."""
        cycle = {c for c in reached(place) if place in reached(c)} or {place}
        count = [1] if place not in reached(place) else [turns[n] for c in cycle for n in known[c].names if n in turns]
        if not count:
            raise FirmwareError(f"{known[place].names[0]} calls itself: its stack has no bound")
        further = {c for f in cycle for c in known[f].calls if c in known} - cycle
        return max(count) * sum(frame(known[f]) for f in cycle) + max(map(depth, further), default=0)

    # What carries the precision in its symbol has it in float builds alone.
    return {entry: depth(places.get(entry) or places[f"{entry}_float"]) for entry in entries}
