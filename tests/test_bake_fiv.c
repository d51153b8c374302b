/* Room >>fiv of the baker: totals, vectors of occluders, what lies inside, ranges, errors, memory. */
#include "memory_hook.h"
#include "test.h"
#include "geometry.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)

/* ---- small helpers ---- */

static void components(const prt_fiv *f, double out[9]) {
    const prt_vec3 v[3] = { f->r, f->g, f->b };
    int k;
    for (k = 0; k < 3; k++) { out[3 * k] = (double)v[k].x; out[3 * k + 1] = (double)v[k].y; out[3 * k + 2] = (double)v[k].z; }
}

/* ---- environments ---- */

enum { MOST_TEXELS = 6 * 32 * 32 };
static float texels[MOST_TEXELS * 3];

static void fill_texels(int constant) {
    int k;
    for (k = 0; k < MOST_TEXELS * 3; k++) texels[k] = constant ? 1 : (float)(uniform() < 0.1 ? 20 * uniform() : uniform());
}

static prt_fiv_env cube_env(int size) {
    prt_fiv_env e;
    int face;
    memset(&e, 0, sizeof e);
    e.cube_size = size;
    for (face = 0; face < 6; face++) e.faces[face] = texels + 3 * face * size * size;
    return e;
}

static prt_fiv_env equirect_env(int width, int height) {
    prt_fiv_env e;
    memset(&e, 0, sizeof e);
    e.width = width; e.height = height; e.equirect = texels;
    return e;
}

/* Radiance in a direction, by the tables of OpenGL's specification. */
static const float *radiance(const prt_fiv_env *e, double x, double y, double z) {
    double ax = fabs(x), ay = fabs(y), az = fabs(z), major, sc, tc;
    int face, i, j, n = e->cube_size;
    if (n == 0) {
        double phi = atan2(y, x);
        i = (int)((phi < 0 ? phi + 2 * pi : phi) / (2 * pi) * e->width);
        j = (int)(acos(fmax(-1, fmin(1, z))) / pi * e->height);
        if (i >= e->width) i = e->width - 1;
        if (j >= e->height) j = e->height - 1;
        return e->equirect + 3 * (j * e->width + i);
    }
    if (ax >= ay && ax >= az) { face = x < 0; major = ax; sc = x < 0 ? z : -z; tc = -y; }
    else if (ay >= az) { face = 2 + (y < 0); major = ay; sc = x; tc = y < 0 ? -z : z; }
    else { face = 4 + (z < 0); major = az; sc = z < 0 ? -x : x; tc = -y; }
    i = (int)((sc / major + 1) / 2 * n);
    j = (int)((tc / major + 1) / 2 * n);
    return e->faces[face] + 3 * ((j < n ? j : n - 1) * n + (i < n ? i : n - 1));
}

/* int f(w) L(w) dw by `nodes` rings of 2 nodes directions of equal share. */
static void quadrature(const prt_fiv_env *e, int nodes, const double *normal, double out[3]) {
    int i, j, c;
    out[0] = out[1] = out[2] = 0;
    for (i = 0; i < nodes; i++)
        for (j = 0; j < 2 * nodes; j++) {
            double z = 1 - 2 * (i + 0.5) / nodes, r = sqrt(1 - z * z), a = pi * (j + 0.5) / nodes, f;
            const float *l = radiance(e, r * cos(a), r * sin(a), z);
            f = r * cos(a) * normal[0] + r * sin(a) * normal[1] + z * normal[2];
            for (c = 0; c < 3 && f > 0; c++) out[c] += f * (double)l[c] * 2 * pi / nodes / nodes;
        }
}

static const int shapes[9][2] = { { 1, 1 }, { 2, 1 }, { 3, 3 }, { 4, 2 }, { 5, 4 }, { 16, 8 }, { 36, 17 }, { 7, 1 }, { 1, 9 } };

static void total_of_a_white_sky_is_pi(void **state) {
    static prt_rgb total[6 * 6 * 6];
    int k, s;
    (void)state;
    fill_texels(1);
    for (s = 0; s < 18; s++) {
        prt_fiv_env e = s < 9 ? equirect_env(shapes[s][0], shapes[s][1]) : cube_env(1 + (s - 9) * 2);
        prt_vec3 axes[6];
        prt_rgb along[6];
        assert_int_equal(prt_bake_fiv_total(&e, 6, 0, 216, total), PRT_OK);
        for (k = 0; k < 216; k++) { assert_near(total[k].r, pi, BY_PRECISION(8, 100) * EPS); assert_near(total[k].b, pi, BY_PRECISION(8, 100) * EPS); }
        for (k = 0; k < 6; k++)
            axes[k] = vec3(k / 2 == 0 ? 1 - k % 2 * 2 : 0, k / 2 == 1 ? 1 - k % 2 * 2 : 0, k / 2 == 2 ? 1 - k % 2 * 2 : 0);
        assert_int_equal(prt_bake_fiv_irradiance(&e, 6, axes, along), PRT_OK);     /* horizons along edges of texels */
        for (k = 0; k < 6; k++) assert_near(along[k].g, pi, BY_PRECISION(8, 100) * EPS);
    }
}

