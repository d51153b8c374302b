/* refined_bake: a bake of diffuse transfer that puts points where transfer bends.

   Every edge of the mesh is cut once, and transfer baked at its middle. Where it differs there from the mean of the
   edge's ends, which is what drawing would interpolate, the edges around that middle are cut again, and so on: contact
   shadows and creases get dense points, the rest of the surface stays as it is. No ray is wasted, since every middle
   that was baked for the comparison is a vertex of the result. */
#ifndef EXAMPLES_REFINED_BAKE_H
#define EXAMPLES_REFINED_BAKE_H

#include "bake_job.h"
#include "mesh.h"

typedef struct refined_bake {
    bake_job job;                      /* desc, threads, what and stop are the caller's to set; the rest is made here */
    mesh     *m;                       /* becomes finer */
    int      levels;                   /* an edge is cut into at most 2^levels */
    double   tolerance;                /* of the difference, see refined_bake_difference */
} refined_bake;

/* Bakes; the rows stand in job.transfer[m->point_count][bands^2], the caller's to free (also after a failure).
   0, or -1 with the reason in w. */
int refined_bake_run(refined_bake *r, why *w);

/* How far transfer in the middle of an edge is from the mean of its ends: the root of the sum of squared differences of
   the coefficients, those of band l divided by l + 1, since so the light of natural environments falls. */
double refined_bake_difference(int bands, const prt_real *middle, const prt_real *a, const prt_real *b);

#endif
