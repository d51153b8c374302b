#define PRT_IMPLEMENTATION
#define PRT_MAX_BANDS 128
#include "prt.h"
#include "test.h"
#include "geometry.h"
#include <mpfr.h>
#include "../bench/published_rotation.h"

/* Deterministic numbers in [-1, 1]. */
static void random_rotation(prt_real r[9]) {
    prt_real q[4];
    int i;
    for (i = 0; i < 4; i++) q[i] = (prt_real)signed_uniform();
    assert_int_equal(prt_rotation_from_quaternion(q, r), PRT_OK);
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

static double worst_orthogonality(int first, int bands, const prt_real *blocks) {
    double worst = 0;
    int l;
    for (l = first; l < bands; l++) {
        double error = orthogonality_error(2 * l + 1, blocks + prt_sh_rotation_count(l));
        if (!(error <= worst)) worst = error;
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
        assert_at_most(worst_orthogonality(0, 64, blocks), BY_PRECISION(1e-5, 2e-14));
        assert_at_most(worst_orthogonality(64, 128, blocks), BY_PRECISION(1e-3, 2e-12));
    }
    free(blocks);
}

/* The same recursion with the published columns: no better at 8 bands, useless at 128. */
static void the_published_recursion_explodes(void **state) {
    prt_real rotation[9], *blocks = new_array(prt_sh_rotation_count(128));
    double low = 0, middle = 0, high = 0;
    int l, trial;
    (void)state;
    for (trial = 0; trial < 5; trial++) {
        random_rotation(rotation);
        assert_int_equal(prt_sh_rotation(2, rotation, blocks), PRT_OK);
        for (l = 2; l < 128; l++)
            published_block(l, blocks + 1, blocks + prt_sh_rotation_count(l - 1), blocks + prt_sh_rotation_count(l));
        low = fmax(low, worst_orthogonality(0, 9, blocks));
        middle = fmax(middle, worst_orthogonality(63, 64, blocks));
        high = fmax(high, worst_orthogonality(127, 128, blocks));
    }
    assert_at_most(low, BY_PRECISION(2e-6, 4e-15));
    assert_at_most(BY_PRECISION(1e-3, 1e-12), middle);
    assert_at_most(BY_PRECISION(1e6, 1e-6), high);
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
    static const int all_bands[] = { 1, 2, 3, 4, 5, 6, 8, 10 };
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

/* The same for rows: any count, any place in the row, in place or not. */
static void rows_are_bit_equal_to_their_parts(void **state) {
    static const int all_bands[] = { 1, 2, 4, 5, 6, 8, 9 };
    enum { COUNT = 40, STRIDE = 43, MOST = 81 * STRIDE };
    prt_real *blocks = new_array(prt_sh_rotation_count(9)), rotation[9];
    prt_real *f = new_array(MOST), *out = new_array(MOST), *part = new_array(MOST);
    size_t b;
    int i, k, count;
    (void)state;
    for (b = 0; b < sizeof all_bands / sizeof *all_bands; b++) {
        int bands = all_bands[b], n = bands * bands;
        random_rotation(rotation);
        prt_sh_rotation(bands, rotation, blocks);
        random_vector(MOST, f);
        for (i = 0; i < MOST; i++) out[i] = 77;
        assert_int_equal(prt_sh_rotate_by_soa(bands, blocks, COUNT, f, out, STRIDE), PRT_OK);
        for (i = 0; i < n; i++)
            for (k = COUNT; k < STRIDE; k++) assert_near(out[i * STRIDE + k], 77, 0);
        for (count = 1; count < COUNT; count += 6) {
            assert_int_equal(prt_sh_rotate_by_soa(bands, blocks, count, f + COUNT - count, part, STRIDE), PRT_OK);
            for (i = 0; i < n; i++)
                assert_memory_equal(part + i * STRIDE, out + i * STRIDE + COUNT - count, (size_t)count * sizeof *part);
        }
        assert_int_equal(prt_sh_rotate_by_soa(bands, blocks, COUNT, f, f, STRIDE), PRT_OK);
        for (i = 0; i < n; i++) assert_memory_equal(f + i * STRIDE, out + i * STRIDE, COUNT * sizeof *f);
    }
    free(f);
    free(out);
    free(part);
    free(blocks);
}

/* Rows whole pages apart, which are copied in parts, give what rows close to each other give, in place too. */
static void rows_pages_apart_are_the_same(void **state) {
    enum { COUNT = 150, PAGES = 1024, BANDS = 8, N = BANDS * BANDS };
    prt_real *blocks = new_array(prt_sh_rotation_count(BANDS)), rotation[9];
    prt_real *f = new_array(N * PAGES), *out = new_array(N * PAGES), *near = new_array(2 * N * COUNT);
    int i, k, in_place;
    (void)state;
    random_rotation(rotation);
    prt_sh_rotation(BANDS, rotation, blocks);
    random_vector(N * PAGES, f);
    for (i = 0; i < N; i++) memcpy(near + i * COUNT, f + i * PAGES, COUNT * sizeof *f);
    assert_int_equal(prt_sh_rotate_by_soa(BANDS, blocks, COUNT, near, near + N * COUNT, COUNT), PRT_OK);
    for (in_place = 0; in_place < 2; in_place++) {
        prt_real *to = in_place ? f : out;
        for (i = 0; i < N; i++)
            for (k = COUNT; k < PAGES; k++) to[i * PAGES + k] = 77;
        assert_int_equal(prt_sh_rotate_by_soa(BANDS, blocks, COUNT, f, to, PAGES), PRT_OK);
        for (i = 0; i < N; i++) {
            assert_memory_equal(to + i * PAGES, near + (N + i) * COUNT, COUNT * sizeof *f);
            for (k = COUNT; k < PAGES; k++) assert_near(to[i * PAGES + k], 77, 0);
        }
    }
    free(f);
    free(out);
    free(near);
    free(blocks);
}

/* Many vectors at 4 to 8 bands may go by factors of the blocks, turns about z, y and z: that must not show. Every layout
   against the plain product of the blocks as they are, band l within scale[l] tolerance (scale NULL: 1). */
enum { FACTORED = 8, SOME = 5 };
typedef struct factored_case {
    prt_real blocks[FACTORED * (4 * FACTORED * FACTORED - 1) / 3], f[3 * SOME * FACTORED * FACTORED];
} factored_case;

static void layouts_agree(int bands, const factored_case *c, const double *scale, double tolerance) {
    enum { MOST = FACTORED * FACTORED };
    prt_real out[3 * SOME * MOST];
    double want[MOST];
    int form, k, l, i, n = bands * bands;
    for (form = 0; form < 3; form++) {
        int plane_step = form ? 1 : n, step = form == 2 ? SOME : form == 1 ? 3 : 1, vectors = form == 1 ? 3 * SOME : SOME;
        if (form == 0) assert_int_equal(prt_sh_rotate_by_n(bands, c->blocks, SOME, c->f, out), PRT_OK);
        if (form == 1) assert_int_equal(prt_sh_rotate_by_n_rgb(bands, c->blocks, SOME, c->f, out), PRT_OK);
        if (form == 2) assert_int_equal(prt_sh_rotate_by_soa(bands, c->blocks, SOME, c->f, out, SOME), PRT_OK);
        for (k = 0; k < vectors; k++) {
            int at = form == 1 ? k / 3 * 3 * n + k % 3 : k * plane_step;
            plain_product(bands, c->blocks, c->f + at, (size_t)step, want);
            for (l = 0; l < bands; l++)
                for (i = l * l; i < (l + 1) * (l + 1); i++)
                    assert_near(out[at + i * step], want[i], tolerance * (scale ? scale[l] : 1));
        }
    }
}

/* R = Rz(a) Ry(b) Rz(g), rounded. */
static void rotation_of_angles(double a, double b, double g, prt_real r[9]) {
    double ca = cos(a), sa = sin(a), cb = cos(b), sb = sin(b), cg = cos(g), sg = sin(g);
    r[0] = (prt_real)(ca * cb * cg - sa * sg); r[1] = (prt_real)(-ca * cb * sg - sa * cg); r[2] = (prt_real)(ca * sb);
    r[3] = (prt_real)(sa * cb * cg + ca * sg); r[4] = (prt_real)(-sa * cb * sg + ca * cg); r[5] = (prt_real)(sa * sb);
    r[6] = (prt_real)(-sb * cg); r[7] = (prt_real)(sb * sg); r[8] = (prt_real)cb;
}

/* Where a cosine or sine of a multiple of a or g vanishes or nearly so, tilts from nothing to upside down; each as a
   rotation and as a reflection. */
static void many_vectors_take_hard_angles(void **state) {
    static const double tilt[] = { 0, 1e-9, 1e-7, 1e-4, 0.7, 0.5, 1 - 1e-4, 1 - 1e-7, 1 };            /* over pi */
    static factored_case c;
    double turn[18];
    prt_real r[9];
    int a, g, i, trial = 0;
    size_t b;
    (void)state;
    for (i = 0; i < 8; i++) turn[i] = pi / 2 / (i + 1);
    for (i = 0; i < 7; i++) turn[8 + i] = -3 * pi / 2 / (i + 1) + (i & 1 ? 1e-8 : -1e-5);
    turn[15] = 0; turn[16] = 1e-7; turn[17] = pi;
    random_vector((int)(sizeof c.f / sizeof *c.f), c.f);
    for (a = 0; a < 18; a++)
        for (b = 0; b < sizeof tilt / sizeof *tilt; b++)
            for (g = (a + (int)b) % 6; g < 18; g += 6, trial++) {
                rotation_of_angles(turn[a], pi * tilt[b], turn[g], r);
                for (i = 0; i < 9 && trial % 7 == 0; i++) r[i] = -r[i];
                assert_int_equal(prt_sh_rotation(FACTORED, r, c.blocks), PRT_OK);
                layouts_agree(FACTORED - trial % 5, &c, NULL, BY_PRECISION(2e-6, 4e-15));
            }
}

/* The whole turn and quarter turns only move numbers and change signs. */
static void quarter_turns_of_many_vectors_are_permutations(void **state) {
    static factored_case c;
    static prt_real out[3 * SOME * FACTORED * FACTORED];
    int quarter, k, l, m, n = FACTORED * FACTORED;
    (void)state;
    random_vector((int)(sizeof c.f / sizeof *c.f), c.f);
    for (quarter = 0; quarter < 4; quarter++) {
        prt_real turn[4] = { 0, 0, 0, 0 }, r[9];
        turn[0] = quarter == 0 ? 1 : quarter == 2 ? 0 : 1;
        turn[3] = quarter == 0 ? 0 : quarter == 3 ? -1 : 1;
        assert_int_equal(prt_rotation_from_quaternion(turn, r), PRT_OK);
        assert_int_equal(prt_sh_rotation(FACTORED, r, c.blocks), PRT_OK);
        assert_int_equal(prt_sh_rotate_by_n(FACTORED, c.blocks, SOME, c.f, out), PRT_OK);
        for (k = 0; k < SOME; k++)
            for (l = 0; l < FACTORED; l++)
                for (m = -l; m <= l; m++) {
                    double cosine = floor(cos(m * quarter * pi / 2) + 0.5), sine = floor(sin(m * quarter * pi / 2) + 0.5);
                    const prt_real *f = c.f + k * n;
                    assert_near(out[k * n + PRT_SH_INDEX(l, m)], cosine * (double)f[PRT_SH_INDEX(l, m)]
                                - sine * (double)f[PRT_SH_INDEX(l, -m)], BY_PRECISION(5e-7, 1e-15));
                }
    }
}

/* Blocks need not be a rotation's: bands scaled, some to nothing, means of two rotations, any numbers, one entry off by a
   little: all count as they are. */
static void many_vectors_take_blocks_as_they_are(void **state) {
    static const double scale[FACTORED] = { 3, -1e-3, 1e4, 0, 1, -1e-20, 1e20, 1e-6 };
    static factored_case c, other;
    double size[FACTORED];
    prt_real r[9];
    int l, i, trial, count = (int)prt_sh_rotation_count(FACTORED);
    (void)state;
    random_vector((int)(sizeof c.f / sizeof *c.f), c.f);
    for (trial = 0; trial < 2 * FACTORED; trial++) {
        random_rotation(r);
        assert_int_equal(prt_sh_rotation(FACTORED, r, c.blocks), PRT_OK);
        for (l = 0; l < FACTORED; l++) {
            double s = scale[(l + trial) % FACTORED];
            size[l] = fabs(s);
            for (i = (int)prt_sh_rotation_count(l); i < (int)prt_sh_rotation_count(l + 1); i++)
                c.blocks[i] = (prt_real)(s * (double)c.blocks[i]);
        }
        layouts_agree(FACTORED - trial % 5, &c, size, BY_PRECISION(2e-6, 4e-15));
    }
    random_rotation(r);
    assert_int_equal(prt_sh_rotation(FACTORED, r, other.blocks), PRT_OK);
    random_rotation(r);
    assert_int_equal(prt_sh_rotation(FACTORED, r, c.blocks), PRT_OK);
    for (i = 0; i < count; i++) other.blocks[i] = (other.blocks[i] + c.blocks[i]) / 2;
    memcpy(other.f, c.f, sizeof c.f);
    layouts_agree(FACTORED, &other, NULL, BY_PRECISION(2e-6, 4e-15));
    random_vector(count, other.blocks);
    layouts_agree(FACTORED, &other, NULL, BY_PRECISION(4e-6, 8e-15));
    for (i = 0; i < (int)prt_sh_rotation_count(6); i++) {
        prt_real as_it_was = c.blocks[i];
        c.blocks[i] += BY_PRECISION(1e-4f, 1e-12);
        layouts_agree(6, &c, NULL, BY_PRECISION(2e-6, 4e-15));
        c.blocks[i] = as_it_was;
    }
}

/* NaN in a block reaches the row that it stands in, and no other; large coefficients stay finite. */
static void blocks_with_nan_and_large_vectors(void **state) {
    static factored_case c;
    static prt_real out[SOME * 36];
    prt_real r[9];
    int l, i, k;
    (void)state;
    skip_if_fast_math();
    rotation_of_angles(pi / 2, 0.7, pi / 4, r);
    assert_int_equal(prt_sh_rotation(6, r, c.blocks), PRT_OK);
    random_vector((int)(sizeof c.f / sizeof *c.f), c.f);
    for (i = 0; i < SOME * 36; i++) c.f[i] *= PRT__R(1e28);
    assert_int_equal(prt_sh_rotate_by_n(6, c.blocks, SOME, c.f, out), PRT_OK);
    for (i = 0; i < SOME * 36; i++) assert_at_most(fabs((double)out[i]), 1e29);
    for (l = 1; l < 6; l++)
        for (i = 0; i <= 2 * l; i++) {
            prt_real *entry = &c.blocks[prt_sh_rotation_count(l) + (size_t)(i * (2 * l + 1) + i / 2)], as_it_was = *entry;
            *entry = (prt_real)NAN;
            assert_int_equal(prt_sh_rotate_by_n(6, c.blocks, SOME, c.f, out), PRT_OK);
            for (k = 0; k < SOME * 36; k++) assert_int_equal(out[k] != out[k], k % 36 == l * l + i);
            *entry = as_it_was;
        }
}

/* ---- one vector, one rotation ----------------------------------------------------------------------------------- */

static void rotation_about_z(double angle, prt_real r[9]) {
    prt_real c = (prt_real)cos(angle), s = (prt_real)sin(angle);
    r[0] = c; r[1] = -s; r[2] = 0; r[3] = s; r[4] = c; r[5] = 0; r[6] = 0; r[7] = 0; r[8] = 1;
}

static void one_shot_agrees_with_the_reference_table(void **state) {
    prt_real f[64], out[64];
    int c, bands, l, i, j;
    (void)state;
    read_golden();
    for (c = 0; c < golden_count; c++)
        for (bands = 1; bands <= 8; bands++) {
            random_vector(64, f);
            assert_int_equal(prt_sh_rotate(bands, golden[c].rotation, f, out), PRT_OK);
            for (l = 0; l < bands; l++)
                for (i = 0; i <= 2 * l; i++) {
                    double want = 0;
                    for (j = 0; j <= 2 * l; j++)
                        want += golden[c].blocks[l * (4 * l * l - 1) / 3 + i * (2 * l + 1) + j] * (double)f[l * l + j];
                    assert_near(out[l * l + i], want, BY_PRECISION(2e-6, 4e-15));
                }
        }
}

/* Tilts of every size from both poles, down to one that underflows when squared, and what lies between. */
static void one_shot_holds_near_the_poles(void **state) {
    static const double tilts[] = { 0, 1e-30, 1e-22, 1e-12, 1e-7, 3e-7, 1e-6, 1e-4, 1e-2, 0.5, 1.5707963267948966 };
    prt_real f[100], out[100], blocks[10 * 399 / 3];
    double want[100];
    size_t k;
    int pole, trial, i;
    (void)state;
    for (k = 0; k < sizeof tilts / sizeof *tilts; k++)
        for (pole = 0; pole < 2; pole++)
            for (trial = 0; trial < 20; trial++) {
                prt_real a[9], b[9], tilt[9] = { 1, 0, 0, 0, 0, 0, 0, 0, 0 }, r[9], part[9];
                double c = cos(tilts[k]), s = sin(tilts[k]);
                if (pole) c = -c;
                tilt[4] = (prt_real)c; tilt[5] = (prt_real)-s; tilt[7] = (prt_real)s; tilt[8] = (prt_real)c;
                rotation_about_z(3 * signed_uniform(), a);
                rotation_about_z(trial & 1 ? 0 : 3 * signed_uniform(), b);
                multiply(tilt, b, part);
                multiply(a, part, r);
                if (trial & 2) for (i = 0; i < 9; i++) r[i] = -r[i];
                random_vector(100, f);
                assert_int_equal(prt_sh_rotation(10, r, blocks), PRT_OK);
                plain_product(10, blocks, f, 1, want);
                assert_int_equal(prt_sh_rotate(8, r, f, out), PRT_OK);
                for (i = 0; i < 64; i++) assert_near(out[i], want[i], BY_PRECISION(2e-6, 4e-15));
                assert_int_equal(prt_sh_rotate(10, r, f, out), PRT_OK);
                for (i = 0; i < 100; i++) assert_near(out[i], want[i], BY_PRECISION(4e-6, 1e-14));
            }
}

/* Every number of bands against the blocks, in place too; reflections half of the time. */
static void one_shot_agrees_with_the_blocks(void **state) {
    static prt_real f[64 * 64], out[64 * 64];
    static double want[64 * 64];
    prt_real rotation[9], *blocks = new_array(prt_sh_rotation_count(64));
    int bands, trial, i;
    (void)state;
    for (bands = 1; bands <= 64; bands += bands < 12 ? 1 : 13)
        for (trial = 0; trial < 8; trial++) {
            double tolerance = bands <= 8 ? BY_PRECISION(2e-6, 4e-15) : BY_PRECISION(4e-7, 1e-15) * bands;
            random_rotation(rotation);
            if (trial & 1) for (i = 0; i < 9; i++) rotation[i] = -rotation[i];
            random_vector(bands * bands, f);
            assert_int_equal(prt_sh_rotation(bands, rotation, blocks), PRT_OK);
            plain_product(bands, blocks, f, 1, want);
            out[bands * bands < 64 * 64 ? bands * bands : 0] = 77;
            assert_int_equal(prt_sh_rotate(bands, rotation, f, out), PRT_OK);
            for (i = 0; i < bands * bands; i++) assert_near(out[i], want[i], tolerance);
            if (bands < 64) assert_near(out[bands * bands], 77, 0);
            assert_int_equal(prt_sh_rotate(bands, rotation, f, f), PRT_OK);
            assert_memory_equal(f, out, (size_t)(bands * bands) * sizeof *f);
        }
    free(blocks);
}

/* 1000 turns by 2 pi / 1000 come back: what drifts is the rounding of the matrix and of the constants, the same in
   every turn: 1000 * 5 bands * half a rounding error, 2^-25 (float) and 2^-54, is the scale of it. */
static void a_thousand_turns_return(void **state) {
    enum { BANDS = 6, N = 36 };
    prt_real f[N], g[N], h[N], r[9], blocks[286];
    int axis, k, i;
    (void)state;
    for (axis = 0; axis < 3; axis++) {
        double angle = 2 * PRT__PI / 1000;
        rotation_about_z(angle, r);
        if (axis) {                                             /* cyclic: about x, about y */
            prt_real turned_r[9];
            for (i = 0; i < 9; i++) turned_r[(i / 3 + axis) % 3 * 3 + (i % 3 + axis) % 3] = r[i];
            memcpy(r, turned_r, sizeof r);
        }
        random_vector(N, f);
        memcpy(g, f, sizeof f);
        memcpy(h, f, sizeof f);
        prt_sh_rotation(BANDS, r, blocks);
        for (k = 0; k < 1000; k++) {
            prt_sh_rotate(BANDS, r, g, g);
            prt_sh_rotate_by(BANDS, blocks, h, h);
        }
        assert_at_most(distance(N, f, g), BY_PRECISION(1e-4, 5e-13));
        assert_at_most(distance(N, f, h), BY_PRECISION(1e-4, 5e-13));
        if (axis == 0) {
            memcpy(g, f, sizeof f);
            for (k = 0; k < 1000; k++) prt_sh_rotate_z(BANDS, (prt_real)angle, g, g);
            assert_at_most(distance(N, f, g), BY_PRECISION(1e-4, 5e-13));
        }
    }
}

/* What a thousand turns by the matrix as it was rounded come to: the rotation beside R is one about n = curl R by
   atan2(|n|, trace R - 1), of which a thousand less a full turn are left. */
static void rest_of_a_thousand(const prt_real *r, prt_real *rest) {
    double n[3] = { (double)r[7] - (double)r[5], (double)r[2] - (double)r[6], (double)r[3] - (double)r[1] };
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), trace = (double)r[0] + (double)r[4] + (double)r[8];
    double half = 500 * atan2(length, trace - 1) - PRT__PI, s = sin(half) / length;
    prt_real q[4];
    q[0] = (prt_real)cos(half);
    q[1] = (prt_real)(n[0] * s);
    q[2] = (prt_real)(n[1] * s);
    q[3] = (prt_real)(n[2] * s);
    assert_int_equal(prt_rotation_from_quaternion(q, rest), PRT_OK);
}

/* R of a turn by 2 pi / 1000 about (x, y, z), and f turned so a thousand times in one shot */
static void turn_a_thousand_times(int bands, double x, double y, double z, prt_real *r, const prt_real *f, prt_real *g) {
    double s = sin(2 * PRT__PI / 1000), v = 2 * pow(sin(PRT__PI / 1000), 2);
    int k;
    r[0] = (prt_real)(1 - v * (y * y + z * z));
    r[4] = (prt_real)(1 - v * (x * x + z * z));
    r[8] = (prt_real)(1 - v * (x * x + y * y));
    r[1] = (prt_real)(v * x * y - s * z);
    r[2] = (prt_real)(v * x * z + s * y);
    r[3] = (prt_real)(v * x * y + s * z);
    r[5] = (prt_real)(v * y * z - s * x);
    r[6] = (prt_real)(v * x * z - s * y);
    r[7] = (prt_real)(v * y * z + s * x);
    memcpy(g, f, (size_t)(bands * bands) * sizeof *g);
    for (k = 0; k < 1000; k++) prt_sh_rotate(bands, r, g, g);
}

/* About axes all over the sphere, from 6 bands on: what is promised for 6 bands. It drifts by what is the same in every
   turn: the rounding of R, in l places, of the multiples of a and b, and of the two swaps, each half a rounding error a
   turn, 3e-5 in a thousand. In double nothing is worked out better than it is kept: 1000 turns, five steps, l places. */
static void a_thousand_turns_about_any_axis_return(void **state) {
    enum { AXES = 100 };
    prt_real f[64], g[64], r[9];
    int k, bands;
    (void)state;
    for (k = 0; k < AXES; k++) {
        double z = 1 - 2 * (k + 0.5) / AXES, xy = sqrt(1 - z * z), phi = 2.399963229728653 * k;
        bands = k % 10 ? 6 : 7 + k / 10 % 2;
        random_vector(bands * bands, f);
        turn_a_thousand_times(bands, xy * cos(phi), xy * sin(phi), z, r, f, g);
        assert_at_most(distance(bands * bands, f, g), BY_PRECISION(1e-4, 2e-12));
    }
}

/* In one shot at 5 bands, by tensors. The matrix was rounded, half a rounding error in l = 4 places, and its turns end
   elsewhere; from there it is our arithmetic: what stands in a tensor's four places is rounded three times, without SIMD
   five times on the way, the same in every turn. */
static void tensors_after_a_thousand_turns(void **state) {
    prt_real f[25], g[25], end[25], r[9], rest[9];
    int trial;
    (void)state;
    for (trial = 0; trial < 24; trial++) {
        prt_vec3 n = random_direction();
        double length = sqrt(dot(n, n));
        random_vector(25, f);
        turn_a_thousand_times(5, (double)n.x / length, (double)n.y / length, (double)n.z / length, r, f, g);
        rest_of_a_thousand(r, rest);
        assert_int_equal(prt_sh_rotate(5, rest, f, end), PRT_OK);
        assert_at_most(distance(25, f, end), BY_PRECISION(1.5e-4, 5e-13));
        assert_at_most(distance(25, end, g), BY_PRECISION(3.7e-4, 1.1e-12));
    }
}

/* ---- about z, and zonal functions ------------------------------------------------------------------------------- */

/* cos and sin of m*angle by MPFR: entry (m,m) of the block, whatever the band. */
static void z_rotation_agrees_with_mpfr(void **state) {
    enum { BANDS = 64, N = BANDS * BANDS };
    static prt_real f[N], out[N];
    static const double angles[] = { 0.7, -3.1, 100.25, 1e-5, 6.2831853071795864769 };
    mpfr_t x, c, s;
    size_t k;
    int l, m;
    (void)state;
    mpfr_inits2(200, x, c, s, (mpfr_ptr)0);
    random_vector(N, f);
    for (k = 0; k < sizeof angles / sizeof *angles; k++) {
        prt_real angle = (prt_real)angles[k];
        assert_int_equal(prt_sh_rotate_z(BANDS, angle, f, out), PRT_OK);
        for (m = 0; m < BANDS; m++) {
            double cm, sm;
            mpfr_set_d(x, (double)angle, MPFR_RNDN);
            mpfr_mul_si(x, x, m, MPFR_RNDN);
            mpfr_sin_cos(s, c, x, MPFR_RNDN);
            cm = mpfr_get_d(c, MPFR_RNDN);
            sm = mpfr_get_d(s, MPFR_RNDN);
            for (l = m; l < BANDS; l++) {
                double plus = (double)f[PRT_SH_INDEX(l, m)], minus = (double)f[PRT_SH_INDEX(l, -m)];
                if (m) assert_near(out[PRT_SH_INDEX(l, -m)], cm * minus + sm * plus, BY_PRECISION(3e-7, 2e-14));
                assert_near(out[PRT_SH_INDEX(l, m)], m ? cm * plus - sm * minus : plus, BY_PRECISION(3e-7, 2e-14));
            }
        }
    }
    mpfr_clears(x, c, s, (mpfr_ptr)0);
    assert_int_equal(prt_sh_rotate_z(BANDS, 1, f, out), PRT_OK);
    assert_int_equal(prt_sh_rotate_z(BANDS, 1, f, f), PRT_OK);
    assert_memory_equal(f, out, sizeof f);
}

/* A zonal function turned to an axis is the same as its full vector turned by a rotation that takes +z there. */
static void zonal_functions_follow_their_axis(void **state) {
    enum { BANDS = 9, N = BANDS * BANDS };
    prt_real zonal[BANDS], f[N], want[N], out[N], r[9];
    int trial, l;
    (void)state;
    for (trial = 0; trial < 20; trial++) {
        prt_vec3 z, axis;
        z.x = 0; z.y = 0; z.z = 1;
        random_rotation(r);
        axis = turned(r, z);
        random_vector(BANDS, zonal);
        memset(f, 0, sizeof f);
        for (l = 0; l < BANDS; l++) f[PRT_SH_INDEX(l, 0)] = zonal[l];
        assert_int_equal(prt_sh_rotate(BANDS, r, f, want), PRT_OK);
        assert_int_equal(prt_sh_zonal_to(BANDS, zonal, axis, out), PRT_OK);
        assert_at_most(distance(N, out, want), BY_PRECISION(2e-6, 6e-15));
        axis.x *= PRT__R(1.0009); axis.y *= PRT__R(1.0009); axis.z *= PRT__R(1.0009);
        assert_int_equal(prt_sh_zonal_to(BANDS, zonal, axis, out), PRT_OK);
        assert_at_most(distance(N, out, want), BY_PRECISION(2e-6, 4e-15));
    }
}

/* ---- what is refused -------------------------------------------------------------------------------------------- */

static void bad_matrices_are_refused_and_nothing_is_written(void **state) {
    enum { CASES = 12 };
    prt_real bad[CASES][9], good[9], f[256], out[256], blocks[5456];
    int c, i, bands;
    (void)state;
    random_rotation(good);
    random_vector(256, f);
    for (c = 0; c < CASES; c++) memcpy(bad[c], good, sizeof good);
    for (i = 0; i < 9; i++) {
        bad[0][i] *= PRT__R(1.001);                             /* scaled: R R^T - 1 = 2.001e-3 */
        bad[1][i] *= PRT__R(0.999);
        bad[2][i] = 0;
        bad[3][i] *= 2;
        bad[4][i] *= BY_PRECISION(1e30f, 1e200);                /* squares overflow */
    }
    for (i = 0; i < 3; i++) bad[5][i] += PRT__R(0.002) * bad[5][3 + i];         /* sheared */
    for (i = 0; i < 3; i++) bad[6][i] = bad[6][3 + i];                          /* two equal rows */
    bad[7][0] = (prt_real)NAN;
    bad[8][8] = (prt_real)NAN;
    bad[9][4] = (prt_real)INFINITY;
    bad[10][2] = (prt_real)-INFINITY;
    for (i = 0; i < 9; i++) bad[11][i] = (prt_real)NAN;
    for (c = 0; c < CASES; c++) {
        for (i = 0; i < 256; i++) out[i] = 77;
        for (i = 0; i < 5456; i++) blocks[i] = 77;
        for (bands = 1; bands <= 16; bands++) {
            assert_int_equal(prt_sh_rotation(bands, bad[c], blocks), PRT_ERR_ROTATION);
            assert_int_equal(prt_sh_rotate(bands, bad[c], f, out), PRT_ERR_ROTATION);
        }
        for (i = 0; i < 256; i++) assert_near(out[i], 77, 0);
        for (i = 0; i < 5456; i++) assert_near(blocks[i], 77, 0);
    }
    for (i = 0; i < 9; i++) bad[0][i] = good[i] * PRT__R(1.0004);               /* 8e-4 off: accepted */
    assert_int_equal(prt_sh_rotation(16, bad[0], blocks), PRT_OK);
    for (bands = 1; bands <= 16; bands++) assert_int_equal(prt_sh_rotate(bands, bad[0], f, out), PRT_OK);
}

static void bad_arguments_are_refused_and_nothing_is_written(void **state) {
    prt_real identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, f[16] = { 0 }, out[16], blocks[84];
    prt_vec3 z, far;
    int i, k;
    static const int bad_bands[] = { 0, -1, -2147483647 - 1, PRT_MAX_BANDS + 1, 2147483647 };
    (void)state;
    z.x = 0; z.y = 0; z.z = 1;
    far.x = 0; far.y = 0; far.z = 2;
    for (i = 0; i < 16; i++) out[i] = 77;
    assert_int_equal(prt_sh_rotation(4, identity, blocks), PRT_OK);
    for (k = 0; k < 5; k++) {
        int b = bad_bands[k];
        assert_int_equal((int)prt_sh_rotation_count(b), 0);
        assert_int_equal(prt_sh_rotation(b, identity, out), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_rotate(b, identity, f, out), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_rotate_by(b, blocks, f, out), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_rotate_by_n(b, blocks, 1, f, out), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_rotate_by_n_rgb(b, blocks, 1, f, out), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_rotate_by_soa(b, blocks, 1, f, out, 1), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_rotate_z(b, 1, f, out), PRT_ERR_BANDS);
        assert_int_equal(prt_sh_zonal_to(b, f, z, out), PRT_ERR_BANDS);
    }
    assert_int_equal(prt_sh_rotate_by_n(4, blocks, -1, f, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_rotate_by_n_rgb(4, blocks, -1, f, out), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_rotate_by_soa(4, blocks, -1, f, out, 1), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_rotate_by_soa(1, blocks, 3, f, out, 2), PRT_ERR_COUNT);
    assert_int_equal(prt_sh_rotate_by_n(4, NULL, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_sh_rotate_by_n_rgb(4, NULL, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_sh_rotate_by_soa(4, NULL, 0, NULL, NULL, 0), PRT_OK);
    assert_int_equal(prt_sh_rotation(4, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotation(4, identity, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate(4, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate(4, identity, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate(4, identity, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_by(4, NULL, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_by(4, blocks, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_by(4, blocks, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_by_n(4, NULL, 1, f, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_by_n(4, blocks, 1, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_by_n(4, blocks, 1, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_z(4, 1, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_z(4, 1, f, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_rotate_z(4, (prt_real)NAN, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_rotate_z(4, (prt_real)INFINITY, f, out), PRT_ERR_VALUE);
    assert_int_equal(prt_sh_zonal_to(4, NULL, z, out), PRT_ERR_NULL);
    assert_int_equal(prt_sh_zonal_to(4, f, z, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_sh_zonal_to(4, f, far, out), PRT_ERR_VALUE);
    far.z = (prt_real)NAN;
    assert_int_equal(prt_sh_zonal_to(4, f, far, out), PRT_ERR_VALUE);
    for (i = 0; i < 16; i++) assert_near(out[i], 77, 0);
}

/* A NaN stays in its band, in every form. */
static void nan_stays_in_its_band(void **state) {
    prt_real r[9], f[36], out[36], blocks[286];
    int bad, form, l, i;
    (void)state;
    skip_if_fast_math();
    random_rotation(r);
    prt_sh_rotation(6, r, blocks);
    for (bad = 0; bad < 36; bad++)
        for (form = 0; form < 3; form++) {
            random_vector(36, f);
            f[bad] = (prt_real)NAN;
            if (form == 0) assert_int_equal(prt_sh_rotate(6, r, f, out), PRT_OK);
            if (form == 1) assert_int_equal(prt_sh_rotate_by(6, blocks, f, out), PRT_OK);
            if (form == 2) assert_int_equal(prt_sh_rotate_by_n(6, blocks, 1, f, out), PRT_OK);
            for (l = 0; l < 6; l++)
                if (bad < l * l || bad >= (l + 1) * (l + 1))
                    for (i = l * l; i < (l + 1) * (l + 1); i++) assert_true(out[i] == out[i]);
                else assert_true(l > 0 || out[0] != out[0]);
        }
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
        cmocka_unit_test(the_published_recursion_explodes),
        cmocka_unit_test(blocks_turn_the_basis),
        cmocka_unit_test(blocks_compose_and_reflect),
        cmocka_unit_test(every_layout_is_the_plain_product),
        cmocka_unit_test(batches_are_bit_equal_to_their_parts),
        cmocka_unit_test(rows_are_bit_equal_to_their_parts),
        cmocka_unit_test(rows_pages_apart_are_the_same),
        cmocka_unit_test(many_vectors_take_hard_angles),
        cmocka_unit_test(quarter_turns_of_many_vectors_are_permutations),
        cmocka_unit_test(many_vectors_take_blocks_as_they_are),
        cmocka_unit_test(blocks_with_nan_and_large_vectors),
        cmocka_unit_test(one_shot_agrees_with_the_reference_table),
        cmocka_unit_test(one_shot_holds_near_the_poles),
        cmocka_unit_test(one_shot_agrees_with_the_blocks),
        cmocka_unit_test(a_thousand_turns_return),
        cmocka_unit_test(a_thousand_turns_about_any_axis_return),
        cmocka_unit_test(tensors_after_a_thousand_turns),
        cmocka_unit_test(z_rotation_agrees_with_mpfr),
        cmocka_unit_test(zonal_functions_follow_their_axis),
        cmocka_unit_test(bad_matrices_are_refused_and_nothing_is_written),
        cmocka_unit_test(bad_arguments_are_refused_and_nothing_is_written),
        cmocka_unit_test(nan_stays_in_its_band),
        cmocka_unit_test(quaternions_turn_as_documented),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
