/* >>sample: stratification, nets, lattices, unbiasedness, mappings, the bake's directions. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "geometry.h"
#include <limits.h>

enum { MOST = 4096 };
static prt_real u[MOST], v[MOST], other_u[MOST], other_v[MOST];
static prt_vec3 dirs[MOST];

static void draw(prt_sample_set set, int total, uint64_t seed, uint64_t index) {
    assert_int_equal(prt_sample_square(set, total, seed, index, 0, total, u, v), PRT_OK);
}

static void members_lie_in_the_square(void **state) {
    int set, total, k;
    (void)state;
    for (set = 0; set < PRT_SAMPLE_SET_COUNT; set++)
        for (total = 1; total < 300; total++) {
            draw((prt_sample_set)set, total, (uint64_t)total, 3);
            for (k = 0; k < total; k++) assert_true(u[k] >= 0 && u[k] < 1 && v[k] >= 0 && v[k] < 1);
        }
}

static void ranges_give_the_same_members(void **state) {
    int set, first;
    (void)state;
    for (set = 0; set < PRT_SAMPLE_SET_COUNT; set++) {
        draw((prt_sample_set)set, 500, 9, 4);
        for (first = 0; first < 500; first += 37) {
            int count = 500 - first < 37 ? 500 - first : 37;
            assert_int_equal(prt_sample_square((prt_sample_set)set, 500, 9, 4, first, count, other_u, other_v), PRT_OK);
            assert_memory_equal(other_u, u + first, (size_t)count * sizeof *u);
            assert_memory_equal(other_v, v + first, (size_t)count * sizeof *v);
        }
    }
}

static void seed_and_index_both_matter(void **state) {
    int set;
    (void)state;
    for (set = 0; set < PRT_SAMPLE_SET_COUNT; set++) {
        draw((prt_sample_set)set, 16, 1, 2);
        memcpy(other_u, u, sizeof u);
        memcpy(other_v, v, sizeof v);
        draw((prt_sample_set)set, 16, 2, 1);
        assert_memory_not_equal(u, other_u, 16 * sizeof *u);
        assert_memory_not_equal(v, other_v, 16 * sizeof *v);
        draw((prt_sample_set)set, 16, 1, 3);
        assert_memory_not_equal(u, other_u, 16 * sizeof *u);
        assert_memory_not_equal(v, other_v, 16 * sizeof *v);
    }
}

/* Every dyadic box of area 1/2^m holds exactly one of 2^m members. */
static void sobol_is_a_net(void **state) {
    int m, split, k;
    (void)state;
    for (m = 0; m <= 10; m++) {
        draw(PRT_SAMPLE_SOBOL, 1 << m, 5, (uint64_t)m);
        for (split = 0; split <= m; split++) {
            unsigned char seen[1 << 10] = { 0 };
            for (k = 0; k < 1 << m; k++) {
                int row = (int)((double)u[k] * (1 << split)), column = (int)((double)v[k] * (1 << (m - split)));
                int box = (row << (m - split)) + column;
                assert_int_equal(seen[box], 0);
                seen[box] = 1;
            }
        }
    }
}

static void jittered_has_one_member_a_cell(void **state) {
    int rows, k, total;
    (void)state;
    for (rows = 1; rows <= 50; rows++) {               /* squares: the grid of the thesis */
        draw(PRT_SAMPLE_JITTERED, rows * rows, 5, 1);
        for (k = 0; k < rows * rows; k++) {
            assert_int_equal((int)((double)u[k] * rows), k / rows);
            assert_int_equal((int)((double)v[k] * rows), k % rows);
        }
    }
    for (total = 1; total < 700; total++) {            /* any count: whole rows of equal cells, area cells/total */
        int row, start = 0;
        rows = (int)sqrt((double)total);
        draw(PRT_SAMPLE_JITTERED, total, 5, 1);
        for (row = 0; row < rows; row++) {
            int end = (row + 1) * total / rows;
            for (k = start; k < end; k++) {
                assert_true((double)u[k] * total >= start - 1e-3 && (double)u[k] * total <= end + 1e-3);
                assert_true((double)v[k] * (end - start) >= k - start - 1e-4);
                assert_true((double)v[k] * (end - start) <= k - start + 1 + 1e-4);
            }
            start = end;
        }
    }
}

/* One member a row of u; steps of v by the golden ratio, from a common start. */
static void fibonacci_is_a_shifted_lattice(void **state) {
    static const int totals[] = { 1, 2, 13, 600, 4096 };
    double golden = (sqrt(5) - 1) / 2;
    int q, k;
    (void)state;
    for (q = 0; q < 5; q++) {
        draw(PRT_SAMPLE_FIBONACCI, totals[q], 5, (uint64_t)q);
        for (k = 0; k < totals[q]; k++) {
            double turn = (double)v[k] - (double)v[0] - k * golden;
            assert_near((double)u[k] * totals[q] - k, (double)u[0] * totals[q], 1e-7 * totals[q]);
            assert_near(turn - floor(turn + 0.5), 0, BY_PRECISION(1e-6, 1e-12));
        }
    }
}

