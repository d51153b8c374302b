/* bounces: what interreflection is worth, and what glossy lobes need, by figures. Two scenes under an environment map,
   baked with 0 to 8 bounces at their vertices, beside path tracing of the same vertices; Phong lobes of four exponents
   from transfer matrices of 3 to 6 bands.

   Writes DIR/bounce.md and DIR/gallery/bounce.jpg, glossy.jpg. RMSE is that of exit radiance over the vertices, all
   colours, divided by the mean of the reference; the reference comes in two independent halves R0, R1, and the mean of
   (P-R0)(P-R1) is free of their noise. Times are of the processor, all cores together. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../bench/bench.h"
#include "bake_job.h"
#include "bounce_job.h"
#include "contact_sheet.h"
#include "parallel.h"
#include "program.h"
#include "progress.h"
#include "replacement.h"
#include "sky_paths.h"
#include "vector.h"

enum { BANDS = 6, N = PRT_SH_COUNT(BANDS), LIT = 5, BOUNCES = 8, SCENES = 2, EXPONENTS = 4, LOBE_BANDS = 5 };
enum { SAMPLES_A_PIXEL = 2, CELL = 250 };
static const double exponents[EXPONENTS] = { 4, 12, 24, 64 };
static const int lobe_bands[LOBE_BANDS] = { 3, 4, 5, 6, 6 };             /* the last under deringed light */
static const prt_rgb background = { (prt_real)0.03, (prt_real)0.03, (prt_real)0.035 };

static const char usage[] =
    "usage: bounces [options]\n"
    "  --environment F    equirectangular .hdr or .pfm        [examples/data/courtyard.hdr]\n"
    "  --rays N           rays a vertex, each bounce          [1024]\n"
    "  --paths N          paths a vertex of each half of the reference [2048]\n"
    "  --strips N         fineness of the scenes, percent     [100]\n"
    "  --threads N        threads                             [all processors]\n"
    "  --out DIR          where bounce.md goes, and gallery/  [out]\n"
    "  --help             this text\n";

typedef struct options { const char *out, *environment; int rays, paths, strips, threads, help; } options;

typedef struct error { double rmse, noise; } error;

typedef struct stage {
    const char    *name;
    scene         scene;
    embree_tracer tracer;
    view          seen;
    prt_bounce_object objects[SCENE_PARTS];
    int           count;               /* vertices */
    prt_real      *direct, *bounce[2], *total;             /* [count][N], [count][3][N] */
    prt_rgb       *truth[SKY_HALVES];  /* [count][SKY_LIGHTS][SKY_BOUNCES + 1] */
    prt_rgb       *shaded[BOUNCES + 1];    /* [count] with so many bounces, own albedo included; light in LIT bands */
    error         banded[BOUNCES + 1], full[BOUNCES + 1], alone[BOUNCES + 1];
    double        share[BOUNCES + 1];  /* of each bounce alone in the reference's mean */
    double        strength[BOUNCES + 1], seconds[BOUNCES + 1], truth_seconds;
    error         lobe[EXPONENTS][LOBE_BANDS], shadows_alone[EXPONENTS];
    double        matrix_seconds;
    picture       pictures[EXPONENTS][LOBE_BANDS + 1];
} stage;

typedef struct study { options o; environment light; stage stages[SCENES]; } study;

static void *room_for(size_t count, size_t size, why *w) {
    void *p = calloc(count ? count : 1, size);
    if (!p) why_set(w, "out of memory");
    return p;
}

/* ---- figures ---- */

/* a: what is judged; r: the halves; `use` not NULL: vertices that count. */
static error error_of(int count, const prt_rgb *a, const prt_rgb *r0, const prt_rgb *r1, const unsigned char *use) {
    double products = 0, differences = 0, mean = 0, n = 0;
    error e;
    int k, c;
    for (k = 0; k < count; k++) {
        double p[3], s[3], t[3];
        if (use && !use[k]) continue;
        p[0] = (double)a[k].r; p[1] = (double)a[k].g; p[2] = (double)a[k].b;
        s[0] = (double)r0[k].r; s[1] = (double)r0[k].g; s[2] = (double)r0[k].b;
        t[0] = (double)r1[k].r; t[1] = (double)r1[k].g; t[2] = (double)r1[k].b;
        for (c = 0; c < 3; c++) {
            products += (p[c] - s[c]) * (p[c] - t[c]);
            differences += (s[c] - t[c]) * (s[c] - t[c]);
            mean += (s[c] + t[c]) / 2;
            n++;
        }
    }
    e.rmse = products > 0 && mean > 0 ? sqrt(products / n) / (mean / n) : 0;
    e.noise = mean > 0 ? sqrt(differences / n) / 2 / (mean / n) : 0;
    return e;
}

