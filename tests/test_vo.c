/* >>vo: shading from vector occluders against the formulas of the header in double, closed forms, limits, continuity,
   bit equality of batches, bad input. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "geometry.h"
#include <float.h>

/* ---- random scenes ---- */

static prt_vec3 noise_place(double size) { return vec3(size * (uniform() - .5), size * (uniform() - .5), size * (uniform() - .5)); }
static prt_rgb noise_color(void) { double r = uniform(), g = uniform(); return rgb(r, g, uniform()); }
static prt_vo_point noise_point(void) {
    prt_vo_point p;
    p.position = noise_place(2); p.normal = random_direction();
    p.diffuse = noise_color(); p.specular = noise_color(); p.emissive = noise_color();
    p.shininess = (prt_real)(1 + 9 * uniform());
    return p;
}
static prt_vo_occluder noise_occluder(void) {
    prt_vo_occluder o;
    o.position = noise_place(6); o.occlusion = random_direction(); o.caustic = random_direction();
    o.transmissive = noise_color();
    o.diffuse_normal = scaled(random_direction(), uniform()); o.specular_normal = scaled(random_direction(), uniform());
    o.diffuse = noise_color(); o.specular = noise_color();
    o.form_factor = (prt_real)uniform(); o.caustic_factor = (prt_real)uniform();
    if (uniform() < .5) o.transmissive = rgb(0, 0, 0);
    return o;
}
static prt_point_light noise_light(void) {
    prt_point_light l;
    l.position = noise_place(20); l.color = noise_color();
    return l;
}

/* ---- the model, as written in the header, in double ---- */

typedef struct v3 { double c[3]; } v3;
static v3 d3(prt_vec3 v) { v3 r; r.c[0] = (double)v.x; r.c[1] = (double)v.y; r.c[2] = (double)v.z; return r; }
static v3 c3(prt_rgb v) { v3 r; r.c[0] = (double)v.r; r.c[1] = (double)v.g; r.c[2] = (double)v.b; return r; }
static double dot3(v3 a, v3 b) { return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2]; }
static v3 minus(v3 a, v3 b) { int k; for (k = 0; k < 3; k++) a.c[k] -= b.c[k]; return a; }
static v3 unit(v3 a) {
    double length = sqrt(dot3(a, a));
    int k;
    for (k = 0; k < 3; k++) a.c[k] = length > 0 ? a.c[k] / length : 0;
    return a;
}
static v3 mirrored(v3 a, v3 n) {
    double along = 2 * dot3(a, n);
    int k;
    for (k = 0; k < 3; k++) a.c[k] -= along * n.c[k];
    return a;
}
static double positive(double v) { return v > 0 ? v : 0; }
static v3 cross(v3 a, v3 b) {
    v3 r;
    int k;
    for (k = 0; k < 3; k++) r.c[k] = a.c[(k + 1) % 3] * b.c[(k + 2) % 3] - a.c[(k + 2) % 3] * b.c[(k + 1) % 3];
    return r;
}
static double sine2(v3 d, v3 l) { return dot3(d, l) <= 0 ? 1 : dot3(cross(d, l), cross(d, l)) / dot3(d, d); }
static double or_default(prt_real v, double standard) { return (double)v != 0 ? (double)v : standard; }

/* steep: by how much the result changes, relatively, for a change of the directions (and of F/cosine) by 1. */
static double model_block(const prt_vo_params *q, const prt_vo_point *p, const prt_vo_occluder *o, v3 l, double *steep) {
    double f = (double)o->form_factor, cosine = dot3(d3(p->normal), d3(o->occlusion)), cap, light, least, apart, u, area, s;
    *steep = 0;
    if ((q->off & PRT_VO_NO_SHADOW) || !(dot3(d3(o->occlusion), d3(o->occlusion)) > 0) || !(f > 0)) return 1;
    s = sine2(d3(o->occlusion), l);
    *steep = 2 * or_default(q->shadow_strength, 1.5) * f / sqrt(s);
    if (q->law != PRT_VO_CAP) return pow(s, or_default(q->shadow_strength, 1.5) * f);
    s = f < cosine ? f / cosine : 1;
    cap = 2 * sin(asin(sqrt(s)) / 2);
    light = 2 * sin(or_default(q->light_angle, pi / 36) / 2);
    least = cap < light ? cap : light;
    apart = sqrt(dot3(minus(d3(o->occlusion), l), minus(d3(o->occlusion), l)));
    u = (cap + light - apart) / (2 * least);
    u = u < 0 ? 0 : u > 1 ? 1 : u;
    *steep = s < 1 ? 6 * u * (1 - u) / least / sqrt(1 - s) : 6 * u * (1 - u) / least;
    area = cap < light ? cap / light : 1;
    apart = cap < light ? cap / light : light / cap;
    u = u * u * (3 - 2 * u) + u * (1 - u) * (.2 * (1 - 2 * u) * (1 - apart) - 1.4 * apart * u * u);
    *steep /= 1 - area * area * u + 1e-9;
    return 1 - area * area * u;
}
static double model_focus(const prt_vo_params *q, const prt_vo_occluder *o, v3 l, double *steep) {
    double s0 = sin(or_default(q->caustic_angle, pi / 180)), s = sine2(d3(o->caustic), l), f = (double)o->caustic_factor;
    *steep = 0;
    if ((q->off & PRT_VO_NO_CAUSTIC) || !(dot3(d3(o->caustic), d3(o->caustic)) > 0) || !(f > 0)) return 1;
    *steep = 2 * or_default(q->caustic_strength, .5) * f / sqrt(s > s0 * s0 ? s : s0 * s0);
    return pow(s > s0 * s0 ? s : s0 * s0, -or_default(q->caustic_strength, .5) * f);
}

/* The exit radiance, and in size[] the sum of the magnitudes of all terms, direct light times (1 + steepness of factors). */
static v3 model(const prt_vo_params *q, const prt_vo_point *p, prt_vec3 eye, int occluders, const prt_vo_occluder *o,
                int lights, const prt_point_light *light, v3 *size) {
    v3 x = d3(p->position), n = d3(p->normal), r = mirrored(unit(minus(x, d3(eye))), n), out = c3(p->emissive);
    double gloss = or_default(q->gloss, 8), dd = or_default(q->dd, 1), ds = or_default(q->ds, 1), ss = or_default(q->ss, 1);
    int j, k, c;
    *size = out;
    for (j = 0; j < lights; j++) {
        v3 l = unit(minus(d3(light[j].position), x)), color = c3(light[j].color), factor;
        double steep = 1, one;
        for (c = 0; c < 3; c++) factor.c[c] = 1;
        for (k = 0; k < occluders; k++) {
            v3 lp = unit(minus(d3(light[j].position), d3(o[k].position))), v = unit(minus(d3(o[k].position), x));
            double specular = sqrt(dot3(d3(o[k].specular_normal), d3(o[k].specular_normal)));
            v3 ns = unit(d3(o[k].specular_normal));
            double block = model_block(q, p, &o[k], l, &one), focus;
            double to_dd = q->off & PRT_VO_NO_DD ? 0 : dd * positive(dot3(d3(o[k].diffuse_normal), lp));
            double to_ds = q->off & PRT_VO_NO_DS ? 0 : ds * specular * pow(positive(dot3(mirrored(v, ns), lp)), gloss);
            double to_ss = q->off & PRT_VO_NO_SS || !(dot3(n, v) > 0) ? 0
                         : ss * specular * positive(dot3(r, v)) * pow(positive(dot3(mirrored(r, ns), lp)), gloss);
            if (q->ss_fade > 0) to_ss *= fmin(1, dot3(n, v) / (double)q->ss_fade);
            steep += one;
            focus = model_focus(q, &o[k], l, &one);
            steep += one;
            for (c = 0; c < 3; c++) {
                double t = c3(o[k].transmissive).c[c], own = c3(p->diffuse).c[c], shiny = c3(p->specular).c[c];
                double terms = color.c[c] * (c3(o[k].diffuse).c[c] * own * to_dd + c3(o[k].specular).c[c] *
                               (own * to_ds + shiny * to_ss));
                factor.c[c] *= (1 - t) * block + t * focus;
                out.c[c] += terms;
                size->c[c] += fabs(terms);
            }
        }
        for (c = 0; c < 3; c++) {
            double direct = c3(p->diffuse).c[c] * positive(dot3(n, l)) +
                            c3(p->specular).c[c] * pow(positive(dot3(r, l)), (double)p->shininess);
            out.c[c] += color.c[c] * direct * factor.c[c];
            size->c[c] += color.c[c] * direct * factor.c[c] * steep;
        }
    }
    for (c = 0; c < 3; c++) out.c[c] = positive(out.c[c]);
    return out;
}

