/* The meshes of the examples: turned, fitted, cut finer, put on a floor, hashed. The file reader is replaced by a
   tetrahedron. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "../examples/common/replacement.c"
#include "../examples/common/transfer_file.c"
#include "../examples/common/mesh.c"
#include "../examples/common/why.c"

static const prt_vec3 corners[4] = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 } };
static const uint32_t faces[12] = { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };
static prt_real first_coordinate;

int raw_mesh_import(const char *path, raw_mesh *m, why *w) {
    (void)path; (void)w;
    memset(m, 0, sizeof *m);
    m->vertex_count = m->triangle_count = 4;
    m->positions = (prt_vec3 *)malloc(sizeof corners);
    m->normals = (prt_vec3 *)calloc(4, sizeof *m->normals);
    m->triangles = (uint32_t *)malloc(sizeof faces);
    memcpy(m->positions, corners, sizeof corners);
    memcpy(m->triangles, faces, sizeof faces);
    m->positions[0].x = first_coordinate;
    return 0;
}

void raw_mesh_free(raw_mesh *m) {
    free(m->positions);
    free(m->normals);
    free(m->triangles);
}

static int load(void **state) {
    static mesh m;
    why w;
    first_coordinate = 0;
    *state = &m;
    return mesh_load("tetrahedron", MESH_Z_UP, &m, &w);
}
static int drop(void **state) { mesh_free((mesh *)*state); return 0; }

static double area(const mesh *m) {
    double sum = 0;
    int i;
    for (i = 0; i < m->triangle_count; i++) {
        const prt_vec3 *a = &m->points[m->triangles[3 * i]].position, *b = &m->points[m->triangles[3 * i + 1]].position,
                       *c = &m->points[m->triangles[3 * i + 2]].position;
        double ux = (double)b->x - (double)a->x, uy = (double)b->y - (double)a->y, uz = (double)b->z - (double)a->z;
        double vx = (double)c->x - (double)a->x, vy = (double)c->y - (double)a->y, vz = (double)c->z - (double)a->z;
        double x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
        sum += 0.5 * sqrt(x * x + y * y + z * z);
    }
    return sum;
}

static void assert_points_are_bakeable(const mesh *m) {
    int i;
    assert_int_equal(prt_points_check(m->point_count, m->points, 0, m->point_count, NULL), PRT_OK);
    for (i = 0; i < 3 * m->triangle_count; i++) assert_true(m->triangles[i] < (uint32_t)m->point_count);
}

static void files_are_taken_as_y_up(void **state) {
    mesh turned;
    why w;
    (void)state;
    assert_int_equal(mesh_load("tetrahedron", MESH_Y_UP, &turned, &w), 0);
    assert_near(turned.points[2].position.z, 4, 0);          /* +y became +z */
    assert_near(turned.points[3].position.y, -4, 0);         /* +z became -y */
    assert_int_equal(turned.report.recomputed, 4);
    assert_points_are_bakeable(&turned);
    mesh_free(&turned);
}

static void positions_must_be_finite(void **state) {
    mesh m;
    why w;
    (void)state;
    first_coordinate = (prt_real)NAN;
    assert_int_equal(mesh_load("tetrahedron", MESH_Z_UP, &m, &w), -1);
    assert_non_null(strstr(w.line, "not finite"));
    assert_null(m.points);
}

static void fits_the_unit_sphere(void **state) {
    mesh *m = (mesh *)*state;
    double most = 0;
    why w;
    int i;
    assert_int_equal(mesh_fit_unit_sphere(m, &w), 0);
    for (i = 0; i < 4; i++) {
        const prt_vec3 *p = &m->points[i].position;
        double r = sqrt((double)p->x * (double)p->x + (double)p->y * (double)p->y + (double)p->z * (double)p->z);
        if (r > most) most = r;
    }
    assert_near(most, 1, 1e-6);
}

/* A closed surface of Euler characteristic 2 keeps it: V = 4 + 6, F = 16; the area stays. */
static void subdivision_keeps_the_surface(void **state) {
    mesh *m = (mesh *)*state;
    double before = area(m);
    why w;
    assert_near(before, 3 * 8 + 8 * sqrt(3.0), 1e-5);
    assert_int_equal(mesh_cut_edges(m, NULL, NULL, NULL, &w), 0);
    assert_int_equal(m->point_count, 10);
    assert_int_equal(m->triangle_count, 16);
    assert_near(area(m), before, 1e-5);
    assert_points_are_bakeable(m);
    assert_int_equal(mesh_cut_edges(m, NULL, NULL, NULL, &w), 0);
    assert_int_equal(m->point_count, 10 + 24);               /* one for each edge: E = V + F - 2 */
    assert_near(area(m), before, 1e-5);
}

/* Every choice among the three edges of one triangle: its area stays, and where both its neighbours across an edge see
   the cut, no edge but the outline belongs to one triangle alone. */
