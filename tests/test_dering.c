/* prt_sh_minimum and prt_sh_dering against a dense search in double and against closed forms. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"

enum { MOST = 16 * 16, DENSE = 60000 };

/* Y in double on DENSE random-phase spiral directions, by the definition; one table for all tests */
static double (*dense)[64];
static int set_up(void **state) {
    int i, l, m;
    (void)state;
    dense = (double (*)[64])malloc(sizeof *dense * DENSE);
    assert_non_null(dense);
    for (i = 0; i < DENSE; i++) {
        double z = 1 - (2 * i + 1.0) / DENSE, r = sqrt(1 - z * z), phi = i * 2.3999632297286533 + 0.7;
        for (l = 0; l < 8; l++)
            for (m = -l; m <= l; m++)
                dense[i][PRT_SH_INDEX(l, m)] = prt_reference_sh(l, m, r * cos(phi), r * sin(phi), z);
    }
    return 0;
}
static int tear_down(void **state) {
    (void)state;
    free(dense);
    return 0;
}

static double dense_minimum(int bands, const double *f) {
    double least = 1e300;
    int i, k;
    for (i = 0; i < DENSE; i++) {
        double v = 0;
        for (k = 0; k < bands * bands; k++) v += f[k] * dense[i][k];
        if (v < least) least = v;
    }
    return least;
}

static double bound(int bands, const prt_real *f) {
    double sum = 0;
    int l, m;
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) sum += fabs((double)f[PRT_SH_INDEX(l, m)]) * sqrt((2 * l + 1) / (4 * PRT__PI));
    return sum;
}

/* functions to dering: caps, deltas, sums of both, noise on a mean */
static void make(int kind, int bands, prt_real *f) {
    static prt_real g[MOST];
    int i, k;
    memset(f, 0, sizeof(prt_real) * (size_t)(bands * bands));
    switch (kind % 4) {
    case 0: prt_sh_cone(bands, random_direction(), PRT__R(0.8) + PRT__R(0.6) * (prt_real)signed_uniform(), f); break;
    case 1: prt_sh_delta(bands, random_direction(), f); break;
    case 2:
        for (k = 0; k < 3; k++) {
            prt_sh_cone(bands, random_direction(), PRT__R(0.6) + PRT__R(0.4) * (prt_real)signed_uniform(), g);
            for (i = 0; i < bands * bands; i++) f[i] += g[i];
        }
        break;
    default:
        for (i = 0; i < bands * bands; i++) f[i] = (prt_real)signed_uniform() * PRT__R(0.4);
        f[0] = PRT__R(1.5);
    }
}

static void the_minimum_is_found(void **state) {
    static prt_real f[MOST];
    double wide[64];
    int n, kind, i;
    (void)state;
    for (n = 1; n <= 8; n++)
        for (kind = 0; kind < 12; kind++) {
            prt_vec3 d;
            double value, dense_value, size;
            make(kind, n, f);
            for (i = 0; i < n * n; i++) wide[i] = (double)f[i];
            value = (double)prt_sh_minimum(n, f, &d);
            dense_value = dense_minimum(n, wide);
            size = bound(n, f);
            assert_at_most(value, dense_value + BY_PRECISION(1e-6, 1e-13) * size);
            /* spacing of the dense directions, and the curvature that n bands can have */
            assert_near(value, dense_value, 1.1 * (4 * PRT__PI / DENSE) * n * (n + 1) / 4.0 * size + 1e-6 * size);
            assert_near(value, prt_sh_at(n, f, d), 0);
            assert_near(prt_sh_minimum(n, f, NULL), value, 0);
        }
}

