/* fiv_scene: bodies that move and turn over a ground and over each other under a photographed environment, shaded from
   fullsphere irradiance vectors, ray traced, and the difference, side by side.

   Each mesh is baked once, in the form that takes any light of some bands (prt_fiv_transfer). Each frame turns the
   light into the frame of each body, makes the body's table of vectors of it, and shades by lookups, in milliseconds;
   beside it rays take seconds. They have the environment as 6 x 32 x 32 texels, whose lower half is the light that the
   open ground reflects; the vectors have its first bands. Writes DIR/fiv-scene-NNN.png, DIR/fiv-scene.csv with a line a
   frame, and DIR/fiv-scene.webp where img2webp (Debian: webp) is installed. Tables stay in DIR for the next run. An
   interrupted run keeps its frames; --resume goes on.

     NRMSE   root mean square difference of what the camera sees (irradiance times albedo over pi, samples on bodies and
             ground), all colours, divided by the range of the truth. The truth's noise is taken out of it by two
             independent halves. */
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
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bake_job.h"
#include "fiv_bake.h"
#include "fiv_receive.h"
#include "program.h"
#include "progress.h"
#include "text.h"
#include "vector.h"

enum { SHAPES = 2, BODIES = 3, GAP = 6, HEAD = 26, FOOT = 24 };

static const char usage[] =
    "usage: fiv_scene [environment.hdr] [options]\n"
    "  environment.hdr  equirectangular .hdr or .pfm                  [examples/data/courtyard.hdr]\n"
    "  --meshes A B     what moves: two of the first, one of the second [Debian's bunny and horse]\n"
    "  --frames N       of the loop                                   [24]\n"
    "  --size N         width of one picture of three, in pixels      [320]\n"
    "  --rays N         shadow rays a sample and half                 [32]\n"
    "  --bands N        of the light that the vectors see              [6]\n"
    "  --threads N                                                    [all processors]\n"
    "  --out DIR        where frames, figures and animation go        [out]\n"
    "  --resume         keep the frames that are there\n"
    "  --quick          tables and light of a few samples, for a test\n"
    "  --help           this text\n";

typedef struct options {
    const char *environment, *meshes[SHAPES], *out;
    int frames, size, rays, bands, threads, resume, quick, help;
} options;

typedef struct show {
    options    o;
    cube_light light, sky;             /* what shines, and the same finer, to be looked at */
    shape      shapes[SHAPES];
    fiv_baked  tables[SHAPES][2];      /* as an occluder, and for its own shadow */
    prt_real   *lit;                   /* the light, three planes of bands^2 */
    body       bodies[BODIES];
    stage      stage;
    fiv_receive receive;
    prt_fiv    *samples[BODIES][2];    /* this frame's tables, in the frames of the bodies */
    prt_fiv_table body_tables[BODIES][2];
    const prt_fiv_table *occluders[BODIES], *self[BODIES];
    receivers  seen;
    picture    fiv, truth[2], mean;
    canvas     sheet;
    text_font  regular, bold;
    double     exposure;               /* of the first frame, for all */
    FILE       *csv;
} show;

/* ---- the choreography ---- */

static const int shape_of[BODIES] = { 0, 0, 1 };
static const double radius_of[SHAPES] = { 0.75, 0.75 };

static double wave(double x) { return 0.5 - 0.5 * cos(2 * pi * x); }

/* Where body k is at time t, 0 to 1 and round again. Two hop about each other, the third flies over both. */
static prt_vec3 place_of(int k, double t) {
    double angle = 2 * pi * (t + 0.5 * k);
    if (k < 2) return vec(1.15 * cos(angle), 1.15 * sin(angle), 0.72 + 0.35 * wave(3 * t + 0.5 * k));
    return vec(-1.4 * sin(2 * pi * t), 0.5 * cos(2 * pi * t), 2.1 + 0.3 * wave(2 * t));
}

/* The hoppers look where they go; the third tumbles. */
static void turn_of(int k, double t, prt_real r[9]) {
    if (k < 2) rotation_about(vec(0, 0, 1), 2 * pi * (t + 0.5 * k), r);
    else rotation_about(vec_unit(vec(0.6, 0.2, 1), vec(0, 0, 1)), 2 * pi * t, r);
}

