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
    int min_bands, max_bands;                          /* both 0: bands have no meaning */
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
node k_arc_tangent(kernel *k, node y, node x);         /* of y/x in -pi ... pi, as atan2; 0 at 0, 0 */
node k_power(kernel *k, node base, node exponent);     /* base >= 0; 1 where the exponent is not above 0 */

/* Vectors of three nodes (vec.c) */
typedef struct vec { node x, y, z; } vec;
vec  vec_param(kernel *k, const char *name);           /* a parameter of three values */
vec  vec_element(kernel *k, int from, int element);    /* three values of an array */
node vec_dot(kernel *k, vec a, vec b);
vec  vec_sub(kernel *k, vec a, vec b);
vec  vec_scale(kernel *k, node s, vec a);
vec  vec_times(kernel *k, vec a, vec b);               /* component by component */
vec  vec_add(kernel *k, vec a, vec b);
node vec_length(kernel *k, vec a);
vec  vec_direction(kernel *k, vec a, node *length);    /* unit, zero for the zero vector; length may be NULL */
void vec_result(kernel *k, vec value);                 /* what the function returns */
node real_param(kernel *k, const char *name);
void real_result(kernel *k, node value);

/* Parts of kernels, from nodes to nodes */
void rotation_turn(kernel *k, const node r[9], node turn[6]);          /* cos, sin of a, b, g: R = Rz(a) Ry(b) Rz(g) */
void rotate_nodes(kernel *k, int bands, const node *r, const node turn[6], node *f);      /* f is replaced */
void product_nodes(kernel *k, int bands, const node *f, const node *g, node *out);
void window_weights(int bands, int positive, xreal *weight);           /* Hann or positive, as wide as the bands */
void input_nodes(kernel *k, const char *name, int count, node *values);
void output_nodes(kernel *k, const char *name, int count, const node *values);

factor sh_factor_a, ch_factor_a, ch_factor_c;
typedef kernel *description(int bands);
description describe_sh_eval, describe_sh_at, describe_ch_eval, describe_ch_at;
description describe_sh_delta, describe_sh_cone, describe_sh_sphere, describe_sh_cosine_lobe, describe_sh_hemisphere;
description describe_sh_convolve, describe_sh_irradiance, describe_sh_zonal_to;
description describe_sh_window_hann, describe_sh_window_lanczos, describe_sh_window_positive;
description describe_sh_rotate, describe_sh_rotate_matrix, describe_sh_turn, describe_sh_rotate_z, describe_rotation_from_quaternion;
description describe_sh_product, describe_sh_square, describe_sh_product_zonal;
description describe_sh_mask_hann, describe_sh_mask_filter_positive;
description describe_ch_from_sh, describe_sh_from_ch, describe_ch_from_moments, describe_ch_to_moments, describe_ch_dot;
description describe_ch_rotate, describe_ch_product;
description describe_sh_dot, describe_shade_diffuse, describe_shade_diffuse_four;
description describe_fiv_irradiance, describe_fiv_place, describe_fiv_blend, describe_fiv_taken, describe_fiv_overlap, describe_fiv_self;
description describe_vo_direct, describe_vo_pass, describe_vo_pass_cap, describe_vo_sent;

void print_swaps(FILE *to);                            /* tables and code of the swap of y and z, four lanes */
description describe_sh_rows, describe_sh_terms, describe_row_product;

void print_grid_tables(FILE *to, int bands);           /* table_grid.c */
void print_node_tables(FILE *to, int bands);
void print_window_tables(FILE *to, int widest);        /* kernel_project.c */

#endif
