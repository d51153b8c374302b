/* vo_compare: section 7.6 of [Sherif 2013] run again. Vector occluders beside Phong, ambient occlusion, spherical and
   cpherical harmonics, all at the vertices, against path tracing of the same point lights.

   Writes DIR/vo.md with its pictures in DIR/gallery and its plots in DIR/plots. What each number means:

     RMSE    root mean square error of linear radiance over the pixels that the scene covers whole, all colours, divided by
             the mean of the reference there; negative radiance counts as 0. The reference comes in two independent halves
             R0, R1; the mean of (P-R0)(P-R1) is free of their noise.
     SSIM    structural similarity of luminance as the screen shows it, see common/similarity.h.
     noise   standard error of the reference picture, in the unit of RMSE.
     time    of the processor: bakes on all cores together, shading on one, the least of several runs taken in turns.

   References are kept in KEEP and taken up again: interrupt it and go on later. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "../bench/bench.h"
#include "bake_job.h"
#include "contact_sheet.h"
#include "path_reference.h"
#include "point_lights.h"
#include "progress.h"
#include "reference.h"
#include "replacement.h"
#include "shadow_laws.h"
#include "similarity.h"
#include "techniques.h"
#include "vector.h"

enum { SAMPLES_A_PIXEL = 2, MOST_LIGHTS = 32, SETS = 6, RUNS = 5 };
static const int light_counts[SETS] = { 1, 2, 4, 8, 16, 32 };

static volatile sig_atomic_t interrupted;
static void on_interrupt(int number) {
    interrupted = 1;
    signal(number, SIG_DFL);
}

typedef struct options {
    const char *out, *keep, *mesh, *up, *environment;
    int        rays, size, paths, directions, threads;
    double     fineness;
} options;

/* Lights in groups: set k of the lights around the scene is groups 0 ... k, at 1/light_counts[k] of their colour. */
typedef struct rig {
    const char      *name;
    int             light_count, group_count, group[MOST_LIGHTS];
    prt_point_light lights[MOST_LIGHTS];
} rig;

enum { AROUND, SKY, RIGS };

/* What a scene looks like without approximation: at the samples of the view, and at the vertices. */
typedef struct truth { const rig *lights; prt_rgb *pixels[PATH_HALVES], *vertices[PATH_HALVES]; double seconds; } truth;

typedef struct score { double rmse, ssim; } score;

typedef struct stage {                 /* one scene with everything about it */
    const char    *name;
    scene         shining, matte;      /* the same mesh */
    embree_tracer tracer;
    techniques    baked;
    view          seen;
    path_query    *pixel_queries, *vertex_queries;
    rig           rigs[RIGS];
    truth         truths[2][RIGS];     /* [matte][rig] */
    score         scores[2][RIGS][TECHNIQUE_COUNT][SETS], at_vertices[2][RIGS][SETS];
    double        noise[2][RIGS][SETS];
    double        seconds[TECHNIQUE_COUNT][SETS];          /* of shading all vertices, shining, lights around */
} stage;

enum { LIGHT_SIZES = 4, STRENGTHS = 8, CAPS = 6, LAWS = 4, SKY_COUNTS = 8, SKY_TRUTH = PATH_LIGHTS };
static const double light_sizes[LIGHT_SIZES] = { 0, 5, 15, 30 };       /* radii, degrees */
static const double strengths[STRENGTHS] = { 0.5, 1, 1.5, 2, 3, 4, 5.5, 8 }, cap_angles[CAPS] = { 1, 5, 10, 20, 30, 45 };
static const int sky_counts[SKY_COUNTS] = { 1, 2, 4, 8, 16, 32, 64, SKY_TRUTH };

typedef struct law_study {
    shadow_error none[LIGHT_SIZES], ao[LIGHT_SIZES], sine[STRENGTHS][LIGHT_SIZES], cap[CAPS][LIGHT_SIZES];
} law_study;

enum { SPLITS = 6 };
static const int split_counts[SPLITS] = { 6, 12, 24, 48, 96, 192 };
typedef struct split_study {
    shadow_error sine, strong, cap, wide;                  /* N = 1.5 and 4; lights of 5 and 20 degrees */
    int          occluders;            /* of the scene */
    double       seen, bake_seconds, seconds;              /* seen: a vertex, mean; seconds: VO/DD, cap law, 8 lights */
} split_study;

typedef struct study {
    options   o;
    split_study splits[SPLITS];
    stage     shapes, statue, ball, glass;
    law_study laws;
    image     sky;
    score     ball_scores[LAWS], glass_scores[LAWS];
    double    sky_errors[SKY_COUNTS];
    double    ball_noise, glass_noise;
    double    ch_differs;              /* CH with its Gram matrix against SH, relative */
    double    loop_seconds, batch_seconds;
    double    packed_seconds, packed_differs, diffuse_seconds, packed_diffuse_seconds, packed_diffuse_differs;   /* 8 lights */
} study;

static const prt_rgb background = { (prt_real)0.03, (prt_real)0.03, (prt_real)0.035 };

/* ---- lights ---- */

static void light_from_around(rig *r) {
    int k, g;
    r->name = "around";
    r->light_count = MOST_LIGHTS;
    r->group_count = SETS;
    point_lights_around(MOST_LIGHTS, vec(0, 0, 0.4), 5, r->lights);
    for (k = 0; k < MOST_LIGHTS; k++) {
        for (g = 0; k >= light_counts[g]; g++) {}
        r->group[k] = g;
    }
}

static int light_from_sky(const image *sky, rig *r, why *w) {
    r->name = "environment";
    r->light_count = MOST_LIGHTS;
    r->group_count = 1;
    return point_lights_from_map(sky, MOST_LIGHTS, 100, r->lights, w);
}

/* The lights of a set, in the colours that they have in it; returns their number. */
static int lights_of(const rig *r, int set, prt_point_light *lights) {
    int count = r->group_count == 1 ? r->light_count : light_counts[set], k;
    for (k = 0; k < count; k++) {
        lights[k] = r->lights[k];
        if (r->group_count > 1) lights[k].color = rgb_scale(lights[k].color, 1.0 / count);
    }
    return count;
}

static int sets_of(const rig *r) { return r->group_count == 1 ? 1 : SETS; }

/* ---- truth ---- */

static void ask(stage *s) {
    int count = s->seen.width * s->seen.height, k;
    for (k = 0; k < count; k++) {
        path_query *q = &s->pixel_queries[k];
        prt_point at;
        q->part = s->seen.hits[k].object;
        if (q->part < 0) continue;
        at = scene_place(&s->shining, &s->seen.hits[k]);
        q->position = rgb_mean(s->shining.parts[q->part].material.transmissive) > 0 ? scene_place_flat(&s->shining, &s->seen.hits[k])
                                                                                    : at.position;
        q->normal = at.normal;
        q->towards = s->seen.rays[k].dir;
    }
    for (k = 0; k < s->shining.mesh.point_count; k++) {
        path_query *q = &s->vertex_queries[k];
        q->part = scene_part_of_point(&s->shining, k);
        q->position = s->shining.mesh.points[k].position;
        q->normal = s->shining.mesh.points[k].normal;
        q->towards = vec_unit(vec_add(q->position, -1, s->seen.eye.eye), vec(0, 0, -1));
    }
}

static int trace_some(const study *d, const stage *s, int matte, const rig *lights, const char *where, int count,
                      const path_query *queries, int samples, int photons, prt_rgb *out[PATH_HALVES], double *seconds,
                      why *w) {
    char path[1024], what[96];
    double before = processor_seconds();
    path_reference r;
    int half;
    for (half = 0; half < PATH_HALVES; half++) {
        out[half] = (prt_rgb *)malloc((size_t)count * (size_t)lights->group_count * sizeof(prt_rgb));
        if (!out[half]) return why_set(w, "out of memory for the reference");
    }
    snprintf(path, sizeof path, "%s/vo-%s-%s-%s-%s.paths", d->o.keep, s->name, matte ? "matte" : "shining", lights->name, where);
    snprintf(what, sizeof what, "reference: %s, %s, lights %s, %s", s->name, matte ? "matte" : "shining", lights->name, where);
    memset(&r, 0, sizeof r);
    r.scene = matte ? &s->matte : &s->shining;
    r.tracer = &s->tracer.tracer;
    r.light_count = lights->light_count;
    r.lights = lights->lights;
    r.group = lights->group;
    r.group_count = lights->group_count;
    r.samples = samples;
    r.photons = photons;
    r.depth = 6;
    r.bias = (prt_real)1e-4;
    r.seed = 1;
    r.threads = d->o.threads;
    r.what = what;
    r.stop = &interrupted;
    r.query_count = count;
    r.queries = queries;
    r.out[0] = out[0];
    r.out[1] = out[1];
    if (path_reference_resume(&r, path, w)) return -1;
    *seconds += processor_seconds() - before;
    return r.done == count ? 0 : why_set(w, "interrupted; the reference so far is kept in %s, start again to go on", path);
}