/* max(0,x) - max(0,-x) = x: I(N) - I(-N) = N.FIV exactly, however the horizon cuts texels. */
static void totals_of_opposite_normals(void **state) {
    int k, s;
    (void)state;
    fill_texels(0);
    for (s = 0; s < 18; s++) {
        prt_fiv_env e = s < 9 ? equirect_env(shapes[s][0], shapes[s][1]) : cube_env(1 + (s - 9) * 2);
        prt_fiv all;
        double v[9];
        assert_int_equal(prt_bake_fiv_environment(&e, &all), PRT_OK);
        components(&all, v);
        for (k = 0; k < 40; k++) {
            prt_vec3 n[2];
            prt_rgb i[2];
            n[0] = random_direction();
            n[1] = vec3(-(double)n[0].x, -(double)n[0].y, -(double)n[0].z);
            assert_int_equal(prt_bake_fiv_irradiance(&e, 2, n, i), PRT_OK);
            assert_near(i[0].r - i[1].r, v[0] * (double)n[0].x + v[1] * (double)n[0].y + v[2] * (double)n[0].z, 300 * EPS);
            assert_near(i[0].b - i[1].b, v[6] * (double)n[0].x + v[7] * (double)n[0].y + v[8] * (double)n[0].z, 300 * EPS);
        }
    }
}

static void totals_agree_with_quadrature(void **state) {
    int k, s;
    (void)state;
    fill_texels(0);
    for (s = 0; s < 4; s++) {
        prt_fiv_env e = s < 2 ? equirect_env(s ? 16 : 3, s ? 8 : 3) : cube_env(s == 2 ? 1 : 5);
        for (k = 0; k < 1; k++) {
            prt_vec3 n = random_direction();
            double normal[3], want[3];
            prt_rgb got;
            normal[0] = (double)n.x; normal[1] = (double)n.y; normal[2] = (double)n.z;
            quadrature(&e, 400, normal, want);
            assert_int_equal(prt_bake_fiv_irradiance(&e, 1, &n, &got), PRT_OK);
            assert_near(got.r, want[0], 0.008 * want[0]);
            assert_near(got.g, want[1], 0.008 * want[1]);
            assert_near(got.b, want[2], 0.008 * want[2]);
        }
    }
}

/* Told after every normal; stopped, what is finished stays and nothing else is written. */
typedef struct teller { int count, last, total, stop_at; } teller;
static int tell(void *user, int done, int total) {
    teller *t = (teller *)user;
    t->count += 1;
    t->last = done;
    t->total = total;
    return done == t->stop_at;
}

static void totals_tell_how_far_they_are(void **state) {
    enum { SIZE = 3, COUNT = 6 * SIZE * SIZE, FIRST = 5, SOME = 40 };
    prt_fiv_env e = cube_env(4);
    prt_rgb whole[COUNT], part[COUNT], same;
    prt_vec3 normals[SOME];
    teller t = { 0, 0, 0, 0 };
    int stop, k;
    (void)state;
    fill_texels(0);
    memset(&same, 0x55, sizeof same);
    for (k = 0; k < SOME; k++) normals[k] = vec3(sin(k), 0, cos(k));
    assert_int_equal(prt_bake_fiv_total(&e, SIZE, 0, COUNT, whole), PRT_OK);
    e.progress = tell;
    e.progress_user = &t;
    assert_int_equal(prt_bake_fiv_total(&e, SIZE, FIRST, SOME, whole), PRT_OK);
    assert_true(t.count == SOME && t.last == SOME && t.total == SOME);
    for (stop = 1; stop <= SOME; stop += 13) {                 /* the last one too */
        memset(part, 0x55, sizeof part);
        memset(&t, 0, sizeof t);
        t.stop_at = stop;
        assert_int_equal(prt_bake_fiv_total(&e, SIZE, FIRST, SOME, part), PRT_ERR_CANCELLED);
        assert_int_equal(t.count, stop);
        for (k = 0; k < COUNT; k++)
            assert_memory_equal(&part[k], k >= FIRST && k < FIRST + stop ? &whole[k] : &same, sizeof same);
        memset(part, 0x55, sizeof part);
        assert_int_equal(prt_bake_fiv_irradiance(&e, SOME, normals, part), PRT_ERR_CANCELLED);
        for (k = 0; k < SOME; k++) assert_true((memcmp(&part[k], &same, sizeof same) != 0) == (k < stop));
    }
}

