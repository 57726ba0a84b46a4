"""The report of an identification, section by section."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..plotting.report_page import Context, ReportSection, TableRow, embedded, report_page, said, table
from .report_figures import over_start, spectra
from .residuals import spectrum

if TYPE_CHECKING:
    from .identification import Identification


def report_html(found: Identification) -> str:
    """The page, which needs nothing else."""
    return report_page(f"Identification of {found.robot}", SECTIONS, found)


def _percent(share: float) -> str:
    return f"{100 * share:.2f}" if np.isfinite(share) else "–"


def _logs(found: Identification) -> Context:
    rows = []
    for log in found.explained:
        of = {name: log.share(name) for name in ("before", "whole", "windows")}
        kind = "held out" if log.held_out else "fitted"
        for sensor in of["whole"]:
            rows.append(
                {"log": log.log, "kind": kind, "sensor": sensor} | {k: _percent(x[sensor]) for k, x in of.items()}
            )
    return {"rows": rows}


def _notes(found: Identification) -> Context:
    return said(found.notes, "Nothing odd was found.")


def _undetermined(found: Identification) -> Context:
    return said(found.undetermined, "The data determine all numbers that were free.")


def _pairs(found: Identification) -> Context:
    head = ("number", "with", "what would tell them apart", "correlation", "if one were known the other would be")
    rows = [
        TableRow((x.first, x.second, x.remedy, f"{x.correlation:+.2f}", f"{x.better:.2g} times better"))
        for x in found.pairs
    ]
    return table(head, rows, words=3) if rows else {}


def _numbers(found: Identification) -> Context:
    rows = [
        {"name": x.name, "unit": x.unit, "start": f"{x.start:.4g}", "value": f"{x.value:.4g}"}
        | {"interval": x.interval, "open": not x.determined or bool(x.bound)}
        for x in found.estimates
    ]
    png = over_start(found.estimates)
    return {"rows": rows, "picture": embedded(png) if png else ""}


def _curves(found: Identification) -> Context:
    return table((), (), pictures={f"{x.log}, measured and model": x.picture() for x in found.explained})


def _residuals(found: Identification) -> Context:
    fitted = [log for log in found.explained if not (log.held_out or log.static)]
    if not fitted:
        return {"rows": [], "picture": ""}
    of = {sensor: spectrum(fitted, sensor) for sensor in fitted[0].sensors}
    first = min(found.frequencies, default=0.0)
    rows = []
    for sensor, (f, power) in of.items():
        below = float(np.sum(power[f < first]) / max(np.sum(power), 1e-300))
        correlation = found.whiteness.get(sensor, float("nan"))
        below_text = f"{100 * below:.0f} %" if first else "–"
        rows.append({"sensor": sensor, "correlation": f"{correlation:.2f}", "below": below_text})
    return {"rows": rows, "picture": embedded(spectra(of, found.frequencies))}


def _vibrations(found: Identification) -> Context:
    """Nothing, and no section, where none was measured."""
    return said([one.line() for one in found.vibrations]) if found.vibrations else {}


def _fit(found: Identification) -> Context:
    return {"rows": list(found.tried.items())}


SECTIONS: Sequence[ReportSection[Identification]] = (
    ReportSection("How much the model explains", "identify/logs", _logs),
    ReportSection("What is odd", "report/said", _notes),
    ReportSection("What the data do not determine", "report/said", _undetermined),
    ReportSection("Numbers, before and after", "identify/numbers", _numbers),
    ReportSection("Numbers that are hard to tell apart", "report/table", _pairs),
    ReportSection("Measured vibrations", "report/said", _vibrations),
    ReportSection("Measured against model", "report/table", _curves),
    ReportSection("What is left", "identify/residuals", _residuals),
    ReportSection("The fit", "identify/fit", _fit),
)
"""In the order of the page."""
