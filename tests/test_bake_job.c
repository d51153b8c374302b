/* The bake of the examples: threads, checkpoints, interruption, resumption, and points where transfer bends. Rays are
   blocked by a ball over the plane z = 0. */
#define _POSIX_C_SOURCE 200809L
#define _ISOC11_SOURCE                 /* timespec_get */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "../examples/common/bake_job.c"
#include "../examples/common/mesh.c"
#include "../examples/common/progress.c"
#include "../examples/common/refined_bake.c"
#include "../examples/common/replacement.c"
#include "../examples/common/transfer_file.c"
#include "../examples/common/why.c"

enum { SIDE = 12, POINTS = SIDE * SIDE, BANDS = 3, ROW = BANDS * BANDS, RAYS = 64 };

int raw_mesh_import(const char *path, raw_mesh *m, why *w) {
    memset(m, 0, sizeof *m);
    return why_set(w, "%s: not here", path);
}
void raw_mesh_free(raw_mesh *m) { (void)m; }

/* ---- the scene ---- */

typedef struct ball {
    double height, radius;
    int    fail_after, hold_after;     /* rays, then tracing fails, or waits for *until; 0: never */
    volatile sig_atomic_t *until;
    int    rays;
    mtx_t  lock;
} ball;

static int ball_blocks(const ball *b, const prt_ray *r) {
    double z = (double)r->origin.z - b->height, x = (double)r->origin.x, y = (double)r->origin.y;
    double along = x * (double)r->dir.x + y * (double)r->dir.y + z * (double)r->dir.z;
    double miss = x * x + y * y + z * z - along * along;
    return along < 0 && miss < b->radius * b->radius;
}

static int ball_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    ball *b = (ball *)user;
    int k, sum;
    mtx_lock(&b->lock);
    sum = b->rays += count;
    mtx_unlock(&b->lock);
    if (b->fail_after > 0 && sum > b->fail_after) return 1;
    while (b->hold_after > 0 && sum > b->hold_after && !*b->until) {
        const struct timespec pause = { 0, 1000000 };
        thrd_sleep(&pause, NULL);
    }
    for (k = 0; k < count; k++) blocked[k] = (unsigned char)ball_blocks(b, rays + k);
    return 0;
}

typedef struct setting {
    ball          occluder;
    prt_tracer    tracer;
    prt_point     points[POINTS];
    bake_job      job;
    unsigned char done[POINTS];
    prt_real      transfer[POINTS * ROW], expected[POINTS * ROW];
    volatile sig_atomic_t stop;
    int           checkpoints, marked, wrong;
} setting;

static void start_over(setting *s) {
    memset(s->done, 0, sizeof s->done);
    memset(s->transfer, 0, sizeof s->transfer);
    s->occluder.rays = 0;
    s->stop = 0;
}

static int set_up(void **state) {
    static setting s;
    int k;
    memset(&s, 0, sizeof s);
    mtx_init(&s.occluder.lock, mtx_plain);
    s.occluder.height = 1;
    s.occluder.radius = 0.5;
    s.tracer.user = &s.occluder;
    s.tracer.occluded = ball_occluded;
    for (k = 0; k < POINTS; k++) {
        s.points[k].position.x = (prt_real)(k % SIDE - SIDE / 2) / 4;
        s.points[k].position.y = (prt_real)(k / SIDE - SIDE / 2) / 4;
        s.points[k].normal.z = 1;
    }
    s.job.desc.bands = BANDS;
    s.job.desc.samples = RAYS;
    s.job.desc.tracer = &s.tracer;
    s.job.point_count = POINTS;
    s.job.points = s.points;
    s.job.threads = 2;
    s.job.done = s.done;
    s.job.transfer = s.transfer;
    s.job.stop = &s.stop;
    *state = &s;
    return prt_bake_transfer(&s.job.desc, POINTS, s.points, 0, POINTS, s.expected) == PRT_OK ? 0 : -1;
}

static int clean_up(void **state) { mtx_destroy(&((setting *)*state)->occluder.lock); return 0; }

static int marks(const unsigned char *done) {
    int k, sum = 0;
    for (k = 0; k < POINTS; k++) sum += done[k];
    return sum;
}

/* ---- threads ---- */

static void any_number_of_threads_gives_the_same_bits(void **state) {
    static const int threads[] = { 1, 2, 3, 7, 300, 0 };
    setting *s = (setting *)*state;
    size_t k;
    skip_if_fast_math();
    for (k = 0; k < sizeof threads / sizeof *threads; k++) {
        start_over(s);
        s->job.threads = threads[k];
        assert_int_equal(bake_job_run(&s->job), PRT_OK);
        assert_int_equal(marks(s->done), POINTS);
        assert_memory_equal(s->transfer, s->expected, sizeof s->expected);
    }
}