static int trace_truth(const study *d, stage *s, int matte, int which, why *w) {
    truth *t = &s->truths[matte][which];
    t->lights = &s->rigs[which];
    return trace_some(d, s, matte, t->lights, "pixels", s->seen.width * s->seen.height, s->pixel_queries, d->o.paths, 0,
                      t->pixels, &t->seconds, w) ||
           trace_some(d, s, matte, t->lights, "vertices", s->shining.mesh.point_count, s->vertex_queries, 4 * d->o.paths,
                      0, t->vertices, &t->seconds, w) ? -1 : 0;
}

/* One half of a set: the sum of its groups. */
static prt_rgb sum_groups(const truth *t, const prt_rgb *values, size_t at, int set) {
    int groups = t->lights->group_count, g;
    prt_rgb sum = rgb(0, 0, 0);
    for (g = 0; g < groups && (groups == 1 || g <= set); g++) {
        prt_rgb one = values[at * (size_t)groups + (size_t)g];
        sum = rgb((double)(sum.r + one.r), (double)(sum.g + one.g), (double)(sum.b + one.b));
    }
    return groups == 1 ? sum : rgb_scale(sum, 1.0 / light_counts[set]);
}

static int paint_truth(const stage *s, const truth *t, int set, int half, picture *to, why *w) {
    size_t count = (size_t)s->seen.width * (size_t)s->seen.height, k;
    prt_rgb *colors = (prt_rgb *)calloc((size_t)s->shining.mesh.point_count, sizeof *colors);
    int failed = !colors || view_paint(&s->seen, &s->shining, colors, background, to, w);
    free(colors);
    if (failed) return why_set(w, "out of memory for a picture");
    for (k = 0; k < count; k++) {
        prt_rgb c;
        if (s->seen.hits[k].object < 0) continue;
        c = sum_groups(t, t->pixels[half], k, set);
        to->rgba[4 * k] = (float)c.r; to->rgba[4 * k + 1] = (float)c.g; to->rgba[4 * k + 2] = (float)c.b;
    }
    return 0;
}

/* The truth at the vertices, interpolated: what no technique at the vertices can do better than. */
static int paint_vertices(const stage *s, const truth *t, int set, int half, picture *to, why *w) {
    int count = s->shining.mesh.point_count, k, failed;
    prt_rgb *colors = (prt_rgb *)malloc((size_t)count * sizeof *colors);
    if (!colors) return why_set(w, "out of memory for a picture");
    for (k = 0; k < count; k++) colors[k] = sum_groups(t, t->vertices[half], (size_t)k, set);
    failed = view_paint(&s->seen, &s->shining, colors, background, to, w);
    free(colors);
    return failed;
}

/* The mean of two pictures, in the first. */
static void merge(picture *a, const picture *b) {
    size_t count = 4 * (size_t)a->width * (size_t)a->height, k;
    for (k = 0; k < count; k++) a->rgba[k] = 0.5f * (a->rgba[k] + b->rgba[k]);
}

/* ---- one technique ---- */

static int paint(stage *s, int matte, int which, int set, technique how, picture *to, double *seconds, why *w) {
    prt_point_light lights[MOST_LIGHTS];
    int count = lights_of(&s->rigs[which], set, lights), failed;
    prt_rgb *colors = (prt_rgb *)malloc((size_t)s->shining.mesh.point_count * sizeof *colors);
    if (!colors) return why_set(w, "out of memory for a picture");
    s->baked.matte = matte;
    failed = techniques_shade(&s->baked, how, s->seen.eye.eye, vec(0, 0, 0.4), count, lights, colors, seconds, w) ||
             (to && view_paint(&s->seen, &s->shining, colors, background, to, w));
    free(colors);
    return failed ? -1 : 0;
}

/* SH and CH have no answer to shining surfaces here, and without shine DS and SS add nothing. */
static int takes_part(int matte, technique how) {
    return matte ? how != TECHNIQUE_VO && how != TECHNIQUE_VO_CAP : how < TECHNIQUE_SH3;
}

static const float whole = 1;          /* alpha of what counts: surfaces that let nothing through */

static score compare(const picture *p, const picture r[PATH_HALVES], const picture *mean) {
    score s;
    s.rmse = reference_error(p, p, &r[0], &r[1], SAMPLES_A_PIXEL, whole);
    s.ssim = picture_similarity(p, mean, SAMPLES_A_PIXEL, picture_exposure(mean) / 3, whole);
    return s;
}

static int measure_set(stage *s, int matte, int which, int set, why *w) {
    const truth *t = &s->truths[matte][which];
    picture r[PATH_HALVES], v[PATH_HALVES], mean, p;
    int how, failed = 0;
    memset(r, 0, sizeof r);
    memset(v, 0, sizeof v);
    memset(&mean, 0, sizeof mean);
    if (paint_truth(s, t, set, 0, &r[0], w) || paint_truth(s, t, set, 1, &r[1], w) || paint_truth(s, t, set, 0, &mean, w) ||
        paint_vertices(s, t, set, 0, &v[0], w) || paint_vertices(s, t, set, 1, &v[1], w)) return -1;
    merge(&mean, &r[1]);
    s->noise[matte][which][set] = 0.5 * reference_error(&r[0], &r[0], &r[1], &r[1], SAMPLES_A_PIXEL, whole);
    s->at_vertices[matte][which][set].rmse = reference_error(&v[0], &v[1], &r[0], &r[1], SAMPLES_A_PIXEL, whole);
    merge(&v[0], &v[1]);
    s->at_vertices[matte][which][set].ssim = compare(&v[0], r, &mean).ssim;
    for (how = 0; how < TECHNIQUE_COUNT && !failed; how++) {
        if (!takes_part(matte, (technique)how)) continue;
        memset(&p, 0, sizeof p);
        failed = paint(s, matte, which, set, (technique)how, &p, NULL, w);
        if (!failed) s->scores[matte][which][how][set] = compare(&p, r, &mean);
        picture_free(&p);
    }
    picture_free(&r[0]); picture_free(&r[1]); picture_free(&v[0]); picture_free(&v[1]); picture_free(&mean);
    return failed;
}

static int measure(const study *d, stage *s, int matte, int which, why *w) {
    int set;
    if (trace_truth(d, s, matte, which, w)) return -1;
    for (set = 0; set < sets_of(&s->rigs[which]); set++) if (measure_set(s, matte, which, set, w)) return -1;
    return interrupted ? why_set(w, "interrupted") : 0;
}

/* Shining, lights around: every technique and number of lights in turns, the least of some runs. */
static int time_shading(stage *s, why *w) {
    int run, set, how;
    for (run = 0; run < RUNS; run++) {
        for (set = 0; set < SETS; set++) {
            for (how = 0; how < TECHNIQUE_COUNT; how++) {
                double seconds;
                if (paint(s, 0, AROUND, set, (technique)how, NULL, &seconds, w)) return -1;
                if (run == 0 || seconds < s->seconds[how][set]) s->seconds[how][set] = seconds;
            }
        }
    }
    return 0;
}

/* What the ways of shading all vertices of the shapes under 8 lights cost. */
typedef struct shading {
    const techniques      *t;
    prt_vo_params         params;
    prt_vec3              eye;
    prt_real              unit;
    int                   light_count;
    prt_point_light       lights[MOST_LIGHTS];
    prt_vo_packed         *packed;
    prt_vo_packed_diffuse *packed_diffuse;
} shading;

typedef void (*shading_way)(const shading *s, prt_rgb *out);

static void shade_one_by_one(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    int k;
    for (k = 0; k < t->scene->mesh.point_count; k++)
        prt_vo_shade(&s->params, &t->points[k], s->eye, t->first[k + 1] - t->first[k], t->occluders + t->first[k], s->light_count, s->lights,
                     &out[k]);
}
static void shade_batch(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    prt_vo_shade_n(&s->params, t->scene->mesh.point_count, t->points, s->eye, t->first, t->occluders, s->light_count, s->lights, out);
}
static void shade_packed(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    prt_vo_shade_packed_n(&s->params, s->unit, t->scene->mesh.point_count, t->points, s->eye, t->first, s->packed, s->light_count, s->lights,
                          out);
}
static void shade_packed_diffuse(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    prt_vo_shade_packed_diffuse_n(&s->params, s->unit, t->scene->mesh.point_count, t->points, s->eye, t->first, s->packed_diffuse,
                                  s->light_count, s->lights, out);
}

