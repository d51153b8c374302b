/* >>convert: each convention against its owner's basis, written here as the polynomials that the owner publishes (facts
   from the files named, with the digits that stand there), evaluated in double. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"
#include <mpfr.h>

/* ---- the owners' bases ---- */

/* microsoft/DirectXMath SHMath/DirectXSH.cpp, sh_eval_basis_3; b[9] is order 3, and so on. */
static void directx(double x, double y, double z, double *b) {
    double z2 = z * z, p21 = -1.092548430592079200 * z, p31 = -2.285228997322328800 * z2 + 0.457045799464465770;
    double p32 = 1.445305721320277100 * z;
    double s2 = 2 * x * y, c2 = x * x - y * y, s3 = x * s2 + y * c2, c3 = x * c2 - y * s2;
    b[0] = 0.282094791773878140;
    b[1] = -0.488602511902919920 * y; b[2] = 0.488602511902919920 * z; b[3] = -0.488602511902919920 * x;
    b[4] = 0.546274215296039590 * s2; b[5] = p21 * y; b[6] = 0.946174695757560080 * z2 - 0.315391565252520050;
    b[7] = p21 * x; b[8] = 0.546274215296039590 * c2;
    b[9] = -0.590043589926643520 * s3; b[10] = p32 * s2; b[11] = p31 * y;
    b[12] = z * (1.865881662950577000 * z2 - 1.119528997770346200);
    b[13] = p31 * x; b[14] = p32 * c2; b[15] = -0.590043589926643520 * c3;
}

/* google/spherical-harmonics sh/spherical_harmonics.cc, the closed forms beside HardcodedSH00 to HardcodedSH4p4. */
static void google(double x, double y, double z, double *b) {
    double x2 = x * x, y2 = y * y, z2 = z * z;
    b[0] = 0.5 * sqrt(1 / pi);
    b[1] = -sqrt(3 / (4 * pi)) * y;
    b[2] = sqrt(3 / (4 * pi)) * z;
    b[3] = -sqrt(3 / (4 * pi)) * x;
    b[4] = 0.5 * sqrt(15 / pi) * x * y;
    b[5] = -0.5 * sqrt(15 / pi) * y * z;
    b[6] = 0.25 * sqrt(5 / pi) * (-x2 - y2 + 2 * z2);
    b[7] = -0.5 * sqrt(15 / pi) * x * z;
    b[8] = 0.25 * sqrt(15 / pi) * (x2 - y2);
    b[9] = -0.25 * sqrt(35 / (2 * pi)) * y * (3 * x2 - y2);
    b[10] = 0.5 * sqrt(105 / pi) * x * y * z;
    b[11] = -0.25 * sqrt(21 / (2 * pi)) * y * (4 * z2 - x2 - y2);
    b[12] = 0.25 * sqrt(7 / pi) * z * (2 * z2 - 3 * x2 - 3 * y2);
    b[13] = -0.25 * sqrt(21 / (2 * pi)) * x * (4 * z2 - x2 - y2);
    b[14] = 0.25 * sqrt(105 / pi) * z * (x2 - y2);
    b[15] = -0.25 * sqrt(35 / (2 * pi)) * x * (x2 - 3 * y2);
    b[16] = 0.75 * sqrt(35 / pi) * x * y * (x2 - y2);
    b[17] = -0.75 * sqrt(35 / (2 * pi)) * y * z * (3 * x2 - y2);
    b[18] = 0.75 * sqrt(5 / pi) * x * y * (7 * z2 - 1);
    b[19] = -0.75 * sqrt(5 / (2 * pi)) * y * z * (7 * z2 - 3);
    b[20] = 3.0 / 16 * sqrt(1 / pi) * (35 * z2 * z2 - 30 * z2 + 3);
    b[21] = -0.75 * sqrt(5 / (2 * pi)) * x * z * (7 * z2 - 3);
    b[22] = 3.0 / 8 * sqrt(5 / pi) * (x2 - y2) * (7 * z2 - 1);
    b[23] = -0.75 * sqrt(35 / (2 * pi)) * x * z * (x2 - 3 * y2);
    b[24] = 3.0 / 16 * sqrt(35 / pi) * (x2 * (x2 - 3 * y2) - y2 * (3 * x2 - y2));
}

