/* engine.c - runs candidates in turns and keeps the statistics.

   Rows of one group (same job, bands, precision) are timed in rounds: every round runs each of them once, in a new
   random order, together with the ceilings of the group (plain write and copy of the same bytes, peak arithmetic of the
   same build) and a chain of dependent additions that tells the clock. So a change of clock or load meets all alike,
   and ratios within a group are worth more than the times themselves. Time is the thread's processor time, which does
   not run while another process has the core. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"
#include "ceilings.h"

#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { MAX_CANDIDATES = 4096, MAX_PEERS = 256, MAX_ROUNDS = 1001, MAX_ROWS = 128, MAX_BANDS = 64 };

/* Something timed in a round: a candidate's row, or a ceiling. */
typedef struct timed {
    const bench_candidate *candidate;
    const bench_data *data;
    int bands, items;
    size_t chunk;             /* ceilings: bytes written at a time */
    long passes;
    double *samples;          /* ns for each item */
} timed;

static const bench_candidate *candidates[MAX_CANDIDATES];
static int candidate_count;
static const bench_peer *peers[MAX_PEERS];
static int peer_count;
static double clock_samples[4096];
static int clock_count;
static volatile sig_atomic_t interrupted;

static void need_room(int count, int capacity, const char *what) {
    if (count < capacity) return;
    fprintf(stderr, "prt_bench: more than %d %s; raise the limit at the top of bench/engine.c\n", capacity, what);
    exit(1);
}

void bench_add(const bench_candidate *rows, int count) {
    int i;
    for (i = 0; i < count; i++) {
        need_room(candidate_count, MAX_CANDIDATES, "candidates");
        candidates[candidate_count++] = rows + i;
    }
}

void bench_add_peers(const bench_peer *rows, int count) {
    int i;
    for (i = 0; i < count; i++) {
        need_room(peer_count, MAX_PEERS, "peers");
        peers[peer_count++] = rows + i;
    }
}

/* Turns peers into candidates: everything but the function comes from the table's own first row of the job. */
static void admit_peers(void) {
    static bench_candidate rows[MAX_PEERS];
    int own = candidate_count, i, k;
    for (i = 0; i < peer_count; i++) {
        for (k = 0; k < own; k++)
            if (!strcmp(candidates[k]->job, peers[i]->job) && candidates[k]->real_bytes == peers[i]->real_bytes) break;
        if (k == own) {
            fprintf(stderr, "prt_bench: peer %s: there is no job \"%s\" in bench/candidates.h; left out\n",
                    peers[i]->name, peers[i]->job);
            continue;
        }
        rows[i] = *candidates[k];
        rows[i].name = peers[i]->name;
        rows[i].build = "native";
        rows[i].bands = peers[i]->bands;
        rows[i].run = peers[i]->run;
        rows[i].peer = 1;
        bench_add(&rows[i], 1);
    }
    peer_count = 0;
}

static void on_interrupt(int signal_number) { (void)signal_number; interrupted = 1; }

/* ------------------------------------------------------------------------------------------------- data ---- */

