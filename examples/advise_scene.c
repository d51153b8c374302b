/* advise, the ways to light a scene: measures light, transfer and visibility, and tries irradiance of the normal,
   ambient occlusion and transfer vectors against ray-traced truth. */
#define _POSIX_C_SOURCE 200809L
#include "advise.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_job.h"
#include "parallel.h"
#include "progress.h"
#include "vector.h"

enum { TRUTH_RAYS = 2048, LIGHT_COUNT = PRT_SH_COUNT(LIGHT_BANDS), MOST_COUNT = PRT_SH_COUNT(MOST_BANDS) };
enum { LADDER = 4, TIMED = 2048, PRINTED = 10, BAND_COUNTS = 13 };
static const int band_counts[BAND_COUNTS] = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16 };
static const int ladder[LADDER] = { 64, 256, 1024, 4096 };

/* ---- truth ---- */

typedef struct truth_rays {
    prt_vec3      cosine[TRUTH_RAYS], light[TRUTH_RAYS];
    size_t        texel[TRUTH_RAYS];
    prt_real      u[TRUTH_RAYS], v[TRUTH_RAYS];
    prt_ray       rays[TRUTH_RAYS];
    unsigned char blocked[TRUTH_RAYS];
} truth_rays;

typedef struct truth_job { advisor *a; checked *c; } truth_job;

static int begin_truth(void *user, void **own) {
    (void)user;
    *own = malloc(sizeof(truth_rays));
    return *own ? 0 : -1;
}

static int trace(const advisor *a, const prt_point *p, int at, int count, const prt_vec3 *dirs, truth_rays *s) {
    int k;
    for (k = 0; k < count; k++) {
        s->rays[k].origin = vec_add(p->position, advise_bias, p->normal);
        s->rays[k].dir = dirs[k];
        s->rays[k].tmin = 0;
        s->rays[k].tmax = (prt_real)1e6;
        s->blocked[k] = 0;
    }
    return a->tracer.tracer.occluded(a->tracer.tracer.user, count, s->rays, s->blocked) ||
           (a->moving && moving_blocks(a, at, count, s->rays, s->blocked));
}

/* Rays by cosine and rays by light together, as environment_add weighs them. */
static int trace_half(const advisor *a, const checked *c, int k, int half, truth_rays *s) {
    const prt_point *p = &c->points[k];
    uint64_t seed = c->seed * 8 + (uint64_t)half, index = (uint64_t)c->vertex[k];
    double *sum = c->truth.half[half][k];
    int i, above = 0;
    if (a->lights) return lights_trace(a, p, sum);         /* exact, both times */
    prt_sample_directions(TRUTH_RAYS, seed, index, p->normal, 0, TRUTH_RAYS, s->cosine);
    if (trace(a, p, k, TRUTH_RAYS, s->cosine, s)) return -1;
    sum[0] = sum[1] = sum[2] = 0;
    for (i = 0; i < TRUTH_RAYS; i++)
        if (!s->blocked[i])
            environment_add(&a->environment, environment_texel(&a->environment, s->cosine[i]),
                            vec_dot(s->cosine[i], p->normal), TRUTH_RAYS, TRUTH_RAYS, sum);
    prt_sample_square(PRT_SAMPLE_SOBOL, TRUTH_RAYS, seed + 2, index, 0, TRUTH_RAYS, s->u, s->v);
    for (i = 0; i < TRUTH_RAYS; i++) {
        s->light[above] = environment_sample(&a->environment, (double)s->u[i], (double)s->v[i], &s->texel[above]);
        above += vec_dot(s->light[above], p->normal) > 0;
    }
    if (trace(a, p, k, above, s->light, s)) return -1;
    for (i = 0; i < above; i++)
        if (!s->blocked[i])
            environment_add(&a->environment, s->texel[i], vec_dot(s->light[i], p->normal), TRUTH_RAYS, TRUTH_RAYS, sum);
    return 0;
}