static prt_rgb albedo_of(const stage *s, int vertex) {
    return s->scene.parts[scene_part_of_point(&s->scene, vertex)].material.diffuse;
}

/* The reference's exit radiance from paths that met `from` to `to` surfaces, to out[count]. */
static void truth_sum(const stage *s, int half, int light, int from, int to, prt_rgb *out) {
    int k, i;
    for (k = 0; k < s->count; k++) {
        const prt_rgb *all = s->truth[half] + ((size_t)k * SKY_LIGHTS + (size_t)light) * (SKY_BOUNCES + 1);
        prt_rgb sum = { 0, 0, 0 };
        for (i = from; i <= to; i++) { sum.r += all[i].r; sum.g += all[i].g; sum.b += all[i].b; }
        out[k] = rgb_times(sum, albedo_of(s, k));
    }
}

/* ---- diffuse ---- */

/* Light of the first bands in room for BANDS. */
static void light_in_bands(const study *d, int bands, prt_real *light) {
    prt_real few[3 * N];
    int c;
    environment_light(&d->light, bands, few);
    memset(light, 0, 3 * N * sizeof *light);
    for (c = 0; c < 3; c++)
        memcpy(light + c * N, few + c * PRT_SH_COUNT(bands), (size_t)PRT_SH_COUNT(bands) * sizeof *few);
}

static void shade(const stage *s, const prt_real *transfer, const prt_real *light, prt_rgb *out) {
    int k;
    prt_shade_diffuse_rgb_n(BANDS, s->count, transfer, light, out);
    for (k = 0; k < s->count; k++) out[k] = rgb_times(out[k], albedo_of(s, k));
}

static int bake_direct(const study *d, stage *s, why *w) {
    double before = processor_seconds();
    bake_job job;
    prt_result result;
    memset(&job, 0, sizeof job);
    job.desc.bands = BANDS;
    job.desc.samples = d->o.rays;
    job.desc.bias = (prt_real)1e-4;
    job.desc.tracer = &s->tracer.tracer;
    job.point_count = s->count;
    job.points = s->scene.mesh.points;
    job.threads = d->o.threads;
    job.what = "bounces: transfer";
    job.stop = &interrupted;
    job.transfer = s->direct;
    job.done = (unsigned char *)room_for((size_t)s->count, 1, w);
    if (!job.done) return -1;
    result = bake_job_run(&job);
    free(job.done);
    s->seconds[0] = processor_seconds() - before;
    return result == PRT_OK ? 0 : why_set(w, "transfer: %s", prt_result_string(result));
}

static prt_bounce_desc bounce_desc(const study *d, const stage *s) {
    prt_bounce_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.bands = BANDS;
    desc.samples = d->o.rays;
    desc.bias = (prt_real)1e-4;
    desc.planes = 3;
    desc.object_count = s->scene.part_count;
    desc.objects = s->objects;
    desc.tracer = &s->tracer.tracer;
    return desc;
}

/* Bounce after bounce, judged each by itself and all together. */
static int bake_bounces(const study *d, stage *s, why *w) {
    prt_real light[3 * N], strength = 0;
    prt_rgb *sum[SKY_HALVES], *own;
    bounce_job job;
    int k, c, half, failed = 0;
    light_in_bands(d, LIT, light);
    memset(&job, 0, sizeof job);
    job.desc = bounce_desc(d, s);
    job.point_count = s->count;
    job.points = s->scene.mesh.points;
    job.previous = s->direct;
    job.threads = d->o.threads;
    job.what = "bounces: a bounce";
    job.stop = &interrupted;
    for (k = 0; k < s->count; k++)
        for (c = 0; c < 3; c++)
            memcpy(s->total + ((size_t)k * 3 + (size_t)c) * N, s->direct + (size_t)k * N, N * sizeof *light);
    shade(s, s->total, light, s->shaded[0]);
    for (half = 0; half < SKY_HALVES; half++) sum[half] = (prt_rgb *)room_for((size_t)s->count, sizeof *own, w);
    own = (prt_rgb *)room_for((size_t)s->count, sizeof *own, w);
    if (!sum[0] || !sum[1] || !own) failed = -1;
    for (k = 1; k <= BOUNCES && !failed; k++) {
        double before = processor_seconds();
        job.out = s->bounce[k % 2];
        failed = bounce_job_run(&job, w);
        if (failed) break;
        s->seconds[k] = processor_seconds() - before;
        prt_bounce_add(BANDS, s->count, 3, job.out, 3, s->total, &strength);
        s->strength[k] = (double)strength;
        shade(s, s->total, light, s->shaded[k]);
        shade(s, job.out, light, own);
        for (half = 0; half < SKY_HALVES; half++) truth_sum(s, half, 1, k, k, sum[half]);
        s->alone[k] = error_of(s->count, own, sum[0], sum[1], NULL);
        job.previous = job.out;
        job.desc.previous_planes = 3;
    }
    for (half = 0; half < SKY_HALVES; half++) free(sum[half]);
    free(own);
    return failed;
}

