/* accuracy.c - the error of SH evaluation, against MPFR, from 1 to 1024 bands; writes CSV.

   Truth is taken at two places. At the unit direction: (x,y,z), exactly as the binary numbers stand, normalised in
   MPFR; that error is what a caller sees. At the direction as given, |(x,y,z)| = 1 + delta: the polynomials
   p(l,m)(z) (x+iy)^m
   with just those numbers; that error is the evaluator's own, without the rounding of its input. */
#define _POSIX_C_SOURCE 200809L
#include "accuracy_forms.h"
#include "bench.h"
#include "command.h"

#include <math.h>
#include <mpfr.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BITS = 256, MAX_DIRECTIONS = 96, MAX_BANDS = 1024, MAX_FORMS = 8, MAX_STEPS = 80 };

typedef struct reference { long double *unit, *raw; } reference;   /* truth for all coefficients of one direction */

typedef struct error {
    double most, own, squares;      /* largest against unit and raw truth; sum of squares against unit truth */
    long count, not_finite, lost;   /* lost: a value that is 0 though the truth is not below the smallest number */
} error;

static volatile sig_atomic_t interrupted;
static void on_interrupt(int signal_number) { (void)signal_number; interrupted = 1; }

/* ------------------------------------------------------------------------------------------------ truth ---- */

/* p(l,m) = a z p(l-1,m) - c p(l-2,m), values p {Im,Re}(x+iy)^m to out, all in MPFR */
static void evaluate_exactly(int bands, mpfr_t x, mpfr_t y, mpfr_t z, long double *out) {
    mpfr_t re, im, sector, p1, p2, p, t, u;
    int l, m;
    mpfr_inits2(BITS, re, im, sector, p1, p2, p, t, u, (mpfr_ptr)0);
    mpfr_set_ui(re, 1, MPFR_RNDN);
    mpfr_set_ui(im, 0, MPFR_RNDN);
    mpfr_const_pi(t, MPFR_RNDN);
    mpfr_mul_ui(t, t, 4, MPFR_RNDN);
    mpfr_rec_sqrt(sector, t, MPFR_RNDN);
    for (m = 0; m < bands; m++) {
        mpfr_set(p1, sector, MPFR_RNDN);
        mpfr_set_ui(p2, 0, MPFR_RNDN);
        for (l = m; l < bands; l++) {
            if (l > m) {
                unsigned long ll = (unsigned long)l, mm = (unsigned long)m;
                mpfr_mul(p, z, p1, MPFR_RNDN);
                if (l > m + 1) {
                    mpfr_set_ui(t, (ll - 1) * (ll - 1) - mm * mm, MPFR_RNDN);
                    mpfr_div_ui(t, t, 4 * (ll - 1) * (ll - 1) - 1, MPFR_RNDN);
                    mpfr_sqrt(t, t, MPFR_RNDN);
                    mpfr_mul(t, t, p2, MPFR_RNDN);
                    mpfr_sub(p, p, t, MPFR_RNDN);
                }
                mpfr_set_ui(t, 4 * ll * ll - 1, MPFR_RNDN);
                mpfr_div_ui(t, t, ll * ll - mm * mm, MPFR_RNDN);
                mpfr_sqrt(t, t, MPFR_RNDN);
                mpfr_mul(p, p, t, MPFR_RNDN);
                mpfr_swap(p2, p1);
                mpfr_swap(p1, p);
            }
            mpfr_mul(t, p1, im, MPFR_RNDN);
            out[l * (l + 1) - m] = mpfr_get_ld(t, MPFR_RNDN);
            mpfr_mul(t, p1, re, MPFR_RNDN);
            out[l * (l + 1) + m] = mpfr_get_ld(t, MPFR_RNDN);
        }
        mpfr_mul(t, re, x, MPFR_RNDN);
        mpfr_mul(u, im, y, MPFR_RNDN);
        mpfr_mul(im, im, x, MPFR_RNDN);
        mpfr_mul(re, re, y, MPFR_RNDN);
        mpfr_add(im, im, re, MPFR_RNDN);
        mpfr_sub(re, t, u, MPFR_RNDN);
        mpfr_set_ui(t, 2 * (unsigned long)m + 3, MPFR_RNDN);   /* sqrt((2m+3)/(2m+2)), and sqrt 2 once */
        mpfr_div_ui(t, t, m ? 2 * (unsigned long)m + 2 : 1, MPFR_RNDN);
        mpfr_sqrt(t, t, MPFR_RNDN);
        mpfr_mul(sector, sector, t, MPFR_RNDN);
    }
    mpfr_clears(re, im, sector, p1, p2, p, t, u, (mpfr_ptr)0);
}

