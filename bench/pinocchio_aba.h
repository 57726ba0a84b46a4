/* pinocchio_aba.h: Pinocchio's articulated-body algorithm behind C functions. */
#ifndef BENCH_PINOCCHIO_ABA_H
#define BENCH_PINOCCHIO_ABA_H

#ifdef __cplusplus
extern "C" {
#endif

/* A joint of the chain: number of its axis (x, y, z), offset along the parent's x (m), mass (kg), x of the centre of
 * mass (m), moments of inertia about it (kg m2). */
enum { JOINT_NUMBERS = 7 };

void *pinocchio_chain(int n, const double joints[][JOINT_NUMBERS]);
void pinocchio_aba(void *chain, const double *q, const double *v, const double *tau);
void pinocchio_vdot(const void *chain, double *vdot);

#ifdef __cplusplus
}
#endif

#endif
