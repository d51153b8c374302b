/* Kernels of the room >>rotate: one rotation of one vector, without a matrix for any band above 2.

   R = Rz(a) Ry(b) Rz(g), and Ry(b) = S Rz(-b) S with S the swap of y and z, which is its own inverse. A turn about z
   mixes only (l,m) with (l,-m), and the matrix of S is constant, symmetric, and three quarters empty [Pinchon 2007]. */
#include "kernels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 8, SIZE = 2 * LARGEST - 1 };

/* ---- matrices of any rotation or reflection, band by band [Ivanic 1996] ---- */

typedef struct blocks { node at[LARGEST][SIZE][SIZE]; } blocks;        /* [l][l+m][l+k] */

/* Within |k| <= this, P_i(a) is a product; outside it is the form that the paper has for |k| = l alone (see prt.h) */
static int inner_columns(int l) { return (7 * l - 1) / 10; }

static node above(kernel *k, const blocks *b, int i, int l, int a, int column) {       /* P_i(a) at this column */
    const node *q = b->at[l - 1][a + l - 1] + (l - 1), *r = b->at[1][i + 1];
    if (column > inner_columns(l)) return k_sub(k, k_mul(k, r[2], q[column - 1]), k_mul(k, r[0], q[1 - column]));
    if (column < -inner_columns(l)) return k_add(k, k_mul(k, r[2], q[column + 1]), k_mul(k, r[0], q[-1 - column]));
    return k_mul(k, r[1], q[column]);
}

static node block_entry(kernel *k, const blocks *b, int l, int m, int column) {
    int am = abs(m), ac = abs(column), s = m < 0 ? -1 : 1;
    long d = ac > inner_columns(l) ? (long)(l + ac) * (l + ac - 1) : (long)(l + ac) * (l - ac);
    xreal u = x_sqrt(x_ratio((long)(l + m) * (l - m), d));
    xreal v = x_sqrt(x_ratio((m ? 1L : 2L) * (l + am - 1) * (l + am), d)) / 2;
    xreal w = x_sqrt(x_ratio((long)(l - am - 1) * (l - am), d)) / 2;
    node sum = am < l ? k_scale(k, u, above(k, b, 0, l, m, column)) : k_const(k, 0), pair;
    if (m == 0) {
        pair = k_add(k, above(k, b, 1, l, 1, column), above(k, b, -1, l, -1, column));
        return k_sub(k, sum, k_scale(k, v, pair));
    }
    if (am == 1) {
        sum = k_add(k, sum, k_scale(k, v * x_sqrt(2), above(k, b, s, l, 0, column)));
    } else {
        pair = k_sub(k, above(k, b, 1, l, m - s, column), k_scale(k, s, above(k, b, -1, l, s - m, column)));
        sum = k_add(k, sum, k_scale(k, v, pair));
    }
    if (am >= l - 1) return sum;
    pair = k_add(k, above(k, b, 1, l, m + s, column), k_scale(k, s, above(k, b, -1, l, -m - s, column)));
    return k_sub(k, sum, k_scale(k, w, pair));
}

static void rotation_blocks(kernel *k, int bands, const node r[9], blocks *b) {
    static const int axis[3] = { 1, 2, 0 };            /* band 1 is R in the order y, z, x */
    int l, row, column;
    b->at[0][0][0] = k_const(k, 1);
    for (row = 0; row < 3; row++)
        for (column = 0; column < 3; column++) b->at[1][row][column] = r[3 * axis[row] + axis[column]];
    for (l = 2; l < bands; l++)
        for (row = -l; row <= l; row++)
            for (column = -l; column <= l; column++)
                b->at[l][l + row][l + column] = block_entry(k, b, l, row, column);
}

/* Blocks one after the other, as prt_sh_rotation writes them */
static int block_offset(int l) { return l * (4 * l * l - 1) / 3; }

kernel *describe_sh_rotation(int bands) {
    kernel *k = named_kernel("sh_rotation", "matrices of a rotation or reflection", bands);
    static blocks b;
    node r[9];
    int out, l, row, column;
    input_nodes(k, "r", 9, r);
    out = kernel_param(k, "blocks", PARAM_OUTPUT, block_offset(bands));
    rotation_blocks(k, bands, r, &b);
    for (l = 0; l < bands; l++)
        for (row = 0; row <= 2 * l; row++)
            for (column = 0; column <= 2 * l; column++)
                kernel_output(k, out, block_offset(l) + row * (2 * l + 1) + column, b.at[l][row][column]);
    return k;
}

