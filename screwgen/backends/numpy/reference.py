"""Reference values for the self-check of generated code, evaluated with many digits."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import cast

import numpy as np

from ...algorithms import fused
from ...algorithms.dae_functions import DaeFunctions
from ...algorithms.functions import FORWARD, MOTION, Functions
from ...algorithms.schedule import Apply
from ...elements import STOP
from ...errors import ScrewgenError, SingularError
from ...ir.program import Program
from ...ir.replay import run
from ...lazily import mpmath
from ...spec.brake import BRAKES
from ...topology.chain import Chain
from .closing import OpenLoopError, closed
from .numeric import Numeric

TRIES = 20

Case = dict[str, list[float]]
"""A state, its inputs and its results by name."""


def cases(chain: Chain) -> Iterator[Case]:
    """States that the robot can be in, with their inputs, ``vdot``, wrenches and tip pose; the first without wrenches.

    ``extent``: how far from the origin a frame or a tip is at most, along an axis, m; 1 where all are there.

    There loops are closed, linkages reach their links, and the mass matrix is positive definite. Raises
    :class:`SingularError` or :class:`OpenLoopError` where none of TRIES states is such.
    """
    p, constants = fused.exact(chain)
    functions = Functions(chain, constants, fused.world(chain, p), evaluation(chain, _real, 0.0))
    refused: list[ScrewgenError] = []
    for number in range(TRIES):
        try:
            case = _case(chain, functions, number)
        except (SingularError, OpenLoopError) as error:
            refused.append(error)
        else:
            yield case
    if len(refused) == TRIES:
        raise refused[0]


def accelerations(
    chain: Chain, q: Sequence[float], v: Sequence[float], tau: Sequence[float], w_ext: Sequence[Sequence[float]]
) -> tuple[list[float], list[float]]:
    """``vdot`` (nv,) and the joint wrenches (6 n,) with many digits, rounded once: the same on every machine.

    Raises :class:`SingularError` as :func:`evaluation` does.
    """
    with mpmath.workdps(fused.DIGITS):
        p, constants = fused.exact(chain, (FORWARD, MOTION))
        functions = Functions(chain, constants, fused.world(chain, p), evaluation(chain, _real, 0.0))
        exactly = lambda values: [mpmath.mpf(float(x)) for x in values]  # noqa: E731
        wrenches = exactly(x for row in w_ext for x in row)
        vdot, wrench = functions.forward_dynamics(exactly(q), exactly(v), exactly(tau), wrenches)
        return [float(x) for x in vdot], [float(x) for x in wrench]


def evaluation(chain: Chain, functions: Callable, epsilon: float) -> Apply:
    """Evaluates phases in numbers whose spacing at 1 is `epsilon`; 0 for as many digits as one likes.

    What it evaluates raises :class:`SingularError` where a guard fails, as the generated code does: out of a linkage's
    reach, where the mass matrix is not positive definite or rows of loops depend on each other.
    """

    def apply(link: int, phase: int, program: Program, inputs: Mapping[str, list]) -> Mapping[str, list]:
        try:
            outputs, guards = run(program, inputs, functions, epsilon)
        except ZeroDivisionError:
            if not epsilon:  # the inertia is zero, and not lost to rounding
                raise
            raise chain.singular(link) from None
        if not all(guard > 0 for guard in guards):
            raise chain.singular(link)
        return outputs

    return apply


def _real(op: str, x: mpmath.mpf, *more: mpmath.mpf) -> mpmath.mpf:
    """The primitives in mpmath; not a number where they have no real value."""
    return mpmath.nan if op == "sqrt" and x < 0 else fused.precise(op, x, *more)


DRAWS = 16
"""How often a state is evaluated with rounding: at the numbers as they are stored, and at neighbours of these."""
REALS: dict[int, type] = {24: np.float32, 53: np.float64}
"""The numbers of so many bits."""


class Rounding:
    """A robot's dynamics in arithmetic of few bits: the program of the fused layout, preparation included."""

    def __init__(self, chain: Chain):
        self.chain, self.program = chain, rounded_dynamics(chain)

    def errors(self, case: Case, bits: int) -> tuple[float, float]:
        """How far arithmetic of so many bits is from a case's results: each part over its own largest entry.

        What rounding does to a result is one draw of a random number, which another order of operations draws anew. So
        the program runs DRAWS times, with inputs and parameters up to one unit in the last place apart, and the largest
        error counts. Infinite where rounding makes the posture singular. The second is that of the joint wrenches by
        inverse dynamics from the rounded accelerations; it is larger where inertial forces that are large beside the
        wrenches cancel, as in many welded links.
        """
        found, guards = _drawn(self.program, self.chain, case, REALS[bits])
        if not all(np.all(guard > 0) for guard in guards):
            return math.inf, math.inf
        drawn = {name: _stacked(values, DRAWS) for name, values in found.items()}
        errors = [_errors(self.chain, case, {name: x[k] for name, x in drawn.items()}) for k in range(DRAWS)]
        return max(error for error, _ in errors), max(error for _, error in errors)


