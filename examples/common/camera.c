#include "camera.h"

#include <math.h>
#include <string.h>

#include <cglm/cglm.h>

camera camera_orbit(prt_vec3 target, double distance, double azimuth, double elevation, double field) {
    camera c;
    c.target = target;
    c.field = field;
    c.eye.x = (prt_real)((double)target.x + distance * cos(elevation) * cos(azimuth));
    c.eye.y = (prt_real)((double)target.y + distance * cos(elevation) * sin(azimuth));
    c.eye.z = (prt_real)((double)target.z + distance * sin(elevation));
    return c;
}

static void look_matrix(const camera *c, mat4 view) {
    vec3 eye, target, up = { 0, 0, 1 };
    eye[0] = (float)c->eye.x; eye[1] = (float)c->eye.y; eye[2] = (float)c->eye.z;
    target[0] = (float)c->target.x; target[1] = (float)c->target.y; target[2] = (float)c->target.z;
    glm_lookat(eye, target, up, view);
}

camera_frame camera_make_frame(const camera *c, double aspect) {
    double tangent = tan(0.5 * c->field);
    camera_frame f;
    mat4 view;
    int k;
    look_matrix(c, view);                                   /* its rows are right, up and backward */
    for (k = 0; k < 3; k++) {
        f.right[k] = tangent * aspect * (double)view[k][0];
        f.up[k] = tangent * (double)view[k][1];
        f.forward[k] = -(double)view[k][2];
    }
    return f;
}

void camera_clip_from_world(const camera *c, double aspect, double near_plane, double far_plane, float matrix[16]) {
    mat4 view, projection, product;
    look_matrix(c, view);
    glm_perspective((float)c->field, (float)aspect, (float)near_plane, (float)far_plane, projection);
    glm_mat4_mul(projection, view, product);
    memcpy(matrix, product, 16 * sizeof *matrix);
}
