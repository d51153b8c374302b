#define _POSIX_C_SOURCE 200809L
#include "fiv_bake.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "progress.h"
#include "replacement.h"
#include "transfer_file.h"

void fiv_env_of(const cube_light *light, prt_fiv_env *env) {
    int k;
    memset(env, 0, sizeof *env);
    env->cube_size = light->size;
    for (k = 0; k < 6; k++) env->faces[k] = light->faces[k];
}

typedef struct range_bake { fiv_baked *baked; int bands, mark_inside; prt_result result; } range_bake;

static int bake_range(void *user, void *own, int first, int count) {
    range_bake *r = (range_bake *)user;
    fiv_baked *b = r->baked;
    prt_result result;
    (void)own;
    result = r->bands ? prt_bake_fiv_transfer(&b->desc, r->bands, first, count, b->coefficients)
                      : prt_bake_fiv_table(&b->desc, first, count, b->samples);
    if (result == PRT_OK && r->mark_inside) result = prt_bake_fiv_inside(&b->desc, first, count, b->inside);
    if (result != PRT_OK) r->result = result;              /* any of several will do */
    return result != PRT_OK;
}

static size_t row_bytes(const fiv_bake_job *job) {
    return job->bands ? (size_t)PRT_SH_COUNT(job->bands + 1) * sizeof(prt_real) : sizeof(prt_fiv);
}

static int make_room(const fiv_bake_job *job, fiv_baked *b, why *w) {
    prt_real radius = job->shape->radius;
    size_t count = (size_t)job->grid.theta * (size_t)job->grid.phi * (size_t)job->grid.rho;
    size_t row = row_bytes(job);
    memset(b, 0, sizeof *b);
    b->rho = (prt_real *)malloc((size_t)job->grid.rho * sizeof *b->rho);
    if (job->bands) b->coefficients = (prt_real *)calloc(count, row);
    else b->samples = (prt_fiv *)calloc(count, row);
    b->inside = job->mark_inside ? (unsigned char *)calloc(count, 1) : NULL;
    if (!b->rho || !(job->bands ? (void *)b->coefficients : (void *)b->samples) || (job->mark_inside && !b->inside))
        return why_set(w, "out of memory for a table of %d x %d x %d places: %.1f MB", job->grid.phi, job->grid.theta,
                       job->grid.rho, (double)count * (double)row * 1e-6);
    if (!job->bands) fiv_env_of(job->light, &b->env);
    b->desc.theta_count = job->grid.theta;
    b->desc.phi_count = job->grid.phi;
    b->desc.rho_count = job->grid.rho;
    b->desc.rho = b->rho;
    b->desc.radius = radius;
    b->desc.tracer = &job->shape->tracer.tracer;
    b->desc.env = &b->env;
    b->desc.rays = job->rays;
    return prt_fiv_distances(job->grid.rho, job->grid.nearest * radius, job->grid.farthest * radius, b->rho) == PRT_OK
           ? 0 : why_set(w, "distances %g ... %g of a table: must increase from above 0", (double)job->grid.nearest,
                         (double)job->grid.farthest);
}

/* ---- keeping ---- */

/* What a table depends on, and what its bake took. Files of this machine alone: its byte order, its floats. */
typedef struct kept_head { uint64_t mark; double seconds, processor; } kept_head;

static uint64_t mark_of(const fiv_bake_job *job) {
    uint64_t hash = mesh_hash(&job->shape->mesh);
    int numbers[6];
    numbers[0] = job->grid.theta; numbers[1] = job->grid.phi; numbers[2] = job->grid.rho;
    numbers[3] = job->bands; numbers[4] = job->rays; numbers[5] = job->mark_inside;
    hash = transfer_checksum(hash, PRT_VERSION, sizeof PRT_VERSION);
    hash = transfer_checksum(hash, numbers, sizeof numbers);
    hash = transfer_checksum(hash, &job->grid.nearest, sizeof job->grid.nearest);
    hash = transfer_checksum(hash, &job->grid.farthest, sizeof job->grid.farthest);
    if (!job->bands)
        hash = transfer_checksum(hash, job->light->texels,
                                 18 * sizeof(float) * (size_t)job->light->size * (size_t)job->light->size);
    return hash;
}

static void kept_path(const fiv_bake_job *job, char *path, size_t size) {
    snprintf(path, size, "%s/%s-%016llx.fiv", job->keep, job->shape->name, (unsigned long long)mark_of(job));
}

