/* bench_gpu: how long the generated kernels take on a GPU, by Vulkan's own clock.

     bench_gpu [--bands N] [--items N] [--runs N]

   Each kernel runs for so many items [262144] at so many bands [4]: it reads its inputs from a buffer and writes its
   outputs to one, as a pass that shades would; what all items share there (a light, a rotation, an occluder) is read
   from one place. The shortest of so many runs [9] counts. Takes the first device that is a GPU; where there is none
   but a processor that stands in for one (Mesa's lavapipe), it says so. Exits with 1 and a line if there is no
   device, or no compiler for GLSL. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../codegen/kernels.h"
#include "../tests/shaders/references.h"
#include "../tests/shaders/runner.h"
#include "../tests/shaders/wrapper.h"
#include "program.h"

/* shared_from, shared_to: parameters that are the same for all items. what: as the table says it */
typedef struct row { const char *kernel; int shared_from, shared_to; const char *what; } row;
static const row rows[] = {
    { "sh_eval", 0, 0, "evaluation of the basis" },
    { "sh_at", 0, 1, "value in a direction, one function for all" },
    { "sh_rotate", 0, 1, "rotation, one matrix for all" },
    { "sh_rotate_turned", 0, 2, "the same, its cosines and sines prepared" },
    { "sh_rotate_by", 0, 1, "the same by prepared matrices of the bands" },
    { "sh_product", 0, 0, "product" },
    { "shade_diffuse", 1, 2, "diffuse shading, one light for all" },
    { "shade_diffuse_rgb", 1, 2, "the same from three planes of transfer" },
    { "vo_direct", 2, 8, "VO shading: light without occluders" },
    { "vo_pass", 1, 8, "VO shading: what one occluder lets through" },
    { "vo_pass_cap", 2, 9, "VO shading: the same, a cap" },
    { "vo_sent", 2, 15, "VO shading: what one occluder sends on" },
};
enum { ROWS = sizeof rows / sizeof rows[0] };

static char folder[128];
static why reason;

static const family *find_family(const char *name) {
    int i;
    for (i = 0; i < family_count; i++)
        if (!strcmp(families[i].name, name) && families[i].forms & FORM_TEXT) return &families[i];
    return NULL;
}

/* Where the inputs of parameter p begin */
static int input_of(const kernel *k, int p) {
    int i, at = 0;
    for (i = 0; i < p && i < k->param_count; i++)
        if (k->params[i].kind != PARAM_OUTPUT && k->params[i].kind != PARAM_RESULT)
            at += k->params[i].count ? k->params[i].count : 1;
    return at;
}

static int compile(kernel *k, const row *r, char *spirv, size_t size) {
    char source[160], command[900];
    FILE *f;
    snprintf(source, sizeof source, "%s/kernel.comp", folder);
    snprintf(spirv, size, "%s/kernel.spv", folder);
    f = fopen(source, "w");
    if (!f) return why_set(&reason, "cannot write %s", source);
    kernel_count_uses(k);
    wrap_shared(f, k, input_of(k, r->shared_from), input_of(k, r->shared_to));
    if (fclose(f)) return why_set(&reason, "cannot write %s: is the disk full?", source);
    snprintf(command, sizeof command, "glslc -O --target-env=vulkan1.0 -o %s %s 2>/dev/null || "
             "glslangValidator -V -S comp -o %s %s >/dev/null 2>&1", spirv, source, spirv, source);
    return system(command) ? why_set(&reason, "GLSL does not compile: install glslc or glslangValidator") : 0;
}

static float *make_inputs(const kernel *k, int items, int ins) {
    float *in = (float *)malloc(sizeof *in * (size_t)items * (size_t)ins);
    double values[1024];
    int item, i;
    for (item = 0; in && item < items; item++) {
        fill_inputs(k, 1000 + item, values);           /* past the special cases */
        for (i = 0; i < ins; i++) in[(size_t)item * (size_t)ins + (size_t)i] = (float)values[i];
    }
    return in;
}

