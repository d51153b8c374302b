/* candidates.c - turns candidates.h into functions and a table, for one build of prt.h. Compiled once for each
   configuration, with BENCH_ID its name in configurations.h, BENCH_BUILD its name in tables, and BENCH_FLAGS. */
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "bench.h"
#include "peak.h"
#include "textbook.h"
#include "kernel_flops.h"
#include "vo_operations.h"

#define DIRS ((const prt_vec3 *)data->directions)
#define DIR(k) (DIRS[k])
#define X ((const prt_real *)data->x)
#define Y ((const prt_real *)data->y)
#define Z ((const prt_real *)data->z)
#define F ((const prt_real *)data->f)
#define G ((const prt_real *)data->g)
#define ROWS ((const prt_real *)data->rows)
#define IMAGE (data->image)
#define CUBE (data->cube)
#define OUT ((prt_real *)data->out)
#define ROTATION ((const prt_real *)data->rotation)

/* What a job needs beside its inputs, made before the clock runs: matrices of the rotation, and of products. */
enum { MATRIX_BANDS = 10 };
static const prt_real *blocks_of(int n, const prt_real *turn) {
    static prt_real blocks[PRT_MAX_BANDS * (4 * PRT_MAX_BANDS * PRT_MAX_BANDS - 1) / 3];
    static int built;
    if (n != built && prt_sh_rotation(n, turn, blocks) == PRT_OK) built = n;
    return blocks;
}
static const prt_real *matrix_of(int n, const prt_real *filter) {
    static prt_real matrix[MATRIX_BANDS * MATRIX_BANDS * MATRIX_BANDS * MATRIX_BANDS];
    static int built;
    if (n != built && n <= MATRIX_BANDS && prt_sh_product_matrix(n, filter, matrix) == PRT_OK) built = n;
    return matrix;
}
/* Packed transfer of 1024 points, in range and steps as if at random; read as bytes, words or finite halves. */
static const prt_packed_transfer *packed_of(int n, prt_storage storage) {
    static uint16_t numbers[1024 * PRT_SH_COUNT(MATRIX_BANDS)];
    static prt_real low[PRT_SH_COUNT(MATRIX_BANDS)], step[PRT_SH_COUNT(MATRIX_BANDS)];
    static prt_packed_transfer packed;
    int i;
    for (i = 0; !numbers[1] && i < 1024 * PRT_SH_COUNT(MATRIX_BANDS); i++)
        numbers[i] = (uint16_t)(i * 40503u & 0xbbffu);
    for (i = 0; !step[0] && i < PRT_SH_COUNT(MATRIX_BANDS); i++) { low[i] = (prt_real)-0.5; step[i] = (prt_real)4e-3; }
    packed.bands = n; packed.storage = storage; packed.data = numbers; packed.low = low; packed.step = step;
    return &packed;
}
#define PACKED(storage) (*packed_of(n, PRT_STORAGE_##storage))
static const int y_up[3] = { 1, -3, 2 };
static const prt_real mirror[9] = {                             /* no axis or plane of it is special */
    (prt_real)-0.36, (prt_real)-0.48, (prt_real)0.8, (prt_real)0.8, (prt_real)-0.6, 0, (prt_real)-0.48, (prt_real)-0.64,
    (prt_real)-0.6
};
static const prt_real quarter[4] = { (prt_real)0.5, (prt_real)0.5, (prt_real)-0.5, (prt_real)0.5 };
static double one(void *user, prt_vec3 dir) { (void)user; (void)dir; return 1; }
/* Points that see VO_SEEN occluders each, and lights, all at random; opaque. Packed forms beside them. */
enum { VO_POINTS = 1024, VO_SEEN = 5, VO_LIGHTS = 32, VO_COLORS = 6 };
typedef struct vo_scene {
    prt_vo_params dd, all;
    prt_vo_point points[VO_POINTS];
    int first[VO_POINTS + 1];
    prt_vo_occluder occluders[VO_POINTS * VO_SEEN];
    prt_vo_packed packed[VO_POINTS * VO_SEEN];
    prt_vo_packed_diffuse packed_diffuse[VO_POINTS * VO_SEEN];
    prt_vo_indexed indexed[VO_POINTS * VO_SEEN];
    prt_vo_indexed_diffuse indexed_diffuse[VO_POINTS * VO_SEEN];
    prt_vo_material materials[VO_COLORS], materials_diffuse[VO_COLORS];
    int material_count, material_count_diffuse;
    prt_point_light lights[VO_LIGHTS];
    prt_vo_wave waves[2];
} vo_scene;
static prt_real vo_noise(void) {
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;
    return (prt_real)(state >> 8) * (prt_real)(1 / 16777216.0);
}
static void vo_fill(prt_real *numbers, size_t count, prt_real low, prt_real high) {
    for (; count > 0; count--) *numbers++ = low + (high - low) * vo_noise();
}
static const vo_scene *vo_scene_of(void) {
    static vo_scene s;
    int k;
    if (s.first[1]) return &s;
    s.dd.off = PRT_VO_NO_DS | PRT_VO_NO_SS;
    for (k = 0; k < VO_POINTS; k++) {
        vo_fill(&s.points[k].position.x, 6, -1, 1);
        vo_fill(&s.points[k].diffuse.r, 9, 0, 1);
        s.points[k].shininess = 20;
        s.first[k + 1] = s.first[k] + VO_SEEN;
    }
    for (k = 0; k < VO_POINTS * VO_SEEN; k++) {
        vo_fill(&s.occluders[k].position.x, 6, -3, 3);
        vo_fill(&s.occluders[k].diffuse_normal.x, 6, (prt_real)-.5, (prt_real).5);
        vo_fill(&s.occluders[k].diffuse.r, 7, 0, 1);
        if (k >= VO_COLORS) {
            s.occluders[k].diffuse = s.occluders[k % VO_COLORS].diffuse;
            s.occluders[k].specular = s.occluders[k % VO_COLORS].specular;
        }
    }
    prt_vo_index(VO_POINTS * VO_SEEN, s.occluders, VO_COLORS, s.materials, &s.material_count, s.indexed);
    prt_vo_index_diffuse(VO_POINTS * VO_SEEN, s.occluders, VO_COLORS, s.materials_diffuse, &s.material_count_diffuse,
                         s.indexed_diffuse);
    for (k = 0; k < VO_POINTS; k++) {
        prt_vo_pack(1, s.points[k].position, VO_SEEN, s.occluders + s.first[k], s.packed + s.first[k]);
        prt_vo_pack_diffuse(1, s.points[k].position, VO_SEEN, s.occluders + s.first[k],
                            s.packed_diffuse + s.first[k]);
    }
    for (k = 0; k < VO_LIGHTS; k++) {
        vo_fill(&s.lights[k].position.x, 3, -9, 9);
        vo_fill(&s.lights[k].color.r, 3, 0, 1);
    }
    for (k = 0; k < 2; k++) {
        s.waves[k].along.x = s.waves[k].across.z = 1;
        s.waves[k].amplitude = s.waves[k].frequency = (prt_real)0.5 + (prt_real)k;
    }
    return &s;
}
#define VO (vo_scene_of())

