/* Programs around one kernel, in each language, that run it over an array of inputs: item k reads kernel_inputs values from
   ins[k * kernel_inputs], its parameters one after the other, and writes kernel_outputs values. */
#ifndef PRT_SHADER_WRAPPER_H
#define PRT_SHADER_WRAPPER_H

#include <stdio.h>
#include "../../codegen/language.h"

int kernel_inputs(const kernel *k);
int kernel_outputs(const kernel *k);

/* language: c, glsl, hlsl, wgsl, metal; stage: compute (430) or fragment (330), of GLSL alone. C and Metal become a
   function `run(ins, outs)` for one item; Metal's text as C++ with the words of metal_shim/. */
void wrap_kernel(FILE *to, kernel *k, const char *language, const char *stage);

#endif
