/* Programs around one kernel, in each language, that run it over an array of inputs: item k reads kernel_inputs
   floats from ins[k * kernel_inputs], its parameters one after the other, and writes kernel_outputs floats. */
#ifndef PRT_SHADER_WRAPPER_H
#define PRT_SHADER_WRAPPER_H

#include <stdio.h>
#include "../../codegen/language.h"

int kernel_inputs(const kernel *k);
int kernel_outputs(const kernel *k);

/* How the program is run: GLSL, HLSL and WGSL as a compute shader, GLSL (330) also as a fragment shader; C and
   Metal, whose text is compiled as C++ with the words of metal_shim/, as a function `run_NUMBER(ins, outs)` for one
   item. */
typedef enum wrapping { WRAP_COMPUTE, WRAP_FRAGMENT, WRAP_FUNCTION } wrapping;

void wrap_kernel(FILE *to, kernel *k, const char *language, precision p, wrapping how, const char *version, int number);

/* A compute shader in GLSL 450 where all items read inputs shared_from ... shared_to - 1 from item 0 */
void wrap_shared(FILE *to, kernel *k, int shared_from, int shared_to);

/* What stands once at the head of a file of functions */
void wrap_preamble(FILE *to, const char *language, precision p);

#endif
