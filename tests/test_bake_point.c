/* >>point: vertices to points, normals, reports, checks. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "geometry.h"
#include <float.h>

static void assert_vec3(prt_vec3 got, double x, double y, double z, double tolerance) {
    assert_near(got.x, x, tolerance); assert_near(got.y, y, tolerance); assert_near(got.z, z, tolerance);
}

/* The cube [-1,1]^3: corner k at the signs of its bits; faces cut along one diagonal each. */
static prt_vec3 corners[8];
static const uint32_t cube[12][3] = {
    { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 }, { 0, 1, 4 }, { 1, 5, 4 },
    { 2, 6, 3 }, { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };

static prt_mesh cube_mesh(double scale, double shift) {
    prt_mesh m;
    int k;
    memset(&m, 0, sizeof m);
    for (k = 0; k < 8; k++)
        corners[k] = vec3(scale * (k & 1 ? 1 : -1) + shift, scale * (k & 2 ? 1 : -1), scale * (k & 4 ? 1 : -1));
    m.vertex_count = 8; m.positions = corners;
    m.triangle_count = 12; m.triangles = &cube[0][0];
    return m;
}

/* By angle a cube's corners point along their diagonals, however its faces are cut; at any scale. */
static void angles_do_not_see_the_cut(void **state) {
    static const double scale[] = { 1, 1e-18, 1e-30, 1e18 };
    int s, k;
    (void)state;
    for (s = 0; s < 4; s++) {
        prt_mesh m = cube_mesh(scale[s], 0);
        prt_mesh_report report;
        prt_point points[8];
        double d = 1 / sqrt(3);
        assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_OK);
        for (k = 0; k < 8; k++) {
            assert_vec3(points[k].normal, k & 1 ? d : -d, k & 2 ? d : -d, k & 4 ? d : -d, 4 * PRT__EPS);
            assert_memory_equal(&points[k].position, &corners[k], sizeof corners[k]);
        }
        assert_int_equal(report.recomputed, 8);
        assert_int_equal(report.without, 0);
        assert_int_equal(report.degenerate, 0);
        assert_vec3(report.centre, 0, 0, 0, 0);
        assert_near((double)report.radius / scale[s], sqrt(3), 1e-6);
    }
}

/* By area a corner weighs each face with one or two triangles: counted here from the list. */
static void areas_see_the_cut(void **state) {
    prt_mesh m = cube_mesh(1, 5);
    prt_point points[8];
    prt_mesh_report report;
    int k, t, c;
    (void)state;
    m.area_weighted = 1;
    assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_OK);
    assert_vec3(report.centre, 5, 0, 0, 4 * PRT__EPS);
    for (k = 0; k < 8; k++) {
        double sum[3] = { 0 }, length;
        for (t = 0; t < 12; t++)
            for (c = 0; c < 3; c++)
                if (cube[t][c] == (uint32_t)k) sum[2 - t / 4] += 1;
        length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        assert_vec3(points[k].normal, (k & 1 ? 1 : -1) * sum[0] / length, (k & 2 ? 1 : -1) * sum[1] / length,
                    (k & 4 ? 1 : -1) * sum[2] / length, 4 * PRT__EPS);
    }
}

/* An apex with two faces, unequal in angle and in area: the sums in closed form. */
static void both_weights_in_closed_form(void **state) {
    static const uint32_t triangles[2][3] = { { 0, 1, 2 }, { 0, 2, 3 } };
    prt_vec3 positions[4];
    prt_mesh m;
    prt_point points[4];
    double a = acos(-1.0) / 2, b = acos(-1.0) / 4, length;
    (void)state;
    memset(&m, 0, sizeof m);
    positions[0] = vec3(0, 0, 0); positions[1] = vec3(1, 0, 0); positions[2] = vec3(0, 1, 0);
    positions[3] = vec3(0, 3, -3);     /* second face: normal towards -x, 45 degrees at the apex, area 3/2 */
    m.vertex_count = 4; m.positions = positions; m.triangle_count = 2; m.triangles = &triangles[0][0];
    assert_int_equal(prt_points_from_vertices(&m, points, NULL), PRT_OK);
    length = sqrt(a * a + b * b);
    assert_vec3(points[0].normal, -b / length, 0, a / length, 4 * PRT__EPS);
    assert_vec3(points[1].normal, 0, 0, 1, 4 * PRT__EPS);
    assert_vec3(points[3].normal, -1, 0, 0, 4 * PRT__EPS);
    m.area_weighted = 1;
    assert_int_equal(prt_points_from_vertices(&m, points, NULL), PRT_OK);
    length = sqrt(0.25 + 2.25);
    assert_vec3(points[0].normal, -1.5 / length, 0, 0.5 / length, 4 * PRT__EPS);
}

