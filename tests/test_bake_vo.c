/* >>vo of the baker: form factors, mean directions and normals against closed forms and quadrature, Snell's law, total
   internal reflection, which occluders are kept, independence of range and thread, every error. */
#include "memory_hook.h"
#include "test.h"
#include <float.h>
#include <limits.h>
#include <pthread.h>

static const double pi = 3.14159265358979323846;

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
    b->centre = v(facing, 0, z); b->radius = 0; b->object = object;
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

/* ---- ambient occlusion, normals that it damps, mirrors that are closed ---- */

/* Under a ball in the zenith with sin^2 of its half-angle 1/4, open = 3/4; ranges and points are those of the transfer bake. */
static void ambient_occlusion(void **state) {
    setting s;
    prt_point points[3];
    prt_real open[3];
    int k;
    (void)state;
    begin(&s, 1);
    ball(&s, 0, v(0, 0, 2), 1);
    for (k = 0; k < 3; k++) points[k] = s.point;
    points[2].position = vec3(v(0, 0, 9));
    for (k = 0; k < 3; k++) open[k] = -1;
    assert_int_equal(prt_bake_vo_ao(&s.desc, 3, points, 1, 2, open), PRT_OK);
    assert_near(open[0], -1, 0);
    assert_near(open[1], .75, 1e-3);
    assert_near(open[2], 1, 0);
    assert_int_equal(prt_bake_vo_ao(NULL, 3, points, 1, 2, open), PRT_ERR_NULL);
    assert_int_equal(prt_bake_vo_ao(&s.desc, 3, points, 1, 2, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_vo_ao(&s.desc, 3, points, 2, 2, open), PRT_ERR_COUNT);
}

/* The diffuse normal is damped by AO between the corners of the triangle that was hit: .5, .25, .25 of 1, .6, .2 is .7. */
static void diffuse_normals_are_damped(void **state) {
    static const uint32_t triangles[] = { 0, 1, 2, 2, 1, 0 };
    static const prt_real open[] = { 1, (prt_real).6, (prt_real).2 };
    setting s;
    prt_vo_row row;
    prt_vo_occluder plain, damped;
    prt_point points[3];
    (void)state;
    begin(&s, 1);
    ball(&s, 0, v(.5, 0, 2), 1);
    s.w.shapes[0].primitive = 1;
    s.desc.max_occluders = 1;
    points[0] = points[1] = points[2] = s.point;
    assert_int_equal(prt_bake_vo(&s.desc, 3, points, open, 0, 1, &row, &plain), PRT_OK);
    s.objects[0].primitive_count = 2;
    s.objects[0].triangles = triangles;                        /* corners 2, 1, 0 at .5, .25, .25 */
    assert_int_equal(prt_bake_vo(&s.desc, 3, points, open, 0, 1, &row, &damped), PRT_OK);
    assert_near(damped.diffuse_normal.z, .5 * (double)plain.diffuse_normal.z, 4 * PRT__EPS);
    assert_near(damped.form_factor, plain.form_factor, 0);
    assert_int_equal(prt_bake_vo(&s.desc, 3, points, NULL, 0, 1, &row, &damped), PRT_OK);
    assert_memory_equal(&damped, &plain, sizeof plain);
}

/* A mirror overhead that faces a floor below the point: every mirror direction is closed. */
static void closed_mirrors_do_not_count(void **state) {
    setting s;
    prt_vo_row row;
    prt_vo_occluder o[2];
    (void)state;
    begin(&s, 2);
    s.objects[0].specular = rgb(1, 1, 1);
    plane(&s, 0, 2, -1);
    s.desc.max_occluders = 2;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_vec3(o[0].specular_normal, v(0, 0, -(double)o[0].form_factor), 4 * PRT__EPS);
    plane(&s, 1, -1, 1);
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_vec3(o[0].specular_normal, v(0, 0, 0), 0);
    assert_vec3(o[0].diffuse_normal, v(0, 0, -(double)o[0].form_factor), 4 * PRT__EPS);
    assert_int_equal(row.count, 1);                            /* the floor lies below the horizon */
}

/* An opaque ball behind a glass one: paths that end there do not count, and what all of it swallows is opaque. */
static void opaque_things_end_caustics(void **state) {
    setting s;
    prt_vo_row row;
    prt_vo_occluder o[2];
    (void)state;
    begin(&s, 2);
    ball(&s, 0, v(0, 0, 2), .5);
    s.objects[0].transmissive = rgb(1, 1, 1);
    s.desc.max_occluders = 2;
    ball(&s, 1, v(0, 0, 4), .5);
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_true(o[0].caustic_factor > 0 && o[0].caustic_factor < o[0].form_factor);
    s.w.count = 1;
    plane(&s, 1, 9, -1);
    s.desc.max_bends = 3;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_int_equal(row.count, 2);
    assert_near(o[1].caustic_factor, 0, 0);
    assert_near(o[1].transmissive.r, 0, 0);
    s.w.count = 1;
    s.desc.max_bends = 1;                                      /* enters, and may not leave */
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_near(o[0].caustic_factor, 0, 0);
    s.desc.off = PRT_VO_NO_CAUSTIC;                            /* tinted shadows stay */
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_near(o[0].transmissive.r, 1, 0);
}

/* What no object has is not baked, and its rays are not traced. */
static void only_what_the_scene_needs(void **state) {
    setting s;
    prt_vo_row row;
    prt_vo_occluder o[1];
    const unsigned mirrors = PRT_VO_NO_DS | PRT_VO_NO_SS;
    (void)state;
    begin(&s, 2);
    assert_int_equal(prt_vo_unneeded(2, s.objects), mirrors | PRT_VO_NO_CAUSTIC);
    s.objects[1].specular = rgb(0, 0, .1);
    assert_int_equal(prt_vo_unneeded(2, s.objects), PRT_VO_NO_CAUSTIC);
    s.objects[1].transmissive = rgb(0, .1, 0);
    assert_int_equal(prt_vo_unneeded(2, s.objects), 0);
    s.objects[0].diffuse = s.objects[1].diffuse = rgb(0, 0, 0);
    assert_int_equal(prt_vo_unneeded(2, s.objects), PRT_VO_NO_DD);
    assert_int_equal(prt_vo_unneeded(0, NULL), mirrors | PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD);
    begin(&s, 1);
    ball(&s, 0, v(0, 0, 2), 1);
    s.tracer.occluded = NULL;                                  /* nothing specular: not needed */
    s.desc.samples = 1024;
    s.desc.max_occluders = 1;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_int_equal(s.w.calls, 1);                            /* one batch */
    s.desc.off = PRT_VO_NO_DD;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_vec3(o[0].diffuse_normal, v(0, 0, 0), 0);
    assert_true(o[0].form_factor > 0);
}

/* ---- which are kept ---- */

/* A ring of balls of different sizes, one object, each a group of its own. */
static const int ring_groups[] = { 0, 1, 2, 3, 4, 5, 6 };
static void ring(setting *s) {
    int k;
    begin(s, 1);
    for (k = 0; k < 7; k++) {
        double angle = 2 * pi * k / 7;
        ball(s, 0, v(3 * cos(angle), 3 * sin(angle), 3), .3 + .1 * ((k * 3) % 7));
        s->w.shapes[k].primitive = k;
    }
    s->objects[0].primitive_count = 7;
    s->objects[0].group_count = 7;
    s->objects[0].groups = ring_groups;
}

static void the_strongest_are_kept(void **state) {
    setting s;
    prt_vo_row row, all_row;
    prt_vo_occluder all[9], o[9];
    double lost = 0;
    int k, keep;
    (void)state;
    ring(&s);
    s.desc.max_occluders = 9;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &all_row, all), PRT_OK);
    assert_int_equal(all_row.count, 7);
    assert_int_equal(all_row.dropped, 0);
    assert_near(all_row.dropped_factor, 0, 0);
    for (k = 1; k < 7; k++) assert_true(all[k].form_factor < all[k - 1].form_factor);
    for (keep = 6; keep >= 1; keep--) {
        s.desc.max_occluders = keep;
        memset(o, 7, sizeof o);
        assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
        lost += (double)all[keep].form_factor;
        assert_int_equal(row.count, keep);
        assert_int_equal(row.dropped, 7 - keep);
        assert_near(row.dropped_factor, lost, 4 * PRT__EPS);
        assert_memory_equal(o, all, (size_t)keep * sizeof *o);
        assert_int_equal(((unsigned char *)(o + keep))[0], 7);
    }
    s.desc.max_occluders = 9;
    s.desc.least = (all[2].form_factor + all[3].form_factor) / 2;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_int_equal(row.count, 3);
    assert_int_equal(row.dropped, 4);
    s.desc.least = 0;
    s.objects[0].groups = NULL;                                /* all of them one occluder */
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_int_equal(row.count, 1);
    assert_near(o[0].form_factor, lost + (double)all[0].form_factor, 8 * PRT__EPS);
    assert_vec3(o[0].occlusion, v(0, 0, 1), .2);
}

