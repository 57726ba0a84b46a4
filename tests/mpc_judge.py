"""A predictive controller's problem in CasADi, from its functions and the controller's file alone."""

from __future__ import annotations

import casadi as ca
import numpy as np

from screwgen import Model
from screwgen.algorithms.gauges import gauges
from screwgen.spec.mpc import Mpc


class Problem:
    """The terms of every stage as CasADi functions; numbers are those of the controller's options."""

    def __init__(self, model: Model, said: Mpc, options: dict, reference: list[dict]):
        self.model, self.said, self.o, self.reference = model, said, options, reference
        self.n, self.nv, self.h = model.nq, model.nv, said.horizon.step
        self.chosen, self.given = model.chain.chosen_inputs, model.chain.given_inputs
        self.nu, self.nx, self.base = len(self.chosen), model.chain.n_changes, model.chain.base_v
        self.lengths = said.horizon.lengths
        self.block = [b for b, length in enumerate(self.lengths) for _ in range(length)]
        x, u, g = ca.SX.sym("x", model.nq + model.chain.nvz), ca.SX.sym("u", self.nu), ca.SX.sym("g", len(self.given))
        dx = ca.SX.sym("dx", self.nx)
        tau = ca.SX(model.n_tau, 1)
        tau[self.chosen], tau[self.given] = u, g
        made = lambda name, given, *results: ca.Function(  # noqa: E731
            name, given, [ca.substitute(result, dx, ca.SX.zeros(self.nx)) for result in results]
        )
        near = self.changed(x, dx)
        after, moved = self._interval(x, tau), self._interval(near, tau)
        self.interval = ca.Function("interval", [x, u, g], [after])
        there = ca.SX.sym("there", model.nq + model.chain.nvz)
        slopes = [ca.substitute(ca.jacobian(self.change(there, moved), z), there, after) for z in (dx, u)]
        self.slopes = made("slopes", [x, u, g], *slopes)
        y, w = ca.SX.sym("y", 18), self._state_terms
        self.terms = made("terms", [x, y], w(x, y), ca.jacobian(w(near, y), dx))
        self.soft_state = made("soft_state", [x], self._soft_state(x), ca.jacobian(self._soft_state(near), dx))
        wrench = self._wrench(near, tau)
        self.wrench = made("wrench", [x, u, g], self._wrench(x, tau), ca.jacobian(wrench, dx), ca.jacobian(wrench, u))

    def changed(self, x, dx):
        """The state after a small change, of which a base has three turns and three shifts along its axes."""
        if not self.base:
            return x + dx
        r, (w, e), turn = x[:3], (x[3], x[4:7]), dx[:3] / 2
        size = ca.sqrt(1 + ca.dot(turn, turn))
        quaternion = ca.vertcat(w - ca.dot(e, turn), e + w * turn + ca.cross(e, turn)) / size
        return ca.vertcat(r + self._turn(w, e) @ dx[3:6], quaternion, x[7:] + dx[6:])

    def change(self, a, b):
        """The small change from one state to another."""
        if not self.base:
            return b - a
        (w, e), (v, f) = ((x[3], x[4:7]) for x in (a, b))
        turn = 2 * (w * f - v * e - ca.cross(e, f))
        return ca.vertcat(turn, self._turn(w, e).T @ (b[:3] - a[:3]), b[7:] - a[7:])

    @staticmethod
    def _turn(w, e):
        E = ca.skew(e)
        return ca.DM.eye(3) + 2 * w * E + 2 * E @ E

    def among(self, k: int) -> np.ndarray:
        """The given inputs over interval k."""
        return self.reference[k]["tau"][self.given]

    def _interval(self, x, u):
        horizon = self.said.horizon
        step, p = self.model.casadi()[f"step_{horizon.method}"], self.model.parameter_values
        w_ext = ca.DM.zeros(6, self.model.n_links)
        for _ in range(horizon.substeps):
            x = ca.vertcat(*step(x[: self.n], x[self.n :], u, w_ext, p, self.h / horizon.substeps))
        return x

    def _state_terms(self, x, y):
        """What the tip misses, (9,): position, orientation, velocity."""
        R, r = self.model.casadi()["tip_pose"](x[: self.n], self.model.parameter_values)
        J = self.model.casadi()["tip_jacobian"](x[: self.n], self.model.parameter_values)
        to = ca.reshape(y[3:12], 3, 3).T
        turn = sum(ca.cross(to[:, a], R[:, a]) for a in range(3)) / 2
        return ca.vertcat(r - y[:3], turn, (J @ x[self.n : self.n + self.nv])[3:] - y[12:15])

    def _soft_state(self, x):
        rows, bounds = [], self.said.bounds
        joints, first = range(self.model.n_joints), self.model.chain.base_q
        rows += [x[first + i] for i in joints if bounds.joints is not None]
        rows += [x[self.n + self.base + i] for i in joints if bounds.joint_rates is not None]
        rows += [x[self.n + self.nv + i] for i in range(self.model.chain.z_offset[-1])]
        for k, g in enumerate(gauges(self.model.chain) if bounds.strains else ()):
            eta, length = x[self.n - self.model.chain.n_modes + g.first :], self.model.robot.links[g.link].length
            bend = sum(c / length**2 * eta[i] for i, c in enumerate(g.curvatures))
            rows.append(-float(self.o["fibre"][k]) * bend)
        return ca.vertcat(*rows) if rows else ca.SX(0, 1)

    def soft_bounds(self) -> tuple[np.ndarray, np.ndarray]:
        o, bounds, lower, upper = self.o, self.said.bounds, [], []
        if bounds.joints is not None:
            lower, upper = [*lower, *o["joint_lower"]], [*upper, *o["joint_upper"]]
        if bounds.joint_rates is not None:
            lower, upper = [*lower, *-o["joint_rate"]], [*upper, *o["joint_rate"]]
        bent = 0.55 * o["scatter"][2 * self.nv :][: self.model.chain.z_offset[-1]]
        lower, upper = [*lower, *-bent], [*upper, *bent]
        if bounds.strains is not None:
            lower, upper = [*lower, *-o["strain"]], [*upper, *o["strain"]]
        return np.array(lower), np.array(upper)

    def _wrench(self, x, u):
        p, w_ext = self.model.parameter_values, ca.DM.zeros(6, self.model.n_links)
        w = ca.vec(self.model.casadi()["forward_dynamics"](x[: self.n], x[self.n :], u, w_ext, p)[1])
        names = [b.component for b in self.said.bounds.wrenches]
        return ca.vertcat(*[w[self.model.wrench_names.index(name)] for name in names]) if names else ca.SX(0, 1)

    # numbers -----------------------------------------------------------------------------------

    def weights(self) -> np.ndarray:
        """Of [q; v], in which internal states, behind the rates, cost nothing."""
        base = np.zeros(self.base)
        own = [base, self.o["joints"], self.o["modes"], base, self.o["joint_rates"], self.o["mode_rates"]]
        return np.concatenate([*own, np.zeros(self.nx - 2 * self.nv)])

    def tip_weights(self) -> np.ndarray:
        names = ("tip_position", "tip_orientation", "tip_velocity")
        stated = [getattr(self.said.cost, name) is not None for name in names]
        return np.concatenate([self.o[name] * s for name, s in zip(names, stated, strict=True)])

    def share(self, k: int) -> float:
        return self.h * (float(self.o["terminal_factor"][0]) if k == len(self.block) else 1.0)

    def target(self, k: int) -> tuple[np.ndarray, np.ndarray]:
        y = self.reference[k]
        tip = np.r_[y["tip_position"], y["tip_rotation"].ravel(), y["tip_velocity"], np.zeros(3)]
        return np.r_[y["q"], y["v"]], tip

    def dense(self, X, U, acting, dx0):
        """H, g per N·m, and rows of the soft constraints with their values, about a plan and from another start."""
        N, nz, nx = len(self.block), self.nu * len(self.lengths), self.nx
        G, off = np.zeros((nx, nz)), np.array(dx0, float)
        H, g, rows, values, wrenches, wrench_values = np.zeros((nz, nz)), np.zeros(nz), [], [], [], []
        pick = lambda k: np.kron(np.eye(len(self.lengths))[self.block[k]], np.eye(self.nu))  # noqa: E731
        for k in range(N + 1):
            if k:
                target, tip = self.target(k)
                e, C = map(np.array, self.terms(X[k], tip))
                Q = self.share(k) * (np.diag(self.weights()) + C.T @ np.diag(self.tip_weights()) @ C)
                away = np.array(self.change(ca.DM(target), ca.DM(X[k])))[:, 0]
                slope = self.share(k) * (self.weights() * away + C.T @ (self.tip_weights() * e[:, 0]))
                if k == N:
                    Q, slope = Q + self.o["terminal"], slope + self.o["terminal"] @ away
                H += G.T @ Q @ G
                g += G.T @ (slope + Q @ off)
                at, slopes = map(np.array, self.soft_state(X[k]))
                rows.append(slopes @ G)
                values.append(at[:, 0] + slopes @ off)
            if k < N:
                S = pick(k)
                u, g_k = U[self.block[k]], self.among(k)
                w, w_x, w_u = map(np.array, self.wrench(X[k], u, g_k))
                wrenches.append(w_x @ G + w_u @ S)
                wrench_values.append(w[:, 0] + w_x @ off)
                H += self.h * S.T @ np.diag(self.o["torques"]) @ S
                g += self.h * S.T @ (self.o["torques"] * (u - self.reference[k]["tau"][self.chosen]))
                A, B = map(np.array, self.slopes(X[k], u, g_k))
                d = np.array(self.change(ca.DM(X[k + 1]), self.interval(X[k], u, g_k)))[:, 0]
                G, off = A @ G + B @ S, A @ off + d
        D = np.eye(nz) - np.eye(nz, k=-self.nu)
        jumps = D @ np.ravel(U) - np.r_[acting, np.zeros(nz - self.nu)]
        R = np.diag(np.tile(self.o["torque_rates"] / self.h, len(self.lengths)))
        soft = np.vstack([*rows, *wrenches]), np.concatenate([*values, *wrench_values])
        return H + D.T @ R @ D, g + D.T @ R @ jumps, D, jumps, *soft

    def solve(self, x0, acting, guess):
        """The torques (blocks, n_tau) of the converged problem, by IPOPT with exact derivatives, and its cost."""
        N, M = len(self.block), len(self.lengths)
        opti = ca.Opti()
        z = opti.variable(self.nu, M)
        half = (self.o["torque_upper"] - self.o["torque_lower"]) / 2
        U, x, cost = z * ca.repmat(ca.DM(half), 1, M), ca.DM(x0), 0
        lower, upper = self.soft_bounds()
        for k in range(N):
            u = U[:, self.block[k]]
            cost += self._softened(opti, self.wrench(x, u, self.among(k))[0], -self.o["wrench"], self.o["wrench"])
            x = self.interval(x, u, self.among(k))
            target, tip = self.target(k + 1)
            e, off = self.terms(x, tip)[0], self.change(ca.MX(target), x)
            cost += self.share(k + 1) / 2 * (ca.dot(self.weights(), off**2) + ca.dot(self.tip_weights(), e**2))
            cost += self.h / 2 * ca.dot(self.o["torques"], (u - self.reference[k]["tau"][self.chosen]) ** 2)
            cost += self._softened(opti, self.soft_state(x)[0], lower, upper)
        cost += ca.bilin(self.o["terminal"], off, off) / 2
        for b in range(M):
            jump = U[:, b] - (U[:, b - 1] if b else acting)
            cost += ca.dot(self.o["torque_rates"], jump**2) / (2 * self.h)
            if self.said.bounds.torque_rates is not None:
                opti.subject_to(
                    opti.bounded(
                        -self.h * self.o["torque_rate"] / half, jump / half, self.h * self.o["torque_rate"] / half
                    )
                )
        for i in range(self.nu):
            opti.subject_to(
                opti.bounded(self.o["torque_lower"][i] / half[i], z[i, :], self.o["torque_upper"][i] / half[i])
            )
        opti.minimize(cost)
        opti.set_initial(z, (guess / half).T)
        quiet = {"print_level": 0, "sb": "yes", "tol": 1e-11, "constr_viol_tol": 1e-11, "max_iter": 200}
        opti.solver("ipopt", {"print_time": False}, quiet | {"bound_relax_factor": 0.0})
        found = opti.solve()
        return np.array(found.value(U)).reshape(self.nu, M).T, float(found.value(cost))

    def _softened(self, opti, values, lower, upper):
        if not values.numel():
            return 0
        half = (np.array(upper) - np.array(lower)) / 2
        s = opti.variable(values.numel())
        opti.subject_to(s >= 0)
        opti.subject_to(values / half - s <= np.array(upper) / half)
        opti.subject_to(values / half + s >= np.array(lower) / half)
        return float(self.o["penalty"][0]) * ca.sum1(s + s**2 / 2)


