"""Plans as C: compiled without a warning, they give what Python gives, and refuse clocks that no clock should show."""

import ctypes
import subprocess

import numpy as np
import pytest
from conftest import require_tool
from helpers import arm, link
from robot_toml import to_toml

import screwgen
from screwgen import UsageError
from screwgen.cli.main import main

STRICT = "-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror -O2".split()
OK, BEFORE, BAD_ARGUMENT, NONFINITE, NOT_STARTED, BACKWARDS = range(6)
POINTS, JOINTS, TIME = 17, 3, 1.3
NAN, INF = float("nan"), float("inf")


def made_up(**changed):
    """Any numbers at all make a plan; those of float alone are small, one is none."""
    rng = np.random.default_rng(7)
    q, v, a, tau = rng.normal(size=(4, POINTS, JOINTS))
    q[3, 1], tau[5, 2] = 2.0, 1e-60
    names = tuple(f"link{i}.joint[0]" for i in range(JOINTS))
    gains = np.array([60.0, 0.5, 1e-3])
    said = {"robot": "boom", "joints": names, "t": np.linspace(0.0, TIME, POINTS), "q": q, "v": v, "vdot": a}
    said |= {"tau": tau, "kp": gains, "kd": gains / 7, "tau_max": np.full(JOINTS, np.inf)}
    return screwgen.MotionPlan(**(said | changed))


class State(ctypes.Structure):
    _fields_ = [(n, ctypes.c_double) for n in ("begin", "latest", "stop", "ramp", "place", "rate")]
    _fields_ += [("mark", ctypes.c_int)]


class Played:
    """A plan's C, compiled and loaded; its functions return a status, `sample` also what it wrote."""

    def __init__(self, plan, folder, compiler="gcc", precision="double"):
        self.real = ctypes.c_float if precision == "float" else ctypes.c_double
        for name, text in plan.c().items():
            (folder / name).write_text(text)
        defines = ["-DBOOM_REAL_FLOAT"] if precision == "float" else []
        command = [*STRICT, *defines, "-shared", "-fPIC", "-o", "plan.so", "boom_plan.c"]
        done = subprocess.run([require_tool(compiler), *command], cwd=folder, capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, "")
        self.library, self.state = ctypes.CDLL(str(folder / "plan.so")), State()
        self.row = self.real * len(plan.joints)
        self.kp = np.array(self.row.in_dll(self.library, "boom_plan_kp"))
        members = [(n, self.row) for n in ("q", "v", "tau")] + [("ended", ctypes.c_int)]
        self.out = type("Out", (ctypes.Structure,), {"_fields_": members})()
        self._sample = getattr(self.library, f"boom_plan_sample{'_float' * bool(defines)}")

    def start(self, time):
        return self.library.boom_plan_start(ctypes.byref(self.state), ctypes.c_double(time))

    def stop(self, t, ramp):
        return self.library.boom_plan_stop(ctypes.byref(self.state), *map(ctypes.c_double, (t, ramp)))

    def sample(self, t, step=1e-3):
        given = map(ctypes.c_double, (t, step))
        return self._sample(ctypes.byref(self.state), *given, ctypes.byref(self.out))

    def values(self, t, step=1e-3, expected=OK):
        """Coordinates, rates and torques at a time."""
        assert self.sample(t, step) == expected
        return tuple(np.array(getattr(self.out, n), float) for n in ("q", "v", "tau"))

    def memory(self):
        return bytes(self.state), bytes(self.out)


@pytest.fixture(scope="module")
def played(tmp_path_factory):
    return Played(made_up(), tmp_path_factory.mktemp("plan"))