static void reference_of(int bands, const double dir[3], const reference *truth) {
    mpfr_t v[3], norm, t;
    int i;
    mpfr_inits2(BITS, v[0], v[1], v[2], norm, t, (mpfr_ptr)0);
    mpfr_set_ui(norm, 0, MPFR_RNDN);
    for (i = 0; i < 3; i++) {
        mpfr_set_d(v[i], dir[i], MPFR_RNDN);
        mpfr_sqr(t, v[i], MPFR_RNDN);
        mpfr_add(norm, norm, t, MPFR_RNDN);
    }
    evaluate_exactly(bands, v[0], v[1], v[2], truth->raw);
    mpfr_sqrt(norm, norm, MPFR_RNDN);
    for (i = 0; i < 3; i++) mpfr_div(v[i], v[i], norm, MPFR_RNDN);
    evaluate_exactly(bands, v[0], v[1], v[2], truth->unit);
    mpfr_clears(v[0], v[1], v[2], norm, t, (mpfr_ptr)0);
}

/* ------------------------------------------------------------------------------------------- directions ---- */

/* v as a float holds it. Through memory, since GCC 12 -O2 vectorises (double)(float)v away. */
static double rounded(int as_float, double v) {
    volatile float f = (float)v;
    return as_float ? (double)f : v;
}

static int add_direction(double dirs[][3], int count, int as_float, double x, double y, double z) {
    if (count == MAX_DIRECTIONS) return count;
    dirs[count][0] = rounded(as_float, x);
    dirs[count][1] = rounded(as_float, y);
    dirs[count][2] = rounded(as_float, z);
    return count + 1;
}

static int add_polar(double dirs[][3], int count, int as_float, double theta, double phi, double sign) {
    return add_direction(dirs, count, as_float, sin(theta) * cos(phi), sin(theta) * sin(phi), sign * cos(theta));
}

/* Poles, axes, diagonals, rings around the poles down to 1e-30, and a Fibonacci spiral. `near` counts those at or
   within a hundredth of a pole, which come first. */
static int directions(double dirs[][3], int as_float, int *near) {
    static const double rings[] = { 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-12, 1e-20, 1e-30 };
    const int spiral = 48;
    const double half = sqrt(0.5), third = sqrt(1.0 / 3);
    int count = 0, i;
    count = add_direction(dirs, count, as_float, 0, 0, 1);
    count = add_direction(dirs, count, as_float, 0, 0, -1);
    for (i = 0; i < 8; i++) {
        count = add_polar(dirs, count, as_float, rings[i], 0.7, 1);
        count = add_polar(dirs, count, as_float, rings[i], 2.5, -1);
    }
    *near = count;
    count = add_direction(dirs, count, as_float, 1, 0, 0);
    count = add_direction(dirs, count, as_float, 0, -1, 0);
    count = add_direction(dirs, count, as_float, half, half, 0);
    count = add_direction(dirs, count, as_float, 0, half, -half);
    count = add_direction(dirs, count, as_float, -third, third, third);
    count = add_direction(dirs, count, as_float, 1, 1e-8, 1e-8);
    for (i = 0; i < spiral; i++)
        count = add_polar(dirs, count, as_float, acos(1 - (2 * i + 1.0) / spiral), 2.399963229728653 * i, 1);
    return count;
}

/* -------------------------------------------------------------------------------------------- measuring ---- */

/* 1, 2, 3 ... 64, 96, 128, 192, 256 ... */
static int band_steps(int max_bands, int steps[MAX_STEPS]) {
    int count = 0, n;
    for (n = 1; n <= max_bands; n = n < 64 ? n + 1 : n % 3 ? n / 2 * 3 : n / 3 * 4) steps[count++] = n;
    return count;
}

