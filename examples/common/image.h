/* image: environment maps from Radiance .hdr and .pfm, tone mapping, PNG. */
#ifndef EXAMPLES_IMAGE_H
#define EXAMPLES_IMAGE_H

#include "why.h"

/* Linear radiance, rows from the top, three floats a pixel. An environment is laid out as prt_sh_project_equirect_rgb
   wants it: row 0 is +z, columns run from +x towards +y. Photographs run the other way round (their right-hand
   neighbour lies clockwise, seen from above), so loading mirrors the rows: seen from inside, writing stays readable. */
typedef struct image {
    int   width, height;
    float *rgb;
    int   not_a_number, infinite, negative;    /* values that image_clean replaced */
    int   all_black;
} image;

/* Reads an environment and cleans it. 0, or -1 with the reason in w. */
int  image_load_environment(const char *path, image *im, why *w);
void image_free(image *im);

/* NaN and negative values become 0, infinite ones the largest finite value (1 where there is none); counts each kind
   and notices blackness. */
void image_clean(image *im);

/* An 8-bit sRGB picture for the screen. */
typedef struct canvas { int width, height; unsigned char *rgb; } canvas;

int  canvas_create(int width, int height, canvas *c, why *w);
void canvas_free(canvas *c);
int  canvas_write_png(const canvas *c, const char *path, why *w);
int  canvas_write_jpg(const canvas *c, const char *path, why *w);    /* quality 92 */

/* A rendered picture in linear radiance, rows from the top: width x height samples, so many to a pixel as the caller
   wants. alpha is 1 where the sample shows a surface, 0 where it shows the background. */
typedef struct picture { int width, height; float *rgba; } picture;

int  picture_create(int width, int height, picture *p, why *w);
void picture_free(picture *p);

/* What brings the mean luminance of the surfaces to a middle grey; 1 where there is no light. */
double picture_exposure(const picture *p);

/* Puts a picture on the canvas, its top left corner at (x, y), per_pixel x per_pixel samples a pixel: times exposure,
   highlights rolled off by Hable's filmic curve, averaged, then sRGB. Negative radiance shows as black. */
void canvas_put_picture(canvas *c, int x, int y, const picture *from, int per_pixel, double exposure);

#endif
