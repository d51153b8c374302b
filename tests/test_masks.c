/* How chains of masks behave. The spectral radii of each variant for one hemisphere are computed here from
   prt_sh_triple and windows written out, in double, and must be those that the library's masks show; then chains of 1
   to 64 masks by identical, nearly aligned and random hemispheres: which variants can grow, which fade, which hold. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"

enum { LEAST = 2, MOST = 8, SIZE = MOST * MOST, CHAIN = 64, STEPS = 12000 };

typedef struct variant { const char *name; prt_window window; int both; } variant;
static const variant plain = { "no window", PRT_WINDOW_NONE, 1 }, hann_both = { "Hann on both", PRT_WINDOW_HANN, 1 },
                     lanczos_both = { "Lanczos on both", PRT_WINDOW_LANCZOS, 1 },
                     positive_both = { "positive on both", PRT_WINDOW_POSITIVE, 1 },
                     hann_filter = { "Hann on the filter", PRT_WINDOW_HANN, 0 },
                     lanczos_filter = { "Lanczos on the filter", PRT_WINDOW_LANCZOS, 0 },
                     positive_filter = { "positive on the filter", PRT_WINDOW_POSITIVE, 0 };

static double length(int n, const prt_real *f) {
    double sum = 0;
    while (n--) sum += (double)f[n] * (double)f[n];
    return sqrt(sum);
}

static void random_light(int n, prt_real *f) {
    double size;
    int i;
    for (i = 0; i < n; i++) f[i] = (prt_real)(uniform() + uniform() + uniform() - 1.5);
    size = length(n, f);
    for (i = 0; i < n; i++) f[i] = (prt_real)((double)f[i] / size);
}

static void mask(const variant *v, int bands, const prt_real *filter, prt_real *light) {
    prt_result r = v->both ? prt_sh_mask(bands, v->window, light, filter, light)
                           : prt_sh_mask_filter(bands, v->window, light, filter, light);
    assert_int_equal(r, PRT_OK);
}

/* ---- spectral radii by another route ---- */

/* 2 pi int_0^1 P_l(z) dz sqrt((2l+1)/4pi): a hemisphere about +z, by the sum of monomials' integrals */
static double hemisphere(int l) {
    double sum = 0, coefficient;
    int k;
    for (k = 0; 2 * k <= l; k++) {
        int i;
        coefficient = k % 2 ? -1 : 1;
        for (i = 1; i <= l; i++) coefficient /= 2;
        for (i = 1; i <= k; i++) coefficient *= (double)(l - i + 1) / i;                     /* binomial (l,k) */
        for (i = 1; i <= l; i++) coefficient *= (double)(2 * l - 2 * k - i + 1) / i;           /* binomial (2l-2k,l) */
        sum += coefficient / (l - 2 * k + 1);
    }
    return 2 * PRT__PI * sum * sqrt((2 * l + 1) / (4 * PRT__PI));
}

/* the weights, from their formulas; those of the positive window from its table to the five digits that it is known
   by */
static double weight(prt_window w, int l, int bands) {
    static const double positive[][8] = {
        { 1, .33333 }, { 1, .57735, .2 }, { 1, .68990, .34495, .09358 }, { 1, .77460, .48571, .22131, .06349 },
        { 1, .82282, .57611, .32616, .14039, .03568 }, { NAN }, { 1, .88579, .70925, .50478, .31543, .16509, .06699, .01660 }
    };
    double x = PRT__PI * l / bands;
    switch (w) {
    case PRT_WINDOW_HANN: return (1 + cos(x)) / 2;
    case PRT_WINDOW_LANCZOS: return l ? sin(x) / x : 1;
    case PRT_WINDOW_POSITIVE: return positive[bands - LEAST][l];
    case PRT_WINDOW_NONE: default: return 1;
    }
}