kernel *describe_sh_rotate_by(int bands) {
    kernel *k = named_kernel("sh_rotate_by", "rotation of one vector by the matrices of sh_rotation", bands);
    int b = kernel_param(k, "blocks", PARAM_INPUT, block_offset(bands)), l, row, column;
    int f = kernel_param(k, "f", PARAM_INPUT, bands * bands), out = kernel_param(k, "out", PARAM_OUTPUT, bands * bands);
    for (l = 0; l < bands; l++)
        for (row = 0; row <= 2 * l; row++) {
            node sum = k_const(k, 0);
            for (column = 0; column <= 2 * l; column++)
                sum = k_madd(k, k_element(k, b, block_offset(l) + row * (2 * l + 1) + column),
                             k_element(k, f, l * l + column), sum);
            kernel_output(k, out, l * l + row, sum);
        }
    return k;
}

/* ---- the matrices of the swap ---- */

/* Every entry is the root of an integer over 2^(l-1): rounded to that form it is exact, ones and zeros among them. */
static xreal exact(int l, xreal v) {
    xreal scale = (xreal)(1L << (l - 1)), square = v * v * scale * scale, off;
    long whole = (long)(square + x_ratio(1, 2));
    off = square - (xreal)whole;
    if (off > 1e-15L || off < -1e-15L) { fprintf(stderr, "prt_codegen: swap of band %d is off\n", l); exit(1); }
    return (v < 0 ? -1 : 1) * x_sqrt((xreal)whole) / scale;
}

static xreal swap_entry(int l, int m, int column) {
    static xreal swap[LARGEST][SIZE][SIZE];
    if (swap[0][0][0] == 0) {
        static const int yz[9] = { 1, 0, 0, 0, 0, 1, 0, 1, 0 };        /* y and z trade places, x stays */
        static blocks b;
        kernel *k = kernel_new("swap", "constants alone");
        node r[9];
        int i, row, c;
        for (i = 0; i < 9; i++) r[i] = k_const(k, yz[i]);
        rotation_blocks(k, LARGEST, r, &b);
        for (i = 0; i < LARGEST; i++)
            for (row = 0; row <= 2 * i; row++)
                for (c = 0; c <= 2 * i; c++) {
                    xreal v = k->nodes[b.at[i][row][c]].value;
                    swap[i][row][c] = i < 2 ? v : exact(i, v);
                }
        kernel_free(k);
    }
    return swap[l][l + m][l + column];
}

/* ---- the same in float ----

   A turn swaps twice, and a thousand small turns two thousand times: what matters is that the swap of the rounded
   matrix is still its own inverse, not that each entry is the nearest. So the entries of a band are rounded
   together, each to one of the four nearest floats, for the least |J J - 1|, and for a trace of it near 0, which would
   make vectors grow or shrink whatever the axis. Found from several starts, by changing one entry or two at a time; in
   integers, entries in units of 2^-30, as any machine must find the same. */

enum { NEAR = 4, STARTS = 12, UNIT_BITS = 30 };
typedef struct entry { int row, column; long long value[NEAR]; } entry;
typedef struct swap_search {
    long long matrix[SIZE][SIZE];
    entry entries[SIZE * SIZE];
    int l, count;
} swap_search;

static float rounded[LARGEST][SIZE][SIZE];

static long long not_inverse(const swap_search *s) {
    const long long one = 1LL << 2 * UNIT_BITS;
    long long sum = 0, trace = 0;
    int i, j, k, size = 2 * s->l + 1;
    for (i = 0; i < size; i++)
        for (j = 0; j <= i; j++) {
            long long dot = i == j ? -one : 0;
            for (k = 0; k < size; k++) dot += s->matrix[i][k] * s->matrix[k][j];
            dot /= 1024;                                       /* the square fits */
            sum += dot * dot;
            if (i == j) trace += dot;
        }
    return sum + trace * trace;
}

static void put(swap_search *s, const entry *e, long long value) {
    s->matrix[e->row][e->column] = s->matrix[e->column][e->row] = value;
}

static xreal away(float value, xreal exact_value) {
    xreal d = (xreal)value - exact_value;
    return d < 0 ? -d : d;
}

