/* operations - error against time of the logarithm, the exponential, windows and deringing, and lights; batched
   products beside what their operations allow.

     operations [-o docs/operations.md] [--plots docs/plots] [--header prt.h]

   Writes the tables of docs/operations.md and log_, exp_, smooth_, light_ and analytic_pareto.svg; the plots need
   gnuplot. Operations of kernels are read from the comments that codegen/ wrote into the header. Seeds are fixed: but
   for the times, every run writes the same. */
#ifndef _POSIX_C_SOURCE
#define _POSIX_C_SOURCE 200809L
#endif
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "batch_forms.h"
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8, SIZE = MOST * MOST, TRIALS = 24, POINTS = 16 };
static FILE *to;

static uint64_t state = 0x9e3779b97f4a7c15u;
static double uniform(void) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

static prt_vec3 direction(void) {
    double z = 2 * uniform() - 1, phi = 2 * PRT__PI * uniform(), r = sqrt(1 - z * z);
    return prt__vec3((prt_real)(r * cos(phi)), (prt_real)(r * sin(phi)), (prt_real)z);
}

/* ---- curves: one for each way, a point for each setting of its knob ---- */

typedef struct curve {
    const char *name, *knob;
    int count;
    double setting[POINTS], error[POINTS], us[POINTS];
} curve;
#define CURVE(name, knob) { name, knob, 0, { 0 }, { 0 }, { 0 } }

static void add_point(curve *c, double setting, double error, double us) {
    c->setting[c->count] = setting;
    c->error[c->count] = error;
    c->us[c->count++] = us;
}

static void print_curves(const char *title, const char *said, const curve *curves, int count) {
    int i, k;
    fprintf(to, "\n## %s\n\n%s\n\n| | error, time in us |\n|---|---|\n", title, said);
    for (i = 0; i < count; i++) {
        fprintf(to, "| %s |", curves[i].name);
        for (k = 0; k < curves[i].count; k++)
            fprintf(to, "%s %g %s: %.2g, %.3g", k ? ";" : "", curves[i].setting[k], curves[i].knob, curves[i].error[k],
                    curves[i].us[k]);
        fprintf(to, " |\n");
    }
}

static int plot(const char *folder, const char *name, const char *x, const char *y, const curve *curves, int count) {
    static const char *const colours[] = { "#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad", "#d35400", "#444444" };
    FILE *p = folder ? popen("gnuplot", "w") : NULL;
    int i, k;
    fprintf(to, "\n![Error against time](plots/%s)\n", name);
    if (!folder) return 1;
    if (!p) return 0;
    fprintf(
        p,
        "set terminal svg size 800,560 noenhanced dynamic font 'sans-serif,13' background 'white'\nset output '%s/%s'\n"
        "set logscale xy\nset autoscale yfix\nset format y '%%g'\nset xlabel '%s'\nset ylabel '%s'\nset grid xtics ytics lc rgb '#dddddd'\n"
        "set key outside top center maxcols 2 Left reverse\nplot ",
        folder, name, x, y);
    for (i = 0; i < count; i++)
        fprintf(p, "%s'-' with linespoints lw 2 pt %d lc rgb '%s' title '%s'", i ? ", " : "", i + 4, colours[i],
                curves[i].name);
    fprintf(p, "\n");
    for (i = 0; i < count; i++) {
        for (k = 0; k < curves[i].count; k++) fprintf(p, "%g %g\n", curves[i].us[k], curves[i].error[k]);
        fprintf(p, "e\n");
    }
    return pclose(p) == 0;
}

/* The least time of one run in us, `work` being run in rounds of about 50 us */
typedef void work_function(void *data);
static double time_of(work_function *work, void *data) {
    double best = 1e300;
    long repeat = 1, k;
    int round;
    for (round = -1; round < 9; round++) {
        double start = bench_seconds(), us;
        for (k = 0; k < repeat; k++) work(data);
        us = 1e6 * (bench_seconds() - start);
        if (round < 0) { repeat = us < 50 ? (long)(50 / (us > 0.01 ? us : 0.01)) + 1 : 1; continue; }
        if (us / (double)repeat < best) best = us / (double)repeat;
    }
    return best;
}