static double worst_error(prt_rgb got, v3 want, v3 size) {     /* in eps of the sum of magnitudes */
    v3 g = c3(got);
    double worst = 0;
    int c;
    for (c = 0; c < 3; c++) {
        double e = fabs(g.c[c] - want.c[c]) / ((double)PRT__EPS * (size.c[c] + 1e-30));
        if (!(e <= worst)) worst = e;
    }
    return worst;
}

enum { OCCLUDERS = 6, LIGHTS = 19, POINTS = 83 };

typedef struct scene {
    prt_vo_params params;
    prt_vec3 eye;
    prt_vo_point points[POINTS];
    int first[POINTS + 1];
    prt_vo_occluder occluders[POINTS * OCCLUDERS];
    prt_point_light lights[LIGHTS];
} scene;

static void noise_scene(scene *s) {
    int k;
    memset(s, 0, sizeof *s);
    s->eye = noise_place(30);
    for (k = 0; k < LIGHTS; k++) s->lights[k] = noise_light();
    for (k = 0; k < POINTS; k++) {
        s->points[k] = noise_point();
        s->first[k + 1] = s->first[k] + (int)(uniform() * (OCCLUDERS + 1));
    }
    for (k = 0; k < s->first[POINTS]; k++) s->occluders[k] = noise_occluder();
}

static const unsigned all_off[] = { 0, PRT_VO_NO_SHADOW, PRT_VO_NO_CAUSTIC, PRT_VO_NO_DD, PRT_VO_NO_DS, PRT_VO_NO_SS,
    PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS, PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS, 31 };

/* Both forms, both laws, each term switched off, other parameters, numbers of lights around the block size. */
static void shading_is_the_model(void **state) {
    static const int light_counts[] = { 0, 1, 3, 7, 8, 9, 16, 19 };
    static prt_rgb out[POINTS], one;
    static scene s;
    double worst = 0, worst_n = 0;
    int k, set;
    (void)state;
    for (set = 0; set < 48; set++) {
        int lights = light_counts[set % 8];
        noise_scene(&s);
        s.params.off = all_off[set % 9];
        s.params.law = set % 2;
        if (set % 5 == 1) { s.params.dd = (prt_real)-.5; s.params.ds = 2; s.params.ss = (prt_real).25; }
        if (set % 5 == 2) { s.params.gloss = (prt_real)3.5; s.params.shadow_strength = 4; s.params.caustic_strength = 1; }
        if (set % 5 == 4) s.params.ss_fade = (prt_real).4;
        if (set % 5 == 3) { s.params.gloss = 13; s.params.caustic_angle = (prt_real).2; s.params.light_angle = (prt_real).4; }
        assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, s.occluders, lights, s.lights, out), PRT_OK);
        for (k = 0; k < POINTS; k++) {
            const prt_vo_occluder *o = s.occluders + s.first[k];
            int count = s.first[k + 1] - s.first[k];
            v3 size, want = model(&s.params, &s.points[k], s.eye, count, o, lights, s.lights, &size);
            double e;
            assert_int_equal(prt_vo_shade(&s.params, &s.points[k], s.eye, count, o, lights, s.lights, &one), PRT_OK);
            e = worst_error(one, want, size);
            if (!(e <= worst)) worst = e;
            e = worst_error(out[k], want, size);
            if (!(e <= worst_n)) worst_n = e;
        }
    }
    printf("largest error in eps of the sum of |terms|: %.1f one by one, %.1f in batches\n", worst, worst_n);
    assert_at_most(worst, 64);
    assert_at_most(worst_n, 64);
}

/* A batch of any length, from any place, at any lane and beside any neighbours gives each point the same bits. */
static void batches_are_bit_equal(void **state) {
    static prt_rgb all[POINTS], part[POINTS];
    static scene s;
    int set, from, count, k;
    (void)state;
    skip_if_fast_math();
    for (set = 0; set < 6; set++) {
        noise_scene(&s);
        s.params.law = set % 2;
        s.params.off = set < 3 ? 0 : PRT_VO_NO_DS | PRT_VO_NO_SS;
        assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, s.occluders, 9, s.lights, all), PRT_OK);
        for (from = 0; from < POINTS; from += 3 + set)
            for (count = 1; count <= 35 && from + count <= POINTS; count += 1 + from % 5) {
                memset(part, 0, sizeof part);
                assert_int_equal(prt_vo_shade_n(&s.params, count, s.points + from, s.eye, s.first + from, s.occluders, 9,
                                                s.lights, part), PRT_OK);
                assert_memory_equal(part, all + from, (size_t)count * sizeof *all);
                for (k = count; k < POINTS; k++) assert_memory_equal(part + k, part + POINTS - 1, sizeof *part);
            }
    }
}

/* A point of a white diffuse floor, one occluder that does nothing yet, a white light. */
typedef struct lone {
    prt_vo_params q;
    prt_vo_point p;
    prt_vo_occluder o;
    prt_point_light l;
} lone;
static lone lone_point(void) {
    lone s;
    memset(&s, 0, sizeof s);
    s.p.normal = vec3(0, 0, 1); s.p.diffuse = rgb(1, 1, 1);
    s.l.color = rgb(1, 1, 1);
    return s;
}
static prt_rgb shade_lone(const lone *s, int batch) {
    static const int first[] = { 0, 1 };
    prt_vec3 eye = vec3(0, 5, 5);
    prt_rgb out;
    assert_int_equal(batch ? prt_vo_shade_n(&s->q, 1, &s->p, eye, first, &s->o, 1, &s->l, &out)
                           : prt_vo_shade(&s->q, &s->p, eye, 1, &s->o, 1, &s->l, &out), PRT_OK);
    return out;
}

/* One opaque occluder, nothing sent: out is the factor times N.l. */
static double shadow(const prt_vo_params *q, double f, prt_vec3 occlusion, prt_vec3 light, int batch) {
    lone s = lone_point();
    prt_rgb out;
    s.q = *q;
    s.o.position = vec3(0, 0, 1); s.o.occlusion = occlusion; s.o.form_factor = (prt_real)f;
    s.l.position = light;
    out = shade_lone(&s, batch);
    assert_memory_equal(&out.r, &out.g, sizeof out.r);
    return (double)out.r;
}

/* sin(45 degrees)^(2 N F) at F = 1/4: .84 at N = 1, a half at N = 4; the thesis' text to figure 7.7 gives a half to 5.5,
   where the formula gives .386. */
static void the_sine_law(void **state) {
    prt_vo_params q;
    int batch;
    (void)state;
    memset(&q, 0, sizeof q);
    for (batch = 0; batch < 2; batch++) {
        q.shadow_strength = 1;
        assert_near(shadow(&q, .25, vec3(1, 0, 0), vec3(3, 0, 3), batch), sqrt(.5) * pow(.5, .25), 4 * PRT__EPS);
        q.shadow_strength = 4;
        assert_near(shadow(&q, .25, vec3(1, 0, 0), vec3(3, 0, 3), batch), sqrt(.5) * .5, 4 * PRT__EPS);
        q.shadow_strength = (prt_real)5.5;
        assert_near(shadow(&q, .25, vec3(1, 0, 0), vec3(3, 0, 3), batch), sqrt(.5) * pow(.5, 1.375), 4 * PRT__EPS);
        assert_near(pow(.5, 1.375), .386, 5e-4);
        assert_near(shadow(&q, .25, vec3(0, 0, 1), vec3(0, 0, 3), batch), 0, 0);            /* on the axis: all */
        assert_near(shadow(&q, 1e-6, vec3(0, 0, 1), vec3(0, 0, 3), batch), 0, 0);           /* ... however small */
        assert_near(shadow(&q, .25, vec3(-1, 0, 0), vec3(3, 0, 3), batch), sqrt(.5), 4 * PRT__EPS);  /* behind: nothing */
        assert_near(shadow(&q, 0, vec3(0, 0, 1), vec3(0, 0, 3), batch), 1, 4 * PRT__EPS);   /* F of 0, and below */
        assert_near(shadow(&q, -1, vec3(0, 0, 1), vec3(0, 0, 3), batch), 1, 4 * PRT__EPS);
        assert_near(shadow(&q, 1, vec3(0, 0, 0), vec3(0, 0, 3), batch), 1, 4 * PRT__EPS);   /* no direction */
        assert_near(shadow(&q, 7, vec3(1, 0, 0), vec3(3, 0, 3), batch), sqrt(.5) * pow(.5, 38.5), 4 * PRT__EPS);
        assert_near(shadow(&q, .25, vec3(1, 0, 0), vec3(0, 0, 0), batch), 0, 0);            /* the light on the point */
        assert_near(shadow(&q, .25, vec3(40, 0, 0), vec3(3, 0, 3), batch), sqrt(.5) * pow(.5, 1.375), 4 * PRT__EPS);
    }
}

