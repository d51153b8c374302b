#define _POSIX_C_SOURCE 200809L
#include "scene.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vector.h"

/* ---- building ---- */

typedef struct builder {
    int      point_count, triangle_count, point_room, triangle_room, failed;
    prt_vec3 *positions;
    uint32_t *triangles;
} builder;

static int add_position(builder *b, prt_vec3 p) {
    if (b->point_count == b->point_room) {
        int room = b->point_room ? 2 * b->point_room : 1024;
        prt_vec3 *more = (prt_vec3 *)realloc(b->positions, (size_t)room * sizeof *more);
        if (!more) { b->failed = 1; return 0; }
        b->positions = more;
        b->point_room = room;
    }
    b->positions[b->point_count] = p;
    return b->point_count++;
}

static void add_triangle(builder *b, int i, int j, int k) {
    if (b->triangle_count == b->triangle_room) {
        int room = b->triangle_room ? 2 * b->triangle_room : 1024;
        uint32_t *more = (uint32_t *)realloc(b->triangles, 3 * (size_t)room * sizeof *more);
        if (!more) { b->failed = 1; return; }
        b->triangles = more;
        b->triangle_room = room;
    }
    b->triangles[3 * (size_t)b->triangle_count] = (uint32_t)i;
    b->triangles[3 * (size_t)b->triangle_count + 1] = (uint32_t)j;
    b->triangles[3 * (size_t)b->triangle_count + 2] = (uint32_t)k;
    b->triangle_count++;
}

/* A sheet of columns x rows squares over u, v in [0,1]; seen from outside, v runs upwards where u runs to the right. */
typedef prt_vec3 (*sheet_form)(const void *what, double u, double v);
enum { WRAP_U = 1, WRAP_V = 2, POLE_BELOW = 4, POLE_ABOVE = 8 };   /* closed; a row that is one point */

static int sheet_point(int first, int columns, int rows, int flags, int i, int j) {
    int width = columns + !(flags & WRAP_U);
    if (flags & WRAP_U) i %= columns;
    if (flags & WRAP_V) j %= rows;
    if (flags & POLE_BELOW)
        return j == 0 ? first : first + 1 + (j - 1) * width + (flags & POLE_ABOVE && j == rows ? 0 : i);
    return first + j * width + (flags & POLE_ABOVE && j == rows ? 0 : i);
}

static void add_sheet(builder *b, int columns, int rows, int flags, sheet_form form, const void *what) {
    int first = b->point_count, i, j;
    for (j = 0; j <= rows - !!(flags & WRAP_V); j++) {
        int pole = (j == 0 && flags & POLE_BELOW) || (j == rows && flags & POLE_ABOVE);
        for (i = 0; i <= (pole ? 0 : columns - !!(flags & WRAP_U)); i++)
            add_position(b, form(what, (double)i / columns, (double)j / rows));
    }
    for (j = 0; j < rows; j++) {
        for (i = 0; i < columns; i++) {
            int a = sheet_point(first, columns, rows, flags, i, j),
                c = sheet_point(first, columns, rows, flags, i + 1, j);
            int d = sheet_point(first, columns, rows, flags, i + 1, j + 1);
            int e = sheet_point(first, columns, rows, flags, i, j + 1);
            if (a != c) add_triangle(b, a, c, d);
            if (d != e) add_triangle(b, a, d, e);
        }
    }
}

/* ---- forms ---- */

/* Standing at `at`, its axis turned from +z by `tilt` towards the azimuth `facing`. */
typedef struct placement { double at[3], tilt, facing; } placement;

static prt_vec3 place(const placement *p, double x, double y, double z) {
    double ct = cos(p->tilt), st = sin(p->tilt), cf = cos(p->facing), sf = sin(p->facing);
    double leant = ct * x + st * z, up = ct * z - st * x;
    return vec(p->at[0] + cf * leant - sf * y, p->at[1] + sf * leant + cf * y, p->at[2] + up);
}

