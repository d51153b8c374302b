/* Projection against other routes: textbook K P_l^m in long double, Gauss-Legendre quadrature of the defining
   integrals, brute-force sums over texels. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"
#include <limits.h>

#define PI_L 3.14159265358979323846264338327950288L
enum { MOST = 64, COUNT = MOST * MOST };

/* Y(l,m), the textbook way: factorials and P_l^m from its own recurrence, trigonometric in phi. */
static long double slow_y(int l, int m, long double theta, long double phi) {
    int order = m < 0 ? -m : m, k;
    long double z = cosl(theta), sine = sinl(theta), p = 1, p1 = 0, norm = (2 * l + 1) / (4 * PI_L);
    for (k = 1; k <= order; k++) p *= (2 * k - 1) * sine;
    for (k = order + 1; k <= l; k++) {
        long double p2 = p1;
        p1 = p;
        p = ((2 * k - 1) * z * p1 - (k + order - 1) * p2) / (k - order);
    }
    for (k = l - order + 1; k <= l + order; k++) norm /= k;
    p *= sqrtl(norm);
    return m == 0 ? p : sqrtl(2) * p * (m > 0 ? cosl(order * phi) : sinl(order * phi));
}

static long double slow_legendre(int l, long double z) {
    long double p = 1, p1 = 0;
    int k;
    for (k = 1; k <= l; k++) { long double p2 = p1; p1 = p; p = ((2 * k - 1) * z * p1 - (k - 1) * p2) / k; }
    return p;
}

/* Nodes and weights of Gauss-Legendre quadrature on 0 ... 1. */
static void gauss(int n, long double *x, long double *w) {
    int i, step;
    for (i = 0; i < n; i++) {
        long double z = cosl(PI_L * (i + 0.75L) / (n + 0.5L)), slope = 1;
        for (step = 0; step < 12; step++) {
            slope = n * (slow_legendre(n - 1, z) - z * slow_legendre(n, z)) / (1 - z * z);
            z -= slow_legendre(n, z) / slope;
        }
        x[i] = (1 - z) / 2;
        w[i] = 1 / ((1 - z * z) * slope * slope);
    }
}

/* 2 pi int_{1-h}^1 F P_l dz by quadrature that is exact for polynomial F of degree <= 1 and l <= 64. */
static long double slow_factor(int l, long double h, int cosine) {
    static long double x[48], w[48];
    long double sum = 0;
    int i;
    if (x[0] == 0) gauss(48, x, w);
    for (i = 0; i < 48; i++) sum += w[i] * (cosine ? 1 - h * x[i] : 1) * slow_legendre(l, 1 - h * x[i]);
    return 2 * PI_L * h * sum;
}

static prt_vec3 direction(double x, double y, double z) {
    double r = sqrt(x * x + y * y + z * z);
    prt_vec3 v;
    v.x = (prt_real)(x / r); v.y = (prt_real)(y / r); v.z = (prt_real)(z / r);
    return v;
}

/* Factors times Y(axis). The lights normalise their axis once more: an ulp of it moves Y by its slope, about
   l sqrt(2l+1)/2 ulp. */
static void check_zonal(const prt_real *f, int bands, prt_vec3 axis, long double (*factor)(int, long double),
                        long double arg, double scale) {
    prt_real y[COUNT];
    int l, m;
    assert_int_equal(prt_sh_eval(bands, axis, y), PRT_OK);
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) {
            long double want = factor(l, arg) * (long double)y[PRT_SH_INDEX(l, m)];
            assert_near(f[PRT_SH_INDEX(l, m)], want, (4 + l * sqrt(2 * l + 1)) * (double)PRT__EPS * scale);
        }
}

static long double cap_factor(int l, long double angle) {
    long double s = sinl(angle / 2);
    return slow_factor(l, 2 * s * s, 0);
}
static long double cosine_factor(int l, long double unused) { (void)unused; return slow_factor(l, 1, 1); }
static long double delta_factor(int l, long double unused) { (void)l; (void)unused; return 1; }

static void delta_is_the_basis(void **state) {
    prt_vec3 d = direction(0.3, -0.5, 0.7), longer = d;
    prt_real f[COUNT], y[COUNT];
    int i;
    (void)state;
    assert_int_equal(prt_sh_delta(MOST, d, f), PRT_OK);
    check_zonal(f, 8, d, delta_factor, 0, 20);
    longer.x *= PRT__R(1.0009); longer.y *= PRT__R(1.0009); longer.z *= PRT__R(1.0009);
    assert_int_equal(prt_sh_delta(8, longer, f), PRT_OK);
    assert_int_equal(prt_sh_eval(8, d, y), PRT_OK);
    for (i = 0; i < 64; i++) assert_near(f[i], y[i], 100 * PRT__EPS);
}

