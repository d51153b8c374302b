/* trade.c - what bands, rays and bits of transfer cost in pictures: exit radiance at vertices of meshes under lights
   from an overcast sky to a bare sun, from transfer of every set-up, against ray tracing.

   trade [--csv FILE] [--points N] [--grid N] [--data DIRECTORY] [--threads N] [mesh ...]

   Truth: at each point a ray through every cell of a grid of N x N cells in every texel of a map of 256 x 128 (all
   lights share the answers), and 1024 rays to the sun's disc. An error is the root mean square over points and colours
   of the difference in exit radiance at albedo 1, negative radiance counted as 0, over the mean of the truth. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_job.h"
#include "bench.h"
#include "command.h"
#include "embree_tracer.h"
#include "image.h"
#include "mesh.h"
#include "parallel.h"
#include "program.h"

enum { WIDTH = 256, HEIGHT = 128, BANDS = 10, N = PRT_SH_COUNT(BANDS), MAPS = 6, LIGHTS = MAPS + 2, OVERCAST = MAPS,
       SUN = MAPS + 1, SUN_RAYS = 1024, STORAGES = 4 };
static const char *const map_files[MAPS] = { "forest.hdr", "courtyard.hdr", "interior.hdr", "sunrise.hdr", "sunset.hdr",
                                             "studio.hdr" };
static const int ray_counts[] = { 64, 256, 1024, 4096, 0 };            /* 0: the transfer of the truth's own rays */
enum { RAY_COUNTS = sizeof ray_counts / sizeof *ray_counts };
static const char *const storage_names[STORAGES] = { "float", "half", "16", "8" };
static const prt_vec3 sun = { (prt_real)0.6, 0, (prt_real)0.8 };
static const double sun_angle = 0.00465;                               /* radians: half of 32 minutes of arc */

typedef struct light {
    char name[32];
    image map;                         /* none for the sun */
    prt_real sh[3 * N];
} light;

typedef struct trade {
    const char *data;
    int points, grid, threads;
    light lights[LIGHTS];
} trade;

/* One mesh: what is traced, the points that are looked at, and the truth there. */
typedef struct subject {
    const trade *t;
    mesh scene;
    embree_tracer tracer;
    int count;
    prt_point *points;
    prt_rgb (*truth)[LIGHTS];          /* [count] */
    prt_real *transfer;                /* [count][N] from the truth's rays */
} subject;

static int fail(const char *reason) {
    fprintf(stderr, "trade: %s\n", reason);
    return 1;
}

static int load_lights(trade *t, why *w) {
    int k, i, c;
    for (k = 0; k < MAPS; k++) {
        char path[1024];
        light *l = &t->lights[k];
        snprintf(path, sizeof path, "%s/%s", t->data, map_files[k]);
        snprintf(l->name, sizeof l->name, "%.*s", (int)strcspn(map_files[k], "."), map_files[k]);
        if (image_load_environment(path, &l->map, w)) return -1;
        if (l->map.width != WIDTH || l->map.height != HEIGHT)
            return why_set(w, "%s: %d x %d texels are wanted", path, WIDTH, HEIGHT);
    }
    snprintf(t->lights[OVERCAST].name, sizeof t->lights[OVERCAST].name, "overcast sky");
    t->lights[OVERCAST].map.width = WIDTH;
    t->lights[OVERCAST].map.height = HEIGHT;
    t->lights[OVERCAST].map.rgb = (float *)malloc(sizeof(float) * 3 * WIDTH * HEIGHT);
    if (!t->lights[OVERCAST].map.rgb) return why_set(w, "out of memory");
    for (i = 0; i < WIDTH * HEIGHT; i++)           /* CIE: (1 + 2 z)/3 above the horizon, a ground of 0.2 below */
        for (c = 0; c < 3; c++) {
            double z = cos(PRT__PI * (i / WIDTH + 0.5) / HEIGHT);
            t->lights[OVERCAST].map.rgb[3 * i + c] = (float)(z > 0 ? (1 + 2 * z) / 3 : 0.2);
        }
    for (k = 0; k < SUN; k++)
        if (prt_sh_project_equirect_rgb(BANDS, WIDTH, HEIGHT, t->lights[k].map.rgb, t->lights[k].sh) != PRT_OK)
            return why_set(w, "%s cannot be projected", t->lights[k].name);
    snprintf(t->lights[SUN].name, sizeof t->lights[SUN].name, "bare sun");
    for (c = 0; c < 3; c++) prt_sh_cone(BANDS, sun, (prt_real)sun_angle, t->lights[SUN].sh + c * N);
    for (i = 0; i < 3 * N; i++) t->lights[SUN].sh[i] /= (prt_real)(sin(sun_angle) * sin(sun_angle));
    return 0;                                                          /* head-on it gives an exit radiance of 1 */
}

