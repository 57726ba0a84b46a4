// pinocchio_aba.cpp: Pinocchio's articulated-body algorithm, compiled from its headers.
#include <pinocchio/algorithm/aba.hpp>

#include "pinocchio_data.hpp"

void *pinocchio_chain(int n, const double joints[][JOINT_NUMBERS])
{
    return new Chain(chain_model(n, joints));
}

void pinocchio_aba(void *chain, const double *q, const double *v, const double *tau)
{
    Chain *x = static_cast<Chain *>(chain);
    const int n = x->model.nv;
    pinocchio::aba(x->model, x->data, Vector(q, n), Vector(v, n), Vector(tau, n));
}

void pinocchio_vdot(const void *chain, double *vdot)
{
    const Chain *x = static_cast<const Chain *>(chain);
    for (int i = 0; i < x->model.nv; ++i) {
        vdot[i] = x->data.ddq[i];
    }
}
