"""The table: one row per variant, printed, as CSV and as Markdown; and the budgets that it is held against."""

from __future__ import annotations

import csv
import io
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from targets import HERE, TARGETS, Variant, variants

BUDGETS = HERE / "budgets.toml"
TABLE = HERE / "TABLE.md"
"""The committed table, written with the budgets."""
SIZES = ("flash", "model", "flash_dae", "ram", "ram_dae", "stack", "stack_painted", "stack_dae", "stack_dae_painted")


@dataclass
class Row:
    """What was measured of a variant."""

    variant: Variant
    sizes: dict[str, int]
    """Bytes, by the names in SIZES."""
    counts: dict[str, int]
    """Executed instructions of a call, the largest over the states at which it was counted."""
    error: dict[str, float]
    """Of the simulation against double on the host: `angle` in rad, `tip` in m."""
    structs: dict[str, int] = field(default_factory=dict)
    check: str = ""

    @property
    def figures(self) -> dict[str, float]:
        """All that a limit may bound: bytes, instructions, metres."""
        return self.sizes | self.counts | {"tip_error": self.error["tip"]}


# ------------------------------------------------------------------------------------------- printing

HEADS = {
    "flash": "flash",
    "model": "model",
    "ram": "RAM",
    "stack": "stack",
    "stack_painted": "painted",
    "forward_dynamics": "dynamics",
    "step_euler": "euler",
    "step_semi_implicit": "semi_impl",
    "step_modal_implicit": "modal_impl",
    "step_modal_midpoint": "midpoint",
    "step_rk4": "rk4",
}
DAE_HEADS = {
    "flash_dae": "flash",
    "ram_dae": "RAM",
    "stack_dae": "stack",
    "stack_dae_painted": "painted",
    "dae_forward_dynamics": "dynamics",
    "dae_step_euler": "euler",
    "dae_step_semi_implicit": "semi_impl",
    "dae_step_modal_implicit": "modal_impl",
    "dae_step_modal_midpoint": "midpoint",
    "dae_step_rk4": "rk4",
}
NAMES = ("core", "real", "layout", "parameters", "arm", "order")


def names(row: Row) -> list[str]:
    v = row.variant
    return [v.target.core, v.precision, v.layout, v.parameters, v.arm, str(v.order)]


def cells(rows: Sequence[Row], heads: dict[str, str], errors: bool) -> list[list[str]]:
    """Text of the table, the head first."""
    out = [[*NAMES, *heads.values(), *(("angle error", "tip error") if errors else ())]]
    for row in rows:
        line = [*names(row), *(f"{row.figures[k]:,}" for k in heads)]
        if errors:
            line += [f"{row.error['angle']:.0e} rad", f"{row.error['tip']:.0e} m"]
        out.append(line)
    return out


def aligned(lines: Sequence[Sequence[str]]) -> str:
    """Columns of equal width, names flush left and figures right."""
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    out = []
    for line in [lines[0], ["-" * w for w in widths], *lines[1:]]:
        row = zip(line, widths, strict=True)
        out.append("  ".join(x.ljust(w) if i < len(NAMES) else x.rjust(w) for i, (x, w) in enumerate(row)).rstrip())
    return "\n".join(out)


def markdown(lines: Sequence[Sequence[str]]) -> str:
    rule = ["---"] * len(NAMES) + ["---:"] * (len(lines[0]) - len(NAMES))
    return "\n".join("| " + " | ".join(line) + " |" for line in [lines[0], rule, *lines[1:]])


def tables(rows: Sequence[Row]) -> dict[str, list[list[str]]]:
    """Both tables by title."""
    return {
        "Joint form": cells(rows, HEADS, errors=True),
        "DAE form, together with the joint form": cells(rows, DAE_HEADS, errors=False),
    }


def text(rows: Sequence[Row]) -> str:
    return "\n\n".join(f"{title}\n{aligned(lines)}" for title, lines in tables(rows).items())


def document(rows: Sequence[Row], notes: str) -> str:
    """The tables in Markdown."""
    parts = [f"## {title}\n\n{markdown(lines)}" for title, lines in tables(rows).items()]
    return "\n\n".join([*parts, notes]) + "\n"


