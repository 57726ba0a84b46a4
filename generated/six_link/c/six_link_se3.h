/* six_link_se3.h: poses and twists on SE(3). Private to the generated sources. */
#ifndef SIX_LINK_SE3_H
#define SIX_LINK_SE3_H

#include "six_link_real.h"

/* The rotation of a unit quaternion times a vector. */
static inline void turn(const six_link_real Q[4], const six_link_real a[3], six_link_real b[3])
{
    const six_link_real t[3] = {
        2 * (Q[2] * a[2] - Q[3] * a[1]), 2 * (Q[3] * a[0] - Q[1] * a[2]), 2 * (Q[1] * a[1] - Q[2] * a[0]),
    };
    b[0] = a[0] + Q[0] * t[0] + Q[2] * t[2] - Q[3] * t[1];
    b[1] = a[1] + Q[0] * t[1] + Q[3] * t[0] - Q[1] * t[2];
    b[2] = a[2] + Q[0] * t[2] + Q[1] * t[1] - Q[2] * t[0];
}

/* pose = start exp(u), u = [turn; shift] in the body's own axes. */
static inline void exponential(const six_link_real Q[4], const six_link_real p[3], const six_link_real u[6],
    six_link_real Q_new[4],
    six_link_real p_new[3])
{
    const six_link_real x = u[0] * u[0] + u[1] * u[1] + u[2] * u[2], quarter = x / 4;
    const six_link_real c3 = (SIX_LINK_REAL(1.0) / 6) - x * six_link_c5(x),
        c2 = SIX_LINK_REAL(0.5) - x * six_link_c4(x);
    const six_link_real w = 1 - quarter * (SIX_LINK_REAL(0.5) - quarter * six_link_c4(quarter));
    const six_link_real s = (1 - quarter * ((SIX_LINK_REAL(1.0) / 6) - quarter * six_link_c5(quarter))) / 2;
    const six_link_real a = s * u[0], b = s * u[1], d = s * u[2];
    const six_link_real cross[3] = { u[1] * u[5] - u[2] * u[4], u[2] * u[3] - u[0] * u[5], u[0] * u[4] - u[1] * u[3] };
    const six_link_real shift[3] = {
        u[3] + c2 * cross[0] + c3 * (u[1] * cross[2] - u[2] * cross[1]),
        u[4] + c2 * cross[1] + c3 * (u[2] * cross[0] - u[0] * cross[2]),
        u[5] + c2 * cross[2] + c3 * (u[0] * cross[1] - u[1] * cross[0]),
    };
    const six_link_real q0 = Q[0], q1 = Q[1], q2 = Q[2], q3 = Q[3];
    six_link_real moved[3];
    int k;
    turn(Q, shift, moved);
    for (k = 0; k < 3; ++k) {
        p_new[k] = p[k] + moved[k];
    }
    Q_new[0] = q0 * w - q1 * a - q2 * b - q3 * d;
    Q_new[1] = q0 * a + q1 * w + q2 * d - q3 * b;
    Q_new[2] = q0 * b - q1 * d + q2 * w + q3 * a;
    Q_new[3] = q0 * d + q1 * b - q2 * a + q3 * w;
}

/* [a, b] of se(3). */
static inline void bracket(const six_link_real a[6], const six_link_real b[6], six_link_real c[6])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
    c[3] = a[4] * b[2] - a[5] * b[1] + a[1] * b[5] - a[2] * b[4];
    c[4] = a[5] * b[0] - a[3] * b[2] + a[2] * b[3] - a[0] * b[5];
    c[5] = a[3] * b[1] - a[4] * b[0] + a[0] * b[4] - a[1] * b[3];
}

/* The rate of u in pose = start exp(u) at twist V: V + [u, V]/2 + [u, [u, V]]/12, enough for order four. */
static inline void algebra_rate(const six_link_real u[6], const six_link_real V[6], six_link_real rate[6])
{
    six_link_real first[6], second[6];
    int k;
    bracket(u, V, first);
    bracket(u, first, second);
    for (k = 0; k < 6; ++k) {
        rate[k] = V[k] + first[k] / 2 + second[k] * (SIX_LINK_REAL(1.0) / 12);
    }
}

#endif
