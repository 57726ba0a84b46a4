"""Tendons: threads along links whose tensions are inputs, against their definition."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import package

import screwgen
from screwgen.spec.load import loads

jax = package("jax")
ARM = """
name = "pulled"
gravity = [0.0, 0.0, -9.81]
order = {order}

[[links]]
name = "arm"
length = 0.5
section = {{ rhoA = 1.0, EIy = 5.0, EIz = 4.0, EA = 2e3, GJ = 3.0, rhoIp = 0.001 }}
modes = {{ {modes} }}
{more}
joint = {{ axes = ["z"], damping = [0.1] }}
tendons = [
    {{ name = "left", at = [[0.0, 0.02, 0.01], [0.0, 0.01, 0.0]] }},
    {{ name = "right", from = 0.2, at = [[0.0, -0.02, 0.01], [0.0, 0.01, 0.0]] }},
    {{ name = "slack", actuated = false, at = [[0.0, 0.01, 0.0], [0.0, 0.01, 0.0]] }},
]

[[links]]
name = "fore"
length = 0.4
section = {{ rhoA = 1.0, EIy = 2.0, EIz = 2.5 }}
modes = {{ bending_y = 1 }}
joint = {{ axes = ["y"] }}
tendons = [{{ name = "left", from = 0.1, to = 0.8, at = [[0.0, -0.01, 0.005], [0.0, 0.02, 0.0]] }}]
"""
MODES = "bending_y = 1, bending_z = 1, torsion = 1"
TAU = np.array([0.3, -0.2, 4.0, 2.5])


def pulled(order: str, more: str = "", modes: str = MODES) -> screwgen.Model:
    return screwgen.derive(loads(ARM.format(order=order, more=more, modes=modes), "pulled.toml"))


def state(model: screwgen.Model, size: float = 0.02) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(3)
    return size * rng.normal(size=model.nq), rng.normal(size=model.nv)


def test_the_length_is_that_of_a_thread_through_guides():
    """Guides at 40 sections of a strongly bent rod; what straight pieces between them lack is extrapolated."""
    count = 40
    markers = ", ".join(f'{{ name = "g{k}", at = {k / count} }}' for k in range(1, count))
    model = pulled(
        '"exact"', f"markers = [{markers}]", "bending_y = 3, bending_z = 2, torsion = 1, axial = 1, points = 16"
    )
    q = np.zeros(model.nq)
    q[2:9] = [0.01, 0.2, -0.06, 0.02, 0.12, -0.03, 0.4]
    R, r = model.numpy().marker_pose(q)
    names = [marker.name for marker in model.chain.markers]
    places = [names.index(name) for name in [*(f"arm.g{k}" for k in range(1, count)), "arm.tip"]]
    s = np.arange(1, count + 1) / count
    begins, ends = np.array([0.0, -0.02, 0.01]), np.array([0.0, 0.01, 0.0])
    offsets = begins + np.clip((s - 0.2) / 0.8, 0, None)[:, None] * (ends - begins)
    thread = (r[places] + np.einsum("kij,kj->ki", R[places], offsets))[s >= 0.2]
    fine, coarse = (np.linalg.norm(np.diff(thread[::k], axis=0), axis=1).sum() for k in (1, 2))
    assert model.numpy().tendon_length(q)[1] == pytest.approx((4 * fine - coarse) / 3, rel=2e-5)


def test_runs_show_tensions_and_linear_models_have_them(tmp_path):
    model = pulled('"exact"')
    run = screwgen.simulate(model, 0.05, 1e-3, controller=lambda t, q, v: TAU * np.sin(30 * t))
    assert run.names_of("drive_power")[2:] == ("left.power", "right.power")
    assert run.names_of("tendon_length") == ("left.length", "right.length")
    assert run.tau[:, 2] == pytest.approx(4.0 * np.sin(30 * run.t), abs=0.13)
    from screwgen.plotting.run_panels import panels

    drawn = {panel.title: [line.label for line in panel.lines] for panel in panels(run, model=model)}
    assert drawn["Tensions of tendons"] == drawn["Power of tendons"] == ["left", "right"]
    linear = model.linearise(np.zeros(model.nq))
    assert list(linear.input_names[2:4]) == ["left.tension", "right.tension"]


def test_a_pd_law_leaves_tendons_slack():
    model, law = pulled('"exact"'), screwgen.PD((20.0, 20.0), (1.0, 1.0), (0.3, 0.2), tau_max=(5.0, 5.0))
    runs = [screwgen.simulate(model, 0.02, 1e-4, controller=law, backend=backend) for backend in ("c", "casadi")]
    assert not runs[0].tau[:, 2:].any()
    assert runs[0].q == pytest.approx(runs[1].q, rel=1e-7, abs=1e-9)


def test_pulled_to_a_quarter_of_a_circle():
    text = ARM.format(order='"exact"', more="", modes="bending_y = 3").split('[[links]]\nname = "fore"')[0]
    text = text.replace("-9.81", "0.0").replace(
        "[[0.0, 0.02, 0.01], [0.0, 0.01, 0.0]]", "[[0.0, 0.02, 0.0], [0.0, 0.02, 0.0]]"
    )
    model = screwgen.derive(loads(text.replace('axes = ["z"], damping = [0.1]', "axes = []"), "pulled.toml"))
    rest = screwgen.equilibrium(model, tau=[np.pi / 2 * 4.0 / 0.5 / 0.02, 0.0])
    assert rest.tip_position == pytest.approx([1 / np.pi, 1 / np.pi, 0.0], abs=1e-7)


def test_without_its_modes_a_link_has_no_tendons():
    robot = pulled("1").robot.without("bending_y", "bending_z", "torsion")
    assert not any(link.tendons for link in robot.links)
    assert screwgen.derive(robot).chain.n_tau == 2
