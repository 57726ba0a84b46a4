"""Independent physics oracle: Lagrange's equations of the kinematic field, by quadrature and AD.

The judge of the package's formulas; it imports nothing from `screwgen`. A robot is the plain dict that
`tomllib` reads from a robot file. The field is small-deformation Euler-Bernoulli with the next link turned by
the tip section: every link is a cloud of Gauss-Legendre elements, plus rigid bodies. Kinetic and potential
energy are summed over that cloud as CasADi SX expressions; everything else is their automatic derivative.
Joint wrenches come from the balance of linear and angular momentum of the outboard links, not from the
equations of motion.

Units are SI, angles radians. `q = [joint coordinates, link by link; modal coordinates, link by link]`,
`v = dq/dt`. Twists and wrenches have the angular part first. `w_ext[i]` acts at link i's tip point, in
tip-frame components. `wrench[i]` is what link i-1 (or the base) exerts on link i, at the joint point, in F_i
components. F_i is the link's frame: x along the undeformed centreline, origin at `frame_at` from the joint. Angles of
rotors (elastic drives) stand between joints and modes.
"""

from __future__ import annotations

from functools import cached_property

import casadi as ca
import numpy as np
import scipy.linalg
from oracle_cloud import Cloud, build_cloud, gradient, modal_slices, per_column, rates, slices
from oracle_drives import Drives
from oracle_link import read_link
from oracle_stations import place_of, section
from oracle_stops import Stops

LOCKED = 1e-8
"""The share of what was subtracted from it below which a number counts as rounding."""


def part_error(reference, value, companion, taken=()) -> float:
    """Largest error over the largest entry of `reference`; see `Oracle.errors` for the companion.

    `taken`: what was subtracted from numbers as large to get the reference, such as accelerations that loops take away;
    it counts where nothing else is left.
    """
    largest = lambda x: float(np.max(np.abs(x), initial=0.0))  # noqa: E731
    locked = largest(taken) if largest(reference) < LOCKED * largest(taken) else 0.0
    return largest(value - reference) / (max(largest(reference), locked, 1e-4 * largest(companion)) or 1.0)


def parents_of(links: list[dict]) -> list[int]:
    """The number of the link that carries each link, -1 for the world."""
    places = {link["name"]: i for i, link in enumerate(links)} | {"world": -1}
    return [places[link["parent"]] if "parent" in link else i - 1 for i, link in enumerate(links)]


