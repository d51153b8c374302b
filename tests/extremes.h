/* At the ends of what numbers can hold: each experiment measures an error and says what arithmetic allows.
   test_extremes.c asserts all of them; stability/stability.c prints them, in float and double, for docs/stability.md.
   Include after prt_bake.h with its implementation. */
#ifndef PRT_EXTREMES_H
#define PRT_EXTREMES_H

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#ifdef PRT_DOUBLE
#  define EXTREME_EPS DBL_EPSILON
#  define EXTREME_QUANTUM 4.9406564584124654e-324      /* the least positive number */
#  define EXTREME_TINY 1e-200                           /* half of it, squared in double, is no subnormal number */
#  define EXTREME_FAR 1e200
#  define EXTREME_MOST DBL_MAX
#else
#  define EXTREME_EPS ((double)FLT_EPSILON)
#  define EXTREME_QUANTUM 1.4012984643248171e-45
#  define EXTREME_TINY 1e-30
#  define EXTREME_FAR 1e30
#  define EXTREME_MOST ((double)FLT_MAX)
#endif

static const double extreme_pi = 3.14159265358979323846;

/* The worst of some comparisons: the one whose error is the largest share of its bound. NaN is worse than all. */
typedef struct extreme { double error, bound; } extreme;

static double extreme_share(extreme e) { return e.bound > 0 ? e.error / e.bound : e.error == 0 ? 0 : HUGE_VAL; }
static void extreme_take(extreme *worst, double error, double bound) {
    extreme e;
    e.error = fabs(error);
    e.bound = bound;
    if (!(extreme_share(e) <= extreme_share(*worst)) || worst->bound < 0) *worst = e;
}
static extreme extreme_none(void) { extreme e = { 0, -1 }; return e; }

static prt_vec3 extreme_vec3(double x, double y, double z) {
    return prt__vec3((prt_real)x, (prt_real)y, (prt_real)z);
}
static uint64_t extreme_state;
static double extreme_uniform(void) {
    extreme_state ^= extreme_state << 13; extreme_state ^= extreme_state >> 7; extreme_state ^= extreme_state << 17;
    return (double)(extreme_state >> 11) / 9007199254740992.0;
}
static void extreme_numbers(int count, prt_real *f) {       /* -1 ... 1, the same each time */
    int i;
    extreme_state = UINT64_C(88172645463325252);
    for (i = 0; i < count; i++) f[i] = (prt_real)(2 * extreme_uniform() - 1);
}

/* ---- directions ---- */

/* Beside the poles Y(l,0) = +-sqrt((2l+1)/4pi) and Y(l,+-1) is linear in the tilt, all relative errors, however small
   the tilt; all others vanish with its square. */
static extreme extreme_pole(double bands, double tilt) {
    static prt_real y[PRT_SH_COUNT(PRT_MAX_BANDS)];
    extreme worst = extreme_none();
    int n = (int)bands, pole, l, m;
    for (pole = -1; pole <= 1; pole += 2) {
        prt_vec3 d = extreme_vec3(0.6 * tilt, -0.8 * tilt, pole);
        memset(y, 0, sizeof y);
        prt_sh_eval(n, d, y);
        for (l = 0; l < n; l++) {
            double sign = pole < 0 && l % 2 ? -1 : 1, next = pole < 0 && l % 2 == 0 ? -1 : 1;
            double mean = sign * sqrt((2 * l + 1) / (4 * extreme_pi)), curved = l * (l + 1.0) * tilt * tilt;
            double slope = next * sqrt((2 * l + 1) * l * (l + 1.0) / (8 * extreme_pi));
            double tolerance = (4 * l + 4) * EXTREME_EPS + curved, x = slope * (double)d.x, yy = slope * (double)d.y;
            extreme_take(&worst, (double)y[PRT_SH_INDEX(l, 0)] / mean - 1, tolerance);
            if (l > 0 && x != 0) {
                extreme_take(&worst, (double)y[PRT_SH_INDEX(l, 1)] / x - 1, tolerance);
                extreme_take(&worst, (double)y[PRT_SH_INDEX(l, -1)] / yy - 1, tolerance);
            }
            for (m = 2; m <= l; m++) {
                double most = pow(l + 1.0, 4.5) * tilt * tilt;
                if (fabs((double)y[PRT_SH_INDEX(l, m)]) > most || fabs((double)y[PRT_SH_INDEX(l, -m)]) > most)
                    extreme_take(&worst, 1, tolerance);
            }
        }
    }
    return worst;
}

