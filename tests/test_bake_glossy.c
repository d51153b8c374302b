/* >>glossy: transfer matrices against quadrature with an analytic ball and a reflecting plane; the whole way from light
   to a Phong lobe against one integral; frames, folding, BRDF matrices; ranges, errors, memory. */
#include "memory_hook.h"
#include "test.h"
#include "geometry.h"
#include "tracer.h"
#include <limits.h>

enum { BANDS = 5, N = PRT_SH_COUNT(BANDS), MOST = 6 * 6 };

static double dot3(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static prt_real scrambled(int k) { return (prt_real)(sin(12.9898 * k + 1) * 0.7); }

static double legendre(int l, double z) {
    double p = 1, before = 0;
    int k;
    for (k = 1; k <= l; k++) { double next = ((2 * k - 1) * z * p - (k - 1) * before) / k; before = p; p = next; }
    return p;
}

/* Real spherical harmonics from the textbook: associated Legendre polynomials without the phase, factorials, angles. */
static void textbook_sh(int bands, const double d[3], double *y) {
    double s = sqrt(fmax(0, 1 - d[2] * d[2])), phi = atan2(d[1], d[0]);
    int l, m, k;
    for (m = 0; m < bands; m++) {
        double before = 0, p = 1;
        for (k = 1; k <= m; k++) p *= (2 * k - 1) * s;
        for (l = m; l < bands; l++) {
            double norm = (2 * l + 1) / (4 * pi), next;
            for (k = l - m + 1; k <= l + m; k++) norm /= k;
            y[PRT_SH_INDEX(l, m)] = sqrt(norm) * p * (m ? sqrt(2) * cos(m * phi) : 1);
            if (m) y[PRT_SH_INDEX(l, -m)] = sqrt(norm) * p * sqrt(2) * sin(m * phi);
            next = ((2 * l + 1) * d[2] * p - (l + m) * before) / (l - m + 1);
            before = p;
            p = next;
        }
    }
}

/* ---- a scene: a ball over a point, and a plane of one triangle below it ---- */

typedef struct world { double centre[3], radius, plane; int calls, fail_at; } world;

static const uint32_t one_triangle[3] = { 0, 1, 2 };

static int meets_ball(const world *s, const double o[3], const double d[3], double *t) {
    double to[3], along, off;
    int k;
    for (k = 0; k < 3; k++) to[k] = s->centre[k] - o[k];
    along = dot3(to, d);
    off = s->radius * s->radius - (dot3(to, to) - along * along);
    *t = along - sqrt(fmax(0, off));
    return s->radius > 0 && off > 0 && along > 0;
}

/* Object 0 is the ball, object 1 the plane. */
static int world_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    world *s = (world *)user;
    int k;
    if (++s->calls == s->fail_at) return 1;
    for (k = 0; k < count; k++) {
        double o[3], d[3], t, n[3];
        o[0] = (double)rays[k].origin.x; o[1] = (double)rays[k].origin.y; o[2] = (double)rays[k].origin.z;
        d[0] = (double)rays[k].dir.x; d[1] = (double)rays[k].dir.y; d[2] = (double)rays[k].dir.z;
        if (meets_ball(s, o, d, &t)) {
            int c;
            memset(&hits[k], 0, sizeof hits[k]);
            for (c = 0; c < 3; c++) n[c] = (o[c] + t * d[c] - s->centre[c]) / s->radius;
            hits[k].t = (prt_real)t;
            hits[k].normal = vec3(n[0], n[1], n[2]);
        } else if (d[2] < 0 && s->plane < o[2]) {
            memset(&hits[k], 0, sizeof hits[k]);
            hits[k].object = 1;
            hits[k].t = (prt_real)((s->plane - o[2]) / d[2]);
            hits[k].u = PRT__R(0.25);
            hits[k].v = PRT__R(0.125);
            hits[k].normal = vec3(0, 0, 1);
        }
    }
    return 0;
}

static int world_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    return occluded_by(world_closest, user, count, rays, blocked);
}

typedef struct setup {
    world world;
    prt_tracer tracer;
    prt_bounce_desc desc;
    prt_bounce_object objects[2];
    prt_point points[16];
} setup;

/* Points 0, 1, 2 are the plane's; the others stand above it and look around. */
static void begin(setup *s) {
    int k;
    memset(s, 0, sizeof *s);
    s->world.plane = 1e30;                         /* above everything: never met */
    s->tracer.user = &s->world;
    s->tracer.closest = world_closest;
    s->tracer.occluded = world_occluded;
    s->desc.tracer = &s->tracer;
    s->desc.objects = s->objects;
    s->desc.object_count = 2;
    s->desc.bias = PRT__R(1e-9);
    s->objects[1].triangle_count = 1;
    s->objects[1].triangles = one_triangle;
    s->objects[1].albedo = rgb(0.5, 0.5, 0.5);
    for (k = 0; k < 16; k++) {
        double z = 1 - 2 * (k + 0.5) / 16, r = sqrt(1 - z * z);
        s->points[k].normal = vec3(r * cos(2.4 * k), r * sin(2.4 * k), z);
    }
    s->points[3].normal = vec3(0, 0, 1);
    s->points[4].normal = vec3(0, 0, -1);
    s->points[5].normal = vec3(0.48, 0.6, 0.64);
}

