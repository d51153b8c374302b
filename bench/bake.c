/* bake.c - what prt_bake_transfer costs beside the rays, and how its error falls with them, on a real mesh with Embree.

   bake speed [--mesh FILE] [--csv FILE]    ns a ray of the bake without its rays, over those of bare rtcOccluded1M
   bake error [--mesh FILE] [--csv FILE]    root mean square error of transfer against rays a point, for each sample set
*/
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "bake_forms.h"
#include "bench.h"
#include "command.h"
#include "embree_tracer.h"

#include <embree3/rtcore.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { BANDS = 5, N = PRT_SH_COUNT(BANDS) };
static const char default_mesh[] = "/usr/share/glmark2/models/bunny.obj";

static double thread_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *room(size_t count, size_t size) {
    void *memory = malloc(count * size);
    if (!memory) { fprintf(stderr, "bake: out of memory (%zu bytes)\n", count * size); exit(1); }
    return memory;
}

static void require(prt_result r, const char *what) {
    if (r == PRT_OK) return;
    fprintf(stderr, "bake: %s: %s\n", what, prt_result_string(r));
    exit(1);
}

static void stamp(FILE *f, const char *prefix, const char *mesh_name, const char *more) {
    fprintf(f, "%sprt_bake.h %s; machine: %s; compiler: %s; mesh: %s; %s\n", prefix, BENCH_VERSION, bench_cpu_name(),
            BENCH_COMPILER, mesh_name, more);
}

/* ---- speed ---- */

enum { ROUNDS = 15, SPEED_POINTS = 500 };

/* Traces with Embree, times it, and keeps the answers for replaying. */
typedef struct recorder {
    RTCScene scene;
    struct RTCRay *rays;
    unsigned char *answers;
    size_t position;
    double bare;                       /* processor seconds inside rtcOccluded1M */
} recorder;

static void to_embree(struct RTCRay *to, const prt_ray *from) {
    to->org_x = from->origin.x; to->org_y = from->origin.y; to->org_z = from->origin.z;
    to->dir_x = from->dir.x; to->dir_y = from->dir.y; to->dir_z = from->dir.z;
    to->tnear = from->tmin; to->tfar = from->tmax;
    to->time = 0; to->mask = ~0u; to->id = 0; to->flags = 0;
}

static int record(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    recorder *r = user;
    struct RTCIntersectContext context;
    double before;
    int k;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    for (k = 0; k < count; k++) to_embree(&r->rays[k], &rays[k]);
    before = thread_seconds();
    rtcOccluded1M(r->scene, &context, r->rays, (unsigned)count, sizeof *r->rays);
    r->bare += thread_seconds() - before;
    for (k = 0; k < count; k++) blocked[k] = r->rays[k].tfar < 0;
    memcpy(r->answers + r->position, blocked, (size_t)count);
    r->position += (size_t)count;
    return 0;
}

static int replay(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    recorder *r = user;
    (void)rays;
    memcpy(blocked, r->answers + r->position, (size_t)count);
    r->position += (size_t)count;
    return 0;
}

typedef struct speed_form { const char *name; bake_transfer_function *bake; } speed_form;

/* The least of ROUNDS rounds of each, taken in turns: what else runs on the machine only adds to a time. */
static void speed_row(const speed_form *form, int bands, int samples, const mesh *m, recorder *r, FILE *csv) {
    double bare = HUGE_VAL, over = HUGE_VAL, whole = HUGE_VAL;
    int count = m->point_count < SPEED_POINTS ? m->point_count : SPEED_POINTS, first = (m->point_count - count) / 2, k;
    double rays = (double)count * samples;
    prt_real *transfer = room((size_t)m->point_count, (size_t)PRT_SH_COUNT(bands) * sizeof *transfer);
    prt_tracer tracer = { 0 };
    prt_bake_desc desc = { 0 };
    tracer.user = r;
    desc.tracer = &tracer; desc.bands = bands; desc.samples = samples; desc.scene_radius = m->report.radius;
    for (k = 0; k < ROUNDS; k++) {
        double start;
        r->position = 0; r->bare = 0;
        tracer.occluded = record;
        start = thread_seconds();
        require(form->bake(&desc, m->point_count, m->points, first, count, transfer), "bake");
        whole = fmin(whole, 1e9 * (thread_seconds() - start) / rays);
        bare = fmin(bare, 1e9 * r->bare / rays);
        r->position = 0;
        tracer.occluded = replay;
        start = thread_seconds();
        require(form->bake(&desc, m->point_count, m->points, first, count, transfer), "bake");
        over = fmin(over, 1e9 * (thread_seconds() - start) / rays);
    }
    free(transfer);
    fprintf(csv, "%s,%d,%d,%.3f,%.3f,%.3f,%.4f\n", form->name, bands, samples, bare, whole, over, over / bare);
    printf("%-9s %5d %8d %12.1f %12.1f %12.2f %9.1f %%\n", form->name, bands, samples, bare, whole, over,
           100 * over / bare);
    fflush(stdout);
}

