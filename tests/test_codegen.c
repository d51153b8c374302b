/* The generator's constants against MPFR, its graph against arithmetic, and the kernels as a whole: the values of every
   generated kernel are covered by the tests of its room. */
#ifdef __clang__
#  pragma clang diagnostic ignored "-Wconversion"
#else
#  pragma GCC diagnostic ignored "-Wconversion"
#endif
#include "../codegen/xreal.c"
#include "../codegen/graph.c"
#include "../codegen/approximate.c"
#include "shaders/error_bound.h"
#include "test.h"
#include <mpfr.h>

static void mpfr_text(mpfr_t v, int digits, char *text, long *exponent) {
    mpfr_exp_t e;
    char *s = mpfr_get_str(NULL, &e, 10, (size_t)digits, v, MPFR_RNDN);
    strcpy(text, s);
    mpfr_free_str(s);
    *exponent = (long)e;
}

/* The significant digits of a printed constant, without sign, point, exponent and zeros at either end. */
static void bare_digits(const char *text, char *digits) {
    int count = 0;
    for (; *text && *text != 'e'; text++)
        if (*text >= '0' && *text <= '9' && (count || *text != '0')) digits[count++] = *text;
    while (count && digits[count - 1] == '0') count--;
    digits[count] = 0;
}

static void constants_are_right_to_the_last_digit(void **state) {
    mpfr_t v;
    int k, digits;
    (void)state;
    mpfr_init2(v, 300);
    for (k = 1; k < 2000; k++)
        for (digits = 9; digits <= 21; digits += 4) {
            char got[64], want[64], got_digits[64], want_digits[64];
            long exponent;
            mpfr_const_pi(v, MPFR_RNDN);
            mpfr_div_ui(v, v, (unsigned long)k, MPFR_RNDN);
            mpfr_sqrt(v, v, MPFR_RNDN);
            mpfr_text(v, digits, want, &exponent);
            x_print(x_sqrt(x_pi() / k), digits, got);
            bare_digits(got, got_digits);
            bare_digits(want, want_digits);
            assert_string_equal(got_digits, want_digits);
            assert_near(strtod(got, NULL), mpfr_get_d(v, MPFR_RNDN), digits == 21 ? 0 : pow(10, 1 - digits));
        }
    mpfr_clear(v);
}

static void constants_print_in_every_range(void **state) {
    static const struct { double value; const char *text; } cases[] = {
        { 0, "0.0" }, { 1, "1.0" }, { -1, "-1.0" }, { 0.5, "0.5" }, { 12.5, "12.5" }, { 1200, "1200.0" }, { 0.0001220703125, "0.0001220703125" },
        { 9.5367431640625e-07, "9.5367431640625e-7" }, { 1e20, "1.0e20" }, { 99999999999.75, "100000000000.0" }
    };
    size_t i;
    (void)state;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[64];
        x_print((xreal)cases[i].value, i + 1 < sizeof cases / sizeof cases[0] ? 17 : 11, text);
        assert_string_equal(text, cases[i].text);
    }
}

static void equal_expressions_are_one_node_and_constants_fold(void **state) {
    kernel *k = kernel_new("test", "test");
    node x = k_scalar(k, kernel_param(k, "x", PARAM_SCALAR, 0)), y = k_scalar(k, kernel_param(k, "y", PARAM_SCALAR, 0));
    node two = k_const(k, 2);
    op_count c;
    int out = kernel_param(k, "out", PARAM_OUTPUT, 3);
    (void)state;
    assert_int_equal(k_mul(k, x, y), k_mul(k, y, x));
    assert_int_equal(k_add(k, x, y), k_add(k, y, x));
    assert_int_equal(k_add(k, x, k_neg(k, y)), k_sub(k, x, y));
    assert_int_equal(k_sub(k, x, k_neg(k, y)), k_add(k, x, y));
    assert_int_equal(k_neg(k, k_sub(k, x, y)), k_sub(k, y, x));
    assert_int_equal(k_neg(k, k_neg(k, x)), x);
    assert_int_equal(k_mul(k, k_const(k, 1), x), x);
    assert_int_equal(k_mul(k, k_const(k, 0), x), k_const(k, 0));
    assert_int_equal(k_add(k, k_const(k, 0), x), x);
    assert_int_equal(k_sub(k, x, x), k_const(k, 0));
    assert_int_equal(k_mul(k, two, k_const(k, 3)), k_const(k, 6));
    assert_int_equal(k_div(k, x, two), k_mul(k, k_const(k, (xreal)0.5), x));
    assert_int_equal(k_add(k, x, k_const(k, -2)), k_sub(k, x, two));
    kernel_output(k, out, 0, k_madd(k, x, y, two));    /* one product, one addition that fuses with it */
    kernel_output(k, out, 1, k_mul(k, k_add(k, x, y), k_add(k, y, x)));
    kernel_output(k, out, 2, k_sqrt(k, k_max(k, x, y)));
    kernel_count_uses(k);
    c = kernel_operations(k);
    assert_int_equal(c.multiplications, 2);
    assert_int_equal(c.additions, 2);
    assert_int_equal(c.fused, 1);
    assert_int_equal(c.roots, 1);
    assert_int_equal(c.others, 1);
    assert_int_equal(c.stores, 3);
    kernel_free(k);
}

