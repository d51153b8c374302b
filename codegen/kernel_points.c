/* Kernels of the room >>product: the product of two SH functions of four or five bands by way of values at points.

   Four bands: the twelve corners of an icosahedron, weight 25/840, and the twenty of a dodecahedron, 27/840,
   integrate polynomials of degree 9 over the sphere exactly [McLaren 1963]: so (f g)(l,m), the sum of w f g Y(l,m)
   over them, is exact where f, g and Y are of degree 3. Both solids stand so that the planes of coordinates are planes
   of symmetry: eight corners are (+-1, +-1, +-1)/sqrt(3), the others lie four by four in the planes. What is even or
   odd in x, y and z is told apart,
     f = Q + x Qx + y Qy + z Qz + a yz + b zx + c xy + d xyz,
   each Q a sum of x^2, y^2, z^2 by three coefficients; from these, the values at points that differ in signs alone are
   sums and differences. Sums over the points go the same way back. All is relative to Y(0,0), at a plane's points to
   the square of the larger coordinate too, and what is odd has the factor of Y(1,m) and such a scale that it needs
   none at the icosahedron. Five bands: see below.

   Statements stand in an order that keeps few values alive: both factors side by side, for they take the same
   constants, and one plane after the other. */
#include "kernels.h"

/* q[axis]: the squares' coefficients of what is odd along that axis; q[WHOLE] of what is even. sum: of their three,
   mixed: of yz, zx, xy; all: of xyz */
enum { WHOLE = 3 };
typedef struct parts { node q[4][3], sum[4], mixed[3], all; } parts;

static xreal root(long numerator, long denominator) { return x_sqrt(x_ratio(numerator, denominator)); }

static node staged(kernel *k, node n) {
    kernel_stage(k, n);
    return n;
}

/* a + s b and a - s b */
static void both_ways(kernel *k, node a, xreal s, node b, node *sum, node *difference) {
    node t = k_scale(k, s, b);
    *sum = staged(k, k_add(k, a, t));
    *difference = staged(k, k_sub(k, a, t));
}

static void add_scaled(kernel *k, node *sum, xreal s, node v) { *sum = k_add(k, *sum, k_scale(k, s, v)); }

/* ---- points that differ in signs alone ---- */

/* The values that a function has at (+-x, +-y, +-z), told apart by their signs: those of 1, of yz, zx, xy, of x, y, z
   and of xyz. Where x differs from y = z, zx, xy, x and xyz lack the factor x/y, and all that is odd another one. */
typedef struct octants { node whole, mixed[3], single[3], all; } octants;

/* Products of two functions at four pairs of opposite points: their sums and differences. At the first pair yz, zx and
   xy are positive, at each of the others one of them alone. */
static void octant_products(kernel *k, const octants f[2], xreal step, xreal odd_factor, node sum[4], node less[4]) {
    node whole[2][2], single[2][2];
    int i, j;
    for (j = 0; j < 2; j++) {
        both_ways(k, f[j].whole, 1, f[j].mixed[0], &whole[j][0], &whole[j][1]);
        both_ways(k, f[j].single[0], 1, f[j].all, &single[j][0], &single[j][1]);
    }
    for (i = 0; i < 2; i++) {
        node even[2][2], odd[2][2];
        for (j = 0; j < 2; j++) {
            node zx_xy = (i ? k_sub : k_add)(k, f[j].mixed[1], f[j].mixed[2]);
            node y_z = (i ? k_sub : k_add)(k, f[j].single[1], f[j].single[2]);
            both_ways(k, whole[j][i], step, zx_xy, &even[j][0], &even[j][1]);
            both_ways(k, y_z, step, single[j][i], &odd[j][i], &odd[j][1 - i]);
        }
        for (j = 0; j < 2; j++) {
            node t0 = k_scale(k, odd_factor, odd[0][j]), t1 = k_scale(k, odd_factor, odd[1][j]);
            node h = k_mul(k, k_add(k, even[0][j], t0), k_add(k, even[1][j], t1));
            node opposite = k_mul(k, k_sub(k, even[0][j], t0), k_sub(k, even[1][j], t1));
            both_ways(k, h, 1, opposite, &sum[2 * i + j], &less[2 * i + j]);
        }
    }
}

/* And what they sum up to, sign by sign */
static octants octant_sums(kernel *k, const node sum[4], const node less[4]) {
    octants s;
    both_ways(k, k_add(k, sum[0], sum[1]), 1, k_add(k, sum[2], sum[3]), &s.whole, &s.mixed[0]);
    both_ways(k, k_sub(k, sum[0], sum[1]), 1, k_sub(k, sum[2], sum[3]), &s.mixed[1], &s.mixed[2]);
    both_ways(k, k_add(k, less[0], less[1]), 1, k_add(k, less[2], less[3]), &s.single[1], &s.single[2]);
    both_ways(k, k_sub(k, less[0], less[1]), 1, k_sub(k, less[3], less[2]), &s.single[0], &s.all);
    return s;
}

