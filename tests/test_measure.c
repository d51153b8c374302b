/* Measuring what a scene requires: Parseval against known functions, truncation against shading with and without the
   bands, the mean over turned light against turning it, needed rays against bakes, entropy against closed forms. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "geometry.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)

/* A unit delta has (2l+1)/4pi in band l; max(0, cos) has 2 pi/3 in all, of which pi/4, pi/3, 5 pi/64 in bands 0 to 2
   [Ramamoorthi 2001]; the mean of two functions. */
static void energy(void **state) {
    prt_real f[2 * 64];
    double e[8], sum = 0;
    int l;
    (void)state;
    assert_int_equal(prt_sh_delta(8, vec3(0.6, 0, -0.8), f), PRT_OK);
    assert_int_equal(prt_measure_energy(8, 1, f, e), PRT_OK);
    for (l = 0; l < 8; l++) assert_near(e[l], (2 * l + 1) / (4 * pi), 64 * EPS);
    assert_int_equal(prt_sh_cosine_lobe(8, vec3(0, 0.6, 0.8), f), PRT_OK);
    memset(f + 64, 0, 64 * sizeof *f);
    assert_int_equal(prt_measure_energy(8, 2, f, e), PRT_OK);
    assert_near(2 * e[0], pi / 4, 8 * EPS);
    assert_near(2 * e[1], pi / 3, 8 * EPS);
    assert_near(2 * e[2], 5 * pi / 64, 8 * EPS);
    for (l = 0; l < 8; l++) sum += 2 * e[l];
    assert_near(sum, 2 * pi / 3, 2e-3);                /* the rest lies above: band 8 alone has 4.3e-4 */
    assert_at_most(sum, 2 * pi / 3);
    assert_int_equal(prt_measure_energy(8, 0, NULL, e), PRT_OK);
    for (l = 0; l < 8; l++) assert_near(e[l], 0, 0);
}

/* What shading with all bands and shading with a windowed light differ by. */
static void truncation(void **state) {
    enum { N = 6, COUNT = N * N, POINTS = 20 };
    prt_real transfer[POINTS * COUNT], light[3 * COUNT], less[3 * COUNT];
    double rms;
    int kept, w, k, c;
    (void)state;
    random_vector(POINTS * COUNT, transfer);
    random_vector(3 * COUNT, light);
    for (w = 0; w <= PRT_WINDOW_POSITIVE; w++)
        for (kept = 0; kept <= N; kept++) {
            double sum = 0;
            memset(less, 0, sizeof less);
            for (c = 0; kept > 0 && c < 3; c++)
                assert_int_equal(prt_sh_window(N, (prt_window)w, kept, light + c * COUNT, less + c * COUNT), PRT_OK);
            for (k = 0; k < POINTS; k++) {
                prt_rgb all, some;
                prt_shade_diffuse(N, transfer + k * COUNT, light, &all);
                prt_shade_diffuse(N, transfer + k * COUNT, less, &some);
                sum += (double)((all.r - some.r) * (all.r - some.r) + (all.g - some.g) * (all.g - some.g) +
                                (all.b - some.b) * (all.b - some.b));
            }
            assert_int_equal(prt_measure_truncation(N, kept, (prt_window)w, POINTS, transfer, light, &rms), PRT_OK);
            assert_near(rms, sqrt(sum / (3 * POINTS)), 60 * EPS);
        }
    assert_int_equal(prt_measure_truncation(N, N, PRT_WINDOW_NONE, POINTS, transfer, light, &rms), PRT_OK);
    assert_near(rms, 0, 0);
    assert_int_equal(prt_measure_truncation(N, 2, PRT_WINDOW_NONE, 0, NULL, light, &rms), PRT_OK);
    assert_near(rms, 0, 0);
}

/* A directional light from all directions of a lattice turns a zonal light any way; on bands below n the lattice
   integrates products up to band 2n-2 well. One transfer vector, one light about an axis. */
