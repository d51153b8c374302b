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

/* Embree leaves the normal of an instance's hit in the instance's own frame. */
static void turn_to_world(RTCGeometry instance, float n[3]) {
    float m[12], own[3];
    int k;
    rtcGetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, m);
    memcpy(own, n, sizeof own);
    for (k = 0; k < 3; k++) n[k] = m[k] * own[0] + m[3 + k] * own[1] + m[6 + k] * own[2];
}

static void read_hit(RTCScene scene, const struct RTCRayHit *from, prt_hit *to) {
    int instanced = from->hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
    RTCGeometry body = rtcGetGeometry(scene, instanced ? from->hit.instID[0] : from->hit.geomID);
    float n[3], length, scale;
    n[0] = from->hit.Ng_x; n[1] = from->hit.Ng_y; n[2] = from->hit.Ng_z;
    if (instanced) turn_to_world(body, n);
    length = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    scale = length > 0 ? 1 / length : 0;
    to->t = from->ray.tfar;
    to->object = (int)(uintptr_t)rtcGetGeometryUserData(body);
    to->primitive = (int)from->hit.primID;
    to->u = from->hit.u;
    to->v = from->hit.v;
    to->normal.x = scale * n[0];
    to->normal.y = scale * n[1];
    to->normal.z = scale * n[2];
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

static int make_scene(embree_tracer *t, why *w) {
    t->scene = rtcNewScene(device_of(t));
    rtcSetSceneFlags(scene_of(t), RTC_SCENE_FLAG_ROBUST);  /* no ray slips through between two triangles */
    t->tracer.user = t;
    t->tracer.occluded = occluded;
    t->tracer.closest = closest;
    return embree_failed(t, "making a scene", w);
}

int embree_tracer_create(embree_tracer *t, why *w) {
    memset(t, 0, sizeof *t);
    t->device = rtcNewDevice(NULL);
    if (!t->device) return embree_failed(t, "starting", w) ? -1 : why_set(w, "Embree cannot be started");
    return make_scene(t, w);
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

int embree_tracer_create_beside(const embree_tracer *other, embree_tracer *t, why *w) {
    memset(t, 0, sizeof *t);
    t->device = other->device;
    rtcRetainDevice(device_of(t));
    return make_scene(t, w);
}

int embree_tracer_add_instance(embree_tracer *t, const embree_tracer *of, int object, why *w) {
    RTCGeometry instance = rtcNewGeometry(device_of(t), RTC_GEOMETRY_TYPE_INSTANCE);
    unsigned number;
    rtcSetGeometryInstancedScene(instance, scene_of(of));
    rtcSetGeometryUserData(instance, (void *)(uintptr_t)object);
    rtcCommitGeometry(instance);
    number = rtcAttachGeometry(scene_of(t), instance);
    rtcReleaseGeometry(instance);
    return embree_failed(t, "adding an instance", w) ? -1 : (int)number;
}

void embree_tracer_move(embree_tracer *t, int number, const prt_real rotation[9], prt_vec3 position) {
    RTCGeometry instance = rtcGetGeometry(scene_of(t), (unsigned)number);
    float m[12];
    int row, column;
    for (column = 0; column < 3; column++)
        for (row = 0; row < 3; row++) m[3 * column + row] = (float)rotation[3 * row + column];
    m[9] = (float)position.x; m[10] = (float)position.y; m[11] = (float)position.z;
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, m);
    rtcCommitGeometry(instance);
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
