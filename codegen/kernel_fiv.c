/* Kernels of the room >>fiv [Michael 2010]: everything but the loop over occluders and the reading of the table,
   which a program may keep in textures. A fiv is nine values, the vectors of red, green and blue. */
#include "kernels.h"

static void vectors_param(kernel *k, const char *name, vec v[3]) {
    int p = kernel_param(k, name, PARAM_INPUT, 9), c;
    for (c = 0; c < 3; c++) v[c] = vec_element(k, p, 3 * c);
}

static vec along(kernel *k, const vec v[3], vec normal) {
    vec out;
    out.x = vec_dot(k, v[0], normal);
    out.y = vec_dot(k, v[1], normal);
    out.z = vec_dot(k, v[2], normal);
    return out;
}

kernel *describe_fiv_irradiance(int bands) {
    kernel *k = kernel_new("fiv_irradiance", "N.FIV, irradiance of what lies above the surface");
    vec fiv[3];
    (void)bands;
    vectors_param(k, "fiv", fiv);
    vec_result(k, along(k, fiv, vec_param(k, "normal")));
    return k;
}

/* Where there is no direction, that of theta = phi = pi/2, as in prt_fiv_lookup */
static vec direction_or_y(kernel *k, vec to, node *distance) {
    vec dir = vec_direction(k, to, distance);
    dir.y = k_select(k, k_const(k, 0), *distance, dir.y, k_const(k, 1));
    return dir;
}

/* Texture coordinates of a place: theta/pi, phi/(2 pi) in 0 ... 1, distance. With texels at the samples, row theta_i
   of n is at i/(n-1) and column phi_j of n at j/n. */
kernel *describe_fiv_place(int bands) {
    kernel *k = kernel_new("fiv_place", "theta/pi, phi/2pi and distance of an occluder");
    vec to = vec_param(k, "to_centre"), out;
    node zero = k_const(k, 0), across, phi;
    out.z = vec_length(k, to);
    to.y = k_select(k, zero, out.z, to.y, k_const(k, 1));
    across = k_sqrt(k, k_madd(k, to.x, to.x, k_mul(k, to.y, to.y)));
    phi = k_scale(k, 1 / (2 * x_pi()), k_arc_tangent(k, to.y, to.x));
    (void)bands;
    out.x = k_scale(k, 1 / x_pi(), k_arc_tangent(k, across, to.z));
    out.y = k_select(k, phi, zero, k_add(k, phi, k_const(k, 1)), phi);
    vec_result(k, out);
    return k;
}

/* samples[8][9]: rho slowest, then theta, then phi, as in the table; at: weights of the upper samples, theta, phi,
   rho */
kernel *describe_fiv_blend(int bands) {
    kernel *k = kernel_new("fiv_blend", "interpolation between 8 samples of a table");
    node samples[72], out[9], one = k_const(k, 1);
    vec at;
    int i, j;
    (void)bands;
    input_nodes(k, "samples", 72, samples);
    at = vec_param(k, "at");
    for (i = 0; i < 9; i++) out[i] = k_const(k, 0);
    for (j = 0; j < 8; j++) {
        node w = k_mul(k, k_mul(k, j & 4 ? at.z : k_sub(k, one, at.z), j & 2 ? at.x : k_sub(k, one, at.x)),
                       j & 1 ? at.y : k_sub(k, one, at.y));
        for (i = 0; i < 9; i++) out[i] = k_madd(k, w, samples[9 * j + i], out[i]);
    }
    output_nodes(k, "out", 9, out);
    return k;
}

/* sin of the half-angle under which a sphere is seen, 1 from inside; 0 without a radius */
static node sine_of(kernel *k, node radius, node distance) {
    return k_select(k, radius, distance, k_div(k, radius, distance), k_const(k, 1));
}

/* How an occluder stands to the horizon: cosine N.to_centre, sine of its half-angle, u = their ratio in -1 ... 1, and
   sine (g(u) - u) with g(u) = (u acos(-u) + sqrt(1-u^2) (2+u^2)/3)/pi */
typedef struct horizon { node up, sine, u, cut; } horizon;

static horizon horizon_of(kernel *k, vec normal, vec to, node radius) {
    node zero = k_const(k, 0), one = k_const(k, 1), two = k_const(k, 2), distance, square, root;
    vec dir = direction_or_y(k, to, &distance);
    horizon h;
    h.sine = sine_of(k, radius, distance);
    h.up = vec_dot(k, normal, dir);
    h.u = k_select(k, zero, h.sine, k_div(k, h.up, h.sine), zero);
    h.u = k_max(k, k_min(k, h.u, one), k_const(k, -1));
    square = k_mul(k, h.u, h.u);
    root = k_mul(k, k_sqrt(k, k_max(k, k_sub(k, one, square), zero)), k_scale(k, x_ratio(1, 3), k_add(k, two, square)));
    h.cut = k_scale(k, 1 / x_pi(), k_madd(k, h.u, k_arc_cosine(k, k_neg(k, h.u)), root));
    h.cut = k_mul(k, h.sine, k_sub(k, h.cut, h.u));
    return h;
}