static void arc_functions_keep_their_bounds(void **state) {
    const arithmetic exact = { 0, 0, 0, 0 };
    kernel *k = kernel_new("test", "test");
    node x = k_scalar(k, kernel_param(k, "x", PARAM_SCALAR, 0)), y = k_scalar(k, kernel_param(k, "y", PARAM_SCALAR, 0));
    int out = kernel_param(k, "out", PARAM_OUTPUT, 4), i;
    (void)state;
    kernel_output(k, out, 0, k_sine(k, k_scale(k, x_pi() / 2, x)));
    kernel_output(k, out, 1, k_arc_cosine(k, x));
    kernel_output(k, out, 2, k_arc_tangent(k, y, x));
    kernel_output(k, out, 3, k_power(k, k_max(k, x, k_const(k, 0)), y));
    kernel_count_uses(k);
    for (i = 0; i <= 4000; i++) {
        double in[2];
        bounded got[4];
        in[0] = -1 + i / 2000.0;
        in[1] = i % 3 ? sin(i) : i % 2 ? 0 : 1e-9 * in[0];
        bound_kernel(k, in, exact, got);
        assert_near(got[0].value, sin(3.141592653589793 / 2 * in[0]), 3e-11);
        assert_near(got[1].value, acos(in[0]), 5e-9);
        assert_near(got[2].value, in[0] == 0 && in[1] == 0 ? 0 : atan2(in[1], in[0]), 5e-9);
        assert_near(got[3].value, in[1] > 0 ? pow(in[0] > 0 ? in[0] : 0, in[1]) : 1, 1e-15);
    }
    kernel_free(k);
}

/* ((a + b) * (c + d)) needs three values at most at a time, the chain a + b + c + d two. */
static void live_values_are_counted_in_the_order_of_printing(void **state) {
    kernel *k = kernel_new("test", "test");
    int f = kernel_param(k, "f", PARAM_INPUT, 4), out = kernel_param(k, "out", PARAM_OUTPUT, 1);
    node a = k_element(k, f, 0), b = k_element(k, f, 1), c = k_element(k, f, 2), d = k_element(k, f, 3);
    (void)state;
    kernel_output(k, out, 0, k_mul(k, k_add(k, a, b), k_add(k, c, d)));
    kernel_count_uses(k);
    assert_int_equal(kernel_live_values(k), 3);
    kernel_free(k);
    k = kernel_new("test", "test");
    f = kernel_param(k, "f", PARAM_INPUT, 4);
    out = kernel_param(k, "out", PARAM_OUTPUT, 1);
    a = k_element(k, f, 0); b = k_element(k, f, 1); c = k_element(k, f, 2); d = k_element(k, f, 3);
    kernel_output(k, out, 0, k_add(k, k_add(k, k_add(k, a, b), c), d));
    kernel_count_uses(k);
    assert_int_equal(kernel_live_values(k), 2);
    kernel_free(k);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants_are_right_to_the_last_digit),
        cmocka_unit_test(constants_print_in_every_range),
        cmocka_unit_test(equal_expressions_are_one_node_and_constants_fold),
        cmocka_unit_test(arc_functions_keep_their_bounds),
        cmocka_unit_test(live_values_are_counted_in_the_order_of_printing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