static void totals_of_a_cube_are_those_of_its_normals(void **state) {
    enum { SIZE = 4, COUNT = 6 * SIZE * SIZE };
    prt_fiv_env e = cube_env(7);
    prt_rgb whole[COUNT], part[COUNT], one;
    int k;
    (void)state;
    skip_if_fast_math();
    fill_texels(0);
    assert_int_equal(prt_bake_fiv_total(&e, SIZE, 0, COUNT, whole), PRT_OK);
    memset(part, 0x55, sizeof part);
    assert_int_equal(prt_bake_fiv_total(&e, SIZE, 10, 50, part), PRT_OK);
    for (k = 0; k < COUNT; k++) {
        unsigned char same[sizeof one];
        memset(same, 0x55, sizeof same);
        if (k >= 10 && k < 60) assert_memory_equal(&part[k], &whole[k], sizeof one);
        else assert_memory_equal(&part[k], same, sizeof one);
    }
    for (k = 0; k < COUNT; k++) {                          /* a texel is read back at its own centre */
        double s = (2 * (k % SIZE) + 1.0) / SIZE - 1, t = (2 * (k / SIZE % SIZE) + 1.0) / SIZE - 1, d[3], r;
        int face = k / SIZE / SIZE;
        d[0] = face == 0 ? 1 : face == 1 ? -1 : face == 5 ? -s : s;
        d[1] = face == 2 ? 1 : face == 3 ? -1 : -t;
        d[2] = face == 4 ? 1 : face == 5 ? -1 : face == 0 ? -s : face == 1 ? s : face == 2 ? t : -t;
        r = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        one = prt_fiv_total(SIZE, whole, vec3(d[0] / r, d[1] / r, d[2] / r));
        assert_near(one.r, whole[k].r, 50 * EPS * 10);
        assert_near(one.g, whole[k].g, 50 * EPS * 10);
    }
}

/* ---- occluders ---- */

/* A ball, and what the tests want to know of the rays that meet it. */
typedef struct ball { prt_vec3 centre; double radius; long rays; int calls, fail_at, largest; double widest; prt_vec3 towards; } ball;

static double ball_meets(const ball *b, prt_vec3 o, prt_vec3 d, int *back) {   /* distance, or -1 */
    double x = (double)b->centre.x - (double)o.x, y = (double)b->centre.y - (double)o.y, z = (double)b->centre.z - (double)o.z;
    double along = x * (double)d.x + y * (double)d.y + z * (double)d.z, gap = x * x + y * y + z * z - b->radius * b->radius;
    double root = along * along - gap;
    *back = gap < 0;
    if (root < 0 || (gap > 0 && along < 0)) return -1;
    return gap < 0 ? along + sqrt(root) : along - sqrt(root);
}

static int ball_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    ball *b = (ball *)user;
    int k, back;
    for (k = 0; k < count; k++) {
        prt_vec3 to = vec3((double)b->centre.x - (double)rays[k].origin.x, (double)b->centre.y - (double)rays[k].origin.y,
                           (double)b->centre.z - (double)rays[k].origin.z);
        double distance = sqrt(dot(to, to));
        blocked[k] = (unsigned char)(ball_meets(b, rays[k].origin, rays[k].dir, &back) >= 0 ? 7 : 0);
        assert_near(dot(rays[k].dir, rays[k].dir), 1, 8 * EPS);
        assert_true(rays[k].tmin == 0 && rays[k].tmax == (prt_real)FLT_MAX);
        if (distance > b->radius * 1.0001)                 /* sine of the angle from the rim of the cone, outwards */
            b->widest = fmax(b->widest, sqrt(1 - b->radius / distance * b->radius / distance) - dot(rays[k].dir, to) / distance);
    }
    b->rays += count;
    b->calls++;
    if (count > b->largest) b->largest = count;
    return b->calls == b->fail_at;
}

static int ball_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    ball *b = (ball *)user;
    int k, back;
    for (k = 0; k < count; k++) {
        double t = ball_meets(b, rays[k].origin, rays[k].dir, &back);
        prt_vec3 p = vec3((double)rays[k].origin.x + t * (double)rays[k].dir.x - (double)b->centre.x,
                          (double)rays[k].origin.y + t * (double)rays[k].dir.y - (double)b->centre.y,
                          (double)rays[k].origin.z + t * (double)rays[k].dir.z - (double)b->centre.z);
        assert_int_equal(hits[k].object, -1);
        if (t < 0 || (p.z > 0.5 * b->radius && p.x > 0.5 * b->radius)) continue;   /* the ball has a hole */
        hits[k].object = 0;
        hits[k].t = (prt_real)t;
        hits[k].normal = vec3((double)p.x / b->radius, (double)p.y / b->radius, (double)p.z / b->radius);
    }
    b->calls++;
    return b->calls == b->fail_at;
}

typedef struct bake { prt_fiv_desc desc; prt_fiv_env env; prt_tracer tracer; ball b; prt_real rho[5]; int told, stop_at; } bake;

static int told(void *user, int done, int total) {
    bake *b = (bake *)user;
    assert_true(done == b->told + 1 && done <= total);
    b->told = done;
    return done == b->stop_at;
}