static void compare(error *e, int bands, const double *got, const reference *truth, double smallest) {
    int i;
    for (i = 0; i < bands * bands; i++) {
        double off = (double)fabsl((long double)got[i] - truth->unit[i]);
        double own = (double)fabsl((long double)got[i] - truth->raw[i]);
        if (!isfinite(got[i])) { e->not_finite++; continue; }
        if (got[i] == 0 && fabsl(truth->unit[i]) > (long double)smallest && fabsl(truth->raw[i]) > 1e-10L) e->lost++;
        if (off > e->most) e->most = off;
        if (own > e->own) e->own = own;
        e->squares += off * off;
    }
    e->count += (long)bands * bands;
}

static void *room(size_t bytes) {
    void *p = malloc(bytes);
    if (p) return p;
    fprintf(stderr, "accuracy: out of memory (%zu bytes); try fewer --bands\n", bytes);
    exit(1);
}

static void write_rows(FILE *csv, const char *precision, const char *where, const accuracy_form *forms, int form_count,
                       const int *steps, int step_count, error all[MAX_FORMS][MAX_STEPS]) {
    int f, s;
    for (f = 0; f < form_count; f++)
        for (s = 0; s < step_count; s++) {
            const error *e = &all[f][s];
            if (!e->count) continue;
            fprintf(csv, "\"%s\",%s,%s,%d,%ld,%.4g,%.4g,%.4g,%ld,%ld\n", forms[f].name, precision, where, steps[s],
                    e->count, e->most, e->own, sqrt(e->squares / (double)e->count), e->not_finite, e->lost);
        }
}

/* One precision: all directions, all forms, all numbers of bands. Interrupted, it writes the directions done. */
static void measure(FILE *csv, int as_float, int max_bands) {
    static error all[2][MAX_FORMS][MAX_STEPS];   /* [near a pole or not] */
    static double dirs[MAX_DIRECTIONS][3];
    size_t most = (size_t)max_bands * (size_t)max_bands;
    int steps[MAX_STEPS], step_count = band_steps(max_bands, steps), form_count, near, count, d, f, s;
    const accuracy_form *forms = as_float ? accuracy_forms_float(&form_count) : accuracy_forms_double(&form_count);
    double *got = (double *)room(most * sizeof *got), start = bench_seconds();
    reference truth;
    truth.unit = (long double *)room(most * sizeof(long double));
    truth.raw = (long double *)room(most * sizeof(long double));
    memset(all, 0, sizeof all);
    count = directions(dirs, as_float, &near);
    for (d = 0; d < count && !interrupted; d++) {
        if (isatty(2))
            fprintf(stderr, "\r%s, direction %d/%d, %.0f s left\033[K\r", as_float ? "float" : "double", d + 1, count,
                    d ? (bench_seconds() - start) / d * (count - d) : 0.0);
        reference_of(max_bands, dirs[d], &truth);
        for (f = 0; f < form_count; f++)
            for (s = 0; s < step_count && steps[s] <= forms[f].max_bands; s++) {
                forms[f].evaluate(steps[s], dirs[d], got);
                compare(&all[d >= near][f][s], steps[s], got, &truth, as_float ? 1.2e-38 : 2.3e-308);
            }
    }
    write_rows(csv, as_float ? "float" : "double", "poles", forms, form_count, steps, step_count, all[0]);
    write_rows(csv, as_float ? "float" : "double", "elsewhere", forms, form_count, steps, step_count, all[1]);
    free(got); free(truth.unit); free(truth.raw);
}

int main(int argc, char **argv) {
    const char *path = NULL;
    int max_bands = MAX_BANDS;
    const command_option options[] = {
        { "--csv", "FILE", "where to write [standard output]", &path, NULL, 0, 0 },
        { "--bands", "N", "largest number of bands [1024]", NULL, &max_bands, 1, MAX_BANDS }
    };
    const command line = { "accuracy", NULL, NULL, options, 2 };
    FILE *csv;
    command_read(&line, argc, argv);
    csv = path ? command_open(&line, path) : stdout;
    signal(SIGINT, on_interrupt);
    fprintf(csv, "# prt.h %s\n# machine: %s\n# compiler: %s\n# flags: %s\n", BENCH_VERSION, bench_cpu_name(),
            BENCH_COMPILER, BENCH_FLAGS);
    fprintf(csv, "form,precision,where,bands,values,error,own_error,rms,not_finite,lost\n");
    measure(csv, 1, max_bands);
    measure(csv, 0, max_bands);
    if (interrupted) fprintf(stderr, "accuracy: interrupted; written is what the directions done until then show\n");
    if (command_close(&line, csv)) return 1;
    return interrupted ? 130 : 0;
}
