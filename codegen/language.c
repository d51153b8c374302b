#include "language.h"

#include <stdlib.h>
#include <string.h>

enum { EXPRESSION_MAX = 400, OPERAND_MAX = 90, INLINE_MAX = 60 };      /* longer operands become temporaries */

static void print_summary(FILE *to, const dialect *d, const kernel *k) {
    op_count c = kernel_operations(k);
    fprintf(to, "%s%s: %d multiplications, %d additions (%d can fuse)", d->comment_open, k->summary, c.multiplications,
            c.additions, c.fused);
    if (c.divisions) fprintf(to, ", %d divisions", c.divisions);
    if (c.roots) fprintf(to, ", %d square roots", c.roots);
    if (c.others) fprintf(to, ", %d others", c.others);
    if (c.loads) fprintf(to, ", %d loads", c.loads);
    fprintf(to, ", %d stores%s\n", c.stores, d->comment_close);
}

#define TERNARY "%s < %s ? %s : %s"

/* ---- the C of prt.h ---- */

static const char axis_name[4] = { 'x', 'y', 'z', 'w' };

/* Separates parameters, breaking lines at 100 columns */
static int next_parameter(FILE *to, int column, int first) {
    if (!first) column += fprintf(to, ", ");
    if (column > 92) { fprintf(to, "\n    "); column = 4; }
    return column;
}

/* cos and sin of angles (prt__turn_of) */
static int is_in_double(const param *p) { return !strcmp(p->name, "turn"); }

static const char *array_type(const param *p) { return is_in_double(p) ? "double" : "prt_real"; }

/* A kernel need not use every parameter: one band is constant. */
static void print_unused(FILE *to, const kernel *k, int components) {
    int i, j;
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        int used[3] = { 0, 0, 0 };
        if (p->kind == PARAM_OUTPUT || p->kind == PARAM_RESULT) continue;
        for (j = 0; j < k->node_count; j++)
            if (k->nodes[j].op == OP_INPUT && k->nodes[j].a == i && k->nodes[j].uses)
                used[p->kind == PARAM_DIRECTION && components ? k->nodes[j].b : 0] = 1;
        if (p->kind == PARAM_DIRECTION && components) {
            for (j = 0; j < 3; j++)
                if (!used[j]) fprintf(to, "    (void)%c;\n", axis_name[j]);
        } else if (!used[0]) fprintf(to, "    (void)%s;\n", p->name);
    }
}

/* head: storage class; tail: rest of the name; last: parameters after those of the kernel */
static void open_header_form(FILE *to, const kernel *k, const char *name, const char *head, const char *tail,
                             const char *scalar, const char *last) {
    int i, column = fprintf(to, "%s void %s%s(", head, name, tail);
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        column = next_parameter(to, column, i == 0);
        switch (p->kind) {
        case PARAM_SCALAR:    column += fprintf(to, "%s %s", scalar, p->name); break;
        case PARAM_DIRECTION: column += fprintf(to, "%s x, %s y, %s z", scalar, scalar, scalar); break;
        case PARAM_INPUT: case PARAM_FOUR: column += fprintf(to, "const %s *%s", array_type(p), p->name); break;
        case PARAM_OUTPUT: case PARAM_RESULT:
            column += fprintf(to, "prt_real *%s%s", k->stores_last ? "" : "PRT__RESTRICT ", p->name);
            break;
        }
    }
    if (*last) {
        next_parameter(to, column + (int)strlen(last) - 14, 0);
        fprintf(to, "%s", last);
    }
    fprintf(to, ") {\n");
    print_unused(to, k, 1);
}

static void open_header(FILE *to, const kernel *k, const char *name) {
    open_header_form(to, k, name, "PRT__STATIC", "", "prt_real", "");
}

static void load_c(char *text, size_t size, const param *p, int element) {
    if (p->kind == PARAM_DIRECTION) snprintf(text, size, "%c", axis_name[element]);
    else if (element < 0) snprintf(text, size, "%s", p->name);
    else snprintf(text, size, "%s[%d]", p->name, element);
}

static void store_c(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)is_constant;
    (void)number;
    fprintf(to, "    %s[%d] = %s;\n", p->name, element, value);
}