@fused.program("q v tau w_ext vdot")
def rounded_dynamics(
    f: Functions, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence, vdot: Sequence
) -> fused.Outputs:
    """Forward dynamics, the pose of the last tip, and the ``inverse`` dynamics' wrenches at accelerations ``vdot``."""
    found, wrench = f.forward_dynamics(q, v, tau, w_ext)
    R, position = f.poses(q)[1][f.chain.last]
    inverse = f.without_forces().loads(q, v, vdot, f.with_loops(q, v, tau, w_ext).w_ext)[1]
    return {"found": found, "wrench": wrench, "R": R, "position": position, "inverse": inverse}


def assembly_error(chain: Chain, cases: Sequence[Case]) -> float:
    """How far rounding to single precision puts the assembled system of the DAE form from its solution.

    The largest entry of ``M_sys z + H_sys - W_sys`` over the largest sum of the sizes of a row's terms, ``z`` being the
    solution of the same system in double precision; of all cases and their neighbours, as in :class:`Rounding`.
    It is large where three axes are near gimbal lock, though accelerations are accurate there.
    """
    places: list[tuple[int, int]] = []

    def body(f: DaeFunctions, x: Mapping[str, Sequence]) -> fused.Outputs:
        entries, H, W = f.assemble(f.place(x["q"], x["v"]), x["tau"], x["w_ext"])
        places.extend(entries)
        return {"M": list(entries.values()), "rest": [h - w for h, w in zip(H, W, strict=True)]}

    program = fused.fuse(chain, "assembly_error", fused.inputs(chain, "q v tau w_ext"), body, kind=DaeFunctions)
    row, column = np.transpose(places)

    def drawn(case: Case, real: type, draws: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        found, _ = _drawn(program, chain, case, real, draws)
        return zip(_stacked(found["M"], draws), _stacked(found["rest"], draws), strict=True)

    def error(case: Case) -> float:
        (entries, rest), *_ = drawn(case, np.float64, 1)
        M = np.zeros((len(rest), len(rest)))
        M[row, column] = entries
        z = np.linalg.lstsq(M, -rest, rcond=None)[0]
        return float(np.max([share(z, *one) for one in drawn(case, np.float32, DRAWS)]))

    def share(z: np.ndarray, entries: np.ndarray, rest: np.ndarray) -> float:
        terms = entries * z[column]
        errors = np.abs(np.bincount(row, terms, len(rest)) + rest)
        largest = np.max(np.bincount(row, np.abs(terms), len(rest)) + np.abs(rest))
        return errors.max() / largest if largest else 0.0  # nothing loads a robot without gravity in its first state

    return max(map(error, cases), default=0.0)


def _drawn(program: Program, chain: Chain, case: Case, real: type, draws: int = DRAWS) -> tuple[dict[str, list], list]:
    """Outputs and guards of a program at a case and its neighbours, in the arithmetic of ``real``."""
    exact = {name: case[name] for name in program.inputs if name != "p"} | {"p": chain.parameters.values}
    size = float(np.finfo(real).eps)
    rng = np.random.default_rng(0)
    inputs = {name: [_neighbours(float(x), rng, real, size, draws) for x in exact[name]] for name in program.inputs}
    with np.errstate(all="ignore"):
        return run(program, inputs, _elementwise(real), real(size), real)


def _neighbours(x: float, rng: np.random.Generator, real: type, size: float, draws: int) -> np.ndarray:
    """(draws,): a number, and others that are at most one unit in the last place away; those of zero are zero."""
    moves = rng.uniform(-0.5, 0.5, draws)
    moves[0] = 0.0
    return (x * (1.0 + size * moves)).astype(real)


def _stacked(values: Sequence, draws: int) -> np.ndarray:
    """(draws, len(values)): entries in double precision; what does not depend on inputs is one number for all draws."""
    out = np.empty((len(values), draws))
    for k, x in enumerate(values):
        out[k] = x
    return out.T


def _elementwise(real: type) -> Callable:
    """The primitives on arrays, each number rounded to the nearest: the same on every machine."""

    def apply(op: str, x: np.ndarray, *more: np.ndarray) -> np.ndarray:
        if op in ("neg", "on", "sqrt"):  # every machine rounds a root to the nearest
            return -x if op == "neg" else np.sqrt(x) if op == "sqrt" else (x > 0).astype(real)
        exactly = lambda *given: real(_real(op, *(mpmath.mpf(float(x)) for x in given)))  # noqa: E731
        return np.vectorize(exactly, otypes=[real])(np.atleast_1d(x), *more)

    return apply


def _errors(chain: Chain, case: Case, found: Mapping[str, np.ndarray]) -> tuple[float, float]:
    """The errors of accelerations, wrenches and pose, and of the wrenches of inverse dynamics."""
    ends = (0, chain.eta_v - chain.n_added, chain.eta_v, chain.nv, chain.nvz)
    vdot, position, (extent,) = np.array(case["vdot"]), found["position"], case["extent"]
    wrench, exact, inverse = (np.reshape(x, (-1, 6)) for x in (found["wrench"], case["wrench"], found["inverse"]))
    parts = [(found["found"][a:b], vdot[a:b]) for a, b in pairwise(ends)]
    parts += [(wrench[:, 3 + k], exact[:, 3 + k]) for k in range(3)]
    parts += [(wrench[:, :3], exact[:, :3]), (found["R"], np.array(case["tip_rotation"]))]
    placed = float(np.max(np.abs(position - case["tip_position"]))) / extent
    return _worst(placed, *(_deviation(*part) for part in parts)), _worst(
        *(_deviation(inverse[:, kind], exact[:, kind]) for kind in (slice(3), slice(3, 6)))
    )


def _worst(*errors: float) -> float:
    return math.inf if any(map(math.isnan, errors)) else max(errors)


def _deviation(x: np.ndarray, reference: np.ndarray) -> float:
    scale, error = (float(np.max(np.abs(y), initial=0.0)) for y in (reference, x - reference))
    return error / scale if scale > 1e-6 else error


def _case(chain: Chain, functions: Functions, number: int) -> Case:
    state = _state(chain, functions, number)
    exact = {name: [mpmath.mpf(x) for x in entries] for name, entries in state.items()}
    vdot, wrench = functions.forward_dynamics(exact["q"], exact["v"], exact["tau"], exact["w_ext"])
    frames, tips = functions.poses(exact["q"])
    (R, position), places = tips[chain.last], [x for _, r in (*frames, *tips) for x in r]
    results = {"vdot": vdot, "wrench": wrench, "tip_rotation": R, "tip_position": position}
    results["extent"] = [max(map(abs, places)) or 1.0]
    return state | {name: [float(x) for x in entries] for name, entries in results.items()}


def _state(chain: Chain, functions: Functions, number: int) -> dict[str, list[float]]:
    """A state without pattern: fractional parts of multiples of irrational numbers, at sensible sizes.

    A mode is deflected by what a force of 20 N bends it, so that no stiff mode drowns the rest, and so are bristles of
    friction. Every other stop is pressed by as much, in the next case the others. The case 0 has no external wrench.
    """
    draw = lambda k, salt, size: [round(size * _fraction(number, salt, j), 6) for j in range(k)]  # noqa: E731
    m, n = chain.n_joints, chain.n
    K = [float(k) for c in functions.constants for k in c["K"]]
    eta = [float(f"{20.0 * _fraction(number, 2, j) / max(k, 400.0):.6e}") for j, k in enumerate(K)]
    pose = _unit(draw(chain.base_q, 7, 0.9))
    q = [round(x, 6) for x in chain.reached(draw(m, 1, 1.2), 1.2)]
    v, tau, p = draw(m, 3, 0.8), draw(m, 5, 20.0), chain.parameters.values
    wound = [1.0 + x for x in draw(chain.n_added, 7, 0.01)]
    turned = lambda x: [round(float(a * b), 6) for a, b in zip(chain.with_added(x, p)[m:], wound, strict=True)]  # noqa: E731
    turned = _stretched(chain, functions, number, turned) if chain.elastic_travels else turned
    of_ends = ([x for c in functions.constants for x in c.get(name, ())] for name in STOP.constants)
    ends = zip(chain.acted(STOP), *of_ends, strict=True)
    for stop, at, k, _ in list(ends)[number % 2 :: 2]:
        pressed, joint = float(at + stop.side * 20 / k), stop.coordinate
        q[joint] = pressed if chain.reach[joint, 0] < pressed < chain.reach[joint, 1] else q[joint]
    bent = [float(f"{20.0 * _fraction(number, 4, j) / max(k, 400.0):.6e}") for j, k in enumerate(_bristles(functions))]
    for ratio, joint in zip(chain.ratios(p), chain.added_joints, strict=True):
        tau[joint] = float(f"{tau[joint] / (ratio or 1.0):.6e}")
    if chain.closing.rows:
        near = _closed(chain, pose + q + turned(q) + eta)[chain.base_q :]
        q, eta = near[:m], near[chain.eta_q - chain.base_q :]
    return {
        "q": pose + _of_axes(chain, q) + turned(q) + eta,
        "v": draw(chain.base_v, 8, 0.8) + v + turned(v) + [float(f"{10.0 * x:.6e}") for x in reversed(eta)] + bent,
        "tau": tau + _others(chain, number, draw(chain.n_tau, 5, 20.0)[m:]),
        "w_ext": [0.0] * 6 * n if number == 0 else draw(6 * n, 6, 5.0),
    }


def _others(chain: Chain, number: int, drawn: Sequence[float]) -> list[float]:
    """The inputs behind torques: as tensions not less than zero; brakes open, closed and in between."""
    out = [abs(x) for x in drawn]
    own = chain.inputs.get(BRAKES, slice(0, 0))
    for k in range(own.start, own.stop):
        out[k - chain.n_joints] = (0.3, 1.0, 0.0, 0.8)[(number + k) % 4]
    return out


def bristle_stiffness(chain: Chain) -> list[float]:
    """What the forces of internal states grow by with these, at rest and at home, in their order."""
    if not chain.n_internal:
        return []
    p, constants = fused.exact(chain, (MOTION,))
    return _bristles(Functions(chain, constants, fused.world(chain, p), evaluation(chain, _real, 0.0)))


def _bristles(functions: Functions) -> list[float]:
    """What the forces of internal states grow by with these, at rest and at home, in their order.

    Of states of forces between frames what 20 N is over their usual size; those of held laws are as efforts.
    """
    chain = functions.chain
    state = functions.motion([mpmath.mpf(x) for x in chain.home], [mpmath.mpf(0)] * chain.nvz)
    acting = (one for i, x in enumerate(state) if chain.keys[i].internal for one in functions.laws(i, x))
    of_laws = [float(cast(float, one.values["by_z"])) for one in acting if one.law.state is not None]
    sizes = (state.size for force in chain.forces for state in force.shape.states.values())
    return of_laws + [20.0 / size for size in sizes] + [1.0] * chain.n_held_states


def _closed(chain: Chain, q: list[float]) -> list[float]:
    """A posture near `q` in which the loops are closed to six digits: that of the same modes if there is one.

    Its numbers are rounded, so that they do not depend on the machine. Rows that share forces need twelve digits: what
    one demands beyond the others is otherwise as large as the answer. Raises OpenLoopError.
    """
    numeric, digits = Numeric(chain), 12 if chain.closing.overconstrained else 6
    try:
        near = closed(numeric, q, np.arange(chain.nq) >= chain.eta_q)
    except OpenLoopError as error:
        near = closed(numeric, error.nearest, hasty=True)
    return [float(f"{x:.{digits}e}") for x in near]


def _stretched(chain: Chain, functions: Functions, number: int, turned: Callable) -> Callable:
    """`turned` with the elastic gears of transmissions stretched by 20 N, or N·m, and rates of the same numbers."""
    K = [float(k) for c in functions.constants for k in c.get("K_theta", ())]
    own = [20.0 * _fraction(number, 9, j) / max(k, 400.0) for j, k in enumerate(K)]
    along = [joint in chain.elastic_travels for joint in chain.added_joints]
    return lambda x: [float(f"{a:.6e}") if k else b for a, b, k in zip(own, turned(x), along, strict=True)]


def _of_axes(chain: Chain, q: list[float]) -> list[float]:
    """Joint coordinates from one number for each torque; of a ball joint a quaternion."""
    out: list[float] = []
    for i, key in enumerate(chain.keys):
        own = q[chain.tau_offset[i] : chain.tau_offset[i + 1]]
        out += [float(x) for x in key.joint.unit(np.array([1.0, *own]))] if own and key.joint.curved else own
    return out


def _unit(pose: list[float]) -> list[float]:
    """The pose of a floating base, its quaternion scaled to length one; of a fixed base there is none."""
    size = mpmath.sqrt(sum(mpmath.mpf(x) ** 2 for x in pose[3:]))
    return pose[:3] + [float(x / size) for x in pose[3:]]


def _fraction(number: int, salt: int, j: int) -> float:
    """A number in (-1, 1)."""
    x = (number + 1) * 0.6180339887498949 + salt * 0.7548776662466927 + (j + 1) * 0.5698402909980532
    return 2.0 * (x - int(x)) - 1.0