@pytest.mark.parametrize(("compiler", "precision"), [(c, p) for c in ("gcc", "clang") for p in ("double", "float")])
def test_samples_are_those_of_python(tmp_path, compiler, precision):
    """In double to 1e-12, in float to what rounding of the terms of a sum leaves."""
    plan = made_up()
    c = Played(plan, tmp_path, compiler, precision)
    terms, powers = np.abs(plan.coefficients).max(axis=(0, 2)), np.arange(6)
    sizes = np.array([terms.sum(), terms @ powers / plan.t[1], plan.effort.max()])
    most = 1e-12 if precision == "double" else 1e-7 * sizes
    assert c.start(0.0) == OK and np.allclose(c.kp, plan.kp, rtol=1e-7)
    rng = np.random.default_rng(1)
    times = [*np.sort(rng.uniform(0.0, 1.2 * TIME, 300)), TIME * 1.3, 50.0]
    for t, step in zip(times, 10 ** rng.uniform(-3, 0.5, len(times)), strict=True):
        found, wanted = c.values(t, step), (*plan.reference(t), plan.mean_torque(t, t + step))
        assert (np.abs(np.subtract(found, wanted)).max(axis=1) <= most).all()
        assert c.out.ended == (t >= TIME)
    assert c.start(0.0) == OK
    samples = plan.sampled(1e-2)
    for i, t in enumerate(samples.t):
        wanted = samples.q[i], samples.v[i], samples.tau[i]
        assert (np.abs(np.subtract(c.values(t, 1e-2), wanted)).max(axis=1) <= most).all()


def test_mean_torques_of_short_steps_lose_no_digits(played):
    """In C and in Python: torques are linear, so the mean over a short step is that in its middle."""
    plan = made_up()
    played.start(0.0)
    for t, step in ((0.3, 1e-9), (0.5, 1e-12), (0.7, 1e-300), (1.2, 1e-7)):
        wanted = [np.interp(t + step / 2, plan.t, column) for column in plan.tau.T]
        assert np.abs(played.values(t, step)[2] - wanted).max() < 1e-14 * POINTS
        assert t + step == t or np.abs(plan.mean_torque(t, t + step) - wanted).max() < 1e-14 * POINTS


def test_a_clock_may_show_any_time_at_the_start(played):
    plan, begin = made_up(), 1.7e9
    assert played.start(begin) == OK
    for t in (-3.0, -1e-4, 0.0, 0.25, 2.0):
        q, v, tau = played.values(begin + t, 0.5, BEFORE if t < 0 else OK)
        elapsed = (begin + t) - begin
        wanted = *plan.reference(elapsed), plan.mean_torque(elapsed, elapsed + 0.5)
        assert np.abs(np.r_[q, v, tau] - np.concatenate(wanted)).max() < 1e-10


def test_what_no_clock_should_show_has_a_status_and_changes_nothing(played):
    played.state = State()
    before = played.memory()
    assert (played.sample(0.0), played.stop(0.0, 1.0)) == (NOT_STARTED, NOT_STARTED)
    assert [played.start(x) for x in (NAN, INF, -INF, 1.1e10)] == [NONFINITE] * 4
    assert played.memory() == before
    assert (played.start(5.0), played.sample(5.5)) == (OK, OK)
    before = played.memory()
    assert [played.sample(x) for x in (NAN, INF, -INF, -1e11)] == [NONFINITE] * 4
    assert [played.sample(6.0, x) for x in (NAN, INF, 1e11)] == [NONFINITE] * 3
    assert [played.sample(6.0, x) for x in (0.0, -1e-3)] == [BAD_ARGUMENT] * 2
    assert [played.sample(x) for x in (np.nextafter(5.5, 0), 5.0, 4.0)] == [BACKWARDS] * 3
    assert [played.stop(*x) for x in ((NAN, 1.0), (6.0, NAN), (6.0, 0.0), (5.4, 1.0))] == [
        NONFINITE,
        NONFINITE,
        BAD_ARGUMENT,
        BACKWARDS,
    ]
    out, state, none = ctypes.byref(played.out), ctypes.byref(played.state), None
    time, step = ctypes.c_double(6.0), ctypes.c_double(1e-3)
    calls = [played.library.boom_plan_sample(none, time, step, out), played.library.boom_plan_start(none, time)]
    calls += [played.library.boom_plan_sample(state, time, step, none), played.library.boom_plan_stop(none, time, step)]
    assert calls == [BAD_ARGUMENT] * 4
    assert played.memory() == before
    assert played.sample(5.5) == OK and played.memory() == before
    assert (played.start(0.0), played.sample(-1.0), played.sample(-2.0), played.sample(0.1)) == (OK, BEFORE, BEFORE, OK)


