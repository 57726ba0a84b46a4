"""Checks of numbers: the judge, and the back ends against each other."""

from __future__ import annotations

import casadi as ca
import jax
import numpy as np
from helpers import EPS32, model_of, quick_batch, relative
from oracle import LOCKED

from conformance.arms import PLACES, varied
from conformance.cases import STEP, Case
from screwgen import rollout
from screwgen.algorithms.functions import FORWARD
from screwgen.algorithms.robot_function import RobotFunction, is_matrix, shape
from screwgen.algorithms.robot_functions import offered
from screwgen.integrators import METHODS
from screwgen.runtime.compiled import Compiled
from screwgen.simulation.mobility import closing
from screwgen.simulation.simulate import stepper


def near(found, expected, tolerance: float, what: str = "", size: float = 0.0) -> None:
    """Fails where arrays differ by more than a share of the largest entry, or of a `size` that is larger."""
    found, expected = np.broadcast_arrays(np.asarray(found, float), np.asarray(expected, float))
    error = relative(np.append(found, size), np.append(expected, size))
    assert error <= tolerance, f"{what}: {error:.1e} of {tolerance:.1e}"


def arguments(case: Case) -> dict[str, np.ndarray]:
    """What functions take, by name; accelerations at random."""
    q, v, tau, w_ext = case.given
    return dict(q=q, v=v, tau=tau, w_ext=w_ext, vdot=np.random.default_rng(1).normal(size=len(v)))


def flat(found) -> np.ndarray:
    """All results of a function in one row, matrices by rows."""
    return np.concatenate([np.ravel(np.asarray(x, float)) for x in (found if isinstance(found, tuple) else (found,))])


def expected_results(case: Case) -> dict[str, np.ndarray]:
    """The results of every function of the robot, by NumPy."""
    given, numeric = arguments(case), case.model.numpy()
    return {f.name: flat(getattr(numeric, f.name)(*(given[x] for x in f.names))) for f in offered(case.model.chain)}


def alike(case: Case, function: RobotFunction, found, expected: np.ndarray) -> None:
    """A function of the robot gives what NumPy's does. Errors of accelerations that loops lock count over those that
    the loops take away."""
    taken, size = float(np.max(np.abs(case.judge.taken), initial=0.0)), 0.0
    if any(of.unit == "m/s^2" for of in function.results.values()) and np.max(np.abs(expected)) < LOCKED * taken:
        size = taken
    solved = FORWARD in function.algorithms or function.name == "inverse_dynamics_with_loops"
    tolerance = case.solved if solved else case.agreement
    near(found, expected, tolerance, function.name, size)


# ------------------------------------------------------------------------------------------------ the judge


def judge(case: Case) -> None:
    """Accelerations, joint wrenches, wrenches of loops, inverse dynamics, mass matrix and energy."""
    j, f = case.judge, case.model.numpy()
    vdot, wrench = f.forward_dynamics(*case.given)
    errors = j.errors(vdot, wrench)
    assert max(errors.values()) <= case.tolerance, errors
    if case.model.chain.closing.rows:
        near(f.loop_wrenches(*case.given), j.loop_wrenches, case.tolerance, "wrenches of loops")
        inverse_with_loops(case)
    if case.model.chain.has_reactions:
        near(f.drive_effort(*case.given), j.efforts, case.tolerance, "efforts", np.abs(j.forces).max())
    near(f.mass_matrix(case.given[0]), j.mass_matrix, case.tolerance, "mass matrix")
    q, v, tau, w_ext = case.given
    inertia = j.mass_matrix @ j.vdot[: case.model.nv]  # the size of forces that may balance
    found = np.append(f.inverse_dynamics(q, v, j.vdot, w_ext), inertia)
    near(found, np.append(j.forces, inertia), case.tolerance, "inverse dynamics")
    near(np.array(case.energy(f, q, v, tau)), np.array(j.energy), case.tolerance, "energy")
    poses, x = j.oracle.poses(j.state["q"]), j.state
    for found, (R, place) in ((f.link_pose(q), ("R", "origin")), (f.tip_poses(q), ("tip_R", "tip_point"))):
        near(found[0][j.outer.links], poses[R], case.tolerance, R)
        near(found[1][j.outer.links], poses[place], case.tolerance, place)
    twist = j.oracle.tip_twists(x["q"], x["v"])[-1].reshape(2, 3) @ poses["tip_R"][-1].T
    J, rates = tip_jacobian(case), v[: case.model.nv]  # a loop may hold the tip, whose parts then balance
    near(J @ rates, twist.ravel(), case.tolerance, "twist of the last tip", np.max(np.abs(J) @ np.abs(rates)))


