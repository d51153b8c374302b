/* Products, squares, batches, matrices and masks against the sum over exact triple product coefficients in long double,
   and against pointwise multiplication on a grid that shares nothing with the header's. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"

enum { MOST = 24, COUNT = MOST * MOST };

static double length(int count, const prt_real *f) {
    double sum = 0;
    int i;
    for (i = 0; i < count; i++) sum += (double)f[i] * (double)f[i];
    return sqrt(sum);
}

/* ---- the reference: every nonzero coefficient of the tensor, listed once ---- */

typedef struct term { int i, j, k; double g; } term;
static term *terms;
static int term_count, term_capacity;

static void add_term(int i, int j, int k, double g) {
    if (term_count == term_capacity) {
        term_capacity = term_capacity ? 2 * term_capacity : 65536;
        terms = (term *)realloc(terms, (size_t)term_capacity * sizeof *terms);
        assert_non_null(terms);
    }
    terms[term_count].i = i;
    terms[term_count].j = j;
    terms[term_count].k = k;
    terms[term_count++].g = g;
}

/* A coefficient with i <= j <= k serves each pair of the three. */
static void add_terms(int i, int j, int k, double g) {
    add_term(i, j, k, g);
    if (j != k) add_term(i, k, j, g);
    if (i != j) add_term(j, k, i, g);
}

/* all (i,j,k), i <= j, below so many bands; the list is ordered by the largest band that takes part */
static void list_terms(int bands) {
    int l1, l2, l3, m1, m2, s;
    for (l3 = 0; l3 < bands; l3++)
        for (l2 = 0; l2 <= l3; l2++)
            for (l1 = l3 - l2; l1 <= l2; l1++) {
                if ((l1 + l2 + l3) % 2) continue;
                for (m1 = -l1; m1 <= l1; m1++)
                    for (m2 = -l2; m2 <= l2; m2++)
                        for (s = 0; s < 4; s++) {
                            int i = PRT_SH_INDEX(l1, m1), j = PRT_SH_INDEX(l2, m2), k;
                            int a = abs(m1) + abs(m2), b = abs(abs(m1) - abs(m2)), m3;
                            double g;
                            if (a == b && s > 1) continue;
                            m3 = s < 2 ? a : b;
                            if ((s & 1) && m3 == 0) continue;
                            if (s & 1) m3 = -m3;
                            k = PRT_SH_INDEX(l3, m3);
                            if (abs(m3) > l3 || i > j || j > k) continue;
                            g = prt_sh_triple(l1, m1, l2, m2, l3, m3);
                            if (g != 0) add_terms(i, j, k, g);
                        }
            }
}

static void reference(int bands, const prt_real *f, const prt_real *g, double *out) {
    static long double sum[COUNT];
    int t, i, n = bands * bands;
    for (i = 0; i < n; i++) sum[i] = 0;
    for (t = 0; t < term_count; t++) {
        const term *e = &terms[t];
        if (e->j >= n || e->k >= n) continue;
        sum[e->k] += (long double)e->g * f[e->i] * g[e->j];
        if (e->i != e->j) sum[e->k] += (long double)e->g * f[e->j] * g[e->i];
    }
    for (i = 0; i < n; i++) out[i] = (double)sum[i];
}

static double worst(int count, const prt_real *got, const double *want) {
    double most = 0;
    int i;
    for (i = 0; i < count; i++) {
        double off = fabs((double)got[i] - want[i]);
        if (!(off <= most)) most = off;
    }
    return most;
}

static int set_up(void **state) {
    (void)state;
    list_terms(16);
    return 0;
}
static int tear_down(void **state) {
    (void)state;
    free(terms);
    return 0;
}

