#include "kernels.h"

#include <stddef.h>

vec vec_element(kernel *k, int from, int element) {
    vec v;
    v.x = k_element(k, from, element);
    v.y = k_element(k, from, element + 1);
    v.z = k_element(k, from, element + 2);
    return v;
}
vec vec_of(const node v[3]) {
    vec a;
    a.x = v[0]; a.y = v[1]; a.z = v[2];
    return a;
}
vec vec_param(kernel *k, const char *name) { return vec_element(k, kernel_param(k, name, PARAM_DIRECTION, 3), 0); }
node real_param(kernel *k, const char *name) { return k_scalar(k, kernel_param(k, name, PARAM_SCALAR, 0)); }

void vec_result(kernel *k, vec value) {
    int out = kernel_param(k, "out", PARAM_RESULT, 3);
    kernel_output(k, out, 0, value.x);
    kernel_output(k, out, 1, value.y);
    kernel_output(k, out, 2, value.z);
}
void real_result(kernel *k, node value) { kernel_output(k, kernel_param(k, "out", PARAM_RESULT, 1), 0, value); }

void input_nodes(kernel *k, const char *name, int count, node *values) {
    int p = kernel_param(k, name, PARAM_INPUT, count), i;
    for (i = 0; i < count; i++) values[i] = k_element(k, p, i);
}
void output_nodes(kernel *k, const char *name, int count, const node *values) {
    int p = kernel_param(k, name, PARAM_OUTPUT, count), i;
    for (i = 0; i < count; i++) kernel_output(k, p, i, values[i]);
}

node vec_dot(kernel *k, vec a, vec b) { return k_madd(k, a.x, b.x, k_madd(k, a.y, b.y, k_mul(k, a.z, b.z))); }
vec vec_sub(kernel *k, vec a, vec b) {
    a.x = k_sub(k, a.x, b.x); a.y = k_sub(k, a.y, b.y); a.z = k_sub(k, a.z, b.z);
    return a;
}
vec vec_add(kernel *k, vec a, vec b) {
    a.x = k_add(k, a.x, b.x); a.y = k_add(k, a.y, b.y); a.z = k_add(k, a.z, b.z);
    return a;
}
vec vec_scale(kernel *k, node s, vec a) {
    a.x = k_mul(k, s, a.x); a.y = k_mul(k, s, a.y); a.z = k_mul(k, s, a.z);
    return a;
}
vec vec_times(kernel *k, vec a, vec b) {
    a.x = k_mul(k, a.x, b.x); a.y = k_mul(k, a.y, b.y); a.z = k_mul(k, a.z, b.z);
    return a;
}
vec vec_cross(kernel *k, vec a, vec b) {
    vec c;
    c.x = k_sub(k, k_mul(k, a.y, b.z), k_mul(k, a.z, b.y));
    c.y = k_sub(k, k_mul(k, a.z, b.x), k_mul(k, a.x, b.z));
    c.z = k_sub(k, k_mul(k, a.x, b.y), k_mul(k, a.y, b.x));
    return c;
}
node vec_length(kernel *k, vec a) { return k_sqrt(k, vec_dot(k, a, a)); }

vec vec_direction(kernel *k, vec a, node *length) {
    node zero = k_const(k, 0), l = vec_length(k, a);
    if (length) *length = l;
    return vec_scale(k, k_select(k, zero, l, k_div(k, k_const(k, 1), l), zero), a);
}