/* Seconds of one run, and the bytes that each item has of its own */
static int measure(const row *r, int bands, int items, int runs, double *seconds, int *bytes) {
    const family *f = find_family(r->kernel);
    kernel *k;
    char spirv[160];
    float *in = NULL, *out = NULL;
    work w;
    int bad;
    if (!f) return why_set(&reason, "no kernel %s", r->kernel);
    if (f->max_bands && (bands < f->min_bands || bands > f->max_bands)) return 1;
    k = f->describe(bands);
    w.items = items;
    w.ins = kernel_inputs(k);
    w.outs = kernel_outputs(k);
    *bytes = 4 * (w.ins + w.outs - (input_of(k, r->shared_to) - input_of(k, r->shared_from)));
    bad = compile(k, r, spirv, sizeof spirv);
    if (!bad) {
        in = make_inputs(k, items, w.ins);
        out = (float *)malloc(sizeof *out * (size_t)items * (size_t)w.outs);
        w.in = in;
        w.out = out;
        if (!in || !out) bad = why_set(&reason, "out of memory: fewer --items");
        else bad = run_vulkan(spirv, &w, runs, seconds, &reason);
    }
    if (!bad && !(*seconds > 0)) bad = why_set(&reason, "%s has no clock for its queue", vulkan_name());
    free(in);
    free(out);
    kernel_free(k);
    return bad;
}

static int print_rows(int bands, int items, int runs) {
    int i;
    printf("%s%s, %d items, shortest of %d runs\n\n", vulkan_name(),
           vulkan_is_processor() ? " (a processor: no GPU was found, these are not times of a GPU)" : "", items, runs);
    printf("| kernel | bands | ns a call, ms a million | GB/s | what |\n|---|---|---|---|---|\n");
    for (i = 0; i < ROWS; i++) {
        double seconds = 0, each;
        int bytes = 0, bad = measure(&rows[i], bands, items, runs, &seconds, &bytes);
        if (bad < 0) return bad;
        if (bad) continue;
        each = seconds * 1e9 / items;
        printf("| %s | ", rows[i].kernel);
        if (find_family(rows[i].kernel)->max_bands) printf("%d", bands);
        printf(" | %.4f | %.1f | %s |\n", each, bytes / each, rows[i].what);
        fflush(stdout);
    }
    return 0;
}

int main(int argc, char **argv) {
    static const char *const names[] = { "--bands", "--items", "--runs" };
    static const long least[] = { 1, 64, 1 }, most[] = { 8, 1L << 24, 1000 };
    long value[] = { 4, 262144, 9 };
    int i, j, bad;
    for (i = 1; i < argc; i += 2) {
        for (j = 0; j < 3 && strcmp(argv[i], names[j]); j++) {}
        if (j == 3) {
            fprintf(stderr, "bench_gpu: unknown option %s: use --bands, --items and --runs\n", argv[i]);
            return 2;
        }
        if (parse_number(names[j], argv[i + 1], least[j], most[j], &value[j], &reason)) {
            fprintf(stderr, "bench_gpu: %s\n", reason.line);
            return 2;
        }
    }
    if (make_temporary_directory("prt-gpu", folder, sizeof folder)) {
        fprintf(stderr, "bench_gpu: cannot make a folder among the temporary files: set TMPDIR\n");
        return 1;
    }
    bad = vulkan_create(0, &reason);
    if (!bad) {
        bad = print_rows((int)value[0], (int)value[1] / 64 * 64, (int)value[2]);
        vulkan_destroy();
    }
    if (bad) fprintf(stderr, "bench_gpu: %s\n", reason.line);
    snprintf(reason.line, sizeof reason.line, "rm -r '%s'", folder);
    if (system(reason.line)) bad = -1;
    return bad ? 1 : 0;
}
