/* Room >>ch against tables of 20 digits, MPFR from the definition, quadrature, and what the thesis does. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"
#include "golden_csv.h"
#include <mpfr.h>

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
enum { MAX_N = PRT_SH_COUNT(PRT_MAX_BANDS) };

static double norm_of(int count, const prt_real *f) {
    double sum = 0;
    int i;
    for (i = 0; i < count; i++) sum += (double)f[i] * (double)f[i];
    return sqrt(sum);
}

static double distance(int count, const prt_real *f, const prt_real *g) {
    double sum = 0;
    int i;
    for (i = 0; i < count; i++) sum += ((double)f[i] - (double)g[i]) * ((double)f[i] - (double)g[i]);
    return sqrt(sum);
}

/* ---- the definition, with exact integer polynomials ---- */

enum { TOP = 64, BITS = 700 };
typedef mpz_t polynomial[TOP];                                                  /* coefficients of z^0 ... z^(TOP-1) */

static void polynomial_init(polynomial p) { int i; for (i = 0; i < TOP; i++) mpz_init(p[i]); }
static void polynomial_clear(polynomial p) { int i; for (i = 0; i < TOP; i++) mpz_clear(p[i]); }

static void differentiate(polynomial p) {
    int i;
    for (i = 0; i + 1 < TOP; i++) mpz_mul_ui(p[i], p[i + 1], (unsigned long)(i + 1));
    mpz_set_ui(p[TOP - 1], 0);
}

/* d^m T_l / dz^m:  T_l = l/2 sum_k (-1)^k (l-k-1)!/(k! (l-2k)!) (2z)^(l-2k) */
static void chebyshev(int l, int m, polynomial p) {
    int k;
    for (k = 0; k < TOP; k++) mpz_set_ui(p[k], 0);
    for (k = 0; 2 * k <= l; k++) {
        mpz_t *c = &p[l - 2 * k], t;
        if (l == 0) { mpz_set_ui(*c, 1); break; }
        mpz_init(t);
        mpz_fac_ui(*c, (unsigned long)(l - k - 1));
        mpz_mul_ui(*c, *c, (unsigned long)l);
        mpz_mul_2exp(*c, *c, (unsigned long)(l - 2 * k));
        mpz_fac_ui(t, (unsigned long)k); mpz_tdiv_q(*c, *c, t);
        mpz_fac_ui(t, (unsigned long)(l - 2 * k)); mpz_tdiv_q(*c, *c, t);
        mpz_tdiv_q_2exp(*c, *c, 1);
        if (k & 1) mpz_neg(*c, *c);
        mpz_clear(t);
    }
    while (m--) differentiate(p);
}

/* 2^l d^m P_l / dz^m:  2^l P_l = sum_k (-1)^k C(l,k) C(2l-2k,l) z^(l-2k) */
static void legendre(int l, int m, polynomial p) {
    int k;
    for (k = 0; k < TOP; k++) mpz_set_ui(p[k], 0);
    for (k = 0; 2 * k <= l; k++) {
        mpz_t t;
        mpz_init(t);
        mpz_bin_uiui(p[l - 2 * k], (unsigned long)l, (unsigned long)k);
        mpz_bin_uiui(t, (unsigned long)(2 * l - 2 * k), (unsigned long)l);
        mpz_mul(p[l - 2 * k], p[l - 2 * k], t);
        if (k & 1) mpz_neg(p[l - 2 * k], p[l - 2 * k]);
        mpz_clear(t);
    }
    while (m--) differentiate(p);
}

/* out = int over the sphere of p q (1-z^2)^m {1 or cos^2(m phi)} */
static void inner_product(int m, polynomial p, polynomial q, mpfr_t out) {
    mpfr_t moment, term;
    mpz_t sum;
    int i, k;
    mpfr_inits2(BITS, moment, term, (mpfr_ptr)0);
    mpz_init(sum);
    mpfr_const_pi(moment, MPFR_RNDN);                                           /* of z^0: 2 (2m)!!/(2m+1)!! */
    mpfr_mul_ui(moment, moment, m ? 2 : 4, MPFR_RNDN);
    for (k = 1; k <= m; k++) {
        mpfr_mul_ui(moment, moment, (unsigned long)(2 * k), MPFR_RNDN);
        mpfr_div_ui(moment, moment, (unsigned long)(2 * k + 1), MPFR_RNDN);
    }
    mpfr_set_zero(out, 1);
    for (k = 0; k < 2 * TOP - 1; k += 2) {                                      /* coefficient of z^k in p q */
        mpz_set_ui(sum, 0);
        for (i = k < TOP ? 0 : k - TOP + 1; i <= k && i < TOP; i++) mpz_addmul(sum, p[i], q[k - i]);
        mpfr_mul_z(term, moment, sum, MPFR_RNDN);
        mpfr_add(out, out, term, MPFR_RNDN);
        mpfr_mul_ui(moment, moment, (unsigned long)(k + 1), MPFR_RNDN);
        mpfr_div_ui(moment, moment, (unsigned long)(k + 2 * m + 3), MPFR_RNDN);
    }
    mpfr_clears(moment, term, (mpfr_ptr)0);
    mpz_clear(sum);
}

