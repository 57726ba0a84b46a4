"""Links of equal welded segments: the same numbers as links that are cut by hand, and words that speak of the link."""

import re
import sys
from functools import cache

import numpy as np
import pytest
from helpers import ROOT, arm, link, model_of
from step_judges import point

import screwgen
from screwgen import Robot
from screwgen.algorithms.fused import forward_dynamics
from screwgen.algorithms.gauges import gauges
from screwgen.backends.c.project import CProject
from screwgen.cli.commands import evaluation
from screwgen.plotting import mode_plot, plot
from screwgen.plugins import plugins
from screwgen.simulation import motion
from screwgen.simulation.state import state_of
from screwgen.spec.advice import advice
from screwgen.studies.equilibrium import equilibrium
from screwgen.studies.modes import mode_shapes, natural_frequencies
from screwgen.target_files import latex_files

sys.path.insert(0, str(ROOT / "docs" / "tools"))
import limits

BOOM = link("boom", 2.0, ["z", "y"], 1.0, {"bending_y": 2, "bending_z": 1, "torsion": 1}, section={"EIy": 90.0})
BOOM |= {"bodies": [{"at": "base", "mass": 0.3, "com": [0.1, 0, 0]}, {"at": "tip", "mass": 0.5}]}
JIB = link("jib", 0.7, "y", 0.5)
MEASURED = {"bending_y": 1, "bending_z": 1, "frequencies": {"bending_y": [3.0]}}


def divided(segments: int, **more):
    return model_of(arm(BOOM | {"segments": segments} | more, JIB))


def test_one_segment_is_the_link_itself():
    assert divided(1).chain.keys == model_of(arm(BOOM, JIB)).chain.keys
    assert screwgen.dump(divided(1).robot) == screwgen.dump(model_of(arm(BOOM, JIB)).robot)
    assert "segments = 3" in screwgen.dump(divided(3).robot)


@pytest.mark.parametrize(
    ("links", "robot", "told"),
    [
        ([BOOM], {"section_rotation": False}, "links[0].segments (link boom): is stated with section_rotation = false"),
        ([BOOM, JIB | {"name": "Boom_1"}], {}, 'links[1].name (link Boom_1): is "Boom_1", the name in generated code'),
        (
            [BOOM | {"section": {"rhoA": 1.0, "EIy": 1.0, "GJ": 1.0, "rhoIp": 1.0}, "modes": MEASURED}],
            {},
            "links[0].modes.frequencies.bending_y (link boom): is stated beside segments = 2, but frequencies are",
        ),
    ],
)
def test_what_segments_cannot_be_is_refused(links, robot, told):
    links = [links[0] | {"segments": 2}, *links[1:]]
    with pytest.raises(screwgen.RobotFileError) as refusal:
        Robot(**arm(*links, **robot))
    assert told in str(refusal.value) and "; " in str(refusal.value)


# ------------------------------------------------------------------------------ size


TABLE = re.compile(r"(static )?const \w+ \w+\[[^;]*;")


@cache
def modular(segments: int) -> dict[str, str]:
    project = CProject(divided(segments).chain, "0", layout="modular")
    return {name: text for name, text in project.files().items() if name.startswith("arm")}


def test_modular_code_does_not_grow():
    """As many functions, and as many lines but for tables, names and the calls that prepare each segment."""
    four, other = modular(4), modular(8)
    functions = lambda text: len(re.findall(r"^[\w ]+\**\w+\([^;]*\)\n\{", text, re.MULTILINE))  # noqa: E731
    for name in four:
        assert functions(other[name]) == functions(four[name]), name
    for name in ("arm_links.c", "arm_dae.c", "arm_dynamics.c", "arm_step.c", "arm_posture.c"):
        assert len({TABLE.sub("", files[name]).count("\n") for files in (four, other)}) == 1, name


def test_operations_are_proportional_to_segments():
    counts = {k: forward_dynamics(divided(k).chain, "constants").operation_count for k in (2, 4, 8, 16)}
    each = (counts[8] - counts[4]) / 4
    assert abs((counts[16] - counts[8]) / 8 / each - 1) < 0.01
    assert abs((counts[4] - counts[2]) / 2 / each - 1) < 0.05