def inverse_with_loops(case: Case) -> None:
    """A motion that driven axes make needs their efforts and no others, or smaller ones where several would do."""
    (q, v, tau, w_ext), f, chain = case.given, case.model.numpy(), case.model.chain
    kept = [*(k - chain.base_v for k in chain.driven_axes), *chain.added_joints]
    given = np.where(np.isin(np.arange(len(tau)), kept), tau, 0.0)
    vdot, loops = f.forward_dynamics(q, v, given, w_ext)[0], f.loop_wrenches(q, v, given, w_ext)
    wanted = f.inverse_dynamics(q, v, vdot, w_ext + loops)
    if chain.closing.couplings:
        wanted[chain.base_v : chain.base_v + chain.n_joints] -= f.coupling_torques(q, v, given, w_ext)
    force, wrenches = f.inverse_dynamics_with_loops(q, v, vdot, w_ext)
    inertia = f.mass_matrix(q) @ vdot[: chain.nv]  # the size of forces that may balance
    size, passive = np.abs(np.append(inertia, wanted)).max(), chain.passive_axes
    assert np.abs(force[passive]).max(initial=0.0) <= case.solved * size, "a passive axis would need a drive"
    driven, J = chain.driven_axes, f.gap_slopes(q)
    if not chain.closing.overconstrained and np.linalg.matrix_rank(np.delete(J, driven, 1), 1e-6) == len(J):
        near(np.append(force, size), np.append(wanted, size), 100 * case.solved, "efforts")
        near(np.append(wrenches, size), np.append(loops, size), 100 * case.solved, "wrenches of loops")
    else:
        assert np.linalg.norm(force[driven]) <= np.linalg.norm(wanted[driven]) + 1e-6 * size, "efforts are not least"


def tip_jacobian(case: Case) -> np.ndarray:
    """Of the last tip, by CasADi."""
    return case.model.casadi()["tip_jacobian"](case.given[0], case.model.parameter_values).full()


def in_float(case: Case) -> float:
    """The error that single precision allows in accelerations: 50 eps cond of the mass matrix, 1e-4 at least."""
    return max(1e-4, 50 * EPS32 * case.tolerance / (50 * np.finfo(float).eps))


# ------------------------------------------------------------------------------------------------ back ends


def numpy_dae(case: Case) -> None:
    """The DAE form by elimination, and its assembled rows by a dense solver."""
    f = case.model.numpy()
    vdot, wrench = f.dae_forward_dynamics(*case.given)
    errors = case.judge.errors(vdot, wrench)
    assert max(errors.values()) <= case.tolerance, errors
    q, v, tau, w_ext = case.given
    x = f.dae_state(q, v)
    near(f.project(x), x, case.tolerance, "projection of a closed state")
    M, H, W = f.assemble(x, tau, w_ext)
    z = np.linalg.solve(M, W - H)
    z += np.linalg.solve(M, W - H - M @ z)
    of_rows(case, z, 10)


def of_rows(case: Case, z: np.ndarray, factor: float) -> None:
    """The unknowns of the DAE form are the judge's wrenches, accelerations of links and of modes."""
    n, eta = case.model.n_links, case.model.chain.eta_v
    errors = case.judge.errors(
        np.concatenate([case.judge.vdot[:eta], z[12 * n :], case.judge.vdot[case.model.nv :]]),
        z[: 12 * n].reshape(n, 12)[:, :6],
    )
    assert max(errors.values()) <= case.tolerance * factor, f"of the assembled rows: {errors}"


