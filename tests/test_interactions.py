"""Forces between frames: their wrenches are the slopes of their energies, and they do what textbooks say."""

import numpy as np
import pytest
from helpers import model_of
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

import screwgen
from screwgen.algorithms.force_programs import energy, slopes, wrenches
from screwgen.backends.numpy.numeric import EPSILON, function_of
from screwgen.interactions import KINDS

LAWS = {
    "spring": KINDS["line"](stiffness=300.0, rest=0.4),
    "taut rope": KINDS["line"](stiffness=300.0, rest=0.4, slack=True),
    "slack rope": KINDS["line"](stiffness=300.0, rest=4.0, slack=True),
    "bushing": KINDS["bushing"](stiffness=(300.0, 500.0, 200.0, 7.0, 9.0, 4.0)),
    "plane": KINDS["contact"](radius=1.1, stiffness=400.0, width=0.02, normal=(0.3, -1.0, 0.8)),
    "edge of a plane": KINDS["contact"](radius=0.6, stiffness=400.0, width=0.8, normal=(0.3, -1.0, 0.8)),
    "sphere and point": KINDS["contact"](radius=1.1, stiffness=400.0, width=0.02),
    "spheres": KINDS["contact"](radius=0.5, stiffness=400.0, width=0.02, other=0.6),
}
DAMPED = {
    "damper": KINDS["line"](stiffness=300.0, rest=0.4, damping=8.0),
    "damped bushing": KINDS["bushing"](
        stiffness=(3.0, 5.0, 2.0, 7.0, 9.0, 4.0), damping=(1.0, 2.0, 3.0, 0.4, 0.5, 0.6)
    ),
    "friction": KINDS["contact"](1.1, 400.0, 0.02, (0.3, -1.0, 0.8), damping=0.3, friction=0.7, velocity=0.2),
    "drag": KINDS["drag"](linear=(1.0, 2.0, 3.0), quadratic=4.0),
}


def run(program, **given) -> dict[str, np.ndarray]:
    found, _ = function_of(program)({name: list(map(float, np.ravel(x))) for name, x in given.items()}, EPSILON)
    return {name: np.array(x) for name, x in found.items()}


def numbers(law) -> list[float]:
    return [y for x in law.numbers.values() for y in np.ravel(x)]


def state(seed: int = 3) -> dict[str, np.ndarray]:
    """A pose of the second frame in the first, and the twists of both."""
    rng = np.random.default_rng(seed)
    R = Rotation.from_rotvec([0.5, -0.3, 0.8]).as_matrix()
    return {"R": R, "d": np.array([0.5, 0.3, -0.4]), "V_A": rng.normal(size=6), "V_B": rng.normal(size=6)}


def moved(x: dict, h: float) -> dict[str, np.ndarray]:
    """The pose after the twists have lasted for h."""
    turn, shift = (lambda V: Rotation.from_rotvec(h * V[:3]).as_matrix()), (lambda V: h * V[3:])
    R_A, R_B = turn(x["V_A"]), turn(x["V_B"])
    return {"R": R_A.T @ x["R"] @ R_B, "d": R_A.T @ (x["d"] + x["R"] @ shift(x["V_B"]) - shift(x["V_A"]))}


def power(law, x: dict) -> float:
    """What the wrenches do at the twists, W."""
    found = run(wrenches(law.shape), **x, numbers=numbers(law))
    return float(found["first"] @ x["V_A"] + found["second"] @ x["V_B"])


@pytest.mark.parametrize("name", LAWS)
def test_the_power_is_what_the_energy_loses(name):
    """For any motion of both frames, so all twelve entries of the wrenches are the slopes of the energy."""
    law = LAWS[name]
    at = lambda x, h: run(energy(law.shape), **moved(x, h), numbers=numbers(law))["energy"].item()  # noqa: E731
    for seed in range(6):
        x, h = state(seed), 1e-3
        rate = (8 * (at(x, h) - at(x, -h)) - at(x, 2 * h) + at(x, -2 * h)) / (12 * h)
        assert power(law, x) == pytest.approx(-rate, rel=1e-8, abs=1e-8)
    assert (name == "slack rope") == (abs(power(law, state())) < 1e-12)