static void begin(bake *b) {
    memset(b, 0, sizeof *b);
    b->env = cube_env(16);
    b->b.centre = vec3(1, 2, 3); b->b.radius = 2;
    b->tracer.user = &b->b; b->tracer.occluded = ball_occluded; b->tracer.closest = ball_closest;
    b->rho[0] = 1; b->rho[1] = PRT__R(2.1); b->rho[2] = 3; b->rho[3] = 8; b->rho[4] = 30;
    b->desc.theta_count = 5; b->desc.phi_count = 8; b->desc.rho_count = 5; b->desc.rho = b->rho;
    b->desc.centre = b->b.centre; b->desc.radius = 2;
    b->desc.tracer = &b->tracer; b->desc.env = &b->env;
    b->desc.progress = told; b->desc.progress_user = b;
}

enum { COUNT = 5 * 8 * 5 };

static void place(const bake *b, int index, double dir[3]) {
    double theta = pi * (index / 8 % 5) / 4, phi = 2 * pi * (index % 8) / 8;
    dir[0] = sin(theta) * cos(phi); dir[1] = sin(theta) * sin(phi); dir[2] = cos(theta);
    (void)b;
}

/* A texel's vector by Gauss' midpoint rule on its plane: L w / |w|^4 du dv. */
static void cube_texel(const prt_fiv_env *e, int face, int row, int column, double centre[3], double v[3]) {
    const int n = 24;
    int i, j, k;
    v[0] = v[1] = v[2] = 0;
    for (i = -1; i < n * n; i++) {
        double s, t, d[3], r2;
        j = i < 0 ? 0 : i / n;
        s = 2 * (column + (i < 0 ? 0.5 : (i % n + 0.5) / n)) / e->cube_size - 1;
        t = 2 * (row + (i < 0 ? 0.5 : (j + 0.5) / n)) / e->cube_size - 1;
        d[0] = face == 0 ? 1 : face == 1 ? -1 : face == 5 ? -s : s;
        d[1] = face == 2 ? 1 : face == 3 ? -1 : -t;
        d[2] = face == 4 ? 1 : face == 5 ? -1 : face == 0 ? -s : face == 1 ? s : face == 2 ? t : -t;
        r2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        for (k = 0; k < 3; k++) {
            if (i < 0) centre[k] = d[k] / sqrt(r2);
            else v[k] += d[k] / r2 / r2 * 4 / e->cube_size / e->cube_size / n / n;
        }
    }
}

/* One ray a texel: the sum over all texels of the sky whose centres the ball hides. */
static void vectors_are_those_of_hidden_texels(void **state) {
    static double centre[6 * 16 * 16][3], v[6 * 16 * 16][3];
    static prt_fiv samples[COUNT];
    bake b;
    int k, t, c, i;
    (void)state;
    fill_texels(0);
    begin(&b);
    b.desc.rays = 1;
    assert_int_equal(prt_bake_fiv_count(&b.desc), COUNT);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, samples), PRT_OK);
    assert_true(b.b.largest <= PRT_BAKE_BATCH && b.b.calls <= b.b.rays / (PRT_BAKE_BATCH - 64) + 1);
    for (t = 0; t < 6 * 256; t++) cube_texel(&b.env, t / 256, t / 16 % 16, t % 16, centre[t], v[t]);
    for (k = 0; k < COUNT; k++) {
        double dir[3], want[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, got[9], edge = 0, rho = (double)b.rho[k / 40];
        place(&b, k, dir);
        for (t = 0; t < 6 * 256; t++) {
            double cosine = dir[0] * centre[t][0] + dir[1] * centre[t][1] + dir[2] * centre[t][2];
            double limit = rho > 2 ? sqrt(1 - 4 / rho / rho) : -2;
            if (fabs(cosine - limit) < 30 * EPS) edge += 20;       /* on the very rim: rounding decides */
            if (cosine < limit) continue;
            for (c = 0; c < 3; c++) for (i = 0; i < 3; i++) want[3 * c + i] += (double)texels[3 * t + c] * v[t][i];
        }
        components(&samples[k], got);
        for (c = 0; c < 9; c++) assert_near(got[c], want[c], 2e-5 + edge * 0.02 + 50 * EPS);
    }
    assert_at_most(b.b.widest, 30 * EPS);                          /* no ray leaves the cone */
}

/* A ball under a sky of radiance 1 hides pi sin^2 a along its direction. */
static void ball_under_a_white_sky(void **state) {
    static prt_fiv samples[COUNT];
    double squares = 0, worst = 0;
    bake b;
    int k, c, count = 0;
    (void)state;
    fill_texels(1);
    begin(&b);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, samples), PRT_OK);
    for (k = 40; k < COUNT; k++) {
        double dir[3], got[9], rho = (double)b.rho[k / 40], size = pi * 4 / rho / rho, square = 0;
        place(&b, k, dir);
        components(&samples[k], got);
        for (c = 0; c < 3; c++) square += (got[c] - size * dir[c]) * (got[c] - size * dir[c]);
        squares += square / size / size;
        worst = fmax(worst, sqrt(square) / size);
        count++;
        for (c = 0; c < 3; c++) assert_near(got[c], got[3 + c], 0);
    }
    print_message("a ball under a white sky of 6x16x16, 256 rays: error %.4f rms, %.4f at most, of what it hides\n",
                  sqrt(squares / count), worst);
    assert_at_most(sqrt(squares / count), 2 * pow(256, -0.75));    /* the law of point sets at an edge */
    assert_at_most(worst, 4 * pow(256, -0.75));
    for (k = 0; k < 40; k++) {                                     /* inside: everything is hidden, and adds up to nothing */
        double got[9];
        components(&samples[k], got);
        for (c = 0; c < 9; c++) assert_near(got[c], 0, 200 * EPS);
    }
    assert_at_most(b.b.widest, 30 * EPS);
}

