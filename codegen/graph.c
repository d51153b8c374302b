#include "graph.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *grow(void *old, int *capacity, size_t size) {
    void *p;
    *capacity = *capacity ? *capacity * 2 : 64;
    p = realloc(old, (size_t)*capacity * size);
    if (!p) { fprintf(stderr, "prt_codegen: out of memory\n"); exit(1); }
    return p;
}

kernel *kernel_new(const char *name, const char *summary) {
    kernel *k = (kernel *)calloc(1, sizeof *k);
    if (!k) { fprintf(stderr, "prt_codegen: out of memory\n"); exit(1); }
    snprintf(k->name, sizeof k->name, "%s", name);
    snprintf(k->summary, sizeof k->summary, "%s", summary);
    return k;
}

void kernel_free(kernel *k) {
    free(k->nodes);
    free(k->buckets);
    free(k->outputs);
    free(k->stages);
    free(k);
}

int kernel_param(kernel *k, const char *name, param_kind kind, int count) {
    param *p = &k->params[k->param_count];
    p->name = name;
    p->kind = kind;
    p->count = count;
    return k->param_count++;
}

void kernel_output(kernel *k, int to, int element, node value) {
    output *o;
    if (k->output_count == k->output_capacity)
        k->outputs = (output *)grow(k->outputs, &k->output_capacity, sizeof *k->outputs);
    o = &k->outputs[k->output_count++];
    o->param = to;
    o->element = element;
    o->value = value;
}

void kernel_stage(kernel *k, node n) {
    if (k->stage_count == k->stage_capacity)
        k->stages = (node *)grow(k->stages, &k->stage_capacity, sizeof *k->stages);
    k->stages[k->stage_count++] = n;
}

/* ---- hash-consing ---- */

static unsigned hash_node(const node_data *n) {
    double rounded = (double)n->value;
    unsigned char bytes[sizeof rounded];
    unsigned h = 2166136261u ^ (unsigned)n->op;
    size_t i;
    memcpy(bytes, &rounded, sizeof rounded);
    h = (h * 16777619u) ^ (unsigned)n->a;
    h = (h * 16777619u) ^ (unsigned)n->b;
    h = (h * 16777619u) ^ (unsigned)n->c;
    h = (h * 16777619u) ^ (unsigned)n->d;
    for (i = 0; i < sizeof bytes; i++) h = (h * 16777619u) ^ bytes[i];
    return h;
}

static int same_node(const node_data *n, const node_data *o) {
    return n->op == o->op && n->a == o->a && n->b == o->b && n->c == o->c && n->d == o->d && n->value == o->value;
}

static void insert_bucket(kernel *k, int index) {
    unsigned slot = hash_node(&k->nodes[index]) % (unsigned)k->bucket_count;
    while (k->buckets[slot]) slot = (slot + 1) % (unsigned)k->bucket_count;
    k->buckets[slot] = index + 1;
}

static void rehash(kernel *k) {
    int i;
    free(k->buckets);
    k->bucket_count = k->node_capacity * 2 + 1;
    k->buckets = (int *)calloc((size_t)k->bucket_count, sizeof *k->buckets);
    if (!k->buckets) { fprintf(stderr, "prt_codegen: out of memory\n"); exit(1); }
    for (i = 0; i < k->node_count; i++) insert_bucket(k, i);
}

static node intern4(kernel *k, node_op op, node a, node b, node c, node d, xreal value) {
    node_data n;
    unsigned slot, slots;
    n.op = op; n.a = a; n.b = b; n.c = c; n.d = d; n.value = value; n.uses = 0;
    if (k->node_count == k->node_capacity) {
        k->nodes = (node_data *)grow(k->nodes, &k->node_capacity, sizeof *k->nodes);
        rehash(k);
    }
    slots = (unsigned)k->bucket_count;
    for (slot = hash_node(&n) % slots; k->buckets[slot]; slot = (slot + 1) % slots)
        if (same_node(&k->nodes[k->buckets[slot] - 1], &n)) return k->buckets[slot] - 1;
    k->nodes[k->node_count] = n;
    k->buckets[slot] = ++k->node_count;
    return k->node_count - 1;
}

static node intern(kernel *k, node_op op, node a, node b, xreal value) { return intern4(k, op, a, b, 0, 0, value); }

/* ---- building, with the folds that keep the value ---- */

