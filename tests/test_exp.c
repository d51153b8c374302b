/* prt_sh_log, prt_sh_exp and prt_sh_exp_linear: constants, inverses, sums, small arguments, and a dense matrix
   function. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"

enum { MOST = 8, SIZE = MOST * MOST };
static const double one = 3.5449077018110320546;

static void random_function(int n, double size, prt_real *f) {
    double sum = 0;
    int i;
    for (i = 0; i < n; i++) {
        f[i] = (prt_real)signed_uniform();
        sum += (double)f[i] * (double)f[i];
    }
    for (i = 0; i < n; i++) f[i] = (prt_real)((double)f[i] * size / sqrt(sum));
}

/* The symmetric matrix of multiplication by f, in double, from exact coefficients */
static double matrix[SIZE][SIZE];
static void make_matrix(int bands, const prt_real *f) {
    int l1, m1, l2, m2, l3, m3;
    memset(matrix, 0, sizeof matrix);
    for (l1 = 0; l1 < bands; l1++) for (m1 = -l1; m1 <= l1; m1++)
        for (l2 = 0; l2 < bands; l2++) for (m2 = -l2; m2 <= l2; m2++)
            for (l3 = 0; l3 < bands; l3++) for (m3 = -l3; m3 <= l3; m3++) {
                int i = PRT_SH_INDEX(l1, m1), j = PRT_SH_INDEX(l2, m2), k = PRT_SH_INDEX(l3, m3);
                if ((l1 + l2 + l3) % 2 || l1 > l2 + l3 || l2 > l1 + l3 || l3 > l1 + l2) continue;
                matrix[i][j] += prt_sh_triple(l1, m1, l2, m2, l3, m3) * (double)f[k];
            }
}

static void multiply(int n, const double *x, double *y) {
    int i, j;
    for (i = 0; i < n; i++) for (y[i] = 0, j = 0; j < n; j++) y[i] += matrix[i][j] * x[j];
}

/* exp(M) 1 as (1 + M/2^k + ...)^(2^k) 1: a Taylor series of 20 terms, 64 times over */
static void exact_exp(int bands, const prt_real *f, double *out) {
    int n = bands * bands, part, k, i;
    make_matrix(bands, f);
    memset(out, 0, sizeof(double) * SIZE);
    out[0] = one;
    for (part = 0; part < 64; part++) {
        double term[SIZE], next[SIZE];
        memcpy(term, out, sizeof term);
        for (k = 1; k <= 20; k++) {
            multiply(n, term, next);
            for (i = 0; i < n; i++) {
                term[i] = next[i] / (64.0 * k);
                out[i] += term[i];
            }
        }
    }
}

static double distance(int n, const prt_real *a, const double *b) {
    double sum = 0;
    int i;
    for (i = 0; i < n; i++) sum += ((double)a[i] - b[i]) * ((double)a[i] - b[i]);
    return sqrt(sum);
}
static double length(int n, const double *b) {
    double sum = 0;
    while (n--) sum += b[n] * b[n];
    return sqrt(sum);
}

static void constants_are_plain_numbers(void **state) {
    prt_real f[SIZE], out[SIZE];
    int bands, i, k;
    (void)state;
    for (bands = 1; bands <= MOST; bands++)
        for (k = -3; k <= 3; k++) {
            memset(f, 0, sizeof f);
            f[0] = (prt_real)(k * one);
            assert_int_equal(prt_sh_exp(bands, f, out), PRT_OK);
            assert_near(out[0] / exp(k) / one, 1, BY_PRECISION(1e-6, 1e-14));
            for (i = 1; i < bands * bands; i++) assert_near(out[i], 0, BY_PRECISION(1e-6, 1e-14) * exp(k));
            f[0] = (prt_real)(exp(k) * one);
            assert_int_equal(prt_sh_log(bands, 6, PRT__R(1e-3), f, out), PRT_OK);
            assert_near(out[0], k * one, BY_PRECISION(3e-6, 1e-14));
            for (i = 1; i < bands * bands; i++) assert_near(out[i], 0, 0);
        }
}

/* Against the matrix exponential: the squarings of truncated series are not exactly exp(M) 1, products not being
   associative, but agree with it to second order in f; so small f, large mean. */
