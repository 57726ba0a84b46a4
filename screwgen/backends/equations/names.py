"""The letters of coordinates, rates, efforts and parameters: short ones with numbers of axes and links."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from ...spec.fields import FIELDS
from ...spec.parameters import Parameter, parameters
from ...topology.chain import Chain
from .ring import Ring

LETTERS: dict[str, tuple[str, str]] = {
    "gravity": ("g", "g"),
    "length": ("l", "l"),
    "frame_at": ("a", "a"),
    "rhoA": ("rhoA", r"\rho A"),
    "EA": ("EA", "EA"),
    "EIy": ("EIy", "EI_y"),
    "EIz": ("EIz", "EI_z"),
    "GJ": ("GJ", "GJ"),
    "rhoIp": ("rhoIp", r"\rho I_p"),
    "GAy": ("GAy", "GA_y"),
    "GAz": ("GAz", "GA_z"),
    "rhoIy": ("rhoIy", r"\rho I_y"),
    "rhoIz": ("rhoIz", r"\rho I_z"),
    "damping.ratio": ("zeta", r"\zeta"),
    "damping.time": ("t_d", "t_d"),
    "joint.mount.xyz": ("p", "p"),
    "joint.mount.rpy": ("alpha", r"\alpha"),
    "joint.armature": ("J_a", "J_a"),
    "joint.damping": ("d", "d"),
    "joint.stiffness": ("k", "k"),
    "joint.drives.ratio": ("N", "N"),
    "joint.drives.rotor_inertia": ("J_r", "J_r"),
    "joint.drives.stiffness": ("k_g", "k_g"),
    "joint.drives.damping": ("d_g", "d_g"),
    "joint.drives.friction.viscous": ("b", "b"),
    "bodies.mass": ("m", "m"),
    "bodies.com": ("c", "c"),
    "bodies.inertia": ("I", "I"),
}
"""The letter of each kind of parameter, in text and in LaTeX; another kind is called by its key."""
FIRST = ("bodies.mass", "bodies.inertia", "joint.armature", "joint.drives.rotor_inertia", "rho")
LAST = ("gravity", "length", "frame_at", "bodies.com", "joint.mount")
"""The fields that stand first and last in a product: masses, all else, gravity, lengths."""


def order(p: Parameter) -> int:
    """Where a parameter stands in a product, as textbooks have it: ``m g l``."""
    begins = lambda fields: next((k for k, f in enumerate(fields) if p.field.startswith(f)), None)  # noqa: E731
    first, last = begins(FIRST), begins(LAST)
    return first if first is not None else len(FIRST) + (0 if last is None else 1 + last)


@dataclass(frozen=True)
class Name:
    """A symbol in text, which sympy has too, and in LaTeX."""

    text: str
    latex: str


def scripted(letter: tuple[str, str], *places: str) -> Name:
    """A letter with what stands below it; of a letter of several, or that has an index, this joins the index."""
    text, latex = letter
    below = ",".join(filter(None, places))
    name = "_".join([text, *filter(None, places)])
    if not below:
        return Name(name, latex)
    head, _, own = latex.partition("_")
    own = own.strip("{}")
    return Name(name, rf"{head}_{{{own + ',' if own else ''}{below}}}" if own or len(below) > 1 else f"{head}_{below}")


def dotted(name: Name, dots: int) -> Name:
    """The name of a rate or of an acceleration."""
    letter, _, place = name.text.partition("_")
    rate = "d" * dots + "ot"
    head, _, below = name.latex.partition("_")
    bare = head.removeprefix("{").removesuffix("}")
    return Name("_".join(filter(None, (letter + rate, place))), rf"\{rate}{{{bare}}}" + (f"_{below}" if below else ""))


def coordinate_names(chain: Chain) -> list[Name]:
    """Of joints ``q_1 …``, of rotors ``theta_1 …`` with the number of their axis, of modes ``eta_1 …``."""
    joints = chain.n_joints
    one = joints == 1
    names = [scripted(("q", "q"), "" if one else str(k + 1)) for k in range(joints)]
    offset = chain.tau_offset
    for i, key in enumerate(chain.keys):
        axes = (offset[i] + axis for axis in key.added_axes)
        names += [scripted(("theta", r"\vartheta"), "" if one else str(k + 1)) for k in axes]
    return names + list(modal_names(chain))


def modal_names(chain: Chain) -> Iterable[Name]:
    """``eta``; with the link's number where several links have modes, with the mode's where one has several."""
    counts = [key.modes for key in chain.keys]
    many = sum(map(bool, counts)) > 1
    for i, modes in enumerate(counts):
        for k in range(modes):
            yield scripted(("eta", r"\eta"), str(i + 1) * many, str(k + 1) * (modes > 1))


def effort_names(chain: Chain) -> list[Name]:
    """``tau_1 …``, one of each axis."""
    return [scripted(("tau", r"\tau"), "" if chain.n_tau == 1 else str(k + 1)) for k in range(chain.n_tau)]


def parameter_names(chain: Chain, used: Sequence[int]) -> dict[int, Name]:
    """Names of the parameters that equations have, by their place; only what tells them apart stands below a letter."""
    known = parameters(chain.robot)
    shown = [known[k] for k in used]
    names = {k: _name(chain, known[k], shown) for k in used}
    taken: dict[Name, int] = {}
    for k in used:  # what is left alike, such as axes of one link, is told apart by its full name
        if names[k] in taken:
            names[k] = spelled(known[k])
        taken[names[k]] = k
    return names


def _name(chain: Chain, p: Parameter, shown: Sequence[Parameter]) -> Name:
    letter = LETTERS.get(p.field)
    if letter is None:
        return spelled(p)
    robot, places = chain.robot, []
    if p.field.startswith("joint.") and not p.field.startswith("joint.mount") and p.link is not None:
        places.append(str(chain.tau_offset[_first(chain, p.link)] + p.index[0] + 1) if chain.n_joints > 1 else "")
    elif p.link is not None:
        places.append(str(p.link + 1) if len(robot.links) > 1 else "")
    if p.field.startswith("bodies.") and p.link is not None and len(robot.links[p.link].bodies) > 1:
        places[-1] += "abcdefghijklmnopqrstuvwxyz"[p.index[0] % 26]
    if components := FIELDS[p.field].components:
        alike = {other.index[-1] for other in shown if other.field == p.field}
        component = components[p.index[-1]]
        places.append((component if len(component) < 3 else component[0]) if len(alike) > 1 else "")
    return scripted(letter, *places)


def _first(chain: Chain, link: int) -> int:
    """The first segment of a link."""
    return next(k for k, segment in enumerate(chain.segments) if segment.link == link)


def spelled(p: Parameter) -> Name:
    """The whole name of a parameter."""
    words = re.sub(r"[^A-Za-z0-9]+", "_", p.name).strip("_")
    return Name(words, rf"\mathit{{{words}}}".replace("_", r"\_"))


MEANINGS = {
    "psi": ("turn of the tip section by bending", "rad"),
    "mu": ("mass of the beam", "kg"),
    "sigma": ("common part", ""),
}
"""What common parts are, and their units, by their letters."""


def part_names(
    ring: Ring, parts: Sequence[int], masses: Mapping[int, int | None], q: Sequence[int], chain: Chain
) -> dict[int, Name]:
    """Names of common parts, by the their generators: ``mu`` and ``psi`` with the link's number, else ``sigma``.

    ``masses``: those that are the mass of a link's beam; ``q``: the generators of the coordinates.
    """
    owners = {number: _owner(ring, number, masses, q, chain) for number in parts}
    out: dict[int, Name] = {}
    for number, (letter, link) in owners.items():
        alike = [k for k in parts if owners[k] == (letter, link)]
        mark = "abcdefghijklmnopqrstuvwxyz"[alike.index(number) % 26] * (len(alike) > 1)
        place = "" if link is None or len(chain.robot.links) == 1 else str(link + 1)
        out[number] = scripted((letter, rf"\{letter}"), place + mark)
    return out


def _owner(
    ring: Ring, number: int, masses: Mapping[int, int | None], q: Sequence[int], chain: Chain
) -> tuple[str, int | None]:
    """The letter of a common part, and the link to which it belongs."""
    if number in masses:
        return "mu", masses[number]
    part, turns = ring.generators[number].part, ring.generators[number].wave is not None
    links = [None] * (len(q) - chain.n_modes) + [i for i, key in enumerate(chain.keys) for _ in range(key.modes)]
    held = [link for x, link in zip(q, links, strict=True) if part is not None and x in part.generators()]
    if not turns or not held or held[0] is None:
        return "sigma", None
    return "psi", chain.segments[held[0]].link
