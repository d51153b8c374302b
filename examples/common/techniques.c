#define _POSIX_C_SOURCE 200809L
#include "techniques.h"

#include <stdlib.h>
#include <string.h>

#include "bake_job.h"
#include "bounce_job.h"
#include "parallel.h"
#include "progress.h"
#include "vector.h"

const char *const technique_names[TECHNIQUE_COUNT] = {
    "Phong", "AO", "VO/DD", "VO/DD, cap law", "VO/DD+DS+SS", "VO/DD+DS+SS, cap law", "SH3", "SH6", "CH3", "CH6",
    "SH3, glossy", "SH6, glossy"
};

enum { DIFFUSE = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS };
enum { EVERYTHING = PRT_VO_NO_SHADOW | PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS };

/* ---- setting up ---- */

static prt_vo_point shaded_point(const scene *s, int k) {
    const material *m = &s->parts[scene_part_of_point(s, k)].material;
    prt_vo_point p;
    memset(&p, 0, sizeof p);
    p.position = s->mesh.points[k].position;
    p.normal = s->mesh.points[k].normal;
    p.diffuse = m->diffuse;
    p.specular = m->specular;
    p.shininess = m->shininess;
    return p;
}

static void describe_parts(techniques *t) {
    const scene *s = t->scene;
    int k;
    for (k = 0; k < s->part_count; k++) {
        prt_vo_object *o = &t->objects[k];
        memset(o, 0, sizeof *o);
        o->diffuse = s->parts[k].material.diffuse;
        o->specular = s->parts[k].material.specular;
        o->transmissive = s->parts[k].material.transmissive;
        o->refraction = s->parts[k].material.index;
        o->primitive_count = s->parts[k].triangle_count;
        o->group_count = 1;
        o->triangles = s->mesh.triangles + 3 * (size_t)s->parts[k].first_triangle;
    }
    t->group_count = s->part_count;
}

/* The part as a mesh of its own. */
static int extract(const scene *s, const scene_part *part, prt_mesh *m, why *w) {
    prt_vec3 *positions = (prt_vec3 *)malloc((size_t)part->point_count * sizeof *positions);
    uint32_t *triangles = (uint32_t *)malloc(3 * (size_t)part->triangle_count * sizeof *triangles);
    int k;
    memset(m, 0, sizeof *m);
    m->vertex_count = part->point_count;
    m->positions = positions;
    m->triangle_count = part->triangle_count;
    m->triangles = triangles;
    if (!positions || !triangles) return why_set(w, "out of memory for occluders");
    for (k = 0; k < part->point_count; k++) positions[k] = s->mesh.points[part->first_point + k].position;
    for (k = 0; k < 3 * part->triangle_count; k++)
        triangles[k] = s->mesh.triangles[3 * (size_t)part->first_triangle + (size_t)k] - (uint32_t)part->first_point;
    return 0;
}

static void release(prt_mesh *m) {
    free((void *)m->positions);
    free((void *)m->triangles);
}

static double area_of(const prt_mesh *m) {
    double sum = 0;
    int k;
    for (k = 0; k < m->triangle_count; k++) {
        const uint32_t *c = m->triangles + 3 * (size_t)k;
        prt_vec3 a = vec_add(m->positions[c[1]], -1, m->positions[c[0]]),
                 b = vec_add(m->positions[c[2]], -1, m->positions[c[0]]);
        double aa = vec_dot(a, a), bb = vec_dot(b, b), ab = vec_dot(a, b);
        sum += 0.5 * sqrt(aa * bb > ab * ab ? aa * bb - ab * ab : 0);
    }
    return sum;
}

/* One group for each part, then always one more for the part with the most area a group. */
static void share_out(int parts, const double *area, int wanted, int *counts) {
    int k, most, made;
    for (k = 0; k < parts; k++) counts[k] = 1;
    for (made = parts; made < wanted; made++) {
        for (most = 0, k = 1; k < parts; k++) if (area[k] / counts[k] > area[most] / counts[most]) most = k;
        counts[most]++;
    }
}

