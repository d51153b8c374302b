/* Room >>sh against tables of 20 digits, MPFR, quadrature and the definition. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"
#include "golden_csv.h"
#include <mpfr.h>

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
enum { MAX_N = PRT_SH_COUNT(PRT_MAX_BANDS) };

/* Y(l,m) = p(l,m)(z) {Re,Im} (x+iy)^m of every band, 200 bits, by the recurrence in z of m outer, l inner. At the
   direction as it is, like the header's (what length it has after rounding is not the evaluator's error), or normalised. */
static void mpfr_sh(int bands, prt_vec3 d, int normalised, double *y) {
    mpfr_t x[3], r, re, im, t, u, sector, p1, p2, p;
    mpfr_ptr all[] = { x[0], x[1], x[2], r, re, im, t, u, sector, p1, p2, p };
    int i, l, m;
    for (i = 0; i < 12; i++) mpfr_init2(all[i], 200);
    mpfr_set_d(x[0], (double)d.x, MPFR_RNDN); mpfr_set_d(x[1], (double)d.y, MPFR_RNDN); mpfr_set_d(x[2], (double)d.z, MPFR_RNDN);
    mpfr_set_zero(r, 1);
    for (i = 0; i < 3; i++) { mpfr_sqr(t, x[i], MPFR_RNDN); mpfr_add(r, r, t, MPFR_RNDN); }
    mpfr_sqrt(r, r, MPFR_RNDN);
    for (i = 0; i < 3 && normalised; i++) mpfr_div(x[i], x[i], r, MPFR_RNDN);
    mpfr_const_pi(sector, MPFR_RNDN);
    mpfr_mul_ui(sector, sector, 4, MPFR_RNDN);
    mpfr_rec_sqrt(sector, sector, MPFR_RNDN);
    mpfr_set_ui(re, 1, MPFR_RNDN);
    mpfr_set_zero(im, 1);
    for (m = 0; m < bands; m++) {
        if (m) {
            mpfr_set_ui(t, (unsigned long)(2 * m + 1), MPFR_RNDN);
            mpfr_div_ui(t, t, (unsigned long)(m == 1 ? 1 : 2 * m), MPFR_RNDN);
            mpfr_sqrt(t, t, MPFR_RNDN);
            mpfr_mul(sector, sector, t, MPFR_RNDN);
            mpfr_mul(t, re, x[0], MPFR_RNDN); mpfr_mul(u, im, x[1], MPFR_RNDN); mpfr_sub(t, t, u, MPFR_RNDN);
            mpfr_mul(u, re, x[1], MPFR_RNDN); mpfr_mul(im, im, x[0], MPFR_RNDN); mpfr_add(im, im, u, MPFR_RNDN);
            mpfr_set(re, t, MPFR_RNDN);
        }
        mpfr_set(p1, sector, MPFR_RNDN);
        mpfr_set_zero(p2, 1);
        for (l = m; l < bands; l++) {
            if (l > m) {
                mpfr_mul(t, x[2], p1, MPFR_RNDN);
                mpfr_set_si(u, (long)(l - 1) * (l - 1) - (long)m * m, MPFR_RNDN);
                mpfr_div_ui(u, u, (unsigned long)(4 * (l - 1) * (l - 1) > 0 ? 4 * (l - 1) * (l - 1) - 1 : 1), MPFR_RNDN);
                mpfr_sqrt(u, u, MPFR_RNDN);
                mpfr_mul(u, u, p2, MPFR_RNDN);
                mpfr_sub(t, t, u, MPFR_RNDN);
                mpfr_set_ui(u, (unsigned long)(4 * l * l - 1), MPFR_RNDN);
                mpfr_div_ui(u, u, (unsigned long)(l * l - m * m), MPFR_RNDN);
                mpfr_sqrt(u, u, MPFR_RNDN);
                mpfr_mul(p, t, u, MPFR_RNDN);
                mpfr_set(p2, p1, MPFR_RNDN);
                mpfr_set(p1, p, MPFR_RNDN);
            }
            mpfr_mul(t, p1, im, MPFR_RNDN);
            y[PRT_SH_INDEX(l, -m)] = mpfr_get_d(t, MPFR_RNDN);
            mpfr_mul(t, p1, re, MPFR_RNDN);
            y[PRT_SH_INDEX(l, m)] = mpfr_get_d(t, MPFR_RNDN);
        }
    }
    for (i = 0; i < 12; i++) mpfr_clear(all[i]);
}

