/* demo: the Stanford bunny under three environments, lit from transfer of 3, 5 and 8 bands, beside the ray-traced truth.

   Writes DIR/demo.png, a contact sheet with one row an environment, and DIR/demo.csv with its figures. Columns: 8 bands
   without shadows; 3, 5 and 8 bands with shadows; direct light by Monte Carlo ray tracing from the same camera, thousands
   of shadow rays a pixel. What each number means:

     RMSE    root mean square error of linear radiance against the reference, all colours, over the pixels that bunny and
             pedestal cover whole (the table adds it for the bunny's alone), divided by the mean of the reference there.
             Negative radiance counts as 0, which is what the screen shows. The reference comes in two independent halves
             R0, R1; the mean of (P-R0)(P-R1) is free of their noise.
     floor   the same of a picture whose every sample has transfer of its own: visibility traced and projected at the
             sample itself, nothing interpolated between vertices. No baker can do better with so many bands of light and
             transfer; what the demo's picture has beyond it is the price of baking at vertices.
     noise   standard error of the reference picture itself, from the difference of its halves, in the same units.
     time    of the processor, all cores together, so that other programs do not count. bake: once for any light; frame:
             drawing the mesh at four samples a pixel (llvmpipe). */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "bake_job.h"
#include "embree_tracer.h"
#include "image.h"
#include "mesh.h"
#include "osmesa_context.h"
#include "progress.h"
#include "relighter.h"
#include "text.h"

enum {
    ENVIRONMENTS = 3, MOST_BANDS = 8, COEFFICIENTS = MOST_BANDS * MOST_BANDS, SHADOWED = 3, SAMPLES_A_PIXEL = 2,
    HALVES = 2,
    COSINE_RAYS = 512, LIGHT_RAYS = 256                    /* a sample and half; the light's for each environment */
};

/* What a sample shows, in a reference picture's alpha. */
static const float pedestal_alpha = 0.5f, bunny_alpha = 1;

static const int shadowed_bands[SHADOWED] = { 3, 5, 8 };

/* Each environment is turned about the vertical, so that one camera shows all of them from their best side. */
static const struct { const char *file; double turn; } choice[ENVIRONMENTS] = {
    { "courtyard.hdr", 0 }, { "studio.hdr", 0.625 }, { "sunset.hdr", 0.875 }
};

static volatile sig_atomic_t interrupted;
static void on_interrupt(int number) {
    interrupted = 1;
    signal(number, SIG_DFL);
}

/* ---- an environment as the reference sees it ---- */

typedef struct environment {
    char   name[32];
    image  map;
    prt_real light[3 * COEFFICIENTS];
    double *cumulative;                /* [texels + 1] of luminance times solid angle, 0 to 1 */
    double scale;                      /* density of a direction: luminance of its texel times this */
} environment;

static double luminance_at(const image *map, size_t texel) {
    const float *v = map->rgb + 3 * texel;
    return 0.2126 * (double)v[0] + 0.7152 * (double)v[1] + 0.0722 * (double)v[2];
}

static int environment_tabulate(environment *e, why *w) {
    const double pi = 3.14159265358979323846;
    size_t width = (size_t)e->map.width, count = width * (size_t)e->map.height, k;
    double sum = 0;
    e->cumulative = (double *)malloc((count + 1) * sizeof *e->cumulative);
    if (!e->cumulative) return why_set(w, "out of memory");
    for (k = 0; k < count; k++) {
        double row = (double)(k / width);
        double solid_angle = (cos(pi * row / e->map.height) - cos(pi * (row + 1) / e->map.height)) * 2 * pi / e->map.width;
        e->cumulative[k] = sum;
        sum += luminance_at(&e->map, k) * solid_angle;
    }
    if (!(sum > 0)) return why_set(w, "%s: the environment is black", e->name);
    e->cumulative[count] = sum;
    for (k = 0; k <= count; k++) e->cumulative[k] /= sum;
    e->scale = 1 / sum;
    return 0;
}

static void turn_map(image *map, double turn) {
    int shift = (int)(turn * map->width + 0.5) % map->width, y, x;
    float *row = (float *)malloc(3 * sizeof(float) * (size_t)map->width);
    if (!row) return;
    for (y = 0; y < map->height; y++) {
        float *in = map->rgb + 3 * (size_t)map->width * (size_t)y;
        for (x = 0; x < map->width; x++) memcpy(row + 3 * ((x + shift) % map->width), in + 3 * x, 3 * sizeof(float));
        memcpy(in, row, 3 * sizeof(float) * (size_t)map->width);
    }
    free(row);
}

