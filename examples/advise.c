/* advise: which set-up a scene needs. Measures a mesh under an environment, tries the ways to light it that the library
   offers, each with its settings, against ray-traced truth, and prints the cheapest one that keeps the error. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "advise.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bake_job.h"
#include "plot.h"
#include "progress.h"
#include "replacement.h"

enum { NOTHING_MEETS = 3, ATTEMPTS = 8 };

static const char usage[] =
    "usage: advise mesh environment [options]\n"
    "  mesh               OBJ, PLY, glTF, 3DS, ...\n"
    "  environment        equirectangular .hdr or .pfm\n"
    "  --error E          largest root mean square error of exit radiance, as a share of its mean [0.02];\n"
    "                     up to 8 of them\n"
    "  --by bytes|time    what is cheap: bytes a vertex, or time a vertex [bytes]\n"
    "  --check N          vertices at which rays are traced and errors measured [512]\n"
    "  --rays N           most rays a vertex that a bake may take, 64, 256, 1024 or 4096 are tried [4096]\n"
    "  --lights N         the light is the environment cut into N point lights, 1 ... 64 [the environment itself]\n"
    "  --moving MESH      another mesh of half the size moves around: it stands at 8 places in turn\n"
    "  --floor            put the mesh on a round floor\n"
    "  --z-up             the file's up is +z [+y]\n"
    "  --seed N           another choice of vertices and rays [0]\n"
    "  --threads N        threads [all processors]\n"
    "  --rows             print advice also as rows of a table\n"
    "  --all              print every set-up that was tried\n"
    "  --csv FILE         write every set-up that was tried\n"
    "  --plot FILE.svg    draw error against cost, .svg or .png (needs gnuplot)\n"
    "  --help             this text\n"
    "exit code: 0 a set-up that keeps every error was found; 1 bad input, or something failed; 3 nothing that was\n"
    "tried keeps one of the errors; 130 interrupted: what had been tried until then is printed.\n"
    "\n"
    "Errors are measured against ray tracing at vertices chosen at random, with their standard error, and again for\n"
    "what is advised, at other vertices with other rays. Cpherical harmonics are not tried: they span what spherical\n"
    "harmonics of as many bands span, at the same cost.\n";

const char *const method_names[METHOD_COUNT] = { "normal only", "ambient occlusion", "transfer",
                                                 "vector occluders", "transfer and FIV" };
const char *const stored_names[STORED_COUNT] = { "nothing", "float", "half", "16 bits", "8 bits" };
const int stored_bits[STORED_COUNT] = { 0, 32, 16, 16, 8 };
static const char *const window_names[] = { "none", "Hann", "Lanczos", "positive" };

/* ---- the command line ---- */

static int parse_error(const char *text, options *o, why *w) {
    char *end;
    double value;
    if (!text) return why_set(w, "--error wants a number (--help lists the options)");
    value = strtod(text, &end);
    if (end == text || *end || !(value > 0 && value <= 10))
        return why_set(w, "--error %s: must be a number above 0 and at most 10; 0.02 is 2 %%", text);
    if (o->error_count == MOST_ERRORS) return why_set(w, "--error %s: more than %d of them", text, MOST_ERRORS);
    o->errors[o->error_count++] = value;
    return 0;
}

static int parse_text(const char *word, const char *next, options *o, int *known, why *w) {
    struct { const char *name, **value; } texts[] = { { "--csv", &o->csv }, { "--plot", &o->plot },
                                                       { "--moving", &o->moving } };
    size_t k;
    for (k = 0; k < sizeof texts / sizeof *texts; k++) {
        if (strcmp(word, texts[k].name)) continue;
        if (!next) return why_set(w, "%s wants a file", word);
        *texts[k].value = next;
        *known = 2;
    }
    if (strcmp(word, "--error") == 0) {
        *known = 2;
        return parse_error(next, o, w);
    }
    if (strcmp(word, "--by") == 0) {
        if (!next || (strcmp(next, "bytes") && strcmp(next, "time"))) return why_set(w, "--by wants bytes or time");
        o->by_time = next[0] == 't';
        *known = 2;
    }
    return 0;
}

