"""Linear models about a state: A, B, C, D with names and units, from exact derivatives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .. import notebook
from ..algorithms.entry_names import entry_units, names_in
from ..algorithms.gauges import base_strains, strain_names
from ..algorithms.linear_model import OUTPUTS as OUTPUT_PARTS
from ..algorithms.linear_model import SENSED
from ..algorithms.robot_functions import of_sensors
from ..arguments import Given, Loads, Numbers, array, choice, nearest
from ..backends.numpy.numeric import Numeric
from ..errors import UnknownNameError, UsageError
from ..lazily import linalg
from ..robot_model import RobotModel
from ..simulation.definiteness import check_definite
from ..simulation.mobility import motions
from ..spec.inputs import input_units
from ..spec.load import one_line
from ..spec.parameters import WRENCH, changes, coordinate_names, coordinate_units, rate_units
from ..topology.chain import Chain

OUTPUTS = ("joint_angles", "tip_position")
INPUTS = ("torques",)
TIP_UNITS = {"position": "m", "velocity": "m/s", "acceleration": "m/s²"}
WRENCH_UNITS = tuple((part, "N" if part.startswith("F") else "N·m") for part in WRENCH)


@dataclass(frozen=True, eq=False, repr=False)
class LinearModel:
    """A robot's small motions δ about a state: `d/dt (x + δx) = [v; vdot] + A δx + B δu`, `y + δy = y + C δx + D δu`.

    The state is x = [q; v], the joints' and modes' coordinates and their rates, d of each: of a robot with loops those
    that the loops leave independent. A floating base has six in place of its pose: the rotation vector and the
    displacement from where it would be, in axes of F_1, zero at the state linearised at; a ball joint has the rotation
    vector in axes of its link. Unpacks as `A, B, C, D`, as in
    `control.ss(*linear)`, and `linear[0]` is A; `linear[outputs, inputs]` is the model of some outputs and inputs
    alone, by names, numbers or slices. SI units, radians.
    """

    A: np.ndarray
    """(2 d, 2 d): with the state."""
    B: np.ndarray
    """(2 d, inputs)."""
    C: np.ndarray
    """(outputs, 2 d)."""
    D: np.ndarray
    """(outputs, inputs): not zero for accelerations and wrenches."""
    state_names: tuple[str, ...]
    input_names: tuple[str, ...]
    output_names: tuple[str, ...]
    state_units: tuple[str, ...]
    input_units: tuple[str, ...]
    output_units: tuple[str, ...]
    x: np.ndarray
    """(2 d,): the state linearised at, [q; v]."""
    u: np.ndarray
    """(inputs,): the inputs there."""
    y: np.ndarray
    """(outputs,): the outputs there."""
    tau: np.ndarray
    """(n_tau,): all torques there, N·m."""
    w_ext: np.ndarray
    """(n, 6): the external wrenches there, [τ; F] on each tip section, tip-frame components."""
    vdot: np.ndarray
    """(nvz,): the accelerations there, zero in equilibrium; the linear model omits them."""
    parameters: np.ndarray
    """The parameter values used."""

    def __iter__(self) -> Iterator[np.ndarray]:
        return iter((self.A, self.B, self.C, self.D))

    def __len__(self) -> int:
        return 4

    def __getitem__(self, key: Any) -> Any:
        """One of `A, B, C, D` for a number; for a pair the model of these outputs and inputs."""
        if not isinstance(key, tuple):
            return tuple(self)[key]
        if len(key) != 2:
            raise UsageError(f"a linear model has no {len(key)} axes; give linear[outputs, inputs]")
        i, j = _places(key[0], self.output_names, "outputs"), _places(key[1], self.input_names, "inputs")
        named: dict[str, Any] = {
            f"{part}_{kind}": tuple(getattr(self, f"{part}_{kind}")[k] for k in places)
            for part, places in (("output", i), ("input", j))
            for kind in ("names", "units")
        }
        return replace(self, B=self.B[:, j], C=self.C[i], D=self.D[np.ix_(i, j)], u=self.u[j], y=self.y[i], **named)

    def __repr__(self) -> str:
        sizes = f"{len(self.A)} states, {self.B.shape[1]} inputs, {len(self.C)} outputs"
        return f"<LinearModel: {sizes}; {', '.join(self.input_names)} -> {', '.join(self.output_names)}>"

    def _repr_html_(self) -> str:
        """Inputs and outputs with their values at the point of linearisation, and the poles."""
        parts = (("input", self.u), ("output", self.y), ("state", self.x))
        rows = [
            (part, *row)
            for part, values in parts
            for row in zip(getattr(self, f"{part}_names"), values, getattr(self, f"{part}_units"), strict=True)
        ]
        poles = [(notebook.number(p.real), notebook.number(p.imag)) for p in self.eigenvalues() if p.imag >= 0]
        title = f"LinearModel: {len(self.A)} states"
        named = notebook.table(title, ("", "name", "linearised at", "unit"), rows)
        return named + notebook.table("poles, 1/s", ("real", "± imaginary"), poles)

    def scipy(self) -> Any:
        """The model as SciPy's continuous-time StateSpace; needs an input, an output and a state."""
        if 0 in (*self.B.shape, len(self.C)):
            size = f"{len(self.A)} states, {self.B.shape[1]} inputs and {len(self.C)} outputs"
            raise UsageError(f"the linear model has {size}; SciPy needs at least one of each")
        import scipy.signal

        return scipy.signal.StateSpace(*self)

    def labels(self, separator: str = "/") -> dict[str, list[str]]:
        """The names as `control.ss(*linear, **linear.labels())` takes them: it allows no dots."""
        kinds = {"states": self.state_names, "inputs": self.input_names, "outputs": self.output_names}
        return {kind: [name.replace(".", separator) for name in names] for kind, names in kinds.items()}

    def eigenvalues(self) -> np.ndarray:
        """The poles (2 d,) in 1/s, by imaginary part, then by real part."""
        poles = np.linalg.eigvals(self.A).astype(complex)
        return poles[np.lexsort((poles.real, poles.imag))]

    def response(self, frequencies: Numbers) -> np.ndarray:
        """The frequency response `C (2πjf − A)⁻¹ B + D` (frequencies, outputs, inputs), at frequencies in Hz."""
        f = np.asarray(frequencies, float)
        if f.ndim != 1 or not np.isfinite(f).all():
            raise UsageError("the frequencies are no row of finite numbers; give a list of Hz")
        shifted = 2j * np.pi * f[:, None, None] * np.eye(len(self.A)) - self.A
        try:
            return self.C @ np.linalg.solve(shifted, np.broadcast_to(self.B, (len(f), *self.B.shape))) + self.D
        except np.linalg.LinAlgError:
            raise UsageError("a frequency is a pole of the robot, such as 0 Hz of a free joint; leave it out") from None