/* sum over m of Y(l,m)^2 = (2l+1)/4pi, relative, worst band, at directions from a pole to the equator. If each value
   errs by e the sum errs by 2 e sqrt(4 pi) at most; prt_sh_eval promises e. */
static double extreme_promised(int bands) {
    double as_double = bands > 10 ? 7.3e-17 * bands * bands : 8e-15;
    return sizeof(prt_real) == sizeof(double) ? as_double : bands > 10 ? as_double + 1.5e-7 : 5e-6;
}
static extreme extreme_bands(double bands, double unused) {
    static prt_real y[PRT_SH_COUNT(PRT_MAX_BANDS)];
    extreme worst = extreme_none();
    int n = (int)bands, k, l, i;
    (void)unused;
    for (k = 0; k < 5; k++) {
        double z = k == 0 ? 1 : k == 1 ? 1 - 1e-6 : k == 2 ? 0.8 : k == 3 ? -0.36 : 0, r = sqrt(1 - z * z), square;
        prt_vec3 d = extreme_vec3(0.6 * r, 0.8 * r, z);
        memset(y, 0, sizeof y);
        prt_sh_eval(n, d, y);
        square = (double)d.x * (double)d.x + (double)d.y * (double)d.y + (double)d.z * (double)d.z;
        for (l = 0; l < n; l++) {
            double sum = 0, input = l * (l + 1.0) * fabs(square - 1);    /* the length is not 1: see prt_sh_eval */
            for (i = l * l; i < (l + 1) * (l + 1); i++) sum += (double)y[i] * (double)y[i];
            extreme_take(&worst, sum * 4 * extreme_pi / (2 * l + 1) - 1,
                         7.1 * extreme_promised(n) + 2 * EXTREME_EPS + 2 * input);
        }
    }
    return worst;
}

/* ---- radiance ---- */

/* Everything linear in radiance stays so: results at this radiance over it, against those at radiance 1, relative to
   the sum of their sizes. Subnormal numbers come in steps of a fixed size. */
static extreme extreme_radiance(double radiance, double unused) {
    enum { N = 6, COUNT = N * N, W = 32, H = 16 };
    static float map[3 * W * H];
    static prt_real out[2][6][3 * COUNT], f[COUNT];
    prt_real zonal[N], r[9] = { 0, -1, 0, 0, 0, -1, 1, 0, 0 };
    extreme worst = extreme_none();
    int pass, i, k;
    (void)unused;
    for (i = 0; i < N; i++) zonal[i] = (prt_real)(1.0 / (1 + i));
    for (pass = 0; pass < 2; pass++) {
        double scale = pass ? radiance : 1;
        extreme_state = UINT64_C(88172645463325252);
        for (i = 0; i < 3 * W * H; i++) map[i] = (float)(extreme_uniform() * scale);
        prt_sh_project_equirect_rgb(N, W, H, map, out[pass][0]);
        for (i = 0; i < COUNT; i++) f[i] = (prt_real)((double)out[0][0][i] * scale);
        prt_sh_rotate(N, r, f, out[pass][1]);
        prt_sh_convolve(N, f, zonal, out[pass][2]);
        prt_sh_irradiance(N, f, out[pass][3]);
        prt_sh_window(N, PRT_WINDOW_HANN, N, f, out[pass][4]);
        prt_sh_product(N, f, out[0][0], out[pass][5]);
    }
    for (k = 0; k < 6; k++) {
        double size = 0;
        for (i = 0; i < COUNT; i++) size += fabs((double)out[0][k][i]);
        for (i = 0; i < COUNT; i++) {
            if (fabs((double)out[0][k][i]) * radiance > EXTREME_MOST) continue;    /* no number can hold the result */
            extreme_take(&worst, ((double)out[1][k][i] / radiance - (double)out[0][k][i]) / size,
                         8 * (double)FLT_EPSILON + (1.4012984643248171e-45 + 64 * EXTREME_QUANTUM) / radiance);
        }
    }
    return worst;
}

