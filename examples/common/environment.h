/* environment: an environment map with what it takes to shade from it and to sample it. */
#ifndef EXAMPLES_ENVIRONMENT_H
#define EXAMPLES_ENVIRONMENT_H

#include <stddef.h>

#include "image.h"
#include "prt.h"

enum { ENVIRONMENT_BANDS = 8 };

typedef struct environment {
    char     name[32];
    image    map;
    prt_real light[3 * PRT_SH_COUNT(ENVIRONMENT_BANDS)];
    double   *cumulative;              /* [texels + 1] of luminance times solid angle, 0 to 1 */
    double   scale;                    /* density of a direction: luminance of its texel times this */
} environment;

/* Loads a map, turned by so many turns about +z. Refuses a black one. 0, or -1 with the reason in w. */
int  environment_load(const char *path, double turn, environment *e, why *w);
void environment_free(environment *e);

/* The first bands of its light: light[3][bands^2]. */
void environment_light(const environment *e, int bands, prt_real *light);

/* The texel that a direction meets. */
size_t environment_texel(const environment *e, prt_vec3 direction);

/* A direction with density luminance * scale: u chooses the texel and the place across it, v the place down it. */
prt_vec3 environment_sample(const environment *e, double u, double v, size_t *texel);

/* Adds what an open ray tells of exit radiance, L cos/pi / (n_cosine p_cosine + n_light p_light): the balance heuristic
   [Veach 1995] of so many rays of cosine distribution and so many from environment_sample. */
void environment_add(const environment *e, size_t texel, double cosine, int cosine_rays, int light_rays, double sum[3]);

#endif
