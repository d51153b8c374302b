/* Languages that kernels are printed in. A dialect says how the few things look that differ between languages; the
   order of statements and the expressions are the same in all of them. */
#ifndef PRT_CODEGEN_LANGUAGE_H
#define PRT_CODEGEN_LANGUAGE_H

#include <stdio.h>
#include "graph.h"

typedef struct dialect {
    const char *name;                                  /* as after --lang */
    const char *declare;                               /* a temporary: "const prt_real " */
    const char *min, *max, *sqrt;                      /* function names */
    int digits;                                        /* significant digits of a constant */
    const char *const_open, *const_close;              /* around a constant */
    void (*open)(FILE *to, const kernel *k, const char *prefix);     /* comment and signature, up to the opening brace */
    void (*load)(char *text, size_t size, const param *p, int element);
    void (*store)(FILE *to, const param *p, int element, const char *value, int is_constant, int number);
    void (*close)(FILE *to, const kernel *k, const char *prefix);    /* after the closing brace; NULL: nothing */
} dialect;

/* The forms that stand in prt.h: scalars, one item a call; prt__vec, PRT__LANES items a call; and prt__vec over arrays of
   items, the stores in sweeps of at most eight rows: more rows whose distance is a multiple of 4096 bytes would evict
   each other from a first-level cache of 8 to 12 ways before their lines are full. */
extern const dialect dialect_c, dialect_c_lanes, dialect_c_swept;

void print_kernel(FILE *to, const dialect *d, kernel *k, const char *prefix);

#endif