/* Over indices, the mean of a function over a set estimates its integral without bias, for a total that is no square
   and no power of two, and no worse than independent members do. */
static void sets_are_unbiased(void **state) {
    enum { SETS = 4000, TOTAL = 7 };
    int set, s, k, f;
    (void)state;
    for (set = 0; set < PRT_SAMPLE_SET_COUNT; set++) {
        static const double want[4] = { 1.0 / 3, 1.0 / 3, 0.25, 0.5 };
        double sum[4] = { 0 }, square[4] = { 0 };
        for (s = 0; s < SETS; s++) {
            double mean[4] = { 0 };
            draw((prt_sample_set)set, TOTAL, 11, (uint64_t)s);
            for (k = 0; k < TOTAL; k++) {
                double a = (double)u[k], b = (double)v[k];
                mean[0] += a * a; mean[1] += b * b; mean[2] += a * b; mean[3] += a + b < 1;
            }
            for (f = 0; f < 4; f++) {
                sum[f] += mean[f] / TOTAL - want[f];
                square[f] += (mean[f] / TOTAL - want[f]) * (mean[f] / TOTAL - want[f]);
            }
        }
        for (f = 0; f < 4; f++) {
            static const double variance[4] = { 4.0 / 45, 4.0 / 45, 7.0 / 144, 0.25 };
            double error = sqrt(square[f]) / SETS;
            assert_near(sum[f] / SETS, 0, 5 * error);
            assert_at_most(square[f] / SETS, 1.1 * variance[f] / TOTAL);
        }
    }
}

