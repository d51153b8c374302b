/* What docs/shaders.md builds from the kernels, with the generated C, against prt.h in double: the loops around the
   kernels of >>fiv and >>vo, whose kernels are within 1e-5 of what they add up (docs/shaders-agreement.md), at most 12
   terms; packed occluders; exponentials; deringing. */
#define PRT_DOUBLE
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"

#include <stdio.h>
#include <stdlib.h>

#include "recipe_kernels.h"

enum { SCENES = 2000, OCCLUDERS = 4, LIGHTS = 3 };

static double uniform(double low, double high) { return low + (high - low) * (rand() / (RAND_MAX + 1.0)); }
static void fill(float *v, int count, double low, double high) {
    int i;
    for (i = 0; i < count; i++) v[i] = (float)uniform(low, high);
}
static void fill_unit(float *v) {
    double z = uniform(-1, 1), phi = uniform(0, 2 * PRT__PI), s = sqrt(1 - z * z);
    v[0] = (float)(s * cos(phi)); v[1] = (float)(s * sin(phi)); v[2] = (float)z;
}
static prt_vec3 vec3_of(const float *v) { return prt__vec3((double)v[0], (double)v[1], (double)v[2]); }
static prt_rgb rgb_of(const float *v) {
    prt_rgb c;
    c.r = (double)v[0]; c.g = (double)v[1]; c.b = (double)v[2];
    return c;
}
static double difference(prt_rgb want, const float *got) {
    return fmax(fabs(want.r - (double)got[0]), fmax(fabs(want.g - (double)got[1]), fabs(want.b - (double)got[2])));
}

/* A part of a uniform cap's vectors, so that what is hidden fits what is seen; more than all under a bright spot */
static double fiv_scene(unsigned flags) {
    float total[3], normal[3], fiv[OCCLUDERS][9], to[OCCLUDERS][3], radius[OCCLUDERS], taken[OCCLUDERS][3];
    float filled[OCCLUDERS][3];
    float left[3], both[OCCLUDERS][OCCLUDERS][3];
    prt_fiv_hidden hidden[OCCLUDERS];
    prt_rgb want = { 0, 0, 0 };
    int count = rand() % (OCCLUDERS + 1), i, j, c;
    fill(total, 3, 1, 3);
    fill_unit(normal);
    for (i = 0; i < count; i++) {
        double distance = uniform(0.5, 4), fill_part = uniform(0.1, 1.2), sine;
        fill_unit(to[i]);
        radius[i] = (float)uniform(0.1, 1.5);
        sine = fmin(1, (double)radius[i] / distance);
        for (j = 0; j < 9; j++) fiv[i][j] = (float)(fill_part * sine * sine) * total[j / 3] * to[i][j % 3];
        for (c = 0; c < 3; c++) to[i][c] *= (float)distance;
        hidden[i].fiv.r = vec3_of(fiv[i]);
        hidden[i].fiv.g = vec3_of(fiv[i] + 3);
        hidden[i].fiv.b = vec3_of(fiv[i] + 6);
        hidden[i].to_centre = vec3_of(to[i]);
        hidden[i].radius = (double)radius[i];
        kernel_fiv_taken(total, normal, fiv[i], to[i], radius[i], taken[i]);
        kernel_fiv_filled(total, normal, taken[i], to[i], radius[i], filled[i]);
        for (j = 0; j < i; j++) {
            float lens = kernel_fiv_overlap(to[i], radius[i], to[j], radius[j]);
            for (c = 0; c < 3; c++)
                both[i][j][c] = fminf((taken[i][c] + taken[j][c]) * lens, fminf(taken[i][c], taken[j][c]));
            if (flags & PRT_FIV_FILLED_OVERLAP)
                kernel_fiv_twice(to[i], radius[i], taken[i], filled[i], to[j], radius[j], taken[j], filled[j], both[i][j]);
        }
    }
    for (c = 0; c < 3; c++) {
        float sum = 0, most = 0, twice = 0;
        for (i = 0; i < count; i++) {
            sum += taken[i][c];
            most = fmaxf(most, taken[i][c]);
            for (j = 0; j < i; j++) twice += both[i][j][c];
        }
        left[c] = fmaxf(total[c] - fminf(fmaxf(sum - twice, most), sum), 0);
    }
    prt_fiv_shade_vectors(rgb_of(total), vec3_of(normal), count, hidden, flags, &want);
    return difference(want, left);
}

typedef struct occluder {
    float position[3], occlusion[3], caustic[3], transmissive[3], diffuse_normal[3], specular_normal[3];
    float diffuse[3], specular[3], factor, caustic_factor;
} occluder;