static void given_normals_are_kept_bad_ones_replaced(void **state) {
    prt_mesh m = cube_mesh(1, 0);
    prt_mesh_report report;
    prt_point points[8];
    prt_vec3 normals[8];
    double d = 1 / sqrt(3);
    int k;
    (void)state;
    for (k = 0; k < 8; k++) normals[k] = vec3(0, 3, 4);
    normals[1] = vec3(0, 0, 0);
    normals[2] = vec3(NAN, 0, 1);
    normals[3] = vec3(0, INFINITY, 0);
    normals[4] = vec3(0, 0, 1e-35);
    normals[5] = vec3(0, -3e38, 0);
    m.normals = normals;
    assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_OK);
    assert_vec3(points[0].normal, 0, 0.6, 0.8, 2 * PRT__EPS);
    assert_vec3(points[1].normal, d, -d, -d, 4 * PRT__EPS);
    assert_vec3(points[2].normal, -d, d, -d, 4 * PRT__EPS);
    assert_vec3(points[3].normal, d, d, -d, 4 * PRT__EPS);
    assert_vec3(points[4].normal, 0, 0, 1, 0);
    assert_vec3(points[5].normal, 0, -1, 0, 0);
    assert_int_equal(report.recomputed, 3);
    assert_int_equal(report.without, 0);
    assert_int_equal(prt_points_check(8, points, 0, 8, NULL), PRT_OK);
}

static void degenerate_lonely_and_cancelling(void **state) {
    static const uint32_t triangles[][3] = {
        { 0, 1, 2 }, { 0, 0, 1 }, { 1, 1, 1 }, { 0, 1, 3 },            /* good, an edge twice, a point, collinear */
        { 5, 6, 7 }, { 5, 7, 6 } };                                    /* the same face from both sides */
    prt_vec3 positions[8];
    prt_mesh m;
    prt_mesh_report report;
    prt_point points[8];
    int k;
    (void)state;
    memset(&m, 0, sizeof m);
    positions[0] = vec3(0, 0, 0); positions[1] = vec3(0, 1, 0); positions[2] = vec3(0, 0, 1);
    positions[3] = vec3(0, 2, 0); positions[4] = vec3(9, 9, 9);        /* 4 is in no triangle */
    positions[5] = vec3(1, 2, 3); positions[6] = vec3(2, 2, 4); positions[7] = vec3(0, 5, 5);
    m.vertex_count = 8; m.positions = positions; m.triangle_count = 6; m.triangles = &triangles[0][0];
    for (m.area_weighted = 0; m.area_weighted < 2; m.area_weighted++) {
        assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_OK);
        assert_int_equal(report.degenerate, 3);
        assert_int_equal(report.recomputed, 8);
        assert_int_equal(report.without, 5);
        for (k = 0; k < 3; k++) assert_vec3(points[k].normal, 1, 0, 0, 0);
        for (k = 3; k < 8; k++) assert_vec3(points[k].normal, 0, 0, 1, 0);
    }
}

/* A sphere so finely cut that an area is 1e-10 of its box: the normals are radial still. */
static void small_triangles_count(void **state) {
    static const uint32_t triangles[1][3] = { { 0, 1, 2 } };
    prt_vec3 positions[5];
    prt_mesh m;
    prt_mesh_report report;
    prt_point points[5];
    (void)state;
    memset(&m, 0, sizeof m);
    positions[0] = vec3(0, 0, 0); positions[1] = vec3(1e-5, 0, 0); positions[2] = vec3(0, 1e-5, 0);
    positions[3] = vec3(-1, -1, -1); positions[4] = vec3(1, 1, 1);
    m.vertex_count = 5; m.positions = positions; m.triangle_count = 1; m.triangles = &triangles[0][0];
    for (m.area_weighted = 0; m.area_weighted < 2; m.area_weighted++) {
        assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_OK);
        assert_vec3(points[1].normal, 0, 0, 1, 0);
        assert_int_equal(report.without, 2);
    }
}

