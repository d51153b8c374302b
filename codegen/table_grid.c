/* Tables of the products of prt.h (room >>product): nodes, weights, steps and scales of columns; factors at nodes. */
#include "kernels.h"

typedef struct table_printer { FILE *to; int column; } table_printer;

static void table_open(table_printer *t, const char *name, const char *what, int count) {
    fprintf(t->to, "/* %s */\nPRT__STATIC const prt_real *prt__%s(void) {\n"
                   "    static const prt_real table[%d] PRT__ALIGNED = {\n", what, name, count);
    t->column = 0;
}

static void table_entry(table_printer *t, xreal value, int is_last) {
    char text[64];
    x_print(value, 20, text);
    t->column += fprintf(t->to, "%s", t->column ? " " : "        ");
    t->column += fprintf(t->to, value == 0 ? "0%s%s" : "PRT__R(%s)%s", value == 0 ? "" : text, is_last ? "" : ",");
    if (t->column > 85 || is_last) { fprintf(t->to, "\n"); t->column = 0; }
    if (is_last) fprintf(t->to, "    };\n    return table;\n}\n\n");
}

/* Node pairs in the grid of so many bands */
int grid_pairs(int bands) { return (3 * bands + 1) / 4; }

/* Gauss-Legendre nodes z >= 0 and weights of 1 ... bands bands, a row of so many places each, the rest of it 0; weights
   times pi/2, of which half for the equator, which is used twice. */
static void print_nodes(FILE *to, int bands, int weights) {
    table_printer t = { to, 0 };
    int n, i;
    table_open(&t, weights ? "grid_weights" : "grid_nodes",
               weights ? "weights of the product grids" : "nodes of the product grids, z >= 0", bands * bands);
    for (n = 1; n <= bands; n++)
        for (i = 0; i < bands; i++) {
            xreal z = 0, w = 0;
            if (i < grid_pairs(n)) x_gauss((3 * n - 1) / 2, i, &z, &w);
            w *= x_pi() / (z > 0 ? 2 : 4);
            table_entry(&t, weights ? w : z, n == bands && i + 1 == bands);
        }
}

/* The monic columns of the part in z: q(l) = z q(l-1) - step(l,m) q(l-2) from q(m) = 1, and what makes Y's of them */
static void print_columns(FILE *to, int bands) {
    table_printer t = { to, 0 };
    int l, m;
    table_open(&t, "grid_steps", "steps of monic columns at (l-1)l/2 + m, 0 <= m < l", bands * (bands - 1) / 2);
    for (l = 1; l < bands; l++)
        for (m = 0; m < l; m++)
            table_entry(&t, x_ratio((l - 1) * (l - 1) - m * m, l > 1 ? 4 * (l - 1) * (l - 1) - 1 : 1),
                        l == bands - 1 && m == l - 1);
    table_open(&t, "grid_scales", "Y(l,m) over its monic column, at l(l+1) + m", bands * bands);
    for (l = 0; l < bands; l++)
        for (m = -l; m <= l; m++) {
            int a = m < 0 ? -m : m, k;
            xreal scale = x_harmonic(a, a, 0) * (a ? x_sqrt(2) : 1);       /* (1-z^2)^(m/2) is 1 at z = 0 */
            for (k = a + 1; k <= l; k++) scale *= x_sqrt(x_ratio(4 * k * k - 1, k * k - a * a));
            table_entry(&t, scale, l == bands - 1 && m == l);
        }
}

/* ---- factors of the product kernels at their nodes: kernel_nodes.c ---- */

static xreal cube_root(xreal v) {                                  /* 0 < v < 8 */
    xreal r = 1;
    int i;
    for (i = 0; i < 40; i++) r = (2 * r + v / (r * r)) / 3;
    return r;
}

/* q(l,m) of the circles at z and -z, z >= 0; the equator, which stands on both sides, has half its weight */
xreal node_factor(int bands, int pair, int l, int m) {
    xreal z, w;
    x_gauss((3 * bands - 1) / 2, pair, &z, &w);
    if (!(z > 0)) { z = 0; w /= 2; }
    return x_harmonic(l, m, z) * (m ? x_sqrt(2) : 1) * cube_root(w * x_pi() / 2) * (m ? 1 : 2);
}

/* One row for each l and m: the factor at the nodes z >= 0, which the macro repeats, or negates, for those at -z. What
   is left of a row is 0. */
static void print_node_table(FILE *to, int bands) {
    int pairs = grid_pairs(bands), most = bands == 3 ? 2 : 4, l, m, i;
    fprintf(to, "/* factors of the product of %d bands at %d nodes z >= 0 and their mirror images */\n", bands, pairs);
    fprintf(to, "PRT__STATIC const prt_real *prt__nodes_%d(void) {\n    static const prt_real table[%d][PRT__NODES] "
                "PRT__ALIGNED = {\n", bands, bands * (bands + 1) / 2);
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            fprintf(to, "        PRT__%s_%d(", (l - m) & 1 ? "ODD" : "EVEN", most);
            for (i = 0; i < most; i++) {
                char text[64];
                x_print(i < pairs ? node_factor(bands, i, l, m) : 0, 20, text);
                fprintf(to, "%s%s", i ? ", " : "", text);
            }
            fprintf(to, ")%s\n", l + 1 == bands && m == l ? "" : ",");
        }
    fprintf(to, "    };\n    return table[0];\n}\n\n");
}

void print_node_tables(FILE *to, int bands) {
    int n;
    for (n = 3; n <= bands; n++) print_node_table(to, n);
}

void print_grid_tables(FILE *to, int bands) {
    print_nodes(to, bands, 0);
    print_nodes(to, bands, 1);
    print_columns(to, bands);
}