/* I = N.FIV where the occluder is above the horizon, N.FIV + |FIV| s (g(u) - u) where it is cut, 0 below; within
   0 ... total */
kernel *describe_fiv_taken(int bands) {
    kernel *k = kernel_new("fiv_taken", "irradiance that one occluder takes");
    node zero = k_const(k, 0), radius, seen;
    vec total = vec_param(k, "total"), normal = vec_param(k, "normal"), fiv[3], to, taken, lit;
    horizon h;
    (void)bands;
    vectors_param(k, "fiv", fiv);
    to = vec_param(k, "to_centre");
    radius = real_param(k, "radius");
    h = horizon_of(k, normal, to, radius);
    lit = along(k, fiv, normal);
#define TAKEN(c, i) k_min(k, k_max(k, k_madd(k, vec_length(k, fiv[i]), h.cut, lit.c), zero), k_max(k, total.c, zero))
    taken.x = TAKEN(x, 0);
    taken.y = TAKEN(y, 1);
    taken.z = TAKEN(z, 2);
#undef TAKEN
    seen = k_select(k, zero, radius, k_select(k, k_const(k, -1), h.u, k_const(k, 1), zero), zero);
    vec_result(k, vec_scale(k, seen, taken));
    return k;
}

/* taken/(total s^2 max(1/1024, N.to_centre + s (g(u) - u))), at most 1: over what the whole disc would take under even
   light */
kernel *describe_fiv_filled(int bands) {
    kernel *k = kernel_new("fiv_filled", "the part of its disc that an occluder fills");
    vec total = vec_param(k, "total"), normal = vec_param(k, "normal"), taken = vec_param(k, "taken"), to, out;
    node zero = k_const(k, 0), one = k_const(k, 1), radius, full, whole;
    horizon h;
    (void)bands;
    to = vec_param(k, "to_centre");
    radius = real_param(k, "radius");
    h = horizon_of(k, normal, to, radius);
    full = k_mul(k, k_mul(k, h.sine, h.sine), k_max(k, k_add(k, h.up, h.cut), k_const(k, x_ratio(1, 1024))));
#define FILLED(c) (whole = k_mul(k, k_max(k, total.c, zero), full), \
                   k_select(k, k_max(k, taken.c, zero), whole, k_div(k, k_max(k, taken.c, zero), whole), one))
    out.x = FILLED(x);
    out.y = FILLED(y);
    out.z = FILLED(z);
#undef FILLED
    vec_result(k, out);
    return k;
}

/* Two discs of radius 2 sin(a/2), the chord apart: their squared radii, the lens over pi, and how far they differ in
   place and radius, squared. Heron's root is four times the triangle of the centres and a crossing; there is none
   where one disc contains the other. */
typedef struct lens { node disc2[2], area, differ; } lens;

static lens lens_of(kernel *k, const vec to[2], const node radius[2]) {
    node zero = k_const(k, 0), one = k_const(k, 1), disc[2], d2, d, reach, heron, root, area, apart_radii;
    vec dir[2], apart;
    lens l;
    int i;
    for (i = 0; i < 2; i++) {
        node distance, sine;
        dir[i] = direction_or_y(k, to[i], &distance);
        sine = sine_of(k, radius[i], distance);
        root = k_sqrt(k, k_max(k, k_mul(k, k_sub(k, one, sine), k_add(k, one, sine)), zero));
        l.disc2[i] = k_div(k, k_scale(k, 2, k_mul(k, sine, sine)), k_add(k, one, root));
        disc[i] = k_sqrt(k, l.disc2[i]);
    }
    apart = vec_sub(k, dir[0], dir[1]);
    d2 = vec_dot(k, apart, apart);
    d = k_sqrt(k, d2);
    reach = k_add(k, disc[0], disc[1]);
    heron = k_mul(k, k_mul(k, k_sub(k, reach, d), k_add(k, reach, d)),
                  k_mul(k, k_sub(k, k_add(k, d, disc[0]), disc[1]), k_add(k, k_sub(k, d, disc[0]), disc[1])));
    root = k_sqrt(k, k_max(k, heron, zero));
    area = k_mul(k, l.disc2[0], k_arc_tangent(k, root, k_sub(k, k_add(k, d2, l.disc2[0]), l.disc2[1])));
    area = k_madd(k, l.disc2[1], k_arc_tangent(k, root, k_sub(k, k_add(k, d2, l.disc2[1]), l.disc2[0])), area);
    area = k_scale(k, 1 / x_pi(), k_sub(k, area, k_scale(k, x_ratio(1, 2), root)));
    area = k_select(k, zero, heron, area, k_min(k, l.disc2[0], l.disc2[1]));
    l.area = k_select(k, d, reach, area, zero);
    apart_radii = k_sub(k, disc[0], disc[1]);
    l.differ = k_madd(k, apart_radii, apart_radii, d2);
    return l;
}

