/* masks - which chains of masks grow, fade or hold, and the logarithm and exponential beside them.

     masks [-o docs/masks.md] [--plot docs/masks.png] [--plot-blockers docs/plots/blockers_pareto.svg]

   Writes the tables of docs/masks.md; the plot (1 to 64 masks at 3 bands) needs gnuplot. Seeds are fixed: but for the
   times, every run writes the same. */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L
#endif
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "bench.h"
#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEAST = 2, MOST = 8, SIZE = MOST * MOST, CHAIN = 64, TRIALS = 60, DENSE = 20000 };
static const double pi = 3.14159265358979323846;
static FILE *to;

/* ---- variants ---- */

typedef struct variant { const char *name; prt_window window; int both; } variant;
static const variant variants[] = {
    { "no window", PRT_WINDOW_NONE, 1 },
    { "Hann, both factors (Chapter 2010)", PRT_WINDOW_HANN, 1 },
    { "Lanczos, both", PRT_WINDOW_LANCZOS, 1 },
    { "positive, both", PRT_WINDOW_POSITIVE, 1 },
    { "Hann, filter only", PRT_WINDOW_HANN, 0 },
    { "Lanczos, filter only", PRT_WINDOW_LANCZOS, 0 },
    { "positive, filter only", PRT_WINDOW_POSITIVE, 0 }
};
enum { VARIANTS = (int)(sizeof variants / sizeof variants[0]) };

static void mask(const variant *v, int bands, const prt_real *filter, prt_real *light) {
    if (v->both) prt_sh_mask(bands, v->window, light, filter, light);
    else prt_sh_mask_filter(bands, v->window, light, filter, light);
}

/* ---- random things ---- */

static uint64_t state = 0x9e3779b97f4a7c15u;
static double uniform(void) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

static prt_vec3 direction(void) {
    double z = 2 * uniform() - 1, phi = 2 * pi * uniform(), r = sqrt(1 - z * z);
    prt_vec3 d;
    d.x = (prt_real)(r * cos(phi));
    d.y = (prt_real)(r * sin(phi));
    d.z = (prt_real)z;
    return d;
}

/* within a few degrees of +z */
static prt_vec3 near_axis(void) {
    prt_vec3 d = direction(), z;
    double length;
    z.x = PRT__R(0.09) * d.x;
    z.y = PRT__R(0.09) * d.y;
    z.z = 1 + PRT__R(0.09) * d.z;
    length = sqrt((double)(z.x * z.x + z.y * z.y + z.z * z.z));
    z.x = (prt_real)((double)z.x / length);
    z.y = (prt_real)((double)z.y / length);
    z.z = (prt_real)((double)z.z / length);
    return z;
}

static double norm(int count, const prt_real *f) {
    double sum = 0;
    int i;
    for (i = 0; i < count; i++) sum += (double)f[i] * (double)f[i];
    return sqrt(sum);
}

static void random_light(int count, prt_real *f) {
    int i;
    double length;
    for (i = 0; i < count; i++) f[i] = (prt_real)(uniform() + uniform() + uniform() + uniform() - 2);
    length = norm(count, f);
    for (i = 0; i < count; i++) f[i] = (prt_real)((double)f[i] / length);
}

/* ---- chains ---- */

typedef enum family { IDENTICAL, ALIGNED, RANDOM, OPEN, FAMILIES } family;
static const char *const family_names[FAMILIES] = {
    "one hemisphere", "hemispheres within 5 degrees", "random hemispheres", "filters that hide nothing"
};

static void make_filter(family kind, int bands, prt_real *filter) {
    prt_vec3 up = { 0, 0, 1 };
    if (kind == ALIGNED) up = near_axis();
    if (kind == RANDOM) up = direction();
    prt_sh_hemisphere(bands, up, 1, kind == OPEN ? 1 : 0, filter);
}

/* norm after 1 ... CHAIN masks, from lights of norm 1: the largest over the trials; with filters that hide nothing,
   the mean */
static void run_chain(const variant *v, family kind, int bands, double most[CHAIN]) {
    prt_real light[SIZE], filter[SIZE];
    int trial, k;
    for (k = 0; k < CHAIN; k++) most[k] = 0;
    state = 12345;
    for (trial = 0; trial < TRIALS; trial++) {
        random_light(bands * bands, light);
        for (k = 0; k < CHAIN; k++) {
            double length;
            make_filter(kind, bands, filter);
            mask(v, bands, filter, light);
            length = norm(bands * bands, light);
            if (kind == OPEN) most[k] += length / TRIALS;
            else if (!(length <= most[k])) most[k] = length;
        }
    }
}

