"""The report of an identification: one HTML page, a list of sections, each a template and what it shows."""

from __future__ import annotations

import base64
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..backends.templates import markup, render
from .report_figures import over_start, spectra
from .residuals import spectrum

if TYPE_CHECKING:
    from .identification import Identification

Context = Mapping[str, Any]


class ReportSection(NamedTuple):
    """A part of the report: its title, its template below templates/identify, and what that shows."""

    title: str
    template: str
    context: Callable[[Identification], Context]


class ShownSection(NamedTuple):
    """A section as it stands on the page."""

    title: str
    html: str


def report_html(found: Identification) -> str:
    """The page, which needs nothing else."""
    contexts = [(section, section.context(found)) for section in SECTIONS]
    shown = [
        ShownSection(section.title, markup(render(f"identify/{section.template}.html.jinja", **context)))
        for section, context in contexts
        if context
    ]
    return render("identify/page.html.jinja", title=f"Identification of {found.robot}", sections=shown)


def _picture(png: bytes) -> str:
    return "data:image/png;base64," + base64.b64encode(png).decode()


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
    return {"lines": found.notes, "nothing": "Nothing odd was found."}


def _undetermined(found: Identification) -> Context:
    return {"lines": found.undetermined, "nothing": "The data determine all numbers that were free."}


def _numbers(found: Identification) -> Context:
    rows = [
        {"name": x.name, "unit": x.unit, "start": f"{x.start:.4g}", "value": f"{x.value:.4g}"}
        | {"interval": x.interval, "open": not x.determined or bool(x.bound)}
        for x in found.estimates
    ]
    png = over_start(found.estimates)
    return {"rows": rows, "picture": _picture(png) if png else ""}


def _curves(found: Identification) -> Context:
    pictures = [{"label": f"{x.log}, measured and model", "source": _picture(x.picture())} for x in found.explained]
    return {"pictures": pictures}


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
    return {"rows": rows, "picture": _picture(spectra(of, found.frequencies))}


def _vibrations(found: Identification) -> Context:
    """Nothing, and no section, where none was measured."""
    return {"lines": [one.line() for one in found.vibrations]} if found.vibrations else {}


def _fit(found: Identification) -> Context:
    return {"rows": list(found.tried.items())}


SECTIONS: Sequence[ReportSection] = (
    ReportSection("How much the model explains", "logs", _logs),
    ReportSection("What is odd", "said", _notes),
    ReportSection("What the data do not determine", "said", _undetermined),
    ReportSection("Numbers, before and after", "numbers", _numbers),
    ReportSection("Measured vibrations", "said", _vibrations),
    ReportSection("Measured against model", "curves", _curves),
    ReportSection("What is left", "residuals", _residuals),
    ReportSection("The fit", "fit", _fit),
)
"""In the order of the page."""
