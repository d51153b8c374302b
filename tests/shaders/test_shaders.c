/* Runs every kernel that prt_codegen can print, in every language, over thousands of inputs, poles and degenerate ones
   included, and compares:
     1. the description, evaluated in double, with the function of prt.h (double) that it stands for;
     2. what the language computed with the description, within the running error bound of float arithmetic.

     test_shaders TARGET... [--naga MODULES] [--only KERNEL] [--bands A-B] [--markdown FILE] [--cost FILE]

   TARGET: a line of the table `targets`. One line of TAP a kernel and number of bands; a target that this machine cannot
   run is skipped, with the reason. --bands: which numbers of bands to run; each kernel at those that it has. By default
   every one where that is quick, a few elsewhere (see `targets`). --markdown writes the outcomes as tables, --cost how
   many instructions the kernels have. */
#include <dlfcn.h>
#include <float.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../../codegen/kernels.h"
#include "error_bound.h"
#include "gl.h"
#include "osmesa_context.h"
#include "program.h"
#include "references.h"
#include "runner.h"
#include "wrapper.h"

/* Inputs a kernel; fewer where a call has more than LONG numbers, and there for fragment shaders, which compute all of a
   call for each output */
enum { ITEMS = 2048, LONG_ITEMS = 512, LONG_FRAGMENT_ITEMS = 128, LONG = 128 };
static char folder[64];                                /* of what external tools read and write */

/* ---- targets ---- */

/* How a language comes to run. SPIR-V runs on a Vulkan device, or, where there is none, as the GLSL that spirv-cross makes
   of it; MSL is what spirv-cross makes of the SPIR-V of GLSL, run as the Metal text is. WEBGPU is headless Chromium's. */
typedef enum route { BY_C, BY_CXX, BY_FRAGMENT, BY_COMPUTE, BY_SPIRV, BY_MSL, BY_WEBGPU } route;

/* from, to: bands that are run by default */
typedef struct target {
    const char *name, *language, *version;
    precision precision;
    route route;
    int from, to;
} target;
static const target targets[] = {
    { "c", "c", "", PRECISION_FLOAT, BY_C, 1, 10 },
    { "metal", "metal", "", PRECISION_FLOAT, BY_CXX, 1, 10 },
    { "glsl330", "glsl", "330", PRECISION_FLOAT, BY_FRAGMENT, 3, 4 },
    { "glsl430", "glsl", "430", PRECISION_FLOAT, BY_COMPUTE, 3, 4 },
    { "glsl450", "glsl", "450", PRECISION_FLOAT, BY_SPIRV, 1, 10 },
    { "hlsl", "hlsl", "", PRECISION_FLOAT, BY_SPIRV, 3, 4 },
    { "wgsl", "wgsl", "", PRECISION_FLOAT, BY_SPIRV, 3, 4 },
    { "webgpu", "wgsl", "", PRECISION_FLOAT, BY_WEBGPU, 3, 4 },
    { "msl", "glsl", "450", PRECISION_FLOAT, BY_MSL, 3, 5 },
    { "c-half", "c", "", PRECISION_HALF, BY_C, 4, 4 },
    { "metal-half", "metal", "", PRECISION_HALF, BY_CXX, 4, 4 },
    { "glsl-mediump", "glsl", "430", PRECISION_HALF, BY_COMPUTE, 4, 4 },
    { "glsl-float16", "glsl", "450", PRECISION_FLOAT16, BY_SPIRV, 4, 4 },
    { "hlsl-min16float", "hlsl", "", PRECISION_HALF, BY_SPIRV, 4, 4 },
    { "hlsl-float16", "hlsl", "", PRECISION_FLOAT16, BY_SPIRV, 4, 4 },
    { "wgsl-f16", "wgsl", "", PRECISION_HALF, BY_SPIRV, 4, 4 },
};
enum { TARGETS = sizeof targets / sizeof targets[0] };

static const target *find_target(const char *name) {
    int i;
    for (i = 0; i < TARGETS; i++)
        if (!strcmp(targets[i].name, name)) return &targets[i];
    return NULL;
}

static const char *naga_modules;
static int have_opengl, have_vulkan;
static osmesa_context opengl;
static why reason;                                     /* of the last failure */

static int there(const char *program, const char *and) {
    char command[128];
    snprintf(command, sizeof command, "command -v %s >/dev/null && command -v %s >/dev/null", program, and);
    return system(command) == 0;
}