static int environment_load(const char *directory, int k, environment *e, why *w) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s", directory, choice[k].file);
    snprintf(e->name, sizeof e->name, "%.*s", (int)strcspn(choice[k].file, "."), choice[k].file);
    if (image_load_environment(path, &e->map, w)) return -1;
    turn_map(&e->map, choice[k].turn);
    if (prt_sh_project_equirect_rgb(MOST_BANDS, e->map.width, e->map.height, e->map.rgb, e->light) != PRT_OK)
        return why_set(w, "%s: cannot be projected", path);
    return environment_tabulate(e, w);
}

static void environment_free(environment *e) {
    image_free(&e->map);
    free(e->cumulative);
}

/* The first bands of the light. */
static void light_of(const environment *e, int bands, prt_real *light) {
    int c;
    for (c = 0; c < 3; c++)
        memcpy(light + c * PRT_SH_COUNT(bands), e->light + c * COEFFICIENTS, (size_t)PRT_SH_COUNT(bands) * sizeof *light);
}

static size_t texel_of(const image *map, prt_vec3 d) {
    const double pi = 3.14159265358979323846;
    double phi = atan2((double)d.y, (double)d.x);
    int x = (int)((phi < 0 ? phi + 2 * pi : phi) / (2 * pi) * map->width);
    int y = (int)(acos(d.z > 1 ? 1 : d.z < -1 ? -1 : (double)d.z) / pi * map->height);
    if (x >= map->width) x = map->width - 1;
    if (y >= map->height) y = map->height - 1;
    return (size_t)y * (size_t)map->width + (size_t)x;
}

/* A direction with density luminance * scale: u chooses the texel and the place across it, v the place down it. */
static prt_vec3 environment_sample(const environment *e, double u, double v, size_t *texel) {
    const double pi = 3.14159265358979323846;
    size_t low = 0, high = (size_t)e->map.width * (size_t)e->map.height;
    double top, bottom, z, across, phi, r;
    prt_vec3 d;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (e->cumulative[middle] <= u) low = middle; else high = middle;
    }
    across = (u - e->cumulative[low]) / (e->cumulative[low + 1] - e->cumulative[low]);
    top = cos(pi * (double)(low / (size_t)e->map.width) / e->map.height);
    bottom = cos(pi * (double)(low / (size_t)e->map.width + 1) / e->map.height);
    z = top + v * (bottom - top);
    phi = 2 * pi * ((double)(low % (size_t)e->map.width) + across) / e->map.width;
    r = sqrt(z * z < 1 ? 1 - z * z : 0);
    d.x = (prt_real)(r * cos(phi));
    d.y = (prt_real)(r * sin(phi));
    d.z = (prt_real)z;
    *texel = low;
    return d;
}

/* ---- the reference ---- */

typedef struct truth {                 /* [environment], [environment][bands] */
    picture reference[ENVIRONMENTS], floor[ENVIRONMENTS][SHADOWED];
} truth;

typedef struct reference_job {
    const mesh          *scene;
    int                 bunny_triangles;                   /* the scene's first; the rest are the pedestal */
    const prt_tracer    *tracer;
    const environment   *environments;
    camera              eye;
    prt_real            bias;
    int                 width, height;
    truth               halves[HALVES];
    pthread_mutex_t     lock;
    int                 next_row;
    int                 failed;
} reference_job;

typedef struct sample_rays {           /* the shadow rays of one sample, with scratch for their results */
    prt_vec3      cosine[COSINE_RAYS], light[LIGHT_RAYS];
    size_t        texel[LIGHT_RAYS];
    prt_real      u[LIGHT_RAYS], v[LIGHT_RAYS];
    prt_ray       rays[COSINE_RAYS];
    unsigned char blocked[COSINE_RAYS];
    prt_real      x[COSINE_RAYS], y[COSINE_RAYS], z[COSINE_RAYS];
    prt_real      basis[COEFFICIENTS * COSINE_RAYS];
} sample_rays;

