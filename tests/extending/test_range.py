"""A sensor that the product does not contain: how far the tip of an arm is from a beacon, in a filter."""

from dataclasses import replace

import numpy as np
import pytest
from helpers import QUICK, arm, link, model_of, relative

from screwgen import UsageError, assemble
from screwgen.algorithms.measurement import Measurement, SensorNumber, root
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.simulation.estimator import Estimator

SOFT = {"modes": {"bending_y": 1, "bending_z": 1}, "section": {"EIy": 300.0, "EIz": 200.0}}
BEACON = np.array([1.5, -0.4, 0.8])


def distance(f, q, beacon):
    """Of the last tip from a point of the inertial frame."""
    _, tip = f.poses(q)[1][f.chain.last]
    return [root(sum((a - b) * (a - b) for a, b in zip(tip, beacon, strict=True)))]


RANGE = Measurement(
    "tip_range",
    "q",
    distance,
    lambda chain: ["forearm.tip"],
    unit="m",
    about="the distance of the tip from a beacon",
    numbers=(SensorNumber("beacon", lambda chain: 3, "m: in the inertial frame"),),
)
NAMES = ["encoder", RANGE]
FILTERS = [CompiledEstimator, Estimator]


def begun(kind, model, noise, measurements=NAMES):
    e = kind(model, measurements=measurements, **({"flags": QUICK} if kind is CompiledEstimator else {}))
    rigid = np.arange(model.nv) < model.chain.eta_v
    q = model.chain.integrate(np.array(model.chain.home), np.where(rigid, 0.3, 1e-3), SERIES)
    if model.chain.closing.rows:
        q = assemble(model, [0.3, -0.4, -1.5], hold=["a.joint[0]"])
    e.start(q, 0.1 * rigid, np.where(rigid, 0.03, 1e-4), np.where(rigid, 0.1, 1e-3), noise)
    return e


@pytest.fixture(scope="module", params=["fixed", "floating", "linkage"])
def model(request):
    if request.param == "linkage":
        bars = [link("a", 0.3, "y"), link("b", 0.7, "y"), link("c", 0.6, "y", parent="world")]
        bars[2]["joint"]["mount"] = {"xyz": [0.8, 0.0, 0.0]}
        return model_of(arm(*bars, loops=[{"between": ["b.tip", "c.tip"], "joint": {"axes": ["y"]}}]))
    hull = {"bodies": [{"at": "base", "mass": 3.0, "inertia": [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]}]}
    upper = link("upper", 0.7, ("z", "y"), **SOFT)
    if request.param == "floating":
        return model_of(arm(link("hull", 0.2, [], **hull), upper, base="floating"))
    return model_of(arm(upper, link("forearm", 0.4, "z", **SOFT)))


def test_its_row_is_the_difference_of_what_it_measures(model):
    e = begun(Estimator, model, Noise(0.0, encoder=1e-3, tip_range=1e-3, beacon=BEACON))
    (q, _), f, n = e.state, model.numpy(), model.nv
    tau, w_ext = np.zeros(model.n_tau), np.zeros((model.n_links, 6))
    far = lambda q: np.linalg.norm(f.tip_pose(q)[1] - BEACON)  # noqa: E731
    found = e.compared(RANGE, np.zeros(1), tau, w_ext)
    assert found.rest[0] == pytest.approx(-far(q), rel=1e-14)
    h = 1e-3
    at = lambda u: far(model.chain.integrate(q, u, SERIES))  # noqa: E731
    thirds = [(8 * (at(u) - at(-u)) - at(2 * u) + at(-2 * u)) / (12 * h) for u in h * np.eye(n)]
    assert np.max(np.abs(found.H[0, :n] - thirds)) < 1e-8 and not found.H[0, n:].any()


def test_both_filters_take_it(model):
    """NumPy and C to 1e-12; the estimate goes to where the beacon sees the tip."""
    noise = Noise(1e-3, 1e-6, encoder=1e-2, tip_range=1e-3, beacon=BEACON, gate=50.0)
    filters, still = [begun(kind, model, noise) for kind in FILTERS], np.zeros((model.n_links, 6))
    told = np.linalg.norm(model.numpy().tip_pose(filters[1].state[0])[1] - BEACON) + 0.01
    for _ in range(3):
        for e in filters:
            e.predict(np.zeros(model.n_tau), still, 1e-4)
            e.update(np.zeros(model.n_tau), still, tip_range=[told])
        mine, other = ([*e.state, e.covariance] for e in filters)
        assert max(map(relative, mine, other)) < 1e-12
    assert np.linalg.norm(model.numpy().tip_pose(filters[0].state[0])[1] - BEACON) == pytest.approx(told, abs=1e-4)
    assert filters[0].consistency.squared == pytest.approx(filters[1].consistency.squared, rel=1e-6)


def test_what_is_said_wrongly_of_it_is_refused_in_a_line(model):
    for kind in FILTERS:
        for change, said in (
            ({"tip_range": [-1.0]}, "tip_range: must be a number >= 0, or 1 of them"),
            ({"beacon": [0.0, 1.0]}, "beacon: must be a finite number, or 3 of them"),
            ({"tip_rage": 1.0}, "tip_rage: is nothing that is measured; choose .* did you mean 'tip_range'"),
        ):
            with pytest.raises(UsageError, match=said):
                begun(kind, model, Noise(0.0, **change))
    with pytest.raises(UsageError, match="measurements: 'my range' cannot be a name; take another of letters"):
        begun(Estimator, model, Noise(0.0), [replace(RANGE, name="my range")])
    with pytest.raises(UsageError, match="measurements: 'tip_range' is there twice; leave one of them out"):
        begun(Estimator, model, Noise(0.0), [RANGE, RANGE])
