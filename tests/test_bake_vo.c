/* >>vo of the baker: form factors, mean directions and normals against closed forms and quadrature, Snell's law, total
   internal reflection, which occluders are kept, independence of range and thread, every error. */
#include <stddef.h>

static void *hooked_malloc(size_t size);
static void hooked_free(void *memory);
#define PRT_MALLOC(size) hooked_malloc(size)
#define PRT_FREE(memory) hooked_free(memory)
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include <float.h>
#include <limits.h>
#include <pthread.h>

static const double pi = 3.14159265358979323846;

static struct { int calls, frees, fail; size_t size; } memory_hook;
static void *hooked_malloc(size_t size) {
    memory_hook.calls++;
    memory_hook.size = size;
    return memory_hook.fail ? NULL : malloc(size);
}
static void hooked_free(void *memory) {
    memory_hook.frees++;
    free(memory);
}

/* ---- small vectors in double ---- */

typedef struct v3 { double x, y, z; } v3;
static v3 v(double x, double y, double z) { v3 r; r.x = x; r.y = y; r.z = z; return r; }
static v3 d3(prt_vec3 a) { return v((double)a.x, (double)a.y, (double)a.z); }
static v3 along(v3 a, double t, v3 b) { return v(a.x + t * b.x, a.y + t * b.y, a.z + t * b.z); }
static double dot3(v3 a, v3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static v3 unit(v3 a) { double s = 1 / sqrt(dot3(a, a)); return v(a.x * s, a.y * s, a.z * s); }
static prt_vec3 vec3(v3 a) {
    prt_vec3 r;
    r.x = (prt_real)a.x; r.y = (prt_real)a.y; r.z = (prt_real)a.z;
    return r;
}
static prt_rgb rgb(double r, double g, double b) {
    prt_rgb c;
    c.r = (prt_real)r; c.g = (prt_real)g; c.b = (prt_real)b;
    return c;
}
static void assert_vec3(prt_vec3 got, v3 want, double tolerance) {
    assert_near(got.x, want.x, tolerance); assert_near(got.y, want.y, tolerance); assert_near(got.z, want.z, tolerance);
}

/* ---- scenes: balls, and horizontal planes ---- */

typedef struct shape { v3 centre; double radius; int object, primitive; } shape;   /* radius 0: the plane z = centre.z */
typedef struct world { int count; shape shapes[64]; prt_hit forged; int forge, fail_at, calls; } world;

static int shape_hit(const shape *s, v3 o, v3 d, double *t, v3 *n) {
    if (s->radius > 0) {
        v3 c = along(s->centre, -1, o);
        double b = dot3(c, d), q = b * b - dot3(c, c) + s->radius * s->radius, root;
        if (q < 0) return 0;
        root = sqrt(q);
        *t = b - root > 0 ? b - root : b + root;
        *n = unit(along(along(o, *t, d), -1, s->centre));
        return *t > 0;
    }
    if (fabs(d.z) < 1e-9) return 0;
    *t = (s->centre.z - o.z) / d.z;
    *n = v(0, 0, s->centre.x);                                 /* up or down */
    return *t > 0;
}
static int world_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    world *w = (world *)user;
    int k, i;
    w->calls++;
    if (w->calls == w->fail_at) return 1;
    for (k = 0; k < count; k++) {
        double nearest = DBL_MAX, t;
        v3 n;
        assert_true(hits[k].object < 0);
        if (w->forge) { hits[k] = w->forged; continue; }
        for (i = 0; i < w->count; i++)
            if (shape_hit(&w->shapes[i], d3(rays[k].origin), d3(rays[k].dir), &t, &n) && t < nearest) {
                nearest = t;
                hits[k].t = (prt_real)t;
                hits[k].object = w->shapes[i].object;
                hits[k].primitive = w->shapes[i].primitive;
                hits[k].u = hits[k].v = (prt_real).25;
                hits[k].normal = vec3(n);
            }
    }
    return 0;
}
static int world_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    world *w = (world *)user;
    int k, i;
    double t;
    v3 n;
    w->calls++;
    if (w->calls == w->fail_at) return 1;
    for (k = 0; k < count; k++)
        for (i = 0; i < w->count; i++)
            if (shape_hit(&w->shapes[i], d3(rays[k].origin), d3(rays[k].dir), &t, &n)) blocked[k] = 1;
    return 0;
}

typedef struct setting { world w; prt_tracer tracer; prt_vo_object objects[8]; prt_vo_desc desc; prt_point point; } setting;

