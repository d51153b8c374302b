#include "stage.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "vector.h"

static const prt_real bias = (prt_real)1e-4, far_away = (prt_real)1e6;

/* ---- shapes and bodies ---- */

static void name_of(const char *path, char *name, size_t size) {
    const char *slash = strrchr(path, '/'), *start = slash ? slash + 1 : path;
    snprintf(name, size, "%.*s", (int)strcspn(start, "."), start);
}

/* z-down to z-up: half a turn about x. */
static void stand_up(mesh *m) {
    int k;
    for (k = 0; k < m->point_count; k++) {
        prt_point *p = m->points + k;
        p->position.y = -p->position.y; p->position.z = -p->position.z;
        p->normal.y = -p->normal.y;     p->normal.z = -p->normal.z;
    }
}

int shape_load(const char *path, prt_real radius, const shape *beside, shape *s, why *w) {
    size_t length = strlen(path);
    int z_down = length > 4 && strcmp(path + length - 4, ".3ds") == 0, k;
    memset(s, 0, sizeof *s);
    name_of(path, s->name, sizeof s->name);
    s->radius = radius;
    if (mesh_load(path, z_down ? MESH_Z_UP : MESH_Y_UP, &s->mesh, w) || mesh_fit_unit_sphere(&s->mesh, w)) return -1;
    if (z_down) stand_up(&s->mesh);
    for (k = 0; k < s->mesh.point_count; k++) {
        prt_vec3 *p = &s->mesh.points[k].position;
        p->x *= radius; p->y *= radius; p->z *= radius;
    }
    if (beside ? embree_tracer_create_beside(&beside->tracer, &s->tracer, w) : embree_tracer_create(&s->tracer, w))
        return -1;
    return embree_tracer_add(&s->tracer, &s->mesh, 0, w) || embree_tracer_build(&s->tracer, w) ? -1 : 0;
}

int shape_turned(const shape *from, const prt_real rotation[9], shape *s, why *w) {
    const mesh *m = &from->mesh;
    size_t points = (size_t)m->point_count * sizeof *m->points;
    size_t triangles = 3 * (size_t)m->triangle_count * sizeof *m->triangles;
    int k;
    *s = *from;
    memset(&s->tracer, 0, sizeof s->tracer);
    s->mesh.points = (prt_point *)malloc(points);
    s->mesh.triangles = (uint32_t *)malloc(triangles);
    if (!s->mesh.points || !s->mesh.triangles) return why_set(w, "out of memory for another %s", from->name);
    memcpy(s->mesh.triangles, m->triangles, triangles);
    for (k = 0; k < m->point_count; k++) {
        s->mesh.points[k].position = vec_turn(rotation, m->points[k].position);
        s->mesh.points[k].normal = vec_turn(rotation, m->points[k].normal);
    }
    return embree_tracer_create_beside(&from->tracer, &s->tracer, w) || embree_tracer_add(&s->tracer, &s->mesh, 0, w) ||
           embree_tracer_build(&s->tracer, w) ? -1 : 0;
}

void shape_free(shape *s) {
    embree_tracer_destroy(&s->tracer);
    mesh_free(&s->mesh);
}

int stage_create(stage *s, why *w) {
    int k;
    if (embree_tracer_create_beside(&s->bodies[0].shape->tracer, &s->tracer, w)) return -1;
    for (k = 0; k < s->body_count; k++) {
        int number = embree_tracer_add_instance(&s->tracer, &s->bodies[k].shape->tracer, k, w);
        if (number < 0) return -1;
        if (k == 0) s->first_instance = number;
    }
    return stage_move(s, w);
}

int stage_move(stage *s, why *w) {
    int k;
    for (k = 0; k < s->body_count; k++)
        embree_tracer_move(&s->tracer, s->first_instance + k, s->bodies[k].rotation, s->bodies[k].position);
    return embree_tracer_build(&s->tracer, w);
}

void stage_free(stage *s) { embree_tracer_destroy(&s->tracer); }

/* ---- receivers ---- */

int receivers_create(int width, int height, receivers *r, why *w) {
    size_t count = (size_t)width * (size_t)height;
    r->width = width;
    r->height = height;
    r->points = (prt_point *)calloc(count, sizeof *r->points);
    r->view = (prt_vec3 *)calloc(count, sizeof *r->view);
    r->body = (int *)calloc(count, sizeof *r->body);
    return r->points && r->view && r->body ? 0 : why_set(w, "out of memory for %d x %d samples", width, height);
}

void receivers_free(receivers *r) {
    free(r->points);
    free(r->view);
    free(r->body);
    memset(r, 0, sizeof *r);
}

