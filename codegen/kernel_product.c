/* Kernels of the room >>product: the product of two SH expansions, truncated to their bands, and the square of one.

   With W(l,m) = f(l,m) + i f(l,-m), m >= 0 (real for m = 0), the sum over triple product coefficients falls into
     W(l3,a+b) += G W(l1,a) W'(l2,b),      W(l2,b) += G W(l3,a+b) conj W'(l1,a),      W(l1,a) += likewise,
   G = int Y(l1,a) Y(l2,b) Y(l3,a+b): one complex term where the real tensor has two or four. Each unordered triple of
   functions is put under one of its pairs. A pair (P,Q) computes X = P Q' + Q P' once for all its thirds R, and one
   linear form T = sum G R (and T' from the other factor) which serves P and Q. Pairs are chosen greedily, those first
   that serve most triples for their own cost. */
#include "kernels.h"

#include <stdio.h>
#include <stdlib.h>

enum { MAX_BANDS = 8, MAX_ELEMENTS = MAX_BANDS * (MAX_BANDS + 1) / 2, MAX_TRIPLES = 4096 };

typedef struct element { int l, m; } element;                      /* W(l,m) */
typedef struct triple { int low, other, top; xreal g; int done; } triple;        /* m(top) = m(low) + m(other) */
typedef struct complex_node { node re, im; } complex_node;

/* A pair of elements and how they meet: SUM multiplies them into m(p) + m(q), DIFFERENCE into m(p) - m(q). */
typedef enum meeting { SUM, DIFFERENCE } meeting;
typedef struct pair { int p, q; meeting how; } pair;

typedef struct product {
    kernel *k;
    int bands, element_count, triple_count;
    element elements[MAX_ELEMENTS];
    triple triples[MAX_TRIPLES];
    complex_node f[MAX_ELEMENTS], g[MAX_ELEMENTS], out[MAX_ELEMENTS];
    node mean;                                                     /* sum of f_i g_i, for coefficient 0 */
} product;

/* ---- triple product coefficients by Gauss-Legendre quadrature, exact but for rounding in 113 bits ---- */

/* int Y(l1,a) Y(l2,b) Y(l3,a+b) of the real harmonics */
static xreal coefficient(element low, element other, element top) {
    int count = (low.l + other.l + top.l) / 2 + 1, i;
    xreal sum = 0;
    for (i = 0; i < count; i++) {
        xreal z, w;
        x_gauss(count, i, &z, &w);
        sum += w * x_harmonic(low.l, low.m, z) * x_harmonic(other.l, other.m, z) * x_harmonic(top.l, top.m, z);
    }
    sum *= 2 * x_pi();
    if (low.m && other.m) sum *= x_sqrt(x_ratio(1, 2));
    return sum > 1e-28 || sum < -1e-28 ? sum : 0;                  /* some vanish by accident */
}

static void find_triples(product *p) {
    int i, j, k;
    for (i = 0; i < p->element_count; i++)
        for (j = i; j < p->element_count; j++)
            for (k = 0; k < p->element_count; k++) {
                element a = p->elements[i], b = p->elements[j], c = p->elements[k];
                triple *t = &p->triples[p->triple_count];
                if (a.m + b.m != c.m || (a.l + b.l + c.l) % 2) continue;
                if (a.l > b.l + c.l || b.l > a.l + c.l || c.l > a.l + b.l) continue;
                /* with m(low) = 0 the other two stand alike: each unordered triple once */
                if ((a.m == 0 && j > k) || (b.m == 0 && i > k)) continue;
                t->low = i;
                t->other = j;
                t->top = k;
                t->g = coefficient(a, b, c);
                t->done = 0;
                if (t->g != 0) p->triple_count++;
            }
}

/* ---- pairs ---- */

/* The third element of a triple that the pair serves, or -1. */
static int third(const product *p, const triple *t, pair pr) {
    int m_p = p->elements[pr.p].m, m_q = p->elements[pr.q].m, members[3], i, j, found = -1;
    members[0] = t->low;
    members[1] = t->other;
    members[2] = t->top;
    for (i = 0; i < 3 && found < 0; i++)
        for (j = 0; j < 3; j++)
            if (i != j && members[i] == pr.p && members[j] == pr.q) { found = members[3 - i - j]; break; }
    if (found < 0) return -1;
    if (pr.p != pr.q && (found == pr.p || found == pr.q)) return -1;           /* {A,A,B} belongs to the pair (A,A) */
    return p->elements[found].m == (pr.how == SUM ? m_p + m_q : m_p - m_q) ? found : -1;
}

