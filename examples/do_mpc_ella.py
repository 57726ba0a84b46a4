"""Model predictive control of ELLA with do-mpc: its Model, MPC and Simulator in a closed loop, point to point.

    python examples/do_mpc_ella.py            # 1.5 s of motion, with a plot in build/do_mpc_ella.png
    python examples/do_mpc_ella.py --short    # the same, 1 s of motion, without the plot

do-mpc takes the model as two expressions, dq/dt = v and dv/dt = forward_dynamics(q, v, tau). The arm is ELLA with
geared motors and one bending mode per link and direction; do-mpc collocates it and IPOPT solves. At the end the same
torques run through the generated C, which has to end where do-mpc's simulator did.
"""

import argparse
import time
import tomllib
import warnings
from pathlib import Path

import casadi as ca
import numpy as np

import screwgen
from screwgen.plotting import look

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # do-mpc says which of its optional packages are missing
    import do_mpc
warnings.filterwarnings("ignore", "(?s).*a numpy function was called on a casadi value", FutureWarning)  # by do-mpc

ROOT = Path(__file__).resolve().parents[1]
PLOT = ROOT / "build" / "do_mpc_ella.png"
SAMPLE, HORIZON = 0.03, 15
LIMITS = np.array([150.0, 60.0, 60.0])  # N·m
START, GOAL = np.array([0.0, 0.3, -0.4]), np.array([0.6, -0.3, 0.4])  # joint coordinates, rad
BAND = 5e-3  # m: the tip has settled when it stays that near


def arm() -> screwgen.Model:
    """ELLA for control: no axial modes; rotors of geared motors (0.5 kg·m² at the joint), 1 % modal damping."""
    table = tomllib.loads((ROOT / "examples" / "ella_paper.toml").read_text(encoding="utf-8"))
    for link in table["links"]:
        link["modes"]["axial"] = 0
        link["damping"] = {"ratio": 0.01}
        link["joint"]["armature"] = [0.5] * len(link["joint"]["axes"])
    return screwgen.derive(screwgen.Robot.model_validate(table))


def predictor(arm: screwgen.Model) -> do_mpc.model.Model:
    """The model as do-mpc takes it, with the tip's position as an expression."""
    functions, p = arm.casadi(), ca.DM(arm.parameter_values)
    model = do_mpc.model.Model("continuous", "SX")
    q = model.set_variable("_x", "q", (arm.nq, 1))
    v = model.set_variable("_x", "v", (arm.nq, 1))
    tau = model.set_variable("_u", "tau", (arm.n_joints, 1))
    model.set_rhs("q", v)
    model.set_rhs("v", functions["forward_dynamics"](q, v, tau, 0, p)[0])
    model.set_expression("tip", functions["tip_pose"](q, p)[1])
    model.setup()
    return model


def controller(model: do_mpc.model.Model, goal: np.ndarray) -> do_mpc.controller.MPC:
    """Tip to `goal` (3,) in m, at rest, under the torque limits."""
    mpc = do_mpc.controller.MPC(model)
    mpc.settings.n_horizon, mpc.settings.t_step = HORIZON, SAMPLE
    mpc.settings.collocation_deg, mpc.settings.collocation_ni = 3, 1
    mpc.settings.store_full_solution = False
    mpc.settings.supress_ipopt_output()
    mpc.settings.nlpsol_opts |= {"ipopt.tol": 1e-5, "ipopt.honor_original_bounds": "yes"}
    cost = 100 * ca.sumsqr(model.aux["tip"] - goal) + 0.1 * ca.sumsqr(model.x["v"])
    mpc.set_objective(lterm=cost, mterm=10 * cost)
    mpc.set_rterm(tau=1e-4)
    mpc.bounds["lower", "_u", "tau"], mpc.bounds["upper", "_u", "tau"] = -LIMITS, LIMITS
    mpc.setup()
    return mpc


def plant(model: do_mpc.model.Model) -> do_mpc.simulator.Simulator:
    simulator = do_mpc.simulator.Simulator(model)
    simulator.settings.t_step, simulator.settings.integration_tool = SAMPLE, "cvodes"
    simulator.settings.abstol = simulator.settings.reltol = 1e-9
    simulator.setup()
    return simulator