/* The normal that shading interpolates, in the world. */
static prt_vec3 normal_at(const body *b, const prt_hit *hit) {
    const mesh *m = &b->shape->mesh;
    const uint32_t *corner = m->triangles + 3 * (size_t)hit->primitive;
    prt_real weight[3];
    prt_vec3 n = { 0, 0, 0 };
    int k;
    weight[0] = 1 - hit->u - hit->v; weight[1] = hit->u; weight[2] = hit->v;
    for (k = 0; k < 3; k++) n = vec_add(n, weight[k], m->points[corner[k]].normal);
    return vec_unit(vec_turn(b->rotation, n), hit->normal);
}

static void set_ground(prt_point *p, int *which, prt_vec3 place) {
    p->position = place;
    p->normal = vec(0, 0, 1);
    *which = STAGE_GROUND;
}

/* The nearer of the body that was hit and the ground. */
static void resolve(const stage *s, const prt_ray *ray, const prt_hit *hit, prt_point *p, int *which) {
    prt_real t = ray->dir.z < 0 ? (s->ground - ray->origin.z) / ray->dir.z : -1;
    prt_vec3 place = vec_add(ray->origin, t, ray->dir);
    int ground = t > 0 && place.x * place.x + place.y * place.y <= s->ground_radius * s->ground_radius;
    place.z = s->ground;
    *which = STAGE_SKY;
    if (hit->object >= 0 && (!ground || hit->t < t)) {
        *which = hit->object;
        p->position = vec_add(ray->origin, hit->t, ray->dir);
        p->normal = normal_at(&s->bodies[hit->object], hit);
    } else if (ground) {
        set_ground(p, which, place);
    }
}

static int trace_view(const stage *s, receivers *r, prt_vec3 eye) {
    size_t count = (size_t)r->width * (size_t)r->height, k;
    prt_ray *rays = (prt_ray *)malloc(count * sizeof *rays);
    prt_hit *hits = (prt_hit *)malloc(count * sizeof *hits);
    int failed = !rays || !hits;
    for (k = 0; k < count && !failed; k++) {
        rays[k].origin = eye;
        rays[k].dir = r->view[k];
        rays[k].tmin = 0;
        rays[k].tmax = far_away;
    }
    if (!failed) failed = s->tracer.tracer.closest(s->tracer.tracer.user, (int)count, rays, hits);
    for (k = 0; k < count && !failed; k++) resolve(s, rays + k, hits + k, r->points + k, r->body + k);
    free(rays);
    free(hits);
    return failed ? -1 : 0;
}

int receivers_look(const stage *s, const camera *eye, receivers *r) {
    camera_frame f = camera_make_frame(eye, (double)r->width / r->height);
    int x, y, k;
    for (y = 0; y < r->height; y++) {
        for (x = 0; x < r->width; x++) {
            double across = 2 * (x + 0.5) / r->width - 1, up = 1 - 2 * (y + 0.5) / r->height, d[3];
            for (k = 0; k < 3; k++) d[k] = f.forward[k] + across * f.right[k] + up * f.up[k];
            r->view[(size_t)y * (size_t)r->width + (size_t)x] = vec_unit(vec(d[0], d[1], d[2]), vec(1, 0, 0));
        }
    }
    return trace_view(s, r, eye->eye);
}

/* A place is inside a body where the way up first meets a face from behind. */
static int mark_inside(const stage *s, receivers *r) {
    size_t count = (size_t)r->width * (size_t)r->height, k;
    prt_hit hit;
    for (k = 0; k < count; k++) {
        prt_ray up;
        up.origin = r->points[k].position;
        up.dir = r->points[k].normal;
        up.tmin = 0;
        up.tmax = far_away;
        if (s->tracer.tracer.closest(s->tracer.tracer.user, 1, &up, &hit)) return -1;
        if (hit.object >= 0 && vec_dot(hit.normal, up.dir) > 0) r->body[k] = STAGE_INSIDE;
    }
    return 0;
}

int receivers_on_ground(const stage *s, double half_side, receivers *r) {
    int x, y;
    for (y = 0; y < r->height; y++) {
        for (x = 0; x < r->width; x++) {
            size_t k = (size_t)y * (size_t)r->width + (size_t)x;
            set_ground(r->points + k, r->body + k,
                       vec(half_side * (2 * (x + 0.5) / r->width - 1), half_side * (1 - 2 * (y + 0.5) / r->height),
                           (double)s->ground));
            r->view[k] = vec(0, 0, -1);
        }
    }
    return mark_inside(s, r);
}

/* ---- truth ---- */

enum { QUEUE = 512 };

/* Rays that wait, each with the light that it would take away. */
typedef struct queue {
    const truth   *t;
    prt_point     at;
    prt_vec3      origin;
    int           own;                 /* the body that the receiver lies on */
    int           count;
    prt_ray       rays[QUEUE];
    double        cost[QUEUE][3];
    unsigned char blocked[QUEUE];
    double        lost[3], open[3];    /* open: of the normal that at had last */
} queue;