static double mean_of(int count, const prt_rgb *a) {
    double sum = 0;
    int k;
    for (k = 0; k < count; k++) sum += rgb_mean(a[k]) / count;
    return sum;
}

static int judge_bounces(stage *s, why *w) {
    prt_rgb *banded[SKY_HALVES], *full[SKY_HALVES];
    int k, half, failed = 0;
    for (half = 0; half < SKY_HALVES; half++) {
        banded[half] = (prt_rgb *)room_for((size_t)s->count, sizeof **banded, w);
        full[half] = (prt_rgb *)room_for((size_t)s->count, sizeof **full, w);
        failed |= !banded[half] || !full[half];
    }
    if (!failed) {
        double all;
        truth_sum(s, 0, 1, 0, SKY_BOUNCES, banded[0]);
        all = mean_of(s->count, banded[0]);
        for (k = 0; k <= BOUNCES; k++) {
            truth_sum(s, 0, 1, k, k, banded[0]);
            s->share[k] = mean_of(s->count, banded[0]) / all;
        }
        for (half = 0; half < SKY_HALVES; half++) {
            truth_sum(s, half, 1, 0, SKY_BOUNCES, banded[half]);
            truth_sum(s, half, 0, 0, SKY_BOUNCES, full[half]);
        }
        for (k = 0; k <= BOUNCES; k++) {
            s->banded[k] = error_of(s->count, s->shaded[k], banded[0], banded[1], NULL);
            s->full[k] = error_of(s->count, s->shaded[k], full[0], full[1], NULL);
        }
    }
    for (half = 0; half < SKY_HALVES; half++) { free(banded[half]); free(full[half]); }
    return failed ? -1 : 0;
}

static sky_paths paths_of(const study *d, const stage *s) {
    sky_paths p;
    memset(&p, 0, sizeof p);
    p.scene = &s->scene;
    p.tracer = &s->tracer.tracer;
    p.light = &d->light;
    p.bands = LIT;
    p.bias = (prt_real)1e-4;
    p.threads = d->o.threads;
    p.stop = &interrupted;
    p.place_count = s->count;
    p.places = s->scene.mesh.points;
    return p;
}

static int trace_truth(const study *d, stage *s, why *w) {
    double before = processor_seconds();
    sky_paths p = paths_of(d, s);
    p.samples = d->o.paths;
    p.what = "bounces: reference";
    p.out[0] = s->truth[0];
    p.out[1] = s->truth[1];
    if (sky_paths_trace(&p, w)) return -1;
    s->truth_seconds = processor_seconds() - before;
    return 0;
}

/* ---- glossy ---- */

typedef struct glossy_job {
    prt_bounce_desc desc;
    const stage     *s;
    const prt_real  *transfer;
    prt_real        *matrices;
} glossy_job;
static int glossy_range(void *user, void *own, int first, int count) {
    const glossy_job *g = (const glossy_job *)user;
    (void)own;
    return prt_bake_glossy(&g->desc, 0, g->s->count, g->s->scene.mesh.points, g->transfer, first, count,
                           g->matrices) != PRT_OK;
}

/* transfer NULL: shadows alone, one plane. */
static int bake_matrices(const study *d, const stage *s, const prt_real *transfer, prt_real *matrices, why *w) {
    glossy_job g;
    parallel job;
    g.desc = bounce_desc(d, s);
    g.desc.previous_planes = 3;
    g.s = s;
    g.transfer = transfer;
    g.matrices = matrices;
    memset(&job, 0, sizeof job);
    job.count = s->count;
    job.chunk = 32;
    job.threads = d->o.threads;
    job.what = "bounces: matrices";
    job.unit = "rays";
    job.unit_per_item = d->o.rays;
    job.stop = &interrupted;
    job.work = glossy_range;
    job.user = &g;
    return parallel_all(&job, w);
}