static void delta_gives_irradiance_one_head_on(void **state) {
    prt_vec3 d = direction(1, 2, -2);
    prt_real f[COUNT], e[COUNT], lobe[COUNT];
    (void)state;
    assert_int_equal(prt_sh_delta(MOST, d, f), PRT_OK);
    assert_int_equal(prt_sh_cosine_lobe(MOST, d, lobe), PRT_OK);
    assert_int_equal(prt_sh_irradiance(MOST, f, e), PRT_OK);
    assert_near(prt_sh_dot(MOST, f, lobe), 1, 1.5e-3);          /* the series of the lobe, cut at 64 bands */
    assert_near(prt_sh_at(MOST, e, d), prt_sh_dot(MOST, f, lobe), 200 * PRT__EPS);
}

/* The factors themselves, in double, relative to the largest: the accuracy that the header promises. */
static void cap_factors_keep_every_digit(void **state) {
    const double angles[] = { 1e-12, 1e-6, 1e-3, 0.0046251225, 0.05, 0.3, 0.785, 1.2, 1.57, 1.5707963267948966 };
    double factor[MOST], worst = 0;
    size_t a;
    int l;
    (void)state;
    for (a = 0; a < sizeof angles / sizeof *angles; a++) {
        double s = sin(angles[a]), half = sin(angles[a] / 2);
        prt__cap_factors(MOST, s * s, 2 * half * half, 0, factor);
        for (l = 0; l < MOST; l++) {
            double error = fabs(factor[l] - (double)cap_factor(l, angles[a])) / (PRT__PI * s * s);
            if (!(error <= worst)) worst = error;
        }
    }
    print_message("cap factors: largest error %.2g of pi sin^2\n", worst);
    assert_at_most(worst, 1e-15);
}

static void cones_of_every_angle(void **state) {
    const double angles[] = { 1e-6, 0.00471238898, 0.01, 0.5, 1.0, 1.5707963267948966, 1.7, 2.5, 3.0, 3.14 };
    prt_vec3 axis = direction(-0.2, 0.6, 0.4);
    prt_real f[COUNT];
    size_t a;
    int i;
    (void)state;
    for (a = 0; a < sizeof angles / sizeof *angles; a++) {
        prt_real angle = (prt_real)angles[a];
        long double s = sinl((long double)angle), scale = angle < 1.5 ? 4 * s * s : 4 * PI_L;
        assert_int_equal(prt_sh_cone(MOST, axis, angle, f), PRT_OK);
        check_zonal(f, MOST, axis, cap_factor, (long double)angle, (double)scale);
    }
    assert_int_equal(prt_sh_cone(MOST, axis, 0, f), PRT_OK);
    for (i = 0; i < COUNT; i++) assert_near(f[i], 0, 0);
    assert_int_equal(prt_sh_cone(MOST, axis, (prt_real)PRT__PI, f), PRT_OK);
    assert_near(f[0], 2 * sqrt(PRT__PI), 4 * PRT__EPS);
    for (i = 1; i < COUNT; i++) assert_near(f[i], 0, 0);
}

/* A small hole, looked at as 4 pi less a small cap, keeps its digits too. */
static void wide_cones_complement_narrow_ones(void **state) {
    prt_vec3 axis = direction(0, 0, 1);
    prt_real wide[COUNT], narrow[COUNT], angle = PRT__R(3.125), rest = (prt_real)(PRT__PI - (double)PRT__R(3.125));
    int l;
    (void)state;
    assert_int_equal(prt_sh_cone(MOST, axis, angle, wide), PRT_OK);
    assert_int_equal(prt_sh_cone(MOST, axis, rest, narrow), PRT_OK);
    for (l = 1; l < MOST; l++) {
        double want = (l & 1 ? 1 : -1) * (double)narrow[PRT_SH_INDEX(l, 0)];
        assert_near(wide[PRT_SH_INDEX(l, 0)], want, 16 * (double)PRT__EPS * sqrt(l) * fabs((double)narrow[2]));
    }
}