static void rows_are_compacted(void **state) {
    prt_vo_occluder o[6];
    prt_vo_row rows[3];
    int first[4], k;
    (void)state;
    memset(o, 0, sizeof o);
    memset(rows, 0, sizeof rows);
    for (k = 0; k < 6; k++) o[k].form_factor = (prt_real)k;
    rows[0].count = 1; rows[2].count = 2;
    assert_int_equal(prt_vo_compact(2, 3, rows, o, first), PRT_OK);
    assert_int_equal(first[0], 0); assert_int_equal(first[1], 1); assert_int_equal(first[2], 1); assert_int_equal(first[3], 3);
    assert_near(o[0].form_factor, 0, 0); assert_near(o[1].form_factor, 4, 0); assert_near(o[2].form_factor, 5, 0);
    assert_int_equal(prt_vo_compact(-1, 3, rows, o, first), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_compact(2, -1, rows, o, first), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_compact(2, 3, NULL, o, first), PRT_ERR_NULL);
    assert_int_equal(prt_vo_compact(2, 3, rows, NULL, first), PRT_ERR_NULL);
    assert_int_equal(prt_vo_compact(2, 3, rows, o, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_compact(2, 0, NULL, NULL, first), PRT_OK);
    assert_int_equal(first[0], 0);
    rows[1].count = 3;
    first[0] = 77;
    assert_int_equal(prt_vo_compact(2, 3, rows, o, first), PRT_ERR_COUNT);
    rows[1].count = -1;
    assert_int_equal(prt_vo_compact(2, 3, rows, o, first), PRT_ERR_COUNT);
    assert_int_equal(first[0], 77);
}

/* ---- ranges, threads, progress, errors ---- */

enum { MANY = 40, KEEP = 3 };
static void scatter(int count, prt_point *points) {
    int k;
    for (k = 0; k < count; k++) {
        double z = 1 - 2 * (k + .5) / count, r = sqrt(1 - z * z), angle = 2.399963 * k;
        points[k].position = vec3(v(cos(3 * angle), sin(angle), .3 * z));
        points[k].normal = vec3(v(r * cos(angle), r * sin(angle), z));
    }
}
static void lively(setting *s) {                               /* everything at once */
    ring(s);
    s->desc.object_count = 3;
    s->objects[0].specular = s->objects[1].specular = rgb(.5, .5, .5);
    s->objects[1].diffuse = s->objects[2].diffuse = rgb(1, 1, 1);
    s->objects[2].transmissive = rgb(.5, .9, .5);
    ball(s, 2, v(0, 0, 2.5), 1);
    plane(s, 1, -2, 1);
    s->desc.max_occluders = KEEP;
    s->desc.samples = 300;
    s->desc.seed = 7;
}

typedef struct work { setting *s; prt_point *points; prt_real *open; int first, count; prt_vo_row *rows; prt_vo_occluder *o;
                      prt_result result; } work;
static void *in_a_thread(void *user) {
    work *w = (work *)user;
    w->result = prt_bake_vo(&w->s->desc, MANY, w->points, w->open, w->first, w->count, w->rows, w->o);
    return NULL;
}
static void ranges_and_threads_give_the_same_bits(void **state) {
    static prt_vo_occluder all[MANY * KEEP], part[MANY * KEEP];
    prt_vo_row all_rows[MANY], rows[MANY];
    prt_point points[MANY];
    prt_real open[MANY];
    setting s, own[4];
    pthread_t threads[4];
    work w[4];
    int k;
    (void)state;
    lively(&s);
    scatter(MANY, points);
    assert_int_equal(prt_bake_vo_ao(&s.desc, MANY, points, 0, MANY, open), PRT_OK);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 0, MANY, all_rows, all), PRT_OK);
    memset(part, 7, sizeof part);
    memset(rows, 7, sizeof rows);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 3, 5, rows, part), PRT_OK);
    assert_memory_equal(part + 3 * KEEP, all + 3 * KEEP, 5 * KEEP * sizeof *all);
    for (k = 0; k < MANY; k++) if (k < 3 || k >= 8) {
        assert_int_equal(((unsigned char *)&part[k * KEEP])[0], 7);
        assert_int_equal(((unsigned char *)&rows[k])[0], 7);
    }
    memory_hook.calls = memory_hook.frees = 0;
    for (k = 0; k < 4; k++) {
        lively(&own[k]);
        w[k].s = &own[k]; w[k].points = points; w[k].open = open; w[k].first = k * 10; w[k].count = 10;
        w[k].rows = rows; w[k].o = part;
        assert_int_equal(pthread_create(&threads[k], NULL, in_a_thread, &w[k]), 0);
    }
    for (k = 0; k < 4; k++) {
        pthread_join(threads[k], NULL);
        assert_int_equal(w[k].result, PRT_OK);
    }
    assert_memory_equal(part, all, sizeof all);
    assert_memory_equal(rows, all_rows, sizeof rows);
}

