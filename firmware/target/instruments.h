/* instruments.h: counting of instructions and of stack for the measuring programs; each includes it once. */
#ifndef INSTRUMENTS_H
#define INSTRUMENTS_H

#include <stdio.h>

enum { TURNS = 1000 }; /* of the loop whose instructions are known */

/* The counter looks at the addresses of these two. */
__attribute__((noinline, noclone)) void count_begin(void);
__attribute__((noinline, noclone)) void count_end(void);

void count_begin(void)
{
    __asm volatile("" : : : "memory");
}

void count_end(void)
{
    __asm volatile("" : : : "memory");
}

#define COUNT(call)         \
    do {                    \
        count_begin();      \
        (void)(call);       \
        count_end();        \
    } while (0)

/* ------------------------------------------------------------------------------------ painted stack */

enum { PAINTED = 16384 }; /* bytes below the stack pointer */
#define PAINT 0xA5u

#if defined(__arm__)
#define STACK_POINTER(p) __asm volatile("mov %0, sp" : "=r"(p) : : "memory")
#elif defined(__riscv)
#define STACK_POINTER(p) __asm volatile("mv %0, sp" : "=r"(p) : : "memory")
#endif

#ifdef STACK_POINTER
/* Paints below the stack pointer, calls, looks for the deepest byte that has changed. Nothing is pushed in between but
 * by the call itself, and no interrupt is enabled.
 */
#define STACK(name, call)                                                   \
    do {                                                                    \
        volatile unsigned char *sp_, *deepest_;                             \
        long used_;                                                         \
        STACK_POINTER(sp_);                                                 \
        for (deepest_ = sp_ - PAINTED; deepest_ < sp_; ++deepest_) {        \
            *deepest_ = PAINT;                                              \
        }                                                                   \
        (void)(call);                                                       \
        deepest_ = sp_ - PAINTED;                                           \
        while (deepest_ < sp_ && *deepest_ == PAINT) {                      \
            ++deepest_;                                                     \
        }                                                                   \
        used_ = (long)(sp_ - deepest_);                                     \
        printf("stack %s %ld\n", name, used_);                              \
    } while (0)
#else
#define STACK(name, call) (void)(call)
#endif

/* A loop of two instructions between begin and end, all in one piece: twice the turns must count twice the loop. */
__attribute__((noinline, noclone)) static void known(long turns)
{
#if defined(__arm__)
    register long n __asm("r4") = turns;
    __asm volatile("bl count_begin\n1:\tsubs %0, #1\n\tbne 1b\n\tbl count_end"
                   : "+r"(n) : : "r0", "r1", "r2", "r3", "r12", "lr", "cc", "memory");
#elif defined(__riscv)
    register long n __asm("s1") = turns;
    __asm volatile("call count_begin\n1:\taddi %0, %0, -1\n\tbnez %0, 1b\n\tcall count_end"
                   : "+r"(n) : : "ra", "t0", "t1", "t2", "t3", "t4", "t5", "t6", "memory");
#else
    (void)turns;
#endif
}

static void count_known(void)
{
    printf("count empty 1\ncount known 2\n");
    count_begin();
    count_end();
    known(TURNS);
    known(2 * TURNS);
}

#endif
