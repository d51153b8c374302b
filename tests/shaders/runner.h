/* Runs one program over an array of inputs: item k reads ins floats from in[k * ins] and writes outs floats. Each
   returns 0, or -1 with the reason in w. */
#ifndef PRT_SHADER_RUNNER_H
#define PRT_SHADER_RUNNER_H

#include "why.h"

typedef struct work { int items, ins, outs; const float *in; float *out; } work;   /* items: a multiple of 64 */

/* OpenGL, with a context current: the text of a compute shader (buffers 0 and 1), or of a fragment shader that paints a
   pixel an output, column x being output x of the item in row y. */
int run_opengl_compute(const char *text, const work *job, why *w);
int run_opengl_fragment(const char *text, const work *job, why *w);

/* Vulkan: SPIR-V with the entry point main and buffers 0 and 1 of set 0, `runs` times. `processor`: whether a
   software device (Mesa's lavapipe) is wanted, or a GPU; where there is only the other kind, that is taken. seconds
   (may be NULL) receives the shortest run by the device's clock, 0 if it has none. */
int  vulkan_create(int processor, why *w);
void vulkan_destroy(void);
const char *vulkan_name(void);
int  vulkan_is_processor(void);
int  run_vulkan(const char *spirv_path, const work *job, int runs, double *seconds, why *w);

#endif