def test_the_self_check_allows_for_inertial_forces_that_cancel():
    """In float, of the wrenches of inverse dynamics alone: those of inner links are small beside what they sum."""
    project = CProject(divided(4, modes={"bending_y": 2}).chain, "0")
    assert project.check["tolerance"]["single"] == "1e-04" and 1e-4 < float(project.check["inverse"]["single"]) < 0.1
    assert "error <= WRENCH_TOLERANCE" in project.files()["check.c"]


# ------------------------------------------------------------------------------ what users see


def test_names_speak_of_the_link():
    model = divided(3)
    assert model.tau_names == ["boom.torque[0]", "boom.torque[1]", "jib.torque[0]"]
    assert model.q_names[:4] == ["boom.joint[0]", "boom.joint[1]", "jib.joint[0]", "boom[0].eta.bending_y[0]"]
    assert model.wrench_names[::6] == ["boom.tau_x", "boom[1].tau_x", "boom[2].tau_x", "jib.tau_x"]
    names = model.dae_names
    assert names["x"][7] == "boom[1].qw"
    assert names["z"][::6][:4] == ["boom.tau_x", "boom[0].omega_x_rate", "boom[1].tau_x", "boom[1].omega_x_rate"]
    q = np.zeros(model.nq)
    linear = model.linearise(q, inputs=["boom.w_ext"], outputs=["base_strain", "boom.tau_x"])
    assert linear.output_names[:3] == tuple(f"boom.base_strain.{d}" for d in ("bending_y", "bending_z", "torsion"))
    assert linear.input_names[0] == "boom.w_ext.tau_x" and len(linear.input_names) == 6


def test_a_wrench_on_the_tip_of_a_link_is_one_on_its_last_segment():
    model, load = divided(3), np.array([[1.0, 2, 3, 4, 5, 6], [6.0, 5, 4, 3, 2, 1]])
    given = state_of({"w_ext": load.tolist()}, model)
    assert np.array_equal(given.w_ext[[2, 3]], load) and not given.w_ext[:2].any()
    assert np.array_equal(model.linearise(np.zeros(model.nq), w_ext=load).w_ext, given.w_ext)
    found = evaluation(model, given)
    whole = model.numpy().forward_dynamics(given.q, given.v, given.tau, given.w_ext)[1]
    assert np.allclose(found["wrench"], whole[[0, 3]])
    assert set(found["validity"]["measures"]) == {"boom", "jib"}


def test_the_base_gauge_measures_the_whole_link():
    """Under a tip moment the curvature is M/EI, whatever the number of segments."""
    boom = link("boom", 2.0, [], 1e-6, {"bending_y": 2}, section={"EIz": 50.0})
    for k in (1, 2, 5):
        model = model_of(arm(boom | {"segments": k}, gravity=(0, 0, 0)))
        e = equilibrium(model, w_ext=[[0, 0, 0.5, 0, 0, 0]])
        strain = model.linearise(e.q, w_ext=[[0, 0, 0.5, 0, 0, 0]], outputs=["base_strain"]).y
        assert np.allclose(strain, 0.01, rtol=1e-8)
        (gauge,) = gauges(model.chain)
        assert gauge.link == 0 and np.allclose(gauge.curvatures @ e.q[:2] / 2.0**2, 0.01, rtol=1e-8)
        assert e.wrench.shape == (1, 6) and e.deflections.shape == (1, 3)
        turn = 0.5 / 50 * 2  # a circular arc
        assert abs(e.deflections[0, 1] - (1 - np.cos(turn)) / 0.01) < 2e-5


def test_lines_are_drawn_through_the_segments():
    model, s = divided(4), np.linspace(0, 1, 9)
    q = point(model, 3, 2.0, 2e-3)[0]
    (R, r), tips = model.numpy().link_pose(q), model.numpy().tip_poses(q)[1]
    lines = motion.centrelines(model, q, s)
    assert lines.shape == (2, 9, 3)
    assert np.allclose(lines[0, [0, 2, 4, 6, 8]], [*r[:4], tips[3]])
    moved = motion.displacements(model, q[None], 0, [1.0])[0, 0]
    assert np.allclose(r[0] + R[0] @ (moved + 2.0 * np.eye(3)[0]), tips[3])
    columns = motion.modal_columns(model, 0, "torsion")
    weight = model.chain.keys[0].shapes("torsion").tip_value[0]
    assert len(columns) == 4 and np.allclose(motion.twist(model, q[None], 0, [1.0]), weight * q[columns].sum())