@pytest.mark.parametrize("name", DAMPED)
def test_what_is_damped_loses_power(name):
    law = DAMPED[name]
    plain = {key: x for key, x in law.numbers.items() if key not in ("damping", "friction", "linear", "quadratic")}
    for seed in range(6):
        kept = 0.0 if name == "drag" else power(type(law)(**plain), state(seed))
        assert power(law, state(seed)) < kept


@pytest.mark.parametrize("name", [*LAWS, *DAMPED])
def test_slopes_are_those_of_differences(name):
    law, x, h = (LAWS | DAMPED)[name], state(), 1e-5
    found = {key: y.reshape(12, 12) for key, y in run(slopes(law.shape), **x, numbers=numbers(law)).items()}
    at = lambda y: np.concatenate([*run(wrenches(law.shape), **y, numbers=numbers(law)).values()])  # noqa: E731
    scale = np.abs(at(x)).max() + np.abs(found["by_pose"]).max() + 1e-3
    for k, e in enumerate(np.eye(12)):
        pair = {"V_A": e[:6], "V_B": e[6:]}
        there = [at(x | moved(x | pair, s * h)) for s in (1, -1)]
        np.testing.assert_allclose(found["by_pose"][:, k], (there[0] - there[1]) / (2 * h), atol=1e-7 * scale)
        faster = [at(x | {n: x[n] + s * h * pair[n] for n in pair}) for s in (1, -1)]
        np.testing.assert_allclose(found["by_twist"][:, k], (faster[0] - faster[1]) / (2 * h), atol=1e-7 * scale)


def test_two_spheres_rub_where_they_touch():
    """That is 0.5 m from the first centre and 0.55 from the second: surfaces that move alike there do not rub."""
    law = KINDS["contact"](radius=0.5, stiffness=400.0, width=0.01, other=0.6, friction=0.7, velocity=1e-3)
    at = {"R": np.eye(3), "d": np.array([1.05, 0.0, 0.0]), "V_B": np.array([0.0, 0.0, -0.5, 0.0, 0.0, 0.0])}
    for rate, slip in ((0.55, 0.0), (0.6, 0.025)):
        V_A = np.array([0.0, 0.0, rate, 0.0, 0.0, 0.0])
        second = run(wrenches(law.shape), **at, V_A=V_A, numbers=numbers(law))["second"]
        assert second[3] == pytest.approx(400.0 * 0.05)
        assert second[4] == pytest.approx(0.7 * second[3] * slip / np.hypot(slip, 1e-3), abs=1e-9)


def block(force: dict, gravity=(0.0, 0.0, -9.81)) -> dict:
    """A body of 2 kg that slides along x and z."""
    body = {"mass": 2.0, "inertia": [0.01, 0.01, 0.01, 0.0, 0.0, 0.0], "at": "tip"}
    link = {"name": "block", "joint": {"axes": [{"slide": "x"}, {"slide": "z"}]}, "bodies": [body]}
    return {"name": "heap", "gravity": list(gravity), "links": [link], "forces": [{"name": "floor", **force}]}


def contact(**more) -> dict:
    law = {"normal": [0.0, 0.0, 1.0], "radius": 0.1, "stiffness": 2e5, "width": 1e-6, **more}
    return {"between": ["block.tip", "world"], "contact": law}


def test_a_bouncing_body_comes_back_as_hunt_and_crossley_say():
    """Without weight, from v: ``v - ln(1 + c v)/c`` is the same before and behind the contact."""
    c, v = 0.4, 1.5
    model = model_of(block(contact(damping=c), gravity=(0.0, 0.0, 0.0)))
    run = screwgen.simulate(model, 0.03, 2e-6, q0=[0.0, 0.1 + 1e-3], v0=[0.0, -v], integrator="rk4")
    law = lambda u: u - np.log(1 + c * u) / c  # noqa: E731
    back = -brentq(lambda u: law(u) - law(v), -1.0 / c + 1e-9, -1e-9)
    assert run.v[-1, 1] == pytest.approx(back, rel=1e-5)
    assert back < 0.75 * v