/* Where vertices mirror the eye, and whether they face it. */
static void mirrored_eye(const stage *s, prt_vec3 *dirs, unsigned char *use) {
    int k;
    for (k = 0; k < s->count; k++) {
        const prt_point *p = &s->scene.mesh.points[k];
        prt_vec3 to = vec_unit(vec_add(p->position, -1, s->seen.eye.eye), p->normal);
        dirs[k] = vec_reflect(to, p->normal);
        use[k] = vec_dot(to, p->normal) < 0;
    }
}

/* A lobe of the first bands, from matrices of BANDS: coefficients beyond are left out on both sides. */
static void shade_lobe(const study *d, const stage *s, const prt_real *matrices, int planes, int which, double exponent,
                       const prt_vec3 *dirs, const unsigned char *use, prt_rgb *out) {
    prt_real light[3 * N], incident[3 * N], zonal[BANDS] = { 0 };
    int k, bands = lobe_bands[which];
    light_in_bands(d, bands, light);
    for (k = 0; k < 3 && which == LOBE_BANDS - 1; k++) prt_sh_dering(BANDS, light + k * N, light + k * N, NULL);
    prt_phong_zonal(bands, (prt_real)exponent, zonal);
    for (k = 0; k < s->count; k++) {
        out[k] = rgb(0, 0, 0);
        if (!use[k]) continue;
        prt_shade_incident(BANDS, BANDS, planes, matrices + (size_t)k * (size_t)planes * N * N, light, incident);
        prt_shade_glossy(BANDS, incident, zonal, dirs[k], &out[k]);
    }
}

typedef struct lobes {
    prt_vec3 *dirs;
    unsigned char *use;
    prt_real *matrices;                /* [count][3][N][N] */
    prt_rgb *shaded, *truth[SKY_HALVES], *sum[EXPONENTS][SKY_HALVES];
} lobes;

static void lobes_free(lobes *l) {
    int half, e;
    free(l->dirs);
    free(l->use);
    free(l->matrices);
    free(l->shaded);
    for (half = 0; half < SKY_HALVES; half++) {
        free(l->truth[half]);
        for (e = 0; e < EXPONENTS; e++) free(l->sum[e][half]);
    }
}

static int lobes_create(const stage *s, lobes *l, why *w) {
    size_t count = (size_t)s->count;
    int half, e;
    memset(l, 0, sizeof *l);
    l->dirs = (prt_vec3 *)room_for(count, sizeof *l->dirs, w);
    l->use = (unsigned char *)room_for(count, 1, w);
    l->matrices = (prt_real *)room_for(count, 3 * N * N * sizeof *l->matrices, w);
    l->shaded = (prt_rgb *)room_for(count, sizeof *l->shaded, w);
    for (half = 0; half < SKY_HALVES; half++) {
        l->truth[half] = (prt_rgb *)room_for(count * SKY_LIGHTS * (SKY_BOUNCES + 1), sizeof *l->shaded, w);
        if (!l->truth[half]) return -1;
        for (e = 0; e < EXPONENTS; e++) {
            l->sum[e][half] = (prt_rgb *)room_for(count, sizeof *l->shaded, w);
            if (!l->sum[e][half]) return -1;
        }
    }
    return l->dirs && l->use && l->matrices && l->shaded ? 0 : -1;
}

static int trace_lobes(const study *d, const stage *s, lobes *l, int e, why *w) {
    sky_paths p = paths_of(d, s);
    int half, k, i;
    p.samples = d->o.paths / 4 > 0 ? d->o.paths / 4 : 1;
    p.seed = 100 + (uint64_t)e;
    p.what = "bounces: reference, glossy";
    p.lobe = l->dirs;
    p.exponent = exponents[e];
    p.out[0] = l->truth[0];
    p.out[1] = l->truth[1];
    if (sky_paths_trace(&p, w)) return -1;
    for (half = 0; half < SKY_HALVES; half++)
        for (k = 0; k < s->count; k++) {
            const prt_rgb *all = l->truth[half] + (size_t)k * SKY_LIGHTS * (SKY_BOUNCES + 1);
            prt_rgb *sum = &l->sum[e][half][k];
            for (i = 0; i <= SKY_BOUNCES; i++) { sum->r += all[i].r; sum->g += all[i].g; sum->b += all[i].b; }
        }
    return 0;
}

static int paint(const stage *s, const prt_rgb *colors, picture *to, why *w) {
    return picture_create(s->seen.width, s->seen.height, to, w) ||
           view_paint(&s->seen, &s->scene, colors, background, to, w);
}

