/* The families of kernels: one description each, in kernel_<room>.c, and a line in families.h. */
#ifndef PRT_CODEGEN_KERNELS_H
#define PRT_CODEGEN_KERNELS_H

#include <stdio.h>
#include "families.h"
#include "graph.h"

/* Forms that prt.h needs of a family (see language.h), and the text in every language */
enum {
    FORM_ONE = 1, FORM_LANES = 2, FORM_SWEPT = 4, FORM_NODES = 16, FORM_BLOCK = 32, FORM_DOUBLE = 64, FORM_STRIDED = 128,
    FORM_HEADER = FORM_ONE | FORM_LANES | FORM_SWEPT | FORM_NODES | FORM_BLOCK | FORM_DOUBLE | FORM_STRIDED,
    FORM_TEXT = 8
};

typedef struct family {
    const char *name;                                  /* as after --emit, and as in prt.h */
    int min_bands, max_bands;                          /* both 0: bands have no meaning */
    unsigned forms;
    kernel *(*describe)(int bands);
} family;

#define FAMILY_DECLARATION(name, description, from, to, forms) kernel *describe_##description(int bands);
FAMILIES(FAMILY_DECLARATION)
#undef FAMILY_DECLARATION

extern const family families[];
extern const int family_count;

/* A basis p(l,m) {Re,Im}(x+iy)^m with p(m,m) as in SH and p(l,m) = a(l,m) z p(l-1,m) - c(l,m) p(l-2,m) above. */
typedef xreal factor(int l, int m);
typedef struct basis { const char *name, *title; factor *a, *c; } basis;
kernel *describe_eval(const basis *b, int bands);
void sh_values(kernel *k, int bands, node x, node y, node z, node *values);        /* values[bands^2] = Y(l,m)(x,y,z) */
/* "family_bands": "what, bands bands" */
kernel *named_kernel(const char *family, const char *what, int bands);
kernel *describe_at(const basis *b, int bands);

/* Polynomials within 3e-11 and 5e-9 of the function (approximate.c) */
node k_sine(kernel *k, node angle);                    /* |angle| <= pi/2 */
node k_arc_cosine(kernel *k, node cosine);             /* clamped to -1 ... 1 */
node k_arc_tangent(kernel *k, node y, node x);         /* of y/x in -pi ... pi, as atan2; 0 at 0, 0 */
node k_power(kernel *k, node base, node exponent);     /* base >= 0; 1 where the exponent is not above 0 */
node k_exponential_slope(kernel *k, node v);           /* (e^v - 1)/v, v <= 0 */

/* Vectors of three nodes (vec.c) */
typedef struct vec { node x, y, z; } vec;
vec  vec_param(kernel *k, const char *name);           /* a parameter of three values */
vec  vec_of(const node v[3]);
vec  vec_element(kernel *k, int from, int element);    /* three values of an array */
node vec_dot(kernel *k, vec a, vec b);
vec  vec_sub(kernel *k, vec a, vec b);
vec  vec_scale(kernel *k, node s, vec a);
vec  vec_times(kernel *k, vec a, vec b);               /* component by component */
vec  vec_add(kernel *k, vec a, vec b);
vec  vec_cross(kernel *k, vec a, vec b);
node vec_length(kernel *k, vec a);
vec  vec_direction(kernel *k, vec a, node *length);    /* unit, zero for the zero vector; length may be NULL */
void vec_result(kernel *k, vec value);                 /* what the function returns */
node real_param(kernel *k, const char *name);
void real_result(kernel *k, node value);

/* Parts of kernels, from nodes to nodes */
void rotate_by_matrix(kernel *k, int bands, const node r[9], node *f); /* f is replaced */
void product_nodes(kernel *k, int bands, const node *f, const node *g, node *out);
void point_product_nodes(kernel *k, const node *f, const node *g, node *out);              /* four bands, by points */
void circle_product_nodes(kernel *k, int bands, const node *f, const node *g, node *out);  /* the same by circles */
typedef void window(int bands, xreal *weight);         /* weights of bands 0 ... bands-1, width = bands */
window hann_weights, lanczos_weights, positive_weights;
void input_nodes(kernel *k, const char *name, int count, node *values);
void output_nodes(kernel *k, const char *name, int count, const node *values);

factor sh_factor_a, ch_factor_a, ch_factor_c;
void print_swaps(FILE *to);                            /* tables and code of the swap of y and z, four lanes */

int   grid_pairs(int bands);                         /* table_grid.c: node pairs in the grid of a product */
xreal node_factor(int bands, int pair, int l, int m);
void print_grid_tables(FILE *to, int bands);
void print_node_tables(FILE *to, int bands);
void print_window_tables(FILE *to, int widest);        /* kernel_project.c */

#endif