static int parse_numbers(const char *word, const char *next, options *o, int *known, why *w) {
    struct { const char *name; int low, high, *value; } numbers[] = {
        { "--check", 16, 65536, &o->check }, { "--rays", 64, 4096, &o->rays },
        { "--threads", 1, 256, &o->threads }, { "--lights", 1, MOST_LIGHTS, &o->lights }
    };
    struct { const char *name; int *value; } switches[] = { { "--floor", &o->floor }, { "--z-up", &o->z_up },
                                                            { "--all", &o->all },     { "--rows", &o->rows },
                                                            { "--help", &o->help } };
    size_t k;
    long value = 0;
    for (k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        if (strcmp(word, numbers[k].name)) continue;
        if (parse_number(word, next, numbers[k].low, numbers[k].high, &value, w)) return -1;
        *numbers[k].value = (int)value;
        *known = 2;
    }
    if (strcmp(word, "--seed") == 0) {
        if (parse_number(word, next, 0, 1000000, &value, w)) return -1;
        o->seed = (uint64_t)value;
        *known = 2;
    }
    for (k = 0; k < sizeof switches / sizeof *switches; k++)
        if (strcmp(word, switches[k].name) == 0) *switches[k].value = *known = 1;
    return 0;
}

static int parse(int count, char **words, options *o, why *w) {
    int i;
    memset(o, 0, sizeof *o);
    o->check = 512;
    o->rays = 4096;
    o->threads = processor_count();
    for (i = 1; i < count; i++) {
        const char *word = words[i], *next = i + 1 < count ? words[i + 1] : NULL;
        int known = 0;
        if (parse_text(word, next, o, &known, w) || parse_numbers(word, next, o, &known, w)) return -1;
        if (known) i += known - 1;
        else if (word[0] == '-') return why_set(w, "%s: no such option (--help lists them)", word);
        else if (!o->mesh) o->mesh = word;
        else if (!o->environment) o->environment = word;
        else return why_set(w, "%s: a third file beside %s and %s", word, o->mesh, o->environment);
    }
    if (o->help) return 0;
    if (o->moving && o->lights) return why_set(w, "--moving and --lights: one at a time");
    if (!o->mesh || !o->environment) return why_set(w, "wants a mesh and an environment (--help explains)");
    if (o->error_count == 0) o->errors[o->error_count++] = 0.02;
    if (o->plot && (strchr(o->plot, '\'') || (!ends_with(o->plot, ".svg") && !ends_with(o->plot, ".png"))))
        return why_set(w, "--plot %s: must end in .svg or .png, and have no ' in it", o->plot);
    if (o->csv && replacement_possible(o->csv, 1 << 16, w)) return -1;
    return 0;
}

/* ---- trials ---- */

double trial_error(const trial *t) { return t->square > 0 ? sqrt(t->square) : 0; }

/* Of the error, from that of its square. */
double trial_uncertainty(const trial *t) {
    double e = trial_error(t), above = sqrt(fmax(0, t->square) + t->square_error) - e;
    return e > 0 && t->square_error < t->square ? t->square_error / (2 * e) : above;
}

void trial_judge(trial *t, const traced *is, const prt_rgb *colors) {
    double sum = 0, squares = 0, scale = 1 / (is->mean * is->mean);
    int k, c;
    for (k = 0; k < is->count; k++) {
        double one = 0, value[3];
        value[0] = (double)colors[k].r; value[1] = (double)colors[k].g; value[2] = (double)colors[k].b;
        for (c = 0; c < 3; c++)
            one += (value[c] - is->half[0][k][c]) * (value[c] - is->half[1][k][c]) * scale / 3;
        sum += one;
        squares += one * one;
    }
    t->square = sum / is->count;
    t->square_error = sqrt(fmax(0, squares / is->count - t->square * t->square) / is->count);
}

void advisor_keep(advisor *a, const trial *t) {
    if (a->trial_count < MOST_TRIALS) a->trials[a->trial_count++] = *t;
}

double time_of(void (*work)(void *user), void *user) {
    double least = 0;
    int go, k, times = 1;
    for (go = 0; go < 5; go++) {
        double start = processor_seconds(), spent;
        for (k = 0; k < times; k++) work(user);
        spent = processor_seconds() - start;
        if (spent < 1e-3 && times < 1 << 20) {             /* too short to be measured: more at a time */
            times *= spent > 1e-4 ? 1 + (int)(1.5e-3 / spent) : 8;
            go = -1;
        } else if (go == 0 || spent / times < least) least = spent / times;
    }
    return least;
}