static void small_functions_have_the_series(void **state) {
    prt_real f[SIZE], out[SIZE];
    double want[SIZE];
    int bands;
    (void)state;
    for (bands = 1; bands <= 6; bands++) {
        random_function(bands * bands, 0.05, f);
        f[0] -= 2;
        exact_exp(bands, f, want);
        assert_int_equal(prt_sh_exp(bands, f, out), PRT_OK);
        assert_at_most(distance(bands * bands, out, want) / length(bands * bands, want), BY_PRECISION(2e-6, 1e-8));
    }
}

/* Norm 1: no halving, the series alone; its first term left out is |f|^5/120 of operators whose norm is below
   |f| times the largest Y, and above in fact. */
static void the_series_is_of_degree_four(void **state) {
    prt_real f[SIZE], out[SIZE];
    double want[SIZE], term[SIZE], next[SIZE];
    int bands, k, i;
    (void)state;
    for (bands = 2; bands <= 6; bands++) {
        random_function(bands * bands, 0.99, f);
        f[0] = 0;
        make_matrix(bands, f);
        memset(want, 0, sizeof want);
        want[0] = one;
        memcpy(term, want, sizeof term);
        for (k = 1; k <= 4; k++) {
            multiply(bands * bands, term, next);
            for (i = 0; i < bands * bands; i++) {
                term[i] = next[i] / k;
                want[i] += term[i];
            }
        }
        prt_sh_exp(bands, f, out);
        assert_at_most(distance(bands * bands, out, want), BY_PRECISION(1e-6, 1e-14));
    }
}

/* exp*(log*(v)) gives the visibility of a cap back, to what `least` takes away. */
static void exp_undoes_log(void **state) {
    prt_real v[SIZE], logs[SIZE], back[SIZE];
    double want[SIZE];
    int bands, i;
    prt_vec3 axis = { PRT__R(0.6), 0, PRT__R(0.8) };
    (void)state;
    for (bands = 2; bands <= 6; bands++) {
        prt_sh_cone(bands, axis, PRT__R(0.35), v);
        for (i = 0; i < bands * bands; i++) v[i] = -v[i];
        v[0] += (prt_real)one;
        for (i = 0; i < bands * bands; i++) want[i] = (double)v[i];
        assert_int_equal(prt_sh_log(bands, PRT_KRYLOV_MAX, PRT__R(0.02), v, logs), PRT_OK);
        prt_sh_exp(bands, logs, back);
        assert_at_most(distance(bands * bands, back, want) / length(bands * bands, want), 0.012);
        prt_sh_exp_linear(bands, logs, back);
        assert_at_most(distance(bands * bands, back, want) / length(bands * bands, want), 0.03);
    }
}

/* Cap about +z: the logarithm by a dense matrix function in the zonal functions alone, its own Jacobi-free route: log x
   as the integral of (x-1)/(1+t(x-1)), 0 < t < 1, each integrand a linear solve. No eigenvalue is below least here. */
static void log_is_the_matrix_logarithm(void **state) {
    enum { NODES = 400 };
    prt_real v[SIZE], logs[SIZE];
    prt_vec3 up = { 0, 0, 1 };
    int bands, i, j, k, node;
    (void)state;
    for (bands = 2; bands <= 5; bands++) {
        double sum[SIZE] = { 0 };
        int n = bands * bands;
        prt_sh_cosine_lobe(bands, up, v);
        for (i = 0; i < n; i++) v[i] *= PRT__R(0.5);
        v[0] += (prt_real)one / 2;
        make_matrix(bands, v);
        for (node = 0; node < NODES; node++) {
            double t, w, a[SIZE][SIZE], b[SIZE];
            prt__gauss_legendre(NODES, node, &t, &w);
            t = (t + 1) / 2;
            for (i = 0; i < n; i++) {
                b[i] = (matrix[i][0] - (i == 0)) * one;
                for (j = 0; j < n; j++) a[i][j] = (1 - t) * (i == j) + t * matrix[i][j];
            }
            for (k = 0; k < n; k++)                                /* elimination; positive definite, no pivots */
                for (i = k + 1; i < n; i++) {
                    double factor = a[i][k] / a[k][k];
                    for (j = k; j < n; j++) a[i][j] -= factor * a[k][j];
                    b[i] -= factor * b[k];
                }
            for (i = n - 1; i >= 0; i--) {
                for (j = i + 1; j < n; j++) b[i] -= a[i][j] * b[j];
                b[i] /= a[i][i];
                sum[i] += w / 2 * b[i];
            }
        }
        assert_int_equal(prt_sh_log(bands, PRT_KRYLOV_MAX, PRT__R(1e-6), v, logs), PRT_OK);
        assert_at_most(distance(n, logs, sum), BY_PRECISION(1e-5, 1e-11));
    }
}