/* ---- exact functions of the operator "multiply by f": its eigenvalues, in double ---- */

typedef struct spectrum { int n; double a[SIZE][SIZE], v[SIZE][SIZE]; } spectrum;

static void diagonalise(spectrum *s) {
    int sweep, p, q, k;
    for (p = 0; p < s->n; p++)
        for (q = 0; q < s->n; q++) s->v[p][q] = p == q;
    for (sweep = 0; sweep < 12; sweep++)
        for (p = 0; p < s->n; p++)
            for (q = p + 1; q < s->n; q++) {
                double t, c, g;
                if (fabs(s->a[p][q]) < 1e-18) continue;
                t = (s->a[q][q] - s->a[p][p]) / (2 * s->a[p][q]);
                t = (t < 0 ? -1 : 1) / (fabs(t) + sqrt(t * t + 1));
                c = 1 / sqrt(t * t + 1);
                g = t * c;
                for (k = 0; k < s->n; k++) {
                    double x = s->a[k][p], y = s->a[k][q];
                    s->a[k][p] = c * x - g * y;
                    s->a[k][q] = g * x + c * y;
                }
                for (k = 0; k < s->n; k++) {
                    double x = s->a[p][k], y = s->a[q][k], z = s->v[k][p], w = s->v[k][q];
                    s->a[p][k] = c * x - g * y;
                    s->a[q][k] = g * x + c * y;
                    s->v[k][p] = c * z - g * w;
                    s->v[k][q] = g * z + c * w;
                }
            }
}

static double triple[SIZE][SIZE][SIZE];
static void make_triples(int bands) {
    int i, j, k, l[SIZE], m[SIZE], n = bands * bands;
    for (i = 0; i < n; i++) {
        for (l[i] = 0; (l[i] + 1) * (l[i] + 1) <= i; l[i]++) { }
        m[i] = i - l[i] * (l[i] + 1);
    }
    for (i = 0; i < n; i++)
        for (j = i; j < n; j++)
            for (k = j; k < n; k++) {
                double g = prt_sh_triple(l[i], m[i], l[j], m[j], l[k], m[k]);
                triple[i][j][k] = triple[i][k][j] = triple[j][i][k] = triple[j][k][i] = triple[k][i][j] =
                    triple[k][j][i] = g;
            }
}

static double clamped_log(double x) { return log(x < 0.02 ? 0.02 : x); }

/* out = F(M_f) 1 */
static void exactly(int bands, double (*function)(double), const prt_real *f, double *out) {
    static spectrum s;
    int i, j, k, n = s.n = bands * bands;
    for (i = 0; i < n; i++)
        for (k = 0; k < n; k++)
            for (s.a[i][k] = 0, j = 0; j < n; j++) s.a[i][k] += triple[i][j][k] * (double)f[j];
    diagonalise(&s);
    for (i = 0; i < n; i++)
        for (out[i] = 0, k = 0; k < n; k++) out[i] += s.v[i][k] * function(s.a[k][k]) * s.v[0][k] * sqrt(4 * PRT__PI);
}

static double relative(int n, const prt_real *got, const double *want) {
    double off = 0, all = 0;
    int i;
    for (i = 0; i < n; i++) {
        off += ((double)got[i] - want[i]) * ((double)got[i] - want[i]);
        all += want[i] * want[i];
    }
    return sqrt(off / all);
}

/* ---- logarithm ---- */

typedef struct job { int bands, way, knob; const prt_real *f; prt_real out[SIZE]; } job;

static void run_log(void *data) {
    job *j = (job *)data;
    prt_sh_log(j->bands, j->knob, PRT__R(0.02), j->f, j->out);
    BENCH_KEEP(j->out);
}

/* What one blocker leaves: 1 less a cap of 5 to 30 degrees */
static void make_visible(int bands, prt_real *f) {
    int i;
    prt_sh_cone(bands, direction(), (prt_real)((5 + 25 * uniform()) * PRT__PI / 180), f);
    for (i = 0; i < bands * bands; i++) f[i] = -f[i];
    f[0] += PRT__R(3.5449077018110320546);
}

