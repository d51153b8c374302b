/* Kernels of the room >>ch: C(l,m) = A (1-z^2)^(m/2) d^m T_l / dz^m {cos, sin}(m phi) [Sherif 2013], of unit norm. The
   shape of SH's kernels with other factors: C(m,m) = Y(m,m), and the recurrence of the derivatives of T, normalised. */
#include "kernels.h"

#include <stdlib.h>

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

/* ---- between the bases: C(l,m) = sum_j S(l,l-2j,m) Y(l-2j,m), j = 0 ... (l-m)/2 ---- */

static xreal basis_change(int l, int L, int m) {
    xreal s = 1 / x_sqrt(norm_ratio(l, m));
    long j, k;
    for (j = 0, k = l; k > L; j++, k -= 2)
        s *= x_ratio((2 * k - 3) * (2 * j - 1) * (2L * l - 2 * j + 1), (2 * k + 1) * (2 * j + 2) * (l + k - 2)) *
             x_sqrt(x_ratio((2 * k + 1) * (k - m) * (k - m - 1), (2 * k - 3) * (k + m) * (k + m - 1)));
    return s;
}

/* One column of coefficients l = |m|, |m|+2, ... or |m|+1, |m|+3, ...; the four ways to go */
typedef void change(kernel *k, int bands, int m, int first, node *f);
#define AT(l) f[(l) * ((l) + 1) + m]
#define S(l, L) basis_change(l, L, m < 0 ? -m : m)

static void by_transpose(kernel *k, int bands, int m, int first, node *f) {    /* f_SH = S^T a */
    int l, L;
    for (L = first; L < bands; L += 2) {
        AT(L) = k_scale(k, S(L, L), AT(L));
        for (l = L + 2; l < bands; l += 2) AT(L) = k_add(k, AT(L), k_scale(k, S(l, L), AT(l)));
    }
}
static int last_of(int bands, int first) { return first + (bands - 1 - first) / 2 * 2; }
/* a = S^-T f_SH, from the last */
static void by_inverse_transpose(kernel *k, int bands, int m, int first, node *f) {
    int l, L;
    for (L = last_of(bands, first); L >= first; L -= 2) {
        for (l = L + 2; l < bands; l += 2) AT(L) = k_sub(k, AT(L), k_scale(k, S(l, L), AT(l)));
        AT(L) = k_scale(k, 1 / S(L, L), AT(L));
    }
}
static void by_matrix(kernel *k, int bands, int m, int first, node *f) {       /* moments = S f_SH, from the last */
    int l, L;
    for (l = last_of(bands, first); l >= first; l -= 2) {
        AT(l) = k_scale(k, S(l, l), AT(l));
        for (L = l - 2; L >= first; L -= 2) AT(l) = k_add(k, AT(l), k_scale(k, S(l, L), AT(L)));
    }
}
static void by_inverse(kernel *k, int bands, int m, int first, node *f) {      /* f_SH = S^-1 moments */
    int l, L;
    for (l = first; l < bands; l += 2) {
        for (L = first; L < l; L += 2) AT(l) = k_sub(k, AT(l), k_scale(k, S(l, L), AT(L)));
        AT(l) = k_scale(k, 1 / S(l, l), AT(l));
    }
}
#undef AT
#undef S

static void change_basis(kernel *k, int bands, change *way, node *f) {
    int m, first;
    for (m = 1 - bands; m < bands; m++)
        for (first = abs(m); first < bands && first <= abs(m) + 1; first++) way(k, bands, m, first, f);
}

static kernel *describe_change(const char *name, const char *what, int bands, change *first, change *second) {
    kernel *k = named_kernel(name, what, bands);
    node f[64 * 64];
    input_nodes(k, "f", bands * bands, f);
    change_basis(k, bands, first, f);
    if (second) change_basis(k, bands, second, f);
    output_nodes(k, "out", bands * bands, f);
    return k;
}
kernel *describe_ch_from_sh(int bands) {
    return describe_change("ch_from_sh", "CH coefficients from SH", bands, by_inverse_transpose, 0);
}
kernel *describe_sh_from_ch(int bands) {
    return describe_change("sh_from_ch", "SH coefficients from CH", bands, by_transpose, 0);
}
kernel *describe_ch_from_moments(int bands) {
    return describe_change("ch_from_moments", "CH coefficients from integrals with the basis", bands, by_inverse,
                           by_inverse_transpose);
}
kernel *describe_ch_to_moments(int bands) {
    return describe_change("ch_to_moments", "integrals with the basis from CH coefficients", bands, by_transpose,
                           by_matrix);
}

/* By the rows of S^T, g as it comes: f.G g = (S^T f).(S^T g) */
kernel *describe_ch_dot(int bands) {
    kernel *k = named_kernel("ch_dot", "integral of a product", bands);
    node f[64 * 64], g[64 * 64], sum = k_const(k, 0);
    int i;
    input_nodes(k, "f", bands * bands, f);
    input_nodes(k, "g", bands * bands, g);
    change_basis(k, bands, by_transpose, f);
    change_basis(k, bands, by_transpose, g);
    for (i = 0; i < bands * bands; i++) sum = k_madd(k, f[i], g[i], sum);
    real_result(k, sum);
    return k;
}

kernel *describe_ch_rotate(int bands) {
    kernel *k = named_kernel("ch_rotate", "rotation or reflection of one vector by a matrix", bands);
    node r[9], f[64 * 64];
    input_nodes(k, "r", 9, r);
    input_nodes(k, "f", bands * bands, f);
    change_basis(k, bands, by_transpose, f);
    rotate_by_matrix(k, bands, r, f);
    change_basis(k, bands, by_inverse_transpose, f);
    output_nodes(k, "out", bands * bands, f);
    return k;
}

kernel *describe_ch_product(int bands) {
    kernel *k = named_kernel("ch_product", "product", bands);
    node f[64 * 64], g[64 * 64], out[64 * 64];
    input_nodes(k, "f", bands * bands, f);
    input_nodes(k, "g", bands * bands, g);
    change_basis(k, bands, by_transpose, f);
    change_basis(k, bands, by_transpose, g);
    product_nodes(k, bands, f, g, out);
    change_basis(k, bands, by_inverse_transpose, out);
    output_nodes(k, "out", bands * bands, out);
    return k;
}