/* The same in a plane, of both functions: 1, xy, x, y; xy lacks a factor, y the ratio y/x, what is odd another. */
typedef struct quadrants { node whole[2], mixed[2], far[2], near[2]; } quadrants;

static void quadrant_products(kernel *k, const quadrants *f, xreal mixed_factor, xreal ratio, xreal odd_factor,
                              node sum[4]) {
    node even[2][2], odd[2][2], all[2], less[2];
    int i, j;
    for (j = 0; j < 2; j++) both_ways(k, f->whole[j], mixed_factor, f->mixed[j], &even[j][0], &even[j][1]);
    for (j = 0; j < 2; j++) both_ways(k, f->far[j], ratio, f->near[j], &odd[j][0], &odd[j][1]);
    for (i = 0; i < 2; i++) {
        node value[2][2], h[2];
        for (j = 0; j < 2; j++) {
            node t = k_scale(k, odd_factor, odd[j][i]);
            value[j][0] = k_add(k, even[j][i], t);
            value[j][1] = k_sub(k, even[j][i], t);
        }
        for (j = 0; j < 2; j++) h[j] = staged(k, k_mul(k, value[0][j], value[1][j]));
        both_ways(k, h[0], 1, h[1], &all[i], &less[i]);
    }
    both_ways(k, all[0], 1, all[1], &sum[0], &sum[1]);             /* 1, xy */
    both_ways(k, less[0], 1, less[1], &sum[2], &sum[3]);           /* x, y */
}

/* ---- parts from coefficients and back ---- */

enum { XYZ = 10 };                                     /* the harmonics that are xyz, and yz, zx, xy by a factor */
static const int mixed[3] = { 5, 7, 4 };

/* The three harmonics of one part: the lowest is 1, or x, y, z, or yz, zx, xy by a factor; the others are that times
   b (z z^2 - s (x^2 + y^2)) and times c (t x^2 - u y^2). */
typedef struct spread { int lowest, along, across, z, s, t, u; xreal b, c; } spread;

static spread spread_of(int part) {
    static const spread of[7] = {
        { 3, 13, 15, 4, 1, 1, 3, 0, 0 }, { 1, 11, 9, 4, 1, 3, 1, 0, 0 }, { 2, 12, 14, 2, 3, 1, 1, 0, 0 },
        { 0, 6, 8, 2, 1, 1, 1, 0, 0 },
        { 5, 19, 17, 4, 3, 3, 1, 0, 0 }, { 7, 21, 23, 4, 3, 1, 3, 0, 0 }, { 4, 18, 16, 6, 1, 1, 1, 0, 0 }
    };
    const xreal b[7] = { root(7, 8), root(7, 8), root(7, 12), root(5, 4), root(3, 8), root(3, 8), root(3, 4) };
    const xreal c[7] = { root(35, 24), root(35, 24), root(35, 4), root(15, 4), root(21, 8), root(21, 8), root(21, 4) };
    spread s = of[part];
    s.b = b[part];
    s.c = c[part];
    return s;
}

/* Of both factors; scale: of all but Q */
static void parts_of(kernel *k, const node *const f[2], xreal scale, parts p[2]) {
    int i, j;
    for (i = 0; i < 4; i++) {
        spread s = spread_of(i);
        xreal size = i == WHOLE ? 1 : scale;
        node lowest[2], middle[2];
        for (j = 0; j < 2; j++) {
            lowest[j] = k_scale(k, size, f[j][s.lowest]);
            middle[j] = staged(k, k_sub(k, lowest[j], k_scale(k, size * s.s * s.b, f[j][s.along])));
        }
        for (j = 0; j < 2; j++)
            p[j].q[i][2] = staged(k, k_add(k, lowest[j], k_scale(k, size * s.z * s.b, f[j][s.along])));
        for (j = 0; j < 2; j++)
            p[j].q[i][0] = staged(k, k_add(k, middle[j], k_scale(k, size * s.t * s.c, f[j][s.across])));
        for (j = 0; j < 2; j++)
            p[j].q[i][1] = staged(k, k_sub(k, middle[j], k_scale(k, size * s.u * s.c, f[j][s.across])));
        for (j = 0; j < 2; j++)                                    /* of what is even the mean is left */
            p[j].sum[i] = staged(k, i == WHOLE ? k_scale(k, 3 * scale, f[j][s.lowest])
                                               : k_add(k, k_add(k, p[j].q[i][0], p[j].q[i][1]), p[j].q[i][2]));
    }
    for (j = 0; j < 2; j++) {
        for (i = 0; i < 3; i++) p[j].mixed[i] = staged(k, k_scale(k, root(15, 1) * scale, f[j][mixed[i]]));
        p[j].all = k_scale(k, root(35, 1) * scale, f[j][XYZ]);
    }
}