static int is_const(const kernel *k, node a, double value) {
    return k->nodes[a].op == OP_CONST && k->nodes[a].value == (xreal)value;
}
static int both_const(const kernel *k, node a, node b) {
    return k->nodes[a].op == OP_CONST && k->nodes[b].op == OP_CONST;
}

node k_const(kernel *k, xreal value) { return intern(k, OP_CONST, 0, 0, value); }
node k_scalar(kernel *k, int from) { return intern(k, OP_INPUT, from, -1, 0); }
node k_element(kernel *k, int from, int element) { return intern(k, OP_INPUT, from, element, 0); }

node k_add(kernel *k, node a, node b) {
    if (both_const(k, a, b)) return k_const(k, k->nodes[a].value + k->nodes[b].value);
    if (is_const(k, a, 0)) return b;
    if (is_const(k, b, 0)) return a;
    if (k->nodes[a].op == OP_CONST) { node t = a; a = b; b = t; }
    if (k->nodes[b].op == OP_CONST && k->nodes[b].value < 0) return k_sub(k, a, k_const(k, -k->nodes[b].value));
    if (k->nodes[b].op == OP_NEG) return k_sub(k, a, k->nodes[b].a);
    if (k->nodes[a].op == OP_NEG) return k_sub(k, b, k->nodes[a].a);
    return a < b || k->nodes[b].op == OP_CONST ? intern(k, OP_ADD, a, b, 0) : intern(k, OP_ADD, b, a, 0);
}

node k_sub(kernel *k, node a, node b) {
    if (both_const(k, a, b)) return k_const(k, k->nodes[a].value - k->nodes[b].value);
    if (is_const(k, b, 0)) return a;
    if (is_const(k, a, 0)) return k_neg(k, b);
    if (a == b) return k_const(k, 0);
    if (k->nodes[b].op == OP_NEG) return k_add(k, a, k->nodes[b].a);
    return intern(k, OP_SUB, a, b, 0);
}

node k_mul(kernel *k, node a, node b) {
    if (both_const(k, a, b)) return k_const(k, k->nodes[a].value * k->nodes[b].value);
    if (k->nodes[b].op == OP_CONST) { node t = a; a = b; b = t; }
    if (is_const(k, a, 0)) return a;
    if (is_const(k, a, 1)) return b;
    if (is_const(k, a, -1)) return k_neg(k, b);
    if (k->nodes[b].op == OP_NEG) {
        if (k->nodes[a].op == OP_CONST) return k_mul(k, k_const(k, -k->nodes[a].value), k->nodes[b].a);
        return k_neg(k, k_mul(k, a, k->nodes[b].a));
    }
    if (k->nodes[a].op == OP_NEG) return k_neg(k, k_mul(k, k->nodes[a].a, b));
    if (k->nodes[a].op != OP_CONST && a > b) { node t = a; a = b; b = t; }
    return intern(k, OP_MUL, a, b, 0);
}

node k_div(kernel *k, node a, node b) {
    if (both_const(k, a, b)) return k_const(k, k->nodes[a].value / k->nodes[b].value);
    if (k->nodes[b].op == OP_CONST) return k_mul(k, k_const(k, 1 / k->nodes[b].value), a);
    return intern(k, OP_DIV, a, b, 0);
}

node k_neg(kernel *k, node a) {
    if (k->nodes[a].op == OP_CONST) return k_const(k, -k->nodes[a].value);
    if (k->nodes[a].op == OP_NEG) return k->nodes[a].a;
    if (k->nodes[a].op == OP_SUB) return k_sub(k, k->nodes[a].b, k->nodes[a].a);
    return intern(k, OP_NEG, a, 0, 0);
}

node k_sqrt(kernel *k, node a) { return intern(k, OP_SQRT, a, 0, 0); }
node k_min(kernel *k, node a, node b) { return a < b ? intern(k, OP_MIN, a, b, 0) : intern(k, OP_MIN, b, a, 0); }
node k_max(kernel *k, node a, node b) { return a < b ? intern(k, OP_MAX, a, b, 0) : intern(k, OP_MAX, b, a, 0); }
node k_sin(kernel *k, node a) { return intern(k, OP_SIN, a, 0, 0); }
node k_cos(kernel *k, node a) { return intern(k, OP_COS, a, 0, 0); }
node k_pow(kernel *k, node a, node b) { return intern(k, OP_POW, a, b, 0); }
node k_abs(kernel *k, node a) { return k_max(k, a, k_neg(k, a)); }
node k_select(kernel *k, node a, node b, node c, node d) { return c == d ? c : intern4(k, OP_SELECT, a, b, c, d, 0); }
node k_scale(kernel *k, xreal factor, node a) { return k_mul(k, k_const(k, factor), a); }
node k_madd(kernel *k, node a, node b, node c) { return k_add(k, k_mul(k, a, b), c); }

