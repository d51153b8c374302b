/* fiv_tables: the experiments of Michael and Chrysanthou's paper on fullsphere irradiance vectors, run again.

   Writes DIR/fiv.md and the pictures it shows, DIR/gallery/fiv-*.png. The paper gives no positions, lights or camera,
   so these are ours; its bunny is the same, its tree and queen are a horse. Figures are against ray-traced truth over
   the ground around the occluders:

     NRMSE   root mean square difference of irradiance, all colours, divided by the range of the truth (largest minus
             smallest): the usual normalisation; the paper does not name its own.
     truth   the same environment, every texel a little area of even light: each is cut into parts with a ray each, no
             noise. Beside it stands how far that moves when the parts are twice as wide: the truth's own error.

   --keep DIR keeps finished tables there, so that an interrupted run need not bake them again. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_job.h"
#include "fiv_bake.h"
#include "fiv_receive.h"
#include "plot.h"
#include "program.h"
#include "progress.h"
#include "replacement.h"
#include "text.h"
#include "vector.h"
#include "../bench/bench.h"

enum { TRIO = 96, PLACES = 2 };          /* squares on the ground: pixels in a picture, places across a pixel */
enum { FACE = 32, MOST_TABLES = 64, MOST_OCCLUDERS = 60, BODIES = 3 };

typedef enum light_id { SUN, LAMP, LAMPS, COLOURS, FOREST, LIGHTS } light_id;
static const char *const light_names[LIGHTS] = { "one directional light", "one area light", "two area lights",
                                                 "a green and a red area light", "forest.hdr" };

typedef enum shape_id { BUNNY, HORSE, SHAPES } shape_id;      /* what they are unless --meshes says otherwise */

/* The sampling rates of table 1, (phi, theta, rho), with its minutes and megabytes for the bunny. */
typedef struct rate { int phi, theta, rho; double minutes, megabytes; } rate;
enum { RATES = 5, FINEST = 0, USUAL = 1, SELF = 5, SUNKEN = 6, QUICK = 7 };
static const rate rates[QUICK + 1] = {
    { 256, 129, 30, 397, 34.0 }, { 128, 65, 30, 99, 8.56 }, { 64, 33, 30, 24, 2.17 }, { 64, 33, 15, 12, 1.08 },
    { 32, 17, 15, 3, 0.28 },
    { 32, 17, 16, 0, 0 },              /* for self-shadow, inside the bounding sphere */
    { 128, 65, 30, 0, 0 },             /* for objects that the ground cuts: from nearer */
    { 16, 9, 8, 0, 0 }                 /* for --quick */
};
/* In radii: of objects that touch no receiver, cut ones, and an object's own surface. */
static const prt_real nearest = 1, farthest = (prt_real)4.5, sunken_nearest = (prt_real)0.4;
static const prt_real self_nearest = (prt_real)0.15, self_farthest = 1;

typedef struct kept_table { int shape, light, rate; fiv_baked baked; } kept_table;

typedef struct lab {
    const char *meshes[SHAPES], *out, *keep;
    int        quick, threads, size;   /* size: of the square of receivers on the ground */
    shape      shapes[SHAPES];
    cube_light lights[LIGHTS], fine[LIGHTS], coarse[LIGHTS];         /* fine, coarse: of the truth */
    kept_table *tables[MOST_TABLES];
    int        table_count;
    text_font  regular, bold;
    FILE       *md;
} lab;

static prt_rgb grey(double v) { return rgb(v, v, v); }

/* ---- what the experiments are made of ---- */

static int make_lights(lab *l, why *w) {
    image forest;
    int k, failed;
    for (k = 0; k < FOREST; k++) if (cube_light_create(FACE, &l->lights[k], w)) return -1;
    cube_light_add_patch(&l->lights[SUN], vec(0.5, -0.35, 0.85), 1, 300, 300, 300);
    cube_light_add_patch(&l->lights[LAMP], vec(0.5, -0.35, 0.85), 6, 10, 10, 10);
    cube_light_add_patch(&l->lights[LAMPS], vec(0.5, -0.35, 0.85), 6, 8, 8, 8);
    cube_light_add_patch(&l->lights[LAMPS], vec(-0.6, 0.1, 0.85), 6, 6, 6, 6);
    cube_light_add_patch(&l->lights[COLOURS], vec(0.5, -0.35, 0.85), 6, 1, 9, 1);
    cube_light_add_patch(&l->lights[COLOURS], vec(-0.6, 0.1, 0.85), 6, 9, 1, 1);
    if (image_load_environment(PRT_EXAMPLE_DATA "/forest.hdr", &forest, w)) return -1;
    failed = cube_light_from_image(&forest, FACE, &l->lights[FOREST], w);
    image_free(&forest);
    for (k = 0; k < LIGHTS && !failed; k++) {
        int parts = l->quick ? 2 : k == FOREST ? 2 : 8;    /* a light of few texels needs more of them */
        failed = cube_light_ready(&l->lights[k], w) || cube_light_refine(&l->lights[k], parts, &l->fine[k], w) ||
                 cube_light_refine(&l->lights[k], parts / 2, &l->coarse[k], w);
    }
    return failed;
}

static int load_shapes(lab *l, why *w) {
    int k;
    for (k = 0; k < SHAPES; k++)
        if (shape_load(l->meshes[k], 1, k ? &l->shapes[0] : NULL, &l->shapes[k], w)) return -1;
    return 0;
}

static int bake_table(lab *l, int which, int light, int r, fiv_baked *b, why *w) {
    char what[100];
    fiv_bake_job job;
    memset(&job, 0, sizeof job);
    job.shape = &l->shapes[which];
    job.light = &l->lights[light];
    job.grid.phi = rates[r].phi;
    job.grid.theta = rates[r].theta;
    job.grid.rho = rates[r].rho;
    job.grid.nearest = r == SELF ? self_nearest : r == SUNKEN ? sunken_nearest : nearest;
    job.grid.farthest = r == SELF ? self_farthest : farthest;
    job.mark_inside = r == SELF;
    job.keep = l->keep;
    job.threads = l->threads;
    job.stop = &interrupted;
    snprintf(what, sizeof what, "fiv_tables: %s, %dx%dx%d, %s", job.shape->name, job.grid.phi, job.grid.theta,
             job.grid.rho, light_names[light]);
    job.what = what;
    return fiv_bake_run(&job, b, w);
}

/* The table of a shape under a light at a rate, baked where it is not there yet. */
static const fiv_baked *table_for(lab *l, int which, int light, int r, why *w) {
    kept_table *kept;
    int k;
    for (k = 0; k < l->table_count; k++) {
        kept = l->tables[k];
        if (kept->shape == which && kept->light == light && kept->rate == r) return &kept->baked;
    }
    kept = l->table_count < MOST_TABLES ? (kept_table *)calloc(1, sizeof *kept) : NULL;
    if (!kept) {
        why_set(w, "out of memory for another table");
        return NULL;
    }
    l->tables[l->table_count++] = kept;
    kept->shape = which;
    kept->light = light;
    kept->rate = r;
    return bake_table(l, which, light, r, &kept->baked, w) ? NULL : &kept->baked;
}

static void lab_free(lab *l) {
    int k;
    for (k = 0; k < l->table_count; k++) {
        fiv_baked_free(&l->tables[k]->baked);
        free(l->tables[k]);
    }
    for (k = 0; k < LIGHTS; k++) {
        cube_light_free(&l->lights[k]);
        cube_light_free(&l->fine[k]);
        cube_light_free(&l->coarse[k]);
    }
    for (k = SHAPES - 1; k >= 0; k--) shape_free(&l->shapes[k]);
    text_font_free(&l->regular);
    text_font_free(&l->bold);
}

/* ---- table 1: bakes ---- */

