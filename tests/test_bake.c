/* >>direct: transfer against closed forms and quadrature, independence of range and thread, errors, memory. */
#include "memory_hook.h"
#include "test.h"
#include "geometry.h"
#include <float.h>
#include <limits.h>
#include <pthread.h>

enum { BANDS = 5, N = PRT_SH_COUNT(BANDS) };

/* ---- scenes ---- */

static prt_point point(prt_vec3 position, prt_vec3 normal) {
    prt_point p;
    p.position = position; p.normal = normal;
    return p;
}

/* One ball; fails at call number fail_at. */
typedef struct ball { prt_vec3 centre; double radius; int calls, fail_at; long rays; } ball;

static int ball_blocks(const ball *b, prt_vec3 o, prt_vec3 d) {
    double x = (double)b->centre.x - (double)o.x, y = (double)b->centre.y - (double)o.y;
    double z = (double)b->centre.z - (double)o.z;
    double along = x * (double)d.x + y * (double)d.y + z * (double)d.z;
    return along > 0 && x * x + y * y + z * z - along * along / dot(d, d) < b->radius * b->radius;
}

static int ball_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    ball *b = (ball *)user;
    int k;
    for (k = 0; k < count; k++) blocked[k] = (unsigned char)(ball_blocks(b, rays[k].origin, rays[k].dir) ? 255 : 0);
    b->rays += count;
    b->calls++;
    return b->calls == b->fail_at ? -1 : 0;
}

/* The same with nothing written to the ball: for threads. */
static int shared_ball_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    const ball *b = (const ball *)user;
    int k;
    for (k = 0; k < count; k++) blocked[k] = (unsigned char)ball_blocks(b, rays[k].origin, rays[k].dir);
    return 0;
}

static int all_blocked(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    (void)user; (void)rays;
    memset(blocked, 1, (size_t)count);
    return 0;
}

/* Writes nothing: the answers start at 0. */
static int none_blocked(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    (void)user; (void)count; (void)rays; (void)blocked;
    return 0;
}

static void begin(prt_bake_desc *desc, prt_tracer *tracer, ball *b) {
    memset(desc, 0, sizeof *desc);
    memset(tracer, 0, sizeof *tracer);
    memset(b, 0, sizeof *b);
    b->centre = vec3(0.5, -0.25, 2); b->radius = 1;
    tracer->user = b; tracer->occluded = ball_occluded;
    desc->tracer = tracer;
}

/* Points scattered below and beside the ball, normals all over the sphere. */
static void scatter(int count, prt_point *points) {
    int k;
    for (k = 0; k < count; k++) {
        double z = 1 - 2 * (k + 0.5) / count, r = sqrt(1 - z * z), angle = 2.399963229728653 * k;
        points[k] = point(vec3(3 * cos(angle * 1.7), 3 * sin(angle * 2.3), 0.5 * z),
                          vec3(r * cos(angle), r * sin(angle), z));
    }
}

/* Real spherical harmonics from the textbook: associated Legendre polynomials without the phase, factorials, angles. */
static double textbook_sh(int l, int m, double x, double y, double z) {
    int a = m < 0 ? -m : m, k;
    double s = sqrt(fmax(0, 1 - z * z)), pmm = 1, p0, p1, norm = (2 * l + 1) / (4 * pi), phi = atan2(y, x);
    for (k = 1; k <= a; k++) pmm *= (2 * k - 1) * s;
    for (k = l - a + 1; k <= l + a; k++) norm /= k;
    p0 = 0; p1 = pmm;
    for (k = a + 1; k <= l; k++) { double p = ((2 * k - 1) * z * p1 - (k + a - 1) * p0) / (k - a); p0 = p1; p1 = p; }
    return sqrt(norm) * p1 * (m == 0 ? 1 : sqrt(2) * (m > 0 ? cos(a * phi) : sin(a * phi)));
}

static double cosine_lobe(int l) {     /* coefficient (l,0) of max(0,z)/pi is this times Y(l,0)(+z) */
    static const double factor[BANDS] = { 1, 2.0 / 3, 0.25, 0, -1.0 / 24 };
    return factor[l];
}

/* ---- against closed forms ---- */

/* A cap of half-angle alpha about `axis`, all of it above the horizon of `normal`, takes away (1/pi) int (N.w) Y(w) dw:
   midpoint rule in the cap's own angles, fine enough for 1e-6. */
