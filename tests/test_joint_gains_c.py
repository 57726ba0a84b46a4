"""The C of joint laws whose gains were found, beside the controllers of runs."""

import ctypes
from dataclasses import replace

import numpy as np
import pytest
from clocked_c import ClockedLaw
from helpers import loaded_boom, model_of
from robot_toml import to_toml
from test_joint_gains import BOOM

import screwgen
from screwgen import UsageError
from screwgen.cli.main import main
from screwgen.simulation.played import Played

OK, BAD_ARGUMENT, NONFINITE, NOT_STARTED, CLOCK_JUMPED = range(5)
GIVEN = ("measured", "rate", "q", "v", "tau")


class Compiled(ClockedLaw):
    """The C of found gains."""

    def __init__(self, law, folder, compiler="gcc", precision="double"):
        m = len(law.joints)
        state = {} if law.ki is None else {"z": m}
        super().__init__(law.c(), folder, "law", state, dict.fromkeys(GIVEN, m), compiler, precision)

    def start(self):
        return self.library.boom_law_start(ctypes.byref(self.state))

    def sample(self, time, *given):
        self.put(*given)
        return self.sample_put(time)


def limited(integral):
    """Gains of a boom whose drive has a limit."""
    model = model_of(loaded_boom(gravity=-9.81, joint={"armature": [0.3], "limits": [{"effort": 40.0}]}))
    return screwgen.gains(model, [[0.0]], integral=integral)


@pytest.mark.parametrize("integral", [False, True])
@pytest.mark.parametrize(("compiler", "precision"), [("gcc", "double"), ("clang", "double"), ("gcc", "float")])
def test_c_of_gains_gives_what_the_controllers_give(tmp_path, integral, compiler, precision):
    """In double to 1e-12 of the limit, also at it, where the integral stands still."""
    found, rng, most, clipped = limited(integral), np.random.default_rng(4), 0.0, 0
    c = Compiled(found, tmp_path, compiler, precision)
    goal = {"q_des": (0.6,), "duration": 0.8, "tau_max": tuple(found.tau_max), "q_start": (-0.4,)}
    law = screwgen.PID(found.kp, found.kd, ki=found.ki, **goal) if integral else screwgen.PD(found.kp, found.kd, **goal)
    assert c.start() == OK and found.tau_max == 40.0
    y = -0.4
    for k in range(1500):
        t = k * found.step
        q, v = law.reference(t)
        y += 0.02 * (q[0] - y) + 1e-3 * rng.normal()
        w = float(rng.normal()) * (1.0 if k < 1000 else 0.05)
        wanted = law(t, np.array([y, 0.0, 0.0]), np.array([w, 0.0, 0.0]))
        assert c.sample(t, y, w, q, v, 0.0) == OK
        most, clipped = max(most, abs(c.effort[0] - wanted[0])), clipped + (abs(wanted[0]) == 40.0)
    assert most < (1e-12 if precision == "double" else 1e-4) * 40.0 and 50 < clipped < 1450


def test_c_of_gains_adds_efforts_ahead_within_limits(tmp_path):
    found = limited(False)
    c, plan = Compiled(found, tmp_path), screwgen.plan(model_of(BOOM), [0.0], [0.5], 1.0, gains=found, fast=True)
    law = Played.of(replace(plan, tau_max=found.tau_max))
    assert c.start() == OK
    for k in range(1000):
        t, y, w = k * found.step, 0.01 * np.sin(0.1 * k), 0.1 * np.cos(0.1 * k)
        q, v = law.reference(t)
        wanted = law(t, np.array([y, 0.0, 0.0]), np.array([w, 0.0, 0.0]))
        assert c.sample(5.0 + t, y, w, q, v, plan.mean_torque(t, t + law.step)) == OK
        assert c.effort[0] == pytest.approx(wanted[0], abs=1e-12 * 40.0)


@pytest.mark.parametrize("integral", [False, True])
def test_wild_inputs_of_c_have_a_status_and_no_effort_beyond_its_limit(tmp_path, integral):
    c, rng, time, seen = Compiled(limited(integral), tmp_path), np.random.default_rng(2), 0.0, set()
    assert c.sample(0.0, *np.zeros(5)) == NOT_STARTED and c.start() == OK
    wild = [np.nan, np.inf, -np.inf, 1e300, -1e30, 1e12, 5.0, -3.0, 1e-300]
    for _ in range(2000):
        given = [float(rng.choice(wild)) if rng.random() < 0.05 else float(rng.normal()) for _ in GIVEN]
        jump = float(rng.choice([0.0, -1.0, 5.0, np.nan, 1e11])) if rng.random() < 0.05 else 1e-3
        before = c.memory()
        status = c.sample(time + jump, *given)
        seen.add(status)
        if status == OK:
            time += jump
            assert abs(c.effort[0]) <= 40.0
        else:
            assert c.memory() == before and status in (NONFINITE, CLOCK_JUMPED)
    assert seen == {OK, NONFINITE, CLOCK_JUMPED}
    assert [c.of_nothing(), c.library.boom_law_start(None)] == [BAD_ARGUMENT] * 2


def test_the_command_writes_gains_as_c(tmp_path, capsys):
    (tmp_path / "boom.toml").write_text(to_toml(BOOM))
    asked = ["gains", str(tmp_path / "boom.toml"), "-o", str(tmp_path / "out"), "--integral"]
    assert main([*asked, "--target", "c"]) == 0
    assert str(tmp_path / "out" / "boom_law.c") in capsys.readouterr().out
    wanted = screwgen.gains(model_of(BOOM), [[0.0]], integral=True).c()
    assert {name: (tmp_path / "out" / name).read_text() for name in wanted} == wanted
    assert main([*asked[:3], str(tmp_path / "gains.toml"), "--target", "c"]) == 2
    assert "is no name of a folder, which --target c writes" in capsys.readouterr().err


def test_gains_that_c_cannot_have_are_refused():
    with pytest.raises(UsageError, match="the law holds something else than measured numbers"):
        replace(limited(False), kp=np.array([np.nan])).c()
    with pytest.raises(UsageError, match="the law's robot: "):
        replace(limited(False), robot="*/").c()
