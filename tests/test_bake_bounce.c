/* >>bounce: interreflection against closed forms (an infinite plane, the inside of a sphere, a bowl), energy, ranges,
   errors, memory; shading from three planes of transfer. */
#include "memory_hook.h"
#include "test.h"
#include "geometry.h"
#include "tracer.h"
#include <limits.h>

enum { BANDS = 5, N = PRT_SH_COUNT(BANDS) };

/* A value that no formula makes by accident. */
static prt_real scrambled(int k) { return (prt_real)(sin(12.9898 * k + 1) * 0.7); }

/* ---- scenes, traced analytically ---- */

/* The plane z = 0, whose one triangle is hit in the same barycentric place everywhere; normal +z. */
static int plane_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    int k;
    for (k = 0; k < count; k++) {
        if (!(rays[k].origin.z * rays[k].dir.z < 0)) continue;
        memset(&hits[k], 0, sizeof hits[k]);
        hits[k].t = -rays[k].origin.z / rays[k].dir.z;
        hits[k].u = PRT__R(0.25);
        hits[k].v = PRT__R(0.125);
        hits[k].normal = vec3(0, 0, 1);
    }
    if (user) ++*(int *)user;
    return 0;
}

/* The unit sphere about the origin seen from inside, or what of it lies below z = lid. Its faces are those of the
   octahedron; a direction d has barycentric coordinates |d_i| / (|x|+|y|+|z|) there. Rays start on the sphere, so t is
   -2 o.d, not the root next to 0. Normals point inwards. */
typedef struct bowl { double lid; int calls, fail_at; } bowl;

static const uint32_t octahedron[8][3] = { { 0, 2, 4 }, { 3, 0, 4 }, { 1, 3, 4 }, { 2, 1, 4 },
                                           { 2, 0, 5 }, { 0, 3, 5 }, { 3, 1, 5 }, { 1, 2, 5 } };
static prt_vec3 octahedron_vertex(int k) {         /* +x -x +y -y +z -z */
    double s = k % 2 ? -1 : 1;
    return vec3(k / 2 == 0 ? s : 0, k / 2 == 1 ? s : 0, k / 2 == 2 ? s : 0);
}

static double corner_share(prt_vec3 p, uint32_t corner) {
    double c[3], s = fabs((double)p.x) + fabs((double)p.y) + fabs((double)p.z);
    c[0] = (double)p.x; c[1] = (double)p.y; c[2] = (double)p.z;
    return fmax(0, (corner % 2 ? -1 : 1) * c[corner / 2] / s);
}

static int bowl_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    bowl *b = (bowl *)user;
    int k, face;
    b->calls++;
    if (b->calls == b->fail_at) return 1;
    for (k = 0; k < count; k++) {
        prt_vec3 o = rays[k].origin, d = rays[k].dir, p;
        double t = -2 * ((double)o.x * (double)d.x + (double)o.y * (double)d.y + (double)o.z * (double)d.z);
        p = vec3((double)o.x + t * (double)d.x, (double)o.y + t * (double)d.y, (double)o.z + t * (double)d.z);
        if (t <= 0 || (double)p.z > b->lid) continue;
        memset(&hits[k], 0, sizeof hits[k]);
        face = p.z >= 0 ? (p.x >= 0 ? (p.y >= 0 ? 0 : 1) : p.y < 0 ? 2 : 3) : p.x >= 0 ? (p.y >= 0 ? 4 : 5)
                        : p.y < 0 ? 6 : 7;
        hits[k].t = (prt_real)t;
        hits[k].primitive = face;
        hits[k].u = (prt_real)corner_share(p, octahedron[face][1]);
        hits[k].v = (prt_real)corner_share(p, octahedron[face][2]);
        hits[k].normal = vec3(-(double)p.x, -(double)p.y, -(double)p.z);
    }
    return 0;
}

static int bowl_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    return occluded_by(bowl_closest, user, count, rays, blocked);
}

/* Everything that a bounce needs, about one scene of one object. */
typedef struct setup {
    prt_bounce_desc desc;
    prt_bounce_object object;
    prt_tracer tracer;
    bowl bowl;
    prt_point points[64];
    int point_count;
} setup;

static const uint32_t one_triangle[3] = { 0, 1, 2 };

static void begin(setup *s) {
    memset(s, 0, sizeof *s);
    s->desc.objects = &s->object;
    s->desc.object_count = 1;
    s->desc.tracer = &s->tracer;
    s->desc.bias = PRT__R(1e-9);
    s->object.albedo = rgb(1, 1, 1);
}

/* Three points of a plane, the corners of its triangle, and a fourth above it that looks towards `normal`. */
static void begin_plane(setup *s, prt_vec3 normal) {
    int k;
    begin(s);
    s->tracer.closest = plane_closest;
    s->object.triangle_count = 1;
    s->object.triangles = one_triangle;
    for (k = 0; k < 3; k++) { s->points[k].position = vec3(k == 1, k == 2, 0); s->points[k].normal = vec3(0, 0, 1); }
    s->points[3].position = vec3(0.5, 0.25, 2);
    s->points[3].normal = normal;
    s->point_count = 4;
}

