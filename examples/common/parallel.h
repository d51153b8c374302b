/* parallel: a loop over many items on several threads, with a progress line, that can be interrupted. */
#ifndef EXAMPLES_PARALLEL_H
#define EXAMPLES_PARALLEL_H

#include <signal.h>

#include "why.h"

typedef struct parallel {
    int        count, chunk;           /* items, and how many a thread takes at a time */
    int        threads;
    const char *what, *unit;           /* of the progress line; what NULL: silent */
    double     unit_per_item;
    volatile sig_atomic_t *stop;       /* becomes nonzero: take no further chunk; NULL: never */
    int        (*begin)(void *user, void **own);           /* what a thread needs of its own; NULL: nothing */
    int        (*work)(void *user, void *own, int first, int count);
    void       (*end)(void *own);
    void       *user;
    int        done;                   /* out: items that are finished; fewer than count: stopped */
} parallel;

/* 0, or -1 with the reason in w where begin or work return nonzero or no thread can be started. */
int parallel_run(parallel *p, why *w);

/* The same where a part is of no use: -1, "interrupted", if it was stopped before the end. */
int parallel_all(parallel *p, why *w);

#endif