def test_figures_show_links():
    """One curve of a link's tip in place of its segments' modes, one of its joint, and a name in the key."""
    model = divided(3)
    run = screwgen.simulate(model, 0.01, 1e-3)
    shown = {panel.title: panel.lines for panel in plot.panels(run, model=model)}
    assert plot.link_names(run) == ["boom", "jib"]
    assert len(shown["Joint forces in x"]) == 2
    assert len(shown["Deflection of tips in y"]) == len(shown["Deflection of tips in z"]) == 1
    (line,) = shown["Deflection of tips in z"]
    assert np.allclose(line.values, motion.displacements(model, run.q, 0, [1.0])[:, 0, 2]) and line.values.max() > 0
    assert len({panel.title: panel.lines for panel in plot.panels(run)}["Modes, bending in y"]) == 6
    shape = mode_shapes(model).shapes[:, 0]
    assert mode_plot.meaning(model, shape).startswith("bending in y of boom, 100 %")
    assert mode_plot.field(model, np.zeros(model.nq), shape).motion.shape == (2, 25, 3)
    tips = mode_plot.figure(model, np.zeros(model.nq), mode_shapes(model)).axes[0].lines
    assert sum(line.get_marker() == "D" for line in tips) == 2


def test_the_watch_names_link_segment_and_remedy():
    """A beam at five times the bound: the worst segment is named once, and so many more segments."""
    boom = link("boom", 1.0, [], 1e-6, {"bending_z": 2}, section={"EIy": 1.0}, bodies=[{"at": "tip", "mass": 0.15}])
    one, four = (equilibrium_of(boom | {"segments": k}) for k in (1, 4))
    assert one.line().startswith("link 'boom': tip deflection over length") and "segments = 8, stiffen" in one.line()
    assert four.line().startswith("link 'boom', segment boom[0] of 4: ") or four.holds
    stiffer = equilibrium_of(boom | {"segments": 2})
    (bent,) = (finding for finding in stiffer.findings if finding.measure == "deflection")
    assert (bent.link, bent.segment, bent.count) == ("boom", "boom[0]", 2)
    assert "link 'boom', segment boom[0] of 2: " in bent.text()
    assert re.search(r"segments = \d+ \(it has 2\)", bent.remedy())
    assert list(stiffer.by_link()) == ["boom"] and len(stiffer.values) == 2
    assert equilibrium_of(boom | {"segments": one.findings[0].segments}).holds


def equilibrium_of(boom: dict):
    with pytest.warns() if boom["segments"] < 4 else np.errstate():
        return equilibrium(model_of(arm(boom))).validity


def test_frequencies_tend_to_those_of_the_beam():
    """Clamped-free, ω√(ρAl⁴/EI): four segments of two modes."""
    beam = link("beam", 1.0, [], 1.0, {"bending_y": 2}, section={"EIz": 1.0}, segments=4)
    found = 2 * np.pi * natural_frequencies(model_of(arm(beam, gravity=(0, 0, 0))))
    assert np.allclose(found[:3], (3.516015, 22.034492, 61.697214), rtol=(1e-4, 2e-3, 1e-2))


def test_damping_is_that_of_the_segments_and_advice_says_so():
    (line,) = advice(divided(4, damping={"ratio": 0.01}).robot)
    assert line.startswith("boom.damping.ratio: ") and "1/16" in line
    assert not any("damping" in line for line in advice(divided(1, damping={"ratio": 0.01}).robot))


def test_documents_say_what_segments_are_once():
    tex = latex_files(divided(4).robot, plugins())["arm.tex"].decode()
    assert "2 links of 5 segments" in tex and "4 segments" in tex and r"l_{0,i}/4" in tex
    assert tex.count(r"\mathbf{H}^*_i &=") <= 1 and "(72)" in tex


# ------------------------------------------------------------------------------ published numbers


@pytest.mark.parametrize("segments, modes, lag", [(4, 2, -0.605), (8, 2, -0.581), (16, 1, -0.5745)])
def test_a_link_spun_up_deflects_as_published(segments, modes, lag):
    """Ten metres, spun up to 6 rad/s in 15 s, at first order: the largest lag of the tip, m."""
    run = limits.spin_up(segments, 10.0, modes=modes)
    deflection = np.cos(run.q[:, 0]) * run.tip_position[:, 1] - np.sin(run.q[:, 0]) * run.tip_position[:, 0]
    assert abs(deflection.min() - lag) < 1e-3