static double dot3(prt_vec3 a, prt_vec3 b) {
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

static int trace(const reference_job *job, const prt_point *at, int count, const prt_vec3 *dirs, sample_rays *s) {
    int k;
    for (k = 0; k < count; k++) {
        s->rays[k].origin.x = at->position.x + job->bias * at->normal.x;
        s->rays[k].origin.y = at->position.y + job->bias * at->normal.y;
        s->rays[k].origin.z = at->position.z + job->bias * at->normal.z;
        s->rays[k].dir = dirs[k];
        s->rays[k].tmin = 0;
        s->rays[k].tmax = (prt_real)1e6;
        s->blocked[k] = 0;
    }
    return job->tracer->occluded(job->tracer->user, count, s->rays, s->blocked);
}

/* One open ray's share under the balance heuristic [Veach 1995]: cos/pi L / (n_cosine p_cosine + n_light p_light). */
static void add_ray(const environment *e, size_t texel, double cosine, double sum[3]) {
    double over_pi = cosine / 3.14159265358979323846;
    double density = COSINE_RAYS * over_pi + LIGHT_RAYS * luminance_at(&e->map, texel) * e->scale;
    int c;
    if (!(density > 0)) return;
    for (c = 0; c < 3; c++) sum[c] += (double)e->map.rgb[3 * texel + (size_t)c] * over_pi / density;
}

static void store(picture *p, size_t at, const double sum[3], float alpha) {
    int c;
    for (c = 0; c < 3; c++) p->rgba[4 * at + (size_t)c] = (float)sum[c];
    p->rgba[4 * at + 3] = alpha;
}

/* Transfer of this one sample from its open cosine rays, dotted with the light of every environment and band count. */
static void store_floor(const reference_job *job, truth *t, size_t at, sample_rays *s) {
    prt_real transfer[COEFFICIENTS], light[3 * COEFFICIENTS];
    prt_rgb out;
    int open = 0, e, b, i, k;
    for (k = 0; k < COSINE_RAYS; k++) {
        if (s->blocked[k]) continue;
        s->x[open] = s->cosine[k].x; s->y[open] = s->cosine[k].y; s->z[open] = s->cosine[k].z;
        open++;
    }
    prt_sh_eval_soa(MOST_BANDS, open, s->x, s->y, s->z, s->basis, COSINE_RAYS);
    for (i = 0; i < COEFFICIENTS; i++) {
        prt_real sum = 0;
        for (k = 0; k < open; k++) sum += s->basis[i * COSINE_RAYS + k];
        transfer[i] = sum / COSINE_RAYS;
    }
    for (e = 0; e < ENVIRONMENTS; e++) {
        for (b = 0; b < SHADOWED; b++) {
            double sum[3];
            light_of(&job->environments[e], shadowed_bands[b], light);
            prt_shade_diffuse(shadowed_bands[b], transfer, light, &out);
            sum[0] = (double)out.r; sum[1] = (double)out.g; sum[2] = (double)out.b;
            store(&t->floor[e][b], at, sum, bunny_alpha);
        }
    }
}

static int shade_sample(reference_job *job, int half, size_t at, const prt_point *point, float alpha, sample_rays *s) {
    truth *t = &job->halves[half];
    double sum[ENVIRONMENTS][3] = { { 0 } };
    uint64_t seed = (uint64_t)half + 1;
    int e, k;
    prt_sample_directions(COSINE_RAYS, seed, at, point->normal, 0, COSINE_RAYS, s->cosine);
    if (trace(job, point, COSINE_RAYS, s->cosine, s)) return -1;
    store_floor(job, t, at, s);
    for (e = 0; e < ENVIRONMENTS; e++)
        for (k = 0; k < COSINE_RAYS; k++)
            if (!s->blocked[k])
                add_ray(&job->environments[e], texel_of(&job->environments[e].map, s->cosine[k]),
                        dot3(s->cosine[k], point->normal), sum[e]);
    for (e = 0; e < ENVIRONMENTS; e++) {
        int above = 0;
        prt_sample_square(PRT_SAMPLE_SOBOL, LIGHT_RAYS, seed + HALVES * (uint64_t)(e + 1), at, 0, LIGHT_RAYS, s->u, s->v);
        for (k = 0; k < LIGHT_RAYS; k++) {
            s->light[above] = environment_sample(&job->environments[e], (double)s->u[k], (double)s->v[k], &s->texel[above]);
            above += dot3(s->light[above], point->normal) > 0;
        }
        if (trace(job, point, above, s->light, s)) return -1;
        for (k = 0; k < above; k++)
            if (!s->blocked[k]) add_ray(&job->environments[e], s->texel[k], dot3(s->light[k], point->normal), sum[e]);
        store(&t->reference[e], at, sum[e], alpha);
    }
    return 0;
}

static prt_vec3 blend(const prt_vec3 *a, const prt_vec3 *b, const prt_vec3 *c, prt_real u, prt_real v) {
    prt_vec3 r;
    prt_real w = 1 - u - v;
    r.x = w * a->x + u * b->x + v * c->x;
    r.y = w * a->y + u * b->y + v * c->y;
    r.z = w * a->z + u * b->z + v * c->z;
    return r;
}

/* The place where a hit lies, with the interpolated normal of unit length that its cosine and its bias use. */
static prt_point point_of(const mesh *m, const prt_hit *hit) {
    const uint32_t *corner = m->triangles + 3 * (size_t)hit->primitive;
    const prt_point *a = m->points + corner[0], *b = m->points + corner[1], *c = m->points + corner[2];
    prt_point p;
    prt_real length;
    p.position = blend(&a->position, &b->position, &c->position, hit->u, hit->v);
    p.normal = blend(&a->normal, &b->normal, &c->normal, hit->u, hit->v);
    length = (prt_real)sqrt(dot3(p.normal, p.normal));
    if (!(length > 0)) return *a;
    p.normal.x /= length; p.normal.y /= length; p.normal.z /= length;
    return p;
}

static int shade_row(reference_job *job, int y, prt_ray *eye_rays, prt_hit *hits, sample_rays *s) {
    camera_frame f = camera_make_frame(&job->eye, (double)job->width / job->height);
    int x, half;
    for (x = 0; x < job->width; x++) {
        double across = 2 * (x + 0.5) / job->width - 1, up = 1 - 2 * (y + 0.5) / job->height, d[3], length;
        int k;
        for (k = 0; k < 3; k++) d[k] = f.forward[k] + across * f.right[k] + up * f.up[k];
        length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        eye_rays[x].origin = job->eye.eye;
        eye_rays[x].dir.x = (prt_real)(d[0] / length);
        eye_rays[x].dir.y = (prt_real)(d[1] / length);
        eye_rays[x].dir.z = (prt_real)(d[2] / length);
        eye_rays[x].tmin = 0;
        eye_rays[x].tmax = (prt_real)1e6;
    }
    if (job->tracer->closest(job->tracer->user, job->width, eye_rays, hits)) return -1;
    for (x = 0; x < job->width; x++) {
        float alpha = hits[x].primitive < job->bunny_triangles ? bunny_alpha : pedestal_alpha;
        prt_point p;
        if (hits[x].object < 0) continue;
        p = point_of(job->scene, &hits[x]);
        for (half = 0; half < HALVES; half++)
            if (shade_sample(job, half, (size_t)y * (size_t)job->width + (size_t)x, &p, alpha, s)) return -1;
    }
    return 0;
}

static void *shade_rows(void *user) {
    reference_job *job = (reference_job *)user;
    prt_ray *rays = (prt_ray *)malloc((size_t)job->width * sizeof *rays);
    prt_hit *hits = (prt_hit *)malloc((size_t)job->width * sizeof *hits);
    sample_rays *s = (sample_rays *)malloc(sizeof *s);
    int failed = !rays || !hits || !s;
    for (;;) {
        int row;
        pthread_mutex_lock(&job->lock);
        job->failed |= failed;
        row = job->failed || interrupted || job->next_row >= job->height ? -1 : job->next_row++;
        pthread_mutex_unlock(&job->lock);
        if (row < 0) break;
        failed = shade_row(job, row, rays, hits, s);
    }
    free(rays);
    free(hits);
    free(s);
    return NULL;
}

static int trace_reference(reference_job *job, int threads, why *w) {
    pthread_t thread[256];
    progress p;
    int started = 0, row = 0;
    pthread_mutex_init(&job->lock, NULL);
    progress_start(&p, "demo: reference", job->height, 0, "rows", 1);
    while (started < threads && pthread_create(&thread[started], NULL, shade_rows, job) == 0) started++;
    while (started > 0 && row < job->height) {
        const struct timespec pause = { 0, 100000000 };
        nanosleep(&pause, NULL);
        pthread_mutex_lock(&job->lock);
        row = job->failed || interrupted ? job->height : job->next_row;
        progress_show(&p, job->next_row);
        pthread_mutex_unlock(&job->lock);
    }
    job->failed |= started == 0;
    while (started > 0) pthread_join(thread[--started], NULL);
    progress_end(&p, job->next_row);
    pthread_mutex_destroy(&job->lock);
    return job->failed ? why_set(w, "the reference could not be traced") : 0;
}

/* ---- figures ---- */

/* A pixel's radiance, as the screen would show it: the mean over its samples, none below 0. -1: a sample's alpha is
   below `least`. */
static int pixel_of(const picture *p, int x, int y, float least, double rgb[3]) {
    int i, j, c;
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (j = 0; j < SAMPLES_A_PIXEL; j++) {
        for (i = 0; i < SAMPLES_A_PIXEL; i++) {
            const float *s = p->rgba + 4 * ((size_t)(y * SAMPLES_A_PIXEL + j) * (size_t)p->width +
                                            (size_t)(x * SAMPLES_A_PIXEL + i));
            if (s[3] < least) return -1;
            for (c = 0; c < 3; c++) rgb[c] += (s[c] > 0 ? (double)s[c] : 0) / (SAMPLES_A_PIXEL * SAMPLES_A_PIXEL);
        }
    }
    return 0;
}

/* The root of the mean of (a0-b0)(a1-b1) over the pixels that all cover whole with surfaces of at least this alpha in
   b0, divided by the mean of b0 and b1 there. Independent noise in the two factors leaves the mean alone. */
static double relative_error(const picture *a0, const picture *a1, const picture *b0, const picture *b1, float least) {
    double products = 0, sum = 0, va0[3], va1[3], vb0[3], vb1[3];
    int x, y, c;
    double count = 0;
    for (y = 0; y < a0->height / SAMPLES_A_PIXEL; y++) {
        for (x = 0; x < a0->width / SAMPLES_A_PIXEL; x++) {
            if (pixel_of(b0, x, y, least, vb0) || pixel_of(b1, x, y, least, vb1) ||
                pixel_of(a0, x, y, pedestal_alpha, va0) || pixel_of(a1, x, y, pedestal_alpha, va1))
                continue;
            for (c = 0; c < 3; c++) {
                products += (va0[c] - vb0[c]) * (va1[c] - vb1[c]);
                sum += 0.5 * (vb0[c] + vb1[c]);
            }
            count += 3;
        }
    }
    return sum > 0 && products > 0 ? sqrt(products / count) / (sum / count) : 0;
}

/* ---- the whole ---- */

enum { UNSHADOWED = 0, REFERENCE = SHADOWED + 1, COLUMNS = SHADOWED + 2 };

typedef struct cell { picture picture; double rmse, floor, bunny_rmse, bunny_floor, seconds; } cell;

typedef struct demo {
    const char    *mesh_path, *data, *out;
    int           rays, size, threads;
    mesh          scene;
    embree_tracer tracer;
    environment   environments[ENVIRONMENTS];
    reference_job reference;
    camera        eye;
    prt_real      *transfer[COLUMNS - 1];
    double        bake_seconds[COLUMNS - 1], reference_seconds, noise[ENVIRONMENTS];
    cell          cells[ENVIRONMENTS][COLUMNS];
} demo;

static int bands_of(int column) { return column == UNSHADOWED ? MOST_BANDS : shadowed_bands[column - 1]; }

static int load_scene(demo *d, why *w) {
    const prt_vec3 target = { 0, 0, (prt_real)-0.06 };
    prt_vec3 under = { 0, 0, 0 };
    int k;
    for (k = 0; k < ENVIRONMENTS; k++) if (environment_load(d->data, k, &d->environments[k], w)) return -1;
    if (mesh_load(d->mesh_path, MESH_Y_UP, &d->scene, w) || mesh_fit_unit_sphere(&d->scene, w)) return -1;
    for (k = 0; k < d->scene.point_count; k++)
        if (d->scene.points[k].position.z < under.z) under.z = d->scene.points[k].position.z;
    d->reference.bunny_triangles = d->scene.triangle_count;
    if (mesh_add_floor(&d->scene, under, (prt_real)1.25, (prt_real)0.0125, w)) return -1;
    d->eye = camera_orbit(target, 4.2, -1.3, 0.3, 0.5);
    return embree_tracer_create(&d->tracer, w) || embree_tracer_add(&d->tracer, &d->scene, 0, w) ||
           embree_tracer_build(&d->tracer, w) ? -1 : 0;
}

/* Without shadows transfer is a cosine lobe over pi: no ray needed. */
static void bake_unshadowed(const mesh *m, prt_real *transfer) {
    int k, i;
    for (k = 0; k < m->point_count; k++) {
        prt_real *row = transfer + (size_t)k * COEFFICIENTS;
        prt_sh_cosine_lobe(MOST_BANDS, m->points[k].normal, row);
        for (i = 0; i < COEFFICIENTS; i++) row[i] *= (prt_real)0.31830988618379067154;
    }
}

static int bake_shadowed(const demo *d, int bands, prt_real *transfer, why *w) {
    char what[40];
    bake_job job;
    prt_result result;
    memset(&job, 0, sizeof job);
    snprintf(what, sizeof what, "demo: bake %d bands", bands);
    job.desc.bands = bands;
    job.desc.samples = d->rays;
    job.desc.bias = (prt_real)1e-4;
    job.desc.tracer = &d->tracer.tracer;
    job.point_count = d->scene.point_count;
    job.points = d->scene.points;
    job.threads = d->threads;
    job.what = what;
    job.stop = &interrupted;
    job.transfer = transfer;
    job.done = (unsigned char *)calloc((size_t)job.point_count, 1);
    if (!job.done) return why_set(w, "out of memory");
    result = bake_job_run(&job);
    free(job.done);
    return result == PRT_OK ? 0 : why_set(w, "bake: %s", prt_result_string(result));
}

static int bake_all(demo *d, why *w) {
    int column;
    for (column = 0; column < COLUMNS - 1; column++) {
        size_t row = (size_t)PRT_SH_COUNT(bands_of(column));
        double before = processor_seconds();
        d->transfer[column] = (prt_real *)malloc((size_t)d->scene.point_count * row * sizeof(prt_real));
        if (!d->transfer[column]) return why_set(w, "out of memory");
        if (column == UNSHADOWED) bake_unshadowed(&d->scene, d->transfer[column]);
        else if (bake_shadowed(d, bands_of(column), d->transfer[column], w)) return -1;
        d->bake_seconds[column] = processor_seconds() - before;
    }
    return 0;
}

/* The second drawing is timed: the first may still compile its shader. */
static int draw_column(demo *d, relighter *r, int column, why *w) {
    int samples = d->size * SAMPLES_A_PIXEL, e;
    if (relighter_set_transfer(r, bands_of(column), d->scene.point_count, d->transfer[column], w)) return -1;
    for (e = 0; e < ENVIRONMENTS; e++) {
        prt_real light[3 * COEFFICIENTS];
        cell *c = &d->cells[e][column];
        light_of(&d->environments[e], bands_of(column), light);
        if (picture_create(samples, samples, &c->picture, w) ||
            relighter_set_environment(r, &d->environments[e].map, w) ||
            relighter_draw(r, &d->eye, light, 1, NULL, NULL, w) ||
            relighter_draw(r, &d->eye, light, 1, &c->picture, &c->seconds, w))
            return -1;
    }
    return 0;
}

static int draw_all(demo *d, why *w) {
    int samples = d->size * SAMPLES_A_PIXEL, column, failed;
    osmesa_context context;
    relighter r;
    if (osmesa_context_create(&context, w)) return -1;
    failed = relighter_create(&r, &d->scene, samples, samples, w);
    for (column = 0; column < COLUMNS - 1 && !failed; column++) failed = draw_column(d, &r, column, w);
    relighter_destroy(&r);
    osmesa_context_destroy(&context);
    return failed;
}

static int make_halves(reference_job *job, why *w) {
    int half, e, b;
    for (half = 0; half < HALVES; half++) {
        for (e = 0; e < ENVIRONMENTS; e++) {
            if (picture_create(job->width, job->height, &job->halves[half].reference[e], w)) return -1;
            for (b = 0; b < SHADOWED; b++)
                if (picture_create(job->width, job->height, &job->halves[half].floor[e][b], w)) return -1;
        }
    }
    return 0;
}

static int trace_all(demo *d, why *w) {
    reference_job *job = &d->reference;
    double before;
    job->scene = &d->scene;
    job->tracer = &d->tracer.tracer;
    job->environments = d->environments;
    job->eye = d->eye;
    job->bias = (prt_real)1e-4;
    job->width = job->height = d->size * SAMPLES_A_PIXEL;
    before = processor_seconds();
    if (make_halves(job, w) || trace_reference(job, d->threads, w)) return -1;
    d->reference_seconds = processor_seconds() - before;
    return 0;
}

/* The mean of the halves, before the background that OpenGL drew. */
static int finish_reference(demo *d, int e, why *w) {
    const picture *r0 = &d->reference.halves[0].reference[e], *r1 = &d->reference.halves[1].reference[e];
    const picture *drawn = &d->cells[e][UNSHADOWED].picture;
    picture *to = &d->cells[e][REFERENCE].picture;
    size_t count = (size_t)r0->width * (size_t)r0->height, i, c;
    if (picture_create(r0->width, r0->height, to, w)) return -1;
    for (i = 0; i < count; i++) {
        float *sample = to->rgba + 4 * i;
        int surface = r0->rgba[4 * i + 3] > 0;
        for (c = 0; c < 3; c++)
            sample[c] = surface ? 0.5f * (r0->rgba[4 * i + c] + r1->rgba[4 * i + c]) : drawn->rgba[4 * i + c];
        sample[3] = (float)surface;
    }
    return 0;
}

static int measure(demo *d, why *w) {
    const truth *h0 = &d->reference.halves[0], *h1 = &d->reference.halves[1];
    int e, column;
    for (e = 0; e < ENVIRONMENTS; e++) {
        const picture *r0 = &h0->reference[e], *r1 = &h1->reference[e];
        if (finish_reference(d, e, w)) return -1;
        d->noise[e] = 0.5 * relative_error(r0, r0, r1, r1, pedestal_alpha);
        for (column = 0; column < COLUMNS - 1; column++) {
            cell *c = &d->cells[e][column];
            c->rmse = relative_error(&c->picture, &c->picture, r0, r1, pedestal_alpha);
            c->bunny_rmse = relative_error(&c->picture, &c->picture, r0, r1, bunny_alpha);
            if (column == UNSHADOWED) continue;
            c->floor = relative_error(&h0->floor[e][column - 1], &h1->floor[e][column - 1], r0, r1, pedestal_alpha);
            c->bunny_floor = relative_error(&h0->floor[e][column - 1], &h1->floor[e][column - 1], r0, r1, bunny_alpha);
        }
    }
    return 0;
}

/* ---- the sheet ---- */

enum { MARGIN = 24, GAP = 8, LABEL = 172, HEAD = 92, CAPTION = 52, FOOT = 58 };

typedef struct sheet { canvas c; text_font regular, bold; } sheet;

static void centred(sheet *s, const text_font *font, double size, int x, int width, int y, int grey, const char *line) {
    text_draw(&s->c, font, size, x + 0.5 * (width - text_width(font, size, line)), y, grey, line);
}

/* The whole panorama, the way a viewer inside sees it. */
static void put_panorama(sheet *s, const environment *e, int x, int y, int width, double exposure, why *w) {
    picture p;
    int i, j, samples = 2;
    if (picture_create(width * samples, width / 2 * samples, &p, w)) return;
    for (j = 0; j < p.height; j++) {
        for (i = 0; i < p.width; i++) {
            int from_x = e->map.width - 1 - i * e->map.width / p.width, from_y = j * e->map.height / p.height;
            memcpy(p.rgba + 4 * ((size_t)j * (size_t)p.width + (size_t)i),
                   e->map.rgb + 3 * ((size_t)from_y * (size_t)e->map.width + (size_t)from_x), 3 * sizeof(float));
        }
    }
    canvas_put_picture(&s->c, x, y, &p, samples, exposure);
    picture_free(&p);
}

static void put_cell(sheet *s, const demo *d, int e, int column, int x, int y, double exposure) {
    const cell *c = &d->cells[e][column];
    char first[80], second[80];
    canvas_put_picture(&s->c, x, y, &c->picture, SAMPLES_A_PIXEL, exposure);
    if (column == REFERENCE) {
        snprintf(first, sizeof first, "noise %.2f %%", 100 * d->noise[e]);
        snprintf(second, sizeof second, "%d rays a pixel · %.0f s for all three",
                 SAMPLES_A_PIXEL * SAMPLES_A_PIXEL * HALVES * (COSINE_RAYS + LIGHT_RAYS), d->reference_seconds);
    } else {
        if (column == UNSHADOWED) snprintf(first, sizeof first, "RMSE %.1f %%", 100 * c->rmse);
        else snprintf(first, sizeof first, "RMSE %.2f %%  (floor %.2f %%)", 100 * c->rmse, 100 * c->floor);
        snprintf(second, sizeof second, "bake %.*f s · frame %.0f ms", d->bake_seconds[column] < 1 ? 2 : 1,
                 d->bake_seconds[column], 1000 * c->seconds);
    }
    centred(s, &s->bold, 15, x, d->size, y + d->size + 19, 235, first);
    centred(s, &s->regular, 14, x, d->size, y + d->size + 37, 165, second);
}

static void put_head(sheet *s, const demo *d) {
    static const char *const heads[COLUMNS] = { "8 bands, no shadows", "3 bands", "5 bands", "8 bands",
                                                "ray traced" };
    int column;
    text_draw(&s->c, &s->bold, 25, MARGIN, MARGIN + 22, 245,
              "Precomputed radiance transfer: bake once, then light with anything");
    for (column = 0; column < COLUMNS; column++)
        centred(s, &s->bold, 17, MARGIN + LABEL + column * (d->size + GAP), d->size, HEAD - 12, 225, heads[column]);
}

static void put_foot(sheet *s, const demo *d) {
    char line[300];
    int y = s->c.height - FOOT + 20;
    snprintf(line, sizeof line, "%d vertices, %d rays each. RMSE: of linear radiance over the pixels that the mesh covers, "
             "relative to the mean of the ray-traced picture.", d->scene.point_count, d->rays);
    text_draw(&s->c, &s->regular, 14, MARGIN, y, 150, line);
    text_draw(&s->c, &s->regular, 14, MARGIN, y + 20, 150,
              "Floor: the same light on transfer traced and projected at every sample itself, the best that so many bands can do; "
              "what a picture has beyond it is the price of vertices and rays. Processor time, all cores together.");
}

static int make_sheet(const demo *d, sheet *s, why *w) {
    int width = 2 * MARGIN + LABEL + COLUMNS * (d->size + GAP) - GAP, e, column;
    int height = HEAD + ENVIRONMENTS * (d->size + CAPTION) + FOOT;
    if (canvas_create(width, height, &s->c, w) || text_font_load(0, &s->regular, w) || text_font_load(1, &s->bold, w))
        return -1;
    memset(s->c.rgb, 26, 3 * (size_t)width * (size_t)height);
    put_head(s, d);
    for (e = 0; e < ENVIRONMENTS; e++) {
        double exposure = picture_exposure(&d->cells[e][REFERENCE].picture);
        int y = HEAD + e * (d->size + CAPTION);
        int middle = y + d->size / 2;
        put_panorama(s, &d->environments[e], MARGIN, middle - LABEL / 4 - 8, LABEL - 16, exposure, w);
        centred(s, &s->bold, 17, MARGIN, LABEL - 16, middle + LABEL / 4 + 8, 225, d->environments[e].name);
        for (column = 0; column < COLUMNS; column++)
            put_cell(s, d, e, column, MARGIN + LABEL + column * (d->size + GAP), y, exposure);
    }
    put_foot(s, d);
    return 0;
}

static int save_sheet(const demo *d, why *w) {
    char path[1024];
    sheet s;
    int failed;
    memset(&s, 0, sizeof s);
    snprintf(path, sizeof path, "%s/demo.png", d->out);
    failed = make_sheet(d, &s, w) || canvas_write_png(&s.c, path, w);
    canvas_free(&s.c);
    text_font_free(&s.regular);
    text_font_free(&s.bold);
    if (!failed) printf("%s\n", path);
    return failed ? -1 : 0;
}

/* The same figures as lines of a table, on the terminal and in DIR/demo.csv. */
static int report(const demo *d, why *w) {
    char path[1024];
    FILE *csv;
    int e, column;
    snprintf(path, sizeof path, "%s/demo.csv", d->out);
    csv = fopen(path, "w");
    if (!csv) return why_set(w, "%s: cannot be created: %s", path, strerror(errno));
    fprintf(csv, "environment,bands,shadowed,rmse_percent,floor_percent,bunny_rmse_percent,bunny_floor_percent,"
            "reference_noise_percent,bake_s,frame_ms\n");
    printf("%-10s %5s %7s %8s %8s %12s %8s %8s %8s %9s\n", "light", "bands", "shadows", "RMSE %", "floor %",
           "bunny RMSE %", "floor %", "noise %", "bake s", "frame ms");
    for (e = 0; e < ENVIRONMENTS; e++) {
        for (column = 0; column < COLUMNS - 1; column++) {
            const cell *c = &d->cells[e][column];
            int shadowed = column != UNSHADOWED;
            printf("%-10s %5d %7s %8.2f %8.2f %12.2f %8.2f %8.2f %8.2f %9.1f\n", d->environments[e].name,
                   bands_of(column), shadowed ? "yes" : "no", 100 * c->rmse, 100 * c->floor, 100 * c->bunny_rmse,
                   100 * c->bunny_floor, 100 * d->noise[e], d->bake_seconds[column], 1000 * c->seconds);
            fprintf(csv, "%s,%d,%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.3f,%.2f\n", d->environments[e].name, bands_of(column),
                    shadowed, 100 * c->rmse, 100 * c->floor, 100 * c->bunny_rmse, 100 * c->bunny_floor,
                    100 * d->noise[e], d->bake_seconds[column], 1000 * c->seconds);
        }
    }
    if (ferror(csv) | fclose(csv)) return why_set(w, "%s: cannot be written: %s", path, strerror(errno));
    return 0;
}

static void demo_free(demo *d) {
    int e, b, column, half;
    for (e = 0; e < ENVIRONMENTS; e++) {
        environment_free(&d->environments[e]);
        for (column = 0; column < COLUMNS; column++) picture_free(&d->cells[e][column].picture);
        for (half = 0; half < HALVES; half++) {
            picture_free(&d->reference.halves[half].reference[e]);
            for (b = 0; b < SHADOWED; b++) picture_free(&d->reference.halves[half].floor[e][b]);
        }
    }
    for (column = 0; column < COLUMNS - 1; column++) free(d->transfer[column]);
    embree_tracer_destroy(&d->tracer);
    mesh_free(&d->scene);
}

static int run(demo *d, why *w) {
    if (mkdir(d->out, 0777) && errno != EEXIST)
        return why_set(w, "%s: cannot be made a directory: %s", d->out, strerror(errno));
    return load_scene(d, w) || bake_all(d, w) || draw_all(d, w) || trace_all(d, w) || measure(d, w) ||
           (interrupted ? why_set(w, "interrupted") : 0) || report(d, w) || save_sheet(d, w) ? -1 : 0;
}

static int parse(int count, char **words, demo *d, why *w) {
    int i;
    d->mesh_path = "/usr/share/glmark2/models/bunny.obj";
    d->data = PRT_EXAMPLE_DATA;
    d->out = "out";
    d->rays = 2048;
    d->size = 300;
    d->threads = processor_count();
    for (i = 1; i + 1 < count; i += 2) {
        const char *word = words[i], *value = words[i + 1];
        if (strcmp(word, "--out") == 0) d->out = value;
        else if (strcmp(word, "--mesh") == 0) d->mesh_path = value;
        else if (strcmp(word, "--rays") == 0) d->rays = atoi(value);
        else if (strcmp(word, "--size") == 0) d->size = atoi(value);
        else if (strcmp(word, "--threads") == 0) d->threads = atoi(value);
        else break;
    }
    if (i < count || d->rays < 1 || d->size < 240 || d->size > 2048 || d->threads < 1 || d->threads > 256)
        return why_set(w, "usage: demo [--out DIR] [--mesh FILE] [--rays N] [--size 240...2048] [--threads N]");
    return 0;
}

int main(int count, char **words) {
    static demo d;
    why w;
    int failed;
    signal(SIGINT, on_interrupt);
    failed = parse(count, words, &d, &w) || run(&d, &w);
    if (failed) fprintf(stderr, "demo: %s\n", w.line);
    demo_free(&d);
    return failed ? interrupted ? 130 : 1 : 0;
}