/* Why this machine cannot run the target; NULL: it can, and what it needs is started */
static const char *cannot_run(const target *t) {
    int opened = t->route == BY_FRAGMENT || t->route == BY_COMPUTE;
    if (t->route == BY_WEBGPU && !there("chromium", "node")) return "chromium or node is not there";
    if (t->route == BY_SPIRV && !strcmp(t->language, "wgsl") && !naga_modules) return "naga is not there";
    if ((t->route == BY_SPIRV || t->route == BY_MSL) &&
        (!there("spirv-val", "spirv-cross") || !(there("glslc", "true") || there("glslangValidator", "true"))))
        return "glslc (or glslangValidator), spirv-val or spirv-cross is not there";
    if (t->route == BY_C && t->precision != PRECISION_FLOAT &&
        system("echo '_Float16 x;' | cc -x c -fsyntax-only - 2>/dev/null")) return "the C compiler has no _Float16";
    if (t->route == BY_SPIRV) {
        if (!have_vulkan && vulkan_create(1, &reason) == 0) have_vulkan = 1;
        if (!have_vulkan && (t->precision == PRECISION_FLOAT16 || !strcmp(t->name, "wgsl-f16"))) return reason.line;
        if (!have_vulkan) opened = 1;
    }
    if (!opened || have_opengl) return NULL;
    if (osmesa_context_create(&opengl, &reason)) return reason.line;
    have_opengl = 1;
    return NULL;
}

/* ---- jobs: every kernel of a target, prepared together and run one by one ---- */

typedef struct job { const family *family; int bands; kernel *k; work work; } job;

static int write_source(const target *t, const job *j, int number) {
    char path[128];
    FILE *f;
    snprintf(path, sizeof path, "%s/%d.%s", folder, number,
             t->route < BY_SPIRV ? "text" : !strcmp(t->language, "glsl") ? "comp" : t->language);
    f = fopen(path, "w");
    if (!f) return why_set(&reason, "cannot write %s", path);
    wrap_kernel(f, j->k, t->language, t->precision, t->route == BY_FRAGMENT ? WRAP_FRAGMENT : WRAP_COMPUTE, t->version,
                number);
    return fclose(f) ? why_set(&reason, "cannot write %s", path) : 0;
}

static int write_library(const target *t, const job *jobs, int count) {
    char path[128];
    int i;
    FILE *f;
    snprintf(path, sizeof path, "%s/all.%s", folder, t->route == BY_C ? "c" : "cpp");
    f = fopen(path, "w");
    if (!f) return why_set(&reason, "cannot write %s", path);
    wrap_preamble(f, t->language, t->precision);
    for (i = 0; i < count; i++) wrap_kernel(f, jobs[i].k, t->language, t->precision, WRAP_FUNCTION, "", i);
    return fclose(f) ? why_set(&reason, "cannot write %s", path) : 0;
}

static int shell(const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 1, 2)))
#endif
    ;
static int shell(const char *format, ...) {
    char command[2000];
    va_list args;
    va_start(args, format);
    vsnprintf(command, sizeof command, format, args);
    va_end(args);
    return system(command) == 0 ? 0 : why_set(&reason, "this command failed: %.600s", command);
}

/* GLSL and HLSL to SPIR-V: by glslc, which takes all files at once, or by glslangValidator, both glslang's front end */
static int compile_spirv(const target *t) {
    int hlsl = !strcmp(t->language, "hlsl"), exact = t->precision == PRECISION_FLOAT16;
    const char *extension = hlsl ? "hlsl" : "comp";
    if (there("glslc", "true"))
        return shell("cd %s && glslc -c --target-env=vulkan1.0 %s%s*.%s && for f in *.comp.spv; do [ ! -e $f ] || "
                     "mv $f ${f%%%%.*}.spv; done", folder,
                     hlsl ? "-x hlsl -fshader-stage=comp -fentry-point=main " : "", hlsl && exact ? "-fhlsl-16bit-types " : "", extension);
    return shell("cd %s && ls *.%s | xargs -P2 -I@ sh -c 'glslangValidator %s%s-V -S comp -e main -o $(basename @ .%s).spv @ >@.log || "
                 "{ cat @.log; exit 255; }'", folder, extension, hlsl ? "-D " : "", hlsl && exact ? "--hlsl-enable-16bit-types " : "",
                 extension);
}

