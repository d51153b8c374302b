#include "cube_light.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "vector.h"

int cube_light_create(int size, cube_light *c, why *w) {
    size_t face = 3 * (size_t)size * (size_t)size;
    int k;
    memset(c, 0, sizeof *c);
    c->size = size;
    c->texels = (float *)calloc(6 * face, sizeof *c->texels);
    if (!c->texels) return why_set(w, "out of memory for a cube map of 6 x %d x %d texels", size, size);
    for (k = 0; k < 6; k++) c->faces[k] = c->texels + (size_t)k * face;
    return 0;
}

void cube_light_free(cube_light *c) {
    free(c->texels);
    free(c->texel);
    free(c->x);
    free(c->cumulative);
    free(c->guide);
    memset(c, 0, sizeof *c);
}

/* ---- where things are ---- */

prt_vec3 cube_light_direction(int face, double s, double t) {
    double a = 2 * s - 1, b = 2 * t - 1, sign = face % 2 ? -1 : 1, x, y, z, length = sqrt(1 + a * a + b * b);
    if (face < 2)      { x = sign;     y = -b;   z = -sign * a; }
    else if (face < 4) { x = a;        y = sign; z = sign * b; }
    else               { x = sign * a; y = -b;   z = sign; }
    return vec(x / length, y / length, z / length);
}

static prt_vec3 texel_centre(const cube_light *c, int texel) {
    int in_face = texel % (c->size * c->size);
    return cube_light_direction(texel / (c->size * c->size), (in_face % c->size + 0.5) / c->size,
                                (in_face / c->size + 0.5) / c->size);
}

int cube_light_texel(const cube_light *c, prt_vec3 direction) {
    double x = (double)direction.x, y = (double)direction.y, z = (double)direction.z;
    double ax = fabs(x), ay = fabs(y), az = fabs(z), a, b;
    int face, i, j;
    if (ax >= ay && ax >= az)  { face = x < 0;     a = (x < 0 ? z : -z) / ax;  b = -y / ax; }
    else if (ay >= az)         { face = 2 + (y < 0); a = x / ay;               b = (y < 0 ? -z : z) / ay; }
    else                       { face = 4 + (z < 0); a = (z < 0 ? -x : x) / az; b = -y / az; }
    i = (int)(0.5 * (a + 1) * c->size);
    j = (int)(0.5 * (b + 1) * c->size);
    if (i >= c->size) i = c->size - 1;
    if (j >= c->size) j = c->size - 1;
    return (face * c->size + j) * c->size + i;
}

/* Of the part of a face at distance 1 from its centre to (a, b). */
static double corner_angle(double a, double b) { return atan2(a * b, sqrt(a * a + b * b + 1)); }

double cube_light_solid_angle(const cube_light *c, int texel) {
    int in_face = texel % (c->size * c->size), i = in_face % c->size, j = in_face / c->size;
    double a0 = 2.0 * i / c->size - 1, a1 = 2.0 * (i + 1) / c->size - 1;
    double b0 = 2.0 * j / c->size - 1, b1 = 2.0 * (j + 1) / c->size - 1;
    return corner_angle(a0, b0) - corner_angle(a0, b1) - corner_angle(a1, b0) + corner_angle(a1, b1);
}

/* ---- filling ---- */

static void add_image_at(const image *from, prt_vec3 d, double weight, double sum[3]) {
    const float *texel;
    double phi = atan2((double)d.y, (double)d.x);
    int x = (int)((phi < 0 ? phi + 2 * pi : phi) / (2 * pi) * from->width), k;
    int y = (int)(acos((double)d.z) / pi * from->height);
    if (x >= from->width) x = from->width - 1;
    if (y >= from->height) y = from->height - 1;
    texel = from->rgb + 3 * ((size_t)y * (size_t)from->width + (size_t)x);
    for (k = 0; k < 3; k++) sum[k] += weight * (double)texel[k];
}

int cube_light_from_image(const image *from, int size, cube_light *c, why *w) {
    enum { ACROSS = 8 };                                   /* samples across a texel */
    int texel, i, j, k;
    if (cube_light_create(size, c, w)) return -1;
    for (texel = 0; texel < 6 * size * size; texel++) {
        int in_face = texel % (size * size);
        double sum[3] = { 0, 0, 0 }, weights = 0;
        for (j = 0; j < ACROSS; j++) {
            for (i = 0; i < ACROSS; i++) {
                double s = (in_face % size + (i + 0.5) / ACROSS) / size;
                double t = (in_face / size + (j + 0.5) / ACROSS) / size;
                double weight = pow(1 + (2 * s - 1) * (2 * s - 1) + (2 * t - 1) * (2 * t - 1), -1.5);
                add_image_at(from, cube_light_direction(texel / (size * size), s, t), weight, sum);
                weights += weight;
            }
        }
        for (k = 0; k < 3; k++) c->texels[3 * texel + k] = (float)(sum[k] / weights);
    }
    return 0;
}

void cube_light_add_patch(cube_light *c, prt_vec3 towards, int texels, float r, float g, float b) {
    int at = cube_light_texel(c, towards), face = at / (c->size * c->size), i0, j0, i, j;
    i0 = at % c->size - texels / 2;
    j0 = at / c->size % c->size - texels / 2;
    for (j = j0; j < j0 + texels; j++) {
        for (i = i0; i < i0 + texels; i++) {
            float *to = c->texels + 3 * ((face * c->size + j) * c->size + i);
            if (i < 0 || j < 0 || i >= c->size || j >= c->size) continue;
            to[0] += r; to[1] += g; to[2] += b;
        }
    }
}

