/* What examples/vo_compare measures with: light paths in an integrating sphere, structural similarity in closed form,
   the median cut of maps whose answer is known, the scenes' meshes. Rays are traced by brute force; no library is
   needed. */
#define _POSIX_C_SOURCE 200809L
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "../examples/common/vector.h"
#include "../examples/common/replacement.c"
#include "../examples/common/transfer_file.c"
#include "../examples/common/mesh.c"
#include "../examples/common/progress.c"
#include "../examples/common/why.c"
#include "../examples/common/parallel.c"
#include "../examples/common/scene.c"
#include "../examples/common/photons.c"
#include "../examples/common/path_reference.c"
#include "../examples/common/similarity.c"
#include "../examples/common/point_lights.c"

/* ---- in the place of libraries ---- */

int raw_mesh_import(const char *path, raw_mesh *m, why *w) {
    memset(m, 0, sizeof *m);
    return why_set(w, "%s: not here", path);
}
void raw_mesh_free(raw_mesh *m) { (void)m; }
int embree_tracer_create(embree_tracer *t, why *w) { (void)t; (void)w; return 0; }
int embree_tracer_add(embree_tracer *t, const mesh *m, int object, why *w) {
    (void)t;
    (void)m;
    (void)object;
    (void)w;
    return 0;
}
int embree_tracer_build(embree_tracer *t, why *w) { (void)t; (void)w; return 0; }
camera_frame camera_make_frame(const camera *c, double aspect) {
    camera_frame f;
    (void)c; (void)aspect;
    memset(&f, 0, sizeof f);
    return f;
}
int picture_create(int width, int height, picture *p, why *w) {
    p->width = width; p->height = height;
    p->rgba = (float *)calloc((size_t)width * (size_t)height, 4 * sizeof(float));
    return p->rgba ? 0 : why_set(w, "out of memory");
}

static prt_vec3 cross(prt_vec3 a, prt_vec3 b) {
    return vec((double)(a.y * b.z - a.z * b.y), (double)(a.z * b.x - a.x * b.z), (double)(a.x * b.y - a.y * b.x));
}

/* Every triangle of every part [Moeller 1997]; the nearest hit. */
static int brute_force(const scene *s, const prt_ray *r, prt_hit *hit) {
    int part, k, found = 0;
    double nearest = (double)r->tmax;
    for (part = 0; part < s->part_count; part++) {
        for (k = 0; k < s->parts[part].triangle_count; k++) {
            const uint32_t *c = s->mesh.triangles + 3 * (size_t)(s->parts[part].first_triangle + k);
            prt_vec3 a = s->mesh.points[c[0]].position, e1 = vec_add(s->mesh.points[c[1]].position, -1, a);
            prt_vec3 e2 = vec_add(s->mesh.points[c[2]].position, -1, a), p = cross(r->dir, e2), o, q;
            double det = vec_dot(e1, p), u, v, t;
            if (fabs(det) < 1e-12) continue;
            o = vec_add(r->origin, -1, a);
            q = cross(o, e1);
            u = vec_dot(o, p) / det; v = vec_dot(r->dir, q) / det; t = vec_dot(e2, q) / det;
            if (u < 0 || v < 0 || u + v > 1 || t <= 0 || t >= nearest) continue;
            nearest = t; found = 1;
            hit->t = (prt_real)t; hit->object = part; hit->primitive = k;
            hit->u = (prt_real)u; hit->v = (prt_real)v;
            hit->normal = vec_unit(cross(e1, e2), vec(0, 0, 1));
        }
    }
    return found;
}
static int brute_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    int k;
    for (k = 0; k < count; k++) if (!brute_force((const scene *)user, &rays[k], &hits[k])) hits[k].object = -1;
    return 0;
}
static int brute_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    prt_hit hit;
    int k;
    for (k = 0; k < count; k++) blocked[k] = (unsigned char)brute_force((const scene *)user, &rays[k], &hit);
    return 0;
}

/* ---- light paths ---- */

/* A sphere seen from within: all normals turned inwards. */
static void make_sphere(scene *s, material m) {
    const ball unit = { { 0, 0, 0 }, 1 };
    builder b;
    why w;
    int k;
    memset(&b, 0, sizeof b);
    memset(s, 0, sizeof *s);
    add_ball(&b, 1, 12, 8, &unit);
    end_part(s, &b, "sphere", m);
    for (k = 0; k < b.triangle_count; k++) {
        uint32_t swap = b.triangles[3 * k];
        b.triangles[3 * k] = b.triangles[3 * k + 1];
        b.triangles[3 * k + 1] = swap;
    }
    assert_int_equal(finish(&b, s, &w), 0);
}

enum { QUERIES = 6 };

