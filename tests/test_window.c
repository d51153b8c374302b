/* Windows against their definitions in long double; the positive one in MPFR, by quadrature of its kernel. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include <limits.h>
#include <mpfr.h>

#define PI_L 3.14159265358979323846264338327950288L
enum { MOST = 64 };

static long double legendre(int l, long double z) {
    long double p = 1, p1 = 0;
    int k;
    for (k = 1; k <= l; k++) { long double p2 = p1; p1 = p; p = ((2 * k - 1) * z * p1 - (k - 1) * p2) / k; }
    return p;
}

/* The positive window in 256 bits: the header's kernel at the nodes of a 96-point Gauss-Legendre quadrature, exact to
   degree 191. */
enum { NODES = 96 };
typedef struct { mpfr_t node[NODES], share[NODES], p[NODES][MOST + 2]; } quadrature;

/* P_0 ... P_last at z. */
static void legendre_row(mpfr_t *p, int last, mpfr_t z) {
    mpfr_t t;
    int k;
    mpfr_init(t);
    mpfr_set_ui(p[0], 1, MPFR_RNDN);
    mpfr_set(p[1], z, MPFR_RNDN);
    for (k = 2; k <= last; k++) {
        mpfr_mul(p[k], z, p[k - 1], MPFR_RNDN);
        mpfr_mul_si(p[k], p[k], 2 * k - 1, MPFR_RNDN);
        mpfr_mul_si(t, p[k - 2], k - 1, MPFR_RNDN);
        mpfr_sub(p[k], p[k], t, MPFR_RNDN);
        mpfr_div_si(p[k], p[k], k, MPFR_RNDN);
    }
    mpfr_clear(t);
}

/* P_n, or P_n + P_n+1 = (1+z) P^(0,1)_n for the kernels of odd degree. */
static void node_polynomial(mpfr_t value, int n, int odd, mpfr_t z) {
    mpfr_t p[NODES + 2];
    int k;
    for (k = 0; k < NODES + 2; k++) mpfr_init(p[k]);
    legendre_row(p, n + 1, z);
    if (odd) mpfr_add(value, p[n], p[n + 1], MPFR_RNDN);
    else mpfr_set(value, p[n], MPFR_RNDN);
    for (k = 0; k < NODES + 2; k++) mpfr_clear(p[k]);
}

/* The root between low and high, where the polynomial changes sign, by bisection. */
static void bisect(mpfr_t root, int n, int odd, mpfr_t low, mpfr_t high) {
    mpfr_t value;
    int i, rising;
    mpfr_init(value);
    node_polynomial(value, n, odd, high);
    rising = mpfr_sgn(value) > 0;
    for (i = 0; i < 240; i++) {
        mpfr_add(root, low, high, MPFR_RNDN);
        mpfr_div_ui(root, root, 2, MPFR_RNDN);
        node_polynomial(value, n, odd, root);
        if ((mpfr_sgn(value) > 0) == rising) mpfr_set(high, root, MPFR_RNDN);
        else mpfr_set(low, root, MPFR_RNDN);
    }
    mpfr_clear(value);
}

/* The i-th root from above: roots lie near cos((i+3/4) pi/N), N = n+1/2 for P_n and n+1 for P_n + P_n+1. */
static void polynomial_root(mpfr_t root, int n, int odd, int i) {
    mpfr_t low, high;
    double scale = PRT__PI / (odd ? n + 1 : n + 0.5);
    mpfr_inits(low, high, (mpfr_ptr)0);
    mpfr_set_d(low, cos((i + 1.15) * scale), MPFR_RNDN);
    mpfr_set_d(high, cos((i + 0.35) * scale), MPFR_RNDN);
    bisect(root, n, odd, low, high);
    mpfr_clears(low, high, (mpfr_ptr)0);
}

