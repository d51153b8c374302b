/* A kernel: straight-line arithmetic as an expression graph. Equal expressions are one node (hash-consing), constants
   are folded, so a description may be written as the formula stands and shared subexpressions are found.

   A description declares the parameters in their order, builds nodes, and names the outputs in the order in which they
   should be computed and stored. Nothing here knows a language: language.c prints a kernel in each. */
#ifndef PRT_CODEGEN_GRAPH_H
#define PRT_CODEGEN_GRAPH_H

#include "xreal.h"

typedef int node;                                      /* index into kernel.nodes */

typedef enum node_op {
    OP_CONST, OP_INPUT, OP_ADD, OP_SUB, OP_MUL, OP_DIV, OP_NEG, OP_SQRT, OP_SIN, OP_COS, OP_MIN, OP_MAX, OP_POW,
    OP_SELECT                                          /* a < b ? c : d */
} node_op;

typedef struct node_data {
    node_op op;
    node a, b, c, d;                                   /* operands; for OP_INPUT: parameter, element (or -1) */
    xreal value;                                       /* OP_CONST */
    int uses;                                          /* by outputs and by nodes that an output needs */
} node_data;

/* A direction is three scalars x, y, z in prt.h, an array in C and one vector elsewhere; so are four values. A
   result is what a shader's function returns, one value or a vector of three; in C it is an output array. */
typedef enum param_kind {
    PARAM_SCALAR, PARAM_DIRECTION, PARAM_FOUR, PARAM_INPUT, PARAM_OUTPUT, PARAM_RESULT
} param_kind;

typedef struct param { const char *name; param_kind kind; int count; } param;   /* count: elements; 0 for a scalar */
typedef struct output { int param, element; node value; } output;

typedef struct kernel {
    char name[64];                                     /* without prefix: sh_eval_5 */
    char summary[160];                                 /* one line of comment */
    param params[20];
    int param_count;
    node_data *nodes;
    int node_count, node_capacity;
    int *buckets;                                      /* hash table of node indices + 1 */
    int bucket_count;
    int stores_last;                                   /* all loads come before all stores: an output may be an input */
    output *outputs;
    int output_count, output_capacity;
    node *stages;                                      /* to be computed in this order, before any output */
    int stage_count, stage_capacity;
} kernel;

/* Operations of a finished kernel. fused: additions whose operand is a product that nothing else uses; others: minima,
   maxima, selections, powers, sines and cosines. */
typedef struct op_count { int multiplications, additions, fused, divisions, roots, others, loads, stores; } op_count;

kernel  *kernel_new(const char *name, const char *summary);
void     kernel_free(kernel *k);
int      kernel_param(kernel *k, const char *name, param_kind kind, int count);   /* returns its index */
void     kernel_output(kernel *k, int to, int element, node value);
void     kernel_stage(kernel *k, node n);              /* keeps few values alive where the order of outputs would not */
void     kernel_count_uses(kernel *k);
int      op_operands(node_op op);                      /* how many of a, b, c, d it has; 0 for constants and inputs */
op_count kernel_operations(const kernel *k);           /* after kernel_count_uses */
int      kernel_live_values(const kernel *k);          /* likewise: registers, in the order of the text */

node k_const(kernel *k, xreal value);
node k_scalar(kernel *k, int from);                    /* the parameter of this index */
node k_element(kernel *k, int from, int element);
node k_add(kernel *k, node a, node b);
node k_sub(kernel *k, node a, node b);
node k_mul(kernel *k, node a, node b);
node k_div(kernel *k, node a, node b);
node k_neg(kernel *k, node a);
node k_sqrt(kernel *k, node a);
node k_min(kernel *k, node a, node b);
node k_max(kernel *k, node a, node b);
node k_sin(kernel *k, node a);
node k_cos(kernel *k, node a);
node k_pow(kernel *k, node a, node b);                 /* a >= 0 */
node k_abs(kernel *k, node a);
node k_select(kernel *k, node a, node b, node c, node d);                 /* a < b ? c : d */
node k_scale(kernel *k, xreal factor, node a);         /* factor * a */
node k_madd(kernel *k, node a, node b, node c);        /* a * b + c */

#endif
