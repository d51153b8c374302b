/* The ray-traced reference of the demo and its figures: closed forms for what a ball takes of a white sky, for the
   irradiance of one texel, for errors and their uncertainty. The camera looks straight down on the plane z = 0. */
#define _POSIX_C_SOURCE 200809L
#define _ISOC11_SOURCE
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "../examples/common/environment.c"
#include "../examples/common/parallel.c"
#include "../examples/common/progress.c"
#include "../examples/common/reference.c"
#include "../examples/common/why.c"

enum { SIZE = 10, MAP_WIDTH = 64, MAP_HEIGHT = 32 };

static float map_values[3 * MAP_WIDTH * MAP_HEIGHT];

/* ---- what the reference takes from elsewhere ---- */

int image_load_environment(const char *path, image *im, why *w) {
    memset(im, 0, sizeof *im);
    im->width = MAP_WIDTH;
    im->height = MAP_HEIGHT;
    im->rgb = (float *)malloc(sizeof map_values);
    if (!im->rgb) return why_set(w, "%s: out of memory", path);
    memcpy(im->rgb, map_values, sizeof map_values);
    return 0;
}
void image_free(image *im) { free(im->rgb); im->rgb = NULL; }

int picture_create(int width, int height, picture *p, why *w) {
    p->width = width;
    p->height = height;
    p->rgba = (float *)calloc(4 * (size_t)width * (size_t)height, sizeof *p->rgba);
    return p->rgba ? 0 : why_set(w, "out of memory");
}
void picture_free(picture *p) { free(p->rgba); p->rgba = NULL; }

camera_frame camera_make_frame(const camera *c, double aspect) {        /* down, +x to the right; 2 wide from 1 up */
    camera_frame f;
    (void)c;
    memset(&f, 0, sizeof f);
    f.right[0] = aspect;
    f.up[1] = 1;
    f.forward[2] = -1;
    return f;
}

/* ---- the scene: a square of two triangles, |x|, |y| < 0.8, and a ball over it that only shadow rays see ---- */

static prt_point corners[4] = {
    { { (prt_real)-0.8, (prt_real)-0.8, 0 }, { 0, 0, 1 } }, { { (prt_real)0.8, (prt_real)-0.8, 0 }, { 0, 0, 1 } },
    { { (prt_real)0.8, (prt_real)0.8, 0 }, { 0, 0, 1 } },   { { (prt_real)-0.8, (prt_real)0.8, 0 }, { 0, 0, 1 } }
};
static uint32_t triangles[6] = { 0, 1, 2, 0, 2, 3 };
static double ball_height = 3, ball_radius;

static int scene_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    int k;
    (void)user;
    for (k = 0; k < count; k++) {
        double x = -(double)rays[k].origin.x, y = -(double)rays[k].origin.y, z = ball_height - (double)rays[k].origin.z;
        double along = x * (double)rays[k].dir.x + y * (double)rays[k].dir.y + z * (double)rays[k].dir.z;
        blocked[k] = along > 0 && x * x + y * y + z * z - along * along < ball_radius * ball_radius;
    }
    return 0;
}

static int scene_closest(void *user, int count, const prt_ray *rays, prt_hit *hits) {
    int k;
    (void)user;
    for (k = 0; k < count; k++) {
        double t = -(double)rays[k].origin.z / (double)rays[k].dir.z;
        double x = ((double)rays[k].origin.x + t * (double)rays[k].dir.x) / 1.6 + 0.5;
        double y = ((double)rays[k].origin.y + t * (double)rays[k].dir.y) / 1.6 + 0.5;
        int first = x >= y;
        memset(hits + k, 0, sizeof *hits);
        hits[k].object = x > 0 && x < 1 && y > 0 && y < 1 ? 0 : -1;
        hits[k].primitive = !first;
        hits[k].u = (prt_real)(first ? x - y : x);           /* of corner 1 of the triangle, then corner 2 */
        hits[k].v = (prt_real)(first ? y : y - x);
    }
    return 0;
}

typedef struct setting {
    mesh                  scene;
    prt_tracer            tracer;
    environment           environments[REFERENCE_LIGHTS];
    reference             r;
    volatile sig_atomic_t stop;
} setting;

static void paint(float value) {
    int i;
    for (i = 0; i < 3 * MAP_WIDTH * MAP_HEIGHT; i++) map_values[i] = value;
}

/* The environments are whatever map_values holds, and a quarter and a half turn of it. */
static setting *make_setting(int threads) {
    setting *s = (setting *)calloc(1, sizeof *s);
    why w;
    int e;
    assert_non_null(s);
    s->scene.point_count = 4;
    s->scene.triangle_count = 2;
    s->scene.points = corners;
    s->scene.triangles = triangles;
    s->tracer.occluded = scene_occluded;
    s->tracer.closest = scene_closest;
    for (e = 0; e < REFERENCE_LIGHTS; e++)
        assert_int_equal(environment_load("data/some.hdr", 0.25 * e, &s->environments[e], &w), 0);
    s->r.scene = &s->scene;
    s->r.object_triangles = 1;
    s->r.tracer = &s->tracer;
    s->r.environments = s->environments;
    s->r.eye.eye.z = 1;
    s->r.width = s->r.height = SIZE;
    s->r.threads = threads;
    s->r.stop = &s->stop;
    return s;
}

