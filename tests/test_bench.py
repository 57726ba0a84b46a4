"""The benchmark: its contenders compute the same, its table has its rows, what is missing is said."""

from __future__ import annotations

import csv
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from screwgen import derive

BENCH = Path(__file__).resolve().parents[1] / "bench"
sys.path.insert(0, str(BENCH))

import derivation  # noqa: E402
import groups  # noqa: E402
import growing  # noqa: E402
import lagrangian  # noqa: E402
import rigid  # noqa: E402
import robots  # noqa: E402
from contenders import Missing, constant_values, same_function  # noqa: E402
from table import HEAD, Row, duration, printed, spread  # noqa: E402
from turns import rows_of  # noqa: E402


def state(model, seed: int = 5) -> tuple[np.ndarray, ...]:
    """q, v, tau: modal coordinates small, as the benchmark has them."""
    rng, n = np.random.default_rng(seed), model.n_joints
    q = np.concatenate([rng.uniform(-1.2, 1.2, n), rng.uniform(-0.01, 0.01, model.nq - n)])
    return q, rng.uniform(-1, 1, model.nq), rng.uniform(-20, 20, n)


@pytest.fixture(scope="module")
def quick(tmp_path_factory) -> tuple[str, Path]:
    """What one group prints and where it writes."""
    out = tmp_path_factory.mktemp("bench")
    command = [sys.executable, BENCH / "bench.py", "--quick", "--rounds", "15", "--groups", "lagrangian2", "--level"]
    done = subprocess.run([*command, "O2", "--out", out], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout, out


@pytest.mark.parametrize("tuned", [False, True])
@pytest.mark.parametrize("links", groups.LAGRANGIAN)
def test_the_lagrangian_gives_the_same_accelerations(links, tuned):
    axial, _ = groups.LAGRANGIAN[links]
    robot = robots.flexible("arm", links, axial, 1)
    model = derive(robot)
    q, v, tau = state(model)
    theirs = lagrangian.forward_dynamics(robot, "f", tuned)(q, v, tau).full()[:, 0]
    ours = model.numpy().forward_dynamics(q, v, tau, np.zeros((links, 6)))[0]
    assert np.max(np.abs(theirs - ours)) < 1e-9 * np.max(np.abs(ours))


def test_the_lagrangian_refuses_what_it_leaves_out():
    with pytest.raises(ValueError, match="without bodies"):
        lagrangian.forward_dynamics(robots.example("ella"), "f")


def test_sympy_derives_the_same_equations():
    robot = derivation.planar(1)
    model = derive(robot)
    q, v, tau = state(model)
    method, torques = derivation.sympy_equations(robot)
    numbers = dict(zip(torques, tau, strict=True)) | dict(zip(method.q, q, strict=True))
    speeds = dict(zip((x.diff() for x in method.q), v, strict=True))
    M, F = (np.array(x.subs(speeds).subs(numbers), float) for x in (method.mass_matrix, method.forcing))
    ours = model.numpy().forward_dynamics(q, v, tau, np.zeros((2, 6)))[0]
    assert np.max(np.abs(np.linalg.solve(M, F)[:, 0] - ours)) < 1e-9 * np.max(np.abs(ours))


def test_the_rigid_chain_is_the_same_for_others():
    """Composite inertia about the base joint of the stretched chain, from the rows that others are given."""
    robot = robots.rigid("chain", 5)
    model, M, x = derive(robot), 0.0, 0.0
    for _, offset, m, com, _, _, zz in robots.rigid_joints(robot):
        x += offset
        M += m * (x + com) ** 2 + zz
    assert model.numpy().mass_matrix(np.zeros(5))[0, 0] == pytest.approx(M, rel=1e-12)


def test_the_constants_given_to_casadi_are_all_inputs_of_the_program():
    model = derive(robots.example("ella"))
    program = same_function(model, "constants")
    sizes = list(program.inputs.values())[4:]
    assert len(constant_values(model, program)) == sum(sizes) > 0


@pytest.mark.examples
def test_the_table_has_its_rows(quick):
    text, out = quick
    with open(out / "bench.csv", newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    titles = [row["contender"] for row in rows]
    assert titles[0].startswith("screwgen") and "CasADi Lagrangian + ldl" in titles
    assert all(float(row["ratio"]) > 0 and float(row["seconds"]) > 0 for row in rows)
    assert float(rows[0]["ratio"]) == 1.0
    assert all(title in text and title in (out / "bench.md").read_text(encoding="utf-8") for title in titles)
    shares = [float(row["share of peak"]) for row in rows if row["operations"]]
    assert shares and all(0.01 < share < 1.5 for share in shares)
    assert (out / "bench.png").stat().st_size > 10_000


@pytest.mark.examples
def test_the_table_fits_a_terminal(quick):
    table = quick[0].splitlines()[2:]
    assert max(map(len, table)) <= 100


def test_missing_contenders_are_named(monkeypatch, tmp_path):
    def absent(*_):
        raise Missing("there is no C++ compiler")

    monkeypatch.setattr(rigid, "toolchain", absent)
    group = groups.rigid_chain(2, tmp_path, "O2")
    reasons = dict(group.missing)
    assert reasons["Pinocchio C++ ABA"] == reasons["Pinocchio ABA on CasADi"] == "there is no C++ compiler"
    assert [c.title.split()[0] for c in group.contenders][:2] == ["screwgen", "screwgen"]


@pytest.mark.parametrize(
    ("ratio", "target", "met"),
    [(3, (3, None), True), (2.9, (3, None), False), (2, (None, 1), False), (1, (None, None), None)],
)
def test_targets(ratio, target, met):
    assert Row("", "", 1.0, ratio, target=target).met is met


def test_numbers():
    assert [duration(x) for x in (2.34e-7, 1.5e-6, 0.0123, 2.0)] == ["234 ns", "1.50 µs", "12.3 ms", "2.00 s"]
    assert spread([1.0, 1.0, 1.0]) == 0.0
    assert printed([Row("group; ratio", "one", 1e-9, 1.0)]).splitlines()[0].split() == list(HEAD[1:])


def test_a_group_that_there_is_not_is_named(tmp_path):
    command = [sys.executable, BENCH / "bench.py", "--groups", "elle", "--out", tmp_path]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 1 and "no group 'elle'; choose lagrangian2, " in done.stderr and not done.stdout


# -------- other tools


def test_peers_take_turns_and_the_best_round_counts():
    """Of two sides whose calls take 2 ms and 6 ms, in one round three times as long."""
    order = []

    def side(name, seconds):
        def run(calls):
            order.append(name)
            return calls * seconds * (3 if order.count(name) == 2 else 1)

        return run

    own, other = rows_of("beside", {"screwgen": side("a", 2e-3), "other": side("b", 6e-3)}, calls=5, rounds=4)
    assert order == ["a", "b"] * 4
    assert (own.seconds, own.ratio) == pytest.approx((2e-3, 1.0)) and (other.seconds, other.ratio) == pytest.approx(
        (6e-3, 3.0)
    )


@pytest.mark.parametrize(
    "name, status, said", [("mujoco", 1, "no rows of mujoco: the Python package"), ("x", 2, "no 'x'")]
)
def test_a_peer_that_is_missing_costs_its_rows(tmp_path, name, status, said):
    lines = ("import runpy, sys", "sys.modules['mujoco'] = None", "runpy.run_path(sys.argv[0], run_name='__main__')")
    program = f"import sys; sys.path.insert(0, {str(BENCH)!r}); sys.argv = sys.argv[1:]; {'; '.join(lines)}"
    command = [sys.executable, "-c", program, str(BENCH / "peers.py"), "--only", name, "--out", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == status and said in done.stderr and "Traceback" not in done.stderr


def test_steps_and_their_derivatives_are_timed_with_and_without_a_spring(monkeypatch):
    monkeypatch.setitem(growing.LEVELS, "O3", ("-O0",))
    monkeypatch.setattr(growing, "ROUNDS", 2)
    monkeypatch.setattr(growing, "LINKS", (2, 3))
    rows = [row for sprung in (False, True) for n in (2, 3) for row in growing.timed(n, sprung, "O3")]
    assert all(row.ratio >= 1 and row.seconds > 0 for row in rows) and len(rows) == 12
    assert growing.picture(rows)[:4] == b"\x89PNG"