/* The list is complete: as many nonzero coefficients as exact arithmetic counts (ordered pairs (i,j)). */
static void the_reference_is_complete(void **state) {
    static const int nonzero[] = { 1, 10, 83, 353, 1158, 2907, 6460, 12868, 23621, 40418 };
    int n, t;
    (void)state;
    for (n = 1; n <= 10; n++) {
        int count = 0;
        for (t = 0; t < term_count; t++)
            if (terms[t].j < n * n && terms[t].k < n * n) count += terms[t].i == terms[t].j ? 1 : 2;
        assert_int_equal(count, nonzero[n - 1]);
    }
}

/* ---- products ---- */

static void products_are_the_triple_sums(void **state) {
    static prt_real f[COUNT], g[COUNT], got[COUNT];
    static double want[COUNT];
    double overall = 0;
    int n, round;
    (void)state;
    for (n = 1; n <= 16; n++) {
        double most = 0;
        for (round = 0; round < (n < 8 ? 50 : 5); round++) {
            double off;
            random_vector(n * n, f);
            random_vector(n * n, g);
            reference(n, f, g, want);
            assert_int_equal(prt_sh_product(n, f, g, got), PRT_OK);
            off = worst(n * n, got, want) / (length(n * n, f) * length(n * n, g));
            if (!(off <= most)) most = off;
        }
        print_message("product, %2d bands: error %.2g of the norms\n", n, most);
        if (!(most <= overall)) overall = most;
    }
    assert_at_most(overall, BY_PRECISION(3e-7, 1e-15));
}

typedef void product_function(int bands, const prt_real *f, const prt_real *g, prt_real *out);
static void by_nodes(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    static prt__product_kernel *const kernels[] = { prt__product_3, prt__product_4, prt__product_5, prt__product_6 };
    kernels[bands - 3](f, g, out);
}
static void by_terms(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    static prt__product_kernel *const kernels[] = { prt__sh_product_1, prt__sh_product_2, prt__sh_product_3, prt__sh_product_4 };
    kernels[bands - 1](f, g, out);
}
static void squares_by_terms(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    static prt__square_kernel *const kernels[] = { prt__sh_square_1, prt__sh_square_2, prt__sh_square_3, prt__sh_square_4,
                                                   prt__sh_square_5 };
    assert_ptr_equal(f, g);
    kernels[bands - 1](f, out);
}

/* Which way is taken depends on the number of bands and on the width of vectors; each is right by itself. */
static void each_way_is_right(void **state) {
    static const struct { product_function *way; int first, last, square; } ways[] = {
        { by_terms, 1, 4, 0 }, { by_nodes, 3, 6, 0 }, { prt__grid_product, 1, 6, 0 }, { prt__ladder_product, 1, 16, 0 },
        { squares_by_terms, 1, 5, 1 }, { by_nodes, 3, 6, 1 }, { prt__grid_product, 1, 6, 1 },
        { prt__ladder_product, 1, 16, 1 }
    };
    static prt_real f[COUNT], g[COUNT], got[COUNT];
    static double want[COUNT];
    size_t w;
    int n;
    (void)state;
    for (w = 0; w < sizeof ways / sizeof ways[0]; w++)
        for (n = ways[w].first; n <= ways[w].last; n++) {
            const prt_real *other = ways[w].square ? f : g;
            random_vector(n * n, f);
            random_vector(n * n, g);
            reference(n, f, other, want);
            ways[w].way(n, f, other, got);
            assert_at_most(worst(n * n, got, want), BY_PRECISION(3e-7, 1e-15) * length(n * n, f) * length(n * n, other));
        }
}