static int stop_at(void *user, int done, int total) {
    int *calls = (int *)user;
    assert_int_equal(done, ++calls[0]);
    assert_int_equal(total, 10);
    return done == calls[1];
}
static void progress_and_cancel(void **state) {
    static prt_vo_occluder all[MANY * KEEP], part[MANY * KEEP];
    prt_vo_row rows[MANY];
    prt_point points[MANY];
    prt_real open[MANY];
    setting s;
    int calls[2] = { 0, 0 };
    (void)state;
    lively(&s);
    scatter(MANY, points);
    s.desc.progress = stop_at;
    s.desc.progress_user = calls;
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, NULL, 5, 10, rows, all), PRT_OK);
    assert_int_equal(calls[0], 10);
    calls[0] = 0; calls[1] = 4;
    memset(part, 7, sizeof part);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, NULL, 5, 10, rows, part), PRT_ERR_CANCELLED);
    assert_memory_equal(part + 5 * KEEP, all + 5 * KEEP, 4 * KEEP * sizeof *all);
    assert_int_equal(((unsigned char *)(part + 9 * KEEP))[0], 7);
    calls[0] = 0; calls[1] = 10;
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, NULL, 5, 10, rows, part), PRT_ERR_CANCELLED);
    assert_memory_equal(part + 5 * KEEP, all + 5 * KEEP, 10 * KEEP * sizeof *all);
    calls[0] = 0; calls[1] = 2;
    assert_int_equal(prt_bake_vo_ao(&s.desc, MANY, points, 5, 10, open), PRT_ERR_CANCELLED);
    assert_int_equal(calls[0], 2);
}

