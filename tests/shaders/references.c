#define PRT_DOUBLE
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"

#include "references.h"

/* ---- prt.h, one line a kernel: inputs and outputs as the kernel's parameters, one after the other ---- */

static prt_vec3 vec3_of(const double *v) { return prt__vec3(v[0], v[1], v[2]); }
static prt_rgb rgb_of(const double *v) {
    prt_rgb c;
    c.r = v[0]; c.g = v[1]; c.b = v[2];
    return c;
}
static prt_fiv fiv_of(const double *v) {
    prt_fiv f;
    memcpy(&f, v, sizeof f);
    return f;
}

/* The 8 samples as a table whose first cell they are */
static void fiv_blend(const double *samples, const double *at, double *out) {
    static const double rho[2] = { 1, 2 };
    double all[2 * 3 * 4 * 9] = { 0 }, theta = at[0] * PRT__PI / 2, phi = at[1] * PRT__PI / 2, r = 1 + at[2];
    prt_fiv_table t = { 3, 4, 2, NULL, 1, NULL, NULL };
    int j;
    for (j = 0; j < 8; j++)
        memcpy(all + 9 * (((j >> 2) * 3 + (j >> 1 & 1)) * 4 + (j & 1)), samples + 9 * j, 9 * sizeof *all);
    t.rho = rho;
    t.samples = (const prt_fiv *)(const void *)all;
    prt_fiv_lookup(&t, prt__vec3(r * sin(theta) * cos(phi), r * sin(theta) * sin(phi), r * cos(theta)),
                   (prt_fiv *)(void *)out);
}

static void fiv_place(const double *to, double *out) {
    double y = to[0] != 0 || to[1] != 0 || to[2] != 0 ? to[1] : 1, phi = atan2(y, to[0]) / (2 * PRT__PI);
    out[0] = atan2(sqrt(to[0] * to[0] + y * y), to[2]) / PRT__PI;
    out[1] = phi < 0 ? phi + 1 : phi;
    out[2] = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
}

static void fiv_taken(const double *in, double *out) {
    prt_rgb left, total = rgb_of(in);
    prt_fiv_hidden h;
    h.fiv = fiv_of(in + 6);
    h.to_centre = vec3_of(in + 15);
    h.radius = in[18];
    prt_fiv_shade_vectors(total, vec3_of(in + 3), 1, &h, PRT_FIV_NO_OVERLAP, &left);
    out[0] = total.r - left.r; out[1] = total.g - left.g; out[2] = total.b - left.b;
}

/* What a whole disc takes of an even sky, as prt.h would have it from its vector */
static void fiv_filled(const double *in, double *out) {
    double whole[19], full[3], d = sqrt(in[9] * in[9] + in[10] * in[10] + in[11] * in[11]);
    double s = in[12] < d ? in[12] / d : 1;
    int i;
    for (i = 0; i < 3; i++) whole[i] = in[i] > 0 ? 4 : 0;
    memcpy(whole + 3, in + 3, 3 * sizeof *in);
    for (i = 0; i < 9; i++) whole[6 + i] = in[i / 3] * s * s * (d > 0 ? in[9 + i % 3] / d : i % 3 == 1);
    memcpy(whole + 15, in + 9, 4 * sizeof *in);
    fiv_taken(whole, full);
    for (i = 0; i < 3; i++) full[i] = fmax(full[i], in[i] > 0 ? in[i] * s * s / 1024 : 0);
    for (i = 0; i < 3; i++) {
        double taken = in[6 + i] > 0 ? in[6 + i] : 0;
        out[i] = taken < full[i] ? taken / full[i] : 1;
    }
}

/* Two circles of radius 2 sin(a/2), centres a chord apart, by the textbook's formula: squared radii, the lens over
   pi. 1 for one disc twice */