def _places(key: Any, names: Sequence[str], what: str) -> list[int]:
    """Which of the names a name, a number, a slice or a sequence of them stands for."""
    if isinstance(key, slice):
        return list(range(len(names)))[key]
    several = [key] if isinstance(key, str | int | np.integer) else list(key)
    try:
        return [
            names.index(choice(k, names, f"{what}: there is no")) if isinstance(k, str) else range(len(names))[k]
            for k in several
        ]
    except (IndexError, TypeError):
        raise UsageError(f"{what}: {key!r} is none of {len(names)}; give names, numbers or a slice") from None


def linearise(
    model: RobotModel,
    q: Numbers,
    v: Numbers | None = None,
    tau: Loads = None,
    w_ext: Loads = None,
    parameters: Given = None,
    outputs: Sequence[str] | str = OUTPUTS,
    inputs: Sequence[str] | str = INPUTS,
) -> LinearModel:
    """What `Model.linearise` does."""
    chain = model.chain
    numbers = Numeric(chain, chain.parameters.vector(parameters))
    q, v, tau = (
        whole(chain, q, numbers.p),
        checked(chain.with_internal(v), "v", chain.nvz),
        checked(tau, "tau", chain.n_tau),
    )
    w_ext = chain.tip_wrenches(w_ext, "w_ext:")
    givers, takers, sensors = input_groups(chain), output_groups(chain), sensor_groups(chain)
    columns, rows = chosen(inputs, givers, "inputs"), chosen(outputs, takers, "outputs", sensors)
    read = [name for name, group in sensors.items() if not group.keys().isdisjoint(rows)]
    takers |= {name: sensors[name] for name in read}
    places = {name: k for k, name in enumerate(entries(takers))}
    own, T = with_internal_states(chain, *motions(model, q, v, numbers.p))
    check_definite(model, q, numbers.p)
    numbers.forward_dynamics(q, v, tau, w_ext)  # names the joint where the posture is singular
    vdot, y, vdot_x, y_x = _changes(model, read, q, v, tau, w_ext.T, numbers.p)
    (vdot_x, vdot_u), (y_x, y_u) = (np.split(slopes, [chain.nv + chain.nvz], axis=1) for slopes in (vdot_x, y_x))
    i, j = [places[name] for name in rows], list(columns.values())
    states = state_names(chain)
    turned = np.hstack([chain.carried(v), np.eye(chain.nv, chain.nvz)])
    A = np.vstack([turned, vdot_x])[own] @ T
    return LinearModel(
        A=A,
        B=np.vstack([np.zeros((chain.nv, vdot_u.shape[1])), vdot_u])[np.ix_(own.tolist(), j)],
        C=y_x[i] @ T,
        D=y_u[np.ix_(i, j)],
        state_names=tuple(list(states)[k] for k in own),
        input_names=tuple(columns),
        output_names=tuple(rows),
        state_units=tuple(list(states.values())[k] for k in own),
        input_units=tuple(entries(givers)[name] for name in columns),
        output_units=tuple(entries(takers)[name] for name in rows),
        x=np.concatenate([chain.flat(q), v])[own],
        u=np.concatenate([tau, w_ext.ravel()])[j],
        y=y[i],
        tau=tau,
        w_ext=w_ext,
        vdot=vdot,
        parameters=np.array(numbers.p),
    )


