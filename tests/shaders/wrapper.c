#include "wrapper.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int kernel_inputs(const kernel *k) {
    int i, count = 0;
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind != PARAM_OUTPUT && k->params[i].kind != PARAM_RESULT) count += k->params[i].count ? k->params[i].count : 1;
    return count;
}

int kernel_outputs(const kernel *k) {
    int i, count = 0;
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind == PARAM_OUTPUT || k->params[i].kind == PARAM_RESULT) count += k->params[i].count;
    return count;
}

/* How a language says the few things that a wrapper needs; %s and %d as in the calls below. */
typedef struct words {
    const char *array_in, *array_out;                  /* declarations: name, count */
    const char *copy_in;                               /* loop: count, name, offset */
    const char *scalar, *vector;                       /* an input, three inputs: offset(s) */
    const char *argument_in, *argument_out;            /* passing an array */
    const char *real, *vec3;                           /* declaration of a result */
    const char *put, *put_array;                       /* output[offset] = name; loop: count, offset, name */
} words;

static const words words_glsl = {
    "    float %s[%d];\n", "    float %s[%d];\n", "    for (int i = 0; i < %d; i++) %s[i] = IN(%d + i);\n", "IN(%d)",
    "vec3(IN(%d), IN(%d), IN(%d))", "%s", "%s", "    float %s = ", "    vec3 %s = ", "    OUT(%d, %s);\n",
    "    for (int i = 0; i < %d; i++) OUT(%d + i, %s[i]);\n"
};
static const words words_hlsl = {
    "    float %s[%d];\n", "    float %s[%d];\n", "    for (int i = 0; i < %d; i++) %s[i] = IN(%d + i);\n", "IN(%d)",
    "float3(IN(%d), IN(%d), IN(%d))", "%s", "%s", "    float %s = ", "    float3 %s = ", "    OUT(%d, %s);\n",
    "    for (int i = 0; i < %d; i++) OUT(%d + i, %s[i]);\n"
};
static const words words_wgsl = {
    "    var %s: array<f32, %d>;\n", "    var %s: array<f32, %d>;\n",
    "    for (var i: u32 = 0u; i < %du; i++) { %s[i] = ins[base_in + %du + i]; }\n", "ins[base_in + %du]",
    "vec3<f32>(ins[base_in + %du], ins[base_in + %du], ins[base_in + %du])", "%s", "&%s", "    let %s = ", "    let %s = ",
    "    outs[base_out + %du] = %s;\n", "    for (var i: u32 = 0u; i < %du; i++) { outs[base_out + %du + i] = %s[i]; }\n"
};
static const words words_c = {
    "    const float *%s; /* %d */\n", "    float %s[%d];\n", "    /* %d */ %s = ins + %d;\n", "ins[%d]",
    "ins + %d /* %d %d */", "%s", "%s", "    float %s = ", "    float %s[3]; ", "    outs[%d] = %s;\n",
    "    for (int i = 0; i < %d; i++) outs[%d + i] = %s[i];\n"
};
static const words words_metal = {
    "    const float *%s; /* %d */\n", "    float %s[%d];\n", "    /* %d */ %s = ins + %d;\n", "ins[%d]",
    "float3(ins[%d], ins[%d], ins[%d])", "%s", "%s", "    float %s = ", "    float3 %s = ", "    outs[%d] = %s;\n",
    "    for (int i = 0; i < %d; i++) outs[%d + i] = %s[i];\n"
};

static const words *words_of(const char *language) {
    if (!strcmp(language, "glsl")) return &words_glsl;
    if (!strcmp(language, "hlsl")) return &words_hlsl;
    if (!strcmp(language, "wgsl")) return &words_wgsl;
    return !strcmp(language, "metal") ? &words_metal : &words_c;
}

