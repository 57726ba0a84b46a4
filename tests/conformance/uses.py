"""Checks of what users do with a model: runs, rollouts, rest, mock-up units, files, documents."""

from __future__ import annotations

import numpy as np
from helpers import quick_batch, relative
from scipy.linalg import eigvalsh, null_space
from scipy.optimize import root

import screwgen
from conformance.cases import STEP, Case
from conformance.numbers import flat, near
from screwgen.algorithms.robot_functions import reported
from screwgen.backends.numpy.closing import moving
from screwgen.backends.numpy.compliant import settled
from screwgen.plotting.run_panels import panels
from screwgen.robot_model import RobotModel
from screwgen.spec.parameters import parameters
from screwgen.studies.held_joints import joint_names
from screwgen.studies.modes import loaded_motion, movable
from screwgen.studies.standing import StandingBase

COUNT = 6


def held(case: Case) -> dict:
    """Inputs of a run that are held, from the state of the case."""
    q, v, tau, w_ext = case.given
    return dict(q0=q, v0=v, controller=tau, w_ext=w_ext)


def runs(case: Case) -> None:
    """A run by C is one by CasADi in both forms, a rollout, and what both report is the same."""
    model, duration = case.model, COUNT * STEP
    q, v, tau, w_ext = case.given
    run = screwgen.simulate(model, duration, STEP, **held(case))
    other = screwgen.simulate(model, duration, STEP, backend="casadi", **held(case))
    near(other.q, run.q, 100 * case.agreement, "coordinates by CasADi")
    near(other.v, run.v, 100 * case.agreement, "rates by CasADi")
    quick_batch(model)
    rolled = screwgen.rollout(model, np.concatenate([q, v])[None], tau, w_ext=w_ext, step=STEP, steps=COUNT)
    assert rolled.ok.all(), rolled.report()
    near(rolled.q[0], run.q, 100 * case.agreement, "coordinates of a rollout")
    rows = {row.name: row for row in reported(model.chain)}
    for name in ("wrench", "tip_position", *rows):
        near(getattr(rolled, name)[0], getattr(run, name), 1e3 * case.agreement, name)
        near(getattr(other, name), getattr(run, name), 1e3 * case.agreement, name)
    near(run.tau, np.array([case.acting_at(v) for v in run.v]), case.agreement, "inputs that acted")
    near(other.tau, run.tau, case.agreement, "inputs that acted, by CasADi")
    last = {name: x[-1] for name, x in run.arrays.items()} | {"w_ext": w_ext}
    if model.chain.compliant:
        last["w_ext"] = settled(model.numpy(), *(last[x] for x in ("q", "v", "tau", "w_ext")), STEP)
    for name, row in rows.items():
        expected = flat(getattr(model.numpy(), name)(*(last[x] for x in row.names)))
        near(np.ravel(getattr(run, name)[-1]), expected, case.agreement, f"{name} of the last sample")
    drawn(case, run)


def drawn(case: Case, run: screwgen.Run) -> None:
    """Figures have a curve of every input, and of every coordinate of a joint that has axes."""
    curves = {line.values.tobytes() for panel in panels(run, model=case.model) for line in panel.lines}
    moved = {name: x for name, x in zip(run.q_names, run.q.T, strict=True) if ".joint[" in name or ".slide[" in name}
    for name, values in {**dict(zip(run.tau_names, run.tau.T, strict=True)), **moved}.items():
        assert values.tobytes() in curves, f"no figure has {name}"


def dae_runs(case: Case) -> None:
    """A run of the DAE form, which CasADi steps, beside the joint form by the same method."""
    model, duration = case.model, COUNT * STEP
    how = dict(every=4, **held(case))
    run = screwgen.simulate(model, duration, STEP / 4, form="dae", **how)
    other = screwgen.simulate(model, duration, STEP / 4, form="dae", backend="casadi", **how)
    near(other.q, run.q, 100 * case.agreement, "coordinates by CasADi")
    joint = screwgen.simulate(model, duration, STEP / 4, **how)
    how["every"] = 8
    finer = [screwgen.simulate(model, duration, STEP / 8, form=form, **how) for form in ("dae", "joint")]
    for name in ("q", "v", "energy"):  # the forms differ by what a step of either does, and drift or are projected
        found = [getattr(x, name) for x in (run, joint)]
        error = sum(relative(x, getattr(fine, name)) for x, fine in zip(found, finer, strict=True))
        near(*found, 1e-8 + 5 * error, f"{name} beside the joint form")