/* ---- counting ---- */

int op_operands(node_op op) {
    switch (op) {
    case OP_CONST: case OP_INPUT: return 0;
    case OP_NEG: case OP_SQRT: case OP_SIN: case OP_COS: return 1;
    case OP_SELECT: return 4;
    default: return 2;
    }
}

static void use(kernel *k, node n) {
    node operand[4];
    int i;
    operand[0] = k->nodes[n].a; operand[1] = k->nodes[n].b; operand[2] = k->nodes[n].c; operand[3] = k->nodes[n].d;
    if (k->nodes[n].uses++) return;
    for (i = 0; i < op_operands(k->nodes[n].op); i++) use(k, operand[i]);
}

void kernel_count_uses(kernel *k) {
    int i;
    for (i = 0; i < k->node_count; i++) k->nodes[i].uses = 0;
    for (i = 0; i < k->output_count; i++) use(k, k->outputs[i].value);
}

static int lone_product(const kernel *k, node n) { return k->nodes[n].op == OP_MUL && k->nodes[n].uses == 1; }

op_count kernel_operations(const kernel *k) {
    op_count c;
    int i;
    memset(&c, 0, sizeof c);
    c.stores = k->output_count;
    for (i = 0; i < k->node_count; i++) {
        const node_data *n = &k->nodes[i];
        if (!n->uses) continue;
        switch (n->op) {
        case OP_CONST: case OP_NEG: break;
        case OP_INPUT: c.loads += k->params[n->a].kind == PARAM_INPUT; break;
        case OP_ADD: case OP_SUB:
            c.additions++;
            c.fused += lone_product(k, n->a) || lone_product(k, n->b);
            break;
        case OP_MUL: c.multiplications++; break;
        case OP_DIV: c.divisions++; break;
        case OP_SQRT: c.roots++; break;
        case OP_MIN: case OP_MAX: case OP_POW: case OP_SELECT: case OP_SIN: case OP_COS: c.others++; break;
        }
    }
    return c;
}

/* ---- live values ---- */

/* Steps of time in which nodes are made, depth first from the outputs, as they are printed; 0: not yet */
typedef struct schedule { int *made, *last, time; } schedule;

static void visit(const kernel *k, node n, schedule *s) {
    const node_data *d = &k->nodes[n];
    node operand[4];
    int i;
    if (d->op == OP_CONST || s->made[n]) return;
    operand[0] = d->a; operand[1] = d->b; operand[2] = d->c; operand[3] = d->d;
    for (i = 0; i < op_operands(d->op); i++)           /* what is loaded is loaded where it is needed: last */
        if (k->nodes[operand[i]].op != OP_INPUT) visit(k, operand[i], s);
    for (i = 0; i < op_operands(d->op); i++) visit(k, operand[i], s);
    s->made[n] = ++s->time;
    for (i = 0; i < op_operands(d->op); i++) s->last[operand[i]] = s->time;
}

int kernel_live_values(const kernel *k) {
    int *ends = (int *)calloc((size_t)k->node_count + 2, sizeof *ends), live = 0, most = 0, i;
    schedule s;
    s.made = (int *)calloc((size_t)k->node_count, sizeof *s.made);
    s.last = (int *)calloc((size_t)k->node_count, sizeof *s.last);
    s.time = 0;
    if (!ends || !s.made || !s.last) { fprintf(stderr, "prt_codegen: out of memory\n"); exit(1); }
    for (i = 0; i < k->stage_count; i++)
        if (k->nodes[k->stages[i]].uses) visit(k, k->stages[i], &s);
    for (i = 0; i < k->output_count; i++) {
        node n = k->outputs[i].value;
        visit(k, n, &s);
        if (s.last[n] <= s.time) s.last[n] = s.time + 1;
    }
    for (i = 0; i < k->node_count; i++)
        if (s.made[i]) ends[s.last[i]]++;              /* its register is free for the value made in that step */
    for (i = 1; i <= s.time; i++) {
        int peak = live + 1 - (ends[i] > 0);
        live += 1 - ends[i];
        if (peak > most) most = peak;
    }
    free(ends); free(s.made); free(s.last);
    return most;
}