static double least_time(const shading *s, shading_way way, prt_rgb *out) {
    double least = 0;
    int run;
    for (run = 0; run < 2 * RUNS; run++) {
        double seconds = processor_seconds();
        way(s, out);
        seconds = processor_seconds() - seconds;
        if (run == 0 || seconds < least) least = seconds;
    }
    return least;
}

/* Root mean square of a - b relative to that of b. */
static double difference(int count, const prt_rgb *a, const prt_rgb *b) {
    double square = 0, all = 0;
    int k;
    for (k = 0; k < count; k++) {
        square += pow((double)(a[k].r - b[k].r), 2) + pow((double)(a[k].g - b[k].g), 2) + pow((double)(a[k].b - b[k].b), 2);
        all += pow((double)b[k].r, 2) + pow((double)b[k].g, 2) + pow((double)b[k].b, 2);
    }
    return sqrt(square / all);
}

static int pack(const techniques *t, shading *s, why *w) {
    int k, count;
    s->packed = (prt_vo_packed *)malloc((size_t)t->occluder_count * sizeof *s->packed + 1);
    s->packed_diffuse = (prt_vo_packed_diffuse *)malloc((size_t)t->occluder_count * sizeof *s->packed_diffuse + 1);
    if (!s->packed || !s->packed_diffuse) return why_set(w, "out of memory for packed occluders");
    for (k = 0; k < t->scene->mesh.point_count; k++) {
        prt_vec3 at = t->points[k].position;
        count = t->first[k + 1] - t->first[k];
        if (prt_vo_pack(s->unit, at, count, t->occluders + t->first[k], s->packed + t->first[k]) != PRT_OK ||
            prt_vo_pack_diffuse(s->unit, at, count, t->occluders + t->first[k], s->packed_diffuse + t->first[k]) != PRT_OK)
            return why_set(w, "the occluders of vertex %d cannot be packed", k);
    }
    return 0;
}

static int time_forms(study *d, why *w) {
    const techniques *t = &d->shapes.baked;
    int points = t->scene->mesh.point_count, failed;
    prt_rgb *out = (prt_rgb *)malloc(2 * (size_t)points * sizeof *out), *other = out + points;
    shading s;
    memset(&s, 0, sizeof s);
    s.t = t;
    s.eye = d->shapes.seen.eye.eye;
    s.unit = t->scene->mesh.report.radius;
    s.light_count = lights_of(&d->shapes.rigs[AROUND], 3, s.lights);
    s.params.off = PRT_VO_NO_CAUSTIC;
    failed = out ? pack(t, &s, w) : why_set(w, "out of memory");
    if (!failed) {
        d->loop_seconds = least_time(&s, shade_one_by_one, out);
        d->batch_seconds = least_time(&s, shade_batch, out);
        d->packed_seconds = least_time(&s, shade_packed, other);
        d->packed_differs = difference(points, other, out);
        s.params.off |= PRT_VO_NO_DS | PRT_VO_NO_SS;
        d->diffuse_seconds = least_time(&s, shade_batch, out);
        d->packed_diffuse_seconds = least_time(&s, shade_packed_diffuse, other);
        d->packed_diffuse_differs = difference(points, other, out);
    }
    free(s.packed);
    free(s.packed_diffuse);
    free(out);
    return failed;
}

/* The largest difference between SH and CH used with its Gram matrix, over exit radiance at the vertices. */
static int compare_ch(study *d) {
    const techniques *t = &d->shapes.baked;
    const rig *r = &d->shapes.rigs[AROUND];
    enum { BANDS = 6, N = BANDS * BANDS };
    prt_real light_sh[N], light[N], y[N], ch[N];
    double most = 0, square = 0;
    int k, i;
    memset(light, 0, sizeof light);
    memset(light_sh, 0, sizeof light_sh);
    for (k = 0; k < r->light_count; k++) {
        prt_vec3 dir = vec_unit(r->lights[k].position, vec(0, 0, 1));
        prt_ch_eval(BANDS, dir, y);
        for (i = 0; i < N; i++) light[i] += y[i];
        prt_sh_delta(BANDS, dir, y);
        for (i = 0; i < N; i++) light_sh[i] += y[i];
    }
    for (k = 0; k < d->shapes.shining.mesh.point_count; k++) {
        const prt_real *row = t->transfer[1] + (size_t)k * 3 * N;
        double by_sh = (double)prt_sh_dot(BANDS, row, light_sh), by_ch = 0;
        prt_ch_from_sh(BANDS, row, ch);
        for (i = 0; i < N; i++) by_ch += (double)ch[i] * (double)light[i];
        if (fabs(by_ch - by_sh) > most) most = fabs(by_ch - by_sh);
        square += by_sh * by_sh;
    }
    d->ch_differs = most / sqrt(square / d->shapes.shining.mesh.point_count);
    return 0;
}

/* ---- stages ---- */

static int size_of_samples(const study *d) { return d->o.size * SAMPLES_A_PIXEL; }

/* For what is not timed. */
static int few_rays(const study *d) { return d->o.rays < 2048 ? d->o.rays : 2048; }

static int bake_stage(const study *d, stage *s, int with_sh, int full, why *w) {
    s->baked.scene = &s->shining;
    s->baked.tracer = &s->tracer;
    s->baked.rays = full ? d->o.rays : few_rays(d);
    s->baked.threads = d->o.threads;
    s->baked.most_occluders = SCENE_PARTS;
    s->baked.bias = (prt_real)1e-4;
    s->baked.shining = 1;
    s->baked.with_sh = with_sh;
    s->baked.with_time_of_dd = full;
    s->baked.stop = &interrupted;
    return techniques_bake(&s->baked, w);
}

static int set_up(const study *d, stage *s, const char *name, camera eye, int with_sh, why *w) {
    int samples = size_of_samples(d);
    s->name = name;
    s->matte = s->shining;                                 /* shares the mesh */
    scene_make_matte(&s->matte);
    s->pixel_queries = (path_query *)calloc((size_t)samples * (size_t)samples, sizeof *s->pixel_queries);
    s->vertex_queries = (path_query *)calloc((size_t)s->shining.mesh.point_count, sizeof *s->vertex_queries);
    if (!s->pixel_queries || !s->vertex_queries) return why_set(w, "out of memory");
    if (scene_trace_with(&s->shining, &s->tracer, w) || view_create(&s->shining, &s->tracer, eye, samples, samples, &s->seen, w))
        return -1;
    ask(s);
    light_from_around(&s->rigs[AROUND]);
    return light_from_sky(&d->sky, &s->rigs[SKY], w) || bake_stage(d, s, with_sh, s == &d->shapes, w) ? -1 : 0;
}

static void stage_free(stage *s) {
    int matte, which, half;
    techniques_free(&s->baked);
    view_free(&s->seen);
    embree_tracer_destroy(&s->tracer);
    free(s->pixel_queries);
    free(s->vertex_queries);
    for (matte = 0; matte < 2; matte++)
        for (which = 0; which < RIGS; which++)
            for (half = 0; half < PATH_HALVES; half++) {
                free(s->truths[matte][which].pixels[half]);
                free(s->truths[matte][which].vertices[half]);
            }
    scene_free(&s->shining);
}

/* ---- pictures ---- */

enum { MOST_COLUMNS = TECHNIQUE_COUNT + 1, MOST_ROWS = 4 };

typedef struct sheet_row { stage *s; int which, set; const char *name; } sheet_row;

/* The mean of both halves. */
static int paint_reference(const stage *s, int matte, int which, int set, picture *to, why *w) {
    picture other;
    memset(&other, 0, sizeof other);
    if (paint_truth(s, &s->truths[matte][which], set, 0, to, w) || paint_truth(s, &s->truths[matte][which], set, 1, &other, w))
        return -1;
    merge(to, &other);
    picture_free(&other);
    return 0;
}

static void caption(sheet_cell *cell, const score *s) {
    snprintf(cell->first, sizeof cell->first, "RMSE %.1f %%", 100 * s->rmse);
    snprintf(cell->second, sizeof cell->second, "SSIM %.3f", s->ssim);
}