static int trace_vertices(void *user, void *own, int first, int count) {
    truth_job *job = (truth_job *)user;
    int k, half;
    for (k = first; k < first + count; k++)
        for (half = 0; half < HALVES; half++)
            if (trace_half(job->a, job->c, k, half, (truth_rays *)own)) return -1;
    return 0;
}

/* `count` different numbers below `of`, at random. */
static int choose(int count, int of, uint64_t seed, int *chosen, why *w) {
    int *deck = (int *)malloc((size_t)of * sizeof *deck), k;
    if (!deck) return why_set(w, "out of memory");
    for (k = 0; k < of; k++) deck[k] = k;
    for (k = 0; k < count; k++) {
        prt_real u, v;
        int other;
        prt_sample_square(PRT_SAMPLE_RANDOM, count, seed, 0, k, 1, &u, &v);
        other = k + (int)((double)u * (of - k));
        chosen[k] = deck[other];
        deck[other] = deck[k];
    }
    free(deck);
    return 0;
}

void checked_free(checked *c) {
    int half;
    free(c->vertex);
    free(c->points);
    for (half = 0; half < HALVES; half++) free(c->truth.half[half]);
    memset(c, 0, sizeof *c);
}

int checked_choose(advisor *a, int count, uint64_t seed, const char *what, checked *c, why *w) {
    truth_job job;
    parallel p;
    int k, half;
    memset(c, 0, sizeof *c);
    c->count = c->truth.count = count < a->mesh.point_count ? count : a->mesh.point_count;
    c->seed = seed;
    c->vertex = (int *)malloc((size_t)c->count * sizeof *c->vertex);
    c->points = (prt_point *)malloc((size_t)c->count * sizeof *c->points);
    for (half = 0; half < HALVES; half++)
        c->truth.half[half] = (double (*)[3])malloc((size_t)c->count * sizeof *c->truth.half[half]);
    if (!c->vertex || !c->points || !c->truth.half[0] || !c->truth.half[1]) return why_set(w, "out of memory");
    if (choose(c->count, a->mesh.point_count, seed, c->vertex, w)) return -1;
    for (k = 0; k < c->count; k++) c->points[k] = a->mesh.points[c->vertex[k]];
    job.a = a;
    job.c = c;
    memset(&p, 0, sizeof p);
    p.count = c->count;
    p.chunk = 8;
    p.threads = a->o.threads;
    p.what = what;
    p.unit = "rays";
    p.unit_per_item = HALVES * (a->lights ? a->o.lights : 2 * TRUTH_RAYS);
    p.stop = &interrupted;
    p.begin = begin_truth;
    p.work = trace_vertices;
    p.end = free;
    p.user = &job;
    if (parallel_run(&p, w)) return -1;
    if (p.done < c->count) return why_set(w, "interrupted before anything could be compared");
    for (k = 0; k < c->count; k++)
        for (half = 0; half < HALVES; half++)
            c->truth.mean += (c->truth.half[half][k][0] + c->truth.half[half][k][1] + c->truth.half[half][k][2]) /
                             (3 * HALVES * c->count);
    if (!(c->truth.mean > 0)) return why_set(w, "%s: no light reaches the checked vertices", a->o.environment);
    return 0;
}

/* ---- what is tried ---- */

static int bake(const advisor *a, const checked *c, int rays, uint64_t seed, const char *what, prt_real *transfer,
                why *w) {
    bake_job job;
    prt_result r;
    memset(&job, 0, sizeof job);
    job.desc.bands = LIGHT_BANDS;
    job.desc.samples = rays;
    job.desc.seed = seed;
    job.desc.bias = advise_bias;
    job.desc.tracer = &a->tracer.tracer;
    job.point_count = c->count;
    job.points = c->points;
    job.threads = a->o.threads;
    job.what = what;
    job.stop = &interrupted;
    job.transfer = transfer;
    job.done = (unsigned char *)calloc((size_t)c->count, 1);
    if (!job.done) return why_set(w, "out of memory");
    r = bake_job_run(&job);
    free(job.done);
    return r == PRT_OK ? 0 : why_set(w, "%s: %s", what, prt_result_string(r));
}

