/* vo_compare_limit: batched shading against the rate at which the same build multiplies and adds. */
#ifndef EXAMPLES_VO_COMPARE_LIMIT_H
#define EXAMPLES_VO_COMPARE_LIMIT_H

#include "prt.h"

typedef struct limit_job {             /* the arguments of prt_vo_shade_n, opaque occluders */
    const prt_vo_params   *params;
    int                   count;
    const prt_vo_point    *points;
    prt_vec3              eye;
    const int             *first;
    const prt_vo_occluder *occluders;
    int                   light_count;
    const prt_point_light *lights;
    prt_rgb               *out;
} limit_job;

typedef struct limit {
    const char *flags;
    int        lanes;                  /* points side by side */
    double     seconds, rate;          /* least time of the job; multiplications and additions a second, at most */
    double     operations, carried;    /* of the job; and those of lanes that wait for neighbours with more occluders */
    double     both;                   /* operations for one point, occluder and light */
} limit;

/* One function for each set of flags: vo_compare_limit.c is compiled so often. */
#define LIMIT_BUILDS(X) X(portable) X(native)
#define LIMIT_DECLARE(id) limit limit_##id(const limit_job *job, int runs);
LIMIT_BUILDS(LIMIT_DECLARE)

#endif