/* One row: the reference, then the techniques in order. */
static int fill_row(const sheet_row *row, int matte, int columns, const technique *order, picture *pictures, sheet_cell *cells,
                    why *w) {
    int k;
    if (paint_reference(row->s, matte, row->which, row->set, &pictures[0], w)) return -1;
    cells[0].shown = &pictures[0];
    snprintf(cells[0].first, sizeof cells[0].first, "noise %.1f %%", 100 * row->s->noise[matte][row->which][row->set]);
    snprintf(cells[0].second, sizeof cells[0].second, "%.0f s", row->s->truths[matte][row->which].seconds);
    for (k = 1; k < columns; k++) {
        if (paint(row->s, matte, row->which, row->set, order[k - 1], &pictures[k], NULL, w)) return -1;
        cells[k].shown = &pictures[k];
        caption(&cells[k], &row->s->scores[matte][row->which][order[k - 1]][row->set]);
    }
    return 0;
}

static int write_sheet(const study *d, const char *file, const char *title, int matte, int rows, const sheet_row *row, int columns,
                       const technique *order, why *w) {
    static picture pictures[MOST_ROWS * MOST_COLUMNS];
    static sheet_cell cells[MOST_ROWS * MOST_COLUMNS];
    const char *heads[MOST_COLUMNS], *names[MOST_ROWS];
    double exposures[MOST_ROWS];
    char path[1024];
    contact_sheet s;
    int k, failed = 0;
    memset(&s, 0, sizeof s);
    memset(pictures, 0, sizeof pictures);
    memset(cells, 0, sizeof cells);
    heads[0] = "path traced";
    for (k = 1; k < columns; k++) heads[k] = technique_names[order[k - 1]];
    for (k = 0; k < rows && !failed; k++) {
        failed = fill_row(&row[k], matte, columns, order, pictures + k * columns, cells + k * columns, w);
        names[k] = row[k].name;
        exposures[k] = failed ? 1 : picture_exposure(&pictures[k * columns]);
    }
    s.title = title;
    s.rows = rows;
    s.columns = columns;
    s.per_pixel = SAMPLES_A_PIXEL;
    s.width = s.height = d->o.size;
    s.heads = heads;
    s.names = names;
    s.exposures = exposures;
    s.cells = cells;
    s.foot[0] = "RMSE: of linear radiance over the pixels of the scene, relative to the mean of the path-traced picture. All techniques "
                "shade vertices.";
    s.foot[1] = matte ? "CH3 and CH6 use inner products as coefficients, as the thesis does; with its Gram matrix CH gives the pictures of SH."
                      : NULL;
    snprintf(path, sizeof path, "%s/gallery/%s", d->o.out, file);
    if (!failed) failed = contact_sheet_write(&s, path, w);
    for (k = 0; k < rows * columns; k++) picture_free(&pictures[k]);
    if (!failed) printf("%s\n", path);
    return failed;
}

static int write_sheets(study *d, why *w) {
    static const technique all[] = { TECHNIQUE_VO_DD, TECHNIQUE_VO_DD_CAP, TECHNIQUE_SH6, TECHNIQUE_SH3, TECHNIQUE_CH6, TECHNIQUE_CH3,
                                     TECHNIQUE_AO, TECHNIQUE_PHONG };
    static const technique shining[] = { TECHNIQUE_VO, TECHNIQUE_VO_CAP, TECHNIQUE_VO_DD, TECHNIQUE_AO, TECHNIQUE_PHONG };
    sheet_row matte[3], bright[3];
    int k;
    for (k = 0; k < 3; k++) {
        matte[k].s = k == 2 ? &d->statue : &d->shapes;
        matte[k].which = k == 0 ? AROUND : SKY;
        matte[k].set = 0;
        bright[k].s = &d->shapes;
        bright[k].which = k == 2 ? SKY : AROUND;
        bright[k].set = k == 1 ? 3 : 0;
    }
    matte[0].name = "shapes\n1 point light";
    matte[1].name = "shapes\nsky as 32 lights";
    matte[2].name = "statue\nsky as 32 lights";
    bright[0].name = "shapes\n1 point light";
    bright[1].name = "shapes\n8 point lights";
    bright[2].name = "shapes\nsky as 32 lights";
    return write_sheet(d, "vo.jpg", "Vector occluders beside other techniques, diffuse scenes", 1, 3, matte, 9, all, w) ||
           write_sheet(d, "vo-shining.jpg", "Vector occluders, shining scene", 0, 3, bright, 6, shining, w) ? -1 : 0;
}

/* ---- plots ---- */

enum { MOST_SERIES = 8, MOST_PLACES = 128 };

typedef struct plot {
    const char *title, *across, *up, *more;                /* more: further commands of gnuplot */
    int        series, places;
    const char *names[MOST_SERIES];
    double     x[MOST_PLACES], y[MOST_SERIES][MOST_PLACES];
} plot;

static int draw_plot(const study *d, const char *file, const plot *p, why *w) {
    FILE *to = popen("gnuplot 2>/dev/null", "w");
    int k, i;
    if (!to) return why_set(w, "gnuplot cannot be started: install gnuplot-nox");
    fprintf(to, "set terminal svg size 760,420 background rgb 'white'\nset output '%s/plots/%s'\nset title '%s'\nset xlabel '%s'\n"
            "set ylabel '%s'\nset grid\nset key outside right\n%s\nplot ", d->o.out, file, p->title, p->across, p->up, p->more);
    for (k = 0; k < p->series; k++)
        fprintf(to, "%s'-' with %s lw 2 title '%s'", k ? ", " : "", p->places > 20 ? "lines" : "linespoints", p->names[k]);
    fprintf(to, "\n");
    for (k = 0; k < p->series; k++) {
        for (i = 0; i < p->places; i++) fprintf(to, "%g %g\n", p->x[i], p->y[k][i]);
        fprintf(to, "e\n");
    }
    return pclose(to) == 0 ? 0 : why_set(w, "%s/plots/%s: cannot be drawn: gnuplot is missing or failed; install gnuplot-nox", d->o.out, file);
}

/* ---- shadow laws ---- */

static const double degree = 3.14159265358979323846 / 180;

static prt_vo_params sine_law(double strength) {
    prt_vo_params p;
    memset(&p, 0, sizeof p);
    p.shadow_strength = (prt_real)strength;
    return p;
}

static prt_vo_params cap_law(double degrees) {
    prt_vo_params p;
    memset(&p, 0, sizeof p);
    p.law = PRT_VO_CAP;
    p.light_angle = (prt_real)(degrees * degree);
    return p;
}

static int study_laws(study *d, why *w) {
    law_study *l = &d->laws;
    int a, k;
    for (a = 0; a < LIGHT_SIZES; a++) {
        shadow_truth traced;
        int failed = shadow_truth_trace(&d->shapes.baked, d->o.directions, light_sizes[a] * degree, &traced, w);
        if (!failed) {
            l->none[a] = shadow_law_error(&d->shapes.baked, &traced, NULL);
            l->ao[a] = shadow_ao_error(&d->shapes.baked, &traced);
            for (k = 0; k < STRENGTHS; k++) {
                prt_vo_params p = sine_law(strengths[k]);
                l->sine[k][a] = shadow_law_error(&d->shapes.baked, &traced, &p);
            }
            for (k = 0; k < CAPS; k++) {
                prt_vo_params p = cap_law(cap_angles[k]);
                l->cap[k][a] = shadow_law_error(&d->shapes.baked, &traced, &p);
            }
        }
        shadow_truth_free(&traced);
        if (failed) return -1;
    }
    return 0;
}

/* One occluder of form factor 1/4, as figure 7.7: a cap of 30 degrees, the light on its way from its middle outwards. */
static int plot_laws(const study *d, why *w) {
    static plot p;
    prt_vo_params laws[3];
    int i;
    laws[0] = sine_law(1.5);
    laws[1] = sine_law(5.5);
    laws[2] = cap_law(5);
    p.title = "Light that one round occluder of form factor 1/4 lets through";
    p.across = "angle between occlusion vector and light, degrees";
    p.up = "share of the light";
    p.more = "set yrange [-0.02:1.02]\nset xrange [0:90]";
    p.series = 5;
    p.places = 91;
    p.names[0] = "sine law, N = 1.5"; p.names[1] = "sine law, N = 5.5"; p.names[2] = "cap law, light of 5 deg";
    p.names[3] = "truth, light of 5 deg"; p.names[4] = "truth, point light";
    for (i = 0; i < p.places; i++) {
        int k;
        p.x[i] = i;
        for (k = 0; k < 3; k++) p.y[k][i] = shadow_law_of_cap(&laws[k], 30 * degree, i * degree);
        p.y[3][i] = shadow_truth_of_cap(30 * degree, 5 * degree, i * degree);
        p.y[4][i] = shadow_truth_of_cap(30 * degree, 0, i * degree);
    }
    return draw_plot(d, "vo-laws.svg", &p, w);
}

