#define _POSIX_C_SOURCE 200809L
#include "path_reference.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "photons.h"
#include "replacement.h"
#include "transfer_file.h"
#include "vector.h"

/* ---- random numbers: one stream for each query and half, whatever thread takes it ---- */

typedef struct random_stream { uint64_t state; } random_stream;

static double random_next(random_stream *r) {                     /* SplitMix64 [Steele 2014] */
    uint64_t z = r->state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0);
}

/* ---- surfaces ---- */

/* A place with its normal turned towards whence it is seen, along `towards`. */
typedef struct surface { prt_vec3 position, flat, normal, towards, mirrored; const material *m; int inside; } surface;

/* flat: where rays start that go through, or that come from inside. */
static surface surface_of(const material *m, prt_vec3 position, prt_vec3 flat, prt_vec3 normal, prt_vec3 towards,
                          int inside) {
    surface s;
    s.position = position;
    s.flat = flat;
    s.normal = inside ? vec(-(double)normal.x, -(double)normal.y, -(double)normal.z) : normal;
    s.towards = towards;
    s.mirrored = vec_reflect(towards, s.normal);
    s.m = m;
    s.inside = inside;
    return s;
}

/* The lobe of the mirror direction, (r.w)^shininess. */
static double lobe(const surface *s, prt_vec3 dir) {
    double c = vec_dot(s->mirrored, dir);
    return c > 0 ? pow(c, (double)s->m->shininess) : 0;
}

/* What leaves towards the eye of a light of colour 1 that comes from `dir`: pi times BRDF times cosine. */
static prt_rgb response(const surface *s, prt_vec3 dir) {
    double cosine = vec_dot(s->normal, dir), shine;
    if (cosine <= 0 || s->inside) return rgb(0, 0, 0);
    shine = rgb_mean(s->m->specular) > 0 ? lobe(s, dir) : 0;
    return rgb(cosine * (double)s->m->diffuse.r + shine * (double)s->m->specular.r,
               cosine * (double)s->m->diffuse.g + shine * (double)s->m->specular.g,
               cosine * (double)s->m->diffuse.b + shine * (double)s->m->specular.b);
}

static prt_vec3 refract_at(const surface *s) {
    return refracted(s->towards, s->normal, s->inside ? (double)s->m->index : 1 / (double)s->m->index);
}

/* The next direction of a path: u, v choose it within a lobe that `select` chooses; *weight is BRDF times cosine over
   density, of both opaque lobes together (one-sample balance heuristic [Veach 1995]). 0: the path ends. */
static int scatter(const surface *s, double select, prt_real u, prt_real v, prt_vec3 *dir, prt_rgb *weight) {
    double clear = s->inside ? 1 : rgb_mean(s->m->transmissive), diffuse = rgb_mean(s->m->diffuse);
    double shine = rgb_mean(s->m->specular), n = (double)s->m->shininess, part, cosine, density, glossy;
    if (select < clear) {
        *dir = refract_at(s);
        *weight = s->inside ? rgb(1, 1, 1) : rgb_scale(s->m->transmissive, 1 / clear);
        return 1;
    }
    if (s->inside || !(diffuse + shine > 0)) return 0;
    part = diffuse / (diffuse + shine);
    if ((select - clear) < part * (1 - clear)) {
        *dir = turn_to(s->normal, prt_sample_cosine(u, v));
    } else {
        double z = pow(1 - (double)u, 1 / (n + 1)), r = sqrt(z < 1 ? 1 - z * z : 0), a = 2 * pi * (double)v;
        *dir = turn_to(s->mirrored, vec(r * cos(a), r * sin(a), z));
    }
    cosine = vec_dot(s->normal, *dir);
    if (cosine <= 0) return 0;
    glossy = shine > 0 ? lobe(s, *dir) : 0;
    density = (1 - clear) * (part * cosine + (1 - part) * 0.5 * (n + 1) * glossy);       /* times pi */
    *weight = rgb_scale(response(s, *dir), 1 / density);
    return density > 0;
}