static void truncation_of_a_turned_light(void **state) {
    enum { N = 5, COUNT = N * N, TURNS = 4096 };
    prt_real transfer[COUNT], zonal[N], light[3 * COUNT], q[4], r[9], u[3 * TURNS];
    double te[N], le[N], rms, sum = 0;
    int kept, k, c, i;
    (void)state;
    random_vector(COUNT, transfer);
    random_vector(N, zonal);
    memset(light, 0, sizeof light);
    for (c = 0; c < 3; c++) for (i = 0; i < N; i++) light[c * COUNT + PRT_SH_INDEX(i, 0)] = zonal[i];
    prt_measure_energy(N, 1, transfer, te);
    prt_measure_energy(N, 3, light, le);
    for (kept = 0; kept < N; kept++) {
        double z = 0;
        sum = 0;
        for (k = 0; k < TURNS; k++) {                  /* axes of a spherical Fibonacci lattice: exact to 1/TURNS */
            double height = 1 - (2 * k + 1.0) / TURNS, angle = 2 * pi * k * 0.61803398874989485;
            double radius = sqrt(1 - height * height);
            prt_real turned[COUNT];
            prt_sh_zonal_to(N, zonal, vec3(radius * cos(angle), radius * sin(angle), height), turned);
            for (z = 0, i = kept * kept; i < COUNT; i++) z += (double)transfer[i] * (double)turned[i];
            sum += z * z / TURNS;
        }
        assert_int_equal(prt_measure_truncation_turned(N, kept, PRT_WINDOW_NONE, te, le, &rms), PRT_OK);
        assert_near(rms, sqrt(sum), 1e-3 * sqrt(sum) + 100 * EPS);
    }
    /* any light, turned at random: a mean of squares of nearly normal numbers has a standard error of sqrt(2/n) */
    random_vector(3 * COUNT, light);
    random_vector(3 * TURNS, u);
    prt_measure_energy(N, 3, light, le);
    sum = 0;
    for (k = 0; k < TURNS; k++) {                      /* uniform rotations [Shoemake 1992] */
        double a = ((double)u[3 * k] + 1) / 2, b = pi * (double)u[3 * k + 1], d = pi * (double)u[3 * k + 2];
        q[0] = (prt_real)(sqrt(1 - a) * sin(b)); q[1] = (prt_real)(sqrt(1 - a) * cos(b));
        q[2] = (prt_real)(sqrt(a) * sin(d)); q[3] = (prt_real)(sqrt(a) * cos(d));
        assert_int_equal(prt_rotation_from_quaternion(q, r), PRT_OK);
        for (c = 0; c < 3; c++) {
            prt_real turned[COUNT];
            double z = 0;
            prt_sh_rotate(N, r, light + c * COUNT, turned);
            for (i = 0; i < COUNT; i++) {
                int l = (int)sqrt(i + 0.5);
                double lost = l >= 4 ? 1 : 1 - (double)prt_window_weight(PRT_WINDOW_HANN, l, 4);
                z += lost * (double)transfer[i] * (double)turned[i];
            }
            sum += z * z / (3 * TURNS);
        }
    }
    assert_int_equal(prt_measure_truncation_turned(N, 4, PRT_WINDOW_HANN, te, le, &rms), PRT_OK);
    assert_near(rms * rms / sum, 1, 5 * sqrt(2.0 / TURNS));
}

/* ---- bakes ---- */

static int wall(void *user, int count, const prt_ray *rays, unsigned char *blocked) {   /* x > 0.3 is hidden */
    int k;
    (void)user;
    for (k = 0; k < count; k++) blocked[k] = (double)rays[k].dir.x > 0.3;
    return 0;
}
enum { B = 4, BC = B * B, BAKED = 400 };
static prt_point baked_points[BAKED];
static void bake_wall(int samples, uint64_t seed, prt_real *transfer) {
    prt_tracer tracer;
    prt_bake_desc desc;
    int k;
    memset(&tracer, 0, sizeof tracer);
    memset(&desc, 0, sizeof desc);
    tracer.occluded = wall;
    desc.tracer = &tracer;
    desc.bands = B;
    desc.samples = samples;
    desc.seed = seed;
    for (k = 0; k < BAKED; k++) {
        double height = 1 - (2 * k + 1.0) / BAKED, angle = 2 * pi * k * 0.61803398874989485;
        double radius = sqrt(1 - height * height);
        baked_points[k].normal = prt_sample_sphere((prt_real)((1 - height) / 2), (prt_real)(angle / (2 * pi)));
        baked_points[k].position = vec3(radius, 0, 0);
    }
    assert_int_equal(prt_bake_transfer(&desc, BAKED, baked_points, 0, BAKED, transfer), PRT_OK);
}

/* The standard error that two halves predict is what their mean is off by, against a bake of very many rays; and the
   rays that it says are needed bring the error asked for. */