static void agrees_with_golden_table_to_13_bands(void **state) {
    FILE *f = golden_open("sh_ref.csv");
    golden_row r;
    int rows = 0;
    (void)state;
    while (golden_next(f, &r)) {
        prt_vec3 d = prt__vec3((prt_real)r.x, (prt_real)r.y, (prt_real)r.z);
        prt_real y[13 * 13];
        int bands;
        for (bands = r.l + 1; bands <= 13; bands++) {
            assert_int_equal(prt_sh_eval(bands, d, y), PRT_OK);
            assert_near(y[PRT_SH_INDEX(r.l, r.m)], r.value, BY_PRECISION(4e-6, 1e-14) + golden_input_rounding(r.l, EPS));
        }
        rows++;
    }
    fclose(f);
    assert_int_equal(rows, 40 * 169);
}

/* The directions are rounded first and the reference is taken there: what remains is the error of the arithmetic. */
static void agrees_with_mpfr(void **state) {
    static const struct { int bands; double error_float, error_double; } promised[] = {
        { 6, 1.3e-6, 2e-15 }, { 10, 5e-6, 8e-15 }, { 13, 1.2e-7, 1e-14 }, { 32, 1.5e-7, 4e-14 }, { 64, 1.5e-7, 3e-13 }
    };
    size_t row;
    int k, i;
    (void)state;
    for (row = 0; row < sizeof promised / sizeof promised[0]; row++) {
        int bands = promised[row].bands;
        for (k = 0; k < 200; k++) {
            prt_vec3 d = random_direction();
            static double want[MAX_N];
            static prt_real y[MAX_N];
            if (k < 24) {                              /* ever closer to the poles, through 1e-8 to the pole itself */
                double tilt = k < 20 ? pow(10, -k / 2.0) : 0;
                d = prt__vec3((prt_real)(sin(tilt) * 0.6), (prt_real)(sin(tilt) * -0.8), (prt_real)((k & 1 ? -1 : 1) * cos(tilt)));
            }
            mpfr_sh(bands, d, 0, want);
            assert_int_equal(prt_sh_eval(bands, d, y), PRT_OK);
            for (i = 0; i < PRT_SH_COUNT(bands); i++)
                assert_near(y[i], want[i], BY_PRECISION(promised[row].error_float, promised[row].error_double));
        }
    }
}

static void kernels_agree_with_the_recurrence(void **state) {
    int bands, k, i;
    (void)state;
    for (bands = 1; bands <= PRT__SH_KERNELS; bands++)
        for (k = 0; k < 200; k++) {
            prt_vec3 d = random_direction();
            prt_real y[100], slow[100];
            prt__sh_eval(bands, d, y);
            prt__sh_recurrence(bands, d, NULL, slow, 1);
            for (i = 0; i < bands * bands; i++) assert_near(y[i], slow[i], 4 * bands * EPS);
        }
}

static void basis_is_orthonormal(void **state) {
    enum { BANDS = 20, N = BANDS * BANDS };
    static double gram[N][N];
    static prt_real y[N];
    double worst = 0;
    int i, j, a, b;
    (void)state;
    memset(gram, 0, sizeof gram);
    for (i = 0; i < BANDS; i++) {
        double z, weight;
        prt__gauss_legendre(BANDS, i, &z, &weight);
        for (j = 0; j < 2 * BANDS; j++) {
            double phi = PRT__PI * j / BANDS, s = sqrt((1 - z) * (1 + z));
            prt_sh_eval(BANDS, prt__vec3((prt_real)(s * cos(phi)), (prt_real)(s * sin(phi)), (prt_real)z), y);
            for (a = 0; a < N; a++)
                for (b = 0; b <= a; b++) gram[a][b] += weight * PRT__PI / BANDS * (double)y[a] * (double)y[b];
        }
    }
    for (a = 0; a < N; a++)
        for (b = 0; b <= a; b++) {
            double error = fabs(gram[a][b] - (a == b));
            if (!(error <= worst)) worst = error;
        }
    assert_at_most(worst, 20 * BANDS * EPS);
}

