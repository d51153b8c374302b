#define _POSIX_C_SOURCE 200809L
#include "photons.h"

#include <stdlib.h>
#include <string.h>

#include "vector.h"

enum { MOST_SURFACES = 12 };           /* that a photon passes */

prt_vec3 refracted(prt_vec3 dir, prt_vec3 normal, double ratio) {
    double cosine = -vec_dot(dir, normal), squared = 1 - ratio * ratio * (1 - cosine * cosine);
    prt_vec3 out = vec(0, 0, 0);
    if (squared < 0) return vec_reflect(dir, normal);
    out = vec_add(out, (prt_real)ratio, dir);
    return vec_unit(vec_add(out, (prt_real)(ratio * cosine - sqrt(squared)), normal), dir);
}

/* ---- sending ---- */

typedef struct target { prt_vec3 centre; double radius; } target;

static target around(const scene *s, const scene_part *p) {
    target t;
    int k;
    t.centre = vec(0, 0, 0);
    t.radius = 0;
    for (k = 0; k < p->point_count; k++)
        t.centre = vec_add(t.centre, (prt_real)(1.0 / p->point_count), s->mesh.points[p->first_point + k].position);
    for (k = 0; k < p->point_count; k++) {
        prt_vec3 off = vec_add(s->mesh.points[p->first_point + k].position, -1, t.centre);
        if (sqrt(vec_dot(off, off)) > t.radius) t.radius = sqrt(vec_dot(off, off));
    }
    return t;
}

static int transmits(const material *m) { return rgb_mean(m->transmissive) > 0; }

/* Follows one photon. 1: it ended on an opaque surface, having gone through a transmissive one; 0: it is lost. */
static int follow(const scene *s, const prt_tracer *t, prt_ray ray, photon *p, double *way) {
    int passed = 0;
    prt_hit hit;
    for (*way = 0; passed < MOST_SURFACES; passed++) {
        const material *m;
        prt_point at;
        int inside;
        if (t->closest(t->user, 1, &ray, &hit) || hit.object < 0) return 0;
        *way += (double)hit.t;
        m = &s->parts[hit.object].material;
        at = scene_place(s, &hit);
        inside = vec_dot(hit.normal, ray.dir) > 0;
        if (!transmits(m)) {
            p->position = at.position;
            p->dir = ray.dir;
            return passed > 0 && !inside;
        }
        if (!inside) p->power = rgb_times(p->power, m->transmissive);
        if (inside) at.normal = vec(-(double)at.normal.x, -(double)at.normal.y, -(double)at.normal.z);
        ray.dir = refracted(ray.dir, at.normal, inside ? (double)m->index : 1 / (double)m->index);
        ray.origin = vec_add(scene_place_flat(s, &hit),
                             vec_dot(ray.dir, at.normal) > 0 ? (prt_real)1e-4 : (prt_real)-1e-4, at.normal);
    }
    return 0;
}

static unsigned cell_of(const photon_map *map, int x, int y, int z) {
    return ((unsigned)x * 73856093u ^ (unsigned)y * 19349663u ^ (unsigned)z * 83492791u) & (unsigned)(map->cells - 1);
}
static int coordinate(const photon_map *map, prt_real v) { return (int)floor((double)v / map->radius); }

static void keep(photon_map *map, const photon *p) {
    unsigned cell = cell_of(map, coordinate(map, p->position.x), coordinate(map, p->position.y),
                            coordinate(map, p->position.z));
    map->photons[map->count] = *p;
    map->photons[map->count].next = map->first[cell];
    map->first[cell] = map->count++;
}