/* The mean of both halves, black where nothing mirrors the eye. */
static void mean_of_halves(int count, const prt_rgb *a, const prt_rgb *b, const unsigned char *use, prt_rgb *out) {
    int k;
    for (k = 0; k < count; k++) {
        out[k] = use && !use[k] ? rgb(0, 0, 0)
               : rgb(((double)a[k].r + (double)b[k].r) / 2, ((double)a[k].g + (double)b[k].g) / 2,
                     ((double)a[k].b + (double)b[k].b) / 2);
    }
}

static int measure_lobe(const study *d, stage *s, lobes *l, int e, int pictures, why *w) {
    int b;
    if (trace_lobes(d, s, l, e, w)) return -1;
    for (b = 0; b < LOBE_BANDS; b++) {
        shade_lobe(d, s, l->matrices, 3, b, exponents[e], l->dirs, l->use, l->shaded);
        s->lobe[e][b] = error_of(s->count, l->shaded, l->sum[e][0], l->sum[e][1], l->use);
        if (pictures && paint(s, l->shaded, &s->pictures[e][b], w)) return -1;
    }
    mean_of_halves(s->count, l->sum[e][0], l->sum[e][1], l->use, l->shaded);
    return pictures ? paint(s, l->shaded, &s->pictures[e][LOBE_BANDS], w) : 0;
}

static int measure_lobes(const study *d, stage *s, int pictures, why *w) {
    double before;
    lobes l;
    int e, failed = lobes_create(s, &l, w);
    if (!failed) {
        mirrored_eye(s, l.dirs, l.use);
        before = processor_seconds();
        failed = bake_matrices(d, s, s->total, l.matrices, w);
        s->matrix_seconds = processor_seconds() - before;
    }
    for (e = 0; e < EXPONENTS && !failed; e++) failed = measure_lobe(d, s, &l, e, pictures, w);
    if (!failed) failed = bake_matrices(d, s, NULL, l.matrices, w);
    for (e = 0; e < EXPONENTS && !failed; e++) {
        shade_lobe(d, s, l.matrices, 1, LOBE_BANDS - 2, exponents[e], l.dirs, l.use, l.shaded);
        s->shadows_alone[e] = error_of(s->count, l.shaded, l.sum[e][0], l.sum[e][1], l.use);
    }
    lobes_free(&l);
    return failed ? -1 : 0;
}

/* ---- scenes ---- */

static int stage_create_here(const study *d, int which, stage *s, why *w) {
    double fineness = d->o.strips / 100.0;
    camera eye = which ? camera_orbit(vec(0, 0, 0.6), 5.0, -1.5, 0.4, 0.5)
                       : camera_orbit(vec(0, 0, 0.35), 7.0, -1.25, 0.55, 0.55);
    size_t row = N * sizeof(prt_real);
    int k;
    s->name = which ? "room" : "shapes";
    if (which ? scene_room(fineness, &s->scene, w) : scene_shapes(fineness, &s->scene, w)) return -1;
    if (scene_trace_with(&s->scene, &s->tracer, w)) return -1;
    if (view_create(&s->scene, &s->tracer, eye, CELL * SAMPLES_A_PIXEL, CELL * SAMPLES_A_PIXEL, &s->seen, w)) return -1;
    s->count = s->scene.mesh.point_count;
    bounce_objects_of(&s->scene, s->objects);
    s->direct = (prt_real *)room_for((size_t)s->count, row, w);
    for (k = 0; k < 2; k++) s->bounce[k] = (prt_real *)room_for((size_t)s->count, 3 * row, w);
    s->total = (prt_real *)room_for((size_t)s->count, 3 * row, w);
    if (!s->direct || !s->bounce[0] || !s->bounce[1] || !s->total) return -1;
    for (k = 0; k < SKY_HALVES; k++) {
        s->truth[k] = (prt_rgb *)room_for((size_t)s->count * SKY_LIGHTS * (SKY_BOUNCES + 1), sizeof **s->truth, w);
        if (!s->truth[k]) return -1;
    }
    for (k = 0; k <= BOUNCES; k++) {
        s->shaded[k] = (prt_rgb *)room_for((size_t)s->count, sizeof **s->shaded, w);
        if (!s->shaded[k]) return -1;
    }
    return 0;
}

static void stage_free_here(stage *s) {
    int k, e;
    for (e = 0; e < EXPONENTS; e++) for (k = 0; k <= LOBE_BANDS; k++) picture_free(&s->pictures[e][k]);
    for (k = 0; k <= BOUNCES; k++) free(s->shaded[k]);
    for (k = 0; k < SKY_HALVES; k++) free(s->truth[k]);
    free(s->direct);
    free(s->bounce[0]);
    free(s->bounce[1]);
    free(s->total);
    view_free(&s->seen);
    embree_tracer_destroy(&s->tracer);
    scene_free(&s->scene);
}