static void trace_sphere(scene *s, int samples, int depth, prt_rgb out[PATH_HALVES][QUERIES]) {
    prt_tracer tracer;
    prt_point_light light;
    path_query q[QUERIES];
    path_reference r;
    why w;
    int k;
    tracer.user = s; tracer.occluded = brute_occluded; tracer.closest = brute_closest;
    light.position = vec(0, 0, 0); light.color = rgb(1, 2, 3);
    memset(q, 0, sizeof q);
    memset(&r, 0, sizeof r);
    for (k = 0; k < QUERIES; k++) {
        q[k].position = s->mesh.points[13 * k].position;
        q[k].normal = vec_unit(vec_add(vec(0, 0, 0), -1, q[k].position), vec(0, 0, 1));
        q[k].towards = vec_add(vec(0, 0, 0), -1, q[k].normal);
    }
    r.scene = s; r.tracer = &tracer; r.light_count = 1; r.lights = &light; r.group_count = 1; r.samples = samples;
    r.depth = depth; r.bias = (prt_real)1e-3; r.seed = 3; r.threads = 2; r.query_count = QUERIES; r.queries = q;
    r.out[0] = out[0]; r.out[1] = out[1];
    assert_int_equal(path_reference_trace(&r, &w), 0);
    assert_int_equal(r.done, QUERIES);
}

/* In a sphere of albedo a around its light every place sends a c, and as much again times a with each bounce. The mesh
   has normals of its vertices; between them its lights fall in at up to 9 degrees: 1 - cos = 0.012 a bounce. */
static void integrating_sphere(void **state) {
    prt_rgb out[PATH_HALVES][QUERIES];
    scene s;
    int depth, k, half;
    (void)state;
    make_sphere(&s, matter(0.5, 0.5, 0.25, 0, 1));
    for (depth = 0; depth <= 2; depth++) {
        double red = 0.5 * (2 - pow(0.5, depth)), blue = 3 * 0.25 * (1 - pow(0.25, depth + 1)) / 0.75;
        trace_sphere(&s, depth ? 16 : 0, depth, out);
        for (half = 0; half < PATH_HALVES; half++) {
            for (k = 0; k < QUERIES; k++) {
                assert_near(out[half][k].r, red, 0.012 * depth * red + 1e-5);
                assert_near(out[half][k].g, 2 * red, 2 * 0.012 * depth * red + 1e-5);
                assert_near(out[half][k].b, blue, 0.012 * depth * blue + 1e-5);
            }
        }
    }
    scene_free(&s);
}

/* A place that shines only, seen head on, under light B from all around: (1/pi) int B k (r.w)^n = 2 k B/(n + 1). The
   walls' own B is k c, times the lobe at the angle between light and eye, 1 for all that is seen from the middle; from
   elsewhere it is less, which the quadrature below sums up over the sphere. */
static void glossy_lobe(void **state) {
    enum { N = 4, STEPS = 2000 };
    const double k = 0.5;
    prt_rgb out[PATH_HALVES][QUERIES];
    double sum = 0, got = 0, square = 0, error;
    scene s;
    int i;
    (void)state;
    make_sphere(&s, matter(0, 0, 0, k, N));
    for (i = 0; i < STEPS; i++) { /* over the angle a from the normal: the wall is met at the same angle */
        double a = 0.5 * pi * (i + 0.5) / STEPS, wall = k * pow(cos(a), N);
        sum += 2 * sin(a) * k * pow(cos(a), N) * wall * (0.5 * pi / STEPS);
    }
    trace_sphere(&s, 128, 1, out);
    for (i = 0; i < QUERIES; i++) {
        double difference = 0.5 * ((double)out[0][i].r - (double)out[1][i].r);
        got += 0.5 * ((double)out[0][i].r + (double)out[1][i].r) / QUERIES;
        square += difference * difference / QUERIES;
    }
    error = sqrt(square / QUERIES);
    print_message("glossy bounce %.5f, expected %.5f, standard error %.5f\n", got - k, sum, error);
    assert_near(got, k + sum, 4 * error + 0.024 * N * sum);
    scene_free(&s);
}