const dialect dialect_header = {
    "c", "/* ", " */", "const prt_real %s = ", "prt__min", "prt__max", "prt__sqrt", "prt__sin", "prt__cos", "prt__pow",
    TERNARY,
    21, "PRT__R(", ")", open_header, load_c, store_c, NULL, 0, NULL, ""
};

/* The same in double, whatever prt_real is */
static void load_header_double(char *text, size_t size, const param *p, int element) {
    char value[64];
    load_c(value, sizeof value, p, element);
    snprintf(text, size, is_in_double(p) ? "%s" : "(double)%s", value);
}

static void store_header_double(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)is_constant;
    (void)number;
    fprintf(to, "    %s[%d] = (prt_real)(%s);\n", p->name, element, value);
}

const dialect dialect_header_double = {
    "c", "/* ", " */", "const double %s = ", "fmin", "fmax", "sqrt", "sin", "cos", "pow", TERNARY, 21, "", "", open_header,
    load_header_double, store_header_double, NULL, 0, NULL, ""
};

/* What forms in SIMD have in common, up to what opens a function */
#define VECTOR_WORDS \
    "c", "/* ", " */", "const prt__vec %s = ", "prt__vec_min", "prt__vec_max", "prt__vec_sqrt", "prt__vec_sin", \
    "prt__vec_cos", "prt__vec_pow", TERNARY, 21, "PRT__R(", ")"

static void open_header_lanes(FILE *to, const kernel *k, const char *name) {
    int i;
    open_header_form(to, k, name, "PRT__STATIC", "_v", "prt__vec", "size_t stride");
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind != PARAM_SCALAR && k->params[i].kind != PARAM_DIRECTION && k->params[i].count > 1) return;
    fprintf(to, "    (void)stride;\n");
}

static void element_address(char *text, size_t size, const param *p, int element) {
    if (element == 0) snprintf(text, size, "%s", p->name);
    else if (element == 1) snprintf(text, size, "%s + stride", p->name);
    else snprintf(text, size, "%s + %d * stride", p->name, element);
}

static void load_header_lanes(char *text, size_t size, const param *p, int element) {
    char address[64];
    if (p->kind == PARAM_DIRECTION || element < 0) { load_c(text, size, p, element); return; }
    element_address(address, sizeof address, p, element);
    snprintf(text, size, "prt__vec_load(%s)", address);
}

static void print_store_lanes(FILE *to, const param *p, int element, const char *value, int is_constant) {
    char address[64];
    element_address(address, sizeof address, p, element);
    fprintf(to, is_constant ? "prt__vec_store(%s, prt__vec_set(%s));\n" : "prt__vec_store(%s, %s);\n", address, value);
}

static void store_header_lanes(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)number;
    fprintf(to, "    ");
    print_store_lanes(to, p, element, value, is_constant);
}

const dialect dialect_header_lanes = {
    VECTOR_WORDS, open_header_lanes, load_header_lanes, store_header_lanes, NULL, 0, NULL, ""
};

static void store_header_swept(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)number;
    fprintf(to, "        ");
    print_store_lanes(to, p, element, value, is_constant);
}

static const dialect dialect_header_swept = {
    VECTOR_WORDS, NULL, load_header_lanes, store_header_swept, NULL, 0, NULL, ""
};

static void open_header_rows(FILE *to, const kernel *k, const char *name, const char *tail, const char *coefficients) {
    int i, column = fprintf(to, "PRT__INLINE void %s%s(", name, tail);
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        column = next_parameter(to, column, i == 0);
        if (p->kind == PARAM_OUTPUT) column += fprintf(to, "prt__vec *PRT__RESTRICT %s", p->name);
        else if (!strcmp(p->name, "q")) column += fprintf(to, "const prt_real *q");
        else column += fprintf(to, "const %s *%s", !strcmp(p->name, "f") ? coefficients : "prt__vec", p->name);
    }
    fprintf(to, ") {\n");
}
static void open_header_nodes(FILE *to, const kernel *k, const char *name) {
    open_header_rows(to, k, name, "", "prt_real");
}
static void open_header_block(FILE *to, const kernel *k, const char *name) {
    open_header_rows(to, k, name, "_v", "prt__vec");
}

