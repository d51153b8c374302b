/* The file format of baked transfer: the bytes that the description promises, every kind of damage, full disks. */
#define _XOPEN_SOURCE 700
#include "test.h"
#include "../examples/common/program.c"
#include "../examples/common/replacement.c"
#include "../examples/common/transfer_file.c"
#include "../examples/common/why.c"

#include <signal.h>
#include <sys/resource.h>

enum { POINTS = 9, ROW = 4, BYTES = 64 + 16 + 3 * 16 + 16 + 2 * 16 + 8 };

static const transfer_info golden_info = { 2, 1024, 0.5f, UINT64_C(0x0123456789ABCDEF), POINTS,
                                           UINT64_C(0xFEDCBA9876543210) };
static const unsigned char golden_done[POINTS] = { 0, 1, 1, 1, 0, 0, 1, 1, 0 };

static float golden_value(int i) { return 0.25f * (float)i - 3; }

static size_t slurp(const char *path, unsigned char *bytes, size_t capacity) {
    FILE *file = fopen(path, "rb");
    size_t size;
    assert_non_null(file);
    size = fread(bytes, 1, capacity, file);
    fclose(file);
    return size;
}

static void golden_bytes(unsigned char bytes[BYTES]) {
    assert_int_equal(slurp(PRT_GOLDEN_DIR "/transfer_v1.prt", bytes, BYTES), BYTES);
}

static int read_from(const void *bytes, size_t size, const transfer_info *expected, unsigned char *done,
                     float *transfer, why *w) {
    FILE *file = fmemopen((void *)(uintptr_t)bytes, size, "rb");
    int result;
    assert_non_null(file);
    result = transfer_file_read(file, "memory", expected, done, transfer, w);
    fclose(file);
    return result;
}

/* A directory that is this test's own. */
static int set_up(void **state) {
    static char directory[512];
    *state = directory;
    return make_temporary_directory("test_transfer_file", directory, sizeof directory);
}
static int remove_directory(void **state) { return rmdir((char *)*state); }

static void reads_the_golden_file(void **state) {
    float transfer[POINTS * ROW];
    unsigned char done[POINTS];
    transfer_info info;
    why w;
    int i;
    (void)state;
    for (i = 0; i < POINTS * ROW; i++) transfer[i] = 77;
    assert_int_equal(transfer_file_info(PRT_GOLDEN_DIR "/transfer_v1.prt", &info, &w), 0);
    assert_int_equal(info.bands, 2);
    assert_int_equal(info.rays, 1024);
    assert_near(info.bias, 0.5, 0);
    assert_true(info.seed == golden_info.seed && info.mesh_hash == golden_info.mesh_hash);
    assert_true(info.point_count == POINTS);
    assert_int_equal(transfer_file_load(PRT_GOLDEN_DIR "/transfer_v1.prt", &golden_info, done, transfer, &w), 0);
    assert_memory_equal(done, golden_done, POINTS);
    for (i = 0; i < POINTS * ROW; i++) assert_near(transfer[i], done[i / ROW] ? golden_value(i) : 77, 0);
}

static void writes_the_golden_file(void **state) {
    char path[256];
    float transfer[POINTS * ROW];
    unsigned char want[BYTES], got[BYTES + 1];
    why w;
    int i;
    golden_bytes(want);
    for (i = 0; i < POINTS * ROW; i++) transfer[i] = golden_value(i);
    snprintf(path, sizeof path, "%s/golden.prt", (char *)*state);
    assert_int_equal(transfer_file_save(path, &golden_info, golden_done, transfer, &w), 0);
    assert_int_equal(slurp(path, got, sizeof got), BYTES);
    assert_memory_equal(got, want, BYTES);
    assert_int_equal(unlink(path), 0);
}

static void size_of_a_complete_file(void **state) {
    transfer_info info = golden_info;
    (void)state;
    assert_int_equal(transfer_file_bytes(&info), 64 + 16 + POINTS * 16 + 8);
    info.bands = 1024;
    info.point_count = UINT64_C(1) << 62;
    assert_int_equal(transfer_file_bytes(&info), 0);
    info.bands = 0xFFFFFFFFu;
    assert_int_equal(transfer_file_bytes(&info), 0);
}