static int fiv_lens(const double *first, const double *second, double r2[2], double *lens) {
    double r[2], d2 = 0, d;
    prt_vec3 to[2];
    int one, i;
    for (i = 0; i < 2; i++) {
        const double *v = i ? second : first;
        double distance = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), sine = v[3] < distance ? v[3] / distance : 1;
        r[i] = 2 * sin(asin(sine) / 2);
        r2[i] = r[i] * r[i];
        to[i] = distance > 0 ? prt__vec3(v[0] / distance, v[1] / distance, v[2] / distance) : prt__vec3(0, 1, 0);
    }
    d2 = (to[0].x - to[1].x) * (to[0].x - to[1].x) + (to[0].y - to[1].y) * (to[0].y - to[1].y) +
         (to[0].z - to[1].z) * (to[0].z - to[1].z);
    d = sqrt(d2);
    *lens = 0;
    if (d >= r[0] + r[1]) return 0;
    *lens = fmin(r2[0], r2[1]);
    one = d2 + (r[0] - r[1]) * (r[0] - r[1]) <= r2[0] / (1 << 30);
    if (d <= fabs(r[0] - r[1])) return one;
    *lens = (r2[0] * acos(fmax(-1, fmin(1, (d2 + r2[0] - r2[1]) / (2 * d * r[0])))) +
             r2[1] * acos(fmax(-1, fmin(1, (d2 + r2[1] - r2[0]) / (2 * d * r[1])))) -
             sqrt(fmax(0, (r[0] + r[1] - d) * (r[0] + r[1] + d) * (d + r[0] - r[1]) * (d - r[0] + r[1]))) / 2) /
            PRT__PI;
    return one;
}

static double fiv_overlap(const double *in) {
    double r2[2], lens;
    fiv_lens(in, in + 4, r2, &lens);
    return r2[0] + r2[1] > 0 ? lens / (r2[0] + r2[1]) : 0;
}

/* The layout of an occluder: to its centre, radius, taken, filled */
static void fiv_twice(const double *in, double *out) {
    double r2[2], lens;
    int one = fiv_lens(in, in + 10, r2, &lens), i;
    for (i = 0; i < 3; i++) {
        double f = one ? 1 : in[7 + i], g = one ? 1 : in[17 + i], areas = f * r2[0] + g * r2[1];
        double both = areas > 0 ? lens * f * g * (in[4 + i] + in[14 + i]) / areas : 0;
        out[i] = fmin(both, fmin(in[4 + i], in[14 + i]));
    }
}

static void fiv_self(const double *in, double *out) {
    static const double rho = 1;
    prt_fiv environment = fiv_of(in), hidden = fiv_of(in + 9);
    prt_fiv_table t = { 1, 1, 1, NULL, 1, NULL, NULL };
    t.rho = &rho;
    t.samples = &hidden;
    prt_fiv_self(&environment, &t, prt__vec3(0, 0, -1), vec3_of(in + 18), (prt_rgb *)(void *)out);
}

static void vo_direct(const double *in, double *out) {
    prt_vo_params params;
    prt_vo_point point;
    prt_point_light light;
    memset(&params, 0, sizeof params);
    memset(&point, 0, sizeof point);
    point.position = vec3_of(in);
    point.normal = vec3_of(in + 3);
    point.diffuse = rgb_of(in + 9);
    point.specular = rgb_of(in + 12);
    point.shininess = in[15];
    light.position = vec3_of(in + 16);
    light.color = rgb_of(in + 19);
    prt_vo_shade(&params, &point, vec3_of(in + 6), 0, NULL, 1, &light, (prt_rgb *)(void *)out);
}

/* What gets through to a point that shines as brightly as the light that arrives: specular 1 at exponent 0 */
static void vo_pass(int cap, const double *in, double *out) {
    prt_vo_params params;
    prt_vo_point point;
    prt_vo_occluder o;
    prt_point_light light;
    memset(&params, 0, sizeof params);
    memset(&point, 0, sizeof point);
    memset(&o, 0, sizeof o);
    params.off = PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS;
    params.law = cap ? PRT_VO_CAP : PRT_VO_SINE;
    point.position = vec3_of(in);
    point.normal = cap ? vec3_of(in + 3) : prt__vec3(0, 0, 1);
    if (cap) in += 3;
    point.specular.r = point.specular.g = point.specular.b = 1;
    light.position = vec3_of(in + 3);
    light.color = point.specular;
    params.shadow_strength = in[6];
    params.light_angle = 2 * asin(in[6] / 2);
    params.caustic_strength = in[7];
    params.caustic_angle = asin(sqrt(in[8]));
    o.occlusion = vec3_of(in + 9);
    o.caustic = vec3_of(in + 12);
    o.transmissive = rgb_of(in + 15);
    o.form_factor = in[18];
    o.caustic_factor = in[19];
    prt_vo_shade(&params, &point, prt__vec3(0, 0, 9), 1, &o, 1, &light, (prt_rgb *)(void *)out);
}