/* ---- quadrature ---- */

/* f with the weight of each node of a rule over the cap of `angle` about `axis`: rings by Gauss's rule of two nodes,
   azimuths evenly. Exact to 1e-9 for what is integrated here. */
typedef void integrand(void *user, const double w[3], double weight);
static void over_cap(const double axis[3], double angle, integrand *f, void *user) {
    enum { RINGS = 160, SPOKES = 24 };
    double t[3], b[3], length = 0;
    int i, j, k, least = 0;
    for (k = 1; k < 3; k++) if (fabs(axis[k]) < fabs(axis[least])) least = k;
    for (k = 0; k < 3; k++) { t[k] = (k == least) - axis[least] * axis[k]; length += t[k] * t[k]; }
    for (k = 0; k < 3; k++) t[k] /= sqrt(length);
    for (k = 0; k < 3; k++) b[k] = axis[(k + 1) % 3] * t[(k + 2) % 3] - axis[(k + 2) % 3] * t[(k + 1) % 3];
    for (i = 0; i < RINGS; i++) {
        double u = (i / 2 + 0.5 + (i % 2 ? 0.5 : -0.5) / sqrt(3)) / (RINGS / 2), z = 1 - u * (1 - cos(angle));
        double r = sqrt(1 - z * z);
        for (j = 0; j < SPOKES; j++) {
            double c = r * cos(2 * pi * j / SPOKES), s = r * sin(2 * pi * j / SPOKES), w[3];
            for (k = 0; k < 3; k++) w[k] = c * t[k] + s * b[k] + z * axis[k];
            f(user, w, 2 * pi * (1 - cos(angle)) / (RINGS * SPOKES));
        }
    }
}

typedef struct matrix_sum { int in, out; double sign, *sum; } matrix_sum;
static void add_to_matrix(void *user, const double w[3], double weight) {
    const matrix_sum *s = (const matrix_sum *)user;
    double y[MOST];
    int i, j;
    textbook_sh(s->in > s->out ? s->in : s->out, w, y);
    for (i = 0; i < s->out * s->out; i++)
        for (j = 0; j < s->in * s->in; j++) s->sum[i * s->in * s->in + j] += s->sign * weight * y[i] * y[j];
}

/* The matrix under the ball, which must lie wholly above the horizon. */
static void want_matrix(const setup *s, prt_vec3 normal, int in, int out, double *want) {
    matrix_sum sum;
    double n[3], axis[3], distance;
    int k;
    n[0] = (double)normal.x; n[1] = (double)normal.y; n[2] = (double)normal.z;
    for (k = 0; k < in * in * out * out; k++) want[k] = 0;
    sum.in = in; sum.out = out; sum.sum = want; sum.sign = 1;
    over_cap(n, pi / 2, add_to_matrix, &sum);
    if (!(s->world.radius > 0)) return;
    distance = sqrt(dot3(s->world.centre, s->world.centre));
    for (k = 0; k < 3; k++) axis[k] = s->world.centre[k] / distance;
    sum.sign = -1;
    over_cap(axis, asin(s->world.radius / distance), add_to_matrix, &sum);
}

static void put_ball(setup *s, double x, double y, double z, double radius) {
    s->world.centre[0] = x; s->world.centre[1] = y; s->world.centre[2] = z;
    s->world.radius = radius;
}

/* Mean over seeds within 6 standard errors of want, and the 2-norm of a single one's error, relative to want's. */
static double assert_unbiased(setup *s, int bands_out, const prt_real *transfer, int point, int numbers,
                              const double *want) {
    enum { SEEDS = 16 };
    static prt_real got[16 * 3 * MOST * MOST];
    static double sum[3 * MOST * MOST], square[3 * MOST * MOST];
    double total = 0, norm = 0;
    int seed, i;
    for (i = 0; i < numbers; i++) { sum[i] = square[i] = 0; norm += want[i] * want[i]; }
    for (seed = 0; seed < SEEDS; seed++) {
        s->desc.seed = (uint64_t)seed;
        assert_int_equal(prt_bake_glossy(&s->desc, bands_out, 16, s->points, transfer, point, 1, got), PRT_OK);
        for (i = 0; i < numbers; i++) {
            double off = (double)got[point * numbers + i] - want[i];
            sum[i] += off;
            square[i] += off * off;
            total += off * off;
        }
    }
    for (i = 0; i < numbers; i++) {
        double mean = sum[i] / SEEDS, error = sqrt(fmax(0, square[i] / SEEDS - mean * mean) / (SEEDS - 1));
        assert_near(mean, 0, 6 * error + 2e-6);    /* 64 rays are summed in float at a time */
    }
    return sqrt(total / SEEDS / norm);
}

