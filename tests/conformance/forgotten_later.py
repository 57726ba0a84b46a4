"""Mutants of features and consumers that came after the order of the first ones was drawn: see `forgotten`."""

from __future__ import annotations

from conformance.mutation import ALGORITHMS, BRAKED, COMPLIANT, INTERACTIONS, LOOPED, PARAMETERS, PRESCRIBED, C, Mutant

M = Mutant
LATER: list[Mutant] = [
    # ------------------------------------------------------------------------------------------------------- brakes
    M("brakes", "derivatives", BRAKED,
      "        out->vdot_v[row][row] += work->brake_by_rate[k];\n", ""),
    M("brakes", "acados", "screwgen/backends/casadi/acados.py", "    if chain.braked:\n", "    if False:\n"),
    M("brakes", "energy balance", ALGORITHMS + "input_functions.py",
      "coupled[k] - levers[k] * tau[k]", "coupled[k]"),
    M("brakes", "document", "screwgen/elements/brake.py",
      r"j_b &= J_b\,\left( 1 - \sigma_b \right)", "j_b &= J_b"),
    M("brakes", "estimator", LOOPED, '{{ "&work->still" if brakes else "input" }}', "input"),
    # ----------------------------------------------------------------------------------- loops whose joints give way
    M("compliant loop", "judge", "screwgen/joints/compliant.py",
      "place = -1 if isinstance(row, Angle) else 0", "place = 0"),
    M("compliant loop", "runs", COMPLIANT, "        m->input = plain;\n", "        (void)plain;\n"),
    M("compliant loop", "DAE runs", COMPLIANT,
      "work->m_eta, work->f_eta, from != s, &work->compliant)", "work->m_eta, work->f_eta, 0, &work->compliant)"),
    M("compliant loop", "lanes", COMPLIANT, "    g->u = held;\n", "    (void)held;\n"),
    M("compliant loop", "derivatives of steps", COMPLIANT,
      "        add(1, &own->vdot_v[0][0], {{ NVZ }} * {{ NVZ }}, &out->vdot_v[0][0]);\n", ""),
    # ------------------------------------------------------------------------------------- axes whose motion is given
    M("given motion", "DAE form", ALGORITHMS + "axis_terms.py",
      "tau[axis] if axis in prescribed(s) else tau[axis] - force", "tau[axis] - force"),
    M("given motion", "derivatives", PRESCRIBED,
      "            out->vdot_tau[i][GIVEN_BY[k]] += work->given[k][i];\n", "            (void)i;\n"),
    M("given motion", "estimator", "screwgen/simulation/estimator.py",
      "prescribed.answers(chain, M, J.T)", "np.linalg.solve(M, J.T)"),
    M("given motion", "plan", "screwgen/planning/drive_coordinates.py",
      "self.given = list(chain.prescribed)", "self.given: list[int] = []"),
    # ------------------------------------------------------------------------------------------ contact and drag
    M("contact", "judge", INTERACTIONS + "contact.py", "[u[k] - rate * n[k] for k in range(3)]", "u"),
    M("contact", "document", INTERACTIONS + "contact.py", ' if "friction" in has else []', " if False else []"),
    M("contact", "document", INTERACTIONS + "drag.py", 'b_d\\,u_d\\,{u}', 'b_d\\,{u}'),
    # ------------------------------------------------------------------------------------------ a base that moves
    M("moving", "energy balance", ALGORITHMS + "input_functions.py",
      "= force[: 6 * self.chain.moving]", "= [0.0 * x for x in force[: 6 * self.chain.moving]]"),
    M("moving", "derivatives of wrenches", ALGORITHMS + "input_functions.py",
      "return 6 * (self.chain.floating and not self.chain.moving)", "return 6 * self.chain.floating"),
    M("moving", "equilibrium", "screwgen/studies/standing.py",
      "np.append(moment + np.cross(self.point, force), force)", "np.append(moment, force)"),
    M("moving", "sensors", ALGORITHMS + "marker_functions.py",
      'units = np.eye(self.chain.nv).tolist()',
      "units = np.diag([float(k >= 6 * self.chain.moving) for k in range(self.chain.nv)]).tolist()"),
    # ----------------------------------------------------------- ball joints beside what acts on single coordinates
    M("ball", "C, fused", C + "couple.jinja", '"PLACE[" ~ number ~ "]" if balls else number', "number"),
    M("ball", "derivatives of steps", C + "own_slopes.jinja",
      '("PLACE[k]" if balls else "($$_NQ - $$_NGIVEN) + "', '("($$_NQ - $$_NGIVEN) + "'),
    M("ball", "derivatives", C + "own_slopes.jinja", '"OF_AXIS[k]" if balls else ', ""),
    # --------------------------------------------------------------------------------------- consumers that had few
    M("markers", "estimator of parameters", PARAMETERS,
      "                row[P_AT + j] += by_vdot[k] * work->vdot_by_p[k * $$_NBY_P + j];\n",
      "                (void)row;\n"),
    M("limited", "estimator of parameters", PARAMETERS, '{{ "&work->step.held" if held else "input" }}', "input"),
    M("ball loop", "estimator of parameters", PARAMETERS,
      "H[P_AT + k] = (n < ROWS ? work->gap_by_p : work->rate_by_p)[i * $$_NBY_P + k];", "H[P_AT + k] = 0;"),
    M("bristles", "estimator of parameters", "screwgen/simulation/parameter_estimator.py",
      'if "vdot" in program.inputs:', 'if "vdot" in program.inputs and not chain.n_internal:'),
    M("tendon", "identification", "screwgen/identification/log_windows.py",
      "        p = parameter_rows(problem.model, problem.unknowns, values)\n        with",
      "        p = parameter_rows(problem.model, problem.unknowns, values)\n"
      "        tau[..., problem.model.n_joints :] = 0.0\n        with"),
    M("spring", "plan", "screwgen/planning/members.py",
      "torque[self.drives.given] = 0.0", "torque[:] = 0.0"),
    # ----------------------------------------------------------------------------------------- slopes by recursion
    M("line spring", "derivatives", C + "acting.jinja",
      "                    out->vdot_v[i][k] -= J[i] * work->acting.D_v[n][k];\n", ""),
    M("welded loop", "derivatives", C + "acting.jinja", " + unit * tip->acc_q[n % 6][i]", ""),
    M("ball", "derivatives", C + "acting.jinja",
      "{% if acting.balls %}\n    for (k = 0; k <", "{% if false %}\n    for (k = 0; k <"),
    M("elastic four-bar", "derivatives", "screwgen/backends/c/recursive_slopes.py",
      '"gear_back": ("f_v", "axis", "gear")', '"gear_back": ("f_v", "gear", "axis")'),
    M("station", "derivatives", "screwgen/backends/c/pair_ranges.py",
      "modes.start if station == TIP else at[parent] + station * count", "modes.start"),
]  # fmt: skip