static void first_bands(int bands, int count, const prt_real *all, prt_real *rows) {
    size_t n = (size_t)PRT_SH_COUNT(bands), k;
    for (k = 0; k < (size_t)count; k++) memcpy(rows + k * n, all + k * LIGHT_COUNT, n * sizeof *rows);
}

/* The first bands of the light under a window. */
static void windowed_light(const advisor *a, int bands, prt_window w, prt_real *light) {
    int c, n = PRT_SH_COUNT(bands);
    for (c = 0; c < 3; c++) prt_sh_window(bands, w, bands, a->light + c * LIGHT_COUNT, light + c * n);
}

/* Irradiance of the normal over pi. */
static void shade_normals(int bands, int count, const prt_point *points, const prt_real *irradiance, prt_rgb *out) {
    int k, n = PRT_SH_COUNT(bands);
    for (k = 0; k < count; k++) {
        out[k].r = prt_sh_at(bands, irradiance, points[k].normal) * (prt_real)(1 / pi);
        out[k].g = prt_sh_at(bands, irradiance + n, points[k].normal) * (prt_real)(1 / pi);
        out[k].b = prt_sh_at(bands, irradiance + 2 * n, points[k].normal) * (prt_real)(1 / pi);
    }
}

static void occlude(int count, const prt_real *open, prt_rgb *colors) {
    int k;
    for (k = 0; k < count; k++) {
        colors[k].r *= open[k];
        colors[k].g *= open[k];
        colors[k].b *= open[k];
    }
}

typedef struct shading {               /* one way to shade some vertices, as timed and as judged */
    const advisor   *a;
    const trial     *t;
    int             count;
    const prt_point *points;
    prt_real        light[3 * MOST_COUNT], low[MOST_COUNT], step[MOST_COUNT], *rows, *open;
    void            *data;             /* rows, packed */
    prt_packed_transfer packed;
    prt_rgb         *out;
} shading;

static int uses_transfer(const trial *t) { return t->method == METHOD_SH || t->method == METHOD_FIV; }

static void shade(void *user) {
    shading *s = (shading *)user;
    if (uses_transfer(s->t)) {
        if (s->data) prt_shade_packed_n(&s->packed, 0, s->count, s->light, s->out);
        else prt_shade_diffuse_n(s->t->bands, s->count, s->rows, s->light, s->out);
        return;
    }
    if (s->a->lights) lights_shade(s->a, s->count, s->points, s->out);
    else shade_normals(s->t->bands, s->count, s->points, s->light, s->out);
    if (s->t->method == METHOD_AO) occlude(s->count, s->open, s->out);
}

static int pack(shading *s, why *w) {
    prt_storage as = s->t->stored == STORED_HALF ? PRT_STORAGE_HALF :
                     s->t->stored == STORED_16 ? PRT_STORAGE_16 : PRT_STORAGE_8;
    prt_result r;
    s->data = malloc(prt_transfer_packed_size(s->t->bands, as, s->count));
    if (!s->data) return why_set(w, "out of memory");
    r = prt_transfer_pack(s->t->bands, as, s->count, s->rows, s->data, s->low, s->step, &s->packed);
    return r == PRT_OK ? 0 : why_set(w, "transfer cannot be packed: %s", prt_result_string(r));
}

