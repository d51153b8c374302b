/* At the ends of what numbers can hold: directions beside the poles, tiny and huge radiance, a million rotations, bakes
   of one ray and of a million, lights around the receiver, scenes of any size and place. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "geometry.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
#define TINY BY_PRECISION(1e-30, 1e-200)               /* halves of it, squared in double, are no subnormal numbers */

/* Beside the pole Y(l,0) = +-sqrt((2l+1)/4pi) and Y(l,+-1) is linear in the tilt: right to the last digits, relatively,
   however small the tilt. All others vanish with its square. */
static void beside_the_poles(void **state) {
    static const double tilts[] = { 0, 1e-6, 1e-12, 1e-20, 1e-30, 1e-37 };
    static prt_real y[64 * 64];
    static const int bands[] = { 3, 6, 10, 13, 64 };
    int b, t, pole, l, m;
    (void)state;
    for (b = 0; b < 5; b++)
        for (t = 0; t < 6; t++)
            for (pole = -1; pole <= 1; pole += 2) {
                prt_vec3 d = vec3(0.6 * tilts[t], -0.8 * tilts[t], pole);
                assert_int_equal(prt_sh_eval(bands[b], d, y), PRT_OK);
                for (l = 0; l < bands[b]; l++) {
                    double sign = pole < 0 && l % 2 ? -1 : 1, next = pole < 0 && l % 2 == 0 ? -1 : 1;
                    double slope = next * sqrt((2 * l + 1) * l * (l + 1.0) / (8 * pi)), tolerance = (4 * l + 4) * EPS;
                    double mean = sqrt((2 * l + 1) / (4 * pi)), square = tilts[t] * tilts[t];
                    double curved = l * (l + 1.0) * square;
                    assert_near(y[PRT_SH_INDEX(l, 0)], sign * mean, mean * (tolerance + curved));
                    if (l > 0) {
                        double cosine = slope * (double)d.x, sine = slope * (double)d.y;
                        assert_near(y[PRT_SH_INDEX(l, 1)], cosine, fabs(cosine) * (tolerance + curved));
                        assert_near(y[PRT_SH_INDEX(l, -1)], sine, fabs(sine) * (tolerance + curved));
                    }
                    for (m = 2; m <= l; m++) {
                        double most = pow(l + 1.0, 4.5) * square;
                        assert_at_most(fabs((double)y[PRT_SH_INDEX(l, m)]), most);
                        assert_at_most(fabs((double)y[PRT_SH_INDEX(l, -m)]), most);
                    }
                }
            }
}

/* Everything linear in radiance stays so, 1e-36 to 1e36: relative to the result at radiance 1. */
static void tinsineand_huge_radiance(void **state) {
    enum { N = 6, COUNT = N * N, W = 32, H = 16 };
    static float map[3 * W * H], scaled[3 * W * H];
    static prt_real one[6][3 * COUNT], other[6][3 * COUNT], f[COUNT];
    prt_real zonal[N], r[9] = { 0, -1, 0, 0, 0, -1, 1, 0, 0 };
#ifdef __FAST_MATH__                                   /* what is subnormal may count as 0 there */
    static const double powers[] = { 1e-25, 1e-30, 1e30, 1e36 };
#else
    static const double powers[] = { 1e-30, 1e-36, 1e30, 1e36 };
#endif
    int p, i, k;
    (void)state;
    for (i = 0; i < 3 * W * H; i++) map[i] = (float)uniform();
    for (i = 0; i < N; i++) zonal[i] = (prt_real)(1.0 / (1 + i));
    for (p = -1; p < 4; p++) {
        double scale = p < 0 ? 1 : powers[p];
        prt_real (*out)[3 * COUNT] = p < 0 ? one : other;
        for (i = 0; i < 3 * W * H; i++) scaled[i] = (float)((double)map[i] * scale);
        assert_int_equal(prt_sh_project_equirect_rgb(N, W, H, scaled, out[0]), PRT_OK);
        for (i = 0; i < COUNT; i++) f[i] = (prt_real)((double)one[0][i] * scale);
        assert_int_equal(prt_sh_rotate(N, r, f, out[1]), PRT_OK);
        assert_int_equal(prt_sh_convolve(N, f, zonal, out[2]), PRT_OK);
        assert_int_equal(prt_sh_irradiance(N, f, out[3]), PRT_OK);
        assert_int_equal(prt_sh_window(N, PRT_WINDOW_HANN, N, f, out[4]), PRT_OK);
        assert_int_equal(prt_sh_product(N, f, one[0], out[5]), PRT_OK);
        for (k = 0; k < 6 && p >= 0; k++) {
            double size = 0;
            for (i = 0; i < COUNT; i++) size += fabs((double)one[k][i]);
            for (i = 0; i < COUNT; i++)
                assert_near((double)other[k][i] / scale, one[k][i], 8 * (double)FLT_EPSILON * size);
        }
    }
}

