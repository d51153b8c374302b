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

/* Fails unless |got - want| <= tolerance; NaN anywhere fails. */
#define assert_near(got, want, tolerance) do { \
        double got_ = (double)(got), want_ = (double)(want), tolerance_ = (double)(tolerance); \
        if (!(fabs(got_ - want_) <= tolerance_)) \
            fail_msg("%s = %.17g, expected %.17g within %.3g, off by %.3g", #got, got_, want_, tolerance_, \
                     fabs(got_ - want_)); \
    } while (0)

/* Fails unless value <= bound; NaN fails. */
#define assert_at_most(value, bound) do { \
        double value_ = (double)(value), bound_ = (double)(bound); \
        if (!(value_ <= bound_)) fail_msg("%s = %.6g exceeds %.6g", #value, value_, bound_); \
    } while (0)

#endif