typedef struct ring { placement where; double radius, thickness; } ring;
static prt_vec3 ring_form(const void *what, double u, double v) {
    const ring *r = (const ring *)what;
    double from_axis = r->radius + r->thickness * cos(2 * pi * v), a = 2 * pi * u;
    return place(&r->where, from_axis * cos(a), from_axis * sin(a), r->thickness * sin(2 * pi * v));
}

typedef struct ball { double at[3], radius; } ball;
static prt_vec3 ball_form(const void *what, double u, double v) {
    const ball *s = (const ball *)what;
    double a = 2 * pi * u, b = pi * (v - 0.5), r = s->radius * cos(b);
    return vec(s->at[0] + r * cos(a), s->at[1] + r * sin(a), s->at[2] + s->radius * sin(b));
}

/* A straight line from (r0, z0) to (r1, z1) turned about the axis. */
typedef struct cone { placement where; double r0, z0, r1, z1; } cone;
static prt_vec3 cone_form(const void *what, double u, double v) {
    const cone *c = (const cone *)what;
    double r = c->r0 + v * (c->r1 - c->r0), a = 2 * pi * u;
    return place(&c->where, r * cos(a), r * sin(a), c->z0 + v * (c->z1 - c->z0));
}

/* The body of the pot: a belly, a neck and a lid with a knob, by a Catmull-Rom spline through (r, z). */
typedef struct pot { double at[3], size, facing; } pot;
static double spline(const double *p, double t) {
    return p[1] + 0.5 * t * (p[2] - p[0] + t * (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3] +
                                                t * (3 * (p[1] - p[2]) + p[3] - p[0])));
}
static prt_vec3 pot_form(const void *what, double u, double v) {
    static const double r[] = { -0.3, 0, 0.42, 0.62, 0.72, 0.60, 0.42, 0.30, 0.10, 0.08, 0.13, 0, -0.13 };
    static const double z[] = { 0, 0, 0.0, 0.18, 0.48, 0.78, 0.90, 0.97, 1.03, 1.08, 1.16, 1.23, 1.16 };
    enum { SPANS = sizeof r / sizeof *r - 3 };
    const pot *p = (const pot *)what;
    int span = (int)(v * SPANS) < SPANS ? (int)(v * SPANS) : SPANS - 1;
    double t = v * SPANS - span, a = 2 * pi * u, radius = p->size * spline(r + span, t);
    if (v <= 0 || v >= 1) radius = 0;
    return vec(p->at[0] + radius * cos(a), p->at[1] + radius * sin(a), p->at[2] + p->size * spline(z + span, t));
}

/* Spout and handle: a tapered tube along a quadratic curve in the plane of the pot's axis and its facing. */
typedef struct arm { pot where; double path[3][2], r0, r1; } arm;
static prt_vec3 arm_form(const void *what, double u, double v) {
    const arm *m = (const arm *)what;
    double a = (1 - v) * (1 - v), b = 2 * v * (1 - v), c = v * v, along[2], tangent[2], length,
           r = m->r0 + v * (m->r1 - m->r0);
    double angle = 2 * pi * u, out, up, side, cf = cos(m->where.facing), sf = sin(m->where.facing), s = m->where.size;
    int k;
    for (k = 0; k < 2; k++) {
        along[k] = a * m->path[0][k] + b * m->path[1][k] + c * m->path[2][k];
        tangent[k] = (1 - v) * (m->path[1][k] - m->path[0][k]) + v * (m->path[2][k] - m->path[1][k]);
    }
    length = sqrt(tangent[0] * tangent[0] + tangent[1] * tangent[1]);
    out = along[0] + r * cos(angle) * tangent[1] / length;
    up = along[1] - r * cos(angle) * tangent[0] / length;
    side = r * sin(angle);
    return vec(m->where.at[0] + s * (cf * out - sf * side), m->where.at[1] + s * (sf * out + cf * side),
               m->where.at[2] + s * up);
}

typedef struct quad { double corner[3], u[3], v[3]; } quad;
static prt_vec3 quad_form(const void *what, double u, double v) {
    const quad *q = (const quad *)what;
    return vec(q->corner[0] + u * q->u[0] + v * q->v[0], q->corner[1] + u * q->u[1] + v * q->v[1],
               q->corner[2] + u * q->u[2] + v * q->v[2]);
}

