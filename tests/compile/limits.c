/* Built by link.sh with PRT_MAX_BANDS overridden: the limit is where it was put, and whatever has kernels for numbers
   of bands, some of which are then left out, works right up to it. */
#define PRT_IMPLEMENTATION
#ifdef PRT_STATIC                                        /* what is not called is not compiled */
#  define PRT_BAKE_IMPLEMENTATION
#  include "prt_bake.h"
#else
#  include "prt.h"
#endif
#include <stdio.h>

enum { MOST = PRT_MAX_BANDS < 11 ? PRT_MAX_BANDS : 11, N = MOST * MOST, COUNT = 20 };

static prt_real y[PRT_SH_COUNT(PRT_MAX_BANDS + 1)];
static prt_real f[3 * COUNT * N], a[3 * COUNT * N], b[3 * COUNT * N], blocks[(MOST * (4 * MOST * MOST - 1)) / 3];
static prt_real xs[COUNT], ys[COUNT], zs[COUNT];
static prt_vec3 dirs[COUNT];
static int bad;

static void fail(const char *what, int bands) { bad = 1; printf("%s, %d bands\n", what, bands); }

/* p and q are the same but for rounding; their numbers are about 1 */
static void expect(const char *what, int bands, int count, const prt_real *p, const prt_real *q) {
    int i;
    for (i = 0; i < count; i++)
        if (!(p[i] - q[i] <= PRT__R(2e-4) && q[i] - p[i] <= PRT__R(2e-4))) { fail(what, bands); return; }
}

/* out[k][n] from in[n][COUNT] */
static void rows_of(int n, const prt_real *in, prt_real *out) {
    int k, i;
    for (k = 0; k < COUNT; k++) for (i = 0; i < n; i++) out[k * n + i] = in[i * COUNT + k];
}

static void check_evaluation(int bands, int n) {
    int k;
    for (k = 0; k < COUNT; k++) {
        prt_real at;
        if (prt_sh_eval(bands, dirs[k], a + k * n) != PRT_OK) fail("prt_sh_eval", bands);
        at = prt_sh_at(bands, f, dirs[k]);
        b[0] = prt_sh_dot(bands, f, a + k * n);
        expect("prt_sh_at", bands, 1, &at, b);
    }
    prt_sh_eval_n(bands, COUNT, dirs, b);
    expect("prt_sh_eval_n", bands, COUNT * n, a, b);
    prt_sh_eval_soa(bands, COUNT, xs, ys, zs, b, COUNT);
    rows_of(n, b, b + COUNT * N);
    expect("prt_sh_eval_soa", bands, COUNT * n, a, b + COUNT * N);
}

static void check_rotation(int bands, int n) {
    static const prt_real turn[9] = { PRT__R(0.36), PRT__R(0.48), PRT__R(-0.8), PRT__R(-0.8), PRT__R(0.6), 0,
                                      PRT__R(0.48), PRT__R(0.64), PRT__R(0.6) };
    int k, i;
    for (k = 0; k < COUNT; k++)
        if (prt_sh_rotate(bands, turn, f + k * n, a + k * n) != PRT_OK) fail("prt_sh_rotate", bands);
    prt_sh_rotation(bands, turn, blocks);
    prt_sh_rotate_by(bands, blocks, f, b);
    expect("prt_sh_rotate_by", bands, n, a, b);
    prt_sh_rotate_by_n(bands, blocks, COUNT, f, b);
    expect("prt_sh_rotate_by_n", bands, COUNT * n, a, b);
    for (k = 0; k < COUNT; k++) for (i = 0; i < n; i++) b[i * COUNT + k] = f[k * n + i];
    prt_sh_rotate_by_soa(bands, blocks, COUNT, b, b, COUNT);
    rows_of(n, b, b + COUNT * N);
    expect("prt_sh_rotate_by_soa", bands, COUNT * n, a, b + COUNT * N);
    for (k = 0; k < COUNT * n; k++) for (i = 0; i < 3; i++) b[3 * k + i] = f[k];
    prt_sh_rotate_by_n_rgb(bands, blocks, COUNT, b, b);
    for (k = 0; k < COUNT * n; k++) expect("prt_sh_rotate_by_n_rgb", bands, 1, a + k, b + 3 * k + k % 3);
}