/* ---- a million turns ---- */

enum { TURNED_BANDS = 5, TURNED = TURNED_BANDS * TURNED_BANDS };
static const double extreme_axis[3] = { 0.11470786693528087, -0.80295506854696610, 0.58494213340446 };   /* unit */
#define EXTREME_ANGLE 1.0                                   /* no turn comes back to where it has been */

static void extreme_turn(double angle, prt_real r[9]) {
    double x = extreme_axis[0], y = extreme_axis[1], z = extreme_axis[2], length = sqrt(x * x + y * y + z * z);
    double c = cos(angle), s = sin(angle);
    x /= length; y /= length; z /= length;
    r[0] = (prt_real)(c + x * x * (1 - c));     r[1] = (prt_real)(x * y * (1 - c) - z * s);
    r[2] = (prt_real)(x * z * (1 - c) + y * s); r[3] = (prt_real)(y * x * (1 - c) + z * s);
    r[4] = (prt_real)(c + y * y * (1 - c));     r[5] = (prt_real)(y * z * (1 - c) - x * s);
    r[6] = (prt_real)(z * x * (1 - c) - y * s); r[7] = (prt_real)(z * y * (1 - c) + x * s);
    r[8] = (prt_real)(c + z * z * (1 - c));
}

/* Scales every band back to the norm it had: 2 n^2 operations. */
static void extreme_renorm(const double *norm, prt_real *f) {
    int l, i;
    for (l = 0; l < TURNED_BANDS; l++) {
        double square = 0;
        for (i = l * l; i < (l + 1) * (l + 1); i++) square += (double)f[i] * (double)f[i];
        for (i = l * l; i < (l + 1) * (l + 1); i++) f[i] = (prt_real)((double)f[i] * norm[l] / sqrt(square));
    }
}

/* The norms of the bands of a vector turned in place so many times, against what they were, relative. every: turns
   after which they are set back (0: never). Rounding R makes it longer or shorter by sqrt(3)/2 eps at most, and band l
   by the l-th power of that; the kernel adds 5 eps. Both go the same way every time: drift in proportion. */
static extreme extreme_drift(double turns, double every) {
    prt_real f[TURNED], r[9];
    double norm[TURNED_BANDS];
    extreme worst = extreme_none();
    int l, i, k;
    extreme_numbers(TURNED, f);
    for (l = 0; l < TURNED_BANDS; l++) {
        for (norm[l] = 0, i = l * l; i < (l + 1) * (l + 1); i++) norm[l] += (double)f[i] * (double)f[i];
        norm[l] = sqrt(norm[l]);
    }
    extreme_turn(EXTREME_ANGLE, r);
    for (k = 1; k <= (int)turns; k++) {
        prt_sh_rotate(TURNED_BANDS, r, f, f);
        if (every > 0 && k % (int)every == 0) extreme_renorm(norm, f);
    }
    for (l = 0; l < TURNED_BANDS; l++) {
        double square = 0, left = every > 0 ? fmod(turns, every) : turns;
        for (i = l * l; i < (l + 1) * (l + 1); i++) square += (double)f[i] * (double)f[i];
        extreme_take(&worst, sqrt(square) / norm[l] - 1, ((5 + 0.87 * l) * left + 4) * EXTREME_EPS);
    }
    return worst;
}

/* One matrix for many turns, R <- Q R in prt_real: how far R R^T is from 1. every: Gram-Schmidt after so many turns. A
   turn adds what rounding Q (sqrt(3) eps) and three products (1.5 sqrt(3) eps, on both sides) leave, 7 eps at most. */
