/* shadow_laws: how far the shadows of vector occluders are from the truth, by law and parameter. */
#ifndef EXAMPLES_SHADOW_LAWS_H
#define EXAMPLES_SHADOW_LAWS_H

#include "techniques.h"

typedef struct shadow_law { const char *name; prt_vo_params params; } shadow_law;

/* Over the vertices of a scene and directions spread by cosine about their normals: each direction is the middle of a
   round light of some angular radius, so far away. The truth is the share of the light that no surface hides (one ray
   for a light without extent); a law gives the product of its factors. */
typedef struct shadow_truth {
    int           directions, rays;    /* a vertex; rays towards each light, 1 for a point */
    double        angle, reach;        /* radius of the light, radians; how far it is, 0: very */
    prt_vec3      *dirs;               /* [points][directions] */
    float         *share;              /* [points][directions] */
} shadow_truth;

typedef struct shadow_error { double rms, bias; } shadow_error;    /* bias: mean factor less mean truth */

int  shadow_truth_trace(const techniques *t, int directions, double angle, double reach, shadow_truth *to, why *w);
void shadow_truth_free(shadow_truth *t);

/* A law against it; NULL: nothing hides anything. */
shadow_error shadow_law_error(const techniques *t, const shadow_truth *truth, const prt_vo_params *law);

/* Ambient occlusion in the place of shadows. */
shadow_error shadow_ao_error(const techniques *t, const shadow_truth *truth);

/* What a law makes of one round cap straight above, of form factor sin^2(cap), for a light `apart` from its middle;
   and the truth, the share of the round light of radius `angle` outside the cap (0: a point). Radians. */
double shadow_law_of_cap(const prt_vo_params *law, double cap, double apart);
double shadow_truth_of_cap(double cap, double angle, double apart);

#endif
