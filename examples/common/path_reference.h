/* path_reference: light at points of a scene by path tracing: point lights with shadows, diffuse and glossy
   interreflection of many bounces, refraction through transmissive parts, their caustics by photons. Each value comes
   in two independent halves: their mean is the result, their difference tells its noise. */
#ifndef EXAMPLES_PATH_REFERENCE_H
#define EXAMPLES_PATH_REFERENCE_H

#include <signal.h>

#include "photons.h"
#include "scene.h"

/* A place to shade, as seen along `towards` (a unit vector from the eye to the place). part < 0: nothing there. */
typedef struct path_query { prt_vec3 position, normal, towards; int part; } path_query;

enum { PATH_HALVES = 2, PATH_GROUPS = 8, PATH_LIGHTS = 2048 };

typedef struct path_reference {
    const scene           *scene;
    const prt_tracer      *tracer;     /* object ids are parts */
    int                   light_count;
    const prt_point_light *lights;
    const int             *group;      /* [light_count] 0 ... group_count-1: whose light is kept apart; NULL: 0 */
    int                   group_count;
    int                   samples;     /* paths for each query and half; 0: direct light alone */
    int                   depth;       /* bounces, 1: light that was reflected once on its way; at most */
    int                   photons;     /* from each light to each transmissive part, in each half; 0: no caustics. Their
                                          density is taken over discs of .015 of the scene's radius; surfaces answer
                                          diffusely. Further bounces see a 32nd of them */
    prt_real              bias;
    uint64_t              seed;
    int                   threads;
    const char            *what;       /* what the progress line calls it; NULL: silent */
    volatile sig_atomic_t *stop;       /* becomes nonzero: give up what is not done; NULL: never */
    int                   query_count;
    const path_query      *queries;
    prt_rgb               *out[PATH_HALVES];     /* [query_count][group_count] */
    photon_map            caustics[PATH_HALVES], coarse[PATH_HALVES];     /* while it runs */
    int                   done;        /* in: queries that need no work; out: finished ones, from the first on */
} path_reference;

/* 0, or -1 with the reason in w; interrupted: done < query_count. */
int path_reference_trace(path_reference *r, why *w);

/* The same, but takes from the file at `path` what is finished there of the same job (scene, lights, queries, counts),
   and leaves there what is finished at the end, interrupted or not. */
int path_reference_resume(path_reference *r, const char *path, why *w);

#endif
