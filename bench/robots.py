"""The robots that the benchmark runs."""

from __future__ import annotations

from pathlib import Path

import screwgen

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
NAMES = ("ella", "three_link", "six_link")


def robot(name: str) -> screwgen.Robot:
    """An example, or ``three_link``: ELLA with a third link like its forearm, on a joint that turns the other way."""
    if name != "three_link":
        return screwgen.load(EXAMPLES / f"{name}.toml")
    ella = screwgen.load(EXAMPLES / "ella.toml")
    hand = ella.links[1].model_copy(update={"name": "hand", "joint": screwgen.Joint(axes=["y"])})
    return screwgen.Robot(name=name, gravity=ella.gravity, links=[*ella.links, hand])
