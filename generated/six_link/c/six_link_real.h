/* six_link_real.h: precision, elementary functions and limits. One source serves double and float:
 * define SIX_LINK_REAL_FLOAT for float. Private to the generated sources.
 */
#ifndef SIX_LINK_REAL_H
#define SIX_LINK_REAL_H

#include <float.h>
#include <math.h>

#include "six_link.h"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "compile without -ffast-math: it removes the checks for NaN and infinity"
#endif

#ifdef SIX_LINK_REAL_FLOAT
#define REAL(x) x##f
#define SIX_LINK_REAL_EPSILON FLT_EPSILON
#define six_link_sin(x) sinf(x)
#define six_link_cos(x) cosf(x)
#define six_link_sqrt(x) sqrtf(x)
#else
#define REAL(x) x
#define SIX_LINK_REAL_EPSILON DBL_EPSILON
#define six_link_sin(x) sin(x)
#define six_link_cos(x) cos(x)
#define six_link_sqrt(x) sqrt(x)
#endif

/* Stumpff functions c_k(x) = sum_j (-x)^j / (k + 2 j)!, k = 4 and 5, of a squared angle x: the series by
 * Horner's rule, with more terms above 1/4 (half a radian), and sine and cosine above 4.
 */
static inline six_link_real six_link_c4(six_link_real x)
{
    six_link_real s = 1;
    if (x >= 4) {
        const six_link_real angle = six_link_sqrt(x);
        return (six_link_cos(angle) - 1 + x / 2) / (x * x);
    }
    if (x >= REAL(0.25)) {
        s = 1 - x * (REAL(1.0) / 870) * s;
        s = 1 - x * (REAL(1.0) / 756) * s;
        s = 1 - x * (REAL(1.0) / 650) * s;
        s = 1 - x * (REAL(1.0) / 552) * s;
        s = 1 - x * (REAL(1.0) / 462) * s;
        s = 1 - x * (REAL(1.0) / 380) * s;
        s = 1 - x * (REAL(1.0) / 306) * s;
    }
    s = 1 - x * (REAL(1.0) / 240) * s;
    s = 1 - x * (REAL(1.0) / 182) * s;
    s = 1 - x * (REAL(1.0) / 132) * s;
    s = 1 - x * (REAL(1.0) / 90) * s;
    s = 1 - x * (REAL(1.0) / 56) * s;
    s = 1 - x * (REAL(1.0) / 30) * s;
    return s * (REAL(1.0) / 24);
}

static inline six_link_real six_link_c5(six_link_real x)
{
    six_link_real s = 1;
    if (x >= 4) {
        const six_link_real angle = six_link_sqrt(x);
        return (six_link_sin(angle) - angle + angle * x / 6) / (x * x * angle);
    }
    if (x >= REAL(0.25)) {
        s = 1 - x * (REAL(1.0) / 930) * s;
        s = 1 - x * (REAL(1.0) / 812) * s;
        s = 1 - x * (REAL(1.0) / 702) * s;
        s = 1 - x * (REAL(1.0) / 600) * s;
        s = 1 - x * (REAL(1.0) / 506) * s;
        s = 1 - x * (REAL(1.0) / 420) * s;
        s = 1 - x * (REAL(1.0) / 342) * s;
    }
    s = 1 - x * (REAL(1.0) / 272) * s;
    s = 1 - x * (REAL(1.0) / 210) * s;
    s = 1 - x * (REAL(1.0) / 156) * s;
    s = 1 - x * (REAL(1.0) / 110) * s;
    s = 1 - x * (REAL(1.0) / 72) * s;
    s = 1 - x * (REAL(1.0) / 42) * s;
    return s * (REAL(1.0) / 120);
}

/* 1 if all n numbers are finite: x - x is zero for every finite x and NaN for the others. Four sums, so that
 * one addition need not wait for the last.
 */
static inline int six_link_finite(const six_link_real *x, int n)
{
    six_link_real a = 0, b = 0, c = 0, d = 0;
    const int whole = n - n % 4;
    int i;
    for (i = 0; i < whole; i += 4) {
        a += x[i] - x[i];
        b += x[i + 1] - x[i + 1];
        c += x[i + 2] - x[i + 2];
        d += x[i + 3] - x[i + 3];
    }
    for (i = whole; i < n; ++i) {
        a += x[i] - x[i];
    }
    return (a + b) + (c + d) <= 0;
}

/* 1 if the cubes of all n numbers are finite: products such as the dynamics form do not overflow. */
static inline int six_link_moderate(const six_link_real *x, int n)
{
    six_link_real sum = 0;
    int i;
    for (i = 0; i < n; ++i) {
        const six_link_real cube = x[i] * x[i] * x[i];
        sum += cube - cube;
    }
    return sum <= 0;
}

#endif
