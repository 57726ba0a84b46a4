"""Simulation: physics against the oracle, orders of the methods, what a run keeps and how it is stored."""

import os
from dataclasses import replace
from functools import cache, partial

import numpy as np
import pytest
import random_robots as rr
from scipy.integrate import solve_ivp

from screwgen import Robot, ScrewgenError, SingularError, UsageError, derive, load
from screwgen.integrators import METHODS
from screwgen.plotting import plot
from screwgen.runtime.compiled import CompiledStepper
from screwgen.simulation.controllers import PD, Holding
from screwgen.simulation.integrate import DivergedError
from screwgen.simulation.runs import ARRAYS
from screwgen.simulation.simulate import FORMS, simulate, time_grid
from screwgen.studies.equilibrium import equilibrium

EXAMPLES = os.path.join(os.path.dirname(__file__), "..", "examples")


@cache
def ella():
    return derive(load(os.path.join(EXAMPLES, "ella_paper.toml")))


def soft_dict(basis="clamped_free") -> dict:
    """Two soft links in space, modes of a few Hz: every method resolves them."""
    links = [
        {"name": name, "length": 0.8, "section": {"rhoA": 1.0, "EIy": 40.0, "EIz": 60.0, "rhoIp": 2e-2},
         "modes": {"basis": basis, "bending_y": 1, "bending_z": 1}, "damping": {"ratio": 0.02},
         "joint": {"axes": axes, "damping": [0.3] * len(axes)}, "bodies": [{"at": "tip", "mass": 1.0}]}
        for name, axes in (("upper", ["y", "z"]), ("fore", ["z"]))
    ]  # fmt: skip
    return {"name": "soft", "gravity": [0.0, 0.0, -9.81], "links": links}


@cache
def soft():
    return derive(Robot.model_validate(soft_dict()))


START = {"q0": [0.3, -0.4, 0.5, 0.01, -0.02, 0.005, 0.01], "v0": [0.5, 0.2, -0.6, 0.0, 0.1, 0.0, 0.0]}


# -------- physics


def test_undamped_swing_keeps_its_energy():
    run = simulate(ella(), 0.2, 1e-4, q0=[0.2, 0.5, -0.8], v0=[0.5, -0.3, 1.0], integrator="rk4")
    total = run.energy.sum(axis=1)
    assert np.ptp(total) < 1e-7 * np.ptp(run.energy[:, 0])


def test_default_method_keeps_energy_at_one_millisecond():
    run = simulate(ella(), 1.0, 1e-3, q0=[0.2, 0.5, -0.8], v0=[0.5, -0.3, 1.0])
    assert np.ptp(run.energy.sum(axis=1)) < 1e-3 * np.ptp(run.energy[:, 0])


def test_modal_implicit_stays_bounded_with_axial_modes_at_one_millisecond():
    run = simulate(ella(), 1.0, 1e-3, integrator="modal_implicit")
    total = run.energy.sum(axis=1)
    assert total.max() < 0.05 * np.ptp(run.energy[:, 0])
    assert np.abs(run.q[:, 3:]).max() < 0.05


@pytest.mark.parametrize("integrator", ["euler", "semi_implicit", "rk4"])
def test_explicit_methods_say_that_axial_modes_are_too_fast(integrator):
    with pytest.raises(DivergedError, match=r"t = 0\.\d+ s: .*modal_midpoint"):
        simulate(ella(), 1.0, 1e-3, integrator=integrator)