/* mrdoob/three.js src/math/SphericalHarmonics3.js, getBasisAt. Six digits. */
static void threejs(double x, double y, double z, double *b) {
    b[0] = 0.282095;
    b[1] = 0.488603 * y; b[2] = 0.488603 * z; b[3] = 0.488603 * x;
    b[4] = 1.092548 * x * y; b[5] = 1.092548 * y * z; b[6] = 0.315392 * (3 * z * z - 1);
    b[7] = 1.092548 * x * z; b[8] = 0.546274 * (x * x - y * y);
}

/* Unreal Engine Shaders/Private/SHCommon.ush, SHBasisFunction3 (and Core Math/SHMath.h). Six digits. */
static void unreal(double x, double y, double z, double *b) {
    b[0] = 0.282095;
    b[1] = -0.488603 * y; b[2] = 0.488603 * z; b[3] = -0.488603 * x;
    b[4] = 1.092548 * x * y; b[5] = -1.092548 * y * z; b[6] = 0.315392 * (3 * z * z - 1);
    b[7] = -1.092548 * x * z; b[8] = 0.546274 * (x * x - y * y);
}

/* graphdeco-inria/gaussian-splatting utils/sh_utils.py, eval_sh with its C0 to C4. */
static void splat(double x, double y, double z, double *b) {
    double xx = x * x, yy = y * y, zz = z * z;
    b[0] = 0.28209479177387814;
    b[1] = -0.4886025119029199 * y; b[2] = 0.4886025119029199 * z; b[3] = -0.4886025119029199 * x;
    b[4] = 1.0925484305920792 * x * y; b[5] = -1.0925484305920792 * y * z;
    b[6] = 0.31539156525252005 * (2 * zz - xx - yy);
    b[7] = -1.0925484305920792 * x * z; b[8] = 0.5462742152960396 * (xx - yy);
    b[9] = -0.5900435899266435 * y * (3 * xx - yy); b[10] = 2.890611442640554 * x * y * z;
    b[11] = -0.4570457994644658 * y * (4 * zz - xx - yy);
    b[12] = 0.3731763325901154 * z * (2 * zz - 3 * xx - 3 * yy);
    b[13] = -0.4570457994644658 * x * (4 * zz - xx - yy);
    b[14] = 1.445305721320277 * z * (xx - yy); b[15] = -0.5900435899266435 * x * (xx - 3 * yy);
    b[16] = 2.5033429417967046 * x * y * (xx - yy); b[17] = -1.7701307697799304 * y * z * (3 * xx - yy);
    b[18] = 0.9461746957575601 * x * y * (7 * zz - 1); b[19] = -0.6690465435572892 * y * z * (7 * zz - 3);
    b[20] = 0.10578554691520431 * (zz * (35 * zz - 30) + 3); b[21] = -0.6690465435572892 * x * z * (7 * zz - 3);
    b[22] = 0.47308734787878004 * (xx - yy) * (7 * zz - 1); b[23] = -1.7701307697799304 * x * z * (xx - 3 * yy);
    b[24] = 0.6258357354491761 * (xx * (xx - 3 * yy) - yy * (3 * xx - yy));
}

/* google/filament libs/ibl/src/CubemapSH.cpp, TSH (its own check of computeSH). */
static void filament(double x, double y, double z, double *b) {
    double r = 1 / (2 * sqrt(pi));
    b[0] = r;
    b[1] = -sqrt(3) * y * r; b[2] = sqrt(3) * z * r; b[3] = -sqrt(3) * x * r;
    b[4] = sqrt(15) * y * x * r; b[5] = -sqrt(15) * y * z * r; b[6] = sqrt(5) * (3 * z * z - 1) * r / 2;
    b[7] = -sqrt(15) * z * x * r; b[8] = sqrt(15) * (x * x - y * y) * r / 2;
}

/* The same file, renderPreScaledSH3Bands; and the polynomial of Unity's SphericalHarmonicsL2 (Unity-Technologies/
   Graphics com.unity.render-pipelines.high-definition/Runtime/Lighting/SphericalHarmonics.cs, PackCoefficients). */
static void polynomial(double x, double y, double z, double *b) {
    b[0] = 1; b[1] = y; b[2] = z; b[3] = x;
    b[4] = y * x; b[5] = y * z; b[6] = 3 * z * z - 1; b[7] = z * x; b[8] = x * x - y * y;
}