/* A ball over a platform under one low light, direct light alone: the pointy shadows of section 7.7.2. */
static int paint_law(stage *s, const prt_vo_params *law, const prt_point_light *light, picture *to, why *w) {
    int points = s->shining.mesh.point_count, failed;
    prt_rgb *colors = (prt_rgb *)malloc((size_t)points * sizeof *colors);
    if (!colors) return why_set(w, "out of memory for a picture");
    failed = prt_vo_shade_n(law, points, s->baked.points, s->seen.eye.eye, s->baked.first, s->baked.occluders, 1, light, colors) != PRT_OK ||
             view_paint(&s->seen, &s->shining, colors, background, to, w);
    free(colors);
    return failed ? why_set(w, "%s cannot be painted", s->name) : 0;
}

/* A scene under its one light, traced and by each law: one row. */
static int study_one_light(const study *d, stage *s, int paths, int photons, const prt_vo_params *laws, const char *const *heads,
                           const char *title, const char *row, const char *file, score *scores, double *noise, why *w) {
    picture pictures[LAWS + 1], halves[PATH_HALVES];
    sheet_cell cells[LAWS + 1];
    contact_sheet sheet;
    truth *t = &s->truths[1][AROUND];
    char path[1024];
    double exposure;
    int k, failed;
    memset(pictures, 0, sizeof pictures);
    memset(halves, 0, sizeof halves);
    memset(cells, 0, sizeof cells);
    memset(&sheet, 0, sizeof sheet);
    t->lights = &s->rigs[AROUND];
    failed = trace_some(d, s, 1, t->lights, "pixels", s->seen.width * s->seen.height, s->pixel_queries, paths, photons, t->pixels,
                        &t->seconds, w) ||
             paint_truth(s, t, 0, 0, &halves[0], w) || paint_truth(s, t, 0, 1, &halves[1], w) ||
             paint_reference(s, 1, AROUND, 0, &pictures[0], w);
    for (k = 0; k < LAWS && !failed; k++) {
        failed = paint_law(s, &laws[k], &s->rigs[AROUND].lights[0], &pictures[k + 1], w);
        if (failed) break;
        scores[k] = compare(&pictures[k + 1], halves, &pictures[0]);
        caption(&cells[k + 1], &scores[k]);
    }
    *noise = failed ? 0 : 0.5 * reference_error(&halves[0], &halves[0], &halves[1], &halves[1], SAMPLES_A_PIXEL, whole);
    for (k = 0; k <= LAWS; k++) cells[k].shown = &pictures[k];
    exposure = failed ? 1 : picture_exposure(&pictures[0]);
    sheet.title = title;
    sheet.rows = 1; sheet.columns = LAWS + 1; sheet.per_pixel = SAMPLES_A_PIXEL;
    sheet.width = sheet.height = d->o.size;
    sheet.heads = heads; sheet.names = &row; sheet.exposures = &exposure; sheet.cells = cells;
    snprintf(path, sizeof path, "%s/gallery/%s", d->o.out, file);
    if (!failed) failed = contact_sheet_write(&sheet, path, w);
    for (k = 0; k <= LAWS; k++) picture_free(&pictures[k]);
    picture_free(&halves[0]);
    picture_free(&halves[1]);
    if (!failed) printf("%s\n", path);
    return failed ? -1 : 0;
}

static void light_alone(stage *s, const char *name, prt_vec3 position) {
    rig *r = &s->rigs[AROUND];
    r->name = name;
    r->light_count = r->group_count = 1;
    r->group[0] = 0;
    r->lights[0].position = position;
    r->lights[0].color = rgb(1, 1, 1);
}

static int study_ball(study *d, why *w) {
    static const char *const heads[LAWS + 1] = { "traced", "sine law, N = 1.5", "sine law, N = 5.5", "cap law, light of 5°",
                                                 "cap law, light of 20°" };
    prt_vo_params laws[LAWS];
    int k;
    laws[0] = sine_law(1.5);
    laws[1] = sine_law(5.5);
    laws[2] = cap_law(5);
    laws[3] = cap_law(20);
    for (k = 0; k < LAWS; k++) laws[k].off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS;
    light_alone(&d->ball, "low", vec(-5, -1.5, 2.6));
    return study_one_light(d, &d->ball, 0, 0, laws, heads, "Shadow laws: one ball, one low light, direct light alone",
                           "ball\n1 low light", "vo-laws.jpg", d->ball_scores, &d->ball_noise, w);
}

/* Caustics: errors are of what is not glass itself. */
static int study_glass(study *d, why *w) {
    static const char *const heads[LAWS + 1] = { "paths and photons", "VO, sine law", "VO, cap law", "VO without caustics", "Phong" };
    prt_vo_params laws[LAWS];
    int k;
    for (k = 0; k < LAWS; k++) laws[k] = k == 1 ? cap_law(5) : sine_law(1.5);
    laws[2].off = PRT_VO_NO_CAUSTIC;
    laws[3].off = PRT_VO_NO_SHADOW | PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD;
    light_alone(&d->glass, "above", vec(-2.5, 1.5, 4.5));
    return study_one_light(d, &d->glass, d->o.paths, 2000 * d->o.paths, laws, heads, "Caustics: balls of glass under one light",
                           "glass\n1 point light", "vo-glass.jpg", d->glass_scores, &d->glass_noise, w);
}

/* ---- splitting ---- */

/* The shapes cut into more and more occluders: shadows against traced ones, what it costs. */
static int study_split(study *d, int which, why *w) {
    split_study *p = &d->splits[which];
    shadow_truth traced;
    techniques t;
    prt_vo_params law;
    prt_point_light lights[MOST_LIGHTS];
    int count = lights_of(&d->shapes.rigs[AROUND], 3, lights), failed, run;
    prt_rgb *out;
    memset(&t, 0, sizeof t);
    t.scene = &d->shapes.matte;
    t.tracer = &d->shapes.tracer;
    t.rays = few_rays(d);
    t.threads = d->o.threads;
    t.most_occluders = t.occluders_wanted = split_counts[which];
    t.bias = (prt_real)1e-4;
    t.stop = &interrupted;
    out = (prt_rgb *)malloc((size_t)t.scene->mesh.point_count * sizeof *out);
    memset(&traced, 0, sizeof traced);
    failed = !out || techniques_bake(&t, w) || shadow_truth_trace(&t, d->o.directions, 0, &traced, w);
    if (!failed) {
        law = sine_law(1.5);
        p->sine = shadow_law_error(&t, &traced, &law);
        law = sine_law(4);
        p->strong = shadow_law_error(&t, &traced, &law);
        law = cap_law(5);
        p->cap = shadow_law_error(&t, &traced, &law);
        law = cap_law(20);
        p->wide = shadow_law_error(&t, &traced, &law);
        p->occluders = t.group_count;
        p->seen = (double)t.occluder_count / t.scene->mesh.point_count;
        p->bake_seconds = t.vo_seconds;
        for (run = 0; run < RUNS && !failed; run++) {
            double seconds;
            failed = techniques_shade(&t, TECHNIQUE_VO_DD_CAP, vec(0, 0, 9), vec(0, 0, 0), count, lights, out, &seconds, w);
            if (run == 0 || seconds < p->seconds) p->seconds = seconds;
        }
    }
    shadow_truth_free(&traced);
    techniques_free(&t);
    free(out);
    return failed ? -1 : 0;
}

static int study_splits(study *d, why *w) {
    int k;
    for (k = 0; k < SPLITS; k++) if (study_split(d, k, w)) return -1;
    return 0;
}

static int plot_splits(const study *d, why *w) {
    static plot p;
    int k;
    p.title = "Shadows of the shapes by number of occluders";
    p.across = "occluders that a vertex sees, mean";
    p.up = "RMS error of the shadow factor, point light";
    p.more = "set logscale x\nset yrange [0:*]";
    p.series = 4;
    p.places = SPLITS;
    p.names[0] = "sine law, N = 1.5"; p.names[1] = "sine law, N = 4"; p.names[2] = "cap law, light of 5 deg";
    p.names[3] = "cap law, light of 20 deg";
    for (k = 0; k < SPLITS; k++) {
        const split_study *s = &d->splits[k];
        p.x[k] = s->seen;
        p.y[0][k] = s->sine.rms; p.y[1][k] = s->strong.rms; p.y[2][k] = s->cap.rms; p.y[3][k] = s->wide.rms;
    }
    return draw_plot(d, "vo-split.svg", &p, w);
}