static int kept_load(const fiv_bake_job *job, fiv_baked *b) {
    size_t count = (size_t)prt_bake_fiv_count(&b->desc);
    void *rows = job->bands ? (void *)b->coefficients : (void *)b->samples;
    char path[PATH_MAX];
    kept_head head;
    FILE *file;
    int whole;
    kept_path(job, path, sizeof path);
    file = fopen(path, "rb");
    if (!file) return -1;
    whole = fread(&head, sizeof head, 1, file) == 1 && head.mark == mark_of(job) &&
            fread(rows, row_bytes(job), count, file) == count &&
            (!b->inside || fread(b->inside, 1, count, file) == count);
    fclose(file);
    b->seconds = head.seconds;
    b->processor = head.processor;
    return whole ? 0 : -1;
}

static int kept_save(const fiv_bake_job *job, const fiv_baked *b, why *w) {
    size_t count = (size_t)prt_bake_fiv_count(&b->desc);
    const void *rows = job->bands ? (const void *)b->coefficients : (const void *)b->samples;
    char path[PATH_MAX];
    replacement r;
    kept_head head;
    head.mark = mark_of(job);
    head.seconds = b->seconds;
    head.processor = b->processor;
    kept_path(job, path, sizeof path);
    if (replacement_open(path, &r, w)) return -1;
    fwrite(&head, sizeof head, 1, r.file);                 /* the commit looks at ferror */
    fwrite(rows, row_bytes(job), count, r.file);
    if (b->inside) fwrite(b->inside, 1, count, r.file);
    return replacement_commit(&r, w);
}

/* ---- baking ---- */

static int bake(const fiv_bake_job *job, fiv_baked *b, why *w) {
    range_bake r;
    parallel p;
    int failed;
    memset(&r, 0, sizeof r);
    r.baked = b;
    r.bands = job->bands;
    r.mark_inside = job->mark_inside;
    r.result = PRT_OK;
    memset(&p, 0, sizeof p);
    p.what = job->what;
    p.unit = "samples";
    p.unit_per_item = 1;
    p.count = prt_bake_fiv_count(&b->desc);
    p.chunk = 512;                                         /* not fewer: a call prepares the environment's texels */
    p.threads = job->threads;
    p.stop = job->stop;
    p.work = bake_range;
    p.user = &r;
    b->seconds = seconds_now();
    b->processor = processor_seconds();
    failed = parallel_run(&p, w);
    b->seconds = seconds_now() - b->seconds;
    b->processor = processor_seconds() - b->processor;
    if (failed && r.result != PRT_OK)
        return why_set(w, "bake of %s: %s", job->shape->name, prt_result_string(r.result));
    if (failed || p.done < p.count) return failed ? -1 : why_set(w, "interrupted");
    return job->keep ? kept_save(job, b, w) : 0;
}

int fiv_bake_run(const fiv_bake_job *job, fiv_baked *b, why *w) {
    if (make_room(job, b, w)) return -1;
    if (!(job->keep && kept_load(job, b) == 0) && bake(job, b, w)) return -1;
    if (job->bands) b->transfer = prt_fiv_transfer_of(&b->desc, job->bands, b->coefficients, b->inside);
    b->table = prt_fiv_table_of(&b->desc, b->samples, b->inside);
    return 0;
}

/* ---- lighting ---- */

/* In the body's frame everything stands still but the light, which turns the other way. */
int fiv_baked_light(const fiv_baked *b, const prt_real *light, const prt_real rotation[9], prt_fiv *samples, why *w) {
    int bands = b->transfer.bands, k;
    size_t n = (size_t)PRT_SH_COUNT(bands), more = (size_t)PRT_SH_COUNT(bands + 1), c;
    prt_real *turned = (prt_real *)malloc((3 * n + 9 * more) * sizeof *turned), *vectors = turned + 3 * n, back[9];
    prt_result result = turned ? PRT_OK : PRT_ERR_MEMORY;
    for (k = 0; k < 9; k++) back[k] = rotation[k % 3 * 3 + k / 3];
    for (c = 0; c < 3 && result == PRT_OK; c++) result = prt_sh_rotate(bands, back, light + c * n, turned + c * n);
    if (result == PRT_OK) result = prt_fiv_transfer_light(bands, NULL, turned, vectors);
    if (result == PRT_OK)
        result = prt_fiv_transfer_samples(&b->transfer, vectors, 0, prt_bake_fiv_count(&b->desc), samples);
    free(turned);
    return result == PRT_OK ? 0 : why_set(w, "lighting a table: %s", prt_result_string(result));
}

void fiv_baked_free(fiv_baked *b) {
    free(b->rho);
    free(b->samples);
    free(b->coefficients);
    free(b->inside);
    memset(b, 0, sizeof *b);
}
