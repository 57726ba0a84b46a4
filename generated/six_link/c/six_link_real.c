/* six_link_real.c: elementary functions. They are not inlined, so that the code stays in the instruction cache.
 *
 * Sine and cosine are polynomials (in double fdlibm's) of the angle less whole quarter turns, which are subtracted in
 * four parts. Their error is below one unit in the last place. libm is used for angles beyond SIX_LINK_FAR. Stumpff
 * functions are series, with more terms above 1/4 (half a radian); above 4 they use sine and cosine.
 */
#include "six_link_real.h"

SIX_LINK_TARGETS six_link_sincos six_link_sine_cosine(six_link_real x)
{
    six_link_sincos y;
#ifndef SIX_LINK_LIBM
    /* sine of whole quarter turns; their cosine is one further */
    static const six_link_real TURN[5] = { 0, 1, 0, -1, 0 };
    if (x >= -SIX_LINK_FAR && x <= SIX_LINK_FAR) {
        const int whole = x < -SIX_LINK_REAL(0.785) || x > SIX_LINK_REAL(0.785);
        unsigned turn = 0;
        six_link_real r = x, rest = 0;
        if (whole != 0) {
            const six_link_real shifted = x * SIX_LINK_REAL(0.63661977236758134308) + SIX_LINK_ROUND;
            const six_link_real k = shifted - SIX_LINK_ROUND;
            const six_link_real a = x - k * SIX_LINK_QUARTER_1, b = k * SIX_LINK_QUARTER_2, ab = a - b;
            const six_link_real d = k * SIX_LINK_QUARTER_3, left = ab - d;
            turn = (unsigned)(int)k & 3u;
            r = left;
            rest = (((a - ab) - b) + ((ab - left) - d)) - k * SIX_LINK_QUARTER_4;
        }
        {
            const six_link_real z = r * r, w = z * z, half = z * SIX_LINK_REAL(0.5), cube = z * r, nearly = 1 - half;
            const six_link_real s = r
                - ((z * (rest * SIX_LINK_REAL(0.5) - cube * SIX_LINK_SINE(z, w)) - rest) + cube * SIX_LINK_SIXTH);
            const six_link_real c = nearly + (((1 - nearly) - half) + (z * (z * SIX_LINK_COSINE(z, w)) - r * rest));
            y.sine = s;
            y.cosine = c;
            if (whole != 0) {
                y.sine = s * TURN[turn + 1] + c * TURN[turn];
                y.cosine = c * TURN[turn + 1] - s * TURN[turn];
            }
        }
        return y;
    }
#endif
    y.sine = six_link_libm_sin(x);
    y.cosine = six_link_libm_cos(x);
    return y;
}

SIX_LINK_TARGETS six_link_real six_link_c4(six_link_real x)
{
    const six_link_real square = x * x;
    six_link_real tail = SIX_LINK_REAL(4.779477332387385e-14);
    if (x >= 4) {
        const six_link_real angle = six_link_sqrt(x);
        return (six_link_libm_cos(angle) - 1 + x / 2) / (x * x);
    }
    if (x >= SIX_LINK_REAL(0.25)) {
        tail = SIX_LINK_REAL(3.7699876288159054e-33);
        tail = SIX_LINK_REAL(3.279889237069838e-30) - x * tail;
        tail = SIX_LINK_REAL(2.4795962632247976e-27) - x * tail;
        tail = SIX_LINK_REAL(1.6117375710961184e-24) - x * tail;
        tail = SIX_LINK_REAL(8.896791392450574e-22) - x * tail;
        tail = SIX_LINK_REAL(4.110317623312165e-19) - x * tail;
        tail = SIX_LINK_REAL(1.5619206968586225e-16) - x * tail;
        tail = SIX_LINK_REAL(4.779477332387385e-14) - x * tail;
    }
    return (SIX_LINK_REAL(0.041666666666666664) - x * SIX_LINK_REAL(0.001388888888888889))
        + square * ((SIX_LINK_REAL(2.48015873015873e-05) - x * SIX_LINK_REAL(2.755731922398589e-07))
            + square * ((SIX_LINK_REAL(2.08767569878681e-09) - x * SIX_LINK_REAL(1.1470745597729725e-11))
            + square * tail));
}

SIX_LINK_TARGETS six_link_real six_link_c5(six_link_real x)
{
    const six_link_real square = x * x;
    six_link_real tail = SIX_LINK_REAL(2.8114572543455206e-15);
    if (x >= 4) {
        const six_link_real angle = six_link_sqrt(x);
        return (six_link_libm_sin(angle) - angle + angle * x / 6) / (x * x * angle);
    }
    if (x >= SIX_LINK_REAL(0.25)) {
        tail = SIX_LINK_REAL(1.216125041553518e-34);
        tail = SIX_LINK_REAL(1.1309962886447716e-31) - x * tail;
        tail = SIX_LINK_REAL(9.183689863795546e-29) - x * tail;
        tail = SIX_LINK_REAL(6.446950284384474e-26) - x * tail;
        tail = SIX_LINK_REAL(3.868170170630684e-23) - x * tail;
        tail = SIX_LINK_REAL(1.9572941063391263e-20) - x * tail;
        tail = SIX_LINK_REAL(8.22063524662433e-18) - x * tail;
        tail = SIX_LINK_REAL(2.8114572543455206e-15) - x * tail;
    }
    return (SIX_LINK_REAL(0.008333333333333333) - x * SIX_LINK_REAL(0.0001984126984126984))
        + square * ((SIX_LINK_REAL(2.7557319223985893e-06) - x * SIX_LINK_REAL(2.505210838544172e-08))
            + square * ((SIX_LINK_REAL(1.6059043836821613e-10) - x * SIX_LINK_REAL(7.647163731819816e-13))
            + square * tail));
}