static void spheres_are_cones(void **state) {
    const double ratios[] = { 1e-9, 1e-4, 0.3, 0.7071, 0.99, 0.9999, 1 };
    prt_vec3 to;
    prt_real f[COUNT];
    size_t a;
    int i;
    (void)state;
    for (a = 0; a < sizeof ratios / sizeof *ratios; a++) {
        prt_real radius = (prt_real)(3 * ratios[a]);
        long double s = (long double)radius / 3;
        to.x = 2; to.y = -1; to.z = 2;                              /* length 3, exactly */
        assert_int_equal(prt_sh_sphere(MOST, to, radius, f), PRT_OK);
        check_zonal(f, 16, direction(2, -1, 2), cap_factor, asinl(s), (double)(40 * s * s));
    }
    to.x = 0; to.y = 0; to.z = PRT__R(1.0) + PRT__EPS;                /* barely outside: cos = sqrt(2 eps) */
    assert_int_equal(prt_sh_sphere(2, to, 1, f), PRT_OK);
    assert_near(f[0], sqrt(PRT__PI) * (1 - sqrt(2 * (double)PRT__EPS)), 4 * PRT__EPS);
    to.z = PRT__R(1.0) - PRT__EPS;                                    /* barely inside: everything */
    assert_int_equal(prt_sh_sphere(MOST, to, 1, f), PRT_OK);
    assert_near(f[0], 2 * sqrt(PRT__PI), 4 * PRT__EPS);
    for (i = 1; i < COUNT; i++) assert_near(f[i], 0, 0);
    to.z = 0;                                                         /* at the centre; a point at the viewer */
    assert_int_equal(prt_sh_sphere(4, to, 5, f), PRT_OK);
    assert_near(f[0], 2 * sqrt(PRT__PI), 4 * PRT__EPS);
    assert_int_equal(prt_sh_sphere(4, to, 0, f), PRT_OK);
    for (i = 0; i < 16; i++) assert_near(f[i], 0, 0);
    to.x = PRT__REAL_MAX; to.y = PRT__REAL_MAX; to.z = PRT__REAL_MAX; /* no overflow on the way */
    assert_int_equal(prt_sh_sphere(4, to, PRT__REAL_MAX, f), PRT_OK);
    assert_near(f[0], sqrt(PRT__PI) * (1 - sqrt(2.0 / 3)), 8 * PRT__EPS);
}

static void cosine_lobe_of_every_band(void **state) {
    const double known[] = { 1, 2.0 / 3, 0.25, 0, -1.0 / 24, 0, 1.0 / 64 };
    prt_vec3 axis = direction(0.1, 0.9, -0.4);
    prt_real f[COUNT], one[COUNT];
    int l, i;
    (void)state;
    assert_int_equal(prt_sh_cosine_lobe(MOST, axis, f), PRT_OK);
    check_zonal(f, MOST, axis, cosine_factor, 0, 1);
    for (i = 0; i < COUNT; i++) one[i] = 1;
    assert_int_equal(prt_sh_irradiance(7, one, one), PRT_OK);         /* in place */
    for (l = 0; l < 7; l++)
        for (i = l * l; i < (l + 1) * (l + 1); i++) assert_near(one[i], PRT__PI * known[l], 4 * PRT__EPS);
}

static void hemisphere_is_two_caps(void **state) {
    prt_vec3 up = direction(1, -2, 3), down = direction(-1, 2, -3);
    prt_real f[COUNT], above[COUNT], below[COUNT];
    int i, l;
    (void)state;
    assert_int_equal(prt_sh_hemisphere(MOST, up, PRT__R(3.0), PRT__R(-0.5), f), PRT_OK);
    assert_int_equal(prt_sh_cone(MOST, up, (prt_real)(PRT__PI / 2), above), PRT_OK);
    assert_int_equal(prt_sh_cone(MOST, down, (prt_real)(PRT__PI / 2), below), PRT_OK);
    for (i = 0; i < COUNT; i++) assert_near(f[i], 3 * (double)above[i] - 0.5 * (double)below[i], 200 * PRT__EPS);
    for (l = 2; l < MOST; l += 2)
        for (i = l * l; i < (l + 1) * (l + 1); i++) assert_near(f[i], 0, 0);
    assert_int_equal(prt_sh_hemisphere(4, up, PRT__REAL_MAX / 16, PRT__REAL_MAX / 16, f), PRT_OK);
    assert_near(f[0] / (PRT__REAL_MAX / 16), 2 * sqrt(PRT__PI), 8 * PRT__EPS);
}

static void samples_add_up(void **state) {
    prt_real f[16] = { 0 }, y[16];
    prt_vec3 a = direction(1, 0, 0), b = direction(0, 1, 1);
    double want[16];
    int i;
    (void)state;
    prt_sh_eval(4, a, y);
    for (i = 0; i < 16; i++) want[i] = 2 * (double)y[i];
    prt_sh_eval(4, b, y);
    for (i = 0; i < 16; i++) want[i] -= 3 * (double)y[i];
    assert_int_equal(prt_sh_add_sample(4, a, 2, f), PRT_OK);
    assert_int_equal(prt_sh_add_sample(4, b, -3, f), PRT_OK);
    for (i = 0; i < 16; i++) assert_near(f[i], want[i], 4 * PRT__EPS);
}

