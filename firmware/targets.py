"""The microcontrollers, their compilers and emulators."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, replace
from pathlib import Path

HERE = Path(__file__).resolve().parent

PRECISIONS = ("float", "double")
LAYOUTS = ("fused", "modular")
PARAMETERS = ("runtime", "baked")
OPTIMISATION = {
    "fused": ("-O2", "-fno-schedule-insns"),
    "modular": ("-Os",),
}
"""Fused for speed, modular for size. Scheduling before the registers are assigned makes long straight-line code spill:
without it the fused function takes 11 % fewer instructions and 7 % less flash."""
COMMON = ("-std=c99", "-ffp-contract=fast", "-fno-math-errno", "-ffunction-sections", "-fdata-sections")
"""With -std=c99 gcc makes no multiplication and addition one instruction (FMA) unless it is told to."""
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Wmissing-prototypes")


@dataclass(frozen=True)
class Target:
    """A core on a board that QEMU emulates."""

    name: str
    core: str
    prefix: str
    cpu: dict[str, tuple[str, ...]]
    """Compiler options by precision."""
    emulator: str
    machine: tuple[str, ...]
    sources: tuple[str, ...]
    """Start-up code of our own."""
    bare: tuple[str, ...]
    """Options of the linker without a console."""
    console: tuple[str, ...]
    """Options of the linker with a console on the host, through semihosting."""

    @property
    def compiler(self) -> str:
        return f"{self.prefix}gcc"

    @property
    def missing(self) -> list[str]:
        """Tools that this machine lacks."""
        return [tool for tool in (self.compiler, self.emulator) if shutil.which(tool) is None]


def cortex_m(name: str, core: str, machine: str, cpu: tuple[str, ...]) -> Target:
    script = f"-T{HERE / 'target' / 'cortex_m.ld'}"
    options = ("-mthumb", "-mfloat-abi=hard", *cpu)
    return Target(
        name, core, "arm-none-eabi-", dict.fromkeys(PRECISIONS, options), "qemu-system-arm", ("-M", machine),
        ("start_cortex_m.c",), ("-nostartfiles", "--specs=nosys.specs", script),
        ("-nostartfiles", "--specs=rdimon.specs", script),
    )  # fmt: skip


def risc_v() -> Target:
    """Start-up code and linker script are picolibc's; memory is that of QEMU's board virt."""
    places = {"flash": "0x80000000", "flash_size": "0x400000", "ram": "0x80400000", "ram_size": "0x400000"}
    memory = tuple(f"-Wl,--defsym=__{k}={v}" for k, v in places.items())
    link = (*memory, "-Wl,--defsym=__stack_size=0x10000")
    cpu = {
        "float": ("--specs=picolibc.specs", "-march=rv32imafc", "-mabi=ilp32f"),
        "double": ("--specs=picolibc.specs", "-march=rv32imafdc", "-mabi=ilp32d"),
    }
    machine = ("-M", "virt", "-bios", "none")
    console = (*link, "--oslib=semihost", "--crt0=hosted")
    bare = (*link, "--crt0=minimal")
    return Target("rv32", "RISC-V RV32", "riscv64-unknown-elf-", cpu, "qemu-system-riscv32", machine, (), bare, console)


TARGETS = {
    t.name: t
    for t in (
        cortex_m("m4f", "Cortex-M4F", "mps2-an386", ("-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16")),
        cortex_m("m7", "Cortex-M7", "mps2-an500", ("-mcpu=cortex-m7", "-mfpu=fpv5-d16")),
        risc_v(),
    )
}
PACKAGES = {
    "m4f": "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm",
    "m7": "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm",
    "rv32": "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc",
}
"""Debian's packages."""


@dataclass(frozen=True)
class Variant:
    """One row of the table: a model on a core."""

    target: Target
    precision: str
    layout: str
    parameters: str
    arm: str = "ella_paper"
    """The robot's file, without its ending."""
    order: int = 1
    """Of the links' shape."""

    @property
    def name(self) -> str:
        arm = "" if self.arm == Variant.arm else f"_{self.arm}"
        order = "" if self.order == 1 else f"_order{self.order}"
        return f"{self.target.name}_{self.precision}_{self.layout}_{self.parameters}{arm}{order}"

    @property
    def flags(self) -> tuple[str, ...]:
        return (*COMMON, *OPTIMISATION[self.layout], *self.target.cpu[self.precision])


def variants(targets: list[Target]) -> list[Variant]:
    """All rows, the cheap ones first within a target.

    In float on the Cortex-M4F also those to second order, and both orders of the arm whose modes converge.
    """
    rows = [Variant(t, p, x, b) for t in targets for p in PRECISIONS for x in LAYOUTS for b in PARAMETERS]
    small = [v for v in rows if (v.target.name, v.precision) == ("m4f", "float")]
    others = [("ella_paper", 2), ("ella", 1), ("ella", 2)]
    return rows + [replace(v, arm=arm, order=order) for arm, order in others for v in small]