static void shadows_are_the_quadrature(void **state) {
    static const int in[3] = { 5, 3, 6 }, out[3] = { 5, 6, 2 };
    static double want[MOST * MOST];
    setup s;
    int q, point;
    (void)state;
    for (q = 0; q < 3; q++) for (point = 3; point <= 5; point++) {
        double err[2];
        begin(&s);
        s.desc.bands = in[q];
        if (point == 4) s.desc.tracer = NULL;
        if (point == 3) put_ball(&s, 0.5, -0.25, 2, 1);
        if (point == 5) put_ball(&s, 1.5, 1, 1.5, 0.7);
        want_matrix(&s, s.points[point].normal, in[q], out[q], want);
        s.desc.samples = 1024;
        err[0] = assert_unbiased(&s, q ? out[q] : 0, NULL, point, in[q] * in[q] * out[q] * out[q], want);
        s.desc.samples = 0;                        /* 4096 */
        err[1] = assert_unbiased(&s, q ? out[q] : 0, NULL, point, in[q] * in[q] * out[q] * out[q], want);
        if (q == 0) printf("matrix, point %d: error %.4f at 1024 rays, %.4f at 4096\n", point, err[0], err[1]);
        assert_at_most(err[0], 0.015);
        assert_at_most(err[1], 0.006);
    }
}

/* Above a plane of transfer T and albedo a: Y_i Y_j over what is open, a T_j int Y_i over the rest. */
static void a_plane_reflects(void **state) {
    static prt_real transfer[16 * 3 * N];
    static double want[3 * N * N];
    double a[3] = { 0.5, 0.5, 0.5 };
    setup s;
    int k, c, i, j, colour;
    matrix_sum sum;
    static const double down[3] = { 0, 0, -1 }, up[3] = { 0, 0, 1 };
    (void)state;
    for (k = 0; k < 16 * 3 * N; k++) transfer[k] = scrambled(k);
    for (colour = 0; colour < 2; colour++) for (k = 3; k <= 4; k++) {
        double one[N * 1];
        int planes = colour ? 3 : 1;
        begin(&s);
        s.world.plane = -1;
        s.desc.samples = 2048;
        if (colour) { s.objects[1].albedo = rgb(1, 0.5, 0.25); a[0] = 1; a[2] = 0.25; }
        memset(one, 0, sizeof one);
        sum.in = 1; sum.out = BANDS; sum.sum = one; sum.sign = 1;
        over_cap(down, pi / 2, add_to_matrix, &sum);
        for (c = 0; c < planes; c++)
            for (i = 0; i < N; i++)
                for (j = 0; j < N; j++)
                    want[(c * N + i) * N + j] = k == 3 ? 0 : a[c] * one[i] * 2 * sqrt(pi) *
                        (0.625 * (double)transfer[j] + 0.25 * (double)transfer[N + j] +
                         0.125 * (double)transfer[2 * N + j]);
        sum.in = BANDS; sum.sum = want;            /* the point that looks up sees the sky alone */
        for (c = 0; c < planes && k == 3; c++, sum.sum += N * N) over_cap(up, pi / 2, add_to_matrix, &sum);
        assert_unbiased(&s, 0, transfer, k, planes * N * N, want);
    }
}

/* In a white furnace light arrives from everywhere whatever stands there, if it is white and lit by the same. */
static void furnace_is_white(void **state) {
    static prt_real transfer[16 * N], open[16 * N * N], closed[16 * N * N];
    prt_real light[3 * N] = { 0 }, a[3 * N], b[3 * N];
    setup s;
    int k, i;
    (void)state;
    begin(&s);
    s.objects[0] = s.objects[1];
    s.objects[0].albedo = s.objects[1].albedo = rgb(1, 1, 1);
    for (k = 0; k < 16; k++) transfer[k * N] = (prt_real)(0.5 / sqrt(pi));
    light[0] = light[N] = light[2 * N] = (prt_real)(2 * sqrt(pi));
    s.desc.samples = 1000;
    s.desc.tracer = NULL;
    assert_int_equal(prt_bake_glossy(&s.desc, 0, 16, s.points, NULL, 0, 16, open), PRT_OK);
    s.desc.tracer = &s.tracer;
    s.world.plane = -1;
    put_ball(&s, 1, 0, 2, 1);
    assert_int_equal(prt_bake_glossy(&s.desc, 0, 16, s.points, transfer, 0, 16, closed), PRT_OK);
    for (k = 0; k < 16; k++) {
        assert_int_equal(prt_shade_incident(BANDS, BANDS, 1, open + k * N * N, light, a), PRT_OK);
        assert_int_equal(prt_shade_incident(BANDS, BANDS, 1, closed + k * N * N, light, b), PRT_OK);
        for (i = 0; i < 3 * N; i++) assert_near(a[i], b[i], 100 * (double)PRT__EPS);
    }
}