static void speed(const mesh *m, const char *mesh_name, RTCScene scene, FILE *csv) {
    static const speed_form forms[] = { { "native", bake_transfer_native }, { "portable", bake_transfer_portable } };
    static const int bands[] = { 3, 5, 8 }, samples[] = { 256, 1024 };
    recorder r;
    int f, b, s;
    memset(&r, 0, sizeof r);
    r.scene = scene;
    r.rays = room(PRT_BAKE_BATCH, sizeof *r.rays);             /* Embree wants them on 16 bytes, as malloc here gives */
    r.answers = room((size_t)SPEED_POINTS * 1024, 1);
    stamp(csv, "# ", mesh_name, "one thread; flags: native " BAKE_NATIVE ", portable " BAKE_PORTABLE);
    fprintf(csv, "build,bands,rays,bare_ns,bake_ns,overhead_ns,overhead_over_bare\n");
    stamp(stdout, "", mesh_name, "one thread; flags: native " BAKE_NATIVE ", portable " BAKE_PORTABLE);
    printf("%-9s %5s %8s %12s %12s %12s %11s\n", "build", "bands", "rays", "Embree ns", "whole bake", "bake alone",
           "ratio");
    for (f = 0; f < 2; f++)
        for (b = 0; b < 3; b++)
            for (s = 0; s < 2; s++) speed_row(&forms[f], bands[b], samples[s], m, &r, csv);
    free(r.rays);
    free(r.answers);
}

/* ---- error ---- */

enum { ERROR_POINTS = 400, REFERENCE = 262144, MOST = REFERENCE };

typedef enum map_kind { SPHERE, HEMISPHERE, COSINE } map_kind;
typedef struct sampler {
    const char *name, *label;
    prt_sample_set set;
    map_kind map;
    int subtract;                      /* 1: the exact unshadowed transfer less what the blocked rays take */
} sampler;
static const sampler samplers[] = {
    { "jittered_sphere",      "jittered grid, uniform over the sphere [Chapter 2010]", PRT_SAMPLE_JITTERED, SPHERE, 0 },
    { "random_cosine",        "independent, cosine-weighted", PRT_SAMPLE_RANDOM, COSINE, 0 },
    { "jittered_cosine",      "jittered grid, cosine-weighted", PRT_SAMPLE_JITTERED, COSINE, 0 },
    { "sobol_cosine",         "Sobol, Owen scrambled, cosine-weighted", PRT_SAMPLE_SOBOL, COSINE, 0 },
    { "fibonacci_hemisphere", "Fibonacci, uniform over the hemisphere", PRT_SAMPLE_FIBONACCI, HEMISPHERE, 0 },
    { "fibonacci_subtract",   "Fibonacci, cosine-weighted, exact unshadowed transfer less the blocked part",
      PRT_SAMPLE_FIBONACCI, COSINE, 1 },
    { "fibonacci_cosine",     "Fibonacci, cosine-weighted: prt_bake_transfer", PRT_SAMPLE_FIBONACCI, COSINE, 0 },
};
enum { SAMPLERS = sizeof samplers / sizeof *samplers, CHAPTER = 0, DEFAULT = SAMPLERS - 1 };
static const int ray_counts[] = { 64, 100, 144, 225, 324, 400, 484, 600, 900, 1225, 1600, 2500, 4096, 6400, 10000 };
enum { RAY_COUNTS = sizeof ray_counts / sizeof *ray_counts };

typedef struct workroom { prt_real *u, *v; prt_ray *rays; unsigned char *blocked; } workroom;