/* Largest eigenvalue of W^(1/2) M W^(1/2), or of M, M the matrix of the windowed hemisphere; m by m, as it is zonal */
static double radius(const variant *v, int bands) {
    double largest = 0;
    int m, l, k, j, step;
    for (m = 0; m < bands; m++) {
        double a[MOST][MOST], x[MOST], y[MOST], growth = 0;
        for (l = m; l < bands; l++)
            for (k = m; k < bands; k++) {
                a[l][k] = 0;
                for (j = abs(l - k); j < bands; j++)
                    a[l][k] += prt_sh_triple(l, m, k, m, j, 0) * hemisphere(j) * weight(v->window, j, bands);
                if (v->both) a[l][k] *= sqrt(weight(v->window, l, bands) * weight(v->window, k, bands));
            }
        for (l = m; l < bands; l++) x[l] = 1 + 0.37 * l;
        for (step = 0; step < STEPS; step++) {
            double size = 0;
            for (l = m; l < bands; l++) {
                y[l] = 0;
                for (k = m; k < bands; k++) y[l] += a[l][k] * x[k];
            }
            for (l = m; l < bands; l++) size += y[l] * y[l];
            size = sqrt(size);
            for (l = m; l < bands; l++) x[l] = y[l] / size;
            growth = size;
        }
        if (!(growth <= largest)) largest = growth;
    }
    return largest;
}

/* growth per mask of a long chain through the library */
static double growth(const variant *v, int bands) {
    prt_real light[SIZE], filter[SIZE];
    prt_vec3 up = { 0, 0, 1 };
    int n = bands * bands, i, k;
    double sum = 0;
    prt_sh_hemisphere(bands, up, 1, 0, filter);
    random_light(n, light);
    for (k = 0; k < STEPS; k++) {
        double size;
        mask(v, bands, filter, light);
        size = length(n, light);
        for (i = 0; i < n; i++) light[i] = (prt_real)((double)light[i] / size);
        if (k >= STEPS - 500) sum += log(size) / 500;
    }
    return exp(sum);
}

static void radii_are_those_of_the_matrices(void **state) {
    static const double published_plain[] = { .933, 1.081, 1.030, 1.043, 1.055, 1.061, 1.036 };
    static const double published_hann[] = { .573, .736, .840, .897, .929, .949, .961 };
    const variant *all[] = { &plain, &hann_both, &lanczos_both, &hann_filter, &lanczos_filter };
    int n;
    size_t i;
    (void)state;
    for (n = LEAST; n <= MOST; n++) {
        assert_near(radius(&plain, n), published_plain[n - LEAST], 5.1e-4);
        assert_near(radius(&hann_both, n), published_hann[n - LEAST], 5.1e-4);
        for (i = 0; i < sizeof all / sizeof all[0]; i++)
            assert_near(growth(all[i], n), radius(all[i], n), 2e-5);
        if (n != 7) {
            assert_near(growth(&positive_filter, n), radius(&positive_filter, n), 3e-5);
            assert_near(growth(&positive_both, n), radius(&positive_both, n), 3e-5);
        }
    }
}

static void which_radii_exceed_one(void **state) {
    int n;
    (void)state;
    for (n = LEAST; n <= MOST; n++) {
        assert_true(growth(&hann_both, n) < 1);
        assert_true(growth(&lanczos_both, n) < 1);
        assert_true(growth(&positive_both, n) < 1);
        assert_true(growth(&positive_filter, n) < 1);
        assert_true((growth(&plain, n) > 1) == (n >= 3));
        assert_true((growth(&hann_filter, n) > 1) == (n >= 4));
        assert_true((growth(&lanczos_filter, n) > 1) == (n >= 4));
    }
}

/* ---- chains ---- */

enum { IDENTICAL, ALIGNED, RANDOM, OPEN };
static void make_filter(int kind, int bands, prt_real *filter) {
    double z = 1, phi = 2 * PRT__PI * uniform(), r;
    prt_vec3 up;
    if (kind == ALIGNED) z = cos(5 * PRT__PI / 180 * uniform());
    if (kind == RANDOM) z = 2 * uniform() - 1;
    r = sqrt(1 - z * z);
    up.x = (prt_real)(r * cos(phi));
    up.y = (prt_real)(r * sin(phi));
    up.z = (prt_real)z;
    prt_sh_hemisphere(bands, up, 1, kind == OPEN ? 1 : 0, filter);
}