/* ---- the whole way ---- */

/* int V L h dw with the light and the lobe in their bands: what shading from the matrix must give. */
typedef struct lobe_sum { const double *light, *h; double r[3], sign, out; } lobe_sum;
static void add_to_lobe(void *user, const double w[3], double weight) {
    lobe_sum *s = (lobe_sum *)user;
    double y[N], light = 0, h = 0;
    int k;
    textbook_sh(BANDS, w, y);
    for (k = 0; k < N; k++) light += s->light[k] * y[k];
    for (k = 0; k < BANDS; k++) h += s->h[k] * sqrt((2 * k + 1) / (4 * pi)) * legendre(k, dot3(w, s->r));
    s->out += s->sign * weight * light * h;
}

/* Zonal coefficients of Phong's lobe by Simpson's rule, within 1e-11 for s <= 60. */
static double phong_zonal(double s, int l) {
    enum { STEPS = 20000 };
    double sum = 0;
    int k;
    for (k = 0; k <= STEPS; k++) {
        double z = (double)k / STEPS;
        sum += (k == 0 || k == STEPS ? 1 : k % 2 ? 4 : 2) * (s > 0 || k > 0 ? pow(z, s) : 1) * legendre(l, z);
    }
    return sqrt((2 * l + 1) / (4 * pi)) * (s + 1) * sum / (3 * STEPS);
}

static void light_to_lobe(void **state) {
    static const double eye[3][3] = { { 0, 0, 1 }, { 0.6, 0, 0.8 }, { -0.48, 0.64, 0.6 } };
    static prt_real matrix[16 * N * N];
    double light[N], h[BANDS], normal[3], axis[3], distance;
    prt_real sh[3 * N], incident[3 * N], zonal[BANDS], turned[3 * N], rotation[9], folded[N * N];
    setup s;
    lobe_sum sum;
    int q, k, c;
    (void)state;
    begin(&s);
    put_ball(&s, 1.5, 1, 1.5, 0.7);
    s.desc.samples = 200000;
    assert_int_equal(prt_bake_glossy(&s.desc, 0, 16, s.points, NULL, 5, 1, matrix), PRT_OK);
    for (k = 0; k < 3 * N; k++) sh[k] = scrambled(k) / (prt_real)(1 + k % N / 5);
    for (k = 0; k < BANDS; k++) h[k] = phong_zonal(12, k);
    assert_int_equal(prt_phong_zonal(BANDS, 12, zonal), PRT_OK);
    assert_int_equal(prt_local_frame(s.points[5].normal, rotation), PRT_OK);
    assert_int_equal(prt_shade_incident(BANDS, BANDS, 1, matrix + 5 * N * N, sh, incident), PRT_OK);
    for (c = 0; c < 3; c++)
        assert_int_equal(prt_sh_rotate(BANDS, rotation, incident + c * N, turned + c * N), PRT_OK);
    memcpy(folded, matrix + 5 * N * N, sizeof folded);
    assert_int_equal(prt_glossy_fold(BANDS, BANDS, 1, rotation, zonal, folded), PRT_OK);
    normal[0] = 0.48; normal[1] = 0.6; normal[2] = 0.64;
    distance = sqrt(dot3(s.world.centre, s.world.centre));
    for (k = 0; k < 3; k++) axis[k] = s.world.centre[k] / distance;
    for (q = 0; q < 3; q++) {
        double along = dot3(normal, eye[q]), want[3], local[3];
        prt_rgb plain, frame, ahead;
        prt_real exit[3 * N];
        prt_vec3 r;
        for (k = 0; k < 3; k++) sum.r[k] = 2 * along * normal[k] - eye[q][k];
        for (c = 0; c < 3; c++) {
            for (k = 0; k < N; k++) light[k] = (double)sh[c * N + k];
            sum.light = light; sum.h = h; sum.out = 0; sum.sign = 1;
            over_cap(normal, pi / 2, add_to_lobe, &sum);
            sum.sign = -1;
            over_cap(axis, asin(s.world.radius / distance), add_to_lobe, &sum);
            want[c] = sum.out;
        }
        r = vec3(sum.r[0], sum.r[1], sum.r[2]);
        assert_int_equal(prt_shade_glossy(BANDS, incident, zonal, r, &plain), PRT_OK);
        assert_near(plain.r, want[0], 5e-4);       /* 200000 rays: .0004 of the matrix, times light and lobe */
        assert_near(plain.g, want[1], 5e-4);
        assert_near(plain.b, want[2], 5e-4);
        for (k = 0; k < 3; k++)
            local[k] = (double)rotation[3 * k] * sum.r[0] + (double)rotation[3 * k + 1] * sum.r[1] +
                       (double)rotation[3 * k + 2] * sum.r[2];
        r = vec3(local[0], local[1], local[2]);
        assert_int_equal(prt_shade_glossy(BANDS, turned, zonal, r, &frame), PRT_OK);
        assert_int_equal(prt_shade_incident(BANDS, BANDS, 1, folded, sh, exit), PRT_OK);
        assert_int_equal(prt_shade_glossy(BANDS, exit, NULL, r, &ahead), PRT_OK);
        assert_near(frame.r, plain.r, 60 * (double)PRT__EPS);
        assert_near(frame.b, plain.b, 60 * (double)PRT__EPS);
        assert_near(ahead.r, plain.r, 60 * (double)PRT__EPS);
        assert_near(ahead.g, plain.g, 60 * (double)PRT__EPS);
    }
}

