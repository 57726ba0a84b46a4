"""Links carried at, and loops joining, places between base and tip: against the oracle, Pinocchio and each other."""

import re
import tomllib

import numpy as np
import pytest
from bad_robot_files import GOOD, refusal, refused
from conftest import swept
from helpers import casadi_forward, model_of
from latex_documents import WHOLE
from mixed_arms import CONDITION, case_of
from mixed_loops import JOINTS, looped
from oracle import part_error
from oracle_robots import relative
from test_loop_derivatives import error, moved

from screwgen import Robot, assemble, dump, equilibrium, simulate
from screwgen.algorithms.fused import forward_dynamics
from screwgen.backends.latex import document as latex
from screwgen.plotting.strands import strands
from screwgen.simulation.motion import centrelines

SECTION = {"rhoA": 1.5, "EIy": 900.0, "EIz": 700.0}


def rod(name: str, axes: list, length=0.7, **more) -> dict:
    more = {"modes": {"bending_y": 1}, **more}
    return {"name": name, "length": length, "section": SECTION, "joint": {"axes": axes}, **more}


def arm(*links: dict, **more):
    return model_of({"name": "arm", "gravity": [0.0, 1.0, -9.81], "links": list(links), **more})


@pytest.fixture(scope="module")
def branched():
    """A trunk that carries two links at a marker, one at its base and one at its tip."""
    return branches()


def branches(*more: dict, **trunk):
    """The same with more links, and what a trunk states besides."""
    trunk = rod("trunk", ["y"], modes={"bending_y": 1, "bending_z": 2}, **trunk)
    trunk |= {"markers": [{"name": "hook", "at": 0.4}]}
    mounted = rod("left", ["z"], parent="trunk", at="hook") | {
        "joint": {"axes": ["z"], "mount": {"xyz": [0.1, 0.0, 0.05]}}
    }
    right, low = rod("right", ["y"], parent="trunk", at={"s": 0.4}), rod("low", ["z"], parent="trunk", at="base")
    return arm(trunk, mounted, right, low, rod("fore", ["y"], parent="trunk"), *more)


@pytest.mark.parametrize("order", [1, 2, "exact"])
def test_derivatives_are_those_of_differences(order):
    """Of 40 digits: links ahead of all points of an exact rod, between them and behind them, wrenches and a tendon."""
    near, far = (rod(name, ["x"], parent="trunk", at={"s": s}) for name, s in (("near", 0.01), ("far", 0.97)))
    model = branches(near, far, order=order, tendons=[{"name": "cord", "at": [[0.0, 0.02, 0.01]] * 2}])
    q, v, tau, w_ext = moved(model, np.zeros(model.nq), seed=5)
    given = q, v, np.append(tau[:-1], 300.0), w_ext
    assert error(model, given, model.numpy().derivatives(*given)) < 1e-11


def test_where_segments_meet_a_link_is_carried_by_a_tip():
    """The boundary of two segments needs no station, and is the tip of the first of two welded halves."""
    whole = rod("boom", ["y"], segments=2), rod("arm", ["z"], parent="boom", at={"s": 0.5})
    halves = rod("boom", ["y"], length=0.35), rod("rest", [], length=0.35), rod("arm", ["z"], parent="boom")
    split, explicit = arm(*whole), arm(*halves)
    assert split.chain.tree.parents == explicit.chain.tree.parents == (-1, 0, 0) and not split.chain.tree.stations
    assert forward_dynamics(split.chain).operation_count <= forward_dynamics(explicit.chain).operation_count
    rng = np.random.default_rng(1)
    q, v, tau = 0.05 * rng.normal(size=split.nq), rng.normal(size=split.nq), rng.normal(size=2)
    ends = [m.numpy().forward_dynamics(q, v, tau, np.zeros((3, 6)))[0] for m in (split, explicit)]
    assert relative(*ends) < 1e-11
    beside = arm(whole[0], whole[1] | {"at": {"s": 0.75}})
    assert beside.chain.keys[1].stations_at == (0.5,) and beside.chain.tree.parents == (-1, 0, 1)


@pytest.mark.parametrize("seed", swept(range(1, 7), 1))
def test_a_loop_at_a_marker_equals_the_oracle(seed):
    rng = np.random.default_rng([902, seed])
    draw = lambda: case_of(*looped(rng, JOINTS[(2 * seed + 2) % len(JOINTS)], 3, s=0.2 + 0.1 * seed))  # noqa: E731
    case = next(case for case in (draw() for _ in range(20)) if case.judge.condition < CONDITION)
    numeric, given = case.model.numpy(), case.given
    assert np.max(np.abs(numeric.gaps(given[0], None)[0])) < 1e-12
    found = [numeric.forward_dynamics(*given), casadi_forward(case.model, *given), numeric.dae_forward_dynamics(*given)]
    if seed == 2:
        found += [case.c("modular").forward_dynamics(*given, form=form) for form in ("joint", "dae")]
    for vdot, wrench in found:
        assert max(case.judge.errors(vdot).values()) <= case.tolerance
        links = case.judge.outer.links  # the judge has other wrenches in the rows of markers
        for part in (np.s_[links, :3], np.s_[links, 3:]):
            assert part_error(case.judge.wrench[part], wrench[part], case.judge.wrench) <= case.tolerance