/* Growth per mask of a long chain by one hemisphere: the spectral radius of the mask. */
static double spectral_radius(const variant *v, int bands) {
    prt_real light[SIZE], filter[SIZE];
    double log_sum = 0;
    int k, i, count = bands * bands;
    state = 777;
    random_light(count, light);
    make_filter(IDENTICAL, bands, filter);
    for (k = 0; k < 6000; k++) {
        double length;
        mask(v, bands, filter, light);
        length = norm(count, light);
        for (i = 0; i < count; i++) light[i] = (prt_real)((double)light[i] / length);
        if (k >= 5000) log_sum += log(length);
    }
    return exp(log_sum / 1000);
}

static void table_head(const char *what) {
    int n;
    fprintf(to, "\n| %s |", what);
    for (n = LEAST; n <= MOST; n++) fprintf(to, " %d bands |", n);
    fprintf(to, "\n|---|");
    for (n = LEAST; n <= MOST; n++) fprintf(to, "---:|");
    fprintf(to, "\n");
}

static void print_radii(void) {
    int i, n;
    table_head("spectral radius, one hemisphere again and again");
    for (i = 0; i < VARIANTS; i++) {
        fprintf(to, "| %s |", variants[i].name);
        for (n = LEAST; n <= MOST; n++) fprintf(to, " %.3f |", spectral_radius(&variants[i], n));
        fprintf(to, "\n");
    }
}

static const char *verdict(double worst, double open) {
    return worst > 1.05 ? "grows" : open < 0.95 ? "fades" : "holds";
}

static void print_chains(void) {
    double worst[VARIANTS] = { 0 }, open[VARIANTS];
    int kind, i, n;
    for (i = 0; i < VARIANTS; i++) open[i] = 1e300;
    for (kind = 0; kind < FAMILIES; kind++) {
        char title[128];
        snprintf(title, sizeof title, "%s norm after 64 masks, %s", kind == OPEN ? "mean" : "largest",
                 family_names[kind]);
        table_head(title);
        for (i = 0; i < VARIANTS; i++) {
            fprintf(to, "| %s |", variants[i].name);
            for (n = LEAST; n <= MOST; n++) {
                double most[CHAIN], peak = 0;
                int k;
                run_chain(&variants[i], (family)kind, n, most);
                for (k = 0; k < CHAIN; k++) if (!(most[k] <= peak)) peak = most[k];
                if (kind != OPEN && !(peak <= worst[i])) worst[i] = peak;
                if (kind == OPEN && most[CHAIN - 1] < open[i]) open[i] = most[CHAIN - 1];
                fprintf(to, " %.3g |", most[CHAIN - 1]);
            }
            fprintf(to, "\n");
        }
    }
    fprintf(to, "\n| variant | largest gain on the way | least left by 64 filters that hide nothing (mean) | verdict |\n"
                "|---|---:|---:|---|\n");
    for (i = 0; i < VARIANTS; i++)
        fprintf(to, "| %s | %.3g | %.3g | %s |\n", variants[i].name, worst[i], open[i], verdict(worst[i], open[i]));
}

/* ---- truth on a dense set of directions ---- */

typedef struct sample { prt_vec3 dir; prt_real y[SIZE]; } sample;
static sample *dense;

static void make_dense(void) {
    int i;
    dense = (sample *)malloc(sizeof *dense * DENSE);
    if (!dense) { fprintf(stderr, "masks: out of memory\n"); exit(1); }
    for (i = 0; i < DENSE; i++) {
        double z = 1 - (2 * i + 1.0) / DENSE, r = sqrt(1 - z * z), phi = 2.3999632297286533 * i;
        dense[i].dir.x = (prt_real)(r * cos(phi));
        dense[i].dir.y = (prt_real)(r * sin(phi));
        dense[i].dir.z = (prt_real)z;
        prt_sh_eval(MOST, dense[i].dir, dense[i].y);
    }
}

static void project(int bands, const double *values, prt_real *f) {
    double sum[SIZE] = { 0 };
    int i, k;
    for (i = 0; i < DENSE; i++)
        for (k = 0; k < bands * bands; k++) sum[k] += values[i] * (double)dense[i].y[k];
    for (k = 0; k < bands * bands; k++) f[k] = (prt_real)(sum[k] * 4 * pi / DENSE);
}

static double distance(int count, const prt_real *a, const prt_real *b) {
    double sum = 0;
    int i;
    for (i = 0; i < count; i++) sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
    return sqrt(sum);
}