static void cap_transfer(prt_vec3 axis, double alpha, prt_vec3 normal, double *out) {
    enum { RINGS = 400, SPOKES = 400 };
    double t[3], b[3], n[3], length = sqrt((double)axis.x * (double)axis.x + (double)axis.y * (double)axis.y);
    int i, j, l, m;
    n[0] = (double)axis.x; n[1] = (double)axis.y; n[2] = (double)axis.z;
    t[0] = length > 0 ? -n[1] / length : 1; t[1] = length > 0 ? n[0] / length : 0; t[2] = 0;
    b[0] = n[1] * t[2] - n[2] * t[1]; b[1] = n[2] * t[0] - n[0] * t[2]; b[2] = n[0] * t[1] - n[1] * t[0];
    for (l = 0; l < N; l++) out[l] = 0;
    for (i = 0; i < RINGS; i++) {
        double z = 1 - (i + 0.5) / RINGS * (1 - cos(alpha)), r = sqrt(1 - z * z);
        for (j = 0; j < SPOKES; j++) {
            double c = r * cos(2 * pi * j / SPOKES), s = r * sin(2 * pi * j / SPOKES);
            double x = c * t[0] + s * b[0] + z * n[0], y = c * t[1] + s * b[1] + z * n[1];
            double up = c * t[2] + s * b[2] + z * n[2];
            double cosine = x * (double)normal.x + y * (double)normal.y + up * (double)normal.z;
            double weight = fmax(0, cosine) * 2 * (1 - cos(alpha)) / (RINGS * SPOKES);
            for (l = 0; l < BANDS; l++)
                for (m = -l; m <= l; m++) out[PRT_SH_INDEX(l, m)] += weight * textbook_sh(l, m, x, y, up);
        }
    }
}

static void unshadowed(prt_vec3 normal, double *out) {
    int l, m;
    for (l = 0; l < BANDS; l++)
        for (m = -l; m <= l; m++)
            out[PRT_SH_INDEX(l, m)] = cosine_lobe(l) * textbook_sh(l, m, (double)normal.x, (double)normal.y,
                                                                   (double)normal.z);
}

/* Mean and standard error over `seeds` bakes of one point; the mean must lie within 6 standard errors of want. */
static void assert_unbiased(prt_bake_desc *desc, prt_point p, const double *want, double most_error) {
    enum { SEEDS = 32 };
    double sum[N] = { 0 }, square[N] = { 0 }, total = 0;
    prt_real transfer[N];
    int s, i;
    for (s = 0; s < SEEDS; s++) {
        desc->seed = (uint64_t)s;
        assert_int_equal(prt_bake_transfer(desc, 1, &p, 0, 1, transfer), PRT_OK);
        for (i = 0; i < N; i++) {
            double off = (double)transfer[i] - want[i];
            sum[i] += off;
            square[i] += off * off;
            total += off * off;
        }
    }
    for (i = 0; i < N; i++) {
        double mean = sum[i] / SEEDS, error = sqrt(fmax(0, square[i] / SEEDS - mean * mean) / (SEEDS - 1));
        assert_near(mean, 0, 6 * error + 2e-6);
    }
    assert_at_most(sqrt(total / SEEDS), most_error);
}

static void ball_is_its_closed_form(void **state) {
    static const double place[4][3] = { { 0, 0, 2 }, { 0.8, 0.3, 1.7 }, { -2, 2, 2.5 }, { 1.5, 0, 2 } };
    prt_point p = point(vec3(0, 0, 0), vec3(0, 0, 1));
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int k, i;
    (void)state;
    begin(&desc, &tracer, &b);
    desc.bias = PRT__R(1e-12);
    for (k = 0; k < 4; k++) {
        double distance = sqrt(place[k][0] * place[k][0] + place[k][1] * place[k][1] + place[k][2] * place[k][2]);
        double open[N], lost[N];
        b.centre = vec3(place[k][0], place[k][1], place[k][2]);
        unshadowed(p.normal, open);
        cap_transfer(vec3(place[k][0] / distance, place[k][1] / distance, place[k][2] / distance), asin(1 / distance),
                     p.normal, lost);
        for (i = 0; i < N; i++) open[i] -= lost[i];
        desc.samples = 1000;
        assert_unbiased(&desc, p, open, 6e-3);
        desc.samples = 7;
        assert_unbiased(&desc, p, open, 0.5);
        desc.samples = 1;
        assert_unbiased(&desc, p, open, 2);
    }
}

