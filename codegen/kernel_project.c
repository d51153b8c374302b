/* Kernels of the room >>project: lights in closed form, by the factors g_l of Funk and Hecke, f_lm = g_l Y_lm(axis),
   and functions of a band. prt.h itself computes the factors in double; these are for languages that have float
   alone. */
#include "kernels.h"

/* f_lm = factor_l Y_lm(a) */
static void zonal_light(kernel *k, int bands, vec a, const node *factor) {
    node y[64 * 64];
    int f = kernel_param(k, "f", PARAM_OUTPUT, bands * bands), l, m;
    sh_values(k, bands, a.x, a.y, a.z, y);
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) kernel_output(k, f, l * (l + 1) + m, k_mul(k, factor[l], y[l * (l + 1) + m]));
}

/* The factors of the clamped cosine: pi, 2 pi/3, pi/4, 0, -pi/24, 0, pi/64 ... [Ramamoorthi 2001] */
static xreal cosine_factor(int l) {
    xreal g = l & 1 ? 2 * x_pi() / 3 : x_pi();
    int k;
    for (k = l & 1 ? 3 : 2; k <= l; k += 2) g *= x_ratio(3 - k, k + 2);
    return g;
}

/* 1 above and -1 below: 0, 2 pi, 0, -pi/2, 0, pi/4 ... */
static xreal sign_factor(int l) {
    xreal g = 2 * x_pi();
    int k;
    if (l % 2 == 0) return 0;
    for (k = 3; k <= l; k += 2) g *= x_ratio(2 - k, k + 1);
    return g;
}

/* Factors of a cap from sin^2 and h = 1 - cos of its half-angle, at most pi/2; of all the rest where `rest` > 0:
   even bands change their sign, and band 0 is what remains of 4 pi. u_l are the differences of Legendre polynomials
   that do not cancel (see prt_sh_cone). */
static void cap_factors(kernel *k, int bands, node sin2, node h, node rest, node *factor) {
    node zero = k_const(k, 0), u = k_const(k, 1), step = zero, whole = k_const(k, 2 * x_pi());
    node cap = k_scale(k, x_pi(), sin2);
    int l;
    factor[0] = k_mul(k, whole, k_select(k, zero, rest, k_sub(k, k_const(k, 2), h), h));
    for (l = 1; l < bands; l++) {
        node value = k_mul(k, cap, u);
        factor[l] = l & 1 ? value : k_select(k, zero, rest, k_neg(k, value), value);
        step = k_sub(k, k_scale(k, x_ratio(l - 1, l + 2), step), k_scale(k, x_ratio(2 * l + 1, l + 2), k_mul(k, h, u)));
        u = k_add(k, u, step);
    }
}

kernel *describe_sh_delta(int bands) {
    kernel *k = named_kernel("sh_delta", "directional light of irradiance 1", bands);
    vec a = vec_param(k, "dir");
    node one[64];
    int l;
    for (l = 0; l < bands; l++) one[l] = k_const(k, 1);
    zonal_light(k, bands, a, one);
    return k;
}

kernel *describe_sh_cone(int bands) {
    kernel *k = named_kernel("sh_cone", "1 within half_angle of axis", bands);
    vec a = vec_param(k, "axis");
    node angle = k_scalar(k, kernel_param(k, "half_angle", PARAM_SCALAR, 0)), pi = k_const(k, x_pi());
    node rest = k_sub(k, angle, k_const(k, x_pi() / 2));                           /* > 0: wider than a hemisphere */
    node narrow = k_max(k, k_min(k, angle, k_sub(k, pi, angle)), k_const(k, 0));   /* float rounds pi up */
    node sine = k_sine(k, narrow), half = k_sine(k, k_scale(k, x_ratio(1, 2), narrow)), factor[64];
    cap_factors(k, bands, k_mul(k, sine, sine), k_scale(k, 2, k_mul(k, half, half)), rest, factor);
    zonal_light(k, bands, a, factor);
    return k;
}