/* Root mean square error of one mask over random lights and hemispheres, for lights of norm 1 */
static void print_single_errors(void) {
    static double values[DENSE];
    int i, n;
    table_head("error of one mask, light of norm 1");
    for (i = 0; i < VARIANTS; i++) {
        fprintf(to, "| %s |", variants[i].name);
        for (n = LEAST; n <= MOST; n++) {
            double sum = 0;
            int trial, k;
            state = 4242;
            for (trial = 0; trial < 20; trial++) {
                prt_real light[SIZE], filter[SIZE], truth[SIZE];
                prt_vec3 up = direction();
                random_light(n * n, light);
                for (k = 0; k < DENSE; k++)
                    values[k] = prt__dot3(up, dense[k].dir) > 0 ? (double)prt__dot(n * n, light, dense[k].y) : 0;
                project(n, values, truth);
                prt_sh_hemisphere(n, up, 1, 0, filter);
                mask(&variants[i], n, filter, light);
                sum += pow(distance(n * n, light, truth), 2) / 20;
            }
            fprintf(to, " %.3f |", sqrt(sum));
        }
        fprintf(to, "\n");
    }
}

/* The window on the index of the coefficient, as the text of Chapter 2010 has it: how far the mask of turned factors is
   from the turned mask, over the norm of the mask, both factors turned by 45 degrees about z; at worst over 20
   pairs. */
static void turn(int bands, const prt_real *f, prt_real *out) {
    int l, m;
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            double c = cos(m * pi / 4), s = sin(m * pi / 4);
            double x = (double)f[PRT_SH_INDEX(l, m)], y = (double)f[PRT_SH_INDEX(l, -m)];
            out[PRT_SH_INDEX(l, m)] = (prt_real)(c * x - (m ? s * y : 0));
            if (m) out[PRT_SH_INDEX(l, -m)] = (prt_real)(s * x + c * y);
        }
}

static void index_mask(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    prt_real a[SIZE], b[SIZE];
    int i, n = bands * bands;
    for (i = 0; i < n; i++) {
        prt_real w = (prt_real)((1 + cos(pi * i / n)) / 2);
        a[i] = w * f[i];
        b[i] = w * g[i];
    }
    prt_sh_product(bands, a, b, out);
}

static double orientation_error(int bands, int by_index) {
    double worst = 0;
    int trial;
    state = 31;
    for (trial = 0; trial < 20; trial++) {
        prt_real light[SIZE], filter[SIZE], a[SIZE], b[SIZE], turned[SIZE], masked[SIZE];
        double off;
        random_light(bands * bands, light);
        prt_sh_hemisphere(bands, direction(), 1, 0, filter);
        if (by_index) index_mask(bands, light, filter, masked);
        else prt_sh_mask(bands, PRT_WINDOW_HANN, light, filter, masked);
        turn(bands, masked, turned);
        turn(bands, light, a);
        turn(bands, filter, b);
        if (by_index) index_mask(bands, a, b, masked);
        else prt_sh_mask(bands, PRT_WINDOW_HANN, a, b, masked);
        off = distance(bands * bands, masked, turned) / norm(bands * bands, turned);
        if (!(off <= worst)) worst = off;
    }
    return worst;
}

static void print_index_window(void) {
    int n;
    table_head("change of a mask with orientation, Hann on both");
    fprintf(to, "| window on the band |");
    for (n = LEAST; n <= MOST; n++) fprintf(to, " %.1g |", orientation_error(n, 0));
    fprintf(to, "\n| window on the index |");
    for (n = LEAST; n <= MOST; n++) fprintf(to, " %.2f |", orientation_error(n, 1));
    fprintf(to, "\n");
}

/* ---- many blockers ---- */

typedef struct scene {
    int bands, count;
    prt_real visible[CHAIN][SIZE], logs[CHAIN][SIZE], truth[SIZE];
} scene;

enum { STEPS_OF_LOG = 12 };
static const double least = 0.02;

/* the two steps that a blocker's logarithm needs: a table made once, and a turn */
static void make_scene(scene *s, int bands, int count) {
    static double values[DENSE];
    int b, k;
    s->bands = bands;
    s->count = count;
    for (k = 0; k < DENSE; k++) values[k] = 1;
    for (b = 0; b < count; b++) {
        prt_vec3 axis = direction();
        double angle = (5 + 25 * uniform()) * pi / 180, edge = cos(angle);
        prt_sh_cone(bands, axis, (prt_real)angle, s->visible[b]);
        for (k = 0; k < bands * bands; k++) s->visible[b][k] = -s->visible[b][k];
        s->visible[b][0] += PRT__R(3.5449077018110320546);
        prt_sh_log(bands, STEPS_OF_LOG, (prt_real)least, s->visible[b], s->logs[b]);
        for (k = 0; k < DENSE; k++) if ((double)prt__dot3(axis, dense[k].dir) > edge) values[k] = 0;
    }
    project(bands, values, s->truth);
}