def casadi(case: Case) -> None:
    """Every function, and the assembled rows."""
    functions, p, given = case.model.casadi(), case.model.parameter_values, arguments(case)
    expected = expected_results(case)
    for row in offered(case.model.chain):
        f = functions[row.name]
        values = [given[x].T if x == "w_ext" else given[x] for x in row.names]
        found = f.call([*values, p])
        parts = [by_columns(x, of, case.model.chain) for x, of in zip(found, row.results.values(), strict=True)]
        alike(case, row, np.concatenate(parts), expected[row.name])
    q, v, tau, w_ext = case.given
    if case.model.chain.holds:
        near(expected["held_inputs"], case.acting, 0.0, "inputs within limits")
        found = np.concatenate([flat(x) for x in functions["step_euler"](q, v, tau, w_ext.T, p, STEP)])
        vdot = case.model.numpy().forward_dynamics(q, v, case.acting, w_ext)[0]
        near(found[-len(v) :], v + STEP * vdot, case.agreement, "a step beyond the limits")
    x = case.model.numpy().dae_state(q, v)
    near(flat(functions["dae_state"](q, v, p)), x, case.agreement, "state of the DAE form")
    rows = [np.asarray(y.full()) for y in functions["assemble"](x, tau, w_ext.T, p)]
    sizes = [x.full().ravel() for x in functions["scaling"](p)]
    assert [len(x) for x in sizes] == [len(q), len(v), len(tau)] and np.all(np.concatenate(sizes) > 0)
    for found, wanted, what in zip(rows, case.model.numpy().assemble(x, tau, w_ext), "MHW", strict=True):
        near(found.ravel(), np.ravel(wanted), case.solved, f"{what} of the assembled rows")


def acados(case: Case) -> None:
    """The implicit rows vanish at the accelerations of the explicit ones, in a state whose loops are slightly open.

    Forces of loops are unknowns of the rows, which are written apart from those of the dynamics.
    """
    (q, v, tau, w_ext), export, numeric = case.given, case.model.acados(w_ext=True), case.model.numpy()
    q = case.moved(q, 1e-3 * np.random.default_rng(2).normal(size=case.model.nv))
    p = np.concatenate([case.model.parameter_values, np.ravel(w_ext)])
    explicit = ca.Function("rates", [export.x, export.u, export.p], [export.f_expl_expr])(np.append(q, v), tau, p)
    expected = numeric.forward_dynamics(q, v, tau, w_ext)[0]
    near(explicit.full()[case.model.nq :, 0], expected, case.tolerance, "accelerations")
    forces = unknowns(case, export, np.append(q, v), explicit, p)
    rows = case.model.chain.closing.rows
    assert len(forces) == len(export.z_labels) == len(rows) and list(export.u_labels) == case.model.tau_names
    if rows:
        on_tips = closing(case.model)(q, v * 0, forces, case.model.parameter_values)[4].full().T
        near(on_tips, numeric.loop_wrenches(q, v, tau, w_ext), 100 * case.tolerance, "wrenches of loops")


def acados_dae(case: Case) -> None:
    """The implicit rows of the DAE form, whose unknowns are joint wrenches and accelerations, vanish at its rates."""
    (q, v, tau, w_ext), export, numeric = case.given, case.model.acados("dae", w_ext=True), case.model.numpy()
    x, p = numeric.dae_state(q, v), np.concatenate([case.model.parameter_values, np.ravel(w_ext)])
    of_rows(case, unknowns(case, export, x, numeric.dae_rates(x, tau, w_ext)[0], p), 100)


def unknowns(case: Case, export, x, rates, p) -> np.ndarray:
    """The algebraic unknowns with which the implicit rows of an export vanish at these rates, as they must."""
    rows = ca.Function("rows", [export.xdot, export.z, export.x, export.u, export.p], [export.f_impl_expr])
    at = lambda z: rows(rates, z, x, case.given[2], p).full()[:, 0]  # noqa: E731
    count = export.z.numel()
    start = at(np.zeros(count))
    slopes = np.array([at(e) - start for e in np.eye(count)]).reshape(count, len(start)).T
    z = np.linalg.lstsq(slopes, -start, rcond=None)[0]
    left, size = start + slopes @ z, max(np.abs(start).max(), np.abs(case.judge.forces).max(), 1.0)
    assert np.abs(left).max() <= 100 * case.tolerance * size, f"{left} of {size:.1e}"
    return z


