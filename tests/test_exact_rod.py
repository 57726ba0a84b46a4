"""A rod's second-order shape beside the exact one: its strains integrated along the rod, `R' = R hat(kappa)`,
`r' = R (e_x + gamma)`, without a truncation.

The strains come from the tests' own mode shapes. What the model leaves out is of third order in the modal coordinates.
"""

from functools import cache

import numpy as np
import pytest
from helpers import arm, link, model_of
from numpy.polynomial import chebyshev
from oracle_second_order import DEGREE, points, strains
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

LENGTH = 0.8
MODES = {"axial": 1, "bending_y": 2, "bending_z": 2, "torsion": 1, "shear_y": 1, "shear_z": 1}
SECTION = {"GAy": 1e5, "GAz": 1e5}
BASES = ("polynomial", "clamped_free")
HALVINGS = 4
SCALE = {"axial": 0.01, "bending_y": 0.03, "bending_z": 0.03, "torsion": 0.06, "shear_y": 0.01, "shear_z": 0.01}
"""The largest modal coordinates: tip deflections of some 5 % of the length, twists of some 0.1 rad."""


@cache
def rod(basis: str, order: int):
    """The tip poses of a clamped rod with all directions flexible."""
    return model_of(arm(link("rod", LENGTH, [], modes={"basis": basis, **MODES}, section=SECTION), order=order)).numpy()


def drawn(seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    scale = [SCALE[d] * (1.0 if d == "torsion" else LENGTH) / (k + 1) ** 2 for d, n in MODES.items() for k in range(n)]
    return np.array(scale) * rng.uniform(0.3, 1, len(scale)) * rng.choice([-1, 1], len(scale))


def exact_tip(basis: str, eta: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rotation (3, 3) and place (3,) of the tip section, m."""
    _, kappa, gamma = (np.einsum("k,kcs->cs", eta, x) for x in strains(basis, MODES, LENGTH))
    bent, stretched = (chebyshev.chebfit(points(), x.T, DEGREE) for x in (kappa, gamma))

    def slope(x, pose):
        R, at = pose[:9].reshape(3, 3), 2 * x / LENGTH - 1
        k, g = chebyshev.chebval(at, bent), chebyshev.chebval(at, stretched)
        return np.append(
            R @ np.cross(np.eye(3), k), R @ (np.array([1.0, 0.0, 0.0]) + g)
        )  # rows e_i x kappa: hat(kappa)

    start = np.append(np.eye(3), np.zeros(3))
    end = solve_ivp(slope, (0, LENGTH), start, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    return end[:9].reshape(3, 3), end[9:]


def differences(basis: str, order: int, eta: np.ndarray) -> np.ndarray:
    """How far the tool's tip is off the exact one: place (m) and angle (rad)."""
    R, place = exact_tip(basis, eta)
    found, at = rod(basis, order).tip_pose(eta)
    apart = Rotation.from_matrix(R).as_rotvec() - Rotation.from_matrix(found).as_rotvec()
    return np.array([np.linalg.norm(at - place), np.linalg.norm(apart)])


def ratios(basis: str, order: int, seed: int) -> np.ndarray:
    """(HALVINGS, 2): by how much the differences of place and angle fall with each halving of the coordinates."""
    off = np.array([differences(basis, order, drawn(seed) / 2**k) for k in range(HALVINGS + 1)])
    return off[:-1] / off[1:]


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("basis", BASES)
def test_the_second_order_shape_is_off_by_the_third(basis, seed):
    found = ratios(basis, 2, seed)
    assert np.all((found > 7.5) & (found < 8.5))


def test_the_first_order_shape_is_off_by_the_second():
    found = ratios("polynomial", 1, 0)
    assert np.all((found > 3.7) & (found < 4.3))
