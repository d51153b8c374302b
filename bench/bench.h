/* bench.h - what the benchmark's parts share: the data that candidates work on, a row of the candidate table, and the
   engine that runs them in turns. peer.h tells how to add a library of your own from outside of the tree. */
#ifndef BENCH_H
#define BENCH_H

#include <stddef.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { BENCH_DIRECTIONS = 1024, BENCH_IMAGE_WIDTH = 256, BENCH_IMAGE_HEIGHT = 128, BENCH_CUBE_SIZE = 64 };

/* The input of every candidate and room for its output; one for each precision, and the same for all candidates of that
   precision, peers included. `real` is float or double. Every pointer is aligned to 64 bytes. */
typedef struct bench_data {
    const void *directions;   /* real[BENCH_DIRECTIONS][3]: unit vectors x, y, z */
    const void *x, *y, *z;    /* the same directions, real[BENCH_DIRECTIONS] each */
    const void *f, *g;        /* coefficients, 3 x 64 x 64 reals each: random, band l scaled by 1/(1+l) */
    const void *rows;         /* as many reals as `out` holds: rows of coefficients, for batches that read them */
    const void *rotation;     /* real[9], row-major, v' = R v: the turn of the jobs "rotate", "rotate_by" and others */
    const float *image;       /* equirectangular, [BENCH_IMAGE_HEIGHT][BENCH_IMAGE_WIDTH][3] */
    const float *const *cube; /* six faces, [BENCH_CUBE_SIZE][BENCH_CUBE_SIZE][3] each */
    void *out;                /* out_bytes of room */
    size_t out_bytes;
} bench_data;

/* One row of the table. A pass does `items` items of work; `run` does so many passes. Counts are for one item. */
typedef struct bench_candidate {
    const char *job;          /* what is computed: rows of the same job, bands and precision stand side by side */
    const char *name;         /* who computes it, and how */
    const char *build;        /* how it was compiled: "native", "native plain", ... */
    int real_bytes;           /* 4 or 8: the precision of the data that it works on */
    const char *bands;        /* bands to run at: "5", "1-10,16,32"; "0" where bands do not matter */
    int whole;                /* 0: the items of a pass are written to the same place; 1: one after the other */
    int (*items)(int bands);
    void (*run)(const bench_data *data, int bands, int items, long passes);
    double (*flops)(int bands);          /* floating-point operations, a multiply-add counted as two; 0: not counted */
    double (*bytes_read)(int bands);
    double (*bytes_written)(int bands);
    int peer;                 /* 1: plugged in from outside of the tree */
} bench_candidate;

/* A row that somebody plugs in, see peer.h: it takes part in a job of the table. */
typedef struct bench_peer {
    const char *job, *name;
    int real_bytes;
    const char *bands;
    void (*run)(const bench_data *data, int bands, int items, long passes);
} bench_peer;

/* What the engine measured for one candidate at one number of bands. Times are for one item. */
typedef struct bench_row {
    const bench_candidate *candidate;
    int bands, items;
    double ns, ns_min, spread;           /* median, minimum, and half the interquartile range over the median */
    double cycles;                       /* median ns x the clock that was measured between the rounds */
    double flops, bytes_read, bytes_written;
    double of_write, of_copy, of_flops;  /* time over that of a plain write, a copy, and the peak rate; 0: no ceiling */
} bench_row;

typedef struct bench_options {
    const char *filter;                  /* NULL, or words that job, name, build, precision and bands must contain */
    int rounds;                          /* timed rounds of each candidate */
    double slice_ns;                     /* least time of one timed run */
} bench_options;

/* Adds `count` candidates, which must outlive the run. */
void bench_add(const bench_candidate *candidates, int count);
/* Adds peers; may be called before the candidates are added. They are compared with rows of the build "native". */
void bench_add_peers(const bench_peer *peers, int count);

/* Runs everything that passes the filter and hands over each group of rows (one job, number of bands and precision) as
   soon as it is measured. An interrupt (Ctrl-C) ends it after the group in work. Returns the number of groups, or -1
   without memory. */
int bench_run(const bench_options *options, void (*group)(void *user, const bench_row *rows, int count), void *user);

double bench_clock_ghz(void);            /* median of all clock measurements so far; 0 before the first */
const char *bench_cpu_name(void);        /* the processor's model */
double bench_seconds(void);              /* monotonic clock */
int bench_has_band(const char *list, int bands);       /* whether a list such as "1-10,16,32" names it */

/* Keeps the compiler from dropping or merging work whose result stands behind p. */
#define BENCH_KEEP(p) __asm__ volatile("" : : "r"(p) : "memory")

#ifdef __cplusplus
}
#endif
#endif