static int served(const product *p, pair pr) {
    int i, count = 0;
    for (i = 0; i < p->triple_count; i++) count += !p->triples[i].done && third(p, &p->triples[i], pr) >= 0;
    return count;
}

/* Multiplications that a pair costs besides those of its triples */
static int pair_cost(const product *p, pair pr) {
    int width = (p->elements[pr.p].m ? 2 : 1) * (p->elements[pr.q].m ? 2 : 1);
    return pr.p == pr.q ? 3 * width : 6 * width;
}

static int best_pair(const product *p, pair *best) {
    double best_rate = 0;
    pair pr = { 0 };
    for (pr.p = 0; pr.p < p->element_count; pr.p++)
        for (pr.q = 0; pr.q < p->element_count; pr.q++) {
            int how;
            for (how = SUM; how <= DIFFERENCE; how++) {
                double rate;
                pr.how = (meeting)how;
                if (pr.how == SUM && pr.q > pr.p) continue;
                if (pr.how == DIFFERENCE && !p->elements[pr.q].m) continue;
                if (pr.how == DIFFERENCE && p->elements[pr.q].m > p->elements[pr.p].m) continue;
                if (pr.how == DIFFERENCE && p->elements[pr.q].m == p->elements[pr.p].m && pr.q > pr.p) continue;
                rate = (double)served(p, pr) / pair_cost(p, pr);
                if (rate > best_rate) { best_rate = rate; *best = pr; }
            }
        }
    return best_rate > 0;
}

/* ---- complex arithmetic on nodes ---- */

static complex_node c_zero(kernel *k) {
    complex_node z;
    z.re = z.im = k_const(k, 0);
    return z;
}
static complex_node c_conj(kernel *k, complex_node a) {
    a.im = k_neg(k, a.im);
    return a;
}
static complex_node c_add(kernel *k, complex_node a, complex_node b) {
    a.re = k_add(k, a.re, b.re);
    a.im = k_add(k, a.im, b.im);
    return a;
}
static complex_node c_mul(kernel *k, complex_node a, complex_node b) {
    complex_node r;
    r.re = k_sub(k, k_mul(k, a.re, b.re), k_mul(k, a.im, b.im));
    r.im = k_add(k, k_mul(k, a.re, b.im), k_mul(k, a.im, b.re));
    return r;
}
static complex_node c_scale(kernel *k, xreal s, complex_node a) {
    a.re = k_scale(k, s, a.re);
    a.im = k_scale(k, s, a.im);
    return a;
}
static complex_node real_part(kernel *k, complex_node a) {
    a.im = k_const(k, 0);
    return a;
}

/* a b' + b a' (a' = a and b' = b in a square), or a a' if both are one element */
static complex_node symmetric(kernel *k, complex_node a, complex_node a2, complex_node b, complex_node b2, int one) {
    complex_node ab = c_mul(k, a, b2);
    if (one) return ab;
    if (a.re == a2.re && b.re == b2.re) return c_add(k, ab, ab);
    return c_add(k, ab, c_mul(k, b, a2));
}

/* ---- one pair with everything that it serves ---- */

static void add_to(product *p, int to, complex_node v) {
    if (p->elements[to].m == 0) v = real_part(p->k, v);
    p->out[to] = c_add(p->k, p->out[to], v);
}

static void serve(product *p, pair pr) {
    kernel *k = p->k;
    int one = pr.p == pr.q, i;
    complex_node q = p->f[pr.q], q2 = p->g[pr.q], x, form = c_zero(k), form2 = c_zero(k);
    if (pr.how == DIFFERENCE) { q = c_conj(k, q); q2 = c_conj(k, q2); }
    x = symmetric(k, p->f[pr.p], p->g[pr.p], q, q2, one);
    for (i = 0; i < p->triple_count; i++) {
        triple *t = &p->triples[i];
        int r = t->done ? -1 : third(p, t, pr);
        if (r < 0) continue;
        t->done = 1;
        if (r != pr.p) {
            form = c_add(k, form, c_scale(k, t->g, p->f[r]));
            form2 = c_add(k, form2, c_scale(k, t->g, p->g[r]));
        }
        if (r == 0) p->mean = k_add(k, p->mean, x.re);             /* one factor for all of them, at the end */
        else add_to(p, r, c_scale(k, t->g, x));
    }
    /* R = P Q: P gets R conj(Q), Q gets R conj(P).  R = P conj(Q): P gets R Q, Q gets conj(R) P. */
    q = p->f[pr.q];
    q2 = p->g[pr.q];
    if (pr.how == SUM) { q = c_conj(k, q); q2 = c_conj(k, q2); }
    add_to(p, pr.p, symmetric(k, form, form2, q, q2, 0));
    if (one) return;
    if (pr.how == SUM) add_to(p, pr.q, symmetric(k, form, form2, c_conj(k, p->f[pr.p]), c_conj(k, p->g[pr.p]), 0));
    else add_to(p, pr.q, symmetric(k, c_conj(k, form), c_conj(k, form2), p->f[pr.p], p->g[pr.p], 0));
}