static void begin(setting *s, int objects) {
    int k;
    memset(s, 0, sizeof *s);
    s->tracer.user = &s->w;
    s->tracer.closest = world_closest;
    s->tracer.occluded = world_occluded;
    s->desc.tracer = &s->tracer;
    s->desc.object_count = objects;
    s->desc.objects = s->objects;
    for (k = 0; k < objects; k++) s->objects[k].diffuse = rgb(.5, .25, .125);
    s->point.normal = vec3(v(0, 0, 1));
}
static void ball(setting *s, int object, v3 centre, double radius) {
    shape *b = &s->w.shapes[s->w.count++];
    b->centre = centre; b->radius = radius; b->object = object;
}
static void plane(setting *s, int object, double z, double facing) {
    shape *b = &s->w.shapes[s->w.count++];
    b->centre = v(facing, 0, z); b->object = object;
}

/* ---- one ball over the point, by quadrature over its cap: 512 x 512 nodes ---- */

typedef struct cap { double f; v3 direction, normal, position, bent; } cap;

static cap cap_of(v3 centre, double radius, double refraction) {
    double distance = sqrt(dot3(centre, centre)), low = sqrt(1 - radius * radius / (distance * distance));
    v3 axis = unit(centre), t = unit(fabs(axis.x) < .5 ? v(0, -axis.z, axis.y) : v(-axis.z, 0, axis.x));
    v3 b = v(axis.y * t.z - axis.z * t.y, axis.z * t.x - axis.x * t.z, axis.x * t.y - axis.y * t.x);
    cap c;
    int i, j, n = 512;
    memset(&c, 0, sizeof c);
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++) {
            double z = low + (1 - low) * (i + .5) / n, r = sqrt(1 - z * z), phi = 2 * pi * (j + .5) / n;
            v3 side = along(v(cos(phi) * t.x, cos(phi) * t.y, cos(phi) * t.z), sin(phi), b);
            v3 w = along(v(z * axis.x, z * axis.y, z * axis.z), r, side);
            double weight = 2 * (1 - low) / (n * n) * w.z, off = distance * r, half = sqrt(radius * radius - off * off);
            double reach = distance * z - half, in = asin(off / radius), turn = acos(z) - 2 * (in - asin(off / radius / refraction));
            if (!(weight > 0)) continue;
            c.f += weight;
            c.direction = along(c.direction, weight, w);
            c.position = along(c.position, weight * reach, w);
            c.normal = along(c.normal, weight / radius, along(v(reach * w.x, reach * w.y, reach * w.z), -1, centre));
            c.bent = along(along(c.bent, weight * cos(turn), axis), weight * sin(turn), side);
        }
    c.position = v(c.position.x / c.f, c.position.y / c.f, c.position.z / c.f);
    return c;
}

/* A cap of half-angle a at theta from the normal, wholly above the horizon: F = cos(theta) sin^2 a; and the integral of
   (N.w) w over it is A N + B (N.c) c by symmetry. Everything else by quadrature. The bias is set to move nothing. */
static void a_ball_has_its_closed_form(void **state) {
    static const v3 centres[] = { { 0, 0, 2 }, { 1.5, -.5, 2 }, { 2, 2, 1.9 } };
    int k;
    (void)state;
    for (k = 0; k < 3; k++) {
        setting s;
        prt_vo_row row;
        prt_vo_occluder o[2];
        double d2 = dot3(centres[k], centres[k]), sin2 = .81 / d2, low = sqrt(1 - sin2), tolerance;
        double a = 2. / 3 - low + low * low * low / 3, b = 2 * (1 - low * low * low) / 3 - a;
        v3 axis = unit(centres[k]), mean = along(v(0, 0, a), b * axis.z, axis);
        cap want = cap_of(centres[k], .9, 1.5);
        begin(&s, 1);
        s.objects[0].specular = rgb(.25, .5, .75);
        ball(&s, 0, centres[k], .9);
        s.desc.samples = 20000;
        s.desc.max_occluders = 2;
        s.desc.bias = (prt_real)BY_PRECISION(1e-5, 1e-9);
        memset(o, 7, sizeof o);
        assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
        assert_int_equal(row.count, 1);
        assert_int_equal(row.dropped, 0);
        assert_near(want.f, axis.z * sin2, 1e-5);
        tolerance = sqrt(want.f / s.desc.samples);             /* one standard error of independent rays */
        assert_near(o[0].form_factor, axis.z * sin2, tolerance);
        assert_vec3(o[0].occlusion, unit(mean), tolerance / want.f * .2);
        assert_vec3(o[0].position, want.position, tolerance / want.f);
        assert_vec3(o[0].diffuse_normal, want.normal, tolerance);
        assert_vec3(o[0].specular_normal, d3(o[0].diffuse_normal), 5.0 / s.desc.samples);   /* all mirrors open, but where
                                                                                               a ray grazes the ball */
        assert_memory_equal(&o[0].diffuse, &s.objects[0].diffuse, sizeof(prt_rgb));
        assert_memory_equal(&o[0].specular, &s.objects[0].specular, sizeof(prt_rgb));
        assert_vec3(o[0].caustic, v(0, 0, 0), 0);
        assert_near(o[0].transmissive.r, 0, 0);
        assert_near(o[0].caustic_factor, 0, 0);
        assert_near(o[1].form_factor, 0, 0);                   /* the slot behind the last is zero */
    }
}

