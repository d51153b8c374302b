/* advise, point lights: what the environment is as so many of them, their truth, and vector occluders as a way to shade
   under them: the mesh cut into 1 to 64 of them, 1 to 8 kept a vertex, by both shadow laws, in 20 bytes each. */
#define _POSIX_C_SOURCE 200809L
#include "advise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "point_lights.h"
#include "vector.h"

enum { MOST_KEPT = 8, CUTS = 4, VO_RAYS = 1024, TIMED = 2048, LIGHT_COUNT = PRT_SH_COUNT(LIGHT_BANDS) };
static const int cuts[CUTS] = { 1, 4, 16, 64 };
static const unsigned shadows_only = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS;

int lights_create(advisor *a, why *w) {
    int k, i;
    a->lights = (prt_point_light *)malloc((size_t)a->o.lights * sizeof *a->lights);
    if (!a->lights) return why_set(w, "out of memory");
    if (point_lights_from_map(&a->environment.map, a->o.lights, 100, a->lights, w)) return -1;
    memset(a->light, 0, sizeof a->light);
    for (k = 0; k < a->o.lights; k++) {                    /* deltas of irradiance pi c, see point_lights.h */
        prt_real delta[LIGHT_COUNT];
        prt_rgb c = rgb_scale(a->lights[k].color, pi);
        prt_sh_delta(LIGHT_BANDS, vec_unit(a->lights[k].position, vec(0, 0, 1)), delta);
        for (i = 0; i < LIGHT_COUNT; i++) {
            a->light[i] += c.r * delta[i];
            a->light[LIGHT_COUNT + i] += c.g * delta[i];
            a->light[2 * LIGHT_COUNT + i] += c.b * delta[i];
        }
    }
    return 0;
}

void lights_shade(const advisor *a, int count, const prt_point *points, prt_rgb *out) {
    int k, i;
    for (k = 0; k < count; k++) {
        out[k] = rgb(0, 0, 0);
        for (i = 0; i < a->o.lights; i++) {
            prt_vec3 to = vec_unit(vec_add(a->lights[i].position, -1, points[k].position), points[k].normal);
            double cosine = vec_dot(to, points[k].normal);
            if (cosine <= 0) continue;
            out[k].r += (prt_real)cosine * a->lights[i].color.r;
            out[k].g += (prt_real)cosine * a->lights[i].color.g;
            out[k].b += (prt_real)cosine * a->lights[i].color.b;
        }
    }
}

int lights_trace(const advisor *a, const prt_point *p, double sum[3]) {
    prt_ray rays[MOST_LIGHTS];
    unsigned char blocked[MOST_LIGHTS] = { 0 };
    int k;
    for (k = 0; k < a->o.lights; k++) {
        rays[k].origin = vec_add(p->position, advise_bias, p->normal);
        rays[k].dir = vec_unit(vec_add(a->lights[k].position, -1, rays[k].origin), p->normal);
        rays[k].tmin = 0;
        rays[k].tmax = (prt_real)1e6;
    }
    if (a->tracer.tracer.occluded(a->tracer.tracer.user, a->o.lights, rays, blocked)) return -1;
    sum[0] = sum[1] = sum[2] = 0;
    for (k = 0; k < a->o.lights; k++) {
        double cosine = vec_dot(rays[k].dir, p->normal);
        if (blocked[k] || cosine <= 0) continue;
        sum[0] += cosine * (double)a->lights[k].color.r;
        sum[1] += cosine * (double)a->lights[k].color.g;
        sum[2] += cosine * (double)a->lights[k].color.b;
    }
    return 0;
}

/* ---- vector occluders ---- */

typedef struct cut_mesh { int *groups; prt_vo_object object; } cut_mesh;