static int write_bakes(lab *l, why *w) {
    int k, which;
    fprintf(l->md, "## Table 1: time and memory of the bake\n\n"
            "6 x %d x %d texels of forest.hdr, all lit, so that no texel is skipped; %d thread%s. Paper: 2.4 GHz Core 2"
            " Duo, processor only. Processor seconds count all threads; wall seconds include what else the machine did"
            " meanwhile. The factor is the paper's minutes over what two such cores take with nothing else to do: half"
            " the processor seconds.\n\n"
            "| object | vertices | samples | processor s | wall s | paper min | times faster | MiB | paper MB |"
            " texels in cones/s a core |\n|---|---:|---|---:|---:|---:|---:|---:|---:|---:|\n",
            FACE, FACE, l->threads, l->threads == 1 ? "" : "s");
    for (which = 0; which < SHAPES; which++) {
        for (k = l->quick ? QUICK : FINEST; k < RATES || k == QUICK; k++) {
            const rate *r = &rates[k];
            const fiv_baked *b;
            double bytes, minutes = which == BUNNY ? r->minutes : 0, cone = 0;
            int j;
            if (which != BUNNY && k != USUAL) continue;        /* as in the paper */
            b = table_for(l, which, FOREST, k, w);
            if (!b) return -1;
            bytes = (double)prt_bake_fiv_count(&b->desc) * sizeof(prt_fiv) + (double)r->rho * sizeof(prt_real);
            for (j = 0; j < r->rho; j++) {
                double s = (double)(b->desc.radius / b->rho[j]);
                cone += (s < 1 ? (1 - sqrt(1 - s * s)) / 2 : 1) * 6 * FACE * FACE * r->phi * r->theta;
            }
            fprintf(l->md, "| %s | %d | %dx%dx%d | %.2f | %.2f | ", l->shapes[which].name,
                    l->shapes[which].mesh.point_count, r->phi, r->theta, r->rho, b->processor, b->seconds);
            if (minutes > 0) fprintf(l->md, "%g | %.0f | ", minutes, 60 * minutes / (b->processor / 2));
            else fprintf(l->md, "| | ");
            fprintf(l->md, "%.2f | %g | %.1f M |\n", bytes / 1048576, r->megabytes, cone / b->processor * 1e-6);
        }
    }
    fputs("\n", l->md);
    return 0;
}

/* ---- table 2: cost ---- */

static double timed(void (*work)(void *), void *user) {
    double start = processor_seconds();
    work(user);
    return processor_seconds() - start;
}

typedef struct cost_job {
    int                    receiver_count, count, batched;
    unsigned               flags;
    const prt_fiv_occluder *occluders;
    const prt_rgb          *totals;
    const prt_vec3         *positions, *normals;
    prt_rgb                *out;
} cost_job;

static void run_cost(void *user) {
    const cost_job *c = (const cost_job *)user;
    int k;
    if (c->batched) {
        prt_fiv_shade_n(c->receiver_count, c->totals, c->positions, c->normals, c->count, c->occluders, c->flags,
                        c->out);
    } else {
        for (k = 0; k < c->receiver_count; k++)
            prt_fiv_shade(c->totals[k], c->positions[k], c->normals[k], c->count, c->occluders, c->flags, c->out + k);
    }
    BENCH_KEEP(c->out);
}

/* A scene of table 2: so many occluders, of one table or of two by turns. */
typedef struct crowd { const char *name; int count, tables[2]; double published; } crowd;
enum { CROWDS = 9, FORMS = 3 };                            /* forms: scalar, batched, batched without overlap */
static const crowd crowds[CROWDS] = {
    { "1 bunny", 1, { BUNNY, BUNNY }, 112 },          { "1 horse (a tree)", 1, { HORSE, HORSE }, 112 },
    { "10 bunnies", 10, { BUNNY, BUNNY }, 68 },       { "10 horses (trees)", 10, { HORSE, HORSE }, 68 },
    { "5 x (bunny+horse)", 10, { BUNNY, HORSE }, 68 },    { "10 x (bunny+horse)", 20, { BUNNY, HORSE }, 46 },
    { "15 x (bunny+horse)", 30, { BUNNY, HORSE }, 35 },   { "20 x (bunny+horse)", 40, { BUNNY, HORSE }, 29 },
    { "30 x (bunny+horse)", 60, { BUNNY, HORSE }, 22 }
};

/* Rows of ten, spacing 2.4 apart, 1.2 above the ground. */
static void place_crowd(const crowd *c, const fiv_baked *const *tables, prt_fiv_occluder *o) {
    int k;
    for (k = 0; k < c->count; k++) {
        int row = k / 10, column = k % 10;
        o[k].table = &tables[c->tables[k % 2]]->table;
        o[k].position = vec(2.4 * (column % 2 ? -(column + 1) / 2 : column / 2) + 1.2,
                             2.4 * (row % 2 ? -(row + 1) / 2 : row / 2), 1.2);
    }
}

static void place_receivers(int side, prt_rgb *totals, prt_vec3 *positions, prt_vec3 *normals) {
    int x, y;
    for (y = 0; y < side; y++) {
        for (x = 0; x < side; x++) {
            positions[y * side + x] = vec(14 * (2 * (x + 0.5) / side - 1), 10 * (2 * (y + 0.5) / side - 1), 0);
            normals[y * side + x] = vec(0, 0, 1);
            totals[y * side + x] = grey(3);
        }
    }
}

/* Seconds by crowd and form: the least of some rounds that go through all of them. */
static int time_crowds(lab *l, const fiv_baked *const *tables, int side, double best[CROWDS][FORMS], why *w) {
    size_t count = (size_t)side * (size_t)side;
    prt_rgb *totals = (prt_rgb *)malloc(2 * count * sizeof *totals);
    prt_vec3 *places = (prt_vec3 *)malloc(2 * count * sizeof *places);
    prt_fiv_occluder occluders[MOST_OCCLUDERS];
    int rounds = l->quick ? 1 : 5, round, k, form;
    progress p;
    cost_job c;
    if (!totals || !places) {
        free(totals);
        free(places);
        return why_set(w, "out of memory");
    }
    place_receivers(side, totals, places, places + count);
    progress_start(&p, "fiv_tables: table 2", rounds * CROWDS, 0, "scenes", 1);
    for (round = 0; round < rounds && !interrupted; round++) {
        for (k = 0; k < CROWDS && !interrupted; k++) {
            place_crowd(&crowds[k], tables, occluders);
            for (form = 0; form < FORMS; form++) {
                double seconds;
                c.receiver_count = (int)count;
                c.count = crowds[k].count;
                c.batched = form > 0;
                c.flags = form == 2 ? PRT_FIV_NO_OVERLAP : 0;
                c.occluders = occluders;
                c.totals = totals;
                c.positions = places;
                c.normals = places + count;
                c.out = totals + count;
                seconds = timed(run_cost, &c);
                if (round == 0 || seconds < best[k][form]) best[k][form] = seconds;
            }
            progress_show(&p, round * CROWDS + k + 1);
        }
    }
    progress_end(&p, rounds * CROWDS);
    free(totals);
    free(places);
    return interrupted ? why_set(w, "interrupted") : 0;
}

static void write_crowds(lab *l, const fiv_baked *const *tables, int side, double best[CROWDS][FORMS]) {
    double pixels = (double)side * side;
    int k;
    for (k = 0; k < CROWDS; k++) {
        const crowd *c = &crowds[k];
        double triangles = 0, bytes = 0;
        int j;
        for (j = 0; j < c->count; j++) triangles += l->shapes[c->tables[j % 2]].mesh.triangle_count;
        for (j = 0; j < 1 + (c->tables[0] != c->tables[1]); j++)
            bytes += (double)prt_bake_fiv_count(&tables[c->tables[j]]->desc) * sizeof(prt_fiv);
        fprintf(l->md, "| %s | %d | %.0f | %.2f | %.1f | %.1f | %.1f | %.2f | %.1f |\n", c->name, c->count, triangles,
                bytes / 1048576, best[k][0] / pixels * 1e9, best[k][1] / pixels * 1e9, best[k][2] / pixels * 1e9,
                best[k][1] / pixels * 1e9 / c->count, 1e9 / c->published / (512 * 512));
    }
}

/* The memory that a lookup touches: 8 samples of 36 bytes, at the cells that these receivers need, and nothing else. */
typedef struct touch_job { const prt_fiv *samples; const int *cells; int count, row, layer; double sum; } touch_job;