static void a_failing_tracer_ends_the_job(void **state) {
    setting *s = (setting *)*state;
    s->occluder.rays = 0;
    s->occluder.fail_after = 40 * RAYS;
    assert_int_equal(bake_job_run(&s->job), PRT_ERR_TRACE);
    assert_in_range(marks(s->done), 0, 40);
}

/* ---- checkpoints and interruption ---- */

static void look_at_checkpoint(void *user, const unsigned char *done, const prt_real *transfer) {
    setting *s = (setting *)user;
    int k, now = marks(done);
    s->checkpoints++;
    s->wrong += now < s->marked;
    s->marked = now;
    for (k = 0; k < POINTS; k++)
        if (done[k]) s->wrong += memcmp(transfer + k * ROW, s->expected + k * ROW, ROW * sizeof(prt_real)) != 0;
    if (now > 0 && s->checkpoints >= 2) s->stop = 1;
}

/* Tracing waits half way for the second checkpoint, which stops the job. */
static void checkpoints_hold_finished_rows_and_a_stopped_job_resumes(void **state) {
    setting *s = (setting *)*state;
    unsigned char first[POINTS];
    int kept, k;
    skip_if_fast_math();
    start_over(s);
    s->occluder.hold_after = POINTS / 2 * RAYS;
    s->occluder.until = &s->stop;
    s->job.checkpoint = look_at_checkpoint;
    s->job.checkpoint_every = 1e-3;
    s->job.user = s;
    assert_int_equal(bake_job_run(&s->job), PRT_ERR_CANCELLED);
    assert_int_equal(s->wrong, 0);
    assert_true(s->checkpoints >= 2);
    kept = marks(s->done);
    assert_in_range(kept, s->marked, POINTS - 1);
    for (k = 0; k < POINTS; k++)
        if (s->done[k]) assert_memory_equal(s->transfer + k * ROW, s->expected + k * ROW, ROW * sizeof(prt_real));
    memcpy(first, s->done, sizeof first);

    for (k = 0; k < POINTS * ROW; k++) if (first[k / ROW]) s->transfer[k] = 77;      /* what is done is not touched */
    s->stop = 0;
    s->occluder.hold_after = s->occluder.rays = 0;
    s->job.checkpoint = NULL;
    s->job.threads = 3;
    assert_int_equal(bake_job_run(&s->job), PRT_OK);
    assert_int_equal(s->occluder.rays, RAYS * (POINTS - kept));
    for (k = 0; k < POINTS * ROW; k++) {
        if (first[k / ROW]) assert_near(s->transfer[k], 77, 0);
        else assert_near(s->transfer[k], s->expected[k], 0);
    }
}

static void no_checkpoint_before_its_time(void **state) {
    setting *s = (setting *)*state;
    start_over(s);
    s->job.checkpoint = look_at_checkpoint;
    s->job.checkpoint_every = 60;
    s->job.user = s;
    assert_int_equal(bake_job_run(&s->job), PRT_OK);
    assert_int_equal(s->checkpoints, 0);
}

static void a_job_that_is_stopped_before_it_starts_does_nothing(void **state) {
    setting *s = (setting *)*state;
    start_over(s);
    s->stop = 1;
    assert_int_equal(bake_job_run(&s->job), PRT_ERR_CANCELLED);
    assert_int_equal(marks(s->done), 0);
    assert_int_equal(s->occluder.rays, 0);
}

/* ---- points where transfer bends ---- */

static void make_ground(mesh *m) {
    static const prt_vec3 places[4] = { { -6, -6, 0 }, { 6, -6, 0 }, { 6, 6, 0 }, { -6, 6, 0 } };
    static const uint32_t triangles[6] = { 0, 1, 2, 0, 2, 3 };
    why w;
    int k;
    memset(m, 0, sizeof *m);
    m->point_count = 4;
    m->triangle_count = 2;
    m->points = (prt_point *)calloc(4, sizeof *m->points);
    m->triangles = (uint32_t *)malloc(sizeof triangles);
    for (k = 0; k < 4; k++) {
        m->points[k].position = places[k];
        m->points[k].normal.z = 1;
    }
    memcpy(m->triangles, triangles, sizeof triangles);
    for (k = 0; k < 3; k++) assert_int_equal(mesh_cut_edges(m, NULL, NULL, NULL, &w), 0);
}

/* The largest error of sky light in the middles of edges: light of band 0 alone, which a ball of radius r at height h
   takes h r^2 / d^3 of [form factor of a sphere above the horizon]. */