@pytest.mark.parametrize("seed", [1, 5])
def test_motion_equals_an_accurate_solution_of_the_oracles_dynamics(seed):
    robot, state, oracle = rr.draw_regular(np.random.default_rng(seed), 2, limit=1e5, soft=1.0, max_modes=1)
    model, nq = derive(Robot.model_validate(robot)), len(state["q"])

    def rate(_, x):
        return np.append(x[nq:], oracle.forward_dynamics(x[:nq], x[nq:], state["tau"], state["w_ext"])[0])

    end = 0.02
    solution = solve_ivp(rate, (0.0, end), [*state["q"], *state["v"]], method="DOP853", rtol=1e-9, atol=1e-11)
    run = simulate(model, end, 2e-5, state["q"], state["v"], state["tau"], state["w_ext"], integrator="rk4")
    error = np.abs(np.append(run.q[-1], run.v[-1]) - solution.y[:, -1])
    assert (error < 1e-6 * np.abs(solution.y).max(axis=1).clip(1.0)).all()
    _, wrench = oracle.forward_dynamics(run.q[-1], run.v[-1], state["tau"], state["w_ext"])
    assert np.allclose(run.wrench[-1], wrench, rtol=1e-7, atol=1e-7 * np.abs(wrench).max())
    assert np.allclose(run.tip_position[-1], oracle.tip_pose(run.q[-1])[1], atol=1e-9)
    assert np.allclose(run.energy[-1], oracle.energy(run.q[-1], run.v[-1]), rtol=1e-9, atol=1e-9)


END = 0.1


@cache
def reference():
    return simulate(soft(), END, END / 1000, integrator="rk4", **START)


@pytest.mark.parametrize(
    ("integrator", "order"),
    [("euler", 1), ("semi_implicit", 1), ("modal_implicit", 1), ("modal_midpoint", 2), ("rk4", 4)],
)
def test_order_of_convergence(integrator, order):
    exact = np.append(reference().q[-1], reference().v[-1])
    counts = {1: (1000, 2000), 2: (200, 400), 4: (40, 80)}[order]
    runs = [simulate(soft(), END, END / count, integrator=integrator, **START) for count in counts]
    errors = [np.linalg.norm(np.append(run.q[-1], run.v[-1]) - exact) for run in runs]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.2)


def test_every_method_has_its_order_tested():
    assert set(METHODS) == {"euler", "semi_implicit", "modal_implicit", "modal_midpoint", "rk4"}


# -------- what is given


def test_time_grid_ends_at_the_duration():
    assert np.allclose(time_grid(0.3, 0.1), [0.0, 0.1, 0.2, 0.3])
    assert np.allclose(time_grid(0.25, 0.1), [0.0, 0.1, 0.2, 0.25])
    assert np.allclose(time_grid(0.05, 0.1), [0.0, 0.05])
    assert len(time_grid(2.0, 1e-3)) == 2001 and time_grid(2.0, 1e-3)[-1] == 2.0


def test_a_shorter_last_step_lands_on_the_same_motion():
    whole = simulate(soft(), 0.05, 1e-3, integrator="rk4", **START)
    ragged = simulate(soft(), 0.05, 1.1e-3, integrator="rk4", **START)
    assert ragged.t[-1] == 0.05 and np.allclose(ragged.q[-1], whole.q[-1], atol=1e-8)


def test_controller_is_asked_once_a_step_and_its_torque_held():
    calls = []

    def controller(t, q, v):
        calls.append(t)
        q[:] = np.nan  # a copy: the run is not disturbed
        return [t, 2 * t, 3 * t]

    run = simulate(soft(), 0.01, 1e-3, controller=controller)
    assert np.array_equal(np.unique(calls), run.t)
    assert np.array_equal(run.tau, np.outer(run.t, [1, 2, 3]))
    assert np.isfinite(run.q).all()


def test_wrenches_may_be_a_function_or_a_constant():
    load_ = np.array([[0.0] * 6, [0.0, 0.0, 0.0, 0.0, 5.0, 0.0]])
    constant = simulate(soft(), 0.02, 1e-3, w_ext=load_)
    assert np.array_equal(constant.q, simulate(soft(), 0.02, 1e-3, w_ext=lambda t, q, v: load_).q)
    assert not np.allclose(constant.q, simulate(soft(), 0.02, 1e-3).q)


def test_parameters_by_name_equal_another_file():
    heavy = soft_dict()
    heavy["links"][1]["bodies"][0]["mass"] = 2.5
    expected = simulate(derive(Robot.model_validate(heavy)), 0.05, 1e-3, **START)
    found = simulate(soft(), 0.05, 1e-3, parameters={"fore.bodies[0].mass": 2.5}, **START)
    assert np.allclose(found.q, expected.q, rtol=1e-12) and np.allclose(found.energy, expected.energy, rtol=1e-12)