static void memory_is_counted(void **state) {
    static prt_vo_occluder o[KEEP];
    prt_vo_row row;
    setting s;
    (void)state;
    lively(&s);
    memory_hook.calls = memory_hook.frees = 0;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    assert_int_equal(memory_hook.calls, 1);
    assert_int_equal(memory_hook.frees, 1);
    assert_int_equal(memory_hook.size, prt_bake_vo_scratch_size(&s.desc));
    memory_hook.fail = 1;
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_ERR_MEMORY);
    memory_hook.fail = 0;
    assert_int_equal(prt_bake_vo_scratch_size(NULL), 0);
    assert_int_equal(prt_bake_vo_size(0, 100), 500 * sizeof *o);
    assert_int_equal(prt_bake_vo_size(7, 100), 700 * sizeof *o);
    assert_int_equal(prt_bake_vo_size(-1, 100), 0);
    assert_int_equal(prt_bake_vo_size(1, -1), 0);
    if (sizeof(size_t) == 4) assert_int_equal(prt_bake_vo_size(INT_MAX, INT_MAX), 0);
}

/* A hit that cannot be ends the bake at once. */
static void forged_hits_are_refused(void **state) {
    static const uint32_t triangles[] = { 0, 0, 0 };
    static prt_vo_occluder o[3 * KEEP];
    prt_vo_row rows[3];
    prt_point points[3];
    int k;
    (void)state;
    for (k = 0; k < 12; k++) {
        setting s;
        lively(&s);
        points[0] = points[1] = points[2] = s.point;
        s.objects[1].triangles = triangles;
        s.objects[1].primitive_count = 1;
        s.w.forge = 1;
        s.w.forged.t = 1;
        s.w.forged.normal = vec3(v(0, 0, -1));
        s.w.forged.object = 1;
        if (k == 0) s.w.forged.object = 3;
        if (k == 1) s.w.forged.object = INT_MAX;
        if (k == 2) s.w.forged.primitive = 1;
        if (k == 3) s.w.forged.primitive = -1;
        if (k == 4) { s.w.forged.object = 0; s.w.forged.primitive = 7; }
        if (k == 5) s.w.forged.t = -1;
        if (k == 6) s.w.forged.normal = vec3(v(0, 0, 0));
        if (k == 7) s.w.forged.normal = vec3(v(0, 0, 1.01));
#ifndef __FAST_MATH__
        if (k == 8) s.w.forged.t = (prt_real)INFINITY;
        if (k == 9) s.w.forged.u = (prt_real)NAN;
        if (k == 10) s.w.forged.normal.x = (prt_real)NAN;
        if (k == 11) s.w.forged.t = (prt_real)NAN;
#else
        if (k >= 8) break;
#endif
        memset(o, 7, sizeof o);
        memset(rows, 7, sizeof rows);
        assert_int_equal(prt_bake_vo(&s.desc, 3, points, NULL, 1, 1, rows, o), PRT_ERR_TRACE);
        assert_int_equal(((unsigned char *)o)[0], 7);
        assert_memory_equal(o, (unsigned char *)o + 1, sizeof o - 1);
        assert_memory_equal(rows, (unsigned char *)rows + 1, sizeof rows - 1);
    }
}

