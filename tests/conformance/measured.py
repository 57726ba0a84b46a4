"""Checks of what sensors at markers read, against the judge's sections and against differences in time.

The back ends share the derivation of these functions, so that it is not enough that they agree.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from oracle import parents_of
from scipy.spatial.transform import Rotation

from conformance.cases import Case
from conformance.judge import Judge
from conformance.numbers import near
from conformance.tendons import tables
from conformance.twin import first_piece
from screwgen.bodies.validity import MEASURES


def sensors(case: Case) -> None:
    """Poses equal the judge's, twists and accelerations the rates of poses, strains the judge's."""
    (q, v, tau, w_ext), f = case.given, case.model.numpy()
    R, r = f.marker_pose(q)
    links = case.judge.outer.links
    for marker, rotation, place in zip(case.model.chain.markers, R, r, strict=True):
        wanted = section(case, links.index(marker.segment), None if marker.is_tip else marker.at, case.judge.state["q"])
        near(rotation, wanted[0], case.tolerance, f"rotation of {marker.name}")
        near(place, wanted[1], case.tolerance, f"place of {marker.name}")
    vdot = f.forward_dynamics(q, v, tau, w_ext)[0]
    twist, gravity = f.marker_velocity(q, v), np.array(case.judge.twin["gravity"])
    rates = in_time(case, vdot, lambda q, v: np.concatenate([np.ravel(x) for x in f.marker_pose(q)]))
    turn, move = np.split(rates, [9 * len(R)])
    spin = np.einsum("kji,kjl->kil", R, turn.reshape(R.shape))
    near(twist[:, :3], np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], 1), 1e-7, "angular velocities")
    near(twist[:, 3:], np.einsum("kji,kj->ki", R, move.reshape(r.shape)), 1e-7, "velocities")
    near(f.gyro(q, v), twist[:, :3], case.agreement, "gyroscopes")
    near(f.marker_jacobian(q) @ v[: case.model.nv], twist, case.agreement, "Jacobians")
    felt = in_time(case, vdot, lambda q, v: np.ravel(moving(f, q, v))).reshape(-1, 2, 3)
    felt = np.concatenate([felt[:, 0], np.einsum("kji,kj->ki", R, felt[:, 1])], axis=1)
    near(f.marker_jacobian(q) @ vdot[: case.model.nv] + f.marker_bias(q, v), felt, 1e-6, "accelerations")
    free = np.einsum("kji,j->ki", R, gravity)
    near(f.accelerometer(q, v, tau, w_ext), felt[:, 3:] - free, 1e-6, "accelerometers")
    strains(case)
    whole_mass(case)
    cylinders(case)


def whole_mass(case: Case) -> None:
    """Mass, centre and momentum are those of all elements of the judge; the centre moves as its Jacobian says."""
    (q, v, *_), f = case.given, case.model.numpy()
    oracle, state = case.judge.oracle, case.judge.state
    moment = oracle._function([oracle.q], sum(cloud.first_moment() for cloud in oracle.clouds))(state["q"]).full()
    wanted = sum(float(np.sum(cloud.masses)) for cloud in oracle.clouds)
    mass, centre = f.centre_of_mass(q)
    near(mass, wanted, case.tolerance, "mass")
    near(centre, moment[:, 0] / wanted, case.tolerance, "centre of mass")
    linear, angular = oracle.momentum(state["q"], state["v"])
    near(np.concatenate(f.momentum(q, v)), np.concatenate([angular, linear]), case.tolerance, "momentum")
    near(
        mass * f.centre_of_mass_jacobian(q) @ v[: case.model.nv],
        linear,
        case.tolerance,
        "Jacobian of the centre of mass",
    )


def cylinders(case: Case) -> None:
    """Their lengths are the distances of their eyes."""
    names, q = case.model.q_names, case.given[0]
    wanted = []
    for link in case.robot["links"]:
        for k, drive in enumerate(link["joint"].get("drives", [])):
            own = drive.get("transmission", {})
            if "crank" in own:
                turned = q[names.index(f"{link['name']}.joint[{k}]")] + own["angle"]
                wanted.append(np.hypot(own["crank"] * np.cos(turned) - own["base"], own["crank"] * np.sin(turned)))
    if wanted:
        near(case.model.numpy().cylinder_length(q), np.array(wanted), 1e-14, "lengths of cylinders")


def section(case: Case, i: int, s: float | None, state: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rotation and place of a section, None for the tip, by the judge."""
    if s is not None:
        return case.judge.oracle.section_pose(i, state, s)
    poses = case.judge.oracle.poses(state)
    return poses["tip_R"][i], poses["tip_point"][i]


