/* prt_sh_triple against 549 values of 20 digits, and against exact integers (GMP) at high l. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "golden_csv.h"
#include <gmp.h>
#include <mpfr.h>

enum { BITS = 400 };

static void unpack(int i, int *l, int *m) {
    *l = (int)sqrt((double)i + 0.5);
    *m = i - *l * (*l + 1);
}

/* Within half a unit in the last place of a reference that is itself rounded, plus what 20 digits leave open. */
static void assert_rounded(double got, double want) { assert_near(got, want, fabs(want) * 1.2e-16); }

static void agrees_with_the_reference_values(void **state) {
    FILE *file = golden_open("gaunt_ref.csv");
    int rows = 0, index[3], l[3], m[3], k;
    double want;
    (void)state;
    while (fscanf(file, "%d,%d,%d,%lf", &index[0], &index[1], &index[2], &want) == 4) {
        for (k = 0; k < 3; k++) unpack(index[k], &l[k], &m[k]);
        assert_rounded(prt_sh_triple(l[0], m[0], l[1], m[1], l[2], m[2]), want);
        assert_rounded(prt_sh_triple(l[2], m[2], l[0], m[0], l[1], m[1]), want);
        assert_rounded(prt_sh_triple(l[1], m[1], l[0], m[0], l[2], m[2]), want);
        rows++;
    }
    fclose(file);
    assert_int_equal(rows, 549);
}

/* Every coefficient that the reference does not list is 0: 549 unique ones below 6 bands are all there are. */
static void vanishes_elsewhere(void **state) {
    int i, j, k, count = 0;
    (void)state;
    for (i = 0; i < 36; i++)
        for (j = i; j < 36; j++)
            for (k = j; k < 36; k++) {
                int l[3], m[3];
                unpack(i, &l[0], &m[0]);
                unpack(j, &l[1], &m[1]);
                unpack(k, &l[2], &m[2]);
                count += prt_sh_triple(l[0], m[0], l[1], m[1], l[2], m[2]) != 0;
            }
    assert_int_equal(count, 549);
}

/* ---- exact Clebsch-Gordan coefficients from sums of binomial coefficients ---- */

static void binomial(mpz_t r, int n, int k) {
    if (k < 0 || k > n) mpz_set_ui(r, 0);
    else mpz_bin_uiui(r, (unsigned long)n, (unsigned long)k);
}

static void multiply_binomial(mpz_t r, int n, int k) {
    mpz_t b;
    mpz_init(b);
    binomial(b, n, k);
    mpz_mul(r, r, b);
    mpz_clear(b);
}

/* Sum over t of (-1)^t (j1+j2-j, t) (j1-j2+j, j1-m1-t) (j2-j1+j, j2+m2-t), times the root of a quotient of binomials */
static void exact_clebsch_gordan(mpfr_t value, int j1, int m1, int j2, int m2, int j) {
    mpz_t sum, term, over, under;
    mpfr_t root;
    int t;
    mpz_inits(sum, term, over, under, NULL);
    mpfr_init2(root, BITS);
    for (t = 0; t <= j1 + j2 - j; t++) {
        binomial(term, j1 + j2 - j, t);
        multiply_binomial(term, j1 - j2 + j, j1 - m1 - t);
        multiply_binomial(term, j2 - j1 + j, j2 + m2 - t);
        if (t % 2) mpz_sub(sum, sum, term); else mpz_add(sum, sum, term);
    }
    mpz_set_ui(over, 1);
    mpz_set_ui(under, 1);
    multiply_binomial(over, 2 * j1, j1 + j2 - j);
    multiply_binomial(over, 2 * j2, j1 + j2 - j);
    multiply_binomial(under, j1 + j2 + j + 1, j1 + j2 - j);
    multiply_binomial(under, 2 * j1, j1 - m1);
    multiply_binomial(under, 2 * j2, j2 - m2);
    multiply_binomial(under, 2 * j, j - m1 - m2);
    mpfr_set_z(value, over, MPFR_RNDN);
    mpfr_set_z(root, under, MPFR_RNDN);
    mpfr_div(value, value, root, MPFR_RNDN);
    mpfr_sqrt(value, value, MPFR_RNDN);
    mpfr_mul_z(value, value, sum, MPFR_RNDN);
    mpz_clears(sum, term, over, under, NULL);
    mpfr_clear(root);
}

