"""The judge is judged: flexible links by textbook results and published figures, and the statics of arms."""

import numpy as np
import pytest
import random_robots as rr
from oracle import Oracle
from oracle_robots import arm, beam, modes, rod
from oracle_shapes import bending_shapes, quadrature, sine_shapes
from scipy.spatial.transform import Rotation

# -------- one flexible link


@pytest.mark.parametrize("count, ratio", [(1, 0.970688), (2, 0.995404), (3, 0.998556), (4, 0.999377), (5, 0.999678)])
def test_static_tip_deflection_of_clamped_free_modes(count, ratio):
    oracle = Oracle(beam(modes=modes("clamped_free", bending_y=count)))
    load = oracle.bias(np.zeros(count), np.zeros(count), [[0, 0, 0, 0, 1.0, 0]])
    _, point = oracle.tip_pose(np.linalg.solve(oracle.K, -load))
    assert np.isclose(point[1] * 3, ratio, atol=5e-7)


def test_static_tip_loads_of_polynomial_modes():
    """Two polynomials are exact: tip force F l³/3EI, its slope F l²/2EI; tip moment M l/EI; twist T l/GJ."""
    section = {"rhoA": 1.0, "EIy": 50.0, "EIz": 80.0, "GJ": 30.0, "rhoIp": 1e-3}
    robot = beam(modes=modes(bending_y=2, bending_z=2, torsion=30), section=section, length=1.1)
    oracle = Oracle(robot)
    zero = np.zeros(oracle.nv)
    for load, deflection, rotation in (
        ([0, 0, 0, 0, 1e-7, 0], [0, 1e-7 * 1.1**3 / 240, 0], [0, 0, 1e-7 * 1.1**2 / 160]),
        ([0, 0, 0, 0, 0, 1e-7], [0, 0, 1e-7 * 1.1**3 / 150], [0, -1e-7 * 1.1**2 / 100, 0]),
        ([0, 1e-7, 0, 0, 0, 0], [0, 0, -1e-7 * 1.1**2 / 100], [0, 1e-7 * 1.1 / 50, 0]),
        ([0, 0, 1e-7, 0, 0, 0], [0, 1e-7 * 1.1**2 / 160, 0], [0, 0, 1e-7 * 1.1 / 80]),
        ([1e-7, 0, 0, 0, 0, 0], [0, 0, 0], [1e-7 * 1.1 / 30, 0, 0]),
    ):
        R, point = oracle.tip_pose(np.linalg.solve(oracle.K, -oracle.bias(zero, zero, [load])))
        assert np.allclose(point - [1.1, 0, 0], deflection, rtol=1e-6, atol=1e-16)
        turned = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
        assert np.allclose(turned, rotation, rtol=1e-2 if load[0] else 1e-6, atol=1e-16)


def test_rotating_beam_by_hand():
    """Driven at Ω about z: centrifugal softening in the plane only, Coriolis between axial and bending."""
    rhoA, length, Omega, section = 1.4, 0.9, 3.0, {"rhoA": 1.4, "EA": 90.0, "EIy": 2.0, "EIz": 3.0}
    counts = {"axial": 1, "bending_y": 1, "bending_z": 1}
    oracle = Oracle(beam(["z"], modes=modes("clamped_free", **counts), section=section, length=length))
    eta, rate = np.array([0.01, 0.03, -0.02]), np.array([0.5, -0.7, 0.4])
    force = oracle.inverse_dynamics([0.6, *eta], [Omega, *rate], np.zeros(4))
    nodes, weights = quadrature(40)
    sine = sine_shapes(1, 40).nodes[0]
    mixed = np.sum(weights * sine * bending_shapes("clamped_free", 1, 40).nodes[0])
    pull = length * np.sum(weights * nodes * sine)
    mass = rhoA * length
    root = 1.8751040687119611
    stiffness = np.array([90 * (np.pi / 2) ** 2 / length, 3 * root**4 / length**3, 2 * root**4 / length**3])
    expected = stiffness * eta
    expected[0] -= mass * (Omega**2 * (eta[0] + pull) + 2 * Omega * mixed * rate[1])
    expected[1] -= mass * (Omega**2 * eta[1] - 2 * Omega * mixed * rate[0])
    assert np.allclose(force[1:], expected, rtol=1e-13)


def test_modal_damping_ratio():
    """An unloaded mode of ratio ζ has damping 2 ζ ω m."""
    robot = beam(modes=modes("clamped_free", bending_y=2, torsion=1), damping={"ratio": 0.03}, length=0.7)
    oracle = Oracle(robot)
    M, K = np.diag(oracle.mass_matrix(np.zeros(3))), np.diag(oracle.K)
    assert np.allclose(oracle.damping / (2 * np.sqrt(M * K)), 0.03, rtol=1e-12)