static int measure_logs(const char *folder) {
    static const int bands[] = { 3, 4, 6, 8 }, steps[] = { 1, 2, 3, 4, 5, 6, 8, 10, 12 };
    static curve curves[4] = { CURVE("3 bands", "steps"), CURVE("4 bands", "steps"),
                               CURVE("6 bands", "steps"), CURVE("8 bands", "steps") };
    static prt_real f[TRIALS][SIZE];
    static double want[TRIALS][SIZE];
    size_t b, s;
    int t;
    for (b = 0; b < 4; b++) {
        job j;
        make_triples(bands[b]);
        for (t = 0; t < TRIALS; t++) {
            make_visible(bands[b], f[t]);
            exactly(bands[b], clamped_log, f[t], want[t]);
        }
        for (s = 0; s < sizeof steps / sizeof *steps; s++) {
            double sum = 0;
            j.bands = bands[b];
            j.knob = steps[s];
            for (t = 0; t < TRIALS; t++) {
                j.f = f[t];
                run_log(&j);
                sum += pow(relative(bands[b] * bands[b], j.out, want[t]), 2) / TRIALS;
            }
            add_point(&curves[b], steps[s], sqrt(sum), time_of(run_log, &j));
        }
    }
    print_curves("Logarithm (`prt_sh_log`)",
                 "Visibility of one cap of 5 to 30 degrees, least .02; against the eigenvalues of the\n"
                 "operator \"multiply by f\" in double. Relative to the logarithm's norm, root mean square.",
                 curves, 4);
    return plot(folder, "log_pareto.svg", "us a logarithm, 1 to 12 steps from left to right",
                "error of prt_sh_log, relative", curves, 4);
}

/* ---- exponential ---- */

/* e^mean (series of x/2^h to a degree)^(2^h), the norm of x/2^h at most limit; limit 0: no halving */
static void series(int bands, int degree, double limit, const prt_real *f, prt_real *out) {
    const prt_real one = PRT__R(3.5449077018110320546);
    prt_real x[SIZE];
    double length = 0, factor = 1, mean = exp((double)f[0] / (double)one);
    int n = bands * bands, h = 0, i, k;
    for (i = 1; i < n; i++) length += (double)f[i] * (double)f[i];
    for (length = sqrt(length); limit > 0 && length > limit; length /= 2, factor /= 2) h++;
    for (x[0] = 0, i = 1; i < n; i++) x[i] = (prt_real)((double)f[i] * factor);
    for (i = 0; i < n; i++) out[i] = x[i] / (prt_real)degree;
    out[0] += one;
    for (k = degree - 1; k > 0; k--) {
        prt_sh_product(bands, x, out, out);
        for (i = 0; i < n; i++) out[i] /= (prt_real)k;
        out[0] += one;
    }
    for (; h > 0; h--) prt_sh_square(bands, out, out);
    for (i = 0; i < n; i++) out[i] = (prt_real)((double)out[i] * mean);
}

enum { EXP_WAYS = 6 };
static const double limits[EXP_WAYS] = { 0, 2, 1, 0.5, 0, 0 };

static void run_exp(void *data) {
    job *j = (job *)data;
    if (j->way == 4) prt_sh_exp(j->bands, j->f, j->out);
    else if (j->way == 5) prt_sh_exp_linear(j->bands, j->f, j->out);
    else series(j->bands, j->knob, limits[j->way], j->f, j->out);
    BENCH_KEEP(j->out);
}

