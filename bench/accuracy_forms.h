/* accuracy_forms.h - the evaluators whose error is measured, as one build of prt.h offers them. */
#ifndef BENCH_ACCURACY_FORMS_H
#define BENCH_ACCURACY_FORMS_H

typedef struct accuracy_form {
    const char *name;
    int max_bands;                     /* beyond this it is not worth running */
    /* Evaluates `bands` bands at dir (whose numbers are exact in the form's precision) to y[bands^2]. */
    void (*evaluate)(int bands, const double dir[3], double *y);
} accuracy_form;

const accuracy_form *accuracy_forms_float(int *count);
const accuracy_form *accuracy_forms_double(int *count);

#endif
