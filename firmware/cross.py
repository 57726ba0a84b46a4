"""Compiling a variant: the model's objects once, and three programs with them."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from targets import COMMON, HERE, PACKAGES, WARNINGS, Target, Variant

from screwgen import Model

PROGRAMS = HERE / "target"
CAREFUL = ("-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Werror")
"""For programs that are not a library."""


class FirmwareError(Exception):
    """Something that the measurement needs failed; one line."""


def run(*command) -> str:
    """What a command prints; raises FirmwareError with the first lines that it said."""
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode:
        said = [x for x in (done.stderr or done.stdout).strip().splitlines() if "error" in x.lower()] or [done.stderr]
        raise FirmwareError(f"{Path(str(command[0])).name} failed: {' | '.join(said[:3]).strip()}")
    return done.stdout + done.stderr


def require(target: Target) -> None:
    """Raises FirmwareError where this machine lacks tools of a target."""
    if missing := ", ".join(target.missing):
        raise FirmwareError(f"not installed: {missing}; on Debian: apt-get install {PACKAGES[target.name]}")


@dataclass(frozen=True)
class Sources:
    """The generated C of a robot in one layout, in a folder."""

    name: str
    folder: Path

    @cached_property
    def methods(self) -> list[str]:
        """The integrators, as the header declares them."""
        header = (self.folder / f"{self.name}.h").read_text(encoding="utf-8")
        return re.findall(rf"^{self.name}_status {self.name}_step_(\w+)\(", header, re.MULTILINE)

    @property
    def parts(self) -> list[Path]:
        """The sources of the library."""
        return sorted(self.folder.glob(f"{self.name}_*.c"))

    @property
    def defines(self) -> list[str]:
        """What the measuring programs are told of the model."""
        steps = " ".join(f"STEP({i}, {m})" for i, m in enumerate(self.methods))
        return [
            f"-DMODEL={self.name}",
            f"-DMODEL_UPPER={self.name.upper()}",
            f'-DMODEL_HEADER="{self.name}_reference.h"',
            f"-DMETHODS={steps}",
            f"-I{self.folder}",
        ]

    def real(self, precision: str) -> list[str]:
        return [f"-D{self.name.upper()}_REAL_FLOAT"] if precision == "float" else []


def generate(model: Model, folder: Path, parameters: str, layout: str, **options) -> Sources:
    """The C of a model, written into the folder."""
    for name, data in model.c_files(parameters, layout, **options).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    return Sources(model.robot.name, folder)


@dataclass(frozen=True)
class Build:
    """A variant in a folder of its own."""

    variant: Variant
    sources: Sources
    folder: Path

    @property
    def flags(self) -> list[str]:
        return [*self.variant.flags, *self.sources.real(self.variant.precision)]

    @property
    def compiler(self) -> str:
        return self.variant.target.compiler

    def tool(self, name: str) -> str:
        """A program of the target's binutils."""
        return f"{self.variant.target.prefix}{name}"

    @cached_property
    def objects(self) -> list[Path]:
        """The model, compiled with all warnings as errors."""
        self.folder.mkdir(parents=True, exist_ok=True)
        out = []
        for source in self.sources.parts:
            out.append(self.folder / f"{source.stem}.o")
            extra = (*WARNINGS, "-Werror", "-fstack-usage")
            run(self.compiler, *self.flags, *extra, "-c", source, "-o", out[-1])
        return out

    def link(self, name: str, main: Path, console: bool, *extra: str) -> Path:
        """A program of the model, with a link map beside it."""
        target = self.variant.target
        out = self.folder / f"{name}.elf"
        start = [PROGRAMS / s for s in target.sources]
        options = target.console if console else target.bare
        defines = [*self.sources.defines, *extra, *(["-DCONSOLE"] if console else [])]
        end = ["-Wl,--gc-sections", f"-Wl,-Map={out.with_suffix('.map')}", "-lm", "-o", out]
        run(self.compiler, *self.flags, *CAREFUL, *defines, main, *start, *self.objects, *options, *end)
        return out

    def image(self, dae: bool) -> Path:
        """The smallest firmware: the joint form, or both forms."""
        return self.link("dae" if dae else "joint", PROGRAMS / "image.c", False, *(["-DDAE_FORM"] if dae else []))

    def measure(self) -> Path:
        return self.link("measure", PROGRAMS / "measure.c", True)

    def check(self) -> Path:
        """The self-check that is generated with the model."""
        return self.link("check", self.sources.folder / "check.c", True)


def run_on_host(sources: Sources, folder: Path, program: Path, *options: str) -> str:
    """What a program of the model prints on this machine, in double: the reference."""
    folder.mkdir(parents=True, exist_ok=True)
    out = folder / program.stem
    run("cc", *COMMON, "-w", *sources.defines, *options, program, *sources.parts, "-lm", "-o", out)
    return run(out)


# ------------------------------------------------------------------------------------------- sizes


@dataclass(frozen=True)
class Size:
    """Bytes of a program."""

    flash: int
    """Code, constants and the initial values of data: the whole image, start-up and libm included."""
    ram: int
    """Data and zero-initialised data, without stack and heap."""
    model: int
    """What of the flash the generated code is."""


def size_of(build: Build, program: Path) -> Size:
    flash = ram = 0
    for line in run(build.tool("readelf"), "-S", "-W", program).splitlines():
        found = re.match(r"\s*\[ *\d+\] (\S+)\s+(\S+)\s+\w+ \w+ (\w+) \w+\s+(\w+) ", line)
        if found and "A" in found[4] and found[1] not in (".stack", ".heap", ".tbss_space"):
            size = int(found[3], 16)
            flash += size if found[2] != "NOBITS" else 0
            ram += size if "W" in found[4] else 0
    return Size(flash, ram, model_bytes(build, program))


def model_bytes(build: Build, program: Path) -> int:
    """Bytes in the image that come from the model's objects, from the link map."""
    text = program.with_suffix(".map").read_text(encoding="utf-8").partition("Linker script and memory map")[2]
    parts = re.findall(r"^ \.\S+\s+0x[0-9a-f]+\s+0x([0-9a-f]+) (\S+)$", text, re.MULTILINE)
    ours = {str(o) for o in build.objects}
    allocated = (int(size, 16) for size, path in parts if path in ours)
    return sum(allocated)
