/* noise.h: noise with deviation 1, the same on every machine; each program includes it once. */
#ifndef NOISE_H
#define NOISE_H

#include <stdint.h>

#include "model.h"

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

#endif
