#include "bounce_job.h"

#include <string.h>

#include "parallel.h"

static int bounce_range(void *user, void *own, int first, int count) {
    const bounce_job *job = (const bounce_job *)user;
    (void)own;
    return prt_bake_bounce(&job->desc, job->point_count, job->points, job->previous, first, count, job->out) != PRT_OK;
}

int bounce_job_run(const bounce_job *job, why *w) {
    bounce_job own = *job;
    parallel loop;
    prt_result result;
    own.desc.progress = NULL;
    result = prt_bake_bounce(&own.desc, own.point_count, own.points, own.previous, 0, 0, own.out);
    if (result != PRT_OK) return why_set(w, "interreflection: %s", prt_result_string(result));
    memset(&loop, 0, sizeof loop);
    loop.count = own.point_count;
    loop.chunk = 64;
    loop.threads = own.threads;
    loop.what = own.what;
    loop.unit = "rays";
    loop.unit_per_item = own.desc.samples;
    loop.stop = own.stop;
    loop.work = bounce_range;
    loop.user = &own;
    return parallel_all(&loop, w);
}

prt_bounce_object bounce_object_of(const mesh *m, prt_rgb albedo) {
    prt_bounce_object object;
    memset(&object, 0, sizeof object);
    object.triangle_count = m->triangle_count;
    object.triangles = m->triangles;
    object.albedo = albedo;
    return object;
}

void bounce_objects_of(const scene *s, prt_bounce_object *objects) {
    int k;
    for (k = 0; k < s->part_count; k++) {
        objects[k] = bounce_object_of(&s->mesh, s->parts[k].material.diffuse);
        objects[k].triangles += 3 * (size_t)s->parts[k].first_triangle;
        objects[k].triangle_count = s->parts[k].triangle_count;
    }
}
