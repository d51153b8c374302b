/* Every room of both headers on inputs that are the same numbers on every machine, for run.sh.
     portable write            the results, as text: of a double build, what others are compared with
     portable check < results  for each operation: its name, how many results, the largest error, what the headers promise
                               for it, and a hash of the bits of the results
   All input is integers over powers of two, or one square root of such: no compiler can round it differently. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include <float.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST = 6000, DIRECTIONS = 48 };

static double result[MOST];
static int result_count;
static void put(prt_real v) {
    if (result_count < MOST) result[result_count] = (double)v;
    result_count++;
}
static void put_all(int count, const prt_real *v) {
    int i;
    for (i = 0; i < count; i++) put(v[i]);
}

static uint32_t state;
static uint32_t next(void) {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}
static prt_real fraction(void) { return (prt_real)((int)(next() >> 20) - 2048) / 2048; }   /* -1 ... 1 in 4096 steps */
static void coefficients(int count, prt_real *f) {
    int i;
    for (i = 0; i < count; i++) f[i] = fraction();
}

/* x and y in 4096 steps, so that 1 - x^2 - y^2 is exact in double; z of float's precision in both builds */
static prt_vec3 direction(void) {
    prt_vec3 d;
    double x, y, square;
    do {
        x = (double)fraction();
        y = (double)fraction();
        square = 1 - x * x - y * y;
    } while (square < 0);
    d.x = (prt_real)x;
    d.y = (prt_real)y;
    d.z = (prt_real)(float)(next() & 1 ? sqrt(square) : -sqrt(square));
    return d;
}
static void directions(prt_vec3 *d) {
    int i;
    for (i = 0; i < DIRECTIONS; i++) d[i] = direction();
    d[0].x = d[0].y = d[1].x = d[1].y = 0;
    d[0].z = 1;
    d[1].z = -1;
}

/* As orthogonal as the precision allows: on less than that, which a double build would take for a slant, two ways to
   compute an angle need not agree. */
static void a_rotation(prt_real r[9]) {
    const prt_real third = (prt_real)(1.0 / 3), two_thirds = (prt_real)(2.0 / 3);
    r[0] = third;       r[1] = two_thirds; r[2] = -two_thirds;
    r[3] = two_thirds;  r[4] = third;      r[5] = two_thirds;
    r[6] = two_thirds;  r[7] = -two_thirds; r[8] = -third;
}

static prt_vec3 vec3(double x, double y, double z) {
    prt_vec3 v;
    v.x = (prt_real)x;
    v.y = (prt_real)y;
    v.z = (prt_real)z;
    return v;
}
/* lengths 1 within one rounding of float */
static prt_vec3 an_axis(void) { return vec3(0.375, -0.5625, (double)(float)0.73687430236271806); }

/* ---- the operations ---- */