static void signs_are_those_of_the_conventions(void **state) {
    const double c1 = sqrt(3 / (4 * PRT__PI));
    prt_real y[9];
    (void)state;
    prt_sh_eval(3, prt__vec3(PRT__R(0.48), PRT__R(0.6), PRT__R(0.64)), y);
    assert_near(y[0], 1 / sqrt(4 * PRT__PI), EPS);
    assert_near(y[1], c1 * 0.6, EPS);
    assert_near(y[2], c1 * 0.64, EPS);
    assert_near(y[3], c1 * 0.48, EPS);
    assert_near(y[4], sqrt(15 / (4 * PRT__PI)) * 0.48 * 0.6, EPS);
    assert_near(y[8], sqrt(15 / (16 * PRT__PI)) * (0.48 * 0.48 - 0.6 * 0.6), EPS);
}

static void batches_are_bit_equal_whatever_the_count(void **state) {
    static const int bands_of[] = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 33, 64 };
    enum { COUNT = 75, STRIDE = 83 };
    static prt_vec3 dirs[COUNT];
    static prt_real x[COUNT], y[COUNT], z[COUNT];
    static prt_real rows[COUNT * MAX_N], part[COUNT * MAX_N], soa[MAX_N * STRIDE], all[MAX_N * COUNT];
    size_t b;
    int k, i, first, count;
    (void)state;
    for (k = 0; k < COUNT; k++) {
        dirs[k] = random_direction();
        x[k] = dirs[k].x; y[k] = dirs[k].y; z[k] = dirs[k].z;
    }
    for (b = 0; b < sizeof bands_of / sizeof bands_of[0]; b++) {
        int bands = bands_of[b], n = bands * bands;
        assert_int_equal(prt_sh_eval_n(bands, COUNT, dirs, rows), PRT_OK);
        assert_int_equal(prt_sh_eval_soa(bands, COUNT, x, y, z, all, COUNT), PRT_OK);
        for (k = 0; k < COUNT; k++) {                  /* the batched forms are the plain one, up to rounding */
            prt_sh_eval(bands, dirs[k], part);
            for (i = 0; i < n; i++) {
                assert_near(rows[k * n + i], part[i], 4 * bands * EPS);
                assert_near(all[i * COUNT + k], part[i], 4 * bands * EPS);
            }
        }
        for (count = 1; count <= COUNT; count += count < 40 ? 1 : 7) {
            first = (count * 7) % (COUNT - count + 1);
            for (i = 0; i < n * STRIDE; i++) soa[i] = -77;
            memset(part, 0, sizeof part);
            assert_int_equal(prt_sh_eval_n(bands, count, dirs + first, part), PRT_OK);
            assert_memory_equal(part, rows + first * n, (size_t)(count * n) * sizeof(prt_real));
            assert_int_equal(prt_sh_eval_soa(bands, count, x + first, y + first, z + first, soa, STRIDE), PRT_OK);
            for (k = 0; k < STRIDE; k++)
                for (i = 0; i < n; i++) {
                    prt_real want = k < count ? all[i * COUNT + first + k] : -77;
                    assert_memory_equal(&soa[i * STRIDE + k], &want, sizeof want);
                }
        }
    }
}

static void reconstruction_and_dot(void **state) {
    static prt_real f[MAX_N], g[MAX_N], y[MAX_N];
    int bands, i, k;
    (void)state;
    for (bands = 1; bands <= PRT_MAX_BANDS; bands += bands < 14 ? 1 : 10) {
        int n = bands * bands;
        double size = 0, want = 0;
        for (i = 0; i < n; i++) { f[i] = (prt_real)(uniform() - 0.5); g[i] = (prt_real)(uniform() - 0.5); }
        for (i = 0; i < n; i++) { want += (double)f[i] * (double)g[i]; size += fabs((double)f[i] * (double)g[i]); }
        assert_near(prt_sh_dot(bands, f, g), want, size * EPS * (n / 8 + 4));
        for (k = 0; k < 20; k++) {
            prt_vec3 d = random_direction();
            prt_sh_eval(bands, d, y);
            want = size = 0;
            for (i = 0; i < n; i++) { want += (double)f[i] * (double)y[i]; size += fabs((double)f[i] * (double)y[i]); }
            assert_near(prt_sh_at(bands, f, d), want, size * EPS * (n / 8 + 4 + bands));
        }
    }
}