/* ---- how many lights a sky needs ---- */

/* Direct light at the vertices, matte, of the environment as so many point lights; the last is the truth. */
static int study_lights(study *d, why *w) {
    stage *s = &d->shapes;
    int points = s->matte.mesh.point_count, k, i, failed = 0;
    prt_point_light *lights = (prt_point_light *)malloc(SKY_TRUTH * sizeof *lights);
    prt_rgb *out[SKY_COUNTS] = { NULL }, *again = (prt_rgb *)malloc((size_t)points * sizeof *again);
    path_reference r;
    memset(&r, 0, sizeof r);
    r.scene = &s->matte;
    r.tracer = &s->tracer.tracer;
    r.lights = lights;
    r.group_count = 1;
    r.bias = (prt_real)1e-4;
    r.threads = d->o.threads;
    r.stop = &interrupted;
    r.query_count = points;
    r.queries = s->vertex_queries;
    if (!lights || !again) failed = why_set(w, "out of memory for lights");
    for (k = 0; k < SKY_COUNTS && !failed; k++) {
        out[k] = (prt_rgb *)malloc((size_t)points * sizeof(prt_rgb));
        r.light_count = sky_counts[k];
        r.out[0] = out[k];
        r.out[1] = again;
        r.done = 0;
        failed = !out[k] || point_lights_from_map(&d->sky, sky_counts[k], 100, lights, w) || path_reference_trace(&r, w) ||
                 (interrupted && why_set(w, "interrupted"));
    }
    for (k = 0; k < SKY_COUNTS && !failed; k++) {
        double square = 0, sum = 0;
        for (i = 0; i < points; i++) {
            prt_rgb a = out[k][i], b = out[SKY_COUNTS - 1][i];
            square += pow((double)(a.r - b.r), 2) + pow((double)(a.g - b.g), 2) + pow((double)(a.b - b.b), 2);
            sum += (double)(b.r + b.g + b.b);
        }
        d->sky_errors[k] = sqrt(square / (3.0 * points)) / (sum / (3.0 * points));
    }
    for (k = 0; k < SKY_COUNTS; k++) free(out[k]);
    free(lights);
    free(again);
    return failed ? -1 : 0;
}

/* ---- the page ---- */

/* Numbers that shading reads of each occluder: its vectors in the C structure, of three numbers each, and a form factor. */
static int numbers_of(technique how) {
    if (how == TECHNIQUE_VO_DD || how == TECHNIQUE_VO_DD_CAP) return 4 * 3 + 1;
    if (how == TECHNIQUE_VO || how == TECHNIQUE_VO_CAP) return 6 * 3 + 1;
    return 0;
}

static double bytes_of(const study *d, technique how) {
    const techniques *t = &d->shapes.baked;
    double points = t->scene->mesh.point_count;
    if (how == TECHNIQUE_PHONG) return 0;
    if (how == TECHNIQUE_AO) return points * sizeof(prt_real);
    if (how >= TECHNIQUE_SH3) {
        int bands = techniques_bands[how == TECHNIQUE_SH6 || how == TECHNIQUE_CH6];
        return points * 3 * PRT_SH_COUNT(bands) * sizeof(prt_real);
    }
    return (points + 1) * sizeof(int) + (double)t->occluder_count * numbers_of(how) * sizeof(prt_real);
}

static const double mebi = 1048576;

static void bake_times(const techniques *t, technique how, double pass[2]) {
    int six = how == TECHNIQUE_SH6 || how == TECHNIQUE_CH6;
    pass[0] = how == TECHNIQUE_PHONG ? 0 : how >= TECHNIQUE_SH3 ? t->sh_seconds[six][0] : t->ao_seconds;
    pass[1] = how <= TECHNIQUE_AO ? 0 : how <= TECHNIQUE_VO_DD_CAP ? t->vo_dd_seconds : how < TECHNIQUE_SH3 ? t->vo_seconds
              : t->sh_seconds[six][1] + (how >= TECHNIQUE_CH3 ? t->ch_seconds[six] : 0);
}

static void write_table_of_costs(const study *d, FILE *to) {
    static const char *const thesis[TECHNIQUE_COUNT] = { "0, 5500 fps, 0", "58, 5500, 0.019", "58 + 60, 4700, 1.03", "",
        "58 + 85, 3500, 2.05", "", "60 + 63, 5100, 2.07", "62 + 68, 2500, 8.26", "56 + 61, 5100, 2.07", "60 + 66, 2500, 8.26" };
    const stage *s = &d->shapes;
    const double points = s->shining.mesh.point_count;
    int how;
    fprintf(to, "\n## Table 7.1 again\n\nShapes scene: %d triangles, %d vertices, %d parts, %d rays a vertex in each pass. Bake: processor "
            "seconds, pass 1 + pass 2.\nShading: processor time a vertex on one core, all terms that the technique has; *a light more* is the "
            "slope from 1 to 32 lights.\nStorage: what shading reads; a vertex sees %.2f occluders in the mean. RMSE and SSIM: one point light, "
            "diffuse scene (for DD+DS+SS: shining).\n\n| technique | bake s | ns a vertex, 1 light | 8 lights | a light more | bytes a vertex | "
            "MiB | RMSE | SSIM | thesis: bake s, frame rate, MB |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---|\n",
            s->shining.mesh.triangle_count, s->shining.mesh.point_count, s->shining.part_count, d->o.rays,
            s->baked.occluder_count / points);
    for (how = 0; how < TECHNIQUE_COUNT; how++) {
        const double *seconds = s->seconds[how];
        double pass[2], bytes = bytes_of(d, (technique)how);
        const score *e = &s->scores[takes_part(1, (technique)how)][AROUND][how][0];
        bake_times(&s->baked, (technique)how, pass);
        fprintf(to, "| %s | %.1f + %.1f | %.1f | %.1f | %.2f | %.1f | %.2f | %.1f %% | %.3f | %s |\n", technique_names[how], pass[0], pass[1],
                1e9 * seconds[0] / points, 1e9 * seconds[3] / points, 1e9 * (seconds[SETS - 1] - seconds[0]) / points / 31,
                bytes / points, bytes / mebi, 100 * e->rmse, e->ssim, thesis[how]);
    }
    fprintf(to, "\nSH and CH carry one bounce in three planes of coefficients, as the thesis' SH/DD. The transfer of CH is that of SH, converted "
            "(in the time of pass 2).\nWith its Gram matrix CH gives what SH gives: exit radiance at the vertices differs by at most %.1e of its "
            "root mean square.\n", d->ch_differs);
}

static void write_scores(const stage *s, int matte, int which, FILE *to) {
    int sets = sets_of(&s->rigs[which]), set, how;
    fprintf(to, "\n| RMSE %%, SSIM |");
    for (set = 0; set < sets; set++) {
        int lights = s->rigs[which].group_count == 1 ? s->rigs[which].light_count : light_counts[set];
        fprintf(to, " %d light%s |", lights, lights > 1 ? "s" : "");
    }
    fprintf(to, "\n|---|");
    for (set = 0; set < sets; set++) fprintf(to, "---:|");
    fprintf(to, "\n| *noise of the reference* |");
    for (set = 0; set < sets; set++) fprintf(to, " %.2f |", 100 * s->noise[matte][which][set]);
    fprintf(to, "\n| *reference at the vertices* |");
    for (set = 0; set < sets; set++)
        fprintf(to, " %.1f, %.3f |", 100 * s->at_vertices[matte][which][set].rmse, s->at_vertices[matte][which][set].ssim);
    for (how = 0; how < TECHNIQUE_COUNT; how++) {
        if (!takes_part(matte, (technique)how)) continue;
        fprintf(to, "\n| %s |", technique_names[how]);
        for (set = 0; set < sets; set++)
            fprintf(to, " %.1f, %.3f |", 100 * s->scores[matte][which][how][set].rmse, s->scores[matte][which][how][set].ssim);
    }
    fprintf(to, "\n");
}