/* ---- parts ---- */

static int strips(double fineness, int count) {
    int n = (int)(fineness * count + 0.5);
    return n < 3 ? 3 : n;
}

static void add_torus(builder *b, double f, const ring *r) {
    add_sheet(b, strips(f, 44), strips(f, 22), WRAP_U | WRAP_V, ring_form, r);
}

static void add_ball(builder *b, double f, int columns, int rows, const ball *s) {
    add_sheet(b, strips(f, columns), strips(f, rows), WRAP_U | POLE_BELOW | POLE_ABOVE, ball_form, s);
}

/* Outer wall, inner wall and both rims, with sharp edges between them. */
static void add_tube(builder *b, double f, placement where, double inner, double outer, double half_length) {
    const double h = half_length;
    cone walls[4];
    int k;
    memset(walls, 0, sizeof walls);
    walls[0].r0 = walls[0].r1 = outer; walls[0].z0 = -h; walls[0].z1 = h;
    walls[1].r0 = walls[1].r1 = inner; walls[1].z0 = h;  walls[1].z1 = -h;
    walls[2].r0 = outer; walls[2].r1 = inner; walls[2].z0 = walls[2].z1 = h;
    walls[3].r0 = inner; walls[3].r1 = outer; walls[3].z0 = walls[3].z1 = -h;
    for (k = 0; k < 4; k++) {
        walls[k].where = where;
        add_sheet(b, strips(f, 36), k < 2 ? strips(f, 10) : 1, WRAP_U, cone_form, &walls[k]);
    }
}

static void add_pot(builder *b, double f, pot where) {
    arm spout = { { { 0 }, 0, 0 }, { { 0.50, 0.30 }, { 0.95, 0.30 }, { 1.12, 0.92 } }, 0.17, 0.07 };
    arm handle = { { { 0 }, 0, 0 }, { { -0.54, 0.80 }, { -1.45, 0.75 }, { -0.58, 0.22 } }, 0.08, 0.08 };
    spout.where = handle.where = where;
    add_sheet(b, strips(f, 36), strips(f, 22), WRAP_U | POLE_BELOW | POLE_ABOVE, pot_form, &where);
    add_sheet(b, strips(f, 14), strips(f, 9), WRAP_U, arm_form, &spout);
    add_sheet(b, strips(f, 12), strips(f, 14), WRAP_U, arm_form, &handle);
}

/* A slab of which top and sides are there, its top at z = 0. */
static void add_platform(builder *b, int cells, double half, double thickness) {
    quad q = { { -half, -half, 0 }, { 2 * half, 0, 0 }, { 0, 2 * half, 0 } };
    int k;
    add_sheet(b, cells, cells, 0, quad_form, &q);
    for (k = 0; k < 4; k++) {
        double c = k == 0 || k == 3 ? -half : half, d = k < 2 ? -half : half;
        quad side = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
        side.corner[0] = c; side.corner[1] = d; side.corner[2] = -thickness;
        side.u[k % 2] = k < 2 ? 2 * half : -2 * half;
        side.v[2] = thickness;
        add_sheet(b, 13, 1, 0, quad_form, &side);
    }
}

/* A closed box; a sheet with its normal outwards for each side. */
static void add_box(builder *b, const double low[3], const double high[3]) {
    int axis, side, k;
    for (axis = 0; axis < 3; axis++) {
        for (side = 0; side < 2; side++) {
            int u = (axis + 1 + side) % 3, v = (axis + 2 - side) % 3;
            quad q;
            memset(&q, 0, sizeof q);
            for (k = 0; k < 3; k++) q.corner[k] = low[k];
            q.corner[axis] = side ? low[axis] : high[axis];
            q.u[u] = high[u] - low[u];
            q.v[v] = high[v] - low[v];
            add_sheet(b, 3, 3, 0, quad_form, &q);
        }
    }
}

static material matter(double r, double g, double blue, double shine, double shininess) {
    material m;
    memset(&m, 0, sizeof m);
    m.diffuse = rgb(r, g, blue);
    m.specular = rgb(shine, shine, shine);
    m.shininess = (prt_real)shininess;
    m.index = 1;
    return m;
}