static void drop_setting(setting *s) {
    int e;
    reference_free(&s->r);
    for (e = 0; e < REFERENCE_LIGHTS; e++) environment_free(&s->environments[e]);
    free(s);
}

static void trace_setting(setting *s) {
    why w;
    assert_int_equal(reference_trace(&s->r, &w), 0);
}

static double place(int i) { return 2 * (i + 0.5) / SIZE - 1; }
static const float *sample_at(const picture *p, int x, int y) { return p->rgba + 4 * ((size_t)y * SIZE + (size_t)x); }

/* ---- light ---- */

/* A ball of radius r at height h, above the horizon, takes h r^2 / d^3 of a white sky. The samples' rays are independent,
   so their mean error is normal, with a standard error that their scatter tells; 5 of them, here and below. */
static void a_ball_takes_its_form_factor(void **state) {
    setting *s;
    int half, x, y, b;
    (void)state;
    paint(1);
    ball_radius = 1.5;
    s = make_setting(2);
    trace_setting(s);
    for (half = 0; half < REFERENCE_HALVES; half++) {
        for (b = -1; b < REFERENCE_BAND_COUNTS; b++) {
            const reference_half *h = &s->r.halves[half];
            const picture *p = b < 0 ? &h->reference[1] : &h->floor[1][b];
            double sum = 0, squares = 0, count = 0;
            for (y = 0; y < SIZE; y++) {
                for (x = 0; x < SIZE; x++) {
                    double px = place(x), py = -place(y), d = sqrt(px * px + py * py + ball_height * ball_height), error;
                    const float *v = sample_at(p, x, y);
                    int outside = fabs(px) > 0.8 || fabs(py) > 0.8;
                    if (outside || b >= 0 || fabs(px - py) > 0.1)
                        assert_near(v[3], outside ? 0 : b >= 0 || px > py ? 1 : 0.5, 0);
                    if (outside) continue;
                    error = (double)v[0] - (1 - ball_height * ball_radius * ball_radius / (d * d * d));
                    assert_near(v[1], v[0], 64 * 6e-8);             /* 64 products, however they are ordered */
                    assert_at_most(fabs(error), 5 * 0.5 / sqrt((double)REFERENCE_COSINE_RAYS));     /* as if random */
                    sum += error;
                    squares += error * error;
                    count++;
                }
            }
            assert_at_most(fabs(sum), 5 * sqrt(squares));
            assert_near(count, 64, 0);
        }
    }
    drop_setting(s);
}

/* Only light rays find one bright texel. Its irradiance over pi: width/2pi * (sin^2 b - sin^2 a) * L. */
static void one_texel_gives_its_irradiance(void **state) {
    const int row = 5, column = 20;
    double a = pi * row / MAP_HEIGHT, b = pi * (row + 1) / MAP_HEIGHT;
    double want = 1000.0 / MAP_WIDTH * (sin(b) * sin(b) - sin(a) * sin(a));
    double sum = 0, squares = 0;
    setting *s;
    int e, x, y, c;
    (void)state;
    paint(0);
    for (c = 0; c < 3; c++) map_values[3 * (row * MAP_WIDTH + column) + c] = 1000;
    ball_radius = 0;
    s = make_setting(2);
    trace_setting(s);
    for (e = 0; e < REFERENCE_LIGHTS; e++) {                 /* turned or not */
        for (y = 1; y < SIZE - 1; y++) {
            for (x = 1; x < SIZE - 1; x++) {
                double error = (double)sample_at(&s->r.halves[0].reference[e], x, y)[0] - want;
                assert_at_most(fabs(error), 0.25 * want);    /* of the few cosine rays that hit it, beside 256 light rays */
                sum += error;
                squares += error * error;
            }
        }
    }
    assert_at_most(fabs(sum), 5 * sqrt(squares));
    drop_setting(s);
}

static void threads_give_the_same_picture(void **state) {
    setting *one, *three;
    int half, e;
    (void)state;
    skip_if_fast_math();
    paint(1);
    ball_radius = 1.5;
    one = make_setting(1);
    three = make_setting(3);
    trace_setting(one);
    trace_setting(three);
    for (half = 0; half < REFERENCE_HALVES; half++)
        for (e = 0; e < REFERENCE_LIGHTS; e++)
            assert_memory_equal(one->r.halves[half].reference[e].rgba, three->r.halves[half].reference[e].rgba,
                                4 * SIZE * SIZE * sizeof(float));
    drop_setting(one);
    drop_setting(three);
}

