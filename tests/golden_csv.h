/* Reading the tables of tests/golden/: comma-separated numbers under one header line. */
#ifndef PRT_GOLDEN_CSV_H
#define PRT_GOLDEN_CSV_H

/* Opens PRT_GOLDEN_DIR/name past its header line; the test fails where it cannot. */
static inline FILE *golden_open(const char *name) {
    char path[1024];
    FILE *f;
    int c;
    snprintf(path, sizeof path, "%s/%s", PRT_GOLDEN_DIR, name);
    f = fopen(path, "r");
    if (!f) fail_msg("cannot open %s", path);
    do c = fgetc(f); while (c != '\n' && c != EOF);
    return f;
}

/* One row "l,m,x,y,z,value" of an evaluation table; 0 at the end of the file. */
typedef struct golden_row { int l, m; double x, y, z, value; } golden_row;
static inline int golden_next(FILE *f, golden_row *r) {
    return fscanf(f, "%d,%d,%lf,%lf,%lf,%lf", &r->l, &r->m, &r->x, &r->y, &r->z, &r->value) == 6;
}

/* How far a value of band l may lie from the exact one because (x,y,z) was rounded to precision eps: each coordinate is
   off by eps/2, and |grad Y_l| <= l(l+1)/2 sqrt((2l+1)/(4 pi)) at worst, at the poles; the length of the direction
   enters with the power l. */
static inline double golden_input_rounding(int l, double eps) {
    return (l + l * (l + 1) / 8.0) * eps * sqrt((2 * l + 1) / (4 * 3.14159265358979323846));
}

#endif
