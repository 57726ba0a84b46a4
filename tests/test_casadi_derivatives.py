"""What MPC needs of the CasADi functions: Jacobians, Hessians, their patterns, map, and files that stand alone."""

import json
import re
import subprocess
import sys
from functools import cache
from itertools import pairwise
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from conftest import swept
from helpers import EPS, arm, drawn, example, flat, link, model_of, relative

from screwgen.backends.casadi.functions import as_function

RIGID = arm(link("a", axes="zy"), link("b", axes="y"))
ROBOTS = ("ella", "drawn", "rigid")
NOT_SMOOTH = {"scaling", "validity"}
"""Constants; measures with absolute values and the larger of two."""
ALL = tuple(example("ella").casadi())
WRITTEN = tuple(name for name in ALL if not name.startswith("step_"))
"""Of the discrete steps one is written to files; the others are the same lines."""
NAMES = tuple(name for name in WRITTEN if name not in NOT_SMOOTH)


@cache
def robot(name: str):
    if name == "drawn":
        return drawn(8, 2).model
    return model_of(RIGID) if name == "rigid" else example(name)


@cache
def saved(model, name: str) -> ca.Function:
    return as_function(name, model.casadi()[name])


def values(model, name: str, seed=0) -> list[np.ndarray]:
    """A value of every input of a function: a state of the robot, small deflections, everything else random."""
    rng, f, functions = np.random.default_rng(seed), saved(model, name), model.casadi()
    m, p = model.n_joints, np.array(model.parameter_values)
    small = np.where(np.arange(model.nq) < m, 1.0, 0.01)
    q, v = rng.normal(size=model.nq) * small, rng.normal(size=model.nq) * np.sqrt(small)
    known = {"q": q, "v": v, "p": p}
    if "x_c" in f.name_in():
        known |= {"q": q[:m], "x_c": flat(functions["cauchy_state"](q, v, p))}
    elif "x" in f.name_in():
        known |= {"x": np.r_[q, v] if name == "ode" else flat(functions["dae_state"](q, v, p))}
    given = [known.get(key, rng.normal(size=f.numel_in(key))) for key in f.name_in()]
    return [np.reshape(x, f.size_in(i), order="F") for i, x in enumerate(given)]


def stacked(f: ca.Function) -> ca.Function:
    """All inputs in one column, all outputs in one column."""
    x = ca.SX.sym("x", sum(f.numel_in(i) for i in range(f.n_in())))
    bounds = np.cumsum([0, *(f.numel_in(i) for i in range(f.n_in()))]).tolist()
    parts = [ca.reshape(x[a:b], *f.size_in(i)) for i, (a, b) in enumerate(pairwise(bounds))]
    return ca.Function("stacked", [x], [ca.densify(ca.vertcat(*map(ca.vec, f.call(parts))))])


def column(given: list[np.ndarray]) -> np.ndarray:
    return np.concatenate([x.ravel(order="F") for x in given])


def steps(f: ca.Function, given: list[np.ndarray]) -> np.ndarray:
    """Lengths for differences: a thousandth, of parameters relative to their size."""
    sizes = [np.where(x == 0, 1.0, np.abs(x)) if f.name_in(i) == "p" else np.ones_like(x) for i, x in enumerate(given)]
    return 1e-3 * column(sizes)


def richardson(f, x: np.ndarray, h: np.ndarray) -> np.ndarray:
    """The Jacobian by central differences, extrapolated twice; all points in one call."""
    E = np.diag(h)
    points = np.hstack([x[:, None] + s * E for s in (1, -1, 0.5, -0.5, 0.25, -0.25)])
    a, b, c = (
        (plus - minus) / (2 * s * h)
        for s, (plus, minus) in zip((1, 0.5, 0.25), pairs(f(points).full(), len(x)), strict=True)
    )
    once, twice = (4 * b - a) / 3, (4 * c - b) / 3
    return (16 * twice - once) / 15


def pairs(columns: np.ndarray, count: int):
    parts = np.split(columns, np.arange(count, columns.shape[1], count), axis=1)
    return zip(parts[::2], parts[1::2], strict=True)


def noise(found: np.ndarray, f, x: np.ndarray) -> np.ndarray:
    """The rounding of each value, measured: what tiny steps change beyond what their slopes say; two eps at least."""
    tiny, value = 1e-12 * np.random.default_rng(9).normal(size=(len(x), 24)), f(x).full()
    misses = np.abs(f(x[:, None] + tiny).full() - value - found @ tiny)
    return np.maximum(misses.max(axis=1, keepdims=True, initial=0.0), 2 * EPS * np.abs(value))


