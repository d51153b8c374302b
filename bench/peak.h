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

/* out[PEAK_LANES]: so that the work is not left out. The chains have a name each: gcc keeps an array of them in memory. */
#define PEAK_EACH(X) X(0) X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(9) X(10) X(11)
static void peak_passes(long passes, prt_real *out) {
    wide scale, offset, zero;
    int step;
#define PEAK_DECLARE(i) wide a##i;
#define PEAK_START(i) a##i = zero;
#define PEAK_STEP(i) a##i = a##i * scale + offset;
#define PEAK_PIN(i) PIN(a##i)
#define PEAK_SUM(i) zero += a##i;
    PEAK_EACH(PEAK_DECLARE)
    memset(&zero, 0, sizeof zero);
    scale = zero + (prt_real)0.5;
    offset = zero + (prt_real)0.25;
    PIN(scale) PIN(offset)
    PEAK_EACH(PEAK_START)
    for (; passes > 0; passes--)
        for (step = 0; step < STEPS; step++) {
            PEAK_EACH(PEAK_STEP)
            PEAK_EACH(PEAK_PIN)
        }
    PEAK_EACH(PEAK_SUM)
    memcpy(out, &zero, sizeof zero);
#undef PEAK_DECLARE
#undef PEAK_START
#undef PEAK_STEP
#undef PEAK_PIN
#undef PEAK_SUM
}

#endif
