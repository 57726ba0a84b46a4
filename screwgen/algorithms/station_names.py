"""The names of what a link has at its stations, other sections than the tip at which it carries links."""

from __future__ import annotations

import re

STATION = re.compile(r"_at\d+$")
"""The end of the name of what a link has at a station, as it has at its tip."""


def plain(name: str) -> str:
    """The name of a signal at the tip from that of the same at a station."""
    return STATION.sub("", name)


def at_station(name: str, number: int) -> str:
    """The name of a signal of the tip at a station of the link: `at0.p` of `tip.p`, `w.r_T_at0` of `w.r_T`."""
    return f"at{number}.{name[4:]}" if name.startswith("tip.") else f"{name}_at{number}"


def edge_name(name: str, station: int) -> str:
    """The name of what is computed for a link that is carried at a station, or at the tip (-1)."""
    return name if station < 0 else at_station(name, station)
