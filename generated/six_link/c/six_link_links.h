/* six_link_links.h: the algorithms on the chain of links. Private to the generated sources. */
#ifndef SIX_LINK_LINKS_H
#define SIX_LINK_LINKS_H

#include "six_link_real.h"

/* The inputs and outputs (new_) of a call, by the names of the signals; every array starts at the first link. */
typedef struct {
    const six_link_real *gravity, *q, *qdot, *eta, *etadot, *tau, *w_ext, *m_eta, *f_eta, *m_q, *f_q;
    const six_link_real *quaternion, *twist, *alpha, *qddot, *etaddot, *wrench, *motion;
    six_link_real *new_qddot, *new_etaddot, *new_wrench, *new_alpha, *new_Vdot, *new_qdot, *new_q, *new_quaternion,
        *new_position;
    six_link_real *new_twist, *new_force, *new_force_eta, *new_R, *new_r, *new_tip_twist, *new_motion, *new_measures,
        *M, *H, *W;
    int tip_pose; /* whether the tip's pose is wanted; new_wrench and new_motion are wanted if not null */
} six_link_call;

/* Results of the forward dynamics that a caller may want besides vdot. */
enum { SIX_LINK_WRENCHES = 1, SIX_LINK_TIP_POSE = 2, SIX_LINK_MOTION = 4 };

/* Joint form: vdot and the wanted results; the rest of output is unchanged. fault is set with SIX_LINK_SINGULAR. */
six_link_status six_link_dynamics(const six_link_constants *c, const six_link_state *state, const six_link_input *input,
    const six_link_real *m_eta, six_link_work *work, int wanted, six_link_output *output);

/* Rotation and position of a tip section. */
static inline void six_link_pose_of(const six_link_node *tip, six_link_real rotation[3][3], six_link_real position[3])
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
six_link_status six_link_dae_motion(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* DAE form: rates of the twists, wrenches, joint rates, by the same elimination. */
six_link_status six_link_dae_solution(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* The state of the DAE form, projected onto the joint constraints. */
six_link_status six_link_projection(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* Poses and twists of the DAE form from coordinates and rates. */
six_link_status six_link_placement(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* Joint form: inverse dynamics, with joint wrenches. */
six_link_status six_link_inverse(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* Joint form at rest, without weight and springs: the posture, and the inertial forces of accelerations. */
six_link_status six_link_inertia_posture(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* Joint form at rest, without weight and springs: the posture, and the inertial forces of accelerations. */
six_link_status six_link_inertia_column(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* Poses of links and tips, twists of the tips. */
six_link_status six_link_motion_of(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* How far every link is from the limits of its model. */
six_link_status six_link_measuring(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

/* M_sys, H_sys and W_sys. */
six_link_status six_link_assembly(const six_link_constants *c, const six_link_call *call, six_link_chain *chain,
    int *fault);

#endif