static void write_errors(const study *d, FILE *to) {
    fprintf(to, "\n## Error by number of lights\n\n![RMSE by number of lights](plots/vo-error.svg)\n\nPoint lights around the shapes, at about "
            "twice the scene's radius. The path-traced picture has all bounces to the sixth, each technique at most one.\n*Reference at the "
            "vertices* is the truth at the vertices, interpolated: no technique that shades vertices can do better.\n\nDiffuse scene:\n");
    write_scores(&d->shapes, 1, AROUND, to);
    fprintf(to, "\nShining scene (SH and CH have no transfer matrices here and do not take part):\n");
    write_scores(&d->shapes, 0, AROUND, to);
    fprintf(to, "\nThe environment as 32 point lights, shapes, diffuse:\n");
    write_scores(&d->shapes, 1, SKY, to);
    fprintf(to, "\nThe same, shining:\n");
    write_scores(&d->shapes, 0, SKY, to);
    fprintf(to, "\nThe same, a statue among balls, diffuse (%d vertices, %d parts, %.2f occluders a vertex):\n",
            d->statue.shining.mesh.point_count, d->statue.shining.part_count,
            (double)d->statue.baked.occluder_count / d->statue.shining.mesh.point_count);
    write_scores(&d->statue, 1, SKY, to);
}

static void write_decay(const study *d, FILE *to) {
    const double points = d->shapes.shining.mesh.point_count;
    int how, set;
    fprintf(to, "\n## Figure 7.21 again: time by number of lights\n\n![Time a vertex by number of lights](plots/vo-decay.svg)\n\nNanoseconds a "
            "vertex on one core.\n\n| technique |");
    for (set = 0; set < SETS; set++) fprintf(to, " %d |", light_counts[set]);
    fprintf(to, "\n|---|---:|---:|---:|---:|---:|---:|\n");
    for (how = 0; how < TECHNIQUE_COUNT; how++) {
        fprintf(to, "| %s |", technique_names[how]);
        for (set = 0; set < SETS; set++) fprintf(to, " %.0f |", 1e9 * d->shapes.seconds[how][set] / points);
        fprintf(to, "\n");
    }
    fprintf(to, "\nOne call of `prt_vo_shade_n` for all vertices against `prt_vo_shade` for each, 8 lights, all terms: %.0f against %.0f ns a "
            "vertex, **%.2f times as fast** (target: 4).\n", 1e9 * d->batch_seconds / points, 1e9 * d->loop_seconds / points,
            d->loop_seconds / d->batch_seconds);
}

static void write_size(FILE *to, const char *name, double bytes, double each, const char *thesis) {
    const double points = 5013, index = 4;
    fprintf(to, "| %s | %.0f | %.2f | %.2f | %s |\n", name, bytes, points * (index + each * bytes) / mebi, points * (index + 5 * bytes) / mebi,
            thesis);
}

static void write_storage(const study *d, FILE *to) {
    const techniques *t = &d->shapes.baked;
    double points = t->scene->mesh.point_count, each = t->occluder_count / points;
    fprintf(to, "\n## Storage and packing\n\nAt the thesis' 5013 vertices, with an index of 4 bytes each: %.2f occluders a vertex as baked here "
            "(%d parts, %d occluders dropped), and 5.\nThe structure `prt_vo_occluder` holds all vectors and both form factors; *read* is what "
            "the technique needs of it.\n\n| | bytes an occluder | MiB at %.2f a vertex | MiB at 5 a vertex | thesis |\n|---|---:|---:|---:|---:|\n",
            each, t->scene->part_count, t->dropped, each);
    write_size(to, "VO/DD, read", 4.0 * numbers_of(TECHNIQUE_VO_DD), each, "1.03");
    write_size(to, "VO/DD, `prt_vo_packed_diffuse`", sizeof(prt_vo_packed_diffuse), each, "");
    write_size(to, "VO/DD+DS+SS, read", 4.0 * numbers_of(TECHNIQUE_VO), each, "2.05");
    write_size(to, "everything, `prt_vo_occluder`", sizeof(prt_vo_occluder), each, "");
    write_size(to, "everything, `prt_vo_packed`", sizeof(prt_vo_packed), each, "");
    fprintf(to, "\nShading from packed occluders, 8 lights, all vertices: %.0f ns a vertex and a difference of %.2f %% (all terms; unpacked %.0f ns), "
            "%.0f ns and %.2f %% (VO/DD; %.0f ns).\n", 1e9 * d->packed_seconds / points, 100 * d->packed_differs, 1e9 * d->batch_seconds / points,
            1e9 * d->packed_diffuse_seconds / points, 100 * d->packed_diffuse_differs, 1e9 * d->diffuse_seconds / points);
}

static void write_law_row(FILE *to, const char *name, const shadow_error *e) {
    int a;
    fprintf(to, "| %s |", name);
    for (a = 0; a < LIGHT_SIZES; a++) fprintf(to, " %.3f, %+.3f |", e[a].rms, e[a].bias);
    fprintf(to, "\n");
}

static void write_laws(const study *d, FILE *to) {
    char name[64];
    int k;
    fprintf(to, "\n## Shadow laws\n\n![What one round occluder lets through](plots/vo-laws.svg)\n\nThe thesis' law is sin(b)^(2 N F), N = 1.5 in its "
            "figures; `PRT_VO_CAP` takes an occluder for a round cap of its form factor and the light for\na disc. Error of the shadow factor, the "
            "product over occluders, against traced light: %d directions at each vertex of the shapes, spread by\ncosine; root mean square, and mean "
            "(positive: too much light). Lights of several angular radii.\n\n| law | point light | 5° | 15° | 30° |\n|---|---:|---:|---:|---:|\n",
            d->o.directions);
    write_law_row(to, "no shadow", d->laws.none);
    write_law_row(to, "ambient occlusion", d->laws.ao);
    for (k = 0; k < STRENGTHS; k++) {
        snprintf(name, sizeof name, "sine, N = %g", strengths[k]);
        write_law_row(to, name, d->laws.sine[k]);
    }
    for (k = 0; k < CAPS; k++) {
        snprintf(name, sizeof name, "cap, light of %g°", cap_angles[k]);
        write_law_row(to, name, d->laws.cap[k]);
    }
    fprintf(to, "\n![A ball under a low light](gallery/vo-laws.jpg)\n\n## Caustics\n\n![Balls of glass](gallery/vo-glass.jpg)\n\nThe reference follows "
            "photons through the glass (Snell's law, total reflection), and paths of the camera; its noise is %.1f %%. Errors are of what is not "
            "glass.\nRMSE is ruled by the few places where light is focused, which no technique at the vertices reaches; without caustics it is "
            "%.0f %%, with them %.0f %%, SSIM %.3f and %.3f.\n", 100 * d->glass_noise, 100 * d->glass_scores[2].rmse, 100 * d->glass_scores[0].rmse,
            d->glass_scores[2].ssim, d->glass_scores[0].ssim);
}

static void write_splits(const study *d, FILE *to) {
    const double points = d->shapes.shining.mesh.point_count;
    int k;
    fprintf(to, "\n## Splitting objects into occluders\n\n![Shadow error by number of occluders](plots/vo-split.svg)\n\n`prt_vo_split` cuts the parts, "
            "by area, into so many occluders in all; none is dropped. Shadow factors against traced ones of point lights, as above;\nVO/DD with the "
            "cap law, 8 lights; memory packed (`prt_vo_packed_diffuse`).\n\n| occluders | a vertex sees | bake s | ns a vertex | bytes a vertex | sine, "
            "N = 1.5 | sine, N = 4 | cap, 5° | cap, 20° |\n|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (k = 0; k < SPLITS; k++) {
        const split_study *p = &d->splits[k];
        fprintf(to, "| %d | %.1f | %.1f | %.0f | %.0f | %.3f, %+.3f | %.3f, %+.3f | %.3f, %+.3f | %.3f, %+.3f |\n", p->occluders, p->seen, p->bake_seconds,
                1e9 * p->seconds / points, 4 + p->seen * (double)sizeof(prt_vo_packed_diffuse), p->sine.rms, p->sine.bias, p->strong.rms, p->strong.bias,
                p->cap.rms, p->cap.bias, p->wide.rms, p->wide.bias);
    }
}

static void write_sky(const study *d, FILE *to) {
    int k;
    fprintf(to, "\n## How many point lights an environment needs\n\nDirect light at the vertices of the shapes, `%s` cut into so many point lights "
            "(median cut), against %d.\n\n| lights |", strrchr(d->o.environment, '/') ? strrchr(d->o.environment, '/') + 1 : d->o.environment, SKY_TRUTH);
    for (k = 0; k < SKY_COUNTS - 1; k++) fprintf(to, " %d |", sky_counts[k]);
    fprintf(to, "\n|---|---:|---:|---:|---:|---:|---:|---:|\n| RMSE %% |");
    for (k = 0; k < SKY_COUNTS - 1; k++) fprintf(to, " %.1f |", 100 * d->sky_errors[k]);
    fprintf(to, "\n");
}