static void run_touch(void *user) {
    touch_job *t = (touch_job *)user;
    float sum[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 };
    int k, corner, c;
    for (k = 0; k < t->count; k++) {
        for (corner = 0; corner < 8; corner++) {
            const float *v = (const float *)(t->samples + t->cells[k] + (corner & 1) + (corner & 2) / 2 * t->row +
                                             (corner & 4) / 4 * t->layer);
            for (c = 0; c < 9; c++) sum[c] += v[c];
        }
    }
    for (c = 0; c < 9; c++) t->sum += (double)sum[c];
    BENCH_KEEP(&t->sum);
}

/* The lowest of the 8 samples around; the last column stands in for the wrap. */
static int cell_of(const fiv_baked *b, prt_vec3 to) {
    const prt_fiv_desc *d = &b->desc;
    double r = sqrt(vec_dot(to, to));
    double phi = atan2((double)to.y, (double)to.x) / (2 * pi);
    int i = (int)(acos((double)to.z / r) / pi * (d->theta_count - 1));
    int j = (int)((phi < 0 ? phi + 1 : phi) * d->phi_count), k = 0;
    while (k < d->rho_count - 2 && (double)d->rho[k + 1] <= r) k++;
    if (i > d->theta_count - 2) i = d->theta_count - 2;
    if (j > d->phi_count - 2) j = d->phi_count - 2;
    return (k * d->theta_count + i) * d->phi_count + j;
}

/* One occluder, receivers in the order of a picture (shuffled 0) or in random order: the cost of the lookup and
   shading, scalar and batched, and of reading the memory alone. */
typedef struct single_cost { double scalar, batched, touch; } single_cost;

static int time_single(lab *l, const fiv_baked *b, int shuffled, single_cost *best, why *w) {
    int side = l->quick ? 64 : 512, count = side * side, rounds = l->quick ? 1 : 9, k, round;
    prt_rgb *totals = (prt_rgb *)malloc(2 * (size_t)count * sizeof *totals);
    prt_vec3 *places = (prt_vec3 *)malloc(2 * (size_t)count * sizeof *places);
    int *cells = (int *)malloc((size_t)count * sizeof *cells);
    prt_fiv_occluder o;
    cost_job c;
    touch_job t;
    uint32_t state = 1;
    int failed = !totals || !places || !cells;
    if (!failed) {
        o.table = &b->table;
        o.position = vec(0.3, -0.2, 1.2);
        place_receivers(side, totals, places, places + count);
        for (k = 0; k < count; k++) {                      /* within the table's distances */
            places[k].x *= (prt_real)(3.5 / 14);
            places[k].y *= (prt_real)(3.5 / 10);
        }
        for (k = count - 1; k > 0 && shuffled; k--) {
            prt_vec3 swap = places[k];
            int other;
            state = state * 1664525u + 1013904223u;
            other = (int)((uint64_t)state * (uint64_t)(k + 1) >> 32);
            places[k] = places[other];
            places[other] = swap;
        }
        for (k = 0; k < count; k++)
            cells[k] = cell_of(b, vec((double)(o.position.x - places[k].x), (double)(o.position.y - places[k].y), 1.2));
        memset(&c, 0, sizeof c);
        c.receiver_count = count;
        c.count = 1;
        c.occluders = &o;
        c.totals = totals;
        c.positions = places;
        c.normals = places + count;
        c.out = totals + count;
        t.samples = b->samples;
        t.cells = cells;
        t.count = count;
        t.row = b->desc.phi_count;
        t.layer = b->desc.phi_count * b->desc.theta_count;
        t.sum = 0;
        for (round = 0; round < rounds; round++) {
            single_cost s;
            c.batched = 0;
            s.scalar = timed(run_cost, &c) / count * 1e9;
            c.batched = 1;
            s.batched = timed(run_cost, &c) / count * 1e9;
            s.touch = timed(run_touch, &t) / count * 1e9;
            if (round == 0 || s.scalar < best->scalar) best->scalar = s.scalar;
            if (round == 0 || s.batched < best->batched) best->batched = s.batched;
            if (round == 0 || s.touch < best->touch) best->touch = s.touch;
        }
    }
    free(totals);
    free(places);
    free(cells);
    return failed ? why_set(w, "out of memory") : 0;
}

static int write_singles(lab *l, why *w) {
    int k;
    fputs("One occluder and one receiver, the mean over 512 x 512 receivers around it, in the order of a picture or at"
          " random. Memory alone: the same 8 samples of 36 bytes read and summed, at cells known beforehand.\n\n"
          "| table | order | `prt_fiv_shade` ns | `prt_fiv_shade_n` ns | memory alone ns |\n|---|---|---:|---:|---:|\n",
          l->md);
    for (k = l->quick ? QUICK : FINEST; k < RATES || k == QUICK; k++) {
        const fiv_baked *b = table_for(l, BUNNY, FOREST, k, w);
        int shuffled;
        for (shuffled = 0; b && shuffled < 2; shuffled++) {
            single_cost s = { 0, 0, 0 };
            if (time_single(l, b, shuffled, &s, w)) return -1;
            fprintf(l->md, "| %dx%dx%d, %.2f MiB | %s | %.1f | %.1f | %.1f |\n", rates[k].phi, rates[k].theta,
                    rates[k].rho, (double)prt_bake_fiv_count(&b->desc) * sizeof(prt_fiv) / 1048576,
                    shuffled ? "random" : "picture",
                    s.scalar, s.batched, s.touch);
        }
        if (!b) return -1;
    }
    fputs("\n", l->md);
    return 0;
}

/* The same floating bunny with a table of each kind: looked up and shaded one by one, and batched. */
enum { KINDS = 4 };
typedef struct kinds_job { prt_fiv_body body; int count; const prt_rgb *totals; const prt_vec3 *positions, *normals;
                           prt_rgb *out; int batched; } kinds_job;

static void run_kind(void *user) {
    kinds_job *j = (kinds_job *)user;
    const prt_fiv_body *b = &j->body;
    int k;
    if (j->batched) {
        prt_fiv_shade_bodies_n(j->count, j->totals, j->positions, j->normals, 1, b, 0, j->out);
    } else {
        for (k = 0; k < j->count; k++) {
            prt_fiv_hidden h;
            h.to_centre = vec_add(b->position, -1, j->positions[k]);
            h.radius = 1;
            if (b->table) prt_fiv_lookup(b->table, h.to_centre, &h.fiv);
            else if (b->packed) prt_fiv_packed_lookup(b->packed, h.to_centre, &h.fiv);
            else prt_fiv_transfer_lookup(b->transfer, NULL, b->vectors, h.to_centre, &h.fiv);
            prt_fiv_shade_vectors(j->totals[k], j->normals[k], 1, &h, 0, j->out + k);
        }
    }
    BENCH_KEEP(j->out);
}

typedef struct kinds { prt_fiv_packed packed[2]; void *data[2]; prt_fiv *range; fiv_baked transfer; prt_real *vectors; } kinds;
enum { KIND_BANDS = 4 };

static int make_kinds(lab *l, const fiv_baked *plain, int r, kinds *m, why *w) {
    prt_real light[3 * PRT_SH_COUNT(KIND_BANDS)];
    size_t rows = (size_t)plain->desc.rho_count;
    fiv_bake_job job;
    memset(&job, 0, sizeof job);
    m->data[0] = malloc(prt_fiv_packed_size(&plain->table, 16));
    m->data[1] = malloc(prt_fiv_packed_size(&plain->table, 8));
    m->range = (prt_fiv *)malloc(2 * rows * sizeof *m->range);
    m->vectors = (prt_real *)malloc(9 * (size_t)PRT_SH_COUNT(KIND_BANDS + 1) * sizeof *m->vectors);
    if (!m->data[0] || !m->data[1] || !m->range || !m->vectors) return why_set(w, "out of memory");
    if (prt_fiv_pack(&plain->table, 16, m->data[0], NULL, NULL, &m->packed[0]) != PRT_OK ||
        prt_fiv_pack(&plain->table, 8, m->data[1], m->range, m->range + rows, &m->packed[1]) != PRT_OK)
        return why_set(w, "packing a table failed");
    job.shape = &l->shapes[BUNNY];
    job.light = &l->lights[FOREST];
    job.bands = KIND_BANDS;
    job.rays = 64;                                         /* only its cost counts here */
    job.grid.phi = rates[r].phi;
    job.grid.theta = rates[r].theta;
    job.grid.rho = rates[r].rho;
    job.grid.nearest = nearest;
    job.grid.farthest = farthest;
    job.threads = l->threads;
    job.stop = &interrupted;
    if (fiv_bake_run(&job, &m->transfer, w)) return -1;
    prt_sh_project_cubemap_rgb(KIND_BANDS, FACE, l->lights[FOREST].faces, light);
    prt_fiv_transfer_light(KIND_BANDS, NULL, light, m->vectors);
    return 0;
}

