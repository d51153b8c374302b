#define PRT_IMPLEMENTATION
#define PRT_MAX_BANDS 128
#include "prt.h"
#include "test.h"
#include <mpfr.h>

/* Deterministic numbers in [-1, 1]. */
static uint32_t random_state = 1;
static double random_signed(void) {
    random_state = random_state * 1664525u + 1013904223u;
    return (double)(random_state >> 8) / 8388608.0 - 1;
}

static prt_vec3 random_direction(void) {
    for (;;) {
        double x = random_signed(), y = random_signed(), z = random_signed(), r = sqrt(x * x + y * y + z * z);
        if (r > 0.1 && r < 1) {
            prt_vec3 v;
            v.x = (prt_real)(x / r); v.y = (prt_real)(y / r); v.z = (prt_real)(z / r);
            return v;
        }
    }
}

static void random_rotation(prt_real r[9]) {
    prt_real q[4];
    int i;
    for (i = 0; i < 4; i++) q[i] = (prt_real)random_signed();
    assert_int_equal(prt_rotation_from_quaternion(q, r), PRT_OK);
}

static void random_vector(int count, prt_real *f) {
    int i;
    for (i = 0; i < count; i++) f[i] = (prt_real)random_signed();
}

static prt_vec3 turned(const prt_real *r, prt_vec3 v) {
    prt_vec3 w;
    w.x = r[0] * v.x + r[1] * v.y + r[2] * v.z;
    w.y = r[3] * v.x + r[4] * v.y + r[5] * v.z;
    w.z = r[6] * v.x + r[7] * v.y + r[8] * v.z;
    return w;
}

/* out = a b, 3x3. */
static void multiply(const prt_real *a, const prt_real *b, prt_real *out) {
    int i, j;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) out[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
}

static prt_real *new_array(size_t count) {
    prt_real *p = (prt_real *)malloc(count * sizeof *p);
    assert_non_null(p);
    return p;
}

static double distance(int count, const prt_real *a, const prt_real *b) {
    double worst = 0;
    int i;
    for (i = 0; i < count; i++) {
        double d = fabs((double)a[i] - (double)b[i]);
        if (!(d <= worst)) worst = d;
    }
    return worst;
}

/* ---- reference tables: 50-digit recursion, golden/gen_rot.py ---------------------------------------------------- */

typedef struct golden_case { char id[40]; prt_real rotation[9]; double blocks[9 * (4 * 81 - 1) / 3]; } golden_case;
static golden_case golden[16];
static int golden_count;

static void read_golden(void) {
    FILE *file = fopen(PRT_GOLDEN_DIR "/rot_ref.csv", "r");
    char line[256];
    if (golden_count) return;
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        char id[40], kind[4];
        int l, row, column;
        double value;
        assert_int_equal(sscanf(line, "%39[^,],%3[^,],%d,%d,%d,%lf", id, kind, &l, &row, &column, &value), 6);
        if (!golden_count || strcmp(golden[golden_count - 1].id, id) != 0) {
            assert_true(golden_count < 16);
            strcpy(golden[golden_count++].id, id);
        }
        if (kind[0] == 'R') golden[golden_count - 1].rotation[3 * row + column] = (prt_real)value;
        else golden[golden_count - 1].blocks[l * (4 * l * l - 1) / 3 + row * (2 * l + 1) + column] = value;
    }
    fclose(file);
    assert_int_equal(golden_count, 10);
}

static void blocks_agree_with_the_reference_table(void **state) {
    prt_real blocks[969];
    int c, i;
    (void)state;
    read_golden();
    for (c = 0; c < golden_count; c++) {
        assert_int_equal(prt_sh_rotation(9, golden[c].rotation, blocks), PRT_OK);
        for (i = 0; i < 969; i++) assert_near(blocks[i], golden[c].blocks[i], BY_PRECISION(1e-6, 2e-15));
    }
}

/* ---- blocks against independent facts --------------------------------------------------------------------------- */

