"""The check of filters: all that can be measured of a robot, in Python and in C."""

from __future__ import annotations

import numpy as np
from helpers import QUICK, relative
from scipy.spatial.transform import Rotation

from conformance.cases import Case
from conformance.numbers import near
from screwgen.algorithms.gauges import gauges
from screwgen.algorithms.measurement import Measurement
from screwgen.algorithms.measurement_names import chosen
from screwgen.algorithms.measurements import AT_MARKERS, FURTHER
from screwgen.backends.numpy.dae_step import SERIES
from screwgen.backends.numpy.estimated import opening
from screwgen.runtime.estimator import CompiledEstimator, Noise
from screwgen.runtime.measurements import known
from screwgen.runtime.parameter_states import ParameterState
from screwgen.simulation.estimator import Estimator
from screwgen.simulation.parameter_estimator import ParameterEstimator

PERIOD = 2e-3


def everything(case: Case) -> list[str]:
    """What a filter may be told; at the last marker one sensor, of each robot another, for brevity."""
    chain, at_marker = case.model.chain, AT_MARKERS[case.seed % len(AT_MARKERS)]
    names = [row.name for row in chosen(chain)] + [row.name for row in FURTHER if row.offered(chain)]
    along = [m.name for m in chain.markers if not m.is_tip and gauges(chain, [(m.segment, m.at)])]
    return [*names, f"{at_marker.name}@{chain.markers[-1].name}", *(f"strain@{m}" for m in along)]


def noise_of(case: Case, rows) -> tuple[Noise, np.ndarray]:
    """The noise of a filter's sensors, and the deviation at its start."""
    rigid = np.arange(case.model.nv) < case.model.chain.eta_v
    sensors = dict.fromkeys(known(rows), 0.02) | {"encoder": 1e-3, "strain": 1e-5}
    return Noise(np.where(rigid, 0.02, 1e-4), 1e-10, sensors=sensors), np.where(rigid, 1e-2, 1e-4)


def expected(case: Case, row: Measurement, e: Estimator) -> np.ndarray:
    """What a sensor says of the estimate: attitudes by other means, the rest by what is left of zeros."""
    (q, _), chain, f = e.state, case.model.chain, case.model.numpy()
    if row.group == 1:
        return -e.compared(row, np.zeros(row.n_values(chain)), *case.given[2:]).rest
    if row.name.startswith("marker"):
        return Rotation.from_matrix(f.marker_pose(q)[0][-1]).as_quat(scalar_first=True)
    own = [part for part in chain.curved if part.joint.in_space == row.name.startswith("base")]
    return np.concatenate([q[part.q.start + part.joint.turn_at :][:4] for part in own])


def estimator(case: Case) -> None:
    """The filter in Python is that in C, whatever it is told; both carry the inputs, all of them, as the model does."""
    model, (q, v, tau, w_ext), names = case.model, case.given, everything(case)
    filters = CompiledEstimator(model, flags=QUICK, measurements=names), Estimator(model, measurements=names)
    noise, deviation = noise_of(case, filters[1].measurements)
    for e in filters:
        e.start(q, v, deviation, 10 * deviation, noise)
    started = filters[1].state
    for e in filters:
        e.predict(tau, w_ext, PERIOD)
    (a, b), (c, d) = filters[0].state, filters[1].state
    near(np.concatenate([a, b]), np.concatenate([c, d]), case.agreement, "a prediction")
    after = case.c().step(*started, tau, w_ext, PERIOD, "modal_midpoint")
    if not model.chain.closing.rows:
        near(np.concatenate([c, d]), np.concatenate(after), case.agreement, "the prediction beside a step")
    alike(filters)
    rng, said = np.random.default_rng(0), {row.name: expected(case, row, filters[1]) for row in filters[1].measurements}
    for name, values in measured_by_functions(case, filters[1]).items():
        if name in said:
            near(said[name], values, case.agreement, f"{name} beside the function of the robot")
    for e in filters:
        e.put(*filters[1].state, filters[1].covariance)
    for name, values in said.items():
        told = values * (1 + 1e-4 * rng.uniform(size=values.size))
        for e in filters:
            e.update(tau, w_ext, **{name: told})
        one, other = (e.innovations[name] for e in filters)
        assert relative(one.value, other.value) < 1e-6 and relative(one.normalised, other.normalised) < 1e-6, name
        alike(filters)


def parameters(case: Case) -> None:
    """The filter in C that also finds three numbers of the robot equals that in Python, whatever it is told."""
    model, (q, v, tau, w_ext), names = case.model, case.given, everything(case)
    rng, stated = (
        np.random.default_rng(case.seed),
        dict(zip(model.parameter_names, model.parameter_values, strict=True)),
    )
    offered = [name for name in rng.permutation(list(stated)) if stated[name] and ".effort" not in name]
    opened = opening(model.chain, [model.parameter_names.index(name) for name in offered[:8]])
    offered = [name for name in offered[:8] if model.parameter_names.index(name) not in opened]
    states = [ParameterState(name, 0.05 * abs(stated[name]), 0.01 * stated[name] ** 2) for name in offered[:3]]
    own = ParameterEstimator(model, states, measurements=names)
    filters = CompiledEstimator(model, flags=QUICK, measurements=names, states=states), own
    noise, deviation = noise_of(case, own.measurements)
    for e in filters:
        e.start(q, v, deviation, 10 * deviation, noise)
        e.predict(tau, w_ext, PERIOD)
    alike(filters)
    for row in own.measurements:
        told = expected(case, row, own) * (1 + 1e-4 * rng.uniform(size=row.n_values(model.chain)))
        for e in filters:
            e.update(tau, w_ext, **{row.name: told})
        alike(filters)
        for name, value in own.values.items():
            assert abs(filters[0].values[name] - value) <= 1e-6 * own.deviations[name], name


def measured_by_functions(case: Case, e: Estimator) -> dict[str, np.ndarray]:
    """What functions of the robot say of the estimate at the last marker; they take inputs as they are, not held."""
    (q, v), (tau, w_ext), f = e.state, case.given[2:], case.model.numpy()
    found = {
        "gyro": f.gyro(q, v),
        "marker_position": f.marker_pose(q)[1],
        "point_position": f.marker_pose(q)[1] + f.marker_pose(q)[0] @ np.full(3, 0.02),
        "marker_velocity": f.marker_velocity(q, v),
        "marker_range": np.linalg.norm(f.marker_pose(q)[1] - 0.02, axis=1)[:, None],
    }
    if not case.model.chain.holds:
        found["accelerometer"] = f.accelerometer(q, v, tau, w_ext)
    ending = case.model.chain.markers[-1].name.replace(".", "_")
    return {f"{name}_{ending}": values[-1] for name, values in found.items()}


def alike(filters) -> None:
    """Mean and covariance, in standard deviations; what loops lock has none but rounding, and agrees to that."""
    (P, other), chain = (e.covariance for e in filters), filters[0].model.chain
    (x, _), (y, _) = (e.state for e in filters)
    sd, mean, spread = np.sqrt(np.diag(other)), np.abs(chain.difference(x, y, SERIES)), np.abs(P - other)
    locked = sd < 1e-9 * sd.max()
    assert mean[locked[: chain.nv]].max(initial=0.0) < 1e-12 and spread[locked].max(initial=0.0) < 1e-12 * sd.max() ** 2
    sd[locked] = np.inf
    assert np.max(mean / sd[: chain.nv]) < 1e-6
    assert np.max(spread / np.outer(sd, sd)) < 1e-6