/* The transpose, of sums over the points that have every factor but those of spread_of */
static void parts_to(kernel *k, const parts *p, node *out) {
    int i;
    for (i = 0; i < 4; i++) {
        spread s = spread_of(i);
        node x = p->q[i][0], y = p->q[i][1], z = p->q[i][2], both = k_add(k, x, y);
        out[s.lowest] = k_add(k, both, z);
        out[s.along] = k_sub(k, k_scale(k, s.z * s.b, z), k_scale(k, s.s * s.b, both));
        if (s.t == s.u) out[s.across] = k_scale(k, s.c, k_sub(k, x, y));
        else out[s.across] = k_sub(k, k_scale(k, s.t * s.c, x), k_scale(k, s.u * s.c, y));
    }
    for (i = 0; i < 3; i++) out[mixed[i]] = p->mixed[i];
    out[XYZ] = p->all;
}

/* ---- four points of a plane: +-large on the axis `far`, +-ratio large on `near` ---- */

typedef struct plane { int far, near, normal; xreal large, ratio, weight; } plane;

/* What the products at its points sum up to with the signs of 1, of far near, of far, of near */
static void plane_product(kernel *k, const parts p[2], const plane *at, xreal scale, node sum[4]) {
    quadrants f;
    int i, j;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 2; j++) {
            const node *square = p[j].q[i == 0 ? WHOLE : i == 1 ? at->far : at->near];
            (i == 0 ? f.whole : i == 1 ? f.far : f.near)[j] =
                staged(k, k_add(k, square[at->far], k_scale(k, at->ratio * at->ratio, square[at->near])));
        }
    for (j = 0; j < 2; j++) f.mixed[j] = p[j].mixed[at->normal];
    quadrant_products(k, &f, at->ratio / scale, at->ratio, root(3, 1) * at->large / scale, sum);
}

/* Adds sum[solid][way[solid]] of both solids. */
static void add_sums(kernel *k, const xreal weight[2], node sum[2][4], const int way[2], node *to) {
    int solid;
    for (solid = 0; solid < 2; solid++) add_scaled(k, to, weight[solid], sum[solid][way[solid]]);
    kernel_stage(k, *to);
}

static xreal on_axis(const plane *at, int axis) { return axis == at->far ? 1 : at->ratio; }

static void plane_sums(kernel *k, node sum[2][4], const plane at[2], parts *p) {
    int axis[2], i, j, s, way[2];
    xreal weight[2];
    axis[0] = at[0].far;
    axis[1] = at[0].near;
    for (i = -1; i < 2; i++)
        for (j = 0; j < 2; j++) {
            for (s = 0; s < 2; s++) {
                xreal along = on_axis(&at[s], axis[j]);
                way[s] = i < 0 ? 0 : axis[i] == at[s].far ? 2 : 3;
                weight[s] = at[s].weight * along * along;
                if (i >= 0) weight[s] *= root(3, 1) * at[s].large * on_axis(&at[s], axis[i]);
            }
            add_sums(k, weight, sum, way, &p->q[i < 0 ? WHOLE : axis[i]][axis[j]]);
        }
    for (s = 0; s < 2; s++) {
        way[s] = 1;
        weight[s] = at[s].weight * root(15, 1) * at[s].ratio;
    }
    add_sums(k, weight, sum, way, &p->mixed[at[0].normal]);
}

/* ---- (+-1, +-1, +-1)/sqrt(3) ---- */

/* Begins the sums; what has one part has it for each of its squares. */
static void corner_sums(kernel *k, const parts p[2], xreal weight, parts *to) {
    octants f[2], s;
    node sum[4], less[4];
    int i, j;
    for (j = 0; j < 2; j++) {
        f[j].whole = p[j].sum[WHOLE];
        f[j].all = p[j].all;
        for (i = 0; i < 3; i++) {
            f[j].mixed[i] = p[j].mixed[i];
            f[j].single[i] = p[j].sum[i];
        }
    }
    octant_products(k, f, 1, 1, sum, less);
    s = octant_sums(k, sum, less);
    for (i = 0; i < 3; i++) to->mixed[i] = staged(k, k_scale(k, weight * root(15, 1), s.mixed[i]));
    to->all = staged(k, k_scale(k, weight * root(35, 1), s.all));
    for (i = 0; i < 4; i++)
        to->q[i][0] = to->q[i][1] = to->q[i][2] = staged(k, k_scale(k, weight, i == WHOLE ? s.whole : s.single[i]));
}

