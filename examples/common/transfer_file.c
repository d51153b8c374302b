#include "transfer_file.h"

#include <errno.h>
#include <inttypes.h>
#include <string.h>

#include "replacement.h"

static const unsigned char transfer_magic[8] = { 0x89, 'P', 'R', 'T', '\r', '\n', 0x1a, '\n' };

uint64_t transfer_checksum(uint64_t hash, const void *bytes, size_t count) {
    const unsigned char *p = (const unsigned char *)bytes;
    size_t i;
    for (i = 0; i < count; i++) hash = (hash ^ p[i]) * UINT64_C(1099511628211);
    return hash;
}

static void put32(unsigned char *p, uint32_t v) {
    int i;
    for (i = 0; i < 4; i++) p[i] = (unsigned char)(v >> (8 * i));
}
static void put64(unsigned char *p, uint64_t v) {
    put32(p, (uint32_t)v);
    put32(p + 4, (uint32_t)(v >> 32));
}
static uint32_t get32(const unsigned char *p) {
    return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}
static uint64_t get64(const unsigned char *p) { return get32(p) | (uint64_t)get32(p + 4) << 32; }

static uint32_t float_bits(float v) { uint32_t u; memcpy(&u, &v, 4); return u; }
static float bits_float(uint32_t u) { float v; memcpy(&v, &u, 4); return v; }
static int bits_finite(uint32_t u) { return (u >> 23 & 255) != 255; }

/* A stream with the checksum of what went through it. */
typedef struct checked_stream { FILE *file; const char *name; uint64_t hash; why *w; } checked_stream;

static int write_failed(checked_stream *s) {
    return why_set(s->w, "%s: cannot be written: %s", s->name, strerror(errno));
}

static int write_bytes(checked_stream *s, const void *bytes, size_t count) {
    s->hash = transfer_checksum(s->hash, bytes, count);
    return fwrite(bytes, 1, count, s->file) == count ? 0 : write_failed(s);
}

static int read_bytes(checked_stream *s, void *bytes, size_t count) {
    if (fread(bytes, 1, count, s->file) != count) {
        if (ferror(s->file)) return why_set(s->w, "%s: cannot be read: %s", s->name, strerror(errno));
        return why_set(s->w, "%s: ends too early; it was cut short or is not a transfer file: bake again", s->name);
    }
    s->hash = transfer_checksum(s->hash, bytes, count);
    return 0;
}

/* ---- writing ---- */

/* The next run of finished points at or after `at`; 0 where there is none. */
static int next_run(const unsigned char *done, uint64_t point_count, uint64_t at, uint64_t *first, uint64_t *count) {
    while (at < point_count && !done[at]) at++;
    *first = at;
    while (at < point_count && done[at]) at++;
    *count = at - *first;
    return *count > 0;
}

static uint64_t count_runs(const unsigned char *done, uint64_t point_count) {
    uint64_t runs = 0, first = 0, count = 0;
    while (next_run(done, point_count, first + count, &first, &count)) runs++;
    return runs;
}

static void pack_header(const transfer_info *info, uint64_t runs, unsigned char header[TRANSFER_FILE_HEADER_BYTES]) {
    memcpy(header, transfer_magic, 8);
    put32(header + 8, TRANSFER_FILE_VERSION);
    put32(header + 12, info->bands);
    put32(header + 16, info->rays);
    put32(header + 20, float_bits(info->bias));
    put64(header + 24, info->seed);
    put64(header + 32, info->point_count);
    put64(header + 40, info->mesh_hash);
    put64(header + 48, runs);
    put64(header + 56, transfer_checksum(TRANSFER_CHECKSUM_START, header, 56));
}

static int write_floats(checked_stream *s, const float *values, uint64_t count) {
    unsigned char packed[4096];
    while (count > 0) {
        size_t i, part = count < sizeof packed / 4 ? (size_t)count : sizeof packed / 4;
        for (i = 0; i < part; i++) put32(packed + 4 * i, float_bits(values[i]));
        if (write_bytes(s, packed, 4 * part)) return -1;
        values += part;
        count -= part;
    }
    return 0;
}