/* Sources to SPIR-V, N.spv, and through the validator */
static int prepare_spirv(const target *t) {
    int bad;
    if (strcmp(t->language, "wgsl")) bad = compile_spirv(t);
    else bad = shell("cd %s && node %s/wgsl_to_spirv.mjs %s *.wgsl", folder, PRT_SHADER_TESTS, naga_modules);
    if (bad) return bad;
    return shell("cd %s && ls *.spv | xargs -P2 -I@ sh -c 'spirv-val --target-env vulkan1.2 @ || { echo @; exit 255; }'", folder);
}

static int compile_cxx(void) {
    return shell("cd %s && c++ -std=c++14 -O0 -ffp-contract=off -fsingle-precision-constant -Wno-literal-suffix -Wno-attributes "
                 "-I%s/metal_shim -shared -fPIC -o all.so all.cpp", folder, PRT_SHADER_TESTS);
}

/* Everything in one library, a namespace a kernel; spirv-cross's array type has address spaces that C++ has not, so the
   shim brings its own. */
static int prepare_msl(int count) {
    return shell("cd %s && { echo '#include <metal_stdlib>\nusing namespace metal;'; i=0; while [ $i -lt %d ]; do "
                 "echo \"namespace k_$i {\"; spirv-cross --msl $i.spv | sed -n '/^struct [st][a-z]*_$/,$p'; "
                 "echo \"}\nextern \\\"C\\\" void run_$i(const float *ins, float *outs) {"
                 " k_$i::main0(*(const k_$i::source_ *)ins, *(k_$i::target_ *)outs, uint3(0, 0, 0)); }\"; i=$((i + 1)); done; } >all.cpp",
                 folder, count);
}

static int write_bytes(const char *path, const void *bytes, size_t size) {
    FILE *f = fopen(path, "wb");
    int bad = !f || fwrite(bytes, 1, size, f) != size;
    if (f && fclose(f)) bad = 1;
    return bad ? why_set(&reason, "cannot write %s", path) : 0;
}

static char webgpu_name[120];

static int prepare_webgpu(const job *jobs, int count) {
    char path[128];
    FILE *list;
    int i, bad = 0;
    snprintf(path, sizeof path, "%s/jobs", folder);
    list = fopen(path, "w");
    if (!list) return why_set(&reason, "cannot write %s", path);
    for (i = 0; i < count; i++) fprintf(list, "%zu %d\n", sizeof(float) * (size_t)(jobs[i].work.items * jobs[i].work.outs), jobs[i].work.items / 64);
    fclose(list);
    for (i = 0; i < count && !bad; i++) {
        snprintf(path, sizeof path, "%s/%d.in", folder, i);
        bad = write_bytes(path, jobs[i].work.in, sizeof(float) * (size_t)(jobs[i].work.items * jobs[i].work.ins));
    }
    if (bad || shell("node %s/webgpu.mjs chromium %s >%s/name", PRT_SHADER_TESTS, folder, folder)) return -1;
    snprintf(path, sizeof path, "%s/name", folder);
    list = fopen(path, "r");
    if (list && fgets(webgpu_name, sizeof webgpu_name, list)) webgpu_name[strcspn(webgpu_name, "\n")] = 0;
    return list && !fclose(list) ? 0 : why_set(&reason, "cannot read %s", path);
}

