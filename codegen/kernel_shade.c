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
