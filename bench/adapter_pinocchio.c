/* adapter_pinocchio.c: Pinocchio's compiled ABA on the rigid chain of -DDATA as a contender. */
#include DATA

#include "contract.h"

#include "pinocchio_aba.h"

static void *chain;

static void init(void)
{
    chain = pinocchio_chain(NQ, data_joints);
}

int CALL(int k);
int CALL(int k)
{
    pinocchio_aba(chain, data_q[k], data_v[k], data_tau[k]);
    return 0;
}

static void result(double *y)
{
    pinocchio_vdot(chain, y);
}

extern const contender VARIANT;
const contender VARIANT = { TEXT(VARIANT), NQ, init, CALL, result };