/* sin^2 as 1 - (d.l)^2, as the thesis has it, of vectors that are aligned: negative, where rounding made d.l exceed 1. Ours
   is 0 up to rounding, and never below. */
static void aligned_vectors_have_no_negative_sine(void **state) {
    int k, negative = 0, n = 5000;
    (void)state;
    for (k = 0; k < n; k++) {
        prt_vec3 d = random_direction(), l = vec3(3 * (double)d.x, 3 * (double)d.y, 3 * (double)d.z);
        prt_real c, length, ours[PRT__LANES];
        prt__vec a[3], b[3];
        int i;
        d = prt__direction(d, &length);
        l = prt__direction(l, &length);
        c = prt__dot3(d, l);
        negative += 1 - c * c < 0;
        for (i = 0; i < 3; i++) { a[i] = prt__vec_set((&d.x)[i]); b[i] = prt__vec_set((&l.x)[i]); }
        prt__vec_store(ours, prt__vo_lanes_sin2(a, b));
        assert_true(ours[0] >= 0 && prt__vo_sin2(d, l) >= 0);
        assert_at_most(ours[0], 4 * PRT__EPS * PRT__EPS);
        assert_at_most(prt__vo_sin2(d, l), 4 * PRT__EPS * PRT__EPS);
    }
    printf("1 - (d.l)^2 of aligned vectors is negative for %.1f %%\n", 100.0 * negative / n);
}

/* A light on an occluder's position sends nothing by its way; one on the point sends nothing straight; one behind the
   occluder is shadowed, one behind the point does not reach it. */
static void lights_in_odd_places(void **state) {
    int batch;
    (void)state;
    for (batch = 0; batch < 2; batch++) {
        prt_vec3 places[4];
        double want[4];
        int k;
        places[0] = vec3(0, 3, 4);  want[0] = .8;              /* on the occluder: only straight, and 37 degrees aside */
        places[1] = vec3(0, 0, 0);  want[1] = .25 * .6;        /* on the point: only by way of the occluder */
        places[2] = vec3(0, 0, 9);  want[2] = 0;               /* behind what hides it, on the axis; DD below its horizon */
        places[3] = vec3(0, 0, -9); want[3] = .25 * 13 / sqrt(178);    /* behind the point */
        for (k = 0; k < 4; k++) {
            lone s = lone_point();
            prt_rgb out;
            s.o.position = vec3(0, 3, 4); s.o.diffuse = rgb(1, 1, 1); s.o.specular = rgb(1, 1, 1);
            s.o.diffuse_normal = k == 1 ? vec3(0, -.25, 0) : vec3(0, 0, -.25);
            s.o.occlusion = k == 2 ? vec3(0, 0, 1) : vec3(0, -1, 0); s.o.form_factor = (prt_real).5;
            s.l.position = places[k];
            assert_near(shade_lone(&s, batch).r, want[k], 8 * PRT__EPS);
            assert_int_equal(prt_vo_shade(&s.q, &s.p, vec3(1, 1, 1), 0, NULL, 1, &s.l, &out), PRT_OK);  /* no occluders */
            assert_near(out.r, k == 0 ? .8 : k == 2 ? 1 : 0, 4 * PRT__EPS);
        }
    }
}

/* Caps against the share of a disc behind a disc, the area of their lens. */
static double disc_behind_disc(double light, double cap, double apart) {
    double x, y;
    if (apart >= light + cap) return 0;
    if (apart <= fabs(light - cap)) return cap < light ? cap * cap / (light * light) : 1;
    x = (apart * apart + light * light - cap * cap) / (2 * apart * light);
    y = (apart * apart + cap * cap - light * light) / (2 * apart * cap);
    return (light * light * (acos(x) - x * sqrt(1 - x * x)) + cap * cap * (acos(y) - y * sqrt(1 - y * y))) /
           (pi * light * light);
}
static void the_cap_law(void **state) {
    static const double caps[] = { .02, .1, .3, .9 }, lights[] = { .02, .1, .4 };
    double worst = 0;
    int i, j, k, batch;
    prt_vo_params q;
    (void)state;
    memset(&q, 0, sizeof q);
    q.law = PRT_VO_CAP;
    for (i = 0; i < 4; i++)
        for (j = 0; j < 3; j++) {
            q.light_angle = (prt_real)lights[j];
            for (k = 0; k <= 40; k++)
                for (batch = 0; batch < 2; batch++) {
                    double t = 1.5 * k / 40 * (caps[i] + lights[j]), reach = 2 * sin(t / 2);
                    double a = 2 * sin(caps[i] / 2), b = 2 * sin(lights[j] / 2), share = disc_behind_disc(b, a, reach), got;
                    if (t > 1.5) continue;
                    got = shadow(&q, sin(caps[i]) * sin(caps[i]), vec3(0, 0, 1), vec3(9 * sin(t), 0, 9 * cos(t)), batch);
                    got = 1 - got / cos(t);
                    if (!(fabs(got - share) <= worst)) worst = fabs(got - share);
                    if (t < .98 * fabs(caps[i] - lights[j])) assert_near(got, share, .01);       /* wholly inside */
                    if (reach > a + b) assert_near(got, 0, 1e-4);                             /* wholly outside */
                }
        }
    printf("share of a light behind a cap: within %.3f of the discs' area\n", worst);
    assert_at_most(worst, .0235);
    q.light_angle = 0;
    assert_near(shadow(&q, 1, vec3(0, 0, 1), vec3(0, 0, 2), 0), 0, 0);                         /* F of 1 and above */
    assert_near(shadow(&q, 3, vec3(0, 0, 1), vec3(0, 0, 2), 1), 0, 0);
    assert_near(shadow(&q, 0, vec3(0, 0, 1), vec3(0, 0, 2), 1), 1, 4 * PRT__EPS);
    assert_near(shadow(&q, .5, vec3(0, 0, 0), vec3(0, 0, 2), 1), 1, 4 * PRT__EPS);
}

/* On a caustic's axis the factor is (sin^2 c0)^(-N F), its largest value; outside c0 it is the thesis' formula. */
static void caustics_are_bounded(void **state) {
    int batch, k;
    (void)state;
    for (batch = 0; batch < 2; batch++) {
        double before = 1e30;
        for (k = 0; k <= 900; k++) {
            double angle = k * pi / 1800, s0 = sin(pi / 180), sine = sin(angle) > s0 ? sin(angle) : s0, want, got;
            lone s = lone_point();
            prt_rgb out;
            s.p.normal = vec3(1, 0, 1);
            s.o.caustic = vec3(0, 0, 1); s.o.caustic_factor = (prt_real).5; s.o.transmissive = rgb(1, .5, 0);
            s.o.occlusion = vec3(0, 0, 1); s.o.form_factor = (prt_real).5;
            s.l.position = vec3(7 * sin(angle), 0, 7 * cos(angle));
            out = shade_lone(&s, batch);
            want = (sin(angle) + cos(angle)) * pow(sine, -.5);
            got = (double)out.r;
            assert_near(got, want, want * 64 * PRT__EPS);
            assert_near(out.b, (sin(angle) + cos(angle)) * pow(sin(angle), 1.5), 16 * PRT__EPS);
            assert_near(out.g, ((double)out.r + (double)out.b) / 2, 8 * want * PRT__EPS);
            assert_at_most(got / (sin(angle) + cos(angle)), before * (1 + 64 * PRT__EPS));
            before = got / (sin(angle) + cos(angle));
        }
    }
}

/* SS alone, of an occluder that rises through the horizon, N.v = 0: cut off there, it begins with a jump to what the
   formula gives; with ss_fade it grows from 0, nothing jumps, and it is the same from N.v = ss_fade on. */