/* Largest entry of |M M^T - 1| over the bands. */
static double orthogonality_error(int bands, const prt_real *blocks) {
    double worst = 0;
    int l, i, j, k;
    for (l = 0; l < bands; l++) {
        int size = 2 * l + 1;
        const prt_real *m = blocks + prt_sh_rotation_count(l);
        for (i = 0; i < size; i++)
            for (j = 0; j <= i; j++) {
                double dot = i == j ? -1 : 0;
                for (k = 0; k < size; k++) dot += (double)m[i * size + k] * (double)m[j * size + k];
                if (!(fabs(dot) <= worst)) worst = fabs(dot);
            }
    }
    return worst;
}

static void blocks_are_orthogonal(void **state) {
    prt_real rotation[9], *blocks = new_array(prt_sh_rotation_count(128));
    int trial;
    (void)state;
    for (trial = 0; trial < 5; trial++) {
        random_rotation(rotation);
        assert_int_equal(prt_sh_rotation(128, rotation, blocks), PRT_OK);
        assert_at_most(orthogonality_error(64, blocks), BY_PRECISION(1e-5, 2e-14));
        assert_at_most(orthogonality_error(128, blocks), BY_PRECISION(1e-3, 2e-12));
    }
    free(blocks);
}

/* Y(R v) = M Y(v), band by band; the evaluation's own error is tested elsewhere. */
static void blocks_turn_the_basis(void **state) {
    enum { BANDS = 40 };
    static prt_real y[BANDS * BANDS], turned_y[BANDS * BANDS], out[BANDS * BANDS];
    prt_real rotation[9], *blocks = new_array(prt_sh_rotation_count(BANDS));
    int trial, i;
    (void)state;
    for (trial = 0; trial < 8; trial++) {
        prt_vec3 v = random_direction();
        random_rotation(rotation);
        if (trial & 1) for (i = 0; i < 9; i++) rotation[i] = -rotation[i];
        assert_int_equal(prt_sh_rotation(BANDS, rotation, blocks), PRT_OK);
        prt_sh_eval(BANDS, v, y);
        prt_sh_eval(BANDS, turned(rotation, v), turned_y);
        assert_int_equal(prt_sh_rotate_by(BANDS, blocks, y, out), PRT_OK);
        assert_at_most(distance(36, out, turned_y), BY_PRECISION(2e-6, 4e-15));
        assert_at_most(distance(BANDS * BANDS, out, turned_y), BY_PRECISION(1e-4, 2e-13));
    }
    free(blocks);
}

/* M(A B) = M(A) M(B), M(-R) = (-1)^l M(R), and the band-1 block is R itself. */
static void blocks_compose_and_reflect(void **state) {
    enum { BANDS = 16, N = BANDS * BANDS };
    prt_real a[9], b[9], ab[9], f[N], by_b[N], by_a[N], by_ab[N];
    prt_real *blocks = new_array(prt_sh_rotation_count(BANDS)), *minus = new_array(prt_sh_rotation_count(BANDS));
    int trial, i, l;
    (void)state;
    for (trial = 0; trial < 10; trial++) {
        random_rotation(a);
        random_rotation(b);
        multiply(a, b, ab);
        random_vector(N, f);
        prt_sh_rotation(BANDS, b, blocks);
        prt_sh_rotate_by(BANDS, blocks, f, by_b);
        prt_sh_rotation(BANDS, a, blocks);
        prt_sh_rotate_by(BANDS, blocks, by_b, by_a);
        prt_sh_rotation(BANDS, ab, blocks);
        prt_sh_rotate_by(BANDS, blocks, f, by_ab);
        assert_at_most(distance(N, by_a, by_ab), BY_PRECISION(2e-5, 4e-14));
        for (i = 0; i < 9; i++) ab[i] = -ab[i];
        assert_int_equal(prt_sh_rotation(BANDS, ab, minus), PRT_OK);
        for (l = 0; l < BANDS; l++)
            for (i = (int)prt_sh_rotation_count(l); i < (int)prt_sh_rotation_count(l + 1); i++)
                assert_near(minus[i], l & 1 ? -blocks[i] : blocks[i], BY_PRECISION(1e-6, 2e-15));
    }
    free(blocks);
    free(minus);
}