/* Cheaper first; what decides between equals is fixed, so that advice does not depend on the clock unless asked to. */
static int by_cost(const trial *a, const trial *b, int by_time) {
    double first = by_time ? a->ns - b->ns : a->bytes - b->bytes;
    double second = a->method != b->method ? (double)a->method - (double)b->method : a->bands - b->bands;
    if (first == 0) first = a->kilobytes - b->kilobytes;
    if (first != 0) return first < 0 ? -1 : 1;
    if (second != 0) return second < 0 ? -1 : 1;
    if (a->stored != b->stored) return a->stored < b->stored ? -1 : 1;
    if (a->rays != b->rays) return a->rays < b->rays ? -1 : 1;
    return a->square < b->square ? -1 : a->square > b->square;
}
static int cheaper_in_bytes(const void *a, const void *b) { return by_cost((const trial *)a, (const trial *)b, 0); }
static int cheaper_in_time(const void *a, const void *b) { return by_cost((const trial *)a, (const trial *)b, 1); }

/* ---- the report ---- */

static void describe(const trial *t, char *text, size_t size) {
    char bands[48] = "", rays[32] = "", as[32] = "";
    if (t->rays) snprintf(rays, sizeof rays, ", %d rays", t->rays);
    if (t->method == METHOD_VO) {
        snprintf(text, size, "%s, the strongest %d of %d%s, %s law", method_names[t->method], t->kept, t->groups, rays,
                 t->law == PRT_VO_CAP ? "cap" : "sine");
        return;
    }
    if (t->bands)
        snprintf(bands, sizeof bands, ", %d band%s, window %s", t->bands, t->bands > 1 ? "s" : "",
                 window_names[t->window]);
    if (t->method == METHOD_FIV) {
        char table[100];
        moving_describe(t, table, sizeof table);
        snprintf(text, size, "%s, %d bands%s, %s; %s", method_names[t->method], t->bands, rays, stored_names[t->stored],
                 table);
        return;
    }
    if (t->stored) snprintf(as, sizeof as, ", %s", stored_names[t->stored]);
    snprintf(text, size, "%s%s%s%s", method_names[t->method], bands, rays, as);
}

static void print_row(const trial *t) {
    char settings[80];
    if (t->method == METHOD_VO)
        snprintf(settings, sizeof settings, "%d of %d, %d rays, %s law", t->kept, t->groups, t->rays,
                 t->law == PRT_VO_CAP ? "cap" : "sine");
    else
        snprintf(settings, sizeof settings, "%5d %5d  %-9s %-7s", t->bands, t->rays, window_names[t->window],
                 stored_names[t->stored]);
    printf("%-18s %-30s %6.0f %7.1f  %7.2f +- %4.2f", method_names[t->method], settings, t->bytes, t->ns,
           100 * trial_error(t), 100 * trial_uncertainty(t));
    if (t->predicted >= 0) printf("   %7.2f", 100 * t->predicted);
    if (t->method == METHOD_FIV) {
        moving_describe(t, settings, sizeof settings);
        printf("   %s", settings);
    }
    printf("\n");
}

void print_trials(const advisor *a) {
    double least = HUGE_VAL;
    int k, shown = 0;
    printf("\n%-18s %5s %5s  %-9s %-7s %6s %7s  %-15s %9s\n", "method", "bands", "rays", "window", "stored", "bytes",
           "ns", "error, %", "foretold");
    for (k = 0; k < a->trial_count; k++) {
        const trial *t = &a->trials[k];
        if (!a->o.all && !(trial_error(t) < 0.98 * least)) continue;
        print_row(t);
        least = fmin(least, trial_error(t));
        shown++;
    }
    if (!a->o.all)
        printf("(%d of %d: what errs less, by 2 %% of the error or more, than everything cheaper)\n", shown,
               a->trial_count);
}

static int meets(const trial *t, double error) {
    double safe = t->square + 2 * t->square_error;         /* two standard errors on the safe side */
    return safe <= error * error;
}

static void print_table_row(double error, const trial *t, const trial *again) {
    printf("row | %g %% | %s | %d | %d | %s | %s | %.0f | %.1f | %.2f ± %.2f | %.2f ± %.2f |\n", 100 * error,
           method_names[t->method], t->bands, t->rays, window_names[t->window], stored_names[t->stored], t->bytes,
           t->ns, 100 * trial_error(t), 100 * trial_uncertainty(t), 100 * trial_error(again),
           100 * trial_uncertainty(again));
}