/* largest norm on the way, from lights of norm 1; *last: the norm at the end, the least over the lights */
static double chain(const variant *v, int kind, int bands, double *last) {
    prt_real light[SIZE], filter[SIZE];
    double most = 0;
    int trial, k;
    *last = 1e300;
    for (trial = 0; trial < 20; trial++) {
        double size = 1;
        random_light(bands * bands, light);
        for (k = 0; k < CHAIN; k++) {
            make_filter(kind, bands, filter);
            mask(v, bands, filter, light);
            size = length(bands * bands, light);
            if (!(size <= most)) most = size;
        }
        if (size < *last) *last = size;
    }
    return most;
}

/* The positive window on the filter alone: no mask of any family makes any light grow. */
static void positive_filters_never_grow(void **state) {
    int kind, n;
    double last;
    (void)state;
    for (kind = IDENTICAL; kind <= OPEN; kind++)
        for (n = LEAST; n <= MOST; n++) {
            assert_at_most(chain(&positive_filter, kind, n, &last), 1 + BY_PRECISION(2e-5, 1e-13));
            assert_at_most(chain(&positive_both, kind, n, &last), 1 + BY_PRECISION(2e-5, 1e-13));
        }
}

static void windows_on_both_never_grow_but_fade(void **state) {
    const variant *both[] = { &hann_both, &lanczos_both, &positive_both };
    int kind, n, i;
    double last;
    (void)state;
    for (kind = IDENTICAL; kind <= OPEN; kind++)
        for (n = LEAST; n <= MOST; n++) {
            assert_at_most(chain(&hann_both, kind, n, &last), 1 + BY_PRECISION(2e-5, 1e-13));
            assert_at_most(chain(&lanczos_both, kind, n, &last), 1 + BY_PRECISION(2e-5, 1e-13));
        }
    for (n = LEAST; n <= MOST; n++)                    /* filters of 1 lose what light has beside its mean */
        for (i = 0; i < 3; i++) {
            chain(both[i], OPEN, n, &last);
            assert_true(last < 0.6);
        }
}

/* Without a window on the light, filters of 1 leave it as it is. */
static void windows_on_filters_hold(void **state) {
    const variant *filter_only[] = { &plain, &hann_filter, &lanczos_filter, &positive_filter };
    double last;
    int n, i;
    (void)state;
    for (n = LEAST; n <= MOST; n++)
        for (i = 0; i < 4; i++) {
            chain(filter_only[i], OPEN, n, &last);
            assert_near(last, 1, BY_PRECISION(2e-5, 1e-12));
        }
}

static void others_can_grow(void **state) {
    double last;
    int n;
    (void)state;
    assert_true(chain(&plain, IDENTICAL, 3, &last) > 60);          /* 1.081^64 = 146, times the light's part in it */
    assert_true(chain(&plain, ALIGNED, 3, &last) > 40);
    assert_true(chain(&hann_filter, IDENTICAL, 5, &last) > 1.5);
    assert_true(chain(&hann_filter, ALIGNED, 5, &last) > 1.2);
    assert_true(chain(&lanczos_filter, IDENTICAL, 4, &last) > 1.5);
    assert_true(chain(&lanczos_filter, ALIGNED, 4, &last) > 1.2);
    for (n = LEAST; n <= MOST; n++) {
        assert_true(chain(&plain, RANDOM, n, &last) < 5);
        assert_true(chain(&hann_filter, RANDOM, n, &last) < 5);
        assert_true(chain(&lanczos_filter, RANDOM, n, &last) < 5);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(radii_are_those_of_the_matrices), cmocka_unit_test(which_radii_exceed_one),
        cmocka_unit_test(positive_filters_never_grow), cmocka_unit_test(windows_on_both_never_grow_but_fade),
        cmocka_unit_test(windows_on_filters_hold), cmocka_unit_test(others_can_grow)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
