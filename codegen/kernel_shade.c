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

/* Three planes of what arrives, through the factors of a lobe about dir, sqrt(4 pi/(2l+1)) zonal_l */
kernel *describe_shade_glossy(int bands) {
    kernel *k = named_kernel("shade_glossy", "exit radiance of a lobe about a direction", bands);
    int n = bands * bands, incident = kernel_param(k, "incident", PARAM_INPUT, 3 * n), l, i, c;
    node zonal[64], y[64 * 64], sum[3];
    vec dir;
    input_nodes(k, "zonal", bands, zonal);
    dir = vec_param(k, "dir");
    sh_values(k, bands, dir.x, dir.y, dir.z, y);
    for (c = 0; c < 3; c++) sum[c] = k_const(k, 0);
    for (l = 0; l < bands; l++) {
        node factor = k_scale(k, x_sqrt(4 * x_pi() / (2 * l + 1)), zonal[l]);
        for (i = l * l; i < (l + 1) * (l + 1); i++) {
            node value = k_mul(k, factor, y[i]);
            for (c = 0; c < 3; c++) sum[c] = k_madd(k, value, k_element(k, incident, c * n + i), sum[c]);
        }
    }
    vec_result(k, vec_of(sum));
    return k;
}

kernel *describe_phong_zonal(int bands) {
    kernel *k = named_kernel("phong_zonal", "Phong's lobe of integral 1 about +z", bands);
    node s = real_param(k, "exponent"), moment[2], zonal[64];
    int l;
    moment[0] = k_const(k, 1);
    moment[1] = k_div(k, k_add(k, s, moment[0]), k_add(k, s, k_const(k, 2)));
    for (l = 0; l < bands; l++) {
        if (l > 1) moment[l % 2] = k_mul(k, moment[l % 2], k_div(k, k_sub(k, s, k_const(k, l - 2)),
                                                                 k_add(k, s, k_const(k, l + 1))));
        zonal[l] = k_scale(k, x_sqrt((2 * l + 1) / (4 * x_pi())), moment[l % 2]);
    }
    output_nodes(k, "zonal", bands, zonal);
    return k;
}

/* Rows tangent, bitangent, normal [Duff 2017] */
kernel *describe_local_frame(int bands) {
    kernel *k = kernel_new("local_frame", "rotation from the world to a frame whose z is the normal");
    vec n = vec_param(k, "normal");
    node one = k_const(k, 1), sign = k_select(k, n.z, k_const(k, 0), k_const(k, -1), one), r[9];
    node a = k_neg(k, k_div(k, one, k_add(k, sign, n.z))), b = k_mul(k, k_mul(k, n.x, n.y), a);
    (void)bands;
    r[0] = k_madd(k, sign, k_mul(k, k_mul(k, n.x, n.x), a), one);
    r[1] = k_mul(k, sign, b);
    r[2] = k_neg(k, k_mul(k, sign, n.x));
    r[3] = b;
    r[4] = k_madd(k, k_mul(k, n.y, n.y), a, sign);
    r[5] = k_neg(k, n.y);
    r[6] = n.x;
    r[7] = n.y;
    r[8] = n.z;
    output_nodes(k, "r", 9, r);
    return k;
}
