"""Rest of robots with floating bases: the base stays as given, and nothing moves there."""

import json
from functools import cache

import dual_arm
import numpy as np
import pytest
from floating_robots import SATELLITE, rod, start
from helpers import model_of, rotation_of

from screwgen import NoEquilibriumError, UsageError, dump, equilibrium
from screwgen.cli.main import main

SPRUNG = {"axes": ["y"], "stiffness": [5.0]}


@cache
def satellite(**more):
    """One joint has a spring."""
    links = [dict(part) for part in SATELLITE["links"]]
    links[2] = links[2] | {"joint": SPRUNG}
    return model_of(SATELLITE | {"links": links} | more)


def still(model, rest, w_ext=None) -> float:
    """The largest acceleration of the whole robot, its base included."""
    return np.max(np.abs(model.numpy().forward_dynamics(rest.q, np.zeros(model.nv), rest.tau, w_ext)[0]))


def test_a_robot_afloat_settles_relative_to_its_base():
    model = satellite()
    q, _ = start(model)
    rest = equilibrium(model, q, hold=True)
    assert np.array_equal(rest.q[:7], q[:7]) and rest.stability == "stable" and still(model, rest) < 1e-9
    assert np.array_equal(np.delete(rest.q[7:11], 1), np.delete(q[7:11], 1)) and rest.passive == ("left_fore.joint[0]",)
    assert np.max(np.abs(rest.q[11:])) < 1e-12 and abs(rest.q[8]) < 1e-10 and rest.q_names[0] == "base.x"
    assert np.allclose(rest.tip_position, model.numpy().tip_pose(rest.q)[1], atol=1e-12)


def test_torques_and_loads_in_balance_bend_it():
    """A spring under a torque; two hands that press the same object away from the hull along its x axis."""
    model = satellite()
    q = start(model)[0]
    rest = equilibrium(model, q, tau=[0.0, 0.3, 0.0, 0.0])
    assert rest.q[8] == pytest.approx(0.06, abs=1e-12) and still(model, rest) < 1e-9
    hull, boom = SATELLITE["links"][0], rod("boom", [])
    pair = model_of(SATELLITE | {"links": [hull, boom, rod("mast", [], parent="hull")]})
    push = np.array([[0.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 2.0, 0.0, 0.0, 0.0, 0.0], [0.0, -2.0, 0.0, 0.0, 0.0, 0.0]])
    rest = equilibrium(pair, w_ext=push)
    assert still(pair, rest, push) < 1e-8 and np.max(np.abs(rest.q[7:])) > 1e-4 and not rest.wrench[0].any()
    with pytest.raises(NoEquilibriumError, match=r"^robot 'satellite': the wrenches on its tips leave 2 N·m on the"):
        equilibrium(pair, w_ext=push * [[0.0], [1.0], [0.0]])


def test_a_rope_to_the_world_is_named_where_it_pulls_the_base():
    rope = {"name": "rope", "between": [{"world": [0.0, 0.0, 9.0]}, "boom.tip"], "line": {"stiffness": 2.0}}
    tied = model_of(SATELLITE | {"links": [SATELLITE["links"][0], rod("boom", [])], "forces": [rope]})
    said = (
        "the wrenches on its tips and forces between it and the world leave .* N on the floating base; let them balance"
    )
    with pytest.raises(NoEquilibriumError, match=said):
        equilibrium(tied)


@pytest.mark.parametrize("anchor, height, taut", [(9.0, 6.0, False), (3.0, -6.0, True)])
def test_a_rope_pulls_where_the_base_floats_not_where_it_would_be_fixed(anchor, height, taut):
    """A slack one leaves the boom as it is; one that is taut at this pose is refused, though it hangs at the origin."""
    line = {"stiffness": 2.0, "rest": 5.0, "slack": True}
    rope = {"name": "rope", "between": [{"world": [0.0, 0.0, anchor]}, "boom.tip"], "line": line}
    model = model_of(SATELLITE | {"links": [SATELLITE["links"][0], rod("boom", [])], "forces": [rope]})
    q = np.array(model.chain.home)
    q[2] = height  # position before quaternion
    if taut:
        with pytest.raises(NoEquilibriumError, match="forces between it and the world leave"):
            equilibrium(model, q)
        return
    rest = equilibrium(model, q)
    assert np.array_equal(rest.q, q) and rest.tip_position[2] == pytest.approx(height, abs=1e-9)


@pytest.mark.long
def test_a_loop_on_a_floating_base():
    """With elastic gears: held joints, and what follows the loop."""
    model = model_of(dual_arm.dual_arm())
    q = dual_arm.start(model)[0]
    rest = equilibrium(model, q, hold=True)
    assert np.max(np.abs(model.numpy().gaps(rest.q, None)[0])) < 1e-12 and still(model, rest) < 1e-8
    assert np.array_equal(rest.q[:7], q[:7])


def test_weight_is_refused_in_one_line(tmp_path, capsys):
    heavy = satellite(gravity=(0.0, 0.0, -9.81))
    said = "robot 'satellite' has a floating base, which nothing holds against gravity; set gravity = [0.0, 0.0, 0.0]"
    with pytest.raises(NoEquilibriumError, match=rf"^{said.replace('[', '.').replace(']', '.')}, or fix the base"):
        equilibrium(heavy)
    with pytest.raises(UsageError, match="q: has 16 numbers"):
        equilibrium(satellite(), np.zeros(16))
    robot, bad = tmp_path / "satellite.toml", tmp_path / "heavy.toml"
    robot.write_text(dump(satellite().robot))
    bad.write_text(dump(heavy.robot))
    state = tmp_path / "state.json"
    state.write_text(json.dumps({"q": start(satellite())[0].tolist()}))
    assert main(["equilibrium", str(robot), "--state", str(state), "--hold", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert len(found["q"]) == 17 and found["stability"] == "stable"
    assert main(["equilibrium", str(robot), "--q", "0.1,0.2,0.3,0.4", "--hold"]) == 0
    text = capsys.readouterr().out
    assert "left.joint[0]                       0.1 rad" in text and "on its spring" in text
    assert main(["equilibrium", str(bad)]) == 2
    assert capsys.readouterr().err.splitlines()[-1] == f"screwgen: error: {said}, or fix the base to find its posture"


def test_poses_are_kept_wherever_they_are():
    """Two bases that differ by a motion rest alike, tips moved along."""
    model = satellite()
    q = start(model)[0]
    home = np.append([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], q[7:])
    there, here = (equilibrium(model, x, tau=[0.0, 0.3, 0.0, 0.0]) for x in (q, home))
    assert np.allclose(there.tip_position, q[:3] + rotation_of(q[3:7]) @ here.tip_position, atol=1e-12)
