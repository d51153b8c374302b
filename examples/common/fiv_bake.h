/* fiv_bake: bakes a shape's table of fullsphere irradiance vectors on several threads: under one light, or in the form
   that takes any light of some bands, for shapes that turn. */
#ifndef EXAMPLES_FIV_BAKE_H
#define EXAMPLES_FIV_BAKE_H

#include "stage.h"

typedef struct fiv_grid { int theta, phi, rho; prt_real nearest, farthest; } fiv_grid;

typedef struct fiv_baked {
    prt_fiv_env   env;
    prt_fiv_desc  desc;
    prt_real      *rho;
    unsigned char *inside;
    prt_fiv       *samples;            /* one of these two */
    prt_real      *coefficients;
    prt_fiv_table table;               /* point to the above: samples is NULL, or */
    prt_fiv_transfer transfer;         /* has 0 bands */
    double        seconds, processor;  /* what the bake took: wall, and processors together */
} fiv_baked;

typedef struct fiv_bake_job {
    const shape      *shape;
    const cube_light *light;           /* bands 0 */
    int              bands;            /* of any light; 0: under this one */
    fiv_grid         grid;             /* distances in units of the shape's radius */
    int              rays;             /* as in prt_fiv_desc */
    int              mark_inside;      /* finds the samples inside the shape: needed for self-shadow */
    int              threads;
    const char       *what;            /* of the progress line; NULL: silent */
    const char       *keep;            /* a directory where finished tables stay and are looked for; NULL: none */
    volatile sig_atomic_t *stop;
} fiv_bake_job;

/* 0, or -1 with the reason in w. */
/* b must stay where it is: it points into itself. */
int  fiv_bake_run(const fiv_bake_job *job, fiv_baked *b, why *w);
void fiv_baked_free(fiv_baked *b);

/* The vectors of a table baked with bands, for a body that is turned so in the world: light[3][bands^2] in the world;
   samples [prt_bake_fiv_count] in the body's frame. */
int  fiv_baked_light(const fiv_baked *b, const prt_real *light, const prt_real rotation[9], prt_fiv *samples, why *w);

void fiv_env_of(const cube_light *light, prt_fiv_env *env);

#endif
