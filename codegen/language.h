/* Languages that kernels are printed in. A dialect says how the few things look that differ between languages; the
   order of statements and the expressions are the same in all of them. */
#ifndef PRT_CODEGEN_LANGUAGE_H
#define PRT_CODEGEN_LANGUAGE_H

#include <stdio.h>
#include "graph.h"

typedef struct dialect {
    const char *name;                                  /* as after --lang */
    const char *comment_open, *comment_close;
    const char *declare;                               /* a temporary, with %s where its name stands */
    const char *min, *max, *sqrt, *sin, *cos, *pow;    /* names of functions */
    /* a < b ? c : d, as printf's arguments a, b, c, d in this order */
    const char *select;
    int digits;                                        /* significant digits of a constant */
    const char *const_open, *const_close;              /* around a constant */
    void (*open)(FILE *to, const kernel *k, const char *name);       /* signature, up to the opening brace */
    void (*load)(char *text, size_t size, const param *p, int element);
    void (*store)(FILE *to, const param *p, int element, const char *value, int is_constant, int number);
    void (*close)(FILE *to, const kernel *k, const char *name);      /* after the closing brace; NULL: nothing */
    int returns;                                       /* results are returned, not stored through a parameter */
    const char *result3;                               /* a vector of three values; NULL: an array, stored */
    const char *preamble;                              /* lines before the first function */
} dialect;

/* The forms that stand in prt.h: scalars, one item a call; the same in double; prt__vec, PRT__LANES items a call; and
   prt__vec over arrays of items, the stores in sweeps of at most eight rows: more rows whose distance is a multiple of
   4096 bytes would evict each other from a first-level cache of 8 to 12 ways before their lines are full. Nodes and
   block, for kernel_nodes.c: arrays of prt__vec, but that of the factors q, which has PRT__NODES reals for each entry,
   and, for nodes, that of the coefficients f, which are the same in all lanes. Strided, for kernel_points.c: as block,
   but f and out are structures of arrays. */
extern const dialect dialect_header, dialect_header_double, dialect_header_lanes, dialect_header_nodes, dialect_header_block,
    dialect_header_strided;

/* half: at least 16 bits, mediump, min16float, f16, half, _Float16; float16: 16 bits exactly, GLSL's float16_t and
   HLSL's half */
typedef enum precision { PRECISION_FLOAT, PRECISION_HALF, PRECISION_FLOAT16, PRECISIONS } precision;

/* The dialect of a language, c, glsl, hlsl, wgsl or metal; NULL if there is none. */
const dialect *find_dialect(const char *language, precision p);

void print_kernel(FILE *to, const dialect *d, kernel *k, const char *name);
void print_swept(FILE *to, kernel *k, const char *name);

#endif