static int write_page(const study *d, why *w) {
    char path[1024];
    replacement r;
    FILE *to;
    snprintf(path, sizeof path, "%s/vo.md", d->o.out);
    if (replacement_open(path, &r, w)) return -1;
    to = r.file;
    fprintf(to, "<!-- Written by examples/vo_compare: do not edit. `make vo` measures and writes anew. -->\n# Vector occluders, measured\n\nSection 7.6 "
            "of Sherif's thesis (2013) run again with `prt_vo_shade_n` and `prt_bake_vo`, beside what else lights vertices from a bake.\nprt.h %s; "
            "machine: %s; compiler: %s; flags: %s; rays by Embree.\n\n![Contact sheet](gallery/vo.jpg)\n\n![Contact sheet, shining](gallery/vo-shining.jpg)\n",
            PRT_VERSION, bench_cpu_name(), EXAMPLE_COMPILER, EXAMPLE_FLAGS);
    write_table_of_costs(d, to);
    write_errors(d, to);
    write_decay(d, to);
    write_storage(d, to);
    write_laws(d, to);
    write_splits(d, to);
    write_sky(d, to);
    if (replacement_commit(&r, w)) return -1;
    printf("%s\n", path);
    return 0;
}

static int plot_lights(const study *d, why *w) {
    static const technique timed[] = { TECHNIQUE_PHONG, TECHNIQUE_VO_DD, TECHNIQUE_VO, TECHNIQUE_SH3, TECHNIQUE_SH6 };
    static const technique judged[] = { TECHNIQUE_PHONG, TECHNIQUE_AO, TECHNIQUE_VO_DD, TECHNIQUE_VO_DD_CAP, TECHNIQUE_SH3, TECHNIQUE_SH6,
                                        TECHNIQUE_CH6 };
    static plot p, q;
    int k, set;
    p.title = "Shading time";
    q.title = "Error, diffuse shapes";
    p.across = q.across = "point lights";
    p.up = "ns a vertex";
    q.up = "RMSE, % of the mean";
    p.more = q.more = "set logscale xy\nset xtics (1,2,4,8,16,32)\nset xrange [1:32]";
    p.places = q.places = SETS;
    p.series = 5;
    q.series = 8;
    for (set = 0; set < SETS; set++) {
        p.x[set] = q.x[set] = light_counts[set];
        for (k = 0; k < 5; k++) p.y[k][set] = 1e9 * d->shapes.seconds[timed[k]][set] / d->shapes.shining.mesh.point_count;
        for (k = 0; k < 7; k++) q.y[k][set] = 100 * d->shapes.scores[1][AROUND][judged[k]][set].rmse;
        q.y[7][set] = 100 * d->shapes.at_vertices[1][AROUND][set].rmse;
    }
    for (k = 0; k < 5; k++) p.names[k] = technique_names[timed[k]];
    for (k = 0; k < 7; k++) q.names[k] = technique_names[judged[k]];
    q.names[7] = "truth at vertices";
    return draw_plot(d, "vo-decay.svg", &p, w) || draw_plot(d, "vo-error.svg", &q, w) ? -1 : 0;
}

/* ---- the program ---- */

static int make_directory(const char *parent, const char *name, why *w) {
    char path[1024];
    snprintf(path, sizeof path, "%s%s%s", parent, *name ? "/" : "", name);
    return mkdir(path, 0777) && errno != EEXIST ? why_set(w, "%s: cannot be made a directory: %s", path, strerror(errno)) : 0;
}

static int prepare(study *d, why *w) {
    camera eye = camera_orbit(vec(0, 0, 0.35), 7.0, -1.25, 0.55, 0.55), low = camera_orbit(vec(0.2, 0, 0.2), 6.2, -1.25, 0.7, 0.5);
    camera at_statue = camera_orbit(vec(0, 0, 0.5), 6.6, -1.3, 0.35, 0.5);
    if (make_directory(d->o.out, "", w) || make_directory(d->o.out, "gallery", w) || make_directory(d->o.out, "plots", w) ||
        make_directory(d->o.keep, "", w) || image_load_environment(d->o.environment, &d->sky, w)) return -1;
    if (scene_shapes(d->o.fineness, &d->shapes.shining, w) || scene_ball(d->o.fineness, &d->ball.shining, w) ||
        scene_glass(d->o.fineness, &d->glass.shining, w) ||
        scene_statue(d->o.mesh, d->o.up, 34, &d->statue.shining, w)) return -1;
    return set_up(d, &d->shapes, "shapes", eye, 1, w) || set_up(d, &d->statue, "statue", at_statue, 1, w) ||
           set_up(d, &d->ball, "ball", low, 0, w) || set_up(d, &d->glass, "glass", low, 0, w) ? -1 : 0;
}

static int run(study *d, why *w) {
    int matte;
    if (prepare(d, w) || time_shading(&d->shapes, w) || time_forms(d, w)) return -1;
    compare_ch(d);
    for (matte = 1; matte >= 0; matte--)
        if (measure(d, &d->shapes, matte, AROUND, w) || measure(d, &d->shapes, matte, SKY, w)) return -1;
    if (measure(d, &d->statue, 1, SKY, w) || study_laws(d, w) || study_ball(d, w) || study_glass(d, w) || study_splits(d, w) ||
        study_lights(d, w)) return -1;
    return write_sheets(d, w) || plot_lights(d, w) || plot_laws(d, w) || plot_splits(d, w) || write_page(d, w) ? -1 : 0;
}

static int parse(int count, char **words, options *o, why *w) {
    int i;
    o->out = o->keep = "out";
    o->mesh = "/usr/share/glmark2/models/horse.3ds";
    o->environment = PRT_EXAMPLE_DATA "/courtyard.hdr";
    o->rays = 4096;
    o->size = 190;
    o->paths = 32;
    o->directions = 64;
    o->fineness = 1;
    o->up = "-x";
    o->threads = processor_count();
    for (i = 1; i + 1 < count; i += 2) {
        const char *word = words[i], *value = words[i + 1];
        if (strcmp(word, "--out") == 0) o->out = value;
        else if (strcmp(word, "--keep") == 0) o->keep = value;
        else if (strcmp(word, "--mesh") == 0) o->mesh = value;
        else if (strcmp(word, "--up") == 0) o->up = value;
        else if (strcmp(word, "--environment") == 0) o->environment = value;
        else if (strcmp(word, "--rays") == 0) o->rays = atoi(value);
        else if (strcmp(word, "--size") == 0) o->size = atoi(value);
        else if (strcmp(word, "--paths") == 0) o->paths = atoi(value);
        else if (strcmp(word, "--directions") == 0) o->directions = atoi(value);
        else if (strcmp(word, "--fineness") == 0) o->fineness = atof(value);
        else if (strcmp(word, "--threads") == 0) o->threads = atoi(value);
        else break;
    }
    if (i < count || strlen(o->up) != 2 || !strchr("+-", o->up[0]) || !strchr("xyz", o->up[1]) || o->rays < 1 || o->rays > 1000000 || o->size < 16 || o->size > 2048 || o->paths < 1 || o->paths > 65536 ||
        o->directions < 1 || o->directions > 4096 || !(o->fineness >= 0.1 && o->fineness <= 10) || o->threads < 1 || o->threads > 256)
        return why_set(w, "usage: vo_compare [--out DIR] [--keep DIR] [--mesh FILE] [--up +x|-x|...|-z] [--environment FILE.hdr] [--rays N] [--size 16...2048] "
                          "[--paths N] [--directions N] [--fineness 0.1...10] [--threads N]");
    return 0;
}

int main(int count, char **words) {
    static study d;
    why w;
    int failed;
    signal(SIGINT, on_interrupt);
    signal(SIGPIPE, SIG_IGN);
    failed = parse(count, words, &d.o, &w) || run(&d, &w);
    if (failed) fprintf(stderr, "vo_compare: %s\n", w.line);
    stage_free(&d.shapes);
    stage_free(&d.statue);
    stage_free(&d.ball);
    stage_free(&d.glass);
    image_free(&d.sky);
    return failed ? interrupted ? 130 : 1 : 0;
}
