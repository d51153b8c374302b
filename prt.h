/* prt.h - v0.1.0 - precomputed radiance transfer, the runtime - MIT or Unlicense, your choice (see end of file)

   WHAT IT IS
     The mathematics that a program needs while it lights a scene from precomputed radiance transfer (PRT):
     spherical harmonics (SH), projection of lights and environment maps, windows, shading from transfer.
     Plain C99, also C++11; no dependency but the C standard library; no allocation, no I/O, no threads, no mutable
     globals: every buffer is yours.
   WHAT IT IS NOT
     A renderer, a ray tracer, or a baker. prt_bake.h beside it computes the transfer, with rays that you trace.

   HOW TO INCLUDE
     Anywhere:                  #include "prt.h"
     In exactly one C/C++ file: #define PRT_IMPLEMENTATION
                                #include "prt.h"
     Link with -lm where the platform needs it.

   A COMPLETE EXAMPLE
     #include <stdio.h>
     #define PRT_IMPLEMENTATION
     #include "prt.h"
     int main(void) {
         enum { BANDS = 3, N = PRT_SH_COUNT(BANDS) };
         prt_vec3 sun = { 0.6f, 0.0f, 0.8f }, normal = { 0.0f, 0.0f, 1.0f };
         prt_real light[3 * N], transfer[N];
         prt_rgb  out;
         int c;
         for (c = 0; c < 3; c++) prt_sh_delta(BANDS, sun, light + c * N);      // a white directional light
         prt_sh_cosine_lobe(BANDS, normal, transfer);                          // an unshadowed surface: its transfer
         for (c = 0; c < N; c++) transfer[c] /= 3.14159265f;                   // is the cosine lobe over pi
         prt_shade_diffuse(BANDS, transfer, light, &out);                      // exit radiance for albedo 1
         printf("%g %g %g\n", out.r, out.g, out.b);                            // about 0.8 / pi
         return 0;
     }

   CONVENTIONS (fixed; every function keeps them)
     Space      right-handed, polar axis +z. A direction is a unit prt_vec3.
     SH         real, orthonormal, without the Condon-Shortley phase:
                Y(0,0) = 1/(2 sqrt(pi));  Y(1,-1), Y(1,0), Y(1,1) = sqrt(3/(4 pi)) (y, z, x).
     Bands      n = how many: l = 0 ... n-1, n^2 coefficients; coefficient (l,m) stands at PRT_SH_INDEX(l,m) = l(l+1)+m.
                (The field also says "order" for n and "degree" for l.) 1 <= n <= PRT_MAX_BANDS.
     Rotation   row-major 3x3 acting on column vectors, v' = R v; rotating a function moves its features: f'(R v) = f(v).
     Colour     prt_rgb, linear. Coloured SH light is three planes of n^2, one after the other: light + c n^2.
     Transfer   radiance L, irradiance E(N) = int L max(0, N.w) dw, transfer T = (1/pi) int V max(0, N.w) Y(w) dw:
                exit radiance of a diffuse surface = albedo * sum_i T_i L_i. White, unshadowed, under L = 1: 1.
     docs/conventions.md converts to and from other programs (see prt_sh_convert).

   MAP OF THE ROOMS (grep for the tag; a room uses only rooms above it)
     >>types      results, vectors, colours
     >>sh         basis evaluation, reconstruction, dot product
     >>project    samples, analytic lights, environment maps, convolution, conversion of conventions
     >>window     Hann, Lanczos and positive windows
     >>shade      exit radiance from transfer
     >>reference  slow evaluators by other routes, for tests
     >>generated  straight-line kernels, written by codegen/

   ERRORS
     Integer and pointer arguments are always checked. A bad one returns a prt_result other than PRT_OK and writes
     nothing; a function that returns a value returns 0. A pointer may be NULL where its count is 0.
     Functions that build something (lights, tables) also check their values. Per-sample functions (evaluation,
     reconstruction, dot, shading) do not; no value makes them crash, loop, or write outside their buffers: NaN in, NaN out.

   MEMORY, ALIASING, THREADS
     The library allocates nothing and keeps no state; its stack use is bounded by PRT_MAX_BANDS. Outputs must not
     overlap inputs except where the declaration says "may alias". Every function may run in any number of threads.

   CONFIG MACROS (define before the include, the same in every file of a program)
     PRT_DOUBLE          prt_real is double (otherwise float)
     PRT_STATIC          everything is static: include with PRT_IMPLEMENTATION in each file that uses it. One program can
                         so hold both precisions, in different files
     PRTDEF              storage and linkage of the declarations, where `extern` is not what you want (dllexport, say)
     PRT_MAX_BANDS       largest number of bands [64]
     PRT_NO_SIMD         plain C only: no vector extensions

   DETERMINISM
     The same build gives the same bits for the same item, whatever the count, range, order or thread it was asked in.
     Other compilers, flags or vector widths may contract a*b+c differently and so differ in the last bits; with
     -ffp-contract=off and PRT_NO_SIMD results agree wherever sin, cos, sqrt and friends of the C library agree.
     -ffast-math: results stay within a few ulp of those promised; NaN and infinity are no longer handled.

   LIMITS
     Coefficients and directions are prt_real; bands are bounded by PRT_MAX_BANDS, evaluation was tested to 1024.

   REFERENCES
     [Ramamoorthi 2001]  Ramamoorthi, Hanrahan: An Efficient Representation for Irradiance Environment Maps. SIGGRAPH 2001
     [Sloan 2002]        Sloan, Kautz, Snyder: Precomputed Radiance Transfer for Real-Time Rendering. SIGGRAPH 2002
     [Sloan 2008]        Sloan: Stupid Spherical Harmonics (SH) Tricks. GDC 2008
     [Sloan 2013]        Sloan: Efficient Spherical Harmonic Evaluation. JCGT 2(2), 2013
     [Chapter 2010]      Chapter: Textured Hierarchical Precomputed Radiance Transfer. Cal Poly 2010
*/
#ifndef PRT_H_INCLUDED
#define PRT_H_INCLUDED

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PRTDEF
#  ifdef PRT_STATIC
#    if defined(__GNUC__)
#      define PRTDEF static __attribute__((unused))
#    else
#      define PRTDEF static
#    endif
#  else
#    define PRTDEF extern
#  endif
#endif