static void defined_norm(int l, int m, mpfr_t norm) {
    polynomial p;
    polynomial_init(p);
    chebyshev(l, m, p);
    inner_product(m, p, p, norm);
    mpfr_rec_sqrt(norm, norm, MPFR_RNDN);
    polynomial_clear(p);
}

/* C(l,m) of every band below `bands` at each direction, made of unit length exactly: out[k * bands^2 + i]. */
static void defined_ch(int bands, int count, const prt_vec3 *dirs, double *out) {
    mpfr_t x, y, z, r, re, im, t, u, norm, value;
    polynomial p;
    int l, m, k, i;
    mpfr_inits2(BITS, x, y, z, r, re, im, t, u, norm, value, (mpfr_ptr)0);
    polynomial_init(p);
    for (l = 0; l < bands; l++) {
        for (m = 0; m <= l; m++) {
            chebyshev(l, m, p);
            inner_product(m, p, p, norm);
            mpfr_rec_sqrt(norm, norm, MPFR_RNDN);
            for (k = 0; k < count; k++) {
                double *to = out + (size_t)k * (size_t)(bands * bands);
                mpfr_set_d(x, (double)dirs[k].x, MPFR_RNDN);
                mpfr_set_d(y, (double)dirs[k].y, MPFR_RNDN);
                mpfr_set_d(z, (double)dirs[k].z, MPFR_RNDN);
                mpfr_sqr(r, x, MPFR_RNDN);
                mpfr_fma(r, y, y, r, MPFR_RNDN);
                mpfr_fma(r, z, z, r, MPFR_RNDN);
                mpfr_sqrt(r, r, MPFR_RNDN);
                mpfr_div(x, x, r, MPFR_RNDN); mpfr_div(y, y, r, MPFR_RNDN); mpfr_div(z, z, r, MPFR_RNDN);
                mpfr_set(re, norm, MPFR_RNDN);
                mpfr_set_zero(im, 1);
                for (i = 0; i < m; i++) {
                    mpfr_fmms(t, re, x, im, y, MPFR_RNDN);
                    mpfr_fmma(u, re, y, im, x, MPFR_RNDN);
                    mpfr_swap(re, t);
                    mpfr_swap(im, u);
                }
                mpfr_set_zero(value, 1);
                for (i = l - m; i >= 0; i--) {
                    mpfr_mul(value, value, z, MPFR_RNDN);
                    mpfr_add_z(value, value, p[i], MPFR_RNDN);
                }
                mpfr_mul(t, value, im, MPFR_RNDN);
                to[PRT_SH_INDEX(l, -m)] = mpfr_get_d(t, MPFR_RNDN);
                mpfr_mul(t, value, re, MPFR_RNDN);
                to[PRT_SH_INDEX(l, m)] = mpfr_get_d(t, MPFR_RNDN);
            }
        }
    }
    polynomial_clear(p);
    mpfr_clears(x, y, z, r, re, im, t, u, norm, value, (mpfr_ptr)0);
}

/* S(l,L,m) = int C(l,m) Y(L,m) */
static double defined_entry(int l, int L, int m) {
    polynomial p, q;
    mpfr_t a, b, c;
    double out;
    mpfr_inits2(BITS, a, b, c, (mpfr_ptr)0);
    polynomial_init(p);
    polynomial_init(q);
    chebyshev(l, m, p);
    legendre(L, m, q);
    inner_product(m, p, p, a);
    inner_product(m, q, q, b);
    inner_product(m, p, q, c);
    mpfr_mul(a, a, b, MPFR_RNDN);
    mpfr_rec_sqrt(a, a, MPFR_RNDN);
    mpfr_mul(c, c, a, MPFR_RNDN);
    out = mpfr_get_d(c, MPFR_RNDN);
    polynomial_clear(p);
    polynomial_clear(q);
    mpfr_clears(a, b, c, (mpfr_ptr)0);
    return out;
}

/* ---- evaluation and norms ---- */