static void a_black_environment_is_refused(void **state) {
    environment e;
    why w;
    (void)state;
    paint(0);
    memset(&e, 0, sizeof e);
    assert_int_equal(environment_load("data/night.hdr", 0, &e, &w), -1);
    assert_non_null(strstr(w.line, "night: the environment is black"));
    environment_free(&e);
}

/* ---- figures ---- */

static uint64_t random_state = 12345;
static double gaussian(void) {           /* the sum of twelve uniform numbers: variance 1 */
    double sum = -6;
    int k;
    for (k = 0; k < 12; k++) {
        random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        sum += (double)(random_state >> 11) / 9007199254740992.0;
    }
    return sum;
}

typedef struct figures { picture p; reference r; } figures;

static void make_figures(figures *f, int size) {
    why w;
    int half;
    memset(f, 0, sizeof *f);
    assert_int_equal(picture_create(size, size, &f->p, &w), 0);
    for (half = 0; half < REFERENCE_HALVES; half++) {
        assert_int_equal(picture_create(size, size, &f->r.halves[half].reference[0], &w), 0);
        assert_int_equal(picture_create(size, size, &f->r.halves[half].floor[0][0], &w), 0);
    }
}
static void drop_figures(figures *f) { picture_free(&f->p); reference_free(&f->r); }

/* Truth is 1 everywhere, the picture has error e and the floor error g, the halves have noise, in the floor the same and
   some of its own. */
static void fill(figures *f, double e, double g, double noise, double own) {
    size_t count = 4 * (size_t)f->p.width * (size_t)f->p.height, i;
    int half;
    for (i = 0; i < count; i++) {
        f->p.rgba[i] = i % 4 == 3 ? 1 : (float)(1 + e);
        for (half = 0; half < REFERENCE_HALVES; half++) {
            double n = noise * gaussian();
            f->r.halves[half].reference[0].rgba[i] = i % 4 == 3 ? 1 : (float)(1 + n);
            f->r.halves[half].floor[0][0].rgba[i] = i % 4 == 3 ? 1 : (float)(1 + g + 0.5 * n + own * gaussian());
        }
    }
}

static double picture_error(const figures *f, float least) {
    return reference_error(&f->p, &f->p, &f->r.halves[0].reference[0], &f->r.halves[1].reference[0], 2, least);
}
static double floor_error(const figures *f) {
    return reference_error(&f->r.halves[0].floor[0][0], &f->r.halves[1].floor[0][0], &f->r.halves[0].reference[0],
                           &f->r.halves[1].reference[0], 2, 0.5f);
}

static void errors_are_relative_and_of_whole_pixels(void **state) {
    figures f;
    (void)state;
    make_figures(&f, 8);
    fill(&f, 0.25, -0.125, 0, 0);
    assert_near(picture_error(&f, 0.5f), 0.25, 1e-7);
    assert_near(floor_error(&f), 0.125, 1e-7);
    f.r.halves[0].reference[0].rgba[3] = 0;                   /* one sample of the first pixel is background: no error there */
    f.p.rgba[4] = 1e6f;
    assert_near(picture_error(&f, 0.5f), 0.25, 1e-7);
    assert_near(picture_error(&f, 2), 0, 0);                 /* nothing is covered */
    fill(&f, -1.5, 0, 0, 0);                                 /* negative radiance shows as black */
    assert_near(picture_error(&f, 0.5f), 1, 1e-7);
    drop_figures(&f);
}

/* 400 times noise anew: the mean of the squared error is right however large the noise, and the scatter of the
   difference is what reference_uncertainty says, within 5 standard errors of a standard deviation. */
static void noise_leaves_the_mean_alone_and_its_scatter_is_known(void **state) {
    enum { TIMES = 400, SAMPLES = 16 };
    const double e = 0.1, g = 0.06;
    double sum = 0, squares = 0, predicted = 0;
    figures f;
    int k;
    (void)state;
    make_figures(&f, SAMPLES);
    for (k = 0; k < TIMES; k++) {
        double a, b, difference, u;
        fill(&f, e, g, 0.1, 0.02);
        a = picture_error(&f, 0.5f);
        b = floor_error(&f);
        difference = a * a - b * b - (e * e - g * g);
        u = reference_uncertainty(&f.r, 0, 0, &f.p, 2, 0.5f);
        sum += difference;
        squares += difference * difference;
        predicted += u * u;
    }
    assert_at_most(fabs(sum), 5 * sqrt(squares));
    assert_near(sqrt(squares / predicted), 1, 5 / sqrt(2.0 * TIMES));
    drop_figures(&f);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ball_takes_its_form_factor),
        cmocka_unit_test(one_texel_gives_its_irradiance),
        cmocka_unit_test(threads_give_the_same_picture),
        cmocka_unit_test(a_black_environment_is_refused),
        cmocka_unit_test(errors_are_relative_and_of_whole_pixels),
        cmocka_unit_test(noise_leaves_the_mean_alone_and_its_scatter_is_known)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
