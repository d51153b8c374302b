#include "fiv_bake.h"

#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "progress.h"

void fiv_env_of(const cube_light *light, prt_fiv_env *env) {
    int k;
    memset(env, 0, sizeof *env);
    env->cube_size = light->size;
    for (k = 0; k < 6; k++) env->faces[k] = light->faces[k];
}

typedef struct range_bake { fiv_baked *baked; int mark_inside; prt_result result; } range_bake;

static int bake_range(void *user, void *own, int first, int count) {
    range_bake *r = (range_bake *)user;
    fiv_baked *b = r->baked;
    prt_result result;
    (void)own;
    result = prt_bake_fiv_table(&b->desc, first, count, b->samples);
    if (result == PRT_OK && r->mark_inside) result = prt_bake_fiv_inside(&b->desc, first, count, b->inside);
    if (result != PRT_OK) r->result = result;              /* any of several will do */
    return result != PRT_OK;
}

static int make_room(const fiv_bake_job *job, fiv_baked *b, why *w) {
    prt_real radius = job->shape->radius;
    size_t count = (size_t)job->grid.theta * (size_t)job->grid.phi * (size_t)job->grid.rho;
    memset(b, 0, sizeof *b);
    b->rho = (prt_real *)malloc((size_t)job->grid.rho * sizeof *b->rho);
    b->samples = (prt_fiv *)calloc(count, sizeof *b->samples);
    b->inside = job->mark_inside ? (unsigned char *)calloc(count, 1) : NULL;
    if (!b->rho || !b->samples || (job->mark_inside && !b->inside))
        return why_set(w, "out of memory for a table of %d x %d x %d vectors: %.1f MB", job->grid.phi, job->grid.theta,
                       job->grid.rho, (double)count * sizeof *b->samples * 1e-6);
    fiv_env_of(job->light, &b->env);
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

int fiv_bake_run(const fiv_bake_job *job, fiv_baked *b, why *w) {
    range_bake r;
    parallel p;
    int failed;
    if (make_room(job, b, w)) return -1;
    memset(&r, 0, sizeof r);
    r.baked = b;
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
    b->table = prt_fiv_table_of(&b->desc, b->samples, b->inside);
    return 0;
}

void fiv_baked_free(fiv_baked *b) {
    free(b->rho);
    free(b->samples);
    free(b->inside);
    memset(b, 0, sizeof *b);
}
