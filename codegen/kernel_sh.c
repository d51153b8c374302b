/* Kernels of the room >>sh, and of any basis of the same form. */
#include "kernels.h"

#include <stdio.h>

/* Normalised recurrence factors: p(l,m) = a z p(l-1,m) - c p(l-2,m) [Sloan 2013] */
xreal sh_factor_a(int l, int m) { return x_sqrt(x_ratio(4L * l * l - 1, (long)l * l - (long)m * m)); }
static xreal sh_factor_c(int l, int m) {
    long k = l - 1;
    return sh_factor_a(l, m) * x_sqrt(x_ratio(k * k - (long)m * m, 4 * k * k - 1));
}

static const basis sh = { "sh", "SH", sh_factor_a, sh_factor_c };

/* p(l,m) for l = m ... bands-1. What bounds a kernel is its products, so the bands next to the diagonal are written
   with fewer than the recurrence needs: u = p(m+2,m) and p(m+3,m)/z are linear in z^2, p(m+4,m) is quadratic in u
   (in u rather than in z^2 its terms cancel little: their sizes add up to 2.9 at m = 0, against 8.5). From there on
   the recurrence, whose error does not grow as that of long polynomials does. */
static void column(kernel *k, const basis *b, int bands, int m, node z, node z2, xreal sector, node *p) {
    int l;
    xreal a1 = b->a(m + 1, m), a2 = b->a(m + 2, m), a3 = b->a(m + 3, m), a4 = b->a(m + 4, m);
    xreal slope = a2 * a1 * sector, offset = b->c(m + 2, m) * sector;                      /* u = slope z^2 - offset */
    xreal cubic = a3 * slope, linear = a3 * offset + b->c(m + 3, m) * a1 * sector;         /* z (cubic z^2 - linear) */
    p[m] = k_const(k, sector);
    p[m + 1] = k_scale(k, a1 * sector, z);
    p[m + 2] = k_sub(k, k_scale(k, slope, z2), k_const(k, offset));
    if (m + 3 < bands) p[m + 3] = k_mul(k, z, k_sub(k, k_scale(k, cubic, z2), k_const(k, linear)));
    /* a4 z^2 (cubic z^2 - linear) - c4 u with z^2 = (u + offset) / slope */
    if (m + 4 < bands) {
        xreal alpha = a4 * cubic / (slope * slope), gamma = alpha * offset * offset - a4 * linear * offset / slope;
        xreal beta = 2 * alpha * offset - a4 * linear / slope - b->c(m + 4, m);
        node u = p[m + 2];
        if (beta < 1e-25L && beta > -1e-25L) beta = 0;             /* it vanishes for some m of CH, but for rounding */
        p[m + 4] = k_add(k, k_mul(k, u, k_add(k, k_scale(k, alpha, u), k_const(k, beta))), k_const(k, gamma));
    }
    for (l = m + 5; l < bands; l++)
        p[l] = k_sub(k, k_scale(k, b->a(l, m), k_mul(k, z, p[l - 1])), k_scale(k, b->c(l, m), p[l - 2]));
}

/* Re and Im of (x+iy)^m, m >= 2, from the powers below: the square of power m/2 where m is even, (C-S)(C+S) and 2CS,
   which are two products; x(C2 - 2y^2) and y(C2 + 2x^2) at m = 3, which are three; x and power m-1 else, which are
   four. */
static void phasor(kernel *k, int m, node x, node y, node *re, node *im) {
    if (m == 3) {
        node y2 = k_mul(k, y, y), x2 = k_add(k, re[2], y2);
        re[3] = k_mul(k, x, k_sub(k, re[2], k_add(k, y2, y2)));
        im[3] = k_mul(k, y, k_add(k, re[2], k_add(k, x2, x2)));
    } else if (m % 2 == 0) {
        node c = re[m / 2], s = im[m / 2], product = k_mul(k, c, s);
        re[m] = k_mul(k, k_sub(k, c, s), k_add(k, c, s));
        im[m] = k_add(k, product, product);
    } else {
        re[m] = k_sub(k, k_mul(k, x, re[m - 1]), k_mul(k, y, im[m - 1]));
        im[m] = k_add(k, k_mul(k, x, im[m - 1]), k_mul(k, y, re[m - 1]));
    }
}

/* A kernel of n bands about a direction x, y, z: its columns and phasors */
typedef struct direction { node x, y, z, z2, re[64], im[64]; xreal sector; } direction;

kernel *named_kernel(const char *family, const char *what, int bands) {
    char name[64], summary[160];
    snprintf(name, sizeof name, "%s_%d", family, bands);
    snprintf(summary, sizeof summary, "%s, %d band%s", what, bands, bands == 1 ? "" : "s");
    return kernel_new(name, summary);
}

