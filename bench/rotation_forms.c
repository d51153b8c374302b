/* rotation_forms.c - rotation and CH of prt.h as this object was compiled, named by ROTATION_ID. */
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"

#include <stdlib.h>

#include "bench.h"
#include "published_rotation.h"
#include "rotation_forms.h"

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)

static void keep_larger(double *worst, double error) { if (!(error <= *worst)) *worst = error; }

static void turn_number(int trial, prt_real rotation[9]) {
    prt_real q[4];
    int i;
    for (i = 0; i < 4; i++) q[i] = (prt_real)sin(1 + 4 * trial + i);
    prt_rotation_from_quaternion(q, rotation);
}

int JOIN(rotation_blocks_, ROTATION_ID)(double *published, double *stabilised) {
    size_t count = prt_sh_rotation_count(ROTATION_BANDS);
    prt_real *ours = (prt_real *)malloc(count * sizeof *ours), *theirs = (prt_real *)malloc(count * sizeof *theirs);
    int trial, l, ok = ours && theirs;
    for (trial = 0; ok && trial < ROTATION_TRIALS; trial++) {
        prt_real rotation[9] = { 0 };
        turn_number(trial, rotation);
        prt_sh_rotation(ROTATION_BANDS, rotation, ours);
        memcpy(theirs, ours, prt_sh_rotation_count(2) * sizeof *ours);
        for (l = 0; l < ROTATION_BANDS; l++) {
            prt_real *block = theirs + prt_sh_rotation_count(l);
            if (l > 1) published_block(l, theirs + 1, theirs + prt_sh_rotation_count(l - 1), block);
            keep_larger(&published[l], orthogonality_error(2 * l + 1, block));
            keep_larger(&stabilised[l], orthogonality_error(2 * l + 1, ours + prt_sh_rotation_count(l)));
        }
    }
    free(ours);
    free(theirs);
    return ok;
}

/* ---- error against time ---- */

/* Many are 1024 as far as 8 bands, 64 above. */
enum { LARGEST = ROTATION_LARGEST, MOST = LARGEST * LARGEST, ITEMS = 1024, FEWER = 64, ROOM = FEWER * MOST };
enum { TRIED = 13 };                                           /* of many, whose errors are looked at */
static int many(int bands) { return bands <= 8 ? ITEMS : FEWER; }
typedef struct work {
    prt_real f[ROOM], out[ROOM], rotation[9], blocks[LARGEST * (4 * MOST - 1) / 3];
    prt_real x[ITEMS], y[ITEMS], z[ITEMS];
    prt_vec3 dirs[ITEMS];
} work;
typedef void way(int bands, work *w);                          /* does it once, or for many items */

static void one_shot(int n, work *w) { prt_sh_rotate(n, w->rotation, w->f, w->out); }
static void build_and_apply(int n, work *w) {
    prt_sh_rotation(n, w->rotation, w->blocks);
    prt_sh_rotate_by(n, w->blocks, w->f, w->out);
}
static void apply(int n, work *w) { prt_sh_rotate_by(n, w->blocks, w->f, w->out); }
static void apply_n(int n, work *w) { prt_sh_rotate_by_n(n, w->blocks, many(n), w->f, w->out); }
static void apply_soa(int n, work *w) {
    prt_sh_rotate_by_soa(n, w->blocks, many(n), w->f, w->out, (size_t)many(n));
}
static void ch_one(int n, work *w) { prt_ch_eval(n, w->dirs[0], w->out); }
static void ch_n(int n, work *w) { prt_ch_eval_n(n, many(n), w->dirs, w->out); }
static void ch_soa(int n, work *w) { prt_ch_eval_soa(n, many(n), w->x, w->y, w->z, w->out, (size_t)many(n)); }