static int measure_exps(const char *folder) {
    enum { BANDS = 4, N = BANDS * BANDS };
    static curve curves[EXP_WAYS] = {
        CURVE("product series, degrees 1 to 12", "terms"),
        CURVE("halved to norm 2, degrees 1 to 8", "terms"),
        CURVE("halved to norm 1, degrees 1 to 8", "terms"),
        CURVE("halved to norm 1/2, degrees 1 to 8", "terms"),
        CURVE("prt_sh_exp (norm 1, degree 4)", "terms"),
        CURVE("prt_sh_exp_linear", "terms")
    };
    static prt_real f[TRIALS][SIZE];
    static double want[TRIALS][SIZE];
    int t, b, i, way, degree;
    make_triples(BANDS);
    for (t = 0; t < TRIALS; t++) {
        memset(f[t], 0, sizeof f[t]);
        for (b = 0; b < 16; b++) {
            prt_real one[SIZE], log_of_one[SIZE];
            make_visible(BANDS, one);
            prt_sh_log(BANDS, PRT_KRYLOV_MAX, PRT__R(0.02), one, log_of_one);
            for (i = 0; i < N; i++) f[t][i] += log_of_one[i];
        }
        exactly(BANDS, exp, f[t], want[t]);
    }
    for (way = 0; way < EXP_WAYS; way++)
        for (degree = way == 4 ? 4 : 1; degree <= (way == 5 ? 1 : way == 4 ? 4 : way ? 8 : 12); degree++) {
            job j;
            double sum = 0;
            j.bands = BANDS;
            j.way = way;
            j.knob = degree;
            for (t = 0; t < TRIALS; t++) {
                j.f = f[t];
                run_exp(&j);
                sum += pow(relative(N, j.out, want[t]), 2) / TRIALS;
            }
            add_point(&curves[way], degree, sqrt(sum), time_of(run_exp, &j));
        }
    print_curves(
        "Exponential (`prt_sh_exp`)",
        "The summed logarithms of 16 such caps, 4 bands; against the eigenvalues as above, so this is the error of\n"
        "the series alone: what 4 bands cannot hold of 16 caps comes on top, and is larger ([masks.md](masks.md)). "
        "Halving has an error of\n"
        "its own, for the square of a truncated function, truncated, is not the function of the truncated operator; "
        "the\n"
        "plain series has not, but needs a degree that grows with the norm, and loses digits by cancellation.",
        curves, EXP_WAYS);
    return plot(folder, "exp_pareto.svg", "us an exponential", "error of exp*, relative", curves, EXP_WAYS);
}

/* ---- windows, deringing ---- */

enum { SMOOTH_WAYS = 5 };
static void run_smooth(void *data) {
    static const prt_window windows[4] = { PRT_WINDOW_NONE, PRT_WINDOW_HANN, PRT_WINDOW_LANCZOS, PRT_WINDOW_POSITIVE };
    job *j = (job *)data;
    if (j->way == 4) prt_sh_dering(j->bands, j->f, j->out, NULL);
    else prt_sh_window(j->bands, windows[j->way], j->bands, j->f, j->out);
    BENCH_KEEP(j->out);
}

static int measure_smoothing(const char *folder) {
    static curve curves[SMOOTH_WAYS] = {
        CURVE("no window", "bands"), CURVE("Hann", "bands"),
        CURVE("Lanczos", "bands"), CURVE("positive", "bands"),
        CURVE("prt_sh_dering", "bands")
    };
    double deepest[SMOOTH_WAYS][MOST + 1];
    int way, n, t, i;
    for (way = 0; way < SMOOTH_WAYS; way++)
        for (n = 2; n <= MOST; n++) {
            double sum = 0, us = 0;
            static prt_real f[TRIALS][SIZE];
            job j;
            state = 7;
            deepest[way][n] = 0;
            j.bands = n;
            j.way = way;
            j.f = f[0];
            for (t = 0; t < TRIALS; t++) {
                double angle = (10 + 80 * uniform()) * PRT__PI / 180, area = 2 * PRT__PI * (1 - cos(angle)), off = area,
                       least;
                prt_sh_cone(n, direction(), (prt_real)angle, f[t]);
                j.f = f[t];
                run_smooth(&j);
                for (i = 0; i < n * n; i++) off += (double)j.out[i] * ((double)j.out[i] - 2 * (double)f[t][i]);
                sum += off / area / TRIALS;
                us += time_of(run_smooth, &j) / TRIALS;
                least = (double)prt_sh_minimum(n, j.out, NULL);
                if (least < deepest[way][n]) deepest[way][n] = least;
            }
            add_point(&curves[way], n, sqrt(sum), us);
        }
    print_curves(
        "Windows and deringing",
        "Caps of 10 to 90 degrees: distance of the smoothed function from the cap itself, relative, root mean square;\n"
        "below, the least value that is left anywhere.",
        curves, SMOOTH_WAYS);
    fprintf(to,
            "\n| least value, the cap is 1 | 2 bands | 3 | 4 | 5 | 6 | 7 | 8 |\n|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (way = 0; way < SMOOTH_WAYS; way++) {
        fprintf(to, "| %s |", curves[way].name);
        for (n = 2; n <= MOST; n++) fprintf(to, " %.3f |", deepest[way][n]);
        fprintf(to, "\n");
    }
    return plot(folder, "smooth_pareto.svg", "us, 2 to 8 bands", "distance from the cap, relative", curves,
                SMOOTH_WAYS);
}

