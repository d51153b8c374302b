/* Runs every kernel that prt_codegen can print, in every language, over thousands of inputs, poles and degenerate ones
   included, and compares:
     1. the description, evaluated in double, with the function of prt.h (double) that it stands for;
     2. what the language computed with the description, within the running error bound of float arithmetic.

     test_shaders LANGUAGE... [--naga MODULES] [--markdown FILE]

   LANGUAGE: c and metal (as C++ through a shim) by the system's compilers; glsl330 (fragment) and glsl430 (compute) by
   OSMesa; hlsl by way of glslangValidator, spirv-val and spirv-cross to GLSL; wgsl by way of naga, spirv-val and
   spirv-cross. One line of TAP a kernel. --markdown writes the outcomes at 4 bands as rows of a table. */
#define PRT_DOUBLE
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../../codegen/kernels.h"
#include "error_bound.h"
#include "gl.h"
#include "osmesa_context.h"
#include "wrapper.h"

enum { ITEMS = 2048, SPECIAL = 24 };
static char folder[64];                                /* of what external tools read and write */

/* ---- prt.h, one line a kernel: inputs and outputs as the kernel's parameters, one after the other ---- */

static prt_vec3 vec3_of(const double *v) { return prt__vec3(v[0], v[1], v[2]); }
#define REFERENCE(name, call) static void reference_##name(int n, const double *in, double *out) { (void)n; call; }
REFERENCE(sh_eval, prt_sh_eval(n, vec3_of(in), out))
REFERENCE(ch_eval, prt_ch_eval(n, vec3_of(in), out))
REFERENCE(sh_at, *out = prt_sh_at(n, in, vec3_of(in + n * n)))
REFERENCE(ch_at, *out = prt_ch_at(n, in, vec3_of(in + n * n)))
REFERENCE(sh_delta, prt_sh_delta(n, vec3_of(in), out))
REFERENCE(sh_cone, prt_sh_cone(n, vec3_of(in), fmin(in[3], PRT__PI), out))
REFERENCE(sh_sphere, prt_sh_sphere(n, vec3_of(in), in[3], out))
REFERENCE(sh_cosine_lobe, prt_sh_cosine_lobe(n, vec3_of(in), out))
REFERENCE(sh_hemisphere, prt_sh_hemisphere(n, vec3_of(in), in[3], in[4], out))
REFERENCE(sh_convolve, prt_sh_convolve(n, in, in + n * n, out))
REFERENCE(sh_irradiance, prt_sh_irradiance(n, in, out))
REFERENCE(sh_window_hann, prt_sh_window(n, PRT_WINDOW_HANN, n, in, out))
REFERENCE(sh_window_lanczos, prt_sh_window(n, PRT_WINDOW_LANCZOS, n, in, out))
REFERENCE(sh_window_positive, prt_sh_window(n, PRT_WINDOW_POSITIVE, n, in, out))
REFERENCE(sh_rotate, prt_sh_rotate(n, in, in + 9 + 6, out))
REFERENCE(sh_dot, *out = prt_sh_dot(n, in, in + n * n))
REFERENCE(sh_product, prt_sh_product(n, in, in + n * n, out))
REFERENCE(sh_square, prt_sh_square(n, in, out))
REFERENCE(shade_diffuse, prt_shade_diffuse(n, in, in + n * n, (prt_rgb *)(void *)out))

typedef struct reference { const char *name; void (*call)(int n, const double *in, double *out); } reference;
static const reference references[] = {
    { "sh_eval", reference_sh_eval }, { "sh_at", reference_sh_at }, { "ch_eval", reference_ch_eval },
    { "ch_at", reference_ch_at }, { "sh_delta", reference_sh_delta }, { "sh_cone", reference_sh_cone },
    { "sh_sphere", reference_sh_sphere }, { "sh_cosine_lobe", reference_sh_cosine_lobe },
    { "sh_hemisphere", reference_sh_hemisphere }, { "sh_convolve", reference_sh_convolve },
    { "sh_irradiance", reference_sh_irradiance }, { "sh_window_hann", reference_sh_window_hann },
    { "sh_window_lanczos", reference_sh_window_lanczos }, { "sh_window_positive", reference_sh_window_positive },
    { "sh_rotate", reference_sh_rotate }, { "sh_dot", reference_sh_dot }, { "shade_diffuse", reference_shade_diffuse },
    { "sh_dot", reference_sh_dot }, { "shade_diffuse", reference_shade_diffuse },
    { "sh_product", reference_sh_product }, { "sh_square", reference_sh_square },
};

