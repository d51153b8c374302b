/* bake_forms.h - prt_bake_transfer as compiled with different flags, for bake.c. */
#ifndef BAKE_FORMS_H
#define BAKE_FORMS_H

#include "prt_bake.h"

typedef prt_result bake_transfer_function(const prt_bake_desc *desc, int point_count, const prt_point *points,
                                          int first, int count, prt_real *transfer);
bake_transfer_function bake_transfer_portable, bake_transfer_native;

#endif
