"""A change of a robot file that changes the model changes the document: one value at a time, of every feature."""

import copy

import numpy as np
import pytest
from conftest import swept
from document_robots import robot_with
from helpers import model_of
from pydantic import ValidationError
from test_document_reader import state

from screwgen import Robot
from screwgen.backends.latex import document as latex

ROBOTS = {
    "transmissions": ("order 2", "four-bar", "stops", "time", "hinge loop"),
    "tendons": ("one exact", "tendons", "elastic cylinder", "spring", "ratio"),
    "forces": ("forces", "slide", "mounted"),
    "couplings": ("varying", "mounted", "rigid", "passive", "skew", "coupling"),
}
OTHERS = {"open": "crossed", "crossed": "open", "fore.tip": "hand.tip", "stay.tip": "cart.tip", "left": "middle"}
OTHERS |= {"hand.joint[0]": "upper.joint[0]", "fore.joint[0]": "upper.joint[0]", "right": "middle"}
OTHERS |= {"upper.lug": "upper.tip", "hand.tip": "fore.tip", "marker": "world"}
OTHERS |= {"tip": "base", "base": "tip", "exact": 2, "world": "upper"}
OTHERS |= {"x": [0.6, 0.8, 0.0], "y": [0.0, 0.6, 0.8], "z": [0.8, 0.0, 0.6]}
"""What stands for a word of a file instead."""
PARTS = 32
"""Every so many values are changed in one test."""
UNSEEN = ("name",)
"""Keys that name a link: all that is called after it changes."""


def places(part, at=()):
    """The places of all values of a robot file."""
    entries = part.items() if isinstance(part, dict) else enumerate(part) if isinstance(part, list) else ()
    for key, value in entries:
        if isinstance(value, dict | list):
            yield from places(value, (*at, key))
        elif key not in UNSEEN or "tendons" in at:
            yield (*at, key)


def changed(robot, at):
    """The robot with another value at a place; None if there is none."""
    out = copy.deepcopy(robot)
    part = out
    for key in at[:-1]:
        part = part[key]
    old = part[at[-1]]
    part[at[-1]] = new = another(old, at[-1])
    return None if new is None else out


def another(old, key):
    """A value that may stand in place of one."""
    if isinstance(old, str):
        return OTHERS.get(old)
    if isinstance(old, bool):
        return not old
    if isinstance(old, int):
        return 1 if key == "order" else old + 1
    return 1.25 * old or 0.01


def variants(robot):
    """The places of all values that can be changed, with the robot that has another there."""
    out = []
    for at in places(robot):
        try:
            out += [(at, Robot.model_validate(new))] if (new := changed(robot, at)) else []
        except ValidationError:
            continue  # the file refuses it
    return out


@pytest.mark.parametrize("part", swept(range(PARTS), 0))
@pytest.mark.parametrize("name", ROBOTS)
def test_every_change_of_the_model_is_seen_in_the_document(name, part):
    robot = robot_with(*ROBOTS[name])
    text, own = latex.document(Robot.model_validate(robot)), model_of(robot)
    chosen = variants(robot)[-1 - part :: -PARTS]
    assert len(chosen) > 1
    for at, other in chosen:
        if latex.document(other) == text:
            given, others = state(own), type(own)(other).numpy()
            pairs = zip(own.numpy().forward_dynamics(*given), others.forward_dynamics(*given), strict=True)
            assert all(np.allclose(a, b, rtol=1e-12, atol=1e-12) for a, b in pairs), f"{at} changes the model unseen"
