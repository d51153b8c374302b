/* Prints what extremes.h measures, for run.sh: lines of
     case|section|what|error|bound
     drift|turns|norm lost by a vector|the same, bands scaled back every 1000|matrix|the same, Gram-Schmidt every 1000
     chain|masks|no window|Hann on light and filter|positive window on the filter
     cost|what|ns
   `stability bands` only the cases of many bands: for a build with PRT_MAX_BANDS of 1024, whose other functions would take
   more stack than there is. Exit code 1 if an error exceeds its bound. */
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include "../extremes.h"
#include <time.h>

static int print_cases(int only_bands) {
    int k, failed = 0;
    for (k = 0; k < EXTREME_CASES; k++) {
        const extreme_case *c = &extreme_cases[k];
        extreme e;
        if (only_bands != (c->measure == extreme_bands)) continue;
        e = c->measure(c->a, c->b);
        printf("case|%s|%s|%.2g|%.2g\n", c->section, c->what, e.error, e.bound);
        if (e.error <= e.bound) continue;
        fprintf(stderr, "stability: %s, %s: error %g exceeds %g\n", c->section, c->what, e.error, e.bound);
        failed = 1;
    }
    return failed;
}

static void print_drift(void) {
    double turns;
    for (turns = 1; turns <= 1000000; turns *= 10)
        printf("drift|%.0f|%g|%g|%g|%g\n", turns, extreme_drift(turns, 0).error, extreme_drift(turns, 1000).error,
               extreme_matrix(turns, 0).error, extreme_matrix(turns, 1000).error);
}

static void print_chains(void) {
    int masks;
    for (masks = 1; masks <= 64; masks++)
        printf("chain|%d|%g|%g|%g\n", masks, extreme_mask_gain(masks, PRT_WINDOW_NONE, 1),
               extreme_mask_gain(masks, PRT_WINDOW_HANN, 0), extreme_mask_gain(masks, PRT_WINDOW_POSITIVE, 1));
}

/* ns of processor time a turn: the least of five */
static double cost(extreme (*turn)(double, double), double every) {
    const double turns = 100000;
    double least = HUGE_VAL;
    int k;
    for (k = 0; k < 5; k++) {
        clock_t start = clock();
        turn(turns, every);
        least = fmin(least, (double)(clock() - start) / CLOCKS_PER_SEC * 1e9 / turns);
    }
    return least;
}

int main(int argc, char **argv) {
    int only_bands = argc == 2 && strcmp(argv[1], "bands") == 0, failed = print_cases(only_bands);
    if (only_bands) return failed;
    print_drift();
    print_chains();
    printf("cost|turning a vector of 5 bands (`prt_sh_rotate`)|%.1f\n", cost(extreme_drift, 0));
    printf("cost|the same, and scaling its bands back every time|%.1f\n", cost(extreme_drift, 1));
    printf("cost|product of two matrices|%.1f\n", cost(extreme_matrix, 0));
    printf("cost|the same, and Gram-Schmidt every time|%.1f\n", cost(extreme_matrix, 1));
    return failed;
}
