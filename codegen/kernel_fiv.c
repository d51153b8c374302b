/* Kernels of the room >>fiv [Michael 2010]: everything but the loop over occluders and the reading of the table, which a
   program may keep in textures. A fiv is nine values, the vectors of red, green and blue. */
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

/* Texture coordinates of a place: theta/pi, phi/(2 pi) in 0 ... 1, distance. With texels at the samples, row theta_i of n
   is at i/(n-1) and column phi_j of n at j/n. */
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

/* samples[8][9]: rho slowest, then theta, then phi, as in the table; at: weights of the upper samples, theta, phi, rho */
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

/* I = N.FIV where the occluder is above the horizon, N.FIV + |FIV| s (g(u) - u) where it is cut, 0 below; within
   0 ... total. g(u) = (u acos(-u) + sqrt(1-u^2) (2+u^2)/3)/pi, u = N.to_centre/(distance s) */
kernel *describe_fiv_taken(int bands) {
    kernel *k = kernel_new("fiv_taken", "irradiance that one occluder takes");
    node zero = k_const(k, 0), one = k_const(k, 1), two = k_const(k, 2), distance, sine, radius, u, square, root, cut;
    vec total = vec_param(k, "total"), normal = vec_param(k, "normal"), fiv[3], to, dir, taken, lit;
    (void)bands;
    vectors_param(k, "fiv", fiv);
    to = vec_param(k, "to_centre");
    radius = real_param(k, "radius");
    dir = direction_or_y(k, to, &distance);
    sine = sine_of(k, radius, distance);
    u = k_select(k, zero, sine, k_div(k, vec_dot(k, normal, dir), sine), zero);
    u = k_max(k, k_min(k, u, one), k_const(k, -1));
    square = k_mul(k, u, u);
    root = k_mul(k, k_sqrt(k, k_max(k, k_sub(k, one, square), zero)), k_scale(k, x_ratio(1, 3), k_add(k, two, square)));
    cut = k_scale(k, 1 / x_pi(), k_madd(k, u, k_arc_cosine(k, k_neg(k, u)), root));
    cut = k_mul(k, sine, k_sub(k, cut, u));
    lit = along(k, fiv, normal);
#define TAKEN(c, i) k_min(k, k_max(k, k_madd(k, vec_length(k, fiv[i]), cut, lit.c), zero), k_max(k, total.c, zero))
    taken.x = TAKEN(x, 0);
    taken.y = TAKEN(y, 1);
    taken.z = TAKEN(z, 2);
#undef TAKEN
    cut = k_select(k, zero, radius, k_select(k, k_const(k, -1), u, one, zero), zero);
    vec_result(k, vec_scale(k, cut, taken));
    return k;
}

/* lens/(area 1 + area 2) of the discs of radius 2 sin(a/2) as far apart as the chord between the centres. Heron's root is
   four times the triangle of the centres and a crossing; there is none where one disc contains the other. */
kernel *describe_fiv_overlap(int bands) {
    kernel *k = kernel_new("fiv_overlap", "share of two occluders' discs that lies in both");
    node zero = k_const(k, 0), one = k_const(k, 1), disc2[2], disc[2], areas, d2, d, heron, root, lens, contained;
    vec dir[2], apart;
    int i;
    (void)bands;
    for (i = 0; i < 2; i++) {
        static const char *const to[] = { "to_centre", "to_centre2" }, *const size[] = { "radius", "radius2" };
        node distance, sine;
        dir[i] = direction_or_y(k, vec_param(k, to[i]), &distance);
        sine = sine_of(k, real_param(k, size[i]), distance);
        root = k_sqrt(k, k_max(k, k_mul(k, k_sub(k, one, sine), k_add(k, one, sine)), zero));
        disc2[i] = k_div(k, k_scale(k, 2, k_mul(k, sine, sine)), k_add(k, one, root));
        disc[i] = k_sqrt(k, disc2[i]);
    }
    apart = vec_sub(k, dir[0], dir[1]);
    d2 = vec_dot(k, apart, apart);
    d = k_sqrt(k, d2);
    areas = k_add(k, disc2[0], disc2[1]);
    heron = k_mul(k, k_mul(k, k_sub(k, k_add(k, disc[0], disc[1]), d), k_add(k, k_add(k, disc[0], disc[1]), d)),
                  k_mul(k, k_sub(k, k_add(k, d, disc[0]), disc[1]), k_add(k, k_sub(k, d, disc[0]), disc[1])));
    root = k_sqrt(k, k_max(k, heron, zero));
    lens = k_mul(k, disc2[0], k_arc_tangent(k, root, k_sub(k, k_add(k, d2, disc2[0]), disc2[1])));
    lens = k_madd(k, disc2[1], k_arc_tangent(k, root, k_sub(k, k_add(k, d2, disc2[1]), disc2[0])), lens);
    lens = k_scale(k, 1 / x_pi(), k_sub(k, lens, k_scale(k, x_ratio(1, 2), root)));
    contained = k_min(k, disc2[0], disc2[1]);
    lens = k_select(k, d, k_add(k, disc[0], disc[1]), k_select(k, zero, heron, lens, contained), zero);
    real_result(k, k_select(k, zero, areas, k_div(k, lens, areas), zero));
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
