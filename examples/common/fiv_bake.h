/* fiv_bake: bakes a shape's table of fullsphere irradiance vectors on several threads. */
#ifndef EXAMPLES_FIV_BAKE_H
#define EXAMPLES_FIV_BAKE_H

#include "stage.h"

typedef struct fiv_grid { int theta, phi, rho; prt_real nearest, farthest; } fiv_grid;

typedef struct fiv_baked {
    prt_fiv_env   env;
    prt_fiv_desc  desc;
    prt_real      *rho;
    prt_fiv       *samples;
    unsigned char *inside;
    prt_fiv_table table;               /* points to the above */
    double        seconds, processor;  /* what the bake took: wall, and processors together */
} fiv_baked;

typedef struct fiv_bake_job {
    const shape      *shape;
    const cube_light *light;
    fiv_grid         grid;             /* distances in units of the shape's radius */
    int              rays;             /* as in prt_fiv_desc */
    int              mark_inside;      /* finds the samples inside the shape: needed for self-shadow */
    int              threads;
    const char       *what;            /* of the progress line; NULL: silent */
    volatile sig_atomic_t *stop;
} fiv_bake_job;

/* 0, or -1 with the reason in w. */
/* b must stay where it is: it points into itself. */
int  fiv_bake_run(const fiv_bake_job *job, fiv_baked *b, why *w);
void fiv_baked_free(fiv_baked *b);

void fiv_env_of(const cube_light *light, prt_fiv_env *env);

#endif