static void by_masks(const scene *s, const variant *v, prt_real *out) {
    int b;
    memcpy(out, s->visible[0], sizeof s->visible[0]);
    for (b = 1; b < s->count; b++) mask(v, s->bands, s->visible[b], out);
}

static void sum_logs(const scene *s, prt_real *out) {
    int b, i, n = s->bands * s->bands;
    memcpy(out, s->logs[0], sizeof s->logs[0]);
    for (b = 1; b < s->count; b++)
        for (i = 0; i < n; i++) out[i] += s->logs[b][i];
}

enum { METHODS = 5 };
static const char *const method_names[METHODS] = {
    "products, no window", "masks, Hann on both", "masks, positive on the filter", "prt_sh_exp", "prt_sh_exp_linear"
};

static void evaluate(const scene *s, int method, prt_real *out) {
    prt_real sum[SIZE];
    switch (method) {
    case 0: by_masks(s, &variants[0], out); return;
    case 1: by_masks(s, &variants[1], out); return;
    case 2: by_masks(s, &variants[6], out); return;
    default: sum_logs(s, sum);
    }
    if (method == 3) prt_sh_exp(s->bands, sum, out);
    else prt_sh_exp_linear(s->bands, sum, out);
}

static const int blocker_counts[] = { 1, 2, 4, 8, 16, 32, 64 };
enum { COUNTS = 7, SCENES = 12 };

static void measure_blockers(int bands, int count, double error[METHODS], double time[METHODS]) {
    static scene scenes[SCENES];
    int m, k, round;
    state = 99;
    for (k = 0; k < SCENES; k++) make_scene(&scenes[k], bands, count);
    for (m = 0; m < METHODS; m++) {
        double sum = 0, best = 1e300;
        prt_real out[SIZE];
        for (k = 0; k < SCENES; k++) {
            evaluate(&scenes[k], m, out);
            sum += pow(distance(bands * bands, out, scenes[k].truth), 2) / (4 * pi) / SCENES;
        }
        for (round = 0; round < 20; round++) {
            double start = bench_seconds();
            for (k = 0; k < SCENES; k++) evaluate(&scenes[k], m, out);
            start = 1e6 * (bench_seconds() - start) / SCENES;
            if (start < best) best = start;
        }
        error[m] = sqrt(sum);
        time[m] = best;
    }
}

static void print_blockers(int bands) {
    double error[COUNTS][METHODS], time[COUNTS][METHODS];
    int c, m;
    for (c = 0; c < COUNTS; c++) measure_blockers(bands, blocker_counts[c], error[c], time[c]);
    fprintf(to, "\n| %d bands: error, time in us |", bands);
    for (c = 0; c < COUNTS; c++) fprintf(to, " %d |", blocker_counts[c]);
    fprintf(to, "\n|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (m = 0; m < METHODS; m++) {
        fprintf(to, "| %s |", method_names[m]);
        for (c = 0; c < COUNTS; c++) fprintf(to, " %.3f, %.2f |", error[c][m], time[c][m]);
        fprintf(to, "\n");
    }
}

/* ---- plot ---- */

static int plot(const char *path) {
    FILE *p = popen("gnuplot", "w");
    int i, k, kind;
    if (!p) return 0;
    fprintf(p, "set terminal pngcairo size 1240,400 font ',10'\nset output '%s'\nset logscale y\nset yrange [0.0005:300]\n"
               "set xrange [0:64]\nset xlabel 'masks'\nset grid\nset multiplot layout 1,4\nunset key\n", path);
    for (kind = 0; kind < FAMILIES; kind++) {
        if (kind == ALIGNED) continue;
        fprintf(p, "set title '%s, 3 bands'\nset ylabel '%s norm'\nplot ", family_names[kind],
                kind == OPEN ? "mean" : "largest");
        for (i = 0; i < VARIANTS; i++)
            fprintf(p, "%s'-' with lines lw 2 lt %d dt %d", i ? ", " : "", i + 1, variants[i].both ? 1 : 2);
        fprintf(p, "\n");
        for (i = 0; i < VARIANTS; i++) {
            double most[CHAIN];
            run_chain(&variants[i], (family)kind, 3, most);
            for (k = 0; k < CHAIN; k++) fprintf(p, "%d %g\n", k + 1, most[k]);
            fprintf(p, "e\n");
        }
    }
    fprintf(p, "unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\nunset grid\n"
               "set key center center\nplot ");
    for (i = 0; i < VARIANTS; i++)
        fprintf(p, "%s1/0 with lines lw 2 lt %d dt %d title '%s'", i ? ", " : "", i + 1, variants[i].both ? 1 : 2,
                variants[i].name);
    fprintf(p, "\nunset multiplot\n");
    return pclose(p) == 0;
}

