/* peak.h - the rate at which the build that includes it can multiply and add: twelve independent chains on vectors as
   wide as the build allows. After prt.h. */
#ifndef BENCH_PEAK_H
#define BENCH_PEAK_H

#include <string.h>

#if defined(PRT_NO_SIMD)
typedef prt_real wide;
#elif defined(__AVX512F__)
typedef prt_real wide __attribute__((vector_size(64)));
#elif defined(__AVX__)
typedef prt_real wide __attribute__((vector_size(32)));
#else
typedef prt_real wide __attribute__((vector_size(16)));
#endif

#if defined(__x86_64__) || defined(__i386__)
#  define PIN(value) __asm__ volatile("" : "+x"(value));
#elif defined(__aarch64__)
#  define PIN(value) __asm__ volatile("" : "+w"(value));
#else
#  define PIN(value) __asm__ volatile("" : "+m"(value));
#endif

enum { CHAINS = 12, STEPS = 64, PEAK_LANES = (int)(sizeof(wide) / sizeof(prt_real)),
       PEAK_FLOPS = 2 * CHAINS * STEPS * PEAK_LANES };         /* of one pass, a multiply-add counted as two */

/* out[PEAK_LANES]: so that the work is not left out. */
static void peak_passes(long passes, prt_real *out) {
    wide a[CHAINS], scale, offset;
    int i, step;
    memset(a, 0, sizeof a);
    scale = a[0] + (prt_real)0.5;
    offset = a[0] + (prt_real)0.25;
    PIN(scale) PIN(offset)
    for (; passes > 0; passes--)
        for (step = 0; step < STEPS; step++) {
            for (i = 0; i < CHAINS; i++) a[i] = a[i] * scale + offset;
            PIN(a[0]) PIN(a[1]) PIN(a[2]) PIN(a[3]) PIN(a[4]) PIN(a[5])
            PIN(a[6]) PIN(a[7]) PIN(a[8]) PIN(a[9]) PIN(a[10]) PIN(a[11])
        }
    for (i = 1; i < CHAINS; i++) a[0] += a[i];
    memcpy(out, &a[0], sizeof a[0]);
}

#endif