static void convolution_multiplies_bands(void **state) {
    prt_vec3 z = direction(0, 0, 1);
    prt_real lobe[COUNT], zonal[MOST], f[COUNT], e[COUNT], c[COUNT];
    int l, i;
    (void)state;
    prt_sh_cosine_lobe(MOST, z, lobe);
    for (l = 0; l < MOST; l++) zonal[l] = lobe[PRT_SH_INDEX(l, 0)];
    prt_sh_delta(MOST, direction(1, 1, -1), f);
    assert_int_equal(prt_sh_irradiance(MOST, f, e), PRT_OK);
    assert_int_equal(prt_sh_convolve(MOST, f, zonal, c), PRT_OK);
    for (i = 0; i < COUNT; i++) assert_near(c[i], e[i], 200 * PRT__EPS);
    assert_int_equal(prt_sh_convolve(MOST, f, zonal, f), PRT_OK);     /* in place, the same bits */
    assert_memory_equal(f, c, sizeof f);
}

/* ---- environment maps ---- */

/* OpenGL 4.5, table 8.19: the major axis and the signs of sc and tc. */
static void cube_direction(int face, long double s, long double t, long double *d) {
    switch (face) {
        case 0: d[0] = 1; d[1] = -t; d[2] = -s; break;
        case 1: d[0] = -1; d[1] = -t; d[2] = s; break;
        case 2: d[0] = s; d[1] = 1; d[2] = t; break;
        case 3: d[0] = s; d[1] = -1; d[2] = -t; break;
        case 4: d[0] = s; d[1] = -t; d[2] = 1; break;
        default: d[0] = -s; d[1] = -t; d[2] = -1; break;
    }
}

static long double corner(long double x, long double y) { return atan2l(x * y, sqrtl(x * x + y * y + 1)); }

static void brute_add(int bands, long double theta, long double phi, long double weight, const float *rgb,
                      long double *sum) {
    int l, m, c;
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) {
            long double y = slow_y(l, m, theta, phi);
            for (c = 0; c < 3; c++) sum[c * bands * bands + PRT_SH_INDEX(l, m)] += weight * y * (long double)rgb[c];
        }
}

static void brute_equirect(int bands, int width, int height, const float *rgb, long double *sum) {
    int i, j;
    memset(sum, 0, (size_t)(3 * bands * bands) * sizeof *sum);
    for (j = 0; j < height; j++)
        for (i = 0; i < width; i++) {
            long double weight = 2 * PI_L / width * (cosl(PI_L * j / height) - cosl(PI_L * (j + 1) / height));
            brute_add(bands, PI_L * (j + 0.5L) / height, 2 * PI_L * (i + 0.5L) / width, weight,
                      rgb + 3 * (j * width + i), sum);
        }
}

static void brute_cubemap(int bands, int size, const float *const faces[6], long double *sum) {
    int face, i, j;
    memset(sum, 0, (size_t)(3 * bands * bands) * sizeof *sum);
    for (face = 0; face < 6; face++)
        for (j = 0; j < size; j++)
            for (i = 0; i < size; i++) {
                long double d[3], s0 = 2.0L * i / size - 1, s1 = 2.0L * (i + 1) / size - 1;
                long double t0 = 2.0L * j / size - 1, t1 = 2.0L * (j + 1) / size - 1;
                cube_direction(face, (s0 + s1) / 2, (t0 + t1) / 2, d);
                brute_add(bands, atan2l(sqrtl(d[0] * d[0] + d[1] * d[1]), d[2]), atan2l(d[1], d[0]),
                          corner(s1, t1) - corner(s0, t1) - corner(s1, t0) + corner(s0, t0),
                          faces[face] + 3 * (j * size + i), sum);
            }
}

/* Rounding in double, as the header promises it for texels in -1 ... 3 (4 pi times a mean below 1.5), and to prt_real. */
static void check_planes(int bands, const prt_real *light, const long double *sum) {
    int i;
    for (i = 0; i < 3 * bands * bands; i++)
        assert_near(light[i], sum[i], 1e-16 * pow(bands, 1.5) * 18 + (double)PRT__EPS * fabs((double)sum[i]));
}

