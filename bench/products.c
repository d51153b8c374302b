/* products - error against time of the ways to multiply two SH functions, 2 to 10 bands.

     products [--plot docs/plots/product_pareto.svg]

   Prints a table; the plot needs gnuplot. Error: largest coefficient error over |f| |g| of 20 random pairs, against the
   sum over triple product coefficients in double; time of one pair, the least of 15 rounds. */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L
#endif
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "bench.h"
#include "command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 10, SIZE = MOST * MOST, PAIRS = 64, TRIALS = 20 };

typedef struct term { int i, j, k; double g; } term;
static term *terms;
static int term_count;
static prt_real f[SIZE * PAIRS], g[SIZE * PAIRS], out[SIZE * PAIRS], one_f[SIZE], one_g[SIZE], matrix[SIZE * SIZE],
                random_numbers[2 * TRIALS * SIZE];

/* Every coefficient that does not vanish, ordered by its highest band */
static void make_terms(void) {
    int l1, m1, l2, m2, l3, m3;
    terms = (term *)malloc(sizeof *terms * 100000);
    if (!terms) { fprintf(stderr, "products: out of memory\n"); exit(1); }
    for (l1 = 0; l1 < MOST; l1++)
        for (m1 = -l1; m1 <= l1; m1++)
            for (l2 = 0; l2 < MOST; l2++)
                for (m2 = -l2; m2 <= l2; m2++)
                    for (l3 = 0; l3 < MOST; l3++)
                        for (m3 = -l3; m3 <= l3; m3++) {
                            double v = prt_sh_triple(l1, m1, l2, m2, l3, m3);
                            term t;
                            if (v == 0) continue;
                            t.i = PRT_SH_INDEX(l1, m1); t.j = PRT_SH_INDEX(l2, m2); t.k = PRT_SH_INDEX(l3, m3); t.g = v;
                            if (term_count == 100000) { fprintf(stderr, "products: more terms than room\n"); exit(1); }
                            terms[term_count++] = t;
                        }
}

static double error_of(int bands, const prt_real *got) {
    static double want[SIZE];
    int n = bands * bands, k;
    double most = 0, ff = 0, gg = 0;
    memset(want, 0, sizeof want);
    for (k = 0; k < term_count; k++)
        if (terms[k].i < n && terms[k].j < n && terms[k].k < n)
            want[terms[k].k] += terms[k].g * (double)one_f[terms[k].i] * (double)one_g[terms[k].j];
    for (k = 0; k < n; k++) {
        ff += (double)one_f[k] * (double)one_f[k];
        gg += (double)one_g[k] * (double)one_g[k];
        if (!(fabs((double)got[k] - want[k]) <= most)) most = fabs((double)got[k] - want[k]);
    }
    return most / sqrt(ff * gg);
}

enum { WAYS = 4 };
static const char *const names[WAYS] = {
    "one pair", "a batch of 64, per pair", "one pair by the loop for any bands", "a matrix made before"
};

static void multiply(int way, int bands) {
    switch (way) {
    case 0: prt_sh_product(bands, one_f, one_g, out); break;
    case 1: prt_sh_product_soa(bands, PAIRS, f, g, out, PAIRS); break;
    case 2: prt__grid_product(bands, one_f, one_g, out); break;
    default: prt_sh_product_by(bands, matrix, one_f, out);
    }
}

static double time_of(int way, int bands) {
    int repeat = (way == 1 ? 40000 : 400000) / (bands * bands * bands) + 1, round, k;
    double best = 1e300;
    for (round = 0; round < 15; round++) {
        double start = bench_seconds();
        for (k = 0; k < repeat; k++) { multiply(way, bands); BENCH_KEEP(out); }
        start = 1e9 * (bench_seconds() - start) / repeat / (way == 1 ? PAIRS : 1);
        if (start < best) best = start;
    }
    return best;
}

static void measure(int way, int bands, double *error, double *time) {
    prt_real got[SIZE];
    int n = bands * bands, i;
    int trial;
    double off;
    *error = 0;
    for (trial = 0; trial < TRIALS; trial++) {
        memcpy(one_f, random_numbers + trial * SIZE, sizeof one_f);
        memcpy(one_g, random_numbers + (trial + TRIALS) * SIZE, sizeof one_g);
        prt_sh_product_matrix(bands, one_g, matrix);
        for (i = 0; i < n; i++) {
            f[i * PAIRS] = one_f[i];
            g[i * PAIRS] = one_g[i];
        }
        multiply(way, bands);
        for (i = 0; i < n; i++) got[i] = out[way == 1 ? i * PAIRS : i];
        off = error_of(bands, got);
        if (!(off <= *error)) *error = off;
    }
    *time = time_of(way, bands);
}

static int plot(const char *path, double error[WAYS][MOST + 1], double time[WAYS][MOST + 1]) {
    FILE *p = popen("gnuplot", "w");
    int way, n;
    if (!p) return 0;
    fprintf(p, "set terminal svg size 800,560 noenhanced dynamic font 'sans-serif,13' background 'white'\n"
               "set output '%s'\nset logscale xy\nset xlabel 'ns a product, 2 to %d bands from left to right'\n"
               "set ylabel 'largest error over |f| |g|'\nset yrange [1e-9:1e-6]\nset format y '1e%%L'\n"
               "set grid xtics ytics lc rgb '#dddddd'\nset key top left Left reverse\nplot ", path, MOST);
    for (way = 0; way < WAYS; way++) fprintf(p, "%s'-' with linespoints lw 2 title '%s'", way ? ", " : "", names[way]);
    fprintf(p, "\n");
    for (way = 0; way < WAYS; way++) {
        for (n = 2; n <= MOST; n++) fprintf(p, "%g %g\n", time[way][n], error[way][n]);
        fprintf(p, "e\n");
    }
    return pclose(p) == 0;
}

int main(int argc, char **argv) {
    static double error[WAYS][MOST + 1], time[WAYS][MOST + 1];
    const char *picture = NULL;
    const command_option options[] = { { "--plot", "FILE.svg", "draw error against time", &picture, NULL, 0, 0 } };
    const command line = { "products", NULL, NULL, options, 1 };
    int way, n, i;
    command_read(&line, argc, argv);
    for (i = 0; i < SIZE * PAIRS; i++) {
        f[i] = (prt_real)(rand() / (double)RAND_MAX - 0.5);
        g[i] = (prt_real)(rand() / (double)RAND_MAX - 0.5);
    }
    for (i = 0; i < 2 * TRIALS * SIZE; i++) random_numbers[i] = (prt_real)(rand() / (double)RAND_MAX - 0.5);
    make_terms();
    printf("%s, %s, %s, %d lanes: ns a product, largest error over |f| |g|\n", bench_cpu_name(), BENCH_COMPILER,
           BENCH_FLAGS, PRT__LANES);
    for (n = 2; n <= MOST; n++) {
        printf("%2d bands", n);
        for (way = 0; way < WAYS; way++) {
            measure(way, n, &error[way][n], &time[way][n]);
            printf(" | %s %.1f, %.1e", names[way], time[way][n], error[way][n]);
        }
        printf("\n");
    }
    if (picture && !plot(picture, error, time)) {
        fprintf(stderr, "products: no plot: check that gnuplot is installed and %s can be written\n", picture);
        return 1;
    }
    return 0;
}