def test_material_spelling_gives_line_properties():
    material = {"density": 7800.0, "area": 2.09e-4, "E": 2.1e11, "G": 8e10, "Iy": 1.1e-8, "Iz": 1.7e-8}
    material["J"] = 2e-8
    line = {"rhoA": 7800 * 2.09e-4, "EA": 2.1e11 * 2.09e-4, "EIy": 2310.0, "EIz": 3570.0, "GJ": 1600.0}
    line["rhoIp"] = 7800 * 2.8e-8
    counts = modes(axial=1, bending_y=1, bending_z=1, torsion=1)
    first, second = (Oracle(beam(["x"], modes=counts, section=s)) for s in (material, line))
    assert np.allclose(first.K, second.K, rtol=1e-13)
    q = [0.1, 0.01, 0.02, 0.03, 0.04]
    assert np.allclose(first.mass_matrix(q), second.mass_matrix(q), rtol=1e-13)


# -------- published figures


# -------- statics of arms


def test_static_arm_weighs_what_it_weighs():
    """A bent, mounted, rigid arm at rest: force and moment at the base are those of the weights."""
    rng = np.random.default_rng(5)
    robot = rr.random_robot(rng, 3, rigid=1.0, material=0.0, frame_at=0.0)
    oracle, state = Oracle(robot), rr.random_state(rng, robot)
    poses, gravity = oracle.poses(state["q"]), np.array(robot["gravity"])
    force, moment = np.zeros(3), np.zeros(3)
    for i, link in enumerate(robot["links"]):
        R, joint = poses["R"][i], poses["joint_point"][i]
        parts = [(link["section"]["rhoA"] * link["length"], joint + R @ [link["length"] / 2, 0, 0])]
        for body in link.get("bodies", []):
            start = joint + R @ [link["length"] if body["at"] == "tip" else 0.0, 0, 0]
            parts.append((body["mass"], start + R @ np.array(body.get("com", [0.0] * 3))))
        for mass, point in parts:
            force -= mass * gravity
            moment -= np.cross(point - poses["joint_point"][0], mass * gravity)
    wrench = oracle.wrenches(state["q"], np.zeros(oracle.nv), np.zeros(oracle.nv))[0]
    assert np.allclose(poses["R"][0] @ wrench[3:], force, atol=1e-11)
    assert np.allclose(poses["R"][0] @ wrench[:3], moment, atol=1e-11)


def test_mount_and_frame():
    """rpy as URDF's, xyz in the parent's tip axes, F_i at frame_at from the joint along the link."""
    mount = {"xyz": [0.1, -0.2, 0.3], "rpy": [0.4, -0.5, 1.2]}
    link = rod(1.0, 1.0, [[0, 3, 4]], frame_at=0.25) | {"joint": {"axes": [[0, 3, 4]], "mount": mount}}
    poses = Oracle(arm(rod(0.7, 1.0, ["z"]), link)).poses([0.6, -0.9])
    first = Rotation.from_euler("z", 0.6)
    point = first.apply([0.7 + 0.1, -0.2, 0.3])
    turned = Rotation.from_rotvec([0, 0.6 * -0.9, 0.8 * -0.9])
    R = first * Rotation.from_euler("xyz", mount["rpy"]) * turned
    assert np.allclose(poses["joint_point"][1], point, atol=1e-14)
    assert np.allclose(poses["R"][1], R.as_matrix(), atol=1e-14)
    assert np.allclose(poses["origin"][1], point + R.apply([0.25, 0, 0]), atol=1e-14)
    assert np.allclose(poses["tip_point"][1], point + R.apply([1.0, 0, 0]), atol=1e-14)


@pytest.mark.parametrize("rotates", [True, False])
def test_tip_frame_turns_by_the_section(rotates):
    """exp of [torsion, -u_z', u_y'], or the base's orientation."""
    robot = beam(modes=modes(bending_y=1, bending_z=1, torsion=1), length=0.8) | {"section_rotation": rotates}
    eta, slope = np.array([0.05, -0.07, 0.3]), bending_shapes("polynomial", 1, 20).tip_slope[0] / 0.8
    theta = np.array([np.sqrt(3) * eta[2], -slope * eta[1], slope * eta[0]])
    R, _ = Oracle(robot).tip_pose(eta)
    assert np.allclose(R, Rotation.from_rotvec(rotates * theta).as_matrix(), atol=1e-14)