#ifndef PRT_MAX_BANDS
#  define PRT_MAX_BANDS 64
#endif

#define PRT_VERSION "0.1.0"

/* ------------------------------------------------------------------------------------------------- >>types ---- */

#ifdef PRT_DOUBLE
typedef double prt_real;
#else
typedef float prt_real;
#endif

typedef struct prt_vec3 { prt_real x, y, z; } prt_vec3;   /* a point or a direction */
typedef struct prt_rgb  { prt_real r, g, b; } prt_rgb;    /* a linear colour */

/* One list for codes and messages. */
#define PRT_RESULTS(X) \
    X(PRT_OK,            "success") \
    X(PRT_ERR_NULL,      "a pointer is NULL where data is needed") \
    X(PRT_ERR_BANDS,     "the number of bands is outside 1 ... PRT_MAX_BANDS") \
    X(PRT_ERR_COUNT,     "a count, size, index or stride is out of range") \
    X(PRT_ERR_VALUE,     "a value is not finite or out of range") \
    X(PRT_ERR_ROTATION,  "the matrix is neither a rotation nor a reflection") \
    X(PRT_ERR_CAPACITY,  "a buffer is too small, or a size does not fit its type") \
    X(PRT_ERR_MEMORY,    "out of memory") \
    X(PRT_ERR_TRACE,     "the ray callback failed") \
    X(PRT_ERR_CANCELLED, "cancelled by the progress callback")

#define PRT__RESULT_ENUM(name, message) name,
typedef enum prt_result { PRT_RESULTS(PRT__RESULT_ENUM) PRT__RESULT_COUNT } prt_result;
#undef PRT__RESULT_ENUM

/* The message that belongs to r: lower case, no full stop, never NULL. Cost: a table look-up. */
PRTDEF const char *prt_result_string(prt_result r);

/* ---------------------------------------------------------------------------------------------------- >>sh ---- */

#define PRT_SH_COUNT(bands)  ((bands) * (bands))          /* coefficients of so many bands */
#define PRT_SH_INDEX(l, m)   ((l) * ((l) + 1) + (m))      /* place of coefficient (l,m), -l <= m <= l */

PRTDEF prt_result prt_sh_eval   (int bands, prt_vec3 dir, prt_real *y);
PRTDEF prt_result prt_sh_eval_n (int bands, int count, const prt_vec3 *dirs, prt_real *y);
PRTDEF prt_result prt_sh_eval_soa(int bands, int count, const prt_real *x, const prt_real *y, const prt_real *z,
                                  prt_real *out, size_t stride);
PRTDEF prt_real   prt_sh_at     (int bands, const prt_real *f, prt_vec3 dir);
PRTDEF prt_real   prt_sh_dot    (int bands, const prt_real *f, const prt_real *g);

/* ----------------------------------------------------------------------------------------------- >>project ---- */

/* ------------------------------------------------------------------------------------------------ >>window ---- */

/* ------------------------------------------------------------------------------------------------- >>shade ---- */