/* ---- all of four bands ---- */

/* The points of one solid, icosahedron or dodecahedron, in a plane */
static plane plane_of(int normal, int solid) {
    const xreal golden = (1 + root(5, 1)) / 2;
    plane at;
    int i;
    at.normal = normal;
    at.far = (normal + 1 + solid) % 3;
    at.near = (normal + 2 - solid) % 3;
    at.ratio = solid ? 1 / (golden * golden) : 1 / golden;
    at.large = 1 / x_sqrt(1 + at.ratio * at.ratio);
    at.weight = x_ratio(solid ? 27 : 25, 840) / x_sqrt(4 * x_pi());
    for (i = 0; i < 6; i++) at.weight *= at.large;
    return at;
}

void point_product_nodes(kernel *k, const node *f, const node *g, node *out) {
    const xreal scale = root(3, 1) * plane_of(0, 0).large;
    const node *factors[2];
    node sums[2][4];
    parts p[2], sum;
    int normal, solid;
    factors[0] = f;
    factors[1] = g;
    parts_of(k, factors, scale, p);
    corner_sums(k, p, x_ratio(1, 840) / x_sqrt(4 * x_pi()) / (scale * scale), &sum);
    for (normal = 0; normal < 3; normal++) {
        plane at[2];
        for (solid = 0; solid < 2; solid++) {
            at[solid] = plane_of(normal, solid);
            plane_product(k, p, &at[solid], scale, sums[solid]);
        }
        plane_sums(k, sums, at, &sum);
    }
    parts_to(k, &sum, out);
}

/* ---- five bands: 74 points, planes and their poles one after the other ----

   The corners of an octahedron, a cube and a cuboctahedron, 24 points (+-l, +-l, +-m) and 24 in the planes of
   coordinates integrate polynomials of degree 12 exactly [Lebedev 1976]. What is even is of degree 4 now,
     W = sum of six products of two squares,
   and yz, zx, xy have factors that are sums of squares too. What belongs to an axis stands in a row, so that the same
   kernel serves the three: for each axis n, followed by i and j, the points in the plane to which n is normal, those
   with l on i and j and m on n, and n's poles. */

enum {                                                 /* of a row; what is odd along n, and what has the factor ij */
    WHOLE_NN, WHOLE_IJ, SINGLE_NN, SINGLE_NI, SINGLE_NJ, MIXED_NN, MIXED_NI, MIXED_NJ, ALL, SUMS,
    SINGLE_SUM = SUMS, MIXED_SUM, WHOLE_SUM, PARTS_ROW
};

/* The weights, of one point each, follow from moments of x^2, y^2, z^2: those that have all three leave 24 and the
   cube, of the rest those with two the points in planes, and the last the octahedron. */
typedef struct lebedev {
    xreal l, m, weight;                                /* squares of the coordinates of the 24 */
    xreal cube, p, q, in_plane, cuboctahedron, octahedron;         /* p, q: squares in the planes */
} lebedev;

static xreal power(xreal v, int n) { return n ? v * power(v, n - 1) : 1; }

/* The mean of x^2a y^2b z^2c over the sphere */
static xreal moment(int a, int b, int c) {
    xreal m = 1;
    int i;
    for (i = 1; i <= a; i++) m *= 2 * i - 1;
    for (i = 1; i <= b; i++) m *= 2 * i - 1;
    for (i = 1; i <= c; i++) m *= 2 * i - 1;
    for (i = 1; i <= a + b + c; i++) m /= 2 * i + 1;
    return m;
}

/* The same without what the points off the planes have of it */
static xreal plane_moment(const lebedev *r, int a, int b) {
    xreal off = power(r->l, 6) + power(r->m, a) * power(r->l, b) + power(r->l, a) * power(r->m, b);
    if (!b) off = 2 * power(r->l, 6) + power(r->m, 6);
    return moment(a, b, 0) - 8 * r->cube / 729 - 8 * r->weight * off;
}

