"""Solving with the inertia by the elimination's own factors: what is parted, its counts, its C."""

import re

import numpy as np
import pytest
from floating_robots import SATELLITE
from helpers import QUICK, equal_links, model_of, relative
from random_robots import random_robot
from step_judges import point
from test_derivatives import MIXED, UNTURNED
from test_tree import FORK

from screwgen.algorithms import inertia_solve
from screwgen.algorithms.schedule import SUMMED
from screwgen.algorithms.signals import is_node
from screwgen.algorithms.structure import passages, specialised_phases
from screwgen.backends.c import inertia_solve as in_c
from screwgen.backends.c.project import CProject
from screwgen.backends.numpy.numeric import EPSILON, function_of
from screwgen.runtime.compiled import Compiled

NAMED = {"mixed": MIXED, "unturned": UNTURNED, "tree": FORK, "floating": SATELLITE, "many modes": equal_links(3, 6)}
DRAWN = {
    "joints": {},
    "trees": {"branching": 0.5, "stations": 0.3},
    "drives": {"drives": 0.8, "armature": 0.7},
    "transmissions": {"drives": 0.8, "cylinders": 0.7, "linkages": 0.4},
    "second order": {"second_order": 0.5, "shear": 0.3},
    "exact rods": {"exact": 0.8, "curved": 0.5, "max_links": 3},
    "slides": {"sliding": 0.5, "max_modes": 3},
}


def drawn(name: str, number: int) -> dict:
    return random_robot(np.random.default_rng([number, *map(ord, name)]), **DRAWN[name])


def solved(model, q, forces):
    """The accelerations (nv, columns) of forces at a posture by the parted phases of all links, on numbers."""
    chain, functions = model.chain, model.numpy()._functions(inertia_solve.SOLVE)
    run = specialised_phases(chain, inertia_solve.SOLVE, None, inertia_solve.ZERO)
    parts = inertia_solve.part(passages(chain, run, inertia_solve.FORCES.values()))
    state = functions._state(list(q), [0.0] * chain.nvz)
    links = [{**constants, **x} for constants, x in zip(functions.constants, state, strict=True)]
    nodes = [{} for _ in functions._nodes(chain)]
    go(chain, parts.fixed, links, nodes)
    found = []
    for force in forces.T:
        own = [link | {n: list(force[at]) for n, at in places(chain, i).items()} for i, link in enumerate(links)]
        go(chain, parts.columns, own, [dict(node) for node in nodes])
        rates = np.zeros(chain.nv)
        for i, link in enumerate(own):
            for name, at in places(chain, i).items():
                rates[at] = link.get(inertia_solve.FORCES[name], rates[at])
        found.append(rates)
    return np.array(found).T


def places(chain, i: int) -> dict[str, slice]:
    """The forces of a link, and where they stand."""
    key, modes, gears = chain.keys[i], chain.nv - chain.n_modes, chain.nv - chain.n_inner
    begin = {"force": (chain.v_offset[i], key.joints), "f_eta": (modes + chain.eta_offset[i], key.modes)}
    begin["force_theta"] = gears + chain.theta_offset[i], len(key.added_axes)
    return {name: slice(first, first + count) for name, (first, count) in begin.items()}


def go(chain, found, links, nodes) -> None:
    """Run passages; only what is wanted is written, and added where several links share a node."""
    for passage in found:
        program, at = passage.program, chain.tree.places(passage.link)

        def there(name: str, link: dict = links[passage.link], at: dict = at) -> tuple[dict, str]:
            where, _, what = name.partition(".")
            return (nodes[at[where]], what) if is_node(where) else (link, name)

        given = {name: there(name)[0][there(name)[1]] for name in program.inputs}
        outputs, guards = function_of(program)(given, EPSILON)
        assert all(guard > 0 for guard in guards)
        for name, values in outputs.items():
            store, what = there(name)
            kept = list(store.get(what, [0.0] * len(values)))
            kept += [0.0] * (len(values) - len(kept))
            for k, value in enumerate(values):
                if (name, k) in passage.wanted:
                    kept[k] = kept[k] + value if passage.adds and name in SUMMED else value
            store[what] = kept


def robots() -> dict[str, dict]:
    return NAMED | {f"{name} {k}": drawn(name, k) for name in DRAWN for k in range(3)}


@pytest.mark.parametrize("name", robots())
def test_what_is_parted_solves_with_the_inertia(name):
    """Of robots of all kinds, against the mass matrix: what is left of the forces is rounding."""
    model = model_of(robots()[name])
    q = point(model)[0]
    forces = np.random.default_rng(3).normal(size=(model.nv, 3))
    M = model.numpy().mass_matrix(q)
    found = solved(model, q, forces)
    assert np.abs(M @ found + forces).max() <= 1e-13 * (np.abs(M) @ np.abs(found)).max()


def linearised(monkeypatch, robot: dict, least: int) -> list[np.ndarray]:
    """Derivatives in C, of accelerations, wrenches and a step, where robots of so many rates are asked for counts."""
    monkeypatch.setattr(in_c, "LEAST", least)
    monkeypatch.setattr(in_c, "GAIN", 1e9)
    model = model_of(robot)
    c = Compiled(model, flags=QUICK, layout="modular", derivatives=True, cache=False)
    given = point(model)
    return [*c.linearise(*given), *c.step_derivatives(*given, 1e-3, "modal_implicit")]


COMPARED = {
    "floating": SATELLITE,
    "chain": equal_links(3, 3),
    "tree": drawn("trees", 1),
    "drives": drawn("drives", 0),
    "transmissions": drawn("transmissions", 1),
}


@pytest.mark.parametrize("name", COMPARED)
def test_c_has_what_dense_factors_find(monkeypatch, name):
    """To 1e-12, or to what rounding leaves of either where the inertia is so ill conditioned."""
    model = model_of(COMPARED[name])
    allowed = max(1e-12, EPSILON * np.linalg.cond(model.numpy().mass_matrix(point(model)[0])))
    dense, sparse = (linearised(monkeypatch, COMPARED[name], least) for least in (10**9, 0))
    for found, reference in zip(sparse, dense, strict=True):
        assert relative(found, reference) <= allowed


def test_the_count_in_the_header():
    """What functions say that a column costs, over all links and columns."""
    chain = model_of(equal_links(24, 3)).chain
    project = CProject(chain, "0", derivatives=True)
    text, header = project.text("derivatives.c"), project.text("derivatives.h")
    cost = {name: int(n) for n, name in re.findall(r": (\d+) operations a column \*/\n\w+_PART void (\w+)\(", text)}
    total = 0
    for way in ("inward", "outward"):
        body = text[text.index(f"solving_{way}(") :]
        body = body[: body.index("\n}\n")]
        classes = list(map(int, re.search(r"CLASS\[\w+\] = \{ (.*) \}", body)[1].split(", ")))
        names = re.findall(r"(columns_\w+)\(", body)
        total += sum(cost[names[k]] for k in classes)
    columns = 2 * chain.nv + chain.n_tau
    assert f"and {columns * total} in the\n * loops of the solver" in header


def test_which_robots_are_solved_so():
    """Long chains; none that is small, and none whose motion is given in part."""
    given = equal_links(24, 3)
    given["links"][3]["joint"]["actuation"] = "motion"
    told = {"long": (equal_links(24, 3), "auto"), "few": (equal_links(4, 3), "modular"), "given": (given, "auto")}
    found = set()
    for name, (robot, layout) in told.items():
        project = CProject(model_of(robot).chain, "0", derivatives=True, layout=layout)
        found |= {name} if "_COLUMNS" in project.text("derivatives.h") else set()
    assert found == {"long"}