PRTDEF prt_result prt_shade_diffuse  (int bands, const prt_real *transfer, const prt_real *light, prt_rgb *out);
PRTDEF prt_result prt_shade_diffuse_n(int bands, int count, const prt_real *transfer, const prt_real *light,
                                      prt_rgb *out);

/* --------------------------------------------------------------------------------------------- >>reference ---- */

#ifdef __cplusplus
}
#endif
#endif /* PRT_H_INCLUDED */

/* ==================================================================================================================
   The interface ends here. Below stands the implementation, in the same order.
   ================================================================================================================== */

#if defined(PRT_IMPLEMENTATION) && !defined(PRT_IMPLEMENTATION_INCLUDED)
#define PRT_IMPLEMENTATION_INCLUDED

#include <float.h>
#include <math.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__) || defined(_MSC_VER)
#  define PRT__RESTRICT __restrict
#elif !defined(__cplusplus) && defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L
#  define PRT__RESTRICT restrict
#else
#  define PRT__RESTRICT
#endif

#if defined(__GNUC__)
#  define PRT__INLINE static __inline__ __attribute__((unused, always_inline))
#  define PRT__STATIC static __attribute__((unused))
#else
#  define PRT__INLINE static inline
#  define PRT__STATIC static
#endif

/* GCC and Clang vector extensions, at the width that the target flags allow. */
#if defined(__GNUC__) && !defined(PRT_NO_SIMD)
#  define PRT__SIMD 1
#  if defined(__AVX512F__)
#    define PRT__VEC_BYTES 64
#  elif defined(__AVX__)
#    define PRT__VEC_BYTES 32
#  else
#    define PRT__VEC_BYTES 16
#  endif
#else
#  define PRT__SIMD 0
#endif

#define PRT__PI 3.14159265358979323846264338327950288
#define PRT__R(v) ((prt_real)(v))                          /* a double constant as a prt_real */

#ifdef PRT_DOUBLE
#  define PRT__EPS DBL_EPSILON
#  define PRT__REAL_MAX DBL_MAX
PRT__INLINE prt_real prt__sqrt(prt_real v) { return sqrt(v); }
#else
#  define PRT__EPS FLT_EPSILON
#  define PRT__REAL_MAX FLT_MAX
PRT__INLINE prt_real prt__sqrt(prt_real v) { return sqrtf(v); }
#endif

/* ------------------------------------------------------------------------------------------------- >>types ---- */

PRTDEF const char *prt_result_string(prt_result r) {
#define PRT__RESULT_MESSAGE(name, message) message,
    static const char *const messages[] = { PRT_RESULTS(PRT__RESULT_MESSAGE) "unknown result" };
#undef PRT__RESULT_MESSAGE
    return messages[(unsigned)r < (unsigned)PRT__RESULT_COUNT ? (unsigned)r : (unsigned)PRT__RESULT_COUNT];
}

/* Finite, in a form that needs no <math.h> macro: false for NaN and for both infinities. */
PRT__INLINE int prt__finite(prt_real v) { return v - v == 0; }
PRT__INLINE int prt__finite3(prt_vec3 v) { return prt__finite(v.x) && prt__finite(v.y) && prt__finite(v.z); }
PRT__INLINE prt_real prt__dot3(prt_vec3 a, prt_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

PRT__INLINE int prt__bands_ok(int bands) { return bands >= 1 && bands <= PRT_MAX_BANDS; }

/* ---------------------------------------------------------------------------------------------------- >>sh ---- */

/* Y(l,+-m) = p(l,m) {Re,Im}(x+iy)^m, the recurrence of [Sloan 2013] with m outside and l inside. */
PRT__STATIC void prt__sh_generic(int bands, prt_vec3 d, prt_real *PRT__RESTRICT y) {
    prt_real re = 1, im = 0, sector = PRT__R(0.28209479177387814347);
    int l, m;
    for (m = 0; m < bands; m++) {
        prt_real p2 = 0, p1 = m ? sector * PRT__R(1.41421356237309504880) : sector;
        for (l = m; l < bands; l++) {
            if (l > m) {
                prt_real a = prt__sqrt(PRT__R(4 * l * l - 1) / PRT__R(l * l - m * m));
                prt_real b = prt__sqrt(PRT__R((l - 1) * (l - 1) - m * m) / PRT__R(4 * (l - 1) * (l - 1) - 1));
                prt_real p = a * (d.z * p1 - b * p2);
                p2 = p1;
                p1 = p;
            }
            y[PRT_SH_INDEX(l, -m)] = p1 * im;
            y[PRT_SH_INDEX(l, m)] = p1 * re;
        }
        { prt_real t = re * d.x - im * d.y; im = re * d.y + im * d.x; re = t; }
        sector *= prt__sqrt(PRT__R(2 * m + 3) / PRT__R(2 * m + 2));
    }
}

PRTDEF prt_result prt_sh_eval(int bands, prt_vec3 dir, prt_real *y) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!y) return PRT_ERR_NULL;
    prt__sh_generic(bands, dir, y);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_eval_n(int bands, int count, const prt_vec3 *dirs, prt_real *y) {
    int k;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0) return PRT_ERR_COUNT;
    if (count == 0) return PRT_OK;
    if (!dirs || !y) return PRT_ERR_NULL;
    for (k = 0; k < count; k++) prt__sh_generic(bands, dirs[k], y + (size_t)k * (size_t)PRT_SH_COUNT(bands));
    return PRT_OK;
}

