/* rotation - measures rotation and cpherical harmonics, and writes docs/rotation.md:
     how far rotation blocks are from orthogonal, band by band: the recursion as published and prt.h's;
     error against time of every way to rotate a vector, and of every way to evaluate CH;
     how far a thousand turns by 2 pi/1000 miss, and what of that the rounding of the matrix alone does;
     the rate at which many vectors are turned, over that of memcpy.

     rotation [--csv FILE] [--points FILE] [-o FILE]

   Prints a few rows; --csv writes the blocks for rotation_error.gp, --points the errors and times for rotation_pareto.gp,
   -o the page. Takes half a minute. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "command.h"
#define PUBLISHED_REAL long double
#define PUBLISHED_ROOT(v) sqrtl(v)
#include "published_rotation.h"
#include "rotation_forms.h"

/* ---- what is right: in long double, by the published recursion and by the definition of CH ---- */

enum { LARGEST = ROTATION_LARGEST, NODES = 48 };

static void turned(int bands, const double *r, const double *f, double *want) {
    static const int axis[3] = { 1, 2, 0 };
    static long double block[2][(2 * LARGEST - 1) * (2 * LARGEST - 1)];
    long double block1[9];
    int l, i, j;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) block1[3 * i + j] = (long double)r[3 * axis[i] + axis[j]];
    want[0] = f[0];
    memcpy(block[1], block1, sizeof block1);
    for (l = 1; l < bands; l++) {
        if (l > 1) published_block(l, block1, block[(l - 1) & 1], block[l & 1]);
        for (i = 0; i <= 2 * l; i++) {
            long double sum = 0;
            for (j = 0; j <= 2 * l; j++) sum += block[l & 1][i * (2 * l + 1) + j] * (long double)f[l * l + j];
            want[l * l + i] = (double)sum;
        }
    }
}

/* t[m][l] = d^m T_l / dz^m */
static void chebyshev(long double z, long double t[LARGEST][LARGEST]) {
    int l, m;
    for (m = 0; m < LARGEST; m++)
        for (l = 0; l < LARGEST; l++)
            if (l < m) t[m][l] = 0;
            else if (l < 2) t[m][l] = m == l ? 1 : z;
            else t[m][l] = 2 * z * t[m][l - 1] - t[m][l - 2] + (m ? 2 * m * t[m - 1][l - 1] : 0);
    t[0][0] = 1;
}

/* One node of the Gauss-Legendre rule, by Newton's method. */
static long double node(int i, long double *weight) {
    long double z = cosl(acosl(-1) * (i + 0.75L) / (NODES + 0.5L)), slope = 1;
    int step, k;
    for (step = 0; step < 12; step++) {
        long double p = 1, before = 0;
        for (k = 1; k <= NODES; k++) {
            long double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
            before = p;
            p = next;
        }
        slope = NODES * (before - z * p) / (1 - z * z);
        z -= p / slope;
    }
    *weight = 2 / ((1 - z * z) * slope * slope);
    return z;
}

/* The factor that makes C(l,m) of unit norm, by quadrature. */
static long double ch_factor(int l, int m) {
    static long double integral[LARGEST][LARGEST], t[LARGEST][LARGEST];
    if (integral[0][0] == 0) {
        int i, a, b;
        for (i = 0; i < NODES; i++) {
            long double weight, z = node(i, &weight);
            chebyshev(z, t);
            for (b = 0; b < LARGEST; b++)
                for (a = b; a < LARGEST; a++) integral[b][a] += weight * powl(1 - z * z, b) * t[b][a] * t[b][a];
        }
    }
    return sqrtl(1 / (integral[m][l] * acosl(-1) * (m ? 1 : 2)));
}

static void ch_basis(int bands, const double *d, const double *f, double *want) {
    static long double t[LARGEST][LARGEST];
    long double re = 1, im = 0, x = (long double)d[0], y = (long double)d[1];
    int l, m;
    (void)f;
    chebyshev((long double)d[2], t);
    for (m = 0; m < bands; m++) {
        long double next = re * x - im * y;
        for (l = m; l < bands; l++) {
            long double c = ch_factor(l, m) * t[m][l];
            want[l * (l + 1) - m] = (double)(c * im);
            want[l * (l + 1) + m] = (double)(c * re);
        }
        im = im * x + re * y;
        re = next;
    }
}

/* ---- output ---- */