static void unshadowed_is_the_cosine_lobe(void **state) {
    enum { POINTS = 40 };
    prt_point points[POINTS];
    prt_bake_desc desc;
    int k, i;
    double want[N];
    (void)state;
    memset(&desc, 0, sizeof desc);
    scatter(POINTS, points);
    for (k = 0; k < POINTS; k++) {
        prt_real transfer[N];
        desc.samples = 600;
        unshadowed(points[k].normal, want);
        assert_unbiased(&desc, points[k], want, 2e-3);
        desc.samples = 100000;
        assert_int_equal(prt_bake_transfer(&desc, 1, &points[k], 0, 1, transfer), PRT_OK);
        for (i = 0; i < N; i++) assert_near(transfer[i], want[i], 2e-5);
    }
}

static void white_furnace_is_white(void **state) {
    static const int samples[] = { 1, 2, 63, 64, 65, 600, 1024, 5000 };
    prt_bake_desc desc;
    prt_point p = point(vec3(1, 2, 3), vec3(0.6, 0, -0.8));
    prt_real transfer[N], light[3 * N] = { 0 };
    prt_rgb out;
    int k;
    (void)state;
    memset(&desc, 0, sizeof desc);
    light[0] = light[N] = light[2 * N] = (prt_real)(2 * sqrt(pi));
    for (k = 0; k < 8; k++) {
        desc.samples = samples[k];
        assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_OK);
        assert_int_equal(prt_shade_diffuse(BANDS, transfer, light, &out), PRT_OK);
        /* running sums of up to 1024/2 equal terms: half an ulp each, of a sum that is half the last on average */
        assert_near(out.r, 1, 512 / 4 * PRT__EPS);
        assert_near(out.g, 1, 512 / 4 * PRT__EPS);
        assert_near(out.b, 1, 512 / 4 * PRT__EPS);
    }
}

/* The estimator as the interface states it, from the public sample set and the textbook's harmonics. */
static void is_the_stated_sum(void **state) {
    static const int all_bands[] = { 1, 2, 5, 10, 11, 17, 23 }, all_samples[] = { 1, 63, 129, 1024, 2500 };
    prt_point points[2];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int q, s;
    (void)state;
    begin(&desc, &tracer, &b);
    points[0] = point(vec3(0, 0, 0), vec3(0, 0, 1));
    points[1] = point(vec3(0.3, 0.1, 0.2), vec3(0.48 * 1.0009, 0.6 * 1.0009, 0.64 * 1.0009));
    for (q = 0; q < 7; q++) for (s = 0; s < 5; s++) {
        int bands = all_bands[q], n = bands * bands, samples = all_samples[s], k, l, m;
        prt_real *transfer = (prt_real *)malloc(2 * (size_t)n * sizeof *transfer);
        prt_vec3 *dirs = (prt_vec3 *)malloc((size_t)samples * sizeof *dirs);
        double *want = (double *)calloc((size_t)n, sizeof *want);
        prt_vec3 origin = points[1].position;
        desc.bands = bands; desc.samples = samples; desc.seed = 77;
        assert_int_equal(prt_bake_transfer(&desc, 2, points, 0, 2, transfer), PRT_OK);
        assert_int_equal(prt_sample_directions(samples, 77, 1, points[1].normal, 0, samples, dirs), PRT_OK);
        origin.x += PRT__R(1e-4) * PRT__R(0.48); origin.y += PRT__R(1e-4) * PRT__R(0.6);
        origin.z += PRT__R(1e-4) * PRT__R(0.64);
        for (k = 0; k < samples; k++) {
            if (ball_blocks(&b, origin, dirs[k])) continue;
            for (l = 0; l < bands; l++)
                for (m = -l; m <= l; m++)
                    want[PRT_SH_INDEX(l, m)] += textbook_sh(l, m, (double)dirs[k].x, (double)dirs[k].y,
                                                            (double)dirs[k].z) / samples;
        }
        for (k = 0; k < n; k++) assert_near(transfer[n + k], want[k], 60.0 * bands * (double)PRT__EPS + 1e-13);
        free(transfer); free(dirs); free(want);
    }
}

static void blocked_is_zero_and_open_is_unshadowed(void **state) {
    prt_point points[20];
    prt_real closed[20 * N], open[20 * N], plain[20 * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int k;
    (void)state;
    begin(&desc, &tracer, &b);
    scatter(20, points);
    tracer.occluded = all_blocked;
    assert_int_equal(prt_bake_transfer(&desc, 20, points, 0, 20, closed), PRT_OK);
    for (k = 0; k < 20 * N; k++) assert_true(closed[k] == 0);
    tracer.occluded = none_blocked;
    assert_int_equal(prt_bake_transfer(&desc, 20, points, 0, 20, open), PRT_OK);
    desc.tracer = NULL;
    assert_int_equal(prt_bake_transfer(&desc, 20, points, 0, 20, plain), PRT_OK);
    assert_memory_equal(open, plain, sizeof open);
}

static void a_million_rays(void **state) {
    prt_point p = point(vec3(0, 0, 0), vec3(0, 0, 1));
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    prt_real transfer[N];
    double want[N], lost[N];
    int i;
    (void)state;
    begin(&desc, &tracer, &b);
    b.centre = vec3(0, 0, 2);
    desc.samples = 1000000;
    desc.bias = PRT__R(1e-12);
    assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_OK);
    assert_int_equal(b.rays, 1000000);
    unshadowed(p.normal, want);
    cap_transfer(vec3(0, 0, 1), pi / 6, p.normal, lost);
    for (i = 0; i < N; i++) assert_near(transfer[i], want[i] - lost[i], 1e-5);
}

