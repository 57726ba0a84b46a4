"""The picture of a run: what it shows, and that nothing on it collides."""

import dataclasses
from functools import cache

import numpy as np
import pytest
from figures import collisions, covered, laid_out, outside
from helpers import ROOT, arm, example, link, model_of

from screwgen import PD, Run
from screwgen.algorithms.entry_names import entry_names
from screwgen.algorithms.robot_functions import BY_NAME
from screwgen.algorithms.signals import Signal
from screwgen.cli.main import main
from screwgen.plotting import curves, plot
from screwgen.plotting.look import canvas
from screwgen.simulation.motion import displacements
from screwgen.simulation.runs import OWN, segments
from screwgen.viewer.view import read_run

SET_POINTS = (-0.4928, 0.6922, 0.4270)
LAW = PD((400.0,) * 3, (28.0,) * 3, SET_POINTS, duration=1.5, tau_max=(90.0, 60.0, 30.0))


def swing(model, samples=200, size=1.0, spike=0.0) -> Run:
    """A made-up run of any arm: every joint and mode swings; `spike` N on every joint at the first step."""
    n, m, r = model.n_links, model.n_joints, model.nq - model.n_joints
    t = np.linspace(0.0, 2.0, samples)
    wave = np.sin(np.outer(t, 2 + np.arange(model.nq)))
    q = size * wave * np.r_[np.full(m, 0.6), np.full(r, 0.01)]
    wrench = size * 30 * np.repeat(wave[:, :1, None], 6 * n, axis=1).reshape(samples, n, 6)
    wrench[min(1, samples - 1), :, 3] += spike
    rows = np.linspace(0, samples - 1, min(samples, 21)).round().astype(int)
    tips = np.array([model.numpy().tip_poses(x)[1][-1] for x in q[rows]])
    path = np.array([np.interp(t, t[rows], x) for x in tips.T]).T
    energy = size * np.column_stack([wave[:, 0] ** 2, 1 - wave[:, 0]])
    arrays = dict(zip(OWN, (t, q, 0 * q, 50 * q[:, :m], wrench, path), strict=True))
    names = {f"{kind}_names": tuple(getattr(model, f"{kind}_names")) for kind in ("q", "v", "tau", "wrench")}
    return Run(model.robot.name, **arrays, **names, energy=energy)


def chain(count: int):
    soft = {"modes": {"bending_y": 2, "torsion": 1}, "section": {"GJ": 50.0, "rhoIp": 1e-3}}
    return model_of(arm(*(link(f"a_link_with_a_name_{i}", 0.4, "y", **soft) for i in range(count))))


MODELS = {
    "ella": lambda: example("ella"),
    "rigid": lambda: model_of(arm(link("rod", axes="z"))),
    "eight": lambda: chain(8),
    "nine": lambda: chain(9),
}


@cache
def picture(name: str):
    """The figure of a swing that begins with a spike; ELLA's under a controller."""
    model = MODELS[name]()
    return laid_out(plot.figure(swing(model, spike=1e6), model, LAW if name == "ella" else None))


def panel(figure, title: str):
    return next(axes for axes in figure.axes if axes.get_title(loc="left") == title)


@pytest.mark.parametrize("name", MODELS)
def test_nothing_collides_and_every_quantity_has_a_unit(name):
    figure = picture(name)
    assert not collisions(figure) and not covered(figure) and not outside(figure)
    over_time = [axes for axes in figure.axes if axes.get_title(loc="left")]
    assert len(over_time) >= 5 and all(" (" in axes.get_ylabel() for axes in over_time)
    assert all(axes.get_xlabel() == "t (s)" for axes in over_time)


def test_the_checks_see_what_collides():
    figure = canvas(4, 3, "a title")
    axes = figure.add_subplot()
    axes.plot([0, 1], label="a curve")
    axes.legend()
    axes.text(0.5, 0.5, "one")
    axes.text(0.5, 0.5, "other")
    axes.text(2.0, 0.5, "far").set_in_layout(False)
    laid_out(figure)
    assert collisions(figure) == [("one", "other")] and outside(figure) == ["far"] and covered(figure) == [""]