def energy(case: Case) -> None:
    """What the energy gains in a run is what inputs and loads do and dampers take: its rate by the dynamics."""
    q, v, tau, w_ext = case.given
    c, f, h = case.c(), case.model.numpy(), 1e-5
    loads = 0 * w_ext
    nv = case.model.nv
    wound = case.judge.outer.winches.size  # what winches do is judged by the energy of their lines below
    idle = np.where(np.arange(len(tau)) < len(tau) - wound, 0.0, tau)
    moved = (f.forward_dynamics(q, v, tau, loads)[0] - f.forward_dynamics(q, v, idle, loads)[0])[:nv]
    given = (drive_power(f, q, v, tau, loads) - drive_power(f, q, v, idle, loads))[: len(tau) - wound]
    M = case.judge.mass_matrix
    most = np.abs(v[:nv]) @ np.abs(M) @ np.abs(moved) + np.abs(given).sum()
    assert abs(v[:nv] @ M @ moved - given.sum()) <= case.tolerance * most, (
        "drives do not give the power that moves the arm"
    )
    ends = []
    for sign in (-1, 1):
        there, rates = c.step(q, v, tau, loads, h, "rk4") if sign > 0 else (q, v)
        ends.append(sum(case.energy(f, there, rates, paid_out(case, sign * h / 2))))
    middle, rates = c.step(q, v, tau, loads, h / 2, "rk4")
    power = float(np.sum(drive_power(f, middle, rates, case.acting, loads)))
    lost = power - (ends[1] - ends[0]) / h
    scale = abs(power) + sum(map(abs, case.energy(f, q, v, tau))) + 1.0
    assert lost >= -1e-5 * scale, f"gains {-lost:.3g} W from nothing"
    lossy = {
        "passive",
        "friction",
        "loaded friction",
        "bristles",
        "Dahl",
        "ratio",
        "time",
        "stops",
        "line spring",
        "winch",
        "contact",
    }
    if not (lossy | {"rope", "bushing", "compliant loop"}) & set(case.features) and not any(
        "damping" in d for link in case.robot["links"] for d in link["joint"].get("drives", [])
    ):
        assert abs(lost) <= 1e-5 * scale, f"{lost:.3g} W vanish"


def drive_power(f, q, v, tau, w_ext) -> np.ndarray:
    """Of each input, also where it is an acceleration."""
    return f.effort_power(q, v, tau, w_ext) if f.chain.has_reactions else f.drive_power(q, v, tau)


def paid_out(case: Case, dt: float) -> np.ndarray:
    """The inputs as a step holds them, with what winches have paid out dt later at their rates."""
    tau, winches = case.acting.copy(), case.judge.outer.winches
    tau[len(tau) - winches.size :] += dt * (winches[:, [1]] * [1.0, 0.0]).ravel()
    return tau


def identification(case: Case) -> None:
    """A mass that is a tenth larger than in the file is found again from what a run records."""
    model, chain = case.model, case.model.chain
    quick = chain.closing.rows or chain.curved  # loops open over long runs, light parts of what floats turn fast
    step = STEP / 10 if quick else STEP
    duration = 24 * step
    q, v, tau, _ = case.given
    masses = [x for x in parameters(model.robot) if x.field == "bodies.mass" and x.value]
    known = next(x for x in masses if not chain.moving or x.link)  # what moves as is given tells no mass
    quick_batch(model)
    more = {"integrator": "modal_midpoint", "parameters": {known.name: 1.1 * known.value}}
    run = screwgen.simulate(model, duration, step, q0=q, v0=v, controller=tau, **more)
    found = screwgen.identify(model, run, free=[known.name], window=duration, iterations=6)
    near(found[known.name].value, 1.1 * known.value, 1e-3, known.name)


def equilibrium(case: Case) -> None:
    """Where it is found nothing accelerates: joints held, torques follow; then the last let go under the torque that
    holds, with all between drive and joint. With little weight or none.
    """
    model, chain = case.model, case.model.chain
    weight = 0.0 if chain.floating and not chain.moving else 0.1  # of the robot's: a link of order 2 bends little
    light = {f"gravity[{k}]": weight * g for k, g in enumerate(case.robot["gravity"])}
    q = closed(case)[0]
    start, pulled = q if chain.floating else q[: chain.n_redundant], 0.1 * case.given[2][model.n_joints :]
    moved = (".speed", ".twist_rate[")  # nothing moves
    pulled[[any(x in name for x in moved) for name in model.tau_names[model.n_joints :]]] = 0.0
    rest = screwgen.equilibrium(model, start, pulled if len(pulled) else None, hold=True, parameters=light)
    rests(model, rest, light)
    names = joint_names(model)
    torques = [rest.tau[j] * (name in rest.held_joints) for j, name in enumerate(names)]
    if any(torques):
        last = int(np.flatnonzero(torques)[-1])
        alone = np.append(np.where(np.arange(model.n_joints) == last, torques, 0.0), pulled)
        rests(model, screwgen.equilibrium(model, rest.q, alone, parameters=light, free=[names[last]]), light)