static void eval(int bands) {
    prt_real y[64 * 64];
    prt_vec3 d[DIRECTIONS];
    int i;
    directions(d);
    for (i = 0; i < (bands > 13 ? 1 : DIRECTIONS); i++) {
        prt_sh_eval(bands, d[bands > 13 ? 5 : i], y);
        put_all(bands * bands, y);
    }
}
static void eval_5(void) { eval(5); }
static void eval_10(void) { eval(10); }
static void eval_64(void) { eval(64); }
static void eval_batch(void) {
    prt_real x[DIRECTIONS], y[DIRECTIONS], z[DIRECTIONS], out[36 * DIRECTIONS];
    prt_vec3 d[DIRECTIONS];
    int i;
    directions(d);
    for (i = 0; i < DIRECTIONS; i++) { x[i] = d[i].x; y[i] = d[i].y; z[i] = d[i].z; }
    prt_sh_eval_soa(6, DIRECTIONS, x, y, z, out, DIRECTIONS);
    put_all(36 * DIRECTIONS, out);
}
static void at_and_dot(void) {
    prt_real f[64], g[64];
    prt_vec3 d[DIRECTIONS];
    int i;
    directions(d);
    coefficients(64, f);
    coefficients(64, g);
    for (i = 0; i < DIRECTIONS; i++) put(prt_sh_at(8, f, d[i]));
    put(prt_sh_dot(8, f, g));
}
static void lights(void) {
    prt_real f[64];
    prt_sh_delta(8, an_axis(), f);                                          put_all(64, f);
    prt_sh_cone(8, an_axis(), (prt_real)0.625, f);                          put_all(64, f);
    prt_sh_sphere(8, vec3(1, -2, 0.5), (prt_real)0.75, f);                  put_all(64, f);
    prt_sh_cosine_lobe(8, an_axis(), f);                                    put_all(64, f);
    prt_sh_hemisphere(8, an_axis(), (prt_real)0.75, (prt_real)0.125, f);    put_all(64, f);
}
static void maps(void) {
    static float map[3 * 16 * 32], face[6][3 * 64];
    const float *faces[6];
    prt_real light[3 * 64];
    int i, k;
    for (i = 0; i < 3 * 16 * 32; i++) map[i] = (float)(next() >> 22) / 256;
    for (k = 0; k < 6; k++) {
        for (i = 0; i < 3 * 64; i++) face[k][i] = (float)(next() >> 22) / 256;
        faces[k] = face[k];
    }
    prt_sh_project_equirect_rgb(8, 32, 16, map, light);
    put_all(3 * 64, light);
    prt_sh_project_cubemap_rgb(8, 8, faces, light);
    put_all(3 * 64, light);
}
static void bands_scaled(void) {
    prt_real f[64], zonal[8], out[64];
    int w;
    coefficients(64, f);
    coefficients(8, zonal);
    prt_sh_convolve(8, f, zonal, out);  put_all(64, out);
    prt_sh_irradiance(8, f, out);       put_all(64, out);
    for (w = PRT_WINDOW_NONE; w <= PRT_WINDOW_POSITIVE; w++) {
        prt_sh_window(8, (prt_window)w, 8, f, out);
        put_all(64, out);
    }
}
static void dering(void) {
    prt_real f[36], out[36], strength = 0;
    prt_sh_cone(6, an_axis(), (prt_real)0.5, f);
    prt_sh_dering(6, f, out, &strength);
    put_all(36, out);
    put(strength);
}
static void convention(void) {
    prt_real f[16], out[16];
    int c;
    coefficients(16, f);
    for (c = PRT_CONVENTION_PRT; c <= PRT_CONVENTION_FILAMENT; c++) {
        prt_sh_convert(4, PRT_CONVENTION_PRT, (prt_sh_convention)c, f, out);
        put_all(16, out);
    }
}
static void blocks(void) {
    static prt_real b[9 * (4 * 81 - 1) / 3];
    prt_real r[9];
    a_rotation(r);
    prt_sh_rotation(9, r, b);
    put_all((int)prt_sh_rotation_count(9), b);
}
static void turned(void) {
    static prt_real b[6 * (4 * 36 - 1) / 3], f[32 * 36], out[32 * 36];
    prt_real r[9];
    a_rotation(r);
    coefficients(32 * 36, f);
    prt_sh_rotation(6, r, b);
    prt_sh_rotate_by_n(6, b, 32, f, out);
    put_all(32 * 36, out);
}
static void turned_once(void) {
    prt_real f[81], out[81], zonal[9], r[9];
    int n;
    a_rotation(r);
    for (n = 2; n <= 9; n++) {
        coefficients(n * n, f);
        prt_sh_rotate(n, r, f, out);
        put_all(n * n, out);
    }
    prt_sh_rotate_z(8, (prt_real)0.6875, f, out);
    put_all(64, out);
    coefficients(9, zonal);
    prt_sh_zonal_to(9, zonal, an_axis(), out);
    put_all(81, out);
}
static void products(void) {
    prt_real f[144], g[144], out[144];
    int n;
    for (n = 2; n <= 12; n++) {
        coefficients(n * n, f);
        coefficients(n * n, g);
        prt_sh_product(n, f, g, out);
        for (int i = 0; i < n * n; i++) put(out[i] / (prt_real)(n * n));
    }
}
static void masks(void) {
    prt_real f[36], g[36], out[36];
    int w;
    coefficients(36, f);
    coefficients(36, g);
    for (w = PRT_WINDOW_NONE; w <= PRT_WINDOW_POSITIVE; w++) {
        prt_sh_mask(6, (prt_window)w, f, g, out);
        for (int i = 0; i < 36; i++) put(out[i] / 36);
    }
}
static void exponential(void) {
    prt_real f[16], out[16], back[16] = { 0 };
    prt_sh_cone(4, an_axis(), (prt_real)0.75, f);
    for (int i = 0; i < 16; i++) f[i] = -f[i];
    prt_sh_exp(4, f, out);
    put_all(16, out);
    prt_sh_log(4, 8, (prt_real)0.0625, out, back);
    put_all(16, back);
}
static void ch(void) {
    prt_real c[100], f[64], out[64], r[9];
    prt_vec3 d[DIRECTIONS];
    int i;
    directions(d);
    for (i = 0; i < DIRECTIONS; i++) {
        prt_ch_eval(10, d[i], c);
        for (int k = 0; k < 100; k++) put(c[k] / 8);
    }
    coefficients(64, f);
    prt_ch_from_sh(8, f, out);  put_all(64, out);
    prt_sh_from_ch(8, f, out);  put_all(64, out);
    a_rotation(r);
    prt_ch_rotate(8, r, f, out);
    for (i = 0; i < 64; i++) put(out[i] / 8);
}
static void ch_product(void) {
    prt_real f[25], g[25], out[25];
    coefficients(25, f);
    coefficients(25, g);
    prt_ch_product(5, f, g, out);
    for (int i = 0; i < 25; i++) put(out[i] / 25);
}
static void triples(void) {
    for (int l = 0; l < 8; l++)
        for (int m = -l; m <= l; m++) put((prt_real)prt_sh_triple(l, m, 4, m < 0 ? -2 : 2, 6, m < 0 ? -m - 2 : m + 2));
}