/* Names what was added to b since the last part. */
static void end_part(scene *s, const builder *b, const char *name, material m) {
    scene_part *p = &s->parts[s->part_count];
    if (s->part_count) {
        p->first_point = p[-1].first_point + p[-1].point_count;
        p->first_triangle = p[-1].first_triangle + p[-1].triangle_count;
    }
    p->name = name;
    p->point_count = b->point_count - p->first_point;
    p->triangle_count = b->triangle_count - p->first_triangle;
    p->material = m;
    s->part_count++;
}

static int finish(builder *b, scene *s, why *w) {
    prt_mesh from;
    memset(&from, 0, sizeof from);
    from.vertex_count = b->point_count;
    from.positions = b->positions;
    from.triangle_count = b->triangle_count;
    from.triangles = b->triangles;
    s->mesh.points = b->failed ? NULL : (prt_point *)malloc((size_t)b->point_count * sizeof *s->mesh.points);
    if (!s->mesh.points || prt_points_from_vertices(&from, s->mesh.points, &s->mesh.report) != PRT_OK) {
        free(b->positions);
        free(b->triangles);
        scene_free(s);
        return why_set(w, "out of memory for the scene");
    }
    s->mesh.point_count = b->point_count;
    s->mesh.triangle_count = b->triangle_count;
    s->mesh.triangles = b->triangles;
    free(b->positions);
    return 0;
}

int scene_shapes(double fineness, scene *s, why *w) {
    const ring torus = { { { -0.15, 0.75, 0.62 }, 0.55, -1.2 }, 0.62, 0.22 };
    const placement tube = { { -1.25, -0.35, 0.45 }, 1.5707963267948966, -0.95 };
    const pot blue = { { 1.05, 0.15, 0.0 }, 0.85, -0.6 };
    const ball white = { { -0.05, -0.75, 0.40 }, 0.40 }, green = { { 0.75, -1.15, 0.25 }, 0.25 };
    builder b;
    memset(&b, 0, sizeof b);
    memset(s, 0, sizeof *s);
    add_torus(&b, fineness, &torus);
    end_part(s, &b, "torus", matter(0.85, 0.42, 0.08, 0.25, 24));
    add_tube(&b, fineness, tube, 0.36, 0.45, 0.62);
    end_part(s, &b, "tube", matter(0.80, 0.08, 0.07, 0.25, 24));
    add_pot(&b, fineness, blue);
    end_part(s, &b, "pot", matter(0.12, 0.25, 0.75, 0.25, 24));
    add_ball(&b, fineness, 30, 15, &white);
    end_part(s, &b, "white sphere", matter(0.85, 0.85, 0.85, 0.1, 24));
    add_ball(&b, fineness, 27, 11, &green);
    end_part(s, &b, "green sphere", matter(0.15, 0.65, 0.15, 0.3, 24));
    add_platform(&b, strips(fineness, 34), 2.1, 0.15);
    end_part(s, &b, "platform", matter(0.65, 0.65, 0.65, 0.25, 24));
    return finish(&b, s, w);
}

int scene_ball(double fineness, scene *s, why *w) {
    const ball white = { { 0, 0, 0.55 }, 0.35 };
    builder b;
    memset(&b, 0, sizeof b);
    memset(s, 0, sizeof *s);
    add_ball(&b, fineness, 36, 18, &white);
    end_part(s, &b, "ball", matter(0.8, 0.8, 0.8, 0, 1));
    add_platform(&b, strips(fineness, 80), 2.1, 0.15);
    end_part(s, &b, "platform", matter(0.65, 0.65, 0.65, 0, 1));
    return finish(&b, s, w);
}