static int split_parts(techniques *t, why *w) {
    const scene *s = t->scene;
    double area[SCENE_PARTS];
    int counts[SCENE_PARTS], k, failed = 0;
    prt_mesh m;
    t->groups = (int *)malloc((size_t)s->mesh.triangle_count * sizeof *t->groups);
    if (!t->groups) return why_set(w, "out of memory for occluders");
    for (k = 0; k < s->part_count && !failed; k++) {
        failed = extract(s, &s->parts[k], &m, w);
        area[k] = failed ? 0 : area_of(&m);
        release(&m);
    }
    if (failed) return -1;
    share_out(s->part_count, area, t->occluders_wanted, counts);
    for (k = 0, t->group_count = 0; k < s->part_count && !failed; k++) {
        prt_vo_object *o = &t->objects[k];
        int *groups = t->groups + s->parts[k].first_triangle;
        failed = extract(s, &s->parts[k], &m, w);
        if (!failed && prt_vo_split(&m, counts[k], (prt_real)0.1, groups, &o->group_count) != PRT_OK)
            failed = why_set(w, "%s cannot be split into occluders", s->parts[k].name);
        o->groups = groups;
        t->group_count += o->group_count;
        release(&m);
    }
    return failed;
}

static int allocate(techniques *t, why *w) {
    size_t points = (size_t)t->scene->mesh.point_count;
    int k;
    t->points = (prt_vo_point *)malloc(points * sizeof *t->points);
    t->matte_points = (prt_vo_point *)malloc(points * sizeof *t->matte_points);
    t->open = (prt_real *)malloc(points * sizeof *t->open);
    t->rows = (prt_vo_row *)malloc(points * sizeof *t->rows);
    t->first = (int *)malloc((points + 1) * sizeof *t->first);
    t->occluders = (prt_vo_occluder *)malloc(prt_bake_vo_size(t->most_occluders, t->scene->mesh.point_count));
    for (k = 0; k < TECHNIQUES_SH && t->with_sh; k++) {
        size_t row = 3 * (size_t)PRT_SH_COUNT(techniques_bands[k]) * sizeof(prt_real);
        t->transfer[k] = (prt_real *)malloc(points * row);
        t->moments[k] = (prt_real *)malloc(points * row);
        if (!t->transfer[k] || !t->moments[k]) return why_set(w, "out of memory for transfer");
        if (!t->with_glossy) continue;
        t->matrices[k] = (prt_real *)malloc(points * row * (size_t)PRT_SH_COUNT(techniques_bands[k]));
        if (!t->matrices[k]) return why_set(w, "out of memory for transfer matrices");
    }
    return t->points && t->matte_points && t->open && t->rows && t->first && t->occluders
               ? 0
               : why_set(w, "out of memory for occluders");
}

void techniques_free(techniques *t) {
    int k;
    free(t->points);
    free(t->matte_points);
    free(t->open);
    free(t->rows);
    free(t->first);
    free(t->occluders);
    free(t->indexed);
    free(t->indexed_diffuse);
    free(t->groups);
    for (k = 0; k < TECHNIQUES_SH; k++) {
        free(t->transfer[k]);
        free(t->moments[k]);
        free(t->matrices[k]);
    }
    memset(t, 0, sizeof *t);
}

/* ---- bakes ---- */

/* Runs a job over the vertices; *seconds is processor time. Interrupted: -1. */
static int run_job(const techniques *t, const char *what, int (*work)(void *, void *, int, int), void *user,
                   double *seconds, why *w) {
    double before = processor_seconds();
    parallel job;
    memset(&job, 0, sizeof job);
    job.count = t->scene->mesh.point_count;
    job.chunk = 32;
    job.threads = t->threads;
    job.what = what;
    job.unit = "rays";
    job.unit_per_item = t->rays;
    job.stop = t->stop;
    job.work = work;
    job.user = user;
    if (parallel_run(&job, w)) return -1;
    *seconds = processor_seconds() - before;
    return job.done == job.count ? 0 : why_set(w, "%s: interrupted", what);
}