static int queue_flush(queue *q) {
    const prt_tracer *tracer = &q->t->stage->tracer.tracer;
    int k, c;
    if (q->count && tracer->occluded(tracer->user, q->count, q->rays, q->blocked)) return -1;
    for (k = 0; k < q->count; k++)
        for (c = 0; c < 3 && q->blocked[k]; c++) q->lost[c] += q->cost[k][c];
    q->count = 0;
    return 0;
}

/* Whether a ray may meet a body at all: spares Embree most of them. */
static int may_be_blocked(const queue *q, prt_vec3 dir) {
    const stage *s = q->t->stage;
    int k;
    for (k = 0; k < s->body_count; k++) {
        prt_vec3 to = vec_add(s->bodies[k].position, -1, q->origin);
        double ahead = vec_dot(to, dir), square = vec_dot(to, to), r = (double)s->bodies[k].shape->radius;
        if (k == q->own || square <= r * r || (ahead > 0 && square - ahead * ahead <= r * r)) return 1;
    }
    return 0;
}

/* Queues the ray towards light k of the list, which counts `weight` times. */
static int queue_light(queue *q, int k, prt_vec3 dir, double weight) {
    const cube_light *l = q->t->light;
    double cosine = vec_dot(dir, q->at.normal) * weight;
    prt_ray *ray = q->rays + q->count;
    if (!(cosine > 0) || !may_be_blocked(q, dir)) return 0;
    ray->origin = q->origin;
    ray->dir = dir;
    ray->tmin = 0;
    ray->tmax = far_away;
    q->cost[q->count][0] = cosine * (double)l->r[k];
    q->cost[q->count][1] = cosine * (double)l->g[k];
    q->cost[q->count][2] = cosine * (double)l->b[k];
    return ++q->count == QUEUE ? queue_flush(q) : 0;
}

static int queue_all_lights(queue *q) {
    const cube_light *l = q->t->light;
    prt_vec3 dir;
    int k;
    for (k = 0; k < l->count; k++) {
        dir.x = (prt_real)l->x[k]; dir.y = (prt_real)l->y[k]; dir.z = (prt_real)l->z[k];
        if (queue_light(q, k, dir, 1)) return -1;
    }
    return queue_flush(q);
}

static int queue_drawn_lights(queue *q, int half, size_t index) {
    enum { DRAWN = 256 };
    const truth *t = q->t;
    prt_real u[DRAWN], v[DRAWN];
    int first, k;
    for (first = 0; first < t->rays; first += DRAWN) {
        int count = t->rays - first < DRAWN ? t->rays - first : DRAWN;
        prt_sample_square(PRT_SAMPLE_SOBOL, t->rays, t->seed * 2 + (uint64_t)half, index, first, count, u, v);
        for (k = 0; k < count; k++) {
            prt_vec3 dir;
            double chance;
            int light = cube_light_draw(t->light, (double)u[k], (double)v[k], &dir, &chance);
            if (queue_light(q, light, dir, 1 / (chance * t->rays))) return -1;
        }
    }
    return queue_flush(q);
}

static int trace_receiver(queue *q, size_t index) {
    const truth *t = q->t;
    prt_vec3 last = q->at.normal;
    int half, c;
    q->at = t->receivers->points[index];
    q->own = t->receivers->body[index];
    q->origin = vec_add(q->at.position, bias, q->at.normal);
    if (memcmp(&last, &q->at.normal, sizeof last)) cube_light_irradiance(t->light, q->at.normal, q->open);
    for (half = 0; half < 2 && t->halves[half]; half++) {
        float *to = t->halves[half]->rgba + 4 * index;
        q->lost[0] = q->lost[1] = q->lost[2] = 0;
        if (t->rays ? queue_drawn_lights(q, half, index) : queue_all_lights(q)) return -1;
        for (c = 0; c < 3; c++) to[c] = (float)(q->open[c] - q->lost[c]);
        to[3] = 1;
    }
    return 0;
}

static int begin(void *user, void **own) {
    queue *q = (queue *)calloc(1, sizeof *q);
    if (q) q->t = (const truth *)user;
    *own = q;
    return !q;
}

static int trace_rows(void *user, void *own, int first, int count) {
    const truth *t = (const truth *)user;
    size_t width = (size_t)t->receivers->width, k;
    int failed = 0, half;
    for (k = (size_t)first * width; k < (size_t)(first + count) * width && !failed; k++) {
        for (half = 0; half < 2 && t->halves[half]; half++) memset(t->halves[half]->rgba + 4 * k, 0, 4 * sizeof(float));
        if (t->receivers->body[k] >= STAGE_GROUND) failed = trace_receiver((queue *)own, k);
    }
    return failed;
}