static void free_kinds(kinds *m) {
    free(m->data[0]);
    free(m->data[1]);
    free(m->range);
    free(m->vectors);
    fiv_baked_free(&m->transfer);
}

static int time_kinds(lab *l, const fiv_baked *plain, kinds *m, double best[KINDS][2], why *w) {
    int side = l->quick ? 64 : 256, count = side * side, rounds = l->quick ? 1 : 9, k, round, form;
    prt_rgb *totals = (prt_rgb *)malloc(2 * (size_t)count * sizeof *totals);
    prt_vec3 *places = (prt_vec3 *)malloc(2 * (size_t)count * sizeof *places);
    int failed = !totals || !places;
    if (!failed) place_receivers(side, totals, places, places + count);
    for (k = 0; k < count && !failed; k++) {               /* within the table's distances */
        places[k].x *= (prt_real)(3.0 / 14);
        places[k].y *= (prt_real)(3.0 / 10);
    }
    for (round = 0; round < rounds && !failed; round++)
        for (k = 0; k < KINDS; k++)
            for (form = 0; form < 2; form++) {
                kinds_job j;
                double ns;
                memset(&j, 0, sizeof j);
                j.count = count;
                j.totals = totals;
                j.positions = places;
                j.normals = places + count;
                j.out = totals + count;
                j.batched = form;
                j.body.position = vec(0.3, -0.2, 1.2);
                if (k == 0) j.body.table = &plain->table;
                else if (k < 3) j.body.packed = &m->packed[k - 1];
                else j.body.transfer = &m->transfer.transfer;
                j.body.vectors = m->vectors;
                ns = timed(run_kind, &j) / count * 1e9;
                if (round == 0 || ns < best[k][form]) best[k][form] = ns;
            }
    free(totals);
    free(places);
    return failed ? why_set(w, "out of memory") : 0;
}

static int write_kinds(lab *l, why *w) {
    static const char *const names[KINDS] = { "float", "16 bits", "8 bits", "transfer, 4 bands" };
    static const int bytes[KINDS] = { 36, 18, 9, 4 * PRT_SH_COUNT(KIND_BANDS + 1) };
    int r = l->quick ? QUICK : 2, k, failed;
    const fiv_baked *plain = table_for(l, BUNNY, FOREST, r, w);
    double best[KINDS][2];
    kinds m;
    if (!plain) return -1;
    memset(&m, 0, sizeof m);
    memset(best, 0, sizeof best);
    failed = make_kinds(l, plain, r, &m, w) || time_kinds(l, plain, &m, best, w);
    if (!failed) {
        fprintf(l->md, "The same by kind of table, %dx%dx%d: looked up and shaded one by one, and by"
                " `prt_fiv_shade_bodies_n`. One receiver at a time gains nothing from vectors, which hold a receiver"
                " a lane.\n\n| table | one by one ns | batched ns | bytes touched | MiB |\n|---|---:|---:|---:|---:|\n",
                rates[r].phi, rates[r].theta, rates[r].rho);
        for (k = 0; k < KINDS; k++)
            fprintf(l->md, "| %s | %.1f | %.1f | %d | %.2f |\n", names[k], best[k][0], best[k][1], 8 * bytes[k],
                    (double)prt_bake_fiv_count(&plain->desc) * bytes[k] / 1048576);
        fputs("\n", l->md);
    }
    free_kinds(&m);
    return failed ? -1 : 0;
}

static int write_costs(lab *l, why *w) {
    const fiv_baked *tables[SHAPES];
    double best[CROWDS][FORMS], each;
    int r = l->quick ? QUICK : USUAL, side = l->quick ? 64 : 512, k;
    for (k = 0; k < SHAPES; k++) if (!(tables[k] = table_for(l, k, FOREST, r, w))) return -1;
    if (time_crowds(l, tables, side, best, w)) return -1;
    fprintf(l->md, "## Table 2: time a pixel\n\n%d x %d receivers on the ground below the crowd, tables of %dx%dx%d,"
            " one thread. A mesh is not touched at run time: only its table is, so that triangles cannot matter. What"
            " the paper shows on a GeForce 8800 GTS, frames a second of 512 x 512 pixels, is given as ns a pixel.\n\n"
            "| scene | occluders | triangles | tables MiB | scalar ns | batched ns | without overlap ns |"
            " batched ns an occluder | paper ns (whole GPU) |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n", side,
            side, rates[r].phi, rates[r].theta, rates[r].rho);
    write_crowds(l, tables, side, best);
    each = (best[CROWDS - 1][1] - best[4][1]) / 50 / side / side * 1e9;
    fprintf(l->md, "\nFrom 10 to 60 occluders each costs %.1f ns more (%.1f without overlap). Ten occluders of %d, %d"
            " and, by turns, both triangles: %.0f, %.0f and %.0f ns a pixel.\n\n", each,
            (best[CROWDS - 1][2] - best[4][2]) / 50 / side / side * 1e9, l->shapes[BUNNY].mesh.triangle_count,
            l->shapes[HORSE].mesh.triangle_count, best[2][1] / side / side * 1e9, best[3][1] / side / side * 1e9,
            best[4][1] / side / side * 1e9);
    return write_singles(l, w) || write_kinds(l, w) ? -1 : 0;
}

/* ---- figures 12 to 17: error ---- */

typedef struct place { int shape; double x, y, z; } place;
typedef struct experiment {
    int        sheet;
    const char *figure, *what;
    int        light, rate, count;
    place      bodies[BODIES];
    unsigned   flags;
    const char *published;
} experiment;

enum { SHEETS = 4 };
static const char *const sheet_names[SHEETS] = { "fiv-rates", "fiv-lights", "fiv-overlap", "fiv-partial" };
static const char *const sheet_titles[SHEETS] = {
    "Figure 12: sampling rates", "Figures 13 and 14: lights", "Figures 15 and 16: several occluders",
    "Figure 17: occluders cut by the horizon"
};

/* Bounding spheres have radius 1. The bunny of figure 12 floats just clear of the ground. */
#define FLOATING { { BUNNY, 0, 0, 1.05 } }
#define ACROSS   { { BUNNY, -0.3, 0.3, 1.3 }, { HORSE, 0.9, -0.6, 2.1 } }
#define CLOSER   { { BUNNY, -0.3, 0.3, 1.05 }, { HORSE, 0.5, -0.3, 1.6 } }
#define SUNK     { { HORSE, 0, 0, 0.46 } }       /* a fifth of its height of 1.5 lies below the ground */
static const experiment experiments[] = {
    { 0, "12", "32x17x15",    LAMP, 4, 1, FLOATING, 0, ".023" },
    { 0, "12", "64x33x30",    LAMP, 2, 1, FLOATING, 0, ".008" },
    { 0, "12", "256x129x30",  LAMP, 0, 1, FLOATING, 0, ".007" },
    { 1, "13", "one directional light", SUN, 1, 1, FLOATING, 0, ".1" },
    { 1, "13", "two area lights", LAMPS, 1, 1, FLOATING, 0, ".035" },
    { 1, "13", "real environment", FOREST, 1, 1, FLOATING, 0, ".022" },
    { 1, "14", "green and red, one occluder", COLOURS, 1, 1, FLOATING, 0, ".019" },
    { 1, "14", "green and red, two occluders", COLOURS, 1, 2, ACROSS, 0, ".019" },
    { 2, "15", "overlap counted twice", FOREST, 1, 2, ACROSS, PRT_FIV_NO_OVERLAP, ".027" },
    { 2, "15", "corrected by equation 14", FOREST, 1, 2, ACROSS, 0, ".019" },
    { 2, "15", "corrected for what is filled", FOREST, 1, 2, ACROSS, PRT_FIV_FILLED_OVERLAP, ".019" },
    { 2, "16", "one area light, counted twice", LAMP, 1, 2, ACROSS, PRT_FIV_NO_OVERLAP, "" },
    { 2, "16", "one area light, equation 14", LAMP, 1, 2, ACROSS, 0, ".019" },
    { 2, "16", "one area light, filled", LAMP, 1, 2, ACROSS, PRT_FIV_FILLED_OVERLAP, ".019" },
    { 2, "16", "closer together, counted twice", FOREST, 1, 2, CLOSER, PRT_FIV_NO_OVERLAP, "" },
    { 2, "16", "closer together, equation 14", FOREST, 1, 2, CLOSER, 0, ".013" },
    { 2, "16", "closer together, filled", FOREST, 1, 2, CLOSER, PRT_FIV_FILLED_OVERLAP, ".013" },
    { 3, "17", "no treatment", FOREST, SUNKEN, 1, SUNK, FIV_NO_PARTIAL, ".026" },
    { 3, "17", "the paper's (d+R)/2R", FOREST, SUNKEN, 1, SUNK, PRT_FIV_PAPER_PARTIAL, ".019" },
    { 3, "17", "prt_fiv_shade", FOREST, SUNKEN, 1, SUNK, 0, "" }
};
enum { EXPERIMENTS = sizeof experiments / sizeof *experiments, FIGURE_12 = 0, FIGURE_13_FOREST = 5 };