static void equirect_is_the_sum_over_texels(void **state) {
    static const int sizes[][3] = { { 1, 1, 5 }, { 1, 2, 5 }, { 2, 1, 5 }, { 3, 2, 5 }, { 5, 3, 7 }, { 6, 4, 7 },
                                    { 7, 7, 18 }, { 8, 4, 18 }, { 130, 3, 20 }, { 131, 4, 34 }, { 260, 5, 10 },
                                    { 258, 2, 10 }, { 12, 6, 64 } };
    static float rgb[3 * 2048];
    static long double sum[3 * COUNT];
    static prt_real light[3 * COUNT];
    size_t k;
    int i;
    (void)state;
    for (k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        int width = sizes[k][0], height = sizes[k][1], bands = sizes[k][2];
        for (i = 0; i < 3 * width * height; i++) rgb[i] = 4 * (float)uniform() - 1;
        brute_equirect(bands, width, height, rgb, sum);
        assert_int_equal(prt_sh_project_equirect_rgb(bands, width, height, rgb, light), PRT_OK);
        check_planes(bands, light, sum);
    }
}

static void cubemap_is_the_sum_over_texels(void **state) {
    static const int sizes[][2] = { { 1, 6 }, { 2, 6 }, { 3, 18 }, { 4, 7 }, { 7, 9 }, { 8, 34 }, { 66, 4 },
                                    { 67, 4 }, { 3, 64 } };
    static float rgb[6][3 * 67 * 67];
    static long double sum[3 * COUNT];
    static prt_real light[3 * COUNT];
    const float *faces[6];
    size_t k;
    int i, face;
    (void)state;
    for (k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        int size = sizes[k][0], bands = sizes[k][1];
        for (face = 0; face < 6; face++) {
            faces[face] = rgb[face];
            for (i = 0; i < 3 * size * size; i++) rgb[face][i] = 4 * (float)uniform() - 1;
        }
        brute_cubemap(bands, size, faces, sum);
        assert_int_equal(prt_sh_project_cubemap_rgb(bands, size, faces, light), PRT_OK);
        check_planes(bands, light, sum);
    }
}