static prt_vec3 turned(prt_vec3 d, const prt_vec3 frame[3]) {
    prt_vec3 out;
    out.x = d.x * frame[0].x + d.y * frame[1].x + d.z * frame[2].x;
    out.y = d.x * frame[0].y + d.y * frame[1].y + d.z * frame[2].y;
    out.z = d.x * frame[0].z + d.y * frame[1].z + d.z * frame[2].z;
    return out;
}

static void frame_about(prt_vec3 n, prt_vec3 frame[3]) {
    double sign = n.z < 0 ? -1 : 1, a = -1 / (sign + n.z), b = n.x * n.y * a;
    frame[0].x = (prt_real)(1 + sign * n.x * n.x * a); frame[0].y = (prt_real)(sign * b);
    frame[0].z = (prt_real)(-sign * n.x);
    frame[1].x = (prt_real)b; frame[1].y = (prt_real)(sign + n.y * n.y * a); frame[1].z = -n.y;
    frame[2] = n;
}

/* Transfer at one point by the formula that belongs to the sampler's density: (1/pi) V cos Y / density, averaged. */
static void transfer_by(const sampler *s, int total, uint64_t seed, int index, prt_point p, prt_real bias,
                        const prt_tracer *tracer, workroom *w, double *out) {
    prt_vec3 frame[3];
    prt_real cosine_lobe[N];
    int k, i, traced = 0;
    frame_about(p.normal, frame);
    require(prt_sh_cosine_lobe(BANDS, p.normal, cosine_lobe), "cosine lobe");
    require(prt_sample_square(s->set, total, seed, (uint64_t)index, 0, total, w->u, w->v), "samples");
    for (k = 0; k < total; k++) {
        prt_ray *ray = &w->rays[traced];
        if (s->map == SPHERE) ray->dir = prt_sample_sphere(w->u[k], w->v[k]);
        else if (s->map == COSINE) ray->dir = turned(prt_sample_cosine(w->u[k], w->v[k]), frame);
        else ray->dir = turned(prt_sample_hemisphere(w->u[k], w->v[k]), frame);
        if (ray->dir.x * p.normal.x + ray->dir.y * p.normal.y + ray->dir.z * p.normal.z <= 0) continue;
        ray->origin.x = p.position.x + bias * p.normal.x;
        ray->origin.y = p.position.y + bias * p.normal.y;
        ray->origin.z = p.position.z + bias * p.normal.z;
        ray->tmin = 0; ray->tmax = 1e30f;
        traced++;
    }
    for (k = 0; k < traced; k += PRT_BAKE_BATCH) {
        int count = traced - k < PRT_BAKE_BATCH ? traced - k : PRT_BAKE_BATCH;
        if (tracer->occluded(tracer->user, count, w->rays + k, w->blocked + k)) require(PRT_ERR_TRACE, "rays");
    }
    for (i = 0; i < N; i++) out[i] = s->subtract ? cosine_lobe[i] / PRT__PI : 0;
    for (k = 0; k < traced; k++) {
        prt_vec3 d = w->rays[k].dir;
        double cosine = (double)(d.x * p.normal.x + d.y * p.normal.y + d.z * p.normal.z);
        double weight = s->map == SPHERE ? 4 * cosine : s->map == HEMISPHERE ? 2 * cosine : 1;
        prt_real y[N];
        if ((w->blocked[k] == 0) == s->subtract) continue;
        prt_sh_eval(BANDS, d, y);
        for (i = 0; i < N; i++) out[i] += (s->subtract ? -weight : weight) / total * (double)y[i];
    }
}

static void show(int done, int total, double start) {
    double left = (bench_seconds() - start) * (total - done) / done;
    fprintf(stderr, "\rbake: %3d %%, %.0f s left   %s", 100 * done / total, left, done == total ? "\n" : "");
}

/* Where the falling curve of errors crosses `level`, on logarithmic axes. */
static double rays_for(const double *error, double level) {
    int k = 1;
    while (k < RAY_COUNTS - 1 && error[k] > level) k++;
    return ray_counts[k - 1] * pow((double)ray_counts[k] / ray_counts[k - 1],
                                   log(error[k - 1] / level) / log(error[k - 1] / error[k]));
}

