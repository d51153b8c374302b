/* relighter: draws a mesh with baked transfer under SH light through OpenGL, before an environment map.

   The fragment shader interpolates the transfer of the triangle's three corners and takes its dot product with the
   light, so that nothing but the light changes when the light changes. Values stay linear float radiance. */
#ifndef EXAMPLES_RELIGHTER_H
#define EXAMPLES_RELIGHTER_H

#include "camera.h"
#include "gl.h"
#include "image.h"
#include "mesh.h"

typedef struct relighter {
    int      width, height;
    int      triangle_count, bands;
    GLuint   framebuffer, color, depth, no_attributes;
    GLuint   points, triangles, transfer, transfer_texels, light, environment;
    GLuint   mesh_program, background_program;
} relighter;

/* A context must be current. width and height count samples, see picture in image.h. */
int  relighter_create(relighter *r, const mesh *m, int width, int height, why *w);
void relighter_destroy(relighter *r);

/* Whether the mesh with so many bands fits into this OpenGL's buffers: to be asked before a long bake. */
int  relighter_fits(int bands, const mesh *m, why *w);

/* transfer[point_count][bands^2] of the mesh that the relighter was created with. */
int  relighter_set_transfer(relighter *r, int bands, const mesh *m, const prt_real *transfer, why *w);
int  relighter_set_environment(relighter *r, const image *environment, why *w);

/* Draws under light[3][bands^2] with a grey albedo. out (created by the caller with r's width and height) receives the
   radiance, alpha 1 on the mesh and 0 on the background; NULL: only draws. seconds, if not NULL: the
   processor time of the mesh pass, light upload included, background and reading back excluded. */
int  relighter_draw(relighter *r, const camera *c, const prt_real *light, double albedo, picture *out, double *seconds,
                    why *w);

#endif