/* ---- truth ---- */

typedef struct workroom {
    prt_ray rays[PRT_BAKE_BATCH];
    unsigned char blocked[PRT_BAKE_BATCH];
    int texel[PRT_BAKE_BATCH], count;
    double weight[PRT_BAKE_BATCH];     /* cosine times solid angle over pi */
    double sum[LIGHTS][3], transfer[N];
} workroom;

/* Traces what has been collected and adds the open rays; texel -1 belongs to the sun. */
static int flush(const subject *s, workroom *room) {
    prt_real y[N];
    int k, l, i, c;
    memset(room->blocked, 0, sizeof room->blocked);
    if (room->count && s->tracer.tracer.occluded(s->tracer.tracer.user, room->count, room->rays, room->blocked))
        return -1;
    for (k = 0; k < room->count; k++) {
        if (room->blocked[k]) continue;
        if (room->texel[k] < 0) {
            for (c = 0; c < 3; c++) room->sum[SUN][c] += room->weight[k];
            continue;
        }
        for (l = 0; l < SUN; l++)
            for (c = 0; c < 3; c++)
                room->sum[l][c] += room->weight[k] * (double)s->t->lights[l].map.rgb[3 * room->texel[k] + c];
        prt_sh_eval(BANDS, room->rays[k].dir, y);
        for (i = 0; i < N; i++) room->transfer[i] += room->weight[k] * (double)y[i];
    }
    room->count = 0;
    return 0;
}

static int add_ray(const subject *s, const prt_point *p, prt_vec3 dir, int texel, double solid_angle, workroom *room) {
    prt_real bias = (prt_real)1e-4;
    prt_ray *ray = &room->rays[room->count];
    double cosine = (double)(dir.x * p->normal.x + dir.y * p->normal.y + dir.z * p->normal.z);
    if (!(cosine > 0)) return 0;
    ray->origin.x = p->position.x + bias * p->normal.x;
    ray->origin.y = p->position.y + bias * p->normal.y;
    ray->origin.z = p->position.z + bias * p->normal.z;
    ray->dir = dir;
    ray->tmin = 0;
    ray->tmax = FLT_MAX;
    room->texel[room->count] = texel;
    room->weight[room->count++] = cosine * solid_angle / PRT__PI;
    return room->count == PRT_BAKE_BATCH ? flush(s, room) : 0;
}

static prt_vec3 direction(double z, double phi) {
    double r = sqrt(z * z < 1 ? 1 - z * z : 0);
    prt_vec3 d;
    d.x = (prt_real)(r * cos(phi)); d.y = (prt_real)(r * sin(phi)); d.z = (prt_real)z;
    return d;
}

static int trace_sky(const subject *s, const prt_point *p, workroom *room) {
    int fine = s->t->grid, rows = HEIGHT * fine, columns = WIDTH * fine, i, j;
    for (j = 0; j < rows; j++) {
        double above = cos(PRT__PI * j / rows), below = cos(PRT__PI * (j + 1) / rows);
        double solid = (above - below) * 2 * PRT__PI / columns;
        for (i = 0; i < columns; i++)
            if (add_ray(s, p, direction((above + below) / 2, 2 * PRT__PI * (i + 0.5) / columns),
                        j / fine * WIDTH + i / fine, solid, room))
                return -1;
    }
    return flush(s, room);
}

