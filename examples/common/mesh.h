/* mesh: triangles from a file (OBJ, PLY, glTF, 3DS and whatever else assimp reads), ready to bake and to draw.

   The whole scene of the file becomes one indexed mesh: node transforms applied, vertices merged where position and
   normal agree, polygons cut into triangles, points and lines left out. Files are taken as y-up, as assimp hands them
   over, and turned to this project's z-up: (x, y, z) -> (x, -z, y); MESH_Z_UP leaves them. */
#ifndef EXAMPLES_MESH_H
#define EXAMPLES_MESH_H

#include <stdint.h>

#include "prt_bake.h"
#include "why.h"

typedef struct mesh {
    int       point_count, triangle_count;
    prt_point *points;                 /* position and unit normal of each vertex */
    uint32_t  *triangles;              /* three vertices each */
    int       transmissive_faces;      /* of the file, whose material lets light through (opacity below 1) */
    prt_mesh_report report;            /* normals that were computed, triangles without area (kept), extent */
} mesh;

typedef enum mesh_up { MESH_Y_UP = 0, MESH_Z_UP } mesh_up;

/* Loads a file. Refuses what cannot be read, has no triangles, or has a position that is not finite. 0, or -1 and w. */
int  mesh_load(const char *path, mesh_up up, mesh *m, why *w);
void mesh_free(mesh *m);
int  mesh_copy(const mesh *from, mesh *to, why *w);

/* Moves and scales to a bounding sphere of radius 1 about the origin (the middle of the bounding box). A mesh without
   extent is refused. */
int  mesh_fit_unit_sphere(mesh *m, why *w);

/* Cuts the edges that `wanted` returns nonzero for (NULL: all) at their middles, and each triangle by those of its edges
   that are cut, into two, three or four: the same surface, finer, without a crack. The new points stand behind the old
   ones and have the normal that shading interpolates there; the ends of the edge that each of them cuts go to
   *ends[2 * new points], allocated here, the caller's to free (NULL: not wanted). */
typedef int (*mesh_edge_test)(void *user, uint32_t a, uint32_t b);
int  mesh_cut_edges(mesh *m, mesh_edge_test wanted, void *user, uint32_t **ends, why *w);

/* Adds a round floor under the lowest point, with normal +z: rings of neighbouring triangles, `spacing` apart. */
int  mesh_add_floor(mesh *m, prt_vec3 centre, prt_real radius, prt_real spacing, why *w);

/* FNV-1a, 64 bits, of positions and normals as little-endian floats and of the triangles. */
uint64_t mesh_hash(const mesh *m);

#endif