static void agrees_with_golden_table_to_14_bands(void **state) {
    FILE *f = golden_open("ch_ref.csv");
    golden_row r;
    int rows = 0;
    (void)state;
    while (golden_next(f, &r)) {
        prt_vec3 d = prt__vec3((prt_real)r.x, (prt_real)r.y, (prt_real)r.z);
        prt_real c[14 * 14];
        int bands;
        for (bands = r.l + 1; bands <= 14; bands++) {
            assert_int_equal(prt_ch_eval(bands, d, c), PRT_OK);
            assert_near(c[PRT_SH_INDEX(r.l, r.m)], r.value,
                        BY_PRECISION(4e-6, 1e-14) + golden_input_rounding(r.l, EPS));
        }
        rows++;
    }
    fclose(f);
    assert_int_equal(rows, 40 * 196);
}

/* At directions that stand exactly as prt_real has them, save for their length, which rounding leaves EPS off 1. */
static void agrees_with_the_definition(void **state) {
    static const struct { int bands; double error_float, error_double; } promised[] = {
        { 6, 6e-7, 1.6e-15 }, { 10, 2.2e-6, 5e-15 }, { 14, 4.5e-6, 8e-15 }, { 33, 2.2e-5, 4.5e-14 }, { 64, 1e-4, 2e-13 }
    };
    enum { COUNT = 40 };
    static double want[COUNT * MAX_N];
    static prt_real c[MAX_N];
    prt_vec3 dirs[COUNT];
    size_t row;
    int k, i;
    (void)state;
    for (k = 0; k < COUNT; k++) {
        double tilt = k < 20 ? pow(10, -k / 2.0) : 0;
        dirs[k] = random_direction();
        if (k < 22) dirs[k] = prt__vec3((prt_real)(sin(tilt) * 0.6), (prt_real)(sin(tilt) * -0.8),
                                        (prt_real)((k & 1 ? -1 : 1) * cos(tilt)));
    }
    for (row = 0; row < sizeof promised / sizeof promised[0]; row++) {
        int bands = promised[row].bands, n = bands * bands;
        double worst = 0;
        defined_ch(bands, COUNT, dirs, want);
        for (k = 0; k < COUNT; k++) {
            assert_int_equal(prt_ch_eval(bands, dirs[k], c), PRT_OK);
            for (i = 0; i < n; i++) {
                double error = fabs((double)c[i] - want[k * n + i]);
                if (!(error <= worst)) worst = error;
            }
        }
        assert_at_most(worst, BY_PRECISION(promised[row].error_float, promised[row].error_double));
    }
}

static void norms_agree_with_golden_table_to_64(void **state) {
    FILE *f = golden_open("ch_norm_ref.csv");
    int l, m, rows = 0;
    double plain, folded, worst = 0;
    (void)state;
    while (fscanf(f, "%d,%d,%lf,%lf", &l, &m, &plain, &folded) == 4) {
        double error = fabs(prt_ch_norm(l, m) / folded - 1);
        if (!(error <= worst)) worst = error;
        assert_true(prt_ch_norm(l, -m) == prt_ch_norm(l, m));
        rows++;
    }
    fclose(f);
    assert_int_equal(rows, 65 * 66 / 2);
    assert_at_most(worst, 4e-16);
}

static void norms_agree_with_the_definition(void **state) {
    int l, m;
    mpfr_t norm;
    (void)state;
    mpfr_init2(norm, BITS);
    for (l = 0; l < TOP; l += 7)
        for (m = 0; m <= l; m++) {
            double want;
            defined_norm(l, m, norm);
            want = mpfr_get_d(norm, MPFR_RNDN);
            assert_near(prt_ch_norm(l, m) / want, 1, 5e-16);
        }
    mpfr_clear(norm);
}

/* A(m,m) T_m^(m) = A(m,m) 2^(m-1) m! is the factor of Y(m,m); the logarithm reaches where the norm is tiny. */
static void norms_reach_far(void **state) {
    int m;
    (void)state;
    for (m = 1; m <= 150; m++) {
        double log_sector = 0.5 * (log(2 / (4 * PRT__PI)) + lgamma(2.0 * m + 2) - 2 * m * log(2) - 2 * lgamma(m + 1.0));
        double want = log_sector - (m - 1) * log(2) - lgamma(m + 1.0);
        assert_near(log(prt_ch_norm(m, m)), want, 1e-14 * fabs(want) + 1e-14);
    }
    assert_true(prt_ch_norm(400, 0) > 0);
    assert_true(prt_ch_norm(3, 4) == 0 && prt_ch_norm(3, -4) == 0 && prt_ch_norm(-1, 0) == 0);
    assert_true(prt_ch_norm(70000, 0) == 0 && prt_ch_norm(-2147483647 - 1, 0) == 0);
    assert_true(prt_ch_norm(5, -2147483647 - 1) == 0 && prt_ch_norm(5, 2147483647) == 0);
}

