/* What extremes.h measures at the ends of what numbers can hold stays within what arithmetic allows. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "test.h"
#include "extremes.h"

static void stays_within_its_bound(void **state) {
    const extreme_case *c = (const extreme_case *)*state;
    extreme e;
    if (FAST_MATH && c->subnormal) skip();
    e = c->measure(c->a, c->b);
    assert_at_most(0, e.bound);                        /* something was compared */
    assert_near(e.error, 0, e.bound);
}

/* Chains of masks without a window do grow: what the positive window is for. */
static void masks_without_a_window_grow(void **state) {
    (void)state;
    assert_at_most(2, extreme_mask_gain(64, PRT_WINDOW_NONE, 1));
    assert_at_most(extreme_mask_gain(64, PRT_WINDOW_HANN, 0), 0.1);
}

int main(void) {
    struct CMUnitTest tests[EXTREME_CASES + 1];
    int k;
    memset(tests, 0, sizeof tests);
    for (k = 0; k < EXTREME_CASES; k++) {
        tests[k].name = extreme_cases[k].what;
        tests[k].test_func = stays_within_its_bound;
        tests[k].initial_state = (void *)&extreme_cases[k];
    }
    tests[EXTREME_CASES].name = "masks_without_a_window_grow";
    tests[EXTREME_CASES].test_func = masks_without_a_window_grow;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