/* A constant as one factor */
static void check_product(int bands, int n) {
    prt_real one[PRT_SH_COUNT(MOST)];
    int k, i;
    for (i = 0; i < n; i++) one[i] = 0;
    one[0] = PRT__R(3.5449077018110321);                 /* 2 sqrt(pi) */
    prt_sh_product(bands, f, one, a);
    expect("prt_sh_product", bands, n, f, a);
    prt_sh_square(bands, one, a);
    expect("prt_sh_square", bands, n, one, a);
    prt_sh_product_zonal(bands, f, one, a);              /* its first `bands` numbers: those of the constant about +z */
    expect("prt_sh_product_zonal", bands, n, f, a);
    for (k = 0; k < COUNT; k++) for (i = 0; i < n; i++) { a[i * COUNT + k] = f[k * n + i]; b[i * COUNT + k] = one[i]; }
    prt_sh_product_soa(bands, COUNT, a, b, a, COUNT);
    rows_of(n, a, b);
    expect("prt_sh_product_soa", bands, COUNT * n, f, b);
}

#ifndef PRT_NO_CH
static void check_ch(int bands, int n) {
    int k;
    for (k = 0; k < COUNT; k++) {
        prt_real at, sum = 0;
        int i;
        prt_ch_eval(bands, dirs[k], a + k * n);
        at = prt_ch_at(bands, f, dirs[k]);
        for (i = 0; i < n; i++) sum += f[i] * a[k * n + i];
        expect("prt_ch_at", bands, 1, &at, &sum);
    }
    prt_ch_eval_n(bands, COUNT, dirs, b);
    expect("prt_ch_eval_n", bands, COUNT * n, a, b);
    prt_ch_eval_soa(bands, COUNT, xs, ys, zs, b, COUNT);
    rows_of(n, b, b + COUNT * N);
    expect("prt_ch_eval_soa", bands, COUNT * n, a, b + COUNT * N);
}
#endif

#ifdef PRT_STATIC
/* A desc of zeros bakes as many bands as by default, or as there are. */
static void check_default(void) {
    prt_bake_desc desc;
    prt_point point;
    int bands = PRT_MAX_BANDS < 5 ? PRT_MAX_BANDS : 5;
    memset(&desc, 0, sizeof desc);
    memset(&point, 0, sizeof point);
    point.normal.z = 1;
    if (prt_bake_transfer(&desc, 1, &point, 0, 1, a) != PRT_OK || !(a[0] > 0)) fail("prt_bake_transfer by default", bands);
    if (prt_bake_scratch_size(0) == 0) fail("prt_bake_scratch_size by default", bands);
}
#endif

int main(void) {
    prt_vec3 dir;
    double sum = 0, want = 0;
    int l, m, k, bands;
    dir.x = PRT__R(0.48); dir.y = PRT__R(-0.6); dir.z = PRT__R(0.64);
    if (prt_sh_eval(PRT_MAX_BANDS + 1, dir, y) != PRT_ERR_BANDS || y[0] != 0) {
        bad = 1;
        printf("one band too many was not refused\n");
    }
    if (prt_sh_eval(PRT_MAX_BANDS, dir, y) != PRT_OK) {
        bad = 1;
        printf("PRT_MAX_BANDS bands were refused\n");
    }
    for (l = 0; l < PRT_MAX_BANDS; l++) {                /* addition theorem: sum_m Y(l,m)^2 = (2l+1)/(4 pi) */
        for (m = -l; m <= l; m++) sum += (double)y[PRT_SH_INDEX(l, m)] * (double)y[PRT_SH_INDEX(l, m)];
        want += (2 * l + 1) / (4 * PRT__PI);
    }
    if (!(sum >= want * (1 - 1e-3) && sum <= want * (1 + 1e-3))) {
        bad = 1;
        printf("sum of squares %.9g, expected %.9g\n", sum, want);
    }
    if (y[PRT_SH_COUNT(PRT_MAX_BANDS)] != 0) {
        bad = 1;
        printf("wrote beyond the last coefficient\n");
    }
    for (k = 0; k < COUNT; k++) {                        /* a spiral */
        zs[k] = (prt_real)(1 - (2 * k + 1.0) / COUNT);
        xs[k] = (prt_real)(sqrt(1 - (double)zs[k] * (double)zs[k]) * cos(2.4 * k));
        ys[k] = (prt_real)(sqrt(1 - (double)zs[k] * (double)zs[k]) * sin(2.4 * k));
        dirs[k].x = xs[k]; dirs[k].y = ys[k]; dirs[k].z = zs[k];
    }
    for (k = 0; k < COUNT * N; k++) f[k] = (prt_real)(0.4 * sin(1.7 * k + 0.3));
    if (PRT_MAX_BANDS > 64) return bad;                  /* arrays of so many bands fill the stack */
    for (bands = 1; bands <= MOST; bands++) {
        check_evaluation(bands, bands * bands);
        check_rotation(bands, bands * bands);
        check_product(bands, bands * bands);
#ifndef PRT_NO_CH
        check_ch(bands, bands * bands);
#endif
    }
#ifdef PRT_STATIC
    check_default();
#endif
    return bad;
}
