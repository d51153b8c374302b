/* libFuzzer target: every function of prt.h that takes numbers, with arguments out of the fuzzer's bytes, bad ones
   included. Buffers lie on the heap at exactly the documented size, so that the address sanitizer sees any byte too many
   read or written; a call that returns an error must leave its output as it was. Built in both precisions by run.sh. */
#define PRT_MAX_BANDS 14
#define PRT_IMPLEMENTATION
#include "prt.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct source { const uint8_t *at, *end; } source;

static unsigned take(source *s) { return s->at < s->end ? *s->at++ : 0u; }

static uint64_t take_bits(source *s) {
    uint64_t bits = 0;
    int k;
    for (k = 0; k < 8; k++) bits = bits << 8 | take(s);
    return bits;
}

static int take_int(source *s, int low, int high) {         /* mostly in low ... high, now and then anything */
    unsigned kind = take(s);
    if (kind >= 240) return (int)(uint32_t)take_bits(s);
    return low + (int)(kind % (unsigned)(high - low + 1));
}

static prt_real take_real(source *s) {
    static const prt_real special[] = { 0, -1, 1, PRT__EPS, PRT__REAL_MAX, -PRT__REAL_MAX, (prt_real)0.5 };
    unsigned kind = take(s);
    if (kind < 7) return special[kind];
    if (kind < 10) {                                         /* any bits: NaN, infinity, subnormal */
        uint64_t bits = take_bits(s);
        prt_real v;
        memcpy(&v, &bits, sizeof v);
        return v;
    }
    return ((prt_real)take(s) - 128) / 64;
}

static prt_vec3 take_direction(source *s) {
    prt_vec3 v;
    double length;
    v.x = take_real(s); v.y = take_real(s); v.z = take_real(s);
    length = sqrt((double)v.x * (double)v.x + (double)v.y * (double)v.y + (double)v.z * (double)v.z);
    if (length > 0 && take(s) < 200) {
        v.x = (prt_real)((double)v.x / length); v.y = (prt_real)((double)v.y / length); v.z = (prt_real)((double)v.z / length);
    }
    return v;
}

/* ---- buffers of one call: freed together ---- */
static void *taken[16];
static int taken_count;
static prt_real *output;
static size_t output_count;

static void *room(size_t size) {
    void *p = malloc(size ? size : 1);
    if (!p) abort();
    taken[taken_count++] = p;
    return p;
}
static prt_real *reals(source *s, size_t count) {
    prt_real *p = (prt_real *)room(count * sizeof *p);
    size_t i;
    for (i = 0; i < count; i++) p[i] = take_real(s);
    return p;
}
static prt_real *out(source *s, size_t count) {              /* sometimes NULL */
    output = (prt_real *)room(count * sizeof *output);
    output_count = count;
    memset(output, 0x5a, count * sizeof *output);
    if (take(s) == 255) output_count = 0;
    return output_count ? output : NULL;
}
static const prt_real *maybe(source *s, const prt_real *p) { return take(s) == 255 ? NULL : p; }

static void check(const char *name, prt_result r) {
    size_t i;
    const unsigned char *bytes = (const unsigned char *)output;
    if ((int)r < 0 || r >= PRT__RESULT_COUNT) {
        fprintf(stderr, "%s returned %d, which is no result\n", name, (int)r);
        abort();
    }
    if (r == PRT_OK) return;
    for (i = 0; i < output_count * sizeof *output; i++)
        if (bytes[i] != 0x5a) {
            fprintf(stderr, "%s wrote although it returned \"%s\"\n", name, prt_result_string(r));
            abort();
        }
}
#define CHECK(call) check(#call, call)

