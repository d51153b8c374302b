/* Values and error bounds of a kernel's outputs, by running error analysis over its graph: each operation carries
   the errors of its operands and rounds once, so a bound follows from the arithmetic of the language that ran the
   kernel. */
#ifndef PRT_ERROR_BOUND_H
#define PRT_ERROR_BOUND_H

#include <math.h>
#include <stdlib.h>
#include "../../codegen/graph.h"

typedef struct bounded { double value, error; } bounded;

static bounded bounded_operation(node_op op, bounded a, bounded b, bounded c, bounded d, double eps, double trig) {
    bounded r = { 0, 0 };
    switch (op) {
    case OP_ADD: r.value = a.value + b.value; r.error = a.error + b.error; break;
    case OP_SUB: r.value = a.value - b.value; r.error = a.error + b.error; break;
    case OP_MUL:
        r.value = a.value * b.value;
        r.error = fabs(a.value) * b.error + fabs(b.value) * a.error + a.error * b.error;
        break;
    case OP_DIV:                                       /* GPUs divide by a rounded reciprocal: 2.5 ulp in every API */
        r.value = a.value / b.value;
        r.error = fabs(b.value) > b.error ? (a.error + fabs(r.value) * b.error) / (fabs(b.value) - b.error) : INFINITY;
        r.error += 2.5 * eps * fabs(r.value);
        break;
    case OP_POW:                                       /* exp2(b log2(a)), 3 ulp and 3 + 2|..| ulp in every API */
        r.value = a.value > 0 ? pow(a.value, b.value) : b.value > 0 ? 0 : 1;
        if (a.value > a.error)
            r.error = r.value * (fabs(b.value) * (a.error / (a.value - a.error) + 6 * eps * (1 + fabs(log2(a.value)))) +
                                 fabs(log(a.value)) * b.error + eps * (6 + 4 * fabs(b.value * log2(a.value))));
        else if (b.value < 0) r.error = INFINITY;
        else r.error = fmax(pow(a.value + a.error, fmax(b.value - b.error, 0)), r.value);
        break;
    case OP_NEG: r = a; r.value = -a.value; break;
    case OP_SQRT:                                      /* 1/inversesqrt: 2 + 2.5 ulp; near 0 the root of the error */
        r.value = sqrt(a.value > 0 ? a.value : 0);
        r.error = fmin(sqrt(a.error), a.error / fmax(r.value, 1e-300)) + 4.5 * eps * r.value;
        break;
    case OP_SIN: r.value = sin(a.value); r.error = a.error + trig; break;
    case OP_COS: r.value = cos(a.value); r.error = a.error + trig; break;
    case OP_MIN: r.value = fmin(a.value, b.value); r.error = fmax(a.error, b.error); break;
    case OP_MAX: r.value = fmax(a.value, b.value); r.error = fmax(a.error, b.error); break;
    case OP_SELECT:                                    /* within the error either branch may have been taken */
        r = a.value < b.value ? c : d;
        if (fabs(a.value - b.value) <= a.error + b.error) {
            bounded other = a.value < b.value ? d : c;
            if (isfinite(other.value)) r.error = fmax(r.error, other.error) + fabs(other.value - r.value);
        }
        break;
    case OP_CONST: case OP_INPUT: break;
    }
    if (isnan(r.error)) r.error = INFINITY;            /* no error times an infinite one */
    if (op != OP_NEG && op != OP_MIN && op != OP_MAX && op != OP_SELECT && op != OP_POW) r.error += eps * fabs(r.value);
    return r;
}

/* What a language's numbers do: unit roundoff; error of a constant, the same unless the compiler truncates; absolute
   error of sine and cosine; the smallest number that is not flushed to zero (0: none is) */
typedef struct arithmetic { double eps, constant, trig, tiny; } arithmetic;

/* inputs: the parameters' values one after the other, exact. outputs: in the order of parameters and elements, as
   many as they have. */
static void bound_kernel(const kernel *k, const double *inputs, arithmetic with, bounded *outputs) {
    bounded *v = (bounded *)calloc((size_t)k->node_count, sizeof *v);
    int first[20], first_out[20], i, in = 0, out = 0;
    for (i = 0; i < k->param_count; i++) {
        int count = k->params[i].count ? k->params[i].count : 1;
        int is_output = k->params[i].kind == PARAM_OUTPUT || k->params[i].kind == PARAM_RESULT;
        first[i] = in;
        first_out[i] = out;
        if (is_output) out += count; else in += count;
    }
    for (i = 0; i < k->node_count; i++) {              /* operands stand before what uses them */
        const node_data *n = &k->nodes[i];
        if (n->op == OP_CONST) { v[i].value = (double)n->value; v[i].error = with.constant * fabs(v[i].value); }
        else if (n->op == OP_INPUT) { v[i].value = inputs[first[n->a] + (n->b < 0 ? 0 : n->b)]; v[i].error = 0; }
        else v[i] = bounded_operation(n->op, v[n->a], v[n->b], v[n->c], v[n->d], with.eps, with.trig);
        if (fabs(v[i].value) - v[i].error < with.tiny) v[i].error += fmin(fabs(v[i].value), with.tiny);
    }
    for (i = 0; i < k->output_count; i++)
        outputs[first_out[k->outputs[i].param] + k->outputs[i].element] = v[k->outputs[i].value];
    free(v);
}

#endif