static void bad_arguments(void **state) {
    static const int bad[][3] = { { -1, 0, 0 }, { 10, -1, 1 }, { 10, 0, -1 }, { 10, 1, 10 }, { 10, 11, 0 },
                                  { INT_MAX, INT_MAX, INT_MAX } };
    prt_vec3 up = vec3(0, 0, 1);
    int k;
    (void)state;
    for (k = 0; k < 6; k++) {
        assert_int_equal(prt_sample_square(PRT_SAMPLE_SOBOL, bad[k][0], 0, 0, bad[k][1], bad[k][2], u, v),
                         PRT_ERR_COUNT);
        assert_int_equal(prt_sample_directions(bad[k][0], 0, 0, up, bad[k][1], bad[k][2], dirs), PRT_ERR_COUNT);
    }
    assert_int_equal(prt_sample_square(PRT_SAMPLE_SOBOL, 1, 0, 0, 0, 1, NULL, v), PRT_ERR_NULL);
    assert_int_equal(prt_sample_square(PRT_SAMPLE_SOBOL, 1, 0, 0, 0, 1, u, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sample_square(PRT_SAMPLE_SOBOL, 1, 0, 0, 0, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_sample_square(PRT_SAMPLE_SOBOL, 0, 0, 0, 0, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_sample_square(PRT_SAMPLE_SET_COUNT, 1, 0, 0, 0, 1, u, v), PRT_ERR_VALUE);
    assert_int_equal(prt_sample_square((prt_sample_set)-1, 1, 0, 0, 0, 1, u, v), PRT_ERR_VALUE);
    assert_int_equal(prt_sample_directions(1, 0, 0, up, 0, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sample_directions(1, 0, 0, up, 0, 0, NULL), PRT_OK);
    assert_int_equal(prt_sample_directions(1, 0, 0, vec3(0, 0, 1.0015), 0, 1, dirs), PRT_ERR_VALUE);
    assert_int_equal(prt_sample_directions(1, 0, 0, vec3(0, NAN, 1), 0, 1, dirs), PRT_ERR_VALUE);
    for (k = 0; k < PRT_SAMPLE_SET_COUNT; k++) {       /* the last members of the largest sets */
        assert_int_equal(prt_sample_square((prt_sample_set)k, INT_MAX, 1, 1, INT_MAX - 3, 3, u, v), PRT_OK);
        assert_true(u[2] >= 0 && u[2] < 1 && v[2] >= 0 && v[2] < 1);
    }
    assert_int_equal(prt_sample_directions(INT_MAX, 1, 1, up, INT_MAX - 3, 3, dirs), PRT_OK);
    assert_near(dot(dirs[2], dirs[2]), 1, 12 * PRT__EPS);
}

/* The thesis' mapping theta = 2 acos(sqrt(1-u)) itself, and moments of the three densities by the midpoint rule. */
static void mappings_have_their_densities(void **state) {
    static const double want[3][2] = { { 0, 1.0 / 3 }, { 0.5, 1.0 / 3 }, { 2.0 / 3, 0.5 } };   /* mean of z, of z^2 */
    enum { STEPS = 400 };
    int map, i, j;
    (void)state;
    for (map = 0; map < 3; map++) {
        double z1 = 0, z2 = 0, x1 = 0, y1 = 0, xy = 0;
        for (i = 0; i < STEPS; i++)
            for (j = 0; j < STEPS; j++) {
                prt_real a = (prt_real)((i + 0.5) / STEPS), b = (prt_real)((j + 0.5) / STEPS);
                prt_vec3 d = map == 0 ? prt_sample_sphere(a, b) : map == 1 ? prt_sample_hemisphere(a, b)
                                                                           : prt_sample_cosine(a, b);
                assert_near(dot(d, d), 1, 4 * PRT__EPS);
                if (map) assert_true(d.z >= 0);
                z1 += (double)d.z; z2 += (double)d.z * (double)d.z;
                x1 += (double)d.x; y1 += (double)d.y; xy += (double)d.x * (double)d.y;
            }
        assert_near(z1 / (STEPS * STEPS), want[map][0], 1e-4);
        assert_near(z2 / (STEPS * STEPS), want[map][1], 1e-4);
        assert_near(x1 / (STEPS * STEPS), 0, 1e-6);
        assert_near(y1 / (STEPS * STEPS), 0, 1e-6);
        assert_near(xy / (STEPS * STEPS), 0, 1e-6);
    }
    for (i = 0; i < 100; i++) {
        double a = i / 100.0, b = i * 0.37 - floor(i * 0.37), theta = 2 * acos(sqrt(1 - a));
        prt_vec3 d = prt_sample_sphere((prt_real)a, (prt_real)b);
        assert_near(d.x, sin(theta) * cos(2 * pi * b), 2e-6);
        assert_near(d.y, sin(theta) * sin(2 * pi * b), 2e-6);
        assert_near(d.z, cos(theta), 2e-6);
    }
    assert_true(prt_sample_cosine(0, 0).z == 1);
    assert_true(prt_sample_sphere(0, 0).z == 1);
}

/* About +z the bake's directions are the Fibonacci set, mapped by cosine; about any normal they are that set turned. */
static void directions_are_the_fibonacci_set(void **state) {
    static const double normal[][3] = { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, -1, 0 }, { 0.48, 0.6, -0.64 },
                                        { 1e-4, 0, -1 }, { 0, 1e-7, 1 } };
    static const int totals[] = { 1, 2, 63, 64, 65, 600, 4000 };
    int q, s, k, first;
    (void)state;
    for (q = 0; q < 7; q++) for (s = 0; s < 7; s++) {
        int total = totals[s];
        prt_vec3 n = vec3(normal[q][0], normal[q][1], normal[q][2]), part[64];
        assert_int_equal(prt_sample_directions(total, 8, 15, n, 0, total, dirs), PRT_OK);
        draw(PRT_SAMPLE_FIBONACCI, total, 8, 15);
        for (k = 0; k < total; k++) {
            prt_vec3 want = prt_sample_cosine(u[k], v[k]), first_want = prt_sample_cosine(u[0], v[0]);
            assert_near(dot(dirs[k], dirs[k]), 1, 12 * PRT__EPS);
            assert_near(dot(dirs[k], n), want.z, BY_PRECISION(4e-5, 3e-8));        /* sqrt(1-u), u being rounded */
            assert_near(dot(dirs[k], dirs[0]), dot(want, first_want), BY_PRECISION(6e-5, 6e-8));
            if (q == 0) {
                assert_near(dirs[k].x, want.x, 4e-6);
                assert_near(dirs[k].y, want.y, 4e-6);
            }
        }
        for (first = 0; first < total; first += 41) {
            int count = total - first < 41 ? total - first : 41;
            assert_int_equal(prt_sample_directions(total, 8, 15, n, first, count, part), PRT_OK);
            assert_memory_equal(part, dirs + first, (size_t)count * sizeof *part);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(members_lie_in_the_square),
        cmocka_unit_test(ranges_give_the_same_members),
        cmocka_unit_test(seed_and_index_both_matter),
        cmocka_unit_test(sobol_is_a_net),
        cmocka_unit_test(jittered_has_one_member_a_cell),
        cmocka_unit_test(fibonacci_is_a_shifted_lattice),
        cmocka_unit_test(sets_are_unbiased),
        cmocka_unit_test(bad_arguments),
        cmocka_unit_test(mappings_have_their_densities),
        cmocka_unit_test(directions_are_the_fibonacci_set),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
