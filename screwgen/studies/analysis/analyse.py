"""The analysis: the assembled system, its blocks, its spectrum, and the integrators' stable step sizes.

What Section 6 of the paper argues for, (Msys_diff), (2T) and (DAESOL), is evaluated at a set of states; (stability)
is set beside step limits from the real spectrum.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ...backends.numpy.closing import OpenLoopError, closed, moving
from ...backends.numpy.dae_step import SERIES
from ...backends.numpy.travel_numbers import efforts
from ...errors import SingularError, UsageError
from ...robot_model import RobotModel
from ...simulation.collocated import left_out
from ...simulation.linearised import Law, check_step, speed
from ...simulation.linearised_loops import linearised
from ...simulation.mobility import loads_of_loops
from ...simulation.state import State, state_of
from ...simulation.validity import validity
from ...spec.parameters import turning
from ...spec.reduced import elastic, reach, sizes
from ...spec.robot import Link
from .findings import Findings, StateAnalysis
from .regularity import LinkRegularity, link_blocks, loops_of, regularity, structure, with_projectors_alone
from .spectrum import LinearMotion, check_moves, motions
from .step_limits import StepLimit, paper_bound, step_limits
from .text import report

SAMPLES = 20
TRIES = 4
"""How many postures more are drawn for a state with closed loops."""
SAG = 0.05
"""Random states bend a link by no more than this share of its length (torsion: this angle in rad)."""
WEIGHT = 9.81


class Analysis(Findings):
    """The findings, with the report on them."""

    def text(self) -> str:
        """The report, for a terminal."""
        return report(self)


# ------------------------------------------------------------------------------ the analysis


def analyse(
    model: RobotModel,
    states: Mapping[str, Any] | Sequence[Any] | None = None,
    step: float = 1e-3,
    controller: Law | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Analysis:
    """Rank, condition and definiteness of the assembled system, spectrum and step limits, at every one of `states`.

    A state is a `State`, or what `state_of` takes: q (nq,), or a dict of q, v, tau, w_ext; a mapping names them.
    None: everything zero, or the closed posture nearest to it, and random ones, `sample_states`. `step` in s: for which
    growth is reported. With a `controller(t, q, v)` its torques, held over each step, take the place of the states' and
    its gains enter the spectrum. Of a robot with loops the spectrum is that of the coordinates which the loops leave
    independent, and steps must bear the loops' stabilisation besides. A singular posture is reported, not raised.
    Raises UsageError, also where a loop is open.
    """
    check_step(step)
    given = _labelled(model, states, controller is None)
    if controller is not None and any(state.tau.any() for state in given.values()):
        raise UsageError("a state gives tau beside a controller; leave one of them out")
    found = []
    for k, (label, state) in enumerate(given.items()):
        found.append(analyse_state(model, label, state, step, controller))
        if progress:
            progress(k + 1, len(given))
    names = tuple(model.chain.names)
    head = (model.robot.name, names, model.nq, model.n_joints, float(step), controller is not None)
    return Analysis(*head, paper_bound(model), structure(model), tuple(found))


def analyse_state(
    model: RobotModel, label: str, state: State, step: float, controller: Law | None = None
) -> StateAnalysis:
    """The analysis of one state."""
    check_moves(model, state.v)
    system = projectors = acceleration = loops = None
    blocks: tuple[LinkRegularity, ...] = ()
    found: tuple[LinearMotion, ...] = ()
    limits: tuple[StepLimit, ...] = ()
    measures: tuple[tuple[float, ...], ...] = ()
    singular = ""
    try:
        loops = loops_of(model, state.q)
        reference = model.numpy()
        M = reference.assemble(reference.dae_state(state.q, state.v), state.tau, state.w_ext)[0]
        system, projectors = regularity(M), regularity(with_projectors_alone(model, M), M)
        blocks = tuple(link_blocks(model, M))
        tau = state.tau if controller is None else None
        motion = linearised(model, state.q, state.v, tau, controller, state.w_ext)
        acceleration, found = float(np.abs(motion.vdot).max(initial=0.0)), tuple(motions(motion))
        limits = tuple(step_limits(motion, step))
        measures = _measures(model, state, controller)
    except SingularError as error:
        singular = str(error)
    except np.linalg.LinAlgError:
        singular = "the mass matrix is lost to rounding; masses or lengths differ by too many orders of magnitude"
    if system is not None and not system.regular and not singular:
        singular = f"M_sys has rank {system.rank} of {system.size}"
    if loops is not None and not loops.regular and not singular and not model.chain.closing.overconstrained:
        singular = f"the rows of the loops have rank {loops.rank} of {loops.size}"
    turned = speed(model, state.v)
    return StateAnalysis(
        *(label, singular, system, projectors, blocks, acceleration, turned, found, limits, measures),
        left_out=left_out(model, state.q[None]),
        loops=loops,
    )


def _measures(model: RobotModel, s: State, controller: Law | None) -> tuple[tuple[float, ...], ...]:
    """How far every link is from the limits of the model, in a state under its torques or the controller's."""
    tau = s.tau if controller is None else controller(0.0, s.q.copy(), s.v.copy())
    return tuple(map(tuple, validity(model, s.q, s.v, tau, s.w_ext).values.tolist()))


def _labelled(model: RobotModel, states: Mapping[str, Any] | Sequence[Any] | None, hold: bool) -> dict[str, State]:
    if states is None:
        return first_state(model) | sample_states(model, SAMPLES, 0, hold)
    if not isinstance(states, Mapping):
        states = {f"state {k + 1}": state for k, state in enumerate(states)}
    if not states:
        raise UsageError("there are no states to analyse; give one")
    return {label: s if isinstance(s, State) else _state(s, model, label) for label, s in states.items()}


