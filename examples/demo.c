/* demo: the Stanford bunny under three environments, lit from transfer of 3, 5 and 8 bands, beside ray-traced truth.

   Writes DIR/demo.png and .jpg, a contact sheet with one row an environment, and DIR/demo.csv with its figures.
   Columns: 8 bands without shadows; 3, 5 and 8 bands with shadows; direct light by Monte Carlo ray tracing from the
   same camera, thousands of shadow rays a pixel. What each number means:

     RMSE    root mean square error of linear radiance against the reference, all colours, over the pixels that bunny
             and pedestal cover whole (the table adds it for the bunny's alone), divided by the mean of the reference
             there. Negative radiance counts as 0, which is what the screen shows. The reference comes in two
             independent halves R0, R1; the mean of (P-R0)(P-R1) is free of their noise.
     floor   the same of a picture whose every sample has transfer of its own: visibility traced and projected at the
             sample itself, nothing interpolated between vertices. It is what the exact projection to so many bands of
             the reference's visibility allows; what the demo's picture has beyond it is the price of vertices and rays.
     above   RMSE less floor, and its standard error from the noise of reference and floor (they are compared over the
             same rays, so that it is far smaller than the noise of either).
     noise   standard error of the reference picture itself, from the difference of its halves, in the same units.
     time    of the processor, all cores together, so that other programs do not count. bake: once for any light, and
             once for all columns, since transfer of fewer bands is the first coefficients of more; frame: drawing the
             mesh at four samples a pixel (llvmpipe).

   Points are put where transfer bends (refined_bake): the mesh that is drawn is finer than the one that is traced, but
   the same surface. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "embree_tracer.h"
#include "image.h"
#include "mesh.h"
#include "osmesa_context.h"
#include "program.h"
#include "progress.h"
#include "reference.h"
#include "refined_bake.h"
#include "relighter.h"
#include "replacement.h"
#include "text.h"

enum {
    ENVIRONMENTS = REFERENCE_LIGHTS, SHADOWED = REFERENCE_BAND_COUNTS, SAMPLES_A_PIXEL = 2,
    MOST_BANDS = REFERENCE_BANDS, COEFFICIENTS = REFERENCE_COEFFICIENTS
};

/* Each environment is turned about the vertical, so that one camera shows all of them from their best side. */
static const struct { const char *file; double turn; } choice[ENVIRONMENTS] = {
    { "courtyard.hdr", 0 }, { "studio.hdr", 0.625 }, { "sunset.hdr", 0.875 }
};

enum { UNSHADOWED = 0, REFERENCE = SHADOWED + 1, COLUMNS = SHADOWED + 2 };

/* Relative errors: over bunny and pedestal, and over the bunny alone. */
typedef struct errors { double rmse, floor, uncertainty; } errors;
typedef struct cell { picture picture; errors all, bunny; double seconds; } cell;

typedef struct demo {
    const char    *mesh_path, *data, *out;
    int           rays, size, threads;
    mesh          scene, fine;         /* what is traced; the same surface with the points that are baked */
    embree_tracer tracer;
    environment   environments[ENVIRONMENTS];
    reference     reference;
    camera        eye;
    prt_real      *unshadowed, *shadowed;                  /* [fine.point_count][COEFFICIENTS] */
    double        bake_seconds[2], reference_seconds, noise[ENVIRONMENTS];     /* of the bake: unshadowed, shadowed */
    cell          cells[ENVIRONMENTS][COLUMNS];
} demo;

static int bands_of(int column) { return column == UNSHADOWED ? MOST_BANDS : reference_bands[column - 1]; }

