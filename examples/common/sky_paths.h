/* sky_paths: radiance at places of a scene under a distant light, by path tracing, bounce by bounce. Paths leave over
   the cosine or in a lobe, and go on between the diffuse surfaces until they reach the sky; what they bring is kept apart
   by the number of surfaces that they met. In two independent halves, as everywhere. */
#ifndef EXAMPLES_SKY_PATHS_H
#define EXAMPLES_SKY_PATHS_H

#include <signal.h>

#include "environment.h"
#include "scene.h"

enum { SKY_HALVES = 2, SKY_LIGHTS = 2, SKY_BOUNCES = 24 };     /* lights: the map; its first bands alone */

typedef struct sky_paths {
    const scene       *scene;
    const prt_tracer  *tracer;         /* object ids are parts */
    const environment *light;
    int               bands;           /* of the second light */
    int               samples;         /* paths for each place and half */
    prt_real          bias;
    uint64_t          seed;
    int               threads;
    const char        *what;           /* what the progress line calls it; NULL: silent */
    volatile sig_atomic_t *stop;       /* becomes nonzero: give up; NULL: never */
    int               place_count;
    const prt_point   *places;
    const prt_vec3    *lobe;           /* [place_count] axes of Phong lobes of integral 1; NULL: cosine over pi */
    double            exponent;
    prt_rgb           *out[SKY_HALVES];    /* [place_count][SKY_LIGHTS][SKY_BOUNCES + 1], by surfaces met on the way */
} sky_paths;

/* 0, or -1 with the reason in w, interruption among them. */
int sky_paths_trace(const sky_paths *s, why *w);

#endif
