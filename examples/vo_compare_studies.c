/* What vo_compare looks at beside the table: shadow laws, caustics, splitting, how many lights a sky needs. */
#define _POSIX_C_SOURCE 200809L
#include "vo_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "point_lights.h"
#include "progress.h"
#include "reference.h"
#include "vector.h"

/* ---- shadow laws ---- */

prt_vo_params sine_law(double strength) {
    prt_vo_params p;
    memset(&p, 0, sizeof p);
    p.shadow_strength = (prt_real)strength;
    return p;
}

prt_vo_params cap_law(double degrees) {
    prt_vo_params p;
    memset(&p, 0, sizeof p);
    p.law = PRT_VO_CAP;
    p.light_angle = (prt_real)(degrees * degree);
    return p;
}

/* Every law against one size of light; the progress line counts laws. */
static void judge_laws(study *d, int size, const shadow_truth *traced, progress *p) {
    law_study *l = &d->laws;
    int k;
    l->none[size] = shadow_law_error(&d->shapes.baked, traced, NULL);
    l->ao[size] = shadow_ao_error(&d->shapes.baked, traced);
    for (k = 0; k < STRENGTHS + CAPS && !*d->stop; k++) {
        prt_vo_params law = k < STRENGTHS ? sine_law(strengths[k]) : cap_law(cap_angles[k - STRENGTHS]);
        shadow_error e = shadow_law_error(&d->shapes.baked, traced, &law);
        if (k < STRENGTHS) l->sine[k][size] = e; else l->cap[k - STRENGTHS][size] = e;
        progress_show(p, size * (STRENGTHS + CAPS) + k + 1);
    }
}

int study_laws(study *d, why *w) {
    double laws = STRENGTHS + CAPS;
    progress p;
    int a;
    progress_start(&p, "shadow laws: factors", LIGHT_SIZES * laws, 0, "factors",
                   (double)d->shapes.shining.mesh.point_count * d->o.directions);
    for (a = 0; a < LIGHT_SIZES; a++) {
        shadow_truth traced;
        int failed = shadow_truth_trace(&d->shapes.baked, d->o.directions, light_sizes[a] * degree, &traced, w);
        if (!failed) judge_laws(d, a, &traced, &p);
        shadow_truth_free(&traced);
        if (failed) return -1;
    }
    progress_end(&p, LIGHT_SIZES * laws);
    return *d->stop ? why_set(w, "interrupted") : 0;
}

static int paint_law(stage *s, const prt_vo_params *law, const prt_point_light *light, picture *to, why *w) {
    int points = s->shining.mesh.point_count, failed;
    prt_rgb *colors = (prt_rgb *)malloc((size_t)points * sizeof *colors);
    if (!colors) return why_set(w, "out of memory for a picture");
    failed = prt_vo_shade_n(law, points, s->baked.points, s->seen.eye.eye, s->baked.first, s->baked.occluders, 1, light,
                            colors) != PRT_OK ||
             view_paint(&s->seen, &s->shining, colors, background, to, w);
    free(colors);
    return failed ? why_set(w, "%s cannot be painted", s->name) : 0;
}

/* A scene under its one light, traced and by each law: one row. */
static int study_one_light(const study *d, stage *s, int paths, int photons, const prt_vo_params *laws,
                           const char *const *heads, const char *title, const char *row, const char *file,
                           score *scores, double *noise, why *w) {
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
    failed = trace_some(d, s, 1, t->lights, "pixels", s->seen.width * s->seen.height, s->pixel_queries, paths, photons,
                        t->pixels, w) ||
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

/* A ball over a platform under one low light, direct light alone: the pointy shadows of section 7.7.2. */
int study_ball(study *d, why *w) {
    static const char *const heads[LAWS + 1] = { "traced", "sine law, N = 1.5", "sine law, N = 5.5",
                                                 "cap law, light of 5°", "cap law, light of 20°" };
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
int study_glass(study *d, why *w) {
    static const char *const heads[LAWS + 1] = { "paths and photons", "VO, sine law", "VO, cap law",
                                                 "VO without caustics", "Phong" };
    prt_vo_params laws[LAWS];
    int k;
    for (k = 0; k < LAWS; k++) laws[k] = k == 1 ? cap_law(5) : sine_law(1.5);
    laws[2].off = PRT_VO_NO_CAUSTIC;
    laws[3].off = PRT_VO_NO_SHADOW | PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD;
    light_alone(&d->glass, "above", vec(-2.5, 1.5, 4.5));
    return study_one_light(d, &d->glass, d->o.paths, 2000 * d->o.paths, laws, heads,
                           "Caustics: balls of glass under one light", "glass\n1 point light", "vo-glass.jpg",
                           d->glass_scores, &d->glass_noise, w);
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
    t.stop = d->stop;
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
            failed = techniques_shade(&t, TECHNIQUE_VO_DD_CAP, vec(0, 0, 9), vec(0, 0, 0), count, lights, out, &seconds,
                                      w);
            if (run == 0 || seconds < p->seconds) p->seconds = seconds;
        }
    }
    shadow_truth_free(&traced);
    techniques_free(&t);
    free(out);
    return failed ? -1 : 0;
}

int study_splits(study *d, why *w) {
    int k;
    for (k = 0; k < SPLITS; k++) if (study_split(d, k, w)) return -1;
    return 0;
}

/* ---- how many lights a sky needs ---- */

/* Direct light at the vertices, matte, of the environment as so many point lights; the last is the truth. */
int study_lights(study *d, why *w) {
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
    r.stop = d->stop;
    r.query_count = points;
    r.queries = s->vertex_queries;
    if (!lights || !again) failed = why_set(w, "out of memory for lights");
    for (k = 0; k < SKY_COUNTS && !failed; k++) {
        out[k] = (prt_rgb *)malloc((size_t)points * sizeof(prt_rgb));
        r.light_count = sky_counts[k];
        r.out[0] = out[k];
        r.out[1] = again;
        r.done = 0;
        failed = !out[k] || point_lights_from_map(&d->sky, sky_counts[k], 100, lights, w) ||
                 path_reference_trace(&r, w) || (*d->stop && why_set(w, "interrupted"));
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