/* The callbacks fail at every call in turn. */
static void failing_callbacks(void **state) {
    static prt_vo_occluder o[KEEP];
    prt_vo_row row;
    setting s;
    int k, calls;
    (void)state;
    lively(&s);
    assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_OK);
    calls = s.w.calls;
    assert_true(calls >= 4);                                   /* feelers, mirrors, and two for caustics */
    for (k = 1; k <= calls; k++) {
        s.w.calls = 0;
        s.w.fail_at = k;
        assert_int_equal(prt_bake_vo(&s.desc, 1, &s.point, NULL, 0, 1, &row, o), PRT_ERR_TRACE);
    }
}

static void bad_arguments(void **state) {
    static const int beyond[] = { 0, 1, 2, 3, 4, 5, 7 };
    static const uint32_t triangles[] = { 0, 1, 2 };
    static prt_vo_occluder o[MANY * KEEP], untouched[MANY * KEEP];
    prt_vo_row rows[MANY];
    prt_point points[MANY];
    prt_real open[MANY];
    setting s;
    int k;
    (void)state;
    scatter(MANY, points);
    memset(o, 7, sizeof o);
    memcpy(untouched, o, sizeof o);
    for (k = 0; k < MANY; k++) open[k] = 1;
#define BAD(change, error) do { \
        lively(&s); \
        change; \
        assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 0, MANY, rows, o), error); \
    } while (0)
    BAD(s.desc.samples = -1, PRT_ERR_COUNT);
    BAD(s.desc.max_occluders = -1, PRT_ERR_COUNT);
    BAD(s.desc.max_bends = -1, PRT_ERR_COUNT);
    BAD(s.desc.object_count = -1, PRT_ERR_COUNT);
    BAD(s.objects[2].primitive_count = -1, PRT_ERR_COUNT);
    BAD(s.objects[2].group_count = -1, PRT_ERR_COUNT);
    BAD(s.objects[0].groups = beyond, PRT_ERR_COUNT);
    BAD(s.objects[0].group_count = 6, PRT_ERR_COUNT);
    BAD(s.objects[0].group_count = INT_MAX, PRT_ERR_CAPACITY);
    BAD(s.desc.objects = NULL, PRT_ERR_NULL);
    BAD(s.desc.tracer = NULL, PRT_ERR_NULL);
    BAD(s.tracer.closest = NULL, PRT_ERR_NULL);
    BAD(s.tracer.occluded = NULL, PRT_ERR_NULL);
    BAD(s.desc.bias = -1, PRT_ERR_VALUE);
    BAD(s.desc.scene_radius = -1, PRT_ERR_VALUE);
    BAD(s.desc.least = -1, PRT_ERR_VALUE);
    BAD(s.objects[1].diffuse.g = -1, PRT_ERR_VALUE);
    BAD(s.objects[1].specular.b = 2, PRT_ERR_VALUE);
    BAD(s.objects[1].transmissive.r = 2, PRT_ERR_VALUE);
    BAD(s.objects[1].refraction = -1, PRT_ERR_VALUE);
    BAD(open[MANY - 1] = 2, PRT_ERR_VALUE);
    BAD(open[MANY - 1] = -1, PRT_ERR_VALUE);
    open[MANY - 1] = 1;
    BAD(points[3].normal.x = 9, PRT_ERR_VALUE);
    scatter(MANY, points);
#ifndef __FAST_MATH__
    BAD(s.objects[1].diffuse.r = (prt_real)NAN, PRT_ERR_VALUE);
    BAD(s.objects[1].specular.r = (prt_real)NAN, PRT_ERR_VALUE);
    BAD(s.objects[1].transmissive.g = (prt_real)INFINITY, PRT_ERR_VALUE);
    BAD(s.objects[1].refraction = (prt_real)INFINITY, PRT_ERR_VALUE);
    BAD(s.desc.bias = (prt_real)NAN, PRT_ERR_VALUE);
    BAD(points[3].position.x = (prt_real)NAN, PRT_ERR_VALUE);
    scatter(MANY, points);
