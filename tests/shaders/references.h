/* What each kernel must agree with, in double, and inputs to try it on. */
#ifndef PRT_SHADER_REFERENCES_H
#define PRT_SHADER_REFERENCES_H

#include "../../codegen/graph.h"

/* call: in and out are the kernel's inputs and outputs, the parameters one after the other, at n bands.
   approximation: how far, over the largest output, the kernel's own formulas may be from those of prt.h; 0 unless it
   approximates a function. */
typedef struct reference {
    const char *name;
    void (*call)(int n, const double *in, double *out);
    double approximation;
} reference;

const reference *find_reference(const char *name);     /* NULL: there is none */

/* Fills the inputs of one item, by the names of the parameters; the first items are the special cases. */
void fill_inputs(const kernel *k, int item, double *in);

#endif
