"""Bodies from finite elements: solids of scikit-fem against their own full model, beam elements, faulty files."""

import importlib
import itertools
import re

import numpy as np
import pytest
import scipy.sparse as sparse
from conftest import package
from helpers import ROOT, model_of
from scipy.sparse.linalg import eigsh, splu

from screwgen import Link, RobotFileError, natural_frequencies
from screwgen.reduction.finite_elements import Mesh, load_npz, reduced

JOINT = {"axes": ["y"]}
PARTS = ("data", "indices", "indptr", "shape")


@pytest.fixture(scope="module")
def beam() -> Mesh:
    """A solid beam, 1 m long, 40 mm by 30 mm, of quadratic hexahedra."""
    skfem = package("skfem")
    from skfem.helpers import dot
    from skfem.models.elasticity import lame_parameters, linear_elasticity

    lines = np.linspace(0, 1, 21), np.linspace(-0.02, 0.02, 3), np.linspace(-0.015, 0.015, 3)
    basis = skfem.Basis(skfem.MeshHex.init_tensor(*lines), skfem.ElementVector(skfem.ElementHex2()), intorder=4)
    tables = (basis.dofs.nodal_dofs, basis.dofs.edge_dofs, basis.dofs.facet_dofs, basis.dofs.interior_dofs)
    order = np.hstack([t.reshape(-1, 3, t.shape[1]).transpose(0, 2, 1).reshape(-1, 3).T for t in tables]).T
    mass = skfem.BilinearForm(lambda u, v, _: 2700.0 * dot(u, v)).assemble(basis)
    stiffness = linear_elasticity(*lame_parameters(70e9, 0.33)).assemble(basis)
    M, K = (A[order.ravel()][:, order.ravel()].tocsc() for A in (mass, stiffness))
    nodes = basis.doflocs[:, order[:, 0]].T
    sets = {name: np.flatnonzero(abs(nodes[:, 0] - x) < 1e-9) for name, x in (("base", 0.0), ("tip", 1.0))}
    return Mesh(M, K, nodes, sets, {name: nodes[own].mean(axis=0) for name, own in sets.items()})


def inner(mesh: Mesh) -> np.ndarray:
    return np.setdiff1d(np.arange(mesh.M.shape[0]), mesh.of("base"))


def frequencies(mesh: Mesh, count: int) -> np.ndarray:
    """Of the full model, Hz, the base clamped and the tip as elastic as the rest."""
    free = inner(mesh)
    squares = eigsh(mesh.K[free][:, free], k=count, M=mesh.M[free][:, free], sigma=0, return_eigenvectors=False)
    return np.sqrt(np.sort(squares)) / (2 * np.pi)


def hertz(body) -> np.ndarray:
    return np.sqrt(np.diag(body.stiffness) / np.diag(body.inertia)) / (2 * np.pi)


def test_six_modes_have_the_frequencies_of_the_full_model(beam):
    assert np.allclose(hertz(reduced(beam, 6))[:6], frequencies(beam, 6), rtol=1e-6)


def test_craig_and_bamptons_modes_converge_from_above(beam):
    full = frequencies(beam, 4)
    errors = [hertz(reduced(beam, n, interface="fixed"))[:4] / full - 1 for n in (4, 8, 16)]
    assert np.all(np.array(errors) > -1e-6) and errors[0].max() < 2e-3 and errors[2].max() < 1e-4
    assert all(np.all(b <= a + 1e-9) for a, b in itertools.pairwise(errors))


@pytest.mark.parametrize("interface", ["free", "fixed"])
def test_the_tip_moves_under_force_and_weight_as_in_the_full_model(beam, interface):
    """Transverse force spread over the tip, and weight: the full model with a tip that is not rigid."""
    body, free, motion = reduced(beam, 2, interface=interface), inner(beam), np.linalg.pinv(beam.rigid("tip"))
    load = np.zeros((beam.M.shape[0], 5))
    load[beam.of("tip"), :2] = motion[1:3].T
    load[:, 2:] = beam.M @ np.tile(np.eye(3), (len(beam.places), 1))
    u = np.zeros_like(load)
    u[free] = splu(beam.K[free][:, free].tocsc()).solve(load[free])
    expected = (motion @ u[beam.of("tip")])[:3]
    generalised = np.hstack([body.tip.phi[1:3].T, body.momenta.T])
    found = body.tip.phi @ np.linalg.solve(body.stiffness, generalised)
    assert np.allclose(found, expected, rtol=0, atol=1e-4 * np.abs(expected).max(axis=0) + 1e-12)


def test_invariants_are_those_of_the_box(beam):
    m, (a, b, c) = 2700 * 1.0 * 0.04 * 0.03, (1.0, 0.04, 0.03)
    body = reduced(beam, 3)
    assert np.allclose(body.mass, m, rtol=1e-12)
    assert np.allclose(body.gram[0, 1:4], [m / 2, 0, 0], atol=1e-12)
    assert np.allclose(body.gram[1:4, 1:4], m * np.diag([a * a / 3, b * b / 12, c * c / 12]), rtol=1e-10)
    assert np.allclose(np.einsum("akal->kl", body.products), body.inertia, rtol=0, atol=1e-10 * m)
    assert np.array_equal(body.base.phi, np.zeros((3, 9))) and np.allclose(body.tip.origin, [1, 0, 0])


