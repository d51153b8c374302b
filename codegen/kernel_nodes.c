/* Kernels of the room >>product: products of SH functions by way of their values on circles of latitude.

   On the circle at z a function is a Fourier series with W(m) = C(m) + i S(m): C(m) = sum over l of q(l,m) f(l,m),
   S(m) the same with f(l,-m). Circles at z and -z differ in the sign of odd l-m. The product of two series, cut off
   at the bands, is
     H(0) = X(0) Y(0)/2 + sum of Re W(a) conj V(a),
     H(m) = X(0) V(m) + Y(0) W(m) + sum over a+b = m of W(a) V(b) + sum over a-b = m of W(a) conj V(b) + V(a) conj W(b),
   X, Y the real W(0), V(0); and f g (l,m) = sum over all circles of q(l,m) H(m), which is exact at Gauss-Legendre
   nodes. The factors q serve all three functions: the harmonic's part in z times the cube root of the weight, twice
   that for m = 0. */
#include "kernels.h"

/* Rows hold a circle's series: C(m) at [2m], S(m) at [2m+1]; S(0) is not used. */
typedef const node *row;

static int place(int l, int m) { return l * (l + 1) / 2 + m; }             /* of q(l,m) */
static int index_of(int l, int m, int sine) { return l * (l + 1) + (sine ? -m : m); }

/* Rows at z and at -z from coefficients */
static void rows_of(kernel *k, int bands, const node *f, const node *q, node *plus, node *minus) {
    int m, l, sine;
    for (m = 0; m < bands; m++)
        for (sine = 0; sine <= (m > 0); sine++) {
            node sum[2];
            sum[0] = sum[1] = k_const(k, 0);
            for (l = m; l < bands; l++)
                sum[(l - m) & 1] = k_add(k, sum[(l - m) & 1], k_mul(k, f[index_of(l, m, sine)], q[place(l, m)]));
            plus[2 * m + sine] = k_add(k, sum[0], sum[1]);
            minus[2 * m + sine] = k_sub(k, sum[0], sum[1]);
        }
}

/* What each circle (or pair of circles: even and odd are the sum and the difference of its rows) adds to the
   coefficients */
static void terms_of(kernel *k, int bands, row even, row odd, const node *q, node *out) {
    int m, l, sine;
    for (m = 0; m < bands; m++)
        for (l = m; l < bands; l++)
            for (sine = 0; sine <= (m > 0); sine++)
                out[index_of(l, m, sine)] = k_mul(k, ((l - m) & 1 ? odd : even)[2 * m + sine], q[place(l, m)]);
}

/* W(a) V(b) or, if conj, W(a) conj V(b), added to re[2] and im[2]: two chains each */
static void add_product(kernel *k, row w, int a, row v, int b, int conj, node *re, node *im) {
    node ss = k_mul(k, w[2 * a + 1], v[2 * b + 1]), cs = k_mul(k, w[2 * a], v[2 * b + 1]);
    re[0] = k_add(k, re[0], k_mul(k, w[2 * a], v[2 * b]));
    re[1] = conj ? k_add(k, re[1], ss) : k_sub(k, re[1], ss);
    im[0] = k_add(k, im[0], k_mul(k, w[2 * a + 1], v[2 * b]));
    im[1] = conj ? k_sub(k, im[1], cs) : k_add(k, im[1], cs);
}

static void row_product(kernel *k, int bands, row w, row v, node *out) {
    node re[2], im[2];
    int a, m;
    re[0] = k_scale(k, x_ratio(1, 2), k_mul(k, w[0], v[0]));
    re[1] = k_const(k, 0);
    for (a = 1; a < bands; a++) {
        re[0] = k_add(k, re[0], k_mul(k, w[2 * a], v[2 * a]));
        re[1] = k_add(k, re[1], k_mul(k, w[2 * a + 1], v[2 * a + 1]));
    }
    out[0] = k_add(k, re[0], re[1]);
    for (m = 1; m < bands; m++) {
        re[0] = k_mul(k, w[0], v[2 * m]);
        re[1] = k_mul(k, v[0], w[2 * m]);
        im[0] = k_mul(k, w[0], v[2 * m + 1]);
        im[1] = k_mul(k, v[0], w[2 * m + 1]);
        for (a = 1; a < m; a++) add_product(k, w, a, v, m - a, 0, re, im);
        for (a = m + 1; a < bands; a++) {
            add_product(k, w, a, v, a - m, 1, re, im);
            add_product(k, v, a, w, a - m, 1, re, im);
        }
        out[2 * m] = k_add(k, re[0], re[1]);
        out[2 * m + 1] = k_add(k, im[0], im[1]);
    }
}