def excess(found: np.ndarray, f, x: np.ndarray, h: np.ndarray) -> float:
    """The largest error of a Jacobian over what differences allow: 1e-8 of its column, and rounding over h.

    The weights of the extrapolated differences add up to 8 / h.
    """
    judge = richardson(f, x, h)
    allowed = 1e-8 * np.abs(judge).max(axis=0, initial=0.0) + 2 * 8 * noise(found, f, x) / h
    return float(np.max(np.abs(found - judge) / np.maximum(allowed, 1e-300), initial=0.0))


# -------- Jacobians and Hessians


def by_casadi(f: ca.Function, given: list[np.ndarray]) -> tuple[np.ndarray, dict[tuple[int, int], ca.DM]]:
    """`f.jacobian()`: its blocks by output and input, and the whole."""
    blocks = f.jacobian().call([ca.DM(x) for x in given] + [ca.DM(*f.size_out(o)) for o in range(f.n_out())])
    places = [(o, i) for o in range(f.n_out()) for i in range(f.n_in())]
    table = dict(zip(places, blocks, strict=True))
    rows = [np.hstack([table[o, i].full() for i in range(f.n_in())]) for o in range(f.n_out())]
    return np.vstack(rows), table


PAIRS = [(which, name) for name in NAMES for which in ROBOTS if (which, name) != ("rigid", "strain")]
"""Nothing of a rigid robot is strained."""


@pytest.mark.parametrize(("which", "name"), PAIRS)
def test_jacobians_equal_finite_differences(which, name):
    """Of every output with every input, parameters included; beyond its pattern the judge finds nothing."""
    model = robot(which)
    f, given = saved(model, name), values(model, name)
    found, _ = by_casadi(f, given)
    assert np.abs(found).max() > 0
    assert excess(found, stacked(f), column(given), steps(f, given)) <= 1


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("which", ["ella", "drawn"])
def test_hessians_equal_finite_differences(which, name):
    """Of a random combination of all outputs, by all inputs but the parameters; the gradient is the Jacobian's."""
    model = robot(which)
    f, given = saved(model, name), values(model, name, seed=1)
    free = [i for i in range(f.n_in()) if f.name_in(i) != "p"]
    symbols = [ca.SX.sym(f.name_in(i), *f.size_in(i)) if i in free else ca.SX(given[i]) for i in range(f.n_in())]
    y = ca.vertcat(*map(ca.vec, f.call(symbols)))
    weights, x = np.random.default_rng(2).normal(size=y.numel()), ca.vertcat(*(ca.vec(symbols[i]) for i in free))
    hessian, gradient = ca.hessian(ca.dot(ca.DM(weights), y), x)
    at = column([given[i] for i in free])
    slope = ca.Function("gradient", [x], [ca.densify(gradient)])
    found = ca.Function("hessian", [x], [hessian])(at).full()
    by_jacobian = np.hstack([np.split(by_casadi(f, given)[0], ends(f), axis=1)[i] for i in free]).T @ weights
    assert relative(slope(at).full().ravel(), by_jacobian) <= 1e-11
    assert relative(found, found.T) <= 1e-12
    assert excess(found, slope, at, np.full(len(at), 1e-3)) <= 1


def ends(f: ca.Function) -> np.ndarray:
    return np.cumsum([f.numel_in(i) for i in range(f.n_in())])[:-1]


# -------- patterns


def tables(text: str) -> list[list[list[str]]]:
    """The tables of a Markdown text: rows of cells, headings first."""
    found = re.findall(r"(?:^\|.*\|\n)+", text, re.MULTILINE)
    rows = [[line[1:-1].split("|") for line in table.splitlines()] for table in found]
    return [[[cell.strip() for cell in row] for row in (r[0], *r[2:])] for r in rows]


def documented(model) -> list[list[list[str]]]:
    return tables(model.casadi_files(tuple(model.casadi()))["README.md"].decode())


def count(cell: str) -> int:
    return int(cell.removeprefix("all ").split()[0])