static int trace_sun(const subject *s, const prt_point *p, workroom *room) {
    const prt_vec3 across = { (prt_real)0.8, 0, (prt_real)-0.6 }, up = { 0, 1, 0 };
    int k;
    for (k = 0; k < SUN_RAYS; k++) {               /* a spiral of equal areas over the disc */
        double r = sin(sun_angle) * sqrt((k + 0.5) / SUN_RAYS), phi = 2.399963229728653 * k, z = sqrt(1 - r * r);
        prt_vec3 d;
        d.x = (prt_real)(z * (double)sun.x + r * (cos(phi) * (double)across.x + sin(phi) * (double)up.x));
        d.y = (prt_real)(z * (double)sun.y + r * (cos(phi) * (double)across.y + sin(phi) * (double)up.y));
        d.z = (prt_real)(z * (double)sun.z + r * (cos(phi) * (double)across.z + sin(phi) * (double)up.z));
        if (add_ray(s, p, d, -1, PRT__PI / SUN_RAYS, room)) return -1;
    }
    return flush(s, room);
}

static int begin_truth(void *user, void **own) {
    (void)user;
    *own = malloc(sizeof(workroom));
    return *own ? 0 : -1;
}

static int truth_of_points(void *user, void *own, int first, int count) {
    subject *s = (subject *)user;
    workroom *room = (workroom *)own;
    int k, l, i;
    for (k = first; k < first + count; k++) {
        memset(room->sum, 0, sizeof room->sum);
        memset(room->transfer, 0, sizeof room->transfer);
        room->count = 0;
        if (trace_sky(s, &s->points[k], room) || trace_sun(s, &s->points[k], room)) return -1;
        for (l = 0; l < LIGHTS; l++) {
            s->truth[k][l].r = (prt_real)room->sum[l][0];
            s->truth[k][l].g = (prt_real)room->sum[l][1];
            s->truth[k][l].b = (prt_real)room->sum[l][2];
        }
        for (i = 0; i < N; i++) s->transfer[(size_t)k * N + (size_t)i] = (prt_real)room->transfer[i];
    }
    return 0;
}

static int find_truth(subject *s, const char *name, why *w) {
    parallel p;
    char what[128];
    snprintf(what, sizeof what, "trade: rays at %s", name);
    memset(&p, 0, sizeof p);
    p.count = s->count;
    p.chunk = 4;
    p.threads = s->t->threads;
    p.what = what;
    p.unit = "points";
    p.unit_per_item = 1;
    p.stop = &interrupted;
    p.begin = begin_truth;
    p.work = truth_of_points;
    p.end = free;
    p.user = s;
    if (parallel_run(&p, w)) return -1;
    return p.done < s->count ? why_set(w, "interrupted") : 0;
}

/* ---- set-ups ---- */

/* Exit radiance under the light from transfer of the first bands, stored as named, to `out`; `exact` keeps that of the
   last call with floats. */
typedef struct shelf { prt_real *rows; uint16_t *data; prt_rgb *out, *exact; } shelf;

static void shade(const subject *s, const prt_real *transfer, int bands, int storage, const light *l, const shelf *to) {
    int n = PRT_SH_COUNT(bands), k, c;
    prt_real sh[3 * N], low[N], step[N];
    for (c = 0; c < 3; c++) memcpy(sh + c * n, l->sh + c * N, (size_t)n * sizeof *sh);
    for (k = 0; k < s->count; k++)
        memcpy(to->rows + (size_t)k * (size_t)n, transfer + (size_t)k * N, (size_t)n * sizeof *sh);
    if (storage == 0) {
        prt_shade_diffuse_n(bands, s->count, to->rows, sh, to->exact);
        memcpy(to->out, to->exact, (size_t)s->count * sizeof *to->out);
    } else {
        prt_packed_transfer packed;
        prt_transfer_pack(bands, (prt_storage)(storage - 1), s->count, to->rows, to->data, low, step, &packed);
        prt_shade_packed_n(&packed, 0, s->count, sh, to->out);
    }
}