/* ---- what is shown ---- */

static int write_sheet(const char *path, const char *title, int rows, int columns, const char *const *heads,
                       const char *const *names, const double *exposures, const sheet_cell *cells, const char *foot,
                       why *w) {
    contact_sheet sheet;
    memset(&sheet, 0, sizeof sheet);
    sheet.title = title;
    sheet.rows = rows;
    sheet.columns = columns;
    sheet.per_pixel = SAMPLES_A_PIXEL;
    sheet.width = sheet.height = CELL;
    sheet.heads = heads;
    sheet.names = names;
    sheet.exposures = exposures;
    sheet.cells = cells;
    sheet.foot[0] = foot;
    if (contact_sheet_write(&sheet, path, w)) return -1;
    printf("%s\n", path);
    return 0;
}

static int write_bounces(study *d, why *w) {
    enum { COLUMNS = 6 };
    static const int bounces[COLUMNS - 1] = { 0, 1, 2, 3, BOUNCES };
    static const char *const heads[COLUMNS] = { "direct light", "1 bounce", "2 bounces", "3 bounces", "8 bounces",
                                                "path traced" };
    const char *names[SCENES];
    picture pictures[SCENES][COLUMNS];
    sheet_cell cells[SCENES * COLUMNS];
    double exposures[SCENES];
    char path[1024];
    int i, k, failed = 0;
    memset(pictures, 0, sizeof pictures);
    memset(cells, 0, sizeof cells);
    for (i = 0; i < SCENES && !failed; i++) {
        stage *s = &d->stages[i];
        prt_rgb *mean = (prt_rgb *)room_for((size_t)s->count, sizeof *mean, w), *other;
        other = (prt_rgb *)room_for((size_t)s->count, sizeof *mean, w);
        failed = !mean || !other;
        for (k = 0; k < COLUMNS && !failed; k++) {
            sheet_cell *c = &cells[i * COLUMNS + k];
            if (k == COLUMNS - 1) {
                truth_sum(s, 0, 1, 0, SKY_BOUNCES, mean);
                truth_sum(s, 1, 1, 0, SKY_BOUNCES, other);
                mean_of_halves(s->count, mean, other, NULL, mean);
                snprintf(c->first, sizeof c->first, "noise %.2f %%", 100 * s->banded[0].noise);
            } else {
                snprintf(c->first, sizeof c->first, "RMSE %.2f %%", 100 * s->banded[bounces[k]].rmse);
            }
            failed = paint(s, k == COLUMNS - 1 ? mean : s->shaded[bounces[k]], &pictures[i][k], w);
            c->shown = &pictures[i][k];
        }
        names[i] = s->name;
        if (!failed) exposures[i] = picture_exposure(&pictures[i][COLUMNS - 1]);
        free(mean);
        free(other);
    }
    snprintf(path, sizeof path, "%s/gallery/bounce.jpg", d->o.out);
    failed = failed || write_sheet(path, "Interreflection at the vertices", SCENES, COLUMNS, heads, names, exposures,
                                   cells, "Light of 5 bands. RMSE over the vertices, relative to the mean of the "
                                   "reference.", w);
    for (i = 0; i < SCENES; i++) for (k = 0; k < COLUMNS; k++) picture_free(&pictures[i][k]);
    return failed ? -1 : 0;
}

static int write_lobes(study *d, why *w) {
    static const char *const heads[LOBE_BANDS + 1] = { "3 bands", "4 bands", "5 bands", "6 bands",
                                                       "6 bands, deringed light", "path traced" };
    enum { ROWS = EXPONENTS - 1 };     /* the sharpest is in the table alone */
    static const char *const names[ROWS] = { "exponent 4", "exponent 12", "exponent 24" };
    const stage *s = &d->stages[1];
    sheet_cell cells[ROWS * (LOBE_BANDS + 1)];
    double exposures[ROWS];
    char path[1024];
    int e, b;
    memset(cells, 0, sizeof cells);
    for (e = 0; e < ROWS; e++) {
        exposures[e] = picture_exposure(&s->pictures[e][LOBE_BANDS]);
        for (b = 0; b <= LOBE_BANDS; b++) {
            sheet_cell *c = &cells[e * (LOBE_BANDS + 1) + b];
            c->shown = &s->pictures[e][b];
            if (b < LOBE_BANDS) snprintf(c->first, sizeof c->first, "RMSE %.1f %%", 100 * s->lobe[e][b].rmse);
            else snprintf(c->first, sizeof c->first, "noise %.1f %%", 100 * s->lobe[e][0].noise);
        }
    }
    snprintf(path, sizeof path, "%s/gallery/glossy.jpg", d->o.out);
    return write_sheet(path, "Phong lobes from transfer matrices", ROWS, LOBE_BANDS + 1, heads, names, exposures,
                       cells, "The lobe alone, as if all surfaces mirrored by it; the whole environment map is "
                       "reflected.", w);
}