@pytest.mark.parametrize("which", swept(ROBOTS, "ella", "rigid"))
def test_patterns_are_as_documented(which):
    """Against the sparsity of CasADi's symbolic Jacobian, entry by entry of the table."""
    model = robot(which)
    jacobians = next(t for t in documented(model) if t[0][-1].startswith("nonzeros"))
    assert len(jacobians) - 1 == sum(saved(model, name).n_out() for name in model.casadi())
    for function, output, cells in jacobians[1:]:
        f = saved(model, function.strip("`"))
        symbols = [ca.SX.sym(f.name_in(i), *f.size_in(i)) for i in range(f.n_in())]
        y = f.call(symbols)[f.index_out(output.strip("`"))]
        patterns = {x: ca.jacobian(ca.densify(y), s).sparsity() for x, s in zip(f.name_in(), symbols, strict=True)}
        written = dict(re.findall(r"`(\w+)`: ([^,]+?(?:, diagonal)?)(?:, (?=`)|$)", cells))
        assert {x: count(cell) for x, cell in written.items()} == {x: s.nnz() for x, s in patterns.items()}
        assert all(written[x].startswith("all") == s.is_dense() for x, s in patterns.items())


@pytest.mark.parametrize("which", ROBOTS)
def test_patterns_by_parts_are_as_documented(which):
    """The parts of `ode` and `dae` add up to the whole, and the ones that mechanics predicts are there."""
    model = robot(which)
    ode, dae = (t for t in documented(model) if t[0][0] == "" and "`tau`" in t[0])
    nq, m, n = model.nq, model.n_joints, model.n_links
    total = lambda table: sum(count(cell) for row in table[1:] for cell in row[1:])  # noqa: E731
    wrt = lambda name, outputs, inputs: sum(  # noqa: E731
        saved(model, name).jac_sparsity(o, i).nnz() for o in range(outputs) for i in range(inputs)
    )
    assert total(ode) == wrt("ode", 1, 2) and total(dae) == wrt("dae", 2, 3)
    assert ode[1] == ["dq/dt", "0", f"{nq} of {nq * nq}, diagonal", "0", "0"]
    assert count(ode[2][3]) == saved(model, "forward_dynamics").jac_sparsity(0, 2).nnz()
    rows = {row[0]: dict(zip(dae[0], row, strict=True)) for row in dae[1:]}
    assert rows["rows of joints"]["`w_ext`"] == rows["rows of joints"]["poses"] == "0"  # wherever in space they are
    assert rows["rate of twists"]["twists' rates"] == f"{6 * n} of {36 * n * n}, diagonal"
    assert all(rows[f"rate of {part}"]["wrenches"] == "0" for part in ("poses", "twists", "`q`"))
    assert ("rows of modes" in rows) == ("d²η/dt²" in dae[0]) == (nq > m)


@pytest.mark.parametrize("name", ["forward_dynamics", "inverse_dynamics", "bias", "energy"])
def test_patterns_hold_no_more_than_they_must(name):
    """Each nonzero that the patterns of ELLA's first outputs state is one, in one of four random states."""
    model = example("ella")
    f = saved(model, name)
    seen = [by_casadi(f, values(model, name, seed))[1] for seed in range(4)]
    for i in range(f.n_in()):
        used = np.any([np.array(table[0, i].full()) != 0 for table in seen], axis=0)
        assert used.sum() == f.jac_sparsity(0, i).nnz()


# -------- shooting


@pytest.mark.parametrize("kind", [("serial",), ("unroll",), ("thread", 2)], ids=lambda k: k[0])
def test_forward_dynamics_under_map(kind):
    """Six intervals at once: the values of six calls, and a Jacobian that does not mix intervals."""
    model, count = example("ella"), 6
    f = model.casadi()["forward_dynamics"]
    given = [values(model, "forward_dynamics", seed) for seed in range(count)]
    mapped = f.map(count, *kind)
    vdot, wrench = mapped(*(np.hstack(columns) for columns in zip(*given, strict=True)))
    single = [f(*columns) for columns in given]
    assert np.array_equal(vdot.full(), np.hstack([one[0].full() for one in single]))
    assert np.array_equal(wrench.full(), np.hstack([one[1].full() for one in single]))
    Q = ca.MX.sym("Q", model.nq, count)
    rest = [ca.DM(np.hstack(columns)) for columns in list(zip(*given, strict=True))[1:]]
    J = ca.Function("J", [Q], [ca.jacobian(mapped(Q, *rest)[0], Q)])
    at = J(np.hstack([columns[0] for columns in given]))
    own = [by_casadi(f, columns)[1][0, 0] for columns in given]
    assert relative(at.full(), ca.diagcat(*own).full()) <= 1e-13
    assert J.sparsity_out(0).nnz() == count * own[0].nnz()


