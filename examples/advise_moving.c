/* advise, a moving occluder: another mesh, half the size of the scene, that stands at eight places around it in turn.
   Transfer of the scene alone leaves its shadow out; irradiance vectors take it away from what transfer gives. */
#define _POSIX_C_SOURCE 200809L
#include "advise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fiv_bake.h"
#include "vector.h"

enum { GRIDS = 3, PACKED_WAYS = 3, FACE = 32, BATCH = 4096, TIMED = 2048, FIV_RAYS = 64 };
static const stored ways[PACKED_WAYS] = { STORED_FLOAT, STORED_HALF, STORED_8 };
static const int grids[GRIDS][3] = { { 5, 8, 4 }, { 9, 16, 8 }, { 17, 32, 12 } };
static const prt_real radius = (prt_real)0.5, nearest = (prt_real)1.05, farthest = 8;

typedef struct packed_table { prt_fiv_packed packed; void *data; prt_fiv *low, *step; } packed_table;

struct moving {
    shape        body;
    cube_light   light;
    fiv_baked    tables[GRIDS];
    packed_table packed[GRIDS][PACKED_WAYS];
};

/* Vertex k of a choice meets it at one of eight places, all around and above. */
static prt_vec3 place_of(int k) {
    double z = 0.1 + 0.8 * (k % 8) / 7, angle = 2.4 * (k % 8), r = sqrt(1 - z * z);
    return vec(1.7 * r * cos(angle), 1.7 * r * sin(angle), 1.7 * z);
}

int moving_blocks(const advisor *a, int k, int count, const prt_ray *rays, unsigned char *blocked) {
    const prt_tracer *t = &a->moving->body.tracer.tracer;
    prt_vec3 place = place_of(k);
    prt_ray shifted[BATCH];
    unsigned char also[BATCH];
    int i;
    if (count < 1) return 0;
    if (count > BATCH) return -1;
    for (i = 0; i < count; i++) {
        shifted[i] = rays[i];
        shifted[i].origin = vec_add(rays[i].origin, -1, place);
        also[i] = 0;
    }
    if (t->occluded(t->user, count, shifted, also)) return -1;
    for (i = 0; i < count; i++) blocked[i] |= also[i];
    return 0;
}

static int pack_table(const prt_fiv_table *t, stored way, packed_table *p, why *w) {
    prt_result r;
    memset(p, 0, sizeof *p);
    if (way == STORED_FLOAT) return 0;
    p->data = malloc(prt_fiv_packed_size(t, stored_bits[way]));
    p->low = (prt_fiv *)malloc((size_t)t->rho_count * sizeof *p->low);
    p->step = (prt_fiv *)malloc((size_t)t->rho_count * sizeof *p->step);
    if (!p->data || !p->low || !p->step) return why_set(w, "out of memory");
    r = prt_fiv_pack(t, stored_bits[way], p->data, p->low, p->step, &p->packed);
    return r == PRT_OK ? 0 : why_set(w, "irradiance vectors cannot be packed: %s", prt_result_string(r));
}

int moving_create(advisor *a, why *w) {
    struct moving *m = (struct moving *)calloc(1, sizeof *m);
    int g, k;
    if (!m) return why_set(w, "out of memory");
    a->moving = m;
    if (shape_load(a->o.moving, radius, NULL, &m->body, w) ||
        cube_light_from_image(&a->environment.map, FACE, &m->light, w))
        return -1;
    for (g = 0; g < GRIDS; g++) {
        fiv_bake_job job;
        memset(&job, 0, sizeof job);
        job.shape = &m->body;
        job.light = &m->light;
        job.grid.theta = grids[g][0];
        job.grid.phi = grids[g][1];
        job.grid.rho = grids[g][2];
        job.grid.nearest = nearest;
        job.grid.farthest = farthest;
        job.rays = FIV_RAYS;
        job.threads = a->o.threads;
        job.what = "advise: irradiance vectors";
        job.stop = &interrupted;
        if (fiv_bake_run(&job, &m->tables[g], w)) return -1;
        for (k = 0; k < PACKED_WAYS; k++) if (pack_table(&m->tables[g].table, ways[k], &m->packed[g][k], w)) return -1;
    }
    printf("%s moves: radius %.2g of the scene's, at 8 places 1.7 radii from its middle\n", a->o.moving,
           (double)radius);
    return 0;
}