def test_progress_reaches_the_end():
    seen = []
    simulate(soft(), 0.3, 1e-3, progress=lambda done, total: seen.append((done, total)))
    assert seen[0] == (0, 300) and seen[-1] == (300, 300) and len(seen) <= 302


BAD = {
    "duration": ({"duration": -1.0}, "duration"),
    "step": ({"step": 0.0}, "step"),
    "too many": ({"step": 1e-12}, "steps"),
    "integrator": ({"integrator": "heun"}, "rk4"),
    "form": ({"form": "lagrange"}, "joint"),
    "q0": ({"q0": [1.0, 2.0]}, "q0 has length 2"),
    "q0 nan": ({"q0": [1.0, 2.0, np.nan]}, "q0"),
    "controller shape": ({"controller": lambda t, q, v: [1.0]}, r"t = 0 s: the controller .*\(3,\)"),
    "controller none": ({"controller": lambda t, q, v: None}, "controller"),
    "controller nan": ({"controller": lambda t, q, v: [np.nan] * 3}, "controller"),
    "w_ext": ({"w_ext": [1.0, 2.0]}, "w_ext"),
    "parameters": ({"parameters": [1.0]}, "parameters: has 1 numbers"),
    "parameter name": ({"parameters": {"fore.colour": 1.0}}, "fore.colour"),
    "memory": ({"duration": 5e7, "step": 1.0}, "GB"),
}


@pytest.mark.parametrize("case", BAD)
def test_arguments_without_sense_are_refused(case):
    arguments, message = BAD[case]
    with pytest.raises(UsageError, match=message) as caught:
        simulate(soft(), **({"duration": 0.01, "step": 1e-3} | arguments))
    assert "\n" not in str(caught.value)


def test_singular_start_names_the_link():
    link = {"name": "wrist", "length": 0.5, "section": {"rhoA": 1.0, "rhoIp": 0.01}, "joint": {"axes": ["x", "z", "x"]}}
    model = derive(Robot.model_validate({"name": "ball", "gravity": [0.0, 0.0, 0.0], "links": [link]}))
    with pytest.raises(SingularError, match=r"t = 0 s: .*wrist"):
        simulate(model, 0.01, 1e-3)


# -------- controllers


def floating() -> Robot:
    robot = soft_dict() | {"gravity": [0.0, 0.0, 0.0]}
    for link in robot["links"]:
        link["damping"] = {"ratio": 0.05}
    return Robot.model_validate(robot)


def test_pd_brings_the_arm_to_its_set_point():
    goal = (0.3, -0.2, 0.4)
    law = PD((40.0, 40.0, 20.0), (15.0, 15.0, 4.0), goal, duration=1.0, tau_max=(9.0, 9.0, 9.0))
    run = simulate(derive(floating()), 4.0, 1e-3, controller=law)
    assert np.abs(run.q[-1, :3] - goal).max() < 0.02
    assert np.abs(run.tau).max() <= 9.0
    assert np.abs(run.tau[0]).max() == 0.0  # a minimum-jerk start asks for nothing


def test_minimum_jerk_reference_starts_and_ends_at_rest():
    law = PD((1.0,), (1.0,), (2.0,), duration=0.5).starting_at([1.0, 9.0])
    for t, place in ((0.0, 1.0), (0.25, 1.5), (0.5, 2.0), (0.9, 2.0)):
        assert law.reference(t)[0] == pytest.approx([place])
    h = 1e-6
    for t in (0.0, 0.1, 0.37, 0.5):
        slope = (law.reference(t + h)[0] - law.reference(max(t - h, 0.0))[0]) / (t + h - max(t - h, 0.0))
        assert law.reference(t)[1] == pytest.approx(slope, abs=1e-4)