static void load_header_rows(char *text, size_t size, const param *p, int element) {
    if (strcmp(p->name, "q")) load_c(text, size, p, element);
    else if (element) snprintf(text, size, "prt__vec_load(q + %d * PRT__NODES)", element);
    else snprintf(text, size, "prt__vec_load(q)");
}

const dialect dialect_header_nodes = {
    VECTOR_WORDS, open_header_nodes, load_header_rows, store_c, NULL, 0, NULL, ""
};
const dialect dialect_header_block = {
    VECTOR_WORDS, open_header_block, load_header_rows, store_c, NULL, 0, NULL, ""
};

/* f and out are columns of structures of arrays; the rest are arrays of prt__vec. */
static void open_header_strided(FILE *to, const kernel *k, const char *name) {
    int i;
    fprintf(to, "PRT__INLINE void %s_v(", name);
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        if (!strcmp(p->name, "f")) fprintf(to, "const prt_real *f, ");
        else if (!strcmp(p->name, "out")) fprintf(to, "prt_real *out, ");
        else if (p->kind == PARAM_OUTPUT) fprintf(to, "prt__vec *PRT__RESTRICT %s, ", p->name);
        else fprintf(to, "const prt__vec *%s, ", p->name);
    }
    fprintf(to, "size_t stride) {\n");
}

static void load_header_strided(char *text, size_t size, const param *p, int element) {
    (strcmp(p->name, "f") ? load_c : load_header_lanes)(text, size, p, element);
}

static void store_header_strided(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (strcmp(p->name, "out") ? store_c : store_header_lanes)(to, p, element, value, is_constant, number);
}

const dialect dialect_header_strided = {
    VECTOR_WORDS, open_header_strided, load_header_strided, store_header_strided, NULL, 0, NULL, ""
};

/* ---- languages to embed in other programs: c, glsl, hlsl, wgsl, metal ---- */

/* Words that some language keeps for itself take another name in all of them. */
static const char *safe_name(const char *name) {
    static const char *const taken[][2] = {
        { "out", "result" }, { "in", "source" }, { "filter", "mask" }, { "sample", "sample_" }, { "half", "half_" },
        { "input", "source" }, { "output", "result" }, { "inout", "inout_" }, { "active", "active_" },
        { "matrix", "matrix_" }
    };
    size_t i;
    for (i = 0; i < sizeof taken / sizeof taken[0]; i++)
        if (!strcmp(name, taken[i][0])) return taken[i][1];
    return name;
}

/* What a signature is made of: printf formats of (name) or (name, count). */
typedef struct signature {
    const char *head_void, *head_real, *head_vec3;     /* up to the parenthesis, with the name */
    const char *tail_void, *tail_real, *tail_vec3;     /* from the parenthesis to the brace */
    const char *scalar, *direction, *four, *array, *out_array;
    int vectors;                                       /* a function can return three values as a vector */
} signature;

static void open_signature(FILE *to, const kernel *k, const char *name, const signature *s) {
    int i, column, returned = 0, printed = 0;
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind == PARAM_RESULT) returned = k->params[i].count;
    column = fprintf(to, returned == 0 ? s->head_void : returned == 1 ? s->head_real : s->head_vec3, name);
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        if (p->kind == PARAM_RESULT && (returned == 1 || s->vectors)) continue;
        column = next_parameter(to, column, !printed++);
        switch (p->kind) {
        case PARAM_SCALAR:    column += fprintf(to, s->scalar, safe_name(p->name)); break;
        case PARAM_DIRECTION: column += fprintf(to, s->direction, safe_name(p->name)); break;
        case PARAM_FOUR:      column += fprintf(to, s->four, safe_name(p->name)); break;
        case PARAM_INPUT:     column += fprintf(to, s->array, safe_name(p->name), p->count); break;
        case PARAM_OUTPUT: case PARAM_RESULT: column += fprintf(to, s->out_array, safe_name(p->name), p->count); break;
        }
    }
    fprintf(to, "%s", returned == 0 ? s->tail_void : returned == 1 ? s->tail_real : s->tail_vec3);
}

