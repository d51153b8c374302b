#define _POSIX_C_SOURCE 200809L
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "vector.h"

static const float rest_alpha = 0.5f, object_alpha = 1;

/* ---- rays ---- */

typedef struct sample_rays {           /* the shadow rays of one sample, with scratch for their results */
    prt_vec3      cosine[REFERENCE_COSINE_RAYS], light[REFERENCE_LIGHT_RAYS];
    size_t        texel[REFERENCE_LIGHT_RAYS];
    prt_real      u[REFERENCE_LIGHT_RAYS], v[REFERENCE_LIGHT_RAYS];
    prt_ray       rays[REFERENCE_COSINE_RAYS];
    unsigned char blocked[REFERENCE_COSINE_RAYS];
    prt_real      x[REFERENCE_COSINE_RAYS], y[REFERENCE_COSINE_RAYS], z[REFERENCE_COSINE_RAYS];
    prt_real      basis[REFERENCE_COEFFICIENTS * REFERENCE_COSINE_RAYS];
} sample_rays;

static int trace(const reference *r, const prt_point *at, int count, const prt_vec3 *dirs, sample_rays *s) {
    int k;
    for (k = 0; k < count; k++) {
        s->rays[k].origin.x = at->position.x + r->bias * at->normal.x;
        s->rays[k].origin.y = at->position.y + r->bias * at->normal.y;
        s->rays[k].origin.z = at->position.z + r->bias * at->normal.z;
        s->rays[k].dir = dirs[k];
        s->rays[k].tmin = 0;
        s->rays[k].tmax = (prt_real)1e6;
        s->blocked[k] = 0;
    }
    return r->tracer->occluded(r->tracer->user, count, s->rays, s->blocked);
}

static void store(picture *p, size_t at, const double sum[3], float alpha) {
    int c;
    for (c = 0; c < 3; c++) p->rgba[4 * at + (size_t)c] = (float)sum[c];
    p->rgba[4 * at + 3] = alpha;
}

/* Transfer of this one sample from its open cosine rays, dotted with the light of every environment and band count. */
static void store_floor(const reference *r, reference_half *t, size_t at, sample_rays *s) {
    prt_real transfer[REFERENCE_COEFFICIENTS], light[3 * REFERENCE_COEFFICIENTS];
    prt_rgb out = { 0, 0, 0 };
    int open = 0, e, b, i, k;
    for (k = 0; k < REFERENCE_COSINE_RAYS; k++) {
        if (s->blocked[k]) continue;
        s->x[open] = s->cosine[k].x; s->y[open] = s->cosine[k].y; s->z[open] = s->cosine[k].z;
        open++;
    }
    prt_sh_eval_soa(REFERENCE_BANDS, open, s->x, s->y, s->z, s->basis, REFERENCE_COSINE_RAYS);
    for (i = 0; i < REFERENCE_COEFFICIENTS; i++) {
        prt_real sum = 0;
        for (k = 0; k < open; k++) sum += s->basis[i * REFERENCE_COSINE_RAYS + k];
        transfer[i] = sum / REFERENCE_COSINE_RAYS;
    }
    for (e = 0; e < REFERENCE_LIGHTS; e++) {
        for (b = 0; b < REFERENCE_BAND_COUNTS; b++) {
            double sum[3];
            environment_light(&r->environments[e], reference_bands[b], light);
            prt_shade_diffuse(reference_bands[b], transfer, light, &out);
            sum[0] = (double)out.r; sum[1] = (double)out.g; sum[2] = (double)out.b;
            store(&t->floor[e][b], at, sum, object_alpha);
        }
    }
}

static int shade_sample(reference *r, int half, size_t at, const prt_point *point, float alpha, sample_rays *s) {
    reference_half *t = &r->halves[half];
    double sum[REFERENCE_LIGHTS][3] = { { 0 } };
    uint64_t seed = (uint64_t)half + 1;
    int e, k;
    prt_sample_directions(REFERENCE_COSINE_RAYS, seed, at, point->normal, 0, REFERENCE_COSINE_RAYS, s->cosine);
    if (trace(r, point, REFERENCE_COSINE_RAYS, s->cosine, s)) return -1;
    store_floor(r, t, at, s);
    for (e = 0; e < REFERENCE_LIGHTS; e++)
        for (k = 0; k < REFERENCE_COSINE_RAYS; k++)
            if (!s->blocked[k])
                environment_add(&r->environments[e], environment_texel(&r->environments[e], s->cosine[k]),
                                vec_dot(s->cosine[k], point->normal), REFERENCE_COSINE_RAYS, REFERENCE_LIGHT_RAYS,
                                sum[e]);
    for (e = 0; e < REFERENCE_LIGHTS; e++) {
        int above = 0;
        prt_sample_square(PRT_SAMPLE_SOBOL, REFERENCE_LIGHT_RAYS, seed + REFERENCE_HALVES * (uint64_t)(e + 1), at, 0,
                          REFERENCE_LIGHT_RAYS, s->u, s->v);
        for (k = 0; k < REFERENCE_LIGHT_RAYS; k++) {
            s->light[above] = environment_sample(&r->environments[e], (double)s->u[k], (double)s->v[k],
                                                 &s->texel[above]);
            above += vec_dot(s->light[above], point->normal) > 0;
        }
        if (trace(r, point, above, s->light, s)) return -1;
        for (k = 0; k < above; k++)
            if (!s->blocked[k])
                environment_add(&r->environments[e], s->texel[k], vec_dot(s->light[k], point->normal),
                                REFERENCE_COSINE_RAYS, REFERENCE_LIGHT_RAYS, sum[e]);
        store(&t->reference[e], at, sum[e], alpha);
    }
    return 0;
}

