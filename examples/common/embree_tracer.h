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

/* Instances: a tracer made with create_beside holds built tracers of the same device as rigid bodies that can be moved;
   what they share is stored once. Hits then report the instance's object id, a normal in the world, and the triangle. */
int  embree_tracer_create_beside(const embree_tracer *device_of, embree_tracer *t, why *w);
/* Returns the number by which the instance is moved, or -1. */
int  embree_tracer_add_instance(embree_tracer *t, const embree_tracer *of, int object, why *w);
/* rotation is row-major; call embree_tracer_build when all have moved. */
void embree_tracer_move(embree_tracer *t, int instance, const prt_real rotation[9], prt_vec3 position);
void embree_tracer_destroy(embree_tracer *t);

#endif