static void vo_sent(const double *in, double *out) {
    prt_vo_params params;
    prt_vo_point point;
    prt_vo_occluder o;
    prt_point_light light;
    prt_rgb all, direct;
    memset(&params, 0, sizeof params);
    memset(&point, 0, sizeof point);
    memset(&o, 0, sizeof o);
    params.off = PRT_VO_NO_SHADOW | PRT_VO_NO_CAUSTIC;
    point.position = vec3_of(in);
    point.normal = vec3_of(in + 3);
    point.diffuse = rgb_of(in + 9);
    point.specular = rgb_of(in + 12);
    light.position = vec3_of(in + 15);
    light.color = rgb_of(in + 18);
    o.position = vec3_of(in + 21);
    o.diffuse_normal = vec3_of(in + 24);
    o.specular_normal = vec3_of(in + 27);
    o.diffuse = rgb_of(in + 30);
    o.specular = rgb_of(in + 33);
    params.dd = in[36]; params.ds = in[37]; params.ss = in[38];
    params.gloss = in[39];
    prt_vo_shade(&params, &point, vec3_of(in + 6), 0, NULL, 1, &light, &direct);
    prt_vo_shade(&params, &point, vec3_of(in + 6), 1, &o, 1, &light, &all);
    out[0] = all.r - direct.r; out[1] = all.g - direct.g; out[2] = all.b - direct.b;
}

static void window_dering(int n, const double *in, double *out) {
    int l, i;
    for (l = 0, i = 0; l < n; l++) {
        double p = prt_window_weight(PRT_WINDOW_POSITIVE, l, n), s = in[0], w = s < 1 ? 1 - s + s * p : (2 - s) * p;
        for (; i < (l + 1) * (l + 1); i++) out[i] = (l ? w : 1) * in[1 + i];
    }
}

/* The light whose constants these are, through its irradiance in SH */
static void irradiance_packed(const double *in, double *out) {
    double light[27], irradiance[9];
    int c;
    prt_sh_unpack_irradiance(in, light);
    for (c = 0; c < 3; c++) {
        prt_sh_irradiance(3, light + 9 * c, irradiance);
        out[c] = prt_sh_at(3, irradiance, vec3_of(in + 28)) / PRT__PI;
    }
}

/* 1 + f + f f/2 + f f f/6 + f f f f/24, each power from the one before */
static void exp_series(int n, const double *f, double *out) {
    double power[64], factor = 1;
    int h, i;
    for (i = 0; i < n * n; i++) out[i] = power[i] = f[i];
    out[0] += sqrt(4 * PRT__PI);
    for (h = 2; h <= 4; h++) {
        prt_sh_product(n, f, power, power);
        factor /= h;
        for (i = 0; i < n * n; i++) out[i] += factor * power[i];
    }
}

static void fiv_add(const double *in, double *out) {
    prt_fiv f = fiv_of(in);
    prt_fiv_add(&f, vec3_of(in + 9), rgb_of(in + 12));
    memcpy(out, &f, sizeof f);
}

/* A table of one sample, which is this one */
static void fiv_transfer(int n, const double *in, double *out) {
    prt_fiv_transfer t;
    memset(&t, 0, sizeof t);
    t.bands = n;
    t.theta_count = t.phi_count = t.rho_count = 1;
    t.samples = in;
    prt_fiv_transfer_samples(&t, in + (n + 1) * (n + 1), 0, 1, (prt_fiv *)(void *)out);
}

static void vo_bend(const double *in, double *out) {
    prt_vo_wave wave;
    prt_vo_occluder o;
    memset(&o, 0, sizeof o);
    wave.along = vec3_of(in);
    wave.across = vec3_of(in + 3);
    wave.amplitude = in[6]; wave.frequency = in[7]; wave.phase = in[8];
    o.caustic = vec3_of(in + 13);
    prt_vo_bend(1, &wave, in[9], vec3_of(in + 10), 1, &o, &o);
    memcpy(out, &o.caustic, sizeof o.caustic);
}

/* From the definition: fold a unit vector, and see that it comes back */
static void vo_unfold(const double *in, double *out) {
    double z = 1 - fabs(in[0]) - fabs(in[1]), x = in[0], y = in[1], length;
    if (z < 0) {
        x = (1 - fabs(in[1])) * (in[0] < 0 ? -1 : 1);
        y = (1 - fabs(in[0])) * (in[1] < 0 ? -1 : 1);
    }
    length = sqrt(x * x + y * y + z * z);
    out[0] = x / length; out[1] = y / length; out[2] = z / length;
}

