#include "similarity.h"

#include <math.h>
#include <stdlib.h>

enum { REACH = 5 };                                        /* pixels on each side of the window's middle */

static double coded(double linear) {
    double v = linear > 0 ? linear < 1 ? linear : 1 : 0;
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055;
}

/* Luminance of each pixel; whole[] is 0 where a sample's alpha is below `least`. */
static void see(const picture *p, int per_pixel, double exposure, float least, double *seen, unsigned char *whole) {
    int width = p->width / per_pixel, height = p->height / per_pixel, x, y, i, j, c;
    for (y = 0; y < height; y++) {
        for (x = 0; x < width; x++) {
            double rgb[3] = { 0, 0, 0 };
            unsigned char covered = 1;
            for (j = 0; j < per_pixel; j++) {
                for (i = 0; i < per_pixel; i++) {
                    const float *s = p->rgba +
                                     4 * ((size_t)(y * per_pixel + j) * (size_t)p->width + (size_t)(x * per_pixel + i));
                    covered = (unsigned char)(covered && s[3] >= least);
                    for (c = 0; c < 3; c++)
                        rgb[c] += exposure * (s[c] > 0 ? (double)s[c] : 0) / (per_pixel * per_pixel);
                }
            }
            seen[y * width + x] = 0.2126 * coded(rgb[0]) + 0.7152 * coded(rgb[1]) + 0.0722 * coded(rgb[2]);
            whole[y * width + x] = covered;
        }
    }
}

/* Of one window; pixels beyond the edge are left out and the rest weighted up. */
static double window_similarity(const double *a, const double *b, int width, int height, int x, int y) {
    const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    double sum = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
    int i, j;
    for (j = y - REACH; j <= y + REACH; j++) {
        for (i = x - REACH; i <= x + REACH; i++) {
            double weight, va, vb;
            if (i < 0 || j < 0 || i >= width || j >= height) continue;
            weight = exp(-((i - x) * (i - x) + (j - y) * (j - y)) / (2 * 1.5 * 1.5));
            va = a[j * width + i];
            vb = b[j * width + i];
            sum += weight;
            ma += weight * va; mb += weight * vb;
            aa += weight * va * va; bb += weight * vb * vb; ab += weight * va * vb;
        }
    }
    ma /= sum; mb /= sum;
    aa = aa / sum - ma * ma; bb = bb / sum - mb * mb; ab = ab / sum - ma * mb;
    return (2 * ma * mb + c1) * (2 * ab + c2) / ((ma * ma + mb * mb + c1) * (aa + bb + c2));
}

double picture_similarity(const picture *a, const picture *b, int per_pixel, double exposure, float least) {
    int width = a->width / per_pixel, height = a->height / per_pixel, x, y;
    size_t count = (size_t)width * (size_t)height;
    double *seen = (double *)malloc(2 * count * sizeof *seen), sum = 0, windows = 0;
    unsigned char *whole = (unsigned char *)malloc(2 * count);
    if (seen && whole) {
        see(a, per_pixel, exposure, 0, seen, whole);
        see(b, per_pixel, exposure, least, seen + count, whole + count);
        for (y = 0; y < height; y++) {
            for (x = 0; x < width; x++) {
                if (!whole[count + (size_t)(y * width + x)]) continue;
                sum += window_similarity(seen, seen + count, width, height, x, y);
                windows += 1;
            }
        }
    }
    free(seen);
    free(whole);
    return windows > 0 ? sum / windows : NAN;
}