def test_a_spike_leaves_the_forces_readable():
    forces = panel(picture("ella"), "Joint forces in x")
    shown = [np.ptp(line.get_ydata()[20:]) for line in forces.lines]
    assert max(shown) > 0.5 * np.ptp(forces.get_ylim())
    assert [text.get_text()[:24] for text in forces.texts] == ["start off scale: 1·10⁶ N"]


def test_the_arm_is_large_and_bends():
    figure, model = picture("ella"), example("ella")
    run = swing(model)
    space = next(axes for axes in figure.axes if axes.name == "3d")
    assert space.get_window_extent().height > 4.0 * figure.dpi
    lines = [np.array(line.get_data_3d()).T for line in space.lines]
    drawn = [line for line in lines if len(line) == plot.STATIONS.size + 1]
    assert len(drawn) == plot.POSTURES * model.n_links and np.allclose(drawn[-1][-1], run.tip_position[-1])
    last = drawn[-model.n_links :]
    chord = last[0][-1] - last[0][0]
    assert np.linalg.norm(np.cross(last[0] - last[0][0], chord), axis=1).max() > 1e-3 * chord @ chord


def test_set_points_and_limits_are_drawn_where_the_controller_states_them():
    told, run = picture("ella"), swing(example("ella"))
    silent = plot.figure(run, None, lambda t, q, v: np.zeros(3))
    angles, torques = ([panel(f, title).lines for f in (told, silent)] for title in ("Joint angles", "Joint torques"))
    assert [len(lines) for lines in angles] == [6, 3] and [len(lines) for lines in torques] == [9, 3]
    goals = [line.get_ydata() for line in angles[0] if line.get_alpha() is not None]
    assert np.allclose([goal[-1] for goal in goals], SET_POINTS)
    assert np.allclose([goal[0] for goal in goals], run.q[0, :3])
    styles = [[x.get_linestyle() for x in angles[0] if (x.get_alpha() is None) == own] for own in (True, False)]
    assert styles[0][:3] == styles[1] and len(set(styles[1])) == 2, "a band of set points has the dashes of its axis"
    heights = {line.get_ydata()[0] for line in torques[0] if len(line.get_xdata()) == 2}
    assert heights == {90, -90, 60, -60, 30, -30}
    words = [{text.get_text() for text in key(figure).get_texts()} for figure in (told, silent)]
    assert {"set point", "torque limit"} <= words[0] and not {"set point", "torque limit"} & words[1]


def key(figure):
    """The legend for all panels."""
    return next(axes.get_legend() for axes in figure.axes if axes.get_legend() and not axes.get_title(loc="left"))


def test_what_is_zero_is_said_and_runs_of_one_step_are_drawn():
    model = example("ella")
    figure = laid_out(plot.figure(swing(model, samples=2, size=0.0), model))
    assert "zero throughout: joint angles, joint torques" in figure.get_supxlabel()
    assert not collisions(figure) and not outside(figure)
    drawn = [axes for axes in figure.axes if axes.get_title(loc="left")]
    assert drawn and all(max(np.abs(line.get_ydata()).max() for line in axes.lines) > 0 for axes in drawn)


def test_colors_of_the_key_are_those_of_the_curves():
    figure, names = picture("eight"), [f"a_link_with_a_name_{i}" for i in range(8)]
    entries = zip(key(figure).get_texts(), key(figure).legend_handles, strict=True)
    colors = {text.get_text(): handle.get_color() for text, handle in entries}
    for axes in (axes for axes in figure.axes if axes.get_title(loc="left")):
        here = {x.get_text() for x in axes.get_legend().get_texts()}
        named = {line.get_label() for line in axes.lines if not line.get_label().startswith("_")}
        assert here == named and named, "each panel names its curves"
    assert [line.get_color() for line in panel(figure, "Joint forces in x").lines] == [colors[name] for name in names]
    assert len({colors[name] for name in names}) == len(names)