def by_columns(found: ca.DM, signal, chain) -> np.ndarray:
    """A result of CasADi as an array of the shape that it has elsewhere: links and markers stand side by side there."""
    size = shape(signal, chain)
    if len(size) < 2 or is_matrix(signal):
        return found.full().ravel()
    parts = np.stack(np.hsplit(found.full(), size[0]))
    return parts.ravel() if len(size) == 3 else parts[:, :, 0].ravel()


STATED = ("q", "v", "tau", "w_ext", "p")


def jax_functions(case: Case) -> None:
    """Dynamics both ways, energy, mass matrix, Jacobian of the tip and a step."""
    with jax.enable_x64(True):
        given = jax_results(case, ("forward_dynamics", "inverse_dynamics", "energy"))
        functions, at = case.model.jax(), (given["q"], given["p"])
        near(np.asarray(functions["tip_jacobian"](*at)), tip_jacobian(case), case.agreement, "Jacobian of the tip")
        near(np.asarray(functions["mass_matrix"](*at)), case.judge.mass_matrix, case.tolerance, "mass matrix")
        q, v = case.model.jax()["step"](*(given[x] for x in STATED), STEP)
    near(np.concatenate([q, v]), np.concatenate(stepped(case, "modal_midpoint")), case.agreement, "step")


def jax_gradients(case: Case) -> None:
    """All other functions, and the gradients of a weighted sum of the accelerations, which CasADi has too."""
    weights, of = np.random.default_rng(3).normal(size=case.model.chain.nvz), "forward_dynamics"
    with jax.enable_x64(True):
        given = jax_results(case, [x.name for x in offered(case.model.chain)])
        (_, wrench), backwards = jax.vjp(case.model.jax()[of], *(given[x] for x in STATED))
        slopes = backwards((weights, np.zeros_like(wrench)))
    function = case.model.casadi()[of]
    at = [given[x].T if x == "w_ext" else given[x] for x in STATED]
    wanted = function.reverse(1)(*at, *function(*at), weights, np.zeros(wrench.T.shape))
    for name, ours, theirs in zip(STATED, slopes, wanted, strict=True):
        near(np.ravel(ours), theirs.full().ravel(order="F"), 10 * case.tolerance, f"gradient with {name}")


def jax_results(case: Case, names) -> dict[str, np.ndarray]:
    """What these functions are given, where they give what NumPy's do."""
    given, expected = arguments(case) | {"p": np.array(case.model.parameter_values)}, expected_results(case)
    for row in offered(case.model.chain):
        if row.name in names:
            found = case.model.jax()[row.name](*(given[x] for x in (*row.names, "p")))
            found = flat(tuple(found) if isinstance(found, list | tuple) else found)
            alike(case, row, found, expected[row.name])
    return given


def stepped(case: Case, method: str, steps: int = 1) -> tuple[np.ndarray, np.ndarray]:
    """The state after steps by CasADi, which are given what the limits of efforts leave."""
    q, v, _, w_ext = case.given
    tau = case.acting
    step = case.model.casadi()[f"step_{method}"]
    for _ in range(steps):
        q, v = (flat(x) for x in step(q, v, tau, w_ext.T, case.model.parameter_values, case.step))
    return q, v


def c_functions(case: Case, layout: str, parameters: str = "runtime") -> None:
    """Every function of the C in both forms, and every step."""
    c, expected, given = case.c(layout, parameters=parameters), expected_results(case), arguments(case)
    q, v, tau, w_ext = case.given
    for form in ("joint", "dae"):
        errors = case.judge.errors(*c.forward_dynamics(q, v, tau, w_ext, form=form))
        assert max(errors.values()) <= case.tolerance, (form, errors)
    near(c.inverse_dynamics(q, v, given["vdot"], w_ext)[0], expected["inverse_dynamics"], case.agreement, "inverse")
    by_elimination(case, c)
    postures(case, c)
    near(np.ravel(c.validity(q, v, tau, w_ext)), expected["validity"], case.solved, "validity")
    if "coupling_torques" in expected:
        near(c.coupling_torques(q, v, tau, w_ext), expected["coupling_torques"], case.solved, "coupling torques")
    for row in offered(case.model.chain):
        if row.c_file:
            alike(case, row, flat(getattr(c, row.name)(q, v, tau, w_ext)), expected[row.name])
    near(x := c.dae_state(q, v), case.model.numpy().dae_state(q, v), case.agreement, "state of the DAE form")
    for method in METHODS:
        near(np.concatenate(c.step(q, v, tau, w_ext, case.step, method)), np.concatenate(stepped(case, method)),
             case.solved, method)  # fmt: skip
        there = stepper(case.model, method, "dae").step(x, case.acting, w_ext, case.step)
        if np.abs(there - x).max() < 1e4:  # of one far beyond the stability of rk4 rounding is all that is left
            near(c.dae_step(x, tau, w_ext, case.step, method), there, 10 * case.solved, f"{method} of the DAE form")