int scene_room(double fineness, scene *s, why *w) {
    const double near_wall = 0.996, above = 0.004;         /* vertices in a crease would see behind the other wall */
    const quad walls[4] = { { { -near_wall, -near_wall, 0 }, { 2 * near_wall, 0, 0 }, { 0, 2 * near_wall, 0 } },
                            { { -near_wall, 1, above }, { 2 * near_wall, 0, 0 }, { 0, 0, 1.5 } },
                            { { -1, -near_wall, above }, { 0, 2 * near_wall, 0 }, { 0, 0, 1.5 } },
                            { { 1, near_wall, above }, { 0, -2 * near_wall, 0 }, { 0, 0, 1.5 } } };
    static const double colours[4][3] = { { 0.75, 0.75, 0.75 }, { 0.75, 0.75, 0.75 }, { 0.75, 0.12, 0.08 },
                                          { 0.12, 0.6, 0.15 } };
    static const char *const names[4] = { "floor", "white wall", "red wall", "green wall" };
    const ball white = { { -0.35, 0.3, 0.4 }, 0.4 }, small = { { 0.45, -0.25, 0.28 }, 0.28 };
    builder b;
    int k;
    memset(&b, 0, sizeof b);
    memset(s, 0, sizeof *s);
    for (k = 0; k < 4; k++) {
        add_sheet(&b, strips(fineness, 30), strips(fineness, k ? 24 : 30), 0, quad_form, &walls[k]);
        end_part(s, &b, names[k], matter(colours[k][0], colours[k][1], colours[k][2], 0.25, 24));
    }
    add_ball(&b, fineness, 36, 18, &white);
    end_part(s, &b, "white ball", matter(0.8, 0.8, 0.8, 0.25, 24));
    add_ball(&b, fineness, 30, 15, &small);
    end_part(s, &b, "small ball", matter(0.8, 0.7, 0.4, 0.25, 24));
    return finish(&b, s, w);
}

static material glass(double r, double g, double blue) {
    material m = matter(0.04, 0.04, 0.04, 0, 1);
    m.transmissive = rgb(r, g, blue);
    m.index = (prt_real)1.5;
    return m;
}

int scene_glass(double fineness, scene *s, why *w) {
    const ball clear = { { -0.55, -0.1, 0.65 }, 0.5 }, red = { { 0.75, 0.3, 0.5 }, 0.38 },
               white = { { 0.35, -0.85, 0.3 }, 0.3 };
    builder b;
    memset(&b, 0, sizeof b);
    memset(s, 0, sizeof *s);
    add_ball(&b, fineness, 48, 24, &clear);
    end_part(s, &b, "clear ball", glass(0.9, 0.9, 0.9));
    add_ball(&b, fineness, 48, 24, &red);
    end_part(s, &b, "red ball", glass(0.85, 0.1, 0.08));
    add_ball(&b, fineness, 36, 18, &white);
    end_part(s, &b, "white ball", matter(0.8, 0.8, 0.8, 0, 1));
    add_platform(&b, strips(fineness, 110), 2.1, 0.15);
    end_part(s, &b, "platform", matter(0.65, 0.65, 0.65, 0, 1));
    return finish(&b, s, w);
}

/* Turns the axis that points upwards to +z. */
int scene_pool(double fineness, scene *s, why *w) {
    static const double low[3] = { -6, -6, 5 }, high[3] = { 6, 6, 5.4 };
    const ball pearl = { { -0.5, -0.2, 0.45 }, 0.45 }, red = { { 0.9, 0.5, 0.3 }, 0.3 };
    material water = glass(0.9, 0.92, 0.95);
    builder b;
    memset(&b, 0, sizeof b);
    memset(s, 0, sizeof *s);
    water.index = (prt_real)1.333;
    add_ball(&b, fineness, 48, 24, &pearl);
    end_part(s, &b, "pearl", matter(0.03, 0.03, 0.03, 0.4, 24));
    add_ball(&b, fineness, 36, 18, &red);
    end_part(s, &b, "red ball", matter(0.75, 0.12, 0.08, 0.15, 24));
    add_platform(&b, strips(fineness, 110), 2.1, 0.15);
    end_part(s, &b, "floor", matter(0.6, 0.55, 0.42, 0.1, 24));
    add_box(&b, low, high);
    end_part(s, &b, "water", water);
    return finish(&b, s, w);
}

static prt_vec3 turn_upright(prt_vec3 v, const char *up) {
    double x = (double)v.x, y = (double)v.y, z = (double)v.z;
    if (*up == '-') return up[1] == 'x' ? vec(z, y, -x) : up[1] == 'y' ? vec(x, z, -y) : vec(x, -y, -z);
    return up[1] == 'x' ? vec(y, z, x) : up[1] == 'y' ? vec(z, x, y) : v;
}