static void write_table_of_bounces(const stage *s, FILE *to) {
    int k;
    fprintf(to, "\n### %s: %d vertices\n\n| bounces | RMSE, light in %d bands | RMSE, whole map | strength of the last | "
            "its share of light | its own RMSE | bake, s |\n|---:|---:|---:|---:|---:|---:|---:|\n", s->name, s->count,
            LIT);
    for (k = 0; k <= BOUNCES; k++) {
        fprintf(to, "| %d | %.2f %% | %.2f %% | ", k, 100 * s->banded[k].rmse, 100 * s->full[k].rmse);
        if (k) fprintf(to, "%.4f | %.2f %% | %.1f %%", s->strength[k], 100 * s->share[k], 100 * s->alone[k].rmse);
        else fprintf(to, "| %.2f %% |", 100 * s->share[k]);
        fprintf(to, " | %.1f |\n", s->seconds[k]);
    }
    fprintf(to, "\nNoise of the reference: %.2f %% and %.2f %%; it took %.0f s.\n", 100 * s->banded[0].noise,
            100 * s->full[0].noise, s->truth_seconds);
}

static void write_table_of_lobes(const stage *s, FILE *to) {
    int e, b;
    fprintf(to, "\n### %s\n\n| exponent |", s->name);
    for (b = 0; b < LOBE_BANDS - 1; b++) fprintf(to, " %d bands |", lobe_bands[b]);
    fprintf(to, " %d, deringed | %d, shadows alone | noise |\n|---:|", BANDS, BANDS);
    for (b = 0; b < LOBE_BANDS + 2; b++) fprintf(to, "---:|");
    for (e = 0; e < EXPONENTS; e++) {
        fprintf(to, "\n| %.0f |", exponents[e]);
        for (b = 0; b < LOBE_BANDS; b++) fprintf(to, " %.1f %% |", 100 * s->lobe[e][b].rmse);
        fprintf(to, " %.1f %% | %.1f %% |", 100 * s->shadows_alone[e].rmse, 100 * s->lobe[e][0].noise);
    }
    fprintf(to, "\n\nMatrices of %d bands: %.1f s, %.1f KB a vertex in three planes.\n", BANDS, s->matrix_seconds,
            3 * N * N * (double)sizeof(float) / 1000);
}

static int write_page(const study *d, why *w) {
    replacement r;
    char path[1024];
    FILE *to;
    int k;
    snprintf(path, sizeof path, "%s/bounce.md", d->o.out);
    if (replacement_open(path, &r, w)) return -1;
    to = r.file;
    fprintf(to, "<!-- Written by examples/bounces.c: do not edit. `make bounces` measures and writes anew. -->\n"
            "# Interreflection and glossy lobes\n\n"
            "What bounces and bands are worth, against path tracing of the same vertices under %s.hdr. RMSE of exit "
            "radiance over the vertices, relative to its mean. %d rays a vertex in each pass, %d paths a vertex in "
            "each of two halves of the reference.\nprt.h %s; machine: %s; compiler: %s; flags: %s; rays by Embree; times of "
            "the processor, all threads together.\n\n## Diffuse interreflection\n\n"
            "![Bounces](gallery/bounce.jpg)\n\n"
            "Under light that is cut to %d bands transfer has nothing to lose but bounces, rays and what lies between "
            "vertices; under the whole map it also loses the bands that light has beyond. Strength: what a bounce adds "
            "at most to a white surface under L = 1 (`prt_bounce_add`), which is known without any light and says when "
            "to stop. The last columns compare each bounce by itself with the paths that met as many surfaces.\n",
            d->light.name, d->o.rays, d->o.paths, PRT_VERSION, bench_cpu_name(), EXAMPLE_COMPILER, EXAMPLE_FLAGS, LIT);
    for (k = 0; k < SCENES; k++) write_table_of_bounces(&d->stages[k], to);
    fprintf(to, "\n## Glossy lobes\n\n![Glossy lobes](gallery/glossy.jpg)\n\n"
            "Phong lobes of integral 1 about the mirrored eye direction, from matrices with interreflection "
            "(`prt_bake_glossy` with the transfer of %d bounces), light and lobe cut to the same bands; vertices that "
            "face the eye. Deringed: the light smoothed until it is nowhere negative (`prt_sh_dering`). The column of "
            "shadows alone leaves out what surfaces reflect. A lobe of exponent s has half of its energy below l = "
            ".83 √s: sharper ones need more bands than a matrix can pay for.\n", BOUNCES);
    for (k = 0; k < SCENES; k++) write_table_of_lobes(&d->stages[k], to);
    if (replacement_commit(&r, w)) return -1;
    printf("%s\n", path);
    return 0;
}