static void poles_are_single(void **state) {
    static prt_fiv samples[COUNT];
    bake b;
    int k;
    (void)state;
    fill_texels(0);
    begin(&b);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, samples), PRT_OK);
    for (k = 0; k < COUNT; k++)
        if (k / 8 % 5 == 0 || k / 8 % 5 == 4) assert_memory_equal(&samples[k], &samples[k - k % 8], sizeof samples[k]);
}

static void any_range_gives_the_same_bits(void **state) {
    static prt_fiv whole[COUNT], part[COUNT];
    static unsigned char inside[COUNT], some[COUNT];
    bake b;
    int first, k;
    (void)state;
    skip_if_fast_math();
    fill_texels(0);
    begin(&b);
    b.env = equirect_env(16, 8);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, whole), PRT_OK);
    assert_int_equal(b.told, COUNT);
    b.told = 0;
    assert_int_equal(prt_bake_fiv_inside(&b.desc, 0, COUNT, inside), PRT_OK);
    assert_int_equal(b.told, COUNT);
    for (first = 0; first < COUNT; first += 37) {
        int count = first * 7 % 60;
        if (count > COUNT - first) count = COUNT - first;
        memset(part, 0x55, sizeof part);
        memset(some, 0x55, sizeof some);
        b.told = 0;
        assert_int_equal(prt_bake_fiv_table(&b.desc, first, count, part), PRT_OK);
        assert_int_equal(b.told, count);
        b.told = 0;
        assert_int_equal(prt_bake_fiv_inside(&b.desc, first, count, some), PRT_OK);
        for (k = 0; k < COUNT; k++) {
            unsigned char same[sizeof part[0]];
            memset(same, 0x55, sizeof same);
            if (k >= first && k < first + count) {
                assert_memory_equal(&part[k], &whole[k], sizeof part[0]);
                assert_int_equal(some[k], inside[k]);
            } else {
                assert_memory_equal(&part[k], same, sizeof part[0]);
                assert_int_equal(some[k], 0x55);
            }
        }
    }
}

static void inside_is_found_through_holes(void **state) {
    static unsigned char inside[COUNT];
    bake b;
    int k;
    (void)state;
    begin(&b);
    b.b.radius = 1.5;                                              /* smaller than its bounding sphere, of 2 */
    b.rho[0] = PRT__R(0.5); b.rho[1] = PRT__R(1.4); b.rho[2] = PRT__R(1.6);
    assert_int_equal(prt_bake_fiv_inside(&b.desc, 0, COUNT, inside), PRT_OK);
    for (k = 0; k < 40; k++) assert_int_equal(inside[k], 1);
    for (k = 80; k < COUNT; k++) assert_int_equal(inside[k], 0);
}

static void progress_stops_and_callbacks_fail(void **state) {
    static prt_fiv whole[COUNT], part[COUNT];
    unsigned char inside[COUNT];
    bake b;
    int k;
    (void)state;
    fill_texels(0);
    begin(&b);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, whole), PRT_OK);
    for (k = 1; k <= COUNT; k += 66) {
        memset(part, 0, sizeof part);
        b.told = 0;
        b.stop_at = k;
        assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, part), PRT_ERR_CANCELLED);
        assert_memory_equal(part, whole, (size_t)k * sizeof part[0]);
        b.told = 0;
        assert_int_equal(prt_bake_fiv_inside(&b.desc, 0, COUNT, inside), PRT_ERR_CANCELLED);
    }
    begin(&b);
    b.b.fail_at = 3;
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, part), PRT_ERR_TRACE);
    assert_memory_equal(part, whole, (size_t)b.told * sizeof part[0]);
    begin(&b);
    b.b.fail_at = 1;
    assert_int_equal(prt_bake_fiv_inside(&b.desc, 0, COUNT, inside), PRT_ERR_TRACE);
}