static void noise_and_rays(void **state) {
    static prt_real a[BAKED * BC], b[BAKED * BC], mean[BAKED * BC], truth[BAKED * BC], light[3 * BC];
    double predicted, off, fewer, rate;
    int rays;
    (void)state;
    random_vector(3 * BC, light);
    bake_wall(1 << 14, 99, truth);
    bake_wall(64, 1, a);
    bake_wall(64, 2, b);
    assert_int_equal(prt_measure_noise(B, BAKED, a, b, light, &predicted), PRT_OK);
    assert_int_equal(prt_bake_error(B, BAKED, a, b, mean, NULL), PRT_OK);
    assert_int_equal(prt_measure_noise(B, BAKED, mean, truth, light, &off), PRT_OK);
    assert_near(2 * off / predicted, 1, 5 / sqrt(2.0 * BAKED));          /* |mean - truth| is twice what it halves */
    bake_wall(32, 3, a);
    bake_wall(32, 4, b);
    prt_measure_noise(B, BAKED, a, b, light, &fewer);
    rate = log(fewer / predicted) / log(2.0);
    rays = prt_measure_rays(64, predicted, rate, predicted / 4);
    bake_wall(rays, 5, a);
    bake_wall(rays, 6, b);
    prt_measure_noise(B, BAKED, a, b, light, &off);
    assert_near(4 * off / predicted, 1, 0.5);          /* the rate from two pairs: 0.7 +- 0.07, and 4^(.07/.7) = 1.15 */
    assert_int_equal(prt_measure_rays(100, 1, 0.5, 0.1), 10000);
    assert_int_equal(prt_measure_rays(100, 1, 1, 2), 50);
    assert_int_equal(prt_measure_rays(100, 0, 0.5, 1), 1);
    assert_int_equal(prt_measure_rays(1000, 1e6, 0.5, 1e-6), INT_MAX);
    assert_int_equal(prt_measure_rays(0, 1, 0.5, 1), 0);
    assert_int_equal(prt_measure_rays(1, -1, 0.5, 1), 0);
    assert_int_equal(prt_measure_rays(1, 1, 0, 1), 0);
    assert_int_equal(prt_measure_rays(1, 1, 0.5, 0), 0);
}

static void entropy(void **state) {
    static const prt_real even[4] = { 2, 2, 2, 2 }, halves[3] = { PRT__R(0.5), PRT__R(0.25), PRT__R(0.25) };
    static const prt_real odd[3] = { 0, -1, 5 }, bell[2] = { PRT__R(0.11), PRT__R(0.89) };
    prt_visibility v;
    prt_real transfer[3];
    double y = 1 / (2 * sqrt(pi));
    (void)state;
    assert_near(prt_measure_entropy(4, even), 2, 1e-15);
    assert_near(prt_measure_entropy(3, halves), 1.5, 1e-15);
    assert_near(prt_measure_entropy(3, odd), 0, 0);
    assert_near(prt_measure_entropy(2, bell), 0.49991595816452800, 3 * EPS);   /* -.11 log2 .11 - .89 log2 .89 */
    assert_near(prt_measure_entropy(0, even), 0, 0);
    assert_near(prt_measure_entropy(-1, even), 0, 0);
    assert_near(prt_measure_entropy(2, NULL), 0, 0);
    transfer[0] = (prt_real)y; transfer[1] = 0;        /* one open point, one walled in: the point tells everything */
    assert_int_equal(prt_measure_visibility(1, 2, transfer, &v), PRT_OK);
    assert_near(v.open, 0.5, 2 * EPS);
    assert_near(v.entropy, 0, 40 * EPS);
    assert_near(v.information, 1, 40 * EPS);
    transfer[0] = transfer[1] = (prt_real)(y / 2);     /* two alike: it tells nothing, only the direction does */
    assert_int_equal(prt_measure_visibility(1, 2, transfer, &v), PRT_OK);
    assert_near(v.entropy, 1, 4 * EPS);
    assert_near(v.information, 0, 4 * EPS);
    transfer[0] = (prt_real)y; transfer[1] = (prt_real)(y / 2); transfer[2] = (prt_real)y;
    assert_int_equal(prt_measure_visibility(1, 3, transfer, &v), PRT_OK);
    assert_near(v.open, 5.0 / 6, 4 * EPS);
    assert_near(v.entropy, 1.0 / 3, 40 * EPS);
    assert_near(v.information, 0.65002242164835422 - 1.0 / 3, 40 * EPS);
    assert_int_equal(prt_measure_visibility(1, 0, NULL, &v), PRT_OK);
    assert_near(v.open + v.entropy + v.information, 0, 0);
}