/* ---- blocks to vectors ------------------------------------------------------------------------------------------ */

/* out = blocks f in double, for one vector whose coefficients stand `step` apart. */
static void plain_product(int bands, const prt_real *blocks, const prt_real *f, size_t step, double *out) {
    int l, i, j;
    for (l = 0; l < bands; l++)
        for (i = 0; i <= 2 * l; i++) {
            double sum = 0;
            for (j = 0; j <= 2 * l; j++) sum += (double)*blocks++ * (double)f[(size_t)(l * l + j) * step];
            out[l * l + i] = sum;
        }
}

static void every_layout_is_the_plain_product(void **state) {
    static const int all_bands[] = { 1, 2, 3, 4, 5, 6, 8, 9, 13, 21 };
    enum { COUNT = 37, STRIDE = 41, MOST = 21 * 21 };
    prt_real *blocks = new_array(prt_sh_rotation_count(21)), rotation[9];
    prt_real *f = new_array(3 * STRIDE * MOST), *out = new_array(3 * STRIDE * MOST), one[MOST];
    double want[MOST];
    size_t b;
    int k, i, c;
    (void)state;
    for (b = 0; b < sizeof all_bands / sizeof *all_bands; b++) {
        int bands = all_bands[b], n = bands * bands;
        double tolerance = BY_PRECISION(1e-6, 2e-15) * bands;
        random_rotation(rotation);
        assert_int_equal(prt_sh_rotation(bands, rotation, blocks), PRT_OK);
        random_vector(3 * STRIDE * n, f);
        assert_int_equal(prt_sh_rotate_by_n(bands, blocks, COUNT, f, out), PRT_OK);
        for (k = 0; k < COUNT; k++) {
            plain_product(bands, blocks, f + k * n, 1, want);
            prt_sh_rotate_by(bands, blocks, f + k * n, one);
            for (i = 0; i < n; i++) { assert_near(out[k * n + i], want[i], tolerance); assert_near(one[i], want[i], tolerance); }
        }
        assert_int_equal(prt_sh_rotate_by_n_rgb(bands, blocks, COUNT, f, out), PRT_OK);
        for (k = 0; k < COUNT; k++)
            for (c = 0; c < 3; c++) {
                plain_product(bands, blocks, f + 3 * k * n + c, 3, want);
                for (i = 0; i < n; i++) assert_near(out[3 * k * n + 3 * i + c], want[i], tolerance);
            }
        assert_int_equal(prt_sh_rotate_by_soa(bands, blocks, COUNT, f, out, STRIDE), PRT_OK);
        for (k = 0; k < COUNT; k++) {
            plain_product(bands, blocks, f + k, STRIDE, want);
            for (i = 0; i < n; i++) assert_near(out[i * STRIDE + k], want[i], tolerance);
        }
    }
    free(f);
    free(out);
    free(blocks);
}