/* A ray through a glass ball is turned twice by i - t; none is reflected totally, so that all of them come out. */
static void a_glass_ball_bends_as_snell_says(void **state) {
    static const double indices[] = { 1.05, 1.5, 2.4 };
    int k;
    (void)state;
    for (k = 0; k < 3; k++) {
        setting s;
        prt_vo_row row;
        prt_vo_occluder o;
        v3 centre = v(1.5, -.5, 2);
        cap want = cap_of(centre, .9, indices[k]);
        begin(&s, 1);
        ball(&s, 0, centre, .9);
        s.objects[0].transmissive = rgb(.75, .5, .25);
        s.objects[0].refraction = (prt_real)indices[k];
        s.desc.samples = 20000;
        s.desc.max_occluders = 1;
        s.desc.bias = (prt_real)1e-5;
        assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, &o), PRT_OK);
        assert_near(o.caustic_factor, o.form_factor, 3.0 / s.desc.samples);   /* but for rays that graze it */
        assert_vec3(o.caustic, unit(want.bent), sqrt(1 / want.f / s.desc.samples));
        assert_near(o.transmissive.r, .75, 1e-6); assert_near(o.transmissive.g, .5, 1e-6);
        assert_near(o.transmissive.b, .25, 1e-6);
    }
}

/* A slab of glass moves rays but does not turn them. */
static void a_slab_turns_nothing(void **state) {
    setting s;
    prt_vo_row row;
    prt_vo_occluder o;
    (void)state;
    begin(&s, 1);
    plane(&s, 0, 1, -1);
    plane(&s, 0, 2, 1);
    s.objects[0].transmissive = rgb(.5, .5, .5);
    s.desc.max_occluders = 1;
    s.desc.bias = (prt_real)1e-5;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, &o), PRT_OK);
    assert_near(o.form_factor, 1, 2.0 / 4096);                 /* all but rays along the horizon */
    assert_near(o.caustic_factor, o.form_factor, 0);
    assert_vec3(o.caustic, d3(o.occlusion), 4 * PRT__EPS);
}

/* A slab of air in glass, index 1/1.5, reflects what meets it beyond asin(1/1.5): a share 1 - 1/2.25 of the form factor. */
static void total_internal_reflection(void **state) {
    setting s;
    prt_vo_row row;
    prt_vo_occluder o;
    double through = 1 / 2.25;
    (void)state;
    begin(&s, 1);
    plane(&s, 0, 1, -1);
    plane(&s, 0, 2, 1);
    s.objects[0].transmissive = rgb(.5, .25, 0);
    s.objects[0].refraction = (prt_real)(1 / 1.5);
    s.desc.samples = 10000;
    s.desc.max_occluders = 1;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, &o), PRT_OK);
    assert_near(o.caustic_factor, o.form_factor, 0);
    assert_near(o.transmissive.r, 1 - .5 * through, 4.0 / s.desc.samples);
    assert_near(o.transmissive.g, 1 - .75 * through, 4.0 / s.desc.samples);
    assert_near(o.transmissive.b, 1 - through, 4.0 / s.desc.samples);
    assert_vec3(o.caustic, v(0, 0, (1 - 2 * pow(1 - through, 1.5)) > 0 ? 1 : -1), .1);
}

/* One surface, by angles. */
static void bending_one_ray(void **state) {
    int i, k;
    (void)state;
    for (k = 0; k < 4; k++) {
        static const double indices[] = { 1.33, 1.5, 2.4, 1 / 1.5 };
        double index = indices[k], n[3] = { 0, 0, 1 };
        for (i = 0; i < 180; i++) {
            double angle = (i + .5) * pi / 180, d[3] = { 0, 0, 0 }, in = angle < pi / 2 ? angle : pi - angle;
            double sine = sin(in) * (angle < pi / 2 ? index : 1 / index);
            int got;
            d[0] = sin(angle); d[2] = cos(angle);              /* below 90 degrees it leaves, above it enters */
            got = prt__vo_bend(index, n, d);
            assert_near(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1, 1e-15);
            if (sine > 1) {
                assert_int_equal(got, 0);
                assert_near(d[0], sin(angle), 1e-15); assert_near(d[2], -cos(angle), 1e-15);
            } else {
                assert_int_equal(got, angle < pi / 2 ? -1 : 1);
                assert_near(d[0], sine, 1e-15);
                assert_near(d[2], sqrt((1 - sine) * (1 + sine)) * (angle < pi / 2 ? 1 : -1), 1e-14);
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ball_has_its_closed_form),
        cmocka_unit_test(a_glass_ball_bends_as_snell_says),
        cmocka_unit_test(a_slab_turns_nothing),
        cmocka_unit_test(total_internal_reflection),
        cmocka_unit_test(bending_one_ray),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
