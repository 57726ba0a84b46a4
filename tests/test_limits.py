"""Limits in robot files and runs: names, units, ten kinds of wrong tables, hits, warnings, and lines in plots."""

import numpy as np
import pytest
from bad_robot_files import GOOD, refused
from helpers import arm, link, model_of
from stop_robots import mixed

import screwgen
from screwgen import PD, LimitWarning, UsageError, load, simulate
from screwgen.cli.main import main
from screwgen.elements import STOP
from screwgen.plotting.plot import figure
from screwgen.simulation.hits import lines
from screwgen.spec import dump
from screwgen.spec.parameters import parameters

UPPER = "links[0].joint.limits"
WRONG = [
    ("[ {} ]", UPPER, "has length 1; it must hold one table per axis, 2; an empty one is no limit"),
    ("[ 2.0, {} ]", f"{UPPER}[0]", "is 2.0; it must be a table of lower, upper, stiffness, damping"),
    ("[ [-1.0, 1.0], {} ]", f"{UPPER}[0]", "is an array of 2; it must be a table"),
    ("[ { lower = 1.0, upper = -1.0 }, {} ]", f"{UPPER}[0].lower", "is 1.0; it must be less than upper, -1.0"),
    ("[ { lower = 1.0, upper = 1.0 }, {} ]", f"{UPPER}[0].lower", "is 1.0; it must be less than upper, 1.0"),
    ("[ { stiffness = 1e4 }, {} ]", f"{UPPER}[0].stiffness", "is stated without a limit to act at; state lower"),
    ("[ { upper = 1.0, damping = 5.0 }, {} ]", f"{UPPER}[0].damping", "is stated without stiffness; state both"),
    ("[ { upper = 1.0, stiffness = 0.0 }, {} ]", f"{UPPER}[0].stiffness", "is 0.0; it must be > 0"),
    ("[ { upper = 1.0, stiffness = -2.0 }, {} ]", f"{UPPER}[0].stiffness", "is -2.0; it must be > 0"),
    ("[ { upper = 1.0, stiffness = 1e3, damping = -1 }, {} ]", f"{UPPER}[0].damping", "is -1; it must be >= 0"),
    ('[ { upper = "90 deg" }, {} ]', f"{UPPER}[0].upper", 'is "90 deg"; it must be a number'),
    ("[ { upper = inf }, {} ]", f"{UPPER}[0].upper", "is inf; it must be a finite number"),
    ("[ { lower = -1e9 }, {} ]", f"{UPPER}[0].lower", "it must be from -1e+06 to 1e+06 rad or m"),
    ("[ { max = 1.0 }, {} ]", f"{UPPER}[0].max", "is an unknown key"),
]


@pytest.mark.parametrize(("limits", "where", "fragment"), WRONG)
def test_wrong_limits_are_refused_in_one_line(tmp_path, limits, where, fragment):
    refused(tmp_path, GOOD.replace("[0.1, 0.2]", f"[0.1, 0.2]\nlimits = {limits}"), where, fragment)


def test_a_single_axis_needs_no_brackets_and_files_are_written_as_read(tmp_path):
    path = tmp_path / "bot.toml"
    table = "{ lower = -1.0, upper = 2.0, stiffness = 1e4, damping = 5.0 }"
    path.write_text(GOOD.replace('axes = ["z"] }', f'axes = ["z"], limits = {table} }}'), "utf-8")
    robot = load(path)
    assert robot.links[1].joint.limits == (screwgen.Limit(lower=-1, upper=2, stiffness=1e4, damping=5),)
    path.write_text(dump(robot), "utf-8")
    assert load(path) == robot
    assert screwgen.derive(robot).chain.limits.tolist()[1:] == [[-np.inf, np.inf], [-1.0, 2.0]]


def test_no_limit_costs_nothing():
    plain, empty = (model_of(arm(link("a", joint=joint))) for joint in ({}, {"limits": [{}]}))
    assert plain.chain.classes == empty.chain.classes and plain.parameter_names == empty.parameter_names


def test_parameters_have_names_units_and_ranges():
    model = mixed()
    of = {x.name: x for x in parameters(model.robot)}
    assert of["cart.joint.limits[0].lower"].unit == "m" and of["cart.joint.limits[0].damping"].unit == "N·s/m"
    assert of["boom.joint.limits[1].stiffness"].unit == "N·m/rad" and of["hand.joint.limits[2].upper"].unit == "rad"
    for given, what in (
        ({"cart.joint.limits[0].stiffness": 0.0}, "must be > 0"),
        ({"cart.joint.limits[0].damping": -1.0}, "must be >= 0"),
        ({"cart.joint.limits[0].lower": 0.5}, r"limits\[0\].lower is 0.5; it must be less than .*upper, 0.3"),
    ):
        with pytest.raises(UsageError, match=what):
            model.numpy(given)


# -------- runs