@pytest.mark.parametrize("angle", [0.45, 0.6])
def test_a_body_slides_beyond_coulombs_angle(angle):
    """On a plane of friction 0.55, whose angle is 0.503 rad; below, what is left is the creep of the small velocity."""
    mu, g = 0.55, 9.81
    down = [g * np.sin(angle), 0.0, -g * np.cos(angle)]
    model = model_of(block(contact(damping=0.5, friction=mu, velocity=1e-3), gravity=down))
    sunk = 2.0 * g * np.cos(angle) / 2e5
    run = screwgen.simulate(model, 0.3, 2e-5, q0=[0.0, 0.1 - sunk], integrator="rk4")
    if np.tan(angle) < mu:
        creep = 1e-3 * np.tan(angle) / np.sqrt(mu**2 - np.tan(angle) ** 2)
        assert run.v[-1, 0] == pytest.approx(creep, rel=1e-3)
    else:
        rate = (run.v[-1, 0] - run.v[len(run.v) // 2, 0]) / (run.t[-1] - run.t[len(run.t) // 2])
        assert rate == pytest.approx(g * (np.sin(angle) - mu * np.cos(angle)), rel=1e-4)


def test_a_body_that_bounces_and_rubs_gains_nothing():
    """Its energy, that of the contact included, falls at every step, but for what a step of 4e-6 s leaves."""
    model = model_of(block(contact(stiffness=2e4, damping=0.3, friction=0.4, velocity=1e-2)))
    run = screwgen.simulate(model, 0.6, 4e-6, q0=[0.0, 0.13], v0=[0.8, 0.0], integrator="rk4", every=50)
    total = run.energy.sum(axis=1)
    assert np.diff(total).max() < 1e-9 * np.ptp(total) and (run.q[:, 1] < 0.1).sum() > 10
    assert run.v[-1, 0] < 0.3 and np.ptp(total) > 0.5


def test_a_rope_catches_and_lets_go():
    """A mass that falls into a rope and bounces: its depth, period and motion are those of the closed form."""
    k, rest, m, g = 5e3, 0.5, 2.0, 9.81
    model = model_of(block({"between": ["block.tip", {"world": [0.0, 0.0, 1.0]}],
                            "line": {"stiffness": k, "rest": rest, "slack": True}}))  # fmt: skip
    run = screwgen.simulate(model, 1.0, 1e-5, q0=[0.0, 0.9], integrator="rk4")
    fall = lambda s: m * g * (0.4 + s) - k * s**2 / 2  # noqa: E731
    deepest = 1.0 - rest - brentq(fall, 0.0, 1.0)
    assert run.q[:, 1].min() == pytest.approx(deepest, abs=1e-6)
    total = run.energy.sum(axis=1)
    assert np.ptp(total) < 1e-5 * m * g
    falls, omega = np.sqrt(2 * 0.4 / g), np.sqrt(k / m)
    swings = 2 * (np.pi - np.arctan(omega * falls)) / omega  # s: that the rope is taut
    t = run.t % (2 * falls + swings)
    t = np.where(t < falls + swings, t, t - 2 * falls - swings)
    swing = g / omega**2 * (1 - np.cos(omega * (t - falls))) + g * falls / omega * np.sin(omega * (t - falls))
    height = np.where(np.abs(t) < falls, 0.9 - g * t**2 / 2, 0.5 - swing)
    assert (run.t > 2 * falls + swings).any() and np.abs(run.q[:, 1] - height).max() < 1e-5


def test_springs_keep_their_energy_to_the_order_of_rk4():
    """A mass that swings in a plane: half the step leaves a sixteenth of what is gained or lost at most, or less."""
    spring = {"between": ["block.tip", {"world": [0.3, 0.0, 1.5]}], "line": {"stiffness": 300.0, "rest": 1.0}}
    model, lost = model_of(block(spring)), []
    for step in (5e-3, 2.5e-3):
        total = screwgen.simulate(model, 1.0, step, v0=[0.5, 0.3], integrator="rk4").energy.sum(axis=1)
        lost.append(np.abs(total - total[0]).max())
    assert lost[1] < 1e-6 and lost[0] > 15 * lost[1], lost


def test_drag_leaves_a_terminal_velocity():
    m, g, b = 2.0, 9.81, 0.8
    model = model_of(block({"between": ["block.tip", "world"], "drag": {"quadratic": b}}))
    run = screwgen.simulate(model, 8.0, 1e-3, integrator="rk4")
    assert run.v[-1, 1] == pytest.approx(-np.sqrt(m * g / b), rel=1e-6)