/* The octahedron's vertices, and points spread over the sphere below the lid, all looking inwards. */
static void begin_bowl(setup *s, double lid, int extra) {
    int k;
    begin(s);
    s->tracer.user = &s->bowl;
    s->tracer.closest = bowl_closest;
    s->tracer.occluded = bowl_occluded;
    s->bowl.lid = lid;
    s->object.triangle_count = 8;
    s->object.triangles = octahedron[0];
    for (k = 0; k < 6 + extra; k++) {
        double z = -1 + (k - 5.5) / extra * (1 + fmin(lid, 1)), r = sqrt(fmax(0, 1 - z * z)), a = 2.399963229728653 * k;
        prt_vec3 p = k < 6 ? octahedron_vertex(k) : vec3(r * cos(a), r * sin(a), z);
        s->points[k].position = p;
        s->points[k].normal = vec3(-(double)p.x, -(double)p.y, -(double)p.z);
    }
    s->point_count = 6 + extra;
}

/* Mean and standard error over seeds of one row of a bounce, which must lie within 6 of them from want[planes][N]. */
static void assert_unbiased(setup *s, const prt_real *previous, int point, int planes, const double *want,
                            double most) {
    enum { SEEDS = 24 };
    static prt_real out[64 * 3 * N];
    double sum[3 * N] = { 0 }, square[3 * N] = { 0 }, total = 0;
    int seed, i;
    for (seed = 0; seed < SEEDS; seed++) {
        s->desc.seed = (uint64_t)seed;
        assert_int_equal(prt_bake_bounce(&s->desc, s->point_count, s->points, previous, point, 1, out), PRT_OK);
        for (i = 0; i < planes * N; i++) {
            double off = (double)out[point * planes * N + i] - want[i];
            sum[i] += off;
            square[i] += off * off;
            total += off * off;
        }
    }
    for (i = 0; i < planes * N; i++) {
        double mean = sum[i] / SEEDS, error = sqrt(fmax(0, square[i] / SEEDS - mean * mean) / (SEEDS - 1));
        assert_near(mean, 0, 6 * error + 2e-6);
    }
    assert_at_most(sqrt(total / SEEDS), most);
}

/* ---- closed forms ---- */

/* A plane of transfer T and albedo a fills (1 - N.z)/2 of the cosine-weighted hemisphere of any point above it: the
   bounce there is a (1 - N.z)/2 T, of T interpolated with weights 5/8, 1/4, 1/8. */
static void a_plane_below(void **state) {
    static const double normals[4][3] = { { 0, 0, -1 }, { 1, 0, 0 }, { 0, 0.6, 0.8 }, { 0.36, 0.48, -0.8 } };
    static const prt_rgb albedos[3] = { { 1, PRT__R(0.5), PRT__R(0.25) }, { PRT__R(0.5), 1, 1 },
                                        { 0, 1, PRT__R(0.5) } };
    prt_real previous[4 * 3 * N];
    setup s;
    int q, colour, k, c;
    (void)state;
    for (k = 0; k < 4 * 3 * N; k++) previous[k] = scrambled(k);
    for (q = 0; q < 4; q++) for (colour = 0; colour < 3; colour++) {
        double want[3 * N], part = (1 - normals[q][2]) / 2;
        int planes = colour ? 3 : 1, from = colour == 2 ? 3 : 1;
        double a[3] = { 0.75, 0.75, 0.75 };
        begin_plane(&s, vec3(normals[q][0], normals[q][1], normals[q][2]));
        s.object.albedo = colour ? rgb(0.5, 0.25, 1) : rgb(0.75, 0.75, 0.75);
        s.desc.samples = 2000;
        s.desc.previous_planes = from;
        if (colour) {
            s.object.albedos = albedos;
            a[0] = 0.5 * (0.625 + 0.125); a[1] = 0.25 * (0.3125 + 0.25 + 0.125); a[2] = 0.15625 + 0.25 + 0.0625;
        }
        for (c = 0; c < planes; c++)
            for (k = 0; k < N; k++) {
                const prt_real *t = previous + (from == 3 ? c * N : 0) + k;
                want[c * N + k] = a[c] * part * (0.625 * (double)t[0] + 0.25 * (double)t[from * N] +
                                                 0.125 * (double)t[2 * from * N]);
            }
        assert_int_equal(prt_bounce_planes(1, &s.object), planes);
        assert_unbiased(&s, previous, 3, planes, want, 0.02);
    }
}

/* Inside a sphere every point receives the mean of what all of it sends, whatever that is: form factors are
   dA/(4 pi R^2) for any two points. The mean of what is interpolated on the octahedron is that of its six vertices. */