def test_a_stop_stays_on_the_path_and_ends_at_a_standstill(played):
    plan, begin, ramp = made_up(), 0.4, 0.5
    played.start(0.0)
    assert played.stop(begin, ramp) == OK
    x = np.linspace(0.0, 1.0, 2001)
    rows = [played.values(begin + ramp * s, 1e-9) for s in x]
    q, v, tau = (np.array(column) for column in zip(*rows, strict=True))
    rate = 1 - 3 * x**2 + 2 * x**3
    place = begin + ramp * np.concatenate([[0.0], np.cumsum((rate[1:] + rate[:-1]) / 2 * np.diff(x))])
    on_path, planned = plan.reference(place)
    holding = plan.tau[0] + (plan.tau[-1] - plan.tau[0]) * place[:, None] / TIME
    torque = np.array([np.interp(place, plan.t, column) for column in plan.tau.T]).T
    assert np.abs(q - on_path).max() < 1e-5 and np.abs(v - planned * rate[:, None]).max() < 1e-3
    assert np.abs(tau - holding - (torque - holding) * rate[:, None] ** 2).max() < 1e-5
    assert np.array_equal(v[-1], np.zeros(JOINTS)) and np.abs(place[-1] - begin - ramp / 2) < 1e-6
    before = bytes(played.state)
    assert played.stop(begin + ramp, 9.0) == OK and bytes(played.state) == before
    later = played.values(5.0)
    assert played.out.ended == 1 and np.array_equal(later[0], q[-1]) and np.abs(later[2] - holding[-1]).max() < 1e-6


@pytest.mark.parametrize(("at", "end"), [(-0.1, 0), (1.25, -1), (2.0, -1)])
def test_a_stop_before_the_start_stays_there_and_one_near_the_goal_arrives(played, at, end):
    plan = made_up(v=np.zeros((POINTS, JOINTS)))
    played.start(0.0)
    assert played.stop(at, 2.0) == OK
    q, _, tau = played.values(9.0)
    assert np.abs(q - plan.q[end]).max() < 1e-12 and np.abs(tau - plan.tau[end]).max() < 1e-12
    assert played.out.ended == 1


@pytest.fixture
def task(tmp_path):
    """Files of a robot and of a motion that is found at once."""
    section = {"rhoA": 0.1, "EIy": 40.0, "EIz": 40.0}
    rod = link("rod", axes=["z"], length=1.0, section=section, modes={}, joint={"armature": [0.4]})
    (tmp_path / "boom.toml").write_text(to_toml({**arm(rod), "name": "boom", "gravity": [0.0, 0.0, 0.0]}))
    (tmp_path / "task.toml").write_text("start = [0.0]\ngoal = [1.0]\ntime = 1.0\nintervals = 4\n")
    return ["plan", str(tmp_path / "boom.toml"), str(tmp_path / "task.toml")]


def test_the_command_writes_a_folder(tmp_path, task, capsys):
    folder = tmp_path / "out"
    for _ in range(2):
        assert main([*task, "-o", str(folder), "--target", "c"]) == 0
        listed = capsys.readouterr().out.splitlines()
        assert listed[:-1] == [str(folder / n) for n in ("MANIFEST.sha256", "boom_plan.c", "boom_plan.h")]
    (folder / "mine").write_text("x")
    model = screwgen.derive(screwgen.load(task[1]))
    plan = screwgen.plan(model, [0.0], [1.0], 1.0, intervals=4)
    assert {n: (folder / n).read_text() for n in ("boom_plan.c", "boom_plan.h")} == plan.c()
    c = Played(plan, tmp_path)
    assert c.start(0.0) == OK and abs(c.values(1.0)[0] - 1.0).max() < 1e-9
    for said, given in (
        ("holds 'mine'", [str(folder), "--target", "c"]),
        ("plan.npz: is no name of a folder", [str(tmp_path / "plan.npz"), "--target", "c"]),
        ("--target: there is no 'rust'", [str(tmp_path / "other"), "--target", "rust"]),
    ):
        assert main([*task, "-o", *given]) == 2
        assert said in capsys.readouterr().err
    assert not (tmp_path / "other").exists()


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"robot": "int"}, 'robot: is "int", a C keyword'),
        ({"robot": "a */ b"}, "robot: .* must be a C identifier"),
        ({"joints": ("a", "b", "*/ c")}, "joints: C needs one at least, with names of letters"),
        ({"kp": np.array([1.0, np.nan, 1.0])}, "something else than measured numbers"),
    ],
)
def test_what_is_no_c_is_refused(changed, said):
    with pytest.raises(UsageError, match=said):
        made_up(**changed).c()
