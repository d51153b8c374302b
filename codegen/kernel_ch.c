/* Kernels of the room >>ch: C(l,m) = A (1-z^2)^(m/2) d^m T_l / dz^m {cos, sin}(m phi) [Sherif 2013], of unit norm. The
   shape of SH's kernels with other factors: C(m,m) = Y(m,m), and the recurrence of the derivatives of T, normalised. */
#include "kernels.h"

/* H(l,m) = 1 + q0 (1 + q1 (1 + ...)): the norm of C's expansion into Y over that of its leading term. */
static xreal norm_ratio(int l, int m) {
    xreal h = 1;
    long j;
    for (j = (l - m) / 2 - 1; j >= 0; j--) {
        long L = l - 2 * j;
        xreal t = x_ratio((2 * L - 3) * (2 * j - 1) * (2 * l - 2 * j + 1), (2 * L + 1) * (2 * j + 2) * (l + L - 2));
        h = 1 + t * t * x_ratio((2 * L + 1) * (L - m) * (L - m - 1), (2 * L - 3) * (L + m) * (L + m - 1)) * h;
    }
    return h;
}

xreal ch_factor_a(int l, int m) { return sh_factor_a(l, m) * x_sqrt(norm_ratio(l - 1, m) / norm_ratio(l, m)); }

xreal ch_factor_c(int l, int m) {
    if (l < m + 2) return 0;
    if (l == 2) return ch_factor_a(2, 0) * ch_factor_a(1, 0) / 2;                  /* l > m + 1, so m = 0 */
    return x_ratio((long)(l + m - 2) * (l - 1 - m), 4L * (l - 2) * (l - 1)) * ch_factor_a(l, m) * ch_factor_a(l - 1, m);
}

static const basis ch = { "ch", "CH", ch_factor_a, ch_factor_c };

kernel *describe_ch_eval(int bands) { return describe_eval(&ch, bands); }
kernel *describe_ch_at(int bands) { return describe_at(&ch, bands); }