static void ss_fades_in(void **state) {
    enum { STEPS = 4000 };
    const double fade = .25;
    int batch, k;
    (void)state;
    for (batch = 0; batch < 2; batch++) {
        double jump = 0, step = 0, plain = 0, faded = 0;
        lone s = lone_point();
        s.p.diffuse = rgb(0, 0, 0); s.p.specular = rgb(1, 1, 1); s.p.shininess = 4;
        s.o.specular = rgb(1, 1, 1); s.o.specular_normal = vec3(0, .5, 0);
        s.l.position = vec3(0, 40, 36);                        /* behind the mirrored eye: nothing comes straight */
        for (k = 0; k <= STEPS; k++) {
            double angle = pi * (k - STEPS / 2) / STEPS, height = sin(angle), was = plain, was_faded = faded;
            s.o.position = vec3(0, -4 * cos(angle), 4 * height);
            s.q.ss_fade = 0;
            plain = (double)shade_lone(&s, batch).r;
            s.q.ss_fade = (prt_real)fade;
            faded = (double)shade_lone(&s, batch).r;
            assert_near(faded, plain * fmin(1, positive(height) / fade), 4 * PRT__EPS);
            if (height <= 0) assert_near(plain, 0, 0);
            if (k == 0) continue;
            jump = fmax(jump, fabs(plain - was));
            step = fmax(step, fabs(faded - was_faded));
        }
        printf("SS at N.v = 0: jumps to %.3f; with ss_fade no step above %.5f\n", jump, step);
        assert_near(jump, .5 * sqrt(.5) * pow((44 + 36) / sqrt(2 * (44. * 44 + 36. * 36)), 8), 1e-3);
        assert_at_most(step, 10. / STEPS);
    }
}

/* Sweeps of light and eye through everything: between two steps of 1e-4 nothing jumps by more than a slope allows. */
static void nothing_jumps(void **state) {
    enum { STEPS = 2000 };
    static const int counts[] = { 0, OCCLUDERS };
    static scene s;
    int set, k, c, law, batch;
    (void)state;
    for (set = 0; set < 12; set++)
        for (law = 0; law < 2; law++) {
            prt_vec3 a, b;
            v3 before = { { 0, 0, 0 } };
            noise_scene(&s);
            s.params.law = law;
            s.params.light_angle = (prt_real).3;
            s.params.caustic_angle = (prt_real).1;
            batch = set % 2;
            for (k = 0; k < OCCLUDERS; k++) {                  /* strong enough to matter, wide enough to have slopes */
                s.occluders[k].form_factor = (prt_real)(.7 + .1 * k);
                s.occluders[k].position.z = (prt_real)(3 + k);
                s.points[0].position.z = 0;
            }
            a = noise_place(6); b = noise_place(6);
            a.z = b.z = (prt_real)-2;
            b.z = 2;
            if (set < 3) { a = scaled(s.occluders[0].occlusion, 4); b = scaled(a, -.5); b.x += (prt_real).1; }
            for (k = 0; k <= STEPS; k++) {
                double t = (double)k / STEPS;
                prt_vec3 at = vec3((double)a.x * (1 - t) + (double)b.x * t, (double)a.y * (1 - t) + (double)b.y * t,
                                   (double)a.z * (1 - t) + (double)b.z * t);
                prt_rgb out;
                v3 now;
                if (set % 3 == 2) s.eye = at; else s.lights[0].position = at;
                assert_int_equal(batch ? prt_vo_shade_n(&s.params, 1, s.points, s.eye, counts, s.occluders, 3, s.lights, &out)
                                       : prt_vo_shade(&s.params, s.points, s.eye, OCCLUDERS, s.occluders, 3, s.lights, &out),
                                 PRT_OK);
                now = c3(out);
                for (c = 0; c < 3; c++) {
                    double floor = sqrt(dot3(minus(d3(at), d3(s.points[0].position)), minus(d3(at), d3(s.points[0].position))));
                    assert_at_most(now.c[c], 1e6);
                    if (k > 0) assert_at_most(fabs(now.c[c] - before.c[c]), (.04 + .04 / floor) * (1 + now.c[c]));
                }
                before = now;
            }
        }
}

/* Finite whatever is finite: huge and tiny places, colours, normals, exponents and factors. */
static void finite_in_finite_out(void **state) {
    static prt_rgb out[POINTS], one;
    static scene s;
    int set, k, i;
    (void)state;
    skip_if_fast_math();
    for (set = 0; set < 40; set++) {
        prt_real *numbers[3];
        int counts[3];
        noise_scene(&s);
        s.params.law = set % 2;
        numbers[0] = &s.points[0].position.x; counts[0] = POINTS * 16;
        numbers[1] = &s.occluders[0].position.x; counts[1] = POINTS * OCCLUDERS * 26;
        numbers[2] = &s.lights[0].position.x; counts[2] = LIGHTS * 6;
        for (i = 0; i < 3; i++)
            for (k = 0; k < counts[i]; k++) {
                double what = uniform();
                if (uniform() < .9) continue;
                numbers[i][k] = (prt_real)(what < .25 ? 0 : what < .5 ? (double)PRT__REAL_MAX : what < .7 ? -(double)PRT__REAL_MAX
                                           : what < .8 ? (double)PRT__REAL_MIN : what < .9 ? 1e-20 : 1e18);
            }
        if (set % 3 == 0) s.params.gloss = PRT__REAL_MAX;
        if (set % 3 == 1) s.params.caustic_strength = PRT__REAL_MAX;
        if (set % 5 == 0) s.params.shadow_strength = -PRT__REAL_MAX;
        if (set % 7 == 0) s.params.dd = -PRT__REAL_MAX;
        assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, s.occluders, 9, s.lights, out), PRT_OK);
        for (k = 0; k < POINTS; k++) {
            assert_int_equal(prt_vo_shade(&s.params, &s.points[k], s.eye, s.first[k + 1] - s.first[k],
                                          s.occluders + s.first[k], 9, s.lights, &one), PRT_OK);
            for (i = 0; i < 3; i++) {
                assert_at_most(c3(one).c[i], PRT__REAL_MAX);
                assert_at_most(c3(out[k]).c[i], PRT__REAL_MAX);
                assert_true(c3(one).c[i] >= 0 && c3(out[k]).c[i] >= 0);
            }
        }
    }
}

/* NaN anywhere neither stops nor crashes it, and stays with its point. */
static void nan_stays_at_home(void **state) {
    static prt_rgb all[POINTS], out[POINTS];
    static scene s;
    int k;
    (void)state;
    skip_if_fast_math();
    noise_scene(&s);
    assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, s.occluders, 9, s.lights, all), PRT_OK);
    for (k = 0; k < 16; k++) (&s.points[k].position.x)[k] = (prt_real)NAN;
    for (k = 0; k < 26 && k < s.first[16]; k++) (&s.occluders[k].position.x)[k] = (prt_real)NAN;
    assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, s.occluders, 9, s.lights, out), PRT_OK);
    assert_memory_equal(out + 16, all + 16, (POINTS - 16) * sizeof *all);
}

/* A negative weight of DD drains colour: never below black. */
static void drained_colour_ends_at_black(void **state) {
    static scene s;
    prt_rgb plain, drained, black;
    double lowest = 1;
    int k;
    (void)state;
    for (k = 0; k < POINTS; k++) {
        if (k == 0) noise_scene(&s);
        memset(&s.points[k].emissive, 0, sizeof s.points[k].emissive);
        s.params.dd = 0;
        prt_vo_shade(&s.params, &s.points[k], s.eye, OCCLUDERS, s.occluders, LIGHTS, s.lights, &plain);
        s.params.dd = (prt_real)-.2;
        prt_vo_shade(&s.params, &s.points[k], s.eye, OCCLUDERS, s.occluders, LIGHTS, s.lights, &drained);
        s.params.dd = -1000;
        prt_vo_shade(&s.params, &s.points[k], s.eye, OCCLUDERS, s.occluders, LIGHTS, s.lights, &black);
        assert_at_most(drained.r, plain.r);
        assert_true(black.r >= 0 && black.g >= 0 && black.b >= 0);
        if ((double)black.r < lowest) lowest = (double)black.r;
    }
    assert_near(lowest, 0, 0);
}

/* ---- packing ---- */

static double angle_between(prt_vec3 a, prt_vec3 b) {
    v3 x = unit(d3(a)), y = unit(d3(b)), n = cross(x, y);
    return atan2(sqrt(dot3(n, n)), dot3(x, y)) * 180 / pi;
}
static double length_of(prt_vec3 a) { return sqrt(dot3(d3(a), d3(a))); }

