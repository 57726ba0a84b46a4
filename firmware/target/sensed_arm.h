/* sensed_arm.h: what the programs of filters share: the example arm under a joint law, with encoders and strain gauges
 * that are read with noise, the same on every machine. Each program includes it once, behind the numbers in which they
 * differ: GOAL (set points), PATH (samples until the references reach these), STRAIN (deviation of a gauge), FIBRE (its
 * distance from the centreline, m).
 */
#ifndef SENSED_ARM_H
#define SENSED_ARM_H

#include <stdint.h>
#include <string.h>

#include "model.h"
#include ESTIMATOR_HEADER

static const real DT = (real)1e-3, ENCODER = (real)1e-4;
static const real KP[JOINTS] = { 400, 400, 120 }, KD[JOINTS] = { 28, 28, 12 };

static M(parameters) parameters;
static M(input) input;
static M(output) output;
static M(work) work;
static M(chain) chain;
static M(estimator) filter;
static M(estimator_work) scratch;
static M(measurement) measured;
static M(state) truth;

/* The sum of twelve even numbers, less six. */
static real noise(void)
{
    static uint32_t seed = 1;
    real sum = -6;
    int k;
    for (k = 0; k < 12; ++k) {
        seed = seed * 1664525u + 1013904223u;
        sum += (real)(seed >> 8) / (real)16777216;
    }
    return sum;
}

/* What the filter knows of its sensors, all of which are read. */
static void read_all(void)
{
    int k;
    for (k = 0; k < JOINTS; ++k) {
        filter.encoder_variance[k] = ENCODER * ENCODER;
        measured.has_encoder[k] = 1;
    }
    for (k = 0; k < N(NGAUGES); ++k) {
        filter.strain_variance[k] = STRAIN * STRAIN;
        filter.fibre[k] = FIBRE;
        measured.has_strain[k] = 1;
    }
}

/* PD about a smooth path, and what holds the straight arm of a model against its weight. */
static int control(const M(constants) *c, int n)
{
    static M(state) straight;
    static real rest[N(NV)], force[N(NV)];
    const real s = n < PATH ? (real)n / PATH : (real)1, reference = s * s * (3 - 2 * s);
    int k;
    memcpy(straight.q, truth.q, JOINTS * sizeof(real));
    if (M(inverse_dynamics)(c, &straight, &input, rest, &chain, force, 0) != N(OK)) {
        return 1;
    }
    for (k = 0; k < JOINTS; ++k) {
        input.tau[k] = KP[k] * (reference * GOAL[k] - truth.q[k]) - KD[k] * truth.v[k] + force[k];
    }
    return 0;
}

static void measure(void)
{
    int k;
    for (k = 0; k < JOINTS; ++k) {
        measured.encoder[k] = truth.q[k] + ENCODER * noise();
    }
    for (k = 0; k < N(NGAUGES); ++k) {
        const int mode = 3 * (k / 2) + 1 + k % 2; /* y, z of the upper arm, then of the forearm */
        measured.strain[k] = -FIBRE * filter.curvature[mode] * truth.q[JOINTS + mode] + STRAIN * noise();
    }
}

#endif