/* ---- the same bits, however it is asked ---- */

static void ranges_give_the_same_bits(void **state) {
    static const int samples[] = { 1, 5, 64, 100, 600, 1024, 1500 }, step[] = { 1, 7, 16 };
    enum { POINTS = 37 };
    prt_point points[POINTS];
    prt_real whole[POINTS * N], parts[POINTS * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int s, q, first;
    (void)state;
    begin(&desc, &tracer, &b);
    scatter(POINTS, points);
    desc.seed = 5;
    for (s = 0; s < 7; s++) {
        desc.samples = samples[s];
        assert_int_equal(prt_bake_transfer(&desc, POINTS, points, 0, POINTS, whole), PRT_OK);
        for (q = 0; q < 3; q++) {
            memset(parts, 0xff, sizeof parts);
            for (first = 0; first < POINTS; first += step[q]) {
                int count = POINTS - first < step[q] ? POINTS - first : step[q];
                assert_int_equal(prt_bake_transfer(&desc, POINTS, points, first, count, parts), PRT_OK);
            }
            assert_memory_equal(whole, parts, sizeof whole);
        }
    }
}

typedef struct part { const prt_bake_desc *desc; int point_count, first, count; const prt_point *points;
                      prt_real *transfer; prt_result result; } part;

static void *bake_part(void *user) {
    part *p = (part *)user;
    p->result = prt_bake_transfer(p->desc, p->point_count, p->points, p->first, p->count, p->transfer);
    return NULL;
}

static void threads_give_the_same_bits(void **state) {
    enum { POINTS = 200, MOST = 8 };
    static prt_point points[POINTS];
    static prt_real whole[POINTS * N], parts[POINTS * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int threads, k;
    (void)state;
    begin(&desc, &tracer, &b);
    tracer.occluded = shared_ball_occluded;
    scatter(POINTS, points);
    desc.samples = 300;
    assert_int_equal(prt_bake_transfer(&desc, POINTS, points, 0, POINTS, whole), PRT_OK);
    for (threads = 2; threads <= MOST; threads += 3) {
        pthread_t thread[MOST];
        part job[MOST];
        memset(parts, 0xff, sizeof parts);
        for (k = 0; k < threads; k++) {
            job[k].desc = &desc; job[k].point_count = POINTS; job[k].points = points; job[k].transfer = parts;
            job[k].first = POINTS * k / threads;
            job[k].count = POINTS * (k + 1) / threads - job[k].first;
            assert_int_equal(pthread_create(&thread[k], NULL, bake_part, &job[k]), 0);
        }
        for (k = 0; k < threads; k++) {
            assert_int_equal(pthread_join(thread[k], NULL), 0);
            assert_int_equal(job[k].result, PRT_OK);
        }
        assert_memory_equal(whole, parts, sizeof whole);
    }
}

/* A scene scaled by a power of two, its radius given, has the same bits: 1e-30 to 1e15 of the size in float. */
static void scale_does_not_matter(void **state) {
    static const int exponent[] = { -100, -20, 20, 50 };
    enum { POINTS = 10 };
    prt_point points[POINTS], scaled[POINTS];
    prt_real unit[POINTS * N], other[POINTS * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int q, k;
    (void)state;
    begin(&desc, &tracer, &b);
    scatter(POINTS, points);
    desc.scene_radius = 4;
    assert_int_equal(prt_bake_transfer(&desc, POINTS, points, 0, POINTS, unit), PRT_OK);
    for (q = 0; q < 4; q++) {
        double scale = ldexp(1, exponent[q]);
        for (k = 0; k < POINTS; k++) {
            scaled[k] = points[k];
            scaled[k].position = vec3((double)points[k].position.x * scale, (double)points[k].position.y * scale,
                                      (double)points[k].position.z * scale);
        }
        b.centre = vec3(0.5 * scale, -0.25 * scale, 2 * scale);
        b.radius = scale;
        desc.scene_radius = (prt_real)(4 * scale);
        assert_int_equal(prt_bake_transfer(&desc, POINTS, scaled, 0, POINTS, other), PRT_OK);
        assert_memory_equal(unit, other, sizeof unit);
    }
}

static void seeds_differ(void **state) {
    prt_point points[2];
    prt_real a[2 * N], b[2 * N];
    prt_bake_desc desc;
    (void)state;
    memset(&desc, 0, sizeof desc);
    points[0] = points[1] = point(vec3(0, 0, 0), vec3(0, 0, 1));
    desc.samples = 64;
    assert_int_equal(prt_bake_transfer(&desc, 2, points, 0, 2, a), PRT_OK);
    desc.seed = 1;
    assert_int_equal(prt_bake_transfer(&desc, 2, points, 0, 2, b), PRT_OK);
    assert_memory_not_equal(a + 1, b + 1, (N - 1) * sizeof *a);
    assert_memory_not_equal(a + 1, a + N + 1, (N - 1) * sizeof *a);
}

/* ---- what the tracer receives ---- */

typedef struct watch {
    const prt_point *points;
    int samples, batches, short_batches;
    double bias;
    long rays;
    prt_vec3 dirs[1024];               /* of the point that the last ray belonged to */
} watch;

static int watching(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    watch *w = (watch *)user;
    int k;
    assert_in_range(count, 1, PRT_BAKE_BATCH);
    assert_int_equal(w->short_batches, 0);             /* only the last may be short */
    w->short_batches += count <= PRT_BAKE_BATCH - 64;
    for (k = 0; k < count; k++) {
        int index = (int)((w->rays + k) / w->samples), member = (int)((w->rays + k) % w->samples);
        const prt_point *p = &w->points[index];
        if (member == 0) prt_sample_directions(w->samples, 21, (uint64_t)index, p->normal, 0, w->samples, w->dirs);
#ifndef __FAST_MATH__                  /* which may round differently where a function is inlined twice */
        assert_memory_equal(&rays[k].dir, &w->dirs[member], sizeof rays[k].dir);
#endif
        assert_near(dot(rays[k].dir, rays[k].dir), 1, 12 * PRT__EPS);
        assert_true(dot(rays[k].dir, p->normal) >= 0);
        assert_true(rays[k].tmin == 0);
        assert_true(rays[k].tmax == PRT__R(FLT_MAX));
        assert_near(rays[k].origin.x, (double)p->position.x + w->bias * (double)p->normal.x, 4 * PRT__EPS);
        assert_near(rays[k].origin.y, (double)p->position.y + w->bias * (double)p->normal.y, 4 * PRT__EPS);
        assert_near(rays[k].origin.z, (double)p->position.z + w->bias * (double)p->normal.z, 4 * PRT__EPS);
        assert_int_equal(blocked[k], 0);
        blocked[k] = (unsigned char)(k & 1);
    }
    w->rays += count;
    w->batches++;
    return 0;
}

static void rays_keep_the_contract(void **state) {
    static const double bias[5][3] = { { 0, 0, 1e-4 }, { 0, 50, 5e-3 }, { 0.25, 50, 0.25 }, { 0.5, 0, 0.5 },
                                       { 0, 1e-3, 1e-7 } };
    prt_point points[50];
    prt_real transfer[50 * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    watch w;
    int k;
    (void)state;
    scatter(50, points);
    for (k = 0; k < 5; k++) {
        memset(&desc, 0, sizeof desc); memset(&tracer, 0, sizeof tracer); memset(&w, 0, sizeof w);
        tracer.user = &w; tracer.occluded = watching;
        desc.tracer = &tracer;
        desc.seed = 21;
        desc.bias = (prt_real)bias[k][0]; desc.scene_radius = (prt_real)bias[k][1];
        desc.samples = k == 0 ? 0 : k == 1 ? 1 : k == 2 ? 600 : 77;
        w.points = points; w.bias = bias[k][2]; w.samples = desc.samples ? desc.samples : 1024;
        assert_int_equal(prt_bake_transfer(&desc, 50, points, 0, 50, transfer), PRT_OK);
        assert_int_equal(w.rays, 50 * w.samples);
        assert_at_most(w.batches, 50.0 * w.samples / (PRT_BAKE_BATCH - 63) + 1);
    }
}

/* ---- ranges, progress, cancelling, failing ---- */

enum { MANY = 30 };

static void canaries(prt_real *transfer) {
    int k;
    for (k = 0; k < MANY * N; k++) transfer[k] = 12345;
}

/* Rows first ... first+count-1 equal `want`, all others still hold canaries. */
static void assert_only_rows(const prt_real *transfer, const prt_real *want, int first, int count) {
    int k;
    for (k = 0; k < MANY * N; k++) {
        if (k / N >= first && k / N < first + count) assert_true(transfer[k] == want[k]);
        else assert_true(transfer[k] == 12345);
    }
}

typedef struct clerk { int calls, total, stop_at; } clerk;

static int keep_count(void *user, int done, int total) {
    clerk *c = (clerk *)user;
    c->calls++;
    assert_int_equal(done, c->calls);
    assert_int_equal(total, c->total);
    return done == c->stop_at;
}

static void only_the_range_is_read_and_written(void **state) {
    prt_point points[MANY];
    prt_real want[MANY * N], transfer[MANY * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int k;
    (void)state;
    begin(&desc, &tracer, &b);
    desc.samples = 100;
    scatter(MANY, points);
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, want), PRT_OK);
    for (k = 0; k < MANY; k++) if (k < 10 || k >= 15) points[k].normal = vec3(NAN, 0, 0);
    canaries(transfer);
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 10, 5, transfer), PRT_OK);
    assert_only_rows(transfer, want, 10, 5);
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 10, 6, transfer), PRT_ERR_VALUE);
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 9, 6, transfer), PRT_ERR_VALUE);
    assert_only_rows(transfer, want, 10, 5);
}