static lebedev lebedev_rule(void) {
    lebedev r;
    xreal even, skew, uneven, sum, ratio;
    even = moment(2, 2, 2);
    uneven = moment(4, 1, 1) - even;
    skew = moment(3, 2, 1) - even;
    ratio = uneven / skew - 2;                                     /* m/l */
    r.l = 1 / (2 + ratio);
    r.m = ratio * r.l;
    r.weight = skew / (8 * power(r.l, 6) * ratio * power(1 - ratio, 2));
    r.cube = 729 * (even / 8 - 3 * r.weight * power(r.l, 4) * r.m * r.m);
    even = plane_moment(&r, 3, 3);
    uneven = plane_moment(&r, 5, 1) - even;
    skew = plane_moment(&r, 4, 2) - even;
    sum = uneven / skew - 2;                                       /* q/p + p/q */
    ratio = (sum - x_sqrt(sum * sum - 4)) / 2;
    r.p = 1 / (1 + ratio);
    r.q = ratio * r.p;
    r.in_plane = skew / (4 * power(r.p, 6) * power(ratio * (1 - ratio), 2));
    r.cuboctahedron = 16 * (even - 8 * r.in_plane * power(r.p * r.q, 3));
    r.octahedron = (plane_moment(&r, 6, 0) - r.cuboctahedron / 8
                    - 8 * r.in_plane * (power(r.p, 6) + power(r.q, 6))) / 2;
    return r;
}

/* Of what is odd, such that it has no factor at the 24 */
static xreal odd_scale(void) { return 1 / x_sqrt(lebedev_rule().l); }

static void parts_row_of(kernel *k, const spread *s, xreal size, const node *f, node row[3], int axis, node *sum) {
    node lowest = k_scale(k, size, f[s->lowest]);
    node middle = k_sub(k, lowest, k_scale(k, size * s->s * s->b, f[s->along])), q[3];
    int i;
    q[0] = k_add(k, middle, k_scale(k, size * s->t * s->c, f[s->across]));
    q[1] = k_sub(k, middle, k_scale(k, size * s->u * s->c, f[s->across]));
    q[2] = k_add(k, lowest, k_scale(k, size * s->z * s->b, f[s->along]));
    for (i = 0; i < 3; i++) row[i] = staged(k, q[(axis + i) % 3]);
    *sum = staged(k, k_add(k, k_add(k, q[0], q[1]), q[2]));
}

/* Of Y(0,0), (2,0), (2,2), (4,0), (4,2), (4,4), the factors of their polynomials */
static const int whole_of[6] = { 0, 6, 8, 20, 22, 24 };
static void whole_factors(xreal c[6]) {
    c[0] = 1;
    c[1] = root(5, 4);
    c[2] = root(15, 4);
    c[3] = x_ratio(3, 8);
    c[4] = root(45, 16);
    c[5] = root(315, 64);
}

static void whole_parts(kernel *k, const node *f, node rows[3][PARTS_ROW]) {
    xreal c[6];
    node v[6], u, x, y, z;
    int i;
    whole_factors(c);
    for (i = 0; i < 6; i++) v[i] = f[whole_of[i]];
    u = k_add(k, k_sub(k, v[0], k_scale(k, c[1], v[1])), k_scale(k, 3 * c[3], v[3]));
    x = k_add(k, u, k_scale(k, c[5], v[5]));
    y = k_sub(k, k_scale(k, c[2], v[2]), k_scale(k, c[4], v[4]));
    rows[0][WHOLE_NN] = staged(k, k_add(k, x, y));
    rows[1][WHOLE_NN] = staged(k, k_sub(k, x, y));
    rows[2][WHOLE_IJ] = staged(k, k_sub(k, k_scale(k, 2, u), k_scale(k, 6 * c[5], v[5])));
    z = k_add(k, k_scale(k, 2, v[0]), k_scale(k, c[1], v[1]));
    x = k_sub(k, z, k_scale(k, 24 * c[3], v[3]));
    y = k_add(k, k_scale(k, c[2], v[2]), k_scale(k, 6 * c[4], v[4]));
    rows[1][WHOLE_IJ] = staged(k, k_add(k, x, y));
    rows[0][WHOLE_IJ] = staged(k, k_sub(k, x, y));
    x = k_add(k, v[0], k_scale(k, 2 * c[1], v[1]));
    rows[2][WHOLE_NN] = staged(k, k_add(k, x, k_scale(k, 8 * c[3], v[3])));
    x = k_sub(k, k_scale(k, 9, v[0]), k_scale(k, 28 * c[3], v[3]));
    rows[0][WHOLE_SUM] = staged(k, k_sub(k, x, k_scale(k, 4 * c[5], v[5])));
}