static void pose(show *s, int frame) {
    double t = (double)frame / s->o.frames;
    int k;
    for (k = 0; k < BODIES; k++) {
        s->bodies[k].position = place_of(k, t);
        turn_of(k, t, s->bodies[k].rotation);
    }
}

/* ---- what is made once ---- */

static int make_light(show *s, why *w) {
    image map;
    int failed;
    if (image_load_environment(s->o.environment, &map, w)) return -1;
    failed = cube_light_from_image(&map, s->o.quick ? 8 : 32, &s->light, w) ||
             cube_light_from_image(&map, s->o.quick ? 8 : 128, &s->sky, w);
    image_free(&map);
    if (failed) return -1;
    cube_light_set_ground(&s->light, s->stage.ground_albedo);
    cube_light_set_ground(&s->sky, s->stage.ground_albedo);
    s->lit = (prt_real *)malloc(3 * (size_t)PRT_SH_COUNT(s->o.bands) * sizeof *s->lit);
    if (!s->lit) return why_set(w, "out of memory");
    prt_sh_project_cubemap_rgb(s->o.bands, s->light.size, s->light.faces, s->lit);
    return cube_light_ready(&s->light, w);
}

static int bake_shape(show *s, int k, int self, why *w) {
    char what[100];
    fiv_bake_job job;
    memset(&job, 0, sizeof job);
    job.shape = &s->shapes[k];
    job.bands = s->o.bands;
    job.rays = s->o.quick ? 64 : 0;
    job.grid.phi = s->o.quick ? 12 : 64;
    job.grid.theta = s->o.quick ? 7 : 33;
    job.grid.rho = s->o.quick ? 6 : 24;
    job.grid.nearest = (prt_real)(self ? 0.15 : 0.5);
    job.grid.farthest = self ? 1 : 8;
    job.mark_inside = self;
    job.keep = s->o.out;
    job.threads = s->o.threads;
    job.stop = &interrupted;
    snprintf(what, sizeof what, "fiv_scene: %s%s", job.shape->name, self ? ", its own shadow" : "");
    job.what = what;
    return fiv_bake_run(&job, &s->tables[k][self], w);
}

static int dress(show *s, why *w) {
    static const double albedo[BODIES][3] = { { 0.8, 0.62, 0.45 }, { 0.5, 0.62, 0.8 }, { 0.75, 0.75, 0.75 } };
    int k, self;
    for (k = 0; k < BODIES; k++) {
        body *b = &s->bodies[k];
        b->shape = &s->shapes[shape_of[k]];
        b->albedo = rgb(albedo[k][0], albedo[k][1], albedo[k][2]);
        for (self = 0; self < 2; self++) {
            const fiv_baked *from = &s->tables[shape_of[k]][self];
            s->samples[k][self] = (prt_fiv *)malloc((size_t)prt_bake_fiv_count(&from->desc) * sizeof(prt_fiv));
            if (!s->samples[k][self]) return why_set(w, "out of memory");
            s->body_tables[k][self] = prt_fiv_table_of(&from->desc, s->samples[k][self], from->inside);
        }
        s->occluders[k] = &s->body_tables[k][0];
        s->self[k] = &s->body_tables[k][1];
    }
    s->stage.body_count = BODIES;
    s->stage.bodies = s->bodies;
    pose(s, 0);
    return 0;
}

static int prepare_receive(show *s, why *w) {
    const prt_vec3 up = vec(0, 0, 1);
    fiv_receive *f = &s->receive;
    prt_fiv_env env;
    prt_result result;
    f->stage = &s->stage;
    f->receivers = &s->seen;
    f->flags = PRT_FIV_FILLED_OVERLAP;                   /* meshes are no balls */
    f->tables = s->occluders;
    f->self = s->self;
    f->threads = s->o.threads;
    f->stop = &interrupted;
    fiv_env_of(&s->light, &env);
    result = prt_bake_fiv_environment(&env, &f->environment);
    if (result == PRT_OK) result = prt_bake_fiv_irradiance(&env, 1, &up, &f->ground_total);
    return result == PRT_OK ? 0 : why_set(w, "%s: %s", s->o.environment, prt_result_string(result));
}