/* The arguments of a call, and before it the arrays that they need. */
static void print_arguments(FILE *to, const kernel *k, const words *w, char arguments[1024]) {
    int i, in = 0, length = 0;
    arguments[0] = 0;
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        char name[16];
        const char *comma = length ? ", " : "";
        snprintf(name, sizeof name, "a%d", i);
        switch (p->kind) {
        case PARAM_SCALAR:
            length += sprintf(arguments + length, "%s", comma);
            length += sprintf(arguments + length, w->scalar, in);
            in++;
            break;
        case PARAM_DIRECTION:
            length += sprintf(arguments + length, "%s", comma);
            length += sprintf(arguments + length, w->vector, in, in + 1, in + 2);
            in += 3;
            break;
        case PARAM_INPUT:
            fprintf(to, w->array_in, name, p->count);
            fprintf(to, w->copy_in, p->count, name, in);
            length += sprintf(arguments + length, "%s", comma);
            length += sprintf(arguments + length, w->argument_in, name);
            in += p->count;
            break;
        case PARAM_OUTPUT:
            fprintf(to, w->array_out, name, p->count);
            length += sprintf(arguments + length, "%s", comma);
            length += sprintf(arguments + length, w->argument_out, name);
            break;
        case PARAM_RESULT: break;
        }
    }
}

static void print_call(FILE *to, const kernel *k, const char *language, const char *function) {
    const words *w = words_of(language);
    char arguments[1024], name[16];
    const param *result = NULL;
    int i, out = 0;
    for (i = 0; i < k->param_count; i++)
        if (k->params[i].kind == PARAM_RESULT) result = &k->params[i];
    print_arguments(to, k, w, arguments);
    if (result && result->count == 3 && w == &words_c) {                           /* C returns it through an array */
        fprintf(to, "    float r[3];\n    %s(%s, r);\n", function, arguments);
    } else {
        if (result) fprintf(to, result->count == 1 ? w->real : w->vec3, "r");
        else fprintf(to, "    ");
        fprintf(to, "%s(%s);\n", function, arguments);
    }
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

void wrap_kernel(FILE *to, kernel *k, const char *language, const char *stage) {
    int ins = kernel_inputs(k), outs = kernel_outputs(k);
    const dialect *d = find_dialect(language, 0);
    if (!strcmp(language, "glsl") && !strcmp(stage, "compute"))
        fprintf(to, "#version 430\nlayout(local_size_x = 64) in;\nlayout(std430, binding = 0) readonly buffer source_ { float ins[]; };\n"
                    "layout(std430, binding = 1) writeonly buffer target_ { float outs[]; };\n"
                    "#define IN(i) ins[item * %d + (i)]\n#define OUT(i, v) outs[item * %d + (i)] = (v)\n", ins, outs);
    if (!strcmp(language, "glsl") && !strcmp(stage, "fragment"))
        fprintf(to, "#version 330\nuniform samplerBuffer source_;\nout vec4 color;\n"
                    "#define IN(i) texelFetch(source_, item * %d + (i)).r\n"
                    "#define OUT(i, v) if ((i) == int(gl_FragCoord.x)) color = vec4(v)\n", ins);
    if (!strcmp(language, "hlsl"))
        fprintf(to, "StructuredBuffer<float> ins : register(t0);\nRWStructuredBuffer<float> outs : register(u1);\n"
                    "#define IN(i) ins[item * %d + (i)]\n#define OUT(i, v) outs[item * %d + (i)] = (v)\n", ins, outs);
    if (!strcmp(language, "wgsl"))
        fprintf(to, "@group(0) @binding(0) var<storage, read> ins: array<f32>;\n"
                    "@group(0) @binding(1) var<storage, read_write> outs: array<f32>;\n");
    if (!strcmp(language, "metal")) fprintf(to, "#include <metal_stdlib>\nusing namespace metal;\n");
    if (!strcmp(language, "c")) fprintf(to, "#include <math.h>\n");
    print_kernel(to, d, k, "prt_kernel");
    if (!strcmp(language, "glsl"))
        fprintf(to, "void main() {\n    int item = int(%s);\n", !strcmp(stage, "compute") ? "gl_GlobalInvocationID.x" : "gl_FragCoord.y");
    if (!strcmp(language, "hlsl"))
        fprintf(to, "[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {\n    int item = int(id.x);\n");
    if (!strcmp(language, "wgsl"))
        fprintf(to, "@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {\n"
                    "    let base_in = id.x * %du;\n    let base_out = id.x * %du;\n", ins, outs);
    if (!strcmp(language, "c")) fprintf(to, "void run(const float *ins, float *outs) {\n");
    if (!strcmp(language, "metal")) fprintf(to, "extern \"C\" void run(const float *ins, float *outs) {\n");
    print_call(to, k, language, "prt_kernel");
    fprintf(to, "}\n");
}