static const reference *find_reference(const char *name) {
    size_t i;
    for (i = 0; i < sizeof references / sizeof references[0]; i++)
        if (!strcmp(references[i].name, name)) return &references[i];
    return NULL;
}

/* ---- inputs ---- */

static double uniform(void) {
    static uint64_t state = 88172645463325252u;
    state ^= state << 13; state ^= state >> 7; state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

/* The first SPECIAL items are the axes, places ever nearer to the poles, and for other vectors the zero vector. */
static void fill_direction(const char *name, int item, double *v) {
    double z = 2 * uniform() - 1, phi = 2 * PRT__PI * uniform(), s = sqrt(1 - z * z);
    v[0] = s * cos(phi); v[1] = s * sin(phi); v[2] = z;
    if (item < 6) { v[0] = v[1] = v[2] = 0; v[item % 3] = item < 3 ? 1 : -1; }
    else if (item < SPECIAL) {
        double tilt = pow(10, -(item - 5) * 0.5);
        v[0] = 0.6 * sin(tilt); v[1] = -0.8 * sin(tilt); v[2] = (item & 1 ? -1 : 1) * cos(tilt);
    }
    if (!strcmp(name, "to_centre")) {
        double scale = item == SPECIAL - 1 ? 0 : pow(10, 2 * uniform() - 1);
        v[0] *= scale; v[1] *= scale; v[2] *= scale;
    }
}

static double fill_scalar(const char *name, int item) {
    double u = uniform();
    if (!strcmp(name, "half_angle")) return item % 7 == 0 ? 0 : item % 7 == 1 ? PRT__PI : item % 7 == 2 ? PRT__PI / 2 : PRT__PI * u;
    if (!strcmp(name, "radius")) return item % 7 == 0 ? 0 : 2 * u;
    return 2 * u - 1;
}

/* A rotation, and after it its cosines and sines. */
static void fill_rotation(double *r) {
    double q[4], turn[8];
    int i;
    for (i = 0; i < 4; i++) q[i] = 2 * uniform() - 1;
    prt_rotation_from_quaternion(q, r);
    prt__euler(r, turn);
    memcpy(r + 9, turn, 6 * sizeof *turn);
}

static void fill_inputs(const kernel *k, int item, double *in) {
    int i, j;
    for (i = 0; i < k->param_count; i++) {
        const param *p = &k->params[i];
        if (p->kind == PARAM_DIRECTION) { fill_direction(p->name, item, in); in += 3; }
        else if (p->kind == PARAM_SCALAR) *in++ = fill_scalar(p->name, item);
        else if (!strcmp(p->name, "r")) { fill_rotation(in); in += 9; }
        else if (!strcmp(p->name, "turn")) in += 6;
        else if (p->kind == PARAM_INPUT)
            for (j = 0; j < p->count; j++) *in++ = 2 * uniform() - 1;
    }
}

/* ---- running: text in, outs[ITEMS][outputs] out; 0, or -1 with a message printed ---- */

static int complain(const char *what, const char *detail) {
    fprintf(stderr, "test_shaders: %s: %.600s\n", what, detail);
    return -1;
}

static int tool(const char *command) {
    return system(command) == 0 ? 0 : complain("this command failed", command);
}

static int write_kernel(kernel *k, const char *language, const char *stage, const char *path) {
    FILE *f = fopen(path, "w");
    if (!f) return complain("cannot write", path);
    wrap_kernel(f, k, language, stage);
    return fclose(f) ? complain("cannot write", path) : 0;
}

static char *read_text(const char *path) {
    FILE *f = fopen(path, "rb");
    long size;
    char *text;
    if (!f || fseek(f, 0, SEEK_END) || (size = ftell(f)) < 0) return NULL;
    rewind(f);
    text = (char *)calloc((size_t)size + 1, 1);
    if (text && fread(text, 1, (size_t)size, f) != (size_t)size) { free(text); text = NULL; }
    fclose(f);
    return text;
}

static int run_native(const char *command, const char *library, int ins, int outs, const float *in, float *out) {
    void *handle;
    void (*run)(const float *, float *);
    void *symbol;
    int k;
    if (tool(command)) return -1;
    handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (!handle) return complain("cannot load", dlerror());
    symbol = dlsym(handle, "run");
    memcpy(&run, &symbol, sizeof run);
    for (k = 0; k < ITEMS; k++) run(in + k * ins, out + k * outs);
    dlclose(handle);
    return 0;
}

static GLuint compile(GLenum stage, const char *text) {
    GLuint shader = gl.CreateShader(stage);
    GLint ok = 0;
    gl.ShaderSource(shader, 1, &text, NULL);
    gl.CompileShader(shader);
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        char log[600] = "";
        gl.GetShaderInfoLog(shader, sizeof log, NULL, log);
        complain("GLSL", log);
        return 0;
    }
    return shader;
}

