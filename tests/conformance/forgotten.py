"""The table of mutants: a feature that one consumer forgets, as a change of one place of one file.

`consumer`: the check of the matrix that looks at what is changed; others may find it first. Changes that alter nothing
but rounding are none: a quaternion that is not scaled to one stays near it for longer than any check runs.
"""

from __future__ import annotations

import random
from typing import NamedTuple

SEED = 38
ALGORITHMS, C, BODIES = "screwgen/algorithms/", "templates/c/", "screwgen/bodies/"


class Mutant(NamedTuple):
    """``old`` occurs once in the file, and ``new`` takes its place."""

    feature: str
    consumer: str
    file: str
    old: str
    new: str

    def __str__(self) -> str:
        return f"{self.feature} × {self.consumer} ({self.file.rpartition('/')[2]})"

    def applied(self, text: str) -> str:
        assert text.count(self.old) == 1, f"{self}: {self.old!r} occurs {text.count(self.old)} times"
        return text.replace(self.old, self.new)


def drawn() -> list[Mutant]:
    """All mutants in an order that is drawn once."""
    return random.Random(SEED).sample(TABLE, len(TABLE))


M = Mutant
TABLE: list[Mutant] = [
    # ------------------------------------------------------------------------------------- what all back ends share
    M("spring", "judge", ALGORITHMS + "axis_terms.py",
      "potential: Value = axis_energy(s, q)", "potential: Value = 0.0"),
    M("elastic gear", "judge", ALGORITHMS + "axis_terms.py",
      '        kinetic = kinetic + s.constant(f"rotor_inertia_{axis + 1}") * thetadot * thetadot\n', ""),
    M("elastic cylinder", "judge", ALGORITHMS + "axis_terms.py",
      'potential = potential + s.constant(f"rotor_stiffness_{axis + 1}") * theta * theta\n', "pass\n"),
    M("passive", "judge", ALGORITHMS + "motions.py",
      "added = mx.dot(qdot, armature(s) * qdot) + spin", "added = spin"),
    M("passive", "energy balance", ALGORITHMS + "motions.py",
      "(mx.dot(q * spring(s), q) if s.key.stiffness else 0.0) + wound", "wound"),
    M("rotor", "judge", ALGORITHMS + "phases.py",
      "mx.multiply(S.T, U) + mx.diagonal(own)", "mx.multiply(S.T, U)"),
    M("frame", "judge", BODIES + "link.py",
      "shifted = J + r_B @ S.T + S @ r_B.T + m @ (r_B @ r_B.T)", "shifted = J"),
    M("bodies", "judge", BODIES + "lumped.py",
      "        second = second + _second_moment(inertia)\n", ""),
    M("stretch and twist", "judge", BODIES + "rod.py",
      "                rate = rate + t.shapes @ etadot\n", "                pass\n"),
    M("shear", "judge", BODIES + "rod.py",
      "parts.append(whole @ (unit(axis) @ unit(axis).T))",
      "parts += [whole @ (unit(axis) @ unit(axis).T)] * (axis == 0)"),
    M("frequencies", "judge", BODIES + "rod_stiffness.py",
      "(2 * sp.pi) * f_n", "f_n"),
    M("stations", "judge", BODIES + "varying_rod.py",
      "for station, w in weights(self.key).at(s).items()",
      "for station, w in list(weights(self.key).at(s).items())[:1]"),
    M("profile", "judge", "screwgen/spec/profile.py", "self.density * (Iy + Iz)}", "self.density * Iy}"),
    M("exact fore", "judge", ALGORITHMS + "phases.py",
      's.keep("M_bent", -s.lower("link", {}, "M_Wphi")[0])', 's.keep("M_bent", mx.zeros(s.key.modes, s.key.modes))'),
    M("station", "judge", ALGORITHMS + "phases.py",
      'total = total + mx.shift_wrench(station.kept("r_T"), load)', "total = total + mx.zeros(6)"),
    M("screw", "judge", BODIES + "joint.py",
      'b.step("slip_rate", rate(motion.linear @ stack(*b.entries(qdot)), rates))', 'b.step("slip_rate", zeros(3))'),
    M("three axes", "judge", BODIES + "joint.py",
      "rate(motion.angular @ stack(*speeds), rates) if len(speeds) > 1 else zeros(3)",
      "rate(motion.angular @ stack(*speeds), rates) if len(speeds) == 2 else zeros(3)"),
    M("elements", "judge", BODIES + "reduced.py",
      "rest[np.abs(rest) < ROUNDING * np.abs(self.data.inertia).max()] = 0.0", "rest[:] = 0.0"),
    M("segments", "validity", BODIES + "validity.py",
      'mass = rhoA @ length\n', "mass = rhoA\n"),
    M("shared tendon", "energy balance", ALGORITHMS + "tendons.py",
      '-(s.read("tension") * rates) if s.key.tendons else rates', "rates if not s.key.tendons else 0.0 * rates"),
    M("cylinder", "energy balance", ALGORITHMS + "axis_terms.py",
      'rates[axis] = tm.travel_rate(s, axis, tm.of_axis(s, axis, s.read("q"))[0], s.read("qdot"))', "pass"),
    M("hinge loop", "judge", ALGORITHMS + "loops.py",
      "return mx.dot(x, y) - row.cosine, turn, -turn, mx.dot(a.omega - b.omega, c_rate)",
      "return mx.dot(x, y) - row.cosine, turn, -turn, 0.0"),
    M("markers", "sensors", ALGORITHMS + "marker_functions.py", "        weightless.gravity = [0.0] * 3\n", ""),
    M("markers", "sensors", ALGORITHMS + "gauges.py", "_strains(s, section.key.section_at)", "_strains(s, BASE)"),
    M("slide loop", "DAE form", ALGORITHMS + "loops.py",
      "gamma + 2 * c * rate + c * c * gap)", "gamma + 2 * c * rate)"),
    # ------------------------------------------------------------------------------------------------- the DAE form
    M("tendon", "DAE form", ALGORITHMS + "dae.py", ' + s.read("f_eta") + pulled(s),', ' + s.read("f_eta"),'),
    M("cylinder", "DAE form", ALGORITHMS + "axis_terms.py",
      "tau, inertia = found.slope * tau - found.force, inertia + found.inertia",
      "tau, inertia = found.slope * tau, inertia + found.inertia"),
    M("elastic gear", "DAE form", ALGORITHMS + "axis_terms.py",
      'tau[axis] = tau[axis] - of("gear_damping", axis) * s.read("thetadot")[k]', "pass"),
    M("friction", "DAE form", ALGORITHMS + "axis_terms.py", "tau[axis] = tau[axis] - force\n", "pass\n"),
    M("spring", "DAE runs", C + "dae.c.jinja",
      "        $_drives(c, dt, from->q, work->start_rate, from->eta, from->etadot, {% if laws %}work->qdot, s->etadot, "
      "{% endif %}work->m_eta, work->f_eta);\n", ""),
    M("time", "DAE runs", C + "dae_terms.jinja",
      "(x[k] + dt * xdot[k]) + D * xdot[k];", "(x[k] + dt * xdot[k]); (void)D;"),
    M("passive", "DAE runs", "screwgen/backends/numpy/dae_step.py",
      "np.append(self.joint_rates(x)[0], etadot)", "np.append(0 * self.joint_rates(x)[0], etadot)"),
    M("coupling", "DAE runs", C + "features/loops.jinja",
      "    call->tau = work->loops.input.tau;\n", ""),
    # ---------------------------------------------------------------------------------------- CasADi, acados, JAX
    M("tendon", "CasADi", "screwgen/backends/casadi/steps.py", "tau=ca.vertcat(tau, *others))", "tau=tau)"),
    M("tendon", "acados", "screwgen/backends/casadi/acados.py",
      "driven += exerted(chain, q, p) @ others", "driven += 0 * exerted(chain, q, p) @ others"),
    M("slide loop", "acados", ALGORITHMS + "linear_model.py",
      "a + 2.0 * c.stabilisation * b + c.stabilisation**2 * g", "a + 2.0 * c.stabilisation * b"),
    M("friction", "JAX", "screwgen/backends/jax/functions.py",
      'inertia.at[at].add(found["inertia"]), force', "inertia, force"),
    M("ball", "JAX", "screwgen/backends/jax/functions.py",
      "x = q[jnp.array(self.chain.given_places, int)]", "x = q[len(q) - self.chain.n_given :]"),
    # ------------------------------------------------------------------------------------------------------- the C
    M("coupling", "C, fused", C + "features/loops.jinja",
      "torque[k] = work->loops.input.tau[k] - input->tau[k];", "torque[k] = work->loops.input.tau[k];"),
    M("welded loop", "C, modular", C + "features/loops.jinja",
      "$_dynamics(c, s, &work->loops.input, m_eta, work, wanted, y);", "$_dynamics(c, s, u, m_eta, work, wanted, y);"),
    M("shared tendon", "C, modular", C + "features/tendons.jinja",
      '{{ "$_tensions(call.tau, work->tension)" if tendons.shared else "call.tau + $$_NAXES" }}',
      "call.tau + $$_NAXES"),
    M("ratio", "C, baked", C + "parameters.c.jinja", '{ {{ baked.D | join(", ") }} },', "{ 0 },"),
    M("stations", "C, float", C + "step.c.jinja",
      "        $_couple(c, 0, s->q + ($$_NQ - $$_NMODES), s->v + ($$_NV - $$_NMODES), 0, "
      "work->f_eta + ($$_NGIVEN - $$_NMODES));\n", ""),
    M("elastic four-bar", "C, float", "screwgen/elements/four_bar.py",
      "slope = 2.0 * self.side * turn / H", "slope = 2.0 * turn / H"),
    M("geared friction", "lanes", C + "batch.c.jinja",
      '    {{ add_axis_terms("&g->c", "dt", "s", "there", "g->work.m_eta", "g->work.f_eta", "drives") }}\n', ""),
    M("shear", "lanes", C + "batch.c.jinja",
      "    couple(&g->c, dt, s->q + ($$_NQ - $$_NMODES), s->v + ($$_NV - $$_NMODES), g->work.m_eta + $$_NGIVEN, "
      "g->work.f_eta + ($$_NGIVEN - $$_NMODES));\n", ""),
    M("stops", "lanes", C + "constants.jinja",
      "{% for column, comment in law.columns.items() %}",
      "{% for column, comment in (law.columns.items() | reverse if lanes else law.columns.items()) %}"),
    M("time", "lanes, float", C + "constants.jinja",
      '{{ real }} K[$$_LENGTH({{ inertia }})];{{ "" if lanes else " /* N/m (torsion: N*m/rad): stiffness of each mode '
      '*/" }}\n    {{ real }} D[',
      '{{ real }} {{ "D" if lanes else "K" }}[$$_LENGTH({{ inertia }})];\n    {{ real }} {{ "K" if lanes else "D" }}['),
    M("welded loop", "C folder", C + "features/loops.jinja", "input.w_ext[i][k] += wrench[i][k];", "(void)wrench;"),
    M("tendon", "C folder", C + "features/inputs.jinja",
      "given[k] += force[k] - eased[k];", "given[k] += 0 * force[k];"),
    M("ball", "C, fused", C + "moves.jinja",
      "u[k{{ joint.v }}] += dt * V[k{{ joint.v }}];", "u[k{{ joint.v }}] += 0 * dt * V[k{{ joint.v }}];"),
    # ----------------------------------------------------------------------------------------------------- slopes
    M("spring", "derivatives by parameters", ALGORITHMS + "parameter_slopes.py",
      "own[place] = float(slope)", "own[place] = 0.0 * float(slope)"),
    M("station", "derivatives", ALGORITHMS + "sensitivity.py",
      "for x in () if k else loaded:", "for x in () if k else loaded[:1]:"),
    M("exact rod", "derivatives", ALGORITHMS + "sensitivity.py",
      "by_modes + np.vstack([cross_columns(x, phi) for x in (z.omega, z.omegadot, z.a)])", "by_modes"),
    M("second order", "derivatives", ALGORITHMS + "sensitivity.py",
      "+ Phiddot + 2.0 * cross_columns(link.omega, Phidot)", "+ Phiddot"),
    M("shared tendon", "derivatives", ALGORITHMS + "sensitivity.py",
      "d_force if k else d_force + pulled_slopes(s)", "d_force"),
    M("tendon", "derivatives", "screwgen/backends/numpy/numeric.py",
      "out[:, chain.n_joints :] = np.array(exerted, float)", "out[:, chain.n_joints :] = 0 * np.array(exerted, float)"),
    M("slide", "derivatives", ALGORITHMS + "sensitivity.py",
      "Tddot + cross_columns(omegadot, T) +", "Tddot +"),
    M("two axes", "derivatives", ALGORITHMS + "sensitivity.py",
      " + turned_rows(s, A, T, w) + travel_q)", " + travel_q)"),
    M("elastic four-bar", "derivatives", ALGORITHMS + "linearise.py",
      "out.f_q[place, axis], out.f_v[place, axis], out.f_v[axis, place] = by_q, by_qdot, back",
      "out.f_v[place, axis], out.f_v[axis, place] = by_qdot, back"),
    M("elastic cylinder", "derivatives", C + "derivatives.c.jinja",
      "    out->vdot_tau[{{ place }}][{{ joint }}] -= 1;\n", ""),
    M("spring", "derivatives", ALGORITHMS + "linearise.py",
      "place = next(coordinates[law]) + chain.base_v", "place = next(coordinates[law])"),
    M("flat", "derivatives of wrenches", ALGORITHMS + "sensitivity.py",
      "return turned, np.vstack([columns_cross(self.Phi, force), mx.zeros(3, self.Phi.shape[1])])",
      "return turned, mx.zeros(6, self.Phi.shape[1])"),
    M("rod", "derivatives", ALGORITHMS + "linearise.py",
      '            J[owners, eta] = mx.multiply(here.T, link[f"F_{modal}"])\n', ""),
    M("stops", "derivatives of steps", C + "own_slopes.jinja",
      "{% for law in acting %}", "{% for law in acting[1:] %}"),
    M("stations", "derivatives of steps", C + "own_slopes.jinja",
      "work->M[{{ first }} + ROW[k]][{{ first }} + COLUMN[k]] += work->m_eta[$$_NGIVEN + k];", "(void)work;"),
    M("floating", "derivatives of steps", C + "moved_derivatives.jinja",
      "            pose->q[i][k] += carried[i][k];\n", "            (void)carried;\n"),
    M("ball", "derivatives of steps", C + "moved_derivatives.jinja",
      "            pose->q[first + i][first + k] += carried[i][k];\n", "            (void)carried;\n"),
    M("floating", "linear model", "screwgen/studies/linear.py",
      "np.hstack([chain.carried(v), np.eye(chain.nv)])", "np.hstack([0 * chain.carried(v), np.eye(chain.nv)])"),
    # ------------------------------------------------------------------------------------------- what users do with it
    M("ball loop", "runs", C + "features/loops_in_runs.jinja", "power += m->drive_power[i];", "(void)i;"),
    M("coupling", "estimator", "screwgen/simulation/estimator.py",
      "[-reach @ J_q @ keep, keep]])", "[np.zeros((n, n)), keep]])"),
    M("afloat", "estimator", "screwgen/simulation/estimator.py",
      "        A[:n, :n] = self.model.chain.carried(v)\n", ""),
    M("ball", "estimator", C + "estimator_prediction.jinja", "    turn_slopes(work);\n", "    (void)turn_slopes;\n"),
    M("tendon", "equilibrium", "screwgen/studies/statics.py", "if self.others.any():", "if False:"),
    M("four-bar", "equilibrium", "screwgen/studies/equilibrium.py",
      "at_joints = chain.n_joints, tau / chain.at_efforts(np.ones(chain.n_tau), p)", "at_joints = chain.n_joints, tau"),
    M("welded loop", "equilibrium", "screwgen/studies/statics_with_loops.py",
      '"stiffness": b.stiffness - bend}', '"stiffness": b.stiffness}'),
    M("hinge loop", "modes", "screwgen/studies/modes.py",
      "N = following((jacobian(model, q, p) @ T)[:, moving], np.diag(K))", "N = None"),
    M("clamped_free", "modes", "screwgen/backends/numpy/vibrations.py",
      "return scale[1] / scale[0] / periods,", "return 2 * scale[1] / scale[0] / periods,"),
    M("tendon", "document", "screwgen/backends/latex/document.py",
      'tension=TENSION if chain.n_tensions else ""', 'tension=""'),
    M("coupling", "document", "screwgen/backends/latex/robot_tables.py",
      "ratio = exact(coupling.ratio) + relation", "ratio = exact(1.0) + relation"),
    M("rotor", "document", "screwgen/elements/gear.py",
      "j_m &\\leftarrow j_m + J_r\\,N^2\n$$", "j_m &\\leftarrow j_m\n$$"),
    M("spring", "document", "screwgen/elements/spring.py", r'r"k\,(q - q_0)"', r'r"k\,q"'),
    M("four-bar", "document", "screwgen/elements/four_bar.py",
      r"\psi'\,(\tau_c - \tau_f) - J_r\,N^2\,\psi'\,\psi''\,\dot{q}^2,", r"\psi'\,(\tau_c - \tau_f),"),
    M("tendon", "commands", "screwgen/plotting/run_panels.py",
      "if array in run.arrays and (kept := places(run.tau_names, row)):", "if False:"),
    M("tendon", "mock-up unit", "screwgen/backends/fmi/variables.py",
      "in zip(names, input_units(chain.robot), strict=True):",
      "in zip(names[: chain.n_joints], input_units(chain.robot), strict=False):"),
    M("bodies", "URDF", "screwgen/interchange/urdf_write.py",
      '"at": "tip", "frame_at": None}', '"at": "tip", "frame_at": None, "bodies": ()}'),
    M("station", "URDF", "screwgen/interchange/urdf_write.py", "return Pose(turned, s * end.p) @ placed",
      "return Pose(turned, end.p) @ placed"),
    M("coupling", "robot file", "screwgen/spec/load.py", "for key, table in tables)])",
      'for key, table in tables if key != "couplings")])'),
]  # fmt: skip