void moving_free(advisor *a) {
    struct moving *m = a->moving;
    int g, k;
    if (!m) return;
    for (g = 0; g < GRIDS; g++) {
        for (k = 0; k < PACKED_WAYS; k++) {
            free(m->packed[g][k].data);
            free(m->packed[g][k].low);
            free(m->packed[g][k].step);
        }
        fiv_baked_free(&m->tables[g]);
    }
    cube_light_free(&m->light);
    shape_free(&m->body);
    free(m);
    a->moving = NULL;
}

/* ---- as a way to shade ---- */

typedef struct taking { const advisor *a; const trial *t; int count; const prt_point *points; prt_rgb *colors; } taking;

/* Irradiance is pi times exit radiance: what the occluder hides is taken off it. */
static void take_shadow(void *user) {
    taking *s = (taking *)user;
    const struct moving *m = s->a->moving;
    int k, way = s->t->table == STORED_FLOAT ? 0 : s->t->table == STORED_HALF ? 1 : 2;
    for (k = 0; k < s->count; k++) {
        prt_fiv_hidden hidden;
        prt_rgb irradiance;
        hidden.to_centre = vec_add(place_of(k), -1, s->points[k].position);
        hidden.radius = radius;
        if (way == 0) prt_fiv_lookup(&m->tables[s->t->grid].table, hidden.to_centre, &hidden.fiv);
        else prt_fiv_packed_lookup(&m->packed[s->t->grid][way].packed, hidden.to_centre, &hidden.fiv);
        prt_fiv_shade_vectors(rgb_scale(s->colors[k], pi), s->points[k].normal, 1, &hidden, 0, &irradiance);
        s->colors[k] = rgb_scale(irradiance, 1 / pi);
    }
}

void moving_take(const advisor *a, const checked *c, const trial *t, prt_rgb *colors) {
    taking s;
    s.a = a;
    s.t = t;
    s.count = c->count;
    s.points = c->points;
    s.colors = colors;
    take_shadow(&s);
}

static double time_of_table(const advisor *a, const checked *c, const trial *t, prt_rgb *colors) {
    taking s;
    s.a = a;
    s.t = t;
    s.count = c->count < TIMED ? c->count : TIMED;
    s.points = c->points;
    s.colors = colors;
    return time_of(take_shadow, &s) / s.count * 1e9;
}

/* Every transfer without window that is among the trials, in floats or bytes, once more with every table. */
int try_moving(advisor *a, const checked *c, const prt_real *const *transfer, const int *rays, int steps, why *w) {
    prt_rgb *base = (prt_rgb *)malloc((size_t)c->count * sizeof *base);
    prt_rgb *colors = (prt_rgb *)malloc((size_t)c->count * sizeof *colors);
    double ns[GRIDS][PACKED_WAYS] = { { 0 } };
    int k, g, way, step, count = a->trial_count, failed = base && colors ? 0 : why_set(w, "out of memory");
    for (k = 0; k < count && !failed && !interrupted; k++) {
        trial t = a->trials[k];
        if (t.method != METHOD_SH || t.window != PRT_WINDOW_NONE || (t.stored != STORED_FLOAT && t.stored != STORED_8))
            continue;
        for (step = 0; step < steps && rays[step] != t.rays; step++) continue;
        failed = scene_colors(a, c, transfer[step], &t, base, w);
        t.method = METHOD_FIV;
        t.predicted = -1;
        for (g = 0; g < GRIDS && !failed; g++)
            for (way = 0; way < PACKED_WAYS; way++) {
                trial with = t;
                with.grid = g;
                with.table = ways[way];
                with.kilobytes = grids[g][0] * grids[g][1] * grids[g][2] * 9 * stored_bits[ways[way]] / 8.0 / 1024;
                memcpy(colors, base, (size_t)c->count * sizeof *base);
                if (ns[g][way] <= 0) ns[g][way] = time_of_table(a, c, &with, colors);
                memcpy(colors, base, (size_t)c->count * sizeof *base);
                moving_take(a, c, &with, colors);
                with.ns += ns[g][way];
                trial_judge(&with, &c->truth, colors);
                advisor_keep(a, &with);
            }
    }
    free(base);
    free(colors);
    return failed;
}

void moving_describe(const trial *t, char *text, size_t size) {
    snprintf(text, size, "vectors of %d x %d x %d places, %s, %.0f KB", grids[t->grid][0], grids[t->grid][1],
             grids[t->grid][2], stored_names[t->table], t->kilobytes);
}
