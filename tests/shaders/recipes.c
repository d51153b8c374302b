/* The loops of docs/shaders.md around the kernels of >>fiv and >>vo, with the generated C, against prt_fiv_shade_vectors and
   prt_vo_shade in double. The kernels are within 1e-5 of what they add up (docs/shaders-agreement.md), and there are at most
   12 terms. */
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

/* A uniform cap's vectors, so that what is hidden fits what is seen */
static double fiv_scene(void) {
    float total[3], normal[3], fiv[OCCLUDERS][9], to[OCCLUDERS][3], radius[OCCLUDERS], taken[OCCLUDERS][3], left[3];
    prt_fiv_hidden hidden[OCCLUDERS];
    prt_rgb want = { 0, 0, 0 };
    int count = rand() % (OCCLUDERS + 1), i, j, c;
    fill(total, 3, 1, 3);
    fill_unit(normal);
    for (i = 0; i < count; i++) {
        double distance = uniform(0.5, 4), sine;
        fill_unit(to[i]);
        radius[i] = (float)uniform(0.1, 1.5);
        sine = fmin(1, (double)radius[i] / distance);
        for (j = 0; j < 9; j++) fiv[i][j] = (float)(sine * sine) * total[j / 3] * to[i][j % 3];
        for (c = 0; c < 3; c++) to[i][c] *= (float)distance;
        hidden[i].fiv.r = vec3_of(fiv[i]);
        hidden[i].fiv.g = vec3_of(fiv[i] + 3);
        hidden[i].fiv.b = vec3_of(fiv[i] + 6);
        hidden[i].to_centre = vec3_of(to[i]);
        hidden[i].radius = (double)radius[i];
        prt_fiv_taken(total, normal, fiv[i], to[i], radius[i], taken[i]);
    }
    for (c = 0; c < 3; c++) {
        float sum = 0, most = 0, twice = 0;
        for (i = 0; i < count; i++) {
            sum += taken[i][c];
            most = fmaxf(most, taken[i][c]);
            for (j = 0; j < i; j++)
                twice += fminf(fminf(taken[i][c], taken[j][c]),
                               prt_fiv_overlap(to[i], radius[i], to[j], radius[j]) * (taken[i][c] + taken[j][c]));
        }
        left[c] = fmaxf(total[c] - fminf(fmaxf(sum - twice, most), sum), 0);
    }
    prt_fiv_shade_vectors(rgb_of(total), vec3_of(normal), count, hidden, 0, &want);
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
    float position[3], normal[3], eye[3], diffuse[3], specular[3], emissive[3], shininess, out[3], weights[3], strength[3];
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
        prt_vo_direct(position, normal, eye, diffuse, specular, shininess, place, color, direct);
        for (i = 0; i < count; i++) {
            float pass[3], sent[3];
            if (cap) prt_vo_pass_cap(position, normal, place, strength, o[i].occlusion, o[i].caustic, o[i].transmissive, o[i].factor,
                                     o[i].caustic_factor, pass);
            else prt_vo_pass(position, place, strength, o[i].occlusion, o[i].caustic, o[i].transmissive, o[i].factor,
                             o[i].caustic_factor, pass);
            prt_vo_sent(position, normal, eye, diffuse, specular, place, color, o[i].position, o[i].diffuse_normal,
                        o[i].specular_normal, o[i].diffuse, o[i].specular, weights, 8, sent);
            for (c = 0; c < 3; c++) { direct[c] *= pass[c]; out[c] += sent[c]; }
        }
        for (c = 0; c < 3; c++) out[c] += direct[c];
    }
    for (c = 0; c < 3; c++) out[c] = fmaxf(out[c], 0);
    prt_vo_shade(&params, &point, vec3_of(eye), count, occluders, LIGHTS, lights, &want);
    return difference(want, out) / fmax(1, fmax(want.r, fmax(want.g, want.b)));
}

static int report(int number, const char *name, double worst) {
    int ok = worst <= 12 * 1e-5;
    printf("%s %d - the loop of %s: largest difference %.1e\n", ok ? "ok" : "not ok", number, name, worst);
    return !ok;
}

int main(void) {
    double worst[3] = { 0, 0, 0 };
    int i, j, failed;
    for (i = 0; i < SCENES; i++)
        for (j = 0; j < 3; j++) {
            double d = j == 0 ? fiv_scene() : vo_scene(j == 2);
            if (!(d <= worst[j])) worst[j] = d;
        }
    failed = report(1, "moving occluders", worst[0]);
    failed |= report(2, "vector occluders", worst[1]);
    failed |= report(3, "vector occluders as caps", worst[2]);
    printf("1..3\n");
    return failed;
}