static complex_node input(kernel *k, const node *f, element e) {
    complex_node w;
    w.re = f[e.l * (e.l + 1) + e.m];
    w.im = e.m ? f[e.l * (e.l + 1) - e.m] : k_const(k, 0);
    return w;
}

/* What out has so far is worked out before the next pair, whose elements then need not wait in memory. */
static void stage_outputs(product *p) {
    int i;
    for (i = 0; i < p->element_count; i++) {
        kernel_stage(p->k, p->out[i].re);
        kernel_stage(p->k, p->out[i].im);
    }
}

/* The order of statements: coefficient by coefficient, or pair by pair */
typedef enum order { BY_OUTPUT, BY_PAIR } order;

/* g is f itself for a square. */
static void tensor_product_nodes(kernel *k, int bands, const node *f, const node *g, order by, node *out) {
    product *p = (product *)calloc(1, sizeof *p);
    pair pr = { 0 };
    int l, m, i;
    if (!p) { fprintf(stderr, "prt_codegen: out of memory\n"); exit(1); }
    p->k = k;
    p->bands = bands;
    p->mean = k_const(k, 0);
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            element e;
            e.l = l;
            e.m = m;
            p->f[p->element_count] = input(k, f, e);
            p->g[p->element_count] = input(k, g, e);
            p->out[p->element_count] = c_zero(k);
            p->elements[p->element_count++] = e;
        }
    find_triples(p);
    while (best_pair(p, &pr)) {
        serve(p, pr);
        if (by == BY_PAIR) stage_outputs(p);
    }
    p->out[0].re = k_add(k, p->out[0].re, k_scale(k, x_sqrt(1 / (4 * x_pi())), p->mean));
    for (i = 0; i < p->element_count; i++) {
        element e = p->elements[i];
        if (e.m) out[e.l * (e.l + 1) - e.m] = p->out[i].im;
        out[e.l * (e.l + 1) + e.m] = p->out[i].re;
    }
    free(p);
}

/* By whichever takes fewer operations, the tensor or the circles of kernel_nodes.c */
void product_nodes(kernel *k, int bands, const node *f, const node *g, node *out) {
    if (bands <= 4) tensor_product_nodes(k, bands, f, g, BY_OUTPUT, out);
    else circle_product_nodes(k, bands, f, g, out);
}

typedef void product_by(kernel *k, int bands, const node *f, const node *g, node *out);

/* Outputs in the order in which the elements are done */
static void output_product(kernel *k, int bands, const node *value) {
    int out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands), l, m;
    k->stores_last = 1;                                            /* out may be f or g */
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            if (m) kernel_output(k, out, l * (l + 1) - m, value[l * (l + 1) - m]);
            kernel_output(k, out, l * (l + 1) + m, value[l * (l + 1) + m]);
        }
}

static kernel *describe_product(const char *name, const char *what, int bands, product_by *multiply) {
    kernel *k = named_kernel(name, what, bands);
    node f[MAX_BANDS * MAX_BANDS], g[MAX_BANDS * MAX_BANDS], out[MAX_BANDS * MAX_BANDS];
    int pf = kernel_param(k, "f", PARAM_INPUT, bands * bands), pg = kernel_param(k, "g", PARAM_INPUT, bands * bands);
    int l, m;
    /* in the order of their use: operands are sorted by it */
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            f[l * (l + 1) + m] = k_element(k, pf, l * (l + 1) + m);
            f[l * (l + 1) - m] = k_element(k, pf, l * (l + 1) - m);
            g[l * (l + 1) + m] = k_element(k, pg, l * (l + 1) + m);
            g[l * (l + 1) - m] = k_element(k, pg, l * (l + 1) - m);
        }
    multiply(k, bands, f, g, out);
    output_product(k, bands, out);
    return k;
}