/* A million times the same turn: what its five factors (three phasors, two constant matrices) lack to be orthogonal after
   rounding, an eps each or less, goes the same way every time, so the norm of a band drifts in proportion. (Scaling each
   band back to its norm now and then costs 2 n^2 operations.) */
static void a_million_rotations(void **state) {
    enum { N = 5, COUNT = N * N, TURNS = 1000000 };
    prt_real f[COUNT], r[9], q[4] = { PRT__R(0.5), PRT__R(0.1), PRT__R(-0.7), PRT__R(0.3) };
    double before[N];
    int i, l, turn;
    (void)state;
    for (i = 0; i < COUNT; i++) f[i] = (prt_real)signed_uniform();
    for (l = 0; l < N; l++) before[l] = sqrt((double)prt_sh_dot(l + 1, f, f) - (l ? (double)prt_sh_dot(l, f, f) : 0));
    assert_int_equal(prt_rotation_from_quaternion(q, r), PRT_OK);
    for (turn = 0; turn < TURNS; turn++) prt_sh_rotate(N, r, f, f);
    for (l = 0; l < N; l++) {
        double after = sqrt((double)prt_sh_dot(l + 1, f, f) - (l ? (double)prt_sh_dot(l, f, f) : 0));
        assert_near(after / before[l], 1, 5 * EPS * TURNS);
    }
}

/* ---- bakes ---- */

/* a wall x > 0: half of the sky of a point at the origin that faces up */
static int wall(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    int k;
    (void)user;
    for (k = 0; k < count; k++) blocked[k] = rays[k].dir.x > 0;
    return 0;
}
static void one_rasineand_a_million(void **state) {
    static const int rays[] = { 1, 2, 3, 1000000 };
    prt_tracer tracer = { NULL, wall, NULL };
    prt_point point;
    prt_bake_desc desc;
    prt_real t[9];
    int k, i;
    (void)state;
    point.position = vec3(0, 0, 0);
    point.normal = vec3(0, 0, 1);
    memset(&desc, 0, sizeof desc);
    desc.bands = 3;
    desc.tracer = &tracer;
    for (k = 0; k < 4; k++) {
        desc.samples = rays[k];
        assert_int_equal(prt_bake_transfer(&desc, 1, &point, 0, 1, t), PRT_OK);
        for (i = 0; i < 9; i++) assert_at_most(fabs((double)t[i]), sqrt(5 / (4 * pi)) * (1 + 4 * EPS));
    }
    /* a million: half of the sky; (1/pi) int over x < 0 of cos Y(1,1) = -sqrt(3/4pi) 2/(3 pi) */
    assert_near(t[0], 0.5 * sqrt(1 / (4 * pi)), 2e-6);
    assert_near(t[PRT_SH_INDEX(1, 0)], 0.5 * sqrt(3 / (4 * pi)) * 2 / 3, 2e-6);
    assert_near(t[PRT_SH_INDEX(1, -1)], 0, 2e-6);
    assert_near(t[PRT_SH_INDEX(1, 1)], -sqrt(3 / (4 * pi)) * 2 / (3 * pi), 2e-6);
}

/* A ball over a plane of any size, far from the origin or not: the bits of the geometry are scaled by powers of two, so the
   transfer must not change by more than the bias moves it. */
