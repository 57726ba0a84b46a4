/* six_link_real.h: precision and elementary functions. One source serves double and float:
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
#ifdef __ASSOCIATIVE_MATH__
#error "compile without -fassociative-math, -funsafe-math-optimizations: they reorder sums that round an angle"
#endif
#if defined(__clang__) && __clang_major__ >= 13
#pragma clang fp reassociate(off) /* clang has no macro for these options */
#endif

#ifdef SIX_LINK_REAL_FLOAT
#define SIX_LINK_REAL(x) x##f
#define SIX_LINK_REAL_EPSILON FLT_EPSILON
#define six_link_libm_sin(x) sinf(x)
#define six_link_libm_cos(x) cosf(x)
#define six_link_sqrt(x) sqrtf(x)
#define SIX_LINK_FAR 8192.0f
#define SIX_LINK_ROUND 12582912.0f /* 1.5 * 2^23: adding it rounds to a whole number */
#define SIX_LINK_QUARTER_1 1.5703125f /* pi / 2 in four parts, the first three of 11 bits */
#define SIX_LINK_QUARTER_2 4.837512969970703125e-4f
#define SIX_LINK_QUARTER_3 7.54953362047672271728515625e-8f
#define SIX_LINK_QUARTER_4 2.56334406825708960298e-12f
#define SIX_LINK_SIXTH 1.6666655e-1f
#define SIX_LINK_SINE(z, w) (8.332158e-3f - (z) * 1.9514958e-4f)
#define SIX_LINK_COSINE(z, w) (4.1666646e-2f - (z) * 1.3887313e-3f + (w) * 2.4432786e-5f)
#else
#define SIX_LINK_REAL(x) x
#define SIX_LINK_REAL_EPSILON DBL_EPSILON
#define six_link_libm_sin(x) sin(x)
#define six_link_libm_cos(x) cos(x)
#define six_link_sqrt(x) sqrt(x)
#define SIX_LINK_FAR 1e6
#define SIX_LINK_ROUND 6755399441055744.0 /* 1.5 * 2^52: adding it rounds to a whole number */
#define SIX_LINK_QUARTER_1 1.57079632673412561417e+00 /* pi / 2 in four parts, the first three of 33 bits */
#define SIX_LINK_QUARTER_2 6.07710050630396597660e-11
#define SIX_LINK_QUARTER_3 2.02226624871116645580e-21
#define SIX_LINK_QUARTER_4 8.47842766036889956997e-32
#define SIX_LINK_SIXTH 1.66666666666666324348e-01
#define SIX_LINK_SINE(z, w) (8.33333333332248946124e-03 - (z) * 1.98412698298579493134e-04 \
    + (w) * (2.75573137070700676789e-06 - (z) * 2.50507602534068634195e-08 + (w) * 1.58969099521155010221e-10))
#define SIX_LINK_COSINE(z, w) (4.16666666666666019037e-02 - (z) * 1.38888888888741095749e-03 \
    + (w) * (2.48015872894767294178e-05 - (z) * 2.75573143513906633035e-07 \
    + (w) * (2.08757232129817482790e-09 - (z) * 1.13596475577881948265e-11)))
#endif

/* Sine and cosine are libm's on request, or if expressions are evaluated with more precision than their type. */
#if !defined(SIX_LINK_LIBM) && (!defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0)
#define SIX_LINK_LIBM
#endif

/* With GCC and glibc on x86-64, functions so marked are compiled twice if optimised, the second time for processors
 * with AVX, whose instructions have three operands and need fewer copies. The version is chosen when the program is
 * loaded; the results are the same to the bit. -DSIX_LINK_ONE_TARGET switches this off.
 */
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) \
    && !defined(__AVX__) && !defined(__SANITIZE_THREAD__) && !defined(SIX_LINK_ONE_TARGET)
#define SIX_LINK_TARGETS __attribute__((target_clones("avx", "default")))
#define SIX_LINK_PART static inline __attribute__((always_inline)) /* of a function compiled twice */
#else
#define SIX_LINK_TARGETS
#define SIX_LINK_PART static
#endif

/* Sine and cosine of an angle, together and separately. */
typedef struct {
    six_link_real sine, cosine;
} six_link_sincos;

six_link_sincos six_link_sine_cosine(six_link_real x);

static inline six_link_real six_link_sin(six_link_real x)
{
    return six_link_sine_cosine(x).sine;
}

static inline six_link_real six_link_cos(six_link_real x)
{
    return six_link_sine_cosine(x).cosine;
}

/* Stumpff functions c_k(x) = sum_j (-x)^j / (k + 2 j)!, k = 4 and 5, of a squared angle x. */
six_link_real six_link_c4(six_link_real x);
six_link_real six_link_c5(six_link_real x);

/* 1 if all n numbers and their sum are finite. Four partial sums, so that additions need not wait for each other.
 */
static inline int six_link_finite(const six_link_real *x, int n)
{
    six_link_real a = 0, b = 0, c = 0, d = 0, sum;
    const int whole = n - n % 4;
    int i;
    for (i = 0; i < whole; i += 4) {
        a += x[i];
        b += x[i + 1];
        c += x[i + 2];
        d += x[i + 3];
    }
    for (i = whole; i < n; ++i) {
        a += x[i];
    }
    sum = (a + b) + (c + d);
    return sum - sum <= 0;
}

/* 1 if dt is the length of a step: finite, positive, and not so small that a part of it is rounded to zero. */
static inline int six_link_is_step(six_link_real dt)
{
    return six_link_finite(&dt, 1) && dt * SIX_LINK_REAL_EPSILON > 0;
}

/* 1 if the cubes of all n numbers are finite, so that products in the dynamics do not overflow. */
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

/* Whether a failed pivot means a singular posture: the input is finite and does not overflow. */
static inline int six_link_sound(const six_link_state *s, const six_link_input *u)
{
    return six_link_finite(s->q, SIX_LINK_NQ - SIX_LINK_NMODES)
        && six_link_moderate(s->q + (SIX_LINK_NQ - SIX_LINK_NMODES), SIX_LINK_NMODES)
        && six_link_moderate(s->v, SIX_LINK_NV)
        && six_link_finite(u->tau, SIX_LINK_NTAU) && six_link_finite(&u->w_ext[0][0], 6 * SIX_LINK_NLINKS);
}

#endif