kernel *describe_sh_product(int bands) { return describe_product("sh_product", "product", bands, product_nodes); }

/* For batches: with few values at a time, and at 4 bands by points, which takes fewer operations than the tensor */
static void batch_nodes(kernel *k, int bands, const node *f, const node *g, node *out) {
    if (bands == 4) point_product_nodes(k, f, g, out);
    else tensor_product_nodes(k, bands, f, g, BY_PAIR, out);
}
kernel *describe_sh_products(int bands) { return describe_product("sh_products", "products", bands, batch_nodes); }

kernel *describe_sh_square(int bands) {
    kernel *k = named_kernel("sh_square", "square", bands);
    node f[MAX_BANDS * MAX_BANDS], out[MAX_BANDS * MAX_BANDS];
    int pf = kernel_param(k, "f", PARAM_INPUT, bands * bands), l, m;
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            f[l * (l + 1) + m] = k_element(k, pf, l * (l + 1) + m);
            f[l * (l + 1) - m] = k_element(k, pf, l * (l + 1) - m);
        }
    tensor_product_nodes(k, bands, f, f, BY_OUTPUT, out);
    output_product(k, bands, out);
    return k;
}

/* zonal[l] is the m = 0 coefficient of a function about +z */
kernel *describe_sh_product_zonal(int bands) {
    kernel *k = named_kernel("sh_product_zonal", "product with a zonal function", bands);
    node f[MAX_BANDS * MAX_BANDS], g[MAX_BANDS * MAX_BANDS], zonal[MAX_BANDS], out[MAX_BANDS * MAX_BANDS];
    int l, i;
    input_nodes(k, "f", bands * bands, f);
    input_nodes(k, "zonal", bands, zonal);
    for (l = 0, i = 0; l < bands; l++)
        for (; i < (l + 1) * (l + 1); i++) g[i] = i == l * (l + 1) ? zonal[l] : k_const(k, 0);
    tensor_product_nodes(k, bands, f, g, BY_OUTPUT, out);
    output_product(k, bands, out);
    return k;
}

static void weigh_bands(kernel *k, int bands, const xreal *weight, node *f) {
    int l, i;
    for (l = 0, i = 0; l < bands; l++)
        for (; i < (l + 1) * (l + 1); i++) f[i] = k_scale(k, weight[l], f[i]);
}

/* Windows as wide as the bands, on both factors [Chapter 2010] or on the filter alone. */
static kernel *describe_mask(const char *name, const char *what, int bands, window *weights, int both) {
    kernel *k = named_kernel(name, what, bands);
    node light[MAX_BANDS * MAX_BANDS], filter[MAX_BANDS * MAX_BANDS], out[MAX_BANDS * MAX_BANDS];
    xreal weight[64];
    weights(bands, weight);
    input_nodes(k, "light", bands * bands, light);
    input_nodes(k, "filter", bands * bands, filter);
    weigh_bands(k, bands, weight, filter);
    if (both) weigh_bands(k, bands, weight, light);
    product_nodes(k, bands, light, filter, out);
    output_product(k, bands, out);
    return k;
}

#define MASK(name, of, weights, both) \
    kernel *describe_##name(int bands) { return describe_mask(#name, "light times filter, " of, bands, weights, both); }
MASK(sh_mask_hann, "both under Hann's window", hann_weights, 1)
MASK(sh_mask_lanczos, "both under Lanczos' window", lanczos_weights, 1)
MASK(sh_mask_positive, "both under the positive window", positive_weights, 1)
MASK(sh_mask_filter_hann, "that under Hann's window", hann_weights, 0)
MASK(sh_mask_filter_lanczos, "that under Lanczos' window", lanczos_weights, 0)
MASK(sh_mask_filter_positive, "that under the positive window", positive_weights, 0)
#undef MASK

/* ---- multiplication by a fixed filter as a matrix ---- */

/* int Y_i Y_j Y_k of the real harmonics: 0 unless one |m| is the sum of the others and the sines are none or two; then
   that of the |m|, negative where the cosine among two sines has the sum. */