static void make_quadrature(quadrature *q) {
    mpfr_t p[NODES + 2], slope, t;
    int i, k;
    mpfr_inits(slope, t, (mpfr_ptr)0);
    for (k = 0; k < NODES + 2; k++) mpfr_init(p[k]);
    for (i = 0; i < NODES; i++) {
        mpfr_inits(q->node[i], q->share[i], (mpfr_ptr)0);
        for (k = 0; k < MOST + 2; k++) mpfr_init(q->p[i][k]);
        polynomial_root(q->node[i], NODES, 0, i);
        legendre_row(p, NODES, q->node[i]);
        legendre_row(q->p[i], MOST + 1, q->node[i]);
        mpfr_mul_ui(slope, p[NODES - 1], NODES, MPFR_RNDN);            /* (1-z^2) dP/dz at a root */
        mpfr_sqr(slope, slope, MPFR_RNDN);
        mpfr_sqr(t, q->node[i], MPFR_RNDN);
        mpfr_ui_sub(t, 1, t, MPFR_RNDN);
        mpfr_mul_ui(t, t, 2, MPFR_RNDN);
        mpfr_div(q->share[i], t, slope, MPFR_RNDN);
    }
    for (k = 0; k < NODES + 2; k++) mpfr_clear(p[k]);
    mpfr_clears(slope, t, (mpfr_ptr)0);
}

static void free_quadrature(quadrature *q) {
    int i, k;
    for (i = 0; i < NODES; i++) {
        mpfr_clears(q->node[i], q->share[i], (mpfr_ptr)0);
        for (k = 0; k < MOST + 2; k++) mpfr_clear(q->p[i][k]);
    }
    mpfr_free_cache();
}

static void slow_positive(const quadrature *q, int width, double *weight) {
    int n = (width - 1) / 2 + 1, odd = (width - 1) % 2, i, l;
    mpfr_t root, value, t, sum[MOST];
    mpfr_inits(root, value, t, (mpfr_ptr)0);
    polynomial_root(root, n, odd, 0);
    for (l = 0; l < width; l++) { mpfr_init(sum[l]); mpfr_set_ui(sum[l], 0, MPFR_RNDN); }
    for (i = 0; i < NODES; i++) {
        mpfr_set(value, q->p[i][n], MPFR_RNDN);
        if (odd) mpfr_add(value, value, q->p[i][n + 1], MPFR_RNDN);
        mpfr_sub(t, q->node[i], root, MPFR_RNDN);
        mpfr_div(value, value, t, MPFR_RNDN);
        mpfr_sqr(value, value, MPFR_RNDN);
        mpfr_add_ui(t, q->node[i], 1, MPFR_RNDN);
        if (odd) mpfr_div(value, value, t, MPFR_RNDN);
        mpfr_mul(value, value, q->share[i], MPFR_RNDN);
        for (l = 0; l < width; l++) {
            mpfr_mul(t, value, q->p[i][l], MPFR_RNDN);
            mpfr_add(sum[l], sum[l], t, MPFR_RNDN);
        }
    }
    for (l = width - 1; l >= 0; l--) {
        mpfr_div(t, sum[l], sum[0], MPFR_RNDN);
        weight[l] = mpfr_get_d(t, MPFR_RNDN);
        mpfr_clear(sum[l]);
    }
    mpfr_clears(root, value, t, (mpfr_ptr)0);
}

static void positive_weights_of_the_literature(void **state) {
    static const double known[][9] = { { 3, 1, .57735, .2 }, { 4, 1, .68990, .34495, .09358 },
        { 5, 1, .77460, .48571, .22131, .06349 }, { 6, 1, .82282, .57611, .32616, .14039, .03568 },
        { 8, 1, .88579, .70925, .50478, .31543, .16509, .06699, .01660 } };
    size_t k;
    int l;
    (void)state;
    for (k = 0; k < sizeof known / sizeof *known; k++)
        for (l = 0; l < (int)known[k][0]; l++)
            assert_near(prt_window_weight(PRT_WINDOW_POSITIVE, l, (int)known[k][0]), known[k][1 + l], 6e-6);
    assert_near(prt_window_weight(PRT_WINDOW_POSITIVE, 0, 1), 1, 0);
    assert_near(prt_window_weight(PRT_WINDOW_POSITIVE, 1, 2), 1.0 / 3, PRT__EPS);
    assert_near(prt_window_weight(PRT_WINDOW_POSITIVE, 1, 3), sqrt(1.0 / 3), PRT__EPS);
    assert_near(prt_window_weight(PRT_WINDOW_POSITIVE, 1, 5), sqrt(0.6), PRT__EPS);
}

