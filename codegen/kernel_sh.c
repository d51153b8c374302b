/* Kernels of the room >>sh. */
#include "kernels.h"

#include <stdio.h>

/* Normalised recurrence factors: p(l,m) = a z p(l-1,m) - a b p(l-2,m) [Sloan 2013] */
static xreal factor_a(int l, int m) { return x_sqrt(x_ratio(4L * l * l - 1, (long)l * l - (long)m * m)); }
static xreal factor_b(int l, int m) {
    long k = l - 1;
    return x_sqrt(x_ratio(k * k - (long)m * m, 4 * k * k - 1));
}

/* p(l,m) for l = m ... bands-1. The two bands above the diagonal are written as polynomials in z^2, which saves the
   product with p(m,m); from there on the recurrence, whose error does not grow as that of long polynomials does. */
static void column(kernel *k, int bands, int m, node z, node z2, xreal sector, node *p) {
    int l;
    xreal a1 = factor_a(m + 1, m), slope, offset;
    p[m] = k_const(k, sector);
    p[m + 1] = k_scale(k, a1 * sector, z);
    slope = factor_a(m + 2, m) * a1 * sector;
    offset = factor_a(m + 2, m) * factor_b(m + 2, m) * sector;
    p[m + 2] = k_sub(k, k_scale(k, slope, z2), k_const(k, offset));
    if (m + 3 < bands) {                               /* z (A z^2 - B) */
        xreal a3 = factor_a(m + 3, m);
        xreal cubic = a3 * slope, linear = a3 * (offset + factor_b(m + 3, m) * a1 * sector);
        p[m + 3] = k_mul(k, z, k_sub(k, k_scale(k, cubic, z2), k_const(k, linear)));
    }
    for (l = m + 4; l < bands; l++)
        p[l] = k_sub(k, k_scale(k, factor_a(l, m), k_mul(k, z, p[l - 1])),
                     k_scale(k, factor_a(l, m) * factor_b(l, m), p[l - 2]));
}

/* y[l(l+1) +- m] = p(l,m) {Re,Im}(x+iy)^m, m outer and l inner, so that a phasor is done with before the next starts */
kernel *describe_sh_eval(int bands) {
    char name[64], summary[160];
    kernel *k;
    node x, y, z, z2, re, im, p[64];
    int px, py, pz, out, l, m;
    xreal sector = x_sqrt(1 / (4 * x_pi()));
    snprintf(name, sizeof name, "sh_eval_%d", bands);
    snprintf(summary, sizeof summary, "SH basis, %d band%s", bands, bands == 1 ? "" : "s");
    k = kernel_new(name, summary);
    px = kernel_param(k, "x", PARAM_SCALAR, 0);
    py = kernel_param(k, "y", PARAM_SCALAR, 0);
    pz = kernel_param(k, "z", PARAM_SCALAR, 0);
    out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands);
    x = k_scalar(k, px);
    y = k_scalar(k, py);
    z = k_scalar(k, pz);
    z2 = k_mul(k, z, z);
    re = x;
    im = y;
    for (m = 0; m < bands; m++) {
        if (m > 1) {
            node t = k_sub(k, k_mul(k, x, re), k_mul(k, y, im));
            im = k_add(k, k_mul(k, x, im), k_mul(k, y, re));
            re = t;
        }
        if (m) sector *= x_sqrt(x_ratio(2L * m + 1, 2L * m)) * (m == 1 ? x_sqrt(2) : 1);
        column(k, bands, m, z, z2, sector, p);
        for (l = m; l < bands; l++) {
            if (m) kernel_output(k, out, l * (l + 1) - m, k_mul(k, p[l], im));
            kernel_output(k, out, l * (l + 1) + m, m ? k_mul(k, p[l], re) : p[l]);
        }
    }
    return k;
}
