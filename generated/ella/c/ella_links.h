/* ella_links.h: the algorithms on the chain of links. Private to the generated sources. */
#ifndef ELLA_LINKS_H
#define ELLA_LINKS_H

#include "ella_real.h"

/* The inputs and outputs (new_) of a call, by the names of the signals; every array starts at the first link. */
typedef struct {
    const ella_real *gravity, *q, *qdot, *eta, *etadot, *tau, *w_ext, *m_eta, *f_eta;
    const ella_real *quaternion, *twist, *alpha, *qddot, *etaddot, *wrench, *motion;
    ella_real *new_qddot, *new_etaddot, *new_wrench, *new_alpha, *new_Vdot, *new_qdot, *new_q, *new_quaternion,
        *new_position;
    ella_real *new_twist, *new_force, *new_force_eta, *new_R, *new_r, *new_tip_twist, *new_motion, *new_measures, *M,
        *H, *W;
    int tip_pose; /* whether the tip's pose is wanted; new_wrench and new_motion are wanted if not null */
} ella_call;

/* Results of the forward dynamics that a caller may want besides vdot. */
enum { ELLA_WRENCHES = 1, ELLA_TIP_POSE = 2, ELLA_MOTION = 4 };

/* Joint form: vdot and the wanted results; the rest of output is unchanged. fault is set with ELLA_SINGULAR. */
ella_status ella_dynamics(const ella_constants *c, const ella_state *state, const ella_input *input,
    const ella_real *m_eta, ella_work *work, int wanted, ella_output *output);

/* Rotation and position of a tip section. */
static inline void ella_pose_of(const ella_node *tip, ella_real rotation[3][3], ella_real position[3])
{
    int k;
    for (k = 0; k < 3; ++k) {
        rotation[k][0] = tip->R[3 * k];
        rotation[k][1] = tip->R[3 * k + 1];
        rotation[k][2] = tip->R[3 * k + 2];
        position[k] = tip->r[k];
    }
}

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

/* How far every link is from the limits of its model. */
ella_status ella_measuring(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

/* M_sys, H_sys and W_sys. */
ella_status ella_assembly(const ella_constants *c, const ella_call *call, ella_chain *chain, int *fault);

#endif
