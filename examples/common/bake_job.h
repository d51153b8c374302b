/* bake_job: a bake of diffuse transfer that uses several threads, can be interrupted, and keeps what is finished.

   prt_bake_transfer gives a point the same bits whichever range it is asked in; so the threads take small ranges of the
   points that are still missing, and a bake that was interrupted and resumed equals one that was not. */
#ifndef EXAMPLES_BAKE_JOB_H
#define EXAMPLES_BAKE_JOB_H

#include <signal.h>

#include "prt_bake.h"
#include "why.h"

typedef struct bake_job {
    prt_bake_desc    desc;             /* its progress callback is the job's */
    int              point_count;
    const prt_point  *points;
    int              threads;
    const char       *what;            /* what the progress line calls it; NULL: silent */
    volatile sig_atomic_t *stop;       /* becomes nonzero: stop after the points at hand; NULL: never */
    double           checkpoint_every; /* seconds between calls of checkpoint; 0: none */
    /* Called from the thread that runs the job, with the marks of what is finished so far. */
    void             (*checkpoint)(void *user, const unsigned char *done, const prt_real *transfer);
    void             *user;
    unsigned char    *done;            /* [point_count] in and out: points whose row is finished */
    prt_real         *transfer;        /* [point_count][bands^2] in and out */
} bake_job;

/* PRT_OK: every point is finished; PRT_ERR_CANCELLED: stopped, what is done is marked; else why it failed. */
prt_result bake_job_run(bake_job *job);

int processor_count(void);

#endif