kernel *describe_sh_sphere(int bands) {
    kernel *k = named_kernel("sh_sphere", "1 where a sphere is seen", bands);
    vec to = vec_param(k, "to_centre");
    node r = k_scalar(k, kernel_param(k, "radius", PARAM_SCALAR, 0)), zero = k_const(k, 0), one = k_const(k, 1);
    node factor[64];
    node d2 = k_madd(k, to.x, to.x, k_madd(k, to.y, to.y, k_mul(k, to.z, to.z))), d = k_sqrt(k, d2);
    node inside = k_sub(k, r, d);                                                  /* > 0: inside, it is everywhere */
    node over_d = k_select(k, zero, d, k_div(k, one, d), zero), s = k_mul(k, r, over_d);
    node sin2 = k_select(k, zero, inside, zero, k_mul(k, s, s));
    node cosine = k_mul(k, k_sqrt(k, k_max(k, k_mul(k, k_sub(k, d, r), k_add(k, d, r)), zero)), over_d);
    node h = k_div(k, sin2, k_add(k, one, cosine));
    vec a;
    a.x = k_mul(k, to.x, over_d);
    a.y = k_mul(k, to.y, over_d);
    a.z = k_mul(k, to.z, over_d);
    cap_factors(k, bands, sin2, h, inside, factor);
    zonal_light(k, bands, a, factor);
    return k;
}

kernel *describe_sh_cosine_lobe(int bands) {
    kernel *k = named_kernel("sh_cosine_lobe", "max(0, axis.w)", bands);
    vec a = vec_param(k, "axis");
    node factor[64];
    int l;
    for (l = 0; l < bands; l++) factor[l] = k_const(k, cosine_factor(l));
    zonal_light(k, bands, a, factor);
    return k;
}

kernel *describe_sh_hemisphere(int bands) {
    kernel *k = named_kernel("sh_hemisphere", "above where up.w > 0, below elsewhere", bands);
    vec a = vec_param(k, "up");
    node above = k_scalar(k, kernel_param(k, "above", PARAM_SCALAR, 0));
    node below = k_scalar(k, kernel_param(k, "below", PARAM_SCALAR, 0)), factor[64];
    int l;
    factor[0] = k_scale(k, 2 * x_pi(), k_add(k, above, below));
    for (l = 1; l < bands; l++) factor[l] = k_scale(k, sign_factor(l) / 2, k_sub(k, above, below));
    zonal_light(k, bands, a, factor);
    return k;
}

/* out_lm = factor_l f_lm with constant factors */
static kernel *scaled_bands(const char *family, const char *what, int bands, const xreal *factor) {
    kernel *k = named_kernel(family, what, bands);
    int f = kernel_param(k, "f", PARAM_INPUT, bands * bands), out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands);
    int l, i;
    for (l = 0, i = 0; l < bands; l++)
        for (; i < (l + 1) * (l + 1); i++) kernel_output(k, out, i, k_scale(k, factor[l], k_element(k, f, i)));
    return k;
}

kernel *describe_sh_irradiance(int bands) {
    xreal factor[64];
    int l;
    for (l = 0; l < bands; l++) factor[l] = cosine_factor(l);
    return scaled_bands("sh_irradiance", "irradiance from radiance", bands, factor);
}

/* The polynomial of prt_sh_pack_irradiance: seven constants of four values, as engines lay them out [Sloan 2008,
   A10] */
kernel *describe_sh_irradiance_packed(int bands) {
    kernel *k = kernel_new("sh_irradiance_packed", "irradiance over pi from the constants of prt_sh_pack_irradiance");
    static const char *const name[7] = { "a_red", "a_green", "a_blue", "b_red", "b_green", "b_blue", "c" };
    node sum[3], product[5];
    int constant[7], i, j;
    vec n;
    (void)bands;
    for (i = 0; i < 7; i++) constant[i] = kernel_param(k, name[i], PARAM_FOUR, 4);
    n = vec_param(k, "normal");
    product[0] = k_mul(k, n.x, n.y);
    product[1] = k_mul(k, n.y, n.z);
    product[2] = k_mul(k, n.z, n.z);
    product[3] = k_mul(k, n.z, n.x);
    product[4] = k_sub(k, k_mul(k, n.x, n.x), k_mul(k, n.y, n.y));
    for (i = 0; i < 3; i++) {
        sum[i] = k_madd(k, k_element(k, constant[i], 2), n.z, k_element(k, constant[i], 3));
        sum[i] = k_madd(k, k_element(k, constant[i], 1), n.y, sum[i]);
        sum[i] = k_madd(k, k_element(k, constant[i], 0), n.x, sum[i]);
        for (j = 0; j < 4; j++) sum[i] = k_madd(k, k_element(k, constant[3 + i], j), product[j], sum[i]);
        sum[i] = k_madd(k, k_element(k, constant[6], i), product[4], sum[i]);
    }
    vec_result(k, vec_of(sum));
    return k;
}

