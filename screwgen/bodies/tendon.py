"""What a tendon does to the modes of the rod that it runs along."""

from __future__ import annotations

from ..algebra.expression import Inverse, Root, hat, unit
from ..ir.block import Block
from ..spec.link_class import LinkClass


def tendon_block(key: LinkClass) -> Block:
    """A tendon at one section: how long it is there, and how that changes with the modes.

    At the offset d from the centreline its direction is ``t = e_x + gamma + kappa x d + d'``, in axes of the section;
    its length is ``∫ |t| ds``, and its tension T does ``-T`` times the derivative of that to the modes. Offsets and
    curvatures are those of a rod of unit length, modal coordinates of unit length. One block serves all points.
    """
    b = Block("tendon", "Tendon at a section")
    if not key.tendons:
        return b
    r = key.modes
    share, offset, slope = b.input("share", (1, 1)), b.input("offset", (3, 1)), b.input("slope", (3, 1))
    gamma, kappa = b.input("gamma", (3, 1)), b.input("kappa", (3, 1))
    gamma_eta, kappa_eta = b.input("gamma_eta", (3, r)), b.input("kappa_eta", (3, r))
    t = b.step("t_c", unit(0) + gamma + hat(kappa) @ offset + slope)
    size = b.step("size_c", Root(t.T @ t))
    b.step("length_k", share @ size)
    moved = b.step("t_c_eta", gamma_eta - hat(offset) @ kappa_eta)
    b.step("pull_k", moved.T @ (t @ (share @ Inverse(size))))
    return b
