/* vector: the little algebra of three numbers that scenes and tracers need. */
#ifndef EXAMPLES_VECTOR_H
#define EXAMPLES_VECTOR_H

#include <math.h>

#include "prt.h"

static const double pi = 3.14159265358979323846;

static inline prt_vec3 vec(double x, double y, double z) {
    prt_vec3 v;
    v.x = (prt_real)x; v.y = (prt_real)y; v.z = (prt_real)z;
    return v;
}
static inline prt_rgb rgb(double r, double g, double b) {
    prt_rgb c;
    c.r = (prt_real)r; c.g = (prt_real)g; c.b = (prt_real)b;
    return c;
}
static inline double vec_dot(prt_vec3 a, prt_vec3 b) {
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}
/* a + s b */
static inline prt_vec3 vec_add(prt_vec3 a, prt_real s, prt_vec3 b) {
    a.x += s * b.x; a.y += s * b.y; a.z += s * b.z;
    return a;
}
/* v / |v|, or `otherwise` where v has no length. */
static inline prt_vec3 vec_unit(prt_vec3 v, prt_vec3 otherwise) {
    double length = sqrt(vec_dot(v, v));
    return length > 0 ? vec((double)v.x / length, (double)v.y / length, (double)v.z / length) : otherwise;
}
/* d reflected about the plane with unit normal n. */
static inline prt_vec3 vec_reflect(prt_vec3 d, prt_vec3 n) { return vec_add(d, (prt_real)(-2 * vec_dot(d, n)), n); }

/* A vector about +z, turned so that +z comes to lie on `axis`. */
static inline prt_vec3 turn_to(prt_vec3 axis, prt_vec3 v) {
    double sign = axis.z < 0 ? -1 : 1, a = -1 / (sign + (double)axis.z), b = (double)axis.x * (double)axis.y * a;
    prt_vec3 t = vec(1 + sign * (double)axis.x * (double)axis.x * a, sign * b, -sign * (double)axis.x);
    prt_vec3 o = vec(b, sign + (double)axis.y * (double)axis.y * a, -(double)axis.y);    /* [Duff 2017] */
    prt_vec3 out = vec(0, 0, 0);
    out = vec_add(out, v.x, t);
    out = vec_add(out, v.y, o);
    return vec_unit(vec_add(out, v.z, axis), axis);
}

/* r v for a row-major rotation r. */
static inline prt_vec3 vec_turn(const prt_real r[9], prt_vec3 v) {
    return vec((double)(r[0] * v.x + r[1] * v.y + r[2] * v.z), (double)(r[3] * v.x + r[4] * v.y + r[5] * v.z),
               (double)(r[6] * v.x + r[7] * v.y + r[8] * v.z));
}
static inline prt_vec3 vec_turn_back(const prt_real r[9], prt_vec3 v) {
    return vec((double)(r[0] * v.x + r[3] * v.y + r[6] * v.z), (double)(r[1] * v.x + r[4] * v.y + r[7] * v.z),
               (double)(r[2] * v.x + r[5] * v.y + r[8] * v.z));
}
/* The rotation by an angle about an axis of length 1: Rodrigues' formula. */
static inline void rotation_about(prt_vec3 axis, double angle, prt_real r[9]) {
    double c = cos(angle), s = sin(angle), x = (double)axis.x, y = (double)axis.y, z = (double)axis.z;
    const double m[9] = { c + x * x * (1 - c),     x * y * (1 - c) - z * s, x * z * (1 - c) + y * s,
                          y * x * (1 - c) + z * s, c + y * y * (1 - c),     y * z * (1 - c) - x * s,
                          z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c) };
    int k;
    for (k = 0; k < 9; k++) r[k] = (prt_real)m[k];
}

static inline prt_rgb rgb_times(prt_rgb a, prt_rgb b) {
    return rgb((double)(a.r * b.r), (double)(a.g * b.g), (double)(a.b * b.b));
}
static inline prt_rgb rgb_scale(prt_rgb a, double s) { return rgb(s * (double)a.r, s * (double)a.g, s * (double)a.b); }
static inline double  rgb_mean(prt_rgb c) { return ((double)c.r + (double)c.g + (double)c.b) / 3; }

#endif