/* f Y(0,0) and the product with a constant 1 at every count of bands, tabulated grid or computed */
static void one_is_one(void **state) {
    static prt_real f[PRT_SH_COUNT(PRT_MAX_BANDS)], one[PRT_SH_COUNT(PRT_MAX_BANDS)], got[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int n, i;
    (void)state;
    one[0] = PRT__R(3.5449077018110320546);
    for (n = 1; n <= PRT_MAX_BANDS; n++) {
        double most = 0;
        random_vector(n * n, f);
        prt_sh_product(n, f, one, got);
        for (i = 0; i < n * n; i++) if (!(fabs((double)(got[i] - f[i])) <= most)) most = fabs((double)(got[i] - f[i]));
        assert_at_most(most, BY_PRECISION(2e-7, 5e-16) * n * sqrt((double)n) * length(n * n, f) / n);
    }
}

/* Integral of three functions is symmetric in them: <f g, h> = <f h, g> at high bands. */
static void triple_integrals_are_symmetric(void **state) {
    static prt_real f[PRT_SH_COUNT(PRT_MAX_BANDS)], g[PRT_SH_COUNT(PRT_MAX_BANDS)], h[PRT_SH_COUNT(PRT_MAX_BANDS)],
                    fg[PRT_SH_COUNT(PRT_MAX_BANDS)], fh[PRT_SH_COUNT(PRT_MAX_BANDS)];
    static const int bands[] = { 17, 20, 33, 64 };
    size_t t;
    (void)state;
    for (t = 0; t < 4; t++) {
        int n = bands[t], i;
        double a = 0, b = 0;
        random_vector(n * n, f);
        random_vector(n * n, g);
        random_vector(n * n, h);
        prt_sh_product(n, f, g, fg);
        prt_sh_product(n, f, h, fh);
        for (i = 0; i < n * n; i++) {
            a += (double)fg[i] * (double)h[i];
            b += (double)fh[i] * (double)g[i];
        }
        assert_near(a, b, BY_PRECISION(1e-6, 3e-15) * length(n * n, f) * length(n * n, g) * length(n * n, h));
    }
}

/* At high bands: a product of low-band functions does not overflow the bands, so it holds point by point. */
static void products_hold_pointwise(void **state) {
    static prt_real f[PRT_SH_COUNT(PRT_MAX_BANDS)], g[PRT_SH_COUNT(PRT_MAX_BANDS)], fg[PRT_SH_COUNT(PRT_MAX_BANDS)];
    static const int bands[] = { 5, 9, 15, 17, 31, 47, 63 };
    size_t t;
    int k;
    (void)state;
    for (t = 0; t < sizeof bands / sizeof bands[0]; t++) {
        int n = bands[t], low = (n + 1) / 2;
        memset(f, 0, sizeof f);
        memset(g, 0, sizeof g);
        random_vector(low * low, f);
        random_vector(low * low, g);
        prt_sh_product(n, f, g, fg);
        for (k = 0; k < 50; k++) {
            double z = 2 * (k + 0.5) / 50 - 1, phi = 2.4 * k, r = sqrt(1 - z * z);
            prt_vec3 d;
            d.x = (prt_real)(r * cos(phi));
            d.y = (prt_real)(r * sin(phi));
            d.z = (prt_real)z;
            assert_near(prt_sh_at(n, fg, d), prt_sh_at(n, f, d) * prt_sh_at(n, g, d),
                        BY_PRECISION(2e-6, 5e-15) * n * n * length(n * n, f) * length(n * n, g));
        }
    }
}

static void squares_are_products(void **state) {
    static prt_real f[COUNT], got[COUNT], product[COUNT];
    int n, i;
    (void)state;
    for (n = 1; n <= MOST; n++) {
        random_vector(n * n, f);
        assert_int_equal(prt_sh_square(n, f, got), PRT_OK);
        prt_sh_product(n, f, f, product);
        for (i = 0; i < n * n; i++)
            assert_near(got[i], product[i], BY_PRECISION(4e-7, 1e-15) * length(n * n, f) * length(n * n, f));
    }
}

static void out_may_alias(void **state) {
    static prt_real f[COUNT], g[COUNT], want[COUNT], in_place[COUNT];
    int n;
    (void)state;
    for (n = 1; n <= 18; n++) {
        size_t bytes = (size_t)(n * n) * sizeof(prt_real);
        random_vector(n * n, f);
        random_vector(n * n, g);
        prt_sh_product(n, f, g, want);
        memcpy(in_place, f, bytes);
        prt_sh_product(n, in_place, g, in_place);
        assert_memory_equal(in_place, want, bytes);
        memcpy(in_place, g, bytes);
        prt_sh_product(n, f, in_place, in_place);
        assert_memory_equal(in_place, want, bytes);
        prt_sh_square(n, f, want);
        memcpy(in_place, f, bytes);
        prt_sh_square(n, in_place, in_place);
        assert_memory_equal(in_place, want, bytes);
        prt_sh_mask(n, PRT_WINDOW_HANN, f, g, want);
        memcpy(in_place, f, bytes);
        prt_sh_mask(n, PRT_WINDOW_HANN, in_place, g, in_place);
        assert_memory_equal(in_place, want, bytes);
        prt_sh_product_zonal(n, f, g, want);
        memcpy(in_place, f, bytes);
        prt_sh_product_zonal(n, in_place, g, in_place);
        assert_memory_equal(in_place, want, bytes);
    }
}

/* ---- batches ---- */

enum { PAIRS = 37, STRIDE = 41 };

static void batches_are_products(void **state) {
    static prt_real f[COUNT * STRIDE], g[COUNT * STRIDE], out[COUNT * STRIDE], a[COUNT], b[COUNT], want[COUNT];
    int n, i, k;
    (void)state;
    for (n = 1; n <= 18; n++) {
        random_vector(n * n * STRIDE, f);
        random_vector(n * n * STRIDE, g);
        assert_int_equal(prt_sh_product_soa(n, PAIRS, f, g, out, STRIDE), PRT_OK);
        for (k = 0; k < PAIRS; k++) {
            for (i = 0; i < n * n; i++) {
                a[i] = f[i * STRIDE + k];
                b[i] = g[i * STRIDE + k];
            }
            prt_sh_product(n, a, b, want);
            for (i = 0; i < n * n; i++)
                assert_near(out[i * STRIDE + k], want[i],
                            BY_PRECISION(4e-7, 1e-15) * length(n * n, a) * length(n * n, b));
        }
    }
}

static void batches_do_not_depend_on_the_count(void **state) {
    static prt_real f[COUNT * STRIDE], g[COUNT * STRIDE], all[COUNT * STRIDE], part[COUNT * STRIDE];
    static const int counts[] = { 1, 2, 3, 5, 8, 15, 16, 17, 33 };
    int n, i, k;
    size_t c;
    (void)state;
    for (n = 1; n <= 17; n++) {
        random_vector(n * n * STRIDE, f);
        random_vector(n * n * STRIDE, g);
        prt_sh_product_soa(n, PAIRS, f, g, all, STRIDE);
        for (c = 0; c < sizeof counts / sizeof counts[0]; c++) {
            int first = (int)c % 5;
            for (i = 0; i < COUNT * STRIDE; i++) part[i] = 77;
            if (first + counts[c] > PAIRS) first = 0;
            prt_sh_product_soa(n, counts[c], f + first, g + first, part, STRIDE);
            for (i = 0; i < n * n; i++)
                for (k = 0; k < STRIDE; k++) {
                    prt_real want = k < counts[c] ? all[i * STRIDE + first + k] : 77;
                    assert_memory_equal(&part[i * STRIDE + k], &want, sizeof want);
                }
        }
        memcpy(part, f, sizeof part);
        prt_sh_product_soa(n, PAIRS, part, g, part, STRIDE);
        for (i = 0; i < n * n; i++) assert_memory_equal(part + i * STRIDE, all + i * STRIDE, PAIRS * sizeof(prt_real));
    }
}

/* ---- zonal factors and matrices ---- */

static void zonal_products_are_products(void **state) {
    static prt_real f[COUNT], zonal[MOST], full[COUNT], got[COUNT], want[COUNT];
    int n, l, i;
    (void)state;
    for (n = 1; n <= MOST; n++) {
        random_vector(n * n, f);
        random_vector(n, zonal);
        memset(full, 0, sizeof full);
        for (l = 0; l < n; l++) full[PRT_SH_INDEX(l, 0)] = zonal[l];
        assert_int_equal(prt_sh_product_zonal(n, f, zonal, got), PRT_OK);
        prt_sh_product(n, f, full, want);
        for (i = 0; i < n * n; i++)
            assert_near(got[i], want[i], BY_PRECISION(4e-7, 1e-15) * length(n * n, f) * length(n, zonal));
    }
}

static void matrices_multiply(void **state) {
    static prt_real filter[64], f[5 * 64], got[5 * 64], want[64], matrix[64 * 64];
    int n, i, j, k;
    (void)state;
    for (n = 1; n <= 8; n++) {
        int count = n * n;
        random_vector(count, filter);
        random_vector(5 * count, f);
        assert_int_equal(prt_sh_product_matrix(n, filter, matrix), PRT_OK);
        for (i = 0; i < count; i++)
            for (j = 0; j < i; j++)
                assert_near(matrix[i * count + j], matrix[j * count + i],
                            BY_PRECISION(1e-6, 2e-15) * length(count, filter));
        assert_int_equal(prt_sh_product_by_n(n, matrix, 5, f, got), PRT_OK);
        for (k = 0; k < 5; k++) {
            prt_sh_product(n, f + k * count, filter, want);
            for (i = 0; i < count; i++)
                assert_near(got[k * count + i], want[i],
                            BY_PRECISION(1e-6, 2e-15) * n * length(count, f + k * count) * length(count, filter));
            prt_sh_product_by(n, matrix, f + k * count, want);
            assert_memory_equal(want, got + k * count, (size_t)count * sizeof *want);
        }
    }
}

/* ---- masks ---- */

static void masks_are_windowed_products(void **state) {
    static prt_real f[COUNT], g[COUNT], wf[COUNT], wg[COUNT], want[COUNT], got[COUNT];
    int n, l, m, w;
    (void)state;
    for (n = 1; n <= 10; n++)
        for (w = PRT_WINDOW_NONE; w <= PRT_WINDOW_POSITIVE; w++) {
            int i;
            random_vector(n * n, f);
            random_vector(n * n, g);
            for (l = 0; l < n; l++)
                for (m = -l; m <= l; m++) {
                    prt_real weight = prt_window_weight((prt_window)w, l, n);
                    wf[PRT_SH_INDEX(l, m)] = weight * f[PRT_SH_INDEX(l, m)];
                    wg[PRT_SH_INDEX(l, m)] = weight * g[PRT_SH_INDEX(l, m)];
                }
            assert_int_equal(prt_sh_mask(n, (prt_window)w, f, g, got), PRT_OK);
            prt_sh_product(n, wf, wg, want);
            for (i = 0; i < n * n; i++)
                assert_near(got[i], want[i], BY_PRECISION(3e-7, 1e-15) * length(n * n, f) * length(n * n, g));
            assert_int_equal(prt_sh_mask_filter(n, (prt_window)w, f, g, got), PRT_OK);
            prt_sh_product(n, f, wg, want);
            for (i = 0; i < n * n; i++)
                assert_near(got[i], want[i], BY_PRECISION(3e-7, 1e-15) * length(n * n, f) * length(n * n, g));
        }
}

static void a_filter_of_zero_hides_everything(void **state) {
    static prt_real f[COUNT], zero[COUNT], out[COUNT];
    int n, i, w;
    (void)state;
    for (n = 1; n <= 18; n++)
        for (w = PRT_WINDOW_NONE; w <= PRT_WINDOW_POSITIVE; w++) {
            random_vector(n * n, f);
            random_vector(n * n, out);
            assert_int_equal(prt_sh_mask(n, (prt_window)w, f, zero, out), PRT_OK);
            for (i = 0; i < n * n; i++) assert_true(out[i] == 0);
        }
}

/* One band: the only triple is G(000) = 1/(2 sqrt pi); every window of width 1 is 1. */
static void one_band_is_a_scalar_product(void **state) {
    prt_real f = PRT__R(2.5), g = PRT__R(-1.5), out;
    int w;
    (void)state;
    for (w = PRT_WINDOW_NONE; w <= PRT_WINDOW_POSITIVE; w++) {
        assert_int_equal(prt_sh_mask(1, (prt_window)w, &f, &g, &out), PRT_OK);
        assert_near(out, -3.75 * 0.28209479177387814, BY_PRECISION(1e-7, 1e-15));
    }
}

static void nan_goes_in_and_comes_out(void **state) {
    static prt_real f[COUNT], g[COUNT], out[COUNT];
    int n, i, w;
    (void)state;
    for (n = 1; n <= 18; n++)
        for (w = PRT_WINDOW_NONE; w <= PRT_WINDOW_POSITIVE; w++) {
            int found = 0;
            random_vector(n * n, f);
            random_vector(n * n, g);
            g[n * n / 2] = (prt_real)NAN;
            assert_int_equal(prt_sh_mask(n, (prt_window)w, f, g, out), PRT_OK);
            for (i = 0; i < n * n; i++) found += out[i] != out[i];
            assert_true(FAST_MATH || found > 0);
            assert_true(FAST_MATH || out[n * n / 2] != out[n * n / 2]);
            prt_sh_square(n, g, out);
            assert_true(FAST_MATH || out[0] != out[0]);
        }
}

/* ---- arguments ---- */

static void bad_calls_write_nothing(void **state) {
    prt_real f[4] = { 1, 2, 3, 4 }, out[16], before[16];
    (void)state;
    random_vector(16, out);
    memcpy(before, out, sizeof out);
    assert_int_equal(prt_sh_product(0, f, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_product(PRT_MAX_BANDS + 1, f, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_product(0, NULL, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_product(2, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product(2, f, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product(2, f, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_square(-1, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_square(2, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_square(2, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_soa(0, 1, f, f, out, 1), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_product_soa(2, -1, f, f, out, 1), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_product_soa(2, 2, f, f, out, 1), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_product_soa(2, 0, NULL, NULL, NULL, 0), PRT_OK);
    assert_int_equal(prt_sh_product_soa(2, 1, NULL, f, out, 1), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_soa(2, 1, f, NULL, out, 1), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_soa(2, 1, f, f, NULL, 1), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_zonal(0, f, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_product_zonal(2, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_zonal(2, f, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_zonal(2, f, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_matrix(0, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_product_matrix(2, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_matrix(2, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_by_n(0, f, 1, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_product_by_n(2, f, -1, f, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_product_by_n(2, NULL, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_sh_product_by_n(2, NULL, 1, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_by(2, f, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_product_by(2, f, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_mask(0, PRT_WINDOW_NONE, f, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_mask(2, PRT_WINDOW_NONE, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_mask(2, (prt_window)4, f, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_mask(2, (prt_window)-1, f, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_mask(2, (prt_window)9, f, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_mask_filter(65536, PRT_WINDOW_HANN, f, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_mask_filter(2, PRT_WINDOW_HANN, f, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_mask_filter(2, (prt_window)77, f, f, out), PRT_ERR_VALUE);
    assert_memory_equal(out, before, sizeof out);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_reference_is_complete), cmocka_unit_test(products_are_the_triple_sums),
        cmocka_unit_test(each_way_is_right), cmocka_unit_test(one_is_one),
        cmocka_unit_test(triple_integrals_are_symmetric), cmocka_unit_test(products_hold_pointwise),
        cmocka_unit_test(squares_are_products), cmocka_unit_test(out_may_alias), cmocka_unit_test(batches_are_products),
        cmocka_unit_test(batches_do_not_depend_on_the_count), cmocka_unit_test(zonal_products_are_products),
        cmocka_unit_test(matrices_multiply), cmocka_unit_test(masks_are_windowed_products),
        cmocka_unit_test(a_filter_of_zero_hides_everything), cmocka_unit_test(one_band_is_a_scalar_product),
        cmocka_unit_test(nan_goes_in_and_comes_out), cmocka_unit_test(bad_calls_write_nothing)
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