static int shading_create(const advisor *a, const trial *t, int count, const prt_point *points, const prt_real *all,
                          shading *s, why *w) {
    int k, c;
    s->a = a;
    s->t = t;
    s->data = NULL;
    s->count = count;
    s->points = points;
    s->rows = (prt_real *)malloc((size_t)count * MOST_COUNT * sizeof *s->rows);
    s->open = (prt_real *)malloc((size_t)count * sizeof *s->open);
    s->out = (prt_rgb *)malloc((size_t)count * sizeof *s->out);
    if (!s->rows || !s->open || !s->out) return why_set(w, "out of memory");
    if (t->bands > 0) windowed_light(a, t->bands, t->window, s->light);
    if (!uses_transfer(t) && !a->lights)
        for (c = 0; c < 3; c++)
            prt_sh_irradiance(t->bands, s->light + c * PRT_SH_COUNT(t->bands), s->light + c * PRT_SH_COUNT(t->bands));
    if (t->method == METHOD_AO)
        for (k = 0; k < count; k++)                        /* as it is stored, in 8 bits */
            s->open[k] = (prt_real)(floor(255 * 2 * sqrt(pi) * (double)all[(size_t)k * LIGHT_COUNT] + 0.5) / 255);
    if (!uses_transfer(t)) return 0;
    first_bands(t->bands, count, all, s->rows);
    return t->stored == STORED_FLOAT ? 0 : pack(s, w);
}

static void shading_free(shading *s) {
    free(s->rows);
    free(s->open);
    free(s->data);
    free(s->out);
}

int scene_colors(const advisor *a, const checked *c, const prt_real *transfer, const trial *t, prt_rgb *colors,
                 why *w) {
    shading s;
    int failed = shading_create(a, t, c->count, c->points, transfer, &s, w);
    if (!failed) {
        shade(&s);
        memcpy(colors, s.out, (size_t)c->count * sizeof *colors);
    }
    shading_free(&s);
    return failed;
}

static int judge(const advisor *a, const checked *c, const prt_real *all, trial *t, why *w) {
    prt_rgb *colors = (prt_rgb *)malloc((size_t)c->count * sizeof *colors);
    int failed = colors ? scene_colors(a, c, all, t, colors, w) : why_set(w, "out of memory");
    if (!failed && t->method == METHOD_FIV) moving_take(a, c, t, colors);
    if (!failed) trial_judge(t, &c->truth, colors);
    free(colors);
    return failed;
}

/* Time a vertex, on so many vertices that caches see them as they would a mesh of that size. */
static int measure_time(const advisor *a, trial *t, why *w) {
    prt_point *points = (prt_point *)malloc(TIMED * sizeof *points);
    prt_real *all = (prt_real *)calloc((size_t)TIMED * LIGHT_COUNT, sizeof *all);
    shading s;
    int k, failed;
    memset(&s, 0, sizeof s);
    if (!points || !all) failed = why_set(w, "out of memory");
    else {
        for (k = 0; k < TIMED; k++) points[k] = a->mesh.points[k % a->mesh.point_count];
        failed = shading_create(a, t, TIMED, points, all, &s, w);
        if (!failed) t->ns = time_of(shade, &s) / TIMED * 1e9;
    }
    shading_free(&s);
    free(all);
    free(points);
    return failed;
}

/* ---- what is measured ---- */

static void print_shares(const char *what, const double *energy, double total) {
    int l;
    printf("%-34s", what);
    for (l = 0; l < PRINTED; l++) printf(" %5.1f", total > 0 ? 100 * energy[l] / total : 0);
    printf("\n");
}

/* int L^2 dw of the map, mean over colours: what all bands together hold. */
static double map_energy(const image *map) {
    double sum = 0;
    size_t k, width = (size_t)map->width;
    for (k = 0; k < width * (size_t)map->height; k++) {
        double y = (double)(k / width), solid = cos(pi * y / map->height) - cos(pi * (y + 1) / map->height);
        const float *v = map->rgb + 3 * k;
        sum += solid * 2 * pi / map->width *
               ((double)v[0] * (double)v[0] + (double)v[1] * (double)v[1] + (double)v[2] * (double)v[2]) / 3;
    }
    return sum;
}

static double rest(const double *energy, double total, int from) {
    int l;
    for (l = 0; l < from; l++) total -= energy[l];
    return total > 0 ? total : 0;
}

static void print_visibility(const prt_visibility *v) {
    printf("visibility: %.1f %% open; %.3f bits a ray that only directions tell, %.3f that the vertex tells\n",
           100 * v->open, v->entropy, v->information);
}