static prt_vec3 blend(const prt_vec3 *a, const prt_vec3 *b, const prt_vec3 *c, prt_real u, prt_real v) {
    prt_vec3 sum;
    prt_real w = 1 - u - v;
    sum.x = w * a->x + u * b->x + v * c->x;
    sum.y = w * a->y + u * b->y + v * c->y;
    sum.z = w * a->z + u * b->z + v * c->z;
    return sum;
}

/* The place where a hit lies, with the interpolated normal of unit length that its cosine and its bias use. */
static prt_point point_of(const mesh *m, const prt_hit *hit) {
    const uint32_t *corner = m->triangles + 3 * (size_t)hit->primitive;
    const prt_point *a = m->points + corner[0], *b = m->points + corner[1], *c = m->points + corner[2];
    prt_point p;
    prt_real length;
    p.position = blend(&a->position, &b->position, &c->position, hit->u, hit->v);
    p.normal = blend(&a->normal, &b->normal, &c->normal, hit->u, hit->v);
    length = (prt_real)sqrt(vec_dot(p.normal, p.normal));
    if (!(length > 0)) return *a;
    p.normal.x /= length; p.normal.y /= length; p.normal.z /= length;
    return p;
}

typedef struct row_buffers { prt_ray *rays; prt_hit *hits; sample_rays samples; } row_buffers;

static int shade_row(reference *r, int y, row_buffers *own) {
    prt_ray *eye_rays = own->rays;
    prt_hit *hits = own->hits;
    camera_frame f = camera_make_frame(&r->eye, (double)r->width / r->height);
    int x, half;
    for (x = 0; x < r->width; x++) {
        double across = 2 * (x + 0.5) / r->width - 1, up = 1 - 2 * (y + 0.5) / r->height, d[3], length;
        int k;
        for (k = 0; k < 3; k++) d[k] = f.forward[k] + across * f.right[k] + up * f.up[k];
        length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        eye_rays[x].origin = r->eye.eye;
        eye_rays[x].dir.x = (prt_real)(d[0] / length);
        eye_rays[x].dir.y = (prt_real)(d[1] / length);
        eye_rays[x].dir.z = (prt_real)(d[2] / length);
        eye_rays[x].tmin = 0;
        eye_rays[x].tmax = (prt_real)1e6;
    }
    if (r->tracer->closest(r->tracer->user, r->width, eye_rays, hits)) return -1;
    for (x = 0; x < r->width; x++) {
        float alpha = hits[x].primitive < r->object_triangles ? object_alpha : rest_alpha;
        prt_point p;
        if (hits[x].object < 0) continue;
        p = point_of(r->scene, &hits[x]);
        for (half = 0; half < REFERENCE_HALVES; half++)
            if (shade_sample(r, half, (size_t)y * (size_t)r->width + (size_t)x, &p, alpha, &own->samples)) return -1;
    }
    return 0;
}

static void end_rows(void *buffers) {
    row_buffers *own = (row_buffers *)buffers;
    free(own->rays);
    free(own->hits);
    free(own);
}

static int begin_rows(void *user, void **buffers) {
    const reference *r = (const reference *)user;
    row_buffers *own = (row_buffers *)malloc(sizeof *own);
    if (!own) return -1;
    own->rays = (prt_ray *)malloc((size_t)r->width * sizeof *own->rays);
    own->hits = (prt_hit *)malloc((size_t)r->width * sizeof *own->hits);
    *buffers = own;
    if (own->rays && own->hits) return 0;
    end_rows(own);
    return -1;
}

static int shade_rows(void *user, void *buffers, int first, int count) {
    int failed = 0, k;
    for (k = 0; k < count && !failed; k++) failed = shade_row((reference *)user, first + k, (row_buffers *)buffers);
    return failed;
}