kernel *describe_sh_convolve(int bands) {
    kernel *k = named_kernel("sh_convolve", "convolution with a zonal function", bands);
    int f = kernel_param(k, "f", PARAM_INPUT, bands * bands), zonal = kernel_param(k, "zonal", PARAM_INPUT, bands);
    int out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands), l, i;
    for (l = 0, i = 0; l < bands; l++) {
        node factor = k_scale(k, x_sqrt(4 * x_pi() / (2 * l + 1)), k_element(k, zonal, l));
        for (; i < (l + 1) * (l + 1); i++) kernel_output(k, out, i, k_mul(k, factor, k_element(k, f, i)));
    }
    return k;
}

/* zonal[l] is the m = 0 coefficient of a function about +z */
kernel *describe_sh_zonal_to(int bands) {
    kernel *k = named_kernel("sh_zonal_to", "zonal function turned to an axis", bands);
    node zonal[64], factor[64];
    vec a;
    int l;
    input_nodes(k, "zonal", bands, zonal);
    a = vec_param(k, "axis");
    for (l = 0; l < bands; l++) factor[l] = k_scale(k, x_sqrt(4 * x_pi() / (2 * l + 1)), zonal[l]);
    zonal_light(k, bands, a, factor);
    return k;
}

/* ---- windows of width = bands ---- */

/* Taylor series, |v| <= pi: for constants alone */
static xreal x_cos(xreal v) {
    xreal term = 1, sum = 1;
    int k;
    for (k = 2; k < 60; k += 2) { term *= -v * v / ((xreal)k * (k - 1)); sum += term; }
    return sum;
}

void hann_weights(int bands, xreal *weight) {
    int l;
    for (l = 0; l < bands; l++) weight[l] = (1 + x_cos(x_pi() * l / bands)) / 2;
}

kernel *describe_sh_window_hann(int bands) {
    xreal weight[64];
    hann_weights(bands, weight);
    return scaled_bands("sh_window_hann", "Hann window as wide as the bands", bands, weight);
}

void lanczos_weights(int bands, xreal *weight) {
    int l;
    weight[0] = 1;
    for (l = 1; l < bands; l++) weight[l] = x_sin(x_pi() * l / bands) / (x_pi() * l / bands);
}

kernel *describe_sh_window_lanczos(int bands) {
    xreal weight[64];
    lanczos_weights(bands, weight);
    return scaled_bands("sh_window_lanczos", "Lanczos window as wide as the bands", bands, weight);
}

/* Coefficients by power of z: Legendre polynomials, times and over (z - root), products, integrals from -1 to 1 */
enum { DEGREE_MAX = 40 };
typedef struct polynomial { int degree; xreal c[DEGREE_MAX + 1]; } polynomial;

static polynomial legendre(int l) {
    polynomial p = { 0, { 1 } }, before = { 0, { 0 } };
    int k, i;
    for (k = 1; k <= l; k++) {
        polynomial next = { k, { 0 } };
        for (i = 0; i < k; i++) next.c[i + 1] += x_ratio(2 * k - 1, k) * p.c[i];
        for (i = 0; i + 1 < k; i++) next.c[i] -= x_ratio(k - 1, k) * before.c[i];
        before = p;
        p = next;
    }
    return p;
}

static xreal value(const polynomial *p, xreal z) {
    xreal v = 0;
    int i;
    for (i = p->degree; i >= 0; i--) v = v * z + p->c[i];
    return v;
}

static polynomial product(const polynomial *p, const polynomial *q) {
    polynomial r = { p->degree + q->degree, { 0 } };
    int i, j;
    for (i = 0; i <= p->degree; i++)
        for (j = 0; j <= q->degree; j++) r.c[i + j] += p->c[i] * q->c[j];
    return r;
}

static polynomial over_root(const polynomial *p, xreal root) {
    polynomial q = { p->degree - 1, { 0 } };
    xreal carry = 0;
    int i;
    for (i = p->degree; i > 0; i--) q.c[i - 1] = carry = p->c[i] + carry * root;
    return q;
}