static void print_measurements(const advisor *a, const checked *c, const prt_real *transfer) {
    double light[LIGHT_BANDS], points[LIGHT_BANDS], total = map_energy(&a->environment.map), all = 0, one;
    prt_visibility v;
    int l;
    prt_measure_energy(LIGHT_BANDS, 3, a->light, light);
    prt_measure_energy(LIGHT_BANDS, c->count, transfer, points);
    prt_measure_visibility(LIGHT_BANDS, c->count, transfer, &v);
    for (l = 0; l < LIGHT_BANDS; l++) all += points[l];
    printf("%-34s", "bands");
    for (l = 1; l <= PRINTED; l++) printf(" %5d", l);
    printf("\n");
    if (!a->lights) print_shares("energy of the light, %", light, total);
    print_shares("energy of the transfer, %", points, all);
    if (a->lights) {
        print_visibility(&v);
        return;
    }
    printf("%-34s", "error that leaving out the rest");
    for (l = 1; l <= PRINTED; l++) {
        prt_measure_truncation(LIGHT_BANDS, l, PRT_WINDOW_NONE, c->count, transfer, a->light, &one);
        printf(" %5.2f", 100 * one / c->truth.mean);
    }
    printf("\n%-34s", "costs, % (mean over turned lights)");
    for (l = 1; l <= PRINTED; l++) {
        prt_measure_truncation_turned(LIGHT_BANDS, l, PRT_WINDOW_NONE, points, light, &one);
        printf(" %5.2f", 100 * one / c->truth.mean);
    }
    printf("\nlight beyond %d bands: %.1f %% of its energy\n", PRINTED,
           total > 0 ? 100 * rest(light, total, PRINTED) / total : 0);
    print_visibility(&v);
}

/* ---- all trials ---- */

/* What bands and rays are foretold to cost: truncation from the most exact bake, noise from two with these rays. */
static double foretell(const advisor *a, const checked *c, const trial *t, const prt_real *exact, const prt_real *one,
                       const prt_real *two) {
    prt_real light[3 * LIGHT_COUNT];
    double lost, noise;
    int k;
    memset(light, 0, sizeof light);
    for (k = 0; k < 3; k++)
        prt_sh_window(LIGHT_BANDS, t->window, t->bands, a->light + k * LIGHT_COUNT, light + k * LIGHT_COUNT);
    prt_measure_truncation(LIGHT_BANDS, t->bands, t->window, c->count, exact, a->light, &lost);
    prt_measure_noise(LIGHT_BANDS, c->count, one, two, light, &noise);
    return sqrt(lost * lost + 2 * noise * noise) / c->truth.mean;
}

static trial trial_of(method m, int bands, stored as, int rays, prt_window window) {
    trial t;
    memset(&t, 0, sizeof t);
    t.method = m;
    t.bands = bands;
    t.rays = m == METHOD_NORMAL ? 0 : rays;
    t.window = window;
    t.stored = as;
    t.bytes = stored_bits[as] / 8.0 * (m == METHOD_SH ? PRT_SH_COUNT(bands) : 1);
    t.predicted = -1;
    return t;
}

/* One method with so many bands, stored so: every number of rays and every window. */
static int try_settings(advisor *a, const checked *c, prt_real *transfer[LADDER][HALVES], int steps, method m,
                        int bands, stored as, why *w) {
    trial t = trial_of(m, bands, as, 0, PRT_WINDOW_NONE);
    double ns;
    int window, step;
    if (measure_time(a, &t, w)) return -1;
    ns = t.ns;
    for (step = 0; step < (m == METHOD_NORMAL ? 1 : steps); step++)
        for (window = PRT_WINDOW_NONE; window <= (bands > 1 ? PRT_WINDOW_POSITIVE : PRT_WINDOW_NONE); window++) {
            t = trial_of(m, bands, as, ladder[step], (prt_window)window);
            t.ns = ns;
            if (judge(a, c, transfer[step][0], &t, w)) return -1;
            if (m == METHOD_SH && !a->lights && !a->moving)
                t.predicted = foretell(a, c, &t, transfer[steps - 1][0], transfer[step][0], transfer[step][1]);
            advisor_keep(a, &t);
        }
    return 0;
}