/* ---- lights: a smooth lobe, e^(8 (t-1)), 5 bands, by samples of it ---- */

enum { LIGHT_BANDS = 5, LIGHT_N = LIGHT_BANDS * LIGHT_BANDS, LIGHT_WAYS = 4, LARGEST = 512 };
static const double sharpness = 8;
static float texels[6 * 3 * LARGEST * LARGEST / 2];
static prt_vec3 lobe_axis, sample_dirs[65536];
static prt_real sample_values[65536];

static double lobe(double x, double y, double z) {
    return exp(sharpness * (((double)lobe_axis.x * x + (double)lobe_axis.y * y + (double)lobe_axis.z * z) /
                                sqrt(x * x + y * y + z * z) -
                            1));
}

static void exact_lobe(double *want) {
    prt_real y[LIGHT_N];
    double g[LIGHT_BANDS] = { 0 };
    int k, l, m, steps = 200000;
    for (k = 0; k < steps; k++) {
        double t = 2 * (k + 0.5) / steps - 1, p = 1, before = 0, w = 4 * PRT__PI / steps * exp(sharpness * (t - 1));
        for (l = 0; l < LIGHT_BANDS; l++) {
            double next = ((2 * l + 1) * t * p - l * before) / (l + 1);
            g[l] += w * p;
            before = p;
            p = next;
        }
    }
    prt_sh_eval(LIGHT_BANDS, lobe_axis, y);
    for (l = 0; l < LIGHT_BANDS; l++)
        for (m = -l; m <= l; m++) want[PRT_SH_INDEX(l, m)] = g[l] * (double)y[PRT_SH_INDEX(l, m)];
}