/* lens/(area 1 + area 2), equation 14 */
kernel *describe_fiv_overlap(int bands) {
    kernel *k = kernel_new("fiv_overlap", "share of two occluders' discs that lies in both");
    node zero = k_const(k, 0), radius[2], areas;
    vec to[2];
    lens l;
    (void)bands;
    to[0] = vec_param(k, "to_centre");
    radius[0] = real_param(k, "radius");
    to[1] = vec_param(k, "to_centre2");
    radius[1] = real_param(k, "radius2");
    l = lens_of(k, to, radius);
    areas = k_add(k, l.disc2[0], l.disc2[1]);
    real_result(k, k_select(k, zero, areas, k_div(k, l.area, areas), zero));
    return k;
}

/* lens f1 f2 (I1 + I2)/(f1 area1 + f2 area2), at most the smaller of the two; f = 1 for one disc twice */
kernel *describe_fiv_twice(int bands) {
    kernel *k = kernel_new("fiv_twice", "what two occluders take together, of discs that they fill in part");
    static const char *const names[2][4] = { { "to_centre", "radius", "taken", "filled" },
                                             { "to_centre2", "radius2", "taken2", "filled2" } };
    node zero = k_const(k, 0), one = k_const(k, 1), radius[2], f, g, areas, both, same;
    vec to[2], taken[2], filled[2], out;
    lens l;
    int i;
    (void)bands;
    for (i = 0; i < 2; i++) {
        to[i] = vec_param(k, names[i][0]);
        radius[i] = real_param(k, names[i][1]);
        taken[i] = vec_param(k, names[i][2]);
        filled[i] = vec_param(k, names[i][3]);
    }
    l = lens_of(k, to, radius);
    same = k_scale(k, x_ratio(1, 1 << 30), l.disc2[0]);
#define TWICE(c) (f = k_select(k, same, l.differ, filled[0].c, one), \
                  g = k_select(k, same, l.differ, filled[1].c, one), \
                  areas = k_madd(k, f, l.disc2[0], k_mul(k, g, l.disc2[1])), \
                  both = k_mul(k, k_mul(k, l.area, k_mul(k, f, g)), k_add(k, taken[0].c, taken[1].c)), \
                  both = k_select(k, zero, areas, k_div(k, both, areas), zero), \
                  k_min(k, both, k_min(k, taken[0].c, taken[1].c)))
    out.x = TWICE(x);
    out.y = TWICE(y);
    out.z = TWICE(z);
#undef TWICE
    vec_result(k, out);
    return k;
}

kernel *describe_fiv_self(int bands) {
    kernel *k = kernel_new("fiv_self", "irradiance at a point of an object's own surface");
    node zero = k_const(k, 0);
    vec environment[3], hidden[3], normal, left;
    (void)bands;
    vectors_param(k, "environment", environment);
    vectors_param(k, "hidden", hidden);
    normal = vec_param(k, "normal");
    left = vec_sub(k, along(k, environment, normal), along(k, hidden, normal));
    left.x = k_max(k, left.x, zero);
    left.y = k_max(k, left.y, zero);
    left.z = k_max(k, left.z, zero);
    vec_result(k, left);
    return k;
}

kernel *describe_fiv_add(int bands) {
    kernel *k = kernel_new("fiv_add", "fiv + radiance_times_solid_angle dir");
    vec fiv[3], dir, light;
    node out[9];
    int c;
    (void)bands;
    vectors_param(k, "fiv", fiv);
    dir = vec_param(k, "dir");
    light = vec_param(k, "color");
    fiv[0] = vec_add(k, fiv[0], vec_scale(k, light.x, dir));
    fiv[1] = vec_add(k, fiv[1], vec_scale(k, light.y, dir));
    fiv[2] = vec_add(k, fiv[2], vec_scale(k, light.z, dir));
    for (c = 0; c < 3; c++) { out[3 * c] = fiv[c].x; out[3 * c + 1] = fiv[c].y; out[3 * c + 2] = fiv[c].z; }
    output_nodes(k, "out", 9, out);
    return k;
}

/* The vectors of a sample of a prt_fiv_transfer table under the light of prt_fiv_transfer_light: nine dot products */
kernel *describe_fiv_transfer(int bands) {
    kernel *k = named_kernel("fiv_transfer", "vectors of what is hidden under a light", bands);
    int n = (bands + 1) * (bands + 1), hidden = kernel_param(k, "hidden", PARAM_INPUT, n), i, c;
    int vectors = kernel_param(k, "vectors", PARAM_INPUT, 9 * n);
    node out[9];
    for (c = 0; c < 9; c++) {
        out[c] = k_const(k, 0);
        for (i = 0; i < n; i++) out[c] = k_madd(k, k_element(k, hidden, i), k_element(k, vectors, c * n + i), out[c]);
    }
    output_nodes(k, "out", 9, out);
    return k;
}
