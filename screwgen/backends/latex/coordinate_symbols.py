"""The symbols of coordinates and inputs in a document, numbered along the whole robot; LaTeX."""

from __future__ import annotations

from ...topology.chain import Chain


def axes(chain: Chain) -> list[str]:
    """Of the axes of joints ``q_1 …``, with the number of their input."""
    return [rf"q_{{{k + 1}}}" for k in range(chain.n_joints)]


def rotors(chain: Chain) -> dict[int, str]:
    """By the axis: of the rotor's angle behind an elastic gear, or of how far it is ahead of a transmission."""
    letters = {joint: "e" if joint in chain.elastic_travels else r"\vartheta" for joint in chain.added_joints}
    return {joint: rf"{letter}_{{{joint + 1}}}" for joint, letter in letters.items()}


def modes(chain: Chain) -> list[str]:
    """Of the modes, with the number of the link and that within the link."""
    return [rf"\eta_{{{i + 1},{k + 1}}}" for i, key in enumerate(chain.keys) for k in range(key.modes)]


def inputs(chain: Chain) -> list[str]:
    """Of the inputs, a symbol for each line of a document's table of them: of each axis, each tendon and so on."""
    return [line.symbol for row, own in chain.inputs.items() for line in row.lines(chain, own.start + 1)]