static int make_pictures(show *s, why *w) {
    int wide = 2 * s->o.size, high = 3 * s->o.size / 2;    /* four samples a pixel; a picture is 4 : 3 */
    return receivers_create(wide, high, &s->seen, w) || picture_create(wide, high, &s->fiv, w) ||
           picture_create(wide, high, &s->truth[0], w) || picture_create(wide, high, &s->truth[1], w) ||
           picture_create(wide, high, &s->mean, w) ||
           canvas_create(3 * s->o.size + 2 * GAP, HEAD + high / 2 + FOOT, &s->sheet, w) ||
           text_font_load(0, &s->regular, w) || text_font_load(1, &s->bold, w) ? -1 : 0;
}

static int prepare(show *s, why *w) {
    int k;
    s->stage.ground_radius = 6;
    s->stage.ground_albedo = rgb(0.6, 0.6, 0.6);
    if (make_light(s, w) || make_pictures(s, w)) return -1;
    for (k = 0; k < SHAPES; k++) {
        if (shape_load(s->o.meshes[k], (prt_real)radius_of[k], k ? &s->shapes[0] : NULL, &s->shapes[k], w)) return -1;
        if (bake_shape(s, k, 0, w) || bake_shape(s, k, 1, w)) return -1;
    }
    return dress(s, w) || prepare_receive(s, w) || stage_create(&s->stage, w) ? -1 : 0;
}

static void show_free(show *s) {
    int k;
    for (k = 0; k < SHAPES; k++) {
        fiv_baked_free(&s->tables[k][0]);
        fiv_baked_free(&s->tables[k][1]);
    }
    for (k = 0; k < BODIES; k++) {
        free(s->samples[k][0]);
        free(s->samples[k][1]);
    }
    free(s->lit);
    stage_free(&s->stage);
    for (k = SHAPES - 1; k >= 0; k--) shape_free(&s->shapes[k]);
    cube_light_free(&s->light);
    cube_light_free(&s->sky);
    receivers_free(&s->seen);
    picture_free(&s->fiv);
    picture_free(&s->truth[0]);
    picture_free(&s->truth[1]);
    picture_free(&s->mean);
    canvas_free(&s->sheet);
    text_font_free(&s->regular);
    text_font_free(&s->bold);
}

/* ---- a frame ---- */

typedef struct figures { double nrmse, noise, light_ms, shade_ms, truth_s; } figures;

static int trace_frame(show *s, int frame, why *w) {
    truth t;
    memset(&t, 0, sizeof t);
    t.stage = &s->stage;
    t.light = &s->light;
    t.receivers = &s->seen;
    t.rays = s->o.rays;
    t.threads = s->o.threads;
    t.seed = (uint64_t)frame + 1;
    t.stop = &interrupted;
    t.halves[0] = &s->truth[0];
    t.halves[1] = &s->truth[1];
    return truth_trace(&t, w);
}

static void average(const picture *a, const picture *b, picture *mean) {
    size_t count = 4 * (size_t)a->width * (size_t)a->height, k;
    for (k = 0; k < count; k++) mean->rgba[k] = 0.5f * (a->rgba[k] + b->rgba[k]);
}

/* The vectors that each body hides in this frame. */
static int light_tables(show *s, why *w) {
    int k, self;
    for (k = 0; k < BODIES; k++)
        for (self = 0; self < 2; self++)
            if (fiv_baked_light(&s->tables[shape_of[k]][self], s->lit, s->bodies[k].rotation, s->samples[k][self], w))
                return -1;
    return 0;
}

static int shade_frame(show *s, int frame, figures *f, why *w) {
    camera eye = camera_orbit(vec(0, 0, 1.3), 8.2, -1.2, 0.13, 0.5);
    double range, start;
    int k;
    pose(s, frame);
    if (stage_move(&s->stage, w)) return -1;
    if (receivers_look(&s->stage, &eye, &s->seen)) return why_set(w, "the scene cannot be traced");
    start = processor_seconds();
    if (light_tables(s, w)) return -1;
    f->light_ms = 1000 * (processor_seconds() - start);
    start = processor_seconds();
    if (fiv_receive_run(&s->receive, &s->fiv, w)) return -1;
    f->shade_ms = 1000 * (processor_seconds() - start);
    start = processor_seconds();
    if (trace_frame(s, frame, w)) return -1;
    f->truth_s = processor_seconds() - start;
    stage_expose(&s->stage, &s->seen, &s->sky, &s->fiv);
    for (k = 0; k < 2; k++) stage_expose(&s->stage, &s->seen, &s->sky, &s->truth[k]);
    average(&s->truth[0], &s->truth[1], &s->mean);
    range = picture_range(&s->mean);
    f->nrmse = picture_rms(&s->fiv, &s->truth[0], &s->truth[1], NULL) / range;
    f->noise = picture_rms(&s->truth[0], &s->truth[1], &s->truth[1], NULL) / 2 / range;
    return 0;
}