int truth_trace(const truth *t, why *w) {
    truth copy = *t;                                       /* the threads only read it */
    parallel job;
    memset(&job, 0, sizeof job);
    job.count = t->receivers->height;
    job.chunk = 1;
    job.threads = t->threads;
    job.what = t->what;
    job.unit = "samples";
    job.unit_per_item = t->receivers->width;
    job.stop = t->stop;
    job.begin = begin;
    job.work = trace_rows;
    job.end = free;
    job.user = &copy;
    if (parallel_run(&job, w)) return -1;
    return job.done < job.count ? why_set(w, "interrupted") : 0;
}

/* ---- pictures ---- */

void stage_expose(const stage *s, const receivers *r, const cube_light *sky, picture *p) {
    size_t count = (size_t)p->width * (size_t)p->height, k;
    for (k = 0; k < count; k++) {
        float *to = p->rgba + 4 * k;
        const float over_pi = 0.318309886f;
        if (r->body[k] == STAGE_SKY) {
            memcpy(to, sky->texels + 3 * cube_light_texel(sky, r->view[k]), 3 * sizeof *to);
        } else {
            const prt_rgb *albedo = r->body[k] >= 0 ? &s->bodies[r->body[k]].albedo : &s->ground_albedo;
            to[0] *= (float)albedo->r * over_pi;
            to[1] *= (float)albedo->g * over_pi;
            to[2] *= (float)albedo->b * over_pi;
        }
    }
}

/* Mean over a pixel's samples; -1 where one of b's shows no surface. */
static int mean_difference(const picture *a, const picture *b, int x, int y, int per_pixel, double mean[3]) {
    int i, j, c;
    mean[0] = mean[1] = mean[2] = 0;
    for (j = y * per_pixel; j < (y + 1) * per_pixel; j++) {
        for (i = x * per_pixel; i < (x + 1) * per_pixel; i++) {
            size_t k = 4 * ((size_t)j * (size_t)b->width + (size_t)i);
            if (!(b->rgba[k + 3] > 0)) return -1;
            for (c = 0; c < 3; c++)
                mean[c] += ((double)a->rgba[k + (size_t)c] - (double)b->rgba[k + (size_t)c]) / (per_pixel * per_pixel);
        }
    }
    return 0;
}

void canvas_put_difference(canvas *c, int x, int y, const picture *a, const picture *b, int per_pixel, double range,
                           double gain) {
    int i, j, k;
    for (j = 0; j < b->height / per_pixel; j++) {
        for (i = 0; i < b->width / per_pixel; i++) {
            unsigned char *to = c->rgb + 3 * ((size_t)(y + j) * (size_t)c->width + (size_t)(x + i));
            double mean[3];
            int seen = mean_difference(a, b, i, j, per_pixel, mean) == 0;
            for (k = 0; k < 3; k++) {
                double v = 128 + 127 * gain * mean[k] / range;
                to[k] = (unsigned char)(!seen || v < 0 ? 0 : v > 255 ? 255 : v);
            }
        }
    }
}

/* ---- figures ---- */

static int in_shadow(const float *b, const float *open) {
    int c;
    for (c = 0; c < 3; c++) if (b[c] < 0.99f * open[c]) return 1;
    return 0;
}

double picture_rms(const picture *a, const picture *b0, const picture *b1, const picture *open) {
    size_t end = 4 * (size_t)a->width * (size_t)a->height, k;
    double sum = 0, count = 0;
    int c;
    for (k = 0; k < end; k += 4) {
        if (!(b0->rgba[k + 3] > 0) || !(a->rgba[k + 3] > 0)) continue;
        if (open && !in_shadow(b0->rgba + k, open->rgba + k)) continue;
        for (c = 0; c < 3; c++) {
            double to = (double)a->rgba[k + (size_t)c];
            sum += (to - (double)b0->rgba[k + (size_t)c]) * (to - (double)b1->rgba[k + (size_t)c]);
        }
        count += 3;
    }
    return count > 0 && sum > 0 ? sqrt(sum / count) : 0;
}

double picture_range(const picture *p) {
    size_t end = 4 * (size_t)p->width * (size_t)p->height, k;
    double range = 0;
    int c;
    for (c = 0; c < 3; c++) {
        double low = 1e300, high = -1e300;
        for (k = 0; k < end; k += 4) {
            double v = (double)p->rgba[k + (size_t)c];
            if (!(p->rgba[k + 3] > 0)) continue;
            if (v < low) low = v;
            if (v > high) high = v;
        }
        if (high - low > range) range = high - low;
    }
    return range;
}