static int load_scene(demo *d, why *w) {
    const prt_vec3 target = { 0, 0, (prt_real)-0.06 };
    prt_vec3 under = { 0, 0, 0 };
    char path[1024];
    int k;
    for (k = 0; k < ENVIRONMENTS; k++) {
        snprintf(path, sizeof path, "%s/%s", d->data, choice[k].file);
        if (environment_load(path, choice[k].turn, &d->environments[k], w)) return -1;
    }
    if (mesh_load(d->mesh_path, MESH_Y_UP, &d->scene, w) || mesh_fit_unit_sphere(&d->scene, w)) return -1;
    for (k = 0; k < d->scene.point_count; k++)
        if (d->scene.points[k].position.z < under.z) under.z = d->scene.points[k].position.z;
    d->reference.object_triangles = d->scene.triangle_count;
    if (mesh_add_floor(&d->scene, under, (prt_real)1.25, (prt_real)0.025, w) || mesh_copy(&d->scene, &d->fine, w))
        return -1;
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

static int bake_shadowed(demo *d, why *w) {
    refined_bake r;
    int failed;
    memset(&r, 0, sizeof r);
    r.job.desc.bands = MOST_BANDS;
    r.job.desc.samples = d->rays;
    r.job.desc.bias = (prt_real)1e-4;
    r.job.desc.tracer = &d->tracer.tracer;
    r.job.threads = d->threads;
    r.job.what = "demo: bake";
    r.job.stop = &interrupted;
    r.m = &d->fine;
    r.levels = 4;
    r.tolerance = 0.003;               /* ten times the difference that the noise of 8192 rays makes */
    failed = refined_bake_run(&r, w);
    d->shadowed = r.job.transfer;
    return failed;
}

static int bake_all(demo *d, why *w) {
    double start = processor_seconds(), middle;
    if (bake_shadowed(d, w)) return -1;
    middle = processor_seconds();
    d->unshadowed = (prt_real *)malloc((size_t)d->fine.point_count * COEFFICIENTS * sizeof(prt_real));
    if (!d->unshadowed) return why_set(w, "out of memory");
    bake_unshadowed(&d->fine, d->unshadowed);
    d->bake_seconds[0] = processor_seconds() - middle;
    d->bake_seconds[1] = middle - start;
    return 0;
}

/* Transfer of so many bands is the first coefficients of transfer of more. */
static int set_transfer(const demo *d, relighter *r, int column, why *w) {
    const prt_real *from = column == UNSHADOWED ? d->unshadowed : d->shadowed;
    size_t points = (size_t)d->fine.point_count, row = (size_t)PRT_SH_COUNT(bands_of(column)), k;
    prt_real *transfer = (prt_real *)malloc(points * row * sizeof *transfer);
    int failed;
    if (!transfer) return why_set(w, "out of memory");
    for (k = 0; k < points; k++) memcpy(transfer + k * row, from + k * COEFFICIENTS, row * sizeof *transfer);
    failed = relighter_set_transfer(r, bands_of(column), &d->fine, transfer, w);
    free(transfer);
    return failed;
}

/* The second drawing is timed: the first may still compile its shader. */
static int draw_column(demo *d, relighter *r, int column, why *w) {
    int samples = d->size * SAMPLES_A_PIXEL, e;
    if (set_transfer(d, r, column, w)) return -1;
    for (e = 0; e < ENVIRONMENTS; e++) {
        prt_real light[3 * COEFFICIENTS];
        cell *c = &d->cells[e][column];
        environment_light(&d->environments[e], bands_of(column), light);
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
    failed = relighter_create(&r, &d->fine, samples, samples, w);
    for (column = 0; column < COLUMNS - 1 && !failed; column++) failed = draw_column(d, &r, column, w);
    relighter_destroy(&r);
    osmesa_context_destroy(&context);
    return failed;
}

static int trace_all(demo *d, why *w) {
    reference *job = &d->reference;
    double before;
    job->scene = &d->scene;
    job->tracer = &d->tracer.tracer;
    job->environments = d->environments;
    job->eye = d->eye;
    job->bias = (prt_real)1e-4;
    job->width = job->height = d->size * SAMPLES_A_PIXEL;
    job->threads = d->threads;
    job->what = "demo: reference";
    job->stop = &interrupted;
    before = processor_seconds();
    if (reference_trace(job, w)) return -1;
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

/* least: of alpha in the reference, see reference.h. */
static void compare(const demo *d, int e, int column, float least, errors *to) {
    const reference_half *h0 = &d->reference.halves[0], *h1 = &d->reference.halves[1];
    const picture *p = &d->cells[e][column].picture, *r0 = &h0->reference[e], *r1 = &h1->reference[e];
    to->rmse = reference_error(p, p, r0, r1, SAMPLES_A_PIXEL, least);
    if (column == UNSHADOWED) return;
    to->floor = reference_error(&h0->floor[e][column - 1], &h1->floor[e][column - 1], r0, r1, SAMPLES_A_PIXEL, least);
    to->uncertainty = reference_uncertainty(&d->reference, e, column - 1, p, SAMPLES_A_PIXEL, least) /
                      (to->rmse + to->floor);              /* of the difference of the squares, to that of the roots */
}

static int measure(demo *d, why *w) {
    int e, column;
    for (e = 0; e < ENVIRONMENTS; e++) {
        const picture *r0 = &d->reference.halves[0].reference[e], *r1 = &d->reference.halves[1].reference[e];
        if (finish_reference(d, e, w)) return -1;
        d->noise[e] = 0.5 * reference_error(r0, r0, r1, r1, SAMPLES_A_PIXEL, 0.5f);
        for (column = 0; column < COLUMNS - 1; column++) {
            compare(d, e, column, 0.5f, &d->cells[e][column].all);
            compare(d, e, column, 1, &d->cells[e][column].bunny);
        }
    }
    return 0;
}

/* ---- the sheet ---- */

enum { MARGIN = 24, GAP = 8, LABEL = 172, HEAD = 92, CAPTION = 68, FOOT = 78 };

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
    char lines[3][80] = { "", "", "" };
    canvas_put_picture(&s->c, x, y, &c->picture, SAMPLES_A_PIXEL, exposure);
    if (column == REFERENCE) {
        snprintf(lines[0], sizeof lines[0], "noise %.2f %%", 100 * d->noise[e]);
        snprintf(lines[1], sizeof lines[1], "%d rays a pixel", SAMPLES_A_PIXEL * SAMPLES_A_PIXEL * REFERENCE_HALVES *
                 (REFERENCE_COSINE_RAYS + REFERENCE_LIGHT_RAYS));
        snprintf(lines[2], sizeof lines[2], "%.0f s for all three", d->reference_seconds);
    } else {
        snprintf(lines[0], sizeof lines[0], "RMSE %.2f %%", 100 * c->all.rmse);
        if (column != UNSHADOWED)
            snprintf(lines[1], sizeof lines[1], "floor %.2f %% %+.3f ± %.3f", 100 * c->all.floor,
                     100 * (c->all.rmse - c->all.floor), 100 * c->all.uncertainty);
        snprintf(lines[2], sizeof lines[2], "bake %.*f s · frame %.0f ms", column == UNSHADOWED ? 2 : 0,
                 d->bake_seconds[column != UNSHADOWED], 1000 * c->seconds);
    }
    centred(s, &s->bold, 15, x, d->size, y + d->size + 19, 235, lines[0]);
    centred(s, &s->regular, 14, x, d->size, y + d->size + 37, 200, lines[1]);
    centred(s, &s->regular, 14, x, d->size, y + d->size + 54, 165, lines[2]);
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
    snprintf(line, sizeof line, "%d vertices, %d rays each. RMSE: of linear radiance over the pixels that the mesh "
             "covers, relative to the mean of the ray-traced picture.", d->fine.point_count, d->rays);
    text_draw(&s->c, &s->regular, 14, MARGIN, y, 150, line);
    text_draw(&s->c, &s->regular, 14, MARGIN, y + 20, 150,
              "Floor: the same light on transfer traced and projected at every sample itself, the best that so many "
              "bands can do; then what the picture has beyond it, ± standard error.");
    text_draw(&s->c, &s->regular, 14, MARGIN, y + 40, 150,
              "Times: processor, all cores. One bake of 8 bands serves all columns: fewer bands are its first "
              "coefficients.");
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

/* As PNG, and as JPEG for documents. */
static int save_sheet(const demo *d, why *w) {
    char png[1024], jpg[1024];
    sheet s;
    int failed;
    memset(&s, 0, sizeof s);
    snprintf(png, sizeof png, "%s/demo.png", d->out);
    snprintf(jpg, sizeof jpg, "%s/demo.jpg", d->out);
    failed = make_sheet(d, &s, w) || canvas_write_png(&s.c, png, w) || canvas_write_jpg(&s.c, jpg, w);
    canvas_free(&s.c);
    text_font_free(&s.regular);
    text_font_free(&s.bold);
    if (!failed) printf("%s\n%s\n", png, jpg);
    return failed ? -1 : 0;
}

/* RMSE, floor, and what is above it; without shadows there is no floor. */
static void print_errors(const errors *e, int width, int column) {
    if (column == UNSHADOWED) printf(" %*.3f %7s %16s |", width, 100 * e->rmse, "", "");
    else printf(" %*.3f %7.3f %+7.3f +- %5.3f |", width, 100 * e->rmse, 100 * e->floor, 100 * (e->rmse - e->floor),
                100 * e->uncertainty);
}

/* The same figures as lines of a table, on the terminal and in DIR/demo.csv. */
static int report(const demo *d, why *w) {
    char path[1024];
    FILE *csv;
    int e, column;
    snprintf(path, sizeof path, "%s/demo.csv", d->out);
    csv = fopen(path, "w");
    if (!csv) return why_set(w, "%s: cannot be created: %s", path, strerror(errno));
    fprintf(csv, "environment,bands,shadowed,rmse_percent,floor_percent,standard_error_of_difference_percent,"
            "bunny_rmse_percent,bunny_floor_percent,bunny_standard_error_of_difference_percent,"
            "reference_noise_percent,bake_s,frame_ms\n");
    printf("%-10s %5s %7s | %7s %7s %16s | %12s %7s %16s | %7s %7s %8s\n", "light", "bands", "shadows", "RMSE %",
           "floor %", "above floor %", "bunny RMSE %", "floor %", "above floor %", "noise %", "bake s", "frame ms");
    for (e = 0; e < ENVIRONMENTS; e++) {
        for (column = 0; column < COLUMNS - 1; column++) {
            const cell *c = &d->cells[e][column];
            const errors *a = &c->all, *b = &c->bunny;
            double bake = d->bake_seconds[column != UNSHADOWED], noise = 100 * d->noise[e], ms = 1000 * c->seconds;
            printf("%-10s %5d %7s |", d->environments[e].name, bands_of(column), column == UNSHADOWED ? "no" : "yes");
            print_errors(a, 7, column);
            print_errors(b, 12, column);
            printf(" %7.2f %7.2f %8.1f\n", noise, bake, ms);
            fprintf(csv, "%s,%d,%d,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.3f,%.2f\n", d->environments[e].name,
                    bands_of(column), column != UNSHADOWED, 100 * a->rmse, 100 * a->floor, 100 * a->uncertainty,
                    100 * b->rmse, 100 * b->floor, 100 * b->uncertainty, noise, bake, ms);
        }
    }
    if (ferror(csv) | fclose(csv)) return why_set(w, "%s: cannot be written: %s", path, strerror(errno));
    return 0;
}

static void demo_free(demo *d) {
    int e, column;
    for (e = 0; e < ENVIRONMENTS; e++) {
        environment_free(&d->environments[e]);
        for (column = 0; column < COLUMNS; column++) picture_free(&d->cells[e][column].picture);
    }
    reference_free(&d->reference);
    free(d->unshadowed);
    free(d->shadowed);
    embree_tracer_destroy(&d->tracer);
    mesh_free(&d->scene);
    mesh_free(&d->fine);
}

static int run(demo *d, why *w) {
    char sheet_path[1024];
    if (make_directory(d->out, w)) return -1;
    snprintf(sheet_path, sizeof sheet_path, "%s/demo.png", d->out);
    return replacement_possible(sheet_path, 4u << 20, w) || load_scene(d, w) || bake_all(d, w) || draw_all(d, w) ||
           trace_all(d, w) || measure(d, w) || (interrupted ? why_set(w, "interrupted") : 0) || report(d, w) ||
           save_sheet(d, w) ? -1 : 0;
}

static int parse(int count, char **words, demo *d, why *w) {
    long rays = 8192, size = 300, threads = processor_count();
    int i, bad = 0;
    d->mesh_path = "/usr/share/glmark2/models/bunny.obj";
    d->data = PRT_EXAMPLE_DATA;
    d->out = "out";
    for (i = 1; i < count && !bad; i += 2) {
        const char *word = words[i], *value = i + 1 < count ? words[i + 1] : NULL;
        if (value && strcmp(word, "--out") == 0) d->out = value;
        else if (value && strcmp(word, "--mesh") == 0) d->mesh_path = value;
        else if (strcmp(word, "--rays") == 0) bad = parse_number(word, value, 1, INT_MAX, &rays, w);
        else if (strcmp(word, "--size") == 0) bad = parse_number(word, value, 240, 2048, &size, w);
        else if (strcmp(word, "--threads") == 0) bad = parse_number(word, value, 1, 256, &threads, w);
        else bad = why_set(w, "usage: demo [--out DIR] [--mesh FILE] [--rays N] [--size 240...2048] [--threads N]");
    }
    d->rays = (int)rays;
    d->size = (int)size;
    d->threads = (int)threads;
    return bad;
}

int main(int count, char **words) {
    static demo d;
    why w;
    int failed;
    stop_on(SIGINT);
    stop_on(SIGTERM);
    failed = parse(count, words, &d, &w) || run(&d, &w);
    if (failed) fprintf(stderr, "demo: %s\n", w.line);
    demo_free(&d);
    return failed ? interrupted ? STOPPED : 1 : 0;
}
