/* mesh_import: what assimp makes of a file, as plain arrays. assimp runs in a process of its own: on damaged files
   (PLY above all) it crashes, throws through its C interface, or never ends. */
#ifndef EXAMPLES_MESH_IMPORT_H
#define EXAMPLES_MESH_IMPORT_H

#include "prt.h"
#include "why.h"

typedef struct raw_mesh {
    int      vertex_count, triangle_count;
    prt_vec3 *positions, *normals;     /* as in the file; normals are zero where the file has none */
    uint32_t *triangles;
    int      transmissive_faces;       /* of the file, whose material lets light through */
} raw_mesh;

/* The whole scene in one mesh of at least one triangle. Call it while the program has one thread. 0, or -1 and w. */
int  raw_mesh_import(const char *path, raw_mesh *m, why *w);
void raw_mesh_free(raw_mesh *m);

#endif