/* The floats nearest to a value, in this order */
static void nearest_floats(xreal exact_value, long long *value) {
    float nearest = (float)exact_value, low = nextafterf(nearest, -2), high = nextafterf(nearest, 2);
    int i;
    for (i = 0; i < NEAR; i++) {
        value[i] = (long long)ldexpf(nearest, UNIT_BITS);
        nearest = away(low, exact_value) < away(high, exact_value) ? low : high;
        if (nearest == low) low = nextafterf(low, -2);
        else high = nextafterf(high, 2);
    }
}

static void collect_entries(swap_search *s) {
    int i, j;
    for (i = 0; i <= 2 * s->l; i++)
        for (j = 0; j <= i; j++) {
            entry *e = &s->entries[s->count];
            if (swap_entry(s->l, i - s->l, j - s->l) == 0) continue;
            e->row = i;
            e->column = j;
            nearest_floats(swap_entry(s->l, i - s->l, j - s->l), e->value);
            s->count++;
        }
}

/* Other values of a and b, where those are better; b may be a. */
static int improve(swap_search *s, const entry *a, const entry *b, long long *least) {
    long long best_a = s->matrix[a->row][a->column], best_b = s->matrix[b->row][b->column];
    int i, j, better = 0;
    for (i = 0; i < NEAR; i++)
        for (j = 0; j < (a == b ? 1 : NEAR); j++) {
            long long now;
            put(s, b, b->value[j]);
            put(s, a, a->value[i]);
            now = not_inverse(s);
            if (now >= *least) continue;
            *least = now;
            best_a = a->value[i];
            best_b = b->value[j];
            better = 1;
        }
    put(s, b, best_b);
    put(s, a, best_a);
    return better;
}

static long long improve_all(swap_search *s) {
    long long least = not_inverse(s);
    int i, j, better = 1;
    while (better) {
        better = 0;
        for (i = 0; i < s->count; i++)
            for (j = 0; j <= i; j++) better |= improve(s, &s->entries[i], &s->entries[j], &least);
    }
    return least;
}

static void round_together(int l) {
    static swap_search s;
    long long least = 0;
    unsigned random = 1;
    int start, i, j;
    memset(&s, 0, sizeof s);
    s.l = l;
    collect_entries(&s);
    for (start = 0; start < STARTS; start++) {
        long long now;
        for (i = 0; i < s.count; i++) {
            random = random * 1664525u + 1013904223u;
            put(&s, &s.entries[i], s.entries[i].value[start ? random >> 30 : 0]);
        }
        now = improve_all(&s);
        if (start && now >= least) continue;
        least = now;
        for (i = 0; i <= 2 * l; i++)
            for (j = 0; j <= 2 * l; j++) rounded[l][i][j] = ldexpf((float)s.matrix[i][j], -UNIT_BITS);
    }
}

static float swap_entry_float(int l, int m, int k) {
    if (rounded[l][l][l] == 0 && rounded[l][0][2 * l] == 0 && rounded[l][0][2 * l - 1] == 0) round_together(l);
    return rounded[l][l + m][l + k];
}

/* ---- one vector, straight-line ---- */

typedef struct angle { node cos[LARGEST], sin[LARGEST]; } angle;       /* of m times the angle */

static void multiples(kernel *k, int bands, node cosine, node sine, angle *x) {
    int m;
    x->cos[1] = cosine;
    x->sin[1] = sine;
    for (m = 2; m < bands; m++) {
        x->cos[m] = k_sub(k, k_mul(k, x->cos[1], x->cos[m - 1]), k_mul(k, x->sin[1], x->sin[m - 1]));
        x->sin[m] = k_add(k, k_mul(k, x->sin[1], x->cos[m - 1]), k_mul(k, x->cos[1], x->sin[m - 1]));
    }
}

static void turn_z(kernel *k, int l, const angle *x, int direction, node *f) {         /* f[l+m] */
    int m;
    for (m = 1; m <= l; m++) {
        node c = f[l + m], s = f[l - m], cc = k_mul(k, x->cos[m], c), ss = k_mul(k, x->sin[m], s);
        node cs = k_mul(k, x->cos[m], s), sc = k_mul(k, x->sin[m], c);
        f[l + m] = direction > 0 ? k_sub(k, cc, ss) : k_add(k, cc, ss);
        f[l - m] = direction > 0 ? k_add(k, cs, sc) : k_sub(k, cs, sc);
    }
}

static void swap_yz(kernel *k, int l, node *f) {
    node g[SIZE];
    int row, column;
    for (row = -l; row <= l; row++) {
        g[l + row] = k_const(k, 0);
        for (column = -l; column <= l; column++)
            g[l + row] = k_add(k, g[l + row], k_scale(k, swap_entry(l, row, column), f[l + column]));
    }
    for (row = 0; row <= 2 * l; row++) f[row] = g[row];
}