static void evaluate(source *s, int bands, size_t n) {
    int count = take_int(s, -1, 40), k;
    size_t items = count > 0 && count <= 40 ? (size_t)count : 0, stride = (size_t)take_int(s, 0, 48);
    size_t room_for = items && stride >= items && stride <= 48 ? n * stride : 1;
    prt_vec3 *dirs = (prt_vec3 *)room((items ? items : 1) * sizeof *dirs);
    prt_real *x = (prt_real *)room((items + 1) * sizeof *x), *y = (prt_real *)room((items + 1) * sizeof *y);
    prt_real *z = (prt_real *)room((items + 1) * sizeof *z);
    for (k = 0; k < (int)items; k++) { dirs[k] = take_direction(s); x[k] = dirs[k].x; y[k] = dirs[k].y; z[k] = dirs[k].z; }
    if (count > 40) count = -count;
    switch (take(s) % 6) {
        case 0: CHECK(prt_sh_eval(bands, take_direction(s), out(s, n))); break;
        case 1: CHECK(prt_ch_eval(bands, take_direction(s), out(s, n))); break;
        case 2: CHECK(prt_sh_eval_n(bands, count, dirs, out(s, items * n))); break;
        case 3: CHECK(prt_ch_eval_n(bands, count, dirs, out(s, items * n))); break;
        case 4: if (stride <= 48 || !items) CHECK(prt_sh_eval_soa(bands, count, x, y, z, out(s, room_for), stride)); break;
        default: if (stride <= 48 || !items) CHECK(prt_ch_eval_soa(bands, count, x, y, z, out(s, room_for), stride)); break;
    }
}

static void project(source *s, int bands, size_t n) {
    prt_vec3 d = take_direction(s);
    prt_real v = take_real(s), w = take_real(s);
    switch (take(s) % 8) {
        case 0: CHECK(prt_sh_add_sample(bands, d, v, reals(s, n))); break;
        case 1: CHECK(prt_sh_delta(bands, d, out(s, n))); break;
        case 2: CHECK(prt_sh_cone(bands, d, v, out(s, n))); break;
        case 3: CHECK(prt_sh_sphere(bands, d, v, out(s, n))); break;
        case 4: CHECK(prt_sh_cosine_lobe(bands, d, out(s, n))); break;
        case 5: CHECK(prt_sh_hemisphere(bands, d, v, w, out(s, n))); break;
        case 6: {
            int width = take_int(s, 1, 9), height = take_int(s, 1, 9), k;
            size_t texels = width > 0 && width < 10 && height > 0 && height < 10 ? (size_t)(width * height) : 0;
            float *rgb = (float *)room(3 * texels * sizeof *rgb);
            for (k = 0; k < (int)(3 * texels); k++) rgb[k] = (float)take_real(s);
            if (!texels && width > 0 && height > 0) return;      /* would need that many texels */
            CHECK(prt_sh_project_equirect_rgb(bands, width, height, rgb, out(s, 3 * n)));
            break;
        }
        default: {
            int size = take_int(s, 1, 5), k, f;
            const float *faces[6];
            if (size > 5) size = -size;
            for (f = 0; f < 6; f++) {
                size_t texels = size > 0 ? (size_t)(size * size) : 0;
                float *rgb = (float *)room(3 * texels * sizeof *rgb);
                for (k = 0; k < (int)(3 * texels); k++) rgb[k] = (float)take_real(s);
                faces[f] = take(s) == 255 ? NULL : rgb;
            }
            CHECK(prt_sh_project_cubemap_rgb(bands, size, faces, out(s, 3 * n)));
        }
    }
}

static void transform(source *s, int bands, size_t n) {
    const prt_real *f = maybe(s, reals(s, n));
    int window = take_int(s, -1, 4), width = take_int(s, 0, 16), from = take_int(s, -1, 9), to = take_int(s, -1, 9);
    switch (take(s) % 12) {
        case 0: CHECK(prt_sh_convolve(bands, f, reals(s, n), out(s, n))); break;
        case 1: CHECK(prt_sh_irradiance(bands, f, out(s, n))); break;
        case 2: CHECK(prt_sh_convert(bands, (prt_sh_convention)from, (prt_sh_convention)to, f, out(s, n))); break;
        case 3: CHECK(prt_sh_window(bands, (prt_window)window, width, f, out(s, n))); break;
        case 4: CHECK(prt_ch_from_sh(bands, f, out(s, n))); break;
        case 5: CHECK(prt_sh_from_ch(bands, f, out(s, n))); break;
        case 6: CHECK(prt_ch_from_moments(bands, f, out(s, n))); break;
        case 7: CHECK(prt_ch_to_moments(bands, f, out(s, n))); break;
        case 8: CHECK(prt_sh_pack_irradiance(bands, reals(s, 3 * n), out(s, 28))); break;
        case 9: CHECK(prt_sh_unpack_irradiance(reals(s, 28), out(s, 27))); break;
        case 10: {
            int axes[3], k;
            for (k = 0; k < 3; k++) axes[k] = take_int(s, -3, 3);
            CHECK(prt_sh_map_axes(bands, axes, f, out(s, n)));
            break;
        }
        default: {
            char names[2][4];
            int k;
            for (k = 0; k < 6; k++) names[k / 3][k % 3] = "RLUDFBx"[take(s) % 7];
            names[0][3] = names[1][3] = 0;
            CHECK(prt_sh_convert_axes(bands, names[0], names[1], f, out(s, n)));
        }
    }
}