def test_way_points_are_reached_at_rest_one_after_the_other():
    points = ((0.5, (1.0, -1.0)), (2.0, (0.2, 0.0)))
    law = PD((1.0, 1.0), (1.0, 1.0), points[-1][1], points[-1][0], waypoints=points).starting_at([0.3, 0.1, 9.0])
    assert law.set_points == ((0.0, (0.3, 0.1)), *points)
    for t, q in (*law.set_points, (9.0, points[-1][1]), (1.25, (0.6, -0.5))):
        assert law.reference(t)[0] == pytest.approx(q)
    h = 1e-6
    for t in (0.1, 0.49, 0.5, 0.51, 1.9, 2.0, 3.0):
        slope = (law.reference(t + h)[0] - law.reference(t - h)[0]) / (2 * h)
        assert law.reference(t)[1] == pytest.approx(slope, abs=1e-4)
    with pytest.raises(UsageError, match="last of the waypoints"):
        PD((1.0, 1.0), (1.0, 1.0), (0.0, 0.0), 2.0, waypoints=points)


def test_torques_that_hold_are_those_of_the_equilibrium():
    """Also beside joint springs; one computation goes down the potential energy, the other solves for the modes."""
    robot = soft_dict()
    robot["links"][1]["joint"]["stiffness"] = [3.0] * len(robot["links"][1]["joint"]["axes"])
    model = derive(Robot.model_validate(robot))
    for q in ([0.0] * 3, [0.3, -0.5, 1.1]):
        assert Holding(model)(q) == pytest.approx(equilibrium(model, q, hold="all").tau, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_gravity_compensation_leaves_no_error_at_rest(backend):
    """PD alone sags under the weight; with the torques that hold the arm it rests at its set point."""
    robot = soft_dict("polynomial")
    for link in robot["links"]:
        link["damping"] = {"ratio": 0.1}
    model, goal = derive(Robot.model_validate(robot)), (0.3, -0.2, 0.4)
    rest = equilibrium(model, goal, hold=True)
    law = PD((40.0, 40.0, 20.0), (15.0, 15.0, 4.0), goal)
    sag, held = (
        np.abs(simulate(model, 0.2, 1e-3, rest.q, controller=x, backend=backend).q[-1, :3] - goal).max()
        for x in (law, replace(law, gravity=Holding(model)))
    )
    assert sag > 1e-2 and held < 1e-9


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tau_max": (-1.0,)}, r"^PD: tau_max\[0\]: is -1.0; it must be > 0"),
        ({"duration": 0.0}, "^PD: duration: is 0.0; it must be > 0"),
        ({"kp": (-1.0,)}, r"^PD: kp\[0\]: .* >= 0"),
        ({"q_des": (float("nan"),)}, r"^PD: q_des\[0\]: .*finite"),
    ],
)
def test_pd_laws_built_in_python_keep_to_the_rules_of_files(options, message):
    with pytest.raises(UsageError, match=message):
        PD(**({"kp": (1.0,), "kd": (1.0,), "q_des": (0.0,)} | options))


def test_pd_of_unequal_lengths_is_refused():
    with pytest.raises(UsageError, match="kd has length 1"):
        PD((1.0, 2.0), (1.0,), (0.0, 0.0))


# -------- storage


def short_run():
    return simulate(soft(), 0.0105, 1e-3, controller=lambda t, q, v: [0.1, 0.2, t], **START)


