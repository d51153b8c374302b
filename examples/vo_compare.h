/* vo_compare: what the files of the program share. */
#ifndef EXAMPLES_VO_COMPARE_H
#define EXAMPLES_VO_COMPARE_H

#include <signal.h>

#include "contact_sheet.h"
#include "path_reference.h"
#include "shadow_laws.h"
#include "techniques.h"
#include "vo_compare_limit.h"

enum { SAMPLES_A_PIXEL = 2, MOST_LIGHTS = 32, SETS = 6, RUNS = 5 };
static const int light_counts[SETS] = { 1, 2, 4, 8, 16, 32 };

typedef struct options {
    const char *out, *keep, *mesh, *up, *environment;
    int        rays, size, paths, directions, threads;
    double     fineness;
} options;

/* Lights in groups: set k of the lights around the scene is groups 0 ... k, at 1/light_counts[k] of their colour. */
typedef struct rig {
    const char      *name;
    int             light_count, group_count, group[MOST_LIGHTS];
    prt_point_light lights[MOST_LIGHTS];
} rig;

enum { AROUND, SKY, RIGS };

/* What a scene looks like without approximation: at the samples of the view, and at the vertices. */
typedef struct truth { const rig *lights; prt_rgb *pixels[PATH_HALVES], *vertices[PATH_HALVES]; } truth;

typedef struct score { double rmse, ssim; } score;

typedef struct stage {                 /* one scene with everything about it */
    const char    *name;
    scene         shining, matte;      /* the same mesh */
    embree_tracer tracer;
    techniques    baked;
    view          seen;
    path_query    *pixel_queries, *vertex_queries;
    rig           rigs[RIGS];
    truth         truths[2][RIGS];     /* [matte][rig] */
    score         scores[2][RIGS][TECHNIQUE_COUNT][SETS], at_vertices[2][RIGS][SETS];
    double        noise[2][RIGS][SETS];
    double        seconds[TECHNIQUE_COUNT][SETS];          /* of shading all vertices, shining, lights around */
} stage;

enum { LIGHT_CASES = 8, STRENGTHS = 8, CAPS = 6, LAWS = 4, SKY_COUNTS = 8, SKY_TRUTH = PATH_LIGHTS };
/* Lights that laws are judged by: radius in degrees; distance in radii of the scene, 0: far away. */
static const struct { double size, reach; } light_cases[LIGHT_CASES] = {
    { 0, 0 }, { 5, 0 }, { 15, 0 }, { 30, 0 }, { 0, 2 }, { 0, 1 }, { 0, 0.5 }, { 0, 0.25 }
};
static const double strengths[STRENGTHS] = { 0.5, 1, 1.5, 2, 3, 4, 5.5, 8 },
                    cap_angles[CAPS] = { 1, 5, 10, 20, 30, 45 };
static const int sky_counts[SKY_COUNTS] = { 1, 2, 4, 8, 16, 32, 64, SKY_TRUTH };

typedef struct law_study {
    shadow_error none[LIGHT_CASES], ao[LIGHT_CASES], sine[STRENGTHS][LIGHT_CASES], cap[CAPS][LIGHT_CASES];
} law_study;

enum { SPLITS = 6 };
static const int split_counts[SPLITS] = { 6, 12, 24, 48, 96, 192 };
typedef struct split_study {
    shadow_error sine, strong, cap, wide;                  /* N = 1.5 and 4; lights of 5 and 20 degrees */
    int          occluders;            /* of the scene */
    double       seen, bake_seconds, seconds;              /* seen: a vertex, mean; seconds: VO/DD, cap law, 8 lights */
} split_study;

/* Pictures by the laws, of scenes and lights that are traced anyway: N = 1.5 and 4, then cap_angles. */
enum { PICTURED = 5, PICTURE_LAWS = 2 + CAPS };

/* The strongest `keep` occluders of a vertex alone: of the shapes, one for each part, and cut into COUNTED. */
enum { KEEPS = 7, CUTS = 2, COUNTED = 48 };
static const int keeps[CUTS][KEEPS] = { { 0, 1, 2, 3, 4, 5, 6 }, { 1, 2, 4, 8, 12, 20, COUNTED } };
typedef struct keep_study {
    double       seen, seconds;        /* seen: a vertex, mean; seconds: VO/DD, cap law, 8 lights */
    shadow_error sine, cap;            /* shadow factors, point light: N = 1.5; light of 5 degrees */
    score        by_sine, by_cap;      /* pictures, 8 lights */
} keep_study;

