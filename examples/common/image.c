#include "image.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "replacement.h"

enum { MOST_PIXELS = 1 << 27 };                            /* 16384 x 8192 */

void image_free(image *im) {
    free(im->rgb);
    memset(im, 0, sizeof *im);
}

/* ---- reading ---- */

/* What stb_image reads from. Debian's stb_image goes round for ever where a run-length encoded scanline stops short, as
   it takes the missing bytes for zeros; so a file that has ended goes on as 0xff here, which no scanline survives. */
typedef struct source { FILE *file; int ended; } source;

static int source_read(void *user, char *data, int size) {
    source *s = (source *)user;
    size_t got = fread(data, 1, (size_t)size, s->file);
    if (got > 0) return (int)got;
    s->ended = 1;
    memset(data, 0xff, (size_t)size);
    return size;
}
static void source_skip(void *user, int count) { fseek(((source *)user)->file, count, SEEK_CUR); }
static int source_eof(void *user) { return ((source *)user)->ended; }

static long file_size(FILE *file) {
    long size;
    if (fseek(file, 0, SEEK_END)) return -1;
    size = ftell(file);
    rewind(file);
    return size;
}

/* The fewest bytes that can hold such an image: flat, or runs of 127. */
static double least_hdr_bytes(int width, int height) {
    if (width < 8 || width >= 32768) return 4.0 * width * height;
    return (double)height * (4 + 8 * ((width + 126) / 127));
}

static int load_hdr(FILE *file, const char *path, image *im, why *w) {
    const stbi_io_callbacks callbacks = { source_read, source_skip, source_eof };
    source s;
    int channels;
    s.file = file;
    s.ended = 0;
    if (!stbi_info_from_callbacks(&callbacks, &s, &im->width, &im->height, &channels))
        return why_set(w, "%s: cannot be read as a Radiance .hdr or a .pfm image", path);
    if (im->width < 1 || im->height < 1 || (double)im->width * im->height > MOST_PIXELS)
        return why_set(w, "%s: claims %d x %d pixels, which is not a sensible image", path, im->width, im->height);
    if ((double)file_size(file) < least_hdr_bytes(im->width, im->height))
        return why_set(w, "%s: is cut short: too small for %d x %d pixels", path, im->width, im->height);
    s.ended = 0;
    im->rgb = stbi_loadf_from_callbacks(&callbacks, &s, &im->width, &im->height, &channels, 3);
    if (s.ended) return why_set(w, "%s: is cut short or damaged", path);
    if (!im->rgb) return why_set(w, "%s: is damaged: %s", path, stbi_failure_reason());
    return 0;
}

/* A float of either byte order. */
static float pfm_value(const unsigned char *p, int little_endian) {
    uint32_t bits = 0;
    float value;
    int i;
    for (i = 0; i < 4; i++) bits |= (uint32_t)p[i] << (little_endian ? 8 * i : 24 - 8 * i);
    memcpy(&value, &bits, 4);
    return value;
}

/* "PF", width, height, scale (negative: little-endian), one white space, rows from the bottom. */
static int load_pfm(FILE *file, const char *path, image *im, why *w) {
    float scale;
    size_t count;
    int y, i;
    if (fscanf(file, "PF %d %d %f%*c", &im->width, &im->height, &scale) != 3)
        return why_set(w, "%s: is not a colour .pfm image", path);
    if (im->width < 1 || im->height < 1 || (double)im->width * im->height > MOST_PIXELS)
        return why_set(w, "%s: claims %d x %d pixels, which is not a sensible image", path, im->width, im->height);
    i = (int)ftell(file);
    if ((double)file_size(file) - i < 12.0 * im->width * im->height)
        return why_set(w, "%s: is cut short: too small for %d x %d pixels", path, im->width, im->height);
    fseek(file, i, SEEK_SET);
    count = 3 * (size_t)im->width;
    im->rgb = (float *)malloc(count * (size_t)im->height * sizeof(float));
    if (!im->rgb) return why_set(w, "%s: out of memory", path);
    for (y = im->height - 1; y >= 0; y--) {
        float *row = im->rgb + count * (size_t)y;
        if (fread(row, 4, count, file) != count) return why_set(w, "%s: is cut short", path);
        for (i = 0; i < 3 * im->width; i++) row[i] = pfm_value((unsigned char *)(row + i), scale < 0);
    }
    return 0;
}

static void mirror_rows(image *im) {
    int x, y, c;
    for (y = 0; y < im->height; y++) {
        float *row = im->rgb + 3 * (size_t)im->width * (size_t)y;
        for (x = 0; x < im->width / 2; x++) {
            float *a = row + 3 * x, *b = row + 3 * (im->width - 1 - x);
            for (c = 0; c < 3; c++) { float swap = a[c]; a[c] = b[c]; b[c] = swap; }
        }
    }
}