typedef struct ball { double x, y, z, radius; } ball;
static int ball_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    const ball *b = (const ball *)user;
    int k;
    for (k = 0; k < count; k++) {
        double ox = b->x - (double)rays[k].origin.x, oy = b->y - (double)rays[k].origin.y;
        double oz = b->z - (double)rays[k].origin.z;
        double along = ox * (double)rays[k].dir.x + oy * (double)rays[k].dir.y + oz * (double)rays[k].dir.z;
        blocked[k] = along > 0 && ox * ox + oy * oy + oz * oz - along * along < b->radius * b->radius;
    }
    return 0;
}
static void scenes_of_ansinesize(void **state) {
    static const double sizes[] = { 1, 9.5367431640625e-7, 1048576 };       /* 1, 2^-20, 2^20 */
    prt_real first[25], t[25];
    int k, i, away;
    (void)state;
    for (k = 0; k < 3; k++)
        for (away = 0; away < 2; away++) {
            double s = sizes[k], shift = away ? 64 * s : 0;
            ball b = { 0.25, -0.5, 2, 0.75 };
            prt_tracer tracer = { NULL, ball_occluded, NULL };
            prt_point point;
            prt_bake_desc desc;
            b.x = b.x * s + shift; b.y = b.y * s + shift; b.z *= s; b.radius *= s;
            tracer.user = &b;
            point.position = vec3(shift, shift, 0);
            point.normal = vec3(0, 0, 1);
            memset(&desc, 0, sizeof desc);
            desc.samples = 4096;
            desc.scene_radius = (prt_real)(2 * s);
            desc.tracer = &tracer;
            assert_int_equal(prt_bake_transfer(&desc, 1, &point, 0, 1, t), PRT_OK);
            if (k == 0 && !away) memcpy(first, t, sizeof first);
            for (i = 0; i < 25; i++) assert_near(t[i], first[i], 3.0 / 4096);  /* three rays on the rim */
        }
}

/* Normals of a scene far from the origin are as good as its coordinates: eps times distance over size. */
static void meshes_far_away(void **state) {
    static const uint32_t faces[12] = { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 };
    static const double at[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, sizes[] = { 1e-6, 1, 1e6 };
    prt_vec3 positions[4];
    prt_point points[4];
    prt_mesh mesh;
    int k, far, i;
    (void)state;
    memset(&mesh, 0, sizeof mesh);
    mesh.vertex_count = 4;
    mesh.positions = positions;
    mesh.triangle_count = 4;
    mesh.triangles = faces;
    for (k = 0; k < 3; k++)
        for (far = 0; far < 2; far++) {
            double shift = far ? 1000 * sizes[k] : 0, third = -1 / sqrt(3.0);
            for (i = 0; i < 4; i++) {
                const double *v = at[i], s = sizes[k];
                positions[i] = vec3(v[0] * s + shift, v[1] * s + shift, v[2] * s + shift);
            }
            assert_int_equal(prt_points_from_vertices(&mesh, points, NULL), PRT_OK);
            assert_near(points[0].normal.x, third, (far ? 4000 : 8) * EPS);
            assert_near(points[0].normal.y, third, (far ? 4000 : 8) * EPS);
            assert_near(points[0].normal.z, third, (far ? 4000 : 8) * EPS);
        }
}

/* A receiver in a sphere, on its surface, or at its centre sees nothing else; one that touches it, half. */
static void lights_around_the_receiver(void **state) {
    prt_real f[16];
    double whole = sqrt(4 * pi);
    int i;
    (void)state;
    assert_int_equal(prt_sh_sphere(4, vec3(0, 0, 0), 1, f), PRT_OK);
    assert_near(f[0], whole, 4 * EPS);
    for (i = 1; i < 16; i++) assert_near(f[i], 0, 0);
    assert_int_equal(prt_sh_sphere(4, vec3(0, 0.5, 0), 1, f), PRT_OK);
    assert_near(f[0], whole, 4 * EPS);
    assert_int_equal(prt_sh_sphere(4, vec3(0, 1.0001, 0), 1, f), PRT_OK);
    assert_near(f[0], whole / 2, 0.02 * whole);
    assert_int_equal(prt_sh_sphere(4, vec3(0, BY_PRECISION(1e30, 1e200), 0), 1, f), PRT_OK);
    for (i = 0; i < 16; i++) assert_near(f[i], 0, EPS);
    assert_int_equal(prt_sh_sphere(4, vec3(0, TINY, 0), (prt_real)(TINY / 2), f), PRT_OK);
    assert_near(f[0], whole / 2 * (1 - sqrt(0.75)), 8 * EPS);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(beside_the_poles),
        cmocka_unit_test(tinsineand_huge_radiance),
        cmocka_unit_test(a_million_rotations),
        cmocka_unit_test(one_rasineand_a_million),
        cmocka_unit_test(scenes_of_ansinesize),
        cmocka_unit_test(meshes_far_away),
        cmocka_unit_test(lights_around_the_receiver),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
