"""A program that reads the document of a robot alone computes the robot's accelerations and joint wrenches."""

import numpy as np
import pytest
from conftest import swept
from document_reader import accelerations_from_document
from document_robots import CHOICES, drawn, robot_with
from helpers import model_of

TOLERANCE = 1e-10


def state(model, seed=3):
    """Coordinates, rates, inputs and wrenches without pattern; loops may be open, which all equations allow."""
    rng, chain = np.random.default_rng(seed), model.chain
    q, v = rng.uniform(0.2, 0.5, model.nq), rng.normal(size=model.nv)
    q[chain.eta_q :] *= 0.03
    v[model.nv - chain.n_modes :] *= 0.2
    for part in chain.curved:
        turn = slice(part.q.start + part.joint.turn_at, part.q.start + part.joint.turn_at + 4)
        q[turn] = [0.8, 0.3, -0.4, np.sqrt(1 - 0.8**2 - 0.3**2 - 0.4**2)]
    return q, v, rng.normal(size=model.n_tau), rng.normal(size=(model.n_links, 6))


def judged(robot) -> float:
    """How far the reader is from the model, the larger of both relative errors."""
    model = model_of(robot)
    given = state(model)
    own, read = model.numpy().forward_dynamics(*given), accelerations_from_document(model, *given)
    return max(np.max(np.abs(a - b)) / max(1.0, np.max(np.abs(a))) for a, b in zip(own, read, strict=True))


SINGLE = ("exact", "segments", "coupling")
TOGETHER = range(3)


@pytest.mark.parametrize("name", swept(CHOICES, *SINGLE))
def test_the_document_of_every_feature_is_complete(name, tmp_path):
    assert judged(robot_with(name, folder=tmp_path)) < TOLERANCE


@pytest.mark.parametrize("seed", swept(range(40), *TOGETHER))
def test_so_is_that_of_features_together(seed, tmp_path):
    assert judged(drawn(seed, tmp_path)) < TOLERANCE