/* Band 1 is R in the order y, z, x. */
static void rotate_band_1(kernel *k, const node *r, node *f) {
    static const int axis[3] = { 1, 2, 0 };
    node g[3];
    int i, j;
    for (i = 0; i < 3; i++) {
        g[i] = k_const(k, 0);
        for (j = 0; j < 3; j++) g[i] = k_add(k, g[i], k_mul(k, r[3 * axis[i] + axis[j]], f[j]));
    }
    for (i = 0; i < 3; i++) f[i] = g[i];
}

/* Band 2 alone, where the angles would not pay: the quadratic form x.A x without trace turns into R A R^T. */
static void rotate_band_2(kernel *k, const node *r, node *f) {
    node third = k_scale(k, 1 / x_sqrt(3), f[2]), a[3][3], b[3][3], yy, zz;
    int i, j;
    a[0][0] = k_sub(k, f[4], third);
    a[1][1] = k_neg(k, k_add(k, f[4], third));
    a[2][2] = k_scale(k, 2, third);
    a[0][1] = a[1][0] = f[0];
    a[1][2] = a[2][1] = f[1];
    a[0][2] = a[2][0] = f[3];
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            b[i][j] = k_madd(k, r[3 * i + 2], a[2][j], k_madd(k, r[3 * i + 1], a[1][j], k_mul(k, r[3 * i], a[0][j])));
#define PART(i, j) k_madd(k, b[i][2], r[3 * j + 2], k_madd(k, b[i][1], r[3 * j + 1], k_mul(k, b[i][0], r[3 * j])))
    yy = PART(1, 1);
    zz = PART(2, 2);
    f[0] = PART(0, 1);
    f[1] = PART(1, 2);
    f[2] = k_scale(k, x_sqrt(3) / 2, zz);
    f[3] = PART(0, 2);
    f[4] = k_neg(k, k_add(k, yy, k_scale(k, x_ratio(1, 2), zz)));
#undef PART
}

void rotate_nodes(kernel *k, int bands, const node *r, const node turn[6], node *f) {
    angle a, b, g;
    int l;
    if (bands > 1) rotate_band_1(k, r, f + 1);
    if (bands == 3) rotate_band_2(k, r, f + 4);
    if (bands < 4) return;
    multiples(k, bands, turn[0], turn[1], &a);
    multiples(k, bands, turn[2], turn[3], &b);
    multiples(k, bands, turn[4], turn[5], &g);
    for (l = 2; l < bands; l++) {
        node *band = f + l * l;
        turn_z(k, l, &g, 1, band);
        swap_yz(k, l, band);
        turn_z(k, l, &b, -1, band);
        swap_yz(k, l, band);
        turn_z(k, l, &a, 1, band);
    }
}

kernel *describe_sh_rotate(int bands) {
    kernel *k = named_kernel("sh_rotate", "rotation of one vector by r and by turn, cos and sin of a, b, g", bands);
    node r[9], turn[6], f[LARGEST * LARGEST];
    int pturn, i;
    input_nodes(k, "r", 9, r);
    pturn = kernel_param(k, "turn", PARAM_INPUT, 6);
    input_nodes(k, "f", bands * bands, f);
    for (i = 0; i < 6; i++) turn[i] = k_element(k, pturn, i);
    rotate_nodes(k, bands, r, turn, f);
    output_nodes(k, "out", bands * bands, f);
    return k;
}

/* ---- for languages: everything from the matrix ---- */

/* As in prt.h: the last row holds the phasor of g times sin b, the upper left corner that of a + g times 1 + cos b
   and that of a - g times 1 - cos b, of which the larger serves. Where sin b = 0, g = 0. */
void rotation_turn(kernel *k, const node r[9], node turn[6]) {
    node zero = k_const(k, 0), one = k_const(k, 1), sine = k_sqrt(k, k_madd(k, r[6], r[6], k_mul(k, r[7], r[7])));
    node side = k_select(k, r[8], zero, k_const(k, -1), one), over = k_div(k, one, k_add(k, one, k_mul(k, side, r[8])));
    node x = k_mul(k, over, k_add(k, r[4], k_mul(k, side, r[0]))),
        y = k_mul(k, over, k_sub(k, r[3], k_mul(k, side, r[1])));
    turn[4] = k_select(k, zero, sine, k_div(k, k_neg(k, r[6]), sine), one);
    turn[5] = k_select(k, zero, sine, k_div(k, r[7], sine), zero);
    turn[0] = k_madd(k, x, turn[4], k_mul(k, y, turn[5]));
    turn[1] = k_mul(k, side, k_sub(k, k_mul(k, y, turn[4]), k_mul(k, x, turn[5])));
    turn[2] = r[8];
    turn[3] = sine;
}