static prt_vo_desc vo_desc(const techniques *t) {
    prt_vo_desc d;
    memset(&d, 0, sizeof d);
    d.samples = t->rays;
    d.max_occluders = t->most_occluders;
    d.bias = t->bias;
    d.object_count = t->scene->part_count;
    d.objects = t->objects;
    d.tracer = &t->tracer->tracer;
    d.off = t->off | (t->shining ? 0 : PRT_VO_NO_DS | PRT_VO_NO_SS);
    return d;
}

static int bake_open(void *user, void *own, int first, int count) {
    techniques *t = (techniques *)user;
    prt_vo_desc d = vo_desc(t);
    (void)own;
    return prt_bake_vo_ao(&d, t->scene->mesh.point_count, t->scene->mesh.points, first, count, t->open) != PRT_OK;
}

static int bake_occluders(void *user, void *own, int first, int count) {
    techniques *t = (techniques *)user;
    prt_vo_desc d = vo_desc(t);
    (void)own;
    return prt_bake_vo(&d, t->scene->mesh.point_count, t->scene->mesh.points, t->open, first, count, t->rows,
                       t->occluders) != PRT_OK;
}

/* The forms that shading reads: colours are those of the parts. */
static int index_occluders(techniques *t, why *w) {
    int opaque = (prt_vo_unneeded(t->scene->part_count, t->objects) & PRT_VO_NO_CAUSTIC) != 0;
    t->material_count = t->material_count_diffuse = 0;
    t->indexed = (prt_vo_indexed *)malloc((size_t)t->occluder_count * sizeof *t->indexed + 1);
    t->indexed_diffuse = (prt_vo_indexed_diffuse *)malloc((size_t)t->occluder_count * sizeof *t->indexed_diffuse + 1);
    if (!t->indexed || !t->indexed_diffuse) return why_set(w, "out of memory for occluders");
    if (prt_vo_index(t->occluder_count, t->occluders, SCENE_PARTS, t->materials, &t->material_count, t->indexed) !=
            PRT_OK ||
        (opaque && prt_vo_index_diffuse(t->occluder_count, t->occluders, SCENE_PARTS, t->materials_diffuse,
                                        &t->material_count_diffuse, t->indexed_diffuse) != PRT_OK))
        return why_set(w, "the occluders have more colours than parts");
    if (!opaque) {
        free(t->indexed_diffuse);
        t->indexed_diffuse = NULL;
    }
    return 0;
}

static int bake_vo(techniques *t, why *w) {
    int points = t->scene->mesh.point_count, k;
    if (run_job(t, "bake: ambient occlusion", bake_open, t, &t->ao_seconds, w)) return -1;
    if (t->shining && t->with_time_of_dd) {                /* once without the specular terms, for its time */
        t->shining = 0;
        k = run_job(t, "bake: occluders, diffuse", bake_occluders, t, &t->vo_dd_seconds, w);
        t->shining = 1;
        if (k) return -1;
    }
    if (run_job(t, "bake: occluders", bake_occluders, t, &t->vo_seconds, w)) return -1;
    if (!t->shining) t->vo_dd_seconds = t->vo_seconds;
    t->dropped = 0;
    for (k = 0; k < points; k++) t->dropped += t->rows[k].dropped;
    if (prt_vo_compact(t->most_occluders, points, t->rows, t->occluders, t->first) != PRT_OK)
        return why_set(w, "the occluders do not fit into one array");
    t->occluder_count = t->first[points];
    return index_occluders(t, w);
}

enum { MOST_COEFFICIENTS = 64 };