static void kernels_agree_with_the_recurrence(void **state) {
    int bands, k, i;
    (void)state;
    for (bands = 1; bands <= PRT__SH_KERNELS; bands++)
        for (k = 0; k < 200; k++) {
            prt_vec3 d = random_direction();
            prt_real c[100], slow[100];
            prt_ch_eval(bands, d, c);
            prt__ch_recurrence(bands, d, NULL, slow, 1);
            for (i = 0; i < bands * bands; i++) assert_near(c[i], slow[i], 16 * EPS);
        }
}

static void batches_are_bit_equal_whatever_the_count(void **state) {
    static const int bands_of[] = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16 };
    enum { COUNT = 45, STRIDE = 53 };
    static prt_vec3 dirs[COUNT];
    static prt_real x[COUNT], y[COUNT], z[COUNT];
    static prt_real rows[COUNT * 256], part[COUNT * 256], soa[256 * STRIDE], all[256 * COUNT];
    size_t b;
    int k, i, first, count;
    (void)state;
    for (k = 0; k < COUNT; k++) {
        dirs[k] = random_direction();
        x[k] = dirs[k].x; y[k] = dirs[k].y; z[k] = dirs[k].z;
    }
    for (b = 0; b < sizeof bands_of / sizeof bands_of[0]; b++) {
        int bands = bands_of[b], n = bands * bands;
        assert_int_equal(prt_ch_eval_n(bands, COUNT, dirs, rows), PRT_OK);
        assert_int_equal(prt_ch_eval_soa(bands, COUNT, x, y, z, all, COUNT), PRT_OK);
        for (k = 0; k < COUNT; k++) {
            prt_ch_eval(bands, dirs[k], part);
            for (i = 0; i < n; i++) {
                assert_near(rows[k * n + i], part[i], 4 * bands * EPS);
                assert_near(all[i * COUNT + k], part[i], 4 * bands * EPS);
            }
        }
        for (count = 1; count <= COUNT; count++) {
            first = (count * 7) % (COUNT - count + 1);
            for (i = 0; i < n * STRIDE; i++) soa[i] = -77;
            assert_int_equal(prt_ch_eval_n(bands, count, dirs + first, part), PRT_OK);
            assert_memory_equal(part, rows + first * n, (size_t)(count * n) * sizeof(prt_real));
            assert_int_equal(prt_ch_eval_soa(bands, count, x + first, y + first, z + first, soa, STRIDE), PRT_OK);
            for (k = 0; k < STRIDE; k++)
                for (i = 0; i < n; i++) {
                    prt_real want = k < count ? all[i * COUNT + first + k] : -77;
                    assert_memory_equal(&soa[i * STRIDE + k], &want, sizeof want);
                }
        }
    }
}

/* ---- conversions ---- */

/* Every entry of S at 16 bands, through the public functions, against the integral. */
static void conversion_is_the_integral_of_c_and_y(void **state) {
    enum { BANDS = 16, N = BANDS * BANDS };
    prt_real one[N], sh[N];
    double worst = 0;
    int l, L, m;
    (void)state;
    for (m = 0; m < BANDS; m++)
        for (l = m; l < BANDS; l++) {
            memset(one, 0, sizeof one);
            one[PRT_SH_INDEX(l, m)] = 1;
            one[PRT_SH_INDEX(l, -m)] = 1;
            assert_int_equal(prt_sh_from_ch(BANDS, one, sh), PRT_OK);
            for (L = 0; L < BANDS; L++) {
                double want = L >= m && L <= l && !((l - L) & 1) ? defined_entry(l, L, m) : 0;
                double error = L >= m ? fabs((double)sh[PRT_SH_INDEX(L, m)] - want) : 0;
                if (!(error <= worst)) worst = error;
                if (L >= m) assert_true(sh[PRT_SH_INDEX(L, m)] == sh[PRT_SH_INDEX(L, -m)]);
            }
        }
    assert_at_most(worst, BY_PRECISION(6e-8, 5e-16));
}

static void conversion_keeps_the_function(void **state) {
    static prt_real f[MAX_N], a[MAX_N], back[MAX_N];
    int bands, k;
    (void)state;
    for (bands = 1; bands <= PRT_MAX_BANDS; bands += bands < 20 ? 1 : 11) {
        int n = bands * bands;
        double size;
        random_vector(n, f);
        size = norm_of(n, f);
        assert_int_equal(prt_ch_from_sh(bands, f, a), PRT_OK);
        for (k = 0; k < 10; k++) {                      /* errors of both evaluations, growing as l EPS |f| |Y| */
            prt_vec3 d = random_direction();
            assert_near(prt_ch_at(bands, a, d), prt_sh_at(bands, f, d),
                        4 * bands * EPS * size * bands / sqrt(4 * PRT__PI));
        }
        assert_int_equal(prt_sh_from_ch(bands, a, back), PRT_OK);
        assert_at_most(distance(n, back, f), 4 * EPS * size);
        assert_int_equal(prt_ch_to_moments(bands, a, back), PRT_OK);
        assert_int_equal(prt_ch_from_moments(bands, back, back), PRT_OK);               /* may alias */
        assert_at_most(distance(n, back, a), 2 * bands * EPS * norm_of(n, a));          /* cond(G) = 0.87 bands */
    }
}