static kernel *basis_kernel(const basis *b, const char *verb, const char *what, int bands) {
    char family[32], title[64];
    snprintf(family, sizeof family, "%s_%s", b->name, verb);
    snprintf(title, sizeof title, "%s %s", b->title, what);
    return named_kernel(family, title, bands);
}

static void set_direction(kernel *k, node x, node y, node z, direction *d) {
    d->x = x;
    d->y = y;
    d->z = z;
    d->z2 = k_mul(k, d->z, d->z);
    d->re[1] = d->x;
    d->im[1] = d->y;
}

static void direction_param(kernel *k, const char *name, direction *d) {
    int dir = kernel_param(k, name, PARAM_DIRECTION, 3);
    set_direction(k, k_element(k, dir, 0), k_element(k, dir, 1), k_element(k, dir, 2), d);
}

/* To be called for m = 0, 1, 2 ...: fills re[m], im[m] and p[m ... bands-1] */
static void next_column(kernel *k, const basis *b, int bands, int m, direction *d, node *p) {
    if (m == 0) d->sector = x_sqrt(1 / (4 * x_pi()));
    else d->sector *= x_sqrt(x_ratio(2L * m + 1, 2L * m)) * (m == 1 ? x_sqrt(2) : 1);
    if (m > 1) phasor(k, m, d->x, d->y, d->re, d->im);
    column(k, b, bands, m, d->z, d->z2, d->sector, p);
}

/* y[l(l+1) +- m] = p(l,m) {Re,Im}(x+iy)^m, m outer and l inner, so that a phasor is done with before the next starts */
kernel *describe_eval(const basis *b, int bands) {
    direction d;
    kernel *k = basis_kernel(b, "eval", "basis", bands);
    int out, l, m;
    node p[64];
    direction_param(k, "dir", &d);
    out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands);
    for (m = 0; m < bands; m++) {
        next_column(k, b, bands, m, &d, p);
        for (l = m; l < bands; l++) {
            if (m) kernel_output(k, out, l * (l + 1) - m, k_mul(k, p[l], d.im[m]));
            kernel_output(k, out, l * (l + 1) + m, m ? k_mul(k, p[l], d.re[m]) : p[l]);
        }
    }
    return k;
}

/* sum of f_i Y_i = sum over m of Re sum_l p(l,m) f(l,m) + Im sum_l p(l,m) f(l,-m): the phasor is met once a column,
   and no value of the basis is formed. */
kernel *describe_at(const basis *b, int bands) {
    direction d;
    kernel *k = basis_kernel(b, "at", "value", bands);
    int f = kernel_param(k, "f", PARAM_INPUT, bands * bands), out, l, m;
    node p[64], sum = k_const(k, 0);
    direction_param(k, "dir", &d);
    out = kernel_param(k, "out", PARAM_RESULT, 1);
    for (m = 0; m < bands; m++) {
        node plus = k_const(k, 0), minus = k_const(k, 0);
        next_column(k, b, bands, m, &d, p);
        for (l = m; l < bands; l++) {
            plus = k_madd(k, p[l], k_element(k, f, l * (l + 1) + m), plus);
            if (m) minus = k_madd(k, p[l], k_element(k, f, l * (l + 1) - m), minus);
        }
        if (m == 0) sum = plus;
        else sum = k_add(k, sum, k_madd(k, d.re[m], plus, k_mul(k, d.im[m], minus)));
    }
    kernel_output(k, out, 0, sum);
    return k;
}

void sh_values(kernel *k, int bands, node x, node y, node z, node *values) {
    direction d;
    node p[64];
    int l, m;
    set_direction(k, x, y, z, &d);
    for (m = 0; m < bands; m++) {
        next_column(k, &sh, bands, m, &d, p);
        for (l = m; l < bands; l++) {
            values[l * (l + 1) - m] = k_mul(k, p[l], m ? d.im[m] : k_const(k, 1));
            values[l * (l + 1) + m] = k_mul(k, p[l], m ? d.re[m] : k_const(k, 1));
        }
    }
}

/* prt.h adds in place; a shader, whose arrays are values, gets the sum: for projecting an environment sample by
   sample */
kernel *describe_sh_add_sample(int bands) {
    kernel *k = named_kernel("sh_add_sample", "f + value Y(dir)", bands);
    vec dir = vec_param(k, "dir");
    node value = real_param(k, "value"), y[64 * 64], f[64 * 64];
    int i;
    input_nodes(k, "f", bands * bands, f);
    sh_values(k, bands, dir.x, dir.y, dir.z, y);
    for (i = 0; i < bands * bands; i++) f[i] = k_madd(k, value, y[i], f[i]);
    output_nodes(k, "out", bands * bands, f);
    return k;
}

kernel *describe_sh_eval(int bands) { return describe_eval(&sh, bands); }
kernel *describe_sh_at(int bands) { return describe_at(&sh, bands); }