/* What leaving out saves, under 8 lights. */
enum { SAVINGS = 6 };
typedef struct saving {
    double bake_seconds, seconds, differs;                 /* pass 2; shading; from everything, relative */
    double bytes;                      /* a vertex, in the smallest form that holds the rest */
} saving;

enum { FRAMES = 4, DRAINS = 4 };
static const double frame_times[FRAMES] = { 0, 0.4, 0.8, 1.2 }, drains[DRAINS] = { 1, 0, -1, -3 };
static const double waves_a_unit = 7, waves_sharpness = 2; /* radians of a wave in a unit of the pool; c0 in degrees */
typedef struct effect { double mean, differs; } effect;    /* radiance of a picture and change, relative to the first */

/* Shading all vertices of the shapes under 8 lights from each form, [0] with all terms, [1] VO/DD. */
enum { FORMS = 3, TERMS = 2, BUILDS = 2 };
typedef struct form_times {
    double loop;                       /* prt_vo_shade for each vertex */
    double seconds[FORMS];             /* plain, indexed, packed */
    double differs[FORMS];             /* from plain, relative */
    limit  limits[BUILDS];
} form_times;

typedef struct study {
    volatile sig_atomic_t *stop;       /* becomes nonzero: give up */
    options   o;
    split_study splits[SPLITS];
    stage     shapes, statue, ball, glass, pool;
    keep_study keeps[CUTS][KEEPS];
    saving    savings[SAVINGS];
    effect    waves[FRAMES], drained[DRAINS];
    double    bend_seconds, pool_seconds;                  /* of all vertices of the pool: bending, and shading */
    law_study laws;
    score     pictured[PICTURE_LAWS][PICTURED];
    image     sky;
    score     ball_scores[LAWS], glass_scores[LAWS];
    double    sky_errors[SKY_COUNTS];
    double    ball_noise, glass_noise;
    double    ch_differs;              /* CH with its Gram matrix against SH, relative */
    form_times forms[TERMS];
} study;

static const prt_rgb background = { (prt_real)0.03, (prt_real)0.03, (prt_real)0.035 };
static const float whole = 1;          /* alpha of what counts: surfaces that let nothing through */
static const double degree = 3.14159265358979323846 / 180;

/* vo_compare.c */

/* The lights of a set, in the colours that they have in it; returns their number. */
int  lights_of(const rig *r, int set, prt_point_light *lights);
int  sets_of(const rig *r);
/* Rays a vertex for what is not timed. */
int  few_rays(const study *d);
int  saving_rays(const study *d);

/* vo_compare_measure.c */

/* Light at the queries, to new arrays out[half]; kept in a file, and taken up from it. */
int trace_some(const study *d, const stage *s, int matte, const rig *lights, const char *where, int count,
               const path_query *queries, int samples, int photons, prt_rgb *out[PATH_HALVES], why *w);
int  paint_truth(const stage *s, const truth *t, int set, int half, picture *to, why *w);
/* The mean of both halves. */
int  paint_reference(const stage *s, int matte, int which, int set, picture *to, why *w);
/* to or seconds may be NULL. */
int  paint(stage *s, int matte, int which, int set, technique how, picture *to, double *seconds, why *w);
int  takes_part(int matte, technique how);
score compare(const picture *p, const picture r[PATH_HALVES], const picture *mean);
/* Traces the truth of a scene under a rig, and scores everything that takes part. */
int  measure(const study *d, stage *s, int matte, int which, why *w);
int  time_shading(stage *s, why *w);
void compare_ch(study *d);

/* vo_compare_forms.c */

int  time_forms(study *d, why *w);
/* Root mean square of a - b relative to that of b. */
double difference(int count, const prt_rgb *a, const prt_rgb *b);

/* vo_compare_studies.c */

prt_vo_params sine_law(double strength);
prt_vo_params cap_law(double degrees);
int  study_laws(study *d, why *w);
int  study_pictures(study *d, why *w);
int  study_ball(study *d, why *w);
int  study_glass(study *d, why *w);
int  study_splits(study *d, why *w);
/* One row of pictures, shown as bright as the first. */
int  write_row(const study *d, const char *title, const char *row, const char *file, int columns,
               const char *const *heads, picture *pictures, sheet_cell *cells, why *w);
int  study_lights(study *d, why *w);

/* vo_compare_effects.c */

int  study_waves(study *d, why *w);
int  study_drain(study *d, why *w);
int  study_savings(study *d, why *w);

/* vo_compare_page.c */

void caption(sheet_cell *cell, const score *s);
int  write_pictures(study *d, why *w);
int  write_plots(const study *d, why *w);
int  write_page(const study *d, why *w);

#endif