static prt_vo_occluder fill_occluder(occluder *o) {
    prt_vo_occluder v;
    fill(o->position, 3, -2, 2);
    fill_unit(o->occlusion);
    fill_unit(o->caustic);
    fill(o->transmissive, 3, 0, 1);
    fill(o->diffuse_normal, 3, -0.3, 0.3);
    fill(o->specular_normal, 3, -0.3, 0.3);
    fill(o->diffuse, 3, 0, 1);
    fill(o->specular, 3, 0, 1);
    fill(&o->factor, 1, 0, 0.5);
    fill(&o->caustic_factor, 1, 0, 0.5);
    v.position = vec3_of(o->position);
    v.occlusion = vec3_of(o->occlusion);
    v.caustic = vec3_of(o->caustic);
    v.transmissive = rgb_of(o->transmissive);
    v.diffuse_normal = vec3_of(o->diffuse_normal);
    v.specular_normal = vec3_of(o->specular_normal);
    v.diffuse = rgb_of(o->diffuse);
    v.specular = rgb_of(o->specular);
    v.form_factor = (double)o->factor;
    v.caustic_factor = (double)o->caustic_factor;
    return v;
}

static double vo_scene(int cap) {
    float position[3], normal[3], eye[3], diffuse[3], specular[3], emissive[3], shininess, out[3], weights[3];
    float strength[3];
    occluder o[OCCLUDERS];
    prt_vo_occluder occluders[OCCLUDERS];
    prt_point_light lights[LIGHTS];
    prt_vo_params params;
    prt_vo_point point;
    prt_rgb want = { 0, 0, 0 };
    int count = rand() % (OCCLUDERS + 1), i, j, c;
    memset(&params, 0, sizeof params);
    fill(position, 3, -1, 1); fill_unit(normal); fill(eye, 3, -3, 3);
    fill(diffuse, 3, 0, 1); fill(specular, 3, 0, 1); fill(emissive, 3, 0, 1); fill(&shininess, 1, 1, 10);
    fill(weights, 3, 0.2, 1); weights[0] = -weights[0];                            /* DD that drains colour */
    strength[0] = cap ? 2 * sinf((float)PRT__PI / 72) : 1.5f;
    strength[1] = 0.5f;
    strength[2] = sinf((float)PRT__PI / 180) * sinf((float)PRT__PI / 180);
    params.law = cap ? PRT_VO_CAP : PRT_VO_SINE;
    params.dd = (double)weights[0]; params.ds = (double)weights[1]; params.ss = (double)weights[2];
    point.position = vec3_of(position); point.normal = vec3_of(normal);
    point.diffuse = rgb_of(diffuse); point.specular = rgb_of(specular); point.emissive = rgb_of(emissive);
    point.shininess = (double)shininess;
    memcpy(out, emissive, sizeof out);
    for (i = 0; i < count; i++) occluders[i] = fill_occluder(&o[i]);
    for (j = 0; j < LIGHTS; j++) {
        float place[3], color[3], direct[3];
        fill(place, 3, -5, 5);
        fill(color, 3, 0, 1);
        lights[j].position = vec3_of(place);
        lights[j].color = rgb_of(color);
        kernel_vo_direct(position, normal, eye, diffuse, specular, shininess, place, color, direct);
        for (i = 0; i < count; i++) {
            float pass[3], sent[3];
            if (cap) kernel_vo_pass_cap(position, normal, place, strength, o[i].occlusion, o[i].caustic,
                                        o[i].transmissive, o[i].factor, o[i].caustic_factor, pass);
            else kernel_vo_pass(position, place, strength, o[i].occlusion, o[i].caustic, o[i].transmissive,
                                o[i].factor, o[i].caustic_factor, pass);
            kernel_vo_sent(position, normal, eye, diffuse, specular, place, color, o[i].position, o[i].diffuse_normal,
                        o[i].specular_normal, o[i].diffuse, o[i].specular, weights, 8, sent);
            for (c = 0; c < 3; c++) { direct[c] *= pass[c]; out[c] += sent[c]; }
        }
        for (c = 0; c < 3; c++) out[c] += direct[c];
    }
    for (c = 0; c < 3; c++) out[c] = fmaxf(out[c], 0);
    prt_vo_shade(&params, &point, vec3_of(eye), count, occluders, LIGHTS, lights, &want);
    return difference(want, out) / fmax(1, fmax(want.r, fmax(want.g, want.b)));
}

/* ---- packed occluders: GLSL's functions, and the words as docs/shaders.md reads them ---- */

static void unpackHalf2x16(uint32_t word, float v[2]) {
    int i;
    for (i = 0; i < 2; i++, word >>= 16) {
        int exponent = (int)(word >> 10 & 31), mantissa = (int)(word & 1023);
        v[i] = (float)ldexp(exponent ? 1024 + mantissa : mantissa, (exponent ? exponent : 1) - 25) *
               (word & 0x8000u ? -1.0f : 1.0f);
    }
}
static void unpackSnorm2x16(uint32_t word, float v[2]) {
    v[0] = fmaxf((float)(int16_t)(word & 0xffffu) / 32767, -1);
    v[1] = fmaxf((float)(int16_t)(word >> 16) / 32767, -1);
}

static double apart(prt_vec3 want, const float *got) {
    return fmax(fabs(want.x - (double)got[0]), fmax(fabs(want.y - (double)got[1]), fabs(want.z - (double)got[2])));
}