static void one_block_of_memory_a_call(void **state) {
    static prt_fiv samples[COUNT];
    static prt_rgb total[6];
    unsigned char inside[COUNT];
    prt_vec3 n = { 0, 0, 1 };
    bake b;
    int pass;
    (void)state;
    fill_texels(1);
    for (pass = 0; pass < 2; pass++) {
        prt_result want = pass ? PRT_ERR_MEMORY : PRT_OK;
        memset(&memory_hook, 0, sizeof memory_hook);
        memory_hook.fail = pass;
        begin(&b);
        assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, samples), want);
        b.told = 0;
        assert_int_equal(prt_bake_fiv_inside(&b.desc, 0, COUNT, inside), want);
        assert_int_equal(prt_bake_fiv_total(&b.env, 1, 0, 6, total), want);
        assert_int_equal(prt_bake_fiv_irradiance(&b.env, 1, &n, total), want);
        assert_int_equal(prt_bake_fiv_environment(&b.env, samples), want);
        assert_int_equal(memory_hook.calls, 5);
        assert_int_equal(memory_hook.frees, pass ? 0 : 5);
    }
    memory_hook.fail = 0;
}

/* ---- any light ---- */

enum { BANDS = 3, HIDDEN = (BANDS + 1) * (BANDS + 1) };

/* A ball hides a cap, whose projection is known; inside everything is hidden. */
static void transfer_of_a_ball_is_its_cap(void **state) {
    static prt_real samples[COUNT * HIDDEN];
    double squares = 0;
    bake b;
    int k, j;
    (void)state;
    begin(&b);
    b.desc.radius = PRT__R(2.6);                                   /* a cap with a margin of open rays */
    b.rho[1] = PRT__R(2.7);
    b.desc.env = NULL;
    assert_int_equal(prt_bake_fiv_transfer_size(&b.desc, BANDS), sizeof samples);
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, COUNT, samples), PRT_OK);
    assert_true(b.told == COUNT && b.b.rays == COUNT * 1024L && b.b.largest <= PRT_BAKE_BATCH);
    for (k = 0; k < COUNT; k++) {
        double dir[3], rho = (double)b.rho[k / 40], cap = 2 * pi * (1 - sqrt(fmax(0, 1 - 2.6 * 2.6 / rho / rho)));
        prt_real want[HIDDEN];
        place(&b, k, dir);
        assert_int_equal(prt_sh_sphere(BANDS + 1, vec3(rho * dir[0], rho * dir[1], rho * dir[2]), 2, want), PRT_OK);
        if (rho < 2) cap = 4 * pi;
        for (j = 0; j < HIDDEN; j++) {
            double off = ((double)samples[k * HIDDEN + j] - (double)want[j]) / cap;
            squares += off * off;
            assert_near(off, 0, 6 * pow(1024, -0.75));
        }
    }
    print_message("projection of a ball by 1024 rays: error %.5f of the cap rms in the 2-norm, 1024^-3/4 is %.5f\n",
                  sqrt(squares / COUNT), pow(1024, -0.75));
    assert_at_most(sqrt(squares / COUNT), 2 * pow(1024, -0.75));
}

/* A table baked under a light of three bands, against the one made from the transfer. */
static void transfer_agrees_with_a_fresh_bake(void **state) {
    static prt_real hidden[COUNT * HIDDEN];
    static prt_fiv fresh[COUNT], made[COUNT];
    prt_real light[3 * BANDS * BANDS], vectors[9 * HIDDEN];
    double squares = 0, all = 0;
    bake b;
    int k, c, t;
    (void)state;
    begin(&b);
    b.env = cube_env(32);
    for (k = 0; k < 27; k++) light[k] = (prt_real)(k % 9 ? uniform() - 0.5 : 3);
    for (t = 0; t < 6 * 32 * 32; t++) {
        double s = (2 * (t % 32) + 1.0) / 32 - 1, u = (2 * (t / 32 % 32) + 1.0) / 32 - 1, d[3], r;
        int face = t / 1024;
        d[0] = face == 0 ? 1 : face == 1 ? -1 : face == 5 ? -s : s;
        d[1] = face == 2 ? 1 : face == 3 ? -1 : -u;
        d[2] = face == 4 ? 1 : face == 5 ? -1 : face == 0 ? -s : face == 1 ? s : face == 2 ? u : -u;
        r = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (c = 0; c < 3; c++) texels[3 * t + c] = (float)prt_sh_at(BANDS, light + 9 * c, vec3(d[0] / r, d[1] / r, d[2] / r));
    }
    b.desc.rays = 1024;
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, fresh), PRT_OK);
    b.told = 0;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, COUNT, hidden), PRT_OK);
    assert_int_equal(prt_fiv_transfer_light(BANDS, NULL, light, vectors), PRT_OK);
    {
        prt_fiv_transfer table = prt_fiv_transfer_of(&b.desc, BANDS, hidden, NULL);
        assert_true(table.rho == b.rho && table.samples == hidden && table.theta_count == 5);
        assert_int_equal(prt_fiv_transfer_samples(&table, vectors, 0, COUNT, made), PRT_OK);
    }
    for (k = 40; k < COUNT; k++) {
        double x[9], y[9], rho = (double)b.rho[k / 40];
        components(&fresh[k], x);
        components(&made[k], y);
        for (c = 0; c < 9; c++) { squares += (x[c] - y[c]) * (x[c] - y[c]) * pow(rho, 4); all += x[c] * x[c] * pow(rho, 4); }
    }
    print_message("transfer against a fresh bake, 1024 rays each: %.4f of what is hidden rms\n", sqrt(squares / all));
    assert_at_most(sqrt(squares / all), 0.015);                    /* two bakes at 1024 rays: sqrt 2 * 2 * 1024^-3/4 */
}