def write(rows: Sequence[Row], folder: Path, notes: str) -> list[Path]:
    """firmware.csv with every figure, firmware.md with the tables and notes."""
    figures = [*SIZES, *(k for k in rows[0].counts)]
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    structs = [f"sizeof_{name}" for name in rows[0].structs]
    writer.writerow([*NAMES, *figures, *structs, "angle_error", "tip_error"])
    for row in rows:
        errors = [f"{row.error[k]:.3e}" for k in ("angle", "tip")]
        writer.writerow([*names(row), *(row.figures[k] for k in figures), *row.structs.values(), *errors])
    files = {"firmware.csv": out.getvalue(), "firmware.md": document(rows, notes)}
    for name, content in files.items():
        (folder / name).write_text(content, encoding="utf-8")
    return [folder / name for name in files]


# ------------------------------------------------------------------------------------------- budgets


@dataclass(frozen=True)
class Verdict:
    """The rows held against the budgets."""

    failures: list[str]
    better: list[str]
    """Figures so far below their budget that it should be lowered."""
    remarks: list[str]


def budgets() -> dict:
    return tomllib.loads(BUDGETS.read_text(encoding="utf-8"))


def judge(rows: Sequence[Row], given: dict, compilers: dict[str, str]) -> Verdict:
    """Limits hold for every compiler; recorded figures, within the tolerance, for the one they were recorded with."""
    out = Verdict([], [], [])
    for row in rows:
        _judge_limits(row, given["limits"], out)
        recorded = given["recorded"].get(row.variant.name)
        compiler = compilers[row.variant.target.name]
        if recorded is None:
            out.failures.append(f"{row.variant.name}: no budget is recorded")
        elif compiler != given["compilers"].get(row.variant.target.name):
            out.remarks.append(f"{row.variant.name}: not compared with its budget, recorded with another compiler")
        else:
            _judge_recorded(row, dict(zip(given["columns"], recorded, strict=True)), given["tolerance"], out)
    return out


def _judge_limits(row: Row, limits: list[dict], out: Verdict) -> None:
    v = row.variant
    place = {"target": v.target.name, "real": v.precision, "layout": v.layout, "parameters": v.parameters}
    place |= {"arm": v.arm, "order": v.order}
    for limit in limits:
        if all(limit.get(key, here) == here for key, here in place.items()):
            over = {k: x for k, x in limit.items() if k not in place and row.figures[k] > x}
            out.failures.extend(f"{v.name}: {k} {row.figures[k]:,g}, the limit is {x:,g}" for k, x in over.items())


def _judge_recorded(row: Row, recorded: dict, tolerance: float, out: Verdict) -> None:
    for name, budget in recorded.items():
        found = row.figures[name]
        if found > budget * (1 + tolerance):
            out.failures.append(f"{row.variant.name}: {name} {found:,}, budget {budget:,} and {tolerance:.0%}")
        elif found < budget * (1 - tolerance):
            out.better.append(f"{row.variant.name}: {name} {found:,}, budget {budget:,}")


BUDGETED = ("flash", "flash_dae", "ram", "ram_dae", "stack", "stack_dae")


def record(rows: Sequence[Row], compilers: dict[str, str], notes: str) -> None:
    """Write what was measured as the new budgets, and all rows, if all were measured, as the committed table.

    The limits stay, and the budgets of rows that were not measured.
    """
    given, head = budgets(), BUDGETS.read_text(encoding="utf-8").partition("columns = ")[0]
    columns = [*BUDGETED, *rows[0].counts]
    kept = given["recorded"] if given["columns"] == columns else {}
    for row in rows:
        kept[row.variant.name] = [row.figures[k] for k in columns]
    names = [v.name for v in variants(list(TARGETS.values()))]
    compiled = given["compilers"] | compilers
    lines = ["columns = [", *(f'    "{name}",' for name in columns), "]", "", "[compilers]"]
    lines += [f'{k} = "{compiled[k]}"' for k in TARGETS if k in compiled]
    lines += ["", "[recorded]"]
    lines += [f"{name} = [{', '.join(map(str, kept[name]))}]" for name in names if name in kept]
    BUDGETS.write_text(head + "\n".join(lines) + "\n", encoding="utf-8")
    if len(rows) == len(names):
        TABLE.write_text(f"# ELLA on microcontrollers\n\n{document(rows, notes)}", encoding="utf-8")