/* A small generator with good low bits: [0,1). */
static double uniform(uint64_t *state) {
    uint64_t z = (*state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static void put(void *array, size_t i, int real_bytes, double value) {
    if (real_bytes == 4) ((float *)array)[i] = (float)value;
    else ((double *)array)[i] = value;
}

static void *room(size_t bytes) {
    void *p = NULL;
    if (posix_memalign(&p, 4096, bytes)) {
        fprintf(stderr, "prt_bench: out of memory (%zu bytes)\n", bytes);
        exit(1);
    }
    memset(p, 0, bytes);
    return p;
}

static void fill_directions(bench_data *d, int real_bytes, uint64_t *state) {
    size_t bytes = (size_t)BENCH_DIRECTIONS * (size_t)real_bytes, k;
    void *v = room(3 * bytes), *x = room(bytes), *y = room(bytes), *z = room(bytes);
    for (k = 0; k < BENCH_DIRECTIONS; k++) {
        double cosine = 2 * uniform(state) - 1, angle = 6.283185307179586 * uniform(state);
        double sine = sqrt(1 - cosine * cosine);
        put(x, k, real_bytes, sine * cos(angle)); put(v, 3 * k, real_bytes, sine * cos(angle));
        put(y, k, real_bytes, sine * sin(angle)); put(v, 3 * k + 1, real_bytes, sine * sin(angle));
        put(z, k, real_bytes, cosine);            put(v, 3 * k + 2, real_bytes, cosine);
    }
    d->directions = v; d->x = x; d->y = y; d->z = z;
}

/* A turn without symmetry. */
static void fill_rotation(bench_data *d, int real_bytes) {
    static const double turn[9] = { 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6 };
    void *r = room(9 * (size_t)real_bytes);
    size_t i;
    for (i = 0; i < 9; i++) put(r, i, real_bytes, turn[i]);
    d->rotation = r;
}

static void *coefficients(size_t planes, int real_bytes, uint64_t *state) {
    size_t n = (size_t)MAX_BANDS * MAX_BANDS, i;
    void *f = room(planes * n * (size_t)real_bytes);
    for (i = 0; i < planes * n; i++) {
        double band = floor(sqrt((double)(i % n)));
        put(f, i, real_bytes, (2 * uniform(state) - 1) / (1 + band));
    }
    return f;
}

static float *image(size_t texels, uint64_t *state) {
    float *rgb = (float *)room(3 * texels * sizeof(float));
    size_t i;
    for (i = 0; i < 3 * texels; i++) rgb[i] = (float)uniform(state);
    return rgb;
}

static const bench_data *data_of(int real_bytes) {
    static bench_data data[2];
    static const float *faces[6];
    bench_data *d = &data[real_bytes == 8];
    uint64_t state = 20131;
    size_t face, i;
    if (d->out) return d;
    fill_directions(d, real_bytes, &state);
    fill_rotation(d, real_bytes);
    d->f = coefficients(3, real_bytes, &state);
    d->g = coefficients(3, real_bytes, &state);
    if (!faces[0]) for (face = 0; face < 6; face++) faces[face] = image(BENCH_CUBE_SIZE * BENCH_CUBE_SIZE, &state);
    d->image = image((size_t)BENCH_IMAGE_WIDTH * BENCH_IMAGE_HEIGHT, &state);
    d->cube = faces;
    d->out_bytes = (size_t)512 * 1024 * (size_t)real_bytes;
    d->out = room(d->out_bytes);
    {
        void *rows = room(d->out_bytes);
        for (i = 0; i < d->out_bytes / (size_t)real_bytes; i++) put(rows, i, real_bytes, uniform(&state) - 0.5);
        d->rows = rows;
    }
    return d;
}

/* ----------------------------------------------------------------------------------------------- timing ---- */

static double now_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static void run_once(const timed *t, long passes) {
    if (t->chunk) bench_ceiling_run(t->candidate, t->data, t->chunk, t->items, passes);
    else t->candidate->run(t->data, t->bands, t->items, passes);
}

static double time_passes(const timed *t, long passes) {
    double start = now_ns();
    run_once(t, passes);
    return now_ns() - start;
}

static void calibrate(timed *t, double slice_ns) {
    run_once(t, 1);
    for (t->passes = 1; t->passes < (1L << 40); t->passes *= 2) {
        double ns = time_passes(t, t->passes);
        if (ns >= slice_ns) break;
        if (ns > slice_ns / 16) { t->passes = (long)((double)t->passes * slice_ns / ns) + 1; break; }
    }
}

/* A chain of dependent additions takes one cycle each on every processor that we know. */
static double measure_clock_ghz(void) {
    long i, turns = 4000;
    uint64_t a = (uint64_t)clock_count, b = 3;
    double start;
    __asm__ volatile("" : "+r"(a), "+r"(b));
    start = now_ns();
    for (i = 0; i < turns; i++) {
#define ADD a += b; __asm__ volatile("" : "+r"(a));
        ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD
        ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD ADD
#undef ADD
    }
    return 32 * (double)turns / (now_ns() - start);
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(const double *sorted, int count, double q) {
    double at = q * (count - 1);
    int i = (int)at;
    return i + 1 < count ? sorted[i] + (at - i) * (sorted[i + 1] - sorted[i]) : sorted[i];
}

double bench_clock_ghz(void) {
    static double sorted[sizeof clock_samples / sizeof *clock_samples];
    if (!clock_count) return 0;
    memcpy(sorted, clock_samples, (size_t)clock_count * sizeof *sorted);
    qsort(sorted, (size_t)clock_count, sizeof *sorted, ascending);
    return quantile(sorted, clock_count, 0.5);
}

static void run_rounds(timed *all, int count, int rounds, double *clock) {
    int order[MAX_ROWS], i, r;
    uint64_t state = 7;
    for (i = 0; i < count; i++) order[i] = i;
    for (r = 0; r < rounds; r++) {
        for (i = count - 1; i > 0; i--) {
            int j = (int)(uniform(&state) * (i + 1)), swap = order[i];
            order[i] = order[j]; order[j] = swap;
        }
        clock[r] = measure_clock_ghz();
        for (i = 0; i < count; i++) {
            timed *t = &all[order[i]];
            run_once(t, 1);   /* code and data back into the caches that the one before used */
            t->samples[r] = time_passes(t, t->passes) / ((double)t->passes * t->items);
        }
    }
    qsort(clock, (size_t)rounds, sizeof *clock, ascending);
    if (clock_count < (int)(sizeof clock_samples / sizeof *clock_samples))
        clock_samples[clock_count++] = quantile(clock, rounds, 0.5);
    for (i = 0; i < count; i++) qsort(all[i].samples, (size_t)rounds, sizeof *all[i].samples, ascending);
}

/* ----------------------------------------------------------------------------------------------- groups ---- */

/* Adds a ceiling to the group unless it stands there already; returns its place, -1 if there is no room. */
static int add_ceiling(timed *all, int *count, const bench_candidate *ceiling, const timed *of, size_t chunk,
                       int items) {
    int i;
    for (i = 0; i < *count; i++)
        if (all[i].candidate == ceiling && all[i].chunk == chunk && all[i].items == items) return i;
    if (*count == MAX_ROWS) return -1;
    memset(&all[*count], 0, sizeof all[*count]);
    all[*count].candidate = ceiling;
    all[*count].data = of->data;
    all[*count].chunk = chunk;
    all[*count].items = items;
    return (*count)++;
}

/* The plain write, copy and arithmetic that the row is held against. */
static void ceilings_of(timed *all, int *count, int row, int at[3]) {
    timed *t = &all[row];
    size_t item = (size_t)t->candidate->bytes_written(t->bands);
    size_t chunk = t->candidate->whole ? item * (size_t)t->items : item;
    int chunks = t->candidate->whole ? 1 : t->items;
    at[0] = at[1] = at[2] = -1;
    if (chunk && chunk <= t->data->out_bytes) {
        at[0] = add_ceiling(all, count, &bench_ceiling_write, t, chunk, chunks);
        at[1] = add_ceiling(all, count, &bench_ceiling_copy, t, chunk, chunks);
    }
    if (t->candidate->flops(t->bands) > 0) {
        const bench_candidate *peak = bench_ceiling_flops(t->candidate->build, t->candidate->real_bytes);
        if (peak) at[2] = add_ceiling(all, count, peak, t, 0, peak->items(0));
    }
}

static double median_of(const timed *all, int i, int rounds) { return quantile(all[i].samples, rounds, 0.5); }

static void row_from(bench_row *row, const timed *all, int i, const int at[3], int rounds, double ghz) {
    const timed *t = &all[i];
    const bench_candidate *c = t->candidate;
    double per_chunk = c->whole ? 1.0 / t->items : 1;
    memset(row, 0, sizeof *row);
    row->candidate = c;
    row->bands = t->bands;
    row->items = t->items;
    row->ns = median_of(all, i, rounds);
    row->ns_min = t->samples[0];
    row->spread = (quantile(t->samples, rounds, 0.75) - quantile(t->samples, rounds, 0.25)) / 2 / row->ns;
    row->cycles = row->ns * ghz;
    row->flops = c->flops(t->bands);
    row->bytes_read = c->bytes_read(t->bands);
    row->bytes_written = c->bytes_written(t->bands);
    if (at[0] >= 0) row->of_write = row->ns / (median_of(all, at[0], rounds) * per_chunk);
    if (at[1] >= 0) row->of_copy = row->ns / (median_of(all, at[1], rounds) * per_chunk);
    if (at[2] >= 0) row->of_flops = row->ns / (median_of(all, at[2], rounds) * row->flops);
}

static double sum_of_squares(const void *array, size_t count, int real_bytes) {
    double sum = 0, v;
    size_t i;
    for (i = 0; i < count; i++) {
        v = real_bytes == 4 ? (double)((const float *)array)[i] : ((const double *)array)[i];
        sum += v * v;
    }
    return sum;
}

/* Whoever evaluates the basis must meet sum_i Y_i^2 = n^2 / (4 pi), and whoever rotates keep the sum of squares: both
   whatever their signs and order. */
static int is_right(const timed *t) {
    const bench_candidate *c = t->candidate;
    size_t row = (size_t)t->bands * (size_t)t->bands, count = row * (size_t)(c->whole ? t->items : 1);
    double want, got;
    if (!strncmp(c->job, "eval", 4)) want = (double)count / 12.566370614359172954;
    else if (!strcmp(c->job, "rotate") || !strcmp(c->job, "rotate_by"))
        want = sum_of_squares(t->data->f, row, c->real_bytes);
    else return 1;
    memset(t->data->out, 0, t->data->out_bytes);
    run_once(t, 1);
    got = sum_of_squares(t->data->out, t->data->out_bytes / (size_t)c->real_bytes, c->real_bytes);
    if (fabs(got - want) <= 1e-3 * want) return 1;
    fprintf(stderr, "prt_bench: %s (%s, %d bands) is wrong and left out: its squares sum to %g, not %g\n", c->name,
            c->build, t->bands, got, want);
    return 0;
}

static int keep_right(timed *all, int count) {
    int i, kept = 0;
    for (i = 0; i < count; i++) if (is_right(&all[i])) all[kept++] = all[i];
    return kept;
}

/* Times the first `count` entries of `all` and their ceilings; hands the rows over. */
static void run_group(timed *all, int count, const bench_options *o,
                      void (*group)(void *, const bench_row *, int), void *user) {
    static bench_row rows[MAX_ROWS];
    static double clock[MAX_ROUNDS];
    int at[MAX_ROWS][3], total, i;
    double *samples;
    total = count = keep_right(all, count);
    for (i = 0; i < count; i++) ceilings_of(all, &total, i, at[i]);
    samples = (double *)room((size_t)total * (size_t)o->rounds * sizeof *samples);
    for (i = 0; i < total; i++) {
        all[i].samples = samples + (size_t)i * (size_t)o->rounds;
        calibrate(&all[i], o->slice_ns);
    }
    run_rounds(all, total, o->rounds, clock);
    for (i = 0; i < count; i++) row_from(&rows[i], all, i, at[i], o->rounds, quantile(clock, o->rounds, 0.5));
    group(user, rows, count);
    free(samples);
}

/* Every word of the filter (separated by blanks) must be in the row's description; "=word" a whole word of it. */
static int passes_filter(const char *filter, const bench_candidate *c, int bands) {
    char text[512], words[512], *word;
    if (!filter) return 1;
    snprintf(text, sizeof text, " %s %s %s %s %d bands ", c->job, c->name, c->build,
             c->real_bytes == 4 ? "float" : "double", bands);
    snprintf(words, sizeof words, "%s", filter);
    for (word = strtok(words, " "); word; word = strtok(NULL, " ")) {
        char whole[512];
        snprintf(whole, sizeof whole, " %s ", word + 1);
        if (!strstr(text, *word == '=' ? whole : word)) return 0;
    }
    return 1;
}

static int gather(timed *all, const char *job, int bands, int real_bytes, const char *filter) {
    int i, count = 0;
    for (i = 0; i < candidate_count; i++) {
        const bench_candidate *c = candidates[i];
        if (strcmp(c->job, job) || c->real_bytes != real_bytes || !bench_has_band(c->bands, bands)) continue;
        if (!passes_filter(filter, c, bands) || count == MAX_ROWS / 2) continue;
        memset(&all[count], 0, sizeof all[count]);
        all[count].candidate = c;
        all[count].data = data_of(real_bytes);
        all[count].bands = bands;
        all[count].items = c->items(bands);
        count++;
    }
    return count;
}

static int first_of_job(int i) {
    int k;
    for (k = 0; k < i; k++) if (!strcmp(candidates[k]->job, candidates[i]->job)) return 0;
    return 1;
}

/* One line on a terminal, wiped before the next output. */
static void show_progress(const char *job, int bands, int done, int of, double seconds) {
    if (!isatty(2)) return;
    fprintf(stderr, "\r%d/%d %s, %d bands", done + 1, of, job, bands);
    if (done) fprintf(stderr, ", %.0f s left", seconds / done * (of - done));
    fprintf(stderr, "\033[K\r");
}

/* Visits every group; with `group` it measures them, without it only counts. */
static int each_group(const bench_options *o, int of, void (*group)(void *, const bench_row *, int), void *user) {
    static timed all[MAX_ROWS];
    double start = bench_seconds();
    int i, real_bytes, bands, done = 0;
    for (i = 0; i < candidate_count; i++)
        for (real_bytes = 4; first_of_job(i) && real_bytes <= 8; real_bytes += 4)
            for (bands = 0; bands <= MAX_BANDS && !interrupted; bands++) {
                int count = gather(all, candidates[i]->job, bands, real_bytes, o->filter);
                if (!count) continue;
                if (group) {
                    show_progress(candidates[i]->job, bands, done, of, bench_seconds() - start);
                    run_group(all, count, o, group, user);
                }
                done++;
            }
    return done;
}

int bench_run(const bench_options *options, void (*group)(void *user, const bench_row *rows, int count), void *user) {
    void (*previous)(int) = signal(SIGINT, on_interrupt);
    int groups;
    admit_peers();
    groups = each_group(options, 0, NULL, NULL);
    groups = each_group(options, groups, group, user);
    signal(SIGINT, previous);
    if (interrupted) fprintf(stderr, "prt_bench: interrupted; what was measured until then is kept\n");
    return groups;
}
