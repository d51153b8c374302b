#include "language.h"

#include <stdlib.h>
#include <string.h>

enum { EXPRESSION_MAX = 400, INLINE_MAX = 60 };        /* longer expressions become temporaries */

/* ---- the C of prt.h ---- */

static void print_operations(FILE *to, const kernel *k) {
    op_count c = kernel_operations(k);
    fprintf(to, "%d multiplications, %d additions (%d can fuse)", c.multiplications, c.additions, c.fused);
    if (c.divisions) fprintf(to, ", %d divisions", c.divisions);
    if (c.roots) fprintf(to, ", %d square roots", c.roots);
    if (c.others) fprintf(to, ", %d minima or maxima", c.others);
    if (c.loads) fprintf(to, ", %d loads", c.loads);
    fprintf(to, ", %d stores", c.stores);
}

/* head: storage class; tail: rest of the name; last: parameters after those of the kernel */
static void open_c_form(FILE *to, const kernel *k, const char *prefix, const char *head, const char *tail, const char *scalar,
                        const char *last) {
    int i, column;
    fprintf(to, "/* %s: ", k->summary);
    print_operations(to, k);
    fprintf(to, " */\n");
    column = fprintf(to, "%s void %s%s%s(", head, prefix, k->name, tail);
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        if (i) fprintf(to, ", ");
        if (column > 88) { fprintf(to, "\n    "); column = 4; }
        switch (p->kind) {
        case PARAM_SCALAR: column += fprintf(to, "%s %s", scalar, p->name); break;
        case PARAM_INPUT:  column += fprintf(to, "const prt_real *%s", p->name); break;
        case PARAM_OUTPUT: column += fprintf(to, "prt_real *PRT__RESTRICT %s", p->name); break;
        }
    }
    fprintf(to, "%s%s) {\n", *last && column + strlen(last) > 116 ? ",\n    " : *last ? ", " : "", last);
    for (i = 0; i < k->param_count; i++) {             /* a kernel need not use every parameter: one band is constant */
        const param *p = &k->params[i];
        int used = 0, j;
        if (p->kind == PARAM_OUTPUT) continue;
        for (j = 0; j < k->node_count; j++)
            used |= k->nodes[j].op == OP_INPUT && k->nodes[j].a == i && k->nodes[j].uses;
        if (!used) fprintf(to, "    (void)%s;\n", p->name);
    }
}

static void open_c(FILE *to, const kernel *k, const char *prefix) {
    open_c_form(to, k, prefix, "PRT__STATIC", "", "prt_real", "");
}

static void load_c(char *text, size_t size, const param *p, int element) {
    if (element < 0) snprintf(text, size, "%s", p->name);
    else snprintf(text, size, "%s[%d]", p->name, element);
}

static void store_c(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)is_constant;
    (void)number;
    fprintf(to, "    %s[%d] = %s;\n", p->name, element, value);
}

const dialect dialect_c = {
    "c", "const prt_real ", "prt__min", "prt__max", "prt__sqrt", 21, "PRT__R(", ")", open_c, load_c, store_c, NULL
};

static void open_c_lanes(FILE *to, const kernel *k, const char *prefix) {
    int i;
    open_c_form(to, k, prefix, "PRT__STATIC", "_v", "prt__vec", "size_t stride");
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind != PARAM_SCALAR && k->params[i].count > 1) return;
    fprintf(to, "    (void)stride;\n");
}

static void element_address(char *text, size_t size, const param *p, int element) {
    if (element == 0) snprintf(text, size, "%s", p->name);
    else if (element == 1) snprintf(text, size, "%s + stride", p->name);
    else snprintf(text, size, "%s + %d * stride", p->name, element);
}

static void load_c_lanes(char *text, size_t size, const param *p, int element) {
    char address[64];
    if (element < 0) { snprintf(text, size, "%s", p->name); return; }
    element_address(address, sizeof address, p, element);
    snprintf(text, size, "prt__vec_load(%s)", address);
}

static void print_store_c_lanes(FILE *to, const param *p, int element, const char *value, int is_constant) {
    char address[64];
    element_address(address, sizeof address, p, element);
    fprintf(to, is_constant ? "prt__vec_store(%s, prt__vec_set(%s));\n" : "prt__vec_store(%s, %s);\n", address, value);
}

static void store_c_lanes(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)number;
    fprintf(to, "    ");
    print_store_c_lanes(to, p, element, value, is_constant);
}

const dialect dialect_c_lanes = {
    "c", "const prt__vec ", "prt__vec_min", "prt__vec_max", "prt__vec_sqrt", 21, "PRT__R(", ")",
    open_c_lanes, load_c_lanes, store_c_lanes, NULL
};

/* Swept: the kernel is inlined once a sweep with constant bounds on the number of the store, which leaves of it just what
   the stores of the sweep need. */
enum { SWEEP_ROWS = 8 };

static void open_c_swept(FILE *to, const kernel *k, const char *prefix) {
    open_c_form(to, k, prefix, "PRT__INLINE", "_part", "prt__vec", "size_t stride, int first, int last");
    if (k->output_count == 1) fprintf(to, "    (void)stride;\n");
}

static void store_c_swept(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    fprintf(to, "    if (first <= %d && %d < last)%s", number, number, strlen(value) > 52 ? "\n        " : " ");
    print_store_c_lanes(to, p, element, value, is_constant);
}

