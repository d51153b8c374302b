#include "environment.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "vector.h"

static double luminance_at(const image *map, size_t texel) {
    const float *v = map->rgb + 3 * texel;
    return 0.2126 * (double)v[0] + 0.7152 * (double)v[1] + 0.0722 * (double)v[2];
}

static int environment_tabulate(environment *e, why *w) {
    size_t width = (size_t)e->map.width, count = width * (size_t)e->map.height, k;
    double sum = 0;
    e->cumulative = (double *)malloc((count + 1) * sizeof *e->cumulative);
    if (!e->cumulative) return why_set(w, "out of memory");
    for (k = 0; k < count; k++) {
        double row = (double)(k / width);
        double height = cos(pi * row / e->map.height) - cos(pi * (row + 1) / e->map.height);
        e->cumulative[k] = sum;
        sum += luminance_at(&e->map, k) * height * 2 * pi / e->map.width;
    }
    if (!(sum > 0)) return why_set(w, "%s: the environment is black", e->name);
    e->cumulative[count] = sum;
    for (k = 0; k <= count; k++) e->cumulative[k] /= sum;
    e->scale = 1 / sum;
    return 0;
}

static void turn_map(image *map, double turn) {
    int shift = (int)(turn * map->width + 0.5) % map->width, y, x;
    float *row = (float *)malloc(3 * sizeof(float) * (size_t)map->width);
    if (!row) return;
    for (y = 0; y < map->height; y++) {
        float *in = map->rgb + 3 * (size_t)map->width * (size_t)y;
        for (x = 0; x < map->width; x++) memcpy(row + 3 * ((x + shift) % map->width), in + 3 * x, 3 * sizeof(float));
        memcpy(in, row, 3 * sizeof(float) * (size_t)map->width);
    }
    free(row);
}

int environment_load(const char *path, double turn, environment *e, why *w) {
    const char *slash = strrchr(path, '/'), *file = slash ? slash + 1 : path;
    snprintf(e->name, sizeof e->name, "%.*s", (int)strcspn(file, "."), file);
    if (image_load_environment(path, &e->map, w)) return -1;
    turn_map(&e->map, turn);
    if (prt_sh_project_equirect_rgb(ENVIRONMENT_BANDS, e->map.width, e->map.height, e->map.rgb, e->light) != PRT_OK)
        return why_set(w, "%s: cannot be projected", path);
    return environment_tabulate(e, w);
}

void environment_free(environment *e) {
    image_free(&e->map);
    free(e->cumulative);
    e->cumulative = NULL;
}

void environment_light(const environment *e, int bands, prt_real *light) {
    size_t count = (size_t)PRT_SH_COUNT(bands), c;
    for (c = 0; c < 3; c++)
        memcpy(light + c * count, e->light + c * PRT_SH_COUNT(ENVIRONMENT_BANDS), count * sizeof *light);
}

size_t environment_texel(const environment *e, prt_vec3 d) {
    const image *map = &e->map;
    double phi = atan2((double)d.y, (double)d.x);
    int x = (int)((phi < 0 ? phi + 2 * pi : phi) / (2 * pi) * map->width);
    int y = (int)(acos(d.z > 1 ? 1 : d.z < -1 ? -1 : (double)d.z) / pi * map->height);
    if (x >= map->width) x = map->width - 1;
    if (y >= map->height) y = map->height - 1;
    return (size_t)y * (size_t)map->width + (size_t)x;
}

prt_vec3 environment_sample(const environment *e, double u, double v, size_t *texel) {
    size_t low = 0, high = (size_t)e->map.width * (size_t)e->map.height;
    double top, bottom, z, across, phi, r;
    prt_vec3 d;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (e->cumulative[middle] <= u) low = middle; else high = middle;
    }
    across = (u - e->cumulative[low]) / (e->cumulative[low + 1] - e->cumulative[low]);
    top = cos(pi * (double)(low / (size_t)e->map.width) / e->map.height);
    bottom = cos(pi * (double)(low / (size_t)e->map.width + 1) / e->map.height);
    z = top + v * (bottom - top);
    phi = 2 * pi * ((double)(low % (size_t)e->map.width) + across) / e->map.width;
    r = sqrt(z * z < 1 ? 1 - z * z : 0);
    d.x = (prt_real)(r * cos(phi));
    d.y = (prt_real)(r * sin(phi));
    d.z = (prt_real)z;
    *texel = low;
    return d;
}

void environment_add(const environment *e, size_t texel, double cosine, int cosine_rays, int light_rays,
                     double sum[3]) {
    double over_pi = cosine / pi;
    double density = cosine_rays * over_pi + light_rays * luminance_at(&e->map, texel) * e->scale;
    int c;
    if (!(density > 0)) return;
    for (c = 0; c < 3; c++) sum[c] += (double)e->map.rgb[3 * texel + (size_t)c] * over_pi / density;
}
