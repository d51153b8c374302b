/* stage: rigid bodies that move and turn over a ground plane, what a camera sees of them, and the irradiance that
   arrives there: ray-traced truth for what prt_fiv_shade and prt_fiv_self compute. */
#ifndef EXAMPLES_STAGE_H
#define EXAMPLES_STAGE_H

#include <signal.h>

#include "camera.h"
#include "cube_light.h"
#include "embree_tracer.h"

/* A mesh scaled to a bounding sphere of this radius about the origin, with a tracer of its own to bake from. */
typedef struct shape { char name[32]; mesh mesh; embree_tracer tracer; prt_real radius; } shape;

/* A .3ds file is taken as z-down, as glmark2's are, others as y-up. beside: a shape of the same stage, loaded earlier,
   or NULL. */
int  shape_load(const char *path, prt_real radius, const shape *beside, shape *s, why *w);
/* The same shape turned about its centre for good. */
int  shape_turned(const shape *from, const prt_real rotation[9], shape *s, why *w);
void shape_free(shape *s);

typedef struct body {
    const shape *shape;
    prt_vec3    position;              /* of the centre of its bounding sphere */
    prt_real    rotation[9];           /* row-major, from its own frame to the world */
    prt_rgb     albedo;
} body;

typedef struct stage {
    int           body_count;
    body          *bodies;             /* the caller's: after changing them call stage_move */
    prt_real      ground;              /* height of the ground, a disc about the z axis with normal +z */
    prt_real      ground_radius;
    prt_rgb       ground_albedo;
    embree_tracer tracer;
    int           first_instance;
} stage;

/* ground..., bodies and body_count are set; the rest is made. */
int  stage_create(stage *s, why *w);
int  stage_move(stage *s, why *w);
void stage_free(stage *s);

/* Receivers: one a sample of a picture. body: which body the point lies on, or one of these. Points inside a body
   receive nothing and are left out of figures. */
enum { STAGE_GROUND = -1, STAGE_SKY = -2, STAGE_INSIDE = -3 };
typedef struct receivers {
    int       width, height;
    prt_point *points;
    int       *body;
    prt_vec3  *view;                   /* unit, away from the eye */
} receivers;

int  receivers_create(int width, int height, receivers *r, why *w);
void receivers_free(receivers *r);
/* What the camera sees. */
int  receivers_look(const stage *s, const camera *eye, receivers *r);
/* Places on the ground, evenly over the square from -half_side to half_side about the origin. */
int  receivers_on_ground(const stage *s, double half_side, receivers *r);

/* Irradiance of receivers by ray tracing: open sky (cube_light_irradiance) minus what is found blocked.
   rays 0: one ray towards each light of the list, the irradiance under just these lights, without noise;
   rays N: N lights drawn at random, twice, independently: halves[0] and halves[1]. Where halves[1] is NULL, once.
   Pictures are created by the caller; alpha becomes 1 on surfaces, else 0. */
typedef struct truth {
    const stage      *stage;
    const cube_light *light;
    const receivers  *receivers;
    int              rays, threads;
    uint64_t         seed;
    const char       *what;            /* of the progress line; NULL: silent */
    volatile sig_atomic_t *stop;
    picture          *halves[2];
} truth;

/* 0, or -1 with the reason in w ("interrupted" where it was stopped). */
int  truth_trace(const truth *t, why *w);

/* Irradiance to what the camera sees: times albedo over pi on surfaces, the light itself where the sky is seen. */
void stage_expose(const stage *s, const receivers *r, const cube_light *sky, picture *p);

/* Root mean square of a - b over the samples that both show, all colours; unbiased by the noise of b's two halves (b1
   may be b0). open not NULL: only over samples that lack more than 1 % of it. */
double picture_rms(const picture *a, const picture *b0, const picture *b1, const picture *open);

/* Largest minus smallest value of a colour on surfaces, of the colour where that is most. */
double picture_range(const picture *p);

/* Signed difference a - b, from + 1/gain (white) to - 1/gain (black) of `range`; none is mid-grey. per_pixel x
   per_pixel samples a pixel; black where nothing is seen. */
void canvas_put_difference(canvas *c, int x, int y, const picture *a, const picture *b, int per_pixel, double range,
                           double gain);

#endif
