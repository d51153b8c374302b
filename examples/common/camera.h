/* camera: a pinhole looking at a target with +z up; the same picture for OpenGL and for a ray tracer. */
#ifndef EXAMPLES_CAMERA_H
#define EXAMPLES_CAMERA_H

#include "prt.h"

typedef struct camera {
    prt_vec3 eye, target;
    double   field;                    /* vertical field of view, radians */
} camera;

/* forward is a unit vector; forward + x right + y up, -1 <= x, y <= 1, spans the picture (y upwards). */
typedef struct camera_frame { double right[3], up[3], forward[3]; } camera_frame;

/* Circles the target at a distance: azimuth from +x towards +y, elevation upwards, radians. */
camera camera_orbit(prt_vec3 target, double distance, double azimuth, double elevation, double field);

camera_frame camera_make_frame(const camera *c, double aspect);

/* Column-major, as OpenGL takes it: world to clip space, depth from near to far. */
void camera_clip_from_world(const camera *c, double aspect, double near_plane, double far_plane, float matrix[16]);

#endif
