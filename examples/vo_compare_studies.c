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

/* Every law against one kind of light; the progress line counts laws. */
static void judge_laws(study *d, int which, const shadow_truth *traced, progress *p) {
    law_study *l = &d->laws;
    int k;
    l->none[which] = shadow_law_error(&d->shapes.baked, traced, NULL);
    l->ao[which] = shadow_ao_error(&d->shapes.baked, traced);
    for (k = 0; k < STRENGTHS + CAPS && !*d->stop; k++) {
        prt_vo_params law = k < STRENGTHS ? sine_law(strengths[k]) : cap_law(cap_angles[k - STRENGTHS]);
        shadow_error e = shadow_law_error(&d->shapes.baked, traced, &law);
        if (k < STRENGTHS) l->sine[k][which] = e; else l->cap[k - STRENGTHS][which] = e;
        progress_show(p, which * (STRENGTHS + CAPS) + k + 1);
    }
}

int study_laws(study *d, why *w) {
    double laws = STRENGTHS + CAPS;
    progress p;
    int a;
    progress_start(&p, "shadow laws: factors", LIGHT_CASES * laws, 0, "factors",
                   (double)d->shapes.shining.mesh.point_count * d->o.directions);
    for (a = 0; a < LIGHT_CASES; a++) {
        shadow_truth traced;
        int failed = shadow_truth_trace(&d->shapes.baked, d->o.directions, light_cases[a].size * degree,
                                        light_cases[a].reach * (double)d->shapes.shining.mesh.report.radius, &traced,
                                        w);
        if (!failed) judge_laws(d, a, &traced, &p);
        shadow_truth_free(&traced);
        if (failed) return -1;
    }
    progress_end(&p, LIGHT_CASES * laws);
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

int write_row(const study *d, const char *title, const char *row, const char *file, int columns,
              const char *const *heads, picture *pictures, sheet_cell *cells, why *w) {
    double exposure = picture_exposure(&pictures[0]);
    contact_sheet sheet;
    char path[1024];
    int k;
    memset(&sheet, 0, sizeof sheet);
    for (k = 0; k < columns; k++) cells[k].shown = &pictures[k];
    sheet.title = title;
    sheet.rows = 1; sheet.columns = columns; sheet.per_pixel = SAMPLES_A_PIXEL;
    sheet.width = sheet.height = d->o.size;
    sheet.heads = heads; sheet.names = &row; sheet.exposures = &exposure; sheet.cells = cells;
    snprintf(path, sizeof path, "%s/gallery/%s", d->o.out, file);
    if (contact_sheet_write(&sheet, path, w)) return -1;
    printf("%s\n", path);
    return 0;
}

/* A scene under its one light, traced and by each law: one row. */
static int study_one_light(const study *d, stage *s, int paths, int photons, const prt_vo_params *laws,
                           const char *const *heads, const char *title, const char *row, const char *file,
                           score *scores, double *noise, why *w) {
    picture pictures[LAWS + 1], halves[PATH_HALVES];
    sheet_cell cells[LAWS + 1];
    truth *t = &s->truths[1][AROUND];
    int k, failed;
    memset(pictures, 0, sizeof pictures);
    memset(halves, 0, sizeof halves);
    memset(cells, 0, sizeof cells);
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
    if (!failed) failed = write_row(d, title, row, file, LAWS + 1, heads, pictures, cells, w);
    for (k = 0; k <= LAWS; k++) picture_free(&pictures[k]);
    picture_free(&halves[0]);
    picture_free(&halves[1]);
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

/* ---- pictures by law ---- */

/* A matte scene by a law, as a picture and its score; t are the techniques of the stage, or others of its mesh. */
static int score_law(stage *s, const techniques *t, int which, int set, const prt_vo_params *law, score *to,
                     double *seconds, why *w) {
    const truth *traced = &s->truths[1][which];
    prt_point_light lights[MOST_LIGHTS];
    int count = lights_of(&s->rigs[which], set, lights), points = t->scene->mesh.point_count, run, k, failed;
    prt_rgb *colors = (prt_rgb *)malloc((size_t)points * sizeof *colors);
    picture halves[PATH_HALVES], mean, p;
    memset(halves, 0, sizeof halves);
    memset(&mean, 0, sizeof mean);
    memset(&p, 0, sizeof p);
    failed = !colors || paint_truth(s, traced, set, 0, &halves[0], w) ||
             paint_truth(s, traced, set, 1, &halves[1], w) || paint_reference(s, 1, which, set, &mean, w);
    for (run = 0; run < (seconds ? RUNS : 1) && !failed; run++) {
        double now = processor_seconds();
        failed = prt_vo_shade_n(law, points, t->matte_points, s->seen.eye.eye, t->first, t->occluders, count, lights,
                                colors) != PRT_OK;
        now = processor_seconds() - now;
        if (seconds && (run == 0 || now < *seconds)) *seconds = now;
    }
    if (!failed) failed = view_paint(&s->seen, &s->shining, colors, background, &p, w);
    if (!failed) *to = compare(&p, halves, &mean);
    for (k = 0; k < PATH_HALVES; k++) picture_free(&halves[k]);
    picture_free(&mean);
    picture_free(&p);
    free(colors);
    return failed ? why_set(w, "%s cannot be painted", s->name) : 0;
}

/* VO/DD of matte scenes: which light of the cap law, and which law, gives the truest pictures. */
int study_pictures(study *d, why *w) {
    static const struct { int statue, which, set; } shown[PICTURED] = {
        { 0, AROUND, 0 }, { 0, AROUND, 3 }, { 0, AROUND, 5 }, { 0, SKY, 0 }, { 1, SKY, 0 }
    };
    int k, i;
    for (k = 0; k < PICTURE_LAWS; k++) {
        prt_vo_params law = k < 2 ? sine_law(k ? 4 : 1.5) : cap_law(cap_angles[k - 2]);
        law.off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS;
        for (i = 0; i < PICTURED; i++) {
            stage *s = shown[i].statue ? &d->statue : &d->shapes;
            if (score_law(s, &s->baked, shown[i].which, shown[i].set, &law, &d->pictured[k][i], NULL, w)) return -1;
        }
    }
    return *d->stop ? why_set(w, "interrupted") : 0;
}

/* ---- how many occluders a vertex ---- */

/* t with the strongest `most` occluders of each vertex alone: rows are in order of falling form factor. */
static int keep_strongest(const techniques *t, int most, techniques *to, why *w) {
    int points = t->scene->mesh.point_count, k;
    *to = *t;
    to->first = (int *)malloc(((size_t)points + 1) * sizeof *to->first);
    to->occluders = (prt_vo_occluder *)malloc((size_t)t->occluder_count * sizeof *to->occluders + 1);
    if (!to->first || !to->occluders) return why_set(w, "out of memory for occluders");
    to->first[0] = 0;
    for (k = 0; k < points; k++) {
        int seen = t->first[k + 1] - t->first[k], kept = seen < most ? seen : most;
        memcpy(to->occluders + to->first[k], t->occluders + t->first[k], (size_t)kept * sizeof *to->occluders);
        to->first[k + 1] = to->first[k] + kept;
    }
    to->occluder_count = to->first[points];
    return 0;
}

static int study_keeps(study *d, int cut, const techniques *t, const shadow_truth *traced, why *w) {
    prt_vo_params sine = sine_law(1.5), cap = cap_law(5);
    int k, failed = 0;
    sine.off = cap.off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS;
    for (k = 0; k < KEEPS && !failed; k++) {
        keep_study *to = &d->keeps[cut][k];
        techniques few;
        failed = keep_strongest(t, keeps[cut][k], &few, w) ||
                 score_law(&d->shapes, &few, AROUND, 3, &sine, &to->by_sine, NULL, w) ||
                 score_law(&d->shapes, &few, AROUND, 3, &cap, &to->by_cap, &to->seconds, w);
        if (!failed) {
            to->seen = (double)few.occluder_count / few.scene->mesh.point_count;
            to->sine = shadow_law_error(&few, traced, &sine);
            to->cap = shadow_law_error(&few, traced, &cap);
        }
        free(few.first);
        free(few.occluders);
    }
    return failed;
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
    failed = !out || techniques_bake(&t, w) || shadow_truth_trace(&t, d->o.directions, 0, 0, &traced, w);
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
    if (!failed && (which == 0 || split_counts[which] == COUNTED))
        failed = study_keeps(d, which > 0, &t, &traced, w) || (*d->stop && why_set(w, "interrupted"));
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