def at_rest(arm: screwgen.Model, joints: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The coordinates q (nq,) of the arm bent by gravity at these joint coordinates, and the torques that hold it."""
    m, rest = arm.n_joints, np.zeros(arm.nq - arm.n_joints)
    tau, eta = ca.SX.sym("tau", m), ca.SX.sym("eta", rest.size)
    h = arm.casadi()["bias"](ca.vertcat(joints, eta), 0, 0, arm.parameter_values)
    balance = ca.rootfinder("balance", "newton", {"x": ca.vertcat(tau, eta), "g": h - ca.vertcat(tau, rest)})
    solution = balance(x0=0)["x"].full().ravel()
    return np.r_[joints, solution[m:]], solution[:m]


def closed_loop(arm: screwgen.Model, goal: np.ndarray, samples: int) -> dict[str, np.ndarray]:
    """States x (samples + 1, 2 nq), torques (samples, 3), seconds of every solve, and whether each one converged."""
    q0, tau0 = at_rest(arm, START)
    model, x = predictor(arm), np.r_[q0, np.zeros(arm.nq)]
    mpc, simulator = controller(model, goal), plant(model)
    mpc.x0 = simulator.x0 = x
    mpc.u0 = tau0
    mpc.set_initial_guess()
    run = {"x": [x], "tau": [], "seconds": [], "solved": []}
    for _ in range(samples):
        clock = time.perf_counter()
        u = mpc.make_step(run["x"][-1][:, None])
        run["seconds"].append(time.perf_counter() - clock)
        run["solved"].append(mpc.solver_stats["success"])
        run["tau"].append(u.ravel())
        run["x"].append(simulator.make_step(u).ravel())
    return {name: np.array(values) for name, values in run.items()}


def replayed(arm: screwgen.Model, run: dict[str, np.ndarray]) -> np.ndarray:
    """The states (samples + 1, 2 nq) that the generated C reaches under the run's torques, by steps of 0.1 ms."""
    compiled, q_v, substeps = arm.compile(), np.split(run["x"][0], 2), round(SAMPLE / 1e-4)
    states = [np.concatenate(q_v)]
    for tau in run["tau"]:
        q_v = compiled.step(*q_v, tau, np.zeros((2, 6)), SAMPLE / substeps, "modal_midpoint", substeps)
        states.append(np.concatenate(q_v))
    return np.array(states)


def tips(arm: screwgen.Model, x: np.ndarray) -> np.ndarray:
    """Tip positions (samples, 3) in m."""
    pose = arm.casadi()["tip_pose"]
    return np.array([pose(row[: arm.nq], arm.parameter_values)[1].full().ravel() for row in x])


def settled(error: np.ndarray) -> float:
    """The time in s from which the tip stays within BAND; infinite if it does not."""
    outside = np.flatnonzero(error > BAND)
    first = outside[-1] + 1 if len(outside) else 0
    return first * SAMPLE if first < len(error) else np.inf


@look.styled
def save_plot(run: dict[str, np.ndarray], error: np.ndarray) -> None:
    t, figure = SAMPLE * np.arange(len(error)), look.canvas(7, 5, "Model-predictive control of ELLA with do-mpc")
    top, bottom = figure.subplots(2, sharex=True)
    top.semilogy(t, 1e3 * error)
    top.axhline(1e3 * BAND, label=f"{1e3 * BAND:g} mm", **look.LIMITS)
    top.set(title="distance of the tip from its goal", ylabel="distance (mm)")
    for j, (limit, shade) in enumerate(zip(LIMITS, look.PALETTE, strict=False)):
        bottom.step(t[:-1], run["tau"][:, j], where="post", color=shade, label=("base y", "base z", "elbow z")[j])
        bottom.hlines([-limit, limit], 0.0, t[-1], linestyles=":", colors=shade, linewidth=0.8)
    bottom.set(title="torques and their limits", xlabel="t (s)", ylabel="τ (N·m)")
    for axes in (top, bottom):
        axes.set_xlim(0, t[-1])
        look.legend_above(axes)
    PLOT.parent.mkdir(exist_ok=True)
    PLOT.write_bytes(look.png(figure))


def main() -> None:
    parser = argparse.ArgumentParser(description="MPC of ELLA with do-mpc")
    parser.add_argument("--short", action="store_true", help="1 s of motion and no plot")
    short = parser.parse_args().short
    model = arm()
    goal = tips(model, np.r_[at_rest(model, GOAL)[0], np.zeros(model.nq)][None])[0]
    run = closed_loop(model, goal, samples=32 if short else 50)
    error = np.linalg.norm(tips(model, run["x"]) - goal, axis=1)
    gap = np.abs(tips(model, replayed(model, run)) - tips(model, run["x"])).max()
    print(
        f"tip                     {error[0]:.2f} m from the goal, within {BAND * 1e3:g} mm after {settled(error):.2f} s"
    )
    print(f"at the end              {error[-3:].max() * 1e3:.2f} mm")
    print(f"largest torques         {np.abs(run['tau']).max(axis=0).round(1)} N·m of {LIMITS} N·m")
    print(f"solve time              median {np.median(run['seconds']):.3f} s, largest {run['seconds'].max():.3f} s")
    print(f"do-mpc and generated C  tips differ by at most {gap * 1e3:.3f} mm")
    if not short:
        save_plot(run, error)
        print(f"plot                    {PLOT.relative_to(ROOT)}")
    assert run["solved"].all(), "a solve did not converge"
    assert np.all(np.abs(run["tau"]) <= LIMITS + 1e-6), "a torque passes its limit"
    assert settled(error) <= 1.0 and error[-3:].max() <= BAND, "the tip has not settled"
    assert gap <= 1e-3, "do-mpc's simulator and the generated C part"


if __name__ == "__main__":
    main()