kernel *describe_point_parts(int bands) {
    kernel *k = named_kernel("point_parts", "parts of a function", bands);
    const xreal scale = odd_scale();
    node f[25], rows[3][PARTS_ROW];
    int axis, i, out;
    input_nodes(k, "f", 25, f);
    out = kernel_param(k, "parts", PARAM_OUTPUT, 3 * PARTS_ROW);
    whole_parts(k, f, rows);
    rows[1][WHOLE_SUM] = rows[2][WHOLE_SUM] = k_const(k, 0);
    for (axis = 0; axis < 3; axis++) {
        spread single = spread_of(axis), twice = spread_of(WHOLE + 1 + axis);
        parts_row_of(k, &single, root(3, 1) * scale, f, rows[axis] + SINGLE_NN, axis, &rows[axis][SINGLE_SUM]);
        parts_row_of(k, &twice, root(15, 1), f, rows[axis] + MIXED_NN, axis, &rows[axis][MIXED_SUM]);
        rows[axis][ALL] = k_scale(k, root(105, 1) * scale, f[XYZ]);
    }
    for (axis = 0; axis < 3; axis++)
        for (i = 0; i < PARTS_ROW; i++)
            if (i != WHOLE_SUM || !axis) kernel_output(k, out, axis * PARTS_ROW + i, rows[axis][i]);
    return k;
}

static void whole_sums(kernel *k, node sums[3][SUMS], node *out) {
    node x = sums[0][WHOLE_NN], y = sums[1][WHOLE_NN], z = sums[2][WHOLE_NN], xy = sums[2][WHOLE_IJ];
    node both = k_add(k, x, y), less = k_sub(k, x, y), u = k_add(k, both, k_scale(k, 2, xy));
    node yz = sums[0][WHOLE_IJ], zx = sums[1][WHOLE_IJ], round = k_add(k, zx, yz), across = k_sub(k, zx, yz);
    xreal c[6];
    whole_factors(c);
    out[0] = k_add(k, k_add(k, u, k_scale(k, 2, round)), z);
    out[6] = k_scale(k, c[1], k_add(k, k_sub(k, round, u), k_scale(k, 2, z)));
    out[8] = k_scale(k, c[2], k_add(k, less, across));
    out[20] = k_add(k, k_sub(k, k_scale(k, 3 * c[3], u), k_scale(k, 24 * c[3], round)), k_scale(k, 8 * c[3], z));
    out[22] = k_sub(k, k_scale(k, 6 * c[4], across), k_scale(k, c[4], less));
    out[24] = k_sub(k, k_scale(k, c[5], both), k_scale(k, 6 * c[5], xy));
}

/* The transpose of parts_row_of, of sums that have the size */
static void coefficients_of_row(kernel *k, const spread *s, const node row[3], int axis, node *out) {
    node x = row[(3 - axis) % 3], y = row[(4 - axis) % 3], z = row[(5 - axis) % 3], both = k_add(k, x, y);
    out[s->lowest] = k_add(k, both, z);
    out[s->along] = k_sub(k, k_scale(k, s->z * s->b, z), k_scale(k, s->s * s->b, both));
    if (s->t == s->u) out[s->across] = k_scale(k, s->c, k_sub(k, x, y));
    else out[s->across] = k_sub(k, k_scale(k, s->t * s->c, x), k_scale(k, s->u * s->c, y));
}

kernel *describe_point_coefficients(int bands) {
    kernel *k = named_kernel("point_coefficients", "coefficients of sums over points", bands);
    node in[3 * SUMS], sums[3][SUMS], f[25];
    int axis, i, out;
    input_nodes(k, "sums", 3 * SUMS, in);
    out = kernel_param(k, "out", PARAM_OUTPUT, 25);
    for (i = 0; i < 3 * SUMS; i++) sums[i / SUMS][i % SUMS] = in[i];
    whole_sums(k, sums, f);
    for (axis = 0; axis < 3; axis++) {
        spread single = spread_of(axis), twice = spread_of(WHOLE + 1 + axis);
        coefficients_of_row(k, &single, sums[axis] + SINGLE_NN, axis, f);
        coefficients_of_row(k, &twice, sums[axis] + MIXED_NN, axis, f);
    }
    f[XYZ] = k_add(k, k_add(k, sums[0][ALL], sums[1][ALL]), sums[2][ALL]);
    for (i = 0; i < 25; i++) kernel_output(k, out, i, f[i]);
    return k;
}

static xreal of_mean(void) { return 1 / x_sqrt(4 * x_pi()); }

