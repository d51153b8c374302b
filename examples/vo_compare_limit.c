/* One build of batched shading, LIMIT_ID, with flags LIMIT_FLAGS: see vo_compare_limit.h. */
#define _POSIX_C_SOURCE 200809L
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "vo_compare_limit.h"

#include <string.h>

#include "../bench/bench.h"
#include "../bench/peak.h"
#include "../bench/vo_operations.h"

enum { PASSES = 4096 };

/* Occluders that are worked on, where every point of a vector waits for the one that has the most. */
static double carried_occluders(const limit_job *job) {
    double sum = 0;
    int k, lane, most;
    for (k = 0; k < job->count; k += PRT__LANES) {
        for (lane = k, most = 0; lane < k + PRT__LANES && lane < job->count; lane++) {
            int own = job->first[lane + 1] - job->first[lane];
            if (own > most) most = own;
        }
        sum += (double)most * PRT__LANES;
    }
    return sum;
}

static double operations_of(const limit_job *job, double occluders) {
    int dd = (job->params->off & (PRT_VO_NO_DS | PRT_VO_NO_SS)) != 0;
    return vo_operations(job->count, occluders / job->count, job->light_count, dd ? VO_DD_OCCLUDER : VO_ALL_OCCLUDER,
                         dd ? VO_DD_BOTH : VO_ALL_BOTH);
}

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
limit JOIN(limit_, LIMIT_ID)(const limit_job *job, int runs) {
    prt_real sink[PEAK_LANES];
    limit l;
    int k;
    memset(&l, 0, sizeof l);
    l.flags = LIMIT_FLAGS;
    l.lanes = PRT__LANES;
    l.both = job->params->off & PRT_VO_NO_DS ? VO_DD_BOTH : VO_ALL_BOTH;
    l.operations = operations_of(job, job->first[job->count] - job->first[0]);
    l.carried = operations_of(job, carried_occluders(job)) - l.operations;
    for (k = 0; k < runs; k++) {
        double a = bench_seconds(), b, c;
        prt_vo_shade_n(job->params, job->count, job->points, job->eye, job->first, job->occluders, job->light_count,
                       job->lights, job->out);
        b = bench_seconds();
        peak_passes(PASSES, sink);
        BENCH_KEEP(sink);
        c = bench_seconds();
        if (k == 0 || b - a < l.seconds) l.seconds = b - a;
        if (k == 0 || (double)PASSES * PEAK_FLOPS / (c - b) > l.rate) l.rate = (double)PASSES * PEAK_FLOPS / (c - b);
    }
    return l;
}