static int print_blocks(FILE *csv) {
    static double error[4][ROTATION_BANDS];
    int l;
    if (!rotation_blocks_float(error[0], error[1]) || !rotation_blocks_double(error[2], error[3])) return 0;
    printf("largest |M M^T - 1| over %d rotations\n", ROTATION_TRIALS);
    printf("%4s %20s %20s %20s %20s\n", "l", "published, float", "prt.h, float", "published, double", "prt.h, double");
    if (csv) fprintf(csv, "# machine: %s\n# compiler: %s %s\nl,published_float,prt_float,published_double,prt_double\n",
                     bench_cpu_name(), BENCH_COMPILER, BENCH_FLAGS);
    for (l = 0; l < ROTATION_BANDS; l++) {
        if (l == 8 || (l + 1) % 16 == 0)
            printf("%4d %20.2g %20.2g %20.2g %20.2g\n", l, error[0][l], error[1][l], error[2][l], error[3][l]);
        if (csv) fprintf(csv, "%d,%.3g,%.3g,%.3g,%.3g\n", l, error[0][l], error[1][l], error[2][l], error[3][l]);
    }
    return 1;
}

/* ---- others, side by side (peer.h) ---- */

enum { MOST_PEERS = 16 };
static const bench_peer *peers[MOST_PEERS];
static int peer_count;

void bench_add_peers(const bench_peer *rows, int count) {
    int i;
    for (i = 0; i < count; i++)
        if (!strcmp(rows[i].job, "rotate") && peer_count < MOST_PEERS) peers[peer_count++] = &rows[i];
}

/* Their points, with prt.h's of the same build and bands beside them. */
static void print_peers(FILE *csv, const rotation_point *points, int count, int real_bytes) {
    int i, k;
    for (i = 0; i < peer_count; i++)
        for (k = 0; k < count; k++) {
            rotation_point p;
            if (strcmp(points[k].form, "one shot") || peers[i]->real_bytes != real_bytes
                || !bench_has_band(peers[i]->bands, points[k].bands)) continue;
            p = real_bytes == 4 ? rotation_peer_float(turned, peers[i], points[k].bands)
                                : rotation_peer_double(turned, peers[i], points[k].bands);
            printf("%s, %d bands: %.4g ns, error %.1e; prt.h %.2f of its time, error %.1e\n", p.form, p.bands, p.ns,
                   p.error, points[k].ns / p.ns, points[k].error);
            if (csv) fprintf(csv, "peer,%s,%s,%d,%.4g,%.3g,%.3f,%.3g\n", p.form, real_bytes == 4 ? "float" : "double",
                             p.bands, p.ns, p.error, points[k].ns / p.ns, points[k].error);
        }
}

/* What was kept of a run with peers goes onto the page: few have their code. */
static void page_peers(FILE *page, const char *path) {
    FILE *csv = path && page ? fopen(path, "r") : NULL;
    char line[512], name[256], build[16];
    int bands, rows = 0;
    double ns, error, ratio, own;
    while (csv && fgets(line, sizeof line, csv)) {
        if (sscanf(line, "peer,%255[^,],%15[^,],%d,%lf,%lf,%lf,%lf", name, build, &bands, &ns, &error, &ratio, &own) != 7)
            continue;
        if (!rows++)
            fprintf(page, "\nOthers, in runs side by side (bench/peer.h; kept in bench/results/rotation-peers.csv):\n\n"
                          "| one vector, one rotation | bands | ns | error | prt.h, of that time | prt.h, error |\n"
                          "|---|--:|--:|--:|--:|--:|\n");
        fprintf(page, "| %s, %s | %d | %.4g | %.1e | %.2f | %.1e |\n", name, build, bands, ns, error, ratio, own);
    }
    if (csv) fclose(csv);
}

static void page_head(FILE *page) {
    fprintf(page, "# Rotation and cpherical harmonics, measured\n\n"
                  "<!-- Written by bench/rotation: do not edit. `make -C build docs-rotation` measures and writes anew. -->\n\n"
                  "- machine: %s\n- compiler: %s %s; `portable` without -march=native\n", bench_cpu_name(), BENCH_COMPILER,
            BENCH_FLAGS);
}