void image_clean(image *im) {
    size_t count = 3 * (size_t)im->width * (size_t)im->height, i;
    float largest = 0;
    for (i = 0; i < count; i++) if (isfinite(im->rgb[i]) && im->rgb[i] > largest) largest = im->rgb[i];
    im->not_a_number = im->infinite = im->negative = 0;
    for (i = 0; i < count; i++) {
        float *v = im->rgb + i;
        if (isnan(*v)) { *v = 0; im->not_a_number++; }
        else if (*v < 0) { *v = 0; im->negative++; }
        else if (isinf(*v)) { *v = largest > 0 ? largest : 1; im->infinite++; }
    }
    im->all_black = largest == 0 && im->infinite == 0;
}

int image_load_environment(const char *path, image *im, why *w) {
    FILE *file = fopen(path, "rb");
    char start[2] = { 0, 0 };
    int failed;
    memset(im, 0, sizeof *im);
    if (!file) return why_set(w, "%s: cannot be opened: %s", path, strerror(errno));
    if (fread(start, 1, 2, file) < 2) {
        failed = why_set(w, "%s: is empty or cannot be read", path);
    } else {
        rewind(file);
        failed = memcmp(start, "PF", 2) ? load_hdr(file, path, im, w) : load_pfm(file, path, im, w);
    }
    fclose(file);
    if (failed) {
        image_free(im);
        return -1;
    }
    mirror_rows(im);
    image_clean(im);
    return 0;
}

/* ---- writing ---- */

int canvas_create(int width, int height, canvas *c, why *w) {
    c->width = width;
    c->height = height;
    c->rgb = (unsigned char *)calloc((size_t)width * (size_t)height, 3);
    return c->rgb ? 0 : why_set(w, "out of memory for a picture of %d x %d pixels", width, height);
}

void canvas_free(canvas *c) {
    free(c->rgb);
    memset(c, 0, sizeof *c);
}

/* Hable's curve for Uncharted 2 (GDC 2010), scaled so that 11.2 becomes white. */
static double filmic(double x) {
    double y = (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3;
    return y < 0 ? 0 : y / 0.7254;
}

static unsigned char to_srgb(double linear) {
    double v = linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
    return (unsigned char)(v > 0 ? v < 1 ? 255 * v + 0.5 : 255 : 0);
}

int picture_create(int width, int height, picture *p, why *w) {
    p->width = width;
    p->height = height;
    p->rgba = (float *)calloc((size_t)width * (size_t)height, 4 * sizeof *p->rgba);
    return p->rgba ? 0 : why_set(w, "out of memory for a picture of %d x %d samples", width, height);
}

void picture_free(picture *p) {
    free(p->rgba);
    memset(p, 0, sizeof *p);
}

double picture_exposure(const picture *p) {
    size_t count = (size_t)p->width * (size_t)p->height, i;
    double sum = 0, covered = 0;
    for (i = 0; i < count; i++) {
        const float *s = p->rgba + 4 * i;
        double luminance = 0.2126 * (double)s[0] + 0.7152 * (double)s[1] + 0.0722 * (double)s[2];
        if (s[3] > 0 && luminance >= 0) { sum += luminance; covered++; }
    }
    return sum > 0 ? 1.5 * covered / sum : 1;
}

static unsigned char shrink_sample(const picture *from, int x, int y, int channel, int per_pixel, double exposure) {
    double sum = 0;
    int i, j;
    for (j = 0; j < per_pixel; j++) {
        for (i = 0; i < per_pixel; i++) {
            size_t at = (size_t)(y * per_pixel + j) * (size_t)from->width + (size_t)(x * per_pixel + i);
            double radiance = (double)from->rgba[4 * at + (size_t)channel];
            sum += filmic(radiance > 0 ? exposure * radiance : 0);
        }
    }
    return to_srgb(sum / (per_pixel * per_pixel));
}

void canvas_put_picture(canvas *c, int x, int y, const picture *from, int per_pixel, double exposure) {
    int i, j, k;
    for (j = 0; j < from->height / per_pixel; j++) {
        for (i = 0; i < from->width / per_pixel; i++) {
            unsigned char *to = c->rgb + 3 * ((size_t)(y + j) * (size_t)c->width + (size_t)(x + i));
            if (x + i < 0 || x + i >= c->width || y + j < 0 || y + j >= c->height) continue;
            for (k = 0; k < 3; k++) to[k] = shrink_sample(from, i, j, k, per_pixel, exposure);
        }
    }
}

static void write_part(void *user, void *data, int size) {
    fwrite(data, 1, (size_t)size, ((replacement *)user)->file);      /* the commit looks at ferror */
}

int canvas_write_png(const canvas *c, const char *path, why *w) {
    replacement r;
    if (replacement_open(path, &r, w)) return -1;
    if (!stbi_write_png_to_func(write_part, &r, c->width, c->height, 3, c->rgb, 3 * c->width)) {
        replacement_abandon(&r);
        return why_set(w, "%s: out of memory", path);
    }
    return replacement_commit(&r, w);
}

int canvas_write_jpg(const canvas *c, const char *path, why *w) {
    replacement r;
    if (replacement_open(path, &r, w)) return -1;
    if (!stbi_write_jpg_to_func(write_part, &r, c->width, c->height, 3, c->rgb, 92)) {
        replacement_abandon(&r);
        return why_set(w, "%s: out of memory", path);
    }
    return replacement_commit(&r, w);
}