def _changes(model: RobotModel, sensors: Sequence[str], *point: Numbers) -> tuple[np.ndarray, ...]:
    """vdot (nvz,), y, and the derivatives of both with [δ; v; tau; w_ext], at `(q, v, tau, w_ext, p)`.

    y ends with what ``sensors`` read.
    """
    from ..backends.casadi.linear import linear_model

    read = [row for row in of_sensors(model.chain) if row.name in sensors]
    key = ("linear_model", *sensors) if sensors else "linear_model"
    function = model.once(key, lambda: linear_model(model.chain, read))
    sizes = [model.nv, *(np.size(x) for x in point[1:-1])]
    directions = np.split(np.eye(sum(sizes)), np.cumsum(sizes)[:-1])
    found = dict(zip(function.name_out(), map(np.array, function(*point, *directions)), strict=True))
    parts = (*OUTPUT_PARTS, *(SENSED + row.name for row in read))
    y, slopes = (np.vstack([found[name + end] for name in parts]) for end in ("", "_along"))
    return found["vdot"][:, 0], y[:, 0] + 0.0, found["vdot_along"] + 0.0, slopes + 0.0


def with_internal_states(chain: Chain, own: np.ndarray, T: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The places of the states among [δ; v], and all changes by theirs, from those of independent coordinates."""
    behind = np.arange(2 * chain.nv, chain.nv + chain.nvz)
    return np.concatenate([own, chain.nv + own, behind]), linalg.block_diag(T, np.eye(len(behind)))


def whole(chain: Chain, q: Numbers | None, p: Numbers) -> np.ndarray:
    """The coordinates (nq,) of a posture: as given, the joints alone, or where everything is zero."""
    given = np.zeros(0)
    if q is not None:
        given = checked(q, "q", chain.n_redundant if np.size(q) == chain.n_redundant else chain.nq)
    found = chain.complete(given, p)
    if isinstance(found, str):
        raise UsageError(f"q: {found}")
    return found


# ------------------------------------------------------------------------------ names


def state_names(chain: Chain) -> dict[str, str]:
    """The names of the entries of [δ; v], with their units."""
    return changes(chain.robot) | rates(chain)


def rates(chain: Chain) -> dict[str, str]:
    """The names of the entries of v, with their units."""
    return dict(zip(coordinate_names(chain.robot).v, rate_units(chain.robot), strict=True))


Groups = dict[str, dict[str, str]]
"""Entries and their units by group."""


def input_groups(chain: Chain) -> Groups:
    """The inputs in the order of u = [tau; w_ext]; `tip_wrench` is that on the last tip."""
    wrenches = [(f"{s.tipped}.w_ext.{part}", unit) for s in chain.segments for part, unit in WRENCH_UNITS]
    torques = dict(zip(coordinate_names(chain.robot).tau, input_units(chain.robot), strict=True))
    return {"torques": torques, "wrenches_on_tips": dict(wrenches), "tip_wrench": dict(wrenches[-6:])}


def output_groups(chain: Chain) -> Groups:
    """The outputs in the order of y."""
    names, m, n = coordinate_names(chain.robot), chain.n_joints, chain.n_redundant
    q = [*zip(names.q, coordinate_units(chain.robot), strict=True)]
    v, a, b = [*rates(chain).items()], chain.base_q, chain.base_v
    parts = {
        "base_pose": q[:a],
        "joint_angles": q[a : a + n],
        "rotor_angles": q[a + n : chain.eta_q],
        "modes": q[chain.eta_q :],
        "base_twist": v[:b],
        "joint_rates": v[b : b + m],
        "rotor_rates": v[b + m : chain.eta_v],
        "mode_rates": v[chain.eta_v : chain.nv],
        "internal_states": v[chain.nv :],
    }
    named = {
        name: dict(own) for name, own in parts.items() if own or not name.startswith(("rotor", "base", "internal"))
    }
    tip = {f"tip_{what}": {f"tip_{what}.{axis}": unit for axis in "xyz"} for what, unit in TIP_UNITS.items()}
    wrenches = dict(zip(names.wrench, [unit for _, unit in WRENCH_UNITS] * chain.n, strict=True))
    gauged = strain_names(chain)
    at_bases = dict([*gauged.items()][: base_strains(chain)])
    return {**named, **tip, "wrenches": wrenches, "base_strain": at_bases, "strain": gauged}


def sensor_groups(chain: Chain) -> Groups:
    """What sensors read, by the names of their functions: outputs of who asks for them, behind all others."""
    own = {row.name: dict(zip(names_in(row, chain), entry_units(row, chain), strict=True)) for row in of_sensors(chain)}
    if twice := own.keys() & output_groups(chain).keys():
        raise UsageError(f"sensors: '{min(twice)}' is a group of outputs of linear models; take another name")
    return own


def entries(groups: Groups) -> dict[str, str]:
    """All entries with their units; one that is in two groups has the first one's place."""
    return {name: unit for group in groups.values() for name, unit in group.items()}


SYMBOLS = {"tau": "torques", "w_ext": "wrenches_on_tips"}
"""Groups by the names that functions have for them."""


def chosen(given: Sequence[str] | str, groups: Groups, what: str, further: Groups | None = None) -> dict[str, int]:
    """The entries that names of groups or of entries choose, in their order, each with its place.

    ``further`` groups stand behind the others; a name means one of theirs where it means none of the others.
    """
    places = {name: k for k, name in enumerate(entries(groups | (further or {})))}
    out: list[str] = []
    for name in [given] if isinstance(given, str) else given:
        out += _members(str(name), groups, further or {}, what)
    return {name: places[name] for name in out}


def _members(name: str, groups: Groups, further: Groups, what: str) -> list[str]:
    """The entries that a name stands for in the first of both that knows it; a group may have none."""
    for known in (groups, further):
        if (found := _own_members(name, known, list(entries(known)))) is not None:
            return found
    names, every = [*entries(groups), *entries(further)], [*groups, *further]
    hint = nearest(name, [*every, *names]) or f"or entries of them, such as '{names[0]}'"
    raise UnknownNameError(f"{what}: there is no '{one_line(name)}'; choose of {', '.join(every)}; {hint}")


def _own_members(name: str, groups: Groups, names: Sequence[str]) -> list[str] | None:
    """The entries of a group, the one entry, all below a name (`forearm.tau`: the torques there), or None."""
    if (group := SYMBOLS.get(name, name)) in groups:
        return list(groups[group])
    if name in names:
        return [name]
    link, dot, rest = name.partition(".")
    torque = rest == "tau" or rest.startswith("tau[")
    whole = [f"{link}{dot}{kind}{rest[3:]}" for kind in ("torque", "force")] if torque else [name]
    return [x for x in names if x in whole or x.startswith(tuple(w + c for w in whole for c in ".["))] or None


def checked(values: Any, name: str, size: int) -> np.ndarray:
    """`values` as a row of `size` finite numbers; zeros if None."""
    return array(values, f"{name}:", (size,))