/* The azimuthal integral of three of 1, sqrt 2 cos, sqrt 2 sin, over 2 pi, by a sum that is exact for it. */
static double azimuth(int m1, int m2, int m3) {
    int m[3], k, i, count = abs(m1) + abs(m2) + abs(m3) + 1;
    double sum = 0;
    m[0] = m1; m[1] = m2; m[2] = m3;
    for (k = 0; k < count; k++) {
        double angle = 2 * PRT__PI * k / count, product = 1;
        for (i = 0; i < 3; i++)
            product *= m[i] > 0 ? sqrt(2.0) * cos(m[i] * angle) : m[i] < 0 ? sqrt(2.0) * sin(-m[i] * angle) : 1;
        sum += product;
    }
    return sum / count;
}

/* l3 carries the largest |m|. The azimuthal factor is 0, +-1 or +-1/sqrt 2. */
static double exact_triple(int l1, int m1, int l2, int m2, int l3, int m3) {
    mpfr_t value, zero, factor, four_pi;
    double result, turn = azimuth(m1, m2, m3);
    int sign = turn < 0 ? -1 : 1;
    mpfr_inits2(BITS, value, zero, factor, four_pi, (mpfr_ptr)0);
    exact_clebsch_gordan(value, l1, abs(m1), l2, abs(m2), l3);
    exact_clebsch_gordan(zero, l1, 0, l2, 0, l3);
    mpfr_mul(value, value, zero, MPFR_RNDN);
    mpfr_const_pi(four_pi, MPFR_RNDN);
    mpfr_mul_ui(four_pi, four_pi, 4, MPFR_RNDN);
    mpfr_set_ui(factor, (unsigned long)(2 * l1 + 1), MPFR_RNDN);
    mpfr_mul_ui(factor, factor, (unsigned long)(2 * l2 + 1), MPFR_RNDN);
    mpfr_div_ui(factor, factor, (unsigned long)(2 * l3 + 1), MPFR_RNDN);
    mpfr_div(factor, factor, four_pi, MPFR_RNDN);
    if (fabs(turn) < 0.9) mpfr_div_ui(factor, factor, 2, MPFR_RNDN);
    mpfr_sqrt(factor, factor, MPFR_RNDN);
    mpfr_mul(value, value, factor, MPFR_RNDN);
    mpfr_mul_si(value, value, sign, MPFR_RNDN);
    result = fabs(turn) < 0.1 ? 0 : mpfr_get_d(value, MPFR_RNDN);
    mpfr_clears(value, zero, factor, four_pi, (mpfr_ptr)0);
    return result;
}

static uint32_t seed = 2463534242u;
static int below(int n) {
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    return (int)(seed % (uint32_t)n);
}

/* Random coefficients that the selection rules allow, and how many differ from the exact value's rounding. */
static void compare_random(int limit, int count) {
    int tried = 0, off = 0;
    while (tried < count) {
        int l1 = below(limit + 1), l2 = below(limit + 1), l3 = below(limit + 1), a, b, s, m1, m2, m3;
        double got, want;
        if ((l1 + l2 + l3) % 2 || l1 > l2 + l3 || l2 > l1 + l3 || l3 > l1 + l2) continue;
        a = below(l1 + 1);
        b = below(l2 + 1);
        if (a + b > l3) continue;
        s = below(4);
        m1 = s & 1 ? -a : a;
        m2 = s & 2 ? -b : b;
        m3 = (m1 < 0) + (m2 < 0) == 1 ? -(a + b) : a + b;
        got = prt_sh_triple(l1, m1, l2, m2, l3, m3);
        want = exact_triple(l1, m1, l2, m2, l3, m3);
        assert_near(got, want, fabs(want) * 2.3e-16);
        if (got != prt_sh_triple(l2, m2, l3, m3, l1, m1)) fail_msg("not symmetric at l = %d %d %d", l1, l2, l3);
        off += got != want;
        tried++;
    }
    print_message("l <= %d: %d of %d values are not the nearest double\n", limit, off, count);
    assert_int_equal(off, 0);
}

