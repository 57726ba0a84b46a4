/* ella_links.h: the algorithms on the chain of links. Private to the generated sources. */
#ifndef ELLA_LINKS_H
#define ELLA_LINKS_H

#include "ella_real.h"

/* The inputs and outputs of a call; every array starts at the first link. */
typedef struct {
    const ella_real *gravity, *q, *qdot, *eta, *etadot, *tau, *w_ext, *m_eta, *f_eta;
    const ella_real *quaternion, *twist, *given_alpha, *given_qddot, *given_etaddot;
    const ella_real *given_wrench, *given_motion;
    ella_real *qddot, *etaddot, *wrench, *alpha, *Vdot, *new_qdot, *new_q, *new_quaternion, *new_position, *new_twist;
    ella_real *force, *force_eta, *M, *H, *W, *rotation, *position, *tip_twist, *motion, *measures;
    int tip_pose; /* whether the tip's pose is wanted; wrench and motion are wanted if not null */
} ella_call;

/* Results of the forward dynamics that a caller may want besides vdot. */
enum { ELLA_WRENCHES = 1, ELLA_TIP_POSE = 2, ELLA_MOTION = 4 };

/* Joint form: vdot and the wanted results; the rest of output is unchanged. fault is set with ELLA_SINGULAR. */
ella_status ella_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    const ella_real *m_eta, ella_work *work, int wanted, ella_output *output);

/* DAE form: rates of the twists, wrenches, joint rates, by the same elimination. */
ella_status ella_dae_dynamics(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* The state of the DAE form, projected onto the joint constraints. */
ella_status ella_projection(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* Poses and twists of the DAE form from coordinates and rates. */
ella_status ella_placement(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* Joint form: inverse dynamics, with joint wrenches. */
ella_status ella_inverse(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* Joint form at rest, without weight and springs: the posture, and the inertial forces of accelerations. */
ella_status ella_inertia_posture(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* Joint form at rest, without weight and springs: the posture, and the inertial forces of accelerations. */
ella_status ella_inertia_column(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* Poses of links and tips, twists of the tips. */
ella_status ella_motion_of(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* How far every link is from the limits of the first-order model. */
ella_status ella_measuring(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* M_sys, H_sys and W_sys. */
ella_status ella_assembly(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

#endif