/* A cap's delta about an axis is zonal: its minimum from the polynomial in z. */
static void a_zonal_minimum_is_that_of_its_polynomial(void **state) {
    static prt_real f[MOST];
    int n, i, l;
    (void)state;
    for (n = 2; n <= 16; n++) {
        double least = 1e300;
        prt_sh_delta(n, random_direction(), f);
        for (i = 0; i <= 40000; i++) {
            double z = i / 20000.0 - 1, p1 = 1, p2 = 0, sum = 0;
            for (l = 0; l < n; l++) {
                double p;
                sum += (2 * l + 1) / (4 * PRT__PI) * p1;
                p = ((2 * l + 1) * z * p1 - l * p2) / (l + 1);
                p2 = p1;
                p1 = p;
            }
            if (sum < least) least = sum;
        }
        assert_near(prt_sh_minimum(n, f, NULL), least, BY_PRECISION(2e-6, 1e-7) * n * n);
    }
}

/* weights of a strength, from prt_window_weight */
static double weight_of(int l, int bands, double s) {
    double p = (double)prt_window_weight(PRT_WINDOW_POSITIVE, l, bands);
    if (l == 0) return 1;
    return s <= 1 ? 1 - s + s * p : (2 - s) * p;
}

static void smooth(int bands, const prt_real *f, double s, double *out) {
    int l, m;
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) out[PRT_SH_INDEX(l, m)] = weight_of(l, bands, s) * (double)f[PRT_SH_INDEX(l, m)];
}

static void dering_is_the_least_that_lifts(void **state) {
    static prt_real f[MOST], out[MOST], before[MOST];
    double wide[64];
    int n, kind, i, beyond = 0, touched = 0;
    (void)state;
    for (n = 2; n <= 8; n++)
        for (kind = 0; kind < 16; kind++) {
            prt_real s = 0;
            double size;
            make(kind, n, f);
            memcpy(before, f, sizeof f);
            size = bound(n, f);
            assert_int_equal(prt_sh_dering(n, f, out, &s), PRT_OK);
            assert_memory_equal(f, before, sizeof f);
            smooth(n, f, (double)s, wide);
            for (i = 0; i < n * n; i++) assert_near(out[i], wide[i], BY_PRECISION(1e-6, 1e-14) * size);
            for (i = 0; i < n * n; i++) wide[i] = (double)out[i];
            assert_true(dense_minimum(n, wide) >= -BY_PRECISION(1e-6, 1e-14) * size);  /* nothing negative is left */
            if (s > 0) {                               /* and less smoothing would leave something */
                double less = (double)s - 2e-3;
                touched++;
                smooth(n, f, less > 0 ? less : 0, wide);
                assert_true(dense_minimum(n, wide) < 0);
            } else assert_memory_equal(out, f, (size_t)(n * n) * sizeof *f);
            beyond += s > 1;
            assert_true(s >= 0 && s <= 2);
        }
    print_message("%d functions needed smoothing, %d of them more than the positive window\n", touched, beyond);
    assert_true(touched > 60 && beyond > 5);
}

/* A delta needs all of the positive window: its smoothed form is that window's kernel, whose least value is 0. */
static void a_delta_needs_the_positive_window(void **state) {
    static prt_real f[MOST], out[MOST];
    int n;
    (void)state;
    for (n = 2; n <= 12; n++) {
        prt_real s;
        prt_sh_delta(n, random_direction(), f);
        prt_sh_dering(n, f, out, &s);
        assert_near(s, 1, BY_PRECISION(1e-4, 1e-9));
    }
}

/* One band up: f = 1 + 2 z has its minimum -1 at z = -1; the positive window of 2 bands is 1/3: 1 + (2/3) z > 0. With
   weight w: 1 - 2 w = 0 at w = 1/2, that is 1 - s + s/3 = 1/2, s = 3/4. And 1 + 6 z: (2-s) 6/3 = 1, s = 3/2. */
static void two_bands_by_hand(void **state) {
    prt_real f[4] = { 0, 0, 0, 0 }, out[4], s;
    (void)state;
    f[0] = PRT__R(3.5449077018110320546);
    f[2] = PRT__R(2 * 2.0466534158929769770);
    assert_int_equal(prt_sh_dering(2, f, out, &s), PRT_OK);
    assert_near(s, 0.75, BY_PRECISION(5e-6, 1e-14));
    f[2] *= 3;
    assert_int_equal(prt_sh_dering(2, f, f, &s), PRT_OK);
    assert_near(s, 1.5, BY_PRECISION(5e-6, 1e-14));
    assert_near(f[2], 2.0466534158929769770, BY_PRECISION(5e-6, 1e-14));
}