def _state(given: Any, model: RobotModel, label: str) -> State:
    listed = lambda x: x.tolist() if isinstance(x, np.ndarray) else x  # noqa: E731
    data = {key: listed(x) for key, x in given.items()} if isinstance(given, Mapping) else listed(given)
    return state_of(list(data) if isinstance(data, tuple) else data, model, label)


# ------------------------------------------------------------------------------ random states


def sample_states(model: RobotModel, count: int, seed: int = 0, hold: bool = True) -> dict[str, State]:
    """Random states by name: joints in ±π or ±1 m, rates in ±1 rad/s or m/s, modes as the arm's weight bends them.

    A mode's deflection is within ±what the weight of the whole arm would cause, but no more than a small share of
    the link's length; its rate is that of a vibration of such a size. `hold`: the torques balance the joints in
    the undeformed posture at rest; else they are zero. Loops are closed, the modes nearly as drawn, and rates keep
    them so; there are fewer states than asked for where most searches for closed postures end with open loops, or
    out of the reach of a four-bar linkage.
    A floating base rests at the inertial frame, and ball joints rest where they are drawn.
    """
    rng, m, n = np.random.default_rng(seed), model.n_joints, model.n_links
    deflection, rate = modal_scale(model)
    most = np.where(turning(model.robot), 1.0, 1 / np.pi)
    out: dict[str, State] = {}
    base, moves = np.zeros(model.chain.base_v), np.setdiff1d(np.arange(model.nv), model.chain.flat_v)
    is_mode = np.arange(model.nq) >= model.chain.eta_q
    for _ in range(count * (1 + TRIES)):
        if len(out) == count:
            break
        whole = lambda x: model.chain.with_added(x, model.parameter_values)  # noqa: E731
        drawn = model.chain.reached(most * rng.uniform(-np.pi, np.pi, m), np.pi)
        moved = np.concatenate([base, whole(drawn), deflection * rng.uniform(-1, 1, len(deflection))])
        q = model.chain.integrate(np.array(model.chain.home), moved, SERIES)
        v = np.concatenate([base, whole(rng.uniform(-1, 1, m)), rate * rng.uniform(-1, 1, len(rate))])
        try:
            q = closed(model.numpy(), np.where(is_mode, 0.0, q), is_mode) + np.where(is_mode, q, 0.0)
            q = closed(model.numpy(), q)
        except OpenLoopError:
            continue
        if not model.chain.within_reach(q):  # closing the loops has moved a joint out of the reach of its linkage
            continue
        v = moving(model.numpy(), q, v)
        v[moves] = 0.0  # a base has no part in the loops, and no ball joint stands beside one
        tau = holding(model, q) if hold else np.zeros(model.n_tau)
        out[f"sample {len(out) + 1}"] = State(q, v, tau, np.zeros((n, 6)))
    return out


def first_state(model: RobotModel) -> dict[str, State]:
    """Everything zero, with loops at rest in the closed posture nearest to it, by name; raises OpenLoopError."""
    still = state_of({}, model)
    if not model.chain.closing.rows:
        return {"zero": still}
    return {"closed": replace(still, q=closed(model.numpy(), still.q))}


def modal_scale(model: RobotModel) -> tuple[np.ndarray, np.ndarray]:
    """Deflections (n_modes,) and rates of random states, at most."""
    links, constants = model.robot.links, model.numpy().constants
    values = dict(zip(model.parameter_names, model.parameter_values, strict=True))
    beams = [_own_mass(values, link) for link in links]
    masses = [beam + sum(body.mass for body in link.bodies) for beam, link in zip(beams, links, strict=True)]
    K, M_eta = (np.array([x for c in constants for x in c[name]], float) for name in ("K", "M_eta"))
    turns = [d == "torsion" for key in model.chain.keys for d, _ in key.directions]
    own = [reach(link) / link.pieces for link in links]
    lengths = np.repeat(own, [link.pieces * len(sizes(link)) for link in links])
    unit = np.array([x for link in links for x in link.pieces * sizes(link)])
    load, room = WEIGHT * sum(masses) * np.where(turns, lengths, unit), SAG * np.where(turns, 1.0, lengths / unit)
    deflection = np.minimum(load / K, room)
    return deflection, deflection * np.sqrt(K / M_eta)


def _own_mass(values: dict[str, float], link: Link) -> float:
    """The mass of a link itself, kg; by the mean of its stations where it varies; 0 without a section."""
    if body := elastic(link):
        return body.mass
    section = f"{link.name}.section["
    stations = [x for name, x in values.items() if name.startswith(section) and name.endswith("].rhoA")]
    return (float(np.mean(stations)) if stations else values.get(f"{link.name}.rhoA", 0.0)) * (link.length or 0.0)


def holding(model: RobotModel, q: np.ndarray) -> np.ndarray:
    """Torques (n_tau,) where they act that carry the weight of the arm with undeformed links."""
    chain, p, still = model.chain, model.parameter_values, np.zeros(model.nv)
    straight = np.append(q[: chain.base_q], chain.with_inner(q[chain.base_q : chain.q_offset[-1]], p))
    force = chain.of_joints(model.numpy().bias(straight, still, loads_of_loops(model, straight, p)), rates=True)
    return chain.with_idle_inputs(efforts(chain, chain.at_efforts(force, p), chain.of_joints(q), p))