static void progress_counts_and_cancels(void **state) {
    static const int samples[] = { 1, 100, 3000 };
    prt_point points[MANY];
    prt_real want[MANY * N], transfer[MANY * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    clerk c;
    int s, stop;
    (void)state;
    begin(&desc, &tracer, &b);
    scatter(MANY, points);
    for (s = 0; s < 3; s++) {
        desc.samples = samples[s];
        desc.progress = NULL;
        assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, want), PRT_OK);
        desc.progress = keep_count; desc.progress_user = &c;
        for (stop = 0; stop <= 20; stop++) {           /* 0: never; 20: at the last */
            memset(&c, 0, sizeof c);
            c.total = 20; c.stop_at = stop;
            canaries(transfer);
            assert_int_equal(prt_bake_transfer(&desc, MANY, points, 3, 20, transfer),
                             stop ? PRT_ERR_CANCELLED : PRT_OK);
            assert_int_equal(c.calls, stop ? stop : 20);
            assert_only_rows(transfer, want, 3, c.calls);
        }
    }
}

static void a_failing_tracer_ends_the_bake(void **state) {
    prt_point points[MANY];
    prt_real want[MANY * N], transfer[MANY * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    clerk c;
    int fail;
    (void)state;
    begin(&desc, &tracer, &b);
    scatter(MANY, points);
    desc.samples = 700;
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, want), PRT_OK);
    desc.progress = keep_count; desc.progress_user = &c;
    for (fail = 1; fail < 10; fail++) {
        memset(&c, 0, sizeof c);
        c.total = MANY;
        b.calls = 0; b.rays = 0; b.fail_at = fail;
        canaries(transfer);
        assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, transfer), PRT_ERR_TRACE);
        assert_int_equal(b.calls, fail);
        assert_in_range(c.calls, 0, b.rays / 700);
        assert_only_rows(transfer, want, 0, c.calls);
    }
}