static void rotate(source *s, int bands, size_t n) {
    prt_real rotation[9];
    size_t blocks = prt_sh_rotation_count(bands);
    int count = take_int(s, -1, 6), k;
    size_t items = count > 0 && count <= 6 ? (size_t)count : 0, stride = (size_t)take_int(s, 0, 8);
    if (count > 6) count = -count;
    for (k = 0; k < 9; k++) rotation[k] = take_real(s);
    if (take(s) < 200) {
        prt_real q[4];
        for (k = 0; k < 4; k++) q[k] = take_real(s);
        (void)prt_rotation_from_quaternion(q, rotation);
    }
    switch (take(s) % 8) {
        case 4: CHECK(prt_sh_rotate(bands, rotation, maybe(s, reals(s, n)), out(s, n))); break;
        case 5: CHECK(prt_sh_rotate_z(bands, take_real(s), maybe(s, reals(s, n)), out(s, n))); break;
        case 6: CHECK(prt_sh_zonal_to(bands, reals(s, n), take_direction(s), out(s, n))); break;
        case 0: CHECK(prt_sh_rotation(bands, rotation, out(s, blocks))); break;
        case 1: CHECK(prt_sh_rotate_by(bands, reals(s, blocks), maybe(s, reals(s, n)), out(s, n))); break;
        case 2: CHECK(prt_sh_rotate_by_n(bands, reals(s, blocks), count, reals(s, items * n), out(s, items * n))); break;
        case 3: CHECK(prt_sh_rotate_by_n_rgb(bands, reals(s, blocks), count, reals(s, 3 * items * n), out(s, 3 * items * n)));
                break;
        default: {
            size_t size = items && stride >= items && stride <= 8 ? n * stride : 1;
            if (stride > 8 && items) return;
            CHECK(prt_sh_rotate_by_soa(bands, reals(s, blocks), count, reals(s, size), out(s, size), stride));
        }
    }
}

static void shade(source *s, int bands, size_t n) {
    int count = take_int(s, -1, 9);
    size_t items = count > 0 && count <= 9 ? (size_t)count : 0;
    if (count > 9) count = -count;
    CHECK(prt_shade_diffuse_n(bands, count, reals(s, items * n), maybe(s, reals(s, 3 * n)), (prt_rgb *)out(s, 3 * items)));
}

static void shade_packed(source *s, int bands, size_t n) {
    int first = take_int(s, -1, 3), count = take_int(s, -1, 6), storage = take_int(s, 0, 3);
    size_t rows, size, k;
    prt_packed_transfer packed;
    unsigned char *data;
    if (first > 3) first = -first;
    if (count > 6) count = -count;
    rows = first >= 0 && count >= 0 ? (size_t)(first + count) : 0;
    size = rows * n * (storage == PRT_STORAGE_8 ? 1 : 2);
    data = (unsigned char *)room(size);
    for (k = 0; k < size; k++) data[k] = (unsigned char)take(s);
    packed.bands = bands;
    packed.storage = (prt_storage)storage;
    packed.data = take(s) == 255 ? NULL : data;
    packed.low = maybe(s, reals(s, n));
    packed.step = maybe(s, reals(s, n));
    if (take(s) % 2) {
        const prt_real *light = maybe(s, reals(s, 3 * n));
        CHECK(prt_shade_packed_n(&packed, first, count, light, (prt_rgb *)out(s, 3 * rows)));
    } else {
        CHECK(prt_transfer_unpack(&packed, first, count, out(s, rows * n)));
    }
}