def linkage(last: str):
    """A linkage whose rocker is hinged to the coupler at a marker; which of the two the file has last."""
    crank = rod("crank", ["y"], length=0.3, modes={})
    coupler = rod("coupler", ["y"], length=0.9, modes={"bending_z": 1}, markers=[{"name": "hook", "at": 0.7}])
    rocker = rod("rocker", ["y"], length=0.6, modes={}, parent="world")
    rocker["joint"] = {"axes": ["y"], "mount": {"xyz": [0.6, 0.0, 0.0]}}
    others = [coupler | {"parent": "crank"}, rocker]
    loop = {"between": ["coupler.hook", "rocker.tip"], "joint": {"axes": ["y"]}}
    return arm(crank, *others[:: 1 if last == "rocker" else -1], loops=[loop], gravity=[0.0, 0.0, -9.81])


def test_the_tip_is_that_of_the_last_link_of_the_file_and_not_a_marker():
    model = linkage("coupler")
    assert model.chain.names == ["crank", "rocker", "coupler", "coupler.hook"] and model.chain.last == 2
    q = assemble(model, [0.3, -2.0, -1.8], hold=["crank.joint[0]"])
    run = simulate(model, 0.01, 1e-3, q0=q)
    slow = simulate(model, 0.01, 1e-3, q0=q, backend="casadi")
    ends = centrelines(model, run.q[-1], [0.0, 0.7, 1.0])
    assert np.allclose(run.q, slow.q, rtol=0, atol=1e-13)
    assert np.allclose(run.tip_position[-1], ends[2, 2], rtol=0, atol=1e-12)
    assert np.allclose(ends[2, 1], ends[1, 2], rtol=0, atol=1e-4)  # the marker is on the rocker's tip
    assert np.allclose(np.array(model.casadi()["tip_pose"](run.q[-1], model.parameter_values)[1])[:, 0], ends[2, 2])
    assert any("coupler.hook.F_x" in name for name in run.wrench_names)


def test_pictures_draw_links_from_the_section_that_carries_them(branched):
    q = np.zeros(branched.nq)
    q[0] = 0.7
    lines = centrelines(branched, q, np.linspace(0, 1, 17))
    starts = [strand[0] for strand in strands(branched, lines)]
    trunk = np.array([np.cos(0.7), 0.0, -np.sin(0.7)]) * 0.7
    assert np.allclose(starts, [np.zeros(3), 0.4 * trunk, 0.4 * trunk, np.zeros(3), trunk], rtol=0, atol=1e-12)


def test_an_equilibrium_carries_the_weight_of_all_branches(branched):
    rest = equilibrium(branched, np.zeros(5), hold=True)
    weight = 1.5 * 0.7 * np.linalg.norm(branched.robot.gravity)
    assert np.linalg.norm(rest.wrench[:, 3:], axis=1) == pytest.approx([5 * weight, *[weight] * 4], rel=1e-12)


@pytest.mark.parametrize(("place", "share"), [("tip", 1.0), ({"s": 0.5}, 0.25), ("base", 0.0)])
def test_a_weight_below_the_tip_buckles_a_column_by_the_square_of_its_height(place, share):
    """P at s l has the buckling load π² EI / 4 (s l)²."""
    column = {**rod("column", [], modes={"bending_y": 1, "bending_z": 1}), "section": {**SECTION, "rhoA": 1e-9}}
    column["joint"] = {"axes": [], "mount": {"rpy": [0.0, -np.pi / 2, 0.0]}}
    weight = {"name": "weight", "joint": {"axes": []}, "bodies": [{"at": "base", "mass": 3.0}], "at": place}
    model = arm(column, weight, gravity=[0.0, 0.0, -10.0])
    q = np.zeros(model.nq)
    found = np.array(model.casadi()["validity"](q, q, [], np.zeros((6, 2)), model.parameter_values))[2, 0]
    whole = 4 * 0.7**2 * 30.0 / (np.pi**2 * 700.0)
    assert found == pytest.approx(share * whole, rel=1e-6, abs=1e-8)


