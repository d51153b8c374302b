#define PRT_IMPLEMENTATION
#include "prt.h"
#include "test.h"

static void diffuse_is_three_dot_products(void **state) {
    prt_real transfer[2][4] = { { 1, 2, 3, 4 }, { -1, 0, 0, 1 } };
    prt_real light[12] = { 1, 0, 0, 0,  0, 1, 0, 0,  1, 1, 1, 1 };
    prt_rgb out[2];
    (void)state;
    assert_int_equal(prt_shade_diffuse_n(2, 2, &transfer[0][0], light, out), PRT_OK);
    assert_near(out[0].r, 1, 0); assert_near(out[0].g, 2, 0); assert_near(out[0].b, 10, 0);
    assert_near(out[1].r, -1, 0); assert_near(out[1].g, 0, 0); assert_near(out[1].b, 0, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = { cmocka_unit_test(diffuse_is_three_dot_products) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
