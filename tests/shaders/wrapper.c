#include "wrapper.h"

#include <stdlib.h>
#include <string.h>

static int is_output(const param *p) { return p->kind == PARAM_OUTPUT || p->kind == PARAM_RESULT; }

int kernel_inputs(const kernel *k) {
    int i, count = 0;
    for (i = 0; i < k->param_count; i++)
        if (!is_output(&k->params[i])) count += k->params[i].count ? k->params[i].count : 1;
    return count;
}

int kernel_outputs(const kernel *k) {
    int i, count = 0;
    for (i = 0; i < k->param_count; i++)
        if (is_output(&k->params[i])) count += k->params[i].count;
    return count;
}

/* How a language says the few things that a wrapper needs; %s and %d as in the calls below. REAL, VEC3 and VEC4 are
   macros for the types of the precision; WGSL has no macros. */
typedef struct words {
    const char *array;                                 /* declaration: name, count */
    const char *copy_in;                               /* loop: count, name, offset */
    const char *scalar, *vector, *four;                /* one, three, four inputs: offset(s) */
    const char *argument_out;                          /* passing an array to be written */
    const char *real, *vec3;                           /* declaration of a result */
    const char *put, *put_array;                       /* output[offset] = name; loop: count, offset, name */
} words;

static const words words_plain = {
    "    REAL %s[%d];\n", "    for (int i = 0; i < %d; i++) %s[i] = REAL(IN(%d + i));\n", "REAL(IN(%d))",
    "VEC3(IN(%d), IN(%d), IN(%d))", "VEC4(IN(%d), IN(%d), IN(%d), IN(%d))", "%s", "    REAL %s = ", "    VEC3 %s = ",
        "    OUT(%d, %s);\n",
    "    for (int i = 0; i < %d; i++) OUT(%d + i, %s[i]);\n"
};
static const words words_c = {
    "    REAL %s[%d];\n", "    for (int i = 0; i < %d; i++) %s[i] = (REAL)IN(%d + i);\n", "(REAL)IN(%d)",
    "(const REAL[3]){ (REAL)IN(%d), (REAL)IN(%d), (REAL)IN(%d) }",
    "(const REAL[4]){ (REAL)IN(%d), (REAL)IN(%d), (REAL)IN(%d), (REAL)IN(%d) }", "%s", "    REAL %s = ",
        "    REAL %s[3];\n", "    OUT(%d, %s);\n",
    "    for (int i = 0; i < %d; i++) OUT(%d + i, %s[i]);\n"
};
#define WGSL_WORDS(real) { \
    "    var %s: array<" real ", %d>;\n", \
    "    for (var i: u32 = 0u; i < %du; i++) { %s[i] = " real "(ins[base_in + %du + i]); }\n", \
        real "(ins[base_in + %du])", \
    "vec3<" real ">(vec3<f32>(ins[base_in + %du], ins[base_in + %du], ins[base_in + %du]))", \
    "vec4<" real ">(vec4<f32>(ins[base_in + %du], ins[base_in + %du], ins[base_in + %du], ins[base_in + %du]))", \
    "&%s", "    let %s = ", "    let %s = ", "    outs[base_out + %du] = f32(%s);\n", \
    "    for (var i: u32 = 0u; i < %du; i++) { outs[base_out + %du + i] = f32(%s[i]); }\n" }
static const words words_wgsl = WGSL_WORDS("f32"), words_wgsl_half = WGSL_WORDS("f16");

static const words *words_of(const char *language, precision p) {
    if (!strcmp(language, "wgsl")) return p == PRECISION_FLOAT ? &words_wgsl : &words_wgsl_half;
    return !strcmp(language, "c") ? &words_c : &words_plain;
}

