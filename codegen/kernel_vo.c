/* Kernels of the room >>vo [Sherif 2013]: the terms of prt_vo_shade for one light, and one occluder; the loops, and
   the sum that is clamped at 0, are the caller's:
     out = emissive + sum over lights of (vo_direct times the product over occluders of vo_pass, plus the sum of
           vo_sent) */
#include "kernels.h"

#include <stddef.h>

static vec towards(kernel *k, vec from, vec to) { return vec_direction(k, vec_sub(k, to, from), NULL); }

static vec reflected(kernel *k, vec a, vec n) {
    return vec_sub(k, a, vec_scale(k, k_scale(k, 2, vec_dot(k, a, n)), n));
}

static node above0(kernel *k, node v) { return k_max(k, v, k_const(k, 0)); }

kernel *describe_vo_direct(int bands) {
    kernel *k = kernel_new("vo_direct", "light from a point light, without occluders");
    vec position = vec_param(k, "position"), normal = vec_param(k, "normal"), eye = vec_param(k, "eye");
    vec diffuse = vec_param(k, "diffuse"), specular = vec_param(k, "specular");
    node shininess = real_param(k, "shininess");
    vec light = vec_param(k, "light"), color = vec_param(k, "color");
    vec l = towards(k, position, light), mirror = reflected(k, towards(k, eye, position), normal);
    (void)bands;
    diffuse = vec_scale(k, above0(k, vec_dot(k, normal, l)), diffuse);
    specular = vec_scale(k, k_power(k, above0(k, vec_dot(k, mirror, l)), shininess), specular);
    vec_result(k, vec_times(k, color, vec_add(k, diffuse, specular)));
    return k;
}

/* sin^2 of the angle between unit vectors, 1 from 90 degrees on */
static node sine_squared(kernel *k, vec d, vec l) {
    vec cross = vec_cross(k, d, l);
    node one = k_const(k, 1), s = vec_dot(k, cross, cross);
    return k_select(k, k_const(k, 0), vec_dot(k, d, l), k_min(k, s, one), one);
}

/* (1 - T) block + T focus, focus = max(s2, sin^2 c0)^(-N_c F) */
static vec passed(kernel *k, node block, vec caustic, node factor, node strength, node least, vec transmissive, vec l) {
    node one = k_const(k, 1), zero = k_const(k, 0), length, exponent, focus;
    vec dir = vec_direction(k, caustic, &length), t;
    exponent = k_mul(k, strength, above0(k, factor));
    focus = k_pow(k, k_max(k, sine_squared(k, dir, l), least), k_neg(k, exponent));
    focus = k_select(k, zero, k_select(k, zero, length, exponent, zero), focus, one);
    t = vec_scale(k, focus, transmissive);
    t.x = k_madd(k, k_sub(k, one, transmissive.x), block, t.x);
    t.y = k_madd(k, k_sub(k, one, transmissive.y), block, t.y);
    t.z = k_madd(k, k_sub(k, one, transmissive.z), block, t.z);
    return t;
}

/* strength: N_sh, N_c, and sin^2 c0, which must be above 0 */
kernel *describe_vo_pass(int bands) {
    kernel *k = kernel_new("vo_pass", "share of a light that one occluder lets through");
    vec position = vec_param(k, "position"), light = vec_param(k, "light"), strength = vec_param(k, "strength");
    vec occlusion = vec_param(k, "occlusion"), caustic = vec_param(k, "caustic"),
        transmissive = vec_param(k, "transmissive");
    node factor = real_param(k, "form_factor"), caustic_factor = real_param(k, "caustic_factor"), length,
        zero = k_const(k, 0);
    vec l = towards(k, position, light), dir = vec_direction(k, occlusion, &length);
    node exponent = k_mul(k, strength.x, above0(k, factor)), block;
    (void)bands;
    block = k_power(k, sine_squared(k, dir, l), k_select(k, zero, length, exponent, zero));
    vec_result(k, passed(k, block, caustic, caustic_factor, strength.y, strength.z, transmissive, l));
    return k;
}

/* Share of the smaller of two discs behind the other: PRT__LENS_STEP of prt.h */
static node lens_step(kernel *k, node u, node ratio) {
    node one = k_const(k, 1), two = k_const(k, 2), square = k_mul(k, u, u), rest = k_sub(k, one, k_mul(k, two, u));
    node outer = k_scale(k, x_ratio(1, 5), k_mul(k, rest, k_sub(k, one, ratio)));
    node inner = k_scale(k, x_ratio(7, 5), k_mul(k, square, ratio));
    node correction = k_mul(k, k_mul(k, u, k_sub(k, one, u)), k_sub(k, outer, inner));
    return k_madd(k, square, k_sub(k, k_const(k, 3), k_mul(k, two, u)), correction);
}