/* ---- the parts that prt.h puts together, with a circle in each lane ---- */

enum { MAX_BANDS = 8, COEFFICIENTS = MAX_BANDS * MAX_BANDS };

static void output_row(kernel *k, int to, int bands, row values) {
    int i;
    for (i = 0; i < 2 * bands; i++)
        if (i != 1) kernel_output(k, to, i, values[i]);
}

kernel *describe_sh_rows(int bands) {
    kernel *k = named_kernel("sh_rows", "rows of a function at z and -z", bands);
    node f[COEFFICIENTS], q[COEFFICIENTS], plus[2 * MAX_BANDS], minus[2 * MAX_BANDS];
    int i, to_plus, to_minus;
    input_nodes(k, "f", bands * bands, f);
    input_nodes(k, "q", place(bands, 0), q);
    to_plus = kernel_param(k, "plus", PARAM_OUTPUT, 2 * bands);
    to_minus = kernel_param(k, "minus", PARAM_OUTPUT, 2 * bands);
    rows_of(k, bands, f, q, plus, minus);
    for (i = 0; i < 2 * bands; i++) {
        if (i == 1) continue;
        kernel_output(k, to_plus, i, plus[i]);
        kernel_output(k, to_minus, i, minus[i]);
    }
    return k;
}

kernel *describe_sh_terms(int bands) {
    kernel *k = named_kernel("sh_terms", "terms of the projection of rows", bands);
    node even[2 * MAX_BANDS], odd[2 * MAX_BANDS], q[COEFFICIENTS], terms[COEFFICIENTS];
    int out, m, l, sine;
    input_nodes(k, "even", 2 * bands, even);
    input_nodes(k, "odd", 2 * bands, odd);
    input_nodes(k, "q", place(bands, 0), q);
    out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands);
    terms_of(k, bands, even, odd, q, terms);
    for (m = 0; m < bands; m++)
        for (l = m; l < bands; l++)
            for (sine = 0; sine <= (m > 0); sine++)
                kernel_output(k, out, index_of(l, m, sine), terms[index_of(l, m, sine)]);
    return k;
}

kernel *describe_row_product(int bands) {
    kernel *k = named_kernel("row_product", "product of two rows", bands);
    node w[2 * MAX_BANDS], v[2 * MAX_BANDS], values[2 * MAX_BANDS];
    input_nodes(k, "w", 2 * bands, w);
    input_nodes(k, "v", 2 * bands, v);
    row_product(k, bands, w, v, values);
    output_row(k, kernel_param(k, "out", PARAM_OUTPUT, 2 * bands), bands, values);
    return k;
}

/* ---- and the whole of it, circle after circle ---- */

void circle_product_nodes(kernel *k, int bands, const node *f, const node *g, node *out) {
    int pair, i, l, m;
    for (i = 0; i < bands * bands; i++) out[i] = k_const(k, 0);
    for (pair = 0; pair < grid_pairs(bands); pair++) {
        node q[COEFFICIENTS], w[2][2 * MAX_BANDS], v[2][2 * MAX_BANDS], h[2][2 * MAX_BANDS], term[COEFFICIENTS];
        for (l = 0; l < bands; l++)
            for (m = 0; m <= l; m++) q[place(l, m)] = k_const(k, node_factor(bands, pair, l, m));
        rows_of(k, bands, f, q, w[0], w[1]);
        rows_of(k, bands, g, q, v[0], v[1]);
        for (i = 0; i < 2; i++) row_product(k, bands, w[i], v[i], h[i]);
        for (i = 0; i < 2 * bands; i++) {
            node plus = h[0][i];
            if (i == 1) continue;
            h[0][i] = k_add(k, plus, h[1][i]);
            h[1][i] = k_sub(k, plus, h[1][i]);
        }
        terms_of(k, bands, h[0], h[1], q, term);
        for (i = 0; i < bands * bands; i++) kernel_stage(k, out[i] = k_add(k, out[i], term[i]));
    }
}
