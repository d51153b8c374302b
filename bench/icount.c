/* icount.c - runs each kernel of a short list once under valgrind's callgrind, which counts its instructions exactly.
   icount.sh compares the counts with icount.csv. Not useful when run alone. */
#include "prt_bake.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <valgrind/callgrind.h>

enum { COUNT = 256, WIDTH = 64, HEIGHT = 32, MOST = 16 };

static prt_vec3 dirs[COUNT];
static prt_real x[COUNT], y[COUNT], z[COUNT], f[3 * MOST * MOST], g[3 * MOST * MOST], rows[COUNT * 25];
static prt_real blocks[MOST * (4 * MOST * MOST - 1) / 3], out[COUNT * 25 + MOST * (4 * MOST * MOST - 1) / 3];
static prt_rgb shaded[COUNT];
static float texels[3 * WIDTH * HEIGHT];
static const prt_real turn[9] = { (prt_real)0.36, (prt_real)0.48, (prt_real)-0.8, (prt_real)-0.8, (prt_real)0.6, 0,
                                  (prt_real)0.48, (prt_real)0.64, (prt_real)0.6 };

/* Moving occluders, vector occluders, and a triangle that every other ray meets. */
enum { THETAS = 9, PHIS = 16, RHOS = 4, FIVS = THETAS * PHIS * RHOS, RECEIVERS = 64, BODIES = 4, SEEN = 5, LAMPS = 4,
       RAYS = 1024 };
static const prt_real rho[RHOS] = { 1, 2, 4, 8 };
static prt_fiv samples[FIVS];
static prt_fiv_table table;
static prt_fiv_occluder bodies[BODIES];
static prt_rgb totals[RECEIVERS];
static prt_vec3 receivers[RECEIVERS], normals[RECEIVERS];
static prt_vo_params params;
static prt_vo_point points[RECEIVERS];
static prt_vo_occluder seen[RECEIVERS * SEEN];
static int first[RECEIVERS + 1];
static prt_point_light lamps[LAMPS];
static prt_real packed_low[25], packed_step[25];
static unsigned char packed_bytes[COUNT * 25];
static prt_packed_transfer packed;
static const uint32_t corners[3] = { 0, 1, 2 };
static prt_point places[3];
static prt_real transfer[3 * 25], bounce[3 * 25];
static prt_bounce_object object;
static prt_tracer tracer;
static prt_bake_desc bake;
static prt_bounce_desc bounces;

static int nothing(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    (void)user; (void)count; (void)rays; (void)blocked;
    return 0;
}

static int every_other(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    int k;
    (void)user; (void)rays;
    for (k = 0; k < count; k += 2) {
        hits[k].t = 1; hits[k].object = hits[k].primitive = 0;
        hits[k].u = hits[k].v = (prt_real)0.25;
        hits[k].normal.x = -rays[k].dir.x; hits[k].normal.y = -rays[k].dir.y; hits[k].normal.z = -rays[k].dir.z;
    }
    return 0;
}

static void fill(prt_real *to, int count) {
    int i;
    for (i = 0; i < count; i++) to[i] = (prt_real)((i * 37) % 101 - 50) / 50;
}

static void prepare_rooms(void) {
    int k;
    fill(&samples[0].r.x, 9 * FIVS);
    table.theta_count = THETAS; table.phi_count = PHIS; table.rho_count = RHOS;
    table.rho = rho; table.radius = 1; table.samples = samples;
    for (k = 0; k < BODIES; k++) {
        bodies[k].table = &table;
        bodies[k].position.x = (prt_real)k; bodies[k].position.z = 2;
    }
    fill(&points[0].position.x, (int)(sizeof points / (sizeof(prt_real))));
    fill(&seen[0].position.x, (int)(sizeof seen / (sizeof(prt_real))));
    fill(&lamps[0].position.x, (int)(sizeof lamps / (sizeof(prt_real))));
    for (k = 0; k < RECEIVERS; k++) {
        totals[k].r = totals[k].g = totals[k].b = 3;
        receivers[k].x = (prt_real)(k % 8); receivers[k].y = (prt_real)(k / 8);
        normals[k].z = 1;
        first[k + 1] = first[k] + SEEN;
    }
    prt_transfer_pack(5, PRT_STORAGE_8, COUNT, rows, packed_bytes, packed_low, packed_step, &packed);
    for (k = 0; k < 3; k++) places[k].normal.z = 1;
    places[1].position.x = places[2].position.y = 1;
    tracer.occluded = nothing; tracer.closest = every_other;
    bake.bands = bounces.bands = 5;
    bake.samples = bounces.samples = RAYS;
    bake.tracer = bounces.tracer = &tracer;
    object.triangle_count = 1; object.triangles = corners;
    object.albedo.r = object.albedo.g = object.albedo.b = (prt_real)0.5;
    bounces.objects = &object; bounces.object_count = 1;
}

static void prepare(void) {
    int k;
    for (k = 0; k < COUNT; k++) {
        prt_real t = (prt_real)(2 * k + 1) / COUNT - 1, s = sqrtf(1 - t * t);
        x[k] = dirs[k].x = s * (prt_real)0.6;
        y[k] = dirs[k].y = s * (prt_real)0.8;
        z[k] = dirs[k].z = t;
    }
    fill(f, 3 * MOST * MOST);
    fill(g, 3 * MOST * MOST);
    fill(rows, COUNT * 25);
    for (k = 0; k < 3 * WIDTH * HEIGHT; k++) texels[k] = (float)(k % 17);
    prepare_rooms();
}

