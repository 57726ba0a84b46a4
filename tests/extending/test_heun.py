"""An integrator of one's own: the table below is all that Heun's method takes, in NumPy, CasADi, C and its batch."""

import pickle
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from helpers import QUICK

import screwgen
from screwgen.integrators import Method, Move, Stage
from screwgen.simulation.simulate import stepper

HEUN = Method("heun", 2, (Stage(), Stage([1])), Move(["1/2", "1/2"]), "Heun's method, two forward dynamics")

DURATION = 0.1


@cache
def model() -> screwgen.Model:
    """Two soft links, the second on a joint with a spring, which swing slowly enough for an explicit method."""
    section = screwgen.Section(rhoA=1.0, EIy=5.0, EIz=8.0, rhoIp=1e-2)
    modes, tip = screwgen.Modes(bending_y=1, bending_z=1), (screwgen.Body(at="tip", mass=0.5),)
    upper = screwgen.Joint(axes=["y", "z"])
    elbow = screwgen.Joint(axes=["y"], stiffness=[20.0], damping=[0.3])
    links = (
        screwgen.Link(name="upper", length=0.8, joint=upper, section=section, modes=modes, bodies=tip),
        screwgen.Link(name="fore", length=0.6, joint=elbow, section=section, modes=modes, bodies=tip),
    )
    return screwgen.derive(screwgen.Robot(name="swing", gravity=(0.0, 0.0, -9.81), links=links))


@cache
def compiled():
    return model().compile(flags=QUICK, methods=(HEUN,))


@cache
def start():
    """State, torques and tip wrenches."""
    rng = np.random.default_rng(2)
    q, v = 0.01 * rng.normal(size=model().nq), 0.1 * rng.normal(size=model().nq)
    q[:3], v[:3] = [0.3, -0.5, 0.7], [1.0, -2.0, 1.5]
    return q, v, np.array([2.0, -1.0, 0.5]), rng.normal(size=(2, 6))


def in_numpy(steps: int) -> np.ndarray:
    plant, (q, v, tau, w_ext) = stepper(model(), HEUN), start()
    state = plant.initial(q, v)
    for _ in range(steps):
        state = plant.step(state, tau, w_ext, DURATION / steps)
    return np.concatenate(plant.coordinates(state))


def in_casadi(steps: int) -> np.ndarray:
    step, (q, v, tau, w_ext) = model().casadi(methods=(HEUN,))["step_heun"], start()
    for _ in range(steps):
        q, v = step(q, v, tau, w_ext.T, model().parameter_values, DURATION / steps)
    return np.concatenate([np.array(q), np.array(v)]).ravel()


def in_c(steps: int) -> np.ndarray:
    return np.concatenate(compiled().step(*start(), DURATION / steps, HEUN, steps))


def in_lanes(steps: int) -> np.ndarray:
    q, v, tau, w_ext = start()
    inputs = {"w_ext": w_ext, "step": DURATION, "steps": 1, "substeps": steps}
    return screwgen.rollout(model(), np.append(q, v), tau, integrator=HEUN, **inputs).x[0, -1]


def in_a_run(steps: int) -> np.ndarray:
    q, v, tau, w_ext = start()
    run = screwgen.simulate(model(), DURATION, DURATION / steps, q, v, tau, w_ext, HEUN)
    return np.concatenate([run.q[-1], run.v[-1]])


WAYS = {"numpy": in_numpy, "casadi": in_casadi, "c": in_c, "batch": in_lanes, "run": in_a_run}


@pytest.mark.filterwarnings("ignore::screwgen.ModelValidityWarning")
@pytest.mark.parametrize("way", WAYS)
def test_a_step_is_heuns(way):
    """In the textbook's words: the mean of the slopes at both ends of a step of Euler's."""
    (q, v, *inputs), h = start(), DURATION / 100
    x = np.append(q, v)

    def slope(x):
        q, v = np.split(x, 2)
        return np.append(v, model().numpy().forward_dynamics(q, v, *inputs)[0])

    for _ in range(100):
        first = slope(x)
        x = x + h / 2 * (first + slope(x + h * first))
    assert np.abs(WAYS[way](100) - x).max() < 1e-11 * np.abs(x).max()


def test_the_generated_folder_checks_it(tmp_path):
    """The folder's own check takes a step of it, too: it fails where a length in that step is changed."""
    files = model().write(tmp_path, targets=("c",), methods=(HEUN,), batch=True)
    folder, source = tmp_path / "c", tmp_path / "c" / "swing_step.c"
    assert "swing_step_batch_heun" in (folder / "swing_batch.h").read_text() and "c/check.c" in files

    def check(*sources: str) -> int:
        subprocess.run(["cc", "-std=c99", *QUICK, "-c", *sources], cwd=folder, check=True)
        objects = sorted(p.name for p in folder.glob("*.o"))
        subprocess.run(["cc", *objects, "-o", "check", "-lm"], cwd=folder, check=True)
        return subprocess.run(["./check"], cwd=folder, capture_output=True).returncode

    assert check(*sorted(p.name for p in folder.glob("swing_*.c")), "check.c") == 0
    before, step = source.read_text().split("swing_step_heun(")
    assert step.count("half = dt / 2") == 1
    source.write_text(before + "swing_step_heun(" + step.replace("half = dt / 2", "half = dt / 3"))
    assert check(source.name) == 1


def test_it_is_an_argument_and_leaves_nothing_behind():
    with pytest.raises(screwgen.UsageError, match="no integrator 'heun'"):
        model().compile(flags=QUICK).step(*start(), 1e-3, "heun")
    with pytest.raises(screwgen.UsageError, match="no integrator 'heun'"):
        stepper(model(), "heun")
    assert "step_heun" not in model().casadi()
    again = pickle.loads(pickle.dumps(compiled()))
    assert np.array_equal(
        np.concatenate(again.step(*start(), 1e-3, "heun")), np.concatenate(compiled().step(*start(), 1e-3, HEUN))
    )


def test_this_file_is_all_that_it_takes():
    product = Path(screwgen.__file__).parent
    texts = [*product.rglob("*.py"), *(product.parent / "templates").rglob("*.jinja")]
    assert len(texts) > 200 and not any("heun" in path.read_text(encoding="utf-8").lower() for path in texts)