/* The file's triangles, their lowest point on the platform. */
static void add_mesh(builder *b, const mesh *m, const char *up) {
    double low = 1e30;
    int base = b->point_count, i;
    for (i = 0; i < m->point_count; i++) {
        prt_vec3 p = turn_upright(m->points[i].position, up);
        if ((double)p.z < low) low = (double)p.z;
        add_position(b, p);
    }
    for (i = base; i < b->point_count && !b->failed; i++) b->positions[i].z -= (prt_real)low;
    for (i = 0; i < m->triangle_count; i++) {
        const uint32_t *v = m->triangles + 3 * (size_t)i;
        add_triangle(b, base + (int)v[0], base + (int)v[1], base + (int)v[2]);
    }
}

int scene_statue(const char *path, const char *up, int cells, scene *s, why *w) {
    static const struct { ball where; double r, g, b; const char *name; } balls[] = {
        { { { -1.25, -0.55, 0.28 }, 0.28 }, 0.80, 0.10, 0.08, "red ball" },
        { { { 1.15, -0.70, 0.22 }, 0.22 }, 0.15, 0.60, 0.15, "green ball" },
        { { { 1.10, 0.80, 0.35 }, 0.35 }, 0.85, 0.65, 0.10, "yellow ball" },
        { { { -1.00, 0.95, 0.32 }, 0.32 }, 0.10, 0.25, 0.75, "blue ball" }
    };
    mesh statue;
    builder b;
    size_t k;
    memset(&b, 0, sizeof b);
    memset(s, 0, sizeof *s);
    if (mesh_load(path, MESH_Z_UP, &statue, w) || mesh_fit_unit_sphere(&statue, w)) return -1;
    add_mesh(&b, &statue, up);
    mesh_free(&statue);
    end_part(s, &b, "statue", matter(0.7, 0.68, 0.62, 0.15, 24));
    for (k = 0; k < sizeof balls / sizeof *balls; k++) {
        add_ball(&b, 1, 30, 15, &balls[k].where);
        end_part(s, &b, balls[k].name, matter(balls[k].r, balls[k].g, balls[k].b, 0.2, 24));
    }
    add_platform(&b, cells, 2.1, 0.15);
    end_part(s, &b, "platform", matter(0.65, 0.65, 0.65, 0.15, 24));
    return finish(&b, s, w);
}

void scene_free(scene *s) {
    mesh_free(&s->mesh);
    memset(s, 0, sizeof *s);
}

void scene_make_matte(scene *s) {
    int k;
    for (k = 0; k < s->part_count; k++) s->parts[k].material.specular = rgb(0, 0, 0);
}

int scene_part_of_point(const scene *s, int point) {
    int k = 0;
    while (k + 1 < s->part_count && point >= s->parts[k + 1].first_point) k++;
    return k;
}

/* ---- tracing ---- */

int scene_trace_with(const scene *s, embree_tracer *t, why *w) {
    int k;
    if (embree_tracer_create(t, w)) return -1;
    for (k = 0; k < s->part_count; k++) {
        mesh part = s->mesh;
        part.triangles += 3 * (size_t)s->parts[k].first_triangle;
        part.triangle_count = s->parts[k].triangle_count;
        if (embree_tracer_add(t, &part, k, w)) return -1;
    }
    return embree_tracer_build(t, w);
}

int scene_triangle(const scene *s, const prt_hit *hit) { return s->parts[hit->object].first_triangle + hit->primitive; }

static void weights_of(const prt_hit *hit, prt_real weight[3]) {
    weight[0] = 1 - hit->u - hit->v;
    weight[1] = hit->u;
    weight[2] = hit->v;
}

prt_vec3 scene_place_flat(const scene *s, const prt_hit *hit) {
    const uint32_t *corner = s->mesh.triangles + 3 * (size_t)scene_triangle(s, hit);
    prt_vec3 place = vec(0, 0, 0);
    prt_real weight[3];
    int k;
    weights_of(hit, weight);
    for (k = 0; k < 3; k++) place = vec_add(place, weight[k], s->mesh.points[corner[k]].position);
    return place;
}