typedef struct owner {
    prt_sh_convention convention;
    void (*basis)(double x, double y, double z, double *b);
    int bands;
    double digits;                                      /* rounding of the published constants */
} owner;

static const owner owners[] = {
    { PRT_CONVENTION_DIRECTX, directx, 4, 1e-17 }, { PRT_CONVENTION_GOOGLE, google, 5, 0 },
    { PRT_CONVENTION_THREEJS, threejs, 3, 5e-7 },  { PRT_CONVENTION_UNREAL, unreal, 3, 5e-7 },
    { PRT_CONVENTION_SPLAT, splat, 5, 5e-17 },     { PRT_CONVENTION_FILAMENT, filament, 3, 0 }
};
enum { OWNERS = sizeof owners / sizeof owners[0] };

/* Arithmetic of at most 25 terms of size up to 2.5, and 25 rounded constants times polynomials of size up to 3. */
static double sum_tolerance(double digits) { return 25 * (4 * (double)PRT__EPS + 3 * digits); }

static double owners_sum(const owner *o, const prt_real *f, prt_vec3 d) {
    double b[25], sum = 0;
    int i;
    o->basis((double)d.x, (double)d.y, (double)d.z, b);
    for (i = 0; i < o->bands * o->bands; i++) sum += (double)f[i] * b[i];
    return sum;
}

static void owners_basis_gives_our_function(void **state) {
    int o, k;
    (void)state;
    for (o = 0; o < OWNERS; o++) {
        const owner *w = &owners[o];
        prt_real ours[25], theirs[25], back[25];
        for (k = 0; k < 200; k++) {
            prt_vec3 d = random_direction();
            random_vector(25, ours);
            assert_int_equal(prt_sh_convert(w->bands, PRT_CONVENTION_PRT, w->convention, ours, theirs), PRT_OK);
            assert_near(owners_sum(w, theirs, d), prt_sh_at(w->bands, ours, d), sum_tolerance(w->digits));
            random_vector(25, theirs);
            assert_int_equal(prt_sh_convert(w->bands, w->convention, PRT_CONVENTION_PRT, theirs, back), PRT_OK);
            assert_near(owners_sum(w, theirs, d), prt_sh_at(w->bands, back, d), sum_tolerance(w->digits));
        }
    }
}

/* E(N)/pi of a three-band radiance by quadrature over the hemisphere about N: four Gauss-Legendre heights on [0,1] and
   eight azimuths integrate cos x (a polynomial of degree 2) exactly. */
static double irradiance_over_pi(const prt_real *light, prt_vec3 n) {
    static const double node[4] = { 0.069431844202973713731, 0.33000947820757187134, 0.66999052179242812866,
                                    0.93056815579702628627 };
    static const double weight[4] = { 0.17392742256872692868, 0.32607257743127307132, 0.32607257743127307132,
                                      0.17392742256872692868 };
    double ax = fabs((double)n.x) < 0.6, ay = 1 - ax, ux, uy, uz, vx, vy, vz, r, sum = 0;
    double nx = (double)n.x, ny = (double)n.y, nz = (double)n.z;
    int i, k;
    ux = ay * nz; uy = -ax * nz; uz = ax * ny - ay * nx;                                       /* (ax,ay,0) x n */
    r = sqrt(ux * ux + uy * uy + uz * uz); ux /= r; uy /= r; uz /= r;
    vx = ny * uz - nz * uy; vy = nz * ux - nx * uz; vz = nx * uy - ny * ux;
    for (i = 0; i < 4; i++) {
        double c = node[i], s = sqrt(1 - c * c);
        for (k = 0; k < 8; k++) {
            double p = s * cos(pi * k / 4), q = s * sin(pi * k / 4), b[25], value = 0;
            int j;
            google(c * nx + p * ux + q * vx, c * ny + p * uy + q * vy, c * nz + p * uz + q * vz, b);
            for (j = 0; j < 9; j++) value += (double)light[j] * b[j] * (j == 1 || j == 3 || j == 5 || j == 7 ? -1 : 1);
            sum += weight[i] * pi / 4 * c * value;
        }
    }
    return sum / pi;
}