static void report(const stage *s) {
    int k, e, b;
    for (k = 0; k <= BOUNCES; k++)
        printf("%-7s %d bounces: RMSE %6.2f %%, whole map %6.2f %%; this bounce alone %5.1f %% off, %.1f s\n",
               s->name, k, 100 * s->banded[k].rmse, 100 * s->full[k].rmse, 100 * s->alone[k].rmse, s->seconds[k]);
    for (e = 0; e < EXPONENTS; e++) {
        printf("%-7s lobe of exponent %2.0f:", s->name, exponents[e]);
        for (b = 0; b < LOBE_BANDS; b++) printf(" %d bands %5.1f %%", lobe_bands[b], 100 * s->lobe[e][b].rmse);
        printf(" deringed, shadows alone %5.1f %%\n", 100 * s->shadows_alone[e].rmse);
    }
}

/* ---- the program ---- */

static int parse(int count, char **words, options *o, why *w) {
    int i;
    memset(o, 0, sizeof *o);
    o->out = "out";
    o->environment = PRT_EXAMPLE_DATA "/courtyard.hdr";
    o->rays = 1024;
    o->paths = 2048;
    o->strips = 100;
    o->threads = processor_count();
    for (i = 1; i < count; i++) {
        struct { const char *name; int low, high; int *value; } numbers[] = {
            { "--rays", 1, 1 << 20, &o->rays }, { "--paths", 1, 1 << 20, &o->paths },
            { "--strips", 10, 1000, &o->strips }, { "--threads", 1, 256, &o->threads }
        };
        const char *next = i + 1 < count ? words[i + 1] : NULL;
        size_t k;
        long value = 0;
        int known = 0;
        for (k = 0; k < sizeof numbers / sizeof *numbers; k++) {
            if (strcmp(words[i], numbers[k].name)) continue;
            if (parse_number(words[i], next, numbers[k].low, numbers[k].high, &value, w)) return -1;
            *numbers[k].value = (int)value;
            known = 2;
        }
        if (strcmp(words[i], "--out") == 0 || strcmp(words[i], "--environment") == 0) {
            if (!next) return why_set(w, "%s wants a name", words[i]);
            *(words[i][2] == 'o' ? &o->out : &o->environment) = next;
            known = 2;
        }
        if (strcmp(words[i], "--help") == 0) o->help = known = 1;
        if (!known) return why_set(w, "%s: no such option (--help lists them)", words[i]);
        i += known - 1;
    }
    return 0;
}

static int run(study *d, why *w) {
    char gallery[1024];
    int k, failed;
    snprintf(gallery, sizeof gallery, "%s/gallery", d->o.out);
    failed = make_directory(d->o.out, w) || make_directory(gallery, w) ||
             environment_load(d->o.environment, 0, &d->light, w);
    for (k = 0; k < SCENES && !failed; k++) {
        stage *s = &d->stages[k];
        failed = stage_create_here(d, k, s, w) || trace_truth(d, s, w) || bake_direct(d, s, w) ||
                 bake_bounces(d, s, w) || judge_bounces(s, w) || measure_lobes(d, s, k == 1, w);
        if (!failed) report(s);
    }
    failed = failed || write_bounces(d, w) || write_lobes(d, w) || write_page(d, w);
    for (k = 0; k < SCENES; k++) stage_free_here(&d->stages[k]);
    environment_free(&d->light);
    return failed ? -1 : 0;
}

int main(int count, char **words) {
    static study d;
    why w;
    int status;
    w.line[0] = 0;
    status = parse(count, words, &d.o, &w);
    if (status == 0 && d.o.help) {
        fputs(usage, stdout);
        return 0;
    }
    if (status == 0) {
        stop_on(SIGINT);
        stop_on(SIGTERM);
        status = run(&d, &w);
    }
    if (status) fprintf(stderr, "bounces: %s\n", w.line);
    return interrupted ? STOPPED : status ? 1 : 0;
}
