"""Runs as they are stored and drawn."""

import os

import numpy as np
import pytest
from helpers import model_of
from test_simulate import START, soft, soft_dict

from screwgen import ScrewgenError
from screwgen.plotting import plot
from screwgen.simulation.simulate import simulate

# -------- storage


def short_run():
    return simulate(soft(), 0.0105, 1e-3, controller=lambda t, q, v: [0.1, 0.2, t], **START)


def test_npz_holds_everything(tmp_path):
    run = short_run()
    run.save(tmp_path / "run.npz")
    with np.load(tmp_path / "run.npz") as stored:
        for name, values in run.arrays.items():
            assert np.array_equal(stored[name], values)
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
    told = [f"tip_position.{axis}" for axis in "xyz"] + ["energy.kinetic", "energy.potential"]
    assert header[1 + len(names) :] == [*told, *(name.replace(".torque[", ".power[") for name in model.tau_names)]
    assert np.array_equal(np.loadtxt(tmp_path / "run.csv", delimiter=",", skiprows=1), run.table)


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
    assert {"$F_x$ (N)", "$M_z$ (N·m)", "E (J)", "r (m)"} <= set(labels)
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
    chain = model_of({"name": "chain", "gravity": [0.0, 0.0, -9.81], "links": links})
    figure = plot.figure(simulate(chain, 0.02, 1e-3))
    assert "link, from base to tip" in [axes.get_ylabel() for axes in figure.axes]
    beam = soft_dict()
    beam["links"] = [beam["links"][0] | {"joint": {"axes": []}}]
    assert plot.png(simulate(model_of(beam), 0.02, 1e-3))