static void nothing_done_is_a_file_too(void **state) {
    unsigned char none[POINTS] = { 0 }, done[POINTS], bytes[512];
    float transfer[POINTS * ROW] = { 0 };
    why w;
    FILE *file = fmemopen(bytes, sizeof bytes, "wb");
    (void)state;
    assert_int_equal(transfer_file_write(file, "memory", &golden_info, none, transfer, &w), 0);
    fclose(file);
    assert_int_equal(read_from(bytes, 72, &golden_info, done, transfer, &w), 0);
    assert_memory_equal(done, none, POINTS);
}

static void refused(const void *bytes, size_t size, const transfer_info *expected) {
    static const unsigned char none[POINTS] = { 0 };
    unsigned char done[POINTS];
    float transfer[POINTS * ROW];
    why w;
    w.line[0] = 0;
    memset(done, 1, sizeof done);
    assert_int_equal(read_from(bytes, size, expected, done, transfer, &w), -1);
    assert_memory_equal(done, none, (size_t)expected->point_count);
    assert_non_null(strstr(w.line, "memory: "));
    assert_null(strchr(w.line, '\n'));
}

static void refuses_every_truncation(void **state) {
    unsigned char bytes[BYTES];
    size_t size;
    (void)state;
    golden_bytes(bytes);
    for (size = 1; size < BYTES; size++) refused(bytes, size, &golden_info);
}

static void refuses_every_flipped_bit(void **state) {
    unsigned char bytes[BYTES];
    int i;
    (void)state;
    golden_bytes(bytes);
    for (i = 0; i < BYTES * 8; i++) {
        bytes[i / 8] = (unsigned char)(bytes[i / 8] ^ (1 << i % 8));
        refused(bytes, BYTES, &golden_info);
        bytes[i / 8] = (unsigned char)(bytes[i / 8] ^ (1 << i % 8));
    }
}

static void refuses_trailing_bytes(void **state) {
    unsigned char bytes[BYTES + 1] = { 0 };
    (void)state;
    golden_bytes(bytes);
    refused(bytes, BYTES + 1, &golden_info);
}

/* Makes both checksums of a file that a test has altered right again. */
static void seal(unsigned char *bytes, size_t size) {
    put64(bytes + 56, transfer_checksum(TRANSFER_CHECKSUM_START, bytes, 56));
    put64(bytes + size - 8, transfer_checksum(TRANSFER_CHECKSUM_START, bytes, size - 8));
}

/* Lies told with right checksums: huge counts, runs outside the mesh, overlapping, touching, empty; NaN, infinity. */
static void refuses_sealed_lies(void **state) {
    static const struct { int at; uint64_t value; } lies[] = {
        { 48, 1 }, { 48, 3 }, { 48, UINT64_C(1) << 63 },                    /* runs */
        { 64, 7 }, { 64, 9 }, { 64, UINT64_MAX },                           /* first of run 0 */
        { 72, 0 }, { 72, 4 }, { 72, 9 }, { 72, UINT64_MAX },                /* count of run 0 */
        { 128, 0 }, { 128, 3 }, { 128, 4 }, { 128, 8 }, { 128, 9 },         /* first of run 1; 4 touches run 0 */
        { 136, 0 }, { 136, 4 }, { 136, UINT64_MAX - 5 }
    };
    unsigned char bytes[BYTES];
    size_t k;
    (void)state;
    for (k = 0; k < sizeof lies / sizeof *lies; k++) {
        golden_bytes(bytes);
        put64(bytes + lies[k].at, lies[k].value);
        seal(bytes, BYTES);
        refused(bytes, BYTES, &golden_info);
    }
    for (k = 0; k < 3; k++) {
        static const uint32_t not_finite[3] = { 0x7fc00000u, 0x7f800000u, 0xff800000u };
        golden_bytes(bytes);
        put32(bytes + 84, not_finite[k]);
        seal(bytes, BYTES);
        refused(bytes, BYTES, &golden_info);
    }
}

static void refuses_lying_headers(void **state) {
    static const struct { int at; uint32_t value; } lies[] = {
        { 8, 0 }, { 8, 2 }, { 12, 0 }, { 12, 1025 }, { 12, 0xFFFFFFFFu }, { 20, 0x7fc00000u }, { 36, 0x80000000u }
    };
    unsigned char bytes[BYTES];
    size_t k;
    (void)state;
    for (k = 0; k < sizeof lies / sizeof *lies; k++) {
        transfer_info info;
        why w;
        FILE *file;
        golden_bytes(bytes);
        put32(bytes + lies[k].at, lies[k].value);
        seal(bytes, BYTES);
        file = fmemopen(bytes, BYTES, "rb");
        assert_int_equal(transfer_file_read_info(file, "memory", &info, &w), -1);
        fclose(file);
    }
}

