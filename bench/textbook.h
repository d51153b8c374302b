/* textbook.h - SH as most textbooks print it: Y(l,m) = K(l,m) P(l,|m|)(cos t) {sqrt2 sin(|m| p), 1, sqrt2 cos(m p)},
   with factorials, sin t = sqrt(1 - z^2) and an angle from atan2. Here to show what that costs in time and accuracy.
   Include after prt.h. */
#ifndef BENCH_TEXTBOOK_H
#define BENCH_TEXTBOOK_H

#include <math.h>

#ifdef PRT_DOUBLE
#  define TEXTBOOK(function) function
#else
#  define TEXTBOOK(function) function##f
#endif

static __attribute__((unused)) prt_real textbook_factorial(int k) {
    prt_real product = 1;
    for (; k > 1; k--) product *= (prt_real)k;
    return product;
}

static __attribute__((unused)) prt_real textbook_legendre(int l, int m, prt_real z) {
    prt_real sine = TEXTBOOK(sqrt)((1 - z) * (1 + z)), p = 1, above, next;
    int k;
    for (k = 1; k <= m; k++) p *= (prt_real)(2 * k - 1) * sine;
    if (l == m) return p;
    above = z * (prt_real)(2 * m + 1) * p;
    for (k = m + 2; k <= l; k++) {
        next = ((prt_real)(2 * k - 1) * z * above - (prt_real)(k + m - 1) * p) / (prt_real)(k - m);
        p = above;
        above = next;
    }
    return above;
}

static __attribute__((unused)) void textbook_sh(int bands, prt_vec3 d, prt_real *y) {
    prt_real angle = TEXTBOOK(atan2)(d.y, d.x);
    int l, m;
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            prt_real k = TEXTBOOK(sqrt)((prt_real)(2 * l + 1) / (prt_real)12.566370614359172954 *
                                        textbook_factorial(l - m) / textbook_factorial(l + m));
            prt_real kp = k * textbook_legendre(l, m, d.z) * (m ? (prt_real)1.41421356237309504880 : 1);
            y[l * (l + 1) + m] = kp * TEXTBOOK(cos)((prt_real)m * angle);
            if (m) y[l * (l + 1) - m] = kp * TEXTBOOK(sin)((prt_real)m * angle);
        }
}

#endif