/* Made before the clock runs: what the candidate does not name costs nothing. */
#define BLOCKS blocks
#define MATRIX matrix
#define PREPARED const prt_real *blocks = n > 0 ? blocks_of(n, ROTATION) : NULL; \
    const prt_real *matrix = n > 0 ? matrix_of(n, F) : NULL; \
    (void)blocks; (void)matrix; (void)n; (void)items;

/* A table of random vectors on 33 x 64 x 30 places, as large as one that is baked (2.3 MB in float), 32 x 32 receivers
   on a plane, and occluders floating over them, close to each other: of 60, four pairs in ten overlap. */
enum { FIV_THETAS = 33, FIV_PHIS = 64, FIV_RHOS = 30, FIV_SAMPLES = FIV_THETAS * FIV_PHIS * FIV_RHOS,
       FIV_RECEIVERS = 1024, FIV_MOST = 60, FIV_BANDS = 4, FIV_HIDDEN = (FIV_BANDS + 1) * (FIV_BANDS + 1) };
typedef struct fiv_scene {
    prt_fiv samples[FIV_SAMPLES], low[FIV_RHOS], step[FIV_RHOS];
    prt_real rho[FIV_RHOS], hidden[FIV_SAMPLES * FIV_HIDDEN], vectors[9 * FIV_HIDDEN];
    unsigned char bytes[FIV_SAMPLES * 9];
    uint16_t halves[FIV_SAMPLES * 9];
    prt_fiv_table table;
    prt_fiv_packed packed8, packed16;
    prt_fiv_transfer transfer;
    prt_fiv_occluder occluders[FIV_MOST];
    prt_fiv_body bodies[4];            /* occluder 0 with each kind of table */
    prt_vec3 positions[FIV_RECEIVERS], normals[FIV_RECEIVERS];
    prt_rgb totals[FIV_RECEIVERS];
    prt_fiv_hidden found[FIV_MOST];    /* what the occluders hide from receiver 0 */
    int corner[FIV_RECEIVERS];         /* the first of eight samples around occluder 0 */
} fiv_scene;