static void occluders(void **state) {
    static const double want[4] = { (0.5 + 0.25 + 0.375) / 2, (0.25 + 0.125) / 2, 0.125 / 2, 0.125 / 2 };
    prt_vo_row rows[2] = { { 2, 0, 0 }, { 1, 3, PRT__R(0.125) } };
    prt_vo_occluder o[2 * 3];
    double left[6];
    int k;
    (void)state;
    memset(o, 0, sizeof o);
    o[0].form_factor = PRT__R(0.5); o[1].form_factor = PRT__R(0.25); o[3].form_factor = PRT__R(0.25);
    assert_int_equal(prt_measure_occluders(3, 2, rows, o, left), PRT_OK);
    for (k = 0; k < 4; k++) assert_near(left[k], want[k], 1e-15);
    rows[1].count = 4;
    left[0] = 7;
    assert_int_equal(prt_measure_occluders(3, 2, rows, o, left), PRT_ERR_COUNT);
    assert_near(left[0], 7, 0);
    assert_int_equal(prt_measure_occluders(0, 0, NULL, NULL, left), PRT_OK);
    for (k = 0; k < 6; k++) assert_near(left[k], 0, 0);
}

static void bad_arguments(void **state) {
    prt_real f[3 * 4] = { 0 };
    double d[4] = { 7, 7, 7, 7 };
    prt_visibility v;
    prt_vo_row row = { 0, 0, 0 };
    prt_vo_occluder o;
    (void)state;
    memset(&v, 0, sizeof v);
    memset(&o, 0, sizeof o);
    assert_int_equal(prt_measure_energy(0, -1, NULL, NULL), PRT_ERR_BANDS);
    assert_int_equal(prt_measure_energy(PRT_MAX_BANDS + 1, 1, f, d), PRT_ERR_BANDS);
    assert_int_equal(prt_measure_energy(2, -1, NULL, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_energy(2, 1, NULL, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_energy(2, 1, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_measure_truncation(0, -1, (prt_window)9, -1, NULL, NULL, NULL), PRT_ERR_BANDS);
    assert_int_equal(prt_measure_truncation(2, -1, PRT_WINDOW_NONE, 1, f, f, d), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_truncation(2, 3, PRT_WINDOW_NONE, 1, f, f, d), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_truncation(2, 1, PRT_WINDOW_NONE, -1, NULL, NULL, NULL), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_truncation(2, 1, (prt_window)9, 1, NULL, f, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_truncation(2, 1, PRT_WINDOW_NONE, 1, f, NULL, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_truncation(2, 1, PRT_WINDOW_NONE, 1, f, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_measure_truncation(2, 1, (prt_window)9, 1, f, f, d), PRT_ERR_VALUE);
    assert_int_equal(prt_measure_truncation_turned(0, 0, PRT_WINDOW_NONE, d, d, d), PRT_ERR_BANDS);
    assert_int_equal(prt_measure_truncation_turned(2, 3, PRT_WINDOW_NONE, d, d, d), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_truncation_turned(2, 1, PRT_WINDOW_NONE, NULL, d, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_truncation_turned(2, 1, PRT_WINDOW_NONE, d, NULL, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_truncation_turned(2, 1, PRT_WINDOW_NONE, d, d, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_measure_truncation_turned(2, 1, (prt_window)-1, d, d, d), PRT_ERR_VALUE);
    assert_int_equal(prt_measure_noise(0, 1, f, f, f, d), PRT_ERR_BANDS);
    assert_int_equal(prt_measure_noise(2, -1, f, f, f, d), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_noise(2, 1, NULL, f, f, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_noise(2, 1, f, NULL, f, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_noise(2, 1, f, f, NULL, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_noise(2, 1, f, f, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_measure_visibility(0, 1, f, &v), PRT_ERR_BANDS);
    assert_int_equal(prt_measure_visibility(2, -1, f, &v), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_visibility(2, 1, NULL, &v), PRT_ERR_NULL);
    assert_int_equal(prt_measure_visibility(2, 1, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_measure_occluders(-1, 1, &row, &o, d), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_occluders(1, -1, &row, &o, d), PRT_ERR_COUNT);
    assert_int_equal(prt_measure_occluders(1, 1, NULL, &o, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_occluders(1, 1, &row, NULL, d), PRT_ERR_NULL);
    assert_int_equal(prt_measure_occluders(1, 1, &row, &o, NULL), PRT_ERR_NULL);
    assert_near(d[0] + d[1] + d[2] + d[3], 28, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(energy),
        cmocka_unit_test(truncation),
        cmocka_unit_test(truncation_of_a_turned_light),
        cmocka_unit_test(noise_and_rays),
        cmocka_unit_test(entropy),
        cmocka_unit_test(occluders),
        cmocka_unit_test(bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