static void conversions_may_alias(void **state) {
    typedef prt_result conversion(int, const prt_real *, prt_real *);
    static conversion *const all[4] = { prt_ch_from_sh, prt_sh_from_ch, prt_ch_from_moments, prt_ch_to_moments };
    prt_real f[100], out[100];
    int i;
    (void)state;
    for (i = 0; i < 4; i++) {
        random_vector(100, f);
        assert_int_equal(all[i](10, f, out), PRT_OK);
        assert_int_equal(all[i](10, f, f), PRT_OK);
        assert_memory_equal(f, out, sizeof f);
        out[0] = 7;
        assert_int_equal(all[i](0, f, out), PRT_ERR_BANDS);
        assert_int_equal(all[i](PRT_MAX_BANDS + 1, f, out), PRT_ERR_BANDS);
        assert_int_equal(all[i](3, NULL, out), PRT_ERR_NULL);
        assert_int_equal(all[i](3, f, NULL), PRT_ERR_NULL);
        assert_true(out[0] == 7);
    }
}

/* int C_i C_j by quadrature, against moments of unit vectors; and the two values that show C is not orthogonal. */
static void gram_matrix_by_quadrature(void **state) {
    enum { BANDS = 16, N = BANDS * BANDS };
    static double gram[N][N];
    static prt_real c[N], one[N], moments[N];
    double worst = 0;
    int i, j, a, b;
    (void)state;
    memset(gram, 0, sizeof gram);
    for (i = 0; i < BANDS; i++) {
        double z, weight;
        prt__gauss_legendre(BANDS, i, &z, &weight);
        for (j = 0; j < 2 * BANDS; j++) {
            double phi = PRT__PI * j / BANDS, s = sqrt((1 - z) * (1 + z));
            prt_ch_eval(BANDS, prt__vec3((prt_real)(s * cos(phi)), (prt_real)(s * sin(phi)), (prt_real)z), c);
            for (a = 0; a < N; a++)
                for (b = 0; b < N; b++) gram[a][b] += weight * PRT__PI / BANDS * (double)c[a] * (double)c[b];
        }
    }
    for (a = 0; a < N; a++) {
        memset(one, 0, sizeof one);
        one[a] = 1;
        assert_int_equal(prt_ch_to_moments(BANDS, one, moments), PRT_OK);
        for (b = 0; b < N; b++) {
            double error = fabs(gram[a][b] - (double)moments[b]);
            if (!(error <= worst)) worst = error;
        }
    }
    assert_at_most(worst, 20 * BANDS * EPS);
    assert_near(gram[PRT_SH_INDEX(0, 0)][PRT_SH_INDEX(2, 0)], -sqrt(15.0 / 7) / 3, 20 * BANDS * EPS);
    assert_near(gram[PRT_SH_INDEX(1, 0)][PRT_SH_INDEX(3, 0)], -0.6 * sqrt(35.0 / 51), 20 * BANDS * EPS);
    for (a = 0; a < N; a++) assert_near(gram[a][a], 1, 20 * BANDS * EPS);
}

/* Moments of a function of more bands give its projection: what truncating its SH gives. */
static void moments_give_the_projection(void **state) {
    enum { WIDE = 9, BANDS = 6, N = BANDS * BANDS };
    prt_real f[WIDE * WIDE], c[N], moments[N] = { 0 }, a[N], want[N];
    double sum[N] = { 0 };
    int i, j, k;
    (void)state;
    random_vector(WIDE * WIDE, f);
    for (i = 0; i < WIDE; i++) {
        double z, weight;
        prt__gauss_legendre(WIDE, i, &z, &weight);
        for (j = 0; j < 2 * WIDE; j++) {
            double phi = PRT__PI * j / WIDE, s = sqrt((1 - z) * (1 + z));
            prt_vec3 d = prt__vec3((prt_real)(s * cos(phi)), (prt_real)(s * sin(phi)), (prt_real)z);
            prt_ch_eval(BANDS, d, c);
            for (k = 0; k < N; k++) sum[k] += weight * PRT__PI / WIDE * (double)prt_sh_at(WIDE, f, d) * (double)c[k];
        }
    }
    for (k = 0; k < N; k++) moments[k] = (prt_real)sum[k];
    assert_int_equal(prt_ch_from_moments(BANDS, moments, a), PRT_OK);
    assert_int_equal(prt_ch_from_sh(BANDS, f, want), PRT_OK);
    assert_at_most(distance(N, a, want), 100 * EPS * norm_of(N, want));
}

