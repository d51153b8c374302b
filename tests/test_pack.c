/* Room >>pack, and prt_shade_packed_n: transfer loses at 16 and 8 bits what the arithmetic of the format says. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
enum { POINTS = 61, MOST = PRT_SH_COUNT(PRT_MAX_BANDS) };
static prt_real transfer[POINTS * MOST], back[POINTS * MOST], light[3 * MOST], low[MOST], step[MOST];
static uint16_t data[POINTS * MOST];
static const prt_storage every[] = { PRT_STORAGE_HALF, PRT_STORAGE_16, PRT_STORAGE_8 };

/* Coefficient i keeps within a range of its own, some of them far from 0. */
static void fill(int n) {
    uint32_t seed = 1;
    int k, i;
    for (k = 0; k < POINTS; k++)
        for (i = 0; i < n; i++) {
            seed = seed * 1664525u + 1013904223u;
            transfer[k * n + i] = (prt_real)(((seed >> 8) / 16777216.0 * (1 + i % 5) - 0.5 * (i % 3)) / (1 + i));
        }
    for (i = 0; i < 3 * n; i++) light[i] = (prt_real)((i * 37 % 101 - 50) / 50.0);
}

/* The bound, from the values alone: half a step of 2^bits - 1 levels between least and largest; halves 2^-11 of the
   value, or 2^-25 where they are subnormal. */
static double bound(prt_storage storage, int n, int i, double value) {
    double least = (double)transfer[i], most = least, size;
    int k;
    for (k = 1; k < POINTS; k++) {
        double v = (double)transfer[k * n + i];
        if (v < least) least = v;
        if (v > most) most = v;
    }
    size = fabs(least) > fabs(most) ? fabs(least) : fabs(most);
    if (storage == PRT_STORAGE_HALF) return fmax(fabs(value) * 0x1p-11, 0x1p-25);
    return (most - least) / (storage == PRT_STORAGE_16 ? 65535 : 255) / 2 + 2 * EPS * size;
}

static void comes_back_within_half_a_step(void **state) {
    prt_packed_transfer packed;
    int s, bands, k, i, n;
    (void)state;
    for (s = 0; s < 3; s++)
        for (bands = 1; bands <= PRT_MAX_BANDS; bands += bands < 11 ? 1 : 21) {
            n = bands * bands;
            fill(n);
            assert_int_equal(prt_transfer_packed_size(bands, every[s], POINTS),
                             (size_t)POINTS * (size_t)n * (every[s] == PRT_STORAGE_8 ? 1 : 2));
            assert_int_equal(prt_transfer_pack(bands, every[s], POINTS, transfer, data, low, step, &packed), PRT_OK);
            assert_int_equal(prt_transfer_unpack(&packed, 0, POINTS, back), PRT_OK);
            for (k = 0; k < POINTS; k++)
                for (i = 0; i < n; i++) {
                    double v = (double)transfer[k * n + i];
                    assert_near(back[k * n + i], v, bound(every[s], n, i, v));
                }
        }
}

static void shades_as_what_is_stored(void **state) {
    static prt_rgb out[POINTS], part[POINTS];
    prt_packed_transfer packed;
    int s, bands, k, c, i, n;
    (void)state;
    for (s = 0; s < 3; s++)
        for (bands = 1; bands <= 12; bands++) {
            n = bands * bands;
            fill(n);
            assert_int_equal(prt_transfer_pack(bands, every[s], POINTS, transfer, data, low, step, &packed), PRT_OK);
            assert_int_equal(prt_transfer_unpack(&packed, 0, POINTS, back), PRT_OK);
            assert_int_equal(prt_shade_packed_n(&packed, 0, POINTS, light, out), PRT_OK);
            for (k = 0; k < POINTS; k++) {
                const prt_real got[3] = { out[k].r, out[k].g, out[k].b };
                for (c = 0; c < 3; c++) {
                    double want = 0, size = 0;
                    for (i = 0; i < n; i++) {
                        double l = (double)light[c * n + i];
                        double top = every[s] == PRT_STORAGE_HALF ? (double)back[k * n + i]
                                     : (double)low[i] + (double)step[i] * (every[s] == PRT_STORAGE_16 ? 65535 : 255);
                        want += (double)back[k * n + i] * l;
                        size += (fabs((double)low[i] * (every[s] != PRT_STORAGE_HALF)) + fabs(top)) * fabs(l);
                    }
                    assert_near(got[c], want, (n / 8 + 8) * EPS * size);
                }
            }
            assert_int_equal(prt_shade_packed_n(&packed, 7, 1, light, part), PRT_OK);
            if (!FAST_MATH) assert_memory_equal(&part[7], &out[7], sizeof *out);
        }
}

