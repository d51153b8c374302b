/* Constants of the kernels: 113-bit arithmetic, so that 21 printed digits are the same on every machine. */
#ifndef PRT_CODEGEN_XREAL_H
#define PRT_CODEGEN_XREAL_H

#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 xreal;
#else
typedef long double xreal;     /* binary128 on 64-bit Arm, RISC-V and s390x */
#endif

xreal x_pi(void);
xreal x_sqrt(xreal v);
xreal x_sin(xreal v);                                  /* |v| <= 4 */
void  x_gauss(int count, int i, xreal *z, xreal *w);   /* node i of count and its weight, Gauss-Legendre, on -1 ... 1 */
xreal x_harmonic(int l, int m, xreal z);               /* the part in z of the complex Y(l,m), m >= 0 */
xreal x_ratio(long numerator, long denominator);
void  x_print(xreal v, int digits, char *text);    /* shortest form with so many significant digits; text holds 64 */

#endif
