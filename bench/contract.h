/* contract.h: what the driver knows of a contender. Compiled with -DVARIANT=<symbol> into each of them. */
#ifndef BENCH_CONTRACT_H
#define BENCH_CONTRACT_H

enum { STATES = 8 }; /* states at which every contender runs, in turns */

typedef struct {
    const char *name;
    int results; /* numbers that result() writes, vdot first; 0 where there is nothing to compare */
    void (*init)(void); /* take the states over and prepare what is prepared once */
    int (*call)(int k); /* one evaluation at state k; 0 where it succeeds */
    void (*result)(double *y); /* what the last call gave: vdot, wrench, tip rotation by rows, tip position */
} contender;

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define TEXT2(a) #a
#define TEXT(a) TEXT2(a)

/* Every contender has a call of its own name, which callgrind finds; everything else stays inside. */
#define CALL JOIN(VARIANT, _call)

#endif