def moving(f, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Angular velocities of markers in their axes and velocities of their points in the inertial frame, (n, 2, 3)."""
    R, twist = f.marker_pose(q)[0], f.marker_velocity(q, v)
    return np.stack([twist[:, :3], np.einsum("kij,kj->ki", R, twist[:, 3:])], axis=1)


def in_time(case: Case, vdot: np.ndarray, f: Callable) -> np.ndarray:
    """The rate of a function of a state in the motion, by differences extrapolated once."""
    q, v, *_ = case.given
    nv = case.model.nv
    at = lambda t: f(case.moved(q, v[:nv] * t + vdot[:nv] * (t * t / 2)), v + vdot * t)  # noqa: E731
    size = 2e-3 / max(1.0, np.abs(v).max(), np.sqrt(np.abs(vdot).max()))
    coarse, fine = ((at(t) - at(-t)) / (2 * t) for t in (size, size / 2))
    return (4 * fine - coarse) / 3


def strains(case: Case) -> None:
    """Strains at bases and markers are the derivatives of the judge's shapes, times the modes."""
    chain, judge, names = case.model.chain, case.judge, [x["name"] for x in case.judge.twin["links"]]
    places = [(f"{x['name']}.base_strain", names.index(first_piece(x)), 0.0) for x in case.robot["links"]]
    places += [(f"{m.name}.strain", judge.outer.links.index(m.segment), m.at) for m in chain.markers if not m.is_tip]
    wanted = {f"{name}.{d}": x for name, i, s in places for d, x in strained(judge, i, s).items()}
    assert list(wanted) == case.model.strain_names
    if wanted:
        near(case.model.numpy().strain(case.given[0]), list(wanted.values()), 1e-9, "strains")


def strained(judge: Judge, i: int, s: float) -> dict[str, float]:
    """By direction, at a section of a link of the judge's."""
    link, table, out = judge.oracle.links[i], judge.twin["links"][i], {}
    eta = judge.state["q"][judge.oracle.modal_slices[i]]
    for d, shapes in tables(link, table, s).items() if "cloud" not in table else ():
        own, eta = np.split(eta, [link.counts[d]])
        order = 2 if d.startswith("bending") else 1
        if len(own):
            out[d] = shapes[order] @ own / link.length**order
    return out


BUCKLED, SAGGED = np.pi**2 / 4, 7.8373474
"""Loads over `EI / l²` and `EI / l³` at which a cantilever buckles, under a force at its tip and its own weight."""


def validity(case: Case) -> None:
    """The four measures of slender links of order 1 whose section is uniform and whose tip alone carries others."""
    (q, v, tau, w_ext), judge = case.given, case.judge
    state, poses, links = judge.state, judge.oracle.poses(judge.state["q"]), judge.twin["links"]
    twists = judge.oracle.link_twists(state["q"], state["v"])
    rates = judge.oracle.link_twist_rates(state["q"], state["v"], judge.motion[0])
    tips = np.split(judge.oracle.tip_twists(state["q"], state["v"]), 2, axis=1)
    tip_rates = np.split(judge.oracle.tip_twist_rates(state["q"], state["v"], judge.motion[0]), 2, axis=1)
    gravity = np.array(case.judge.twin["gravity"])
    found = np.reshape(case.model.numpy().validity(q, v, tau, w_ext), (-1, 4))[judge.outer.links]
    parents, loads = parents_of(links), judge.state["w_ext"] + judge.motion[1] + judge.acted[2].T
    loaded, wrench = {row.place.link for row in judge.outer.rows if row.place.s < 1.0}, judge.wrench[judge.outer.links]
    for i, link in enumerate(links):
        carried = [k for k, parent in enumerate(parents) if parent == i]
        if i in loaded or not plain(link, [links[k] for k in carried]):
            continue
        R, tip = poses["R"][i], poses["R"][i].T @ poses["tip_R"][i]
        force = sum((R.T @ poses["R"][k] @ wrench[k, 3:] for k in carried), np.zeros(3)) - tip @ loads[i, 3:]
        for body in (body for body in link.get("bodies", []) if body["at"] == "tip"):
            (spin, fast), (turned, sped), c = (x[i] for x in tips), (x[i] for x in tip_rates), np.array(body["com"])
            sped = sped + np.cross(spin, fast + np.cross(spin, c)) + np.cross(turned, c)
            force = force + body["mass"] * (tip @ (sped - poses["tip_R"][i].T @ gravity))
        omega, speed = np.split(twists[i], 2)
        a = rates[i, 3:] + np.cross(omega, speed) - R.T @ gravity
        l, rhoA = link["length"], link["section"]["rhoA"]
        EI, turn = min(link["section"][name] for name in ("EIy", "EIz")), np.sum(omega[1:] ** 2)
        moved = (R.T @ (poses["tip_point"][i] - poses["origin"][i]))[1:]
        wanted = [np.linalg.norm(moved) / l, np.linalg.norm(Rotation.from_matrix(tip).as_rotvec()[1:])]
        wanted += [l**2 / EI * (force[0] / BUCKLED + rhoA * l / SAGGED * a[0]), turn * rhoA * l**4 / EI]
        for what, value, expected in zip(MEASURES, found[i], wanted, strict=True):
            if what != "slope" or "flat" not in case.features:
                error = abs(value - expected)
                assert error <= 10 * case.tolerance * max(1.0, np.abs(wanted).max()), f"{what}: {value} is {expected}"


def plain(link: dict, carried: list[dict]) -> bool:
    """Whether a link's measures follow from one section, and from what it carries at its tip."""
    modes, section = link.get("modes", {}), link.get("section")
    bends = {"bending_y", "bending_z"} <= set(modes) and "shear_y" not in modes
    return (
        bends
        and "frame_at" not in link
        and isinstance(section, dict)
        and link.get("order", 1) == 1
        and all(x.get("at", "tip") == "tip" for x in carried)
    )
