/* cube_light: distant light on the six faces of a cube, as an environment to bake from and as a list of small lights to
   sum over or to draw samples from. Faces and rows as in prt_sh_project_cubemap_rgb. */
#ifndef EXAMPLES_CUBE_LIGHT_H
#define EXAMPLES_CUBE_LIGHT_H

#include "image.h"
#include "prt.h"

typedef struct cube_light {
    int    size;                       /* texels along an edge of a face */
    float  *texels;                    /* [6][size][size] r, g, b: radiance */
    const float *faces[6];             /* into texels */
    /* The texels that are not black, after cube_light_ready: direction of the centre, radiance times solid angle. */
    int    count, *texel;
    float  *x, *y, *z, *r, *g, *b;
    double *cumulative;                /* [count + 1] of luminance times solid angle, 0 to 1 */
    int    *guide;                     /* [count + 1] the light in whose part of cumulative k / count lies */
} cube_light;

int  cube_light_create(int size, cube_light *c, why *w);               /* all black */
void cube_light_free(cube_light *c);

/* Each texel is the mean of an environment over the texel's solid angle. */
int  cube_light_from_image(const image *environment, int size, cube_light *c, why *w);

/* Adds a patch of texels x texels texels, all of this radiance, around the texel that holds the direction. */
void cube_light_add_patch(cube_light *c, prt_vec3 towards, int texels, float r, float g, float b);

/* What lies below the horizon becomes the radiance of an unshadowed ground of this albedo, the same everywhere. */
void cube_light_set_ground(cube_light *c, prt_rgb albedo);

/* Makes the list, once the texels stand. */
int  cube_light_ready(cube_light *c, why *w);

/* The same light on texels cut into parts x parts, with its list: sums over it come nearer to texels that are areas. */
int  cube_light_refine(const cube_light *from, int parts, cube_light *c, why *w);

/* Towards a place on a face, 0 <= s, t <= 1 along its columns and rows. */
prt_vec3 cube_light_direction(int face, double s, double t);
/* The texel that a direction meets. */
int      cube_light_texel(const cube_light *c, prt_vec3 direction);
double   cube_light_solid_angle(const cube_light *c, int texel);

/* A light of the list with a chance that goes with its luminance times solid angle, and a place on it; u, v in [0,1).
   Returns its number in the list and the chance. */
int  cube_light_draw(const cube_light *c, double u, double v, prt_vec3 *direction, double *chance);

/* Irradiance under open sky, by summing the list. */
void cube_light_irradiance(const cube_light *c, prt_vec3 normal, double rgb[3]);

#endif