static void is_the_nearest_double_at_high_l(void **state) {
    (void)state;
    compare_random(20, 1500);
    compare_random(50, 600);
    compare_random(100, 200);
    compare_random(150, 60);
}

/* Far from the classical region the values fall by hundreds of orders of magnitude and keep their relative accuracy. */
static void keeps_tiny_values(void **state) {
    static const int cases[][6] = {
        { 50, 50, 50, 0, 100, 50 }, { 100, 100, 100, -100, 200, 0 }, { 150, 150, 10, 0, 150, 150 },
        { 150, 140, 150, -140, 298, 0 }, { 80, 0, 80, 80, 158, 80 }, { 120, 119, 60, 60, 180, 179 },
        { 64, 64, 64, 64, 128, 128 }, { 140, -1, 141, 141, 3, 0 }, { 200, 200, 200, -200, 400, 0 }
    };
    size_t i;
    (void)state;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const int *c = cases[i];
        int top = abs(c[1]) == abs(c[3]) + abs(c[5]) ? 0 : abs(c[3]) == abs(c[1]) + abs(c[5]) ? 1 : 2;
        const int *x = c + 2 * ((top + 1) % 3), *y = c + 2 * ((top + 2) % 3), *z = c + 2 * top;
        double want = abs(z[1]) == abs(x[1]) + abs(y[1]) ? exact_triple(x[0], x[1], y[0], y[1], z[0], z[1]) : 0;
        assert_near(prt_sh_triple(c[0], c[1], c[2], c[3], c[4], c[5]), want, fabs(want) * 1.2e-16);
    }
}

/* Completeness: sum over l3, m3 of G(1 2 3)^2 is the integral of Y1^2 Y2^2, known by quadrature of a polynomial; here
   Y1 = Y2 = Y(l,0) at the pole's own expansion: sum over l3 of G(l 0 l 0 l3 0) Y(l3,0)(pole) = Y(l,0)(pole)^2. */
static void sums_to_the_product_at_the_pole(void **state) {
    int l, k;
    (void)state;
    for (l = 0; l <= 400; l += 50) {
        double sum = 0;
        for (k = 0; k <= 2 * l; k++) sum += prt_sh_triple(l, 0, l, 0, k, 0) * sqrt((2.0 * k + 1) / (4 * PRT__PI));
        assert_near(sum / ((2.0 * l + 1) / (4 * PRT__PI)), 1, 1e-13);
    }
}

static void refuses_what_is_no_coefficient(void **state) {
    (void)state;
    assert_true(prt_sh_triple(-1, 0, 0, 0, 1, 0) == 0);
    assert_true(prt_sh_triple(1, 2, 1, 0, 2, 2) == 0);
    assert_true(prt_sh_triple(1, INT32_MIN, 1, 0, 2, 0) == 0);
    assert_true(prt_sh_triple(INT32_MAX, 0, INT32_MAX, 0, 0, 0) == 0);
    assert_true(prt_sh_triple(INT32_MIN, 0, 0, 0, 0, 0) == 0);
    assert_true(prt_sh_triple(2, 0, 2, 0, 1, 0) == 0);
    assert_true(prt_sh_triple(1, 0, 1, 0, 4, 0) == 0);
    assert_true(prt_sh_triple(2, -1, 2, 1, 2, 2) == 0);
    assert_near(prt_sh_triple(0, 0, 0, 0, 0, 0), 0.28209479177387814, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_the_reference_values), cmocka_unit_test(vanishes_elsewhere),
        cmocka_unit_test(is_the_nearest_double_at_high_l), cmocka_unit_test(keeps_tiny_values),
        cmocka_unit_test(sums_to_the_product_at_the_pole), cmocka_unit_test(refuses_what_is_no_coefficient)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
