"""Random arms with bodies of points, and the standard input data of these by the definitions; no package code."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
import random_robots as rr
from oracle_flexible import Flexible

POINTS = 12
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))
HATS = [np.cross(np.eye(3), axis).T for axis in np.eye(3)]
"""``HATS[a] @ b`` is the unit vector of axis a times b, negative."""


def random_cloud(rng, modes: int, second: bool = False, axes: bool = False) -> Flexible:
    """A body of some kilograms and decimetres whose modes displace and turn its tip."""
    even = lambda x: x + x.swapaxes(-1, -2)  # noqa: E731
    shapes = rng.normal(size=(POINTS, 3, modes))
    A = rng.normal(size=(modes, modes))
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0] if axes else np.eye(3)
    return Flexible(
        masses=rng.uniform(0.1, 0.5, POINTS),
        places=rng.uniform([0.1, -0.2, -0.2], [0.5, 0.2, 0.2], (POINTS, 3)),
        shapes=shapes,
        stiffness=200.0 * (A @ A.T + np.eye(modes)),
        tip=np.array([0.6, 0.0, 0.1]) + rng.uniform(-0.1, 0.1, 3),
        tip_shapes=rng.normal(size=(3, modes)),
        tip_turns=2.0 * rng.normal(size=(3, modes)),
        tip_axes=turn * np.sign(np.linalg.det(turn)),
        damping=rng.uniform(0.0, 2.0, modes) if rng.random() < 0.5 else None,
        second=even(rng.normal(size=(POINTS, 3, modes, modes))) if second else None,
        tip_second=even(rng.normal(size=(3, modes, modes))) if second else None,
        tip_turn_second=even(rng.normal(size=(3, modes, modes))) if second else None,
    )


def random_arm(rng, n_links: int, **limits) -> dict:
    """A random robot, at least one link of which is a flexible body of points."""
    robot = rr.random_robot(rng, n_links, **limits)
    for i in {int(rng.integers(n_links)), *(k for k in range(n_links) if rng.random() < 0.3)}:
        kept = {key: robot["links"][i][key] for key in ("name", "joint", "bodies") if key in robot["links"][i]}
        follows = robot.get("section_rotation", True)
        cloud = random_cloud(rng, int(rng.integers(1, 4)), bool(rng.random() < 0.5), follows and rng.random() < 0.3)
        robot["links"][i] = kept | {"cloud": cloud}
    return robot


def random_state(rng, robot: dict) -> dict:
    """q, v, tau and w_ext; modal coordinates of bodies of points up to 3 cm."""
    state, q, v = rr.random_state(rng, {**robot, "links": [_bare(link) for link in robot["links"]]}), [], []
    joints = rr.joint_count(robot) + len(rr.ratios(robot))
    modal = iter(zip(state["q"][joints:], state["v"][joints:], strict=True))
    for link in robot["links"]:
        if "cloud" in link:
            q += rr.numbers(rng.uniform(-0.03, 0.03, link["cloud"].modes))
            v += rr.numbers(rng.uniform(-0.5, 0.5, link["cloud"].modes))
        else:
            own = list(itertools.islice(modal, sum(count for _, count in _counts(link))))
            q, v = q + [x for x, _ in own], v + [y for _, y in own]
    return state | {"q": state["q"][:joints] + q, "v": state["v"][:joints] + v}


def _bare(link: dict) -> dict:
    return link if "cloud" not in link else {"joint": link["joint"]}


def _counts(link: dict):
    return ((d, n) for d, n in link.get("modes", {}).items() if isinstance(n, int))


def with_files(robot: dict, folder: Path) -> dict:
    """The robot with a file of standard input data in the place of each body of points."""
    links = []
    for i, link in enumerate(robot["links"]):
        if "cloud" in link:
            path = folder / f"{robot['name']}_{i}.SID_FEM"
            path.write_text(sid_text(link["cloud"]), encoding="ascii")
            link = {key: value for key, value in link.items() if key != "cloud"} | {"body": {"sid": str(path)}}
        links.append(link)
    return {**robot, "links": links}


# -------- standard input data by the definitions, sums over the points


def operator(a: int, b: int) -> np.ndarray:
    """``omega x (omega x .)`` by the product of components a and b of omega."""
    return HATS[a] @ HATS[b] + (HATS[b] @ HATS[a] if a != b else 0.0)


def matrices(c: Flexible) -> dict[str, tuple[np.ndarray, np.ndarray | None]]:
    """``m0`` and ``m1`` (rows, modes, columns) of every matrix."""
    m, r, phi, modes = c.masses, c.places, c.shapes.transpose(0, 2, 1), range(c.modes)
    total = lambda x: np.tensordot(m, x, 1)  # noqa: E731
    h = np.zeros((len(m), c.modes, c.modes, 3)) if c.second is None else c.second.transpose(0, 2, 3, 1)
    skew = lambda x: np.cross(np.eye(3), x[:, None]).swapaxes(1, 2)  # noqa: E731
    S, F = skew(r), [skew(phi[:, k]) for k in modes]
    twice = lambda k: -total(S @ F[k] + F[k] @ S)  # noqa: E731
    spins = [operator(a, b) for a, b in PAIRS]
    crossed = lambda k, i: np.cross(phi[:, i], phi[:, k]) + np.cross(r, h[:, k, i])  # noqa: E731

    def spun(k, i, E):
        return total(np.sum((phi[:, k] @ E) * phi[:, i] + (h[:, k, i] @ E) * r, axis=1))

    return {
        "mdCM": (total(r)[:, None], np.array([[total(phi[:, k])[[a]] for k in modes] for a in range(3)])),
        "J": (-total(S @ S), np.array([twice(k) for k in modes]).swapaxes(0, 1)),
        "Ct": (total(phi), np.array([[total(h[:, k, i]) for i in modes] for k in modes])),
        "Cr": (total(np.cross(r[:, None], phi)), np.array([[total(crossed(k, i)) for i in modes] for k in modes])),
        "Me": (total(np.einsum("nka,nla->nkl", phi, phi)), None),
        "Gr": (np.hstack([-2 * total(S @ F[k]) for k in modes]), None),
        "Ge": (np.array([np.hstack([2 * total(np.cross(phi[:, i], phi[:, k])) for i in modes]) for k in modes]), None),
        "Oe": (
            np.array([[total(np.sum((phi[:, k] @ E) * r, axis=1)) for E in spins] for k in modes]),
            np.array([[[spun(k, i, E) for E in spins] for i in modes] for k in modes]),
        ),
        "Ke": (c.stiffness, None),
        "De": (np.diag(np.zeros(c.modes) if c.damping is None else c.damping), None),
    }


def node(name: str, origin, phi, psi, axes, phi1=None, psi1=None) -> str:
    """A node, second-order parts as ``m1(i, k, j)``."""
    order = lambda x: None if x is None else x.swapaxes(1, 2)  # noqa: E731
    turned = np.array([np.cross(axes.T, p).T * -1 for p in np.transpose(psi)]).swapaxes(0, 1)
    parts = {"origin": (origin[:, None], phi[:, :, None]), "phi": (phi, order(phi1)), "psi": (psi, order(psi1))}
    text = "".join(taylor(key, *value, psi.shape[1]) for key, value in {**parts, "AP": (axes, turned)}.items())
    return f" new node = {name}\n rframe = body ref\n{text} end node\n"


def taylor(name: str, m0: np.ndarray, m1: np.ndarray | None, modes: int) -> str:
    """A matrix in full, numbers in Fortran's spelling."""
    shown = lambda x: repr(float(x)).replace("e", "D")  # noqa: E731
    head = (
        f"  order = {int(m1 is not None)}\n  nrow = {m0.shape[0]}\n  ncol = {m0.shape[1]}\n  nq = {modes}\n  nqn = 0\n"
    )
    lines = [f"  m0( {i + 1}, {j + 1}) = {shown(x)}\n" for (i, j), x in np.ndenumerate(m0)]
    if m1 is not None:
        lines += [f"  m1( {i + 1}, {k + 1}, {j + 1}) = {shown(x)}\n" for (i, k, j), x in np.ndenumerate(m1)]
    return f" {name}\n{head}  structure = 3\n{''.join(lines)} end {name}\n"


def sid_text(c: Flexible) -> str:
    """A file of standard input data: base and tip as nodes."""
    none = np.zeros((3, c.modes))
    nodes = node("base", np.zeros(3), none, none, np.eye(3))
    nodes += node("tip", c.tip, c.tip_shapes, c.tip_turns, c.tip_axes, c.tip_second, c.tip_turn_second)
    parts = "".join(taylor(name, *value, c.modes) for name, value in matrices(c).items())
    reference = f" refmod\n mass = {float(c.masses.sum())!r}\n nelastq = {c.modes}\n end refmod\n"
    return f"points and modes\npart\n new modal\n{reference} frame\n{nodes} end frame\n{parts} end modal\nend part\n"
