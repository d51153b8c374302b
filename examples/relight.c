/* relight: bake a mesh once, then light it with any environment map.

   Reads a mesh and Radiance .hdr (or .pfm) environments; bakes shadowed diffuse transfer at the vertices with Embree,
   on all processors, into DIR/<mesh>.prt; adds --bounces of light between its own surfaces; draws one picture an
   environment with OpenGL (headless) into DIR/<mesh>-<environment>.png. An interrupted bake keeps what it has and goes
   on with --resume. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bake_job.h"
#include "bounce_job.h"
#include "embree_tracer.h"
#include "image.h"
#include "mesh.h"
#include "osmesa_context.h"
#include "program.h"
#include "relighter.h"
#include "replacement.h"
#include "transfer_file.h"

enum { MOST_ENVIRONMENTS = 64, SAMPLES_A_PIXEL = 2 };
static const double albedo = 0.8;

static const char usage[] =
    "usage: relight [mesh] [environment.hdr ...] [options]\n"
    "  mesh               OBJ, PLY, glTF, 3DS, ...            [Debian's Stanford bunny]\n"
    "  environment.hdr    equirectangular .hdr or .pfm        [examples/data/sunset.hdr]\n"
    "  --bands N          spherical harmonics bands, 1 ... 64 [5]\n"
    "  --rays N           rays a vertex                       [1024]\n"
    "  --bounces N        bounces between surfaces, albedo .8 [0]\n"
    "  --seed N           another choice of rays              [0]\n"
    "  --threads N        threads of the bake                 [all processors]\n"
    "  --out DIR          where pictures and transfer go      [out]\n"
    "  --resume           go on with an interrupted bake\n"
    "  --checkpoint N     seconds between saves of a bake     [60]\n"
    "  --floor            put the mesh on a round floor\n"
    "  --z-up             the file's up is +z                 [+y]\n"
    "  --size N           width and height of the pictures    [768]\n"
    "  --azimuth DEGREES  where the camera stands             [-80]\n"
    "  --help             this text\n";

typedef struct options {
    const char *mesh, *out, *environments[MOST_ENVIRONMENTS];
    int environment_count, bands, rays, bounces, threads, checkpoint, size, azimuth, resume, floor, z_up, help;
    uint64_t seed;
} options;

/* ---- the command line ---- */

static int parse_positional(const char *text, options *o, why *w) {
    if (ends_with(text, ".hdr") || ends_with(text, ".pfm")) {
        if (o->environment_count == MOST_ENVIRONMENTS)
            return why_set(w, "more than %d environments: call relight again for the rest", MOST_ENVIRONMENTS);
        o->environments[o->environment_count++] = text;
        return 0;
    }
    if (o->mesh) return why_set(w, "%s: a second mesh beside %s; environments end in .hdr or .pfm", text, o->mesh);
    o->mesh = text;
    return 0;
}

static int parse(int count, char **words, options *o, why *w) {
    int i;
    memset(o, 0, sizeof *o);
    o->out = "out";
    o->bands = 5;
    o->rays = 1024;
    o->size = 768;
    o->azimuth = -80;
    o->threads = processor_count();
    o->checkpoint = 60;
    for (i = 1; i < count; i++) {
        const char *word = words[i], *next = i + 1 < count ? words[i + 1] : NULL;
        struct { const char *name; int low, high; int *value; } numbers[] = {
            { "--bands", 1, PRT_MAX_BANDS, &o->bands }, { "--rays", 1, 1 << 24, &o->rays },
            { "--bounces", 0, 1000, &o->bounces },
            { "--threads", 1, 256, &o->threads },       { "--size", 16, 8192, &o->size },
            { "--azimuth", -360, 360, &o->azimuth },   { "--checkpoint", 1, 86400, &o->checkpoint }
        };
        struct { const char *name; int *value; } switches[] = {
            { "--resume", &o->resume }, { "--floor", &o->floor }, { "--z-up", &o->z_up }, { "--help", &o->help }
        };
        size_t k;
        long value = 0;
        int known = 0;
        for (k = 0; k < sizeof numbers / sizeof *numbers; k++) {
            if (strcmp(word, numbers[k].name)) continue;
            if (parse_number(word, next, numbers[k].low, numbers[k].high, &value, w)) return -1;
            *numbers[k].value = (int)value;
            known = 2;
        }
        for (k = 0; k < sizeof switches / sizeof *switches; k++)
            if (strcmp(word, switches[k].name) == 0) *switches[k].value = known = 1;
        if (strcmp(word, "--seed") == 0) {
            if (parse_number(word, next, 0, LONG_MAX, &value, w)) return -1;
            o->seed = (uint64_t)value;
            known = 2;
        }
        if (strcmp(word, "--out") == 0) {
            if (!next) return why_set(w, "--out wants a directory");
            o->out = next;
            known = 2;
        }
        if (known) i += known - 1;
        else if (word[0] == '-') return why_set(w, "%s: no such option (--help lists them)", word);
        else if (parse_positional(word, o, w)) return -1;
    }
    if (!o->mesh) o->mesh = "/usr/share/glmark2/models/bunny.obj";
    if (o->environment_count == 0) o->environments[o->environment_count++] = PRT_EXAMPLE_DATA "/sunset.hdr";
    return 0;
}