static prt_ray leave(const path_reference *r, const surface *s, prt_vec3 dir, double length) {
    prt_ray ray;
    int back = vec_dot(s->normal, dir) > 0;
    ray.origin = vec_add(back && !s->inside ? s->position : s->flat, back ? r->bias : -r->bias, s->normal);
    ray.dir = dir;
    ray.tmin = 0;
    ray.tmax = (prt_real)length;
    return ray;
}

/* ---- one query ---- */

typedef struct light_path { surface at; prt_rgb weight; random_stream random; } light_path;

typedef struct worker {
    path_reference *r;
    const photon_map *caustics, *coarse;        /* of the half that is at work */
    int            in_group[PATH_GROUPS], group_start[PATH_GROUPS + 1], by_group[PATH_LIGHTS];
    light_path           *paths;             /* [samples] */
    prt_ray        *rays;              /* [most] */
    prt_hit        *hits;
    unsigned char  *blocked;
    prt_rgb        *carried;           /* what each shadow ray brings where nothing blocks it */
    int            *owner;             /* its group */
    int            most;
} worker;

/* Traces the first `count` shadow rays and adds what they carry to sum[group]. */
static int add_unblocked(worker *k, int count, double scale, prt_rgb *sum) {
    const prt_tracer *t = k->r->tracer;
    int i;
    if (count == 0) return 0;
    if (t->occluded(t->user, count, k->rays, k->blocked)) return -1;
    for (i = 0; i < count; i++) {
        prt_rgb *to = &sum[k->owner[i]];
        if (k->blocked[i]) continue;
        to->r += (prt_real)scale * k->carried[i].r;
        to->g += (prt_real)scale * k->carried[i].g;
        to->b += (prt_real)scale * k->carried[i].b;
    }
    return 0;
}

/* Puts a shadow ray from s to a light at place `at`, if light from there can be seen; returns the next place. */
static int aim_at_light(worker *k, const surface *s, int light, prt_rgb weight, int at) {
    const prt_point_light *l = &k->r->lights[light];
    prt_vec3 to = vec_add(l->position, -1, s->position), dir = vec_unit(to, s->normal);
    prt_rgb seen = rgb_times(rgb_times(response(s, dir), l->color), weight);
    if (!(seen.r + seen.g + seen.b > 0)) return at;
    k->rays[at] = leave(k->r, s, dir, sqrt(vec_dot(to, to)));
    k->carried[at] = seen;
    k->owner[at] = k->r->group ? k->r->group[light] : 0;
    return at + 1;
}

static int direct_light(worker *k, const surface *s, prt_rgb *sum) {
    int i, count = 0;
    for (i = 0; i < k->r->light_count; i++) count = aim_at_light(k, s, i, rgb(1, 1, 1), count);
    return add_unblocked(k, count, 1, sum);
}

/* Adds the light of caustics that leaves s, weighted, to sum[group]. */
static void add_caustics(const worker *k, const photon_map *map, const surface *s, prt_rgb weight, prt_rgb *sum) {
    prt_rgb light[PATH_GROUPS];
    int g;
    if (map->count == 0 || s->inside) return;
    memset(light, 0, sizeof light);
    photon_map_add(map, s->position, s->normal, k->r->group, light);
    weight = rgb_times(weight, s->m->diffuse);
    for (g = 0; g < k->r->group_count; g++) {
        sum[g].r += weight.r * light[g].r;
        sum[g].g += weight.g * light[g].g;
        sum[g].b += weight.b * light[g].b;
    }
}