static double part(prt_real got, prt_real want) {
    double v = (got > 0 ? (double)got : 0) - (want > 0 ? (double)want : 0);
    return v * v;
}

/* Against the truth under light l, or with `exact` against that; in both cases over the mean of the truth. */
static double rmse(const subject *s, int l, const prt_rgb *out, const prt_rgb *exact) {
    double squares = 0, sum = 0;
    int k;
    for (k = 0; k < s->count; k++) {
        const prt_rgb *truth = &s->truth[k][l], *want = exact ? &exact[k] : truth;
        squares += part(out[k].r, want->r) + part(out[k].g, want->g) + part(out[k].b, want->b);
        sum += (double)truth->r + (double)truth->g + (double)truth->b;
    }
    return sum > 0 ? sqrt(squares / (3.0 * s->count)) / (sum / (3.0 * s->count)) : 0;
}

static int bake(const subject *s, int rays, prt_real *transfer, why *w) {
    bake_job job;
    prt_result r;
    memset(&job, 0, sizeof job);
    job.desc.bands = BANDS;
    job.desc.samples = rays;
    job.desc.bias = (prt_real)1e-4;
    job.desc.tracer = &s->tracer.tracer;
    job.point_count = s->count;
    job.points = s->points;
    job.threads = s->t->threads;
    job.stop = &interrupted;
    job.transfer = transfer;
    job.done = (unsigned char *)calloc((size_t)s->count, 1);
    if (!job.done) return why_set(w, "out of memory");
    r = bake_job_run(&job);
    free(job.done);
    return r == PRT_OK ? 0 : why_set(w, "baking: %s", prt_result_string(r));
}

static int try_all(const subject *s, const char *name, FILE *csv, why *w) {
    size_t room = (size_t)s->count * N;
    prt_real *baked = (prt_real *)malloc(room * sizeof *baked);
    shelf to;
    int r, bands, storage, l, failed = 0;
    to.rows = (prt_real *)malloc(room * sizeof *to.rows);
    to.data = (uint16_t *)malloc(room * sizeof *to.data);
    to.out = (prt_rgb *)malloc((size_t)s->count * sizeof *to.out);
    to.exact = (prt_rgb *)malloc((size_t)s->count * sizeof *to.exact);
    if (!baked || !to.rows || !to.data || !to.out || !to.exact) failed = why_set(w, "out of memory");
    for (r = 0; r < RAY_COUNTS && !failed; r++) {
        const prt_real *transfer = ray_counts[r] ? baked : s->transfer;
        if (ray_counts[r] && bake(s, ray_counts[r], baked, w)) failed = -1;
        for (bands = 1; bands <= BANDS && !failed; bands++)
            for (l = 0; l < LIGHTS; l++)
                for (storage = 0; storage < STORAGES; storage++) {
                    shade(s, transfer, bands, storage, &s->t->lights[l], &to);
                    fprintf(csv, "%s,%s,%d,%d,%s,%.5g,%.3g\n", name, s->t->lights[l].name, bands, ray_counts[r],
                            storage_names[storage], rmse(s, l, to.out, NULL), rmse(s, l, to.out, to.exact));
                }
    }
    free(baked); free(to.rows); free(to.data); free(to.out); free(to.exact);
    return failed;
}

/* ---- subjects ---- */

static int choose_points(subject *s, why *w) {
    int k, used = s->scene.point_count < s->t->points ? s->scene.point_count : s->t->points;
    s->points = (prt_point *)malloc((size_t)used * sizeof *s->points);
    s->truth = (prt_rgb (*)[LIGHTS])malloc((size_t)used * sizeof *s->truth);
    s->transfer = (prt_real *)malloc((size_t)used * N * sizeof *s->transfer);
    if (!s->points || !s->truth || !s->transfer) return why_set(w, "out of memory");
    for (k = 0; k < used; k++) s->points[k] = s->scene.points[(size_t)k * (size_t)s->scene.point_count / (size_t)used];
    s->count = used;
    return 0;
}

