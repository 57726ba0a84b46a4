/* driver.h: what the drivers share: memory that is watched, and a count of what was not as it should be. */
#ifndef DRIVER_H
#define DRIVER_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures;

/* What the functions are given: a block of its own, so that reading or writing past its end shows. */
static void *scratch(size_t size)
{
    void *block = malloc(size);
    if (!block) {
        exit(3);
    }
#ifdef FILL
    memset(block, FILL, size);
#endif
    return block;
}

static void expect(int good, const char *what, int number)
{
    if (!good && ++failures < 20) {
        printf("%s (%d)\n", what, number);
    }
}

#endif
