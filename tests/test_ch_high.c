/* Room >>ch beyond its tables and beyond the range of plain floats (200 bands), poles included: the moments of a delta
   are the basis at its direction, C = S Y, where S knows nothing of the recurrence that evaluates C. */
#define PRT_MAX_BANDS 200
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
enum { N = PRT_SH_COUNT(PRT_MAX_BANDS) };

static void basis_is_s_times_sh(void **state) {
    static const double tilts[8] = { 1.1, 0.3, 1e-2, 1e-4, 1e-8, 1e-20, 0, 1.5707 };
    static prt_real c[N], y[N];
    int k, i;
    (void)state;
    for (k = 0; k < 8; k++) {
        double s = sin(tilts[k]), worst = 0;
        prt_vec3 d = prt__vec3((prt_real)(0.6 * s), (prt_real)(-0.8 * s), (prt_real)((k & 1 ? -1 : 1) * cos(tilts[k])));
        assert_int_equal(prt_ch_eval(PRT_MAX_BANDS, d, c), PRT_OK);
        assert_int_equal(prt_sh_eval(PRT_MAX_BANDS, d, y), PRT_OK);
        assert_int_equal(prt__ch_convert(PRT_MAX_BANDS, prt__ch_moments_from_sh, NULL, y, y), PRT_OK);
        for (i = 0; i < N; i++) {
            double error = fabs((double)c[i] - (double)y[i]);
            if (!(error <= worst)) worst = error;
        }
        assert_at_most(worst, BY_PRECISION(3e-3, 3e-12));
    }
}

static void conversions_return(void **state) {
    static prt_real f[N], g[N];
    double error = 0, size = 0;
    uint32_t seed = 1;
    int i;
    (void)state;
    for (i = 0; i < N; i++) { seed = seed * 1664525u + 1013904223u; f[i] = (prt_real)((double)seed / 4294967296.0 - 0.5); }
    assert_int_equal(prt_ch_from_sh(PRT_MAX_BANDS, f, g), PRT_OK);
    assert_int_equal(prt_sh_from_ch(PRT_MAX_BANDS, g, g), PRT_OK);
    for (i = 0; i < N; i++) {
        error += ((double)f[i] - (double)g[i]) * ((double)f[i] - (double)g[i]);
        size += (double)f[i] * (double)f[i];
    }
    assert_at_most(sqrt(error / size), 8 * EPS);
}

int main(void) {
    const struct CMUnitTest tests[] = { cmocka_unit_test(basis_is_s_times_sh), cmocka_unit_test(conversions_return) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