kernel *describe_sh_turn(int bands) {
    kernel *k = kernel_new("sh_turn", "cos, sin of a, b, g with R = Rz(a) Ry(b) Rz(g)");
    node r[9], turn[6];
    (void)bands;
    input_nodes(k, "r", 9, r);
    rotation_turn(k, r, turn);
    output_nodes(k, "turn", 6, turn);
    return k;
}

/* A matrix of determinant -1 is -1 times a rotation, and M(-R) = (-1)^l M(R); bands 1, and 2 alone, take R as it is. */
void rotate_by_matrix(kernel *k, int bands, const node r[9], node *f) {
    node proper[9], turn[6] = { 0 }, zero = k_const(k, 0), one = k_const(k, 1), det = zero, side;
    int i, l;
    if (bands < 4) {
        rotate_nodes(k, bands, r, turn, f);
        return;
    }
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, h = (i + 2) % 3;
        det = k_madd(k, r[i], k_sub(k, k_mul(k, r[3 + j], r[6 + h]), k_mul(k, r[3 + h], r[6 + j])), det);
    }
    side = k_select(k, det, zero, k_const(k, -1), one);
    for (i = 0; i < 9; i++) proper[i] = k_mul(k, side, r[i]);
    rotation_turn(k, proper, turn);
    rotate_nodes(k, bands, r, turn, f);
    for (l = 3; l < bands; l += 2)
        for (i = l * l; i < (l + 1) * (l + 1); i++) f[i] = k_mul(k, side, f[i]);
}

kernel *describe_sh_rotate_matrix(int bands) {
    kernel *k = named_kernel("sh_rotate", "rotation or reflection of one vector by a matrix", bands);
    node r[9], f[LARGEST * LARGEST];
    input_nodes(k, "r", 9, r);
    input_nodes(k, "f", bands * bands, f);
    rotate_by_matrix(k, bands, r, f);
    output_nodes(k, "out", bands * bands, f);
    return k;
}

kernel *describe_sh_rotate_z(int bands) {
    kernel *k = named_kernel("sh_rotate_z", "rotation of one vector about z", bands);
    node angle_ = real_param(k, "angle"), f[LARGEST * LARGEST];
    angle x;
    int l;
    input_nodes(k, "f", bands * bands, f);
    multiples(k, bands, k_cos(k, angle_), k_sin(k, angle_), &x);
    for (l = 1; l < bands; l++) turn_z(k, l, &x, 1, f + l * l);
    output_nodes(k, "out", bands * bands, f);
    return k;
}

kernel *describe_rotation_from_quaternion(int bands) {
    kernel *k = kernel_new("rotation_from_quaternion", "the matrix of a quaternion w, x, y, z of any length but 0");
    node q[4], r[9], one = k_const(k, 1), s;
    int i;
    (void)bands;
    input_nodes(k, "q", 4, q);
    s = k_div(k, k_const(k, 2),
              k_madd(k, q[0], q[0], k_madd(k, q[1], q[1], k_madd(k, q[2], q[2], k_mul(k, q[3], q[3])))));
    for (i = 0; i < 3; i++) {
        int j = (i + 1) % 3, h = (i + 2) % 3;
        node u = q[1 + j], v = q[1 + h];
        r[3 * i + i] = k_sub(k, one, k_mul(k, s, k_madd(k, u, u, k_mul(k, v, v))));
        r[3 * i + j] = k_mul(k, s, k_sub(k, k_mul(k, q[1 + i], u), k_mul(k, q[0], v)));
        r[3 * j + i] = k_mul(k, s, k_add(k, k_mul(k, q[1 + i], u), k_mul(k, q[0], v)));
    }
    output_nodes(k, "r", 9, r);
    return k;
}

