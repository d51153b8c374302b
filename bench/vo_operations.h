/* vo_operations.h - what batched shading from opaque vector occluders has to compute, by the sine law with an integer
   gloss of 8: additions, multiplications and divisions in the vector code of prt.h, in float. Comparisons, masks and
   exponents are not counted. */
#ifndef BENCH_VO_OPERATIONS_H
#define BENCH_VO_OPERATIONS_H

enum {
    VO_POINT_ALONE = 40,               /* of a point: its mirrored eye, the sum */
    VO_LIGHT = 103,                    /* of a point and light: direction, Phong's terms, the product of the factors */
    VO_DD_OCCLUDER = 60,               /* of a point and occluder: directions at length 1, colours */
    VO_ALL_OCCLUDER = 155,             /* ... and mirror directions, with DS and SS */
    VO_DD_BOTH = 65,                   /* of all three: sin^2 11, its logarithm 15, into the sum 2; DD 37 */
    VO_ALL_BOTH = 97                   /* ... and DS 10, SS 10, their colours 12 */
};

static double vo_operations(double points, double occluders, double lights, double an_occluder, double both) {
    return points * (VO_POINT_ALONE + VO_LIGHT * lights) + points * occluders * (an_occluder + both * lights);
}

#endif
