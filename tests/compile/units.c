/* Compiled many times by link.sh, with UNIT naming the part: pieces of programs that share prt.h across files. */
#if defined(UNIT_IMPLEMENTATION) || defined(PRT_STATIC)
#  define PRT_IMPLEMENTATION
#endif
#include "prt.h"
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif
double first_coefficient(void);
double second_unit(void);

/* one program, two precisions: the same question to both */
double from_float_unit(void);
double from_double_unit(void);
unsigned long size_in_float_unit(void);
unsigned long size_in_double_unit(void);

#ifdef UNIT_NAMES_PRECISION
#  ifdef PRT_DOUBLE
#    define from_this_unit from_double_unit
#    define size_in_this_unit size_in_double_unit
#  else
#    define from_this_unit from_float_unit
#    define size_in_this_unit size_in_float_unit
#  endif
#endif

static double answer(void) {
    prt_vec3 dir;
    prt_real y[PRT_SH_COUNT(3)];
    dir.x = 0; dir.y = 0; dir.z = 1;
    if (prt_sh_eval(3, dir, y) != PRT_OK) return -1;
    return (double)y[PRT_SH_INDEX(2, 0)];             /* sqrt(5/(4 pi)) */
}

#ifdef UNIT_SECOND
double second_unit(void) { return answer(); }
#endif
#ifdef UNIT_NAMES_PRECISION
double from_this_unit(void) { return answer(); }
unsigned long size_in_this_unit(void) { return (unsigned long)sizeof(prt_vec3); }
#endif
#ifdef UNIT_MAIN_TWO_FILES
int main(void) {
    printf("%.6f %.6f\n", answer(), second_unit());
    return 0;
}
#endif
#ifdef UNIT_MAIN_BOTH_PRECISIONS
int main(void) {
    double f = from_float_unit(), d = from_double_unit();
    printf("%.6f %.6f %lu %lu %s\n", f, d, size_in_float_unit(), size_in_double_unit(), f == d ? "same" : "different");
    return answer() < 0;
}
#endif
#ifdef __cplusplus
}
#endif
