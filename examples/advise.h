/* advise: what the parts of the program share. */
#ifndef EXAMPLES_ADVISE_H
#define EXAMPLES_ADVISE_H

#include "embree_tracer.h"
#include "environment.h"
#include "mesh.h"
#include "program.h"

enum { MOST_ERRORS = 8, MOST_BANDS = 16, LIGHT_BANDS = 20, MOST_TRIALS = 4096, HALVES = 2, MOST_LIGHTS = 64 };

typedef struct options {
    const char *mesh, *environment, *moving, *plot, *csv;
    double     errors[MOST_ERRORS];
    int        error_count, check, rays, threads, lights, floor, z_up, by_time, all, rows, help;
    uint64_t   seed;
} options;

typedef enum method {
    METHOD_NORMAL,                     /* no visibility: irradiance of the normal */
    METHOD_AO,                         /* that times ambient occlusion */
    METHOD_SH,                         /* transfer vectors */
    METHOD_VO,                         /* vector occluders, of point lights */
    METHOD_FIV,                        /* transfer vectors, and irradiance vectors of a moving occluder */
    METHOD_COUNT
} method;
extern const char *const method_names[METHOD_COUNT];

/* How a number is stored: as it is, or as prt_transfer_pack does. */
typedef enum stored { STORED_NOTHING, STORED_FLOAT, STORED_HALF, STORED_16, STORED_8, STORED_COUNT } stored;
extern const char *const stored_names[STORED_COUNT];
extern const int stored_bits[STORED_COUNT];

/* A set-up that was tried. Errors are relative to the mean of the truth over the checked vertices and colours. */
typedef struct trial {
    method     method;
    int        bands, rays;            /* rays a vertex in the bake; 0: none */
    prt_window window;                 /* of the light; width = bands */
    stored     stored;
    int        groups, kept, law;      /* vector occluders: groups of faces, occluders kept a vertex, prt_vo_law */
    int        grid;                   /* irradiance vectors: which table */
    stored     table;
    double     bytes, ns;              /* a vertex */
    double     kilobytes;              /* of the table */
    double     square, square_error;   /* mean square error and its standard error */
    double     predicted;              /* error foretold by >>measure, or -1 */
} trial;

/* Exit radiance at the checked vertices by ray tracing: two independent halves. */
typedef struct traced {
    int    count;
    double (*half[HALVES])[3];
    double mean;
} traced;

/* What is looked at: the scene, a choice of its vertices, and what light falls there. */
typedef struct checked {
    int        count, *vertex;
    prt_point  *points;                /* [count] */
    uint64_t   seed;
    traced     truth;
} checked;

typedef struct advisor {
    options     o;
    mesh        mesh;
    environment environment;
    embree_tracer tracer;
    prt_real    light[3 * PRT_SH_COUNT(LIGHT_BANDS)];      /* of the environment, or of the point lights */
    prt_point_light *lights;           /* [o.lights]; NULL: none */
    struct moving *moving;             /* NULL: nothing moves */
    checked     first, second;         /* vertices to choose by, and others to verify on */
    trial       trials[MOST_TRIALS];
    int         trial_count;
} advisor;

static const prt_real advise_bias = (prt_real)1e-4;

double trial_error(const trial *t);
double trial_uncertainty(const trial *t);

/* Mean square error of colours [count] against the two halves of the truth, and its standard error, relative to the
   square of the mean. */
void trial_judge(trial *t, const traced *is, const prt_rgb *colors);

/* Keeps a trial; silently drops it when there is no room left. */
void advisor_keep(advisor *a, const trial *t);

/* Chooses so many vertices at random and traces their truth. 0, or -1 and w. */
int  checked_choose(advisor *a, int count, uint64_t seed, const char *what, checked *c, why *w);
void checked_free(checked *c);

/* Every method, all its settings, into a->trials; prints what it measures. */
int  advise_scene(advisor *a, why *w);
/* The trial once more with other rays, at a->second. 0, or -1 and w. */
int  verify_elsewhere(advisor *a, trial *t, why *w);

/* Point lights: the environment cut into o.lights of them; their exit radiance without and with shadows. try_occluders
   says how many occluders a vertex sees, under any light, and under point lights tries vector occluders. */
int  lights_create(advisor *a, why *w);
void lights_shade(const advisor *a, int count, const prt_point *points, prt_rgb *out);
int  lights_trace(const advisor *a, const prt_point *p, double sum[3]);
int  try_occluders(advisor *a, const checked *c, why *w);
int  verify_occluders(advisor *a, trial *t, why *w);

/* A moving occluder: what it hides of rays that leave vertex k of a choice; its shadow as trials, and taken off
   colours. */
int  moving_create(advisor *a, why *w);
void moving_free(advisor *a);
int  moving_blocks(const advisor *a, int k, int count, const prt_ray *rays, unsigned char *blocked);
int  try_moving(advisor *a, const checked *c, const prt_real *const *transfer, const int *rays, int steps, why *w);
void moving_take(const advisor *a, const checked *c, const trial *t, prt_rgb *colors);
void moving_describe(const trial *t, char *text, size_t size);

/* Colours of the checked vertices by a trial, from transfer[count][LIGHT_BANDS^2]. */
int  scene_colors(const advisor *a, const checked *c, const prt_real *transfer, const trial *t, prt_rgb *colors,
                  why *w);

/* Seconds that `work` takes, the least of several goes, each long enough to be measured. */
double time_of(void (*work)(void *user), void *user);

/* Report. */
void print_trials(const advisor *a);
int  print_advice(advisor *a, why *w);
int  write_csv(const advisor *a, why *w);
int  draw_plot(const advisor *a, why *w);

#endif