static void inside_a_sphere(void **state) {
    prt_real previous[64 * N], out[64 * N];
    double want[N] = { 0 };
    setup s;
    int k, i;
    (void)state;
    begin_bowl(&s, 2, 10);
    for (k = 0; k < 64 * N; k++) previous[k] = scrambled(k);
    for (i = 0; i < N; i++)
        for (k = 0; k < 6; k++) want[i] += 0.75 * (double)previous[k * N + i] / 6;
    s.object.albedo = rgb(0.75, 0.75, 0.75);
    s.desc.samples = 3000;
    for (k = 0; k < s.point_count; k += 5) assert_unbiased(&s, previous, k, 1, want, 0.05);
    /* all the same: then no ray is needed to know it, and the series is geometric */
    for (k = 0; k < 64 * N; k++) previous[k] = scrambled(k % N);
    s.desc.samples = 100;
    assert_int_equal(prt_bake_bounce(&s.desc, s.point_count, s.points, previous, 0, s.point_count, out), PRT_OK);
    for (k = 0; k < s.point_count * N; k++) assert_near(out[k], 0.75 * (double)previous[k], 16 * (double)PRT__EPS);
    assert_int_equal(prt_bake_bounces(&s.desc, 8, 0, s.point_count, s.points, previous, out, NULL), PRT_OK);
    for (k = 0; k < s.point_count * N; k++)
        assert_near(out[k], (1 - pow(0.75, 9)) / (1 - 0.75) * (double)previous[k], 400 * (double)PRT__EPS);
}

/* (l,0) of max(0,z)/pi over Y(l,0)(+z) */
static double cosine_lobe(int l) {
    static const double factor[BANDS] = { 1, 2.0 / 3, 0.25, 0, -1.0 / 24 };
    return factor[l] * sqrt((2 * l + 1) / (4 * pi));
}

/* A hemispherical bowl of albedo a under the sky. Half of the cosine-weighted hemisphere over any of its points is bowl,
   and every part of the bowl the same share of it, so that bounce one is a/2 times the mean of what is interpolated
   between its vertices, which is 1/3 of the bottom and 1/6 of each of the four on the rim. Under L = 1 every point
   then has T = 1/2 + a/2 T, so T = 1/(2-a). */
static void a_bowl_under_the_sky(void **state) {
    prt_real previous[64 * N], total[64 * N];
    double a = 0.8, want[N];
    setup s;
    int k, i;
    (void)state;
    begin_bowl(&s, 0, 40);
    for (k = 0; k < 64 * N; k++) previous[k] = scrambled(k);
    s.object.albedo = rgb(a, a, a);
    s.desc.samples = 3000;
    for (i = 0; i < N; i++) {
        double rim = 0;
        for (k = 0; k < 4; k++) rim += (double)previous[k * N + i];
        want[i] = a / 2 * ((double)previous[5 * N + i] / 3 + rim / 6);
    }
    for (k = 6; k < s.point_count; k += 7) assert_unbiased(&s, previous, k, 1, want, 0.05);
    for (k = 0; k < 64 * N; k++) previous[k] = k % N ? 0 : (prt_real)(0.5 * cosine_lobe(0));
    assert_int_equal(prt_bake_bounces(&s.desc, 40, 0, s.point_count, s.points, previous, total, NULL), PRT_OK);
    for (k = 6; k < s.point_count; k++) assert_near((double)total[k * N] / cosine_lobe(0), 1 / (2 - a), 4e-3);
}

/* Equation 2 of [Chen 2005] as printed adds to M(b-1) what M(b-1), all bounces so far, sends on: M(b) = (1 + K)
   M(b-1), so that bounce k enters binomially often; the series is M(b) = M(0) + K M(b-1). Under L = 1 in the bowl:
   after b steps (1 + a/2)^b / 2 instead of something below 1/(2-a). */
static void equation_2_of_chen_as_printed(void **state) {
    enum { STEPS = 8 };
    prt_real previous[64 * N], sum[64 * N], next[64 * N];
    double a = 0.8;
    setup s;
    int k, b;
    (void)state;
    begin_bowl(&s, 0, 40);
    s.object.albedo = rgb(a, a, a);
    s.desc.samples = 2048;
    for (k = 0; k < 64 * N; k++) previous[k] = k % N ? 0 : (prt_real)(0.5 * cosine_lobe(0));
    memcpy(sum, previous, sizeof sum);
    for (b = 0; b < STEPS; b++) {
        assert_int_equal(prt_bake_bounce(&s.desc, s.point_count, s.points, sum, 0, s.point_count, next), PRT_OK);
        assert_int_equal(prt_bounce_add(BANDS, s.point_count, 1, next, 1, sum, NULL), PRT_OK);
    }
    printf("bowl of albedo .8 under L = 1, %d bounces: equation 2 as printed %.2f, right %.4f, all bounces %.4f\n",
           STEPS, (double)sum[6 * N] / cosine_lobe(0), 0.5 * (1 - pow(a / 2, STEPS + 1)) / (1 - a / 2), 1 / (2 - a));
    for (k = 6; k < s.point_count; k++)
        assert_near((double)sum[k * N] / cosine_lobe(0) / (0.5 * pow(1 + a / 2, STEPS)), 1, STEPS * 4e-3);
    assert_int_equal(prt_bake_bounces(&s.desc, STEPS, 0, s.point_count, s.points, previous, sum, NULL), PRT_OK);
    for (k = 6; k < s.point_count; k++)
        assert_near((double)sum[k * N] / cosine_lobe(0), 0.5 * (1 - pow(a / 2, STEPS + 1)) / (1 - a / 2), 4e-3);
}

/* Reciprocity: the mean of T0 over the bowl is the light that falls through its opening, (l,0) of max(0,z)/pi times
   half, the opening's share of the bowl's area. Points from 6 on are spread evenly over the bowl. */
