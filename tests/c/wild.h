/* wild.h: numbers of every size, memory that is watched, and the campaign of a program that conformance/c_wild.py writes. */
#ifndef WILD_H
#define WILD_H

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ARRAY = 4096, SCENARIOS = 5 };

static unsigned long long seed = 20240229;
static const char *now = "";
static long calls[4];
static int failures;

static void expect(int good, const char *what, int number)
{
    if (!good && ++failures < 20) {
        printf("%s: %s (%d) at call %ld\n", now, what, number, calls[0] + calls[1] + calls[2] + calls[3]);
    }
}

static void seen(int status)
{
    expect(status >= 0 && status <= (int)LAST_STATUS, "a status that the header does not list", status);
    ++calls[status & 3];
}

static double draw(void)
{
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return (double)(seed >> 33) / 2147483648.0;
}

static int one_in(int n)
{
    return draw() * n < 1;
}

static void *block(size_t size)
{
    void *made = calloc(1, size ? size : 1);
    if (!made) {
        exit(3);
    }
    return made;
}

/* Memory that nobody wrote: valgrind sees a function that asks what stands there. */
static void *scratch(size_t size)
{
    void *made = malloc(size ? size : 1);
    if (!made) {
        exit(3);
    }
    return made;
}

static void *copy(const void *from, size_t size)
{
    return memcpy(block(size), from, size);
}

static real wild(void)
{
    static const double LIST[] = { 0, NAN, INFINITY, -INFINITY, 1e154, -1e154, 1e300, 5e-324, 1e-310, 1e18, -1e12, 3e6, -100, 1 };
    return (real)LIST[(int)(draw() * (double)(sizeof LIST / sizeof LIST[0]))];
}

static real wild_step(void)
{
    return one_in(4) ? wild() : one_in(8) ? (real)-1e-3 : (real)pow(10, -2 - 4 * draw());
}

static int last_whole;

static int whole_number(void)
{
    last_whole = one_in(2) ? 1 : 0;
    return last_whole;
}

/* The reals of a block; what other members hold is chosen behind. */
static void fill(void *to, size_t size, double value)
{
    real *x = to;
    size_t k;
    for (k = 0; k < size / sizeof(real); ++k) {
        x[k] = (real)value;
    }
}

static void ordinary(void *to, size_t size)
{
    real *x = to;
    size_t k;
    for (k = 0; k < size / sizeof(real); ++k) {
        x[k] = (real)((draw() - 0.5) / 50);
    }
}

static void spoil(void *to, size_t size, int count)
{
    real *x = to;
    for (; count > 0; --count) {
        x[(size_t)(draw() * (double)(size / sizeof(real)))] = wild();
    }
}

/* Ordinary numbers if they may be new, one or two wild ones, or all of any size. */
static void mix(void *to, size_t size, int anew)
{
    real *x = to;
    size_t k;
    const double decades = 300 * draw() * draw();
    if (anew) {
        ordinary(to, size);
    }
    if (one_in(3)) {
        spoil(to, size, 1 + one_in(2));
    } else if (one_in(6)) {
        for (k = 0; k < size / sizeof(real); ++k) {
            x[k] = (real)((draw() < 0.5 ? -1 : 1) * pow(10, decades * (2 * draw() - 1)));
        }
    }
}

static void choose(void *to, size_t size)
{
    int *x = to;
    size_t k;
    for (k = 0; k < size / sizeof(int); ++k) {
        x[k] = (int)(draw() * 3) - one_in(8);
    }
}

static int all_finite(const void *block_, size_t size)
{
    const real *x = block_;
    size_t k;
    for (k = 0; k < size / sizeof(real); ++k) {
        if (!isfinite(x[k])) {
            return 0;
        }
    }
    return 1;
}

static void reset(void);
static void vary(void);

static int campaign(void (*const functions[])(void), const char *const names[], int count, int argc, char **argv)
{
    const long rounds = argc > 1 ? atol(argv[1]) : 1000;
    long n;
    seed += argc > 2 ? (unsigned long long)atol(argv[2]) << 20 : 0;
    now = "reset";
    reset();
    for (n = 0; n < rounds; ++n) {
        const int k = (int)(draw() * count);
        if (one_in(20)) {
            now = "reset";
            reset();
        }
        vary();
        now = names[k];
        functions[k]();
    }
    printf("%ld calls: %ld ok, %ld non-finite, %ld singular, %ld bad argument; %d failures\n",
        calls[0] + calls[1] + calls[2] + calls[3], calls[0], calls[1], calls[2], calls[3], failures);
    return failures != 0;
}

#endif
