/* reference: the same pictures without precomputation. Direct light on white diffuse surfaces by Monte Carlo ray
   tracing, and beside it, from the same rays, pictures whose every sample has transfer of its own: what so many bands
   can do. */
#ifndef EXAMPLES_REFERENCE_H
#define EXAMPLES_REFERENCE_H

#include <signal.h>

#include "camera.h"
#include "environment.h"
#include "image.h"
#include "mesh.h"

enum {
    REFERENCE_LIGHTS = 3, REFERENCE_BAND_COUNTS = 3, REFERENCE_HALVES = 2,
    REFERENCE_BANDS = ENVIRONMENT_BANDS, REFERENCE_COEFFICIENTS = REFERENCE_BANDS * REFERENCE_BANDS,
    REFERENCE_COSINE_RAYS = 512,       /* a sample and half, shared by the environments */
    REFERENCE_LIGHT_RAYS = 256         /* the same, towards the light of each environment */
};

static const int reference_bands[REFERENCE_BAND_COUNTS] = { 3, 5, 8 };

/* One of two independent halves; their mean is the picture, their difference tells its noise. alpha of a reference
   sample is 0 on the background, 1 on the first `object_triangles` of the scene, 0.5 on the rest. */
typedef struct reference_half {
    picture reference[REFERENCE_LIGHTS], floor[REFERENCE_LIGHTS][REFERENCE_BAND_COUNTS];
} reference_half;

typedef struct reference {
    const mesh            *scene;
    int                   object_triangles;
    const prt_tracer      *tracer;
    const environment     *environments;                   /* [REFERENCE_LIGHTS] */
    camera                eye;
    prt_real              bias;        /* of shadow rays along the shading normal, as in a bake */
    int                   width, height, threads;          /* width and height count samples */
    const char            *what;       /* what the progress line calls it; NULL: silent */
    volatile sig_atomic_t *stop;       /* becomes nonzero: give up */
    reference_half        halves[REFERENCE_HALVES];
} reference;

/* Traces everything; everything above `halves` is the caller's to set. 0, or -1 with the reason in w. */
int  reference_trace(reference *r, why *w);
void reference_free(reference *r);

/* The root of the mean of (a0-b0)(a1-b1) over the pixels (per_pixel x per_pixel samples) that all four cover whole, in
   b0 with alpha of at least `least`; divided by the mean of b0 and b1 there. Colours count alike, negative radiance as
   0. Independent noise in the two factors leaves the mean alone. */
double reference_error(const picture *a0, const picture *a1, const picture *b0, const picture *b1, int per_pixel,
                       float least);

/* The standard error, from the noise of the rays, of the difference between two squared errors as reference_error gives
   them: that of picture p and that of the floor of `bands` (an index into reference_bands), both against the reference
   under one light. With independent noise in the halves, the square of (P-R0)^2/2 - (P-R1)^2/2 has at each pixel the
   mean of the variance of (P-R0)(P-R1), and likewise the floor; the two are correlated, so they are taken together. */
double reference_uncertainty(const reference *r, int light, int bands, const picture *p, int per_pixel, float least);

#endif
