/* rotation_forms.c - the two recursions at the precision of prt_real, named by ROTATION_FORM. */
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"

#include <stdlib.h>

#include "published_rotation.h"
#include "rotation_forms.h"

static void keep_larger(double *worst, double error) { if (!(error <= *worst)) *worst = error; }

int ROTATION_FORM(double *published, double *stabilised) {
    size_t count = prt_sh_rotation_count(ROTATION_BANDS);
    prt_real *ours = (prt_real *)malloc(count * sizeof *ours), *theirs = (prt_real *)malloc(count * sizeof *theirs);
    int trial, l, i, ok = ours && theirs;
    for (trial = 0; ok && trial < ROTATION_TRIALS; trial++) {
        prt_real q[4], rotation[9] = { 0 };
        for (i = 0; i < 4; i++) q[i] = (prt_real)sin(1 + 4 * trial + i);
        prt_rotation_from_quaternion(q, rotation);
        prt_sh_rotation(ROTATION_BANDS, rotation, ours);
        memcpy(theirs, ours, prt_sh_rotation_count(2) * sizeof *ours);
        for (l = 0; l < ROTATION_BANDS; l++) {
            prt_real *block = theirs + prt_sh_rotation_count(l);
            if (l > 1) published_block(l, theirs + 1, theirs + prt_sh_rotation_count(l - 1), block);
            keep_larger(&published[l], orthogonality_error(2 * l + 1, block));
            keep_larger(&stabilised[l], orthogonality_error(2 * l + 1, ours + prt_sh_rotation_count(l)));
        }
    }
    free(ours);
    free(theirs);
    return ok;
}