static void load_shader(char *text, size_t size, const param *p, int element) {
    if (p->kind == PARAM_DIRECTION || p->kind == PARAM_FOUR)
        snprintf(text, size, "%s.%c", safe_name(p->name), axis_name[element]);
    else if (element < 0) snprintf(text, size, "%s", safe_name(p->name));
    else snprintf(text, size, "%s[%d]", safe_name(p->name), element);
}

static void load_plain_c(char *text, size_t size, const param *p, int element) {
    if (element < 0) snprintf(text, size, "%s", safe_name(p->name));
    else snprintf(text, size, "%s[%d]", safe_name(p->name), element);
}

static void store_shader(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)is_constant;
    (void)number;
    fprintf(to, "    %s[%d] = %s;\n", safe_name(p->name), element, value);
}

static void store_wgsl(FILE *to, const param *p, int element, const char *value, int is_constant, int number) {
    (void)is_constant;
    (void)number;
    fprintf(to, "    (*%s)[%d] = %s;\n", safe_name(p->name), element, value);
}

#define WGSL_SELECT "select(%4$s, %3$s, %1$s < %2$s)"

/* One dialect of a shading language: what it prints before the functions, a conversion where functions are of float
   alone (glslang's for half in HLSL), a declaration, how constants end. */
#define DIALECT(id, language, preamble, round, signature_, declare_, select_, const_close_, store_, result3_) \
    static void open_##id(FILE *to, const kernel *k, const char *name) { open_signature(to, k, name, &signature_); } \
    static const dialect dialect_##id = { \
        language, "// ", "", declare_, round "min", round "max", round "sqrt", round "sin", round "cos", round "pow", \
        select_, 9, "", const_close_, \
        open_##id, load_shader, store_, NULL, 1, result3_, preamble };

/* C's functions of float serve _Float16 too: the conversion rounds what they return. */
#define C_DIALECT(id, real, preamble, round, const_close_) \
    static const signature signature_##id = { \
        "static void %s(", "static " real " %s(", "static void %s(", ") {\n", ") {\n", ") {\n", \
        real " %s", "const " real " %s[3]", "const " real " %s[4]", "const " real " %s[%d]", real " %s[%d]", 0 }; \
    static void open_##id(FILE *to, const kernel *k, const char *name) { \
        open_signature(to, k, name, &signature_##id); \
        print_unused(to, k, 0); \
    } \
    static const dialect dialect_##id = { \
        "c", "/* ", " */", "const " real " %s = ", round "fminf", round "fmaxf", round "sqrtf", round "sinf", \
        round "cosf", round "powf", TERNARY, 9, "", const_close_, open_##id, load_plain_c, store_shader, NULL, 1, \
        NULL, preamble };
C_DIALECT(c, "float", "#include <math.h>\n", "", "f")
C_DIALECT(c_float16, "_Float16", "#include <math.h>\n", "(_Float16)", "f16")

#define GLSL_SIGNATURE(real, vec3, vec4) { \
    "void %s(", real " %s(", vec3 " %s(", ") {\n", ") {\n", ") {\n", \
    real " %s", vec3 " %s", vec4 " %s", real " %s[%d]", "out " real " %s[%d]", 1 }
static const signature signature_glsl = GLSL_SIGNATURE("float", "vec3", "vec4");
static const signature signature_glsl_half = GLSL_SIGNATURE("mediump float", "mediump vec3", "mediump vec4");
static const signature signature_glsl_float16 = GLSL_SIGNATURE("float16_t", "f16vec3", "f16vec4");
DIALECT(glsl, "glsl", "", "", signature_glsl, "float %s = ", TERNARY, "", store_shader, "vec3(%s, %s, %s)")
DIALECT(glsl_half, "glsl", "", "", signature_glsl_half, "mediump float %s = ", TERNARY, "", store_shader,
        "vec3(%s, %s, %s)")
DIALECT(glsl_float16, "glsl", "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n", "",
        signature_glsl_float16, "float16_t %s = ", TERNARY, "hf", store_shader, "f16vec3(%s, %s, %s)")