typedef struct outcome {
    double  all, shadow, reference, worst;       /* NRMSE everywhere, in the shadow, of the truth; largest error */
    picture fiv, truth, open, view;              /* over the ground, and what the camera sees */
} outcome;

static void outcome_free(outcome *o) {
    picture_free(&o->fiv);
    picture_free(&o->truth);
    picture_free(&o->open);
    picture_free(&o->view);
}

/* A stage with its bodies, their tables, and what shading needs. */
typedef struct set {
    stage               stage;
    body                bodies[BODIES];
    const prt_fiv_table *tables[BODIES], *self[BODIES];
    fiv_receive         receive;
} set;

static int build_set(lab *l, const experiment *e, set *s, why *w) {
    const prt_vec3 up = vec(0, 0, 1);
    const cube_light *light = &l->lights[e->light];
    prt_fiv_env env;
    prt_result result;
    int r = l->quick ? QUICK : e->rate, k;
    memset(s, 0, sizeof *s);
    for (k = 0; k < e->count; k++) {
        const place *p = &e->bodies[k];
        const fiv_baked *table = table_for(l, p->shape, e->light, r, w), *self = NULL;
        if (!table || (!l->quick && !(self = table_for(l, p->shape, e->light, SELF, w)))) return -1;
        s->bodies[k].shape = &l->shapes[p->shape];
        s->bodies[k].position = vec(p->x, p->y, p->z);
        s->bodies[k].rotation[0] = s->bodies[k].rotation[4] = s->bodies[k].rotation[8] = 1;
        s->bodies[k].albedo = grey(0.7);
        s->tables[k] = &table->table;
        s->self[k] = self ? &self->table : NULL;
    }
    s->stage.body_count = e->count;
    s->stage.bodies = s->bodies;
    s->stage.ground_radius = 5;
    s->stage.ground_albedo = grey(0.7);
    fiv_env_of(light, &env);
    s->receive.stage = &s->stage;
    s->receive.tables = s->tables;
    s->receive.self = l->quick ? NULL : s->self;
    s->receive.flags = e->flags;
    s->receive.threads = l->threads;
    s->receive.stop = &interrupted;
    result = prt_bake_fiv_environment(&env, &s->receive.environment);
    if (result == PRT_OK) result = prt_bake_fiv_irradiance(&env, 1, &up, &s->receive.ground_total);
    if (result != PRT_OK) return why_set(w, "%s: %s", light_names[e->light], prt_result_string(result));
    return stage_create(&s->stage, w);
}

static double largest_difference(const picture *a, const picture *b) {
    size_t count = (size_t)a->width * (size_t)a->height, k;
    double worst = 0;
    int c;
    for (k = 0; k < 4 * count; k += 4) {
        for (c = 0; c < 3 && b->rgba[k + 3] > 0; c++) {
            double d = fabs((double)a->rgba[k + (size_t)c] - (double)b->rgba[k + (size_t)c]);
            if (d > worst) worst = d;
        }
    }
    return worst;
}

static void fill(picture *p, prt_rgb with) {
    size_t count = (size_t)p->width * (size_t)p->height, k;
    for (k = 0; k < 4 * count; k += 4) {
        p->rgba[k] = (float)with.r; p->rgba[k + 1] = (float)with.g; p->rgba[k + 2] = (float)with.b;
        p->rgba[k + 3] = 1;
    }
}

/* Experiments about the same things share their truth. */
static int same_scene(const experiment *a, const experiment *b) {
    return a->light == b->light && a->count == b->count && memcmp(a->bodies, b->bodies, sizeof a->bodies) == 0;
}

static int trace_truth(lab *l, const experiment *e, const set *s, const receivers *ground, outcome *o, why *w) {
    picture coarse;
    truth t;
    int failed;
    memset(&t, 0, sizeof t);
    t.stage = &s->stage;
    t.receivers = ground;
    t.threads = l->threads;
    t.stop = &interrupted;
    t.what = "fiv_tables: truth";
    t.light = &l->fine[e->light];
    t.halves[0] = &o->truth;
    if (picture_create(l->size, l->size, &coarse, w)) return -1;
    failed = truth_trace(&t, w);
    t.light = &l->coarse[e->light];
    t.halves[0] = &coarse;
    if (!failed) failed = truth_trace(&t, w);
    if (!failed) o->reference = picture_rms(&coarse, &o->truth, &o->truth, NULL) / picture_range(&o->truth);
    picture_free(&coarse);
    return failed;
}

/* The square around the occluders: vectors, truth, and how they differ. `last`, if not NULL, has the same truth. */
static int measure(lab *l, const experiment *e, set *s, const outcome *last, outcome *o, why *w) {
    size_t bytes = 4 * sizeof(float) * (size_t)l->size * (size_t)l->size;
    receivers ground;
    int failed;
    memset(&ground, 0, sizeof ground);
    failed = receivers_create(l->size, l->size, &ground, w) || receivers_on_ground(&s->stage, 3, &ground) ||
             picture_create(l->size, l->size, &o->fiv, w) || picture_create(l->size, l->size, &o->truth, w) ||
             picture_create(l->size, l->size, &o->open, w);
    s->receive.receivers = &ground;
    if (!failed) failed = fiv_receive_run(&s->receive, &o->fiv, w);
    if (!failed && last) {
        memcpy(o->truth.rgba, last->truth.rgba, bytes);
        o->reference = last->reference;
    } else if (!failed) {
        failed = trace_truth(l, e, s, &ground, o, w);
    }
    if (!failed) {
        double range = picture_range(&o->truth);
        fill(&o->open, s->receive.ground_total);
        o->all = picture_rms(&o->fiv, &o->truth, &o->truth, NULL) / range;
        o->shadow = picture_rms(&o->fiv, &o->truth, &o->truth, &o->open) / range;
        o->worst = largest_difference(&o->fiv, &o->truth) / range;
    }
    receivers_free(&ground);
    return failed ? -1 : 0;
}

enum { CELL = 300, VIEW = 216, SAMPLES = 2 };

/* What a camera sees, shaded from the vectors alone, shadows on the bodies included. */
static int look(lab *l, const experiment *e, set *s, outcome *o, why *w) {
    camera eye = camera_orbit(vec(0, 0, 0.55), 8, -2.2, 0.5, 0.5);
    receivers seen;
    int failed;
    memset(&seen, 0, sizeof seen);
    failed = receivers_create(CELL * SAMPLES, VIEW * SAMPLES, &seen, w) || receivers_look(&s->stage, &eye, &seen) ||
             picture_create(CELL * SAMPLES, VIEW * SAMPLES, &o->view, w);
    s->receive.receivers = &seen;
    if (!failed) failed = fiv_receive_run(&s->receive, &o->view, w);
    if (!failed) stage_expose(&s->stage, &seen, &l->lights[e->light], &o->view);
    receivers_free(&seen);
    return failed;
}

