"""CasADi functions for optimal control besides the dynamics: discrete steps, the tip's Jacobian, scales."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial

import casadi as ca

from ...algorithms import fused
from ...algorithms import robot_programs as programs
from ...algorithms.axis_laws import of_robot
from ...algorithms.law_programs import STAGE, stage, state_rate, stuck
from ...algorithms.schedule import COLUMNS
from ...algorithms.tip_programs import row_terms, row_wrenches
from ...integrators.method import Method, Motion
from ...integrators.methods import METHODS
from ...integrators.space import replayed
from ...ir.program import Program
from ...topology.chain import Chain
from .expressions import expressions
from .functions import coordinate_rates, exerted, function, side_by_side, symbols

STEP = "modal_midpoint"
"""The method of the function `step`, which is that of a simulation."""


def motion_functions(chain: Chain) -> dict[str, Callable[[], ca.Function]]:
    """What makes ``step``, ``step_<method>`` of every method, ``tip_jacobian`` and ``scaling``, by name."""
    others = {"tip_jacobian": lambda: tip_jacobian(chain), "scaling": lambda: scaling(chain)}
    return {"step": lambda: step(chain, METHODS[STEP], "step")} | steps(chain, METHODS.values()) | others


def steps(chain: Chain, methods: Iterable[Method]) -> dict[str, Callable[[], ca.Function]]:
    """What makes ``step_<method>`` of methods, by name."""
    dynamics = cache(lambda: fused.modal_dynamics(chain))
    return {f"step_{m}": partial(step, chain, m, f"step_{m}", dynamics) for m in methods}


class CasadiAccelerations:
    """Accelerations in SX at held torques and wrenches: a :class:`~screwgen.integrators.method.Accelerations`."""

    def __init__(self, chain: Chain, dynamics: Program, tau: ca.SX, w_ext: ca.SX, p: ca.SX):
        self.chain = chain
        self.program, self.given = dynamics, {"tau": tau, "w_ext": w_ext, "p": p}
        self.properties = expressions(fused.modal_properties(chain), {"p": p})

    def explicit(self, q: ca.SX, v: ca.SX) -> ca.SX:
        return self.implicit(q, v, 0.0)

    def implicit(self, q: ca.SX, v: ca.SX, h: ca.SX | float, there: Motion | None = None) -> ca.SX:
        q_there, v_there = there or (q, v)
        x = q[self.chain.given_places, 0]
        rates = slice(self.chain.nv - self.chain.n_given, self.chain.nv)
        rate, later = v[rates, 0], v_there[rates, 0]
        M, K, D = (self.properties[name] for name in COLUMNS["eta"])
        times = self.chain.modal_product
        felt = {"m_eta": M + h * D + h**2 * K, "f_eta": times(K, x + h * rate) + times(D, rate)}
        remembering = []
        for law, coordinates, sides, axes in of_robot(self.chain):
            for k, (i, side) in enumerate(zip(coordinates, sides, strict=True)):
                constants = {name: self.properties[name][k] for name in law.constants}
                state = {"side": ca.SX(side), "x": x[i], "w": rate[i], "there": later[i], "h": ca.SX(h)}
                state |= {"axis": x[axes[k]]} if axes else {}
                if law in self.chain.internal:
                    state |= {"z": v[self.chain.internal[law][k]]}
                    remembering.append((self.chain.internal[law][k], law, rates.start + i, state | constants))
                found = expressions(stage(law), state | constants)
                felt["m_eta"][i] += found["inertia"]
                felt["f_eta"][i] += found["force"]
        given = self.given | felt | {"q": q_there, "v": v_there}
        if self.chain.compliant and isinstance(h, ca.SX):
            terms = expressions(row_terms(self.chain), {"q": q, "v": v, "p": self.given["p"]})["terms"]
            over = {"terms": terms, "h": h, "ahead": ca.SX(there is not None and there[0] is not q)}
            acted = expressions(row_wrenches(self.chain), given | over)["acted"]
            given |= {"w_ext": ca.reshape(acted, 6, self.chain.n)}
        vdot = expressions(self.program, given)["vdot"]
        order = sorted(remembering, key=lambda one: one[0])
        states = [expressions(state_rate(law), given | {"a": vdot[i]})["rate"] for _, law, i, given in order]
        return ca.vertcat(vdot, *states, *self._of_forces(q_there, v_there, v, h))

    def _of_forces(self, q: ca.SX, v: ca.SX, start: ca.SX, h: ca.SX | float) -> list[ca.SX]:
        """The rates of the internal states of forces between frames."""
        if not self.chain.n_force_states:
            return []
        given = {"q": q, "v": v, "start": start[self.chain.force_states], "h": ca.SX(h)}
        return [expressions(programs.force_rates(self.chain), self.given | given)["rate"]]


def step(chain: Chain, method: Method, name: str, dynamics: Callable[[], Program] | None = None) -> ca.Function:
    """``(q, v, tau, w_ext, p, dt) -> (q_next, v_next)``: the inputs held over dt seconds, efforts within their limits.

    Quaternions are multiplied by unit quaternions and not scaled. ``dynamics``: what gives the program of modal
    dynamics, which all methods share.
    """
    given = symbols(chain, "q v tau w_ext p dt")
    tau = expressions(programs.held_inputs(chain), given)["held"] if chain.holds else given["tau"]
    program = dynamics() if dynamics else fused.modal_dynamics(chain)
    held = CasadiAccelerations(chain, program, tau, given["w_ext"], given["p"])
    q, v = method.step(held, given["q"], given["v"], given["dt"], replayed(chain, expressions))
    return function(name, given, q_next=q, v_next=v)


def tip_jacobian(chain: Chain) -> ca.Function:
    """``(q, p) -> (J)``: J v is the twist of the last tip, [ω; ṙ] of its section and point in inertial components."""
    given = symbols(chain, "q p")
    found, own = expressions(fused.poses(chain), given), chain.last_entries
    R, position = side_by_side(found["tip_R"], 3, 3)[:, own], found["tip_position"][own]
    slopes = along_rates(chain, ca.vec(R), given)
    columns = [_axis(ca.reshape(slopes[:, k], 3, 3) @ R.T) for k in range(chain.nv)]
    turning = ca.horzcat(ca.SX(3, 0), *columns)
    return function("tip_jacobian", given, J=ca.vertcat(turning, along_rates(chain, position, given)))


def along_rates(chain: Chain, f: ca.SX, given: Mapping[str, ca.SX]) -> ca.SX:
    """The matrix that takes v to the rate of a function of q."""
    slopes = ca.jacobian(f, given["q"])
    if not chain.curved:
        return slopes
    v = ca.SX.sym("v", chain.nv)
    return slopes @ ca.jacobian(coordinate_rates(chain, given["q"], v, given["p"]), v)


def _axis(spin: ca.SX) -> ca.SX:
    """ω of the matrix ω̃."""
    return ca.vertcat(spin[2, 1], spin[0, 2], spin[1, 0])


def scaling(chain: Chain) -> ca.Function:
    """``(p) -> (q, v, tau)``: the size of a coordinate, rate and input; divided by it they are of order one.

    Each is what the energy E says, that of the stretched arm whose heaviest joint moves at 1 rad/s or 1 m/s: a mode
    bends until its spring holds E, and so do bristles of friction; a rate alone carries E; a torque does 2 E over its
    angle, another input 2 E as what it moves most moves.  Joints turn by 1 rad or slide by 1 m, and rotors with them;
    the gear of a transmission stretches as a mode bends.  E is 1 J where there are no joints.
    """
    given, m, first = symbols(chain, "p"), chain.n_joints, chain.base_v
    inputs = symbols(chain, "q v vdot w_ext") | given
    force = expressions(fused.inertial_force(chain), inputs)["force"]
    M = ca.diag(ca.jacobian(force, inputs["vdot"])[:, : chain.nv])
    inertia = ca.substitute(M, inputs["q"], ca.vertcat(ca.SX(0, 1), *chain.home))
    properties = expressions(fused.modal_properties(chain), given)
    stiffness = list(properties.values())[1]
    twice = ca.mmax(inertia[first : first + m]) if m else ca.SX(2.0)
    springs = stiffness[chain.n_given - chain.n_modes : chain.n_given] if chain.n_modes else ca.SX(0, 1)
    modes = ca.sqrt(twice / springs)
    ratios, tau = ca.vertcat(ca.SX(0, 1), *chain.ratios(given["p"])), twice * ca.SX.ones(m)
    for k, (ratio, joint) in enumerate(zip(chain.ratios(given["p"]), chain.added_joints, strict=True)):
        if joint in chain.elastic_travels:
            ratios[k] = ca.sqrt(twice / stiffness[chain.n_given - chain.n_inner + k])
        else:
            tau[joint] /= ratio
    q = ca.vertcat(ca.SX.ones(chain.q_offset[-1]), ratios, modes)
    moves, at_home = ca.vertcat(ca.SX.ones(first + m), ratios, modes), ca.SX(ca.DM(list(chain.home)))
    at_rest = ca.SX.zeros(chain.nvz), ca.SX.zeros(chain.n_tau)
    forces = ca.horzsplit(ca.fabs(exerted(chain, at_home, *at_rest, given["p"]))) if chain.other_inputs else []
    sizes = [ca.mmax(force * moves) for force in forces]  # nothing where an input does nothing at home
    others = [ca.if_else(size > 0, twice / size, 1.0) for size in sizes]
    v = ca.vertcat(ca.sqrt(twice / inertia), *(ca.sqrt(twice / k) for k in _bristles(chain, properties)))
    v = ca.vertcat(v, *(tau[chain.tau_offset[i] + x.axis] for i, key in enumerate(chain.keys) for x in key.remembering))
    return function("scaling", given, q=q, v=v, tau=ca.vertcat(tau, *others))


def _bristles(chain: Chain, properties: Mapping[str, ca.SX]) -> list[ca.SX]:
    """The stiffness of every internal state; of one of a force such that 1 J is its usual size."""
    found = {}
    for law, places in chain.internal.items():
        for k, place in enumerate(places):
            own = {name: properties[name][k] for name in law.constants}
            given = dict.fromkeys((*STAGE, "z", "axis"), ca.SX(0)) | own
            found[place] = expressions(stuck(law), given)["stiffness"]
    sizes = (state.size for force in chain.forces for state in force.shape.states.values())
    return [found[place] for place in sorted(found)] + [ca.SX(2.0 / size**2) for size in sizes]
