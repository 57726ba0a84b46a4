/* adapter_casadi.c: the C that casadi.Function.generate writes as a contender.
 *
 * The function is -DFUNCTION, its inputs q, v, tau, w_ext and, unless -DBAKED, one of constants or parameters
 * (-DEXTRA, an array of -DDATA); its outputs vdot, wrench, tip rotation by rows, tip position. -DPLAIN: q, v, tau to
 * vdot, and that is all.
 */
#include DATA

#include "contract.h"

#ifndef casadi_real
#define casadi_real double
#endif

int FUNCTION(const casadi_real **arg, casadi_real **res, long long *iw, casadi_real *w, int mem);

static casadi_real q[STATES][NQ], v[STATES][NQ], tau[STATES][NTAU], w_ext[STATES][6 * NLINKS];
static casadi_real vdot[NQ], wrench[6 * NLINKS], R[9], position[3];
#if !defined(BAKED)
static casadi_real extra[sizeof EXTRA / sizeof EXTRA[0]];
#endif
static casadi_real w[SZ_W + 1];
static long long iw[SZ_IW + 1];

static void take(const double *from, casadi_real *to, int n)
{
    int i;
    for (i = 0; i < n; ++i) {
        to[i] = (casadi_real)from[i];
    }
}

static void init(void)
{
    int k;
    for (k = 0; k < STATES; ++k) {
        take(data_q[k], q[k], NQ);
        take(data_v[k], v[k], NQ);
        take(data_tau[k], tau[k], NTAU);
        take(data_w_ext[k], w_ext[k], 6 * NLINKS);
    }
#if !defined(BAKED)
    take(EXTRA, extra, (int)(sizeof EXTRA / sizeof EXTRA[0]));
#endif
}

int CALL(int k);
int CALL(int k)
{
    const casadi_real *arg[SZ_ARG + 1];
    casadi_real *res[SZ_RES + 1];
    arg[0] = q[k];
    arg[1] = v[k];
    arg[2] = tau[k];
#if !defined(PLAIN)
    arg[3] = w_ext[k];
#endif
#if !defined(BAKED)
    arg[4] = extra;
#endif
    res[0] = vdot;
#if !defined(PLAIN)
    res[1] = wrench;
    res[2] = R;
    res[3] = position;
#endif
    return FUNCTION(arg, res, iw, w, 0);
}

static double *give(const casadi_real *from, int n, double *y)
{
    int i;
    for (i = 0; i < n; ++i) {
        y[i] = (double)from[i];
    }
    return y + n;
}

static void result(double *y)
{
    y = give(vdot, NQ, y);
#if !defined(PLAIN)
    give(position, 3, give(R, 9, give(wrench, 6 * NLINKS, y)));
#endif
}

#if defined(PLAIN)
#define RESULTS NQ
#else
#define RESULTS (NQ + 6 * NLINKS + 12)
#endif

extern const contender VARIANT;
const contender VARIANT = { TEXT(VARIANT), RESULTS, init, CALL, result };