static void hopeless_functions_become_their_mean(void **state) {
    prt_real f[16] = { 0 }, out[16], s = 7;
    int i;
    (void)state;
    f[0] = -1;
    f[5] = PRT__R(0.1);
    assert_int_equal(prt_sh_dering(4, f, out, &s), PRT_OK);
    assert_near(s, 2, 0);
    assert_near(out[0], -1, 0);
    for (i = 1; i < 16; i++) assert_true(out[i] == 0);
    f[0] = 0;
    assert_int_equal(prt_sh_dering(4, f, out, &s), PRT_OK);
    assert_near(s, 2, 0);
    for (i = 0; i < 16; i++) assert_true(out[i] == 0);
    f[5] = 0;                                                      /* nothing is not negative */
    assert_int_equal(prt_sh_dering(4, f, out, &s), PRT_OK);
    assert_near(s, 0, 0);
    f[0] = 2;                                                      /* one band, or a constant */
    assert_int_equal(prt_sh_dering(1, f, out, &s), PRT_OK);
    assert_near(s, 0, 0);
    assert_near(out[0], 2, 0);
}

static void dering_in_place_and_without_strength(void **state) {
    static prt_real f[MOST], out[MOST];
    (void)state;
    make(2, 5, f);
    prt_sh_dering(5, f, out, NULL);
    prt_sh_dering(5, f, f, NULL);
    assert_memory_equal(f, out, 25 * sizeof *f);
}

static void bad_calls_write_nothing(void **state) {
    prt_real f[4] = { 1, 2, 3, 4 }, out[4] = { 5, 6, 7, 8 }, s = 9;
    (void)state;
    assert_int_equal(prt_sh_dering(0, f, out, &s), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_dering(PRT_MAX_BANDS + 1, NULL, out, &s), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_dering(2, NULL, out, &s), PRT_ERR_NULL);
    assert_int_equal(prt_sh_dering(2, f, NULL, &s), PRT_ERR_NULL);
    f[3] = (prt_real)NAN;
    assert_int_equal(prt_sh_dering(2, f, out, &s), PRT_ERR_VALUE);
    f[3] = (prt_real)INFINITY;
    assert_int_equal(prt_sh_dering(2, f, out, &s), PRT_ERR_VALUE);
    assert_near(out[0] + out[1] + out[2] + out[3] + s, 35, 0);
    assert_true(prt_sh_minimum(0, f, NULL) == 0);
    assert_true(prt_sh_minimum(2, NULL, NULL) == 0);
    f[3] = (prt_real)NAN;
    assert_true(FAST_MATH || prt_sh_minimum(2, f, NULL) != 0);    /* NaN in, NaN out */
}

/* The search ends whatever it is given; also where the compiler takes NaN for impossible. */
static void the_search_ends(void **state) {
    static prt_real f[MOST], out[MOST];
    static const double odd[] = { NAN, INFINITY, -INFINITY, DBL_MAX, 1e-310 };
    int bands, k;
    (void)state;
    for (bands = 1; bands <= 3; bands++)
        for (k = 0; k < 25; k++) {
            make(k % 3, bands, f);
            f[(7 * k) % (bands * bands)] = (prt_real)odd[k % 5];
            f[(3 * k) % (bands * bands)] = (prt_real)odd[k / 5];
            (void)prt_sh_minimum(bands, f, NULL);
            (void)prt_sh_dering(bands, f, out, NULL);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_minimum_is_found), cmocka_unit_test(a_zonal_minimum_is_that_of_its_polynomial),
        cmocka_unit_test(dering_is_the_least_that_lifts), cmocka_unit_test(a_delta_needs_the_positive_window),
        cmocka_unit_test(two_bands_by_hand), cmocka_unit_test(hopeless_functions_become_their_mean),
        cmocka_unit_test(dering_in_place_and_without_strength), cmocka_unit_test(bad_calls_write_nothing), cmocka_unit_test(the_search_ends)
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