int transfer_file_write(FILE *file, const char *name, const transfer_info *info, const unsigned char *done,
                        const float *transfer, why *w) {
    checked_stream s = { NULL, NULL, TRANSFER_CHECKSUM_START, NULL };
    unsigned char bytes[TRANSFER_FILE_HEADER_BYTES];
    uint64_t row = (uint64_t)info->bands * info->bands, first = 0, count = 0;
    s.file = file; s.name = name; s.w = w;
    pack_header(info, count_runs(done, info->point_count), bytes);
    if (write_bytes(&s, bytes, TRANSFER_FILE_HEADER_BYTES)) return -1;
    while (next_run(done, info->point_count, first + count, &first, &count)) {
        put64(bytes, first);
        put64(bytes + 8, count);
        if (write_bytes(&s, bytes, 16) || write_floats(&s, transfer + first * row, count * row)) return -1;
    }
    put64(bytes, s.hash);
    return write_bytes(&s, bytes, 8);
}

uint64_t transfer_file_bytes(const transfer_info *info) {
    uint64_t row = 4 * (uint64_t)info->bands * info->bands;
    if (info->bands > TRANSFER_FILE_MAX_BANDS || (row && info->point_count > (UINT64_MAX / 2 - 4096) / row)) return 0;
    return TRANSFER_FILE_HEADER_BYTES + 16 + info->point_count * row + 8;
}

int transfer_file_save(const char *path, const transfer_info *info, const unsigned char *done, const float *transfer,
                       why *w) {
    replacement r;
    if (replacement_open(path, &r, w)) return -1;
    if (transfer_file_write(r.file, path, info, done, transfer, w)) {
        replacement_abandon(&r);
        return -1;
    }
    return replacement_commit(&r, w);
}

/* ---- reading ---- */

static int unpack_header(checked_stream *s, transfer_info *info, uint64_t *runs) {
    unsigned char header[TRANSFER_FILE_HEADER_BYTES];
    if (read_bytes(s, header, sizeof header)) return -1;
    if (memcmp(header, transfer_magic, 8)) return why_set(s->w, "%s: is not a transfer file", s->name);
    if (get32(header + 8) != TRANSFER_FILE_VERSION)
        return why_set(s->w, "%s: has version %" PRIu32 " of the format; this program reads version %d", s->name,
                       get32(header + 8), TRANSFER_FILE_VERSION);
    if (get64(header + 56) != transfer_checksum(TRANSFER_CHECKSUM_START, header, 56))
        return why_set(s->w, "%s: its header is damaged (wrong checksum): bake again", s->name);
    info->bands = get32(header + 12);
    info->rays = get32(header + 16);
    info->bias = bits_float(get32(header + 20));
    info->seed = get64(header + 24);
    info->point_count = get64(header + 32);
    info->mesh_hash = get64(header + 40);
    *runs = get64(header + 48);
    if (info->bands < 1 || info->bands > TRANSFER_FILE_MAX_BANDS || !bits_finite(get32(header + 20)) ||
        *runs > info->point_count || !transfer_file_bytes(info))
        return why_set(s->w, "%s: its header holds impossible values: bake again", s->name);
    return 0;
}

static int compare_info(const char *name, const transfer_info *got, const transfer_info *want, why *w) {
    if (got->point_count != want->point_count || got->mesh_hash != want->mesh_hash)
        return why_set(w, "%s: was baked for another mesh: bake again without --resume", name);
    if (got->bands != want->bands)
        return why_set(w, "%s: was baked with %" PRIu32 " bands, not %" PRIu32 ": ask for those, or bake again without "
                       "--resume", name, got->bands, want->bands);
    if (got->rays != want->rays)
        return why_set(w, "%s: was baked with %" PRIu32 " rays, not %" PRIu32 ": ask for those, or bake again without "
                       "--resume", name, got->rays, want->rays);
    if (got->seed != want->seed)
        return why_set(w, "%s: was baked with seed %" PRIu64 ", not %" PRIu64 ": ask for that, or bake again without "
                       "--resume", name, got->seed, want->seed);
    if (float_bits(got->bias) != float_bits(want->bias))
        return why_set(w, "%s: was baked with bias %g, not %g: bake again without --resume", name, (double)got->bias,
                       (double)want->bias);
    return 0;
}