/* ---- names ---- */

/* "a/b/bunny.obj" -> "bunny" */
static void stem(const char *path, char *name, size_t size) {
    const char *slash = strrchr(path, '/'), *start = slash ? slash + 1 : path, *dot = strrchr(start, '.');
    snprintf(name, size, "%.*s", dot && dot > start ? (int)(dot - start) : (int)strlen(start), start);
}

static int output_name(const options *o, const char *environment, char *path, size_t size, why *w) {
    char model[200], light[200];
    int length;
    stem(o->mesh, model, sizeof model);
    if (environment) stem(environment, light, sizeof light);
    length = environment ? snprintf(path, size, "%s/%s-%s.png", o->out, model, light)
                         : snprintf(path, size, "%s/%s.prt", o->out, model);
    return length < (int)size ? 0 : why_set(w, "--out %.60s...: the path is too long", o->out);
}

/* ---- the mesh ---- */

static void notice(const char *path, int count, const char *what) {
    if (count > 0) fprintf(stderr, "relight: %s: note: %d %s\n", path, count, what);
}

static int load_mesh(const options *o, mesh *m, why *w) {
    const prt_vec3 origin = { 0, 0, 0 };
    prt_vec3 under = origin;
    int i;
    if (mesh_load(o->mesh, o->z_up ? MESH_Z_UP : MESH_Y_UP, m, w)) return -1;
    notice(o->mesh, m->report.recomputed, "vertex normals were missing or unusable: computed from the faces");
    notice(o->mesh, m->report.without, "of these have no face with an area: set to straight up");
    notice(o->mesh, m->report.degenerate, "triangles have no area: kept");
    if (mesh_fit_unit_sphere(m, w)) return -1;
    if (!o->floor) return 0;
    for (i = 0; i < m->point_count; i++) if (m->points[i].position.z < under.z) under.z = m->points[i].position.z;
    return mesh_add_floor(m, under, (prt_real)1.6, (prt_real)0.025, w);
}

/* ---- the bake ---- */

typedef struct saver { const char *path; const transfer_info *info; } saver;

static void save_checkpoint(void *user, const unsigned char *done, const prt_real *transfer) {
    const saver *s = (const saver *)user;
    why w;
    if (transfer_file_save(s->path, s->info, done, transfer, &w)) fprintf(stderr, "relight: %s\n", w.line);
}

static int count_done(const unsigned char *done, int count) {
    int i, sum = 0;
    for (i = 0; i < count; i++) sum += done[i];
    return sum;
}

/* Where the file cannot be written (the disk has filled up since the bake began), what is baked goes to a directory of its
   own among the temporary files: nothing is lost, but it is a failure all the same. */
static int keep_elsewhere(const options *o, const transfer_info *info, const unsigned char *done,
                          const prt_real *transfer, why *w) {
    char directory[PATH_MAX], path[PATH_MAX], name[200];
    why failure = *w, again;
    stem(o->mesh, name, sizeof name);
    if (make_temporary_directory("relight", directory, sizeof directory)) return -1;
    if (snprintf(path, sizeof path, "%s/%s.prt", directory, name) < (int)sizeof path &&
        transfer_file_save(path, info, done, transfer, &again) == 0)
        return why_set(w, "%s; what is baked is in %s: --resume goes on with --out there", failure.line, path);
    rmdir(directory);
    return -1;
}

static int trace_mesh(const mesh *m, embree_tracer *tracer, why *w) {
    if (embree_tracer_create(tracer, w) == 0 && embree_tracer_add(tracer, m, 0, w) == 0 &&
        embree_tracer_build(tracer, w) == 0)
        return 0;
    embree_tracer_destroy(tracer);
    return -1;
}