static void fill_light(int way, int knob) {
    int i, j, face, c;
    if (way == 0)
        for (j = 0; j < knob / 2; j++)
            for (i = 0; i < knob; i++) {
                double theta = PRT__PI * (j + 0.5) / (knob / 2), phi = 2 * PRT__PI * (i + 0.5) / knob;
                for (c = 0; c < 3; c++)
                    texels[3 * (j * knob + i) + c] =
                        (float)lobe(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
            }
    if (way == 1)
        for (face = 0; face < 6; face++)
            for (j = 0; j < knob; j++)
                for (i = 0; i < knob; i++) {
                    double s = 2 * (i + 0.5) / knob - 1, t = 2 * (j + 0.5) / knob - 1, d[6][3] = {
                        { 1, -t, -s }, { -1, -t, s }, { s, 1, t }, { s, -1, -t }, { s, -t, 1 }, { -s, -t, -1 } };
                    for (c = 0; c < 3; c++)
                        texels[3 * ((face * knob + j) * knob + i) + c] =
                            (float)lobe(d[face][0], d[face][1], d[face][2]);
                }
    for (i = 0; way > 1 && i < knob; i++) {
        double z = 1 - 2 * (i + 0.5) / knob, phi = i * PRT__PI * (3 - sqrt(5.0)), r = sqrt(1 - z * z);
        sample_dirs[i] =
            way == 2 ? direction() : prt__vec3((prt_real)(r * cos(phi)), (prt_real)(r * sin(phi)), (prt_real)z);
        sample_values[i] =
            (prt_real)(lobe((double)sample_dirs[i].x, (double)sample_dirs[i].y, (double)sample_dirs[i].z) * 4 *
                       PRT__PI / knob);
    }
}

typedef struct light_job { int way, knob; prt_real out[3 * LIGHT_N]; } light_job;
static void run_light(void *data) {
    light_job *j = (light_job *)data;
    const float *faces[6];
    int i;
    if (j->way == 0) prt_sh_project_equirect_rgb(LIGHT_BANDS, j->knob, j->knob / 2, texels, j->out);
    for (i = 0; i < 6; i++) faces[i] = texels + (size_t)i * 3 * (size_t)j->knob * (size_t)j->knob;
    if (j->way == 1) prt_sh_project_cubemap_rgb(LIGHT_BANDS, j->knob, faces, j->out);
    if (j->way > 1) {
        memset(j->out, 0, sizeof j->out);
        for (i = 0; i < j->knob; i++) prt_sh_add_sample(LIGHT_BANDS, sample_dirs[i], sample_values[i], j->out);
    }
    BENCH_KEEP(j->out);
}

static int measure_lights(const char *folder) {
    static curve curves[LIGHT_WAYS] = {
        CURVE("latitude-longitude maps, 3 channels", "wide"), CURVE("cube maps, 3 channels", "wide"),
        CURVE("random directions, 1 channel", "samples"), CURVE("a spiral of directions, 1 channel", "samples")
    };
    static const int first[LIGHT_WAYS] = { 16, 4, 64, 64 }, last[LIGHT_WAYS] = { 512, 128, 65536, 65536 };
    int way, knob, t;
    for (way = 0; way < LIGHT_WAYS; way++)
        for (knob = first[way]; knob <= last[way]; knob *= way < 2 ? 2 : 4) {
            double want[LIGHT_N], sum = 0;
            light_job j;
            state = 5;
            j.way = way;
            j.knob = knob;
            for (t = 0; t < 4; t++) {
                lobe_axis = direction();
                exact_lobe(want);
                fill_light(way, knob);
                run_light(&j);
                sum += pow(relative(LIGHT_N, j.out, want), 2) / 4;
            }
            add_point(&curves[way], knob, sqrt(sum), time_of(run_light, &j));
        }
    print_curves("Lights by samples",
                 "The lobe e^(8 (t-1)) about a random axis, 5 bands; against its factors by quadrature. Relative, root "
                 "mean square. Many\n"
                 "samples added to a float one by one lose digits in the sum; maps are summed in double.",
                 curves, LIGHT_WAYS);
    return plot(folder, "light_pareto.svg", "us a projection", "error of 5 bands, relative", curves, LIGHT_WAYS);
}

/* ---- analytic lights ---- */

static void run_analytic(void *data) {
    job *j = (job *)data;
    static prt_real wide_out[64 * 64];
    const prt_vec3 up = { 0, 0, 1 };
    switch (j->way) {
    case 0: prt_sh_delta(j->bands, up, wide_out); break;
    case 1: prt_sh_cone(j->bands, up, PRT__R(0.3), wide_out); break;
    case 2: prt_sh_cosine_lobe(j->bands, up, wide_out); break;
    default: prt_sh_hemisphere(j->bands, up, 1, PRT__R(0.25), wide_out);
    }
    BENCH_KEEP(wide_out);
    j->f = wide_out;
}

/* integral of F P_l over -1 ... 1: exact for a step and a ramp by Gauss-Legendre on either side of the edge */
static double factor_of(int way, int l) {
    const double edge = way == 1 ? cos((double)PRT__R(0.3)) : 0;
    double sum = 0;
    int side, i, k;
    if (way == 0) return 1;
    for (side = 0; side < 2; side++)
        for (i = 0; i < 40; i++) {
            double low = side ? edge : -1, high = side ? 1 : edge, z, w, t, p = 1, before = 0;
            prt__gauss_legendre(40, i, &z, &w);
            t = low + (high - low) * (z + 1) / 2;
            for (k = 1; k <= l; k++) {
                double next = ((2 * k - 1) * t * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            sum += PRT__PI * (high - low) * w * p * (way == 1 ? side : way == 2 ? side * t : side ? 1 : 0.25);
        }
    return sum;
}

static int measure_analytic(const char *folder) {
    static const int bands[] = { 2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 32, 48, 64 };
    static curve curves[4] = { CURVE("prt_sh_delta", "bands"), CURVE("prt_sh_cone, 0.3", "bands"),
                               CURVE("prt_sh_cosine_lobe", "bands"), CURVE("prt_sh_hemisphere", "bands") };
    size_t b;
    int way, l;
    for (way = 0; way < 4; way++)
        for (b = 0; b < sizeof bands / sizeof *bands; b++) {
            job j;
            double off = 0, all = 0;
            j.way = way;
            j.bands = bands[b];
            run_analytic(&j);
            for (l = 0; l < bands[b]; l++) {
                double want = factor_of(way, l) * sqrt((2 * l + 1) / (4 * PRT__PI));
                off += pow((double)j.f[PRT_SH_INDEX(l, 0)] - want, 2);
                all += want * want;
            }
            add_point(&curves[way], bands[b], sqrt(off / all), time_of(run_analytic, &j));
        }
    print_curves("Analytic lights", "About +z, 2 to 64 bands; against quadrature in double. Relative.", curves, 4);
    return plot(folder, "analytic_pareto.svg", "us a light, 2 to 64 bands from left to right", "error, relative",
                curves, 4);
}

/* ---- batched products: what their operations allow ---- */

typedef struct operations { int multiplications, additions, fused; } operations;

/* of the kernel whose comment in the header starts so */
static int read_operations(const char *header, const char *what, int bands, operations *o) {
    char line[512], start[128];
    FILE *file = fopen(header, "r");
    int found = 0;
    if (!file) return 0;
    snprintf(start, sizeof start, "/* %s, %d bands: ", what, bands);
    while (!found && fgets(line, sizeof line, file))
        found = !strncmp(line, start, strlen(start)) &&
                sscanf(line + strlen(start), "%d multiplications, %d additions (%d can fuse)", &o->multiplications,
                       &o->additions, &o->fused) == 3;
    fclose(file);
    return found;
}

static void add_operations(operations *o, int times, const operations *more) {
    o->multiplications += times * more->multiplications;
    o->additions += times * more->additions;
    o->fused += times * more->fused;
}

/* of one pair of 5 bands: both factors' parts, the cube, each axis and its plane, the coefficients */
static int point_operations(const char *header, operations *o) {
    static const struct { const char *what; int times; } kernels[] = {
        { "parts of a function", 2 }, { "sums over the corners of a cube", 1 }, { "sums over the points of an axis", 3 },
        { "sums over the points of a plane", 3 }, { "coefficients of sums over points", 1 }
    };
    size_t i;
    memset(o, 0, sizeof *o);
    for (i = 0; i < sizeof kernels / sizeof *kernels; i++) {
        operations of;
        if (!read_operations(header, kernels[i].what, 5, &of)) return 0;
        add_operations(o, kernels[i].times, &of);
    }
    return 1;
}

/* of one pair: to 4 bands one kernel; at 6 for each pair of circles two rows and a product on both, their fold, and the
   projection */
static int pair_operations(const char *header, int bands, operations *o) {
    operations rows, product;
    int pairs = (3 * bands + 1) / 4, n = bands * bands;
    if (bands < 5) return read_operations(header, "products", bands, o);
    if (bands == 5) return point_operations(header, o);
    if (!read_operations(header, "rows of a function at z and -z", bands, &rows)) return 0;
    if (!read_operations(header, "product of two rows", bands, &product)) return 0;
    o->multiplications = pairs * n;
    o->additions = pairs * 4 * bands + (pairs - 1) * n;
    o->fused = (pairs - 1) * n;
    add_operations(o, 2 * pairs, &rows);
    add_operations(o, 2 * pairs, &product);
    return 1;
}

static int print_batches(const char *header) {
    static const int theirs[7] = { 0, 0, 0, 120, 399, 1135, 2527 };
    struct {
        const char *name;
        int present;
        batch_rates rates;
    } width[3] = { { "SSE2", 1, { 0, 0, { 0 } } }, { "AVX2", 0, { 0, 0, { 0 } } }, { "native", 1, { 0, 0, { 0 } } } };
    int i, n;
    batch_portable(&width[0].rates);
    batch_native(&width[2].rates);
    if (width[0].rates.lanes != 4) width[0].name = "portable";
#ifdef BENCH_HAS_AVX2
    width[1].present = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (width[1].present) batch_avx2(&width[1].rates);
#endif
    fprintf(to, "\n## Batches of products: what their operations allow\n\n"
                "`prt_sh_product_soa`, 64 pairs in the first-level cache, beside the least time that its operations "
                "take at the peak of\n"
                "the same run (multiplications on two units, additions that do not fuse on two others). `XMSHMultiply` "
                "of DirectXMath\n"
                "takes 120, 399, 1135, 2527 multiplications at 3 to 6 bands, as its source says, one at a time; \"at "
                "most\" is by how\n"
                "much a batch can win where both run at the peak, and \"won\" by how much it does beside that ideal. "
                "The aim, 8 times\n"
                "faster a pair, lies beyond what four lanes can give, and within eight and sixteen.\n\n"
                "| | bands | multiplications | additions | of which fuse | ns a pair, least | ns a pair | of the peak "
                "| at most | won |\n"
                "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    for (i = 0; i < 3; i++)
        for (n = 3; n <= 6 && width[i].present; n++) {
            const batch_rates *r = &width[i].rates;
            operations o;
            int fuses = i > 0, adds;
            double least, their_least = theirs[n] * 2.0 * r->lanes / r->flops;
            if (!pair_operations(header, n, &o)) return 0;
            adds = o.additions - (fuses ? o.fused : 0);
            least = (o.multiplications > adds ? o.multiplications : adds) * 2.0 / r->flops;
            fprintf(to, "| %s, %d lanes | %d | %d | %d | %d | %.2f | %.2f | %.2f | %.1f | %.1f |\n", width[i].name,
                    r->lanes, n, o.multiplications, o.additions, o.fused, least, r->ns[n], least / r->ns[n],
                    their_least / least, their_least / r->ns[n]);
        }
    return 1;
}

static int usage(void) {
    fprintf(stderr, "operations: usage: operations [-o FILE.md] [--plots FOLDER] [--header prt.h]\n");
    return 2;
}

int main(int argc, char **argv) {
    const char *page = NULL, *folder = NULL, *header = "prt.h";
    int i, drawn;
    for (i = 1; i < argc; i += 2) {
        if (i + 1 == argc) return usage();
        if (!strcmp(argv[i], "-o")) page = argv[i + 1];
        else if (!strcmp(argv[i], "--plots")) folder = argv[i + 1];
        else if (!strcmp(argv[i], "--header")) header = argv[i + 1];
        else return usage();
    }
    to = page ? fopen(page, "w") : stdout;
    if (!to) {
        fprintf(stderr, "operations: cannot write %s: check the path and its permissions\n", page);
        return 1;
    }
    fprintf(to,
            "# Error against time, operation by operation\n\nWritten by `bench/operations.c` on %s, %s, %s, float, %d "
            "lanes. Evaluation and its error:\n"
            "[accuracy.md](accuracy.md), [speed.md](speed.md); rotation and CH: [rotation.md](rotation.md); products, "
            "masks and many blockers:\n"
            "[masks.md](masks.md); bakes: [bake.md](bake.md).\n",
            bench_cpu_name(), BENCH_COMPILER, BENCH_FLAGS, PRT__LANES);
    drawn = measure_logs(folder) & measure_exps(folder) & measure_smoothing(folder) & measure_lights(folder) &
            measure_analytic(folder);
    if (!print_batches(header)) {
        fprintf(stderr,
                "operations: no operations of product kernels in %s: give --header with the prt.h of this tree\n",
                header);
        return 1;
    }
    if (ferror(to) || (page && fclose(to))) {
        fprintf(stderr, "operations: cannot write %s: is the disk full?\n", page ? page : "the page");
        return 1;
    }
    if (!drawn) {
        fprintf(stderr, "operations: no plots in %s: check that gnuplot is installed and the folder exists\n", folder);
        return 1;
    }
    return 0;
}