/* Relative to each weight, the smallest included. */
static void positive_weights_of_every_width(void **state) {
    static quadrature q;
    double worst = 0;
    int width, l;
    (void)state;
    mpfr_set_default_prec(256);
    make_quadrature(&q);
    for (width = 1; width <= MOST; width++) {
        double want[MOST], got[MOST];
        slow_positive(&q, width, want);
        prt__positive_weights(width, width, got);
        for (l = 0; l < width; l++) {
            double error = fabs(got[l] / want[l] - 1);
            if (!(error / width <= worst)) worst = error / width;
            assert_near((double)prt_window_weight(PRT_WINDOW_POSITIVE, l, width) / want[l], 1,       /* a table, then not */
                        width <= PRT__WINDOW_TABLES ? 0.51 * PRT__EPS : PRT__EPS + 3e-16 * width);
        }
    }
    free_quadrature(&q);
    print_message("positive weights: largest relative error over width %.2g, to width %d\n", worst, MOST);
    assert_at_most(worst, 3e-16);
}

static void positive_kernels_are_positive(void **state) {
    int width, i, l;
    (void)state;
    for (width = 1; width <= MOST; width++) {
        double weight[MOST], lowest = 0;
        prt__positive_weights(width, width, weight);
        for (i = 0; i <= 4000; i++) {
            long double z = cosl(PI_L * i / 4000), sum = 0;
            for (l = 0; l < width; l++) sum += (2 * l + 1) * (long double)weight[l] * legendre(l, z);
            if ((double)sum < lowest) lowest = (double)sum;
        }
        assert_at_most(-lowest, 1e-16 * width * width);                /* the peak is about width^2/2 */
    }
}

/* What the window promises: a hemisphere, cut at any number of bands, stays between 0 and 1. */
static void positive_window_keeps_the_range(void **state) {
    prt_vec3 z = { 0, 0, 1 };
    int bands, i;
    (void)state;
    for (bands = 1; bands <= 16; bands++) {
        prt_real f[256];
        assert_int_equal(prt_sh_hemisphere(bands, z, 1, 0, f), PRT_OK);
        assert_int_equal(prt_sh_window(bands, PRT_WINDOW_POSITIVE, bands, f, f), PRT_OK);
        for (i = 0; i <= 2000; i++) {
            double theta = PRT__PI * i / 2000, value;
            prt_vec3 d;
            d.x = (prt_real)sin(theta); d.y = 0; d.z = (prt_real)cos(theta);
            value = (double)prt_sh_at(bands, f, d);
            assert_at_most(fabs(value - 0.5), 0.5 + 64 * (double)PRT__EPS);
        }
    }
}

static void hann_and_lanczos_to_the_last_band(void **state) {
    int width, l;
    (void)state;
    for (width = 1; width <= 100; width++)
        for (l = 0; l < width; l++) {
            long double x = PI_L * l / width, hann = (1 + cosl(x)) / 2, lanczos = l ? sinl(x) / x : 1;
            assert_near((double)prt_window_weight(PRT_WINDOW_HANN, l, width) / (double)hann, 1, 4 * PRT__EPS);
            assert_near((double)prt_window_weight(PRT_WINDOW_LANCZOS, l, width) / (double)lanczos, 1, 4 * PRT__EPS);
            assert_near(prt_window_weight(PRT_WINDOW_NONE, l, width), 1, 0);
        }
    assert_near(prt_window_weight(PRT_WINDOW_HANN, 1, 2), 0.5, PRT__EPS);
    assert_near(prt_window_weight(PRT_WINDOW_HANN, 2, 3), 0.25, PRT__EPS);
    assert_near(prt_window_weight(PRT_WINDOW_HANN, INT_MAX - 1, INT_MAX), 0, 1e-15);
    assert_near(prt_window_weight(PRT_WINDOW_LANCZOS, INT_MAX - 1, INT_MAX), 0, 1e-8);
}