static void linear_is_right_at_its_two_points(void **state) {
    prt_real f[4] = { 0, 0, 0, 0 }, out[4];
    (void)state;
    assert_int_equal(prt_sh_exp_linear(2, f, out), PRT_OK);        /* nothing blocks: 1 */
    assert_near(out[0], one, BY_PRECISION(1e-6, 1e-15));
    f[0] = (prt_real)(-1.5 * one);                                 /* everywhere -1.5 */
    prt_sh_exp_linear(2, f, f);
    assert_near(f[0], exp(-1.5) * one, BY_PRECISION(1e-6, 1e-15));
    f[0] = 1;                                                      /* no visibility has this logarithm */
    f[2] = PRT__R(0.5);
    prt_sh_exp_linear(2, f, out);
    assert_near(out[0], 1 + one, BY_PRECISION(1e-6, 1e-15));
    assert_near(out[2], 0.5, 0);
}

static void in_place_and_with_nan(void **state) {
    prt_real f[SIZE], out[SIZE], same[SIZE];
    int i;
    (void)state;
    random_function(16, 3, f);
    f[0] -= 4;
    memcpy(same, f, sizeof f);
    prt_sh_exp(4, f, out);
    prt_sh_exp(4, same, same);
    if (!FAST_MATH) assert_memory_equal(same, out, 16 * sizeof *out);
    memcpy(same, f, sizeof f);
    prt_sh_log(4, 5, PRT__R(0.1), f, out);
    prt_sh_log(4, 5, PRT__R(0.1), same, same);
    if (!FAST_MATH) assert_memory_equal(same, out, 16 * sizeof *out);
    f[5] = (prt_real)NAN;
    prt_sh_exp(4, f, out);
    for (i = 0; i < 16; i++) assert_true(FAST_MATH || out[i] != out[i]);
    prt_sh_log(4, 5, PRT__R(0.1), f, out);
    for (i = 0; i < 16; i++) assert_true(FAST_MATH || out[i] != out[i]);
}

/* Every function ends, within its buffers, whatever it is given; also where the compiler takes NaN for impossible. */
static void nothing_hangs(void **state) {
    static prt_real f[SIZE], out[SIZE];
    static const double odd[] = { NAN, INFINITY, -INFINITY, DBL_MAX, 1e-310 };
    int bands, k;
    (void)state;
    for (bands = 1; bands * bands <= SIZE && bands <= 7; bands++)
        for (k = 0; k < 40; k++) {
            random_function(bands * bands, 3, f);
            f[(7 * k) % (bands * bands)] = (prt_real)odd[k % 5];
            f[(3 * k) % (bands * bands)] = (prt_real)odd[k / 5 % 5];
            assert_int_equal(prt_sh_exp(bands, f, out), PRT_OK);
            assert_int_equal(prt_sh_exp_linear(bands, f, out), PRT_OK);
            assert_int_equal(prt_sh_log(bands, 1 + k % PRT_KRYLOV_MAX, PRT__R(0.02), f, out), PRT_OK);
        }
}

static void bad_calls_write_nothing(void **state) {
    prt_real f[4] = { 1, 0, 0, 0 }, out[4] = { 5, 6, 7, 8 };
    (void)state;
    assert_int_equal(prt_sh_exp(0, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_exp(2, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_exp(2, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_exp_linear(PRT_MAX_BANDS + 1, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_exp_linear(2, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_exp_linear(2, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_log(0, 0, 0, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_log(2, 0, 0, f, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_log(2, PRT_KRYLOV_MAX + 1, 0, NULL, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_log(2, 2, 0, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_log(2, 2, 1, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_log(2, 2, 0, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_log(2, 2, -1, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_log(2, 2, (prt_real)NAN, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_log(2, 2, (prt_real)INFINITY, f, out), PRT_ERR_VALUE);
    assert_near(out[0] + out[1] + out[2] + out[3], 26, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants_are_plain_numbers), cmocka_unit_test(small_functions_have_the_series),
        cmocka_unit_test(the_series_is_of_degree_four), cmocka_unit_test(exp_undoes_log),
        cmocka_unit_test(log_is_the_matrix_logarithm), cmocka_unit_test(linear_is_right_at_its_two_points),
        cmocka_unit_test(in_place_and_with_nan), cmocka_unit_test(nothing_hangs), cmocka_unit_test(bad_calls_write_nothing)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