/* One bright texel in turn: its coefficients of band 1 point where the table of the OpenGL specification says. */
static void every_face_looks_where_opengl_says(void **state) {
    enum { SIZE = 3 };
    static float rgb[6][3 * SIZE * SIZE];
    const float *faces[6];
    int face, i, j, k;
    (void)state;
    for (face = 0; face < 6; face++) faces[face] = rgb[face];
    for (face = 0; face < 6; face++)
        for (j = 0; j < SIZE; j++)
            for (i = 0; i < SIZE; i++) {
                prt_real light[12];
                long double d[3], length;
                double got;
                float *texel = rgb[face] + 3 * (j * SIZE + i);
                texel[1] = 1;
                assert_int_equal(prt_sh_project_cubemap_rgb(2, SIZE, faces, light), PRT_OK);
                texel[1] = 0;
                cube_direction(face, (2 * i + 1) / (long double)SIZE - 1, (2 * j + 1) / (long double)SIZE - 1, d);
                length = sqrtl(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
                got = sqrt((double)(light[5] * light[5] + light[6] * light[6] + light[7] * light[7]));
                assert_near((double)light[7] / got, d[0] / length, 4 * PRT__EPS);
                assert_near((double)light[5] / got, d[1] / length, 4 * PRT__EPS);
                assert_near((double)light[6] / got, d[2] / length, 4 * PRT__EPS);
                for (k = 0; k < 4; k++) { assert_near(light[k], 0, 0); assert_near(light[8 + k], 0, 0); }
            }
}

static void first_texels_are_where_the_header_says(void **state) {
    static float map[3 * 8 * 4], cube[6][3 * 4];
    const float *faces[6];
    prt_real light[12];
    int face;
    (void)state;
    map[0] = 1;                                                       /* row 0: near +z; column 0: from +x towards +y */
    assert_int_equal(prt_sh_project_equirect_rgb(2, 8, 4, map, light), PRT_OK);
    assert_true(light[2] > light[3] && light[3] > light[1] && light[1] > 0);
    for (face = 0; face < 6; face++) faces[face] = cube[face];
    for (face = 0; face < 6; face++) {
        static const int corner_of[6][3] = { { 1, 1, 1 }, { -1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }, { -1, 1, 1 },
                                             { 1, 1, -1 } };
        double major;
        cube[face][0] = 1;
        assert_int_equal(prt_sh_project_cubemap_rgb(2, 2, faces, light), PRT_OK);
        cube[face][0] = 0;
        assert_true(light[3] * (prt_real)corner_of[face][0] > 0);
        assert_true(light[1] * (prt_real)corner_of[face][1] > 0);
        assert_true(light[2] * (prt_real)corner_of[face][2] > 0);
        major = fabs((double)light[face < 2 ? 3 : face < 4 ? 1 : 2]);
        assert_near(major / fabs((double)light[face < 2 ? 1 : 3]), 2, 8 * PRT__EPS);
    }
}

/* A map against itself with every texel split into 16 x 16: the means of Y over its texels, near enough. */
static void centres_differ_from_means_as_the_header_says(void **state) {
    enum { W = 64, H = 32, SPLIT = 16, BANDS = 8 };
    static float coarse[3 * W * H], fine[3 * W * H * SPLIT * SPLIT];
    static prt_real centre[3 * BANDS * BANDS], mean[3 * BANDS * BANDS];
    int i, j, c, l;
    (void)state;
    for (i = 0; i < 3 * W * H; i++) coarse[i] = (float)uniform() - 0.5f;
    for (j = 0; j < H * SPLIT; j++)
        for (i = 0; i < W * SPLIT; i++)
            for (c = 0; c < 3; c++)
                fine[3 * (j * W * SPLIT + i) + c] = coarse[3 * (j / SPLIT * W + i / SPLIT) + c];
    assert_int_equal(prt_sh_project_equirect_rgb(BANDS, W, H, coarse, centre), PRT_OK);
    assert_int_equal(prt_sh_project_equirect_rgb(BANDS, W * SPLIT, H * SPLIT, fine, mean), PRT_OK);
    for (l = 1; l < BANDS; l++) {
        double error = 0, norm = 0, width = PRT__PI / H;
        for (c = 0; c < 3; c++)
            for (i = c * BANDS * BANDS + l * l; i < c * BANDS * BANDS + (l + 1) * (l + 1); i++) {
                error += pow((double)(centre[i] - mean[i]), 2);
                norm += pow((double)mean[i], 2);
            }
        assert_at_most(sqrt(error / norm), 2 * l * (l + 1) * width * width / 24);
    }
}

static void constants_fill_band_zero(void **state) {
    enum { W = 256, H = 128, S = 64 };
    float *rgb = malloc(3 * W * H * sizeof *rgb);
    const float *faces[6];
    prt_real light[3 * 64];
    double pole = PRT__PI / H;
    int i, l;
    (void)state;
    assert_non_null(rgb);
    for (i = 0; i < 3 * W * H; i++) rgb[i] = 0.75f;
    for (i = 0; i < 6; i++) faces[i] = rgb;
    assert_int_equal(prt_sh_project_equirect_rgb(8, W, H, rgb, light), PRT_OK);
    assert_near(light[0] / (0.75 * 2 * sqrt(PRT__PI)), 1, BY_PRECISION(2, 10) * PRT__EPS);
    for (l = 1; l < 8; l++)
        for (i = l * l; i < (l + 1) * (l + 1); i++) {
            int leak = l % 2 == 0 && i == PRT_SH_INDEX(l, 0);           /* the two polar rows, as the header says */
            assert_near(light[i], leak ? 0.75 * 2 * sqrt(PRT__PI) * sqrt(2 * l + 1) * pole * pole / 24 : 0,
                        leak ? 2e-6 : 1e-14);
        }
    assert_int_equal(prt_sh_project_cubemap_rgb(8, S, faces, light), PRT_OK);
    assert_near(light[0] / (0.75 * 2 * sqrt(PRT__PI)), 1, BY_PRECISION(2, 10) * PRT__EPS);
    for (i = 1; i < 64; i++) assert_near(light[i], 0, 1.2e-4 * 0.75 * 2 * sqrt(PRT__PI));
    free(rgb);
}

/* A function of 5 bands sampled at texel centres comes back, and the error falls with the square of the resolution. */
static double round_trip(int cube, int size) {
    static const float colour[3] = { 1, -2, 0.5f };
    float *rgb = malloc((size_t)(6 * 3 * size * size) * sizeof *rgb);
    const float *faces[6];
    prt_real light[3 * 25], f[25];
    double worst = 0;
    int face, i, j, c;
    assert_non_null(rgb);
    random_state = 7;                                      /* the same function at every size */
    for (i = 0; i < 25; i++) f[i] = (prt_real)(uniform() - 0.5);
    for (face = 0; face < (cube ? 6 : 1); face++) {
        faces[face] = rgb + 3 * face * size * size;
        for (j = 0; j < size; j++)
            for (i = 0; i < (cube ? size : 2 * size); i++) {
                long double d[3], theta = PI_L * (j + 0.5L) / size, phi = PI_L * (i + 0.5L) / size;
                float *texel = rgb + 3 * (face * size * size + j * (cube ? size : 2 * size) + i);
                prt_real value;
                d[0] = sinl(theta) * cosl(phi); d[1] = sinl(theta) * sinl(phi); d[2] = cosl(theta);
                if (cube)
                    cube_direction(face, (2 * i + 1) / (long double)size - 1, (2 * j + 1) / (long double)size - 1, d);
                value = prt_sh_at(5, f, direction((double)d[0], (double)d[1], (double)d[2]));
                for (c = 0; c < 3; c++) texel[c] = (float)(value * (prt_real)colour[c]);
            }
    }
    if (cube) assert_int_equal(prt_sh_project_cubemap_rgb(5, size, faces, light), PRT_OK);
    else assert_int_equal(prt_sh_project_equirect_rgb(5, 2 * size, size, rgb, light), PRT_OK);
    for (c = 0; c < 3; c++)
        for (i = 0; i < 25; i++) {
            double error = fabs((double)light[25 * c + i] - (double)colour[c] * (double)f[i]);
            if (!(error <= worst)) worst = error;
        }
    free(rgb);
    return worst;
}

static void maps_converge_to_the_function(void **state) {
    int cube;
    (void)state;
    for (cube = 0; cube < 2; cube++) {
        double coarse = round_trip(cube, 32), fine = round_trip(cube, 128);
        print_message("%s: error %.3g at 32, %.3g at 128 texels\n", cube ? "cube map" : "equirect", coarse, fine);
        assert_at_most(fine, 1e-3);
        assert_at_most(fine / coarse, 1.1 / 16);
    }
}

static void solid_angles_are_exact(void **state) {
    const int sizes[] = { 1, 2, 3, 17, 500, 4095, 1000003 };
    long double x[48], w[48];
    size_t k;
    (void)state;
    gauss(40, x, w);
    for (k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        int n = sizes[k], places[4], p, q, i, j;
        places[0] = 0; places[1] = n / 2; places[2] = n - 1; places[3] = n / 3;
        for (p = 0; p < 4; p++)
            for (q = 0; q < 4; q++) {
                long double want = 0, edge = 2.0L / n, u = edge * places[p] - 1, v = edge * places[q] - 1;
                double got = prt__square_solid_angle((2.0 * places[p] + 1) / n - 1, (2.0 * places[q] + 1) / n - 1,
                                                     1.0 / n);
                for (i = 0; i < 40; i++)
                    for (j = 0; j < 40; j++) {
                        long double s = u + edge * x[i], t = v + edge * x[j];
                        want += w[i] * w[j] / powl(1 + s * s + t * t, 1.5L);
                    }
                want *= edge * edge;
                assert_near(got / (double)want, 1, 1.5e-15);
            }
    }
}

static void texels_that_are_not_finite_are_refused(void **state) {
    const float bad[] = { (float)NAN, (float)INFINITY, -(float)INFINITY };
    float map[3 * 5 * 4], cube[6][3 * 9];
    const float *faces[6];
    prt_real light[3 * 400], untouched[3 * 400];
    size_t k;
    int i, face;
    (void)state;
    skip_if_fast_math();
    for (i = 0; i < 3 * 400; i++) light[i] = untouched[i] = 42;
    for (k = 0; k < 3; k++) {
        for (i = 0; i < 60; i++) {
            memset(map, 0, sizeof map);
            map[i] = bad[k];
            assert_int_equal(prt_sh_project_equirect_rgb(20, 5, 4, map, light), PRT_ERR_VALUE);
        }
        memset(cube, 0, sizeof cube);
        for (face = 0; face < 6; face++) faces[face] = cube[face];
        for (face = 0; face < 6; face++)
            for (i = 0; i < 27; i++) {
                cube[face][i] = bad[k];
                assert_int_equal(prt_sh_project_cubemap_rgb(20, 3, faces, light), PRT_ERR_VALUE);
                cube[face][i] = 0;
            }
    }
    map[0] = (float)INFINITY; map[1] = 0; map[3] = -(float)INFINITY;
    assert_int_equal(prt_sh_project_equirect_rgb(20, 5, 4, map, light), PRT_ERR_VALUE);
    assert_memory_equal(light, untouched, sizeof light);
}

static void bad_arguments_write_nothing(void **state) {
    const prt_vec3 z = { 0, 0, 1 }, half = { 0, 0, PRT__R(0.5) }, long_z = { 0, 0, PRT__R(1.0011) }, none = { 0, 0, 0 },
                   nan = { 0, (prt_real)NAN, 1 }, inf = { 0, (prt_real)INFINITY, 1 };
    const prt_vec3 bad[5] = { half, long_z, none, nan, inf };
    prt_real f[12], same[12];
    const float rgb[12] = { 0 };
    const float *faces[6] = { rgb, rgb, rgb, rgb, rgb, rgb };
    int i;
    (void)state;
    for (i = 0; i < 12; i++) f[i] = same[i] = 42;
    for (i = 0; i < 2; i++) {
        int bands = i ? PRT_MAX_BANDS + 1 : 0;
        assert_int_equal(prt_sh_add_sample(bands, z, 1, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_delta(bands, z, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_cone(bands, z, 1, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_sphere(bands, z, 1, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_cosine_lobe(bands, z, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_hemisphere(bands, z, 1, 0, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_project_equirect_rgb(bands, 2, 2, rgb, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_project_cubemap_rgb(bands, 2, faces, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_convolve(bands, f, f, f), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_irradiance(bands, f, f), PRT_ERR_BANDS);
    }
    assert_int_equal(prt_sh_add_sample(2, z, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_delta(2, z, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_cone(2, z, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_sphere(2, z, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_cosine_lobe(2, z, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_hemisphere(2, z, 1, 0, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convolve(2, NULL, f, f), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convolve(2, f, NULL, f), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convolve(2, f, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_irradiance(2, NULL, f), PRT_ERR_NULL);
    assert_int_equal(prt_sh_irradiance(2, f, NULL), PRT_ERR_NULL);
    for (i = 0; i < 5; i++) {
        assert_int_equal(prt_sh_delta(2, bad[i], f), PRT_ERR_VALUE);
        assert_int_equal(prt_sh_cone(2, bad[i], 1, f), PRT_ERR_VALUE);
        assert_int_equal(prt_sh_cosine_lobe(2, bad[i], f), PRT_ERR_VALUE);
        assert_int_equal(prt_sh_hemisphere(2, bad[i], 1, 0, f), PRT_ERR_VALUE);
    }
    assert_int_equal(prt_sh_cone(2, z, PRT__R(-1e-6), f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_cone(2, z, PRT__R(3.1416), f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_cone(2, z, (prt_real)NAN, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_sphere(2, nan, 1, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_sphere(2, inf, 1, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_sphere(2, z, -1, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_sphere(2, z, (prt_real)NAN, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_sphere(2, z, (prt_real)INFINITY, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_hemisphere(2, z, (prt_real)NAN, 0, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_hemisphere(2, z, 0, (prt_real)INFINITY, f), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_project_equirect_rgb(2, 0, 2, rgb, f), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_project_equirect_rgb(2, 2, -1, rgb, f), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_project_equirect_rgb(2, INT_MAX, INT_MAX, rgb, f), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_project_equirect_rgb(2, 2, 2, NULL, f), PRT_ERR_NULL);
    assert_int_equal(prt_sh_project_equirect_rgb(2, 2, 2, rgb, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_project_cubemap_rgb(2, 0, faces, f), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_project_cubemap_rgb(2, INT_MAX, faces, f), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_project_cubemap_rgb(2, 2, NULL, f), PRT_ERR_NULL);
    assert_int_equal(prt_sh_project_cubemap_rgb(2, 2, faces, NULL), PRT_ERR_NULL);
    for (i = 0; i < 6; i++) {
        faces[i] = NULL;
        assert_int_equal(prt_sh_project_cubemap_rgb(2, 2, faces, f), PRT_ERR_NULL);
        faces[i] = rgb;
    }
    assert_memory_equal(f, same, sizeof f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(delta_is_the_basis), cmocka_unit_test(delta_gives_irradiance_one_head_on),
        cmocka_unit_test(cap_factors_keep_every_digit), cmocka_unit_test(cones_of_every_angle),
        cmocka_unit_test(wide_cones_complement_narrow_ones), cmocka_unit_test(spheres_are_cones),
        cmocka_unit_test(cosine_lobe_of_every_band), cmocka_unit_test(hemisphere_is_two_caps),
        cmocka_unit_test(samples_add_up), cmocka_unit_test(convolution_multiplies_bands),
        cmocka_unit_test(equirect_is_the_sum_over_texels), cmocka_unit_test(cubemap_is_the_sum_over_texels),
        cmocka_unit_test(every_face_looks_where_opengl_says), cmocka_unit_test(first_texels_are_where_the_header_says),
        cmocka_unit_test(constants_fill_band_zero),
        cmocka_unit_test(centres_differ_from_means_as_the_header_says), cmocka_unit_test(maps_converge_to_the_function),
        cmocka_unit_test(solid_angles_are_exact), cmocka_unit_test(texels_that_are_not_finite_are_refused),
        cmocka_unit_test(bad_arguments_write_nothing) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