/* Starts the paths of one half; their first directions are a low-discrepancy set. */
static int start_paths(worker *k, const surface *s, int query, int half) {
    const path_reference *r = k->r;
    uint64_t seed = r->seed * PATH_HALVES + (uint64_t)half;
    int alive = 0, i;
    for (i = 0; i < r->samples; i++) {
        light_path *p = &k->paths[alive];
        prt_real u = 0, v = 0;
        prt_vec3 dir;
        prt_sample_square(PRT_SAMPLE_SOBOL, r->samples, seed, (uint64_t)query, i, 1, &u, &v);
        p->random.state = (seed << 48) ^ ((uint64_t)query << 20) ^ (uint64_t)i;
        random_next(&p->random);
        p->at = *s;
        if (!scatter(s, random_next(&p->random), u, v, &dir, &p->weight)) continue;
        k->rays[alive++] = leave(r, s, dir, 1e6);
    }
    return alive;
}

/* Moves the paths to what their rays hit; those that leave the scene drop out. */
static int arrive(worker *k, int alive) {
    const path_reference *r = k->r;
    int i, left = 0;
    if (r->tracer->closest(r->tracer->user, alive, k->rays, k->hits)) return -1;
    for (i = 0; i < alive; i++) {
        const prt_hit *h = &k->hits[i];
        prt_point at;
        int inside;
        if (h->object < 0) continue;
        at = scene_place(r->scene, h);
        inside = vec_dot(h->normal, k->rays[i].dir) > 0;
        k->paths[left] = k->paths[i];
        k->paths[left++].at = surface_of(&r->scene->parts[h->object].material, at.position,
                                         scene_place_flat(r->scene, h), at.normal, k->rays[i].dir, inside);
    }
    return left;
}

/* One light of each group, as many times as bright as the group has lights. */
static int light_paths(worker *k, int alive, prt_rgb *sum) {
    const path_reference *r = k->r;
    int i, g, count = 0;
    for (i = 0; i < alive; i++) {
        light_path *p = &k->paths[i];
        add_caustics(k, k->coarse, &p->at, rgb_scale(p->weight, 1.0 / r->samples), sum);
        for (g = 0; g < r->group_count; g++) {
            int n = k->in_group[g], chosen = (int)(random_next(&p->random) * n);
            if (n)
                count = aim_at_light(k, &p->at, k->by_group[k->group_start[g] + chosen], rgb_scale(p->weight, n),
                                     count);
        }
    }
    return add_unblocked(k, count, 1.0 / r->samples, sum);
}

/* Scatters the paths; from the third bounce on they survive by chance, as far as they still carry something. */
static int go_on(worker *k, int alive, int bounce) {
    int i, left = 0;
    for (i = 0; i < alive; i++) {
        light_path p = k->paths[i];
        prt_vec3 dir;
        prt_rgb weight;
        prt_real u = (prt_real)random_next(&p.random), v = (prt_real)random_next(&p.random);
        double stay = 1;
        if (!scatter(&p.at, random_next(&p.random), u < 1 ? u : 0, v < 1 ? v : 0, &dir, &weight)) continue;
        p.weight = rgb_times(p.weight, weight);
        if (bounce >= 3) stay = rgb_mean(p.weight) < 0.95 ? rgb_mean(p.weight) : 0.95;
        if (random_next(&p.random) >= stay) continue;
        p.weight = rgb_scale(p.weight, 1 / stay);
        k->rays[left] = leave(k->r, &p.at, dir, 1e6);
        k->paths[left++] = p;
    }
    return left;
}