/* Three numbers up to `most`, one after the other, since the order of arguments is the compiler's; through a pointer,
   since tcc 0.9.27 stores the 12 bytes that a function returns as 16, over what stands beside them. */
static void place(double most, prt_vec3 *v) {
    v->x = fraction() * (prt_real)most;
    v->y = fraction() * (prt_real)most;
    v->z = fraction() * (prt_real)most;
}
static void colour(prt_rgb *c) {
    c->r = (1 + fraction()) / 2;
    c->g = (1 + fraction()) / 2;
    c->b = (1 + fraction()) / 2;
}

/* Vectors of 5 x 8 x 3 places, 1 at most, as the table of three occluders over 24 receivers. */
enum { FIV_PLACES = 5 * 8 * 3, RECEIVERS = 24 };
static prt_fiv fiv_samples[FIV_PLACES];
static prt_fiv_table fiv_table(void) {
    static const prt_real rho[3] = { (prt_real)1.25, 2, 4 };
    prt_fiv_table t;
    memset(&t, 0, sizeof t);
    for (int i = 0; i < FIV_PLACES; i++) {
        place(1, &fiv_samples[i].r);
        place(1, &fiv_samples[i].g);
        place(1, &fiv_samples[i].b);
    }
    t.theta_count = 5;
    t.phi_count = 8;
    t.rho_count = 3;
    t.rho = rho;
    t.radius = 1;
    t.samples = fiv_samples;
    return t;
}
static void fiv_lookup(void) {
    prt_fiv_table t = fiv_table();
    prt_vec3 at;
    prt_fiv v;
    for (int i = 0; i < 64; i++) {
        place(4, &at);
        prt_fiv_lookup(&t, at, &v);
        put_all(9, &v.r.x);
    }
}
static void fiv_shade(void) {
    prt_fiv_table t = fiv_table();
    prt_fiv_occluder o[3];
    prt_vec3 positions[RECEIVERS], normals[DIRECTIONS];
    prt_rgb totals[RECEIVERS], out[RECEIVERS];
    for (int i = 0; i < 3; i++) { o[i].table = &t; place(4, &o[i].position); }
    directions(normals);
    for (int i = 0; i < RECEIVERS; i++) { place(4, &positions[i]); colour(&totals[i]); }
    prt_fiv_shade_n(RECEIVERS, totals, positions, normals, 3, o, 0, out);
    put_all(3 * RECEIVERS, &out[0].r);
    for (int i = 0; i < RECEIVERS; i++) {
        prt_fiv_shade(totals[i], positions[i], normals[i], 3, o, PRT_FIV_PAPER_PARTIAL, out);
        put_all(3, &out[0].r);
    }
}
static prt_vo_occluder a_vo_occluder(void) {
    prt_vo_occluder o;
    memset(&o, 0, sizeof o);
    place(4, &o.position);
    o.occlusion = direction();
    o.caustic = direction();
    colour(&o.transmissive);
    place(0.25, &o.diffuse_normal);
    place(0.25, &o.specular_normal);
    colour(&o.diffuse);
    colour(&o.specular);
    o.form_factor = (1 + fraction()) / 4;
    o.caustic_factor = (1 + fraction()) / 8;
    return o;
}
static void vo_shade(void) {
    prt_vo_occluder o[3];
    prt_point_light lights[2];
    prt_vo_point points[RECEIVERS];
    prt_vo_params params;
    prt_rgb out[RECEIVERS];
    int first[RECEIVERS + 1];
    memset(&params, 0, sizeof params);
    memset(points, 0, sizeof points);
    for (int i = 0; i < 3; i++) o[i] = a_vo_occluder();
    for (int i = 0; i < 2; i++) { place(4, &lights[i].position); colour(&lights[i].color); }
    for (int i = 0; i < RECEIVERS; i++) {
        place(4, &points[i].position);
        points[i].normal = direction();
        colour(&points[i].diffuse);
        colour(&points[i].specular);
        points[i].shininess = 4;
        prt_vo_shade(&params, &points[i], vec3(2, 3, 5), 3, o, 2, lights, out);
        for (int c = 0; c < 3; c++) put((&out[0].r)[c] / 16);
    }
    for (int i = 0; i <= RECEIVERS; i++) first[i] = i % 4 == 3 ? 3 : i % 4;
    for (int i = 1; i <= RECEIVERS; i++) if (first[i] < first[i - 1]) first[i] = first[i - 1];
    params.law = PRT_VO_CAP;
    prt_vo_shade_n(&params, RECEIVERS, points, vec3(2, 3, 5), first, o, 2, lights, out);
    for (int i = 0; i < RECEIVERS; i++) for (int c = 0; c < 3; c++) put((&out[i].r)[c] / 16);
}
static void packed(void) {
    static prt_real transfer[40 * 16], low[16], step[16];
    static uint16_t data[40 * 16];
    prt_real light[48];
    prt_packed_transfer p;
    prt_rgb out[40];
    coefficients(40 * 16, transfer);
    coefficients(48, light);
    prt_transfer_pack(4, PRT_STORAGE_HALF, 40, transfer, data, low, step, &p);
    prt_shade_packed_n(&p, 0, 40, light, out);
    for (int i = 0; i < 40; i++) for (int c = 0; c < 3; c++) put((&out[i].r)[c] / 8);
}
static void measures(void) {
    prt_real transfer[16 * 16], light[48], shares[5];
    double energy[4], light_energy[4], rms = 0;
    coefficients(16 * 16, transfer);
    coefficients(48, light);
    coefficients(5, shares);
    prt_measure_energy(4, 16, transfer, energy);
    prt_measure_energy(4, 3, light, light_energy);
    for (int n = 0; n <= 4; n++) {
        prt_measure_truncation(4, n, PRT_WINDOW_HANN, 16, transfer, light, &rms);
        put((prt_real)rms);
        prt_measure_truncation_turned(4, n, PRT_WINDOW_NONE, energy, light_energy, &rms);
        put((prt_real)rms);
    }
    put((prt_real)prt_measure_entropy(5, shares));
}
static void shading(void) {
    static prt_real transfer[40 * 36], light[3 * 36];
    prt_rgb out[40];
    coefficients(40 * 36, transfer);
    coefficients(3 * 36, light);
    prt_shade_diffuse_n(6, 40, transfer, light, out);
    for (int i = 0; i < 40; i++) { put(out[i].r / 8); put(out[i].g / 8); put(out[i].b / 8); }
}
static void samples(void) {
    prt_vec3 d[64];
    prt_real u[64], v[64];
    int set;
    for (set = 0; set < PRT_SAMPLE_SET_COUNT; set++) {
        prt_sample_square((prt_sample_set)set, 64, 7, 3, 0, 64, u, v);
        put_all(64, u);
        put_all(64, v);
    }
    prt_sample_directions(64, 7, 3, an_axis(), 0, 64, d);
    for (int i = 0; i < 64; i++) { put(d[i].x); put(d[i].y); put(d[i].z); }
}
static void bake(void) {
    static const prt_real at[8][3] = { {0,0,0}, {1,0,0}, {1,1,0}, {0,1,0}, {0,0,1}, {1,0,1}, {1,1,1}, {0,1,1} };
    static const uint32_t faces[36] = { 0,2,1, 0,3,2, 4,5,6, 4,6,7, 0,1,5, 0,5,4, 1,2,6, 1,6,5, 2,3,7, 2,7,6,
                                        3,0,4, 3,4,7 };
    prt_vec3 positions[8];
    prt_point points[8];
    prt_mesh mesh;
    prt_bake_desc desc;
    prt_real transfer[8 * 25];
    memset(&mesh, 0, sizeof mesh);
    memset(&desc, 0, sizeof desc);
    for (int i = 0; i < 8; i++) { positions[i].x = at[i][0]; positions[i].y = at[i][1]; positions[i].z = at[i][2]; }
    mesh.vertex_count = 8;
    mesh.positions = positions;
    mesh.triangle_count = 12;
    mesh.triangles = faces;
    prt_points_from_vertices(&mesh, points, NULL);
    for (int i = 0; i < 8; i++) { put(points[i].normal.x); put(points[i].normal.y); put(points[i].normal.z); }
    desc.samples = 256;
    prt_bake_transfer(&desc, 8, points, 0, 8, transfer);
    put_all(8 * 25, transfer);
}