static extreme extreme_matrix(double turns, double every) {
    prt_real q[9], r[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, out[9];
    extreme worst = extreme_none();
    double left = every > 0 ? fmod(turns, every) : turns;
    int k, i, j;
    extreme_turn(EXTREME_ANGLE, q);
    for (k = 1; k <= (int)turns; k++) {
        for (i = 0; i < 9; i++) out[i] = q[i / 3 * 3] * r[i % 3] + q[i / 3 * 3 + 1] * r[3 + i % 3] +
                                         q[i / 3 * 3 + 2] * r[6 + i % 3];
        memcpy(r, out, sizeof r);
        for (i = 0; i < 3 && every > 0 && k % (int)every == 0; i++) {
            prt_real length, dot;
            for (j = 0; j < i; j++) {
                dot = r[3 * i] * r[3 * j] + r[3 * i + 1] * r[3 * j + 1] + r[3 * i + 2] * r[3 * j + 2];
                r[3 * i] -= dot * r[3 * j]; r[3 * i + 1] -= dot * r[3 * j + 1]; r[3 * i + 2] -= dot * r[3 * j + 2];
            }
            dot = r[3 * i] * r[3 * i] + r[3 * i + 1] * r[3 * i + 1] + r[3 * i + 2] * r[3 * i + 2];
            length = (prt_real)sqrt((double)dot);
            r[3 * i] /= length; r[3 * i + 1] /= length; r[3 * i + 2] /= length;
        }
    }
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) {
            double dot = (double)r[3 * i] * (double)r[3 * j] + (double)r[3 * i + 1] * (double)r[3 * j + 1] +
                         (double)r[3 * i + 2] * (double)r[3 * j + 2];
            extreme_take(&worst, dot - (i == j), (7 * left + 4) * EXTREME_EPS);
        }
    return worst;
}

/* ---- chains of masks ---- */

/* So many masks by one hemisphere, of a light that is 1 all round: the norm that is left of 1. One exact mask leaves
   sqrt(1/2), and all others leave that. */
static double extreme_mask_gain(int masks, prt_window w, int filter_alone) {
    enum { N = 3 };
    prt_real light[N * N], filter[N * N];
    double before, after;
    int k;
    prt_sh_hemisphere(N, extreme_vec3(0, 0, 1), 1, 1, light);
    prt_sh_hemisphere(N, extreme_vec3(0.6, 0, 0.8), 1, 0, filter);
    before = (double)prt_sh_dot(N, light, light);
    for (k = 0; k < masks; k++) {
        if (filter_alone) prt_sh_mask_filter(N, w, light, filter, light);
        else prt_sh_mask(N, w, light, filter, light);
    }
    after = (double)prt_sh_dot(N, light, light);
    return sqrt(after / before);
}
/* Under the positive window on the filter the norm never grows (prt_sh_mask_filter): the error is what exceeds 1. */
static extreme extreme_masks(double masks, double window) {
    double gain = extreme_mask_gain((int)masks, (prt_window)(int)window, 1);
    double over = gain > 1 ? gain - 1 : gain >= 0 ? 0 : gain;
    extreme worst = extreme_none();
    extreme_take(&worst, over, 8 * masks * EXTREME_EPS);
    return worst;
}

/* ---- bakes ---- */

/* a wall x > 0: half of the sky of a point at the origin that faces up */
static int extreme_wall(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    int k;
    (void)user;
    for (k = 0; k < count; k++) blocked[k] = rays[k].dir.x > 0;
    return 0;
}

/* (1/pi) int over x < 0 of cos Y: 1/2 of the open sky; Y(1,1) gives -sqrt(3/4pi) 2/(3 pi). With N lattice rays a
   straight edge through them misses its length by few of their spacings: 4 N^-3/4; the sum of N numbers errs by eps. */
static extreme extreme_rays(double rays, double unused) {
    prt_tracer tracer = { NULL, extreme_wall, NULL };
    prt_point point;
    prt_bake_desc desc;
    prt_real t[9];
    extreme worst = extreme_none();
    double y0 = sqrt(1 / (4 * extreme_pi)), y1 = sqrt(3 / (4 * extreme_pi)), bound = pow(rays, -0.75);
    (void)unused;
    memset(&desc, 0, sizeof desc);
    memset(t, 0, sizeof t);
    point.position = extreme_vec3(0, 0, 0);
    point.normal = extreme_vec3(0, 0, 1);
    desc.bands = 3;
    desc.tracer = &tracer;
    desc.samples = (int)rays;
    prt_bake_transfer(&desc, 1, &point, 0, 1, t);
    extreme_take(&worst, (double)t[0] - 0.5 * y0, bound + 1e-6);
    extreme_take(&worst, (double)t[PRT_SH_INDEX(1, 0)] - y1 / 3, bound + 1e-6);
    extreme_take(&worst, (double)t[PRT_SH_INDEX(1, -1)], bound + 1e-6);
    extreme_take(&worst, (double)t[PRT_SH_INDEX(1, 1)] + y1 * 2 / (3 * extreme_pi), bound + 1e-6);
    return worst;
}