static GLuint link_program(GLuint a, GLuint b) {
    GLuint program = gl.CreateProgram();
    GLint ok = 0;
    if (!a) return 0;
    gl.AttachShader(program, a);
    if (b) gl.AttachShader(program, b);
    gl.LinkProgram(program);
    gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    gl.DeleteShader(a);
    if (b) gl.DeleteShader(b);
    if (!ok) complain("GLSL", "does not link");
    return ok ? program : 0;
}

static GLuint buffer_of(const void *data, size_t bytes) {
    GLuint buffer;
    gl.CreateBuffers(1, &buffer);
    gl.NamedBufferData(buffer, (GLsizeiptr)(bytes ? bytes : 4), data, GL_STATIC_DRAW);
    return buffer;
}

static int run_compute(const char *text, int ins, int outs, const float *in, float *out) {
    GLuint program = link_program(compile(GL_COMPUTE_SHADER, text), 0), buffers[2];
    size_t size = (size_t)ITEMS * (size_t)outs * sizeof *out;
    if (!program) return -1;
    buffers[0] = buffer_of(in, (size_t)ITEMS * (size_t)ins * sizeof *in);
    buffers[1] = buffer_of(NULL, size);
    gl.UseProgram(program);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffers[0]);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers[1]);
    gl.DispatchCompute(ITEMS / 64, 1, 1);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl.GetNamedBufferSubData(buffers[1], 0, (GLsizeiptr)size, out);
    gl.DeleteBuffers(2, buffers);
    gl.DeleteProgram(program);
    return gl.GetError() == GL_NO_ERROR ? 0 : complain("OpenGL", "error in a compute shader");
}