/* Through a ball of index 1 light goes straight on: behind it a plane gets T c cos, as if the ball were a filter. */
static void photons_keep_the_lights_colour(void **state) {
    const ball lens = { { 0, 0, 1 }, 0.5 };
    const quad plane = { { -2, -2, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
    material filter = matter(0, 0, 0, 0, 1);
    prt_point_light light;
    prt_tracer tracer;
    photon_map map;
    prt_rgb sum = { 0, 0, 0 };
    builder b;
    scene s;
    why w;
    (void)state;
    memset(&b, 0, sizeof b);
    memset(&s, 0, sizeof s);
    filter.transmissive = rgb(0.5, 0.25, 1);
    add_ball(&b, 1, 24, 12, &lens);
    end_part(&s, &b, "filter", filter);
    add_sheet(&b, 1, 1, 0, quad_form, &plane);
    end_part(&s, &b, "plane", matter(1, 1, 1, 0, 1));
    assert_int_equal(finish(&b, &s, &w), 0);
    tracer.user = &s; tracer.occluded = brute_occluded; tracer.closest = brute_closest;
    light.position = vec(0, 0, 3); light.color = rgb(1, 2, 3);
    assert_int_equal(photon_map_make(&s, &tracer, 1, &light, 4096, 0.3, 1, &map, &w), 0);
    photon_map_add(&map, vec(0.1, 0, 0), vec(0, 0, 1), NULL, &sum); /* some 400 photons of the set: 2 % and less */
    assert_near(sum.r, 0.5, 0.02);
    assert_near(sum.g, 0.5, 0.02);
    assert_near(sum.b, 3.0, 0.12);
    sum = rgb(0, 0, 0);
    photon_map_add(&map, vec(1.5, 0, 0), vec(0, 0, 1), NULL, &sum);
    photon_map_add(&map, vec(0.1, 0, 0), vec(0, 0, -1), NULL, &sum);
    assert_near(sum.b, 0, 0);
    photon_map_free(&map);
    scene_free(&s);
}

static void refraction_follows_snell(void **state) {
    material glass;
    prt_vec3 in, out, normal;
    surface s;
    int k;
    (void)state;
    memset(&glass, 0, sizeof glass);
    glass.index = (prt_real)1.5;
    normal = vec(0, 0, 1);
    for (k = 1; k < 89; k += 8) {
        double a = k * pi / 180;
        in = vec(sin(a), 0, -cos(a));
        s = surface_of(&glass, vec(0, 0, 0), vec(0, 0, 0), normal, in, 0);
        out = refract_at(&s);
        assert_near(out.x, sin(a) / 1.5, BY_PRECISION(1e-6, 1e-12));
        assert_true(out.z < 0);
        s = surface_of(&glass, vec(0, 0, 0), vec(0, 0, 0), normal, vec((double)in.x, 0, cos(a)), 1);
        out = refract_at(&s);
        if (1.5 * sin(a) < 1) assert_near(out.x, 1.5 * sin(a), BY_PRECISION(2e-6, 1e-12));
        else assert_near(out.z, -cos(a), BY_PRECISION(1e-6, 1e-12));                   /* total reflection */
    }
}

/* ---- similarity ---- */

static void flat(picture *p, float value) {
    int k;
    for (k = 0; k < p->width * p->height; k++) {
        p->rgba[4 * k] = p->rgba[4 * k + 1] = p->rgba[4 * k + 2] = value;
        p->rgba[4 * k + 3] = 1;
    }
}

static void similarity_in_closed_form(void **state) {
    const double c1 = 1e-4, c2 = 9e-4;
    picture a, b;
    double va, vb, got;
    why w;
    int k;
    (void)state;
    picture_create(24, 24, &a, &w);
    picture_create(24, 24, &b, &w);
    flat(&a, 0.25f);
    flat(&b, 0.5f);
    va = coded(0.25); vb = coded(0.5);
    assert_near(picture_similarity(&a, &a, 1, 1, 0.5f), 1, 1e-12);
    assert_near(picture_similarity(&a, &b, 1, 1, 0.5f), (2 * va * vb + c1) / (va * va + vb * vb + c1), 1e-6);
    assert_near(picture_similarity(&a, &b, 2, 2, 0.5f), (2 * vb + c1) / (1 + vb * vb + c1), 1e-6);
    for (k = 0; k < 24 * 24; k++) { /* a checkerboard and its negative: only the covariance differs */
        float *pa = a.rgba + 4 * k, *pb = b.rgba + 4 * k;
        pa[0] = pa[1] = pa[2] = (k + k / 24) % 2 ? 1.0f : 0.0f;
        pb[0] = pb[1] = pb[2] = 1 - pa[0];
    }
    got = picture_similarity(&a, &b, 1, 1, 0.5f);
    assert_near(got, (2 * 0.25 * -1 + c2) / (2 * 0.25 + c2), 2e-3);      /* means are 1/2 within the window's weights */
    flat(&b, 0);
    for (k = 0; k < 24 * 24; k++) b.rgba[4 * k + 3] = 0;
    skip_if_fast_math();
    assert_true(isnan(picture_similarity(&a, &b, 1, 1, 0.5f)));
    free(a.rgba);
    free(b.rgba);
}

/* ---- lights ---- */

static void cut_keeps_energy_and_finds_the_sun(void **state) {
    enum { W = 32, H = 16, MOST = 32 };
    static float texels[3 * W * H];
    prt_point_light lights[MOST];
    image map;
    double total[3] = { 0, 0, 0 };
    why w;
    int x, y, c, n, k;
    (void)state;
    memset(&map, 0, sizeof map);
    map.width = W; map.height = H; map.rgb = texels;
    for (k = 0; k < 3 * W * H; k++) texels[k] = 0.01f * (float)(1 + k % 7);
    for (c = 0; c < 3; c++) texels[3 * (5 * W + 9) + c] = 1000;
    for (y = 0; y < H; y++)
        for (x = 0; x < W; x++)
            for (c = 0; c < 3; c++)
                total[c] += (double)texels[3 * (y * W + x) + c] * 2 / W * (cos(pi * y / H) - cos(pi * (y + 1) / H));
    for (n = 1; n <= MOST; n++) {
        double sum[3] = { 0, 0, 0 }, theta = pi * 5.5 / H, phi = 2 * pi * 9.5 / W, nearest = -1;
        prt_vec3 sun = vec(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
        assert_int_equal(point_lights_from_map(&map, n, 10, lights, &w), 0);
        for (k = 0; k < n; k++) {
            double towards = vec_dot(lights[k].position, sun) / 10;
            sum[0] += (double)lights[k].color.r;
            sum[1] += (double)lights[k].color.g;
            sum[2] += (double)lights[k].color.b;
            assert_near(vec_dot(lights[k].position, lights[k].position), 100, BY_PRECISION(1e-4, 1e-10));
            if (towards > nearest) nearest = towards;
        }
        for (c = 0; c < 3; c++) assert_near(sum[c], total[c], total[c] * n * BY_PRECISION(2e-7, 1e-12));
        assert_true(nearest > 0.999);
    }
    assert_int_equal(point_lights_from_map(&map, W * H + 1, 10, lights, &w), -1);
    memset(texels, 0, sizeof texels);
    assert_int_equal(point_lights_from_map(&map, 4, 10, lights, &w), -1);
}

/* ---- scenes ---- */

/* Every edge inside a sheet borders two triangles that run through it in opposite directions; normals lie on the side
   from which triangles are counter-clockwise. */
static void shapes_are_well_made(void **state) {
    scene s;
    why w;
    int k, c;
    (void)state;
    assert_int_equal(scene_shapes(1, &s, &w), 0);
    assert_int_equal(s.mesh.point_count, 5013);
    assert_int_equal(s.mesh.report.degenerate, 0);
    assert_int_equal(s.mesh.report.without, 0);
    for (k = 0; k < s.mesh.triangle_count; k++) {
        const uint32_t *t = s.mesh.triangles + 3 * (size_t)k;
        const prt_point *p = s.mesh.points;
        prt_vec3 face = cross(vec_add(p[t[1]].position, -1, p[t[0]].position),
                              vec_add(p[t[2]].position, -1, p[t[0]].position));
        for (c = 0; c < 3; c++) assert_true(vec_dot(face, p[t[c]].normal) > 0);
    }
    assert_int_equal(scene_part_of_point(&s, 0), 0);
    assert_int_equal(scene_part_of_point(&s, s.mesh.point_count - 1), s.part_count - 1);
    for (k = 1; k < s.part_count; k++) {
        assert_int_equal(scene_part_of_point(&s, s.parts[k].first_point), k);
        assert_int_equal(scene_part_of_point(&s, s.parts[k].first_point - 1), k - 1);
    }
    scene_free(&s);
    for (k = 0; k < 6; k++) { /* a turn: the axis goes to +z, lengths and handedness stay */
        const char up[3] = { "+-"[k % 2], "xyz"[k / 2], 0 };
        double sign = k % 2 ? -1 : 1;
        prt_vec3 axis = vec(k / 2 == 0 ? sign : 0, k / 2 == 1 ? sign : 0, k / 2 == 2 ? sign : 0);
        prt_vec3 a = turn_upright(vec(1, 0, 0), up), b = turn_upright(vec(0, 1, 0), up),
                 c3 = turn_upright(vec(0, 0, 1), up);
        assert_near(turn_upright(axis, up).z, 1, 0);
        assert_near(vec_dot(cross(a, b), c3), 1, 0);
    }
    assert_int_equal(scene_statue("nowhere.obj", "+z", 4, &s, &w), -1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integrating_sphere), cmocka_unit_test(glossy_lobe), cmocka_unit_test(refraction_follows_snell),
        cmocka_unit_test(photons_keep_the_lights_colour),
        cmocka_unit_test(similarity_in_closed_form), cmocka_unit_test(cut_keeps_energy_and_finds_the_sun),
        cmocka_unit_test(shapes_are_well_made)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
