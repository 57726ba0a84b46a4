"""Rods to second order: published numbers, and where they end."""

import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
import scipy.optimize
from helpers import ROOT, arm, flat, link, model_of

from screwgen import Modes, SingularError, derive, load
from screwgen.studies.equilibrium import equilibrium


def test_a_link_spun_up_deflects_as_published():
    """Ten metres, spun up to 6 rad/s in 15 s: the tip lags by 0.574 m at most and ends on the turning radius."""
    end, rate = 15.0, 6.0
    section = {"EIy": 1.4e4, "EIz": 1.4e4, "EA": 2.8e7}
    model = model_of(arm(link("rod", 10.0, "z", 1.2, {"bending_y": 3}, section=section), gravity=(0, 0, 0), order=2))
    inertia, bias = (model.casadi()[name] for name in ("mass_matrix", "bias"))
    shapes, p = np.array(model.chain.keys[0].shapes("bending_y").tip_value), model.parameter_values

    def slope(t, x):
        phase = 2 * np.pi * t / end
        q, v = np.append(0.0, x[:3]), np.append(rate / end * (t - end / (2 * np.pi) * np.sin(phase)), x[3:])
        M, h = inertia(q, p).full(), flat(bias(q, v, np.zeros((6, 1)), p))
        return np.append(x[3:], np.linalg.solve(M[1:, 1:], -h[1:] - M[1:, 0] * rate / end * (1 - np.cos(phase))))

    run = scipy.integrate.solve_ivp(slope, (0, 8), np.zeros(6), method="DOP853", rtol=1e-7, atol=1e-9, max_step=0.1)
    assert abs((shapes @ run.y[:3]).min() + 0.5744) < 1e-3


ELASTICA = {1: (0.301721, 0.056433), 2: (0.493457, 0.160642), 4: (0.669964, 0.328941)}


def bent(load: float, order: int, segments: int) -> np.ndarray:
    """Deflection and approach of the tip of a cantilever of unit length and stiffness under a dead load at its tip."""
    flexible = {"modes": {"bending_z": 3}, "section": {"EIy": 1.0, "EIz": 1.0}, "rhoA": 1e-9}
    beam = link("beam", 1.0, [], bodies=[{"at": "tip", "mass": 1.0}], segments=segments, **flexible)
    found = equilibrium(model_of(arm(beam, gravity=(0, 0, -load), order=order)))
    return np.array([-found.tip_position[2], 1 - found.tip_position[0]])


@pytest.mark.parametrize("load", ELASTICA)
def test_segments_tend_to_the_elastica(load):
    """The error falls with the cube of the segments' number at order 2, with its square at order 1."""
    errors = {o: [abs(bent(load, o, k) / ELASTICA[load] - 1).max() for k in (4, 8)] for o in (1, 2)}
    assert errors[2][1] < 2e-3 and errors[1][1] < 2e-2
    assert 7 < errors[2][0] / errors[2][1] < 9 and 3.5 < errors[1][0] / errors[1][1] < 5.5


def test_the_watch_knows_orders():
    """A column past its buckling load: order 1 warns of axial load and names order 2, which has no such bound."""
    rod = link("rod", 1.0, [], 1.0, {"bending_y": 2})
    first, second = (model_of(arm(rod, gravity=(-12, 0, 0), order=order)).validity(np.zeros(2)) for order in (1, 2))
    assert "axial load" in first.line() and "order = 2" in first.line() and second.holds


@pytest.mark.parametrize("pieces, lost", [(1, True), (2, False)])
def test_a_bent_link_with_torsion_wants_pieces(pieces, lost):
    """ELLA's weight bends its upper arm by 15 mm, and its sections have a radius of gyration of 11 mm. In one piece, of
    two modes per plane, the mass matrix is no longer definite: what twisting swings out is left out of the energy."""
    robot = load(ROOT / "examples" / "ella.toml")
    bent = {"modes": Modes(bending_y=2, bending_z=2, torsion=1), "segments": pieces}
    links = tuple(x.model_copy(update=bent) for x in robot.links)
    model = derive(robot.model_copy(update={"order": 2, "links": links}))
    numeric, unloaded = model.numpy(), np.zeros((model.n_links, 6))
    rest = equilibrium(model, np.zeros(model.n_joints), hold=True).q
    assert (np.linalg.eigvalsh(numeric.mass_matrix(rest))[0] < 0) == lost
    if lost:
        with pytest.raises(SingularError):
            numeric.forward_dynamics(rest, 0 * rest, np.zeros(model.n_joints), unloaded)
