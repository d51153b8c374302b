/* icount.c - runs each kernel of a short list once under valgrind's callgrind, which counts its instructions exactly.
   icount.sh compares the counts with icount.csv. Not useful when run alone. */
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"

#include <stdio.h>
#include <string.h>
#include <valgrind/callgrind.h>

enum { COUNT = 256, WIDTH = 64, HEIGHT = 32, MOST = 16 };

static prt_vec3 dirs[COUNT];
static prt_real x[COUNT], y[COUNT], z[COUNT], f[3 * MOST * MOST], g[3 * MOST * MOST], rows[COUNT * 25];
static prt_real blocks[MOST * (4 * MOST * MOST - 1) / 3], out[COUNT * 25 + MOST * (4 * MOST * MOST - 1) / 3];
static prt_rgb shaded[COUNT];
static float texels[3 * WIDTH * HEIGHT];
static const prt_real turn[9] = { (prt_real)0.36, (prt_real)0.48, (prt_real)-0.8, (prt_real)-0.8, (prt_real)0.6, 0,
                                  (prt_real)0.48, (prt_real)0.64, (prt_real)0.6 };

static void fill(prt_real *to, int count) {
    int i;
    for (i = 0; i < count; i++) to[i] = (prt_real)((i * 37) % 101 - 50) / 50;
}

static void prepare(void) {
    int k;
    for (k = 0; k < COUNT; k++) {
        prt_real t = (prt_real)(2 * k + 1) / COUNT - 1, s = prt__sqrt(1 - t * t);
        x[k] = dirs[k].x = s * (prt_real)0.6;
        y[k] = dirs[k].y = s * (prt_real)0.8;
        z[k] = dirs[k].z = t;
    }
    fill(f, 3 * MOST * MOST);
    fill(g, 3 * MOST * MOST);
    fill(rows, COUNT * 25);
    for (k = 0; k < 3 * WIDTH * HEIGHT; k++) texels[k] = (float)(k % 17);
}

/* Counts `call` and gives the count its name. A first call leaves out what happens only once, say symbol binding. */
#define COUNT_IT(name, call) do { \
        call; \
        CALLGRIND_ZERO_STATS; \
        call; \
        CALLGRIND_DUMP_STATS_AT(name); \
        __asm__ volatile("" : : "r"(out), "r"(shaded) : "memory"); \
    } while (0)

int main(void) {
    if (!RUNNING_ON_VALGRIND) {
        fprintf(stderr, "icount: run me through bench/icount.sh, which needs valgrind\n");
        return 1;
    }
    prepare();
    COUNT_IT("sh_eval-3", prt_sh_eval(3, dirs[0], out));
    COUNT_IT("sh_eval-5", prt_sh_eval(5, dirs[0], out));
    COUNT_IT("sh_eval-10", prt_sh_eval(10, dirs[0], out));
    COUNT_IT("sh_eval-16", prt_sh_eval(16, dirs[0], out));
    COUNT_IT("sh_eval_n-5x256", prt_sh_eval_n(5, COUNT, dirs, out));
    COUNT_IT("sh_eval_soa-5x256", prt_sh_eval_soa(5, COUNT, x, y, z, out, COUNT));
    COUNT_IT("sh_at-5", out[0] = prt_sh_at(5, f, dirs[0]));
    COUNT_IT("sh_dot-5", out[0] = prt_sh_dot(5, f, g));
    COUNT_IT("sh_cone-5", prt_sh_cone(5, dirs[0], (prt_real)0.3, out));
    COUNT_IT("sh_project_equirect-5x64x32", prt_sh_project_equirect_rgb(5, WIDTH, HEIGHT, texels, out));
    COUNT_IT("sh_rotation-5", prt_sh_rotation(5, turn, blocks));
    COUNT_IT("sh_rotate_by-5", prt_sh_rotate_by(5, blocks, f, out));
    COUNT_IT("sh_rotate_by_n-5x256", prt_sh_rotate_by_n(5, blocks, COUNT, rows, out));
    COUNT_IT("sh_product-3", prt_sh_product(3, f, g, out));
    COUNT_IT("sh_product-5", prt_sh_product(5, f, g, out));
    COUNT_IT("sh_product-10", prt_sh_product(10, f, g, out));
    COUNT_IT("sh_product_soa-5x128", prt_sh_product_soa(5, COUNT / 2, rows, rows + COUNT / 2, out, COUNT));
    COUNT_IT("sh_mask_filter-5", prt_sh_mask_filter(5, PRT_WINDOW_POSITIVE, f, g, out));
    COUNT_IT("shade_diffuse_n-5x256", prt_shade_diffuse_n(5, COUNT, rows, f, shaded));
    return 0;
}