static void the_bowl_receives_what_falls_in(void **state) {
    enum { EXTRA = 40 };
    prt_real direct[64 * N];
    double mean[N] = { 0 };
    prt_bake_desc desc;
    setup s;
    int k, i, l;
    (void)state;
    begin_bowl(&s, 0, EXTRA);
    memset(&desc, 0, sizeof desc);
    desc.samples = 4096; desc.tracer = &s.tracer; desc.bias = s.desc.bias;
    assert_int_equal(prt_bake_transfer(&desc, s.point_count, s.points, 0, s.point_count, direct), PRT_OK);
    for (k = 6; k < s.point_count; k++)
        for (i = 0; i < N; i++) mean[i] += (double)direct[k * N + i] / EXTRA;
    for (l = 0; l < BANDS; l++) assert_near(mean[PRT_SH_INDEX(l, 0)], 0.5 * cosine_lobe(l), 3e-3);
}

static int no_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    (void)user; (void)count; (void)rays; (void)hits;
    return 0;
}

static void nothing_is_hit_nothing_bounces(void **state) {
    prt_real previous[4 * N], out[4 * N], total[4 * N], strength = 5;
    setup s;
    int k, made = 7;
    (void)state;
    begin_plane(&s, vec3(0, 0, 1));
    s.tracer.closest = no_closest;                 /* a convex body sees nothing of itself */
    for (k = 0; k < 4 * N; k++) previous[k] = scrambled(k);
    memset(out, 0xff, sizeof out);
    assert_int_equal(prt_bake_bounce(&s.desc, 4, s.points, previous, 0, 4, out), PRT_OK);
    for (k = 0; k < 4 * N; k++) assert_true(out[k] == 0);
    assert_int_equal(prt_bake_bounces(&s.desc, 5, 0, 4, s.points, previous, total, &made), PRT_OK);
    assert_int_equal(made, 1);                     /* its strength is 0 */
    assert_memory_equal(total, previous, sizeof total);
    assert_int_equal(prt_bounce_add(BANDS, 4, 1, out, 1, total, &strength), PRT_OK);
    assert_true(strength == 0);
    s.tracer.closest = plane_closest;              /* nor does black reflect, nor what has no triangles */
    s.object.albedo = rgb(0, 0, 0);
    assert_int_equal(prt_bake_bounce(&s.desc, 4, s.points, previous, 0, 4, out), PRT_OK);
    for (k = 0; k < 4 * N; k++) assert_true(out[k] == 0);
    s.object.albedo = rgb(1, 1, 1);
    s.object.triangles = NULL;
    assert_int_equal(prt_bake_bounce(&s.desc, 4, s.points, previous, 0, 4, out), PRT_OK);
    for (k = 0; k < 4 * N; k++) assert_true(out[k] == 0);
}

/* Open rays of the direct pass and hits of the bounces are the same rays: a white furnace is white, to rounding. */
static void energy_is_conserved(void **state) {
    prt_real direct[64 * N], out[64 * N], furnace[64 * N];
    setup s;
    prt_bake_desc desc;
    int k;
    (void)state;
    begin_bowl(&s, 0.3, 30);
    memset(&desc, 0, sizeof desc);
    desc.samples = s.desc.samples = 1500; desc.tracer = &s.tracer; desc.bias = s.desc.bias; desc.seed = s.desc.seed = 9;
    assert_int_equal(prt_bake_transfer(&desc, s.point_count, s.points, 0, s.point_count, direct), PRT_OK);
    for (k = 0; k < s.point_count * N; k++) furnace[k] = k % N ? 0 : (prt_real)(0.5 / sqrt(pi));
    assert_int_equal(prt_bake_bounce(&s.desc, s.point_count, s.points, furnace, 0, s.point_count, out), PRT_OK);
    for (k = 0; k < s.point_count; k++)            /* running sums as in test_bake.c */
        assert_near(2 * sqrt(pi) * ((double)direct[k * N] + (double)out[k * N]), 1, 128 * (double)PRT__EPS);
}

/* ---- the back of faces ---- */

static void backs_of_faces(void **state) {
    prt_real previous[8 * N], out[8 * N];
    setup s;
    int k;
    (void)state;
    begin_plane(&s, vec3(0, 0, 1));
    s.points[3].position = vec3(0, 0, -2);         /* below the plane, and looking up at its back */
    s.points[3].normal = vec3(0, 0, 1);
    for (k = 4; k < 7; k++) { s.points[k] = s.points[k - 4]; s.points[k].normal = vec3(0, 0, -1); }
    s.point_count = 7;
    for (k = 0; k < 8 * N; k++) previous[k] = scrambled(k);
    assert_int_equal(prt_bake_bounce(&s.desc, 7, s.points, previous, 3, 1, out), PRT_OK);
    for (k = 0; k < N; k++) assert_true(out[3 * N + k] == 0);
    s.object.back_offset = 4;
    assert_int_equal(prt_bake_bounce(&s.desc, 7, s.points, previous, 3, 1, out), PRT_OK);
    for (k = 0; k < N; k++)
        assert_near(out[3 * N + k], 0.625 * (double)previous[4 * N + k] + 0.25 * (double)previous[5 * N + k] +
                    0.125 * (double)previous[6 * N + k], 16 * (double)PRT__EPS);
    s.object.first_point = 4;                      /* the same the other way round: seen from above, then from below */
    s.object.back_offset = -4;
    assert_int_equal(prt_bake_bounce(&s.desc, 7, s.points, previous, 3, 1, out), PRT_OK);
    for (k = 0; k < N; k++)
        assert_near(out[3 * N + k], 0.625 * (double)previous[k] + 0.25 * (double)previous[N + k] +
                    0.125 * (double)previous[2 * N + k], 16 * (double)PRT__EPS);
}

