/* Functions that languages compute too coarsely (Vulkan and WebGPU ask 2^-11 of a sine, 4096 ulp of an arc cosine) as
   polynomials, so that the values do not depend on the driver. Chebyshev interpolation, in 113 bits. */
#include "kernels.h"

enum { MOST = 12 };

/* Coefficients by power of t of the polynomial that meets f at the Chebyshev nodes of 0 ... 1, by divided
   differences. */
static void fit(xreal (*f)(xreal t), int degree, xreal *c) {
    xreal t[MOST], d[MOST];
    int i, j;
    for (i = 0; i <= degree; i++) {
        t[i] = (1 - x_sin(x_pi() * (2 * i - degree) / (2 * degree + 2))) / 2;
        d[i] = f(t[i]);
    }
    for (j = 1; j <= degree; j++)
        for (i = degree; i >= j; i--) d[i] = (d[i] - d[i - 1]) / (t[i] - t[i - j]);
    for (i = 0; i <= degree; i++) c[i] = 0;
    for (j = degree; j >= 0; j--) {                    /* c = c (t - t_j) + d_j */
        for (i = degree; i > 0; i--) c[i] = c[i - 1] - t[j] * c[i];
        c[0] = d[j] - t[j] * c[0];
    }
}

static node polynomial_of(kernel *k, xreal (*f)(xreal t), int degree, node t) {
    xreal c[MOST];
    node sum;
    int i;
    fit(f, degree, c);
    sum = k_const(k, c[degree]);
    for (i = degree - 1; i >= 0; i--) sum = k_madd(k, t, sum, k_const(k, c[i]));
    return sum;
}

/* sin(v)/v as a function of t = (2v/pi)^2 */
static xreal sine_over_angle(xreal t) {
    xreal v = x_sqrt(t) * x_pi() / 2;
    return x_sin(v) / v;
}

node k_sine(kernel *k, node angle) {
    node square = k_scale(k, 4 / (x_pi() * x_pi()), k_mul(k, angle, angle));
    return k_mul(k, angle, polynomial_of(k, sine_over_angle, 5, square));
}

/* acos(t)/sqrt(1-t): acos(t) = 2 asin(s), s = sqrt((1-t)/2) <= sqrt(1/2), and Newton for the arc sine */
static xreal arc_over_root(xreal t) {
    xreal s = x_sqrt((1 - t) / 2), v = s;
    int i;
    for (i = 0; i < 8; i++) {
        xreal sine = x_sin(v);
        v -= (sine - s) / x_sqrt(1 - sine * sine);
    }
    return 2 * v / x_sqrt(1 - t);
}

node k_arc_cosine(kernel *k, node cosine) {
    node one = k_const(k, 1), zero = k_const(k, 0), size = k_min(k, k_abs(k, cosine), one);
    node arc = k_mul(k, k_sqrt(k, k_sub(k, one, size)), polynomial_of(k, arc_over_root, 8, size));
    return k_select(k, cosine, zero, k_sub(k, k_const(k, x_pi()), arc), arc);
}

/* atan(v)/v as a function of t = v^2 */
static xreal arc_over_tangent(xreal t) {
    xreal v = x_sqrt(t);
    return arc_over_root(1 / x_sqrt(1 + t)) * x_sqrt(1 - 1 / x_sqrt(1 + t)) / v;
}

node k_arc_tangent(kernel *k, node y, node x) {
    node zero = k_const(k, 0), wide = k_abs(k, x), high = k_abs(k, y), large = k_max(k, wide, high), v, arc;
    v = k_select(k, zero, large, k_div(k, k_min(k, wide, high), large), zero);
    arc = k_mul(k, v, polynomial_of(k, arc_over_tangent, 9, k_mul(k, v, v)));
    arc = k_select(k, wide, high, k_sub(k, k_const(k, x_pi() / 2), arc), arc);
    arc = k_select(k, x, zero, k_sub(k, k_const(k, x_pi()), arc), arc);
    return k_select(k, y, zero, k_neg(k, arc), arc);
}

/* Languages leave 0 to the power 0 open, and some make every power of 0 not a number. */
node k_power(kernel *k, node base, node exponent) {
    node zero = k_const(k, 0), one = k_const(k, 1);
    return k_select(k, zero, exponent, k_select(k, zero, base, k_pow(k, base, exponent), zero), one);
}

static xreal falling_slope(xreal t) {                  /* (1 - e^-t)/t */
    xreal term = 1, sum = 1;
    int k;
    for (k = 2; k < 40; k++) { term *= -t / k; sum += term; }
    return sum;
}

node k_exponential_slope(kernel *k, node v) {
    node one = k_const(k, 1), t = k_neg(k, v), near = polynomial_of(k, falling_slope, 8, k_min(k, t, one));
    node far = k_div(k, k_sub(k, one, k_pow(k, k_const(k, 1 / (1 + falling_slope(-1))), t)), k_max(k, t, one));
    return k_select(k, one, t, far, near);
}
