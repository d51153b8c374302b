/* What an analytic tracer's `occluded` answers where only its `closest` is written out. Included after prt_bake.h. */
#ifndef PRT_TESTS_TRACER_H
#define PRT_TESTS_TRACER_H

static inline int occluded_by(int (*closest)(void *user, int count, const prt_ray *rays, prt_hit *hits), void *user,
                              int count, const prt_ray *rays, unsigned char *blocked) {
    prt_hit hits[PRT_BAKE_BATCH];
    int k, failed;
    for (k = 0; k < count; k++) hits[k].object = -1;
    failed = closest(user, count, rays, hits);
    for (k = 0; k < count; k++) blocked[k] = hits[k].object >= 0;
    return failed;
}

#endif