static int try_all(advisor *a, const checked *c, prt_real *transfer[LADDER][HALVES], int steps, why *w) {
    int as, k;
    for (k = 0; k < BAND_COUNTS && !interrupted; k++) {
        int bands = band_counts[k];
        if ((!a->lights || bands == 1) &&                  /* no bands where lights are summed one by one */
            (try_settings(a, c, transfer, steps, METHOD_NORMAL, a->lights ? 0 : bands, STORED_NOTHING, w) ||
             try_settings(a, c, transfer, steps, METHOD_AO, a->lights ? 0 : bands, STORED_8, w)))
            return -1;
        for (as = STORED_FLOAT; as <= STORED_8; as++)
            if (try_settings(a, c, transfer, steps, METHOD_SH, bands, (stored)as, w)) return -1;
    }
    return 0;
}

static int set_light(advisor *a, why *w) {
    prt_result r;
    if (a->o.lights) return lights_create(a, w);
    r = prt_sh_project_equirect_rgb(LIGHT_BANDS, a->environment.map.width, a->environment.map.height,
                                    a->environment.map.rgb, a->light);
    return r == PRT_OK ? 0 : why_set(w, "%s: %s", a->o.environment, prt_result_string(r));
}

int advise_scene(advisor *a, why *w) {
    prt_real *transfer[LADDER][HALVES] = { { NULL } };
    int steps = 0, step, half, failed = 0, done = 0;
    if (set_light(a, w) || (a->o.moving && moving_create(a, w))) return -1;
    if (checked_choose(a, a->o.check, 2 * a->o.seed + 1, "advise: truth", &a->first, w)) return -1;
    while (steps < LADDER && ladder[steps] <= a->o.rays) steps++;
    for (step = 0; step < steps && !failed; step++) {
        for (half = 0; half < HALVES && !failed; half++) {
            char what[64];
            snprintf(what, sizeof what, "advise: bake, %d rays", ladder[step]);
            transfer[step][half] = (prt_real *)malloc((size_t)a->first.count * LIGHT_COUNT * sizeof(prt_real));
            failed = transfer[step][half] ? bake(a, &a->first, ladder[step], 100 + 2 * a->o.seed + (uint64_t)half, what,
                                                 transfer[step][half], w)
                                          : why_set(w, "out of memory");
        }
        done += !failed;
    }
    if (failed && interrupted && done > 0) failed = 0;     /* what is there can be compared */
    if (!failed) {
        const prt_real *chosen[LADDER];
        print_measurements(a, &a->first, transfer[done - 1][0]);
        for (step = 0; step < done; step++) chosen[step] = transfer[step][0];
        failed = try_all(a, &a->first, transfer, done, w) || (!a->moving && try_occluders(a, &a->first, w)) ||
                 (a->moving && try_moving(a, &a->first, chosen, ladder, done, w)) ? -1 : 0;
    }
    for (step = 0; step < LADDER; step++) for (half = 0; half < HALVES; half++) free(transfer[step][half]);
    return failed;
}

int verify_elsewhere(advisor *a, trial *t, why *w) {
    prt_real *all;
    int failed;
    if (a->second.count == 0 &&
        checked_choose(a, a->o.check, 2 * a->o.seed + 2, "advise: truth elsewhere", &a->second, w))
        return -1;
    if (t->method == METHOD_VO) return verify_occluders(a, t, w);
    all = (prt_real *)calloc((size_t)a->second.count * LIGHT_COUNT, sizeof *all);
    if (!all) return why_set(w, "out of memory");
    failed = t->rays > 0 ? bake(a, &a->second, t->rays, 77777 + a->o.seed, "advise: bake elsewhere", all, w) : 0;
    if (!failed) failed = judge(a, &a->second, all, t, w);
    free(all);
    return failed;
}