static int bake_direct(const techniques *t, int bands, prt_real *transfer, double *seconds, why *w) {
    double before = processor_seconds();
    bake_job job;
    prt_result result;
    memset(&job, 0, sizeof job);
    job.desc.bands = bands;
    job.desc.samples = t->rays;
    job.desc.bias = t->bias;
    job.desc.tracer = &t->tracer->tracer;
    job.point_count = t->scene->mesh.point_count;
    job.points = t->scene->mesh.points;
    job.threads = t->threads;
    job.what = "bake: transfer";
    job.stop = t->stop;
    job.transfer = transfer;
    job.done = (unsigned char *)calloc((size_t)job.point_count, 1);
    if (!job.done) return why_set(w, "out of memory");
    result = bake_job_run(&job);
    free(job.done);
    *seconds = processor_seconds() - before;
    return result == PRT_OK ? 0 : why_set(w, "bake: transfer: %s", prt_result_string(result));
}

/* The same transfer as inner products with CH, which the thesis dots in the place of coefficients. */
static double make_moments(const techniques *t, int k) {
    double before = processor_seconds();
    size_t n = (size_t)PRT_SH_COUNT(techniques_bands[k]), rows = 3 * (size_t)t->scene->mesh.point_count, i;
    for (i = 0; i < rows; i++) {
        prt_real ch[MOST_COEFFICIENTS];
        prt_ch_from_sh(techniques_bands[k], t->transfer[k] + i * n, ch);
        prt_ch_to_moments(techniques_bands[k], ch, t->moments[k] + i * n);
    }
    return processor_seconds() - before;
}

/* objects: [SCENE_PARTS], filled here. */
static prt_bounce_desc bounce_desc(const techniques *t, int bands, prt_bounce_object *objects) {
    prt_bounce_desc desc;
    memset(&desc, 0, sizeof desc);
    bounce_objects_of(t->scene, objects);
    desc.bands = bands;
    desc.samples = t->rays;
    desc.bias = t->bias;
    desc.planes = 3;
    desc.object_count = t->scene->part_count;
    desc.objects = objects;
    desc.tracer = &t->tracer->tracer;
    return desc;
}

/* The second pass of transfer: what the parts that a vertex sees send on, of their own transfer without bounce; to
   transfer, three planes, with the direct one in it. */
static int bake_bounce(const techniques *t, int bands, const prt_real *direct, prt_real *transfer, double *seconds,
                       why *w) {
    double before = processor_seconds();
    prt_bounce_object objects[SCENE_PARTS];
    bounce_job job;
    memset(&job, 0, sizeof job);
    job.desc = bounce_desc(t, bands, objects);
    job.point_count = t->scene->mesh.point_count;
    job.points = t->scene->mesh.points;
    job.previous = direct;
    job.out = transfer;
    job.threads = t->threads;
    job.what = "bake: transfer of one bounce";
    job.stop = t->stop;
    if (bounce_job_run(&job, w)) return -1;
    prt_bounce_add(bands, job.point_count, 1, direct, 3, transfer, NULL);
    *seconds = processor_seconds() - before;
    return 0;
}

/* Matrices with what other parts reflect of the light, of the transfer with its bounce. */
typedef struct glossy { const techniques *t; prt_bounce_desc desc; int k; } glossy;
static int glossy_range(void *user, void *own, int first, int count) {
    const glossy *g = (const glossy *)user;
    const mesh *m = &g->t->scene->mesh;
    (void)own;
    return prt_bake_glossy(&g->desc, 0, m->point_count, m->points, g->t->transfer[g->k], first, count,
                           g->t->matrices[g->k]) != PRT_OK;
}

static int bake_glossy(techniques *t, int k, why *w) {
    prt_bounce_object objects[SCENE_PARTS];
    glossy g;
    g.t = t;
    g.desc = bounce_desc(t, techniques_bands[k], objects);
    g.desc.previous_planes = 3;
    g.k = k;
    return run_job(t, "bake: transfer matrices", glossy_range, &g, &t->glossy_seconds[k], w);
}