static void centred(show *s, const text_font *font, double size, int column, int y, int grey, const char *line) {
    int x = column * (s->o.size + GAP);
    text_draw(&s->sheet, font, size, x + 0.5 * (s->o.size - text_width(font, size, line)), y, grey, line);
}

static void draw_sheet(show *s, const figures *f) {
    static const char *const heads[3] = { "irradiance vectors", "ray traced", "difference, 5 times" };
    int below = s->sheet.height - 8, k;
    char line[100];
    memset(s->sheet.rgb, 26, 3 * (size_t)s->sheet.width * (size_t)s->sheet.height);
    if (!(s->exposure > 0)) s->exposure = picture_exposure(&s->mean);
    canvas_put_picture(&s->sheet, 0, HEAD, &s->fiv, 2, s->exposure);
    canvas_put_picture(&s->sheet, s->o.size + GAP, HEAD, &s->mean, 2, s->exposure);
    canvas_put_difference(&s->sheet, 2 * (s->o.size + GAP), HEAD, &s->fiv, &s->mean, 2, picture_range(&s->mean), 5);
    for (k = 0; k < 3; k++) centred(s, &s->bold, 16, k, HEAD - 8, 235, heads[k]);
    snprintf(line, sizeof line, "%d bands, %.0f + %.0f ms of one core", s->o.bands, f->light_ms, f->shade_ms);
    centred(s, &s->regular, 14, 0, below, 190, line);
    snprintf(line, sizeof line, "%.1f s of one core, %d rays a sample", f->truth_s, 2 * s->o.rays);
    centred(s, &s->regular, 14, 1, below, 190, line);
    snprintf(line, sizeof line, "NRMSE %.4f", f->nrmse);
    centred(s, &s->regular, 14, 2, below, 190, line);
}

static void frame_path(const options *o, int frame, char *path, size_t size) {
    snprintf(path, size, "%s/fiv-scene-%03d.png", o->out, frame);
}

static int make_frame(show *s, int frame, why *w) {
    char path[PATH_MAX];
    figures f = { 0, 0, 0, 0, 0 };
    if (shade_frame(s, frame, &f, w)) return -1;
    draw_sheet(s, &f);
    frame_path(&s->o, frame, path, sizeof path);
    if (canvas_write_png(&s->sheet, path, w)) return -1;
    fprintf(s->csv, "%d,%.5f,%.5f,%.1f,%.1f,%.2f\n", frame, f.nrmse, f.noise, f.light_ms, f.shade_ms, f.truth_s);
    return fflush(s->csv) ? why_set(w, "%s/fiv-scene.csv: cannot be written: %s", s->o.out, strerror(errno)) : 0;
}

static int exists(const char *path) {
    struct stat st;
    return stat(path, &st) == 0;
}

static int make_frames(show *s, why *w) {
    char path[PATH_MAX];
    progress p;
    int frame, kept = 0;
    for (frame = 0; s->o.resume && frame < s->o.frames; frame++) {
        frame_path(&s->o, frame, path, sizeof path);
        kept += exists(path);
    }
    snprintf(path, sizeof path, "%s/fiv-scene.csv", s->o.out);
    s->csv = fopen(path, kept ? "a" : "w");
    if (!s->csv) return why_set(w, "%s: cannot be created: %s", path, strerror(errno));
    if (!kept) fprintf(s->csv, "frame,nrmse,noise,light_ms,shade_ms,traced_s\n");
    progress_start(&p, "fiv_scene: frames", s->o.frames, kept, "frames", 1);
    for (frame = 0; frame < s->o.frames && !interrupted; frame++) {
        frame_path(&s->o, frame, path, sizeof path);
        if (s->o.resume && exists(path)) continue;
        if (make_frame(s, frame, w)) break;
        progress_show(&p, ++kept);
    }
    progress_end(&p, kept);
    fclose(s->csv);
    if (interrupted)
        return why_set(w, "interrupted: %d of %d frames are in %s; --resume goes on", kept, s->o.frames, s->o.out);
    return kept < s->o.frames ? -1 : 0;
}