/* Bits of IEEE 754 binary16, from its definition. */
static void halves_are_ieee(void **state) {
    static const struct { double value; unsigned bits; } known[] = {
        { 0, 0 }, { 1, 0x3c00 }, { -2, 0xc000 }, { 65504, 0x7bff }, { -65504, 0xfbff }, { 0x1p-24, 1 },
        { 0x1p-14, 0x0400 }, { 0x1p-14 - 0x1p-24, 0x03ff }, { 1 + 0x1p-10, 0x3c01 }, { 1 + 0x1p-11, 0x3c00 },
        { 1 + 0x3p-11, 0x3c02 }, { 0x1p-25, 0 }, { 0x3p-25, 2 }
    };
    enum { COUNT = sizeof known / sizeof *known };
    prt_packed_transfer packed;
    prt_real v[COUNT];
    uint16_t bits[COUNT];
    int k;
    (void)state;
    for (k = 0; k < COUNT; k++) v[k] = (prt_real)known[k].value;
    assert_int_equal(prt_transfer_pack(1, PRT_STORAGE_HALF, COUNT, v, bits, NULL, NULL, &packed), PRT_OK);
    for (k = 0; k < COUNT; k++) assert_int_equal(bits[k], known[k].bits);
    assert_int_equal(prt_transfer_unpack(&packed, 0, COUNT, back), PRT_OK);
    for (k = 0; k < COUNT; k++) assert_near(back[k], known[k].value, fmax(fabs(known[k].value) * 0x1p-11, 0x1p-25));
}

static void one_value_for_all_is_exact(void **state) {
    const prt_real same[3 * 4] = { 7, (prt_real)-0.1, 0, 1, 7, (prt_real)-0.1, 0, 1, 7, (prt_real)-0.1, 0, 1 };
    prt_packed_transfer packed;
    int s, i;
    (void)state;
    for (s = 1; s < 3; s++) {
        assert_int_equal(prt_transfer_pack(2, every[s], 3, same, data, low, step, &packed), PRT_OK);
        assert_int_equal(prt_transfer_unpack(&packed, 0, 3, back), PRT_OK);
        for (i = 0; i < 12; i++) assert_near(back[i], same[i], 0);
    }
    for (i = 0; i < 3; i++) transfer[i] = (i == 1 ? -1 : 1) * (PRT__REAL_MAX / 4);     /* the widest range there is */
    assert_int_equal(prt_transfer_pack(1, PRT_STORAGE_16, 3, transfer, data, low, step, &packed), PRT_OK);
    assert_int_equal(prt_transfer_unpack(&packed, 0, 3, back), PRT_OK);
    assert_near(back[0] / transfer[0], 1, 4 * EPS);
    assert_near(back[1] / transfer[1], 1, 4 * EPS);
    transfer[2] = PRT__REAL_MAX;
    assert_int_equal(prt_transfer_pack(1, PRT_STORAGE_8, 3, transfer, data, low, step, &packed), PRT_ERR_VALUE);
}

