#define _POSIX_C_SOURCE 200809L
#include "shadow_laws.h"

#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "vector.h"

enum { RAYS = 16, BATCH = 256 };

/* ---- truth ---- */

typedef struct tracing { const techniques *t; shadow_truth *to; } tracing;

/* Directions within `angle` of `axis`, uniform in solid angle; a single one is the axis. */
static prt_vec3 within(prt_vec3 axis, double angle, int k, int count, uint64_t seed, uint64_t index) {
    prt_real u = 0, v = 0;
    double z, r;
    if (count == 1) return axis;
    prt_sample_square(PRT_SAMPLE_FIBONACCI, count, seed, index, k, 1, &u, &v);
    z = 1 - (double)u * (1 - cos(angle));
    r = sqrt(z < 1 ? 1 - z * z : 0);
    return turn_to(axis, vec(r * cos(2 * pi * (double)v), r * sin(2 * pi * (double)v), z));
}

/* Rays below the tangent plane bring no light and are left out of the share. */
static int trace_vertex(const tracing *g, int k) {
    const techniques *t = g->t;
    const prt_point *at = &t->scene->mesh.points[k];
    shadow_truth *to = g->to;
    prt_vec3 *dirs = to->dirs + (size_t)k * (size_t)to->directions;
    prt_ray rays[BATCH];
    unsigned char blocked[BATCH];
    int i, j, count;
    if (prt_sample_directions(to->directions, 7, (uint64_t)k, at->normal, 0, to->directions, dirs) != PRT_OK) return -1;
    for (i = 0; i < to->directions; i++) {
        int open = 0;
        for (j = 0, count = 0; j < to->rays; j++) {
            prt_vec3 d = within(dirs[i], to->angle, j, to->rays, 11,
                                (uint64_t)k * (uint64_t)to->directions + (uint64_t)i);
            if (vec_dot(d, at->normal) <= 0) continue;
            rays[count].origin = vec_add(at->position, t->bias, at->normal);
            rays[count].dir = d;
            rays[count].tmin = 0;
            rays[count].tmax = (prt_real)(to->reach > 0 ? to->reach : 1e6);
            blocked[count++] = 0;
        }
        if (count && t->tracer->tracer.occluded(t->tracer->tracer.user, count, rays, blocked)) return -1;
        for (j = 0; j < count; j++) open += !blocked[j];
        to->share[(size_t)k * (size_t)to->directions + (size_t)i] = count ? (float)open / (float)count : 1;
    }
    return 0;
}

static int trace_range(void *user, void *own, int first, int count) {
    int k;
    (void)own;
    for (k = first; k < first + count; k++) if (trace_vertex((const tracing *)user, k)) return -1;
    return 0;
}

int shadow_truth_trace(const techniques *t, int directions, double angle, double reach, shadow_truth *to, why *w) {
    size_t count = (size_t)t->scene->mesh.point_count * (size_t)directions;
    tracing g;
    parallel job;
    memset(to, 0, sizeof *to);
    to->directions = directions;
    to->rays = angle > 0 ? RAYS : 1;
    to->angle = angle;
    to->reach = reach;
    to->dirs = (prt_vec3 *)malloc(count * sizeof *to->dirs);
    to->share = (float *)malloc(count * sizeof *to->share);
    if (!to->dirs || !to->share) return why_set(w, "out of memory for shadows");
    g.t = t;
    g.to = to;
    memset(&job, 0, sizeof job);
    job.count = t->scene->mesh.point_count;
    job.chunk = 64;
    job.threads = t->threads;
    job.what = "shadow laws";
    job.unit = "rays";
    job.unit_per_item = (double)directions * to->rays;
    job.stop = t->stop;
    job.work = trace_range;
    job.user = &g;
    return parallel_all(&job, w);
}

void shadow_truth_free(shadow_truth *t) {
    free(t->dirs);
    free(t->share);
    memset(t, 0, sizeof *t);
}

/* ---- laws ---- */

/* The product of the shadow factors at a point for a distant light: shading of a white surface, over its cosine. */
static double factor_of(const prt_vo_params *law, const prt_vo_point *at, int count, const prt_vo_occluder *occluders,
                        prt_vec3 dir) {
    prt_vo_point white = *at;
    prt_point_light light;
    prt_rgb out = { 0, 0, 0 };
    double cosine = vec_dot(at->normal, dir);
    white.diffuse = rgb(1, 1, 1);
    white.specular = rgb(0, 0, 0);
    light.position = vec_add(at->position, 10000, dir);
    light.color = rgb(1, 1, 1);
    prt_vo_shade(law, &white, at->position, count, occluders, 1, &light, &out);
    return cosine > 0 ? (double)out.g / cosine : 1;
}

static prt_vo_params shadow_alone(const prt_vo_params *law) {
    prt_vo_params p = *law;
    p.off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS;
    return p;
}

static shadow_error error_of(const techniques *t, const shadow_truth *truth, const prt_vo_params *law, int ambient) {
    int points = t->scene->mesh.point_count, k, i;
    double square = 0, sum = 0, count = (double)points * truth->directions;
    prt_vo_params p;
    shadow_error e;
    if (law) p = shadow_alone(law);
    for (k = 0; k < points; k++) {
        for (i = 0; i < truth->directions; i++) {
            size_t at = (size_t)k * (size_t)truth->directions + (size_t)i;
            double factor = ambient ? (double)t->open[k]
                            : !law  ? 1
                                    : factor_of(&p, &t->points[k], t->first[k + 1] - t->first[k],
                                                t->occluders + t->first[k], truth->dirs[at]);
            double off = factor - (double)truth->share[at];
            square += off * off;
            sum += off;
        }
    }
    e.rms = sqrt(square / count);
    e.bias = sum / count;
    return e;
}

shadow_error shadow_law_error(const techniques *t, const shadow_truth *truth, const prt_vo_params *law) {
    return error_of(t, truth, law, 0);
}
shadow_error shadow_ao_error(const techniques *t, const shadow_truth *truth) { return error_of(t, truth, NULL, 1); }

double shadow_law_of_cap(const prt_vo_params *law, double cap, double apart) {
    prt_vo_params p = shadow_alone(law);
    prt_vo_occluder o;
    prt_vo_point at;
    memset(&o, 0, sizeof o);
    memset(&at, 0, sizeof at);
    o.occlusion = at.normal = vec(0, 0, 1);
    o.form_factor = (prt_real)(sin(cap) * sin(cap));
    return factor_of(&p, &at, 1, &o, vec(sin(apart), 0, cos(apart)));
}

double shadow_truth_of_cap(double cap, double angle, double apart) {
    enum { RINGS = 400 };
    double covered = 0, all = 0;
    int k;
    if (!(angle > 0)) return apart < cap ? 0 : 1;
    for (k = 0; k < RINGS; k++) { /* rings of the light; the part of each inside the cap in closed form */
        double b = angle * (k + 0.5) / RINGS, weight = sin(b), across = sin(apart) * sin(b), c;
        c = across > 1e-12 ? (cos(cap) - cos(apart) * cos(b)) / across : cos(apart - b) > cos(cap) ? -1 : 1;
        covered += weight * acos(c < -1 ? -1 : c > 1 ? 1 : c) / pi;
        all += weight;
    }
    return 1 - covered / all;
}
