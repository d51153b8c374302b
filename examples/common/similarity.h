/* similarity: structural similarity of two pictures as the eye sees them. */
#ifndef EXAMPLES_SIMILARITY_H
#define EXAMPLES_SIMILARITY_H

#include "image.h"

/* Mean SSIM [Wang 2004] of the luminance of two pictures of one size (per_pixel x per_pixel samples to a pixel), times
   exposure, clipped to [0,1] and sRGB-coded: Gaussian window of 11 x 11 pixels, standard deviation 1.5, K1 = .01,
   K2 = .03; over the pixels that b covers whole with alpha of at least `least`; windows end at the picture's edge.
   1: equal. NaN where no such pixel exists. */
double picture_similarity(const picture *a, const picture *b, int per_pixel, double exposure, float least);

#endif