def test_symmetric_bodies_keep_their_zeros(beam):
    """Each mode moves the tip along one axis; no integral that vanishes is kept as noise."""
    body = reduced(beam, 6)
    assert ((np.abs(body.tip.phi) > 1e-9 * np.abs(body.tip.phi).max()).sum(axis=0) <= 1).all()
    assert (body.gram != 0).mean() < 0.25


@pytest.mark.parametrize("interface", ["free", "fixed", "natural"])
def test_modes_of_equal_frequency_keep_to_a_plane(interface):
    """Of a round beam, even where the count would cut a pair."""
    body = reduced(beam_elements(32, 0.8, 2.0, 300.0, 4e5, 200.0, 0.02), 4, interface=interface)
    moved = np.abs(body.tip.phi) > 1e-9 * np.abs(body.tip.phi).max()
    assert (moved.sum(axis=0) <= 1).all() and (moved[1:].sum(axis=1) >= 1).all()


def test_all_modes_up_to_a_frequency(beam):
    full = frequencies(beam, 8)
    count = int(np.sum(full <= 600.0))
    assert reduced(beam, None, 600.0).modes == 6 + count
    assert reduced(beam, None, 600.0, "natural").modes == count


def write(path, mesh: Mesh, **changed):
    parts = {f"{n}_{k}": getattr(A.tocsr(), k) for n, A in (("M", mesh.M), ("K", mesh.K)) for k in PARTS}
    stored = parts | {"nodes": mesh.places} | {f"set_{name}": own for name, own in mesh.sets.items()} | changed
    np.savez(path, **{name: value for name, value in stored.items() if value is not None})
    return path


def test_an_arm_has_the_frequencies_of_its_solid(beam, tmp_path):
    """A payload of the body's own mass: the full model with a rigid tip that carries it."""
    m = 3.24
    path = write(tmp_path / "beam.npz", beam)
    body = {
        "name": "boom",
        "joint": JOINT,
        "body": {"npz": str(path), "modes": 6},
        "bodies": [{"at": "tip", "mass": m}],
    }
    found = natural_frequencies(model_of({"name": "arm", "gravity": [0, 0, 0], "links": [body]}))[:4]
    tip, rest = beam.of("tip"), np.setdiff1d(inner(beam), beam.of("tip"))
    columns = sparse.identity(beam.M.shape[0], format="csc")[:, rest]
    rigid = np.zeros((beam.M.shape[0], 6))
    rigid[tip] = beam.rigid("tip")
    T = sparse.hstack([columns, sparse.csc_matrix(rigid)]).tocsc()
    added = sparse.diags(np.append(np.zeros(len(rest)), [m, m, m, 0, 0, 0]))
    squares = eigsh(T.T @ beam.K @ T, k=4, M=T.T @ beam.M @ T + added, sigma=0, return_eigenvectors=False)
    assert np.allclose(found, np.sqrt(np.sort(squares)) / (2 * np.pi), rtol=1e-4)


# -------- beam elements: nodes that turn


def beam_elements(count: int, l: float, rhoA: float, EI: float, EA: float, GJ: float, rhoIp: float) -> Mesh:
    """A straight beam along x of elements with six degrees of freedom at each node, consistent mass."""
    h, n = l / count, count + 1
    M, K = np.zeros((6 * n,) * 2), np.zeros((6 * n,) * 2)
    bar = np.array([[1, -1], [-1, 1]])
    share = np.array([[2, 1], [1, 2]]) / 6
    k = EI / h**3 * np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])
    m = rhoA * h / 420 * np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]])
    for e in range(count):
        for d, stiff, mass in ((0, EA, rhoA), (3, GJ, rhoIp)):
            place = np.ix_(*[[6 * e + d, 6 * e + 6 + d]] * 2)
            K[place] += stiff / h * bar
            M[place] += mass * h * share
        for d, turn, sign in ((1, 5, 1.0), (2, 4, -1.0)):
            change = np.diag([1, sign * h, 1, sign * h])
            place = np.ix_(*[[6 * e + d, 6 * e + turn, 6 * e + 6 + d, 6 * e + 6 + turn]] * 2)
            K[place] += change @ k @ change
            M[place] += change @ m @ change
    nodes = np.outer(np.linspace(0, l, n), [1.0, 0, 0])
    sets = {"base": np.array([0]), "tip": np.array([count])}
    return Mesh(sparse.csc_matrix(M), sparse.csc_matrix(K), nodes, sets, {k: nodes[v[0]] for k, v in sets.items()})