static int prepare(const target *t, const job *jobs, int count) {
    int i, bad = 0;
    if (t->route == BY_C || t->route == BY_CXX) {
        if (write_library(t, jobs, count)) return -1;
        if (t->route == BY_C)
            return shell("cd %s && cc -std=c99 -O1 -ffp-contract=off %s -shared -fPIC -o all.so all.c -lm", folder,
                         t->precision == PRECISION_FLOAT ? "" : "$(echo 'int x;' | cc -fexcess-precision=16 -x c -fsyntax-only - "
                         "2>/dev/null && echo -fexcess-precision=16)");
        return compile_cxx();
    }
    for (i = 0; i < count && !bad; i++) bad = write_source(t, &jobs[i], i);
    if (!bad && (t->route == BY_SPIRV || t->route == BY_MSL)) bad = prepare_spirv(t);
    if (!bad && t->route == BY_MSL) bad = prepare_msl(count) || compile_cxx();
    if (!bad && t->route == BY_WEBGPU) bad = prepare_webgpu(jobs, count);
    if (!bad && t->route == BY_SPIRV && !have_vulkan)
        bad = shell("cd %s && ls *.spv | xargs -P2 -I@ spirv-cross --version 430 --no-es @ --output @.text && "
                    "for f in *.spv.text; do mv $f ${f%%.spv.text}.text; done", folder);
    return bad;
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

static int run_text(const target *t, const work *w, int number) {
    char path[128], *text;
    int bad;
    snprintf(path, sizeof path, "%s/%d.text", folder, number);
    text = read_text(path);
    if (!text) return why_set(&reason, "cannot read %s", path);
    bad = t->route == BY_FRAGMENT ? run_opengl_fragment(text, w, &reason) : run_opengl_compute(text, w, &reason);
    free(text);
    return bad;
}

static int run_function(void *library, const work *w, int number) {
    char name[32];
    void *symbol;
    void (*run)(const float *, float *);
    int i;
    snprintf(name, sizeof name, "run_%d", number);
    symbol = dlsym(library, name);
    if (!symbol) return why_set(&reason, "%s is not in the library", name);
    memcpy(&run, &symbol, sizeof run);
    for (i = 0; i < w->items; i++) run(w->in + i * w->ins, w->out + i * w->outs);
    return 0;
}

static int read_output(const work *w, int number) {
    char path[128];
    FILE *f;
    size_t count = (size_t)(w->items * w->outs), got;
    snprintf(path, sizeof path, "%s/%d.out", folder, number);
    f = fopen(path, "rb");
    if (!f) return why_set(&reason, "no output of kernel %d", number);
    got = fread(w->out, sizeof(float), count, f);
    fclose(f);
    return got == count ? 0 : why_set(&reason, "too little output of kernel %d", number);
}

static int run_job(const target *t, const job *j, int number, void *library) {
    char path[128];
    if (library) return run_function(library, &j->work, number);
    if (t->route == BY_WEBGPU) return read_output(&j->work, number);
    if (t->route != BY_SPIRV || !have_vulkan) return run_text(t, &j->work, number);
    snprintf(path, sizeof path, "%s/%d.spv", folder, number);
    return run_vulkan(path, &j->work, 1, NULL, &reason);
}

/* ---- the proof ---- */

/* Largest error of the language against the description in double, as it is and over its bound; of the description against
   prt.h, over the largest output; the largest output */
typedef struct outcome { double error, bound_share, description, largest; } outcome;

/* Sine and cosine: every API asks for 2^-11; llvmpipe keeps 2^-21, Chromium's SwiftShader does not. glslang truncates the
   constants of 16 bits. */
static arithmetic arithmetic_of(const target *t) {
    const double eps = 1.0 / 2048;
    const arithmetic full = { FLT_EPSILON / 2, FLT_EPSILON / 2, ldexp(1, t->route == BY_WEBGPU ? -11 : -21), FLT_MIN };
    const arithmetic half = { eps, t->precision == PRECISION_FLOAT16 ? 2 * eps : eps, 2 * eps, 1.0 / 16384 };
    return t->precision == PRECISION_FLOAT ? full : half;
}

static double round_input(double v, precision p) {
    int exponent;
    if (p == PRECISION_FLOAT || v == 0) return (double)(float)v;
    frexp(v, &exponent);
    exponent = exponent < -13 ? -24 : exponent - 11;
    v = ldexp(nearbyint(ldexp(v, -exponent)), exponent);
    return fabs(v) < 1.0 / 16384 ? 0 : v;              /* a subnormal half may be flushed */
}

static double description_error(const job *j, const reference *r, double *largest) {
    static const arithmetic exact = { DBL_EPSILON / 2, DBL_EPSILON / 2, DBL_EPSILON, 0 };
    double in[1024], out[512] = { 0 }, worst = 0;
    bounded got[512];
    int item, i;
    *largest = 0;
    for (item = 0; item < 256; item++) {
        fill_inputs(j->k, item, in);
        bound_kernel(j->k, in, exact, got);
        r->call(j->bands, in, out);
        for (i = 0; i < j->work.outs; i++) {
            double difference = fabs(got[i].value - out[i]);
            if (!(difference <= worst)) worst = difference;
            if (fabs(out[i]) > *largest) *largest = fabs(out[i]);
        }
    }
    return *largest > 0 ? worst / *largest : worst;
}

static void compare(const job *j, const target *t, outcome *o) {
    const arithmetic a = arithmetic_of(t);
    double values[1024];
    bounded want[512];
    int item, i;
    for (item = 0; item < j->work.items; item++) {
        for (i = 0; i < j->work.ins; i++) values[i] = (double)j->work.in[item * j->work.ins + i];
        bound_kernel(j->k, values, a, want);
        for (i = 0; i < j->work.outs; i++) {
            double got = (double)j->work.out[item * j->work.outs + i];
            double error = fabs(got - want[i].value), share = error / (want[i].error + 1e-37);
            if (!(error <= o->error)) o->error = error;
            if (!(share <= o->bound_share)) {
                o->bound_share = share;
                if (share > 1 && !*reason.line)
                    why_set(&reason, "item %d, output %d: %g instead of %g", item, i, got, want[i].value);
            }
        }
    }
}

static int items_of(const work *w, const target *t) {
    if (w->ins + w->outs <= LONG) return ITEMS;
    return t->route == BY_FRAGMENT ? LONG_FRAGMENT_ITEMS : LONG_ITEMS;
}

static int open_job(job *j, const family *f, int bands, const target *t) {
    double values[1024];
    float *in;
    int item, i;
    j->family = f;
    j->bands = bands;
    j->k = f->describe(bands);
    kernel_count_uses(j->k);
    j->work.ins = kernel_inputs(j->k);
    j->work.outs = kernel_outputs(j->k);
    j->work.items = items_of(&j->work, t);
    j->work.in = in = (float *)calloc((size_t)j->work.items * (size_t)j->work.ins + 1, sizeof *in);
    j->work.out = (float *)calloc((size_t)j->work.items * (size_t)j->work.outs, sizeof *in);
    if (!in || !j->work.out) return why_set(&reason, "out of memory");
    for (item = 0; item < j->work.items; item++) {
        fill_inputs(j->k, item, values);
        for (i = 0; i < j->work.ins; i++) in[item * j->work.ins + i] = (float)round_input(values[i], t->precision);
    }
    return 0;
}

static void close_job(job *j) {
    kernel_free(j->k);
    free((float *)j->work.in);
    free(j->work.out);
}

enum { MAX_FAMILIES = 100, MAX_JOBS = 1000, MAX_BANDS = 10, PAGE_BANDS = 4 };
static outcome outcomes[MAX_FAMILIES][TARGETS][MAX_BANDS + 1];         /* [bands]; 0 where bands mean nothing */
static int passed, failed;

static void judge(const target *t, const job *j, int number, void *library) {
    const reference *r = find_reference(j->family->name);
    outcome o = { 0, 0, 0, 0 };
    int ok;
    o.description = description_error(j, r, &o.largest);
    reason.line[0] = 0;
    ok = !run_job(t, j, number, library);
    if (ok) {
        compare(j, t, &o);
        ok = o.bound_share <= 1 && o.description <= 2e-14 * j->bands + r->approximation;
    }
    printf("%s %d - %s %s, %d bands: description %.1e, error %.2e, %.2f of its bound%s%s\n", ok ? "ok" : "not ok",
           passed + failed + 1, t->name, j->family->name, j->bands, o.description, o.error, o.bound_share,
           *reason.line ? ": " : "", reason.line);
    outcomes[j->family - families][t - targets][j->family->max_bands ? j->bands : 0] = o;
    passed += ok;
    failed += !ok;
}

static const char *only;                               /* kernel, NULL: every */
static int bands_from, bands_to;                       /* of --bands; 0: the target's own */

/* llvmpipe's LLVM takes half a minute for each kernel of this size, products of 6 bands */
enum { LONGEST_FOR_LLVMPIPE = 2500 };

static int too_long(const target *t, const job *j) {
    op_count c = kernel_operations(j->k);
    int by_llvmpipe = t->route == BY_FRAGMENT || t->route == BY_COMPUTE || t->route == BY_SPIRV;
    return by_llvmpipe && !only && c.multiplications + c.additions > LONGEST_FOR_LLVMPIPE;
}

static int open_jobs(const target *t, job *jobs) {
    int from = bands_from ? bands_from : t->from, to = bands_to ? bands_to : t->to, f, bands, count = 0;
    for (f = 0; f < family_count; f++) {
        const family *has = &families[f];
        if (!(has->forms & FORM_TEXT) || (only && strcmp(only, has->name))) continue;
        if (!find_reference(has->name)) {
            printf("not ok %d - no line in REFERENCES for the kernel %s\n", passed + ++failed, has->name);
            continue;
        }
        for (bands = from; bands <= to && bands <= MAX_BANDS; bands++) {
            if (has->max_bands ? bands < has->min_bands || bands > has->max_bands : bands > from) continue;
            if (count == MAX_JOBS) return why_set(&reason, "more than %d kernels: raise MAX_JOBS", MAX_JOBS);
            if (open_job(&jobs[count], has, bands, t)) return -1;
            if (too_long(t, &jobs[count])) close_job(&jobs[count]);
            else count++;
        }
    }
    return count;
}

static int prove(const target *t) {
    static job jobs[MAX_JOBS];
    const char *why_not = cannot_run(t);
    int count, i, bad;
    void *library = NULL;
    char path[128];
    if (why_not) {
        printf("ok %d - %s # SKIP %s\n", ++passed + failed, t->name, why_not);
        return 0;
    }
    if (make_temporary_directory("prt-shaders", folder, sizeof folder))
        return why_set(&reason, "cannot make a folder among the temporary files");
    count = open_jobs(t, jobs);
    bad = count < 0 || prepare(t, jobs, count);
    if (!bad && (t->route == BY_C || t->route == BY_CXX || t->route == BY_MSL)) {
        snprintf(path, sizeof path, "%s/all.so", folder);
        library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
        if (!library) bad = why_set(&reason, "cannot load %s: %s", path, dlerror());
    }
    for (i = 0; i < count; i++) {
        if (!bad) judge(t, &jobs[i], i, library);
        close_job(&jobs[i]);
    }
    if (library) dlclose(library);
    if (shell("rm -r %s", folder)) return -1;
    return bad;
}

/* ---- the page ---- */

static const outcome *page_outcome(int f, int t) { return &outcomes[f][t][families[f].max_bands ? PAGE_BANDS : 0]; }
static int was_run(const outcome *o) { return o->bound_share > 0 || o->error > 0 || o->largest > 0; }

static void print_page_head(FILE *page, const char *first, int columns, int half) {
    int i;
    fprintf(page, "%s", first);
    for (i = 0; i < TARGETS; i++)
        if ((targets[i].precision != PRECISION_FLOAT) == half) fprintf(page, " %s |", targets[i].name);
    fprintf(page, "\n|");
    for (i = 0; i < columns; i++) fprintf(page, "---|");
    for (i = 0; i < TARGETS; i++)
        if ((targets[i].precision != PRECISION_FLOAT) == half) fprintf(page, "---|");
    fprintf(page, "\n");
}

static void print_page_table(FILE *page, int half) {
    int i, f;
    if (half) print_page_head(page, "| kernel | largest output |", 2, half);
    else print_page_head(page, "| kernel | largest output | description |", 3, half);
    for (f = 0; f < family_count; f++) {
        if (!(families[f].forms & FORM_TEXT) || families[f].min_bands > PAGE_BANDS) continue;
        fprintf(page, "| %s | %.2g |", families[f].name, page_outcome(f, 0)->largest);
        if (!half) fprintf(page, " %.0e |", page_outcome(f, 0)->description);
        for (i = 0; i < TARGETS; i++) {
            const outcome *o = page_outcome(f, i);
            if ((targets[i].precision != PRECISION_FLOAT) != half) continue;
            if (was_run(o)) fprintf(page, " %.1e (%.2f) |", o->error, o->bound_share);
            else fprintf(page, " – |");
        }
        fprintf(page, "\n");
    }
}

/* The worst at any number of bands, and which these were */
static void print_bands_table(FILE *page, int half) {
    int i, f, bands;
    print_page_head(page, "| kernel |", 1, half);
    for (f = 0; f < family_count; f++) {
        if (!(families[f].forms & FORM_TEXT) || !families[f].max_bands) continue;
        fprintf(page, "| %s |", families[f].name);
        for (i = 0; i < TARGETS; i++) {
            double worst = 0;
            int first = 0, last = 0;
            if ((targets[i].precision != PRECISION_FLOAT) != half) continue;
            for (bands = 1; bands <= MAX_BANDS; bands++) {
                const outcome *o = &outcomes[f][i][bands];
                if (!was_run(o)) continue;
                if (!first) first = bands;
                last = bands;
                if (!(o->bound_share <= worst)) worst = o->bound_share;
            }
            if (first) fprintf(page, " %.2f (%d–%d) |", worst, first, last);
            else fprintf(page, " – |");
        }
        fprintf(page, "\n");
    }
}

static int write_page(const char *path) {
    FILE *page = fopen(path, "w");
    if (!page) return why_set(&reason, "cannot write %s", path);
    fprintf(page,
        "<!-- Written by test_shaders --markdown: do not edit. -->\n# Generated kernels in every language, against prt.h\n\n"
        "4 bands, %d inputs each (%d, glsl330 %d, where a call has more than %d numbers), the axes, places from 1e-0.5 to 1e-9 rad off the poles, zero and full cones and vectors of\n"
        "length 0 among them. *Largest output*: to set errors against. *Description*: largest difference between the description,\n"
        "evaluated in double, and the function of prt.h in double, over the largest output; above 1e-13 it is that of the\n"
        "polynomials that stand for sine and arc functions. The other columns: largest difference between what the language\n"
        "computed and the description in double at the same inputs; in parentheses the largest share of the running error bound\n"
        "that the operations of the kernel allow: above 1 the test fails. –: not run here.\n\n", ITEMS, LONG_ITEMS,
        LONG_FRAGMENT_ITEMS, LONG);
    fprintf(page,
        "How each was run. c: the C compiler (%s). metal: as C++ through a shim of `<metal_stdlib>`; no Metal compiler was at\n"
        "hand, so Metal's own rules were not checked. glsl330: fragment shader, glsl430: compute shader, by OSMesa (llvmpipe).\n"
        "glsl450, hlsl: by glslang (%s), wgsl: by naga to SPIR-V, which spirv-val passed and %s ran%s.\n"
        "webgpu: WGSL in headless Chromium%s%s. msl: what spirv-cross makes of the SPIR-V of glsl450, through the shim.\n\n",
        __VERSION__, there("glslc", "true") ? "glslc" : "glslangValidator",
        have_vulkan ? vulkan_name() : "OpenGL", have_vulkan ? " by Vulkan" : ", after spirv-cross",
        *webgpu_name ? ", " : "", webgpu_name);
    print_page_table(page, 0);
    fprintf(page, "\n## Every number of bands\n\n"
        "The largest share of the bound at any number of bands, and from which to which number it was run. A language has a\n"
        "kernel at each number of bands that `prt_codegen --list` names. llvmpipe, which runs glsl330, glsl430 and all SPIR-V, is\n"
        "not given kernels of more than %d operations, products of 6 bands: its LLVM compiles each for half a minute.\n\n",
        LONGEST_FOR_LLVMPIPE);
    print_bands_table(page, 0);
    fprintf(page, "\n## Half precision\n\n"
        "Inputs are halves, constants too. c-half: `_Float16`, each operation rounded; metal-half: C++ that rounds each operation;\n"
        "glsl-float16, hlsl-float16 and wgsl-f16: 16-bit types in SPIR-V; glsl-mediump and hlsl-min16float leave the width to the\n"
        "driver, and this one takes 32 bits.\n\n");
    print_page_table(page, 1);
    fprintf(page, "\nThe largest share of the bound at any number of bands:\n\n");
    print_bands_table(page, 1);
    return fclose(page) ? why_set(&reason, "cannot write %s", path) : 0;
}

/* ---- what a call costs ---- */

enum { COST_FROM = 2, COST_TO = 6 };

/* Arithmetic and memory instructions of the one function besides main, once its values are in SSA form */
static const char count_instructions[] =
    "/ = OpFunction / { inside = $1 != \"%main\"; next }\n"
    "/OpFunctionEnd/ { inside = 0 }\n"
    "!inside { next }\n"
    "{ op = $1 ~ /^%/ ? $3 : $1 }\n"
    "op == \"OpLoad\" || op == \"OpStore\" { memory++ }\n"
    "op ~ /^Op(F[A-Z]|ExtInst|Select|Dot|Vector|Composite|Phi)/ && op !~ /^OpFunction/ { work++ }\n"
    "END { printf \"%d + %d\", work, memory }\n";

static int write_cost_sources(void) {
    int f, bands;
    char path[128];
    FILE *file;
    for (f = 0; f < family_count; f++)
        for (bands = COST_FROM; bands <= COST_TO; bands++) {
            kernel *k;
            if (!(families[f].forms & FORM_TEXT) || (families[f].max_bands &&
                (bands < families[f].min_bands || bands > families[f].max_bands))) continue;
            if (families[f].max_bands == 0 && bands > COST_FROM) continue;
            snprintf(path, sizeof path, "%s/%d-%d.comp", folder, f, bands);
            file = fopen(path, "w");
            if (!file) return why_set(&reason, "cannot write %s", path);
            k = families[f].describe(bands);
            wrap_kernel(file, k, "glsl", PRECISION_FLOAT, WRAP_COMPUTE, "450", 0);
            kernel_free(k);
            fclose(file);
        }
    snprintf(path, sizeof path, "%s/count.awk", folder);
    file = fopen(path, "w");
    if (!file) return why_set(&reason, "cannot write %s", path);
    fputs(count_instructions, file);
    return fclose(file) ? why_set(&reason, "cannot write %s", path) : 0;
}

static void print_cost(FILE *page, int f, int bands) {
    char path[128], *text;
    kernel *k = families[f].describe(bands);
    kernel_count_uses(k);
    snprintf(path, sizeof path, "%s/%d-%d.comp.count", folder, f, bands);
    text = read_text(path);
    fprintf(page, " %s; %d |", text ? text : "?", kernel_live_values(k));
    free(text);
    kernel_free(k);
}

static int write_costs(const char *path) {
    FILE *page;
    int f, bands;
    if (make_temporary_directory("prt-shaders", folder, sizeof folder))
        return why_set(&reason, "cannot make a folder among the temporary files");
    if (write_cost_sources() ||
        shell("cd %s && ls *.comp | xargs -P2 -I@ sh -c 'glslangValidator -V -S comp -o @.spv @ >@.log && "
              "spirv-opt --ssa-rewrite --eliminate-local-multi-store --eliminate-dead-code-aggressive @.spv -o @.opt && "
              "spirv-dis --no-color @.opt | awk -f count.awk >@.count || exit 255'", folder)) return -1;
    page = fopen(path, "w");
    if (!page) return why_set(&reason, "cannot write %s", path);
    fprintf(page,
        "<!-- Written by test_shaders --cost: do not edit. -->\n# What a call of a generated kernel costs\n\n"
        "Instructions of SPIR-V in the kernel's function by itself (GLSL 450 by glslangValidator, brought into SSA form by\n"
        "spirv-opt): arithmetic + loads and stores; those of arrays vanish where a compiler inlines the function and keeps the\n"
        "arrays in registers, as their indices are constants. After the semicolon: the most values that live at a time besides\n"
        "those arrays, in the order of the text, as an estimate of registers. –: does not exist at these bands.\n\n"
        "| kernel | 2 bands | 3 bands | 4 bands | 5 bands | 6 bands |\n|---|---|---|---|---|---|\n");
    for (f = 0; f < family_count; f++) {
        if (!(families[f].forms & FORM_TEXT)) continue;
        fprintf(page, "| %s |", families[f].name);
        for (bands = COST_FROM; bands <= COST_TO; bands++) {
            if (families[f].max_bands == 0 && bands > COST_FROM) fprintf(page, " same |");
            else if (families[f].max_bands == 0) print_cost(page, f, bands);
            else if (bands < families[f].min_bands || bands > families[f].max_bands) fprintf(page, " – |");
            else print_cost(page, f, bands);
        }
        fprintf(page, "\n");
    }
    if (fclose(page)) return why_set(&reason, "cannot write %s", path);
    return shell("rm -r %s", folder);
}

int main(int argc, char **argv) {
    const char *page = NULL, *costs = NULL;
    int i;
    for (i = 1; i + 1 < argc; i++) {
        if (!strcmp(argv[i], "--naga")) naga_modules = argv[i + 1];
        if (!strcmp(argv[i], "--only")) only = argv[i + 1];
        if (!strcmp(argv[i], "--bands") && sscanf(argv[i + 1], "%d-%d", &bands_from, &bands_to) != 2) {
            fprintf(stderr, "test_shaders: --bands %s: give A-B\n", argv[i + 1]);
            return 2;
        }
        if (!strcmp(argv[i], "--markdown")) page = argv[i + 1];
        if (!strcmp(argv[i], "--cost")) costs = argv[i + 1];
    }
    for (i = 1; i < argc; i++) {
        const target *t = find_target(argv[i]);
        if (argv[i][0] == '-') { i++; continue; }
        if (!t) { fprintf(stderr, "test_shaders: no target '%s'\n", argv[i]); return 2; }
        if (prove(t)) {
            fprintf(stderr, "test_shaders: %s: %s\n", t->name, reason.line);
            printf("not ok %d - %s\n", passed + ++failed, t->name);
        }
    }
    if (costs && write_costs(costs)) { fprintf(stderr, "test_shaders: %s\n", reason.line); failed++; }
    if (page && write_page(page)) { fprintf(stderr, "test_shaders: %s\n", reason.line); failed++; }
    if (have_opengl) osmesa_context_destroy(&opengl);
    if (have_vulkan) vulkan_destroy();
    printf("1..%d\n", passed + failed);
    return failed != 0;
}
