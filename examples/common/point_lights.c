#define _POSIX_C_SOURCE 200809L
#include "point_lights.h"

#include <math.h>
#include <stdlib.h>

#include "vector.h"

/* Texels x0 ... x1-1 of rows y0 ... y1-1. */
typedef struct region { int x0, y0, x1, y1; double energy; } region;

typedef struct cutting {
    const image *map;
    double      *sums;                 /* [height + 1][width + 1]: energy above and left of each corner */
} cutting;

static double row_solid_angle(const image *map, int y) {
    return 2 * pi / map->width * (cos(pi * y / map->height) - cos(pi * (y + 1) / map->height));
}

static double luminance(const float *v) {
    return 0.2126 * (double)v[0] + 0.7152 * (double)v[1] + 0.0722 * (double)v[2];
}

static int sum_up(cutting *c, why *w) {
    const image *map = c->map;
    size_t stride = (size_t)map->width + 1;
    int x, y;
    c->sums = (double *)calloc(stride * ((size_t)map->height + 1), sizeof *c->sums);
    if (!c->sums) return why_set(w, "out of memory for the sums of a map of %d x %d texels", map->width, map->height);
    for (y = 0; y < map->height; y++) {
        double row = 0, solid_angle = row_solid_angle(map, y);
        for (x = 0; x < map->width; x++) {
            row += solid_angle * luminance(map->rgb + 3 * ((size_t)y * (size_t)map->width + (size_t)x));
            c->sums[((size_t)y + 1) * stride + (size_t)x + 1] = c->sums[(size_t)y * stride + (size_t)x + 1] + row;
        }
    }
    return 0;
}

static double energy_of(const cutting *c, int x0, int y0, int x1, int y1) {
    size_t stride = (size_t)c->map->width + 1;
    return c->sums[(size_t)y1 * stride + (size_t)x1] - c->sums[(size_t)y0 * stride + (size_t)x1] -
           c->sums[(size_t)y1 * stride + (size_t)x0] + c->sums[(size_t)y0 * stride + (size_t)x0];
}

static region make_region(const cutting *c, int x0, int y0, int x1, int y1) {
    region r;
    r.x0 = x0; r.y0 = y0; r.x1 = x1; r.y1 = y1;
    r.energy = energy_of(c, x0, y0, x1, y1);
    return r;
}

/* A region of one texel cannot be cut. */
static int divisible(const region *r) { return r->x1 - r->x0 > 1 || r->y1 - r->y0 > 1; }

/* Across the longer side, as seen on the sphere, where the halves come nearest to equal energy. */
static void cut(const cutting *c, const region *r, region *a, region *b) {
    double across = 2.0 * (r->x1 - r->x0) / c->map->width * sin(pi * 0.5 * (r->y0 + r->y1) / c->map->height);
    int vertical = r->y1 - r->y0 == 1 ||
                   (r->x1 - r->x0 > 1 && across > (double)(r->y1 - r->y0) / c->map->height);
    int first = vertical ? r->x0 : r->y0, last = vertical ? r->x1 : r->y1, at, best = first + 1;
    double least = INFINITY;
    for (at = first + 1; at < last; at++) {
        double part = vertical ? energy_of(c, r->x0, r->y0, at, r->y1) : energy_of(c, r->x0, r->y0, r->x1, at);
        if (fabs(part - 0.5 * r->energy) < least) {
            least = fabs(part - 0.5 * r->energy);
            best = at;
        }
    }
    *a = vertical ? make_region(c, r->x0, r->y0, best, r->y1) : make_region(c, r->x0, r->y0, r->x1, best);
    *b = vertical ? make_region(c, best, r->y0, r->x1, r->y1) : make_region(c, r->x0, best, r->x1, r->y1);
}

static prt_point_light light_of(const cutting *c, const region *r, double distance) {
    double sum[3] = { 0, 0, 0 }, centroid[3] = { 0, 0, 0 };
    prt_point_light light;
    prt_vec3 towards;
    int x, y, k;
    for (y = r->y0; y < r->y1; y++) {
        double theta = pi * (y + 0.5) / c->map->height, solid_angle = row_solid_angle(c->map, y);
        for (x = r->x0; x < r->x1; x++) {
            const float *v = c->map->rgb + 3 * ((size_t)y * (size_t)c->map->width + (size_t)x);
            double phi = 2 * pi * (x + 0.5) / c->map->width, energy = solid_angle * luminance(v);
            centroid[0] += energy * sin(theta) * cos(phi);
            centroid[1] += energy * sin(theta) * sin(phi);
            centroid[2] += energy * cos(theta);
            for (k = 0; k < 3; k++) sum[k] += solid_angle * (double)v[k];
        }
    }
    towards = vec_unit(vec(centroid[0], centroid[1], centroid[2]), vec(0, 0, 1));
    light.position = vec(distance * (double)towards.x, distance * (double)towards.y, distance * (double)towards.z);
    light.color = rgb(sum[0] / pi, sum[1] / pi, sum[2] / pi);
    return light;
}

int point_lights_from_map(const image *map, int count, double distance, prt_point_light *lights, why *w) {
    region *regions = (region *)malloc((size_t)(count > 0 ? count : 1) * sizeof *regions);
    cutting c;
    int made = 1, k, failed = 0;
    c.map = map;
    c.sums = NULL;
    if (!regions || sum_up(&c, w)) {
        free(regions);
        return why_set(w, "out of memory for %d lights", count);
    }
    regions[0] = make_region(&c, 0, 0, map->width, map->height);
    if (!(regions[0].energy > 0)) failed = why_set(w, "the environment is black: it has no lights");
    while (!failed && made < count) {
        int most = -1;
        for (k = 0; k < made; k++)
            if (divisible(&regions[k]) && (most < 0 || regions[k].energy > regions[most].energy)) most = k;
        if (most < 0) failed = why_set(w, "an environment of %d texels cannot become %d lights", made, count);
        else {
            region whole = regions[most];
            cut(&c, &whole, &regions[most], &regions[made++]);
        }
    }
    for (k = 0; !failed && k < count; k++) lights[k] = light_of(&c, &regions[k], distance);
    free(c.sums);
    free(regions);
    return failed;
}

/* The radical inverse in base 2. */
static double van_der_corput(unsigned k) {
    double value = 0, digit = 0.5;
    for (; k; k >>= 1, digit /= 2) value += digit * (k & 1);
    return value;
}

void point_lights_around(int count, prt_vec3 centre, double distance, prt_point_light *lights) {
    int k;
    for (k = 0; k < count; k++) {
        double height = 0.3 + 0.65 * (1 - van_der_corput((unsigned)k + 1)),
               phi = 2 * pi * fmod(0.55 + 0.6180339887498949 * k, 1);
        double across = sqrt(1 - height * height), warm = 0.12 * cos(2.399963 * k);
        lights[k].position = vec_add(centre, (prt_real)distance, vec(across * cos(phi), across * sin(phi), height));
        lights[k].color = rgb(1 + warm, 1, 1 - warm);
    }
}
