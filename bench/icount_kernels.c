/* icount_kernels.c - both headers in a file of their own: nothing of icount.c is compiled into what is counted. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
