"""Section 4 of the paper: joints' rows alone leave M_sys singular, whatever the arm; what P and the Adjoint do."""

import numpy as np
import pytest
from conftest import swept
from helpers import drawn
from random_robots import LETTERS
from scipy.linalg import block_diag
from scipy.spatial.transform import Rotation

from screwgen.paper.equation import SEEDS
from screwgen.paper.evaluate import evaluate
from screwgen.paper.jets import skew
from screwgen.paper.quantities import LinkLetters, indexed
from screwgen.paper.random_motion import RandomMotion
from screwgen.paper.synthesis import BEFORE, EQUATIONS, L, joint_bias


def equation(label):
    return next(e for e in EQUATIONS if e.label == label)


# -------- E17


def axes_of(joint, q):
    """The joint's axes in F_i, (3, m): each as the rotations after it leave it."""
    axes = [np.eye(3)[LETTERS.index(a)] if isinstance(a, str) else np.array(a) for a in joint["axes"]]
    axes = [a / np.linalg.norm(a) for a in axes]
    out = []
    for k, a in enumerate(axes):
        for later, angle in zip(axes[k + 1 :], q[k + 1 :], strict=True):
            a = Rotation.from_rotvec(-angle * later).apply(a)
        out.append(a)
    return np.array(out).T


def projector(joint, q):
    """(43) with the pseudo-inverse, in F_i."""
    A = axes_of(joint, q)
    return block_diag(np.eye(3) - A @ np.linalg.pinv(A), np.eye(3)) if A.size else np.eye(6)


def balanced(M):
    """Rows and columns scaled by turns to length 1: units have no effect."""
    for _ in range(30):
        for axis in (1, 0):
            M = M / np.linalg.norm(M, axis=axis, keepdims=True)
    return M


@pytest.mark.parametrize("seed", swept(range(6), 0, 1))
def test_projectors_alone_leave_one_zero_singular_value_per_joint_axis(seed):
    case = drawn(seed)
    q, v, tau, w_ext = case.inputs
    judge = case.model.numpy()
    M = judge.assemble(judge.dae_state(q, v), tau, w_ext)[0]
    rows, at = M.copy(), 0
    for i, link in enumerate(case.robot["links"]):
        count, own = len(link["joint"]["axes"]), slice(12 * i, 12 * i + 6)
        rows[own] = projector(link["joint"], q[at : at + count]) @ M[own]
        assert np.abs(rows[own, own]).max() < 1e-13
        at += count
    completed = np.linalg.svd(balanced(M), compute_uv=False)
    assert completed[-1] > 1e-9 * completed[0]
    alone = np.linalg.svd(rows, compute_uv=False) / np.linalg.norm(rows, 2)
    assert alone[-at] < 1e-14
    assert alone[-at - 1] > 1e-8


# -------- the joint's rows


@pytest.mark.parametrize("seed", SEEDS)
def test_the_adjoint_adds_the_lever_of_each_frame(seed):
    motion = RandomMotion(seed)
    v = motion.values
    lever = lambda k: skew(v[f"r_o:{k}"]) @ v[f"R:{k}"] @ v[f"omega:{k}"]  # noqa: E731
    gap = evaluate(equation("45").printed[0].left, motion)
    assert np.abs(gap[:3]).max() < 1e-12
    assert np.allclose(gap[3:], lever("i-1") - lever("i"), atol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("which", ["printed", "derived"])
def test_the_projector_leaves_the_bias_as_it_is(seed, which):
    motion = RandomMotion(seed)
    H_p = evaluate(getattr(equation("accconst5"), which)[0].right, motion)
    assert np.abs(H_p).max() > 0.1
    assert np.allclose(motion.values["P:i"] @ H_p, H_p, rtol=0, atol=1e-12 * np.abs(H_p).max())


@pytest.mark.parametrize("seed", SEEDS)
def test_the_bias_of_the_first_joint_has_no_link_before(seed):
    one, motion = LinkLetters("1"), RandomMotion(seed)
    assert np.allclose(evaluate(joint_bias(one), motion), motion.values["H_p:1"], atol=1e-11)


# -------- letters


def test_indices_of_several_characters_stand_as_in_the_paper():
    assert BEFORE.Ad.display == r"\mathbf{Ad}_{o(i-1)}"
    assert BEFORE.V_b_c.display == r"\mathbf{V}_{b_{i-1}}(c_{i-1})"
    assert BEFORE.V_xi_c.display == r"\mathbf{V}_{(i-1)\xi(c_{i-1})}"
    assert BEFORE.V_T.display == r"\mathbf{V}_{T_{i-1}}"
    assert BEFORE.W.display == r"\boldsymbol{\mathcal{W}}_{i-1}"
    assert indexed(r"\mathbf{r}_@", "i-1") == r"\mathbf{r}_{i-1}"
    assert L.V_xi_a.display == r"\mathbf{V}_{i\xi(a_i)}"
