/* published_rotation.h - the recursion of [Ivanic 1996], with the corrections of 1998 and nothing else: for comparison with
   prt_sh_rotation, which takes other columns near the edges. Include prt.h first, or define PUBLISHED_REAL and its root. */
#ifndef PUBLISHED_ROTATION_H
#define PUBLISHED_ROTATION_H

#ifndef PUBLISHED_REAL
#  define PUBLISHED_REAL prt_real
#  define PUBLISHED_ROOT(v) ((prt_real)sqrt((double)(v)))
#endif
typedef PUBLISHED_REAL published_real;

/* P_i(a) at column k: row a of block l-1 (last), row i of block 1. */
static inline published_real published_product(int l, const published_real *block1, const published_real *last, int i, int a,
                                        int k) {
    const published_real *q = last + (a + l - 1) * (2 * l - 1) + (l - 1), *r = block1 + (i + 1) * 3 + 1;
    if (k == l) return r[1] * q[l - 1] - r[-1] * q[1 - l];
    if (k == -l) return r[1] * q[1 - l] + r[-1] * q[l - 1];
    return r[0] * q[k];
}

static inline published_real published_entry(int l, const published_real *block1, const published_real *last, int m, int k) {
    int am = m < 0 ? -m : m, s = m < 0 ? -1 : 1;
    published_real d = k == l || k == -l ? (published_real)(2 * l * (2 * l - 1)) : (published_real)((l + k) * (l - k));
    published_real u = PUBLISHED_ROOT((published_real)((l + m) * (l - m)) / d), sum = 0;
    published_real v = PUBLISHED_ROOT((published_real)((m ? 1 : 2) * (l + am - 1) * (l + am)) / d) / 2;
    published_real w = -PUBLISHED_ROOT((published_real)((l - am - 1) * (l - am)) / d) / 2;
#define P(i, a) published_product(l, block1, last, i, a, k)
    if (am < l) sum = u * P(0, m);
    if (m == 0) return sum - v * (P(1, 1) + P(-1, -1));
    if (am == 1) sum += v * PUBLISHED_ROOT((published_real)2) * P(s, 0);
    else sum += v * (P(1, m - s) - (published_real)s * P(-1, s - m));
    if (am < l - 1) sum += w * (P(1, m + s) + (published_real)s * P(-1, -m - s));
#undef P
    return sum;
}

/* Block l >= 2 from blocks 1 and l-1, all row-major. */
static inline void published_block(int l, const published_real *block1, const published_real *last, published_real *block) {
    int m, k;
    for (m = -l; m <= l; m++)
        for (k = -l; k <= l; k++) *block++ = published_entry(l, block1, last, m, k);
}

/* Largest entry of |M M^T - 1| of a square matrix; NaN comes out as infinity. */
static inline double orthogonality_error(int size, const published_real *m) {
    double worst = 0;
    int i, j, k;
    for (i = 0; i < size; i++)
        for (j = 0; j <= i; j++) {
            double dot = i == j ? -1 : 0;
            for (k = 0; k < size; k++) dot += (double)m[i * size + k] * (double)m[j * size + k];
            if (!(fabs(dot) <= worst)) worst = dot == dot ? fabs(dot) : HUGE_VAL;
        }
    return worst;
}

#endif