/* The sweeps over `vectors` vectors of items, scalar parameters as arrays; all sweeps but the last have equally many rows. */
static void close_c_swept(FILE *to, const kernel *k, const char *prefix) {
    int parts = (k->output_count + SWEEP_ROWS - 1) / SWEEP_ROWS, rows = (k->output_count + parts - 1) / parts, first, i;
    fprintf(to, "PRT__STATIC void %s%s_v(int vectors", prefix, k->name);
    for (i = 0; i < k->param_count; i++)
        fprintf(to, k->params[i].kind == PARAM_OUTPUT ? ",\n    prt_real *PRT__RESTRICT %s" : ", const prt_real *%s", k->params[i].name);
    fprintf(to, ", size_t stride) {\n    int k;\n");
    for (first = 0; first < k->output_count; first += rows) {
        fprintf(to, "    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES)\n        %s%s_part(", prefix, k->name);
        for (i = 0; i < k->param_count; i++)
            fprintf(to, k->params[i].kind == PARAM_SCALAR ? "prt__vec_load(%s + k), " : "%s + k, ", k->params[i].name);
        fprintf(to, "stride, %d, %d);\n", first, first + rows < k->output_count ? first + rows : k->output_count);
    }
    fprintf(to, "}\n\n");
}

const dialect dialect_c_swept = {
    "c", "const prt__vec ", "prt__vec_min", "prt__vec_max", "prt__vec_sqrt", 21, "PRT__R(", ")",
    open_c_swept, load_c_lanes, store_c_swept, close_c_swept
};

/* ---- expressions and statements, common to all languages ---- */

typedef struct printer {
    FILE *to;
    const dialect *d;
    const kernel *k;
    int *temporary;                                    /* number of the temporary that holds a node, or 0 */
    int temporary_count;
} printer;

/* Where an expression stands, and so which of its operators needs no parentheses. */
typedef enum place { IN_PRODUCT, IN_SUM, ALONE } place;

static void expression(printer *p, node n, char *text, place where);

static void constant_text(const printer *p, xreal value, char *text) {
    char digits[64];
    x_print(value, p->d->digits, digits);
    snprintf(text, EXPRESSION_MAX, "%s%s%s", p->d->const_open, digits, p->d->const_close);
}

static void operation_text(printer *p, const node_data *n, char *text, place where) {
    static const char symbol[] = { [OP_ADD] = '+', [OP_SUB] = '-', [OP_MUL] = '*', [OP_DIV] = '/' };
    char a[EXPRESSION_MAX], b[EXPRESSION_MAX] = "";
    const char *call = n->op == OP_MIN ? p->d->min : n->op == OP_MAX ? p->d->max : n->op == OP_SQRT ? p->d->sqrt : NULL;
    int sum = n->op == OP_ADD || n->op == OP_SUB;
    int bare = where == ALONE || (where == IN_SUM && !sum && n->op != OP_NEG);
    place inner = call ? ALONE : sum ? IN_SUM : IN_PRODUCT;
    expression(p, n->a, a, inner);
    if (n->op != OP_NEG && n->op != OP_SQRT) expression(p, n->b, b, inner);
    if (n->op == OP_SQRT)     snprintf(text, EXPRESSION_MAX, "%.40s(%.300s)", call, a);
    else if (call)            snprintf(text, EXPRESSION_MAX, "%.40s(%.150s, %.150s)", call, a, b);
    else if (n->op == OP_NEG) snprintf(text, EXPRESSION_MAX, bare ? "-%.300s" : "(-%.300s)", a);
    else snprintf(text, EXPRESSION_MAX, bare ? "%.150s %c %.150s" : "(%.150s %c %.150s)", a, symbol[n->op], b);
}

/* The text of node n; a node that is used again, or whose text grows long, is first stored in a temporary. */
static void expression(printer *p, node n, char *text, place where) {
    const node_data *d = &p->k->nodes[n];
    char whole[EXPRESSION_MAX];
    if (p->temporary[n]) { snprintf(text, EXPRESSION_MAX, "t%d", p->temporary[n]); return; }
    if (d->op == OP_CONST) { constant_text(p, d->value, text); return; }
    if (d->op == OP_INPUT) {
        p->d->load(whole, sizeof whole, &p->k->params[d->a], d->b);
        if (d->b < 0 || d->uses == 1) { strcpy(text, whole); return; }
    } else {
        operation_text(p, d, whole, d->uses == 1 ? where : ALONE);
        if (d->uses == 1 && (where == ALONE || strlen(whole) <= INLINE_MAX)) { strcpy(text, whole); return; }
        if (d->uses == 1) operation_text(p, d, whole, ALONE);
    }
    p->temporary[n] = ++p->temporary_count;
    fprintf(p->to, "    %st%d = %s;\n", p->d->declare, p->temporary[n], whole);
    snprintf(text, EXPRESSION_MAX, "t%d", p->temporary[n]);
}

void print_kernel(FILE *to, const dialect *d, kernel *k, const char *prefix) {
    printer p;
    int i;
    kernel_count_uses(k);
    p.to = to;
    p.d = d;
    p.k = k;
    p.temporary_count = 0;
    p.temporary = (int *)calloc((size_t)k->node_count, sizeof *p.temporary);
    if (!p.temporary) { fprintf(stderr, "prt_codegen: out of memory\n"); exit(1); }
    d->open(to, k, prefix);
    for (i = 0; i < k->output_count; i++) {
        const output *o = &k->outputs[i];
        char text[EXPRESSION_MAX];
        expression(&p, o->value, text, ALONE);
        d->store(to, &k->params[o->param], o->element, text, k->nodes[o->value].op == OP_CONST, i);
    }
    fprintf(to, "}\n\n");
    if (d->close) d->close(to, k, prefix);
    free(p.temporary);
}