def rests(model: RobotModel, rest: screwgen.Equilibrium, parameters: dict[str, float]) -> None:
    """Nothing accelerates by more than a millionth of a torque of 1 gives; wrenches and efforts are the dynamics'."""
    f = model.numpy(model.chain.parameters.vector(parameters))
    zero, torques = np.zeros(model.nv), [".brake[" not in name for name in model.tau_names]
    vdot, wrench = f.forward_dynamics(rest.q, zero, rest.tau, None)
    pushed = np.abs(f.forward_dynamics(rest.q, zero, rest.tau + torques, None)[0] - vdot).max()
    vdot = vdot[: model.chain.held_states.start]  # of what remembers an input there is another rest
    assert np.abs(vdot).max() < 1e-6 * max(pushed, 1.0), f"{np.abs(vdot).max():.1e} beside {pushed:.1e}"
    effort = f.drive_effort(rest.q, zero, rest.tau, None) if model.chain.has_reactions else rest.tau
    pairs = {"wrenches": (rest.wrench, wrench[model.chain.firsts]), "efforts": (rest.effort[torques], effort[torques])}
    for what, (found, wanted) in pairs.items():
        size = max(np.abs(wrench).max(), 1.0)
        assert np.abs(found - wanted).max(initial=0.0) < 1e-6 * size, f"{what}: {found} are {wanted}"


def closed(case: Case) -> tuple[np.ndarray, np.ndarray]:
    """The state with its loops closed to rounding, and rates that keep them so."""
    q, v, *_ = case.given
    if not case.model.chain.closing.rows:
        return q, v
    q = screwgen.assemble(case.model, q)
    return q, moving(case.model.numpy(), q, v)


def modes(case: Case) -> None:
    """Vibrations are those of mass matrix and springs in the motions that loops leave, joints locked and free."""
    if case.model.chain.forces:
        return modes_beside_forces(case)
    model, q = case.model, closed(case)[0]
    chain, f = model.chain, model.numpy(np.append(np.zeros(3), model.parameter_values[3:]))
    T, M = np.eye(model.nv), f.mass_matrix(q)
    for joint, place in chain.elastic_travels.items():
        T[place, chain.base_v + joint] = -f.levers(q)[joint]
    rest, h = np.zeros(model.nv), 1e-6
    at = lambda x: np.asarray(f.inverse_dynamics(case.moved(q, x), rest, rest, None))  # noqa: E731
    K = np.array([(at(h * x) - at(-h * x)) / (2 * h) for x in T.T]).T
    K, M = (x + x.T for x in (T.T @ K / 2, T.T @ M @ T / 2))
    for joints in ("locked", "free"):
        if joints == "free" and chain.elastic_travels:
            return  # whose gears are under load in this posture
        found, moving = screwgen.mode_shapes(model, q, joints), movable(model, joints, q, model.parameter_values)
        N = np.eye(model.nv)[:, moving]
        N = N @ null_space(f.gap_slopes(q) @ T @ N) if chain.closing.rows else N
        squares = eigvalsh(N.T @ K @ N, N.T @ M @ N)
        expected = np.sqrt(np.maximum(squares[found.rigid :], 0.0)) / (2 * np.pi)
        near(found.frequencies, expected, 1e-6, f"frequencies, {joints}")
        near(squares[: found.rigid], 0.0, 1e-7 * np.max(squares, initial=1.0), "of rigid motions")
        S = np.linalg.solve(T, found.shapes)
        near(S.T @ M @ S, np.eye(len(expected)), 1e-8, "modal masses")
        near(S.T @ K @ S, np.diag((2 * np.pi * expected) ** 2), 1e-6, "modal stiffness")


