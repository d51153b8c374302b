/* What every test needs: cmocka with its includes, and a comparison that fails on NaN. */
#ifndef PRT_TEST_H
#define PRT_TEST_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#ifdef PRT_DOUBLE
#  define BY_PRECISION(for_float, for_double) (for_double)
#else
#  define BY_PRECISION(for_float, for_double) (for_float)
#endif

/* With -ffast-math the compiler assumes that there is no NaN and no infinity and reorders sums (prt.h, DETERMINISM):
   errors may be twice what they are without, and cases that are about NaN, infinity or bit equality are skipped. */
#ifdef __FAST_MATH__
#  define FAST_MATH 1
#  define ERROR_FACTOR 2
#  define skip_if_fast_math() skip()
#else
#  define FAST_MATH 0
#  define ERROR_FACTOR 1
#  define skip_if_fast_math() ((void)0)
#endif

/* value <= bound, false for NaN whatever the compiler assumes */
static inline int test_at_most(double value, double bound) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return (bits & UINT64_C(0x7fffffffffffffff)) <= UINT64_C(0x7ff0000000000000) && value <= bound;
}

/* Fails unless |got - want| <= tolerance; NaN anywhere fails. */
#define assert_near(got, want, tolerance) do { \
        double got_ = (double)(got), want_ = (double)(want), tolerance_ = ERROR_FACTOR * (double)(tolerance); \
        if (!test_at_most(fabs(got_ - want_), tolerance_)) \
            fail_msg("%s = %.17g, expected %.17g within %.3g, off by %.3g", #got, got_, want_, tolerance_, \
                     fabs(got_ - want_)); \
    } while (0)

/* Fails unless value <= bound; NaN fails. */
#define assert_at_most(value, bound) do { \
        double value_ = (double)(value), bound_ = (double)(bound) * ((bound) > 0 ? ERROR_FACTOR : 1); \
        if (!test_at_most(value_, bound_)) fail_msg("%s = %.6g exceeds %.6g", #value, value_, bound_); \
    } while (0)

#endif