/* The cheapest trial that meets the error here, and elsewhere with other rays. 0; NOTHING_MEETS; -1 and w. */
static int advise_one(advisor *a, double error, why *w) {
    const trial *best = NULL;
    double failed = HUGE_VAL;                              /* least error here of what has failed elsewhere */
    int k, tried = 0;
    for (k = 0; k < a->trial_count && tried < ATTEMPTS; k++) {
        const trial *t = &a->trials[k];
        trial again = *t;
        char text[200];
        if (!best || t->square < best->square) best = t;
        if (!meets(t, error) || !(trial_error(t) < 0.95 * failed)) continue;
        if (verify_elsewhere(a, &again, w)) return -1;
        tried++;
        describe(t, text, sizeof text);
        if (a->o.rows && again.square <= error * error) print_table_row(error, t, &again);
        printf("for an error of %.3g %%: %s: %.0f bytes and %.1f ns a vertex\n", 100 * error, text, t->bytes, t->ns);
        printf("    error %.2f +- %.2f %%; at %d vertices chosen anew, with other rays, %.2f +- %.2f %%%s\n",
               100 * trial_error(t), 100 * trial_uncertainty(t), a->second.count, 100 * trial_error(&again),
               100 * trial_uncertainty(&again), again.square <= error * error ? "" : ": too much; the next one");
        if (again.square <= error * error) return 0;
        failed = trial_error(t);
    }
    for (; k < a->trial_count; k++) if (!best || a->trials[k].square < best->square) best = &a->trials[k];
    if (best && tried == 0)
        printf("for an error of %.3g %%: nothing that was tried; the least error was %.2f +- %.2f %%, by %s\n",
               100 * error, 100 * trial_error(best), 100 * trial_uncertainty(best), method_names[best->method]);
    else printf("for an error of %.3g %%: nothing that was tried stayed below it elsewhere\n", 100 * error);
    return NOTHING_MEETS;
}

int print_advice(advisor *a, why *w) {
    int e, status = 0;
    qsort(a->trials, (size_t)a->trial_count, sizeof *a->trials, a->o.by_time ? cheaper_in_time : cheaper_in_bytes);
    print_trials(a);
    printf("\n");
    for (e = 0; e < a->o.error_count && !interrupted; e++) {
        int one = advise_one(a, a->o.errors[e], w);
        if (one < 0) return interrupted ? status : -1;
        if (one) status = one;
    }
    return status;
}

/* ---- files ---- */

int write_csv(const advisor *a, why *w) {
    replacement file;
    int k;
    if (replacement_open(a->o.csv, &file, w)) return -1;
    fprintf(file.file, "method,bands,rays,window,stored,bytes,ns,error,standard_error,foretold,groups,kept,law,"
                       "kilobytes\n");
    for (k = 0; k < a->trial_count; k++) {
        const trial *t = &a->trials[k];
        fprintf(file.file, "%s,%d,%d,%s,%s,%g,%g,%g,%g,", method_names[t->method], t->bands, t->rays,
                window_names[t->window], stored_names[t->stored], t->bytes, t->ns, trial_error(t),
                trial_uncertainty(t));
        if (t->predicted >= 0) fprintf(file.file, "%g", t->predicted);
        if (t->method == METHOD_VO)
            fprintf(file.file, ",%d,%d,%s,\n", t->groups, t->kept, t->law == PRT_VO_CAP ? "cap" : "sine");
        else fprintf(file.file, ",,,,%g\n", t->kilobytes);
    }
    return replacement_commit(&file, w);
}

/* Points of one method; what no byte is stored for stands at half a byte. */
static void send_points(const advisor *a, method m, FILE *to) {
    int k;
    for (k = 0; k < a->trial_count; k++) {
        const trial *t = &a->trials[k];
        if (t->method == m)
            fprintf(to, "%g %g\n", a->o.by_time ? t->ns : fmax(0.5, t->bytes), 100 * fmax(1e-5, trial_error(t)));
    }
    fprintf(to, "e\n");
}

static int count_of(const advisor *a, method m) {
    int k, count = 0;
    for (k = 0; k < a->trial_count; k++) count += a->trials[k].method == m;
    return count;
}

