/* peak.c: the machine's rate of scalar multiplications and additions, as a contender.
 *
 * Twelve chains that do not wait for each other; compiled without vectorisation, else at the level of the others.
 */
#include "contract.h"

enum { CHAINS = 12, LAPS = 200 }; /* 2 CHAINS LAPS operations per call */

static volatile double seed = 0.5, factor = 0.999, summand = 1e-3;
static volatile double sink;

static void init(void) {}

int CALL(int k);
int CALL(int k)
{
    const double b = factor, c = summand;
    double x0 = seed + k, x1 = x0 + 1, x2 = x0 + 2, x3 = x0 + 3, x4 = x0 + 4, x5 = x0 + 5, x6 = x0 + 6, x7 = x0 + 7;
    double x8 = x0 + 8, x9 = x0 + 9, x10 = x0 + 10, x11 = x0 + 11;
    int i;
    for (i = 0; i < LAPS; ++i) {
        x0 = x0 * b + c;
        x1 = x1 * b + c;
        x2 = x2 * b + c;
        x3 = x3 * b + c;
        x4 = x4 * b + c;
        x5 = x5 * b + c;
        x6 = x6 * b + c;
        x7 = x7 * b + c;
        x8 = x8 * b + c;
        x9 = x9 * b + c;
        x10 = x10 * b + c;
        x11 = x11 * b + c;
    }
    sink = x0 + x1 + x2 + x3 + x4 + x5 + x6 + x7 + x8 + x9 + x10 + x11;
    return 0;
}

static void result(double *y)
{
    (void)y;
}

extern const contender VARIANT;
const contender VARIANT = { TEXT(VARIANT), 0, init, CALL, result };
