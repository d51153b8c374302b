/* scene: parts with materials in one mesh; the shapes of [Sherif 2013], figure 7.22, a mesh from a file on a platform,
   and what a tracer and a shader need to know of the places that rays hit. */
#ifndef EXAMPLES_SCENE_H
#define EXAMPLES_SCENE_H

#include "camera.h"
#include "embree_tracer.h"
#include "image.h"

/* Phong's model as in the thesis: a light of colour c, whatever its distance, gives c (diffuse max(0, N.l) +
   specular max(0, r.l)^shininess), r the eye ray reflected. Light from all around, of radiance L, gives accordingly
   (1/pi) int L (diffuse max(0, N.w) + specular max(0, r.w)^shininess) dw: a point light is a delta of irradiance
   pi c. */
typedef struct material {
    prt_rgb  diffuse, specular, transmissive;              /* transmissive: 0 opaque ... 1 clear */
    prt_real shininess, index;                             /* index of refraction, where transmissive */
} material;

typedef struct scene_part {
    const char *name;
    int        first_point, point_count, first_triangle, triangle_count;
    material   material;
} scene_part;

enum { SCENE_PARTS = 16 };

typedef struct scene {
    mesh       mesh;                   /* all parts, one after the other; they share no vertex */
    int        part_count;
    scene_part parts[SCENE_PARTS];
} scene;

/* Orange torus, red tube, blue pot with spout and handle, white and green sphere on a platform: 5013 vertices at
   fineness 1, as in the thesis; both directions of every part are cut into `fineness` times as many strips. */
int  scene_shapes(double fineness, scene *s, why *w);

/* A small white ball over a wide platform: what lengthens a shadow. */
int  scene_ball(double fineness, scene *s, why *w);

/* Two balls in a room without ceiling and front, a red wall to the left and a green one to the right: what makes light
   go back and forth. */
int  scene_room(double fineness, scene *s, why *w);

/* A clear and a red ball of glass and a white one on a platform: what makes caustics. */
int  scene_glass(double fineness, scene *s, why *w);

/* The floor of a sea, with a black pearl and a red ball on it, under a slab of water. */
int  scene_pool(double fineness, scene *s, why *w);

/* A mesh of a file, standing on a platform of `strips` x `strips` squares; with four coloured balls around it. up:
   which axis of the file points upwards, "+x", "-x", "+y" ... */
int  scene_statue(const char *path, const char *up, int strips, scene *s, why *w);

void scene_free(scene *s);

/* No part shines: specular colours become black. */
void scene_make_matte(scene *s);

int  scene_part_of_point(const scene *s, int point);

/* Hands every part to Embree, its number as object id. */
int  scene_trace_with(const scene *s, embree_tracer *t, why *w);

/* The triangle of the whole mesh, and of it the place that was hit: normal interpolated; position moved out to the
   surface that the normals describe [Hanika 2021], so that coarse triangles do not shade themselves. */
int       scene_triangle(const scene *s, const prt_hit *hit);
prt_point scene_place(const scene *s, const prt_hit *hit);

/* The place on the triangle itself, where light goes through or comes from behind. */
prt_vec3  scene_place_flat(const scene *s, const prt_hit *hit);

/* What a camera sees, sample by sample, and a picture with a colour for each vertex, interpolated as OpenGL would. */
typedef struct view {
    camera   eye;
    int      width, height;            /* samples */
    prt_ray  *rays;                    /* [width * height] */
    prt_hit  *hits;
} view;

int  view_create(const scene *s, const embree_tracer *t, camera eye, int width, int height, view *v, why *w);
void view_free(view *v);

/* alpha is 1 on surfaces, 0.5 where a part is transmissive, 0 on the background, which shows `background`. */
int  view_paint(const view *v, const scene *s, const prt_rgb *colors, prt_rgb background, picture *to, why *w);

#endif