int draw_plot(const advisor *a, why *w) {
    const char *path = a->o.plot;
    int m;
    const char *comma = "";
    FILE *to = plot_open(w);
    if (!to) return -1;
    fprintf(to, "set terminal %s size 900,600\nset output '%s'\n", ends_with(path, ".png") ? "pngcairo" : "svg", path);
    fprintf(to, "set logscale xy\nset grid\nset key top right\nset xlabel '%s'\n",
            a->o.by_time ? "ns a vertex" : "bytes a vertex (none stands at 0.5)");
    fprintf(to, "set ylabel 'root mean square error, %% of the mean'\nplot ");
    for (m = 0; m < METHOD_COUNT; m++) {
        if (count_of(a, (method)m) == 0) continue;
        fprintf(to, "%s'-' with points pt %d ps 0.7 title '%s'", comma, m + 5, method_names[m]);
        comma = ", ";
    }
    for (m = 0; m < a->o.error_count; m++)
        fprintf(to, ", %g with lines dt 2 lc rgb '#808080' title '%g %%'", 100 * a->o.errors[m], 100 * a->o.errors[m]);
    fprintf(to, "\n");
    for (m = 0; m < METHOD_COUNT; m++) if (count_of(a, (method)m) > 0) send_points(a, (method)m, to);
    return plot_close(to, path, w);
}

/* ---- the program ---- */

static void print_transmissive(const mesh *m) {
    if (m->transmissive_faces == 0)
        printf("transmissive: no material; no caustics to store, vector occluders of shadows and diffuse light"
               " suffice\n");
    else
        printf("transmissive: %d faces by their material; everything here takes them as opaque, and their caustics need"
               " the full vector occluders, %d bytes packed instead of %d\n", m->transmissive_faces,
               (int)sizeof(prt_vo_packed), (int)sizeof(prt_vo_packed_diffuse));
}

static int load(advisor *a, why *w) {
    const prt_vec3 origin = { 0, 0, 0 };
    prt_vec3 under = origin;
    int i;
    if (environment_load(a->o.environment, 0, &a->environment, w) ||
        mesh_load(a->o.mesh, a->o.z_up ? MESH_Z_UP : MESH_Y_UP, &a->mesh, w) || mesh_fit_unit_sphere(&a->mesh, w))
        return -1;
    for (i = 0; i < a->mesh.point_count; i++)
        if (a->mesh.points[i].position.z < under.z) under.z = a->mesh.points[i].position.z;
    if (a->o.floor && mesh_add_floor(&a->mesh, under, (prt_real)1.6, (prt_real)0.05, w)) return -1;
    printf("%s: %d vertices, %d triangles\n", a->o.mesh, a->mesh.point_count, a->mesh.triangle_count);
    print_transmissive(&a->mesh);
    return embree_tracer_create(&a->tracer, w) || embree_tracer_add(&a->tracer, &a->mesh, 0, w) ||
           embree_tracer_build(&a->tracer, w) ? -1 : 0;
}

static int run(advisor *a, why *w) {
    int status, failed = 0;
    if (load(a, w)) return -1;
    if (advise_scene(a, w)) return -1;
    status = print_advice(a, w);
    if (a->o.csv) failed |= write_csv(a, w);
    if (a->o.plot && !failed) failed |= draw_plot(a, w);
    return failed || status < 0 ? -1 : status;
}

int main(int count, char **words) {
    static advisor a;
    why w;
    int status;
    w.line[0] = 0;
    status = parse(count, words, &a.o, &w);
    if (status == 0 && a.o.help) {
        fputs(usage, stdout);
        return 0;
    }
    if (status == 0) {
        stop_on(SIGINT);
        stop_on(SIGTERM);
        signal(SIGPIPE, SIG_IGN);
        status = run(&a, &w);
        checked_free(&a.first);
        checked_free(&a.second);
        embree_tracer_destroy(&a.tracer);
        mesh_free(&a.mesh);
        environment_free(&a.environment);
        free(a.lights);
        moving_free(&a);
    }
    if (status < 0) fprintf(stderr, "advise: %s\n", w.line);
    if (interrupted) {
        fprintf(stderr, "advise: interrupted: the advice counts what had been tried\n");
        return STOPPED;
    }
    return status < 0 ? 1 : status;
}