/* What lies between a receiver and occluder k. */
static prt_vec3 fiv_between(const fiv_scene *s, int receiver, int k) {
    prt_vec3 p = s->positions[receiver], o = s->occluders[k].position;
    return prt__vec3(o.x - p.x, o.y - p.y, o.z - p.z);
}

static prt_fiv fiv_low[FIV_RHOS], fiv_step[FIV_RHOS];  /* where prt_fiv_pack writes when it is timed */
static prt_fiv_packed fiv_packed;

static const fiv_scene *fiv_scene_of(const bench_data *data) {
    static fiv_scene s;
    int k;
    if (s.table.samples) return &s;
    for (k = 0; k < FIV_SAMPLES * 9; k++) (&s.samples[0].r.x)[k] = F[k % 4096] + 1;
    for (k = 0; k < FIV_SAMPLES * FIV_HIDDEN; k++) s.hidden[k] = F[k % 4096];
    for (k = 0; k < FIV_RHOS; k++) s.rho[k] = (prt_real)(1.05 * pow(1.07, k));
    s.table.theta_count = s.transfer.theta_count = FIV_THETAS;
    s.table.phi_count = s.transfer.phi_count = FIV_PHIS;
    s.table.rho_count = s.transfer.rho_count = FIV_RHOS;
    s.table.rho = s.transfer.rho = s.rho;
    s.table.radius = s.transfer.radius = 1;
    s.transfer.bands = FIV_BANDS;
    s.transfer.samples = s.hidden;
    s.table.samples = s.samples;
    prt_fiv_pack(&s.table, 8, s.bytes, s.low, s.step, &s.packed8);
    prt_fiv_pack(&s.table, 16, s.halves, NULL, NULL, &s.packed16);
    prt_fiv_transfer_light(FIV_BANDS, NULL, F, s.vectors);
    for (k = 0; k < FIV_MOST; k++) {
        prt_fiv_occluder o = { NULL, { 0, 0, 0 } };
        o.table = &s.table;
        o.position.x = (prt_real)(3 * sin(2.4 * k) * sqrt((k + 0.5) / FIV_MOST));
        o.position.y = (prt_real)(3 * cos(2.4 * k) * sqrt((k + 0.5) / FIV_MOST));
        o.position.z = (prt_real)(1.2 + 0.3 * (k % 5));
        s.occluders[k] = o;
    }
    s.bodies[0].table = &s.table;
    s.bodies[1].packed = &s.packed16;
    s.bodies[2].packed = &s.packed8;
    s.bodies[3].transfer = &s.transfer;
    s.bodies[3].vectors = s.vectors;
    for (k = 0; k < 4; k++) s.bodies[k].position = s.occluders[0].position;
    for (k = 0; k < FIV_RECEIVERS; k++) {
        prt__fiv_grid grid = prt__fiv_grid_of(&s.table);
        prt__fiv_cells cells;
        s.positions[k].x = (prt_real)(k % 32 * 0.2 - 3.2);
        s.positions[k].y = (prt_real)(k / 32 * 0.2 - 3.2);
        s.normals[k].z = 1;
        s.totals[k].r = s.totals[k].g = s.totals[k].b = 3;
        prt__fiv_cell_of(&grid, fiv_between(&s, k, 0), &cells);
        s.corner[k] = (int)cells.at[0] % (FIV_SAMPLES - FIV_THETAS * FIV_PHIS - FIV_PHIS - 1);
    }
    for (k = 0; k < FIV_MOST; k++) {
        s.found[k].to_centre = fiv_between(&s, 0, k);
        s.found[k].radius = s.table.radius;
        prt_fiv_lookup(&s.table, s.found[k].to_centre, &s.found[k].fiv);
    }
    return &s;
}