static int shade_query(worker *k, int query) {
    path_reference *r = k->r;
    const path_query *q = &r->queries[query];
    prt_rgb direct[PATH_GROUPS];
    surface s;
    int half, g, bounce, alive;
    memset(direct, 0, sizeof direct);
    if (q->part >= 0) {
        s = surface_of(&r->scene->parts[q->part].material, q->position, q->position, q->normal, q->towards, 0);
        if (direct_light(k, &s, direct)) return -1;
    }
    for (half = 0; half < PATH_HALVES; half++) {
        prt_rgb sum[PATH_GROUPS];
        memcpy(sum, direct, sizeof sum);
        k->caustics = &r->caustics[half];
        k->coarse = &r->coarse[half];
        if (q->part >= 0) add_caustics(k, k->caustics, &s, rgb(1, 1, 1), sum);
        alive = q->part >= 0 ? start_paths(k, &s, query, half) : 0;
        for (bounce = 1; alive > 0 && bounce <= r->depth; bounce++) {
            alive = arrive(k, alive);
            if (alive < 0 || light_paths(k, alive, sum)) return -1;
            alive = bounce < r->depth ? go_on(k, alive, bounce) : 0;
        }
        for (g = 0; g < r->group_count; g++) r->out[half][(size_t)query * (size_t)r->group_count + (size_t)g] = sum[g];
    }
    return 0;
}

/* ---- threads ---- */

static void sort_lights(worker *k) {
    const path_reference *r = k->r;
    int g, i, at = 0;
    for (g = 0; g < r->group_count; g++) {
        k->group_start[g] = at;
        for (i = 0; i < r->light_count; i++) if ((r->group ? r->group[i] : 0) == g) k->by_group[at++] = i;
        k->in_group[g] = at - k->group_start[g];
    }
}

static void worker_free(void *own) {
    worker *k = (worker *)own;
    free(k->paths);
    free(k->rays);
    free(k->hits);
    free(k->blocked);
    free(k->carried);
    free(k->owner);
    free(k);
}

static int worker_create(void *user, void **own) {
    path_reference *r = (path_reference *)user;
    size_t most = (size_t)r->samples * (size_t)r->group_count;
    worker *k = (worker *)calloc(1, sizeof *k);
    if (!k) return -1;
    if (most < (size_t)r->light_count) most = (size_t)r->light_count;
    if (most < 1) most = 1;
    k->r = r;
    k->paths = (light_path *)malloc((size_t)(r->samples + 1) * sizeof *k->paths);
    k->rays = (prt_ray *)malloc(most * sizeof *k->rays);
    k->hits = (prt_hit *)malloc(most * sizeof *k->hits);
    k->blocked = (unsigned char *)malloc(most);
    k->carried = (prt_rgb *)malloc(most * sizeof *k->carried);
    k->owner = (int *)malloc(most * sizeof *k->owner);
    sort_lights(k);
    *own = k;
    if (k->paths && k->rays && k->hits && k->blocked && k->carried && k->owner) return 0;
    worker_free(k);
    return -1;
}

static int shade_queries(void *user, void *own, int first, int count) {
    int skip = ((path_reference *)user)->done, i;
    for (i = 0; i < count; i++) if (shade_query((worker *)own, skip + first + i)) return -1;
    return 0;
}

static int trace_queries(path_reference *r, why *w) {
    parallel job;
    int failed;
    memset(&job, 0, sizeof job);
    job.count = r->query_count - r->done;
    job.chunk = 64;
    job.threads = r->threads;
    job.what = r->what;
    job.unit = "paths";
    job.unit_per_item = PATH_HALVES * r->samples;
    job.stop = r->stop;
    job.begin = worker_create;
    job.work = shade_queries;
    job.end = worker_free;
    job.user = r;
    failed = parallel_run(&job, w);
    r->done += job.done;
    return failed;
}

