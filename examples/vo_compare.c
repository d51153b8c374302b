/* vo_compare: section 7.6 of [Sherif 2013] run again. Vector occluders beside Phong, ambient occlusion, spherical and
   cpherical harmonics, all at the vertices, against path tracing of the same point lights.

   Writes DIR/vo.md with its pictures in DIR/gallery and its plots in DIR/plots. What each number means:

     RMSE    root mean square error of linear radiance over the pixels that the scene covers whole, all colours,
             divided by the mean of the reference there; negative radiance counts as 0. The reference comes in two
             independent halves R0, R1; the mean of (P-R0)(P-R1) is free of their noise.
     SSIM    structural similarity of luminance as the screen shows it, see common/similarity.h.
     noise   standard error of the reference picture, in the unit of RMSE.
     time    of the processor: bakes on all cores together, shading on one, the least of several runs taken in turns.

   References are kept in KEEP and taken up again: interrupt it and go on later. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "vo_compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_job.h"
#include "point_lights.h"
#include "program.h"
#include "vector.h"

/* ---- lights ---- */

static void light_from_around(rig *r) {
    int k, g;
    r->name = "around";
    r->light_count = MOST_LIGHTS;
    r->group_count = SETS;
    point_lights_around(MOST_LIGHTS, vec(0, 0, 0.4), 5, r->lights);
    for (k = 0; k < MOST_LIGHTS; k++) {
        for (g = 0; k >= light_counts[g]; g++) {}
        r->group[k] = g;
    }
}

static int light_from_sky(const image *sky, rig *r, why *w) {
    r->name = "environment";
    r->light_count = MOST_LIGHTS;
    r->group_count = 1;
    return point_lights_from_map(sky, MOST_LIGHTS, 100, r->lights, w);
}

int lights_of(const rig *r, int set, prt_point_light *lights) {
    int count = r->group_count == 1 ? r->light_count : light_counts[set], k;
    for (k = 0; k < count; k++) {
        lights[k] = r->lights[k];
        if (r->group_count > 1) lights[k].color = rgb_scale(lights[k].color, 1.0 / count);
    }
    return count;
}

int sets_of(const rig *r) { return r->group_count == 1 ? 1 : SETS; }

/* ---- stages ---- */

int few_rays(const study *d) { return d->o.rays < 2048 ? d->o.rays : 2048; }
int saving_rays(const study *d) { return d->o.rays < 512 ? d->o.rays : 512; }

static int size_of_samples(const study *d) { return d->o.size * SAMPLES_A_PIXEL; }

static void ask(stage *s) {
    int count = s->seen.width * s->seen.height, k;
    for (k = 0; k < count; k++) {
        path_query *q = &s->pixel_queries[k];
        prt_point at;
        q->part = s->seen.hits[k].object;
        if (q->part < 0) continue;
        at = scene_place(&s->shining, &s->seen.hits[k]);
        q->position = rgb_mean(s->shining.parts[q->part].material.transmissive) > 0
                          ? scene_place_flat(&s->shining, &s->seen.hits[k])
                          : at.position;
        q->normal = at.normal;
        q->towards = s->seen.rays[k].dir;
    }
    for (k = 0; k < s->shining.mesh.point_count; k++) {
        path_query *q = &s->vertex_queries[k];
        q->part = scene_part_of_point(&s->shining, k);
        q->position = s->shining.mesh.points[k].position;
        q->normal = s->shining.mesh.points[k].normal;
        q->towards = vec_unit(vec_add(q->position, -1, s->seen.eye.eye), vec(0, 0, -1));
    }
}

static int bake_stage(const study *d, stage *s, int with_sh, int full, why *w) {
    s->baked.scene = &s->shining;
    s->baked.tracer = &s->tracer;
    s->baked.rays = full ? d->o.rays : few_rays(d);
    s->baked.threads = d->o.threads;
    s->baked.most_occluders = SCENE_PARTS;
    s->baked.bias = (prt_real)1e-4;
    s->baked.shining = 1;
    s->baked.with_sh = with_sh;
    s->baked.with_glossy = with_sh && full;
    s->baked.with_time_of_dd = full;
    s->baked.stop = d->stop;
    return techniques_bake(&s->baked, w);
}

static int set_up(const study *d, stage *s, const char *name, camera eye, int with_sh, why *w) {
    int samples = size_of_samples(d);
    s->name = name;
    s->matte = s->shining;                                 /* shares the mesh */
    scene_make_matte(&s->matte);
    s->pixel_queries = (path_query *)calloc((size_t)samples * (size_t)samples, sizeof *s->pixel_queries);
    s->vertex_queries = (path_query *)calloc((size_t)s->shining.mesh.point_count, sizeof *s->vertex_queries);
    if (!s->pixel_queries || !s->vertex_queries) return why_set(w, "out of memory");
    if (scene_trace_with(&s->shining, &s->tracer, w) ||
        view_create(&s->shining, &s->tracer, eye, samples, samples, &s->seen, w))
        return -1;
    ask(s);
    light_from_around(&s->rigs[AROUND]);
    return light_from_sky(&d->sky, &s->rigs[SKY], w) || bake_stage(d, s, with_sh, s == &d->shapes, w) ? -1 : 0;
}

