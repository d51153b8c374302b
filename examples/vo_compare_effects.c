/* What vo_compare shows beside the comparison: waves that bend vectors, drained colour [Sherif 2013, 7.3], and what it
   saves to model only what a scene requires. */
#define _POSIX_C_SOURCE 200809L
#include "vo_compare.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"
#include "vector.h"

/* Mean radiance of a picture, and its change from another, both over what is not background, relative to the other's
   mean. */
static effect effect_of(const picture *p, const picture *from) {
    double sum = 0, all = 0, square = 0;
    effect e;
    size_t k, count = (size_t)p->width * (size_t)p->height;
    int c, places = 0;
    for (k = 0; k < count; k++) {
        if (!(from->rgba[4 * k + 3] > 0)) continue;
        for (c = 0; c < 3; c++, places++) {
            double a = (double)p->rgba[4 * k + (size_t)c], b = (double)from->rgba[4 * k + (size_t)c];
            sum += a;
            all += b;
            square += (a - b) * (a - b);
        }
    }
    e.mean = sum / all;
    e.differs = sqrt(square / places) / (all / places);
    return e;
}

static void caption_effect(sheet_cell *cell, const effect *e, int first) {
    snprintf(cell->first, sizeof cell->first, "mean %.0f %%", 100 * e->mean);
    if (!first) snprintf(cell->second, sizeof cell->second, "differs by %.0f %%", 100 * e->differs);
}

/* ---- waves ---- */

enum { WAVES = 5 };
/* Plane waves that run and push in different directions of the surface. */
static void make_waves(prt_vo_wave *waves) {
    int k;
    for (k = 0; k < WAVES; k++) {
        double angle = 2.4 * k;
        memset(&waves[k], 0, sizeof waves[k]);
        waves[k].along = vec(cos(angle), sin(angle), 0);
        waves[k].across = vec(0, 0, 1);
        waves[k].frequency = (prt_real)(2 + 0.7 * k);
        waves[k].amplitude = (prt_real)(0.07 / (2 + 0.7 * k));
        waves[k].phase = (prt_real)(1.3 * k);
    }
}

/* Occluders of all vertices as the waves bend them at a time. */
static int bend(const techniques *t, const prt_vo_wave *waves, double time, prt_vo_occluder *out) {
    int k;
    for (k = 0; k < t->scene->mesh.point_count; k++) {
        prt_vec3 at = vec_add(vec(0, 0, 0), (prt_real)waves_a_unit, t->points[k].position);
        if (prt_vo_bend(WAVES, waves, (prt_real)time, at, t->first[k + 1] - t->first[k], t->occluders + t->first[k],
                        out + t->first[k]) != PRT_OK) return -1;
    }
    return 0;
}

int study_waves(study *d, why *w) {
    static const char *const heads[FRAMES + 1] = { "still water", "waves, t = 0", "t = 0.4", "t = 0.8", "t = 1.2" };
    stage *s = &d->pool;
    const techniques *t = &s->baked;
    int points = t->scene->mesh.point_count, k, failed = 0;
    prt_vo_occluder *bent = (prt_vo_occluder *)malloc((size_t)t->occluder_count * sizeof *bent + 1);
    prt_rgb *colors = (prt_rgb *)malloc((size_t)points * sizeof *colors);
    picture pictures[FRAMES + 1];
    sheet_cell cells[FRAMES + 1];
    prt_vo_wave waves[WAVES];
    prt_vo_params params = sine_law(1.5);
    prt_point_light light;
    params.caustic_angle = (prt_real)(waves_sharpness * degree);
    light.position = vec(0.6, -1.5, 12);
    light.color = rgb(1, 1, 0.95);
    make_waves(waves);
    memset(pictures, 0, sizeof pictures);
    memset(cells, 0, sizeof cells);
    if (!bent || !colors) failed = why_set(w, "out of memory for waves");
    for (k = 0; k <= FRAMES && !failed; k++) {
        const prt_vo_occluder *seen = k ? bent : t->occluders;
        double start = processor_seconds(), middle;
        effect e;
        if (k) failed = bend(t, waves, frame_times[k - 1], bent);
        middle = processor_seconds();
        failed = failed || prt_vo_shade_n(&params, points, t->points, s->seen.eye.eye, t->first, seen, 1, &light,
                                          colors) != PRT_OK;
        if (k) d->bend_seconds = middle - start;
        d->pool_seconds = processor_seconds() - middle;
        if (failed) why_set(w, "the pool cannot be shaded");
        else failed = view_paint(&s->seen, &s->shining, colors, background, &pictures[k], w);
        if (failed) break;
        e = effect_of(&pictures[k], &pictures[0]);
        caption_effect(&cells[k], &e, k == 0);
        if (k) d->waves[k - 1] = e;
    }
    if (!failed)
        failed = write_row(d, "Waves bend caustic and occlusion vectors", "sea floor\n1 point light", "vo-waves.jpg",
                           FRAMES + 1, heads, pictures, cells, w);
    for (k = 0; k <= FRAMES; k++) picture_free(&pictures[k]);
    free(bent);
    free(colors);
    return failed ? -1 : 0;
}

