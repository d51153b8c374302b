/* What the forms of occluders cost in shading, and how far that is from the arithmetic limit. */
#define _POSIX_C_SOURCE 200809L
#include "vo_compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"

typedef struct shading {
    const techniques      *t;
    prt_vo_params         params;
    prt_vec3              eye;
    prt_real              unit;
    int                   diffuse, light_count;
    prt_point_light       lights[MOST_LIGHTS];
    prt_vo_packed         *packed;
    prt_vo_packed_diffuse *packed_diffuse;
} shading;

typedef void (*shading_way)(const shading *s, prt_rgb *out);

static void shade_one_by_one(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    int k;
    for (k = 0; k < t->scene->mesh.point_count; k++)
        prt_vo_shade(&s->params, &t->points[k], s->eye, t->first[k + 1] - t->first[k], t->occluders + t->first[k],
                     s->light_count, s->lights, &out[k]);
}
static void shade_plain(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    prt_vo_shade_n(&s->params, t->scene->mesh.point_count, t->points, s->eye, t->first, t->occluders, s->light_count,
                   s->lights, out);
}
static void shade_indexed(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    int points = t->scene->mesh.point_count;
    if (s->diffuse)
        prt_vo_shade_indexed_diffuse_n(&s->params, points, t->points, s->eye, t->first, t->material_count_diffuse,
                                       t->materials_diffuse, t->indexed_diffuse, s->light_count, s->lights, out);
    else
        prt_vo_shade_indexed_n(&s->params, points, t->points, s->eye, t->first, t->material_count, t->materials,
                               t->indexed, s->light_count, s->lights, out);
}
static void shade_packed(const shading *s, prt_rgb *out) {
    const techniques *t = s->t;
    int points = t->scene->mesh.point_count;
    if (s->diffuse)
        prt_vo_shade_packed_diffuse_n(&s->params, s->unit, points, t->points, s->eye, t->first, s->packed_diffuse,
                                      s->light_count, s->lights, out);
    else
        prt_vo_shade_packed_n(&s->params, s->unit, points, t->points, s->eye, t->first, s->packed, s->light_count,
                              s->lights, out);
}

double difference(int count, const prt_rgb *a, const prt_rgb *b) {
    double square = 0, all = 0;
    int k;
    for (k = 0; k < count; k++) {
        square += pow((double)(a[k].r - b[k].r), 2) + pow((double)(a[k].g - b[k].g), 2) +
                  pow((double)(a[k].b - b[k].b), 2);
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
            prt_vo_pack_diffuse(s->unit, at, count, t->occluders + t->first[k], s->packed_diffuse + t->first[k]) !=
                PRT_OK)
            return why_set(w, "the occluders of vertex %d cannot be packed", k);
    }
    return 0;
}

/* All ways in turns, the least of some runs. out, other: room for all vertices. */
static void time_ways(const shading *s, form_times *f, prt_rgb *out, prt_rgb *other) {
    static const shading_way ways[FORMS + 1] = { shade_plain, shade_indexed, shade_packed, shade_one_by_one };
    int points = s->t->scene->mesh.point_count, run, k;
    for (run = 0; run < 2 * RUNS; run++) {
        for (k = 0; k <= FORMS; k++) {
            double *least = k < FORMS ? &f->seconds[k] : &f->loop, seconds = processor_seconds();
            ways[k](s, k ? other : out);
            seconds = processor_seconds() - seconds;
            if (run == 0 || seconds < *least) *least = seconds;
            if (k && k < FORMS) f->differs[k] = difference(points, other, out);
        }
    }
}

static void find_limits(const shading *s, form_times *f, prt_rgb *out) {
    limit_job job;
    job.params = &s->params;
    job.count = s->t->scene->mesh.point_count;
    job.points = s->t->points;
    job.eye = s->eye;
    job.first = s->t->first;
    job.occluders = s->t->occluders;
    job.light_count = s->light_count;
    job.lights = s->lights;
    job.out = out;
    f->limits[0] = limit_portable(&job, 4 * RUNS);
    f->limits[1] = limit_native(&job, 4 * RUNS);
}

int time_forms(study *d, why *w) {
    const techniques *t = &d->shapes.baked;
    int points = t->scene->mesh.point_count, failed, k;
    prt_rgb *out = (prt_rgb *)malloc(2 * (size_t)points * sizeof *out);
    shading s;
    memset(&s, 0, sizeof s);
    s.t = t;
    s.eye = d->shapes.seen.eye.eye;
    s.unit = t->scene->mesh.report.radius;
    s.light_count = lights_of(&d->shapes.rigs[AROUND], 3, s.lights);
    failed = out ? pack(t, &s, w) : why_set(w, "out of memory");
    for (k = 0; k < TERMS && !failed; k++) {
        s.diffuse = k;
        s.params.off = PRT_VO_NO_CAUSTIC | (k ? PRT_VO_NO_DS | PRT_VO_NO_SS : 0);
        time_ways(&s, &d->forms[k], out, out + points);
        find_limits(&s, &d->forms[k], out);
    }
    free(s.packed);
    free(s.packed_diffuse);
    free(out);
    return failed;
}
