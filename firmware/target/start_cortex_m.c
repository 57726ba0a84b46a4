/* start_cortex_m.c: vector table and what runs before main: FPU, .data, .bss, console.
 * With -DCONSOLE input and output go through semihosting (newlib's librdimon); without it there is none.
 */
#include <stdint.h>

extern char data_begin[], data_end[], data_image[], bss_begin[], bss_end[];
extern const uint32_t stack_top[];

int main(void);
void reset(void);
void fault(void);

#define CPACR (*(volatile uint32_t *)0xE000ED88u)

#ifdef CONSOLE
#include <stdlib.h>

void initialise_monitor_handles(void);
void _fini(void);

/* newlib's exit calls it; the C library's own start-up files, which have it, are left out. */
void _fini(void)
{
}
#else
int *__errno(void);

/* Where libm leaves its errors. newlib's own would bring its whole context along, a kilobyte of RAM. */
int *__errno(void)
{
    static int last;
    return &last;
}
#endif

/* A fault ends the emulation with status 3 (SYS_EXIT_EXTENDED); a board waits here for its debugger. */
void fault(void)
{
#ifdef CONSOLE
    static const uint32_t REASON[2] = { 0x20026u, 3 };
    register uint32_t operation __asm("r0") = 0x20;
    register const uint32_t *reason __asm("r1") = REASON;
    __asm volatile("bkpt 0xAB" : : "r"(operation), "r"(reason) : "memory");
#endif
    for (;;) {
    }
}

void reset(void)
{
    volatile char *to;
    const char *from = data_image;
    CPACR |= 0xFu << 20; /* full access to the FPU, coprocessors 10 and 11 */
    __asm volatile("dsb\n\tisb" : : : "memory");
    for (to = data_begin; to < data_end; ++to, ++from) {
        *to = *from;
    }
    for (to = bss_begin; to < bss_end; ++to) {
        *to = 0;
    }
#ifdef CONSOLE
    initialise_monitor_handles();
    exit(main());
#else
    (void)main();
    fault();
#endif
}

typedef union {
    const uint32_t *stack;
    void (*handler)(void);
} vector;

/* The stack, reset, then NMI and the faults. No interrupt is enabled. */
__attribute__((section(".vectors"), used)) static const vector VECTORS[16] = {
    { .stack = stack_top }, { .handler = reset }, { .handler = fault }, { .handler = fault }, { .handler = fault },
    { .handler = fault }, { .handler = fault }, { .handler = fault }, { .handler = fault }, { .handler = fault },
    { .handler = fault }, { .handler = fault }, { .handler = fault }, { .handler = fault }, { .handler = fault },
    { .handler = fault },
};