/* What the headers promise for these inputs, absolute, float and double, where the input has no rounding of its own */
static const struct operation { const char *name; void (*run)(void); double promised[2]; } operations[] = {
    { "eval, 5 bands",                        eval_5,       { 1.3e-6, 2e-15 } },
    { "eval, 10 bands",                       eval_10,      { 5e-6, 8e-15 } },
    { "eval, 64 bands",                       eval_64,      { 1.5e-7, 3e-13 } },
    { "eval_soa, 6 bands",                    eval_batch,   { 1.3e-6, 2e-15 } },
    { "at, dot, 8 bands",                     at_and_dot,   { 4e-5, 8e-14 } },
    { "delta, cone, sphere, lobe, hemisphere", lights,      { 2e-6, 4e-15 } },
    { "maps, 8 bands",                        maps,         { 2e-6, 4e-14 } },
    { "convolve, irradiance, window",         bands_scaled, { 1e-6, 2e-15 } },
    { "dering, 6 bands",                      dering,       { 1e-5, 2e-14 } },
    { "convert",                              convention,   { 0, 0 } },
    { "rotation blocks, 9 bands",             blocks,       { 4e-7, 9e-16 } },
    { "rotate_by_n, 6 bands",                 turned,       { 2e-6, 4e-15 } },
    { "rotate 2 to 9 bands, rotate_z, zonal_to", turned_once, { 2e-6, 4e-15 } },
    { "product, 2 to 12 bands, per n^2",      products,     { 3e-7, 1e-15 } },
    { "mask, 6 bands, per n^2",               masks,        { 3e-7, 1e-15 } },
    { "exp, log, 4 bands",                    exponential,  { 2e-5, 4e-14 } },
    { "ch: eval, from and to SH, rotate",     ch,           { 2e-6, 4e-15 } },
    { "ch_product, 5 bands, per n^2",         ch_product,   { 3e-7, 1e-15 } },
    { "triple",                               triples,      { 6e-8, 2e-16 } },
    { "shade_diffuse_n, 6 bands, eighth",     shading,      { 1e-6, 2e-15 } },
    { "shade_packed_n, halves, 4 bands, eighth", packed,    { 1e-6, 2e-15 } },
    { "fiv_lookup",                           fiv_lookup,   { 1.2e-5, 2.3e-14 } },
    { "fiv_shade, fiv_shade_n, 3 occluders",  fiv_shade,    { 3.6e-5, 7e-14 } },
    { "vo_shade, vo_shade_n, 2 lights, 16th", vo_shade,     { 1e-5, 2e-14 } },
    { "energies, truncation, entropy",        measures,     { 3e-7, 2e-15 } },
    { "sample sets, directions",              samples,      { 3e-7, 1e-15 } },
    { "mesh normals, unshadowed bake",        bake,         { 1e-6, 2e-15 } },
};
enum { OPERATIONS = sizeof operations / sizeof operations[0] };