/* ---- the same bits, however it is asked ---- */

static void ranges_give_the_same_bits(void **state) {
    static const int samples[] = { 1, 63, 100, 1024, 1500 };
    prt_real previous[64 * N], whole[64 * 3 * N], parts[64 * 3 * N];
    setup s;
    int q, first, step;
    (void)state;
    begin_bowl(&s, 0.2, 31);
    s.object.albedo = rgb(0.9, 0.5, 0.1);
    for (q = 0; q < 64 * N; q++) previous[q] = scrambled(q);
    for (q = 0; q < 5; q++) for (step = 1; step < 37; step += 12) {
        s.desc.samples = samples[q];
        assert_int_equal(prt_bake_bounce(&s.desc, 37, s.points, previous, 0, 37, whole), PRT_OK);
        memset(parts, 0xff, sizeof parts);
        for (first = 0; first < 37; first += step)
            assert_int_equal(prt_bake_bounce(&s.desc, 37, s.points, previous, first,
                                             37 - first < step ? 37 - first : step, parts), PRT_OK);
        assert_memory_equal(whole, parts, 37 * 3 * N * sizeof *whole);
    }
}

static int count_progress(void *user, int done, int total) {
    int *log = (int *)user;                        /* calls, stop after, last total */
    assert_int_equal(done, ++log[0]);
    log[2] = total;
    return done == log[1];
}

static void progress_and_cancelling(void **state) {
    prt_real previous[64 * N], whole[64 * N], out[64 * N], total[64 * N], marks[N];
    setup s;
    int log[3] = { 0, 0, 0 }, made = -1, k;
    (void)state;
    begin_bowl(&s, 0, 10);
    s.desc.samples = 64;
    for (k = 0; k < 64 * N; k++) previous[k] = scrambled(k);
    assert_int_equal(prt_bake_bounce(&s.desc, 16, s.points, previous, 0, 16, whole), PRT_OK);
    s.desc.progress = count_progress; s.desc.progress_user = log;
    memset(out, 0xff, sizeof out);
    memset(marks, 0xff, sizeof marks);
    log[1] = 5;
    assert_int_equal(prt_bake_bounce(&s.desc, 16, s.points, previous, 3, 10, out), PRT_ERR_CANCELLED);
    assert_int_equal(log[0], 5);
    assert_int_equal(log[2], 10);
    assert_memory_equal(out + 3 * N, whole + 3 * N, 5 * N * sizeof *out);
    assert_memory_equal(out + 2 * N, marks, sizeof marks);
    assert_memory_equal(out + 8 * N, marks, sizeof marks);
    log[0] = 0; log[1] = 16 + 7;                   /* in the second bounce: the first is kept */
    assert_int_equal(prt_bake_bounces(&s.desc, 4, 0, 16, s.points, previous, total, &made), PRT_ERR_CANCELLED);
    assert_int_equal(made, 1);
    assert_int_equal(log[2], 64);
    for (k = 0; k < 16 * N; k++) assert_true(total[k] == previous[k] + whole[k]);
}

/* The helper is bounces and sums, colours included, and stops where it was told. */
static void bounces_are_bounces_added(void **state) {
    prt_real direct[64 * N], b1[64 * 3 * N], b2[64 * 3 * N], sum[64 * 3 * N], total[64 * 3 * N], strength, first;
    setup s;
    int made, k, c;
    (void)state;
    begin_bowl(&s, 0, 10);
    s.object.albedo = rgb(0.9, 0.5, 0.1);
    s.desc.samples = 64;
    for (k = 0; k < 64 * N; k++) direct[k] = (prt_real)fabs((double)scrambled(k));
    assert_int_equal(prt_bake_bounce(&s.desc, 16, s.points, direct, 0, 16, b1), PRT_OK);
    s.desc.previous_planes = 3;
    assert_int_equal(prt_bake_bounce(&s.desc, 16, s.points, b1, 0, 16, b2), PRT_OK);
    for (k = 0; k < 16; k++)
        for (c = 0; c < 3; c++) memcpy(sum + (k * 3 + c) * N, direct + k * N, N * sizeof *sum);
    assert_int_equal(prt_bounce_add(BANDS, 16, 3, b1, 3, sum, &first), PRT_OK);
    assert_int_equal(prt_bounce_add(BANDS, 16, 3, b2, 3, sum, &strength), PRT_OK);
    assert_true(strength > 0 && strength < first);
    s.desc.previous_planes = 0;
    assert_int_equal(prt_bake_bounces(&s.desc, 9, strength, 16, s.points, direct, total, &made), PRT_OK);
    assert_int_equal(made, 2);
    assert_memory_equal(total, sum, 16 * 3 * N * sizeof *sum);
    assert_int_equal(prt_bake_bounces(&s.desc, 0, 0, 16, s.points, direct, total, &made), PRT_OK);
    assert_int_equal(made, 0);
    for (k = 0; k < 16 * 3 * N; k++) assert_true(total[k] == direct[k / (3 * N) * N + k % N]);
    for (k = 0; k < 16 * 3 * N; k++) total[k] = 1;
    assert_int_equal(prt_bounce_add(BANDS, 16, 1, direct, 3, total, NULL), PRT_OK);
    for (k = 0; k < 16 * 3 * N; k++) assert_true(total[k] == 1 + direct[k / (3 * N) * N + k % N]);
}