static void error(const mesh *m, const char *mesh_name, const prt_tracer *tracer, FILE *csv) {
    static double rms[SAMPLERS][RAY_COUNTS];
    const sampler reference_by = { "", "", PRT_SAMPLE_SOBOL, COSINE, 0 };
    int points = m->point_count < ERROR_POINTS ? m->point_count : ERROR_POINTS, p, s, q, i;
    double start = bench_seconds(), open = 0, chapter = 0;
    prt_real bias = (prt_real)1e-4 * m->report.radius;
    char more[160];
    workroom w;
    w.u = room(MOST, sizeof *w.u); w.v = room(MOST, sizeof *w.v);
    w.rays = room(MOST, sizeof *w.rays); w.blocked = room(MOST, 1);
    for (p = 0; p < points; p++) {
        int index = (int)((double)p * m->point_count / points);
        double want[N], got[N];
        transfer_by(&reference_by, REFERENCE, 1, index, m->points[index], bias, tracer, &w, want);
        open += want[0] * 2 * sqrt(PRT__PI) / points;
        for (s = 0; s < SAMPLERS; s++)
            for (q = 0; q < RAY_COUNTS; q++) {
                transfer_by(&samplers[s], ray_counts[q], 2, index, m->points[index], bias, tracer, &w, got);
                for (i = 0; i < N; i++) rms[s][q] += (got[i] - want[i]) * (got[i] - want[i]) / points;
            }
        show(p + 1, points, start);
    }
    snprintf(more, sizeof more, "%d bands, %d vertices, %.1f %% open, reference %d rays a point", BANDS, points,
             100 * open, REFERENCE);
    stamp(csv, "# ", mesh_name, more);
    stamp(stdout, "", mesh_name, more);
    fprintf(csv, "rays");
    printf("%6s", "rays");
    for (s = 0; s < SAMPLERS; s++) { fprintf(csv, ",%s", samplers[s].name); printf(" %20s", samplers[s].name); }
    for (q = 0; q < RAY_COUNTS; q++) {
        fprintf(csv, "\n%d", ray_counts[q]);
        printf("\n%6d", ray_counts[q]);
        for (s = 0; s < SAMPLERS; s++) {
            rms[s][q] = sqrt(rms[s][q]);
            fprintf(csv, ",%.6g", rms[s][q]);
            printf(" %20.6f", rms[s][q]);
        }
        if (ray_counts[q] == 2500) chapter = rms[CHAPTER][q];
    }
    fprintf(csv, "\n");
    printf("\n");
    printf("The error of 2500 samples of [Chapter 2010], %.5f, is reached with so many rays:\n", chapter);
    for (s = 0; s < SAMPLERS; s++)
        if (rms[s][RAY_COUNTS - 1] > chapter) printf(" >%d  %s\n", ray_counts[RAY_COUNTS - 1], samplers[s].label);
        else printf("%7.0f  %s\n", rays_for(rms[s], chapter), samplers[s].label);
    free(w.u); free(w.v); free(w.rays); free(w.blocked);
}

int main(int argc, char **argv) {
    const char *mesh_name = default_mesh, *csv_name = "/dev/null", *base;
    const command_option options[] = {
        { "--mesh", "FILE", "[bunny.obj of glmark2-data]", &mesh_name, NULL, 0, 0 },
        { "--csv", "FILE", "write every figure as comma-separated values", &csv_name, NULL, 0, 0 }
    };
    const command line = { "bake", "speed|error", NULL, options, 2 };
    embree_tracer embree;
    mesh m;
    why w;
    FILE *csv;
    if (command_read(&line, argc, argv) != 1 || (strcmp(argv[0], "speed") && strcmp(argv[0], "error"))) {
        fprintf(stderr, "bake: speed or error? (--help tells more)\n");
        return 2;
    }
    memset(&w, 0, sizeof w);
    if (mesh_load(mesh_name, MESH_Y_UP, &m, &w) || embree_tracer_create(&embree, &w) ||
        embree_tracer_add(&embree, &m, 0, &w) || embree_tracer_build(&embree, &w)) {
        fprintf(stderr, "bake: %s\n", w.line);
        return 1;
    }
    csv = command_open(&line, csv_name);
    base = strrchr(mesh_name, '/');
    base = base ? base + 1 : mesh_name;
    if (!strcmp(argv[0], "speed")) speed(&m, base, (RTCScene)embree.scene, csv);
    else error(&m, base, &embree.tracer, csv);
    if (command_close(&line, csv)) return 1;
    embree_tracer_destroy(&embree);
    mesh_free(&m);
    return 0;
}
