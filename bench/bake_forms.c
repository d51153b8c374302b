/* bake_forms.c - compiled once for each set of flags; BAKE_FORM names the function. */
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "bake_forms.h"

prt_result BAKE_FORM(const prt_bake_desc *desc, int point_count, const prt_point *points, int first, int count,
                     prt_real *transfer) {
    return prt_bake_transfer(desc, point_count, points, first, count, transfer);
}