static void multiply(source *s, int bands, size_t n) {
    const prt_real *f = maybe(s, reals(s, n)), *g = maybe(s, reals(s, n));
    int window = take_int(s, -1, 4), count = take_int(s, -1, 20);
    size_t items = count > 0 && count <= 20 ? (size_t)count : 0, stride = (size_t)take_int(s, 0, 24);
    if (count > 20) count = -count;
    switch (take(s) % 8) {
        case 0: CHECK(prt_sh_product(bands, f, g, out(s, n))); break;
        case 1: CHECK(prt_sh_square(bands, f, out(s, n))); break;
        case 2: CHECK(prt_sh_product_zonal(bands, f, g, out(s, n))); break;
        case 3: CHECK(prt_sh_mask(bands, (prt_window)window, f, g, out(s, n))); break;
        case 4: CHECK(prt_sh_mask_filter(bands, (prt_window)window, f, g, out(s, n))); break;
        case 5: CHECK(prt_ch_product(bands, f, g, out(s, n))); break;
        case 6: {
            size_t size = items && stride >= items && stride <= 24 ? n * stride : 1;
            if (stride <= 24 || !items)
                CHECK(prt_sh_product_soa(bands, count, reals(s, size), reals(s, size), out(s, size), stride));
            break;
        }
        default:
            if (bands > 6) return;                            /* n^2 products */
            if (take(s) % 2) CHECK(prt_sh_product_matrix(bands, f, out(s, n * n)));
            else CHECK(prt_sh_product_by_n(bands, reals(s, n * n), count, reals(s, items * n), out(s, items * n)));
    }
}

static void smooth(source *s, int bands, size_t n) {          /* the slow ones */
    const prt_real *f = maybe(s, reals(s, n));
    prt_vec3 dir;
    volatile prt_real sink;
    switch (take(s) % 5) {
        case 0: CHECK(prt_sh_exp(bands, f, out(s, n))); break;
        case 1: CHECK(prt_sh_exp_linear(bands, f, out(s, n))); break;
        case 2: CHECK(prt_sh_log(bands, take_int(s, 0, PRT_KRYLOV_MAX + 1), take_real(s), f, out(s, n))); break;
        case 3: if (bands <= 4) CHECK(prt_sh_dering(bands, f, out(s, n), NULL)); break;
        default: if (bands <= 4) { sink = prt_sh_minimum(bands, f, &dir); (void)sink; }
    }
}

static void values(source *s, int bands, size_t n) {         /* functions that return a value: they only must return */
    const prt_real *f = maybe(s, reals(s, n)), *g = maybe(s, reals(s, n));
    volatile double sink;
    sink = (double)prt_sh_at(bands, f, take_direction(s));
    sink = (double)prt_ch_at(bands, f, take_direction(s));
    sink = (double)prt_sh_dot(bands, f, g);
    sink = (double)prt_ch_dot(bands, f, g);
    sink = (double)prt_window_weight((prt_window)take_int(s, -1, 4), take_int(s, -2, 20), take_int(s, -2, 20));
    sink = prt_ch_norm(take_int(s, -2, 90), take_int(s, -90, 90));
    if (take(s) < 8) sink = prt_sh_triple(take_int(s, -1, 12), take_int(s, -12, 12), take_int(s, -1, 12), take_int(s, -12, 12),
                                          take_int(s, -1, 12), take_int(s, -12, 12));
    (void)sink;
    if (!prt_result_string((prt_result)take_int(s, -1, 12))) abort();
}

static int inside_total(prt_rgb c, prt_rgb total) {
    const prt_real v[3] = { c.r, c.g, c.b }, most[3] = { total.r, total.g, total.b };
    int k;
    for (k = 0; k < 3; k++) {
        if (most[k] - most[k] != 0) continue;                /* no finite total, no promise */
        if (!(v[k] >= 0) || v[k] > (most[k] > 0 ? most[k] : 0)) return 0;
    }
    return 1;
}