static int chosen(void *user, uint32_t a, uint32_t b) {
    const int *choice = (const int *)user;
    return *choice >> (a + b - 1) & 1;                       /* of corners 0, 1, 2: sums 1, 2, 3 name the edges */
}

static int edges_of_one_triangle(const mesh *m) {
    int i, k, count = 0;
    for (i = 0; i < 3 * m->triangle_count; i++) {
        uint32_t a = m->triangles[i], b = m->triangles[i % 3 == 2 ? i - 2 : i + 1];
        int others = 0;
        for (k = 0; k < 3 * m->triangle_count; k++) {
            uint32_t c = m->triangles[k], d = m->triangles[k % 3 == 2 ? k - 2 : k + 1];
            others += k != i && ((a == c && b == d) || (a == d && b == c));
        }
        count += others == 0;
    }
    return count;
}

static void every_choice_of_edges_is_cut(void **state) {
    int choice;
    (void)state;
    for (choice = 0; choice < 8; choice++) {
        int cuts = (choice & 1) + (choice >> 1 & 1) + (choice >> 2), i;
        uint32_t *ends = NULL;
        mesh m;
        why w;
        first_coordinate = 0;
        assert_int_equal(mesh_load("tetrahedron", MESH_Z_UP, &m, &w), 0);
        m.triangle_count = 1;                                /* 0 2 1 alone, of area 8 */
        assert_int_equal(mesh_cut_edges(&m, chosen, &choice, &ends, &w), 0);
        assert_int_equal(m.triangle_count, 1 + cuts);
        assert_int_equal(m.point_count, 4 + cuts);
        assert_near(area(&m), 8, 1e-6);
        assert_int_equal(edges_of_one_triangle(&m), 3 + cuts);
        for (i = 0; i < cuts; i++) {
            const prt_vec3 *a = &m.points[ends[2 * i]].position, *b = &m.points[ends[2 * i + 1]].position;
            assert_true(chosen(&choice, ends[2 * i], ends[2 * i + 1]));
            assert_near(m.points[4 + i].position.x, (a->x + b->x) / 2, 0);
            assert_near(m.points[4 + i].position.y, (a->y + b->y) / 2, 0);
        }
        assert_points_are_bakeable(&m);
        free(ends);
        mesh_free(&m);
    }
}

/* Across a closed surface neighbours agree about the edge between them, so that cutting some leaves it closed. */
static int an_odd_end(void *user, uint32_t a, uint32_t b) { (void)user; return (a ^ b) & 1; }

static void neighbours_are_cut_alike(void **state) {
    mesh *m = (mesh *)*state;
    double before = area(m);
    why w;
    int k;
    for (k = 0; k < 3; k++) {
        assert_int_equal(mesh_cut_edges(m, an_odd_end, NULL, NULL, &w), 0);
        assert_int_equal(edges_of_one_triangle(m), 0);
        assert_int_equal(m->triangle_count, 2 * m->point_count - 4);     /* Euler: a sphere still */
        assert_near(area(m), before, 1e-5);
        assert_points_are_bakeable(m);
    }
}

/* Five rings: the area of a regular polygon of 30 corners, and every point at its height. */
static void the_floor_is_a_disc(void **state) {
    const prt_vec3 centre = { 1, 2, -3 };
    mesh *m = (mesh *)*state;
    double before = area(m), pi = 3.14159265358979323846;
    why w;
    int i;
    assert_int_equal(mesh_add_floor(m, centre, 2, (prt_real)0.4, &w), 0);
    assert_int_equal(m->point_count, 4 + 1 + 6 * 15);
    assert_int_equal(m->triangle_count, 4 + 6 * 25);
    assert_near(area(m) - before, 0.5 * 30 * 4 * sin(2 * pi / 30), 1e-4);
    for (i = 4; i < m->point_count; i++) assert_near(m->points[i].position.z, -3, 0);
    assert_points_are_bakeable(m);
}

static void the_hash_sees_every_part(void **state) {
    mesh *m = (mesh *)*state;
    uint64_t hash = mesh_hash(m);
    assert_true(hash == mesh_hash(m));
    m->points[3].position.y += 1;
    assert_true(hash != mesh_hash(m));
    m->points[3].position.y -= 1;
    m->points[0].normal.z = -m->points[0].normal.z;
    assert_true(hash != mesh_hash(m));
    m->points[0].normal.z = -m->points[0].normal.z;
    m->triangles[11] = 0;
    assert_true(hash != mesh_hash(m));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(files_are_taken_as_y_up, load, drop),
        cmocka_unit_test(positions_must_be_finite),
        cmocka_unit_test_setup_teardown(fits_the_unit_sphere, load, drop),
        cmocka_unit_test_setup_teardown(subdivision_keeps_the_surface, load, drop),
        cmocka_unit_test(every_choice_of_edges_is_cut),
        cmocka_unit_test_setup_teardown(neighbours_are_cut_alike, load, drop),
        cmocka_unit_test_setup_teardown(the_floor_is_a_disc, load, drop),
        cmocka_unit_test_setup_teardown(the_hash_sees_every_part, load, drop)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