/* Half floats against the definition, all of them, and the ties between them. */
static void half_floats(void **state) {
    uint32_t h;
    (void)state;
    for (h = 0; h < 0x7c00u; h++) {
        int e = (int)(h >> 10);
        double value = ldexp((double)(h & 0x3ffu) + (e ? 1024 : 0), (e ? e : 1) - 25), next;
        prt_real lanes[PRT__LANES];
        prt__bits word;
        memset(&word, 0, sizeof word);
        word = word + h;
        prt__vec_store(lanes, prt__vec_of_half(word));
        if (e > 0) assert_near(lanes[0], value, 0);            /* subnormal ones may count as 0 with -ffast-math */
        assert_int_equal(prt__half_of(value), h);
        assert_int_equal(prt__half_of(-value), h ? 0x8000u | h : 0);
        if (h == 0x7bffu) break;
        next = ldexp(1, (e ? e : 1) - 25);
        assert_int_equal(prt__half_of(value + next * .49), h);
        assert_int_equal(prt__half_of(value + next * .5), h + (h & 1));
        assert_int_equal(prt__half_of(value + next * .51), h + 1);
    }
}

/* Errors of everything packed, and what the header promises. */
static void packing_keeps_what_it_says(void **state) {
    double occlusion = 0, normal = 0, factor = 0, color = 0, place = 0;
    prt_vec3 at = vec3(3, -2, 1);
    int k, c;
    (void)state;
    assert_int_equal(sizeof(prt_vo_packed), 40);
    assert_int_equal(sizeof(prt_vo_packed_diffuse), 20);
    assert_true(5013 * 5 * sizeof(prt_vo_packed_diffuse) <= 1.03e6 / 2);   /* half of what the thesis' table 7.1 has */
    assert_true(5013 * 5 * sizeof(prt_vo_packed) <= 2.05e6 / 2);
    for (k = 0; k < 6000; k++) {
        prt_vo_occluder o = noise_occluder(), back, half;
        prt_vo_packed packed;
        prt_vo_packed_diffuse packed_diffuse;
        o.form_factor += (prt_real)1e-3; o.caustic_factor += (prt_real)1e-3;   /* half floats below 6e-5 have fewer bits */
        o.diffuse_normal = scaled(random_direction(), 1e-3 + uniform()); o.specular_normal = scaled(random_direction(), 1e-3 + uniform());
        if (k == 0) o.occlusion = vec3(0, 0, -1);
        if (k == 1) o.occlusion = vec3(-1, 0, 0);
        if (k == 2) o.occlusion = vec3(0, 1, 0);
        assert_int_equal(prt_vo_pack(10, at, 1, &o, &packed), PRT_OK);
        assert_int_equal(prt_vo_unpack(10, at, 1, &packed, &back), PRT_OK);
        assert_int_equal(prt_vo_pack_diffuse(10, at, 1, &o, &packed_diffuse), PRT_OK);
        assert_int_equal(prt_vo_unpack_diffuse(10, at, 1, &packed_diffuse, &half), PRT_OK);
        assert_memory_equal(packed_diffuse.word, packed.word, sizeof packed_diffuse);
        assert_memory_equal(&half.position, &back.position, sizeof back.position);
        assert_memory_equal(&half.diffuse_normal, &back.diffuse_normal, sizeof back.position);
        assert_near(length_of(half.specular_normal) + length_of(half.caustic) + (double)half.transmissive.r, 0, 0);
        occlusion = fmax(occlusion, fmax(angle_between(o.occlusion, back.occlusion), angle_between(o.caustic, back.caustic)));
        normal = fmax(normal, angle_between(o.diffuse_normal, back.diffuse_normal));
        normal = fmax(normal, angle_between(o.specular_normal, back.specular_normal));
        assert_near(length_of(back.occlusion), 1, 4 * PRT__EPS);
        factor = fmax(factor, fabs((double)back.form_factor / (double)o.form_factor - 1));
        factor = fmax(factor, fabs((double)back.caustic_factor / (double)o.caustic_factor - 1));
        factor = fmax(factor, fabs(length_of(back.diffuse_normal) / length_of(o.diffuse_normal) - 1));
        factor = fmax(factor, fabs(length_of(back.specular_normal) / length_of(o.specular_normal) - 1));
        for (c = 0; c < 9; c++) {
            double was = (double)((c < 3 ? &o.transmissive.r : &o.diffuse.r) [c < 3 ? c : c - 3]);
            double is = (double)((c < 3 ? &back.transmissive.r : &back.diffuse.r) [c < 3 ? c : c - 3]);
            color = fmax(color, fabs(is - was) / ((sqrt(was) + 1 / 1020.) / 255));
        }
        for (c = 0; c < 3; c++) {
            double d = fabs((double)(&o.position.x)[c] - (double)(&at.x)[c]);
            if (d > 7e-4) place = fmax(place, fabs((double)(&back.position.x)[c] - (double)(&o.position.x)[c]) / d);
        }
    }
    printf("packing: occlusion %.4f degrees, normals %.3f, factors and lengths %.2e, position %.2e, colour %.2f of a step\n",
           occlusion, normal, factor, place, color);
    assert_at_most(occlusion, .004);
    assert_at_most(normal, .06);
    assert_at_most(factor, 1.01 / 2048);
    assert_at_most(place, 1.01 / 2048);
    assert_at_most(color, 1.001);
}

/* Shading packed occluders is shading what they unpack to; and close to shading what was packed. */
static void packed_shading_is_shading(void **state) {
    static prt_rgb plain[POINTS], packed[POINTS], exact[POINTS];
    static prt_vo_packed p[POINTS * OCCLUDERS];
    static prt_vo_packed_diffuse d[POINTS * OCCLUDERS];
    static prt_vo_occluder back[POINTS * OCCLUDERS];
    static scene s;
    double sum = 0, all = 0;
    int k, c, count, form;
    (void)state;
    for (form = 0; form < 4; form++) {
        noise_scene(&s);
        s.params.law = form % 2;
        if (form < 2) s.params.off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS;
        for (k = 0; k < s.first[POINTS] && form < 2; k++) s.occluders[k].transmissive = rgb(0, 0, 0);
        for (k = 0; k < POINTS; k++) {
            count = s.first[k + 1] - s.first[k];
            prt_vo_pack(10, s.points[k].position, count, s.occluders + s.first[k], p + s.first[k]);
            prt_vo_pack_diffuse(10, s.points[k].position, count, s.occluders + s.first[k], d + s.first[k]);
            prt_vo_unpack(10, s.points[k].position, count, p + s.first[k], back + s.first[k]);
        }
        assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, back, 9, s.lights, plain), PRT_OK);
        assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, s.occluders, 9, s.lights, exact), PRT_OK);
        if (form < 2)
            assert_int_equal(prt_vo_shade_packed_diffuse_n(&s.params, 10, POINTS, s.points, s.eye, s.first, d, 9, s.lights,
                                                           packed), PRT_OK);
        else
            assert_int_equal(prt_vo_shade_packed_n(&s.params, 10, POINTS, s.points, s.eye, s.first, p, 9, s.lights,
                                                   packed), PRT_OK);
        for (k = 0; k < POINTS; k++)
            for (c = 0; c < 3; c++) {
                assert_near(c3(packed[k]).c[c], c3(plain[k]).c[c], 4e4 * PRT__EPS * c3(plain[k]).c[c] * (form < 2 ? .01 : 1));
                sum += pow(c3(packed[k]).c[c] - c3(exact[k]).c[c], 2);
                all += pow(c3(exact[k]).c[c], 2);
            }
    }
    printf("packed against plain occluders: %.2e of the light\n", sqrt(sum / all));
    assert_at_most(sqrt(sum / all), 4e-3);
}