PRTDEF prt_result prt_sh_eval_soa(int bands, int count, const prt_real *x, const prt_real *y, const prt_real *z,
                                  prt_real *out, size_t stride) {
    prt_real row[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int k, i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0 || stride < (size_t)count) return PRT_ERR_COUNT;
    if (count == 0) return PRT_OK;
    if (!x || !y || !z || !out) return PRT_ERR_NULL;
    for (k = 0; k < count; k++) {
        prt_vec3 d;
        d.x = x[k]; d.y = y[k]; d.z = z[k];
        prt__sh_generic(bands, d, row);
        for (i = 0; i < PRT_SH_COUNT(bands); i++) out[(size_t)i * stride + (size_t)k] = row[i];
    }
    return PRT_OK;
}

PRT__STATIC prt_real prt__dot(int count, const prt_real *f, const prt_real *g) {
    prt_real sum = 0;
    int i;
    for (i = 0; i < count; i++) sum += f[i] * g[i];
    return sum;
}

PRTDEF prt_real prt_sh_at(int bands, const prt_real *f, prt_vec3 dir) {
    prt_real y[PRT_SH_COUNT(PRT_MAX_BANDS)];
    if (!prt__bands_ok(bands) || !f) return 0;
    prt__sh_generic(bands, dir, y);
    return prt__dot(PRT_SH_COUNT(bands), f, y);
}

PRTDEF prt_real prt_sh_dot(int bands, const prt_real *f, const prt_real *g) {
    if (!prt__bands_ok(bands) || !f || !g) return 0;
    return prt__dot(PRT_SH_COUNT(bands), f, g);
}

/* ----------------------------------------------------------------------------------------------- >>project ---- */

/* ------------------------------------------------------------------------------------------------ >>window ---- */

/* ------------------------------------------------------------------------------------------------- >>shade ---- */

PRTDEF prt_result prt_shade_diffuse(int bands, const prt_real *transfer, const prt_real *light, prt_rgb *out) {
    return prt_shade_diffuse_n(bands, 1, transfer, light, out);
}

PRTDEF prt_result prt_shade_diffuse_n(int bands, int count, const prt_real *transfer, const prt_real *light,
                                      prt_rgb *out) {
    int k, n;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0) return PRT_ERR_COUNT;
    if (count == 0) return PRT_OK;
    if (!transfer || !light || !out) return PRT_ERR_NULL;
    n = PRT_SH_COUNT(bands);
    for (k = 0; k < count; k++) {
        const prt_real *t = transfer + (size_t)k * (size_t)n;
        out[k].r = prt__dot(n, t, light);
        out[k].g = prt__dot(n, t, light + n);
        out[k].b = prt__dot(n, t, light + 2 * n);
    }
    return PRT_OK;
}

/* --------------------------------------------------------------------------------------------- >>reference ---- */

/* --------------------------------------------------------------------------------------------- >>generated ---- */

#ifdef __cplusplus
}
#endif
#endif /* PRT_IMPLEMENTATION */

/*
This software is available under two licences. Choose whichever you prefer.

------------------------------------------------------------------------------
ALTERNATIVE A - MIT License

Copyright (c) 2026 the prt.h authors

Permission is hereby granted, free of charge, to any person obtaining a copy of
this software and associated documentation files (the "Software"), to deal in
the Software without restriction, including without limitation the rights to
use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies
of the Software, and to permit persons to whom the Software is furnished to do
so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.

------------------------------------------------------------------------------
ALTERNATIVE B - Public Domain (www.unlicense.org)

This is free and unencumbered software released into the public domain.

Anyone is free to copy, modify, publish, use, compile, sell, or distribute this
software, either in source code form or as a compiled binary, for any purpose,
commercial or non-commercial, and by any means.

In jurisdictions that recognize copyright laws, the author or authors of this
software dedicate any and all copyright interest in the software to the public
domain. We make this dedication for the benefit of the public at large and to
the detriment of our heirs and successors. We intend this dedication to be an
overt act of relinquishment in perpetuity of all present and future rights to
this software under copyright law.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN
ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION
WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
*/