/* Counts `call` and gives the count its name. A first call leaves out what happens only once, say symbol binding. */
#define COUNT_IT(name, call) do { \
        call; \
        CALLGRIND_ZERO_STATS; \
        call; \
        CALLGRIND_DUMP_STATS_AT(name); \
        __asm__ volatile("" : : "r"(out), "r"(shaded) : "memory"); \
    } while (0)

int main(void) {
    if (!RUNNING_ON_VALGRIND) {
        fprintf(stderr, "icount: run me through bench/icount.sh, which needs valgrind\n");
        return 1;
    }
    prepare();
    COUNT_IT("sh_eval-3", prt_sh_eval(3, dirs[0], out));
    COUNT_IT("sh_eval-5", prt_sh_eval(5, dirs[0], out));
    COUNT_IT("sh_eval-10", prt_sh_eval(10, dirs[0], out));
    COUNT_IT("sh_eval-16", prt_sh_eval(16, dirs[0], out));
    COUNT_IT("sh_eval_n-5x256", prt_sh_eval_n(5, COUNT, dirs, out));
    COUNT_IT("sh_eval_soa-5x256", prt_sh_eval_soa(5, COUNT, x, y, z, out, COUNT));
    COUNT_IT("sh_at-5", out[0] = prt_sh_at(5, f, dirs[0]));
    COUNT_IT("sh_dot-5", out[0] = prt_sh_dot(5, f, g));
    COUNT_IT("sh_cone-5", prt_sh_cone(5, dirs[0], (prt_real)0.3, out));
    COUNT_IT("sh_project_equirect-5x64x32", prt_sh_project_equirect_rgb(5, WIDTH, HEIGHT, texels, out));
    COUNT_IT("sh_rotation-5", prt_sh_rotation(5, turn, blocks));
    COUNT_IT("sh_rotate_by-5", prt_sh_rotate_by(5, blocks, f, out));
    COUNT_IT("sh_rotate_by_n-5x256", prt_sh_rotate_by_n(5, blocks, COUNT, rows, out));
    COUNT_IT("sh_product-3", prt_sh_product(3, f, g, out));
    COUNT_IT("sh_product-5", prt_sh_product(5, f, g, out));
    COUNT_IT("sh_product-10", prt_sh_product(10, f, g, out));
    COUNT_IT("sh_product_soa-5x128", prt_sh_product_soa(5, COUNT / 2, rows, rows + COUNT / 2, out, COUNT));
    COUNT_IT("sh_mask_filter-5", prt_sh_mask_filter(5, PRT_WINDOW_POSITIVE, f, g, out));
    COUNT_IT("sh_rotate-5", prt_sh_rotate(5, turn, f, out));
    COUNT_IT("sh_rotate-8", prt_sh_rotate(8, turn, f, out));
    COUNT_IT("sh_rotate-16", prt_sh_rotate(16, turn, f, out));
    COUNT_IT("sh_square-5", prt_sh_square(5, f, out));
    COUNT_IT("sh_mask-5", prt_sh_mask(5, PRT_WINDOW_HANN, f, g, out));
    COUNT_IT("sh_exp-5", prt_sh_exp(5, f, out));
    COUNT_IT("sh_window-5", prt_sh_window(5, PRT_WINDOW_HANN, 5, f, out));
    COUNT_IT("ch_eval-5", prt_ch_eval(5, dirs[0], out));
    COUNT_IT("ch_from_sh-5", prt_ch_from_sh(5, f, out));
    COUNT_IT("shade_diffuse_n-5x256", prt_shade_diffuse_n(5, COUNT, rows, f, shaded));
    COUNT_IT("shade_diffuse_rgb_n-5x85", prt_shade_diffuse_rgb_n(5, COUNT / 3, rows, f, shaded));
    COUNT_IT("shade_packed_n-5x256", prt_shade_packed_n(&packed, 0, COUNT, f, shaded));
    COUNT_IT("fiv_lookup", prt_fiv_lookup(&table, receivers[9], (prt_fiv *)out));
    COUNT_IT("fiv_shade-4", prt_fiv_shade(totals[0], receivers[0], normals[0], BODIES, bodies, 0, shaded));
    COUNT_IT("fiv_shade_n-64x4", prt_fiv_shade_n(RECEIVERS, totals, receivers, normals, BODIES, bodies, 0, shaded));
    COUNT_IT("vo_shade-5x4", prt_vo_shade(&params, points, dirs[0], SEEN, seen, LAMPS, lamps, shaded));
    COUNT_IT("vo_shade_n-64x5x4",
             prt_vo_shade_n(&params, RECEIVERS, points, dirs[0], first, seen, LAMPS, lamps, shaded));
    COUNT_IT("bake_transfer-5x1024", prt_bake_transfer(&bake, 1, places, 0, 1, transfer));
    COUNT_IT("bake_bounce-5x1024", prt_bake_bounce(&bounces, 3, places, transfer, 0, 1, bounce));
    return 0;
}