static double worst_middle(const refined_bake *r, const ball *b) {
    const mesh *m = r->m;
    double worst = 0;
    int i;
    for (i = 0; i < 3 * m->triangle_count; i++) {
        uint32_t at[2];
        double value = 0, x = 0, y = 0, d, error;
        int k;
        at[0] = m->triangles[i];
        at[1] = m->triangles[i % 3 == 2 ? i - 2 : i + 1];
        for (k = 0; k < 2; k++) {
            value += 0.5 * (double)r->job.transfer[ROW * (size_t)at[k]] * 3.5449077018110320546;
            x += 0.5 * (double)m->points[at[k]].position.x;
            y += 0.5 * (double)m->points[at[k]].position.y;
        }
        d = sqrt(x * x + y * y + b->height * b->height);
        error = fabs(value - (1 - b->height * b->radius * b->radius / (d * d * d)));
        if (!(error <= worst)) worst = error;
    }
    return worst;
}

static void points_gather_where_transfer_bends(void **state) {
    setting *s = (setting *)*state;
    refined_bake r;
    double worst[2];
    int level, near_points = 0, far_points = 0, k;
    mesh m;
    why w;
    make_ground(&m);                                         /* 81 points, 1.5 apart; the ball is 1 wide */
    for (level = 0; level < 2; level++) {
        memset(&r, 0, sizeof r);
        r.job.desc = s->job.desc;
        r.job.desc.samples = 1024;
        r.job.threads = 2;
        r.m = &m;
        r.levels = level ? 4 : 0;
        r.tolerance = 0.01;
        assert_int_equal(refined_bake_run(&r, &w), 0);
        assert_int_equal(r.job.point_count, m.point_count);
        worst[level] = worst_middle(&r, &s->occluder);
        if (level) break;
        free(r.job.transfer);
    }
    for (k = 0; k < m.point_count; k++) {
        double x = (double)m.points[k].position.x, y = (double)m.points[k].position.y;
        near_points += x * x + y * y < 4;
        far_points += x * x + y * y > 16;
    }
    assert_at_most(0.05, worst[0]);                          /* otherwise this scene shows nothing */
    assert_at_most(worst[1], 0.02);                          /* 1.5 times the tolerance in band 0, and noise */
    assert_at_most(m.point_count, 81 * 16);                  /* of 81 * 256 */
    assert_true(near_points > 4 * far_points / 10);          /* on a tenth of the area */
    for (k = 0; k < m.point_count; k += 37) {                /* rows are what one call would have baked */
        static prt_real row[81 * 16 * ROW];
        skip_if_fast_math();
        assert_int_equal(prt_bake_transfer(&r.job.desc, m.point_count, m.points, k, 1, row), PRT_OK);
        assert_memory_equal(row + k * ROW, r.job.transfer + k * ROW, ROW * sizeof(prt_real));
    }
    free(r.job.transfer);
    mesh_free(&m);
}

static void a_flat_white_ground_is_cut_once(void **state) {
    setting *s = (setting *)*state;
    refined_bake r;
    mesh m;
    why w;
    make_ground(&m);
    memset(&r, 0, sizeof r);
    r.job.desc = s->job.desc;
    r.job.threads = 2;
    r.m = &m;
    r.levels = 4;
    r.tolerance = 0.05;
    s->occluder.radius = 0;
    assert_int_equal(refined_bake_run(&r, &w), 0);
    assert_int_equal(m.point_count, 17 * 17);
    free(r.job.transfer);
    mesh_free(&m);
}

static void a_stopped_refinement_says_so(void **state) {
    setting *s = (setting *)*state;
    refined_bake r;
    mesh m;
    why w;
    make_ground(&m);
    memset(&r, 0, sizeof r);
    r.job.desc = s->job.desc;
    r.job.stop = &s->stop;
    r.m = &m;
    r.levels = 4;
    s->stop = 1;
    assert_int_equal(refined_bake_run(&r, &w), -1);
    assert_non_null(strstr(w.line, prt_result_string(PRT_ERR_CANCELLED)));
    free(r.job.transfer);
    mesh_free(&m);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(any_number_of_threads_gives_the_same_bits, set_up, clean_up),
        cmocka_unit_test_setup_teardown(a_failing_tracer_ends_the_job, set_up, clean_up),
        cmocka_unit_test_setup_teardown(checkpoints_hold_finished_rows_and_a_stopped_job_resumes, set_up, clean_up),
        cmocka_unit_test_setup_teardown(no_checkpoint_before_its_time, set_up, clean_up),
        cmocka_unit_test_setup_teardown(a_job_that_is_stopped_before_it_starts_does_nothing, set_up, clean_up),
        cmocka_unit_test_setup_teardown(points_gather_where_transfer_bends, set_up, clean_up),
        cmocka_unit_test_setup_teardown(a_flat_white_ground_is_cut_once, set_up, clean_up),
        cmocka_unit_test_setup_teardown(a_stopped_refinement_says_so, set_up, clean_up)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