/* A ball over a plane of any size, far from the origin or not: the geometry is scaled by powers of two, so transfer
   must not change by more than what the bias moves, three rays on the rim. away: distance from the origin in sizes. */
typedef struct extreme_ball { double x, y, z, radius; } extreme_ball;
static int extreme_ball_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    const extreme_ball *b = (const extreme_ball *)user;
    int k;
    for (k = 0; k < count; k++) {
        double ox = b->x - (double)rays[k].origin.x, oy = b->y - (double)rays[k].origin.y;
        double oz = b->z - (double)rays[k].origin.z;
        double along = ox * (double)rays[k].dir.x + oy * (double)rays[k].dir.y + oz * (double)rays[k].dir.z;
        blocked[k] = along > 0 && ox * ox + oy * oy + oz * oz - along * along < b->radius * b->radius;
    }
    return 0;
}
static void extreme_bake_ball(double size, double away, prt_real *t) {
    double shift = away * size;
    extreme_ball b;
    prt_tracer tracer = { NULL, extreme_ball_occluded, NULL };
    prt_point point;
    prt_bake_desc desc;
    b.x = 0.25 * size + shift; b.y = -0.5 * size + shift; b.z = 2 * size; b.radius = 0.75 * size;
    tracer.user = &b;
    point.position = extreme_vec3(0.1 * size + shift, shift, 0);
    point.normal = extreme_vec3(0, 0, 1);
    memset(&desc, 0, sizeof desc);
    desc.samples = 4096;
    desc.scene_radius = (prt_real)(2 * size);
    desc.tracer = &tracer;
    prt_bake_transfer(&desc, 1, &point, 0, 1, t);
}
static extreme extreme_scene(double exponent, double away) {
    prt_real first[25] = { 0 }, t[25] = { 0 };
    extreme worst = extreme_none();
    int i;
    extreme_bake_ball(1, 0, first);
    extreme_bake_ball(ldexp(1, (int)exponent), away, t);
    for (i = 0; i < 25; i++) extreme_take(&worst, (double)t[i] - (double)first[i], 3.0 / 4096);
    return worst;
}

/* The normal at the second corner of a tetrahedron of this size, `away` sizes from the origin, where a slope meets two
   walls at angles of 60, 45 and 45 degrees: as good as its coordinates. */