def test_the_header_and_the_document_say_where_links_are_carried(tmp_path):
    trunk = rod("trunk", ["y"], markers=[{"name": "hook", "at": 0.4}])
    left, low = (rod(name, ["z"], parent="trunk", modes={}, at=at) for name, at in (("left", "hook"), ("low", "base")))
    branched = arm(trunk, left, low, rod("fore", ["y"], parent="trunk", modes={}))
    branched.write(tmp_path / "out", targets=("c",), layout="modular")
    header = (tmp_path / "out" / "c" / "arm.h").read_text()
    assert "ARM_LINK_LEFT = 1, /* on trunk at s = 0.4 */" in header and "ARM_LINK_FORE = 3 /* on trunk */" in header
    text = latex.document(branched.robot, (), WHOLE)
    assert r"The link carries others at $s = 0, 0.4$ too." in text and "that section stands for the tip" in text
    base, rest, *_ = text.partition(r"\subsection{Section at $s = 0$}")[2].split(r"\subsection{Section at $s = 0.4$}")
    zeros = re.search(r"Zero at this section: (.*)\.", base)[1]
    assert all(f"${name}$" in zeros for name in (r"\mathbf{r}_T", r"\boldsymbol{\phi}_c", r"\mathbf{b}_{v}"))
    assert r"The identity at this section: $\mathbf{J}_l$, $\mathbf{R}_T$." in base
    assert "at this section:" not in rest and "(-0)" not in text


def test_markers_survive_their_file(branched):
    text = dump(branched.robot)
    assert "at = { s = 0.4 }" in text and 'at = "hook"' in text
    assert Robot.model_validate(tomllib.loads(text)) == branched.robot


ON_UPPER = 'name = "fore"'
MARKERS = 'markers = [{ name = "hook", at = 0.4 }]\nname = "upper"'
WRONG = [
    (ON_UPPER, f'{ON_UPPER}\nat = "hook"', "links[1].at", 'no marker of link \'upper\'; choose "base" or "tip"'),
    (ON_UPPER, f"{ON_UPPER}\nat = 0.4", "links[1].at", 'is 0.4; it must be "tip", "base", a place as { s = 0.4 }'),
    (ON_UPPER, f"{ON_UPPER}\nat = {{ s = 1.2 }}", "links[1].at.s", "is 1.2; it must be from 0 at the base to 1"),
    (ON_UPPER, f'{ON_UPPER}\nat = {{ s = "mid" }}', "links[1].at.s", 'is "mid"; it must be a number'),
    (ON_UPPER, f"{ON_UPPER}\nat = {{ x = 0.3 }}", "links[1].at", 'has the keys "x"; it must be "tip", "base"'),
    (ON_UPPER, f"{ON_UPPER}\nat = {{}}", "links[1].at", "has the keys of no place"),
    (
        ON_UPPER,
        f'{ON_UPPER}\nparent = "world"\nat = "base"',
        "links[1].at",
        "a link on the world, which has no markers",
    ),
    ('name = "upper"', 'name = "upper"\nat = "base"', "links[0].at", "a link on the world, which has no markers"),
    ('name = "upper"', MARKERS.replace("0.4", "-0.1"), "links[0].markers[0].at", "is -0.1; it must be from 0"),
    ('name = "upper"', MARKERS.replace("0.4", "nan"), "links[0].markers[0].at", "must be a finite number"),
    ('name = "upper"', MARKERS.replace("hook", "tip"), "links[0].markers[0].name", 'is "tip", which every link has'),
    ('name = "upper"', MARKERS.replace("hook", "a b"), "links[0].markers[0].name", "must be a C identifier"),
    ('name = "upper"', MARKERS.replace("at = 0.4", "s = 0.4"), "links[0].markers[0].s", "is an unknown key"),
    (
        'name = "upper"',
        MARKERS.replace("]", ', { name = "hook", at = 0.5 }]'),
        "links[0].markers[1].name",
        'is "hook", the name of an earlier one',
    ),
]


@pytest.mark.parametrize(("old", "new", "where", "fragment"), WRONG)
def test_wrong_places_are_refused_in_one_line(tmp_path, old, new, where, fragment):
    refused(tmp_path, GOOD.replace(old, new, 1), where, fragment)


HUB = '[[links]]\nname = "hub"\njoint = { axes = [] }\nbodies = [{ at = "base", mass = 1.0 }]\n'


def test_a_link_without_length_has_base_and_tip_alone(tmp_path):
    path = tmp_path / "bot.toml"
    path.write_text(GOOD + HUB + HUB.replace('"hub"', '"low"\nat = "base"'), encoding="utf-8")
    assert not model_of(tomllib.loads(path.read_text())).chain.tree.stations
    path.write_text(GOOD + HUB + HUB.replace('"hub"', '"low"\nat = { s = 0.4 }'), encoding="utf-8")
    message = refusal(path)
    assert (
        message.startswith("links[3].at") and "is a place along link 'hub', which states no length; choose" in message
    )
    loop = '[[loops]]\nbetween = ["upper.hook", "hub.tip"]\njoint = { axes = ["y"] }\n'
    other = HUB.replace('"hub"', '"upper_hook"')
    path.write_text(GOOD.replace('name = "upper"', MARKERS, 1) + HUB + other + loop, encoding="utf-8")
    assert "the name in generated code of marker upper.hook; choose another name" in refusal(path)
