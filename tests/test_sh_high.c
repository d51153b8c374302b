/* Room >>sh to 1024 bands, poles included. */
#define PRT_MAX_BANDS 1024
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"
#include "golden_csv.h"

#define EPS BY_PRECISION((double)FLT_EPSILON, DBL_EPSILON)
enum { N = PRT_SH_COUNT(PRT_MAX_BANDS) };
static prt_real *y;

/* The table holds values at the double direction; in float the direction itself is rounded, and near the poles that alone
   can move band l by l(l+1)/8 eps. What exceeds it is the error of the evaluation. */
static void agrees_with_golden_table_to_band_1000(void **state) {
    static golden_row rows[1000];
    static int checked[1000];
    FILE *f = golden_open("sh_ref_high.csv");
    int count = 0, i, j;
    (void)state;
    while (count < 1000 && golden_next(f, &rows[count])) count++;
    fclose(f);
    assert_int_equal(count, 960);
    for (i = 0; i < count; i++) {                      /* one evaluation for all rows of a direction */
        const golden_row *r = &rows[i];
        if (checked[i]) continue;
        assert_int_equal(prt_sh_eval(1024, prt__vec3((prt_real)r->x, (prt_real)r->y, (prt_real)r->z), y), PRT_OK);
        for (j = i; j < count; j++) {
            if (rows[j].x != r->x || rows[j].y != r->y || rows[j].z != r->z) continue;
            assert_near(y[PRT_SH_INDEX(rows[j].l, rows[j].m)], rows[j].value,
                        BY_PRECISION(1e-2, 1e-10) + golden_input_rounding(rows[j].l, EPS));
            checked[j] = 1;
        }
    }
}

/* sum over m of Y(l,m)^2 = (2l+1)/(4 pi) in every band, whatever the direction (the addition theorem). */
static void addition_theorem_holds_at_and_near_the_poles(void **state) {
    int k, l, m;
    (void)state;
    for (k = 0; k <= 44; k++) {
        double tilt = k == 44 ? 0 : pow(10, -k), s = sin(tilt), z = cos(tilt) * (k & 1 ? -1 : 1), worst = 0;
        prt_vec3 d = prt__vec3((prt_real)(0.6 * s), (prt_real)(0.8 * s), (prt_real)z);
        double length2 = (double)d.x * (double)d.x + (double)d.y * (double)d.y + (double)d.z * (double)d.z;
        assert_int_equal(prt_sh_eval(1024, d, y), PRT_OK);
        for (l = 0; l < 1024; l++) {
            double sum = 0, exact = (2 * l + 1) / (4 * PRT__PI);
            for (m = -l; m <= l; m++) {
                double v = (double)y[PRT_SH_INDEX(l, m)];
                if (!isfinite(v)) fail_msg("Y(%d,%d) is not finite at tilt %g", l, m, tilt);
                sum += v * v;
            }
            {   /* relative; a direction that is eps too long changes z against (x,y), which band l feels l^2/2 fold */
                double allowed = BY_PRECISION(1e-2, 1e-10) + (l + l * (double)l / 2) * fabs(length2 - 1);
                double excess = fabs(sum / exact - 1) - allowed;
                if (!(excess <= worst)) worst = excess;
            }
        }
        if (!(worst <= 0)) fail_msg("tilt %g: addition theorem exceeded by %g", tilt, worst);
    }
}

static void reconstruction_equals_evaluation_at_1024_bands(void **state) {
    static const double tilts[] = { 1.0, 1e-2, 1e-6, 1e-20, 0 };
    prt_real *f = (prt_real *)malloc(N * sizeof *f);
    size_t t;
    int i;
    (void)state;
    assert_non_null(f);
    for (i = 0; i < N; i++) f[i] = (prt_real)(sin(i * 0.7) / (1 + i));
    for (t = 0; t < sizeof tilts / sizeof tilts[0]; t++) {
        prt_vec3 d = prt__vec3((prt_real)(0.6 * sin(tilts[t])), (prt_real)(0.8 * sin(tilts[t])), (prt_real)cos(tilts[t]));
        double want = 0, size = 0;
        prt_sh_eval(1024, d, y);
        for (i = 0; i < N; i++) { want += (double)f[i] * (double)y[i]; size += fabs((double)f[i] * (double)y[i]); }
        assert_near(prt_sh_at(1024, f, d), want, size * EPS * 64);
    }
    free(f);
}

static void unscaled_batches_agree_up_to_their_last_band(void **state) {
    enum { COUNT = 40 };
    static const double tilts[] = { 1.2, 0.3, 0.05, 1e-2, 1e-3, 1e-5, 1e-12, 1e-30, 0, 1.5707 };
    int bands = PRT__SH_UNSCALED_V < 1024 ? PRT__SH_UNSCALED_V : 1024, k, i, n = bands * bands;
    prt_real x[COUNT], v[COUNT], z[COUNT], *soa = (prt_real *)malloc((size_t)n * COUNT * sizeof *soa);
    (void)state;
    assert_non_null(soa);
    for (k = 0; k < COUNT; k++) {
        double tilt = tilts[k % 10], turn = k / 10 * 1.1;
        x[k] = (prt_real)(sin(tilt) * cos(turn)); v[k] = (prt_real)(sin(tilt) * sin(turn)); z[k] = (prt_real)cos(tilt);
    }
    assert_int_equal(prt_sh_eval_soa(bands, COUNT, x, v, z, soa, COUNT), PRT_OK);
    for (k = 0; k < COUNT; k++) {
        prt_sh_eval(bands, prt__vec3(x[k], v[k], z[k]), y);
        for (i = 0; i < n; i++) assert_near(soa[(size_t)i * COUNT + (size_t)k], y[i], BY_PRECISION(2e-3, 1e-10));
    }
    assert_int_equal(prt_sh_eval_soa(1024, 1, x, v, z, y, 1), PRT_OK);        /* beyond it: one direction at a time */
    for (i = 0; i < N; i++) assert_true(isfinite((double)y[i]));
    free(soa);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_golden_table_to_band_1000),
        cmocka_unit_test(addition_theorem_holds_at_and_near_the_poles),
        cmocka_unit_test(reconstruction_equals_evaluation_at_1024_bands),
        cmocka_unit_test(unscaled_batches_agree_up_to_their_last_band),
    };
    int failed;
    y = (prt_real *)malloc(N * sizeof *y);
    if (!y) return 1;
    failed = cmocka_run_group_tests(tests, NULL, NULL);
    free(y);
    return failed;
}