/* The arguments of a call, and before it the arrays that they need. */
static void print_arguments(FILE *to, const kernel *k, const words *w, char arguments[2048]) {
    int i, in = 0, length = 0;
    arguments[0] = 0;
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        char name[16];
        snprintf(name, sizeof name, "a%d", i);
        if (p->kind == PARAM_RESULT) continue;
        if (p->kind == PARAM_INPUT || p->kind == PARAM_OUTPUT) fprintf(to, w->array, name, p->count);
        if (p->kind == PARAM_INPUT) fprintf(to, w->copy_in, p->count, name, in);
        length += sprintf(arguments + length, "%s", length ? ", " : "");
        switch (p->kind) {
        case PARAM_SCALAR:    length += sprintf(arguments + length, w->scalar, in); break;
        case PARAM_DIRECTION: length += sprintf(arguments + length, w->vector, in, in + 1, in + 2); break;
        case PARAM_FOUR:      length += sprintf(arguments + length, w->four, in, in + 1, in + 2, in + 3); break;
        case PARAM_INPUT:     length += sprintf(arguments + length, "%s", name); break;
        default:              length += sprintf(arguments + length, w->argument_out, name); break;
        }
        if (!is_output(p)) in += p->count ? p->count : 1;
    }
}

static void print_call(FILE *to, const kernel *k, const words *w, const char *function) {
    char arguments[2048], name[16];
    const param *result = NULL;
    int i, out = 0;
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind == PARAM_RESULT) result = &k->params[i];
    print_arguments(to, k, w, arguments);
    if (result) fprintf(to, result->count == 1 ? w->real : w->vec3, "r");
    else fprintf(to, "    ");
    if (result && result->count == 3 && w == &words_c)                             /* C returns it through an array */
        fprintf(to, "    %s(%s, r);\n", function, arguments);
    else fprintf(to, "%s(%s);\n", function, arguments);
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind == PARAM_OUTPUT) {
            snprintf(name, sizeof name, "a%d", i);
            fprintf(to, w->put_array, k->params[i].count, out, name);
            out += k->params[i].count;
        }
    for (i = 0; result && i < result->count && i < 3; i++) {
        static const char *const member[] = { "r.x", "r.y", "r.z" }, *const element[] = { "r[0]", "r[1]", "r[2]" };
        fprintf(to, w->put, out + i, result->count == 1 ? "r" : w == &words_c ? element[i] : member[i]);
    }
}

static void print_types(FILE *to, const char *language, precision p) {
    static const char *const types[][PRECISIONS][3] = {
        { { "float", "", "" }, { "_Float16", "", "" }, { "_Float16", "", "" } },
        { { "float", "vec3", "vec4" }, { "float", "vec3", "vec4" }, { "float16_t", "f16vec3", "f16vec4" } },
        { { "float", "float3", "float4" }, { "min16float", "min16float3", "min16float4" },
          { "half", "half3", "half4" } },
        { { "float", "float3", "float4" }, { "half", "half3", "half4" }, { "half", "half3", "half4" } }
    };
    int row = !strcmp(language, "c") ? 0 : !strcmp(language, "glsl") ? 1 : !strcmp(language, "hlsl") ? 2 : 3;
    const char *const *type = types[row][p];
    if (!strcmp(language, "wgsl")) return;
    fprintf(to, "#define REAL %s\n#define VEC3 %s\n#define VEC4 %s\n", type[0], type[1], type[2]);
}

void wrap_preamble(FILE *to, const char *language, precision p) {
    fputs(find_dialect(language, p)->preamble, to);
    print_types(to, language, p);
    fprintf(to, "#define IN(i) ins[i]\n#define OUT(i, v) outs[i] = (float)(v)\n");
}

static void wrap_function(FILE *to, kernel *k, const char *language, precision p, int number) {
    char name[32];
    snprintf(name, sizeof name, "prt_kernel_%d", number);
    print_kernel(to, find_dialect(language, p), k, name);
    fprintf(to, "%svoid run_%d(const float *ins, float *outs) {\n", !strcmp(language, "metal") ? "extern \"C\" " : "",
            number);
    if (kernel_inputs(k) == 0) fprintf(to, "    (void)ins;\n");
    print_call(to, k, words_of(language, p), name);
    fprintf(to, "}\n");
}