static void every_error_in_its_order(void **state) {
    static const double bad_values[] = { -1, NAN, INFINITY, -INFINITY };
    prt_point points[MANY], good[MANY];
    prt_real transfer[MANY * N], bad_normals[4];
    prt_bake_desc desc, ok;
    prt_tracer tracer;
    ball b;
    int k;
    (void)state;
    begin(&ok, &tracer, &b);
    ok.samples = 10;
    desc = ok;
    scatter(MANY, good);
    memcpy(points, good, sizeof points);
    canaries(transfer);
    assert_int_equal(prt_bake_transfer(NULL, MANY, points, 0, MANY, transfer), PRT_ERR_NULL);
    desc.bands = -1; desc.samples = -1;
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, transfer), PRT_ERR_BANDS);
    desc.bands = PRT_MAX_BANDS + 1;
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, 0, MANY, NULL), PRT_ERR_BANDS);
    desc.bands = INT_MAX;
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, 0, MANY, NULL), PRT_ERR_BANDS);
    desc.bands = 0;
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, 0, MANY, NULL), PRT_ERR_COUNT);
    desc = ok;
    assert_int_equal(prt_bake_transfer(&desc, -1, NULL, 0, 0, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, -1, 2, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, 0, -1, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, 1, MANY, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, MANY + 1, 0, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_transfer(&desc, INT_MAX, NULL, INT_MAX, INT_MAX, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_transfer(&desc, MANY, NULL, 0, MANY, transfer), PRT_ERR_NULL);
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, NULL), PRT_ERR_NULL);
    tracer.occluded = NULL;
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, transfer), PRT_ERR_NULL);
    tracer.occluded = ball_occluded;
    for (k = 0; k < 4; k++) {
        desc = ok;
        desc.bias = (prt_real)bad_values[k];
        assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, transfer), PRT_ERR_VALUE);
        desc = ok;
        desc.scene_radius = (prt_real)bad_values[k];
        assert_int_equal(prt_bake_transfer(&desc, MANY, points, 0, MANY, transfer), PRT_ERR_VALUE);
    }
    bad_normals[0] = 0; bad_normals[1] = PRT__R(0.9985); bad_normals[2] = PRT__R(1.0015); bad_normals[3] = PRT__R(NAN);
    for (k = 0; k < 4; k++) {
        memcpy(points, good, sizeof points);
        points[MANY - 1].normal = vec3(0, (double)bad_normals[k], 0);
        assert_int_equal(prt_bake_transfer(&ok, MANY, points, 0, MANY, transfer), PRT_ERR_VALUE);
        memcpy(points, good, sizeof points);
        points[0].position.y = (prt_real)bad_values[k];
        assert_int_equal(prt_bake_transfer(&ok, MANY, points, 0, MANY, transfer), k ? PRT_ERR_VALUE : PRT_OK);
        if (!k) canaries(transfer);
    }
    desc = ok;
    desc.bias = PRT__REAL_MAX;         /* finite, but the rays would start at infinity */
    memcpy(points, good, sizeof points);
    points[4].position = vec3((double)PRT__REAL_MAX, 0, 0); points[4].normal = vec3(1, 0, 0);
    assert_int_equal(prt_bake_transfer(&desc, MANY, points, 4, 1, transfer), PRT_ERR_VALUE);
    assert_only_rows(transfer, transfer, 0, 0);
    assert_int_equal(prt_bake_transfer(&ok, 0, NULL, 0, 0, NULL), PRT_OK);
    assert_int_equal(prt_bake_transfer(&ok, MANY, NULL, MANY, 0, NULL), PRT_OK);
    memcpy(points, good, sizeof points);
    points[0].normal = vec3(0, 0, 0.9991);
    assert_int_equal(prt_bake_transfer(&ok, 1, points, 0, 1, transfer), PRT_OK);
}

