"""A functional mock-up unit as an archive: descriptions, sources and a binary."""

from __future__ import annotations

import hashlib
import io
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass

from ...errors import UsageError
from ..c.project import CProject
from . import description
from .code import TOKEN, sources
from .variables import variables

TIME = (1980, 1, 1, 0, 0, 0)
"""The time of all entries: the earliest that an archive can state."""

VERSIONS = {"fmu2": 2, "fmu3": 3}
"""The version of FMI of each target."""


@dataclass(frozen=True)
class Unit:
    """What is in a unit but its binary."""

    name: str
    version: int
    sources: dict[str, str]
    descriptions: dict[str, bytes]
    derived: bool
    """Whether it has directional derivatives."""


def unit(project: CProject, programs: dict, target: str) -> Unit:
    """The unit of a robot in the version of FMI of ``target``; ``programs`` are those of :func:`.code.content`.

    Its token is the digest of what it holds, so equal robots have equal tokens.
    """
    chain, version = project.chain, VERSIONS[target]
    if not chain.nv:
        raise UsageError(f"robot '{project.name}' has no coordinates, so there is nothing to simulate; give it a joint")
    answers = programs["answers"]
    found = variables(answers, list(project.methods), project.baked is not None)
    plain = sources(project, version, found, programs)
    token = _token(plain)
    files = {name: text.replace(TOKEN, token) for name, text in plain.items()}
    listed = sorted(name for name in files if name.endswith(".c"))
    derived = programs["derived"]
    tool = f"screwgen {project.version}"
    model = description.model_description(answers, version, found, token, tool, listed, derived)
    descriptions = {"modelDescription.xml": model}
    if version == 3:
        descriptions["sources/buildDescription.xml"] = description.build_description(project.name, listed)
        descriptions["terminalsAndIcons/terminalsAndIcons.xml"] = description.terminals(answers, found)
    return Unit(project.name, version, files, descriptions, derived)


def _token(files: Mapping[str, str]) -> str:
    """A GUID of what the files hold."""
    digest = hashlib.sha256("".join(f"{name}\0{text}\0" for name, text in sorted(files.items())).encode()).hexdigest()
    return "{" + "-".join((digest[:8], digest[8:12], digest[12:16], digest[16:20], digest[20:32])) + "}"


def archive(made: Unit, binary: bytes | None, place: str = "") -> bytes:
    """The bytes of the .fmu; ``place``: the folder of the binary, of this machine's kind."""
    entries: dict[str, bytes] = dict(made.descriptions)
    entries |= {f"sources/{name}": text.encode() for name, text in made.sources.items()}
    if binary is not None:
        entries[f"binaries/{place}/{made.name}.so"] = binary
    return _zipped(entries)


def _zipped(entries: Mapping[str, bytes]) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as file:
        for name in sorted(entries, key=lambda name: (name != "modelDescription.xml", name)):
            entry = zipfile.ZipInfo(name, TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            file.writestr(entry, entries[name])
    return out.getvalue()