static void bad_packing(void **state) {
    static scene s;
    prt_vo_packed p[2], untouched[2];
    prt_vo_packed_diffuse d[2];
    prt_vo_occluder o[2], back[2];
    prt_rgb out[2];
    prt_vec3 at = vec3(0, 0, 0);
    int k;
    (void)state;
    noise_scene(&s);
    o[0] = noise_occluder(); o[1] = noise_occluder();
    memset(p, 7, sizeof p);
    memset(d, 7, sizeof d);
    memcpy(untouched, p, sizeof p);
    assert_int_equal(prt_vo_pack(1, at, -1, o, p), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_pack(1, at, 2, NULL, p), PRT_ERR_NULL);
    assert_int_equal(prt_vo_pack(1, at, 2, o, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_pack(0, at, 2, o, p), PRT_ERR_VALUE);
    assert_int_equal(prt_vo_pack(-1, at, 2, o, p), PRT_ERR_VALUE);
    assert_int_equal(prt_vo_pack((prt_real)1e-7, at, 2, o, p), PRT_ERR_VALUE);        /* too far in this unit */
    assert_int_equal(prt_vo_pack_diffuse(1, at, -1, o, d), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_pack_diffuse(1, at, 2, NULL, d), PRT_ERR_NULL);
    assert_int_equal(prt_vo_unpack(1, at, -1, p, back), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_unpack(1, at, 1, NULL, back), PRT_ERR_NULL);
    assert_int_equal(prt_vo_unpack(1, at, 1, p, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_unpack(0, at, 1, p, back), PRT_ERR_VALUE);
    assert_int_equal(prt_vo_unpack_diffuse(1, at, -1, d, back), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_unpack_diffuse(1, at, 1, NULL, back), PRT_ERR_NULL);
    for (k = 0; k < 26; k++) {                                 /* each number once out of its range, in the second of two */
        prt_vo_occluder bad[2];
        int is_color = (k >= 9 && k < 12) || (k >= 18 && k < 24), is_factor = k >= 24, full = k >= 21 || (k >= 6 && k < 12) ||
                       (k >= 15 && k < 18);
        bad[0] = bad[1] = o[0];
        (&bad[1].position.x)[k] = (prt_real)(is_color ? 1.01 : is_factor ? -.01 : 1e30);
        if (!is_color && !is_factor && k >= 3 && k < 9) continue;                  /* directions may have any length */
        assert_int_equal(prt_vo_pack(1, at, 2, bad, p), PRT_ERR_VALUE);
        assert_int_equal(prt_vo_pack_diffuse(1, at, 2, bad, d), full && k != 24 ? PRT_OK : PRT_ERR_VALUE);
    }
    assert_memory_equal(p, untouched, sizeof p);
    assert_int_equal(prt_vo_shade_packed_n(&s.params, 0, 1, s.points, s.eye, s.first, p, 1, s.lights, out), PRT_ERR_VALUE);
    assert_int_equal(prt_vo_shade_packed_n(&s.params, 1, -1, s.points, s.eye, s.first, p, 1, s.lights, out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_shade_packed_n(NULL, 1, 1, s.points, s.eye, s.first, p, 1, s.lights, out), PRT_ERR_NULL);
    s.first[0] = 0; s.first[1] = 1;
    assert_int_equal(prt_vo_shade_packed_n(&s.params, 1, 1, s.points, s.eye, s.first, NULL, 1, s.lights, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade_packed_diffuse_n(&s.params, 1, 1, s.points, s.eye, s.first, NULL, 1, s.lights, out),
                     PRT_ERR_NULL);
#ifndef __FAST_MATH__
    for (k = 0; k < 26; k++) {
        prt_vo_occluder bad = o[0];
        (&bad.position.x)[k] = (prt_real)NAN;
        assert_int_equal(prt_vo_pack(1, at, 1, &bad, p), PRT_ERR_VALUE);
        (&bad.position.x)[k] = (prt_real)INFINITY;
        assert_int_equal(prt_vo_pack(1, at, 1, &bad, p), PRT_ERR_VALUE);
    }
    assert_int_equal(prt_vo_pack((prt_real)NAN, at, 1, o, p), PRT_ERR_VALUE);
    assert_memory_equal(p, untouched, sizeof p);
#endif
}

/* ---- indexed occluders ---- */

static void assert_rgb_is(prt_rgb got, prt_rgb want) { assert_memory_equal(&got, &want, sizeof got); }
static void assert_vec3_is(prt_vec3 got, prt_vec3 want) { assert_memory_equal(&got, &want, sizeof got); }

/* Back from a form: the same bits, but for factors and directions, which rounding may move. */
static double index_error(const prt_vo_occluder *o, const prt_vo_occluder *back) {
    double worst = fabs((double)back->form_factor - (double)o->form_factor) / (double)o->form_factor;
    v3 turned = minus(unit(d3(o->occlusion)), d3(back->occlusion));
    assert_vec3_is(back->position, o->position);
    assert_vec3_is(back->diffuse_normal, o->diffuse_normal);
    assert_rgb_is(back->diffuse, o->diffuse);
    assert_rgb_is(back->transmissive, o->transmissive);
    return fmax(worst, sqrt(dot3(turned, turned)) / 2) / (double)PRT__EPS;
}

static void indexing_keeps_what_it_says(void **state) {
    static prt_vo_material materials[8];
    double worst = 0;
    int k, count = 0;
    (void)state;
    for (k = 0; k < 4000; k++) {
        prt_vo_occluder o = noise_occluder(), back;
        prt_vo_indexed full;
        prt_vo_indexed_diffuse diffuse;
        double factor;
        o.form_factor = (prt_real)pow(10, -9 * uniform());
        o.caustic_factor = (prt_real)pow(10, -9 * uniform());
        o.occlusion = scaled(o.occlusion, pow(10, 4 * uniform() - 2));
        count = 0;
        assert_int_equal(prt_vo_index(1, &o, 8, materials, &count, &full), PRT_OK);
        assert_int_equal(prt_vo_expand(count, materials, 1, &full, &back), PRT_OK);
        worst = fmax(worst, index_error(&o, &back));
        factor = fabs((double)back.caustic_factor / (double)o.caustic_factor - 1) / (double)PRT__EPS;
        worst = fmax(worst, factor);
        assert_vec3_is(back.specular_normal, o.specular_normal);
        assert_rgb_is(back.specular, o.specular);
        assert_int_equal(prt_vo_index_diffuse(1, &o, 8, materials, &count, &diffuse), PRT_OK);
        assert_int_equal(prt_vo_expand_diffuse(count, materials, 1, &diffuse, &back), PRT_OK);
        worst = fmax(worst, index_error(&o, &back));
        assert_near(length_of(back.specular_normal) + length_of(back.caustic) + (double)back.specular.g, 0, 0);
    }
    printf("indexing: factors and half of the turns within %.2f eps\n", worst);
    assert_at_most(worst, BY_PRECISION(1, 4));
}

/* Materials: one for each set of colours, found again in later calls; what has no direction or no factor loses both. */
static void materials_are_shared(void **state) {
    prt_vo_occluder o[6], back[6];
    prt_vo_material materials[4];
    prt_vo_indexed_diffuse indexed[6];
    int k, count = 0;
    (void)state;
    for (k = 0; k < 6; k++) {
        o[k] = noise_occluder();
        o[k].diffuse = rgb(.25 * (1 + k % 3), .5, .5);
        o[k].transmissive = rgb(0, 0, 0);
    }
    o[4].occlusion = vec3(0, 0, 0);
    o[5].form_factor = 0;
    assert_int_equal(prt_vo_index_diffuse(4, o, 4, materials, &count, indexed), PRT_OK);
    assert_int_equal(count, 3);
    assert_int_equal(prt_vo_index_diffuse(2, o + 4, 4, materials, &count, indexed + 4), PRT_OK);
    assert_int_equal(count, 3);
    for (k = 0; k < 6; k++) assert_int_equal(indexed[k].material, k % 3);
    assert_int_equal(prt_vo_expand_diffuse(count, materials, 6, indexed, back), PRT_OK);
    for (k = 0; k < 6; k++) assert_rgb_is(back[k].diffuse, o[k].diffuse);
    for (k = 4; k < 6; k++) assert_near(length_of(back[k].occlusion) + (double)back[k].form_factor, 0, 0);
}

/* Shading indexed occluders is shading what they expand to, and each point the same bits in any batch. */
static void indexed_shading_is_shading(void **state) {
    enum { MOST = POINTS * OCCLUDERS };
    static prt_rgb plain[POINTS], got[POINTS], part[POINTS];
    static prt_vo_material materials[MOST];
    static prt_vo_indexed full[MOST];
    static prt_vo_indexed_diffuse diffuse[MOST];
    static prt_vo_occluder back[MOST];
    static scene s;
    double worst = 0;
    int form, k;
    (void)state;
    for (form = 0; form < 8; form++) {
        int materials_made = 0, count;
        noise_scene(&s);
        count = s.first[POINTS];
        s.params.law = form % 2;
        if (form & 4) s.params.off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS;
        for (k = 0; k < count && !(form & 2); k++) s.occluders[k].diffuse = rgb(k % 5, k % 7, 1);
        if (form & 4) {
            assert_int_equal(prt_vo_index_diffuse(count, s.occluders, MOST, materials, &materials_made, diffuse), PRT_OK);
            assert_int_equal(prt_vo_expand_diffuse(materials_made, materials, count, diffuse, back), PRT_OK);
            assert_int_equal(prt_vo_shade_indexed_diffuse_n(&s.params, POINTS, s.points, s.eye, s.first, materials_made,
                                                            materials, diffuse, 9, s.lights, got), PRT_OK);
            assert_int_equal(prt_vo_shade_indexed_diffuse_n(&s.params, 30, s.points + 50, s.eye, s.first + 50, materials_made,
                                                            materials, diffuse, 9, s.lights, part), PRT_OK);
        } else {
            assert_int_equal(prt_vo_index(count, s.occluders, MOST, materials, &materials_made, full), PRT_OK);
            assert_int_equal(prt_vo_expand(materials_made, materials, count, full, back), PRT_OK);
            assert_int_equal(prt_vo_shade_indexed_n(&s.params, POINTS, s.points, s.eye, s.first, materials_made, materials,
                                                    full, 9, s.lights, got), PRT_OK);
            assert_int_equal(prt_vo_shade_indexed_n(&s.params, 30, s.points + 50, s.eye, s.first + 50, materials_made,
                                                    materials, full, 9, s.lights, part), PRT_OK);
        }
        for (k = 0; k < POINTS; k++) {
            v3 size, want = model(&s.params, &s.points[k], s.eye, s.first[k + 1] - s.first[k], s.occluders + s.first[k], 9,
                                  s.lights, &size);
            worst = fmax(worst, worst_error(got[k], want, size));
        }
        assert_int_equal(prt_vo_shade_n(&s.params, POINTS, s.points, s.eye, s.first, back, 9, s.lights, plain), PRT_OK);
        for (k = 0; k < POINTS; k++) {
            v3 size;
            model(&s.params, &s.points[k], s.eye, s.first[k + 1] - s.first[k], back + s.first[k], 9, s.lights, &size);
            worst = fmax(worst, worst_error(got[k], c3(plain[k]), size));
        }
#ifndef __FAST_MATH__
        assert_memory_equal(part, got + 50, 30 * sizeof *part);
#endif
    }
    printf("indexed shading: %.1f eps of the sum of |terms|\n", worst);
    assert_at_most(worst, 64);
}

static void bad_indexing(void **state) {
    static scene s;
    prt_vo_occluder o[3], bad;
    prt_vo_material materials[3];
    prt_vo_indexed full[3], untouched[3];
    prt_vo_indexed_diffuse diffuse[3];
    prt_rgb out[2];
    int count = 0, k, none = -1;
    (void)state;
    noise_scene(&s);
    s.first[0] = 0; s.first[1] = 3;
    for (k = 0; k < 3; k++) o[k] = noise_occluder();
    memset(full, 7, sizeof full);
    memset(diffuse, 7, sizeof diffuse);
    memcpy(untouched, full, sizeof full);
    assert_int_equal(prt_vo_index(-1, o, 3, materials, &count, full), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_index(3, o, -1, materials, &count, full), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_index(3, o, 3, materials, &none, full), PRT_ERR_COUNT);
    count = 4;
    assert_int_equal(prt_vo_index(3, o, 3, materials, &count, full), PRT_ERR_COUNT);
    count = 0;
    assert_int_equal(prt_vo_index(3, NULL, 3, materials, &count, full), PRT_ERR_NULL);
    assert_int_equal(prt_vo_index(3, o, 3, NULL, &count, full), PRT_ERR_NULL);
    assert_int_equal(prt_vo_index(3, o, 3, materials, NULL, full), PRT_ERR_NULL);
    assert_int_equal(prt_vo_index(3, o, 3, materials, &count, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_index_diffuse(3, o, 3, materials, &count, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_index(3, o, 2, materials, &count, full), PRT_ERR_CAPACITY);
    assert_int_equal(prt_vo_index_diffuse(3, o, 2, materials, &count, diffuse), PRT_ERR_CAPACITY);
    assert_int_equal(count, 0);
    for (k = 24; k < 26; k++) {                                /* the factors */
        bad = o[0];
        (&bad.position.x)[k] = -1;
        assert_int_equal(prt_vo_index(1, &bad, 3, materials, &count, full), PRT_ERR_VALUE);
        (&bad.position.x)[k] = (prt_real)1.1e15;
        assert_int_equal(prt_vo_index(1, &bad, 3, materials, &count, full), PRT_ERR_VALUE);
    }
#ifndef __FAST_MATH__
    for (k = 0; k < 26; k++) {
        int held = !((k >= 6 && k < 9) || (k >= 15 && k < 18) || (k >= 21 && k < 24) || k == 25);
        bad = o[0];
        (&bad.position.x)[k] = (prt_real)NAN;
        assert_int_equal(prt_vo_index(1, &bad, 3, materials, &count, full), PRT_ERR_VALUE);
        (&bad.position.x)[k] = (prt_real)INFINITY;
        assert_int_equal(prt_vo_index(1, &bad, 3, materials, &count, full), PRT_ERR_VALUE);
        if (held) assert_int_equal(prt_vo_index_diffuse(1, &bad, 3, materials, &count, diffuse), PRT_ERR_VALUE);
    }
#endif
    assert_memory_equal(full, untouched, sizeof full);
    assert_int_equal(count, 0);
    assert_int_equal(prt_vo_index(0, NULL, 0, NULL, &count, NULL), PRT_OK);
    assert_int_equal(prt_vo_index(3, o, 3, materials, &count, full), PRT_OK);
    assert_int_equal(count, 3);
    memset(out, 7, sizeof out);
#define SHADE(n, table, rows) prt_vo_shade_indexed_n(&s.params, 1, s.points, s.eye, s.first, n, table, rows, 1, s.lights, out)
    assert_int_equal(SHADE(-1, materials, full), PRT_ERR_COUNT);
    assert_int_equal(SHADE(2, materials, full), PRT_ERR_COUNT);
    assert_int_equal(SHADE(3, NULL, full), PRT_ERR_NULL);
    assert_int_equal(SHADE(3, materials, NULL), PRT_ERR_NULL);
    full[2].material = -1;
    assert_int_equal(SHADE(3, materials, full), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_expand(3, materials, 3, full, o), PRT_ERR_COUNT);
    full[2].material = 3;
    assert_int_equal(SHADE(3, materials, full), PRT_ERR_COUNT);
    assert_near(out[0].r, out[1].r, 0);
    s.first[1] = 0;                                            /* nothing seen: no table is needed */
    assert_int_equal(SHADE(0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_vo_expand(3, materials, -1, full, o), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_expand(-1, materials, 1, full, o), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_expand(3, NULL, 1, full, o), PRT_ERR_NULL);
    assert_int_equal(prt_vo_expand(3, materials, 1, NULL, o), PRT_ERR_NULL);
    assert_int_equal(prt_vo_expand(3, materials, 1, full, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_expand_diffuse(3, materials, 1, NULL, o), PRT_ERR_NULL);
    assert_int_equal(prt_vo_expand(0, NULL, 0, NULL, NULL), PRT_OK);
}

/* What [Sherif 2013], table 7.1, has for the shapes scene, at 5 occluders for every vertex; half of it packed. Its MB are
   2^20 bytes: 67,244 vectors of 16 bytes are 1.03 of them. What is not packed holds in MB of 10^6 bytes too. */
static void sizes_of_forms(void **state) {
    const double mega = 1e6, mebi = 1048576;
    const int points = 5013, seen = 5 * points;
    int k;
    (void)state;
    assert_near(67244 * 16 / mebi, 1.03, .005);
    if (sizeof(prt_real) == sizeof(float)) {
        assert_int_equal(sizeof(prt_vo_indexed_diffuse), 40);
        assert_int_equal(sizeof(prt_vo_indexed), 76);
        assert_at_most((double)prt_vo_size(PRT_VO_INDEXED_DIFFUSE, points, seen, 10), 1.03 * mega);
        assert_at_most((double)prt_vo_size(PRT_VO_INDEXED, points, seen, 10), 2.05 * mega);
    }
    assert_at_most((double)prt_vo_size(PRT_VO_PACKED_DIFFUSE, points, seen, 0), 1.03 / 2 * mebi);
    assert_at_most((double)prt_vo_size(PRT_VO_PACKED, points, seen, 0), 2.05 / 2 * mega);
    assert_int_equal(prt_vo_size(PRT_VO_PLAIN, 10, 30, 99), 11 * sizeof(int) + 30 * sizeof(prt_vo_occluder));
    assert_int_equal(prt_vo_size(PRT_VO_PACKED, 0, 0, 0), sizeof(int));
    for (k = 0; k < 5; k++) {
        assert_int_equal(prt_vo_size((prt_vo_form)k, -1, 1, 1), 0);
        assert_int_equal(prt_vo_size((prt_vo_form)k, 1, -1, 1), 0);
        assert_int_equal(prt_vo_size((prt_vo_form)k, 1, 1, -1), 0);
    }
    assert_int_equal(prt_vo_size((prt_vo_form)5, 1, 1, 1), 0);
    if (sizeof(size_t) == 4) assert_int_equal(prt_vo_size(PRT_VO_PLAIN, 1, 0x7fffffff, 1), 0);
}

/* ---- waves ---- */

/* One wave along x that pushes along z: its axis is -y; at slope 1 vectors turn by 45 degrees. */
static void waves_bend(void **state) {
    prt_vo_wave w[3];
    prt_vo_occluder o = noise_occluder(), out, twice;
    int k;
    (void)state;
    memset(w, 0, sizeof w);
    w[0].along = vec3(1, 0, 0); w[0].across = vec3(0, 0, 1);
    w[0].amplitude = (prt_real).5; w[0].frequency = 2;
    o.occlusion = vec3(0, 0, 1); o.caustic = vec3(2, 0, 0);
    assert_int_equal(prt_vo_bend(1, w, 0, vec3(0, 9, 9), 1, &o, &out), PRT_OK);
    assert_near(out.occlusion.x, -sqrt(.5), 2 * PRT__EPS); assert_near(out.occlusion.z, sqrt(.5), 2 * PRT__EPS);
    assert_near(out.caustic.x, 2 * sqrt(.5), 4 * PRT__EPS); assert_near(out.caustic.z, 2 * sqrt(.5), 4 * PRT__EPS);
    assert_near(out.occlusion.y, 0, 0);
    out.occlusion = o.occlusion; out.caustic = o.caustic;
    assert_memory_equal(&out, &o, sizeof o);                   /* and nothing else */
    assert_int_equal(prt_vo_bend(1, w, 0, vec3(pi / 2, 0, 0), 1, &o, &out), PRT_OK);   /* where the slope is 0 */
    assert_near(out.occlusion.x, 0, 4 * PRT__EPS);
    assert_int_equal(prt_vo_bend(1, w, (prt_real)(pi / 4), vec3(0, 0, 0), 1, &o, &out), PRT_OK);
    assert_near(out.occlusion.x, 0, 4 * PRT__EPS);
    for (k = 0; k < 50; k++) {                                 /* lengths and angles stay; waves in turn; in place */
        int j;
        for (j = 0; j < 3; j++) {
            prt_vec3 a = random_direction(), b = random_direction();
            v3 n = unit(cross(d3(a), d3(b)));
            w[j].along = a; w[j].across = vec3(n.c[0], n.c[1], n.c[2]);
            w[j].amplitude = (prt_real)uniform(); w[j].frequency = (prt_real)(5 * uniform()); w[j].phase = (prt_real)uniform();
        }
        o = noise_occluder();
        assert_int_equal(prt_vo_bend(3, w, (prt_real)k, vec3(1, 2, 3), 1, &o, &out), PRT_OK);
        assert_near(length_of(out.occlusion), length_of(o.occlusion), 8 * PRT__EPS);
        assert_near(dot3(d3(out.occlusion), d3(out.caustic)), dot3(d3(o.occlusion), d3(o.caustic)), 16 * PRT__EPS);
        twice = o;
        for (j = 0; j < 3; j++) prt_vo_bend(1, w + j, (prt_real)k, vec3(1, 2, 3), 1, &twice, &twice);
        assert_memory_equal(&twice, &out, sizeof out);
    }
    out = o;
    assert_int_equal(prt_vo_bend(-1, w, 0, vec3(0, 0, 0), 1, &o, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_bend(1, w, 0, vec3(0, 0, 0), -1, &o, &out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_bend(1, NULL, 0, vec3(0, 0, 0), 1, &o, &out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_bend(1, w, 0, vec3(0, 0, 0), 1, NULL, &out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_bend(1, w, 0, vec3(0, 0, 0), 1, &o, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_bend(0, NULL, 0, vec3(0, 0, 0), 0, NULL, NULL), PRT_OK);
    w[1].across = w[1].along;
    assert_int_equal(prt_vo_bend(3, w, 0, vec3(0, 0, 0), 1, &o, &out), PRT_ERR_VALUE);
    w[1].across = vec3(0, 0, 2);
    assert_int_equal(prt_vo_bend(3, w, 0, vec3(0, 0, 0), 1, &o, &out), PRT_ERR_VALUE);
#ifndef __FAST_MATH__
    w[1] = w[0];
    w[1].amplitude = (prt_real)NAN;
    assert_int_equal(prt_vo_bend(3, w, 0, vec3(0, 0, 0), 1, &o, &out), PRT_ERR_VALUE);
    w[1] = w[0];
    assert_int_equal(prt_vo_bend(3, w, (prt_real)INFINITY, vec3(0, 0, 0), 1, &o, &out), PRT_ERR_VALUE);
    assert_int_equal(prt_vo_bend(3, w, 0, vec3(NAN, 0, 0), 1, &o, &out), PRT_ERR_VALUE);
#endif
    assert_memory_equal(&out, &o, sizeof o);
}

static void bad_arguments(void **state) {
    static scene s;
    static const int falling[] = { 0, 2, 1 }, negative[] = { -1, 2, 2 };
    prt_rgb out[2], untouched[2];
    const prt_vo_params *q = &s.params;
    (void)state;
    noise_scene(&s);
    memset(out, 7, sizeof out);
    memcpy(untouched, out, sizeof out);
    assert_int_equal(prt_vo_shade(q, s.points, s.eye, -1, s.occluders, 1, s.lights, out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_shade(q, s.points, s.eye, 1, s.occluders, -1, s.lights, out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_shade(NULL, s.points, s.eye, 1, s.occluders, 1, s.lights, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade(q, NULL, s.eye, 1, s.occluders, 1, s.lights, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade(q, s.points, s.eye, 1, NULL, 1, s.lights, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade(q, s.points, s.eye, 1, s.occluders, 1, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade(q, s.points, s.eye, 1, s.occluders, 1, s.lights, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade_n(q, -1, s.points, s.eye, s.first, s.occluders, 1, s.lights, out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_shade_n(q, 2, s.points, s.eye, s.first, s.occluders, -1, s.lights, out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_shade_n(q, 2, s.points, s.eye, falling, s.occluders, 1, s.lights, out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_shade_n(q, 2, s.points, s.eye, negative, s.occluders, 1, s.lights, out), PRT_ERR_COUNT);
    assert_int_equal(prt_vo_shade_n(NULL, 2, s.points, s.eye, s.first, s.occluders, 1, s.lights, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade_n(q, 2, NULL, s.eye, s.first, s.occluders, 1, s.lights, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade_n(q, 2, s.points, s.eye, NULL, s.occluders, 1, s.lights, out), PRT_ERR_NULL);
    s.first[1] = 1; s.first[2] = 3;
    assert_int_equal(prt_vo_shade_n(q, 2, s.points, s.eye, s.first, NULL, 1, s.lights, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade_n(q, 2, s.points, s.eye, s.first, s.occluders, 1, NULL, out), PRT_ERR_NULL);
    assert_int_equal(prt_vo_shade_n(q, 2, s.points, s.eye, s.first, s.occluders, 1, s.lights, NULL), PRT_ERR_NULL);
    assert_memory_equal(out, untouched, sizeof out);
    assert_int_equal(prt_vo_shade(q, s.points, s.eye, 0, NULL, 0, NULL, out), PRT_OK);
    assert_memory_equal(out, &s.points[0].emissive, sizeof *out);
    assert_int_equal(prt_vo_shade_n(q, 0, NULL, s.eye, NULL, NULL, 0, NULL, NULL), PRT_OK);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shading_is_the_model),
        cmocka_unit_test(batches_are_bit_equal),
        cmocka_unit_test(the_sine_law),
        cmocka_unit_test(aligned_vectors_have_no_negative_sine),
        cmocka_unit_test(lights_in_odd_places),
        cmocka_unit_test(the_cap_law),
        cmocka_unit_test(caustics_are_bounded),
        cmocka_unit_test(nothing_jumps),
        cmocka_unit_test(ss_fades_in),
        cmocka_unit_test(finite_in_finite_out),
        cmocka_unit_test(nan_stays_at_home),
        cmocka_unit_test(drained_colour_ends_at_black),
        cmocka_unit_test(half_floats),
        cmocka_unit_test(packing_keeps_what_it_says),
        cmocka_unit_test(packed_shading_is_shading),
        cmocka_unit_test(bad_packing),
        cmocka_unit_test(indexing_keeps_what_it_says),
        cmocka_unit_test(materials_are_shared),
        cmocka_unit_test(indexed_shading_is_shading),
        cmocka_unit_test(bad_indexing),
        cmocka_unit_test(sizes_of_forms),
        cmocka_unit_test(waves_bend),
        cmocka_unit_test(bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
