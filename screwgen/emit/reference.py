"""Reference values for the self-check of generated code, evaluated with many digits."""

from __future__ import annotations

from collections.abc import Mapping

import mpmath

from ..chain import fuse
from ..chain.algorithms import Functions
from ..chain.chain import Chain
from ..lower.program import Program
from ..lower.replay import run


def cases(chain: Chain, count: int) -> list[dict[str, list[float]]]:
    """States and inputs with ``vdot``, wrenches and tip pose: at rest, then in motion."""
    p, constants = fuse.exact(chain)
    functions = Functions(chain, constants, p[:3], _apply)
    return [_case(chain, functions, number) for number in range(count)]


def _apply(link: int, phase: int, program: Program, inputs: Mapping) -> Mapping[str, list]:
    return run(program, inputs, fuse.precise)[0]


def _case(chain: Chain, functions: Functions, number: int) -> dict[str, list[float]]:
    state = _state(chain, number)
    exact = {name: [mpmath.mpf(x) for x in entries] for name, entries in state.items()}
    vdot, wrench = functions.forward_dynamics(exact["q"], exact["v"], exact["tau"], exact["w_ext"])
    R, position = functions.poses(exact["q"])[1][-1]
    results = {"vdot": vdot, "wrench": wrench, "tip_rotation": R, "tip_position": position}
    return state | {name: [float(x) for x in entries] for name, entries in results.items()}


def _state(chain: Chain, number: int) -> dict[str, list[float]]:
    """A state without pattern: fractional parts of multiples of irrational numbers, at sensible sizes.

    Even cases keep v small and odd ones do not; the case 0 has no external wrench.
    """
    draw = lambda k, salt, size: [round(size * _fraction(number, salt, j), 6) for j in range(k)]  # noqa: E731
    m, r, n = chain.n_joints, chain.n_modes, chain.n
    return {
        "q": draw(m, 1, 1.2) + draw(r, 2, 0.01),
        "v": draw(m, 3, 0.8) + draw(r, 4, 0.1),
        "tau": draw(m, 5, 20.0),
        "w_ext": [0.0] * 6 * n if number == 0 else draw(6 * n, 6, 5.0),
    }


def _fraction(number: int, salt: int, j: int) -> float:
    """A number in (-1, 1)."""
    x = (number + 1) * 0.6180339887498949 + salt * 0.7548776662466927 + (j + 1) * 0.5698402909980532
    return 2.0 * (x - int(x)) - 1.0