/* X(kernel, approximation, call): the second is how far, over the largest output, the kernel's own formulas may be from
   those of prt.h, 0 unless it approximates a function. */
#define REFERENCES(X) \
    X(sh_eval, 0, prt_sh_eval(n, vec3_of(in), out)) \
    X(ch_eval, 0, prt_ch_eval(n, vec3_of(in), out)) \
    X(sh_at, 0, *out = prt_sh_at(n, in, vec3_of(in + n * n))) \
    X(ch_at, 0, *out = prt_ch_at(n, in, vec3_of(in + n * n))) \
    X(sh_add_sample, 0, \
      memcpy(out, in + 4, sizeof *out * (size_t)(n * n)); prt_sh_add_sample(n, vec3_of(in), in[3], out)) \
    X(sh_delta, 0, prt_sh_delta(n, vec3_of(in), out)) \
    X(sh_cone, 1e-10, prt_sh_cone(n, vec3_of(in), fmin(in[3], PRT__PI), out)) \
    X(sh_sphere, 0, prt_sh_sphere(n, vec3_of(in), in[3], out)) \
    X(sh_cosine_lobe, 0, prt_sh_cosine_lobe(n, vec3_of(in), out)) \
    X(sh_hemisphere, 0, prt_sh_hemisphere(n, vec3_of(in), in[3], in[4], out)) \
    X(sh_convolve, 0, prt_sh_convolve(n, in, in + n * n, out)) \
    X(sh_irradiance, 0, prt_sh_irradiance(n, in, out)) \
    X(sh_window_hann, 0, prt_sh_window(n, PRT_WINDOW_HANN, n, in, out)) \
    X(sh_window_lanczos, 0, prt_sh_window(n, PRT_WINDOW_LANCZOS, n, in, out)) \
    X(sh_window_positive, 0, prt_sh_window(n, PRT_WINDOW_POSITIVE, n, in, out)) \
    X(sh_window_dering, 0, window_dering(n, in, out)) \
    X(sh_irradiance_packed, 0, irradiance_packed(in, out)) \
    X(sh_rotation, 0, prt_sh_rotation(n, in, out)) \
    X(sh_rotate_by, 0, prt_sh_rotate_by(n, in, in + prt_sh_rotation_count(n), out)) \
    X(sh_rotate, 0, prt_sh_rotate(n, in, in + 9, out)) \
    X(shade_diffuse_four, 0, prt_shade_diffuse(2, in, in + 4, (prt_rgb *)(void *)out)) \
    X(sh_rotate_turned, 0, prt_sh_rotate(n, in, in + 9 + 6, out)) \
    X(sh_turn, 0, prt__turn_of(in, out)) \
    X(sh_rotate_z, 0, prt_sh_rotate_z(n, in[0], in + 1, out)) \
    X(rotation_from_quaternion, 0, prt_rotation_from_quaternion(in, out)) \
    X(sh_zonal_to, 0, prt_sh_zonal_to(n, in, vec3_of(in + n), out)) \
    X(sh_product_zonal, 0, prt_sh_product_zonal(n, in, in + n * n, out)) \
    X(sh_mask_hann, 0, prt_sh_mask(n, PRT_WINDOW_HANN, in, in + n * n, out)) \
    X(sh_mask_lanczos, 0, prt_sh_mask(n, PRT_WINDOW_LANCZOS, in, in + n * n, out)) \
    X(sh_mask_positive, 0, prt_sh_mask(n, PRT_WINDOW_POSITIVE, in, in + n * n, out)) \
    X(sh_mask_filter_hann, 0, prt_sh_mask_filter(n, PRT_WINDOW_HANN, in, in + n * n, out)) \
    X(sh_mask_filter_lanczos, 0, prt_sh_mask_filter(n, PRT_WINDOW_LANCZOS, in, in + n * n, out)) \
    X(sh_product_matrix, 0, prt_sh_product_matrix(n, in, out)) \
    X(sh_product_by, 0, prt_sh_product_by(n, in, in + n * n * n * n, out)) \
    X(sh_exp_series, 0, exp_series(n, in, out)) \
    X(sh_exp_linear, 1e-10, prt_sh_exp_linear(n, in, out)) \
    X(sh_mask_filter_positive, 0, prt_sh_mask_filter(n, PRT_WINDOW_POSITIVE, in, in + n * n, out)) \
    X(ch_from_sh, 0, prt_ch_from_sh(n, in, out)) \
    X(sh_from_ch, 0, prt_sh_from_ch(n, in, out)) \
    X(ch_from_moments, 0, prt_ch_from_moments(n, in, out)) \
    X(ch_to_moments, 0, prt_ch_to_moments(n, in, out)) \
    X(ch_dot, 0, *out = prt_ch_dot(n, in, in + n * n)) \
    X(ch_rotate, 0, prt_ch_rotate(n, in, in + 9, out)) \
    X(ch_product, 0, prt_ch_product(n, in, in + n * n, out)) \
    X(fiv_irradiance, 0, \
      prt_fiv f = fiv_of(in); prt_rgb c = prt_fiv_irradiance(&f, vec3_of(in + 9)); memcpy(out, &c, sizeof c)) \
    X(fiv_add, 0, fiv_add(in, out)) \
    X(fiv_transfer, 0, fiv_transfer(n, in, out)) \
    X(fiv_place, 4e-9, fiv_place(in, out)) \
    X(fiv_blend, 0, fiv_blend(in, in + 72, out)) \
    X(fiv_taken, 4e-9, fiv_taken(in, out)) \
    X(fiv_filled, 1024 * 4e-9, fiv_filled(in, out)) \
    X(fiv_overlap, 4e-9, *out = fiv_overlap(in)) \
    X(fiv_twice, 4e-9, fiv_twice(in, out)) \
    X(fiv_self, 0, fiv_self(in, out)) \
    X(vo_direct, 0, vo_direct(in, out)) \
    X(vo_pass, 0, vo_pass(0, in, out)) \
    X(vo_pass_cap, 0, vo_pass(1, in, out)) \
    X(vo_sent, 0, vo_sent(in, out)) \
    X(vo_bend, 0, vo_bend(in, out)) \
    X(vo_unfold, 0, vo_unfold(in, out)) \
    X(sh_dot, 0, *out = prt_sh_dot(n, in, in + n * n)) \
    X(sh_product, 0, prt_sh_product(n, in, in + n * n, out)) \
    X(sh_square, 0, prt_sh_square(n, in, out)) \
    X(shade_glossy, 0, prt_shade_glossy(n, in, in + 3 * n * n, vec3_of(in + 3 * n * n + n), (prt_rgb *)(void *)out)) \
    X(phong_zonal, 0, prt_phong_zonal(n, in[0], out)) \
    X(local_frame, 0, prt_local_frame(vec3_of(in), out)) \
    X(shade_diffuse_rgb, 0, prt_shade_diffuse_rgb(n, in, in + 3 * n * n, (prt_rgb *)(void *)out)) \
    X(shade_diffuse, 0, prt_shade_diffuse(n, in, in + n * n, (prt_rgb *)(void *)out))