class Oracle:
    """Dynamics of one robot (a plain dict). Functions are built when first used; see the module's docstring.

    Attributes: n (links), n_joint (joint coordinates), nv, links, K (nv, nv: modal and joint stiffness),
    damping (nv,), armature (nv,), joint_slices: where each link's joint coordinates sit in q, modal_slices.
    """

    def __init__(self, robot: dict, extra_nodes: int = 0):
        self.robot = robot
        self.links = [read_link(link, extra_nodes, robot.get("order", 1)) for link in robot["links"]]
        self.n = len(self.links)
        self.parents = parents_of(robot["links"])
        self.gravity = np.array(robot["gravity"], dtype=float)
        self.joint_slices = slices([len(link.axes) for link in self.links])
        self.n_joint = self.joint_slices[-1].stop
        drives = [drive for link in self.links for drive in link.drives]
        self.n_rotor = sum("stiffness" in drive for drive in drives)
        self.modal_slices = slices([len(link.damping) for link in self.links], self.n_joint + self.n_rotor)
        self.nv = self.modal_slices[-1].stop
        self.stops = Stops([limit for link in self.links for limit in link.limits])
        self.drives, rotors = Drives(drives, self.nv), np.zeros(self.n_rotor)
        self.K = self.drives.K + scipy.linalg.block_diag(
            *[np.diag(link.joint_stiffness) for link in self.links],
            *[np.zeros((1, 1))] * self.n_rotor,
            *[link.K for link in self.links],
        )
        self.damping = np.concatenate(
            [link.joint_damping for link in self.links] + [rotors] + [link.damping for link in self.links]
        )
        self.D = self.drives.D + np.diag(self.damping)
        for link, table, modal in zip(self.links, robot["links"], self.modal_slices, strict=True):
            self.D[modal, modal] += table.get("damping", {}).get("time", 0.0) * link.K
        self.armature = self.drives.inertia.copy()
        self.armature[: self.n_joint] += np.concatenate([link.armature for link in self.links])
        self.q, self.v, self.a, self.trial = (ca.SX.sym(name, self.nv) for name in ("q", "v", "a", "trial"))
        self.w_ext = ca.SX.sym("w_ext", 6, self.n)

    # ---------------------------------------------------------------------------------------- expressions

    @cached_property
    def clouds(self) -> list[Cloud]:
        """Every link's cloud as a function of q, with its rates along v."""
        return self._with_rates(self._place(), self.v)

    def _place(self) -> list[Cloud]:
        clouds: list[Cloud] = []
        follow = self.robot.get("section_rotation", True)
        parts = zip(self.links, self.parents, self.joint_slices, self.modal_slices, strict=True)
        for i, (link, parent, joints, modal) in enumerate(parts):
            R, point = (ca.SX(np.eye(3)), ca.SX.zeros(3)) if parent < 0 else self.carrying(i, parent, clouds[parent])
            angles = [self.q[i] for i in range(joints.start, joints.stop)]
            where = modal_slices(link, modal.start)
            clouds.append(build_cloud(link, self.q, angles, where, R, point, follow))
        return clouds

    def carrying(self, i: int, parent: int, cloud: Cloud) -> tuple[ca.SX, ca.SX]:
        """Rotation and place of the section of its parent at which link i is carried."""
        return self.section(parent, cloud, place_of(self.robot, i, parent))

    def section(self, i: int, cloud: Cloud, s: float) -> tuple[ca.SX, ca.SX]:
        """Rotation and place of a section of link i."""
        return section(self.robot["links"][i], self.links[i], cloud, self.q[self.modal_slices[i]], s, self.robot)

    def section_pose(self, i: int, q, s: float) -> tuple[np.ndarray, np.ndarray]:
        """Rotation (3, 3) and position (3,) of a section of link i in the inertial frame."""
        R, place = self._function([self.q], *self.section(i, self.clouds[i], s))(q)
        return R.full(), place.full()[:, 0]

    def _with_rates(self, clouds: list[Cloud], direction: ca.SX) -> list[Cloud]:
        moving = [getattr(cloud, name) for cloud in clouds for name in cloud.moving]
        values = iter(rates(moving, self.q, direction))
        for cloud in clouds:
            cloud.rate = {name: next(values) for name in cloud.moving}
        return clouds

    def along_motion(self, expressions: list[ca.SX]) -> list[ca.SX]:
        """d/dt of functions of (q, v), along (v, a)."""
        return rates(expressions, ca.vertcat(self.q, self.v), ca.vertcat(self.v, self.a))

    @cached_property
    def kinetic(self) -> ca.SX:
        rotors = ca.dot(ca.DM(self.armature) * self.v, self.v) / 2 + self.drives.kinetic(self.q, self.v)
        return sum(cloud.kinetic() for cloud in self.clouds) + rotors

    @cached_property
    def potential(self) -> ca.SX:
        weight = -ca.dot(ca.DM(self.gravity), sum(cloud.first_moment() for cloud in self.clouds))
        return weight + ca.dot(self.q, ca.DM(self.K) @ self.q) / 2 + self.stops.potential(self.q)

    @cached_property
    def external_power(self) -> ca.SX:
        """Power of the tip wrenches: linear in v, its gradient is their generalised force."""
        return sum(ca.dot(self.w_ext[:, i], cloud.tip_twist()) for i, cloud in enumerate(self.clouds))

    def _function(self, inputs: list[ca.SX], *outputs: ca.SX) -> ca.Function:
        return ca.Function("f", inputs, [ca.densify(o) for o in outputs])

    @cached_property
    def _momentum(self) -> ca.Function:
        return self._function([self.q, self.v], gradient(self.kinetic, self.v))

    @cached_property
    def _inverse(self) -> ca.Function:
        """Lagrange: d/dt(∂T/∂v) - ∂T/∂q + ∂U/∂q + D v - external."""
        (inertial,) = self.along_motion([gradient(self.kinetic, self.v)])
        force = inertial - gradient(self.kinetic, self.q) + gradient(self.potential, self.q)
        force += self._losses() - gradient(self.external_power, self.v)
        return self._function([self.q, self.v, self.a, self.w_ext], force)

    @cached_property
    def _virtual(self) -> ca.Function:
        """d'Alembert: virtual power of every element's inertia and weight; accelerations, no energies."""
        trial = self._with_rates(self._place(), self.trial)
        power = sum(map(self._virtual_power, self.clouds, trial))
        springs = ca.DM(self.K) @ self.q + ca.gradient(ca.SX(self.stops.potential(self.q)), self.q)
        force = gradient(power, self.trial) + springs + self._losses()
        force += self.drives.pushed(self.q, self.v, self.a)
        force += ca.DM(self.armature) * self.a - gradient(self.external_power, self.v)
        return self._function([self.q, self.v, self.a, self.w_ext], force)

    def _losses(self) -> ca.SX:
        """(nv,): the forces of dampers, friction and stops that no potential has."""
        return ca.DM(self.D) @ self.v + self.drives.friction(self.q, self.v) + self.stops.losses(self.q, self.v)

    def _virtual_power(self, cloud: Cloud, trial: Cloud) -> ca.SX:
        momenta = [cloud.rate["points"], cloud.intrinsic_momentum(), cloud.tip_momentum(), cloud.turning[0]]
        acceleration, base, tip, turned = self.along_motion(momenta)
        weight = ca.repmat(ca.DM(self.gravity), 1, len(cloud.masses))
        power = ca.dot(per_column(acceleration - weight, cloud.masses), trial.rate["points"])
        if cloud.second is not None:
            later, undeformed = self.along_motion([cloud.rate["second"], cloud.rate["bare"]])
            power += ca.dot(per_column(later, cloud.masses), trial.rate["bare"])
            power += ca.dot(per_column(undeformed - weight, cloud.masses), trial.rate["second"])
        power += ca.dot(base, trial.R @ trial.omega) + ca.dot(tip, trial.tip_R @ trial.tip_omega)
        return power + ca.dot(turned, trial.turning[1])

    @cached_property
    def _wrench(self) -> ca.Function:
        """Balance of linear and angular momentum of link i and all that it carries; moments about the origin, then
        moved."""
        momenta = [m for cloud in self.clouds for m in (cloud.linear_momentum(), cloud.angular_momentum())]
        changes, columns = self.along_motion(momenta), []
        sums = [(ca.SX.zeros(3), ca.SX.zeros(3)) for _ in range(self.n + 1)]  # by link, the last one of the world
        for i in reversed(range(self.n)):
            cloud = self.clouds[i]
            load, torque = self._loads(i)
            force, moment = sums[i][0] + changes[2 * i] - load, sums[i][1] + changes[2 * i + 1] - torque
            sums[self.parents[i]] = (sums[self.parents[i]][0] + force, sums[self.parents[i]][1] + moment)
            about_joint = moment - ca.cross(cloud.joint_point, force)
            columns.insert(0, ca.vertcat(cloud.R.T @ about_joint, cloud.R.T @ force))
        return self._function([self.q, self.v, self.a, self.w_ext], ca.horzcat(*columns))

    def _loads(self, i: int) -> tuple[ca.SX, ca.SX]:
        """Weight and tip wrench of link i: force, moment about the inertial origin; inertial axes."""
        cloud, gravity = self.clouds[i], ca.SX(self.gravity)
        tip_force, tip_moment = cloud.tip_R @ self.w_ext[3:, i], cloud.tip_R @ self.w_ext[:3, i]
        moment = ca.cross(cloud.first_moment(), gravity) + ca.cross(cloud.tip_point, tip_force) + tip_moment
        return float(cloud.masses.sum()) * gravity + tip_force, moment

    @cached_property
    def _energy(self) -> ca.Function:
        (rate,) = self.along_motion([self.kinetic + self.potential])
        return self._function([self.q, self.v, self.a], self.kinetic, self.potential, rate)

    @cached_property
    def _motion(self) -> ca.Function:
        twists = [cloud.twist_vector() for cloud in self.clouds]
        tips = [cloud.tip_twist() for cloud in self.clouds]
        outputs = [ca.horzcat(*group) for group in (twists, tips, self.along_motion(twists))]
        return self._function([self.q, self.v, self.a], *outputs)

    @cached_property
    def _tip_rates(self) -> ca.Function:
        rates = self.along_motion([cloud.tip_twist() for cloud in self.clouds])
        return self._function([self.q, self.v, self.a], ca.horzcat(*rates))

    @cached_property
    def _total_momentum(self) -> ca.Function:
        linear = sum(cloud.linear_momentum() for cloud in self.clouds)
        return self._function([self.q, self.v], linear, sum(c.angular_momentum() for c in self.clouds))

    @cached_property
    def _poses(self) -> ca.Function:
        names = ("R", "tip_R", "origin", "joint_point", "tip_point")
        return self._function([self.q], *[ca.horzcat(*[getattr(c, n) for c in self.clouds]) for n in names])

    # ------------------------------------------------------------------------------------------- numbers

    def _w(self, w_ext) -> np.ndarray:
        return np.zeros((6, self.n)) if w_ext is None else np.array(w_ext, dtype=float).reshape(self.n, 6).T

    def _force(self, tau, q) -> np.ndarray:
        return np.zeros(self.nv) if tau is None else self.drives.applied(q, np.array(tau, float))

    def mass_matrix(self, q) -> np.ndarray:
        """M(q), (nv, nv): the momenta of unit velocities."""
        return self._momentum(np.tile(np.reshape(q, (-1, 1)), self.nv), np.eye(self.nv)).full()

    def condition(self, q) -> float:
        """Condition number of M(q); 1 where there is nothing to solve."""
        return float(np.linalg.cond(self.mass_matrix(q))) if self.nv else 1.0

    def inverse_dynamics(self, q, v, vdot, w_ext=None) -> np.ndarray:
        """M vdot + h, (nv,): all generalised forces, modal rows included."""
        return self._inverse(q, v, vdot, self._w(w_ext)).full()[:, 0]

    def virtual_power_dynamics(self, q, v, vdot, w_ext=None) -> np.ndarray:
        """The same as `inverse_dynamics` by d'Alembert's principle on the elements' accelerations."""
        return self._virtual(q, v, vdot, self._w(w_ext)).full()[:, 0]

    def bias(self, q, v, w_ext=None) -> np.ndarray:
        """h of M vdot + h = [tau; 0], (nv,)."""
        return self.inverse_dynamics(q, v, np.zeros(self.nv), w_ext)

    def wrenches(self, q, v, vdot, w_ext=None) -> np.ndarray:
        """(n, 6) joint wrenches [τ; F] for any motion, by momentum balance."""
        return self._wrench(q, v, vdot, self._w(w_ext)).full().T

    def tolerance(self, q) -> float:
        """Relative agreement that double precision allows: max(1e-10, 50 eps cond M)."""
        return max(1e-10, 50 * np.finfo(float).eps * self.condition(q))

    def errors(self, state: dict, vdot, wrench) -> dict[str, float]:
        """Errors of another's forward dynamics, of q̈, η̈, τ and F, each over the reference's largest entry.

        `state` has q, v, tau, w_ext. A part that all but vanishes is measured against 1e-4 of its companion
        (q̈ and η̈, τ and F), or absolutely where both vanish.
        """
        expected = self.parts(*self.forward_dynamics(**state))
        given = self.parts(np.array(vdot), np.reshape(wrench, (self.n, 6)))
        companion = {"qdd": "etadd", "etadd": "qdd", "tau": "F", "F": "tau", "thetadd": "qdd"}
        return {k: part_error(value, given[k], expected[companion[k]]) for k, value in expected.items()}

    def parts(self, vdot, wrench) -> dict[str, np.ndarray]:
        """Forward dynamics split into its parts of one unit each: four, and the rotors' if there are any."""
        joints, rotors, modal = np.split(vdot, [self.n_joint, self.n_joint + self.n_rotor])
        own = {"thetadd": rotors} if self.n_rotor else {}
        return {"qdd": joints, "etadd": modal, "tau": wrench[:, :3], "F": wrench[:, 3:]} | own

    def forward_dynamics(self, q, v, tau=None, w_ext=None) -> tuple[np.ndarray, np.ndarray]:
        """(vdot (nv,), wrench (n, 6)); one step of iterative refinement in the linear solve."""
        vdot, force = np.zeros(self.nv), self._force(tau, q)
        if self.nv:
            factors = scipy.linalg.lu_factor(self.mass_matrix(q))
            for _ in range(2):
                vdot = vdot + scipy.linalg.lu_solve(factors, force - self.inverse_dynamics(q, v, vdot, w_ext))
        return vdot, self.wrenches(q, v, vdot, w_ext)

    def energy(self, q, v) -> tuple[float, float]:
        """(kinetic, potential) in J."""
        kinetic, potential, _ = self._energy(q, v, np.zeros(self.nv))
        return float(kinetic), float(potential)

    def energy_rate(self, q, v, vdot) -> float:
        """d/dt(T + U) along a motion, in W."""
        return float(self._energy(q, v, vdot)[2])

    def power(self, q, v, tau=None, w_ext=None) -> float:
        """Power of motors and tip wrenches less what the dampers take, in W: equals the energy's rate."""
        v = np.array(v, dtype=float)
        twists = self.tip_twists(q, v)
        external = 0.0 if w_ext is None else float(np.sum(twists * np.reshape(w_ext, (self.n, 6))))
        losses = ca.Function("f", [self.q, self.v], [self._losses()])(q, v).full()[:, 0]
        return float(v @ self._force(tau, q) - v @ losses) + external

    def momentum(self, q, v) -> tuple[np.ndarray, np.ndarray]:
        """Linear momentum, and angular momentum about the inertial origin, of the whole arm; no armature."""
        return tuple(m.full()[:, 0] for m in self._total_momentum(q, v))

    def link_twists(self, q, v) -> np.ndarray:
        """(n, 6) twists [ω; v] of the link frames F_i, in F_i components."""
        return self._motion(q, v, np.zeros(self.nv))[0].full().T

    def link_twist_rates(self, q, v, vdot) -> np.ndarray:
        """(n, 6) time derivatives of the components that `link_twists` gives."""
        return self._motion(q, v, vdot)[2].full().T

    def tip_twists(self, q, v) -> np.ndarray:
        """(n, 6) twists of the tip frames, in tip-frame components."""
        return self._motion(q, v, np.zeros(self.nv))[1].full().T

    def tip_twist_rates(self, q, v, vdot) -> np.ndarray:
        """(n, 6) time derivatives of the components that `tip_twists` gives."""
        return self._tip_rates(q, v, vdot).full().T

    def poses(self, q) -> dict[str, np.ndarray]:
        """R, tip_R: (n, 3, 3) body to inertial; origin, joint_point, tip_point: (n, 3) inertial, m."""
        names = ("R", "tip_R", "origin", "joint_point", "tip_point")
        found = dict(zip(names, (m.full() for m in self._poses(q)), strict=True))
        split = lambda m: np.stack(np.hsplit(m, self.n))  # noqa: E731
        return {name: split(m) if name.endswith("R") else m.T for name, m in found.items()}

    def tip_pose(self, q) -> tuple[np.ndarray, np.ndarray]:
        """(R (3, 3), position (3,)) of the last link's tip frame in the inertial frame."""
        poses = self.poses(q)
        return poses["tip_R"][-1], poses["tip_point"][-1]

    def joint_axes(self, i: int, q) -> np.ndarray:
        """A(q) of joint i, (3, m): the axes in F_i components."""
        unit = np.eye(self.nv)[:, self.joint_slices[i]]
        relative = [self.link_twists(q, column)[i, :3] for column in unit.T]
        return np.array(relative).reshape(-1, 3).T

    def frequencies(self, q=None, joints: str = "locked") -> np.ndarray:
        """Natural frequencies in Hz, ascending, at rest without gravity; joints 'locked' or 'free'."""
        held = self.drives.driven if joints == "locked" else []
        keep = np.setdiff1d(np.arange(self.nv), held)
        M, K = self.mass_matrix(np.zeros(self.nv) if q is None else q), self.K
        values = scipy.linalg.eigh(K[np.ix_(keep, keep)], M[np.ix_(keep, keep)], eigvals_only=True)
        return np.sqrt(np.maximum(values, 0.0)) / (2 * np.pi)