/* ---- the swap in SIMD: four lanes ----

   Cosines and sines of even and odd order make four classes of at most four coefficients up to band 7, and the swap
   takes a class to a class: a small matrix, written as a sum of shuffled vectors times constant ones. Bands 2 and 3
   share one set of vectors, and band 4, whose four turning pairs fill one vector each, mixes even and odd. A term
   names its vectors and the lane of them that each lane of the result takes (4 to 7: of the second); the constants
   follow from that and from the matrices, and it is checked that nothing is left out. */

enum { EVEN_COS, ODD_COS, EVEN_SIN, ODD_SIN, CLASSES };
static const char *const class_name[CLASSES] = { "even_cos", "odd_cos", "even_sin", "odd_sin" };

typedef struct label { int l, m; } label;              /* l = 0: a lane without meaning */
typedef struct swap_term { int to, from, second, lane[4]; } swap_term;
typedef struct swap_form {
    int first_band, last_band;
    label lanes[CLASSES][4];
    swap_term terms[16];                               /* of one class after those of another; lane[0] < 0 ends them */
} swap_form;

#define END { 0, 0, 0, { -1, 0, 0, 0 } }
static const swap_form forms[] = {
    { 2, 3, { { { 3, 0 }, { 3, 2 }, { 2, 0 }, { 2, 2 } }, { { 3, 1 }, { 3, 3 }, { 2, 1 }, { 0, 0 } },
              { { 0, 0 }, { 3, -2 }, { 0, 0 }, { 2, -2 } }, { { 3, -1 }, { 3, -3 }, { 2, -1 }, { 0, 0 } } },
      { { EVEN_COS, ODD_SIN, EVEN_COS, { 0, 1, 6, 7 } }, { EVEN_COS, ODD_SIN, EVEN_COS, { 1, 0, 7, 6 } },
        { ODD_COS, ODD_COS, EVEN_SIN, { 0, 1, 7, 7 } }, { ODD_COS, ODD_COS, EVEN_SIN, { 1, 0, 7, 7 } },
        { EVEN_SIN, EVEN_SIN, ODD_COS, { 1, 1, 6, 6 } },
        { ODD_SIN, EVEN_COS, ODD_SIN, { 0, 1, 6, 6 } }, { ODD_SIN, EVEN_COS, ODD_SIN, { 1, 0, 6, 6 } }, END } },
    { 4, 4, { { { 4, 2 }, { 4, 4 }, { 4, 1 }, { 4, 3 } }, { { 4, 0 }, { 0, 0 }, { 0, 0 }, { 0, 0 } },
              { { 4, -2 }, { 4, -4 }, { 4, -1 }, { 4, -3 } }, { { 0, 0 }, { 0, 0 }, { 0, 0 }, { 0, 0 } } },
      { { EVEN_COS, EVEN_COS, EVEN_SIN, { 0, 1, 4, 5 } }, { EVEN_COS, EVEN_COS, EVEN_SIN, { 1, 0, 5, 4 } },
        { EVEN_COS, ODD_COS, ODD_COS, { 0, 0, 0, 0 } },
        { ODD_COS, ODD_COS, ODD_COS, { 0, 1, 2, 3 } }, { ODD_COS, EVEN_COS, EVEN_COS, { 0, 1, 2, 3 } },
        { ODD_COS, EVEN_COS, EVEN_COS, { 1, 1, 1, 1 } },
        { EVEN_SIN, EVEN_COS, EVEN_SIN, { 2, 3, 6, 7 } }, { EVEN_SIN, EVEN_COS, EVEN_SIN, { 3, 2, 7, 6 } }, END } },
    { 5, 5, { { { 5, 0 }, { 5, 2 }, { 5, 4 }, { 0, 0 } }, { { 5, 1 }, { 5, 3 }, { 5, 5 }, { 0, 0 } },
              { { 0, 0 }, { 5, -2 }, { 5, -4 }, { 0, 0 } }, { { 5, -1 }, { 5, -3 }, { 5, -5 }, { 0, 0 } } },
      { { EVEN_COS, ODD_SIN, ODD_SIN, { 0, 1, 2, 3 } }, { EVEN_COS, ODD_SIN, ODD_SIN, { 1, 2, 0, 0 } },
        { EVEN_COS, ODD_SIN, ODD_SIN, { 2, 0, 1, 1 } },
        { ODD_COS, ODD_COS, ODD_COS, { 0, 1, 2, 3 } }, { ODD_COS, ODD_COS, ODD_COS, { 1, 2, 0, 0 } },
        { ODD_COS, ODD_COS, ODD_COS, { 2, 0, 1, 1 } },
        { EVEN_SIN, EVEN_SIN, EVEN_SIN, { 0, 1, 2, 3 } }, { EVEN_SIN, EVEN_SIN, EVEN_SIN, { 2, 2, 1, 1 } },
        { ODD_SIN, EVEN_COS, EVEN_COS, { 0, 1, 2, 3 } }, { ODD_SIN, EVEN_COS, EVEN_COS, { 1, 2, 0, 0 } },
        { ODD_SIN, EVEN_COS, EVEN_COS, { 2, 0, 1, 1 } }, END } },
    { 6, 6, { { { 6, 0 }, { 6, 2 }, { 6, 4 }, { 6, 6 } }, { { 6, 1 }, { 6, 3 }, { 6, 5 }, { 0, 0 } },
              { { 0, 0 }, { 6, -2 }, { 6, -4 }, { 6, -6 } }, { { 6, -1 }, { 6, -3 }, { 6, -5 }, { 0, 0 } } },
      { { EVEN_COS, EVEN_COS, EVEN_COS, { 0, 1, 2, 3 } }, { EVEN_COS, EVEN_COS, EVEN_COS, { 1, 2, 3, 0 } },
        { EVEN_COS, EVEN_COS, EVEN_COS, { 2, 3, 0, 1 } }, { EVEN_COS, EVEN_COS, EVEN_COS, { 3, 0, 1, 2 } },
        { ODD_COS, EVEN_SIN, EVEN_SIN, { 1, 2, 3, 3 } }, { ODD_COS, EVEN_SIN, EVEN_SIN, { 2, 3, 1, 1 } },
        { ODD_COS, EVEN_SIN, EVEN_SIN, { 3, 1, 2, 2 } },
        { EVEN_SIN, ODD_COS, ODD_COS, { 0, 0, 1, 2 } }, { EVEN_SIN, ODD_COS, ODD_COS, { 1, 1, 2, 0 } },
        { EVEN_SIN, ODD_COS, ODD_COS, { 2, 2, 0, 1 } },
        { ODD_SIN, ODD_SIN, ODD_SIN, { 0, 1, 2, 3 } }, { ODD_SIN, ODD_SIN, ODD_SIN, { 1, 2, 0, 0 } },
        { ODD_SIN, ODD_SIN, ODD_SIN, { 2, 0, 1, 1 } }, END } },
    { 7, 7, { { { 7, 0 }, { 7, 2 }, { 7, 4 }, { 7, 6 } }, { { 7, 1 }, { 7, 3 }, { 7, 5 }, { 7, 7 } },
              { { 0, 0 }, { 7, -2 }, { 7, -4 }, { 7, -6 } }, { { 7, -1 }, { 7, -3 }, { 7, -5 }, { 7, -7 } } },
      { { EVEN_COS, ODD_SIN, ODD_SIN, { 0, 1, 2, 3 } }, { EVEN_COS, ODD_SIN, ODD_SIN, { 1, 2, 3, 0 } },
        { EVEN_COS, ODD_SIN, ODD_SIN, { 2, 3, 0, 1 } }, { EVEN_COS, ODD_SIN, ODD_SIN, { 3, 0, 1, 2 } },
        { ODD_COS, ODD_COS, ODD_COS, { 0, 1, 2, 3 } }, { ODD_COS, ODD_COS, ODD_COS, { 1, 2, 3, 0 } },
        { ODD_COS, ODD_COS, ODD_COS, { 2, 3, 0, 1 } }, { ODD_COS, ODD_COS, ODD_COS, { 3, 0, 1, 2 } },
        { EVEN_SIN, EVEN_SIN, EVEN_SIN, { 0, 1, 2, 3 } }, { EVEN_SIN, EVEN_SIN, EVEN_SIN, { 2, 2, 3, 1 } },
        { EVEN_SIN, EVEN_SIN, EVEN_SIN, { 3, 3, 1, 2 } },
        { ODD_SIN, EVEN_COS, EVEN_COS, { 0, 1, 2, 3 } }, { ODD_SIN, EVEN_COS, EVEN_COS, { 1, 2, 3, 0 } },
        { ODD_SIN, EVEN_COS, EVEN_COS, { 2, 3, 0, 1 } }, { ODD_SIN, EVEN_COS, EVEN_COS, { 3, 0, 1, 2 } }, END } },
};
#undef END