static int load(subject *s, const char *path, why *w) {
    prt_vec3 under = { 0, 0, 0 };
    int k;
    if (mesh_load(path, MESH_Y_UP, &s->scene, w) || mesh_fit_unit_sphere(&s->scene, w) || choose_points(s, w))
        return -1;
    for (k = 0; k < s->scene.point_count; k++)
        if (s->scene.points[k].position.z < under.z) under.z = s->scene.points[k].position.z;
    if (mesh_add_floor(&s->scene, under, (prt_real)1.25, (prt_real)0.1, w)) return -1;
    return embree_tracer_create(&s->tracer, w) || embree_tracer_add(&s->tracer, &s->scene, 0, w) ||
           embree_tracer_build(&s->tracer, w) ? -1 : 0;
}

static int measure(const trade *t, const char *path, FILE *csv, why *w) {
    const char *base = strrchr(path, '/');
    char name[64];
    subject s;
    int failed;
    memset(&s, 0, sizeof s);
    s.t = t;
    base = base ? base + 1 : path;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(base, ".,"), base);
    failed = load(&s, path, w) || find_truth(&s, name, w) || try_all(&s, name, csv, w) ? -1 : 0;
    if (s.tracer.device) embree_tracer_destroy(&s.tracer);
    mesh_free(&s.scene);
    free(s.points); free(s.truth); free(s.transfer);
    return failed;
}

int main(int argc, char **argv) {
    static trade t = { PRT_EXAMPLE_DATA, 512, 4, 1, { { "", { 0 }, { 0 } } } };
    static char bunny[] = "/usr/share/glmark2/models/bunny.obj", horse[] = "/usr/share/glmark2/models/horse.3ds";
    char *standard[] = { bunny, horse }, **meshes = argv;
    const char *csv_name = NULL;
    const command_option options[] = {
        { "--csv", "FILE", "where to write [standard output]", &csv_name, NULL, 0, 0 },
        { "--points", "N", "vertices of each mesh that are looked at [512]", NULL, &t.points, 1, 100000 },
        { "--grid", "N", "rays a texel of the truth: N x N [4]", NULL, &t.grid, 1, 16 },
        { "--data", "DIRECTORY", "where forest.hdr and the others are [" PRT_EXAMPLE_DATA "]", &t.data, NULL, 0, 0 },
        { "--threads", "N", "[all processors]", NULL, &t.threads, 1, 1024 }
    };
    const command line = { "trade", "[mesh ...]",
                           "Meshes are put on a floor [bunny.obj and horse.3ds of glmark2-data].\n", options, 5 };
    int count, k, failed = 0;
    FILE *csv;
    why w;
    memset(&w, 0, sizeof w);
    t.threads = processor_count();
    count = command_read(&line, argc, argv);
    if (count == 0) { meshes = standard; count = 2; }
    if (load_lights(&t, &w)) return fail(w.line);
    csv = csv_name ? command_open(&line, csv_name) : stdout;
    stop_on(SIGINT);
    fprintf(csv, "# prt.h %s\n# machine: %s\n# compiler: %s\n# flags: %s\n# points: %d\n# rays of the truth: %d x %d\n",
            BENCH_VERSION, bench_cpu_name(), BENCH_COMPILER, BENCH_FLAGS, t.points, WIDTH * t.grid, HEIGHT * t.grid);
    fprintf(csv, "mesh,light,bands,rays,storage,rmse,off_float\n");
    for (k = 0; k < count && !failed; k++) failed = measure(&t, meshes[k], csv, &w);
    if (failed) fail(w.line);
    failed |= command_close(&line, csv);
    for (k = 0; k < SUN; k++) image_free(&t.lights[k].map);
    return interrupted ? STOPPED : failed != 0;
}