static void fiv_each(const fiv_scene *s, int occluders, prt_rgb *out) {
    int k;
    for (k = 0; k < FIV_RECEIVERS; k++)
        prt_fiv_shade(s->totals[k], s->positions[k], s->normals[k], occluders, s->occluders, 0, out + k);
}

/* The memory alone: the sum of the eight samples of each receiver. */
static void fiv_touch(const fiv_scene *s, prt_real *out) {
    static const int steps[8] = { 0, 1, FIV_PHIS, FIV_PHIS + 1, FIV_THETAS * FIV_PHIS, FIV_THETAS * FIV_PHIS + 1,
                                  (FIV_THETAS + 1) * FIV_PHIS, (FIV_THETAS + 1) * FIV_PHIS + 1 };
    int k, i, c;
    for (k = 0; k < FIV_RECEIVERS; k++) {
        prt_real sum[8] = { 0 };
        for (i = 0; i < 8; i++) {
            const prt_real *sample = &s->samples[s->corner[k] + steps[i]].r.x;
            for (c = 0; c < 8; c++) sum[c] += sample[c];
        }
        memcpy(out + 8 * (k % 8), sum, sizeof sum);
    }
}
#define FIV const fiv_scene *s = fiv_scene_of(data)

/* The functions of each line ... */
#define COUNTS(id, items_, flops_, reads_, writes_) \
    static int id##_items(int n) { (void)n; return items_; } \
    static double id##_flops(int n) { (void)n; return flops_; } \
    static double id##_reads(int n) { (void)n; return (double)(reads_) * sizeof(prt_real); } \
    static double id##_writes(int n) { (void)n; return (double)(writes_) * sizeof(prt_real); }
#define EACH(id, job, name, bands, items_, call, flops_, reads_, writes_) \
    COUNTS(id, items_, flops_, reads_, writes_) \
    static void id##_run(const bench_data *data, int n, int items, long passes) { \
        int k; \
        PREPARED \
        for (; passes > 0; passes--) for (k = 0; k < items; k++) { call; BENCH_KEEP(data->out); } \
    }
#define BATCH(id, job, name, bands, items_, call, flops_, reads_, writes_) \
    COUNTS(id, items_, flops_, reads_, writes_) \
    static void id##_run(const bench_data *data, int n, int items, long passes) { \
        PREPARED \
        for (; passes > 0; passes--) { call; BENCH_KEEP(data->out); } \
    }
#include "candidates.h"
#undef EACH
#undef BATCH

/* ... and its row. */
#define ROW(id, job, name, bands, whole) \
    { job, name, BENCH_BUILD, (int)sizeof(prt_real), bands, whole, id##_items, id##_run, id##_flops, id##_reads, \
      id##_writes, 0 },
#define EACH(id, job, name, bands, items, call, flops, reads, writes) ROW(id, job, name, bands, 0)
#define BATCH(id, job, name, bands, items, call, flops, reads, writes) ROW(id, job, name, bands, 1)
static const bench_candidate rows[] = {
#include "candidates.h"
};

static int peak_items(int n) { (void)n; return PEAK_FLOPS; }
static double peak_none(int n) { (void)n; return 0; }

static void peak_run(const bench_data *data, int n, int items, long passes) {
    (void)n; (void)items;
    peak_passes(passes, (prt_real *)data->out);
    BENCH_KEEP(data->out);
}

static const bench_candidate peak = { "ceiling", "multiply-add", BENCH_BUILD, (int)sizeof(prt_real), "", 0, peak_items,
                                      peak_run, peak_none, peak_none, peak_none, 0 };

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
const bench_candidate *JOIN(bench_rows_, BENCH_ID)(int *count);
const bench_candidate *JOIN(bench_peak_, BENCH_ID)(void);
const char *JOIN(bench_flags_, BENCH_ID)(void);

const bench_candidate *JOIN(bench_rows_, BENCH_ID)(int *count) {
    *count = (int)(sizeof rows / sizeof rows[0]);
    return rows;
}
const bench_candidate *JOIN(bench_peak_, BENCH_ID)(void) { return &peak; }
const char *JOIN(bench_flags_, BENCH_ID)(void) { return BENCH_FLAGS; }