static void batches_and_planes(void **state) {
    enum { POINTS = 7 };
    prt_real matrices[POINTS * 3 * 16 * 9], light[3 * 9], incident[POINTS * 3 * 16], one[3 * 16], zonal[4];
    double h[4];
    prt_rgb out[POINTS], single;
    prt_vec3 dirs[POINTS];
    int k, c, i, j, planes;
    (void)state;
    for (k = 0; k < POINTS * 3 * 16 * 9; k++) matrices[k] = scrambled(k);
    for (k = 0; k < 27; k++) light[k] = scrambled(11 * k);
    for (k = 0; k < POINTS; k++) dirs[k] = vec3(cos(k), 0.6 * sin(k), 0.8 * sin(k));
    assert_int_equal(prt_phong_zonal(4, 3, zonal), PRT_OK);
    for (k = 0; k < 4; k++) h[k] = phong_zonal(3, k);
    for (planes = 1; planes <= 3; planes += 2) {
        assert_int_equal(prt_shade_incident_n(3, 4, planes, POINTS, matrices, light, incident), PRT_OK);
        assert_int_equal(prt_shade_glossy_n(4, POINTS, incident, zonal, dirs, out), PRT_OK);
        for (k = 0; k < POINTS; k++) {
            double want[3] = { 0, 0, 0 };
            assert_int_equal(prt_shade_incident(3, 4, planes, matrices + k * planes * 144, light, one), PRT_OK);
            for (c = 0; c < 3; c++) for (i = 0; i < 16; i++) {
                double sum = 0, y[16], d[3];
                const prt_real *row = matrices + (k * planes + (planes == 3 ? c : 0)) * 144 + i * 9;
                for (j = 0; j < 9; j++) sum += (double)row[j] * (double)light[9 * c + j];
                assert_near(incident[k * 48 + c * 16 + i], sum, 20 * (double)PRT__EPS);
                d[0] = (double)dirs[k].x; d[1] = (double)dirs[k].y; d[2] = (double)dirs[k].z;
                textbook_sh(4, d, y);
                j = (int)sqrt(i + 0.5);
                want[c] += sum * y[i] * sqrt(4 * pi / (2 * j + 1)) * h[j];
            }
            assert_near(out[k].r, want[0], 200 * (double)PRT__EPS);
            assert_near(out[k].g, want[1], 200 * (double)PRT__EPS);
            assert_near(out[k].b, want[2], 200 * (double)PRT__EPS);
            assert_int_equal(prt_shade_glossy(4, one, zonal, dirs[k], &single), PRT_OK);
            if (FAST_MATH) continue;
            assert_memory_equal(one, incident + k * 48, sizeof one);
            assert_memory_equal(&single, &out[k], sizeof single);
        }
    }
}