/* ---- the animation ---- */

/* Runs a program; its status, 127 where there is none of that name. */
static int run_program(char **words) {
    pid_t child = fork();
    int status = -1;
    if (child == 0) {
        execvp(words[0], words);
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

static int encode(const options *o, why *w) {
    static char lossy[] = "-lossy", quality[] = "-q", forty[] = "40", duration[] = "-d", ms[] = "100", to[] = "-o";
    static char smallest[] = "-min_size", program[] = "img2webp";
    char animation[PATH_MAX], **words = (char **)calloc((size_t)o->frames + 12, sizeof *words);
    char *paths = (char *)malloc((size_t)o->frames * PATH_MAX);
    int frame, n = 0, status = -1;
    if (words && paths) {
        snprintf(animation, sizeof animation, "%s/fiv-scene.webp", o->out);
        words[n++] = program;
        words[n++] = smallest;
        words[n++] = lossy; words[n++] = quality; words[n++] = forty; words[n++] = duration; words[n++] = ms;
        for (frame = 0; frame < o->frames; frame++) {
            words[n] = paths + (size_t)frame * PATH_MAX;
            frame_path(o, frame, words[n++], PATH_MAX);
        }
        words[n++] = to; words[n] = animation;
        fflush(NULL);
        status = run_program(words);
    }
    free(words);
    free(paths);
    if (status == 127) {
        fprintf(stderr, "fiv_scene: note: no animation, since img2webp is not installed (Debian: webp); the frames are"
                " in %s\n", o->out);
        return 0;
    }
    if (status) return why_set(w, "img2webp could not make %s/fiv-scene.webp of the frames", o->out);
    printf("%s\n", animation);
    return 0;
}

/* ---- the program ---- */

static int parse(int count, char **words, options *o, why *w) {
    int i;
    memset(o, 0, sizeof *o);
    o->environment = PRT_EXAMPLE_DATA "/courtyard.hdr";
    o->meshes[0] = "/usr/share/glmark2/models/bunny.obj";
    o->meshes[1] = "/usr/share/glmark2/models/horse.3ds";
    o->out = "out";
    o->frames = 24;
    o->size = 320;
    o->rays = 32;
    o->bands = 6;
    o->threads = processor_count();
    for (i = 1; i < count; i++) {
        const char *word = words[i], *next = i + 1 < count ? words[i + 1] : NULL;
        struct { const char *name; int low, high; int *value; } numbers[] = {
            { "--frames", 1, 999, &o->frames }, { "--size", 32, 2048, &o->size }, { "--rays", 1, 65536, &o->rays },
            { "--bands", 1, 16, &o->bands }, { "--threads", 1, 256, &o->threads }
        };
        struct { const char *name; int *value; } switches[] = {
            { "--resume", &o->resume }, { "--quick", &o->quick }, { "--help", &o->help }
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
        if (strcmp(word, "--out") == 0) {
            if (!next) return why_set(w, "--out wants a directory");
            o->out = next;
            known = 2;
        }
        if (strcmp(word, "--meshes") == 0) {
            if (i + 2 >= count) return why_set(w, "--meshes wants two files");
            o->meshes[0] = next;
            o->meshes[1] = words[i + 2];
            known = 3;
        }
        if (known) i += known - 1;
        else if (word[0] == '-') return why_set(w, "%s: no such option (--help lists them)", word);
        else o->environment = word;
    }
    o->size &= ~3;                                         /* a picture is 4 : 3 */
    return 0;
}

int main(int count, char **words) {
    static show s;
    why w;
    int failed;
    w.line[0] = 0;
    stop_on(SIGINT);
    stop_on(SIGTERM);
    failed = parse(count, words, &s.o, &w);
    if (!failed && s.o.help) {
        fputs(usage, stdout);
        return 0;
    }
    if (!failed)
        failed = make_directory(s.o.out, &w) || prepare(&s, &w) || make_frames(&s, &w) || encode(&s.o, &w);
    if (failed) fprintf(stderr, "fiv_scene: %s\n", w.line);
    show_free(&s);
    return failed ? interrupted ? STOPPED : 1 : 0;
}