static void dot_is_the_integral(void **state) {
    static prt_real f[MAX_N], g[MAX_N], a[MAX_N], b[MAX_N];
    int bands;
    (void)state;
    for (bands = 1; bands <= PRT_MAX_BANDS; bands += bands < 12 ? 1 : 13) {
        int n = bands * bands;
        double size;
        random_vector(n, f);
        random_vector(n, g);
        size = norm_of(n, f) * norm_of(n, g);
        prt_ch_from_sh(bands, f, a);
        prt_ch_from_sh(bands, g, b);
        assert_near(prt_ch_dot(bands, a, b), prt_sh_dot(bands, f, g), 8 * EPS * size);
        assert_near(prt_ch_dot(bands, a, a), norm_of(n, f) * norm_of(n, f), 8 * EPS * norm_of(n, f) * norm_of(n, f));
    }
}

/* A turn about (1,2,2)/3 by an angle, and its mirror image. */
static void turn(double angle, int mirror, prt_real rotation[9]) {
    double c = cos(angle), s = sin(angle), x = 1.0 / 3, y = 2.0 / 3, z = 2.0 / 3, r[9];
    int i;
    r[0] = c + x * x * (1 - c);     r[1] = x * y * (1 - c) - z * s; r[2] = x * z * (1 - c) + y * s;
    r[3] = y * x * (1 - c) + z * s; r[4] = c + y * y * (1 - c);     r[5] = y * z * (1 - c) - x * s;
    r[6] = z * x * (1 - c) - y * s; r[7] = z * y * (1 - c) + x * s; r[8] = c + z * z * (1 - c);
    for (i = 0; i < 9; i++) rotation[i] = (prt_real)(mirror ? -r[i] : r[i]);
}

static prt_vec3 turned_direction(const prt_real r[9], prt_vec3 v) {
    return prt__vec3(r[0] * v.x + r[1] * v.y + r[2] * v.z, r[3] * v.x + r[4] * v.y + r[5] * v.z,
                     r[6] * v.x + r[7] * v.y + r[8] * v.z);
}

static void rotation_moves_the_features(void **state) {
    static const int bands_of[] = { 1, 2, 3, 5, 8, 10, 17, 33 };
    static prt_real f[MAX_N], out[MAX_N];
    size_t b;
    int k;
    (void)state;
    for (b = 0; b < sizeof bands_of / sizeof bands_of[0]; b++)
        for (k = 0; k < 12; k++) {
            int bands = bands_of[b], n = bands * bands, j;
            prt_real r[9];
            double size;
            turn(0.1 + 0.6 * k, k & 1, r);
            random_vector(n, f);
            size = norm_of(n, f);
            assert_int_equal(prt_ch_rotate(bands, r, f, out), PRT_OK);
            for (j = 0; j < 10; j++) {
                prt_vec3 v = random_direction();
                assert_near(prt_ch_at(bands, out, turned_direction(r, v)), prt_ch_at(bands, f, v),
                            12 * bands * EPS * size * bands / sqrt(4 * PRT__PI));
            }
            assert_int_equal(prt_ch_rotate(bands, r, f, f), PRT_OK);                    /* may alias */
            assert_memory_equal(f, out, (size_t)n * sizeof(prt_real));
        }
}

/* Of factors whose product fits the bands the product is the product, at every direction; else it is SH's. */
static void product_is_the_product(void **state) {
    static prt_real f[MAX_N], g[MAX_N], a[MAX_N], b[MAX_N], ab[MAX_N], want[MAX_N];
    int bands, k, i;
    (void)state;
    for (bands = 1; bands <= 17; bands += bands < 9 ? 1 : 4) {
        int n = bands * bands, half = (bands + 1) / 2;
        for (k = 0; k < 4; k++) {
            random_vector(n, f);
            random_vector(n, g);
            assert_int_equal(prt_ch_from_sh(bands, f, a), PRT_OK);
            assert_int_equal(prt_ch_from_sh(bands, g, b), PRT_OK);
            assert_int_equal(prt_ch_product(bands, a, b, ab), PRT_OK);
            assert_int_equal(prt_sh_from_ch(bands, ab, ab), PRT_OK);
            assert_int_equal(prt_sh_product(bands, f, g, want), PRT_OK);
            assert_at_most(distance(n, ab, want), 40 * bands * EPS * norm_of(n, f) * norm_of(n, g));
            for (i = half * half; i < n; i++) a[i] = b[i] = 0;
            assert_int_equal(prt_ch_product(bands, a, b, ab), PRT_OK);
            for (i = 0; i < 10; i++) {
                prt_vec3 v = random_direction();
                assert_near(prt_ch_at(bands, ab, v), (double)prt_ch_at(bands, a, v) * (double)prt_ch_at(bands, b, v),
                            40 * bands * bands * EPS * norm_of(n, a) * norm_of(n, b));
            }
            assert_int_equal(prt_ch_product(bands, a, b, b), PRT_OK);                   /* may alias */
            assert_memory_equal(b, ab, (size_t)n * sizeof(prt_real));
        }
    }
}

