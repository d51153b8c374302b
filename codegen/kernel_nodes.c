/* Kernels of the room >>product: products of SH functions by way of their values on circles of latitude.

   On the circle at z a function is a Fourier series with W(m) = C(m) + i S(m): C(m) = sum over l of q(l,m) f(l,m), S(m) the
   same with f(l,-m). Circles at z and -z differ in the sign of odd l-m. The product of two series, cut off at the bands, is
     H(0) = X(0) Y(0)/2 + sum of Re W(a) conj V(a),
     H(m) = X(0) V(m) + Y(0) W(m) + sum over a+b = m of W(a) V(b) + sum over a-b = m of W(a) conj V(b) + V(a) conj W(b),
   X, Y the real W(0), V(0); and f g (l,m) = sum over all circles of q(l,m) H(m), which is exact at Gauss-Legendre nodes. The
   factors q serve all three functions: the harmonic's part in z times the cube root of the weight, twice that for m = 0. */
#include "kernels.h"

/* Rows hold a circle's series: C(m) at [2m], S(m) at [2m+1]. */
static node c_of(kernel *k, int row, int m) { return k_element(k, row, 2 * m); }
static node s_of(kernel *k, int row, int m) { return k_element(k, row, 2 * m + 1); }

static int place(int l, int m) { return l * (l + 1) / 2 + m; }             /* of q(l,m) */
static int index_of(int l, int m, int sine) { return l * (l + 1) + (sine ? -m : m); }

/* Rows at z and at -z from coefficients */
kernel *describe_sh_rows(int bands) {
    kernel *k = named_kernel("sh_rows", "rows of a function at z and -z", bands);
    int f = kernel_param(k, "f", PARAM_INPUT, bands * bands), q = kernel_param(k, "q", PARAM_INPUT, place(bands, 0));
    int plus = kernel_param(k, "plus", PARAM_OUTPUT, 2 * bands), minus = kernel_param(k, "minus", PARAM_OUTPUT, 2 * bands);
    int m, l, sine;
    for (m = 0; m < bands; m++)
        for (sine = 0; sine <= (m > 0); sine++) {
            node sum[2];
            sum[0] = sum[1] = k_const(k, 0);
            for (l = m; l < bands; l++) {
                node term = k_mul(k, k_element(k, f, index_of(l, m, sine)), k_element(k, q, place(l, m)));
                sum[(l - m) & 1] = k_add(k, sum[(l - m) & 1], term);
            }
            kernel_output(k, plus, 2 * m + sine, k_add(k, sum[0], sum[1]));
            kernel_output(k, minus, 2 * m + sine, k_sub(k, sum[0], sum[1]));
        }
    return k;
}

/* What each circle (or pair of circles: even and odd are the sum and the difference of its rows) adds to the coefficients */
kernel *describe_sh_terms(int bands) {
    kernel *k = named_kernel("sh_terms", "terms of the projection of rows", bands);
    int even = kernel_param(k, "even", PARAM_INPUT, 2 * bands), odd = kernel_param(k, "odd", PARAM_INPUT, 2 * bands);
    int q = kernel_param(k, "q", PARAM_INPUT, place(bands, 0)), out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands);
    int m, l, sine;
    for (m = 0; m < bands; m++)
        for (l = m; l < bands; l++)
            for (sine = 0; sine <= (m > 0); sine++)
                kernel_output(k, out, index_of(l, m, sine),
                              k_mul(k, k_element(k, (l - m) & 1 ? odd : even, 2 * m + sine), k_element(k, q, place(l, m))));
    return k;
}

/* W(a) V(b) or, if conj, W(a) conj V(b), added to re[2] and im[2]: two chains each */
static void add_product(kernel *k, int w, int a, int v, int b, int conj, node *re, node *im) {
    node ss = k_mul(k, s_of(k, w, a), s_of(k, v, b)), cs = k_mul(k, c_of(k, w, a), s_of(k, v, b));
    re[0] = k_add(k, re[0], k_mul(k, c_of(k, w, a), c_of(k, v, b)));
    re[1] = conj ? k_add(k, re[1], ss) : k_sub(k, re[1], ss);
    im[0] = k_add(k, im[0], k_mul(k, s_of(k, w, a), c_of(k, v, b)));
    im[1] = conj ? k_sub(k, im[1], cs) : k_add(k, im[1], cs);
}

kernel *describe_row_product(int bands) {
    kernel *k = named_kernel("row_product", "product of two rows", bands);
    int w = kernel_param(k, "w", PARAM_INPUT, 2 * bands), v = kernel_param(k, "v", PARAM_INPUT, 2 * bands);
    int out = kernel_param(k, "out", PARAM_OUTPUT, 2 * bands), a, m;
    node x = c_of(k, w, 0), y = c_of(k, v, 0), re[2], im[2];
    re[0] = k_scale(k, x_ratio(1, 2), k_mul(k, x, y));
    re[1] = k_const(k, 0);
    for (a = 1; a < bands; a++) {
        re[0] = k_add(k, re[0], k_mul(k, c_of(k, w, a), c_of(k, v, a)));
        re[1] = k_add(k, re[1], k_mul(k, s_of(k, w, a), s_of(k, v, a)));
    }
    kernel_output(k, out, 0, k_add(k, re[0], re[1]));
    for (m = 1; m < bands; m++) {
        re[0] = k_mul(k, x, c_of(k, v, m));
        re[1] = k_mul(k, y, c_of(k, w, m));
        im[0] = k_mul(k, x, s_of(k, v, m));
        im[1] = k_mul(k, y, s_of(k, w, m));
        for (a = 1; a < m; a++) add_product(k, w, a, v, m - a, 0, re, im);
        for (a = m + 1; a < bands; a++) {
            add_product(k, w, a, v, a - m, 1, re, im);
            add_product(k, v, a, w, a - m, 1, re, im);
        }
        kernel_output(k, out, 2 * m, k_add(k, re[0], re[1]));
        kernel_output(k, out, 2 * m + 1, k_add(k, im[0], im[1]));
    }
    return k;
}