/* ---- memory ---- */

static void one_modest_allocation(void **state) {
    prt_point p = point(vec3(0, 0, 0), vec3(0, 0, 1));
    prt_real *transfer = (prt_real *)malloc(PRT_SH_COUNT(64) * sizeof *transfer);
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int bands;
    (void)state;
    begin(&desc, &tracer, &b);
    for (bands = 1; bands <= 64; bands++) {
        memset(&memory_hook, 0, sizeof memory_hook);
        desc.bands = bands;
        desc.samples = bands % 2 ? 130 : 20000;
        assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_OK);
        assert_int_equal(memory_hook.calls, 1);
        assert_int_equal(memory_hook.frees, 1);
        assert_int_equal(memory_hook.size, prt_bake_scratch_size(bands));
        assert_at_most(memory_hook.size, 640 * 1024);
    }
    assert_int_equal(prt_bake_scratch_size(0), prt_bake_scratch_size(5));
    assert_int_equal(prt_bake_scratch_size(-1), 0);
    assert_int_equal(prt_bake_scratch_size(PRT_MAX_BANDS + 1), 0);
    free(transfer);
}

static void memory_goes_back_on_every_way_out(void **state) {
    prt_point p = point(vec3(0, 0, 0), vec3(0, 0, 1));
    prt_real transfer[MANY * N];
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    clerk c;
    (void)state;
    begin(&desc, &tracer, &b);
    memset(&memory_hook, 0, sizeof memory_hook);
    memory_hook.fail = 1;
    canaries(transfer);
    assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_ERR_MEMORY);
    assert_only_rows(transfer, transfer, 0, 0);
    assert_int_equal(b.calls, 0);
    assert_int_equal(memory_hook.frees, 0);
    memory_hook.fail = 0;
    b.fail_at = 1;
    assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_ERR_TRACE);
    memset(&c, 0, sizeof c);
    c.total = 1; c.stop_at = 1;
    desc.progress = keep_count; desc.progress_user = &c;
    assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_ERR_CANCELLED);
    assert_int_equal(memory_hook.calls, 3);
    assert_int_equal(memory_hook.frees, 2);
    memset(&memory_hook, 0, sizeof memory_hook);
    desc.samples = -1;
    assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_ERR_COUNT);
    desc.samples = 0;
    assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 0, transfer), PRT_OK);
    assert_int_equal(memory_hook.calls, 0);
}