def by_elimination(case: Case, c: Compiled) -> None:
    """What the C has of the dynamics besides: accelerations alone, wrenches of inverse dynamics, M, assembled rows."""
    (q, v, tau, w_ext), f = case.given, case.model.numpy()
    vdot, wrench = f.forward_dynamics(q, v, tau, w_ext)
    near(c.accelerations(q, v, tau, w_ext), vdot, case.solved, "accelerations alone")
    loads = w_ext + f.loop_wrenches(q, v, tau, w_ext) if case.model.chain.closing.rows else w_ext
    if not case.model.chain.inputs_load_links:  # inverse dynamics is that without inputs
        near(c.inverse_dynamics(q, v, vdot, loads)[1], wrench, case.tolerance, "wrenches of inverse dynamics")
    near(c.mass_matrix(q), f.mass_matrix(q), case.agreement, "mass matrix")
    x = f.dae_state(q, v)
    for found, wanted, what in zip(c.assemble(x, tau, w_ext), f.assemble(x, tau, w_ext), "MHW", strict=True):
        near(found, wanted, case.agreement, f"{what} of the assembled rows")


def postures(case: Case, c: Compiled) -> None:
    """Poses of links and tips, the Jacobian of the last tip and its twist."""
    (q, v, *_), f = case.given, case.model.numpy()
    found = c.kinematics(q, v)
    for given, wanted in zip(found[:4], (*f.link_pose(q), *f.tip_poses(q)), strict=True):
        near(given, wanted, case.agreement, "poses")
    J = tip_jacobian(case)
    near(c.tip_jacobian(q), J, case.agreement, "Jacobian of the tip")
    near(found.tip_twist[case.model.chain.last], J @ v[: case.model.nv], case.agreement, "twist of the tip")


def parameters(case: Case) -> None:
    """Numbers that are given at run time make the robot whose file has them, in every back end."""
    kept = PLACES if case.model.chain.closing.rows else ("at", "from", "to", "axes", "transmission")
    other = model_of(varied(case.robot, np.random.default_rng(case.seed), kept))
    (q, v, tau, w_ext), p, model = case.given, np.array(other.parameter_values), case.model
    assert other.parameter_names == model.parameter_names
    vdot, energy = other.numpy().forward_dynamics(q, v, tau, w_ext)[0], case.energy(other.numpy(), q, v, tau)
    found = {x: (f.forward_dynamics(q, v, tau, w_ext)[0], case.energy(f, q, v, tau))
             for x, f in (("NumPy", model.numpy(p)), ("C", case.c().fresh(p)))}  # fmt: skip
    f = model.casadi()
    found["CasADi"] = flat(f["forward_dynamics"](q, v, tau, w_ext.T, p)[0]), flat(case.energy(f, q, v, tau, p))
    for name, (rates, energies) in found.items():
        near(rates, vdot, case.tolerance, f"accelerations by {name}")
        near(energies, energy, case.tolerance, f"energies by {name}")


def c_float(case: Case) -> None:
    """Accelerations in single precision, as far as their condition allows."""
    c = case.c(single=True)
    errors = case.judge.errors(*c.forward_dynamics(*case.given))
    assert max(errors.values()) <= in_float(case), errors


def lanes(case: Case, single: bool = False) -> None:
    """Lanes step as the scalar C does."""
    q, v, tau, w_ext = case.given
    quick_batch(case.model, single)
    x0 = np.tile(np.concatenate([q, v]), (3, 1))
    run = rollout(case.model, x0, tau, w_ext=w_ext, step=STEP, steps=1, single=single)
    assert run.ok.all(), run.report()
    expected = np.concatenate(stepped(case, "modal_midpoint"))
    for lane in run.x:
        near(lane[-1], expected, in_float(case) if single else case.agreement, "a lane")