def off_the_dense_program(c, model: Model, q: np.ndarray, sizes: np.ndarray) -> float:
    """By how much the program of a controller is off, by the size of each part: Hessian, gradient, rows and bounds.

    The plan is none of the motion: changed at random by ``sizes`` (nv + nvz,), as is the state that is measured.
    """
    rng, blocks = np.random.default_rng(1), len(c.said.horizon.lengths)
    margin, c.options["margin"][:] = c.options["margin"].copy(), 1e4
    judge = Problem(model, c.said, c.options, c.reference)
    some = lambda x: np.array(judge.changed(ca.DM(x), ca.DM(sizes * rng.standard_normal(len(sizes)))))[:, 0]  # noqa: E731
    c.initialise(q, np.zeros(model.nv))
    for state in c.inner["x"]:
        state[:] = some(state)
    c.inner["tau"][:] += rng.standard_normal(c.inner["tau"].shape)
    c.prepare()
    X, U, acting, unit = c.states, c.inner["tau"].copy(), c.inner["acting"].copy(), np.tile(c.inner["unit"], blocks)
    x0 = some(X[0])
    c.feedback(*np.split(x0, [model.nq]))
    c.options["margin"][:] = margin
    if c.options["delay"]:
        x0 = np.array(judge.interval(x0, acting, c.options.get("given", [])))[:, 0]
    H, g, D, jumps, rows, values = judge.dense(X, U, acting, np.array(judge.change(ca.DM(X[0]), ca.DM(x0)))[:, 0])
    soft, wrench = judge.soft_bounds(), c.options["wrench"]
    low, high = (
        np.r_[np.tile(x, len(X) - 1), np.tile(y, len(X) - 1)] for x, y in zip(soft, (-wrench, wrench), strict=True)
    )
    there = high < 1e9
    half, rate = np.where(there, (high - low) / 2, 1.0), c.said.horizon.step * np.tile(c.options["torque_rate"], blocks)
    lower, upper = (np.tile(c.options[f"torque_{x}"], blocks) - U.ravel() for x in ("lower", "upper"))
    found, triangle = c.inner, np.tril(c.inner["H"])
    stated = np.r_[np.full(len(lower) + len(jumps), True), there]
    low, high, values, half = (x[there] for x in (low, high, values, half))
    pairs = (
        (triangle + np.tril(triangle, -1).T, unit[:, None] * H * unit),
        (found["g"], unit * g),
        (found["row"][stated[len(lower) :]], np.vstack([D, rows[there] * unit / half[:, None]])),
        (found["lower"][stated], np.r_[lower / unit, (-rate - jumps) / unit, (low - values) / half]),
        (found["upper"][stated], np.r_[upper / unit, (rate - jumps) / unit, (high - values) / half]),
    )
    return max(np.abs(a - b).max() / np.abs(b).max() for a, b in pairs)