static const signature signature_hlsl = GLSL_SIGNATURE("float", "float3", "float4");
static const signature signature_hlsl_half = GLSL_SIGNATURE("min16float", "min16float3", "min16float4");
static const signature signature_hlsl_float16 = GLSL_SIGNATURE("half", "half3", "half4");
DIALECT(hlsl, "hlsl", "", "", signature_hlsl, "float %s = ", TERNARY, "f", store_shader, "float3(%s, %s, %s)")
DIALECT(hlsl_half, "hlsl", "", "", signature_hlsl_half, "min16float %s = ", TERNARY, "f", store_shader,
        "min16float3(%s, %s, %s)")
DIALECT(hlsl_float16, "hlsl", "", "(half)", signature_hlsl_float16, "half %s = ", TERNARY, "h", store_shader,
        "half3(%s, %s, %s)")

#define METAL_SIGNATURE(real, vec3, vec4) { \
    "static inline void %s(", "static inline " real " %s(", "static inline " vec3 " %s(", ") {\n", ") {\n", ") {\n", \
    real " %s", vec3 " %s", vec4 " %s", "thread const " real " *%s", "thread " real " *%s", 1 }
#define METAL_PREAMBLE "#include <metal_stdlib>\nusing namespace metal;\n"
static const signature signature_metal = METAL_SIGNATURE("float", "float3", "float4");
static const signature signature_metal_half = METAL_SIGNATURE("half", "half3", "half4");
DIALECT(metal, "metal", METAL_PREAMBLE, "", signature_metal, "const float %s = ", TERNARY, "f", store_shader,
        "float3(%s, %s, %s)")
DIALECT(metal_half, "metal", METAL_PREAMBLE, "", signature_metal_half, "const half %s = ", TERNARY, "h", store_shader,
        "half3(%s, %s, %s)")

#define WGSL_SIGNATURE(real) { \
    "fn %s(", "fn %s(", "fn %s(", ") {\n", ") -> " real " {\n", ") -> vec3<" real "> {\n", \
    "%s: " real, "%s: vec3<" real ">", "%s: vec4<" real ">", "%s: array<" real ", %d>", \
    "%s: ptr<function, array<" real ", %d>>", 1 }
static const signature signature_wgsl = WGSL_SIGNATURE("f32");
static const signature signature_wgsl_half = WGSL_SIGNATURE("f16");
DIALECT(wgsl, "wgsl", "", "", signature_wgsl, "let %s: f32 = ", WGSL_SELECT, "", store_wgsl, "vec3<f32>(%s, %s, %s)")
DIALECT(wgsl_half, "wgsl", "enable f16;\n", "", signature_wgsl_half, "let %s: f16 = ", WGSL_SELECT, "h", store_wgsl,
        "vec3<f16>(%s, %s, %s)")

const dialect *find_dialect(const char *language, precision p) {
    static const dialect *const all[][PRECISIONS] = {
        { &dialect_c, &dialect_c_float16, &dialect_c_float16 },
        { &dialect_glsl, &dialect_glsl_half, &dialect_glsl_float16 },
        { &dialect_hlsl, &dialect_hlsl_half, &dialect_hlsl_float16 },
        { &dialect_wgsl, &dialect_wgsl_half, &dialect_wgsl_half },
        { &dialect_metal, &dialect_metal_half, &dialect_metal_half }
    };
    size_t i;
    for (i = 0; i < sizeof all / sizeof all[0]; i++)
        if (!strcmp(all[i][0]->name, language)) return all[i][p];
    return NULL;
}

/* ---- expressions and statements, common to all languages ---- */

typedef struct printer {
    FILE *to;
    const dialect *d;
    const kernel *k;
    const char *indent;
    int *temporary;                                    /* number of the temporary that holds a node, or 0 */
    int temporary_count;
} printer;

static void printer_open(printer *p, FILE *to, const dialect *d, const kernel *k, const char *indent) {
    p->to = to;
    p->d = d;
    p->k = k;
    p->indent = indent;
    p->temporary_count = 0;
    p->temporary = (int *)calloc((size_t)k->node_count, sizeof *p->temporary);
    if (!p->temporary) { fprintf(stderr, "prt_codegen: out of memory\n"); exit(1); }
}

/* Where an expression stands, and so which of its operators needs no parentheses. */
typedef enum place { IN_PRODUCT, IN_SUM, ARGUMENT, STATEMENT } place;

static void expression(printer *p, node n, char *text, place where);