/* Error against time for 16 blockers, a curve a method over 2 to 8 bands */
static int plot_blockers(const char *path) {
    double error[MOST + 1][METHODS], time[MOST + 1][METHODS];
    FILE *p = popen("gnuplot", "w");
    int m, n;
    if (!p) return 0;
    for (n = LEAST; n <= MOST; n++) measure_blockers(n, 16, error[n], time[n]);
    fprintf(p, "set terminal svg size 800,560 noenhanced dynamic font 'sans-serif,13' background 'white'\nset output '%s'\n"
               "set logscale xy\nset xlabel 'us for 16 blockers, 2 to 8 bands from left to right'\n"
               "set ylabel 'error, full sight is 1'\nset yrange [0.01:1]\nset grid xtics ytics lc rgb '#dddddd'\n"
               "set key bottom right Left reverse\nplot ", path);
    for (m = 0; m < METHODS; m++) fprintf(p, "%s'-' with linespoints lw 2 title '%s'", m ? ", " : "", method_names[m]);
    fprintf(p, "\n");
    for (m = 0; m < METHODS; m++) {
        for (n = LEAST; n <= MOST; n++) fprintf(p, "%g %g\n", time[n][m], error[n][m]);
        fprintf(p, "e\n");
    }
    return pclose(p) == 0;
}

int main(int argc, char **argv) {
    const char *picture = NULL, *blockers = NULL, *page = NULL, *name;
    const command_option options[] = {
        { "-o", "FILE.md", "where to write the page [standard output]", &page, NULL, 0, 0 },
        { "--plot", "FILE.png", "draw chains of masks", &picture, NULL, 0, 0 },
        { "--plot-blockers", "FILE.svg", "draw error against time for many blockers", &blockers, NULL, 0, 0 }
    };
    const command line = { "masks", NULL, NULL, options, 3 };
    command_read(&line, argc, argv);
    to = page ? command_open(&line, page) : stdout;
    make_dense();
    fprintf(to, "# Chains of masks\n\nWritten by `bench/masks.c` on %s, %s, %s, float, %d lanes. `prt_sh_mask` windows\n"
            "both factors, `prt_sh_mask_filter` the filter alone. %d random lights of norm 1 a cell; norms are the largest of\n"
            "them, or where it says so their mean.\n", bench_cpu_name(), BENCH_COMPILER, BENCH_FLAGS, PRT__LANES, TRIALS);
    if (picture) {
        name = strrchr(picture, '/');
        fprintf(to, "\n![1 to 64 masks at 3 bands](%s)\n", name ? name + 1 : picture);
    }
    print_radii();
    print_chains();
    print_single_errors();
    print_index_window();
    fprintf(to, "\n# Many blockers: masks, or the exponential of summed logarithms\n\n"
            "1 to 64 random caps of 5 to 30 degrees; error: distance from the projection of the true visibility, root mean\n"
            "square over the sphere (12 scenes). Logarithms (`prt_sh_log`, %d steps, least %g) are made beforehand; times are\n"
            "for one receiver, with everything in the first-level cache.\n", STEPS_OF_LOG, least);
    print_blockers(3);
    print_blockers(4);
    print_blockers(6);
    if (blockers) fprintf(to, "\n![Error against time for 16 blockers, 2 to 8 bands](plots/blockers_pareto.svg)\n\n"
                              "![Error against time of products](plots/product_pareto.svg)\n\n"
                              "Series of other degrees, logarithms by steps, and what batches of products can gain: "
                              "[operations.md](operations.md).\n");
    if (command_close(&line, to)) return 1;
    if (picture && !plot(picture)) {
        fprintf(stderr, "masks: no plot %s: gnuplot is missing or failed; install gnuplot-nox\n", picture);
        return 1;
    }
    if (blockers && !plot_blockers(blockers)) {
        fprintf(stderr, "masks: no plot %s: gnuplot is missing or failed; install gnuplot-nox\n", blockers);
        return 1;
    }
    free(dense);
    return 0;
}