static void reference_is_the_definition(void **state) {
    FILE *f = golden_open("sh_ref.csv");
    golden_row r;
    static double want[81 * 81];
    int k, l, m;
    (void)state;
    while (golden_next(f, &r)) assert_near(prt_reference_sh(r.l, r.m, r.x, r.y, r.z), r.value,
                                           2e-14 + golden_input_rounding(r.l, DBL_EPSILON));
    fclose(f);
    for (k = 0; k < 20; k++) {
        prt_vec3 d = random_direction();
        mpfr_sh(PRT_REFERENCE_MAX_L + 1, d, 1, want);
        for (l = 0; l <= PRT_REFERENCE_MAX_L; l++)
            for (m = -l; m <= l; m++)
                assert_near(prt_reference_sh(l, m, (double)d.x, (double)d.y, (double)d.z), want[PRT_SH_INDEX(l, m)], 3e-13);
    }
    assert_true(prt_reference_sh(PRT_REFERENCE_MAX_L + 1, 0, 0, 0, 1) == 0);
    assert_true(prt_reference_sh(2, 3, 0, 0, 1) == 0);
    assert_true(prt_reference_sh(2, -3, 0, 0, 1) == 0);
    assert_true(prt_reference_sh(-1, 0, 0, 0, 1) == 0);
    assert_true(prt_reference_sh(2, 0, 0, 0, 0) == 0);
}

static double cubic(void *user, prt_vec3 d) {          /* = Y(2,1)/a + Y(3,-3)/b, by their polynomials */
    (void)user;
    return (double)d.x * (double)d.z + (double)d.y * (3 * (double)d.x * (double)d.x - (double)d.y * (double)d.y);
}

static void reference_projection_is_exact_for_polynomials(void **state) {
    prt_real f[25];
    int i;
    (void)state;
    assert_int_equal(prt_reference_project(5, 5, cubic, NULL, f), PRT_OK);
    for (i = 0; i < 25; i++) {
        double want = i == PRT_SH_INDEX(2, 1) ? sqrt(4 * PRT__PI / 15) : i == PRT_SH_INDEX(3, -3) ? sqrt(32 * PRT__PI / 35) : 0;
        assert_near(f[i], want, 16 * EPS);
    }
}

static void gauss_rule_is_exact(void **state) {
    static const int sizes[] = { 1, 2, 3, 10, 64, 255, 1024 };
    size_t s;
    int i, power;
    (void)state;
    for (s = 0; s < sizeof sizes / sizeof sizes[0]; s++) {
        int n = sizes[s];
        double moment[8] = { 0 };
        for (i = 0; i < n; i++) {
            double z, w;
            prt__gauss_legendre(n, i, &z, &w);
            for (power = 0; power < 8; power++) moment[power] += w * pow(z, power);
        }
        for (power = 0; power < 8 && power < 2 * n; power++)
            assert_near(moment[power], power & 1 ? 0 : 2.0 / (power + 1), 4e-15 + 1e-16 * n);
    }
}