def test_shooting_gaps_differentiate():
    """x[k+1] - RK4(x[k], u[k]) on two threads, as multiple shooting asks for it: Jacobian and Hessian."""
    model, count, step = example("ella"), 4, 1e-4  # what RK4 bears of axial modes
    f, p, nq, m = model.casadi()["forward_dynamics"], model.parameter_values, model.nq, model.n_joints
    x, u = ca.SX.sym("x", 2 * nq), ca.SX.sym("u", m)
    interval = ca.Function("interval", [x, u], [runge_kutta(lambda x: rate(f, x, u, p, nq), x, step)])
    w, states = ca.MX.sym("w", 2 * nq * (count + 1) + m * count), 2 * nq * (count + 1)
    X, U = ca.reshape(w[:states], 2 * nq, count + 1), ca.reshape(w[states:], m, count)
    gaps = ca.vec(X[:, 1:] - interval.map(count, "thread", 2)(X[:, :-1], U))
    rng = np.random.default_rng(5)
    size = np.tile(np.repeat([0.1, 1e-3, 0.1, 1e-2], [m, nq - m] * 2), count + 1)
    at = np.r_[size * rng.normal(size=states), rng.normal(size=m * count)]
    jacobian = ca.Function("J", [w], [ca.jacobian(gaps, w)])(at).full()
    assert excess(jacobian, ca.Function("f", [w], [gaps]), at, np.full(len(at), 1e-3)) <= 1
    weights = rng.normal(size=(2 * nq, count))
    hessian = ca.Function("H", [w], [ca.hessian(ca.dot(ca.DM(weights.ravel(order="F")), gaps), w)[0]])(at).full()
    both, multiplier = ca.vertcat(x, u), ca.SX.sym("l", 2 * nq)
    one = ca.Function("one", [x, u, multiplier], [ca.hessian(-ca.dot(multiplier, interval(x, u)), both)[0]])
    expected = np.zeros_like(hessian)
    for k in range(count):
        places = np.r_[2 * nq * k : 2 * nq * (k + 1), states + m * k : states + m * (k + 1)]
        here = at[places]
        expected[np.ix_(places, places)] = one(here[: 2 * nq], here[2 * nq :], weights[:, k]).full()
    assert relative(hessian, expected) <= 1e-11


def rate(f, x, u, p, nq):
    return ca.vertcat(x[nq:], f(x[:nq], x[nq:], u, 0, p)[0])


def runge_kutta(rate, x, h):
    k1 = rate(x)
    k2 = rate(x + h / 2 * k1)
    k3 = rate(x + h / 2 * k2)
    return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(x + h * k3))


# -------- files that stand alone

ALONE = """
import json, sys
from pathlib import Path

class Forbidden:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("screwgen", "sympy"):
            raise ImportError(f"{name} is not installed here")

sys.meta_path.insert(0, Forbidden())
try:
    import screwgen
except ImportError:
    import casadi as ca
else:
    sys.exit("screwgen can be imported")
folder, out = Path(sys.argv[1]), {}
for name, given in json.loads((folder / "given.json").read_text()).items():
    f = ca.Function.load(str(folder / "casadi" / f"{name}.casadi"))
    f = f if sys.argv[2] == "values" else f.jacobian()
    rest = [ca.DM(*f.size_in(i)) for i in range(len(given), f.n_in())]
    values = f.call([ca.DM(x) for x in given] + rest)
    out[name] = [[v.hex() for v in y.full().ravel().tolist()] for y in values]
print(json.dumps(out))
"""


@pytest.mark.parametrize("what", ["values", "jacobians"])
def test_files_load_without_the_package(tmp_path, what):
    """In an isolated process that may not import screwgen: the same bits, and the Jacobians' too."""
    model = robot("drawn")
    model.write(tmp_path / "out", targets=("casadi",), functions="all")
    given = {name: values(model, name) for name in WRITTEN}
    (tmp_path / "out" / "given.json").write_text(json.dumps({k: [x.tolist() for x in v] for k, v in given.items()}))
    command = [sys.executable, "-I", "-c", ALONE, str(tmp_path / "out"), what]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    printed = json.loads(done.stdout)
    assert set(printed) == {path.stem for path in Path(tmp_path / "out" / "casadi").glob("*.casadi")}
    for name, columns in printed.items():
        f = saved(model, name)
        f = f if what == "values" else f.jacobian()
        rest = [ca.DM(*f.size_in(i)) for i in range(len(given[name]), f.n_in())]
        for y, found in zip(f.call([ca.DM(x) for x in given[name]] + rest), columns, strict=True):
            assert [float.fromhex(x) for x in found] == y.full().ravel().tolist()
