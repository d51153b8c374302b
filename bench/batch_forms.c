/* The batched product, compiled for one width of vectors (BATCH_ID), and that width's peak in the same rounds. */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L
#endif
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "bench.h"
#include "batch_forms.h"
#include "peak.h"

#define BATCH_NAME_(id) batch_##id
#define BATCH_NAME(id) BATCH_NAME_(id)

void BATCH_NAME(BATCH_ID)(batch_rates *rates) {
    enum { PAIRS = 64, PASSES = 200 };
    static prt_real f[36 * PAIRS], g[36 * PAIRS], out[36 * PAIRS], sums[PEAK_LANES];
    int n, i, round, k;
    for (i = 0; i < 36 * PAIRS; i++) {
        f[i] = (prt_real)((i * 7919 % 2001) - 1000) / 1000;
        g[i] = (prt_real)((i * 104729 % 2001) - 1000) / 1000;
    }
    rates->lanes = PRT__LANES;
    rates->flops = 0;
    for (n = 3; n <= 6; n++) rates->ns[n] = 1e300;
    for (round = 0; round < 40; round++) {
        double start = bench_seconds(), ns;
        peak_passes(PASSES, sums);
        ns = 1e9 * (bench_seconds() - start);
        BENCH_KEEP(sums);
        if (PASSES * (double)PEAK_FLOPS / ns > rates->flops) rates->flops = PASSES * (double)PEAK_FLOPS / ns;
        for (n = 3; n <= 6; n++) {
            int repeat = 1000 / (n * n * n) + 1;
            start = bench_seconds();
            for (k = 0; k < repeat; k++) { prt_sh_product_soa(n, PAIRS, f, g, out, PAIRS); BENCH_KEEP(out); }
            ns = 1e9 * (bench_seconds() - start) / repeat / PAIRS;
            if (ns < rates->ns[n]) rates->ns[n] = ns;
        }
    }
}
