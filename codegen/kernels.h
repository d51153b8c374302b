/* The families of kernels: one description each, in kernel_<room>.c. To add one: write its describe function, declare it
   here, and give it a line in families.c. */
#ifndef PRT_CODEGEN_KERNELS_H
#define PRT_CODEGEN_KERNELS_H

#include <stdio.h>
#include "graph.h"

/* Forms that prt.h needs of a family (see language.h), and the text in every language */
enum {
    FORM_ONE = 1, FORM_LANES = 2, FORM_SWEPT = 4, FORM_NODES = 16, FORM_BLOCK = 32,
    FORM_HEADER = FORM_ONE | FORM_LANES | FORM_SWEPT | FORM_NODES | FORM_BLOCK, FORM_TEXT = 8
};

typedef struct family {
    const char *name;                                  /* as after --emit, and as in prt.h */
    int min_bands, max_bands;
    unsigned forms;
    kernel *(*describe)(int bands);
} family;

extern const family families[];
extern const int family_count;

/* A basis p(l,m) {Re,Im}(x+iy)^m with p(m,m) as in SH and p(l,m) = a(l,m) z p(l-1,m) - c(l,m) p(l-2,m) above. */
typedef xreal factor(int l, int m);
typedef struct basis { const char *name, *title; factor *a, *c; } basis;
kernel *describe_eval(const basis *b, int bands);
void sh_values(kernel *k, int bands, node x, node y, node z, node *values);        /* values[bands^2] = Y(l,m)(x,y,z) */
kernel *named_kernel(const char *family, const char *what, int bands);             /* "family_bands": "what, bands bands" */
kernel *describe_at(const basis *b, int bands);

/* Polynomials within 3e-11 and 5e-9 of the function (approximate.c) */
node k_sine(kernel *k, node angle);                    /* |angle| <= pi/2 */
node k_arc_cosine(kernel *k, node cosine);             /* clamped to -1 ... 1 */

factor sh_factor_a, ch_factor_a, ch_factor_c;
kernel *describe_sh_eval(int bands);
kernel *describe_sh_at(int bands);
kernel *describe_ch_eval(int bands);
kernel *describe_ch_at(int bands);
kernel *describe_sh_delta(int bands);
kernel *describe_sh_cone(int bands);
kernel *describe_sh_sphere(int bands);
kernel *describe_sh_cosine_lobe(int bands);
kernel *describe_sh_hemisphere(int bands);
kernel *describe_sh_convolve(int bands);
kernel *describe_sh_irradiance(int bands);
kernel *describe_sh_window_hann(int bands);
kernel *describe_sh_window_lanczos(int bands);
kernel *describe_sh_window_positive(int bands);
kernel *describe_sh_dot(int bands);
kernel *describe_shade_diffuse(int bands);
kernel *describe_sh_rotate(int bands);

void print_swaps(FILE *to);                            /* tables and code of the swap of y and z, four lanes */
kernel *describe_sh_product(int bands);
kernel *describe_sh_square(int bands);
kernel *describe_sh_rows(int bands);
kernel *describe_sh_terms(int bands);
kernel *describe_row_product(int bands);

void print_grid_tables(FILE *to, int bands);           /* table_grid.c */
void print_node_tables(FILE *to, int bands);

#endif
