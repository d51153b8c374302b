#include "sky_paths.h"

#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "vector.h"

typedef struct sky_path { prt_rgb weight; uint64_t random; } sky_path;

typedef struct sky_buffers {
    sky_path *paths;                   /* [samples], those that are still under way */
    prt_ray  *rays;
    prt_hit  *hits;
} sky_buffers;

static double next_random(uint64_t *state) {               /* SplitMix64 [Steele 2014] */
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (double)((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0);
}

static prt_ray leave(const sky_paths *s, prt_vec3 position, prt_vec3 normal, prt_vec3 dir) {
    prt_ray ray;
    ray.origin = vec_add(position, s->bias, normal);
    ray.dir = dir;
    ray.tmin = 0;
    ray.tmax = (prt_real)1e6;
    return ray;
}

/* The paths' first directions, a low-discrepancy set; those of a lobe that go below the surface carry nothing. */
static int start(const sky_paths *s, sky_buffers *b, int place, int half) {
    const prt_point *at = &s->places[place];
    uint64_t seed = s->seed * SKY_HALVES + (uint64_t)half;
    int alive = 0, k;
    for (k = 0; k < s->samples; k++) {
        prt_real u = 0, v = 0;
        prt_vec3 dir;
        prt_sample_square(PRT_SAMPLE_SOBOL, s->samples, seed, (uint64_t)place, k, 1, &u, &v);
        if (s->lobe) {
            double z = pow(1 - (double)u, 1 / (s->exponent + 1)), r = sqrt(z < 1 ? 1 - z * z : 0);
            double a = 2 * pi * (double)v;
            dir = turn_to(s->lobe[place], vec(r * cos(a), r * sin(a), z));
            if (vec_dot(dir, at->normal) <= 0) continue;
        } else {
            dir = turn_to(at->normal, prt_sample_cosine(u, v));
        }
        b->paths[alive].weight = rgb(1, 1, 1);
        b->paths[alive].random = (seed << 48) ^ ((uint64_t)place << 20) ^ (uint64_t)k;
        b->rays[alive++] = leave(s, at->position, at->normal, dir);
    }
    return alive;
}

static void add_light(const sky_paths *s, prt_vec3 dir, prt_rgb weight, int surfaces, double (*sum)[3]) {
    prt_real light[3 * PRT_SH_COUNT(ENVIRONMENT_BANDS)], y[PRT_SH_COUNT(ENVIRONMENT_BANDS)];
    const float *texel = s->light->map.rgb + 3 * environment_texel(s->light, dir);
    double *full = sum[surfaces], *cut = sum[SKY_BOUNCES + 1 + surfaces];
    prt_rgb banded = { 0, 0, 0 };
    environment_light(s->light, s->bands, light);
    prt_sh_eval(s->bands, dir, y);
    prt_shade_diffuse(s->bands, y, light, &banded);
    full[0] += (double)weight.r * (double)texel[0];
    full[1] += (double)weight.g * (double)texel[1];
    full[2] += (double)weight.b * (double)texel[2];
    cut[0] += (double)(weight.r * banded.r);
    cut[1] += (double)(weight.g * banded.g);
    cut[2] += (double)(weight.b * banded.b);
}

/* Those that met nothing bring light, those that met the back of a face nothing, the others go on from there. */
static int go_on(const sky_paths *s, sky_buffers *b, int alive, int surfaces, double (*sum)[3]) {
    int left = 0, k;
    for (k = 0; k < alive; k++) {
        const prt_hit *hit = &b->hits[k];
        sky_path path = b->paths[k];
        prt_point at;
        prt_real u, v;
        if (hit->object < 0) add_light(s, b->rays[k].dir, path.weight, surfaces, sum);
        if (hit->object < 0 || vec_dot(b->rays[k].dir, hit->normal) > 0) continue;
        at = scene_place(s->scene, hit);
        path.weight = rgb_times(path.weight, s->scene->parts[hit->object].material.diffuse);
        u = (prt_real)next_random(&path.random);
        v = (prt_real)next_random(&path.random);
        b->rays[left] = leave(s, at.position, at.normal, turn_to(at.normal, prt_sample_cosine(u, v)));
        b->paths[left++] = path;
    }
    return left;
}

static int trace_place(const sky_paths *s, sky_buffers *b, int place, int half) {
    double sum[SKY_LIGHTS * (SKY_BOUNCES + 1)][3] = { { 0 } };
    prt_rgb *out = s->out[half] + (size_t)place * SKY_LIGHTS * (SKY_BOUNCES + 1);
    int alive = start(s, b, place, half), surfaces, k;
    for (surfaces = 0; surfaces <= SKY_BOUNCES && alive > 0; surfaces++) {
        for (k = 0; k < alive; k++) b->hits[k].object = -1;
        if (s->tracer->closest(s->tracer->user, alive, b->rays, b->hits)) return -1;
        alive = go_on(s, b, alive, surfaces, sum);
    }
    for (k = 0; k < SKY_LIGHTS * (SKY_BOUNCES + 1); k++)
        out[k] = rgb(sum[k][0] / s->samples, sum[k][1] / s->samples, sum[k][2] / s->samples);
    return 0;
}

static void end(void *own) {
    sky_buffers *b = (sky_buffers *)own;
    free(b->paths);
    free(b->rays);
    free(b->hits);
    free(b);
}

static int begin(void *user, void **own) {
    const sky_paths *s = (const sky_paths *)user;
    sky_buffers *b = (sky_buffers *)calloc(1, sizeof *b);
    size_t count = (size_t)s->samples;
    if (!b) return -1;
    b->paths = (sky_path *)malloc(count * sizeof *b->paths);
    b->rays = (prt_ray *)malloc(count * sizeof *b->rays);
    b->hits = (prt_hit *)malloc(count * sizeof *b->hits);
    *own = b;
    if (b->paths && b->rays && b->hits) return 0;
    end(b);
    return -1;
}

static int trace_range(void *user, void *own, int first, int count) {
    int k, half;
    for (k = first; k < first + count; k++)
        for (half = 0; half < SKY_HALVES; half++)
            if (trace_place((const sky_paths *)user, (sky_buffers *)own, k, half)) return -1;
    return 0;
}

int sky_paths_trace(const sky_paths *s, why *w) {
    sky_paths own = *s;
    parallel job;
    memset(&job, 0, sizeof job);
    job.count = s->place_count;
    job.chunk = 32;
    job.threads = s->threads;
    job.what = s->what;
    job.unit = "paths";
    job.unit_per_item = SKY_HALVES * s->samples;
    job.stop = s->stop;
    job.begin = begin;
    job.work = trace_range;
    job.end = end;
    job.user = &own;
    return parallel_all(&job, w);
}
