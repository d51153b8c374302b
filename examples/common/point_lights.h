/* point_lights: an environment as a few point lights, and lights around a scene. */
#ifndef EXAMPLES_POINT_LIGHTS_H
#define EXAMPLES_POINT_LIGHTS_H

#include "image.h"
#include "prt.h"

/* Cuts the map (laid out as image_load_environment leaves it) into `count` regions, always the region of most energy
   next, across its longer side into halves of equal energy: the median cut of [Debevec 2005], for any number of lights.
   Each region becomes a light at its energy's centroid, so far from the origin. A light of colour c stands for the
   irradiance pi c: c = (1/pi) sum of radiance times solid angle. The sum of all colours does not depend on count.
   0, or -1 with the reason in w (more lights than texels, a black map). */
int point_lights_from_map(const image *map, int count, double distance, prt_point_light *lights, why *w);

/* White to tinted lights over the upper half of a sphere about the centre, low-discrepancy, so that the first so many
   of them are spread as well; colour about 1 each. */
void point_lights_around(int count, prt_vec3 centre, double distance, prt_point_light *lights);

#endif