static extreme extreme_normals(double size, double away) {
    static const uint32_t faces[12] = { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };
    static const double at[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    prt_vec3 positions[4];
    prt_point points[4];
    prt_mesh mesh;
    extreme worst = extreme_none();
    double shift = away * size, slope = extreme_pi / 3 / sqrt(3.0), up = slope - extreme_pi / 4;
    double length = sqrt(slope * slope + 2 * up * up), bound = (8 + 4 * away) * EXTREME_EPS;
    int i;
    memset(&mesh, 0, sizeof mesh);
    memset(points, 0, sizeof points);
    mesh.vertex_count = 4;
    mesh.positions = positions;
    mesh.triangle_count = 4;
    mesh.triangles = faces;
    for (i = 0; i < 4; i++)
        positions[i] = extreme_vec3(at[i][0] * size + shift, at[i][1] * size - 0.7 * shift,
                                    at[i][2] * size + 0.9 * shift);
    prt_points_from_vertices(&mesh, points, NULL);
    extreme_take(&worst, (double)points[1].normal.x - slope / length, bound);
    extreme_take(&worst, (double)points[1].normal.y - up / length, bound);
    extreme_take(&worst, (double)points[1].normal.z - up / length, bound);
    return worst;
}

/* ---- lights and occluders of any size, around the receiver ---- */

/* The share of directions that meet a sphere of this radius at this distance: (1 - cos a)/2, all from inside, on its
   surface half. Relative to all. */
static extreme extreme_sphere(double distance, double radius) {
    prt_real f[16] = { 0 };
    extreme worst = extreme_none();
    double whole = sqrt(4 * extreme_pi), q = radius / distance;
    double share = distance <= radius ? 1 : q * q / (1 + sqrt((1 - q) * (1 + q))) / 2;
    int i;
    prt_sh_sphere(4, extreme_vec3(0, distance, 0), (prt_real)radius, f);
    /* 1 ulp of distance over cosine is what rounding costs there */
    extreme_take(&worst, (double)f[0] / whole - share,
                 (8 + (distance > radius ? 2 / sqrt((1 - q) * (1 + q)) : 0)) * EXTREME_EPS);
    for (i = 1; i < 16 && distance <= radius; i++) extreme_take(&worst, (double)f[i], 0);
    return worst;
}

/* Shadows of irradiance vectors and of vector occluders in a scene of size 2^exponent, `away` sizes from the origin:
   against size 1 at the origin. Places are as exact as coordinates. */
static void extreme_shade_fiv(double size, double away, prt_rgb *out) {
    static const double distances[3] = { 1.25, 2, 4 };
    prt_real rho[3];
    prt_fiv samples[3 * 5 * 8];
    prt_fiv_table table;
    prt_fiv_occluder o;
    prt_rgb total = { 3, 2, 1 };
    double shift = away * size;
    int k, i, j;
    memset(&table, 0, sizeof table);
    for (k = 0; k < 3; k++) {
        rho[k] = (prt_real)(distances[k] * size);
        for (i = 0; i < 5; i++)
            for (j = 0; j < 8; j++) {
                double theta = extreme_pi * i / 4, phi = extreme_pi * j / 4, most = 1 / (distances[k] * distances[k]);
                prt_fiv *s = &samples[(k * 5 + i) * 8 + j];
                s->r = extreme_vec3(most * sin(theta) * cos(phi), most * sin(theta) * sin(phi), most * cos(theta));
                s->g = s->b = s->r;
            }
    }
    table.theta_count = 5;
    table.phi_count = 8;
    table.rho_count = 3;
    table.rho = rho;
    table.radius = (prt_real)size;
    table.samples = samples;
    o.table = &table;
    o.position = extreme_vec3(0.53 * size + shift, -0.72 * size + shift, 1.51 * size + shift);
    prt_fiv_shade(total, extreme_vec3(shift, shift, shift), extreme_vec3(0.36, 0.48, 0.8), 1, &o, 0, out);
}

/* A scene of size 1 at the origin, and the same at another size, so many sizes away. */
static extreme extreme_moved(void (*shade)(double size, double away, prt_rgb *out), double exponent, double away,
                             double allowed) {
    prt_rgb one = { 0, 0, 0 }, other = { 9, 9, 9 };
    extreme worst = extreme_none();
    shade(1, 0, &one);
    shade(ldexp(1, (int)exponent), away, &other);
    extreme_take(&worst, (double)other.r - (double)one.r, allowed);
    return worst;
}
static extreme extreme_fiv(double exponent, double away) {
    return extreme_moved(extreme_shade_fiv, exponent, away, (100 + 8 * away) * EXTREME_EPS);
}

static void extreme_shade_vo(double size, double away, prt_rgb *out) {
    prt_vo_params params;
    prt_vo_point point;
    prt_vo_occluder o;
    prt_point_light light;
    double shift = away * size;
    memset(&params, 0, sizeof params);
    memset(&point, 0, sizeof point);
    memset(&o, 0, sizeof o);
    point.position = extreme_vec3(shift, shift, shift);
    point.normal = extreme_vec3(0, 0, 1);
    point.diffuse.r = point.specular.r = 1;
    point.shininess = 4;
    o.position = extreme_vec3(1.03 * size + shift, 0.02 * size + shift, 0.98 * size + shift);
    o.occlusion = extreme_vec3(0.6, 0, 0.8);
    o.diffuse_normal = extreme_vec3(-0.25, 0, 0.125);
    o.specular_normal = extreme_vec3(-0.125, 0.0625, 0);
    o.diffuse.r = o.specular.r = (prt_real)0.5;
    o.form_factor = (prt_real)0.25;
    light.position = extreme_vec3(-2.1 * size + shift, 0.9 * size + shift, 4.2 * size + shift);
    light.color.r = light.color.g = light.color.b = 1;
    prt_vo_shade(&params, &point, extreme_vec3(2.9 * size + shift, -1.1 * size + shift, 2.2 * size + shift), 1, &o, 1,
                 &light, out);
}
static extreme extreme_vo(double exponent, double away) {
    return extreme_moved(extreme_shade_vo, exponent, away, (64 + 32 * away) * EXTREME_EPS);
}

/* ---- the list ---- */

typedef struct extreme_case {
    const char *section, *what;
    extreme    (*measure)(double a, double b);
    double     a, b;
    int        subnormal;                                   /* needs subnormal numbers: not under -ffast-math */
} extreme_case;

#define EXTREME_POLES "Directions beside the poles"
#define EXTREME_BANDS "Many bands"
#define EXTREME_LIGHT "Radiance from subnormal to huge"
#define EXTREME_TURNS "A million rotations"
#define EXTREME_CHAIN "Chains of masks"
#define EXTREME_BAKES "Bakes of one ray and of a million"
#define EXTREME_NEAR  "Lights around the receiver"
#define EXTREME_SIZES "Scenes of any size, anywhere"

static const extreme_case extreme_cases[] = {
    { EXTREME_POLES, "3 bands, at the pole", extreme_pole, 3, 0, 0 },
    { EXTREME_POLES, "3 bands, 1e-30 beside it", extreme_pole, 3, 1e-30, 0 },
    { EXTREME_POLES, "6 bands, at the pole", extreme_pole, 6, 0, 0 },
    { EXTREME_POLES, "6 bands, 1e-6 beside it", extreme_pole, 6, 1e-6, 0 },
    { EXTREME_POLES, "6 bands, 1e-30 beside it", extreme_pole, 6, 1e-30, 0 },
    { EXTREME_POLES, "10 bands, 1e-12 beside it", extreme_pole, 10, 1e-12, 0 },
    { EXTREME_POLES, "10 bands, 1e-20 beside it", extreme_pole, 10, 1e-20, 0 },
    { EXTREME_POLES, "10 bands, 1e-37 beside it", extreme_pole, 10, 1e-37, 1 },
    { EXTREME_POLES, "13 bands, 1e-30 beside it", extreme_pole, 13, 1e-30, 0 },
    { EXTREME_POLES, "64 bands, at the pole", extreme_pole, 64, 0, 0 },
    { EXTREME_POLES, "64 bands, 1e-30 beside it", extreme_pole, 64, 1e-30, 0 },
    { EXTREME_BANDS, "10 bands", extreme_bands, 10, 0, 0 },
    { EXTREME_BANDS, "64 bands", extreme_bands, 64, 0, 0 },
#if PRT_MAX_BANDS >= 1024
    { EXTREME_BANDS, "256 bands", extreme_bands, 256, 0, 0 },
    { EXTREME_BANDS, "1024 bands", extreme_bands, 1024, 0, 0 },
#endif
    { EXTREME_LIGHT, "1e-42", extreme_radiance, 1e-42, 0, 1 },
    { EXTREME_LIGHT, "1e-38", extreme_radiance, 1e-38, 0, 1 },
    { EXTREME_LIGHT, "1e-36", extreme_radiance, 1e-36, 0, 1 },
    { EXTREME_LIGHT, "1e-30", extreme_radiance, 1e-30, 0, 1 },
    { EXTREME_LIGHT, "1e-25", extreme_radiance, 1e-25, 0, 0 },
    { EXTREME_LIGHT, "1e30", extreme_radiance, 1e30, 0, 0 },
    { EXTREME_LIGHT, "1e36", extreme_radiance, 1e36, 0, 0 },
    { EXTREME_LIGHT, "1e38", extreme_radiance, 1e38, 0, 0 },
    { EXTREME_TURNS, "a vector, 1 turn", extreme_drift, 1, 0, 0 },
    { EXTREME_TURNS, "a vector, 1000 turns", extreme_drift, 1000, 0, 0 },
    { EXTREME_TURNS, "a vector, 10^6 turns", extreme_drift, 1000000, 0, 0 },
    { EXTREME_TURNS, "a vector, 10^6 turns, bands scaled back every 1000", extreme_drift, 1000000, 1000, 0 },
    { EXTREME_TURNS, "a matrix, 1000 turns", extreme_matrix, 1000, 0, 0 },
    { EXTREME_TURNS, "a matrix, 10^6 turns", extreme_matrix, 1000000, 0, 0 },
    { EXTREME_TURNS, "a matrix, 10^6 turns, Gram-Schmidt every 1000", extreme_matrix, 1000000, 1000, 0 },
    { EXTREME_CHAIN, "1 mask, positive window", extreme_masks, 1, PRT_WINDOW_POSITIVE, 0 },
    { EXTREME_CHAIN, "8 masks, positive window", extreme_masks, 8, PRT_WINDOW_POSITIVE, 0 },
    { EXTREME_CHAIN, "64 masks, positive window", extreme_masks, 64, PRT_WINDOW_POSITIVE, 0 },
    { EXTREME_BAKES, "1 ray", extreme_rays, 1, 0, 0 },
    { EXTREME_BAKES, "2 rays", extreme_rays, 2, 0, 0 },
    { EXTREME_BAKES, "100 rays", extreme_rays, 100, 0, 0 },
    { EXTREME_BAKES, "10^4 rays", extreme_rays, 10000, 0, 0 },
    { EXTREME_BAKES, "10^6 rays", extreme_rays, 1000000, 0, 0 },
    { EXTREME_NEAR, "at the centre of a sphere", extreme_sphere, 0, 1, 0 },
    { EXTREME_NEAR, "inside it", extreme_sphere, 0.5, 1, 0 },
    { EXTREME_NEAR, "just outside, 1.0001 radii", extreme_sphere, 1.0001, 1, 0 },
    { EXTREME_NEAR, "very far", extreme_sphere, EXTREME_FAR, 1, 0 },
    { EXTREME_NEAR, "a tiny sphere, two radii away", extreme_sphere, EXTREME_TINY, EXTREME_TINY / 2, 0 },
    { EXTREME_SIZES, "bake, 1e-6", extreme_scene, -20, 0, 0 },
    { EXTREME_SIZES, "bake, 1e6", extreme_scene, 20, 0, 0 },
    { EXTREME_SIZES, "bake, 1, 64 sizes from the origin", extreme_scene, 0, 64, 0 },
    { EXTREME_SIZES, "bake, 1e-6, 64 sizes from the origin", extreme_scene, -20, 64, 0 },
    { EXTREME_SIZES, "bake, 1e6, 64 sizes from the origin", extreme_scene, 20, 64, 0 },
    { EXTREME_SIZES, "normals, 1e-6", extreme_normals, 1e-6, 0, 0 },
    { EXTREME_SIZES, "normals, 1e6", extreme_normals, 1e6, 0, 0 },
    { EXTREME_SIZES, "normals, 1e-6, 1000 sizes from the origin", extreme_normals, 1e-6, 1000, 0 },
    { EXTREME_SIZES, "normals, 1e6, 1000 sizes from the origin", extreme_normals, 1e6, 1000, 0 },
    { EXTREME_SIZES, "irradiance vectors, 1e-6", extreme_fiv, -20, 0, 0 },
    { EXTREME_SIZES, "irradiance vectors, 1e6, 64 sizes from the origin", extreme_fiv, 20, 64, 0 },
    { EXTREME_SIZES, "vector occluders, 1e-6", extreme_vo, -20, 0, 0 },
    { EXTREME_SIZES, "vector occluders, 1e6, 64 sizes from the origin", extreme_vo, 20, 64, 0 },
};
enum { EXTREME_CASES = sizeof extreme_cases / sizeof *extreme_cases };

#endif