static int bake_sh(techniques *t, int k, why *w) {
    size_t n = (size_t)PRT_SH_COUNT(techniques_bands[k]);
    prt_real *direct = (prt_real *)malloc((size_t)t->scene->mesh.point_count * n * sizeof *direct);
    int failed;
    if (!direct) return why_set(w, "out of memory for transfer");
    failed = bake_direct(t, techniques_bands[k], direct, &t->sh_seconds[k][0], w) ||
             bake_bounce(t, techniques_bands[k], direct, t->transfer[k], &t->sh_seconds[k][1], w);
    free(direct);
    if (failed) return -1;
    t->ch_seconds[k] = make_moments(t, k);
    return t->with_glossy ? bake_glossy(t, k, w) : 0;
}

int techniques_bake(techniques *t, why *w) {
    int k;
    describe_parts(t);
    if (allocate(t, w) || (t->occluders_wanted && split_parts(t, w))) return -1;
    for (k = 0; k < t->scene->mesh.point_count; k++) {
        t->points[k] = t->matte_points[k] = shaded_point(t->scene, k);
        t->matte_points[k].specular = rgb(0, 0, 0);
    }
    if (bake_vo(t, w)) return -1;
    for (k = 0; k < TECHNIQUES_SH && t->with_sh; k++) if (bake_sh(t, k, w)) return -1;
    return 0;
}

/* ---- shading ---- */

static int sh_of(technique which) {
    return which == TECHNIQUE_SH6 || which == TECHNIQUE_CH6 || which == TECHNIQUE_SH6_GLOSSY;
}
static int is_glossy(technique which) { return which >= TECHNIQUE_SH3_GLOSSY; }
static int is_ch(technique which) { return which == TECHNIQUE_CH3 || which == TECHNIQUE_CH6; }

/* Point lights as deltas of irradiance pi c in their directions from the centre: three planes of inner products. */
static void project_lights(technique which, prt_vec3 centre, int light_count, const prt_point_light *lights,
                           prt_real *light) {
    int bands = techniques_bands[sh_of(which)], n = PRT_SH_COUNT(bands), k, i;
    memset(light, 0, 3 * (size_t)n * sizeof *light);
    for (k = 0; k < light_count; k++) {
        prt_vec3 dir = vec_unit(vec_add(lights[k].position, -1, centre), vec(0, 0, 1));
        prt_rgb c = rgb_scale(lights[k].color, pi);
        prt_real y[MOST_COEFFICIENTS];
        if (is_ch(which)) prt_ch_eval(bands, dir, y); else prt_sh_delta(bands, dir, y);
        for (i = 0; i < n; i++) {
            light[i] += c.r * y[i];
            light[n + i] += c.g * y[i];
            light[2 * n + i] += c.b * y[i];
        }
    }
}

/* out += Phong's lobe: specular max(0, r.w)^shininess over pi is 2/(shininess + 1) of one of integral 1. */
static void add_lobes(const techniques *t, int bands, const prt_real *matrix, prt_vec3 eye, const prt_real *light,
                      prt_rgb *out) {
    size_t n = (size_t)PRT_SH_COUNT(bands);
    prt_real zonal[PRT_MAX_BANDS], incident[3 * MOST_COEFFICIENTS], made_for = -1;
    int k;
    for (k = 0; k < t->scene->mesh.point_count; k++, matrix += 3 * n * n) {
        const prt_vo_point *p = &t->points[k];
        prt_vec3 towards = vec_unit(vec_add(p->position, -1, eye), p->normal);
        prt_rgb lobe = { 0, 0, 0 };
        if (vec_dot(towards, p->normal) >= 0) continue;
        if (p->shininess != made_for) prt_phong_zonal(bands, p->shininess, zonal);
        made_for = p->shininess;
        prt_shade_incident(bands, bands, 3, matrix, light, incident);
        prt_shade_glossy(bands, incident, zonal, vec_reflect(towards, p->normal), &lobe);
        lobe = rgb_scale(rgb_times(lobe, p->specular), 2 / ((double)p->shininess + 1));
        out[k].r += lobe.r; out[k].g += lobe.g; out[k].b += lobe.b;
    }
}