#endif
    lively(&s);
    s.objects[1].triangles = triangles;
    s.objects[1].primitive_count = 1;
    assert_int_equal(prt_bake_vo(&s.desc, 2, points, open, 0, 1, rows, o), PRT_ERR_COUNT);      /* corner 2 of 2 points */
    assert_int_equal(prt_bake_vo(NULL, MANY, points, open, 0, 1, rows, o), PRT_ERR_NULL);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, NULL, open, 0, 1, rows, o), PRT_ERR_NULL);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 0, 1, NULL, o), PRT_ERR_NULL);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 0, 1, rows, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, -1, 1, rows, o), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 1, MANY, rows, o), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_vo(&s.desc, -1, points, open, 0, 0, rows, o), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 0, 0, rows, o), PRT_OK);
    assert_int_equal(s.w.calls, 0);
    s.desc.object_count = 0;                                   /* an empty scene has no hits to speak of */
    s.w.count = 0;
    assert_memory_equal(o, untouched, sizeof o);
    assert_int_equal(prt_bake_vo(&s.desc, MANY, points, open, 0, 1, rows, o), PRT_OK);
    assert_int_equal(rows[0].count, 0);
}

/* ---- splitting ---- */

enum { PATCHES = 5, CELLS = 6 };                               /* patches of CELLS x CELLS quads, far from each other */
static prt_vec3 patch_vertices[PATCHES * (CELLS + 1) * (CELLS + 1)];
static uint32_t patch_triangles[PATCHES * CELLS * CELLS * 2 * 3];
static prt_mesh patches(double scale, double shift) {
    prt_mesh m;
    int p, i, j, at = 0;
    memset(&m, 0, sizeof m);
    for (p = 0; p < PATCHES; p++)
        for (i = 0; i <= CELLS; i++)
            for (j = 0; j <= CELLS; j++)
                patch_vertices[(p * (CELLS + 1) + i) * (CELLS + 1) + j] =
                    vec3(v(scale * (20 * p + i) + shift, scale * (15 * (p % 2) + j), scale * p * p));
    for (i = 0; i < CELLS; i++)                                /* faces of all patches mixed */
        for (j = 0; j < CELLS; j++)
            for (p = 0; p < PATCHES; p++) {
                uint32_t a = (uint32_t)((p * (CELLS + 1) + i) * (CELLS + 1) + j), b = a + 1, c = a + CELLS + 1, d = c + 1;
                uint32_t two[6];
                two[0] = a; two[1] = c; two[2] = b; two[3] = b; two[4] = c; two[5] = d;
                memcpy(patch_triangles + at, two, sizeof two);
                at += 6;
            }
    m.vertex_count = PATCHES * (CELLS + 1) * (CELLS + 1);
    m.positions = patch_vertices;
    m.triangle_count = PATCHES * CELLS * CELLS * 2;
    m.triangles = patch_triangles;
    return m;
}

/* Patches far apart become the groups, at any scale, numbered by their first face; with more groups none mixes patches. */
static void patches_become_groups(void **state) {
    static const double scales[] = { 1, 1e-15, 1e15 };
    static int groups[PATCHES * CELLS * CELLS * 2], owner[64];
    int s, k, count, made;
    (void)state;
    for (s = 0; s < 3; s++) {
        prt_mesh m = patches(scales[s], s == 0 ? 3 : 0);
        assert_int_equal(prt_vo_split(&m, PATCHES, 0, groups, &made), PRT_OK);
        assert_int_equal(made, PATCHES);
        for (k = 0; k < m.triangle_count; k++) assert_int_equal(groups[k], k / 2 % PATCHES);
        for (count = PATCHES; count <= 40; count += 5) {
            assert_int_equal(prt_vo_split(&m, count, 0, groups, &made), PRT_OK);
            assert_int_equal(made, count);
            memset(owner, -1, sizeof owner);
            for (k = 0; k < m.triangle_count; k++) {
                int patch = k / 2 % PATCHES;
                assert_true(groups[k] >= 0 && groups[k] < made);
                if (owner[groups[k]] < 0) owner[groups[k]] = patch;
                assert_int_equal(owner[groups[k]], patch);
            }
        }
        assert_int_equal(prt_vo_split(&m, 1, 0, groups, &made), PRT_OK);
        assert_int_equal(made, 1);
        assert_int_equal(prt_vo_split(&m, 100000, 0, groups, &made), PRT_OK);
        assert_true(made <= m.triangle_count && made > m.triangle_count / 2);
    }
}

