"""A change of a robot file that changes the model changes the document: one value at a time, of every feature."""

import copy

import numpy as np
import pytest
from conftest import swept
from document_robots import robot_with
from helpers import model_of
from pydantic import ValidationError
from test_document_reader import state

from screwgen import Robot, UsageError
from screwgen.backends.latex import document as latex

ROBOTS = {
    "transmissions": ("order 2", "four-bar", "stops", "time", "hinge loop"),
    "tendons": ("one exact", "tendons", "elastic cylinder", "spring", "ratio"),
    "couplings": ("varying", "mounted", "rigid", "passive", "skew", "coupling"),
}
OTHERS = {"open": "crossed", "crossed": "open", "fore.tip": "hand.tip", "stay.tip": "cart.tip", "left": "middle"}
OTHERS |= {"hand.joint[0]": "upper.joint[0]", "fore.joint[0]": "upper.joint[0]", "x": "z", "y": "x", "z": "y"}
"""What stands for a word of a file instead."""
PARTS = 16
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
    new = OTHERS.get(old) if isinstance(old, str) else (not old if isinstance(old, bool) else old)
    if isinstance(new, int | float) and not isinstance(new, bool):
        new = old + 1 if isinstance(old, int) else 1.25 * old or 0.01
    part[at[-1]] = new
    return None if new is None else out


@pytest.mark.parametrize("part", swept(range(PARTS), 0))
@pytest.mark.parametrize("name", ROBOTS)
def test_every_change_of_the_model_is_seen_in_the_document(name, part):
    robot = robot_with(*ROBOTS[name])
    text = latex.document(Robot.model_validate(robot))
    seen = 0
    for at in [*places(robot)][-1 - part :: -PARTS]:
        try:
            other = (new := changed(robot, at)) and Robot.model_validate(new)
            same = other and latex.document(other) == text
        except (ValidationError, UsageError):
            continue  # the file refuses it
        seen += bool(other)
        if same:
            own, given = model_of(robot).numpy(), state(model_of(robot))
            pairs = zip(own.forward_dynamics(*given), model_of(new).numpy().forward_dynamics(*given), strict=True)
            assert all(np.allclose(a, b, rtol=1e-12, atol=1e-12) for a, b in pairs), f"{at} changes the model unseen"
    assert seen > 3
