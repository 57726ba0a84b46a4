"""Arms at rest of which some joints are held, and whose tendons are pulled meanwhile."""

from __future__ import annotations

import json

import numpy as np
import pytest
import test_loops
from floating_robots import SATELLITE
from helpers import G, arm, example, link, model_of

from screwgen import UsageError, dump, equilibrium
from screwgen.cli.main import main

four_bar = test_loops.four_bar

BOOM = arm(link("mast", 0.5, "z"), link("boom", 1.0, "y"), link("load", 0.7, "y"))
"""A mast that turns about the vertical, a boom of 1 kg, and a load of 1 kg that hangs from its tip."""


def finger(**joint):
    """A bar of EI = 1e-3 N·m² and 0.1 m with a thread 6 mm beside its centreline, without gravity."""
    thread = {"name": "t", "at": [[0.0, 0.006, 0.0], [0.0, 0.006, 0.0]]}
    bar = link("a", 0.1, "z", rhoA=0.1, modes={"bending_y": 3}, section={"EIy": 1e-3, "EIz": 1e-3})
    return arm(bar | {"tendons": [thread], "joint": bar["joint"] | joint}, gravity=(0, 0, 0))


@pytest.mark.parametrize("asked", [{"hold": ["mast", "boom.joint[0]"]}, {"free": ["load"]}])
def test_a_load_hangs_from_a_boom_that_is_held(asked):
    """Held level, with the load vertical below its tip: both weights at their levers."""
    e = equilibrium(model_of(BOOM), [0.3, 0.0, 0.2], **asked)
    assert e.held and e.held_joints == ("mast.joint[0]", "boom.joint[0]") and e.stability == "stable"
    assert np.allclose(e.q, [0.3, 0.0, np.pi / 2], atol=1e-12)
    assert np.allclose(e.tau, [0.0, -G * (0.5 + 0.7), 0.0], atol=1e-10)


def test_named_axes_are_held_in_spite_of_their_springs():
    model = model_of(arm(link("base", axes="y"), link("flap", axes="y", joint={"stiffness": [30.0]})))
    named = equilibrium(model, [0.0, 0.0], hold=["flap"], tau=[-G, 0.0])
    assert named.held_joints == ("flap.joint[0]",) and named.q[1] == 0.0 and named.passive == ()
    assert equilibrium(model, free=["flap"]).held_joints == ("base.joint[0]",)


@pytest.mark.parametrize("hold", [True, ["a"]])
def test_tensions_stay_as_given_where_joints_are_held(hold):
    """The thread bends the bar by the moment T d, which the joint does not feel: `T d l²/2EI`."""
    for tau in ([2.0], [0.0, 2.0]):
        e = equilibrium(model_of(finger()), hold=hold, tau=tau)
        assert np.allclose(e.tau, [0.0, 2.0], atol=1e-15) and e.q[0] == 0.0
        assert np.allclose(e.deflections, [[0, 2.0 * 0.006 * 0.1**2 / 2e-3, 0]], rtol=1e-12, atol=1e-15)


def test_tensions_alone_are_taken_where_no_joint_needs_holding():
    e = equilibrium(model_of(finger(stiffness=[1.0])), hold=True, tau=[2.0])
    assert e.held and e.held_joints == () and e.passive == ("a.joint[0]",) and e.tau.tolist() == [0.0, 2.0]


def test_loops_follow_the_joints_that_are_named(four_bar):
    """A four-bar linkage leaves one joint to state: any of its joints, where it is named."""
    model = four_bar
    every = equilibrium(model, test_loops.angles(0.7), hold=True)
    for k, name in enumerate(model.q_names[: model.n_joints]):
        e = equilibrium(model, every.q, hold=[name])
        assert e.held_joints == (name,) and e.q[k] == every.q[k] and np.allclose(e.q, every.q, atol=1e-9)
        assert np.flatnonzero(np.abs(e.tau) > 1e-9).tolist() in ([k], [])
    with pytest.raises(UsageError, match="follows the loops while the others are held; leave it out, or one of them"):
        equilibrium(model, every.q, hold=model.q_names[: model.n_joints])


def said(capsys, *arguments: str) -> tuple[str, str]:
    assert main(["equilibrium", *arguments]) == 0
    return capsys.readouterr()


def test_commands_hold_some_joints_and_pull_tendons(capsys, tmp_path):
    (tmp_path / "boom.toml").write_text(dump(model_of(BOOM).robot))
    (tmp_path / "finger.toml").write_text(dump(model_of(finger()).robot))
    boom, bar = str(tmp_path / "boom.toml"), str(tmp_path / "finger.toml")
    out = said(capsys, boom, "--q", "0.3,0,0.2", "--hold-only", "mast", "--hold-only", "boom")[0]
    assert "  boom.joint[0]                         0 rad, held\n" in out and "rad, held\n\ntorques\n" not in out
    assert out == said(capsys, boom, "--q", "0.3,0,0.2", "--free", "load")[0]
    found = json.loads(said(capsys, boom, "--q", "0.3,0,0.2", "--free", "load", "--json")[0])
    assert found["held"] and found["held_joints"] == ["mast.joint[0]", "boom.joint[0]"]
    pulled = [said(capsys, bar, "--hold", *more)[0] for more in (["--tensions", "0.2"], ["--tau", "0,0.2"])]
    assert pulled[0] == pulled[1] and "t.tension                           0.2 N\n" in pulled[0]
    assert said(capsys, bar, "--hold", "--tau", "0")[0] == said(capsys, bar, "--hold")[0]


def test_a_state_with_rates_and_torques_is_read(capsys, tmp_path):
    """What rest has none of, or finds, is left out with a note; tensions stay."""
    (tmp_path / "finger.toml").write_text(dump(model_of(finger()).robot))
    path = tmp_path / "state.json"
    path.write_text(json.dumps({"q": [0.1], "v": [1.0], "tau": [3.0, 0.2]}))
    out, notes = said(capsys, str(tmp_path / "finger.toml"), "--state", str(path), "--hold", "--json")
    assert json.loads(out)["tau"] == [0.0, 0.2]
    assert notes.splitlines() == [
        f"screwgen: note: {path}: v: is left out; an arm at rest has none",
        f"screwgen: note: {path}: tau: torques of held joints follow, those given are left out",
    ]


def test_degrees_are_suspected(capsys, tmp_path):
    """An angle of more than two turns gets a note; it is taken as it stands."""
    (tmp_path / "boom.toml").write_text(dump(model_of(BOOM).robot))
    out, notes = said(capsys, str(tmp_path / "boom.toml"), "--q", "30,0.2,0.1", "--hold-all", "--json")
    assert json.loads(out)["q"][0] == 30.0
    assert notes == "screwgen: note: --q: mast.joint[0] is 30 rad, 4.77 turns; 30 degrees are 0.5236\n"


def test_floating_bases_take_names_too():
    model = model_of(SATELLITE | {"gravity": [0.0, 0.0, 0.0]})
    e = equilibrium(model, hold=["left"])
    assert e.held_joints == ("left.joint[0]",)
    assert equilibrium(example("ella"), hold=[]).held_joints == ()
