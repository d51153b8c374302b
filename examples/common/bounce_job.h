/* bounce_job: one bounce of interreflection on several threads, that can be interrupted; and what prt_bake_bounce wants
   to know of a mesh or a scene. */
#ifndef EXAMPLES_BOUNCE_JOB_H
#define EXAMPLES_BOUNCE_JOB_H

#include <signal.h>

#include "scene.h"

typedef struct bounce_job {
    prt_bounce_desc  desc;             /* its progress callback is the job's */
    int              point_count;
    const prt_point  *points;
    const prt_real   *previous;        /* as prt_bake_bounce */
    prt_real         *out;
    int              threads;
    const char       *what;            /* what the progress line calls it; NULL: silent */
    volatile sig_atomic_t *stop;       /* becomes nonzero: give up; NULL: never */
} bounce_job;

/* 0, or -1 with the reason in w, interruption among them. */
int bounce_job_run(const bounce_job *job, why *w);

/* All of a mesh as one object of this albedo. */
prt_bounce_object bounce_object_of(const mesh *m, prt_rgb albedo);

/* The parts of a scene with their diffuse colours, by number: objects[SCENE_PARTS]. */
void bounce_objects_of(const scene *s, prt_bounce_object *objects);

#endif
