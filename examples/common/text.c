#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <stb/stb_truetype.h>

static const char *const regular_fonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/System/Library/Fonts/Supplemental/Arial.ttf", NULL
};
static const char *const bold_fonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf",
    "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf", "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf",
    "/System/Library/Fonts/Supplemental/Arial Bold.ttf", NULL
};

static unsigned char *read_whole(const char *path) {
    FILE *file = fopen(path, "rb");
    unsigned char *bytes = NULL;
    long size;
    if (!file) return NULL;
    if (fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) > 0) {
        rewind(file);
        bytes = (unsigned char *)malloc((size_t)size);
        if (bytes && fread(bytes, 1, (size_t)size, file) != (size_t)size) {
            free(bytes);
            bytes = NULL;
        }
    }
    fclose(file);
    return bytes;
}

int text_font_load(int bold, text_font *font, why *w) {
    const char *const *path = bold ? bold_fonts : regular_fonts;
    for (; *path; path++) {
        font->file = read_whole(*path);
        font->info = font->file ? malloc(sizeof(stbtt_fontinfo)) : NULL;
        if (font->info && stbtt_InitFont((stbtt_fontinfo *)font->info, font->file, 0)) return 0;
        text_font_free(font);
    }
    return why_set(w, "no TrueType font found for the captions: install fonts-dejavu-core");
}

void text_font_free(text_font *font) {
    free(font->file);
    free(font->info);
    memset(font, 0, sizeof *font);
}

/* The next code point; a broken sequence counts as one odd character. */
static int next_code(const char **at) {
    const unsigned char *p = (const unsigned char *)*at;
    int more = *p >= 0xf0 ? 3 : *p >= 0xe0 ? 2 : *p >= 0xc0 ? 1 : 0, code = more ? *p & (0x3f >> more) : *p;
    for (p++; more > 0 && (*p & 0xc0) == 0x80; more--, p++) code = code << 6 | (*p & 0x3f);
    *at = (const char *)p;
    return code;
}

static double advance(const stbtt_fontinfo *info, double scale, int code, int next) {
    int width, left;
    stbtt_GetCodepointHMetrics(info, code, &width, &left);
    return scale * (width + (next ? stbtt_GetCodepointKernAdvance(info, code, next) : 0));
}

double text_width(const text_font *font, double size, const char *line) {
    const stbtt_fontinfo *info = (const stbtt_fontinfo *)font->info;
    double scale = (double)stbtt_ScaleForPixelHeight(info, (float)size), x = 0;
    int code = *line ? next_code(&line) : 0;
    while (code) {
        int next = *line ? next_code(&line) : 0;
        x += advance(info, scale, code, next);
        code = next;
    }
    return x;
}

static void blend(canvas *c, int x, int y, int width, int height, const unsigned char *alpha, int grey) {
    int i, j, k;
    for (j = 0; j < height; j++) {
        for (i = 0; i < width; i++) {
            unsigned char *to;
            if (x + i < 0 || x + i >= c->width || y + j < 0 || y + j >= c->height) continue;
            to = c->rgb + 3 * ((size_t)(y + j) * (size_t)c->width + (size_t)(x + i));
            for (k = 0; k < 3; k++)
                to[k] = (unsigned char)((to[k] * (255 - alpha[j * width + i]) + grey * alpha[j * width + i]) / 255);
        }
    }
}

void text_draw(canvas *c, const text_font *font, double size, double x, double y, int grey, const char *line) {
    const stbtt_fontinfo *info = (const stbtt_fontinfo *)font->info;
    float scale = stbtt_ScaleForPixelHeight(info, (float)size);
    int code = *line ? next_code(&line) : 0;
    while (code) {
        int next = *line ? next_code(&line) : 0, width, height, left, top;
        unsigned char *alpha = stbtt_GetCodepointBitmapSubpixel(info, scale, scale, (float)(x - floor(x)), 0, code,
                                                                &width, &height, &left, &top);
        if (alpha) blend(c, (int)floor(x) + left, (int)floor(y) + top, width, height, alpha, grey);
        stbtt_FreeBitmap(alpha, NULL);
        x += advance(info, (double)scale, code, next);
        code = next;
    }
}