static xreal real_coefficient(element a, element b, element c) {
    int sines = (a.m < 0) + (b.m < 0) + (c.m < 0), sign;
    element top = c, e[3];
    if (abs(a.m) > abs(top.m)) { top = a; a = c; }
    if (abs(b.m) > abs(top.m)) { element t = top; top = b; b = t; }
    if (sines % 2 || abs(a.m) + abs(b.m) != abs(top.m) || (a.l + b.l + top.l) % 2) return 0;
    if (a.l > b.l + top.l || b.l > a.l + top.l || top.l > a.l + b.l) return 0;
    sign = sines == 2 && top.m > 0 ? -1 : 1;
    e[0] = a; e[1] = b; e[2] = top;
    e[0].m = abs(a.m); e[1].m = abs(b.m); e[2].m = abs(top.m);
    return sign * coefficient(e[0], e[1], e[2]);
}

static element element_of(int i) {
    element e = { 0, 0 };
    while ((e.l + 1) * (e.l + 1) <= i) e.l++;
    e.m = i - e.l * (e.l + 1);
    return e;
}

kernel *describe_sh_product_matrix(int bands) {
    kernel *k = named_kernel("sh_product_matrix", "the matrix that multiplies by a filter", bands);
    int n = bands * bands, i, j, h;
    node f[MAX_BANDS * MAX_BANDS];
    int out;
    input_nodes(k, "filter", n, f);
    out = kernel_param(k, "matrix", PARAM_OUTPUT, n * n);
    for (i = 0; i < n; i++)
        for (j = 0; j <= i; j++) {
            node sum = k_const(k, 0);
            for (h = 0; h < n; h++)
                sum = k_madd(k, k_const(k, real_coefficient(element_of(i), element_of(j), element_of(h))), f[h], sum);
            kernel_output(k, out, i * n + j, sum);
            if (j < i) kernel_output(k, out, j * n + i, sum);
        }
    return k;
}

kernel *describe_sh_product_by(int bands) {
    kernel *k = named_kernel("sh_product_by", "product by the matrix of a filter", bands);
    int n = bands * bands, matrix = kernel_param(k, "matrix", PARAM_INPUT, n * n), i, j;
    int f = kernel_param(k, "f", PARAM_INPUT, n), out = kernel_param(k, "out", PARAM_OUTPUT, n);
    for (i = 0; i < n; i++) {
        node sum = k_const(k, 0);
        for (j = 0; j < n; j++) sum = k_madd(k, k_element(k, matrix, i * n + j), k_element(k, f, j), sum);
        kernel_output(k, out, i, sum);
    }
    return k;
}

/* ---- exponentials ---- */

/* f without its mean, of norm 1 at most: 1 + f (1 + f/2 (1 + f/3 (1 + f/4))); sh_square doubles the exponent */
kernel *describe_sh_exp_series(int bands) {
    kernel *k = named_kernel("sh_exp_series", "exponential of f of norm 1 at most", bands);
    node f[MAX_BANDS * MAX_BANDS], out[MAX_BANDS * MAX_BANDS], one = k_const(k, x_sqrt(4 * x_pi()));
    int n = bands * bands, h, i;
    input_nodes(k, "f", n, f);
    for (i = 0; i < n; i++) out[i] = k_scale(k, x_ratio(1, 4), f[i]);
    out[0] = k_add(k, out[0], one);
    for (h = 3; h >= 1; h--) {
        node product[MAX_BANDS * MAX_BANDS];
        product_nodes(k, bands, f, out, product);
        for (i = 0; i < n; i++) out[i] = k_scale(k, x_ratio(1, h), product[i]);
        out[0] = k_add(k, out[0], one);
    }
    output_product(k, bands, out);
    return k;
}

/* 1 + (e^v - 1)/v f at v = |f|^2 over the mean, if that is negative; else 1 + f */
kernel *describe_sh_exp_linear(int bands) {
    kernel *k = named_kernel("sh_exp_linear", "exponential of a log visibility, linear in it", bands);
    node f[64 * 64], zero = k_const(k, 0), square = zero, mean, slope;
    xreal root = x_sqrt(4 * x_pi());
    int i;
    input_nodes(k, "f", bands * bands, f);
    for (i = 0; i < bands * bands; i++) square = k_madd(k, f[i], f[i], square);
    mean = k_scale(k, root, f[0]);
    slope = k_exponential_slope(k, k_select(k, mean, zero, k_div(k, square, mean), zero));
    for (i = 0; i < bands * bands; i++) f[i] = k_mul(k, slope, f[i]);
    f[0] = k_add(k, f[0], k_const(k, root));
    output_nodes(k, "out", bands * bands, f);
    return k;
}
