"""Programs of the functions that `robot_functions` lists, as far as no file of their subject has them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ..ir.derivative import columns, tangents
from ..ir.program import Node, Program
from ..topology.chain import Chain
from . import fused
from .dae_functions import DaeFunctions
from .functions import HOLD, Functions


@fused.program("q")
def centre_of_mass(f: Functions, q: Sequence) -> fused.Outputs:
    """``(q) -> (mass, centre)``."""
    mass, centre = f.centre_of_mass(q)
    return {"mass": [mass], "centre": centre}


@fused.program("q")
def centre_of_mass_jacobian(f: Functions, q: Sequence) -> fused.Outputs:
    """``(q) -> (J)``, row by row."""
    return {"J": f.centre_of_mass_jacobian(q)}


@fused.program("q v")
def momentum(f: Functions, q: Sequence, v: Sequence) -> fused.Outputs:
    """``(q, v) -> (angular, linear)``."""
    found = f.momentum(q, v)
    return {"angular": found[:3], "linear": found[3:]}


@fused.program("q v tau")
def drive_power(f: Functions, q: Sequence, v: Sequence, tau: Sequence) -> fused.Outputs:
    """``(q, v, tau) -> (power)``."""
    return {"power": f.drive_power(q, v, tau)}


@fused.program("q v tau w_ext")
def drive_effort(f: Functions, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> fused.Outputs:
    """``(q, v, tau, w_ext) -> (effort)``."""
    return {"effort": f.drive_efforts(q, v, tau, w_ext)}


@fused.program("q v tau w_ext")
def effort_power(f: Functions, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> fused.Outputs:
    """``(q, v, tau, w_ext) -> (power)``."""
    return {"power": f.effort_power(q, v, tau, w_ext)}


@fused.program("q v tau", algorithms=(HOLD,))
def held_inputs(f: Functions, q: Sequence, v: Sequence, tau: Sequence) -> fused.Outputs:
    """``(q, v, tau) -> (held)``: what a step that begins at the state holds."""
    return {"held": f.held(q, v, tau)}


@fused.program("q v tau")
def exerted(f: Functions, q: Sequence, v: Sequence, tau: Sequence) -> fused.Outputs:
    """``(q, v, tau) -> (exerted)``: the generalised forces per unit of each input but torques, (inputs, nv)."""
    return {"exerted": [x for force in f.exerted(q, v, tau) for x in force]}


@fused.program("q v tau")
def by_inputs(f: Functions, q: Sequence, v: Sequence, tau: Sequence) -> fused.Outputs:
    """``(q, v, tau) -> (force)``: the generalised forces of all inputs but torques."""
    return {"force": f.by_inputs(q, v, tau)}


def force_rates(chain: Chain, constants: str = "parameters") -> Program:
    """``(q, v, tau, start, h) -> (rate)``: of the internal states of forces and of held laws, the means over h.

    ``v`` holds the states at which gain and decay are taken, ``start`` those from which they change.
    """

    def body(f: Functions, x: Mapping[str, Sequence]) -> fused.Outputs:
        return {"rate": f.under_inputs(x["tau"]).force_rates(x["q"], x["v"], x["start"], x["h"][0])}

    given = {**fused.inputs(chain, "q v tau"), "start": chain.n_force_states, "h": 1}
    return fused.fuse(chain, "force_rates", given, body, constants)


def force_rate_slopes(chain: Chain, constants: str = "constants") -> Program:
    """``(q, v, tau, start, h) -> (by_q, by_v, by_start)``: how these rates change along coordinates, with rates and
    states, and with the states at the start, (states, nv), (states, nvz) and (states, states) row by row. Where inputs
    change them: also ``by_tau`` (states, n_tau)."""

    def body(f: Functions, x: Mapping[str, Sequence]) -> fused.Outputs:
        rates = f.under_inputs(x["tau"]).force_rates(x["q"], x["v"], x["start"], x["h"][0])
        units = [[float(i == k) for i in range(chain.nv)] for k in range(chain.nv)]
        ways = [zip(x["q"], f.coordinate_rates(x["q"], unit), strict=True) for unit in units]
        by_q = [tangents(rates, {a: b for a, b in way if isinstance(a, Node)}) for way in ways]
        rows = {"by_q": by_q, "by_v": columns(rates, x["v"]), "by_start": columns(rates, x["start"])}
        by_tau = columns(rates, x["tau"])
        rows |= {"by_tau": by_tau} if any(isinstance(s, Node) or s for row in by_tau for s in row) else {}
        return {name: [row[k] for k in range(len(rates)) for row in found] for name, found in rows.items()}

    given = {**fused.inputs(chain, "q v tau"), "start": chain.n_force_states, "h": 1}
    return fused.fuse(chain, "force_rate_slopes", given, body, constants)


def dae_force_rates(chain: Chain) -> Program:
    """The same of a state of the DAE form: ``(x, tau, start, h) -> (rate)``."""

    def body(f: DaeFunctions, x: Mapping[str, Sequence]) -> fused.Outputs:
        return {"rate": f.under_inputs(x["tau"]).force_rates(*f.coordinates(x["x"]), x["start"], x["h"][0])}

    given = {**fused.inputs(chain, "x tau"), "start": chain.n_force_states, "h": 1}
    return fused.fuse(chain, "dae_force_rates", given, body, kind=DaeFunctions)


@fused.program("tau", constants="constants", algorithms=())
def free_fall(f: Functions, tau: Sequence) -> fused.Outputs:
    """``(tau) -> (free_fall)``: its acceleration with what inputs add to it."""
    return {"free_fall": f.falling(tau).gravity}


@fused.program("q v (tau)")
def force_quantities(f: Functions, q: Sequence, v: Sequence, tau: Sequence = ()) -> fused.Outputs:
    """``(q, v) -> (force_quantities)`` of the forces between frames."""
    return {"force_quantities": f.under_inputs(tau).force_quantities(q, v)}


@fused.program("q")
def levers(f: Functions, q: Sequence) -> fused.Outputs:
    """``(q) -> (levers)``: what the torque of each axis is multiplied by."""
    return {"levers": f.levers(q)}


@fused.program("q v tau w_ext")
def loop_wrenches(f: Functions, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> fused.Outputs:
    """``(q, v, tau, w_ext) -> (loop_wrench)``: what the loops exert on the tips."""
    return {"loop_wrench": f.loop_wrenches(q, v, tau, w_ext)}


@fused.program("q v vdot w_ext")
def inverse_dynamics_with_loops(
    f: Functions, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence
) -> fused.Outputs:
    """``(q, v, vdot, w_ext) -> (force, loop_wrench)``."""
    found = f.shared_loads(q, v, vdot, w_ext)
    return {"force": found.force, "loop_wrench": found.wrenches}


@fused.program("q v tau w_ext")
def coupling_torques(f: Functions, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> fused.Outputs:
    """``(q, v, tau, w_ext) -> (torque)``: what couplings exert on the joint axes."""
    return {"torque": f.coupling_torques(q, v, tau, w_ext)}


@fused.program("q")
def tip_pose(f: Functions, q: Sequence) -> fused.Outputs:
    """``(q) -> (R, position)`` of the last tip, R row by row."""
    return dict(zip(("R", "position"), f.poses(q)[1][f.chain.last], strict=True))


@fused.program("q")
def link_pose(f: Functions, q: Sequence) -> fused.Outputs:
    """``(q) -> (R, position)`` of the link frames, link by link."""
    frames = f.poses(q)[0]
    return {name: [x for frame in frames for x in frame[k]] for k, name in enumerate(("R", "position"))}