/* ---- colour drain ---- */

int study_drain(study *d, why *w) {
    static const char *const heads[DRAINS] = { "dd = 1", "dd off", "dd = -1", "dd = -3" };
    stage *s = &d->shapes;
    const techniques *t = &s->baked;
    int points = t->scene->mesh.point_count, k, failed = 0, count;
    prt_rgb *colors = (prt_rgb *)malloc((size_t)points * sizeof *colors);
    picture pictures[DRAINS];
    sheet_cell cells[DRAINS];
    prt_point_light lights[MOST_LIGHTS];
    count = lights_of(&s->rigs[AROUND], 2, lights);
    memset(pictures, 0, sizeof pictures);
    memset(cells, 0, sizeof cells);
    if (!colors) failed = why_set(w, "out of memory for a picture");
    for (k = 0; k < DRAINS && !failed; k++) {
        prt_vo_params params = cap_law(5);
        params.off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS;
        params.dd = (prt_real)drains[k];
        if (!(fabs(drains[k]) > 0)) params.off |= PRT_VO_NO_DD;
        failed = prt_vo_shade_n(&params, points, t->matte_points, s->seen.eye.eye, t->first, t->occluders, count,
                                lights, colors) != PRT_OK ||
                 view_paint(&s->seen, &s->shining, colors, background, &pictures[k], w);
        if (failed) break;
        d->drained[k] = effect_of(&pictures[k], &pictures[0]);
        caption_effect(&cells[k], &d->drained[k], k == 0);
    }
    if (!failed)
        failed = write_row(d, "A negative weight of DD drains colour", "shapes\n4 point lights", "vo-drain.jpg", DRAINS,
                           heads, pictures, cells, w);
    for (k = 0; k < DRAINS; k++) picture_free(&pictures[k]);
    free(colors);
    return failed ? why_set(w, "the drained shapes cannot be painted") : 0;
}

/* ---- model only what a scene requires ---- */

enum { DIFFUSE_FORM = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS };
static const unsigned left_out[SAVINGS] = {
    0, PRT_VO_NO_CAUSTIC, PRT_VO_NO_DS | PRT_VO_NO_SS, PRT_VO_NO_DD, DIFFUSE_FORM, DIFFUSE_FORM | PRT_VO_NO_DD
};

/* The pool, baked and shaded without some of its terms. */
int study_savings(study *d, why *w) {
    stage *s = &d->pool;
    prt_point_light lights[MOST_LIGHTS];
    int points = s->shining.mesh.point_count, count = lights_of(&d->shapes.rigs[AROUND], 3, lights), k, run, failed = 0;
    prt_rgb *all = (prt_rgb *)malloc(2 * (size_t)points * sizeof *all), *some = all + points;
    if (!all) failed = why_set(w, "out of memory");
    for (k = 0; k < SAVINGS && !failed; k++) {
        saving *to = &d->savings[k];
        prt_rgb *out = k ? some : all;
        prt_vo_params params = cap_law(5);
        prt_vo_form form = (left_out[k] & DIFFUSE_FORM) == DIFFUSE_FORM ? PRT_VO_INDEXED_DIFFUSE : PRT_VO_INDEXED;
        techniques t;
        memset(&t, 0, sizeof t);
        t.scene = &s->shining;
        t.tracer = &s->tracer;
        t.rays = saving_rays(d);
        t.threads = d->o.threads;
        t.most_occluders = SCENE_PARTS;
        t.bias = (prt_real)1e-4;
        t.shining = 1;
        t.off = params.off = left_out[k];
        t.stop = d->stop;
        failed = techniques_bake(&t, w);
        for (run = 0; run < RUNS && !failed; run++) {
            double seconds = processor_seconds();
            failed = prt_vo_shade_n(&params, points, t.points, s->seen.eye.eye, t.first, t.occluders, count, lights,
                                    out) != PRT_OK;
            seconds = processor_seconds() - seconds;
            if (run == 0 || seconds < to->seconds) to->seconds = seconds;
        }
        to->bake_seconds = t.vo_seconds;
        to->bytes = (double)prt_vo_size(form, points, t.occluder_count, t.material_count) / points;
        to->differs = failed ? 0 : difference(points, out, all);
        techniques_free(&t);
    }
    free(all);
    return failed ? -1 : 0;
}
