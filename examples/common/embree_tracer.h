/* embree_tracer: Intel Embree as the ray callback of prt_bake.h. One device holds any number of meshes, each with an
   object id of the caller's choice; after embree_tracer_build any number of threads may trace. */
#ifndef EXAMPLES_EMBREE_TRACER_H
#define EXAMPLES_EMBREE_TRACER_H

#include "mesh.h"

typedef struct embree_tracer {
    void       *device, *scene;        /* RTCDevice, RTCScene */
    prt_tracer tracer;                 /* hand &tracer to a bake; it points back to this struct, which must stay */
} embree_tracer;

int  embree_tracer_create(embree_tracer *t, why *w);
/* Copies positions and triangles. Hits report this object id (0 ... 2^31-2) and the triangle's number as primitive. */
int  embree_tracer_add(embree_tracer *t, const mesh *m, int object, why *w);
int  embree_tracer_build(embree_tracer *t, why *w);
void embree_tracer_destroy(embree_tracer *t);

#endif