/* Photons of one light through one part: directions uniform in the cone that its bounding sphere fills. */
static void send(const scene *s, const prt_tracer *t, const prt_point_light *light, int number, const scene_part *part,
                 int count, uint64_t seed, photon_map *map) {
    target at = around(s, part);
    prt_vec3 to = vec_add(at.centre, -1, light->position), axis = vec_unit(to, vec(0, 0, 1));
    double distance = sqrt(vec_dot(to, to)), sine = at.radius / distance,
           cosine = sine < 1 ? sqrt(1 - sine * sine) : -1, way;
    double solid_angle = 2 * pi * (1 - cosine);
    int k;
    for (k = 0; k < count; k++) {
        prt_real u = 0, v = 0;
        double z, r;
        prt_ray ray;
        photon p;
        prt_sample_square(PRT_SAMPLE_SOBOL, count, seed, (uint64_t)number, k, 1, &u, &v);
        z = 1 - (double)u * (1 - cosine);
        r = sqrt(z * z < 1 ? 1 - z * z : 0);
        ray.origin = light->position;
        ray.dir = turn_to(axis, vec(r * cos(2 * pi * (double)v), r * sin(2 * pi * (double)v), z));
        ray.tmin = 0;
        ray.tmax = (prt_real)1e6;
        p.power = rgb_scale(light->color, solid_angle / count);
        p.light = number;
        if (!follow(s, t, ray, &p, &way)) continue;
        p.power = rgb_scale(p.power, way * way);
        keep(map, &p);
    }
}

int photon_map_make(const scene *s, const prt_tracer *t, int light_count, const prt_point_light *lights, int photons,
                    double radius, uint64_t seed, photon_map *map, why *w) {
    int parts = 0, k, i;
    memset(map, 0, sizeof *map);
    for (k = 0; k < s->part_count; k++) parts += transmits(&s->parts[k].material);
    if (parts == 0 || photons == 0) return 0;
    map->radius = radius;
    for (map->cells = 1; map->cells < 65536; map->cells *= 2) {}
    map->photons = (photon *)malloc((size_t)photons * (size_t)parts * (size_t)light_count * sizeof *map->photons);
    map->first = (int *)malloc((size_t)map->cells * sizeof *map->first);
    if (!map->photons || !map->first) return why_set(w, "out of memory for photons");
    for (k = 0; k < map->cells; k++) map->first[k] = -1;
    for (i = 0; i < light_count; i++)
        for (k = 0; k < s->part_count; k++)
            if (transmits(&s->parts[k].material))
                send(s, t, &lights[i], i, &s->parts[k], photons, seed + 16 * (uint64_t)k, map);
    return 0;
}

void photon_map_free(photon_map *map) {
    free(map->photons);
    free(map->first);
    memset(map, 0, sizeof *map);
}

/* ---- gathering ---- */

/* Photons of one cell within the disc; those of another surface nearby lie off its plane or come from behind. */
static void add_cell(const photon_map *map, int x, int y, int z, prt_vec3 position, prt_vec3 normal, const int *group,
                     prt_rgb *sum) {
    double area = pi * map->radius * map->radius;
    int k;
    for (k = map->first[cell_of(map, x, y, z)]; k >= 0; k = map->photons[k].next) {
        const photon *p = &map->photons[k];
        prt_vec3 off = vec_add(p->position, -1, position);
        prt_rgb *to;
        if (coordinate(map, p->position.x) != x || coordinate(map, p->position.y) != y ||
            coordinate(map, p->position.z) != z)
            continue;
        if (vec_dot(off, off) > map->radius * map->radius || fabs(vec_dot(off, normal)) > 0.25 * map->radius ||
            vec_dot(p->dir, normal) >= 0)
            continue;
        to = &sum[group ? group[p->light] : 0];
        to->r += (prt_real)((double)p->power.r / area);
        to->g += (prt_real)((double)p->power.g / area);
        to->b += (prt_real)((double)p->power.b / area);
    }
}

void photon_map_add(const photon_map *map, prt_vec3 position, prt_vec3 normal, const int *group, prt_rgb *sum) {
    int x, y, z, i;
    if (map->count == 0) return;
    x = coordinate(map, position.x); y = coordinate(map, position.y); z = coordinate(map, position.z);
    for (i = 0; i < 27; i++)
        add_cell(map, x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1, position, normal, group, sum);
}