static void refuses_another_bake(void **state) {
    unsigned char bytes[BYTES];
    transfer_info other[6];
    int k;
    (void)state;
    golden_bytes(bytes);
    for (k = 0; k < 6; k++) other[k] = golden_info;
    other[0].bands = 1;
    other[1].rays = 1023;
    other[2].bias = 0.25f;
    other[3].seed++;
    other[4].point_count = 8;
    other[5].mesh_hash++;
    for (k = 0; k < 6; k++) refused(bytes, BYTES, &other[k]);
}

static void a_missing_file_is_one_line(void **state) {
    unsigned char done[POINTS];
    float transfer[POINTS * ROW];
    transfer_info info;
    why w;
    (void)state;
    assert_int_equal(transfer_file_load("/nonexistent/x.prt", &golden_info, done, transfer, &w), -1);
    assert_string_equal(w.line, "/nonexistent/x.prt: cannot be opened: No such file or directory");
    assert_int_equal(transfer_file_info("/nonexistent/x.prt", &info, &w), -1);
    assert_int_equal(transfer_file_info(".", &info, &w), -1);
    assert_int_equal(transfer_file_save("/nonexistent/x.prt", &golden_info, golden_done, transfer, &w), -1);
    assert_string_equal(w.line, "/nonexistent/x.prt: cannot be created: No such file or directory");
    assert_int_equal(replacement_possible("/nonexistent/x.prt", 100, &w), -1);
}

/* /dev/full takes nothing: a failed write is noticed even where only the flush fails. */
static void a_full_device_is_noticed(void **state) {
    FILE *file = fopen("/dev/full", "wb");
    float transfer[POINTS * ROW] = { 0 };
    why w;
    (void)state;
    if (!file) skip();
    setvbuf(file, NULL, _IONBF, 0);
    assert_int_equal(transfer_file_write(file, "/dev/full", &golden_info, golden_done, transfer, &w), -1);
    assert_string_equal(w.line, "/dev/full: cannot be written: No space left on device");
    fclose(file);
}

/* No room for the new file: the old one stays as it was, and nothing else is left in the directory. */
static void a_full_disk_leaves_the_old_file(void **state) {
    enum { MANY = 4096 };
    static float transfer[MANY * ROW];
    static unsigned char done[MANY];
    transfer_info info = golden_info;
    unsigned char want[BYTES], got[BYTES + 1];
    struct rlimit limit, old_limit;
    char path[256];
    why w;
    int i;
    golden_bytes(want);
    for (i = 0; i < POINTS * ROW; i++) transfer[i] = golden_value(i);
    snprintf(path, sizeof path, "%s/kept.prt", (char *)*state);
    assert_int_equal(transfer_file_save(path, &golden_info, golden_done, transfer, &w), 0);

    info.point_count = MANY;
    memset(done, 1, sizeof done);
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
    limit = old_limit;
    limit.rlim_cur = 4096;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
    i = transfer_file_save(path, &info, done, transfer, &w);
    assert_int_equal(replacement_possible(path, 4000, &w), 0);
    assert_int_equal(replacement_possible(path, 5000, &w), -1);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &old_limit), 0);

    assert_int_equal(i, -1);
    assert_non_null(strstr(w.line, "File too large"));
    assert_int_equal(slurp(path, got, sizeof got), BYTES);
    assert_memory_equal(got, want, BYTES);
    assert_int_equal(unlink(path), 0);                              /* the group's teardown finds the directory empty */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_the_golden_file),
        cmocka_unit_test(writes_the_golden_file),
        cmocka_unit_test(size_of_a_complete_file),
        cmocka_unit_test(nothing_done_is_a_file_too),
        cmocka_unit_test(refuses_every_truncation),
        cmocka_unit_test(refuses_every_flipped_bit),
        cmocka_unit_test(refuses_trailing_bytes),
        cmocka_unit_test(refuses_sealed_lies),
        cmocka_unit_test(refuses_lying_headers),
        cmocka_unit_test(refuses_another_bake),
        cmocka_unit_test(a_missing_file_is_one_line),
        cmocka_unit_test(a_full_device_is_noticed),
        cmocka_unit_test(a_full_disk_leaves_the_old_file)
    };
    return cmocka_run_group_tests(tests, set_up, remove_directory);
}