static void bad_arguments_write_nothing(void **state) {
    const unsigned char untouched[8] = { 5, 5, 5, 5, 5, 5, 5, 5 };
    unsigned char bytes[8] = { 5, 5, 5, 5, 5, 5, 5, 5 };
    prt_real t[8] = { 1, 2, 3, 4, 5, 6, 7, 8 }, l[12] = { 0 }, lo[4] = { 9, 9, 9, 9 }, st[4] = { 9, 9, 9, 9 };
    const prt_storage none = (prt_storage)3;
    prt_rgb out[2] = { { 3, 3, 3 }, { 3, 3, 3 } };
    prt_packed_transfer p, q;
    (void)state;
    assert_int_equal(prt_transfer_packed_size(0, PRT_STORAGE_8, 2), 0);
    assert_int_equal(prt_transfer_packed_size(2, none, 2), 0);
    assert_int_equal(prt_transfer_packed_size(2, PRT_STORAGE_8, -1), 0);
    assert_int_equal(prt_transfer_pack(0, PRT_STORAGE_8, 2, t, bytes, lo, st, &p), PRT_ERR_BANDS);
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, -1, t, bytes, lo, st, &p), PRT_ERR_COUNT);
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, 2, NULL, bytes, lo, st, &p), PRT_ERR_NULL);
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, 2, t, NULL, lo, st, &p), PRT_ERR_NULL);
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, 2, t, bytes, NULL, st, &p), PRT_ERR_NULL);
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_16, 2, t, bytes, lo, NULL, &p), PRT_ERR_NULL);
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, 2, t, bytes, lo, st, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_transfer_pack(2, none, 2, t, bytes, lo, st, &p), PRT_ERR_VALUE);
    t[5] = 65536;
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_HALF, 2, t, bytes, lo, st, &p), PRT_ERR_VALUE);
    if (!FAST_MATH) {
        t[5] = (prt_real)NAN;
        assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, 2, t, bytes, lo, st, &p), PRT_ERR_VALUE);
    }
    assert_memory_equal(bytes, untouched, sizeof bytes);
    assert_near(lo[0] + st[3], 18, 0);
    t[5] = 6;
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, 0, NULL, NULL, lo, st, &p), PRT_OK);
    assert_int_equal(prt_transfer_pack(2, PRT_STORAGE_8, 2, t, bytes, lo, st, &p), PRT_OK);
    assert_int_equal(prt_shade_packed_n(NULL, 0, 2, l, out), PRT_ERR_NULL);
    q = p; q.bands = PRT_MAX_BANDS + 1;
    assert_int_equal(prt_shade_packed_n(&q, 0, 2, l, out), PRT_ERR_BANDS);
    assert_int_equal(prt_shade_packed_n(&p, -1, 2, l, out), PRT_ERR_COUNT);
    assert_int_equal(prt_shade_packed_n(&p, 0, -1, l, out), PRT_ERR_COUNT);
    assert_int_equal(prt_shade_packed_n(&p, 0, 2, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_shade_packed_n(&p, 0, 2, l, NULL), PRT_ERR_NULL);
    q = p; q.data = NULL;
    assert_int_equal(prt_shade_packed_n(&q, 0, 2, l, out), PRT_ERR_NULL);
    q = p; q.low = NULL;
    assert_int_equal(prt_shade_packed_n(&q, 0, 2, l, out), PRT_ERR_NULL);
    q = p; q.storage = none;
    assert_int_equal(prt_shade_packed_n(&q, 0, 2, l, out), PRT_ERR_VALUE);
    assert_int_equal(prt_transfer_unpack(&q, 0, 2, back), PRT_ERR_VALUE);
    assert_int_equal(prt_transfer_unpack(&p, 0, 2, NULL), PRT_ERR_NULL);
    assert_near(out[0].r + out[1].b, 6, 0);
    assert_int_equal(prt_shade_packed_n(&p, 0, 0, NULL, NULL), PRT_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(comes_back_within_half_a_step),
        cmocka_unit_test(shades_as_what_is_stored),
        cmocka_unit_test(halves_are_ieee),
        cmocka_unit_test(one_value_for_all_is_exact),
        cmocka_unit_test(bad_arguments_write_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