static int make_halves(reference *r, why *w) {
    int half, e, b;
    for (half = 0; half < REFERENCE_HALVES; half++) {
        for (e = 0; e < REFERENCE_LIGHTS; e++) {
            if (picture_create(r->width, r->height, &r->halves[half].reference[e], w)) return -1;
            for (b = 0; b < REFERENCE_BAND_COUNTS; b++)
                if (picture_create(r->width, r->height, &r->halves[half].floor[e][b], w)) return -1;
        }
    }
    return 0;
}

void reference_free(reference *r) {
    int half, e, b;
    for (half = 0; half < REFERENCE_HALVES; half++) {
        for (e = 0; e < REFERENCE_LIGHTS; e++) {
            picture_free(&r->halves[half].reference[e]);
            for (b = 0; b < REFERENCE_BAND_COUNTS; b++) picture_free(&r->halves[half].floor[e][b]);
        }
    }
}

int reference_trace(reference *r, why *w) {
    parallel rows;
    if (make_halves(r, w)) return -1;
    memset(&rows, 0, sizeof rows);
    rows.count = r->height;
    rows.chunk = 1;
    rows.threads = r->threads;
    rows.what = r->what;
    rows.unit = "rows";
    rows.unit_per_item = 1;
    rows.stop = r->stop;
    rows.begin = begin_rows;
    rows.work = shade_rows;
    rows.end = end_rows;
    rows.user = r;
    return parallel_run(&rows, w);
}

/* ---- figures ---- */

/* A pixel's radiance, as the screen would show it: the mean over its samples, none below 0. -1: a sample's alpha is
   below `least`. */
static int pixel_of(const picture *p, int x, int y, int per_pixel, float least, double rgb[3]) {
    int i, j, c;
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (j = 0; j < per_pixel; j++) {
        for (i = 0; i < per_pixel; i++) {
            const float *s = p->rgba + 4 * ((size_t)(y * per_pixel + j) * (size_t)p->width +
                                            (size_t)(x * per_pixel + i));
            if (s[3] < least) return -1;
            for (c = 0; c < 3; c++) rgb[c] += (s[c] > 0 ? (double)s[c] : 0) / (per_pixel * per_pixel);
        }
    }
    return 0;
}

double reference_error(const picture *a0, const picture *a1, const picture *b0, const picture *b1, int per_pixel,
                       float least) {
    double products = 0, sum = 0, va0[3], va1[3], vb0[3], vb1[3];
    int x, y, c;
    double count = 0;
    for (y = 0; y < a0->height / per_pixel; y++) {
        for (x = 0; x < a0->width / per_pixel; x++) {
            if (pixel_of(b0, x, y, per_pixel, least, vb0) || pixel_of(b1, x, y, per_pixel, least, vb1) ||
                pixel_of(a0, x, y, per_pixel, rest_alpha, va0) || pixel_of(a1, x, y, per_pixel, rest_alpha, va1))
                continue;
            for (c = 0; c < 3; c++) {
                products += (va0[c] - vb0[c]) * (va1[c] - vb1[c]);
                sum += 0.5 * (vb0[c] + vb1[c]);
            }
            count += 3;
        }
    }
    return sum > 0 && products > 0 ? sqrt(products / count) / (sum / count) : 0;
}

static double squared(const double a[3], const double b[3]) {
    double sum = 0;
    int c;
    for (c = 0; c < 3; c++) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

double reference_uncertainty(const reference *r, int light, int bands, const picture *p, int per_pixel, float least) {
    const picture *r0 = &r->halves[0].reference[light], *r1 = &r->halves[1].reference[light];
    const picture *f0 = &r->halves[0].floor[light][bands], *f1 = &r->halves[1].floor[light][bands];
    double vp[3], vr0[3], vr1[3], vf0[3], vf1[3], sum = 0, squares = 0, count = 0;
    int x, y;
    for (y = 0; y < p->height / per_pixel; y++) {
        for (x = 0; x < p->width / per_pixel; x++) {
            double d;
            if (pixel_of(r0, x, y, per_pixel, least, vr0) || pixel_of(r1, x, y, per_pixel, least, vr1) ||
                pixel_of(f0, x, y, per_pixel, rest_alpha, vf0) || pixel_of(f1, x, y, per_pixel, rest_alpha, vf1) ||
                pixel_of(p, x, y, per_pixel, rest_alpha, vp))
                continue;
            d = 0.5 * ((squared(vp, vr0) - squared(vp, vr1)) - (squared(vf0, vr0) - squared(vf1, vr1)));
            squares += d * d;
            sum += 0.5 * (vr0[0] + vr0[1] + vr0[2] + vr1[0] + vr1[1] + vr1[2]);
            count += 3;
        }
    }
    return sum > 0 ? sqrt(squares) / count / (sum / count * sum / count) : 0;
}