static int run_experiment(lab *l, int k, outcome *outcomes, why *w) {
    const experiment *e = &experiments[k];
    const outcome *last = k > 0 && same_scene(e, e - 1) ? &outcomes[k - 1] : NULL;
    set s;
    int failed = build_set(l, e, &s, w) || measure(l, e, &s, last, &outcomes[k], w) ||
                 (!l->quick && look(l, e, &s, &outcomes[k], w));
    stage_free(&s.stage);
    return failed ? -1 : 0;
}

/* ---- their pictures ---- */

static void centred(canvas *c, const text_font *font, double size, int x, int width, int y, int shade,
                    const char *line) {
    text_draw(c, font, size, x + 0.5 * (width - text_width(font, size, line)), y, shade, line);
}

static void put_cell(lab *l, canvas *c, const experiment *e, const outcome *o, int x, int y) {
    const double gain = 5, exposure = picture_exposure(&o->open);
    char line[160];
    canvas_put_picture(c, x, y, &o->view, SAMPLES, picture_exposure(&o->view));
    y += VIEW + 6;
    canvas_put_picture(c, x, y, &o->fiv, PLACES, exposure);
    canvas_put_picture(c, x + TRIO + 6, y, &o->truth, PLACES, exposure);
    canvas_put_difference(c, x + 2 * (TRIO + 6), y, &o->fiv, &o->truth, PLACES, picture_range(&o->truth), gain);
    centred(c, &l->regular, 13, x, TRIO, y + TRIO + 14, 165, "vectors");
    centred(c, &l->regular, 13, x + TRIO + 6, TRIO, y + TRIO + 14, 165, "ray traced");
    centred(c, &l->regular, 13, x + 2 * (TRIO + 6), TRIO, y + TRIO + 14, 165, "difference, 5 times");
    centred(c, &l->bold, 16, x, CELL, y + TRIO + 36, 235, e->what);
    if (*e->published) snprintf(line, sizeof line, "NRMSE %.4f   (paper %s)", o->all, e->published);
    else snprintf(line, sizeof line, "NRMSE %.4f", o->all);
    centred(c, &l->regular, 14, x, CELL, y + TRIO + 54, 200, line);
}

static int save_sheet(lab *l, int sheet, const outcome *outcomes, why *w) {
    enum { EDGE = 20, GAP = 14, HEAD = 52, HEIGHT = VIEW + 6 + TRIO + 64 };
    char path[1100];
    canvas c;
    int cells = 0, k, x = EDGE, failed;
    for (k = 0; k < EXPERIMENTS; k++) cells += experiments[k].sheet == sheet;
    if (canvas_create(2 * EDGE + cells * (CELL + GAP) - GAP, HEAD + HEIGHT + 8, &c, w)) return -1;
    memset(c.rgb, 26, 3 * (size_t)c.width * (size_t)c.height);
    text_draw(&c, &l->bold, 22, EDGE, 34, 245, sheet_titles[sheet]);
    for (k = 0; k < EXPERIMENTS; k++) {
        if (experiments[k].sheet != sheet) continue;
        put_cell(l, &c, &experiments[k], &outcomes[k], x, HEAD);
        x += CELL + GAP;
    }
    snprintf(path, sizeof path, "%s/gallery/%s.png", l->out, sheet_names[sheet]);
    failed = canvas_write_png(&c, path, w);
    if (!failed) printf("%s\n", path);
    canvas_free(&c);
    return failed;
}

static void write_outcomes(lab *l, const outcome *outcomes) {
    int k, sheet;
    fprintf(l->md, "## Figures 12 to 17: error\n\nNRMSE over %d x %d places on the ground, a square of side 6 about the"
            " occluders, whose bounding spheres have radius 1; tables from %g to %g radii in geometric steps. In the"
            " shadow: the same over those places alone that lack more than 1 %% of the open ground's light, divided by"
            " the same range. Places inside an object are left out. Figure 17's table begins at %g radii.\n\n"
            "| figure | set-up | light | NRMSE | paper | in the shadow | largest error | truth's own |\n"
            "|---|---|---|---:|---:|---:|---:|---:|\n", l->size, l->size, (double)nearest, (double)farthest,
            (double)sunken_nearest);
    for (k = 0; k < EXPERIMENTS; k++) {
        const experiment *e = &experiments[k];
        const outcome *o = &outcomes[k];
        fprintf(l->md, "| %s | %s | %s | %.4f | %s | %.4f | %.3f | %.4f |\n", e->figure, e->what, light_names[e->light],
                o->all, e->published, o->shadow, o->worst, o->reference);
    }
    fputs("\n", l->md);
    for (sheet = 0; sheet < SHEETS && !l->quick; sheet++)
        fprintf(l->md, "![%s](gallery/%s.png)\n\n", sheet_titles[sheet], sheet_names[sheet]);
}

/* ---- what limits a table, and what its storage buys ---- */

/* NRMSE over the ground of two pictures of the same places; the second gives the range. */
static double apart(const picture *a, const picture *b) { return picture_rms(a, b, b, NULL) / picture_range(b); }

static int shade_ground(lab *l, set *s, picture *out, why *w) {
    receivers ground;
    int failed;
    memset(&ground, 0, sizeof ground);
    failed = receivers_create(l->size, l->size, &ground, w) || receivers_on_ground(&s->stage, 3, &ground);
    s->receive.receivers = &ground;
    if (!failed) failed = fiv_receive_run(&s->receive, out, w);
    receivers_free(&ground);
    return failed;
}

/* A table packed and unpacked again. */
static int repack(const prt_fiv_table *from, int bits, prt_fiv *samples, double *bytes, why *w) {
    int count = from->theta_count * from->phi_count * from->rho_count;
    size_t size = prt_fiv_packed_size(from, bits), rows = (size_t)from->rho_count;
    void *data = malloc(size);
    prt_fiv *low = (prt_fiv *)malloc(2 * rows * sizeof *low);
    prt_fiv_packed packed;
    prt_result result = data && low ? PRT_OK : PRT_ERR_MEMORY;
    if (result == PRT_OK)
        result = prt_fiv_pack(from, bits, data, bits == 8 ? low : NULL, bits == 8 ? low + rows : NULL, &packed);
    if (result == PRT_OK) result = prt_fiv_unpack(&packed, 0, count, samples);
    *bytes = (double)size + (bits == 8 ? 2.0 * (double)rows * sizeof *low : 0);
    free(data);
    free(low);
    return result == PRT_OK ? 0 : why_set(w, "packing a table to %d bits: %s", bits, prt_result_string(result));
}

/* The floating bunny's shadow from some table, against a truth of the same places. */
static int shade_floating(lab *l, int light, const prt_fiv_table *table, const picture *traced, double *nrmse, why *w) {
    const experiment e = { 0, "", "", light, 0, 1, FLOATING, 0, "" };
    picture shaded;
    set s;
    int failed;
    memset(&shaded, 0, sizeof shaded);
    failed = build_set(l, &e, &s, w) || picture_create(l->size, l->size, &shaded, w);
    s.tables[0] = table;
    if (!failed) failed = shade_ground(l, &s, &shaded, w);
    if (!failed) *nrmse = apart(&shaded, traced);
    picture_free(&shaded);
    stage_free(&s.stage);
    return failed ? -1 : 0;
}

/* The coarsest table of figure 12 with more of one thing at a time. */
typedef struct finer { const char *what; int phi, theta, rho, rays; } finer;
static const finer finers[] = {
    { "32x17x15", 32, 17, 15, 0 },               { "16 times the rays", 32, 17, 15, 4096 },
    { "4 times the distances", 32, 17, 60, 0 },  { "twice the columns (phi)", 64, 17, 15, 0 },
    { "twice the rows (theta)", 32, 33, 15, 0 }, { "both", 64, 33, 15, 0 },
    { "4 times both", 128, 65, 15, 0 },          { "4 times both, twice the distances", 128, 65, 30, 0 }
};