static void irradiance_conventions_hold_irradiance_over_pi(void **state) {
    static const prt_sh_convention both[2] = { PRT_CONVENTION_UNITY, PRT_CONVENTION_FILAMENT_IRRADIANCE };
    int k, which, i;
    (void)state;
    for (k = 0; k < 100; k++) {
        for (which = 0; which < 2; which++) {
            prt_real light[9], theirs[9], back[9];
            prt_vec3 n = random_direction();
            double b[9], sum = 0;
            random_vector(9, light);
            assert_int_equal(prt_sh_convert(3, PRT_CONVENTION_PRT, both[which], light, theirs), PRT_OK);
            polynomial((double)n.x, (double)n.y, (double)n.z, b);
            for (i = 0; i < 9; i++) sum += (double)theirs[i] * b[i];
            assert_near(sum, irradiance_over_pi(light, n), sum_tolerance(0));
            assert_int_equal(prt_sh_convert(3, both[which], PRT_CONVENTION_PRT, theirs, back), PRT_OK);
            for (i = 0; i < 9; i++) assert_near(back[i], light[i], 2 * (double)PRT__EPS);
        }
    }
}

/* filament/include/filament/IndirectLight.h, table of irradiance(): index, factor to six digits, for its own signs. */
static void filament_table(void **state) {
    static const double table[9] = { 0.282095, -0.325735, 0.325735, -0.325735, 0.273137, -0.273137, 0.078848, -0.273137,
                                     0.136569 };
    int i;
    (void)state;
    for (i = 0; i < 9; i++) {
        prt_real one[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, out[9];
        one[i] = 1;
        assert_int_equal(prt_sh_convert(3, PRT_CONVENTION_FILAMENT, PRT_CONVENTION_FILAMENT_IRRADIANCE, one, out),
                         PRT_OK);
        assert_near(out[i], table[i], 6e-7);
    }
}

/* A sky of radiance 1 is the ambient colour 1 in Unity, and the sun at its zenith (irradiance 1 head-on) holds, in
   units of 1/pi, the 1/4, 1/2, 5/16 of [Sloan 2008]: 17/16 at the zenith. */
static void known_lights(void **state) {
    prt_real sky[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, sun[9], out[9];
    prt_vec3 up = { 0, 0, 1 };
    (void)state;
    sky[0] = (prt_real)(2 * sqrt(pi));
    assert_int_equal(prt_sh_convert(3, PRT_CONVENTION_PRT, PRT_CONVENTION_UNITY, sky, out), PRT_OK);
    assert_near(out[0], 1, 2 * (double)PRT__EPS);
    assert_int_equal(prt_sh_eval(3, up, sun), PRT_OK);
    assert_int_equal(prt_sh_convert(3, PRT_CONVENTION_PRT, PRT_CONVENTION_UNITY, sun, out), PRT_OK);
    assert_near((double)out[0] * pi, 0.25, 2 * (double)PRT__EPS);
    assert_near((double)out[2] * pi, 0.5, 2 * (double)PRT__EPS);
    assert_near(2 * (double)out[6] * pi, 5.0 / 16, 2 * (double)PRT__EPS);
    assert_near(((double)out[0] + (double)out[2] + 2 * (double)out[6]) * pi, 17.0 / 16, 4 * (double)PRT__EPS);
}

static void round_trips_and_aliasing(void **state) {
    int from, to, i;
    (void)state;
    for (from = 0; from <= (int)PRT_CONVENTION_UNITY; from++) {
        for (to = 0; to <= (int)PRT_CONVENTION_UNITY; to++) {
            int exact = from < (int)PRT_CONVENTION_FILAMENT_IRRADIANCE && to < (int)PRT_CONVENTION_FILAMENT_IRRADIANCE;
            int bands = exact ? 12 : 3;
            prt_real f[144], there[144], back[144];
            random_vector(144, f);
            assert_int_equal(prt_sh_convert(bands, (prt_sh_convention)from, (prt_sh_convention)to, f, there), PRT_OK);
            assert_int_equal(prt_sh_convert(bands, (prt_sh_convention)to, (prt_sh_convention)from, there, back),
                             PRT_OK);
            for (i = 0; i < bands * bands; i++)
                assert_near(back[i], f[i], exact ? 0 : 2 * (double)PRT__EPS * fabs((double)f[i]));
            memcpy(back, f, sizeof f);
            assert_int_equal(prt_sh_convert(bands, (prt_sh_convention)from, (prt_sh_convention)to, back, back), PRT_OK);
            assert_memory_equal(back, there, (size_t)(bands * bands) * sizeof(prt_real));
        }
    }
}

static void convert_refuses(void **state) {
    prt_real f[16] = { 1 }, out[16] = { 7 };
    (void)state;
    assert_int_equal(prt_sh_convert(0, PRT_CONVENTION_PRT, PRT_CONVENTION_GOOGLE, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_convert(-5, PRT_CONVENTION_PRT, PRT_CONVENTION_GOOGLE, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_convert(PRT_MAX_BANDS + 1, PRT_CONVENTION_PRT, PRT_CONVENTION_GOOGLE, f, out),
                     PRT_ERR_BANDS);
    assert_int_equal(prt_sh_convert(4, PRT_CONVENTION_PRT, PRT_CONVENTION_UNITY, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_convert(4, PRT_CONVENTION_FILAMENT_IRRADIANCE, PRT_CONVENTION_PRT, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_convert(2, PRT_CONVENTION_PRT, PRT_CONVENTION_GOOGLE, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convert(2, PRT_CONVENTION_PRT, PRT_CONVENTION_GOOGLE, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convert(2, (prt_sh_convention)15, PRT_CONVENTION_GOOGLE, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_convert(2, PRT_CONVENTION_PRT, (prt_sh_convention)9, f, out), PRT_ERR_VALUE);
    assert_near(out[0], 7, 0);
}

/* ---- seven shader constants ---- */

/* Unity-Technologies/Graphics com.unity.render-pipelines.core/ShaderLibrary/SphericalHarmonics.hlsl, SampleSH9. */
static double shader(const prt_real *k, int c, double x, double y, double z) {
    const prt_real *a = k + 4 * c, *b = k + 12 + 4 * c;
    return (double)a[0] * x + (double)a[1] * y + (double)a[2] * z + (double)a[3] + (double)b[0] * x * y
         + (double)b[1] * y * z + (double)b[2] * z * z + (double)b[3] * z * x + (double)k[24 + c] * (x * x - y * y);
}

static void shader_constants(void **state) {
    int k, c, i, bands;
    (void)state;
    for (bands = 1; bands <= 6; bands++) {
        for (k = 0; k < 50; k++) {
            prt_real light[3 * 36], constants[28], back[27];
            prt_vec3 n = random_direction();
            random_vector(3 * bands * bands, light);
            assert_int_equal(prt_sh_pack_irradiance(bands, light, constants), PRT_OK);
            assert_near(constants[27], 1, 0);
            assert_int_equal(prt_sh_unpack_irradiance(constants, back), PRT_OK);
            for (c = 0; c < 3; c++) {
                prt_real low[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 };
                for (i = 0; i < 9 && i < bands * bands; i++) low[i] = light[c * bands * bands + i];
                assert_near(shader(constants, c, (double)n.x, (double)n.y, (double)n.z), irradiance_over_pi(low, n),
                            sum_tolerance(0));
                for (i = 0; i < 9; i++) assert_near(back[9 * c + i], low[i], 8 * (double)PRT__EPS);
            }
        }
    }
}

static void shader_constants_refuse(void **state) {
    prt_real light[27] = { 0 }, constants[28] = { 5 };
    (void)state;
    assert_int_equal(prt_sh_pack_irradiance(0, light, constants), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_pack_irradiance(PRT_MAX_BANDS + 1, light, constants), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_pack_irradiance(3, NULL, constants), PRT_ERR_NULL);
    assert_int_equal(prt_sh_pack_irradiance(3, light, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_unpack_irradiance(NULL, light), PRT_ERR_NULL);
    assert_int_equal(prt_sh_unpack_irradiance(constants, NULL), PRT_ERR_NULL);
    assert_near(constants[0], 5, 0);
}

/* ---- axes ---- */

/* The k-th of the 48 signed permutations. */
static void signed_permutation(int k, int axes[3]) {
    static const int order[6][3] = { { 1, 2, 3 }, { 1, 3, 2 }, { 2, 1, 3 }, { 2, 3, 1 }, { 3, 1, 2 }, { 3, 2, 1 } };
    int i;
    for (i = 0; i < 3; i++) axes[i] = order[k / 8][i] * (k >> i & 1 ? -1 : 1);
}

/* The basis evaluated at v, mapped, is the basis evaluated at the mapped v (both are the delta at a direction). */
static void all_48_maps_carry_the_delta_along(void **state) {
    static const int bands[8] = { 1, 2, 3, 4, 7, 10, 16, PRT_MAX_BANDS };
    static prt_real at[PRT_SH_COUNT(PRT_MAX_BANDS)], want[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int k, b, i;
    (void)state;
    for (k = 0; k < 48; k++) {
        int axes[3];
        signed_permutation(k, axes);
        for (b = 0; b < 8; b++) {
            prt_vec3 v = random_direction(), w = prt_map_axes(axes, v);
            int n = bands[b];
            double tolerance = n * (16 + n * n / 16.0) * (double)PRT__EPS;     /* of prt_sh_eval at v and at w */
            assert_int_equal(prt_sh_eval(n, v, at), PRT_OK);
            assert_int_equal(prt_sh_eval(n, w, want), PRT_OK);
            assert_int_equal(prt_sh_map_axes(n, axes, at, at), PRT_OK);
            for (i = 0; i < n * n; i++) assert_near(at[i], want[i], tolerance);
        }
    }
}

/* |d(pi/2)| of orders a and b: 2^-l sqrt((l+a)!(l-a)!/((l+b)!(l-b)!)) sum_k (-1)^k C(l+b,l-a-k) C(l-b,k), in MPFR. */
static double wigner_quarter(int l, int a, int b) {
    mpfr_t sum, term, root;
    double out;
    int k;
    mpfr_inits2(512, sum, term, root, (mpfr_ptr)0);
    mpfr_set_zero(sum, 1);
    for (k = 0; k <= l - b; k++) {
        mpz_t binomial;
        int pick = l - a - k;
        if (pick < 0 || pick > l + b) continue;
        mpz_init(binomial);
        mpz_bin_uiui(binomial, (unsigned long)(l + b), (unsigned long)pick);
        mpfr_set_z(term, binomial, MPFR_RNDN);
        mpz_bin_uiui(binomial, (unsigned long)(l - b), (unsigned long)k);
        mpfr_mul_z(term, term, binomial, MPFR_RNDN);
        if (k & 1) mpfr_sub(sum, sum, term, MPFR_RNDN); else mpfr_add(sum, sum, term, MPFR_RNDN);
        mpz_clear(binomial);
    }
    mpfr_fac_ui(root, (unsigned long)(l + a), MPFR_RNDN);
    mpfr_fac_ui(term, (unsigned long)(l - a), MPFR_RNDN);
    mpfr_mul(root, root, term, MPFR_RNDN);
    mpfr_fac_ui(term, (unsigned long)(l + b), MPFR_RNDN);
    mpfr_div(root, root, term, MPFR_RNDN);
    mpfr_fac_ui(term, (unsigned long)(l - b), MPFR_RNDN);
    mpfr_div(root, root, term, MPFR_RNDN);
    mpfr_sqrt(root, root, MPFR_RNDN);
    mpfr_mul(sum, sum, root, MPFR_RNDN);
    mpfr_div_2ui(sum, sum, (unsigned long)l, MPFR_RNDN);
    out = mpfr_get_d(sum, MPFR_RNDN);
    mpfr_clears(sum, term, root, (mpfr_ptr)0);
    return out;
}

static void quarter_turn_entries_to_the_last_digits(void **state) {
    static const int bands[6] = { 1, 2, 3, 9, 31, 63 };
    static prt_real f[PRT_SH_COUNT(64)];
    static const int swap_yz[3] = { 1, 3, 2 };
    int b, row, column;
    double worst = 0;
    (void)state;
    for (b = 0; b < 6; b++) {
        int l = bands[b], step = l > 20 ? 7 : 1;
        for (column = -l; column <= l; column += step) {
            memset(f, 0, sizeof f);
            f[PRT_SH_INDEX(l, column)] = 1;
            assert_int_equal(prt_sh_map_axes(l + 1, swap_yz, f, f), PRT_OK);
            for (row = -l; row <= l; row++) {
                int r = abs(row), c = abs(column);
                double entry = fabs((double)f[PRT_SH_INDEX(l, row)]), want;
                int even_z_of_source = !((l + column) & 1), even_y_of_image = row >= 0;
                int even_y_of_source = column >= 0, even_z_of_image = !((l + row) & 1);
                int joined = even_z_of_source == even_y_of_image && even_y_of_source == even_z_of_image;
                want = joined ? fabs(wigner_quarter(l, r, c)) * (r ? sqrt(2) : 1) * (c ? sqrt(2) : 1) : 0;
                if (!(fabs(entry - want) <= worst)) worst = fabs(entry - want);
            }
        }
    }
    assert_at_most(worst, BY_PRECISION(6e-8, 1e-15));
}

/* A map and its inverse cancel: to rounding, and to the bit where z keeps its axis. */
static void a_map_and_its_inverse_cancel(void **state) {
    static prt_real f[PRT_SH_COUNT(PRT_MAX_BANDS)], g[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int k, i, j, n = PRT_MAX_BANDS;
    (void)state;
    for (k = 0; k < 48; k++) {
        int axes[3], inverse[3] = { 0, 0, 0 };
        double norm = 0, error = 0;
        signed_permutation(k, axes);
        for (i = 0; i < 3; i++)
            for (j = 0; j < 3; j++) if (abs(axes[i]) == j + 1) inverse[j] = axes[i] < 0 ? -(i + 1) : i + 1;
        random_vector(n * n, f);
        assert_int_equal(prt_sh_map_axes(n, axes, f, g), PRT_OK);
        assert_int_equal(prt_sh_map_axes(n, inverse, g, g), PRT_OK);
        for (i = 0; i < n * n; i++) {
            norm += (double)f[i] * (double)f[i];
            error += ((double)f[i] - (double)g[i]) * ((double)f[i] - (double)g[i]);
        }
        assert_at_most(sqrt(error / norm), BY_PRECISION(2e-7, 2e-15));
        if (abs(axes[2]) == 3) assert_near(error, 0, 0);
    }
}

static void three_letters(void **state) {
    static const struct { const char *from, *to; int axes[3]; } known[] = {
        { PRT_AXES_BLENDER, PRT_AXES_OPENGL, { 1, 3, -2 } }, { PRT_AXES_OPENGL, PRT_AXES_BLENDER, { 1, -3, 2 } },
        { PRT_AXES_OPENGL, PRT_AXES_UNITY, { 1, 2, -3 } },   { PRT_AXES_OPENGL, PRT_AXES_OPENCV, { 1, -2, -3 } },
        { PRT_AXES_UNITY, PRT_AXES_UNREAL, { 3, 1, 2 } },    { "LUF", "RUB", { -1, 2, -3 } }
    };
    static const char *const bad[] = { "", "R", "RU", "RUR", "RLU", "RUBB", "ruB", "RUX", "XYZ" };
    prt_real f[4] = { 1, 2, 3, 4 }, out[4] = { 9, 9, 9, 9 };
    int axes[3] = { 4, 4, 4 };
    size_t i;
    (void)state;
    for (i = 0; i < sizeof known / sizeof known[0]; i++) {
        assert_int_equal(prt_axes_map(known[i].from, known[i].to, axes), PRT_OK);
        assert_memory_equal(axes, known[i].axes, sizeof axes);
    }
    axes[0] = 4;
    for (i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(prt_axes_map(bad[i], "RUB", axes), PRT_ERR_VALUE);
        assert_int_equal(prt_axes_map("RUB", bad[i], axes), PRT_ERR_VALUE);
        assert_int_equal(prt_sh_convert_axes(2, bad[i], "RUB", f, out), PRT_ERR_VALUE);
    }
    assert_int_equal(axes[0], 4);
    assert_int_equal(prt_axes_map(NULL, "RUB", axes), PRT_ERR_NULL);
    assert_int_equal(prt_axes_map("RUB", NULL, axes), PRT_ERR_NULL);
    assert_int_equal(prt_axes_map("RUB", "RUB", NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convert_axes(0, "RUB", "RUB", f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_convert_axes(2, NULL, "RUB", f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convert_axes(2, "RUB", "RUB", NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_convert_axes(2, "RUB", "RUB", f, NULL), PRT_ERR_NULL);
    assert_near(out[0], 9, 0);
}

/* "Up" stays up: light from above in a y-up world comes from above in the z-up one. */
static void up_stays_up(void **state) {
    static const struct { const char *world; double up[3]; } worlds[] = {
        { PRT_AXES_BLENDER, { 0, 0, 1 } }, { PRT_AXES_OPENGL, { 0, 1, 0 } }, { PRT_AXES_UNITY, { 0, 1, 0 } },
        { PRT_AXES_UNREAL, { 0, 0, 1 } },  { PRT_AXES_OPENCV, { 0, -1, 0 } }
    };
    int from, to, i;
    (void)state;
    for (from = 0; from < 5; from++) {
        for (to = 0; to < 5; to++) {
            const double *u = worlds[from].up, *w = worlds[to].up;
            prt_vec3 above, there;
            prt_real light[25], want[25];
            above.x = (prt_real)u[0]; above.y = (prt_real)u[1]; above.z = (prt_real)u[2];
            there.x = (prt_real)w[0]; there.y = (prt_real)w[1]; there.z = (prt_real)w[2];
            assert_int_equal(prt_sh_eval(5, above, light), PRT_OK);
            assert_int_equal(prt_sh_eval(5, there, want), PRT_OK);
            assert_int_equal(prt_sh_convert_axes(5, worlds[from].world, worlds[to].world, light, light), PRT_OK);
            for (i = 0; i < 25; i++) assert_near(light[i], want[i], 4 * (double)PRT__EPS);
        }
    }
}

/* From everyone's world and signs into ours and back: what a splat shows along v, prt.h shows along the mapped v. */
static void signs_and_axes_together(void **state) {
    int k;
    (void)state;
    for (k = 0; k < 100; k++) {
        prt_real theirs[25], ours[25], back[25];
        prt_vec3 v = random_direction();
        int axes[3], i;
        random_vector(25, theirs);
        assert_int_equal(prt_axes_map(PRT_AXES_OPENCV, PRT_AXES_BLENDER, axes), PRT_OK);
        assert_int_equal(prt_sh_convert(5, PRT_CONVENTION_SPLAT, PRT_CONVENTION_PRT, theirs, ours), PRT_OK);
        assert_int_equal(prt_sh_convert_axes(5, PRT_AXES_OPENCV, PRT_AXES_BLENDER, ours, ours), PRT_OK);
        assert_near(prt_sh_at(5, ours, prt_map_axes(axes, v)), owners_sum(&owners[4], theirs, v), sum_tolerance(0));
        assert_int_equal(prt_sh_convert_axes(5, PRT_AXES_BLENDER, PRT_AXES_OPENCV, ours, back), PRT_OK);
        assert_int_equal(prt_sh_convert(5, PRT_CONVENTION_PRT, PRT_CONVENTION_SPLAT, back, back), PRT_OK);
        for (i = 0; i < 25; i++) assert_near(back[i], theirs[i], 4 * (double)PRT__EPS);
    }
}

static void map_axes_refuses(void **state) {
    static const int bad[7][3] = { { 0, 1, 2 }, { 1, 1, 2 }, { 1, -1, 3 }, { 1, 2, 4 }, { -4, 2, 3 }, { 3, 3, 3 },
                                   { -2147483647 - 1, 1, 2 } };
    static const int good[3] = { 1, 2, 3 };
    prt_real f[4] = { 1, 2, 3, 4 }, out[4] = { 9, 9, 9, 9 };
    prt_vec3 v = { 1, 2, 3 };
    int k;
    (void)state;
    for (k = 0; k < 7; k++) {
        assert_int_equal(prt_sh_map_axes(2, bad[k], f, out), PRT_ERR_VALUE);
        assert_near(prt_map_axes(bad[k], v).x, 0, 0);
    }
    assert_near(prt_map_axes(NULL, v).z, 0, 0);
    assert_int_equal(prt_sh_map_axes(0, good, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_map_axes(PRT_MAX_BANDS + 1, good, f, out), PRT_ERR_BANDS);
    assert_int_equal(prt_sh_map_axes(2, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_map_axes(2, good, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_map_axes(2, good, f, NULL), PRT_ERR_NULL);
    assert_near(out[0], 9, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(owners_basis_gives_our_function),
        cmocka_unit_test(irradiance_conventions_hold_irradiance_over_pi),
        cmocka_unit_test(filament_table), cmocka_unit_test(known_lights), cmocka_unit_test(round_trips_and_aliasing),
        cmocka_unit_test(convert_refuses), cmocka_unit_test(shader_constants),
        cmocka_unit_test(shader_constants_refuse),
        cmocka_unit_test(all_48_maps_carry_the_delta_along), cmocka_unit_test(quarter_turn_entries_to_the_last_digits),
        cmocka_unit_test(a_map_and_its_inverse_cancel), cmocka_unit_test(three_letters), cmocka_unit_test(up_stays_up),
        cmocka_unit_test(signs_and_axes_together), cmocka_unit_test(map_axes_refuses)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