static void transfer_ranges_errors_and_progress(void **state) {
    static prt_real whole[COUNT * HIDDEN], part[COUNT * HIDDEN];
    bake b;
    int k;
    (void)state;
    begin(&b);
    b.desc.rays = 100;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, COUNT, whole), PRT_OK);
    b.told = 0;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 20, 60, part), PRT_OK);
    if (ERROR_FACTOR == 1)
        assert_memory_equal(part + 20 * HIDDEN, whole + 20 * HIDDEN, 60 * HIDDEN * sizeof *part);
    for (k = 0; k < COUNT * HIDDEN; k++) if (k < 20 * HIDDEN || k >= 80 * HIDDEN) assert_true(part[k] == 0);
    b.told = 0;
    b.stop_at = 7;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, COUNT, part), PRT_ERR_CANCELLED);
    begin(&b);
    b.b.fail_at = 3;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, COUNT, part), PRT_ERR_TRACE);
    assert_int_equal(b.told, 2);
    memset(&memory_hook, 0, sizeof memory_hook);
    memory_hook.fail = 1;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, COUNT, part), PRT_ERR_MEMORY);
    memory_hook.fail = 0;
    assert_int_equal(prt_bake_fiv_transfer(NULL, BANDS, 0, 1, part), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, 0, 0, 1, part), PRT_ERR_BANDS);
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, PRT_MAX_BANDS, 0, 1, part), PRT_ERR_BANDS);
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, COUNT + 1, part), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, 0, NULL), PRT_OK);
    b.desc.rays = -1;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, 1, part), PRT_ERR_COUNT);
    b.desc.rays = 0;
    b.tracer.occluded = NULL;
    assert_int_equal(prt_bake_fiv_transfer(&b.desc, BANDS, 0, 1, part), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_transfer_size(&b.desc, PRT_MAX_BANDS), 0);
    assert_int_equal(prt_bake_fiv_transfer_size(NULL, 3), 0);
}

static void distances_are_geometric(void **state) {
    prt_real rho[30];
    int k;
    (void)state;
    assert_int_equal(prt_fiv_distances(30, PRT__R(1.05), PRT__R(7.5), rho), PRT_OK);
    assert_true(rho[0] == PRT__R(1.05) && rho[29] == PRT__R(7.5));
    for (k = 1; k < 30; k++) assert_near(rho[k] / rho[k - 1], pow(7.5 / 1.05, 1 / 29.0), 8 * EPS);
    assert_int_equal(prt_fiv_distances(1, 2, 3, rho), PRT_OK);
    assert_near(rho[0], 2, 0);
    assert_int_equal(prt_fiv_distances(0, 1, 2, rho), PRT_ERR_COUNT);
    assert_int_equal(prt_fiv_distances(2, 1, 2, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_fiv_distances(2, 0, 2, rho), PRT_ERR_VALUE);
    assert_int_equal(prt_fiv_distances(2, 2, 2, rho), PRT_ERR_VALUE);
}

static void tables_are_made_of_descs(void **state) {
    bake b;
    prt_fiv samples[1] = { { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } } };
    unsigned char inside[1] = { 0 };
    prt_fiv_table t;
    (void)state;
    begin(&b);
    t = prt_fiv_table_of(&b.desc, samples, inside);
    assert_true(t.theta_count == 5 && t.phi_count == 8 && t.rho_count == 5 && t.rho == b.rho && t.radius == 2);
    assert_true(t.samples == samples && t.inside == inside);
    t = prt_fiv_table_of(NULL, samples, inside);
    assert_true(t.theta_count == 0 && t.samples == NULL);
}

