"""The algorithms as lists of phases, and the public functions built from them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import NamedTuple

from ..elements import Law
from ..ir.program import Value
from ..spec.link_class import LinkClass
from ..topology.chain import Chain
from . import dae, given_motion, travels, validity
from . import motions as mo
from . import phases as ph
from . import sensitivity as sy
from .axis_laws import Place, of_link
from .axis_terms import rotor_accelerations
from .brake_functions import BrakeFunctions
from .compliant_functions import CompliantFunctions
from .force_functions import MOTION as MOTION
from .force_functions import POSES, ForceFunctions
from .held import hold, remember
from .input_functions import InputFunctions
from .joint_moves import rates
from .law_programs import forces
from .loop_functions import LoopFunctions
from .marker_functions import MarkerFunctions
from .momentum import MomentumFunctions
from .schedule import COLUMNS, INWARD, OUTWARD, Algorithm, Apply, Phase, execute, seen_by

KINEMATICS = Phase(ph.kinematics, OUTWARD)

SOLVE: Algorithm = (Phase(ph.eliminate, INWARD), Phase(ph.accelerate, OUTWARD))

FORWARD: Algorithm = (KINEMATICS, *SOLVE)
INVERSE: Algorithm = (KINEMATICS, Phase(ph.inverse_outward, OUTWARD), Phase(ph.inverse_inward, INWARD))
PLACES: Algorithm = (POSES,)
ENERGY: Algorithm = (Phase(mo.velocities, OUTWARD), POSES, Phase(mo.energy, OUTWARD))
MEASURING: Algorithm = (Phase(validity.measure, OUTWARD),)
SENSITIVITY: Algorithm = (Phase(given_motion.motion, OUTWARD), Phase(sy.answers, INWARD))

LEVERS: Algorithm = (Phase(travels.levers, OUTWARD),)
CYLINDERS: Algorithm = (Phase(travels.cylinders, OUTWARD),)
HOLD: Algorithm = (Phase(hold, OUTWARD),)
MEMORY: Algorithm = (Phase(remember, OUTWARD),)

DAE_FORWARD: Algorithm = (Phase(dae.dae_kinematics, OUTWARD), *SOLVE, Phase(dae.twist_rates, OUTWARD))
ROTORS: Algorithm = (Phase(rotor_accelerations, OUTWARD),)
DAE_RATES: Algorithm = (Phase(dae.pose_rates, OUTWARD),)
PROJECTION: Algorithm = (Phase(dae.project, OUTWARD),)
PLACEMENT: Algorithm = (Phase(dae.forward_kinematics, OUTWARD),)
ASSEMBLY: Algorithm = (Phase(dae.joint_rows, OUTWARD), Phase(dae.link_rows, INWARD, per_child=True))

EVERYTHING = (FORWARD, INVERSE, PLACES, ENERGY, DAE_FORWARD, DAE_RATES, PROJECTION, PLACEMENT, ASSEMBLY, MEASURING)

IDENTITY = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]


def nodes(chain: Chain, gravity: Sequence) -> list[dict[str, list]]:
    """The nodes with their known values: the base is at rest and accelerates by ``-g``, leaves carry no load."""
    out: list[dict[str, list]] = [{} for _ in range(chain.tree.size)]
    out[0] |= {name: [0.0] * 3 for name in ("omega", "v", "omega_T", "v_T")}
    out[0] |= {"acc_0": [0.0] * 3 + [-g for g in gravity]}
    out[0] |= {"R_T": IDENTITY, "delta": [0.0] * 6}
    out[0] |= {"R": IDENTITY, "r": [0.0] * 3, "rdot": [0.0] * 3, "Q": [1.0, 0.0, 0.0, 0.0], "b": [0.0] * 6}
    out[0] |= {"R_m": IDENTITY, "r_m": [0.0] * 3, "omega_m": [0.0] * 3, "v_m": [0.0] * 3}
    out[0] |= {"acc": out[0]["acc_0"]}
    for leaf in chain.tree.leaves:
        out[leaf] |= {"f": [0.0] * 6, "Gamma": [0.0] * 18, "Lambda_T": [0.0] * 21}
        out[leaf] |= {"Lambda": [0.0] * 21, "p": [0.0] * 6, "X": [0.0] * 36, "PX": [0.0] * 36}
    return out


class ActingLaw(NamedTuple):
    """A law on a coordinate of a link, the ``number`` of that among the law's there, and what its program
    :func:`.law_programs.forces` finds."""

    law: Law
    place: Place
    number: int
    values: Mapping[str, Value]


class Functions(
    InputFunctions,
    LoopFunctions,
    CompliantFunctions,
    ForceFunctions,
    MarkerFunctions,
    MomentumFunctions,
    BrakeFunctions,
):
    """The functions of a robot; ``apply`` runs one program on numbers, casadi.SX or nodes of another program.

    Vectors are lists.  ``constants`` holds, for every link, its constants by label (lists of one) and the
    ``COLUMNS``; ``world`` has gravity, three entries, then the numbers of the forces between frames.  ``given``, if
    set, holds inertia (``chain.n_inertia`` entries) and force of the last ``chain.n_given`` coordinates in place of
    ``M`` and ``K x + D xdot``: implicit integrators give their own.
    """

    given: tuple[Sequence, Sequence] | None = None

    section: Callable[[str], AbstractContextManager] = nullcontext
    """Opens a titled section of the program that is being recorded, if one is."""

    def __init__(self, chain: Chain, constants: Sequence[dict[str, list]], world: Sequence, apply: Apply):
        self.chain, self.constants, self.world, self.apply = chain, constants, world, apply
        self.acts = chain.acts_on_tips

    @property
    def gravity(self) -> Sequence:
        """The acceleration of free fall (3,)."""
        return self.world[:3]

    def _nodes(self, chain: Chain) -> list[dict[str, list]]:
        return nodes(chain, self.gravity)

    def _run(self, algorithm: Algorithm, *parts: Sequence[Mapping[str, list]]) -> tuple[list, list]:
        chain = seen_by(self.chain, algorithm)
        places = self._nodes(chain)
        links = [dict(c) for c in self.constants]
        for part in parts:
            for link, more in zip(links, part, strict=True):
                link.update(more)
        return execute(chain, algorithm, links, places, self.apply), places

    def motion(self, q: Sequence, v: Sequence) -> list[dict[str, list]]:
        """Coordinates, rates and internal states, link by link."""
        position, velocity = self.chain.split(q, "q", "eta"), self.chain.split(v, "qdot", "etadot")
        return [a | b for a, b in zip(position, velocity, strict=True)]

    def _state(self, q: Sequence, v: Sequence) -> list[dict[str, list]]:
        return self._with_terms(self.motion(q, v))

    def _with_terms(self, state: Sequence[Mapping], *parts: str) -> list[dict[str, list]]:
        """The state with inertia and force of modes and joints, or of the named ``parts`` alone."""
        return [dict(x) | self._terms(i, x, parts) for i, x in enumerate(state)]

    def _terms(self, i: int, x: Mapping[str, list], parts: Sequence[str]) -> dict[str, list]:
        out: dict[str, list] = {}
        spans = self.chain.coordinate_spans(i)
        below, gear = (spans.pop(part, None) for part in ("below", "between"))
        for part, span in spans.items():
            if not isinstance(part, str):
                continue
            if self.given is not None:
                out |= {f"{name}_{part}": list(column[span]) for name, column in zip("mf", self.given, strict=True)}
            elif not parts or part in parts:
                M, K, D = (self.constants[i][name] for name in COLUMNS[part])
                pairs = zip(K, stretched(self.chain.keys[i], x, part), D, x[f"{part}dot"], strict=True)
                out |= {f"m_{part}": list(M), f"f_{part}": [k * a + d * b for k, a, d, b in pairs]}
        out |= {} if below is None else self._coupled_terms(i, x, below, out["f_eta"])
        key = self.chain.keys[i]
        return self._axis_terms(i, x, gear, out) if gear is not None or key.laws else out

    def _axis_terms(self, i: int, x: Mapping[str, list], span: slice | None, out: dict[str, list]) -> dict[str, list]:
        """What gears and laws add to the forces of joint and rotors, unless they are given."""
        key, own = self.chain.keys[i], self.constants[i]
        if self.given is not None:
            return out | ({} if span is None else {"m_gear": list(self.given[0][span])})
        if "f_q" not in out:
            return out
        out |= {part: list(out[part]) for part in ("f_q", "f_theta") if part in out}
        if span is not None:
            M, K, D = (own[name] for name in COLUMNS["between"])
            out["m_gear"] = list(M)
            for n, axis in enumerate(key.added_axes):
                out["f_theta"][n] = out["f_theta"][n] + K[n] * x["q"][axis] + D[n] * x["qdot"][axis]
                out["f_q"][axis] = out["f_q"][axis] + K[n] * x["theta"][n] + D[n] * x["thetadot"][n]
        for acting in self.laws(i, x):
            part, n = acting.place
            out[f"f_{part}"][n] = out[f"f_{part}"][n] + acting.values["force"]
        return out

    def laws(self, i: int, x: Mapping[str, list]) -> Iterator[ActingLaw]:
        """What laws do on a link's coordinates in the state ``x``."""
        key = self.chain.keys[i]
        for law, places, sides in of_link(key):
            given = {name: self.constants[i][name] for name in law.constants}
            given |= {"x": [x[part][n] for part, n in places], "w": [x[f"{part}dot"][n] for part, n in places]}
            given |= (
                {"z": [z for z, own in zip(x["z"], key.internal, strict=True) if own.law == law]} if law.state else {}
            )
            given |= {"axis": [x["q"][key.added_axes[n]] for _, n in places]} if law.beside else {}
            found = self.apply(i, -1, forces(law, sides), given)
            for k, place in enumerate(places):
                yield ActingLaw(law, place, k, {name: values[k] for name, values in found.items()})

    def internal_rates(self, q: Sequence, v: Sequence) -> list:
        """The rates of the internal states."""
        of_laws = [x for link in self.link_internal_rates(self.motion(q, v)) for x in link["zdot"]]
        return of_laws + (self.force_rates(q, v, self.remembered(v), 0.0) if self.chain.n_force_states else [])

    def memory_rates(self, q: Sequence, v: Sequence, start: Sequence, h: Value) -> list[Value]:
        """The rates of what held laws remember, the means over ``h`` from the states ``start``."""
        if not self.chain.n_held_states:
            return []
        links = self._run(MEMORY, self.motion(q, v), self.of_links(self.acting or [0.0] * self.chain.n_joints))[0]
        gains, decays = ([x for link in links for x in link[f"memory_{name}"]] for name in ("gain", "decay"))
        return [(g - d * z) / (1.0 + h * d) for g, d, z in zip(gains, decays, start, strict=True)]

    def link_internal_rates(self, state: Sequence[Mapping[str, list]]) -> list[dict[str, list]]:
        """The same link by link in a motion."""
        laws = [list(self.laws(i, x)) if self.chain.keys[i].internal else [] for i, x in enumerate(state)]
        return [{"zdot": [one.values["rate"] for one in own if "rate" in one.values]} for own in laws]

    def _coupled_terms(self, i: int, x: Mapping[str, list], span: slice, force: Sequence) -> dict[str, list]:
        """The inertia of coupled modes; their forces are added to ``force`` unless they are given."""
        if self.given is not None:
            return {"m_below": list(self.given[0][span])}
        M, K, D = (self.constants[i][name] for name in COLUMNS["below"])
        out = list(force)
        for (a, b), k, d in zip(self.chain.keys[i].coupled, K, D, strict=True):
            out[a] = out[a] + k * x["eta"][b] + d * x["etadot"][b]
            out[b] = out[b] + k * x["eta"][a] + d * x["etadot"][a]
        return {"m_below": list(M), "f_eta": out}

    def _wrenches(self, w_ext: Sequence) -> list[dict[str, list]]:
        return [{"w_ext": list(w_ext[6 * i : 6 * i + 6])} for i in range(self.chain.n)]

    def forward_dynamics(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> tuple[list, list]:
        """``vdot`` and the joint wrenches, link by link."""
        return self.watched_dynamics(q, v, tau, w_ext)[:2]

    def watched_dynamics(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> tuple[list, list, list]:
        """``vdot``, the joint wrenches, and the inputs of :meth:`measures`, link by link."""
        links, _ = self.forward(q, v, *self.with_loops(q, v, tau, w_ext))
        wrench = [x for link in links for x in link["wrench"]]
        vdot = self.chain.join(links, "qddot", "etaddot")
        if self.chain.n_internal and self.given is None:  # integrators that give forces find these rates themselves
            vdot += self.under_inputs(tau).internal_rates(q, v)
        return vdot, wrench, axial_motions(links)

    def forward(self, q: Sequence, v: Sequence, tau: Sequence, w_ext: Sequence) -> tuple[list, list]:
        """The links and the nodes of the open tree after forward dynamics."""
        return self.falling(tau)._run(FORWARD, self._state(q, v), self.of_links(tau), self._wrenches(w_ext))

    def measures(self, q: Sequence, wrench: Sequence, motion: Sequence) -> list:
        """How far every link is from the limits of the model, four numbers each; see :mod:`..bodies.validity`."""
        n, eta = range(self.chain.n), self.chain.split(q, "q", "eta")
        given = [{"wrench": list(wrench[6 * i : 6 * i + 6]), "motion": list(motion[4 * i : 4 * i + 4])} for i in n]
        return [x for link in self._run(MEASURING, eta, given)[0] for x in link["measures"]]

    def measures_at_rest(self, q: Sequence, w_ext: Sequence) -> list:
        """The measures at rest in a held posture."""
        rest = [0.0] * self.chain.nv
        still = self.chain.split(rest, "qddot", "etaddot")
        wrenches = self._wrenches(self.with_forces(q, rest, w_ext))
        links, _ = self._run(INVERSE, self._state(q, rest), still, wrenches)
        return self.measures(q, [x for link in links for x in link["wrench"]], axial_motions(links))

    def inverse_dynamics(self, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence) -> list:
        """Inverse dynamics: the generalised forces of a given motion."""
        return self.loads(q, v, vdot, w_ext)[0]

    def loads(self, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence) -> tuple[list, list]:
        """The generalised forces of a given motion, and the joint wrenches, link by link."""
        motion = self.chain.split(vdot, "qddot", "etaddot")
        wrenches = self._wrenches(self.with_forces(q, v, w_ext))
        links, _ = self._run(INVERSE, self._state(q, v), motion, wrenches)
        return self.chain.join(links, "force", "force_eta"), [x for link in links for x in link["wrench"]]

    def statics(self, q: Sequence, w_ext: Sequence) -> tuple[list, list]:
        """The same at rest."""
        rest = [0.0] * self.chain.nv
        return self.loads(q, rest, rest, w_ext)

    def levers(self, q: Sequence) -> list:
        """What the torque of each axis is multiplied by: the travel of its transmission per rad, or 1."""
        return [x for link in self._run(LEVERS, self.chain.split(q, "q", "eta"))[0] for x in link["levers"]]

    def held(self, q: Sequence, v: Sequence, tau: Sequence) -> list:
        """What a step that begins here holds of its inputs; those behind torques are held as they are."""
        links = self._run(HOLD, self.motion(q, v), self.of_links(tau))[0]
        return [x for link in links for x in link["held"]] + list(tau[self.chain.n_joints :])

    def cylinder_lengths(self, q: Sequence) -> list:
        """The lengths of all cylinders."""
        links = self._run(CYLINDERS, self.chain.split(q, "q", "eta"))[0]
        lengths = [x for link in links for x in link["cylinder_length"]]
        return [lengths[joint] for joint in self.chain.cylinders]

    def sensitivities(
        self, q: Sequence, v: Sequence, vdot: Sequence, w_ext: Sequence, tau: Sequence
    ) -> list[dict[str, list]]:
        """The first-order changes of every link's motion and loads at given accelerations; see :mod:`.linearise`."""
        motion = self.chain.split(vdot, "qddot", "etaddot")
        given = self._state(q, v), motion, self._wrenches(w_ext), self.of_links(tau)
        return self.falling(tau)._run(SENSITIVITY, *given)[0]

    def poses(self, q: Sequence) -> tuple[list, list]:
        """Rotation (row by row) and position of every link frame and of every tip section."""
        links, places = self._run(PLACES, self.chain.split(q, "q", "eta"))
        tips = places[1 : self.chain.n + 1]
        return [(link["R"], link["r"]) for link in links], [(node["R"], node["r"]) for node in tips]

    def coordinate_rates(self, q: Sequence, v: Sequence) -> list:
        """``dq/dt``: the rates themselves, but for joints whose coordinates do not add up."""
        return rates(self.chain, q, v, self.apply)

    def energy(self, q: Sequence, v: Sequence) -> tuple[Value, Value]:
        """Kinetic and potential energy; that of forces with inputs is of :meth:`under_inputs`."""
        gravity = [{"gravity": list(self.gravity)}] * self.chain.n
        links, _ = self._run(ENERGY, self._state(q, v), gravity)
        return sum_of(links, "kinetic"), sum_of(links, "potential") + self.energy_of_forces(q, v)


def stretched(key: LinkClass, x: Mapping[str, list], part: str) -> Sequence[Value]:
    """The coordinates that springs stretch, one for each rate; a joint whose coordinates do not add up has none."""
    return [0.0] * key.joints if part == "q" and key.joint.curved else x[part]


def axial_motions(links: Sequence[Mapping[str, list]]) -> list:
    """The inputs of the measures from a motion, four numbers per link; zero for links without bending modes."""
    return [x for link in links for x in link.get("motion", [0.0] * 4)]


def sum_of(links: Sequence[Mapping[str, list]], name: str) -> Value:
    total: Value = 0.0
    for link in links:
        total = total + link[name][0]
    return total