/* A pixel an output: column x is output x of the item in row y. */
static int run_fragment(const char *text, int ins, int outs, const float *in, float *out) {
    static const char triangle[] =
        "#version 330\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }\n";
    GLuint program = link_program(compile(GL_FRAGMENT_SHADER, text), compile(GL_VERTEX_SHADER, triangle));
    GLuint buffer, texture, frame, target, array;
    if (!program) return -1;
    buffer = buffer_of(in, (size_t)ITEMS * (size_t)ins * sizeof *in);
    gl.CreateTextures(GL_TEXTURE_BUFFER, 1, &texture);
    gl.TextureBuffer(texture, GL_R32F, buffer);
    gl.CreateFramebuffers(1, &frame);
    gl.CreateRenderbuffers(1, &target);
    gl.NamedRenderbufferStorage(target, GL_RGBA32F, outs, ITEMS);
    gl.NamedFramebufferRenderbuffer(frame, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
    gl.CreateVertexArrays(1, &array);
    gl.BindVertexArray(array);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl.Viewport(0, 0, outs, ITEMS);
    gl.UseProgram(program);
    gl.BindTextureUnit(0, texture);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.ReadPixels(0, 0, outs, ITEMS, GL_RED, GL_FLOAT, out);
    gl.DeleteVertexArrays(1, &array);
    gl.DeleteRenderbuffers(1, &target);
    gl.DeleteFramebuffers(1, &frame);
    gl.DeleteTextures(1, &texture);
    gl.DeleteBuffers(1, &buffer);
    gl.DeleteProgram(program);
    return gl.GetError() == GL_NO_ERROR ? 0 : complain("OpenGL", "error in a fragment shader");
}

/* prepare is a command that turns k.in into k.glsl */
static int run_glsl_file(const char *prepare, const char *path, int fragment, int ins, int outs, const float *in, float *out) {
    char *text;
    int bad;
    if (prepare && tool(prepare)) return -1;
    text = read_text(path);
    if (!text) return complain("cannot read", path);
    bad = fragment ? run_fragment(text, ins, outs, in, out) : run_compute(text, ins, outs, in, out);
    free(text);
    return bad;
}

static const char *naga_modules = "node_modules";

static int run(const char *target, kernel *k, const float *in, float *out) {
    int ins = kernel_inputs(k), outs = kernel_outputs(k), fragment = !strcmp(target, "glsl330");
    char path[128], glsl[128], command[1200];
    const char *language = !strncmp(target, "glsl", 4) ? "glsl" : target;
    snprintf(path, sizeof path, "%s/k.%s", folder, !strcmp(target, "metal") ? "cpp" : target);
    snprintf(glsl, sizeof glsl, "%s/k.comp.glsl", folder);
    if (write_kernel(k, language, fragment ? "fragment" : "compute", path)) return -1;
    if (!strcmp(language, "glsl")) return run_glsl_file(NULL, path, fragment, ins, outs, in, out);
    if (!strcmp(target, "c")) {
        snprintf(command, sizeof command, "cc -std=c99 -O1 -ffp-contract=off -shared -fPIC -o %s/k.so %s -lm", folder, path);
    } else if (!strcmp(target, "metal")) {
        snprintf(command, sizeof command, "c++ -std=c++14 -O1 -ffp-contract=off -I%s/metal_shim -shared -fPIC -o %s/k.so %s",
                 PRT_SHADER_TESTS, folder, path);
    } else {
        if (!strcmp(target, "hlsl"))
            snprintf(command, sizeof command, "glslangValidator -D -V -S comp -e main -o %s/k.spv %s >%s/log || { cat %s/log; false; }",
                     folder, path, folder, folder);
        else
            snprintf(command, sizeof command, "node %s/wgsl_to_spirv.mjs %s %s %s/k.spv", PRT_SHADER_TESTS, naga_modules, path, folder);
        if (tool(command)) return -1;
        snprintf(command, sizeof command, "spirv-val %s/k.spv && spirv-cross --version 430 --no-es %s/k.spv --output %s", folder, folder, glsl);
        return run_glsl_file(command, glsl, 0, ins, outs, in, out);
    }
    snprintf(path, sizeof path, "%s/k.so", folder);
    return run_native(command, path, ins, outs, in, out);
}

/* ---- the proof ---- */

typedef struct outcome { double error, bound_share; } outcome;      /* largest error; largest error over its bound */

/* Description in double against prt.h in double; the largest difference over the largest output. */
static double description_error(const kernel *k, const reference *r, int bands) {
    double in[1024], out[256] = { 0 }, worst = 0, largest = 0;
    bounded got[256];
    int item, i;
    for (item = 0; item < 256; item++) {
        fill_inputs(k, item, in);
        bound_kernel(k, in, DBL_EPSILON / 2, DBL_EPSILON, 0, got);
        r->call(bands, in, out);
        for (i = 0; i < kernel_outputs(k); i++) {
            double difference = fabs(got[i].value - out[i]);
            if (!(difference <= worst)) worst = difference;
            if (fabs(out[i]) > largest) largest = fabs(out[i]);
        }
    }
    return largest > 0 ? worst / largest : worst;
}

static int prove(const char *target, kernel *k, outcome *o) {
    int ins = kernel_inputs(k), outs = kernel_outputs(k), item, i, bad;
    float *in = (float *)calloc((size_t)ITEMS * (size_t)ins + 1, sizeof *in), *out = (float *)calloc((size_t)ITEMS * (size_t)outs, sizeof *out);
    double values[1024];
    bounded want[256];
    if (!in || !out) { free(in); free(out); return complain("out of memory", target); }
    for (item = 0; item < ITEMS; item++) {
        fill_inputs(k, item, values);
        for (i = 0; i < ins; i++) in[item * ins + i] = (float)values[i];
    }
    bad = run(target, k, in, out);
    o->error = o->bound_share = 0;
    for (item = 0; item < ITEMS && !bad; item++) {
        for (i = 0; i < ins; i++) values[i] = (double)in[item * ins + i];
        /* Sine and cosine: 4 ulp in C; OpenGL and Vulkan ask for 2^-11, llvmpipe keeps 2^-21 */
        bound_kernel(k, values, FLT_EPSILON / 2, ldexp(1, -21), (double)FLT_MIN, want);
        for (i = 0; i < outs; i++) {
            double error = fabs((double)out[item * outs + i] - want[i].value), share = error / (want[i].error + 1e-37);
            if (!(error <= o->error)) o->error = error;
            if (!(share <= o->bound_share)) o->bound_share = share;
        }
    }
    free(in);
    free(out);
    return bad;
}

static FILE *open_page(const char *path) {
    FILE *page = fopen(path, "w");
    if (!page) { complain("cannot write", path); return NULL; }
    fprintf(page,
        "<!-- Written by test_shaders --markdown: do not edit. -->\n# Generated kernels in every language, against prt.h\n\n"
        "4 bands, %d inputs each, the axes, places from 1e-0.5 to 1e-9 rad off the poles, zero and full cones and vectors of\n"
        "length 0 among them. *Description*: largest difference, over the largest output, between the description evaluated in\n"
        "double and the function of prt.h in double. *Error*: largest difference between what the language computed in float and\n"
        "the description in double. *Of its bound*: largest share of the running error bound that the float operations allow;\n"
        "above 1 the test fails.\n\n"
        "How each was run: c by the C compiler; metal as C++ through a shim (no Metal compiler was at hand, so Metal's own rules\n"
        "were not checked); glsl330 in a fragment shader and glsl430 in a compute shader of Mesa's llvmpipe; hlsl by\n"
        "glslangValidator to SPIR-V, spirv-val, spirv-cross to GLSL, llvmpipe; wgsl by naga to SPIR-V, then likewise.\n\n"
        "Compiler: " __VERSION__ ". The largest errors are those of kernels with large outputs (a sphere covers up to 4 pi).\n\n"
        "| kernel | language | description | error | of its bound |\n|---|---|---|---|---|\n", ITEMS);
    return page;
}

int main(int argc, char **argv) {
    static const int bands_of[] = { 1, 2, 3, 4, 5, 8, 10 };
    FILE *table = NULL;
    osmesa_context context;
    why w;
    int passed = 0, failed = 0, i, f, have_gl = 0;
    size_t b;
    snprintf(folder, sizeof folder, "/tmp/prt-shaders-XXXXXX");
    if (!mkdtemp(folder)) { complain("cannot make a folder", folder); return 1; }
    for (i = 1; i + 1 < argc; i++) {
        if (!strcmp(argv[i], "--naga")) naga_modules = argv[i + 1];
        if (!strcmp(argv[i], "--markdown") && !(table = open_page(argv[i + 1]))) return 1;
    }
    for (i = 1; i < argc; i++) {
        int by_tools = !strcmp(argv[i], "hlsl") || !strcmp(argv[i], "wgsl");
        if (argv[i][0] == '-') { i++; continue; }
        if (strcmp(argv[i], "c") && strcmp(argv[i], "metal") && !have_gl) {
            if (osmesa_context_create(&context, &w)) { complain("OpenGL", w.line); return 1; }
            have_gl = 1;
        }
        for (f = 0; f < family_count; f++)
            for (b = 0; b < sizeof bands_of / sizeof bands_of[0]; b++) {
                int bands = bands_of[b], ok;
                const reference *r = find_reference(families[f].name);
                outcome o = { 0, 0 };
                double description;
                kernel *k;
                if (bands < families[f].min_bands || bands > families[f].max_bands) continue;
                if (by_tools && bands != 1 && bands != 4 && bands != 10) continue;         /* they are slow to start */
                if (!r) { complain("no line in `references` for the kernel", families[f].name); failed++; break; }
                k = families[f].describe(bands);
                kernel_count_uses(k);
                description = description_error(k, r, bands);
                ok = !prove(argv[i], k, &o) && o.bound_share <= 1 && description <= 2e-14 * bands;
                printf("%s %d - %s %s %d bands: description %.1e, error %.2e, %.2f of its bound\n", ok ? "ok" : "not ok",
                       passed + failed + 1, argv[i], families[f].name, bands, description, o.error, o.bound_share);
                if (table && bands == 4)
                    fprintf(table, "| %s | %s | %.1e | %.1e | %.2f |\n", families[f].name, argv[i], description, o.error, o.bound_share);
                passed += ok;
                failed += !ok;
                kernel_free(k);
            }
    }
    if (have_gl) osmesa_context_destroy(&context);
    if (table) fclose(table);
    {
        char command[128];
        snprintf(command, sizeof command, "rm -r %s", folder);
        if (tool(command)) failed++;
    }
    printf("1..%d\n", passed + failed);
    return failed != 0;
}