static void shade_sh(const techniques *t, technique which, prt_vec3 eye, prt_vec3 centre, int light_count,
                     const prt_point_light *lights, prt_rgb *out) {
    int bands = techniques_bands[sh_of(which)], k;
    const prt_real *rows = is_ch(which) ? t->moments[sh_of(which)] : t->transfer[sh_of(which)];
    prt_real light[3 * MOST_COEFFICIENTS];
    project_lights(which, centre, light_count, lights, light);
    prt_shade_diffuse_rgb_n(bands, t->scene->mesh.point_count, rows, light, out);
    for (k = 0; k < t->scene->mesh.point_count; k++) out[k] = rgb_times(out[k], t->points[k].diffuse);
    if (is_glossy(which)) add_lobes(t, bands, t->matrices[sh_of(which)], eye, light, out);
}

static prt_vo_params params_of(technique which) {
    prt_vo_params p;
    memset(&p, 0, sizeof p);
    if (which == TECHNIQUE_PHONG || which == TECHNIQUE_AO) p.off = EVERYTHING;
    if (which == TECHNIQUE_VO_DD || which == TECHNIQUE_VO_DD_CAP) p.off = PRT_VO_NO_DS | PRT_VO_NO_SS;
    if (which == TECHNIQUE_VO_DD_CAP || which == TECHNIQUE_VO_CAP) p.law = PRT_VO_CAP;
    return p;
}

static int shade_vo(const techniques *t, technique which, prt_vec3 eye, int light_count, const prt_point_light *lights,
                    prt_rgb *out, why *w) {
    prt_vo_params p = params_of(which);
    int points = t->scene->mesh.point_count, k, alone = p.off == EVERYTHING;
    int *nobody = alone ? (int *)calloc((size_t)points + 1, sizeof *nobody) : NULL;
    const int *first = alone ? nobody : t->first;
    const prt_vo_point *at = t->matte ? t->matte_points : t->points;
    prt_result result;
    if (alone && !nobody) return why_set(w, "out of memory");
    p.off |= prt_vo_unneeded(t->scene->part_count, t->objects) | (t->matte ? PRT_VO_NO_DS | PRT_VO_NO_SS : 0);
    result = (p.off & DIFFUSE) == DIFFUSE && t->indexed_diffuse
                 ? prt_vo_shade_indexed_diffuse_n(&p, points, at, eye, first, t->material_count_diffuse,
                                                  t->materials_diffuse, t->indexed_diffuse, light_count, lights, out)
                 : prt_vo_shade_indexed_n(&p, points, at, eye, first, t->material_count, t->materials, t->indexed,
                                          light_count, lights, out);
    for (k = 0; k < points && which == TECHNIQUE_AO; k++) out[k] = rgb_scale(out[k], (double)t->open[k]);
    free(nobody);
    return result == PRT_OK ? 0 : why_set(w, "shading: %s", prt_result_string(result));
}

int techniques_shade(const techniques *t, technique which, prt_vec3 eye, prt_vec3 centre, int light_count,
                     const prt_point_light *lights, prt_rgb *out, double *seconds, why *w) {
    double before = processor_seconds();
    if (which >= TECHNIQUE_SH3) shade_sh(t, which, eye, centre, light_count, lights, out);
    else if (shade_vo(t, which, eye, light_count, lights, out, w)) return -1;
    if (seconds) *seconds = processor_seconds() - before;
    return 0;
}