#define REFERENCE(name, approximation, call) \
    static void reference_##name(int n, const double *in, double *out) { (void)n; (void)in; call; }
REFERENCES(REFERENCE)

#define REFERENCE_ROW(name, approximation, call) { #name, reference_##name, approximation },
static const reference references[] = { REFERENCES(REFERENCE_ROW) };

const reference *find_reference(const char *name) {
    size_t i;
    for (i = 0; i < sizeof references / sizeof references[0]; i++)
        if (!strcmp(references[i].name, name)) return &references[i];
    return NULL;
}

/* ---- inputs ---- */

enum { SPECIAL = 24 };

static double uniform(void) {
    static uint64_t state = 88172645463325252u;
    state ^= state << 13; state ^= state >> 7; state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

/* Whether a name is one of the words */
static int one_of(const char *name, const char *words) {
    const char *found = strstr(words, name);
    size_t length = strlen(name);
    for (; found; found = strstr(found + 1, name))
        if ((found == words || found[-1] == ' ') && (found[length] == ' ' || !found[length])) return 1;
    return 0;
}

/* The first SPECIAL items are the axes, places ever nearer to the poles, and for other vectors the zero vector. */
static void fill_direction(const char *name, int item, double *v) {
    double z = 2 * uniform() - 1, phi = 2 * PRT__PI * uniform(), s = sqrt(1 - z * z), scale = 1;
    v[0] = s * cos(phi); v[1] = s * sin(phi); v[2] = z;
    if (item < 6) { v[0] = v[1] = v[2] = 0; v[item % 3] = item < 3 ? 1 : -1; }
    else if (item < SPECIAL) {
        double tilt = pow(10, -(item - 5) * 0.5);
        v[0] = 0.6 * sin(tilt); v[1] = -0.8 * sin(tilt); v[2] = (item & 1 ? -1 : 1) * cos(tilt);
    }
    if (!strncmp(name, "to_centre", 9)) scale = item == SPECIAL - 1 ? 0 : pow(10, 2 * uniform() - 1);
    else if (one_of(name, "occlusion caustic diffuse_normal specular_normal")) scale = item % 7 == 0 ? 0 : uniform();
    v[0] *= scale; v[1] *= scale; v[2] *= scale;
}

/* Three values that are no direction: places, colours, weights */
static void fill_triple(const char *name, double *v) {
    int i;
    for (i = 0; i < 3; i++) {
        double u = uniform();
        if (one_of(name, "position light eye occluder_position")) v[i] = 4 * u - 2;
        else v[i] = one_of(name, "weights strength") ? 0.1 + u : u;
    }
    if (!strcmp(name, "strength")) v[2] = 1e-3 + 0.05 * v[2];
}

static double fill_scalar(const char *name, int item) {
    double u = uniform();
    if (!strcmp(name, "half_angle"))
        return item % 7 == 0 ? 0 : item % 7 == 1 ? PRT__PI : item % 7 == 2 ? PRT__PI / 2 : PRT__PI * u;
    if (!strncmp(name, "radius", 6)) return item % 7 == 0 ? 0 : 2 * u;
    if (!strcmp(name, "angle")) return item % 7 == 0 ? 0 : 2 * PRT__PI * (2 * u - 1);
    if (!strcmp(name, "exponent")) return item % 7 == 0 ? 0 : 100 * u;
    if (!strcmp(name, "shininess")) return item % 7 == 0 ? 0 : 20 * u;
    if (!strcmp(name, "strength")) return item % 7 == 0 ? 0 : item % 7 == 1 ? 1 : item % 7 == 2 ? 2 : 2 * u;
    if (!strcmp(name, "gloss")) return 1 + 15 * u;
    return 2 * u - 1;
}

/* A rotation, any or about z, and after it its cosines and sines; or a reflection. */
static void fill_rotation(int item, int reflect, double *r) {
    double q[4];
    int i;
    for (i = 0; i < 4; i++) q[i] = item < SPECIAL && item % 4 != i && (i == 1 || i == 2) ? 0 : 2 * uniform() - 1;
    prt_rotation_from_quaternion(q, r);
    prt__turn_of(r, r + 9);
    for (i = 0; reflect && i < 9; i++) r[i] = -r[i];
}

/* A unit vector at right angles to the one before it */
static void fill_across(double *v) {
    double length = 0;
    int axis = fabs(v[-3]) < 0.6 ? 0 : fabs(v[-2]) < 0.6 ? 1 : 2, i;
    for (i = 0; i < 3; i++) v[i] = (i == axis) - v[axis - 3] * v[i - 3];
    for (i = 0; i < 3; i++) length += v[i] * v[i];
    for (i = 0; i < 3; i++) v[i] /= sqrt(length);
}

static int has_turn(const kernel *k) {                 /* and so takes rotations alone */
    int i;
    for (i = 0; i < k->param_count; i++)
        if (!strcmp(k->params[i].name, "turn")) return 1;
    return 0;
}

void fill_inputs(const kernel *k, int item, double *in) {
    int i, j;
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        if (p->kind == PARAM_DIRECTION) {
            if (!strcmp(p->name, "across")) fill_across(in);
            else if (one_of(p->name, "along v dir axis up normal to_centre to_centre2 occlusion caustic "
                                     "diffuse_normal specular_normal"))
                fill_direction(p->name, item, in);
            else fill_triple(p->name, in);
            in += 3;
        }
        else if (p->kind == PARAM_SCALAR) *in++ = fill_scalar(p->name, item);
        else if (!strcmp(p->name, "r")) { fill_rotation(item, item % 5 == 4 && !has_turn(k), in); in += 9; }
        else if (!strcmp(p->name, "turn")) in += 6;
        else if (p->kind == PARAM_INPUT || p->kind == PARAM_FOUR)
            for (j = 0; j < p->count; j++) *in++ = 2 * uniform() - 1;
    }
}