static void phong_is_its_integral(void **state) {
    static const double s[5] = { 0, 1, 5, 20, 60 };
    prt_real zonal[64], lobe[25];
    double all = 0, below = 0, half = 0;
    int q, l;
    (void)state;
    for (q = 0; q < 5; q++) {
        assert_int_equal(prt_phong_zonal(10, (prt_real)s[q], zonal), PRT_OK);
        for (l = 0; l < 10; l++) assert_near(zonal[l], phong_zonal(s[q], l), 4 * (double)PRT__EPS + 1e-11);
    }
    assert_int_equal(prt_phong_zonal(5, 1, zonal), PRT_OK);        /* exponent 1 is the cosine over pi */
    assert_int_equal(prt_sh_cosine_lobe(5, vec3(0, 0, 1), lobe), PRT_OK);
    for (l = 0; l < 5; l++) assert_near(zonal[l], (double)lobe[l * l + l] / pi, 4 * (double)PRT__EPS);
    assert_int_equal(prt_phong_zonal(64, 100, zonal), PRT_OK);     /* where the energy of a lobe lies */
    for (l = 0; l < 64; l++) {
        double energy = (double)zonal[l] * (double)zonal[l];
        all += energy;
        if (l < 8.3) half += energy;
        if (l < 21.5) below += energy;
    }
    printf("energy of a lobe of exponent 100 below l = 8.3: %.3f, below 21.5: %.4f\n", half / all, below / all);
    assert_near(half / all, 0.5, 0.06);            /* one band holds .06 */
    assert_near(below / all, 0.99, 0.005);
    assert_int_equal(prt_phong_zonal(64, BY_PRECISION(1e38f, 1e300), zonal), PRT_OK);
    for (l = 0; l < 64; l++) assert_near(zonal[l], sqrt((2 * l + 1) / (4 * pi)), 1e-5);       /* a mirror */
}

static void frames_are_frames(void **state) {
    prt_real m[9];
    int k, i, j;
    (void)state;
    for (k = 0; k < 100; k++) {
        double z = k == 98 ? 1 : k == 99 ? -1 : 1 - 2 * (k + 0.5) / 98, r = sqrt(1 - z * z), n[3];
        n[0] = r * cos(2.4 * k); n[1] = r * sin(2.4 * k); n[2] = z;
        assert_int_equal(prt_local_frame(vec3(n[0], n[1], n[2]), m), PRT_OK);
        for (i = 0; i < 3; i++) {
            double up = 0;
            for (j = 0; j < 3; j++) {
                double product = 0;
                int c;
                for (c = 0; c < 3; c++) product += (double)m[3 * i + c] * (double)m[3 * j + c];
                assert_near(product, i == j, 8 * (double)PRT__EPS);
                up += (double)m[3 * i + j] * n[j];
            }
            assert_near(up, i == 2, 4 * (double)PRT__EPS);
        }
        assert_near((double)m[0] * ((double)m[4] * (double)m[8] - (double)m[5] * (double)m[7]) -
                    (double)m[1] * ((double)m[3] * (double)m[8] - (double)m[5] * (double)m[6]) +
                    (double)m[2] * ((double)m[3] * (double)m[7] - (double)m[4] * (double)m[6]), 1,
                    12 * (double)PRT__EPS);
    }
    assert_int_equal(prt_local_frame(vec3(0, 0, 2), m), PRT_ERR_VALUE);
    assert_int_equal(prt_local_frame(vec3(0, 0, 1), NULL), PRT_ERR_NULL);
}

/* ---- matrices of BRDFs ---- */

static prt_real lambert(void *user, prt_vec3 w, prt_vec3 v) {
    (void)user; (void)w; (void)v;
    return PRT__R(0.318309886183790671538);
}
static prt_real skewed(void *user, prt_vec3 w, prt_vec3 v) { (void)user; return (w.x + 2) * (v.z - v.y / 2); }
static prt_real broken(void *user, prt_vec3 w, prt_vec3 v) {
    int *left = (int *)user;
    (void)w; (void)v;
    return (prt_real)(--*left < 0 ? INFINITY : 1);
}

typedef struct pair_sum { double from[N], to[N]; int skewed; } pair_sum;
static void add_to_pair(void *user, const double w[3], double weight) {
    pair_sum *s = (pair_sum *)user;
    double y[N];
    int i;
    textbook_sh(BANDS, w, y);
    for (i = 0; i < N; i++) {
        s->from[i] += weight * w[2] * y[i] * (s->skewed ? w[0] + 2 : 1 / pi);
        s->to[i] += weight * y[i] * (s->skewed ? w[2] - w[1] / 2 : 1);
    }
}

