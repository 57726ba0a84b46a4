"""What deriving and generating cost: once per class of links, and seconds."""

import subprocess
import sys

import numpy as np
import pytest
import random_robots as rr
from helpers import ROOT, arm, equal_links, link, model_of

from screwgen import load
from screwgen.algorithms import fused, scope
from screwgen.algorithms import schedule as chain_module
from screwgen.algorithms.linearisation import linearisation
from screwgen.topology.chain import Chain


def derivations(links: int, name: str) -> tuple[int, int]:
    """How many classes a chain's forward dynamics has derived and traced that were not yet known."""
    robot = equal_links(links)
    for table in robot["links"]:
        table["joint"]["axes"] = [[1.0, float(len(name)), 0.5]]  # a class that no other test derives
    before = scope.derived.cache_info().misses, chain_module.trace.cache_info().misses
    model = model_of(robot)
    model.numpy().forward_dynamics(np.zeros(model.nq), np.zeros(model.nq), np.zeros(links), np.zeros((links, 6)))
    after = scope.derived.cache_info().misses, chain_module.trace.cache_info().misses
    return after[0] - before[0], after[1] - before[1]


def test_equal_links_are_derived_once():
    """Two links or forty of one class: the same number of derivations, and none when the class is known."""
    short, long = derivations(2, "short"), derivations(40, "longer")
    assert short == long and short[0] == 1
    assert derivations(7, "short") == (0, 0)


GENERATE = """
import cProfile, io, pstats, sys

counting = cProfile.Profile()
counting.enable()
import screwgen
screwgen.derive(screwgen.load(sys.argv[1])).write(sys.argv[2])
counting.disable()
print(pstats.Stats(counting, stream=io.StringIO()).total_calls)
"""


@pytest.mark.parametrize(("name", "limit"), [("ella", 20e6), pytest.param("arm", 40e6, marks=pytest.mark.long)])
def test_generation_is_quick(tmp_path, name, limit):
    """File to all outputs, imports included: at most so many calls of functions, of ELLA or 32 equal links.

    Seconds depend on the processor and on who else is on it; calls differ by a few in ten thousand. `make bench` has
    the seconds: a million calls take a third of one.
    """
    file = ROOT / "examples" / "ella_paper.toml"
    if name == "arm":
        file = tmp_path / "arm.toml"
        file.write_text(rr.to_toml(equal_links(32)))
    command = [sys.executable, "-c", GENERATE, str(file), str(tmp_path / "out")]
    calls = int(subprocess.run(command, check=True, cwd=ROOT, capture_output=True, text=True).stdout)
    assert calls <= limit, f"{calls:,} calls"
    assert {p.name for p in (tmp_path / "out").iterdir()} >= {"c", "casadi", "latex"}


def test_a_link_class_names_all_that_matters():
    """Robots that differ in numbers alone share a class; robots that differ in structure do not."""
    base = link("a", modes={"bending_y": 1})
    key = lambda **more: model_of(arm(base | more)).chain.keys[0]  # noqa: E731
    assert key() == key(length=2.0) == key(section=base["section"] | {"rhoA": 3.0})
    others = [
        key(frame_at=0.1),
        key(damping={"ratio": 0.1}),
        key(modes={"bending_y": 2}),
        key(modes={"bending_z": 1}),
        key(joint={"axes": ["y"]}),
        key(joint={"axes": ["z"], "armature": [1.0]}),
        key(bodies=[{"at": "tip", "mass": 1}]),
        key(joint={"axes": ["z"], "mount": {"xyz": [0, 0, 1]}}),
        key(modes={"bending_y": 1, "basis": "clamped_free"}),
    ]
    assert len({key(), *others}) == len(others) + 1


@pytest.mark.parametrize("name, dynamics, derivatives", [("ella_paper", 1.33, 1.26), ("ella", 1.73, 1.56)])
def test_operations_of_the_second_order(name, dynamics, derivatives):
    """Forward dynamics and exact derivatives of order 2 over those of order 1; DESIGN says where they go."""
    robot = load(ROOT / "examples" / f"{name}.toml")
    chains = [Chain(robot.model_copy(update={"order": order})) for order in (1, 2)]
    count = lambda make: [make(chain, "constants").operation_count for chain in chains]  # noqa: E731
    for make, most in ((fused.modal_dynamics, dynamics), (linearisation, derivatives)):
        first, second = count(make)
        assert second <= most * first