static const struct { const char *what, *name; way *run; int many, rows; } ways[] = {
    { "rotation", "one shot", one_shot, 0, 0 },
    { "rotation", "blocks built for one vector", build_and_apply, 0, 0 },
    { "rotation", "built blocks on one vector", apply, 0, 0 },
    { "rotation", "built blocks on many vectors", apply_n, 1, 0 },
    { "rotation", "built blocks on rows", apply_soa, 1, 1 },
    { "ch", "one direction", ch_one, 0, 0 },
    { "ch", "many directions", ch_n, 1, 0 },
    { "ch", "rows", ch_soa, 1, 1 }
};
enum { WAYS = (int)(sizeof ways / sizeof ways[0]) };
static int items_of(int k, int bands) { return ways[k].many ? many(bands) : 1; }

static void prepare(int bands, int trial, work *w) {
    int i, items = many(bands);
    turn_number(trial, w->rotation);
    prt_sh_rotation(bands, w->rotation, w->blocks);
    for (i = 0; i < items * bands * bands; i++) w->f[i] = (prt_real)sin(1.0 + i + 0.37 * i * (trial + 1));
    for (i = 0; i < items; i++) {
        double z = 1 - 2 * (i + 0.5) / items, r = sqrt(1 - z * z), phi = 2.4 * i + trial;
        w->dirs[i] = prt__vec3((prt_real)(r * cos(phi)), (prt_real)(r * sin(phi)), (prt_real)z);
        w->x[i] = w->dirs[i].x;
        w->y[i] = w->dirs[i].y;
        w->z[i] = w->dirs[i].z;
    }
}

static work all __attribute__((aligned(64)));

/* Largest error of one item; its coefficients stand far apart in rows. */
static double item_error(int k, int bands, int item, rotation_truth *truth, const work *w) {
    static double in[MOST], want[MOST];
    double r[9], worst = 0;
    int i, n = bands * bands;
    for (i = 0; i < n; i++) in[i] = (double)w->f[ways[k].rows ? i * many(bands) + item : item * n + i];
    for (i = 0; i < 9; i++) r[i] = (double)w->rotation[i];
    if (ways[k].what[0] == 'c') { r[0] = (double)w->x[item]; r[1] = (double)w->y[item]; r[2] = (double)w->z[item]; }
    truth(bands, r, in, want);
    for (i = 0; i < n; i++)
        keep_larger(&worst, fabs((double)w->out[ways[k].rows ? i * many(bands) + item : item * n + i] - want[i]));
    return worst;
}

static double time_of(int k, int bands, work *w) {
    double best = HUGE_VAL;
    int round, i, items = items_of(k, bands), repeats = 1 + 200000 / (bands * bands * bands * items + 200);
    for (round = 0; round < 15; round++) {
        double start = bench_seconds(), t;
        for (i = 0; i < repeats; i++) { ways[k].run(bands, w); BENCH_KEEP(w->out); }
        t = (bench_seconds() - start) * 1e9 / repeats / items;
        if (t < best) best = t;
    }
    return best;
}

int JOIN(rotation_points_, ROTATION_ID)(rotation_truth *turned, rotation_truth *ch, rotation_point *points) {
    static const int all_bands[] = { 2, 3, 4, 5, 6, 8, 10, 16, LARGEST };
    int k, trial, item, count = 0;
    size_t b;
    for (k = 0; k < WAYS; k++)
        for (b = 0; b < sizeof all_bands / sizeof *all_bands; b++) {
            rotation_point p;
            int items = items_of(k, all_bands[b]);
            p.what = ways[k].what;
            p.form = ways[k].name;
            p.bands = all_bands[b];
            p.error = 0;
            for (trial = 0; trial < ROTATION_TRIALS; trial++) {
                prepare(p.bands, trial, &all);
                ways[k].run(p.bands, &all);
                for (item = 0; item < items; item += 1 + items / TRIED)
                    keep_larger(&p.error, item_error(k, p.bands, item, p.what[0] == 'c' ? ch : turned, &all));
            }
            p.ns = time_of(k, p.bands, &all);
            if (count < ROTATION_POINTS) points[count++] = p;
        }
    return count;
}