static double packed_scene(void) {
    float position[3], xy[2], zf[2], o[2], length[2], place[3], occlusion[3], normal[3], diffuse[3];
    const float unit = 4;
    occluder values;
    prt_vo_occluder in = fill_occluder(&values), want;
    prt_vo_packed p;
    int c;
    memset(&want, 0, sizeof want);
    fill(position, 3, -1, 1);
    if (prt_vo_pack((double)unit, vec3_of(position), 1, &in, &p) != PRT_OK ||
        prt_vo_unpack((double)unit, vec3_of(position), 1, &p, &want) != PRT_OK) return NAN;
    unpackHalf2x16(p.word[0], xy);
    unpackHalf2x16(p.word[1], zf);
    unpackSnorm2x16(p.word[2], o);
    unpackHalf2x16(p.word[4], length);
    place[0] = position[0] + unit * xy[0]; place[1] = position[1] + unit * xy[1]; place[2] = position[2] + unit * zf[0];
    kernel_vo_unfold(o[0], o[1], occlusion);
    kernel_vo_unfold(((float)(p.word[3] & 4095u) - 2048) / 2047, ((float)(p.word[3] >> 12 & 4095u) - 2048) / 2047,
                     normal);
    for (c = 0; c < 3; c++) normal[c] *= length[0];
    for (c = 0; c < 3; c++) if (!(zf[1] > 0)) occlusion[c] = 0;
    diffuse[0] = (float)(p.word[3] >> 24) / 255;
    diffuse[0] *= diffuse[0];
    return fmax(fmax(apart(want.position, place), apart(want.occlusion, occlusion)),
                fmax(apart(want.diffuse_normal, normal),
                     fmax(fabs(want.form_factor - (double)zf[1]), fabs(want.diffuse.r - (double)diffuse[0]))));
}

/* ---- functions of 4 bands ---- */

enum { N = 16 };

/* Difference of coefficients over the largest of them */
static double coefficients_apart(const double *want, const float *got) {
    double worst = 0, largest = 0;
    int i;
    for (i = 0; i < N; i++) {
        double d = fabs(want[i] - (double)got[i]);
        if (!(d <= worst)) worst = d;
        if (fabs(want[i]) > largest) largest = fabs(want[i]);
    }
    return worst / largest;
}

static double exponential(void) {
    float f[N], out[N], f0, size = 0;
    double in[N], want[N] = { 0 };
    int i, h;
    fill(f, N, -2, 2);
    f[0] = (float)uniform(-8, 0);
    for (i = 0; i < N; i++) in[i] = (double)f[i];
    if (prt_sh_exp(4, in, want) != PRT_OK) return NAN;
    f0 = f[0];
    f[0] = 0;
    for (i = 0; i < N; i++) size += f[i] * f[i];
    h = (int)fmaxf(0, ceilf(0.5f * log2f(fmaxf(size, 1e-30f))));
    for (i = 0; i < N; i++) f[i] *= exp2f(-(float)h);
    kernel_sh_exp_series(f, out);
    for (; h > 0; h--) {
        float copy[N];
        memcpy(copy, out, sizeof copy);
        kernel_sh_square(copy, out);
    }
    for (i = 0; i < N; i++) out[i] *= expf(0.282094792f * f0);
    return coefficients_apart(want, out);
}

static double dering(void) {
    float f[N], out[N];
    double in[N], want[N] = { 0 }, strength = 0;
    int i;
    fill(f, N, -1, 1);
    f[0] = 2;
    for (i = 0; i < N; i++) in[i] = (double)f[i];
    if (prt_sh_dering(4, in, want, &strength) != PRT_OK) return NAN;
    kernel_sh_window_dering((float)strength, f, out);
    return coefficients_apart(want, out);
}

static int report(int number, const char *name, int scenes, double (*scene)(void), double allowed) {
    double worst = 0;
    int i, ok;
    for (i = 0; i < scenes; i++) {
        double d = scene();
        if (!(d <= worst)) worst = d;
    }
    ok = worst <= allowed;
    printf("%s %d - %s: largest difference %.1e\n", ok ? "ok" : "not ok", number, name, worst);
    return !ok;
}

static double fiv_whole_scene(void) { return fiv_scene(0); }
static double fiv_filled_scene(void) { return fiv_scene(PRT_FIV_FILLED_OVERLAP); }
static double vo_sine_scene(void) { return vo_scene(0); }
static double vo_cap_scene(void) { return vo_scene(1); }

int main(void) {
    int failed = report(1, "the loop of moving occluders", SCENES, fiv_whole_scene, 12 * 1e-5);
    failed |= report(2, "the loop of moving occluders that fill a part", SCENES, fiv_filled_scene, 12 * 1e-5);
    failed |= report(3, "the loop of vector occluders", SCENES, vo_sine_scene, 12 * 1e-5);
    failed |= report(4, "the loop of vector occluders as caps", SCENES, vo_cap_scene, 12 * 1e-5);
    failed |= report(5, "packed vector occluders", SCENES, packed_scene, 4e-6);
    failed |= report(6, "exponentials", 200, exponential, 2e-4);
    failed |= report(7, "deringing", 20, dering, 1e-6);
    printf("1..7\n");
    return failed;
}