static void bad_meshes(void **state) {
    static uint32_t triangles[12][3];
    prt_mesh m = cube_mesh(1, 0), bad;
    prt_point points[8], before[8];
    prt_mesh_report report, untouched;
    (void)state;
    memset(points, 0x55, sizeof points); memcpy(before, points, sizeof points);
    memset(&report, 0x55, sizeof report); memcpy(&untouched, &report, sizeof report);
    memcpy(triangles, cube, sizeof triangles);
    assert_int_equal(prt_points_from_vertices(NULL, points, &report), PRT_ERR_NULL);
    bad = m; bad.vertex_count = -1;
    assert_int_equal(prt_points_from_vertices(&bad, points, &report), PRT_ERR_COUNT);
    bad = m; bad.triangle_count = -1;
    assert_int_equal(prt_points_from_vertices(&bad, points, &report), PRT_ERR_COUNT);
    bad = m; bad.positions = NULL;
    assert_int_equal(prt_points_from_vertices(&bad, points, &report), PRT_ERR_NULL);
    bad = m; bad.triangles = NULL;
    assert_int_equal(prt_points_from_vertices(&bad, points, &report), PRT_ERR_NULL);
    assert_int_equal(prt_points_from_vertices(&m, NULL, &report), PRT_ERR_NULL);
    bad = m; bad.triangles = &triangles[0][0];
    triangles[11][2] = 8;
    assert_int_equal(prt_points_from_vertices(&bad, points, &report), PRT_ERR_COUNT);
    triangles[11][2] = UINT32_MAX;
    assert_int_equal(prt_points_from_vertices(&bad, points, &report), PRT_ERR_COUNT);
    corners[7].y = PRT__R(NAN);
    assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_ERR_VALUE);
    corners[7].y = PRT__R(INFINITY);
    assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_ERR_VALUE);
    assert_memory_equal(points, before, sizeof points);
    assert_memory_equal(&report, &untouched, sizeof report);
    memset(&bad, 0, sizeof bad);
    assert_int_equal(prt_points_from_vertices(&bad, NULL, &report), PRT_OK);
    assert_int_equal(report.recomputed, 0);
    assert_near(report.radius, 0, 0);
}

/* The largest coordinates overflow nothing: finite unit normals come out. */
static void extreme_coordinates(void **state) {
    double most = BY_PRECISION((double)FLT_MAX, DBL_MAX);
    prt_mesh m = cube_mesh(most, 0);
    prt_mesh_report report;
    prt_point points[8];
    (void)state;
    skip_if_fast_math();
    assert_int_equal(prt_points_from_vertices(&m, points, &report), PRT_OK);
    assert_int_equal(prt_points_check(8, points, 0, 8, NULL), PRT_OK);
    assert_int_equal(report.without, 0);
}

static void check_finds_the_first_bad(void **state) {
    prt_mesh m = cube_mesh(1, 0);
    prt_point points[8];
    int bad = 77;
    (void)state;
    assert_int_equal(prt_points_from_vertices(&m, points, NULL), PRT_OK);
    assert_int_equal(prt_points_check(8, points, 0, 8, &bad), PRT_OK);
    assert_int_equal(bad, -1);
    points[5].normal = vec3(0, 0, 0); points[6].position = vec3(0, NAN, 0);
    assert_int_equal(prt_points_check(8, points, 0, 8, &bad), PRT_ERR_VALUE);
    assert_int_equal(bad, 5);
    assert_int_equal(prt_points_check(8, points, 6, 1, &bad), PRT_ERR_VALUE);
    assert_int_equal(bad, 6);
    assert_int_equal(prt_points_check(8, points, 7, 1, &bad), PRT_OK);
    points[5].normal = vec3(0, 0, 1.0009);
    assert_int_equal(prt_points_check(8, points, 0, 6, &bad), PRT_OK);
    points[5].normal = vec3(0, 0, 1.0011);
    assert_int_equal(prt_points_check(8, points, 0, 6, NULL), PRT_ERR_VALUE);
    bad = 77;
    assert_int_equal(prt_points_check(8, points, 7, 2, &bad), PRT_ERR_COUNT);
    assert_int_equal(prt_points_check(-1, points, 0, 0, &bad), PRT_ERR_COUNT);
    assert_int_equal(prt_points_check(8, NULL, 0, 1, &bad), PRT_ERR_NULL);
    assert_int_equal(bad, 77);
    assert_int_equal(prt_points_check(8, NULL, 0, 0, &bad), PRT_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_do_not_see_the_cut),
        cmocka_unit_test(areas_see_the_cut),
        cmocka_unit_test(both_weights_in_closed_form),
        cmocka_unit_test(given_normals_are_kept_bad_ones_replaced),
        cmocka_unit_test(degenerate_lonely_and_cancelling),
        cmocka_unit_test(small_triangles_count),
        cmocka_unit_test(bad_meshes),
        cmocka_unit_test(extreme_coordinates),
        cmocka_unit_test(check_finds_the_first_bad),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
