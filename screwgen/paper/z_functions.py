"""The functions of the Z-form: its state, the assembled system in ``Zdot``, and the Cauchy form, (98) to (111).

State ``x_c = [theta_1; r_1; ...; theta_n; r_n; eta; Z_1; ...; Z_n; etadot]``, (109); unknowns
``q_sys = [w_1; Zdot_1; ...; w_n; Zdot_n; etaddot]``, (84) and (100).  The joint coordinates come with the state as
memory: poses alone do not tell the axes of a skew universal joint.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..algorithms.dae_functions import DaeFunctions, Entries, link_unknowns
from ..algorithms.functions import ASSEMBLY, DAE_FORWARD, PLACEMENT, Algorithm
from ..algorithms.fused import Outputs, fuse, program
from ..algorithms.schedule import OUTWARD, Phase
from ..ir.lower import lower
from ..ir.program import Program, Tracer
from ..spec.parameters import coordinate_names
from ..topology.chain import Chain
from .z_form import H_MS, z_place, z_rates, z_rows, z_state
from .z_form_blocks import z_form_block

Z_ASSEMBLY: Algorithm = (Phase(z_state, OUTWARD), *ASSEMBLY, Phase(z_rows, OUTWARD))
Z_FORWARD: Algorithm = (Phase(z_state, OUTWARD), *DAE_FORWARD, Phase(z_rates, OUTWARD))
Z_PLACEMENT: Algorithm = (*PLACEMENT, Phase(z_place, OUTWARD))

COORDINATES = ("theta_x", "theta_y", "theta_z", "r_x", "r_y", "r_z")
RATES = ("omega_x", "omega_y", "omega_z", "rdot_x", "rdot_y", "rdot_z")


def cauchy_size(chain: Chain) -> int:
    """The length of x_c."""
    return 12 * chain.n + 2 * chain.n_modes


def cauchy_names(chain: Chain) -> dict[str, list[str]]:
    """The names of the entries of ``x_c`` and ``q_sys``."""
    links, names, m = chain.names, coordinate_names(chain.robot), chain.n_joints
    modal, rates = list(names.q[m:]), list(names.v[m:])
    of_links = lambda parts: [f"{link}.{part}" for link in links for part in parts]  # noqa: E731
    unknowns = link_unknowns(chain, RATES)
    return {
        "x_c": of_links(COORDINATES) + modal + of_links(RATES) + rates,
        "q_sys": unknowns + [name.replace("eta_rate", "eta_acceleration") for name in rates],
    }


class ZFunctions(DaeFunctions):
    """The functions of the Z-form, on values of any algebra."""

    def _nodes(self, chain: Chain) -> list[dict[str, list]]:
        places = super()._nodes(chain)
        places[0]["h_M"] = [0.0] * 6
        return places

    def unpack_z(self, x_c: Sequence, q: Sequence) -> list[dict[str, list]]:
        """The state as one mapping per link, the joint coordinates with it."""
        c, o = self.chain, self.chain.eta_offset
        at_Z = 6 * c.n + c.n_modes
        at_rate = at_Z + 6 * c.n
        state = [
            {
                "theta": list(x_c[6 * i : 6 * i + 3]),
                "r": list(x_c[6 * i + 3 : 6 * i + 6]),
                "eta": list(x_c[6 * c.n + o[i] : 6 * c.n + o[i + 1]]),
                "Z": list(x_c[at_Z + 6 * i : at_Z + 6 * i + 6]),
                "etadot": list(x_c[at_rate + o[i] : at_rate + o[i + 1]]),
                "q": list(q[c.q_offset[i] : c.q_offset[i + 1]]),
            }
            for i in range(c.n)
        ]
        return state

    def _links(
        self, algorithm: Algorithm, state: Sequence[Mapping], tau: Sequence, w_ext: Sequence
    ) -> list[dict[str, list]]:
        falling = self.falling(tau)
        return falling._run(algorithm, state, self.of_links(tau), self._wrenches(w_ext), falling._gravity())[0]

    def assemble_z(
        self, x_c: Sequence, q: Sequence, tau: Sequence, w_ext: Sequence
    ) -> tuple[Entries, list, list, list[dict[str, list]]]:
        """``M_sys`` by entries, ``H_sys`` and ``W_sys`` with ``Zdot`` as unknown, and what every link has stored."""
        links = self._links(Z_ASSEMBLY, self._with_terms(self.unpack_z(x_c, q), "eta"), tau, w_ext)
        return *self._stacked(links), links

    def cauchy(self, x_c: Sequence, q: Sequence, tau: Sequence, w_ext: Sequence) -> list[dict[str, list]]:
        """What every link gives to the Cauchy form: ``J_inverse``, ``Zdot``, ``etaddot``, ``qdot``, ``wrench``."""
        return self._links(Z_FORWARD, self._moving(self.unpack_z(x_c, q), Z_FORWARD[:2]), tau, w_ext)

    def place_z(self, q: Sequence, v: Sequence) -> list[dict[str, list]]:
        """``new_quaternion``, ``r``, ``eta``, ``Z``, ``etadot`` of every link, on the joints."""
        return self._run(Z_PLACEMENT, self._state(q, v))[0]


# ------------------------------------------------------------------------- the functions as programs


def _inputs(chain: Chain) -> dict[str, int]:
    return {"x_c": cauchy_size(chain), "q": chain.n_joints, "tau": chain.n_tau, "w_ext": 6 * chain.n}


def _gathered(links: Sequence[Mapping[str, list]], *names: str) -> list:
    return [v for link in links for name in names for v in link[name]]


def z_assembly(chain: Chain, constants: str = "parameters") -> tuple[Program, list[tuple[int, int]]]:
    """``(x_c, q, tau, w_ext) -> (M, H, W, h_Ms, T_gamma, gamma_star)``, with the places of the entries of ``M``.

    ``T_gamma`` (36 numbers) and ``gamma_star`` (6) link by link.
    """
    places: list[tuple[int, int]] = []

    def body(f: ZFunctions, x: Mapping[str, Sequence]) -> Outputs:
        entries, H, W, links = f.assemble_z(x["x_c"], x["q"], x["tau"], x["w_ext"])
        places.extend(entries)
        pieces = {name: _gathered(links, name) for name in ("T_gamma", "gamma_star")}
        return {"M": list(entries.values()), "H": H, "W": W, "h_Ms": _gathered(links, *H_MS)} | pieces

    return fuse(chain, "assemble_z", _inputs(chain), body, constants, ZFunctions), places


def z_dynamics(chain: Chain, constants: str = "parameters") -> Program:
    """``(x_c, q, tau, w_ext) -> (J_inverse, Zdot, etaddot, qdot, wrench, margin)`` by block elimination.

    ``margin`` is positive where a link's ``J_inverse`` exists.
    """

    def body(f: ZFunctions, x: Mapping[str, Sequence]) -> Outputs:
        links = f.cauchy(x["x_c"], x["q"], x["tau"], x["w_ext"])
        names = ("J_inverse", "Zdot", "etaddot", "qdot", "wrench", "margin")
        return {name: _gathered(links, name) for name in names}

    return fuse(chain, "cauchy", _inputs(chain), body, constants, ZFunctions)


@program("q v", kind=ZFunctions)
def z_placement(f: ZFunctions, q: Sequence, v: Sequence) -> Outputs:
    """``(q, v) -> (quaternion, r, eta, Z, etadot)``, link by link."""
    links, names = f.place_z(q, v), ("new_quaternion", "r", "eta", "Z", "etadot")
    return {name.removeprefix("new_"): _gathered(links, name) for name in names}


def exponential() -> Program:
    """``(theta) -> (R, J, J_inverse)``, row by row."""
    tracer = Tracer()
    values = lower(z_form_block(), {"theta": np.array(tracer.input("theta", 3))}, ("R", "J_theta", "J_inverse"), tracer)
    outputs = {name.removesuffix("_theta"): list(matrix.ravel()) for name, matrix in values.items()}
    return tracer.program("exponential", {"theta": 3}, outputs)