/* Begins the sums with those over the cube. */
kernel *describe_point_corners(int bands) {
    kernel *k = named_kernel("point_corners", "sums over the corners of a cube", bands);
    const xreal weight = lebedev_rule().cube / 729 * of_mean();
    node in[2][3 * PARTS_ROW], sum[4], less[4];
    octants f[2], s;
    int i, j, e, out;
    input_nodes(k, "f", 3 * PARTS_ROW, in[0]);
    input_nodes(k, "g", 3 * PARTS_ROW, in[1]);
    out = kernel_param(k, "sums", PARAM_OUTPUT, 3 * SUMS);
    for (j = 0; j < 2; j++) {
        f[j].whole = in[j][WHOLE_SUM];
        f[j].all = in[j][ALL];
        for (i = 0; i < 3; i++) {
            f[j].mixed[i] = in[j][i * PARTS_ROW + MIXED_SUM];
            f[j].single[i] = in[j][i * PARTS_ROW + SINGLE_SUM];
        }
    }
    octant_products(k, f, 1, root(3, 1) / odd_scale(), sum, less);
    s = octant_sums(k, sum, less);
    for (i = 0; i < 3; i++)
        for (e = 0; e < SUMS; e++) {
            node v = e < SINGLE_NN ? k_scale(k, weight, s.whole)
                   : e < MIXED_NN  ? k_scale(k, weight * 3, s.single[i])
                   : e < ALL       ? k_scale(k, weight * root(15, 1), s.mixed[i])
                                   : k_scale(k, weight * root(35, 1), s.all);        /* a third in each row */
            kernel_output(k, out, i * SUMS + e, v);
        }
    return k;
}

/* The entry of what is odd along (or, twice, mixed away from) the axis `of`, that the square of `along` goes with */
static int entry(int twice, int of, int along) { return (twice ? MIXED_NN : SINGLE_NN) + (along - of + 3) % 3; }

/* of l^2 at the 24: ratio = m/l */
static node at_ratio(kernel *k, node row[3][PARTS_ROW], int twice, int of, xreal ratio) {
    node both = k_add(k, row[of][entry(twice, of, 1)], row[of][entry(twice, of, 2)]);
    return k_add(k, both, k_scale(k, ratio, row[of][entry(twice, of, 0)]));
}

/* The 24's part of an axis */
static octants axis_octants(kernel *k, node row[3][PARTS_ROW], xreal ratio) {
    octants o;
    node equal = k_add(k, k_add(k, row[1][WHOLE_NN], row[2][WHOLE_NN]), row[0][WHOLE_IJ]);
    int i;
    o.whole = k_add(k, equal, k_scale(k, ratio, k_add(k, row[1][WHOLE_IJ], row[2][WHOLE_IJ])));
    o.whole = staged(k, k_add(k, o.whole, k_scale(k, ratio * ratio, row[0][WHOLE_NN])));
    for (i = 0; i < 3; i++) {
        o.mixed[i] = staged(k, at_ratio(k, row, 1, i, ratio));
        o.single[i] = staged(k, at_ratio(k, row, 0, i, ratio));
    }
    o.all = row[0][ALL];
    return o;
}

static void add_octants(kernel *k, const octants *s, const lebedev *r, node to[3][SUMS]) {
    const xreal ratio = r->m / r->l, step = x_sqrt(ratio), weight = r->weight * power(r->l, 6) * of_mean();
    int i, j;
    add_scaled(k, &to[0][WHOLE_NN], weight * ratio * ratio, s->whole);
    add_scaled(k, &to[1][WHOLE_IJ], weight * ratio, s->whole);
    add_scaled(k, &to[2][WHOLE_IJ], weight * ratio, s->whole);
    add_scaled(k, &to[1][WHOLE_NN], weight, s->whole);
    add_scaled(k, &to[2][WHOLE_NN], weight, s->whole);
    add_scaled(k, &to[0][WHOLE_IJ], weight, s->whole);
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) {
            xreal along = j ? 1 : ratio;
            xreal single = weight * odd_scale() * root(3, 1) * (i ? 1 : step);
            xreal twice = weight * root(15, 1) * (i ? step : 1);
            add_scaled(k, &to[i][entry(0, i, j)], single * along, s->single[i]);
            add_scaled(k, &to[i][entry(1, i, j)], twice * along, s->mixed[i]);
        }
    add_scaled(k, &to[0][ALL], weight * odd_scale() * root(105, 1) * step, s->all);
}