prt_point scene_place(const scene *s, const prt_hit *hit) {
    const uint32_t *corner = s->mesh.triangles + 3 * (size_t)scene_triangle(s, hit);
    prt_vec3 flat = scene_place_flat(s, hit);
    prt_real weight[3];
    prt_point p;
    int k;
    weights_of(hit, weight);
    p.position = flat;
    p.normal = vec(0, 0, 0);
    for (k = 0; k < 3; k++) {
        const prt_point *c = &s->mesh.points[corner[k]];
        double below = vec_dot(vec_add(flat, -1, c->position), c->normal);
        p.normal = vec_add(p.normal, weight[k], c->normal);
        if (below < 0) p.position = vec_add(p.position, (prt_real)-below * weight[k], c->normal);
    }
    p.normal = vec_unit(p.normal, hit->normal);
    return p;
}

/* ---- the camera ---- */

static void aim(view *v) {
    camera_frame f = camera_make_frame(&v->eye, (double)v->width / v->height);
    int x, y, k;
    for (y = 0; y < v->height; y++) {
        for (x = 0; x < v->width; x++) {
            double across = 2 * (x + 0.5) / v->width - 1, up = 1 - 2 * (y + 0.5) / v->height, d[3];
            prt_ray *r = v->rays + (size_t)y * (size_t)v->width + (size_t)x;
            for (k = 0; k < 3; k++) d[k] = f.forward[k] + across * f.right[k] + up * f.up[k];
            r->origin = v->eye.eye;
            r->dir = vec_unit(vec(d[0], d[1], d[2]), vec(0, 0, 1));
            r->tmin = 0;
            r->tmax = (prt_real)1e6;
        }
    }
}

int view_create(const scene *s, const embree_tracer *t, camera eye, int width, int height, view *v, why *w) {
    size_t count = (size_t)width * (size_t)height, k;
    int row;
    v->eye = eye;
    v->width = width;
    v->height = height;
    v->rays = (prt_ray *)malloc(count * sizeof *v->rays);
    v->hits = (prt_hit *)malloc(count * sizeof *v->hits);
    if (!v->rays || !v->hits) return why_set(w, "out of memory for a picture of %d x %d samples", width, height);
    aim(v);
    for (row = 0; row < height; row++) {
        size_t at = (size_t)row * (size_t)width;
        if (t->tracer.closest(t->tracer.user, width, v->rays + at, v->hits + at))
            return why_set(w, "the view cannot be traced");
    }
    for (k = 0; k < count; k++)
        if (v->hits[k].object >= s->part_count) return why_set(w, "Embree reports an unknown object");
    return 0;
}

void view_free(view *v) {
    free(v->rays);
    free(v->hits);
    memset(v, 0, sizeof *v);
}

int view_paint(const view *v, const scene *s, const prt_rgb *colors, prt_rgb background, picture *to, why *w) {
    size_t count = (size_t)v->width * (size_t)v->height, k;
    if (picture_create(v->width, v->height, to, w)) return -1;
    for (k = 0; k < count; k++) {
        const prt_hit *h = &v->hits[k];
        float *sample = to->rgba + 4 * k;
        if (h->object < 0) {
            sample[0] = (float)background.r; sample[1] = (float)background.g; sample[2] = (float)background.b;
            sample[3] = 0;
        } else {
            const uint32_t *corner = s->mesh.triangles + 3 * (size_t)scene_triangle(s, h);
            const prt_rgb *a = colors + corner[0], *b = colors + corner[1], *c = colors + corner[2];
            prt_real t = 1 - h->u - h->v;
            sample[0] = (float)(t * a->r + h->u * b->r + h->v * c->r);
            sample[1] = (float)(t * a->g + h->u * b->g + h->v * c->g);
            sample[2] = (float)(t * a->b + h->u * b->b + h->v * c->b);
            sample[3] = s->parts[h->object].material.transmissive.g > 0 ? 0.5f : 1;
        }
    }
    return 0;
}