/* The constants of a term, exact or in float, with each matrix entry counted as done; 1 if they are 1 in every lane
   that has a meaning. */
static int term_constants(const swap_form *form, const swap_term *t, int in_float, int done[LARGEST][SIZE][SIZE],
                          xreal *constant) {
    int i, ones = 1;
    for (i = 0; i < 4; i++) {
        label to = form->lanes[t->to][i];
        label from = t->lane[i] < 4 ? form->lanes[t->from][t->lane[i]] : form->lanes[t->second][t->lane[i] - 4];
        constant[i] = 0;
        if (!to.l || to.l != from.l || done[to.l][to.l + to.m][to.l + from.m]++) {
            ones &= !to.l;
            continue;
        }
        constant[i] = in_float ? (xreal)swap_entry_float(to.l, to.m, from.m) : swap_entry(to.l, to.m, from.m);
        ones &= constant[i] == 1;
    }
    return ones;
}

static void check_complete(const swap_form *form, int done[LARGEST][SIZE][SIZE]) {
    int l, m, k;
    for (l = form->first_band; l <= form->last_band; l++)
        for (m = -l; m <= l; m++)
            for (k = -l; k <= l; k++)
                if (swap_entry(l, m, k) != 0 && !done[l][l + m][l + k]) {
                    fprintf(stderr, "prt_codegen: the terms of band %d leave out entry (%d,%d)\n", l, m, k);
                    exit(1);
                }
}

