/* configurations.h - the builds of prt.h that live in one program. CMakeLists.txt compiles candidates.c once for each,
   with BENCH_ID as listed here. */
#ifndef BENCH_CONFIGURATIONS_H
#define BENCH_CONFIGURATIONS_H

#include "bench.h"

#ifdef BENCH_ONE_CONFIGURATION          /* for a test that every row runs */
#  define BENCH_CONFIGURATIONS(X) X(float_native)
#else
#  define BENCH_CONFIGURATIONS(X) \
    X(float_native) X(float_native_plain) X(float_portable) X(float_portable_plain) \
    X(double_native) X(double_native_plain) X(double_portable) X(double_portable_plain)
#endif

#define BENCH_DECLARE(id) \
    const bench_candidate *bench_rows_##id(int *count); \
    const bench_candidate *bench_peak_##id(void); \
    const char *bench_flags_##id(void);
BENCH_CONFIGURATIONS(BENCH_DECLARE)
#undef BENCH_DECLARE

#endif