/* The walls of a thin box belong together by place, and apart by where they face. */
static void faces_that_look_apart(void **state) {
    prt_vec3 positions[8];
    static const uint32_t walls[] = { 0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7 };
    int groups[4], made, k;
    prt_mesh m;
    (void)state;
    memset(&m, 0, sizeof m);
    for (k = 0; k < 8; k++) positions[k] = vec3(v(k & 1 ? 2 : 0, k & 2 ? 1 : 0, k & 4 ? .01 : 0));
    m.vertex_count = 8; m.positions = positions; m.triangle_count = 4; m.triangles = walls;
    assert_int_equal(prt_vo_split(&m, 2, 1, groups, &made), PRT_OK);
    assert_int_equal(made, 2);
    assert_int_equal(groups[0], 0); assert_int_equal(groups[1], 0); assert_int_equal(groups[2], 1); assert_int_equal(groups[3], 1);
    assert_int_equal(prt_vo_split(&m, 2, 0, groups, &made), PRT_OK);
    assert_int_equal(made, 2);
    assert_true(groups[0] != groups[1] && groups[2] != groups[3]);
}

static void bad_splits(void **state) {
    static int groups[PATCHES * CELLS * CELLS * 2];
    prt_mesh m = patches(1, 0);
    prt_vec3 same[3];
    static const uint32_t flat[] = { 0, 1, 2, 2, 1, 0 };
    int made = 77;
    (void)state;
    groups[0] = 77;
    assert_int_equal(prt_vo_split(NULL, 2, 0, groups, &made), PRT_ERR_NULL);
    assert_int_equal(prt_vo_split(&m, 2, 0, NULL, &made), PRT_ERR_NULL);
    assert_int_equal(prt_vo_split(&m, 2, 0, groups, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_split(&m, 0, 0, groups, &made), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_split(&m, -1, 0, groups, &made), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_split(&m, 2, -1, groups, &made), PRT_ERR_VALUE);
    assert_int_equal(prt_vo_split(&m, 2, 2, groups, &made), PRT_ERR_VALUE);
    m.vertex_count = 3;
    assert_int_equal(prt_vo_split(&m, 2, 0, groups, &made), PRT_ERR_COUNT);
    m = patches(1, 0);
#ifndef __FAST_MATH__
    assert_int_equal(prt_vo_split(&m, 2, (prt_real)NAN, groups, &made), PRT_ERR_VALUE);
    patch_vertices[5].y = (prt_real)INFINITY;
    assert_int_equal(prt_vo_split(&m, 2, 0, groups, &made), PRT_ERR_VALUE);
    m = patches(1, 0);
#endif
    memory_hook.fail = 1;
    assert_int_equal(prt_vo_split(&m, 2, 0, groups, &made), PRT_ERR_MEMORY);
    memory_hook.fail = 0;
    assert_int_equal(groups[0], 77);
    same[0] = same[1] = same[2] = vec3(v(1, 2, 3));            /* nothing has an area: one group */
    m.vertex_count = 3; m.positions = same; m.triangle_count = 2; m.triangles = flat;
    assert_int_equal(prt_vo_split(&m, 2, 0, groups, &made), PRT_OK);
    assert_int_equal(made, 1);
    assert_int_equal(groups[0], 0);
    assert_int_equal(groups[1], 0);
    m.triangle_count = 0;
    assert_int_equal(prt_vo_split(&m, 2, 0, NULL, &made), PRT_OK);
    assert_int_equal(made, 0);
}

/* ---- shadows against the truth ---- */

/* A bar of 12 balls over a floor, under a light that stands aside: the share of the light that reaches each of 16 x 16 points,
   by both laws, against a ray to the light. From two occluders on splitting helps the cap law; the sine law it does not. */
enum { BALLS = 12, SIDE = 16 };
static double shadow_error(setting *s, const prt_point *points, prt_vec3 light, const unsigned char *blocked, int law) {
    static prt_vo_occluder o[SIDE * SIDE * BALLS];
    static prt_vo_row rows[SIDE * SIDE];
    static int first[SIDE * SIDE + 1];
    static prt_rgb out[SIDE * SIDE];
    static prt_vo_point at[SIDE * SIDE];
    prt_vo_params params;
    prt_point_light l;
    double sum = 0;
    int k, n = SIDE * SIDE;
    memset(&params, 0, sizeof params);
    memset(at, 0, sizeof at);
    params.law = law;
    params.off = PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS;
    l.position = light;
    l.color = rgb(1, 1, 1);
    assert_int_equal(prt_bake_vo(&s->desc, n, points, NULL, 0, n, rows, o), PRT_OK);
    assert_int_equal(prt_vo_compact(BALLS, n, rows, o, first), PRT_OK);
    for (k = 0; k < n; k++) { at[k].position = points[k].position; at[k].normal = points[k].normal; at[k].diffuse = rgb(1, 1, 1); }
    assert_int_equal(prt_vo_shade_n(&params, n, at, light, first, o, 1, &l, out), PRT_OK);
    for (k = 0; k < n; k++) {
        v3 to = unit(along(d3(light), -1, d3(points[k].position)));
        sum += pow((double)out[k].r / to.z - (blocked[k] ? 0 : 1), 2);
    }
    return sqrt(sum / n);
}
static void shadows_against_the_truth(void **state) {
    static const int counts[] = { 1, 2, 3, 4, 6, 12 };
    static prt_point points[SIDE * SIDE];
    static unsigned char blocked[SIDE * SIDE];
    static int groups[BALLS];
    prt_vec3 corners[3 * BALLS], light = vec3(v(2, 3, 6));
    uint32_t faces[3 * BALLS];
    prt_mesh bar;
    setting s;
    double last = 1, sine = 0;
    int k, i, made;
    (void)state;
    begin(&s, 1);
    for (k = 0; k < BALLS; k++) {
        ball(&s, 0, v(.45 * (k - 5.5), 0, 1.2 + .1 * (k % 3)), .3);
        s.w.shapes[k].primitive = k;
        for (i = 0; i < 3; i++) {
            faces[3 * k + i] = (uint32_t)(3 * k + i);
            corners[3 * k + i] = vec3(along(s.w.shapes[k].centre, .1, v(i == 1, i == 2, 0)));
        }
    }
    for (k = 0; k < SIDE * SIDE; k++) {
        v3 at = v(7. * (k % SIDE) / (SIDE - 1) - 3.5, 4. * (k / SIDE) / (SIDE - 1) - 2.5, 0), to = along(d3(light), -1, at);
        prt_ray ray;
        points[k].position = vec3(at);
        points[k].normal = vec3(v(0, 0, 1));
        ray.origin = vec3(at); ray.dir = vec3(unit(to)); ray.tmin = 0; ray.tmax = 100;
        blocked[k] = 0;
        world_occluded(&s.w, 1, &ray, &blocked[k]);
    }
    memset(&bar, 0, sizeof bar);
    bar.vertex_count = 3 * BALLS; bar.positions = corners; bar.triangle_count = BALLS; bar.triangles = faces;
    s.desc.samples = 256;
    s.desc.max_occluders = BALLS;
    s.objects[0].primitive_count = BALLS;
    s.objects[0].groups = groups;
    for (i = 0; i < 6; i++) {
        double round_cap;
        assert_int_equal(prt_vo_split(&bar, counts[i], 0, groups, &made), PRT_OK);
        assert_int_equal(made, counts[i]);
        s.objects[0].group_count = made;
        sine = shadow_error(&s, points, light, blocked, PRT_VO_SINE);
        round_cap = shadow_error(&s, points, light, blocked, PRT_VO_CAP);
        printf("bar of %d balls as %2d occluders: RMSE of the shadow %.3f by the sine, %.3f by the cap\n", (int)BALLS, made, sine, round_cap);
        if (made > 2) { assert_at_most(round_cap, last); assert_at_most(round_cap, sine); }
        last = round_cap;
    }
    assert_at_most(last, .6 * sine);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ball_has_its_closed_form),
        cmocka_unit_test(a_glass_ball_bends_as_snell_says),
        cmocka_unit_test(a_slab_turns_nothing),
        cmocka_unit_test(total_internal_reflection),
        cmocka_unit_test(bending_one_ray),
        cmocka_unit_test(ambient_occlusion),
        cmocka_unit_test(diffuse_normals_are_damped),
        cmocka_unit_test(closed_mirrors_do_not_count),
        cmocka_unit_test(opaque_things_end_caustics),
        cmocka_unit_test(only_what_the_scene_needs),
        cmocka_unit_test(the_strongest_are_kept),
        cmocka_unit_test(rows_are_compacted),
        cmocka_unit_test(ranges_and_threads_give_the_same_bits),
        cmocka_unit_test(progress_and_cancel),
        cmocka_unit_test(memory_is_counted),
        cmocka_unit_test(forged_hits_are_refused),
        cmocka_unit_test(failing_callbacks),
        cmocka_unit_test(patches_become_groups),
        cmocka_unit_test(faces_that_look_apart),
        cmocka_unit_test(bad_splits),
        cmocka_unit_test(shadows_against_the_truth),
        cmocka_unit_test(bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