/* Moving occluders: small tables of any numbers, distances in any order, and what they take stays within the total. */
static void occlude(source *s) {
    prt_fiv_table t;
    prt_fiv_transfer any;
    prt_fiv_occluder occluders[3];
    prt_fiv_packed packed;
    prt_fiv looked;
    prt_rgb total, *lit;
    size_t samples, k;
    unsigned flags = take(s);
    int count = take_int(s, 0, 3);
    memset(&t, 0, sizeof t);
    t.theta_count = 1 + (int)(take(s) % 3); t.phi_count = 1 + (int)(take(s) % 4); t.rho_count = 1 + (int)(take(s) % 3);
    samples = (size_t)(t.theta_count * t.phi_count * t.rho_count);
    t.rho = reals(s, (size_t)t.rho_count);
    t.radius = take_real(s);
    t.samples = (const prt_fiv *)reals(s, samples * 9);
    if (take(s) & 1) {
        unsigned char *inside = (unsigned char *)room(samples);
        for (k = 0; k < samples; k++) inside[k] = (unsigned char)(take(s) & 1);
        t.inside = inside;
    }
    for (k = 0; k < 3; k++) { occluders[k].table = &t; occluders[k].position = take_direction(s); }
    total.r = take_real(s); total.g = take_real(s); total.b = take_real(s);
    lit = (prt_rgb *)out(s, 3);
    if (count > 3) count = -1;
    {
        prt_vec3 at = take_direction(s), normal = take_direction(s);
        if (prt_fiv_shade(total, at, normal, count, occluders, flags, lit) == PRT_OK && !inside_total(*lit, total)) abort();
        if (prt_fiv_lookup(&t, at, &looked) == PRT_OK && !prt__fiv_sample_finite(&looked)) abort();
        if (prt_fiv_self(&looked, &t, at, normal, lit) == PRT_OK && !(lit->r >= 0)) abort();
        if (prt_fiv_pack(&t, 16, room(samples * 18), NULL, NULL, &packed) == PRT_OK) prt_fiv_packed_lookup(&packed, at, &looked);
        any.bands = 1;
        any.theta_count = t.theta_count; any.phi_count = t.phi_count; any.rho_count = t.rho_count;
        any.rho = t.rho; any.radius = t.radius; any.inside = t.inside;
        any.samples = reals(s, samples * 4);
        if (prt_fiv_transfer_lookup(&any, NULL, reals(s, 36), at, &looked) == PRT_OK && !prt__fiv_sample_finite(&looked)) abort();
    }
}

