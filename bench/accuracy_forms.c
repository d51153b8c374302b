/* accuracy_forms.c - compiled once for float and once for double (PRT_DOUBLE), with PRT_MAX_BANDS 1024. */
#define PRT_STATIC
#define PRT_IMPLEMENTATION
#include "prt.h"
#include "accuracy_forms.h"
#include "textbook.h"

#include <stdlib.h>

enum { LANES = 16 };   /* directions handed to the batched forms: all the same one */

static prt_real *scratch(void) {
    static prt_real *room;
    if (!room) room = (prt_real *)malloc(sizeof(prt_real) * LANES * PRT_SH_COUNT(PRT_MAX_BANDS));
    if (!room) abort();
    return room;
}

static prt_vec3 direction(const double dir[3]) {
    prt_vec3 d;
    d.x = (prt_real)dir[0]; d.y = (prt_real)dir[1]; d.z = (prt_real)dir[2];
    return d;
}

static void widen(int bands, const prt_real *from, size_t step, double *to) {
    size_t i, count = (size_t)PRT_SH_COUNT(bands);
    for (i = 0; i < count; i++) to[i] = (double)from[i * step];
}

static void by_eval(int bands, const double dir[3], double *y) {
    prt_sh_eval(bands, direction(dir), scratch());
    widen(bands, scratch(), 1, y);
}

static void by_recurrence(int bands, const double dir[3], double *y) {
    prt__sh_recurrence(bands, direction(dir), NULL, scratch(), 1);
    widen(bands, scratch(), 1, y);
}

static void by_soa(int bands, const double dir[3], double *y) {
    prt_real at[3][LANES];
    int k;
    for (k = 0; k < LANES; k++) {
        at[0][k] = direction(dir).x; at[1][k] = direction(dir).y; at[2][k] = direction(dir).z;
    }
    prt_sh_eval_soa(bands, LANES, at[0], at[1], at[2], scratch(), LANES);
    widen(bands, scratch(), LANES, y);
}

static void by_textbook(int bands, const double dir[3], double *y) {
    textbook_sh(bands, direction(dir), scratch());
    widen(bands, scratch(), 1, y);
}

static const accuracy_form forms[] = {
    { "prt_sh_eval", PRT_MAX_BANDS, by_eval },
    { "prt_sh_eval_soa", PRT_MAX_BANDS, by_soa },
    { "recurrence, any band", PRT_MAX_BANDS, by_recurrence },
    { "textbook K P", 128, by_textbook },
};

#ifdef PRT_DOUBLE
const accuracy_form *accuracy_forms_double(int *count)
#else
const accuracy_form *accuracy_forms_float(int *count)
#endif
{
    *count = (int)(sizeof forms / sizeof forms[0]);
    return forms;
}