/* FNV-1a over the bits of the results as prt_real, most significant byte first: the same on any byte order */
static uint64_t hash_of_results(void) {
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    int i, shift;
    for (i = 0; i < result_count; i++) {
        prt_real v = (prt_real)result[i];
        uint64_t bits = 0;
#ifdef PRT_DOUBLE
        memcpy(&bits, &v, sizeof v);
#else
        uint32_t word;
        memcpy(&word, &v, sizeof word);
        bits = word;
#endif
        for (shift = 8 * (int)sizeof v - 8; shift >= 0; shift -= 8) {
            hash ^= bits >> shift & 0xff;
            hash *= UINT64_C(0x100000001b3);
        }
    }
    return hash;
}

static int run(int k) {
    state = 2463534242u;
    result_count = 0;
    operations[k].run();
    if (result_count <= MOST) return 0;
    fprintf(stderr, "portable: %s gives %d results, and there is room for %d: raise MOST\n", operations[k].name,
            result_count, (int)MOST);
    return 1;
}

static int write_results(void) {
    int k, i;
    for (k = 0; k < OPERATIONS; k++) {
        if (run(k)) return 1;
        for (i = 0; i < result_count; i++) printf("%.17g\n", result[i]);
    }
    return 0;
}

static int check_results(void) {
    char line[64];
    int k, i, far = 0;
    for (k = 0; k < OPERATIONS; k++) {
        double worst = 0, promised = operations[k].promised[sizeof(prt_real) == sizeof(double)];
        if (run(k)) return 1;
        for (i = 0; i < result_count; i++) {
            double error;
            if (!fgets(line, sizeof line, stdin)) {
                fprintf(stderr, "portable: standard input ends before %s: give it what `portable write` prints\n",
                        operations[k].name);
                return 1;
            }
            error = fabs(result[i] - strtod(line, NULL));
            if (!(error <= worst)) worst = error;
        }
        if (!(worst <= promised)) far = 1;
        printf("%s|%d|%.2g|%.2g|%08lx%08lx\n", operations[k].name, result_count, worst, promised,
               (unsigned long)(hash_of_results() >> 32), (unsigned long)(hash_of_results() & 0xffffffffu));
    }
    return far ? 3 : 0;
}

int main(int argc, char **argv) {
    if (argc == 2 && !strcmp(argv[1], "write")) return write_results();
    if (argc == 2 && !strcmp(argv[1], "check")) return check_results();
    fprintf(stderr, "usage: portable write, or portable check < what a double build wrote\n");
    return 2;
}