/* ---- errors ---- */

static int bad_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    const prt_hit *bad = (const prt_hit *)user;
    plane_closest(NULL, count, rays, hits);
    if (count > 7) hits[7] = *bad;
    return 0;
}

static void hits_that_cannot_be(void **state) {
    prt_real previous[4 * N] = { 0 }, out[5 * N];
    setup s;
    prt_hit good, bad[16];
    int k, count = 0;
    (void)state;
    begin_plane(&s, vec3(0, 0, -1));
    memset(&good, 0, sizeof good);
    good.t = 1; good.normal = vec3(0, 0, 1);
    s.tracer.closest = bad_closest;
    for (k = 0; k < 16; k++) bad[k] = good;
    bad[count++].object = 1;
    bad[count++].object = INT_MAX;
    bad[count++].primitive = -1;
    bad[count++].primitive = 1;
    bad[count++].t = -1;
    bad[count++].u = PRT__R(-0.01);
    bad[count++].v = PRT__R(1.01);
    bad[count].u = PRT__R(0.6); bad[count++].v = PRT__R(0.5);
    bad[count++].normal = vec3(0, 0, 2);
    bad[count++].normal = vec3(0, 0, 0);
    if (!FAST_MATH) {
        bad[count++].u = (prt_real)NAN;
        bad[count++].v = (prt_real)NAN;
        bad[count++].t = (prt_real)NAN;
        bad[count++].t = (prt_real)INFINITY;
        bad[count++].normal = vec3(NAN, 0, 1);
    }
    s.tracer.user = &good;
    assert_int_equal(prt_bake_bounce(&s.desc, 4, s.points, previous, 3, 1, out), PRT_OK);
    for (k = 0; k < count; k++) {
        s.tracer.user = &bad[k];
        assert_int_equal(prt_bake_bounce(&s.desc, 4, s.points, previous, 3, 1, out), PRT_ERR_TRACE);
    }
    assert_int_equal(memory_hook.calls, memory_hook.frees);
}

static void a_failing_tracer(void **state) {
    prt_real previous[64 * N], whole[64 * N], out[64 * N], marks[64 * N];
    setup s;
    int k;
    (void)state;
    begin_bowl(&s, 0, 10);
    s.desc.samples = 300;
    for (k = 0; k < 64 * N; k++) previous[k] = scrambled(k);
    assert_int_equal(prt_bake_bounce(&s.desc, 16, s.points, previous, 0, 16, whole), PRT_OK);
    memset(out, 0xff, sizeof out);
    memset(marks, 0xff, sizeof marks);
    s.bowl.calls = 0; s.bowl.fail_at = 7;
    assert_int_equal(prt_bake_bounce(&s.desc, 16, s.points, previous, 0, 16, out), PRT_ERR_TRACE);
    assert_memory_equal(out, whole, 6 * N * sizeof *out);
    assert_memory_equal(out + 6 * N, marks, (64 - 6) * N * sizeof *out);
    s.bowl.calls = 0;
    assert_int_equal(prt_bake_bounces(&s.desc, 3, 0, 16, s.points, previous, out, NULL), PRT_ERR_TRACE);
    assert_memory_equal(out, previous, 16 * N * sizeof *out);
    assert_int_equal(memory_hook.calls, memory_hook.frees);
}

#define REFUSES(change, error) do { \
        setup s; \
        int made = -3; \
        begin_plane(&s, vec3(0, 0, -1)); \
        (void)made; \
        change; \
        assert_int_equal(prt_bake_bounce(&s.desc, points, p ? s.points : NULL, previous, first, count, to), error); \
        assert_memory_equal(out, marks, sizeof out); \
    } while (0)