static void brdf_matrices(void **state) {
    static const double up[3] = { 0, 0, 1 };
    prt_real matrix[N * N];
    int which, i, j;
    (void)state;
    for (which = 0; which < 2; which++) {
        pair_sum want;
        memset(&want, 0, sizeof want);
        want.skewed = which;
        over_cap(up, pi / 2, add_to_pair, &want);
        assert_int_equal(prt_glossy_brdf(BANDS, BANDS, 500, which ? skewed : lambert, NULL, matrix), PRT_OK);
        for (i = 0; i < N; i++)                    /* 500 directions: .004 of a smooth function's norm, either way */
            for (j = 0; j < N; j++) assert_near(matrix[i * N + j], want.to[i] * want.from[j], which ? 0.04 : 0.01);
    }
    if (!FAST_MATH) {
        int left = 1000;
        prt_real marks[N * N];
        memset(matrix, 0xff, sizeof matrix);
        memset(marks, 0xff, sizeof marks);
        assert_int_equal(prt_glossy_brdf(BANDS, BANDS, 100, broken, &left, matrix), PRT_ERR_VALUE);
        assert_memory_equal(matrix, marks, sizeof marks);
    }
    assert_int_equal(prt_glossy_brdf(0, 5, 10, lambert, NULL, matrix), PRT_ERR_BANDS);
    assert_int_equal(prt_glossy_brdf(5, 65, 10, lambert, NULL, matrix), PRT_ERR_BANDS);
    assert_int_equal(prt_glossy_brdf(5, 5, -1, lambert, NULL, matrix), PRT_ERR_COUNT);
    assert_int_equal(prt_glossy_brdf(5, 5, 10, NULL, NULL, matrix), PRT_ERR_NULL);
    assert_int_equal(prt_glossy_brdf(5, 5, 10, lambert, NULL, NULL), PRT_ERR_NULL);
    memory_hook.fail = 1;
    assert_int_equal(prt_glossy_brdf(5, 5, 10, lambert, NULL, matrix), PRT_ERR_MEMORY);
    memory_hook.fail = 0;
    assert_int_equal(memory_hook.calls - 1, memory_hook.frees);
}

/* ---- the same bits; errors ---- */

static int stop_after(void *user, int done, int total) { (void)total; return done == *(int *)user; }

static void ranges_give_the_same_bits(void **state) {
    static prt_real transfer[16 * 9], whole[16 * 3 * 81], parts[16 * 3 * 81];
    setup s;
    int q, k, first, step, stop = 3;
    (void)state;
    for (k = 0; k < 16 * 9; k++) transfer[k] = scrambled(k);
    for (q = 0; q < 3; q++) for (step = 1; step < 16; step += 6) {
        const prt_real *from = q ? transfer : NULL;
        size_t all = 16 * (size_t)(q == 2 ? 3 : 1) * 81 * sizeof *whole;
        begin(&s);
        s.world.plane = -1;
        put_ball(&s, 1, 0, 2, 1);
        s.desc.bands = 3;
        s.desc.samples = 150 + 1000 * q;
        if (q == 2) s.objects[1].albedo = rgb(1, 0.5, 0);
        assert_int_equal(prt_bake_glossy(&s.desc, 0, 16, s.points, from, 0, 16, whole), PRT_OK);
        memset(parts, 0xff, sizeof parts);
        for (first = 0; first < 16; first += step)
            assert_int_equal(prt_bake_glossy(&s.desc, 0, 16, s.points, from, first,
                                             16 - first < step ? 16 - first : step, parts), PRT_OK);
        assert_memory_equal(whole, parts, all);
        memset(parts, 0xff, sizeof parts);
        s.desc.progress = stop_after; s.desc.progress_user = &stop;
        assert_int_equal(prt_bake_glossy(&s.desc, 0, 16, s.points, from, 0, 16, parts), PRT_ERR_CANCELLED);
        assert_memory_equal(whole, parts, all / 16 * 3);
        s.desc.progress = NULL;
        s.world.calls = 0; s.world.fail_at = 2;
        assert_int_equal(prt_bake_glossy(&s.desc, 0, 16, s.points, from, 0, 16, parts), PRT_ERR_TRACE);
    }
    assert_int_equal(memory_hook.calls - 1, memory_hook.frees);    /* the one that was refused above */
}

#define REFUSES(change, error) do { \
        setup s; \
        begin(&s); \
        s.desc.bands = 2; s.desc.samples = 8; s.world.plane = -1; \
        change; \
        assert_int_equal(prt_bake_glossy(p == 2 ? NULL : &s.desc, bands_out, 16, p == 1 ? NULL : s.points, from, \
                                         first, count, to), error); \
        assert_memory_equal(out, marks, sizeof out); \
    } while (0)

