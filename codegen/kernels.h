/* The families of kernels: one description each, in kernel_<room>.c. To add one: write its describe function, declare it
   here, and give it a line in the table of prt_codegen.c. */
#ifndef PRT_CODEGEN_KERNELS_H
#define PRT_CODEGEN_KERNELS_H

#include "graph.h"

enum { FORM_ONE = 1, FORM_LANES = 2, FORM_SWEPT = 4 }; /* forms that prt.h needs of a family: see language.h */

typedef struct family {
    const char *name;                                  /* as after --emit, and as in prt.h */
    int min_bands, max_bands;
    unsigned forms;
    kernel *(*describe)(int bands);
} family;

kernel *describe_sh_eval(int bands);
kernel *describe_sh_at(int bands);

#endif