static void constant_text(const printer *p, xreal value, char *text) {
    char digits[64];
    x_print(value, p->d->digits, digits);
    snprintf(text, OPERAND_MAX, "%s%s%s", p->d->const_open, digits, p->d->const_close);
}

static const char *function_name(const dialect *d, node_op op) {
    switch (op) {
    case OP_MIN: return d->min;
    case OP_MAX: return d->max;
    case OP_SQRT: return d->sqrt;
    case OP_SIN: return d->sin;
    case OP_COS: return d->cos;
    case OP_POW: return d->pow;
    default: return NULL;
    }
}

static void operation_text(printer *p, const node_data *n, char *text, place where) {
    static const char symbol[] = { [OP_ADD] = '+', [OP_SUB] = '-', [OP_MUL] = '*', [OP_DIV] = '/' };
    char t[4][OPERAND_MAX];
    const char *call = function_name(p->d, n->op);
    int sum = n->op == OP_ADD || n->op == OP_SUB, select = n->op == OP_SELECT;
    int bare = where == STATEMENT || where == ARGUMENT || (where == IN_SUM && !sum && n->op != OP_NEG && !select);
    place inner = call ? ARGUMENT : sum ? IN_SUM : IN_PRODUCT;
    node operand[4];
    int i;
    operand[0] = n->a; operand[1] = n->b; operand[2] = n->c; operand[3] = n->d;
    for (i = 0; i < op_operands(n->op); i++) expression(p, operand[i], t[i], inner);
    if (select) {
        char inside[EXPRESSION_MAX - 2];
        snprintf(inside, sizeof inside, p->d->select, t[0], t[1], t[2], t[3]);
        snprintf(text, EXPRESSION_MAX, bare ? "%s" : "(%s)", inside);
    }
    else if (call && op_operands(n->op) == 1) snprintf(text, EXPRESSION_MAX, "%s(%s)", call, t[0]);
    else if (call)            snprintf(text, EXPRESSION_MAX, "%s(%s, %s)", call, t[0], t[1]);
    else if (n->op == OP_NEG) snprintf(text, EXPRESSION_MAX, bare ? "-%s" : "(-%s)", t[0]);
    else snprintf(text, EXPRESSION_MAX, bare ? "%s %c %s" : "(%s %c %s)", t[0], symbol[n->op], t[1]);
}

static void keep_temporary(printer *p, node n, const char *text, char name[16]) {
    p->temporary[n] = ++p->temporary_count;
    snprintf(name, 16, "t%d", p->temporary[n]);
    fprintf(p->to, "%s", p->indent);
    fprintf(p->to, p->d->declare, name);
    fprintf(p->to, "%s;\n", text);
}

/* The text of node n; a node that is used again, or whose text grows long, is first stored in a temporary. Except for a
   statement, text holds OPERAND_MAX characters. */
static void expression(printer *p, node n, char *text, place where) {
    const node_data *d = &p->k->nodes[n];
    char whole[EXPRESSION_MAX], name[16];
    if (p->temporary[n]) { snprintf(text, OPERAND_MAX, "t%d", p->temporary[n]); return; }
    if (d->op == OP_CONST) { constant_text(p, d->value, text); return; }
    if (d->op == OP_INPUT) {
        const param *from = &p->k->params[d->a];
        p->d->load(whole, OPERAND_MAX, from, d->b);
        if (from->kind != PARAM_INPUT || d->uses == 1) { strcpy(text, whole); return; }
    } else {
        operation_text(p, d, whole, d->uses == 1 ? where : STATEMENT);
        if (d->uses == 1 && (where == STATEMENT || strlen(whole) <= INLINE_MAX)) { strcpy(text, whole); return; }
        if (d->uses == 1) operation_text(p, d, whole, STATEMENT);
    }
    keep_temporary(p, n, whole, name);
    strcpy(text, name);
}

static void print_value(printer *p, node n) {
    char text[EXPRESSION_MAX], name[16];
    expression(p, n, text, STATEMENT);
    if (!p->temporary[n] && p->k->nodes[n].op != OP_CONST) keep_temporary(p, n, text, name);
}