static void weights_outside_are_zero(void **state) {
    int w;
    (void)state;
    for (w = 0; w <= PRT_WINDOW_POSITIVE; w++) {
        assert_near(prt_window_weight((prt_window)w, -1, 4), 0, 0);
        assert_near(prt_window_weight((prt_window)w, 4, 4), 0, 0);
        assert_near(prt_window_weight((prt_window)w, INT_MAX, 4), 0, 0);
        assert_near(prt_window_weight((prt_window)w, 0, 0), 0, 0);
        assert_near(prt_window_weight((prt_window)w, 0, -3), 0, 0);
        assert_near(prt_window_weight((prt_window)w, INT_MIN, INT_MIN), 0, 0);
        assert_near(prt_window_weight((prt_window)w, 0, 1), 1, 0);
    }
    assert_near(prt_window_weight((prt_window)(PRT_WINDOW_POSITIVE + 1), 0, 4), 0, 0);
    assert_near(prt_window_weight(PRT_WINDOW_POSITIVE, 0, PRT_MAX_BANDS), 1, 0);
    assert_near(prt_window_weight(PRT_WINDOW_POSITIVE, 0, PRT_MAX_BANDS + 1), 0, 0);
}

static void windows_act_on_bands(void **state) {
    prt_real f[64], out[64];
    int w, width, i, l;
    (void)state;
    for (i = 0; i < 64; i++) f[i] = (prt_real)(i % 7 - 3);
    for (w = 0; w <= PRT_WINDOW_POSITIVE; w++)
        for (width = 1; width <= 12; width++) {
            prt_real in_place[64];
            assert_int_equal(prt_sh_window(8, (prt_window)w, width, f, out), PRT_OK);
            for (l = 0; l < 8; l++)
                for (i = l * l; i < (l + 1) * (l + 1); i++)
                    assert_near(out[i], (double)(f[i] * prt_window_weight((prt_window)w, l, width)), 6 * PRT__EPS);
            memcpy(in_place, f, sizeof f);
            assert_int_equal(prt_sh_window(8, (prt_window)w, width, in_place, in_place), PRT_OK);
            assert_memory_equal(in_place, out, sizeof out);
        }
}

static void bad_arguments_write_nothing(void **state) {
    prt_real f[4] = { 1, 2, 3, 4 }, out[4] = { 5, 6, 7, 8 };
    (void)state;
    assert_int_equal(prt_sh_window(0, PRT_WINDOW_HANN, 2, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_window(PRT_MAX_BANDS + 1, PRT_WINDOW_HANN, 2, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_window(2, PRT_WINDOW_HANN, 0, f, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_window(2, PRT_WINDOW_HANN, -1, f, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_window(2, PRT_WINDOW_POSITIVE, PRT_MAX_BANDS + 1, f, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_window(2, PRT_WINDOW_HANN, 2, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_window(2, PRT_WINDOW_HANN, 2, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_window(2, (prt_window)(PRT_WINDOW_POSITIVE + 1), 2, f, out), PRT_ERR_VALUE);
    assert_near(out[0], 5, 0); assert_near(out[1], 6, 0); assert_near(out[2], 7, 0); assert_near(out[3], 8, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(positive_weights_of_the_literature), cmocka_unit_test(positive_weights_of_every_width),
        cmocka_unit_test(positive_kernels_are_positive), cmocka_unit_test(positive_window_keeps_the_range),
        cmocka_unit_test(hann_and_lanczos_to_the_last_band), cmocka_unit_test(weights_outside_are_zero),
        cmocka_unit_test(windows_act_on_bands), cmocka_unit_test(bad_arguments_write_nothing) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
