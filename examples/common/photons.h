/* photons: light that point lights send through transmissive parts onto the rest: caustics [Jensen 1996]. A light of
   colour c, whatever its distance, so a photon's power grows with the square of the way that it went. */
#ifndef EXAMPLES_PHOTONS_H
#define EXAMPLES_PHOTONS_H

#include "scene.h"

typedef struct photon { prt_vec3 position, dir; prt_rgb power; int light, next; } photon;

typedef struct photon_map {
    int    count, cells;               /* cells: a power of two */
    double radius;                     /* of the disc over which the density is estimated */
    photon *photons;
    int    *first;                     /* [cells]: chains through photon.next, -1: none */
} photon_map;

/* So many photons from each light towards each transmissive part; kept where they end on an opaque surface after they
   went through one at least. Snell's law, total reflection, nothing lost by partial reflection. */
int  photon_map_make(const scene *s, const prt_tracer *t, int light_count, const prt_point_light *lights, int photons,
                     double radius, uint64_t seed, photon_map *map, why *w);
void photon_map_free(photon_map *map);

/* Adds to sum[group[light]] (group NULL: sum[0]) the irradiance over pi at a place with this normal. */
void photon_map_add(const photon_map *map, prt_vec3 position, prt_vec3 normal, const int *group, prt_rgb *sum);

/* Snell's law at a surface whose unit normal points against `dir`; ratio: index before over index behind. The mirror
   direction where light is reflected totally. */
prt_vec3 refracted(prt_vec3 dir, prt_vec3 normal, double ratio);

#endif
