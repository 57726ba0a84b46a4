"""The judges of the paper's Section 3: a beam at rest and a single link, against what owes them nothing."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from numpy.polynomial.legendre import leggauss

from screwgen.algebra.expression import Negative, Sum, add
from screwgen.paper.beam_at_rest import BeamAtRest
from screwgen.paper.equation import SEEDS, TOLERANCE, Equality
from screwgen.paper.erratum import WRONG
from screwgen.paper.evaluate import evaluate
from screwgen.paper.jets import Jet, constant, turn
from screwgen.paper.link import DEFORMATION, DERIVED_D, DERIVED_H_STAR, M_STAR, L
from screwgen.paper.link_ends import DERIVED_H, ENDS, SECTIONS
from screwgen.paper.random_motion import RandomMotion
from screwgen.paper.single_link import RHO_A, TO_MASS_CENTRE, SingleLink, shaped

every_seed = pytest.mark.parametrize("seed", SEEDS)


def least_energy(beam: BeamAtRest) -> np.ndarray:
    """(3,): the displacement of the tip at which strain energy minus work is least, over polynomials of degree 4."""
    nodes, weights = leggauss(8)
    x, w, l = (1 + nodes) * beam.l / 2, weights * beam.l / 2, beam.l
    tip = []
    for k, (stiffness, order) in enumerate(((beam.EA, 1), (beam.EIz, 2), (beam.EIy, 2))):
        shapes = [Polynomial.basis(n) for n in range(order, 5)]
        strain = np.array([p.deriv(order)(x) for p in shapes])
        slope = {0: 0.0, 1: beam.torque[2], 2: -beam.torque[1]}[
            k
        ]  # the work of a torque on u': theta = (., -u_z', u_y')
        work = [
            beam.force[k] * p(l) + slope * p.deriv()(l) + beam.rhoA * beam.fall[k] * (w * p(x)).sum() for p in shapes
        ]
        c = np.linalg.solve(stiffness * (strain * w) @ strain.T, work)
        tip.append(sum(a * p(l) for a, p in zip(c, shapes, strict=True)))
    return np.array(tip)


@every_seed
def test_the_beam_at_rest_has_the_least_energy(seed):
    beam = BeamAtRest(seed)
    assert np.allclose(beam.values["r_xi_c:i"][:, 0], least_energy(beam), rtol=1e-10, atol=1e-14)
    assert np.abs(beam.values["r_xi_a:i"]).max() == 0 == np.abs(beam.values["r_xi1_a:i"][1:]).max()


@every_seed
def test_the_clamp_balances_the_elements(seed):
    """Force and moment of weight, tip load and reaction on the undeformed beam, element by element."""
    beam, v = BeamAtRest(seed), BeamAtRest(seed).values
    weight = beam.rhoA * beam.fall
    arms = v["r_b:i"][..., 0] - [beam.a, 0, 0]
    force = v["F_B:i"][:, 0] + beam.force + beam.weights["i"].sum() * weight
    hung = sum(w * np.cross(arm, weight) for w, arm in zip(beam.weights["i"], arms, strict=True))
    moment = v["tau_B:i"][:, 0] + beam.torque + np.cross([beam.l, 0, 0], beam.force) + hung
    assert np.abs(force).max() < 1e-14 and np.abs(moment).max() < 1e-14


@every_seed
def test_the_deformation_of_a_beam_at_rest(seed):
    """(34) as derived, with the paper's zero on the right: no load but the weight."""
    (printed,), (derived,) = DEFORMATION.printed, DEFORMATION.derived
    assert derived.misfit(BeamAtRest(seed)) < TOLERANCE
    assert printed.misfit(BeamAtRest(seed)) > WRONG


@pytest.mark.parametrize("e", [*SECTIONS, *ENDS], ids=lambda e: e.label)
def test_the_beam_at_rest_sees_a_wrong_sign(e):
    """Every term of either side of a row that holds."""
    beam = BeamAtRest(1)
    (line,) = e.derived or e.printed
    line = line.read({"H:i": DERIVED_H})
    assert e.label == "39" or line.misfit(beam) < TOLERANCE
    for wrong in flipped(line):
        assert wrong.misfit(beam) > WRONG


