/* rotation - how far the rotation blocks are from orthogonal, band by band: the recursion as published and prt.h's.

     rotation [--csv FILE]

   Prints a few rows; --csv writes all of them for rotation_error.gp. Takes some seconds. */
#include <stdio.h>
#include <string.h>

#include "bench.h"
#include "rotation_forms.h"

int main(int argc, char **argv) {
    static double error[4][ROTATION_BANDS];
    FILE *csv = NULL;
    int l;
    if (argc != 1 && !(argc == 3 && !strcmp(argv[1], "--csv"))) {
        fprintf(stderr, "rotation: unknown arguments: give none, or --csv FILE\n");
        return 1;
    }
    if (argc == 3 && !(csv = fopen(argv[2], "w"))) {
        fprintf(stderr, "rotation: cannot write '%s': check the folder and its permissions\n", argv[2]);
        return 1;
    }
    if (!rotation_float(error[0], error[1]) || !rotation_double(error[2], error[3])) {
        fprintf(stderr, "rotation: out of memory: 128 bands need 70 MB\n");
        return 1;
    }
    printf("largest |M M^T - 1| over %d rotations\n", ROTATION_TRIALS);
    printf("%4s %20s %20s %20s %20s\n", "l", "published, float", "prt.h, float", "published, double", "prt.h, double");
    if (csv) fprintf(csv, "# machine: %s\n# compiler: %s %s\nl,published_float,prt_float,published_double,prt_double\n",
                     bench_cpu_name(), BENCH_COMPILER, BENCH_FLAGS);
    for (l = 0; l < ROTATION_BANDS; l++) {
        if (l == 8 || (l + 1) % 16 == 0)
            printf("%4d %20.2g %20.2g %20.2g %20.2g\n", l, error[0][l], error[1][l], error[2][l], error[3][l]);
        if (csv) fprintf(csv, "%d,%.3g,%.3g,%.3g,%.3g\n", l, error[0][l], error[1][l], error[2][l], error[3][l]);
    }
    if (csv && fclose(csv)) {
        fprintf(stderr, "rotation: cannot finish '%s': is the disk full?\n", argv[2]);
        return 1;
    }
    return 0;
}