static void print_points(FILE *csv, FILE *page, FILE *peer_csv) {
    static rotation_point points[3][ROTATION_POINTS];
    static const char *const build[3] = { "float", "double", "portable" };
    int count[3], i, k;
    count[0] = rotation_points_float(turned, ch_basis, points[0]);
    count[1] = rotation_points_double(turned, ch_basis, points[1]);
    count[2] = rotation_points_portable(turned, ch_basis, points[2]);
    if (csv) fprintf(csv, "# machine: %s\n# compiler: %s %s\nwhat,form,build,bands,ns,error\n", bench_cpu_name(),
                     BENCH_COMPILER, BENCH_FLAGS);
    if (peer_csv) fprintf(peer_csv, "# machine: %s\n# compiler: %s %s\nwhat,form,build,bands,ns,error,ratio,own_error\n",
                          bench_cpu_name(), BENCH_COMPILER, BENCH_FLAGS);
    print_peers(peer_csv, points[0], count[0], 4);
    print_peers(peer_csv, points[1], count[1], 8);
    for (k = 0; k < 3 && csv; k++)
        for (i = 0; i < count[k]; i++)
            fprintf(csv, "%s,%s,%s,%d,%.4g,%.3g\n", points[k][i].what, points[k][i].form, build[k],
                    points[k][i].bands, points[k][i].ns, points[k][i].error);
    if (!page) return;
    fprintf(page, "\n## Error against time\n\nLargest error of a coefficient against long double, for input as it was rounded, and the least time of "
                  "15 runs, for one vector or direction; many are 1024 to 8 bands, 64 above. |f_i| <= 1. Each line runs through 2, 3, 4, 5, 6, 8, 10, 16 and 32 bands.\n\n"
                  "![Rotation: error against time](plots/rotation_pareto.svg)\n\n"
                  "![Cpherical harmonics: error against time](plots/ch_pareto.svg)\n\n"
                  "| | bands | float, ns | portable, ns | double, ns | float, error | double, error |\n"
                  "|---|--:|--:|--:|--:|--:|--:|\n");
    for (i = 0; i < count[0]; i++)
        fprintf(page, "| %s%s | %d | %.4g | %.4g | %.4g | %.1e | %.1e |\n", points[0][i].what[0] == 'c' ? "CH, " : "",
                points[0][i].form, points[0][i].bands, points[0][i].ns, points[2][i].ns, points[1][i].ns, points[0][i].error,
                points[1][i].error);
}

/* How far from where they should be 1000 turns by 2 pi/1000 about an axis leave a vector, in float. The matrix is
   rounded: its turns, worked out in double, end at `input` from the start. The rest is arithmetic: `ours` is the distance
   from that end. `floor`: exact blocks of the exact rotation, their entries rounded to float, multiplied in double. */
enum { ONE_SHOT, BLOCKS, WAYS_TO_TURN };
typedef struct turns { double total[WAYS_TO_TURN], input[WAYS_TO_TURN], ours[WAYS_TO_TURN], floor; } turns;

static double apart(const double *a, const double *b) {
    double worst = 0;
    int i;
    for (i = 0; i < TURNED; i++)
        if (!(fabs(a[i] - b[i]) <= worst)) worst = fabs(a[i] - b[i]);
    return worst;
}

static turns turns_about(double x, double y, double z, int vector) {
    double t = acos(-1.0) / 500, c = cos(t), s = sin(t), u = 2 * sin(t / 2) * sin(t / 2);
    double r[9] = { c + u * x * x, u * x * y - s * z, u * x * z + s * y, u * x * y + s * z, c + u * y * y,
                    u * y * z - s * x, u * x * z - s * y, u * y * z + s * x, c + u * z * z };
    double f[TURNED], in_float[WAYS_TO_TURN][TURNED], in_double[WAYS_TO_TURN][TURNED], rounded[WAYS_TO_TURN][TURNED];
    turns e;
    int i;
    for (i = 0; i < TURNED; i++) f[i] = (double)(float)sin(1 + i + 50 * vector);
    rotation_turns_float(r, 0, f, in_float[ONE_SHOT], in_float[BLOCKS]);
    rotation_turns_double(r, 0, f, in_double[ONE_SHOT], in_double[BLOCKS]);
    rotation_turns_double(r, 1, f, rounded[ONE_SHOT], rounded[BLOCKS]);
    for (i = 0; i < WAYS_TO_TURN; i++) {
        e.total[i] = apart(in_float[i], f);
        e.input[i] = apart(in_double[i], f);
        e.ours[i] = apart(in_float[i], in_double[i]);
    }
    e.floor = apart(rounded[BLOCKS], f);
    return e;
}

/* Sum and largest over some turns. */
static void gather(turns *sum, turns *worst, turns e) {
    double *to = (double *)sum, *most = (double *)worst, *from = (double *)&e;
    size_t i;
    for (i = 0; i < sizeof e / sizeof *from; i++) {
        to[i] += from[i];
        if (!(from[i] <= most[i])) most[i] = from[i];
    }
}

static void print_turns_row(FILE *page, const char *name, const turns *e, double over) {
    int w;
    printf("%24s", name);
    if (page) fprintf(page, "| %s", name);
    for (w = 0; w < WAYS_TO_TURN; w++) {
        printf(" %9.1e %9.1e %9.1e", e->total[w] / over, e->input[w] / over, e->ours[w] / over);
        if (page) fprintf(page, " | %.1e | %.1e | %.1e", e->total[w] / over, e->input[w] / over, e->ours[w] / over);
    }
    printf(" %9.1e\n", e->floor / over);
    if (page) fprintf(page, " | %.1e |\n", e->floor / over);
}