/* Vector occluders in every form: whatever is finite gives light that is finite and not below 0. */
static void vectors(source *s) {
    enum { MOST = 6, SEEN = 3, LIGHTS = 3, POINT = 16, OCCLUDER = 26 };
    int points = take_int(s, 0, MOST), lights = take_int(s, 0, LIGHTS), seen, made = 0, k;
    int *first = (int *)room((MOST + 1) * sizeof *first);
    prt_real *p = reals(s, MOST * POINT), *o = reals(s, MOST * SEEN * OCCLUDER), *l = reals(s, LIGHTS * 6);
    prt_real *v = reals(s, 13), *lit;
    const prt_vo_point *at = (const prt_vo_point *)p;
    const prt_vo_occluder *occluders = (const prt_vo_occluder *)o;
    const prt_point_light *light = (const prt_point_light *)l;
    prt_vo_material *materials = (prt_vo_material *)room(MOST * SEEN * sizeof *materials);
    void *form = room(MOST * SEEN * sizeof(prt_vo_indexed));
    const prt_real unit = v[9];
    prt_vec3 eye;
    prt_vo_params q;
    prt_result r = PRT_OK;
    eye.x = v[10]; eye.y = v[11]; eye.z = v[12];
    q.shadow_strength = v[0]; q.caustic_strength = v[1]; q.caustic_angle = v[2]; q.gloss = v[3];
    q.dd = v[4]; q.ds = v[5]; q.ss = v[6]; q.light_angle = v[7]; q.ss_fade = v[8];
    q.off = take(s); q.law = (int)(take(s) % 3);
    for (first[0] = 0, k = 0; k < MOST; k++) first[k + 1] = first[k] + (int)(take(s) % (SEEN + 1));
    if (points > MOST) points = -1;
    if (lights > LIGHTS) lights = -1;
    seen = points > 0 ? first[points] : 0;
    if (take(s) == 255) first[k / 2] = -1;
    lit = out(s, MOST * 3);
    switch (take(s) % 7) {
        case 0:
            CHECK(r = prt_vo_shade(&q, at, eye, (int)(take(s) % 4), occluders, lights, light, (prt_rgb *)lit));
            break;
        case 1:
            CHECK(r = prt_vo_shade_n(&q, points, at, eye, first, occluders, lights, light, (prt_rgb *)lit));
            break;
        case 2:
            if (prt_vo_pack(unit, eye, seen, occluders, (prt_vo_packed *)form) != PRT_OK) return;
            CHECK(r = prt_vo_shade_packed_n(&q, unit, points, at, eye, first, (prt_vo_packed *)form, lights, light,
                                            (prt_rgb *)lit));
            break;
        case 3:
            if (prt_vo_pack_diffuse(unit, eye, seen, occluders, (prt_vo_packed_diffuse *)form) != PRT_OK) return;
            CHECK(r = prt_vo_shade_packed_diffuse_n(&q, unit, points, at, eye, first, (prt_vo_packed_diffuse *)form,
                                                    lights, light, (prt_rgb *)lit));
            break;
        case 4:
            if (prt_vo_index(seen, occluders, MOST * SEEN, materials, &made, (prt_vo_indexed *)form) != PRT_OK) return;
            CHECK(r = prt_vo_shade_indexed_n(&q, points, at, eye, first, made, materials, (prt_vo_indexed *)form, lights,
                                             light, (prt_rgb *)lit));
            break;
        case 5:
            if (prt_vo_index_diffuse(seen, occluders, MOST * SEEN, materials, &made, (prt_vo_indexed_diffuse *)form) !=
                PRT_OK) return;
            CHECK(r = prt_vo_shade_indexed_diffuse_n(&q, points, at, eye, first, made, materials,
                                                     (prt_vo_indexed_diffuse *)form, lights, light, (prt_rgb *)lit));
            break;
        default:
            prt_vo_bend(2, (const prt_vo_wave *)reals(s, 18), take_real(s), eye, seen, occluders, (prt_vo_occluder *)o);
            return;
    }
    for (k = 0; k < MOST * POINT; k++) if (!prt__finite(p[k])) return;
    for (k = 0; k < MOST * SEEN * OCCLUDER; k++) if (!prt__finite(o[k])) return;
    for (k = 0; k < LIGHTS * 6; k++) if (!prt__finite(l[k])) return;
    for (k = 0; k < 13; k++) if (!prt__finite(v[k])) return;
    for (k = 0; r == PRT_OK && lit && k < (points > 0 ? 3 * points : 0); k++) if (!(lit[k] >= 0 && prt__finite(lit[k]))) abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    source s;
    int bands, k;
    size_t n;
    s.at = data;
    s.end = data + size;
    bands = take_int(&s, 0, PRT_MAX_BANDS + 1);
    n = bands >= 1 && bands <= PRT_MAX_BANDS ? (size_t)PRT_SH_COUNT(bands) : 1;
    taken_count = 0;
    output_count = 0;
    switch (take(&s) % 10) {
        case 0: evaluate(&s, bands, n); break;
        case 1: project(&s, bands, n); break;
        case 2: transform(&s, bands, n); break;
        case 3: rotate(&s, bands, n); break;
        case 4: if (take(&s) % 2) shade(&s, bands, n); else shade_packed(&s, bands, n); break;
        case 5: multiply(&s, bands, n); break;
        case 6: smooth(&s, bands, n); break;
        case 7: occlude(&s); break;
        case 8: vectors(&s); break;
        default: values(&s, bands, n); break;
    }
    for (k = 0; k < taken_count; k++) free(taken[k]);
    return 0;
}