static int cut_mesh_create(const advisor *a, int count, cut_mesh *c, why *w) {
    prt_mesh m;
    prt_vec3 *positions = (prt_vec3 *)malloc((size_t)a->mesh.point_count * sizeof *positions);
    int k;
    prt_result r;
    memset(c, 0, sizeof *c);
    memset(&m, 0, sizeof m);
    c->groups = (int *)malloc((size_t)a->mesh.triangle_count * sizeof *c->groups);
    if (!positions || !c->groups) {
        free(positions);
        return why_set(w, "out of memory");
    }
    for (k = 0; k < a->mesh.point_count; k++) positions[k] = a->mesh.points[k].position;
    m.vertex_count = a->mesh.point_count;
    m.positions = positions;
    m.triangle_count = a->mesh.triangle_count;
    m.triangles = a->mesh.triangles;
    r = prt_vo_split(&m, count, (prt_real)0.1, c->groups, &c->object.group_count);
    free(positions);
    c->object.primitive_count = a->mesh.triangle_count;
    c->object.groups = c->groups;
    return r == PRT_OK ? 0 : why_set(w, "%s cannot be cut into occluders: %s", a->o.mesh, prt_result_string(r));
}

typedef struct vo_job {
    prt_vo_desc     desc;
    const checked   *c;
    prt_vo_row      *rows;
    prt_vo_occluder *occluders;        /* [count][MOST_KEPT] */
} vo_job;

static int bake_some(void *user, void *own, int first, int count) {
    vo_job *j = (vo_job *)user;
    (void)own;
    return prt_bake_vo(&j->desc, j->c->count, j->c->points, NULL, first, count, j->rows, j->occluders) != PRT_OK;
}

static void vo_free(vo_job *j) {
    free(j->rows);
    free(j->occluders);
}

static int vo_bake(const advisor *a, const checked *c, const cut_mesh *cut, int rays, uint64_t seed, const char *what,
                   vo_job *j, why *w) {
    parallel p;
    memset(j, 0, sizeof *j);
    j->desc.samples = rays;
    j->desc.max_occluders = MOST_KEPT;
    j->desc.seed = seed;
    j->desc.bias = advise_bias;
    j->desc.off = shadows_only;
    j->desc.object_count = 1;
    j->desc.objects = &cut->object;
    j->desc.tracer = &a->tracer.tracer;
    j->c = c;
    j->rows = (prt_vo_row *)calloc((size_t)c->count, sizeof *j->rows);
    j->occluders = (prt_vo_occluder *)calloc((size_t)c->count * MOST_KEPT, sizeof *j->occluders);
    if (!j->rows || !j->occluders) return why_set(w, "out of memory");
    memset(&p, 0, sizeof p);
    p.count = c->count;
    p.chunk = 8;
    p.threads = a->o.threads;
    p.what = what;
    p.unit = "rays";
    p.unit_per_item = rays;
    p.stop = &interrupted;
    p.work = bake_some;
    p.user = j;
    return parallel_all(&p, w);
}

/* At most `kept` of each vertex, packed, ready to shade. */
typedef struct vo_shading {
    const advisor        *a;
    prt_vo_params        params;
    int                  count, *first;
    prt_vo_point         *points;
    prt_vo_packed_diffuse *packed;
    prt_rgb              *out;
} vo_shading;

static void vo_shading_free(vo_shading *s) {
    free(s->first);
    free(s->points);
    free(s->packed);
    free(s->out);
}

static int vo_shading_create(const advisor *a, const vo_job *j, const trial *t, vo_shading *s, why *w) {
    int count = j->c->count, k;
    memset(s, 0, sizeof *s);
    s->a = a;
    s->count = count;
    s->params.off = shadows_only;
    s->params.law = t->law;
    s->first = (int *)malloc(((size_t)count + 1) * sizeof *s->first);
    s->points = (prt_vo_point *)calloc((size_t)count, sizeof *s->points);
    s->packed = (prt_vo_packed_diffuse *)malloc((size_t)count * MOST_KEPT * sizeof *s->packed);
    s->out = (prt_rgb *)malloc((size_t)count * sizeof *s->out);
    if (!s->first || !s->points || !s->packed || !s->out) return why_set(w, "out of memory");
    s->first[0] = 0;
    for (k = 0; k < count; k++) {
        int kept = j->rows[k].count < t->kept ? j->rows[k].count : t->kept;
        prt_result r = prt_vo_pack_diffuse(1, j->c->points[k].position, kept, j->occluders + (size_t)k * MOST_KEPT,
                                           s->packed + s->first[k]);
        if (r != PRT_OK) return why_set(w, "occluders cannot be packed: %s", prt_result_string(r));
        s->first[k + 1] = s->first[k] + kept;
        s->points[k].position = j->c->points[k].position;
        s->points[k].normal = j->c->points[k].normal;
        s->points[k].diffuse = rgb(1, 1, 1);
    }
    return 0;
}