static int read_floats(checked_stream *s, float *values, uint64_t count) {
    unsigned char packed[4096];
    while (count > 0) {
        size_t i, part = count < sizeof packed / 4 ? (size_t)count : sizeof packed / 4;
        if (read_bytes(s, packed, 4 * part)) return -1;
        for (i = 0; i < part; i++) {
            uint32_t bits = get32(packed + 4 * i);
            if (!bits_finite(bits)) return why_set(s->w, "%s: holds a number that is not finite: bake again", s->name);
            values[i] = bits_float(bits);
        }
        values += part;
        count -= part;
    }
    return 0;
}

static int read_runs(checked_stream *s, const transfer_info *info, uint64_t runs, unsigned char *done,
                     float *transfer) {
    uint64_t row = (uint64_t)info->bands * info->bands, k, free_from = 0;
    for (k = 0; k < runs; k++) {
        unsigned char range[16];
        uint64_t first, count;
        if (read_bytes(s, range, 16)) return -1;
        first = get64(range);
        count = get64(range + 8);
        if (first < free_from || first >= info->point_count || count < 1 || count > info->point_count - first)
            return why_set(s->w, "%s: run %" PRIu64 " of its points is impossible: bake again", s->name, k);
        if (read_floats(s, transfer + first * row, count * row)) return -1;
        memset(done + first, 1, (size_t)count);
        free_from = first + count + 1;                              /* touching runs would be one run */
    }
    return 0;
}

static int read_end(checked_stream *s) {
    uint64_t hash = s->hash;
    unsigned char bytes[8];
    if (read_bytes(s, bytes, 8)) return -1;
    if (get64(bytes) != hash) return why_set(s->w, "%s: is damaged (wrong checksum): bake again", s->name);
    if (fgetc(s->file) != EOF) return why_set(s->w, "%s: goes on after its end: bake again", s->name);
    return 0;
}

int transfer_file_read_info(FILE *file, const char *name, transfer_info *info, why *w) {
    checked_stream s = { NULL, NULL, TRANSFER_CHECKSUM_START, NULL };
    uint64_t runs;
    s.file = file; s.name = name; s.w = w;
    return unpack_header(&s, info, &runs);
}

int transfer_file_read(FILE *file, const char *name, const transfer_info *expected, unsigned char *done,
                       float *transfer, why *w) {
    checked_stream s = { NULL, NULL, TRANSFER_CHECKSUM_START, NULL };
    transfer_info info;
    uint64_t runs;
    int failed;
    s.file = file; s.name = name; s.w = w;
    memset(done, 0, (size_t)expected->point_count);
    failed = unpack_header(&s, &info, &runs) || compare_info(name, &info, expected, w) ||
             read_runs(&s, &info, runs, done, transfer) || read_end(&s);
    if (!failed) return 0;
    memset(done, 0, (size_t)expected->point_count);
    return -1;
}

static FILE *open_to_read(const char *path, why *w) {
    FILE *file = fopen(path, "rb");
    if (!file) why_set(w, "%s: cannot be opened: %s", path, strerror(errno));
    return file;
}

int transfer_file_info(const char *path, transfer_info *info, why *w) {
    FILE *file = open_to_read(path, w);
    int failed;
    if (!file) return -1;
    failed = transfer_file_read_info(file, path, info, w);
    fclose(file);
    return failed;
}

int transfer_file_load(const char *path, const transfer_info *expected, unsigned char *done, float *transfer, why *w) {
    FILE *file = open_to_read(path, w);
    int failed;
    if (!file) {
        memset(done, 0, (size_t)expected->point_count);
        return -1;
    }
    failed = transfer_file_read(file, path, expected, done, transfer, w);
    fclose(file);
    return failed;
}