static void print_turns(FILE *page) {
    static const struct { const char *name; double x, y, z; } axes[] = {
        { "x", 1, 0, 0 }, { "y", 0, 1, 0 }, { "z", 0, 0, 1 }, { "(3,0,4)/5", 0.6, 0, 0.8 },
        { "(9,12,20)/25", 0.36, 0.48, 0.8 }, { "(1,1,1)", 0.57735026918962576, 0.57735026918962576, 0.57735026918962576 }
    };
    enum { AXES = 400 };
    turns sum = { { 0 }, { 0 }, { 0 }, 0 }, worst = sum;
    size_t a;
    int k;
    printf("\n1000 turns by 2 pi/1000 at 6 bands, float: distance from the start, what the matrix and the arithmetic do\n"
           "%24s %29s %29s %9s\n", "axis", "one shot", "built blocks", "floor");
    if (page) fprintf(page, "\n## A thousand turns\n\n1000 turns by 2π/1000 in float at 6 bands, one after the other, "
                            "|f_i| <= 1: largest distance from the start. *Matrix*: what the rounding of R to float does "
                            "alone, the same turns in double; one shot takes angles out of R and so forgives its lengths, "
                            "blocks use it as it is. *Arithmetic*: distance from that. *Entries in float*: exact blocks with "
                            "only their entries rounded to float, multiplied in double: the least to expect of any way that "
                            "keeps the coefficients of a turn in float.\n\nThe same error in every turn adds up. One shot takes "
                            "back in each multiple of a what the rounding of that of g did wrong; blocks cannot. Where a "
                            "chain has to be long, keep the rotation all the same and turn the first vector by it.\n\n"
                            "| axis | one shot | matrix | arithmetic | blocks | matrix | arithmetic | entries in float |\n"
                            "|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (a = 0; a < sizeof axes / sizeof *axes; a++) {
        turns none = { { 0 }, { 0 }, { 0 }, 0 }, most = none;
        for (k = 0; k < ROTATION_TRIALS; k++) gather(&none, &most, turns_about(axes[a].x, axes[a].y, axes[a].z, k));
        print_turns_row(page, axes[a].name, &most, 1);
    }
    for (k = 0; k < AXES; k++) {
        double z = 1 - 2 * (k + 0.5) / AXES, r = sqrt(1 - z * z), phi = 2.399963229728653 * k;
        gather(&sum, &worst, turns_about(r * cos(phi), r * sin(phi), z, k));
    }
    print_turns_row(page, "400 others, mean", &sum, AXES);
    print_turns_row(page, "400 others, worst", &worst, 1);
}

static void print_streams(FILE *page) {
    double native[3], portable[3];
    if (!rotation_stream_float(native) || !rotation_stream_portable(portable)) {
        fprintf(stderr, "rotation: the rates of memory are left out: they need 400 MB\n");
        return;
    }
    printf("\n4 bands, 200 MB, of memcpy's rate: native _n %.2f, _n_rgb %.2f, _soa %.2f; portable %.2f, %.2f, %.2f\n", native[0],
           native[1], native[2], portable[0], portable[1], portable[2]);
    if (page) fprintf(page, "\n## At the speed of memory\n\nBuilt blocks of 4 bands applied to 200 MB of vectors, float: the rate over that of "
                            "memcpy in the same run.\n\n| | `prt_sh_rotate_by_n` | `_n_rgb` | `_soa` |\n|---|--:|--:|--:|\n"
                            "| native | %.2f | %.2f | %.2f |\n| portable | %.2f | %.2f | %.2f |\n", native[0], native[1], native[2],
                      portable[0], portable[1], portable[2]);
}

int main(int argc, char **argv) {
    const char *csv_path = NULL, *points_path = NULL, *peers_path = NULL, *page_path = NULL;
    const command_option options[] = {
        { "--csv", "FILE", "write the error of blocks", &csv_path, NULL, 0, 0 },
        { "--points", "FILE", "write errors and times", &points_path, NULL, 0, 0 },
        { "--peers", "FILE", "keep errors and times of peers, if any are plugged in (peer.h), for the page", &peers_path,
          NULL, 0, 0 },
        { "-o", "FILE", "write the page", &page_path, NULL, 0, 0 }
    };
    const command line = { "rotation", NULL, NULL, options, 4 };
    FILE *csv, *points, *peer_csv, *page;
    int failed;
    command_read(&line, argc, argv);
    csv = command_open(&line, csv_path);
    points = command_open(&line, points_path);
    peer_csv = peer_count ? command_open(&line, peers_path) : NULL;
    page = command_open(&line, page_path);
    if (page) page_head(page);
    if (!print_blocks(csv)) {
        fprintf(stderr, "rotation: out of memory: 128 bands need 70 MB\n");
        return 1;
    }
    print_turns(page);
    print_streams(page);
    if (points || page || peer_count) print_points(points, page, peer_csv);
    failed = command_close(&line, peer_csv);
    page_peers(page, peers_path);
    return failed | command_close(&line, csv) | command_close(&line, points) | command_close(&line, page);
}