/* What is staged into temporaries; if all stores come last every output too, so that none needs a load any more */
static void print_values(printer *p) {
    int i;
    for (i = 0; i < p->k->stage_count; i++)
        if (p->k->nodes[p->k->stages[i]].uses) print_value(p, p->k->stages[i]);
    for (i = 0; p->k->stores_last && i < p->k->output_count; i++) print_value(p, p->k->outputs[i].value);
}

void print_kernel(FILE *to, const dialect *d, kernel *k, const char *name) {
    printer p;
    char result[3][EXPRESSION_MAX];
    int i, returned = 0;
    kernel_count_uses(k);
    printer_open(&p, to, d, k, "    ");
    print_summary(to, d, k);
    d->open(to, k, name);
    print_values(&p);
    for (i = 0; i < k->output_count; i++) {
        const output *o = &k->outputs[i];
        const param *into = &k->params[o->param];
        char text[EXPRESSION_MAX];
        int returns = into->kind == PARAM_RESULT && d->returns && (into->count == 1 || d->result3);
        expression(&p, o->value, text, returns && into->count == 3 ? ARGUMENT : STATEMENT);
        if (returns) {
            strcpy(result[o->element], text);
            returned = into->count;
        } else d->store(to, into, o->element, text, k->nodes[o->value].op == OP_CONST, i);
    }
    if (returned == 1) fprintf(to, "    return %s;\n", result[0]);
    if (returned == 3) {
        fprintf(to, "    return ");
        fprintf(to, d->result3, result[0], result[1], result[2]);
        fprintf(to, ";\n");
    }
    fprintf(to, "}\n\n");
    if (d->close) d->close(to, k, name);
    free(p.temporary);
}

/* ---- the sweeps of prt.h over many directions ---- */

enum { SWEEP_ROWS = 8 };

/* The components of the direction that a sweep uses */
static void print_sweep_loads(FILE *to, const kernel *k) {
    int i, axis;
    for (axis = 0; axis < 3; axis++)
        for (i = 0; i < k->node_count; i++) {
            const node_data *n = &k->nodes[i];
            if (n->op != OP_INPUT || n->b != axis || !n->uses) continue;
            fprintf(to, "        const prt__vec %c = prt__vec_load(%cs + k);\n", axis_name[axis], axis_name[axis]);
            break;
        }
}

static void print_sweep(FILE *to, kernel *sweep) {
    char text[EXPRESSION_MAX];
    printer p;
    int i;
    kernel_count_uses(sweep);
    printer_open(&p, to, &dialect_header_swept, sweep, "        ");
    fprintf(to, "    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {\n");
    print_sweep_loads(to, sweep);
    fprintf(to, "        prt_real *PRT__RESTRICT out = rows + k;\n");
    for (i = 0; i < sweep->output_count; i++) {
        const output *o = &sweep->outputs[i];
        expression(&p, o->value, text, STATEMENT);
        store_header_swept(to, &sweep->params[o->param], o->element, text, sweep->nodes[o->value].op == OP_CONST, i);
    }
    fprintf(to, "    }\n");
    free(p.temporary);
}

/* Each sweep computes what its rows need, and some of it again. All but the last have equally many rows. */
void print_swept(FILE *to, kernel *k, const char *name) {
    int parts = (k->output_count + SWEEP_ROWS - 1) / SWEEP_ROWS, rows = (k->output_count + parts - 1) / parts, first;
    if (k->param_count != 2 || k->params[0].kind != PARAM_DIRECTION) {
        fprintf(stderr, "prt_codegen: %s: only functions of a direction are swept\n", name);
        exit(1);
    }
    kernel_count_uses(k);
    print_summary(to, &dialect_header_swept, k);
    fprintf(to, "PRT__STATIC void %s_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,\n"
                "    prt_real *PRT__RESTRICT rows, size_t stride) {\n    int k;\n", name);
    if (k->output_count == 1) fprintf(to, "    (void)xs;\n    (void)ys;\n    (void)zs;\n    (void)stride;\n");
    for (first = 0; first < k->output_count; first += rows) {
        kernel sweep = *k;
        sweep.outputs += first;
        sweep.output_count = first + rows < k->output_count ? rows : k->output_count - first;
        print_sweep(to, &sweep);
    }
    fprintf(to, "}\n\n");
}