def test_a_beam_of_elements_moves_as_the_rod(tmp_path):
    """Nodes with rotations and rotary inertia: accelerations and energy of the rod, to the elements' error."""
    section = {"rhoA": 2.0, "EIy": 300.0, "EIz": 300.0, "EA": 4e5, "GJ": 200.0, "rhoIp": 0.02}
    mesh = beam_elements(64, 0.8, 2.0, 300.0, 4e5, 200.0, 0.02)
    path = write(tmp_path / "beam.npz", mesh)
    tip = [{"at": "tip", "mass": 3.0, "com": [0.05, 0.02, 0.0], "inertia": [0.02, 0.03, 0.03, 0, 0, 0]}]
    joint = {"axes": ["z", "x"], "stiffness": [100.0, 100.0]}
    rod = {"name": "a", "length": 0.8, "section": section, "joint": joint, "bodies": tip}
    rod["modes"] = {"axial": 4, "bending_y": 8, "bending_z": 8, "torsion": 4}
    body = {"name": "a", "body": {"npz": str(path), "modes": 16}, "joint": joint, "bodies": tip}
    models = [model_of({"name": "arm", "gravity": [0, 0, -9.81], "links": [x]}) for x in (rod, body)]
    expected, found = (natural_frequencies(m, joints="free")[:7] for m in models)
    assert np.allclose(found, expected, rtol=2e-4)


# -------- faults

FAULTS = {
    "no matrix": ({"K_data": None}, "has no 'K_data'; it needs M_data"),
    "no nodes": ({"nodes": np.zeros((3, 2))}, r"nodes must be an array \(n, 3\)"),
    "size": ({"nodes": np.zeros((5, 3))}, r"M is 390 x 390; with 5 nodes it must have 15 or 30 rows"),
    "not symmetric": ({"K_data": np.arange(2278.0)}, "K is not finite and symmetric|K is no sparse matrix"),
    "no set": ({"set_tip": None}, "has no 'set_tip', which is to be the tip; it has base"),
    "outside": ({"set_tip": np.array([99])}, "set_tip must be indices of nodes, from 0 to 64"),
    "shared": ({"set_tip": np.array([0])}, "base and tip share nodes"),
    "point": ({"point_tip": np.zeros(2)}, "point_tip must be three coordinates"),
}


@pytest.mark.parametrize(("changed", "message"), FAULTS.values(), ids=FAULTS)
def test_a_fault_in_the_file_has_one_line(changed, message, tmp_path):
    path = write(tmp_path / "beam.npz", beam_elements(64, 0.8, 2.0, 300.0, 4e5, 200.0, 0.02), **changed)
    with pytest.raises(RobotFileError, match=message) as caught:
        Link(name="a", joint=JOINT, body={"npz": str(path), "modes": 2})
    assert "\n" not in str(caught.value)


TABLES = {
    "no count": ({}, "body.modes: must be stated, or frequency in its place"),
    "both": (
        {"modes": 2, "frequency": 10.0},
        "body.modes: must be stated, or frequency in its place; state one of them",
    ),
    "too many": ({"modes": 32, "interface": "fixed", "base": "tip", "tip": "base"}, None),
    "nothing left": ({"frequency": 0.01, "interface": "natural"}, "no mode is left; raise modes or frequency"),
    "interface": ({"modes": 2, "interface": "loose"}, 'interface: is "loose"; it must be "free" or "fixed"'),
    "other base": ({"modes": 2, "base": "flange"}, "has no 'set_flange', which is to be the base"),
}


@pytest.mark.parametrize(("more", "message"), TABLES.values(), ids=TABLES)
def test_what_the_table_may_say(more, message, tmp_path):
    path = write(tmp_path / "beam.npz", beam_elements(64, 0.8, 2.0, 300.0, 4e5, 200.0, 0.02))
    make = lambda: Link(name="a", joint=JOINT, body={"npz": str(path), **more})  # noqa: E731
    if message is None:
        assert make().body.data.modes == 38
        return
    with pytest.raises(RobotFileError, match=message):
        make()


def test_a_text_is_no_npz(tmp_path):
    (tmp_path / "a.npz").write_text("no matrices")
    with pytest.raises(RobotFileError, match=r"is no \.npz file"):
        load_npz(tmp_path / "a.npz", 2)


def test_the_example_compares_solid_reduced_body_and_rod(monkeypatch, capsys, tmp_path):
    package("skfem")
    monkeypatch.syspath_prepend(str(ROOT / "examples"))
    bracket = importlib.import_module("bracket")
    monkeypatch.setattr(bracket, "FOLDER", tmp_path)
    monkeypatch.setattr(bracket, "COUNTS", (6,))
    assert bracket.main(["--quick"]) == 0
    rows = {
        m[1].strip(): [float(x) for x in m[2].split()]
        for m in re.finditer(r"^(.{16})((?: +[\d.]+)+)$", capsys.readouterr().out, re.M)
    }
    full = np.array(rows["finite elements"])
    assert np.allclose(rows["6 modes"], full, rtol=1e-3)
    assert (tmp_path / "boom.SID_FEM").exists()