def flipped(line: Equality):
    for side in ("left", "right"):
        e = getattr(line, side)
        terms = e.terms if isinstance(e, Sum) else (e,)
        for k in range(len(terms)):
            changed = add(*(Negative(t) if i == k else t for i, t in enumerate(terms)))
            yield Equality(changed, line.right) if side == "left" else Equality(line.left, changed)


def test_the_derived_wrench_of_a_flying_link_is_nothing():
    """A straight link whose mass centre flies uniformly and whose spin about z is steady."""
    R = turn((0, 0, 1), 0.4, 2.5, 0)
    centre = Jet(np.array([[0.1], [0.2], [0.3]]), np.array([[1.0], [-2.0], [0.5]]), np.zeros((3, 1)))
    link = SingleLink(R=R, origin=centre - R @ constant([[TO_MASS_CENTRE], [0], [0]]))
    assert np.abs(link.values["total:i"]).max() < 1e-14
    assert np.abs(evaluate(M_STAR @ L.Vdot + DERIVED_D + DERIVED_H_STAR, link)).max() < 1e-13


def test_the_momentum_of_a_single_link_changes_by_its_wrench():
    """Central differences of linear and angular momentum about the inertial origin, the link bent and vibrating."""
    rate = constant(np.reshape([0.1, 0.2, -0.1, 0.05, 0.1, 0.2], (6, 1)))
    eta = Jet(shaped(0.02, 0.03, -0.02, 0.01, 0.0, 0.02).value, rate.value, -0.7 * rate.value)
    axis, state = np.array([[0.36], [0.48], [0.8]]), (0.4, 2.5, -1.2)
    p, v, a = (np.reshape(x, (3, 1)) for x in ((0.3, 0.2, 0.1), (1.0, -2.0, 0.5), (0.4, 0.8, -0.6)))

    def at(t: float) -> SingleLink:
        angle, speed = state[0] + state[1] * t + state[2] * t**2 / 2, state[1] + state[2] * t
        moved = Jet(eta.value + eta.rate * t + eta.second * t**2 / 2, eta.rate + eta.second * t, eta.second)
        return SingleLink(turn(axis, angle, speed, state[2]), Jet(p + v * t + a * t**2 / 2, v + a * t, a), moved)

    def momentum(link: SingleLink) -> np.ndarray:
        R, v = link.values["R:i"], link.values
        place, flow = R @ v["r_ob:i"], RHO_A * R @ v["v_ob:i"]
        spin = np.cross(place[..., 0], flow[..., 0])
        return np.concatenate([link.weights["i"] @ spin, link.weights["i"] @ flow[..., 0]])

    h, now = 1e-5, at(0.0)
    slope = (momentum(at(h)) - momentum(at(-h))) / (2 * h)
    R, origin = now.values["R:i"], now.values["r_o:i"][:, 0]
    wrench = evaluate(M_STAR @ L.Vdot + DERIVED_D + DERIVED_H_STAR, now)
    torque, force = (R @ part[:, 0] for part in (wrench[:3], wrench[3:]))
    assert np.allclose(slope, [*(torque + np.cross(origin, force)), *force], rtol=1e-7, atol=1e-7)


@every_seed
def test_the_shapes_of_the_judge_carry_momentum(seed):
    """Else no motion would tell whether the deformation's inertia is in a formula."""
    motion = RandomMotion(seed)
    phi, w = motion.values["phi:i"], motion.weights["i"]
    moments = [np.tensordot(w, motion.values["xi:i"] ** k * phi, 1) for k in (0, 1)]
    assert all((np.abs(m).sum(0) > 1e-2).any() for m in moments)
    gram = np.tensordot(w, np.swapaxes(phi, -1, -2) @ phi, 1)
    assert np.allclose(gram[np.ix_([0, 3], [0, 3])], np.eye(2), atol=1e-12)
