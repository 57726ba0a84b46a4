"""The equations of motion of a robot as exact sums: its programs, run on symbols.

Nothing is derived here a second time. The inverse dynamics at rest without gravity, linear in the accelerations, has
the inertia matrix; C follows by Christoffel's symbols from the derivatives of its entries; at rest the inverse dynamics
has gravity and springs. What inverse dynamics of a motion has beyond these must be linear in the rates: the damping.
So that the equations hold together is proven for each robot, term by term.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from ...algorithms.functions import INVERSE, Functions
from ...algorithms.fused import prepared
from ...errors import UsageError
from ...ir.program import Program
from ...ir.replay import run
from ...topology.chain import Chain
from .functions import NoClosedFormError, function, without_parts
from .ring import COORDINATE, RATE, ExactSum, Generator, Ring, coefficients, derivative

Matrix = list[list[ExactSum]]


@dataclass
class ScalarMotion:
    """``M(q) vdot + C(q, v) v + D v + K q + g(q) = forces``, entry by entry."""

    ring: Ring
    q: list[Generator]
    v: list[Generator]
    vdot: list[Generator]
    M: Matrix
    C: Matrix
    D: Matrix
    K: Matrix
    g: list[ExactSum]


class Derivation:
    """Runs the programs of a robot on symbols.

    ``p``: its parameters as sums; ``turns``: which coordinates are angles.
    """

    def __init__(self, ring: Ring, chain: Chain, p: Sequence[ExactSum], turns: Sequence[bool]):
        self.ring, self.chain = ring, chain
        make = lambda turn, name: (ring.turning if turn else ring.generator)(name, COORDINATE)  # noqa: E731
        self.q = [make(turn, f"q{k}") for k, turn in enumerate(turns)]
        self.v = [ring.generator(f"v{k}", RATE) for k in range(chain.nv)]
        self.vdot = [ring.generator(f"vdot{k}", RATE) for k in range(chain.nv)]
        self.gravity = p[:3]
        self.constants = prepared(chain, p, lambda i, program, given: self._apply(i, 0, program, given), [INVERSE])

    def _apply(self, _: int, number: int, program: Program, given: Mapping[str, list]) -> dict[str, list]:
        ring = self.ring
        found = run(program, given, lambda op, *x: function(ring, op, *x), literal=ring.literal)[0]
        return {name: [without_parts(ring.literal(x)) for x in values] for name, values in found.items()}

    def forces(self, moving: bool, accelerating: bool, weight: bool = True) -> list[ExactSum]:
        """The inverse dynamics, with the given motion and weight left out."""
        ring, chain = self.ring, self.chain
        gravity = self.gravity if weight else [ring.literal(0)] * 3
        functions = Functions(chain, self.constants, gravity, self._apply)
        still = [ring.literal(0)] * chain.nv
        v = [ring.of(x) for x in self.v] if moving else still
        vdot = [ring.of(x) for x in self.vdot] if accelerating else still
        zero = [ring.literal(0)] * 6 * chain.n
        found = [ring.literal(x) for x in functions.inverse_dynamics([ring.of(x) for x in self.q], v, vdot, zero)]
        unsolved = {generator.number for generator in ring.open.values()}
        if any(unsolved & force.generators() for force in found):
            raise NoClosedFormError(
                "modes turn a section that carries a link about several axes; section_rotation = false leaves its frame"
            )
        return found

    def motion(self) -> ScalarMotion:
        """All terms of the equations.  Raises UsageError where forces are no polynomials of rates."""
        q = [self.ring.of(x) for x in self.q]
        springs = self.forces(moving=False, accelerating=False, weight=False)
        M = self._matrix(self.forces(moving=False, accelerating=True, weight=False), springs, self.vdot)
        rest = self.forces(moving=False, accelerating=False)
        K = [[_linear(force, x) for x in self.q] for force in springs]
        g = [force - _dot(row, q) for force, row in zip(rest, K, strict=True)]
        C = christoffel(M, self.q, self.v)
        v = [self.ring.of(x) for x in self.v]
        static = [force + _dot(row, v) for force, row in zip(rest, C, strict=True)]
        D = self._matrix(self.forces(moving=True, accelerating=False), static, self.v)
        return ScalarMotion(self.ring, self.q, self.v, self.vdot, M, C, D, K, g)

    def _matrix(self, forces: Sequence[ExactSum], others: Sequence[ExactSum], by: Sequence[Generator]) -> Matrix:
        """What ``forces - others`` multiply some symbols by."""
        places = {x.number: k for k, x in enumerate(by)}
        try:
            return [coefficients(force - other, places) for force, other in zip(forces, others, strict=True)]
        except ValueError:
            raise NoClosedFormError("its friction is no multiple of a rate") from None


def christoffel(M: Matrix, q: Sequence[Generator], v: Sequence[Generator]) -> Matrix:
    """``C_ij = sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) v_k / 2``: with it ``Mdot - 2 C`` is skew-symmetric."""
    ring, n = v[0].ring, range(len(v))
    slopes = {(i, j, k): derivative(M[i][j], q[k]) for i in n for j in range(i + 1) for k in n}
    by = lambda i, j, k: slopes[max(i, j), min(i, j), k]  # noqa: E731
    rates = [ring.of(x) for x in v]
    half = Fraction(1, 2)
    return [[_dot([(by(i, j, k) + by(i, k, j) - by(j, k, i)) * half for k in n], rates) for j in n] for i in n]


def _linear(force: ExactSum, x: Generator) -> ExactSum:
    """The constant coefficient of a coordinate in a force: a stiffness."""
    ring, out = force.ring, {}
    for m, c in force.terms.items():
        held = [(k, e) for k, e in m if _moves(ring.generators[k])]
        if held == [(x.number, 1)]:
            out[tuple(f for f in m if f[0] != x.number)] = c
    return ExactSum(ring, out)


def _moves(generator: Generator) -> bool:
    """Whether it depends on coordinates."""
    symbol = generator.angle or generator
    if symbol.part is not None:
        return any(_moves(symbol.ring.generators[k]) for k in symbol.part.generators())
    return symbol.kind == COORDINATE


def _dot(a: Sequence[ExactSum], b: Sequence[ExactSum]) -> ExactSum:
    out = ExactSum(b[0].ring, {})
    for x, y in zip(a, b, strict=True):
        out = out + x * y
    return out


def check(chain: Chain) -> None:
    """Raises UsageError for what equations in scalars do not cover."""
    reasons = (
        (bool(chain.closing.rows), "it has loops or couplings, whose forces are unknowns beside the motion"),
        (chain.nq != chain.nv, "its coordinates have a quaternion, of a ball joint or a floating base"),
        *((True, f"it has {row.words}, which are no torques of axes") for row in chain.other_inputs),
        (bool(chain.forces), "forces act between its frames, whose distances are roots of sums"),
        (bool(chain.z_offset[-1]), "its friction has internal states, whose rates have terms of |w|"),
        (bool(chain.n_force_states), "its forces or inputs have internal states"),
        (bool(chain.travel_kinds), "an axis has a transmission, whose lever is no sum of sines and cosines"),
    )
    for found, reason in reasons:
        if found:
            raise UsageError(f"robot '{chain.robot.name}' has no equations in scalars: {reason}")