static int write_finer(lab *l, const picture *traced, why *w) {
    int count = l->quick ? 2 : (int)(sizeof finers / sizeof *finers), k, failed = 0;
    fputs("What limits the coarsest table of figure 12: the same with more of one thing. It is the steps in direction,"
          " most of all from pole to pole, across the edge of a light's shadow; not rays, and distances little.\n\n"
          "| table | NRMSE |\n|---|---:|\n", l->md);
    for (k = 0; k < count && !failed; k++) {
        fiv_bake_job job;
        fiv_baked b;
        double nrmse = 0;
        memset(&job, 0, sizeof job);
        job.shape = &l->shapes[BUNNY];
        job.light = &l->lights[LAMP];
        job.grid.phi = finers[k].phi;
        job.grid.theta = finers[k].theta;
        job.grid.rho = finers[k].rho;
        job.grid.nearest = nearest;
        job.grid.farthest = farthest;
        job.rays = finers[k].rays;
        job.threads = l->threads;
        job.stop = &interrupted;
        failed = fiv_bake_run(&job, &b, w) || shade_floating(l, LAMP, &b.table, traced, &nrmse, w);
        if (!failed) fprintf(l->md, "| %s | %.4f |\n", finers[k].what, nrmse);
        fiv_baked_free(&b);
    }
    fputs("\n", l->md);
    return failed;
}

/* Error against bytes: one table in float and packed. Curves of a light: float, 16, 8 bits. */
static int trade_rate(lab *l, int light, int r, int at, const picture *traced, int curve, plot *p, why *w) {
    const fiv_baked *b = table_for(l, BUNNY, light, r, w);
    prt_fiv *samples = b ? (prt_fiv *)malloc((size_t)prt_bake_fiv_count(&b->desc) * sizeof *samples) : NULL;
    int form, failed = !samples;
    for (form = 0; form < 3 && !failed; form++) {
        prt_fiv_table table = b->table;
        double bytes = (double)prt_bake_fiv_count(&b->desc) * sizeof *samples, nrmse = 0;
        if (form) {
            failed = repack(&b->table, form == 1 ? 16 : 8, samples, &bytes, w);
            table.samples = samples;
        }
        if (!failed) failed = shade_floating(l, light, &table, traced, &nrmse, w);
        p->x[curve + form][at] = bytes / 1024;
        p->y[curve + form][at] = nrmse;
    }
    free(samples);
    return failed ? -1 : 0;
}

/* truths: of one area light and of the real environment. */
static int write_trade(lab *l, const picture *const truths[2], why *w) {
    static const int light[2] = { LAMP, FOREST };
    static const char *const forms[3] = { "float", "16 bits", "8 bits" };
    static plot p;
    char path[1100];
    int k, i, first = l->quick ? QUICK : 0, count = l->quick ? 1 : RATES;
    memset(&p, 0, sizeof p);
    p.title = "The shadow of a bunny: error against the size of its table";
    p.across = "KiB";
    p.up = "NRMSE";
    p.more = "set logscale xy\nset key outside bottom center horizontal maxcols 3";
    p.series = 6;
    p.places = count;
    p.names[0] = "area light, float";   p.names[1] = "area light, 16 bits";   p.names[2] = "area light, 8 bits";
    p.names[3] = "forest.hdr, float";   p.names[4] = "forest.hdr, 16 bits";   p.names[5] = "forest.hdr, 8 bits";
    for (k = 0; k < 2; k++)
        for (i = 0; i < count; i++) if (trade_rate(l, light[k], first + i, i, truths[k], 3 * k, &p, w)) return -1;
    fputs("## Error against storage\n\n", l->md);
    if (!l->quick) {
        snprintf(path, sizeof path, "%s/plots/fiv-storage.svg", l->out);
        if (plot_draw(&p, path, w)) return -1;
        printf("%s\n", path);
        fputs("![NRMSE by bytes of the table](plots/fiv-storage.svg)\n\n", l->md);
    }
    fputs("The floating bunny of figures 12 and 13, all grids, in float and packed: at 8 bits a table of the next finer"
          " grid takes no more memory and errs less.\n\n| grid | bits | KiB | one area light | forest.hdr |\n"
          "|---|---|---:|---:|---:|\n", l->md);
    for (i = 0; i < count; i++)
        for (k = 0; k < 3; k++)
            fprintf(l->md, "| %dx%dx%d | %s | %.0f | %.4f | %.4f |\n", rates[first + i].phi, rates[first + i].theta,
                    rates[first + i].rho, forms[k], p.x[k][i], p.y[k][i], p.y[3 + k][i]);
    fputs("\n", l->md);
    return 0;
}

static int write_figures(lab *l, why *w) {
    outcome outcomes[EXPERIMENTS];
    int k, failed = 0;
    memset(outcomes, 0, sizeof outcomes);
    const picture *truths[2];
    for (k = 0; k < EXPERIMENTS && !failed; k++) failed = run_experiment(l, k, outcomes, w);
    if (!failed) write_outcomes(l, outcomes);
    truths[0] = &outcomes[FIGURE_12].truth;
    truths[1] = &outcomes[FIGURE_13_FOREST].truth;
    if (!failed) failed = write_finer(l, truths[0], w) || write_trade(l, truths, w);
    for (k = 0; k < SHEETS && !failed && !l->quick; k++) failed = save_sheet(l, k, outcomes, w);
    for (k = 0; k < EXPERIMENTS; k++) outcome_free(&outcomes[k]);
    return failed;
}

/* ---- beyond the paper: the transfer form, packed tables ---- */

enum { FORM_RATE = 2 };                                    /* 64x33x30 */

static int bake_form(lab *l, const shape *from, int bands, fiv_baked *b, why *w) {
    int r = l->quick ? QUICK : FORM_RATE;
    char what[100];
    fiv_bake_job job;
    memset(&job, 0, sizeof job);
    job.shape = from;
    job.light = &l->lights[FOREST];
    job.bands = bands;
    job.rays = l->quick ? 64 : 0;
    job.grid.phi = rates[r].phi;
    job.grid.theta = rates[r].theta;
    job.grid.rho = rates[r].rho;
    job.grid.nearest = nearest;
    job.grid.farthest = farthest;
    job.keep = l->keep;
    job.threads = l->threads;
    job.stop = &interrupted;
    if (bands) snprintf(what, sizeof what, "fiv_tables: %s, %d bands", from->name, bands);
    else snprintf(what, sizeof what, "fiv_tables: %s, turned", from->name);
    job.what = what;
    return fiv_bake_run(&job, b, w);
}

/* A row: the turned body from a table for any light of so many bands. */
static int write_bands(lab *l, set *s, int bands, const picture *traced, const picture *fresh, picture *shaded,
                       why *w) {
    prt_real *light = (prt_real *)malloc(3 * (size_t)PRT_SH_COUNT(bands) * sizeof *light);
    prt_fiv_table table;
    fiv_baked b;
    prt_fiv *samples = NULL;
    double seconds;
    int failed = !light;
    memset(&b, 0, sizeof b);
    if (!failed) failed = bake_form(l, &l->shapes[BUNNY], bands, &b, w);
    if (!failed) samples = (prt_fiv *)malloc((size_t)prt_bake_fiv_count(&b.desc) * sizeof *samples);
    failed |= !samples;
    if (!failed) {
        prt_sh_project_cubemap_rgb(bands, FACE, l->lights[FOREST].faces, light);
        seconds = processor_seconds();
        failed = fiv_baked_light(&b, light, s->bodies[0].rotation, samples, w);
        seconds = processor_seconds() - seconds;
        table = prt_fiv_table_of(&b.desc, samples, NULL);
        s->tables[0] = &table;
        if (!failed) failed = shade_ground(l, s, shaded, w);
        if (!failed)
            fprintf(l->md, "| %d bands, turned | %.4f | %.4f | %.1f | %.1f | %.2f |\n", bands, apart(shaded, traced),
                    apart(shaded, fresh), b.processor, 1000 * seconds,
                    (double)prt_bake_fiv_count(&b.desc) * PRT_SH_COUNT(bands + 1) * sizeof(prt_real) / 1048576);
    }
    free(light);
    free(samples);
    fiv_baked_free(&b);
    return failed ? -1 : 0;
}

/* A bunny turned by 70 degrees about a slanting axis: its shadow by a fresh bake of the turned mesh, and by the table
   of the mesh as it was, turned at run time. */
