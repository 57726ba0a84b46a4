"""The arm that the paper's evidence rests on is the one of the example file."""

from pathlib import Path

import numpy as np
import pytest

import screwgen
from screwgen.paper.arm import SET_POINTS, ella

EXAMPLE = screwgen.load(Path(__file__).resolve().parents[2] / "examples" / "ella_paper.toml")


@pytest.mark.parametrize("i", [0, 1])
def test_links_are_those_of_the_example(i):
    link, given = ella().links[i], EXAMPLE.links[i]
    assert (link.length, link.joint, link.bodies, link.modes) == (given.length, given.joint, given.bodies, given.modes)
    for name in ("rhoA", "EA", "EIy", "EIz", "rhoIp"):
        assert getattr(link.section, name) == pytest.approx(getattr(given.section, name), rel=4e-3)
    assert ella().gravity == EXAMPLE.gravity


def locked(**options) -> np.ndarray:
    return screwgen.natural_frequencies(screwgen.derive(ella(locked=True, **options)))


@pytest.mark.parametrize("rotation", [True, False])
def test_welds_are_the_set_points(rotation):
    model = screwgen.derive(ella(section_rotation=rotation))
    turned = screwgen.natural_frequencies(model, [*SET_POINTS, *(model.nq - 3) * [0.0]])
    assert locked(section_rotation=rotation) == pytest.approx(turned, rel=1e-9)


def test_bodies_beyond_the_joints_are_the_same_arm():
    assert locked(bodies_beyond=True) == pytest.approx(locked(), rel=1e-6)