/* The largest root, below 1: Newton's method from 1 falls to it monotonously */
static xreal largest_root(const polynomial *p) {
    xreal z = 1;
    int step, i;
    for (step = 0; step < 100; step++) {
        xreal slope = 0;
        for (i = p->degree; i > 0; i--) slope = slope * z + i * p->c[i];
        z -= value(p, z) / slope;
    }
    return z;
}

static xreal integral(const polynomial *p) {
    xreal sum = 0;
    int i;
    for (i = 0; i <= p->degree; i += 2) sum += p->c[i] * x_ratio(2, i + 1);
    return sum;
}

/* The sharpest non-negative kernel of degree d = bands-1: [P_k+1(z)/(z-z*)]^2 for d = 2k,
   (1+z) [P^(0,1)_k+1(z)/(z-z*)]^2 for d = 2k+1, where (1+z) P^(0,1)_k+1 is P_k+1 + P_k+2 up to a factor; weights
   are its Legendre moments over the 0th. */
void positive_weights(int bands, xreal *weight) {
    int d = bands - 1, k = d / 2, l, i;
    polynomial p = legendre(k + 1), kernel_of_z;
    if (d & 1) {
        polynomial q = legendre(k + 2);
        for (i = 0; i <= k + 1; i++) q.c[i] += p.c[i];
        p = over_root(&q, -1);
    }
    p = over_root(&p, largest_root(&p));
    kernel_of_z = product(&p, &p);
    if (d & 1) {
        polynomial one_plus_z = { 1, { 1, 1 } };
        kernel_of_z = product(&kernel_of_z, &one_plus_z);
    }
    for (l = 0; l < bands; l++) {
        polynomial moment = legendre(l);
        moment = product(&moment, &kernel_of_z);
        weight[l] = integral(&moment) / integral(&kernel_of_z);
    }
}

kernel *describe_sh_window_positive(int bands) {
    xreal weight[64];
    positive_weights(bands, weight);
    return scaled_bands("sh_window_positive", "positive window as wide as the bands", bands, weight);
}

/* What prt_sh_dering does once its strength is found, 0 to 2: w(l) = 1 + s (p(l) - 1) to 1, (2 - s) p(l) from there */
kernel *describe_sh_window_dering(int bands) {
    kernel *k = named_kernel("sh_window_dering", "smoothing by the strength that prt_sh_dering returns", bands);
    node s = real_param(k, "strength"), one = k_const(k, 1), rest = k_sub(k, k_const(k, 2), s), f[64 * 64];
    xreal p[64];
    int l, i;
    positive_weights(bands, p);
    input_nodes(k, "f", bands * bands, f);
    for (l = 1; l < bands; l++) {
        node weight = k_select(k, one, s, k_scale(k, p[l], rest), k_sub(k, one, k_scale(k, 1 - p[l], s)));
        for (i = l * l; i < (l + 1) * (l + 1); i++) f[i] = k_mul(k, weight, f[i]);
    }
    output_nodes(k, "out", bands * bands, f);
    return k;
}

/* double prt__window_NAME()[(width-1) width/2 + l]: the weights of windows of width 1 ... widest */
static void print_window_table(FILE *to, const char *name, void (*weights)(int, xreal *), int widest) {
    int width, l, column = 0;
    fprintf(to, "/* %s windows: weight of band l for width 1 ... %d at (width-1) width/2 + l */\n", name, widest);
    fprintf(to, "PRT__STATIC const double *prt__window_%s(void) {\n    static const double table[%d] = {\n", name,
            widest * (widest + 1) / 2);
    for (width = 1; width <= widest; width++) {
        xreal weight[64];
        weights(width, weight);
        for (l = 0; l < width; l++) {
            char text[64];
            int last = width == widest && l + 1 == width;
            x_print(weight[l], 20, text);
            column += fprintf(to, "%s%s%s", column ? " " : "        ", text, last ? "" : ",");
            if (column > 92 || last) { fprintf(to, "\n"); column = 0; }
        }
    }
    fprintf(to, "    };\n    return table;\n}\n\n");
}

void print_window_tables(FILE *to, int widest) {
    print_window_table(to, "hann", hann_weights, widest);
    print_window_table(to, "lanczos", lanczos_weights, widest);
    print_window_table(to, "positive", positive_weights, widest);
}