static void stage_free(stage *s) {
    int matte, which, half;
    techniques_free(&s->baked);
    view_free(&s->seen);
    embree_tracer_destroy(&s->tracer);
    free(s->pixel_queries);
    free(s->vertex_queries);
    for (matte = 0; matte < 2; matte++)
        for (which = 0; which < RIGS; which++)
            for (half = 0; half < PATH_HALVES; half++) {
                free(s->truths[matte][which].pixels[half]);
                free(s->truths[matte][which].vertices[half]);
            }
    scene_free(&s->shining);
}

/* ---- the program ---- */

static int make_directory_in(const char *parent, const char *name, why *w) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", parent, name);
    return make_directory(path, w);
}

static int prepare(study *d, why *w) {
    camera eye = camera_orbit(vec(0, 0, 0.35), 7.0, -1.25, 0.55, 0.55),
           low = camera_orbit(vec(0.2, 0, 0.2), 6.2, -1.25, 0.7, 0.5);
    camera at_statue = camera_orbit(vec(0, 0, 0.5), 6.6, -1.3, 0.35, 0.5);
    if (make_directory(d->o.out, w) || make_directory_in(d->o.out, "gallery", w) ||
        make_directory_in(d->o.out, "plots", w) || make_directory(d->o.keep, w) ||
        image_load_environment(d->o.environment, &d->sky, w))
        return -1;
    if (scene_shapes(d->o.fineness, &d->shapes.shining, w) || scene_ball(d->o.fineness, &d->ball.shining, w) ||
        scene_glass(d->o.fineness, &d->glass.shining, w) || scene_pool(d->o.fineness, &d->pool.shining, w) ||
        scene_statue(d->o.mesh, d->o.up, 34, &d->statue.shining, w)) return -1;
    return set_up(d, &d->shapes, "shapes", eye, 1, w) || set_up(d, &d->statue, "statue", at_statue, 1, w) ||
           set_up(d, &d->ball, "ball", low, 0, w) || set_up(d, &d->glass, "glass", low, 0, w) ||
           set_up(d, &d->pool, "pool", low, 0, w) ? -1 : 0;
}

static int run(study *d, why *w) {
    int matte;
    if (prepare(d, w) || time_shading(&d->shapes, w) || time_forms(d, w)) return -1;
    compare_ch(d);
    for (matte = 1; matte >= 0; matte--)
        if (measure(d, &d->shapes, matte, AROUND, w) || measure(d, &d->shapes, matte, SKY, w)) return -1;
    if (measure(d, &d->statue, 1, SKY, w) || study_laws(d, w) || study_pictures(d, w) || study_ball(d, w) ||
        study_glass(d, w) || study_splits(d, w) || study_lights(d, w) || study_savings(d, w) || study_waves(d, w) ||
        study_drain(d, w))
        return -1;
    return write_pictures(d, w) || write_plots(d, w) || write_page(d, w) ? -1 : 0;
}

static int parse(int count, char **words, options *o, why *w) {
    int i;
    o->out = o->keep = "out";
    o->mesh = "/usr/share/glmark2/models/horse.3ds";
    o->environment = PRT_EXAMPLE_DATA "/courtyard.hdr";
    o->rays = 4096;
    o->size = 190;
    o->paths = 32;
    o->directions = 64;
    o->fineness = 1;
    o->up = "-x";
    o->threads = processor_count();
    for (i = 1; i + 1 < count; i += 2) {
        const char *word = words[i], *value = words[i + 1];
        if (strcmp(word, "--out") == 0) o->out = value;
        else if (strcmp(word, "--keep") == 0) o->keep = value;
        else if (strcmp(word, "--mesh") == 0) o->mesh = value;
        else if (strcmp(word, "--up") == 0) o->up = value;
        else if (strcmp(word, "--environment") == 0) o->environment = value;
        else if (strcmp(word, "--rays") == 0) o->rays = atoi(value);
        else if (strcmp(word, "--size") == 0) o->size = atoi(value);
        else if (strcmp(word, "--paths") == 0) o->paths = atoi(value);
        else if (strcmp(word, "--directions") == 0) o->directions = atoi(value);
        else if (strcmp(word, "--fineness") == 0) o->fineness = atof(value);
        else if (strcmp(word, "--threads") == 0) o->threads = atoi(value);
        else break;
    }
    if (i < count || strlen(o->up) != 2 || !strchr("+-", o->up[0]) || !strchr("xyz", o->up[1]) || o->rays < 1 ||
        o->rays > 1000000 || o->size < 16 || o->size > 2048 || o->paths < 1 || o->paths > 65536 || o->directions < 1 ||
        o->directions > 4096 || !(o->fineness >= 0.1 && o->fineness <= 10) || o->threads < 1 || o->threads > 256)
        return why_set(
            w,
            "usage: vo_compare [--out DIR] [--keep DIR] [--mesh FILE] [--up +x|-x|...|-z] [--environment FILE.hdr] "
            "[--rays N] [--size 16...2048] "
            "[--paths N] [--directions N] [--fineness 0.1...10] [--threads N]");
    return 0;
}

int main(int count, char **words) {
    static study d;
    why w;
    int failed;
    d.stop = &interrupted;
    stop_on(SIGINT);
    stop_on(SIGTERM);
    signal(SIGPIPE, SIG_IGN);
    failed = parse(count, words, &d.o, &w) || run(&d, &w);
    if (failed) fprintf(stderr, "vo_compare: %s\n", w.line);
    stage_free(&d.shapes);
    stage_free(&d.statue);
    stage_free(&d.ball);
    stage_free(&d.glass);
    stage_free(&d.pool);
    image_free(&d.sky);
    return failed ? interrupted ? STOPPED : 1 : 0;
}
