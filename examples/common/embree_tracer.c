#include "embree_tracer.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include <embree3/rtcore.h>

enum { BATCH = 512 };                  /* rays handed to Embree at a time: 24 KiB of RTCRay, 40 KiB of RTCRayHit */

static RTCDevice device_of(const embree_tracer *t) { return (RTCDevice)t->device; }
static RTCScene scene_of(const embree_tracer *t) { return (RTCScene)t->scene; }

static int embree_failed(const embree_tracer *t, const char *doing, why *w) {
    static const struct { enum RTCError code; const char *text; } messages[] = {
        { RTC_ERROR_INVALID_ARGUMENT, "invalid argument" }, { RTC_ERROR_INVALID_OPERATION, "invalid operation" },
        { RTC_ERROR_OUT_OF_MEMORY, "out of memory" },       { RTC_ERROR_UNSUPPORTED_CPU, "this CPU is not supported" },
        { RTC_ERROR_CANCELLED, "cancelled" }
    };
    enum RTCError code = rtcGetDeviceError(device_of(t));
    size_t i;
    if (code == RTC_ERROR_NONE) return 0;
    for (i = 0; i < sizeof messages / sizeof *messages; i++)
        if (messages[i].code == code) return why_set(w, "Embree, %s: %s", doing, messages[i].text);
    return why_set(w, "Embree, %s: unknown error", doing);
}

/* Debian's Embree is built with assertions: a ray with a NaN, or beyond its range of about 1.8e18, ends the process. */
static int in_range(prt_real v) { return v > (prt_real)-1e18 && v < (prt_real)1e18; }
static int traceable(const prt_ray *r) {
    return in_range(r->origin.x) && in_range(r->origin.y) && in_range(r->origin.z) &&
           in_range(r->dir.x) && in_range(r->dir.y) && in_range(r->dir.z) && r->tmin >= 0 && r->tmin <= r->tmax;
}

static void fill_ray(const prt_ray *from, unsigned id, struct RTCRay *to) {
    to->org_x = (float)from->origin.x;
    to->org_y = (float)from->origin.y;
    to->org_z = (float)from->origin.z;
    to->dir_x = (float)from->dir.x;
    to->dir_y = (float)from->dir.y;
    to->dir_z = (float)from->dir.z;
    to->tnear = (float)from->tmin;
    to->tfar = (float)from->tmax;
    to->time = 0;
    to->mask = UINT_MAX;
    to->id = id;
    to->flags = 0;
}

/* Random directions from one point: the incoherent flag is twice as fast as the coherent one here. */
static void start(struct RTCIntersectContext *context) {
    rtcInitIntersectContext(context);
    context->flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
}

static int occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    const embree_tracer *t = (const embree_tracer *)user;
    struct RTCIntersectContext context;
    struct RTCRay batch[BATCH];
    int done = 0;
    start(&context);
    while (done < count) {
        unsigned filled = 0, k;
        int first = done;
        for (; done < count && filled < BATCH; done++) {
            blocked[done] = 0;
            if (traceable(rays + done)) fill_ray(rays + done, (unsigned)(done - first), batch + filled++);
        }
        if (filled) rtcOccluded1M(scene_of(t), &context, batch, filled, sizeof *batch);
        for (k = 0; k < filled; k++) blocked[first + (int)batch[k].id] = batch[k].tfar < 0;      /* -infinity: a hit */
    }
    return 0;
}

static void read_hit(RTCScene scene, const struct RTCRayHit *from, prt_hit *to) {
    float length = sqrtf(from->hit.Ng_x * from->hit.Ng_x + from->hit.Ng_y * from->hit.Ng_y +
                         from->hit.Ng_z * from->hit.Ng_z);
    float scale = length > 0 ? 1 / length : 0;
    to->t = from->ray.tfar;
    to->object = (int)(uintptr_t)rtcGetGeometryUserData(rtcGetGeometry(scene, from->hit.geomID));
    to->primitive = (int)from->hit.primID;
    to->u = from->hit.u;
    to->v = from->hit.v;
    to->normal.x = scale * from->hit.Ng_x;
    to->normal.y = scale * from->hit.Ng_y;
    to->normal.z = scale * from->hit.Ng_z;
}

static int closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    const embree_tracer *t = (const embree_tracer *)user;
    struct RTCIntersectContext context;
    struct RTCRayHit batch[BATCH];
    int done = 0;
    start(&context);
    while (done < count) {
        unsigned filled = 0, k;
        int first = done;
        for (; done < count && filled < BATCH; done++) {
            memset(hits + done, 0, sizeof *hits);
            hits[done].t = rays[done].tmax;
            hits[done].object = -1;
            if (!traceable(rays + done)) continue;
            fill_ray(rays + done, (unsigned)(done - first), &batch[filled].ray);
            batch[filled].hit.geomID = batch[filled].hit.primID = batch[filled].hit.instID[0] =
                RTC_INVALID_GEOMETRY_ID;
            filled++;
        }
        if (filled) rtcIntersect1M(scene_of(t), &context, batch, filled, sizeof *batch);
        for (k = 0; k < filled; k++)
            if (batch[k].hit.geomID != RTC_INVALID_GEOMETRY_ID)
                read_hit(scene_of(t), batch + k, hits + first + (int)batch[k].ray.id);
    }
    return 0;
}

int embree_tracer_create(embree_tracer *t, why *w) {
    memset(t, 0, sizeof *t);
    t->device = rtcNewDevice(NULL);
    if (!t->device) return embree_failed(t, "starting", w) ? -1 : why_set(w, "Embree cannot be started");
    t->scene = rtcNewScene(device_of(t));
    rtcSetSceneFlags(scene_of(t), RTC_SCENE_FLAG_ROBUST);  /* no ray slips through between two triangles */
    t->tracer.user = t;
    t->tracer.occluded = occluded;
    t->tracer.closest = closest;
    return embree_failed(t, "making a scene", w);
}

static void copy_buffers(const mesh *m, float *positions, uint32_t *triangles) {
    int i;
    for (i = 0; i < m->point_count; i++) {
        positions[3 * (size_t)i] = (float)m->points[i].position.x;
        positions[3 * (size_t)i + 1] = (float)m->points[i].position.y;
        positions[3 * (size_t)i + 2] = (float)m->points[i].position.z;
    }
    memcpy(triangles, m->triangles, 3 * (size_t)m->triangle_count * sizeof *triangles);
}

int embree_tracer_add(embree_tracer *t, const mesh *m, int object, why *w) {
    RTCGeometry geometry = rtcNewGeometry(device_of(t), RTC_GEOMETRY_TYPE_TRIANGLE);
    float *positions = (float *)rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                        3 * sizeof(float), (size_t)m->point_count);
    uint32_t *triangles = (uint32_t *)rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                              3 * sizeof(uint32_t), (size_t)m->triangle_count);
    if (positions && triangles) {
        copy_buffers(m, positions, triangles);
        rtcSetGeometryUserData(geometry, (void *)(uintptr_t)object);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_of(t), geometry);
    }
    rtcReleaseGeometry(geometry);
    return embree_failed(t, "adding a mesh", w);
}

int embree_tracer_build(embree_tracer *t, why *w) {
    rtcCommitScene(scene_of(t));
    return embree_failed(t, "building its tree", w);
}

void embree_tracer_destroy(embree_tracer *t) {
    if (t->scene) rtcReleaseScene(scene_of(t));
    if (t->device) rtcReleaseDevice(device_of(t));
    memset(t, 0, sizeof *t);
}