def test_npz_holds_everything(tmp_path):
    run = short_run()
    run.save(tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as stored:
        for name in ARRAYS:
            assert np.array_equal(stored[name], getattr(run, name))
        assert stored["wrench"].shape == (12, 2, 6)
        assert stored["q_names"].tolist() == soft().q_names
    assert os.listdir(tmp_path) == ["run.npz"]


def test_csv_reads_back_bit_for_bit(tmp_path):
    run = short_run()
    run.save(tmp_path / "run.csv")
    header = (tmp_path / "run.csv").read_text().splitlines()[0].split(",")
    model = soft()
    names = [*model.q_names, *model.v_names, *model.tau_names, *model.wrench_names]
    assert header[: 1 + len(names)] == ["t", *names] and len(set(header)) == len(header)
    assert header[-5:] == ["tip_position.x", "tip_position.y", "tip_position.z", "energy.kinetic", "energy.potential"]
    assert np.array_equal(np.loadtxt(tmp_path / "run.csv", delimiter=",", skiprows=1), run.table)


@pytest.mark.parametrize("suffix", [".npz", ".csv"])
def test_stored_twice_gives_the_same_bytes(tmp_path, suffix):
    for name in ("a", "b"):
        short_run().save(tmp_path / (name + suffix))
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()


def test_saving_replaces_a_whole_file_or_leaves_it_alone(tmp_path, monkeypatch):
    path = tmp_path / "run.csv"
    path.write_text("old")
    run = short_run()
    with monkeypatch.context() as m:
        m.setattr(type(run), "columns", property(lambda self: 1 / 0))
        with pytest.raises(ZeroDivisionError):
            run.save(path)
    assert path.read_text() == "old" and os.listdir(tmp_path) == ["run.csv"]
    run.save(path)
    assert path.read_text().startswith("t,")


def test_saving_follows_a_link_and_refuses_what_is_no_file(tmp_path):
    (tmp_path / "there.csv").write_text("old")
    (tmp_path / "link.csv").symlink_to("there.csv")
    short_run().save(tmp_path / "link.csv")
    assert (tmp_path / "link.csv").is_symlink() and (tmp_path / "there.csv").read_text().startswith("t,")
    (tmp_path / "folder.csv").mkdir()
    os.mkfifo(tmp_path / "pipe.csv")
    for name in ("folder.csv", "pipe.csv", "run.txt", "none/run.csv", "x" * 300 + ".csv"):
        with pytest.raises(ScrewgenError):
            short_run().save(tmp_path / name)


# -------- pictures


def test_figure_names_quantities_and_units():
    labels = [axes.get_ylabel() for axes in plot.figure(short_run()).axes]
    assert labels[:2] == ["q (rad)", "τ (N·m)"]
    assert {"|F| (N)", "|τ| (N·m)", "E (J)", "r (m)"} <= set(labels)
    assert any(label in ("η (m)", "η (mm)") for label in labels)


def test_picture_is_the_same_every_time(tmp_path):
    run = short_run()
    plot.save(run, tmp_path / "run.png")
    picture = (tmp_path / "run.png").read_bytes()
    assert picture == plot.png(run) and picture.startswith(b"\x89PNG")
    assert b"tIME" not in picture and b"Creation" not in picture


def test_long_rigid_and_welded_arms_are_drawn():
    links = [
        {"name": f"link_{i}", "length": 0.2, "section": {"rhoA": 1.0, "rhoIp": 1e-3}, "joint": {"axes": ["y"]}}
        for i in range(12)
    ]
    chain = derive(Robot.model_validate({"name": "chain", "gravity": [0.0, 0.0, -9.81], "links": links}))
    figure = plot.figure(simulate(chain, 0.02, 1e-3))
    assert "link, from base to tip" in [axes.get_ylabel() for axes in figure.axes]
    beam = soft_dict()
    beam["links"] = [beam["links"][0] | {"joint": {"axes": []}}]
    assert plot.png(simulate(derive(Robot.model_validate(beam)), 0.02, 1e-3))


# -------- forms of one's own


def test_a_form_is_an_argument():
    """What makes a stepper stands where a form is named; it has to say which integrator to take, or be told."""
    model = ella()
    form, posture = partial(CompiledStepper, model.compile()), [0.1, 0.2, 0.3]
    run = simulate(model, 0.01, 1e-3, posture, form=form, integrator="modal_midpoint")
    assert np.abs(run.q - simulate(model, 0.01, 1e-3, posture, backend="numpy").q).max() < 1e-12
    with pytest.raises(UsageError, match="this form names no integrator of its own; give one"):
        simulate(model, 0.01, 1e-3, form=form)
    with pytest.raises(UsageError, match="the backend 'c' steps the joint form"):
        simulate(model, 0.01, 1e-3, form=form, integrator="rk4", backend="c")
    with pytest.raises(TypeError):
        FORMS["compiled"] = form