def test_deflections_of_tips_stand_in_place_of_modal_coordinates():
    model = example("ella")
    run = swing(model)
    shown = {panel.title: panel for panel in plot.panels(run, model=model)}
    u = displacements(model, run.q, 1, [1.0])[:, 0]
    for k, axis in ((1, "y"), (2, "z")):
        bent = shown[f"Deflection of tips in {axis}"]
        assert [line.label for line in bent.lines] == ["upper_arm", "forearm"] and bent.unit == "m"
        assert np.allclose(bent.lines[1].values, u[:, k]) and np.abs(u[:, k]).max() > 1e-3
    assert not any("η" in panel.symbol for panel in shown.values())
    assert any("η" in panel.symbol for panel in plot.panels(run) if panel.lines), "all there is"


def test_what_a_function_reports_has_a_panel_by_itself(monkeypatch):
    """Vectors have a curve along each axis, numbers one; quantities of axes are drawn with their links."""
    model = example("ella")
    signals = {"linear": Signal((3,), "kg*m/s", "-", "momentum of the arm"), "mass": Signal((), "kg", "-", "all mass")}
    monkeypatch.setitem(BY_NAME, "momentum", dataclasses.replace(BY_NAME["energy"], results=signals, name="momentum"))
    signals["strain"] = Signal(("NLINKS",), "J", "-", "strain energy of links")
    run = swing(model)
    told = np.random.default_rng(0).normal(size=(len(run.t), 4 + model.n_links))
    run = dataclasses.replace(run, told={"momentum": told})
    drawn = plot.panels(run, model=model)
    shown = {x.title: x for x in drawn}
    assert len(shown) == len(drawn), "nothing is drawn twice"
    moved, heavy, bent = shown["Momentum of the arm"], shown["All mass"], shown["Strain energy of links"]
    assert [(x.label, x.owner) for x in bent.lines] == [("upper_arm", 0), ("forearm", 1)]
    names = entry_names(BY_NAME["momentum"], (), links=segments(run.wrench_names))
    assert names[3:] == ("momentum.mass", "upper_arm.momentum.strain", "forearm.momentum.strain")
    assert (moved.unit, heavy.unit) == ("kg·m/s", "kg") and [x.label for x in moved.lines] == ["x", "y", "z"]
    assert all(np.array_equal(x.values, told[:, k]) for k, x in enumerate([*moved.lines, *heavy.lines, *bent.lines]))
    assert curves.prefixed(1e-5, "kg·m/s") == (1.0, "kg·m/s")
    assert "Power of drives" not in shown, "the run has none of it"


def test_forces_keep_their_signs():
    """A force that passes zero is a smooth curve through it, not a cusp."""
    model = example("ella")
    run = swing(model)
    shown = {panel.title: panel.lines for panel in plot.panels(run, model=model)}
    for k, axis in enumerate("xyz"):
        for what, row in (("forces", 3), ("moments", 0)):
            lines = shown[f"Joint {what} in {axis}"][:2]
            assert all(np.array_equal(x.values, run.wrench[:, i, row + k]) for i, x in enumerate(lines))
            assert min(lines[0].values) < 0 < max(lines[0].values)


def test_axes_of_a_joint_are_named_beside_their_curves():
    legend = panel(picture("ella"), "Joint angles").get_legend()
    assert [text.get_text() for text in legend.get_texts()] == ["upper_arm y", "upper_arm z", "forearm"]
    assert len({handle.get_linestyle() for handle in legend.legend_handles[:2]}) == 2


def test_panels_are_chosen_by_words_of_their_titles(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    run = f"simulate {ROOT / 'examples' / 'ella.toml'} --duration 0.003 --step 1e-3 -o run.npz --quiet".split()
    assert main([*run, "--plot", "run.png", "--panel", "ENERGY", "--panel", "angles"]) == 0
    drawn = plot.figure(read_run("run.npz"), only=["energy", "angles"])
    titles = {axes.get_title(loc="left") for axes in drawn.axes} - {""}
    assert titles == {"Joint angles", "Energy"}
    for wrong, said in (
        (["--plot", "a.png", "--panel", "nonsense"], "panel: no title has 'nonsense'; there are Joint angles, "),
        (["--panel", "energy"], "--panel: is given without --plot"),
    ):
        assert main([*run[:-3], "-o", "a.npz", "--quiet", *wrong]) == 2
        assert capsys.readouterr().err.startswith(f"screwgen: error: {said}")
    assert sorted(x.name for x in tmp_path.iterdir()) == ["run.npz", "run.png"]
