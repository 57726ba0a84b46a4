"""A body that the product does not contain: a rigid body given by the masses and places of its points."""

from dataclasses import dataclass

import numpy as np
import pytest
import sympy as sp
from conftest import swept
from helpers import link, model_of, relative
from outside import Outside, every_check

from screwgen.algebra.expression import matrix, number, vector


@dataclass(frozen=True)
class PointCloud:
    """Points of a body, in F_i axes from the joint point: masses (kg) and places (m)."""

    masses: tuple[float, ...]
    places: tuple[tuple[float, float, float], ...]

    def moments(self, _):
        """Mass, first and second moment about the joint point."""
        m, r = np.array(self.masses), np.array(self.places)
        second = np.einsum("k,ki,kj->ij", m, r, r)
        return number(sp.Float(m.sum())), vector(list(m @ r), r"\mathbf{S}"), matrix(second, (3, 3), r"\mathbf{J}")


def cloud(seed: int) -> PointCloud:
    rng = np.random.default_rng([seed, 5])
    return PointCloud(tuple(rng.uniform(0.1, 1.0, 7)), tuple(map(tuple, rng.normal(size=(7, 3)) * 0.3)))


def arm(body=None, bodies=()) -> dict:
    """A flexible link, and a rigid one without section and length that carries a third."""
    rod = link("rod", 0.8, "y", 1.5, {"bending_y": 2, "bending_z": 2}, section={"EIy": 900.0, "EIz": 700.0})
    lump = {"name": "lump", "joint": {"axes": ["z", "x"], "mount": {"xyz": [0.1, 0.0, 0.05]}}, "bodies": list(bodies)}
    last = {"name": "last", "joint": {"axes": ["y"], "mount": {"xyz": [0.3, 0.1, 0.0]}}}
    last["bodies"] = [{"at": "tip", "mass": 0.7, "com": [0.2, 0.0, 0.1]}]
    lump |= {} if body is None else {"body": body}
    return {"name": "cloud", "gravity": [0.0, 0.0, -9.81], "links": [rod, lump, last]}


def same_body(points: PointCloud) -> list[dict]:
    """The points as one body of mass, centre and inertia; by the textbook."""
    m, r = np.array(points.masses), np.array(points.places)
    centre = m @ r / m.sum()
    d = r - centre
    I = sum(x * (p @ p * np.eye(3) - np.outer(p, p)) for x, p in zip(m, d, strict=True))
    entries = [I[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    return [{"at": "base", "mass": m.sum(), "com": list(centre), "inertia": entries}]


@pytest.fixture(scope="module", params=swept(range(2), 0))
def pair(request):
    points = cloud(request.param)
    return model_of(arm(body=points)), model_of(arm(bodies=same_body(points)))


@every_check
def test_a_cloud_moves_as_the_body_that_it_is(pair, check):
    rng, (found, expected) = np.random.default_rng(3), pair
    q, v = rng.normal(size=(2, found.nq)) * np.where(np.arange(found.nq) < found.n_joints, 0.3, 0.01)
    given = q, v, rng.normal(size=found.n_joints), rng.normal(size=(3, 6))
    Outside(found, given, *expected.numpy().forward_dynamics(*given)).holds(check)
    assert relative(found.numpy().energy(q, v), expected.numpy().energy(q, v)) < 1e-12


def test_everything_is_written(pair, tmp_path):
    names = pair[0].write(tmp_path / "out")
    assert any(name.endswith(".tex") for name in names)
    assert "rhoA" in (tmp_path / "out" / "c" / "cloud.h").read_text()


def test_a_file_cannot_state_one():
    from screwgen import Robot, RobotFileError

    message = r"body .link lump.: is 3; it must be a table with sid or npz, or a hashable Python object"
    with pytest.raises(RobotFileError, match=message):
        Robot(**arm(body=3))
