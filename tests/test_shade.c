/* Room >>shade: exit radiance is three dot products. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
enum { POINTS = 37 };

static void fill(prt_real *v, int count, unsigned seed) {
    int i;
    for (i = 0; i < count; i++) {
        seed = seed * 1664525u + 1013904223u;
        v[i] = (prt_real)((double)(seed >> 8) / 8388608.0 - 1);
    }
}

static void small_numbers_are_exact(void **state) {
    prt_real transfer[2][4] = { { 1, 2, 3, 4 }, { -1, 0, 0, 1 } };
    prt_real light[12] = { 1, 0, 0, 0,  0, 1, 0, 0,  1, 1, 1, 1 };
    prt_rgb out[2];
    (void)state;
    assert_int_equal(prt_shade_diffuse_n(2, 2, &transfer[0][0], light, out), PRT_OK);
    assert_near(out[0].r, 1, 0); assert_near(out[0].g, 2, 0); assert_near(out[0].b, 10, 0);
    assert_near(out[1].r, -1, 0); assert_near(out[1].g, 0, 0); assert_near(out[1].b, 0, 0);
}

static void equals_the_sums_at_every_band(void **state) {
    static prt_real transfer[POINTS * PRT_SH_COUNT(PRT_MAX_BANDS)], light[3 * PRT_SH_COUNT(PRT_MAX_BANDS)];
    prt_rgb out[POINTS], one;
    int bands, k, c, i;
    (void)state;
    skip_if_fast_math();
    fill(transfer, POINTS * PRT_SH_COUNT(PRT_MAX_BANDS), 1);
    fill(light, 3 * PRT_SH_COUNT(PRT_MAX_BANDS), 2);
    for (bands = 1; bands <= PRT_MAX_BANDS; bands += bands < 12 ? 1 : 13) {
        int n = bands * bands;
        assert_int_equal(prt_shade_diffuse_n(bands, POINTS, transfer, light, out), PRT_OK);
        for (k = 0; k < POINTS; k++) {
            const prt_real *t = transfer + k * n;
            const prt_real got[3] = { out[k].r, out[k].g, out[k].b };
            for (c = 0; c < 3; c++) {
                double want = 0, size = 0;
                prt_real dot = prt_sh_dot(bands, t, light + c * n);
                for (i = 0; i < n; i++) {
                    want += (double)t[i] * (double)light[c * n + i];
                    size += fabs((double)t[i] * (double)light[c * n + i]);
                }
                assert_near(got[c], want, (n / 8 + 4) * EPS * size);
                assert_memory_equal(&got[c], &dot, sizeof dot);
            }
            assert_int_equal(prt_shade_diffuse(bands, t, light, &one), PRT_OK);
            assert_memory_equal(&one, &out[k], sizeof one);
        }
    }
}

static void nan_stays_in_its_point(void **state) {
    prt_real transfer[3 * 25], light[75];
    prt_rgb out[3];
    (void)state;
    skip_if_fast_math();
    fill(transfer, 75, 3);
    fill(light, 75, 4);
    transfer[25 + 24] = (prt_real)NAN;
    assert_int_equal(prt_shade_diffuse_n(5, 3, transfer, light, out), PRT_OK);
    assert_true(isnan((double)out[1].r) && isnan((double)out[1].g) && isnan((double)out[1].b));
    assert_true(isfinite((double)out[0].r) && isfinite((double)out[2].b));
}

static void bad_arguments_write_nothing(void **state) {
    prt_real t[4] = { 0 }, light[12] = { 0 };
    prt_rgb out = { 7, 7, 7 };
    (void)state;
    assert_int_equal(prt_shade_diffuse(0, t, light, &out), PRT_ERR_BANDS);
    assert_int_equal(prt_shade_diffuse(PRT_MAX_BANDS + 1, t, light, &out), PRT_ERR_BANDS);
    assert_int_equal(prt_shade_diffuse(2, NULL, light, &out), PRT_ERR_NULL);
    assert_int_equal(prt_shade_diffuse(2, t, NULL, &out), PRT_ERR_NULL);
    assert_int_equal(prt_shade_diffuse(2, t, light, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_shade_diffuse_n(2, -1, t, light, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_shade_diffuse_n(2, 0, NULL, NULL, NULL), PRT_OK);
    assert_true(out.r == 7 && out.g == 7 && out.b == 7);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_numbers_are_exact),
        cmocka_unit_test(equals_the_sums_at_every_band),
        cmocka_unit_test(nan_stays_in_its_point),
        cmocka_unit_test(bad_arguments_write_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
