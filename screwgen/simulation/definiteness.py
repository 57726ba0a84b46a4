"""Whether the mass matrix of a posture is positive definite, which that of a link of order 2 is not however it bends.

The kinetic energy of such a link is a series in its deflection, of which terms above the second order are left out.
Where it bends far, or has many modes, a motion with negative kinetic energy remains. Forces and energies at rest are
right all the same; accelerations, frequencies and linear models mean nothing there. A rod of order "exact" is a sum of
squares, whatever its deflection.
"""

from __future__ import annotations

import numpy as np

from ..arguments import Given, Numbers
from ..errors import SingularError
from ..robot_model import RobotModel
from ..spec.segments import owner

ROUNDING = 1e-10
"""Of the eigenvalues of a mass matrix with ones on its diagonal; a singular posture has one of that size."""


def indefinite(model: RobotModel, q: Numbers, parameters: Given = None) -> str:
    """What is wrong with the mass matrix in the posture `q` (nq,), with its remedy; empty where nothing is."""
    second = [i for i, key in enumerate(model.chain.keys) if key.order == 2 and key.modes]
    if not second or _lowest(model, q, parameters) >= -ROUNDING:
        return ""
    straight = [_straightened(model, q, i) for i in second]
    alone = [i for i, there in zip(second, straight, strict=True) if _lowest(model, there, parameters) >= -ROUNDING]
    names = dict.fromkeys(f"'{owner(model.chain.names[i])}'" for i in alone or second)
    who = f"link {', '.join(names)} bends" if len(names) == 1 else f"links {', '.join(names)} bend"
    what = "so far that the mass matrix, of second order in the deflection, is not positive definite"
    return f'{who} {what}; give order = "exact", or more segments'


def _lowest(model: RobotModel, q: Numbers, parameters: Given) -> float:
    """The lowest eigenvalue of the mass matrix with ones on its diagonal."""
    M = model.numpy(parameters).mass_matrix(q)
    sizes = np.sqrt(np.where(np.diag(M) > 0, np.diag(M), 1.0))
    return float(np.linalg.eigvalsh((M + M.T) / 2 / np.outer(sizes, sizes))[0])


def _straightened(model: RobotModel, q: Numbers, link: int) -> np.ndarray:
    """The coordinates (nq,) with those of a link's modes zero."""
    chain, out = model.chain, np.array(q, float)
    first, last = chain.eta_offset[link : link + 2]
    out[chain.eta_q + first : chain.eta_q + last] = 0.0
    return out


def check_definite(model: RobotModel, q: Numbers, parameters: Given = None) -> None:
    """Raise SingularError where the mass matrix is indefinite in the posture `q` (nq,)."""
    if said := indefinite(model, q, parameters):
        raise SingularError(said)
