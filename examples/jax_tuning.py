"""Gradient-based tuning of a PD law: 1,000 scenarios of payloads and starts, differentiated through the flexible arm.

The gains of a planar arm with two flexible links are logarithms that Adam moves along the gradient of the mean cost of
all scenarios: the error of the joints and the effort. The motions are steps of JAX under `jit(vmap(scan(step)))`. The
same torques go through the compiled C at the end. Writes build/jax_tuning.png. Needs
`pip install screwgen[jax]`; some minutes. `--short`: few scenarios, seconds.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", True)

import screwgen  # noqa: E402
from screwgen.plotting.look import PALETTE, canvas, png, styled  # noqa: E402

FILE = Path(__file__).resolve().parents[1] / "build" / "jax_tuning.png"
TUBE = {"rhoA": 0.9, "EIz": 160.0}
LINKS = [
    {"name": name, "length": length, "section": TUBE, "modes": {"bending_y": 2}, "damping": {"ratio": 0.01}}
    | {"joint": {"axes": ["z"], "armature": 0.15}, "bodies": [{"at": "tip", "mass": mass}]}
    for name, length, mass in (("upper_arm", 0.8, 1.5), ("forearm", 0.7, 1.0))
]
ROBOT = {"name": "tuned", "gravity": [0.0, 0.0, 0.0], "links": LINKS}
H, GOAL, PAYLOADS = 4e-3, np.array([0.6, -0.9]), (0.2, 3.0)
FIRST = np.log([40.0, 20.0, 4.0, 2.0])
"""Logarithms of the first gains: N·m/rad, then N·m·s/rad."""
EFFORT = 2e-4


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--short", action="store_true", help="24 scenarios, 50 steps, 4 iterations")
    short = parser.parse_args().short
    count, steps, rounds = (24, 50, 4) if short else (1000, 200, 25)
    model = screwgen.derive(screwgen.Robot.model_validate(ROBOT))
    starts, parameters = scenarios(model, count)
    moved = motions(model, starts, parameters, steps)
    cost = jax.jit(jax.value_and_grad(lambda gains: costs(moved(gains)), has_aux=True))
    found, history, before, after = tune(cost, jnp.array(FIRST), rounds)
    check(model, starts, parameters, after)
    print(f"gains {np.exp(FIRST).round(1)} -> {np.exp(found).round(1)}")
    print(f"mean cost {history[0]:.4f} -> {min(history):.4f}")
    assert min(history) < history[0]
    FILE.parent.mkdir(parents=True, exist_ok=True)
    FILE.write_bytes(picture(before, after, history))
    print(f"build/{FILE.name}")


def scenarios(model, count: int) -> tuple[jnp.ndarray, jnp.ndarray]:
    """Postures at rest (count, nq) and parameters (count, n): the payload differs."""
    rng = np.random.default_rng(0)
    q = np.zeros((count, model.nq))
    q[:, :2] = rng.uniform(-0.8, 0.8, (count, 2))
    p = np.tile(model.parameter_values, (count, 1))
    p[:, model.chain.parameters.place("forearm.bodies[0].mass")] = rng.uniform(*PAYLOADS, count)
    return jnp.array(q), jnp.array(p)


def motions(model, starts, parameters, steps: int):
    """``(gains) -> (q, tau)``: the motions (count, steps, nq) and torques (count, steps, 2) under the PD law."""
    step, w_ext = model.jax()["step_modal_midpoint"], jnp.zeros((model.n_links, 6))

    def one(gains, q, p):
        kp, kd = jnp.split(jnp.exp(gains), 2)

        def period(state, _):
            q, v = state
            tau = kp * (GOAL - q[:2]) - kd * v[:2]
            return step(q, v, tau, w_ext, p, H), (q, tau)

        return jax.lax.scan(period, (q, jnp.zeros(model.nv)), None, length=steps)[1]

    return lambda gains: jax.vmap(one, (None, 0, 0))(gains, starts, parameters)


def costs(run) -> tuple[jnp.ndarray, tuple]:
    """The mean cost of all scenarios, and the motions and torques of which it is made."""
    q, tau = run
    return H * (((q[..., :2] - GOAL) ** 2).sum(axis=(1, 2)) + EFFORT * (tau**2).sum(axis=(1, 2))).mean(), run


def tune(cost, gains, rounds: int) -> tuple[np.ndarray, list[float], tuple, tuple]:
    """The best gains by Adam, the costs, and the runs with the first and with the best gains."""
    mean, square, history, first, best = 0.0, 0.0, [], None, (np.inf, gains, None)
    for k in range(1, rounds + 1):
        clock = time.perf_counter()
        (value, run), slope = cost(gains)
        history.append(float(value))
        first = first or run
        best = min(best, (float(value), gains, run), key=lambda found: found[0])
        size, spent = np.linalg.norm(slope), time.perf_counter() - clock
        print(f"iteration {k}: cost {value:.4f}, slope {size:.2e}, {spent:.1f} s")
        mean, square = 0.9 * mean + 0.1 * slope, 0.99 * square + 0.01 * slope**2
        gains = gains - 0.15 * (mean / (1 - 0.9**k)) / (jnp.sqrt(square / (1 - 0.99**k)) + 1e-12)
    return np.array(best[1]), history, first, best[2]


def check(model, starts, parameters, run) -> None:
    """The same torques through the generated C."""
    q, tau = (np.array(x) for x in run)
    x0 = np.hstack([starts, np.zeros((len(starts), model.nv))])
    other = screwgen.rollout(model, x0, tau, step=H, parameters=np.array(parameters))
    error = np.abs(other.q[:, :-1] - q).max()
    print(f"JAX and the C, {q.shape[0]} motions of {q.shape[1]} steps: they differ by at most {error:.1e} rad, m")
    assert error < 1e-9


@styled
def picture(before, after, history) -> bytes:
    """The joint errors of all scenarios with the first and with the tuned gains, and the cost."""
    figure = canvas(9.0, 3.4)
    axes = figure.subplots(1, 3)
    t = H * np.arange(before[0].shape[1])
    errors = [np.linalg.norm(np.array(run[0][..., :2]) - GOAL, axis=2) for run in (before, after)]
    top = 1.05 * max(error.max() for error in errors)
    for axis, error, title in zip(axes[:2], errors, ("First gains", "Tuned gains"), strict=True):
        for low, high, shade in ((0, 100, 0.15), (10, 90, 0.3)):
            axis.fill_between(t, *np.percentile(error, (low, high), axis=0), color=PALETTE[0], alpha=shade, linewidth=0)
        axis.plot(t, np.median(error, axis=0), color=PALETTE[0])
        axis.set(title=title, xlabel="time (s)", ylim=(0, top))
    axes[0].set_ylabel("joint error (rad): median, 80 %, all")
    axes[2].plot(np.arange(1, len(history) + 1), history, color=PALETTE[1], marker="o", markersize=3)
    axes[2].set(title="Mean cost", xlabel="iteration")
    return png(figure)


if __name__ == "__main__":
    main()
