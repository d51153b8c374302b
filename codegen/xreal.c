#include "xreal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* pi as a sum of three doubles: 1e-48 away from the truth */
xreal x_pi(void) {
    return (xreal)3.141592653589793116 + (xreal)1.2246467991473532072e-16 - (xreal)2.9947698097183396659e-33;
}

xreal x_ratio(long numerator, long denominator) { return (xreal)numerator / (xreal)denominator; }

xreal x_sqrt(xreal v) {
    xreal s;
    int i;
    if (!(v > 0)) return 0;
    s = (xreal)sqrt((double)v);
    for (i = 0; i < 3; i++) s = (s + v / s) / 2;      /* Newton: 53, 106, 113 bits */
    return s;
}

xreal x_sin(xreal v) {
    xreal term = v, sum = v;
    int k;
    for (k = 2; k < 60; k += 2) {
        term *= -v * v / ((xreal)k * (k + 1));
        sum += term;
    }
    return sum;
}

/* Newton on P(count) from Tricomi's guess; nodes descend from +1. */
void x_gauss(int count, int i, xreal *z, xreal *w) {
    xreal x = (xreal)cos(3.141592653589793 * (i + 0.75) / (count + 0.5)), slope = 1;
    int step, k;
    for (step = 0; step < 7; step++) {
        xreal p1 = 1, p2 = 0;
        for (k = 1; k <= count; k++) {
            xreal p = ((2 * k - 1) * x * p1 - (k - 1) * p2) / k;
            p2 = p1;
            p1 = p;
        }
        slope = count * (x * p1 - p2) / (x * x - 1);
        x -= p1 / slope;
    }
    if (2 * i + 1 == count) x = 0;
    *z = x;
    *w = 2 / ((1 - x * x) * slope * slope);
}

xreal x_harmonic(int l, int m, xreal z) {
    xreal p1 = x_sqrt(1 / (4 * x_pi())), p2 = 0, s = x_sqrt(1 - z * z);
    int k;
    for (k = 1; k <= m; k++) p1 *= s * x_sqrt(x_ratio(2L * k + 1, 2L * k));
    for (k = m + 1; k <= l; k++) {
        xreal a = x_sqrt(x_ratio(4L * k * k - 1, (long)k * k - (long)m * m));
        xreal b = x_sqrt(x_ratio((long)(k - 1) * (k - 1) - (long)m * m, 4L * (k - 1) * (k - 1) - 1));
        xreal p = a * (z * p1 - b * p2);
        p2 = p1;
        p1 = p;
    }
    return p1;
}

/* Rounds to nearest at the last digit; a tie may go either way, but no irrational meets one. */
void x_print(xreal v, int digits, char *text) {
    char digit[48] = { 0 };
    int exponent = 0, i, last;
    xreal scale = 1, rest;
    if (v == 0) { strcpy(text, "0.0"); return; }
    if (v < 0) { *text++ = '-'; v = -v; }
    while (v / scale >= 10) { scale *= 10; exponent++; }
    while (v / scale < 1)   { scale /= 10; exponent--; }
    rest = v / scale;
    for (i = 0; i <= digits; i++) {
        int d = (int)rest;
        digit[i] = (char)d;
        rest = (rest - d) * 10;
    }
    if (digit[digits] >= 5) {
        for (i = digits - 1; i >= 0 && ++digit[i] == 10; i--) digit[i] = 0;
        if (i < 0) { memmove(digit + 1, digit, (size_t)digits - 1); digit[0] = 1; exponent++; }
    }
    for (last = digits - 1; last > 0 && digit[last] == 0; last--) {}
    if (exponent >= 0 && exponent < 16) {              /* 12.5, 1200.0 */
        for (i = 0; i <= exponent; i++) *text++ = (char)('0' + (i <= last ? digit[i] : 0));
        *text++ = '.';
        if (last <= exponent) *text++ = '0';
        for (; i <= last; i++) *text++ = (char)('0' + digit[i]);
        *text = 0;
    } else if (exponent < 0 && exponent >= -5) {       /* 0.00012 */
        *text++ = '0';
        *text++ = '.';
        for (i = exponent + 1; i < 0; i++) *text++ = '0';
        for (i = 0; i <= last; i++) *text++ = (char)('0' + digit[i]);
        *text = 0;
    } else {                                           /* 1.2e-9 */
        *text++ = (char)('0' + digit[0]);
        *text++ = '.';
        if (!last) *text++ = '0';
        for (i = 1; i <= last; i++) *text++ = (char)('0' + digit[i]);
        sprintf(text, "e%d", exponent);
    }
}