/* Bakes what is missing. 0; -1 with the reason in w; STOPPED where Ctrl-C ended it and what is done has been saved. */
static int bake(const options *o, const mesh *m, prt_real *transfer, unsigned char *done, why *w) {
    char path[PATH_MAX];
    transfer_info info;
    embree_tracer tracer;
    bake_job job;
    saver s;
    prt_result result;
    int before;
    memset(&job, 0, sizeof job);
    job.desc.bands = o->bands;
    job.desc.samples = o->rays;
    job.desc.seed = o->seed;
    job.desc.bias = (prt_real)1e-4;
    info.bands = (uint32_t)o->bands;
    info.rays = (uint32_t)o->rays;
    info.bias = (float)job.desc.bias;
    info.seed = o->seed;
    info.point_count = (uint64_t)m->point_count;
    info.mesh_hash = mesh_hash(m);
    if (output_name(o, NULL, path, sizeof path, w)) return -1;
    if (o->resume && transfer_file_load(path, &info, done, transfer, w)) return -1;
    before = count_done(done, m->point_count);
    if (before == m->point_count) {
        printf("%s: is complete, nothing to bake\n", path);
        return 0;
    }
    if (replacement_possible(path, transfer_file_bytes(&info), w)) return -1;
    if (trace_mesh(m, &tracer, w)) return -1;
    s.path = path;
    s.info = &info;
    job.desc.tracer = &tracer.tracer;
    job.point_count = m->point_count;
    job.points = m->points;
    job.threads = o->threads;
    job.what = "relight: bake";
    job.stop = &interrupted;
    job.checkpoint = save_checkpoint;
    job.checkpoint_every = o->checkpoint;
    job.user = &s;
    job.done = done;
    job.transfer = transfer;
    result = bake_job_run(&job);
    embree_tracer_destroy(&tracer);
    if (result != PRT_OK && result != PRT_ERR_CANCELLED) return why_set(w, "bake: %s", prt_result_string(result));
    if (transfer_file_save(path, &info, done, transfer, w)) return keep_elsewhere(o, &info, done, transfer, w);
    if (result == PRT_ERR_CANCELLED) {
        printf("%s: %d of %d points are baked; --resume goes on\n", path, count_done(done, m->point_count),
               m->point_count);
        return STOPPED;
    }
    printf("%s\n", path);
    return 0;
}

/* Light between the surfaces, added to direct transfer of all points; ends early when a bounce would add no more than
   half a grey level of 8 bits to white. The file keeps direct transfer alone. */
static int add_bounces(const options *o, const mesh *m, prt_real *transfer, why *w) {
    const prt_rgb grey = { (prt_real)albedo, (prt_real)albedo, (prt_real)albedo };
    size_t numbers = (size_t)m->point_count * (size_t)PRT_SH_COUNT(o->bands), bytes = numbers * sizeof *transfer;
    prt_real *bounce = (prt_real *)malloc(bytes), *previous = (prt_real *)malloc(bytes), strength = 1;
    prt_bounce_object object = bounce_object_of(m, grey);
    embree_tracer tracer;
    bounce_job job;
    int k, failed = 0;
    memset(&job, 0, sizeof job);
    if (!bounce || !previous) {
        failed = why_set(w, "out of memory: %.0f MB for bounces; fewer --bands", 2e-6 * (double)bytes);
    } else if ((failed = trace_mesh(m, &tracer, w)) == 0) {
        memcpy(previous, transfer, bytes);
        job.desc.bands = o->bands;
        job.desc.samples = o->rays;
        job.desc.seed = o->seed;
        job.desc.bias = (prt_real)1e-4;
        job.desc.object_count = 1;
        job.desc.objects = &object;
        job.desc.tracer = &tracer.tracer;
        job.point_count = m->point_count;
        job.points = m->points;
        job.previous = previous;
        job.out = bounce;
        job.threads = o->threads;
        job.what = "relight: bounce";
        job.stop = &interrupted;
        for (k = 0; k < o->bounces && !failed && strength > (prt_real)(0.5 / 255); k++) {
            failed = bounce_job_run(&job, w);
            if (failed) break;
            prt_bounce_add(o->bands, m->point_count, 1, bounce, 1, transfer, &strength);
            memcpy(previous, bounce, bytes);
            printf("bounce %d: adds at most %.4f to white\n", k + 1, (double)strength);
        }
        embree_tracer_destroy(&tracer);
    }
    free(bounce);
    free(previous);
    if (failed && interrupted) {
        printf("interrupted between the surfaces; direct transfer is complete: --resume goes on from there\n");
        return STOPPED;
    }
    return failed;
}

/* ---- the pictures ---- */