void cube_light_set_ground(cube_light *c, prt_rgb albedo) {
    double sum[3] = { 0, 0, 0 };
    float ground[3];
    int texel, k;
    for (texel = 0; texel < 6 * c->size * c->size; texel++) {
        double z = (double)texel_centre(c, texel).z;
        for (k = 0; k < 3 && z > 0; k++)
            sum[k] += z * cube_light_solid_angle(c, texel) * (double)c->texels[3 * texel + k];
    }
    ground[0] = (float)((double)albedo.r * sum[0] / pi);
    ground[1] = (float)((double)albedo.g * sum[1] / pi);
    ground[2] = (float)((double)albedo.b * sum[2] / pi);
    for (texel = 0; texel < 6 * c->size * c->size; texel++)
        if (texel_centre(c, texel).z < 0) memcpy(c->texels + 3 * texel, ground, sizeof ground);
}

/* ---- the list ---- */

static int reserve(cube_light *c, size_t count, why *w) {
    float *columns = (float *)malloc((count + 1) * 6 * sizeof *columns);
    c->x = columns;                                        /* one block: freeing x frees all columns */
    c->texel = (int *)malloc((count + 1) * sizeof *c->texel);
    c->cumulative = (double *)malloc((count + 1) * sizeof *c->cumulative);
    c->guide = (int *)malloc((count + 1) * sizeof *c->guide);
    if (!columns || !c->texel || !c->cumulative || !c->guide) return why_set(w, "out of memory for the list of lights");
    c->y = columns + count; c->z = columns + 2 * count;
    c->r = columns + 3 * count; c->g = columns + 4 * count; c->b = columns + 5 * count;
    return 0;
}

static int is_black(const float *texel) { return !(texel[0] > 0 || texel[1] > 0 || texel[2] > 0); }

int cube_light_ready(cube_light *c, why *w) {
    int all = 6 * c->size * c->size, texel, k = 0;
    size_t count = 0;
    double sum = 0;
    for (texel = 0; texel < all; texel++) count += !is_black(c->texels + 3 * texel);
    if (count == 0) return why_set(w, "the environment is black: nothing would be seen");
    if (reserve(c, count, w)) return -1;
    for (texel = 0; texel < all; texel++) {
        const float *l = c->texels + 3 * texel;
        double angle = cube_light_solid_angle(c, texel);
        prt_vec3 d = texel_centre(c, texel);
        if (is_black(l)) continue;
        c->texel[k] = texel;
        c->x[k] = (float)d.x; c->y[k] = (float)d.y; c->z[k] = (float)d.z;
        c->r[k] = (float)(angle * (double)l[0]);
        c->g[k] = (float)(angle * (double)l[1]);
        c->b[k] = (float)(angle * (double)l[2]);
        c->cumulative[k] = sum;
        sum += 0.2126 * (double)c->r[k] + 0.7152 * (double)c->g[k] + 0.0722 * (double)c->b[k];
        k++;
    }
    c->count = k;
    c->cumulative[k] = sum;
    for (k = 0; k <= c->count; k++) c->cumulative[k] /= sum;
    for (k = 0, texel = 0; k <= c->count; k++) {
        while (texel < c->count - 1 && c->cumulative[texel + 1] * c->count <= k) texel++;
        c->guide[k] = texel;
    }
    return 0;
}

int cube_light_refine(const cube_light *from, int parts, cube_light *c, why *w) {
    int size = from->size * parts, face, i, j;
    if (cube_light_create(size, c, w)) return -1;
    for (face = 0; face < 6; face++)
        for (j = 0; j < size; j++)
            for (i = 0; i < size; i++)
                memcpy(c->texels + 3 * ((face * size + j) * size + i),
                       from->texels + 3 * ((face * from->size + j / parts) * from->size + i / parts),
                       3 * sizeof(float));
    return cube_light_ready(c, w);
}

int cube_light_draw(const cube_light *c, double u, double v, prt_vec3 *direction, double *chance) {
    int low = c->guide[(int)(u * c->count)], in_face;
    double across;
    while (low < c->count - 1 && c->cumulative[low + 1] <= u) low++;
    *chance = c->cumulative[low + 1] - c->cumulative[low];
    across = (u - c->cumulative[low]) / *chance;
    in_face = c->texel[low] % (c->size * c->size);
    *direction = cube_light_direction(c->texel[low] / (c->size * c->size), (in_face % c->size + across) / c->size,
                                      (in_face / c->size + v) / c->size);
    return low;
}

void cube_light_irradiance(const cube_light *c, prt_vec3 normal, double rgb[3]) {
    enum { BLOCK = 4096 };                                 /* float sums of so many, then double */
    float nx = (float)normal.x, ny = (float)normal.y, nz = (float)normal.z;
    int first, k;
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (first = 0; first < c->count; first += BLOCK) {
        int end = first + BLOCK < c->count ? first + BLOCK : c->count;
        float r = 0, g = 0, b = 0;
        for (k = first; k < end; k++) {
            float cosine = nx * c->x[k] + ny * c->y[k] + nz * c->z[k];
            cosine = cosine > 0 ? cosine : 0;
            r += cosine * c->r[k];
            g += cosine * c->g[k];
            b += cosine * c->b[k];
        }
        rgb[0] += (double)r; rgb[1] += (double)g; rgb[2] += (double)b;
    }
}
