/* Built by link.sh with PRT_MAX_BANDS overridden: the limit is where it was put, and evaluation works right up to it. */
#define PRT_IMPLEMENTATION
#include "prt.h"
#include <stdio.h>

static prt_real y[PRT_SH_COUNT(PRT_MAX_BANDS + 1)];

int main(void) {
    prt_vec3 dir;
    double sum = 0, want = 0;
    int l, m, bad = 0;
    dir.x = PRT__R(0.48); dir.y = PRT__R(-0.6); dir.z = PRT__R(0.64);
    if (prt_sh_eval(PRT_MAX_BANDS + 1, dir, y) != PRT_ERR_BANDS || y[0] != 0) {
        bad = 1;
        printf("one band too many was not refused\n");
    }
    if (prt_sh_eval(PRT_MAX_BANDS, dir, y) != PRT_OK) {
        bad = 1;
        printf("PRT_MAX_BANDS bands were refused\n");
    }
    for (l = 0; l < PRT_MAX_BANDS; l++) {                /* addition theorem: sum_m Y(l,m)^2 = (2l+1)/(4 pi) */
        for (m = -l; m <= l; m++) sum += (double)y[PRT_SH_INDEX(l, m)] * (double)y[PRT_SH_INDEX(l, m)];
        want += (2 * l + 1) / (4 * PRT__PI);
    }
    if (!(sum >= want * (1 - 1e-3) && sum <= want * (1 + 1e-3))) {
        bad = 1;
        printf("sum of squares %.9g, expected %.9g\n", sum, want);
    }
    if (y[PRT_SH_COUNT(PRT_MAX_BANDS)] != 0) {
        bad = 1;
        printf("wrote beyond the last coefficient\n");
    }
    return bad;
}
