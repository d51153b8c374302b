/* What vo_compare takes for the truth, and how far each technique is from it. */
#define _POSIX_C_SOURCE 200809L
#include "vo_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"
#include "reference.h"
#include "similarity.h"
#include "vector.h"

/* ---- truth ---- */

int trace_some(const study *d, const stage *s, int matte, const rig *lights, const char *where, int count,
               const path_query *queries, int samples, int photons, prt_rgb *out[PATH_HALVES], why *w) {
    char path[1024], what[96];
    path_reference r;
    int half;
    for (half = 0; half < PATH_HALVES; half++) {
        out[half] = (prt_rgb *)malloc((size_t)count * (size_t)lights->group_count * sizeof(prt_rgb));
        if (!out[half]) return why_set(w, "out of memory for the reference");
    }
    snprintf(path, sizeof path, "%s/vo-%s-%s-%s-%s.paths", d->o.keep, s->name, matte ? "matte" : "shining",
             lights->name, where);
    snprintf(what, sizeof what, "reference: %s, %s, lights %s, %s", s->name, matte ? "matte" : "shining", lights->name,
             where);
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
    r.stop = d->stop;
    r.query_count = count;
    r.queries = queries;
    r.out[0] = out[0];
    r.out[1] = out[1];
    if (path_reference_resume(&r, path, w)) return -1;
    return r.done == count ? 0
                           : why_set(w, "interrupted; the reference so far is kept in %s, start again to go on", path);
}

static int trace_truth(const study *d, stage *s, int matte, int which, why *w) {
    truth *t = &s->truths[matte][which];
    t->lights = &s->rigs[which];
    return trace_some(d, s, matte, t->lights, "pixels", s->seen.width * s->seen.height, s->pixel_queries, d->o.paths, 0,
                      t->pixels, w) ||
                   trace_some(d, s, matte, t->lights, "vertices", s->shining.mesh.point_count, s->vertex_queries,
                              4 * d->o.paths, 0, t->vertices, w)
               ? -1
               : 0;
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

int paint_truth(const stage *s, const truth *t, int set, int half, picture *to, why *w) {
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

int paint_reference(const stage *s, int matte, int which, int set, picture *to, why *w) {
    picture other;
    memset(&other, 0, sizeof other);
    if (paint_truth(s, &s->truths[matte][which], set, 0, to, w) ||
        paint_truth(s, &s->truths[matte][which], set, 1, &other, w))
        return -1;
    merge(to, &other);
    picture_free(&other);
    return 0;
}

/* ---- one technique ---- */

int paint(stage *s, int matte, int which, int set, technique how, picture *to, double *seconds, why *w) {
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

/* SH and CH without matrices have no answer to shining surfaces, and without shine lobes, DS and SS add nothing. */
int takes_part(int matte, technique how) {
    int glossy = how >= TECHNIQUE_SH3_GLOSSY;
    return matte ? how != TECHNIQUE_VO && how != TECHNIQUE_VO_CAP && !glossy : how < TECHNIQUE_SH3 || glossy;
}

score compare(const picture *p, const picture r[PATH_HALVES], const picture *mean) {
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
    if (paint_truth(s, t, set, 0, &r[0], w) || paint_truth(s, t, set, 1, &r[1], w) ||
        paint_truth(s, t, set, 0, &mean, w) || paint_vertices(s, t, set, 0, &v[0], w) ||
        paint_vertices(s, t, set, 1, &v[1], w))
        return -1;
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

int measure(const study *d, stage *s, int matte, int which, why *w) {
    int set;
    if (trace_truth(d, s, matte, which, w)) return -1;
    for (set = 0; set < sets_of(&s->rigs[which]); set++) if (measure_set(s, matte, which, set, w)) return -1;
    return *d->stop ? why_set(w, "interrupted") : 0;
}

/* Shining, lights around: every technique and number of lights in turns, the least of some runs. */
int time_shading(stage *s, why *w) {
    int run, set, how;
    for (run = 0; run < RUNS; run++) {
        for (set = 0; set < SETS; set++) {
            for (how = 0; how < TECHNIQUE_COUNT; how++) {
                double seconds;                            /* of the second call: all that it reads is in the caches */
                if (paint(s, 0, AROUND, set, (technique)how, NULL, NULL, w) ||
                    paint(s, 0, AROUND, set, (technique)how, NULL, &seconds, w)) return -1;
                if (run == 0 || seconds < s->seconds[how][set]) s->seconds[how][set] = seconds;
            }
        }
    }
    return 0;
}

/* The largest difference between SH and CH used with its Gram matrix, over exit radiance at the vertices. */
void compare_ch(study *d) {
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
}