static void bad_arguments(void **state) {
    prt_real values[16 * 4] = { 0 }, out[16 * 16], marks[16 * 16], rotation[9] = { 0 }, zonal[2] = { 1, 1 };
    const prt_real *from = values;
    prt_real *to = out;
    int bands_out = 0, first = 0, count = 16, p = 0;
    prt_rgb colour;
    (void)state;
    memset(out, 0xff, sizeof out);
    memset(marks, 0xff, sizeof marks);
    p = 2; REFUSES((void)0, PRT_ERR_NULL); p = 0;
    REFUSES(s.desc.bands = -1, PRT_ERR_BANDS);
    bands_out = -1; REFUSES((void)0, PRT_ERR_BANDS);
    bands_out = PRT_MAX_BANDS + 1; REFUSES((void)0, PRT_ERR_BANDS);
    bands_out = 0;
    REFUSES(s.desc.samples = -1, PRT_ERR_COUNT);
    REFUSES(s.desc.planes = 2, PRT_ERR_COUNT);
    REFUSES(s.objects[1].first_point = 14, PRT_ERR_COUNT);
    first = 1; REFUSES((void)0, PRT_ERR_COUNT); first = 0;
    p = 1; REFUSES((void)0, PRT_ERR_NULL); p = 0;
    to = NULL; REFUSES((void)0, PRT_ERR_NULL); to = out;
    REFUSES(s.desc.objects = NULL, PRT_ERR_NULL);
    REFUSES(s.desc.tracer = NULL, PRT_ERR_NULL);
    REFUSES(s.tracer.closest = NULL, PRT_ERR_NULL);
    REFUSES(s.objects[1].albedo.g = 2, PRT_ERR_VALUE);
    REFUSES(s.desc.bias = -1, PRT_ERR_VALUE);
    REFUSES(s.points[9].normal.x = 3, PRT_ERR_VALUE);
    from = NULL;
    REFUSES(s.tracer.occluded = NULL, PRT_ERR_NULL);
    from = values;
    memory_hook.fail = 1; REFUSES((void)0, PRT_ERR_MEMORY); memory_hook.fail = 0;
    count = 0; REFUSES((void)0, PRT_OK);
    assert_true(prt_glossy_size(2, 3, 3, 10) == 3 * 4 * 9 * 10 * sizeof(prt_real));
    assert_true(prt_glossy_size(0, 3, 1, 1) == 0 && prt_glossy_size(3, 65, 1, 1) == 0);
    assert_true(prt_glossy_size(3, 3, 2, 1) == 0);
    assert_int_equal(prt_glossy_fold(0, 2, 1, NULL, NULL, out), PRT_ERR_BANDS);
    assert_int_equal(prt_glossy_fold(2, 2, 2, NULL, NULL, out), PRT_ERR_COUNT);
    assert_int_equal(prt_glossy_fold(2, 2, 1, NULL, NULL, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_glossy_fold(2, 2, 1, rotation, NULL, out), PRT_ERR_ROTATION);
    if (!FAST_MATH) {
        zonal[1] = (prt_real)NAN;
        assert_int_equal(prt_glossy_fold(2, 2, 1, NULL, zonal, out), PRT_ERR_VALUE);
        assert_int_equal(prt_phong_zonal(2, (prt_real)NAN, zonal), PRT_ERR_VALUE);
    }
    assert_int_equal(prt_phong_zonal(0, 1, zonal), PRT_ERR_BANDS);
    assert_int_equal(prt_phong_zonal(2, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_phong_zonal(2, -1, zonal), PRT_ERR_VALUE);
    assert_int_equal(prt_shade_incident(0, 2, 1, values, values, out), PRT_ERR_BANDS);
    assert_int_equal(prt_shade_incident(2, 65, 1, values, values, out), PRT_ERR_BANDS);
    assert_int_equal(prt_shade_incident(2, 2, 2, values, values, out), PRT_ERR_COUNT);
    assert_int_equal(prt_shade_incident_n(2, 2, 1, -1, values, values, out), PRT_ERR_COUNT);
    assert_int_equal(prt_shade_incident(2, 2, 1, NULL, values, out), PRT_ERR_NULL);
    assert_int_equal(prt_shade_incident(2, 2, 1, values, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_shade_incident(2, 2, 1, values, values, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_shade_incident_n(2, 2, 1, 0, NULL, NULL, NULL), PRT_OK);
    assert_int_equal(prt_shade_glossy(0, values, NULL, vec3(0, 0, 1), &colour), PRT_ERR_BANDS);
    assert_int_equal(prt_shade_glossy_n(2, -1, values, NULL, NULL, &colour), PRT_ERR_COUNT);
    assert_int_equal(prt_shade_glossy(2, NULL, NULL, vec3(0, 0, 1), &colour), PRT_ERR_NULL);
    assert_int_equal(prt_shade_glossy(2, values, NULL, vec3(0, 0, 1), NULL), PRT_ERR_NULL);
    assert_int_equal(prt_shade_glossy_n(2, 1, values, NULL, NULL, &colour), PRT_ERR_NULL);
    assert_memory_equal(out, marks, sizeof out);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shadows_are_the_quadrature),
        cmocka_unit_test(a_plane_reflects),
        cmocka_unit_test(furnace_is_white),
        cmocka_unit_test(light_to_lobe),
        cmocka_unit_test(batches_and_planes),
        cmocka_unit_test(phong_is_its_integral),
        cmocka_unit_test(frames_are_frames),
        cmocka_unit_test(brdf_matrices),
        cmocka_unit_test(ranges_give_the_same_bits),
        cmocka_unit_test(bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
