/* Kernels of the room >>product: the product of two SH functions of four bands by way of their values at 32 points.

   The twelve corners of an icosahedron, weight 25/840, and the twenty of a dodecahedron, 27/840, integrate polynomials of
   degree 9 over the sphere exactly [McLaren 1963]: so (f g)(l,m), the sum of w f g Y(l,m) over them, is exact where f, g
   and Y are of degree 3. Both solids stand so that the planes of coordinates are planes of symmetry: eight corners are
   (+-1, +-1, +-1)/sqrt(3), the others lie four by four in the planes. What is even or odd in x, y and z is told apart,
     f = Q + x Qx + y Qy + z Qz + a yz + b zx + c xy + d xyz,
   each Q a sum of x^2, y^2, z^2 by three coefficients; from these, the values at points that differ in signs alone are
   sums and differences. Sums over the points go the same way back. All is relative to Y(0,0), at a plane's points to the
   square of the larger coordinate too, and what is odd has the factor of Y(1,m) and such a scale that it needs none at
   the icosahedron.

   Statements stand in an order that keeps few values alive: both factors side by side, for they take the same constants,
   and one plane after the other. */
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

/* ---- parts from coefficients and back ---- */

enum { XYZ = 10 };                                     /* the harmonics that are xyz, and yz, zx, xy, but for a factor */
static const int mixed[3] = { 5, 7, 4 };

/* The three harmonics of one part: the lowest is 1 or x, y, z; the others are that times b (z z^2 - s (x^2 + y^2)) and
   times c (t x^2 - u y^2), beside the factor of Y(1,m) */
typedef struct spread { int lowest, along, across, z, s, t, u; xreal b, c; } spread;

static spread spread_of(int part) {
    static const spread of[4] = {
        { 3, 13, 15, 4, 1, 1, 3, 0, 0 }, { 1, 11, 9, 4, 1, 3, 1, 0, 0 }, { 2, 12, 14, 2, 3, 1, 1, 0, 0 },
        { 0, 6, 8, 2, 1, 1, 1, 0, 0 }
    };
    spread s = of[part];
    s.b = part == WHOLE ? root(5, 4) : part == 2 ? root(7, 12) : root(7, 8);
    s.c = part == WHOLE ? root(15, 4) : part == 2 ? root(35, 4) : root(35, 24);
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
    const xreal odd = root(3, 1) * at->large / scale;
    node q[3][2], even[2][2], turned[2][2], all[2], less[2];
    int i, j, of[3];
    of[0] = WHOLE;
    of[1] = at->far;
    of[2] = at->near;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 2; j++) {
            const node *square = p[j].q[of[i]];
            q[i][j] = staged(k, k_add(k, square[at->far], k_scale(k, at->ratio * at->ratio, square[at->near])));
        }
    for (j = 0; j < 2; j++)
        both_ways(k, q[0][j], at->ratio / scale, p[j].mixed[at->normal], &even[j][0], &even[j][1]);
    for (j = 0; j < 2; j++) both_ways(k, q[1][j], at->ratio, q[2][j], &turned[j][0], &turned[j][1]);
    for (i = 0; i < 2; i++) {
        node value[2][2], h[2];
        for (j = 0; j < 2; j++) {
            node t = k_scale(k, odd, turned[j][i]);
            value[j][0] = k_add(k, even[j][i], t);
            value[j][1] = k_sub(k, even[j][i], t);
        }
        for (j = 0; j < 2; j++) h[j] = staged(k, k_mul(k, value[0][j], value[1][j]));
        both_ways(k, h[0], 1, h[1], &all[i], &less[i]);
    }
    both_ways(k, all[0], 1, all[1], &sum[0], &sum[1]);
    both_ways(k, less[0], 1, less[1], &sum[2], &sum[3]);
}

/* Adds sum[solid][way[solid]] of both solids. */
static void add_sums(kernel *k, const xreal weight[2], node sum[2][4], const int way[2], node *to) {
    *to = k_add(k, *to, k_scale(k, weight[0], sum[0][way[0]]));
    *to = staged(k, k_add(k, *to, k_scale(k, weight[1], sum[1][way[1]])));
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

/* ---- (+-1, +-1, +-1)/sqrt(3) in pairs of opposites: `even` plus and minus `odd`. yz, zx and xy are positive at the first
   pair, and one of them alone at each of the others. ---- */

/* Sums and differences of the products at each pair */
static void corner_products(kernel *k, const parts p[2], node all[4], node less[4]) {
    node whole[2][2], x[2][2];
    int i, j;
    for (j = 0; j < 2; j++) {
        both_ways(k, p[j].sum[WHOLE], 1, p[j].mixed[0], &whole[j][0], &whole[j][1]);
        both_ways(k, p[j].sum[0], 1, p[j].all, &x[j][0], &x[j][1]);
    }
    for (i = 0; i < 2; i++) {
        node even[2][2], odd[2][2];
        for (j = 0; j < 2; j++) {
            node zx_xy = (i ? k_sub : k_add)(k, p[j].mixed[1], p[j].mixed[2]);
            node yz = (i ? k_sub : k_add)(k, p[j].sum[1], p[j].sum[2]);
            both_ways(k, whole[j][i], 1, zx_xy, &even[j][0], &even[j][1]);
            both_ways(k, x[j][i], 1, yz, &odd[j][i], &odd[j][1 - i]);
        }
        for (j = 0; j < 2; j++) {
            node h = k_mul(k, k_add(k, even[0][j], odd[0][j]), k_add(k, even[1][j], odd[1][j]));
            node opposite = k_mul(k, k_sub(k, even[0][j], odd[0][j]), k_sub(k, even[1][j], odd[1][j]));
            both_ways(k, h, 1, opposite, &all[2 * i + j], &less[2 * i + j]);
        }
    }
}

/* Begins the sums; what has one part has it for each of its squares. */
static void corner_sums(kernel *k, node all[4], node less[4], xreal weight, parts *p) {
    node sum[4], plus, minus, other;
    int i;
    both_ways(k, k_add(k, all[0], all[1]), 1, k_add(k, all[2], all[3]), &sum[WHOLE], &p->mixed[0]);
    plus = k_sub(k, all[0], all[1]);
    minus = k_sub(k, all[2], all[3]);
    both_ways(k, plus, 1, minus, &p->mixed[1], &p->mixed[2]);
    both_ways(k, k_add(k, less[0], less[1]), 1, k_add(k, less[2], less[3]), &sum[0], &other);
    plus = k_sub(k, less[0], less[1]);
    minus = k_sub(k, less[3], less[2]);
    both_ways(k, plus, 1, minus, &sum[1], &sum[2]);
    for (i = 0; i < 3; i++) p->mixed[i] = staged(k, k_scale(k, weight * root(15, 1), p->mixed[i]));
    p->all = staged(k, k_scale(k, weight * root(35, 1), other));
    for (i = 0; i < 4; i++) p->q[i][0] = p->q[i][1] = p->q[i][2] = staged(k, k_scale(k, weight, sum[i]));
}

/* ---- all of it ---- */

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
    node all[4], less[4], sums[2][4];
    parts p[2], sum;
    int normal, solid;
    factors[0] = f;
    factors[1] = g;
    parts_of(k, factors, scale, p);
    corner_products(k, p, all, less);
    corner_sums(k, all, less, x_ratio(1, 840) / x_sqrt(4 * x_pi()) / (scale * scale), &sum);
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