static void bad_arguments(void **state) {
    static const uint32_t wrong[3] = { 0, 4, 2 };
    static const prt_rgb bright[3] = { { 1, 1, 1 }, { 1, PRT__R(1.5), 1 }, { 1, 1, 1 } };
    prt_real values[4 * 3 * N] = { 0 }, out[4 * 3 * N], marks[4 * 3 * N];
    const prt_real *previous = values;
    prt_real *to = out;
    int points = 4, first = 0, count = 4, p = 1;
    prt_bounce_desc none;
    (void)state;
    memset(out, 0xff, sizeof out);
    memset(marks, 0xff, sizeof marks);
    memset(&none, 0, sizeof none);
    assert_int_equal(prt_bake_bounce(NULL, 0, NULL, NULL, 0, 0, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_bounce(&none, 0, NULL, NULL, 0, 0, NULL), PRT_ERR_NULL);          /* no tracer */
    REFUSES(s.desc.bands = -1, PRT_ERR_BANDS);
    REFUSES(s.desc.bands = PRT_MAX_BANDS + 1, PRT_ERR_BANDS);
    REFUSES(s.desc.samples = -1, PRT_ERR_COUNT);
    REFUSES(s.desc.planes = 2, PRT_ERR_COUNT);
    REFUSES(s.desc.previous_planes = 2, PRT_ERR_COUNT);
    REFUSES(s.desc.planes = 1; s.desc.previous_planes = 3, PRT_ERR_COUNT);
    REFUSES(s.desc.object_count = -1, PRT_ERR_COUNT);
    REFUSES(s.object.triangle_count = -1, PRT_ERR_COUNT);
    REFUSES(s.object.triangles = wrong, PRT_ERR_COUNT);
    REFUSES(s.object.first_point = 2, PRT_ERR_COUNT);
    REFUSES(s.object.first_point = -1, PRT_ERR_COUNT);
    REFUSES(s.object.first_point = INT_MIN, PRT_ERR_COUNT);
    REFUSES(s.object.back_offset = 2, PRT_ERR_COUNT);
    REFUSES(s.object.back_offset = INT_MAX, PRT_ERR_COUNT);
    REFUSES(first = 1, PRT_ERR_COUNT);
    first = 0;
    REFUSES(count = -1, PRT_ERR_COUNT);
    count = 4;
    REFUSES(points = 3, PRT_ERR_COUNT);
    points = 4;
    REFUSES(p = 0, PRT_ERR_NULL);
    p = 1;
    REFUSES(previous = NULL, PRT_ERR_NULL);
    previous = values;
    REFUSES(to = NULL, PRT_ERR_NULL);
    to = out;
    REFUSES(s.desc.objects = NULL, PRT_ERR_NULL);
    REFUSES(s.desc.tracer = NULL, PRT_ERR_NULL);
    REFUSES(s.tracer.closest = NULL, PRT_ERR_NULL);
    REFUSES(s.object.albedo.g = PRT__R(1.5), PRT_ERR_VALUE);
    REFUSES(s.object.albedo.b = PRT__R(-0.5), PRT_ERR_VALUE);
    REFUSES(s.object.albedos = bright, PRT_ERR_VALUE);
    REFUSES(s.desc.planes = 1; s.object.albedo = rgb(1, 1, 0.5), PRT_ERR_VALUE);
    REFUSES(s.desc.bias = -1, PRT_ERR_VALUE);
    REFUSES(s.desc.scene_radius = -1, PRT_ERR_VALUE);
    REFUSES(s.points[2].normal = vec3(0, 0, 2), PRT_ERR_VALUE);
    if (!FAST_MATH) {
        REFUSES(s.object.albedo.r = (prt_real)NAN, PRT_ERR_VALUE);
        REFUSES(s.desc.bias = (prt_real)NAN, PRT_ERR_VALUE);
        REFUSES(s.points[2].position.x = (prt_real)INFINITY, PRT_ERR_VALUE);
    }
    memory_hook.fail = 1;
    REFUSES((void)0, PRT_ERR_MEMORY);
    memory_hook.fail = 0;
    REFUSES(count = 0; previous = NULL; to = NULL; p = 0, PRT_OK);
}

static void helpers_refuse(void **state) {
    prt_real values[4 * N] = { 0 }, out[4 * N], strength = 3;
    prt_bounce_object object;
    setup s;
    int made = -3;
    (void)state;
    begin_plane(&s, vec3(0, 0, -1));
    assert_int_equal(prt_bake_bounces(&s.desc, -1, 0, 4, s.points, values, out, &made), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_bounces(&s.desc, 1, PRT__R(-0.1), 4, s.points, values, out, &made), PRT_ERR_VALUE);
    assert_int_equal(prt_bake_bounces(&s.desc, INT_MAX, 0, 4, s.points, values, out, &made), PRT_ERR_CAPACITY);
    assert_int_equal(prt_bake_bounces(&s.desc, 1, 0, 4, s.points, values, NULL, &made), PRT_ERR_NULL);
    assert_int_equal(prt_bake_bounces(NULL, 1, 0, 4, s.points, values, out, &made), PRT_ERR_NULL);
    memory_hook.fail = 1;
    assert_int_equal(prt_bake_bounces(&s.desc, 1, 0, 4, s.points, values, out, NULL), PRT_ERR_MEMORY);
    memory_hook.fail = 0;
    assert_int_equal(made, -3);
    s.object.triangles = NULL;                     /* its corners would be none of the points */
    assert_int_equal(prt_bake_bounces(&s.desc, 1, 0, 0, NULL, NULL, NULL, &made), PRT_OK);
    assert_int_equal(made, 0);
    assert_int_equal(prt_bounce_add(0, 4, 1, values, 1, out, &strength), PRT_ERR_BANDS);
    assert_int_equal(prt_bounce_add(5, -1, 1, values, 1, out, &strength), PRT_ERR_COUNT);
    assert_int_equal(prt_bounce_add(5, 4, 3, values, 1, out, &strength), PRT_ERR_COUNT);
    assert_int_equal(prt_bounce_add(5, 4, 2, values, 3, out, &strength), PRT_ERR_COUNT);
    assert_int_equal(prt_bounce_add(5, 4, 1, NULL, 1, out, &strength), PRT_ERR_NULL);
    assert_int_equal(prt_bounce_add(5, 4, 1, values, 1, NULL, &strength), PRT_ERR_NULL);
    assert_true(strength == 3);
    assert_int_equal(prt_bounce_planes(0, NULL), 1);
    assert_int_equal(prt_bounce_planes(-1, &s.object), 1);
    memset(&object, 0, sizeof object);
    object.albedo = rgb(1, 0, 0);
    assert_int_equal(prt_bounce_planes(1, &object), 1);            /* without triangles nothing is reflected */
    assert_true(prt_bounce_size(5, 3, 10) == 750 * sizeof(prt_real));
    assert_true(prt_bounce_size(5, 2, 10) == 0 && prt_bounce_size(0, 1, 10) == 0 && prt_bounce_size(5, 1, -1) == 0);
    assert_true(prt_bake_bounce_scratch_size(NULL) == 0);
    assert_int_equal(prt_bake_bounce(&s.desc, 4, s.points, values, 0, 4, out), PRT_OK);
    assert_true(prt_bake_bounce_scratch_size(&s.desc) == memory_hook.size);
}

/* ---- shading ---- */

static void three_planes_are_three_dot_products(void **state) {
    enum { POINTS = 5 };
    prt_real light[3 * 64], transfer[POINTS * 3 * 64], grey[64], white[3 * 64];
    prt_rgb out[POINTS], one, same;
    int bands, k, c;
    (void)state;
    for (k = 0; k < POINTS * 3 * 64; k++) transfer[k] = scrambled(k);
    for (k = 0; k < 3 * 64; k++) light[k] = scrambled(7 * k);
    for (bands = 1; bands <= 8; bands++) {
        int n = bands * bands;
        assert_int_equal(prt_shade_diffuse_rgb_n(bands, POINTS, transfer, light, out), PRT_OK);
        for (k = 0; k < POINTS; k++) {
            double want[3] = { 0, 0, 0 };
            int i;
            for (c = 0; c < 3; c++)
                for (i = 0; i < n; i++)
                    want[c] += (double)transfer[(3 * k + c) * n + i] * (double)light[c * n + i];
            assert_near(out[k].r, want[0], (n + 4) * (double)PRT__EPS);
            assert_near(out[k].g, want[1], (n + 4) * (double)PRT__EPS);
            assert_near(out[k].b, want[2], (n + 4) * (double)PRT__EPS);
            assert_int_equal(prt_shade_diffuse_rgb(bands, transfer + 3 * k * n, light, &one), PRT_OK);
            if (!FAST_MATH) assert_memory_equal(&one, &out[k], sizeof one);
        }
        memcpy(grey, transfer, (size_t)n * sizeof *grey);
        for (c = 0; c < 3; c++) memcpy(white + c * n, grey, (size_t)n * sizeof *grey);
        assert_int_equal(prt_shade_diffuse(bands, grey, light, &one), PRT_OK);
        assert_int_equal(prt_shade_diffuse_rgb(bands, white, light, &same), PRT_OK);
        if (!FAST_MATH) assert_memory_equal(&one, &same, sizeof one);
    }
    assert_int_equal(prt_shade_diffuse_rgb(0, transfer, light, &one), PRT_ERR_BANDS);
    assert_int_equal(prt_shade_diffuse_rgb_n(2, -1, transfer, light, &one), PRT_ERR_COUNT);
    assert_int_equal(prt_shade_diffuse_rgb_n(2, 0, NULL, NULL, NULL), PRT_OK);
    assert_int_equal(prt_shade_diffuse_rgb(2, NULL, light, &one), PRT_ERR_NULL);
    assert_int_equal(prt_shade_diffuse_rgb(2, transfer, NULL, &one), PRT_ERR_NULL);
    assert_int_equal(prt_shade_diffuse_rgb(2, transfer, light, NULL), PRT_ERR_NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_below),
        cmocka_unit_test(inside_a_sphere),
        cmocka_unit_test(a_bowl_under_the_sky),
        cmocka_unit_test(equation_2_of_chen_as_printed),
        cmocka_unit_test(the_bowl_receives_what_falls_in),
        cmocka_unit_test(nothing_is_hit_nothing_bounces),
        cmocka_unit_test(energy_is_conserved),
        cmocka_unit_test(backs_of_faces),
        cmocka_unit_test(ranges_give_the_same_bits),
        cmocka_unit_test(progress_and_cancelling),
        cmocka_unit_test(bounces_are_bounces_added),
        cmocka_unit_test(hits_that_cannot_be),
        cmocka_unit_test(a_failing_tracer),
        cmocka_unit_test(bad_arguments),
        cmocka_unit_test(helpers_refuse),
        cmocka_unit_test(three_planes_are_three_dot_products),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
