/* Products beyond the bands where powers of sqrt(1 - z^2) underflow in float (180): the scaled columns of the grid. */
#define PRT_MAX_BANDS 192
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"

enum { BANDS = PRT_MAX_BANDS, LOW = BANDS / 2, N = PRT_SH_COUNT(BANDS) };

static prt_real f[N], g[N], fg[N];

static double length(const prt_real *v) {
    double sum = 0;
    int i;
    for (i = 0; i < N; i++) sum += (double)v[i] * (double)v[i];
    return sqrt(sum);
}

/* Factors of half the bands: nothing is cut off, so the product holds point by point; at the poles too. */
static void products_hold_pointwise(void **state) {
    int i, k;
    (void)state;
    assert_true((int)BANDS > (int)PRT__SH_UNSCALED_V || sizeof(prt_real) == 8);
    memset(f, 0, sizeof f);
    memset(g, 0, sizeof g);
    for (i = 0; i < PRT_SH_COUNT(LOW); i++) {
        f[i] = (prt_real)signed_uniform() / (prt_real)LOW;
        g[i] = (prt_real)signed_uniform() / (prt_real)LOW;
    }
    assert_int_equal(prt_sh_product(BANDS, f, g, fg), PRT_OK);
    for (k = 0; k < 40; k++) {
        double z = k < 2 ? 1 - 2 * k : 2 * (k + 0.5) / 40 - 1, phi = 2.4 * k, r = sqrt(1 - z * z), scale;
        prt_vec3 d = prt__vec3((prt_real)(r * cos(phi)), (prt_real)(r * sin(phi)), (prt_real)z);
        double a = (double)prt_sh_at(BANDS, f, d), b = (double)prt_sh_at(BANDS, g, d);
        scale = BANDS / sqrt(4 * PRT__PI);                         /* |f(d)| <= |f| n/sqrt(4 pi) */
        assert_near(prt_sh_at(BANDS, fg, d), a * b, BY_PRECISION(5e-7, 2e-15) * length(f) * length(g) * scale * scale);
    }
}

/* Full bands: the constant 1 leaves f as it is, and <f g, h> is symmetric. */
static void full_bands_are_kept(void **state) {
    static prt_real gf[N];
    double most = 0, a = 0, b = 0;
    int i;
    (void)state;
    for (i = 0; i < N; i++) f[i] = (prt_real)signed_uniform() / (prt_real)BANDS;
    memset(g, 0, sizeof g);
    g[0] = PRT__R(3.5449077018110320546);
    prt_sh_product(BANDS, f, g, fg);
    for (i = 0; i < N; i++) {
        double off = fabs((double)(fg[i] - f[i]));
        if (!(off <= most)) most = off;
    }
    print_message("times 1 at %d bands: largest error %.2g of the norm\n", BANDS, most / length(f));
    assert_at_most(most, BY_PRECISION(2e-7, 5e-16) * sqrt((double)BANDS) * length(f));     /* as in test_product.c */
    g[0] = 0;
    for (i = 1; i < 400; i++) g[i] = (prt_real)signed_uniform();
    prt_sh_product(BANDS, f, g, fg);
    for (i = 0; i < N; i++) gf[i] = (prt_real)signed_uniform();
    for (i = 0; i < N; i++) a += (double)fg[i] * (double)gf[i];
    prt_sh_product(BANDS, gf, g, fg);
    for (i = 0; i < N; i++) b += (double)fg[i] * (double)f[i];
    assert_near(a, b, BY_PRECISION(1e-6, 3e-15) * length(f) * length(g) * length(gf));
}

int main(void) {
    const struct CMUnitTest tests[] = { cmocka_unit_test(products_hold_pointwise), cmocka_unit_test(full_bands_are_kept) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