static void bad_rotations_and_factors_write_nothing(void **state) {
    prt_real identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, skew[9] = { 1, 0.5, 0, 0, 1, 0, 0, 0, 1 };
    static const prt_real twice[9] = { 2, 0, 0, 0, 2, 0, 0, 0, 2 }, zero[9] = { 0 };
    prt_real f[4] = { 1, 2, 3, 4 }, out[4] = { 7, 7, 7, 7 };
    static const prt_real untouched[4] = { 7, 7, 7, 7 };
    (void)state;
    assert_int_equal(prt_ch_rotate(0, identity, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_ch_rotate(PRT_MAX_BANDS + 1, identity, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_ch_rotate(2, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_ch_rotate(2, identity, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_ch_rotate(2, identity, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_ch_rotate(2, skew, f, out), PRT_ERR_ROTATION);
    assert_int_equal(prt_ch_rotate(2, twice, f, out), PRT_ERR_ROTATION);
    assert_int_equal(prt_ch_rotate(2, zero, f, out), PRT_ERR_ROTATION);
    skew[1] = (prt_real)NAN;
    assert_int_equal(prt_ch_rotate(2, skew, f, out), PRT_ERR_ROTATION);
    assert_int_equal(prt_ch_product(0, f, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_ch_product(PRT_MAX_BANDS + 1, f, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_ch_product(2, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_ch_product(2, f, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_ch_product(2, f, f, NULL), PRT_ERR_NULL);
    assert_memory_equal(out, untouched, sizeof out);
}

/* A mirror is accepted: f'(x, y, -z) = f(x, y, z). */
static void reflections_work(void **state) {
    static const prt_real mirror[9] = { 1, 0, 0, 0, 1, 0, 0, 0, -1 };
    prt_real f[64], out[64];
    int i, n;
    (void)state;
    for (n = 1; n <= 8; n++) {
        prt_vec3 d = prt__vec3(PRT__R(0.48), PRT__R(-0.64), PRT__R(0.6)), e = d;
        e.z = -d.z;
        for (i = 0; i < n * n; i++) f[i] = (prt_real)((i * 37 % 17) - 8) / 8;
        assert_int_equal(prt_ch_rotate(n, mirror, f, out), PRT_OK);
        assert_near(prt_ch_at(n, out, e), (double)prt_ch_at(n, f, d), BY_PRECISION(1e-5, 2e-14));
    }
}

/* One band: C is the constant 1/(2 sqrt pi), and coefficients, moments and SH are one number. */
static void one_band_is_a_number(void **state) {
    prt_real f = PRT__R(2.5), g = PRT__R(-1.5), out = 0;
    const double c = 0.28209479177387814;
    (void)state;
    assert_int_equal(prt_ch_eval(1, prt__vec3(0, 0, 1), &out), PRT_OK);
    assert_near(out, c, BY_PRECISION(2e-8, 1e-16));
    assert_int_equal(prt_ch_from_sh(1, &f, &out), PRT_OK);
    assert_near(out, 2.5, 0);
    assert_int_equal(prt_ch_to_moments(1, &f, &out), PRT_OK);
    assert_near(out, 2.5, 0);
    assert_int_equal(prt_ch_product(1, &f, &g, &out), PRT_OK);
    assert_near(out, -3.75 * c, BY_PRECISION(1e-7, 1e-15));
    assert_near(prt_ch_dot(1, &f, &g), -3.75, 0);
}

/* What is not finite comes out again, and stops nothing. */
static void nan_goes_in_and_comes_out(void **state) {
    static const double odd[] = { NAN, INFINITY, -INFINITY };
    static const prt_real identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    prt_real f[144], g[144], out[144];
    int n, i, k, l, m;
    (void)state;
    for (n = 2; n <= 12; n++)
        for (k = 0; k < 3; k++) {
            int at_l = (int)sqrt(n * n / 2 + 0.5), at_m = n * n / 2 - at_l * (at_l + 1);
            for (i = 0; i < n * n; i++) f[i] = g[i] = (prt_real)((i * 37 % 17) - 8) / 8;
            f[n * n / 2] = (prt_real)odd[k];
            assert_int_equal(prt_ch_from_sh(n, f, out), PRT_OK);
            assert_true(FAST_MATH || !prt__finite(out[n * n / 2]));
            for (l = 0; l < n; l++)                    /* others than its m and parity are not touched */
                for (m = -l; m <= l; m++)
                    if (m != at_m || (l - at_l) % 2) assert_true(prt__finite(out[PRT_SH_INDEX(l, m)]));
            assert_int_equal(prt_ch_from_moments(n, f, out), PRT_OK);
            assert_true(FAST_MATH || !prt__finite(out[n * n / 2]));
            assert_int_equal(prt_ch_product(n, f, g, out), PRT_OK);
            assert_true(FAST_MATH || !prt__finite(out[n * n / 2]));
            assert_int_equal(prt_ch_rotate(n, identity, f, out), PRT_OK);
            assert_true(FAST_MATH || !prt__finite(out[n * n / 2]));
            assert_true(FAST_MATH || !prt__finite(prt_ch_dot(n, f, g)));
        }
}

static void bad_conversions_write_nothing(void **state) {
    typedef prt_result conversion(int bands, const prt_real *in, prt_real *out);
    static conversion *const conversions[] = { prt_ch_from_sh, prt_sh_from_ch, prt_ch_from_moments, prt_ch_to_moments };
    static const prt_real f[4] = { 1, 2, 3, 4 }, untouched[4] = { 7, 7, 7, 7 };
    prt_real out[4] = { 7, 7, 7, 7 };
    int i;
    (void)state;
    for (i = 0; i < 4; i++) {
        assert_int_equal(conversions[i](0, f, out), PRT_ERR_BANDS);
        assert_int_equal(conversions[i](PRT_MAX_BANDS + 1, NULL, out), PRT_ERR_BANDS);
        assert_int_equal(conversions[i](2, NULL, out), PRT_ERR_NULL);
        assert_int_equal(conversions[i](2, f, NULL), PRT_ERR_NULL);
    }
    assert_memory_equal(out, untouched, sizeof out);
}

static void bad_arguments_write_nothing(void **state) {
    prt_vec3 d = { 0, 0, 1 };
    prt_real c[4] = { 7, 7, 7, 7 }, f[4] = { 1, 1, 1, 1 };
    static const prt_real untouched[4] = { 7, 7, 7, 7 };
    int bands;
    (void)state;
    for (bands = -1; bands <= PRT_MAX_BANDS + 1; bands += PRT_MAX_BANDS + 2) {
        assert_int_equal(prt_ch_eval(bands, d, c), PRT_ERR_BANDS);
        assert_int_equal(prt_ch_eval_n(bands, 1, &d, c), PRT_ERR_BANDS);
        assert_int_equal(prt_ch_eval_soa(bands, 1, f, f, f, c, 1), PRT_ERR_BANDS);
        assert_true(prt_ch_at(bands, f, d) == 0 && prt_ch_dot(bands, f, f) == 0);
    }
    assert_int_equal(prt_ch_eval(2, d, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_ch_eval_n(2, -1, &d, c), PRT_ERR_COUNT);
    assert_int_equal(prt_ch_eval_n(2, 1, NULL, c), PRT_ERR_NULL);
    assert_int_equal(prt_ch_eval_n(2, 1, &d, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_ch_eval_n(2, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_ch_eval_soa(2, 4, f, f, f, c, 3), PRT_ERR_COUNT);
    assert_int_equal(prt_ch_eval_soa(2, 1, NULL, f, f, c, 1), PRT_ERR_NULL);
    assert_int_equal(prt_ch_eval_soa(2, 1, f, f, f, NULL, 1), PRT_ERR_NULL);
    assert_true(prt_ch_at(2, NULL, d) == 0 && prt_ch_dot(2, NULL, f) == 0 && prt_ch_dot(2, f, NULL) == 0);
    assert_memory_equal(c, untouched, sizeof c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_golden_table_to_14_bands), cmocka_unit_test(agrees_with_the_definition),
        cmocka_unit_test(norms_agree_with_golden_table_to_64), cmocka_unit_test(norms_agree_with_the_definition),
        cmocka_unit_test(norms_reach_far), cmocka_unit_test(kernels_agree_with_the_recurrence),
        cmocka_unit_test(batches_are_bit_equal_whatever_the_count),
        cmocka_unit_test(conversion_is_the_integral_of_c_and_y), cmocka_unit_test(conversion_keeps_the_function),
        cmocka_unit_test(conversions_may_alias), cmocka_unit_test(gram_matrix_by_quadrature),
        cmocka_unit_test(moments_give_the_projection), cmocka_unit_test(dot_is_the_integral),
        cmocka_unit_test(rotation_moves_the_features),
        cmocka_unit_test(product_is_the_product), cmocka_unit_test(bad_rotations_and_factors_write_nothing),
        cmocka_unit_test(reflections_work), cmocka_unit_test(one_band_is_a_number),
        cmocka_unit_test(nan_goes_in_and_comes_out), cmocka_unit_test(bad_conversions_write_nothing),
        cmocka_unit_test(bad_arguments_write_nothing)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