static void bad_arguments_write_nothing(void **state) {
    static const prt_result want[18] = { PRT_ERR_COUNT, PRT_ERR_COUNT, PRT_ERR_COUNT, PRT_ERR_COUNT, PRT_ERR_COUNT,
        PRT_ERR_COUNT, PRT_ERR_NULL, PRT_ERR_NULL, PRT_ERR_NULL, PRT_ERR_NULL, PRT_ERR_NULL, PRT_ERR_VALUE, PRT_ERR_VALUE,
        PRT_ERR_VALUE, PRT_ERR_VALUE, PRT_ERR_COUNT, PRT_ERR_COUNT, PRT_ERR_NULL };
    prt_fiv samples[COUNT], before[COUNT];
    bake b;
    int k;
    (void)state;
    fill_texels(1);
    memset(samples, 0x55, sizeof samples);
    memcpy(before, samples, sizeof before);
    for (k = 0; k < 18; k++) {
        begin(&b);
        if (k == 0) b.desc.theta_count = 0;
        if (k == 1) b.desc.phi_count = 1 << 30;
        if (k == 2) b.desc.rho_count = -1;
        if (k == 3) b.desc.rays = -1;
        if (k == 4) b.env.cube_size = -1;
        if (k == 5) b.env.cube_size = 1 << 20;
        if (k == 6) b.desc.rho = NULL;
        if (k == 7) b.desc.tracer = NULL;
        if (k == 8) b.tracer.occluded = NULL;
        if (k == 9) b.desc.env = NULL;
        if (k == 10) b.env.faces[3] = NULL;
        if (k == 11) b.rho[2] = b.rho[1];
        if (k == 12) b.rho[0] = 0;
        if (k == 13) b.desc.radius = 0;
        if (k == 14) b.desc.centre.y = PRT__REAL_MAX * 2;
        if (k == 15) { b.env = equirect_env(0, 4); }
        if (k == 16) { b.env = equirect_env(4, 1 << 20); }
        if (k == 17) { b.env = equirect_env(4, 4); b.env.equirect = NULL; }
        if (k == 14 && ERROR_FACTOR > 1) continue;                 /* -ffast-math knows no infinity */
        assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT, samples), want[k]);
        assert_int_equal(b.b.calls, 0);
    }
    begin(&b);
    assert_int_equal(prt_bake_fiv_table(NULL, 0, 1, samples), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, COUNT + 1, samples), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_fiv_table(&b.desc, -1, 1, samples), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 3, 0, NULL), PRT_OK);
    assert_int_equal(prt_bake_fiv_inside(NULL, 0, 1, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_inside(&b.desc, 0, 1, NULL), PRT_ERR_NULL);
    b.tracer.closest = NULL;
    assert_int_equal(prt_bake_fiv_inside(&b.desc, 0, 1, (unsigned char *)samples), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_count(NULL), 0);
    assert_memory_equal(samples, before, sizeof samples);
}

static void bad_environments_are_refused(void **state) {
    prt_fiv_env e = cube_env(4);
    prt_vec3 n = { 0, 0, 1 }, crooked = { 0, 0, PRT__R(1.1) };
    prt_rgb total = { 7, 7, 7 };
    prt_fiv f;
    bake b;
    (void)state;
    fill_texels(1);
    memset(&f, 0, sizeof f);
    assert_int_equal(prt_bake_fiv_environment(NULL, &f), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_environment(&e, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_irradiance(&e, -1, &n, &total), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_fiv_irradiance(NULL, 1, &n, &total), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_irradiance(&e, 1, NULL, &total), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_irradiance(&e, 1, &n, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_irradiance(&e, 1, &crooked, &total), PRT_ERR_VALUE);
    assert_int_equal(prt_bake_fiv_irradiance(&e, 0, NULL, NULL), PRT_OK);
    assert_int_equal(prt_bake_fiv_total(&e, 0, 0, 0, &total), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_fiv_total(&e, 1, 0, 7, &total), PRT_ERR_COUNT);
    assert_int_equal(prt_bake_fiv_total(&e, 1, 0, 6, NULL), PRT_ERR_NULL);
    assert_int_equal(prt_bake_fiv_total(NULL, 1, 0, 6, &total), PRT_ERR_NULL);
    skip_if_fast_math();
    texels[17] = (float)NAN;
    begin(&b);
    assert_int_equal(prt_bake_fiv_environment(&e, &f), PRT_ERR_VALUE);
    assert_int_equal(prt_bake_fiv_irradiance(&e, 1, &n, &total), PRT_ERR_VALUE);
    assert_int_equal(prt_bake_fiv_total(&e, 1, 0, 6, &total), PRT_ERR_VALUE);
    assert_int_equal(prt_bake_fiv_table(&b.desc, 0, 1, &f), PRT_ERR_VALUE);
    assert_true(total.r == 7 && f.r.x == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(total_of_a_white_sky_is_pi),
        cmocka_unit_test(totals_of_opposite_normals),
        cmocka_unit_test(totals_agree_with_quadrature),
        cmocka_unit_test(totals_tell_how_far_they_are),
        cmocka_unit_test(totals_of_a_cube_are_those_of_its_normals),
        cmocka_unit_test(vectors_are_those_of_hidden_texels),
        cmocka_unit_test(ball_under_a_white_sky),
        cmocka_unit_test(poles_are_single),
        cmocka_unit_test(any_range_gives_the_same_bits),
        cmocka_unit_test(inside_is_found_through_holes),
        cmocka_unit_test(progress_stops_and_callbacks_fail),
        cmocka_unit_test(one_block_of_memory_a_call),
        cmocka_unit_test(transfer_of_a_ball_is_its_cap),
        cmocka_unit_test(transfer_agrees_with_a_fresh_bake),
        cmocka_unit_test(transfer_ranges_errors_and_progress),
        cmocka_unit_test(distances_are_geometric),
        cmocka_unit_test(tables_are_made_of_descs),
        cmocka_unit_test(bad_arguments_write_nothing),
        cmocka_unit_test(bad_environments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