/* Four points in the plane, with the square p of the coordinate on `far`, q on `near`: 1 and 2, or 2 and 1 */
static void quadrants_of_plane(kernel *k, node row[2][3][PARTS_ROW], int far, xreal p, xreal q, xreal weight,
                               node to[3][SUMS]) {
    const xreal ratio = q / p, coordinates = x_sqrt(ratio), odd = 1 / x_sqrt(p);
    const int near = 3 - far;
    quadrants f;
    node sum[4];
    int j, i;
    for (j = 0; j < 2; j++) {
        node (*r)[PARTS_ROW] = row[j];
        f.whole[j] = k_add(k, r[far][WHOLE_NN], k_scale(k, ratio, r[0][WHOLE_IJ]));
        f.whole[j] = staged(k, k_add(k, f.whole[j], k_scale(k, ratio * ratio, r[near][WHOLE_NN])));
        f.mixed[j] = staged(k, k_add(k, r[0][entry(1, 0, far)], k_scale(k, ratio, r[0][entry(1, 0, near)])));
        f.far[j] = staged(k, k_add(k, r[far][entry(0, far, far)], k_scale(k, ratio, r[far][entry(0, far, near)])));
        f.near[j] = staged(k, k_add(k, r[near][entry(0, near, far)], k_scale(k, ratio, r[near][entry(0, near, near)])));
    }
    quadrant_products(k, &f, coordinates, coordinates, odd / odd_scale(), sum);
    weight *= power(p, 6) * of_mean();
    add_scaled(k, &to[far][WHOLE_NN], weight, sum[0]);
    add_scaled(k, &to[0][WHOLE_IJ], weight * ratio, sum[0]);
    add_scaled(k, &to[near][WHOLE_NN], weight * ratio * ratio, sum[0]);
    for (i = 0; i < 2; i++) {
        int along = i ? near : far;
        xreal scaled = weight * (i ? ratio : 1);
        add_scaled(k, &to[0][entry(1, 0, along)], scaled * root(15, 1) * coordinates, sum[1]);
        add_scaled(k, &to[far][entry(0, far, along)], scaled * root(3, 1) * odd, sum[2]);
        add_scaled(k, &to[near][entry(0, near, along)], scaled * root(3, 1) * odd * coordinates, sum[3]);
    }
}

static void poles(kernel *k, node row[2][3][PARTS_ROW], xreal weight, node to[3][SUMS]) {
    node value[2][2], sum, less;
    int j;
    for (j = 0; j < 2; j++)
        both_ways(k, row[j][0][WHOLE_NN], 1 / odd_scale(), row[j][0][SINGLE_NN], &value[j][0], &value[j][1]);
    both_ways(k, k_mul(k, value[0][0], value[1][0]), 1, k_mul(k, value[0][1], value[1][1]), &sum, &less);
    add_scaled(k, &to[0][WHOLE_NN], weight * of_mean(), sum);
    add_scaled(k, &to[0][SINGLE_NN], weight * root(3, 1) * of_mean(), less);
}

/* The rows of an axis n and of i and j: those of both factors, and of the sums, to which a kernel adds */
typedef struct axis_rows {
    node factor[2][3][PARTS_ROW], sums[3][SUMS];
    int out[3];
} axis_rows;

static void input_rows(kernel *k, axis_rows *rows) {
    static const char *const names[3][3] = { { "fn", "fi", "fj" }, { "gn", "gi", "gj" }, { "sn", "si", "sj" } };
    int i, j, e;
    for (j = 0; j < 2; j++)
        for (i = 0; i < 3; i++) input_nodes(k, names[j][i], PARTS_ROW, rows->factor[j][i]);
    for (i = 0; i < 3; i++) {
        rows->out[i] = kernel_param(k, names[2][i], PARAM_OUTPUT, SUMS);
        for (e = 0; e < SUMS; e++) rows->sums[i][e] = k_element(k, rows->out[i], e);
    }
}

/* Those that have changed */
static void output_rows(kernel *k, const axis_rows *rows) {
    int i, e;
    for (i = 0; i < 3; i++)
        for (e = 0; e < SUMS; e++)
            if (k->nodes[rows->sums[i][e]].op != OP_INPUT) kernel_output(k, rows->out[i], e, rows->sums[i][e]);
}

kernel *describe_point_octants(int bands) {
    kernel *k = named_kernel("point_octants", "sums over the points of an axis", bands);
    const lebedev r = lebedev_rule();
    axis_rows rows;
    node sum[4], less[4];
    octants f[2], s;
    int j;
    input_rows(k, &rows);
    for (j = 0; j < 2; j++) f[j] = axis_octants(k, rows.factor[j], r.m / r.l);
    octant_products(k, f, x_sqrt(r.m / r.l), 1, sum, less);
    s = octant_sums(k, sum, less);
    add_octants(k, &s, &r, rows.sums);
    output_rows(k, &rows);
    return k;
}

kernel *describe_point_plane(int bands) {
    kernel *k = named_kernel("point_plane", "sums over the points of a plane", bands);
    const lebedev r = lebedev_rule();
    axis_rows rows;
    input_rows(k, &rows);
    quadrants_of_plane(k, rows.factor, 1, r.p, r.q, r.in_plane, rows.sums);
    quadrants_of_plane(k, rows.factor, 2, r.p, r.q, r.in_plane, rows.sums);
    quadrants_of_plane(k, rows.factor, 1, x_ratio(1, 2), x_ratio(1, 2), r.cuboctahedron, rows.sums);
    poles(k, rows.factor, r.octahedron, rows.sums);
    output_rows(k, &rows);
    return k;
}