static int draw_environment(const options *o, relighter *r, const char *file, const image *environment, picture *p,
                            canvas *c, why *w) {
    static prt_real light[3 * PRT_SH_COUNT(PRT_MAX_BANDS)];
    const prt_vec3 origin = { 0, 0, 0 };
    camera eye = camera_orbit(origin, o->floor ? 4.4 : 3.6, o->azimuth * 3.14159265358979 / 180, 0.22, 0.6);
    char path[PATH_MAX];
    prt_result result = prt_sh_project_equirect_rgb(o->bands, environment->width, environment->height,
                                                    environment->rgb, light);
    if (result != PRT_OK) return why_set(w, "%s: %s", file, prt_result_string(result));
    if (output_name(o, file, path, sizeof path, w) || relighter_set_environment(r, environment, w) ||
        relighter_draw(r, &eye, light, albedo, p, NULL, w))
        return -1;
    canvas_put_picture(c, 0, 0, p, SAMPLES_A_PIXEL, picture_exposure(p));
    if (canvas_write_png(c, path, w)) return -1;
    printf("%s\n", path);
    return 0;
}

static int load_environments(const options *o, image *environments, why *w) {
    int i;
    for (i = 0; i < o->environment_count; i++) {
        const char *path = o->environments[i];
        if (image_load_environment(path, &environments[i], w)) return -1;
        notice(path, environments[i].not_a_number, "values were not numbers: taken as 0");
        notice(path, environments[i].negative, "values were negative: taken as 0");
        notice(path, environments[i].infinite, "values were infinite: taken as the largest finite one");
        if (environments[i].all_black) fprintf(stderr, "relight: %s: note: the environment is all black\n", path);
    }
    return 0;
}

static int draw_all(const options *o, relighter *r, const image *environments, why *w) {
    int samples = o->size * SAMPLES_A_PIXEL, i, failed;
    canvas c = { 0, 0, NULL };
    picture p = { 0, 0, NULL };
    failed = canvas_create(o->size, o->size, &c, w) || picture_create(samples, samples, &p, w);
    for (i = 0; i < o->environment_count && !failed && !interrupted; i++)
        failed = draw_environment(o, r, o->environments[i], &environments[i], &p, &c, w);
    picture_free(&p);
    canvas_free(&c);
    return failed ? -1 : 0;
}

static int bake_and_draw(const options *o, const mesh *m, const image *environments, why *w) {
    int samples = o->size * SAMPLES_A_PIXEL, status = -1;
    size_t numbers = (size_t)m->point_count * (size_t)PRT_SH_COUNT(o->bands);
    prt_real *transfer = (prt_real *)calloc(numbers, sizeof *transfer);
    unsigned char *done = (unsigned char *)calloc((size_t)m->point_count, 1);
    osmesa_context context = { NULL, NULL };
    relighter r;
    memset(&r, 0, sizeof r);
    if (!transfer || !done) {
        why_set(w, "out of memory: %.0f MB of transfer; fewer --bands", (double)numbers * sizeof *transfer * 1e-6);
    } else if (osmesa_context_create(&context, w) == 0) {
        if (relighter_fits(o->bands, m, w) == 0 && relighter_create(&r, m, samples, samples, w) == 0) {
            status = bake(o, m, transfer, done, w);
            if (status == 0 && o->bounces > 0) status = add_bounces(o, m, transfer, w);
            if (status == 0)
                status = relighter_set_transfer(&r, o->bands, m, transfer, w) ||
                         draw_all(o, &r, environments, w) ? -1 : 0;
            relighter_destroy(&r);
        }
        osmesa_context_destroy(&context);
    }
    free(transfer);
    free(done);
    return status;
}

static int run(const options *o, why *w) {
    image environments[MOST_ENVIRONMENTS];
    mesh m;
    int i, status = -1;
    memset(environments, 0, sizeof environments);
    memset(&m, 0, sizeof m);
    if (load_environments(o, environments, w) == 0 && load_mesh(o, &m, w) == 0 && make_directory(o->out, w) == 0)
        status = bake_and_draw(o, &m, environments, w);
    for (i = 0; i < o->environment_count; i++) image_free(&environments[i]);
    mesh_free(&m);
    return status;
}

int main(int count, char **words) {
    options o;
    why w;
    int status;
    w.line[0] = 0;
    status = parse(count, words, &o, &w);
    if (status == 0 && o.help) {
        fputs(usage, stdout);
        return 0;
    }
    if (status == 0) {
        stop_on(SIGINT);
        stop_on(SIGTERM);
        signal(SIGXFSZ, SIG_IGN);                          /* a file size limit becomes a write error like any other */
        status = run(&o, &w);
    }
    if (status < 0) fprintf(stderr, "relight: %s\n", w.line);
    if (status == 0 && interrupted) status = STOPPED;
    return status < 0 ? 1 : status;
}