def modes_beside_forces(case: Case) -> None:
    """The same about the deflection under forces between frames: where the potential is least as loops let it be.

    Its second derivatives there are those of the potential less the loops' gaps times their forces. Of robots with
    transmissions, or with gears in loops, that frequencies are found.
    """
    model, chain = case.model, case.model.chain
    f, rest, h = model.numpy(np.append(np.zeros(3), model.parameter_values[3:])), np.zeros(model.nv), 1e-6
    at, looped = closed(case)[0], bool(chain.closing.rows)
    found = {joints: screwgen.mode_shapes(model, at, joints) for joints in ("locked", "free")}
    if chain.travels or (looped and chain.n_added):
        assert all(np.isfinite(x.frequencies).all() for x in found.values())
        return
    gears = [chain.base_v + k for k in chain.added_joints]
    joints = at[chain.base_q : chain.base_q + chain.n_redundant]
    joints = chain.with_added(joints, model.parameter_values) if chain.n_added else joints
    start = np.concatenate([at[: chain.base_q], joints, at[chain.eta_q :]])
    moving = {joints: movable(model, joints, start, model.parameter_values) for joints in found}
    if model.robot.loops:  # which may find rest in several postures
        start = _hanging(model, at, moving["locked"])
    bent = moving["locked"] if looped else np.r_[chain.eta_v - len(gears) : model.nv]
    balanced = bent if looped else [*gears, *range(chain.eta_v, model.nv)]
    place = lambda x: case.moved(start, np.bincount(bent, x, model.nv))  # noqa: E731
    force = lambda q: np.asarray(f.inverse_dynamics(q, rest, rest, None))  # noqa: E731
    slopes = lambda q: f.gap_slopes(q) if looped else np.zeros((0, model.nv))  # noqa: E731
    along = lambda q: null_space(slopes(q)[:, balanced]) if looped else np.eye(len(balanced))  # noqa: E731

    def unbalanced(x: np.ndarray) -> np.ndarray:
        q = place(x)
        N = along(q)
        return np.append(N @ (N.T @ force(q)[balanced]), f.gaps(q, None)[0] if looped else ())

    precise, most = {"xtol": 1e-15, "ftol": 1e-15}, 1e-8 * max(1.0, np.abs(force(start)).max())
    solved = root(unbalanced, np.zeros(len(bent)), method="lm", options=precise)
    if np.abs(solved.fun).max() >= most:  # far off it is sought from where the product says that it is
        start = _hanging(model, at, moving["locked"])
        solved = root(unbalanced, np.zeros(len(bent)), method="lm", options=precise)
    assert np.abs(solved.fun).max() < most, "no rest was found"
    q = place(solved.x)
    loops = np.linalg.lstsq(slopes(q)[:, balanced].T, force(q)[balanced], rcond=None)[0]
    free = lambda q: force(q) - slopes(q).T @ loops  # noqa: E731
    K = np.array([(free(case.moved(q, h * x)) - free(case.moved(q, -h * x))) / (2 * h) for x in np.eye(model.nv)]).T
    M = f.mass_matrix(q)
    for joints, shapes in found.items():
        N = np.eye(model.nv)[:, moving[joints]]
        N = N @ null_space(slopes(q) @ N) if looped else N
        squares = eigvalsh(*(N.T @ ((x + x.T) / 2) @ N for x in (K, M)))
        expected = np.sqrt(np.maximum(squares, 0.0))[shapes.rigid :] / (2 * np.pi)
        near(np.sort(shapes.frequencies), expected, 1e-5, f"frequencies, {joints}")


def _hanging(model: screwgen.Model, at: np.ndarray, moving: np.ndarray) -> np.ndarray:
    """Where a robot rests, the joints locked."""
    if not model.chain.moving:
        return loaded_motion(model, at, None, False, model.parameter_values, moving).q
    there = StandingBase(model, at, model.parameter_values)
    p = there.fixed.chain.parameters.vector(there.values)
    found = loaded_motion(there.fixed, there.q, None, False, p, moving - model.chain.base_v)
    return np.append(there.pose, found.q)


def toml(case: Case) -> None:
    """Written and read again it is the same robot."""
    path = case.folder / "again.toml"
    path.write_text(screwgen.dump(case.model.robot), encoding="utf-8")
    assert screwgen.load(path) == case.model.robot


def document(case: Case) -> None:
    """Who reads the steps of the document alone computes the same accelerations and wrenches."""
    from document_mass import mass_matrix_from_document
    from document_reader import accelerations_from_document

    vdot, wrench = accelerations_from_document(case.model, *case.given)
    errors = case.judge.errors(vdot, wrench)
    assert max(errors.values()) <= case.tolerance, errors
    q = case.given[0]
    own, read = case.model.numpy().mass_matrix(q), mass_matrix_from_document(case.model, q)
    scale = np.sqrt(np.outer(np.diag(own), np.diag(own)))
    assert np.max(np.abs(own - read) / scale) < 1e-10
    balances = [right for left, _, right in derived(case) if r"\boldsymbol{\mathcal{W}}^*_i" in left]
    assert [r"T_c\," in loads for loads in balances] == [bool(case.model.chain.n_tensions)], "loads of the derivation"


def derived(case: Case) -> list[tuple[str, str, str]]:
    """The equations of the section that says how those of the algorithm come about."""
    from document_reader import content_of
    from document_symbols import parts

    from screwgen.backends.latex import document

    (section,) = [x for x in content_of(case.model).sections if x.title == document.DERIVATION]
    return [equation for part in parts(section) for equation in part.equations]
