"""An extended Kalman filter by the textbook, dense and in one piece: the judge of the generated one."""

from __future__ import annotations

import casadi as ca
import numpy as np

from screwgen import Model
from screwgen.runtime.estimator import Noise
from screwgen.simulation.integrate import JointStepper


class DenseFilter:
    """Mean ``x`` = [q; v] and covariance ``P``; all of it NumPy and CasADi, no generated C."""

    def __init__(self, model: Model, q, v, deviation_q, deviation_v, noise: Noise, gauge_rows):
        n, self.n, self.model, self.noise = model.nq, model.nq, model, noise
        self.x = np.r_[q, v].astype(float)
        self.P = np.diag(np.r_[full(deviation_q, n), full(deviation_v, n)] ** 2)
        self.numpy, self.stepper = model.numpy(), JointStepper(model, "modal_midpoint", model.parameter_values)
        self.gauge_rows = gauge_rows
        self.accelerometer = accelerometer(model)

    def predict(self, tau, w_ext, h):
        n, middle = self.n, self.x.copy()
        state = self.stepper.initial(self.x[:n], self.x[n:])
        self.x = np.concatenate(self.stepper.step(state, tau, w_ext, h))
        middle = (middle + self.x) / 2
        by_q, by_v, _ = self.numpy.derivatives(middle[:n], middle[n:], tau, w_ext)
        one = np.eye(2 * n)
        A = np.block([[np.zeros((n, n)), np.eye(n)], [by_q, by_v]])
        Phi = np.linalg.solve(one - h / 2 * A, one + h / 2 * A)
        G = np.linalg.solve(one - h / 2 * A, np.r_[np.zeros((n, n)), np.eye(n)])
        still = np.diag(np.r_[full(self.noise.density_q, n), np.zeros(n)])
        self.P = Phi @ self.P @ Phi.T + h * (G @ np.diag(full(self.noise.density_v, n)) @ G.T + still)

    def update(self, tau, w_ext, encoder, strain, acceleration):
        """All entries at once; NaN is not measured."""
        n, driven = self.n, self.model.chain.effort_places
        a, H_a = self.accelerometer(self.x, tau, np.reshape(w_ext, (-1, 6)).T)
        H = np.r_[np.eye(2 * n)[driven], self.gauge_rows, H_a.full()]
        expected = np.r_[self.x[driven], self.gauge_rows @ self.x, a.full()[:, 0]]
        z = np.r_[encoder, strain, acceleration]
        sizes = (len(driven), len(self.gauge_rows), 3)
        names = ("encoder", "strain", "acceleration")
        R = np.concatenate([full(getattr(self.noise, x), k) ** 2 for x, k in zip(names, sizes, strict=True)])
        there = np.isfinite(z)
        H, R, z, expected = H[there], np.diag(R[there]), z[there], expected[there]
        if there.any():
            K = np.linalg.solve(H @ self.P @ H.T + R, H @ self.P).T
            self.x = self.x + K @ (z - expected)
            rest = np.eye(2 * n) - K @ H
            self.P = rest @ self.P @ rest.T + K @ R @ K.T


def full(value, size) -> np.ndarray:
    return np.broadcast_to(np.asarray(value, float), size).copy()


def accelerometer(model: Model) -> ca.Function:
    """``(x, tau, w_ext) -> (a, da/dx)``: R^T (d²r/dt² - g), by differentiating the position of the tip twice."""
    n, p = model.nq, model.parameter_values
    x, tau, w = ca.SX.sym("x", 2 * n), ca.SX.sym("tau", model.n_tau), ca.SX.sym("w", 6, model.n_links)
    q, v = x[:n], x[n:]
    vdot = model.casadi()["forward_dynamics"](q, v, tau, w, p)[0]
    R, r = model.casadi()["tip_pose"](q, p)
    rate = ca.jtimes(r, q, v)
    a = R.T @ (ca.jtimes(rate, q, v) + ca.jtimes(rate, v, vdot) - ca.DM(p[:3]))
    return ca.Function("accelerometer", [x, tau, w], [a, ca.jacobian(a, x)])