/* A vector's bits depend neither on the count nor on its place, in place or not, and nothing else is written. */
static void batches_are_bit_equal_to_their_parts(void **state) {
    static const int all_bands[] = { 1, 2, 3, 4, 6, 10 };
    enum { COUNT = 40, MOST = 3 * 100 };
    prt_real *blocks = new_array(prt_sh_rotation_count(10)), rotation[9];
    prt_real *f = new_array(COUNT * MOST), *out = new_array(COUNT * MOST + 1), part[MOST + 1];
    prt_result (*const batch[2])(int, const prt_real *, int, const prt_real *, prt_real *) =
        { prt_sh_rotate_by_n, prt_sh_rotate_by_n_rgb };
    size_t b, form;
    int k, count;
    (void)state;
    for (b = 0; b < sizeof all_bands / sizeof *all_bands; b++)
        for (form = 0; form < 2; form++) {
            int bands = all_bands[b], n = bands * bands * (form ? 3 : 1);
            size_t bytes = (size_t)n * sizeof *f;
            random_rotation(rotation);
            prt_sh_rotation(bands, rotation, blocks);
            random_vector(COUNT * n, f);
            for (count = 1; count <= COUNT; count += 3) {
                out[count * n] = 77;
                assert_int_equal(batch[form](bands, blocks, count, f, out), PRT_OK);
                assert_near(out[count * n], 77, 0);
                for (k = 0; k < count; k++) {
                    part[n] = 77;
                    assert_int_equal(batch[form](bands, blocks, 1, f + k * n, part), PRT_OK);
                    assert_near(part[n], 77, 0);
                    assert_memory_equal(part, out + k * n, bytes);
                }
            }
            assert_int_equal(batch[form](bands, blocks, COUNT, f, out), PRT_OK);
            assert_int_equal(batch[form](bands, blocks, COUNT, f, f), PRT_OK);
            assert_memory_equal(f, out, COUNT * bytes);
        }
    free(f);
    free(out);
    free(blocks);
}

/* ---- quaternions ------------------------------------------------------------------------------------------------ */

static void quaternions_turn_as_documented(void **state) {
    prt_real quarter_about_x[4] = { 1, 1, 0, 0 }, r[9], want[9] = { 1, 0, 0, 0, 0, -1, 0, 1, 0 }, minus[9];
    prt_real huge[4] = { 0, 0, BY_PRECISION(1e38f, 1e300), BY_PRECISION(1e38f, 1e300) };
    prt_real tiny[4] = { 0, 0, BY_PRECISION(1e-38f, 1e-300), BY_PRECISION(1e-38f, 1e-300) };
    prt_real bad[4] = { 1, 0, 0, 0 };
    int i;
    (void)state;
    skip_if_fast_math();
    assert_int_equal(prt_rotation_from_quaternion(quarter_about_x, r), PRT_OK);
    assert_at_most(distance(9, r, want), 0);
    for (i = 0; i < 4; i++) quarter_about_x[i] = -quarter_about_x[i];
    assert_int_equal(prt_rotation_from_quaternion(quarter_about_x, minus), PRT_OK);
    assert_memory_equal(r, minus, sizeof r);
    assert_int_equal(prt_rotation_from_quaternion(huge, r), PRT_OK);
    assert_int_equal(prt_rotation_from_quaternion(tiny, minus), PRT_OK);
    assert_memory_equal(r, minus, sizeof r);
    assert_near(r[5], 1, 0);
    for (i = 0; i < 9; i++) r[i] = 77;
    bad[2] = (prt_real)NAN;
    assert_int_equal(prt_rotation_from_quaternion(bad, r), PRT_ERR_VALUE);
    bad[2] = (prt_real)INFINITY;
    assert_int_equal(prt_rotation_from_quaternion(bad, r), PRT_ERR_VALUE);
    bad[0] = bad[2] = 0;
    assert_int_equal(prt_rotation_from_quaternion(bad, r), PRT_ERR_VALUE);
    assert_int_equal(prt_rotation_from_quaternion(NULL, r), PRT_ERR_NULL);
    assert_int_equal(prt_rotation_from_quaternion(bad, NULL), PRT_ERR_NULL);
    for (i = 0; i < 9; i++) assert_near(r[i], 77, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_agree_with_the_reference_table),
        cmocka_unit_test(blocks_are_orthogonal),
        cmocka_unit_test(blocks_turn_the_basis),
        cmocka_unit_test(blocks_compose_and_reflect),
        cmocka_unit_test(every_layout_is_the_plain_product),
        cmocka_unit_test(batches_are_bit_equal_to_their_parts),
        cmocka_unit_test(quaternions_turn_as_documented),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