static void sizes_do_not_overflow(void **state) {
    (void)state;
    assert_int_equal(prt_bake_transfer_size(5, 1000), 25000 * sizeof(prt_real));
    assert_int_equal(prt_bake_transfer_size(5, 0), 0);
    assert_int_equal(prt_bake_transfer_size(0, 1), 0);
    assert_int_equal(prt_bake_transfer_size(PRT_MAX_BANDS + 1, 1), 0);
    assert_int_equal(prt_bake_transfer_size(5, -1), 0);
    if (sizeof(size_t) == 4) assert_int_equal(prt_bake_transfer_size(PRT_MAX_BANDS, INT_MAX), 0);
    else assert_true(prt_bake_transfer_size(PRT_MAX_BANDS, INT_MAX) / sizeof(prt_real) / INT_MAX ==
                     PRT_SH_COUNT(PRT_MAX_BANDS));
}

/* ---- the error of a bake ---- */

static void two_seeds_tell_the_error(void **state) {
    enum { POINTS = 200 };
    static prt_point points[POINTS];
    static prt_real a[POINTS * N], b2[POINTS * N], mean[POINTS * N], reference[POINTS * N], error[POINTS];
    double estimated = 0, actual = 0;
    prt_bake_desc desc;
    prt_tracer tracer;
    ball b;
    int k;
    (void)state;
    begin(&desc, &tracer, &b);
    scatter(POINTS, points);
    desc.samples = 20000; desc.seed = 99;
    assert_int_equal(prt_bake_transfer(&desc, POINTS, points, 0, POINTS, reference), PRT_OK);
    desc.samples = 200; desc.seed = 1;
    assert_int_equal(prt_bake_transfer(&desc, POINTS, points, 0, POINTS, a), PRT_OK);
    desc.seed = 2;
    assert_int_equal(prt_bake_transfer(&desc, POINTS, points, 0, POINTS, b2), PRT_OK);
    assert_int_equal(prt_bake_error(BANDS, POINTS, a, b2, mean, error), PRT_OK);
    for (k = 0; k < POINTS; k++) estimated += (double)error[k] * (double)error[k];
    for (k = 0; k < POINTS * N; k++) {
        assert_near(mean[k], ((double)a[k] + (double)b2[k]) / 2, PRT__EPS);
        actual += ((double)mean[k] - (double)reference[k]) * ((double)mean[k] - (double)reference[k]);
    }
    assert_in_range((int)(1000 * sqrt(estimated / actual)), 850, 1150);
    assert_int_equal(prt_bake_error(BANDS, POINTS, a, b2, a, NULL), PRT_OK);
    assert_memory_equal(a, mean, sizeof a);
    assert_int_equal(prt_bake_error(0, 1, a, b2, mean, error), PRT_ERR_BANDS);
    assert_int_equal(prt_bake_error(BANDS, -1, a, b2, mean, error), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_error(BANDS, 1, NULL, b2, mean, error), PRT_ERR_NULL);
    assert_int_equal(prt_bake_error(BANDS, 1, a, NULL, mean, error), PRT_ERR_NULL);
    assert_int_equal(prt_bake_error(BANDS, 0, NULL, NULL, NULL, NULL), PRT_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ball_is_its_closed_form),
        cmocka_unit_test(unshadowed_is_the_cosine_lobe),
        cmocka_unit_test(white_furnace_is_white),
        cmocka_unit_test(is_the_stated_sum),
        cmocka_unit_test(blocked_is_zero_and_open_is_unshadowed),
        cmocka_unit_test(a_million_rays),
        cmocka_unit_test(ranges_give_the_same_bits),
        cmocka_unit_test(threads_give_the_same_bits),
        cmocka_unit_test(scale_does_not_matter),
        cmocka_unit_test(seeds_differ),
        cmocka_unit_test(rays_keep_the_contract),
        cmocka_unit_test(only_the_range_is_read_and_written),
        cmocka_unit_test(progress_counts_and_cancels),
        cmocka_unit_test(a_failing_tracer_ends_the_bake),
        cmocka_unit_test(every_error_in_its_order),
        cmocka_unit_test(one_modest_allocation),
        cmocka_unit_test(memory_goes_back_on_every_way_out),
        cmocka_unit_test(sizes_do_not_overflow),
        cmocka_unit_test(two_seeds_tell_the_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