/* strength: 2 sin(light_angle/2), N_c, sin^2 c0 */
kernel *describe_vo_pass_cap(int bands) {
    kernel *k = kernel_new("vo_pass_cap", "the same under PRT_VO_CAP, a cap before a light of some width");
    node zero = k_const(k, 0), one = k_const(k, 1);
    vec position = vec_param(k, "position"), normal = vec_param(k, "normal"), light = vec_param(k, "light");
    vec strength = vec_param(k, "strength"), occlusion = vec_param(k, "occlusion"), caustic = vec_param(k, "caustic");
    vec transmissive = vec_param(k, "transmissive"), l = towards(k, position, light), dir, apart;
    node factor = above0(k, real_param(k, "form_factor")), caustic_factor = real_param(k, "caustic_factor"), length;
    node cosine, sin2, cap, least, u, share, open;
    (void)bands;
    dir = vec_direction(k, occlusion, &length);
    cosine = vec_dot(k, normal, dir);
    sin2 = k_select(k, factor, cosine, k_div(k, factor, cosine), one);
    cap = k_sqrt(k, k_div(k, k_scale(k, 2, sin2), k_add(k, one, k_sqrt(k, k_sub(k, one, sin2)))));
    apart = vec_sub(k, dir, l);
    least = k_min(k, cap, strength.x);
    u = k_div(k, k_sub(k, k_add(k, cap, strength.x), vec_length(k, apart)), k_scale(k, 2, least));
    u = k_max(k, k_min(k, u, one), zero);
    share = k_div(k, least, strength.x);
    open = k_sub(k, one, k_mul(k, k_mul(k, share, share), lens_step(k, u, k_div(k, least, k_max(k, cap, strength.x)))));
    open = k_select(k, zero, k_min(k, k_min(k, length, factor), least), open, one);
    vec_result(k, passed(k, open, caustic, caustic_factor, strength.y, strength.z, transmissive, l));
    return k;
}

/* weights: of DD, DS and SS */
kernel *describe_vo_sent(int bands) {
    kernel *k = kernel_new("vo_sent", "light that one occluder sends on to the point");
    vec position = vec_param(k, "position"), normal = vec_param(k, "normal"), eye = vec_param(k, "eye");
    vec diffuse = vec_param(k, "diffuse"), specular = vec_param(k, "specular"), light = vec_param(k, "light");
    vec color = vec_param(k, "color"), place = vec_param(k, "occluder_position");
    vec diffuse_normal = vec_param(k, "diffuse_normal"), specular_normal = vec_param(k, "specular_normal");
    vec own_diffuse = vec_param(k, "occluder_diffuse"), own_specular = vec_param(k, "occluder_specular");
    vec weights = vec_param(k, "weights"), mirror = reflected(k, towards(k, eye, position), normal);
    node gloss = real_param(k, "gloss"), zero = k_const(k, 0), length, dd, ds, ss;
    vec v = towards(k, position, place), l = towards(k, place, light), n = vec_direction(k, specular_normal, &length);
    vec sum;
    (void)bands;
    dd = k_mul(k, weights.x, above0(k, vec_dot(k, diffuse_normal, l)));
    ds = k_power(k, above0(k, vec_dot(k, reflected(k, v, n), l)), gloss);
    ds = k_mul(k, k_mul(k, weights.y, length), ds);
    ss = k_power(k, above0(k, vec_dot(k, reflected(k, mirror, n), l)), gloss);
    ss = k_mul(k, k_mul(k, weights.z, length), ss);
    ss = k_mul(k, ss, k_select(k, zero, vec_dot(k, normal, v), above0(k, vec_dot(k, mirror, v)), zero));
    sum = vec_times(k, diffuse, vec_add(k, vec_scale(k, dd, own_diffuse), vec_scale(k, ds, own_specular)));
    sum = vec_add(k, sum, vec_times(k, specular, vec_scale(k, ss, own_specular)));
    vec_result(k, vec_times(k, color, sum));
    return k;
}

/* One wave of prt_vo_bend on one direction of an occluder; wave: amplitude, frequency, phase. v is turned about
   cross(along, across) by the angle of tangent frequency amplitude cos(frequency time + along.position + phase). */
kernel *describe_vo_bend(int bands) {
    kernel *k = kernel_new("vo_bend", "a direction of an occluder under a wave");
    vec along = vec_param(k, "along"), across = vec_param(k, "across"), wave = vec_param(k, "wave"), position, v, axis;
    node one = k_const(k, 1), time = real_param(k, "time"), angle, slope, cosine, sine;
    (void)bands;
    position = vec_param(k, "position");
    v = vec_param(k, "v");
    axis = vec_cross(k, along, across);
    angle = k_add(k, k_madd(k, wave.y, time, wave.z), vec_dot(k, along, position));
    slope = k_mul(k, k_mul(k, wave.x, wave.y), k_cos(k, angle));
    cosine = k_div(k, one, k_sqrt(k, k_madd(k, slope, slope, one)));
    sine = k_mul(k, slope, cosine);
    vec_result(k, vec_add(k, vec_add(k, vec_scale(k, cosine, v), vec_scale(k, sine, vec_cross(k, axis, v))),
                          vec_scale(k, k_mul(k, k_sub(k, one, cosine), vec_dot(k, axis, v)), axis)));
    return k;
}

/* A direction of a packed occluder, from its octahedral coordinates -1 ... 1 [Cigolle 2014] */
kernel *describe_vo_unfold(int bands) {
    kernel *k = kernel_new("vo_unfold", "a unit vector from octahedral coordinates");
    node x = real_param(k, "x"), y = real_param(k, "y"), zero = k_const(k, 0), below;
    vec v;
    (void)bands;
    v.z = k_sub(k, k_sub(k, k_const(k, 1), k_abs(k, x)), k_abs(k, y));
    below = above0(k, k_neg(k, v.z));
    v.x = k_select(k, x, zero, k_add(k, x, below), k_sub(k, x, below));
    v.y = k_select(k, y, zero, k_add(k, y, below), k_sub(k, y, below));
    vec_result(k, vec_direction(k, v, NULL));
    return k;
}
