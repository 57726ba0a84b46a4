"""Sensors that the product does not contain, in a filter: an inclinometer of two axes, and the bearing of a beacon."""

from dataclasses import dataclass

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of, relative

from screwgen.algorithms.measurement import Measurement, SensorNumber, along_changes, root
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator

SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
BEACON = np.array([1.5, -0.4, 0.8])


def seen(f, q, vector):
    """A vector of the inertial frame in axes of the last tip."""
    R, _ = f.poses(q)[1][f.chain.last]
    return [sum(R[3 * i + k] * vector[i] for i in range(3)) for k in range(3)]


def direction(f, q, beacon):
    """What leads from the last tip to a point of the inertial frame, in axes of the tip, x and y."""
    _, tip = f.poses(q)[1][f.chain.last]
    return seen(f, q, [b - a for a, b in zip(tip, beacon, strict=True)])[:2]


TILT = Measurement(
    "tilt",
    "q",
    lambda f, q: [-x for x in seen(f, q, f.gravity)[:2]],
    lambda chain: ["x", "y"],
    unit="m/s^2",
    about="what an accelerometer at the last tip reads while nothing moves, along x and y",
)


@dataclass(frozen=True)
class Bearing(Measurement):
    """The angle of a direction about z: its innovation is the sine of the difference, which knows no whole turns."""

    readings = 2

    def innovation(self, measured, expected):
        c, s = expected
        return [(measured[1] * c - measured[0] * s) / root(c * c + s * s)]

    def slopes(self, f, given, expected):
        c, s = expected
        return [[[(c * ds - s * dc) / (c * c + s * s)] for dc, ds in along_changes(f, given["q"], expected)], [], []]


BEARING = Bearing(
    "bearing",
    "q",
    direction,
    lambda chain: ["about z"],
    unit="rad",
    about="the angle about z of the last tip at which it sees a beacon, as its cosine and sine",
    numbers=(SensorNumber("beacon", lambda chain: 3, "m: in the inertial frame"),),
)
FILTERS = [CompiledEstimator, Estimator]
GIVEN = {"encoder": 1e-2, "tilt": 1e-3, "bearing": 1e-3, "beacon": BEACON}


def begun(kind, model):
    more = {"flags": QUICK} if kind is CompiledEstimator else {}
    e = kind(model, measurements=["encoder", TILT, BEARING], **more)
    rigid = np.arange(model.nv) < model.chain.eta_v
    q = model.chain.integrate(np.array(model.chain.home), np.where(rigid, 0.3, 1e-3), SERIES)
    e.start(
        q, 0.1 * rigid, np.where(rigid, 0.03, 1e-4), np.where(rigid, 0.1, 1e-3), Noise(1e-3, 1e-6, gate=50.0, **GIVEN)
    )
    return e


@pytest.fixture(scope="module", params=["fixed", "floating"])
def model(request):
    hull = {"bodies": [{"at": "base", "mass": 3.0, "inertia": [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]}]}
    upper, more = link("upper", 0.7, ("z", "y"), **SOFT), {"gravity": (0.0, -3.0, -6.0)}
    if request.param == "floating":
        return model_of(arm(link("hull", 0.2, [], **hull), upper, base="floating", **more))
    return model_of(arm(upper, link("forearm", 0.4, "z", **SOFT), **more))


def read(model, q):
    """What both say in a posture: the tilt, and the beacon's direction as the tip sees it."""
    R, r = model.numpy().tip_pose(q)
    return -(np.array(R).T @ np.array([0.0, -3.0, -6.0]))[:2], (np.array(R).T @ (BEACON - r))[:2]


def angle(model, q):
    return np.arctan2(*read(model, q)[1][::-1])


@pytest.mark.parametrize("row, of", [(TILT, lambda m, q: read(m, q)[0]), (BEARING, angle)], ids=["tilt", "bearing"])
def test_their_rows_are_differences_of_what_they_measure(model, row, of):
    e = begun(Estimator, model)
    (q, _), n, h = e.state, model.nv, 1e-3
    still = np.zeros(model.n_tau), np.zeros((model.n_links, 6))
    found = e.compared(row, np.array([1.0, 0.0]), *still)
    want = [1.0, 0.0] - of(model, q) if row is TILT else np.sin(-angle(model, q))
    assert found.rest == pytest.approx(want, rel=1e-12)
    at = lambda u: np.atleast_1d(of(model, model.chain.integrate(q, u, SERIES)))  # noqa: E731
    thirds = [(8 * (at(u) - at(-u)) - at(2 * u) + at(-2 * u)) / (12 * h) for u in h * np.eye(n)]
    assert np.max(np.abs(found.H[:, :n].T - thirds)) < 1e-7 and not found.H[:, n:].any()


def test_both_filters_take_them(model):
    """NumPy and C to 1e-12; the estimate goes to where tilt and bearing are those that are told."""
    filters, still = [begun(kind, model) for kind in FILTERS], np.zeros((model.n_links, 6))
    tilt, _ = read(model, filters[1].state[0])
    turned = angle(model, filters[1].state[0]) + 0.01
    for _ in range(3):
        for e in filters:
            e.predict(np.zeros(model.n_tau), still, 1e-4)
            e.update(np.zeros(model.n_tau), still, tilt=tilt + 0.02, bearing=[np.cos(turned), np.sin(turned)])
        mine, other = ([*e.state, e.covariance] for e in filters)
        assert max(map(relative, mine, other)) < 1e-12
    assert angle(model, filters[0].state[0]) == pytest.approx(turned, abs=2e-3)
    assert read(model, filters[0].state[0])[0] == pytest.approx(tilt + 0.02, abs=2e-3)