static void bad_arguments_write_nothing(void **state) {
    prt_vec3 d = { 0, 0, 1 };
    prt_real y[4] = { 7, 7, 7, 7 }, f[4] = { 1, 1, 1, 1 };
    static const prt_real untouched[4] = { 7, 7, 7, 7 };
    int bands;
    (void)state;
    for (bands = -1; bands <= PRT_MAX_BANDS + 1; bands += PRT_MAX_BANDS + 2) {         /* -1 and PRT_MAX_BANDS + 1 */
        assert_int_equal(prt_sh_eval(bands, d, y), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_eval_n(bands, 1, &d, y), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_eval_soa(bands, 1, &d.x, &d.y, &d.z, y, 1), PRT_ERR_BANDS);
        assert_int_equal(prt_reference_project(bands, 4, cubic, NULL, y), PRT_ERR_BANDS);
        assert_true(prt_sh_at(bands, f, d) == 0);
        assert_true(prt_sh_dot(bands, f, f) == 0);
    }
    assert_int_equal(prt_sh_eval(0, d, y), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_eval(2, d, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_eval_n(2, -1, &d, y), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_eval_n(2, 1, NULL, y), PRT_ERR_NULL);
    assert_int_equal(prt_sh_eval_n(2, 1, &d, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_eval_n(2, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_sh_eval_soa(2, -1, f, f, f, y, 1), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_eval_soa(2, 4, f, f, f, y, 3), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_eval_soa(2, 1, NULL, f, f, y, 1), PRT_ERR_NULL);
    assert_int_equal(prt_sh_eval_soa(2, 1, f, NULL, f, y, 1), PRT_ERR_NULL);
    assert_int_equal(prt_sh_eval_soa(2, 1, f, f, NULL, y, 1), PRT_ERR_NULL);
    assert_int_equal(prt_sh_eval_soa(2, 1, f, f, f, NULL, 1), PRT_ERR_NULL);
    assert_int_equal(prt_sh_eval_soa(2, 0, NULL, NULL, NULL, NULL, 0), PRT_OK);
    assert_int_equal(prt_reference_project(2, 0, cubic, NULL, y), PRT_ERR_COUNT);
    assert_int_equal(prt_reference_project(2, 4097, cubic, NULL, y), PRT_ERR_COUNT);
    assert_int_equal(prt_reference_project(2, 4, NULL, NULL, y), PRT_ERR_NULL);
    assert_int_equal(prt_reference_project(2, 4, cubic, NULL, NULL), PRT_ERR_NULL);
    assert_true(prt_sh_at(2, NULL, d) == 0);
    assert_true(prt_sh_dot(2, NULL, f) == 0 && prt_sh_dot(2, f, NULL) == 0);
    assert_memory_equal(y, untouched, sizeof y);
}

static void nan_and_huge_values_stay_inside_their_item(void **state) {
    static const double values[] = { NAN, INFINITY, -INFINITY, 1e30, -1e30, 1e-42, 0 };
    enum { V = 7 };
    static prt_real rows[V * V * V * 400];
    prt_vec3 dirs[V * V * V];
    int bands, i, count = 0;
    (void)state;
    skip_if_fast_math();
    for (i = 0; i < V * V * V; i++)
        dirs[count++] = prt__vec3((prt_real)values[i % V], (prt_real)values[i / V % V], (prt_real)values[i / V / V]);
    dirs[count - 1] = prt__vec3(0, 0, 1);
    for (bands = 1; bands <= 20; bands++) {
        int n = bands * bands;
        assert_int_equal(prt_sh_eval_n(bands, count, dirs, rows), PRT_OK);
        for (i = 0; i < count; i++) prt_sh_eval(bands, dirs[i], rows + i * n);
        prt_sh_eval_n(bands, count, dirs, rows);
        assert_near(rows[(count - 1) * n], 0.28209479177387814, EPS);         /* untouched by its neighbours */
        for (i = 1; i < n; i++) assert_true(rows[(count - 1) * n + i] == rows[(count - 1) * n + i]);
    }
    assert_true(isnan((double)prt_sh_at(12, rows, prt__vec3((prt_real)NAN, 0, 0))));
}

static void every_result_has_a_message(void **state) {
    int r;
    (void)state;
    for (r = -1; r <= (int)PRT__RESULT_COUNT; r++) assert_true(strlen(prt_result_string((prt_result)r)) > 4);
    assert_string_equal(prt_result_string(PRT_OK), "success");
    assert_string_equal(prt_result_string((prt_result)1000), "unknown result");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_golden_table_to_13_bands),
        cmocka_unit_test(agrees_with_mpfr),
        cmocka_unit_test(kernels_agree_with_the_recurrence),
        cmocka_unit_test(basis_is_orthonormal),
        cmocka_unit_test(signs_are_those_of_the_conventions),
        cmocka_unit_test(batches_are_bit_equal_whatever_the_count),
        cmocka_unit_test(reconstruction_and_dot),
        cmocka_unit_test(reference_is_the_definition),
        cmocka_unit_test(reference_projection_is_exact_for_polynomials),
        cmocka_unit_test(gauss_rule_is_exact),
        cmocka_unit_test(bad_arguments_write_nothing),
        cmocka_unit_test(nan_and_huge_values_stay_inside_their_item),
        cmocka_unit_test(every_result_has_a_message),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
