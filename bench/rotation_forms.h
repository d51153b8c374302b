/* rotation_forms.h - what rotation.c asks of rotation_forms.c, which is compiled once for each precision. */
#ifndef ROTATION_FORMS_H
#define ROTATION_FORMS_H

enum { ROTATION_BANDS = 128, ROTATION_TRIALS = 4 };

/* error[l] = largest |M M^T - 1| of band l over ROTATION_TRIALS rotations; 0 if there was no memory. */
typedef int rotation_form(double *published, double *stabilised);
rotation_form rotation_float, rotation_double;

#endif