static int write_transfer(lab *l, why *w) {
    static const int bands[] = { 2, 4, 6, 8 };
    static const experiment e = { 0, "", "", FOREST, FORM_RATE, 1, FLOATING, 0, "" };
    outcome o;
    picture shaded;
    shape turned;
    fiv_baked fresh;
    prt_real rotation[9];
    set s;
    size_t k;
    int failed;
    memset(&o, 0, sizeof o);
    memset(&shaded, 0, sizeof shaded);
    memset(&turned, 0, sizeof turned);
    memset(&fresh, 0, sizeof fresh);
    rotation_about(vec_unit(vec(1, 0.5, 0.3), vec(1, 0, 0)), 70 * pi / 180, rotation);
    fputs("## Beyond the paper: the transfer form, for occluders that turn and lights that change\n\n"
          "The paper's tables hold one environment, and its occluders cannot turn (its section 6)."
          " `prt_bake_fiv_transfer` keeps for each place what is hidden, in spherical harmonics, not the light of"
          " it; every light of so many bands, turned in any way, then gives a table without a ray. A bunny turned by 70"
          " degrees about (1, .5, .3) under forest.hdr, tables of 64x33x30; a fresh bake of the turned mesh sees"
          " all frequencies.\n\n"
          "| table | NRMSE to the truth | to the fresh bake | bake, processor s | new light, ms | MiB |\n"
          "|---|---:|---:|---:|---:|---:|\n", l->md);
    failed = build_set(l, &e, &s, w) || picture_create(l->size, l->size, &shaded, w) ||
             shape_turned(&l->shapes[BUNNY], rotation, &turned, w) || bake_form(l, &turned, 0, &fresh, w);
    if (!failed) {
        memcpy(s.bodies[0].rotation, rotation, sizeof rotation);
        failed = stage_move(&s.stage, w) || measure(l, &e, &s, NULL, &o, w);   /* with the table of the wrong pose */
    }
    if (!failed) {
        prt_real upright[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
        memcpy(s.bodies[0].rotation, upright, sizeof upright);     /* the fresh table is in the world's frame */
        s.tables[0] = &fresh.table;
        failed = shade_ground(l, &s, &o.fiv, w);
        memcpy(s.bodies[0].rotation, rotation, sizeof rotation);
    }
    if (!failed)
        fprintf(l->md, "| fresh bake | %.4f | | %.1f | | %.2f |\n", apart(&o.fiv, &o.truth), fresh.processor,
                (double)prt_bake_fiv_count(&fresh.desc) * sizeof(prt_fiv) / 1048576);
    for (k = 0; k < (l->quick ? 2 : sizeof bands / sizeof *bands) && !failed; k++)
        failed = write_bands(l, &s, bands[k], &o.truth, &o.fiv, &shaded, w);
    fputs("\n", l->md);
    outcome_free(&o);
    picture_free(&shaded);
    fiv_baked_free(&fresh);
    stage_free(&s.stage);
    shape_free(&turned);
    return failed ? -1 : 0;
}

static int write_packed_row(lab *l, int light, why *w) {
    const experiment e = { 0, "", "", light, USUAL, 1, FLOATING, 0, "" };
    int r = l->quick ? QUICK : USUAL, bits, failed;
    const fiv_baked *plain = table_for(l, BUNNY, light, r, w);
    prt_fiv *samples = plain ? (prt_fiv *)malloc((size_t)prt_bake_fiv_count(&plain->desc) * sizeof *samples) : NULL;
    picture whole, shaded;
    set s;
    if (!plain || !samples) return plain ? why_set(w, "out of memory") : -1;
    memset(&whole, 0, sizeof whole);
    memset(&shaded, 0, sizeof shaded);
    failed = build_set(l, &e, &s, w) || picture_create(l->size, l->size, &whole, w) ||
             picture_create(l->size, l->size, &shaded, w) || shade_ground(l, &s, &whole, w);
    for (bits = 16; bits >= 8 && !failed; bits -= 8) {
        prt_fiv_table table = plain->table;
        double bytes = 0;
        table.samples = samples;
        failed = repack(&plain->table, bits, samples, &bytes, w);
        s.tables[0] = &table;
        if (!failed) failed = shade_ground(l, &s, &shaded, w);
        if (!failed)
            fprintf(l->md, "| %s | %d | %.2e | %.2e | %.2f |\n", light_names[light], bits, apart(&shaded, &whole),
                    largest_difference(&shaded, &whole) / picture_range(&whole), bytes / 1048576);
    }
    free(samples);
    picture_free(&whole);
    picture_free(&shaded);
    stage_free(&s.stage);
    return failed ? -1 : 0;
}

static int write_packed(lab *l, why *w) {
    int r = l->quick ? QUICK : USUAL, light;
    fprintf(l->md, "## Packed tables\n\nThe floating bunny's shadow from a table of %dx%dx%d vectors packed"
            " (`prt_fiv_pack`), against the same table in float, as part of the range.\n\n"
            "| light | bits | NRMSE | largest | MiB |\n|---|---:|---:|---:|---:|\n", rates[r].phi, rates[r].theta,
            rates[r].rho);
    for (light = 0; light < LIGHTS; light++) if (write_packed_row(l, light, w)) return -1;
    fputs("\n", l->md);
    return 0;
}

/* ---- the program ---- */

static int write_page(lab *l, why *w) {
    char path[1100], gallery[1100], plots[1100];
    replacement page;
    snprintf(path, sizeof path, "%s/fiv.md", l->out);
    snprintf(gallery, sizeof gallery, "%s/gallery", l->out);
    snprintf(plots, sizeof plots, "%s/plots", l->out);
    if (make_directory(l->out, w) || make_directory(gallery, w) || make_directory(plots, w) || (l->keep && make_directory(l->keep, w))) return -1;
    if (text_font_load(0, &l->regular, w) || text_font_load(1, &l->bold, w)) return -1;
    if (make_lights(l, w) || load_shapes(l, w) || replacement_open(path, &page, w)) return -1;
    l->md = page.file;
    fprintf(l->md, "# Fullsphere irradiance vectors: the paper's experiments again\n\n"
            "Written by `examples/fiv_tables.c` (`make fiv`) on %s, %s, %s, float. Rays: Embree 3. What the figures say"
            " of the paper's claims stands in [papers.md](papers.md); the formulas in [math.md](math.md).\n\n"
            "![An animation: vectors, ray traced, difference](gallery/fiv-scene.webp)\n\n", bench_cpu_name(),
            EXAMPLE_COMPILER, EXAMPLE_FLAGS);
    if (write_bakes(l, w) || write_figures(l, w) || write_costs(l, w) || write_transfer(l, w) || write_packed(l, w)) {
        replacement_abandon(&page);
        return -1;
    }
    if (replacement_commit(&page, w)) return -1;
    printf("%s\n", path);
    return 0;
}

static int parse(int count, char **words, lab *l, why *w) {
    int i;
    l->meshes[BUNNY] = "/usr/share/glmark2/models/bunny.obj";
    l->meshes[HORSE] = "/usr/share/glmark2/models/horse.3ds";
    l->out = "out";
    l->threads = processor_count();
    l->size = TRIO * PLACES;
    for (i = 1; i < count; i++) {
        const char *word = words[i], *value = i + 1 < count ? words[i + 1] : NULL;
        if (strcmp(word, "--quick") == 0) { l->quick = 1; l->size = 24; }
        else if (strcmp(word, "--out") == 0 && value) { l->out = value; i++; }
        else if (strcmp(word, "--keep") == 0 && value) { l->keep = value; i++; }
        else if (strcmp(word, "--meshes") == 0 && i + 2 < count) {
            l->meshes[BUNNY] = value;
            l->meshes[HORSE] = words[i += 2];
        }
        else if (strcmp(word, "--threads") == 0 && value) { l->threads = atoi(value); i++; }
        else return why_set(w, "%s: not understood. usage: fiv_tables [--quick] [--out DIR] [--keep DIR]"
                            " [--meshes FILE FILE] [--threads N]", word);
    }
    return l->threads >= 1 && l->threads <= 256 ? 0 : why_set(w, "--threads: must be a whole number from 1 to 256");
}

int main(int count, char **words) {
    static lab l;
    why w;
    int failed;
    w.line[0] = 0;
    stop_on(SIGINT);
    stop_on(SIGTERM);
    failed = parse(count, words, &l, &w) || write_page(&l, &w);
    if (failed) fprintf(stderr, "fiv_tables: %s\n", w.line);
    lab_free(&l);
    return failed ? interrupted ? STOPPED : 1 : 0;
}