/* Its error is taken as that of one shot, way 0. */
rotation_point JOIN(rotation_peer_, ROTATION_ID)(rotation_truth *turned, const bench_peer *peer, int bands) {
    rotation_point p = { "peer", NULL, 0, 0, 0 };
    bench_data data;
    int trial, round, repeats = 1 + 200000 / (bands * bands * bands + 200);
    memset(&data, 0, sizeof data);
    data.f = all.f;
    data.rotation = all.rotation;
    data.out = all.out;
    data.out_bytes = sizeof all.out;
    p.form = peer->name;
    p.bands = bands;
    for (trial = 0; trial < ROTATION_TRIALS; trial++) {
        prepare(bands, trial, &all);
        peer->run(&data, bands, 1, 1);
        keep_larger(&p.error, item_error(0, bands, 0, turned, &all));
    }
    p.ns = HUGE_VAL;
    for (round = 0; round < 15; round++) {
        double start = bench_seconds(), t;
        peer->run(&data, bands, 1, repeats);
        t = (bench_seconds() - start) * 1e9 / repeats;
        if (t < p.ns) p.ns = t;
    }
    return p;
}

/* ---- a thousand turns, and memory ---- */

void JOIN(rotation_turns_, ROTATION_ID)(const double *r, int rounded, const double *f, double *one_shot,
                                        double *blocks) {
    prt_real rotation[9], m[TURNED_BANDS * (4 * TURNED - 1) / 3], g[TURNED], h[TURNED];
    int i, k;
    for (i = 0; i < 9; i++) rotation[i] = (prt_real)(rounded ? r[i] : (double)(float)r[i]);
    prt_sh_rotation(TURNED_BANDS, rotation, m);
    for (i = 0; rounded && i < (int)(sizeof m / sizeof *m); i++) m[i] = (prt_real)(float)m[i];
    for (i = 0; i < TURNED; i++) g[i] = h[i] = (prt_real)(float)f[i];
    for (k = 0; k < 1000; k++) {
        prt_sh_rotate(TURNED_BANDS, rotation, g, g);
        prt_sh_rotate_by(TURNED_BANDS, m, h, h);
    }
    for (i = 0; i < TURNED; i++) {
        one_shot[i] = (double)g[i];
        blocks[i] = (double)h[i];
    }
}

int JOIN(rotation_stream_, ROTATION_ID)(double rate[3]) {
    enum { COUNT = 3 << 20, BANDS = 4, N = 16 };
    size_t bytes = (size_t)COUNT * N * sizeof(prt_real), i;
    prt_real *f = (prt_real *)malloc(bytes), *out = (prt_real *)malloc(bytes), rotation[9], blocks[84];
    double best[4] = { HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL };
    int round, form, ok = f && out;
    turn_number(0, rotation);
    prt_sh_rotation(BANDS, rotation, blocks);
    for (i = 0; ok && i < (size_t)COUNT * N; i++) { f[i] = (prt_real)(i % 977); out[i] = 0; }
    for (round = 0; ok && round < 5; round++)
        for (form = 0; form < 4; form++) {
            double start = bench_seconds(), t;
            if (form == 0) memcpy(out, f, bytes);
            if (form == 1) prt_sh_rotate_by_n(BANDS, blocks, COUNT, f, out);
            if (form == 2) prt_sh_rotate_by_n_rgb(BANDS, blocks, COUNT / 3, f, out);
            if (form == 3) prt_sh_rotate_by_soa(BANDS, blocks, COUNT, f, out, COUNT);
            BENCH_KEEP(out);
            t = bench_seconds() - start;
            if (t < best[form]) best[form] = t;
        }
    for (form = 0; form < 3; form++) rate[form] = best[0] / best[form + 1];
    free(f);
    free(out);
    return ok;
}
