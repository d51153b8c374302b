/* Vectors and random numbers for tests, the same in every run; random_state may be set where a test must not depend on
   those before it. Included after prt.h. */
#ifndef PRT_TESTS_GEOMETRY_H
#define PRT_TESTS_GEOMETRY_H

#include <math.h>
#include <stdint.h>

static const double pi = 3.14159265358979323846;
static uint64_t random_state = 88172645463325252u;

static inline prt_vec3 vec3(double x, double y, double z) {
    prt_vec3 v;
    v.x = (prt_real)x; v.y = (prt_real)y; v.z = (prt_real)z;
    return v;
}

static inline prt_rgb rgb(double r, double g, double b) {
    prt_rgb c;
    c.r = (prt_real)r; c.g = (prt_real)g; c.b = (prt_real)b;
    return c;
}

static inline prt_vec3 scaled(prt_vec3 v, double s) {
    return vec3(s * (double)v.x, s * (double)v.y, s * (double)v.z);
}

static inline double dot(prt_vec3 a, prt_vec3 b) {
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

/* [0, 1): xorshift [Marsaglia 2003] */
static inline double uniform(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (double)(random_state >> 11) / 9007199254740992.0;
}

static inline double signed_uniform(void) { return 2 * uniform() - 1; }

/* evenly over the sphere */
static inline prt_vec3 random_direction(void) {
    const double z = signed_uniform(), phi = 2 * pi * uniform(), s = sqrt(1 - z * z);
    return vec3(s * cos(phi), s * sin(phi), z);
}

/* every element in [-1, 1) */
static inline void random_vector(int count, prt_real *f) {
    int i;
    for (i = 0; i < count; i++) f[i] = (prt_real)signed_uniform();
}

#endif