/* Sums of indices are left to right, item * N + 1 + i: with parentheses about 1 + i Mesa 22.3 takes that sum for the
   loop's own next i where the loop is too long to be unrolled, and fills the array one place too far.
   Inputs shared_from ... shared_to - 1 are those of item 0 for all. */
static void wrap_compute(FILE *to, kernel *k, const char *language, precision p, const char *version, int shared_from,
                         int shared_to) {
    int ins = kernel_inputs(k), outs = kernel_outputs(k);
    const dialect *d = find_dialect(language, p);
    if (!strcmp(language, "glsl")) fprintf(to, "#version %s\n", version);
    fputs(d->preamble, to);
    print_types(to, language, p);
    if (!strcmp(language, "glsl"))
        fprintf(to, "layout(local_size_x = 64) in;\n"
                    "layout(std430, binding = 0) readonly buffer source_ { float ins[]; };\n"
                    "layout(std430, binding = 1) writeonly buffer target_ { float outs[]; };\n");
    if (!strcmp(language, "hlsl"))
        fprintf(to, "StructuredBuffer<float> ins : register(t0);\nRWStructuredBuffer<float> outs : register(u1);\n");
    if (!strcmp(language, "wgsl"))
        fprintf(to, "@group(0) @binding(0) var<storage, read> ins: array<f32>;\n"
                    "@group(0) @binding(1) var<storage, read_write> outs: array<f32>;\n");
    else {
        if (shared_from < shared_to)
            fprintf(to, "#define IN(i) ins[(i >= %d && i < %d ? 0 : item * %d) + i]\n", shared_from, shared_to, ins);
        else fprintf(to, "#define IN(i) ins[item * %d + i]\n", ins);
        fprintf(to, "#define OUT(i, v) outs[item * %d + i] = float(v)\n", outs);
    }
    print_kernel(to, d, k, "prt_kernel");
    if (!strcmp(language, "glsl")) fprintf(to, "void main() {\n    int item = int(gl_GlobalInvocationID.x);\n");
    if (!strcmp(language, "hlsl"))
        fprintf(to, "[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {\n    int item = int(id.x);\n");
    if (!strcmp(language, "wgsl"))
        fprintf(to, "@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {\n"
                    "    let base_in = id.x * %du;\n    let base_out = id.x * %du;\n", ins, outs);
    print_call(to, k, words_of(language, p), "prt_kernel");
    fprintf(to, "}\n");
}

static void wrap_fragment(FILE *to, kernel *k, precision p, const char *version) {
    const dialect *d = find_dialect("glsl", p);
    fprintf(to, "#version %s\n%s", version, d->preamble);
    print_types(to, "glsl", p);
    fprintf(to, "uniform samplerBuffer source_;\nout vec4 color;\n#define IN(i) texelFetch(source_, item * %d + i).r\n"
                "#define OUT(i, v) if ((i) == int(gl_FragCoord.x)) color = vec4(v)\n", kernel_inputs(k));
    print_kernel(to, d, k, "prt_kernel");
    fprintf(to, "void main() {\n    int item = int(gl_FragCoord.y);\n");
    print_call(to, k, words_of("glsl", p), "prt_kernel");
    fprintf(to, "}\n");
}

void wrap_kernel(FILE *to, kernel *k, const char *language, precision p, wrapping how, const char *version,
                 int number) {
    switch (how) {
    case WRAP_FUNCTION: wrap_function(to, k, language, p, number); break;
    case WRAP_COMPUTE:  wrap_compute(to, k, language, p, version, 0, 0); break;
    case WRAP_FRAGMENT: wrap_fragment(to, k, p, version); break;
    }
}

void wrap_shared(FILE *to, kernel *k, int shared_from, int shared_to) {
    wrap_compute(to, k, "glsl", PRECISION_FLOAT, "450", shared_from, shared_to);
}