static void vo_shade(void *user) {
    vo_shading *s = (vo_shading *)user;
    prt_vo_shade_packed_diffuse_n(&s->params, 1, s->count, s->points, vec(0, 0, 10), s->first, s->packed,
                                  s->a->o.lights, s->a->lights, s->out);
}

static int judge(const advisor *a, const vo_job *j, trial *t, int timed, why *w) {
    vo_shading s;
    int failed = vo_shading_create(a, j, t, &s, w);
    if (!failed) {
        vo_shade(&s);
        trial_judge(t, &j->c->truth, s.out);
        t->bytes = (double)sizeof *s.packed * s.first[s.count] / s.count + (double)sizeof *s.first;
        if (timed) t->ns = time_of(vo_shade, &s) / s.count * 1e9;
    }
    vo_shading_free(&s);
    return failed;
}

static void print_occluders(const vo_job *j, int groups) {
    double left[MOST_KEPT + 1], effective = 0;
    int k, i;
    prt_measure_occluders(MOST_KEPT, j->c->count, j->rows, j->occluders, left);
    for (k = 0; k < j->c->count; k++) {
        prt_real shares[MOST_KEPT];
        for (i = 0; i < MOST_KEPT; i++) shares[i] = j->occluders[(size_t)k * MOST_KEPT + (size_t)i].form_factor;
        effective += pow(2, prt_measure_entropy(MOST_KEPT, shares)) / j->c->count;
    }
    printf("cut into %2d occluders: a vertex sees %4.1f in effect; blocked share beyond the strongest 0 1 2 4 8, %%:"
           " %.1f %.1f %.1f %.1f %.1f\n", groups, effective, 100 * left[0], 100 * left[1], 100 * left[2], 100 * left[4],
           100 * left[8]);
}

static int try_cut(advisor *a, const checked *c, int groups, why *w) {
    cut_mesh cut;
    vo_job j;
    char what[64];
    int kept, law, failed;
    memset(&j, 0, sizeof j);
    snprintf(what, sizeof what, "advise: %d occluders", groups);
    failed = cut_mesh_create(a, groups, &cut, w) || vo_bake(a, c, &cut, VO_RAYS, 500 + a->o.seed, what, &j, w);
    if (!failed) print_occluders(&j, groups);
    for (kept = 1; kept <= MOST_KEPT && kept <= groups && a->lights && !failed; kept *= 2)
        for (law = PRT_VO_SINE; law <= PRT_VO_CAP && !failed; law++) {
            trial t;
            memset(&t, 0, sizeof t);
            t.method = METHOD_VO;
            t.rays = VO_RAYS;
            t.groups = groups;
            t.kept = kept;
            t.law = law;
            t.predicted = -1;
            failed = judge(a, &j, &t, 1, w);
            if (!failed) advisor_keep(a, &t);
        }
    vo_free(&j);
    free(cut.groups);
    return failed;
}

int try_occluders(advisor *a, const checked *c, why *w) {
    int k;
    for (k = 0; k < CUTS && !interrupted; k++) if (try_cut(a, c, cuts[k], w)) return interrupted ? 0 : -1;
    return 0;
}

int verify_occluders(advisor *a, trial *t, why *w) {
    cut_mesh cut;
    vo_job j;
    int failed;
    memset(&j, 0, sizeof j);
    failed = cut_mesh_create(a, t->groups, &cut, w) ||
             vo_bake(a, &a->second, &cut, t->rays, 77777 + a->o.seed, "advise: occluders elsewhere", &j, w) ||
             judge(a, &j, t, 0, w);
    vo_free(&j);
    free(cut.groups);
    return failed;
}
