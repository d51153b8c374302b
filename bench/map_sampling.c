/* map_sampling.c - should a texel of an environment map count with Y at its centre, or with the mean of Y over it?
   Averages each map given (Radiance .hdr, latitude-longitude, sides divisible by 4) over 4 x 4 texels, projects the
   small map in both ways, and prints, band by band, how far each ends from the coefficients of the map itself.
   The mean is taken by splitting every texel into 32 x 32. The table in docs/math.md is its output. */
#define PRT_DOUBLE
#define PRT_IMPLEMENTATION
#include "prt.h"
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_HDR
#include <stb/stb_image.h>
#include <stdio.h>
#include <stdlib.h>

enum { BANDS = 8, COUNT = BANDS * BANDS, SHRINK = 4, SPLIT = 32 };

typedef struct map { int width, height; float *rgb; } map;

static map new_map(int width, int height) {
    map m = { width, height, malloc((size_t)width * (size_t)height * 3 * sizeof(float)) };
    if (!m.rgb) { fprintf(stderr, "map_sampling: out of memory for %d x %d texels\n", width, height); exit(1); }
    return m;
}

static float *texel(const map *m, int i, int j) { return m->rgb + 3 * ((size_t)j * (size_t)m->width + (size_t)i); }

static map split(const map *in) {
    map out = new_map(in->width * SPLIT, in->height * SPLIT);
    for (int j = 0; j < out.height; j++)
        for (int i = 0; i < out.width; i++)
            memcpy(texel(&out, i, j), texel(in, i / SPLIT, j / SPLIT), 3 * sizeof(float));
    return out;
}

/* Means weighted by solid angle. */
static map shrink(const map *in) {
    map out = new_map(in->width / SHRINK, in->height / SHRINK);
    for (int j = 0; j < out.height; j++)
        for (int i = 0; i < out.width; i++)
            for (int c = 0; c < 3; c++) {
                double sum = 0, total = 0;
                for (int y = j * SHRINK; y < (j + 1) * SHRINK; y++)
                    for (int x = i * SHRINK; x < (i + 1) * SHRINK; x++) {
                        double weight = sin(PRT__PI * (y + 0.5) / in->height);
                        sum += weight * (double)texel(in, x, y)[c];
                        total += weight;
                    }
                texel(&out, i, j)[c] = (float)(sum / total);
            }
    return out;
}

static int project(const map *m, double *light) {
    return prt_sh_project_equirect_rgb(BANDS, m->width, m->height, m->rgb, light) == PRT_OK;
}

static void print_row(const char *name, const char *how, const double *got, const double *want) {
    printf("| %s | %s |", name, how);
    for (int l = 1; l < BANDS; l++) {
        double error = 0, norm = 0;
        for (int i = l * l; i < (l + 1) * (l + 1); i++)
            for (int c = 0; c < 3; c++) {
                double step = got[c * COUNT + i] - want[c * COUNT + i];
                error += step * step;
                norm += want[c * COUNT + i] * want[c * COUNT + i];
            }
        printf(" %.2g |", 100 * sqrt(error / norm));
    }
    printf("\n");
}

static int run(const char *path) {
    const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    double want[3 * COUNT], centre[3 * COUNT], mean[3 * COUNT];
    map whole, small, fine;
    int channels, ok;
    whole.rgb = stbi_loadf(path, &whole.width, &whole.height, &channels, 3);
    if (!whole.rgb) {
        fprintf(stderr, "map_sampling: cannot read %s: %s\n", path, stbi_failure_reason());
        return 0;
    }
    if (whole.width % SHRINK || whole.height % SHRINK || whole.width > 1024 || whole.height > 1024) {
        fprintf(stderr, "map_sampling: %s is %d x %d: give a map of at most 1024 x 1024 with sides divisible by %d\n",
                path, whole.width, whole.height, (int)SHRINK);
        free(whole.rgb);
        return 0;
    }
    small = shrink(&whole);
    fine = split(&small);
    ok = project(&whole, want) && project(&small, centre) && project(&fine, mean);
    if (ok) {
        print_row(name, "centre", centre, want);
        print_row(name, "mean", mean, want);
    } else fprintf(stderr, "map_sampling: %s holds values that are not finite\n", path);
    free(whole.rgb); free(small.rgb); free(fine.rgb);
    return ok;
}

int main(int count, char **paths) {
    int failed = 0;
    if (count < 2) { fprintf(stderr, "usage: map_sampling MAP.hdr ...\n"); return 1; }
    printf("| map | Y at | band 1 | 2 | 3 | 4 | 5 | 6 | 7 |\n|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < count; i++) failed |= !run(paths[i]);
    return failed;
}