BOUNCY = {"lower": -0.3, "upper": 0.2, "stiffness": 3000.0}


def shuttle(**table):
    """A cart without weight between two stops."""
    cart = link("cart", axes=[{"slide": "x"}], rhoA=2.0, joint={"limits": [BOUNCY | table]})
    return model_of(arm(cart, gravity=(0, 0, 0)))


@pytest.fixture(scope="module")
def cart():
    return shuttle()


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_hits_are_found_at_every_step_whatever_is_sampled(cart, backend):
    """At 2 m/s to and fro: contacts of half a swing each, the last one still lasting."""
    swing = np.sqrt(3000.0 / cart.numpy().mass_matrix([0.0])[0, 0])
    half = np.pi / swing
    run = simulate(cart, 0.47, 5e-4, v0=[2.0], backend=backend, every=500)
    begins = [0.1, 0.1 + half + 0.25]
    assert [hit.side for hit in run.hits] == ["upper", "lower"] and len(run.t) == 3
    for hit, begin in zip(run.hits, begins, strict=True):
        assert hit.axis == "cart.slide[0]" and hit.stop and abs(hit.begin - begin) < 1e-4
        assert np.isclose(hit.depth, 2.0 / swing, rtol=1e-2) and np.isclose(hit.force, 3000.0 * hit.depth)
    assert abs(run.hits[0].end - 0.1 - half) < 1e-4
    assert str(run.hits[0]).startswith("cart.slide[0] on its upper stop from 0.1")


def test_the_hits_of_c_and_numpy_are_the_same(cart):
    given = dict(v0=[20.0], every=100, parameters={"cart.joint.limits[0].stiffness": 3e4})
    runs = [simulate(cart, 1.2, 1e-3, backend=backend, **given) for backend in ("c", "numpy")]
    assert len(runs[0].hits) > 8
    for a, b in zip(*(run.hits for run in runs), strict=True):
        assert (a.side, a.end is None) == (b.side, b.end is None)
        assert np.allclose([a.begin, a.depth, a.force], [b.begin, b.depth, b.force], rtol=1e-9)
    said = lines(runs[0].hits)
    assert len(said) == 2 and all(" stop 1" in line and "the deepest: " in line for line in said)


def test_more_hits_than_the_c_keeps_at_once(cart):
    """A run of 1,500 contacts on each side."""
    run = simulate(cart, 120.0, 1e-3, v0=[20.0], every=10**6, parameters={"cart.joint.limits[0].stiffness": 1e5})
    sides = [hit.side for hit in run.hits]
    assert len(sides) > 2000 and sides[:4] == ["upper", "lower"] * 2
    assert all(a.end <= b.begin for a, b in zip(run.hits, run.hits[1:], strict=False))


def test_a_range_without_stop_is_watched_and_said():
    model = shuttle()
    bare = model_of(arm(link("cart", axes=[{"slide": "x"}], joint={"limits": [{"upper": 0.2}]}), gravity=(0, 0, 0)))
    assert not bare.chain.acted(STOP) and model.chain.acted(STOP)
    with pytest.warns(
        LimitWarning, match=r"cart.slide\[0\] past its upper limit from 0.1 s to the end: 0.2 m deep; noth"
    ):
        run = simulate(bare, 0.2, 1e-3, v0=[2.0], backend="casadi")
    assert [(hit.stop, hit.force) for hit in run.hits] == [(False, 0.0)]


def test_a_set_point_beyond_a_limit_is_said(cart):
    law = PD((10.0,), (5.0,), (0.25,), duration=0.1)
    with pytest.warns(LimitWarning, match=r"sends cart.slide\[0\] to 0.25 m, past its upper limit 0.2 m; move"):
        simulate(cart, 0.01, 1e-3, controller=law, backend="casadi")


def test_the_command_line_prints_a_line_per_hit(tmp_path, capsys):
    path, state = tmp_path / "cart.toml", tmp_path / "state.json"
    path.write_text(dump(shuttle().robot), "utf-8")
    state.write_text('{"v": [2.0]}', "utf-8")
    main(
        ["simulate", str(path), "--duration", "0.5", "--step", "1e-3", "--state", str(state), "-o", f"{tmp_path}/a.npz"]
    )
    out = capsys.readouterr().out.splitlines()
    assert len(out) == 3 and out[1].startswith("cart.slide[0] on its upper stop from 0.1") and out[1].endswith("N")


def test_figures_draw_the_limits_beside_the_coordinate(cart):
    """Both as lines of their own; without a model there are none."""
    run = simulate(cart, 0.45, 1e-3, v0=[2.0], backend="casadi")
    for model, expected in ((cart, [-0.3, 0.2]), (None, [])):
        axes = next(a for a in figure(run, model).axes if "Slides" in (a.get_title(), a.get_title(loc="left")))
        assert sorted(x.get_ydata()[0] for x in axes.lines if len(x.get_ydata()) == 2) == pytest.approx(expected)