static void print_source(FILE *to, const swap_term *t) {
    if (t->from == t->second && t->lane[0] == 0 && t->lane[1] == 1 && t->lane[2] == 2 && t->lane[3] == 3)
        fprintf(to, "%s", class_name[t->from]);
    else
        fprintf(to, "PRT__QUAD_SHUFFLE(%s, %s, %d, %d, %d, %d)", class_name[t->from], class_name[t->second], t->lane[0],
                t->lane[1], t->lane[2], t->lane[3]);
}

/* The table of constants; product[term] = its row there + 1, or 0. */
static void print_swap_constants(FILE *to, const swap_form *form, int in_float, int *product) {
    int done[LARGEST][SIZE][SIZE] = { { { 0 } } }, i, rows = 0;
    const swap_term *t;
    fprintf(to, "    static const prt_real c[][4] = {\n");
    for (t = form->terms; t->lane[0] >= 0; t++) {
        xreal constant[4];
        if (term_constants(form, t, in_float, done, constant)) continue;
        product[t - form->terms] = ++rows;
        fprintf(to, "%s        { ", rows > 1 ? ",\n" : "");
        for (i = 0; i < 4; i++) {
            char text[64];
            x_print(constant[i], in_float ? 9 : 21, text);
            fprintf(to, constant[i] == 0 ? "%s0" : in_float ? "%s%sf" : "%s%s", i ? ", " : "", text);
        }
        fprintf(to, " }");
    }
    check_complete(form, done);
    fprintf(to, "\n    };\n");
}

static void print_swap_form(FILE *to, const swap_form *form) {
    const swap_term *t;
    int i, product[16] = { 0 }, used[CLASSES] = { 0 };
    fprintf(to, "/* y and z swapped in band%s %d", form->first_band < form->last_band ? "s" : "", form->first_band);
    if (form->first_band < form->last_band) fprintf(to, " and %d", form->last_band);
    fprintf(to, " */\nPRT__INLINE void prt__swap_yz_%d(prt__classes *v) {\n#ifdef PRT_DOUBLE\n", form->last_band);
    print_swap_constants(to, form, 0, product);
    fprintf(to, "#else\n");
    print_swap_constants(to, form, 1, product);
    fprintf(to, "#endif\n");
    for (t = form->terms; t->lane[0] >= 0; t++) used[t->from] = used[t->second] = 1;
    for (i = 0; i < CLASSES; i++)
        if (used[i]) fprintf(to, "    prt__quad %s = v->%s;\n", class_name[i], class_name[i]);
    for (t = form->terms; t->lane[0] >= 0; t++) {
        int row = product[t - form->terms], first = t == form->terms || t[-1].to != t->to;
        fprintf(to, "    v->%s %s ", class_name[t->to], first ? "=" : "+=");
        if (row) fprintf(to, "prt__quad_load(c[%d]) * ", row - 1);
        print_source(to, t);
        fprintf(to, ";\n");
    }
    fprintf(to, "}\n\n");
}

void print_swaps(FILE *to) {
    size_t i;
    for (i = 0; i < sizeof forms / sizeof forms[0]; i++) print_swap_form(to, &forms[i]);
}