int path_reference_trace(path_reference *r, why *w) {
    double disc = 0.015 * (double)r->scene->mesh.report.radius;
    int half, failed = 0;
    if (r->group_count < 1 || r->group_count > PATH_GROUPS || r->light_count < 0 || r->light_count > PATH_LIGHTS)
        return why_set(w, "the reference takes 1 to %d groups of at most %d lights in all", PATH_GROUPS, PATH_LIGHTS);
    memset(r->caustics, 0, sizeof r->caustics);
    memset(r->coarse, 0, sizeof r->coarse);
    for (half = 0; half < PATH_HALVES && !failed; half++) {
        uint64_t seed = r->seed * PATH_HALVES + (uint64_t)half;
        failed = photon_map_make(r->scene, r->tracer, r->light_count, r->lights, r->photons, disc, seed,
                                 &r->caustics[half], w) ||
                 photon_map_make(r->scene, r->tracer, r->light_count, r->lights, r->photons / 32, disc, seed,
                                 &r->coarse[half], w);
    }
    if (!failed) failed = trace_queries(r, w);
    for (half = 0; half < PATH_HALVES; half++) {
        photon_map_free(&r->caustics[half]);
        photon_map_free(&r->coarse[half]);
    }
    return failed;
}

/* ---- the file of what is finished ---- */

typedef struct kept { char magic[8]; uint64_t job; int32_t done, real_size; } kept;

static uint64_t hash(uint64_t h, const void *bytes, size_t count) { return transfer_checksum(h, bytes, count); }

/* Everything that the result depends on. Structures are hashed member by member where they could hold padding. */
static uint64_t job_of(const path_reference *r) {
    const int counts[] = { r->light_count, r->group_count, r->samples, r->depth, r->query_count, r->scene->part_count };
    uint64_t h = mesh_hash(&r->scene->mesh);
    int k;
    h = hash(h, counts, sizeof counts);
    if (r->photons) h = hash(h, &r->photons, sizeof r->photons);
    h = hash(h, &r->bias, sizeof r->bias);
    h = hash(h, &r->seed, sizeof r->seed);
    h = hash(h, r->lights, (size_t)r->light_count * sizeof *r->lights);
    if (r->group) h = hash(h, r->group, (size_t)r->light_count * sizeof *r->group);
    h = hash(h, r->queries, (size_t)r->query_count * sizeof *r->queries);
    for (k = 0; k < r->scene->part_count; k++) {
        h = hash(h, &r->scene->parts[k].material, sizeof r->scene->parts[k].material);
        h = hash(h, &r->scene->parts[k].triangle_count, sizeof r->scene->parts[k].triangle_count);
    }
    return h;
}

static kept stamp_of(const path_reference *r) {
    kept k;
    memset(&k, 0, sizeof k);
    memcpy(k.magic, "PRTPATH", 8);
    k.job = job_of(r);
    k.real_size = (int32_t)sizeof(prt_real);
    return k;
}

/* Sets done to 0 where the file is of another job, cut short, or not there. */
static void take_up(path_reference *r, const char *path) {
    kept want = stamp_of(r), got;
    FILE *file = fopen(path, "rb");
    size_t values;
    int half;
    r->done = 0;
    if (!file) return;
    if (fread(&got, sizeof got, 1, file) == 1 && got.done >= 0 && got.done <= r->query_count) {
        want.done = got.done;
        values = (size_t)got.done * (size_t)r->group_count;
        r->done = memcmp(&want, &got, sizeof want) == 0 ? got.done : 0;
        for (half = 0; half < PATH_HALVES && r->done; half++)
            if (fread(r->out[half], sizeof(prt_rgb), values, file) != values) r->done = 0;
    }
    fclose(file);
}

static int put_down(const path_reference *r, const char *path, why *w) {
    kept stamp = stamp_of(r);
    replacement to;
    int half;
    stamp.done = r->done;
    if (replacement_open(path, &to, w)) return -1;
    fwrite(&stamp, sizeof stamp, 1, to.file);
    for (half = 0; half < PATH_HALVES; half++)
        fwrite(r->out[half], sizeof(prt_rgb), (size_t)r->done * (size_t)r->group_count, to.file);
    return replacement_commit(&to, w);
}

int path_reference_resume(path_reference *r, const char *path, why *w) {
    int before;
    take_up(r, path);
    before = r->done;
    if (before == r->query_count) return 0;
    return path_reference_trace(r, w) || (r->done > before && put_down(r, path, w)) ? -1 : 0;
}
