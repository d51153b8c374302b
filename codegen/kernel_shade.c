/* Kernels of the room >>shade, and the dot product that it is made of. */
#include "kernels.h"

static node dot(kernel *k, int count, int f, int f_first, int g, int g_first) {
    node sum = k_const(k, 0);
    int i;
    for (i = 0; i < count; i++) sum = k_madd(k, k_element(k, f, f_first + i), k_element(k, g, g_first + i), sum);
    return sum;
}

kernel *describe_sh_dot(int bands) {
    kernel *k = named_kernel("sh_dot", "integral of a product", bands);
    int n = bands * bands, f = kernel_param(k, "f", PARAM_INPUT, n), g = kernel_param(k, "g", PARAM_INPUT, n);
    int out = kernel_param(k, "out", PARAM_RESULT, 1);
    kernel_output(k, out, 0, dot(k, n, f, 0, g, 0));
    return k;
}

/* light: three planes of bands^2 values, as in prt.h */
kernel *describe_shade_diffuse(int bands) {
    kernel *k = named_kernel("shade_diffuse", "exit radiance of a white diffuse surface", bands);
    int n = bands * bands, transfer = kernel_param(k, "transfer", PARAM_INPUT, n);
    int light = kernel_param(k, "light", PARAM_INPUT, 3 * n), out = kernel_param(k, "out", PARAM_RESULT, 3), c;
    for (c = 0; c < 3; c++) kernel_output(k, out, c, dot(k, n, transfer, 0, light, c * n));
    return k;
}

/* transfer: three planes too, one for each channel */
kernel *describe_shade_diffuse_rgb(int bands) {
    kernel *k = named_kernel("shade_diffuse_rgb", "exit radiance from transfer of three planes", bands);
    int n = bands * bands, transfer = kernel_param(k, "transfer", PARAM_INPUT, 3 * n);
    int light = kernel_param(k, "light", PARAM_INPUT, 3 * n), out = kernel_param(k, "out", PARAM_RESULT, 3), c;
    for (c = 0; c < 3; c++) kernel_output(k, out, c, dot(k, n, transfer, c * n, light, c * n));
    return k;
}

/* The share of four coefficients, for those that stand four a texel or attribute: the sum over all fours is
   shade_diffuse. */
kernel *describe_shade_diffuse_four(int bands) {
    kernel *k = kernel_new("shade_diffuse_four", "shade_diffuse, the share of four coefficients");
    static const char *const plane[3] = { "red", "green", "blue" };
    int transfer = kernel_param(k, "transfer", PARAM_FOUR, 4), light[3], out, c;
    (void)bands;
    for (c = 0; c < 3; c++) light[c] = kernel_param(k, plane[c], PARAM_FOUR, 4);
    out = kernel_param(k, "out", PARAM_RESULT, 3);
    for (c = 0; c < 3; c++) kernel_output(k, out, c, dot(k, 4, transfer, 0, light[c], 0));
    return k;
}
