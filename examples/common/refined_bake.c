#include "refined_bake.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double refined_bake_difference(int bands, const prt_real *middle, const prt_real *a, const prt_real *b) {
    double sum = 0;
    int l, i;
    for (l = 0; l < bands; l++) {
        for (i = PRT_SH_COUNT(l); i < PRT_SH_COUNT(l + 1); i++) {
            double d = ((double)middle[i] - 0.5 * ((double)a[i] + (double)b[i])) / (l + 1);
            sum += d * d;
        }
    }
    return sqrt(sum);
}

/* Makes room for the points that the mesh has now; those that are new have yet to be baked. */
static int grow(refined_bake *r, why *w) {
    size_t count = (size_t)r->m->point_count, row = (size_t)PRT_SH_COUNT(r->job.desc.bands);
    prt_real *transfer = (prt_real *)realloc(r->job.transfer, count * row * sizeof *transfer);
    unsigned char *done = (unsigned char *)realloc(r->job.done, count);
    if (transfer) r->job.transfer = transfer;
    if (done) r->job.done = done;
    if (!transfer || !done) return why_set(w, "out of memory for %d points of transfer", r->m->point_count);
    memset(done + r->job.point_count, 0, count - (size_t)r->job.point_count);
    r->job.point_count = r->m->point_count;
    r->job.points = r->m->points;
    return 0;
}

static int bake_level(refined_bake *r, why *w) {
    prt_result result;
    if (grow(r, w)) return -1;
    result = bake_job_run(&r->job);
    return result == PRT_OK ? 0 : why_set(w, "bake: %s", prt_result_string(result));
}

static int touches_a_bend(void *user, uint32_t a, uint32_t b) {
    const unsigned char *bends = (const unsigned char *)user;
    return bends[a] || bends[b];
}

/* Cuts the edges around points that bend; then bends[point] says which of the new points do. */
static int refine(refined_bake *r, unsigned char **bends, why *w) {
    int old = r->m->point_count, bands = r->job.desc.bands, k;
    size_t row = (size_t)PRT_SH_COUNT(bands);
    unsigned char *next;
    uint32_t *ends = NULL;
    if (mesh_cut_edges(r->m, *bends ? touches_a_bend : NULL, *bends, &ends, w)) return -1;
    next = (unsigned char *)calloc((size_t)r->m->point_count, 1);
    if (!next || bake_level(r, w)) {
        if (!next) why_set(w, "out of memory for a finer mesh");
        free(next);
        free(ends);
        return -1;
    }
    for (k = old; k < r->m->point_count; k++) {
        const prt_real *t = r->job.transfer;
        const uint32_t *end = ends + 2 * (size_t)(k - old);
        next[k] = refined_bake_difference(bands, t + row * (size_t)k, t + row * end[0], t + row * end[1]) > r->tolerance;
    }
    free(ends);
    free(*bends);
    *bends = next;
    return 0;
}

int refined_bake_run(refined_bake *r, why *w) {
    unsigned char *bends = NULL;
    int level, failed;
    r->job.transfer = NULL;
    r->job.done = NULL;
    r->job.point_count = 0;
    failed = bake_level(r, w);
    for (level = 0; level < r->levels && !failed; level++) failed = refine(r, &bends, w);
    free(bends);
    free(r->job.done);
    r->job.done = NULL;
    return failed ? -1 : 0;
}
