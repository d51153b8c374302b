/* prt.h - v0.1.0 - precomputed radiance transfer, the runtime - MIT or Unlicense, your choice (see end of file)

   WHAT IT IS
     The mathematics that a program needs while it lights a scene from precomputed radiance transfer (PRT):
     spherical harmonics (SH), projection of lights and environment maps, windows, rotation, products and masks,
     cpherical harmonics (CH), shading from transfer.
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
     >>project    samples, analytic lights, environment maps, convolution
     >>convert    coefficients and axes of other programs: DirectXMath, Unity, Unreal, three.js, Filament, splats
     >>window     Hann, Lanczos and positive windows, least values, deringing
     >>rotate     rotation: matrices, one shot, one or many vectors, about z, zonal functions
     >>product    products, squares, masks, logarithm and exponential; triple product coefficients
     >>ch         cpherical harmonics: evaluation, norms, conversion, moments, dot product, rotation, product
     >>shade      exit radiance from transfer
     >>fiv        moving occluders: fullsphere irradiance vectors, lookup, shadow, self-shadow
     >>vo         vector occluders: shadows, caustics and interreflections of point lights
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
     PRT_NO_CH           without the room >>ch, of which few programs have need: a quarter less to compile. (With
                         PRT_STATIC the compiler drops what a file does not call, which is faster still.)

   DETERMINISM
     The same build gives the same bits for the same item, whatever the count, range, order or thread it was asked in.
     Other compilers, flags or vector widths may contract a*b+c differently and so differ in the last bits; with
     -ffp-contract=off and PRT_NO_SIMD results agree wherever sin, cos, sqrt and friends of the C library agree.
     -ffast-math: errors stay within twice those promised (the tests run so); building functions still refuse NaN and
     infinity in their arguments (not among the texels of a map), nothing else holds for NaN, subnormal numbers may
     count as 0, and what is bit-equal without it may differ in the last bits.

   LIMITS
     Coefficients and directions are prt_real; bands are bounded by PRT_MAX_BANDS, evaluation was tested to 1024.

   REFERENCES
     [Ivanic 1996]       Ivanic, Ruedenberg: Rotation Matrices for Real Spherical Harmonics. Direct Determination by
                         Recursion. J. Phys. Chem. 100(15), 1996; corrections: J. Phys. Chem. A 102(45), 1998
     [Pinchon 2007]      Pinchon, Hoggan: Rotation Matrices for Real Spherical Harmonics: General Rotations of Atomic
                         Orbitals in Space-Fixed Axes. J. Phys. A 40(7), 2007
     [Ramamoorthi 2001]  Ramamoorthi, Hanrahan: An Efficient Representation for Irradiance Environment Maps. SIGGRAPH 2001
     [Sloan 2002]        Sloan, Kautz, Snyder: Precomputed Radiance Transfer for Real-Time Rendering. SIGGRAPH 2002
     [Sloan 2005]        Sloan, Luna, Snyder: Local, Deformable Precomputed Radiance Transfer. SIGGRAPH 2005
     [Sloan 2008]        Sloan: Stupid Spherical Harmonics (SH) Tricks. GDC 2008
     [Sloan 2013]        Sloan: Efficient Spherical Harmonic Evaluation. JCGT 2(2), 2013
     [Schulten 1975]     Schulten, Gordon: Exact Recursive Evaluation of 3j- and 6j-Coefficients. J. Math. Phys. 16, 1975
     [Driscoll 1994]     Driscoll, Healy: Computing Fourier Transforms and Convolutions on the 2-Sphere. Adv. Appl. Math. 15
     [Ren 2006]          Ren et al.: Real-time Soft Shadows in Dynamic Scenes using Spherical Harmonic Exponentiation.
                         SIGGRAPH 2006
     [Trapani 2006]      Trapani, Navaza: Calculation of spherical harmonics and Wigner d functions by FFT. Acta
                         Crystallographica A 62, 2006
     [Van Oosterom 1983] Van Oosterom, Strackee: The Solid Angle of a Plane Triangle. IEEE Transactions on Biomedical
                         Engineering 30(2), 1983
     [Adams 1878]        Adams: On the Expression of the Product of Any Two Legendre's Coefficients by Means of a
                         Series of Legendre's Coefficients. Proceedings of the Royal Society of London 27, 1878
     [Szego 1939]        Szego: Orthogonal Polynomials, section 7.7. AMS Colloquium Publications 23, 1939
     [Sherif 2013]       Sherif: Vector Occluders: An Empirical Approximation for Rendering Global Illumination
                         Effects in Real-Time. MSc thesis, University of Ontario Institute of Technology, 2013
     [Cigolle 2014]      Cigolle et al.: A Survey of Efficient Representations for Independent Unit Vectors. JCGT 3(2)
     [Oat 2007]          Oat, Sander: Ambient Aperture Lighting. I3D 2007
     [Michael 2010]      Michael, Chrysanthou: Fullsphere Irradiance Factorization for Real-time All-frequency
                         Illumination for Dynamic Scenes. Computer Graphics Forum 29(8), 2010
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

/* y[n^2] = Y(l,m)(dir), all bands below n, by Y(l,+-m) = p(l,m) {Re,Im} (x+iy)^m and the normalised recurrence of p in l
   ([Sloan 2013], section 2). There is no division, root or angle in it: the poles are as good as any other place.
   dir     a unit vector. It is not normalised: a length of 1 + d changes band l by up to l(l+1)/2 d
   y       n^2 values, not overlapping anything
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL.
   Cost: to 10 bands straight-line code of 0 3 12 25 41 64 90 123 159 202 products (1 to 10 bands) and somewhat fewer
   additions; above, about 7 operations a coefficient, in double, and a table of roots. Stack above 10 bands: 48 bytes
   times PRT_MAX_BANDS.
   Accuracy: absolute error at the direction as it is given, float/double, below 1.3e-6/2e-15 at 6 bands, 5e-6/8e-15 at
   10, and, being computed in double above, 1.2e-7/1e-14 at 13, 1.5e-7/4e-14 at 32, 1.5e-7/3e-13 at 64 (tests/test_sh.c;
   to 1024 bands see docs/accuracy.md). Rounding a direction to float changes a value by up to 2e-6 at 10 bands. */
PRTDEF prt_result prt_sh_eval   (int bands, prt_vec3 dir, prt_real *y);

/* The same for many directions: y[count][n^2]. Each row is the same bits whatever count and place it was asked in; it may
   differ from prt_sh_eval in the last bits, since vector code fuses other pairs of operations.
   count   >= 0; dirs and y may be NULL if it is 0. Errors: PRT_ERR_BANDS, PRT_ERR_COUNT, PRT_ERR_NULL.
   Cost: to 10 bands PRT__LANES directions at once, then a transpose: about 0.6 of prt_sh_eval a direction at 5 bands; above,
   prt_sh_eval for each (docs/speed.md). */
PRTDEF prt_result prt_sh_eval_n (int bands, int count, const prt_vec3 *dirs, prt_real *y);

/* The same, structure of arrays: the fastest form. Coefficient i of direction k = (x[k], y[k], z[k]) at out[i*stride+k].
   stride  in values, >= count (PRT_ERR_COUNT); out[i*stride + count ...] is not written
   Each direction is the same bits whatever count and place. Any stride is fast, multiples of a page included: rows are
   written in sweeps of eight. Errors: PRT_ERR_BANDS, PRT_ERR_COUNT, PRT_ERR_NULL (unless count is 0).
   Accuracy: that of prt_sh_eval to 10 bands; from 11 to 180 float stays float, 4e-6 at 13 bands, 9e-5 at 64.
   Cost: at 5 bands with AVX-512 below 1.5 x a memset of the output (docs/speed.md). */
PRTDEF prt_result prt_sh_eval_soa(int bands, int count, const prt_real *x, const prt_real *y, const prt_real *z,
                                  prt_real *out, size_t stride);

/* Value of a function in one direction, sum of f_i Y_i(dir), without forming the basis: the phasor of each m is met once.
   f[n^2]. A bad argument returns 0. Cost: n^2 multiply-adds and the columns p(l,m): 1 7 19 35 54 80 109 145 184 230
   products at 1 to 10 bands. Accuracy: that of prt_sh_eval times sum of |f_i|. */
PRTDEF prt_real   prt_sh_at     (int bands, const prt_real *f, prt_vec3 dir);

/* Integral of a product, int f g dw = sum of f_i g_i (the basis is orthonormal), f[n^2], g[n^2], which may be the same.
   A bad argument returns 0. Cost: n^2 multiply-adds in eight partial sums of fixed order.
   Accuracy: (n^2/8 + 4) eps sum of |f_i g_i|. */
PRTDEF prt_real   prt_sh_dot    (int bands, const prt_real *f, const prt_real *g);

/* ----------------------------------------------------------------------------------------------- >>project ---- */

/* Projection turns a function f on the sphere into its coefficients f_lm = int f Y_lm dw.
   Lights about an axis, F(axis.w), have closed forms: f_lm = g_l Y_lm(axis) with the factors
     g_l = 2 pi int_-1^1 F(t) P_l(t) dt = sqrt(4 pi/(2l+1)) z_l,
   z_l the m = 0 coefficient of F about +z (Funk-Hecke; [Ramamoorthi 2001], [Sloan 2008]). Nothing is sampled. The
   factors are computed in double; the error of f is that of prt_sh_eval times g_l.
   Common to all: f receives n^2 values. Axes and directions must have length 1 within 1e-3, and are then normalised.
   Errors: PRT_ERR_BANDS; PRT_ERR_NULL; PRT_ERR_VALUE, a value that is not finite or out of the range given. */

/* f += value_times_weight Y(dir): one sample of a quadrature or of a Monte Carlo estimate of int f Y dw, with
   value_times_weight = f(dir) dw, or f(dir)/(samples pdf(dir)). dir: unit. Per-sample: values are not checked.
   Cost: one evaluation and n^2 multiply-adds. The sums are prt_real: over many samples the error grows with their
   number, where float is not enough accumulate in batches. */
PRTDEF prt_result prt_sh_add_sample(int bands, prt_vec3 dir, prt_real value_times_weight, prt_real *f);

/* A unit delta, f = Y(dir): the directional light that gives irradiance 1 to a surface that faces it.
   dir: from the scene towards the light. Cost: one evaluation. */
PRTDEF prt_result prt_sh_delta(int bands, prt_vec3 dir, prt_real *f);

/* 1 within half_angle of axis, 0 outside: sun, moon, spotlight. half_angle: radians, 0 ... pi. With c = cos(half_angle)
     g_0 = 2 pi (1-c),  g_l = 2 pi (P_l-1(c) - P_l+1(c))/(2l+1) = pi sin^2(half_angle) u_l,  u_l = 2 P'_l(c)/(l(l+1)),
     (l+2)(u_l+1 - u_l) = (l-1)(u_l - u_l-1) - (2l+1)(1-c) u_l,  u_1 = 1:
   nothing cancels, however small the cap; a cap beyond pi/2 is 4 pi less the rest. To spread irradiance 1 over the cap
   multiply by 1/(pi sin^2(half_angle)). Cost: one evaluation, n^2 + 9n operations, one sine and cosine.
   Error of g_l below 1e-15 pi sin^2(half_angle), 1e-12 rad to pi, 64 bands (tests/test_project.c). */
PRTDEF prt_result prt_sh_cone(int bands, prt_vec3 axis, prt_real half_angle, prt_real *f);

/* 1 in directions that meet a sphere, 0 elsewhere: the cone with sin(half angle) = radius/|to_centre|. From inside the
   sphere every direction does (f = 2 sqrt(pi), 0, 0 ...); on its surface a hemisphere; radius 0 covers nothing.
   to_centre: from the viewer to the centre, any finite vector; radius >= 0 in the same unit. Computed from
   sin^2 = r^2/d^2 and 1 - cos = sin^2/(1 + sqrt((d-r)(d+r))/d), good for far and for grazing spheres; squares neither
   overflow nor underflow. Cost as prt_sh_cone with three square roots. Error as prt_sh_cone plus what rounding
   to_centre costs, 1 ulp of d/cos. */
PRTDEF prt_result prt_sh_sphere(int bands, prt_vec3 to_centre, prt_real radius, prt_real *f);

/* max(0, axis.w), the clamped cosine: g = pi, 2 pi/3, pi/4, 0, -pi/24, 0, pi/64 ... [Ramamoorthi 2001], by
   g_l+2 = g_l (1-l)/(l+4), for every band. f/pi is the transfer of an unshadowed surface with normal axis.
   Cost: one evaluation, n^2 + 3n operations. */
PRTDEF prt_result prt_sh_cosine_lobe(int bands, prt_vec3 axis, prt_real *f);

/* above where up.w > 0, below where up.w < 0: sky and ground. g_0 = 2 pi (above + below), for odd l g_l =
   (above - below) pi u_l with u_1 = 1, u_l+2 = -u_l l/(l+3); exactly 0 for even l > 0. above, below: finite, any sign.
   Cost: one evaluation, n^2 + 4n operations. */
PRTDEF prt_result prt_sh_hemisphere(int bands, prt_vec3 up, prt_real above, prt_real below, prt_real *f);

/* Environment maps: light = sum over texels of colour * Y(centre of the texel) * solid angle of the texel, the solid
   angles exact (they sum to 4 pi), everything accumulated in double. light: 3 n^2 values, planes r, g, b.
   rgb: linear, 3 floats a texel, row after row without padding, of either sign; one that is not finite: PRT_ERR_VALUE.
   light must not overlap the texels. A size below 1, or a map larger than size_t can count: PRT_ERR_COUNT.
   Taken at its centre a texel counts l(l+1) a^2/24 more in band l than the mean of Y over it would, a = its width in
   radians: 1.4e-3 in band 7 of a map of 256 x 128. That is the better choice where texels are samples or means of
   something finer, as the means would blur twice. It leaves sqrt(2l+1) (pi/height)^2/24 of a constant in even bands of
   a latitude-longitude map, 5.6e-5 in band 2 at 256 x 128; a cube map of 6 x 64 x 64 leaves at most 1.2e-4.
   Error: 1e-16 n^1.5 times the sum of |colour| * solid angle, then rounding to prt_real (tests/test_project.c).
   The eight mirror images of a texel share one evaluation. Stack: 1 KiB for each of PRT_MAX_BANDS, and 20 KiB. */

/* Latitude-longitude map, row 0 at +z: texel (i,j) has its centre at theta = pi (j+1/2)/height from +z and
   phi = 2 pi (i+1/2)/width from +x towards +y, and covers (2 pi/width) (cos(pi j/height) - cos(pi (j+1)/height)).
   Any width and height. Sums over columns come first, then Legendre functions for each pair of rows.
   Cost: width height (12 + 2n) + 2.3 height n^2 multiply-adds; every 16 bands beyond the first read the map again.
   1024 x 512 at 8 bands: 2 ms on one core of a Zen 5 EPYC, SSE2, gcc -O3. */
PRTDEF prt_result prt_sh_project_equirect_rgb(int bands, int width, int height, const float *rgb, prt_real *light);

/* Cube map, faces +x -x +y -y +z -z of size x size texels, oriented as in OpenGL: row 0 is t = 0, column 0 is s = 0;
   the first texel of +x lies towards (1,1,1), of -x (-1,1,-1), +y (-1,1,-1), -y (-1,-1,1), +z (-1,1,1), -z (1,1,-1).
   Any size. The solid angle of a texel is that of two triangles [Van Oosterom 1983], exact at every size.
   Cost: 6 size^2 (12 + 0.6 n^2) multiply-adds and an arctangent for 12 texels; every 16 bands beyond the first read
   the map again. 6 x 256 x 256 at 8 bands: 3.3 ms on one core of a Zen 5 EPYC, SSE2, gcc -O3. */
PRTDEF prt_result prt_sh_project_cubemap_rgb(int bands, int size, const float *const faces[6], prt_real *light);

/* Convolution with a kernel about the pole, out(w) = int f(v) k(w.v) dv: out_lm = sqrt(4 pi/(2l+1)) zonal_l f_lm
   [Ramamoorthi 2001]. zonal[n]: the m = 0 coefficients of k about +z. out may alias f, not zonal. Values unchecked.
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL. Cost: n^2 multiplies, n square roots. Error: 1 ulp of each coefficient. */
PRTDEF prt_result prt_sh_convolve(int bands, const prt_real *f, const prt_real *zonal, prt_real *out);

/* Irradiance of every normal from radiance, E(N) = int L(w) max(0, N.w) dw: E_lm = g_l L_lm with the factors pi,
   2 pi/3, pi/4, 0, -pi/24, 0, pi/64 ... of prt_sh_cosine_lobe [Ramamoorthi 2001]. out may alias radiance. Values unchecked.
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL. Cost: n^2 + 2n multiplies. Error: 1 ulp of each coefficient. */
PRTDEF prt_result prt_sh_irradiance(int bands, const prt_real *radiance, prt_real *out);

/* ----------------------------------------------------------------------------------------------- >>convert ---- */

/* Coefficients of other programs. A convention says which function the numbers stand for, as a polynomial in the
   components (x, y, z) of a direction, whatever that program calls its axes; if the axes differ too (y up, say), call
   prt_sh_convert_axes as well, on coefficients of PRT_CONVENTION_PRT, as every function here expects them. All
   conventions index coefficient (l,m) at l(l+1)+m. docs/conventions.md has the table, file by file, and the traps. */
typedef enum prt_sh_convention {
    PRT_CONVENTION_PRT = 0,             /* this header */
    PRT_CONVENTION_THREEJS,             /* SphericalHarmonics3, LightProbe: radiance, the same numbers as here */
    PRT_CONVENTION_DIRECTX,             /* D3DX and DirectXMath SHMath: (-1)^m times ours */
    PRT_CONVENTION_GOOGLE,              /* google/spherical-harmonics: (-1)^m */
    PRT_CONVENTION_UNREAL,              /* FSHVector, TSHVector: (-1)^m */
    PRT_CONVENTION_SPLAT,               /* 3D Gaussian splatting, f_dc and f_rest: (-1)^m; colour = 0.5 + the sum */
    PRT_CONVENTION_FILAMENT,            /* cmgen without pre-scaling, IndirectLight::Builder::radiance: (-1)^m */
    PRT_CONVENTION_FILAMENT_IRRADIANCE, /* IndirectLight::Builder::irradiance, pre-scaled: see below */
    PRT_CONVENTION_UNITY                /* SphericalHarmonicsL2, light probes: as FILAMENT_IRRADIANCE */
} prt_sh_convention;

/* Rewrites coefficients from one convention to another: out_i = f_i times a constant of (from, to, i). f and out hold
   bands^2 numbers; may alias. Between the first seven the constant is 1 or (-1)^m: any number of bands, exact.
   The last two hold the polynomial of irradiance over pi, E(N)/pi = sum_i c_i q_i(N) with q = 1, y, z, x, xy, yz,
   3z^2-1, xz, x^2-y^2, of the light whose radiance is meant: c_i = k_i A_l L_i, where k_i is the factor of q_i in Y_i
   and A = 1, 2/3, 1/4 the cosine lobe over pi [Ramamoorthi 2001]. So converting from them undoes the convolution with
   the cosine, and converting to them applies it: bands <= 3, else PRT_ERR_BANDS; error 1 ulp.
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL, PRT_ERR_VALUE (no such convention). Cost: n^2 multiplies. */
PRTDEF prt_result prt_sh_convert(int bands, prt_sh_convention from, prt_sh_convention to, const prt_real *f,
                                 prt_real *out);

/* Seven shader constants of four numbers each, the layout of [Sloan 2008] appendix A10 that Unity names unity_SHAr,
   SHAg, SHAb, SHBr, SHBg, SHBb, SHC (and Unreal SkyIrradianceEnvironmentMap): with N = (x,y,z), for each channel
     E(N)/pi = dot(A, (x,y,z,1)) + dot(B, (xy, yz, zz, zx)) + C (xx - yy)
   from coloured light (three planes of bands^2, radiance); of its bands the first three are used, missing ones are 0.
   Unpacking gives three planes of 9. constants[27] is written as 1 and not read. Errors: PRT_ERR_BANDS, PRT_ERR_NULL.
   Cost: 27 multiplies and a few adds. Accuracy: 2 ulp of the largest coefficient. */
PRTDEF prt_result prt_sh_pack_irradiance  (int bands, const prt_real *light, prt_real constants[28]);
PRTDEF prt_result prt_sh_unpack_irradiance(const prt_real constants[28], prt_real light[27]);

/* Axes of a world, as three letters: where +x, +y and +z point for somebody who stands in it. R right, L left, U up,
   D down, F forward, B backward; each pair once, in any order: 48 worlds, 24 of them left-handed. */
#define PRT_AXES_BLENDER "RFU"          /* z up, right-handed: Blender, 3ds Max, CAD; the usual reading of prt.h */
#define PRT_AXES_OPENGL  "RUB"          /* y up, right-handed: OpenGL, three.js, Filament, Godot, Maya, SPZ */
#define PRT_AXES_UNITY   "RUF"          /* y up, left-handed: Unity, Direct3D */
#define PRT_AXES_UNREAL  "FRU"          /* z up, left-handed: Unreal Engine */
#define PRT_AXES_OPENCV  "RDF"          /* y down, right-handed: OpenCV, COLMAP, and so most Gaussian splats */

/* The map between two worlds as a signed permutation: component k of the new vector is component |axes[k]|-1 of the
   old one, times the sign of axes[k]. "RFU" to "RUB" gives {1, 3, -2}: (x,y,z) -> (x,z,-y).
   Errors: PRT_ERR_NULL, PRT_ERR_VALUE (not three letters of three different pairs). */
PRTDEF prt_result prt_axes_map(const char *from, const char *to, int axes[3]);
/* The mapped vector; the zero vector if axes is NULL or not a signed permutation of 1, 2, 3. */
PRTDEF prt_vec3   prt_map_axes(const int axes[3], prt_vec3 v);
/* The same function in the other world: g(prt_map_axes(axes, v)) = f(v) for every v; a rotation or reflection
   by quarter turns. axes = {-1,-2,-3} turns every direction round (a splat's colour is a function of the direction
   from the eye, exit radiance of the direction to it). f and out hold bands^2 coefficients; may alias.
   Permutes and negates coefficients where z stays on its axis; otherwise it applies one swap of y and z, whose matrix
   is made from Wigner's d(pi/2) by the recurrence of [Trapani 2006] in double: about 2/3 n^3 multiply-adds, n^2/2
   square roots, no table. To 64 bands the matrix entries are within 6e-8 (float) or 1e-15 (double) of exact ones, and
   a map and its inverse return within 2e-7 or 2e-15 of the norm (tests/test_convert.c).
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL, PRT_ERR_VALUE (axes is not a signed permutation of 1, 2, 3). */
PRTDEF prt_result prt_sh_map_axes(int bands, const int axes[3], const prt_real *f, prt_real *out);
/* prt_axes_map and prt_sh_map_axes in one call; errors of both. */
PRTDEF prt_result prt_sh_convert_axes(int bands, const char *from, const char *to, const prt_real *f, prt_real *out);

/* ------------------------------------------------------------------------------------------------ >>window ---- */

/* Windows taper the bands so that a function cut off at n bands rings less: out_lm = w(l) f_lm, a convolution with a
   kernel whose factors are w(l). They act on the band l, never on the index of a coefficient. */
typedef enum prt_window { PRT_WINDOW_NONE = 0, PRT_WINDOW_HANN, PRT_WINDOW_LANCZOS, PRT_WINDOW_POSITIVE } prt_window;

/* The weight w(l) of band l in a window of this width, 0 for l >= width:
     NONE      1
     HANN      (1 + cos(pi l/width))/2
     LANCZOS   sin(pi l/width)/(pi l/width)
     POSITIVE  the Legendre moments of the sharpest non-negative kernel of degree d = width-1, that is the one with
               the largest w(1), over its integral: [P_k+1(z)/(z-z*)]^2 for d = 2k, (1+z) [P^(0,1)_k+1(z)/(z-z*)]^2 for
               d = 2k+1, z* the largest root; w(1) = z* [Szego 1939]. Keeps 0 <= f <= sup f for every non-negative f.
               Width 3: 1 .57735 .2; width 6: 1 .82282 .57611 .32616 .14039 .03568.
   w(0) = 1 for all. Width = bands leaves something of every band; width = bands-1 makes Hann drop the last.
   Returns 0 for l < 0, width < 1, an unknown window, and for POSITIVE wider than PRT_MAX_BANDS.
   Cost: one sine; POSITIVE about width^2/8 multiply-adds. Error relative to w(l): 1 ulp, in double 4 ulp; POSITIVE
   1 ulp, in double 3e-16 width (tests/test_window.c). */
PRTDEF prt_real prt_window_weight(prt_window w, int l, int width);

/* out_lm = w(l) f_lm with the weights of prt_window_weight. width >= 1, and for POSITIVE <= PRT_MAX_BANDS, else
   PRT_ERR_COUNT; an unknown window is PRT_ERR_VALUE. Bands from width on become 0. out may alias f. Values of f are
   not checked. Cost: n^2 multiplies and n weights (POSITIVE: width^3/24 multiply-adds; keep the weights if you need
   them often). */
PRTDEF prt_result prt_sh_window(int bands, prt_window w, int width, const prt_real *f, prt_real *out);

/* The least smoothing that leaves no negative value. Strength s from 0 to 1 blends every band's weight from 1 to that of the
   positive window, w(l) = 1 - s + s p(l); from 1 to 2 goes on to the mean alone, w(l) = (2 - s) p(l) for l > 0: the way for
   functions that even the positive window leaves negative (they are no projection of a non-negative one).
   out        n^2 values, may alias f; bit-equal to f where f has no negative value
   strength   receives s, 0 (untouched) to 2; may be NULL
   A mean below 0, or of 0 with anything beside it, cannot be helped: out is the mean alone, strength 2.
   Method: the minimum over 16 n^2 directions of a spiral, its eight lowest basins followed down by pattern search and Newton
   steps; f + s (Pf - f) is linear in s in every direction, so Newton's method on s from below ends in a few rounds. The
   result is above 0 by a few rounding errors, the strength above the least possible by as much (tests/test_dering.c).
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL, PRT_ERR_VALUE for a coefficient that is not finite.
   Cost: 1 to 6 rounds of 16 n^2 + 700 evaluations prt_sh_at: about 0.1 ms at 5 bands. For lights, once each; a light in
   colour keeps its hue if its three planes get the weights of the strongest of the three. */
PRTDEF prt_result prt_sh_dering(int bands, const prt_real *f, prt_real *out, prt_real *strength);

/* The least value of a function on the sphere, and (unless NULL) a direction where it is met; the search of
   prt_sh_dering. 0 for bad arguments. Accuracy: the value within a few rounding errors of the true minimum; a basin
   narrower than those that n bands can form would be needed to miss it. Cost: 16 n^2 + 700 evaluations prt_sh_at. */
PRTDEF prt_real prt_sh_minimum(int bands, const prt_real *f, prt_vec3 *dir);

/* ------------------------------------------------------------------------------------------------ >>rotate ---- */

/* Rotation of SH vectors. f'(R v) = f(v) has the coefficients f'_l = M^l(R) f_l, band by band, where M^l is defined by
   Y_l(R v) = M^l Y_l(v), is orthogonal, and M^l(-R) = (-1)^l M^l(R). A rotation is a row-major 3x3 matrix R acting on
   column vectors; it is accepted if every entry is finite and |R R^T - 1| <= 1e-3 in every entry, reflections
   (determinant -1) included, and refused with PRT_ERR_ROTATION otherwise. It is used as it is: if it is off by e, the
   result in band l is off by about l e. */

/* The rotation of the unit quaternion q = { w, x, y, z }: v' = q v q*, a turn by 2 acos(w) about (x,y,z), counter-
   clockwise seen against the axis. q is normalised first; it must be finite and not zero (PRT_ERR_VALUE). q and -q
   give the same matrix. rotation may alias q. Accuracy: 2 ulp of 1 in every entry. Cost: 30 operations, a square root,
   a division. */
PRTDEF prt_result prt_rotation_from_quaternion(const prt_real q[4], prt_real rotation[9]);

/* Values that prt_sh_rotation writes: sum of (2l+1)^2 for l < bands, which is bands (4 bands^2 - 1) / 3; 0 for a bands
   argument out of range. */
PRTDEF size_t     prt_sh_rotation_count(int bands);

/* The blocks M^l, l = 0 ... bands-1, one after the other, each row-major: entry (m,k) of band l stands at
   prt_sh_rotation_count(l) + (l+m) (2l+1) + (l+k). Use it with prt_sh_rotate_by where many vectors take one rotation.
   Method: the recursion of [Ivanic 1996] with its corrections of 1998 but with other columns of the last block near the
   edges, |k| >= 0.7 l: as published the error grows exponentially with l, here it does not (docs/papers.md).
   Accuracy, float/double, largest error of an entry: 4e-7/9e-16 at 9 bands, 4e-6/9e-15 at 64.
   Cost: about 10 multiply-adds an entry, and 7l square roots a band. blocks must not overlap rotation. */
PRTDEF prt_result prt_sh_rotation   (int bands, const prt_real rotation[9], prt_real *blocks);

/* out = blocks f for one vector f[bands^2]; out may be f. Cost: prt_sh_rotation_count multiply-adds, four at a time:
   7 ns at 4 bands, 16 to 20 ns at 6 (float, Zen 5 at 4 GHz). */
PRTDEF prt_result prt_sh_rotate_by  (int bands, const prt_real *blocks, const prt_real *f, prt_real *out);

/* out = blocks f for many vectors; out may be f, and overlap it in no other way. Each vector gets the same bits
   whatever the count and its place. Layouts: _n [count][bands^2], vector after vector (a coloured light in three
   planes is three vectors); _n_rgb [count][bands^2][3], red, green and blue of each coefficient side by side; _soa
   coefficient i of vector k at [i*stride + k], stride >= count. Cost: prt_sh_rotation_count multiply-adds a vector
   (three times that for _n_rgb), done in SIMD across vectors; _soa, which transposes nothing, does 0.65 to 0.8 of the
   multiply-adds that the machine can. At 4 bands arrays beyond the caches are turned at 0.7 of the rate of memcpy and
   more, SSE2 at 0.4 (_n_rgb), 0.6 (_soa) and 0.7 (_n): docs/rotation.md. */
PRTDEF prt_result prt_sh_rotate_by_n(int bands, const prt_real *blocks, int count, const prt_real *f, prt_real *out);
PRTDEF prt_result prt_sh_rotate_by_n_rgb(int bands, const prt_real *blocks, int count, const prt_real *f,
                                         prt_real *out);
PRTDEF prt_result prt_sh_rotate_by_soa(int bands, const prt_real *blocks, int count, const prt_real *f, prt_real *out,
                                       size_t stride);

/* f turned by one rotation: out = M(R) f, without a matrix for any band above 2. To 3 bands (4 in SIMD) from the
   entries of R alone: band 2 as R A R^T of a symmetric matrix A, band 3 as a symmetric tensor. Above as Z(a) S Z(-b) S
   Z(g) with R = Rz(a) Ry(b) Rz(g), turns about z and the constant sparse swap S of y and z [Pinchon 2007]: cosines and
   sines are quotients of entries of R, good at the poles too, and no angle is computed. Reflections go by M(-R) =
   (-1)^l M(R). out may be f.
   Accuracy, float/double, tilts of 1e-7 from the poles included, for |f_i| <= 1: 2e-6/4e-15 to 8 bands, 3e-7/8e-16 a
   band above; 1000 turns by 2 pi/1000 about x, y or z at 6 bands come back within 1.2e-4 in float, which is the
   rounding of R and of the constants taken 1000 times. Cost: 9 55 122 224 358 528 738 multiplications and about 0.6
   times as many additions for 2 to 8 bands, most of them four at a time, one root, two divisions; 0.4 to 0.85 times
   the time of DirectXMath's XMSHRotate at 3 to 6 bands. Above 8 bands the swap is computed on the way, in double, about
   16 l^2 operations a band without a root or division: 0.22, 1.5 and 41 us at 9, 16 and 64 bands (AVX-512; 0.35, 3.3
   and 167 us with SSE2), a seventh of what building the blocks takes. */
PRTDEF prt_result prt_sh_rotate     (int bands, const prt_real rotation[9], const prt_real *f, prt_real *out);

/* The same about z by an angle in radians (finite, else PRT_ERR_VALUE), from +x towards +y. out may be f.
   Accuracy: 2 ulp of the largest coefficient. Cost: 2 n^2 multiply-adds, one sine, one cosine. */
PRTDEF prt_result prt_sh_rotate_z   (int bands, prt_real angle, const prt_real *f, prt_real *out);

/* A function that is symmetric about +z, given by its m = 0 coefficients zonal[bands], turned to the given axis:
   out = sqrt(4 pi/(2l+1)) zonal_l Y(l,m)(axis) [Sloan 2005]. The axis is finite and of length 1 within 1e-3 (else
   PRT_ERR_VALUE), then normalised. out must not overlap zonal. Accuracy and cost: of prt_sh_eval, and n^2 products. */
PRTDEF prt_result prt_sh_zonal_to   (int bands, const prt_real *zonal, prt_vec3 axis, prt_real *out);

/* ----------------------------------------------------------------------------------------------- >>product ---- */

/* The triple product (real Gaunt) coefficient  G = int Y(l1,m1) Y(l2,m2) Y(l3,m3) dw.
   0 unless l1+l2+l3 is even, the l satisfy the triangle inequality, the number of negative m is even, and one |m| is
   the sum of the other two; 0 also where l < 0 or |m| > l. The l are not bounded by PRT_MAX_BANDS.
   Method: G = (azimuthal factor) sqrt((2 l1+1)(2 l2+1)/(4 pi)) C(l1 0 l2 0; l3 0) C(l1 a l2 b; l3 a+b), the
   Clebsch-Gordan coefficients C(a) by their three-term recurrence in a, run from both ends towards the first maximum
   [Schulten 1975], in double-double arithmetic.
   Accuracy: the nearest double, but for about one value in 10^14 next to a tie or to an accidental zero (where the
   error stays below 1e-28 of the neighbouring coefficients); tests compare it with exact rational arithmetic to l =
   150. Cost: O(l1 + l2 + l3) operations, about 10 microseconds at l = 20; for tables and tests, not for inner loops. */
PRTDEF double prt_sh_triple(int l1, int m1, int l2, int m2, int l3, int m3);

/* Products of SH functions, truncated to the bands of the factors:  (f g)_k = sum of G_ijk f_i g_j, with the triple
   product coefficients G of prt_sh_triple. The product of n and n bands has 2n-1; what truncation drops makes it non-associative.

   out = f g. f, g, out: n^2 values; out may alias f, g or both.
   Method: generated kernels. At 1 and 2 bands (3 and 4 too in batches) of the sum, coefficients of +-m taken as complex
   numbers, pairs grouped, linear forms shared: 2 15 97 364 multiplications. At 3 to 6 bands by way of the Fourier series
   on ceil((3n-2)/2) circles of latitude, at Gauss-Legendre nodes, a circle in each lane of a vector (docs/math.md).
   Above, evaluation on a grid that is exact for the product, the same circles by 4 ceil((3n-2)/4) azimuths, mirror
   symmetries used [Driscoll 1994]: about 10 n^3 multiply-adds instead of the 0.4 n^5 terms of the sum.
   Cost with AVX-512, Zen 5: 12, 19, 34, 48 ns at 3, 4, 5, 6 bands, 1.0 us at 10, 2.4 us at 16, 0.25 ms at 64 (where
   nodes and sines are computed each time: above 16 bands). bench/ times it beside other libraries.
   Accuracy: to 16 bands within 3e-7 |f| |g| in float, 1e-15 in double (2-norms; measured 1.3e-7 and 2.4e-16,
   tests/test_product.c). Stack: at most 80 KB, in double 120 KB, for 64 bands.
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL. Values are not checked; a NaN reaches every coefficient, or, in the kernels,
   those that its coefficient has a part in. */
PRTDEF prt_result prt_sh_product(int bands, const prt_real *f, const prt_real *g, prt_real *out);

/* out = f f: as prt_sh_product(bands, f, f, out) but for rounding, at 0.6 to 0.9 of its cost. out may alias f. */
PRTDEF prt_result prt_sh_square(int bands, const prt_real *f, prt_real *out);

/* Many products, a vector of them at once: coefficient i of pair k at f[i*stride+k], g[i*stride+k], out[i*stride+k].
   stride >= count >= 0, else PRT_ERR_COUNT; pointers may be NULL if count is 0. out may be f, g or both (the same
   pointer). Each pair gets the same bits whatever count and place it comes in; they may differ from prt_sh_product's in
   the last places. Cost per pair with AVX-512: 0.8, 4.2, 15, 34 ns at 3, 4, 5, 6 bands, 0.27 us at 10.
   Above 16 bands pair after pair, as prt_sh_product. Stack: to 110 KB. */
PRTDEF prt_result prt_sh_product_soa(int bands, int count, const prt_real *f, const prt_real *g, prt_real *out,
                                     size_t stride);

/* out = f times a function about +z: zonal[n], its m=0 coefficients, as for prt_sh_convolve. No azimuth takes part:
   about 3 n^3 multiply-adds. out may alias f. (About another axis: turn f, multiply, turn back.) */
PRTDEF prt_result prt_sh_product_zonal(int bands, const prt_real *f, const prt_real *zonal, prt_real *out);

/* The matrix of multiplication by a fixed filter: matrix[n^2][n^2], symmetric, matrix f = filter times f truncated to n
   bands. Worth its n^2 products when many functions meet one filter: the planes of a coloured light, the lights of a
   hierarchy's node. For a mask with a window on the filter alone, apply prt_sh_window to the filter first. */
PRTDEF prt_result prt_sh_product_matrix(int bands, const prt_real *filter, prt_real *matrix);

/* out = matrix f, for one function or for count of them ([count][n^2]). out may not overlap the inputs. count >= 0,
   else PRT_ERR_COUNT. Cost: n^4 multiply-adds a function, at full vector width. Each is the same bits alone or among
   many. */
PRTDEF prt_result prt_sh_product_by  (int bands, const prt_real *matrix, const prt_real *f, prt_real *out);
PRTDEF prt_result prt_sh_product_by_n(int bands, const prt_real *matrix, int count, const prt_real *f, prt_real *out);

/* Masks: light times a filter (a visibility in [0,1]) with a window of width `bands` against ringing.
   prt_sh_mask windows both factors, sum of G_ijk w(l_i) light_i w(l_j) filter_j: the masking product of hierarchical
   PRT ([Chapter 2010], 5.1.7, with Hann; its text puts the window on the index of the coefficient, which would
   oscillate within a band: here it acts on the band). Chains of such masks fade: a filter that hides nothing still
   smooths the light. prt_sh_mask_filter windows the filter alone: a filter of 1 then leaves the light as it is. With
   PRT_WINDOW_POSITIVE a filter in [0,1] stays in [0,1], and since truncation is a projection |out| <= |light|
   (2-norms): no chain of masks can grow. NONE and HANN can; docs/masks.md shows which chains fade, hold or blow up.
   Cost: prt_sh_product, n window weights and n^2 multiplies a windowed factor. Stack: 33 KB, in double 66 KB, more.
   out may alias light, filter or both. Errors: PRT_ERR_BANDS, PRT_ERR_NULL, PRT_ERR_VALUE for an unknown window. */
PRTDEF prt_result prt_sh_mask       (int bands, prt_window w, const prt_real *light, const prt_real *filter,
                                     prt_real *out);
PRTDEF prt_result prt_sh_mask_filter(int bands, prt_window w, const prt_real *light, const prt_real *filter,
                                     prt_real *out);

/* Logarithm and exponential in the algebra of truncated products [Ren 2006]: the visibility of many blockers is
   exp*(sum of log*(v_b)), one exponential for all, where a chain of masks takes a product for each. With M_f the
   operator "multiply by f, truncate to n bands", a function F of f is F(M_f) 1: F of a symmetric matrix, applied to the
   constant 1. docs/masks.md compares all of this with chains of masks, in accuracy and time, for 1 to 64 blockers: the
   error is that of a chain of plain products, the time, from about four blockers on, a fraction.

   prt_sh_exp: the mean is split off (a factor), the rest halved h times until its norm is at most 1, exponentiated by a
   series of degree 4 and squared h times. Products: 3, and h squares, h = log2 of the norm of f without its mean.
   Error of the series and the squarings: docs/masks.md; truncation of f to n bands costs more. out may alias f.
   Values are not checked; what is not finite makes every coefficient NaN. */
PRTDEF prt_result prt_sh_exp(int bands, const prt_real *f, prt_real *out);

/* exp* without a product, for a log visibility f (0 where nothing blocks, negative elsewhere): the linear function of f
   that is right at 0 and at v = |f|^2 / <f,1>, the one value that a blocker with this mean and norm would have:
     out = 1 + (e^v - 1)/v f.   Where the mean of f is not negative: 1 + f.
   The "optimal linear" of [Ren 2006] in closed form; they tabulate its two factors by the norm of f. Good for few or
   small blockers: error .01 to .06 of full sight for up to 4, .2 to .3 for 64 (docs/masks.md). Cost: 2 n^2
   multiply-adds. out may alias f. */
PRTDEF prt_result prt_sh_exp_linear(int bands, const prt_real *f, prt_real *out);

/* log* of a visibility; values below least (0.02, say: log 0 is not finite) count as least, of 1 and above as they are.
   Lanczos' recurrence from the constant 1: M_f in the Krylov space of 1, f, f f, ..., f^(steps-1), its eigenvalues'
   logarithms. steps      1 ... PRT_KRYLOV_MAX, else PRT_ERR_COUNT; the error falls with it until it is that of least
   Cost: steps-1 products, 4 steps^2 n^2 multiply-adds, eigenvalues of a matrix of steps: about 10 us at 6 bands and 12
   steps. For blockers like caps, make it once for each size, keep the zonal coefficients, and turn them with
   prt_sh_zonal_to. out may alias f. Errors, in this order: PRT_ERR_BANDS, PRT_ERR_COUNT, PRT_ERR_NULL, PRT_ERR_VALUE
   unless 0 < least < infinity. A value of f that is not finite makes every coefficient NaN. */
#define PRT_KRYLOV_MAX 12
PRTDEF prt_result prt_sh_log(int bands, int steps, prt_real least, const prt_real *f, prt_real *out);

#ifndef PRT_NO_CH
/* ---------------------------------------------------------------------------------------------------- >>ch ---- */

/* Cpherical harmonics [Sherif 2013, chapter 6]: SH with Chebyshev polynomials in the place of Legendre's,
     C(l,m) = A(l,m) (1-z^2)^(m/2) d^m T_l(z)/dz^m {1, cos(m phi), sin(|m| phi)},  of unit norm, laid out as SH.
   n bands of C span exactly the functions that n bands of Y span, but C is NOT ORTHOGONAL: int C(0,0) C(2,0) = -0.488. A
   vector here holds coefficients, f = sum_i a_i C_i; the inner products int f C_i are its *moments*, other numbers, and
   SH's matrices do not turn it. The thesis uses moments as coefficients, a dot product as integral, and SH's rotations:
   docs/papers.md has what that costs. With C = S Y (S lower triangular for each m, unit rows, Gram matrix S S^T):
     a = S^-T f_SH,   moments = S f_SH,   int f g = a_f . moments_g,   rotation a' = S^-T R S^T a.
   S is made row by row in double where it is needed, about n^3/12 square roots and divisions a conversion, no table. */

/* A(l,m), with sqrt 2 folded in for m != 0 as in the thesis' table; the sign of m does not matter. 0 unless
   |m| <= l < 65536. Closed form for every l and m, an open point of the thesis: A = K(l,m) / (t(l,0) sqrt H(l,m)), where t and H are the
   expansion of T_l in Legendre polynomials. Relative error 2.3e-16 to l = 64 (tests/test_ch.c); underflows to 0 from
   about l = m = 150. Cost: O(l) multiplications and divisions. */
PRTDEF double prt_ch_norm(int l, int m);

/* The basis at one direction, at count of them, and with coefficient i of direction k at out[i*stride+k]: as
   prt_sh_eval, prt_sh_eval_n and prt_sh_eval_soa in shapes, errors, cost and determinism. Straight-line kernels to 10
   bands with the same operation counts as SH's; above, the recurrence
     C(l) = a z C(l-1) - c C(l-2),   a = a_SH sqrt(H(l-1,m)/H(l,m)),   c = a(l) a(l-1) (l+m-2)(l-1-m) / (4(l-2)(l-1)),
   from C(m,m) = Y(m,m), with a and c from tables to 64 bands; beyond, O(l) for each. Time: SH's within 5 % to 10 bands.
   Above, one direction at a time takes 0.75 to 0.82 of SH's time, since SH makes its factors from roots; _soa the same
   as SH with SSE2, and up to 1.15 of it with AVX-512, which waits for the table (bench jobs ch_eval, ch_eval_soa).
   Absolute error float/double, with that of the direction's length: 1.7e-6/4e-15 to 10 bands, 3.3e-6/6e-15 to 14, 1.7e-5/4e-14 to 33, 8e-5/2e-13 to 64
   (tests/test_ch.c). */
PRTDEF prt_result prt_ch_eval    (int bands, prt_vec3 dir, prt_real *c);
PRTDEF prt_result prt_ch_eval_n  (int bands, int count, const prt_vec3 *dirs, prt_real *c);
PRTDEF prt_result prt_ch_eval_soa(int bands, int count, const prt_real *x, const prt_real *y, const prt_real *z,
                                  prt_real *out, size_t stride);
/* sum_i f_i C_i(dir); 0 for bad arguments. Cost: prt_ch_eval and bands^2 multiply-adds. */
PRTDEF prt_real   prt_ch_at      (int bands, const prt_real *f, prt_vec3 dir);

/* The same function in the other basis, and moments to and from coefficients; bands^2 numbers each, out may alias in.
   Well conditioned: the Gram matrix has condition 0.87 bands. Error, of the norm, 6e-8 float, 2e-16 double at 16 bands.
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL. Cost: bands^3/6 multiply-adds and the rows of S (3.4 us at 16 bands on a Zen 5
   core at 4.1 GHz, bench job ch_from_sh); from and to moments, twice. */
PRTDEF prt_result prt_ch_from_sh     (int bands, const prt_real *sh, prt_real *ch);       /* a = S^-T f */
PRTDEF prt_result prt_sh_from_ch     (int bands, const prt_real *ch, prt_real *sh);       /* f = S^T a */
PRTDEF prt_result prt_ch_from_moments(int bands, const prt_real *moments, prt_real *ch);  /* a = S^-T S^-1 moments */
PRTDEF prt_result prt_ch_to_moments  (int bands, const prt_real *ch, prt_real *moments);  /* moments = S S^T a */

/* int f g over the sphere, by the Gram matrix; 0 for bad arguments. Cost: two conversions. */
PRTDEF prt_real   prt_ch_dot(int bands, const prt_real *f, const prt_real *g);

/* The turned function, f'(R v) = f(v), by way of SH and with the accuracy of prt_sh_rotate; out may alias f. Errors:
   PRT_ERR_BANDS, PRT_ERR_NULL, PRT_ERR_ROTATION. Cost: two conversions beside prt_sh_rotate. Stack: 2 PRT_MAX_BANDS^2
   prt_reals. */
PRTDEF prt_result prt_ch_rotate(int bands, const prt_real rotation[9], const prt_real *f, prt_real *out);

/* The projection of f g to the same bands, by way of SH and with the accuracy of prt_sh_product; out may alias f and g.
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL. Cost: three conversions beside prt_sh_product. Stack: 3 PRT_MAX_BANDS^2
   prt_reals beside its own. */
PRTDEF prt_result prt_ch_product(int bands, const prt_real *f, const prt_real *g, prt_real *out);
#endif /* PRT_NO_CH */

/* ------------------------------------------------------------------------------------------------- >>shade ---- */

/* Exit radiance of a diffuse surface of albedo 1 from its transfer vector, out = sum of T_i L_i in each channel
   ([Sloan 2002], equation 8; multiply by the albedo yourself).
   transfer   n^2 values, T = (1/pi) int V max(0, N.w) Y(w) dw, from prt_bake_transfer
   light      three planes of n^2 values: radiance, as projected by the functions of >>project
   Errors: PRT_ERR_BANDS, PRT_ERR_NULL. Values are not checked. out may not overlap the inputs.
   Cost: 3 n^2 multiply-adds in one pass over the transfer; at 5 bands about 5 ns with AVX2 or AVX-512 (docs/speed.md).
   Accuracy: (n^2/8 + 4) eps sum of |T_i L_i|; each channel is bit-equal to prt_sh_dot. */
PRTDEF prt_result prt_shade_diffuse  (int bands, const prt_real *transfer, const prt_real *light, prt_rgb *out);

/* The same for many points under one light: transfer[count][n^2], out[count]; PRT_ERR_COUNT if count < 0; transfer and out
   may be NULL if it is 0. Each point is bit-equal to prt_shade_diffuse. */
PRTDEF prt_result prt_shade_diffuse_n(int bands, int count, const prt_real *transfer, const prt_real *light,
                                      prt_rgb *out);

/* --------------------------------------------------------------------------------------------------- >>fiv ---- */

/* Shadows of moving objects by fullsphere irradiance vectors [Michael 2010]. The vector of a part of the environment is
   FIV = int L(w) w dw over that part (equation 9), and N.FIV its irradiance on a surface of normal N wherever all of
   that part lies above the surface (equation 10). So what an occluder takes from a receiver is one vector a channel,
   whatever the receiver's normal: it is baked for places of the occluder around the receiver, by prt_bake_fiv_table,
   and looked up. Irradiance = total - what the occluders take (equation 11).
   Space: the environment is at infinity and fixed; occluders move without turning (prt_fiv_transfer lets them turn).
   Values are not checked and none makes a call crash, loop or read outside a table: shading returns numbers within
   0 ... total for every finite total, in every channel, whatever stands in table, positions and normals. */
typedef struct prt_fiv { prt_vec3 r, g, b; } prt_fiv;                  /* one vector a channel */

typedef struct prt_fiv_table {         /* one occluder's vectors on a grid of places as seen from the receiver */
    int theta_count, phi_count, rho_count;   /* theta_i = pi i/(theta_count-1), phi_j = 2 pi j/phi_count (wraps),
                                          rho[k]; each at least 1; one row stands for every theta */
    const prt_real *rho;               /* [rho_count] increasing distances from receiver to occluder centre */
    prt_real radius;                   /* bounding radius of the occluder; 0: it hides nothing */
    const prt_fiv *samples;            /* [rho_count][theta_count][phi_count] */
    const unsigned char *inside;       /* same shape, nonzero: a receiver there is inside the occluder; NULL: none */
} prt_fiv_table;

typedef struct prt_fiv_occluder { const prt_fiv_table *table; prt_vec3 position; } prt_fiv_occluder;

/* What one occluder hides from one receiver, however it was looked up: for prt_fiv_shade_vectors. */
typedef struct prt_fiv_hidden {
    prt_fiv  fiv;                      /* the vectors of what it hides */
    prt_vec3 to_centre;                /* from the receiver to the occluder's centre */
    prt_real radius;                   /* bounding radius; 0: it hides nothing */
} prt_fiv_hidden;

enum {
    PRT_FIV_PAPER_PARTIAL = 1,         /* occluders cut by the horizon: the paper's factor (d+R)/2R (4.3.1) */
    PRT_FIV_NO_OVERLAP = 2             /* what two occluders hide together counts twice */
};

/* fiv += radiance dw w in each channel (equation 9). dir: unit. NULL: nothing happens. */
PRTDEF void prt_fiv_add(prt_fiv *fiv, prt_vec3 dir, prt_rgb radiance_times_solid_angle);

/* N.FIV (equation 10): the irradiance of the part of the environment that FIV stands for, where that part lies above
   the surface; negative where it lies below. NULL: 0. Cost: 9 multiplications. */
PRTDEF prt_rgb prt_fiv_irradiance(const prt_fiv *fiv, prt_vec3 normal);

/* The vectors that the occluder hides when its centre is at from_receiver_to_centre (any finite length, in the unit of
   rho): trilinear in (theta, phi, rho) between the 8 samples around. phi wraps; nearer than rho[0] the vectors of
   rho[0] hold; beyond the last rho they fall off with the solid angle, (rho_last/rho)^2. Samples inside the occluder,
   and samples that are not finite, are left out and the other weights raised to 1; if all are inside, all count, and if
   none is finite the vectors are 0. At distance 0 the direction is taken for that of theta = phi = pi/2.
   Errors: PRT_ERR_NULL (table, its rho or samples, out); PRT_ERR_COUNT (a count of the table below 1).
   Accuracy: 100 eps of the largest sample around (tests/test_fiv.c), beside what interpolation costs
   (prt_fiv_distances). Cost: reads 8 samples, 288 bytes in float; 80 ns on Zen 5, five times less in a batch. */
PRTDEF prt_result prt_fiv_lookup(const prt_fiv_table *table, prt_vec3 from_receiver_to_centre, prt_fiv *out);

/* irradiance = total - what the occluders hide, at a receiver.
   total       irradiance of the whole environment on `normal` (prt_bake_fiv_total), >= 0; negative or NaN counts as 0
   normal      unit
   occluders   [count]; an occluder's own surface is no receiver of it: see prt_fiv_self
   flags       0, or PRT_FIV_...
   An occluder whose centre is d = N.(centre - position) above the receiver's plane, of radius R, at distance r, hides
     d >= R     I = N.FIV
     d <= -R    nothing
     between    I = max(0, N.FIV + |FIV| s (g(u) - u)),  s = min(1, R/r), u = N.to_centre/(r s) in [-1,1],
                g(u) = (u acos(-u) + sqrt(1-u^2) (2+u^2)/3)/pi
                what a cap of uniform radiance cut by the horizon takes, within .0005, .008, .067 of the uncut cap for
                half-angles .2, .5, 1 (tests/test_fiv.c). The paper's (d+R)/2R scales N.FIV, which is too small already.
   Overlap (equations 13, 14): with discs of radius r_i = 2 sin(a_i/2), sin(a_i) = s_i, whose centres are the chord
   apart, each pair takes back lens/(area 1 + area 2) (I_1 + I_2), at most the smaller of the two. The sum then is kept
   between the largest I and the total. With 0 occluders irradiance = total.
   Errors: PRT_ERR_COUNT (count < 0, a count of a table below 1); PRT_ERR_NULL (irradiance; occluders with count > 0; a
   table, its rho or samples). Nothing is written then.
   Cost: a lookup an occluder that is not below the horizon, and about 60 operations a pair of discs that overlap. One
   receiver: 0.12 to 0.16 us an occluder (float, Zen 5), with or without SIMD. Stack: 5 to 19 KiB by vector width. */
PRTDEF prt_result prt_fiv_shade(prt_rgb total, prt_vec3 position, prt_vec3 normal, int count,
                                const prt_fiv_occluder *occluders, unsigned flags, prt_rgb *irradiance);

/* The same for many receivers: totals, positions, normals and irradiance have receiver_count entries. Each receiver
   gets the same bits as from prt_fiv_shade, whatever the count and its place. irradiance may be totals. Errors: as
   prt_fiv_shade, and PRT_ERR_COUNT (receiver_count < 0), PRT_ERR_NULL (an array with receiver_count > 0).
   Cost a receiver and occluder, float, AVX-512, Zen 5, a table of 2.3 MB: 25 ns without overlaps, of which 10 go to
   reading the samples; with them 34 ns among 10 occluders close to each other, 83 among 60 (bench, rows fiv). */
PRTDEF prt_result prt_fiv_shade_n(int receiver_count, const prt_rgb *totals, const prt_vec3 *positions,
                                  const prt_vec3 *normals, int count, const prt_fiv_occluder *occluders, unsigned flags,
                                  prt_rgb *irradiance);

/* The same from vectors that you looked up yourself: occluders from tables of different kinds, or of your own.
   Errors: PRT_ERR_COUNT, PRT_ERR_NULL. */
PRTDEF prt_result prt_fiv_shade_vectors(prt_rgb total, prt_vec3 normal, int count, const prt_fiv_hidden *hidden,
                                        unsigned flags, prt_rgb *irradiance);

/* Self-shadow (4.3.2): irradiance at a point of an object's own surface, max(0, N.(FIV_environment - FIV_object)) in
   each channel, the object as seen from local_position (relative to its centre). What the object leaves open lies above
   its surface, so that here nothing needs a horizon.
   environment   vectors of the whole environment (prt_bake_fiv_environment)
   self          the object's table, with `inside` marked
   Errors: PRT_ERR_NULL, PRT_ERR_COUNT (as prt_fiv_lookup). */
PRTDEF prt_result prt_fiv_self(const prt_fiv *environment, const prt_fiv_table *self, prt_vec3 local_position,
                               prt_vec3 normal, prt_rgb *irradiance);

/* The table for any SH light, moving or turned, and for occluders that turn: per sample, in the occluder's own frame,
   the projection V_j = int over what it hides of Y_j dw, to one band more than the light has. For a light of `bands`
   bands the vector int_hidden w L dw is linear in V: each component of w raises the light by one band, so that it is
   the dot product of V with the product w_k L. The 3 bands^2 numbers int_hidden w_k Y_i dw that the method asks for are
   linear functions of these (bands+1)^2 (25 for 48 at 4 bands). Filled by prt_bake_fiv_transfer. */
typedef struct prt_fiv_transfer {
    int bands;                         /* of the light: 1 ... PRT_MAX_BANDS - 1 */
    int theta_count, phi_count, rho_count;   /* these and the next two as in prt_fiv_table */
    const prt_real *rho;
    prt_real radius;
    const prt_real *samples;           /* [rho_count][theta_count][phi_count][(bands+1)^2] */
    const unsigned char *inside;
} prt_fiv_transfer;

/* What a light is to an occluder: vectors[9][(bands+1)^2], the products of its channels, red first, with the three
   components of the direction in world space, as functions in the occluder's frame. Once for each light and
   orientation.
   rotation   from the occluder's frame to the world; NULL: none
   light      three planes of bands^2
   Errors: PRT_ERR_BANDS (bands outside 1 ... PRT_MAX_BANDS - 1), PRT_ERR_NULL, PRT_ERR_ROTATION. Cost: nine products of
   bands+1 bands, and three rotations. */
PRTDEF prt_result prt_fiv_transfer_light(int bands, const prt_real rotation[9], const prt_real *light,
                                         prt_real *vectors);

/* prt_fiv_lookup for a transfer table, in world space: rotation and vectors as above. Errors: as prt_fiv_lookup, and
   PRT_ERR_BANDS. Cost: 17 (bands+1)^2 multiply-adds; 0.15 us at 4 bands, twice prt_fiv_lookup. */
PRTDEF prt_result prt_fiv_transfer_lookup(const prt_fiv_transfer *table, const prt_real rotation[9],
                                          const prt_real *vectors, prt_vec3 from_receiver_to_centre, prt_fiv *out);

/* Samples first ... first+count-1 of the prt_fiv_table that belongs to a light, from vectors made with rotation NULL:
   what prt_bake_fiv_table would find, without a ray. Errors: PRT_ERR_BANDS, PRT_ERR_COUNT, PRT_ERR_NULL.
   Cost: 9 (bands+1)^2 multiply-adds a sample. */
PRTDEF prt_result prt_fiv_transfer_samples(const prt_fiv_transfer *table, const prt_real *vectors, int first, int count,
                                           prt_fiv *samples);

/* Tables in half or a quarter of the memory. 16 bits: IEEE half floats, error 2^-11 of each value. 8 bits: for each
   distance and component a byte between the least and the largest value, low + step byte, error step/2. Errors of
   shadows: docs/fiv.md. */
typedef struct prt_fiv_packed {
    prt_fiv_table grid;                /* counts, rho, radius and inside; samples is not read */
    int bits;                          /* 16 or 8 */
    const void *data;                  /* [rho_count][theta_count][phi_count][9] uint16_t or unsigned char, red first */
    const prt_fiv *low, *step;         /* [rho_count], for 8 bits */
} prt_fiv_packed;

/* Bytes of data for a table at 16 or 8 bits, 0 for a bad argument or if a size_t does not hold it. */
PRTDEF size_t prt_fiv_packed_size(const prt_fiv_table *table, int bits);

/* Packs table->samples into data, and for 8 bits into low and step [rho_count] (NULL for 16), and describes them in
   *packed. Errors: PRT_ERR_COUNT (counts, bits), PRT_ERR_NULL, PRT_ERR_VALUE (a sample not finite, or for 16 bits
   beyond 65504: scale the light). Cost: two passes over the table. */
PRTDEF prt_result prt_fiv_pack(const prt_fiv_table *table, int bits, void *data, prt_fiv *low, prt_fiv *step,
                               prt_fiv_packed *packed);

/* prt_fiv_lookup from a packed table: use it with prt_fiv_shade_vectors. Errors: as prt_fiv_lookup (data; low and step
   for 8 bits), PRT_ERR_COUNT for other bits. Cost: reads 144 or 72 bytes. */
PRTDEF prt_result prt_fiv_packed_lookup(const prt_fiv_packed *packed, prt_vec3 from_receiver_to_centre, prt_fiv *out);

/* Samples first ... first+count-1 of a packed table. Errors: PRT_ERR_COUNT, PRT_ERR_NULL. */
PRTDEF prt_result prt_fiv_unpack(const prt_fiv_packed *packed, int first, int count, prt_fiv *samples);

/* The irradiance of the whole environment on `normal` from the cube texture that prt_bake_fiv_total writes,
   total[6][size][size], bilinear between texel centres, and beyond the outermost ones extended in a straight line, so
   that edges and corners are as good as the rest. Error: curvature of I_tot times (2/size)^2/8. size < 1 or NULL: 0. */
PRTDEF prt_rgb prt_fiv_total(int size, const prt_rgb *total, prt_vec3 normal);

/* ---------------------------------------------------------------------------------------------------- >>vo ---- */

/* Vector occluders [Sherif 2013, chapter 7]: shadows, caustics and interreflections of point lights, from a few vectors
   for each occluder that a point sees. An empirical model, as Phong's: plausible, fast, and not a solution of the rendering
   equation; docs/papers.md lists what the thesis leaves open and how it is decided here. prt_bake_vo (prt_bake.h) fills
   prt_vo_occluder.

   With x the point, N its normal, l and l_P the unit directions to a light from x and from the occluder's position P, v the
   direction from x to P, i the one from the eye to x, reflect(a, n) = a - 2 (n.a) n, r = reflect(i, N), and
   n_S = specular_normal/|specular_normal|, a light of colour c sends
     direct   c (diffuse max(0, N.l) + specular max(0, r.l)^shininess) times, for every occluder,
              (1 - T) block + T focus,  T = transmissive                                              (7.2, 7.3)
              block = s2(occlusion, l)^(N_sh form_factor)               under PRT_VO_SINE, or PRT_VO_CAP, see below
              focus = max(s2(caustic, l), sin^2 c0)^(-N_c caustic_factor)
              s2(d, l) = 1 if d.l <= 0, else sin^2 of the angle between d and l
     DD       c dd o.diffuse diffuse max(0, diffuse_normal.l_P)                     diffuse from diffuse
     DS       c ds o.specular diffuse |specular_normal| max(0, reflect(v, n_S).l_P)^gloss
     SS       c ss o.specular specular |specular_normal| max(0, r.v) max(0, reflect(r, n_S).l_P)^gloss, where N.v > 0
   out = max(0, emissive + the sum over lights and occluders). No 1/pi and no falloff with distance: `color` is what arrives.
   A zero vector, a factor F <= 0 and an exponent <= 0 give a power of 1; a light on x or on P has no direction from there,
   so dot products with it are 0.
   Bounded: every finite input gives a finite result; what overflows is clamped to the largest finite number. Continuous in
   the place of every light (but where it meets x or P, where a direction has no limit), in the eye, and in every vector of
   an occluder that is not zero, except that SS begins abruptly at N.v = 0, where no baked occluder stands.
   occlusion, caustic and specular_normal may have any length but zero; normals of points should be unit. */
typedef struct prt_vo_occluder {       /* the thesis' eight vectors, with the two form factors beside them (7.2) */
    prt_vec3 position;                 /* mean visible position */
    prt_vec3 occlusion;                /* unit mean direction, zero: none */
    prt_vec3 caustic;                  /* unit mean direction after refraction, zero: none */
    prt_rgb  transmissive;             /* 0 opaque ... 1 clear */
    prt_vec3 diffuse_normal;           /* length: form factor x ambient occlusion at the hits */
    prt_vec3 specular_normal;          /* length: form factor of the hits whose mirror direction is open */
    prt_rgb  diffuse, specular;
    prt_real form_factor, caustic_factor;
} prt_vo_occluder;
typedef struct prt_vo_point { prt_vec3 position, normal; prt_rgb diffuse, specular, emissive; prt_real shininess; } prt_vo_point;
typedef struct prt_point_light { prt_vec3 position; prt_rgb color; } prt_point_light;

enum { PRT_VO_NO_SHADOW = 1, PRT_VO_NO_CAUSTIC = 2, PRT_VO_NO_DD = 4, PRT_VO_NO_DS = 8, PRT_VO_NO_SS = 16 };

typedef enum prt_vo_law {
    PRT_VO_SINE = 0,                   /* block = s2^(N_sh F) [Sherif 2013, equation 7.2]: an occluder hides a light on its
                                          axis fully, however small it is, and one at 90 degrees never */
    PRT_VO_CAP                         /* block = 1 - the share of the light's disc, of radius light_angle, behind a round
                                          cap about `occlusion` that has the occluder's form factor: sin^2 a =
                                          F/max(N.occlusion, F). The share within 0.023 (see [Oat 2007]) */
} prt_vo_law;

typedef struct prt_vo_params {         /* zero-initialise; 0 means the default in brackets */
    prt_real shadow_strength;          /* N_sh [1.5]; PRT_VO_CAP does not read it */
    prt_real caustic_strength;         /* N_c [0.5] */
    prt_real caustic_angle;            /* c0, radians [1 degree] */
    prt_real gloss;                    /* exponent of the DS and SS terms [8] */
    prt_real dd, ds, ss;               /* weights of the three interreflections [1]; negative dd drains colour */
    unsigned off;                      /* PRT_VO_NO_SHADOW | ...: terms to leave out; block or focus is then 1 */
    int law;                           /* prt_vo_law; anything else counts as PRT_VO_SINE */
    prt_real light_angle;              /* radians; half the angle under which PRT_VO_CAP sees a light [5 degrees] */
} prt_vo_params;

/* Exit radiance towards the eye at one point, see above.
   Errors: PRT_ERR_COUNT (a count below 0); PRT_ERR_NULL. Values are not checked. out may not overlap the inputs.
   Cost: for each light and occluder 30 operations and a power for block, the same for focus, 40 for DD, 15 and a power each
   for DS and SS, where not off; a gloss that is an integer up to 64 needs products alone. About 45 ns an occluder and light.
   Accuracy: 32 eps of the sum of |terms|, the direct one times (1 + sum of |its change for a turn of the directions by 1
   radian|), for exponents to 13 (tests/test_vo.c). */
PRTDEF prt_result prt_vo_shade(const prt_vo_params *params, const prt_vo_point *point, prt_vec3 eye,
                               int occluder_count, const prt_vo_occluder *occluders,
                               int light_count, const prt_point_light *lights, prt_rgb *out);

/* The same for many points, out[count]. Point k sees occluders[first[k]] ... occluders[first[k+1] - 1]:
   first[count + 1], first[0] >= 0, not decreasing (PRT_ERR_COUNT). Each point is the same bits whatever count and place;
   it differs from prt_vo_shade by rounding, and counts directions shorter than 5e-19 (float) as none.
   Errors: PRT_ERR_COUNT, PRT_ERR_NULL. Cost: at 8 lights and 5 opaque occluders 80 ns a point for DD with AVX-512, 1.9 times
   what its arithmetic takes at the peak rate and a 24th of the loop over points; 250 ns, a ninth, with SSE2 (bench rows
   vo_dd, vo_all; Zen 5, gcc -O3). Packed: the same. Accuracy: 64 eps as above. */
PRTDEF prt_result prt_vo_shade_n(const prt_vo_params *params, int count, const prt_vo_point *points, prt_vec3 eye,
                                 const int *first, const prt_vo_occluder *occluders,
                                 int light_count, const prt_point_light *lights, prt_rgb *out);

/* Packed occluders: 40 bytes instead of 104 (float), or 20 where DS, SS and caustics are off. Words, from the lowest bit:
     0  half x, half y                           the position from the point, (P - x)/unit; as GLSL's unpackHalf2x16
     1  half z, half form_factor
     2  occlusion                                octahedral, 16 bits each; as GLSL's unpackSnorm2x16
     3  diffuse_normal, diffuse.r                octahedral, 12 bits each, 2048 + 2047 v; then 8 bits of the root of r
     4  half |diffuse_normal|, diffuse.g, diffuse.b
     5  caustic                                  as 2
     6  half caustic_factor, half |specular_normal|
     7  specular_normal, specular.r              as 3
     8  specular.g, specular.b, transmissive.r, transmissive.g
     9  transmissive.b
   Octahedral, of a unit vector v: (x, y)/(|x| + |y| + |z|), and below z = 0 (1 - |y|, 1 - |x|) with the signs of x and y
   [Cigolle 2014]. A colour is (byte/255)^2. Directions of which the factor is 0 come back as zero vectors.
   Errors: 2^-11 of each component of P - x, of factors and lengths; 0.004 degrees of occlusion and caustic, 0.06 of normals;
   (sqrt(c) + 1/1020)/255 of a colour c (tests/test_vo.c). */
typedef struct prt_vo_packed { uint32_t word[10]; } prt_vo_packed;
typedef struct prt_vo_packed_diffuse { uint32_t word[5]; } prt_vo_packed_diffuse;

/* Packs and unpacks the occluders of one point at `position`; unit > 0 is a length of the scene's size (its radius): distances
   from 6e-8 to 65504 units are held. out must not overlap the input.
   Errors: PRT_ERR_COUNT; PRT_ERR_NULL; PRT_ERR_VALUE, before anything is written: unit not positive and finite; packing:
   a number that is not finite, a colour outside 0 ... 1, a factor below 0 or above 65504, a distance above 65504 units.
   Cost: a packed occluder takes two passes of scalar code; unpacking is SIMD. */
PRTDEF prt_result prt_vo_pack          (prt_real unit, prt_vec3 position, int count, const prt_vo_occluder *occluders,
                                        prt_vo_packed *out);
PRTDEF prt_result prt_vo_pack_diffuse  (prt_real unit, prt_vec3 position, int count, const prt_vo_occluder *occluders,
                                        prt_vo_packed_diffuse *out);
PRTDEF prt_result prt_vo_unpack        (prt_real unit, prt_vec3 position, int count, const prt_vo_packed *packed,
                                        prt_vo_occluder *out);
PRTDEF prt_result prt_vo_unpack_diffuse(prt_real unit, prt_vec3 position, int count, const prt_vo_packed_diffuse *packed,
                                        prt_vo_occluder *out);

/* prt_vo_shade_n from packed occluders, as if they were unpacked first. The second form holds nothing for caustics, DS and
   SS: they are off whatever params says. Errors beside those of prt_vo_shade_n: PRT_ERR_VALUE (unit). */
PRTDEF prt_result prt_vo_shade_packed_n(const prt_vo_params *params, prt_real unit, int count, const prt_vo_point *points,
                                        prt_vec3 eye, const int *first, const prt_vo_packed *packed,
                                        int light_count, const prt_point_light *lights, prt_rgb *out);
PRTDEF prt_result prt_vo_shade_packed_diffuse_n(const prt_vo_params *params, prt_real unit, int count,
                                                const prt_vo_point *points, prt_vec3 eye, const int *first,
                                                const prt_vo_packed_diffuse *packed, int light_count,
                                                const prt_point_light *lights, prt_rgb *out);

/* One train of plane waves [Sherif 2013, 7.3.2 and the shader of A.2]. */
typedef struct prt_vo_wave {
    prt_vec3 along, across;            /* unit, at right angles: where it runs, and where it pushes to */
    prt_real amplitude, frequency;     /* frequency: radians in a unit of time, and a factor of the slope */
    prt_real phase;                    /* radians, added to along.position */
} prt_vo_wave;

/* Bends occlusion and caustic vectors as under moving water: for each wave in turn they are turned about cross(along,
   across) by atan(frequency amplitude cos(frequency time + along.position + phase)). Lengths stay, and so does all else.
   occluders[count] are those of the point at `position`; out[count] may be the same array.
   Errors: PRT_ERR_COUNT; PRT_ERR_NULL; PRT_ERR_VALUE (time, position or a wave not finite, an axis or the cross product of
   two that differs from length 1 by more than 1e-3), before anything is written. Occluders are not checked.
   Cost: a cosine, a root and 20 operations a wave, and 30 a wave and occluder. Error: 2 eps a wave. */
PRTDEF prt_result prt_vo_bend(int wave_count, const prt_vo_wave *waves, prt_real time, prt_vec3 position,
                              int count, const prt_vo_occluder *occluders, prt_vo_occluder *out);

/* --------------------------------------------------------------------------------------------- >>reference ---- */

/* Slow evaluators that share no code with the rooms above, for tests of this library and of yours. */

/* Y(l,m) by its definition in angles, K(l,m) P_l^|m|(cos theta) {1, sqrt2 cos(m phi), sqrt2 sin(|m| phi)} ([Sloan 2008],
   appendix A1, without the Condon-Shortley phase), in double whatever prt_real is. (x,y,z) is normalised first.
   0 <= l <= PRT_REFERENCE_MAX_L, where (2l)! still fits a double, and |m| <= l; otherwise, and for a zero vector, 0.
   Cost: O(l), with square roots and trigonometry. Accuracy: absolute error below 3e-13 (tests/test_sh.c). */
#define PRT_REFERENCE_MAX_L 80
PRTDEF double prt_reference_sh(int l, int m, double x, double y, double z);

/* out[n^2] = int f(w) Y_i(w) dw of any function, by the product of a Gauss-Legendre rule with `nodes` nodes in z and the
   trapezoidal rule with 2 `nodes` nodes in phi: exact (to rounding) if f has at most 2 nodes - bands bands, for instance a
   function of `bands` bands with nodes = bands. Sharp edges converge slowly: error about 1/nodes.
   f       called 2 nodes^2 times with unit directions, user passed through
   nodes   1 ... 4096, otherwise PRT_ERR_COUNT
   Errors: PRT_ERR_BANDS, _COUNT, _NULL (f or out). Cost: 2 nodes^2 (calls of f and n^2 fused multiply-adds).
   Sums are in double; the basis is prt_sh_eval's, and so is the accuracy. */
typedef double prt_function(void *user, prt_vec3 dir);
PRTDEF prt_result prt_reference_project(int bands, int nodes, prt_function *f, void *user, prt_real *out);

#ifdef __cplusplus
}
#endif
#endif /* PRT_H_INCLUDED */

/* ==================================================================================================================
   The interface ends here. Below stands the implementation, in the same order.
   ================================================================================================================== */

/* Private building blocks of both headers, all of them static: in each file that implements prt.h or prt_bake.h. */
#if (defined(PRT_IMPLEMENTATION) || defined(PRT_BAKE_IMPLEMENTATION)) && !defined(PRT__INTERNALS_INCLUDED)
#define PRT__INTERNALS_INCLUDED

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

/* Vector extensions of GCC and Clang, at the width that the target flags allow, where the machine has such registers. */
#if !defined(PRT_NO_SIMD) && defined(__GNUC__) && (defined(__SSE2__) || defined(__ARM_NEON) || \
    defined(__VSX__) || defined(__VX__) || defined(__wasm_simd128__)) && \
    (defined(PRT_DOUBLE) || !defined(__FLT_EVAL_METHOD__) || __FLT_EVAL_METHOD__ == 0) /* a float times a vector is one */
#  define PRT__SIMD 1
#  if defined(__AVX512F__)
#    define PRT__VEC_BYTES 64
#  elif defined(__AVX__)
#    define PRT__VEC_BYTES 32
#  else
#    define PRT__VEC_BYTES 16
#  endif
#  ifdef PRT_DOUBLE
#    define PRT__LANES (PRT__VEC_BYTES / 8)
#  else
#    define PRT__LANES (PRT__VEC_BYTES / 4)
#  endif
#else
#  define PRT__SIMD 0
#  define PRT__LANES 1
#endif

/* Before a loop of few steps, known when it is compiled: gcc -O2 would leave it rolled, and its arrays in memory. */
#if defined(__clang__)
#  define PRT__UNROLL _Pragma("unroll")
#elif defined(__GNUC__) && __GNUC__ >= 8
#  define PRT__UNROLL _Pragma("GCC unroll 16")
#else
#  define PRT__UNROLL
#endif

#if defined(__GNUC__)
#  define PRT__ALIGNED __attribute__((aligned(64)))               /* a table: to lines of the cache */
#else
#  define PRT__ALIGNED
#endif

#define PRT__PI 3.14159265358979323846264338327950288
#define PRT__SQRT2 1.41421356237309504880168872420969808
#define PRT__R(v) ((prt_real)(v))                          /* a double constant as a prt_real */

#ifdef PRT_DOUBLE
#  define PRT__EPS DBL_EPSILON
#  define PRT__REAL_MAX DBL_MAX
#  define PRT__REAL_MIN DBL_MIN
#  define PRT__REAL_MIN DBL_MIN
PRT__INLINE prt_real prt__sqrt(prt_real v) { return sqrt(v); }
PRT__INLINE prt_real prt__sign(prt_real v) { return copysign(1.0, v); }
#else
#  define PRT__EPS FLT_EPSILON
#  define PRT__REAL_MAX FLT_MAX
#  define PRT__REAL_MIN FLT_MIN
#  define PRT__REAL_MIN FLT_MIN
PRT__INLINE prt_real prt__sqrt(prt_real v) { return sqrtf(v); }
PRT__INLINE prt_real prt__sign(prt_real v) { return copysignf(1.0f, v); }
#endif

/* Finite, from the bits of the exponent: -ffast-math lets a compiler take any comparison with NaN as it likes. */
PRT__INLINE int prt__finite(prt_real v) {
#ifdef PRT_DOUBLE
    uint64_t bits, exponent = UINT64_C(0x7ff) << 52;
#else
    uint32_t bits, exponent = UINT32_C(0xff) << 23;
#endif
    memcpy(&bits, &v, sizeof bits);
    return (bits & exponent) != exponent;
}
PRT__INLINE int prt__finite3(prt_vec3 v) { return prt__finite(v.x) && prt__finite(v.y) && prt__finite(v.z); }
PRT__INLINE prt_real prt__dot3(prt_vec3 a, prt_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

PRT__INLINE prt_real prt__abs(prt_real v) { return v < 0 ? -v : v; }

PRT__INLINE int prt__rgb_within_1(prt_rgb c) {                 /* false for NaN */
    return c.r >= 0 && c.r <= 1 && c.g >= 0 && c.g <= 1 && c.b >= 0 && c.b <= 1;
}

PRT__INLINE int prt__bands_ok(int bands) { return bands >= 1 && bands <= PRT_MAX_BANDS; }

PRT__INLINE prt_vec3 prt__vec3(prt_real x, prt_real y, prt_real z) { prt_vec3 v; v.x = x; v.y = y; v.z = z; return v; }

/* Node i (in rising order) and weight of the Gauss-Legendre rule with n nodes on [-1,1], by Newton's method on P_n from
   Tricomi's estimate; both within a few ulp. Cost: O(n). */
PRT__STATIC void prt__gauss_legendre(int n, int i, double *node, double *weight) {
    double z = -(1 - (n - 1) / (8.0 * n * n * n)) * cos(PRT__PI * (4 * i + 3) / (4 * n + 2)), slope = 1;
    int step, k;
    for (step = 0; step < 8; step++) {
        double p = 1, before = 0, move;
        for (k = 1; k <= n; k++) { double next = ((2 * k - 1) * z * p - (k - 1) * before) / k; before = p; p = next; }
        slope = n * (before - z * p) / ((1 - z) * (1 + z));
        move = p / slope;
        z -= move;
        if (!(fabs(move) > 1e-15)) break;
    }
    *node = z;
    *weight = 2 / ((1 - z) * (1 + z) * slope * slope);
}

/* prt__vec: PRT__LANES values that are worked on at once; one plain value where there is no SIMD, so that a batched
   function is written once. A batch is bit-equal to its parts only if every item runs through the same vector code:
   the last, incomplete vector is padded (load_part, store_part), never done in scalars. */
#if PRT__SIMD
typedef prt_real prt__vec __attribute__((vector_size(PRT__VEC_BYTES)));
#else
typedef prt_real prt__vec;
#endif
PRT__INLINE prt__vec prt__vec_load(const prt_real *from) { prt__vec v; memcpy(&v, from, sizeof v); return v; }
PRT__INLINE void prt__vec_store(prt_real *to, prt__vec v) { memcpy(to, &v, sizeof v); }
PRT__INLINE prt__vec prt__vec_load_part(const prt_real *from, int lanes) {
    prt_real all[PRT__LANES] = { 0 };
    memcpy(all, from, (size_t)lanes * sizeof *from);
    return prt__vec_load(all);
}
PRT__INLINE void prt__vec_store_part(prt_real *to, prt__vec v, int lanes) {
    memcpy(to, &v, (size_t)lanes * sizeof *to);
}
PRT__INLINE prt__vec prt__vec_set(prt_real s) {                /* s in every lane; the subtraction keeps -0 */
#if PRT__SIMD
    prt__vec zero = { 0 };
    return s - zero;
#else
    return s;
#endif
}

/* a in the lanes where the comparison m holds, else b. */
#if PRT__SIMD
#  ifdef PRT_DOUBLE
typedef int64_t prt__chosen __attribute__((vector_size(PRT__VEC_BYTES)));
#  else
typedef int32_t prt__chosen __attribute__((vector_size(PRT__VEC_BYTES)));
#  endif
PRT__INLINE prt__vec prt__vec_select(prt__chosen m, prt__vec a, prt__vec b) {
    return (prt__vec)(((prt__chosen)a & m) | ((prt__chosen)b & ~m));
}
#else
#  ifdef PRT_DOUBLE
typedef int64_t prt__chosen;
#  else
typedef int32_t prt__chosen;
#  endif
PRT__INLINE prt__vec prt__vec_select(prt__chosen m, prt__vec a, prt__vec b) { return m ? a : b; }
#endif
#define PRT__SELECT(m, a, b) prt__vec_select((prt__chosen)(m), a, b)

/* Square root, of negative values and NaN 0. By an instruction where the loop below is slow: a compiler may not widen
   sqrt, which reports errors through errno, and <immintrin.h> would take longer to read than this header. */
PRT__INLINE prt__vec prt__vec_root(prt__vec v) {
    prt__vec zero = prt__vec_set(0);
    v = PRT__SELECT(v > zero, v, zero);
#if PRT__SIMD && defined(__SSE2__)
#  if defined(__AVX__) && defined(PRT_DOUBLE)
    __asm__("vsqrtpd %1, %0" : "=v"(v) : "v"(v));
#  elif defined(__AVX__)
    __asm__("vsqrtps %1, %0" : "=v"(v) : "v"(v));
#  elif defined(PRT_DOUBLE)
    __asm__("sqrtpd %1, %0" : "=x"(v) : "x"(v));
#  else
    __asm__("sqrtps %1, %0" : "=x"(v) : "x"(v));
#  endif
    return v;
#else
    {
        prt_real all[PRT__LANES];
        int k;
        prt__vec_store(all, v);
        for (k = 0; k < PRT__LANES; k++) all[k] = prt__sqrt(all[k]);
        return prt__vec_load(all);
    }
#endif
}

#ifdef __cplusplus
}
#endif
#endif /* PRT__INTERNALS_INCLUDED */

#if defined(PRT_IMPLEMENTATION) && !defined(PRT_IMPLEMENTATION_INCLUDED)
#define PRT_IMPLEMENTATION_INCLUDED

#ifdef __cplusplus
extern "C" {
#endif

/* Four values, for transposes and for sums across lanes */
#if PRT__SIMD
typedef prt_real prt__quad __attribute__((vector_size(4 * sizeof(prt_real))));
PRT__INLINE void prt__quad_transpose(prt__quad m[4]) {
#  if defined(__clang__) || __GNUC__ >= 12
    prt__quad low = __builtin_shufflevector(m[0], m[1], 0, 4, 1, 5), high = __builtin_shufflevector(m[0], m[1], 2, 6, 3, 7);
    prt__quad low2 = __builtin_shufflevector(m[2], m[3], 0, 4, 1, 5), high2 = __builtin_shufflevector(m[2], m[3], 2, 6, 3, 7);
    m[0] = __builtin_shufflevector(low, low2, 0, 1, 4, 5);
    m[1] = __builtin_shufflevector(low, low2, 2, 3, 6, 7);
    m[2] = __builtin_shufflevector(high, high2, 0, 1, 4, 5);
    m[3] = __builtin_shufflevector(high, high2, 2, 3, 6, 7);
#  else
    int i, j;
    for (i = 0; i < 4; i++)
        for (j = 0; j < i; j++) { prt_real t = m[i][j]; m[i][j] = m[j][i]; m[j][i] = t; }
#  endif
}
#endif

/* Whether quads fit registers, and the compiler has their shuffles */
#if PRT__SIMD && (defined(__clang__) || __GNUC__ >= 12)
#  ifdef PRT_DOUBLE
#    define PRT__QUADS (PRT__VEC_BYTES >= 32)
#  else
#    define PRT__QUADS 1
#  endif
#else
#  define PRT__QUADS 0
#endif
#if PRT__QUADS
PRT__INLINE prt__quad prt__quad_load(const prt_real *from) { prt__quad v; memcpy(&v, from, sizeof v); return v; }
PRT__INLINE void prt__quad_store(prt_real *to, prt__quad v) { memcpy(to, &v, sizeof v); }
#endif

/* ------------------------------------------------------------------------------------------------- >>types ---- */

PRTDEF const char *prt_result_string(prt_result r) {
#define PRT__RESULT_MESSAGE(name, message) message,
    static const char *const messages[] = { PRT_RESULTS(PRT__RESULT_MESSAGE) "unknown result" };
#undef PRT__RESULT_MESSAGE
    return messages[(unsigned)r < (unsigned)PRT__RESULT_COUNT ? (unsigned)r : (unsigned)PRT__RESULT_COUNT];
}

/* ---------------------------------------------------------------------------------------------------- >>sh ---- */

enum { PRT__SH_KERNELS = 10, PRT__ROOTS = 128 };               /* generated: straight-line kernels, table of sqrt(k) */

typedef void prt__sh_kernel(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out);
typedef void prt__sh_kernel_v(int vectors, const prt_real *x, const prt_real *y, const prt_real *z,
                              prt_real *PRT__RESTRICT out, size_t stride);
typedef void prt__sh_kernel_at(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out);
static prt__sh_kernel prt__sh_eval_1, prt__sh_eval_2, prt__sh_eval_3, prt__sh_eval_4, prt__sh_eval_5,
                      prt__sh_eval_6, prt__sh_eval_7, prt__sh_eval_8, prt__sh_eval_9, prt__sh_eval_10;
static prt__sh_kernel_v prt__sh_eval_1_v, prt__sh_eval_2_v, prt__sh_eval_3_v, prt__sh_eval_4_v, prt__sh_eval_5_v,
                        prt__sh_eval_6_v, prt__sh_eval_7_v, prt__sh_eval_8_v, prt__sh_eval_9_v, prt__sh_eval_10_v;
static prt__sh_kernel_at prt__sh_at_1, prt__sh_at_2, prt__sh_at_3, prt__sh_at_4, prt__sh_at_5,
                         prt__sh_at_6, prt__sh_at_7, prt__sh_at_8, prt__sh_at_9, prt__sh_at_10;
static const double *prt__roots(void), *prt__inverse_roots(void);

static prt__sh_kernel *const prt__sh_kernels[PRT__SH_KERNELS] = {
    prt__sh_eval_1, prt__sh_eval_2, prt__sh_eval_3, prt__sh_eval_4, prt__sh_eval_5,
    prt__sh_eval_6, prt__sh_eval_7, prt__sh_eval_8, prt__sh_eval_9, prt__sh_eval_10
};
static prt__sh_kernel_v *const prt__sh_kernels_v[PRT__SH_KERNELS] = {
    prt__sh_eval_1_v, prt__sh_eval_2_v, prt__sh_eval_3_v, prt__sh_eval_4_v, prt__sh_eval_5_v,
    prt__sh_eval_6_v, prt__sh_eval_7_v, prt__sh_eval_8_v, prt__sh_eval_9_v, prt__sh_eval_10_v
};
static prt__sh_kernel_at *const prt__sh_kernels_at[PRT__SH_KERNELS] = {
    prt__sh_at_1, prt__sh_at_2, prt__sh_at_3, prt__sh_at_4, prt__sh_at_5,
    prt__sh_at_6, prt__sh_at_7, prt__sh_at_8, prt__sh_at_9, prt__sh_at_10
};

/* sqrt(k) and 1/sqrt(k) for integers k >= 1: a table to 64 bands, the instruction beyond */
PRT__INLINE double prt__root(int k) {
    return (unsigned)k < PRT__ROOTS ? prt__roots()[k] : sqrt((double)k);
}
PRT__INLINE double prt__inverse_root(int k) {
    return (unsigned)k < PRT__ROOTS ? prt__inverse_roots()[k] : 1 / sqrt((double)k);
}

/* The recurrence [Sloan 2013], normalised:  p(l,m) = a z p(l-1,m) - c p(l-2,m),
     a = sqrt((4l^2-1)/(l^2-m^2)),   c = a sqrt(((l-1)^2-m^2)/(4(l-1)^2-1)),   p(m,m) from prt__sh_sector.
   A basis of another name has other factors. Below l = PRT__NEAR they come from tables, without a branch. */
enum { PRT__NEAR = 64 };
typedef struct prt__sh_step { double a, c; } prt__sh_step;
typedef prt__sh_step prt__step_of(int l, int m);               /* l > m; c(m+1,m) = 0 */
PRT__INLINE prt__sh_step prt__sh_near_step(int l, int m) {
    const double *r = prt__roots(), *inverse = prt__inverse_roots();                       /* both 0 at 0 */
    double over = inverse[l - m] * inverse[l + m];
    prt__sh_step s;
    s.a = r[2 * l + 1] * r[2 * l - 1] * over;
    s.c = r[2 * l + 1] * inverse[l > 1 ? 2 * l - 3 : 0] * (r[l - 1 - m] * r[l - 1 + m] * over);
    return s;
}
PRT__INLINE prt__sh_step prt__sh_far_step(int l, int m) {
    double l2 = (double)l * l, m2 = (double)m * m, k2 = (double)(l - 1) * (l - 1);
    prt__sh_step s;
    s.a = sqrt((4 * l2 - 1) / (l2 - m2));
    s.c = s.a * sqrt((k2 - m2) / (4 * k2 - 1));
    return s;
}

/* p(m,m) = p(m-1,m-1) sqrt((2m+1)/(2m)), times sqrt 2 from m = 0 to 1 */
PRT__INLINE double prt__sh_sector(int m, double previous) {
    if (m == 0) return 0.28209479177387814347;
    return previous * prt__root(2 * m + 1) * (m == 1 ? 1.0 : prt__inverse_root(2 * m));
}

/* One direction goes band by band, all m of a band at once: their chains are independent, so none waits for another. It
   runs in double whatever prt_real is, which costs little and leaves of the error little more than one rounding of the
   result. From about 1477 bands on, though, powers of x+iy and columns p(.,m) leave the range of double near the poles
   (that of float from 186) though their products do not. */
enum { PRT__SH_UNSCALED = 1400 };

typedef struct prt__sh_state {
    double p1[PRT_MAX_BANDS], p2[PRT_MAX_BANDS];               /* p(l,m), p(l-1,m) */
    double re[PRT_MAX_BANDS], im[PRT_MAX_BANDS];               /* (x+iy)^m */
    double plus[PRT_MAX_BANDS], minus[PRT_MAX_BANDS];          /* sums of p(l,m) f(l,+-m) */
} prt__sh_state;

PRT__INLINE void prt__sh_next_band(prt__step_of *step, int l, double z, prt__sh_state *s) {
    int m;
    for (m = 0; m < l; m++) {
        prt__sh_step k = step(l, m);
        double p = k.a * (z * s->p1[m]) - k.c * s->p2[m];
        s->p2[m] = s->p1[m];
        s->p1[m] = p;
    }
}

PRT__INLINE void prt__sh_open_column(int l, prt_vec3 d, double sector, prt__sh_state *s) {
    double x = (double)d.x, y = (double)d.y;
    s->p1[l] = sector;
    s->p2[l] = s->plus[l] = s->minus[l] = 0;
    s->re[l] = l ? s->re[l - 1] * x - s->im[l - 1] * y : 1;
    s->im[l] = l ? s->re[l - 1] * y + s->im[l - 1] * x : 0;
}

PRT__INLINE void prt__sh_emit(int l, const prt__sh_state *s, prt_real *PRT__RESTRICT row, size_t stride) {
    int m;
    if (stride == 1) {
        for (m = 0; m <= l; m++) row[-m] = (prt_real)(s->p1[m] * s->im[m]);
        for (m = 0; m <= l; m++) row[m] = (prt_real)(s->p1[m] * s->re[m]);
        return;
    }
    for (m = 0; m <= l; m++) {
        row[-(ptrdiff_t)((size_t)m * stride)] = (prt_real)(s->p1[m] * s->im[m]);
        row[(size_t)m * stride] = (prt_real)(s->p1[m] * s->re[m]);
    }
}

PRT__INLINE void prt__sh_gather(int l, prt__sh_state *s, const prt_real *row) {
    int m;
    for (m = 0; m <= l; m++) s->plus[m] += s->p1[m] * (double)row[m];
    for (m = 1; m <= l; m++) s->minus[m] += s->p1[m] * (double)row[-m];
}

/* Beyond the range: m outer, l inner, phasor and column with an integer exponent each, value = mantissa * 2^(400 exponent).
   A rescale is exact. */
#define PRT__SCALE 2.58224987808690858965591917200e120
typedef struct prt__scaled { double p1, p2; int exponent; } prt__scaled;

PRT__INLINE void prt__scaled_turn(prt__scaled *c, double x, double y) {               /* p1 + i p2 times x + iy */
    double re = c->p1 * x - c->p2 * y, im = c->p1 * y + c->p2 * x;
    if (fabs(re) < 1 / PRT__SCALE && fabs(im) < 1 / PRT__SCALE) { re *= PRT__SCALE; im *= PRT__SCALE; c->exponent--; }
    c->p1 = re;
    c->p2 = im;
}

PRT__INLINE void prt__scaled_climb(prt__scaled *c, double z, prt__sh_step s) {
    double p = s.a * (z * c->p1) - s.c * c->p2;
    c->p2 = c->p1;
    c->p1 = p;
    if (fabs(p) > PRT__SCALE) { c->p1 *= 1 / PRT__SCALE; c->p2 *= 1 / PRT__SCALE; c->exponent++; }
}

/* With finite input the product with a phasor is bounded, so that higher exponents do not occur. */
PRT__INLINE double prt__unscaled(double mantissa, int exponent) {
    if (exponent == 0) return mantissa;
    if (exponent == 1) return mantissa * PRT__SCALE;
    if (exponent == -1) return mantissa * (1 / PRT__SCALE);
    return exponent < 0 ? 0 : mantissa * PRT__SCALE * PRT__SCALE;
}

PRT__INLINE prt_real prt__recurrence_scaled(prt__step_of *near_step, prt__step_of *far_step, int bands, prt_vec3 d,
                                            const prt_real *f, prt_real *PRT__RESTRICT y, size_t stride) {
    prt__scaled c = { 1, 0, 0 };
    double sum = 0, sector = 0;
    int l, m;
    for (m = 0; m < bands; m++) {
        prt__scaled p = { 0, 0, 0 };
        double minus = 0, plus = 0;
        p.p1 = sector = prt__sh_sector(m, sector);
        for (l = m; l < bands; l++) {
            double q;
            if (l > m) prt__scaled_climb(&p, (double)d.z, l < PRT__NEAR ? near_step(l, m) : far_step(l, m));
            q = prt__unscaled(p.p1, p.exponent + c.exponent);
            if (f) {
                minus += q * (double)f[PRT_SH_INDEX(l, -m)];
                plus += q * (double)f[PRT_SH_INDEX(l, m)];
            } else {
                y[(size_t)PRT_SH_INDEX(l, -m) * stride] = (prt_real)(q * c.p2);
                y[(size_t)PRT_SH_INDEX(l, m) * stride] = (prt_real)(q * c.p1);
            }
        }
        sum += plus * c.p1 + (m ? minus * c.p2 : 0);
        prt__scaled_turn(&c, (double)d.x, (double)d.y);
    }
    return (prt_real)sum;
}

/* p(l,m) {Im,Re}(x+iy)^m for any number of bands, coefficient i to y[i * stride]; with coefficients f given, returns the
   value of f instead. The steps are inlined: they cost no call. */
PRT__INLINE prt_real prt__recurrence_with(prt__step_of *near_step, prt__step_of *far_step, int bands, prt_vec3 d,
                                          const prt_real *f, prt_real *PRT__RESTRICT y, size_t stride) {
    prt__sh_state s;
    double sector = 0, sum = 0;
    int l, m;
    if (bands > PRT__SH_UNSCALED) return prt__recurrence_scaled(near_step, far_step, bands, d, f, y, stride);
    for (l = 0; l < bands; l++) {
        if (l < PRT__NEAR) prt__sh_next_band(near_step, l, (double)d.z, &s);
        else prt__sh_next_band(far_step, l, (double)d.z, &s);
        sector = prt__sh_sector(l, sector);
        prt__sh_open_column(l, d, sector, &s);
        if (f) prt__sh_gather(l, &s, f + PRT_SH_INDEX(l, 0));
        else prt__sh_emit(l, &s, y + (size_t)PRT_SH_INDEX(l, 0) * stride, stride);
    }
    for (m = 0; f && m < bands; m++) sum += s.plus[m] * s.re[m] + s.minus[m] * s.im[m];
    return (prt_real)sum;
}

/* Batches in rows (_soa) go through blocks of PRT__SH_BLOCK vectors of directions, the last one padded: coefficient i of
   direction k to to[i * stride + k]. Vectors run in prt_real, so float has fewer bands before it leaves its range. */
enum { PRT__SH_BLOCK = 4, PRT__SH_BLOCK_ITEMS = PRT__SH_BLOCK * PRT__LANES };
#ifdef PRT_DOUBLE
enum { PRT__SH_UNSCALED_V = PRT__SH_UNSCALED };
#else
enum { PRT__SH_UNSCALED_V = 180 };
#endif
typedef struct prt__sh_block {
    prt_real x[PRT__SH_BLOCK_ITEMS], y[PRT__SH_BLOCK_ITEMS], z[PRT__SH_BLOCK_ITEMS];
    int items;
    prt_real *to;
    size_t stride;
} prt__sh_block;

PRT__INLINE void prt__sh_put(const prt__sh_block *b, int i, int vector, prt__vec v) {
    int first = vector * PRT__LANES, lanes = b->items - first;
    prt_real *to = b->to + (size_t)i * b->stride + first;
    if (lanes >= PRT__LANES) prt__vec_store(to, v);
    else if (lanes > 0) prt__vec_store_part(to, v, lanes);
}

/* The vectors of a block stand side by side in the innermost loop: the factors are taken once for all of them, and the
   rows are written in runs of whole cache lines. */
PRT__INLINE void prt__recurrence_with_v(prt__step_of *near_step, prt__step_of *far_step, int bands, const prt__sh_block *b) {
    prt__vec re[PRT__SH_BLOCK], im[PRT__SH_BLOCK], p1[PRT__SH_BLOCK], p2[PRT__SH_BLOCK];
    double sector = 0;
    int l, m, v;
    for (v = 0; v < PRT__SH_BLOCK; v++) { re[v] = prt__vec_set(1); im[v] = prt__vec_set(0); }
    for (m = 0; m < bands; m++) {
        sector = prt__sh_sector(m, sector);
        for (v = 0; v < PRT__SH_BLOCK; v++) { p1[v] = prt__vec_set((prt_real)sector); p2[v] = prt__vec_set(0); }
        for (l = m; l < bands; l++) {
            prt__sh_step s = { 0, 0 };
            prt_real a, c;
            if (l > m) s = l < PRT__NEAR ? near_step(l, m) : far_step(l, m);
            a = (prt_real)s.a;
            c = (prt_real)s.c;
            for (v = 0; v < PRT__SH_BLOCK; v++) {
                if (l > m) {
                    prt__vec p = a * (prt__vec_load(b->z + v * PRT__LANES) * p1[v]) - c * p2[v];
                    p2[v] = p1[v];
                    p1[v] = p;
                }
                prt__sh_put(b, PRT_SH_INDEX(l, -m), v, p1[v] * im[v]);
                prt__sh_put(b, PRT_SH_INDEX(l, m), v, p1[v] * re[v]);
            }
        }
        for (v = 0; v < PRT__SH_BLOCK; v++) {
            prt__vec x = prt__vec_load(b->x + v * PRT__LANES), y = prt__vec_load(b->y + v * PRT__LANES);
            prt__vec turned = re[v] * x - im[v] * y;
            im[v] = re[v] * y + im[v] * x;
            re[v] = turned;
        }
    }
}

/* What evaluates a basis: straight-line kernels for the low bands, a recurrence above. */
typedef prt_real prt__recurrence(int bands, prt_vec3 d, const prt_real *f, prt_real *PRT__RESTRICT y, size_t stride);
typedef void prt__recurrence_v(int bands, const prt__sh_block *b);
typedef struct prt__basis {
    prt__sh_kernel *const *kernels;
    prt__sh_kernel_v *const *kernels_v;
    prt__sh_kernel_at *const *kernels_at;
    prt__recurrence *recurrence;
    prt__recurrence_v *recurrence_v;
} prt__basis;

PRT__STATIC prt_real prt__sh_recurrence(int bands, prt_vec3 d, const prt_real *f, prt_real *PRT__RESTRICT y,
                                        size_t stride) {
    return prt__recurrence_with(prt__sh_near_step, prt__sh_far_step, bands, d, f, y, stride);
}
PRT__STATIC void prt__sh_recurrence_v(int bands, const prt__sh_block *b) {
    prt__recurrence_with_v(prt__sh_near_step, prt__sh_far_step, bands, b);
}

static const prt__basis prt__sh_basis = {
    prt__sh_kernels, prt__sh_kernels_v, prt__sh_kernels_at, prt__sh_recurrence, prt__sh_recurrence_v
};

PRT__INLINE void prt__eval(const prt__basis *basis, int bands, prt_vec3 d, prt_real *y) {
    if (bands <= PRT__SH_KERNELS) basis->kernels[bands - 1](d.x, d.y, d.z, y);
    else basis->recurrence(bands, d, NULL, y, 1);
}

/* to[k * n + i] = from[i * from_stride + k]: rows of coefficients out of a block of columns */
PRT__STATIC void prt__transpose(int n, int items, const prt_real *from, size_t from_stride, prt_real *PRT__RESTRICT to) {
    int i, k = 0, quads = 0;
#if PRT__SIMD
    quads = n & ~3;
    for (; k + 4 <= items; k += 4)
        for (i = 0; i < quads; i += 4) {
            const prt_real *block = from + (size_t)i * from_stride + k;        /* written out: gcc -O2 does not unroll */
            prt_real *rows = to + (size_t)k * (size_t)n + i;
            prt__quad m[4];
            memcpy(&m[0], block, sizeof m[0]);
            memcpy(&m[1], block + from_stride, sizeof m[0]);
            memcpy(&m[2], block + 2 * from_stride, sizeof m[0]);
            memcpy(&m[3], block + 3 * from_stride, sizeof m[0]);
            prt__quad_transpose(m);
            memcpy(rows, &m[0], sizeof m[0]);
            memcpy(rows + n, &m[1], sizeof m[0]);
            memcpy(rows + 2 * n, &m[2], sizeof m[0]);
            memcpy(rows + 3 * n, &m[3], sizeof m[0]);
        }
#endif
    for (i = 0; i < n; i++) {
        int first = i < quads ? k : 0, item;
        for (item = first; item < items; item++) to[(size_t)item * (size_t)n + (size_t)i] = from[(size_t)i * from_stride + (size_t)item];
    }
}

/* Up to a block of directions through the kernels of vectors, each result transposed into its row */
PRT__STATIC void prt__eval_rows(const prt__basis *basis, int bands, int items, const prt_vec3 *dirs, prt_real *y) {
    prt_real columns[PRT_SH_COUNT(PRT__SH_KERNELS) * PRT__SH_BLOCK_ITEMS];
    prt_real dx[PRT__SH_BLOCK_ITEMS], dy[PRT__SH_BLOCK_ITEMS], dz[PRT__SH_BLOCK_ITEMS];
    int k;
    for (k = 0; k < PRT__SH_BLOCK_ITEMS; k++) {
        prt_vec3 d = dirs[k < items ? k : 0];
        dx[k] = d.x; dy[k] = d.y; dz[k] = d.z;
    }
    basis->kernels_v[bands - 1]((items + PRT__LANES - 1) / PRT__LANES, dx, dy, dz, columns, PRT__SH_BLOCK_ITEMS);
    prt__transpose(PRT_SH_COUNT(bands), items, columns, PRT__SH_BLOCK_ITEMS, y);
}

PRT__STATIC prt_result prt__eval_n(const prt__basis *basis, int bands, int count, const prt_vec3 *dirs, prt_real *y) {
    size_t n;
    int k, step = PRT__LANES > 1 && bands <= PRT__SH_KERNELS ? PRT__SH_BLOCK_ITEMS : 1;        /* else one by one is faster */
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0) return PRT_ERR_COUNT;
    if (count == 0) return PRT_OK;
    if (!dirs || !y) return PRT_ERR_NULL;
    n = (size_t)PRT_SH_COUNT(bands);
    for (k = 0; k < count; k += step) {
        if (step == 1) prt__eval(basis, bands, dirs[k], y + (size_t)k * n);
        else prt__eval_rows(basis, bands, count - k < step ? count - k : step, dirs + k, y + (size_t)k * n);
    }
    return PRT_OK;
}

/* Up to a block of directions, padded with the first of them */
PRT__STATIC void prt__eval_soa_block(const prt__basis *basis, int bands, int items, const prt_real *x, const prt_real *y,
                                     const prt_real *z, prt_real *out, size_t stride) {
    prt_real columns[PRT_SH_COUNT(PRT__SH_KERNELS) * PRT__SH_BLOCK_ITEMS];
    prt__sh_block b;
    int k, i;
    b.items = items;
    b.to = out;
    b.stride = stride;
    for (k = 0; k < PRT__SH_BLOCK_ITEMS; k++) {
        int from = k < items ? k : 0;
        b.x[k] = x[from]; b.y[k] = y[from]; b.z[k] = z[from];
    }
    if (bands > PRT__SH_KERNELS) { basis->recurrence_v(bands, &b); return; }
    basis->kernels_v[bands - 1]((items + PRT__LANES - 1) / PRT__LANES, b.x, b.y, b.z, columns, PRT__SH_BLOCK_ITEMS);
    for (i = 0; i < PRT_SH_COUNT(bands); i++)
        memcpy(out + (size_t)i * stride, columns + i * PRT__SH_BLOCK_ITEMS, (size_t)items * sizeof *out);
}

enum { PRT__SH_CHUNK = 1024 };                                 /* directions a sweep: they stay in the first-level cache */

PRT__STATIC prt_result prt__eval_soa(const prt__basis *basis, int bands, int count, const prt_real *x, const prt_real *y,
                                     const prt_real *z, prt_real *out, size_t stride) {
    int k = 0;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0 || stride < (size_t)count) return PRT_ERR_COUNT;
    if (count == 0) return PRT_OK;
    if (!x || !y || !z || !out) return PRT_ERR_NULL;
    if (bands > PRT__SH_UNSCALED_V) {
        for (; k < count; k++) basis->recurrence(bands, prt__vec3(x[k], y[k], z[k]), NULL, out + k, stride);
        return PRT_OK;
    }
    if (bands <= PRT__SH_KERNELS)
        while (count - k >= PRT__LANES) {
            int vectors = (count - k < PRT__SH_CHUNK ? count - k : PRT__SH_CHUNK) / PRT__LANES;
            basis->kernels_v[bands - 1](vectors, x + k, y + k, z + k, out + k, stride);
            k += vectors * PRT__LANES;
        }
    for (; k < count; k += PRT__SH_BLOCK_ITEMS)
        prt__eval_soa_block(basis, bands, count - k < PRT__SH_BLOCK_ITEMS ? count - k : PRT__SH_BLOCK_ITEMS,
                            x + k, y + k, z + k, out + k, stride);
    return PRT_OK;
}

PRT__INLINE void prt__sh_eval(int bands, prt_vec3 d, prt_real *y) { prt__eval(&prt__sh_basis, bands, d, y); }

PRTDEF prt_result prt_sh_eval(int bands, prt_vec3 dir, prt_real *y) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!y) return PRT_ERR_NULL;
    prt__sh_eval(bands, dir, y);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_eval_n(int bands, int count, const prt_vec3 *dirs, prt_real *y) {
    return prt__eval_n(&prt__sh_basis, bands, count, dirs, y);
}

PRTDEF prt_result prt_sh_eval_soa(int bands, int count, const prt_real *x, const prt_real *y, const prt_real *z,
                                  prt_real *out, size_t stride) {
    return prt__eval_soa(&prt__sh_basis, bands, count, x, y, z, out, stride);
}

/* Eight partial sums: a single one would wait for each addition. Which term goes to which sum is fixed, and so are the
   bits, whatever the width of the machine. */
#if PRT__SIMD && PRT__LANES >= 8                                /* narrower registers: gcc spills vectors wider than they */
typedef prt_real prt__oct __attribute__((vector_size(8 * sizeof(prt_real))));
PRT__INLINE void prt__oct_madd(prt__oct *sum, const prt_real *f, const prt_real *g) {
    prt__oct a, b;
    memcpy(&a, f, sizeof a);
    memcpy(&b, g, sizeof b);
    *sum += a * b;
}
#else
typedef struct prt__oct { prt_real lane[8]; } prt__oct;
PRT__INLINE void prt__oct_madd(prt__oct *sum, const prt_real *f, const prt_real *g) {
    int k;
    for (k = 0; k < 8; k++) sum->lane[k] += f[k] * g[k];
}
#endif
PRT__INLINE prt_real prt__oct_sum(const prt__oct *sum) {
    prt_real s[8];
    memcpy(s, sum, sizeof s);
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

/* Three of them at once, bit-equal */
PRT__INLINE void prt__oct_sum3(const prt__oct *r, const prt__oct *g, const prt__oct *b, prt_rgb *out) {
#if PRT__SIMD && PRT__LANES >= 8 && (defined(__clang__) || __GNUC__ >= 12)
    prt__quad m[4];
    m[0] = __builtin_shufflevector(*r, *r, 0, 1, 2, 3) + __builtin_shufflevector(*r, *r, 4, 5, 6, 7);
    m[1] = __builtin_shufflevector(*g, *g, 0, 1, 2, 3) + __builtin_shufflevector(*g, *g, 4, 5, 6, 7);
    m[2] = __builtin_shufflevector(*b, *b, 0, 1, 2, 3) + __builtin_shufflevector(*b, *b, 4, 5, 6, 7);
    m[3] = m[2];
    prt__quad_transpose(m);
    m[0] = (m[0] + m[2]) + (m[1] + m[3]);
    out->r = m[0][0]; out->g = m[0][1]; out->b = m[0][2];
#else
    out->r = prt__oct_sum(r); out->g = prt__oct_sum(g); out->b = prt__oct_sum(b);
#endif
}

/* sum of f_i g_i, the terms past the last multiple of eight added one by one */
PRT__INLINE prt_real prt__dot_tail(prt_real sum, int first, int count, const prt_real *f, const prt_real *g) {
    int i;
    for (i = first; i < count; i++) sum += f[i] * g[i];
    return sum;
}

PRT__STATIC prt_real prt__dot(int count, const prt_real *f, const prt_real *g) {
    prt__oct sum;
    int i;
    memset(&sum, 0, sizeof sum);
    for (i = 0; i + 8 <= count; i += 8) prt__oct_madd(&sum, f + i, g + i);
    return prt__dot_tail(prt__oct_sum(&sum), i, count, f, g);
}

PRT__INLINE prt_real prt__at(const prt__basis *basis, int bands, const prt_real *f, prt_vec3 dir) {
    prt_real sum;
    if (!prt__bands_ok(bands) || !f) return 0;
    if (bands > PRT__SH_KERNELS) return basis->recurrence(bands, dir, f, NULL, 1);
    basis->kernels_at[bands - 1](f, dir.x, dir.y, dir.z, &sum);
    return sum;
}

PRTDEF prt_real prt_sh_at(int bands, const prt_real *f, prt_vec3 dir) {
    return prt__at(&prt__sh_basis, bands, f, dir);
}

PRTDEF prt_real prt_sh_dot(int bands, const prt_real *f, const prt_real *g) {
    if (!prt__bands_ok(bands) || !f || !g) return 0;
    return prt__dot(PRT_SH_COUNT(bands), f, g);
}

/* ----------------------------------------------------------------------------------------------- >>project ---- */

/* The direction at length 1; 0 if it is not finite or its length differs from 1 by more than 1e-3. Within that the series of
   (1+e)^(-1/2) - 1 ends after six terms; it saves the latency of a root and a division. */
PRT__STATIC int prt__unit(prt_vec3 v, prt_vec3 *unit) {
    double x = (double)v.x, y = (double)v.y, z = (double)v.z, e = x * x + y * y + z * z - 1, s;
    if (!prt__finite3(v) || !(e >= -0.001999 && e <= 0.002001)) return 0;
    s = e * (-0.5 + e * (0.375 + e * (-0.3125 + e * (0.2734375 + e * (-0.24609375 + e * 0.2255859375)))));
    unit->x = (prt_real)(x + s * x);
    unit->y = (prt_real)(y + s * y);
    unit->z = (prt_real)(z + s * z);
    return 1;
}

/* Where only the product is in the range of prt_real */
PRT__STATIC void prt__scale_band_wide(int l, double factor, const prt_real *f, prt_real *out) {
    int i;
    for (i = l * l; i < (l + 1) * (l + 1); i++) out[i] = (prt_real)(factor * (double)f[i]);
}

PRT__INLINE void prt__scale_band(int l, double factor, const prt_real *f, prt_real *out) {
    const prt_real w = (prt_real)factor;
    int i;
    for (i = l * l; i < (l + 1) * (l + 1); i++) out[i] = w * f[i];
}
PRT__INLINE int prt__in_range(double v) { return !(fabs(v) > (double)PRT__REAL_MAX); }

/* out_lm = factor_l f_lm; out may be f. Low bands one after the other, so that each is a loop of known length. */
PRT__STATIC void prt__scale_bands(int bands, const double *factor, const prt_real *f, prt_real *out) {
    int l, wide = 0;
    for (l = 0; l < bands; l++) wide |= !prt__in_range(factor[l]);
    if (wide) {
        for (l = 0; l < bands; l++) prt__scale_band_wide(l, factor[l], f, out);
        return;
    }
    prt__scale_band(0, factor[0], f, out);
    if (bands > 1) prt__scale_band(1, factor[1], f, out);
    if (bands > 2) prt__scale_band(2, factor[2], f, out);
    if (bands > 3) prt__scale_band(3, factor[3], f, out);
    if (bands > 4) prt__scale_band(4, factor[4], f, out);
    if (bands > 5) prt__scale_band(5, factor[5], f, out);
    for (l = 6; l < bands; l++) prt__scale_band(l, factor[l], f, out);
}

/* A function about an axis from its Funk-Hecke factors. */
PRT__STATIC void prt__zonal_light(int bands, const double *factor, prt_vec3 axis, prt_real *f) {
    prt__sh_eval(bands, axis, f);
    prt__scale_bands(bands, factor, f, f);
}

/* Factors of a cap from sin^2 and h = 1 - cos of its half-angle, at most pi/2; `outside`: of all the rest. */
PRT__STATIC void prt__cap_factors(int bands, double sin2, double h, int outside, double *factor) {
    static const double low[8][2] = {                                 /* the same quotients, of l-1 and of 2l+1 */
        { 0, 0 }, { 0, 3 / 3.0 }, { 1 / 4.0, 5 / 4.0 }, { 2 / 5.0, 7 / 5.0 }, { 3 / 6.0, 9 / 6.0 }, { 4 / 7.0, 11 / 7.0 },
        { 5 / 8.0, 13 / 8.0 }, { 6 / 9.0, 15 / 9.0 }
    };
    double u = 1, step = 0, scale = PRT__PI * sin2;
    int l;
    factor[0] = outside ? 2 * PRT__PI * (2 - h) : 2 * PRT__PI * h;
    for (l = 1; l < bands; l++) {
        factor[l] = scale * u;
        if (l < 8) step = low[l][0] * step - low[l][1] * (h * u);
        else step = ((l - 1) * step - (2 * l + 1) * h * u) / (l + 2);
        u += step;
        if (outside) scale = -scale;
    }
}

/* pi, 2 pi/3, pi/4, 0, -pi/24, 0, pi/64 ... */
PRT__STATIC void prt__cosine_factors(int bands, double *factor) {
    static const double low[8] = { PRT__PI, 2 * PRT__PI / 3, PRT__PI / 4, 0, -PRT__PI / 24, 0, PRT__PI / 64, 0 };
    int l;
    for (l = 0; l < bands; l++) factor[l] = l < 8 ? low[l] : factor[l - 2] * (3 - l) / (l + 2);
}

/* 1 above and -1 below: 4 pi int_0^1 P_l for odd l, 0 for even l. */
PRT__STATIC void prt__sign_factors(int bands, double *factor) {
    static const double low[8] = { 0, 2 * PRT__PI, 0, -PRT__PI / 2, 0, PRT__PI / 4, 0, -5 * PRT__PI / 32 };
    int l;
    for (l = 0; l < bands; l++) factor[l] = l < 8 ? low[l] : factor[l - 2] * (2 - l) / (l + 1);
}

PRTDEF prt_result prt_sh_add_sample(int bands, prt_vec3 dir, prt_real value_times_weight, prt_real *f) {
    prt_real y[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f) return PRT_ERR_NULL;
    prt__sh_eval(bands, dir, y);
    for (i = 0; i < PRT_SH_COUNT(bands); i++) f[i] += value_times_weight * y[i];
    return PRT_OK;
}

PRTDEF prt_result prt_sh_delta(int bands, prt_vec3 dir, prt_real *f) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f) return PRT_ERR_NULL;
    if (!prt__unit(dir, &dir)) return PRT_ERR_VALUE;
    prt__sh_eval(bands, dir, f);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_cone(int bands, prt_vec3 axis, prt_real half_angle, prt_real *f) {
    double factor[PRT_MAX_BANDS], angle, half, h;
    int wide;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f) return PRT_ERR_NULL;
    if (!prt__unit(axis, &axis) || !prt__finite(half_angle)) return PRT_ERR_VALUE;
    if (!(half_angle >= 0 && half_angle <= PRT__R(PRT__PI))) return PRT_ERR_VALUE;
    angle = (double)half_angle;
    wide = angle > PRT__PI / 2;
    if (wide) angle = angle < PRT__PI ? PRT__PI - angle : 0;          /* float rounds pi up */
    half = sin(angle / 2);
    h = 2 * half * half;
    prt__cap_factors(bands, h * (2 - h), h, wide, factor);
    prt__zonal_light(bands, factor, axis, f);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_sphere(int bands, prt_vec3 to_centre, prt_real radius, prt_real *f) {
    double factor[PRT_MAX_BANDS], scale, x, y, z, r, d, sin2 = 0, h = 0;
    int inside;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f) return PRT_ERR_NULL;
    if (!prt__finite3(to_centre) || !prt__finite(radius) || radius < 0) return PRT_ERR_VALUE;
    x = (double)to_centre.x; y = (double)to_centre.y; z = (double)to_centre.z; r = (double)radius;
    scale = r + fabs(x) + fabs(y) + fabs(z);
    if (!(scale > 1e-140 && scale < 1e140)) {                         /* squares would overflow, or vanish: never in float */
        int exponent;
        (void)frexp(scale < DBL_MAX / 8 ? scale : DBL_MAX / 8, &exponent);    /* a power of 2 keeps `inside` exact */
        x = ldexp(x, -exponent); y = ldexp(y, -exponent); z = ldexp(z, -exponent); r = ldexp(r, -exponent);
    }
    d = sqrt(x * x + y * y + z * z);
    inside = d < r;
    to_centre.x = 0; to_centre.y = 0; to_centre.z = 1;
    if (d > 0) {
        double inverse = 1 / d, sine = r * inverse;
        to_centre.x = (prt_real)(x * inverse); to_centre.y = (prt_real)(y * inverse); to_centre.z = (prt_real)(z * inverse);
        if (!inside) {
            sin2 = sine * sine;
            h = sin2 / (1 + sqrt((d - r) * (d + r)) * inverse);
        }
    }
    prt__cap_factors(bands, sin2, h, inside, factor);
    prt__zonal_light(bands, factor, to_centre, f);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_cosine_lobe(int bands, prt_vec3 axis, prt_real *f) {
    double factor[PRT_MAX_BANDS];
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f) return PRT_ERR_NULL;
    if (!prt__unit(axis, &axis)) return PRT_ERR_VALUE;
    prt__cosine_factors(bands, factor);
    prt__zonal_light(bands, factor, axis, f);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_hemisphere(int bands, prt_vec3 up, prt_real above, prt_real below, prt_real *f) {
    double factor[PRT_MAX_BANDS], step;
    int l;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f) return PRT_ERR_NULL;
    if (!prt__unit(up, &up) || !prt__finite(above) || !prt__finite(below)) return PRT_ERR_VALUE;
    step = (double)above / 2 - (double)below / 2;
    prt__sign_factors(bands, factor);
    for (l = 1; l < bands; l++) factor[l] *= step;
    factor[0] = 4 * PRT__PI * ((double)above / 2 + (double)below / 2);
    prt__zonal_light(bands, factor, up, f);
    return PRT_OK;
}

/* Vectors of doubles for the sums over texels. */
#if PRT__SIMD
#  define PRT__WIDE_LANES (PRT__VEC_BYTES / 8)
typedef double prt__wide __attribute__((vector_size(PRT__VEC_BYTES)));
#else
#  define PRT__WIDE_LANES 1
typedef double prt__wide;
#endif

PRT__INLINE prt__wide prt__wide_load(const double *p) { prt__wide v; memcpy(&v, p, sizeof v); return v; }
PRT__INLINE void prt__wide_store(double *p, prt__wide v) { memcpy(p, &v, sizeof v); }

/* Adds the lanes of six vectors to six sums. */
PRT__INLINE void prt__wide_add6(const prt__wide v[6], double *sum) {
    double lane[PRT__WIDE_LANES];
    int k, i;
    for (k = 0; k < 6; k++) {
        prt__wide_store(lane, v[k]);
        for (i = 0; i < PRT__WIDE_LANES; i++) sum[k] += lane[i];
    }
}

enum { PRT__ORDERS = 16,          /* orders m that one pass over a map gathers */
       PRT__TEXELS = 32 };         /* texels, after folding, worked on at a time */

/* What one pass over a map gathers, orders first <= m < last of every band: sum[m-first][l] holds r, g, b of (l,m),
   then of (l,-m). p(l,m) = a z p(l-1,m) - b p(l-2,m) from p(m,m) = sector, as in prt_sh_eval. */
typedef struct prt__gather {
    int bands, first, last;
    double sector[PRT__ORDERS], a[PRT__ORDERS][PRT_MAX_BANDS], b[PRT__ORDERS][PRT_MAX_BANDS];
    double sum[PRT__ORDERS][PRT_MAX_BANDS][6];
} prt__gather;

PRT__STATIC void prt__gather_start(prt__gather *g, int bands, int first) {
    double sector = 0;
    int m, l;
    g->bands = bands;
    g->first = first;
    g->last = first + PRT__ORDERS < bands ? first + PRT__ORDERS : bands;
    for (m = 0; m < first; m++) sector = prt__sh_sector(m, sector);
    for (m = first; m < g->last; m++) {
        double *a = g->a[m - first], *b = g->b[m - first];
        g->sector[m - first] = sector = prt__sh_sector(m, sector);
        for (l = m + 1; l < bands; l++) {
            a[l] = prt__root(2 * l + 1) * prt__root(2 * l - 1) * prt__inverse_root(l - m) * prt__inverse_root(l + m);
            b[l] = l > m + 1 ? a[l] / a[l - 1] : 0;
        }
        memset(g->sum[m - first], 0, (size_t)bands * sizeof g->sum[0][0]);
    }
}

PRT__STATIC void prt__gather_write(const prt__gather *g, prt_real *light) {
    int count = PRT_SH_COUNT(g->bands), m, l, c;
    for (m = g->first; m < g->last; m++)
        for (l = m; l < g->bands; l++)
            for (c = 0; c < 3; c++) {
                const double *sum = g->sum[m - g->first][l];
                light[c * count + PRT_SH_INDEX(l, m)] = (prt_real)sum[c];
                if (m > 0) light[c * count + PRT_SH_INDEX(l, -m)] = (prt_real)sum[3 + c];
            }
}

/* The sums of band 0 weigh every texel by a positive number, so that one texel that is not finite shows in them. */
PRT__STATIC int prt__gather_finite(const prt__gather *g) {
    const double *sum = g->sum[0][0];
    return sum[0] - sum[0] == 0 && sum[1] - sum[1] == 0 && sum[2] - sum[2] == 0;
}

/* Both maps map onto themselves when x, y or z changes its sign, and a real Y(l,m) is even or odd in each: so the eight
   images of a texel share one evaluation. Class bits 0, 1, 2: odd in x, y, z. A block is a run of texels along a row, with
   value[class][r, g, b] = weight times sum over the images of sign times texel. */
typedef struct prt__octant {
    int lanes;                                                         /* texels, rounded up to whole vectors */
    double x[PRT__TEXELS], y[PRT__TEXELS], z[PRT__TEXELS], value[8][3][PRT__TEXELS];
} prt__octant;

/* Where the images of a row of texels are: of its first texel, and the steps to the next. Image bits as class bits. */
typedef struct prt__images {
    const float *texel[8];
    ptrdiff_t step[8];
} prt__images;

static const float prt__no_texel[3] = { 0, 0, 0 };

/* Texels from ... from+count-1 of the row into value[image]. */
PRT__STATIC void prt__load_images(const prt__images *images, int from, int count, prt__octant *block) {
    int i, k;
    block->lanes = (count + PRT__WIDE_LANES - 1) / PRT__WIDE_LANES * PRT__WIDE_LANES;
    for (k = 0; k < 8; k++) {
        double (*value)[PRT__TEXELS] = block->value[k];
        for (i = 0; i < count; i++) {
            const float *texel = images->texel[k] + (from + i) * images->step[k];
            value[0][i] = (double)texel[0];
            value[1][i] = (double)texel[1];
            value[2][i] = (double)texel[2];
        }
        for (; i < block->lanes; i++) value[0][i] = value[1][i] = value[2][i] = 0;
    }
}

/* Images to classes, a Walsh-Hadamard transform, and the weights. */
PRT__STATIC void prt__fold_images(const double *weight, prt__octant *block) {
    int i, c, k, bit;
    for (c = 0; c < 3; c++)
        for (i = 0; i < block->lanes; i += PRT__WIDE_LANES) {
            prt__wide v[8], w = prt__wide_load(weight + i);
            for (k = 0; k < 8; k++) v[k] = prt__wide_load(block->value[k][c] + i);
            for (bit = 1; bit < 8; bit *= 2)
                for (k = 0; k < 4; k++) {
                    int at = k + (k & -bit);                           /* the numbers without that bit */
                    prt__wide sum = v[at] + v[at + bit], difference = v[at] - v[at + bit];
                    v[at] = sum;
                    v[at + bit] = difference;
                }
            for (k = 0; k < 8; k++) prt__wide_store(block->value[k][c] + i, w * v[k]);
        }
}

/* e^(i pi k/width), reduced before rounding: k, in half columns, grows with the order. */
PRT__STATIC void prt__column_phase(uint64_t k, int width, double *re, double *im) {
    double angle = PRT__PI * (double)(k % (2 * (uint64_t)width)) / width;
    *re = cos(angle);
    *im = sin(angle);
}

/* e^(i order phi) for the columns of a block, from that of its first column and the steps [re, im] between them. */
PRT__STATIC void prt__column_phasors(int width, int from, int order, double (*step)[PRT__TEXELS], double *re,
                                     double *im) {
    double c, s;
    int i;
    prt__column_phase((uint64_t)order * (2 * (uint64_t)from + 1), width, &c, &s);
    for (i = 0; i < PRT__TEXELS; i++) {
        re[i] = c * step[0][i] - s * step[1][i];
        im[i] = s * step[0][i] + c * step[1][i];
    }
}

/* Row j with its images: first quarter of the columns (first half of an odd width, which has no images in -x). */
PRT__STATIC void prt__equirect_images(int width, int height, const float *rgb, int j, prt__images *images) {
    size_t stride = 3 * (size_t)width, half = 3 * (size_t)(width / 2);
    int k;
    for (k = 0; k < 8; k += 4) {
        const float *row = rgb + (size_t)(k ? height - 1 - j : j) * stride;
        images->texel[k] = row;
        images->texel[k + 2] = row + stride - 3;
        images->texel[k + 1] = width % 2 ? prt__no_texel : row + half - 3;
        images->texel[k + 3] = width % 2 ? prt__no_texel : row + half;
        images->step[k] = 3;
        images->step[k + 2] = -3;
        images->step[k + 1] = width % 2 ? 0 : -3;
        images->step[k + 3] = width % 2 ? 0 : 3;
    }
}

/* Adds a block's part of sum_i v_i e^(i m phi_i) to sum[m][odd in z], for the orders of a pass; re, im: e^(i first phi),
   moved on from order to order. */
PRT__STATIC void prt__sum_columns(const prt__gather *g, const prt__octant *block, double *re, double *im,
                                  double (*sum)[2][6]) {
    int m, i, k;
    for (m = g->first; m < g->last; m++) {
        int even = m & 1, odd = 3 - even;                              /* classes of cos m phi and sin m phi */
        prt__wide acc[2][6];
        memset(acc, 0, sizeof acc);
        for (i = 0; i < block->lanes; i += PRT__WIDE_LANES) {
            prt__wide c = prt__wide_load(re + i), s = prt__wide_load(im + i);
            prt__wide x = prt__wide_load(block->x + i), y = prt__wide_load(block->y + i);
            for (k = 0; k < 3; k++) {
                acc[0][k] += c * prt__wide_load(block->value[even][k] + i);
                acc[0][3 + k] += s * prt__wide_load(block->value[odd][k] + i);
                acc[1][k] += c * prt__wide_load(block->value[even + 4][k] + i);
                acc[1][3 + k] += s * prt__wide_load(block->value[odd + 4][k] + i);
            }
            prt__wide_store(re + i, c * x - s * y);
            prt__wide_store(im + i, c * y + s * x);
        }
        prt__wide_add6(acc[0], sum[m - g->first][0]);
        prt__wide_add6(acc[1], sum[m - g->first][1]);
    }
}

/* Legendre functions of a row at z, times its sums over columns; p(l,m) is even in z where l-m is. */
PRT__STATIC void prt__gather_row(prt__gather *g, double z, double sine, double weight, double (*sum)[2][6]) {
    double power = weight * pow(sine, g->first);
    int m, l, k;
    for (m = 0; m < g->last - g->first; m++, power *= sine) {
        double p = g->sector[m] * power, p1 = 0;
        for (l = g->first + m; l < g->bands; l++) {
            const double *v = sum[m][(l - g->first - m) & 1];
            if (l > g->first + m) {
                double p2 = p1;
                p1 = p;
                p = g->a[m][l] * z * p1 - g->b[m][l] * p2;
            }
            for (k = 0; k < 6; k++) g->sum[m][l][k] += p * v[k];
        }
    }
}

/* A texel that is its own image counts half, once for each axis. */
PRT__STATIC void prt__gather_equirect(prt__gather *g, int width, int height, const float *rgb) {
    double one[2][PRT__TEXELS], first[2][PRT__TEXELS], re[PRT__TEXELS], im[PRT__TEXELS], weight[PRT__TEXELS];
    double sum[PRT__ORDERS][2][6];
    int columns = width % 2 ? width / 2 + 1 : (width / 2 + 1) / 2, from, count, i, j;
    prt__images images;
    prt__octant block;
    for (i = 0; i < PRT__TEXELS; i++) {
        prt__column_phase(2 * (uint64_t)i, width, one[0] + i, one[1] + i);
        prt__column_phase(2 * (uint64_t)i * (uint64_t)g->first, width, first[0] + i, first[1] + i);
    }
    for (j = 0; j < height / 2 + height % 2; j++) {
        double theta = PRT__PI * (j + 0.5) / height, sine = sin(theta);
        double share = 4 * PRT__PI / width * sine * sin(PRT__PI / (2.0 * height)) * (2 * j + 1 == height ? 0.5 : 1);
        prt__equirect_images(width, height, rgb, j, &images);
        memset(sum, 0, sizeof sum);
        for (from = 0; from < columns; from += count) {
            count = columns - from < PRT__TEXELS ? columns - from : PRT__TEXELS;
            for (i = 0; i < PRT__TEXELS; i++) weight[i] = 1;
            if (from + count == columns && width % 4) weight[count - 1] = 0.5;
            prt__load_images(&images, from, count, &block);
            prt__fold_images(weight, &block);
            prt__column_phasors(width, from, 1, one, block.x, block.y);
            prt__column_phasors(width, from, g->first, first, re, im);
            prt__sum_columns(g, &block, re, im, sum);
        }
        prt__gather_row(g, cos(theta), sine, share, sum);
    }
}

PRTDEF prt_result prt_sh_project_equirect_rgb(int bands, int width, int height, const float *rgb, prt_real *light) {
    prt__gather g;
    int first;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (width < 1 || height < 1 || (size_t)width > SIZE_MAX / (3 * sizeof *rgb) / (size_t)height) return PRT_ERR_COUNT;
    if (!rgb || !light) return PRT_ERR_NULL;
    for (first = 0; first < bands; first += PRT__ORDERS) {
        prt__gather_start(&g, bands, first);
        prt__gather_equirect(&g, width, height, rgb);
        if (first == 0 && !prt__gather_finite(&g)) return PRT_ERR_VALUE;
        prt__gather_write(&g, light);
    }
    return PRT_OK;
}

/* Solid angle of the square of centre (u,v) and half width e on the plane z = 1: two triangles, tan(omega/2) =
   a.(b x c)/(|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|) [Van Oosterom 1983]. The triple product is the square's area:
   nothing cancels, however small the square. */
PRT__STATIC double prt__square_solid_angle(double u, double v, double e) {
    double x0 = u - e, x1 = u + e, y0 = v - e, y1 = v + e, area = 4 * e * e;
    double a = sqrt(x0 * x0 + y0 * y0 + 1), b = sqrt(x1 * x1 + y0 * y0 + 1), c = sqrt(x1 * x1 + y1 * y1 + 1);
    double d = sqrt(x0 * x0 + y1 * y1 + 1), ac = x0 * x1 + y0 * y1 + 1, ab = x0 * x1 + y0 * y0 + 1;
    double bc = x1 * x1 + y0 * y1 + 1, cd = x0 * x1 + y1 * y1 + 1, da = x0 * x0 + y0 * y1 + 1;
    return 2 * (atan2(area, a * b * c + ab * c + bc * a + ac * b) + atan2(area, a * c * d + ac * d + cd * a + da * c));
}

/* Row j of face pair 0 (x), 1 (y), 2 (z) with its images; rows and columns counted from the edges s = t = -1. OpenGL's
   table of face coordinates says in which images s and t are negative. */
PRT__STATIC void prt__cubemap_images(int size, const float *const faces[6], int pair, int j, prt__images *images) {
    int k;
    for (k = 0; k < 8; k++) {
        int x = k & 1, y = k >> 1 & 1, z = k >> 2;
        int s_negative = pair == 0 ? z == x : pair == 1 ? x : x ^ z;
        int t_negative = pair == 1 ? z ^ y : !y;
        size_t row = (size_t)(t_negative ? j : size - 1 - j), column = (size_t)(s_negative ? 0 : size - 1);
        images->texel[k] = faces[2 * pair + (k >> pair & 1)] + 3 * (row * (size_t)size + column);
        images->step[k] = s_negative ? 3 : -3;
    }
}

/* For one order: p(l,m) upwards in l over a block, and its six dot products with re, im times the folded values. */
PRT__STATIC void prt__gather_order(prt__gather *g, int m, const prt__octant *block, const double *re,
                                   const double *im) {
    double value[2][6][PRT__TEXELS], p[PRT__TEXELS], p1[PRT__TEXELS];
    int row = m - g->first, even = m & 1, odd = 3 - even, i, k, l;     /* classes of cos m phi and sin m phi */
    for (k = 0; k < 3; k++)
        for (i = 0; i < block->lanes; i++) {
            value[0][k][i] = re[i] * block->value[even][k][i];
            value[0][3 + k][i] = im[i] * block->value[odd][k][i];
            value[1][k][i] = re[i] * block->value[even + 4][k][i];
            value[1][3 + k][i] = im[i] * block->value[odd + 4][k][i];
        }
    for (i = 0; i < block->lanes; i++) { p[i] = g->sector[row]; p1[i] = 0; }
    for (l = m; l < g->bands; l++) {
        double (*part)[PRT__TEXELS] = value[(l - m) & 1];
        double a = l + 1 < g->bands ? g->a[row][l + 1] : 0, b = l + 1 < g->bands ? g->b[row][l + 1] : 0;
        prt__wide acc[6];
        memset(acc, 0, sizeof acc);
        for (i = 0; i < block->lanes; i += PRT__WIDE_LANES) {
            prt__wide q = prt__wide_load(p + i);
            for (k = 0; k < 6; k++) acc[k] += q * prt__wide_load(part[k] + i);
            prt__wide_store(p + i, a * prt__wide_load(block->z + i) * q - b * prt__wide_load(p1 + i));
            prt__wide_store(p1 + i, q);
        }
        prt__wide_add6(acc, g->sum[row][l]);
    }
}

PRT__STATIC void prt__gather_octant(prt__gather *g, const prt__octant *block) {
    double re[PRT__TEXELS], im[PRT__TEXELS];
    int m, i;
    for (i = 0; i < block->lanes; i++) { re[i] = 1; im[i] = 0; }
    for (m = 0; m < g->last; m++) {
        if (m >= g->first) prt__gather_order(g, m, block, re, im);
        for (i = 0; i < block->lanes; i++) {
            double t = re[i] * block->x[i] - im[i] * block->y[i];
            im[i] = re[i] * block->y[i] + im[i] * block->x[i];
            re[i] = t;
        }
    }
}

/* Texels from ... from+count-1 of row j, seen by face pair 0: their directions in the octant, and solid angles. */
PRT__STATIC void prt__cubemap_block(int size, int j, int from, int count, double (*dir)[PRT__TEXELS], double *weight) {
    double v = (size - 1.0 - 2 * j) / size;
    int i;
    memset(dir, 0, 3 * sizeof *dir);
    memset(weight, 0, PRT__TEXELS * sizeof *weight);
    for (i = 0; i < count; i++) {
        int column = from + i;
        double u = (size - 1.0 - 2 * column) / size, r = 1 / sqrt(1 + u * u + v * v);
        dir[0][i] = r;
        dir[1][i] = v * r;
        dir[2][i] = u * r;
        weight[i] = prt__square_solid_angle(u, v, 1.0 / size);
        if (2 * column + 1 == size) weight[i] /= 2;                    /* its own image in the middle of an odd size */
        if (2 * j + 1 == size) weight[i] /= 2;
    }
}

PRT__STATIC void prt__gather_cubemap(prt__gather *g, int size, const float *const faces[6]) {
    /* which of major axis, t and s a face pair sees along x, y, z */
    static const unsigned char axis[3][3] = { { 0, 1, 2 }, { 2, 0, 1 }, { 2, 1, 0 } };
    double dir[3][PRT__TEXELS], weight[PRT__TEXELS];
    int half = size / 2 + size % 2, from, count, j, pair;
    prt__images images;
    prt__octant block;
    for (j = 0; j < half; j++)
        for (from = 0; from < half; from += count) {
            count = half - from < PRT__TEXELS ? half - from : PRT__TEXELS;
            prt__cubemap_block(size, j, from, count, dir, weight);
            for (pair = 0; pair < 3; pair++) {
                memcpy(block.x, dir[axis[pair][0]], sizeof block.x);
                memcpy(block.y, dir[axis[pair][1]], sizeof block.y);
                memcpy(block.z, dir[axis[pair][2]], sizeof block.z);
                prt__cubemap_images(size, faces, pair, j, &images);
                prt__load_images(&images, from, count, &block);
                prt__fold_images(weight, &block);
                prt__gather_octant(g, &block);
            }
        }
}

PRTDEF prt_result prt_sh_project_cubemap_rgb(int bands, int size, const float *const faces[6], prt_real *light) {
    prt__gather g;
    int first, face;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (size < 1 || (size_t)size > SIZE_MAX / (3 * sizeof **faces) / (size_t)size) return PRT_ERR_COUNT;
    if (!faces || !light) return PRT_ERR_NULL;
    for (face = 0; face < 6; face++)
        if (!faces[face]) return PRT_ERR_NULL;
    for (first = 0; first < bands; first += PRT__ORDERS) {
        prt__gather_start(&g, bands, first);
        prt__gather_cubemap(&g, size, faces);
        if (first == 0 && !prt__gather_finite(&g)) return PRT_ERR_VALUE;
        prt__gather_write(&g, light);
    }
    return PRT_OK;
}

PRTDEF prt_result prt_sh_convolve(int bands, const prt_real *f, const prt_real *zonal, prt_real *out) {
    double factor[PRT_MAX_BANDS];
    int l;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !zonal || !out) return PRT_ERR_NULL;
    for (l = 0; l < bands; l++) factor[l] = 3.5449077018110320546 * prt__inverse_root(2 * l + 1) * (double)zonal[l];
    prt__scale_bands(bands, factor, f, out);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_irradiance(int bands, const prt_real *radiance, prt_real *out) {
    double factor[PRT_MAX_BANDS];
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!radiance || !out) return PRT_ERR_NULL;
    prt__cosine_factors(bands, factor);
    prt__scale_bands(bands, factor, radiance, out);
    return PRT_OK;
}

/* ----------------------------------------------------------------------------------------------- >>convert ---- */

/* The factor of the monomial 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2 in Y_i, times the cosine lobe's 1, 2/3, 1/4. */
static const double prt__irradiance_factor[9] = {
    0.28209479177387814347, 0.32573500793527994773, 0.32573500793527994773, 0.32573500793527994773,
    0.27313710764801976764, 0.27313710764801976764, 0.07884789131313000152, 0.27313710764801976764,
    0.13656855382400988382
};

PRT__INLINE int prt__is_irradiance(prt_sh_convention c) {
    return c == PRT_CONVENTION_UNITY || c == PRT_CONVENTION_FILAMENT_IRRADIANCE;
}
PRT__INLINE int prt__has_phase(prt_sh_convention c) {
    return c >= PRT_CONVENTION_DIRECTX && c <= PRT_CONVENTION_FILAMENT;
}
PRT__INLINE int prt__is_convention(prt_sh_convention c) {
    return (unsigned)c <= (unsigned)PRT_CONVENTION_UNITY;
}

PRTDEF prt_result prt_sh_convert(int bands, prt_sh_convention from, prt_sh_convention to, const prt_real *f,
                                 prt_real *out) {
    int l, m, undo = prt__is_irradiance(from), apply = prt__is_irradiance(to);
    int flip = prt__has_phase(from) != prt__has_phase(to);
    if (!prt__bands_ok(bands) || ((undo || apply) && bands > 3)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    if (!prt__is_convention(from) || !prt__is_convention(to)) return PRT_ERR_VALUE;
    for (l = 0; l < bands; l++) {
        for (m = -l; m <= l; m++) {
            int i = PRT_SH_INDEX(l, m);
            prt_real v = flip && (m & 1) ? -f[i] : f[i];
            if (undo && !apply) v /= PRT__R(prt__irradiance_factor[i]);
            if (apply && !undo) v *= PRT__R(prt__irradiance_factor[i]);
            out[i] = v;
        }
    }
    return PRT_OK;
}

PRTDEF prt_result prt_sh_pack_irradiance(int bands, const prt_real *light, prt_real constants[28]) {
    int c, i, n;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!light || !constants) return PRT_ERR_NULL;
    n = PRT_SH_COUNT(bands < 3 ? bands : 3);
    for (c = 0; c < 3; c++) {
        const prt_real *plane = light + c * PRT_SH_COUNT(bands);
        prt_real *a = constants + 4 * c, *b = constants + 12 + 4 * c, q[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 };
        for (i = 0; i < n; i++) q[i] = plane[i] * PRT__R(prt__irradiance_factor[i]);
        a[0] = q[3]; a[1] = q[1]; a[2] = q[2]; a[3] = q[0] - q[6];
        b[0] = q[4]; b[1] = q[5]; b[2] = 3 * q[6]; b[3] = q[7];
        constants[24 + c] = q[8];
    }
    constants[27] = 1;
    return PRT_OK;
}

PRTDEF prt_result prt_sh_unpack_irradiance(const prt_real constants[28], prt_real light[27]) {
    int c, i;
    if (!constants || !light) return PRT_ERR_NULL;
    for (c = 0; c < 3; c++) {
        const prt_real *a = constants + 4 * c, *b = constants + 12 + 4 * c;
        prt_real *q = light + 9 * c, third = b[2] / 3;
        q[0] = a[3] + third; q[1] = a[1]; q[2] = a[2]; q[3] = a[0];
        q[4] = b[0]; q[5] = b[1]; q[6] = third; q[7] = b[3]; q[8] = constants[24 + c];
        for (i = 0; i < 9; i++) q[i] /= PRT__R(prt__irradiance_factor[i]);
    }
    return PRT_OK;
}

/* Which pair a letter belongs to (1 right-left, 2 up-down, 3 forward-backward), negative for the second of the pair;
   0 for anything else. */
PRT__STATIC int prt__axis_letter(char letter) {
    switch (letter) {
    case 'R': return 1;
    case 'L': return -1;
    case 'U': return 2;
    case 'D': return -2;
    case 'F': return 3;
    case 'B': return -3;
    default:  return 0;
    }
}

PRT__INLINE int prt__axis_of(int signed_axis) { return signed_axis < 0 ? -signed_axis : signed_axis; }

PRT__STATIC int prt__is_signed_permutation(const int axes[3]) {
    int k, seen = 0;
    for (k = 0; k < 3; k++) {
        if (axes[k] < -3 || axes[k] > 3 || axes[k] == 0) return 0;
        seen |= 1 << prt__axis_of(axes[k]);
    }
    return seen == 14;
}

/* Three letters and no more as a signed permutation; 0 if they are not one. */
PRT__STATIC int prt__parse_axes(const char *letters, int axes[3]) {
    int k;
    for (k = 0; k < 3; k++)
        if ((axes[k] = prt__axis_letter(letters[k])) == 0) return 0;
    return letters[3] == '\0' && prt__is_signed_permutation(axes);
}

PRTDEF prt_result prt_axes_map(const char *from, const char *to, int axes[3]) {
    int source[3], target[3], k, j;
    if (!from || !to || !axes) return PRT_ERR_NULL;
    if (!prt__parse_axes(from, source) || !prt__parse_axes(to, target)) return PRT_ERR_VALUE;
    for (k = 0; k < 3; k++)
        for (j = 0; j < 3; j++)
            if (prt__axis_of(source[j]) == prt__axis_of(target[k])) axes[k] = source[j] == target[k] ? j + 1 : -(j + 1);
    return PRT_OK;
}

PRTDEF prt_vec3 prt_map_axes(const int axes[3], prt_vec3 v) {
    prt_real old[4], mapped[3] = { 0, 0, 0 };
    prt_vec3 out;
    int k;
    old[0] = 0; old[1] = v.x; old[2] = v.y; old[3] = v.z;
    if (axes && prt__is_signed_permutation(axes))
        for (k = 0; k < 3; k++) mapped[k] = axes[k] < 0 ? -old[-axes[k]] : old[axes[k]];
    out.x = mapped[0]; out.y = mapped[1]; out.z = mapped[2];
    return out;
}

/* g(y,x,z) = f(x,y,z) in place: (y+ix)^m = i^m conj((x+iy)^m). */
PRT__STATIC void prt__sh_swap_xy(int bands, prt_real *f) {
    int l, m;
    for (l = 1; l < bands; l++) {
        for (m = 1; m <= l; m++) {
            prt_real *c = f + PRT_SH_INDEX(l, m), *s = f + PRT_SH_INDEX(l, -m), t = *c;
            if (m & 1) { *c = m & 2 ? -*s : *s; *s = m & 2 ? -t : t; }
            else if (m & 2) *c = -t;
            else *s = -*s;
        }
    }
}

/* Negates what is odd under each reflected axis, in place. Cosines (m >= 0) are even in y, sines odd; x has parity
   (-1)^m, the other way round for sines; z has (-1)^(l+m). */
PRT__STATIC void prt__sh_reflect(int bands, int x, int y, int z, prt_real *f) {
    int l, m;
    for (l = 0; l < bands; l++) {
        for (m = -l; m <= l; m++) {
            int sine = m < 0, odd = (x && ((m & 1) != sine)) + (y && sine) + (z && ((l + m) & 1));
            if (odd & 1) f[PRT_SH_INDEX(l, m)] = -f[PRT_SH_INDEX(l, m)];
        }
    }
}

/* Adds d, with its sign, at the two places of the symmetric y-z swap of band l that the orders hi >= lo >= 0 own:
   parity in y and in z trade places, so they join two cosines, two sines, or a sine and a cosine. */
PRT__STATIC void prt__swap_yz_entry(int l, int hi, int lo, double d, const double *f, double *g) {
    int hi_even = !((l + hi) & 1), lo_even = !((l + lo) & 1), row, column, turns;
    if (!lo_even && lo_even == hi_even) { row = -hi; column = -lo; turns = hi - lo; }
    else if (lo_even == hi_even)        { row = hi;  column = lo;  turns = hi - lo; }
    else if (hi_even)                   { row = -hi; column = lo;  turns = hi - lo - 1; }
    else                                { row = -lo; column = hi;  turns = hi - lo + 1; }
    if (lo == 0 && !hi_even) return;                                        /* there is no sine of order 0 */
    if (turns & 2) d = -d;
    g[row] += d * f[column];
    if (row != column) g[column] += d * f[row];
}

/* g(x,z,y) = f(x,y,z) for one band, f and g centred on m = 0. The entries are D(hi,lo) of Wigner's d(pi/2) by
   [Trapani 2006]: D(l,m) = 2^-l sqrt(binomial(2l, l+m)), then downwards in the first order, stable for hi >= lo. */
PRT__STATIC void prt__sh_swap_yz_band(int l, const double *f, double *g) {
    double c[PRT_MAX_BANDS + 1], top = 1;                                                      /* top = D(l,lo) */
    int lo, k;
    for (k = 0; k <= l; k++) c[k] = sqrt((double)(l - k) * (l + k + 1));
    for (k = 1; k <= l; k++) top *= sqrt((2.0 * k - 1) / (2.0 * k));
    for (k = -l; k <= l; k++) g[k] = 0;
    for (lo = 0; lo <= l; lo++) {
        double d = top, above = 0, weight = lo ? 2 : PRT__SQRT2;
        prt__swap_yz_entry(l, l, lo, l ? weight * d : d, f, g);
        for (k = l - 1; k >= lo; k--) {
            double next = (2 * lo * d - c[k + 1] * above) / c[k];
            above = d;
            d = next;
            prt__swap_yz_entry(l, k, lo, k ? weight * d : d, f, g);
        }
        top *= sqrt((double)(l - lo) / (l + lo + 1));
    }
}

/* g(x,z,y) = f(x,y,z) in place. */
PRT__STATIC void prt__sh_swap_yz(int bands, prt_real *f) {
    double in[2 * PRT_MAX_BANDS], out[2 * PRT_MAX_BANDS];
    int l, m;
    for (l = 1; l < bands; l++) {
        for (m = -l; m <= l; m++) in[l + m] = f[PRT_SH_INDEX(l, m)];
        prt__sh_swap_yz_band(l, in + l, out + l);
        for (m = -l; m <= l; m++) f[PRT_SH_INDEX(l, m)] = PRT__R(out[l + m]);
    }
}

PRTDEF prt_result prt_sh_map_axes(int bands, const int axes[3], const prt_real *f, prt_real *out) {
    int x, z;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!axes || !f || !out) return PRT_ERR_NULL;
    if (!prt__is_signed_permutation(axes)) return PRT_ERR_VALUE;
    if (f != out) memmove(out, f, (size_t)PRT_SH_COUNT(bands) * sizeof *f);
    x = prt__axis_of(axes[0]);
    z = prt__axis_of(axes[2]);
    if (z == 1) { prt__sh_swap_xy(bands, out); x = x == 2 ? 1 : x; }         /* old x stands on y now, old y on x */
    if (z != 3) { prt__sh_swap_yz(bands, out); x = x == 3 ? 2 : x; }         /* new z is right, old z stands on y */
    if (x == 2) prt__sh_swap_xy(bands, out);
    prt__sh_reflect(bands, axes[0] < 0, axes[1] < 0, axes[2] < 0, out);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_convert_axes(int bands, const char *from, const char *to, const prt_real *f, prt_real *out) {
    int axes[3] = { 1, 2, 3 };
    prt_result r;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    r = prt_axes_map(from, to, axes);
    return r == PRT_OK ? prt_sh_map_axes(bands, axes, f, out) : r;
}

/* ------------------------------------------------------------------------------------------------ >>window ---- */

/* The sharpest non-negative kernel of degree width-1 as the product of two Legendre series with coefficients >= 0.
   By Christoffel-Darboux at the root z*: degree 2k is a(z)^2 with a_i = (2i+1) P_i(z*); degree 2k+1 is a(z) b(z)
   with a = P^(0,1)_k+1/(z-z*), a_i = (2i+1)(P_i + (-1)^(k-i) P_k+1)(z*), and b = (1+z) a, b_i = ((i+1)(P_i + P_i+1)
   + i(P_i-1 + P_i))(z*); there P_k+1 + P_k+2 = 0 at z*. w[r] = (1/2)_r/r!. */
typedef struct prt__kernel {
    int a_count, b_count;
    double a[PRT_MAX_BANDS / 2 + 2], b[PRT_MAX_BANDS / 2 + 2], w[PRT_MAX_BANDS + 1];
} prt__kernel;

/* P_0 ... P_count-1 at z = 1-h, by differences, so that they keep their accuracy near z = 1. */
PRT__STATIC void prt__legendre_row(int count, double h, double *p) {
    double step = 0;
    int l;
    p[0] = 1;
    for (l = 0; l + 1 < count; l++) {
        step = (l * step - (2 * l + 1) * h * p[l]) / (l + 1);
        p[l + 1] = p[l] + step;
    }
}

/* h = 1-z at the largest root of P_n, or of P_n + P_n+1 (`paired`); p: P_0 ... P_n+1 there. Newton from its
   asymptote. */
PRT__STATIC void prt__legendre_root(int n, int paired, double *p) {
    double angle = 2.404825557695773 / (n + (paired ? 1 : 0.5)), sine = sin(angle / 2), h = 2 * sine * sine;
    int step;
    for (step = 0; step < 5; step++) {
        double value, slope;
        prt__legendre_row(n + 2, h, p);
        value = paired ? p[n] + p[n + 1] : p[n];
        slope = n * (p[n - 1] - (1 - h) * p[n]);                       /* (1-z^2) dP/dz */
        if (paired) slope += (n + 1) * (p[n] - (1 - h) * p[n + 1]);
        h += value / slope * h * (2 - h);
    }
    prt__legendre_row(n + 2, h, p);
}

PRT__STATIC void prt__positive_kernel(int width, prt__kernel *kernel) {
    double p[PRT_MAX_BANDS / 2 + 3];
    int k = (width - 1) / 2, paired = (width - 1) % 2, i;
    prt__legendre_root(k + 1, paired, p);
    kernel->a_count = k + 1;
    kernel->b_count = k + 1 + paired;
    for (i = 0; i <= k; i++) {
        double end = paired ? ((k - i) % 2 ? -p[k + 1] : p[k + 1]) : 0;
        kernel->a[i] = (2 * i + 1) * (p[i] + end);
        kernel->b[i] = paired ? (i + 1) * (p[i] + p[i + 1]) + (i > 0 ? i * (p[i - 1] + p[i]) : 0) : kernel->a[i];
    }
    if (paired) kernel->b[k + 1] = (k + 1) * (p[k] + p[k + 1]);
    kernel->w[0] = 1;
    for (i = 1; i <= width; i++) kernel->w[i] = kernel->w[i - 1] * (2 * i - 1) / (2 * i);
}

/* Half the Legendre moment int a b P_l dz: a sum of positive terms, (1/2) int P_i P_j P_l dz =
   w(s-i) w(s-j) w(s-l)/((2s+1) w(s)), s = (i+j+l)/2 [Adams 1878]. */
PRT__STATIC double prt__kernel_moment(const prt__kernel *kernel, int l) {
    const double *w = kernel->w;
    double sum = 0;
    int i, j;
    for (i = 0; i < kernel->a_count; i++) {
        double row = 0;
        int last = i + l < kernel->b_count ? i + l : kernel->b_count - 1;
        for (j = i > l ? i - l : l - i; j <= last; j += 2) {
            int s = (i + j + l) / 2;
            row += kernel->b[j] * w[s - i] * w[s - j] * w[s - l] / ((2 * s + 1) * w[s]);
        }
        sum += kernel->a[i] * row;
    }
    return sum;
}

/* The weights of bands 0 ... count-1; count <= width. */
PRT__STATIC void prt__positive_weights(int width, int count, double *weight) {
    prt__kernel kernel;
    double mean;
    int l;
    prt__positive_kernel(width, &kernel);
    mean = prt__kernel_moment(&kernel, 0);
    for (l = 0; l < count; l++) weight[l] = prt__kernel_moment(&kernel, l) / mean;
}

/* cos^2 and sin of the smaller angle, from whichever end: the last weights keep their digits. */
PRT__STATIC double prt__hann(int l, int width) {
    double root = l < width - l ? cos(PRT__PI * l / (2.0 * width)) : sin(PRT__PI * (width - l) / (2.0 * width));
    return root * root;
}

PRT__STATIC double prt__lanczos(int l, int width) {
    int small = l < width - l ? l : width - l;
    return l == 0 ? 1 : sin(PRT__PI * small / width) / (PRT__PI * l / width);
}

PRT__STATIC int prt__window_ok(prt_window w) { return (unsigned)w <= (unsigned)PRT_WINDOW_POSITIVE; }
PRT__STATIC int prt__window_width_ok(prt_window w, int width) {
    return width >= 1 && (w != PRT_WINDOW_POSITIVE || width <= PRT_MAX_BANDS);
}

enum { PRT__WINDOW_TABLES = 16 };                                      /* generated: weights to this width */
static const double *prt__window_hann(void), *prt__window_lanczos(void), *prt__window_positive(void);

/* The weights of a window that is tabulated, or NULL */
PRT__STATIC const double *prt__window_row(prt_window w, int width) {
    int first = width * (width - 1) / 2;
    if (width > PRT__WINDOW_TABLES) return NULL;
    switch (w) {
        case PRT_WINDOW_HANN:     return prt__window_hann() + first;
        case PRT_WINDOW_LANCZOS:  return prt__window_lanczos() + first;
        case PRT_WINDOW_POSITIVE: return prt__window_positive() + first;
        case PRT_WINDOW_NONE: default: return NULL;
    }
}

/* The weights of bands 0 ... bands-1. */
PRT__STATIC void prt__window_weights(prt_window w, int width, int bands, double *weight) {
    int l, kept = bands < width ? bands : width;
    const double *row = prt__window_row(w, width);
    if (row) for (l = 0; l < kept; l++) weight[l] = row[l];
    else if (w == PRT_WINDOW_POSITIVE) prt__positive_weights(width, kept, weight);
    else
        for (l = 0; l < kept; l++)
            weight[l] = w == PRT_WINDOW_HANN ? prt__hann(l, width) :
                        w == PRT_WINDOW_LANCZOS ? prt__lanczos(l, width) : 1;
    for (l = kept; l < bands; l++) weight[l] = 0;
}

PRTDEF prt_real prt_window_weight(prt_window w, int l, int width) {
    prt__kernel kernel;
    const double *row;
    if (!prt__window_ok(w) || !prt__window_width_ok(w, width) || l < 0 || l >= width) return 0;
    row = prt__window_row(w, width);
    if (row) return (prt_real)row[l];
    switch (w) {
        case PRT_WINDOW_HANN:    return (prt_real)prt__hann(l, width);
        case PRT_WINDOW_LANCZOS: return (prt_real)prt__lanczos(l, width);
        case PRT_WINDOW_POSITIVE:
            prt__positive_kernel(width, &kernel);
            return (prt_real)(prt__kernel_moment(&kernel, l) / prt__kernel_moment(&kernel, 0));
        case PRT_WINDOW_NONE: default: return 1;
    }
}

PRTDEF prt_result prt_sh_window(int bands, prt_window w, int width, const prt_real *f, prt_real *out) {
    double weight[PRT_MAX_BANDS];
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!prt__window_width_ok(w, width)) return PRT_ERR_COUNT;
    if (!f || !out) return PRT_ERR_NULL;
    if (!prt__window_ok(w)) return PRT_ERR_VALUE;
    prt__window_weights(w, width, bands, weight);
    prt__scale_bands(bands, weight, f, out);
    return PRT_OK;
}

/* ---- the least value of a function ---- */

enum { PRT__BASINS = 8 };
typedef struct prt__basin { prt_vec3 dir; prt_real value; } prt__basin;

/* Keeps the lowest basins; directions closer than half a wavelength of the highest band are one basin. */
PRT__STATIC int prt__basin_insert(prt__basin *basins, int count, prt__basin b, prt_real near) {
    int i, highest = 0;
    for (i = 0; i < count; i++) {
        if (prt__dot3(basins[i].dir, b.dir) > near) {
            if (b.value < basins[i].value) basins[i] = b;
            return count;
        }
        if (basins[i].value > basins[highest].value) highest = i;
    }
    if (count < PRT__BASINS) { basins[count] = b; return count + 1; }
    if (b.value < basins[highest].value) basins[highest] = b;
    return count;
}

/* d moved by x and y along two tangents */
PRT__STATIC prt_vec3 prt__beside(prt_vec3 d, prt_real x, prt_real y) {
    prt_vec3 a, b, r;
    prt_real length;
    if (prt__abs(d.z) < PRT__R(0.8)) { a.x = d.y; a.y = -d.x; a.z = 0; }
    else { a.x = 0; a.y = d.z; a.z = -d.y; }
    length = prt__sqrt(prt__dot3(a, a));
    a.x /= length; a.y /= length; a.z /= length;
    b.x = d.y * a.z - d.z * a.y; b.y = d.z * a.x - d.x * a.z; b.z = d.x * a.y - d.y * a.x;
    r.x = d.x + x * a.x + y * b.x; r.y = d.y + x * a.y + y * b.y; r.z = d.z + x * a.z + y * b.z;
    length = prt__sqrt(prt__dot3(r, r));
    r.x /= length; r.y /= length; r.z /= length;
    return r;
}

PRT__STATIC int prt__basin_try(int bands, const prt_real *f, prt__basin *b, prt_vec3 from, prt_real x, prt_real y) {
    prt__basin other;
    other.dir = prt__beside(from, x, y);
    other.value = prt_sh_at(bands, f, other.dir);
    if (!(other.value < b->value)) return 0;
    *b = other;
    return 1;
}

/* A Newton step from differences over h, along the principal curvatures: in a valley, as zonal functions have, the one
   that is flat says nothing and must not spoil the other. */
PRT__STATIC void prt__basin_newton(int bands, const prt_real *f, prt__basin *b, prt_real h) {
    prt_vec3 d = b->dir;
    double v = (double)b->value;
    double px = (double)prt_sh_at(bands, f, prt__beside(d, h, 0)), mx = (double)prt_sh_at(bands, f, prt__beside(d, -h, 0));
    double py = (double)prt_sh_at(bands, f, prt__beside(d, 0, h)), my = (double)prt_sh_at(bands, f, prt__beside(d, 0, -h));
    double pp = (double)prt_sh_at(bands, f, prt__beside(d, h, h));
    double gx = (px - mx) / 2, gy = (py - my) / 2, xx = px + mx - 2 * v, yy = py + my - 2 * v;
    double xy = pp - v - gx - gy - (xx + yy) / 2, half = (xx - yy) / 2, spread = sqrt(half * half + xy * xy);
    double steep = (xx + yy) / 2 + spread, flat = (xx + yy) / 2 - spread, turn = atan2(xy, half) / 2;
    double c = cos(turn), s = sin(turn), along, across;
    if (!(steep > 0)) return;
    along = -(c * gx + s * gy) / steep;
    across = flat > 1e-3 * steep ? (s * gx - c * gy) / flat : 0;
    if (along * along + across * across < 16)
        prt__basin_try(bands, f, b, d, (prt_real)(c * along - s * across) * h, (prt_real)(s * along + c * across) * h);
}

/* Downhill: a pattern search until the steps are short beside the highest band's waves, then Newton. The search ends by
   itself, long before the rounds do, but where comparisons with NaN lie, as they may under -ffast-math. */
PRT__STATIC void prt__basin_descend(int bands, const prt_real *f, prt__basin *b) {
    prt_real step = PRT__R(0.5) / (prt_real)bands, last = PRT__R(0.03) / (prt_real)bands, h;
    int k, rounds;
    for (rounds = 0; rounds < 256 && step > last; rounds++) {
        prt_vec3 from = b->dir;
        int moved = prt__basin_try(bands, f, b, from, step, 0) | prt__basin_try(bands, f, b, from, -step, 0) |
                    prt__basin_try(bands, f, b, from, 0, step) | prt__basin_try(bands, f, b, from, 0, -step);
        if (!moved) step /= 2;
    }
    for (k = 0, h = last; k < 3; k++, h /= 8) prt__basin_newton(bands, f, b, h);
}

PRT__STATIC prt__basin prt__sh_lowest(int bands, const prt_real *f) {
    prt__basin basins[PRT__BASINS], b;
    int count = 16 * PRT_SH_COUNT(bands), found = 1, i;
    prt_real near = (prt_real)cos(PRT__PI / (2 * bands));
    basins[0].dir = prt__vec3(0, 0, 1);
    basins[0].value = prt_sh_at(bands, f, basins[0].dir);
    for (i = 0; i < count; i++) {
        double z = 1 - (2 * i + 1.0) / count, radius = sqrt((1 - z) * (1 + z)), turn = 2.39996322972865332 * i;
        b.dir = prt__vec3((prt_real)(radius * cos(turn)), (prt_real)(radius * sin(turn)), (prt_real)z);
        b.value = prt_sh_at(bands, f, b.dir);
        found = prt__basin_insert(basins, found, b, near);
    }
    b = basins[0];
    for (i = 0; i < found; i++) {
        prt__basin_descend(bands, f, &basins[i]);
        if (basins[i].value < b.value) b = basins[i];
    }
    return b;
}

PRTDEF prt_real prt_sh_minimum(int bands, const prt_real *f, prt_vec3 *dir) {
    prt__basin lowest;
    if (!prt__bands_ok(bands) || !f) return 0;
    lowest = prt__sh_lowest(bands, f);
    if (dir) *dir = lowest.dir;
    return lowest.value;
}

/* ---- deringing ---- */

/* A few rounding errors of a value of f: eps times a bound on |f| */
PRT__STATIC prt_real prt__dering_margin(int bands, const prt_real *f) {
    double bound = 0;
    int l, i = 0;
    for (l = 0; l < bands; l++) {
        double sum = 0;
        for (; i < PRT_SH_COUNT(l + 1); i++) sum += (double)f[i] * (double)f[i];
        bound += sqrt(sum * (2 * l + 1) / (4 * PRT__PI));
    }
    return (prt_real)(4 * PRT__EPS * bound);
}

/* The strength in 0 ... 1 that lifts every value of f to at least 0, or a number above 1 where there is none. P f in
   smooth; out is scratch. The lowest value as a function of the strength is concave, the root of its tangent lies below. */
PRT__STATIC double prt__dering_blend(int bands, const prt_real *f, const prt_real *smooth, prt_real *out) {
    double margin = (double)prt__dering_margin(bands, f), s = 0;
    int round, i;
    for (round = 0; round < 12; round++) {
        prt__basin lowest;
        double before, after, next;
        for (i = 0; i < PRT_SH_COUNT(bands); i++) out[i] = (prt_real)((1 - s) * (double)f[i] + s * (double)smooth[i]);
        lowest = prt__sh_lowest(bands, out);
        if (lowest.value >= 0) break;
        before = (double)prt_sh_at(bands, f, lowest.dir);
        after = (double)prt_sh_at(bands, smooth, lowest.dir);
        if (after <= before || after < 0) return 2;
        next = (margin - before) / (after - before);
        s = next > s ? next : s + PRT__EPS;
        if (s > 1) return 2;
    }
    return s;
}

/* The weights of a strength */
PRT__STATIC void prt__dering_weights(int bands, double strength, double *weight) {
    int l;
    prt__window_weights(PRT_WINDOW_POSITIVE, bands, bands, weight);
    for (l = 1; l < bands; l++)
        weight[l] = strength <= 1 ? 1 - strength + strength * weight[l] : (2 - strength) * weight[l];
}

PRT__STATIC double prt__dering_strength(int bands, const prt_real *f) {
    prt_real smooth[PRT_SH_COUNT(PRT_MAX_BANDS)], scratch[PRT_SH_COUNT(PRT_MAX_BANDS)];
    double weight[PRT_MAX_BANDS], s, mean = (double)f[0] * 0.28209479177387814, lowest;
    int i, empty = 1;
    for (i = 1; i < PRT_SH_COUNT(bands); i++) empty &= f[i] == 0;
    if (f[0] < 0 || (f[0] == 0 && !empty)) return 2;
    if (empty) return 0;
    weight[0] = 1;                     /* or gcc -O3 thinks that the next line may leave it empty */
    prt__window_weights(PRT_WINDOW_POSITIVE, bands, bands, weight);
    prt__scale_bands(bands, weight, f, smooth);
    s = prt__dering_blend(bands, f, smooth, scratch);
    if (s <= 1) return s;
    lowest = (double)prt__sh_lowest(bands, smooth).value - (double)prt__dering_margin(bands, smooth);
    return lowest >= 0 ? 1 : 2 - mean / (mean - lowest);
}

PRTDEF prt_result prt_sh_dering(int bands, const prt_real *f, prt_real *out, prt_real *strength) {
    double weight[PRT_MAX_BANDS], s;
    int i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    for (i = 0; i < PRT_SH_COUNT(bands); i++)
        if (!prt__finite(f[i])) return PRT_ERR_VALUE;
    s = prt__dering_strength(bands, f);
    prt__dering_weights(bands, s, weight);
    prt__scale_bands(bands, weight, f, out);
    if (strength) *strength = (prt_real)s;
    return PRT_OK;
}

/* ------------------------------------------------------------------------------------------------ >>rotate ---- */

/* |R R^T - 1| <= 1e-3 in every entry; an entry that is not finite fails. */
PRT__STATIC int prt__rotation_ok(const prt_real *r) {
    const prt_real tolerance = PRT__R(1e-3);
    prt_real xx = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] - 1, xy = r[0] * r[3] + r[1] * r[4] + r[2] * r[5];
    prt_real yy = r[3] * r[3] + r[4] * r[4] + r[5] * r[5] - 1, yz = r[3] * r[6] + r[4] * r[7] + r[5] * r[8];
    prt_real zz = r[6] * r[6] + r[7] * r[7] + r[8] * r[8] - 1, zx = r[6] * r[0] + r[7] * r[1] + r[8] * r[2];
    int i;
    for (i = 0; i < 9; i++)
        if (!prt__finite(r[i])) return 0;
    return prt__abs(xx) <= tolerance && prt__abs(yy) <= tolerance && prt__abs(zz) <= tolerance
        && prt__abs(xy) <= tolerance && prt__abs(yz) <= tolerance && prt__abs(zx) <= tolerance;
}

PRTDEF prt_result prt_rotation_from_quaternion(const prt_real q[4], prt_real rotation[9]) {
#ifdef PRT_DOUBLE
    typedef long double wide;                                   /* at least what it says: errors of R show l-fold */
#else
    typedef double wide;
#endif
    wide v[4], largest = 0, s = 0, w, x, y, z;
    int i;
    if (!q || !rotation) return PRT_ERR_NULL;
    for (i = 0; i < 4; i++) {
        if (!prt__finite(q[i])) return PRT_ERR_VALUE;
        if (prt__abs(q[i]) > largest) largest = prt__abs(q[i]);
    }
    if (largest == 0) return PRT_ERR_VALUE;
    for (i = 0; i < 4; i++) {
        v[i] = q[i] / largest;                                  /* no square overflows */
        s += v[i] * v[i];
    }
    s = 2 / s;
    w = v[0]; x = v[1]; y = v[2]; z = v[3];
    rotation[0] = (prt_real)(1 - s * (y * y + z * z));
    rotation[1] = (prt_real)(s * (x * y - w * z));
    rotation[2] = (prt_real)(s * (x * z + w * y));
    rotation[3] = (prt_real)(s * (x * y + w * z));
    rotation[4] = (prt_real)(1 - s * (x * x + z * z));
    rotation[5] = (prt_real)(s * (y * z - w * x));
    rotation[6] = (prt_real)(s * (x * z - w * y));
    rotation[7] = (prt_real)(s * (y * z + w * x));
    rotation[8] = (prt_real)(1 - s * (x * x + y * y));
    return PRT_OK;
}

PRT__INLINE size_t prt__block_offset(int l) { return (size_t)l * (4 * (size_t)l * (size_t)l - 1) / 3; }

PRTDEF size_t prt_sh_rotation_count(int bands) { return prt__bands_ok(bands) ? prt__block_offset(bands) : 0; }

/* A row of block l is a sum of at most five terms: factor * P_i(a), where P_i takes row a of block l-1 and row i of
   block 1. q and r point to the middle (column 0) of the two rows. */
typedef struct prt__rotation_term { prt_real factor; const prt_real *q, *r; } prt__rotation_term;

PRT__INLINE prt__rotation_term prt__rotation_row(int l, const prt_real *block1, const prt_real *last, int i, int a,
                                                 prt_real factor) {
    prt__rotation_term t;
    t.factor = factor;
    t.q = last + (a + l - 1) * (2 * l - 1) + (l - 1);
    t.r = block1 + (i + 1) * 3 + 1;
    return t;
}

/* The terms u U + v V + w W of row m, without the factor 1/sqrt(d) of the column; returns how many. */
PRT__STATIC int prt__rotation_terms(int l, int m, const prt_real *block1, const prt_real *last,
                                    prt__rotation_term *terms) {
    int n = 0, am = m < 0 ? -m : m, s = m < 0 ? -1 : 1;
    prt_real u = PRT__R(prt__root(l + m) * prt__root(l - m));
    prt_real v = PRT__R(0.5 * prt__root(l + am) * prt__root(l + am - 1) * (m == 0 ? -PRT__SQRT2 : 1));
    if (am < l) terms[n++] = prt__rotation_row(l, block1, last, 0, m, u);
    if (m == 0) {
        terms[n++] = prt__rotation_row(l, block1, last, 1, 1, v);
        terms[n++] = prt__rotation_row(l, block1, last, -1, -1, v);
        return n;
    }
    if (am == 1) {
        terms[n++] = prt__rotation_row(l, block1, last, s, 0, v * PRT__R(PRT__SQRT2));
    } else {
        terms[n++] = prt__rotation_row(l, block1, last, 1, m - s, v);
        terms[n++] = prt__rotation_row(l, block1, last, -1, s - m, -(prt_real)s * v);
    }
    if (am < l - 1) {
        prt_real w = PRT__R(-0.5 * prt__root(l - am - 1) * prt__root(l - am));
        terms[n++] = prt__rotation_row(l, block1, last, 1, m + s, w);
        terms[n++] = prt__rotation_row(l, block1, last, -1, -m - s, (prt_real)s * w);
    }
    return n;
}

/* Block l from blocks 1 and l-1. Inside |k| < 0.7 l every P_i(a) is r_i0 Q(a,k). Outside it is the form that
   [Ivanic 1996] uses for |k| = l only: taken in time, it is what keeps rounding errors from growing. */
PRT__STATIC void prt__rotation_block(int l, const prt_real *block1, const prt_real *last,
                                     prt_real *PRT__RESTRICT block) {
    prt_real scale[PRT_MAX_BANDS];                              /* 1/sqrt(d), the same for k and -k */
    int inner = (7 * l - 1) / 10, k, m;
    for (k = 0; k <= l; k++)
        scale[k] = PRT__R(prt__inverse_root(l + k) * prt__inverse_root(k <= inner ? l - k : l + k - 1));
    for (m = -l; m <= l; m++) {
        prt_real *PRT__RESTRICT row = block + (l + m) * (2 * l + 1) + l;
        prt__rotation_term terms[5];
        int count = prt__rotation_terms(l, m, block1, last, terms), t;
        for (k = -l; k <= l; k++) row[k] = 0;
        for (t = 0; t < count; t++) {
            const prt_real *q = terms[t].q;
            prt_real c0 = terms[t].factor * terms[t].r[0];
            prt_real cp = terms[t].factor * terms[t].r[1], cm = terms[t].factor * terms[t].r[-1];
            for (k = -inner; k <= inner; k++) row[k] += c0 * q[k];
            for (k = inner + 1; k <= l; k++) {
                row[k] += cp * q[k - 1] - cm * q[1 - k];
                row[-k] += cp * q[1 - k] + cm * q[k - 1];
            }
        }
        for (k = -l; k <= l; k++) row[k] *= scale[k < 0 ? -k : k];
    }
}

PRTDEF prt_result prt_sh_rotation(int bands, const prt_real rotation[9], prt_real *blocks) {
    static const unsigned char from[9] = { 4, 5, 3, 7, 8, 6, 1, 2, 0 };     /* block 1 = R in the order y, z, x */
    int l, i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!rotation || !blocks) return PRT_ERR_NULL;
    if (!prt__rotation_ok(rotation)) return PRT_ERR_ROTATION;
    blocks[0] = 1;
    if (bands > 1)
        for (i = 0; i < 9; i++) blocks[1 + i] = rotation[from[i]];
    for (l = 2; l < bands; l++)
        prt__rotation_block(l, blocks + 1, blocks + prt__block_offset(l - 1), blocks + prt__block_offset(l));
    return PRT_OK;
}

/* ---- blocks to vectors ---- */

#if PRT__QUADS
/* One vector at a time takes quads of a row of M times quads of f. The last of them ends with the row: what it has in
   common with the one before is 0 in f. */
PRT__INLINE prt__quad prt__last_quad(int size, const prt_real *f) {
    const prt__quad one = { 0, 0, 0, 1 }, three = { 0, 1, 1, 1 };           /* sizes are odd */
    return prt__quad_load(f + size - 4) * (size % 4 == 1 ? one : three);
}

PRT__INLINE prt__quad prt__row_times(int size, const prt_real *m, const prt__quad *f) {
    prt__quad sum = f[0] * prt__quad_load(m);
    int j;
    PRT__UNROLL
    for (j = 4; j < size; j += 4) sum += f[j / 4] * prt__quad_load(m + (j + 4 <= size ? j : size - 4));
    return sum;
}

PRT__INLINE prt__quad prt__sum_of_each(prt__quad *sum) {
    prt__quad_transpose(sum);
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* out = M f for one block of odd size, 5 ... 15, known when it is compiled; f is read before anything is written. */
PRT__INLINE void prt__block_times(int size, const prt_real *m, const prt_real *f, prt_real *out) {
    prt__quad in[4], sum[4];
    int r, j, rows = size % 4 == 1 ? size - 1 : size;
    PRT__UNROLL
    for (j = 0; j + 4 <= size; j += 4) in[j / 4] = prt__quad_load(f + j);
    in[j / 4] = prt__last_quad(size, f);
    PRT__UNROLL
    for (r = 0; r < rows; r += 4) {
        int row = r + 4 <= size ? r : size - 4;                                 /* the last may overlap */
        PRT__UNROLL
        for (j = 0; j < 4; j++) sum[j] = prt__row_times(size, m + (row + j) * size, in);
        prt__quad_store(out + row, prt__sum_of_each(sum));
    }
    if (rows < size) {
        sum[0] = prt__row_times(size, m + rows * size, in);
        out[rows] = (sum[0][0] + sum[0][1]) + (sum[0][2] + sum[0][3]);
    }
}

/* The same for any odd size >= 5. */
PRT__STATIC void prt__block_times_any(int size, const prt_real *m, const prt_real *f, prt_real *out) {
    prt__quad in[PRT_MAX_BANDS / 2 + 2], sum[4];
    int r, j, k;
    for (j = 0; j + 4 <= size; j += 4) in[j / 4] = prt__quad_load(f + j);
    in[j / 4] = prt__last_quad(size, f);
    for (r = 0; r < size; r += 4) {
        int row = r + 4 <= size ? r : size - 4;
        const prt_real *rows = m + row * size;
        PRT__UNROLL
        for (k = 0; k < 4; k++) sum[k] = in[0] * prt__quad_load(rows + k * size);
        for (j = 4; j < size; j += 4) {
            int at = j + 4 <= size ? j : size - 4;
            PRT__UNROLL
            for (k = 0; k < 4; k++) sum[k] += in[j / 4] * prt__quad_load(rows + k * size + at);
        }
        prt__quad_store(out + row, prt__sum_of_each(sum));
    }
}
#else
/* out = M f for one block, four rows at a time. */
PRT__STATIC void prt__block_times_any(int size, const prt_real *m, const prt_real *f, prt_real *out) {
    prt_real in[2 * PRT_MAX_BANDS];
    int r, j;
    memcpy(in, f, (size_t)size * sizeof *f);                                    /* so that out may be f */
    for (r = 0; r + 4 <= size; r += 4, m += 4 * size) {
        prt_real a = 0, b = 0, c = 0, d = 0;
        for (j = 0; j < size; j++) {
            a += m[j] * in[j];
            b += m[size + j] * in[j];
            c += m[2 * size + j] * in[j];
            d += m[3 * size + j] * in[j];
        }
        out[r] = a; out[r + 1] = b; out[r + 2] = c; out[r + 3] = d;
    }
    for (; r < size; r++, m += size)
        for (out[r] = 0, j = 0; j < size; j++) out[r] += m[j] * in[j];
}
#endif

PRTDEF prt_result prt_sh_rotate_by(int bands, const prt_real *blocks, const prt_real *f, prt_real *out) {
    prt_real x, y, z;
    int l, first = 2;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!blocks || !f || !out) return PRT_ERR_NULL;
    out[0] = blocks[0] * f[0];
    if (bands == 1) return PRT_OK;
    x = f[1]; y = f[2]; z = f[3];
    for (l = 1; l < 4; l++) out[l] = blocks[3 * l - 2] * x + blocks[3 * l - 1] * y + blocks[3 * l] * z;
#if PRT__QUADS
    first = 6;
    if (bands > 2) prt__block_times(5, blocks + prt__block_offset(2), f + 4, out + 4);
    if (bands > 3) prt__block_times(7, blocks + prt__block_offset(3), f + 9, out + 9);
    if (bands > 4) prt__block_times(9, blocks + prt__block_offset(4), f + 16, out + 16);
    if (bands > 5) prt__block_times(11, blocks + prt__block_offset(5), f + 25, out + 25);
#endif
    for (l = first; l < bands; l++)
        prt__block_times_any(2 * l + 1, blocks + prt__block_offset(l), f + l * l, out + l * l);
    return PRT_OK;
}

/* PRT__LANES vectors side by side: coefficient i of lane k at [i * PRT__LANES + k]. A matrix entry meets a whole
   prt__vec; registers of 16 bytes have no cheap way to repeat a number in all lanes, so there the entries are repeated
   in advance (prt__entry), up to PRT__ENTRY_BANDS bands. */
#if PRT__SIMD && PRT__VEC_BYTES == 16
typedef prt__vec prt__entry;
PRT__INLINE prt__entry prt__entry_of(prt_real m) { return prt__vec_set(m); }
#else
typedef prt_real prt__entry;
PRT__INLINE prt__entry prt__entry_of(prt_real m) { return m; }
#endif
enum { PRT__ENTRY_BANDS = 8, PRT__ENTRIES = PRT__ENTRY_BANDS * (4 * PRT__ENTRY_BANDS * PRT__ENTRY_BANDS - 1) / 3 };

/* sum = M v for four rows or fewer in all lanes, side by side: no sum waits for another. */
PRT__INLINE void prt__block_rows(int rows, int size, const prt__entry *m, const prt__vec *v, prt__vec *sum) {
    int r, j;
    PRT__UNROLL
    for (r = 0; r < rows; r++) sum[r] = m[r * size] * v[0];
    PRT__UNROLL
    for (j = 1; j < size; j++) {
        PRT__UNROLL
        for (r = 0; r < rows; r++) sum[r] += m[r * size + j] * v[j];
    }
}

/* out = M x for one block in all lanes, coefficients so many steps apart. With size known the input stays in registers;
   all of it is read before anything is written. */
PRT__INLINE void prt__block_lanes(int size, const prt__entry *m, const prt_real *x, size_t x_step, prt_real *out,
                                  size_t out_step) {
    prt__vec v[2 * PRT__ENTRY_BANDS - 1], sum[4];
    int r, i, rows;
    PRT__UNROLL
    for (i = 0; i < size; i++) v[i] = prt__vec_load(x + (size_t)i * x_step);
    PRT__UNROLL
    for (r = 0; r < size; r += 4) {
        rows = size - r < 4 ? size - r : 4;
        prt__block_rows(rows, size, m + r * size, v, sum);
        PRT__UNROLL
        for (i = 0; i < rows; i++) prt__vec_store(out + (size_t)(r + i) * out_step, sum[i]);
    }
}

typedef void prt__block_kernel(const prt__entry *m, const prt_real *x, size_t x_step, prt_real *out, size_t out_step);
#define PRT__BLOCK_KERNEL(l) \
    PRT__STATIC void prt__block_lanes_##l(const prt__entry *m, const prt_real *x, size_t x_step, prt_real *out, \
                                          size_t out_step) { \
        prt__block_lanes(2 * l + 1, m, x, x_step, out, out_step); \
    }
PRT__BLOCK_KERNEL(0) PRT__BLOCK_KERNEL(1) PRT__BLOCK_KERNEL(2) PRT__BLOCK_KERNEL(3)
PRT__BLOCK_KERNEL(4) PRT__BLOCK_KERNEL(5) PRT__BLOCK_KERNEL(6) PRT__BLOCK_KERNEL(7)
#undef PRT__BLOCK_KERNEL
static prt__block_kernel *const prt__block_kernels[PRT__ENTRY_BANDS] = {
    prt__block_lanes_0, prt__block_lanes_1, prt__block_lanes_2, prt__block_lanes_3,
    prt__block_lanes_4, prt__block_lanes_5, prt__block_lanes_6, prt__block_lanes_7
};

/* The same for a block of any size, which writes before it has read all. */
PRT__STATIC void prt__block_lanes_any(int size, const prt_real *m, const prt_real *x, size_t x_step, prt_real *out,
                                      size_t out_step) {
    int r, j;
    for (r = 0; r + 4 <= size; r += 4, m += 4 * size, out += 4 * out_step) {
        prt__vec a = prt__vec_set(0), b = a, c = a, d = a;
        for (j = 0; j < size; j++) {
            prt__vec v = prt__vec_load(x + (size_t)j * x_step);
            a += m[j] * v;
            b += m[size + j] * v;
            c += m[2 * size + j] * v;
            d += m[3 * size + j] * v;
        }
        prt__vec_store(out, a);
        prt__vec_store(out + out_step, b);
        prt__vec_store(out + 2 * out_step, c);
        prt__vec_store(out + 3 * out_step, d);
    }
    for (; r < size; r++, m += size, out += out_step) {
        prt__vec a = prt__vec_set(0);
        for (j = 0; j < size; j++) a += m[j] * prt__vec_load(x + (size_t)j * x_step);
        prt__vec_store(out, a);
    }
}

#if PRT__SIMD
/* Two-operand shuffles: lo and hi interleave single numbers within each 16 bytes, as the machines' unpack instructions
   do; block_lo and block_hi interleave whole blocks of 16 bytes. */
#if defined(__clang__) || __GNUC__ >= 12
#  define PRT__SHUFFLE(name, ...) \
    PRT__INLINE prt__vec name(prt__vec a, prt__vec b) { return __builtin_shufflevector(a, b, __VA_ARGS__); }
#else
#  ifdef PRT_DOUBLE
typedef int64_t prt__lane_index __attribute__((vector_size(PRT__VEC_BYTES)));
#  else
typedef int32_t prt__lane_index __attribute__((vector_size(PRT__VEC_BYTES)));
#  endif
#  define PRT__SHUFFLE(name, ...) \
    PRT__INLINE prt__vec name(prt__vec a, prt__vec b) { \
        const prt__lane_index lanes = { __VA_ARGS__ }; \
        return __builtin_shuffle(a, b, lanes); \
    }
#endif
#if PRT__LANES == 2
PRT__SHUFFLE(prt__lo, 0, 2)
PRT__SHUFFLE(prt__hi, 1, 3)
#elif PRT__LANES == 4 && PRT__VEC_BYTES == 16
PRT__SHUFFLE(prt__lo, 0, 4, 1, 5)
PRT__SHUFFLE(prt__hi, 2, 6, 3, 7)
#elif PRT__LANES == 4
PRT__SHUFFLE(prt__lo, 0, 4, 2, 6)
PRT__SHUFFLE(prt__hi, 1, 5, 3, 7)
PRT__SHUFFLE(prt__block_lo, 0, 1, 4, 5)
PRT__SHUFFLE(prt__block_hi, 2, 3, 6, 7)
#elif PRT__LANES == 8 && PRT__VEC_BYTES == 32
PRT__SHUFFLE(prt__lo, 0, 8, 1, 9, 4, 12, 5, 13)
PRT__SHUFFLE(prt__hi, 2, 10, 3, 11, 6, 14, 7, 15)
PRT__SHUFFLE(prt__block_lo, 0, 1, 2, 3, 8, 9, 10, 11)
PRT__SHUFFLE(prt__block_hi, 4, 5, 6, 7, 12, 13, 14, 15)
#elif PRT__LANES == 8
PRT__SHUFFLE(prt__lo, 0, 8, 2, 10, 4, 12, 6, 14)
PRT__SHUFFLE(prt__hi, 1, 9, 3, 11, 5, 13, 7, 15)
PRT__SHUFFLE(prt__block_lo, 0, 1, 8, 9, 2, 3, 10, 11)
PRT__SHUFFLE(prt__block_hi, 4, 5, 12, 13, 6, 7, 14, 15)
#else
PRT__SHUFFLE(prt__lo, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29)
PRT__SHUFFLE(prt__hi, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31)
PRT__SHUFFLE(prt__block_lo, 0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23)
PRT__SHUFFLE(prt__block_hi, 8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31)
#endif

/* Registers of 16 bytes take a block from vector after vector without a buffer between. */
#define PRT__BLOCK_VECTORS (PRT__SIMD && PRT__VEC_BYTES == 16)

enum { PRT__UNIT = 16 / (int)sizeof(prt_real) };                /* numbers in 16 bytes */

/* The transposed PRT__LANES x PRT__LANES matrix, in place: first within blocks of 16 bytes, then the blocks. */
PRT__INLINE void prt__lanes_transpose(prt__vec *row) {
    prt__vec t[PRT__LANES];
    int g, j;
    PRT__UNROLL
    for (g = 0; g < PRT__LANES; g += PRT__UNIT) {
#ifdef PRT_DOUBLE
        t[g] = prt__lo(row[g], row[g + 1]);
        t[g + 1] = prt__hi(row[g], row[g + 1]);
#else
        prt__vec a = prt__lo(row[g], row[g + 2]), b = prt__lo(row[g + 1], row[g + 3]);
        prt__vec c = prt__hi(row[g], row[g + 2]), d = prt__hi(row[g + 1], row[g + 3]);
        t[g] = prt__lo(a, b);
        t[g + 1] = prt__hi(a, b);
        t[g + 2] = prt__lo(c, d);
        t[g + 3] = prt__hi(c, d);
#endif
    }
    PRT__UNROLL
    for (j = 0; j < PRT__UNIT; j++) {
#if PRT__VEC_BYTES == 16
        row[j] = t[j];
#elif PRT__VEC_BYTES == 32
        row[j] = prt__block_lo(t[j], t[PRT__UNIT + j]);
        row[PRT__UNIT + j] = prt__block_hi(t[j], t[PRT__UNIT + j]);
#else
        prt__vec a = prt__block_lo(t[j], t[2 * PRT__UNIT + j]), c = prt__block_hi(t[j], t[2 * PRT__UNIT + j]);
        prt__vec b = prt__block_lo(t[PRT__UNIT + j], t[3 * PRT__UNIT + j]);
        prt__vec d = prt__block_hi(t[PRT__UNIT + j], t[3 * PRT__UNIT + j]);
        row[j] = prt__block_lo(a, b);
        row[PRT__UNIT + j] = prt__block_hi(a, b);
        row[2 * PRT__UNIT + j] = prt__block_lo(c, d);
        row[3 * PRT__UNIT + j] = prt__block_hi(c, d);
#endif
    }
}
#else
PRT__INLINE void prt__lanes_transpose(prt__vec *row) { (void)row; }
#endif

#if PRT__BLOCK_VECTORS
/* PRT__LANES coefficients of as many vectors. */
PRT__INLINE void prt__vectors_load(const prt_real *f, size_t stride, prt__vec *v) {
    int k;
    PRT__UNROLL
    for (k = 0; k < PRT__LANES; k++) v[k] = prt__vec_load(f + (size_t)k * stride);
    prt__lanes_transpose(v);
}

PRT__INLINE void prt__vectors_store(prt_real *out, size_t stride, const prt__vec *sum) {
    prt__vec v[PRT__LANES];
    int k;
    PRT__UNROLL
    for (k = 0; k < PRT__LANES; k++) v[k] = sum[k];
    prt__lanes_transpose(v);
    PRT__UNROLL
    for (k = 0; k < PRT__LANES; k++) prt__vec_store(out + (size_t)k * stride, v[k]);
}

/* One block, or with size = 4 the first two, of PRT__LANES vectors, `stride` apart, all in registers. */
PRT__INLINE void prt__block_vectors(int size, const prt__entry *m, const prt_real *f, prt_real *out, size_t stride) {
    prt__vec v[2 * PRT__ENTRY_BANDS - 1], sum[2 * PRT__ENTRY_BANDS - 1];
    int i;
    if (size % PRT__LANES) prt__vectors_load(f + size - PRT__LANES, stride, v + size - PRT__LANES);
    PRT__UNROLL
    for (i = 0; i + PRT__LANES <= size; i += PRT__LANES) prt__vectors_load(f + i, stride, v + i);
    if (size == 4) {
        prt__block_rows(1, 1, m, v, sum);
        prt__block_rows(3, 3, m + 1, v + 1, sum + 1);
    } else {
        PRT__UNROLL
        for (i = 0; i < size; i += 4) prt__block_rows(size - i < 4 ? size - i : 4, size, m + i * size, v, sum + i);
    }
    PRT__UNROLL
    for (i = 0; i + PRT__LANES <= size; i += PRT__LANES) prt__vectors_store(out + i, stride, sum + i);
    if (size % PRT__LANES) prt__vectors_store(out + size - PRT__LANES, stride, sum + size - PRT__LANES);
}

typedef void prt__vectors_kernel(const prt__entry *m, const prt_real *f, prt_real *out, size_t stride);
#define PRT__VECTORS_KERNEL(l) \
    PRT__STATIC void prt__block_vectors_##l(const prt__entry *m, const prt_real *f, prt_real *out, size_t stride) { \
        prt__block_vectors(l == 1 ? 4 : 2 * l + 1, m, f, out, stride); \
    }
PRT__VECTORS_KERNEL(1) PRT__VECTORS_KERNEL(2) PRT__VECTORS_KERNEL(3) PRT__VECTORS_KERNEL(4)
PRT__VECTORS_KERNEL(5) PRT__VECTORS_KERNEL(6) PRT__VECTORS_KERNEL(7)
#undef PRT__VECTORS_KERNEL
static prt__vectors_kernel *const prt__vectors_kernels[PRT__ENTRY_BANDS] = {
    NULL, prt__block_vectors_1, prt__block_vectors_2, prt__block_vectors_3, prt__block_vectors_4, prt__block_vectors_5,
    prt__block_vectors_6, prt__block_vectors_7
};

/* The low bands, two or more, of a group of PRT__LANES vectors, an incomplete one by way of `part`; returns how many. */
PRT__STATIC int prt__rotate_vectors(int bands, const prt__entry *entries, int lanes, const prt_real *f, prt_real *out,
                                    size_t stride) {
    prt_real part[PRT__LANES][PRT_SH_COUNT(PRT__ENTRY_BANDS)];
    int low = bands < PRT__ENTRY_BANDS ? bands : PRT__ENTRY_BANDS, l, k;
    size_t bytes = (size_t)PRT_SH_COUNT(low) * sizeof *f;
    if (lanes < PRT__LANES) {
        memset(part, 0, sizeof part);
        for (k = 0; k < lanes; k++) memcpy(part[k], f + (size_t)k * stride, bytes);
        prt__rotate_vectors(low, entries, PRT__LANES, part[0], part[0], PRT_SH_COUNT(PRT__ENTRY_BANDS));
        for (k = 0; k < lanes; k++) memcpy(out + (size_t)k * stride, part[k], bytes);
        return low;
    }
    prt__vectors_kernels[1](entries, f, out, stride);
    for (l = 2; l < low; l++)
        prt__vectors_kernels[l](entries + prt__block_offset(l), f + l * l, out + l * l, stride);
    return low;
}
#else
PRT__INLINE int prt__rotate_vectors(int bands, const prt__entry *entries, int lanes, const prt_real *f, prt_real *out,
                                    size_t stride) {
    (void)bands; (void)entries; (void)lanes; (void)f; (void)out; (void)stride;
    return 0;
}
#endif

/* Coefficients 0 ... count-1 of `lanes` vectors, `stride` apart, from f to x[count][PRT__LANES]; missing lanes become 0. */
PRT__STATIC void prt__lanes_gather(size_t stride, const prt_real *f, int count, int lanes, prt_real *x) {
    prt__vec row[PRT__LANES];
    int i, k;
    if (lanes < PRT__LANES || count < PRT__LANES) {
        for (i = 0; i < count; i++)
            for (k = 0; k < PRT__LANES; k++) x[i * PRT__LANES + k] = k < lanes ? f[(size_t)k * stride + (size_t)i] : 0;
        return;
    }
    for (i = 0; i < count; i += PRT__LANES) {
        int first = i + PRT__LANES <= count ? i : count - PRT__LANES;                   /* the last may overlap */
        PRT__UNROLL
        for (k = 0; k < PRT__LANES; k++) row[k] = prt__vec_load(f + (size_t)k * stride + first);
        prt__lanes_transpose(row);
        PRT__UNROLL
        for (k = 0; k < PRT__LANES; k++) prt__vec_store(x + (first + k) * PRT__LANES, row[k]);
    }
}

PRT__STATIC void prt__lanes_scatter(size_t stride, const prt_real *x, int count, int lanes, prt_real *f) {
    prt__vec row[PRT__LANES];
    int i, k;
    if (lanes < PRT__LANES || count < PRT__LANES) {
        for (i = 0; i < count; i++)
            for (k = 0; k < lanes; k++) f[(size_t)k * stride + (size_t)i] = x[i * PRT__LANES + k];
        return;
    }
    for (i = 0; i < count; i += PRT__LANES) {
        int first = i + PRT__LANES <= count ? i : count - PRT__LANES;
        PRT__UNROLL
        for (k = 0; k < PRT__LANES; k++) row[k] = prt__vec_load(x + (first + k) * PRT__LANES);
        prt__lanes_transpose(row);
        PRT__UNROLL
        for (k = 0; k < PRT__LANES; k++) prt__vec_store(f + (size_t)k * stride + first, row[k]);
    }
}

/* The blocks as the kernels take them: repeated in `room` where registers have 16 bytes. */
PRT__STATIC const prt__entry *prt__block_entries(int bands, const prt_real *blocks, prt__entry *room) {
#if PRT__SIMD && PRT__VEC_BYTES == 16
    size_t i, total = prt__block_offset(bands < PRT__ENTRY_BANDS ? bands : PRT__ENTRY_BANDS);
    for (i = 0; i < total; i++) room[i] = prt__entry_of(blocks[i]);
    return room;
#else
    (void)bands; (void)room;
    return blocks;
#endif
}

/* Bands first ... end-1 of one group of lanes; `channels` values stand side by side for each coefficient. */
PRT__STATIC void prt__rotate_lanes(int first, int end, int channels, const prt__entry *entries, const prt_real *blocks,
                                   const prt_real *x, prt_real *out) {
    size_t step = (size_t)(channels * PRT__LANES);
    int l, c;
    for (l = first; l < end && l < PRT_MAX_BANDS; l++)          /* the second bound only tells compilers */
        for (c = 0; c < channels; c++) {
            int at = ((l * l - first * first) * channels + c) * PRT__LANES;
            size_t block = prt__block_offset(l);
            if (l < PRT__ENTRY_BANDS) prt__block_kernels[l](entries + block, x + at, step, out + at, step);
            else prt__block_lanes_any(2 * l + 1, blocks + block, x + at, step, out + at, step);
        }
}

/* Has so many numbers brought near, in the order in which memory likes it: transposes read them in another. */
PRT__INLINE void prt__fetch_ahead(size_t count, const prt_real *f, const prt_real *out) {
#if PRT__SIMD
    size_t i;
    for (i = 0; i < count; i += 64 / sizeof *f) {
        __builtin_prefetch(f + i, 0);
        __builtin_prefetch(out + i, 1);
    }
#else
    (void)count; (void)f; (void)out;
#endif
}

/* Vectors one after the other, a group of PRT__LANES at a time: some bands at once as far as they fit the buffers, at
   least one. */
PRT__STATIC void prt__rotate_many(int bands, int channels, const prt_real *blocks, int count, const prt_real *f,
                                  prt_real *out) {
    enum { BAND = 3 * (2 * PRT_MAX_BANDS - 1), ROOM = BAND > 3 * 64 ? BAND : 3 * 64 };
    prt__vec x[ROOM], y[ROOM];
    prt__entry room[PRT__ENTRIES];
    const prt__entry *entries = prt__block_entries(bands, blocks, room);
    size_t stride = (size_t)(PRT_SH_COUNT(bands) * channels);
    int k, first, end, far_away = (size_t)count > ((size_t)1 << 22) / sizeof *f / stride;       /* beyond most caches */
    for (k = 0; k < count; k += PRT__LANES) {
        int lanes = count - k < PRT__LANES ? count - k : PRT__LANES, next = count - k - lanes;
        if (far_away)
            prt__fetch_ahead((size_t)(next < PRT__LANES ? next : PRT__LANES) * stride, f + (size_t)(k + lanes) * stride,
                             out + (size_t)(k + lanes) * stride);
        first = channels == 1 && bands > 1 ? prt__rotate_vectors(bands, entries, lanes, f + (size_t)k * stride,
                                                                 out + (size_t)k * stride, stride) : 0;
        for (; first < bands; first = end) {
            size_t start = (size_t)k * stride + (size_t)(first * first * channels);
            int size;
            for (end = first + 1; end < bands && (end + 1 - first) * (end + 1 + first) * channels <= ROOM; end++) { }
            size = (end * end - first * first) * channels;
            prt__lanes_gather(stride, f + start, size, lanes, (prt_real *)x);
            prt__rotate_lanes(first, end, channels, entries, blocks, (const prt_real *)x, (prt_real *)y);
            prt__lanes_scatter(stride, (const prt_real *)y, size, lanes, out + start);
        }
    }
}

/* Band l of one group of lanes in rows, by way of x: the band may be of any size and the group incomplete. */
PRT__STATIC void prt__rotate_row_part(int l, int lanes, const prt__entry *entries, const prt_real *blocks,
                                      const prt_real *f, prt_real *out, size_t stride) {
    prt__vec x[2 * PRT_MAX_BANDS], y[2 * PRT_MAX_BANDS];
    int j, size = 2 * l + 1;
    for (j = 0; j < size; j++) x[j] = prt__vec_load_part(f + (size_t)j * stride, lanes);
    if (l < PRT__ENTRY_BANDS)
        prt__block_kernels[l](entries, (const prt_real *)x, PRT__LANES, (prt_real *)y, PRT__LANES);
    else
        prt__block_lanes_any(size, blocks, (const prt_real *)x, PRT__LANES, (prt_real *)y, PRT__LANES);
    for (j = 0; j < size; j++) prt__vec_store_part(out + (size_t)j * stride, y[j], lanes);
}

/* Rows of coefficients, band after band: so only the rows of one band are streams at a time. */
PRT__STATIC void prt__rotate_rows(int bands, const prt_real *blocks, int count, const prt_real *f, prt_real *out,
                                  size_t stride) {
    prt__entry room[PRT__ENTRIES];
    const prt__entry *entries = prt__block_entries(bands, blocks, room);
    int l, k;
    for (l = 0; l < bands; l++) {
        size_t row = (size_t)(l * l) * stride, block = prt__block_offset(l);
        const prt__entry *m = l < PRT__ENTRY_BANDS ? entries + block : entries;
        for (k = 0; k < count; k += PRT__LANES) {
            const prt_real *from = f + row + k;
            prt_real *to = out + row + k;
            int lanes = count - k < PRT__LANES ? count - k : PRT__LANES;
            if (lanes == PRT__LANES && l < PRT__ENTRY_BANDS) prt__block_kernels[l](m, from, stride, to, stride);
            else prt__rotate_row_part(l, lanes, m, blocks + block, from, to, stride);
        }
    }
}

PRT__STATIC prt_result prt__rotate_many_check(int bands, const prt_real *blocks, int count, const prt_real *f,
                                              const prt_real *out) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0) return PRT_ERR_COUNT;
    return count > 0 && (!blocks || !f || !out) ? PRT_ERR_NULL : PRT_OK;
}

PRTDEF prt_result prt_sh_rotate_by_n(int bands, const prt_real *blocks, int count, const prt_real *f, prt_real *out) {
    prt_result r = prt__rotate_many_check(bands, blocks, count, f, out);
    if (r == PRT_OK && count > 0) prt__rotate_many(bands, 1, blocks, count, f, out);
    return r;
}

PRTDEF prt_result prt_sh_rotate_by_n_rgb(int bands, const prt_real *blocks, int count, const prt_real *f,
                                         prt_real *out) {
    prt_result r = prt__rotate_many_check(bands, blocks, count, f, out);
    if (r == PRT_OK && count > 0) prt__rotate_many(bands, 3, blocks, count, f, out);
    return r;
}

PRTDEF prt_result prt_sh_rotate_by_soa(int bands, const prt_real *blocks, int count, const prt_real *f, prt_real *out,
                                       size_t stride) {
    prt_result r;
    if (prt__bands_ok(bands) && count > 0 && stride < (size_t)count) return PRT_ERR_COUNT;
    r = prt__rotate_many_check(bands, blocks, count, f, out);
    if (r == PRT_OK && count > 0) prt__rotate_rows(bands, blocks, count, f, out, stride);
    return r;
}

/* ---- one vector, one rotation ---- */

/* cos and sin of a, b, g with R = Rz(a) Ry(b) Rz(g), in this order, for a proper rotation, then those of 2g. R holds
   the phasor of g in its last row, times sin b. That of a in the last column is lost near the poles; but the upper
   left corner holds those of a + g, times 1 + cos b, and of a - g, times 1 - cos b, and one of the two is always well
   defined. What is of length 1 up to the error of R needs no root to be normalised, one step of Newton's does; a takes
   back what rounding does to the length of g. */
PRT__INLINE void prt__euler(const prt_real *r, prt_real *turn) {
    prt_real h2 = r[6] * r[6] + r[7] * r[7], h = 0, cg = 1, sg = 0, c2g = 1, s2g = 0, c = r[8];
    prt_real side = prt__sign(c), over = 1 / (1 + side * c), unit;     /* no branch: either is as likely */
    prt_real x = (r[4] + side * r[0]) * over, y = (r[3] - side * r[1]) * over;
    if (h2 > PRT__EPS * PRT__EPS * PRT__EPS * PRT__EPS) {
        over = 1 / h2;                                          /* beside the root, not after it */
        h = prt__sqrt(h2);
        cg = -r[6] * over * h;
        sg = r[7] * over * h;
        c2g = (r[6] * r[6] - r[7] * r[7]) * over;
        s2g = -2 * r[6] * r[7] * over;
    }
    unit = (PRT__R(1.5) - PRT__R(0.5) * (x * x + y * y)) * (2 - (cg * cg + sg * sg));
    x *= unit;
    y *= unit;
    turn[0] = x * cg + y * sg;
    turn[1] = side * (y * cg - x * sg);
    unit = PRT__R(1.5) - PRT__R(0.5) * (h2 + c * c);
    turn[2] = c * unit;
    turn[3] = h * unit;
    turn[4] = cg;
    turn[5] = sg;
    turn[6] = c2g;
    turn[7] = s2g;
}

PRT__INLINE prt_real prt__determinant(const prt_real *r) {
    return r[0] * (r[4] * r[8] - r[5] * r[7]) + r[1] * (r[5] * r[6] - r[3] * r[8]) + r[2] * (r[3] * r[7] - r[4] * r[6]);
}

/* A reflection R goes by M(R) = (-1)^l M(-R). */
PRT__STATIC const prt_real *prt__negated(const prt_real *r, prt_real *minus) {
    int i;
    for (i = 0; i < 9; i++) minus[i] = -r[i];
    return minus;
}
PRT__STATIC void prt__negate_odd_bands(int first, int bands, prt_real *f) {
    int l, m;
    for (l = first; l < bands; l += 2)
        for (m = -l; m <= l; m++) f[PRT_SH_INDEX(l, m)] = -f[PRT_SH_INDEX(l, m)];
}

/* Turns f about z, in place: (c_m, s_m) by m times the angle. The multiples in double: their errors add up. */
PRT__STATIC void prt__turn_z(int bands, double c, double s, const prt_real *f, prt_real *out) {
    double cm = 1, sm = 0;
    int l, m;
    for (m = 0; m < bands; m++) {
        double next = cm * c - sm * s;
        prt_real cr = (prt_real)cm, sr = (prt_real)sm;
        for (l = m; l < bands; l++) {
            prt_real plus = f[PRT_SH_INDEX(l, m)], minus = f[PRT_SH_INDEX(l, -m)];
            out[PRT_SH_INDEX(l, -m)] = cr * minus + sr * plus;
            out[PRT_SH_INDEX(l, m)] = m ? cr * plus - sr * minus : plus;
        }
        sm = sm * c + cm * s;
        cm = next;
    }
}

enum { PRT__ROTATE_KERNELS = 8 };

/* The same in SIMD, four coefficients at once. */
#if PRT__QUADS
#define PRT__QUAD_SHUFFLE(a, b, i, j, k, l) __builtin_shufflevector(a, b, i, j, k, l)
#  ifdef PRT_DOUBLE
typedef int64_t prt__quad_mask __attribute__((vector_size(32)));
#  else
typedef int32_t prt__quad_mask __attribute__((vector_size(16)));
#  endif

/* A band in four classes: from band 4 on even_cos = { c0 c2 c4 c6 }, odd_cos = { c1 c3 c5 c7 }, even_sin = { - s2 s4 s6 },
   odd_sin = { s1 s3 s5 s7 }, with s_m the coefficient of (l,-m). Bands 3 and 2 share one set: { c0 c2, c0 c2 },
   { c1 c3, c1 - }, { - s2, - s2 }, { s1 s3, s1 - }. Lanes without meaning hold copies from the same band. */
typedef struct prt__classes { prt__quad even_cos, odd_cos, even_sin, odd_sin; } prt__classes;
PRT__INLINE void prt__swap_yz_3(prt__classes *v);
PRT__INLINE void prt__swap_yz_4(prt__classes *v);
PRT__INLINE void prt__swap_yz_5(prt__classes *v);
PRT__INLINE void prt__swap_yz_6(prt__classes *v);
PRT__INLINE void prt__swap_yz_7(prt__classes *v);

/* Cosines and sines of the multiples of an angle, in the lanes of the classes of bands 2 and 3, and of those above. */
typedef struct prt__turn { prt__classes low, high; } prt__turn;

PRT__INLINE void prt__turn_classes(prt__classes *v, const prt__classes *t) {
    prt__quad even = v->even_cos, odd = v->odd_cos;
    v->even_cos = even * t->even_cos - v->even_sin * t->even_sin;
    v->even_sin = v->even_sin * t->even_cos + even * t->even_sin;
    v->odd_cos = odd * t->odd_cos - v->odd_sin * t->odd_sin;
    v->odd_sin = v->odd_sin * t->odd_cos + odd * t->odd_sin;
}

/* From the phasor of the angle and that of twice the angle: { 0 2 4 6 } is { 0 2 0 2 } + { 0 0 4 4 }. */
PRT__INLINE prt__turn prt__multiples(int bands, prt_real c1, prt_real s1, prt_real c2, prt_real s2) {
    prt_real c4 = c2 * c2 - s2 * s2, s4 = 2 * s2 * c2;
    prt__quad c = { 1, c2, 1, c2 }, s = { 0, s2, 0, s2 };
    prt__turn t;
    t.low.even_cos = c;
    t.low.even_sin = s;
    t.low.odd_cos = c * c1 - s * s1;
    t.low.odd_sin = s * c1 + c * s1;
    t.high = t.low;
    if (bands == 5) {                                           /* nothing above 4: no product */
        prt__quad even_cos = { 1, c2, c4, c4 }, even_sin = { 0, s2, s4, s4 };
        t.high.even_cos = even_cos;
        t.high.even_sin = even_sin;
    } else {
        prt__quad up_c = { 1, 1, c4, c4 }, up_s = { 0, 0, s4, s4 };
        t.high.even_cos = c * up_c - s * up_s;
        t.high.even_sin = s * up_c + c * up_s;
        t.high.odd_cos = t.high.even_cos * c1 - t.high.even_sin * s1;
        t.high.odd_sin = t.high.even_sin * c1 + t.high.even_cos * s1;
    }
    return t;
}

/* Bands 2 and 3: f[4 ... 15] = s2 s1 c0 c1 | c2, s3 s2 s1 | c0 c1 c2 c3. */
PRT__INLINE void prt__rotate_bands_2_3(const prt__turn *a, const prt__turn *b, const prt__turn *g, const prt_real *f,
                                       prt_real *out) {
    prt__quad p = prt__quad_load(f + 4), q = prt__quad_load(f + 8), r = prt__quad_load(f + 12), t, u;
    prt__classes v;
    t = PRT__QUAD_SHUFFLE(p, q, 2, 2, 4, 4);
    v.even_cos = PRT__QUAD_SHUFFLE(r, t, 0, 2, 4, 6);
    v.odd_cos = PRT__QUAD_SHUFFLE(r, p, 1, 3, 7, 7);
    v.even_sin = PRT__QUAD_SHUFFLE(q, p, 2, 2, 4, 4);
    v.odd_sin = PRT__QUAD_SHUFFLE(q, p, 3, 1, 5, 5);
    prt__turn_classes(&v, &g->low);
    prt__swap_yz_3(&v);
    prt__turn_classes(&v, &b->low);
    prt__swap_yz_3(&v);
    prt__turn_classes(&v, &a->low);
    t = PRT__QUAD_SHUFFLE(v.even_sin, v.odd_sin, 3, 3, 6, 6);
    u = PRT__QUAD_SHUFFLE(v.even_cos, v.odd_cos, 2, 2, 6, 6);
    prt__quad_store(out + 4, PRT__QUAD_SHUFFLE(t, u, 0, 2, 4, 6));
    t = PRT__QUAD_SHUFFLE(v.even_cos, v.odd_sin, 3, 3, 5, 5);
    u = PRT__QUAD_SHUFFLE(v.even_sin, v.odd_sin, 1, 1, 4, 4);
    prt__quad_store(out + 8, PRT__QUAD_SHUFFLE(t, u, 0, 2, 4, 6));
    prt__quad_store(out + 12, PRT__QUAD_SHUFFLE(v.even_cos, v.odd_cos, 0, 4, 1, 5));
}

/* A band from 4 to 7, f and out at its m = 0. Loads stay within the band: the second of each pair overlaps the first. */
PRT__INLINE prt__classes prt__load_classes(int l, const prt_real *f) {
    prt__quad cos_low = prt__quad_load(f), cos_high = prt__quad_load(f + l - 3);
    prt__quad sin_low = prt__quad_load(f - 4), sin_high = prt__quad_load(f - l);
    prt__classes v;
    if (l == 4) {
        v.even_cos = PRT__QUAD_SHUFFLE(cos_low, cos_high, 0, 2, 7, 7);
        v.odd_cos = PRT__QUAD_SHUFFLE(cos_low, cos_low, 1, 3, 3, 3);
        v.even_sin = PRT__QUAD_SHUFFLE(sin_low, sin_low, 2, 2, 0, 0);
        v.odd_sin = PRT__QUAD_SHUFFLE(sin_low, sin_low, 3, 1, 1, 1);
    } else if (l == 5) {
        v.even_cos = PRT__QUAD_SHUFFLE(cos_low, cos_high, 0, 2, 6, 6);
        v.odd_cos = PRT__QUAD_SHUFFLE(cos_low, cos_high, 1, 3, 7, 7);
        v.even_sin = PRT__QUAD_SHUFFLE(sin_low, sin_low, 2, 2, 0, 0);
        v.odd_sin = PRT__QUAD_SHUFFLE(sin_low, sin_high, 3, 1, 4, 4);
    } else if (l == 6) {
        v.even_cos = PRT__QUAD_SHUFFLE(cos_low, cos_high, 0, 2, 5, 7);
        v.odd_cos = PRT__QUAD_SHUFFLE(cos_low, cos_high, 1, 3, 6, 6);
        v.even_sin = PRT__QUAD_SHUFFLE(sin_low, sin_high, 2, 2, 6, 4);
        v.odd_sin = PRT__QUAD_SHUFFLE(sin_low, sin_high, 3, 1, 5, 5);
    } else {
        v.even_cos = PRT__QUAD_SHUFFLE(cos_low, cos_high, 0, 2, 4, 6);
        v.odd_cos = PRT__QUAD_SHUFFLE(cos_low, cos_high, 1, 3, 5, 7);
        v.even_sin = PRT__QUAD_SHUFFLE(sin_low, sin_high, 2, 2, 7, 5);
        v.odd_sin = PRT__QUAD_SHUFFLE(sin_low, sin_high, 3, 1, 6, 4);
    }
    return v;
}

PRT__INLINE void prt__store_classes(int l, const prt__classes *v, prt_real *out) {
    prt__quad t = PRT__QUAD_SHUFFLE(v->even_sin, v->odd_sin, 2, 1, 5, 4);
    prt__quad_store(out, PRT__QUAD_SHUFFLE(v->even_cos, v->odd_cos, 0, 4, 1, 5));
    prt__quad_store(out - 4, PRT__QUAD_SHUFFLE(t, t, 0, 2, 1, 3));
    out[4] = v->even_cos[2];
    if (l > 4) { out[5] = v->odd_cos[2]; out[-5] = v->odd_sin[2]; }
    if (l > 5) { out[6] = v->even_cos[3]; out[-6] = v->even_sin[3]; }
    if (l > 6) { out[7] = v->odd_cos[3]; out[-7] = v->odd_sin[3]; }
}

#define PRT__ROTATE_BAND(l) \
    PRT__INLINE void prt__rotate_band_##l(const prt__turn *a, const prt__turn *b, const prt__turn *g, const prt_real *f, \
                                          prt_real *out) { \
        prt__classes v = prt__load_classes(l, f + PRT_SH_INDEX(l, 0)); \
        prt__turn_classes(&v, &g->high); \
        prt__swap_yz_##l(&v); \
        prt__turn_classes(&v, &b->high); \
        prt__swap_yz_##l(&v); \
        prt__turn_classes(&v, &a->high); \
        prt__store_classes(l, &v, out + PRT_SH_INDEX(l, 0)); \
    }
PRT__ROTATE_BAND(4) PRT__ROTATE_BAND(5) PRT__ROTATE_BAND(6) PRT__ROTATE_BAND(7)
#undef PRT__ROTATE_BAND

/* The columns of R, rows 0 1 2 2 in the lanes. */
typedef struct prt__axes { prt__quad x, y, z; } prt__axes;
PRT__INLINE prt__axes prt__load_axes(const prt_real *r) {
    prt__quad p = prt__quad_load(r), q = prt__quad_load(r + 4), last = prt__quad_load(r + 5);
    prt__quad t = PRT__QUAD_SHUFFLE(p, q, 1, 1, 4, 4), u = PRT__QUAD_SHUFFLE(p, last, 2, 2, 4, 4);
    prt__axes c;
    c.x = PRT__QUAD_SHUFFLE(p, q, 0, 3, 6, 6);
    c.y = PRT__QUAD_SHUFFLE(t, q, 0, 2, 7, 7);
    c.z = PRT__QUAD_SHUFFLE(u, last, 0, 2, 7, 7);
    return c;
}

/* prt__rotation_ok for all entries at once. */
PRT__INLINE int prt__axes_ok(const prt__axes *c) {
    const prt__quad one = { 1, 1, 1, 1 }, limit = one * PRT__R(1e-6);
    prt__quad x = PRT__QUAD_SHUFFLE(c->x, c->x, 1, 2, 0, 0), y = PRT__QUAD_SHUFFLE(c->y, c->y, 1, 2, 0, 0);
    prt__quad z = PRT__QUAD_SHUFFLE(c->z, c->z, 1, 2, 0, 0);
    prt__quad lengths = c->x * c->x + c->y * c->y + c->z * c->z - one, angles = c->x * x + c->y * y + c->z * z;
    prt__quad_mask mask = (lengths * lengths <= limit) & (angles * angles <= limit);
    int64_t lanes[sizeof mask / 8];
    int i, all = 1;
    memcpy(lanes, &mask, sizeof mask);
    for (i = 0; i < (int)(sizeof mask / 8); i++) all &= lanes[i] == -1;
    return all;
}

/* Band 1: R (x y z) in the order y, z, x. */
PRT__INLINE void prt__rotate_band_1(const prt__axes *c, const prt_real *f, prt_real *out) {
    prt__quad v = c->x * f[3] + c->y * f[1] + c->z * f[2];
    out[1] = v[1];
    out[2] = v[2];
    out[3] = v[0];
}

/* Band 2 as prt__sh_rotate_3 does it: the rows of A R^T, then of R A R^T without the first, which the trace gives. */
PRT__INLINE void prt__rotate_band_2(const prt__axes *c, const prt_real *r, const prt_real *f, prt_real *out) {
    prt_real third = f[6] * PRT__R(0.577350269189625764509), xx = f[8] - third, yy = -f[8] - third, zz = 2 * third;
    prt_real xy = f[4], yz = f[5], zx = f[7];
    prt__quad x = c->x * xx + c->y * xy + c->z * zx, y = c->x * xy + c->y * yy + c->z * yz;
    prt__quad z = c->x * zx + c->y * yz + c->z * zz;
    prt__quad p = x * r[3] + y * r[4] + z * r[5], q = x * r[6] + y * r[7] + z * r[8];
    out[4] = p[0];
    out[5] = q[1];
    out[6] = q[2] * PRT__R(0.866025403784438646764);
    out[7] = q[0];
    out[8] = -p[1] - PRT__R(0.5) * q[2];
}

/* Band 3 as a symmetric tensor T_ijk without trace: f.Y = T(x,x,x) up to a factor. `part` holds T(R^T i, j, k) for the
   rows i in the lanes and jk = xx, yy, xy, yz, zx; zz follows from the trace. */
PRT__INLINE void prt__band_3_parts(const prt__axes *c, const prt_real *f, prt__quad part[5]) {
    const prt_real u = PRT__R(1.6329931618554520655), v = PRT__R(1.5811388300841896660), w = PRT__R(1.2909944487358056284);
    prt_real xzz = u * f[4], yzz = u * f[2], xyz = w * f[1], w5 = w * f[5], v6 = v * f[6], v0 = v * f[0];
    prt_real xxz = w5 - f[3], yyz = -w5 - f[3], thirdx = PRT__R(0.25) * xzz, thirdy = PRT__R(0.25) * yzz;
    prt_real xyy = -thirdx - v6, xxy = v0 - thirdy, xxx = v6 - 3 * thirdx, yyy = -v0 - 3 * thirdy;
    part[0] = c->x * xxx + c->y * xxy + c->z * xxz;
    part[1] = c->x * xyy + c->y * yyy + c->z * yyz;
    part[2] = c->x * xxy + c->y * xyy + c->z * xyz;
    part[3] = c->x * xyz + c->y * yyz + c->z * yzz;
    part[4] = c->x * xxz + c->y * xyz + c->z * xzz;
}

/* T(R^T i, p, q) for the rows i in the lanes, from the parts; p and q are rows of R. */
PRT__INLINE prt__quad prt__band_3_contract(const prt__quad *part, prt__quad p, prt__quad q) {
    prt__quad same = p * q, other = p * PRT__QUAD_SHUFFLE(q, q, 1, 2, 0, 0) + q * PRT__QUAD_SHUFFLE(p, p, 1, 2, 0, 0);
    return (same[0] - same[2]) * part[0] + (same[1] - same[2]) * part[1] + other[0] * part[2] + other[1] * part[3]
         + other[2] * part[4];
}

PRT__INLINE void prt__rotate_band_3(const prt__axes *c, const prt_real *r, const prt_real *f, prt_real *out) {
    prt__quad x = prt__quad_load(r), y = prt__quad_load(r + 3), z = prt__quad_load(r + 5), part[5], zz, xy, xx;
    z = PRT__QUAD_SHUFFLE(z, z, 1, 2, 3, 3);
    prt__band_3_parts(c, f + 9, part);
    zz = prt__band_3_contract(part, z, z);
    xy = prt__band_3_contract(part, x, y);
    xx = prt__band_3_contract(part, x, x);
    out[9] = (xy[0] + PRT__R(0.25) * zz[1]) * PRT__R(0.63245553203367586640);
    out[10] = xy[2] * PRT__R(0.77459666924148337704);
    out[11] = zz[1] * PRT__R(0.61237243569579452455);
    out[12] = zz[2] * PRT__R(0.5);
    out[13] = zz[0] * PRT__R(0.61237243569579452455);
    out[14] = (xx[2] + PRT__R(0.5) * zz[2]) * PRT__R(0.77459666924148337704);
    out[15] = -(xy[1] + PRT__R(0.25) * zz[0]) * PRT__R(0.63245553203367586640);
}

PRT__INLINE void prt__rotate_upper_bands(int bands, const prt_real *r, const prt_real *f, prt_real *out) {
    prt_real e[8];
    prt__turn a, b, g;
    prt__euler(r, e);
    g = prt__multiples(bands, e[4], e[5], e[6], e[7]);
    b = prt__multiples(bands, e[2], -e[3], e[2] * e[2] - e[3] * e[3], -2 * e[2] * e[3]);
    a = prt__multiples(bands, e[0], e[1], e[0] * e[0] - e[1] * e[1], 2 * e[0] * e[1]);
    prt__rotate_bands_2_3(&a, &b, &g, f, out);
    prt__rotate_band_4(&a, &b, &g, f, out);
    if (bands > 5) prt__rotate_band_5(&a, &b, &g, f, out);
    if (bands > 6) prt__rotate_band_6(&a, &b, &g, f, out);
    if (bands > 7) prt__rotate_band_7(&a, &b, &g, f, out);
}

PRT__INLINE prt_result prt__rotate_quads(int bands, const prt_real *r, const prt_real *f, prt_real *out) {
    prt__axes c = prt__load_axes(r);
    const prt_real *proper = r;
    prt_real minus[9];
    if (!prt__axes_ok(&c)) return PRT_ERR_ROTATION;
    out[0] = f[0];
    if (bands > 1) prt__rotate_band_1(&c, f, out);
    if (bands == 3 || bands == 4) prt__rotate_band_2(&c, r, f, out);
    if (bands == 4) prt__rotate_band_3(&c, r, f, out);
    if (bands > 4) {
        if (prt__determinant(r) < 0) proper = prt__negated(r, minus);
        prt__rotate_upper_bands(bands, proper, f, out);
        if (proper == minus) prt__negate_odd_bands(3, bands, out);
    }
    return PRT_OK;
}
#define PRT__ROTATE_QUADS(bands) \
    PRT__STATIC prt_result prt__rotate_quads_##bands(const prt_real *r, const prt_real *f, prt_real *out) { \
        return prt__rotate_quads(bands, r, f, out); \
    }
PRT__ROTATE_QUADS(1) PRT__ROTATE_QUADS(2) PRT__ROTATE_QUADS(3) PRT__ROTATE_QUADS(4)
PRT__ROTATE_QUADS(5) PRT__ROTATE_QUADS(6) PRT__ROTATE_QUADS(7) PRT__ROTATE_QUADS(8)
#undef PRT__ROTATE_QUADS
static prt_result (*const prt__rotate_quads_of[])(const prt_real *r, const prt_real *f, prt_real *out) = {
    prt__rotate_quads_1, prt__rotate_quads_2, prt__rotate_quads_3, prt__rotate_quads_4,
    prt__rotate_quads_5, prt__rotate_quads_6, prt__rotate_quads_7, prt__rotate_quads_8
};
#else
typedef void prt__rotate_kernel(const prt_real *r, const prt_real *turn, const prt_real *f, prt_real *PRT__RESTRICT out);
static prt__rotate_kernel prt__sh_rotate_2, prt__sh_rotate_3, prt__sh_rotate_4, prt__sh_rotate_5, prt__sh_rotate_6,
                          prt__sh_rotate_7, prt__sh_rotate_8;
static prt__rotate_kernel *const prt__rotate_kernels[PRT__ROTATE_KERNELS - 1] = {
    prt__sh_rotate_2, prt__sh_rotate_3, prt__sh_rotate_4, prt__sh_rotate_5, prt__sh_rotate_6, prt__sh_rotate_7,
    prt__sh_rotate_8
};

PRT__STATIC prt_result prt__rotate_plain(int bands, const prt_real *r, const prt_real *f, prt_real *out) {
    prt_real copy[PRT__ROTATE_KERNELS * PRT__ROTATE_KERNELS], minus[9], turn[8] = { 0 };
    const prt_real *proper = r;
    if (!prt__rotation_ok(r)) return PRT_ERR_ROTATION;
    if (bands > 3 && prt__determinant(r) < 0) proper = prt__negated(r, minus);
    if (bands > 3) prt__euler(proper, turn);
    else turn[0] = 0;                                                        /* not read; gcc -O3 does not see that */
    memcpy(copy, f, (size_t)PRT_SH_COUNT(bands) * sizeof *f);               /* so that out may be f */
    if (bands == 1) out[0] = f[0];
    else prt__rotate_kernels[bands - 2](proper, turn, copy, out);
    if (proper == minus) prt__negate_odd_bands(1, bands, out);
    return PRT_OK;
}
#endif

/* ---- above PRT__ROTATE_KERNELS bands ---- */

/* One band in double, cosine and sine of order m at [m], up to a whole vector: what lies beyond order l is 0. */
enum { PRT__BAND_ROOM = PRT_MAX_BANDS + PRT__WIDE_LANES };
typedef struct prt__band { double c[PRT__BAND_ROOM], s[PRT__BAND_ROOM]; } prt__band;

PRT__STATIC void prt__band_load(int l, const prt_real *f, prt__band *b) {
    int m;
    for (m = 0; m <= l; m++) {
        b->c[m] = (double)f[PRT_SH_INDEX(l, m)];
        b->s[m] = (double)f[PRT_SH_INDEX(l, -m)];
    }
    b->s[0] = 0;
    for (; m % PRT__WIDE_LANES; m++) b->c[m] = b->s[m] = 0;
}

PRT__STATIC void prt__band_store(int l, const prt__band *b, prt_real *f) {
    int m;
    for (m = 0; m <= l; m++) {
        f[PRT_SH_INDEX(l, -m)] = (prt_real)b->s[m];
        f[PRT_SH_INDEX(l, m)] = (prt_real)b->c[m];
    }
}

/* What prt__sh_swap_yz_band does to the last digit, here faster and within 2e-15.
   Swapping y and z takes order k of band l to order m with the factor w(k) w(m) D(k,m): D is Wigner's d(pi/2)
   [Trapani 2006], w = sqrt 2, but 1 for order 0, with a sign of period four. Cosines come from even l + k, sines from
   odd; they take cosines at even l + m, sines at odd. D(l,m) = 2^-l sqrt(binomial(2l, l+m)), and then down in k
     c(k) D(k,m) = 2m D(k+1,m) - c(k+1) D(k+2,m),   c(k) = sqrt((l-k) (l+k+1)),
   which grows until it oscillates, and so is stable. Each m starts at `start`, which keeps it in range for any l, and
   what it should have started at comes last. */
typedef struct prt__swap {
    double start, over[PRT__BAND_ROOM], ratio[PRT__BAND_ROOM];             /* 2/c(k), c(k+1)/c(k) */
    double from[PRT__BAND_ROOM], to[PRT__BAND_ROOM];                       /* w(k), w(m) D(l,m) / start */
} prt__swap;

PRT__STATIC void prt__swap_prepare(int l, prt__swap *t) {
    static const double sign[2][4] = { { 1, -1, -1, 1 }, { 1, 1, -1, -1 } };
    double top = 1;
    int k;
    t->start = l < 512 ? 1 : ldexp(1, -(l / 2));
    for (k = 1; k <= l; k++) top *= prt__root(2 * k - 1) * prt__inverse_root(2 * k);
    top /= t->start;
    for (k = 0; k <= l; k++) {
        double near_l = prt__inverse_root(l + k + 1);
        t->over[k] = 2 * near_l * prt__inverse_root(l - k);
        t->ratio[k] = 0.5 * t->over[k] * (k < l ? prt__root(l - k - 1) * prt__root(l + k + 2) : 0);
        t->from[k] = sign[l & 1][k & 3] * (k ? PRT__SQRT2 : 1);
        t->to[k] = top * t->from[k];
        top *= near_l * prt__root(l - k);
    }
    for (; k % PRT__WIDE_LANES; k++) t->to[k] = 0;
}

/* The step down to k. */
PRT__INLINE void prt__swap_step(const prt__swap *t, int k, prt__wide order, prt__wide *d, prt__wide *before) {
    prt__wide next = *d * (order * t->over[k]) - *before * t->ratio[k];
    *before = *d;
    *d = next;
}

/* What order k gives to the orders m, which take turns in taking its cosine and its sine. */
enum { PRT__SWAP_LANES = PRT__WIDE_LANES > 1 ? PRT__WIDE_LANES : 2 };
typedef double prt__swap_source[PRT__BAND_ROOM][PRT__SWAP_LANES];

PRT__INLINE void prt__swap_sources(int l, const prt__swap *t, const prt__band *b, prt__swap_source in) {
    static const double turns[10] = { 1, 0, 1, 0, 1, 0, 1, 0, 1, 0 };
    int k, m;
    for (k = 0; k <= l; k++)
        for (m = 0; m < PRT__SWAP_LANES; m += PRT__WIDE_LANES)
            prt__wide_store(in[k] + m, prt__wide_load(turns + ((l + m) & 1)) * (t->from[k] * b->c[k])
                                     + prt__wide_load(turns + ((l + m + 1) & 1)) * (t->from[k] * b->s[k]));
}

/* Orders m and following from all orders k; in: at m. */
PRT__INLINE void prt__swap_orders(int l, int m, const prt__swap *t, prt__swap_source in, prt__band *b) {
    double order[PRT__WIDE_LANES], start[PRT__WIDE_LANES];
    prt__wide orders, d, before, cosine, sine;
    int k, at = m % PRT__SWAP_LANES;
    for (k = 0; k < PRT__WIDE_LANES; k++) {
        order[k] = m + k;
        start[k] = m + k <= l ? t->start : 0;
    }
    orders = prt__wide_load(order);
    d = prt__wide_load(start);
    before = cosine = sine = d - d;
    for (k = l; k > 0; k -= 2) {
        cosine += d * prt__wide_load(in[k] + at);
        prt__swap_step(t, k - 1, orders, &d, &before);
        sine += d * prt__wide_load(in[k - 1] + at);
        if (k > 1) prt__swap_step(t, k - 2, orders, &d, &before);
    }
    if (k == 0) cosine += d * prt__wide_load(in[0] + at);
    prt__wide_store(b->c + m, cosine * prt__wide_load(t->to + m));
    prt__wide_store(b->s + m, sine * prt__wide_load(t->to + m));
}

/* y and z swapped, in place. */
PRT__STATIC void prt__band_swap_yz(int l, const prt__swap *t, prt__band *b) {
    prt__swap_source in;
    int m;
    prt__swap_sources(l, t, b, in);
    for (m = 0; m <= l; m += PRT__WIDE_LANES) prt__swap_orders(l, m, t, in, b);
    b->s[0] = 0;
}

/* Cosine and sine of the multiples of an angle, as a band; the phasor need only be near the unit circle. */
PRT__STATIC void prt__multiples_of(int bands, double c, double s, prt__band *turn) {
    double unit = 1 / sqrt(c * c + s * s);
    int m;
    c *= unit;
    s *= unit;
    turn->c[0] = 1;
    turn->s[0] = 0;
    for (m = 1; m < bands; m++) {
        turn->c[m] = turn->c[m - 1] * c - turn->s[m - 1] * s;
        turn->s[m] = turn->s[m - 1] * c + turn->c[m - 1] * s;
    }
    for (; m % PRT__WIDE_LANES; m++) turn->c[m] = turn->s[m] = 0;
}

PRT__STATIC void prt__band_turn(int l, const prt__band *turn, prt__band *b) {
    int m;
    for (m = 0; m <= l; m += PRT__WIDE_LANES) {
        prt__wide c = prt__wide_load(b->c + m), s = prt__wide_load(b->s + m);
        prt__wide ct = prt__wide_load(turn->c + m), st = prt__wide_load(turn->s + m);
        prt__wide_store(b->c + m, ct * c - st * s);
        prt__wide_store(b->s + m, ct * s + st * c);
    }
}

/* Bands first ... bands-1, in double and with the swap computed on the way. */
PRT__STATIC void prt__rotate_far(int first, int bands, const prt_real *r, const prt_real *f, prt_real *out) {
    prt_real minus[9], turn[8];
    const prt_real *proper = prt__determinant(r) < 0 ? prt__negated(r, minus) : r;
    prt__band a, b, g, v;
    prt__swap t;
    int l;
    prt__euler(proper, turn);
    prt__multiples_of(bands, (double)turn[0], (double)turn[1], &a);
    prt__multiples_of(bands, (double)turn[2], -(double)turn[3], &b);
    prt__multiples_of(bands, (double)turn[4], (double)turn[5], &g);
    for (l = first; l < bands; l++) {
        prt__swap_prepare(l, &t);
        prt__band_load(l, f, &v);
        prt__band_turn(l, &g, &v);
        prt__band_swap_yz(l, &t, &v);
        prt__band_turn(l, &b, &v);
        prt__band_swap_yz(l, &t, &v);
        prt__band_turn(l, &a, &v);
        prt__band_store(l, &v, out);
    }
    if (proper == minus) prt__negate_odd_bands(first | 1, bands, out);
}

PRTDEF prt_result prt_sh_rotate(int bands, const prt_real rotation[9], const prt_real *f, prt_real *out) {
    int low = bands < PRT__ROTATE_KERNELS ? bands : PRT__ROTATE_KERNELS;
    prt_result result;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!rotation || !f || !out) return PRT_ERR_NULL;
#if PRT__QUADS
    result = prt__rotate_quads_of[low - 1](rotation, f, out);
#else
    result = prt__rotate_plain(low, rotation, f, out);
#endif
    if (result == PRT_OK && bands > low) prt__rotate_far(low, bands, rotation, f, out);
    return result;
}

PRTDEF prt_result prt_sh_rotate_z(int bands, prt_real angle, const prt_real *f, prt_real *out) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    if (!prt__finite(angle)) return PRT_ERR_VALUE;
    prt__turn_z(bands, cos((double)angle), sin((double)angle), f, out);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_zonal_to(int bands, const prt_real *zonal, prt_vec3 axis, prt_real *out) {
    double factor[PRT_MAX_BANDS];
    int l;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!zonal || !out) return PRT_ERR_NULL;
    if (!prt__unit(axis, &axis)) return PRT_ERR_VALUE;
    for (l = 0; l < bands; l++) factor[l] = sqrt(4 * PRT__PI / (2 * l + 1)) * (double)zonal[l];
    prt__zonal_light(bands, factor, axis, out);
    return PRT_OK;
}

/* ----------------------------------------------------------------------------------------------- >>product ---- */

/* Double-double arithmetic for prt_sh_triple: hi + lo carries 106 bits. The volatile intermediates keep every rounding
   where it is written, whatever the compiler may contract or reassociate. */
typedef struct prt__dd { double hi, lo; } prt__dd;

PRT__STATIC prt__dd prt__dd_sum(double a, double b) {
    volatile double s = a + b, bb = s - a, aa = s - bb, ea = a - aa, eb = b - bb;
    prt__dd r;
    r.hi = s;
    r.lo = ea + eb;
    return r;
}

PRT__STATIC prt__dd prt__dd_add(prt__dd a, prt__dd b) {
    prt__dd s = prt__dd_sum(a.hi, b.hi), t = prt__dd_sum(a.lo, b.lo);
    s = prt__dd_sum(s.hi, s.lo + t.hi);
    return prt__dd_sum(s.hi, s.lo + t.lo);
}

PRT__STATIC prt__dd prt__dd_product(double a, double b) {
    volatile double p = a * b;
    prt__dd r;
    r.hi = p;
    r.lo = fma(a, b, -p);
    return r;
}

PRT__STATIC prt__dd prt__dd_mul(prt__dd a, prt__dd b) {
    prt__dd p = prt__dd_product(a.hi, b.hi);
    volatile double cross = a.hi * b.lo + a.lo * b.hi;
    return prt__dd_sum(p.hi, p.lo + cross);
}

PRT__STATIC prt__dd prt__dd_scale(prt__dd a, double s) { return prt__dd_mul(a, prt__dd_sum(s, 0)); }

PRT__STATIC prt__dd prt__dd_div(prt__dd a, prt__dd b) {
    volatile double q = a.hi / b.hi;
    prt__dd rest = prt__dd_add(a, prt__dd_scale(b, -q));
    return prt__dd_sum(q, rest.hi / b.hi);
}

PRT__STATIC prt__dd prt__dd_sqrt(prt__dd a) {
    volatile double root = sqrt(a.hi);
    prt__dd rest = prt__dd_add(a, prt__dd_scale(prt__dd_product(root, root), -1));
    return prt__dd_sum(root, rest.hi / (2 * root));
}

/* The coefficients C(k) = C(j1 k j2 m-k; j m), k = first ... last, are the eigenvector, for the eigenvalue j(j+1), of
   J^2 in the product basis: a tridiagonal matrix. prt__cg_off couples k and k+1; prt__cg_diagonal is the eigenvalue
   less the diagonal. */
typedef struct prt__cg { int j1, j2, j, m, first, last; } prt__cg;

PRT__STATIC prt__dd prt__cg_off(const prt__cg *c, int k) {
    prt__dd a = prt__dd_product((double)c->j1 - k, (double)c->j1 + k + 1);
    prt__dd b = prt__dd_product((double)c->j2 + c->m - k, (double)c->j2 - c->m + k + 1);
    return prt__dd_sqrt(prt__dd_mul(a, b));
}

PRT__STATIC double prt__cg_diagonal(const prt__cg *c, int k) {
    double j1 = c->j1, j2 = c->j2, j = c->j;
    return j * (j + 1) - j1 * (j1 + 1) - j2 * (j2 + 1) - 2.0 * k * ((double)c->m - k);
}

/* A run of the recurrence from one end, step +1 or -1. It starts at 1 and is scaled down whenever it grows large. */
typedef struct prt__cg_run {
    prt__dd value, before, off;                        /* at k and one step back; the coupling between the two */
    prt__dd wanted, squares;                           /* the value at the target, once passed; sum of squares before k */
    double neighbour;                                  /* size of what stands around the wanted value */
    int k, step, target;
} prt__cg_run;

PRT__STATIC prt__cg_run prt__cg_start(const prt__cg *c, int step, int target) {
    prt__cg_run r;
    memset(&r, 0, sizeof r);
    r.k = step > 0 ? c->first : c->last;
    r.step = step;
    r.target = target;
    r.value.hi = 1;
    if (r.k == target) r.wanted = r.value;
    return r;
}

PRT__STATIC void prt__cg_step(const prt__cg *c, prt__cg_run *r) {
    const double tiny = 6.223015277861142e-61;         /* 2^-200 */
    prt__dd off = prt__cg_off(c, r->step > 0 ? r->k : r->k - 1);
    prt__dd next = prt__dd_mul(prt__dd_scale(r->off, -1), r->before);
    next = prt__dd_add(next, prt__dd_scale(r->value, prt__cg_diagonal(c, r->k)));
    next = prt__dd_div(next, off);
    r->squares = prt__dd_add(r->squares, prt__dd_mul(r->value, r->value));
    r->before = r->value;
    r->value = next;
    r->off = off;
    r->k += r->step;
    if (r->k == r->target) { r->wanted = next; r->neighbour = fabs(r->before.hi); }
    if (r->k == r->target + r->step) r->neighbour += fabs(next.hi);
    if (fabs(next.hi) > 1 / tiny) {
        r->value = prt__dd_scale(r->value, tiny);
        r->before = prt__dd_scale(r->before, tiny);
        r->wanted = prt__dd_scale(r->wanted, tiny);
        r->squares = prt__dd_scale(prt__dd_scale(r->squares, tiny), tiny);
        r->neighbour *= tiny;
    }
}

/* C(target). Both runs grow into the oscillating middle, where neither loses accuracy. They meet at the first maximum
   that the run from above finds: there the value is not small, so their ratio is well known. The value at `last` is
   positive. */
PRT__STATIC prt__dd prt__clebsch_gordan(const prt__cg *c, int target) {
    prt__cg_run up = prt__cg_start(c, 1, target), down = prt__cg_start(c, -1, target);
    prt__dd ratio, norm, wanted;
    while (down.k > c->first) {
        prt__cg_run further = down;
        prt__cg_step(c, &further);
        if (!(fabs(further.value.hi) >= fabs(further.before.hi))) break;
        down = further;
    }
    while (up.k < down.k) prt__cg_step(c, &up);
    ratio = prt__dd_div(up.value, down.value);
    norm = prt__dd_add(prt__dd_mul(up.value, up.value), up.squares);
    norm = prt__dd_sqrt(prt__dd_add(norm, prt__dd_mul(prt__dd_mul(ratio, ratio), down.squares)));
    if (target > up.k) wanted = prt__dd_scale(prt__dd_mul(down.wanted, ratio), ratio.hi < 0 ? -1 : 1);
    else wanted = prt__dd_scale(up.wanted, ratio.hi < 0 ? -1 : 1);
    if (fabs(wanted.hi) < 1e-25 * (target > up.k ? down.neighbour * fabs(ratio.hi) : up.neighbour))
        wanted = prt__dd_sum(0, 0);                    /* an accidental zero, and what rounding left of it */
    return prt__dd_div(wanted, norm);
}

/* binomial(2k,k) / 4^k */
PRT__STATIC prt__dd prt__central_binomial(int k) {
    prt__dd p = prt__dd_sum(1, 0);
    int i;
    for (i = 1; i <= k; i++) p = prt__dd_div(prt__dd_scale(p, 2.0 * i - 1), prt__dd_sum(2.0 * i, 0));
    return p;
}

/* int Y(l1,a) Y(l2,b) conj Y(l3,a+b) of the complex harmonics; l1+l2+l3 = 2g even.
   |C(l1 0 l2 0; l3 0)|^2 = (2 l3+1) p(g-l1) p(g-l2) p(g-l3) / ((2g+1) p(g)), p(k) = binomial(2k,k)/4^k */
PRT__STATIC prt__dd prt__gaunt(int l1, int a, int l2, int b, int l3) {
    prt__dd four_pi = { 12.566370614359172, 4.898587196589413e-16 }, root, value;
    prt__cg c;
    int g = l1 / 2 + l2 / 2 + l3 / 2 + (l1 % 2 + l2 % 2 + l3 % 2) / 2;
    root = prt__dd_mul(prt__central_binomial(g - l1), prt__central_binomial(g - l2));
    root = prt__dd_div(prt__dd_mul(root, prt__central_binomial(g - l3)), prt__central_binomial(g));
    root = prt__dd_mul(root, prt__dd_product(2.0 * l1 + 1, 2.0 * l2 + 1));
    root = prt__dd_div(root, prt__dd_scale(four_pi, 2.0 * g + 1));
    c.j1 = l1; c.j2 = l2; c.j = l3; c.m = a + b;
    c.first = a + b - l2 > -l1 ? a + b - l2 : -l1;
    c.last = a + b + l2 < l1 ? a + b + l2 : l1;
    value = prt__dd_mul(prt__clebsch_gordan(&c, a), prt__dd_sqrt(root));
    return (g - l3) % 2 ? prt__dd_scale(value, -1) : value;
}

PRT__INLINE int prt__iabs(int v) { return v < 0 ? -v : v; }

/* with m3 the largest |m|; Y(l,m) = sqrt 2 cos or sin for m != 0, hence the factors */
PRT__STATIC double prt__triple_ordered(int l1, int m1, int l2, int m2, int l3, int m3) {
    int a = prt__iabs(m1), b = prt__iabs(m2);
    prt__dd value, half_root = { 0.7071067811865476, -4.833646656726457e-17 };
    if (a + b != prt__iabs(m3)) return 0;
    value = prt__gaunt(l1, a, l2, b, l3);
    if (a && b) value = prt__dd_scale(prt__dd_mul(value, half_root), m1 < 0 && m2 < 0 ? -1 : 1);
    return value.hi;
}

PRTDEF double prt_sh_triple(int l1, int m1, int l2, int m2, int l3, int m3) {
    const int limit = INT32_MAX / 4;
    int a, b, c;
    if (l1 < 0 || l2 < 0 || l3 < 0 || l1 > limit || l2 > limit || l3 > limit) return 0;
    if (m1 < -l1 || m1 > l1 || m2 < -l2 || m2 > l2 || m3 < -l3 || m3 > l3) return 0;
    if ((l1 + l2 + l3) % 2 || l1 > l2 + l3 || l2 > l1 + l3 || l3 > l1 + l2) return 0;
    if (((m1 < 0) + (m2 < 0) + (m3 < 0)) % 2) return 0;
    a = prt__iabs(m1);
    b = prt__iabs(m2);
    c = prt__iabs(m3);
    if (c >= a && c >= b) return prt__triple_ordered(l1, m1, l2, m2, l3, m3);
    if (b >= a) return prt__triple_ordered(l1, m1, l3, m3, l2, m2);
    return prt__triple_ordered(l2, m2, l3, m3, l1, m1);
}

/* ---- products on a grid that is exact for them ----

   f, g and their product need the Gauss-Legendre nodes z_k, k < (3n-2)/2, and 4q >= 3n-2 azimuths, q = ceil((3n-2)/4).
   Symmetries halve and quarter the work: nodes come in pairs +-z (even and odd l-m), azimuths at (j+1/2) pi/(2q) in
   fours phi, pi-phi, pi+phi, -phi (even and odd m, cosines and sines). There are as many pairs of nodes as angles in a
   quarter: q. A vector holds a node pair in each lane (one product) or a product in each lane (a batch). */

enum {
    PRT__GRID_TABLES = 16,                                         /* generated: grids to so many bands */
    PRT__QUARTER_MAX = (3 * PRT_MAX_BANDS + 1) / 4,
    PRT__GROUP = PRT__LANES > 16 ? 1 : 16 / PRT__LANES             /* vectors of node pairs between two passes */
};

static const double *prt__grid_nodes(void), *prt__grid_weights(void), *prt__grid_sines(void);

typedef struct prt__grid {
    int bands, quarter;
    prt_real z[PRT__QUARTER_MAX + 16], weight[PRT__QUARTER_MAX + 16];       /* z >= 0; padded: weight 0 */
    prt_real sine[10 * PRT__QUARTER_MAX];                          /* sin(pi k/(4q)), k < 10q: cos is 2q further */
} prt__grid;

/* All nodes z >= 0 of the Gauss-Legendre rule with count nodes, and their weights: prt__gauss_legendre for many nodes
   at once, each step of the recurrence over all of them, so that it vectorises. */
PRT__STATIC void prt__gauss_legendre_all(int count, double *z, double *weight) {
    double p[PRT__QUARTER_MAX], before[PRT__QUARTER_MAX];
    int half = (count + 1) / 2, step, k, i;
    for (i = 0; i < half; i++)
        z[i] = (1 - (count - 1) / (8.0 * count * count * count)) * cos(PRT__PI * (4 * i + 3) / (4 * count + 2));
    for (step = 0; step < 5; step++) {                             /* the last only for the weight, at the final node */
        for (i = 0; i < half; i++) {
            before[i] = 0;
            p[i] = 1;
        }
        for (k = 1; k <= count; k++) {
            double a = (2 * k - 1) / (double)k, b = (k - 1) / (double)k;
            for (i = 0; i < half; i++) {
                double next = a * (z[i] * p[i]) - b * before[i];
                before[i] = p[i];
                p[i] = next;
            }
        }
        for (i = 0; i < half; i++) {
            double slope = count * (before[i] - z[i] * p[i]) / ((1 - z[i]) * (1 + z[i]));
            weight[i] = 2 / ((1 - z[i]) * (1 + z[i]) * slope * slope);
            z[i] -= p[i] / slope;
        }
    }
    if (count & 1) z[half - 1] = 0;
}

/* The equator, where it is a node, stands for both of its pair: half the weight each. */
PRT__STATIC void prt__grid_compute(prt__grid *grid, double *quarter_sine) {
    double z[PRT__QUARTER_MAX], weight[PRT__QUARTER_MAX];
    int q = grid->quarter, k;
    prt__gauss_legendre_all((3 * grid->bands - 1) / 2, z, weight);
    for (k = 0; k < q; k++) {
        grid->z[k] = (prt_real)z[k];
        grid->weight[k] = (prt_real)(weight[k] * (z[k] > 0 ? 0.5 : 0.25) * PRT__PI / q);
    }
    for (k = 0; k <= 2 * q; k++) quarter_sine[k] = sin(PRT__PI * k / (4 * q));
}

PRT__STATIC void prt__grid_init(prt__grid *grid, int bands) {
    double computed[2 * PRT__QUARTER_MAX + 1];
    const double *quarter_sine = computed;
    int q = (3 * bands + 1) / 4, k, n, first = 0;
    grid->bands = bands;
    grid->quarter = q;
    if (bands <= PRT__GRID_TABLES) {
        for (n = 1; n < bands; n++) first += (3 * n + 1) / 4;
        for (k = 0; k < q; k++) {
            grid->z[k] = (prt_real)prt__grid_nodes()[first + k];
            grid->weight[k] = (prt_real)prt__grid_weights()[first + k];
        }
        quarter_sine = prt__grid_sines() + q * q - 1;
    } else prt__grid_compute(grid, computed);
    for (k = q; k < q + 16; k++) grid->z[k] = grid->weight[k] = 0;
    for (k = 0; k <= 2 * q; k++) {
        prt_real s = (prt_real)quarter_sine[k];
        grid->sine[k] = grid->sine[4 * q - k] = s;
        grid->sine[4 * q + k] = -s;
        if (k) grid->sine[8 * q - k] = -s;
        if (k < 2 * q) grid->sine[8 * q + k] = s;
    }
}

/* Rows of azimuthal coefficients: cosine of m at [2m], sine at [2m+1]. */
typedef prt__vec prt__row[2 * PRT_MAX_BANDS];

/* The samples of a row at one angle and its three mirror images, before they are combined: even and odd m, cosine
   and sine */
typedef struct prt__fourfold { prt__vec ce, co, se, so; } prt__fourfold;

PRT__INLINE prt__fourfold prt__fourfold_of(const prt__grid *grid, const prt__vec *row, int angle) {
    int q = grid->quarter, step = 2 * angle + 1, k = 0, m;
    prt__fourfold s;
    s.ce = row[0];
    s.co = s.se = s.so = prt__vec_set(0);
    for (m = 1; m < grid->bands; m++) {
        k += step;
        if (k >= 8 * q) k -= 8 * q;
        if (m & 1) {
            s.co += grid->sine[k + 2 * q] * row[2 * m];
            s.so += grid->sine[k] * row[2 * m + 1];
        } else {
            s.ce += grid->sine[k + 2 * q] * row[2 * m];
            s.se += grid->sine[k] * row[2 * m + 1];
        }
    }
    return s;
}

/* Four samples from a quad, and, but for a factor 4 in the weight, the way back */
PRT__INLINE prt__fourfold prt__fourfold_mirror(prt__fourfold s) {
    prt__fourfold r;
    prt__vec c = s.ce + s.co, d = s.ce - s.co, a = s.se + s.so, b = s.se - s.so;
    r.ce = c + a;                                                  /* phi */
    r.co = d - b;                                                  /* pi - phi */
    r.se = d + b;                                                  /* pi + phi */
    r.so = c - a;                                                  /* -phi */
    return r;
}

/* h = f g along one circle of latitude */
PRT__STATIC void prt__row_product(const prt__grid *grid, const prt__vec *f, const prt__vec *g, prt__vec *h) {
    prt__fourfold sample[PRT__QUARTER_MAX];
    int q = grid->quarter, j, m;
    for (j = 0; j < q; j++) {
        prt__fourfold a = prt__fourfold_mirror(prt__fourfold_of(grid, f, j)), b, s;
        prt__vec c, d;
        b = f == g ? a : prt__fourfold_mirror(prt__fourfold_of(grid, g, j));
        a.ce *= b.ce;
        a.co *= b.co;
        a.se *= b.se;
        a.so *= b.so;
        c = a.ce + a.so;
        d = a.co + a.se;
        s.ce = c + d;
        s.co = c - d;
        c = a.ce - a.so;
        d = a.se - a.co;
        s.se = c + d;
        s.so = c - d;
        sample[j] = s;
    }
    for (m = 0; m < grid->bands; m++) {
        prt__vec c = prt__vec_set(0), s = prt__vec_set(0);
        int k = m;
        for (j = 0; j < q; j++) {
            c += grid->sine[k + 2 * q] * (m & 1 ? sample[j].co : sample[j].ce);
            s += grid->sine[k] * (m & 1 ? sample[j].so : sample[j].se);
            k += 2 * m;
            if (k >= 8 * q) k -= 8 * q;
        }
        h[2 * m] = c;
        h[2 * m + 1] = s;
    }
}

typedef struct prt__grid_step { prt_real a, c; } prt__grid_step;
PRT__INLINE prt__grid_step prt__grid_factors(int l, int m) {       /* l > m */
    prt__sh_step d = l < PRT__NEAR ? prt__sh_near_step(l, m) : prt__sh_far_step(l, m);
    prt__grid_step s;
    s.a = (prt_real)d.a;
    s.c = (prt_real)d.c;
    return s;
}

/* Columns p(.,m)(z) sqrt(1-z^2)^m of a vector of nodes, m rising: prt__ladder_column starts the next one,
   prt__ladder_climb takes it from l-1 to l. Where powers of sqrt(1-z^2) would underflow, each lane is scaled on its
   own. */
typedef struct prt__ladder {
    prt__vec z, radius, sector, p1, p2;                            /* sector: radius^m, up to the factor in double */
    double factor;
    int scaled;
    prt__scaled power[PRT__LANES], column[PRT__LANES];             /* radius^m and p(l,m), where they need an exponent */
} prt__ladder;

PRT__STATIC void prt__ladder_init(prt__ladder *s, const prt_real *z, int bands) {
    prt_real radius[PRT__LANES];
    int k;
    s->scaled = bands > PRT__SH_UNSCALED_V;
    s->factor = 0;
    for (k = 0; k < PRT__LANES; k++) {
        radius[k] = prt__sqrt((1 - z[k]) * (1 + z[k]));
        s->power[k].p1 = 1;
        s->power[k].p2 = 0;
        s->power[k].exponent = 0;
    }
    s->z = prt__vec_load(z);
    s->radius = prt__vec_load(radius);
    s->sector = prt__vec_set(1);
}

PRT__STATIC void prt__ladder_unscale(prt__ladder *s) {
    prt_real p[PRT__LANES];
    int k;
    for (k = 0; k < PRT__LANES; k++)
        p[k] = (prt_real)(prt__unscaled(s->column[k].p1, s->column[k].exponent + s->power[k].exponent) * s->power[k].p1);
    s->p1 = prt__vec_load(p);
}

PRT__STATIC void prt__ladder_column(prt__ladder *s, int m) {
    int k;
    if (m) s->sector *= s->radius;
    s->factor = prt__sh_sector(m, s->factor);
    s->p1 = (prt_real)s->factor * s->sector;
    s->p2 = prt__vec_set(0);
    if (!s->scaled) return;
    for (k = 0; k < PRT__LANES; k++) {
        prt_real radius[PRT__LANES];
        prt__vec_store(radius, s->radius);
        if (m) prt__scaled_turn(&s->power[k], (double)radius[k], 0);
        s->column[k].p1 = s->factor;
        s->column[k].p2 = 0;
        s->column[k].exponent = 0;
    }
    prt__ladder_unscale(s);
}

PRT__INLINE void prt__ladder_climb(prt__ladder *s, prt__grid_step step) {
    prt__vec p;
    int k;
    if (s->scaled) {
        prt_real z[PRT__LANES];
        prt__sh_step wide;
        wide.a = (double)step.a;
        wide.c = (double)step.c;
        prt__vec_store(z, s->z);
        for (k = 0; k < PRT__LANES; k++) prt__scaled_climb(&s->column[k], (double)z[k], wide);
        prt__ladder_unscale(s);
        return;
    }
    p = step.a * (s->z * s->p1) - step.c * s->p2;
    s->p2 = s->p1;
    s->p1 = p;
}

/* Rows of one function on the circles at +z and -z */
typedef struct prt__rows { prt__row plus, minus; } prt__rows;

/* The row coefficients of column m from its sums over even and odd l-m, cosine and sine */
PRT__INLINE void prt__rows_put(prt__rows *rows, int m, const prt__vec *sum) {
    rows->plus[2 * m] = sum[0] + sum[1];
    rows->minus[2 * m] = sum[0] - sum[1];
    rows->plus[2 * m + 1] = sum[2] + sum[3];
    rows->minus[2 * m + 1] = sum[2] - sum[3];
}

PRT__STATIC void prt__grid_rows(int bands, const prt_real *z, const prt_real *f, const prt_real *g, prt__rows *rf,
                                prt__rows *rg) {
    prt__ladder s;
    int l, m;
    prt__ladder_init(&s, z, bands);
    for (m = 0; m < bands; m++) {
        prt__vec a[4] = { prt__vec_set(0), prt__vec_set(0), prt__vec_set(0), prt__vec_set(0) };
        prt__vec b[4] = { prt__vec_set(0), prt__vec_set(0), prt__vec_set(0), prt__vec_set(0) };
        prt__ladder_column(&s, m);
        for (l = m; l < bands; l++) {
            int odd = (l - m) & 1;
            if (l > m) prt__ladder_climb(&s, prt__grid_factors(l, m));
            a[odd] += f[PRT_SH_INDEX(l, m)] * s.p1;
            a[2 + odd] += f[PRT_SH_INDEX(l, -m)] * s.p1;
            if (f == g) continue;
            b[odd] += g[PRT_SH_INDEX(l, m)] * s.p1;
            b[2 + odd] += g[PRT_SH_INDEX(l, -m)] * s.p1;
        }
        prt__rows_put(rf, m, a);
        if (f != g) prt__rows_put(rg, m, b);
    }
}

/* The sums over the first lanes, a multiple of 4 or all, of four vectors */
PRT__INLINE void prt__vec_sum4(const prt__vec v[4], int lanes, prt_real sum[4]) {
    int i, k;
#if PRT__SIMD && PRT__LANES >= 4
    prt__quad m[4], part[PRT__LANES / 4];
    for (i = 0; i < 4; i++) {
        memcpy(part, &v[i], sizeof part);
        m[i] = part[0];
        for (k = 1; k < lanes / 4; k++) m[i] += part[k];
    }
    prt__quad_transpose(m);
    m[0] = (m[0] + m[2]) + (m[1] + m[3]);
    memcpy(sum, &m[0], sizeof m[0]);
#else
    for (i = 0; i < 4; i++) {
        prt_real lane[PRT__LANES];
        prt__vec_store(lane, v[i]);
        sum[i] = lane[0];
        for (k = 1; k < lanes; k++) sum[i] += lane[k];
    }
#endif
}

/* out += the projection of a group of row pairs, already weighted; two bands at a time, whose sums are taken
   together */
PRT__STATIC void prt__grid_project(int bands, const prt_real *z, int vectors, const prt__rows *rows, prt_real *out) {
    prt__ladder s[PRT__GROUP];
    int l, m, k;
    for (k = 0; k < vectors; k++) prt__ladder_init(&s[k], z + k * PRT__LANES, bands);
    for (m = 0; m < bands; m++) {
        for (k = 0; k < vectors; k++) prt__ladder_column(&s[k], m);
        for (l = m; l < bands; l += 2) {
            prt__vec sum[4] = { prt__vec_set(0), prt__vec_set(0), prt__vec_set(0), prt__vec_set(0) };
            prt_real total[4];
            prt__grid_step even = { 0, 0 }, odd = { 0, 0 };
            if (l > m) even = prt__grid_factors(l, m);
            if (l + 1 < bands) odd = prt__grid_factors(l + 1, m);
            for (k = 0; k < vectors; k++) {
                if (l > m) prt__ladder_climb(&s[k], even);
                sum[0] += s[k].p1 * rows[k].plus[2 * m];
                sum[1] += s[k].p1 * rows[k].plus[2 * m + 1];
                if (l + 1 == bands) continue;
                prt__ladder_climb(&s[k], odd);
                sum[2] += s[k].p1 * rows[k].minus[2 * m];
                sum[3] += s[k].p1 * rows[k].minus[2 * m + 1];
            }
            prt__vec_sum4(sum, PRT__LANES, total);
            out[PRT_SH_INDEX(l, m)] += total[0];
            if (m) out[PRT_SH_INDEX(l, -m)] += total[1];
            if (l + 1 == bands) continue;
            out[PRT_SH_INDEX(l + 1, m)] += total[2];
            if (m) out[PRT_SH_INDEX(l + 1, -m)] += total[3];
        }
    }
}

/* h = f g on both rows, then their even and odd parts times the weight */
PRT__STATIC void prt__rows_product(const prt__grid *grid, prt__vec weight, const prt__rows *f, const prt__rows *g,
                                   prt__rows *h) {
    int i;
    prt__row_product(grid, f->plus, g->plus, h->plus);
    prt__row_product(grid, f->minus, g->minus, h->minus);
    for (i = 0; i < 2 * grid->bands; i++) {
        prt__vec plus = h->plus[i], minus = h->minus[i];
        h->plus[i] = weight * (plus + minus);
        h->minus[i] = weight * (plus - minus);
    }
}

/* out = f g; reads f and g to the end before it writes */
PRT__STATIC void prt__grid_product(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    prt__grid grid;
    prt__rows rf, rg, rh[PRT__GROUP];
    prt_real sum[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int first, k;
    prt__grid_init(&grid, bands);
    memset(sum, 0, sizeof(prt_real) * (size_t)PRT_SH_COUNT(bands));
    for (first = 0; first < grid.quarter; first += PRT__GROUP * PRT__LANES) {
        for (k = 0; k < PRT__GROUP && first + k * PRT__LANES < grid.quarter; k++) {
            const int node = first + k * PRT__LANES;
            prt__grid_rows(bands, grid.z + node, f, g, &rf, &rg);
            prt__rows_product(&grid, prt__vec_load(grid.weight + node), &rf, f == g ? &rf : &rg, &rh[k]);
        }
        prt__grid_project(bands, grid.z + first, k, rh, sum);
    }
    memcpy(out, sum, sizeof(prt_real) * (size_t)PRT_SH_COUNT(bands));
}

/* f times a function of z alone: column by column, no azimuth. Rows of the zonal factor: even l at [0], odd l at
   [1]. */
PRT__STATIC void prt__zonal_product(int bands, const prt_real *f, const prt_real *zonal, prt_real *out) {
    prt__grid grid;
    prt__rows rows;
    int q, first, l, k;
    prt__grid_init(&grid, bands);
    q = grid.quarter;
    memset(out, 0, sizeof(prt_real) * (size_t)PRT_SH_COUNT(bands));
    for (first = 0; first < q; first += PRT__LANES) {
        prt__vec even = prt__vec_set(0), odd = prt__vec_set(0);
        prt__vec circle = (prt_real)(4 * q) * prt__vec_load(grid.weight + first);      /* all azimuths: 2 pi w */
        prt__ladder s;
        prt__ladder_init(&s, grid.z + first, bands);
        prt__ladder_column(&s, 0);
        for (l = 0; l < bands; l++) {
            if (l) prt__ladder_climb(&s, prt__grid_factors(l, 0));
            if (l & 1) odd += zonal[l] * s.p1;
            else even += zonal[l] * s.p1;
        }
        prt__grid_rows(bands, grid.z + first, f, f, &rows, &rows);
        for (k = 0; k < 2 * bands; k++) {
            prt__vec plus = rows.plus[k] * (even + odd), minus = rows.minus[k] * (even - odd);
            prt__vec weight = k < 2 ? circle : PRT__R(0.5) * circle;               /* int 1 or cos^2 */
            rows.plus[k] = weight * (plus + minus);
            rows.minus[k] = weight * (plus - minus);
        }
        prt__grid_project(bands, grid.z + first, 1, &rows, out);
    }
}

/* ---- batches: a product in each lane ---- */

/* p(l,m) sqrt(1-z^2)^m for the bands of a tabulated grid at one node, column after column */
PRT__STATIC void prt__node_column(int bands, prt_real z, const prt__grid_step *steps, prt_real *p) {
    prt_real radius = prt__sqrt((1 - z) * (1 + z)), power = 1;
    double factor = 0;
    int l, m;
    for (m = 0; m < bands; m++) {
        prt_real p1, p2 = 0;
        factor = prt__sh_sector(m, factor);
        *p++ = p1 = (prt_real)factor * power;
        for (l = m + 1; l < bands; l++) {
            const prt__grid_step *step = &steps[l * (l - 1) / 2 + m];
            prt_real next = step->a * (z * p1) - step->c * p2;
            p2 = p1;
            *p++ = p1 = next;
        }
        power *= radius;
    }
}

PRT__STATIC void prt__node_rows(int bands, const prt_real *p, const prt_real *f, size_t stride, prt__rows *rows) {
    int l, m;
    for (m = 0; m < bands; m++) {
        prt__vec sum[4] = { prt__vec_set(0), prt__vec_set(0), prt__vec_set(0), prt__vec_set(0) };
        for (l = m; l < bands; l++, p++) {
            int odd = (l - m) & 1;
            sum[odd] += *p * prt__vec_load(f + (size_t)PRT_SH_INDEX(l, m) * stride);
            if (m) sum[2 + odd] += *p * prt__vec_load(f + (size_t)PRT_SH_INDEX(l, -m) * stride);
        }
        prt__rows_put(rows, m, sum);
    }
}

PRT__STATIC void prt__node_project(int bands, const prt_real *p, const prt__rows *rows, prt__vec *out) {
    int l, m;
    for (m = 0; m < bands; m++)
        for (l = m; l < bands; l++, p++) {
            const prt__vec *row = (l - m) & 1 ? rows->minus : rows->plus;
            out[PRT_SH_INDEX(l, m)] += *p * row[2 * m];
            if (m) out[PRT_SH_INDEX(l, -m)] += *p * row[2 * m + 1];
        }
}

/* PRT__LANES products at once; bands <= PRT__GRID_TABLES */
PRT__STATIC void prt__grid_product_v(const prt__grid *grid, const prt__grid_step *steps, const prt_real *f,
                                     const prt_real *g, prt_real *out, size_t stride) {
    prt_real p[PRT__GRID_TABLES * (PRT__GRID_TABLES + 1) / 2];
    prt__vec sum[PRT__GRID_TABLES * PRT__GRID_TABLES];
    prt__rows rf, rg, rh;
    int n = PRT_SH_COUNT(grid->bands), i, k;
    for (i = 0; i < n; i++) sum[i] = prt__vec_set(0);
    for (k = 0; k < grid->quarter; k++) {
        prt__node_column(grid->bands, grid->z[k], steps, p);
        prt__node_rows(grid->bands, p, f, stride, &rf);
        if (f != g) prt__node_rows(grid->bands, p, g, stride, &rg);
        prt__rows_product(grid, prt__vec_set(grid->weight[k]), &rf, f == g ? &rf : &rg, &rh);
        prt__node_project(grid->bands, p, &rh, sum);
    }
    for (i = 0; i < n; i++) prt__vec_store(out + (size_t)i * stride, sum[i]);
}

/* ---- 3 to 6 bands: generated rows and products of rows; see codegen/kernel_nodes.c ----

   The same nodes as the grid's, but series are multiplied as series. A vector holds a circle in each lane (one product;
   the mirror images at -z too, where they fit beside) or a product in each lane (a batch). */

enum {
    PRT__NODE_BANDS = 6,
    PRT__NODES = PRT__LANES > 8 ? PRT__LANES : 8,                  /* room for the nodes in a row of the table */
    PRT__ROW = 2 * PRT__NODE_BANDS,
    PRT__TERMS = PRT__NODE_BANDS * PRT__NODE_BANDS
};

typedef void prt__rows_kernel(const prt_real *f, const prt_real *q, prt__vec *plus, prt__vec *minus);
typedef void prt__terms_kernel(const prt__vec *even, const prt__vec *odd, const prt_real *q, prt__vec *out);
typedef void prt__row_kernel_v(const prt__vec *w, const prt__vec *v, prt__vec *out);
typedef void prt__rows_kernel_v(const prt__vec *f, const prt_real *q, prt__vec *plus, prt__vec *minus);
static prt__rows_kernel prt__sh_rows_3, prt__sh_rows_4, prt__sh_rows_5, prt__sh_rows_6;
static prt__rows_kernel_v prt__sh_rows_5_v, prt__sh_rows_6_v;
static prt__terms_kernel prt__sh_terms_3, prt__sh_terms_4, prt__sh_terms_5, prt__sh_terms_6;
static prt__row_kernel_v prt__row_product_3_v, prt__row_product_4_v, prt__row_product_5_v, prt__row_product_6_v;
static const prt_real *prt__nodes_3(void), *prt__nodes_4(void), *prt__nodes_5(void), *prt__nodes_6(void);

/* Pairs of nodes +-z, and the pairs that a row of the table has room for */
PRT__INLINE int prt__node_pairs(int bands) { return (3 * bands + 1) / 4; }
PRT__INLINE int prt__node_room(int bands) { return bands == 3 ? 2 : 4; }

/* Even and odd parts from rows at z and -z */
PRT__INLINE void prt__rows_fold(int count, const prt__vec *plus, const prt__vec *minus, prt__vec *even, prt__vec *odd) {
    int i;
    for (i = 0; i < count; i++) {
        prt__vec a = plus[i], b = minus[i];
        even[i] = a + b;
        odd[i] = a - b;
    }
}

/* out = f g; reads f and g to the end before it writes */
PRT__INLINE void prt__node_product(int bands, const prt_real *q, prt__rows_kernel *rows, prt__row_kernel_v *multiply,
                                   prt__terms_kernel *terms, const prt_real *f, const prt_real *g, prt_real *out) {
    prt__vec fp[PRT__ROW], fm[PRT__ROW], gp[PRT__ROW], gm[PRT__ROW], even[PRT__ROW], odd[PRT__ROW];
    prt__vec term[PRT__TERMS + 3], more[PRT__TERMS];
    const int n = bands * bands, room = prt__node_room(bands), whole = PRT__LANES >= 2 * room;
    int at, i;
    for (at = 0; at < prt__node_pairs(bands); at += PRT__LANES) {
        rows(f, q + at, fp, fm);
        if (f != g) rows(g, q + at, gp, gm);
        multiply(fp, f == g ? fp : gp, even);
        if (whole) terms(even, even, q + at, term);
        else {
            multiply(fm, f == g ? fm : gm, odd);
            odd[1] = even[1] = prt__vec_set(0);
            prt__rows_fold(2 * bands, even, odd, even, odd);
            terms(even, odd, q + at, at ? more : term);
            if (at) for (i = 0; i < n; i++) term[i] += more[i];
        }
    }
    for (i = n; i & 3; i++) term[i] = prt__vec_set(0);
    for (i = 0; i < n; i += 4) {
        prt_real sum[4];
        prt__vec_sum4(term + i, PRT__LANES > 8 ? 8 : PRT__LANES, sum);
        memcpy(out + i, sum, sizeof(prt_real) * (size_t)(n - i < 4 ? n - i : 4));
    }
}

PRT__STATIC void prt__product_3(const prt_real *f, const prt_real *g, prt_real *out) {
    prt__node_product(3, prt__nodes_3(), prt__sh_rows_3, prt__row_product_3_v, prt__sh_terms_3, f, g, out);
}
PRT__STATIC void prt__product_4(const prt_real *f, const prt_real *g, prt_real *out) {
    prt__node_product(4, prt__nodes_4(), prt__sh_rows_4, prt__row_product_4_v, prt__sh_terms_4, f, g, out);
}
PRT__STATIC void prt__product_5(const prt_real *f, const prt_real *g, prt_real *out) {
    prt__node_product(5, prt__nodes_5(), prt__sh_rows_5, prt__row_product_5_v, prt__sh_terms_5, f, g, out);
}
PRT__STATIC void prt__product_6(const prt_real *f, const prt_real *g, prt_real *out) {
    prt__node_product(6, prt__nodes_6(), prt__sh_rows_6, prt__row_product_6_v, prt__sh_terms_6, f, g, out);
}

/* The factors of a batch: those of one node after the other, the same in all lanes */
typedef struct prt__node_block { prt_real q[4][PRT__NODE_BANDS * (PRT__NODE_BANDS + 1) / 2 * PRT__NODES]; } prt__node_block;

PRT__STATIC void prt__node_block_init(prt__node_block *block, int bands) {
    const prt_real *q = bands == 5 ? prt__nodes_5() : prt__nodes_6();
    int k, i;
    for (k = 0; k < prt__node_pairs(bands); k++)
        for (i = 0; i < bands * (bands + 1) / 2; i++)
            prt__vec_store(block->q[k] + i * PRT__NODES, prt__vec_set(q[i * PRT__NODES + k]));
}

/* The projection of all pairs of circles */
PRT__INLINE void prt__block_project(int bands, const prt__node_block *block, const prt__vec *even,
                                    const prt__vec *odd, prt_real *out, size_t stride) {
    const int pairs = prt__node_pairs(bands);
    int l, m, k;
    for (l = 0; l < bands; l++)
        for (m = 0; m <= l; m++) {
            const prt__vec *row = ((l - m) & 1 ? odd : even) + 2 * m;
            prt__vec c = prt__vec_set(0), s = prt__vec_set(0);
            for (k = 0; k < pairs; k++) {
                prt__vec q = prt__vec_load(block->q[k] + (l * (l + 1) / 2 + m) * PRT__NODES);
                c += q * row[k * PRT__ROW];
                s += q * row[k * PRT__ROW + 1];
            }
            prt__vec_store(out + (size_t)PRT_SH_INDEX(l, m) * stride, c);
            if (m) prt__vec_store(out + (size_t)PRT_SH_INDEX(l, -m) * stride, s);
        }
}

/* PRT__LANES products at once */
PRT__INLINE void prt__block_product(int bands, const prt__node_block *block, prt__rows_kernel_v *rows,
                                    prt__row_kernel_v *multiply, const prt_real *f, const prt_real *g, prt_real *out,
                                    size_t stride) {
    prt__vec a[PRT__TERMS], b[PRT__TERMS], fp[PRT__ROW], fm[PRT__ROW], gp[PRT__ROW], gm[PRT__ROW];
    prt__vec even[4][PRT__ROW], odd[4][PRT__ROW];
    int i, k;
    for (i = 0; i < bands * bands; i++) {
        a[i] = prt__vec_load(f + (size_t)i * stride);
        b[i] = prt__vec_load(g + (size_t)i * stride);
    }
    for (k = 0; k < prt__node_pairs(bands); k++) {
        rows(a, block->q[k], fp, fm);
        if (f != g) rows(b, block->q[k], gp, gm);
        multiply(fp, f == g ? fp : gp, even[k]);
        multiply(fm, f == g ? fm : gm, odd[k]);
        even[k][1] = odd[k][1] = prt__vec_set(0);
        prt__rows_fold(2 * bands, even[k], odd[k], even[k], odd[k]);
    }
    prt__block_project(bands, block, even[0], odd[0], out, stride);
}

PRT__STATIC void prt__product_5_block(const prt__node_block *block, const prt_real *f, const prt_real *g, prt_real *out,
                                      size_t stride) {
    prt__block_product(5, block, prt__sh_rows_5_v, prt__row_product_5_v, f, g, out, stride);
}
PRT__STATIC void prt__product_6_block(const prt__node_block *block, const prt_real *f, const prt_real *g, prt_real *out,
                                      size_t stride) {
    prt__block_product(6, block, prt__sh_rows_6_v, prt__row_product_6_v, f, g, out, stride);
}

/* ---- dispatch ---- */

typedef void prt__product_kernel(const prt_real *f, const prt_real *g, prt_real *out);
typedef void prt__product_kernel_v(const prt_real *f, const prt_real *g, prt_real *out, size_t stride);
typedef void prt__square_kernel(const prt_real *f, prt_real *out);
static prt__product_kernel prt__sh_product_1, prt__sh_product_2, prt__sh_product_3, prt__sh_product_4;
static prt__product_kernel_v prt__sh_product_1_v, prt__sh_product_2_v, prt__sh_product_3_v, prt__sh_product_4_v;
static prt__square_kernel prt__sh_square_1, prt__sh_square_2, prt__sh_square_3, prt__sh_square_4, prt__sh_square_5;

PRT__STATIC void prt__product(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    switch (bands) {
    case 1: prt__sh_product_1(f, g, out); break;
    case 2: prt__sh_product_2(f, g, out); break;
    case 3: if (PRT__LANES == 4) prt__product_3(f, g, out); else prt__sh_product_3(f, g, out); break;
    case 4: if (PRT__LANES >= 2) prt__product_4(f, g, out); else prt__sh_product_4(f, g, out); break;
    case 5: prt__product_5(f, g, out); break;
    case 6: prt__product_6(f, g, out); break;
    default: prt__grid_product(bands, f, g, out);
    }
}

PRTDEF prt_result prt_sh_product(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !g || !out) return PRT_ERR_NULL;
    prt__product(bands, f, g, out);
    return PRT_OK;
}

PRT__STATIC void prt__square(int bands, const prt_real *f, prt_real *out) {
    switch (bands) {
    case 1: prt__sh_square_1(f, out); break;
    case 2: prt__sh_square_2(f, out); break;
    case 3: prt__sh_square_3(f, out); break;
    case 4: if (PRT__LANES >= 4) prt__product_4(f, f, out); else prt__sh_square_4(f, out); break;
    case 5: if (PRT__LANES >= 2) prt__product_5(f, f, out); else prt__sh_square_5(f, out); break;
    default: prt__product(bands, f, f, out);
    }
}

PRTDEF prt_result prt_sh_square(int bands, const prt_real *f, prt_real *out) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    prt__square(bands, f, out);
    return PRT_OK;
}

/* Columns first ... first+lanes-1 of an array of structures of arrays, to or from a block of PRT__LANES */
PRT__STATIC void prt__lanes_in(int count, const prt_real *from, size_t stride, int lanes, prt_real *block) {
    int i;
    for (i = 0; i < count; i++)
        prt__vec_store(block + i * PRT__LANES, prt__vec_load_part(from + (size_t)i * stride, lanes));
}

/* What a batch of so many bands prepares: the factors of its nodes, or its grid */
typedef struct prt__batch {
    prt__node_block block;
    prt__grid grid;
    prt__grid_step steps[PRT__GRID_TABLES * (PRT__GRID_TABLES - 1) / 2];
} prt__batch;

PRT__STATIC void prt__batch_init(prt__batch *batch, int bands) {
    int l, m;
    if (bands <= PRT__NODE_BANDS) {
        if (bands > 4) prt__node_block_init(&batch->block, bands);
        return;
    }
    prt__grid_init(&batch->grid, bands);
    for (l = 1; l < bands; l++)
        for (m = 0; m < l; m++) batch->steps[l * (l - 1) / 2 + m] = prt__grid_factors(l, m);
}

PRT__STATIC void prt__product_lanes(int bands, const prt__batch *batch, const prt_real *f, const prt_real *g,
                                    prt_real *out, size_t stride) {
    switch (bands) {
    case 1: prt__sh_product_1_v(f, g, out, stride); break;
    case 2: prt__sh_product_2_v(f, g, out, stride); break;
    case 3: prt__sh_product_3_v(f, g, out, stride); break;
    case 4: prt__sh_product_4_v(f, g, out, stride); break;
    case 5: prt__product_5_block(&batch->block, f, g, out, stride); break;
    case 6: prt__product_6_block(&batch->block, f, g, out, stride); break;
    default: prt__grid_product_v(&batch->grid, batch->steps, f, g, out, stride);
    }
}

/* Beyond the tabulated grids: pair after pair */
PRT__STATIC void prt__product_each(int bands, int count, const prt_real *f, const prt_real *g, prt_real *out,
                                   size_t stride) {
    prt_real a[PRT_SH_COUNT(PRT_MAX_BANDS)], b[PRT_SH_COUNT(PRT_MAX_BANDS)];
    size_t n = (size_t)PRT_SH_COUNT(bands), i;
    int k;
    for (k = 0; k < count; k++, f++, g++, out++) {
        a[0] = f[0];
        b[0] = g[0];
        for (i = 1; i < n; i++) {
            a[i] = f[i * stride];
            b[i] = g[i * stride];
        }
        prt__grid_product(bands, a, b, a);
        for (i = 0; i < n; i++) out[i * stride] = a[i];
    }
}

PRT__STATIC void prt__product_batch(int bands, int count, const prt_real *f, const prt_real *g, prt_real *out,
                                    size_t stride) {
    enum { MOST = PRT__GRID_TABLES * PRT__GRID_TABLES * PRT__LANES };
    prt_real a[MOST], b[MOST];
    prt__batch batch;
    int n = PRT_SH_COUNT(bands), i, k;
    a[0] = b[0] = 0;
    prt__batch_init(&batch, bands);
    for (k = 0; k + PRT__LANES <= count; k += PRT__LANES)
        prt__product_lanes(bands, &batch, f + k, g + k, out + k, stride);
    if (k >= count) return;
    prt__lanes_in(n, f + k, stride, count - k, a);
    if (f != g) prt__lanes_in(n, g + k, stride, count - k, b);
    prt__product_lanes(bands, &batch, a, f == g ? a : b, a, PRT__LANES);
    for (i = 0; i < n; i++)
        prt__vec_store_part(out + (size_t)i * stride + k, prt__vec_load(a + i * PRT__LANES), count - k);
}

PRTDEF prt_result prt_sh_product_soa(int bands, int count, const prt_real *f, const prt_real *g, prt_real *out,
                                     size_t stride) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0 || stride < (size_t)count) return PRT_ERR_COUNT;
    if (count == 0) return PRT_OK;
    if (!f || !g || !out) return PRT_ERR_NULL;
    if (bands <= PRT__GRID_TABLES) prt__product_batch(bands, count, f, g, out, stride);
    else prt__product_each(bands, count, f, g, out, stride);
    return PRT_OK;
}

/* Column m: evaluated on the circles, times the zonal function, projected again; the azimuth takes no part. */
PRTDEF prt_result prt_sh_product_zonal(int bands, const prt_real *f, const prt_real *zonal, prt_real *out) {
    prt_real sum[PRT_SH_COUNT(PRT_MAX_BANDS)];
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !zonal || !out) return PRT_ERR_NULL;
    prt__zonal_product(bands, f, zonal, sum);
    memcpy(out, sum, sizeof(prt_real) * (size_t)PRT_SH_COUNT(bands));
    return PRT_OK;
}

/* Column j is the product with the unit vector of coefficient j; the matrix is symmetric. */
PRTDEF prt_result prt_sh_product_matrix(int bands, const prt_real *filter, prt_real *matrix) {
    prt_real unit[PRT_SH_COUNT(PRT_MAX_BANDS)];
    size_t n, i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!filter || !matrix) return PRT_ERR_NULL;
    n = (size_t)PRT_SH_COUNT(bands);
    memset(unit, 0, sizeof(prt_real) * n);
    for (i = 0; i < n; i++) {
        unit[i] = 1;
        prt__product(bands, unit, filter, matrix + i * n);
        unit[i] = 0;
    }
    return PRT_OK;
}

PRTDEF prt_result prt_sh_product_by(int bands, const prt_real *matrix, const prt_real *f, prt_real *out) {
    return prt_sh_product_by_n(bands, matrix, 1, f, out);
}

PRTDEF prt_result prt_sh_product_by_n(int bands, const prt_real *matrix, int count, const prt_real *f, prt_real *out) {
    int n, i, k;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0) return PRT_ERR_COUNT;
    if (count == 0) return PRT_OK;
    if (!matrix || !f || !out) return PRT_ERR_NULL;
    n = PRT_SH_COUNT(bands);
    for (k = 0; k < count; k++, f += n, out += n)
        for (i = 0; i < n; i++) out[i] = prt__dot(n, matrix + (size_t)i * (size_t)n, f);
    return PRT_OK;
}

/* ---- masks ---- */

PRT__STATIC prt_result prt__mask(int bands, prt_window w, int both, const prt_real *light, const prt_real *filter,
                                 prt_real *out) {
    prt_real a[PRT_SH_COUNT(PRT_MAX_BANDS)], b[PRT_SH_COUNT(PRT_MAX_BANDS)];
    double weight[PRT_MAX_BANDS];
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!light || !filter || !out) return PRT_ERR_NULL;
    if (!prt__window_ok(w)) return PRT_ERR_VALUE;
    if (w != PRT_WINDOW_NONE) {
        prt__window_weights(w, bands, bands, weight);
        prt__scale_bands(bands, weight, filter, b);
        filter = b;
        if (both) {
            prt__scale_bands(bands, weight, light, a);
            light = a;
        }
    }
    prt__product(bands, light, filter, out);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_mask(int bands, prt_window w, const prt_real *light, const prt_real *filter, prt_real *out) {
    return prt__mask(bands, w, 1, light, filter, out);
}

PRTDEF prt_result prt_sh_mask_filter(int bands, prt_window w, const prt_real *light, const prt_real *filter,
                                     prt_real *out) {
    return prt__mask(bands, w, 0, light, filter, out);
}

/* ---- logarithm and exponential ---- */

/* Eigenvalues (on the diagonal of a) and eigenvectors (columns of v) of a small symmetric matrix: cyclic Jacobi
   rotations. */
PRT__STATIC void prt__jacobi(int n, double a[PRT_KRYLOV_MAX][PRT_KRYLOV_MAX],
                             double v[PRT_KRYLOV_MAX][PRT_KRYLOV_MAX]) {
    int sweep, p, q, k;
    for (p = 0; p < n; p++)
        for (q = 0; q < n; q++) v[p][q] = p == q;
    for (sweep = 0; sweep < 16; sweep++) {
        int rotated = 0;
        for (p = 0; p < n; p++)
            for (q = p + 1; q < n; q++) {
                double off = a[p][q], spread, t, c, s;
                if (!(fabs(off) > 1e-17 * (fabs(a[p][p]) + fabs(a[q][q])))) continue;
                rotated = 1;
                spread = (a[q][q] - a[p][p]) / (2 * off);
                t = (spread < 0 ? -1 : 1) / (fabs(spread) + sqrt(spread * spread + 1));
                c = 1 / sqrt(t * t + 1);
                s = t * c;
                for (k = 0; k < n; k++) {
                    double x = a[k][p], y = a[k][q];
                    a[k][p] = c * x - s * y;
                    a[k][q] = s * x + c * y;
                }
                for (k = 0; k < n; k++) {
                    double x = a[p][k], y = a[q][k], z = v[k][p];
                    a[p][k] = c * x - s * y;
                    a[q][k] = s * x + c * y;
                    v[k][p] = c * z - s * v[k][q];
                    v[k][q] = s * z + c * v[k][q];
                }
            }
        if (!rotated) break;
    }
}

typedef struct prt__krylov {
    int steps;                                                     /* as many as the space has dimensions */
    double t[PRT_KRYLOV_MAX][PRT_KRYLOV_MAX];                      /* M_f in the basis: tridiagonal */
    prt_real basis[PRT_KRYLOV_MAX][PRT_SH_COUNT(PRT_MAX_BANDS)];   /* orthonormal; the first is the constant */
} prt__krylov;

/* w less its parts along the basis so far, twice, as rounding asks; returns its length */
PRT__STATIC double prt__krylov_orthogonalise(const prt__krylov *s, int n, int count, prt_real *w) {
    double sum = 0;
    int pass, j, i;
    for (pass = 0; pass < 2; pass++)
        for (j = 0; j < count; j++) {
            prt_real part = prt__dot(n, w, s->basis[j]);
            for (i = 0; i < n; i++) w[i] -= part * s->basis[j][i];
        }
    for (i = 0; i < n; i++) sum += (double)w[i] * (double)w[i];
    return sqrt(sum);
}

/* Lanczos, from the constant */
PRT__STATIC void prt__krylov_build(prt__krylov *s, int bands, int steps, const prt_real *f) {
    int n = PRT_SH_COUNT(bands), j, i;
    double size = sqrt((double)prt__dot(n, f, f));
    prt_real w[PRT_SH_COUNT(PRT_MAX_BANDS)];
    memset(s->t, 0, sizeof s->t);
    memset(s->basis[0], 0, sizeof(prt_real) * (size_t)n);
    s->basis[0][0] = 1;
    for (j = 0;; j++) {
        double length;
        if (j) prt__product(bands, f, s->basis[j], w);
        else for (i = 0; i < n; i++) w[i] = PRT__R(0.28209479177387814347) * f[i];
        s->t[j][j] = (double)prt__dot(n, w, s->basis[j]);
        s->steps = j + 1;
        if (s->steps == steps) return;
        length = prt__krylov_orthogonalise(s, n, s->steps, w);
        if (length <= 8 * PRT__EPS * size) return;
        s->t[j][j + 1] = s->t[j + 1][j] = length;
        for (i = 0; i < n; i++) s->basis[j + 1][i] = w[i] / (prt_real)length;
    }
}

/* out = log(M_f) 1, eigenvalues below least counted as least */
PRT__STATIC void prt__krylov_log(int bands, int steps, double least, const prt_real *f, prt_real *out) {
    prt__krylov s;
    double v[PRT_KRYLOV_MAX][PRT_KRYLOV_MAX], part[PRT_KRYLOV_MAX] = { 0 };
    int n = PRT_SH_COUNT(bands), i, j;
    prt__krylov_build(&s, bands, steps, f);
    prt__jacobi(s.steps, s.t, v);
    for (i = 0; i < s.steps; i++) {
        double x = s.t[i][i], weight = v[0][i] * log(x < least ? least : x) * 3.5449077018110320546;
        for (j = 0; j < s.steps; j++) part[j] += v[j][i] * weight;
    }
    memset(out, 0, sizeof(prt_real) * (size_t)n);
    for (j = 0; j < s.steps; j++)
        for (i = 0; i < n; i++) out[i] += (prt_real)part[j] * s.basis[j][i];
}

PRTDEF prt_result prt_sh_log(int bands, int steps, prt_real least, const prt_real *f, prt_real *out) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (steps < 1 || steps > PRT_KRYLOV_MAX) return PRT_ERR_COUNT;
    if (!f || !out) return PRT_ERR_NULL;
    if (!(least > 0) || !prt__finite(least)) return PRT_ERR_VALUE;
    prt__krylov_log(bands, steps, (double)least, f, out);
    return PRT_OK;
}

/* out = 1 + x + x^2/2 + x^3/6 + x^4/24 by Horner's rule; |x| <= 1 */
PRT__STATIC void prt__exp_series(int bands, const prt_real *x, prt_real *out) {
    static const prt_real factor[4] = { 1, PRT__R(0.5), PRT__R(0.33333333333333333333), PRT__R(0.25) };
    int n = PRT_SH_COUNT(bands), k, i;
    for (i = 0; i < n; i++) out[i] = factor[3] * x[i];
    out[0] += PRT__R(3.5449077018110320546);
    for (k = 2; k >= 0; k--) {
        prt__product(bands, x, out, out);
        for (i = 0; i < n; i++) out[i] *= factor[k];
        out[0] += PRT__R(3.5449077018110320546);
    }
}

PRTDEF prt_result prt_sh_exp(int bands, const prt_real *f, prt_real *out) {
    prt_real x[PRT_SH_COUNT(PRT_MAX_BANDS)];
    double mean, length, factor = 1;
    int n, halvings = 0, i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    n = PRT_SH_COUNT(bands);
    mean = exp(0.28209479177387814347 * (double)f[0]);
    memcpy(x, f, sizeof(prt_real) * (size_t)n);
    x[0] = 0;
    for (length = sqrt((double)prt__dot(n, x, x)); length > 1 && halvings < 30; length /= 2) {
        halvings++;
        factor /= 2;
    }
    for (i = 0; i < n; i++) x[i] = (prt_real)((double)x[i] * factor);
    prt__exp_series(bands, x, out);
    for (i = 0; i < halvings; i++) prt__square(bands, out, out);
    for (i = 0; i < n; i++) out[i] = (prt_real)((double)out[i] * mean);
    return PRT_OK;
}

PRTDEF prt_result prt_sh_exp_linear(int bands, const prt_real *f, prt_real *out) {
    double mean, square, v, slope;
    int n, i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    n = PRT_SH_COUNT(bands);
    mean = 3.5449077018110320546 * (double)f[0];
    square = (double)prt__dot(n, f, f);
    v = mean < 0 ? square / mean : 0;
    slope = v < -1e-6 ? (exp(v) - 1) / v : 1;
    for (i = 0; i < n; i++) out[i] = (prt_real)slope * f[i];
    out[0] += PRT__R(3.5449077018110320546);
    return PRT_OK;
}

#ifndef PRT_NO_CH
/* ---------------------------------------------------------------------------------------------------- >>ch ---- */

static prt__sh_kernel prt__ch_eval_1, prt__ch_eval_2, prt__ch_eval_3, prt__ch_eval_4, prt__ch_eval_5,
                      prt__ch_eval_6, prt__ch_eval_7, prt__ch_eval_8, prt__ch_eval_9, prt__ch_eval_10;
static prt__sh_kernel_v prt__ch_eval_1_v, prt__ch_eval_2_v, prt__ch_eval_3_v, prt__ch_eval_4_v, prt__ch_eval_5_v,
                        prt__ch_eval_6_v, prt__ch_eval_7_v, prt__ch_eval_8_v, prt__ch_eval_9_v, prt__ch_eval_10_v;
static prt__sh_kernel_at prt__ch_at_1, prt__ch_at_2, prt__ch_at_3, prt__ch_at_4, prt__ch_at_5,
                         prt__ch_at_6, prt__ch_at_7, prt__ch_at_8, prt__ch_at_9, prt__ch_at_10;
static const double *prt__ch_a(void), *prt__ch_c(void);

static prt__sh_kernel *const prt__ch_kernels[PRT__SH_KERNELS] = {
    prt__ch_eval_1, prt__ch_eval_2, prt__ch_eval_3, prt__ch_eval_4, prt__ch_eval_5,
    prt__ch_eval_6, prt__ch_eval_7, prt__ch_eval_8, prt__ch_eval_9, prt__ch_eval_10
};
static prt__sh_kernel_v *const prt__ch_kernels_v[PRT__SH_KERNELS] = {
    prt__ch_eval_1_v, prt__ch_eval_2_v, prt__ch_eval_3_v, prt__ch_eval_4_v, prt__ch_eval_5_v,
    prt__ch_eval_6_v, prt__ch_eval_7_v, prt__ch_eval_8_v, prt__ch_eval_9_v, prt__ch_eval_10_v
};
static prt__sh_kernel_at *const prt__ch_kernels_at[PRT__SH_KERNELS] = {
    prt__ch_at_1, prt__ch_at_2, prt__ch_at_3, prt__ch_at_4, prt__ch_at_5,
    prt__ch_at_6, prt__ch_at_7, prt__ch_at_8, prt__ch_at_9, prt__ch_at_10
};

/* Entry j+1 of a row of S over entry j. T_l = sum_j t(l,j) P_{l-2j}, and with L = l-2j
     t(l,j+1)/t(l,j) = (2L-3)(2j-1)(2l-2j+1) / ((2L+1)(2j+2)(2l-2j-2)),
   derivatives keep it; the root is K(L,m)/K(L-2,m). */
PRT__STATIC double prt__ch_ratio(int l, int m, int j) {
    double L = l - 2 * j, t = (2 * L - 3) * (2 * j - 1) * (2 * l - 2 * j + 1) / ((2 * L + 1) * (2 * j + 2) * (l + L - 2));
    return t * sqrt((2 * L + 1) * (L - m) * (L - m - 1) / ((2 * L - 3) * (L + m) * (L + m - 1)));
}

/* H(l,m) = 1 + q0 (1 + q1 (1 + ...)), the square of the row's length over that of its first entry; 1 <= H <= 1.33 */
PRT__STATIC double prt__ch_length2(int l, int m) {
    double h = 1;
    int j;
    for (j = (l - m) / 2 - 1; j >= 0; j--) {
        double r = prt__ch_ratio(l, m, j);
        h = 1 + r * r * h;
    }
    return h;
}

/* row[j] = S(l, l-2j, m): C(l,m) = sum_j row[j] Y(l-2j,m). Returns how many. */
PRT__STATIC int prt__ch_row(int l, int m, double *row) {
    int j, count = (l - m) / 2 + 1;
    row[0] = 1 / sqrt(prt__ch_length2(l, m));
    for (j = 0; j + 1 < count; j++) row[j + 1] = row[j] * prt__ch_ratio(l, m, j);
    return count;
}

PRT__STATIC double prt__ch_far_a(int l, int m) {
    return sqrt((4.0 * l * l - 1) / ((double)(l - m) * (l + m)) * prt__ch_length2(l - 1, m) / prt__ch_length2(l, m));
}

PRT__STATIC prt__sh_step prt__ch_far_step(int l, int m) {
    prt__sh_step s;
    s.a = prt__ch_far_a(l, m);
    s.c = l - m < 2 ? 0 : s.a * prt__ch_far_a(l - 1, m) * (l + m - 2) * (l - 1 - m) / (4.0 * (l - 2) * (l - 1));
    return s;
}

PRT__INLINE prt__sh_step prt__ch_near_step(int l, int m) {
    int i = (l - 1) * l / 2 + m;
    prt__sh_step s;
    s.a = prt__ch_a()[i];
    s.c = prt__ch_c()[i];
    return s;
}

PRT__STATIC prt_real prt__ch_recurrence(int bands, prt_vec3 d, const prt_real *f, prt_real *PRT__RESTRICT y,
                                        size_t stride) {
    return prt__recurrence_with(prt__ch_near_step, prt__ch_far_step, bands, d, f, y, stride);
}
PRT__STATIC void prt__ch_recurrence_v(int bands, const prt__sh_block *b) {
    prt__recurrence_with_v(prt__ch_near_step, prt__ch_far_step, bands, b);
}

static const prt__basis prt__ch_basis = {
    prt__ch_kernels, prt__ch_kernels_v, prt__ch_kernels_at, prt__ch_recurrence, prt__ch_recurrence_v
};

/* A product of many integers and their inverses that keeps what rounding drops: value = (hi + lo) 2^exponent. */
typedef struct prt__long_product { double hi, lo; int exponent; } prt__long_product;

PRT__STATIC void prt__multiply(prt__long_product *p, double k) {
    double hi = p->hi * k;
    p->lo = p->lo * k + fma(p->hi, k, -hi);
    p->hi = hi;
}

PRT__STATIC void prt__divide(prt__long_product *p, double k) {
    double hi = p->hi / k;
    p->lo = (p->lo + fma(-hi, k, p->hi)) / k;
    p->hi = hi;
    if (p->hi < 1e-150) {                                      /* factorials of a few hundred leave the range of double */
        p->hi = ldexp(p->hi, 512);
        p->lo = ldexp(p->lo, 512);
        p->exponent -= 512;
    }
}

/* A^2 = (2l+1)/(4 pi) (l-m)!/(l+m)! / (t(l,0)^2 H), doubled for m > 0;  1/t(l,0) = 2 prod_k (2k-1)/(2k) */
PRTDEF double prt_ch_norm(int l, int m) {
    prt__long_product p = { 1, 0, 0 };
    int k;
    if (l < 0 || l > 65535 || m < -l || m > l) return 0;
    if (m < 0) m = -m;
    prt__multiply(&p, m ? 2.0 * (2.0 * l + 1) : 2.0 * l + 1);
    if (l > 0) prt__multiply(&p, 4);
    for (k = 1; k <= l; k++) {
        double odd = (2.0 * k - 1) * (2.0 * k - 1), even = 4.0 * k * k;
        prt__multiply(&p, odd);
        prt__divide(&p, even);
    }
    for (k = l - m + 1; k <= l + m; k++) prt__divide(&p, k);
    return ldexp(sqrt((p.hi + p.lo) / (4 * PRT__PI * prt__ch_length2(l, m))), p.exponent / 2);
}

PRTDEF prt_result prt_ch_eval(int bands, prt_vec3 dir, prt_real *c) {
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!c) return PRT_ERR_NULL;
    prt__eval(&prt__ch_basis, bands, dir, c);
    return PRT_OK;
}

PRTDEF prt_result prt_ch_eval_n(int bands, int count, const prt_vec3 *dirs, prt_real *c) {
    return prt__eval_n(&prt__ch_basis, bands, count, dirs, c);
}

PRTDEF prt_result prt_ch_eval_soa(int bands, int count, const prt_real *x, const prt_real *y, const prt_real *z,
                                  prt_real *out, size_t stride) {
    return prt__eval_soa(&prt__ch_basis, bands, count, x, y, z, out, stride);
}

PRTDEF prt_real prt_ch_at(int bands, const prt_real *f, prt_vec3 dir) {
    return prt__at(&prt__ch_basis, bands, f, dir);
}

/* The coefficients of one order m: sines and cosines of the bands l >= m, indexed by l. S acts on each alike. */
typedef struct prt__ch_column { double sine[PRT_MAX_BANDS], cosine[PRT_MAX_BANDS]; } prt__ch_column;

PRT__STATIC void prt__ch_load(int bands, int m, const prt_real *f, prt__ch_column *v) {
    int l;
    for (l = m; l < bands; l++) {
        v->sine[l] = f[PRT_SH_INDEX(l, -m)];
        v->cosine[l] = f[PRT_SH_INDEX(l, m)];
    }
}

PRT__STATIC void prt__ch_store(int bands, int m, const prt__ch_column *v, prt_real *f) {
    int l;
    for (l = m; l < bands; l++) {
        f[PRT_SH_INDEX(l, -m)] = (prt_real)v->sine[l];
        f[PRT_SH_INDEX(l, m)] = (prt_real)v->cosine[l];
    }
}

/* The four steps between coefficients, SH and moments, in place; each visits the rows in the order that allows it. */
typedef void prt__ch_step_of(int bands, int m, prt__ch_column *v);

PRT__STATIC void prt__ch_sh_from_coefficients(int bands, int m, prt__ch_column *v) {           /* v = S^T v */
    double row[PRT_MAX_BANDS + 1];
    int l, j, count;
    for (l = m; l < bands; l++) {
        double s = v->sine[l], c = v->cosine[l];
        count = prt__ch_row(l, m, row);
        v->sine[l] = row[0] * s;
        v->cosine[l] = row[0] * c;
        for (j = 1; j < count; j++) {
            v->sine[l - 2 * j] += row[j] * s;
            v->cosine[l - 2 * j] += row[j] * c;
        }
    }
}

PRT__STATIC void prt__ch_coefficients_from_sh(int bands, int m, prt__ch_column *v) {           /* v = S^-T v */
    double row[PRT_MAX_BANDS + 1];
    int l, j, count;
    for (l = bands - 1; l >= m; l--) {
        count = prt__ch_row(l, m, row);
        v->sine[l] /= row[0];
        v->cosine[l] /= row[0];
        for (j = 1; j < count; j++) {
            v->sine[l - 2 * j] -= row[j] * v->sine[l];
            v->cosine[l - 2 * j] -= row[j] * v->cosine[l];
        }
    }
}

PRT__STATIC void prt__ch_moments_from_sh(int bands, int m, prt__ch_column *v) {                /* v = S v */
    double row[PRT_MAX_BANDS + 1];
    int l, j, count;
    for (l = bands - 1; l >= m; l--) {
        count = prt__ch_row(l, m, row);
        v->sine[l] *= row[0];
        v->cosine[l] *= row[0];
        for (j = 1; j < count; j++) {
            v->sine[l] += row[j] * v->sine[l - 2 * j];
            v->cosine[l] += row[j] * v->cosine[l - 2 * j];
        }
    }
}

PRT__STATIC void prt__ch_sh_from_moments(int bands, int m, prt__ch_column *v) {                /* v = S^-1 v */
    double row[PRT_MAX_BANDS + 1];
    int l, j, count;
    for (l = m; l < bands; l++) {
        count = prt__ch_row(l, m, row);
        for (j = 1; j < count; j++) {
            v->sine[l] -= row[j] * v->sine[l - 2 * j];
            v->cosine[l] -= row[j] * v->cosine[l - 2 * j];
        }
        v->sine[l] /= row[0];
        v->cosine[l] /= row[0];
    }
}

PRT__STATIC prt_result prt__ch_convert(int bands, prt__ch_step_of *first, prt__ch_step_of *second, const prt_real *f,
                                       prt_real *out) {
    prt__ch_column v;
    int m;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !out) return PRT_ERR_NULL;
    for (m = 0; m < bands; m++) {
        prt__ch_load(bands, m, f, &v);
        first(bands, m, &v);
        if (second) second(bands, m, &v);
        prt__ch_store(bands, m, &v, out);
    }
    return PRT_OK;
}

PRTDEF prt_result prt_ch_from_sh(int bands, const prt_real *sh, prt_real *ch) {
    return prt__ch_convert(bands, prt__ch_coefficients_from_sh, NULL, sh, ch);
}
PRTDEF prt_result prt_sh_from_ch(int bands, const prt_real *ch, prt_real *sh) {
    return prt__ch_convert(bands, prt__ch_sh_from_coefficients, NULL, ch, sh);
}
PRTDEF prt_result prt_ch_from_moments(int bands, const prt_real *moments, prt_real *ch) {
    return prt__ch_convert(bands, prt__ch_sh_from_moments, prt__ch_coefficients_from_sh, moments, ch);
}
PRTDEF prt_result prt_ch_to_moments(int bands, const prt_real *ch, prt_real *moments) {
    return prt__ch_convert(bands, prt__ch_sh_from_coefficients, prt__ch_moments_from_sh, ch, moments);
}

PRTDEF prt_real prt_ch_dot(int bands, const prt_real *f, const prt_real *g) {
    prt__ch_column a, b;
    double sum = 0;
    int l, m;
    if (!prt__bands_ok(bands) || !f || !g) return 0;
    for (m = 0; m < bands; m++) {
        prt__ch_load(bands, m, f, &a);
        prt__ch_load(bands, m, g, &b);
        prt__ch_sh_from_coefficients(bands, m, &a);
        prt__ch_sh_from_coefficients(bands, m, &b);
        for (l = m; l < bands; l++) sum += a.cosine[l] * b.cosine[l] + (m ? a.sine[l] * b.sine[l] : 0);
    }
    return (prt_real)sum;
}

PRTDEF prt_result prt_ch_rotate(int bands, const prt_real rotation[9], const prt_real *f, prt_real *out) {
    prt_real sh[PRT_SH_COUNT(PRT_MAX_BANDS)], turned[PRT_SH_COUNT(PRT_MAX_BANDS)];
    prt_result r;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!rotation || !f || !out) return PRT_ERR_NULL;
    sh[0] = 0;                                                 /* gcc does not see that the conversion writes all of it */
    prt_sh_from_ch(bands, f, sh);
    r = prt_sh_rotate(bands, rotation, sh, turned);
    return r == PRT_OK ? prt_ch_from_sh(bands, turned, out) : r;
}

PRTDEF prt_result prt_ch_product(int bands, const prt_real *f, const prt_real *g, prt_real *out) {
    prt_real a[PRT_SH_COUNT(PRT_MAX_BANDS)], b[PRT_SH_COUNT(PRT_MAX_BANDS)], product[PRT_SH_COUNT(PRT_MAX_BANDS)];
    prt_result r;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (!f || !g || !out) return PRT_ERR_NULL;
    a[0] = b[0] = 0;                                           /* as in prt_ch_rotate */
    prt_sh_from_ch(bands, f, a);
    prt_sh_from_ch(bands, g, b);
    r = prt_sh_product(bands, a, b, product);
    return r == PRT_OK ? prt_ch_from_sh(bands, product, out) : r;
}
#endif /* PRT_NO_CH */

/* ------------------------------------------------------------------------------------------------- >>shade ---- */

/* The three dot products of one transfer vector with the planes of a light, in one pass over the vector; each is bit-equal
   to prt__dot. */
PRT__INLINE prt_rgb prt__shade(int n, const prt_real *transfer, const prt_real *light) {
    const prt_real *green = light + n, *blue = light + 2 * n;
    prt__oct r, g, b;
    prt_rgb out;
    int i;
    memset(&r, 0, sizeof r);
    memset(&g, 0, sizeof g);
    memset(&b, 0, sizeof b);
    for (i = 0; i + 8 <= n; i += 8) {
        prt__oct_madd(&r, transfer + i, light + i);
        prt__oct_madd(&g, transfer + i, green + i);
        prt__oct_madd(&b, transfer + i, blue + i);
    }
    prt__oct_sum3(&r, &g, &b, &out);
    out.r = prt__dot_tail(out.r, i, n, transfer, light);
    out.g = prt__dot_tail(out.g, i, n, transfer, green);
    out.b = prt__dot_tail(out.b, i, n, transfer, blue);
    return out;
}

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
    for (k = 0; k < count; k++) out[k] = prt__shade(n, transfer + (size_t)k * (size_t)n, light);
    return PRT_OK;
}

/* --------------------------------------------------------------------------------------------------- >>fiv ---- */

PRTDEF void prt_fiv_add(prt_fiv *fiv, prt_vec3 dir, prt_rgb radiance_times_solid_angle) {
    prt_rgb c = radiance_times_solid_angle;
    if (!fiv) return;
    fiv->r.x += c.r * dir.x; fiv->r.y += c.r * dir.y; fiv->r.z += c.r * dir.z;
    fiv->g.x += c.g * dir.x; fiv->g.y += c.g * dir.y; fiv->g.z += c.g * dir.z;
    fiv->b.x += c.b * dir.x; fiv->b.y += c.b * dir.y; fiv->b.z += c.b * dir.z;
}

PRTDEF prt_rgb prt_fiv_irradiance(const prt_fiv *fiv, prt_vec3 normal) {
    prt_rgb out = { 0, 0, 0 };
    if (!fiv) return out;
    out.r = prt__dot3(fiv->r, normal);
    out.g = prt__dot3(fiv->g, normal);
    out.b = prt__dot3(fiv->b, normal);
    return out;
}

/* Numbers of either kind within low ... high; NaN becomes low. */
PRT__INLINE prt_real prt__clamp(prt_real v, prt_real low, prt_real high) { return v > low ? v < high ? v : high : low; }
PRT__INLINE prt__vec prt__vec_clamp(prt__vec v, prt__vec low, prt__vec high) {
    return PRT__SELECT(v > low, PRT__SELECT(v < high, v, high), low);
}
PRT__INLINE prt__vec prt__vec_least(prt__vec a, prt__vec b) { return PRT__SELECT(a < b, a, b); }
PRT__INLINE prt__vec prt__vec_most(prt__vec a, prt__vec b) { return PRT__SELECT(a > b, a, b); }
PRT__INLINE prt__vec prt__vec_abs(prt__vec v) { return PRT__SELECT(v < 0, -v, v); }

/* The angle of (x,y) in 0 ... pi, for y >= 0; pi/2 for (0,0). The smaller of |x|, y over the larger, above tan(pi/8)
   turned by pi/4, through a polynomial in its square: Chebyshev interpolation of atan(sqrt u)/sqrt u to 2e-8, or
   3e-17. */
PRT__STATIC prt__vec prt__vec_angle(prt__vec y, prt__vec x) {
#ifdef PRT_DOUBLE
    static const prt_real c[11] = { 0.999999999999999965, -0.333333333333284386, 0.199999999988551101,
        -0.142857141809764668, 0.111111061804559452, -0.0909077307480841379, 0.0768995349630685776,
        -0.0664023393042940859, 0.0568834922680901048, -0.0434805221571646248, 0.0211353731576932452 };
    enum { TERMS = 11 };
#else
    static const prt_real c[5] = { 0.999999981264611121f, -0.333327857719248436f, 0.199740824155076671f,
        -0.138484902122692077f, 0.0797629180679455791f };
    enum { TERMS = 5 };
#endif
    prt__vec ax = prt__vec_abs(x), low = prt__vec_least(ax, y), high = prt__vec_most(ax, y), z, u, p;
    prt__chosen turned = low > high * PRT__R(0.41421356237309504880);
    int k;
    high = prt__vec_most(high, prt__vec_set(PRT__REAL_MIN));
    z = PRT__SELECT(turned, low - high, low) / PRT__SELECT(turned, low + high, high);
    u = z * z;
    p = prt__vec_set(c[TERMS - 1]);
    for (k = TERMS - 2; k >= 0; k--) p = p * u + c[k];
    z = z * p;
    z = PRT__SELECT(turned, z + PRT__R(PRT__PI / 4), z);
    z = PRT__SELECT(ax > y, z, PRT__R(PRT__PI / 2) - z);
    return PRT__SELECT(x < 0, PRT__R(PRT__PI) - z, z);
}

/* Directions and distances, a receiver a lane. */
typedef struct prt__fiv_polar { prt__vec x, y, z, distance; } prt__fiv_polar;

/* Components are first brought within what a square root of a sum can hold; the zero vector is given
   the direction +y. */
PRT__STATIC prt__fiv_polar prt__fiv_polar_of(prt__vec x, prt__vec y, prt__vec z) {
    const prt__vec most = prt__vec_set(PRT__REAL_MAX / 4), zero = prt__vec_set(0);
    prt__fiv_polar p;
    prt__vec big, length;
    x = prt__vec_clamp(x, -most, most);
    y = prt__vec_clamp(y, -most, most);
    z = prt__vec_clamp(z, -most, most);
    big = prt__vec_most(prt__vec_most(prt__vec_abs(x), prt__vec_abs(y)), prt__vec_abs(z));
    y = PRT__SELECT(big > 0, y, prt__vec_set(1));
    big = PRT__SELECT(big > 0, big, zero);
    length = PRT__SELECT(big > 0, big, prt__vec_set(1));
    x = x / length; y = y / length; z = z / length;
    length = prt__vec_root(x * x + y * y + z * z);
    p.x = x / length; p.y = y / length; p.z = z / length;
    p.distance = big * length;
    return p;
}
PRT__INLINE prt__vec prt__fiv_dot(const prt__fiv_polar *p, prt__vec x, prt__vec y, prt__vec z) {
    return p->x * x + p->y * y + p->z * z;
}

/* A grid of places, of whatever is kept at them. */
typedef struct prt__fiv_grid {
    int theta_count, phi_count, rho_count;
    const prt_real *rho;
    const unsigned char *inside;
} prt__fiv_grid;

PRT__STATIC int prt__fiv_table_ok(const prt_fiv_table *t) {
    return t->theta_count >= 1 && t->phi_count >= 1 && t->rho_count >= 1;
}

PRT__INLINE prt__fiv_grid prt__fiv_grid_of(const prt_fiv_table *t) {
    prt__fiv_grid g;
    g.theta_count = t->theta_count; g.phi_count = t->phi_count; g.rho_count = t->rho_count;
    g.rho = t->rho;
    g.inside = t->inside;
    return g;
}

/* Where lanes stand in a grid: the sample before them in theta, phi and rho, how many samples on the next one in each
   of these stands, and the weights of the eight, bit 0 of whose number is phi, bit 1 theta, bit 2 rho; the fall-off
   beyond the last distance is in the weights. */
typedef struct prt__fiv_cells {
    size_t at[PRT__LANES];
    ptrdiff_t phi[PRT__LANES], theta, rho[PRT__LANES];
    prt_real weight[8][PRT__LANES];
} prt__fiv_cells;

/* The interval of rho that holds a distance, by bisection without a branch to guess. It ends whatever the order of
   rho is. */
PRT__INLINE int prt__fiv_interval(int count, const prt_real *rho, prt_real distance) {
    int low = 0, left = count - 1;                             /* intervals from low on */
    while (left > 1) {
        int half = left / 2;
        low += rho[low + half] <= distance ? half : 0;
        left -= half;
    }
    return low;
}

PRT__INLINE void prt__fiv_weights(const prt_real *p, const prt_real *t, prt__vec r, prt__vec fall,
                                  prt_real (*weight)[PRT__LANES]) {
    prt__vec phi = prt__vec_load(p), theta = prt__vec_load(t), w[4];
    int k;
    w[3] = r * fall; w[1] = fall - w[3];
    w[2] = w[3] - w[3] * theta; w[3] = w[3] * theta;
    w[0] = w[1] - w[1] * theta; w[1] = w[1] * theta;
    for (k = 0; k < 4; k++) {
        prt__vec_store(weight[2 * k + 1], w[k] * phi);
        prt__vec_store(weight[2 * k], w[k] - w[k] * phi);
    }
}

PRT__STATIC void prt__fiv_cells_of(const prt__fiv_grid *g, const prt__fiv_polar *p, int lanes, prt__fiv_cells *c) {
    prt_real theta[PRT__LANES], phi[PRT__LANES], distance[PRT__LANES];
    prt_real low[PRT__LANES] = { 0 }, high[PRT__LANES] = { 0 };
    prt__vec angle = prt__vec_angle(prt__vec_abs(p->y), p->x), zero = prt__vec_set(0), fall = prt__vec_set(1), far, r;
    prt_real rows = (prt_real)(g->theta_count - 1), columns = (prt_real)g->phi_count, last = g->rho[g->rho_count - 1];
    size_t ring = (size_t)g->phi_count, shell = (size_t)g->theta_count * ring;
    int lane;
    angle = PRT__SELECT(p->y < zero, PRT__R(2 * PRT__PI) - angle, angle);
    prt__vec_store(phi, prt__vec_clamp(angle * (columns / PRT__R(2 * PRT__PI)), zero, prt__vec_set(columns)));
    angle = prt__vec_angle(prt__vec_root(p->x * p->x + p->y * p->y), p->z);
    prt__vec_store(theta, prt__vec_clamp(angle * (rows / PRT__R(PRT__PI)), zero, prt__vec_set(rows)));
    prt__vec_store(distance, p->distance);
    c->theta = g->theta_count > 1 ? (ptrdiff_t)ring : 0;
    for (lane = 0; lane < lanes; lane++) {
        int i = (int)theta[lane], j = (int)phi[lane], k = prt__fiv_interval(g->rho_count, g->rho, distance[lane]);
        int more = k + 1 < g->rho_count;
        i = i < g->theta_count - 1 ? i : g->theta_count - 2;
        i = i > 0 ? i : 0;                                     /* whatever the compiler thinks of NaN */
        j = j < g->phi_count ? j : g->phi_count - 1;
        j = j > 0 ? j : 0;
        theta[lane] -= (prt_real)i;
        phi[lane] -= (prt_real)j;
        low[lane] = g->rho[k];
        high[lane] = g->rho[k + more];
        c->at[lane] = (size_t)k * shell + (size_t)i * ring + (size_t)j;
        c->phi[lane] = j + 1 < g->phi_count ? 1 : -(ptrdiff_t)j;
        c->rho[lane] = more ? (ptrdiff_t)shell : 0;
    }
    far = prt__vec_set(last) / PRT__SELECT(p->distance > zero, p->distance, prt__vec_set(1));
    if (last > 0) fall = PRT__SELECT(far < fall, far * far, fall);
    r = (p->distance - prt__vec_load(low)) / (prt__vec_load(high) - prt__vec_load(low));
    prt__fiv_weights(phi, theta, prt__vec_clamp(r, zero, prt__vec_set(1)), fall, c->weight);
}

/* How far from the first the corner k of a lane stands. */
PRT__INLINE ptrdiff_t prt__fiv_corner(const prt__fiv_cells *c, int lane, int k) {
    return (k & 1 ? c->phi[lane] : 0) + (k & 2 ? c->theta : 0) + (k & 4 ? c->rho[lane] : 0);
}

PRT__STATIC int prt__fiv_any_inside(const prt__fiv_grid *g, const prt__fiv_cells *c, int lane) {
    int any = 0, k;
    for (k = 0; k < 8; k++) any |= g->inside[c->at[lane] + (size_t)prt__fiv_corner(c, lane, k)];
    return any;
}

/* The corners of a lane, and their weights without those that lie inside, unless all with a weight do, and those that
   `good` (NULL: none) denies; the others are raised. */
PRT__STATIC void prt__fiv_corners(const prt__fiv_grid *g, const prt__fiv_cells *c, int lane, const unsigned char *good,
                                  size_t at[8], prt_real weight[8]) {
    prt_real all = 0, kept = 0;
    unsigned char in[8];
    int outside = 0, k;
    for (k = 0; k < 8; k++) {
        at[k] = c->at[lane] + (size_t)prt__fiv_corner(c, lane, k);
        in[k] = g->inside ? g->inside[at[k]] : 0;
        outside |= c->weight[k][lane] > 0 && !in[k];
    }
    for (k = 0; k < 8; k++) {
        all += c->weight[k][lane];
        weight[k] = (good && !good[k]) || (outside && in[k]) ? 0 : c->weight[k][lane];
        kept += weight[k];
    }
    for (k = 0; k < 8; k++) weight[k] = kept > 0 ? weight[k] / kept * all : 0;
}

/* out[0...8] = sum of weight times sample. */
PRT__INLINE void prt__fiv_sum(const prt_fiv *samples, const prt__fiv_cells *c, int lane, prt_real *out) {
    const prt_fiv *first = samples + c->at[lane];
    int k;
#if PRT__SIMD
    prt__quad low, high, a = { 0, 0, 0, 0 }, b = { 0, 0, 0, 0 };
    prt_real last = 0;
    for (k = 0; k < 8; k++) {
        const prt_fiv *sample = first + prt__fiv_corner(c, lane, k);
        prt_real w = c->weight[k][lane];
        memcpy(&low, sample, sizeof low);
        memcpy(&high, &sample->g.y, sizeof high);
        a += w * low;
        b += w * high;
        last += w * sample->b.z;
    }
    memcpy(out, &a, sizeof a);
    memcpy(out + 4, &b, sizeof b);
    out[8] = last;
#else
    prt_real sample[9];
    int i;
    for (i = 0; i < 9; i++) out[i] = 0;
    for (k = 0; k < 8; k++) {
        memcpy(sample, first + prt__fiv_corner(c, lane, k), sizeof sample);
        for (i = 0; i < 9; i++) out[i] += c->weight[k][lane] * sample[i];
    }
#endif
}

PRT__STATIC int prt__fiv_sample_finite(const prt_fiv *s) {
    return prt__finite3(s->r) && prt__finite3(s->g) && prt__finite3(s->b);
}

/* The sum where a sample is inside, or something is not finite. Taken at a quarter of its size, so that finite samples
   cannot overflow on the way. */
PRT__STATIC void prt__fiv_sum_carefully(const prt__fiv_grid *g, const prt_fiv *samples, const prt__fiv_cells *c,
                                        int lane, prt_real *out) {
    unsigned char good[8];
    prt_real sample[9], weight[8];
    size_t at[8];
    int k, i;
    for (k = 0; k < 8; k++)
        good[k] = (unsigned char)prt__fiv_sample_finite(samples + c->at[lane] + prt__fiv_corner(c, lane, k));
    prt__fiv_corners(g, c, lane, good, at, weight);
    for (i = 0; i < 9; i++) out[i] = 0;
    for (k = 0; k < 8; k++) {
        if (!good[k]) continue;
        memcpy(sample, samples + at[k], sizeof sample);
        for (i = 0; i < 9; i++) out[i] += weight[k] * PRT__R(0.25) * sample[i];
    }
    for (i = 0; i < 9; i++) out[i] = 4 * prt__clamp(out[i], -PRT__REAL_MAX / 4, PRT__REAL_MAX / 4);
}

PRT__STATIC void prt__fiv_blend(const prt__fiv_grid *g, const prt_fiv *samples, const prt__fiv_cells *c, int lane,
                                prt_real *out) {
    if (!g->inside || !prt__fiv_any_inside(g, c, lane)) {
        prt__fiv_sum(samples, c, lane, out);
        if (prt__finite(out[0] + out[1] + out[2] + out[3] + out[4] + out[5] + out[6] + out[7] + out[8])) return;
    }
    prt__fiv_sum_carefully(g, samples, c, lane, out);
}

/* Where one place stands, in lane 0. */
PRT__STATIC void prt__fiv_cell_of(const prt__fiv_grid *g, prt_vec3 to, prt__fiv_cells *c) {
    prt__fiv_polar p = prt__fiv_polar_of(prt__vec_set(to.x), prt__vec_set(to.y), prt__vec_set(to.z));
    prt__fiv_cells_of(g, &p, 1, c);
}

PRTDEF prt_result prt_fiv_lookup(const prt_fiv_table *table, prt_vec3 from_receiver_to_centre, prt_fiv *out) {
    prt__fiv_cells cells;
    prt__fiv_grid grid;
    prt_real values[9];
    if (!table) return PRT_ERR_NULL;
    if (!prt__fiv_table_ok(table)) return PRT_ERR_COUNT;
    if (!table->rho || !table->samples || !out) return PRT_ERR_NULL;
    grid = prt__fiv_grid_of(table);
    prt__fiv_cell_of(&grid, from_receiver_to_centre, &cells);
    prt__fiv_blend(&grid, table->samples, &cells, 0, values);
    memcpy(out, values, sizeof values);
    return PRT_OK;
}

/* Receivers, one a lane, and what stands around them: vectors that were looked up already (one receiver), or
   occluders. */
typedef struct prt__fiv_scene {
    const prt_fiv_hidden *hidden;
    const prt_fiv_occluder *occluders;
    int count, lanes;
    unsigned flags;
    prt__vec px, py, pz, nx, ny, nz, total[3];
} prt__fiv_scene;

/* An occluder from the receivers: direction, its unit bounding disc, what it takes of each channel; lit 0: nothing. */
typedef struct prt__fiv_seen { prt__vec x, y, z, disc, disc2, taken[3]; int lit; } prt__fiv_seen;

/* The vectors of occluder k in the lanes that `lit` names, nine numbers each. A single lane is spread over all: going
   through memory would wait for it. */
PRT__STATIC void prt__fiv_vectors(const prt__fiv_scene *s, int k, const prt__fiv_polar *p, const prt_real *lit,
                                  prt__vec vectors[9]) {
    prt_real rows[9][PRT__LANES], v[9] = { 0 };
    prt__fiv_cells cells;
    prt__fiv_grid grid;
    int lane, i;
    if (s->lanes > 1) memset(rows, 0, sizeof rows);
    if (!s->hidden) {
        grid = prt__fiv_grid_of(s->occluders[k].table);
        prt__fiv_cells_of(&grid, p, s->lanes, &cells);
    }
    for (lane = 0; lane < s->lanes; lane++) {
        if (!(lit[lane] > 0)) continue;
        if (s->hidden) memcpy(v, &s->hidden[k].fiv, sizeof v);
        else prt__fiv_blend(&grid, s->occluders[k].table->samples, &cells, lane, v);
        for (i = 0; i < 9 && s->lanes > 1; i++) rows[i][lane] = v[i];
    }
    for (i = 0; i < 9; i++) vectors[i] = s->lanes > 1 ? prt__vec_load(rows[i]) : prt__vec_set(v[i]);
}

/* g(u) - u: what the horizon leaves of a cap of uniform radiance, over what it would give facing the receiver uncut,
   beyond what N.FIV says. */
PRT__STATIC prt__vec prt__fiv_cut(prt__vec u) {
    prt__vec root = prt__vec_root((1 - u) * (1 + u));
    return (u * prt__vec_angle(root, -u) + root * (2 + u * u) * PRT__R(1.0 / 3)) * PRT__R(1 / PRT__PI) - u;
}

PRT__STATIC void prt__fiv_see(const prt__fiv_scene *s, int k, prt__fiv_seen *seen) {
    const prt__vec zero = prt__vec_set(0), one = prt__vec_set(1);
    prt_vec3 to = s->hidden ? s->hidden[k].to_centre : s->occluders[k].position;
    prt_real size = s->hidden ? s->hidden[k].radius : s->occluders[k].table->radius, lit[PRT__LANES];
    prt__vec radius = prt__vec_set(size);
    prt__fiv_polar p = prt__fiv_polar_of(to.x - s->px, to.y - s->py, to.z - s->pz);
    prt__vec up = prt__fiv_dot(&p, s->nx, s->ny, s->nz), sine, u, cut = zero, shine, vectors[9];
    int c, lane, partial = 0;
    seen->lit = 0;
    if (!(size > 0)) return;
    sine = PRT__SELECT(radius < p.distance, radius / PRT__SELECT(p.distance > 0, p.distance, one), one);
    u = prt__vec_clamp(up / sine, -one, one);
    shine = PRT__SELECT(u > -one, one, zero);
    prt__vec_store(lit, shine);
    for (lane = 0; lane < s->lanes; lane++) seen->lit |= lit[lane] > 0;
    if (!seen->lit) return;
    prt__fiv_vectors(s, k, &p, lit, vectors);
    prt__vec_store(lit, u);
    for (lane = 0; lane < s->lanes; lane++) partial |= lit[lane] < 1;
    if (s->flags & PRT_FIV_PAPER_PARTIAL)
        cut = prt__vec_clamp(up * p.distance / radius, -one, one) * PRT__R(0.5) + PRT__R(0.5);
    else if (partial) cut = prt__fiv_cut(u) * sine;
    for (c = 0; c < 3; c++) {
        prt__vec x = vectors[3 * c], y = vectors[3 * c + 1], z = vectors[3 * c + 2];
        prt__vec along = x * s->nx + y * s->ny + z * s->nz;
        if (s->flags & PRT_FIV_PAPER_PARTIAL) along = along * cut;
        else if (partial) along = along + PRT__SELECT(u < one, prt__vec_root(x * x + y * y + z * z) * cut, zero);
        seen->taken[c] = PRT__SELECT(shine > zero, prt__vec_clamp(along, zero, s->total[c]), zero);
    }
    seen->x = p.x; seen->y = p.y; seen->z = p.z;
    seen->disc2 = 2 * sine * sine / (1 + prt__vec_root((1 - sine) * (1 + sine)));
    seen->disc = prt__vec_root(seen->disc2);
}

PRT__INLINE int prt__any_over(prt__vec a, prt__vec b) {        /* a > b in any lane */
    prt_real over[PRT__LANES], sum = 0;
    int k;
    prt__vec_store(over, PRT__SELECT(a > b, prt__vec_set(1), prt__vec_set(0)));
    for (k = 0; k < PRT__LANES; k++) sum += over[k];
    return sum > 0;
}

/* Adds what two occluders take together: the part of two unit bounding discs' areas that lies in both, over the sum of
   the areas, of the sum of what they take. By Heron: s is four times the triangle of the centres and a crossing; it
   turns to 0, and the angles to 0 and pi, where one disc contains the other. */
PRT__STATIC void prt__fiv_pair(const prt__fiv_seen *a, const prt__fiv_seen *b, prt__vec *twice) {
    prt__vec x = a->x - b->x, y = a->y - b->y, z = a->z - b->z, d2 = x * x + y * y + z * z, d, s, share;
    prt__vec reach = a->disc + b->disc, apart = a->disc - b->disc, zero = prt__vec_set(0);
    int c;
    if (!prt__any_over(reach * reach, d2)) return;
    d = prt__vec_root(d2);
    s = prt__vec_root(prt__vec_most((reach - d) * (reach + d) * (d + apart) * (d - apart), zero));
    share = a->disc2 * prt__vec_angle(s, d2 + a->disc2 - b->disc2)
            + b->disc2 * prt__vec_angle(s, d2 + b->disc2 - a->disc2);
    share = (share - s * PRT__R(0.5)) / ((a->disc2 + b->disc2) * PRT__R(PRT__PI));
    share = PRT__SELECT(reach > d, share, zero);
    for (c = 0; c < 3; c++) {
        prt__vec both = share * (a->taken[c] + b->taken[c]);
        twice[c] += prt__vec_least(both, prt__vec_least(a->taken[c], b->taken[c]));
    }
}

/* Occluders that are kept to meet all that follow; more are taken block by block, and looked up once more for each. */
enum { PRT__FIV_BLOCK = 32 };

/* left[c] = total - what all occluders take. */
PRT__STATIC void prt__fiv_shade(const prt__fiv_scene *s, prt__vec left[3]) {
    prt__fiv_seen block[PRT__FIV_BLOCK], one;
    prt__vec zero = prt__vec_set(0), sum[3], most[3], twice[3];
    int pairs = !(s->flags & PRT_FIV_NO_OVERLAP), first, k, j, c;
    for (c = 0; c < 3; c++) sum[c] = most[c] = twice[c] = zero;
    for (first = 0; first < s->count; first += PRT__FIV_BLOCK)
        for (k = first; k < s->count && (pairs || k < first + PRT__FIV_BLOCK); k++) {
            int own = k - first < PRT__FIV_BLOCK;
            prt__fiv_see(s, k, &one);
            for (j = 0; one.lit && pairs && j < (own ? k - first : PRT__FIV_BLOCK); j++)
                if (block[j].lit) prt__fiv_pair(&block[j], &one, twice);
            if (!own) continue;
            block[k - first] = one;
            for (c = 0; one.lit && c < 3; c++) {
                sum[c] += one.taken[c];
                most[c] = prt__vec_most(most[c], one.taken[c]);
            }
        }
    for (c = 0; c < 3; c++)
        left[c] = prt__vec_clamp(s->total[c] - prt__vec_clamp(sum[c] - twice[c], most[c], sum[c]), zero, s->total[c]);
}

PRT__STATIC prt_result prt__fiv_occluders_check(int count, const prt_fiv_occluder *occluders) {
    int k;
    if (count < 0) return PRT_ERR_COUNT;
    for (k = 0; k < count && occluders; k++)
        if (occluders[k].table && !prt__fiv_table_ok(occluders[k].table)) return PRT_ERR_COUNT;
    if (count > 0 && !occluders) return PRT_ERR_NULL;
    for (k = 0; k < count; k++)
        if (!occluders[k].table || !occluders[k].table->rho || !occluders[k].table->samples) return PRT_ERR_NULL;
    return PRT_OK;
}

/* The receivers of the lanes; lanes without one see the last of them. */
PRT__STATIC void prt__fiv_receivers(prt__fiv_scene *s, int lanes, const prt_rgb *totals, const prt_vec3 *positions,
                                    const prt_vec3 *normals) {
    prt_real v[9][PRT__LANES];
    prt__vec zero = prt__vec_set(0), all[9];
    int k, i;
    for (k = 0; k < (lanes > 1 ? PRT__LANES : 1); k++) {
        int at = k < lanes ? k : lanes - 1;
        v[0][k] = positions[at].x; v[1][k] = positions[at].y; v[2][k] = positions[at].z;
        v[3][k] = normals[at].x; v[4][k] = normals[at].y; v[5][k] = normals[at].z;
        v[6][k] = totals[at].r; v[7][k] = totals[at].g; v[8][k] = totals[at].b;
    }
    for (i = 0; i < 9; i++) all[i] = lanes > 1 ? prt__vec_load(v[i]) : prt__vec_set(v[i][0]);
    s->lanes = lanes;
    s->px = all[0]; s->py = all[1]; s->pz = all[2];
    s->nx = all[3]; s->ny = all[4]; s->nz = all[5];
    for (k = 0; k < 3; k++) s->total[k] = prt__vec_most(all[6 + k], zero);
}

PRT__STATIC void prt__fiv_write(const prt__vec left[3], int lanes, prt_rgb *irradiance) {
    prt_real v[3][PRT__LANES];
    int k;
    for (k = 0; k < 3; k++) prt__vec_store(v[k], left[k]);
    for (k = 0; k < lanes; k++) { irradiance[k].r = v[0][k]; irradiance[k].g = v[1][k]; irradiance[k].b = v[2][k]; }
}

PRTDEF prt_result prt_fiv_shade_n(int receiver_count, const prt_rgb *totals, const prt_vec3 *positions,
                                  const prt_vec3 *normals, int count, const prt_fiv_occluder *occluders, unsigned flags,
                                  prt_rgb *irradiance) {
    prt_result r;
    prt__fiv_scene scene;
    prt__vec left[3];
    int k;
    if (receiver_count < 0) return PRT_ERR_COUNT;
    r = prt__fiv_occluders_check(count, occluders);
    if (r != PRT_OK) return r;
    if (receiver_count > 0 && (!totals || !positions || !normals || !irradiance)) return PRT_ERR_NULL;
    scene.hidden = 0;
    scene.occluders = occluders;
    scene.count = count;
    scene.flags = flags;
    for (k = 0; k < receiver_count; k += PRT__LANES) {
        int lanes = receiver_count - k < PRT__LANES ? receiver_count - k : PRT__LANES;
        prt__fiv_receivers(&scene, lanes, totals + k, positions + k, normals + k);
        prt__fiv_shade(&scene, left);
        prt__fiv_write(left, lanes, irradiance + k);
    }
    return PRT_OK;
}

PRTDEF prt_result prt_fiv_shade(prt_rgb total, prt_vec3 position, prt_vec3 normal, int count,
                                const prt_fiv_occluder *occluders, unsigned flags, prt_rgb *irradiance) {
    return prt_fiv_shade_n(1, &total, &position, &normal, count, occluders, flags, irradiance);
}

PRTDEF prt_result prt_fiv_shade_vectors(prt_rgb total, prt_vec3 normal, int count, const prt_fiv_hidden *hidden,
                                        unsigned flags, prt_rgb *irradiance) {
    const prt_vec3 origin = { 0, 0, 0 };
    prt__fiv_scene scene;
    prt__vec left[3];
    if (count < 0) return PRT_ERR_COUNT;
    if ((count > 0 && !hidden) || !irradiance) return PRT_ERR_NULL;
    scene.hidden = hidden;
    scene.occluders = 0;
    scene.count = count;
    scene.flags = flags;
    prt__fiv_receivers(&scene, 1, &total, &origin, &normal);
    prt__fiv_shade(&scene, left);
    prt__fiv_write(left, 1, irradiance);
    return PRT_OK;
}

PRTDEF prt_result prt_fiv_self(const prt_fiv *environment, const prt_fiv_table *self, prt_vec3 local_position,
                               prt_vec3 normal, prt_rgb *irradiance) {
    prt_fiv hidden;
    prt_rgb all, taken;
    prt_result r;
    if (!self) return PRT_ERR_NULL;
    if (!prt__fiv_table_ok(self)) return PRT_ERR_COUNT;
    if (!environment || !irradiance) return PRT_ERR_NULL;
    r = prt_fiv_lookup(self, prt__vec3(-local_position.x, -local_position.y, -local_position.z), &hidden);
    if (r != PRT_OK) return r;
    all = prt_fiv_irradiance(environment, normal);
    taken = prt_fiv_irradiance(&hidden, normal);
    irradiance->r = prt__clamp(all.r - taken.r, 0, PRT__REAL_MAX);
    irradiance->g = prt__clamp(all.g - taken.g, 0, PRT__REAL_MAX);
    irradiance->b = prt__clamp(all.b - taken.b, 0, PRT__REAL_MAX);
    return PRT_OK;
}

/* Whether samples first ... first+count-1 exist in a grid. */
PRT__STATIC int prt__fiv_range_ok(int theta_count, int phi_count, int rho_count, int first, int count) {
    size_t total;
    if (theta_count < 1 || phi_count < 1 || rho_count < 1 || first < 0 || count < 0) return 0;
    total = (size_t)theta_count * (size_t)phi_count;
    if ((size_t)rho_count > SIZE_MAX / total) return 0;
    return (size_t)first <= total * (size_t)rho_count && (size_t)count <= total * (size_t)rho_count - (size_t)first;
}

PRT__STATIC prt_result prt__fiv_transfer_check(const prt_fiv_transfer *t) {
    if (!t) return PRT_ERR_NULL;
    if (!prt__bands_ok(t->bands) || t->bands == PRT_MAX_BANDS) return PRT_ERR_BANDS;
    return t->theta_count >= 1 && t->phi_count >= 1 && t->rho_count >= 1 ? PRT_OK : PRT_ERR_COUNT;
}

/* w_a times a function of `bands` bands, in one band more: out[a][(bands+1)^2]. */
PRT__STATIC void prt__fiv_raise(int bands, const prt_real *f, prt_real *out) {
    static const int place[3] = { PRT_SH_INDEX(1, 1), PRT_SH_INDEX(1, -1), PRT_SH_INDEX(1, 0) };
    prt_real padded[PRT_SH_COUNT(PRT_MAX_BANDS)], axis[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int more = PRT_SH_COUNT(bands + 1), a;
    memset(padded, 0, (size_t)more * sizeof *padded);
    memset(axis, 0, (size_t)more * sizeof *axis);
    memcpy(padded, f, (size_t)PRT_SH_COUNT(bands) * sizeof *padded);
    for (a = 0; a < 3; a++) {
        axis[place[a]] = PRT__R(2.04665341589297697696);       /* sqrt(4 pi/3) */
        prt_sh_product(bands + 1, padded, axis, out + (size_t)a * (size_t)more);
        axis[place[a]] = 0;
    }
}

PRTDEF prt_result prt_fiv_transfer_light(int bands, const prt_real rotation[9], const prt_real *light,
                                         prt_real *vectors) {
    prt_real back[9], turned[PRT_SH_COUNT(PRT_MAX_BANDS)];
    size_t n, more;
    int c, k, i;
    if (!prt__bands_ok(bands) || bands == PRT_MAX_BANDS) return PRT_ERR_BANDS;
    if (!light || !vectors) return PRT_ERR_NULL;
    n = (size_t)PRT_SH_COUNT(bands);
    more = (size_t)PRT_SH_COUNT(bands + 1);
    for (k = 0; rotation && k < 9; k++) back[k] = rotation[k % 3 * 3 + k / 3];
    for (c = 0; c < 3; c++) {
        prt_real *x = vectors + (size_t)(3 * c) * more, *y = x + more, *z = y + more;
        if (rotation) {
            prt_result r = prt_sh_rotate(bands, back, light + (size_t)c * n, turned);
            if (r != PRT_OK) return r;
        }
        prt__fiv_raise(bands, rotation ? turned : light + (size_t)c * n, x);
        for (i = 0; rotation && i < (int)more; i++) {
            prt_vec3 v = prt__vec3(x[i], y[i], z[i]);
            x[i] = rotation[0] * v.x + rotation[1] * v.y + rotation[2] * v.z;
            y[i] = rotation[3] * v.x + rotation[4] * v.y + rotation[5] * v.z;
            z[i] = rotation[6] * v.x + rotation[7] * v.y + rotation[8] * v.z;
        }
    }
    return PRT_OK;
}

/* The vectors of a projection V under the light that `vectors` stand for. */
PRT__STATIC prt_fiv prt__fiv_under(int count, const prt_real *hidden, const prt_real *vectors) {
    prt_rgb v[3];
    prt_fiv out;
    int c;
    for (c = 0; c < 3; c++) v[c] = prt__shade(count, hidden, vectors + (size_t)(3 * c) * (size_t)count);
    out.r = prt__vec3(v[0].r, v[0].g, v[0].b);
    out.g = prt__vec3(v[1].r, v[1].g, v[1].b);
    out.b = prt__vec3(v[2].r, v[2].g, v[2].b);
    return out;
}

/* out = sum of weight times sample, `count` numbers each; samples of weight 0 are not read. */
PRT__STATIC void prt__fiv_mix(int count, const prt_real *samples, const size_t at[8], const prt_real weight[8],
                              prt_real *out) {
    int k, i;
    memset(out, 0, (size_t)count * sizeof *out);
    for (k = 0; k < 8; k++) {
        const prt_real *sample = samples + at[k] * (size_t)count;
        prt__vec w = prt__vec_set(weight[k]);
        if (!(weight[k] > 0)) continue;
        for (i = 0; i + PRT__LANES <= count; i += PRT__LANES)
            prt__vec_store(out + i, prt__vec_load(out + i) + w * prt__vec_load(sample + i));
        for (; i < count; i++) out[i] += weight[k] * sample[i];
    }
}

PRT__STATIC int prt__fiv_all_finite(int count, const prt_real *v) {
    int i, ok = 1;
    for (i = 0; i < count; i++) ok &= prt__finite(v[i]);
    return ok;
}

PRTDEF prt_result prt_fiv_transfer_lookup(const prt_fiv_transfer *table, const prt_real rotation[9],
                                          const prt_real *vectors, prt_vec3 from_receiver_to_centre, prt_fiv *out) {
    prt_real hidden[PRT_SH_COUNT(PRT_MAX_BANDS)], weight[8];
    prt_vec3 to = from_receiver_to_centre, turned = to;
    prt_result r = prt__fiv_transfer_check(table);
    unsigned char good[8];
    prt__fiv_grid g;
    prt__fiv_cells c;
    size_t at[8];
    int n, k;
    if (r != PRT_OK) return r;
    if (!table->rho || !table->samples || !vectors || !out) return PRT_ERR_NULL;
    if (rotation) turned = prt__vec3(rotation[0] * to.x + rotation[3] * to.y + rotation[6] * to.z,
                                     rotation[1] * to.x + rotation[4] * to.y + rotation[7] * to.z,
                                     rotation[2] * to.x + rotation[5] * to.y + rotation[8] * to.z);
    n = PRT_SH_COUNT(table->bands + 1);
    g.theta_count = table->theta_count; g.phi_count = table->phi_count; g.rho_count = table->rho_count;
    g.rho = table->rho;
    g.inside = table->inside;
    prt__fiv_cell_of(&g, turned, &c);
    prt__fiv_corners(&g, &c, 0, 0, at, weight);
    prt__fiv_mix(n, table->samples, at, weight, hidden);
    *out = prt__fiv_under(n, hidden, vectors);
    if (prt__fiv_sample_finite(out)) return PRT_OK;
    for (k = 0; k < 8; k++) good[k] = (unsigned char)prt__fiv_all_finite(n, table->samples + at[k] * (size_t)n);
    prt__fiv_corners(&g, &c, 0, good, at, weight);
    prt__fiv_mix(n, table->samples, at, weight, hidden);
    *out = prt__fiv_under(n, hidden, vectors);
    if (!prt__fiv_sample_finite(out)) memset(out, 0, sizeof *out);
    return PRT_OK;
}

PRTDEF prt_result prt_fiv_transfer_samples(const prt_fiv_transfer *table, const prt_real *vectors, int first, int count,
                                           prt_fiv *samples) {
    prt_result r = prt__fiv_transfer_check(table);
    int n, k;
    if (r != PRT_OK) return r;
    if (!prt__fiv_range_ok(table->theta_count, table->phi_count, table->rho_count, first, count)) return PRT_ERR_COUNT;
    if (!table->samples || !vectors || (count > 0 && !samples)) return PRT_ERR_NULL;
    n = PRT_SH_COUNT(table->bands + 1);
    for (k = first; k < first + count; k++)
        samples[k] = prt__fiv_under(n, table->samples + (size_t)k * (size_t)n, vectors);
    return PRT_OK;
}

/* The nearest half float, ties to even; the caller has checked |v| <= 65504. By the bits of a double: a half counts its
   exponent from -15, its subnormals have steps of 2^-24. */
PRT__STATIC uint32_t prt__half_of(double v) {
    uint64_t bits, sign = v < 0 ? 0x8000u : 0;
    int exponent, shift = 42;
    memcpy(&bits, &v, sizeof bits);
    bits &= UINT64_C(0x7fffffffffffffff);
    exponent = (int)(bits >> 52) - 1023;
    if (exponent < -25) return (uint32_t)sign;
    if (exponent < -14) {
        shift += -14 - exponent;
        bits = (bits & UINT64_C(0xfffffffffffff)) | UINT64_C(0x10000000000000);
    } else {
        bits -= UINT64_C(1008) << 52;
    }
    bits += (UINT64_C(1) << (shift - 1)) - 1 + (bits >> shift & 1);
    return (uint32_t)(sign | bits >> shift);
}

PRT__INLINE prt_real prt__real_of_half(uint16_t half) {        /* infinity and NaN do not occur */
    uint32_t size = half & 0x7fffu, bits = (size << 13) + 0x38000000u;
    float f;
    memcpy(&f, &bits, sizeof f);
    if (size < 0x400u) f = (float)size * (1.0f / 16777216);    /* in steps of 2^-24 */
    return (prt_real)(half & 0x8000u ? -f : f);
}

/* Sample at index `at`, in the slice of distance k. */
PRT__INLINE void prt__fiv_decode(const prt_fiv_packed *p, size_t at, size_t k, prt_real *out) {
    prt_real low[9], step[9];
    int i;
    if (p->bits == 16) {
        const uint16_t *half = (const uint16_t *)p->data + at * 9;
        for (i = 0; i < 9; i++) out[i] = prt__real_of_half(half[i]);
    } else {
        const unsigned char *byte = (const unsigned char *)p->data + at * 9;
        memcpy(low, &p->low[k], sizeof low);
        memcpy(step, &p->step[k], sizeof step);
        for (i = 0; i < 9; i++) out[i] = low[i] + step[i] * (prt_real)byte[i];
    }
}

PRTDEF size_t prt_fiv_packed_size(const prt_fiv_table *table, int bits) {
    size_t all, sample = (size_t)bits / 8 * 9;
    if (!table || !prt__fiv_table_ok(table) || (bits != 8 && bits != 16)) return 0;
    all = (size_t)table->theta_count;
    if ((size_t)table->phi_count > SIZE_MAX / sample / all) return 0;
    all *= (size_t)table->phi_count;
    return (size_t)table->rho_count > SIZE_MAX / sample / all ? 0 : all * (size_t)table->rho_count * sample;
}

/* Least values and steps of one distance. */
PRT__STATIC void prt__fiv_spread(const prt_fiv *samples, size_t count, prt_fiv *low, prt_fiv *step) {
    prt_real v[9], least[9], most[9];
    size_t k;
    int i;
    memcpy(least, samples, sizeof least);
    memcpy(most, samples, sizeof most);
    for (k = 1; k < count; k++) {
        memcpy(v, &samples[k], sizeof v);
        for (i = 0; i < 9; i++) {
            if (v[i] < least[i]) least[i] = v[i];
            if (v[i] > most[i]) most[i] = v[i];
        }
    }
    for (i = 0; i < 9; i++) most[i] = most[i] / 255 - least[i] / 255;
    memcpy(low, least, sizeof least);
    memcpy(step, most, sizeof most);
}

PRT__STATIC int prt__fiv_all_in_range(const prt_fiv_table *t, size_t count, prt_real most) {
    prt_real v[9];
    size_t k;
    int i, ok = 1;
    for (k = 0; k < count; k++) {
        memcpy(v, &t->samples[k], sizeof v);
        for (i = 0; i < 9; i++) ok &= v[i] <= most && v[i] >= -most;
    }
    return ok;
}

PRT__STATIC void prt__fiv_encode(const prt_fiv_packed *p, size_t ring, void *data) {
    size_t all = ring * (size_t)p->grid.rho_count, k;
    prt_real v[9], low[9], step[9];
    int i;
    for (k = 0; k < all; k++) {
        memcpy(v, &p->grid.samples[k], sizeof v);
        if (p->bits == 16) {
            for (i = 0; i < 9; i++) ((uint16_t *)data)[k * 9 + (size_t)i] = (uint16_t)prt__half_of((double)v[i]);
            continue;
        }
        memcpy(low, &p->low[k / ring], sizeof low);
        memcpy(step, &p->step[k / ring], sizeof step);
        for (i = 0; i < 9; i++) {
            prt_real at = step[i] > 0 ? (v[i] - low[i]) / step[i] : 0;
            ((unsigned char *)data)[k * 9 + (size_t)i] = (unsigned char)(prt__clamp(at, 0, 255) + PRT__R(0.5));
        }
    }
}

PRTDEF prt_result prt_fiv_pack(const prt_fiv_table *table, int bits, void *data, prt_fiv *low, prt_fiv *step,
                               prt_fiv_packed *packed) {
    size_t ring;
    int k;
    if (!table) return PRT_ERR_NULL;
    if (!prt_fiv_packed_size(table, bits)) return PRT_ERR_COUNT;
    if (!table->samples || !data || !packed || (bits == 8 && (!low || !step))) return PRT_ERR_NULL;
    ring = (size_t)table->theta_count * (size_t)table->phi_count;
    if (!prt__fiv_all_in_range(table, ring * (size_t)table->rho_count, bits == 16 ? 65504 : PRT__REAL_MAX))
        return PRT_ERR_VALUE;
    for (k = 0; bits == 8 && k < table->rho_count; k++)
        prt__fiv_spread(table->samples + ring * (size_t)k, ring, low + k, step + k);
    packed->grid = *table;
    packed->bits = bits;
    packed->data = data;
    packed->low = low;
    packed->step = step;
    prt__fiv_encode(packed, ring, data);
    return PRT_OK;
}

PRT__STATIC prt_result prt__fiv_packed_check(const prt_fiv_packed *p) {
    if (!p) return PRT_ERR_NULL;
    if (!prt_fiv_packed_size(&p->grid, p->bits)) return PRT_ERR_COUNT;
    return !p->data || (p->bits == 8 && (!p->low || !p->step)) ? PRT_ERR_NULL : PRT_OK;
}

PRTDEF prt_result prt_fiv_packed_lookup(const prt_fiv_packed *packed, prt_vec3 from_receiver_to_centre, prt_fiv *out) {
    prt_real weight[8], v[9], sum[9] = { 0 };
    prt_result r = prt__fiv_packed_check(packed);
    prt__fiv_grid g;
    prt__fiv_cells c;
    size_t at[8], ring;
    int k, i;
    if (r != PRT_OK) return r;
    if (!packed->grid.rho || !out) return PRT_ERR_NULL;
    g = prt__fiv_grid_of(&packed->grid);
    ring = (size_t)g.theta_count * (size_t)g.phi_count;
    prt__fiv_cell_of(&g, from_receiver_to_centre, &c);
    prt__fiv_corners(&g, &c, 0, 0, at, weight);
    for (k = 0; k < 8; k++) {
        prt__fiv_decode(packed, at[k], at[k] / ring, v);
        for (i = 0; i < 9; i++) sum[i] += weight[k] * v[i];
    }
    memcpy(out, sum, sizeof sum);
    return PRT_OK;
}

PRTDEF prt_result prt_fiv_unpack(const prt_fiv_packed *packed, int first, int count, prt_fiv *samples) {
    prt_result r = prt__fiv_packed_check(packed);
    size_t ring;
    prt_real v[9];
    int k;
    if (r != PRT_OK) return r;
    if (!prt__fiv_range_ok(packed->grid.theta_count, packed->grid.phi_count, packed->grid.rho_count, first, count))
        return PRT_ERR_COUNT;
    if (count > 0 && !samples) return PRT_ERR_NULL;
    ring = (size_t)packed->grid.theta_count * (size_t)packed->grid.phi_count;
    for (k = first; k < first + count; k++) {
        prt__fiv_decode(packed, (size_t)k, (size_t)k / ring, v);
        memcpy(&samples[k], v, sizeof v);
    }
    return PRT_OK;
}

/* Place v of a row of texels, -1 ... 1, as a cell and the weight of its upper texel, which may leave 0 ... 1. */
PRT__STATIC int prt__fiv_texel(int size, prt_real v, prt_real *weight) {
    prt_real at = prt__clamp((v + 1) * PRT__R(0.5), 0, 1) * (prt_real)size - PRT__R(0.5);
    int i = at > 0 ? (int)at : 0;
    if (i > size - 2) i = size > 1 ? size - 2 : 0;
    *weight = size > 1 ? at - (prt_real)i : 0;
    return i;
}

PRTDEF prt_rgb prt_fiv_total(int size, const prt_rgb *total, prt_vec3 normal) {
    prt_real x = prt__abs(normal.x), y = prt__abs(normal.y), z = prt__abs(normal.z), major, s, t, ws, wt;
    const prt_rgb *a, *b;
    prt_rgb out = { 0, 0, 0 };
    size_t right = size > 1 ? 1 : 0, face;
    int i, j;
    if (size < 1 || !total) return out;
    if (x >= y && x >= z) { face = normal.x < 0; major = x; s = normal.x < 0 ? normal.z : -normal.z; t = -normal.y; }
    else if (y >= z) { face = normal.y < 0 ? 3 : 2; major = y; s = normal.x; t = normal.y < 0 ? -normal.z : normal.z; }
    else { face = normal.z < 0 ? 5 : 4; major = z; s = normal.z < 0 ? -normal.x : normal.x; t = -normal.y; }
    i = prt__fiv_texel(size, major > 0 ? s / major : 0, &ws);
    j = prt__fiv_texel(size, major > 0 ? t / major : 0, &wt);
    a = total + (face * (size_t)size + (size_t)j) * (size_t)size + (size_t)i;
    b = a + right * (size_t)size;
    out.r = (1 - wt) * ((1 - ws) * a[0].r + ws * a[right].r) + wt * ((1 - ws) * b[0].r + ws * b[right].r);
    out.g = (1 - wt) * ((1 - ws) * a[0].g + ws * a[right].g) + wt * ((1 - ws) * b[0].g + ws * b[right].g);
    out.b = (1 - wt) * ((1 - ws) * a[0].b + ws * a[right].b) + wt * ((1 - ws) * b[0].b + ws * b[right].b);
    return out;
}

/* ---------------------------------------------------------------------------------------------------- >>vo ---- */

#ifdef PRT_DOUBLE
PRT__INLINE prt_real prt__pow(prt_real x, prt_real y) { return pow(x, y); }
#else
PRT__INLINE prt_real prt__pow(prt_real x, prt_real y) { return powf(x, y); }
#endif
PRT__INLINE prt_real prt__above0(prt_real v) { return v > 0 ? v : 0; }

/* Keeps infinities out: a product or a sum of finite numbers that overflowed becomes the largest finite number. */
PRT__INLINE prt_real prt__bounded(prt_real v) {
    return v > PRT__REAL_MAX ? PRT__REAL_MAX : v < -PRT__REAL_MAX ? -PRT__REAL_MAX : v;
}
PRT__INLINE prt_rgb prt__rgb_scaled(prt_rgb a, prt_real s) {
    a.r = prt__bounded(a.r * s); a.g = prt__bounded(a.g * s); a.b = prt__bounded(a.b * s);
    return a;
}
PRT__INLINE prt_rgb prt__rgb_times(prt_rgb a, prt_rgb b) {
    a.r = prt__bounded(a.r * b.r); a.g = prt__bounded(a.g * b.g); a.b = prt__bounded(a.b * b.b);
    return a;
}
PRT__INLINE prt_rgb prt__rgb_plus(prt_rgb a, prt_rgb b) {
    a.r = prt__bounded(a.r + b.r); a.g = prt__bounded(a.g + b.g); a.b = prt__bounded(a.b + b.b);
    return a;
}
PRT__INLINE prt_real prt__bounded_dot(prt_vec3 a, prt_vec3 b) {
    return prt__bounded(prt__bounded(a.x * b.x) + prt__bounded(a.y * b.y) + prt__bounded(a.z * b.z));
}

/* v at length 1 and its length, through its largest component; zero where v has no direction. */
PRT__STATIC prt_vec3 prt__direction(prt_vec3 v, prt_real *length) {
    prt_real x = prt__abs(v.x), y = prt__abs(v.y), z = prt__abs(v.z), most = x > y ? x : y, s;
    most = z > most ? z : most;
    *length = 0;
    if (!(most >= PRT__REAL_MIN)) return prt__vec3(0, 0, 0);
    x = v.x / most; y = v.y / most; z = v.z / most;
    s = prt__sqrt(x * x + y * y + z * z);
    *length = prt__bounded(most * s);
    return prt__vec3(x / s, y / s, z / s);
}

/* The unit direction from a to b; halves, so that the difference cannot overflow. */
PRT__STATIC prt_vec3 prt__towards(prt_vec3 a, prt_vec3 b) {
    const prt_real half = PRT__R(0.5);
    prt_real length;
    return prt__direction(prt__vec3(half * b.x - half * a.x, half * b.y - half * a.y, half * b.z - half * a.z), &length);
}

PRT__STATIC prt_vec3 prt__reflect(prt_vec3 a, prt_vec3 n) {
    prt_real twice = prt__bounded(2 * prt__bounded_dot(a, n));
    return prt__vec3(prt__bounded(a.x - prt__bounded(twice * n.x)), prt__bounded(a.y - prt__bounded(twice * n.y)),
                     prt__bounded(a.z - prt__bounded(twice * n.z)));
}

/* Parameters with the defaults in their places. */
typedef struct prt__vo_law {
    prt_real shadow, caustic, least, gloss, dd, ds, ss, light_chord;
    unsigned off;
    int cap, gloss_power;              /* gloss_power: gloss if it is a small integer, else 0 */
} prt__vo_law;

#define PRT__VO_GLOSS_POWER 64

PRT__INLINE prt_real prt__or_default(prt_real v, double standard) { return v < 0 || v > 0 ? v : PRT__R(standard); }

PRT__STATIC prt__vo_law prt__vo_law_of(const prt_vo_params *params) {
    prt__vo_law law;
    double c0 = (double)prt__or_default(params->caustic_angle, PRT__PI / 180);
    double light = (double)prt__or_default(params->light_angle, PRT__PI / 36);
    law.shadow = prt__or_default(params->shadow_strength, 1.5);
    law.caustic = prt__or_default(params->caustic_strength, 0.5);
    law.least = PRT__R(sin(c0) * sin(c0));
    law.light_chord = PRT__R(2 * fabs(sin(light / 2)));
    law.gloss = prt__above0(prt__or_default(params->gloss, 8));
    law.gloss_power = 0;
    if (law.gloss >= 1 && law.gloss <= PRT__VO_GLOSS_POWER && law.gloss - (prt_real)(int)law.gloss <= 0)
        law.gloss_power = (int)law.gloss;
    law.dd = prt__or_default(params->dd, 1);
    law.ds = prt__or_default(params->ds, 1);
    law.ss = prt__or_default(params->ss, 1);
    law.off = params->off;
    law.cap = params->law == (int)PRT_VO_CAP;
    return law;
}

PRT__STATIC prt_real prt__vo_gloss(const prt__vo_law *law, prt_real x) {
    prt_real value = 1;
    int power = law->gloss_power;
    if (power == 0) return prt__bounded(prt__pow(x, law->gloss));
    for (;; x *= x) {
        if (power & 1) value *= x;
        if ((power >>= 1) == 0) return prt__bounded(value);
    }
}

/* ---- vectors of numbers ---- */

/* The bits of a prt__vec: as prt__chosen for masks, where a comparison gives -1 or 0 in each lane; unsigned for exponents,
   sums of which may wrap where the value makes no sense. */
#if PRT__SIMD
#  ifdef PRT_DOUBLE
typedef uint64_t prt__bits __attribute__((vector_size(PRT__VEC_BYTES)));
#  else
typedef uint32_t prt__bits __attribute__((vector_size(PRT__VEC_BYTES)));
#  endif
PRT__INLINE prt__chosen prt__vec_less(prt__vec a, prt__vec b) { return (prt__chosen)(a < b); }
#else
#  ifdef PRT_DOUBLE
typedef uint64_t prt__bits;
#  else
typedef uint32_t prt__bits;
#  endif
PRT__INLINE prt__chosen prt__vec_less(prt__vec a, prt__vec b) { return -(prt__chosen)(a < b); }
#endif
PRT__INLINE prt__bits prt__vec_bits(prt__vec v) { prt__bits b; memcpy(&b, &v, sizeof b); return b; }
PRT__INLINE prt__vec prt__vec_of_bits(prt__bits b) { prt__vec v; memcpy(&v, &b, sizeof v); return v; }
PRT__INLINE prt__vec prt__vec_masked(prt__chosen mask, prt__vec v) {
    return prt__vec_of_bits((prt__bits)mask & prt__vec_bits(v));
}
PRT__INLINE prt__vec prt__vec_above0(prt__vec v) { return prt__vec_masked(prt__vec_less(prt__vec_set(0), v), v); }

/* Layout of a prt_real: bits of the fraction, the bits of sqrt(1/2), and the first guess of 1/sqrt. */
#ifdef PRT_DOUBLE
#  define PRT__FRACTION 52
#  define PRT__ROOT_HALF UINT64_C(0x3fe6a09e667f3bcd)
#  define PRT__ROOT_GUESS UINT64_C(0x5fe6eb50c7b537a9)
#  define PRT__ROUNDER 6755399441055744.0                      /* 1.5 * 2^52: its unit is 1 */
#  define PRT__ROUNDER_BITS UINT64_C(0x4338000000000000)
#  define PRT__WHOLE 5629499534213120.0                        /* 1.25 * 2^52: another, so that nothing is folded */
#  define PRT__WHOLE_BITS UINT64_C(0x4334000000000000)
#  define PRT__LEAST_POWER (-1021.0)
#  define PRT__MOST_POWER 1024.25
enum { PRT__ROOT_STEPS = 4, PRT__LOG_TERMS = 11, PRT__EXP_TERMS = 13 };
#else
#  define PRT__FRACTION 23
#  define PRT__ROOT_HALF 0x3f3504f3u
#  define PRT__ROOT_GUESS 0x5f375a86u
#  define PRT__ROUNDER 12582912.0
#  define PRT__ROUNDER_BITS 0x4b400000u
#  define PRT__WHOLE 10485760.0
#  define PRT__WHOLE_BITS 0x4b200000u
#  define PRT__LEAST_POWER (-125.0)
#  define PRT__MOST_POWER 128.25
enum { PRT__ROOT_STEPS = 3, PRT__LOG_TERMS = 5, PRT__EXP_TERMS = 7 };
#endif

/* A small whole number as a prt_real where mask is all ones, else 0. With -ffast-math sums may be taken in another order; the
   mask keeps this difference from being torn apart. */
PRT__INLINE prt__vec prt__vec_of_whole(prt__bits n, prt__chosen mask) {
    return prt__vec_masked(mask, prt__vec_of_bits(n + PRT__WHOLE_BITS) - PRT__R(PRT__WHOLE));
}

/* 1/sqrt(v) by Newton's method, 2 ulp: cheaper than a root and a division, and plain arithmetic. 0 where v is so small that
   the square of that would overflow, so that v/|v| is 0 for vectors without length. */
PRT__INLINE prt__vec prt__vec_inverse_root(prt__vec v) {
    prt__vec half = v * PRT__R(-0.5), y = prt__vec_of_bits(PRT__ROOT_GUESS - (prt__vec_bits(v) >> 1));
    int k;
    for (k = 0; k < PRT__ROOT_STEPS; k++) y *= half * (y * y) + PRT__R(1.5);
    return prt__vec_masked(prt__vec_less(prt__vec_set(PRT__REAL_MIN * 16), v), y);
}

/* log2 of v > 0: v = 2^e m with m in [sqrt(1/2), sqrt(2)), f = (m-1)/(m+1), log m = 2 (f + f^3/3 + f^5/5 + ...).
   Of 0 a number that makes any power but the 0th vanish. */
PRT__INLINE prt__vec prt__vec_log2(prt__vec v) {
    prt__bits bits = prt__vec_bits(v), e = (prt__bits)((prt__chosen)(bits - PRT__ROOT_HALF) >> PRT__FRACTION);
    prt__vec m = prt__vec_of_bits(bits - (e << PRT__FRACTION)), f = (m - PRT__R(1)) / (m + PRT__R(1)), z = f * f, sum;
    prt__chosen positive = prt__vec_less(prt__vec_set(0), v);
    int k;
    sum = prt__vec_set(PRT__R(2.88539008177792681472 / (2 * PRT__LOG_TERMS - 1)));         /* 2/ln 2 over 1, 3, 5 ... */
    for (k = PRT__LOG_TERMS - 1; k > 0; k--) sum = sum * z + PRT__R(2.88539008177792681472 / (2 * k - 1));
    return prt__vec_select(positive, sum * f + prt__vec_of_whole(e, positive), prt__vec_set(PRT__R(-1e30)));
}

/* 2^t: 2^n times the exponential series of (t-n) ln 2, |t-n| <= 1/2. 0 below PRT__LEAST_POWER; not finite (infinity or
   NaN) where it overflows. */
PRT__INLINE prt__vec prt__vec_exp2(prt__vec t) {
    static const prt_real series[14] = {                       /* ln(2)^k / k! */
        PRT__R(1), PRT__R(6.93147180559945309417e-1), PRT__R(2.40226506959100712334e-1), PRT__R(5.55041086648215799532e-2),
        PRT__R(9.61812910762847716198e-3), PRT__R(1.33335581464284434234e-3), PRT__R(1.54035303933816099544e-4),
        PRT__R(1.52527338040598402800e-5), PRT__R(1.32154867901443094884e-6), PRT__R(1.01780860092396997275e-7),
        PRT__R(7.05491162080112332988e-9), PRT__R(4.44553827187081149760e-10), PRT__R(2.56784359934882051420e-11),
        PRT__R(1.36914888539041288809e-12)
    };
    prt__chosen counts = prt__vec_less(prt__vec_set(PRT__R(PRT__LEAST_POWER)), t);
    prt__bits n;
    prt__vec sum = prt__vec_set(series[PRT__EXP_TERMS]), rest;
    int k;
    t = prt__vec_select(counts, t, prt__vec_set(0));
    t = prt__vec_select(prt__vec_less(t, prt__vec_set(PRT__R(PRT__MOST_POWER))), t, prt__vec_set(PRT__R(PRT__MOST_POWER)));
    n = prt__vec_bits(t + PRT__R(PRT__ROUNDER)) - PRT__ROUNDER_BITS;
    rest = t - prt__vec_of_whole(n, counts);
    for (k = PRT__EXP_TERMS - 1; k >= 0; k--) sum = sum * rest + series[k];
    return prt__vec_masked(counts, prt__vec_of_bits(prt__vec_bits(sum) + (n << PRT__FRACTION)));
}

PRT__INLINE prt__vec prt__vec_dot3(const prt__vec *a, const prt__vec *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* v at length 1; adds the square of its length to *squares, which tells whether one overflowed. */
PRT__INLINE prt__vec prt__vec_unit(prt__vec *v, prt__vec *squares) {
    prt__vec square = prt__vec_dot3(v, v), inverse = prt__vec_inverse_root(square);
    *squares += square;
    v[0] *= inverse; v[1] *= inverse; v[2] *= inverse;
    return square;
}

PRT__INLINE void prt__vec_reflect(const prt__vec *a, const prt__vec *n, prt__vec *out) {
    prt__vec twice = prt__vec_dot3(a, n) * PRT__R(-2);
    out[0] = twice * n[0] + a[0]; out[1] = twice * n[1] + a[1]; out[2] = twice * n[2] + a[2];
}

/* out[i] = number i of every row, for rows of `fields` numbers, fields >= PRT__LANES. */
PRT__INLINE void prt__lanes_load(const prt_real *const *rows, int fields, prt__vec *out) {
    int from, lane;
    for (from = 0; from < fields; from += PRT__LANES) {
        int at = from + PRT__LANES <= fields ? from : fields - PRT__LANES;
        for (lane = 0; lane < PRT__LANES; lane++) out[at + lane] = prt__vec_load(rows[lane] + at);
        prt__lanes_transpose(out + at);
    }
}

enum { PRT__VO_FIELDS = 26, PRT__VO_POINT_FIELDS = 16, PRT__VO_WORDS = 10, PRT__VO_WORDS_DIFFUSE = 5 };
typedef char prt__vo_occluder_is_reals[sizeof(prt_vo_occluder) == PRT__VO_FIELDS * sizeof(prt_real) ? 1 : -1];
typedef char prt__vo_point_is_reals[sizeof(prt_vo_point) == PRT__VO_POINT_FIELDS * sizeof(prt_real) ? 1 : -1];

/* Points side by side, in the order of prt_vo_point, their positions halved; sum: what they send to the eye. */
typedef struct prt__vo_lanes {
    prt__vec position[3], normal[3], diffuse[3], specular[3], emissive[3], shininess;
    prt__vec mirror[3], sum[3], squares;
} prt__vo_lanes;

/* Occluders side by side, in the order of prt_vo_occluder. */
typedef struct prt__vo_seen_lanes {
    prt__vec position[3], occlusion[3], caustic[3], transmissive[3], diffuse_normal[3], specular_normal[3];
    prt__vec diffuse[3], specular[3], form_factor, caustic_factor;
} prt__vo_seen_lanes;

/* What PRT__VO_LIGHTS lights send straight to the points: direction, product of the factors of translucent occluders, and
   the logarithm of that of opaque ones. */
typedef struct prt__vo_light_lanes { prt__vec l[3], factor[3], log_block; } prt__vo_light_lanes;

/* The zero occluder, for lanes whose point sees fewer than others; a point without anything, for lanes past the last. */
static const prt_vo_occluder prt__vo_none = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 },
                                              { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, 0, 0 };
static const prt_vo_point prt__vo_nowhere = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, 0 };
static const uint32_t prt__vo_packed_none[PRT__VO_WORDS] = { 0 };

/* ---- packed occluders ---- */

/* All ones where n is not 0. */
PRT__INLINE prt__chosen prt__bits_any(prt__bits n) {
#if PRT__SIMD
    return (prt__chosen)(n != 0);
#else
    return -(prt__chosen)(n != 0);
#endif
}
PRT__INLINE prt__vec prt__vec_of_count(prt__bits n) { return prt__vec_of_whole(n, prt__bits_any(n)); }

/* Half floats, in the low 16 bits: the exponent is moved by a product, which serves subnormal numbers too. */
PRT__INLINE prt__vec prt__vec_of_half(prt__bits h) {
#ifdef PRT_DOUBLE
    return prt__vec_of_bits(((h & 0x7fffu) << 42) | ((h & 0x8000u) << 48)) * 2.74306203439684434063e303;     /* 2^1008 */
#else
    return prt__vec_of_bits(((h & 0x7fffu) << 13) | ((h & 0x8000u) << 16)) * 5192296858534827628530496329220096.0f;
#endif
}

/* A unit vector from octahedral coordinates -steps ... steps, times length; zero where length is not above 0. */
PRT__INLINE void prt__vo_lanes_unfold(prt__vec x, prt__vec y, prt_real steps, prt__vec length, prt__vec *out) {
    prt__vec zero = prt__vec_set(0), one = prt__vec_set(1), ax, ay, below, scale;
    x *= 1 / steps; y *= 1 / steps;
    ax = PRT__SELECT(x < zero, zero - x, x); ay = PRT__SELECT(y < zero, zero - y, y);
    out[2] = one - ax - ay;
    below = prt__vec_above0(zero - out[2]);
    out[0] = PRT__SELECT(x < zero, x + below, x - below);
    out[1] = PRT__SELECT(y < zero, y + below, y - below);
    scale = prt__vec_inverse_root(prt__vec_dot3(out, out)) * prt__vec_above0(length);
    out[0] *= scale; out[1] *= scale; out[2] *= scale;
}
PRT__INLINE void prt__vo_lanes_unfold16(prt__bits word, prt__vec factor, prt__vec *out) {
    prt__vec length = prt__vec_masked(prt__vec_less(prt__vec_set(0), factor), prt__vec_set(1));
    prt__vo_lanes_unfold(prt__vec_of_count((word & 0xffffu) ^ 0x8000u) - PRT__R(32768),
                         prt__vec_of_count(((word >> 16) & 0xffffu) ^ 0x8000u) - PRT__R(32768), 32767, length, out);
}
PRT__INLINE void prt__vo_lanes_unfold12(prt__bits word, prt__vec length, prt__vec *out) {
    prt__vo_lanes_unfold(prt__vec_of_count(word & 0xfffu) - PRT__R(2048),
                         prt__vec_of_count((word >> 12) & 0xfffu) - PRT__R(2048), 2047, length, out);
}
PRT__INLINE prt__vec prt__vo_lanes_color(prt__bits word, int shift) {
    prt__vec root = prt__vec_of_count((word >> shift) & 0xffu) * PRT__R(1 / 255.0);
    return root * root;
}

/* Rows of words, one to each lane, of points at position. */
PRT__INLINE void prt__vo_lanes_unpack(const uint32_t *const *rows, int words, prt_real unit, const prt__vec *position,
                                      prt__vo_seen_lanes *o) {
#ifdef PRT_DOUBLE
    uint64_t lanes[PRT__VO_WORDS][PRT__LANES];
#else
    uint32_t lanes[PRT__VO_WORDS][PRT__LANES];
#endif
    prt__bits w[PRT__VO_WORDS];
    int lane, k;
    for (lane = 0; lane < PRT__LANES; lane++) for (k = 0; k < words; k++) lanes[k][lane] = rows[lane][k];
    memset(o, 0, sizeof *o);
    memcpy(w, lanes, (size_t)words * sizeof *w);
    o->position[0] = prt__vec_of_half(w[0] & 0xffffu) * unit + position[0];
    o->position[1] = prt__vec_of_half((w[0] >> 16) & 0xffffu) * unit + position[1];
    o->position[2] = prt__vec_of_half(w[1] & 0xffffu) * unit + position[2];
    o->form_factor = prt__vec_of_half((w[1] >> 16) & 0xffffu);
    prt__vo_lanes_unfold16(w[2], o->form_factor, o->occlusion);
    prt__vo_lanes_unfold12(w[3], prt__vec_of_half(w[4] & 0xffffu), o->diffuse_normal);
    o->diffuse[0] = prt__vo_lanes_color(w[3], 24);
    o->diffuse[1] = prt__vo_lanes_color(w[4], 16);
    o->diffuse[2] = prt__vo_lanes_color(w[4], 24);
    if (words < PRT__VO_WORDS) return;
    o->caustic_factor = prt__vec_of_half(w[6] & 0xffffu);
    prt__vo_lanes_unfold16(w[5], o->caustic_factor, o->caustic);
    prt__vo_lanes_unfold12(w[7], prt__vec_of_half((w[6] >> 16) & 0xffffu), o->specular_normal);
    o->specular[0] = prt__vo_lanes_color(w[7], 24);
    o->specular[1] = prt__vo_lanes_color(w[8], 0);
    o->specular[2] = prt__vo_lanes_color(w[8], 8);
    o->transmissive[0] = prt__vo_lanes_color(w[8], 16);
    o->transmissive[1] = prt__vo_lanes_color(w[8], 24);
    o->transmissive[2] = prt__vo_lanes_color(w[9], 0);
}

/* `count` rows of packed occluders of one point. */
PRT__STATIC void prt__vo_unpack_rows(prt_real unit, prt_vec3 at, int count, const uint32_t *packed, int words,
                                     prt_vo_occluder *out) {
    prt__vec position[3];
    int k, lane, i;
    position[0] = prt__vec_set(at.x); position[1] = prt__vec_set(at.y); position[2] = prt__vec_set(at.z);
    for (k = 0; k < count; k += PRT__LANES) {
        const uint32_t *rows[PRT__LANES];
        prt_real fields[PRT__VO_FIELDS][PRT__LANES];
        prt__vo_seen_lanes o;
        for (lane = 0; lane < PRT__LANES; lane++)
            rows[lane] = k + lane < count ? packed + (size_t)(k + lane) * (size_t)words : prt__vo_packed_none;
        prt__vo_lanes_unpack(rows, words, unit, position, &o);
        memcpy(fields, &o, sizeof fields);
        for (lane = 0; lane < PRT__LANES && k + lane < count; lane++)
            for (i = 0; i < PRT__VO_FIELDS; i++) (&out[k + lane].position.x)[i] = fields[i][lane];
    }
}

PRT__STATIC uint32_t prt__byte_of(prt_real color) { return (uint32_t)(sqrt((double)color) * 255 + 0.5); }

PRT__STATIC double prt__length3(prt_vec3 v) {                  /* NaN and infinity stay */
    double x = fabs((double)v.x), y = fabs((double)v.y), z = fabs((double)v.z), most = x > y ? x : y;
    most = z > most ? z : most;
    return most > 0 ? most * sqrt(x / most * (x / most) + y / most * (y / most) + z / most * (z / most)) : x + y + z;
}

/* Octahedral coordinates of v, whole numbers from -steps to steps. */
PRT__STATIC void prt__fold(prt_vec3 v, double steps, int out[2]) {
    double length = prt__length3(v), x, y, z, size, u, w;
    out[0] = out[1] = 0;
    if (!(length > 0)) return;
    x = (double)v.x / length; y = (double)v.y / length; z = (double)v.z / length;
    size = fabs(x) + fabs(y) + fabs(z);
    u = x / size; w = y / size;
    if (z < 0) {
        u = (1 - fabs(y) / size) * (x < 0 ? -1 : 1);
        w = (1 - fabs(x) / size) * (y < 0 ? -1 : 1);
    }
    out[0] = (int)floor(u * steps + 0.5);
    out[1] = (int)floor(w * steps + 0.5);
}
PRT__STATIC uint32_t prt__fold16(prt_vec3 v) {
    int at[2];
    prt__fold(v, 32767, at);
    return ((uint32_t)at[0] & 0xffffu) | ((uint32_t)at[1] & 0xffffu) << 16;
}
PRT__STATIC uint32_t prt__fold12(prt_vec3 v) {
    int at[2];
    prt__fold(v, 2047, at);
    return (uint32_t)(at[0] + 2048) | (uint32_t)(at[1] + 2048) << 12;
}

PRT__INLINE int prt__half_holds(double v) { return fabs(v) <= 65504; }         /* false for NaN */

/* Whether it can be packed; the words, where out is not NULL. */
PRT__STATIC int prt__vo_pack_one(double unit, prt_vec3 at, const prt_vo_occluder *o, int words, uint32_t *out) {
    double x = (double)o->position.x / unit - (double)at.x / unit, y = (double)o->position.y / unit - (double)at.y / unit;
    double z = (double)o->position.z / unit - (double)at.z / unit, f = (double)o->form_factor;
    double diffuse = prt__length3(o->diffuse_normal), specular = prt__length3(o->specular_normal);
    double focus = (double)o->caustic_factor;
    if (!prt__half_holds(x) || !prt__half_holds(y) || !prt__half_holds(z) || !prt__half_holds(f) || f < 0) return 0;
    if (!prt__half_holds(diffuse) || !prt__rgb_within_1(o->diffuse) || !prt__finite3(o->occlusion)) return 0;
    if (words > PRT__VO_WORDS_DIFFUSE &&
        (!prt__half_holds(focus) || focus < 0 || !prt__half_holds(specular) || !prt__rgb_within_1(o->specular) ||
         !prt__rgb_within_1(o->transmissive) || !prt__finite3(o->caustic))) return 0;
    if (!out) return 1;
    if (!(prt__length3(o->occlusion) > 0)) f = 0;
    if (!(prt__length3(o->caustic) > 0)) focus = 0;
    out[0] = prt__half_of(x) | prt__half_of(y) << 16;
    out[1] = prt__half_of(z) | prt__half_of(f) << 16;
    out[2] = prt__fold16(o->occlusion);
    out[3] = prt__fold12(o->diffuse_normal) | prt__byte_of(o->diffuse.r) << 24;
    out[4] = prt__half_of(diffuse) | prt__byte_of(o->diffuse.g) << 16 | prt__byte_of(o->diffuse.b) << 24;
    if (words == PRT__VO_WORDS_DIFFUSE) return 1;
    out[5] = prt__fold16(o->caustic);
    out[6] = prt__half_of(focus) | prt__half_of(specular) << 16;
    out[7] = prt__fold12(o->specular_normal) | prt__byte_of(o->specular.r) << 24;
    out[8] = prt__byte_of(o->specular.g) | prt__byte_of(o->specular.b) << 8 | prt__byte_of(o->transmissive.r) << 16 |
             prt__byte_of(o->transmissive.g) << 24;
    out[9] = prt__byte_of(o->transmissive.b);
    return 1;
}

/* ---- one point ---- */

/* Points and where their occluders stand: what prt_vo_shade_n and its kin were given. Packed occluders are rows of `words`
   words; words 0: occluders are plain. */
typedef struct prt__vo_batch {
    prt__vo_law law;
    const prt_vo_point *points;
    const int *first;
    const prt_vo_occluder *occluders;
    const uint32_t *packed;
    int words;
    prt_real unit;
    prt_vec3 eye;
    int light_count;
    const prt_point_light *lights;
} prt__vo_batch;

/* Occluder number `at` of the point; out is where one that is packed is unpacked. */
PRT__INLINE const prt_vo_occluder *prt__vo_occluder_at(const prt__vo_batch *b, const prt_vo_point *p, int at,
                                                       prt_vo_occluder *out) {
    if (b->words == 0) return b->occluders + at;
    prt__vo_unpack_rows(b->unit, p->position, 1, b->packed + (size_t)at * (size_t)b->words, b->words, out);
    return out;
}

/* An occluder as one point sees it: everything that does not depend on the light. */
typedef struct prt__vo_seen {
    prt_vec3 position, occlusion, caustic, dd_dir, ds_dir, ss_dir;
    prt_real block, focus;             /* exponents, 0: no such effect */
    prt_real cap_chord;                /* of the cap that stands for the occluder */
    prt_rgb transmissive, dd, ds, ss;  /* the colours that the terms carry */
} prt__vo_seen;

/* Chord of the angle a between the axis and the rim of a cap with form factor F: sin^2 a = F/cosine, at most 1. */
PRT__INLINE prt_real prt__cap_chord(prt_real f, prt_real cosine) {
    prt_real sin2 = f < cosine ? f / cosine : 1;
    return prt__sqrt(2 * sin2 / (1 + prt__sqrt(1 - sin2)));
}

PRT__STATIC void prt__vo_see(const prt__vo_law *law, const prt_vo_point *p, prt_vec3 mirror, const prt_vo_occluder *o,
                             prt__vo_seen *s) {
    prt_vec3 v = prt__towards(p->position, o->position), n;
    prt_real length, specular, lined_up;
    s->position = o->position;
    s->occlusion = prt__direction(o->occlusion, &length);
    s->block = (law->off & PRT_VO_NO_SHADOW) || !(length > 0) ? 0 : prt__above0(o->form_factor);
    s->cap_chord = prt__cap_chord(s->block, prt__bounded_dot(p->normal, s->occlusion));
    if (!law->cap) s->block = prt__bounded(prt__above0(s->block * law->shadow));
    s->caustic = prt__direction(o->caustic, &length);
    s->focus = (law->off & PRT_VO_NO_CAUSTIC) || !(length > 0) ? 0
             : prt__bounded(prt__above0(law->caustic * prt__above0(o->caustic_factor)));
    s->transmissive = o->transmissive;
    s->dd_dir = o->diffuse_normal;
    s->dd = prt__rgb_scaled(prt__rgb_times(o->diffuse, p->diffuse), law->off & PRT_VO_NO_DD ? 0 : law->dd);
    n = prt__direction(o->specular_normal, &specular);
    s->ds_dir = prt__reflect(v, n);
    s->ds = prt__rgb_scaled(prt__rgb_times(o->specular, p->diffuse), law->off & PRT_VO_NO_DS ? 0 : law->ds);
    s->ds = prt__rgb_scaled(s->ds, specular);
    s->ss_dir = prt__reflect(mirror, n);
    lined_up = prt__bounded_dot(p->normal, v) > 0 ? prt__above0(prt__bounded_dot(mirror, v)) : 0;
    s->ss = prt__rgb_scaled(prt__rgb_times(o->specular, p->specular), law->off & PRT_VO_NO_SS ? 0 : law->ss);
    s->ss = prt__rgb_scaled(prt__rgb_scaled(s->ss, specular), lined_up);
}

/* sin^2 of the angle between unit vectors, 1 from 90 degrees on. */
PRT__INLINE prt_real prt__vo_sin2(prt_vec3 d, prt_vec3 l) {
    prt_real x = d.y * l.z - d.z * l.y, y = d.z * l.x - d.x * l.z, z = d.x * l.y - d.y * l.x, s = x * x + y * y + z * z;
    return prt__dot3(d, l) > 0 && s < 1 ? s : 1;
}

/* Share of the smaller of two discs that lies behind the other, by how deep they are in each other, u = 0 outside ... 1 inside,
   and by the ratio of their radii: the step [Oat 2007] uses, and a correction fitted to the area of the lens, within 0.023. */
#define PRT__LENS_STEP(u, ratio) ((u) * (u) * (3 - (u) - (u)) + \
    (u) * (1 - (u)) * ((1 - (u) - (u)) * (1 - (ratio)) * PRT__R(0.2) - (u) * (u) * (ratio) * PRT__R(1.4)))

/* Share of a disc of radius `light` that a disc of radius `cap` leaves open, centres `apart`. */
PRT__INLINE prt_real prt__vo_cap_open(prt_real cap, prt_real light, prt_real apart) {
    prt_real least = cap < light ? cap : light, most = cap < light ? light : cap, u, share;
    if (!(least > 0)) return 1;
    u = (cap + light - apart) / (2 * least);
    u = u > 0 ? u < 1 ? u : 1 : 0;
    share = least / light;
    return 1 - share * share * PRT__LENS_STEP(u, least / most);
}

PRT__INLINE prt_real prt__vo_block(const prt__vo_law *law, const prt__vo_seen *s, prt_vec3 l) {
    if (!(s->block > 0)) return 1;
    if (law->cap) {
        prt_vec3 apart = prt__vec3(s->occlusion.x - l.x, s->occlusion.y - l.y, s->occlusion.z - l.z);
        return prt__vo_cap_open(s->cap_chord, law->light_chord, prt__sqrt(prt__dot3(apart, apart)));
    }
    return prt__pow(prt__vo_sin2(s->occlusion, l), s->block);
}

PRT__INLINE prt_real prt__vo_focus(const prt__vo_law *law, const prt__vo_seen *s, prt_vec3 l) {
    prt_real sin2 = prt__vo_sin2(s->caustic, l);
    if (!(s->focus > 0)) return 1;
    return prt__bounded(prt__pow(sin2 > law->least ? sin2 : law->least, -s->focus));
}

PRT__INLINE prt_real prt__vo_pass(prt_real transmissive, prt_real block, prt_real focus) {
    return prt__bounded(prt__bounded((1 - transmissive) * block) + prt__bounded(transmissive * focus));
}

/* What the occluder sends to the point of the light, DD + DS + SS. */
PRT__STATIC prt_rgb prt__vo_sent(const prt__vo_law *law, const prt__vo_seen *s, prt_vec3 light) {
    prt_vec3 l = prt__towards(s->position, light);
    prt_rgb sum = prt__rgb_scaled(s->dd, prt__above0(prt__bounded_dot(s->dd_dir, l)));
    if (!(law->off & PRT_VO_NO_DS))
        sum = prt__rgb_plus(sum, prt__rgb_scaled(s->ds, prt__vo_gloss(law, prt__above0(prt__bounded_dot(s->ds_dir, l)))));
    if (!(law->off & PRT_VO_NO_SS))
        sum = prt__rgb_plus(sum, prt__rgb_scaled(s->ss, prt__vo_gloss(law, prt__above0(prt__bounded_dot(s->ss_dir, l)))));
    return sum;
}

/* Lights worked on together, so that an occluder is prepared once for so many. */
enum { PRT__VO_LIGHTS = 8 };
enum { PRT__VO_SENDS = PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS };

/* Adds what some lights send to the point, directly and by way of the occluders. */
PRT__STATIC void prt__vo_add_lights(const prt__vo_batch *b, int point, prt_vec3 mirror, int light_count,
                                    const prt_point_light *lights, prt_rgb *sum) {
    const prt__vo_law *law = &b->law;
    const prt_vo_point *p = &b->points[point];
    prt_vec3 l[PRT__VO_LIGHTS];
    prt_rgb direct[PRT__VO_LIGHTS];
    int j, k;
    for (j = 0; j < light_count; j++) {
        l[j] = prt__towards(p->position, lights[j].position);
        direct[j] = prt__rgb_scaled(p->specular, prt__bounded(prt__pow(prt__above0(prt__bounded_dot(mirror, l[j])),
                                                                       prt__above0(p->shininess))));
        direct[j] = prt__rgb_plus(direct[j], prt__rgb_scaled(p->diffuse, prt__above0(prt__bounded_dot(p->normal, l[j]))));
    }
    for (k = b->first[point]; k < b->first[point + 1]; k++) {
        prt_vo_occluder unpacked;
        prt__vo_seen s;
        prt__vo_see(law, p, mirror, prt__vo_occluder_at(b, p, k, &unpacked), &s);
        for (j = 0; j < light_count; j++) {
            prt_real block = prt__vo_block(law, &s, l[j]), focus = prt__vo_focus(law, &s, l[j]);
            direct[j].r = prt__bounded(direct[j].r * prt__vo_pass(s.transmissive.r, block, focus));
            direct[j].g = prt__bounded(direct[j].g * prt__vo_pass(s.transmissive.g, block, focus));
            direct[j].b = prt__bounded(direct[j].b * prt__vo_pass(s.transmissive.b, block, focus));
            if ((law->off & PRT__VO_SENDS) == PRT__VO_SENDS) continue;
            *sum = prt__rgb_plus(*sum, prt__rgb_times(lights[j].color, prt__vo_sent(law, &s, lights[j].position)));
        }
    }
    for (j = 0; j < light_count; j++) *sum = prt__rgb_plus(*sum, prt__rgb_times(lights[j].color, direct[j]));
}

PRT__STATIC prt_rgb prt__vo_shade(const prt__vo_batch *b, int point) {
    const prt_vo_point *p = &b->points[point];
    prt_vec3 mirror = prt__reflect(prt__towards(b->eye, p->position), p->normal);
    prt_rgb sum = p->emissive;
    int j;
    for (j = 0; j < b->light_count; j += PRT__VO_LIGHTS)
        prt__vo_add_lights(b, point, mirror, b->light_count - j < PRT__VO_LIGHTS ? b->light_count - j : (int)PRT__VO_LIGHTS,
                           b->lights + j, &sum);
    sum.r = prt__above0(sum.r); sum.g = prt__above0(sum.g); sum.b = prt__above0(sum.b);
    return sum;
}

/* ---- the same for PRT__LANES points at once ---- */

PRT__INLINE void prt__vo_lanes_towards(const prt__vec *half_position, prt_vec3 to, prt__vec *out) {
    out[0] = PRT__R(0.5) * to.x - half_position[0];
    out[1] = PRT__R(0.5) * to.y - half_position[1];
    out[2] = PRT__R(0.5) * to.z - half_position[2];
}

PRT__INLINE void prt__vo_lanes_halve(prt__vec *v) { v[0] *= PRT__R(0.5); v[1] *= PRT__R(0.5); v[2] *= PRT__R(0.5); }

/* sin^2 of the angle between unit vectors, 1 from 90 degrees on: with q = |d-l|^2 it is q (1 - q/4), and nothing cancels. */
PRT__INLINE prt__vec prt__vo_lanes_chord2(const prt__vec *d, const prt__vec *l) {
    prt__vec x = d[0] - l[0], y = d[1] - l[1], z = d[2] - l[2];
    return x * x + y * y + z * z;
}
PRT__INLINE prt__vec prt__vo_lanes_sin2(const prt__vec *d, const prt__vec *l) {
    prt__vec q = prt__vo_lanes_chord2(d, l);
    return prt__vec_select(prt__vec_less(q, prt__vec_set(2)), q * (q * PRT__R(-0.25) + PRT__R(1)), prt__vec_set(1));
}

PRT__INLINE prt__vec prt__vo_lanes_gloss(const prt__vo_law *law, prt__vec x) {
    prt__vec value = prt__vec_set(1);
    int power = law->gloss_power;
    if (power == 0) return prt__vec_exp2(prt__vec_log2(x) * law->gloss);
    for (;; x *= x) {
        if (power & 1) value *= x;
        if ((power >>= 1) == 0) return value;
    }
}

/* As prt__cap_chord and prt__vo_cap_open. */
PRT__INLINE prt__vec prt__vo_lanes_cap_chord(prt__vec f, prt__vec cosine) {
    prt__vec one = prt__vec_set(1), sin2 = prt__vec_select(prt__vec_less(f, cosine), f / cosine, one);
    return prt__vec_masked(prt__vec_less(prt__vec_set(0), f),
                           prt__vec_root(PRT__R(2) * sin2 / (prt__vec_root(one - sin2) + PRT__R(1))));
}
PRT__INLINE prt__vec prt__vo_lanes_cap_open(prt__vec cap, prt_real light, prt__vec apart) {
    prt__vec zero = prt__vec_set(0), one = prt__vec_set(1), disc = prt__vec_set(light);
    prt__chosen inside = prt__vec_less(cap, disc);
    prt__vec least = prt__vec_select(inside, cap, disc), most = prt__vec_select(inside, disc, cap), share, u;
    u = prt__vec_above0((cap + disc - apart) / (least + least));
    u = prt__vec_select(prt__vec_less(u, one), u, one);
    share = least / disc;
    return prt__vec_select(prt__vec_less(zero, cap), one - share * share * PRT__LENS_STEP(u, least / most), one);
}

/* Prepares the occluder: directions to unit length, exponents, colours. In place: occlusion and caustic become directions,
   form_factor and caustic_factor exponents, position half of itself, specular_normal the direction of DS, diffuse and
   specular the colours of DD and DS. ss, ss_dir: those of SS; cap: the chord of the cap law. */
PRT__INLINE void prt__vo_lanes_see(const prt__vo_law *law, prt__vo_lanes *p, prt__vo_seen_lanes *o, prt__vec *ss,
                                   prt__vec *ss_dir, prt__vec *cap) {
    prt__vec zero = prt__vec_set(0), v[3], n[3], specular, square, lined_up;
    int c;
    prt__vo_lanes_halve(o->position);
    square = prt__vec_unit(o->occlusion, &p->squares);
    o->form_factor = prt__vec_masked(prt__vec_less(zero, square), prt__vec_above0(o->form_factor));
    if (law->off & PRT_VO_NO_SHADOW) o->form_factor = zero;
    if (law->cap) *cap = prt__vo_lanes_cap_chord(o->form_factor, prt__vec_dot3(p->normal, o->occlusion));
    else o->form_factor = prt__vec_above0(o->form_factor * law->shadow);
    square = prt__vec_unit(o->caustic, &p->squares);
    o->caustic_factor = prt__vec_masked(prt__vec_less(zero, square), prt__vec_above0(o->caustic_factor));
    o->caustic_factor = law->off & PRT_VO_NO_CAUSTIC ? zero : prt__vec_above0(o->caustic_factor * law->caustic);
    for (c = 0; c < 3; c++) {
        o->diffuse[c] *= p->diffuse[c] * (law->off & PRT_VO_NO_DD ? 0 : law->dd);
        ss[c] = o->specular[c] * p->specular[c];
        o->specular[c] *= p->diffuse[c];
        v[c] = o->position[c] - p->position[c];
        n[c] = o->specular_normal[c];
    }
    if ((law->off & PRT_VO_NO_DS) && (law->off & PRT_VO_NO_SS)) return;
    prt__vec_unit(v, &p->squares);
    specular = prt__vec_root(prt__vec_unit(n, &p->squares));
    prt__vec_reflect(v, n, o->specular_normal);
    prt__vec_reflect(p->mirror, n, ss_dir);
    lined_up = prt__vec_masked(prt__vec_less(zero, prt__vec_dot3(p->normal, v)),
                               prt__vec_above0(prt__vec_dot3(p->mirror, v)));
    for (c = 0; c < 3; c++) {
        o->specular[c] *= specular * law->ds;
        ss[c] *= specular * lined_up * law->ss;
    }
}

/* Adds what the occluders send from one light. */
PRT__INLINE void prt__vo_lanes_send(const prt__vo_law *law, prt__vo_lanes *p, const prt__vo_seen_lanes *o,
                                    const prt__vec *ss, const prt__vec *ss_dir, const prt_point_light *light) {
    prt__vec l[3], square, inverse, dd, ds = prt__vec_set(0), mirrored = ds;
    prt__vo_lanes_towards(o->position, light->position, l);
    square = prt__vec_dot3(l, l);
    inverse = prt__vec_inverse_root(square);
    p->squares += square;
    dd = prt__vec_above0(prt__vec_dot3(o->diffuse_normal, l)) * inverse;
    if (!(law->off & PRT_VO_NO_DS))
        ds = prt__vo_lanes_gloss(law, prt__vec_above0(prt__vec_dot3(o->specular_normal, l)) * inverse);
    if (!(law->off & PRT_VO_NO_SS))
        mirrored = prt__vo_lanes_gloss(law, prt__vec_above0(prt__vec_dot3(ss_dir, l)) * inverse);
    if ((law->off & PRT_VO_NO_DS) && (law->off & PRT_VO_NO_SS)) {
        p->sum[0] += o->diffuse[0] * dd * light->color.r;
        p->sum[1] += o->diffuse[1] * dd * light->color.g;
        p->sum[2] += o->diffuse[2] * dd * light->color.b;
        return;
    }
    p->sum[0] += (o->diffuse[0] * dd + o->specular[0] * ds + ss[0] * mirrored) * light->color.r;
    p->sum[1] += (o->diffuse[1] * dd + o->specular[1] * ds + ss[1] * mirrored) * light->color.g;
    p->sum[2] += (o->diffuse[2] * dd + o->specular[2] * ds + ss[2] * mirrored) * light->color.b;
}

/* Whether any lane of any of three vectors is not 0. */
PRT__INLINE int prt__vo_lanes_any(const prt__vec *v) {
    prt_real lane[3 * PRT__LANES];
    int k, any = 0;
    for (k = 0; k < 3; k++) prt__vec_store(lane + k * PRT__LANES, v[k]);
    for (k = 0; k < 3 * PRT__LANES; k++) any |= lane[k] < 0 || lane[k] > 0;
    return any;
}

/* What one occluder of each point does to the light that comes straight from some lights, and what it sends itself. */
PRT__INLINE void prt__vo_lanes_occlude(const prt__vo_law *law, prt__vo_lanes *p, prt__vo_seen_lanes *o, int light_count,
                                       const prt_point_light *lights, prt__vo_light_lanes *direct) {
    prt__vec zero = prt__vec_set(0), one = prt__vec_set(1), ss[3], ss_dir[3] = { zero, zero, zero }, cap = one, least = prt__vec_set(law->least);
    prt__chosen clear[3], translucent;
    int j, c, any = prt__vo_lanes_any(o->transmissive);
    prt__vo_lanes_see(law, p, o, ss, ss_dir, &cap);
    for (c = 0; c < 3; c++)
        clear[c] = prt__vec_less(zero, o->transmissive[c]) | prt__vec_less(o->transmissive[c], zero);
    translucent = clear[0] | clear[1] | clear[2];
    for (j = 0; j < light_count; j++) {
        prt__vo_light_lanes *d = &direct[j];
        prt__vec block = one, focus;
        if (law->off & PRT_VO_NO_SHADOW) {
            block = one;
        } else if (law->cap) {
            block = prt__vo_lanes_cap_open(cap, law->light_chord, prt__vec_root(prt__vo_lanes_chord2(o->occlusion, d->l)));
        } else {
            prt__vec log_block = o->form_factor * prt__vec_log2(prt__vo_lanes_sin2(o->occlusion, d->l));
            d->log_block += prt__vec_masked(~translucent, log_block);
            if (any) block = prt__vec_exp2(prt__vec_masked(translucent, log_block));
        }
        if (any) {
            focus = prt__vo_lanes_sin2(o->caustic, d->l);
            focus = prt__vec_select(prt__vec_less(least, focus), focus, least);
            focus = prt__vec_exp2(zero - o->caustic_factor * prt__vec_log2(focus));
            for (c = 0; c < 3; c++) d->factor[c] *= (one - o->transmissive[c]) * block + o->transmissive[c] * focus;
        } else if (law->cap) {
            for (c = 0; c < 3; c++) d->factor[c] *= block;
        }
        if ((law->off & PRT__VO_SENDS) != PRT__VO_SENDS) prt__vo_lanes_send(law, p, o, ss, ss_dir, &lights[j]);
    }
}

/* A light's direction from the points; what it sends if nothing is in its way. */
PRT__INLINE void prt__vo_lanes_light(prt__vo_lanes *p, const prt_point_light *light, prt__vo_light_lanes *d) {
    prt__vec square, spread, gloss;
    int c;
    prt__vo_lanes_towards(p->position, light->position, d->l);
    square = prt__vec_unit(d->l, &p->squares);
    spread = prt__vec_above0(prt__vec_dot3(p->normal, d->l));
    gloss = prt__vec_exp2(p->shininess * prt__vec_log2(prt__vec_above0(prt__vec_dot3(p->mirror, d->l))));
    for (c = 0; c < 3; c++) d->factor[c] = p->diffuse[c] * spread + p->specular[c] * gloss;
    d->log_block = prt__vec_set(0);
    d->l[0] = prt__vec_select(prt__vec_less(prt__vec_set(0), square), d->l[0], prt__vec_set(4));   /* on the point: no */
}                                                                                      /* direction is within 90 degrees */

/* Occluder number k of each of the points from ... from+count-1. */
PRT__INLINE void prt__vo_lanes_fetch(const prt__vo_batch *b, const prt__vo_lanes *p, int from, int count, int k,
                                     prt__vo_seen_lanes *o) {
    const prt_real *rows[PRT__LANES];
    const uint32_t *packed[PRT__LANES];
    prt__vec fields[PRT__VO_FIELDS];
    int lane, c;
    for (lane = 0; lane < PRT__LANES; lane++) {
        const int *first = b->first + from + lane;
        int some = lane < count && k < first[1] - first[0];
        rows[lane] = some && b->words == 0 ? &b->occluders[first[0] + k].position.x : &prt__vo_none.position.x;
        packed[lane] = some && b->words ? b->packed + (size_t)(first[0] + k) * (size_t)b->words : prt__vo_packed_none;
    }
    if (b->words) {
        for (c = 0; c < 3; c++) fields[c] = p->position[c] * PRT__R(2);
        prt__vo_lanes_unpack(packed, b->words, b->unit, fields, o);
        return;
    }
    prt__lanes_load(rows, PRT__VO_FIELDS, fields);
    memcpy(o, fields, sizeof fields);
}

PRT__INLINE void prt__vo_lanes_begin(const prt__vo_batch *b, int from, int count, prt__vo_lanes *p) {
    const prt_real *rows[PRT__LANES];
    prt__vec fields[PRT__VO_POINT_FIELDS], eye[3];
    int lane, c;
    for (lane = 0; lane < PRT__LANES; lane++)
        rows[lane] = lane < count ? &b->points[from + lane].position.x : &prt__vo_nowhere.position.x;
    prt__lanes_load(rows, PRT__VO_POINT_FIELDS, fields);
    memcpy(p, fields, sizeof fields);
    prt__vo_lanes_halve(p->position);
    p->shininess = prt__vec_above0(p->shininess);
    p->squares = prt__vec_set(0);
    prt__vo_lanes_towards(p->position, b->eye, eye);
    prt__vec_unit(eye, &p->squares);
    for (c = 0; c < 3; c++) { eye[c] = prt__vec_set(0) - eye[c]; p->sum[c] = p->emissive[c]; }
    prt__vec_reflect(eye, p->normal, p->mirror);
}

/* Points from ... from+count-1, count at most PRT__LANES. What is not finite in the end, or came near overflow, is done
   again by the code that cannot overflow. */
PRT__STATIC void prt__vo_shade_lanes(const prt__vo_batch *b, int from, int count, prt_rgb *out) {
    prt__vo_light_lanes direct[PRT__VO_LIGHTS];
    prt__vo_seen_lanes o;
    prt__vo_lanes p;
    prt_real sum[3][PRT__LANES], squares[PRT__LANES];
    int j, k, c, at, most = 0;
    for (k = from; k < from + count; k++) if (b->first[k + 1] - b->first[k] > most) most = b->first[k + 1] - b->first[k];
    prt__vo_lanes_begin(b, from, count, &p);
    for (at = 0; at < b->light_count; at += PRT__VO_LIGHTS) {
        int lights = b->light_count - at < PRT__VO_LIGHTS ? b->light_count - at : (int)PRT__VO_LIGHTS;
        for (j = 0; j < lights; j++) prt__vo_lanes_light(&p, &b->lights[at + j], &direct[j]);
        for (k = 0; k < most; k++) {
            prt__vo_lanes_fetch(b, &p, from, count, k, &o);
            prt__vo_lanes_occlude(&b->law, &p, &o, lights, b->lights + at, direct);
        }
        for (j = 0; j < lights; j++) {
            prt__vec block = prt__vec_exp2(direct[j].log_block);
            p.sum[0] += direct[j].factor[0] * block * b->lights[at + j].color.r;
            p.sum[1] += direct[j].factor[1] * block * b->lights[at + j].color.g;
            p.sum[2] += direct[j].factor[2] * block * b->lights[at + j].color.b;
        }
    }
    for (c = 0; c < 3; c++) prt__vec_store(sum[c], p.sum[c]);
    prt__vec_store(squares, p.squares);
    for (k = 0; k < count; k++) {
        out[k].r = prt__above0(sum[0][k]); out[k].g = prt__above0(sum[1][k]); out[k].b = prt__above0(sum[2][k]);
        if (!prt__finite(sum[0][k] + sum[1][k] + sum[2][k] + squares[k])) out[k] = prt__vo_shade(b, from + k);
    }
}

/* The checks and the loop of all batched forms; b holds everything but the law. */
PRT__STATIC prt_result prt__vo_shade_batch(const prt_vo_params *params, prt__vo_batch *b, int count, prt_rgb *out) {
    int k;
    if (count < 0 || b->light_count < 0) return PRT_ERR_COUNT;
    if (!params || (count > 0 && (!b->points || !b->first || !out)) || (b->light_count > 0 && !b->lights))
        return PRT_ERR_NULL;
    for (k = 0; k < count; k++) if (b->first[k] < 0 || b->first[k + 1] < b->first[k]) return PRT_ERR_COUNT;
    if (count > 0 && b->first[count] > b->first[0] && !(b->words ? (const void *)b->packed : b->occluders)) return PRT_ERR_NULL;
    if (b->words && !(b->unit > 0 && prt__finite(b->unit))) return PRT_ERR_VALUE;
    b->law = prt__vo_law_of(params);
    if (b->words == PRT__VO_WORDS_DIFFUSE) b->law.off |= PRT_VO_NO_CAUSTIC | PRT_VO_NO_DS | PRT_VO_NO_SS;
    for (k = 0; k < count; k += PRT__LANES)
        prt__vo_shade_lanes(b, k, count - k < PRT__LANES ? count - k : PRT__LANES, out + k);
    return PRT_OK;
}

PRT__STATIC prt__vo_batch prt__vo_batch_of(const prt_vo_point *points, prt_vec3 eye, const int *first, int light_count,
                                           const prt_point_light *lights) {
    prt__vo_batch b;
    memset(&b, 0, sizeof b);
    b.points = points;
    b.eye = eye;
    b.first = first;
    b.light_count = light_count;
    b.lights = lights;
    return b;
}

PRTDEF prt_result prt_vo_shade(const prt_vo_params *params, const prt_vo_point *point, prt_vec3 eye,
                               int occluder_count, const prt_vo_occluder *occluders,
                               int light_count, const prt_point_light *lights, prt_rgb *out) {
    prt__vo_batch b;
    int first[2];
    if (occluder_count < 0 || light_count < 0) return PRT_ERR_COUNT;
    if (!params || !point || !out || (occluder_count > 0 && !occluders) || (light_count > 0 && !lights)) return PRT_ERR_NULL;
    first[0] = 0; first[1] = occluder_count;
    b = prt__vo_batch_of(point, eye, first, light_count, lights);
    b.law = prt__vo_law_of(params);
    b.occluders = occluders;
    *out = prt__vo_shade(&b, 0);
    return PRT_OK;
}

PRTDEF prt_result prt_vo_shade_n(const prt_vo_params *params, int count, const prt_vo_point *points, prt_vec3 eye,
                                 const int *first, const prt_vo_occluder *occluders,
                                 int light_count, const prt_point_light *lights, prt_rgb *out) {
    prt__vo_batch b = prt__vo_batch_of(points, eye, first, light_count, lights);
    b.occluders = occluders;
    return prt__vo_shade_batch(params, &b, count, out);
}

PRT__STATIC prt_result prt__vo_pack(prt_real unit, prt_vec3 at, int count, const prt_vo_occluder *occluders, int words,
                                    uint32_t *out) {
    int k;
    if (count < 0) return PRT_ERR_COUNT;
    if (count > 0 && (!occluders || !out)) return PRT_ERR_NULL;
    if (!(unit > 0 && prt__finite(unit)) || !prt__finite3(at)) return PRT_ERR_VALUE;
    for (k = 0; k < count; k++) if (!prt__vo_pack_one((double)unit, at, &occluders[k], words, NULL)) return PRT_ERR_VALUE;
    for (k = 0; k < count; k++)
        prt__vo_pack_one((double)unit, at, &occluders[k], words, out + (size_t)k * (size_t)words);
    return PRT_OK;
}

PRT__STATIC prt_result prt__vo_unpack(prt_real unit, prt_vec3 at, int count, const uint32_t *packed, int words,
                                      prt_vo_occluder *out) {
    if (count < 0) return PRT_ERR_COUNT;
    if (count > 0 && (!packed || !out)) return PRT_ERR_NULL;
    if (!(unit > 0 && prt__finite(unit))) return PRT_ERR_VALUE;
    prt__vo_unpack_rows(unit, at, count, packed, words, out);
    return PRT_OK;
}

PRTDEF prt_result prt_vo_pack(prt_real unit, prt_vec3 position, int count, const prt_vo_occluder *occluders,
                              prt_vo_packed *out) {
    return prt__vo_pack(unit, position, count, occluders, PRT__VO_WORDS, out ? out->word : NULL);
}

PRTDEF prt_result prt_vo_pack_diffuse(prt_real unit, prt_vec3 position, int count, const prt_vo_occluder *occluders,
                                      prt_vo_packed_diffuse *out) {
    return prt__vo_pack(unit, position, count, occluders, PRT__VO_WORDS_DIFFUSE, out ? out->word : NULL);
}

PRTDEF prt_result prt_vo_unpack(prt_real unit, prt_vec3 position, int count, const prt_vo_packed *packed,
                                prt_vo_occluder *out) {
    return prt__vo_unpack(unit, position, count, packed ? packed->word : NULL, PRT__VO_WORDS, out);
}

PRTDEF prt_result prt_vo_unpack_diffuse(prt_real unit, prt_vec3 position, int count, const prt_vo_packed_diffuse *packed,
                                        prt_vo_occluder *out) {
    return prt__vo_unpack(unit, position, count, packed ? packed->word : NULL, PRT__VO_WORDS_DIFFUSE, out);
}

PRTDEF prt_result prt_vo_shade_packed_n(const prt_vo_params *params, prt_real unit, int count, const prt_vo_point *points,
                                        prt_vec3 eye, const int *first, const prt_vo_packed *packed,
                                        int light_count, const prt_point_light *lights, prt_rgb *out) {
    prt__vo_batch b = prt__vo_batch_of(points, eye, first, light_count, lights);
    b.packed = packed ? packed->word : NULL;
    b.words = PRT__VO_WORDS;
    b.unit = unit;
    return prt__vo_shade_batch(params, &b, count, out);
}

PRTDEF prt_result prt_vo_shade_packed_diffuse_n(const prt_vo_params *params, prt_real unit, int count,
                                                const prt_vo_point *points, prt_vec3 eye, const int *first,
                                                const prt_vo_packed_diffuse *packed, int light_count,
                                                const prt_point_light *lights, prt_rgb *out) {
    prt__vo_batch b = prt__vo_batch_of(points, eye, first, light_count, lights);
    b.packed = packed ? packed->word : NULL;
    b.words = PRT__VO_WORDS_DIFFUSE;
    b.unit = unit;
    return prt__vo_shade_batch(params, &b, count, out);
}

/* v turned about the unit vector `axis` by the angle of which sine and cosine are given (Rodrigues). */
PRT__STATIC prt_vec3 prt__turned(prt_vec3 v, const double axis[3], double sine, double cosine) {
    double x = (double)v.x, y = (double)v.y, z = (double)v.z;
    double rest = (1 - cosine) * (axis[0] * x + axis[1] * y + axis[2] * z);
    return prt__vec3((prt_real)(cosine * x + sine * (axis[1] * z - axis[2] * y) + rest * axis[0]),
                     (prt_real)(cosine * y + sine * (axis[2] * x - axis[0] * z) + rest * axis[1]),
                     (prt_real)(cosine * z + sine * (axis[0] * y - axis[1] * x) + rest * axis[2]));
}

/* The turn of one wave: its axis, and sine and cosine of atan(slope). 0 if the wave cannot be. */
PRT__STATIC int prt__vo_wave_turn(const prt_vo_wave *wave, prt_real time, prt_vec3 at, double axis[3], double turn[2]) {
    prt_vec3 along, across;
    double f = (double)wave->frequency, slope, length, root;
    if (!prt__unit(wave->along, &along) || !prt__unit(wave->across, &across)) return 0;
    axis[0] = (double)along.y * (double)across.z - (double)along.z * (double)across.y;
    axis[1] = (double)along.z * (double)across.x - (double)along.x * (double)across.z;
    axis[2] = (double)along.x * (double)across.y - (double)along.y * (double)across.x;
    length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    slope = f * (double)time + (double)wave->phase + (double)along.x * (double)at.x + (double)along.y * (double)at.y +
            (double)along.z * (double)at.z;
    slope = f * (double)wave->amplitude * cos(slope);
    if (!(fabs(length - 1) <= 1e-3) || !(fabs(slope) <= DBL_MAX)) return 0;
    axis[0] /= length; axis[1] /= length; axis[2] /= length;
    root = fabs(slope) < 1e150 ? sqrt(1 + slope * slope) : fabs(slope);
    turn[0] = slope / root;
    turn[1] = 1 / root;
    return 1;
}

PRTDEF prt_result prt_vo_bend(int wave_count, const prt_vo_wave *waves, prt_real time, prt_vec3 position,
                              int count, const prt_vo_occluder *occluders, prt_vo_occluder *out) {
    double axis[3], turn[2];
    int j, k;
    if (wave_count < 0 || count < 0) return PRT_ERR_COUNT;
    if ((wave_count > 0 && !waves) || (count > 0 && (!occluders || !out))) return PRT_ERR_NULL;
    for (j = 0; j < wave_count; j++) if (!prt__vo_wave_turn(&waves[j], time, position, axis, turn)) return PRT_ERR_VALUE;
    if (out != occluders && count > 0) memcpy(out, occluders, (size_t)count * sizeof *out);
    for (j = 0; j < wave_count; j++) {
        prt__vo_wave_turn(&waves[j], time, position, axis, turn);
        for (k = 0; k < count; k++) {
            out[k].occlusion = prt__turned(out[k].occlusion, axis, turn[0], turn[1]);
            out[k].caustic = prt__turned(out[k].caustic, axis, turn[0], turn[1]);
        }
    }
    return PRT_OK;
}

/* --------------------------------------------------------------------------------------------- >>reference ---- */

/* Textbook associated Legendre function P_l^m(z) without phase; s = sqrt(1-z^2) */
PRT__STATIC double prt__legendre(int l, int m, double z, double s) {
    double before = 0, p = 1;
    int k;
    for (k = 1; k <= m; k++) p *= (2 * k - 1) * s;
    for (k = m + 1; k <= l; k++) {
        double next = ((2 * k - 1) * z * p - (k + m - 1) * before) / (k - m);
        before = p;
        p = next;
    }
    return p;
}

PRTDEF double prt_reference_sh(int l, int m, double x, double y, double z) {
    double length = sqrt(x * x + y * y + z * z), phi = atan2(y, x), k2 = (2 * l + 1) / (4 * PRT__PI), value;
    int a = m < 0 ? -m : m, k;
    if (l < 0 || l > PRT_REFERENCE_MAX_L || a > l || !(length > 0)) return 0;
    for (k = l - a + 1; k <= l + a; k++) k2 /= k;              /* (l-|m|)!/(l+|m|)! */
    value = sqrt(k2) * prt__legendre(l, a, z / length, sqrt(x * x + y * y) / length);
    if (m == 0) return value;
    return value * 1.41421356237309504880 * (m > 0 ? cos(a * phi) : sin(a * phi));
}

PRTDEF prt_result prt_reference_project(int bands, int nodes, prt_function *f, void *user, prt_real *out) {
    double sum[PRT_SH_COUNT(PRT_MAX_BANDS)];
    prt_real y[PRT_SH_COUNT(PRT_MAX_BANDS)];
    int i, j, c;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (nodes < 1 || nodes > 4096) return PRT_ERR_COUNT;
    if (!f || !out) return PRT_ERR_NULL;
    memset(sum, 0, sizeof sum);
    for (i = 0; i < nodes; i++) {
        double z, weight, s;
        prt__gauss_legendre(nodes, i, &z, &weight);
        s = sqrt((1 - z) * (1 + z));
        for (j = 0; j < 2 * nodes; j++) {
            double phi = PRT__PI * (j + 0.5) / nodes, value;
            prt_vec3 d = prt__vec3((prt_real)(s * cos(phi)), (prt_real)(s * sin(phi)), (prt_real)z);
            value = f(user, d) * weight * PRT__PI / nodes;
            prt__sh_eval(bands, d, y);
            for (c = 0; c < PRT_SH_COUNT(bands); c++) sum[c] += value * (double)y[c];
        }
    }
    for (c = 0; c < PRT_SH_COUNT(bands); c++) out[c] = (prt_real)sum[c];
    return PRT_OK;
}

/* --------------------------------------------------------------------------------------------- >>generated ---- */

/* BEGIN GENERATED: prt_codegen --table roots --count 128 */
/* sqrt(k) for k = 0 ... 127 */
PRT__STATIC const double *prt__roots(void) {
    static const double table[128] = {
        0.0, 1.0, 1.4142135623730950488, 1.7320508075688772935, 2.0, 2.2360679774997896964, 2.4494897427831780982,
        2.6457513110645905905, 2.8284271247461900976, 3.0, 3.162277660168379332, 3.3166247903553998491,
        3.4641016151377545871, 3.6055512754639892931, 3.7416573867739413856, 3.8729833462074168852,
        4.0, 4.1231056256176605498, 4.2426406871192851464, 4.3588989435406735522, 4.4721359549995793928,
        4.5825756949558400066, 4.6904157598234295546, 4.7958315233127195416, 4.8989794855663561964,
        5.0, 5.09901951359278483, 5.1961524227066318806, 5.291502622129181181, 5.3851648071345040313,
        5.4772255750516611346, 5.5677643628300219221, 5.6568542494923801952, 5.7445626465380286599,
        5.8309518948453004709, 5.9160797830996160426, 6.0, 6.082762530298219689, 6.1644140029689764503,
        6.2449979983983982058, 6.324555320336758664, 6.4031242374328486865, 6.480740698407860231,
        6.5574385243020006523, 6.6332495807107996982, 6.7082039324993690892, 6.7823299831252681391,
        6.8556546004010441249, 6.9282032302755091741, 7.0, 7.071067811865475244, 7.141428428542849998,
        7.2111025509279785862, 7.2801098892805182711, 7.3484692283495342946, 7.4161984870956629487,
        7.4833147735478827712, 7.5498344352707496972, 7.6157731058639082857, 7.6811457478686081758,
        7.7459666924148337704, 7.8102496759066543941, 7.8740078740118110197, 7.9372539331937717715,
        8.0, 8.0622577482985496524, 8.1240384046359603605, 8.18535277187244997, 8.2462112512353210996,
        8.3066238629180748526, 8.3666002653407554798, 8.4261497731763586306, 8.4852813742385702928,
        8.5440037453175311679, 8.6023252670426267717, 8.6602540378443864676, 8.7177978870813471045,
        8.7749643873921220604, 8.8317608663278468548, 8.8881944173155888501, 8.9442719099991587856,
        9.0, 9.0553851381374166266, 9.1104335791442988819, 9.1651513899116800132, 9.21954445729288731,
        9.2736184954957037525, 9.3273790530888150456, 9.3808315196468591091, 9.4339811320566038113,
        9.486832980505137996, 9.5393920141694564915, 9.5916630466254390832, 9.6436507609929549958,
        9.6953597148326580281, 9.7467943448089639068, 9.7979589711327123928, 9.8488578017961047217,
        9.8994949366116653416, 9.9498743710661995473, 10.0, 10.04987562112089027, 10.099504938362077953,
        10.148891565092219469, 10.19803902718556966, 10.246950765959598383, 10.295630140987000316,
        10.34408043278860047, 10.392304845413263761, 10.44030650891055018, 10.48808848170151547,
        10.535653752852738848, 10.583005244258362362, 10.630145812734649408, 10.677078252031311211,
        10.723805294763608305, 10.770329614269008063, 10.816653826391967879, 10.862780491200215724,
        10.908712114635714412, 10.954451150103322269, 11.0, 11.045361017187260774, 11.090536506409417162,
        11.135528725660043844, 11.180339887498948482, 11.224972160321824157, 11.269427669584644883
    };
    return table;
}

/* 1/sqrt(k), and 0 for k = 0 ... 127 */
PRT__STATIC const double *prt__inverse_roots(void) {
    static const double table[128] = {
        0.0, 1.0, 0.7071067811865475244, 0.57735026918962576451, 0.5, 0.44721359549995793928,
        0.40824829046386301637, 0.37796447300922722721, 0.3535533905932737622, 0.33333333333333333333,
        0.3162277660168379332, 0.30151134457776362265, 0.28867513459481288225, 0.27735009811261456101,
        0.26726124191242438468, 0.25819888974716112568, 0.25, 0.24253562503633297352, 0.23570226039551584147,
        0.22941573387056176591, 0.22360679774997896964, 0.21821789023599238127, 0.2132007163556104343,
        0.20851441405707476268, 0.20412414523193150818, 0.2, 0.19611613513818403192, 0.19245008972987525484,
        0.18898223650461361361, 0.18569533817705186315, 0.18257418583505537115, 0.17960530202677490071,
        0.1767766952966368811, 0.17407765595569783818, 0.17149858514250883738, 0.1690308509457033155,
        0.16666666666666666667, 0.16439898730535728889, 0.16222142113076253816, 0.16012815380508713348,
        0.1581138830084189666, 0.15617376188860606552, 0.15430334996209191026, 0.15249857033260466633,
        0.15075567228888181132, 0.14907119849998597976, 0.14744195615489713346, 0.14586499149789455585,
        0.14433756729740644113, 0.14285714285714285714, 0.14142135623730950488, 0.14002800840280098035,
        0.1386750490563072805, 0.13736056394868902398, 0.13608276348795433879, 0.13483997249264841725,
        0.13363062095621219234, 0.13245323570650438065, 0.13130643285972255665, 0.13018891098082386739,
        0.12909944487358056284, 0.12803687993289597367, 0.12700012700019050032, 0.12598815766974240907,
        0.125, 0.12403473458920845619, 0.12309149097933273273, 0.12216944435630522343, 0.12126781251816648676,
        0.12038585308576920076, 0.119522860933439364, 0.11867816581938533283, 0.11785113019775792073,
        0.11704114719613056394, 0.1162476387438192807, 0.1154700538379251529, 0.11470786693528088295,
        0.11396057645963794884, 0.11322770341445957506, 0.11250879009260239051, 0.11180339887498948482,
        0.11111111111111111111, 0.11043152607484654423, 0.10976425998969034798, 0.10910894511799619063,
        0.108465228909328086, 0.10783277320343841573, 0.10721125348377948328, 0.10660035817780521715,
        0.10599978800063599788, 0.10540925533894597773, 0.10482848367219182958, 0.10425720702853738134,
        0.10369516947304252684, 0.10314212462587934072, 0.10259783520851540955, 0.10206207261596575409,
        0.10153461651336190435, 0.10101525445522107491, 0.10050378152592120755, 0.1, 0.099503719020998913567,
        0.099014754297667430915, 0.09853292781642931523, 0.098058067569092015962, 0.097590007294853317935,
        0.097128586235726418074, 0.09667364890456635953, 0.096225044864937627418, 0.095782628522115139264,
        0.095346258924559231545, 0.094915799575249899535, 0.094491118252306806804, 0.094072086838359729274,
        0.093658581158169396586, 0.093250480824031376564, 0.092847669088525931573, 0.09245003270420485367,
        0.092057461789832336643, 0.091669849702821129508, 0.091287092917527685576, 0.090909090909090909091,
        0.090535746042518530936, 0.09016696346674322896, 0.089802651013387450357, 0.089442719099991587856,
        0.089087080637474794895, 0.08873565094161137703
    };
    return table;
}

/* END GENERATED */

/* BEGIN GENERATED: prt_codegen --lang c --emit sh_eval,sh_at --bands 1-10 */
/* SH basis, 1 band: 0 multiplications, 0 additions (0 can fuse), 1 stores */
PRT__STATIC void prt__sh_eval_1(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    (void)x;
    (void)y;
    (void)z;
    out[0] = PRT__R(0.282094791773878143474);
}

/* SH basis, 1 band: 0 multiplications, 0 additions (0 can fuse), 1 stores */
PRT__STATIC void prt__sh_eval_1_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    (void)xs;
    (void)ys;
    (void)zs;
    (void)stride;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
    }
}

/* SH basis, 2 bands: 3 multiplications, 0 additions (0 can fuse), 4 stores */
PRT__STATIC void prt__sh_eval_2(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
}

/* SH basis, 2 bands: 3 multiplications, 0 additions (0 can fuse), 4 stores */
PRT__STATIC void prt__sh_eval_2_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
}

/* SH basis, 3 bands: 12 multiplications, 4 additions (1 can fuse), 9 stores */
PRT__STATIC void prt__sh_eval_3(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    out[6] = PRT__R(0.946174695757560018093) * (z * z) - PRT__R(0.315391565252520006031);
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t1 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t1;
    out[7] = x * t1;
    const prt_real t2 = y * x;
    out[4] = PRT__R(0.546274215296039535272) * (t2 + t2);
    out[8] = PRT__R(0.546274215296039535272) * ((y + x) * (x - y));
}

/* SH basis, 3 bands: 12 multiplications, 4 additions (1 can fuse), 9 stores */
PRT__STATIC void prt__sh_eval_3_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        prt__vec_store(out + 6 * stride, PRT__R(0.946174695757560018093) * (z * z) - PRT__R(0.315391565252520006031));
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t2 + t2));
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * ((y + x) * (x - y)));
    }
}

/* SH basis, 4 bands: 25 multiplications, 11 additions (3 can fuse), 16 stores */
PRT__STATIC void prt__sh_eval_4(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    out[6] = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
    const prt_real t2 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
    out[12] = z * t2;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t3 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t3;
    out[7] = x * t3;
    const prt_real t4 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
    out[11] = y * t4;
    out[13] = x * t4;
    const prt_real t5 = y * x;
    const prt_real t6 = t5 + t5;
    out[4] = PRT__R(0.546274215296039535272) * t6;
    const prt_real t7 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t7;
    const prt_real t8 = PRT__R(1.44530572132027702769) * z;
    out[10] = t6 * t8;
    out[14] = t7 * t8;
    const prt_real t9 = y * y;
    const prt_real t10 = t7 + t9;
    out[9] = PRT__R(0.590043589926643510346) * (y * (t7 + (t10 + t10)));
    out[15] = PRT__R(0.590043589926643510346) * (x * (t7 - (t9 + t9)));
}

/* SH basis, 4 bands: 25 multiplications, 11 additions (3 can fuse), 16 stores */
PRT__STATIC void prt__sh_eval_4_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        prt__vec_store(out + 6 * stride, PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031));
        const prt__vec t2 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        prt__vec_store(out + 12 * stride, z * t2);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t3 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t3);
        prt__vec_store(out + 7 * stride, x * t3);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(2.28522899732232868079) * (z * z) - PRT__R(0.457045799464465736158);
        prt__vec_store(out + 11 * stride, y * t1);
        prt__vec_store(out + 13 * stride, x * t1);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t3);
        const prt__vec t4 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t4);
        const prt__vec t5 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t3 * t5);
        prt__vec_store(out + 14 * stride, t4 * t5);
        const prt__vec t6 = y * y;
        const prt__vec t7 = t4 + t6;
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * (y * (t4 + (t7 + t7))));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * (x * (t4 - (t6 + t6))));
    }
}

/* SH basis, 5 bands: 41 multiplications, 18 additions (7 can fuse), 25 stores */
PRT__STATIC void prt__sh_eval_5(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
    out[12] = z * t3;
    const prt_real t4 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
    out[20] = t2 * t4 - PRT__R(0.329110590402857834053);
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t5 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t5;
    out[7] = x * t5;
    const prt_real t6 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
    out[11] = y * t6;
    out[13] = x * t6;
    const prt_real t7 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
    const prt_real t8 = z * t7;
    out[19] = y * t8;
    out[21] = x * t8;
    const prt_real t9 = y * x;
    const prt_real t10 = t9 + t9;
    out[4] = PRT__R(0.546274215296039535272) * t10;
    const prt_real t11 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t11;
    const prt_real t12 = PRT__R(1.44530572132027702769) * z;
    out[10] = t10 * t12;
    out[14] = t11 * t12;
    const prt_real t13 = PRT__R(3.31161143515146006332) * t1 - PRT__R(0.473087347878780009046);
    out[18] = t10 * t13;
    out[22] = t11 * t13;
    const prt_real t14 = y * y;
    const prt_real t15 = t11 + t14;
    const prt_real t16 = y * (t11 + (t15 + t15));
    out[9] = PRT__R(0.590043589926643510346) * t16;
    const prt_real t17 = x * (t11 - (t14 + t14));
    out[15] = PRT__R(0.590043589926643510346) * t17;
    const prt_real t18 = PRT__R(1.77013076977993053104) * z;
    out[17] = t16 * t18;
    out[23] = t17 * t18;
    const prt_real t19 = t11 * t10;
    out[16] = PRT__R(0.625835735449176134587) * (t19 + t19);
    out[24] = PRT__R(0.625835735449176134587) * ((t11 + t10) * (t11 - t10));
}

/* SH basis, 5 bands: 41 multiplications, 18 additions (7 can fuse), 25 stores */
PRT__STATIC void prt__sh_eval_5_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        prt__vec_store(out + 12 * stride, z * t3);
        const prt__vec t4 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        prt__vec_store(out + 20 * stride, t2 * t4 - PRT__R(0.329110590402857834053));
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
        const prt__vec t5 = z * t4;
        prt__vec_store(out + 19 * stride, y * t5);
        prt__vec_store(out + 21 * stride, x * t5);
        const prt__vec t6 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t6 + t6));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t1);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t3 * t4);
        prt__vec_store(out + 14 * stride, t1 * t4);
        const prt__vec t5 = PRT__R(3.31161143515146006332) * (z * z) - PRT__R(0.473087347878780009046);
        prt__vec_store(out + 18 * stride, t3 * t5);
        prt__vec_store(out + 22 * stride, t1 * t5);
        const prt__vec t6 = y * y;
        const prt__vec t7 = t1 + t6;
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * (y * (t1 + (t7 + t7))));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * (x * (t1 - (t6 + t6))));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, (y * (t1 + (t3 + t3))) * t4);
        prt__vec_store(out + 23 * stride, (x * (t1 - (t2 + t2))) * t4);
        const prt__vec t5 = y * x;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = t1 * t6;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * (t7 + t7));
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * ((t1 + t6) * (t1 - t6)));
    }
}

/* SH basis, 6 bands: 64 multiplications, 25 additions (14 can fuse), 36 stores */
PRT__STATIC void prt__sh_eval_6(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
    const prt_real t6 = t2 * t5 - PRT__R(0.329110590402857834053);
    out[20] = t6;
    out[30] = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t7 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t7;
    out[7] = x * t7;
    const prt_real t8 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
    out[11] = y * t8;
    out[13] = x * t8;
    const prt_real t9 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
    const prt_real t10 = z * t9;
    out[19] = y * t10;
    out[21] = x * t10;
    const prt_real t11 = PRT__R(1.82140655598655998134) * t8 - PRT__R(1.10995495404092863574);
    const prt_real t12 = t8 * t11 - PRT__R(0.434828785147869044447);
    out[29] = y * t12;
    out[31] = x * t12;
    const prt_real t13 = y * x;
    const prt_real t14 = t13 + t13;
    out[4] = PRT__R(0.546274215296039535272) * t14;
    const prt_real t15 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t15;
    const prt_real t16 = PRT__R(1.44530572132027702769) * z;
    out[10] = t14 * t16;
    out[14] = t15 * t16;
    const prt_real t17 = PRT__R(3.31161143515146006332) * t1 - PRT__R(0.473087347878780009046);
    out[18] = t14 * t17;
    out[22] = t15 * t17;
    const prt_real t18 = PRT__R(7.1903051774599856325) * t1 - PRT__R(2.3967683924866618775);
    const prt_real t19 = z * t18;
    out[28] = t14 * t19;
    out[32] = t15 * t19;
    const prt_real t20 = y * y;
    const prt_real t21 = t15 + t20;
    const prt_real t22 = y * (t15 + (t21 + t21));
    out[9] = PRT__R(0.590043589926643510346) * t22;
    const prt_real t23 = x * (t15 - (t20 + t20));
    out[15] = PRT__R(0.590043589926643510346) * t23;
    const prt_real t24 = PRT__R(1.77013076977993053104) * z;
    out[17] = t22 * t24;
    out[23] = t23 * t24;
    const prt_real t25 = PRT__R(4.40314469491725348916) * t1 - PRT__R(0.489238299435250387684);
    out[27] = t22 * t25;
    out[33] = t23 * t25;
    const prt_real t26 = t15 * t14;
    const prt_real t27 = t26 + t26;
    out[16] = PRT__R(0.625835735449176134587) * t27;
    const prt_real t28 = (t15 + t14) * (t15 - t14);
    out[24] = PRT__R(0.625835735449176134587) * t28;
    const prt_real t29 = PRT__R(2.075662314881041279) * z;
    out[26] = t27 * t29;
    out[34] = t28 * t29;
    out[25] = PRT__R(0.656382056840170102814) * (y * t28 + x * t27);
    out[35] = PRT__R(0.656382056840170102814) * (x * t28 - y * t27);
}

/* SH basis, 6 bands: 64 multiplications, 25 additions (14 can fuse), 36 stores */
PRT__STATIC void prt__sh_eval_6_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        const prt__vec t6 = t2 * t5 - PRT__R(0.329110590402857834053);
        prt__vec_store(out + 20 * stride, t6);
        prt__vec_store(out + 30 * stride, PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
        const prt__vec t5 = z * t4;
        prt__vec_store(out + 19 * stride, y * t5);
        prt__vec_store(out + 21 * stride, x * t5);
        const prt__vec t6 = PRT__R(1.82140655598655998134) * t3 - PRT__R(1.10995495404092863574);
        const prt__vec t7 = t3 * t6 - PRT__R(0.434828785147869044447);
        prt__vec_store(out + 29 * stride, y * t7);
        prt__vec_store(out + 31 * stride, x * t7);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t2);
        const prt__vec t3 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t3);
        const prt__vec t4 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t2 * t4);
        prt__vec_store(out + 14 * stride, t3 * t4);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(3.31161143515146006332) * t5 - PRT__R(0.473087347878780009046);
        prt__vec_store(out + 18 * stride, t2 * t6);
        prt__vec_store(out + 22 * stride, t3 * t6);
        const prt__vec t7 = PRT__R(7.1903051774599856325) * t5 - PRT__R(2.3967683924866618775);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 28 * stride, t2 * t8);
        prt__vec_store(out + 32 * stride, t3 * t8);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = y * (t1 + (t3 + t3));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t4);
        const prt__vec t5 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t5);
        const prt__vec t6 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t4 * t6);
        prt__vec_store(out + 23 * stride, t5 * t6);
        const prt__vec t7 = PRT__R(4.40314469491725348916) * (z * z) - PRT__R(0.489238299435250387684);
        prt__vec_store(out + 27 * stride, t4 * t7);
        prt__vec_store(out + 33 * stride, t5 * t7);
        const prt__vec t8 = y * x;
        const prt__vec t9 = t8 + t8;
        const prt__vec t10 = t1 * t9;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * (t10 + t10));
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * ((t1 + t9) * (t1 - t9)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = t1 * t3;
        const prt__vec t5 = t4 + t4;
        const prt__vec t6 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t5 * t6);
        const prt__vec t7 = (t1 + t3) * (t1 - t3);
        prt__vec_store(out + 34 * stride, t7 * t6);
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * (y * t7 + x * t5));
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * (x * t7 - y * t5));
    }
}

/* SH basis, 7 bands: 90 multiplications, 34 additions (20 can fuse), 49 stores */
PRT__STATIC void prt__sh_eval_7(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
    const prt_real t6 = t2 * t5 - PRT__R(0.329110590402857834053);
    out[20] = t6;
    const prt_real t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
    out[30] = t7;
    out[42] = PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t8 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t8;
    out[7] = x * t8;
    const prt_real t9 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
    out[11] = y * t9;
    out[13] = x * t9;
    const prt_real t10 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
    const prt_real t11 = z * t10;
    out[19] = y * t11;
    out[21] = x * t11;
    const prt_real t12 = PRT__R(1.82140655598655998134) * t9 - PRT__R(1.10995495404092863574);
    const prt_real t13 = t9 * t12 - PRT__R(0.434828785147869044447);
    out[29] = y * t13;
    out[31] = x * t13;
    const prt_real t14 = PRT__R(2.02131498923702777609) * (z * t13) - PRT__R(0.995226703056238577025) * t11;
    out[41] = y * t14;
    out[43] = x * t14;
    const prt_real t15 = y * x;
    const prt_real t16 = t15 + t15;
    out[4] = PRT__R(0.546274215296039535272) * t16;
    const prt_real t17 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t17;
    const prt_real t18 = PRT__R(1.44530572132027702769) * z;
    out[10] = t16 * t18;
    out[14] = t17 * t18;
    const prt_real t19 = PRT__R(3.31161143515146006332) * t1 - PRT__R(0.473087347878780009046);
    out[18] = t16 * t19;
    out[22] = t17 * t19;
    const prt_real t20 = PRT__R(7.1903051774599856325) * t1 - PRT__R(2.3967683924866618775);
    const prt_real t21 = z * t20;
    out[28] = t16 * t21;
    out[32] = t17 * t21;
    const prt_real t22 = PRT__R(1.38599481613688115647) * t19 - PRT__R(1.19217565770897169497);
    const prt_real t23 = t19 * t22 - PRT__R(0.413602361414863611859);
    out[40] = t16 * t23;
    out[44] = t17 * t23;
    const prt_real t24 = y * y;
    const prt_real t25 = t17 + t24;
    const prt_real t26 = y * (t17 + (t25 + t25));
    out[9] = PRT__R(0.590043589926643510346) * t26;
    const prt_real t27 = x * (t17 - (t24 + t24));
    out[15] = PRT__R(0.590043589926643510346) * t27;
    const prt_real t28 = PRT__R(1.77013076977993053104) * z;
    out[17] = t26 * t28;
    out[23] = t27 * t28;
    const prt_real t29 = PRT__R(4.40314469491725348916) * t1 - PRT__R(0.489238299435250387684);
    out[27] = t26 * t29;
    out[33] = t27 * t29;
    const prt_real t30 = PRT__R(10.1332578546641584906) * t1 - PRT__R(2.76361577854477049742);
    const prt_real t31 = z * t30;
    out[39] = t26 * t31;
    out[45] = t27 * t31;
    const prt_real t32 = t17 * t16;
    const prt_real t33 = t32 + t32;
    out[16] = PRT__R(0.625835735449176134587) * t33;
    const prt_real t34 = (t17 + t16) * (t17 - t16);
    out[24] = PRT__R(0.625835735449176134587) * t34;
    const prt_real t35 = PRT__R(2.075662314881041279) * z;
    out[26] = t33 * t35;
    out[34] = t34 * t35;
    const prt_real t36 = PRT__R(5.5502139080159657518) * t1 - PRT__R(0.504564900728724159254);
    out[38] = t33 * t36;
    out[46] = t34 * t36;
    const prt_real t37 = y * t34 + x * t33;
    out[25] = PRT__R(0.656382056840170102814) * t37;
    const prt_real t38 = x * t34 - y * t33;
    out[35] = PRT__R(0.656382056840170102814) * t38;
    const prt_real t39 = PRT__R(2.36661916223175203199) * z;
    out[37] = t37 * t39;
    out[47] = t38 * t39;
    const prt_real t40 = t27 * t26;
    out[36] = PRT__R(0.683184105191914321975) * (t40 + t40);
    out[48] = PRT__R(0.683184105191914321975) * ((t27 + t26) * (t27 - t26));
}

/* SH basis, 7 bands: 90 multiplications, 34 additions (20 can fuse), 49 stores */
PRT__STATIC void prt__sh_eval_7_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        const prt__vec t6 = t2 * t5 - PRT__R(0.329110590402857834053);
        prt__vec_store(out + 20 * stride, t6);
        const prt__vec t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
        prt__vec_store(out + 30 * stride, t7);
        prt__vec_store(out + 42 * stride, PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
        prt__vec_store(out + 19 * stride, y * (z * t4));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
        const prt__vec t3 = z * t2;
        prt__vec_store(out + 21 * stride, x * t3);
        const prt__vec t4 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        const prt__vec t5 = PRT__R(1.82140655598655998134) * t4 - PRT__R(1.10995495404092863574);
        const prt__vec t6 = t4 * t5 - PRT__R(0.434828785147869044447);
        prt__vec_store(out + 29 * stride, y * t6);
        prt__vec_store(out + 31 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.02131498923702777609) * (z * t6) - PRT__R(0.995226703056238577025) * t3;
        prt__vec_store(out + 41 * stride, y * t7);
        prt__vec_store(out + 43 * stride, x * t7);
        const prt__vec t8 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t8 + t8));
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * ((y + x) * (x - y)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t2 * t3);
        const prt__vec t4 = (y + x) * (x - y);
        prt__vec_store(out + 14 * stride, t4 * t3);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(3.31161143515146006332) * t5 - PRT__R(0.473087347878780009046);
        prt__vec_store(out + 18 * stride, t2 * t6);
        prt__vec_store(out + 22 * stride, t4 * t6);
        const prt__vec t7 = PRT__R(7.1903051774599856325) * t5 - PRT__R(2.3967683924866618775);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 28 * stride, t2 * t8);
        prt__vec_store(out + 32 * stride, t4 * t8);
        const prt__vec t9 = PRT__R(1.38599481613688115647) * t6 - PRT__R(1.19217565770897169497);
        prt__vec_store(out + 40 * stride, t2 * (t6 * t9 - PRT__R(0.413602361414863611859)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
        const prt__vec t4 = PRT__R(1.38599481613688115647) * t3 - PRT__R(1.19217565770897169497);
        prt__vec_store(out + 44 * stride, t1 * (t3 * t4 - PRT__R(0.413602361414863611859)));
        const prt__vec t5 = y * y;
        const prt__vec t6 = t1 + t5;
        const prt__vec t7 = y * (t1 + (t6 + t6));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t7);
        const prt__vec t8 = x * (t1 - (t5 + t5));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t8);
        const prt__vec t9 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t7 * t9);
        prt__vec_store(out + 23 * stride, t8 * t9);
        const prt__vec t10 = PRT__R(4.40314469491725348916) * t2 - PRT__R(0.489238299435250387684);
        prt__vec_store(out + 27 * stride, t7 * t10);
        prt__vec_store(out + 33 * stride, t8 * t10);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = z * z;
        const prt__vec t5 = PRT__R(10.1332578546641584906) * t4 - PRT__R(2.76361577854477049742);
        const prt__vec t6 = z * t5;
        prt__vec_store(out + 39 * stride, (y * (t1 + (t3 + t3))) * t6);
        prt__vec_store(out + 45 * stride, (x * (t1 - (t2 + t2))) * t6);
        const prt__vec t7 = y * x;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = t1 * t8;
        const prt__vec t10 = t9 + t9;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t10);
        const prt__vec t11 = (t1 + t8) * (t1 - t8);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t11);
        const prt__vec t12 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t10 * t12);
        prt__vec_store(out + 34 * stride, t11 * t12);
        const prt__vec t13 = PRT__R(5.5502139080159657518) * t4 - PRT__R(0.504564900728724159254);
        prt__vec_store(out + 38 * stride, t10 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = PRT__R(5.5502139080159657518) * (z * z) - PRT__R(0.504564900728724159254);
        prt__vec_store(out + 46 * stride, t4 * t5);
        const prt__vec t6 = t1 * t3;
        const prt__vec t7 = t6 + t6;
        const prt__vec t8 = y * t4 + x * t7;
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * t8);
        const prt__vec t9 = x * t4 - y * t7;
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * t9);
        const prt__vec t10 = PRT__R(2.36661916223175203199) * z;
        prt__vec_store(out + 37 * stride, t8 * t10);
        prt__vec_store(out + 47 * stride, t9 * t10);
        const prt__vec t11 = y * y;
        const prt__vec t12 = x * (t1 - (t11 + t11));
        const prt__vec t13 = t1 + t11;
        const prt__vec t14 = y * (t1 + (t13 + t13));
        const prt__vec t15 = t12 * t14;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * (t15 + t15));
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * ((t12 + t14) * (t12 - t14)));
    }
}

/* SH basis, 8 bands: 123 multiplications, 43 additions (29 can fuse), 64 stores */
PRT__STATIC void prt__sh_eval_8(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
    const prt_real t6 = t2 * t5 - PRT__R(0.329110590402857834053);
    out[20] = t6;
    const prt_real t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
    out[30] = t7;
    const prt_real t8 = PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6;
    out[42] = t8;
    out[56] = PRT__R(1.99489143482413445284) * (z * t8) - PRT__R(1.00092721392195810546) * t7;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t9 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t9;
    out[7] = x * t9;
    const prt_real t10 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
    out[11] = y * t10;
    out[13] = x * t10;
    const prt_real t11 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
    const prt_real t12 = z * t11;
    out[19] = y * t12;
    out[21] = x * t12;
    const prt_real t13 = PRT__R(1.82140655598655998134) * t10 - PRT__R(1.10995495404092863574);
    const prt_real t14 = t10 * t13 - PRT__R(0.434828785147869044447);
    out[29] = y * t14;
    out[31] = x * t14;
    const prt_real t15 = PRT__R(2.02131498923702777609) * (z * t14) - PRT__R(0.995226703056238577025) * t12;
    out[41] = y * t15;
    out[43] = x * t15;
    const prt_real t16 = PRT__R(2.01556443707463741309) * (z * t15) - PRT__R(0.997155044021832052319) * t14;
    out[55] = y * t16;
    out[57] = x * t16;
    const prt_real t17 = y * x;
    const prt_real t18 = t17 + t17;
    out[4] = PRT__R(0.546274215296039535272) * t18;
    const prt_real t19 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t19;
    const prt_real t20 = PRT__R(1.44530572132027702769) * z;
    out[10] = t18 * t20;
    out[14] = t19 * t20;
    const prt_real t21 = PRT__R(3.31161143515146006332) * t1 - PRT__R(0.473087347878780009046);
    out[18] = t18 * t21;
    out[22] = t19 * t21;
    const prt_real t22 = PRT__R(7.1903051774599856325) * t1 - PRT__R(2.3967683924866618775);
    const prt_real t23 = z * t22;
    out[28] = t18 * t23;
    out[32] = t19 * t23;
    const prt_real t24 = PRT__R(1.38599481613688115647) * t21 - PRT__R(1.19217565770897169497);
    const prt_real t25 = t21 * t24 - PRT__R(0.413602361414863611859);
    out[40] = t18 * t25;
    out[44] = t19 * t25;
    const prt_real t26 = PRT__R(2.08166599946613273528) * (z * t25) - PRT__R(0.984731927834661861874) * t23;
    out[54] = t18 * t26;
    out[58] = t19 * t26;
    const prt_real t27 = y * y;
    const prt_real t28 = t19 + t27;
    const prt_real t29 = y * (t19 + (t28 + t28));
    out[9] = PRT__R(0.590043589926643510346) * t29;
    const prt_real t30 = x * (t19 - (t27 + t27));
    out[15] = PRT__R(0.590043589926643510346) * t30;
    const prt_real t31 = PRT__R(1.77013076977993053104) * z;
    out[17] = t29 * t31;
    out[23] = t30 * t31;
    const prt_real t32 = PRT__R(4.40314469491725348916) * t1 - PRT__R(0.489238299435250387684);
    out[27] = t29 * t32;
    out[33] = t30 * t32;
    const prt_real t33 = PRT__R(10.1332578546641584906) * t1 - PRT__R(2.76361577854477049742);
    const prt_real t34 = z * t33;
    out[39] = t29 * t34;
    out[45] = t30 * t34;
    const prt_real t35 = PRT__R(1.15401243699174093424) * t32 - PRT__R(1.21603371550977803267);
    const prt_real t36 = t32 * t35 - PRT__R(0.401771089424162456772);
    out[53] = t29 * t36;
    out[59] = t30 * t36;
    const prt_real t37 = t19 * t18;
    const prt_real t38 = t37 + t37;
    out[16] = PRT__R(0.625835735449176134587) * t38;
    const prt_real t39 = (t19 + t18) * (t19 - t18);
    out[24] = PRT__R(0.625835735449176134587) * t39;
    const prt_real t40 = PRT__R(2.075662314881041279) * z;
    out[26] = t38 * t40;
    out[34] = t39 * t40;
    const prt_real t41 = PRT__R(5.5502139080159657518) * t1 - PRT__R(0.504564900728724159254);
    out[38] = t38 * t41;
    out[46] = t39 * t41;
    const prt_real t42 = PRT__R(13.4918050467267683135) * t1 - PRT__R(3.11349347232156191849);
    const prt_real t43 = z * t42;
    out[52] = t38 * t43;
    out[60] = t39 * t43;
    const prt_real t44 = y * t39 + x * t38;
    out[25] = PRT__R(0.656382056840170102814) * t44;
    const prt_real t45 = x * t39 - y * t38;
    out[35] = PRT__R(0.656382056840170102814) * t45;
    const prt_real t46 = PRT__R(2.36661916223175203199) * z;
    out[37] = t44 * t46;
    out[47] = t45 * t46;
    const prt_real t47 = PRT__R(6.74590252336338415674) * t1 - PRT__R(0.518915578720260319749);
    out[51] = t44 * t47;
    out[61] = t45 * t47;
    const prt_real t48 = t30 * t29;
    const prt_real t49 = t48 + t48;
    out[36] = PRT__R(0.683184105191914321975) * t49;
    const prt_real t50 = (t30 + t29) * (t30 - t29);
    out[48] = PRT__R(0.683184105191914321975) * t50;
    const prt_real t51 = PRT__R(2.64596066180190022197) * z;
    out[50] = t49 * t51;
    out[62] = t50 * t51;
    out[49] = PRT__R(0.707162732524596178226) * (y * t50 + x * t49);
    out[63] = PRT__R(0.707162732524596178226) * (x * t50 - y * t49);
}

/* SH basis, 8 bands: 123 multiplications, 43 additions (29 can fuse), 64 stores */
PRT__STATIC void prt__sh_eval_8_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        const prt__vec t6 = t2 * t5 - PRT__R(0.329110590402857834053);
        prt__vec_store(out + 20 * stride, t6);
        const prt__vec t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
        prt__vec_store(out + 30 * stride, t7);
        const prt__vec t8 = PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6;
        prt__vec_store(out + 42 * stride, t8);
        prt__vec_store(out + 56 * stride, PRT__R(1.99489143482413445284) * (z * t8) - PRT__R(1.00092721392195810546) * t7);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
        const prt__vec t5 = z * t4;
        prt__vec_store(out + 19 * stride, y * t5);
        prt__vec_store(out + 21 * stride, x * t5);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        const prt__vec t3 = PRT__R(1.82140655598655998134) * t2 - PRT__R(1.10995495404092863574);
        const prt__vec t4 = t2 * t3 - PRT__R(0.434828785147869044447);
        prt__vec_store(out + 29 * stride, y * t4);
        prt__vec_store(out + 31 * stride, x * t4);
        const prt__vec t5 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
        const prt__vec t6 = PRT__R(2.02131498923702777609) * (z * t4) - PRT__R(0.995226703056238577025) * (z * t5);
        prt__vec_store(out + 41 * stride, y * t6);
        prt__vec_store(out + 43 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.01556443707463741309) * (z * t6) - PRT__R(0.997155044021832052319) * t4;
        prt__vec_store(out + 55 * stride, y * t7);
        prt__vec_store(out + 57 * stride, x * t7);
        const prt__vec t8 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t8 + t8));
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * ((y + x) * (x - y)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t2 * t3);
        const prt__vec t4 = (y + x) * (x - y);
        prt__vec_store(out + 14 * stride, t4 * t3);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(3.31161143515146006332) * t5 - PRT__R(0.473087347878780009046);
        prt__vec_store(out + 18 * stride, t2 * t6);
        prt__vec_store(out + 22 * stride, t4 * t6);
        const prt__vec t7 = PRT__R(7.1903051774599856325) * t5 - PRT__R(2.3967683924866618775);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 28 * stride, t2 * t8);
        prt__vec_store(out + 32 * stride, t4 * t8);
        const prt__vec t9 = PRT__R(1.38599481613688115647) * t6 - PRT__R(1.19217565770897169497);
        const prt__vec t10 = t6 * t9 - PRT__R(0.413602361414863611859);
        prt__vec_store(out + 40 * stride, t2 * t10);
        prt__vec_store(out + 44 * stride, t4 * t10);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
        const prt__vec t4 = PRT__R(1.38599481613688115647) * t3 - PRT__R(1.19217565770897169497);
        const prt__vec t5 = PRT__R(2.08166599946613273528) * (z * (t3 * t4 - PRT__R(0.413602361414863611859)));
        const prt__vec t6 = PRT__R(7.1903051774599856325) * t2 - PRT__R(2.3967683924866618775);
        const prt__vec t7 = t5 - PRT__R(0.984731927834661861874) * (z * t6);
        prt__vec_store(out + 54 * stride, (t1 + t1) * t7);
        const prt__vec t8 = (y + x) * (x - y);
        prt__vec_store(out + 58 * stride, t8 * t7);
        const prt__vec t9 = y * y;
        const prt__vec t10 = t8 + t9;
        const prt__vec t11 = y * (t8 + (t10 + t10));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t11);
        const prt__vec t12 = x * (t8 - (t9 + t9));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t12);
        const prt__vec t13 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t11 * t13);
        prt__vec_store(out + 23 * stride, t12 * t13);
        const prt__vec t14 = PRT__R(4.40314469491725348916) * t2 - PRT__R(0.489238299435250387684);
        prt__vec_store(out + 27 * stride, t11 * t14);
        prt__vec_store(out + 33 * stride, t12 * t14);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = y * (t1 + (t3 + t3));
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(10.1332578546641584906) * t5 - PRT__R(2.76361577854477049742);
        const prt__vec t7 = z * t6;
        prt__vec_store(out + 39 * stride, t4 * t7);
        const prt__vec t8 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 45 * stride, t8 * t7);
        const prt__vec t9 = PRT__R(4.40314469491725348916) * t5 - PRT__R(0.489238299435250387684);
        const prt__vec t10 = PRT__R(1.15401243699174093424) * t9 - PRT__R(1.21603371550977803267);
        const prt__vec t11 = t9 * t10 - PRT__R(0.401771089424162456772);
        prt__vec_store(out + 53 * stride, t4 * t11);
        prt__vec_store(out + 59 * stride, t8 * t11);
        const prt__vec t12 = y * x;
        const prt__vec t13 = t12 + t12;
        const prt__vec t14 = t1 * t13;
        const prt__vec t15 = t14 + t14;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t15);
        const prt__vec t16 = (t1 + t13) * (t1 - t13);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t16);
        const prt__vec t17 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t15 * t17);
        prt__vec_store(out + 34 * stride, t16 * t17);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = t1 * t3;
        const prt__vec t5 = t4 + t4;
        const prt__vec t6 = z * z;
        const prt__vec t7 = PRT__R(5.5502139080159657518) * t6 - PRT__R(0.504564900728724159254);
        prt__vec_store(out + 38 * stride, t5 * t7);
        const prt__vec t8 = (t1 + t3) * (t1 - t3);
        prt__vec_store(out + 46 * stride, t8 * t7);
        const prt__vec t9 = PRT__R(13.4918050467267683135) * t6 - PRT__R(3.11349347232156191849);
        const prt__vec t10 = z * t9;
        prt__vec_store(out + 52 * stride, t5 * t10);
        prt__vec_store(out + 60 * stride, t8 * t10);
        const prt__vec t11 = y * t8 + x * t5;
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * t11);
        const prt__vec t12 = x * t8 - y * t5;
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * t12);
        const prt__vec t13 = PRT__R(2.36661916223175203199) * z;
        prt__vec_store(out + 37 * stride, t11 * t13);
        prt__vec_store(out + 47 * stride, t12 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = PRT__R(6.74590252336338415674) * (z * z) - PRT__R(0.518915578720260319749);
        prt__vec_store(out + 51 * stride, (y * t4 + x * t6) * t7);
        prt__vec_store(out + 61 * stride, (x * t4 - y * t6) * t7);
        const prt__vec t8 = y * y;
        const prt__vec t9 = x * (t1 - (t8 + t8));
        const prt__vec t10 = t1 + t8;
        const prt__vec t11 = y * (t1 + (t10 + t10));
        const prt__vec t12 = t9 * t11;
        const prt__vec t13 = t12 + t12;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * t13);
        const prt__vec t14 = (t9 + t11) * (t9 - t11);
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * t14);
        const prt__vec t15 = PRT__R(2.64596066180190022197) * z;
        prt__vec_store(out + 50 * stride, t13 * t15);
        prt__vec_store(out + 62 * stride, t14 * t15);
        prt__vec_store(out + 49 * stride, PRT__R(0.707162732524596178226) * (y * t14 + x * t13));
        prt__vec_store(out + 63 * stride, PRT__R(0.707162732524596178226) * (x * t14 - y * t13));
    }
}

/* SH basis, 9 bands: 159 multiplications, 54 additions (37 can fuse), 81 stores */
PRT__STATIC void prt__sh_eval_9(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
    const prt_real t6 = t2 * t5 - PRT__R(0.329110590402857834053);
    out[20] = t6;
    const prt_real t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
    out[30] = t7;
    const prt_real t8 = PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6;
    out[42] = t8;
    const prt_real t9 = PRT__R(1.99489143482413445284) * (z * t8) - PRT__R(1.00092721392195810546) * t7;
    out[56] = t9;
    out[72] = PRT__R(1.99608992783391399988) * (z * t9) - PRT__R(1.00060078106951479479) * t8;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t10 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t10;
    out[7] = x * t10;
    const prt_real t11 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
    out[11] = y * t11;
    out[13] = x * t11;
    const prt_real t12 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
    const prt_real t13 = z * t12;
    out[19] = y * t13;
    out[21] = x * t13;
    const prt_real t14 = PRT__R(1.82140655598655998134) * t11 - PRT__R(1.10995495404092863574);
    const prt_real t15 = t11 * t14 - PRT__R(0.434828785147869044447);
    out[29] = y * t15;
    out[31] = x * t15;
    const prt_real t16 = PRT__R(2.02131498923702777609) * (z * t15) - PRT__R(0.995226703056238577025) * t13;
    out[41] = y * t16;
    out[43] = x * t16;
    const prt_real t17 = PRT__R(2.01556443707463741309) * (z * t16) - PRT__R(0.997155044021832052319) * t15;
    out[55] = y * t17;
    out[57] = x * t17;
    const prt_real t18 = PRT__R(2.01186954040739123146) * (z * t17) - PRT__R(0.998166817890174275952) * t16;
    out[71] = y * t18;
    out[73] = x * t18;
    const prt_real t19 = y * x;
    const prt_real t20 = t19 + t19;
    out[4] = PRT__R(0.546274215296039535272) * t20;
    const prt_real t21 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t21;
    const prt_real t22 = PRT__R(1.44530572132027702769) * z;
    out[10] = t20 * t22;
    out[14] = t21 * t22;
    const prt_real t23 = PRT__R(3.31161143515146006332) * t1 - PRT__R(0.473087347878780009046);
    out[18] = t20 * t23;
    out[22] = t21 * t23;
    const prt_real t24 = PRT__R(7.1903051774599856325) * t1 - PRT__R(2.3967683924866618775);
    const prt_real t25 = z * t24;
    out[28] = t20 * t25;
    out[32] = t21 * t25;
    const prt_real t26 = PRT__R(1.38599481613688115647) * t23 - PRT__R(1.19217565770897169497);
    const prt_real t27 = t23 * t26 - PRT__R(0.413602361414863611859);
    out[40] = t20 * t27;
    out[44] = t21 * t27;
    const prt_real t28 = PRT__R(2.08166599946613273528) * (z * t27) - PRT__R(0.984731927834661861874) * t25;
    out[54] = t20 * t28;
    out[58] = t21 * t28;
    const prt_real t29 = PRT__R(2.06155281280883027491) * (z * t28) - PRT__R(0.990337937660287135802) * t27;
    out[70] = t20 * t29;
    out[74] = t21 * t29;
    const prt_real t30 = y * y;
    const prt_real t31 = t21 + t30;
    const prt_real t32 = y * (t21 + (t31 + t31));
    out[9] = PRT__R(0.590043589926643510346) * t32;
    const prt_real t33 = x * (t21 - (t30 + t30));
    out[15] = PRT__R(0.590043589926643510346) * t33;
    const prt_real t34 = PRT__R(1.77013076977993053104) * z;
    out[17] = t32 * t34;
    out[23] = t33 * t34;
    const prt_real t35 = PRT__R(4.40314469491725348916) * t1 - PRT__R(0.489238299435250387684);
    out[27] = t32 * t35;
    out[33] = t33 * t35;
    const prt_real t36 = PRT__R(10.1332578546641584906) * t1 - PRT__R(2.76361577854477049742);
    const prt_real t37 = z * t36;
    out[39] = t32 * t37;
    out[45] = t33 * t37;
    const prt_real t38 = PRT__R(1.15401243699174093424) * t35 - PRT__R(1.21603371550977803267);
    const prt_real t39 = t35 * t38 - PRT__R(0.401771089424162456772);
    out[53] = t32 * t39;
    out[59] = t33 * t39;
    const prt_real t40 = PRT__R(2.15322168769582022424) * (z * t39) - PRT__R(0.975217386560017729543) * t37;
    out[69] = t32 * t40;
    out[75] = t33 * t40;
    const prt_real t41 = t21 * t20;
    const prt_real t42 = t41 + t41;
    out[16] = PRT__R(0.625835735449176134587) * t42;
    const prt_real t43 = (t21 + t20) * (t21 - t20);
    out[24] = PRT__R(0.625835735449176134587) * t43;
    const prt_real t44 = PRT__R(2.075662314881041279) * z;
    out[26] = t42 * t44;
    out[34] = t43 * t44;
    const prt_real t45 = PRT__R(5.5502139080159657518) * t1 - PRT__R(0.504564900728724159254);
    out[38] = t42 * t45;
    out[46] = t43 * t45;
    const prt_real t46 = PRT__R(13.4918050467267683135) * t1 - PRT__R(3.11349347232156191849);
    const prt_real t47 = z * t46;
    out[52] = t42 * t47;
    out[60] = t43 * t47;
    const prt_real t48 = PRT__R(1.0094855015668566765) * t45 - PRT__R(1.22244228452440165368);
    const prt_real t49 = t45 * t48 - PRT__R(0.395385557652339419216);
    out[68] = t42 * t49;
    out[76] = t43 * t49;
    const prt_real t50 = y * t43 + x * t42;
    out[25] = PRT__R(0.656382056840170102814) * t50;
    const prt_real t51 = x * t43 - y * t42;
    out[35] = PRT__R(0.656382056840170102814) * t51;
    const prt_real t52 = PRT__R(2.36661916223175203199) * z;
    out[37] = t50 * t52;
    out[47] = t51 * t52;
    const prt_real t53 = PRT__R(6.74590252336338415674) * t1 - PRT__R(0.518915578720260319749);
    out[51] = t50 * t53;
    out[61] = t51 * t53;
    const prt_real t54 = PRT__R(17.2495531104905400876) * t1 - PRT__R(3.44991062209810801752);
    const prt_real t55 = z * t54;
    out[67] = t50 * t55;
    out[77] = t51 * t55;
    const prt_real t56 = t33 * t32;
    const prt_real t57 = t56 + t56;
    out[36] = PRT__R(0.683184105191914321975) * t57;
    const prt_real t58 = (t33 + t32) * (t33 - t32);
    out[48] = PRT__R(0.683184105191914321975) * t58;
    const prt_real t59 = PRT__R(2.64596066180190022197) * z;
    out[50] = t57 * t59;
    out[62] = t58 * t59;
    const prt_real t60 = PRT__R(7.98499149089313861467) * t1 - PRT__R(0.532332766059542574311);
    out[66] = t57 * t60;
    out[78] = t58 * t60;
    const prt_real t61 = y * t58 + x * t57;
    out[49] = PRT__R(0.707162732524596178226) * t61;
    const prt_real t62 = x * t58 - y * t57;
    out[63] = PRT__R(0.707162732524596178226) * t62;
    const prt_real t63 = PRT__R(2.91570664069931947548) * z;
    out[65] = t61 * t63;
    out[79] = t62 * t63;
    const prt_real t64 = t43 * t42;
    out[64] = PRT__R(0.72892666017482986887) * (t64 + t64);
    out[80] = PRT__R(0.72892666017482986887) * ((t43 + t42) * (t43 - t42));
}

/* SH basis, 9 bands: 159 multiplications, 54 additions (37 can fuse), 81 stores */
PRT__STATIC void prt__sh_eval_9_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        const prt__vec t6 = t2 * t5 - PRT__R(0.329110590402857834053);
        prt__vec_store(out + 20 * stride, t6);
        const prt__vec t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
        prt__vec_store(out + 30 * stride, t7);
        const prt__vec t8 = PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6;
        prt__vec_store(out + 42 * stride, t8);
        prt__vec_store(out + 56 * stride, PRT__R(1.99489143482413445284) * (z * t8) - PRT__R(1.00092721392195810546) * t7);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        const prt__vec t3 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        const prt__vec t4 = t2 * t3 - PRT__R(0.329110590402857834053);
        const prt__vec t5 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        const prt__vec t6 = PRT__R(1.98997487421323990947) * (z * t4) - PRT__R(1.00285307284481394976) * (z * t5);
        const prt__vec t7 = PRT__R(1.99304345718356633685) * (z * t6) - PRT__R(1.00154202096221924809) * t4;
        const prt__vec t8 = PRT__R(1.99489143482413445284) * (z * t7) - PRT__R(1.00092721392195810546) * t6;
        prt__vec_store(out + 72 * stride, PRT__R(1.99608992783391399988) * (z * t8) - PRT__R(1.00060078106951479479) * t7);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t9 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t9);
        prt__vec_store(out + 7 * stride, x * t9);
        const prt__vec t10 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        prt__vec_store(out + 11 * stride, y * t10);
        prt__vec_store(out + 13 * stride, x * t10);
        const prt__vec t11 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
        prt__vec_store(out + 19 * stride, y * (z * t11));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
        const prt__vec t3 = z * t2;
        prt__vec_store(out + 21 * stride, x * t3);
        const prt__vec t4 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        const prt__vec t5 = PRT__R(1.82140655598655998134) * t4 - PRT__R(1.10995495404092863574);
        const prt__vec t6 = t4 * t5 - PRT__R(0.434828785147869044447);
        prt__vec_store(out + 29 * stride, y * t6);
        prt__vec_store(out + 31 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.02131498923702777609) * (z * t6) - PRT__R(0.995226703056238577025) * t3;
        prt__vec_store(out + 41 * stride, y * t7);
        prt__vec_store(out + 43 * stride, x * t7);
        const prt__vec t8 = PRT__R(2.01556443707463741309) * (z * t7) - PRT__R(0.997155044021832052319) * t6;
        prt__vec_store(out + 55 * stride, y * t8);
        prt__vec_store(out + 57 * stride, x * t8);
        const prt__vec t9 = PRT__R(2.01186954040739123146) * (z * t8) - PRT__R(0.998166817890174275952) * t7;
        prt__vec_store(out + 71 * stride, y * t9);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        const prt__vec t3 = PRT__R(1.82140655598655998134) * t2 - PRT__R(1.10995495404092863574);
        const prt__vec t4 = t2 * t3 - PRT__R(0.434828785147869044447);
        const prt__vec t5 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
        const prt__vec t6 = PRT__R(2.02131498923702777609) * (z * t4) - PRT__R(0.995226703056238577025) * (z * t5);
        const prt__vec t7 = PRT__R(2.01556443707463741309) * (z * t6) - PRT__R(0.997155044021832052319) * t4;
        const prt__vec t8 = PRT__R(2.01186954040739123146) * (z * t7) - PRT__R(0.998166817890174275952) * t6;
        prt__vec_store(out + 73 * stride, x * t8);
        const prt__vec t9 = y * x;
        const prt__vec t10 = t9 + t9;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t10);
        const prt__vec t11 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t11);
        const prt__vec t12 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t10 * t12);
        prt__vec_store(out + 14 * stride, t11 * t12);
        const prt__vec t13 = PRT__R(3.31161143515146006332) * t1 - PRT__R(0.473087347878780009046);
        prt__vec_store(out + 18 * stride, t10 * t13);
        prt__vec_store(out + 22 * stride, t11 * t13);
        const prt__vec t14 = PRT__R(7.1903051774599856325) * t1 - PRT__R(2.3967683924866618775);
        prt__vec_store(out + 28 * stride, t10 * (z * t14));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(7.1903051774599856325) * t2 - PRT__R(2.3967683924866618775);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 32 * stride, t1 * t4);
        const prt__vec t5 = y * x;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
        const prt__vec t8 = PRT__R(1.38599481613688115647) * t7 - PRT__R(1.19217565770897169497);
        const prt__vec t9 = t7 * t8 - PRT__R(0.413602361414863611859);
        prt__vec_store(out + 40 * stride, t6 * t9);
        prt__vec_store(out + 44 * stride, t1 * t9);
        const prt__vec t10 = PRT__R(2.08166599946613273528) * (z * t9) - PRT__R(0.984731927834661861874) * t4;
        prt__vec_store(out + 54 * stride, t6 * t10);
        prt__vec_store(out + 58 * stride, t1 * t10);
        const prt__vec t11 = PRT__R(2.06155281280883027491) * (z * t10) - PRT__R(0.990337937660287135802) * t9;
        prt__vec_store(out + 70 * stride, t6 * t11);
        prt__vec_store(out + 74 * stride, t1 * t11);
        const prt__vec t12 = t1 + y * y;
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * (y * (t1 + (t12 + t12))));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t3);
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t5 * t6);
        prt__vec_store(out + 23 * stride, t3 * t6);
        const prt__vec t7 = z * z;
        const prt__vec t8 = PRT__R(4.40314469491725348916) * t7 - PRT__R(0.489238299435250387684);
        prt__vec_store(out + 27 * stride, t5 * t8);
        prt__vec_store(out + 33 * stride, t3 * t8);
        const prt__vec t9 = PRT__R(10.1332578546641584906) * t7 - PRT__R(2.76361577854477049742);
        const prt__vec t10 = z * t9;
        prt__vec_store(out + 39 * stride, t5 * t10);
        prt__vec_store(out + 45 * stride, t3 * t10);
        const prt__vec t11 = PRT__R(1.15401243699174093424) * t8 - PRT__R(1.21603371550977803267);
        prt__vec_store(out + 53 * stride, t5 * (t8 * t11 - PRT__R(0.401771089424162456772)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = z * z;
        const prt__vec t5 = PRT__R(4.40314469491725348916) * t4 - PRT__R(0.489238299435250387684);
        const prt__vec t6 = PRT__R(1.15401243699174093424) * t5 - PRT__R(1.21603371550977803267);
        const prt__vec t7 = t5 * t6 - PRT__R(0.401771089424162456772);
        prt__vec_store(out + 59 * stride, t3 * t7);
        const prt__vec t8 = t1 + t2;
        const prt__vec t9 = PRT__R(10.1332578546641584906) * t4 - PRT__R(2.76361577854477049742);
        const prt__vec t10 = PRT__R(2.15322168769582022424) * (z * t7) - PRT__R(0.975217386560017729543) * (z * t9);
        prt__vec_store(out + 69 * stride, (y * (t1 + (t8 + t8))) * t10);
        prt__vec_store(out + 75 * stride, t3 * t10);
        const prt__vec t11 = y * x;
        const prt__vec t12 = t11 + t11;
        const prt__vec t13 = t1 * t12;
        const prt__vec t14 = t13 + t13;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t14);
        const prt__vec t15 = (t1 + t12) * (t1 - t12);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t15);
        const prt__vec t16 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t14 * t16);
        prt__vec_store(out + 34 * stride, t15 * t16);
        const prt__vec t17 = PRT__R(5.5502139080159657518) * t4 - PRT__R(0.504564900728724159254);
        prt__vec_store(out + 38 * stride, t14 * t17);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(5.5502139080159657518) * t5 - PRT__R(0.504564900728724159254);
        prt__vec_store(out + 46 * stride, t4 * t6);
        const prt__vec t7 = t1 * t3;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = PRT__R(13.4918050467267683135) * t5 - PRT__R(3.11349347232156191849);
        const prt__vec t10 = z * t9;
        prt__vec_store(out + 52 * stride, t8 * t10);
        prt__vec_store(out + 60 * stride, t4 * t10);
        const prt__vec t11 = PRT__R(1.0094855015668566765) * t6 - PRT__R(1.22244228452440165368);
        const prt__vec t12 = t6 * t11 - PRT__R(0.395385557652339419216);
        prt__vec_store(out + 68 * stride, t8 * t12);
        prt__vec_store(out + 76 * stride, t4 * t12);
        const prt__vec t13 = y * t4 + x * t8;
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * t13);
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * (x * t4 - y * t8));
        prt__vec_store(out + 37 * stride, t13 * (PRT__R(2.36661916223175203199) * z));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = x * t4 - y * t6;
        prt__vec_store(out + 47 * stride, t7 * (PRT__R(2.36661916223175203199) * z));
        const prt__vec t8 = y * t4 + x * t6;
        const prt__vec t9 = z * z;
        const prt__vec t10 = PRT__R(6.74590252336338415674) * t9 - PRT__R(0.518915578720260319749);
        prt__vec_store(out + 51 * stride, t8 * t10);
        prt__vec_store(out + 61 * stride, t7 * t10);
        const prt__vec t11 = PRT__R(17.2495531104905400876) * t9 - PRT__R(3.44991062209810801752);
        const prt__vec t12 = z * t11;
        prt__vec_store(out + 67 * stride, t8 * t12);
        prt__vec_store(out + 77 * stride, t7 * t12);
        const prt__vec t13 = y * y;
        const prt__vec t14 = x * (t1 - (t13 + t13));
        const prt__vec t15 = t1 + t13;
        const prt__vec t16 = y * (t1 + (t15 + t15));
        const prt__vec t17 = t14 * t16;
        const prt__vec t18 = t17 + t17;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * t18);
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * ((t14 + t16) * (t14 - t16)));
        prt__vec_store(out + 50 * stride, t18 * (PRT__R(2.64596066180190022197) * z));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = (t3 + t5) * (t3 - t5);
        prt__vec_store(out + 62 * stride, t6 * (PRT__R(2.64596066180190022197) * z));
        const prt__vec t7 = t3 * t5;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = PRT__R(7.98499149089313861467) * (z * z) - PRT__R(0.532332766059542574311);
        prt__vec_store(out + 66 * stride, t8 * t9);
        prt__vec_store(out + 78 * stride, t6 * t9);
        const prt__vec t10 = y * t6 + x * t8;
        prt__vec_store(out + 49 * stride, PRT__R(0.707162732524596178226) * t10);
        const prt__vec t11 = x * t6 - y * t8;
        prt__vec_store(out + 63 * stride, PRT__R(0.707162732524596178226) * t11);
        const prt__vec t12 = PRT__R(2.91570664069931947548) * z;
        prt__vec_store(out + 65 * stride, t10 * t12);
        prt__vec_store(out + 79 * stride, t11 * t12);
        const prt__vec t13 = y * x;
        const prt__vec t14 = t13 + t13;
        const prt__vec t15 = t1 * t14;
        const prt__vec t16 = ((t1 + t14) * (t1 - t14)) * (t15 + t15);
        prt__vec_store(out + 64 * stride, PRT__R(0.72892666017482986887) * (t16 + t16));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        prt__vec_store(out + 80 * stride, PRT__R(0.72892666017482986887) * ((t4 + t6) * (t4 - t6)));
    }
}

/* SH basis, 10 bands: 202 multiplications, 65 additions (48 can fuse), 100 stores */
PRT__STATIC void prt__sh_eval_10(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
    const prt_real t6 = t2 * t5 - PRT__R(0.329110590402857834053);
    out[20] = t6;
    const prt_real t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
    out[30] = t7;
    const prt_real t8 = PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6;
    out[42] = t8;
    const prt_real t9 = PRT__R(1.99489143482413445284) * (z * t8) - PRT__R(1.00092721392195810546) * t7;
    out[56] = t9;
    const prt_real t10 = PRT__R(1.99608992783391399988) * (z * t9) - PRT__R(1.00060078106951479479) * t8;
    out[72] = t10;
    out[90] = PRT__R(1.99691119506793649529) * (z * t10) - PRT__R(1.000411437993133759) * t9;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t11 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t11;
    out[7] = x * t11;
    const prt_real t12 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
    out[11] = y * t12;
    out[13] = x * t12;
    const prt_real t13 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
    const prt_real t14 = z * t13;
    out[19] = y * t14;
    out[21] = x * t14;
    const prt_real t15 = PRT__R(1.82140655598655998134) * t12 - PRT__R(1.10995495404092863574);
    const prt_real t16 = t12 * t15 - PRT__R(0.434828785147869044447);
    out[29] = y * t16;
    out[31] = x * t16;
    const prt_real t17 = PRT__R(2.02131498923702777609) * (z * t16) - PRT__R(0.995226703056238577025) * t14;
    out[41] = y * t17;
    out[43] = x * t17;
    const prt_real t18 = PRT__R(2.01556443707463741309) * (z * t17) - PRT__R(0.997155044021832052319) * t16;
    out[55] = y * t18;
    out[57] = x * t18;
    const prt_real t19 = PRT__R(2.01186954040739123146) * (z * t18) - PRT__R(0.998166817890174275952) * t17;
    out[71] = y * t19;
    out[73] = x * t19;
    const prt_real t20 = PRT__R(2.00935312974101194944) * (z * t19) - PRT__R(0.998749217771908945789) * t18;
    out[89] = y * t20;
    out[91] = x * t20;
    const prt_real t21 = y * x;
    const prt_real t22 = t21 + t21;
    out[4] = PRT__R(0.546274215296039535272) * t22;
    const prt_real t23 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t23;
    const prt_real t24 = PRT__R(1.44530572132027702769) * z;
    out[10] = t22 * t24;
    out[14] = t23 * t24;
    const prt_real t25 = PRT__R(3.31161143515146006332) * t1 - PRT__R(0.473087347878780009046);
    out[18] = t22 * t25;
    out[22] = t23 * t25;
    const prt_real t26 = PRT__R(7.1903051774599856325) * t1 - PRT__R(2.3967683924866618775);
    const prt_real t27 = z * t26;
    out[28] = t22 * t27;
    out[32] = t23 * t27;
    const prt_real t28 = PRT__R(1.38599481613688115647) * t25 - PRT__R(1.19217565770897169497);
    const prt_real t29 = t25 * t28 - PRT__R(0.413602361414863611859);
    out[40] = t22 * t29;
    out[44] = t23 * t29;
    const prt_real t30 = PRT__R(2.08166599946613273528) * (z * t29) - PRT__R(0.984731927834661861874) * t27;
    out[54] = t22 * t30;
    out[58] = t23 * t30;
    const prt_real t31 = PRT__R(2.06155281280883027491) * (z * t30) - PRT__R(0.990337937660287135802) * t29;
    out[70] = t22 * t31;
    out[74] = t23 * t31;
    const prt_real t32 = PRT__R(2.0481223583578191106) * (z * t31) - PRT__R(0.993485272670404014071) * t30;
    out[88] = t22 * t32;
    out[92] = t23 * t32;
    const prt_real t33 = y * y;
    const prt_real t34 = t23 + t33;
    const prt_real t35 = y * (t23 + (t34 + t34));
    out[9] = PRT__R(0.590043589926643510346) * t35;
    const prt_real t36 = x * (t23 - (t33 + t33));
    out[15] = PRT__R(0.590043589926643510346) * t36;
    const prt_real t37 = PRT__R(1.77013076977993053104) * z;
    out[17] = t35 * t37;
    out[23] = t36 * t37;
    const prt_real t38 = PRT__R(4.40314469491725348916) * t1 - PRT__R(0.489238299435250387684);
    out[27] = t35 * t38;
    out[33] = t36 * t38;
    const prt_real t39 = PRT__R(10.1332578546641584906) * t1 - PRT__R(2.76361577854477049742);
    const prt_real t40 = z * t39;
    out[39] = t35 * t40;
    out[45] = t36 * t40;
    const prt_real t41 = PRT__R(1.15401243699174093424) * t38 - PRT__R(1.21603371550977803267);
    const prt_real t42 = t38 * t41 - PRT__R(0.401771089424162456772);
    out[53] = t35 * t42;
    out[59] = t36 * t42;
    const prt_real t43 = PRT__R(2.15322168769582022424) * (z * t42) - PRT__R(0.975217386560017729543) * t40;
    out[69] = t35 * t43;
    out[75] = t36 * t43;
    const prt_real t44 = PRT__R(2.11804417118980573708) * (z * t43) - PRT__R(0.983662844979209628271) * t42;
    out[87] = t35 * t44;
    out[93] = t36 * t44;
    const prt_real t45 = t23 * t22;
    const prt_real t46 = t45 + t45;
    out[16] = PRT__R(0.625835735449176134587) * t46;
    const prt_real t47 = (t23 + t22) * (t23 - t22);
    out[24] = PRT__R(0.625835735449176134587) * t47;
    const prt_real t48 = PRT__R(2.075662314881041279) * z;
    out[26] = t46 * t48;
    out[34] = t47 * t48;
    const prt_real t49 = PRT__R(5.5502139080159657518) * t1 - PRT__R(0.504564900728724159254);
    out[38] = t46 * t49;
    out[46] = t47 * t49;
    const prt_real t50 = PRT__R(13.4918050467267683135) * t1 - PRT__R(3.11349347232156191849);
    const prt_real t51 = z * t50;
    out[52] = t46 * t51;
    out[60] = t47 * t51;
    const prt_real t52 = PRT__R(1.0094855015668566765) * t49 - PRT__R(1.22244228452440165368);
    const prt_real t53 = t49 * t52 - PRT__R(0.395385557652339419216);
    out[68] = t46 * t53;
    out[76] = t47 * t53;
    const prt_real t54 = PRT__R(2.22917715070623519765) * (z * t53) - PRT__R(0.967152839723182214167) * t51;
    out[86] = t46 * t54;
    out[94] = t47 * t54;
    const prt_real t55 = y * t47 + x * t46;
    out[25] = PRT__R(0.656382056840170102814) * t55;
    const prt_real t56 = x * t47 - y * t46;
    out[35] = PRT__R(0.656382056840170102814) * t56;
    const prt_real t57 = PRT__R(2.36661916223175203199) * z;
    out[37] = t55 * t57;
    out[47] = t56 * t57;
    const prt_real t58 = PRT__R(6.74590252336338415674) * t1 - PRT__R(0.518915578720260319749);
    out[51] = t55 * t58;
    out[61] = t56 * t58;
    const prt_real t59 = PRT__R(17.2495531104905400876) * t1 - PRT__R(3.44991062209810801752);
    const prt_real t60 = z * t59;
    out[67] = t55 * t60;
    out[77] = t56 * t60;
    const prt_real t61 = PRT__R(0.910342823558204599004) * t58 - PRT__R(1.22265924807669582645);
    const prt_real t62 = t58 * t61 - PRT__R(0.392209739345009019975);
    out[85] = t55 * t62;
    out[95] = t56 * t62;
    const prt_real t63 = t36 * t35;
    const prt_real t64 = t63 + t63;
    out[36] = PRT__R(0.683184105191914321975) * t64;
    const prt_real t65 = (t36 + t35) * (t36 - t35);
    out[48] = PRT__R(0.683184105191914321975) * t65;
    const prt_real t66 = PRT__R(2.64596066180190022197) * z;
    out[50] = t64 * t66;
    out[62] = t65 * t66;
    const prt_real t67 = PRT__R(7.98499149089313861467) * t1 - PRT__R(0.532332766059542574311);
    out[66] = t64 * t67;
    out[78] = t65 * t67;
    const prt_real t68 = PRT__R(21.3928901909086362545) * t1 - PRT__R(3.77521591604270051551);
    const prt_real t69 = z * t68;
    out[84] = t64 * t69;
    out[96] = t65 * t69;
    const prt_real t70 = y * t65 + x * t64;
    out[49] = PRT__R(0.707162732524596178226) * t70;
    const prt_real t71 = x * t65 - y * t64;
    out[63] = PRT__R(0.707162732524596178226) * t71;
    const prt_real t72 = PRT__R(2.91570664069931947548) * z;
    out[65] = t70 * t72;
    out[79] = t71 * t72;
    const prt_real t73 = PRT__R(9.26339318284890424012) * t1 - PRT__R(0.544905481344053190595);
    out[83] = t70 * t73;
    out[97] = t71 * t73;
    const prt_real t74 = t47 * t46;
    const prt_real t75 = t74 + t74;
    out[64] = PRT__R(0.72892666017482986887) * t75;
    const prt_real t76 = (t47 + t46) * (t47 - t46);
    out[80] = PRT__R(0.72892666017482986887) * t76;
    const prt_real t77 = PRT__R(3.1773176489546974773) * z;
    out[82] = t75 * t77;
    out[98] = t76 * t77;
    out[81] = PRT__R(0.74890095185318829655) * (y * t76 + x * t75);
    out[99] = PRT__R(0.74890095185318829655) * (x * t76 - y * t75);
}

/* SH basis, 10 bands: 202 multiplications, 65 additions (48 can fuse), 100 stores */
PRT__STATIC void prt__sh_eval_10_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        const prt__vec t6 = t2 * t5 - PRT__R(0.329110590402857834053);
        prt__vec_store(out + 20 * stride, t6);
        const prt__vec t7 = PRT__R(1.98997487421323990947) * (z * t6) - PRT__R(1.00285307284481394976) * t4;
        prt__vec_store(out + 30 * stride, t7);
        const prt__vec t8 = PRT__R(1.99304345718356633685) * (z * t7) - PRT__R(1.00154202096221924809) * t6;
        prt__vec_store(out + 42 * stride, t8);
        prt__vec_store(out + 56 * stride, PRT__R(1.99489143482413445284) * (z * t8) - PRT__R(1.00092721392195810546) * t7);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.946174695757560018093) * t1 - PRT__R(0.315391565252520006031);
        const prt__vec t3 = PRT__R(4.13572565211287073036) * t2 - PRT__R(0.745355992499929898803);
        const prt__vec t4 = t2 * t3 - PRT__R(0.329110590402857834053);
        const prt__vec t5 = PRT__R(1.86588166295057695707) * t1 - PRT__R(1.11952899777034617424);
        const prt__vec t6 = PRT__R(1.98997487421323990947) * (z * t4) - PRT__R(1.00285307284481394976) * (z * t5);
        const prt__vec t7 = PRT__R(1.99304345718356633685) * (z * t6) - PRT__R(1.00154202096221924809) * t4;
        const prt__vec t8 = PRT__R(1.99489143482413445284) * (z * t7) - PRT__R(1.00092721392195810546) * t6;
        const prt__vec t9 = PRT__R(1.99608992783391399988) * (z * t8) - PRT__R(1.00060078106951479479) * t7;
        prt__vec_store(out + 72 * stride, t9);
        prt__vec_store(out + 90 * stride, PRT__R(1.99691119506793649529) * (z * t9) - PRT__R(1.000411437993133759) * t8);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t10 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t10);
        prt__vec_store(out + 7 * stride, x * t10);
        const prt__vec t11 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        prt__vec_store(out + 11 * stride, y * t11);
        prt__vec_store(out + 13 * stride, x * t11);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
        const prt__vec t3 = z * t2;
        prt__vec_store(out + 19 * stride, y * t3);
        prt__vec_store(out + 21 * stride, x * t3);
        const prt__vec t4 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        const prt__vec t5 = PRT__R(1.82140655598655998134) * t4 - PRT__R(1.10995495404092863574);
        const prt__vec t6 = t4 * t5 - PRT__R(0.434828785147869044447);
        prt__vec_store(out + 29 * stride, y * t6);
        prt__vec_store(out + 31 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.02131498923702777609) * (z * t6) - PRT__R(0.995226703056238577025) * t3;
        prt__vec_store(out + 41 * stride, y * t7);
        prt__vec_store(out + 43 * stride, x * t7);
        const prt__vec t8 = PRT__R(2.01556443707463741309) * (z * t7) - PRT__R(0.997155044021832052319) * t6;
        prt__vec_store(out + 55 * stride, y * t8);
        prt__vec_store(out + 57 * stride, x * t8);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(2.28522899732232868079) * t1 - PRT__R(0.457045799464465736158);
        const prt__vec t3 = PRT__R(1.82140655598655998134) * t2 - PRT__R(1.10995495404092863574);
        const prt__vec t4 = t2 * t3 - PRT__R(0.434828785147869044447);
        const prt__vec t5 = PRT__R(4.68332580490102417566) * t1 - PRT__R(2.00713963067186750386);
        const prt__vec t6 = PRT__R(2.02131498923702777609) * (z * t4) - PRT__R(0.995226703056238577025) * (z * t5);
        const prt__vec t7 = PRT__R(2.01556443707463741309) * (z * t6) - PRT__R(0.997155044021832052319) * t4;
        const prt__vec t8 = PRT__R(2.01186954040739123146) * (z * t7) - PRT__R(0.998166817890174275952) * t6;
        prt__vec_store(out + 71 * stride, y * t8);
        prt__vec_store(out + 73 * stride, x * t8);
        const prt__vec t9 = PRT__R(2.00935312974101194944) * (z * t8) - PRT__R(0.998749217771908945789) * t7;
        prt__vec_store(out + 89 * stride, y * t9);
        prt__vec_store(out + 91 * stride, x * t9);
        const prt__vec t10 = y * x;
        const prt__vec t11 = t10 + t10;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t11);
        const prt__vec t12 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t12);
        const prt__vec t13 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t11 * t13);
        prt__vec_store(out + 14 * stride, t12 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = z * z;
        const prt__vec t4 = PRT__R(3.31161143515146006332) * t3 - PRT__R(0.473087347878780009046);
        prt__vec_store(out + 18 * stride, t2 * t4);
        const prt__vec t5 = (y + x) * (x - y);
        prt__vec_store(out + 22 * stride, t5 * t4);
        const prt__vec t6 = PRT__R(7.1903051774599856325) * t3 - PRT__R(2.3967683924866618775);
        const prt__vec t7 = z * t6;
        prt__vec_store(out + 28 * stride, t2 * t7);
        prt__vec_store(out + 32 * stride, t5 * t7);
        const prt__vec t8 = PRT__R(1.38599481613688115647) * t4 - PRT__R(1.19217565770897169497);
        const prt__vec t9 = t4 * t8 - PRT__R(0.413602361414863611859);
        prt__vec_store(out + 40 * stride, t2 * t9);
        prt__vec_store(out + 44 * stride, t5 * t9);
        const prt__vec t10 = PRT__R(2.08166599946613273528) * (z * t9) - PRT__R(0.984731927834661861874) * t7;
        prt__vec_store(out + 54 * stride, t2 * t10);
        prt__vec_store(out + 58 * stride, t5 * t10);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = z * z;
        const prt__vec t4 = PRT__R(3.31161143515146006332) * t3 - PRT__R(0.473087347878780009046);
        const prt__vec t5 = PRT__R(1.38599481613688115647) * t4 - PRT__R(1.19217565770897169497);
        const prt__vec t6 = t4 * t5 - PRT__R(0.413602361414863611859);
        const prt__vec t7 = PRT__R(7.1903051774599856325) * t3 - PRT__R(2.3967683924866618775);
        const prt__vec t8 = PRT__R(2.08166599946613273528) * (z * t6) - PRT__R(0.984731927834661861874) * (z * t7);
        const prt__vec t9 = PRT__R(2.06155281280883027491) * (z * t8) - PRT__R(0.990337937660287135802) * t6;
        prt__vec_store(out + 70 * stride, t2 * t9);
        const prt__vec t10 = (y + x) * (x - y);
        prt__vec_store(out + 74 * stride, t10 * t9);
        const prt__vec t11 = PRT__R(2.0481223583578191106) * (z * t9) - PRT__R(0.993485272670404014071) * t8;
        prt__vec_store(out + 88 * stride, t2 * t11);
        prt__vec_store(out + 92 * stride, t10 * t11);
        const prt__vec t12 = y * y;
        const prt__vec t13 = t10 + t12;
        const prt__vec t14 = y * (t10 + (t13 + t13));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t14);
        const prt__vec t15 = x * (t10 - (t12 + t12));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t15);
        const prt__vec t16 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t14 * t16);
        prt__vec_store(out + 23 * stride, t15 * t16);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = y * (t1 + (t3 + t3));
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(4.40314469491725348916) * t5 - PRT__R(0.489238299435250387684);
        prt__vec_store(out + 27 * stride, t4 * t6);
        const prt__vec t7 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 33 * stride, t7 * t6);
        const prt__vec t8 = PRT__R(10.1332578546641584906) * t5 - PRT__R(2.76361577854477049742);
        const prt__vec t9 = z * t8;
        prt__vec_store(out + 39 * stride, t4 * t9);
        prt__vec_store(out + 45 * stride, t7 * t9);
        const prt__vec t10 = PRT__R(1.15401243699174093424) * t6 - PRT__R(1.21603371550977803267);
        const prt__vec t11 = t6 * t10 - PRT__R(0.401771089424162456772);
        prt__vec_store(out + 53 * stride, t4 * t11);
        prt__vec_store(out + 59 * stride, t7 * t11);
        const prt__vec t12 = PRT__R(2.15322168769582022424) * (z * t11) - PRT__R(0.975217386560017729543) * t9;
        prt__vec_store(out + 69 * stride, t4 * t12);
        prt__vec_store(out + 75 * stride, t7 * t12);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = z * z;
        const prt__vec t5 = PRT__R(4.40314469491725348916) * t4 - PRT__R(0.489238299435250387684);
        const prt__vec t6 = PRT__R(1.15401243699174093424) * t5 - PRT__R(1.21603371550977803267);
        const prt__vec t7 = t5 * t6 - PRT__R(0.401771089424162456772);
        const prt__vec t8 = PRT__R(10.1332578546641584906) * t4 - PRT__R(2.76361577854477049742);
        const prt__vec t9 = PRT__R(2.15322168769582022424) * (z * t7) - PRT__R(0.975217386560017729543) * (z * t8);
        const prt__vec t10 = PRT__R(2.11804417118980573708) * (z * t9) - PRT__R(0.983662844979209628271) * t7;
        prt__vec_store(out + 87 * stride, (y * (t1 + (t3 + t3))) * t10);
        prt__vec_store(out + 93 * stride, (x * (t1 - (t2 + t2))) * t10);
        const prt__vec t11 = y * x;
        const prt__vec t12 = t11 + t11;
        const prt__vec t13 = t1 * t12;
        const prt__vec t14 = t13 + t13;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t14);
        const prt__vec t15 = (t1 + t12) * (t1 - t12);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t15);
        const prt__vec t16 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t14 * t16);
        prt__vec_store(out + 34 * stride, t15 * t16);
        const prt__vec t17 = PRT__R(5.5502139080159657518) * t4 - PRT__R(0.504564900728724159254);
        prt__vec_store(out + 38 * stride, t14 * t17);
        prt__vec_store(out + 46 * stride, t15 * t17);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = t1 * t3;
        const prt__vec t5 = t4 + t4;
        const prt__vec t6 = z * z;
        const prt__vec t7 = PRT__R(13.4918050467267683135) * t6 - PRT__R(3.11349347232156191849);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 52 * stride, t5 * t8);
        const prt__vec t9 = (t1 + t3) * (t1 - t3);
        prt__vec_store(out + 60 * stride, t9 * t8);
        const prt__vec t10 = PRT__R(5.5502139080159657518) * t6 - PRT__R(0.504564900728724159254);
        const prt__vec t11 = PRT__R(1.0094855015668566765) * t10 - PRT__R(1.22244228452440165368);
        const prt__vec t12 = t10 * t11 - PRT__R(0.395385557652339419216);
        prt__vec_store(out + 68 * stride, t5 * t12);
        prt__vec_store(out + 76 * stride, t9 * t12);
        const prt__vec t13 = PRT__R(2.22917715070623519765) * (z * t12) - PRT__R(0.967152839723182214167) * t8;
        prt__vec_store(out + 86 * stride, t5 * t13);
        prt__vec_store(out + 94 * stride, t9 * t13);
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * (y * t9 + x * t5));
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * (x * t9 - y * t5));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = y * t4 + x * t6;
        const prt__vec t8 = PRT__R(2.36661916223175203199) * z;
        prt__vec_store(out + 37 * stride, t7 * t8);
        const prt__vec t9 = x * t4 - y * t6;
        prt__vec_store(out + 47 * stride, t9 * t8);
        const prt__vec t10 = z * z;
        const prt__vec t11 = PRT__R(6.74590252336338415674) * t10 - PRT__R(0.518915578720260319749);
        prt__vec_store(out + 51 * stride, t7 * t11);
        prt__vec_store(out + 61 * stride, t9 * t11);
        const prt__vec t12 = PRT__R(17.2495531104905400876) * t10 - PRT__R(3.44991062209810801752);
        const prt__vec t13 = z * t12;
        prt__vec_store(out + 67 * stride, t7 * t13);
        prt__vec_store(out + 77 * stride, t9 * t13);
        const prt__vec t14 = PRT__R(0.910342823558204599004) * t11 - PRT__R(1.22265924807669582645);
        const prt__vec t15 = t11 * t14 - PRT__R(0.392209739345009019975);
        prt__vec_store(out + 85 * stride, t7 * t15);
        prt__vec_store(out + 95 * stride, t9 * t15);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = t3 * t5;
        const prt__vec t7 = t6 + t6;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * t7);
        const prt__vec t8 = (t3 + t5) * (t3 - t5);
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * t8);
        const prt__vec t9 = PRT__R(2.64596066180190022197) * z;
        prt__vec_store(out + 50 * stride, t7 * t9);
        prt__vec_store(out + 62 * stride, t8 * t9);
        const prt__vec t10 = z * z;
        const prt__vec t11 = PRT__R(7.98499149089313861467) * t10 - PRT__R(0.532332766059542574311);
        prt__vec_store(out + 66 * stride, t7 * t11);
        prt__vec_store(out + 78 * stride, t8 * t11);
        const prt__vec t12 = PRT__R(21.3928901909086362545) * t10 - PRT__R(3.77521591604270051551);
        const prt__vec t13 = z * t12;
        prt__vec_store(out + 84 * stride, t7 * t13);
        prt__vec_store(out + 96 * stride, t8 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = (t3 + t5) * (t3 - t5);
        const prt__vec t7 = t3 * t5;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = y * t6 + x * t8;
        prt__vec_store(out + 49 * stride, PRT__R(0.707162732524596178226) * t9);
        const prt__vec t10 = x * t6 - y * t8;
        prt__vec_store(out + 63 * stride, PRT__R(0.707162732524596178226) * t10);
        const prt__vec t11 = PRT__R(2.91570664069931947548) * z;
        prt__vec_store(out + 65 * stride, t9 * t11);
        prt__vec_store(out + 79 * stride, t10 * t11);
        const prt__vec t12 = PRT__R(9.26339318284890424012) * (z * z) - PRT__R(0.544905481344053190595);
        prt__vec_store(out + 83 * stride, t9 * t12);
        prt__vec_store(out + 97 * stride, t10 * t12);
        const prt__vec t13 = y * x;
        const prt__vec t14 = t13 + t13;
        const prt__vec t15 = (t1 + t14) * (t1 - t14);
        const prt__vec t16 = t1 * t14;
        const prt__vec t17 = t16 + t16;
        const prt__vec t18 = t15 * t17;
        prt__vec_store(out + 64 * stride, PRT__R(0.72892666017482986887) * (t18 + t18));
        prt__vec_store(out + 80 * stride, PRT__R(0.72892666017482986887) * ((t15 + t17) * (t15 - t17)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = t4 * t6;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = PRT__R(3.1773176489546974773) * z;
        prt__vec_store(out + 82 * stride, t8 * t9);
        const prt__vec t10 = (t4 + t6) * (t4 - t6);
        prt__vec_store(out + 98 * stride, t10 * t9);
        prt__vec_store(out + 81 * stride, PRT__R(0.74890095185318829655) * (y * t10 + x * t8));
        prt__vec_store(out + 99 * stride, PRT__R(0.74890095185318829655) * (x * t10 - y * t8));
    }
}

/* SH value, 1 band: 1 multiplications, 0 additions (0 can fuse), 1 loads, 1 stores */
PRT__STATIC void prt__sh_at_1(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    (void)x;
    (void)y;
    (void)z;
    out[0] = PRT__R(0.282094791773878143474) * f[0];
}

/* SH value, 2 bands: 7 multiplications, 3 additions (2 can fuse), 4 loads, 1 stores */
PRT__STATIC void prt__sh_at_2(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = y * (PRT__R(0.488602511902919921586) * f[1]) + x * (PRT__R(0.488602511902919921586) * f[3]);
    out[0] = t1 + t2;
}

/* SH value, 3 bands: 19 multiplications, 12 additions (7 can fuse), 9 loads, 1 stores */
PRT__STATIC void prt__sh_at_3(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = PRT__R(0.946174695757560018093) * (z * z) - PRT__R(0.315391565252520006031);
    const prt_real t3 = PRT__R(1.09254843059207907054) * z;
    const prt_real t4 = y * (PRT__R(0.488602511902919921586) * f[1] + t3 * f[5]) + x * (PRT__R(0.488602511902919921586) * f[3] + t3 * f[7]);
    const prt_real t5 = y * x;
    const prt_real t6 = ((y + x) * (x - y)) * (PRT__R(0.546274215296039535272) * f[8]);
    out[0] = ((t1 + t2 * f[6]) + t4) + ((t5 + t5) * (PRT__R(0.546274215296039535272) * f[4]) + t6);
}

/* SH value, 4 bands: 35 multiplications, 26 additions (15 can fuse), 16 loads, 1 stores */
PRT__STATIC void prt__sh_at_4(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.946174695757560018093) * t2 - PRT__R(0.315391565252520006031);
    const prt_real t4 = PRT__R(1.86588166295057695707) * t2 - PRT__R(1.11952899777034617424);
    const prt_real t5 = PRT__R(1.09254843059207907054) * z;
    const prt_real t6 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
    const prt_real t7 = (PRT__R(0.488602511902919921586) * f[1] + t5 * f[5]) + t6 * f[11];
    const prt_real t8 = (PRT__R(0.488602511902919921586) * f[3] + t5 * f[7]) + t6 * f[13];
    const prt_real t9 = y * x;
    const prt_real t10 = PRT__R(1.44530572132027702769) * z;
    const prt_real t11 = (t9 + t9) * (PRT__R(0.546274215296039535272) * f[4] + t10 * f[10]);
    const prt_real t12 = (y + x) * (x - y);
    const prt_real t13 = t11 + t12 * (PRT__R(0.546274215296039535272) * f[8] + t10 * f[14]);
    const prt_real t14 = (((t1 + t3 * f[6]) + (z * t4) * f[12]) + (y * t7 + x * t8)) + t13;
    const prt_real t15 = y * y;
    const prt_real t16 = t12 + t15;
    const prt_real t17 = (y * (t12 + (t16 + t16))) * (PRT__R(0.590043589926643510346) * f[9]);
    const prt_real t18 = (x * (t12 - (t15 + t15))) * (PRT__R(0.590043589926643510346) * f[15]);
    out[0] = t14 + (t17 + t18);
}

/* SH value, 5 bands: 54 multiplications, 42 additions (27 can fuse), 25 loads, 1 stores */
PRT__STATIC void prt__sh_at_5(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.946174695757560018093) * t2 - PRT__R(0.315391565252520006031);
    const prt_real t4 = PRT__R(1.86588166295057695707) * t2 - PRT__R(1.11952899777034617424);
    const prt_real t5 = PRT__R(4.13572565211287073036) * t3 - PRT__R(0.745355992499929898803);
    const prt_real t6 = ((t1 + t3 * f[6]) + (z * t4) * f[12]) + (t3 * t5 - PRT__R(0.329110590402857834053)) * f[20];
    const prt_real t7 = PRT__R(1.09254843059207907054) * z;
    const prt_real t8 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
    const prt_real t9 = (PRT__R(0.488602511902919921586) * f[1] + t7 * f[5]) + t8 * f[11];
    const prt_real t10 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
    const prt_real t11 = z * t10;
    const prt_real t12 = (PRT__R(0.488602511902919921586) * f[3] + t7 * f[7]) + t8 * f[13];
    const prt_real t13 = y * x;
    const prt_real t14 = t13 + t13;
    const prt_real t15 = PRT__R(1.44530572132027702769) * z;
    const prt_real t16 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
    const prt_real t17 = (PRT__R(0.546274215296039535272) * f[4] + t15 * f[10]) + t16 * f[18];
    const prt_real t18 = (y + x) * (x - y);
    const prt_real t19 = (PRT__R(0.546274215296039535272) * f[8] + t15 * f[14]) + t16 * f[22];
    const prt_real t20 = (t6 + (y * (t9 + t11 * f[19]) + x * (t12 + t11 * f[21]))) + (t14 * t17 + t18 * t19);
    const prt_real t21 = y * y;
    const prt_real t22 = t18 + t21;
    const prt_real t23 = PRT__R(1.77013076977993053104) * z;
    const prt_real t24 = (y * (t18 + (t22 + t22))) * (PRT__R(0.590043589926643510346) * f[9] + t23 * f[17]);
    const prt_real t25 = (x * (t18 - (t21 + t21))) * (PRT__R(0.590043589926643510346) * f[15] + t23 * f[23]);
    const prt_real t26 = t18 * t14;
    const prt_real t27 = ((t18 + t14) * (t18 - t14)) * (PRT__R(0.625835735449176134587) * f[24]);
    const prt_real t28 = (t26 + t26) * (PRT__R(0.625835735449176134587) * f[16]) + t27;
    out[0] = (t20 + (t24 + t25)) + t28;
}

/* SH value, 6 bands: 80 multiplications, 60 additions (44 can fuse), 36 loads, 1 stores */
PRT__STATIC void prt__sh_at_6(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.946174695757560018093) * t2 - PRT__R(0.315391565252520006031);
    const prt_real t4 = PRT__R(1.86588166295057695707) * t2 - PRT__R(1.11952899777034617424);
    const prt_real t5 = z * t4;
    const prt_real t6 = PRT__R(4.13572565211287073036) * t3 - PRT__R(0.745355992499929898803);
    const prt_real t7 = t3 * t6 - PRT__R(0.329110590402857834053);
    const prt_real t8 = PRT__R(1.98997487421323990947) * (z * t7) - PRT__R(1.00285307284481394976) * t5;
    const prt_real t9 = (((t1 + t3 * f[6]) + t5 * f[12]) + t7 * f[20]) + t8 * f[30];
    const prt_real t10 = PRT__R(1.09254843059207907054) * z;
    const prt_real t11 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
    const prt_real t12 = (PRT__R(0.488602511902919921586) * f[1] + t10 * f[5]) + t11 * f[11];
    const prt_real t13 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
    const prt_real t14 = z * t13;
    const prt_real t15 = PRT__R(1.82140655598655998134) * t11 - PRT__R(1.10995495404092863574);
    const prt_real t16 = t11 * t15 - PRT__R(0.434828785147869044447);
    const prt_real t17 = (PRT__R(0.488602511902919921586) * f[3] + t10 * f[7]) + t11 * f[13];
    const prt_real t18 = y * ((t12 + t14 * f[19]) + t16 * f[29]) + x * ((t17 + t14 * f[21]) + t16 * f[31]);
    const prt_real t19 = y * x;
    const prt_real t20 = t19 + t19;
    const prt_real t21 = PRT__R(1.44530572132027702769) * z;
    const prt_real t22 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
    const prt_real t23 = (PRT__R(0.546274215296039535272) * f[4] + t21 * f[10]) + t22 * f[18];
    const prt_real t24 = PRT__R(7.1903051774599856325) * t2 - PRT__R(2.3967683924866618775);
    const prt_real t25 = z * t24;
    const prt_real t26 = (y + x) * (x - y);
    const prt_real t27 = (PRT__R(0.546274215296039535272) * f[8] + t21 * f[14]) + t22 * f[22];
    const prt_real t28 = (t9 + t18) + (t20 * (t23 + t25 * f[28]) + t26 * (t27 + t25 * f[32]));
    const prt_real t29 = y * y;
    const prt_real t30 = t26 + t29;
    const prt_real t31 = PRT__R(1.77013076977993053104) * z;
    const prt_real t32 = PRT__R(4.40314469491725348916) * t2 - PRT__R(0.489238299435250387684);
    const prt_real t33 = (PRT__R(0.590043589926643510346) * f[9] + t31 * f[17]) + t32 * f[27];
    const prt_real t34 = (PRT__R(0.590043589926643510346) * f[15] + t31 * f[23]) + t32 * f[33];
    const prt_real t35 = (y * (t26 + (t30 + t30))) * t33 + (x * (t26 - (t29 + t29))) * t34;
    const prt_real t36 = t26 * t20;
    const prt_real t37 = t36 + t36;
    const prt_real t38 = PRT__R(2.075662314881041279) * z;
    const prt_real t39 = t37 * (PRT__R(0.625835735449176134587) * f[16] + t38 * f[26]);
    const prt_real t40 = (t26 + t20) * (t26 - t20);
    const prt_real t41 = t40 * (PRT__R(0.625835735449176134587) * f[24] + t38 * f[34]);
    const prt_real t42 = (y * t40 + x * t37) * (PRT__R(0.656382056840170102814) * f[25]);
    const prt_real t43 = (x * t40 - y * t37) * (PRT__R(0.656382056840170102814) * f[35]);
    out[0] = ((t28 + t35) + (t39 + t41)) + (t42 + t43);
}

/* SH value, 7 bands: 109 multiplications, 82 additions (62 can fuse), 49 loads, 1 stores */
PRT__STATIC void prt__sh_at_7(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.946174695757560018093) * t2 - PRT__R(0.315391565252520006031);
    const prt_real t4 = PRT__R(1.86588166295057695707) * t2 - PRT__R(1.11952899777034617424);
    const prt_real t5 = z * t4;
    const prt_real t6 = PRT__R(4.13572565211287073036) * t3 - PRT__R(0.745355992499929898803);
    const prt_real t7 = t3 * t6 - PRT__R(0.329110590402857834053);
    const prt_real t8 = PRT__R(1.98997487421323990947) * (z * t7) - PRT__R(1.00285307284481394976) * t5;
    const prt_real t9 = (((t1 + t3 * f[6]) + t5 * f[12]) + t7 * f[20]) + t8 * f[30];
    const prt_real t10 = PRT__R(1.99304345718356633685) * (z * t8) - PRT__R(1.00154202096221924809) * t7;
    const prt_real t11 = PRT__R(1.09254843059207907054) * z;
    const prt_real t12 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
    const prt_real t13 = (PRT__R(0.488602511902919921586) * f[1] + t11 * f[5]) + t12 * f[11];
    const prt_real t14 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
    const prt_real t15 = z * t14;
    const prt_real t16 = PRT__R(1.82140655598655998134) * t12 - PRT__R(1.10995495404092863574);
    const prt_real t17 = t12 * t16 - PRT__R(0.434828785147869044447);
    const prt_real t18 = PRT__R(2.02131498923702777609) * (z * t17) - PRT__R(0.995226703056238577025) * t15;
    const prt_real t19 = (PRT__R(0.488602511902919921586) * f[3] + t11 * f[7]) + t12 * f[13];
    const prt_real t20 = y * (((t13 + t15 * f[19]) + t17 * f[29]) + t18 * f[41]) + x * (((t19 + t15 * f[21]) + t17 * f[31]) + t18 * f[43]);
    const prt_real t21 = y * x;
    const prt_real t22 = t21 + t21;
    const prt_real t23 = PRT__R(1.44530572132027702769) * z;
    const prt_real t24 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
    const prt_real t25 = (PRT__R(0.546274215296039535272) * f[4] + t23 * f[10]) + t24 * f[18];
    const prt_real t26 = PRT__R(7.1903051774599856325) * t2 - PRT__R(2.3967683924866618775);
    const prt_real t27 = z * t26;
    const prt_real t28 = PRT__R(1.38599481613688115647) * t24 - PRT__R(1.19217565770897169497);
    const prt_real t29 = t24 * t28 - PRT__R(0.413602361414863611859);
    const prt_real t30 = (y + x) * (x - y);
    const prt_real t31 = (PRT__R(0.546274215296039535272) * f[8] + t23 * f[14]) + t24 * f[22];
    const prt_real t32 = t22 * ((t25 + t27 * f[28]) + t29 * f[40]) + t30 * ((t31 + t27 * f[32]) + t29 * f[44]);
    const prt_real t33 = y * y;
    const prt_real t34 = t30 + t33;
    const prt_real t35 = y * (t30 + (t34 + t34));
    const prt_real t36 = PRT__R(1.77013076977993053104) * z;
    const prt_real t37 = PRT__R(4.40314469491725348916) * t2 - PRT__R(0.489238299435250387684);
    const prt_real t38 = (PRT__R(0.590043589926643510346) * f[9] + t36 * f[17]) + t37 * f[27];
    const prt_real t39 = PRT__R(10.1332578546641584906) * t2 - PRT__R(2.76361577854477049742);
    const prt_real t40 = z * t39;
    const prt_real t41 = x * (t30 - (t33 + t33));
    const prt_real t42 = (PRT__R(0.590043589926643510346) * f[15] + t36 * f[23]) + t37 * f[33];
    const prt_real t43 = (((t9 + t10 * f[42]) + t20) + t32) + (t35 * (t38 + t40 * f[39]) + t41 * (t42 + t40 * f[45]));
    const prt_real t44 = t30 * t22;
    const prt_real t45 = t44 + t44;
    const prt_real t46 = PRT__R(2.075662314881041279) * z;
    const prt_real t47 = PRT__R(5.5502139080159657518) * t2 - PRT__R(0.504564900728724159254);
    const prt_real t48 = (PRT__R(0.625835735449176134587) * f[16] + t46 * f[26]) + t47 * f[38];
    const prt_real t49 = (t30 + t22) * (t30 - t22);
    const prt_real t50 = (PRT__R(0.625835735449176134587) * f[24] + t46 * f[34]) + t47 * f[46];
    const prt_real t51 = PRT__R(2.36661916223175203199) * z;
    const prt_real t52 = (y * t49 + x * t45) * (PRT__R(0.656382056840170102814) * f[25] + t51 * f[37]);
    const prt_real t53 = (x * t49 - y * t45) * (PRT__R(0.656382056840170102814) * f[35] + t51 * f[47]);
    const prt_real t54 = t41 * t35;
    const prt_real t55 = ((t41 + t35) * (t41 - t35)) * (PRT__R(0.683184105191914321975) * f[48]);
    const prt_real t56 = (t54 + t54) * (PRT__R(0.683184105191914321975) * f[36]) + t55;
    out[0] = ((t43 + (t45 * t48 + t49 * t50)) + (t52 + t53)) + t56;
}

/* SH value, 8 bands: 145 multiplications, 106 additions (85 can fuse), 64 loads, 1 stores */
PRT__STATIC void prt__sh_at_8(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.946174695757560018093) * t2 - PRT__R(0.315391565252520006031);
    const prt_real t4 = PRT__R(1.86588166295057695707) * t2 - PRT__R(1.11952899777034617424);
    const prt_real t5 = z * t4;
    const prt_real t6 = PRT__R(4.13572565211287073036) * t3 - PRT__R(0.745355992499929898803);
    const prt_real t7 = t3 * t6 - PRT__R(0.329110590402857834053);
    const prt_real t8 = PRT__R(1.98997487421323990947) * (z * t7) - PRT__R(1.00285307284481394976) * t5;
    const prt_real t9 = (((t1 + t3 * f[6]) + t5 * f[12]) + t7 * f[20]) + t8 * f[30];
    const prt_real t10 = PRT__R(1.99304345718356633685) * (z * t8) - PRT__R(1.00154202096221924809) * t7;
    const prt_real t11 = PRT__R(1.99489143482413445284) * (z * t10) - PRT__R(1.00092721392195810546) * t8;
    const prt_real t12 = PRT__R(1.09254843059207907054) * z;
    const prt_real t13 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
    const prt_real t14 = (PRT__R(0.488602511902919921586) * f[1] + t12 * f[5]) + t13 * f[11];
    const prt_real t15 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
    const prt_real t16 = z * t15;
    const prt_real t17 = PRT__R(1.82140655598655998134) * t13 - PRT__R(1.10995495404092863574);
    const prt_real t18 = t13 * t17 - PRT__R(0.434828785147869044447);
    const prt_real t19 = PRT__R(2.02131498923702777609) * (z * t18) - PRT__R(0.995226703056238577025) * t16;
    const prt_real t20 = PRT__R(2.01556443707463741309) * (z * t19) - PRT__R(0.997155044021832052319) * t18;
    const prt_real t21 = (((t14 + t16 * f[19]) + t18 * f[29]) + t19 * f[41]) + t20 * f[55];
    const prt_real t22 = (PRT__R(0.488602511902919921586) * f[3] + t12 * f[7]) + t13 * f[13];
    const prt_real t23 = (((t22 + t16 * f[21]) + t18 * f[31]) + t19 * f[43]) + t20 * f[57];
    const prt_real t24 = y * x;
    const prt_real t25 = t24 + t24;
    const prt_real t26 = PRT__R(1.44530572132027702769) * z;
    const prt_real t27 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
    const prt_real t28 = (PRT__R(0.546274215296039535272) * f[4] + t26 * f[10]) + t27 * f[18];
    const prt_real t29 = PRT__R(7.1903051774599856325) * t2 - PRT__R(2.3967683924866618775);
    const prt_real t30 = z * t29;
    const prt_real t31 = PRT__R(1.38599481613688115647) * t27 - PRT__R(1.19217565770897169497);
    const prt_real t32 = t27 * t31 - PRT__R(0.413602361414863611859);
    const prt_real t33 = PRT__R(2.08166599946613273528) * (z * t32) - PRT__R(0.984731927834661861874) * t30;
    const prt_real t34 = (y + x) * (x - y);
    const prt_real t35 = (PRT__R(0.546274215296039535272) * f[8] + t26 * f[14]) + t27 * f[22];
    const prt_real t36 = t25 * (((t28 + t30 * f[28]) + t32 * f[40]) + t33 * f[54]) + t34 * (((t35 + t30 * f[32]) + t32 * f[44]) + t33 * f[58]);
    const prt_real t37 = (((t9 + t10 * f[42]) + t11 * f[56]) + (y * t21 + x * t23)) + t36;
    const prt_real t38 = y * y;
    const prt_real t39 = t34 + t38;
    const prt_real t40 = y * (t34 + (t39 + t39));
    const prt_real t41 = PRT__R(1.77013076977993053104) * z;
    const prt_real t42 = PRT__R(4.40314469491725348916) * t2 - PRT__R(0.489238299435250387684);
    const prt_real t43 = (PRT__R(0.590043589926643510346) * f[9] + t41 * f[17]) + t42 * f[27];
    const prt_real t44 = PRT__R(10.1332578546641584906) * t2 - PRT__R(2.76361577854477049742);
    const prt_real t45 = z * t44;
    const prt_real t46 = PRT__R(1.15401243699174093424) * t42 - PRT__R(1.21603371550977803267);
    const prt_real t47 = t42 * t46 - PRT__R(0.401771089424162456772);
    const prt_real t48 = x * (t34 - (t38 + t38));
    const prt_real t49 = (PRT__R(0.590043589926643510346) * f[15] + t41 * f[23]) + t42 * f[33];
    const prt_real t50 = t40 * ((t43 + t45 * f[39]) + t47 * f[53]) + t48 * ((t49 + t45 * f[45]) + t47 * f[59]);
    const prt_real t51 = t34 * t25;
    const prt_real t52 = t51 + t51;
    const prt_real t53 = PRT__R(2.075662314881041279) * z;
    const prt_real t54 = PRT__R(5.5502139080159657518) * t2 - PRT__R(0.504564900728724159254);
    const prt_real t55 = (PRT__R(0.625835735449176134587) * f[16] + t53 * f[26]) + t54 * f[38];
    const prt_real t56 = PRT__R(13.4918050467267683135) * t2 - PRT__R(3.11349347232156191849);
    const prt_real t57 = z * t56;
    const prt_real t58 = (t34 + t25) * (t34 - t25);
    const prt_real t59 = (PRT__R(0.625835735449176134587) * f[24] + t53 * f[34]) + t54 * f[46];
    const prt_real t60 = (t37 + t50) + (t52 * (t55 + t57 * f[52]) + t58 * (t59 + t57 * f[60]));
    const prt_real t61 = PRT__R(2.36661916223175203199) * z;
    const prt_real t62 = PRT__R(6.74590252336338415674) * t2 - PRT__R(0.518915578720260319749);
    const prt_real t63 = (PRT__R(0.656382056840170102814) * f[25] + t61 * f[37]) + t62 * f[51];
    const prt_real t64 = (PRT__R(0.656382056840170102814) * f[35] + t61 * f[47]) + t62 * f[61];
    const prt_real t65 = t60 + ((y * t58 + x * t52) * t63 + (x * t58 - y * t52) * t64);
    const prt_real t66 = t48 * t40;
    const prt_real t67 = t66 + t66;
    const prt_real t68 = PRT__R(2.64596066180190022197) * z;
    const prt_real t69 = t67 * (PRT__R(0.683184105191914321975) * f[36] + t68 * f[50]);
    const prt_real t70 = (t48 + t40) * (t48 - t40);
    const prt_real t71 = t70 * (PRT__R(0.683184105191914321975) * f[48] + t68 * f[62]);
    const prt_real t72 = (y * t70 + x * t67) * (PRT__R(0.707162732524596178226) * f[49]);
    const prt_real t73 = (x * t70 - y * t67) * (PRT__R(0.707162732524596178226) * f[63]);
    out[0] = (t65 + (t69 + t71)) + (t72 + t73);
}

/* SH value, 9 bands: 184 multiplications, 134 additions (109 can fuse), 81 loads, 1 stores */
PRT__STATIC void prt__sh_at_9(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.946174695757560018093) * t2 - PRT__R(0.315391565252520006031);
    const prt_real t4 = PRT__R(1.86588166295057695707) * t2 - PRT__R(1.11952899777034617424);
    const prt_real t5 = z * t4;
    const prt_real t6 = PRT__R(4.13572565211287073036) * t3 - PRT__R(0.745355992499929898803);
    const prt_real t7 = t3 * t6 - PRT__R(0.329110590402857834053);
    const prt_real t8 = PRT__R(1.98997487421323990947) * (z * t7) - PRT__R(1.00285307284481394976) * t5;
    const prt_real t9 = (((t1 + t3 * f[6]) + t5 * f[12]) + t7 * f[20]) + t8 * f[30];
    const prt_real t10 = PRT__R(1.99304345718356633685) * (z * t8) - PRT__R(1.00154202096221924809) * t7;
    const prt_real t11 = PRT__R(1.99489143482413445284) * (z * t10) - PRT__R(1.00092721392195810546) * t8;
    const prt_real t12 = PRT__R(1.99608992783391399988) * (z * t11) - PRT__R(1.00060078106951479479) * t10;
    const prt_real t13 = PRT__R(1.09254843059207907054) * z;
    const prt_real t14 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
    const prt_real t15 = (PRT__R(0.488602511902919921586) * f[1] + t13 * f[5]) + t14 * f[11];
    const prt_real t16 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
    const prt_real t17 = z * t16;
    const prt_real t18 = PRT__R(1.82140655598655998134) * t14 - PRT__R(1.10995495404092863574);
    const prt_real t19 = t14 * t18 - PRT__R(0.434828785147869044447);
    const prt_real t20 = PRT__R(2.02131498923702777609) * (z * t19) - PRT__R(0.995226703056238577025) * t17;
    const prt_real t21 = PRT__R(2.01556443707463741309) * (z * t20) - PRT__R(0.997155044021832052319) * t19;
    const prt_real t22 = (((t15 + t17 * f[19]) + t19 * f[29]) + t20 * f[41]) + t21 * f[55];
    const prt_real t23 = PRT__R(2.01186954040739123146) * (z * t21) - PRT__R(0.998166817890174275952) * t20;
    const prt_real t24 = (PRT__R(0.488602511902919921586) * f[3] + t13 * f[7]) + t14 * f[13];
    const prt_real t25 = (((t24 + t17 * f[21]) + t19 * f[31]) + t20 * f[43]) + t21 * f[57];
    const prt_real t26 = (((t9 + t10 * f[42]) + t11 * f[56]) + t12 * f[72]) + (y * (t22 + t23 * f[71]) + x * (t25 + t23 * f[73]));
    const prt_real t27 = y * x;
    const prt_real t28 = t27 + t27;
    const prt_real t29 = PRT__R(1.44530572132027702769) * z;
    const prt_real t30 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
    const prt_real t31 = (PRT__R(0.546274215296039535272) * f[4] + t29 * f[10]) + t30 * f[18];
    const prt_real t32 = PRT__R(7.1903051774599856325) * t2 - PRT__R(2.3967683924866618775);
    const prt_real t33 = z * t32;
    const prt_real t34 = PRT__R(1.38599481613688115647) * t30 - PRT__R(1.19217565770897169497);
    const prt_real t35 = t30 * t34 - PRT__R(0.413602361414863611859);
    const prt_real t36 = PRT__R(2.08166599946613273528) * (z * t35) - PRT__R(0.984731927834661861874) * t33;
    const prt_real t37 = PRT__R(2.06155281280883027491) * (z * t36) - PRT__R(0.990337937660287135802) * t35;
    const prt_real t38 = (((t31 + t33 * f[28]) + t35 * f[40]) + t36 * f[54]) + t37 * f[70];
    const prt_real t39 = (y + x) * (x - y);
    const prt_real t40 = (PRT__R(0.546274215296039535272) * f[8] + t29 * f[14]) + t30 * f[22];
    const prt_real t41 = (((t40 + t33 * f[32]) + t35 * f[44]) + t36 * f[58]) + t37 * f[74];
    const prt_real t42 = y * y;
    const prt_real t43 = t39 + t42;
    const prt_real t44 = y * (t39 + (t43 + t43));
    const prt_real t45 = PRT__R(1.77013076977993053104) * z;
    const prt_real t46 = PRT__R(4.40314469491725348916) * t2 - PRT__R(0.489238299435250387684);
    const prt_real t47 = (PRT__R(0.590043589926643510346) * f[9] + t45 * f[17]) + t46 * f[27];
    const prt_real t48 = PRT__R(10.1332578546641584906) * t2 - PRT__R(2.76361577854477049742);
    const prt_real t49 = z * t48;
    const prt_real t50 = PRT__R(1.15401243699174093424) * t46 - PRT__R(1.21603371550977803267);
    const prt_real t51 = t46 * t50 - PRT__R(0.401771089424162456772);
    const prt_real t52 = PRT__R(2.15322168769582022424) * (z * t51) - PRT__R(0.975217386560017729543) * t49;
    const prt_real t53 = x * (t39 - (t42 + t42));
    const prt_real t54 = (PRT__R(0.590043589926643510346) * f[15] + t45 * f[23]) + t46 * f[33];
    const prt_real t55 = t44 * (((t47 + t49 * f[39]) + t51 * f[53]) + t52 * f[69]) + t53 * (((t54 + t49 * f[45]) + t51 * f[59]) + t52 * f[75]);
    const prt_real t56 = t39 * t28;
    const prt_real t57 = t56 + t56;
    const prt_real t58 = PRT__R(2.075662314881041279) * z;
    const prt_real t59 = PRT__R(5.5502139080159657518) * t2 - PRT__R(0.504564900728724159254);
    const prt_real t60 = (PRT__R(0.625835735449176134587) * f[16] + t58 * f[26]) + t59 * f[38];
    const prt_real t61 = PRT__R(13.4918050467267683135) * t2 - PRT__R(3.11349347232156191849);
    const prt_real t62 = z * t61;
    const prt_real t63 = PRT__R(1.0094855015668566765) * t59 - PRT__R(1.22244228452440165368);
    const prt_real t64 = t59 * t63 - PRT__R(0.395385557652339419216);
    const prt_real t65 = (t39 + t28) * (t39 - t28);
    const prt_real t66 = (PRT__R(0.625835735449176134587) * f[24] + t58 * f[34]) + t59 * f[46];
    const prt_real t67 = t57 * ((t60 + t62 * f[52]) + t64 * f[68]) + t65 * ((t66 + t62 * f[60]) + t64 * f[76]);
    const prt_real t68 = PRT__R(2.36661916223175203199) * z;
    const prt_real t69 = PRT__R(6.74590252336338415674) * t2 - PRT__R(0.518915578720260319749);
    const prt_real t70 = (PRT__R(0.656382056840170102814) * f[25] + t68 * f[37]) + t69 * f[51];
    const prt_real t71 = PRT__R(17.2495531104905400876) * t2 - PRT__R(3.44991062209810801752);
    const prt_real t72 = z * t71;
    const prt_real t73 = (PRT__R(0.656382056840170102814) * f[35] + t68 * f[47]) + t69 * f[61];
    const prt_real t74 = (y * t65 + x * t57) * (t70 + t72 * f[67]) + (x * t65 - y * t57) * (t73 + t72 * f[77]);
    const prt_real t75 = t53 * t44;
    const prt_real t76 = t75 + t75;
    const prt_real t77 = PRT__R(2.64596066180190022197) * z;
    const prt_real t78 = PRT__R(7.98499149089313861467) * t2 - PRT__R(0.532332766059542574311);
    const prt_real t79 = (PRT__R(0.683184105191914321975) * f[36] + t77 * f[50]) + t78 * f[66];
    const prt_real t80 = (t53 + t44) * (t53 - t44);
    const prt_real t81 = (PRT__R(0.683184105191914321975) * f[48] + t77 * f[62]) + t78 * f[78];
    const prt_real t82 = ((((t26 + (t28 * t38 + t39 * t41)) + t55) + t67) + t74) + (t76 * t79 + t80 * t81);
    const prt_real t83 = PRT__R(2.91570664069931947548) * z;
    const prt_real t84 = (y * t80 + x * t76) * (PRT__R(0.707162732524596178226) * f[49] + t83 * f[65]);
    const prt_real t85 = (x * t80 - y * t76) * (PRT__R(0.707162732524596178226) * f[63] + t83 * f[79]);
    const prt_real t86 = t65 * t57;
    const prt_real t87 = ((t65 + t57) * (t65 - t57)) * (PRT__R(0.72892666017482986887) * f[80]);
    const prt_real t88 = (t86 + t86) * (PRT__R(0.72892666017482986887) * f[64]) + t87;
    out[0] = (t82 + (t84 + t85)) + t88;
}

/* SH value, 10 bands: 230 multiplications, 164 additions (138 can fuse), 100 loads, 1 stores */
PRT__STATIC void prt__sh_at_10(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.946174695757560018093) * t2 - PRT__R(0.315391565252520006031);
    const prt_real t4 = PRT__R(1.86588166295057695707) * t2 - PRT__R(1.11952899777034617424);
    const prt_real t5 = z * t4;
    const prt_real t6 = PRT__R(4.13572565211287073036) * t3 - PRT__R(0.745355992499929898803);
    const prt_real t7 = t3 * t6 - PRT__R(0.329110590402857834053);
    const prt_real t8 = PRT__R(1.98997487421323990947) * (z * t7) - PRT__R(1.00285307284481394976) * t5;
    const prt_real t9 = (((t1 + t3 * f[6]) + t5 * f[12]) + t7 * f[20]) + t8 * f[30];
    const prt_real t10 = PRT__R(1.99304345718356633685) * (z * t8) - PRT__R(1.00154202096221924809) * t7;
    const prt_real t11 = PRT__R(1.99489143482413445284) * (z * t10) - PRT__R(1.00092721392195810546) * t8;
    const prt_real t12 = PRT__R(1.99608992783391399988) * (z * t11) - PRT__R(1.00060078106951479479) * t10;
    const prt_real t13 = PRT__R(1.99691119506793649529) * (z * t12) - PRT__R(1.000411437993133759) * t11;
    const prt_real t14 = (((t9 + t10 * f[42]) + t11 * f[56]) + t12 * f[72]) + t13 * f[90];
    const prt_real t15 = PRT__R(1.09254843059207907054) * z;
    const prt_real t16 = PRT__R(2.28522899732232868079) * t2 - PRT__R(0.457045799464465736158);
    const prt_real t17 = (PRT__R(0.488602511902919921586) * f[1] + t15 * f[5]) + t16 * f[11];
    const prt_real t18 = PRT__R(4.68332580490102417566) * t2 - PRT__R(2.00713963067186750386);
    const prt_real t19 = z * t18;
    const prt_real t20 = PRT__R(1.82140655598655998134) * t16 - PRT__R(1.10995495404092863574);
    const prt_real t21 = t16 * t20 - PRT__R(0.434828785147869044447);
    const prt_real t22 = PRT__R(2.02131498923702777609) * (z * t21) - PRT__R(0.995226703056238577025) * t19;
    const prt_real t23 = PRT__R(2.01556443707463741309) * (z * t22) - PRT__R(0.997155044021832052319) * t21;
    const prt_real t24 = (((t17 + t19 * f[19]) + t21 * f[29]) + t22 * f[41]) + t23 * f[55];
    const prt_real t25 = PRT__R(2.01186954040739123146) * (z * t23) - PRT__R(0.998166817890174275952) * t22;
    const prt_real t26 = PRT__R(2.00935312974101194944) * (z * t25) - PRT__R(0.998749217771908945789) * t23;
    const prt_real t27 = (PRT__R(0.488602511902919921586) * f[3] + t15 * f[7]) + t16 * f[13];
    const prt_real t28 = (((t27 + t19 * f[21]) + t21 * f[31]) + t22 * f[43]) + t23 * f[57];
    const prt_real t29 = y * ((t24 + t25 * f[71]) + t26 * f[89]) + x * ((t28 + t25 * f[73]) + t26 * f[91]);
    const prt_real t30 = y * x;
    const prt_real t31 = t30 + t30;
    const prt_real t32 = PRT__R(1.44530572132027702769) * z;
    const prt_real t33 = PRT__R(3.31161143515146006332) * t2 - PRT__R(0.473087347878780009046);
    const prt_real t34 = (PRT__R(0.546274215296039535272) * f[4] + t32 * f[10]) + t33 * f[18];
    const prt_real t35 = PRT__R(7.1903051774599856325) * t2 - PRT__R(2.3967683924866618775);
    const prt_real t36 = z * t35;
    const prt_real t37 = PRT__R(1.38599481613688115647) * t33 - PRT__R(1.19217565770897169497);
    const prt_real t38 = t33 * t37 - PRT__R(0.413602361414863611859);
    const prt_real t39 = PRT__R(2.08166599946613273528) * (z * t38) - PRT__R(0.984731927834661861874) * t36;
    const prt_real t40 = PRT__R(2.06155281280883027491) * (z * t39) - PRT__R(0.990337937660287135802) * t38;
    const prt_real t41 = (((t34 + t36 * f[28]) + t38 * f[40]) + t39 * f[54]) + t40 * f[70];
    const prt_real t42 = PRT__R(2.0481223583578191106) * (z * t40) - PRT__R(0.993485272670404014071) * t39;
    const prt_real t43 = (y + x) * (x - y);
    const prt_real t44 = (PRT__R(0.546274215296039535272) * f[8] + t32 * f[14]) + t33 * f[22];
    const prt_real t45 = (((t44 + t36 * f[32]) + t38 * f[44]) + t39 * f[58]) + t40 * f[74];
    const prt_real t46 = (t14 + t29) + (t31 * (t41 + t42 * f[88]) + t43 * (t45 + t42 * f[92]));
    const prt_real t47 = y * y;
    const prt_real t48 = t43 + t47;
    const prt_real t49 = y * (t43 + (t48 + t48));
    const prt_real t50 = PRT__R(1.77013076977993053104) * z;
    const prt_real t51 = PRT__R(4.40314469491725348916) * t2 - PRT__R(0.489238299435250387684);
    const prt_real t52 = (PRT__R(0.590043589926643510346) * f[9] + t50 * f[17]) + t51 * f[27];
    const prt_real t53 = PRT__R(10.1332578546641584906) * t2 - PRT__R(2.76361577854477049742);
    const prt_real t54 = z * t53;
    const prt_real t55 = PRT__R(1.15401243699174093424) * t51 - PRT__R(1.21603371550977803267);
    const prt_real t56 = t51 * t55 - PRT__R(0.401771089424162456772);
    const prt_real t57 = PRT__R(2.15322168769582022424) * (z * t56) - PRT__R(0.975217386560017729543) * t54;
    const prt_real t58 = PRT__R(2.11804417118980573708) * (z * t57) - PRT__R(0.983662844979209628271) * t56;
    const prt_real t59 = (((t52 + t54 * f[39]) + t56 * f[53]) + t57 * f[69]) + t58 * f[87];
    const prt_real t60 = x * (t43 - (t47 + t47));
    const prt_real t61 = (PRT__R(0.590043589926643510346) * f[15] + t50 * f[23]) + t51 * f[33];
    const prt_real t62 = (((t61 + t54 * f[45]) + t56 * f[59]) + t57 * f[75]) + t58 * f[93];
    const prt_real t63 = t43 * t31;
    const prt_real t64 = t63 + t63;
    const prt_real t65 = PRT__R(2.075662314881041279) * z;
    const prt_real t66 = PRT__R(5.5502139080159657518) * t2 - PRT__R(0.504564900728724159254);
    const prt_real t67 = (PRT__R(0.625835735449176134587) * f[16] + t65 * f[26]) + t66 * f[38];
    const prt_real t68 = PRT__R(13.4918050467267683135) * t2 - PRT__R(3.11349347232156191849);
    const prt_real t69 = z * t68;
    const prt_real t70 = PRT__R(1.0094855015668566765) * t66 - PRT__R(1.22244228452440165368);
    const prt_real t71 = t66 * t70 - PRT__R(0.395385557652339419216);
    const prt_real t72 = PRT__R(2.22917715070623519765) * (z * t71) - PRT__R(0.967152839723182214167) * t69;
    const prt_real t73 = (t43 + t31) * (t43 - t31);
    const prt_real t74 = (PRT__R(0.625835735449176134587) * f[24] + t65 * f[34]) + t66 * f[46];
    const prt_real t75 = t64 * (((t67 + t69 * f[52]) + t71 * f[68]) + t72 * f[86]) + t73 * (((t74 + t69 * f[60]) + t71 * f[76]) + t72 * f[94]);
    const prt_real t76 = PRT__R(2.36661916223175203199) * z;
    const prt_real t77 = PRT__R(6.74590252336338415674) * t2 - PRT__R(0.518915578720260319749);
    const prt_real t78 = (PRT__R(0.656382056840170102814) * f[25] + t76 * f[37]) + t77 * f[51];
    const prt_real t79 = PRT__R(17.2495531104905400876) * t2 - PRT__R(3.44991062209810801752);
    const prt_real t80 = z * t79;
    const prt_real t81 = PRT__R(0.910342823558204599004) * t77 - PRT__R(1.22265924807669582645);
    const prt_real t82 = t77 * t81 - PRT__R(0.392209739345009019975);
    const prt_real t83 = (PRT__R(0.656382056840170102814) * f[35] + t76 * f[47]) + t77 * f[61];
    const prt_real t84 = (y * t73 + x * t64) * ((t78 + t80 * f[67]) + t82 * f[85]) + (x * t73 - y * t64) * ((t83 + t80 * f[77]) + t82 * f[95]);
    const prt_real t85 = t60 * t49;
    const prt_real t86 = t85 + t85;
    const prt_real t87 = PRT__R(2.64596066180190022197) * z;
    const prt_real t88 = PRT__R(7.98499149089313861467) * t2 - PRT__R(0.532332766059542574311);
    const prt_real t89 = (PRT__R(0.683184105191914321975) * f[36] + t87 * f[50]) + t88 * f[66];
    const prt_real t90 = PRT__R(21.3928901909086362545) * t2 - PRT__R(3.77521591604270051551);
    const prt_real t91 = z * t90;
    const prt_real t92 = (t60 + t49) * (t60 - t49);
    const prt_real t93 = (PRT__R(0.683184105191914321975) * f[48] + t87 * f[62]) + t88 * f[78];
    const prt_real t94 = (((t46 + (t49 * t59 + t60 * t62)) + t75) + t84) + (t86 * (t89 + t91 * f[84]) + t92 * (t93 + t91 * f[96]));
    const prt_real t95 = PRT__R(2.91570664069931947548) * z;
    const prt_real t96 = PRT__R(9.26339318284890424012) * t2 - PRT__R(0.544905481344053190595);
    const prt_real t97 = (PRT__R(0.707162732524596178226) * f[49] + t95 * f[65]) + t96 * f[83];
    const prt_real t98 = (PRT__R(0.707162732524596178226) * f[63] + t95 * f[79]) + t96 * f[97];
    const prt_real t99 = t94 + ((y * t92 + x * t86) * t97 + (x * t92 - y * t86) * t98);
    const prt_real t100 = t73 * t64;
    const prt_real t101 = t100 + t100;
    const prt_real t102 = PRT__R(3.1773176489546974773) * z;
    const prt_real t103 = t101 * (PRT__R(0.72892666017482986887) * f[64] + t102 * f[82]);
    const prt_real t104 = (t73 + t64) * (t73 - t64);
    const prt_real t105 = t104 * (PRT__R(0.72892666017482986887) * f[80] + t102 * f[98]);
    const prt_real t106 = (y * t104 + x * t101) * (PRT__R(0.74890095185318829655) * f[81]);
    const prt_real t107 = (x * t104 - y * t101) * (PRT__R(0.74890095185318829655) * f[99]);
    out[0] = (t99 + (t103 + t105)) + (t106 + t107);
}

/* END GENERATED */

#ifndef PRT_NO_CH
/* BEGIN GENERATED: prt_codegen --table ch_steps --bands 64 */
/* a(l,m) of CH's recurrence at (l-1)l/2 + m, 0 <= m < l < 64 */
PRT__STATIC const double *prt__ch_a(void) {
    static const double table[2016] = {
        1.7320508075688773, 1.6903085094570332, 2.2360679774997897, 1.9603921176392137, 2.0367003088692622,
        2.6457513110645906, 1.987054880161641, 2.0124611797498107, 2.2677868380553634, 3.0, 1.9941605714785483,
        2.0057061456896279, 2.1480763975561548, 2.4742148513083464, 3.3166247903553998, 1.9968676566524542,
        2.0030840419244385, 2.093975861212525, 2.2860032725192412, 2.6653001963403713, 3.6055512754639893,
        1.9981247065730925, 2.0018544278439162, 2.0648507494718002, 2.1930991604053257, 2.4199173539606678,
        2.8442727788398633, 3.8729833462074169, 1.9987882458748263, 2.0012015621390296, 2.047379529757828,
        2.1396076962767153, 2.2935777499036682, 2.5488050711208436, 3.0131410643329466, 4.1231056256176605,
        1.9991716711179193, 2.0008228759862675, 2.0360862262771316, 2.1057755982810943, 2.218229463386103,
        2.392743487091899, 2.6726782978341193, 3.1733883113702302, 4.3588989435406736, 1.9994087213470191,
        2.0005881488143607, 2.0283727587492686, 2.0829514014290433, 2.1691371702312855, 2.2975809211965715,
        2.489681609607561, 2.7918297807334465, 3.3261711672952644, 4.58257569495584, 1.9995631757073595,
        2.0004349244370213, 2.0228756280593875, 2.0668031220608441, 2.135169204294917, 2.234364341093652,
        2.3763520512790265, 2.5840925137151841, 2.9066231496347656, 3.4724151686597994, 4.7958315233127195,
        1.9996681324128817, 2.0003306604965968, 2.0188230895717833, 2.0549499841938526, 2.1106076971797445,
        2.1898710720001093, 2.3000188597580234, 2.4539475610035392, 2.6759285308831015, 3.0174214732350599,
        3.6128740199357416, 5.0, 1.9997419521310465, 2.0002572512712421, 2.0157517624457893, 2.0459897937207067,
        2.092235193547692, 2.1572101961375751, 2.2456238038364519, 2.3653686334802338, 2.5300967999106967,
        2.7652519438950143, 3.1245624282254788, 3.7481702853265456, 5.1961524227066319, 1.9997953859527103,
        2.0002040712213872, 2.0133698572941911, 2.0390510250379894, 2.0781152516843035, 2.1324496102708735,
        2.2052465430500704, 2.3016462162936614, 2.4300238363185462, 2.6046902896750347, 2.8521724887444233,
        3.2283511329073853, 3.8788245800491614, 5.385164807134504, 1.9998350175291068, 2.0001646022800203,
        2.0114862789168185, 2.0335680249559994, 2.0670202311006564, 2.1131910060937211, 2.174326097205249,
        2.2539350957211679, 2.3574895981102861, 2.4937755696335927, 2.6777027651120201, 2.9368178896385568,
        3.3290599361299711, 4.0052770471494781, 5.5677643628300219, 1.9998650335727451, 2.0001346937402612,
        2.0099716802712954, 2.0291603287173019, 2.0581388191008205, 2.0978946489369149, 2.1500556791678385,
        2.2171089919415506, 2.3028041293594267, 2.4128889250727459, 2.5565163102398522, 2.7491539651233711,
        3.0193194920611515, 3.4269308426876317, 4.1279034532199262, 5.7445626465380287, 1.999888183825703,
        2.0001116164858419, 2.0087360112832277, 2.025564241553627, 2.0509162377594557, 2.0855308343430844,
        2.1306177107677025, 2.1879931834420182, 2.2603250221480068, 2.3515593401801365, 2.4676866222622542,
        2.618197572032403, 2.8190875376835237, 3.0998052480889232, 3.5221787608121024, 4.2470274396897419,
        5.916079783099616, 1.9999063253787454, 2.0000935256845422, 2.0077150376160533, 2.0225922605427948,
        2.0449621317650367, 2.0753875749247145, 2.1147865775535763, 2.1645190110010805, 2.2265414000683474,
        2.3036675527308525, 2.4000136201368254, 2.5217906149422093, 2.6788060690236118, 2.8875592610498963,
        3.178396433309722, 3.6149948085103255, 4.362929977484055, 6.0827625302982197, 1.9999207434266268,
        2.0000791436655699, 2.0068619572722981, 2.020108074151275, 2.0399950706610667, 2.0669586578767822,
        2.1017081017176468, 2.145283081406223, 2.1991548508812979, 2.2653921176161495, 2.3469333460226598,
        2.4480473067647716, 2.575149959560271, 2.738349717326816, 2.9546303110950515, 3.2552063032174443,
        3.7055493746078802, 4.4758567557484005, 6.2449979983983982, 1.999932346723025, 2.0000675664262621,
        2.0061420264282919, 2.0180106484142029, 2.0358078453837526, 2.0598755542698558, 2.0907703831753223,
        2.129301561634211, 2.176598930219687, 2.2342222203786958, 2.3043348429423875, 2.3899858552992532,
        2.4955845009388467, 2.6277400784241613, 2.7968491500628209, 3.0203633710003392, 3.3303397642338529,
        3.7939948340696669, 4.5860240231632232, 6.4031242374328487, 1.9999417902411216, 2.0000581420701607,
        2.0055290212410304, 2.0162238061976502, 2.0322450680070691, 2.0538644455787339, 2.0815247511471897,
        2.1158656712307605, 2.1577705482031798, 2.2084404948503145, 2.2695092716009845, 2.343223437350252,
        2.4327328728453352, 2.5425783726157127, 2.6795535116365342, 2.8543324514260623, 3.0848203899262783,
        3.4038935677002252, 3.8804679064312172, 4.6936232553890239, 6.5574385243020007, 1.9999495541851029,
        2.0000503924310649, 2.0050028527938297, 2.0146892318661692, 2.0291883103429987, 2.0487182364878781,
        2.0736355692403066, 2.10445286536852, 2.1418715171642559, 2.1868332773187392, 2.2405984787989204,
        2.3048652933379769, 2.3819553989926986, 2.4751123829665493, 2.5890017401552189, 2.7305939702025162,
        2.9108318336861601, 3.1480613192020396, 3.4759567604042175, 3.9650916830250622, 4.7988249214398157,
        6.7082039324993691, 1.9999559960836461, 2.0000439613579717, 2.0045479251846476, 2.0133616710284391,
        2.0265460043910163, 2.0442778265929505, 2.0668473477160692, 2.0946701967677002, 2.1283108670882349,
        2.1685193080762345, 2.2162855517205321, 2.2729210656372762, 2.3401817313812521, 2.4204585196947219,
        2.5170833206961259, 2.634840867361349, 2.7808724312440756, 2.9663815185451333, 3.2101434364525989,
        3.5466112459922502, 4.0479773614333982, 4.9017815507497001, 6.8556546004010441, 1.9999613858614296,
        2.0000385798748119, 2.0041519836677429, 2.0122055713438272, 2.0242464316233298, 2.040419277599226,
        2.0609626055839458, 2.0862170484960421, 2.1166423600729684, 2.152843886309669, 2.1956115594550056,
        2.2459768377519717, 2.305296664358334, 2.3753797709314539, 2.4586820277415618, 2.5586193750849749,
        2.6800912887332636, 2.8304045318165478, 3.0210163812602374, 3.271121025985478, 3.6159323779301382,
        4.1292257274704379, 5.0026302519380342, 7.0, 1.9999659299007684, 2.0000340422634726, 2.0038052926981451,
        2.0111926900176813, 2.0222327635541778, 2.0370448346880437, 2.0558266138404546, 2.0788599420449,
        2.1065232474073084, 2.1393110070040292, 2.1778621183295637, 2.2230006479744084, 2.2757946577236756,
        2.3376424565845098, 2.4104019753978065, 2.496590557865065, 2.5997047421487252, 2.7247549485700321,
        2.8792088077926733, 3.0747710862146434, 3.3310452749437799, 3.6839895416885056, 4.208928422254374,
        5.1014947975505391, 7.14142842854285, 1.9999697878350701, 2.0000301893627797, 2.0035000402526377,
        2.0103003624726671, 2.0204594934122305, 2.034076526844183, 2.05131666086343, 2.0724151032640838,
        2.0976863029919753, 2.1275384629267262, 2.1624945316418604, 2.2032219369486685, 2.2505747391863252,
        2.3056540913218425, 2.3698965844529874, 2.4452065181467942, 2.5341599572343058, 2.6403311599533935,
        2.7688382111488163, 2.927305493430349, 3.1276795433646853, 3.3899642987438735, 3.7508467046890334,
        4.2871690275249656, 5.1984873621640006, 7.2801098892805183, 1.9999730844542524, 2.0000268967233079,
        2.0032299000075083, 2.0095102312431744, 2.0188898291239269, 2.031451528951907, 2.0473343593970253,
        2.066736145307945, 2.0899204086910123, 2.1172273270405289, 2.1490894970431469, 2.1860540048413059,
        2.2288132313190908, 2.2782482034699561, 2.335490528423859, 2.4020126966707014, 2.4797631197972959,
        2.571374314730463, 2.6804958062968205, 2.8123504599888287, 2.9747156990431047, 3.1797745762302447,
        3.447923241996366, 3.8165629243237995, 4.3640239976621433, 5.2937099813360648, 7.4161984870956629,
        1.999975918266596, 2.0000240660854716, 2.0029897053609066, 2.0088073003678586, 2.0174937619890937,
        2.0291187499448621, 2.043800041895723, 2.0617052058670589, 2.083056795463376, 2.1081407162148194,
        2.1373182205086192, 2.1710425399864918, 2.2098817910701528, 2.2545506809246683, 2.3059549264104547,
        2.3652545542260984, 2.4339560641789559, 2.5140501353224764, 2.6082238235103962, 2.7201997882655785,
        2.8553031023555345, 3.0214608471380299, 3.231087730192553, 3.5049644212353517, 3.8811928109529228,
        4.4395634624559492, 5.3872557839903281, 7.5498344352707497, 1.9999783677376433, 2.0000216191675546,
        2.0027752038326896, 2.0081792233742334, 2.0162466176788009, 2.0270362885892505, 2.0406486164283742,
        2.0572264647432216, 2.0769591127080553, 2.1000887053272293, 2.1269194888967064, 2.1578305161208676,
        2.1932929415933737, 2.2338936194342358, 2.2803676021173893, 2.3336435396944734, 2.39490826948258,
        2.4657007654840936, 2.5480524330563599, 2.6447032222404444, 2.7594470449272468, 2.8977088566696995,
        3.0675622872318915, 3.2816491740475021, 3.5611274883566622, 3.9447869463916443, 4.5138519207889889,
        5.4792100395765563, 7.6811457478686082, 1.9999804958919468, 2.0000194930823928, 2.0025828699875633,
        2.0076157611556976, 2.0151279564086987, 2.0251695126471667, 2.0378264611833302, 2.0532213321912349,
        2.0715161427122951, 2.0929174127773808, 2.1176833518723564, 2.146133682608794, 2.1786628808033463,
        2.2157580131621376, 2.2580229369536805, 2.3062115198807983, 2.3612739581470449, 2.4244225986496574,
        2.4972276161125296, 2.5817598294120717, 2.680810645026039, 2.7982435427485485, 2.9395812399430745,
        3.1130410353054565, 3.3314876633853922, 3.6164496016143499, 4.0073922602748446, 4.5869488420650203,
        5.5696510527666164, 7.8102496759066544, 1.9999823537456377, 2.0000176369175963, 2.0024097614865862,
        2.0071083649427443, 2.0141207291825332, 2.0234895921668075, 2.0352890687201352, 2.049624829566654,
        2.0666363766859802, 2.0865009741150626, 2.1094392935514173, 2.1357230936229139, 2.1656854813213232,
        2.1997345841408482, 2.2383718539871722, 2.2822168090571181, 2.3320409245654018, 2.3888148244402072,
        2.4537752916762428, 2.5285226251820338, 2.6151659200511631, 2.7165467643190564, 2.8365966811700998,
        2.9809341981980183, 3.1579176008015815, 3.3806305446156262, 3.6709655960914497, 4.0690523675650581,
        4.6589091894195652, 5.6586509318465589, 7.9372539331937718, 1.9999839828937302, 2.0000160091572382,
        2.0022534072790132, 2.0066498524367534, 2.0132106240720307, 2.0219723678173425, 2.0329992389174786,
        2.0463828336932692, 2.0622439228287295, 2.0807355524521781, 2.1020475175758839, 2.1264124247952616,
        2.1541137342976781, 2.1854963708137977, 2.2209807631897412, 2.2610815641516856, 2.3064328927797984,
        2.3578228594834319, 2.4162415966610927, 2.4829494214132555, 2.5595758314005799, 2.6482671980520972,
        2.7519141466376975, 2.8745148508157887, 3.021781840056092, 3.2022118754060485, 3.4291037852663186,
        3.7247081488084343, 4.129807870777376, 4.7297838764190563, 5.7462762518453179, 8.0622577482985497,
        1.9999854174793382, 2.0000145757190386, 2.0021117199958739, 2.0062341540613564, 2.0123855550848864,
        2.020597469308259, 2.030925678546209, 2.0434499555146217, 2.0582753818998847, 2.0755348092655482,
        2.0953924313934445, 2.1180486139619683, 2.1437462611778693, 2.1727791443396878, 2.2055028069284868,
        2.2423489288255755, 2.2838444270144095, 2.3306371685023572, 2.3835311017884267, 2.4435350989174187,
        2.5119322406923492, 2.5903804161103739, 2.6810623825687538, 2.7869167646927138, 2.9120071036950236,
        3.0621382453572647, 3.2459430655398348, 3.4769320207684433, 3.7777079357181166, 4.1896966304836612,
        4.7996201670256819, 5.8325886294374443, 8.18535277187245, 1.9999866857061068, 2.0000133084465385,
        2.0019829267445696, 2.0058561125069657, 2.0116352591138466, 2.0193476224946885, 2.0290419056724475,
        2.040787890386028, 2.0546774351576959, 2.0708264381155835, 2.0893777099325158, 2.1105048529181477,
        2.1344173478943442, 2.1613671585790886, 2.1916572989311225, 2.2256529957466317, 2.2637963479260684,
        2.3066257829409096, 2.3548022175425339, 2.4091447739217214, 2.4706804105051001, 2.5407143040638813,
        2.620932021222187, 2.7135519036772914, 2.8215596256733291, 2.9490829063174425, 3.1020173287021527,
        3.2891296557762697, 3.5241386110435156, 3.8299937791719194, 4.2487540074782692, 4.8684620270107834,
        5.9176452235041766, 8.3066238629180749, 1.9999878110097054, 2.0000121839409567, 2.0018655140209978,
        2.0055113231530661, 2.0109509755895022, 2.0182081002686914, 2.0273253850190437, 2.0383641231065021,
        2.0514049633806827, 2.0665494825921587, 2.0839225106748369, 2.1036752697733691, 2.125989472926203,
        2.1510826103168941, 2.1792147499446279, 2.210697312168237, 2.2459044645078481, 2.2852880547002619,
        2.3293974041338527, 2.3789058987268167, 2.4346472721019884, 2.4976660059809818, 2.5692887867256407,
        2.6512282204284642, 2.7457375043393101, 2.8558484866126991, 2.9857519546742957, 3.1414327434063231,
        3.3317893940702956, 3.5707457023422739, 3.8815927852921082, 4.307013079725591, 4.9363504336828234,
        6.0014991727360148, 8.4261497731763586, 1.999988812972477, 2.0000111826490019, 2.0017581835447652,
        2.0051960061143065, 2.0103251899786232, 2.0171662840391474, 2.0257568400435959, 2.0361509025941495,
        2.0484195663639511, 2.0626522401077819, 2.0789585396206226, 2.0974708453821302, 2.1183476305741446,
        2.1417777285660966, 2.1679857823486982, 2.1972392140946526, 2.2298571851123533, 2.2662222047231658,
        2.3067953213089631, 2.3521362382205965, 2.4029303207009154, 2.4600254313316573, 2.5244830834493792,
        2.5976509520360806, 2.6812681062801101, 2.7776219310166817, 2.8897896355805584, 3.0220240356985558,
        3.1803978153026705, 3.3739392922671046, 3.6167742912485164, 3.932530471216762, 4.3645048369171004,
        5.003323649707449, 6.0841999796627494, 8.5440037453175312, 1.9999897080429071, 2.0000102881452275,
        2.0016598166131295, 2.0049069029479985, 2.0097514269778766, 2.0162113110036752, 2.0243197014693507,
        2.0341244235307014, 2.0456883875938945, 2.0590906083586661, 2.0744277539376263, 2.0918162429635252,
        2.1113949660698876, 2.133328758063845, 2.1578128024567983, 2.185078220180317, 2.2153991891485292,
        2.2491020740355802, 2.2865772358086194, 2.328294468664692, 2.3748234269008395, 2.4268610362388377,
        2.4852688689396178, 2.5511250355947687, 2.6257977321343944, 2.7110519656715574, 2.8092086919661891,
        2.9233897230101244, 3.0579089238480505, 3.21892549864168, 3.415595637185886, 3.6622442887780132,
        3.98283088250871, 4.4212583551710244, 5.0694174658959839, 6.1657938488919917, 8.6602540378443865,
        1.9999905101055513, 2.0000094865634687, 2.0015694451482313, 2.0046411927385774, 2.0092240826887515,
        2.0153337885139513, 2.0229996620778137, 2.0322641683123688, 2.0431831737512506, 2.0558267697953234,
        2.0702805464724356, 2.0866473219194729, 2.1050493824581279, 2.1256313281470266, 2.1485636611096265,
        2.1740473061518126, 2.2023193222906909, 2.2336601588243445, 2.2684029434272541, 2.3069454821081715,
        2.3497659324976588, 2.3974435322866083, 2.4506864051144077, 2.5103694643430266, 2.5775870300630581,
        2.6537273954628382, 2.7405810233628062, 2.8405018676031016, 2.9566556314620094, 3.0934163043612178,
        3.2570283483650837, 3.4567740088806863, 3.7071745832082403, 4.0325167012082702, 4.4773009541268831,
        5.1346654170909546, 6.2463239860398571, 8.7749643873921221, 1.9999912309355057, 2.000008766143401,
        2.0014862280403656, 2.0043964235149598, 2.0087382875919679, 2.0145255613082877, 2.0217843149106633,
        2.0305523742143358, 2.0408795165441885, 2.0528281367021637, 2.0664742987950299, 2.0819091701600826,
        2.0992408763582273, 2.1185968487949592, 2.1401267695435144, 2.1640062573610298, 2.1904414899571892,
        2.2196750265797933, 2.2519931906497724, 2.287735507436433, 2.3273068864266518, 2.3711935232468982,
        2.4199839218160229, 2.4743970863004734, 2.5353209437594063, 2.6038656743739186, 2.6814392816248254,
        2.7698572382695131, 2.8715059612038036, 2.9895943750311391, 3.1285557168494525, 3.2947185044997716,
        3.4974893036201764, 3.7515831007658695, 4.0816093451097461, 4.5326583384276996, 5.1990989746552818,
        6.3258308627826823, 8.8881944173155889, 1.9999918805630829, 2.000008116866646, 2.0014094317095484,
        2.0041704558818651, 2.0082897940234705, 2.0137795206975774, 2.0206628574308284, 2.0289735991295241,
        2.0387562373000927, 2.0500664990224465, 2.0629722188443321, 2.07755453351302, 2.0939094266950895,
        2.1121496777938957, 2.1324072950553163, 2.1548365433177436, 2.1796177150018565, 2.2069618437317548,
        2.2371166293280137, 2.2703739394791057, 2.307079390185642, 2.3476447041049836, 2.392563834715171,
        2.4424342754694078, 2.4979856303409599, 2.5601185465019538, 2.6299587467258563, 2.7089335888228739,
        2.7988831409698249, 2.902225781057584, 3.0222130217333867, 3.1633365144429377, 3.3320076854961737,
        3.537755759808394, 3.7954868636405336, 4.1301290588846329, 4.5873547253477498, 5.2627477185529591,
        6.404352452596488, 9.0, 1.9999924675681732, 2.0000075301630092, 2.0013384140480296, 2.0039614164420109,
        2.0078748832676546, 2.0130894472660983, 2.0196258482077377, 2.0275143654820075, 2.036794884209126,
        2.0475173312349176, 2.0597424003384797, 2.0735425521872352, 2.0890033073685181, 2.1062248734486806,
        2.1253241679126341, 2.1464373222283379, 2.1697227812751092, 2.1953651502402567, 2.223579992023287,
        2.2546198481006659, 2.2887818533879452, 2.3264174540152943, 2.3679449363578302, 2.4138657680294207,
        2.4647861881899575, 2.5214461499921487, 2.584758755214324, 2.6558649785593982, 2.7362112026461219,
        2.8276617036141511, 2.9326663472766269, 3.0545186337868448, 3.197767834857049, 3.3689071881299936,
        3.5775869855634824, 3.8389020450301544, 4.178094997681166, 4.6414129601137545, 5.3256394915750223,
        6.4819244410425396, 9.1104335791442989, 1.9999929993191838, 2.000006998672002, 2.0012726110887095,
        2.0037676591136408, 2.0074902884528243, 2.0124498805144518, 2.0186650057029224, 2.0261628665655845,
        2.0349793191132906, 2.0451592249796209, 2.056757056433488, 2.0698377368124694, 2.0844777281017274,
        2.1007663966189603, 2.1188077047495871, 2.1387222950475188, 2.1606500552657728, 2.1847532814445481,
        2.211220594055309, 2.2402718134773166, 2.2721640716745705, 2.3071995356037947, 2.3457352578819775,
        2.3881958720615391, 2.4350901457821025, 2.4870328470475358, 2.5447740525105768, 2.6092390765952656,
        2.6815838780626023, 2.7632735575880351, 2.8561962354596561, 2.9628328180387519, 3.0865182218816128,
        3.2318585806049353, 3.4054278921761964, 3.6169959870331011, 3.8818440210861463, 4.2255253038140478,
        4.6948546202813577, 5.3878005379004173, 6.5585804138725159, 9.2195444572928873, 1.9999934821680264,
        2.0000065160482123, 2.001211525883686, 2.0035877328508067, 2.0071331302491304, 2.011856010289562,
        2.0177730410095425, 2.0249087230546633, 2.0332953759626681, 2.0429734218288793, 2.0539918913625747,
        2.0664091329688262, 2.0802937316285469, 2.0957256609055518, 2.1127977053926638, 2.1316172055158276,
        2.1523081938848755, 2.1750140141691219, 2.1999005419585527, 2.2271601651369147, 2.2570167330198098,
        2.2897317548390413, 2.3256122279257201, 2.3650206175700777, 2.4083877147404853, 2.4562293972899828,
        2.5091687675428522, 2.5679658208549239, 2.6335578622701409, 2.7071155862737867, 2.7901225246270744,
        2.8844902987786407, 2.9927304312150404, 3.1182187104196315, 3.2656174062272556, 3.441580268504851,
        3.655995196790287, 3.9243274197378072, 4.2724371771290803, 4.7477001103648241, 5.4492556278748468,
        6.634352025741676, 9.327379053088815, 1.9999939216100439, 2.0000060768016578, 2.0011547191843206,
        2.0034203545838283, 2.006800862995278, 2.0113035859319913, 2.0169435181355593, 2.0237427800860975,
        2.0317305769997278, 2.0409434263577948, 2.0514255821327203, 2.0632296351691439, 2.0764172927799523,
        2.09106035502508, 2.1072419167992242, 2.1250578366078603, 2.1446185264645723, 2.1660511341431935,
        2.1895022106723747, 2.2151409845374175, 2.2431634024129998, 2.27379714848216, 2.3073079264919722,
        2.344007389588905, 2.3842632462284255, 2.4285122770274947, 2.4772773003671221, 2.5311895770458819,
        2.5910188339647715, 2.6577141617904914, 2.7324607592930439, 2.8167603196757456, 2.9125476410457092,
        3.0223644582272616, 3.1496269113792971, 3.2990527108983704, 3.4773743895793403, 3.6945965018483146,
        3.9663661664494453, 4.3188469395910651, 4.7999687477740277, 5.5100281706318869, 6.7092691519142185,
        9.4339811320566038, 1.9999943224158121, 2.0000056761662038, 2.0011018015972039, 2.0032643864374409,
        2.0064912293643938, 2.0107888399076975, 2.0161707367537727, 2.022656937337157, 2.0302738957257367,
        2.0390546840144396, 2.0490393486043641, 2.0602754202035806, 2.0728185778303953, 2.0867334797652438,
        2.102094784233486, 2.1189883921681915, 2.1375129551532485, 2.1577817047336165, 2.1799246759110147,
        2.2040914193247207, 2.2304543253808715, 2.2592127222986378, 2.2905979628081466, 2.3248797871116599,
        2.3623743517365405, 2.4034544587788773, 2.4485627289613264, 2.4982287683260992, 2.5530918360520975,
        2.613931218455403, 2.6817076014976137, 2.7576204715216006, 2.8431894288236058, 2.9403721401899661,
        3.0517401676618335, 3.1807495049736083, 3.3321726351400034, 3.5128199415871028, 3.7328112709763532,
        4.0079735270120623, 4.3647700946036606, 4.8516788409868398, 5.5701403159615088, 6.7833600250068251,
        9.5393920141694565, 1.9999946887402621, 2.0000053099906146, 2.0010524269550935, 2.0031188164712802,
        2.0062022220562122, 2.0103084233410296, 2.0154496333734203, 2.0216440060852816, 2.0289155579955825,
        2.037294311597278, 2.0468165950024916, 2.0575254764631042, 2.0694713319768206, 2.0827125554230108,
        2.0973164290648091, 2.1133601801284119, 2.1309322577873543, 2.1501338751732259, 2.1710808739322906,
        2.1939059854609815, 2.2187615847474209, 2.24582306174609, 2.2752929742927337, 2.3074061998833042,
        2.3424363773047545, 2.3807040322446048, 2.4225869274845985, 2.468533389538219, 2.5190796734135432,
        2.5748728899706791, 2.6367017257183182, 2.705538284322437, 2.7825961359237778, 2.8694125471584222,
        2.967967760375492, 3.0808627966913076, 3.2115930256655327, 3.3649850606578926, 3.5479262376221822,
        3.7706503811030581, 4.0491621475013699, 4.4102213815294512, 4.9028477607748814, 5.6296130466449994,
        6.8566513585322453, 9.643650760992955, 1.9999950242134214, 2.0000049746479504, 2.0010062866926283,
        2.0029827423341056, 2.0059320512978212, 2.0098593513733454, 2.0147756976912639, 2.0206975884453178,
        2.0276468743559036, 2.0356508706843117, 2.0447426095058748, 2.0549612109321836, 2.0663523699605775,
        2.0789689656749461, 2.0928718067575445, 2.108130533823093, 2.1248247060621699, 2.1430451078543568,
        2.1628953211068332, 2.1844936219240774, 2.2079752768895366, 2.2334953361937457, 2.2612320501070866,
        2.2913910747658879, 2.3242106871147627, 2.3599683033001491, 2.3989886990656298, 2.4416544787733916,
        2.4884195532386625, 2.5398266997754205, 2.5965307457054209, 2.6593296296794274, 2.7292067066198017,
        2.807389438134679, 2.8954325286125711, 2.9953385162969344, 3.1097375287600433, 3.2421638524094877,
        3.3974976125358108, 3.5827022314826206, 3.8081242426725656, 4.0899440915510255, 4.4552148258388874,
        4.9534920052043549, 5.6884662623166947, 6.9291684587651397, 9.7467943448089639, 1.9999953320161839,
        2.0000046669599073, 2.000963105056631, 2.0028553573389159, 2.0056791171676669, 2.0094389566706374,
        2.0141449015095363, 2.019811974924504, 2.026460098115553, 2.0341141763188918, 2.0428043113250023,
        2.0525661194111044, 2.0634411502458261, 2.0754774113723699, 2.0887300091761498, 2.1032619227504659,
        2.1191449327762057, 2.1364607340807634, 2.1553022685127947, 2.1757753247969813, 2.1980004649091553,
        2.222115353292688, 2.2482775873761546, 2.2766681573950023, 2.3074957033890074, 2.3410017916815114,
        2.3774675083841938, 2.4172217728357751, 2.4606519235385067, 2.5082173450046825, 2.5604672204923644,
        2.6180639684766436, 2.6818146414398536, 2.7527136889285641, 2.8320022818791833, 2.921252344797012,
        3.0224884443845583, 3.1383694763065112, 3.2724682022249697, 3.4297176631904652, 3.617156531755325,
        3.8452428238739374, 4.1303308750981214, 4.4997637852789439, 5.0036272590495654, 5.746718855777454,
        7.0009353262495281, 9.8488578017961047, 1.9999956149438329, 2.0000043841333829, 2.0009226350125435,
        2.0027359385579122, 2.0054419859416767, 2.0090448497190112, 2.0135536381043695, 2.018982057177456,
        2.025348304712142, 2.0326751347827307, 2.0409900368176854, 2.0503255085037909, 2.0607194172932019,
        2.0722154534688651, 2.0848636832583341, 2.0987212151620759, 2.1138529973681877, 2.1303327694195726,
        2.1482441976474686, 2.1676822317765742, 2.1887547301361704, 2.2115844138548629, 2.2363112273270637,
        2.2630952045786659, 2.2921199709893743, 2.3235970501003635, 2.3577712002298321, 2.3949270816383226,
        2.4353976614507667, 2.4795749147651155, 2.5279235984895649, 2.5809991943391183, 2.6394715952513805,
        2.704156837779739, 2.7760603181667872, 2.8564367436694018, 2.9468750511881728, 3.0494215796321486,
        3.166763667541824, 3.3025121263935382, 3.4616523376220281, 3.6512974159447774, 3.8820156737062522,
        4.1703334987599418, 4.5438809924168719, 5.0532684481832241, 5.8043887825687151, 7.0719747480948466,
        9.9498743710661995, 1.9999958754594996, 2.000004123707089, 2.0008846547338306, 2.0026238366094602,
        2.0052193698070476, 2.008674884797656, 2.0129986703217948, 2.0182032534297364, 2.0243052887842464,
        2.0313256054816803, 2.0392893578575292, 2.0482262602116277, 2.0581708996417072, 2.0691631286536047,
        2.0812485441193734, 2.0944790631623483, 2.108913610467443, 2.1246189358312514, 2.141670585862777,
        2.160154060006001, 2.1801661889314763, 2.2018167834130978, 2.2252306148396226, 2.250549805565044,
        2.2779367298497724, 2.3075775562660807, 2.3396866031155886, 2.3745117339581162, 2.4123410971468341,
        2.4535116208209922, 2.4984198275834116, 2.547535753443901, 2.6014210787872215, 2.6607530618653149,
        2.7263566010960637, 2.79924789925559, 2.8806950351417973, 2.9723037593501752, 3.0761419370123544,
        3.1949250364985512, 3.3323015087156291, 3.4933085195972771, 3.6851328444660386, 3.9184519438712138,
        4.2099624779988071, 4.5875785938815252, 5.1024297894433173, 5.8614931245162313, 7.1423083820606891,
        10.04987562112089, 1.9999961157393156, 2.0000038835064568, 2.0008489645814573, 2.0025184668678495,
        2.0050101094066699, 2.0083271307193695, 2.0124770859920829, 2.0174714445045575, 2.0233254760285176,
        2.0300582829118183, 2.0376929269772859, 2.0462566317712959, 2.0557810539724397, 2.0663026246258127,
        2.0778629652451535, 2.0905093872910816, 2.1042954868269786, 2.1192818497025044, 2.1355368867384329,
        2.1531378233913924, 2.1721718746105353, 2.1927376434945316, 2.2149467924878183, 2.2389260489920512,
        2.2648196244753908, 2.2927921489231129, 2.3230322528877662, 2.3557569704738836, 2.391217192698386,
        2.4297044782338288, 2.4715596371797834, 2.5171836578220967, 2.5670517689139686, 2.6217317564466609,
        2.6819081414819075, 2.7484145688102114, 2.822277914547228, 2.9047794717065472, 2.9975416141257012,
        3.1026534966428627, 3.2228584157176075, 3.3618420653781221, 3.5246928584822072, 3.7186704743715787,
        3.9545604095062634, 4.2492278712268763, 4.6308681865945121, 5.1511248364200212, 5.918048147866658,
        7.2119568333046531, 10.148891565092219, 1.9999963377106846, 2.0000036616054126, 2.0008153844968567,
        2.0024193018738756, 2.0048131587716322, 2.0079998455896822, 2.0119862595045613, 2.0167829187594776,
        2.0224038474541068, 2.028866595420291, 2.0361923448404923, 2.0444060847859205, 2.0535368472486206,
        2.0636180045536005, 2.0746876319713335, 2.0867889423740036, 2.0999708025701579, 2.1142883438933065,
        2.1298036829822396, 2.1465867727217045, 2.164716408282298, 2.1842814194384272, 2.2053820882804069,
        2.2281318416415573, 2.2526592808096191, 2.2791106284552354, 2.3076526956863144, 2.3384765028452956,
        2.3718017291439269, 2.4078822228871778, 2.4470128823680901, 2.4895383272256985, 2.5358639358968359,
        2.5864700495658414, 2.6419304726749246, 2.7029368924778818, 2.770331590648894, 2.845151989736011,
        2.9286924464291532, 3.0225917749283395, 3.1289601920249061, 3.2505685310630916, 3.3911393460741116,
        3.5558117765035898, 3.7519176727190565, 3.9903494887859285, 4.2881393059960935, 4.6737608512558093,
        5.1993665215567976, 5.9740693565659358, 7.280939724559896, 10.246950765959598, 1.9999965430848301,
        2.0000034562938679, 2.0007837517450013, 2.0023258647624661, 2.0046275722756032, 2.007691454965544,
        2.0115238185874735, 2.0161343245389537, 2.0215358740735963, 2.0277446180709303, 2.0347800464136159,
        2.0426651388137924, 2.0514265705357799, 2.0610949722977008, 2.071705247193659, 2.0832969501359322,
        2.095914737702218, 2.1096088987295986, 2.1244359787585694, 2.1404595147000813, 2.1577509000897246,
        2.1763904062601263, 2.196468391028406, 2.2180867344855767, 2.2413605517613546, 2.2664202460023006,
        2.2934139823238484, 2.3225106866888572, 2.353903704666289, 2.3878152968997467, 2.4245022053194134,
        2.4642626032188653, 2.5074448530911536, 2.5544586534673358, 2.605789382952097, 2.662016782503922,
        2.723839614196697, 2.7921086924949382, 2.8678718651723853, 2.9524364082619172, 3.0474574004287241,
        3.1550659008019404, 3.2780599982523189, 3.4201987360881991, 3.5866714762681467, 3.7848815295159372,
        4.02582726142915, 4.3267060034107671, 4.7162671833233703, 5.2471671949164979, 6.02957154116413,
        7.3492757604162281, 10.3440804327886, 1.9999967333845647, 2.000003266049982, 2.0007539189549073,
        2.0022377235546048, 2.0044524933068808, 2.0074005328998651, 2.011087615501237, 2.01552262898993,
        2.0207174604129975, 2.0266869974021092, 2.0334492028646527, 2.0410252454650178, 2.0494396792994633,
        2.05872067158264, 2.0689002804021473, 2.0800147869517885, 2.0921050887094364, 2.1052171620933397,
        2.1194026054154538, 2.1347192756207732, 2.1512320355284925, 2.1690136322718016, 2.1881457326148578,
        2.2087201471283282, 2.2308402832549448, 2.254622877669326, 2.2802000718193732, 2.3077219122195316,
        2.3373593804742123, 2.3693080893020988, 2.4037928231040968, 2.4410731593639859, 2.4814504870100264,
        2.5252768496917765, 2.5729662007713944, 2.6250088859381185, 2.6819905053715398, 2.7446168092931882,
        2.8137470457388743, 2.8904393716943021, 2.9760138439015316, 3.0721416360548399, 3.1809744375877089,
        3.3053373207662527, 3.4490254591178631, 3.617277948406738, 3.817568870198802, 4.0610014861568117,
        4.3649368008920544, 4.7583973217035087, 5.294538659925252, 6.0845688237755882, 7.4169827862984908,
        10.44030650891055, 1.9999969099680568, 2.0000030895164212, 2.0007257524136444, 2.0021544861861319,
        2.00428714440444, 2.0071257854439746, 2.010675701986583, 2.0149450822833047, 2.019944895500984,
        2.0256888862489904, 2.0321936367388272, 2.0394786797645956, 2.0475666559271333, 2.0564835135655448,
        2.0662587528217266, 2.0769257173635485, 2.08852193907667, 2.1010895427887412, 2.1146757199931977,
        2.1293332827354145, 2.1451213114499664, 2.1621059137495576, 2.1803611151539482, 2.1999699077543912,
        2.2210254891558472, 2.2436327321536033, 2.2679099360625985, 2.2939909242207564, 2.3220275700312766,
        2.3521928575321218, 2.3846846140631569, 2.4197300952664613, 2.4575916609397191, 2.4985738608465774,
        2.5430323624575457, 2.5913853129226748, 2.64412795882482, 2.7018516864140832, 2.7652691516186423,
        2.8352479412508775, 2.9128564102461339, 2.9994272626769353, 3.0966476038301485, 3.2066895484946012,
        3.332404888868185, 3.4776245806471958, 3.6476369792415072, 3.8499862676219247, 4.0958796171475824,
        4.4028401734152599, 4.8001609753482747, 5.3414922063734325, 6.1390746994747017, 7.4840778426666631,
        10.535653752852739, 1.9999970740492306, 2.0000029254799798, 2.0006991305770846, 2.0020757961667363,
        2.0041308186456943, 2.0068660362501957, 2.0102863074177313, 2.0143991864434772, 2.0192148102230086,
        2.0247458871137928, 2.0310077483853324, 2.038018446109394, 2.0457988909802634, 2.0543730282617853,
        2.0637680527798802, 2.0740146657647277, 2.0851473779073401, 2.0972048644934457, 2.1102303800742538,
        2.1242722419505215, 2.1393843938968175, 2.155627064160532, 2.1730675349829414, 2.1917810448942429,
        2.2118518500735733, 2.2333744774598212, 2.2564552104803105, 2.2812138588164425, 2.3077858773489047,
        2.3363249174291685, 2.3670059174615495, 2.4000288716502184, 2.4356234588206437, 2.474054772042966,
        2.5156304711071493, 2.5607097938038926, 2.6097150237622975, 2.6631462459616556, 2.7216005632929136,
        2.7857974587780545, 2.8566127672450883, 2.9351249346817747, 3.0226791839751929, 3.1209783941568337,
        3.2322149070592892, 3.3592669795090389, 3.5060010117259297, 3.6777541583980422, 3.8821400535423491,
        4.1304688195421583, 4.4404242533325651, 4.8415674479374807, 5.3880386409234808, 6.1931020744651973,
        7.5505772149019876, 10.630145812734649, 1.9999972267153286, 2.0000027728540363, 2.0006739427665104,
        2.0020013287795175, 2.0039828721076986, 2.0066202139743213, 2.009917819699827, 2.0138826681185298,
        2.0185241401099127, 2.0238540028210531, 2.029886451952177, 2.0366381966059618, 2.0441285802932339,
        2.0523797360943163, 2.0614167764874641, 2.0712680200588984, 2.0819652586833755, 2.0935440700531453,
        2.1060441817814066, 2.1195098948192889, 2.1339905756972016, 2.1495412292313551, 2.1662231659406242,
        2.184104781642127, 2.2032624707214476, 2.2237816996484043, 2.2457582737546419, 2.2692998385390235,
        2.2945276674098852, 2.3215788016173418, 2.350608626292856, 2.3817939905638664, 2.41533701186724,
        2.4514697480273616, 2.4904599800118896, 2.5326184303325685, 2.5783078569880248, 2.6279546260988269,
        2.6820636018514104, 2.7412375377042979, 2.8062026686392846, 2.8778429904321581, 2.9572469372512934,
        3.0457721267974047, 3.1451370592194657, 3.2575541113162634, 3.3859277569385333, 3.5341595130360985,
        3.7076348863036592, 3.9140363295982267, 4.1647759840465724, 4.477696848885766, 4.8826256608063039,
        5.4341883153483375, 6.2466633013238371, 7.6164964792910765, 10.723805294763608, 1.9999973689420713,
        2.0000026306634073, 2.0006500880250619, 2.0019307877455772, 2.0038427172515829, 2.0063873412252323,
        2.0095687685231706, 2.0133934547306484, 2.0178700927813574, 2.0230095934018441, 2.0288251195456484,
        2.0353321599489408, 2.042548635529142, 2.0504950364835186, 2.059194590272365, 2.0686734622182622,
        2.0789609916714966, 2.0900899678082072, 2.1020969502737423, 2.1150226411512872, 2.1289123162042429,
        2.143816325090768, 2.159790672372536, 2.1768976937497983, 2.1952068451942673, 2.2147956267056106,
        2.2357506675306617, 2.2581690061819268, 2.2821596069109507, 2.3078451650265333, 2.3353642674122863,
        2.3648739929211687, 2.3965530615868858, 2.4306056740317301, 2.4672662262763597, 2.5068051450290129,
        2.549536171311793, 2.5958255362277198, 2.646103637369248, 2.7008800619168124, 2.7607631508643827,
        2.8264858191943635, 2.8989401399568601, 2.979224436354372, 3.0687086011054541, 3.1691266077398839,
        3.2827106818135882, 3.4123912738746084, 3.5621046991523544, 3.7372843815279717, 3.9456809777842564,
        4.1988077406848261, 4.5146654615058959, 4.9233441742643243, 5.4799511527012037, 6.2997702115869505,
        7.6818505454743027, 10.816653826391968, 1.9999975016067791, 2.0000024980312391, 2.0006274741120261,
        2.0018639022897634, 2.0037098171032487, 2.0061665248481662, 2.0092378106473261, 2.0129296535346628,
        2.0172501193883971, 2.0222093383207391, 2.0278195323794686, 2.0340950793037763, 2.0410526062034415,
        2.0487111109200189, 2.0570921109929086, 2.0662198215654272, 2.0761213646532426, 2.0868270131710661,
        2.0983704740936454, 2.1107892161954669, 2.1241248490375273, 2.1384235613153107, 2.1537366284235526,
        2.1701210012191456, 2.1876399905847188, 2.2063640656546578, 2.226371787648699, 2.2477509064113906,
        2.2705996533061926, 2.2950282725016466, 2.3211608435127974, 2.3491374619454542, 2.3791168638722446,
        2.4112796037418494, 2.4458319284440652, 2.4830105343600379, 2.523088454619452, 2.5663824072862349,
        2.6132620521482517, 2.6641617699147103, 2.7195958172364509, 2.7801780623779362, 2.8466480312718136,
        2.9199057937003143, 3.0010594662124818, 3.0914911006767816, 3.1929500008595372, 3.3076880604008976,
        3.4386614731104879, 3.5898410429210525, 3.7667076879337902, 3.9770796704332796, 4.2325704717499729,
        4.5513373019893216, 4.9637312074382873, 5.5253366715969852, 6.3524341459197124, 7.7466536956848644,
        10.908712114635714, 1.9999976254997581, 2.0000023741676317, 2.00060601661632, 2.0018004245533944,
        2.0035836801226674, 2.0059569473607395, 2.0089237169383953, 2.0124895331856373, 2.0166618895019163,
        2.0214502032992142, 2.0268658379264788, 2.032922157906276, 2.0396346115133252, 2.0470208383901942,
        2.055100801914116, 2.0638969473243009, 2.073434387594954, 2.0837411198935147, 2.0948482763072017,
        2.1067904134266772, 2.119605846401492, 2.1333370342829468, 2.1480310249057993, 2.163739969301189,
        2.180521717766231, 2.1984405123514608, 2.2175677938086181, 2.2379831451551935, 2.2597753992060843,
        2.2830439440266714, 2.3079002687200788, 2.3344698028782167, 2.3628941172299277, 2.3933335716581316,
        2.4259705214389684, 2.4610132255565827, 2.4987006455316124, 2.5393083841100288, 2.5831560973723892,
        2.63061683177684, 2.6821289051965845, 2.7382111926700664, 2.7994830319952659, 2.8666904936798372,
        2.9407415665943752, 3.0227540681682864, 3.1141220972307431, 3.2166101489628635, 3.3324896096489204,
        3.4647421894607557, 3.617372879898631, 3.7959096816157739, 4.0082378797168242, 4.2660703240011831,
        4.5877193056330476, 5.0037946567586627, 5.5703540087677076, 6.4046659820830023, 7.8109196210699247,
        11.0, 1.9999977413342052, 2.000002258359742, 2.0005856381733033, 2.0017401273078754, 2.0034638556702264,
        2.0057578593879819, 2.0086253609245215, 2.0120715074771303, 2.0161032689785331, 2.0207294111048708,
        2.0259605122405344, 2.0318090112961855, 2.0382892805787366, 2.0454177213728863, 2.0532128817822143,
        2.0616955975712424, 2.0708891576306062, 2.0808194964417788, 2.0915154166481949, 2.1030088456118669,
        2.1153351306990441, 2.1285333790413371, 2.1426468487086983, 2.1577233996640038, 2.1738160146143283,
        2.1909834020176203, 2.2092906961559335, 2.2288102724911796, 2.2496227006647931, 2.271817862737913,
        2.2954962709263511, 2.3207706276127735, 2.3477676814260886, 2.3766304475003791, 2.4075208788204356,
        2.4406231004491773, 2.47614735171011, 2.5143348263570728, 2.5554636621840543, 2.599856416449017,
        2.6478894824300175, 2.7000050713865874, 2.7567266278858721, 2.8186789038405905, 2.8866144504270226,
        2.9614491006518518, 3.0443102833674201, 3.1366040356283823, 3.2401099092860615, 3.3571186127838739,
        3.4906371519658145, 3.6447044128022796, 3.8248950776116296, 4.0391608866800178, 4.2993132201523881,
        4.6238181464055677, 5.0435421131990726, 5.6150119400381502, 6.4564761608905554, 7.8746614553544936,
        11.090536506409417, 1.9999978497548452, 2.000002149963155, 2.0005662677713963, 2.0016828019298932,
        2.0033499299920343, 2.0055685729653427, 2.0083417086695547, 2.0116741209623199, 2.0155723004061949,
        2.020044415771902, 2.0251003267444989, 2.0307516252708661, 2.0370116999214197, 2.0438958209119066,
        2.0514212452023231, 2.0596073421938006, 2.0684757413433722, 2.0780505036864547, 2.0883583198930343,
        2.0994287381456504, 2.1112944258595858, 2.123991470107376, 2.1375597226009654, 2.152043196270952,
        2.1674905219179126, 2.183955475163623, 2.2014975860861994, 2.220182846593736, 2.2400845339202326,
        2.2612841728050767, 2.2838726641941258, 2.3079516150118229, 2.3336349121514477, 2.3610505949284294,
        2.3903430946818844, 2.4216759291593009, 2.4552349644131019, 2.4912323904907333, 2.5299116025307375,
        2.5715532408056051, 2.6164827288753451, 2.6650797689430226, 2.7177904238539454, 2.775142660879026,
        2.8377665927603643, 2.9064211897224894, 2.9820300564626983, 3.0657301466164486, 3.1589393299791223,
        3.2634520841810479, 3.381578274039893, 3.5163499862888247, 3.6718397159359702, 3.8536684363764468,
        4.0698537898280365, 4.3323048696959883, 4.6596402502236461, 5.0829808783677524, 5.659318899853683,
        6.5078747103295756, 7.937891806081664, 11.180339887498948, 1.9999979513454795, 2.0000020483943405,
        2.0005478401369326, 2.0016282566045592, 2.0032415226574031, 2.0053884555976586, 2.0080718097940219,
        2.0112960362124976, 2.0150671857906421, 2.0193928797982197, 2.0242823188867631, 2.0297463187851556,
        2.0357973671906137, 2.042449699504478, 2.0497193927274551, 2.0576244778535892, 2.0661850718307748,
        2.0754235307539525, 2.08536462651437, 2.0960357496990647, 2.1074671421582951, 2.1196921633685883,
        2.1327475955487485, 2.1466739934724968, 2.1615160861080697, 2.1773232386557639, 2.1941499853166701,
        2.2120566452959822, 2.2311100372337924, 2.2513843106104858, 2.272961916883672, 2.2959347484320429,
        2.320405480146568, 2.3464891571763154, 2.3743150835237692, 2.4040290807418467, 2.4357962050885179,
        2.4698040367927584, 2.5062666889114126, 2.5454297289561265, 2.587576268901602, 2.6330345655059212,
        2.6821875937760351, 2.7354852281464163, 2.7934599136337564, 2.8567470724941667, 2.9261120345033102,
        3.0024861059449351, 3.0870156812429328, 3.1811303605141931, 3.286639419925481, 3.4058717193490309,
        3.5418842172513187, 3.6987827395630964, 3.882234170015273, 4.1003215132823472, 4.36505077910288,
        4.6951918073999031, 5.1221179795412804, 5.7032829994795903, 6.5588712680006797, 8.0006227836389423,
        11.269427669584645
    };
    return table;
}

/* c(l,m) of CH's recurrence at (l-1)l/2 + m, 0 <= m < l < 64 */
PRT__STATIC const double *prt__ch_c(void) {
    static const double table[2016] = {
        0.0, 1.4638501094227998, 0.0, 0.82841686957951404, 1.138550085106622, 0.0, 0.97385168109635337,
        1.0246950765959598, 1.0, 0.0, 0.99062662384559407, 1.0091014390464986, 1.0148707044823392, 0.92783056924062989,
        0.0, 0.99551868683927186, 1.0043994933051666, 1.0120545280176632, 0.98981106822615283, 0.88398007049215901,
        0.0, 0.99749765012849594, 1.0024706646674815, 1.0088744461601261, 1.002686371529155, 0.96747092979582596,
        0.8545976121261312, 0.0, 0.9984570443225959, 1.0015285520440446, 1.0065555134461126, 1.0055082519216938,
        0.99111939279463338, 0.94933887745164512, 0.83356036870965665, 0.0, 0.99898020942910778, 1.0010124662468061,
        1.0049403038709369, 1.0056994814093603, 0.99936605634704132, 0.98013804650215761, 0.93474140627161663,
        0.81776344992999526, 0.0, 0.99929031867576562, 1.000705633393698, 1.0038053073234698, 1.0051773035183659,
        1.0024258294027072, 0.99260810011633508, 0.97039220928341512, 0.92287083265779497, 0.80546911039770982,
        0.0, 0.99948601309840915, 1.000511600575764, 1.0029912000272949, 1.0045117739007301, 1.0034862252500067,
        0.99820639354697399, 0.98606000000376603, 0.96191285812805372, 0.91308191081465448, 0.79563026773481903,
        0.0, 0.99961569030207662, 1.0003828284198916, 1.0023941516543135, 1.0038782101661742, 1.003721469595155,
        1.0008347389505946, 0.99375537006662301, 0.9800078896769179, 0.95456239543222834, 0.90489573538237818,
        0.78757886884388073, 0.0, 0.99970506368139503, 1.0002939771496277, 1.0019469812749524, 1.0033243247682972,
        1.0036108417754798, 1.002063194945985, 0.9977796671894506, 0.98940180494370921, 0.97452125789972936,
        0.9481739311833872, 0.8979608289116156, 0.78086880944303033, 0.0, 0.99976868224193309, 1.0002306743707099,
        1.0016055947076649, 1.0028551889671806, 1.0033628921127968, 1.0025950604415481, 0.99995419940795175,
        0.99462109175384883, 0.98528774550901739, 0.96958411937266353, 0.94259327854462504, 0.89201738814155858,
        0.77519091303371092, 0.0, 0.99981521018034131, 1.0001843451483508, 1.001340455521643, 1.0024623873292552,
        1.0030715185774023, 1.0027696162834344, 1.0011382096393748, 0.99764638169963801, 0.99151544722171587,
        0.98146487801357032, 0.96514952567477805, 0.93768916758698683, 0.88687084537897137, 0.77032417846903481,
        0.0, 0.99985003111769961, 1.0001496535528649, 1.0011313509790898, 1.0021343507686867, 1.0027791504095381,
        1.002759404445798, 1.0017690372126402, 0.99944395359520819, 0.99528674326588138, 0.98854056737482216,
        0.97794154185474731, 0.96116244596965348, 0.93335315871544255, 0.88237333583906078, 0.76610645800136299,
        0.0, 0.99987661247208144, 1.000123158871562, 1.0009641604221431, 1.0018599342933114, 1.0025042018685242,
        1.0026554948577971, 1.0020820926313046, 1.0005227432714491, 0.99764144398356631, 0.99295901050010439,
        0.98573142162095968, 0.97470590704354613, 0.95756916963988562, 0.92949659346258023, 0.87841083795585538,
        0.76241609965199162, 0.0, 0.99989725722080864, 1.0001025736949441, 1.0008288272450746, 1.0016294930889965,
        1.0022536496566428, 1.0025071367104215, 1.0022095774488332, 1.001166501420253, 0.99914040782661338,
        0.99581083645113109, 0.99070922211940282, 0.98309968985749859, 0.97173753006228257, 0.95432084263065076,
        0.9260470928088234, 0.87489420317731401, 0.75916005396684355, 0.0, 0.99991353625876848, 1.0000863365255474,
        1.0007180610544888, 1.0014350382937204, 1.0020290233135876, 1.0023412830898642, 1.0022281756794703,
        1.0015405127551025, 1.0001040279102008, 0.99769461915204799, 0.99400094047194292, 0.98856102429269178,
        0.98064457288805348, 0.96901312331622711, 0.95137444352461599, 0.92294540288322743, 0.87175282816060852,
        0.75626593791245892, 0.0, 0.99992654641531767, 1.0000733563827796, 1.0006264902530649, 1.001270078319069,
        1.0018293347227151, 1.0021726540621887, 1.0021834682624822, 1.0017444331986234, 1.0007236369907026,
        0.99895843560172681, 0.99623268376641171, 0.99224067047874761, 0.98652478698910902, 0.9783588172359455,
        0.96650938881123308, 0.94869267294878348, 0.92014277771931862, 0.8689301305951517, 0.75367660119108679,
        0.0, 0.99993706946659356, 1.0000628552303244, 1.0005500978218163, 1.0011293785029007, 1.0016525307726134,
        1.0020091176074948, 1.0021030299610029, 1.0018400225989725, 1.0011175958346465, 0.99981396210620932,
        0.99777348313814122, 0.99478495736161543, 0.99054633697007807, 0.98460306622731632, 0.9762320910464214,
        0.96420434305304619, 0.94624342198205323, 0.91759888029630474, 0.86638026905299479, 0.75134632069899821,
        0.0, 0.99994567294722193, 1.0000542679830928, 1.0004858386551886, 1.0010087250183048, 1.001496212968381,
        1.0018546535550517, 1.0020037305183495, 1.0018664042752037, 1.0013612435173301, 1.0003945984885072,
        0.99885087923680946, 0.99657884305848836, 0.99337049156245102, 0.98892627659949947, 0.98279389979935204,
        0.97425287260217152, 0.96207786345016757, 0.94399911900198856, 0.91528012287475931, 0.8640657318983874,
        0.74923808121976118, 0.0, 0.99995277568932786, 1.0000471774483482, 1.0004313755066551, 1.0009047206621868,
        1.0013579859941303, 1.0017110252135506, 1.0018959373435393, 1.0018487949067791, 1.0015036693237581,
        1.0007868897779402, 0.99961030590156205, 0.9978622626065005, 0.9953943767299383, 0.99200081033187586,
        0.98738380263605253, 0.98109280702637282, 0.97240949330052877, 0.96011183665599079, 0.9419360853081837,
        0.9131583606757808, 0.86195554153928785, 0.74732159715890895, 0.0, 0.99995869139733117, 1.0000412710403977,
        1.0003848938292482, 1.0008146174835827, 1.0012356165252281, 1.0015787394606558, 1.0017860006246801,
        1.0018036647330176, 1.0015774809818005, 1.0010483468752942, 1.000147482898645, 0.99879027406823178,
        0.99686764531384449, 0.99423313805411912, 0.99068242955891854, 0.98591909509631847, 0.97949400502115933,
        0.9706906957538328, 0.95829010945833332, 0.94003395124156908, 0.9112098632402369, 0.86002390025811351,
        0.74557185001748736, 0.0, 0.99996365820999585, 1.0000363113974788, 1.0003449699885418, 1.0007361830621187,
        1.0011270951039936, 1.0014576053517716, 1.0016777565162543, 1.0017418735462309, 1.0016046846098851,
        1.0012179613790447, 1.0005269609417765, 0.99946608732830639, 0.99795306610066144, 0.99588056467589502,
        0.99310346291713662, 0.98941854201478912, 0.98453041766573478, 0.97799114640679861, 0.96908591279844402,
        0.95659834852530555, 0.93827514830956115, 0.90941450189127311, 0.85824915706840566, 0.74396799130945362,
        0.0, 0.99996785912525208, 1.0000321160700547, 1.0003104761576462, 1.0006675949518685, 1.0010306493280108,
        1.0013470615723002, 1.0015734538941262, 1.0016706223905076, 1.0016003249513104, 1.0013226193439874,
        1.0007931708309985, 0.99996010783311561, 0.99875996380837823, 0.99711205540326774, 0.99491026034057085,
        0.99201041960075221, 0.98821014872781532, 0.9832149038393771, 0.97657776219934125, 0.96758538635956966,
        0.95502386507579829, 0.93664447674523792, 0.9077551049158778, 0.85661301086375462, 0.74249250867157449,
        0.0, 0.99997143634795548, 1.0000285432460426, 1.0002805107979284, 1.0006073577661086, 1.0009447336375231,
        1.0012463686121401, 1.0014743348882119, 1.0015946933902967, 1.0015747941918421, 1.0013811258523534,
        1.0009772306939486, 1.0003213672935624, 0.99936360461822104, 0.99804193536165691, 0.99627678474012107,
        0.99396289428117131, 0.99095681717802187, 0.98705682186105849, 0.98196906514414795, 0.97524752188492828,
        0.96618019561160868, 0.95355543347654253, 0.9351287414190023, 0.90621694305753797, 0.85509988953948194,
        0.74113058434822448, 0.0, 0.99997450152246745, 1.0000254815662144, 1.0002543472330264, 1.000554238101458,
        1.0008680089446287, 1.0011547207743313, 1.0013810033015848, 1.0015172514804507, 1.0015353274247544,
        1.0014067927986429, 1.001101261180492, 1.00058462023406, 0.99981689889078481, 0.99874950747611504,
        0.99732146103776917, 0.99545397553196935, 0.9930424256477832, 0.98994390879007481, 0.98595722088248502,
        0.98078911869105308, 0.97399437978679614, 0.96486223522610353, 0.95218311810770828, 0.93371644700410612,
        0.90478731658933469, 0.85369646161885745, 0.73986959620048946, 0.0, 0.99997714313235522, 1.0000228427565853,
        1.0002313951830166, 1.0005072133832383, 1.0007993189504467, 1.0010713102633559, 1.0012936608290516,
        1.001440370890916, 1.0014869892653006, 1.0014091385702471, 1.0011811890204225, 1.0007748781740408,
        1.0001577102131517, 0.99929094857316033, 0.99812694977456001, 0.99660546017548135, 0.99464827279109746,
        0.99215123878139196, 0.98897188384690874, 0.98490944249265623, 0.97967119651806678, 0.97281265075917805,
        0.96362416771020251, 0.95089811491508541, 0.93239754330890542, 0.90345522193196726, 0.85239124869203415,
        0.73869872562279093, 0.0, 0.99997943192027453, 1.0000205562303298, 1.00021117169374, 1.000465431532526,
        1.0007376665761165, 1.0009953625008891, 1.0012122596534132, 1.0013653855204862, 1.0014333353677571,
        1.0013950254371254, 1.0012286079185956, 1.0009103792825414, 1.0004135543819816, 0.99970677438591293,
        0.99875218000871043, 0.9975028078671047, 0.99589893796782224, 0.99386279401711627, 0.99129059513063997,
        0.9880402135934765, 0.98391125781043576, 0.97861147721704934, 0.97169704223100618, 0.9624593638976467,
        0.94969260983766471, 0.93116321253543367, 0.90221108088862028, 0.85117431530521523, 0.73760864657017608,
        0.0, 0.99998142490483586, 1.000018565085944, 1.0001932789535811, 1.0004281790416126, 1.0006821921051612,
        1.0009261541760941, 1.0011366014746718, 1.0012931247958634, 1.0013768623428347, 1.0013694333220978,
        1.0012520372174116, 1.0010045757591059, 1.0006046966670483, 1.0000266625261311, 0.99923992860959308,
        0.9982072699145576, 0.99688222064395044, 0.9952054578530365, 0.99309953392792784, 0.99046095939310131,
        0.98714789428776204, 0.98296027265046501, 0.97760626632614484, 0.97064265966753768, 0.96136183972427141,
        0.94855965410796859, 0.93000569133697226, 0.90104651944780213, 0.85003701889706922, 0.73659127677539124,
        0.0, 0.99998316839034447, 1.0000168231080053, 1.0001773872124983, 1.0003948555933668, 1.0006321536670309,
        1.0008630210090899, 1.0010664018592981, 1.0012240739952107, 1.0013193176463036, 1.0013359939687511,
        1.0012577875292736, 1.0010674893025777, 1.0007462381472326, 1.0002726477431475, 0.99962173649758268,
        0.99876355206892982, 0.9976613354976119, 0.99626899131473608, 0.99452749770187696, 0.99235966345831217,
        0.98966223554730644, 0.98629361850525977, 0.98205403507575502, 0.97665204294046783, 0.96964499626650084,
        0.96032619386785751, 0.94749305535459489, 0.92891812166631826, 0.89995418605057579, 0.8489718066904085,
        0.73563957711576151, 0.0, 0.99998470024492667, 1.0000152924964747, 1.0001632215181034, 1.0003649537883025,
        1.0005869101919013, 1.0008053594856623, 1.0010013319427105, 1.0011584841110324, 1.0012619154157849,
        1.0012973645543363, 1.0012505649696605, 1.0011066512452916, 1.0008495481565497, 1.0004612856024878,
        0.99992117917157487, 0.99920480087442064, 0.99828263587709553, 0.99711827293365668, 0.99566589683028633,
        0.99386671850781032, 0.99164375117840959, 0.98889393806856381, 0.98547589573156142, 0.98119010666708535,
        0.97574548411955198, 0.96869991374493063, 0.95934754870417066, 0.94648728298303103, 0.92789442542256355,
        0.89892760145937411, 0.84797204959834152, 0.73474738859875084, 0.0, 0.99998605164126148, 1.0000139421312836,
        1.0001505513337497, 1.0003380428732064, 1.0005459067215705, 1.0007526251681837, 1.000941045244436,
        1.0010964476225486, 1.0012054882884191, 1.0012554920824293, 1.0012338985711315, 1.001127764451987,
        1.0009232645434933, 1.000605146041486, 1.0001560908418659, 0.99955593202263479, 0.99878065275921497,
        0.99780106588579084, 0.99658102345045922, 0.99507492585325609, 0.99322416737832955, 0.99095192766325147,
        0.98815531631747289, 0.98469313700808224, 0.98036610876509049, 0.97488347481315866, 0.96780361854587426,
        0.95842149576282443, 0.94553738618676917, 0.92692919878178827, 0.89796103407633587, 0.84703190553041536,
        0.73390929898738903, 0.0, 0.99998724839847803, 1.0000127462342849, 1.0001391823515671, 1.000313755617945,
        1.0005086618534328, 1.000704329173968, 1.0008851946523593, 1.0010379510079615, 1.0011505951154831,
        1.0012118024592732, 1.0012104462583755, 1.0011351756262113, 1.0009740027473031, 1.0007138620348286,
        1.0003401064828954, 0.99983590176266316, 0.99918146752396613, 0.99835309629138255, 0.99732184959858518,
        0.99605178177005963, 0.9944974618272439, 0.99260043119771143, 0.99028400777887265, 0.9874454449487513,
        0.98394371399649765, 0.97957975143914201, 0.97406310847371368, 0.96695263617313362, 0.9575440461203381,
        0.94463892298629463, 0.92601762283443907, 0.89704939587092225, 0.84614620621777428, 0.73312053296370685,
        0.0, 0.99998831202518084, 1.0000116833290415, 1.0001289499908667, 1.0002917776802099, 1.0004747570593958,
        1.0006600337863325, 1.0008334429007898, 1.0009829112484252, 1.0010975979633362, 1.0011673369896312,
        1.0011822162652543, 1.0011322164330067, 1.0010068653003208, 1.0007948771435617, 1.0004837494371939,
        1.0000592874567025, 0.9995050203562606, 0.99880146008042314, 0.99792513476039717, 0.99684729714534571,
        0.99553215919747232, 0.99393442397858247, 0.99199575319536212, 0.9896395818127882, 0.98676328956053862,
        0.98322599978255834, 0.97882885055407003, 0.97328168182078333, 0.96614378531895023, 0.95671158573916299,
        0.94378789881951055, 0.92515538776197673, 0.89618815508744723, 0.84531036297963703, 0.73237686112278402,
        0.0, 0.99998926053647617, 1.0000107354258769, 1.0001197142006313, 1.0002718389455559, 1.0004438276235889,
        1.0006193477754319, 1.0007854687449312, 1.0009312012322034, 1.0010467175151489, 1.0011228517516046,
        1.001150728935188, 1.0011214525872407, 1.001025812420358, 1.0008539857124421, 1.0005952102933836,
        1.0002374065092379, 0.99976672139111663, 0.99916696034482881, 0.99841885884596416, 0.99749912658119413,
        0.99637916518920144, 0.99502331124257326, 0.99338637609806096, 0.9914101215509477, 0.98901808345276461,
        0.98610775423484788, 0.98253839661870903, 0.97811133667204613, 0.97253668608008803, 0.96537415277756857,
        0.95592083552600358, 0.94298071336458364, 0.92433862828511792, 0.89537326268617933, 0.84452028784148289,
        0.73167452413595796, 0.0, 0.9999901090986466, 1.0000098873787479, 1.0001113552784202, 1.0002537064430875,
        1.0004155549622155, 1.0005819217647952, 1.0007409702997305, 1.0008826674139155, 1.0009980731487874,
        1.0010788904961212, 1.0011171360092255, 1.0011048675567186, 1.0010339345609498, 1.00089572805179,
        1.0006809123613311, 1.0003791207485596, 0.9999785948586781, 0.99946574280342069, 0.99882458219147136,
        0.99803602129287206, 0.99707691129616136, 0.99591877123148086, 0.99452603758314798, 0.99285361061909354,
        0.99084333685745374, 0.98841884049861573, 0.98547771579096116, 0.98187935431746294, 0.9774252583992726,
        0.97182579624841643, 0.96464106970576911, 0.95516881576408922, 0.94221411443882617, 0.92356386852348316,
        0.8946010900814472, 0.84377232717044546, 0.73101016921332318, 0.0, 0.99999087054133286, 1.000009126374225,
        1.0001037704869373, 1.0002371785238895, 1.000389660115354, 1.0005474438300251, 1.000699666525834,
        1.0008371420420444, 1.0009517120566338, 1.0010358384874283, 1.0010823092823778, 1.0010839992771676,
        1.0010336548827778, 1.0009236827685221, 1.0007459273157853, 1.0004914227020714, 1.0001501042344944,
        0.99971046026163083, 0.99915910036857839, 0.99848020681006676, 0.99765482281891013, 0.99665991110289064,
        0.9954670844085591, 0.99404086047248552, 0.99233621371905794, 0.99029506354876545, 0.98784111265177232,
        0.98487204826496425, 0.98124738195776522, 0.97676878200388677, 0.97114685941340961, 0.96394208951567109,
        0.95445281452512272, 0.94148515797175981, 0.92282797473794303, 0.89386837621759425, 0.8430632055748469,
        0.73038079659978972, 0.0, 0.99999155576709427, 1.0000084415228119, 1.0000968713006745, 1.0002220800561269,
        1.0003658982283475, 1.0005156354240595, 1.0006612975223108, 1.0007944515621039, 1.0009076304736321,
        1.0009939625064652, 1.0010469069775633, 1.0010600427436871, 1.0010268810524134, 1.0009406852167949,
        1.0007942841486311, 1.0005798682448577, 1.0002887556310227, 0.99991111468733231, 0.99943562502375238,
        0.99884905317397796, 0.99813571036570069, 0.99727674631050136, 0.99624921257891132, 0.99502479767022007,
        0.99356808633713466, 0.99183411580767154, 0.98976486912610614, 0.98728411960426925, 0.98428964018717514,
        0.98064105482126721, 0.97614018858445978, 0.97049788280236432, 0.96327496751105151, 0.95377035965843578,
        0.94079117319087952, 0.92212811469644161, 0.89317218239940816, 0.84238997826572515, 0.7297837143037116,
        0.0, 0.99999217408091783, 1.0000078235301079, 1.0000905811533331, 1.0002082584424092, 1.0003440538668889,
        1.0004862476674337, 1.0006256240692836, 1.0007544223201606, 1.0008657891859844, 1.0009534407300697,
        1.0010114237683999, 1.0010339275811995, 1.0010151200112365, 1.0009489922586269, 1.0008292011698182,
        1.0006488994929891, 1.0004005445733383, 1.0000756746946502, 0.99966463976003523, 0.99915626899201789,
        0.99853745228317699, 0.99779260282376627, 0.99690295516421069, 0.9958456324649167, 0.99459238522453105,
        0.99310785424628418, 0.99134713073260491, 0.98925225407221063, 0.98674706182629418, 0.98372940654823274,
        0.98005901794322254, 0.9755378696845669, 0.96987702199295692, 0.96263764227077884, 0.95311919396955759,
        0.94012973228278097, 0.92146172262329291, 0.89250985359099069, 0.84174999043029391, 0.72921649961728571,
        0.0, 0.99999273345686152, 1.0000072644306809, 1.0000848335855965, 1.0001955803051458, 1.0003239370337702,
        1.0004590580087214, 1.0005924267176781, 1.0007168843584065, 1.0008261248719287, 1.0009143851500319,
        1.0009762287063565, 1.0010063771047981, 1.0009995654201081, 1.0009504075899682, 1.0008532618550323,
        1.0007020882682521, 1.0004902905766554, 1.0002105340592013, 0.99985452923306454, 0.99941276859096755,
        0.99887419937693867, 0.99822580927135249, 0.99745209279795133, 0.99653435276670741, 0.99544977064839356,
        0.99417014831946682, 0.99266017410766158, 0.99087498624946818, 0.9887566746376936, 0.98622913584638604,
        0.98319029684939879, 0.97949998728066076, 0.97496032197840084, 0.96928256955491249, 0.96202821871860686,
        0.9524972532270206, 0.93949862390028306, 0.92082646887052264, 0.89187898513351859, 0.84114084244397246,
        0.72867696626905222, 0.0, 0.99999324075501242, 1.0000067573715081, 1.0000795707147549, 1.0001839287169116,
        1.0003053797761397, 1.0004338672413193, 1.0005615046245281, 1.0006816738629497, 1.0007885583906358,
        1.0008768584594221, 1.0009415941336782, 1.0009779535740205, 1.0009811647601695, 1.0009463778181169,
        1.0008685492763306, 1.0007423214022513, 1.0005618902982439, 1.0003208560879223, 1.0000120474281499,
        0.99962731069060509, 0.99915725127381179, 0.99859091026877339, 0.99791535351344256, 0.99711514098215596,
        0.9961716309412112, 0.99506205288024417, 0.99375825178134857, 0.99222495680580998, 0.99041734770974563,
        0.98827756015754286, 0.98572954537122641, 0.98267130027066246, 0.97896274922490305, 0.97440614146119526,
        0.96871294428069518, 0.96144495278232774, 0.95190264666817372, 0.93889582997906859, 0.92022023359558539,
        0.89127739402137525, 0.84056035996641362, 0.72816313626972033, 0.0, 0.99999370189893966, 1.0000062964348342,
        1.0000747419644492, 1.0001732008773518, 1.0002882332900168, 1.0004104968526255, 1.0005326742652246,
        1.0006486346618594, 1.0007530008274007, 1.0008408868114981, 1.0009077178324137, 1.0009490930713147,
        1.0009606711610094, 1.0009380666489134, 1.0008767496829345, 1.0007719429925766, 1.0006185108942598,
        1.0004108349538032, 1.0001426702403667, 0.9998069748051763, 0.99939570300235938, 0.99889955030865188,
        0.99830763301203149, 0.99760707992091515, 0.99678250413876745, 0.99581530942643523, 0.99468276525490152,
        0.99335675321618127, 0.99180203800551406, 0.98997383646956672, 0.98781432616067009, 0.98524750925999947,
        0.98217144872438456, 0.97844615898583262, 0.97387401744278284, 0.96816668108866645, 0.9608862375271344,
        0.95133363970812895, 0.93831950540673088, 0.91964108384904093, 0.89070309402796599, 0.84000656814097589,
        0.72767321568720513, 0.0, 0.99999412202155563, 1.000005876492554, 1.0000703030057066, 1.0001633061574416,
        1.0002723654439922, 1.0003887866770202, 1.0005057681084986, 1.0006176190572397, 1.0007193578838923,
        1.0008064694831502, 1.0008747400659951, 1.0009201325277373, 1.0009386836750186, 1.0009264125537177,
        1.0008792328939372, 1.0007928644802502, 1.0006627389884848, 1.0004838959051437, 1.0002508637225413,
        0.99995752071231836, 0.99959692816247349, 0.99916112687422406, 0.99864088470809309, 0.99802537865239391,
        0.99730178865072712, 0.99645477130865505, 0.99546576807482005, 0.99431208207732561, 0.99296562637577275,
        0.99139119696273983, 0.98954404417915951, 0.98736638423798578, 0.98478226712072691, 0.9816898183660688,
        0.97794913823014757, 0.97336272654656793, 0.96764242163249805, 0.96035059064138451, 0.95078863858849036,
        0.93776796015462493, 0.91908725357359901, 0.89015427409506209, 0.83947766925626662, 0.72720557372569772,
        0.0, 0.99999450558557588, 1.0000054930859443, 1.0000662148704347, 1.0001541644471507, 1.0002576586568064,
        1.0003685928227398, 1.000480633308938, 1.0005884881941181, 1.0006875330447219, 1.0007735862057062,
        1.0008427567416666, 1.0008913307665709, 1.000915678748759, 1.0009121738720464, 1.0008771151150196,
        1.0008066504530015, 1.0006966963610494, 1.0005428499860026, 1.0003402901249113, 1.0000836625448459,
        0.99976694417955595, 0.99938327925257263, 0.99892477824376966, 0.99838226758123049, 0.99774497360607544,
        0.99700011811073025, 0.99613239362995861, 0.99512327313993639, 0.99395008841333925, 0.99258477987346559,
        0.99099217139168762, 0.98912754385096338, 0.98693314940956712, 0.98433308311055106, 0.98122552998851554,
        0.97747067224991308, 0.97287112684810679, 0.9671389056181417, 0.95983664315343134, 0.95026617673299776,
        0.93723964354019553, 0.91855712609641712, 0.88962927949885779, 0.83897202334029438, 0.72675872459474062,
        0.0, 0.9999948564834487, 1.0000051423258863, 1.0000624432063282, 1.0001457047546539, 1.0002440080741742,
        1.0003497858433548, 1.000457130450813, 1.0005611121112417, 1.0006574298377583, 1.000742202730423,
        1.0008118296108383, 1.0008628849622487, 1.0008920349426346, 1.0008959642895465, 1.0008713083289266,
        1.0008145859821151, 1.0007221304557105, 1.0005900145645649, 1.000413967542007, 1.0001892797928149,
        0.99991069133990287, 0.99957225865197024, 0.99916719301226665, 0.99868766142917019, 0.99812453803665148,
        0.99746708958757266, 0.99670257238965496, 0.99581570891117756, 0.99478799876227763, 0.99359679835870655,
        0.99221407218581957, 0.99060466920929924, 0.98872389840383649, 0.98651404556078412, 0.98389924838246871,
        0.98077774861752093, 0.97700980686027298, 0.97239815223930791, 0.96665496280897164, 0.9593431292629236,
        0.9497649026050915, 0.93673313033597867, 0.91804921876293047, 0.88912659538681592, 0.83848813124821164,
        0.72633131174368284, 0.0, 0.99999517812060938, 1.000004820809733, 1.0000589576482392, 1.0001378640148647,
        1.0002313199991309, 1.0003322491262591, 1.000435132362796, 1.0005353695775891, 1.0006289534228399,
        1.0007122750529884, 1.0007819941964579, 1.0008349435657412, 1.0008680524400815, 1.000878280893649,
        1.0008625593551941, 1.0008177298007075, 1.0007404856712891, 1.0006273079228721, 1.0004743946122534,
        1.0002775811703289, 1.0000322480189662, 0.9997332114231069, 0.9993745923671455, 0.99894965669207385,
        0.99845061755364075, 0.99786838819828242, 0.99719226870192125, 0.99640954406061761, 0.99550496189963577,
        0.99446004455037681, 0.99325216985454304, 0.99185332368174921, 0.99022837780235058, 0.98833266722670238,
        0.98610850938718033, 0.98348008251570445, 0.98034568254661121, 0.97656564516843197, 0.9719428070703019,
        0.96618950568711033, 0.95886887717709996, 0.9492835688874773, 0.9362471084825616, 0.91756216941543605,
        0.88864483234552896, 0.83802461987807738, 0.72592209410917234, 0.0, 0.99999547348512574, 1.0000045255517602,
        1.0000557312858733, 1.00013058607278, 1.0002195105375888, 1.0003158774728072, 1.00041452301366,
        1.0005111477887682, 1.0006020116829898, 1.0006837526160491, 1.0007532659682833, 1.0008076164922715,
        1.0008439685124343, 1.000859526469404, 1.0008514809071233, 1.0008169565470564, 1.0007529598738124,
        1.0006563240007363, 1.0005236486472322, 1.0003512329097091, 1.0001349981644299, 0.99987039788942052,
        0.99955231039117837, 0.99917490929529698, 0.99873150509153813, 0.99821434883703979, 0.99761438605110693,
        0.99692094447962806, 0.99612133314993518, 0.99520032101609287, 0.99413944998232509, 0.99291611671143266,
        0.99150232626767909, 0.98986297132527476, 0.98795341118617691, 0.98571599318842507, 0.98307493418709667,
        0.97992858198791205, 0.97613734431440078, 0.97150416109723934, 0.96574152273184214, 0.9584128008509,
        0.94882102282607402, 0.93578036819758731, 0.91709472446525572, 0.88818271371414307, 0.83758022920899341,
        0.72552993408207263, 0.0, 0.99999574520618783, 1.0000042539247556, 1.0000527402114713, 1.0001238208133184,
        1.000208504426964, 1.0003005758471642, 1.0003951964927609, 1.0004883419761125, 1.0005765159477313,
        1.0006565807307608, 1.0007256451619792, 1.0007809831776423, 1.0008199698276844, 1.0008400272994251,
        1.0008385764102056, 1.0008129905051433, 1.0007605494581404, 1.0006783918350088, 1.0005634633858547,
        1.0004124599583145, 1.0002217626886953, 0.99998736293116493, 0.99970477379954857, 0.999368924372118,
        0.99897403146789993, 0.99851344232420909, 0.99797943931153584, 0.99736299474755912, 0.99665345951470137,
        0.99583816292852311, 0.99490189218580167, 0.99382620621412454, 0.99258851837330164, 0.99116085111701347,
        0.9895081164300677, 0.98758569641080843, 0.98533596677529455, 0.98268318128017312, 0.97952573747092913,
        0.97572411225347162, 0.97108134474777209, 0.96531007227262229, 0.95797389253840622, 0.94837619760041403,
        0.93533179230238371, 0.91664572834526841, 0.88773906440267498, 0.83715380090507722, 0.72515378694813208,
        0.0, 0.9999959956034128, 1.0000040036107765, 1.0000499631341715, 1.0001175234143323, 1.0001982340208623,
        1.0002862582733653, 1.0003770560750455, 1.0004668549658833, 1.0005523814452139, 1.0006307024002145,
        1.0006991205445468, 1.0007550989676757, 1.0007962022838461, 1.0008200474352529, 1.0008242599285121,
        1.0008064326915473, 1.0007640854773806, 1.0006946231091648, 1.0005952909996046, 1.0004631263556686,
        1.00029490332426, 1.0000870700497887, 0.99983567518518563, 0.99953628079082303, 0.99918385771716963,
        0.99877265841534665, 0.9982960605343342, 0.99774637246574157, 0.99711458892028291, 0.99639008026196859,
        0.99556019306979976, 0.99460973028116986, 0.99352026576965486, 0.99226922784763739, 0.99082865485744555,
        0.98916347674612833, 0.98722909711322335, 0.98496791869482688, 0.98230423058229102, 0.97913647808693118,
        0.97532520462802599, 0.97067354470469174, 0.96489427687325539, 0.95755121607174122, 0.94794810459985092,
        0.93490034761281984, 0.91621411416130339, 0.88731280101161389, 0.8367442682691503, 0.72479269159604649,
        0.0, 0.99999622672855644, 1.0000037725594897, 1.0000473810501614, 1.0001116537035216, 1.0001886384070914,
        1.000272846862402, 1.0003600133677748, 1.0004465967148428, 1.0005295275554641, 1.0006060596840317,
        1.0006736723583376, 1.0007300001985631, 1.0007727788916636, 1.0007998001850827, 1.0008088722336617,
        1.0007977827046777, 1.0007642627599837, 1.0007059504026455, 1.0006203518343869, 1.0005047994860384,
        1.0003564052858701, 1.0001720075281465, 0.99994810938886901, 0.99968080668595933, 0.99936570186035516,
        0.99899780030650016, 0.99857138402266089, 0.99807985596182133, 0.99751554626342046, 0.99686946846813242,
        0.99613100945975364, 0.99528753062344569, 0.99432384859716424, 0.99322155049716997, 0.99195807814544344,
        0.9905054845147747, 0.98882871636240355, 0.98688319765591233, 0.98461135693334897, 0.98193751718479747,
        0.97876016965095308, 0.9749399217599282, 0.97027999980065362, 0.96449331820448508, 0.9571439007917815,
        0.94753582650004886, 0.93448507726224843, 0.9157988953874368, 0.88690292307998623, 0.83635064736341992,
        0.72444576231892937, 0.0, 0.99999644040092242, 1.0000035589528042, 1.0000449769596773, 1.0001061756032651,
        1.0001796626398228, 1.0002602709532991, 1.0003439875346325, 1.0004274838404157, 1.0005078779188987,
        1.00058259471062, 1.00064927462277, 1.0007057082451233, 1.0007497861133711, 1.000779457394927,
        1.0007926938163379, 1.0007874564279614, 1.0007616634887793, 1.000713158118689, 1.000639674537111,
        1.000538801749764, 1.0004079434905545, 1.0002442730835703, 1.0000446816586923, 0.99980571781976808,
        0.99952351640159753, 0.99919371332229107, 0.99881134268343676, 0.99837071110826926, 0.99786524271560671,
        0.99728728592525097, 0.99662787021193173, 0.99587639656724623, 0.99502023917596471, 0.99404422670398696,
        0.99292995810489427, 0.99165488750794927, 0.99019108145262512, 0.98850350251270408, 0.9865475940229908,
        0.98426580922185001, 0.98158250367400401, 0.97839621283408158, 0.97456760578285415, 0.96989999721203662,
        0.96410643236390779, 0.95675113606275619, 0.94713851104742086, 0.93408509384247893, 0.91539915847253477,
        0.88650850531472536, 0.83597202914214038, 0.72411218156197479, 0.0, 0.99999663823752053, 1.0000033611747471,
        1.0000427356234764, 1.0001010566500717, 1.0001712570696999, 1.0002484663540986, 1.0003289045920709,
        1.0004094391578349, 1.000487360440654, 1.0005602504187681, 1.0006258969324679, 1.0006822327524289,
        1.0007272889743693, 1.0007591569727182, 1.0007759554625626, 1.0007758004338618, 1.0007567763816901,
        1.0007169076136962, 1.0006541285946246, 1.0005662523498535, 1.0004509359260857, 1.0003056418102637,
        1.000127594038481, 0.99991372747703609, 0.99966062841089823, 0.99936446410370238, 0.99902089835782524,
        0.99862498924489777, 0.99817106401211004, 0.9976525645754997, 0.99706185480847065, 0.9963899777551238,
        0.99562634654119656, 0.99475834650426475, 0.99377081695918982, 0.99264536752999632, 0.99135946364404093,
        0.98988518450040019, 0.98818750762442728, 0.98622189482625931, 0.98393082304079855, 0.98123867917989564,
        0.97804404130409079, 0.97420763792529001, 0.96953286893700607, 0.963732905604388, 0.95637216630989819,
        0.94675536547067728, 0.93369957326413698, 0.91501405624417229, 0.88612869067565695, 0.83560757246431343,
        0.72379119349132163, 0.0, 0.99999682167883426, 1.0000031777857242, 1.0000406433526755, 1.0000962675775456,
        1.0001633767581728, 1.0002373746704151, 1.0003146967723853, 1.0003923912324787, 1.0004679072210967,
        1.000538971091403, 1.0006035058596712, 1.0006595742191462, 1.0007053351958848, 1.0007390090073243,
        1.0007588468813749, 1.00076310374966, 1.0007500123608562, 1.0007177577084119, 1.0006644508488341,
        1.000588101262045, 1.0004865869042629, 1.0003576210401866, 1.0001987148183405, 1.0000071343669599,
        0.9997798509265093, 0.9995134821800162, 0.99920422246564061, 0.99884775891641033, 0.99843916971113902,
        0.99797279945374078, 0.99744210510293018, 0.99683946367095942, 0.99615592983166553, 0.9953809272223795,
        0.99450185097516642, 0.99350354991063214, 0.99236764334818887, 0.9910716071598828, 0.98958753242434886,
        0.98788041085878012, 0.98590572194716433, 0.98360596540016628, 0.98090555833342625, 0.97770311990149424,
        0.973859435948755, 0.96917798854120159, 0.96337207043473012, 0.95600628652578327, 0.94638565144865054,
        0.93332774925092332, 0.91464280201192605, 0.8857626842084295, 0.83525649787377124, 0.72348209827764807,
        0.0, 0.99999699201090401, 1.0000030075004601, 1.0000386878268869, 1.0000917819535717, 1.0001559809644148,
        1.000226942710779, 1.0003013019479645, 1.0003762739525908, 1.0004494544352262, 1.0005187027299498,
        1.0005820660450729, 1.0006377260646673, 1.0006839585437085, 1.0007191007594372, 1.0007415237665468,
        1.0007496075037003, 1.0007417174041872, 1.0007161815014284, 1.0006712672024033, 1.0006051569862553,
        1.0005159223008981, 1.0004014948916845, 1.0002596347080522, 1.0000878933948644, 0.99988357217763599,
        0.99964367268191684, 0.99936483886684869, 0.99904328777238283, 0.99867472613750896, 0.99825424908411792,
        0.99777621589315725, 0.99723409630391402, 0.9966202785638577, 0.99592582737860826, 0.99514017555708036,
        0.99425072689989661, 0.99324233878035103, 0.99209663939320285, 0.99079111432808394, 0.9892978658667255,
        0.98758189924509526, 0.98559871089520262, 0.98329082245375877, 0.98058268017086637, 0.97737294286980199,
        0.97352245174142445, 0.96883476815376047, 0.96302330205906466, 0.95565283819684016, 0.94602868057226766,
        0.93296890839353786, 0.91428466428548251, 0.88540974753289197, 0.834918082050158, 0.7231842470035137,
        0.0, 0.9999971503843082, 1.000002849169036, 1.0000368579364227, 1.0000875758639075, 1.0001490326949218,
        1.0002171219593496, 1.0002886631113037, 1.0003610261254285, 1.0004319421779107, 1.0004993933067197,
        1.0005615410429606, 1.0006166762840702, 1.000663181547115, 1.0006995007432865, 1.0007241135946789,
        1.0007355128613446, 1.0007321831256008, 1.0007125802072396, 1.0006751104641217, 1.0006181093224825,
        1.0005398184088954, 1.0004383606356834, 1.0003117125296263, 1.0001576729902374, 0.99997382751420669,
        0.99975750671783124, 0.99950573771524497, 0.99921518654640039, 0.99888208936566634, 0.99850216945797609,
        0.99807053628552699, 0.99758156159934855, 0.99702872605394739, 0.99640442755999584, 0.99569973953282536,
        0.9949041028412667, 0.99400492901657135, 0.99298708318571789, 0.99183220172462103, 0.9905177793163104,
        0.98901592885410483, 0.9872916684915496, 0.98530051094667747, 0.98298499899391197, 0.98026960701411368,
        0.97705303215255675, 0.97319616906428404, 0.96850265569631894, 0.9626860151241091, 0.95531120560676919,
        0.94568381024611708, 0.93262238569867739, 0.91393896203441992, 0.88506919390723517, 0.83459165284793525,
        0.7228970371164664, 0.0, 0.99999729783052412, 1.0000027017605454, 1.0000351436450345, 1.000083627635604,
        1.0001424983073584, 1.0002078681077829, 1.0002767279056328, 1.0003465910983575, 1.0004153142875437,
        1.0004809929242908, 1.0005418939723991, 1.0005964087731556, 1.0006430177101852, 1.0006802620730353,
        1.000706720399706, 1.000720987575137, 1.0007216555161904, 1.0007072945887162, 1.0006764350801703,
        1.0006275481444151, 1.0005590256715806, 1.0004691585296134, 1.0003561125820104, 1.0002179018096537,
        1.000052357751145, 0.99985709431947296, 0.9996294668432264, 0.99936652390311402, 0.99906495016822949,
        0.99872099795166105, 0.99833040455989949, 0.99788829164577841, 0.99738904160557796, 0.99682614446475045,
        0.99619200649379717, 0.99547770871938257, 0.99467269914389697, 0.99376439624402364, 0.99273767222675635,
        0.99157417105760821, 0.99025139597310314, 0.98874146995672473, 0.98700942353841815, 0.98501078511454344,
        0.98268811786238839, 0.97996592334850284, 0.97674293576507658, 0.9728801014448839, 0.96818113232799873,
        0.96235966074608689, 0.95498081247831057, 0.94535043998165041, 0.93228756057679322, 0.91360506042624672,
        0.88474038379907083, 0.83427658485202439, 0.72261990836087754, 0.0, 0.99999743527606859, 1.0000025643489661,
        1.0000335358702187, 1.0000799175946958, 1.0001363471614462, 1.0001991406390841, 1.0002654482013408,
        1.0003329164053528, 1.000399518157424, 1.0004634539043202, 1.0005230880151869, 1.0005769043888061,
        1.0006234733128387, 1.0006614252124866, 1.0006894287152217, 1.0007061714077061, 1.0007103421900779,
        1.0007006144360672, 1.0006756293413609, 1.0006339789373809, 1.0005741882899517, 1.0004946964064553,
        1.0003938353479623, 1.0002698069868036, 1.0001206567640219, 0.99994424368107461, 0.99973820559898839,
        0.99949991870525511, 0.99922644972894539, 0.99891449911649675, 0.99856033289459057, 0.99815970030056802,
        0.99770773339561746, 0.99719882370665624, 0.99662646934674453, 0.99598308386135672, 0.9952597549722187,
        0.99444593703991347, 0.99352905482593597, 0.99249398704602032, 0.99132238474779867, 0.98999175925076133,
        0.98847424316529963, 0.98673487890706487, 0.98472920998962439, 0.98239981930527794, 0.97967123471396168,
        0.9764422262453775, 0.97257379021242269, 0.96786971009003292, 0.96204372379158248, 0.95466111891899927,
        0.94502800803980299, 0.93196385321941686, 0.91328236698758082, 0.88442272090384658, 0.83397229538842876,
        0.72235233913071697, 0.0, 0.99999756355475173, 1.0000024361009181, 1.0000320263785938, 1.00007642785345,
        1.0001305513107309, 1.0001909024571923, 1.0002547797137387, 1.0003199534386288, 1.0003845045416755,
        1.0004467308231876, 1.000505086792745, 1.0005581417965955, 1.0006045488793347, 1.0006430202390727,
        1.0006723068379047, 1.0006911806342978, 1.0006984184096319, 1.0006927864527115, 1.00067302553545,
        1.0006378357079676, 1.0005858604878117, 1.0005156700298233, 1.0004257428474738, 1.0003144456161956,
        1.0001800105242235, 1.0000205095442135, 0.9998338248744521, 0.99961761463415567, 0.9993692726821939,
        0.99908588114711648, 0.99876415388716626, 0.99840036861209264, 0.99799028475207235, 0.99752904329353211,
        0.99701104363229918, 0.99642979089861337, 0.99577770500650974, 0.99504587960532784, 0.99422377476197372,
        0.99329882096414281, 0.99225590294902998, 0.99107667840808991, 0.98973866633064662, 0.98821400853930854,
        0.98646775888750999, 0.9844554754851796, 0.9821197602933976, 0.97938516662097522, 0.97615049918620075,
        0.97227680266708181, 0.96756792973450632, 0.96173772038894817, 0.95435161864027946, 0.94471598838582307,
        0.93165072132299871, 0.91297032814046019, 0.88411564855885481, 0.83367824093644045, 0.72209384319331603,
        0.0, 0.99999768341832244, 1.0000023162650273, 1.0000306076942404, 1.0000731421231726, 1.0001250852299417,
        1.0001831195568362, 1.0002446816580725, 1.0003076571446372, 1.000370227360646, 1.0004307805079624,
        1.000487854647378, 1.0005400981471023, 1.0005862403765899, 1.0006250687113, 1.0006554095352917,
        1.000676111791219, 1.0006860321105362, 1.000684020836803, 1.0006689084193584, 1.0006394917490464,
        1.0005945200568488, 1.0005326800137623, 1.0004525796632293, 1.0003527307891969, 1.0002315292740252,
        1.0000872329295467, 0.99991793618813927, 0.99972154091323671, 0.99949572242222178, 0.9992378895979063,
        0.9989451376822054, 0.99861419197559526, 0.9982413401785108, 0.99782235046398478, 0.99735237150516439,
        0.99682580951201928, 0.99623617573592745, 0.99557589569933568, 0.99483606833382268, 0.99400615886213307,
        0.993073603023398, 0.99202329115817242, 0.99083688722061693, 0.98949191750448495, 0.98796053267071246,
        0.98620779759909383, 0.98418928451017402, 0.98184761382471884, 0.97910736349944467, 0.97586737184821115,
        0.9719887303761038, 0.96727535872260368, 0.96144119564904774, 0.9540518364226718, 0.94441388792346782,
        0.9313476571215054, 0.91266842607187263, 0.88381864650780887, 0.83339391389607631, 0.72184396674082858,
        0.0, 0.99999779554573935, 1.0000022041626624, 1.0000292730182193, 1.0000700455491654, 1.0001199255734015,
        1.0001757607288977, 1.0002351164380629, 1.000295985743354, 1.0003566435093092, 1.0004155620031501,
        1.0004713568480764, 1.0005227496141056, 1.0005685401924673, 1.000607585211552, 1.0006387802973686,
        1.000661044804369, 1.0006733081044485, 1.0006744967907744, 1.0006635223122411, 1.0006392686474552,
        1.0006005796779446, 1.0005462459418936, 1.0004749904492621, 1.0003854532201913, 1.0002761741722223,
        1.0001455739273736, 0.99999193203520898, 0.99981336200874424, 0.99960778244052985, 0.9993728832982597,
        0.99910608628140761, 0.99880449783699206, 0.99846485306198116, 0.99808344823203798, 0.99765605904924039,
        0.99717784083569337, 0.9966432057307489, 0.99604567035423674, 0.99537766519718297, 0.99463029392851809,
        0.99379302645987131, 0.99285330337621793, 0.99179602026057495, 0.99060284699616209, 0.98925131685565478,
        0.987713588998919, 0.98595473895206228, 0.98393035259132975, 0.98158306822144476, 0.9788374876859384,
        0.97559248185309733, 0.97170918758895953, 0.96699158937872102, 0.96115372157611738, 0.953761325802636,
        0.94412124397953882, 0.93105418469460695, 0.91237617589983675, 0.88353122797671206, 0.83311883967039937,
        0.72160228573177767, 0.0, 0.9999979005512636, 1.0000020991798487, 1.0000280161577534, 1.0000671245649219,
        1.000115050960578, 1.0001687972971142, 1.0002260493645932, 1.0002849004695912, 1.0003437126711242,
        1.000401036516315, 1.00045555973687, 1.0005060718212983, 1.0005514379345079, 1.0005905786224335,
        1.0006224532125529, 1.0006460456065545, 1.000660351603115, 1.0006643671467054, 1.0006570770521348,
        1.0006374438458584, 1.0006043964166695, 1.0005568181929463, 1.00049353456817, 1.0004132992846235,
        1.000314779458479, 1.0001965388877349, 1.0000570192261814, 0.99989451852894352, 0.99970716657388682,
        0.99949289623221353, 0.99924940999252418, 0.9989741405239871, 0.99866420388029027, 0.99831634357506751,
        0.9979268632714319, 0.99749154518106999, 0.99700555040265649, 0.99646329626031674, 0.99585830410790232,
        0.99518300886449881, 0.99442851847450265, 0.99358430714053356, 0.99263781994509459, 0.99157395740025289,
        0.99037439502422588, 0.98901667277663087, 0.98747295800620974, 0.98570833653250353, 0.9836784074598193,
        0.98132582643128383, 0.97857521845285212, 0.97532548595436646, 0.97143780976399401, 0.96671623718776337,
        0.96087489515135086, 0.95347966695938772, 0.94383762201306593, 0.93076985752226033, 0.91209312310388712,
        0.88325293702668559, 0.83285257402753211, 0.72136840348993013, 0.0
    };
    return table;
}

/* END GENERATED */

/* BEGIN GENERATED: prt_codegen --lang c --emit ch_eval,ch_at --bands 1-10 */
/* CH basis, 1 band: 0 multiplications, 0 additions (0 can fuse), 1 stores */
PRT__STATIC void prt__ch_eval_1(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    (void)x;
    (void)y;
    (void)z;
    out[0] = PRT__R(0.282094791773878143474);
}

/* CH basis, 1 band: 0 multiplications, 0 additions (0 can fuse), 1 stores */
PRT__STATIC void prt__ch_eval_1_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    (void)xs;
    (void)ys;
    (void)zs;
    (void)stride;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
    }
}

/* CH basis, 2 bands: 3 multiplications, 0 additions (0 can fuse), 4 stores */
PRT__STATIC void prt__ch_eval_2(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
}

/* CH basis, 2 bands: 3 multiplications, 0 additions (0 can fuse), 4 stores */
PRT__STATIC void prt__ch_eval_2_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
}

/* CH basis, 3 bands: 12 multiplications, 4 additions (1 can fuse), 9 stores */
PRT__STATIC void prt__ch_eval_3(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    out[6] = PRT__R(0.825888983611586872968) * (z * z) - PRT__R(0.412944491805793436484);
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t1 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t1;
    out[7] = x * t1;
    const prt_real t2 = y * x;
    out[4] = PRT__R(0.546274215296039535272) * (t2 + t2);
    out[8] = PRT__R(0.546274215296039535272) * ((y + x) * (x - y));
}

/* CH basis, 3 bands: 12 multiplications, 4 additions (1 can fuse), 9 stores */
PRT__STATIC void prt__ch_eval_3_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        prt__vec_store(out + 6 * stride, PRT__R(0.825888983611586872968) * (z * z) - PRT__R(0.412944491805793436484));
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t2 + t2));
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * ((y + x) * (x - y)));
    }
}

/* CH basis, 4 bands: 25 multiplications, 11 additions (3 can fuse), 16 stores */
PRT__STATIC void prt__ch_eval_4(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    out[6] = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
    const prt_real t2 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
    out[12] = z * t2;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t3 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t3;
    out[7] = x * t3;
    const prt_real t4 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
    out[11] = y * t4;
    out[13] = x * t4;
    const prt_real t5 = y * x;
    const prt_real t6 = t5 + t5;
    out[4] = PRT__R(0.546274215296039535272) * t6;
    const prt_real t7 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t7;
    const prt_real t8 = PRT__R(1.44530572132027702769) * z;
    out[10] = t6 * t8;
    out[14] = t7 * t8;
    const prt_real t9 = y * y;
    const prt_real t10 = t7 + t9;
    out[9] = PRT__R(0.590043589926643510346) * (y * (t7 + (t10 + t10)));
    out[15] = PRT__R(0.590043589926643510346) * (x * (t7 - (t9 + t9)));
}

/* CH basis, 4 bands: 25 multiplications, 11 additions (3 can fuse), 16 stores */
PRT__STATIC void prt__ch_eval_4_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        prt__vec_store(out + 6 * stride, PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484));
        const prt__vec t2 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        prt__vec_store(out + 12 * stride, z * t2);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t3 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t3);
        prt__vec_store(out + 7 * stride, x * t3);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(2.2251937260415151452) * (z * z) - PRT__R(0.556298431510378786299);
        prt__vec_store(out + 11 * stride, y * t1);
        prt__vec_store(out + 13 * stride, x * t1);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t3);
        const prt__vec t4 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t4);
        const prt__vec t5 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t3 * t5);
        prt__vec_store(out + 14 * stride, t4 * t5);
        const prt__vec t6 = y * y;
        const prt__vec t7 = t4 + t6;
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * (y * (t4 + (t7 + t7))));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * (x * (t4 - (t6 + t6))));
    }
}

/* CH basis, 5 bands: 41 multiplications, 17 additions (6 can fuse), 25 stores */
PRT__STATIC void prt__ch_eval_5(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
    out[12] = z * t3;
    out[20] = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t4 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t4;
    out[7] = x * t4;
    const prt_real t5 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
    out[11] = y * t5;
    out[13] = x * t5;
    const prt_real t6 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
    const prt_real t7 = z * t6;
    out[19] = y * t7;
    out[21] = x * t7;
    const prt_real t8 = y * x;
    const prt_real t9 = t8 + t8;
    out[4] = PRT__R(0.546274215296039535272) * t9;
    const prt_real t10 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t10;
    const prt_real t11 = PRT__R(1.44530572132027702769) * z;
    out[10] = t9 * t11;
    out[14] = t10 * t11;
    const prt_real t12 = PRT__R(3.27764529177623721163) * t1 - PRT__R(0.546274215296039535272);
    out[18] = t9 * t12;
    out[22] = t10 * t12;
    const prt_real t13 = y * y;
    const prt_real t14 = t10 + t13;
    const prt_real t15 = y * (t10 + (t14 + t14));
    out[9] = PRT__R(0.590043589926643510346) * t15;
    const prt_real t16 = x * (t10 - (t13 + t13));
    out[15] = PRT__R(0.590043589926643510346) * t16;
    const prt_real t17 = PRT__R(1.77013076977993053104) * z;
    out[17] = t15 * t17;
    out[23] = t16 * t17;
    const prt_real t18 = t10 * t9;
    out[16] = PRT__R(0.625835735449176134587) * (t18 + t18);
    out[24] = PRT__R(0.625835735449176134587) * ((t10 + t9) * (t10 - t9));
}

/* CH basis, 5 bands: 41 multiplications, 17 additions (6 can fuse), 25 stores */
PRT__STATIC void prt__ch_eval_5_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        prt__vec_store(out + 12 * stride, z * t3);
        prt__vec_store(out + 20 * stride, t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061));
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
        const prt__vec t5 = z * t4;
        prt__vec_store(out + 19 * stride, y * t5);
        prt__vec_store(out + 21 * stride, x * t5);
        const prt__vec t6 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t6 + t6));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t1);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t3 * t4);
        prt__vec_store(out + 14 * stride, t1 * t4);
        const prt__vec t5 = PRT__R(3.27764529177623721163) * (z * z) - PRT__R(0.546274215296039535272);
        prt__vec_store(out + 18 * stride, t3 * t5);
        prt__vec_store(out + 22 * stride, t1 * t5);
        const prt__vec t6 = y * y;
        const prt__vec t7 = t1 + t6;
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * (y * (t1 + (t7 + t7))));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * (x * (t1 - (t6 + t6))));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, (y * (t1 + (t3 + t3))) * t4);
        prt__vec_store(out + 23 * stride, (x * (t1 - (t2 + t2))) * t4);
        const prt__vec t5 = y * x;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = t1 * t6;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * (t7 + t7));
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * ((t1 + t6) * (t1 - t6)));
    }
}

/* CH basis, 6 bands: 64 multiplications, 24 additions (13 can fuse), 36 stores */
PRT__STATIC void prt__ch_eval_6(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
    out[20] = t5;
    out[30] = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t6 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t6;
    out[7] = x * t6;
    const prt_real t7 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
    out[11] = y * t7;
    out[13] = x * t7;
    const prt_real t8 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
    const prt_real t9 = z * t8;
    out[19] = y * t9;
    out[21] = x * t9;
    const prt_real t10 = PRT__R(1.81395700920230242682) * t7 - PRT__R(1.00910143904649857838);
    const prt_real t11 = t7 * t10 - PRT__R(0.561361547776433262911);
    out[29] = y * t11;
    out[31] = x * t11;
    const prt_real t12 = y * x;
    const prt_real t13 = t12 + t12;
    out[4] = PRT__R(0.546274215296039535272) * t13;
    const prt_real t14 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t14;
    const prt_real t15 = PRT__R(1.44530572132027702769) * z;
    out[10] = t13 * t15;
    out[14] = t14 * t15;
    const prt_real t16 = PRT__R(3.27764529177623721163) * t1 - PRT__R(0.546274215296039535272);
    out[18] = t13 * t16;
    out[22] = t14 * t16;
    const prt_real t17 = PRT__R(7.04063249082559160399) * t1 - PRT__R(2.6402371840595968515);
    const prt_real t18 = z * t17;
    out[28] = t13 * t18;
    out[32] = t14 * t18;
    const prt_real t19 = y * y;
    const prt_real t20 = t14 + t19;
    const prt_real t21 = y * (t14 + (t20 + t20));
    out[9] = PRT__R(0.590043589926643510346) * t21;
    const prt_real t22 = x * (t14 - (t19 + t19));
    out[15] = PRT__R(0.590043589926643510346) * t22;
    const prt_real t23 = PRT__R(1.77013076977993053104) * z;
    out[17] = t21 * t23;
    out[23] = t22 * t23;
    const prt_real t24 = PRT__R(4.37968383934737954461) * t1 - PRT__R(0.547460479918422443076);
    out[27] = t21 * t24;
    out[33] = t22 * t24;
    const prt_real t25 = t14 * t13;
    const prt_real t26 = t25 + t25;
    out[16] = PRT__R(0.625835735449176134587) * t26;
    const prt_real t27 = (t14 + t13) * (t14 - t13);
    out[24] = PRT__R(0.625835735449176134587) * t27;
    const prt_real t28 = PRT__R(2.075662314881041279) * z;
    out[26] = t26 * t28;
    out[34] = t27 * t28;
    out[25] = PRT__R(0.656382056840170102814) * (y * t27 + x * t26);
    out[35] = PRT__R(0.656382056840170102814) * (x * t27 - y * t26);
}

/* CH basis, 6 bands: 64 multiplications, 24 additions (13 can fuse), 36 stores */
PRT__STATIC void prt__ch_eval_6_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
        prt__vec_store(out + 20 * stride, t5);
        prt__vec_store(out + 30 * stride, PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
        const prt__vec t5 = z * t4;
        prt__vec_store(out + 19 * stride, y * t5);
        prt__vec_store(out + 21 * stride, x * t5);
        const prt__vec t6 = PRT__R(1.81395700920230242682) * t3 - PRT__R(1.00910143904649857838);
        const prt__vec t7 = t3 * t6 - PRT__R(0.561361547776433262911);
        prt__vec_store(out + 29 * stride, y * t7);
        prt__vec_store(out + 31 * stride, x * t7);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t2);
        const prt__vec t3 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t3);
        const prt__vec t4 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t2 * t4);
        prt__vec_store(out + 14 * stride, t3 * t4);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(3.27764529177623721163) * t5 - PRT__R(0.546274215296039535272);
        prt__vec_store(out + 18 * stride, t2 * t6);
        prt__vec_store(out + 22 * stride, t3 * t6);
        const prt__vec t7 = PRT__R(7.04063249082559160399) * t5 - PRT__R(2.6402371840595968515);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 28 * stride, t2 * t8);
        prt__vec_store(out + 32 * stride, t3 * t8);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = y * (t1 + (t3 + t3));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t4);
        const prt__vec t5 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t5);
        const prt__vec t6 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t4 * t6);
        prt__vec_store(out + 23 * stride, t5 * t6);
        const prt__vec t7 = PRT__R(4.37968383934737954461) * (z * z) - PRT__R(0.547460479918422443076);
        prt__vec_store(out + 27 * stride, t4 * t7);
        prt__vec_store(out + 33 * stride, t5 * t7);
        const prt__vec t8 = y * x;
        const prt__vec t9 = t8 + t8;
        const prt__vec t10 = t1 * t9;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * (t10 + t10));
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * ((t1 + t9) * (t1 - t9)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = t1 * t3;
        const prt__vec t5 = t4 + t4;
        const prt__vec t6 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t5 * t6);
        const prt__vec t7 = (t1 + t3) * (t1 - t3);
        prt__vec_store(out + 34 * stride, t7 * t6);
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * (y * t7 + x * t5));
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * (x * t7 - y * t5));
    }
}

/* CH basis, 7 bands: 90 multiplications, 33 additions (19 can fuse), 49 stores */
PRT__STATIC void prt__ch_eval_7(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
    out[20] = t5;
    const prt_real t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
    out[30] = t6;
    out[42] = PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t7 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t7;
    out[7] = x * t7;
    const prt_real t8 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
    out[11] = y * t8;
    out[13] = x * t8;
    const prt_real t9 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
    const prt_real t10 = z * t9;
    out[19] = y * t10;
    out[21] = x * t10;
    const prt_real t11 = PRT__R(1.81395700920230242682) * t8 - PRT__R(1.00910143904649857838);
    const prt_real t12 = t8 * t11 - PRT__R(0.561361547776433262911);
    out[29] = y * t12;
    out[31] = x * t12;
    const prt_real t13 = PRT__R(2.00308404192443849618) * (z * t12) - PRT__R(1.00439949330516663946) * t10;
    out[41] = y * t13;
    out[43] = x * t13;
    const prt_real t14 = y * x;
    const prt_real t15 = t14 + t14;
    out[4] = PRT__R(0.546274215296039535272) * t15;
    const prt_real t16 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t16;
    const prt_real t17 = PRT__R(1.44530572132027702769) * z;
    out[10] = t15 * t17;
    out[14] = t16 * t17;
    const prt_real t18 = PRT__R(3.27764529177623721163) * t1 - PRT__R(0.546274215296039535272);
    out[18] = t15 * t18;
    out[22] = t16 * t18;
    const prt_real t19 = PRT__R(7.04063249082559160399) * t1 - PRT__R(2.6402371840595968515);
    const prt_real t20 = z * t19;
    out[28] = t15 * t20;
    out[32] = t16 * t20;
    const prt_real t21 = PRT__R(1.37233279507355082388) * t18 - PRT__R(1.19947203320611937035);
    const prt_real t22 = t18 * t21 - PRT__R(0.511906752897826512122);
    out[40] = t15 * t22;
    out[44] = t16 * t22;
    const prt_real t23 = y * y;
    const prt_real t24 = t16 + t23;
    const prt_real t25 = y * (t16 + (t24 + t24));
    out[9] = PRT__R(0.590043589926643510346) * t25;
    const prt_real t26 = x * (t16 - (t23 + t23));
    out[15] = PRT__R(0.590043589926643510346) * t26;
    const prt_real t27 = PRT__R(1.77013076977993053104) * z;
    out[17] = t25 * t27;
    out[23] = t26 * t27;
    const prt_real t28 = PRT__R(4.37968383934737954461) * t1 - PRT__R(0.547460479918422443076);
    out[27] = t25 * t28;
    out[33] = t26 * t28;
    const prt_real t29 = PRT__R(10.0119715893477442193) * t1 - PRT__R(3.0035914768043232658);
    const prt_real t30 = z * t29;
    out[39] = t25 * t30;
    out[45] = t26 * t30;
    const prt_real t31 = t16 * t15;
    const prt_real t32 = t31 + t31;
    out[16] = PRT__R(0.625835735449176134587) * t32;
    const prt_real t33 = (t16 + t15) * (t16 - t15);
    out[24] = PRT__R(0.625835735449176134587) * t33;
    const prt_real t34 = PRT__R(2.075662314881041279) * z;
    out[26] = t32 * t34;
    out[34] = t33 * t34;
    const prt_real t35 = PRT__R(5.53226317538874894011) * t1 - PRT__R(0.553226317538874894011);
    out[38] = t32 * t35;
    out[46] = t33 * t35;
    const prt_real t36 = y * t33 + x * t32;
    out[25] = PRT__R(0.656382056840170102814) * t36;
    const prt_real t37 = x * t33 - y * t32;
    out[35] = PRT__R(0.656382056840170102814) * t37;
    const prt_real t38 = PRT__R(2.36661916223175203199) * z;
    out[37] = t36 * t38;
    out[47] = t37 * t38;
    const prt_real t39 = t26 * t25;
    out[36] = PRT__R(0.683184105191914321975) * (t39 + t39);
    out[48] = PRT__R(0.683184105191914321975) * ((t26 + t25) * (t26 - t25));
}

/* CH basis, 7 bands: 90 multiplications, 33 additions (19 can fuse), 49 stores */
PRT__STATIC void prt__ch_eval_7_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
        prt__vec_store(out + 20 * stride, t5);
        const prt__vec t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
        prt__vec_store(out + 30 * stride, t6);
        prt__vec_store(out + 42 * stride, PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
        prt__vec_store(out + 19 * stride, y * (z * t4));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
        const prt__vec t3 = z * t2;
        prt__vec_store(out + 21 * stride, x * t3);
        const prt__vec t4 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        const prt__vec t5 = PRT__R(1.81395700920230242682) * t4 - PRT__R(1.00910143904649857838);
        const prt__vec t6 = t4 * t5 - PRT__R(0.561361547776433262911);
        prt__vec_store(out + 29 * stride, y * t6);
        prt__vec_store(out + 31 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.00308404192443849618) * (z * t6) - PRT__R(1.00439949330516663946) * t3;
        prt__vec_store(out + 41 * stride, y * t7);
        prt__vec_store(out + 43 * stride, x * t7);
        const prt__vec t8 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t8 + t8));
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * ((y + x) * (x - y)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t2 * t3);
        const prt__vec t4 = (y + x) * (x - y);
        prt__vec_store(out + 14 * stride, t4 * t3);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(3.27764529177623721163) * t5 - PRT__R(0.546274215296039535272);
        prt__vec_store(out + 18 * stride, t2 * t6);
        prt__vec_store(out + 22 * stride, t4 * t6);
        const prt__vec t7 = PRT__R(7.04063249082559160399) * t5 - PRT__R(2.6402371840595968515);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 28 * stride, t2 * t8);
        prt__vec_store(out + 32 * stride, t4 * t8);
        const prt__vec t9 = PRT__R(1.37233279507355082388) * t6 - PRT__R(1.19947203320611937035);
        prt__vec_store(out + 40 * stride, t2 * (t6 * t9 - PRT__R(0.511906752897826512122)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
        const prt__vec t4 = PRT__R(1.37233279507355082388) * t3 - PRT__R(1.19947203320611937035);
        prt__vec_store(out + 44 * stride, t1 * (t3 * t4 - PRT__R(0.511906752897826512122)));
        const prt__vec t5 = y * y;
        const prt__vec t6 = t1 + t5;
        const prt__vec t7 = y * (t1 + (t6 + t6));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t7);
        const prt__vec t8 = x * (t1 - (t5 + t5));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t8);
        const prt__vec t9 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t7 * t9);
        prt__vec_store(out + 23 * stride, t8 * t9);
        const prt__vec t10 = PRT__R(4.37968383934737954461) * t2 - PRT__R(0.547460479918422443076);
        prt__vec_store(out + 27 * stride, t7 * t10);
        prt__vec_store(out + 33 * stride, t8 * t10);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = z * z;
        const prt__vec t5 = PRT__R(10.0119715893477442193) * t4 - PRT__R(3.0035914768043232658);
        const prt__vec t6 = z * t5;
        prt__vec_store(out + 39 * stride, (y * (t1 + (t3 + t3))) * t6);
        prt__vec_store(out + 45 * stride, (x * (t1 - (t2 + t2))) * t6);
        const prt__vec t7 = y * x;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = t1 * t8;
        const prt__vec t10 = t9 + t9;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t10);
        const prt__vec t11 = (t1 + t8) * (t1 - t8);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t11);
        const prt__vec t12 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t10 * t12);
        prt__vec_store(out + 34 * stride, t11 * t12);
        const prt__vec t13 = PRT__R(5.53226317538874894011) * t4 - PRT__R(0.553226317538874894011);
        prt__vec_store(out + 38 * stride, t10 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = PRT__R(5.53226317538874894011) * (z * z) - PRT__R(0.553226317538874894011);
        prt__vec_store(out + 46 * stride, t4 * t5);
        const prt__vec t6 = t1 * t3;
        const prt__vec t7 = t6 + t6;
        const prt__vec t8 = y * t4 + x * t7;
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * t8);
        const prt__vec t9 = x * t4 - y * t7;
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * t9);
        const prt__vec t10 = PRT__R(2.36661916223175203199) * z;
        prt__vec_store(out + 37 * stride, t8 * t10);
        prt__vec_store(out + 47 * stride, t9 * t10);
        const prt__vec t11 = y * y;
        const prt__vec t12 = x * (t1 - (t11 + t11));
        const prt__vec t13 = t1 + t11;
        const prt__vec t14 = y * (t1 + (t13 + t13));
        const prt__vec t15 = t12 * t14;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * (t15 + t15));
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * ((t12 + t14) * (t12 - t14)));
    }
}

/* CH basis, 8 bands: 123 multiplications, 42 additions (28 can fuse), 64 stores */
PRT__STATIC void prt__ch_eval_8(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
    out[20] = t5;
    const prt_real t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
    out[30] = t6;
    const prt_real t7 = PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5;
    out[42] = t7;
    out[56] = PRT__R(1.9981247065730924832) * (z * t7) - PRT__R(0.99749765012849593691) * t6;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t8 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t8;
    out[7] = x * t8;
    const prt_real t9 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
    out[11] = y * t9;
    out[13] = x * t9;
    const prt_real t10 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
    const prt_real t11 = z * t10;
    out[19] = y * t11;
    out[21] = x * t11;
    const prt_real t12 = PRT__R(1.81395700920230242682) * t9 - PRT__R(1.00910143904649857838);
    const prt_real t13 = t9 * t12 - PRT__R(0.561361547776433262911);
    out[29] = y * t13;
    out[31] = x * t13;
    const prt_real t14 = PRT__R(2.00308404192443849618) * (z * t13) - PRT__R(1.00439949330516663946) * t11;
    out[41] = y * t14;
    out[43] = x * t14;
    const prt_real t15 = PRT__R(2.00185442784391621093) * (z * t14) - PRT__R(1.00247066466748147447) * t13;
    out[55] = y * t15;
    out[57] = x * t15;
    const prt_real t16 = y * x;
    const prt_real t17 = t16 + t16;
    out[4] = PRT__R(0.546274215296039535272) * t17;
    const prt_real t18 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t18;
    const prt_real t19 = PRT__R(1.44530572132027702769) * z;
    out[10] = t17 * t19;
    out[14] = t18 * t19;
    const prt_real t20 = PRT__R(3.27764529177623721163) * t1 - PRT__R(0.546274215296039535272);
    out[18] = t17 * t20;
    out[22] = t18 * t20;
    const prt_real t21 = PRT__R(7.04063249082559160399) * t1 - PRT__R(2.6402371840595968515);
    const prt_real t22 = z * t21;
    out[28] = t17 * t22;
    out[32] = t18 * t22;
    const prt_real t23 = PRT__R(1.37233279507355082388) * t20 - PRT__R(1.19947203320611937035);
    const prt_real t24 = t20 * t23 - PRT__R(0.511906752897826512122);
    out[40] = t17 * t24;
    out[44] = t18 * t24;
    const prt_real t25 = PRT__R(2.06485074947180018626) * (z * t24) - PRT__R(1.00887444616012613957) * t22;
    out[54] = t17 * t25;
    out[58] = t18 * t25;
    const prt_real t26 = y * y;
    const prt_real t27 = t18 + t26;
    const prt_real t28 = y * (t18 + (t27 + t27));
    out[9] = PRT__R(0.590043589926643510346) * t28;
    const prt_real t29 = x * (t18 - (t26 + t26));
    out[15] = PRT__R(0.590043589926643510346) * t29;
    const prt_real t30 = PRT__R(1.77013076977993053104) * z;
    out[17] = t28 * t30;
    out[23] = t29 * t30;
    const prt_real t31 = PRT__R(4.37968383934737954461) * t1 - PRT__R(0.547460479918422443076);
    out[27] = t28 * t31;
    out[33] = t29 * t31;
    const prt_real t32 = PRT__R(10.0119715893477442193) * t1 - PRT__R(3.0035914768043232658);
    const prt_real t33 = z * t32;
    out[39] = t28 * t33;
    out[45] = t29 * t33;
    const prt_real t34 = PRT__R(1.14470177335741903992) * t31 - PRT__R(1.25335796441144373015);
    const prt_real t35 = t31 * t34 - PRT__R(0.48031476689438621492);
    out[53] = t28 * t35;
    out[59] = t29 * t35;
    const prt_real t36 = t18 * t17;
    const prt_real t37 = t36 + t36;
    out[16] = PRT__R(0.625835735449176134587) * t37;
    const prt_real t38 = (t18 + t17) * (t18 - t17);
    out[24] = PRT__R(0.625835735449176134587) * t38;
    const prt_real t39 = PRT__R(2.075662314881041279) * z;
    out[26] = t37 * t39;
    out[34] = t38 * t39;
    const prt_real t40 = PRT__R(5.53226317538874894011) * t1 - PRT__R(0.553226317538874894011);
    out[38] = t37 * t40;
    out[46] = t38 * t40;
    const prt_real t41 = PRT__R(13.3876196648007832099) * t1 - PRT__R(3.34690491620019580249);
    const prt_real t42 = z * t41;
    out[52] = t37 * t42;
    out[60] = t38 * t42;
    const prt_real t43 = y * t38 + x * t37;
    out[25] = PRT__R(0.656382056840170102814) * t43;
    const prt_real t44 = x * t38 - y * t37;
    out[35] = PRT__R(0.656382056840170102814) * t44;
    const prt_real t45 = PRT__R(2.36661916223175203199) * z;
    out[37] = t43 * t45;
    out[47] = t44 * t45;
    const prt_real t46 = PRT__R(6.73131046101657472554) * t1 - PRT__R(0.560942538418047893795);
    out[51] = t43 * t46;
    out[61] = t44 * t46;
    const prt_real t47 = t29 * t28;
    const prt_real t48 = t47 + t47;
    out[36] = PRT__R(0.683184105191914321975) * t48;
    const prt_real t49 = (t29 + t28) * (t29 - t28);
    out[48] = PRT__R(0.683184105191914321975) * t49;
    const prt_real t50 = PRT__R(2.64596066180190022197) * z;
    out[50] = t48 * t50;
    out[62] = t49 * t50;
    out[49] = PRT__R(0.707162732524596178226) * (y * t49 + x * t48);
    out[63] = PRT__R(0.707162732524596178226) * (x * t49 - y * t48);
}

/* CH basis, 8 bands: 123 multiplications, 42 additions (28 can fuse), 64 stores */
PRT__STATIC void prt__ch_eval_8_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
        prt__vec_store(out + 20 * stride, t5);
        const prt__vec t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
        prt__vec_store(out + 30 * stride, t6);
        const prt__vec t7 = PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5;
        prt__vec_store(out + 42 * stride, t7);
        prt__vec_store(out + 56 * stride, PRT__R(1.9981247065730924832) * (z * t7) - PRT__R(0.99749765012849593691) * t6);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t1 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t1);
        prt__vec_store(out + 7 * stride, x * t1);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
        prt__vec_store(out + 11 * stride, y * t3);
        prt__vec_store(out + 13 * stride, x * t3);
        const prt__vec t4 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
        const prt__vec t5 = z * t4;
        prt__vec_store(out + 19 * stride, y * t5);
        prt__vec_store(out + 21 * stride, x * t5);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        const prt__vec t3 = PRT__R(1.81395700920230242682) * t2 - PRT__R(1.00910143904649857838);
        const prt__vec t4 = t2 * t3 - PRT__R(0.561361547776433262911);
        prt__vec_store(out + 29 * stride, y * t4);
        prt__vec_store(out + 31 * stride, x * t4);
        const prt__vec t5 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
        const prt__vec t6 = PRT__R(2.00308404192443849618) * (z * t4) - PRT__R(1.00439949330516663946) * (z * t5);
        prt__vec_store(out + 41 * stride, y * t6);
        prt__vec_store(out + 43 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.00185442784391621093) * (z * t6) - PRT__R(1.00247066466748147447) * t4;
        prt__vec_store(out + 55 * stride, y * t7);
        prt__vec_store(out + 57 * stride, x * t7);
        const prt__vec t8 = y * x;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * (t8 + t8));
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * ((y + x) * (x - y)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t2 * t3);
        const prt__vec t4 = (y + x) * (x - y);
        prt__vec_store(out + 14 * stride, t4 * t3);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(3.27764529177623721163) * t5 - PRT__R(0.546274215296039535272);
        prt__vec_store(out + 18 * stride, t2 * t6);
        prt__vec_store(out + 22 * stride, t4 * t6);
        const prt__vec t7 = PRT__R(7.04063249082559160399) * t5 - PRT__R(2.6402371840595968515);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 28 * stride, t2 * t8);
        prt__vec_store(out + 32 * stride, t4 * t8);
        const prt__vec t9 = PRT__R(1.37233279507355082388) * t6 - PRT__R(1.19947203320611937035);
        const prt__vec t10 = t6 * t9 - PRT__R(0.511906752897826512122);
        prt__vec_store(out + 40 * stride, t2 * t10);
        prt__vec_store(out + 44 * stride, t4 * t10);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
        const prt__vec t4 = PRT__R(1.37233279507355082388) * t3 - PRT__R(1.19947203320611937035);
        const prt__vec t5 = PRT__R(2.06485074947180018626) * (z * (t3 * t4 - PRT__R(0.511906752897826512122)));
        const prt__vec t6 = PRT__R(7.04063249082559160399) * t2 - PRT__R(2.6402371840595968515);
        const prt__vec t7 = t5 - PRT__R(1.00887444616012613957) * (z * t6);
        prt__vec_store(out + 54 * stride, (t1 + t1) * t7);
        const prt__vec t8 = (y + x) * (x - y);
        prt__vec_store(out + 58 * stride, t8 * t7);
        const prt__vec t9 = y * y;
        const prt__vec t10 = t8 + t9;
        const prt__vec t11 = y * (t8 + (t10 + t10));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t11);
        const prt__vec t12 = x * (t8 - (t9 + t9));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t12);
        const prt__vec t13 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t11 * t13);
        prt__vec_store(out + 23 * stride, t12 * t13);
        const prt__vec t14 = PRT__R(4.37968383934737954461) * t2 - PRT__R(0.547460479918422443076);
        prt__vec_store(out + 27 * stride, t11 * t14);
        prt__vec_store(out + 33 * stride, t12 * t14);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = y * (t1 + (t3 + t3));
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(10.0119715893477442193) * t5 - PRT__R(3.0035914768043232658);
        const prt__vec t7 = z * t6;
        prt__vec_store(out + 39 * stride, t4 * t7);
        const prt__vec t8 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 45 * stride, t8 * t7);
        const prt__vec t9 = PRT__R(4.37968383934737954461) * t5 - PRT__R(0.547460479918422443076);
        const prt__vec t10 = PRT__R(1.14470177335741903992) * t9 - PRT__R(1.25335796441144373015);
        const prt__vec t11 = t9 * t10 - PRT__R(0.48031476689438621492);
        prt__vec_store(out + 53 * stride, t4 * t11);
        prt__vec_store(out + 59 * stride, t8 * t11);
        const prt__vec t12 = y * x;
        const prt__vec t13 = t12 + t12;
        const prt__vec t14 = t1 * t13;
        const prt__vec t15 = t14 + t14;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t15);
        const prt__vec t16 = (t1 + t13) * (t1 - t13);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t16);
        const prt__vec t17 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t15 * t17);
        prt__vec_store(out + 34 * stride, t16 * t17);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = t1 * t3;
        const prt__vec t5 = t4 + t4;
        const prt__vec t6 = z * z;
        const prt__vec t7 = PRT__R(5.53226317538874894011) * t6 - PRT__R(0.553226317538874894011);
        prt__vec_store(out + 38 * stride, t5 * t7);
        const prt__vec t8 = (t1 + t3) * (t1 - t3);
        prt__vec_store(out + 46 * stride, t8 * t7);
        const prt__vec t9 = PRT__R(13.3876196648007832099) * t6 - PRT__R(3.34690491620019580249);
        const prt__vec t10 = z * t9;
        prt__vec_store(out + 52 * stride, t5 * t10);
        prt__vec_store(out + 60 * stride, t8 * t10);
        const prt__vec t11 = y * t8 + x * t5;
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * t11);
        const prt__vec t12 = x * t8 - y * t5;
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * t12);
        const prt__vec t13 = PRT__R(2.36661916223175203199) * z;
        prt__vec_store(out + 37 * stride, t11 * t13);
        prt__vec_store(out + 47 * stride, t12 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = PRT__R(6.73131046101657472554) * (z * z) - PRT__R(0.560942538418047893795);
        prt__vec_store(out + 51 * stride, (y * t4 + x * t6) * t7);
        prt__vec_store(out + 61 * stride, (x * t4 - y * t6) * t7);
        const prt__vec t8 = y * y;
        const prt__vec t9 = x * (t1 - (t8 + t8));
        const prt__vec t10 = t1 + t8;
        const prt__vec t11 = y * (t1 + (t10 + t10));
        const prt__vec t12 = t9 * t11;
        const prt__vec t13 = t12 + t12;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * t13);
        const prt__vec t14 = (t9 + t11) * (t9 - t11);
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * t14);
        const prt__vec t15 = PRT__R(2.64596066180190022197) * z;
        prt__vec_store(out + 50 * stride, t13 * t15);
        prt__vec_store(out + 62 * stride, t14 * t15);
        prt__vec_store(out + 49 * stride, PRT__R(0.707162732524596178226) * (y * t14 + x * t13));
        prt__vec_store(out + 63 * stride, PRT__R(0.707162732524596178226) * (x * t14 - y * t13));
    }
}

/* CH basis, 9 bands: 159 multiplications, 53 additions (36 can fuse), 81 stores */
PRT__STATIC void prt__ch_eval_9(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
    out[20] = t5;
    const prt_real t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
    out[30] = t6;
    const prt_real t7 = PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5;
    out[42] = t7;
    const prt_real t8 = PRT__R(1.9981247065730924832) * (z * t7) - PRT__R(0.99749765012849593691) * t6;
    out[56] = t8;
    out[72] = PRT__R(1.99878824587482633945) * (z * t8) - PRT__R(0.998457044322595902884) * t7;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t9 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t9;
    out[7] = x * t9;
    const prt_real t10 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
    out[11] = y * t10;
    out[13] = x * t10;
    const prt_real t11 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
    const prt_real t12 = z * t11;
    out[19] = y * t12;
    out[21] = x * t12;
    const prt_real t13 = PRT__R(1.81395700920230242682) * t10 - PRT__R(1.00910143904649857838);
    const prt_real t14 = t10 * t13 - PRT__R(0.561361547776433262911);
    out[29] = y * t14;
    out[31] = x * t14;
    const prt_real t15 = PRT__R(2.00308404192443849618) * (z * t14) - PRT__R(1.00439949330516663946) * t12;
    out[41] = y * t15;
    out[43] = x * t15;
    const prt_real t16 = PRT__R(2.00185442784391621093) * (z * t15) - PRT__R(1.00247066466748147447) * t14;
    out[55] = y * t16;
    out[57] = x * t16;
    const prt_real t17 = PRT__R(2.00120156213902958958) * (z * t16) - PRT__R(1.00152855204404460325) * t15;
    out[71] = y * t17;
    out[73] = x * t17;
    const prt_real t18 = y * x;
    const prt_real t19 = t18 + t18;
    out[4] = PRT__R(0.546274215296039535272) * t19;
    const prt_real t20 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t20;
    const prt_real t21 = PRT__R(1.44530572132027702769) * z;
    out[10] = t19 * t21;
    out[14] = t20 * t21;
    const prt_real t22 = PRT__R(3.27764529177623721163) * t1 - PRT__R(0.546274215296039535272);
    out[18] = t19 * t22;
    out[22] = t20 * t22;
    const prt_real t23 = PRT__R(7.04063249082559160399) * t1 - PRT__R(2.6402371840595968515);
    const prt_real t24 = z * t23;
    out[28] = t19 * t24;
    out[32] = t20 * t24;
    const prt_real t25 = PRT__R(1.37233279507355082388) * t22 - PRT__R(1.19947203320611937035);
    const prt_real t26 = t22 * t25 - PRT__R(0.511906752897826512122);
    out[40] = t19 * t26;
    out[44] = t20 * t26;
    const prt_real t27 = PRT__R(2.06485074947180018626) * (z * t26) - PRT__R(1.00887444616012613957) * t24;
    out[54] = t19 * t27;
    out[58] = t20 * t27;
    const prt_real t28 = PRT__R(2.047379529757827986) * (z * t27) - PRT__R(1.0065555134461126069) * t26;
    out[70] = t19 * t28;
    out[74] = t20 * t28;
    const prt_real t29 = y * y;
    const prt_real t30 = t20 + t29;
    const prt_real t31 = y * (t20 + (t30 + t30));
    out[9] = PRT__R(0.590043589926643510346) * t31;
    const prt_real t32 = x * (t20 - (t29 + t29));
    out[15] = PRT__R(0.590043589926643510346) * t32;
    const prt_real t33 = PRT__R(1.77013076977993053104) * z;
    out[17] = t31 * t33;
    out[23] = t32 * t33;
    const prt_real t34 = PRT__R(4.37968383934737954461) * t1 - PRT__R(0.547460479918422443076);
    out[27] = t31 * t34;
    out[33] = t32 * t34;
    const prt_real t35 = PRT__R(10.0119715893477442193) * t1 - PRT__R(3.0035914768043232658);
    const prt_real t36 = z * t35;
    out[39] = t31 * t36;
    out[45] = t32 * t36;
    const prt_real t37 = PRT__R(1.14470177335741903992) * t34 - PRT__R(1.25335796441144373015);
    const prt_real t38 = t34 * t37 - PRT__R(0.48031476689438621492);
    out[53] = t31 * t38;
    out[59] = t32 * t38;
    const prt_real t39 = PRT__R(2.13960769627671528242) * (z * t38) - PRT__R(1.00550825192169375133) * t36;
    out[69] = t31 * t39;
    out[75] = t32 * t39;
    const prt_real t40 = t20 * t19;
    const prt_real t41 = t40 + t40;
    out[16] = PRT__R(0.625835735449176134587) * t41;
    const prt_real t42 = (t20 + t19) * (t20 - t19);
    out[24] = PRT__R(0.625835735449176134587) * t42;
    const prt_real t43 = PRT__R(2.075662314881041279) * z;
    out[26] = t41 * t43;
    out[34] = t42 * t43;
    const prt_real t44 = PRT__R(5.53226317538874894011) * t1 - PRT__R(0.553226317538874894011);
    out[38] = t41 * t44;
    out[46] = t42 * t44;
    const prt_real t45 = PRT__R(13.3876196648007832099) * t1 - PRT__R(3.34690491620019580249);
    const prt_real t46 = z * t45;
    out[52] = t41 * t46;
    out[60] = t42 * t46;
    const prt_real t47 = PRT__R(1.00325462178684816145) * t44 - PRT__R(1.26863282277713073229);
    const prt_real t48 = t44 * t47 - PRT__R(0.460583198810398206878);
    out[68] = t41 * t48;
    out[76] = t42 * t48;
    const prt_real t49 = y * t42 + x * t41;
    out[25] = PRT__R(0.656382056840170102814) * t49;
    const prt_real t50 = x * t42 - y * t41;
    out[35] = PRT__R(0.656382056840170102814) * t50;
    const prt_real t51 = PRT__R(2.36661916223175203199) * z;
    out[37] = t49 * t51;
    out[47] = t50 * t51;
    const prt_real t52 = PRT__R(6.73131046101657472554) * t1 - PRT__R(0.560942538418047893795);
    out[51] = t49 * t52;
    out[61] = t50 * t52;
    const prt_real t53 = PRT__R(17.1567982383278290323) * t1 - PRT__R(3.67645676535596336405);
    const prt_real t54 = z * t53;
    out[67] = t49 * t54;
    out[77] = t50 * t54;
    const prt_real t55 = t32 * t31;
    const prt_real t56 = t55 + t55;
    out[36] = PRT__R(0.683184105191914321975) * t56;
    const prt_real t57 = (t32 + t31) * (t32 - t31);
    out[48] = PRT__R(0.683184105191914321975) * t57;
    const prt_real t58 = PRT__R(2.64596066180190022197) * z;
    out[50] = t56 * t58;
    out[62] = t57 * t58;
    const prt_real t59 = PRT__R(7.97265272468488541901) * t1 - PRT__R(0.569475194620348958501);
    out[66] = t56 * t59;
    out[78] = t57 * t59;
    const prt_real t60 = y * t57 + x * t56;
    out[49] = PRT__R(0.707162732524596178226) * t60;
    const prt_real t61 = x * t57 - y * t56;
    out[63] = PRT__R(0.707162732524596178226) * t61;
    const prt_real t62 = PRT__R(2.91570664069931947548) * z;
    out[65] = t60 * t62;
    out[79] = t61 * t62;
    const prt_real t63 = t42 * t41;
    out[64] = PRT__R(0.72892666017482986887) * (t63 + t63);
    out[80] = PRT__R(0.72892666017482986887) * ((t42 + t41) * (t42 - t41));
}

/* CH basis, 9 bands: 159 multiplications, 53 additions (36 can fuse), 81 stores */
PRT__STATIC void prt__ch_eval_9_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
        prt__vec_store(out + 20 * stride, t5);
        const prt__vec t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
        prt__vec_store(out + 30 * stride, t6);
        const prt__vec t7 = PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5;
        prt__vec_store(out + 42 * stride, t7);
        prt__vec_store(out + 56 * stride, PRT__R(1.9981247065730924832) * (z * t7) - PRT__R(0.99749765012849593691) * t6);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        const prt__vec t3 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
        const prt__vec t4 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        const prt__vec t5 = PRT__R(1.9941605714785482504) * (z * t3) - PRT__R(0.990626623845594065416) * (z * t4);
        const prt__vec t6 = PRT__R(1.99686765665245415552) * (z * t5) - PRT__R(0.995518686839271862673) * t3;
        const prt__vec t7 = PRT__R(1.9981247065730924832) * (z * t6) - PRT__R(0.99749765012849593691) * t5;
        prt__vec_store(out + 72 * stride, PRT__R(1.99878824587482633945) * (z * t7) - PRT__R(0.998457044322595902884) * t6);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t8 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t8);
        prt__vec_store(out + 7 * stride, x * t8);
        const prt__vec t9 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        prt__vec_store(out + 11 * stride, y * t9);
        prt__vec_store(out + 13 * stride, x * t9);
        const prt__vec t10 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
        prt__vec_store(out + 19 * stride, y * (z * t10));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
        const prt__vec t3 = z * t2;
        prt__vec_store(out + 21 * stride, x * t3);
        const prt__vec t4 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        const prt__vec t5 = PRT__R(1.81395700920230242682) * t4 - PRT__R(1.00910143904649857838);
        const prt__vec t6 = t4 * t5 - PRT__R(0.561361547776433262911);
        prt__vec_store(out + 29 * stride, y * t6);
        prt__vec_store(out + 31 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.00308404192443849618) * (z * t6) - PRT__R(1.00439949330516663946) * t3;
        prt__vec_store(out + 41 * stride, y * t7);
        prt__vec_store(out + 43 * stride, x * t7);
        const prt__vec t8 = PRT__R(2.00185442784391621093) * (z * t7) - PRT__R(1.00247066466748147447) * t6;
        prt__vec_store(out + 55 * stride, y * t8);
        prt__vec_store(out + 57 * stride, x * t8);
        const prt__vec t9 = PRT__R(2.00120156213902958958) * (z * t8) - PRT__R(1.00152855204404460325) * t7;
        prt__vec_store(out + 71 * stride, y * t9);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        const prt__vec t3 = PRT__R(1.81395700920230242682) * t2 - PRT__R(1.00910143904649857838);
        const prt__vec t4 = t2 * t3 - PRT__R(0.561361547776433262911);
        const prt__vec t5 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
        const prt__vec t6 = PRT__R(2.00308404192443849618) * (z * t4) - PRT__R(1.00439949330516663946) * (z * t5);
        const prt__vec t7 = PRT__R(2.00185442784391621093) * (z * t6) - PRT__R(1.00247066466748147447) * t4;
        const prt__vec t8 = PRT__R(2.00120156213902958958) * (z * t7) - PRT__R(1.00152855204404460325) * t6;
        prt__vec_store(out + 73 * stride, x * t8);
        const prt__vec t9 = y * x;
        const prt__vec t10 = t9 + t9;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t10);
        const prt__vec t11 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t11);
        const prt__vec t12 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t10 * t12);
        prt__vec_store(out + 14 * stride, t11 * t12);
        const prt__vec t13 = PRT__R(3.27764529177623721163) * t1 - PRT__R(0.546274215296039535272);
        prt__vec_store(out + 18 * stride, t10 * t13);
        prt__vec_store(out + 22 * stride, t11 * t13);
        const prt__vec t14 = PRT__R(7.04063249082559160399) * t1 - PRT__R(2.6402371840595968515);
        prt__vec_store(out + 28 * stride, t10 * (z * t14));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = z * z;
        const prt__vec t3 = PRT__R(7.04063249082559160399) * t2 - PRT__R(2.6402371840595968515);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 32 * stride, t1 * t4);
        const prt__vec t5 = y * x;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
        const prt__vec t8 = PRT__R(1.37233279507355082388) * t7 - PRT__R(1.19947203320611937035);
        const prt__vec t9 = t7 * t8 - PRT__R(0.511906752897826512122);
        prt__vec_store(out + 40 * stride, t6 * t9);
        prt__vec_store(out + 44 * stride, t1 * t9);
        const prt__vec t10 = PRT__R(2.06485074947180018626) * (z * t9) - PRT__R(1.00887444616012613957) * t4;
        prt__vec_store(out + 54 * stride, t6 * t10);
        prt__vec_store(out + 58 * stride, t1 * t10);
        const prt__vec t11 = PRT__R(2.047379529757827986) * (z * t10) - PRT__R(1.0065555134461126069) * t9;
        prt__vec_store(out + 70 * stride, t6 * t11);
        prt__vec_store(out + 74 * stride, t1 * t11);
        const prt__vec t12 = t1 + y * y;
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * (y * (t1 + (t12 + t12))));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t3);
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t5 * t6);
        prt__vec_store(out + 23 * stride, t3 * t6);
        const prt__vec t7 = z * z;
        const prt__vec t8 = PRT__R(4.37968383934737954461) * t7 - PRT__R(0.547460479918422443076);
        prt__vec_store(out + 27 * stride, t5 * t8);
        prt__vec_store(out + 33 * stride, t3 * t8);
        const prt__vec t9 = PRT__R(10.0119715893477442193) * t7 - PRT__R(3.0035914768043232658);
        const prt__vec t10 = z * t9;
        prt__vec_store(out + 39 * stride, t5 * t10);
        prt__vec_store(out + 45 * stride, t3 * t10);
        const prt__vec t11 = PRT__R(1.14470177335741903992) * t8 - PRT__R(1.25335796441144373015);
        prt__vec_store(out + 53 * stride, t5 * (t8 * t11 - PRT__R(0.48031476689438621492)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = z * z;
        const prt__vec t5 = PRT__R(4.37968383934737954461) * t4 - PRT__R(0.547460479918422443076);
        const prt__vec t6 = PRT__R(1.14470177335741903992) * t5 - PRT__R(1.25335796441144373015);
        const prt__vec t7 = t5 * t6 - PRT__R(0.48031476689438621492);
        prt__vec_store(out + 59 * stride, t3 * t7);
        const prt__vec t8 = t1 + t2;
        const prt__vec t9 = PRT__R(10.0119715893477442193) * t4 - PRT__R(3.0035914768043232658);
        const prt__vec t10 = PRT__R(2.13960769627671528242) * (z * t7) - PRT__R(1.00550825192169375133) * (z * t9);
        prt__vec_store(out + 69 * stride, (y * (t1 + (t8 + t8))) * t10);
        prt__vec_store(out + 75 * stride, t3 * t10);
        const prt__vec t11 = y * x;
        const prt__vec t12 = t11 + t11;
        const prt__vec t13 = t1 * t12;
        const prt__vec t14 = t13 + t13;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t14);
        const prt__vec t15 = (t1 + t12) * (t1 - t12);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t15);
        const prt__vec t16 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t14 * t16);
        prt__vec_store(out + 34 * stride, t15 * t16);
        const prt__vec t17 = PRT__R(5.53226317538874894011) * t4 - PRT__R(0.553226317538874894011);
        prt__vec_store(out + 38 * stride, t14 * t17);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(5.53226317538874894011) * t5 - PRT__R(0.553226317538874894011);
        prt__vec_store(out + 46 * stride, t4 * t6);
        const prt__vec t7 = t1 * t3;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = PRT__R(13.3876196648007832099) * t5 - PRT__R(3.34690491620019580249);
        const prt__vec t10 = z * t9;
        prt__vec_store(out + 52 * stride, t8 * t10);
        prt__vec_store(out + 60 * stride, t4 * t10);
        const prt__vec t11 = PRT__R(1.00325462178684816145) * t6 - PRT__R(1.26863282277713073229);
        const prt__vec t12 = t6 * t11 - PRT__R(0.460583198810398206878);
        prt__vec_store(out + 68 * stride, t8 * t12);
        prt__vec_store(out + 76 * stride, t4 * t12);
        const prt__vec t13 = y * t4 + x * t8;
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * t13);
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * (x * t4 - y * t8));
        prt__vec_store(out + 37 * stride, t13 * (PRT__R(2.36661916223175203199) * z));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = x * t4 - y * t6;
        prt__vec_store(out + 47 * stride, t7 * (PRT__R(2.36661916223175203199) * z));
        const prt__vec t8 = y * t4 + x * t6;
        const prt__vec t9 = z * z;
        const prt__vec t10 = PRT__R(6.73131046101657472554) * t9 - PRT__R(0.560942538418047893795);
        prt__vec_store(out + 51 * stride, t8 * t10);
        prt__vec_store(out + 61 * stride, t7 * t10);
        const prt__vec t11 = PRT__R(17.1567982383278290323) * t9 - PRT__R(3.67645676535596336405);
        const prt__vec t12 = z * t11;
        prt__vec_store(out + 67 * stride, t8 * t12);
        prt__vec_store(out + 77 * stride, t7 * t12);
        const prt__vec t13 = y * y;
        const prt__vec t14 = x * (t1 - (t13 + t13));
        const prt__vec t15 = t1 + t13;
        const prt__vec t16 = y * (t1 + (t15 + t15));
        const prt__vec t17 = t14 * t16;
        const prt__vec t18 = t17 + t17;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * t18);
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * ((t14 + t16) * (t14 - t16)));
        prt__vec_store(out + 50 * stride, t18 * (PRT__R(2.64596066180190022197) * z));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = (t3 + t5) * (t3 - t5);
        prt__vec_store(out + 62 * stride, t6 * (PRT__R(2.64596066180190022197) * z));
        const prt__vec t7 = t3 * t5;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = PRT__R(7.97265272468488541901) * (z * z) - PRT__R(0.569475194620348958501);
        prt__vec_store(out + 66 * stride, t8 * t9);
        prt__vec_store(out + 78 * stride, t6 * t9);
        const prt__vec t10 = y * t6 + x * t8;
        prt__vec_store(out + 49 * stride, PRT__R(0.707162732524596178226) * t10);
        const prt__vec t11 = x * t6 - y * t8;
        prt__vec_store(out + 63 * stride, PRT__R(0.707162732524596178226) * t11);
        const prt__vec t12 = PRT__R(2.91570664069931947548) * z;
        prt__vec_store(out + 65 * stride, t10 * t12);
        prt__vec_store(out + 79 * stride, t11 * t12);
        const prt__vec t13 = y * x;
        const prt__vec t14 = t13 + t13;
        const prt__vec t15 = t1 * t14;
        const prt__vec t16 = ((t1 + t14) * (t1 - t14)) * (t15 + t15);
        prt__vec_store(out + 64 * stride, PRT__R(0.72892666017482986887) * (t16 + t16));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        prt__vec_store(out + 80 * stride, PRT__R(0.72892666017482986887) * ((t4 + t6) * (t4 - t6)));
    }
}

/* CH basis, 10 bands: 202 multiplications, 64 additions (47 can fuse), 100 stores */
PRT__STATIC void prt__ch_eval_10(prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    out[0] = PRT__R(0.282094791773878143474);
    out[2] = PRT__R(0.488602511902919921586) * z;
    const prt_real t1 = z * z;
    const prt_real t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
    out[6] = t2;
    const prt_real t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
    const prt_real t4 = z * t3;
    out[12] = t4;
    const prt_real t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
    out[20] = t5;
    const prt_real t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
    out[30] = t6;
    const prt_real t7 = PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5;
    out[42] = t7;
    const prt_real t8 = PRT__R(1.9981247065730924832) * (z * t7) - PRT__R(0.99749765012849593691) * t6;
    out[56] = t8;
    const prt_real t9 = PRT__R(1.99878824587482633945) * (z * t8) - PRT__R(0.998457044322595902884) * t7;
    out[72] = t9;
    out[90] = PRT__R(1.9991716711179192974) * (z * t9) - PRT__R(0.998980209429107783872) * t8;
    out[1] = PRT__R(0.488602511902919921586) * y;
    out[3] = PRT__R(0.488602511902919921586) * x;
    const prt_real t10 = PRT__R(1.09254843059207907054) * z;
    out[5] = y * t10;
    out[7] = x * t10;
    const prt_real t11 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
    out[11] = y * t11;
    out[13] = x * t11;
    const prt_real t12 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
    const prt_real t13 = z * t12;
    out[19] = y * t13;
    out[21] = x * t13;
    const prt_real t14 = PRT__R(1.81395700920230242682) * t11 - PRT__R(1.00910143904649857838);
    const prt_real t15 = t11 * t14 - PRT__R(0.561361547776433262911);
    out[29] = y * t15;
    out[31] = x * t15;
    const prt_real t16 = PRT__R(2.00308404192443849618) * (z * t15) - PRT__R(1.00439949330516663946) * t13;
    out[41] = y * t16;
    out[43] = x * t16;
    const prt_real t17 = PRT__R(2.00185442784391621093) * (z * t16) - PRT__R(1.00247066466748147447) * t15;
    out[55] = y * t17;
    out[57] = x * t17;
    const prt_real t18 = PRT__R(2.00120156213902958958) * (z * t17) - PRT__R(1.00152855204404460325) * t16;
    out[71] = y * t18;
    out[73] = x * t18;
    const prt_real t19 = PRT__R(2.000822875986267518) * (z * t18) - PRT__R(1.00101246624680610771) * t17;
    out[89] = y * t19;
    out[91] = x * t19;
    const prt_real t20 = y * x;
    const prt_real t21 = t20 + t20;
    out[4] = PRT__R(0.546274215296039535272) * t21;
    const prt_real t22 = (y + x) * (x - y);
    out[8] = PRT__R(0.546274215296039535272) * t22;
    const prt_real t23 = PRT__R(1.44530572132027702769) * z;
    out[10] = t21 * t23;
    out[14] = t22 * t23;
    const prt_real t24 = PRT__R(3.27764529177623721163) * t1 - PRT__R(0.546274215296039535272);
    out[18] = t21 * t24;
    out[22] = t22 * t24;
    const prt_real t25 = PRT__R(7.04063249082559160399) * t1 - PRT__R(2.6402371840595968515);
    const prt_real t26 = z * t25;
    out[28] = t21 * t26;
    out[32] = t22 * t26;
    const prt_real t27 = PRT__R(1.37233279507355082388) * t24 - PRT__R(1.19947203320611937035);
    const prt_real t28 = t24 * t27 - PRT__R(0.511906752897826512122);
    out[40] = t21 * t28;
    out[44] = t22 * t28;
    const prt_real t29 = PRT__R(2.06485074947180018626) * (z * t28) - PRT__R(1.00887444616012613957) * t26;
    out[54] = t21 * t29;
    out[58] = t22 * t29;
    const prt_real t30 = PRT__R(2.047379529757827986) * (z * t29) - PRT__R(1.0065555134461126069) * t28;
    out[70] = t21 * t30;
    out[74] = t22 * t30;
    const prt_real t31 = PRT__R(2.03608622627713160396) * (z * t30) - PRT__R(1.00494030387093691765) * t29;
    out[88] = t21 * t31;
    out[92] = t22 * t31;
    const prt_real t32 = y * y;
    const prt_real t33 = t22 + t32;
    const prt_real t34 = y * (t22 + (t33 + t33));
    out[9] = PRT__R(0.590043589926643510346) * t34;
    const prt_real t35 = x * (t22 - (t32 + t32));
    out[15] = PRT__R(0.590043589926643510346) * t35;
    const prt_real t36 = PRT__R(1.77013076977993053104) * z;
    out[17] = t34 * t36;
    out[23] = t35 * t36;
    const prt_real t37 = PRT__R(4.37968383934737954461) * t1 - PRT__R(0.547460479918422443076);
    out[27] = t34 * t37;
    out[33] = t35 * t37;
    const prt_real t38 = PRT__R(10.0119715893477442193) * t1 - PRT__R(3.0035914768043232658);
    const prt_real t39 = z * t38;
    out[39] = t34 * t39;
    out[45] = t35 * t39;
    const prt_real t40 = PRT__R(1.14470177335741903992) * t37 - PRT__R(1.25335796441144373015);
    const prt_real t41 = t37 * t40 - PRT__R(0.48031476689438621492);
    out[53] = t34 * t41;
    out[59] = t35 * t41;
    const prt_real t42 = PRT__R(2.13960769627671528242) * (z * t41) - PRT__R(1.00550825192169375133) * t39;
    out[69] = t34 * t42;
    out[75] = t35 * t42;
    const prt_real t43 = PRT__R(2.10577559828109434639) * (z * t42) - PRT__R(1.00569948140936029559) * t41;
    out[87] = t34 * t43;
    out[93] = t35 * t43;
    const prt_real t44 = t22 * t21;
    const prt_real t45 = t44 + t44;
    out[16] = PRT__R(0.625835735449176134587) * t45;
    const prt_real t46 = (t22 + t21) * (t22 - t21);
    out[24] = PRT__R(0.625835735449176134587) * t46;
    const prt_real t47 = PRT__R(2.075662314881041279) * z;
    out[26] = t45 * t47;
    out[34] = t46 * t47;
    const prt_real t48 = PRT__R(5.53226317538874894011) * t1 - PRT__R(0.553226317538874894011);
    out[38] = t45 * t48;
    out[46] = t46 * t48;
    const prt_real t49 = PRT__R(13.3876196648007832099) * t1 - PRT__R(3.34690491620019580249);
    const prt_real t50 = z * t49;
    out[52] = t45 * t50;
    out[60] = t46 * t50;
    const prt_real t51 = PRT__R(1.00325462178684816145) * t48 - PRT__R(1.26863282277713073229);
    const prt_real t52 = t48 * t51 - PRT__R(0.460583198810398206878);
    out[68] = t45 * t52;
    out[76] = t46 * t52;
    const prt_real t53 = PRT__R(2.21822946338610302856) * (z * t52) - PRT__R(0.999366056347041316611) * t50;
    out[86] = t45 * t53;
    out[94] = t46 * t53;
    const prt_real t54 = y * t46 + x * t45;
    out[25] = PRT__R(0.656382056840170102814) * t54;
    const prt_real t55 = x * t46 - y * t45;
    out[35] = PRT__R(0.656382056840170102814) * t55;
    const prt_real t56 = PRT__R(2.36661916223175203199) * z;
    out[37] = t54 * t56;
    out[47] = t55 * t56;
    const prt_real t57 = PRT__R(6.73131046101657472554) * t1 - PRT__R(0.560942538418047893795);
    out[51] = t54 * t57;
    out[61] = t55 * t57;
    const prt_real t58 = PRT__R(17.1567982383278290323) * t1 - PRT__R(3.67645676535596336405);
    const prt_real t59 = z * t58;
    out[67] = t54 * t59;
    out[77] = t55 * t59;
    const prt_real t60 = PRT__R(0.906010318363799802197) * t57 - PRT__R(1.27054931953983393429);
    const prt_real t61 = t57 * t60 - PRT__R(0.447986100878170112466);
    out[85] = t54 * t61;
    out[95] = t55 * t61;
    const prt_real t62 = t35 * t34;
    const prt_real t63 = t62 + t62;
    out[36] = PRT__R(0.683184105191914321975) * t63;
    const prt_real t64 = (t35 + t34) * (t35 - t34);
    out[48] = PRT__R(0.683184105191914321975) * t64;
    const prt_real t65 = PRT__R(2.64596066180190022197) * z;
    out[50] = t63 * t65;
    out[62] = t64 * t65;
    const prt_real t66 = PRT__R(7.97265272468488541901) * t1 - PRT__R(0.569475194620348958501);
    out[66] = t63 * t66;
    out[78] = t64 * t66;
    const prt_real t67 = PRT__R(21.3083359134333530585) * t1 - PRT__R(3.99531298376875369847);
    const prt_real t68 = z * t67;
    out[84] = t63 * t68;
    out[96] = t64 * t68;
    const prt_real t69 = y * t64 + x * t63;
    out[49] = PRT__R(0.707162732524596178226) * t69;
    const prt_real t70 = x * t64 - y * t63;
    out[63] = PRT__R(0.707162732524596178226) * t70;
    const prt_real t71 = PRT__R(2.91570664069931947548) * z;
    out[65] = t69 * t71;
    out[79] = t70 * t71;
    const prt_real t72 = PRT__R(9.25266937297977981733) * t1 - PRT__R(0.578291835811236238583);
    out[83] = t69 * t72;
    out[97] = t70 * t72;
    const prt_real t73 = t46 * t45;
    const prt_real t74 = t73 + t73;
    out[64] = PRT__R(0.72892666017482986887) * t74;
    const prt_real t75 = (t46 + t45) * (t46 - t45);
    out[80] = PRT__R(0.72892666017482986887) * t75;
    const prt_real t76 = PRT__R(3.1773176489546974773) * z;
    out[82] = t74 * t76;
    out[98] = t75 * t76;
    out[81] = PRT__R(0.74890095185318829655) * (y * t75 + x * t74);
    out[99] = PRT__R(0.74890095185318829655) * (x * t75 - y * t74);
}

/* CH basis, 10 bands: 202 multiplications, 64 additions (47 can fuse), 100 stores */
PRT__STATIC void prt__ch_eval_10_v(int vectors, const prt_real *xs, const prt_real *ys, const prt_real *zs,
    prt_real *PRT__RESTRICT rows, size_t stride) {
    int k;
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        prt__vec_store(out, prt__vec_set(PRT__R(0.282094791773878143474)));
        prt__vec_store(out + 2 * stride, PRT__R(0.488602511902919921586) * z);
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        prt__vec_store(out + 6 * stride, t2);
        const prt__vec t3 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        const prt__vec t4 = z * t3;
        prt__vec_store(out + 12 * stride, t4);
        const prt__vec t5 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
        prt__vec_store(out + 20 * stride, t5);
        const prt__vec t6 = PRT__R(1.9941605714785482504) * (z * t5) - PRT__R(0.990626623845594065416) * t4;
        prt__vec_store(out + 30 * stride, t6);
        const prt__vec t7 = PRT__R(1.99686765665245415552) * (z * t6) - PRT__R(0.995518686839271862673) * t5;
        prt__vec_store(out + 42 * stride, t7);
        prt__vec_store(out + 56 * stride, PRT__R(1.9981247065730924832) * (z * t7) - PRT__R(0.99749765012849593691) * t6);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(0.825888983611586872968) * t1 - PRT__R(0.412944491805793436484);
        const prt__vec t3 = t2 * (PRT__R(4.71662269588694702818) * t2) - PRT__R(0.402146687544551258061);
        const prt__vec t4 = PRT__R(1.61906625351721666923) * t1 - PRT__R(1.21429969013791250192);
        const prt__vec t5 = PRT__R(1.9941605714785482504) * (z * t3) - PRT__R(0.990626623845594065416) * (z * t4);
        const prt__vec t6 = PRT__R(1.99686765665245415552) * (z * t5) - PRT__R(0.995518686839271862673) * t3;
        const prt__vec t7 = PRT__R(1.9981247065730924832) * (z * t6) - PRT__R(0.99749765012849593691) * t5;
        const prt__vec t8 = PRT__R(1.99878824587482633945) * (z * t7) - PRT__R(0.998457044322595902884) * t6;
        prt__vec_store(out + 72 * stride, t8);
        prt__vec_store(out + 90 * stride, PRT__R(1.9991716711179192974) * (z * t8) - PRT__R(0.998980209429107783872) * t7);
        prt__vec_store(out + stride, PRT__R(0.488602511902919921586) * y);
        prt__vec_store(out + 3 * stride, PRT__R(0.488602511902919921586) * x);
        const prt__vec t9 = PRT__R(1.09254843059207907054) * z;
        prt__vec_store(out + 5 * stride, y * t9);
        prt__vec_store(out + 7 * stride, x * t9);
        const prt__vec t10 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        prt__vec_store(out + 11 * stride, y * t10);
        prt__vec_store(out + 13 * stride, x * t10);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
        const prt__vec t3 = z * t2;
        prt__vec_store(out + 19 * stride, y * t3);
        prt__vec_store(out + 21 * stride, x * t3);
        const prt__vec t4 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        const prt__vec t5 = PRT__R(1.81395700920230242682) * t4 - PRT__R(1.00910143904649857838);
        const prt__vec t6 = t4 * t5 - PRT__R(0.561361547776433262911);
        prt__vec_store(out + 29 * stride, y * t6);
        prt__vec_store(out + 31 * stride, x * t6);
        const prt__vec t7 = PRT__R(2.00308404192443849618) * (z * t6) - PRT__R(1.00439949330516663946) * t3;
        prt__vec_store(out + 41 * stride, y * t7);
        prt__vec_store(out + 43 * stride, x * t7);
        const prt__vec t8 = PRT__R(2.00185442784391621093) * (z * t7) - PRT__R(1.00247066466748147447) * t6;
        prt__vec_store(out + 55 * stride, y * t8);
        prt__vec_store(out + 57 * stride, x * t8);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = z * z;
        const prt__vec t2 = PRT__R(2.2251937260415151452) * t1 - PRT__R(0.556298431510378786299);
        const prt__vec t3 = PRT__R(1.81395700920230242682) * t2 - PRT__R(1.00910143904649857838);
        const prt__vec t4 = t2 * t3 - PRT__R(0.561361547776433262911);
        const prt__vec t5 = PRT__R(4.47811599108138469697) * t1 - PRT__R(2.23905799554069234849);
        const prt__vec t6 = PRT__R(2.00308404192443849618) * (z * t4) - PRT__R(1.00439949330516663946) * (z * t5);
        const prt__vec t7 = PRT__R(2.00185442784391621093) * (z * t6) - PRT__R(1.00247066466748147447) * t4;
        const prt__vec t8 = PRT__R(2.00120156213902958958) * (z * t7) - PRT__R(1.00152855204404460325) * t6;
        prt__vec_store(out + 71 * stride, y * t8);
        prt__vec_store(out + 73 * stride, x * t8);
        const prt__vec t9 = PRT__R(2.000822875986267518) * (z * t8) - PRT__R(1.00101246624680610771) * t7;
        prt__vec_store(out + 89 * stride, y * t9);
        prt__vec_store(out + 91 * stride, x * t9);
        const prt__vec t10 = y * x;
        const prt__vec t11 = t10 + t10;
        prt__vec_store(out + 4 * stride, PRT__R(0.546274215296039535272) * t11);
        const prt__vec t12 = (y + x) * (x - y);
        prt__vec_store(out + 8 * stride, PRT__R(0.546274215296039535272) * t12);
        const prt__vec t13 = PRT__R(1.44530572132027702769) * z;
        prt__vec_store(out + 10 * stride, t11 * t13);
        prt__vec_store(out + 14 * stride, t12 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = z * z;
        const prt__vec t4 = PRT__R(3.27764529177623721163) * t3 - PRT__R(0.546274215296039535272);
        prt__vec_store(out + 18 * stride, t2 * t4);
        const prt__vec t5 = (y + x) * (x - y);
        prt__vec_store(out + 22 * stride, t5 * t4);
        const prt__vec t6 = PRT__R(7.04063249082559160399) * t3 - PRT__R(2.6402371840595968515);
        const prt__vec t7 = z * t6;
        prt__vec_store(out + 28 * stride, t2 * t7);
        prt__vec_store(out + 32 * stride, t5 * t7);
        const prt__vec t8 = PRT__R(1.37233279507355082388) * t4 - PRT__R(1.19947203320611937035);
        const prt__vec t9 = t4 * t8 - PRT__R(0.511906752897826512122);
        prt__vec_store(out + 40 * stride, t2 * t9);
        prt__vec_store(out + 44 * stride, t5 * t9);
        const prt__vec t10 = PRT__R(2.06485074947180018626) * (z * t9) - PRT__R(1.00887444616012613957) * t7;
        prt__vec_store(out + 54 * stride, t2 * t10);
        prt__vec_store(out + 58 * stride, t5 * t10);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = y * x;
        const prt__vec t2 = t1 + t1;
        const prt__vec t3 = z * z;
        const prt__vec t4 = PRT__R(3.27764529177623721163) * t3 - PRT__R(0.546274215296039535272);
        const prt__vec t5 = PRT__R(1.37233279507355082388) * t4 - PRT__R(1.19947203320611937035);
        const prt__vec t6 = t4 * t5 - PRT__R(0.511906752897826512122);
        const prt__vec t7 = PRT__R(7.04063249082559160399) * t3 - PRT__R(2.6402371840595968515);
        const prt__vec t8 = PRT__R(2.06485074947180018626) * (z * t6) - PRT__R(1.00887444616012613957) * (z * t7);
        const prt__vec t9 = PRT__R(2.047379529757827986) * (z * t8) - PRT__R(1.0065555134461126069) * t6;
        prt__vec_store(out + 70 * stride, t2 * t9);
        const prt__vec t10 = (y + x) * (x - y);
        prt__vec_store(out + 74 * stride, t10 * t9);
        const prt__vec t11 = PRT__R(2.03608622627713160396) * (z * t9) - PRT__R(1.00494030387093691765) * t8;
        prt__vec_store(out + 88 * stride, t2 * t11);
        prt__vec_store(out + 92 * stride, t10 * t11);
        const prt__vec t12 = y * y;
        const prt__vec t13 = t10 + t12;
        const prt__vec t14 = y * (t10 + (t13 + t13));
        prt__vec_store(out + 9 * stride, PRT__R(0.590043589926643510346) * t14);
        const prt__vec t15 = x * (t10 - (t12 + t12));
        prt__vec_store(out + 15 * stride, PRT__R(0.590043589926643510346) * t15);
        const prt__vec t16 = PRT__R(1.77013076977993053104) * z;
        prt__vec_store(out + 17 * stride, t14 * t16);
        prt__vec_store(out + 23 * stride, t15 * t16);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = y * (t1 + (t3 + t3));
        const prt__vec t5 = z * z;
        const prt__vec t6 = PRT__R(4.37968383934737954461) * t5 - PRT__R(0.547460479918422443076);
        prt__vec_store(out + 27 * stride, t4 * t6);
        const prt__vec t7 = x * (t1 - (t2 + t2));
        prt__vec_store(out + 33 * stride, t7 * t6);
        const prt__vec t8 = PRT__R(10.0119715893477442193) * t5 - PRT__R(3.0035914768043232658);
        const prt__vec t9 = z * t8;
        prt__vec_store(out + 39 * stride, t4 * t9);
        prt__vec_store(out + 45 * stride, t7 * t9);
        const prt__vec t10 = PRT__R(1.14470177335741903992) * t6 - PRT__R(1.25335796441144373015);
        const prt__vec t11 = t6 * t10 - PRT__R(0.48031476689438621492);
        prt__vec_store(out + 53 * stride, t4 * t11);
        prt__vec_store(out + 59 * stride, t7 * t11);
        const prt__vec t12 = PRT__R(2.13960769627671528242) * (z * t11) - PRT__R(1.00550825192169375133) * t9;
        prt__vec_store(out + 69 * stride, t4 * t12);
        prt__vec_store(out + 75 * stride, t7 * t12);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = t1 + t2;
        const prt__vec t4 = z * z;
        const prt__vec t5 = PRT__R(4.37968383934737954461) * t4 - PRT__R(0.547460479918422443076);
        const prt__vec t6 = PRT__R(1.14470177335741903992) * t5 - PRT__R(1.25335796441144373015);
        const prt__vec t7 = t5 * t6 - PRT__R(0.48031476689438621492);
        const prt__vec t8 = PRT__R(10.0119715893477442193) * t4 - PRT__R(3.0035914768043232658);
        const prt__vec t9 = PRT__R(2.13960769627671528242) * (z * t7) - PRT__R(1.00550825192169375133) * (z * t8);
        const prt__vec t10 = PRT__R(2.10577559828109434639) * (z * t9) - PRT__R(1.00569948140936029559) * t7;
        prt__vec_store(out + 87 * stride, (y * (t1 + (t3 + t3))) * t10);
        prt__vec_store(out + 93 * stride, (x * (t1 - (t2 + t2))) * t10);
        const prt__vec t11 = y * x;
        const prt__vec t12 = t11 + t11;
        const prt__vec t13 = t1 * t12;
        const prt__vec t14 = t13 + t13;
        prt__vec_store(out + 16 * stride, PRT__R(0.625835735449176134587) * t14);
        const prt__vec t15 = (t1 + t12) * (t1 - t12);
        prt__vec_store(out + 24 * stride, PRT__R(0.625835735449176134587) * t15);
        const prt__vec t16 = PRT__R(2.075662314881041279) * z;
        prt__vec_store(out + 26 * stride, t14 * t16);
        prt__vec_store(out + 34 * stride, t15 * t16);
        const prt__vec t17 = PRT__R(5.53226317538874894011) * t4 - PRT__R(0.553226317538874894011);
        prt__vec_store(out + 38 * stride, t14 * t17);
        prt__vec_store(out + 46 * stride, t15 * t17);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = t1 * t3;
        const prt__vec t5 = t4 + t4;
        const prt__vec t6 = z * z;
        const prt__vec t7 = PRT__R(13.3876196648007832099) * t6 - PRT__R(3.34690491620019580249);
        const prt__vec t8 = z * t7;
        prt__vec_store(out + 52 * stride, t5 * t8);
        const prt__vec t9 = (t1 + t3) * (t1 - t3);
        prt__vec_store(out + 60 * stride, t9 * t8);
        const prt__vec t10 = PRT__R(5.53226317538874894011) * t6 - PRT__R(0.553226317538874894011);
        const prt__vec t11 = PRT__R(1.00325462178684816145) * t10 - PRT__R(1.26863282277713073229);
        const prt__vec t12 = t10 * t11 - PRT__R(0.460583198810398206878);
        prt__vec_store(out + 68 * stride, t5 * t12);
        prt__vec_store(out + 76 * stride, t9 * t12);
        const prt__vec t13 = PRT__R(2.21822946338610302856) * (z * t12) - PRT__R(0.999366056347041316611) * t8;
        prt__vec_store(out + 86 * stride, t5 * t13);
        prt__vec_store(out + 94 * stride, t9 * t13);
        prt__vec_store(out + 25 * stride, PRT__R(0.656382056840170102814) * (y * t9 + x * t5));
        prt__vec_store(out + 35 * stride, PRT__R(0.656382056840170102814) * (x * t9 - y * t5));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = y * t4 + x * t6;
        const prt__vec t8 = PRT__R(2.36661916223175203199) * z;
        prt__vec_store(out + 37 * stride, t7 * t8);
        const prt__vec t9 = x * t4 - y * t6;
        prt__vec_store(out + 47 * stride, t9 * t8);
        const prt__vec t10 = z * z;
        const prt__vec t11 = PRT__R(6.73131046101657472554) * t10 - PRT__R(0.560942538418047893795);
        prt__vec_store(out + 51 * stride, t7 * t11);
        prt__vec_store(out + 61 * stride, t9 * t11);
        const prt__vec t12 = PRT__R(17.1567982383278290323) * t10 - PRT__R(3.67645676535596336405);
        const prt__vec t13 = z * t12;
        prt__vec_store(out + 67 * stride, t7 * t13);
        prt__vec_store(out + 77 * stride, t9 * t13);
        const prt__vec t14 = PRT__R(0.906010318363799802197) * t11 - PRT__R(1.27054931953983393429);
        const prt__vec t15 = t11 * t14 - PRT__R(0.447986100878170112466);
        prt__vec_store(out + 85 * stride, t7 * t15);
        prt__vec_store(out + 95 * stride, t9 * t15);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = t3 * t5;
        const prt__vec t7 = t6 + t6;
        prt__vec_store(out + 36 * stride, PRT__R(0.683184105191914321975) * t7);
        const prt__vec t8 = (t3 + t5) * (t3 - t5);
        prt__vec_store(out + 48 * stride, PRT__R(0.683184105191914321975) * t8);
        const prt__vec t9 = PRT__R(2.64596066180190022197) * z;
        prt__vec_store(out + 50 * stride, t7 * t9);
        prt__vec_store(out + 62 * stride, t8 * t9);
        const prt__vec t10 = z * z;
        const prt__vec t11 = PRT__R(7.97265272468488541901) * t10 - PRT__R(0.569475194620348958501);
        prt__vec_store(out + 66 * stride, t7 * t11);
        prt__vec_store(out + 78 * stride, t8 * t11);
        const prt__vec t12 = PRT__R(21.3083359134333530585) * t10 - PRT__R(3.99531298376875369847);
        const prt__vec t13 = z * t12;
        prt__vec_store(out + 84 * stride, t7 * t13);
        prt__vec_store(out + 96 * stride, t8 * t13);
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * y;
        const prt__vec t3 = x * (t1 - (t2 + t2));
        const prt__vec t4 = t1 + t2;
        const prt__vec t5 = y * (t1 + (t4 + t4));
        const prt__vec t6 = (t3 + t5) * (t3 - t5);
        const prt__vec t7 = t3 * t5;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = y * t6 + x * t8;
        prt__vec_store(out + 49 * stride, PRT__R(0.707162732524596178226) * t9);
        const prt__vec t10 = x * t6 - y * t8;
        prt__vec_store(out + 63 * stride, PRT__R(0.707162732524596178226) * t10);
        const prt__vec t11 = PRT__R(2.91570664069931947548) * z;
        prt__vec_store(out + 65 * stride, t9 * t11);
        prt__vec_store(out + 79 * stride, t10 * t11);
        const prt__vec t12 = PRT__R(9.25266937297977981733) * (z * z) - PRT__R(0.578291835811236238583);
        prt__vec_store(out + 83 * stride, t9 * t12);
        prt__vec_store(out + 97 * stride, t10 * t12);
        const prt__vec t13 = y * x;
        const prt__vec t14 = t13 + t13;
        const prt__vec t15 = (t1 + t14) * (t1 - t14);
        const prt__vec t16 = t1 * t14;
        const prt__vec t17 = t16 + t16;
        const prt__vec t18 = t15 * t17;
        prt__vec_store(out + 64 * stride, PRT__R(0.72892666017482986887) * (t18 + t18));
        prt__vec_store(out + 80 * stride, PRT__R(0.72892666017482986887) * ((t15 + t17) * (t15 - t17)));
    }
    for (k = 0; k < vectors * PRT__LANES; k += PRT__LANES) {
        const prt__vec x = prt__vec_load(xs + k);
        const prt__vec y = prt__vec_load(ys + k);
        const prt__vec z = prt__vec_load(zs + k);
        prt_real *PRT__RESTRICT out = rows + k;
        const prt__vec t1 = (y + x) * (x - y);
        const prt__vec t2 = y * x;
        const prt__vec t3 = t2 + t2;
        const prt__vec t4 = (t1 + t3) * (t1 - t3);
        const prt__vec t5 = t1 * t3;
        const prt__vec t6 = t5 + t5;
        const prt__vec t7 = t4 * t6;
        const prt__vec t8 = t7 + t7;
        const prt__vec t9 = PRT__R(3.1773176489546974773) * z;
        prt__vec_store(out + 82 * stride, t8 * t9);
        const prt__vec t10 = (t4 + t6) * (t4 - t6);
        prt__vec_store(out + 98 * stride, t10 * t9);
        prt__vec_store(out + 81 * stride, PRT__R(0.74890095185318829655) * (y * t10 + x * t8));
        prt__vec_store(out + 99 * stride, PRT__R(0.74890095185318829655) * (x * t10 - y * t8));
    }
}

/* CH value, 1 band: 1 multiplications, 0 additions (0 can fuse), 1 loads, 1 stores */
PRT__STATIC void prt__ch_at_1(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    (void)x;
    (void)y;
    (void)z;
    out[0] = PRT__R(0.282094791773878143474) * f[0];
}

/* CH value, 2 bands: 7 multiplications, 3 additions (2 can fuse), 4 loads, 1 stores */
PRT__STATIC void prt__ch_at_2(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = y * (PRT__R(0.488602511902919921586) * f[1]) + x * (PRT__R(0.488602511902919921586) * f[3]);
    out[0] = t1 + t2;
}

/* CH value, 3 bands: 19 multiplications, 12 additions (7 can fuse), 9 loads, 1 stores */
PRT__STATIC void prt__ch_at_3(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = PRT__R(0.825888983611586872968) * (z * z) - PRT__R(0.412944491805793436484);
    const prt_real t3 = PRT__R(1.09254843059207907054) * z;
    const prt_real t4 = y * (PRT__R(0.488602511902919921586) * f[1] + t3 * f[5]) + x * (PRT__R(0.488602511902919921586) * f[3] + t3 * f[7]);
    const prt_real t5 = y * x;
    const prt_real t6 = ((y + x) * (x - y)) * (PRT__R(0.546274215296039535272) * f[8]);
    out[0] = ((t1 + t2 * f[6]) + t4) + ((t5 + t5) * (PRT__R(0.546274215296039535272) * f[4]) + t6);
}

/* CH value, 4 bands: 35 multiplications, 26 additions (15 can fuse), 16 loads, 1 stores */
PRT__STATIC void prt__ch_at_4(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.825888983611586872968) * t2 - PRT__R(0.412944491805793436484);
    const prt_real t4 = PRT__R(1.61906625351721666923) * t2 - PRT__R(1.21429969013791250192);
    const prt_real t5 = PRT__R(1.09254843059207907054) * z;
    const prt_real t6 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
    const prt_real t7 = (PRT__R(0.488602511902919921586) * f[1] + t5 * f[5]) + t6 * f[11];
    const prt_real t8 = (PRT__R(0.488602511902919921586) * f[3] + t5 * f[7]) + t6 * f[13];
    const prt_real t9 = y * x;
    const prt_real t10 = PRT__R(1.44530572132027702769) * z;
    const prt_real t11 = (t9 + t9) * (PRT__R(0.546274215296039535272) * f[4] + t10 * f[10]);
    const prt_real t12 = (y + x) * (x - y);
    const prt_real t13 = t11 + t12 * (PRT__R(0.546274215296039535272) * f[8] + t10 * f[14]);
    const prt_real t14 = (((t1 + t3 * f[6]) + (z * t4) * f[12]) + (y * t7 + x * t8)) + t13;
    const prt_real t15 = y * y;
    const prt_real t16 = t12 + t15;
    const prt_real t17 = (y * (t12 + (t16 + t16))) * (PRT__R(0.590043589926643510346) * f[9]);
    const prt_real t18 = (x * (t12 - (t15 + t15))) * (PRT__R(0.590043589926643510346) * f[15]);
    out[0] = t14 + (t17 + t18);
}

/* CH value, 5 bands: 54 multiplications, 41 additions (26 can fuse), 25 loads, 1 stores */
PRT__STATIC void prt__ch_at_5(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.825888983611586872968) * t2 - PRT__R(0.412944491805793436484);
    const prt_real t4 = PRT__R(1.61906625351721666923) * t2 - PRT__R(1.21429969013791250192);
    const prt_real t5 = t3 * (PRT__R(4.71662269588694702818) * t3) - PRT__R(0.402146687544551258061);
    const prt_real t6 = PRT__R(1.09254843059207907054) * z;
    const prt_real t7 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
    const prt_real t8 = (PRT__R(0.488602511902919921586) * f[1] + t6 * f[5]) + t7 * f[11];
    const prt_real t9 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
    const prt_real t10 = z * t9;
    const prt_real t11 = (PRT__R(0.488602511902919921586) * f[3] + t6 * f[7]) + t7 * f[13];
    const prt_real t12 = (((t1 + t3 * f[6]) + (z * t4) * f[12]) + t5 * f[20]) + (y * (t8 + t10 * f[19]) + x * (t11 + t10 * f[21]));
    const prt_real t13 = y * x;
    const prt_real t14 = t13 + t13;
    const prt_real t15 = PRT__R(1.44530572132027702769) * z;
    const prt_real t16 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
    const prt_real t17 = (PRT__R(0.546274215296039535272) * f[4] + t15 * f[10]) + t16 * f[18];
    const prt_real t18 = (y + x) * (x - y);
    const prt_real t19 = (PRT__R(0.546274215296039535272) * f[8] + t15 * f[14]) + t16 * f[22];
    const prt_real t20 = y * y;
    const prt_real t21 = t18 + t20;
    const prt_real t22 = PRT__R(1.77013076977993053104) * z;
    const prt_real t23 = (y * (t18 + (t21 + t21))) * (PRT__R(0.590043589926643510346) * f[9] + t22 * f[17]);
    const prt_real t24 = (x * (t18 - (t20 + t20))) * (PRT__R(0.590043589926643510346) * f[15] + t22 * f[23]);
    const prt_real t25 = t18 * t14;
    const prt_real t26 = ((t18 + t14) * (t18 - t14)) * (PRT__R(0.625835735449176134587) * f[24]);
    const prt_real t27 = (t25 + t25) * (PRT__R(0.625835735449176134587) * f[16]) + t26;
    out[0] = ((t12 + (t14 * t17 + t18 * t19)) + (t23 + t24)) + t27;
}

/* CH value, 6 bands: 80 multiplications, 59 additions (43 can fuse), 36 loads, 1 stores */
PRT__STATIC void prt__ch_at_6(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.825888983611586872968) * t2 - PRT__R(0.412944491805793436484);
    const prt_real t4 = PRT__R(1.61906625351721666923) * t2 - PRT__R(1.21429969013791250192);
    const prt_real t5 = z * t4;
    const prt_real t6 = t3 * (PRT__R(4.71662269588694702818) * t3) - PRT__R(0.402146687544551258061);
    const prt_real t7 = PRT__R(1.9941605714785482504) * (z * t6) - PRT__R(0.990626623845594065416) * t5;
    const prt_real t8 = (((t1 + t3 * f[6]) + t5 * f[12]) + t6 * f[20]) + t7 * f[30];
    const prt_real t9 = PRT__R(1.09254843059207907054) * z;
    const prt_real t10 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
    const prt_real t11 = (PRT__R(0.488602511902919921586) * f[1] + t9 * f[5]) + t10 * f[11];
    const prt_real t12 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
    const prt_real t13 = z * t12;
    const prt_real t14 = PRT__R(1.81395700920230242682) * t10 - PRT__R(1.00910143904649857838);
    const prt_real t15 = t10 * t14 - PRT__R(0.561361547776433262911);
    const prt_real t16 = (PRT__R(0.488602511902919921586) * f[3] + t9 * f[7]) + t10 * f[13];
    const prt_real t17 = y * ((t11 + t13 * f[19]) + t15 * f[29]) + x * ((t16 + t13 * f[21]) + t15 * f[31]);
    const prt_real t18 = y * x;
    const prt_real t19 = t18 + t18;
    const prt_real t20 = PRT__R(1.44530572132027702769) * z;
    const prt_real t21 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
    const prt_real t22 = (PRT__R(0.546274215296039535272) * f[4] + t20 * f[10]) + t21 * f[18];
    const prt_real t23 = PRT__R(7.04063249082559160399) * t2 - PRT__R(2.6402371840595968515);
    const prt_real t24 = z * t23;
    const prt_real t25 = (y + x) * (x - y);
    const prt_real t26 = (PRT__R(0.546274215296039535272) * f[8] + t20 * f[14]) + t21 * f[22];
    const prt_real t27 = (t8 + t17) + (t19 * (t22 + t24 * f[28]) + t25 * (t26 + t24 * f[32]));
    const prt_real t28 = y * y;
    const prt_real t29 = t25 + t28;
    const prt_real t30 = PRT__R(1.77013076977993053104) * z;
    const prt_real t31 = PRT__R(4.37968383934737954461) * t2 - PRT__R(0.547460479918422443076);
    const prt_real t32 = (PRT__R(0.590043589926643510346) * f[9] + t30 * f[17]) + t31 * f[27];
    const prt_real t33 = (PRT__R(0.590043589926643510346) * f[15] + t30 * f[23]) + t31 * f[33];
    const prt_real t34 = (y * (t25 + (t29 + t29))) * t32 + (x * (t25 - (t28 + t28))) * t33;
    const prt_real t35 = t25 * t19;
    const prt_real t36 = t35 + t35;
    const prt_real t37 = PRT__R(2.075662314881041279) * z;
    const prt_real t38 = t36 * (PRT__R(0.625835735449176134587) * f[16] + t37 * f[26]);
    const prt_real t39 = (t25 + t19) * (t25 - t19);
    const prt_real t40 = t39 * (PRT__R(0.625835735449176134587) * f[24] + t37 * f[34]);
    const prt_real t41 = (y * t39 + x * t36) * (PRT__R(0.656382056840170102814) * f[25]);
    const prt_real t42 = (x * t39 - y * t36) * (PRT__R(0.656382056840170102814) * f[35]);
    out[0] = ((t27 + t34) + (t38 + t40)) + (t41 + t42);
}

/* CH value, 7 bands: 109 multiplications, 81 additions (61 can fuse), 49 loads, 1 stores */
PRT__STATIC void prt__ch_at_7(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.825888983611586872968) * t2 - PRT__R(0.412944491805793436484);
    const prt_real t4 = PRT__R(1.61906625351721666923) * t2 - PRT__R(1.21429969013791250192);
    const prt_real t5 = z * t4;
    const prt_real t6 = t3 * (PRT__R(4.71662269588694702818) * t3) - PRT__R(0.402146687544551258061);
    const prt_real t7 = PRT__R(1.9941605714785482504) * (z * t6) - PRT__R(0.990626623845594065416) * t5;
    const prt_real t8 = (((t1 + t3 * f[6]) + t5 * f[12]) + t6 * f[20]) + t7 * f[30];
    const prt_real t9 = PRT__R(1.99686765665245415552) * (z * t7) - PRT__R(0.995518686839271862673) * t6;
    const prt_real t10 = PRT__R(1.09254843059207907054) * z;
    const prt_real t11 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
    const prt_real t12 = (PRT__R(0.488602511902919921586) * f[1] + t10 * f[5]) + t11 * f[11];
    const prt_real t13 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
    const prt_real t14 = z * t13;
    const prt_real t15 = PRT__R(1.81395700920230242682) * t11 - PRT__R(1.00910143904649857838);
    const prt_real t16 = t11 * t15 - PRT__R(0.561361547776433262911);
    const prt_real t17 = PRT__R(2.00308404192443849618) * (z * t16) - PRT__R(1.00439949330516663946) * t14;
    const prt_real t18 = (PRT__R(0.488602511902919921586) * f[3] + t10 * f[7]) + t11 * f[13];
    const prt_real t19 = y * (((t12 + t14 * f[19]) + t16 * f[29]) + t17 * f[41]) + x * (((t18 + t14 * f[21]) + t16 * f[31]) + t17 * f[43]);
    const prt_real t20 = y * x;
    const prt_real t21 = t20 + t20;
    const prt_real t22 = PRT__R(1.44530572132027702769) * z;
    const prt_real t23 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
    const prt_real t24 = (PRT__R(0.546274215296039535272) * f[4] + t22 * f[10]) + t23 * f[18];
    const prt_real t25 = PRT__R(7.04063249082559160399) * t2 - PRT__R(2.6402371840595968515);
    const prt_real t26 = z * t25;
    const prt_real t27 = PRT__R(1.37233279507355082388) * t23 - PRT__R(1.19947203320611937035);
    const prt_real t28 = t23 * t27 - PRT__R(0.511906752897826512122);
    const prt_real t29 = (y + x) * (x - y);
    const prt_real t30 = (PRT__R(0.546274215296039535272) * f[8] + t22 * f[14]) + t23 * f[22];
    const prt_real t31 = t21 * ((t24 + t26 * f[28]) + t28 * f[40]) + t29 * ((t30 + t26 * f[32]) + t28 * f[44]);
    const prt_real t32 = y * y;
    const prt_real t33 = t29 + t32;
    const prt_real t34 = y * (t29 + (t33 + t33));
    const prt_real t35 = PRT__R(1.77013076977993053104) * z;
    const prt_real t36 = PRT__R(4.37968383934737954461) * t2 - PRT__R(0.547460479918422443076);
    const prt_real t37 = (PRT__R(0.590043589926643510346) * f[9] + t35 * f[17]) + t36 * f[27];
    const prt_real t38 = PRT__R(10.0119715893477442193) * t2 - PRT__R(3.0035914768043232658);
    const prt_real t39 = z * t38;
    const prt_real t40 = x * (t29 - (t32 + t32));
    const prt_real t41 = (PRT__R(0.590043589926643510346) * f[15] + t35 * f[23]) + t36 * f[33];
    const prt_real t42 = (((t8 + t9 * f[42]) + t19) + t31) + (t34 * (t37 + t39 * f[39]) + t40 * (t41 + t39 * f[45]));
    const prt_real t43 = t29 * t21;
    const prt_real t44 = t43 + t43;
    const prt_real t45 = PRT__R(2.075662314881041279) * z;
    const prt_real t46 = PRT__R(5.53226317538874894011) * t2 - PRT__R(0.553226317538874894011);
    const prt_real t47 = (PRT__R(0.625835735449176134587) * f[16] + t45 * f[26]) + t46 * f[38];
    const prt_real t48 = (t29 + t21) * (t29 - t21);
    const prt_real t49 = (PRT__R(0.625835735449176134587) * f[24] + t45 * f[34]) + t46 * f[46];
    const prt_real t50 = PRT__R(2.36661916223175203199) * z;
    const prt_real t51 = (y * t48 + x * t44) * (PRT__R(0.656382056840170102814) * f[25] + t50 * f[37]);
    const prt_real t52 = (x * t48 - y * t44) * (PRT__R(0.656382056840170102814) * f[35] + t50 * f[47]);
    const prt_real t53 = t40 * t34;
    const prt_real t54 = ((t40 + t34) * (t40 - t34)) * (PRT__R(0.683184105191914321975) * f[48]);
    const prt_real t55 = (t53 + t53) * (PRT__R(0.683184105191914321975) * f[36]) + t54;
    out[0] = ((t42 + (t44 * t47 + t48 * t49)) + (t51 + t52)) + t55;
}

/* CH value, 8 bands: 145 multiplications, 105 additions (84 can fuse), 64 loads, 1 stores */
PRT__STATIC void prt__ch_at_8(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.825888983611586872968) * t2 - PRT__R(0.412944491805793436484);
    const prt_real t4 = PRT__R(1.61906625351721666923) * t2 - PRT__R(1.21429969013791250192);
    const prt_real t5 = z * t4;
    const prt_real t6 = t3 * (PRT__R(4.71662269588694702818) * t3) - PRT__R(0.402146687544551258061);
    const prt_real t7 = PRT__R(1.9941605714785482504) * (z * t6) - PRT__R(0.990626623845594065416) * t5;
    const prt_real t8 = (((t1 + t3 * f[6]) + t5 * f[12]) + t6 * f[20]) + t7 * f[30];
    const prt_real t9 = PRT__R(1.99686765665245415552) * (z * t7) - PRT__R(0.995518686839271862673) * t6;
    const prt_real t10 = PRT__R(1.9981247065730924832) * (z * t9) - PRT__R(0.99749765012849593691) * t7;
    const prt_real t11 = PRT__R(1.09254843059207907054) * z;
    const prt_real t12 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
    const prt_real t13 = (PRT__R(0.488602511902919921586) * f[1] + t11 * f[5]) + t12 * f[11];
    const prt_real t14 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
    const prt_real t15 = z * t14;
    const prt_real t16 = PRT__R(1.81395700920230242682) * t12 - PRT__R(1.00910143904649857838);
    const prt_real t17 = t12 * t16 - PRT__R(0.561361547776433262911);
    const prt_real t18 = PRT__R(2.00308404192443849618) * (z * t17) - PRT__R(1.00439949330516663946) * t15;
    const prt_real t19 = PRT__R(2.00185442784391621093) * (z * t18) - PRT__R(1.00247066466748147447) * t17;
    const prt_real t20 = (((t13 + t15 * f[19]) + t17 * f[29]) + t18 * f[41]) + t19 * f[55];
    const prt_real t21 = (PRT__R(0.488602511902919921586) * f[3] + t11 * f[7]) + t12 * f[13];
    const prt_real t22 = (((t21 + t15 * f[21]) + t17 * f[31]) + t18 * f[43]) + t19 * f[57];
    const prt_real t23 = y * x;
    const prt_real t24 = t23 + t23;
    const prt_real t25 = PRT__R(1.44530572132027702769) * z;
    const prt_real t26 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
    const prt_real t27 = (PRT__R(0.546274215296039535272) * f[4] + t25 * f[10]) + t26 * f[18];
    const prt_real t28 = PRT__R(7.04063249082559160399) * t2 - PRT__R(2.6402371840595968515);
    const prt_real t29 = z * t28;
    const prt_real t30 = PRT__R(1.37233279507355082388) * t26 - PRT__R(1.19947203320611937035);
    const prt_real t31 = t26 * t30 - PRT__R(0.511906752897826512122);
    const prt_real t32 = PRT__R(2.06485074947180018626) * (z * t31) - PRT__R(1.00887444616012613957) * t29;
    const prt_real t33 = (y + x) * (x - y);
    const prt_real t34 = (PRT__R(0.546274215296039535272) * f[8] + t25 * f[14]) + t26 * f[22];
    const prt_real t35 = t24 * (((t27 + t29 * f[28]) + t31 * f[40]) + t32 * f[54]) + t33 * (((t34 + t29 * f[32]) + t31 * f[44]) + t32 * f[58]);
    const prt_real t36 = (((t8 + t9 * f[42]) + t10 * f[56]) + (y * t20 + x * t22)) + t35;
    const prt_real t37 = y * y;
    const prt_real t38 = t33 + t37;
    const prt_real t39 = y * (t33 + (t38 + t38));
    const prt_real t40 = PRT__R(1.77013076977993053104) * z;
    const prt_real t41 = PRT__R(4.37968383934737954461) * t2 - PRT__R(0.547460479918422443076);
    const prt_real t42 = (PRT__R(0.590043589926643510346) * f[9] + t40 * f[17]) + t41 * f[27];
    const prt_real t43 = PRT__R(10.0119715893477442193) * t2 - PRT__R(3.0035914768043232658);
    const prt_real t44 = z * t43;
    const prt_real t45 = PRT__R(1.14470177335741903992) * t41 - PRT__R(1.25335796441144373015);
    const prt_real t46 = t41 * t45 - PRT__R(0.48031476689438621492);
    const prt_real t47 = x * (t33 - (t37 + t37));
    const prt_real t48 = (PRT__R(0.590043589926643510346) * f[15] + t40 * f[23]) + t41 * f[33];
    const prt_real t49 = t39 * ((t42 + t44 * f[39]) + t46 * f[53]) + t47 * ((t48 + t44 * f[45]) + t46 * f[59]);
    const prt_real t50 = t33 * t24;
    const prt_real t51 = t50 + t50;
    const prt_real t52 = PRT__R(2.075662314881041279) * z;
    const prt_real t53 = PRT__R(5.53226317538874894011) * t2 - PRT__R(0.553226317538874894011);
    const prt_real t54 = (PRT__R(0.625835735449176134587) * f[16] + t52 * f[26]) + t53 * f[38];
    const prt_real t55 = PRT__R(13.3876196648007832099) * t2 - PRT__R(3.34690491620019580249);
    const prt_real t56 = z * t55;
    const prt_real t57 = (t33 + t24) * (t33 - t24);
    const prt_real t58 = (PRT__R(0.625835735449176134587) * f[24] + t52 * f[34]) + t53 * f[46];
    const prt_real t59 = (t36 + t49) + (t51 * (t54 + t56 * f[52]) + t57 * (t58 + t56 * f[60]));
    const prt_real t60 = PRT__R(2.36661916223175203199) * z;
    const prt_real t61 = PRT__R(6.73131046101657472554) * t2 - PRT__R(0.560942538418047893795);
    const prt_real t62 = (PRT__R(0.656382056840170102814) * f[25] + t60 * f[37]) + t61 * f[51];
    const prt_real t63 = (PRT__R(0.656382056840170102814) * f[35] + t60 * f[47]) + t61 * f[61];
    const prt_real t64 = t59 + ((y * t57 + x * t51) * t62 + (x * t57 - y * t51) * t63);
    const prt_real t65 = t47 * t39;
    const prt_real t66 = t65 + t65;
    const prt_real t67 = PRT__R(2.64596066180190022197) * z;
    const prt_real t68 = t66 * (PRT__R(0.683184105191914321975) * f[36] + t67 * f[50]);
    const prt_real t69 = (t47 + t39) * (t47 - t39);
    const prt_real t70 = t69 * (PRT__R(0.683184105191914321975) * f[48] + t67 * f[62]);
    const prt_real t71 = (y * t69 + x * t66) * (PRT__R(0.707162732524596178226) * f[49]);
    const prt_real t72 = (x * t69 - y * t66) * (PRT__R(0.707162732524596178226) * f[63]);
    out[0] = (t64 + (t68 + t70)) + (t71 + t72);
}

/* CH value, 9 bands: 184 multiplications, 133 additions (108 can fuse), 81 loads, 1 stores */
PRT__STATIC void prt__ch_at_9(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.825888983611586872968) * t2 - PRT__R(0.412944491805793436484);
    const prt_real t4 = PRT__R(1.61906625351721666923) * t2 - PRT__R(1.21429969013791250192);
    const prt_real t5 = z * t4;
    const prt_real t6 = t3 * (PRT__R(4.71662269588694702818) * t3) - PRT__R(0.402146687544551258061);
    const prt_real t7 = PRT__R(1.9941605714785482504) * (z * t6) - PRT__R(0.990626623845594065416) * t5;
    const prt_real t8 = (((t1 + t3 * f[6]) + t5 * f[12]) + t6 * f[20]) + t7 * f[30];
    const prt_real t9 = PRT__R(1.99686765665245415552) * (z * t7) - PRT__R(0.995518686839271862673) * t6;
    const prt_real t10 = PRT__R(1.9981247065730924832) * (z * t9) - PRT__R(0.99749765012849593691) * t7;
    const prt_real t11 = PRT__R(1.99878824587482633945) * (z * t10) - PRT__R(0.998457044322595902884) * t9;
    const prt_real t12 = PRT__R(1.09254843059207907054) * z;
    const prt_real t13 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
    const prt_real t14 = (PRT__R(0.488602511902919921586) * f[1] + t12 * f[5]) + t13 * f[11];
    const prt_real t15 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
    const prt_real t16 = z * t15;
    const prt_real t17 = PRT__R(1.81395700920230242682) * t13 - PRT__R(1.00910143904649857838);
    const prt_real t18 = t13 * t17 - PRT__R(0.561361547776433262911);
    const prt_real t19 = PRT__R(2.00308404192443849618) * (z * t18) - PRT__R(1.00439949330516663946) * t16;
    const prt_real t20 = PRT__R(2.00185442784391621093) * (z * t19) - PRT__R(1.00247066466748147447) * t18;
    const prt_real t21 = (((t14 + t16 * f[19]) + t18 * f[29]) + t19 * f[41]) + t20 * f[55];
    const prt_real t22 = PRT__R(2.00120156213902958958) * (z * t20) - PRT__R(1.00152855204404460325) * t19;
    const prt_real t23 = (PRT__R(0.488602511902919921586) * f[3] + t12 * f[7]) + t13 * f[13];
    const prt_real t24 = (((t23 + t16 * f[21]) + t18 * f[31]) + t19 * f[43]) + t20 * f[57];
    const prt_real t25 = (((t8 + t9 * f[42]) + t10 * f[56]) + t11 * f[72]) + (y * (t21 + t22 * f[71]) + x * (t24 + t22 * f[73]));
    const prt_real t26 = y * x;
    const prt_real t27 = t26 + t26;
    const prt_real t28 = PRT__R(1.44530572132027702769) * z;
    const prt_real t29 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
    const prt_real t30 = (PRT__R(0.546274215296039535272) * f[4] + t28 * f[10]) + t29 * f[18];
    const prt_real t31 = PRT__R(7.04063249082559160399) * t2 - PRT__R(2.6402371840595968515);
    const prt_real t32 = z * t31;
    const prt_real t33 = PRT__R(1.37233279507355082388) * t29 - PRT__R(1.19947203320611937035);
    const prt_real t34 = t29 * t33 - PRT__R(0.511906752897826512122);
    const prt_real t35 = PRT__R(2.06485074947180018626) * (z * t34) - PRT__R(1.00887444616012613957) * t32;
    const prt_real t36 = PRT__R(2.047379529757827986) * (z * t35) - PRT__R(1.0065555134461126069) * t34;
    const prt_real t37 = (((t30 + t32 * f[28]) + t34 * f[40]) + t35 * f[54]) + t36 * f[70];
    const prt_real t38 = (y + x) * (x - y);
    const prt_real t39 = (PRT__R(0.546274215296039535272) * f[8] + t28 * f[14]) + t29 * f[22];
    const prt_real t40 = (((t39 + t32 * f[32]) + t34 * f[44]) + t35 * f[58]) + t36 * f[74];
    const prt_real t41 = y * y;
    const prt_real t42 = t38 + t41;
    const prt_real t43 = y * (t38 + (t42 + t42));
    const prt_real t44 = PRT__R(1.77013076977993053104) * z;
    const prt_real t45 = PRT__R(4.37968383934737954461) * t2 - PRT__R(0.547460479918422443076);
    const prt_real t46 = (PRT__R(0.590043589926643510346) * f[9] + t44 * f[17]) + t45 * f[27];
    const prt_real t47 = PRT__R(10.0119715893477442193) * t2 - PRT__R(3.0035914768043232658);
    const prt_real t48 = z * t47;
    const prt_real t49 = PRT__R(1.14470177335741903992) * t45 - PRT__R(1.25335796441144373015);
    const prt_real t50 = t45 * t49 - PRT__R(0.48031476689438621492);
    const prt_real t51 = PRT__R(2.13960769627671528242) * (z * t50) - PRT__R(1.00550825192169375133) * t48;
    const prt_real t52 = x * (t38 - (t41 + t41));
    const prt_real t53 = (PRT__R(0.590043589926643510346) * f[15] + t44 * f[23]) + t45 * f[33];
    const prt_real t54 = t43 * (((t46 + t48 * f[39]) + t50 * f[53]) + t51 * f[69]) + t52 * (((t53 + t48 * f[45]) + t50 * f[59]) + t51 * f[75]);
    const prt_real t55 = t38 * t27;
    const prt_real t56 = t55 + t55;
    const prt_real t57 = PRT__R(2.075662314881041279) * z;
    const prt_real t58 = PRT__R(5.53226317538874894011) * t2 - PRT__R(0.553226317538874894011);
    const prt_real t59 = (PRT__R(0.625835735449176134587) * f[16] + t57 * f[26]) + t58 * f[38];
    const prt_real t60 = PRT__R(13.3876196648007832099) * t2 - PRT__R(3.34690491620019580249);
    const prt_real t61 = z * t60;
    const prt_real t62 = PRT__R(1.00325462178684816145) * t58 - PRT__R(1.26863282277713073229);
    const prt_real t63 = t58 * t62 - PRT__R(0.460583198810398206878);
    const prt_real t64 = (t38 + t27) * (t38 - t27);
    const prt_real t65 = (PRT__R(0.625835735449176134587) * f[24] + t57 * f[34]) + t58 * f[46];
    const prt_real t66 = t56 * ((t59 + t61 * f[52]) + t63 * f[68]) + t64 * ((t65 + t61 * f[60]) + t63 * f[76]);
    const prt_real t67 = PRT__R(2.36661916223175203199) * z;
    const prt_real t68 = PRT__R(6.73131046101657472554) * t2 - PRT__R(0.560942538418047893795);
    const prt_real t69 = (PRT__R(0.656382056840170102814) * f[25] + t67 * f[37]) + t68 * f[51];
    const prt_real t70 = PRT__R(17.1567982383278290323) * t2 - PRT__R(3.67645676535596336405);
    const prt_real t71 = z * t70;
    const prt_real t72 = (PRT__R(0.656382056840170102814) * f[35] + t67 * f[47]) + t68 * f[61];
    const prt_real t73 = (y * t64 + x * t56) * (t69 + t71 * f[67]) + (x * t64 - y * t56) * (t72 + t71 * f[77]);
    const prt_real t74 = t52 * t43;
    const prt_real t75 = t74 + t74;
    const prt_real t76 = PRT__R(2.64596066180190022197) * z;
    const prt_real t77 = PRT__R(7.97265272468488541901) * t2 - PRT__R(0.569475194620348958501);
    const prt_real t78 = (PRT__R(0.683184105191914321975) * f[36] + t76 * f[50]) + t77 * f[66];
    const prt_real t79 = (t52 + t43) * (t52 - t43);
    const prt_real t80 = (PRT__R(0.683184105191914321975) * f[48] + t76 * f[62]) + t77 * f[78];
    const prt_real t81 = ((((t25 + (t27 * t37 + t38 * t40)) + t54) + t66) + t73) + (t75 * t78 + t79 * t80);
    const prt_real t82 = PRT__R(2.91570664069931947548) * z;
    const prt_real t83 = (y * t79 + x * t75) * (PRT__R(0.707162732524596178226) * f[49] + t82 * f[65]);
    const prt_real t84 = (x * t79 - y * t75) * (PRT__R(0.707162732524596178226) * f[63] + t82 * f[79]);
    const prt_real t85 = t64 * t56;
    const prt_real t86 = ((t64 + t56) * (t64 - t56)) * (PRT__R(0.72892666017482986887) * f[80]);
    const prt_real t87 = (t85 + t85) * (PRT__R(0.72892666017482986887) * f[64]) + t86;
    out[0] = (t81 + (t83 + t84)) + t87;
}

/* CH value, 10 bands: 230 multiplications, 163 additions (137 can fuse), 100 loads, 1 stores */
PRT__STATIC void prt__ch_at_10(const prt_real *f, prt_real x, prt_real y, prt_real z, prt_real *PRT__RESTRICT out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * f[0] + (PRT__R(0.488602511902919921586) * z) * f[2];
    const prt_real t2 = z * z;
    const prt_real t3 = PRT__R(0.825888983611586872968) * t2 - PRT__R(0.412944491805793436484);
    const prt_real t4 = PRT__R(1.61906625351721666923) * t2 - PRT__R(1.21429969013791250192);
    const prt_real t5 = z * t4;
    const prt_real t6 = t3 * (PRT__R(4.71662269588694702818) * t3) - PRT__R(0.402146687544551258061);
    const prt_real t7 = PRT__R(1.9941605714785482504) * (z * t6) - PRT__R(0.990626623845594065416) * t5;
    const prt_real t8 = (((t1 + t3 * f[6]) + t5 * f[12]) + t6 * f[20]) + t7 * f[30];
    const prt_real t9 = PRT__R(1.99686765665245415552) * (z * t7) - PRT__R(0.995518686839271862673) * t6;
    const prt_real t10 = PRT__R(1.9981247065730924832) * (z * t9) - PRT__R(0.99749765012849593691) * t7;
    const prt_real t11 = PRT__R(1.99878824587482633945) * (z * t10) - PRT__R(0.998457044322595902884) * t9;
    const prt_real t12 = PRT__R(1.9991716711179192974) * (z * t11) - PRT__R(0.998980209429107783872) * t10;
    const prt_real t13 = (((t8 + t9 * f[42]) + t10 * f[56]) + t11 * f[72]) + t12 * f[90];
    const prt_real t14 = PRT__R(1.09254843059207907054) * z;
    const prt_real t15 = PRT__R(2.2251937260415151452) * t2 - PRT__R(0.556298431510378786299);
    const prt_real t16 = (PRT__R(0.488602511902919921586) * f[1] + t14 * f[5]) + t15 * f[11];
    const prt_real t17 = PRT__R(4.47811599108138469697) * t2 - PRT__R(2.23905799554069234849);
    const prt_real t18 = z * t17;
    const prt_real t19 = PRT__R(1.81395700920230242682) * t15 - PRT__R(1.00910143904649857838);
    const prt_real t20 = t15 * t19 - PRT__R(0.561361547776433262911);
    const prt_real t21 = PRT__R(2.00308404192443849618) * (z * t20) - PRT__R(1.00439949330516663946) * t18;
    const prt_real t22 = PRT__R(2.00185442784391621093) * (z * t21) - PRT__R(1.00247066466748147447) * t20;
    const prt_real t23 = (((t16 + t18 * f[19]) + t20 * f[29]) + t21 * f[41]) + t22 * f[55];
    const prt_real t24 = PRT__R(2.00120156213902958958) * (z * t22) - PRT__R(1.00152855204404460325) * t21;
    const prt_real t25 = PRT__R(2.000822875986267518) * (z * t24) - PRT__R(1.00101246624680610771) * t22;
    const prt_real t26 = (PRT__R(0.488602511902919921586) * f[3] + t14 * f[7]) + t15 * f[13];
    const prt_real t27 = (((t26 + t18 * f[21]) + t20 * f[31]) + t21 * f[43]) + t22 * f[57];
    const prt_real t28 = y * ((t23 + t24 * f[71]) + t25 * f[89]) + x * ((t27 + t24 * f[73]) + t25 * f[91]);
    const prt_real t29 = y * x;
    const prt_real t30 = t29 + t29;
    const prt_real t31 = PRT__R(1.44530572132027702769) * z;
    const prt_real t32 = PRT__R(3.27764529177623721163) * t2 - PRT__R(0.546274215296039535272);
    const prt_real t33 = (PRT__R(0.546274215296039535272) * f[4] + t31 * f[10]) + t32 * f[18];
    const prt_real t34 = PRT__R(7.04063249082559160399) * t2 - PRT__R(2.6402371840595968515);
    const prt_real t35 = z * t34;
    const prt_real t36 = PRT__R(1.37233279507355082388) * t32 - PRT__R(1.19947203320611937035);
    const prt_real t37 = t32 * t36 - PRT__R(0.511906752897826512122);
    const prt_real t38 = PRT__R(2.06485074947180018626) * (z * t37) - PRT__R(1.00887444616012613957) * t35;
    const prt_real t39 = PRT__R(2.047379529757827986) * (z * t38) - PRT__R(1.0065555134461126069) * t37;
    const prt_real t40 = (((t33 + t35 * f[28]) + t37 * f[40]) + t38 * f[54]) + t39 * f[70];
    const prt_real t41 = PRT__R(2.03608622627713160396) * (z * t39) - PRT__R(1.00494030387093691765) * t38;
    const prt_real t42 = (y + x) * (x - y);
    const prt_real t43 = (PRT__R(0.546274215296039535272) * f[8] + t31 * f[14]) + t32 * f[22];
    const prt_real t44 = (((t43 + t35 * f[32]) + t37 * f[44]) + t38 * f[58]) + t39 * f[74];
    const prt_real t45 = (t13 + t28) + (t30 * (t40 + t41 * f[88]) + t42 * (t44 + t41 * f[92]));
    const prt_real t46 = y * y;
    const prt_real t47 = t42 + t46;
    const prt_real t48 = y * (t42 + (t47 + t47));
    const prt_real t49 = PRT__R(1.77013076977993053104) * z;
    const prt_real t50 = PRT__R(4.37968383934737954461) * t2 - PRT__R(0.547460479918422443076);
    const prt_real t51 = (PRT__R(0.590043589926643510346) * f[9] + t49 * f[17]) + t50 * f[27];
    const prt_real t52 = PRT__R(10.0119715893477442193) * t2 - PRT__R(3.0035914768043232658);
    const prt_real t53 = z * t52;
    const prt_real t54 = PRT__R(1.14470177335741903992) * t50 - PRT__R(1.25335796441144373015);
    const prt_real t55 = t50 * t54 - PRT__R(0.48031476689438621492);
    const prt_real t56 = PRT__R(2.13960769627671528242) * (z * t55) - PRT__R(1.00550825192169375133) * t53;
    const prt_real t57 = PRT__R(2.10577559828109434639) * (z * t56) - PRT__R(1.00569948140936029559) * t55;
    const prt_real t58 = (((t51 + t53 * f[39]) + t55 * f[53]) + t56 * f[69]) + t57 * f[87];
    const prt_real t59 = x * (t42 - (t46 + t46));
    const prt_real t60 = (PRT__R(0.590043589926643510346) * f[15] + t49 * f[23]) + t50 * f[33];
    const prt_real t61 = (((t60 + t53 * f[45]) + t55 * f[59]) + t56 * f[75]) + t57 * f[93];
    const prt_real t62 = t42 * t30;
    const prt_real t63 = t62 + t62;
    const prt_real t64 = PRT__R(2.075662314881041279) * z;
    const prt_real t65 = PRT__R(5.53226317538874894011) * t2 - PRT__R(0.553226317538874894011);
    const prt_real t66 = (PRT__R(0.625835735449176134587) * f[16] + t64 * f[26]) + t65 * f[38];
    const prt_real t67 = PRT__R(13.3876196648007832099) * t2 - PRT__R(3.34690491620019580249);
    const prt_real t68 = z * t67;
    const prt_real t69 = PRT__R(1.00325462178684816145) * t65 - PRT__R(1.26863282277713073229);
    const prt_real t70 = t65 * t69 - PRT__R(0.460583198810398206878);
    const prt_real t71 = PRT__R(2.21822946338610302856) * (z * t70) - PRT__R(0.999366056347041316611) * t68;
    const prt_real t72 = (t42 + t30) * (t42 - t30);
    const prt_real t73 = (PRT__R(0.625835735449176134587) * f[24] + t64 * f[34]) + t65 * f[46];
    const prt_real t74 = t63 * (((t66 + t68 * f[52]) + t70 * f[68]) + t71 * f[86]) + t72 * (((t73 + t68 * f[60]) + t70 * f[76]) + t71 * f[94]);
    const prt_real t75 = PRT__R(2.36661916223175203199) * z;
    const prt_real t76 = PRT__R(6.73131046101657472554) * t2 - PRT__R(0.560942538418047893795);
    const prt_real t77 = (PRT__R(0.656382056840170102814) * f[25] + t75 * f[37]) + t76 * f[51];
    const prt_real t78 = PRT__R(17.1567982383278290323) * t2 - PRT__R(3.67645676535596336405);
    const prt_real t79 = z * t78;
    const prt_real t80 = PRT__R(0.906010318363799802197) * t76 - PRT__R(1.27054931953983393429);
    const prt_real t81 = t76 * t80 - PRT__R(0.447986100878170112466);
    const prt_real t82 = (PRT__R(0.656382056840170102814) * f[35] + t75 * f[47]) + t76 * f[61];
    const prt_real t83 = (y * t72 + x * t63) * ((t77 + t79 * f[67]) + t81 * f[85]) + (x * t72 - y * t63) * ((t82 + t79 * f[77]) + t81 * f[95]);
    const prt_real t84 = t59 * t48;
    const prt_real t85 = t84 + t84;
    const prt_real t86 = PRT__R(2.64596066180190022197) * z;
    const prt_real t87 = PRT__R(7.97265272468488541901) * t2 - PRT__R(0.569475194620348958501);
    const prt_real t88 = (PRT__R(0.683184105191914321975) * f[36] + t86 * f[50]) + t87 * f[66];
    const prt_real t89 = PRT__R(21.3083359134333530585) * t2 - PRT__R(3.99531298376875369847);
    const prt_real t90 = z * t89;
    const prt_real t91 = (t59 + t48) * (t59 - t48);
    const prt_real t92 = (PRT__R(0.683184105191914321975) * f[48] + t86 * f[62]) + t87 * f[78];
    const prt_real t93 = (((t45 + (t48 * t58 + t59 * t61)) + t74) + t83) + (t85 * (t88 + t90 * f[84]) + t91 * (t92 + t90 * f[96]));
    const prt_real t94 = PRT__R(2.91570664069931947548) * z;
    const prt_real t95 = PRT__R(9.25266937297977981733) * t2 - PRT__R(0.578291835811236238583);
    const prt_real t96 = (PRT__R(0.707162732524596178226) * f[49] + t94 * f[65]) + t95 * f[83];
    const prt_real t97 = (PRT__R(0.707162732524596178226) * f[63] + t94 * f[79]) + t95 * f[97];
    const prt_real t98 = t93 + ((y * t91 + x * t85) * t96 + (x * t91 - y * t85) * t97);
    const prt_real t99 = t72 * t63;
    const prt_real t100 = t99 + t99;
    const prt_real t101 = PRT__R(3.1773176489546974773) * z;
    const prt_real t102 = t100 * (PRT__R(0.72892666017482986887) * f[64] + t101 * f[82]);
    const prt_real t103 = (t72 + t63) * (t72 - t63);
    const prt_real t104 = t103 * (PRT__R(0.72892666017482986887) * f[80] + t101 * f[98]);
    const prt_real t105 = (y * t103 + x * t100) * (PRT__R(0.74890095185318829655) * f[81]);
    const prt_real t106 = (x * t103 - y * t100) * (PRT__R(0.74890095185318829655) * f[99]);
    out[0] = (t98 + (t102 + t104)) + (t105 + t106);
}

/* END GENERATED */
#endif /* PRT_NO_CH */

/* BEGIN GENERATED: prt_codegen --table windows --count 16 */
/* hann windows: weight of band l for width 1 ... 16 at (width-1) width/2 + l */
PRT__STATIC const double *prt__window_hann(void) {
    static const double table[136] = {
        1.0, 1.0, 0.5, 1.0, 0.75, 0.25, 1.0, 0.8535533905932737622, 0.5, 0.1464466094067262378,
        1.0, 0.90450849718747371205, 0.65450849718747371205, 0.34549150281252628795, 0.095491502812526287949,
        1.0, 0.93301270189221932338, 0.75, 0.5, 0.25, 0.066987298107780676618, 1.0, 0.95048443395120956312,
        0.81174490092936676526, 0.61126046697815720214, 0.38873953302184279786, 0.18825509907063323474,
        0.049515566048790436882, 1.0, 0.96193976625564337806, 0.8535533905932737622, 0.69134171618254488586,
        0.5, 0.30865828381745511414, 0.1464466094067262378, 0.038060233744356621936, 1.0, 0.96984631039295419203,
        0.8830222215594890176, 0.75, 0.58682408883346517443, 0.41317591116653482557, 0.25, 0.1169777784405109824,
        0.030153689607045807973, 1.0, 0.97552825814757678606, 0.90450849718747371205, 0.79389262614623656458,
        0.65450849718747371205, 0.5, 0.34549150281252628795, 0.20610737385376343542, 0.095491502812526287949,
        0.024471741852423213942, 1.0, 0.97974648680724869495, 0.92062676641559058443, 0.82743036697264253203,
        0.70770750650094321276, 0.57115741913664257022, 0.42884258086335742978, 0.29229249349905678724,
        0.17256963302735746797, 0.079373233584409415569, 0.020253513192751305055, 1.0, 0.98296291314453414337,
        0.93301270189221932338, 0.8535533905932737622, 0.75, 0.62940952255126038117, 0.5, 0.37059047744873961883,
        0.25, 0.1464466094067262378, 0.066987298107780676618, 0.017037086855465856625, 1.0, 0.98547090871302601358,
        0.94272801282660494795, 0.87425537408555054932, 0.78403237336557790126, 0.67730244352126781298,
        0.56026834012766152667, 0.43973165987233847333, 0.32269755647873218702, 0.21596762663442209874,
        0.12574462591444945068, 0.05727198717339505205, 0.014529091286973986422, 1.0, 0.98746395609091180351,
        0.95048443395120956312, 0.89091574123401490435, 0.81174490092936676526, 0.71694186955877906024,
        0.61126046697815720214, 0.5, 0.38873953302184279786, 0.28305813044122093976, 0.18825509907063323474,
        0.10908425876598509565, 0.049515566048790436882, 0.012536043909088196491, 1.0, 0.98907380036690281896,
        0.95677272882130044775, 0.90450849718747371205, 0.83456530317942910691, 0.75, 0.65450849718747371205,
        0.5522642316338267357, 0.4477357683661732643, 0.34549150281252628795, 0.25, 0.16543469682057089309,
        0.095491502812526287949, 0.043227271178699552249, 0.010926199633097181036, 1.0, 0.99039264020161522456,
        0.96193976625564337806, 0.91573480615127261854, 0.8535533905932737622, 0.77778511650980111237,
        0.69134171618254488586, 0.59754516100806413392, 0.5, 0.40245483899193586608, 0.30865828381745511414,
        0.22221488349019888763, 0.1464466094067262378, 0.084265193848727381461, 0.038060233744356621936,
        0.0096073597983847754369
    };
    return table;
}

/* lanczos windows: weight of band l for width 1 ... 16 at (width-1) width/2 + l */
PRT__STATIC const double *prt__window_lanczos(void) {
    static const double table[136] = {
        1.0, 1.0, 0.63661977236758134308, 1.0, 0.82699334313268807427, 0.41349667156634403713,
        1.0, 0.90031631615710606956, 0.63661977236758134308, 0.30010543871903535652, 1.0, 0.93548928378863903321,
        0.75682672864065697923, 0.50455115242710465282, 0.2338723209471597583, 1.0, 0.95492965855137201461,
        0.82699334313268807427, 0.63661977236758134308, 0.41349667156634403713, 0.19098593171027440292,
        1.0, 0.96676638530855214796, 0.87102641569756015086, 0.72410144978265952504, 0.54307608733699464378,
        0.34841056627902406035, 0.16112773088475869133, 1.0, 0.97449535840443264512, 0.90031631615710606956,
        0.78421330357653712202, 0.63661977236758134308, 0.47052798214592227321, 0.30010543871903535652,
        0.13921362262920466359, 1.0, 0.97981553605101648399, 0.92072542895852937812, 0.82699334313268807427,
        0.70531659849201881006, 0.56425327879361504804, 0.41349667156634403713, 0.2630644082738655366,
        0.1224769420063770605, 1.0, 0.98363164308346596735, 0.93548928378863903321, 0.85839369133413977501,
        0.75682672864065697923, 0.63661977236758134308, 0.50455115242710465282, 0.36788301057177418929,
        0.2338723209471597583, 0.10929240478705177415, 1.0, 0.98646083912710205269, 0.94650224388831548428,
        0.88206272365255806559, 0.79624835650368565609, 0.69315389111626959647, 0.57762824259689133039,
        0.45499906085924894633, 0.3307735213697092746, 0.21033383197518121873, 0.098646083912710205269,
        1.0, 0.98861592946536921938, 0.95492965855137201461, 0.90031631615710606956, 0.82699334313268807427,
        0.73791297558733748561, 0.63661977236758134308, 0.52708069684809820401, 0.41349667156634403713,
        0.30010543871903535652, 0.19098593171027440292, 0.089874175405942656308, 1.0, 0.99029504419782001947,
        0.96151887000144388821, 0.91467349077225437371, 0.85138267722204389049, 0.77382477585189397258,
        0.68464293891021285808, 0.58683680478018244978, 0.48364048490743373286, 0.37839230098757506244,
        0.27440204723167631211, 0.1748216127275352524, 0.082524587016485001622, 1.0, 0.99162858425603334449,
        0.96676638530855214796, 0.92616051670990244874, 0.87102641569756015086, 0.8030044338320417405,
        0.72410144978265952504, 0.63661977236758134308, 0.54307608733699464378, 0.44611357435113430028,
        0.34841056627902406035, 0.25258923182997339511, 0.16112773088475869133, 0.076279121865848718807,
        1.0, 0.99270519960720675966, 0.97101220923176290694, 0.93548928378863903321, 0.88706379305918377893,
        0.82699334313268807427, 0.75682672864065697923, 0.67835603854706327336, 0.59356153372868036419,
        0.50455115242710465282, 0.41349667156634403713, 0.32256865202152137416, 0.2338723209471597583,
        0.14938649372796352414, 0.07090751425765762569, 1.0, 0.9935868511442057663, 0.97449535840443264512,
        0.94316532074438211273, 0.90031631615710606956, 0.84692799250337193706, 0.78421330357653712202,
        0.71358548794489029397, 0.63661977236758134308, 0.55501093506824800642, 0.47052798214592227321,
        0.38496726931971451685, 0.30010543871903535652, 0.21765353555639587217, 0.13921362262920466359,
        0.066239123409613717754
    };
    return table;
}

/* positive windows: weight of band l for width 1 ... 16 at (width-1) width/2 + l */
PRT__STATIC const double *prt__window_positive(void) {
    static const double table[136] = {
        1.0, 1.0, 0.33333333333333333333, 1.0, 0.57735026918962576451, 0.2, 1.0, 0.68989794855663561964,
        0.34494897427831780982, 0.093578717960240312883, 1.0, 0.77459666924148337704, 0.48571428571428571429,
        0.22131333406899525058, 0.063492063492063492063, 1.0, 0.82282408097459210521, 0.57611430205408276365,
        0.32616412509556891217, 0.14039292951996396188, 0.035680614305211888582, 1.0, 0.86113631159405257522,
        0.65540766286107894359, 0.42838905754161649851, 0.23543778300977621503, 0.098351648648280926527,
        0.026356494317880762619, 1.0, 0.88579160777096463561, 0.70924614273658511646, 0.50478388446010662338,
        0.31542540151686073445, 0.16508996392378056997, 0.066989588507976113483, 0.016604824016209008501,
        1.0, 0.9061798459386639928, 0.7561298816164829212, 0.5746945664799351087, 0.39586103728594092058,
        0.2402739072003459132, 0.12456097908283001293, 0.049977780595316047141, 0.012976980055159098854,
        1.0, 0.92038028589706251532, 0.78976232216844298264, 0.62742332427006856566, 0.46005819708814381817,
        0.30622691080359980486, 0.18139073493923034635, 0.091352913885923727042, 0.036016972790941475148,
        0.0088320853463888206389, 1.0, 0.93246951420315202781, 0.81930685450220939568, 0.67505293842206772367,
        0.52101418341507956065, 0.37244297618895996577, 0.24399573979984582179, 0.14245248722649306337,
        0.07160169429670985373, 0.028116584500175400155, 0.0071792426229772324729, 1.0, 0.94136714568043021606,
        0.84145400056051045293, 0.71185600683306375858, 0.56966136160507929453, 0.42802621347728644223,
        0.29970270433610036942, 0.19233495096893660368, 0.11061917856337013722, 0.054531127410892559144,
        0.021161945486990115301, 0.0051646428677286943586, 1.0, 0.94910791234275852453, 0.86112816098028115886,
        0.74512497236684605117, 0.61499496808419465795, 0.4815371410752342585, 0.35608782449306076629,
        0.24580683319603685916, 0.15643398344906205522, 0.089271862773536158875, 0.044063997692037006526,
        0.017086508211739221467, 0.0043206488087273198723, 1.0, 0.95504122712257500378, 0.87639589211471016209,
        0.77146638909829611871, 0.65163304004515694892, 0.52614734042714737158, 0.40473450091614772793,
        0.2943202429802143532, 0.20050199987317033717, 0.12586353092009634319, 0.071107606632923218413,
        0.034603998348757134312, 0.013303235772430160729, 0.0032403007546311967842, 1.0, 0.96028985649753623168,
        0.89010344728290644066, 0.79539525518773670114, 0.68559550155273914108, 0.5683764975602726757,
        0.45223634690067764117, 0.34333987378308093884, 0.24730159263840422324, 0.16702497296140045597,
        0.10437716082397107193, 0.058712309660426287951, 0.028650517849476793725, 0.011022980392886860412,
        0.0027707461316773926296, 1.0, 0.96444016970527309637, 0.90103852466660929085, 0.81475660394443598235,
        0.71346228281742165917, 0.60375346589007652363, 0.49292757111561328156, 0.38666863473687317316,
        0.2901408729263988644, 0.20662479478518149205, 0.13829614113919610345, 0.08558327486297905011,
        0.04779632775263624675, 0.023069022750020088503, 0.0088167389767978915657, 0.0021462774651431782107
    };
    return table;
}

/* END GENERATED */

/* BEGIN GENERATED: prt_codegen --table grids --count 16 */
/* nodes of the product grids, z >= 0 */
PRT__STATIC const double *prt__grid_nodes(void) {
    static const double table[100] = {
        0.0, 0.57735026918962576451, 0.86113631159405257522, 0.3399810435848562648, 0.9061798459386639928,
        0.53846931010568309104, 0.0, 0.94910791234275852453, 0.74153118559939443986, 0.40584515137739716691,
        0.0, 0.96028985649753623168, 0.79666647741362673959, 0.52553240991632898582, 0.18343464249564980494,
        0.97390652851717172008, 0.86506336668898451073, 0.67940956829902440623, 0.4333953941292471908,
        0.14887433898163121088, 0.9782286581460569928, 0.88706259976809529908, 0.73015200557404932409,
        0.51909612920681181593, 0.26954315595234497233, 0.0, 0.98418305471858814947, 0.91759839922297796521,
        0.80157809073330991279, 0.64234933944034022064, 0.44849275103644685288, 0.23045831595513479407,
        0.0, 0.98628380869681233884, 0.92843488366357351734, 0.82720131506976499319, 0.68729290481168547015,
        0.51524863635815409197, 0.31911236892788976044, 0.10805494870734366207, 0.9894009349916499326,
        0.94457502307323257608, 0.86563120238783174388, 0.7554044083550030339, 0.61787624440264374845,
        0.45801677765722738634, 0.28160355077925891323, 0.095012509837637440185, 0.99057547531441733568,
        0.95067552176876776122, 0.88023915372698590212, 0.78151400389680140693, 0.65767115921669076585,
        0.51269053708647696789, 0.3512317634538763153, 0.17848418149584785585, 0.0, 0.99240684384358440319,
        0.96020815213483003085, 0.90315590361481790164, 0.82271465653714282498, 0.72096617733522937862,
        0.60054530466168102347, 0.46457074137596094572, 0.31656409996362983199, 0.16035864564022537587,
        0.0, 0.99312859918509492479, 0.96397192727791379127, 0.91223442825132590587, 0.83911697182221882339,
        0.74633190646015079261, 0.63605368072651502545, 0.510867001950827098, 0.37370608871541956067,
        0.22778585114164507808, 0.076526521133497333755, 0.99429458548239929207, 0.97006049783542872712,
        0.92695677218717400052, 0.86581257772030013654, 0.787816805979208162, 0.69448726318668278005,
        0.58764040350691159296, 0.46935583798675702641, 0.34193582089208422516, 0.20786042668822128548,
        0.069739273319722221214, 0.99476933499755212352, 0.97254247121811523196, 0.93297108682601610235,
        0.87675235827044166738, 0.80488840161883989215, 0.71866136313195019446, 0.61960987576364615639,
        0.50950147784600754969, 0.39030103803029083142, 0.26413568097034493053, 0.13325682429846611093,
        0.0
    };
    return table;
}

/* weights of the product grids */
PRT__STATIC const double *prt__grid_weights(void) {
    static const double table[100] = {
        1.5707963267948966192, 1.5707963267948966192, 0.27320455649986006227, 0.51219360689758824735,
        0.12405462692173950072, 0.25060938583970991512, 0.14893476283684945723, 0.050848627308305492903,
        0.1098400503840210821, 0.1499443101983376748, 0.082066093808059905005, 0.039752353242936729575,
        0.087328828017052492275, 0.12319231175903318696, 0.142425588679701746, 0.02094542054851303252,
        0.046951526056054717732, 0.068828010698191943975, 0.0845926347240509469, 0.092841673332168682719,
        0.014573996790670127715, 0.032876863845503030241, 0.048770663173855245418, 0.06104998480876207833,
        0.068802068863616895043, 0.035725810316742059792, 0.0090845894256150391858, 0.020672016223420072993,
        0.031163142820336475779, 0.03997586460201981202, 0.046633812017139726073, 0.050777826910346633028,
        0.026092223257536043669, 0.0078807884697335582687, 0.017987432696208072156, 0.02726870349627490231,
        0.035276308218944933001, 0.041634719033965175539, 0.04604642758248099825, 0.048305095758806163223,
        0.0053313729384288564499, 0.012223450841608284404, 0.018684330076766115516, 0.024470841282552420162,
        0.029373103717041145551, 0.033213804914884959392, 0.035854096701596241953, 0.037198540376484053976,
        0.004214673938249528532, 0.009679513891825863101, 0.014841607713490120758, 0.019527415133231162346,
        0.023585745689640166945, 0.026886057295308651, 0.029322247394869588882, 0.030816005448826847566,
        0.015659658693991028561, 0.0030570505464114503782, 0.0070394022791714472372, 0.010845491411752009422,
        0.014371218990293012716, 0.017524847701858044736, 0.020224625141707706645, 0.022400608395063506538,
        0.023996433773604702498, 0.024970767527805665608, 0.012649186911822116145, 0.0027668017714319232925,
        0.0063776576793068660105, 0.0098445023315930736879, 0.013081079977613566682, 0.016011145779868497445,
        0.018565953665239513716, 0.020685602955658783675, 0.02232040465691606074, 0.023432037920819076774,
        0.0239944459410422999, 0.0020888728438999082721, 0.0048230446679350188024, 0.0074674707976081227198,
        0.0099669123840447970724, 0.012272432669511221541, 0.014339106295375418228, 0.016126694169074973155,
        0.017600398251153946535, 0.018731532681120941797, 0.01949808036881746212, 0.019885120943721518778,
        0.0017556083014909651325, 0.0040563204812368378061, 0.0062881165252472366868, 0.0084080043008045240183,
        0.01037791253349864941, 0.01216264533570309445, 0.013730342665194664592, 0.015053025004593169621,
        0.016107087470373858721, 0.016873719576323570412, 0.017339240411388191751, 0.0087476712937199556693
    };
    return table;
}

/* sin(pi k/(4q)), k = 0 ... 2q, for q = 1, 2, ...: q from place q^2-1 */
PRT__STATIC const double *prt__grid_sines(void) {
    static const double table[168] = {
        0.0, 0.7071067811865475244, 1.0, 0.0, 0.38268343236508977173, 0.7071067811865475244, 0.92387953251128675613,
        1.0, 0.0, 0.25881904510252076235, 0.5, 0.7071067811865475244, 0.86602540378443864676,
        0.96592582628906828675, 1.0, 0.0, 0.19509032201612826785, 0.38268343236508977173, 0.55557023301960222474,
        0.7071067811865475244, 0.83146961230254523708, 0.92387953251128675613, 0.98078528040323044913,
        1.0, 0.0, 0.15643446504023086901, 0.3090169943749474241, 0.45399049973954679156, 0.58778525229247312917,
        0.7071067811865475244, 0.8090169943749474241, 0.89100652418836786236, 0.95105651629515357212,
        0.98768834059513772619, 1.0, 0.0, 0.13052619222005159155, 0.25881904510252076235, 0.38268343236508977173,
        0.5, 0.60876142900872063942, 0.7071067811865475244, 0.79335334029123516458, 0.86602540378443864676,
        0.92387953251128675613, 0.96592582628906828675, 0.99144486137381041114, 1.0, 0.0, 0.11196447610330785847,
        0.22252093395631440429, 0.33027906195516708177, 0.43388373911755812048, 0.53203207651533656356,
        0.62348980185873353053, 0.7071067811865475244, 0.78183148246802980871, 0.84672419922828416835,
        0.90096886790241912624, 0.9438833303083675629, 0.97492791218182360702, 0.99371220989324258353,
        1.0, 0.0, 0.098017140329560601994, 0.19509032201612826785, 0.29028467725446236764, 0.38268343236508977173,
        0.47139673682599764856, 0.55557023301960222474, 0.63439328416364549822, 0.7071067811865475244,
        0.77301045336273696081, 0.83146961230254523708, 0.88192126434835502971, 0.92387953251128675613,
        0.95694033573220886494, 0.98078528040323044913, 0.99518472667219688624, 1.0, 0.0, 0.087155742747658173558,
        0.17364817766693034885, 0.25881904510252076235, 0.34202014332566873304, 0.42261826174069943619,
        0.5, 0.57357643635104609611, 0.64278760968653932632, 0.7071067811865475244, 0.7660444431189780352,
        0.81915204428899178968, 0.86602540378443864676, 0.90630778703664996324, 0.93969262078590838405,
        0.96592582628906828675, 0.98480775301220805937, 0.9961946980917455323, 1.0, 0.0, 0.078459095727844945033,
        0.15643446504023086901, 0.23344536385590541177, 0.3090169943749474241, 0.38268343236508977173,
        0.45399049973954679156, 0.52249856471594886499, 0.58778525229247312917, 0.64944804833018365573,
        0.7071067811865475244, 0.76040596560003093817, 0.8090169943749474241, 0.85264016435409222152,
        0.89100652418836786236, 0.92387953251128675613, 0.95105651629515357212, 0.97236992039767660183,
        0.98768834059513772619, 0.9969173337331279762, 1.0, 0.0, 0.071339183199232340327, 0.14231483827328514044,
        0.21256528955297667388, 0.28173255684142969771, 0.34946417959909833671, 0.41541501300188642553,
        0.4792489867200568312, 0.54064081745559758211, 0.59927766651134693453, 0.65486073394528506406,
        0.7071067811865475244, 0.75574957435425828377, 0.80054124092436040397, 0.84125353283118116886,
        0.87767898956725561521, 0.90963199535451837141, 0.93694972499976173582, 0.95949297361449738989,
        0.97714686597115951949, 0.98982144188093273238, 0.99745211461025354136, 1.0, 0.0, 0.065403129230143066815,
        0.13052619222005159155, 0.19509032201612826785, 0.25881904510252076235, 0.3214394653031615807,
        0.38268343236508977173, 0.442288690219001282, 0.5, 0.55557023301960222474, 0.60876142900872063942,
        0.65934581510006886843, 0.7071067811865475244, 0.75183980747897739641, 0.79335334029123516458,
        0.83146961230254523708, 0.86602540378443864676, 0.89687274153268830389, 0.92387953251128675613,
        0.94693012949510566426, 0.96592582628906828675, 0.98078528040323044913, 0.99144486137381041114,
        0.99785892323860350674, 1.0
    };
    return table;
}

/* END GENERATED */

/* BEGIN GENERATED: prt_codegen --lang c --emit sh_product --bands 1-4 */
/* product, 1 band: 2 multiplications, 0 additions (0 can fuse), 2 loads, 1 stores */
PRT__STATIC void prt__sh_product_1(const prt_real *f, const prt_real *g, prt_real *out) {
    const prt_real t1 = PRT__R(0.282094791773878143474) * (f[0] * g[0]);
    out[0] = t1;
}

/* product, 1 band: 2 multiplications, 0 additions (0 can fuse), 2 loads, 1 stores */
PRT__STATIC void prt__sh_product_1_v(const prt_real *f, const prt_real *g, prt_real *out, size_t stride) {
    (void)stride;
    const prt__vec t1 = PRT__R(0.282094791773878143474) * (prt__vec_load(f) * prt__vec_load(g));
    prt__vec_store(out, t1);
}

/* product, 2 bands: 15 multiplications, 6 additions (5 can fuse), 8 loads, 4 stores */
PRT__STATIC void prt__sh_product_2(const prt_real *f, const prt_real *g, prt_real *out) {
    const prt_real t1 = f[0];
    const prt_real t2 = g[0];
    const prt_real t3 = f[2];
    const prt_real t4 = g[2];
    const prt_real t5 = f[1];
    const prt_real t6 = g[1];
    const prt_real t7 = f[3];
    const prt_real t8 = g[3];
    const prt_real t9 = PRT__R(0.282094791773878143474) * ((t1 * t2 + t3 * t4) + (t5 * t6 + t7 * t8));
    const prt_real t10 = t4 * (PRT__R(0.282094791773878143474) * t1) + t3 * (PRT__R(0.282094791773878143474) * t2);
    const prt_real t11 = PRT__R(0.282094791773878143474) * t1;
    const prt_real t12 = PRT__R(0.282094791773878143474) * t2;
    const prt_real t13 = t6 * t11 + t5 * t12;
    const prt_real t14 = t8 * t11 + t7 * t12;
    out[0] = t9;
    out[2] = t10;
    out[1] = t13;
    out[3] = t14;
}

/* product, 2 bands: 15 multiplications, 6 additions (5 can fuse), 8 loads, 4 stores */
PRT__STATIC void prt__sh_product_2_v(const prt_real *f, const prt_real *g, prt_real *out, size_t stride) {
    const prt__vec t1 = prt__vec_load(f);
    const prt__vec t2 = prt__vec_load(g);
    const prt__vec t3 = prt__vec_load(f + 2 * stride);
    const prt__vec t4 = prt__vec_load(g + 2 * stride);
    const prt__vec t5 = prt__vec_load(f + stride);
    const prt__vec t6 = prt__vec_load(g + stride);
    const prt__vec t7 = prt__vec_load(f + 3 * stride);
    const prt__vec t8 = prt__vec_load(g + 3 * stride);
    const prt__vec t9 = PRT__R(0.282094791773878143474) * ((t1 * t2 + t3 * t4) + (t5 * t6 + t7 * t8));
    const prt__vec t10 = t4 * (PRT__R(0.282094791773878143474) * t1) + t3 * (PRT__R(0.282094791773878143474) * t2);
    const prt__vec t11 = PRT__R(0.282094791773878143474) * t1;
    const prt__vec t12 = PRT__R(0.282094791773878143474) * t2;
    const prt__vec t13 = t6 * t11 + t5 * t12;
    const prt__vec t14 = t8 * t11 + t7 * t12;
    prt__vec_store(out, t9);
    prt__vec_store(out + 2 * stride, t10);
    prt__vec_store(out + stride, t13);
    prt__vec_store(out + 3 * stride, t14);
}

/* product, 3 bands: 97 multiplications, 65 additions (44 can fuse), 18 loads, 9 stores */
PRT__STATIC void prt__sh_product_3(const prt_real *f, const prt_real *g, prt_real *out) {
    const prt_real t1 = f[2];
    const prt_real t2 = g[2];
    const prt_real t3 = t1 * t2;
    const prt_real t4 = f[6];
    const prt_real t5 = g[6];
    const prt_real t6 = t4 * t5;
    const prt_real t7 = f[0];
    const prt_real t8 = g[0];
    const prt_real t9 = f[1];
    const prt_real t10 = g[1];
    const prt_real t11 = t9 * t10;
    const prt_real t12 = f[3];
    const prt_real t13 = g[3];
    const prt_real t14 = t12 * t13;
    const prt_real t15 = t11 + t14;
    const prt_real t16 = f[5];
    const prt_real t17 = g[5];
    const prt_real t18 = t16 * t17;
    const prt_real t19 = f[7];
    const prt_real t20 = g[7];
    const prt_real t21 = t19 * t20;
    const prt_real t22 = t18 + t21;
    const prt_real t23 = f[4];
    const prt_real t24 = g[4];
    const prt_real t25 = f[8];
    const prt_real t26 = g[8];
    const prt_real t27 = t23 * t24 + t25 * t26;
    const prt_real t28 = PRT__R(0.282094791773878143474) * (((((t3 + t6) + t7 * t8) + t15) + t22) + t27);
    const prt_real t29 = PRT__R(0.282094791773878143474) * t7 + PRT__R(0.252313252202016004825) * t4;
    const prt_real t30 = PRT__R(0.282094791773878143474) * t8 + PRT__R(0.252313252202016004825) * t5;
    const prt_real t31 = PRT__R(0.218509686118415814109) * t16;
    const prt_real t32 = PRT__R(0.218509686118415814109) * t19;
    const prt_real t33 = PRT__R(0.218509686118415814109) * t17;
    const prt_real t34 = PRT__R(0.218509686118415814109) * t20;
    const prt_real t35 = (t2 * t29 + t1 * t30) + ((t10 * t31 + t13 * t32) + (t9 * t33 + t12 * t34));
    const prt_real t36 = PRT__R(0.282094791773878143474) * t7 + PRT__R(-0.126156626101008002412) * t4;
    const prt_real t37 = PRT__R(0.282094791773878143474) * t8 + PRT__R(-0.126156626101008002412) * t5;
    const prt_real t38 = PRT__R(0.218509686118415814109) * t23;
    const prt_real t39 = PRT__R(0.218509686118415814109) * t25;
    const prt_real t40 = PRT__R(0.218509686118415814109) * t24;
    const prt_real t41 = PRT__R(0.218509686118415814109) * t26;
    const prt_real t42 = ((t10 * t36 + t9 * t37) + (t2 * t31 + t1 * t33)) + ((t13 * t38 - t10 * t39) + (t12 * t40 - t9 * t41));
    const prt_real t43 = ((t13 * t36 + t12 * t37) + (t2 * t32 + t1 * t34)) + ((t10 * t38 + t13 * t39) + (t9 * t40 + t12 * t41));
    const prt_real t44 = PRT__R(0.252313252202016004825) * t3 + PRT__R(0.180223751572868574875) * t6;
    const prt_real t45 = PRT__R(0.282094791773878143474) * t7;
    const prt_real t46 = PRT__R(0.282094791773878143474) * t8;
    const prt_real t47 = (t44 + (t5 * t45 + t4 * t46)) + PRT__R(-0.126156626101008002412) * t15;
    const prt_real t48 = (t47 + PRT__R(0.0901118757864342874374) * t22) + PRT__R(-0.180223751572868574875) * t27;
    const prt_real t49 = t45 + PRT__R(0.0901118757864342874374) * t4;
    const prt_real t50 = t46 + PRT__R(0.0901118757864342874374) * t5;
    const prt_real t51 = (t17 * t49 + t16 * t50) + PRT__R(0.218509686118415814109) * (t2 * t9 + t1 * t10);
    const prt_real t52 = PRT__R(0.15607834722743986722) * t23;
    const prt_real t53 = PRT__R(0.15607834722743986722) * t25;
    const prt_real t54 = PRT__R(0.15607834722743986722) * t24;
    const prt_real t55 = PRT__R(0.15607834722743986722) * t26;
    const prt_real t56 = t51 + ((t20 * t52 - t17 * t53) + (t19 * t54 - t16 * t55));
    const prt_real t57 = (t20 * t49 + t19 * t50) + PRT__R(0.218509686118415814109) * (t2 * t12 + t1 * t13);
    const prt_real t58 = t57 + ((t17 * t52 + t20 * t53) + (t16 * t54 + t19 * t55));
    const prt_real t59 = PRT__R(0.282094791773878143474) * t7 + PRT__R(-0.180223751572868574875) * t4;
    const prt_real t60 = PRT__R(0.282094791773878143474) * t8 + PRT__R(-0.180223751572868574875) * t5;
    const prt_real t61 = (t24 * t59 + t23 * t60) + PRT__R(0.218509686118415814109) * (t9 * t13 + t12 * t10);
    const prt_real t62 = t61 + PRT__R(0.15607834722743986722) * (t16 * t20 + t19 * t17);
    const prt_real t63 = (t26 * t59 + t25 * t60) + PRT__R(0.218509686118415814109) * (t14 - t11);
    const prt_real t64 = t63 + PRT__R(0.15607834722743986722) * (t21 - t18);
    out[0] = t28;
    out[2] = t35;
    out[1] = t42;
    out[3] = t43;
    out[6] = t48;
    out[5] = t56;
    out[7] = t58;
    out[4] = t62;
    out[8] = t64;
}

/* product, 3 bands: 97 multiplications, 65 additions (44 can fuse), 18 loads, 9 stores */
PRT__STATIC void prt__sh_product_3_v(const prt_real *f, const prt_real *g, prt_real *out, size_t stride) {
    const prt__vec t1 = prt__vec_load(f + 2 * stride);
    const prt__vec t2 = prt__vec_load(g + 2 * stride);
    const prt__vec t3 = t1 * t2;
    const prt__vec t4 = prt__vec_load(f + 6 * stride);
    const prt__vec t5 = prt__vec_load(g + 6 * stride);
    const prt__vec t6 = t4 * t5;
    const prt__vec t7 = prt__vec_load(f);
    const prt__vec t8 = prt__vec_load(g);
    const prt__vec t9 = prt__vec_load(f + stride);
    const prt__vec t10 = prt__vec_load(g + stride);
    const prt__vec t11 = t9 * t10;
    const prt__vec t12 = prt__vec_load(f + 3 * stride);
    const prt__vec t13 = prt__vec_load(g + 3 * stride);
    const prt__vec t14 = t12 * t13;
    const prt__vec t15 = t11 + t14;
    const prt__vec t16 = prt__vec_load(f + 5 * stride);
    const prt__vec t17 = prt__vec_load(g + 5 * stride);
    const prt__vec t18 = t16 * t17;
    const prt__vec t19 = prt__vec_load(f + 7 * stride);
    const prt__vec t20 = prt__vec_load(g + 7 * stride);
    const prt__vec t21 = t19 * t20;
    const prt__vec t22 = t18 + t21;
    const prt__vec t23 = prt__vec_load(f + 4 * stride);
    const prt__vec t24 = prt__vec_load(g + 4 * stride);
    const prt__vec t25 = prt__vec_load(f + 8 * stride);
    const prt__vec t26 = prt__vec_load(g + 8 * stride);
    const prt__vec t27 = t23 * t24 + t25 * t26;
    const prt__vec t28 = PRT__R(0.282094791773878143474) * (((((t3 + t6) + t7 * t8) + t15) + t22) + t27);
    const prt__vec t29 = PRT__R(0.282094791773878143474) * t7 + PRT__R(0.252313252202016004825) * t4;
    const prt__vec t30 = PRT__R(0.282094791773878143474) * t8 + PRT__R(0.252313252202016004825) * t5;
    const prt__vec t31 = PRT__R(0.218509686118415814109) * t16;
    const prt__vec t32 = PRT__R(0.218509686118415814109) * t19;
    const prt__vec t33 = PRT__R(0.218509686118415814109) * t17;
    const prt__vec t34 = PRT__R(0.218509686118415814109) * t20;
    const prt__vec t35 = (t2 * t29 + t1 * t30) + ((t10 * t31 + t13 * t32) + (t9 * t33 + t12 * t34));
    const prt__vec t36 = PRT__R(0.282094791773878143474) * t7 + PRT__R(-0.126156626101008002412) * t4;
    const prt__vec t37 = PRT__R(0.282094791773878143474) * t8 + PRT__R(-0.126156626101008002412) * t5;
    const prt__vec t38 = PRT__R(0.218509686118415814109) * t23;
    const prt__vec t39 = PRT__R(0.218509686118415814109) * t25;
    const prt__vec t40 = PRT__R(0.218509686118415814109) * t24;
    const prt__vec t41 = PRT__R(0.218509686118415814109) * t26;
    const prt__vec t42 = ((t10 * t36 + t9 * t37) + (t2 * t31 + t1 * t33)) + ((t13 * t38 - t10 * t39) + (t12 * t40 - t9 * t41));
    const prt__vec t43 = ((t13 * t36 + t12 * t37) + (t2 * t32 + t1 * t34)) + ((t10 * t38 + t13 * t39) + (t9 * t40 + t12 * t41));
    const prt__vec t44 = PRT__R(0.252313252202016004825) * t3 + PRT__R(0.180223751572868574875) * t6;
    const prt__vec t45 = PRT__R(0.282094791773878143474) * t7;
    const prt__vec t46 = PRT__R(0.282094791773878143474) * t8;
    const prt__vec t47 = (t44 + (t5 * t45 + t4 * t46)) + PRT__R(-0.126156626101008002412) * t15;
    const prt__vec t48 = (t47 + PRT__R(0.0901118757864342874374) * t22) + PRT__R(-0.180223751572868574875) * t27;
    const prt__vec t49 = t45 + PRT__R(0.0901118757864342874374) * t4;
    const prt__vec t50 = t46 + PRT__R(0.0901118757864342874374) * t5;
    const prt__vec t51 = (t17 * t49 + t16 * t50) + PRT__R(0.218509686118415814109) * (t2 * t9 + t1 * t10);
    const prt__vec t52 = PRT__R(0.15607834722743986722) * t23;
    const prt__vec t53 = PRT__R(0.15607834722743986722) * t25;
    const prt__vec t54 = PRT__R(0.15607834722743986722) * t24;
    const prt__vec t55 = PRT__R(0.15607834722743986722) * t26;
    const prt__vec t56 = t51 + ((t20 * t52 - t17 * t53) + (t19 * t54 - t16 * t55));
    const prt__vec t57 = (t20 * t49 + t19 * t50) + PRT__R(0.218509686118415814109) * (t2 * t12 + t1 * t13);
    const prt__vec t58 = t57 + ((t17 * t52 + t20 * t53) + (t16 * t54 + t19 * t55));
    const prt__vec t59 = PRT__R(0.282094791773878143474) * t7 + PRT__R(-0.180223751572868574875) * t4;
    const prt__vec t60 = PRT__R(0.282094791773878143474) * t8 + PRT__R(-0.180223751572868574875) * t5;
    const prt__vec t61 = (t24 * t59 + t23 * t60) + PRT__R(0.218509686118415814109) * (t9 * t13 + t12 * t10);
    const prt__vec t62 = t61 + PRT__R(0.15607834722743986722) * (t16 * t20 + t19 * t17);
    const prt__vec t63 = (t26 * t59 + t25 * t60) + PRT__R(0.218509686118415814109) * (t14 - t11);
    const prt__vec t64 = t63 + PRT__R(0.15607834722743986722) * (t21 - t18);
    prt__vec_store(out, t28);
    prt__vec_store(out + 2 * stride, t35);
    prt__vec_store(out + stride, t42);
    prt__vec_store(out + 3 * stride, t43);
    prt__vec_store(out + 6 * stride, t48);
    prt__vec_store(out + 5 * stride, t56);
    prt__vec_store(out + 7 * stride, t58);
    prt__vec_store(out + 4 * stride, t62);
    prt__vec_store(out + 8 * stride, t64);
}

/* product, 4 bands: 364 multiplications, 274 additions (173 can fuse), 32 loads, 16 stores */
PRT__STATIC void prt__sh_product_4(const prt_real *f, const prt_real *g, prt_real *out) {
    const prt_real t1 = f[2];
    const prt_real t2 = g[2];
    const prt_real t3 = t1 * t2;
    const prt_real t4 = f[6];
    const prt_real t5 = g[6];
    const prt_real t6 = t4 * t5;
    const prt_real t7 = f[12];
    const prt_real t8 = g[12];
    const prt_real t9 = t7 * t8;
    const prt_real t10 = f[0];
    const prt_real t11 = g[0];
    const prt_real t12 = f[1];
    const prt_real t13 = g[1];
    const prt_real t14 = t12 * t13;
    const prt_real t15 = f[3];
    const prt_real t16 = g[3];
    const prt_real t17 = t15 * t16;
    const prt_real t18 = t14 + t17;
    const prt_real t19 = f[5];
    const prt_real t20 = g[5];
    const prt_real t21 = t19 * t20;
    const prt_real t22 = f[7];
    const prt_real t23 = g[7];
    const prt_real t24 = t22 * t23;
    const prt_real t25 = t21 + t24;
    const prt_real t26 = f[4];
    const prt_real t27 = g[4];
    const prt_real t28 = f[8];
    const prt_real t29 = g[8];
    const prt_real t30 = t26 * t27 + t28 * t29;
    const prt_real t31 = f[11];
    const prt_real t32 = g[11];
    const prt_real t33 = t31 * t32;
    const prt_real t34 = f[13];
    const prt_real t35 = g[13];
    const prt_real t36 = t34 * t35;
    const prt_real t37 = t33 + t36;
    const prt_real t38 = ((((((t3 + t6) + t9) + t10 * t11) + t18) + t25) + t30) + t37;
    const prt_real t39 = f[9];
    const prt_real t40 = g[9];
    const prt_real t41 = f[15];
    const prt_real t42 = g[15];
    const prt_real t43 = t39 * t40 + t41 * t42;
    const prt_real t44 = f[10];
    const prt_real t45 = g[10];
    const prt_real t46 = f[14];
    const prt_real t47 = g[14];
    const prt_real t48 = PRT__R(0.282094791773878143474) * ((t38 + t43) + (t44 * t45 + t46 * t47));
    const prt_real t49 = PRT__R(0.282094791773878143474) * t10 + PRT__R(0.252313252202016004825) * t4;
    const prt_real t50 = PRT__R(0.282094791773878143474) * t11 + PRT__R(0.252313252202016004825) * t5;
    const prt_real t51 = PRT__R(0.247766695083476061891) * t7;
    const prt_real t52 = PRT__R(0.247766695083476061891) * t8;
    const prt_real t53 = PRT__R(0.218509686118415814109) * t12 + PRT__R(0.233596680327607397348) * t31;
    const prt_real t54 = PRT__R(0.218509686118415814109) * t15 + PRT__R(0.233596680327607397348) * t34;
    const prt_real t55 = PRT__R(0.218509686118415814109) * t13 + PRT__R(0.233596680327607397348) * t32;
    const prt_real t56 = PRT__R(0.218509686118415814109) * t16 + PRT__R(0.233596680327607397348) * t35;
    const prt_real t57 = ((t2 * t49 + t1 * t50) + (t5 * t51 + t4 * t52)) + ((t20 * t53 + t23 * t54) + (t19 * t55 + t22 * t56));
    const prt_real t58 = PRT__R(0.184674390922371801719) * t44;
    const prt_real t59 = PRT__R(0.184674390922371801719) * t46;
    const prt_real t60 = PRT__R(0.184674390922371801719) * t45;
    const prt_real t61 = PRT__R(0.184674390922371801719) * t47;
    const prt_real t62 = t57 + ((t27 * t58 + t29 * t59) + (t26 * t60 + t28 * t61));
    const prt_real t63 = PRT__R(0.282094791773878143474) * t10 + PRT__R(-0.126156626101008002412) * t4;
    const prt_real t64 = PRT__R(0.282094791773878143474) * t11 + PRT__R(-0.126156626101008002412) * t5;
    const prt_real t65 = t2 * t19 + t1 * t20;
    const prt_real t66 = (t13 * t63 + t12 * t64) + PRT__R(0.218509686118415814109) * t65;
    const prt_real t67 = t20 * t7 + t19 * t8;
    const prt_real t68 = PRT__R(0.218509686118415814109) * t26;
    const prt_real t69 = PRT__R(0.218509686118415814109) * t28;
    const prt_real t70 = PRT__R(0.218509686118415814109) * t27;
    const prt_real t71 = PRT__R(0.218509686118415814109) * t29;
    const prt_real t72 = (t66 + PRT__R(-0.143048168102668830763) * t67) + ((t16 * t68 - t13 * t69) + (t15 * t70 - t12 * t71));
    const prt_real t73 = PRT__R(0.202300659403420632118) * t31;
    const prt_real t74 = PRT__R(0.202300659403420632118) * t32;
    const prt_real t75 = t23 * t44;
    const prt_real t76 = t20 * t46;
    const prt_real t77 = t22 * t45;
    const prt_real t78 = t19 * t47;
    const prt_real t79 = (t75 - t76) + (t77 - t78);
    const prt_real t80 = (t72 + (t5 * t73 + t4 * t74)) + PRT__R(0.184674390922371801719) * t79;
    const prt_real t81 = (t29 * t39 - t27 * t41) + (t28 * t40 - t26 * t42);
    const prt_real t82 = PRT__R(-0.0583991700819018493369) * t34;
    const prt_real t83 = PRT__R(-0.0583991700819018493369) * t31;
    const prt_real t84 = PRT__R(-0.0583991700819018493369) * t35;
    const prt_real t85 = PRT__R(-0.0583991700819018493369) * t32;
    const prt_real t86 = (t80 + PRT__R(0.226179013159540292444) * t81) + ((t27 * t82 - t29 * t83) + (t26 * t84 - t28 * t85));
    const prt_real t87 = t2 * t22 + t1 * t23;
    const prt_real t88 = (t16 * t63 + t15 * t64) + PRT__R(0.218509686118415814109) * t87;
    const prt_real t89 = t23 * t7 + t22 * t8;
    const prt_real t90 = (t88 + PRT__R(-0.143048168102668830763) * t89) + ((t13 * t68 + t16 * t69) + (t12 * t70 + t15 * t71));
    const prt_real t91 = PRT__R(0.202300659403420632118) * t34;
    const prt_real t92 = PRT__R(0.202300659403420632118) * t35;
    const prt_real t93 = t20 * t44;
    const prt_real t94 = t23 * t46;
    const prt_real t95 = t19 * t45;
    const prt_real t96 = t22 * t47;
    const prt_real t97 = (t93 + t94) + (t95 + t96);
    const prt_real t98 = (t90 + (t5 * t91 + t4 * t92)) + PRT__R(0.184674390922371801719) * t97;
    const prt_real t99 = (t27 * t39 + t29 * t41) + (t26 * t40 + t28 * t42);
    const prt_real t100 = (t98 + PRT__R(0.226179013159540292444) * t99) + ((t27 * t83 + t29 * t82) + (t26 * t85 + t28 * t84));
    const prt_real t101 = PRT__R(0.252313252202016004825) * t3 + PRT__R(0.180223751572868574875) * t6;
    const prt_real t102 = PRT__R(0.282094791773878143474) * t10;
    const prt_real t103 = PRT__R(0.282094791773878143474) * t11;
    const prt_real t104 = (t101 + (t5 * t102 + t4 * t103)) + PRT__R(0.168208834801344003216) * t9;
    const prt_real t105 = (t104 + PRT__R(-0.126156626101008002412) * t18) + (t2 * t51 + t1 * t52);
    const prt_real t106 = (t105 + PRT__R(0.0901118757864342874374) * t25) + PRT__R(-0.180223751572868574875) * t30;
    const prt_real t107 = (t106 + PRT__R(0.126156626101008002412) * t37) + PRT__R(-0.210261043501680004021) * t43;
    const prt_real t108 = t107 + ((t13 * t73 + t16 * t91) + (t12 * t74 + t15 * t92));
    const prt_real t109 = t102 + PRT__R(0.0901118757864342874374) * t4;
    const prt_real t110 = t103 + PRT__R(0.0901118757864342874374) * t5;
    const prt_real t111 = PRT__R(-0.143048168102668830763) * t12 + PRT__R(0.0594708038717590371513) * t31;
    const prt_real t112 = PRT__R(-0.143048168102668830763) * t13 + PRT__R(0.0594708038717590371513) * t32;
    const prt_real t113 = ((t2 * t53 + t1 * t55) + (t20 * t109 + t19 * t110)) + (t8 * t111 + t7 * t112);
    const prt_real t114 = PRT__R(0.15607834722743986722) * t26;
    const prt_real t115 = PRT__R(0.15607834722743986722) * t28;
    const prt_real t116 = PRT__R(0.15607834722743986722) * t27;
    const prt_real t117 = PRT__R(0.15607834722743986722) * t29;
    const prt_real t118 = t113 + ((t23 * t114 - t20 * t115) + (t22 * t116 - t19 * t117));
    const prt_real t119 = PRT__R(0.184674390922371801719) * t15 + PRT__R(0.115164716490445159755) * t34;
    const prt_real t120 = PRT__R(0.184674390922371801719) * t12 + PRT__R(0.115164716490445159755) * t31;
    const prt_real t121 = PRT__R(0.184674390922371801719) * t16 + PRT__R(0.115164716490445159755) * t35;
    const prt_real t122 = PRT__R(0.184674390922371801719) * t13 + PRT__R(0.115164716490445159755) * t32;
    const prt_real t123 = t118 + ((t45 * t119 - t47 * t120) + (t44 * t121 - t46 * t122));
    const prt_real t124 = PRT__R(0.148677009679397592878) * t39;
    const prt_real t125 = PRT__R(0.148677009679397592878) * t41;
    const prt_real t126 = PRT__R(0.148677009679397592878) * t40;
    const prt_real t127 = PRT__R(0.148677009679397592878) * t42;
    const prt_real t128 = t123 + ((t47 * t124 - t45 * t125) + (t46 * t126 - t44 * t127));
    const prt_real t129 = PRT__R(-0.143048168102668830763) * t15 + PRT__R(0.0594708038717590371513) * t34;
    const prt_real t130 = PRT__R(-0.143048168102668830763) * t16 + PRT__R(0.0594708038717590371513) * t35;
    const prt_real t131 = ((t2 * t54 + t1 * t56) + (t23 * t109 + t22 * t110)) + (t8 * t129 + t7 * t130);
    const prt_real t132 = t131 + ((t20 * t114 + t23 * t115) + (t19 * t116 + t22 * t117));
    const prt_real t133 = t132 + ((t45 * t120 + t47 * t119) + (t44 * t122 + t46 * t121));
    const prt_real t134 = t133 + ((t45 * t124 + t47 * t125) + (t44 * t126 + t46 * t127));
    const prt_real t135 = PRT__R(0.282094791773878143474) * t10 + PRT__R(-0.180223751572868574875) * t4;
    const prt_real t136 = PRT__R(0.282094791773878143474) * t11 + PRT__R(-0.180223751572868574875) * t5;
    const prt_real t137 = (t27 * t135 + t26 * t136) + PRT__R(0.218509686118415814109) * (t12 * t16 + t15 * t13);
    const prt_real t138 = t137 + PRT__R(0.15607834722743986722) * (t19 * t23 + t22 * t20);
    const prt_real t139 = PRT__R(-0.188063194515918762316) * t44;
    const prt_real t140 = PRT__R(-0.188063194515918762316) * t45;
    const prt_real t141 = ((t138 + (t2 * t58 + t1 * t60)) + (t8 * t139 + t7 * t140)) + PRT__R(0.145673124078943876072) * (t31 * t35 + t34 * t32);
    const prt_real t142 = PRT__R(0.226179013159540292444) * t15 + PRT__R(-0.094031597257959381158) * t34;
    const prt_real t143 = PRT__R(0.226179013159540292444) * t12 + PRT__R(-0.094031597257959381158) * t31;
    const prt_real t144 = PRT__R(0.226179013159540292444) * t16 + PRT__R(-0.094031597257959381158) * t35;
    const prt_real t145 = PRT__R(0.226179013159540292444) * t13 + PRT__R(-0.094031597257959381158) * t32;
    const prt_real t146 = t141 + ((t40 * t142 - t42 * t143) + (t39 * t144 - t41 * t145));
    const prt_real t147 = t146 + ((t16 * t83 + t13 * t82) + (t12 * t84 + t15 * t85));
    const prt_real t148 = (t29 * t135 + t28 * t136) + PRT__R(0.218509686118415814109) * (t17 - t14);
    const prt_real t149 = (t148 + PRT__R(0.15607834722743986722) * (t24 - t21)) + (t2 * t59 + t1 * t61);
    const prt_real t150 = PRT__R(-0.188063194515918762316) * t46;
    const prt_real t151 = PRT__R(-0.188063194515918762316) * t47;
    const prt_real t152 = (t149 + (t8 * t150 + t7 * t151)) + PRT__R(0.145673124078943876072) * (t36 - t33);
    const prt_real t153 = t152 + ((t40 * t143 + t42 * t142) + (t39 * t145 + t41 * t144));
    const prt_real t154 = t153 + ((t16 * t82 - t13 * t83) + (t15 * t84 - t12 * t85));
    const prt_real t155 = t8 * (t102 + PRT__R(0.168208834801344003216) * t4) + t7 * (t103 + PRT__R(0.168208834801344003216) * t5);
    const prt_real t156 = t155 + PRT__R(0.247766695083476061891) * (t2 * t4 + t1 * t5);
    const prt_real t157 = t156 + ((t20 * t111 + t23 * t129) + (t19 * t112 + t22 * t130));
    const prt_real t158 = t157 + ((t27 * t139 + t29 * t150) + (t26 * t140 + t28 * t151));
    const prt_real t159 = PRT__R(0.233596680327607397348) * t65 + PRT__R(0.0594708038717590371513) * t67;
    const prt_real t160 = PRT__R(0.282094791773878143474) * t10 + PRT__R(0.126156626101008002412) * t4;
    const prt_real t161 = PRT__R(0.282094791773878143474) * t11 + PRT__R(0.126156626101008002412) * t5;
    const prt_real t162 = (t159 + (t32 * t160 + t31 * t161)) + PRT__R(0.202300659403420632118) * (t13 * t4 + t12 * t5);
    const prt_real t163 = PRT__R(0.145673124078943876072) * t26;
    const prt_real t164 = PRT__R(0.145673124078943876072) * t28;
    const prt_real t165 = PRT__R(0.145673124078943876072) * t27;
    const prt_real t166 = PRT__R(0.145673124078943876072) * t29;
    const prt_real t167 = t162 + ((t35 * t163 - t32 * t164) + (t34 * t165 - t31 * t166));
    const prt_real t168 = (t167 + PRT__R(0.115164716490445159755) * t79) + PRT__R(-0.094031597257959381158) * t81;
    const prt_real t169 = PRT__R(-0.0583991700819018493369) * ((t16 * t26 - t13 * t28) + (t15 * t27 - t12 * t29));
    const prt_real t170 = t168 + t169;
    const prt_real t171 = PRT__R(0.233596680327607397348) * t87 + PRT__R(0.0594708038717590371513) * t89;
    const prt_real t172 = (t171 + (t35 * t160 + t34 * t161)) + PRT__R(0.202300659403420632118) * (t16 * t4 + t15 * t5);
    const prt_real t173 = t172 + ((t32 * t163 + t35 * t164) + (t31 * t165 + t34 * t166));
    const prt_real t174 = (t173 + PRT__R(0.115164716490445159755) * t97) + PRT__R(-0.094031597257959381158) * t99;
    const prt_real t175 = PRT__R(-0.0583991700819018493369) * ((t13 * t26 + t16 * t28) + (t12 * t27 + t15 * t29));
    const prt_real t176 = t174 + t175;
    const prt_real t177 = PRT__R(0.184674390922371801719) * (t2 * t26 + t1 * t27) + PRT__R(-0.188063194515918762316) * (t27 * t7 + t26 * t8);
    const prt_real t178 = t177 + ((t23 * t120 + t20 * t119) + (t19 * t121 + t22 * t122));
    const prt_real t179 = (t178 + (t45 * t102 + t44 * t103)) + ((t23 * t124 - t20 * t125) + (t22 * t126 - t19 * t127));
    const prt_real t180 = PRT__R(0.184674390922371801719) * (t2 * t28 + t1 * t29) + PRT__R(-0.188063194515918762316) * (t29 * t7 + t28 * t8);
    const prt_real t181 = t180 + ((t23 * t119 - t20 * t120) + (t22 * t121 - t19 * t122));
    const prt_real t182 = (t181 + (t47 * t102 + t46 * t103)) + ((t20 * t124 + t23 * t125) + (t19 * t126 + t22 * t127));
    const prt_real t183 = PRT__R(0.282094791773878143474) * t10 + PRT__R(-0.210261043501680004021) * t4;
    const prt_real t184 = PRT__R(0.282094791773878143474) * t11 + PRT__R(-0.210261043501680004021) * t5;
    const prt_real t185 = (t40 * t183 + t39 * t184) + ((t29 * t143 + t27 * t142) + (t26 * t144 + t28 * t145));
    const prt_real t186 = PRT__R(0.148677009679397592878) * ((t75 + t76) + (t78 + t77));
    const prt_real t187 = t185 + t186;
    const prt_real t188 = (t42 * t183 + t41 * t184) + ((t29 * t142 - t27 * t143) + (t28 * t144 - t26 * t145));
    const prt_real t189 = PRT__R(0.148677009679397592878) * ((t94 - t93) + (t96 - t95));
    const prt_real t190 = t188 + t189;
    out[0] = t48;
    out[2] = t62;
    out[1] = t86;
    out[3] = t100;
    out[6] = t108;
    out[5] = t128;
    out[7] = t134;
    out[4] = t147;
    out[8] = t154;
    out[12] = t158;
    out[11] = t170;
    out[13] = t176;
    out[10] = t179;
    out[14] = t182;
    out[9] = t187;
    out[15] = t190;
}

/* product, 4 bands: 364 multiplications, 274 additions (173 can fuse), 32 loads, 16 stores */
PRT__STATIC void prt__sh_product_4_v(const prt_real *f, const prt_real *g, prt_real *out, size_t stride) {
    const prt__vec t1 = prt__vec_load(f + 2 * stride);
    const prt__vec t2 = prt__vec_load(g + 2 * stride);
    const prt__vec t3 = t1 * t2;
    const prt__vec t4 = prt__vec_load(f + 6 * stride);
    const prt__vec t5 = prt__vec_load(g + 6 * stride);
    const prt__vec t6 = t4 * t5;
    const prt__vec t7 = prt__vec_load(f + 12 * stride);
    const prt__vec t8 = prt__vec_load(g + 12 * stride);
    const prt__vec t9 = t7 * t8;
    const prt__vec t10 = prt__vec_load(f);
    const prt__vec t11 = prt__vec_load(g);
    const prt__vec t12 = prt__vec_load(f + stride);
    const prt__vec t13 = prt__vec_load(g + stride);
    const prt__vec t14 = t12 * t13;
    const prt__vec t15 = prt__vec_load(f + 3 * stride);
    const prt__vec t16 = prt__vec_load(g + 3 * stride);
    const prt__vec t17 = t15 * t16;
    const prt__vec t18 = t14 + t17;
    const prt__vec t19 = prt__vec_load(f + 5 * stride);
    const prt__vec t20 = prt__vec_load(g + 5 * stride);
    const prt__vec t21 = t19 * t20;
    const prt__vec t22 = prt__vec_load(f + 7 * stride);
    const prt__vec t23 = prt__vec_load(g + 7 * stride);
    const prt__vec t24 = t22 * t23;
    const prt__vec t25 = t21 + t24;
    const prt__vec t26 = prt__vec_load(f + 4 * stride);
    const prt__vec t27 = prt__vec_load(g + 4 * stride);
    const prt__vec t28 = prt__vec_load(f + 8 * stride);
    const prt__vec t29 = prt__vec_load(g + 8 * stride);
    const prt__vec t30 = t26 * t27 + t28 * t29;
    const prt__vec t31 = prt__vec_load(f + 11 * stride);
    const prt__vec t32 = prt__vec_load(g + 11 * stride);
    const prt__vec t33 = t31 * t32;
    const prt__vec t34 = prt__vec_load(f + 13 * stride);
    const prt__vec t35 = prt__vec_load(g + 13 * stride);
    const prt__vec t36 = t34 * t35;
    const prt__vec t37 = t33 + t36;
    const prt__vec t38 = ((((((t3 + t6) + t9) + t10 * t11) + t18) + t25) + t30) + t37;
    const prt__vec t39 = prt__vec_load(f + 9 * stride);
    const prt__vec t40 = prt__vec_load(g + 9 * stride);
    const prt__vec t41 = prt__vec_load(f + 15 * stride);
    const prt__vec t42 = prt__vec_load(g + 15 * stride);
    const prt__vec t43 = t39 * t40 + t41 * t42;
    const prt__vec t44 = prt__vec_load(f + 10 * stride);
    const prt__vec t45 = prt__vec_load(g + 10 * stride);
    const prt__vec t46 = prt__vec_load(f + 14 * stride);
    const prt__vec t47 = prt__vec_load(g + 14 * stride);
    const prt__vec t48 = PRT__R(0.282094791773878143474) * ((t38 + t43) + (t44 * t45 + t46 * t47));
    const prt__vec t49 = PRT__R(0.282094791773878143474) * t10 + PRT__R(0.252313252202016004825) * t4;
    const prt__vec t50 = PRT__R(0.282094791773878143474) * t11 + PRT__R(0.252313252202016004825) * t5;
    const prt__vec t51 = PRT__R(0.247766695083476061891) * t7;
    const prt__vec t52 = PRT__R(0.247766695083476061891) * t8;
    const prt__vec t53 = PRT__R(0.218509686118415814109) * t12 + PRT__R(0.233596680327607397348) * t31;
    const prt__vec t54 = PRT__R(0.218509686118415814109) * t15 + PRT__R(0.233596680327607397348) * t34;
    const prt__vec t55 = PRT__R(0.218509686118415814109) * t13 + PRT__R(0.233596680327607397348) * t32;
    const prt__vec t56 = PRT__R(0.218509686118415814109) * t16 + PRT__R(0.233596680327607397348) * t35;
    const prt__vec t57 = ((t2 * t49 + t1 * t50) + (t5 * t51 + t4 * t52)) + ((t20 * t53 + t23 * t54) + (t19 * t55 + t22 * t56));
    const prt__vec t58 = PRT__R(0.184674390922371801719) * t44;
    const prt__vec t59 = PRT__R(0.184674390922371801719) * t46;
    const prt__vec t60 = PRT__R(0.184674390922371801719) * t45;
    const prt__vec t61 = PRT__R(0.184674390922371801719) * t47;
    const prt__vec t62 = t57 + ((t27 * t58 + t29 * t59) + (t26 * t60 + t28 * t61));
    const prt__vec t63 = PRT__R(0.282094791773878143474) * t10 + PRT__R(-0.126156626101008002412) * t4;
    const prt__vec t64 = PRT__R(0.282094791773878143474) * t11 + PRT__R(-0.126156626101008002412) * t5;
    const prt__vec t65 = t2 * t19 + t1 * t20;
    const prt__vec t66 = (t13 * t63 + t12 * t64) + PRT__R(0.218509686118415814109) * t65;
    const prt__vec t67 = t20 * t7 + t19 * t8;
    const prt__vec t68 = PRT__R(0.218509686118415814109) * t26;
    const prt__vec t69 = PRT__R(0.218509686118415814109) * t28;
    const prt__vec t70 = PRT__R(0.218509686118415814109) * t27;
    const prt__vec t71 = PRT__R(0.218509686118415814109) * t29;
    const prt__vec t72 = (t66 + PRT__R(-0.143048168102668830763) * t67) + ((t16 * t68 - t13 * t69) + (t15 * t70 - t12 * t71));
    const prt__vec t73 = PRT__R(0.202300659403420632118) * t31;
    const prt__vec t74 = PRT__R(0.202300659403420632118) * t32;
    const prt__vec t75 = t23 * t44;
    const prt__vec t76 = t20 * t46;
    const prt__vec t77 = t22 * t45;
    const prt__vec t78 = t19 * t47;
    const prt__vec t79 = (t75 - t76) + (t77 - t78);
    const prt__vec t80 = (t72 + (t5 * t73 + t4 * t74)) + PRT__R(0.184674390922371801719) * t79;
    const prt__vec t81 = (t29 * t39 - t27 * t41) + (t28 * t40 - t26 * t42);
    const prt__vec t82 = PRT__R(-0.0583991700819018493369) * t34;
    const prt__vec t83 = PRT__R(-0.0583991700819018493369) * t31;
    const prt__vec t84 = PRT__R(-0.0583991700819018493369) * t35;
    const prt__vec t85 = PRT__R(-0.0583991700819018493369) * t32;
    const prt__vec t86 = (t80 + PRT__R(0.226179013159540292444) * t81) + ((t27 * t82 - t29 * t83) + (t26 * t84 - t28 * t85));
    const prt__vec t87 = t2 * t22 + t1 * t23;
    const prt__vec t88 = (t16 * t63 + t15 * t64) + PRT__R(0.218509686118415814109) * t87;
    const prt__vec t89 = t23 * t7 + t22 * t8;
    const prt__vec t90 = (t88 + PRT__R(-0.143048168102668830763) * t89) + ((t13 * t68 + t16 * t69) + (t12 * t70 + t15 * t71));
    const prt__vec t91 = PRT__R(0.202300659403420632118) * t34;
    const prt__vec t92 = PRT__R(0.202300659403420632118) * t35;
    const prt__vec t93 = t20 * t44;
    const prt__vec t94 = t23 * t46;
    const prt__vec t95 = t19 * t45;
    const prt__vec t96 = t22 * t47;
    const prt__vec t97 = (t93 + t94) + (t95 + t96);
    const prt__vec t98 = (t90 + (t5 * t91 + t4 * t92)) + PRT__R(0.184674390922371801719) * t97;
    const prt__vec t99 = (t27 * t39 + t29 * t41) + (t26 * t40 + t28 * t42);
    const prt__vec t100 = (t98 + PRT__R(0.226179013159540292444) * t99) + ((t27 * t83 + t29 * t82) + (t26 * t85 + t28 * t84));
    const prt__vec t101 = PRT__R(0.252313252202016004825) * t3 + PRT__R(0.180223751572868574875) * t6;
    const prt__vec t102 = PRT__R(0.282094791773878143474) * t10;
    const prt__vec t103 = PRT__R(0.282094791773878143474) * t11;
    const prt__vec t104 = (t101 + (t5 * t102 + t4 * t103)) + PRT__R(0.168208834801344003216) * t9;
    const prt__vec t105 = (t104 + PRT__R(-0.126156626101008002412) * t18) + (t2 * t51 + t1 * t52);
    const prt__vec t106 = (t105 + PRT__R(0.0901118757864342874374) * t25) + PRT__R(-0.180223751572868574875) * t30;
    const prt__vec t107 = (t106 + PRT__R(0.126156626101008002412) * t37) + PRT__R(-0.210261043501680004021) * t43;
    const prt__vec t108 = t107 + ((t13 * t73 + t16 * t91) + (t12 * t74 + t15 * t92));
    const prt__vec t109 = t102 + PRT__R(0.0901118757864342874374) * t4;
    const prt__vec t110 = t103 + PRT__R(0.0901118757864342874374) * t5;
    const prt__vec t111 = PRT__R(-0.143048168102668830763) * t12 + PRT__R(0.0594708038717590371513) * t31;
    const prt__vec t112 = PRT__R(-0.143048168102668830763) * t13 + PRT__R(0.0594708038717590371513) * t32;
    const prt__vec t113 = ((t2 * t53 + t1 * t55) + (t20 * t109 + t19 * t110)) + (t8 * t111 + t7 * t112);
    const prt__vec t114 = PRT__R(0.15607834722743986722) * t26;
    const prt__vec t115 = PRT__R(0.15607834722743986722) * t28;
    const prt__vec t116 = PRT__R(0.15607834722743986722) * t27;
    const prt__vec t117 = PRT__R(0.15607834722743986722) * t29;
    const prt__vec t118 = t113 + ((t23 * t114 - t20 * t115) + (t22 * t116 - t19 * t117));
    const prt__vec t119 = PRT__R(0.184674390922371801719) * t15 + PRT__R(0.115164716490445159755) * t34;
    const prt__vec t120 = PRT__R(0.184674390922371801719) * t12 + PRT__R(0.115164716490445159755) * t31;
    const prt__vec t121 = PRT__R(0.184674390922371801719) * t16 + PRT__R(0.115164716490445159755) * t35;
    const prt__vec t122 = PRT__R(0.184674390922371801719) * t13 + PRT__R(0.115164716490445159755) * t32;
    const prt__vec t123 = t118 + ((t45 * t119 - t47 * t120) + (t44 * t121 - t46 * t122));
    const prt__vec t124 = PRT__R(0.148677009679397592878) * t39;
    const prt__vec t125 = PRT__R(0.148677009679397592878) * t41;
    const prt__vec t126 = PRT__R(0.148677009679397592878) * t40;
    const prt__vec t127 = PRT__R(0.148677009679397592878) * t42;
    const prt__vec t128 = t123 + ((t47 * t124 - t45 * t125) + (t46 * t126 - t44 * t127));
    const prt__vec t129 = PRT__R(-0.143048168102668830763) * t15 + PRT__R(0.0594708038717590371513) * t34;
    const prt__vec t130 = PRT__R(-0.143048168102668830763) * t16 + PRT__R(0.0594708038717590371513) * t35;
    const prt__vec t131 = ((t2 * t54 + t1 * t56) + (t23 * t109 + t22 * t110)) + (t8 * t129 + t7 * t130);
    const prt__vec t132 = t131 + ((t20 * t114 + t23 * t115) + (t19 * t116 + t22 * t117));
    const prt__vec t133 = t132 + ((t45 * t120 + t47 * t119) + (t44 * t122 + t46 * t121));
    const prt__vec t134 = t133 + ((t45 * t124 + t47 * t125) + (t44 * t126 + t46 * t127));
    const prt__vec t135 = PRT__R(0.282094791773878143474) * t10 + PRT__R(-0.180223751572868574875) * t4;
    const prt__vec t136 = PRT__R(0.282094791773878143474) * t11 + PRT__R(-0.180223751572868574875) * t5;
    const prt__vec t137 = (t27 * t135 + t26 * t136) + PRT__R(0.218509686118415814109) * (t12 * t16 + t15 * t13);
    const prt__vec t138 = t137 + PRT__R(0.15607834722743986722) * (t19 * t23 + t22 * t20);
    const prt__vec t139 = PRT__R(-0.188063194515918762316) * t44;
    const prt__vec t140 = PRT__R(-0.188063194515918762316) * t45;
    const prt__vec t141 = ((t138 + (t2 * t58 + t1 * t60)) + (t8 * t139 + t7 * t140)) + PRT__R(0.145673124078943876072) * (t31 * t35 + t34 * t32);
    const prt__vec t142 = PRT__R(0.226179013159540292444) * t15 + PRT__R(-0.094031597257959381158) * t34;
    const prt__vec t143 = PRT__R(0.226179013159540292444) * t12 + PRT__R(-0.094031597257959381158) * t31;
    const prt__vec t144 = PRT__R(0.226179013159540292444) * t16 + PRT__R(-0.094031597257959381158) * t35;
    const prt__vec t145 = PRT__R(0.226179013159540292444) * t13 + PRT__R(-0.094031597257959381158) * t32;
    const prt__vec t146 = t141 + ((t40 * t142 - t42 * t143) + (t39 * t144 - t41 * t145));
    const prt__vec t147 = t146 + ((t16 * t83 + t13 * t82) + (t12 * t84 + t15 * t85));
    const prt__vec t148 = (t29 * t135 + t28 * t136) + PRT__R(0.218509686118415814109) * (t17 - t14);
    const prt__vec t149 = (t148 + PRT__R(0.15607834722743986722) * (t24 - t21)) + (t2 * t59 + t1 * t61);
    const prt__vec t150 = PRT__R(-0.188063194515918762316) * t46;
    const prt__vec t151 = PRT__R(-0.188063194515918762316) * t47;
    const prt__vec t152 = (t149 + (t8 * t150 + t7 * t151)) + PRT__R(0.145673124078943876072) * (t36 - t33);
    const prt__vec t153 = t152 + ((t40 * t143 + t42 * t142) + (t39 * t145 + t41 * t144));
    const prt__vec t154 = t153 + ((t16 * t82 - t13 * t83) + (t15 * t84 - t12 * t85));
    const prt__vec t155 = t8 * (t102 + PRT__R(0.168208834801344003216) * t4) + t7 * (t103 + PRT__R(0.168208834801344003216) * t5);
    const prt__vec t156 = t155 + PRT__R(0.247766695083476061891) * (t2 * t4 + t1 * t5);
    const prt__vec t157 = t156 + ((t20 * t111 + t23 * t129) + (t19 * t112 + t22 * t130));
    const prt__vec t158 = t157 + ((t27 * t139 + t29 * t150) + (t26 * t140 + t28 * t151));
    const prt__vec t159 = PRT__R(0.233596680327607397348) * t65 + PRT__R(0.0594708038717590371513) * t67;
    const prt__vec t160 = PRT__R(0.282094791773878143474) * t10 + PRT__R(0.126156626101008002412) * t4;
    const prt__vec t161 = PRT__R(0.282094791773878143474) * t11 + PRT__R(0.126156626101008002412) * t5;
    const prt__vec t162 = (t159 + (t32 * t160 + t31 * t161)) + PRT__R(0.202300659403420632118) * (t13 * t4 + t12 * t5);
    const prt__vec t163 = PRT__R(0.145673124078943876072) * t26;
    const prt__vec t164 = PRT__R(0.145673124078943876072) * t28;
    const prt__vec t165 = PRT__R(0.145673124078943876072) * t27;
    const prt__vec t166 = PRT__R(0.145673124078943876072) * t29;
    const prt__vec t167 = t162 + ((t35 * t163 - t32 * t164) + (t34 * t165 - t31 * t166));
    const prt__vec t168 = (t167 + PRT__R(0.115164716490445159755) * t79) + PRT__R(-0.094031597257959381158) * t81;
    const prt__vec t169 = PRT__R(-0.0583991700819018493369) * ((t16 * t26 - t13 * t28) + (t15 * t27 - t12 * t29));
    const prt__vec t170 = t168 + t169;
    const prt__vec t171 = PRT__R(0.233596680327607397348) * t87 + PRT__R(0.0594708038717590371513) * t89;
    const prt__vec t172 = (t171 + (t35 * t160 + t34 * t161)) + PRT__R(0.202300659403420632118) * (t16 * t4 + t15 * t5);
    const prt__vec t173 = t172 + ((t32 * t163 + t35 * t164) + (t31 * t165 + t34 * t166));
    const prt__vec t174 = (t173 + PRT__R(0.115164716490445159755) * t97) + PRT__R(-0.094031597257959381158) * t99;
    const prt__vec t175 = PRT__R(-0.0583991700819018493369) * ((t13 * t26 + t16 * t28) + (t12 * t27 + t15 * t29));
    const prt__vec t176 = t174 + t175;
    const prt__vec t177 = PRT__R(0.184674390922371801719) * (t2 * t26 + t1 * t27) + PRT__R(-0.188063194515918762316) * (t27 * t7 + t26 * t8);
    const prt__vec t178 = t177 + ((t23 * t120 + t20 * t119) + (t19 * t121 + t22 * t122));
    const prt__vec t179 = (t178 + (t45 * t102 + t44 * t103)) + ((t23 * t124 - t20 * t125) + (t22 * t126 - t19 * t127));
    const prt__vec t180 = PRT__R(0.184674390922371801719) * (t2 * t28 + t1 * t29) + PRT__R(-0.188063194515918762316) * (t29 * t7 + t28 * t8);
    const prt__vec t181 = t180 + ((t23 * t119 - t20 * t120) + (t22 * t121 - t19 * t122));
    const prt__vec t182 = (t181 + (t47 * t102 + t46 * t103)) + ((t20 * t124 + t23 * t125) + (t19 * t126 + t22 * t127));
    const prt__vec t183 = PRT__R(0.282094791773878143474) * t10 + PRT__R(-0.210261043501680004021) * t4;
    const prt__vec t184 = PRT__R(0.282094791773878143474) * t11 + PRT__R(-0.210261043501680004021) * t5;
    const prt__vec t185 = (t40 * t183 + t39 * t184) + ((t29 * t143 + t27 * t142) + (t26 * t144 + t28 * t145));
    const prt__vec t186 = PRT__R(0.148677009679397592878) * ((t75 + t76) + (t78 + t77));
    const prt__vec t187 = t185 + t186;
    const prt__vec t188 = (t42 * t183 + t41 * t184) + ((t29 * t142 - t27 * t143) + (t28 * t144 - t26 * t145));
    const prt__vec t189 = PRT__R(0.148677009679397592878) * ((t94 - t93) + (t96 - t95));
    const prt__vec t190 = t188 + t189;
    prt__vec_store(out, t48);
    prt__vec_store(out + 2 * stride, t62);
    prt__vec_store(out + stride, t86);
    prt__vec_store(out + 3 * stride, t100);
    prt__vec_store(out + 6 * stride, t108);
    prt__vec_store(out + 5 * stride, t128);
    prt__vec_store(out + 7 * stride, t134);
    prt__vec_store(out + 4 * stride, t147);
    prt__vec_store(out + 8 * stride, t154);
    prt__vec_store(out + 12 * stride, t158);
    prt__vec_store(out + 11 * stride, t170);
    prt__vec_store(out + 13 * stride, t176);
    prt__vec_store(out + 10 * stride, t179);
    prt__vec_store(out + 14 * stride, t182);
    prt__vec_store(out + 9 * stride, t187);
    prt__vec_store(out + 15 * stride, t190);
}

/* END GENERATED */

/* BEGIN GENERATED: prt_codegen --lang c --emit sh_square --bands 1-5 */
/* square, 1 band: 2 multiplications, 0 additions (0 can fuse), 1 loads, 1 stores */
PRT__STATIC void prt__sh_square_1(const prt_real *f, prt_real *out) {
    const prt_real t1 = f[0];
    const prt_real t2 = PRT__R(0.282094791773878143474) * (t1 * t1);
    out[0] = t2;
}

/* square, 2 bands: 10 multiplications, 6 additions (2 can fuse), 4 loads, 4 stores */
PRT__STATIC void prt__sh_square_2(const prt_real *f, prt_real *out) {
    const prt_real t1 = f[0];
    const prt_real t2 = f[2];
    const prt_real t3 = f[1];
    const prt_real t4 = f[3];
    const prt_real t5 = PRT__R(0.282094791773878143474) * ((t1 * t1 + t2 * t2) + (t3 * t3 + t4 * t4));
    const prt_real t6 = t2 * (PRT__R(0.282094791773878143474) * t1);
    const prt_real t7 = t6 + t6;
    const prt_real t8 = PRT__R(0.282094791773878143474) * t1;
    const prt_real t9 = t3 * t8;
    const prt_real t10 = t9 + t9;
    const prt_real t11 = t4 * t8;
    const prt_real t12 = t11 + t11;
    out[0] = t5;
    out[2] = t7;
    out[1] = t10;
    out[3] = t12;
}

/* square, 3 bands: 59 multiplications, 56 additions (21 can fuse), 9 loads, 9 stores */
PRT__STATIC void prt__sh_square_3(const prt_real *f, prt_real *out) {
    const prt_real t1 = f[2];
    const prt_real t2 = t1 * t1;
    const prt_real t3 = f[6];
    const prt_real t4 = t3 * t3;
    const prt_real t5 = f[0];
    const prt_real t6 = f[1];
    const prt_real t7 = t6 * t6;
    const prt_real t8 = f[3];
    const prt_real t9 = t8 * t8;
    const prt_real t10 = t7 + t9;
    const prt_real t11 = f[5];
    const prt_real t12 = t11 * t11;
    const prt_real t13 = f[7];
    const prt_real t14 = t13 * t13;
    const prt_real t15 = t12 + t14;
    const prt_real t16 = f[4];
    const prt_real t17 = f[8];
    const prt_real t18 = t16 * t16 + t17 * t17;
    const prt_real t19 = PRT__R(0.282094791773878143474) * (((((t2 + t4) + t5 * t5) + t10) + t15) + t18);
    const prt_real t20 = PRT__R(0.282094791773878143474) * t5 + PRT__R(0.252313252202016004825) * t3;
    const prt_real t21 = t1 * t20;
    const prt_real t22 = PRT__R(0.218509686118415814109) * t11;
    const prt_real t23 = PRT__R(0.218509686118415814109) * t13;
    const prt_real t24 = t6 * t22 + t8 * t23;
    const prt_real t25 = (t21 + t21) + (t24 + t24);
    const prt_real t26 = PRT__R(0.282094791773878143474) * t5 + PRT__R(-0.126156626101008002412) * t3;
    const prt_real t27 = t6 * t26;
    const prt_real t28 = t1 * t22;
    const prt_real t29 = PRT__R(0.218509686118415814109) * t16;
    const prt_real t30 = PRT__R(0.218509686118415814109) * t17;
    const prt_real t31 = t8 * t29 - t6 * t30;
    const prt_real t32 = ((t27 + t27) + (t28 + t28)) + (t31 + t31);
    const prt_real t33 = t8 * t26;
    const prt_real t34 = t1 * t23;
    const prt_real t35 = t6 * t29 + t8 * t30;
    const prt_real t36 = ((t33 + t33) + (t34 + t34)) + (t35 + t35);
    const prt_real t37 = PRT__R(0.252313252202016004825) * t2 + PRT__R(0.180223751572868574875) * t4;
    const prt_real t38 = PRT__R(0.282094791773878143474) * t5;
    const prt_real t39 = t3 * t38;
    const prt_real t40 = (t37 + (t39 + t39)) + PRT__R(-0.126156626101008002412) * t10;
    const prt_real t41 = (t40 + PRT__R(0.0901118757864342874374) * t15) + PRT__R(-0.180223751572868574875) * t18;
    const prt_real t42 = t38 + PRT__R(0.0901118757864342874374) * t3;
    const prt_real t43 = t11 * t42;
    const prt_real t44 = t1 * t6;
    const prt_real t45 = (t43 + t43) + PRT__R(0.218509686118415814109) * (t44 + t44);
    const prt_real t46 = PRT__R(0.15607834722743986722) * t16;
    const prt_real t47 = PRT__R(0.15607834722743986722) * t17;
    const prt_real t48 = t13 * t46 - t11 * t47;
    const prt_real t49 = t45 + (t48 + t48);
    const prt_real t50 = t13 * t42;
    const prt_real t51 = t1 * t8;
    const prt_real t52 = (t50 + t50) + PRT__R(0.218509686118415814109) * (t51 + t51);
    const prt_real t53 = t11 * t46 + t13 * t47;
    const prt_real t54 = t52 + (t53 + t53);
    const prt_real t55 = PRT__R(0.282094791773878143474) * t5 + PRT__R(-0.180223751572868574875) * t3;
    const prt_real t56 = t16 * t55;
    const prt_real t57 = t8 * t6;
    const prt_real t58 = (t56 + t56) + PRT__R(0.218509686118415814109) * (t57 + t57);
    const prt_real t59 = t13 * t11;
    const prt_real t60 = t58 + PRT__R(0.15607834722743986722) * (t59 + t59);
    const prt_real t61 = t17 * t55;
    const prt_real t62 = ((t61 + t61) + PRT__R(0.218509686118415814109) * (t9 - t7)) + PRT__R(0.15607834722743986722) * (t14 - t12);
    out[0] = t19;
    out[2] = t25;
    out[1] = t32;
    out[3] = t36;
    out[6] = t41;
    out[5] = t49;
    out[7] = t54;
    out[4] = t60;
    out[8] = t62;
}

/* square, 4 bands: 211 multiplications, 224 additions (86 can fuse), 16 loads, 16 stores */
PRT__STATIC void prt__sh_square_4(const prt_real *f, prt_real *out) {
    const prt_real t1 = f[2];
    const prt_real t2 = t1 * t1;
    const prt_real t3 = f[6];
    const prt_real t4 = t3 * t3;
    const prt_real t5 = f[12];
    const prt_real t6 = t5 * t5;
    const prt_real t7 = f[0];
    const prt_real t8 = f[1];
    const prt_real t9 = t8 * t8;
    const prt_real t10 = f[3];
    const prt_real t11 = t10 * t10;
    const prt_real t12 = t9 + t11;
    const prt_real t13 = f[5];
    const prt_real t14 = t13 * t13;
    const prt_real t15 = f[7];
    const prt_real t16 = t15 * t15;
    const prt_real t17 = t14 + t16;
    const prt_real t18 = f[4];
    const prt_real t19 = f[8];
    const prt_real t20 = t18 * t18 + t19 * t19;
    const prt_real t21 = f[11];
    const prt_real t22 = t21 * t21;
    const prt_real t23 = f[13];
    const prt_real t24 = t23 * t23;
    const prt_real t25 = t22 + t24;
    const prt_real t26 = f[9];
    const prt_real t27 = f[15];
    const prt_real t28 = t26 * t26 + t27 * t27;
    const prt_real t29 = (((((((t2 + t4) + t6) + t7 * t7) + t12) + t17) + t20) + t25) + t28;
    const prt_real t30 = f[10];
    const prt_real t31 = f[14];
    const prt_real t32 = PRT__R(0.282094791773878143474) * (t29 + (t30 * t30 + t31 * t31));
    const prt_real t33 = PRT__R(0.282094791773878143474) * t7 + PRT__R(0.252313252202016004825) * t3;
    const prt_real t34 = t1 * t33;
    const prt_real t35 = PRT__R(0.247766695083476061891) * t5;
    const prt_real t36 = t3 * t35;
    const prt_real t37 = PRT__R(0.218509686118415814109) * t8 + PRT__R(0.233596680327607397348) * t21;
    const prt_real t38 = PRT__R(0.218509686118415814109) * t10 + PRT__R(0.233596680327607397348) * t23;
    const prt_real t39 = t13 * t37 + t15 * t38;
    const prt_real t40 = PRT__R(0.184674390922371801719) * t30;
    const prt_real t41 = PRT__R(0.184674390922371801719) * t31;
    const prt_real t42 = t18 * t40 + t19 * t41;
    const prt_real t43 = (((t34 + t34) + (t36 + t36)) + (t39 + t39)) + (t42 + t42);
    const prt_real t44 = PRT__R(0.282094791773878143474) * t7 + PRT__R(-0.126156626101008002412) * t3;
    const prt_real t45 = t8 * t44;
    const prt_real t46 = t1 * t13;
    const prt_real t47 = t46 + t46;
    const prt_real t48 = t13 * t5;
    const prt_real t49 = t48 + t48;
    const prt_real t50 = ((t45 + t45) + PRT__R(0.218509686118415814109) * t47) + PRT__R(-0.143048168102668830763) * t49;
    const prt_real t51 = PRT__R(0.218509686118415814109) * t18;
    const prt_real t52 = PRT__R(0.218509686118415814109) * t19;
    const prt_real t53 = t10 * t51 - t8 * t52;
    const prt_real t54 = PRT__R(0.202300659403420632118) * t21;
    const prt_real t55 = t3 * t54;
    const prt_real t56 = t15 * t30;
    const prt_real t57 = t13 * t31;
    const prt_real t58 = t56 - t57;
    const prt_real t59 = t58 + t58;
    const prt_real t60 = ((t50 + (t53 + t53)) + (t55 + t55)) + PRT__R(0.184674390922371801719) * t59;
    const prt_real t61 = t19 * t26 - t18 * t27;
    const prt_real t62 = t61 + t61;
    const prt_real t63 = PRT__R(-0.0583991700819018493369) * t23;
    const prt_real t64 = PRT__R(-0.0583991700819018493369) * t21;
    const prt_real t65 = t18 * t63 - t19 * t64;
    const prt_real t66 = (t60 + PRT__R(0.226179013159540292444) * t62) + (t65 + t65);
    const prt_real t67 = t10 * t44;
    const prt_real t68 = t1 * t15;
    const prt_real t69 = t68 + t68;
    const prt_real t70 = t15 * t5;
    const prt_real t71 = t70 + t70;
    const prt_real t72 = ((t67 + t67) + PRT__R(0.218509686118415814109) * t69) + PRT__R(-0.143048168102668830763) * t71;
    const prt_real t73 = t8 * t51 + t10 * t52;
    const prt_real t74 = PRT__R(0.202300659403420632118) * t23;
    const prt_real t75 = t3 * t74;
    const prt_real t76 = t13 * t30;
    const prt_real t77 = t15 * t31;
    const prt_real t78 = t76 + t77;
    const prt_real t79 = t78 + t78;
    const prt_real t80 = ((t72 + (t73 + t73)) + (t75 + t75)) + PRT__R(0.184674390922371801719) * t79;
    const prt_real t81 = t18 * t26 + t19 * t27;
    const prt_real t82 = t81 + t81;
    const prt_real t83 = t18 * t64 + t19 * t63;
    const prt_real t84 = (t80 + PRT__R(0.226179013159540292444) * t82) + (t83 + t83);
    const prt_real t85 = PRT__R(0.252313252202016004825) * t2 + PRT__R(0.180223751572868574875) * t4;
    const prt_real t86 = PRT__R(0.282094791773878143474) * t7;
    const prt_real t87 = t3 * t86;
    const prt_real t88 = ((t85 + (t87 + t87)) + PRT__R(0.168208834801344003216) * t6) + PRT__R(-0.126156626101008002412) * t12;
    const prt_real t89 = t1 * t35;
    const prt_real t90 = (t88 + (t89 + t89)) + PRT__R(0.0901118757864342874374) * t17;
    const prt_real t91 = (t90 + PRT__R(-0.180223751572868574875) * t20) + PRT__R(0.126156626101008002412) * t25;
    const prt_real t92 = t8 * t54 + t10 * t74;
    const prt_real t93 = (t91 + PRT__R(-0.210261043501680004021) * t28) + (t92 + t92);
    const prt_real t94 = t1 * t37;
    const prt_real t95 = t86 + PRT__R(0.0901118757864342874374) * t3;
    const prt_real t96 = t13 * t95;
    const prt_real t97 = PRT__R(-0.143048168102668830763) * t8 + PRT__R(0.0594708038717590371513) * t21;
    const prt_real t98 = t5 * t97;
    const prt_real t99 = PRT__R(0.15607834722743986722) * t18;
    const prt_real t100 = PRT__R(0.15607834722743986722) * t19;
    const prt_real t101 = t15 * t99 - t13 * t100;
    const prt_real t102 = (((t94 + t94) + (t96 + t96)) + (t98 + t98)) + (t101 + t101);
    const prt_real t103 = PRT__R(0.184674390922371801719) * t10 + PRT__R(0.115164716490445159755) * t23;
    const prt_real t104 = PRT__R(0.184674390922371801719) * t8 + PRT__R(0.115164716490445159755) * t21;
    const prt_real t105 = t30 * t103 - t31 * t104;
    const prt_real t106 = PRT__R(0.148677009679397592878) * t26;
    const prt_real t107 = PRT__R(0.148677009679397592878) * t27;
    const prt_real t108 = t31 * t106 - t30 * t107;
    const prt_real t109 = (t102 + (t105 + t105)) + (t108 + t108);
    const prt_real t110 = t1 * t38;
    const prt_real t111 = t15 * t95;
    const prt_real t112 = PRT__R(-0.143048168102668830763) * t10 + PRT__R(0.0594708038717590371513) * t23;
    const prt_real t113 = t5 * t112;
    const prt_real t114 = t13 * t99 + t15 * t100;
    const prt_real t115 = (((t110 + t110) + (t111 + t111)) + (t113 + t113)) + (t114 + t114);
    const prt_real t116 = t30 * t104 + t31 * t103;
    const prt_real t117 = t30 * t106 + t31 * t107;
    const prt_real t118 = (t115 + (t116 + t116)) + (t117 + t117);
    const prt_real t119 = PRT__R(0.282094791773878143474) * t7 + PRT__R(-0.180223751572868574875) * t3;
    const prt_real t120 = t18 * t119;
    const prt_real t121 = t10 * t8;
    const prt_real t122 = (t120 + t120) + PRT__R(0.218509686118415814109) * (t121 + t121);
    const prt_real t123 = t15 * t13;
    const prt_real t124 = t1 * t40;
    const prt_real t125 = (t122 + PRT__R(0.15607834722743986722) * (t123 + t123)) + (t124 + t124);
    const prt_real t126 = PRT__R(-0.188063194515918762316) * t30;
    const prt_real t127 = t5 * t126;
    const prt_real t128 = t23 * t21;
    const prt_real t129 = (t125 + (t127 + t127)) + PRT__R(0.145673124078943876072) * (t128 + t128);
    const prt_real t130 = PRT__R(0.226179013159540292444) * t10 + PRT__R(-0.094031597257959381158) * t23;
    const prt_real t131 = PRT__R(0.226179013159540292444) * t8 + PRT__R(-0.094031597257959381158) * t21;
    const prt_real t132 = t26 * t130 - t27 * t131;
    const prt_real t133 = t10 * t64 + t8 * t63;
    const prt_real t134 = (t129 + (t132 + t132)) + (t133 + t133);
    const prt_real t135 = t19 * t119;
    const prt_real t136 = (t135 + t135) + PRT__R(0.218509686118415814109) * (t11 - t9);
    const prt_real t137 = t1 * t41;
    const prt_real t138 = (t136 + PRT__R(0.15607834722743986722) * (t16 - t14)) + (t137 + t137);
    const prt_real t139 = PRT__R(-0.188063194515918762316) * t31;
    const prt_real t140 = t5 * t139;
    const prt_real t141 = (t138 + (t140 + t140)) + PRT__R(0.145673124078943876072) * (t24 - t22);
    const prt_real t142 = t26 * t131 + t27 * t130;
    const prt_real t143 = t10 * t63 - t8 * t64;
    const prt_real t144 = (t141 + (t142 + t142)) + (t143 + t143);
    const prt_real t145 = t5 * (t86 + PRT__R(0.168208834801344003216) * t3);
    const prt_real t146 = t1 * t3;
    const prt_real t147 = (t145 + t145) + PRT__R(0.247766695083476061891) * (t146 + t146);
    const prt_real t148 = t13 * t97 + t15 * t112;
    const prt_real t149 = t18 * t126 + t19 * t139;
    const prt_real t150 = (t147 + (t148 + t148)) + (t149 + t149);
    const prt_real t151 = PRT__R(0.233596680327607397348) * t47 + PRT__R(0.0594708038717590371513) * t49;
    const prt_real t152 = PRT__R(0.282094791773878143474) * t7 + PRT__R(0.126156626101008002412) * t3;
    const prt_real t153 = t21 * t152;
    const prt_real t154 = t8 * t3;
    const prt_real t155 = (t151 + (t153 + t153)) + PRT__R(0.202300659403420632118) * (t154 + t154);
    const prt_real t156 = PRT__R(0.145673124078943876072) * t18;
    const prt_real t157 = PRT__R(0.145673124078943876072) * t19;
    const prt_real t158 = t23 * t156 - t21 * t157;
    const prt_real t159 = (t155 + (t158 + t158)) + PRT__R(0.115164716490445159755) * t59;
    const prt_real t160 = t10 * t18 - t8 * t19;
    const prt_real t161 = (t159 + PRT__R(-0.094031597257959381158) * t62) + PRT__R(-0.0583991700819018493369) * (t160 + t160);
    const prt_real t162 = PRT__R(0.233596680327607397348) * t69 + PRT__R(0.0594708038717590371513) * t71;
    const prt_real t163 = t23 * t152;
    const prt_real t164 = t10 * t3;
    const prt_real t165 = (t162 + (t163 + t163)) + PRT__R(0.202300659403420632118) * (t164 + t164);
    const prt_real t166 = t21 * t156 + t23 * t157;
    const prt_real t167 = (t165 + (t166 + t166)) + PRT__R(0.115164716490445159755) * t79;
    const prt_real t168 = t8 * t18 + t10 * t19;
    const prt_real t169 = (t167 + PRT__R(-0.094031597257959381158) * t82) + PRT__R(-0.0583991700819018493369) * (t168 + t168);
    const prt_real t170 = t1 * t18;
    const prt_real t171 = t18 * t5;
    const prt_real t172 = PRT__R(0.184674390922371801719) * (t170 + t170) + PRT__R(-0.188063194515918762316) * (t171 + t171);
    const prt_real t173 = t15 * t104 + t13 * t103;
    const prt_real t174 = t30 * t86;
    const prt_real t175 = t15 * t106 - t13 * t107;
    const prt_real t176 = ((t172 + (t173 + t173)) + (t174 + t174)) + (t175 + t175);
    const prt_real t177 = t1 * t19;
    const prt_real t178 = t19 * t5;
    const prt_real t179 = PRT__R(0.184674390922371801719) * (t177 + t177) + PRT__R(-0.188063194515918762316) * (t178 + t178);
    const prt_real t180 = t15 * t103 - t13 * t104;
    const prt_real t181 = t31 * t86;
    const prt_real t182 = t13 * t106 + t15 * t107;
    const prt_real t183 = ((t179 + (t180 + t180)) + (t181 + t181)) + (t182 + t182);
    const prt_real t184 = PRT__R(0.282094791773878143474) * t7 + PRT__R(-0.210261043501680004021) * t3;
    const prt_real t185 = t26 * t184;
    const prt_real t186 = t19 * t131 + t18 * t130;
    const prt_real t187 = t56 + t57;
    const prt_real t188 = ((t185 + t185) + (t186 + t186)) + PRT__R(0.148677009679397592878) * (t187 + t187);
    const prt_real t189 = t27 * t184;
    const prt_real t190 = t19 * t130 - t18 * t131;
    const prt_real t191 = t77 - t76;
    const prt_real t192 = ((t189 + t189) + (t190 + t190)) + PRT__R(0.148677009679397592878) * (t191 + t191);
    out[0] = t32;
    out[2] = t43;
    out[1] = t66;
    out[3] = t84;
    out[6] = t93;
    out[5] = t109;
    out[7] = t118;
    out[4] = t134;
    out[8] = t144;
    out[12] = t150;
    out[11] = t161;
    out[13] = t169;
    out[10] = t176;
    out[14] = t183;
    out[9] = t188;
    out[15] = t192;
}

/* square, 5 bands: 603 multiplications, 642 additions (308 can fuse), 25 loads, 25 stores */
PRT__STATIC void prt__sh_square_5(const prt_real *f, prt_real *out) {
    const prt_real t1 = f[6];
    const prt_real t2 = t1 * t1;
    const prt_real t3 = f[12];
    const prt_real t4 = t3 * t3;
    const prt_real t5 = f[20];
    const prt_real t6 = t5 * t5;
    const prt_real t7 = f[2];
    const prt_real t8 = t7 * t7;
    const prt_real t9 = f[0];
    const prt_real t10 = f[5];
    const prt_real t11 = t10 * t10;
    const prt_real t12 = f[7];
    const prt_real t13 = t12 * t12;
    const prt_real t14 = t11 + t13;
    const prt_real t15 = f[4];
    const prt_real t16 = t15 * t15;
    const prt_real t17 = f[8];
    const prt_real t18 = t17 * t17;
    const prt_real t19 = t16 + t18;
    const prt_real t20 = f[11];
    const prt_real t21 = t20 * t20;
    const prt_real t22 = f[13];
    const prt_real t23 = t22 * t22;
    const prt_real t24 = t21 + t23;
    const prt_real t25 = f[9];
    const prt_real t26 = f[15];
    const prt_real t27 = t25 * t25 + t26 * t26;
    const prt_real t28 = (((((((t2 + t4) + t6) + t8) + t9 * t9) + t14) + t19) + t24) + t27;
    const prt_real t29 = f[19];
    const prt_real t30 = t29 * t29;
    const prt_real t31 = f[21];
    const prt_real t32 = t31 * t31;
    const prt_real t33 = t30 + t32;
    const prt_real t34 = f[18];
    const prt_real t35 = t34 * t34;
    const prt_real t36 = f[22];
    const prt_real t37 = t36 * t36;
    const prt_real t38 = t35 + t37;
    const prt_real t39 = f[17];
    const prt_real t40 = f[23];
    const prt_real t41 = t39 * t39 + t40 * t40;
    const prt_real t42 = f[16];
    const prt_real t43 = f[24];
    const prt_real t44 = t42 * t42 + t43 * t43;
    const prt_real t45 = f[1];
    const prt_real t46 = t45 * t45;
    const prt_real t47 = f[3];
    const prt_real t48 = t47 * t47;
    const prt_real t49 = t46 + t48;
    const prt_real t50 = f[10];
    const prt_real t51 = t50 * t50;
    const prt_real t52 = f[14];
    const prt_real t53 = t52 * t52;
    const prt_real t54 = t51 + t53;
    const prt_real t55 = PRT__R(0.282094791773878143474) * ((((((t28 + t33) + t38) + t41) + t44) + t49) + t54);
    const prt_real t56 = PRT__R(0.282094791773878143474) * t9;
    const prt_real t57 = t7 * (t56 + PRT__R(0.252313252202016004825) * t1);
    const prt_real t58 = PRT__R(0.247766695083476061891) * t1 + PRT__R(0.246232521229829068958) * t5;
    const prt_real t59 = t3 * t58;
    const prt_real t60 = PRT__R(0.218509686118415814109) * t45 + PRT__R(0.233596680327607397348) * t20;
    const prt_real t61 = PRT__R(0.218509686118415814109) * t47 + PRT__R(0.233596680327607397348) * t22;
    const prt_real t62 = t10 * t60 + t12 * t61;
    const prt_real t63 = PRT__R(0.184674390922371801719) * t15 + PRT__R(0.213243618622923080808) * t34;
    const prt_real t64 = PRT__R(0.184674390922371801719) * t17 + PRT__R(0.213243618622923080808) * t36;
    const prt_real t65 = t50 * t63 + t52 * t64;
    const prt_real t66 = PRT__R(0.238413613504448051271) * t29;
    const prt_real t67 = PRT__R(0.238413613504448051271) * t31;
    const prt_real t68 = t20 * t66 + t22 * t67;
    const prt_real t69 = ((((t57 + t57) + (t59 + t59)) + (t62 + t62)) + (t65 + t65)) + (t68 + t68);
    const prt_real t70 = PRT__R(0.162867503967639973862) * t39;
    const prt_real t71 = PRT__R(0.162867503967639973862) * t40;
    const prt_real t72 = t25 * t70 + t26 * t71;
    const prt_real t73 = t69 + (t72 + t72);
    const prt_real t74 = PRT__R(0.282094791773878143474) * t9 + PRT__R(-0.126156626101008002412) * t1;
    const prt_real t75 = t45 * t74;
    const prt_real t76 = t7 * t10;
    const prt_real t77 = t76 + t76;
    const prt_real t78 = PRT__R(-0.143048168102668830763) * t10 + PRT__R(0.194663900273006164456) * t29;
    const prt_real t79 = t3 * t78;
    const prt_real t80 = ((t75 + t75) + PRT__R(0.218509686118415814109) * t77) + (t79 + t79);
    const prt_real t81 = PRT__R(0.218509686118415814109) * t15;
    const prt_real t82 = PRT__R(0.218509686118415814109) * t17;
    const prt_real t83 = t47 * t81 - t45 * t82;
    const prt_real t84 = PRT__R(0.202300659403420632118) * t20;
    const prt_real t85 = t1 * t84;
    const prt_real t86 = PRT__R(-0.0583991700819018493369) * t15 + PRT__R(0.168583882836183860099) * t34;
    const prt_real t87 = PRT__R(-0.0583991700819018493369) * t17 + PRT__R(0.168583882836183860099) * t36;
    const prt_real t88 = t22 * t86 - t20 * t87;
    const prt_real t89 = PRT__R(0.184674390922371801719) * t12 + PRT__R(-0.0753930043865134308146) * t31;
    const prt_real t90 = PRT__R(0.184674390922371801719) * t10 + PRT__R(-0.0753930043865134308146) * t29;
    const prt_real t91 = t50 * t89 - t52 * t90;
    const prt_real t92 = (((t80 + (t83 + t83)) + (t85 + t85)) + (t88 + t88)) + (t91 + t91);
    const prt_real t93 = PRT__R(0.226179013159540292444) * t17 + PRT__R(-0.0435281713775681653484) * t36;
    const prt_real t94 = PRT__R(0.226179013159540292444) * t15 + PRT__R(-0.0435281713775681653484) * t34;
    const prt_real t95 = t25 * t93 - t26 * t94;
    const prt_real t96 = PRT__R(-0.150786008773026861629) * t20;
    const prt_real t97 = t5 * t96;
    const prt_real t98 = t52 * t39 - t50 * t40;
    const prt_real t99 = t98 + t98;
    const prt_real t100 = ((t92 + (t95 + t95)) + (t97 + t97)) + PRT__R(0.19947114020071633897) * t99;
    const prt_real t101 = t26 * t42 - t25 * t43;
    const prt_real t102 = t101 + t101;
    const prt_real t103 = t100 + PRT__R(0.23032943298089031951) * t102;
    const prt_real t104 = t47 * t74;
    const prt_real t105 = t7 * t12;
    const prt_real t106 = t105 + t105;
    const prt_real t107 = PRT__R(-0.143048168102668830763) * t12 + PRT__R(0.194663900273006164456) * t31;
    const prt_real t108 = t3 * t107;
    const prt_real t109 = ((t104 + t104) + PRT__R(0.218509686118415814109) * t106) + (t108 + t108);
    const prt_real t110 = t45 * t81 + t47 * t82;
    const prt_real t111 = PRT__R(0.202300659403420632118) * t22;
    const prt_real t112 = t1 * t111;
    const prt_real t113 = t20 * t86 + t22 * t87;
    const prt_real t114 = t50 * t90 + t52 * t89;
    const prt_real t115 = (((t109 + (t110 + t110)) + (t112 + t112)) + (t113 + t113)) + (t114 + t114);
    const prt_real t116 = t25 * t94 + t26 * t93;
    const prt_real t117 = PRT__R(-0.150786008773026861629) * t22;
    const prt_real t118 = t5 * t117;
    const prt_real t119 = t50 * t39 + t52 * t40;
    const prt_real t120 = t119 + t119;
    const prt_real t121 = ((t115 + (t116 + t116)) + (t118 + t118)) + PRT__R(0.19947114020071633897) * t120;
    const prt_real t122 = t25 * t42 + t26 * t43;
    const prt_real t123 = t122 + t122;
    const prt_real t124 = t121 + PRT__R(0.23032943298089031951) * t123;
    const prt_real t125 = PRT__R(0.282094791773878143474) * t9;
    const prt_real t126 = t1 * (t125 + PRT__R(0.241795535806181265835) * t5);
    const prt_real t127 = (PRT__R(0.180223751572868574875) * t2 + (t126 + t126)) + PRT__R(0.168208834801344003216) * t4;
    const prt_real t128 = (t127 + PRT__R(0.163839774157153249886) * t6) + PRT__R(0.252313252202016004825) * t8;
    const prt_real t129 = t7 * t3;
    const prt_real t130 = t129 + t129;
    const prt_real t131 = (t128 + PRT__R(0.247766695083476061891) * t130) + PRT__R(0.0901118757864342874374) * t14;
    const prt_real t132 = (t131 + PRT__R(-0.180223751572868574875) * t19) + PRT__R(0.126156626101008002412) * t24;
    const prt_real t133 = (t132 + PRT__R(-0.210261043501680004021) * t27) + PRT__R(0.139263808033580262403) * t33;
    const prt_real t134 = (t133 + PRT__R(0.0655359096628612999545) * t38) + PRT__R(-0.0573439209550036374602) * t41;
    const prt_real t135 = (t134 + PRT__R(-0.229375683820014549841) * t44) + PRT__R(-0.126156626101008002412) * t49;
    const prt_real t136 = t45 * t84 + t47 * t111;
    const prt_real t137 = PRT__R(0.220728115441822617338) * t29;
    const prt_real t138 = PRT__R(0.220728115441822617338) * t31;
    const prt_real t139 = t10 * t137 + t12 * t138;
    const prt_real t140 = PRT__R(0.15607834722743986722) * t34;
    const prt_real t141 = PRT__R(0.15607834722743986722) * t36;
    const prt_real t142 = t15 * t140 + t17 * t141;
    const prt_real t143 = ((t135 + (t136 + t136)) + (t139 + t139)) + (t142 + t142);
    const prt_real t144 = (t125 + PRT__R(0.0901118757864342874374) * t1) + PRT__R(-0.161197023870787510557) * t5;
    const prt_real t145 = t10 * t144;
    const prt_real t146 = t7 * t60;
    const prt_real t147 = PRT__R(0.15607834722743986722) * t15 + PRT__R(0.180223751572868574875) * t34;
    const prt_real t148 = PRT__R(0.15607834722743986722) * t17 + PRT__R(0.180223751572868574875) * t36;
    const prt_real t149 = t12 * t147 - t10 * t148;
    const prt_real t150 = t45 * t3;
    const prt_real t151 = t150 + t150;
    const prt_real t152 = (((t145 + t145) + (t146 + t146)) + (t149 + t149)) + PRT__R(-0.143048168102668830763) * t151;
    const prt_real t153 = t3 * t20;
    const prt_real t154 = t153 + t153;
    const prt_real t155 = t1 * t137;
    const prt_real t156 = (t152 + PRT__R(0.0594708038717590371513) * t154) + (t155 + t155);
    const prt_real t157 = t47 * t50 - t45 * t52;
    const prt_real t158 = t157 + t157;
    const prt_real t159 = t22 * t50 - t20 * t52;
    const prt_real t160 = t159 + t159;
    const prt_real t161 = (t156 + PRT__R(0.184674390922371801719) * t158) + PRT__R(0.115164716490445159755) * t160;
    const prt_real t162 = t52 * t25 - t50 * t26;
    const prt_real t163 = t162 + t162;
    const prt_real t164 = PRT__R(0.0448693700612123999046) * t29;
    const prt_real t165 = t5 * t164;
    const prt_real t166 = (t161 + PRT__R(0.148677009679397592878) * t163) + (t165 + t165);
    const prt_real t167 = PRT__R(-0.063718718434027539805) * t15 + PRT__R(0.0902978654080183434566) * t34;
    const prt_real t168 = PRT__R(-0.063718718434027539805) * t17 + PRT__R(0.0902978654080183434566) * t36;
    const prt_real t169 = t31 * t167 - t29 * t168;
    const prt_real t170 = PRT__R(0.168583882836183860099) * t17 + PRT__R(0.132725386549776930311) * t36;
    const prt_real t171 = PRT__R(0.168583882836183860099) * t15 + PRT__R(0.132725386549776930311) * t34;
    const prt_real t172 = t39 * t170 - t40 * t171;
    const prt_real t173 = t40 * t42 - t39 * t43;
    const prt_real t174 = t173 + t173;
    const prt_real t175 = ((t166 + (t169 + t169)) + (t172 + t172)) + PRT__R(0.140463346190250756488) * t174;
    const prt_real t176 = t12 * t144;
    const prt_real t177 = t7 * t61;
    const prt_real t178 = t10 * t147 + t12 * t148;
    const prt_real t179 = t47 * t3;
    const prt_real t180 = t179 + t179;
    const prt_real t181 = (((t176 + t176) + (t177 + t177)) + (t178 + t178)) + PRT__R(-0.143048168102668830763) * t180;
    const prt_real t182 = t3 * t22;
    const prt_real t183 = t182 + t182;
    const prt_real t184 = t1 * t138;
    const prt_real t185 = (t181 + PRT__R(0.0594708038717590371513) * t183) + (t184 + t184);
    const prt_real t186 = t45 * t50 + t47 * t52;
    const prt_real t187 = t186 + t186;
    const prt_real t188 = t20 * t50 + t22 * t52;
    const prt_real t189 = t188 + t188;
    const prt_real t190 = (t185 + PRT__R(0.184674390922371801719) * t187) + PRT__R(0.115164716490445159755) * t189;
    const prt_real t191 = t50 * t25 + t52 * t26;
    const prt_real t192 = t191 + t191;
    const prt_real t193 = PRT__R(0.0448693700612123999046) * t31;
    const prt_real t194 = t5 * t193;
    const prt_real t195 = (t190 + PRT__R(0.148677009679397592878) * t192) + (t194 + t194);
    const prt_real t196 = t29 * t167 + t31 * t168;
    const prt_real t197 = t39 * t171 + t40 * t170;
    const prt_real t198 = t39 * t42 + t40 * t43;
    const prt_real t199 = t198 + t198;
    const prt_real t200 = ((t195 + (t196 + t196)) + (t197 + t197)) + PRT__R(0.140463346190250756488) * t199;
    const prt_real t201 = PRT__R(0.282094791773878143474) * t9 + PRT__R(-0.180223751572868574875) * t1;
    const prt_real t202 = t201 + PRT__R(0.0402992559676968776391) * t5;
    const prt_real t203 = t15 * t202;
    const prt_real t204 = t12 * t10;
    const prt_real t205 = t204 + t204;
    const prt_real t206 = t22 * t20;
    const prt_real t207 = t206 + t206;
    const prt_real t208 = ((t203 + t203) + PRT__R(0.15607834722743986722) * t205) + PRT__R(0.145673124078943876072) * t207;
    const prt_real t209 = t7 * t50;
    const prt_real t210 = t209 + t209;
    const prt_real t211 = t3 * t50;
    const prt_real t212 = t211 + t211;
    const prt_real t213 = (t208 + PRT__R(0.184674390922371801719) * t210) + PRT__R(-0.188063194515918762316) * t212;
    const prt_real t214 = t31 * t29;
    const prt_real t215 = t214 + t214;
    const prt_real t216 = t47 * t45;
    const prt_real t217 = (t213 + PRT__R(0.141889406570399879291) * t215) + PRT__R(0.218509686118415814109) * (t216 + t216);
    const prt_real t218 = t1 * t140;
    const prt_real t219 = PRT__R(0.238413613504448051271) * t42;
    const prt_real t220 = PRT__R(0.238413613504448051271) * t43;
    const prt_real t221 = t17 * t219 - t15 * t220;
    const prt_real t222 = t47 * t20 + t45 * t22;
    const prt_real t223 = t222 + t222;
    const prt_real t224 = ((t217 + (t218 + t218)) + (t221 + t221)) + PRT__R(-0.0583991700819018493369) * t223;
    const prt_real t225 = t47 * t25 - t45 * t26;
    const prt_real t226 = t225 + t225;
    const prt_real t227 = t22 * t25 - t20 * t26;
    const prt_real t228 = t227 + t227;
    const prt_real t229 = (t224 + PRT__R(0.226179013159540292444) * t226) + PRT__R(-0.094031597257959381158) * t228;
    const prt_real t230 = PRT__R(-0.190364615027111657761) * t34;
    const prt_real t231 = t5 * t230;
    const prt_real t232 = t12 * t29 + t10 * t31;
    const prt_real t233 = t232 + t232;
    const prt_real t234 = (t229 + (t231 + t231)) + PRT__R(-0.063718718434027539805) * t233;
    const prt_real t235 = t12 * t39 - t10 * t40;
    const prt_real t236 = t235 + t235;
    const prt_real t237 = t31 * t39 - t29 * t40;
    const prt_real t238 = t237 + t237;
    const prt_real t239 = (t234 + PRT__R(0.168583882836183860099) * t236) + PRT__R(-0.112621225037943664496) * t238;
    const prt_real t240 = PRT__R(-0.0750808166919624429971) * t42;
    const prt_real t241 = PRT__R(-0.0750808166919624429971) * t43;
    const prt_real t242 = t36 * t240 - t34 * t241;
    const prt_real t243 = t239 + (t242 + t242);
    const prt_real t244 = t17 * t202;
    const prt_real t245 = t13 - t11;
    const prt_real t246 = t23 - t21;
    const prt_real t247 = ((t244 + t244) + PRT__R(0.15607834722743986722) * t245) + PRT__R(0.145673124078943876072) * t246;
    const prt_real t248 = t7 * t52;
    const prt_real t249 = t248 + t248;
    const prt_real t250 = t3 * t52;
    const prt_real t251 = t250 + t250;
    const prt_real t252 = (t247 + PRT__R(0.184674390922371801719) * t249) + PRT__R(-0.188063194515918762316) * t251;
    const prt_real t253 = t32 - t30;
    const prt_real t254 = (t252 + PRT__R(0.141889406570399879291) * t253) + PRT__R(0.218509686118415814109) * (t48 - t46);
    const prt_real t255 = t1 * t141;
    const prt_real t256 = t15 * t219 + t17 * t220;
    const prt_real t257 = t47 * t22 - t45 * t20;
    const prt_real t258 = t257 + t257;
    const prt_real t259 = ((t254 + (t255 + t255)) + (t256 + t256)) + PRT__R(-0.0583991700819018493369) * t258;
    const prt_real t260 = t45 * t25 + t47 * t26;
    const prt_real t261 = t260 + t260;
    const prt_real t262 = t20 * t25 + t22 * t26;
    const prt_real t263 = t262 + t262;
    const prt_real t264 = (t259 + PRT__R(0.226179013159540292444) * t261) + PRT__R(-0.094031597257959381158) * t263;
    const prt_real t265 = PRT__R(-0.190364615027111657761) * t36;
    const prt_real t266 = t5 * t265;
    const prt_real t267 = t12 * t31 - t10 * t29;
    const prt_real t268 = t267 + t267;
    const prt_real t269 = (t264 + (t266 + t266)) + PRT__R(-0.063718718434027539805) * t268;
    const prt_real t270 = t10 * t39 + t12 * t40;
    const prt_real t271 = t270 + t270;
    const prt_real t272 = t29 * t39 + t31 * t40;
    const prt_real t273 = t272 + t272;
    const prt_real t274 = (t269 + PRT__R(0.168583882836183860099) * t271) + PRT__R(-0.112621225037943664496) * t273;
    const prt_real t275 = t34 * t240 + t36 * t241;
    const prt_real t276 = t274 + (t275 + t275);
    const prt_real t277 = (t125 + PRT__R(0.168208834801344003216) * t1) + PRT__R(0.153869886422115350986) * t5;
    const prt_real t278 = t3 * t277;
    const prt_real t279 = t7 * t58;
    const prt_real t280 = t45 * t78 + t47 * t107;
    const prt_real t281 = PRT__R(0.0594708038717590371513) * t10 + PRT__R(0.0993225845992799155039) * t29;
    const prt_real t282 = PRT__R(0.0594708038717590371513) * t12 + PRT__R(0.0993225845992799155039) * t31;
    const prt_real t283 = t20 * t281 + t22 * t282;
    const prt_real t284 = (((t278 + t278) + (t279 + t279)) + (t280 + t280)) + (t283 + t283);
    const prt_real t285 = PRT__R(-0.188063194515918762316) * t15 + PRT__R(-0.0444184101729927201442) * t34;
    const prt_real t286 = PRT__R(-0.188063194515918762316) * t17 + PRT__R(-0.0444184101729927201442) * t36;
    const prt_real t287 = t50 * t285 + t52 * t286;
    const prt_real t288 = PRT__R(-0.203550726867335668044) * t39;
    const prt_real t289 = PRT__R(-0.203550726867335668044) * t40;
    const prt_real t290 = t25 * t288 + t26 * t289;
    const prt_real t291 = (t284 + (t287 + t287)) + (t290 + t290);
    const prt_real t292 = PRT__R(0.282094791773878143474) * t9 + PRT__R(0.126156626101008002412) * t1;
    const prt_real t293 = t292 + PRT__R(0.0256449810703525584976) * t5;
    const prt_real t294 = t20 * t293;
    const prt_real t295 = t3 * t281;
    const prt_real t296 = ((t294 + t294) + PRT__R(0.233596680327607397348) * t77) + (t295 + t295);
    const prt_real t297 = PRT__R(0.145673124078943876072) * t15 + PRT__R(0.11468784191000727492) * t34;
    const prt_real t298 = PRT__R(0.145673124078943876072) * t17 + PRT__R(0.11468784191000727492) * t36;
    const prt_real t299 = t22 * t297 - t20 * t298;
    const prt_real t300 = t45 * t1;
    const prt_real t301 = (t296 + (t299 + t299)) + PRT__R(0.202300659403420632118) * (t300 + t300);
    const prt_real t302 = t7 * t66;
    const prt_real t303 = t47 * t86 - t45 * t87;
    const prt_real t304 = PRT__R(0.115164716490445159755) * t12 + PRT__R(0.102579924281410233991) * t31;
    const prt_real t305 = PRT__R(0.115164716490445159755) * t10 + PRT__R(0.102579924281410233991) * t29;
    const prt_real t306 = t50 * t304 - t52 * t305;
    const prt_real t307 = PRT__R(-0.094031597257959381158) * t17 + PRT__R(0.133255230518978160433) * t36;
    const prt_real t308 = PRT__R(-0.094031597257959381158) * t15 + PRT__R(0.133255230518978160433) * t34;
    const prt_real t309 = t25 * t307 - t26 * t308;
    const prt_real t310 = (((t301 + (t302 + t302)) + (t303 + t303)) + (t306 + t306)) + (t309 + t309);
    const prt_real t311 = t45 * t5;
    const prt_real t312 = (t310 + PRT__R(-0.150786008773026861629) * (t311 + t311)) + PRT__R(0.0678502422891118893481) * t99;
    const prt_real t313 = t312 + PRT__R(-0.117520066950600237457) * t102;
    const prt_real t314 = t22 * t293;
    const prt_real t315 = t3 * t282;
    const prt_real t316 = ((t314 + t314) + PRT__R(0.233596680327607397348) * t106) + (t315 + t315);
    const prt_real t317 = t20 * t297 + t22 * t298;
    const prt_real t318 = t47 * t1;
    const prt_real t319 = (t316 + (t317 + t317)) + PRT__R(0.202300659403420632118) * (t318 + t318);
    const prt_real t320 = t7 * t67;
    const prt_real t321 = t45 * t86 + t47 * t87;
    const prt_real t322 = t50 * t305 + t52 * t304;
    const prt_real t323 = t25 * t308 + t26 * t307;
    const prt_real t324 = (((t319 + (t320 + t320)) + (t321 + t321)) + (t322 + t322)) + (t323 + t323);
    const prt_real t325 = t47 * t5;
    const prt_real t326 = (t324 + PRT__R(-0.150786008773026861629) * (t325 + t325)) + PRT__R(0.0678502422891118893481) * t120;
    const prt_real t327 = t326 + PRT__R(-0.117520066950600237457) * t123;
    const prt_real t328 = t7 * t63;
    const prt_real t329 = t3 * t285;
    const prt_real t330 = t125 + PRT__R(-0.179514867492467909483) * t5;
    const prt_real t331 = t50 * t330;
    const prt_real t332 = t47 * t90 + t45 * t89;
    const prt_real t333 = (((t328 + t328) + (t329 + t329)) + (t331 + t331)) + (t332 + t332);
    const prt_real t334 = t22 * t305 + t20 * t304;
    const prt_real t335 = PRT__R(0.151717754048285123536) * t42;
    const prt_real t336 = PRT__R(0.151717754048285123536) * t43;
    const prt_real t337 = t52 * t335 - t50 * t336;
    const prt_real t338 = PRT__R(0.148677009679397592878) * t12 + PRT__R(-0.0993225845992799155039) * t31;
    const prt_real t339 = PRT__R(0.148677009679397592878) * t10 + PRT__R(-0.0993225845992799155039) * t29;
    const prt_real t340 = t25 * t338 - t26 * t339;
    const prt_real t341 = PRT__R(0.19947114020071633897) * t47 + PRT__R(0.0678502422891118893481) * t22;
    const prt_real t342 = PRT__R(0.19947114020071633897) * t45 + PRT__R(0.0678502422891118893481) * t20;
    const prt_real t343 = t39 * t341 - t40 * t342;
    const prt_real t344 = (((t333 + (t334 + t334)) + (t337 + t337)) + (t340 + t340)) + (t343 + t343);
    const prt_real t345 = t7 * t64;
    const prt_real t346 = t3 * t286;
    const prt_real t347 = t52 * t330;
    const prt_real t348 = t47 * t89 - t45 * t90;
    const prt_real t349 = (((t345 + t345) + (t346 + t346)) + (t347 + t347)) + (t348 + t348);
    const prt_real t350 = t22 * t304 - t20 * t305;
    const prt_real t351 = t50 * t335 + t52 * t336;
    const prt_real t352 = t25 * t339 + t26 * t338;
    const prt_real t353 = t39 * t342 + t40 * t341;
    const prt_real t354 = (((t349 + (t350 + t350)) + (t351 + t351)) + (t352 + t352)) + (t353 + t353);
    const prt_real t355 = PRT__R(0.282094791773878143474) * t9;
    const prt_real t356 = (t355 + PRT__R(-0.210261043501680004021) * t1) + PRT__R(0.0769349432110576754929) * t5;
    const prt_real t357 = t25 * t356;
    const prt_real t358 = t7 * t70;
    const prt_real t359 = t47 * t94 + t45 * t93;
    const prt_real t360 = t3 * t288;
    const prt_real t361 = (((t357 + t357) + (t358 + t358)) + (t359 + t359)) + (t360 + t360);
    const prt_real t362 = t22 * t308 + t20 * t307;
    const prt_real t363 = t52 * t339 + t50 * t338;
    const prt_real t364 = PRT__R(0.23032943298089031951) * t47 + PRT__R(-0.117520066950600237457) * t22;
    const prt_real t365 = PRT__R(0.23032943298089031951) * t45 + PRT__R(-0.117520066950600237457) * t20;
    const prt_real t366 = t42 * t364 - t43 * t365;
    const prt_real t367 = ((t361 + (t362 + t362)) + (t363 + t363)) + (t366 + t366);
    const prt_real t368 = t26 * t356;
    const prt_real t369 = t7 * t71;
    const prt_real t370 = t47 * t93 - t45 * t94;
    const prt_real t371 = t3 * t289;
    const prt_real t372 = (((t368 + t368) + (t369 + t369)) + (t370 + t370)) + (t371 + t371);
    const prt_real t373 = t22 * t307 - t20 * t308;
    const prt_real t374 = t52 * t338 - t50 * t339;
    const prt_real t375 = t42 * t365 + t43 * t364;
    const prt_real t376 = ((t372 + (t373 + t373)) + (t374 + t374)) + (t375 + t375);
    const prt_real t377 = PRT__R(0.241795535806181265835) * t2 + PRT__R(0.153869886422115350986) * t4;
    const prt_real t378 = t5 * (t355 + PRT__R(0.163839774157153249886) * t1);
    const prt_real t379 = (t377 + PRT__R(0.136961107694410367361) * t6) + (t378 + t378);
    const prt_real t380 = (t379 + PRT__R(0.246232521229829068958) * t130) + PRT__R(-0.161197023870787510557) * t14;
    const prt_real t381 = (t380 + PRT__R(0.0402992559676968776391) * t19) + PRT__R(0.0256449810703525584976) * t24;
    const prt_real t382 = (t381 + PRT__R(0.0769349432110576754929) * t27) + PRT__R(0.0684805538472051836805) * t33;
    const prt_real t383 = (t382 + PRT__R(-0.0836984547021396689428) * t38) + PRT__R(-0.159787958976812095255) * t41;
    const prt_real t384 = (t383 + PRT__R(0.106525305984541396836) * t44) + PRT__R(-0.179514867492467909483) * t54;
    const prt_real t385 = t45 * t96 + t47 * t117;
    const prt_real t386 = t10 * t164 + t12 * t193;
    const prt_real t387 = t15 * t230 + t17 * t265;
    const prt_real t388 = ((t384 + (t385 + t385)) + (t386 + t386)) + (t387 + t387);
    const prt_real t389 = PRT__R(0.282094791773878143474) * t9 + PRT__R(0.139263808033580262403) * t1;
    const prt_real t390 = t389 + PRT__R(0.0684805538472051836805) * t5;
    const prt_real t391 = t29 * t390;
    const prt_real t392 = ((t391 + t391) + PRT__R(0.194663900273006164456) * t151) + PRT__R(0.0993225845992799155039) * t154;
    const prt_real t393 = PRT__R(0.141889406570399879291) * t15 + PRT__R(0.102084782359457024929) * t34;
    const prt_real t394 = PRT__R(0.141889406570399879291) * t17 + PRT__R(0.102084782359457024929) * t36;
    const prt_real t395 = t31 * t393 - t29 * t394;
    const prt_real t396 = t1 * t10;
    const prt_real t397 = (t392 + (t395 + t395)) + PRT__R(0.220728115441822617338) * (t396 + t396);
    const prt_real t398 = t7 * t20;
    const prt_real t399 = (t397 + PRT__R(0.238413613504448051271) * (t398 + t398)) + PRT__R(-0.0753930043865134308146) * t158;
    const prt_real t400 = (t399 + PRT__R(0.102579924281410233991) * t160) + PRT__R(-0.0993225845992799155039) * t163;
    const prt_real t401 = t10 * t5;
    const prt_real t402 = t12 * t167 - t10 * t168;
    const prt_real t403 = (t400 + PRT__R(0.0448693700612123999046) * (t401 + t401)) + (t402 + t402);
    const prt_real t404 = PRT__R(-0.112621225037943664496) * t17 + PRT__R(0.0450151577945461355547) * t36;
    const prt_real t405 = PRT__R(-0.112621225037943664496) * t15 + PRT__R(0.0450151577945461355547) * t34;
    const prt_real t406 = t39 * t404 - t40 * t405;
    const prt_real t407 = (t403 + (t406 + t406)) + PRT__R(-0.119098912752699862417) * t174;
    const prt_real t408 = t31 * t390;
    const prt_real t409 = ((t408 + t408) + PRT__R(0.194663900273006164456) * t180) + PRT__R(0.0993225845992799155039) * t183;
    const prt_real t410 = t29 * t393 + t31 * t394;
    const prt_real t411 = t1 * t12;
    const prt_real t412 = (t409 + (t410 + t410)) + PRT__R(0.220728115441822617338) * (t411 + t411);
    const prt_real t413 = t7 * t22;
    const prt_real t414 = (t412 + PRT__R(0.238413613504448051271) * (t413 + t413)) + PRT__R(-0.0753930043865134308146) * t187;
    const prt_real t415 = (t414 + PRT__R(0.102579924281410233991) * t189) + PRT__R(-0.0993225845992799155039) * t192;
    const prt_real t416 = t12 * t5;
    const prt_real t417 = t10 * t167 + t12 * t168;
    const prt_real t418 = (t415 + PRT__R(0.0448693700612123999046) * (t416 + t416)) + (t417 + t417);
    const prt_real t419 = t39 * t405 + t40 * t404;
    const prt_real t420 = (t418 + (t419 + t419)) + PRT__R(-0.119098912752699862417) * t199;
    const prt_real t421 = (t56 + PRT__R(0.0655359096628612999545) * t1) + PRT__R(-0.0836984547021396689428) * t5;
    const prt_real t422 = t34 * t421;
    const prt_real t423 = ((t422 + t422) + PRT__R(0.180223751572868574875) * t205) + PRT__R(0.11468784191000727492) * t207;
    const prt_real t424 = (t423 + PRT__R(0.213243618622923080808) * t210) + PRT__R(-0.0444184101729927201442) * t212;
    const prt_real t425 = t1 * t15;
    const prt_real t426 = (t424 + PRT__R(0.102084782359457024929) * t215) + PRT__R(0.15607834722743986722) * (t425 + t425);
    const prt_real t427 = (t426 + PRT__R(0.168583882836183860099) * t223) + PRT__R(-0.0435281713775681653484) * t226;
    const prt_real t428 = t15 * t5;
    const prt_real t429 = (t427 + PRT__R(0.133255230518978160433) * t228) + PRT__R(-0.190364615027111657761) * (t428 + t428);
    const prt_real t430 = PRT__R(0.135045473383638406664) * t42;
    const prt_real t431 = PRT__R(0.135045473383638406664) * t43;
    const prt_real t432 = t36 * t430 - t34 * t431;
    const prt_real t433 = (t429 + PRT__R(0.0902978654080183434566) * t233) + (t432 + t432);
    const prt_real t434 = (t433 + PRT__R(0.132725386549776930311) * t236) + PRT__R(0.0450151577945461355547) * t238;
    const prt_real t435 = t17 * t240 - t15 * t241;
    const prt_real t436 = t434 + (t435 + t435);
    const prt_real t437 = t36 * t421;
    const prt_real t438 = ((t437 + t437) + PRT__R(0.180223751572868574875) * t245) + PRT__R(0.11468784191000727492) * t246;
    const prt_real t439 = (t438 + PRT__R(0.213243618622923080808) * t249) + PRT__R(-0.0444184101729927201442) * t251;
    const prt_real t440 = t1 * t17;
    const prt_real t441 = (t439 + PRT__R(0.102084782359457024929) * t253) + PRT__R(0.15607834722743986722) * (t440 + t440);
    const prt_real t442 = (t441 + PRT__R(0.168583882836183860099) * t258) + PRT__R(-0.0435281713775681653484) * t261;
    const prt_real t443 = t17 * t5;
    const prt_real t444 = (t442 + PRT__R(0.133255230518978160433) * t263) + PRT__R(-0.190364615027111657761) * (t443 + t443);
    const prt_real t445 = t34 * t430 + t36 * t431;
    const prt_real t446 = (t444 + PRT__R(0.0902978654080183434566) * t268) + (t445 + t445);
    const prt_real t447 = (t446 + PRT__R(0.132725386549776930311) * t271) + PRT__R(0.0450151577945461355547) * t273;
    const prt_real t448 = t15 * t240 + t17 * t241;
    const prt_real t449 = t447 + (t448 + t448);
    const prt_real t450 = (t355 + PRT__R(-0.0573439209550036374602) * t1) + PRT__R(-0.159787958976812095255) * t5;
    const prt_real t451 = t39 * t450;
    const prt_real t452 = t7 * t25;
    const prt_real t453 = (t451 + t451) + PRT__R(0.162867503967639973862) * (t452 + t452);
    const prt_real t454 = t3 * t25;
    const prt_real t455 = t12 * t171 + t10 * t170;
    const prt_real t456 = (t453 + PRT__R(-0.203550726867335668044) * (t454 + t454)) + (t455 + t455);
    const prt_real t457 = t52 * t342 + t50 * t341;
    const prt_real t458 = t31 * t405 + t29 * t404;
    const prt_real t459 = PRT__R(0.140463346190250756488) * t12 + PRT__R(-0.119098912752699862417) * t31;
    const prt_real t460 = PRT__R(0.140463346190250756488) * t10 + PRT__R(-0.119098912752699862417) * t29;
    const prt_real t461 = t42 * t459 - t43 * t460;
    const prt_real t462 = ((t456 + (t457 + t457)) + (t458 + t458)) + (t461 + t461);
    const prt_real t463 = t40 * t450;
    const prt_real t464 = t7 * t26;
    const prt_real t465 = (t463 + t463) + PRT__R(0.162867503967639973862) * (t464 + t464);
    const prt_real t466 = t3 * t26;
    const prt_real t467 = t12 * t170 - t10 * t171;
    const prt_real t468 = (t465 + PRT__R(-0.203550726867335668044) * (t466 + t466)) + (t467 + t467);
    const prt_real t469 = t52 * t341 - t50 * t342;
    const prt_real t470 = t31 * t404 - t29 * t405;
    const prt_real t471 = t42 * t460 + t43 * t459;
    const prt_real t472 = ((t468 + (t469 + t469)) + (t470 + t470)) + (t471 + t471);
    const prt_real t473 = (t355 + PRT__R(-0.229375683820014549841) * t1) + PRT__R(0.106525305984541396836) * t5;
    const prt_real t474 = t42 * t473;
    const prt_real t475 = t17 * t15;
    const prt_real t476 = (t474 + t474) + PRT__R(0.238413613504448051271) * (t475 + t475);
    const prt_real t477 = t52 * t50;
    const prt_real t478 = t36 * t34;
    const prt_real t479 = (t476 + PRT__R(0.151717754048285123536) * (t477 + t477)) + PRT__R(0.135045473383638406664) * (t478 + t478);
    const prt_real t480 = t26 * t365 + t25 * t364;
    const prt_real t481 = t40 * t460 + t39 * t459;
    const prt_real t482 = t17 * t34 + t15 * t36;
    const prt_real t483 = ((t479 + (t480 + t480)) + (t481 + t481)) + PRT__R(-0.0750808166919624429971) * (t482 + t482);
    const prt_real t484 = t43 * t473;
    const prt_real t485 = (t484 + t484) + PRT__R(0.238413613504448051271) * (t18 - t16);
    const prt_real t486 = (t485 + PRT__R(0.151717754048285123536) * (t53 - t51)) + PRT__R(0.135045473383638406664) * (t37 - t35);
    const prt_real t487 = t26 * t364 - t25 * t365;
    const prt_real t488 = t40 * t459 - t39 * t460;
    const prt_real t489 = t17 * t36 - t15 * t34;
    const prt_real t490 = ((t486 + (t487 + t487)) + (t488 + t488)) + PRT__R(-0.0750808166919624429971) * (t489 + t489);
    out[0] = t55;
    out[2] = t73;
    out[1] = t103;
    out[3] = t124;
    out[6] = t143;
    out[5] = t175;
    out[7] = t200;
    out[4] = t243;
    out[8] = t276;
    out[12] = t291;
    out[11] = t313;
    out[13] = t327;
    out[10] = t344;
    out[14] = t354;
    out[9] = t367;
    out[15] = t376;
    out[20] = t388;
    out[19] = t407;
    out[21] = t420;
    out[18] = t436;
    out[22] = t449;
    out[17] = t462;
    out[23] = t472;
    out[16] = t483;
    out[24] = t490;
}

/* END GENERATED */

/* A row of the table: the factors at z and at -z, of even and of odd l-m */
#define PRT__EVEN_2(a, b) { PRT__R(a), PRT__R(b), PRT__R(a), PRT__R(b) }
#define PRT__ODD_2(a, b) { PRT__R(a), PRT__R(b), -PRT__R(a), -PRT__R(b) }
#define PRT__EVEN_4(a, b, c, d) { PRT__R(a), PRT__R(b), PRT__R(c), PRT__R(d), PRT__R(a), PRT__R(b), PRT__R(c), PRT__R(d) }
#define PRT__ODD_4(a, b, c, d) \
    { PRT__R(a), PRT__R(b), PRT__R(c), PRT__R(d), -PRT__R(a), -PRT__R(b), -PRT__R(c), -PRT__R(d) }

/* BEGIN GENERATED: prt_codegen --table nodes --bands 3-6 */
/* factors of the product of 3 bands at 2 nodes z >= 0 and their mirror images */
PRT__STATIC const prt_real *prt__nodes_3(void) {
    static const prt_real table[6][PRT__NODES] PRT__ALIGNED = {
        PRT__EVEN_2(0.4612443311955583156, 0.56873913527056539037),
        PRT__ODD_2(0.68796060780730948967, 0.33491025302237789751),
        PRT__EVEN_2(0.20306969326164291462, 0.46320290758624838539),
        PRT__EVEN_2(0.63154477904727381183, -0.41537466665206294256),
        PRT__ODD_2(0.39102274262563929193, 0.35213645000362533032),
        PRT__EVEN_2(0.11542066144803945107, 0.48702787100961098081)
    };
    return table[0];
}

/* factors of the product of 4 bands at 3 nodes z >= 0 and their mirror images */
PRT__STATIC const prt_real *prt__nodes_4(void) {
    static const prt_real table[10][PRT__NODES] PRT__ALIGNED = {
        PRT__EVEN_4(0.40582282607636473424, 0.51301641242821843398, 0.43131792572606196857, 0.0),
        PRT__ODD_4(0.63695902753877401376, 0.47846793950724826989, 0.0, 0.0),
        PRT__EVEN_4(0.14862679412767526716, 0.37437479520056099461, 0.37353228078637933392, 0.0),
        PRT__EVEN_4(0.66401818362120540867, -0.074651487769219098957, -0.4822281009188399487, 0.0),
        PRT__ODD_4(0.30115946107230313574, 0.45076746261981974013, 0.0, 0.0),
        PRT__EVEN_4(0.070271969287176961485, 0.35270069855707663133, 0.41762178581444139578, 0.0),
        PRT__ODD_4(0.53796031189611660862, -0.56651850836882865365, 0.0, 0.0),
        PRT__EVEN_4(0.43179336035756959365, 0.15749904620906224329, -0.34940745440071855347, 0.0),
        PRT__ODD_4(0.16847890965907251695, 0.50247712520109020596, 0.0, 0.0),
        PRT__EVEN_4(0.032098558307644899627, 0.32101433456783950444, 0.4510830839782367913, 0.0)
    };
    return table[0];
}

/* factors of the product of 5 bands at 4 nodes z >= 0 and their mirror images */
PRT__STATIC const prt_real *prt__nodes_5(void) {
    static const prt_real table[15][PRT__NODES] PRT__ALIGNED = {
        PRT__EVEN_4(0.33179624893936239621, 0.42890914080061222595, 0.47579702729324618685, 0.38919415997157896463),
        PRT__ODD_4(0.54544089084085419434, 0.55087789971712119173, 0.33445886643091016185, 0.0),
        PRT__EVEN_4(0.090499291474338909814, 0.24921009850636649982, 0.37659185473434657327, 0.33705202953993208157),
        PRT__EVEN_4(0.6315279122432288826, 0.31150857069164700358, -0.26910075532720584639, -0.435132299071189092),
        PRT__ODD_4(0.1920639141206893077, 0.41321878777449915057, 0.34175610900489724373, 0.0),
        PRT__EVEN_4(0.031867152678844868828, 0.18693488132096822707, 0.38480835724393667033, 0.37683562500277765093),
        PRT__ODD_4(0.626559533801297955, -0.10546162458482443452, -0.55596764567199924493, 0.0),
        PRT__EVEN_4(0.29663125934544931199, 0.40779745376704771819, -0.062157434499185836102, -0.31528330401380889242),
        PRT__ODD_4(0.08002171873595119528, 0.36674887211538420986, 0.4131938770688121575, 0.0),
        PRT__EVEN_4(0.010840760040559774135, 0.13546697862301159869, 0.37987127701066573723, 0.40702899526091062508),
        PRT__EVEN_4(0.54455417666449507247, -0.46862888588974112549, -0.17695667985554933063, 0.43784342996802633521),
        PRT__ODD_4(0.38879177604457655984, 0.21485429801130600925, -0.38654975073965934316, 0.0),
        PRT__EVEN_4(0.14642382156175198864, 0.46123849385983388719, 0.050978505034334394517, -0.326349224303391819),
        PRT__ODD_4(0.03086715339091345637, 0.30135896780366883845, 0.4625067477669564254, 0.0),
        PRT__EVEN_4(0.003621421438033654104, 0.096400527228546980025, 0.36824027348822440394, 0.43171944403280552798)
    };
    return table[0];
}

/* factors of the product of 6 bands at 4 nodes z >= 0 and their mirror images */
PRT__STATIC const prt_real *prt__nodes_6(void) {
    static const prt_real table[21][PRT__NODES] PRT__ALIGNED = {
        PRT__EVEN_4(0.3056558238406966942, 0.39734181511440479004, 0.44562847015528651133, 0.46770757286225876415),
        PRT__ODD_4(0.50838841319950142896, 0.54827878511365451833, 0.40563279580132347609, 0.14859917107325066051),
        PRT__EVEN_4(0.073854027086710089079, 0.20798553309636981161, 0.32833528412631235761, 0.39817377095134545555),
        PRT__EVEN_4(0.60366209259810296034, 0.40160886180340764496, -0.085419686597690085084, -0.47012761656491442968),
        PRT__ODD_4(0.15858478764174479458, 0.37050551162167385622, 0.38583539244723109052, 0.16331986339536869986),
        PRT__EVEN_4(0.023037750070510602667, 0.14054854654608439817, 0.31231048011018717963, 0.43761809308705195423),
        PRT__ODD_4(0.62544782959778433987, 0.072606804908664999209, -0.50160209880969184122, -0.32138900943629445639),
        PRT__EVEN_4(0.24944775635432218364, 0.42283827788088788728, 0.11699226458301942922, -0.30979471590175669865),
        PRT__ODD_4(0.05853173853378713239, 0.29624560898807197456, 0.43424525577150083048, 0.21238588329726862909),
        PRT__EVEN_4(0.0069426349751800228708, 0.09175674063232297267, 0.28699474726509460926, 0.46466106004916326828),
        PRT__EVEN_4(0.58437765181980150323, -0.28933166848361143071, -0.43712932417949650996, 0.35607381382926294609),
        PRT__ODD_4(0.33553459952227255284, 0.32734000297777263519, -0.25203681499730842197, -0.27648099632161172167),
        PRT__EVEN_4(0.10883613548154537703, 0.41904581754615780249, 0.25242588866357998339, -0.28972226617727989533),
        PRT__ODD_4(0.02000082583209120054, 0.21929855801552560928, 0.45247512349065881194, 0.25570480629530379088),
        PRT__EVEN_4(0.0020545251769475102544, 0.058823717065820541926, 0.25897879431574914796, 0.4844847983388630251),
        PRT__ODD_4(0.48948576579620284633, -0.53150483975585770605, 0.045884980083346769225, 0.45228369732524642101),
        PRT__EVEN_4(0.4072020515360987429, 0.11060239327045825875, -0.38495734562084170749, 0.20401115748847078009),
        PRT__ODD_4(0.17146046378021003248, 0.4441219911002096421, -0.12346147675286700391, -0.31664916648467748285),
        PRT__EVEN_4(0.042019261000097229581, 0.35849951941403160034, 0.35353253420506120025, -0.26860158555660766799),
        PRT__ODD_4(0.0065435006769128500861, 0.15542660104159548464, 0.45139843770912757326, 0.2947527427278786468),
        PRT__EVEN_4(0.00060119960255012263665, 0.037289540453716354348, 0.23108648281355381111, 0.4995099136844362452)
    };
    return table[0];
}

/* END GENERATED */

#undef PRT__EVEN_2
#undef PRT__ODD_2
#undef PRT__EVEN_4
#undef PRT__ODD_4

/* BEGIN GENERATED: prt_codegen --lang c --emit sh_rows,sh_terms,row_product --bands 3-6 */
/* rows of a function at z and -z, 3 bands: 9 multiplications, 7 additions (1 can fuse), 15 loads, 10 stores */
PRT__INLINE void prt__sh_rows_3(const prt_real *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q + 1 * PRT__NODES) * f[2];
    const prt__vec t2 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    plus[0] = t1 + t2;
    minus[0] = t2 - t1;
    const prt__vec t3 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t4 = t3 * f[3];
    const prt__vec t5 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t6 = t5 * f[7];
    plus[2] = t4 + t6;
    minus[2] = t4 - t6;
    const prt__vec t7 = t3 * f[1];
    const prt__vec t8 = t5 * f[5];
    plus[3] = t7 + t8;
    minus[3] = t7 - t8;
    const prt__vec t9 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t10 = t9 * f[8];
    plus[4] = t10;
    minus[4] = t10;
    const prt__vec t11 = t9 * f[4];
    plus[5] = t11;
    minus[5] = t11;
}

/* rows of a function at z and -z, 3 bands: 9 multiplications, 7 additions (1 can fuse), 15 loads, 10 stores */
PRT__INLINE void prt__sh_rows_3_v(const prt__vec *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q + 1 * PRT__NODES) * f[2];
    const prt__vec t2 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    plus[0] = t1 + t2;
    minus[0] = t2 - t1;
    const prt__vec t3 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t4 = t3 * f[3];
    const prt__vec t5 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t6 = t5 * f[7];
    plus[2] = t4 + t6;
    minus[2] = t4 - t6;
    const prt__vec t7 = t3 * f[1];
    const prt__vec t8 = t5 * f[5];
    plus[3] = t7 + t8;
    minus[3] = t7 - t8;
    const prt__vec t9 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t10 = t9 * f[8];
    plus[4] = t10;
    minus[4] = t10;
    const prt__vec t11 = t9 * f[4];
    plus[5] = t11;
    minus[5] = t11;
}

/* rows of a function at z and -z, 4 bands: 16 multiplications, 14 additions (4 can fuse), 26 loads, 14 stores */
PRT__INLINE void prt__sh_rows_4(const prt_real *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    const prt__vec t2 = prt__vec_load(q + 1 * PRT__NODES) * f[2] + prt__vec_load(q + 6 * PRT__NODES) * f[12];
    plus[0] = t1 + t2;
    minus[0] = t1 - t2;
    const prt__vec t3 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t4 = t3 * f[7];
    const prt__vec t5 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t6 = prt__vec_load(q + 7 * PRT__NODES);
    const prt__vec t7 = t5 * f[3] + t6 * f[13];
    plus[2] = t4 + t7;
    minus[2] = t7 - t4;
    const prt__vec t8 = t3 * f[5];
    const prt__vec t9 = t5 * f[1] + t6 * f[11];
    plus[3] = t8 + t9;
    minus[3] = t9 - t8;
    const prt__vec t10 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t11 = t10 * f[8];
    const prt__vec t12 = prt__vec_load(q + 8 * PRT__NODES);
    const prt__vec t13 = t12 * f[14];
    plus[4] = t11 + t13;
    minus[4] = t11 - t13;
    const prt__vec t14 = t10 * f[4];
    const prt__vec t15 = t12 * f[10];
    plus[5] = t14 + t15;
    minus[5] = t14 - t15;
    const prt__vec t16 = prt__vec_load(q + 9 * PRT__NODES);
    const prt__vec t17 = t16 * f[15];
    plus[6] = t17;
    minus[6] = t17;
    const prt__vec t18 = t16 * f[9];
    plus[7] = t18;
    minus[7] = t18;
}

/* rows of a function at z and -z, 4 bands: 16 multiplications, 14 additions (4 can fuse), 26 loads, 14 stores */
PRT__INLINE void prt__sh_rows_4_v(const prt__vec *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    const prt__vec t2 = prt__vec_load(q + 1 * PRT__NODES) * f[2] + prt__vec_load(q + 6 * PRT__NODES) * f[12];
    plus[0] = t1 + t2;
    minus[0] = t1 - t2;
    const prt__vec t3 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t4 = t3 * f[7];
    const prt__vec t5 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t6 = prt__vec_load(q + 7 * PRT__NODES);
    const prt__vec t7 = t5 * f[3] + t6 * f[13];
    plus[2] = t4 + t7;
    minus[2] = t7 - t4;
    const prt__vec t8 = t3 * f[5];
    const prt__vec t9 = t5 * f[1] + t6 * f[11];
    plus[3] = t8 + t9;
    minus[3] = t9 - t8;
    const prt__vec t10 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t11 = t10 * f[8];
    const prt__vec t12 = prt__vec_load(q + 8 * PRT__NODES);
    const prt__vec t13 = t12 * f[14];
    plus[4] = t11 + t13;
    minus[4] = t11 - t13;
    const prt__vec t14 = t10 * f[4];
    const prt__vec t15 = t12 * f[10];
    plus[5] = t14 + t15;
    minus[5] = t14 - t15;
    const prt__vec t16 = prt__vec_load(q + 9 * PRT__NODES);
    const prt__vec t17 = t16 * f[15];
    plus[6] = t17;
    minus[6] = t17;
    const prt__vec t18 = t16 * f[9];
    plus[7] = t18;
    minus[7] = t18;
}

/* rows of a function at z and -z, 5 bands: 25 multiplications, 23 additions (9 can fuse), 40 loads, 18 stores */
PRT__INLINE void prt__sh_rows_5(const prt_real *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q + 1 * PRT__NODES) * f[2] + prt__vec_load(q + 6 * PRT__NODES) * f[12];
    const prt__vec t2 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    const prt__vec t3 = t2 + prt__vec_load(q + 10 * PRT__NODES) * f[20];
    plus[0] = t1 + t3;
    minus[0] = t3 - t1;
    const prt__vec t4 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t5 = prt__vec_load(q + 7 * PRT__NODES);
    const prt__vec t6 = t4 * f[3] + t5 * f[13];
    const prt__vec t7 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t8 = prt__vec_load(q + 11 * PRT__NODES);
    const prt__vec t9 = t7 * f[7] + t8 * f[21];
    plus[2] = t6 + t9;
    minus[2] = t6 - t9;
    const prt__vec t10 = t4 * f[1] + t5 * f[11];
    const prt__vec t11 = t7 * f[5] + t8 * f[19];
    plus[3] = t10 + t11;
    minus[3] = t10 - t11;
    const prt__vec t12 = prt__vec_load(q + 8 * PRT__NODES);
    const prt__vec t13 = t12 * f[14];
    const prt__vec t14 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t15 = prt__vec_load(q + 12 * PRT__NODES);
    const prt__vec t16 = t14 * f[8] + t15 * f[22];
    plus[4] = t13 + t16;
    minus[4] = t16 - t13;
    const prt__vec t17 = t12 * f[10];
    const prt__vec t18 = t14 * f[4] + t15 * f[18];
    plus[5] = t17 + t18;
    minus[5] = t18 - t17;
    const prt__vec t19 = prt__vec_load(q + 9 * PRT__NODES);
    const prt__vec t20 = t19 * f[15];
    const prt__vec t21 = prt__vec_load(q + 13 * PRT__NODES);
    const prt__vec t22 = t21 * f[23];
    plus[6] = t20 + t22;
    minus[6] = t20 - t22;
    const prt__vec t23 = t19 * f[9];
    const prt__vec t24 = t21 * f[17];
    plus[7] = t23 + t24;
    minus[7] = t23 - t24;
    const prt__vec t25 = prt__vec_load(q + 14 * PRT__NODES);
    const prt__vec t26 = t25 * f[24];
    plus[8] = t26;
    minus[8] = t26;
    const prt__vec t27 = t25 * f[16];
    plus[9] = t27;
    minus[9] = t27;
}

/* rows of a function at z and -z, 5 bands: 25 multiplications, 23 additions (9 can fuse), 40 loads, 18 stores */
PRT__INLINE void prt__sh_rows_5_v(const prt__vec *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q + 1 * PRT__NODES) * f[2] + prt__vec_load(q + 6 * PRT__NODES) * f[12];
    const prt__vec t2 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    const prt__vec t3 = t2 + prt__vec_load(q + 10 * PRT__NODES) * f[20];
    plus[0] = t1 + t3;
    minus[0] = t3 - t1;
    const prt__vec t4 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t5 = prt__vec_load(q + 7 * PRT__NODES);
    const prt__vec t6 = t4 * f[3] + t5 * f[13];
    const prt__vec t7 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t8 = prt__vec_load(q + 11 * PRT__NODES);
    const prt__vec t9 = t7 * f[7] + t8 * f[21];
    plus[2] = t6 + t9;
    minus[2] = t6 - t9;
    const prt__vec t10 = t4 * f[1] + t5 * f[11];
    const prt__vec t11 = t7 * f[5] + t8 * f[19];
    plus[3] = t10 + t11;
    minus[3] = t10 - t11;
    const prt__vec t12 = prt__vec_load(q + 8 * PRT__NODES);
    const prt__vec t13 = t12 * f[14];
    const prt__vec t14 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t15 = prt__vec_load(q + 12 * PRT__NODES);
    const prt__vec t16 = t14 * f[8] + t15 * f[22];
    plus[4] = t13 + t16;
    minus[4] = t16 - t13;
    const prt__vec t17 = t12 * f[10];
    const prt__vec t18 = t14 * f[4] + t15 * f[18];
    plus[5] = t17 + t18;
    minus[5] = t18 - t17;
    const prt__vec t19 = prt__vec_load(q + 9 * PRT__NODES);
    const prt__vec t20 = t19 * f[15];
    const prt__vec t21 = prt__vec_load(q + 13 * PRT__NODES);
    const prt__vec t22 = t21 * f[23];
    plus[6] = t20 + t22;
    minus[6] = t20 - t22;
    const prt__vec t23 = t19 * f[9];
    const prt__vec t24 = t21 * f[17];
    plus[7] = t23 + t24;
    minus[7] = t23 - t24;
    const prt__vec t25 = prt__vec_load(q + 14 * PRT__NODES);
    const prt__vec t26 = t25 * f[24];
    plus[8] = t26;
    minus[8] = t26;
    const prt__vec t27 = t25 * f[16];
    plus[9] = t27;
    minus[9] = t27;
}

/* rows of a function at z and -z, 6 bands: 36 multiplications, 34 additions (16 can fuse), 57 loads, 22 stores */
PRT__INLINE void prt__sh_rows_6(const prt_real *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    const prt__vec t2 = t1 + prt__vec_load(q + 10 * PRT__NODES) * f[20];
    const prt__vec t3 = prt__vec_load(q + 1 * PRT__NODES) * f[2] + prt__vec_load(q + 6 * PRT__NODES) * f[12];
    const prt__vec t4 = t3 + prt__vec_load(q + 15 * PRT__NODES) * f[30];
    plus[0] = t2 + t4;
    minus[0] = t2 - t4;
    const prt__vec t5 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t6 = prt__vec_load(q + 11 * PRT__NODES);
    const prt__vec t7 = t5 * f[7] + t6 * f[21];
    const prt__vec t8 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t9 = prt__vec_load(q + 7 * PRT__NODES);
    const prt__vec t10 = prt__vec_load(q + 16 * PRT__NODES);
    const prt__vec t11 = (t8 * f[3] + t9 * f[13]) + t10 * f[31];
    plus[2] = t7 + t11;
    minus[2] = t11 - t7;
    const prt__vec t12 = t5 * f[5] + t6 * f[19];
    const prt__vec t13 = (t8 * f[1] + t9 * f[11]) + t10 * f[29];
    plus[3] = t12 + t13;
    minus[3] = t13 - t12;
    const prt__vec t14 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t15 = prt__vec_load(q + 12 * PRT__NODES);
    const prt__vec t16 = t14 * f[8] + t15 * f[22];
    const prt__vec t17 = prt__vec_load(q + 8 * PRT__NODES);
    const prt__vec t18 = prt__vec_load(q + 17 * PRT__NODES);
    const prt__vec t19 = t17 * f[14] + t18 * f[32];
    plus[4] = t16 + t19;
    minus[4] = t16 - t19;
    const prt__vec t20 = t14 * f[4] + t15 * f[18];
    const prt__vec t21 = t17 * f[10] + t18 * f[28];
    plus[5] = t20 + t21;
    minus[5] = t20 - t21;
    const prt__vec t22 = prt__vec_load(q + 13 * PRT__NODES);
    const prt__vec t23 = t22 * f[23];
    const prt__vec t24 = prt__vec_load(q + 9 * PRT__NODES);
    const prt__vec t25 = prt__vec_load(q + 18 * PRT__NODES);
    const prt__vec t26 = t24 * f[15] + t25 * f[33];
    plus[6] = t23 + t26;
    minus[6] = t26 - t23;
    const prt__vec t27 = t22 * f[17];
    const prt__vec t28 = t24 * f[9] + t25 * f[27];
    plus[7] = t27 + t28;
    minus[7] = t28 - t27;
    const prt__vec t29 = prt__vec_load(q + 14 * PRT__NODES);
    const prt__vec t30 = t29 * f[24];
    const prt__vec t31 = prt__vec_load(q + 19 * PRT__NODES);
    const prt__vec t32 = t31 * f[34];
    plus[8] = t30 + t32;
    minus[8] = t30 - t32;
    const prt__vec t33 = t29 * f[16];
    const prt__vec t34 = t31 * f[26];
    plus[9] = t33 + t34;
    minus[9] = t33 - t34;
    const prt__vec t35 = prt__vec_load(q + 20 * PRT__NODES);
    const prt__vec t36 = t35 * f[35];
    plus[10] = t36;
    minus[10] = t36;
    const prt__vec t37 = t35 * f[25];
    plus[11] = t37;
    minus[11] = t37;
}

/* rows of a function at z and -z, 6 bands: 36 multiplications, 34 additions (16 can fuse), 57 loads, 22 stores */
PRT__INLINE void prt__sh_rows_6_v(const prt__vec *f, const prt_real *q, prt__vec *PRT__RESTRICT plus, 
    prt__vec *PRT__RESTRICT minus) {
    const prt__vec t1 = prt__vec_load(q) * f[0] + prt__vec_load(q + 3 * PRT__NODES) * f[6];
    const prt__vec t2 = t1 + prt__vec_load(q + 10 * PRT__NODES) * f[20];
    const prt__vec t3 = prt__vec_load(q + 1 * PRT__NODES) * f[2] + prt__vec_load(q + 6 * PRT__NODES) * f[12];
    const prt__vec t4 = t3 + prt__vec_load(q + 15 * PRT__NODES) * f[30];
    plus[0] = t2 + t4;
    minus[0] = t2 - t4;
    const prt__vec t5 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t6 = prt__vec_load(q + 11 * PRT__NODES);
    const prt__vec t7 = t5 * f[7] + t6 * f[21];
    const prt__vec t8 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t9 = prt__vec_load(q + 7 * PRT__NODES);
    const prt__vec t10 = prt__vec_load(q + 16 * PRT__NODES);
    const prt__vec t11 = (t8 * f[3] + t9 * f[13]) + t10 * f[31];
    plus[2] = t7 + t11;
    minus[2] = t11 - t7;
    const prt__vec t12 = t5 * f[5] + t6 * f[19];
    const prt__vec t13 = (t8 * f[1] + t9 * f[11]) + t10 * f[29];
    plus[3] = t12 + t13;
    minus[3] = t13 - t12;
    const prt__vec t14 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t15 = prt__vec_load(q + 12 * PRT__NODES);
    const prt__vec t16 = t14 * f[8] + t15 * f[22];
    const prt__vec t17 = prt__vec_load(q + 8 * PRT__NODES);
    const prt__vec t18 = prt__vec_load(q + 17 * PRT__NODES);
    const prt__vec t19 = t17 * f[14] + t18 * f[32];
    plus[4] = t16 + t19;
    minus[4] = t16 - t19;
    const prt__vec t20 = t14 * f[4] + t15 * f[18];
    const prt__vec t21 = t17 * f[10] + t18 * f[28];
    plus[5] = t20 + t21;
    minus[5] = t20 - t21;
    const prt__vec t22 = prt__vec_load(q + 13 * PRT__NODES);
    const prt__vec t23 = t22 * f[23];
    const prt__vec t24 = prt__vec_load(q + 9 * PRT__NODES);
    const prt__vec t25 = prt__vec_load(q + 18 * PRT__NODES);
    const prt__vec t26 = t24 * f[15] + t25 * f[33];
    plus[6] = t23 + t26;
    minus[6] = t26 - t23;
    const prt__vec t27 = t22 * f[17];
    const prt__vec t28 = t24 * f[9] + t25 * f[27];
    plus[7] = t27 + t28;
    minus[7] = t28 - t27;
    const prt__vec t29 = prt__vec_load(q + 14 * PRT__NODES);
    const prt__vec t30 = t29 * f[24];
    const prt__vec t31 = prt__vec_load(q + 19 * PRT__NODES);
    const prt__vec t32 = t31 * f[34];
    plus[8] = t30 + t32;
    minus[8] = t30 - t32;
    const prt__vec t33 = t29 * f[16];
    const prt__vec t34 = t31 * f[26];
    plus[9] = t33 + t34;
    minus[9] = t33 - t34;
    const prt__vec t35 = prt__vec_load(q + 20 * PRT__NODES);
    const prt__vec t36 = t35 * f[35];
    plus[10] = t36;
    minus[10] = t36;
    const prt__vec t37 = t35 * f[25];
    plus[11] = t37;
    minus[11] = t37;
}

/* terms of the projection of rows, 3 bands: 9 multiplications, 0 additions (0 can fuse), 14 loads, 9 stores */
PRT__INLINE void prt__sh_terms_3(const prt__vec *even, const prt__vec *odd, const prt_real *q, 
    prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = even[0];
    out[0] = prt__vec_load(q) * t1;
    out[2] = prt__vec_load(q + 1 * PRT__NODES) * odd[0];
    out[6] = t1 * prt__vec_load(q + 3 * PRT__NODES);
    const prt__vec t2 = prt__vec_load(q + 2 * PRT__NODES);
    out[3] = t2 * even[2];
    out[1] = t2 * even[3];
    const prt__vec t3 = prt__vec_load(q + 4 * PRT__NODES);
    out[7] = t3 * odd[2];
    out[5] = t3 * odd[3];
    const prt__vec t4 = prt__vec_load(q + 5 * PRT__NODES);
    out[8] = t4 * even[4];
    out[4] = t4 * even[5];
}

/* terms of the projection of rows, 4 bands: 16 multiplications, 0 additions (0 can fuse), 22 loads, 16 stores */
PRT__INLINE void prt__sh_terms_4(const prt__vec *even, const prt__vec *odd, const prt_real *q, 
    prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = even[0];
    out[0] = prt__vec_load(q) * t1;
    const prt__vec t2 = odd[0];
    out[2] = prt__vec_load(q + 1 * PRT__NODES) * t2;
    out[6] = t1 * prt__vec_load(q + 3 * PRT__NODES);
    out[12] = t2 * prt__vec_load(q + 6 * PRT__NODES);
    const prt__vec t3 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t4 = even[2];
    out[3] = t3 * t4;
    const prt__vec t5 = even[3];
    out[1] = t3 * t5;
    const prt__vec t6 = prt__vec_load(q + 4 * PRT__NODES);
    out[7] = t6 * odd[2];
    out[5] = t6 * odd[3];
    const prt__vec t7 = prt__vec_load(q + 7 * PRT__NODES);
    out[13] = t4 * t7;
    out[11] = t5 * t7;
    const prt__vec t8 = prt__vec_load(q + 5 * PRT__NODES);
    out[8] = t8 * even[4];
    out[4] = t8 * even[5];
    const prt__vec t9 = prt__vec_load(q + 8 * PRT__NODES);
    out[14] = t9 * odd[4];
    out[10] = t9 * odd[5];
    const prt__vec t10 = prt__vec_load(q + 9 * PRT__NODES);
    out[15] = t10 * even[6];
    out[9] = t10 * even[7];
}

/* terms of the projection of rows, 5 bands: 25 multiplications, 0 additions (0 can fuse), 31 loads, 25 stores */
PRT__INLINE void prt__sh_terms_5(const prt__vec *even, const prt__vec *odd, const prt_real *q, 
    prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = even[0];
    out[0] = prt__vec_load(q) * t1;
    const prt__vec t2 = odd[0];
    out[2] = prt__vec_load(q + 1 * PRT__NODES) * t2;
    out[6] = t1 * prt__vec_load(q + 3 * PRT__NODES);
    out[12] = t2 * prt__vec_load(q + 6 * PRT__NODES);
    out[20] = t1 * prt__vec_load(q + 10 * PRT__NODES);
    const prt__vec t3 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t4 = even[2];
    out[3] = t3 * t4;
    const prt__vec t5 = even[3];
    out[1] = t3 * t5;
    const prt__vec t6 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t7 = odd[2];
    out[7] = t6 * t7;
    const prt__vec t8 = odd[3];
    out[5] = t6 * t8;
    const prt__vec t9 = prt__vec_load(q + 7 * PRT__NODES);
    out[13] = t4 * t9;
    out[11] = t5 * t9;
    const prt__vec t10 = prt__vec_load(q + 11 * PRT__NODES);
    out[21] = t7 * t10;
    out[19] = t8 * t10;
    const prt__vec t11 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t12 = even[4];
    out[8] = t11 * t12;
    const prt__vec t13 = even[5];
    out[4] = t11 * t13;
    const prt__vec t14 = prt__vec_load(q + 8 * PRT__NODES);
    out[14] = t14 * odd[4];
    out[10] = t14 * odd[5];
    const prt__vec t15 = prt__vec_load(q + 12 * PRT__NODES);
    out[22] = t12 * t15;
    out[18] = t13 * t15;
    const prt__vec t16 = prt__vec_load(q + 9 * PRT__NODES);
    out[15] = t16 * even[6];
    out[9] = t16 * even[7];
    const prt__vec t17 = prt__vec_load(q + 13 * PRT__NODES);
    out[23] = t17 * odd[6];
    out[17] = t17 * odd[7];
    const prt__vec t18 = prt__vec_load(q + 14 * PRT__NODES);
    out[24] = t18 * even[8];
    out[16] = t18 * even[9];
}

/* terms of the projection of rows, 6 bands: 36 multiplications, 0 additions (0 can fuse), 41 loads, 36 stores */
PRT__INLINE void prt__sh_terms_6(const prt__vec *even, const prt__vec *odd, const prt_real *q, 
    prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = even[0];
    out[0] = prt__vec_load(q) * t1;
    const prt__vec t2 = odd[0];
    out[2] = prt__vec_load(q + 1 * PRT__NODES) * t2;
    out[6] = t1 * prt__vec_load(q + 3 * PRT__NODES);
    out[12] = t2 * prt__vec_load(q + 6 * PRT__NODES);
    out[20] = t1 * prt__vec_load(q + 10 * PRT__NODES);
    out[30] = t2 * prt__vec_load(q + 15 * PRT__NODES);
    const prt__vec t3 = prt__vec_load(q + 2 * PRT__NODES);
    const prt__vec t4 = even[2];
    out[3] = t3 * t4;
    const prt__vec t5 = even[3];
    out[1] = t3 * t5;
    const prt__vec t6 = prt__vec_load(q + 4 * PRT__NODES);
    const prt__vec t7 = odd[2];
    out[7] = t6 * t7;
    const prt__vec t8 = odd[3];
    out[5] = t6 * t8;
    const prt__vec t9 = prt__vec_load(q + 7 * PRT__NODES);
    out[13] = t4 * t9;
    out[11] = t5 * t9;
    const prt__vec t10 = prt__vec_load(q + 11 * PRT__NODES);
    out[21] = t7 * t10;
    out[19] = t8 * t10;
    const prt__vec t11 = prt__vec_load(q + 16 * PRT__NODES);
    out[31] = t4 * t11;
    out[29] = t5 * t11;
    const prt__vec t12 = prt__vec_load(q + 5 * PRT__NODES);
    const prt__vec t13 = even[4];
    out[8] = t12 * t13;
    const prt__vec t14 = even[5];
    out[4] = t12 * t14;
    const prt__vec t15 = prt__vec_load(q + 8 * PRT__NODES);
    const prt__vec t16 = odd[4];
    out[14] = t15 * t16;
    const prt__vec t17 = odd[5];
    out[10] = t15 * t17;
    const prt__vec t18 = prt__vec_load(q + 12 * PRT__NODES);
    out[22] = t13 * t18;
    out[18] = t14 * t18;
    const prt__vec t19 = prt__vec_load(q + 17 * PRT__NODES);
    out[32] = t16 * t19;
    out[28] = t17 * t19;
    const prt__vec t20 = prt__vec_load(q + 9 * PRT__NODES);
    const prt__vec t21 = even[6];
    out[15] = t20 * t21;
    const prt__vec t22 = even[7];
    out[9] = t20 * t22;
    const prt__vec t23 = prt__vec_load(q + 13 * PRT__NODES);
    out[23] = t23 * odd[6];
    out[17] = t23 * odd[7];
    const prt__vec t24 = prt__vec_load(q + 18 * PRT__NODES);
    out[33] = t21 * t24;
    out[27] = t22 * t24;
    const prt__vec t25 = prt__vec_load(q + 14 * PRT__NODES);
    out[24] = t25 * even[8];
    out[16] = t25 * even[9];
    const prt__vec t26 = prt__vec_load(q + 19 * PRT__NODES);
    out[34] = t26 * odd[8];
    out[26] = t26 * odd[9];
    const prt__vec t27 = prt__vec_load(q + 20 * PRT__NODES);
    out[35] = t27 * even[10];
    out[25] = t27 * even[11];
}

/* product of two rows, 3 bands: 24 multiplications, 20 additions (15 can fuse), 10 loads, 5 stores */
PRT__INLINE void prt__row_product_3_v(const prt__vec *w, const prt__vec *v, prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = w[0];
    const prt__vec t2 = v[0];
    const prt__vec t3 = v[2];
    const prt__vec t4 = w[2];
    const prt__vec t5 = t3 * t4;
    const prt__vec t6 = v[4];
    const prt__vec t7 = w[4];
    const prt__vec t8 = v[3];
    const prt__vec t9 = w[3];
    const prt__vec t10 = t8 * t9;
    const prt__vec t11 = v[5];
    const prt__vec t12 = w[5];
    out[0] = ((PRT__R(0.5) * (t1 * t2) + t5) + t6 * t7) + (t10 + t11 * t12);
    out[2] = ((t1 * t3 + t3 * t7) + t4 * t6) + ((t2 * t4 + t8 * t12) + t9 * t11);
    out[3] = ((t1 * t8 + t3 * t12) + t4 * t11) + ((t2 * t9 - t8 * t7) - t9 * t6);
    out[4] = (t5 + t1 * t6) + (t2 * t7 - t10);
    out[5] = (t1 * t11 + t3 * t9) + (t2 * t12 + t4 * t8);
}

/* product of two rows, 4 bands: 46 multiplications, 48 additions (33 can fuse), 14 loads, 7 stores */
PRT__INLINE void prt__row_product_4_v(const prt__vec *w, const prt__vec *v, prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = w[0];
    const prt__vec t2 = v[0];
    const prt__vec t3 = v[2];
    const prt__vec t4 = w[2];
    const prt__vec t5 = t3 * t4;
    const prt__vec t6 = v[4];
    const prt__vec t7 = w[4];
    const prt__vec t8 = v[6];
    const prt__vec t9 = w[6];
    const prt__vec t10 = v[3];
    const prt__vec t11 = w[3];
    const prt__vec t12 = t10 * t11;
    const prt__vec t13 = v[5];
    const prt__vec t14 = w[5];
    const prt__vec t15 = v[7];
    const prt__vec t16 = w[7];
    out[0] = (((PRT__R(0.5) * (t1 * t2) + t5) + t6 * t7) + t8 * t9) + ((t12 + t13 * t14) + t15 * t16);
    const prt__vec t17 = t3 * t7;
    const prt__vec t18 = t4 * t6;
    const prt__vec t19 = t10 * t14;
    const prt__vec t20 = t11 * t13;
    out[2] = ((((t1 * t3 + t17) + t18) + t6 * t9) + t7 * t8) + ((((t2 * t4 + t19) + t20) + t13 * t16) + t14 * t15);
    const prt__vec t21 = t3 * t14;
    const prt__vec t22 = t4 * t13;
    const prt__vec t23 = t10 * t7;
    const prt__vec t24 = t11 * t6;
    out[3] = ((((t1 * t10 + t21) + t22) + t6 * t16) + t7 * t15) + ((((t2 * t11 - t23) - t24) - t13 * t9) - t14 * t8);
    out[4] = (((t5 + t1 * t6) + t3 * t9) + t4 * t8) + (((t2 * t7 - t12) + t10 * t16) + t11 * t15);
    out[5] = (((t1 * t13 + t3 * t11) + t3 * t16) + t4 * t15) + (((t2 * t14 + t4 * t10) - t10 * t9) - t11 * t8);
    out[6] = (t17 + (t18 + t1 * t8)) + ((t2 * t9 - t20) - t19);
    out[7] = (t21 + (t24 + t1 * t15)) + (t23 + (t22 + t2 * t16));
}

/* product of two rows, 5 bands: 78 multiplications, 88 additions (55 can fuse), 18 loads, 9 stores */
PRT__INLINE void prt__row_product_5_v(const prt__vec *w, const prt__vec *v, prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = w[0];
    const prt__vec t2 = v[0];
    const prt__vec t3 = v[2];
    const prt__vec t4 = w[2];
    const prt__vec t5 = t3 * t4;
    const prt__vec t6 = v[4];
    const prt__vec t7 = w[4];
    const prt__vec t8 = t6 * t7;
    const prt__vec t9 = v[6];
    const prt__vec t10 = w[6];
    const prt__vec t11 = v[8];
    const prt__vec t12 = w[8];
    const prt__vec t13 = (((PRT__R(0.5) * (t1 * t2) + t5) + t8) + t9 * t10) + t11 * t12;
    const prt__vec t14 = v[3];
    const prt__vec t15 = w[3];
    const prt__vec t16 = t14 * t15;
    const prt__vec t17 = v[5];
    const prt__vec t18 = w[5];
    const prt__vec t19 = t17 * t18;
    const prt__vec t20 = v[7];
    const prt__vec t21 = w[7];
    const prt__vec t22 = v[9];
    const prt__vec t23 = w[9];
    out[0] = t13 + (((t16 + t19) + t20 * t21) + t22 * t23);
    const prt__vec t24 = t3 * t7;
    const prt__vec t25 = t4 * t6;
    const prt__vec t26 = ((((t1 * t3 + t24) + t25) + t6 * t10) + t7 * t9) + t9 * t12;
    const prt__vec t27 = t14 * t18;
    const prt__vec t28 = t15 * t17;
    const prt__vec t29 = ((((t2 * t4 + t27) + t28) + t17 * t21) + t18 * t20) + t20 * t23;
    out[2] = (t26 + t10 * t11) + (t29 + t21 * t22);
    const prt__vec t30 = t3 * t18;
    const prt__vec t31 = t4 * t17;
    const prt__vec t32 = ((((t1 * t14 + t30) + t31) + t6 * t21) + t7 * t20) + t9 * t23;
    const prt__vec t33 = t14 * t7;
    const prt__vec t34 = t15 * t6;
    const prt__vec t35 = ((((t2 * t15 - t33) - t34) - t17 * t10) - t18 * t9) - t20 * t12;
    out[3] = (t32 + t10 * t22) + (t35 - t21 * t11);
    const prt__vec t36 = t3 * t10;
    const prt__vec t37 = t4 * t9;
    const prt__vec t38 = t14 * t21;
    const prt__vec t39 = t15 * t20;
    out[4] = (((((t5 + t1 * t6) + t36) + t37) + t6 * t12) + t7 * t11) + (((((t2 * t7 - t16) + t38) + t39) + t17 * t23) + t18 * t22);
    const prt__vec t40 = t3 * t21;
    const prt__vec t41 = t4 * t20;
    const prt__vec t42 = ((((t1 * t17 + t3 * t15) + t40) + t41) + t6 * t23) + t7 * t22;
    const prt__vec t43 = t14 * t10;
    const prt__vec t44 = t15 * t9;
    const prt__vec t45 = ((((t2 * t18 + t4 * t14) - t43) - t44) - t17 * t12) - t18 * t11;
    out[5] = t42 + t45;
    out[6] = (((t24 + (t25 + t1 * t9)) + t3 * t12) + t4 * t11) + ((((t2 * t10 - t28) - t27) + t14 * t23) + t15 * t22);
    out[7] = (((t30 + (t34 + t1 * t20)) + t3 * t23) + t4 * t22) + (((t33 + (t31 + t2 * t21)) - t14 * t12) - t15 * t11);
    out[8] = (t36 + (t8 + (t37 + t1 * t11))) + (((t2 * t12 - t39) - t19) - t38);
    out[9] = (t40 + ((t44 + t1 * t22) + t6 * t18)) + (t43 + ((t41 + t2 * t23) + t7 * t17));
}

/* product of two rows, 6 bands: 116 multiplications, 140 additions (77 can fuse), 22 loads, 11 stores */
PRT__INLINE void prt__row_product_6_v(const prt__vec *w, const prt__vec *v, prt__vec *PRT__RESTRICT out) {
    const prt__vec t1 = w[0];
    const prt__vec t2 = v[0];
    const prt__vec t3 = v[2];
    const prt__vec t4 = w[2];
    const prt__vec t5 = t3 * t4;
    const prt__vec t6 = v[4];
    const prt__vec t7 = w[4];
    const prt__vec t8 = t6 * t7;
    const prt__vec t9 = v[6];
    const prt__vec t10 = w[6];
    const prt__vec t11 = v[8];
    const prt__vec t12 = w[8];
    const prt__vec t13 = (((PRT__R(0.5) * (t1 * t2) + t5) + t8) + t9 * t10) + t11 * t12;
    const prt__vec t14 = v[10];
    const prt__vec t15 = w[10];
    const prt__vec t16 = v[3];
    const prt__vec t17 = w[3];
    const prt__vec t18 = t16 * t17;
    const prt__vec t19 = v[5];
    const prt__vec t20 = w[5];
    const prt__vec t21 = t19 * t20;
    const prt__vec t22 = v[7];
    const prt__vec t23 = w[7];
    const prt__vec t24 = v[9];
    const prt__vec t25 = w[9];
    const prt__vec t26 = v[11];
    const prt__vec t27 = w[11];
    out[0] = (t13 + t14 * t15) + ((((t18 + t21) + t22 * t23) + t24 * t25) + t26 * t27);
    const prt__vec t28 = t3 * t7;
    const prt__vec t29 = t4 * t6;
    const prt__vec t30 = t6 * t10;
    const prt__vec t31 = t7 * t9;
    const prt__vec t32 = (((((t1 * t3 + t28) + t29) + t30) + t31) + t9 * t12) + t10 * t11;
    const prt__vec t33 = t16 * t20;
    const prt__vec t34 = t17 * t19;
    const prt__vec t35 = t19 * t23;
    const prt__vec t36 = t20 * t22;
    const prt__vec t37 = (((((t2 * t4 + t33) + t34) + t35) + t36) + t22 * t25) + t23 * t24;
    out[2] = ((t32 + t11 * t15) + t12 * t14) + ((t37 + t24 * t27) + t25 * t26);
    const prt__vec t38 = t3 * t20;
    const prt__vec t39 = t4 * t19;
    const prt__vec t40 = t6 * t23;
    const prt__vec t41 = t7 * t22;
    const prt__vec t42 = (((((t1 * t16 + t38) + t39) + t40) + t41) + t9 * t25) + t10 * t24;
    const prt__vec t43 = t16 * t7;
    const prt__vec t44 = t17 * t6;
    const prt__vec t45 = t19 * t10;
    const prt__vec t46 = t20 * t9;
    const prt__vec t47 = (((((t2 * t17 - t43) - t44) - t45) - t46) - t22 * t12) - t23 * t11;
    out[3] = ((t42 + t11 * t27) + t12 * t26) + ((t47 - t24 * t15) - t25 * t14);
    const prt__vec t48 = t3 * t10;
    const prt__vec t49 = t4 * t9;
    const prt__vec t50 = (((((t5 + t1 * t6) + t48) + t49) + t6 * t12) + t7 * t11) + t9 * t15;
    const prt__vec t51 = t16 * t23;
    const prt__vec t52 = t17 * t22;
    const prt__vec t53 = (((((t2 * t7 - t18) + t51) + t52) + t19 * t25) + t20 * t24) + t22 * t27;
    out[4] = (t50 + t10 * t14) + (t53 + t23 * t26);
    const prt__vec t54 = t3 * t23;
    const prt__vec t55 = t4 * t22;
    const prt__vec t56 = ((((t1 * t19 + t3 * t17) + t54) + t55) + t6 * t25) + t7 * t24;
    const prt__vec t57 = t16 * t10;
    const prt__vec t58 = t17 * t9;
    const prt__vec t59 = ((((t2 * t20 + t4 * t16) - t57) - t58) - t19 * t12) - t20 * t11;
    out[5] = ((t56 + t9 * t27) + t10 * t26) + ((t59 - t22 * t15) - t23 * t14);
    const prt__vec t60 = t3 * t12;
    const prt__vec t61 = t4 * t11;
    const prt__vec t62 = ((((t28 + (t29 + t1 * t9)) + t60) + t61) + t6 * t15) + t7 * t14;
    const prt__vec t63 = t16 * t25;
    const prt__vec t64 = t17 * t24;
    const prt__vec t65 = (((((t2 * t10 - t34) - t33) + t63) + t64) + t19 * t27) + t20 * t26;
    out[6] = t62 + t65;
    const prt__vec t66 = t3 * t25;
    const prt__vec t67 = t4 * t24;
    const prt__vec t68 = ((((t38 + (t44 + t1 * t22)) + t66) + t67) + t6 * t27) + t7 * t26;
    const prt__vec t69 = t16 * t12;
    const prt__vec t70 = t17 * t11;
    const prt__vec t71 = ((((t43 + (t39 + t2 * t23)) - t69) - t70) - t19 * t15) - t20 * t14;
    out[7] = t68 + t71;
    out[8] = (((t48 + (t8 + (t49 + t1 * t11))) + t3 * t15) + t4 * t14) + (((((t2 * t12 - t52) - t21) - t51) + t16 * t27) + t17 * t26);
    const prt__vec t72 = ((t54 + ((t58 + t1 * t24) + t6 * t20)) + t3 * t27) + t4 * t26;
    const prt__vec t73 = ((t57 + ((t55 + t2 * t25) + t7 * t19)) - t16 * t15) - t17 * t14;
    out[9] = t72 + t73;
    out[10] = (t60 + (t30 + (t31 + (t61 + t1 * t14)))) + ((((t2 * t15 - t64) - t36) - t35) - t63);
    out[11] = (t66 + (t40 + (t46 + (t70 + t1 * t26)))) + (t69 + (t45 + (t41 + (t67 + t2 * t27))));
}

/* END GENERATED */

#if !PRT__QUADS
/* BEGIN GENERATED: prt_codegen --lang c --emit sh_rotate --bands 2-8 */
/* rotation of one vector by r and by turn, cos and sin of a, b, g, 2 bands: 9 multiplications, 6 additions (6 can fuse), 13 loads, 4 stores */
PRT__STATIC void prt__sh_rotate_2(const prt_real *r, const prt_real *turn, const prt_real *f, 
    prt_real *PRT__RESTRICT out) {
    (void)turn;
    out[0] = f[0];
    const prt_real t1 = f[1];
    const prt_real t2 = f[2];
    const prt_real t3 = f[3];
    out[1] = (r[4] * t1 + r[5] * t2) + r[3] * t3;
    out[2] = (r[7] * t1 + r[8] * t2) + r[6] * t3;
    out[3] = (r[1] * t1 + r[2] * t2) + r[0] * t3;
}

/* rotation of one vector by r and by turn, cos and sin of a, b, g, 3 bands: 55 multiplications, 37 additions (35 can fuse), 18 loads, 9 stores */
PRT__STATIC void prt__sh_rotate_3(const prt_real *r, const prt_real *turn, const prt_real *f, 
    prt_real *PRT__RESTRICT out) {
    (void)turn;
    out[0] = f[0];
    const prt_real t1 = r[4];
    const prt_real t2 = f[1];
    const prt_real t3 = r[5];
    const prt_real t4 = f[2];
    const prt_real t5 = r[3];
    const prt_real t6 = f[3];
    out[1] = (t1 * t2 + t3 * t4) + t5 * t6;
    const prt_real t7 = r[7];
    const prt_real t8 = r[8];
    const prt_real t9 = r[6];
    out[2] = (t7 * t2 + t8 * t4) + t9 * t6;
    const prt_real t10 = r[1];
    const prt_real t11 = r[2];
    const prt_real t12 = r[0];
    out[3] = (t10 * t2 + t11 * t4) + t12 * t6;
    const prt_real t13 = f[8];
    const prt_real t14 = PRT__R(0.577350269189625764509) * f[6];
    const prt_real t15 = t13 - t14;
    const prt_real t16 = f[4];
    const prt_real t17 = f[7];
    const prt_real t18 = (t12 * t15 + t10 * t16) + t11 * t17;
    const prt_real t19 = t13 + t14;
    const prt_real t20 = f[5];
    const prt_real t21 = (t12 * t16 - t10 * t19) + t11 * t20;
    const prt_real t22 = PRT__R(2.0) * t14;
    const prt_real t23 = (t12 * t17 + t10 * t20) + t11 * t22;
    out[4] = (t5 * t18 + t1 * t21) + t3 * t23;
    const prt_real t24 = (t5 * t15 + t1 * t16) + t3 * t17;
    const prt_real t25 = (t5 * t16 - t1 * t19) + t3 * t20;
    const prt_real t26 = (t5 * t17 + t1 * t20) + t3 * t22;
    out[5] = (t9 * t24 + t7 * t25) + t8 * t26;
    const prt_real t27 = t9 * ((t9 * t15 + t7 * t16) + t8 * t17) + t7 * ((t9 * t16 - t7 * t19) + t8 * t20);
    const prt_real t28 = t27 + t8 * ((t9 * t17 + t7 * t20) + t8 * t22);
    out[6] = PRT__R(0.866025403784438646764) * t28;
    out[7] = (t9 * t18 + t7 * t21) + t8 * t23;
    out[8] = -(((t5 * t24 + t1 * t25) + t3 * t26) + PRT__R(0.5) * t28);
}

/* rotation of one vector by r and by turn, cos and sin of a, b, g, 4 bands: 122 multiplications, 64 additions (61 can fuse), 31 loads, 16 stores */
PRT__STATIC void prt__sh_rotate_4(const prt_real *r, const prt_real *turn, const prt_real *f, 
    prt_real *PRT__RESTRICT out) {
    out[0] = f[0];
    const prt_real t1 = f[1];
    const prt_real t2 = f[2];
    const prt_real t3 = f[3];
    out[1] = (r[4] * t1 + r[5] * t2) + r[3] * t3;
    out[2] = (r[7] * t1 + r[8] * t2) + r[6] * t3;
    out[3] = (r[1] * t1 + r[2] * t2) + r[0] * t3;
    const prt_real t4 = turn[0];
    const prt_real t5 = turn[1];
    const prt_real t6 = t4 * t4 - t5 * t5;
    const prt_real t7 = turn[2];
    const prt_real t8 = f[4];
    const prt_real t9 = turn[4];
    const prt_real t10 = turn[5];
    const prt_real t11 = t9 * t9 - t10 * t10;
    const prt_real t12 = f[8];
    const prt_real t13 = t9 * t10;
    const prt_real t14 = t13 + t13;
    const prt_real t15 = t8 * t11 + t12 * t14;
    const prt_real t16 = turn[3];
    const prt_real t17 = f[5];
    const prt_real t18 = f[7];
    const prt_real t19 = t17 * t9 + t18 * t10;
    const prt_real t20 = t7 * t15 + t16 * t19;
    const prt_real t21 = t4 * t5;
    const prt_real t22 = t21 + t21;
    const prt_real t23 = f[6];
    const prt_real t24 = t12 * t11 - t8 * t14;
    const prt_real t25 = PRT__R(-0.5) * t23 + PRT__R(-0.866025403784438646764) * t24;
    const prt_real t26 = t7 * t7 - t16 * t16;
    const prt_real t27 = PRT__R(-0.866025403784438646764) * t23 + PRT__R(0.5) * t24;
    const prt_real t28 = t7 * t16;
    const prt_real t29 = t28 + t28;
    const prt_real t30 = t18 * t9 - t17 * t10;
    const prt_real t31 = t26 * t27 + t29 * t30;
    const prt_real t32 = PRT__R(-0.866025403784438646764) * t25 + PRT__R(0.5) * t31;
    out[4] = t6 * t20 + t22 * t32;
    const prt_real t33 = t7 * t19 - t16 * t15;
    const prt_real t34 = t26 * t30 - t29 * t27;
    out[5] = t4 * t33 + t5 * t34;
    out[6] = PRT__R(-0.5) * t25 + PRT__R(-0.866025403784438646764) * t31;
    out[7] = t4 * t34 - t5 * t33;
    out[8] = t6 * t32 - t22 * t20;
    const prt_real t35 = t4 * t6 - t5 * t22;
    const prt_real t36 = f[9];
    const prt_real t37 = t9 * t11 - t10 * t14;
    const prt_real t38 = f[15];
    const prt_real t39 = t9 * t14 + t10 * t11;
    const prt_real t40 = t36 * t37 + t38 * t39;
    const prt_real t41 = f[11];
    const prt_real t42 = f[13];
    const prt_real t43 = t41 * t9 + t42 * t10;
    const prt_real t44 = PRT__R(-0.790569415042094833) * t40 + PRT__R(-0.612372435695794524549) * t43;
    const prt_real t45 = PRT__R(0.612372435695794524549) * t40 + PRT__R(-0.790569415042094833) * t43;
    const prt_real t46 = f[10];
    const prt_real t47 = f[14];
    const prt_real t48 = t46 * t11 + t47 * t14;
    const prt_real t49 = t26 * t45 + t29 * t48;
    const prt_real t50 = PRT__R(-0.790569415042094833) * t44 + PRT__R(0.612372435695794524549) * t49;
    const prt_real t51 = t4 * t22 + t5 * t6;
    const prt_real t52 = t42 * t9 - t41 * t10;
    const prt_real t53 = t38 * t37 - t36 * t39;
    const prt_real t54 = PRT__R(-0.25) * t52 + PRT__R(-0.968245836551854221295) * t53;
    const prt_real t55 = f[12];
    const prt_real t56 = t47 * t11 - t46 * t14;
    const prt_real t57 = PRT__R(-0.612372435695794524549) * t55 + PRT__R(-0.790569415042094833) * t56;
    const prt_real t58 = t7 * t54 + t16 * t57;
    const prt_real t59 = t7 * t26 - t16 * t29;
    const prt_real t60 = PRT__R(-0.968245836551854221295) * t52 + PRT__R(0.25) * t53;
    const prt_real t61 = t7 * t29 + t16 * t26;
    const prt_real t62 = PRT__R(-0.790569415042094833) * t55 + PRT__R(0.612372435695794524549) * t56;
    const prt_real t63 = t59 * t60 + t61 * t62;
    const prt_real t64 = PRT__R(-0.968245836551854221295) * t58 + PRT__R(0.25) * t63;
    out[9] = t35 * t50 + t51 * t64;
    const prt_real t65 = t26 * t48 - t29 * t45;
    const prt_real t66 = t59 * t62 - t61 * t60;
    const prt_real t67 = t7 * t57 - t16 * t54;
    const prt_real t68 = PRT__R(0.612372435695794524549) * t66 + PRT__R(-0.790569415042094833) * t67;
    out[10] = t6 * t65 + t22 * t68;
    const prt_real t69 = PRT__R(-0.612372435695794524549) * t44 + PRT__R(-0.790569415042094833) * t49;
    const prt_real t70 = PRT__R(-0.25) * t58 + PRT__R(-0.968245836551854221295) * t63;
    out[11] = t4 * t69 + t5 * t70;
    out[12] = PRT__R(-0.790569415042094833) * t66 + PRT__R(-0.612372435695794524549) * t67;
    out[13] = t4 * t70 - t5 * t69;
    out[14] = t6 * t68 - t22 * t65;
    out[15] = t35 * t64 - t51 * t50;
}

/* rotation of one vector by r and by turn, cos and sin of a, b, g, 5 bands: 224 multiplications, 118 additions (115 can fuse), 40 loads, 25 stores */
PRT__STATIC void prt__sh_rotate_5(const prt_real *r, const prt_real *turn, const prt_real *f, 
    prt_real *PRT__RESTRICT out) {
    out[0] = f[0];
    const prt_real t1 = f[1];
    const prt_real t2 = f[2];
    const prt_real t3 = f[3];
    out[1] = (r[4] * t1 + r[5] * t2) + r[3] * t3;
    out[2] = (r[7] * t1 + r[8] * t2) + r[6] * t3;
    out[3] = (r[1] * t1 + r[2] * t2) + r[0] * t3;
    const prt_real t4 = turn[0];
    const prt_real t5 = turn[1];
    const prt_real t6 = t4 * t4 - t5 * t5;
    const prt_real t7 = turn[2];
    const prt_real t8 = f[4];
    const prt_real t9 = turn[4];
    const prt_real t10 = turn[5];
    const prt_real t11 = t9 * t9 - t10 * t10;
    const prt_real t12 = f[8];
    const prt_real t13 = t9 * t10;
    const prt_real t14 = t13 + t13;
    const prt_real t15 = t8 * t11 + t12 * t14;
    const prt_real t16 = turn[3];
    const prt_real t17 = f[5];
    const prt_real t18 = f[7];
    const prt_real t19 = t17 * t9 + t18 * t10;
    const prt_real t20 = t7 * t15 + t16 * t19;
    const prt_real t21 = t4 * t5;
    const prt_real t22 = t21 + t21;
    const prt_real t23 = f[6];
    const prt_real t24 = t12 * t11 - t8 * t14;
    const prt_real t25 = PRT__R(-0.5) * t23 + PRT__R(-0.866025403784438646764) * t24;
    const prt_real t26 = t7 * t7 - t16 * t16;
    const prt_real t27 = PRT__R(-0.866025403784438646764) * t23 + PRT__R(0.5) * t24;
    const prt_real t28 = t7 * t16;
    const prt_real t29 = t28 + t28;
    const prt_real t30 = t18 * t9 - t17 * t10;
    const prt_real t31 = t26 * t27 + t29 * t30;
    const prt_real t32 = PRT__R(-0.866025403784438646764) * t25 + PRT__R(0.5) * t31;
    out[4] = t6 * t20 + t22 * t32;
    const prt_real t33 = t7 * t19 - t16 * t15;
    const prt_real t34 = t26 * t30 - t29 * t27;
    out[5] = t4 * t33 + t5 * t34;
    out[6] = PRT__R(-0.5) * t25 + PRT__R(-0.866025403784438646764) * t31;
    out[7] = t4 * t34 - t5 * t33;
    out[8] = t6 * t32 - t22 * t20;
    const prt_real t35 = t4 * t6 - t5 * t22;
    const prt_real t36 = f[9];
    const prt_real t37 = t9 * t11 - t10 * t14;
    const prt_real t38 = f[15];
    const prt_real t39 = t9 * t14 + t10 * t11;
    const prt_real t40 = t36 * t37 + t38 * t39;
    const prt_real t41 = f[11];
    const prt_real t42 = f[13];
    const prt_real t43 = t41 * t9 + t42 * t10;
    const prt_real t44 = PRT__R(-0.790569415042094833) * t40 + PRT__R(-0.612372435695794524549) * t43;
    const prt_real t45 = PRT__R(0.612372435695794524549) * t40 + PRT__R(-0.790569415042094833) * t43;
    const prt_real t46 = f[10];
    const prt_real t47 = f[14];
    const prt_real t48 = t46 * t11 + t47 * t14;
    const prt_real t49 = t26 * t45 + t29 * t48;
    const prt_real t50 = PRT__R(-0.790569415042094833) * t44 + PRT__R(0.612372435695794524549) * t49;
    const prt_real t51 = t4 * t22 + t5 * t6;
    const prt_real t52 = t42 * t9 - t41 * t10;
    const prt_real t53 = t38 * t37 - t36 * t39;
    const prt_real t54 = PRT__R(-0.25) * t52 + PRT__R(-0.968245836551854221295) * t53;
    const prt_real t55 = f[12];
    const prt_real t56 = t47 * t11 - t46 * t14;
    const prt_real t57 = PRT__R(-0.612372435695794524549) * t55 + PRT__R(-0.790569415042094833) * t56;
    const prt_real t58 = t7 * t54 + t16 * t57;
    const prt_real t59 = t7 * t26 - t16 * t29;
    const prt_real t60 = PRT__R(-0.968245836551854221295) * t52 + PRT__R(0.25) * t53;
    const prt_real t61 = t7 * t29 + t16 * t26;
    const prt_real t62 = PRT__R(-0.790569415042094833) * t55 + PRT__R(0.612372435695794524549) * t56;
    const prt_real t63 = t59 * t60 + t61 * t62;
    const prt_real t64 = PRT__R(-0.968245836551854221295) * t58 + PRT__R(0.25) * t63;
    out[9] = t35 * t50 + t51 * t64;
    const prt_real t65 = t26 * t48 - t29 * t45;
    const prt_real t66 = t59 * t62 - t61 * t60;
    const prt_real t67 = t7 * t57 - t16 * t54;
    const prt_real t68 = PRT__R(0.612372435695794524549) * t66 + PRT__R(-0.790569415042094833) * t67;
    out[10] = t6 * t65 + t22 * t68;
    const prt_real t69 = PRT__R(-0.612372435695794524549) * t44 + PRT__R(-0.790569415042094833) * t49;
    const prt_real t70 = PRT__R(-0.25) * t58 + PRT__R(-0.968245836551854221295) * t63;
    out[11] = t4 * t69 + t5 * t70;
    out[12] = PRT__R(-0.790569415042094833) * t66 + PRT__R(-0.612372435695794524549) * t67;
    out[13] = t4 * t70 - t5 * t69;
    out[14] = t6 * t68 - t22 * t65;
    out[15] = t35 * t64 - t51 * t50;
    const prt_real t71 = t4 * t35 - t5 * t51;
    const prt_real t72 = f[16];
    const prt_real t73 = t9 * t37 - t10 * t39;
    const prt_real t74 = f[24];
    const prt_real t75 = t9 * t39 + t10 * t37;
    const prt_real t76 = t72 * t73 + t74 * t75;
    const prt_real t77 = f[18];
    const prt_real t78 = f[22];
    const prt_real t79 = t77 * t11 + t78 * t14;
    const prt_real t80 = PRT__R(-0.935414346693485346396) * t76 + PRT__R(-0.3535533905932737622) * t79;
    const prt_real t81 = f[17];
    const prt_real t82 = f[23];
    const prt_real t83 = t81 * t37 + t82 * t39;
    const prt_real t84 = f[19];
    const prt_real t85 = f[21];
    const prt_real t86 = t84 * t9 + t85 * t10;
    const prt_real t87 = PRT__R(-0.661437827766147647625) * t83 + PRT__R(-0.75) * t86;
    const prt_real t88 = t7 * t80 + t16 * t87;
    const prt_real t89 = PRT__R(0.3535533905932737622) * t76 + PRT__R(-0.935414346693485346396) * t79;
    const prt_real t90 = PRT__R(0.75) * t83 + PRT__R(-0.661437827766147647625) * t86;
    const prt_real t91 = t59 * t89 + t61 * t90;
    const prt_real t92 = PRT__R(-0.935414346693485346396) * t88 + PRT__R(0.3535533905932737622) * t91;
    const prt_real t93 = t4 * t51 + t5 * t35;
    const prt_real t94 = f[20];
    const prt_real t95 = t78 * t11 - t77 * t14;
    const prt_real t96 = PRT__R(0.375) * t94 + PRT__R(0.559016994374947424102) * t95;
    const prt_real t97 = t74 * t73 - t72 * t75;
    const prt_real t98 = t96 + PRT__R(0.739509972887452005321) * t97;
    const prt_real t99 = (PRT__R(0.559016994374947424102) * t94 + PRT__R(0.5) * t95) + PRT__R(-0.661437827766147647625) * t97;
    const prt_real t100 = t85 * t9 - t84 * t10;
    const prt_real t101 = t82 * t37 - t81 * t39;
    const prt_real t102 = PRT__R(-0.3535533905932737622) * t100 + PRT__R(-0.935414346693485346396) * t101;
    const prt_real t103 = t26 * t99 + t29 * t102;
    const prt_real t104 = PRT__R(0.739509972887452005321) * t98 + PRT__R(-0.661437827766147647625) * t103;
    const prt_real t105 = t7 * t59 - t16 * t61;
    const prt_real t106 = PRT__R(0.739509972887452005321) * t94 + PRT__R(-0.661437827766147647625) * t95;
    const prt_real t107 = t106 + PRT__R(0.125) * t97;
    const prt_real t108 = t7 * t61 + t16 * t59;
    const prt_real t109 = PRT__R(-0.935414346693485346396) * t100 + PRT__R(0.3535533905932737622) * t101;
    const prt_real t110 = t105 * t107 + t108 * t109;
    const prt_real t111 = t104 + PRT__R(0.125) * t110;
    out[16] = t71 * t92 + t93 * t111;
    const prt_real t112 = t59 * t90 - t61 * t89;
    const prt_real t113 = t7 * t87 - t16 * t80;
    const prt_real t114 = PRT__R(0.75) * t112 + PRT__R(-0.661437827766147647625) * t113;
    const prt_real t115 = t105 * t109 - t108 * t107;
    const prt_real t116 = t26 * t102 - t29 * t99;
    const prt_real t117 = PRT__R(0.3535533905932737622) * t115 + PRT__R(-0.935414346693485346396) * t116;
    out[17] = t35 * t114 + t51 * t117;
    const prt_real t118 = PRT__R(-0.3535533905932737622) * t88 + PRT__R(-0.935414346693485346396) * t91;
    const prt_real t119 = (PRT__R(0.559016994374947424102) * t98 + PRT__R(0.5) * t103) + PRT__R(-0.661437827766147647625) * t110;
    out[18] = t6 * t118 + t22 * t119;
    const prt_real t120 = PRT__R(-0.661437827766147647625) * t112 + PRT__R(-0.75) * t113;
    const prt_real t121 = PRT__R(-0.935414346693485346396) * t115 + PRT__R(-0.3535533905932737622) * t116;
    out[19] = t4 * t120 + t5 * t121;
    const prt_real t122 = PRT__R(0.375) * t98 + PRT__R(0.559016994374947424102) * t103;
    out[20] = t122 + PRT__R(0.739509972887452005321) * t110;
    out[21] = t4 * t121 - t5 * t120;
    out[22] = t6 * t119 - t22 * t118;
    out[23] = t35 * t117 - t51 * t114;
    out[24] = t71 * t111 - t93 * t92;
}

/* rotation of one vector by r and by turn, cos and sin of a, b, g, 6 bands: 358 multiplications, 194 additions (191 can fuse), 51 loads, 36 stores */
PRT__STATIC void prt__sh_rotate_6(const prt_real *r, const prt_real *turn, const prt_real *f, 
    prt_real *PRT__RESTRICT out) {
    out[0] = f[0];
    const prt_real t1 = f[1];
    const prt_real t2 = f[2];
    const prt_real t3 = f[3];
    out[1] = (r[4] * t1 + r[5] * t2) + r[3] * t3;
    out[2] = (r[7] * t1 + r[8] * t2) + r[6] * t3;
    out[3] = (r[1] * t1 + r[2] * t2) + r[0] * t3;
    const prt_real t4 = turn[0];
    const prt_real t5 = turn[1];
    const prt_real t6 = t4 * t4 - t5 * t5;
    const prt_real t7 = turn[2];
    const prt_real t8 = f[4];
    const prt_real t9 = turn[4];
    const prt_real t10 = turn[5];
    const prt_real t11 = t9 * t9 - t10 * t10;
    const prt_real t12 = f[8];
    const prt_real t13 = t9 * t10;
    const prt_real t14 = t13 + t13;
    const prt_real t15 = t8 * t11 + t12 * t14;
    const prt_real t16 = turn[3];
    const prt_real t17 = f[5];
    const prt_real t18 = f[7];
    const prt_real t19 = t17 * t9 + t18 * t10;
    const prt_real t20 = t7 * t15 + t16 * t19;
    const prt_real t21 = t4 * t5;
    const prt_real t22 = t21 + t21;
    const prt_real t23 = f[6];
    const prt_real t24 = t12 * t11 - t8 * t14;
    const prt_real t25 = PRT__R(-0.5) * t23 + PRT__R(-0.866025403784438646764) * t24;
    const prt_real t26 = t7 * t7 - t16 * t16;
    const prt_real t27 = PRT__R(-0.866025403784438646764) * t23 + PRT__R(0.5) * t24;
    const prt_real t28 = t7 * t16;
    const prt_real t29 = t28 + t28;
    const prt_real t30 = t18 * t9 - t17 * t10;
    const prt_real t31 = t26 * t27 + t29 * t30;
    const prt_real t32 = PRT__R(-0.866025403784438646764) * t25 + PRT__R(0.5) * t31;
    out[4] = t6 * t20 + t22 * t32;
    const prt_real t33 = t7 * t19 - t16 * t15;
    const prt_real t34 = t26 * t30 - t29 * t27;
    out[5] = t4 * t33 + t5 * t34;
    out[6] = PRT__R(-0.5) * t25 + PRT__R(-0.866025403784438646764) * t31;
    out[7] = t4 * t34 - t5 * t33;
    out[8] = t6 * t32 - t22 * t20;
    const prt_real t35 = t4 * t6 - t5 * t22;
    const prt_real t36 = f[9];
    const prt_real t37 = t9 * t11 - t10 * t14;
    const prt_real t38 = f[15];
    const prt_real t39 = t9 * t14 + t10 * t11;
    const prt_real t40 = t36 * t37 + t38 * t39;
    const prt_real t41 = f[11];
    const prt_real t42 = f[13];
    const prt_real t43 = t41 * t9 + t42 * t10;
    const prt_real t44 = PRT__R(-0.790569415042094833) * t40 + PRT__R(-0.612372435695794524549) * t43;
    const prt_real t45 = PRT__R(0.612372435695794524549) * t40 + PRT__R(-0.790569415042094833) * t43;
    const prt_real t46 = f[10];
    const prt_real t47 = f[14];
    const prt_real t48 = t46 * t11 + t47 * t14;
    const prt_real t49 = t26 * t45 + t29 * t48;
    const prt_real t50 = PRT__R(-0.790569415042094833) * t44 + PRT__R(0.612372435695794524549) * t49;
    const prt_real t51 = t4 * t22 + t5 * t6;
    const prt_real t52 = t42 * t9 - t41 * t10;
    const prt_real t53 = t38 * t37 - t36 * t39;
    const prt_real t54 = PRT__R(-0.25) * t52 + PRT__R(-0.968245836551854221295) * t53;
    const prt_real t55 = f[12];
    const prt_real t56 = t47 * t11 - t46 * t14;
    const prt_real t57 = PRT__R(-0.612372435695794524549) * t55 + PRT__R(-0.790569415042094833) * t56;
    const prt_real t58 = t7 * t54 + t16 * t57;
    const prt_real t59 = t7 * t26 - t16 * t29;
    const prt_real t60 = PRT__R(-0.968245836551854221295) * t52 + PRT__R(0.25) * t53;
    const prt_real t61 = t7 * t29 + t16 * t26;
    const prt_real t62 = PRT__R(-0.790569415042094833) * t55 + PRT__R(0.612372435695794524549) * t56;
    const prt_real t63 = t59 * t60 + t61 * t62;
    const prt_real t64 = PRT__R(-0.968245836551854221295) * t58 + PRT__R(0.25) * t63;
    out[9] = t35 * t50 + t51 * t64;
    const prt_real t65 = t26 * t48 - t29 * t45;
    const prt_real t66 = t59 * t62 - t61 * t60;
    const prt_real t67 = t7 * t57 - t16 * t54;
    const prt_real t68 = PRT__R(0.612372435695794524549) * t66 + PRT__R(-0.790569415042094833) * t67;
    out[10] = t6 * t65 + t22 * t68;
    const prt_real t69 = PRT__R(-0.612372435695794524549) * t44 + PRT__R(-0.790569415042094833) * t49;
    const prt_real t70 = PRT__R(-0.25) * t58 + PRT__R(-0.968245836551854221295) * t63;
    out[11] = t4 * t69 + t5 * t70;
    out[12] = PRT__R(-0.790569415042094833) * t66 + PRT__R(-0.612372435695794524549) * t67;
    out[13] = t4 * t70 - t5 * t69;
    out[14] = t6 * t68 - t22 * t65;
    out[15] = t35 * t64 - t51 * t50;
    const prt_real t71 = t4 * t35 - t5 * t51;
    const prt_real t72 = f[16];
    const prt_real t73 = t9 * t37 - t10 * t39;
    const prt_real t74 = f[24];
    const prt_real t75 = t9 * t39 + t10 * t37;
    const prt_real t76 = t72 * t73 + t74 * t75;
    const prt_real t77 = f[18];
    const prt_real t78 = f[22];
    const prt_real t79 = t77 * t11 + t78 * t14;
    const prt_real t80 = PRT__R(-0.935414346693485346396) * t76 + PRT__R(-0.3535533905932737622) * t79;
    const prt_real t81 = f[17];
    const prt_real t82 = f[23];
    const prt_real t83 = t81 * t37 + t82 * t39;
    const prt_real t84 = f[19];
    const prt_real t85 = f[21];
    const prt_real t86 = t84 * t9 + t85 * t10;
    const prt_real t87 = PRT__R(-0.661437827766147647625) * t83 + PRT__R(-0.75) * t86;
    const prt_real t88 = t7 * t80 + t16 * t87;
    const prt_real t89 = PRT__R(0.3535533905932737622) * t76 + PRT__R(-0.935414346693485346396) * t79;
    const prt_real t90 = PRT__R(0.75) * t83 + PRT__R(-0.661437827766147647625) * t86;
    const prt_real t91 = t59 * t89 + t61 * t90;
    const prt_real t92 = PRT__R(-0.935414346693485346396) * t88 + PRT__R(0.3535533905932737622) * t91;
    const prt_real t93 = t4 * t51 + t5 * t35;
    const prt_real t94 = f[20];
    const prt_real t95 = t78 * t11 - t77 * t14;
    const prt_real t96 = PRT__R(0.375) * t94 + PRT__R(0.559016994374947424102) * t95;
    const prt_real t97 = t74 * t73 - t72 * t75;
    const prt_real t98 = t96 + PRT__R(0.739509972887452005321) * t97;
    const prt_real t99 = (PRT__R(0.559016994374947424102) * t94 + PRT__R(0.5) * t95) + PRT__R(-0.661437827766147647625) * t97;
    const prt_real t100 = t85 * t9 - t84 * t10;
    const prt_real t101 = t82 * t37 - t81 * t39;
    const prt_real t102 = PRT__R(-0.3535533905932737622) * t100 + PRT__R(-0.935414346693485346396) * t101;
    const prt_real t103 = t26 * t99 + t29 * t102;
    const prt_real t104 = PRT__R(0.739509972887452005321) * t98 + PRT__R(-0.661437827766147647625) * t103;
    const prt_real t105 = t7 * t59 - t16 * t61;
    const prt_real t106 = PRT__R(0.739509972887452005321) * t94 + PRT__R(-0.661437827766147647625) * t95;
    const prt_real t107 = t106 + PRT__R(0.125) * t97;
    const prt_real t108 = t7 * t61 + t16 * t59;
    const prt_real t109 = PRT__R(-0.935414346693485346396) * t100 + PRT__R(0.3535533905932737622) * t101;
    const prt_real t110 = t105 * t107 + t108 * t109;
    const prt_real t111 = t104 + PRT__R(0.125) * t110;
    out[16] = t71 * t92 + t93 * t111;
    const prt_real t112 = t59 * t90 - t61 * t89;
    const prt_real t113 = t7 * t87 - t16 * t80;
    const prt_real t114 = PRT__R(0.75) * t112 + PRT__R(-0.661437827766147647625) * t113;
    const prt_real t115 = t105 * t109 - t108 * t107;
    const prt_real t116 = t26 * t102 - t29 * t99;
    const prt_real t117 = PRT__R(0.3535533905932737622) * t115 + PRT__R(-0.935414346693485346396) * t116;
    out[17] = t35 * t114 + t51 * t117;
    const prt_real t118 = PRT__R(-0.3535533905932737622) * t88 + PRT__R(-0.935414346693485346396) * t91;
    const prt_real t119 = (PRT__R(0.559016994374947424102) * t98 + PRT__R(0.5) * t103) + PRT__R(-0.661437827766147647625) * t110;
    out[18] = t6 * t118 + t22 * t119;
    const prt_real t120 = PRT__R(-0.661437827766147647625) * t112 + PRT__R(-0.75) * t113;
    const prt_real t121 = PRT__R(-0.935414346693485346396) * t115 + PRT__R(-0.3535533905932737622) * t116;
    out[19] = t4 * t120 + t5 * t121;
    const prt_real t122 = PRT__R(0.375) * t98 + PRT__R(0.559016994374947424102) * t103;
    out[20] = t122 + PRT__R(0.739509972887452005321) * t110;
    out[21] = t4 * t121 - t5 * t120;
    out[22] = t6 * t119 - t22 * t118;
    out[23] = t35 * t117 - t51 * t114;
    out[24] = t71 * t111 - t93 * t92;
    const prt_real t123 = t4 * t71 - t5 * t93;
    const prt_real t124 = f[25];
    const prt_real t125 = t9 * t73 - t10 * t75;
    const prt_real t126 = f[35];
    const prt_real t127 = t9 * t75 + t10 * t73;
    const prt_real t128 = t124 * t125 + t126 * t127;
    const prt_real t129 = f[27];
    const prt_real t130 = f[33];
    const prt_real t131 = t129 * t37 + t130 * t39;
    const prt_real t132 = PRT__R(0.701560760020114009797) * t128 + PRT__R(0.522912516583797217486) * t131;
    const prt_real t133 = f[29];
    const prt_real t134 = f[31];
    const prt_real t135 = t133 * t9 + t134 * t10;
    const prt_real t136 = t132 + PRT__R(0.484122918275927110647) * t135;
    const prt_real t137 = PRT__R(-0.684653196881457641821) * t128 + PRT__R(0.306186217847897262275) * t131;
    const prt_real t138 = t137 + PRT__R(0.661437827766147647625) * t135;
    const prt_real t139 = f[26];
    const prt_real t140 = f[34];
    const prt_real t141 = t139 * t73 + t140 * t75;
    const prt_real t142 = f[28];
    const prt_real t143 = f[32];
    const prt_real t144 = t142 * t11 + t143 * t14;
    const prt_real t145 = PRT__R(-0.866025403784438646764) * t141 + PRT__R(-0.5) * t144;
    const prt_real t146 = t26 * t138 + t29 * t145;
    const prt_real t147 = PRT__R(0.701560760020114009797) * t136 + PRT__R(-0.684653196881457641821) * t146;
    const prt_real t148 = PRT__R(0.19764235376052370825) * t128 + PRT__R(-0.795495128834865964951) * t131;
    const prt_real t149 = t148 + PRT__R(0.572821961869480000824) * t135;
    const prt_real t150 = PRT__R(0.5) * t141 + PRT__R(-0.866025403784438646764) * t144;
    const prt_real t151 = t105 * t149 + t108 * t150;
    const prt_real t152 = t147 + PRT__R(0.19764235376052370825) * t151;
    const prt_real t153 = t4 * t93 + t5 * t71;
    const prt_real t154 = t134 * t9 - t133 * t10;
    const prt_real t155 = t130 * t37 - t129 * t39;
    const prt_real t156 = PRT__R(0.125) * t154 + PRT__R(0.405046293650491264435) * t155;
    const prt_real t157 = t126 * t125 - t124 * t127;
    const prt_real t158 = t156 + PRT__R(0.905711046636839910857) * t157;
    const prt_real t159 = f[30];
    const prt_real t160 = t143 * t11 - t142 * t14;
    const prt_real t161 = PRT__R(0.484122918275927110647) * t159 + PRT__R(0.661437827766147647625) * t160;
    const prt_real t162 = t140 * t73 - t139 * t75;
    const prt_real t163 = t161 + PRT__R(0.572821961869480000824) * t162;
    const prt_real t164 = t7 * t158 + t16 * t163;
    const prt_real t165 = PRT__R(0.405046293650491264435) * t154 + PRT__R(0.8125) * t155;
    const prt_real t166 = t165 + PRT__R(-0.419262745781210568077) * t157;
    const prt_real t167 = PRT__R(0.522912516583797217486) * t159 + PRT__R(0.306186217847897262275) * t160;
    const prt_real t168 = t167 + PRT__R(-0.795495128834865964951) * t162;
    const prt_real t169 = t59 * t166 + t61 * t168;
    const prt_real t170 = PRT__R(0.905711046636839910857) * t164 + PRT__R(-0.419262745781210568077) * t169;
    const prt_real t171 = t7 * t105 - t16 * t108;
    const prt_real t172 = PRT__R(0.905711046636839910857) * t154 + PRT__R(-0.419262745781210568077) * t155;
    const prt_real t173 = t172 + PRT__R(0.0625) * t157;
    const prt_real t174 = t7 * t108 + t16 * t105;
    const prt_real t175 = PRT__R(0.701560760020114009797) * t159 + PRT__R(-0.684653196881457641821) * t160;
    const prt_real t176 = t175 + PRT__R(0.19764235376052370825) * t162;
    const prt_real t177 = t171 * t173 + t174 * t176;
    const prt_real t178 = t170 + PRT__R(0.0625) * t177;
    out[25] = t123 * t152 + t153 * t178;
    const prt_real t179 = t105 * t150 - t108 * t149;
    const prt_real t180 = t26 * t145 - t29 * t138;
    const prt_real t181 = PRT__R(0.5) * t179 + PRT__R(-0.866025403784438646764) * t180;
    const prt_real t182 = t171 * t176 - t174 * t173;
    const prt_real t183 = t59 * t168 - t61 * t166;
    const prt_real t184 = PRT__R(0.19764235376052370825) * t182 + PRT__R(-0.795495128834865964951) * t183;
    const prt_real t185 = t7 * t163 - t16 * t158;
    const prt_real t186 = t184 + PRT__R(0.572821961869480000824) * t185;
    out[26] = t71 * t181 + t93 * t186;
    const prt_real t187 = PRT__R(0.522912516583797217486) * t136 + PRT__R(0.306186217847897262275) * t146;
    const prt_real t188 = t187 + PRT__R(-0.795495128834865964951) * t151;
    const prt_real t189 = PRT__R(0.405046293650491264435) * t164 + PRT__R(0.8125) * t169;
    const prt_real t190 = t189 + PRT__R(-0.419262745781210568077) * t177;
    out[27] = t35 * t188 + t51 * t190;
    const prt_real t191 = PRT__R(-0.866025403784438646764) * t179 + PRT__R(-0.5) * t180;
    const prt_real t192 = PRT__R(-0.684653196881457641821) * t182 + PRT__R(0.306186217847897262275) * t183;
    const prt_real t193 = t192 + PRT__R(0.661437827766147647625) * t185;
    out[28] = t6 * t191 + t22 * t193;
    const prt_real t194 = PRT__R(0.484122918275927110647) * t136 + PRT__R(0.661437827766147647625) * t146;
    const prt_real t195 = t194 + PRT__R(0.572821961869480000824) * t151;
    const prt_real t196 = PRT__R(0.125) * t164 + PRT__R(0.405046293650491264435) * t169;
    const prt_real t197 = t196 + PRT__R(0.905711046636839910857) * t177;
    out[29] = t4 * t195 + t5 * t197;
    const prt_real t198 = PRT__R(0.701560760020114009797) * t182 + PRT__R(0.522912516583797217486) * t183;
    out[30] = t198 + PRT__R(0.484122918275927110647) * t185;
    out[31] = t4 * t197 - t5 * t195;
    out[32] = t6 * t193 - t22 * t191;
    out[33] = t35 * t190 - t51 * t188;
    out[34] = t71 * t186 - t93 * t181;
    out[35] = t123 * t178 - t153 * t152;
}

/* rotation of one vector by r and by turn, cos and sin of a, b, g, 7 bands: 528 multiplications, 296 additions (293 can fuse), 64 loads, 49 stores */
PRT__STATIC void prt__sh_rotate_7(const prt_real *r, const prt_real *turn, const prt_real *f, 
    prt_real *PRT__RESTRICT out) {
    out[0] = f[0];
    const prt_real t1 = f[1];
    const prt_real t2 = f[2];
    const prt_real t3 = f[3];
    out[1] = (r[4] * t1 + r[5] * t2) + r[3] * t3;
    out[2] = (r[7] * t1 + r[8] * t2) + r[6] * t3;
    out[3] = (r[1] * t1 + r[2] * t2) + r[0] * t3;
    const prt_real t4 = turn[0];
    const prt_real t5 = turn[1];
    const prt_real t6 = t4 * t4 - t5 * t5;
    const prt_real t7 = turn[2];
    const prt_real t8 = f[4];
    const prt_real t9 = turn[4];
    const prt_real t10 = turn[5];
    const prt_real t11 = t9 * t9 - t10 * t10;
    const prt_real t12 = f[8];
    const prt_real t13 = t9 * t10;
    const prt_real t14 = t13 + t13;
    const prt_real t15 = t8 * t11 + t12 * t14;
    const prt_real t16 = turn[3];
    const prt_real t17 = f[5];
    const prt_real t18 = f[7];
    const prt_real t19 = t17 * t9 + t18 * t10;
    const prt_real t20 = t7 * t15 + t16 * t19;
    const prt_real t21 = t4 * t5;
    const prt_real t22 = t21 + t21;
    const prt_real t23 = f[6];
    const prt_real t24 = t12 * t11 - t8 * t14;
    const prt_real t25 = PRT__R(-0.5) * t23 + PRT__R(-0.866025403784438646764) * t24;
    const prt_real t26 = t7 * t7 - t16 * t16;
    const prt_real t27 = PRT__R(-0.866025403784438646764) * t23 + PRT__R(0.5) * t24;
    const prt_real t28 = t7 * t16;
    const prt_real t29 = t28 + t28;
    const prt_real t30 = t18 * t9 - t17 * t10;
    const prt_real t31 = t26 * t27 + t29 * t30;
    const prt_real t32 = PRT__R(-0.866025403784438646764) * t25 + PRT__R(0.5) * t31;
    out[4] = t6 * t20 + t22 * t32;
    const prt_real t33 = t7 * t19 - t16 * t15;
    const prt_real t34 = t26 * t30 - t29 * t27;
    out[5] = t4 * t33 + t5 * t34;
    out[6] = PRT__R(-0.5) * t25 + PRT__R(-0.866025403784438646764) * t31;
    out[7] = t4 * t34 - t5 * t33;
    out[8] = t6 * t32 - t22 * t20;
    const prt_real t35 = t4 * t6 - t5 * t22;
    const prt_real t36 = f[9];
    const prt_real t37 = t9 * t11 - t10 * t14;
    const prt_real t38 = f[15];
    const prt_real t39 = t9 * t14 + t10 * t11;
    const prt_real t40 = t36 * t37 + t38 * t39;
    const prt_real t41 = f[11];
    const prt_real t42 = f[13];
    const prt_real t43 = t41 * t9 + t42 * t10;
    const prt_real t44 = PRT__R(-0.790569415042094833) * t40 + PRT__R(-0.612372435695794524549) * t43;
    const prt_real t45 = PRT__R(0.612372435695794524549) * t40 + PRT__R(-0.790569415042094833) * t43;
    const prt_real t46 = f[10];
    const prt_real t47 = f[14];
    const prt_real t48 = t46 * t11 + t47 * t14;
    const prt_real t49 = t26 * t45 + t29 * t48;
    const prt_real t50 = PRT__R(-0.790569415042094833) * t44 + PRT__R(0.612372435695794524549) * t49;
    const prt_real t51 = t4 * t22 + t5 * t6;
    const prt_real t52 = t42 * t9 - t41 * t10;
    const prt_real t53 = t38 * t37 - t36 * t39;
    const prt_real t54 = PRT__R(-0.25) * t52 + PRT__R(-0.968245836551854221295) * t53;
    const prt_real t55 = f[12];
    const prt_real t56 = t47 * t11 - t46 * t14;
    const prt_real t57 = PRT__R(-0.612372435695794524549) * t55 + PRT__R(-0.790569415042094833) * t56;
    const prt_real t58 = t7 * t54 + t16 * t57;
    const prt_real t59 = t7 * t26 - t16 * t29;
    const prt_real t60 = PRT__R(-0.968245836551854221295) * t52 + PRT__R(0.25) * t53;
    const prt_real t61 = t7 * t29 + t16 * t26;
    const prt_real t62 = PRT__R(-0.790569415042094833) * t55 + PRT__R(0.612372435695794524549) * t56;
    const prt_real t63 = t59 * t60 + t61 * t62;
    const prt_real t64 = PRT__R(-0.968245836551854221295) * t58 + PRT__R(0.25) * t63;
    out[9] = t35 * t50 + t51 * t64;
    const prt_real t65 = t26 * t48 - t29 * t45;
    const prt_real t66 = t59 * t62 - t61 * t60;
    const prt_real t67 = t7 * t57 - t16 * t54;
    const prt_real t68 = PRT__R(0.612372435695794524549) * t66 + PRT__R(-0.790569415042094833) * t67;
    out[10] = t6 * t65 + t22 * t68;
    const prt_real t69 = PRT__R(-0.612372435695794524549) * t44 + PRT__R(-0.790569415042094833) * t49;
    const prt_real t70 = PRT__R(-0.25) * t58 + PRT__R(-0.968245836551854221295) * t63;
    out[11] = t4 * t69 + t5 * t70;
    out[12] = PRT__R(-0.790569415042094833) * t66 + PRT__R(-0.612372435695794524549) * t67;
    out[13] = t4 * t70 - t5 * t69;
    out[14] = t6 * t68 - t22 * t65;
    out[15] = t35 * t64 - t51 * t50;
    const prt_real t71 = t4 * t35 - t5 * t51;
    const prt_real t72 = f[16];
    const prt_real t73 = t9 * t37 - t10 * t39;
    const prt_real t74 = f[24];
    const prt_real t75 = t9 * t39 + t10 * t37;
    const prt_real t76 = t72 * t73 + t74 * t75;
    const prt_real t77 = f[18];
    const prt_real t78 = f[22];
    const prt_real t79 = t77 * t11 + t78 * t14;
    const prt_real t80 = PRT__R(-0.935414346693485346396) * t76 + PRT__R(-0.3535533905932737622) * t79;
    const prt_real t81 = f[17];
    const prt_real t82 = f[23];
    const prt_real t83 = t81 * t37 + t82 * t39;
    const prt_real t84 = f[19];
    const prt_real t85 = f[21];
    const prt_real t86 = t84 * t9 + t85 * t10;
    const prt_real t87 = PRT__R(-0.661437827766147647625) * t83 + PRT__R(-0.75) * t86;
    const prt_real t88 = t7 * t80 + t16 * t87;
    const prt_real t89 = PRT__R(0.3535533905932737622) * t76 + PRT__R(-0.935414346693485346396) * t79;
    const prt_real t90 = PRT__R(0.75) * t83 + PRT__R(-0.661437827766147647625) * t86;
    const prt_real t91 = t59 * t89 + t61 * t90;
    const prt_real t92 = PRT__R(-0.935414346693485346396) * t88 + PRT__R(0.3535533905932737622) * t91;
    const prt_real t93 = t4 * t51 + t5 * t35;
    const prt_real t94 = f[20];
    const prt_real t95 = t78 * t11 - t77 * t14;
    const prt_real t96 = PRT__R(0.375) * t94 + PRT__R(0.559016994374947424102) * t95;
    const prt_real t97 = t74 * t73 - t72 * t75;
    const prt_real t98 = t96 + PRT__R(0.739509972887452005321) * t97;
    const prt_real t99 = (PRT__R(0.559016994374947424102) * t94 + PRT__R(0.5) * t95) + PRT__R(-0.661437827766147647625) * t97;
    const prt_real t100 = t85 * t9 - t84 * t10;
    const prt_real t101 = t82 * t37 - t81 * t39;
    const prt_real t102 = PRT__R(-0.3535533905932737622) * t100 + PRT__R(-0.935414346693485346396) * t101;
    const prt_real t103 = t26 * t99 + t29 * t102;
    const prt_real t104 = PRT__R(0.739509972887452005321) * t98 + PRT__R(-0.661437827766147647625) * t103;
    const prt_real t105 = t7 * t59 - t16 * t61;
    const prt_real t106 = PRT__R(0.739509972887452005321) * t94 + PRT__R(-0.661437827766147647625) * t95;
    const prt_real t107 = t106 + PRT__R(0.125) * t97;
    const prt_real t108 = t7 * t61 + t16 * t59;
    const prt_real t109 = PRT__R(-0.935414346693485346396) * t100 + PRT__R(0.3535533905932737622) * t101;
    const prt_real t110 = t105 * t107 + t108 * t109;
    const prt_real t111 = t104 + PRT__R(0.125) * t110;
    out[16] = t71 * t92 + t93 * t111;
    const prt_real t112 = t59 * t90 - t61 * t89;
    const prt_real t113 = t7 * t87 - t16 * t80;
    const prt_real t114 = PRT__R(0.75) * t112 + PRT__R(-0.661437827766147647625) * t113;
    const prt_real t115 = t105 * t109 - t108 * t107;
    const prt_real t116 = t26 * t102 - t29 * t99;
    const prt_real t117 = PRT__R(0.3535533905932737622) * t115 + PRT__R(-0.935414346693485346396) * t116;
    out[17] = t35 * t114 + t51 * t117;
    const prt_real t118 = PRT__R(-0.3535533905932737622) * t88 + PRT__R(-0.935414346693485346396) * t91;
    const prt_real t119 = (PRT__R(0.559016994374947424102) * t98 + PRT__R(0.5) * t103) + PRT__R(-0.661437827766147647625) * t110;
    out[18] = t6 * t118 + t22 * t119;
    const prt_real t120 = PRT__R(-0.661437827766147647625) * t112 + PRT__R(-0.75) * t113;
    const prt_real t121 = PRT__R(-0.935414346693485346396) * t115 + PRT__R(-0.3535533905932737622) * t116;
    out[19] = t4 * t120 + t5 * t121;
    const prt_real t122 = PRT__R(0.375) * t98 + PRT__R(0.559016994374947424102) * t103;
    out[20] = t122 + PRT__R(0.739509972887452005321) * t110;
    out[21] = t4 * t121 - t5 * t120;
    out[22] = t6 * t119 - t22 * t118;
    out[23] = t35 * t117 - t51 * t114;
    out[24] = t71 * t111 - t93 * t92;
    const prt_real t123 = t4 * t71 - t5 * t93;
    const prt_real t124 = f[25];
    const prt_real t125 = t9 * t73 - t10 * t75;
    const prt_real t126 = f[35];
    const prt_real t127 = t9 * t75 + t10 * t73;
    const prt_real t128 = t124 * t125 + t126 * t127;
    const prt_real t129 = f[27];
    const prt_real t130 = f[33];
    const prt_real t131 = t129 * t37 + t130 * t39;
    const prt_real t132 = PRT__R(0.701560760020114009797) * t128 + PRT__R(0.522912516583797217486) * t131;
    const prt_real t133 = f[29];
    const prt_real t134 = f[31];
    const prt_real t135 = t133 * t9 + t134 * t10;
    const prt_real t136 = t132 + PRT__R(0.484122918275927110647) * t135;
    const prt_real t137 = PRT__R(-0.684653196881457641821) * t128 + PRT__R(0.306186217847897262275) * t131;
    const prt_real t138 = t137 + PRT__R(0.661437827766147647625) * t135;
    const prt_real t139 = f[26];
    const prt_real t140 = f[34];
    const prt_real t141 = t139 * t73 + t140 * t75;
    const prt_real t142 = f[28];
    const prt_real t143 = f[32];
    const prt_real t144 = t142 * t11 + t143 * t14;
    const prt_real t145 = PRT__R(-0.866025403784438646764) * t141 + PRT__R(-0.5) * t144;
    const prt_real t146 = t26 * t138 + t29 * t145;
    const prt_real t147 = PRT__R(0.701560760020114009797) * t136 + PRT__R(-0.684653196881457641821) * t146;
    const prt_real t148 = PRT__R(0.19764235376052370825) * t128 + PRT__R(-0.795495128834865964951) * t131;
    const prt_real t149 = t148 + PRT__R(0.572821961869480000824) * t135;
    const prt_real t150 = PRT__R(0.5) * t141 + PRT__R(-0.866025403784438646764) * t144;
    const prt_real t151 = t105 * t149 + t108 * t150;
    const prt_real t152 = t147 + PRT__R(0.19764235376052370825) * t151;
    const prt_real t153 = t4 * t93 + t5 * t71;
    const prt_real t154 = t134 * t9 - t133 * t10;
    const prt_real t155 = t130 * t37 - t129 * t39;
    const prt_real t156 = PRT__R(0.125) * t154 + PRT__R(0.405046293650491264435) * t155;
    const prt_real t157 = t126 * t125 - t124 * t127;
    const prt_real t158 = t156 + PRT__R(0.905711046636839910857) * t157;
    const prt_real t159 = f[30];
    const prt_real t160 = t143 * t11 - t142 * t14;
    const prt_real t161 = PRT__R(0.484122918275927110647) * t159 + PRT__R(0.661437827766147647625) * t160;
    const prt_real t162 = t140 * t73 - t139 * t75;
    const prt_real t163 = t161 + PRT__R(0.572821961869480000824) * t162;
    const prt_real t164 = t7 * t158 + t16 * t163;
    const prt_real t165 = PRT__R(0.405046293650491264435) * t154 + PRT__R(0.8125) * t155;
    const prt_real t166 = t165 + PRT__R(-0.419262745781210568077) * t157;
    const prt_real t167 = PRT__R(0.522912516583797217486) * t159 + PRT__R(0.306186217847897262275) * t160;
    const prt_real t168 = t167 + PRT__R(-0.795495128834865964951) * t162;
    const prt_real t169 = t59 * t166 + t61 * t168;
    const prt_real t170 = PRT__R(0.905711046636839910857) * t164 + PRT__R(-0.419262745781210568077) * t169;
    const prt_real t171 = t7 * t105 - t16 * t108;
    const prt_real t172 = PRT__R(0.905711046636839910857) * t154 + PRT__R(-0.419262745781210568077) * t155;
    const prt_real t173 = t172 + PRT__R(0.0625) * t157;
    const prt_real t174 = t7 * t108 + t16 * t105;
    const prt_real t175 = PRT__R(0.701560760020114009797) * t159 + PRT__R(-0.684653196881457641821) * t160;
    const prt_real t176 = t175 + PRT__R(0.19764235376052370825) * t162;
    const prt_real t177 = t171 * t173 + t174 * t176;
    const prt_real t178 = t170 + PRT__R(0.0625) * t177;
    out[25] = t123 * t152 + t153 * t178;
    const prt_real t179 = t105 * t150 - t108 * t149;
    const prt_real t180 = t26 * t145 - t29 * t138;
    const prt_real t181 = PRT__R(0.5) * t179 + PRT__R(-0.866025403784438646764) * t180;
    const prt_real t182 = t171 * t176 - t174 * t173;
    const prt_real t183 = t59 * t168 - t61 * t166;
    const prt_real t184 = PRT__R(0.19764235376052370825) * t182 + PRT__R(-0.795495128834865964951) * t183;
    const prt_real t185 = t7 * t163 - t16 * t158;
    const prt_real t186 = t184 + PRT__R(0.572821961869480000824) * t185;
    out[26] = t71 * t181 + t93 * t186;
    const prt_real t187 = PRT__R(0.522912516583797217486) * t136 + PRT__R(0.306186217847897262275) * t146;
    const prt_real t188 = t187 + PRT__R(-0.795495128834865964951) * t151;
    const prt_real t189 = PRT__R(0.405046293650491264435) * t164 + PRT__R(0.8125) * t169;
    const prt_real t190 = t189 + PRT__R(-0.419262745781210568077) * t177;
    out[27] = t35 * t188 + t51 * t190;
    const prt_real t191 = PRT__R(-0.866025403784438646764) * t179 + PRT__R(-0.5) * t180;
    const prt_real t192 = PRT__R(-0.684653196881457641821) * t182 + PRT__R(0.306186217847897262275) * t183;
    const prt_real t193 = t192 + PRT__R(0.661437827766147647625) * t185;
    out[28] = t6 * t191 + t22 * t193;
    const prt_real t194 = PRT__R(0.484122918275927110647) * t136 + PRT__R(0.661437827766147647625) * t146;
    const prt_real t195 = t194 + PRT__R(0.572821961869480000824) * t151;
    const prt_real t196 = PRT__R(0.125) * t164 + PRT__R(0.405046293650491264435) * t169;
    const prt_real t197 = t196 + PRT__R(0.905711046636839910857) * t177;
    out[29] = t4 * t195 + t5 * t197;
    const prt_real t198 = PRT__R(0.701560760020114009797) * t182 + PRT__R(0.522912516583797217486) * t183;
    out[30] = t198 + PRT__R(0.484122918275927110647) * t185;
    out[31] = t4 * t197 - t5 * t195;
    out[32] = t6 * t193 - t22 * t191;
    out[33] = t35 * t190 - t51 * t188;
    out[34] = t71 * t186 - t93 * t181;
    out[35] = t123 * t178 - t153 * t152;
    const prt_real t199 = t4 * t123 - t5 * t153;
    const prt_real t200 = f[36];
    const prt_real t201 = t9 * t125 - t10 * t127;
    const prt_real t202 = f[48];
    const prt_real t203 = t9 * t127 + t10 * t125;
    const prt_real t204 = t200 * t201 + t202 * t203;
    const prt_real t205 = f[38];
    const prt_real t206 = f[46];
    const prt_real t207 = t205 * t73 + t206 * t75;
    const prt_real t208 = PRT__R(0.879452954966893041481) * t204 + PRT__R(0.433012701892219323382) * t207;
    const prt_real t209 = f[40];
    const prt_real t210 = f[44];
    const prt_real t211 = t209 * t11 + t210 * t14;
    const prt_real t212 = t208 + PRT__R(0.19764235376052370825) * t211;
    const prt_real t213 = f[37];
    const prt_real t214 = f[47];
    const prt_real t215 = t213 * t125 + t214 * t127;
    const prt_real t216 = f[39];
    const prt_real t217 = f[45];
    const prt_real t218 = t216 * t37 + t217 * t39;
    const prt_real t219 = PRT__R(0.507752400289747522529) * t215 + PRT__R(0.59292706128157112475) * t218;
    const prt_real t220 = f[41];
    const prt_real t221 = f[43];
    const prt_real t222 = t220 * t9 + t221 * t10;
    const prt_real t223 = t219 + PRT__R(0.625) * t222;
    const prt_real t224 = t7 * t212 + t16 * t223;
    const prt_real t225 = PRT__R(-0.463512405443478934294) * t204 + PRT__R(0.684653196881457641821) * t207;
    const prt_real t226 = t225 + PRT__R(0.5625) * t211;
    const prt_real t227 = PRT__R(-0.802827036166570563757) * t215 + PRT__R(0.0625) * t218;
    const prt_real t228 = t227 + PRT__R(0.59292706128157112475) * t222;
    const prt_real t229 = t59 * t226 + t61 * t228;
    const prt_real t230 = PRT__R(0.879452954966893041481) * t224 + PRT__R(-0.463512405443478934294) * t229;
    const prt_real t231 = PRT__R(0.108253175473054830845) * t204 + PRT__R(-0.586301969977928694321) * t207;
    const prt_real t232 = t231 + PRT__R(0.802827036166570563757) * t211;
    const prt_real t233 = PRT__R(0.3125) * t215 + PRT__R(-0.802827036166570563757) * t218;
    const prt_real t234 = t233 + PRT__R(0.507752400289747522529) * t222;
    const prt_real t235 = t171 * t232 + t174 * t234;
    const prt_real t236 = t230 + PRT__R(0.108253175473054830845) * t235;
    const prt_real t237 = t4 * t153 + t5 * t123;
    const prt_real t238 = f[42];
    const prt_real t239 = t210 * t11 - t209 * t14;
    const prt_real t240 = PRT__R(-0.3125) * t238 + PRT__R(-0.452855523318419955429) * t239;
    const prt_real t241 = t206 * t73 - t205 * t75;
    const prt_real t242 = t202 * t201 - t200 * t203;
    const prt_real t243 = (t240 + PRT__R(-0.496078370824610735719) * t241) + PRT__R(-0.671693289381396157476) * t242;
    const prt_real t244 = PRT__R(-0.452855523318419955429) * t238 + PRT__R(-0.53125) * t239;
    const prt_real t245 = (t244 + PRT__R(-0.171163299220364410455) * t241) + PRT__R(0.695268608165218401442) * t242;
    const prt_real t246 = t221 * t9 - t220 * t10;
    const prt_real t247 = t217 * t37 - t216 * t39;
    const prt_real t248 = PRT__R(0.19764235376052370825) * t246 + PRT__R(0.5625) * t247;
    const prt_real t249 = t214 * t125 - t213 * t127;
    const prt_real t250 = t248 + PRT__R(0.802827036166570563757) * t249;
    const prt_real t251 = t26 * t245 + t29 * t250;
    const prt_real t252 = PRT__R(-0.671693289381396157476) * t243 + PRT__R(0.695268608165218401442) * t251;
    const prt_real t253 = PRT__R(-0.496078370824610735719) * t238 + PRT__R(-0.171163299220364410455) * t239;
    const prt_real t254 = (t253 + PRT__R(0.8125) * t241) + PRT__R(-0.253876200144873761264) * t242;
    const prt_real t255 = PRT__R(0.433012701892219323382) * t246 + PRT__R(0.684653196881457641821) * t247;
    const prt_real t256 = t255 + PRT__R(-0.586301969977928694321) * t249;
    const prt_real t257 = t105 * t254 + t108 * t256;
    const prt_real t258 = t7 * t171 - t16 * t174;
    const prt_real t259 = PRT__R(-0.671693289381396157476) * t238 + PRT__R(0.695268608165218401442) * t239;
    const prt_real t260 = (t259 + PRT__R(-0.253876200144873761264) * t241) + PRT__R(0.03125) * t242;
    const prt_real t261 = t7 * t174 + t16 * t171;
    const prt_real t262 = PRT__R(0.879452954966893041481) * t246 + PRT__R(-0.463512405443478934294) * t247;
    const prt_real t263 = t262 + PRT__R(0.108253175473054830845) * t249;
    const prt_real t264 = t258 * t260 + t261 * t263;
    const prt_real t265 = (t252 + PRT__R(-0.253876200144873761264) * t257) + PRT__R(0.03125) * t264;
    out[36] = t199 * t236 + t237 * t265;
    const prt_real t266 = t171 * t234 - t174 * t232;
    const prt_real t267 = t59 * t228 - t61 * t226;
    const prt_real t268 = PRT__R(0.3125) * t266 + PRT__R(-0.802827036166570563757) * t267;
    const prt_real t269 = t7 * t223 - t16 * t212;
    const prt_real t270 = t268 + PRT__R(0.507752400289747522529) * t269;
    const prt_real t271 = t258 * t263 - t261 * t260;
    const prt_real t272 = t105 * t256 - t108 * t254;
    const prt_real t273 = PRT__R(0.108253175473054830845) * t271 + PRT__R(-0.586301969977928694321) * t272;
    const prt_real t274 = t26 * t250 - t29 * t245;
    const prt_real t275 = t273 + PRT__R(0.802827036166570563757) * t274;
    out[37] = t123 * t270 + t153 * t275;
    const prt_real t276 = PRT__R(0.433012701892219323382) * t224 + PRT__R(0.684653196881457641821) * t229;
    const prt_real t277 = t276 + PRT__R(-0.586301969977928694321) * t235;
    const prt_real t278 = PRT__R(-0.496078370824610735719) * t243 + PRT__R(-0.171163299220364410455) * t251;
    const prt_real t279 = (t278 + PRT__R(0.8125) * t257) + PRT__R(-0.253876200144873761264) * t264;
    out[38] = t71 * t277 + t93 * t279;
    const prt_real t280 = PRT__R(-0.802827036166570563757) * t266 + PRT__R(0.0625) * t267;
    const prt_real t281 = t280 + PRT__R(0.59292706128157112475) * t269;
    const prt_real t282 = PRT__R(-0.463512405443478934294) * t271 + PRT__R(0.684653196881457641821) * t272;
    const prt_real t283 = t282 + PRT__R(0.5625) * t274;
    out[39] = t35 * t281 + t51 * t283;
    const prt_real t284 = PRT__R(0.19764235376052370825) * t224 + PRT__R(0.5625) * t229;
    const prt_real t285 = t284 + PRT__R(0.802827036166570563757) * t235;
    const prt_real t286 = PRT__R(-0.452855523318419955429) * t243 + PRT__R(-0.53125) * t251;
    const prt_real t287 = (t286 + PRT__R(-0.171163299220364410455) * t257) + PRT__R(0.695268608165218401442) * t264;
    out[40] = t6 * t285 + t22 * t287;
    const prt_real t288 = PRT__R(0.507752400289747522529) * t266 + PRT__R(0.59292706128157112475) * t267;
    const prt_real t289 = t288 + PRT__R(0.625) * t269;
    const prt_real t290 = PRT__R(0.879452954966893041481) * t271 + PRT__R(0.433012701892219323382) * t272;
    const prt_real t291 = t290 + PRT__R(0.19764235376052370825) * t274;
    out[41] = t4 * t289 + t5 * t291;
    const prt_real t292 = PRT__R(-0.3125) * t243 + PRT__R(-0.452855523318419955429) * t251;
    out[42] = (t292 + PRT__R(-0.496078370824610735719) * t257) + PRT__R(-0.671693289381396157476) * t264;
    out[43] = t4 * t291 - t5 * t289;
    out[44] = t6 * t287 - t22 * t285;
    out[45] = t35 * t283 - t51 * t281;
    out[46] = t71 * t279 - t93 * t277;
    out[47] = t123 * t275 - t153 * t270;
    out[48] = t199 * t265 - t237 * t236;
}

/* rotation of one vector by r and by turn, cos and sin of a, b, g, 8 bands: 738 multiplications, 428 additions (425 can fuse), 79 loads, 64 stores */
PRT__STATIC void prt__sh_rotate_8(const prt_real *r, const prt_real *turn, const prt_real *f, 
    prt_real *PRT__RESTRICT out) {
    out[0] = f[0];
    const prt_real t1 = f[1];
    const prt_real t2 = f[2];
    const prt_real t3 = f[3];
    out[1] = (r[4] * t1 + r[5] * t2) + r[3] * t3;
    out[2] = (r[7] * t1 + r[8] * t2) + r[6] * t3;
    out[3] = (r[1] * t1 + r[2] * t2) + r[0] * t3;
    const prt_real t4 = turn[0];
    const prt_real t5 = turn[1];
    const prt_real t6 = t4 * t4 - t5 * t5;
    const prt_real t7 = turn[2];
    const prt_real t8 = f[4];
    const prt_real t9 = turn[4];
    const prt_real t10 = turn[5];
    const prt_real t11 = t9 * t9 - t10 * t10;
    const prt_real t12 = f[8];
    const prt_real t13 = t9 * t10;
    const prt_real t14 = t13 + t13;
    const prt_real t15 = t8 * t11 + t12 * t14;
    const prt_real t16 = turn[3];
    const prt_real t17 = f[5];
    const prt_real t18 = f[7];
    const prt_real t19 = t17 * t9 + t18 * t10;
    const prt_real t20 = t7 * t15 + t16 * t19;
    const prt_real t21 = t4 * t5;
    const prt_real t22 = t21 + t21;
    const prt_real t23 = f[6];
    const prt_real t24 = t12 * t11 - t8 * t14;
    const prt_real t25 = PRT__R(-0.5) * t23 + PRT__R(-0.866025403784438646764) * t24;
    const prt_real t26 = t7 * t7 - t16 * t16;
    const prt_real t27 = PRT__R(-0.866025403784438646764) * t23 + PRT__R(0.5) * t24;
    const prt_real t28 = t7 * t16;
    const prt_real t29 = t28 + t28;
    const prt_real t30 = t18 * t9 - t17 * t10;
    const prt_real t31 = t26 * t27 + t29 * t30;
    const prt_real t32 = PRT__R(-0.866025403784438646764) * t25 + PRT__R(0.5) * t31;
    out[4] = t6 * t20 + t22 * t32;
    const prt_real t33 = t7 * t19 - t16 * t15;
    const prt_real t34 = t26 * t30 - t29 * t27;
    out[5] = t4 * t33 + t5 * t34;
    out[6] = PRT__R(-0.5) * t25 + PRT__R(-0.866025403784438646764) * t31;
    out[7] = t4 * t34 - t5 * t33;
    out[8] = t6 * t32 - t22 * t20;
    const prt_real t35 = t4 * t6 - t5 * t22;
    const prt_real t36 = f[9];
    const prt_real t37 = t9 * t11 - t10 * t14;
    const prt_real t38 = f[15];
    const prt_real t39 = t9 * t14 + t10 * t11;
    const prt_real t40 = t36 * t37 + t38 * t39;
    const prt_real t41 = f[11];
    const prt_real t42 = f[13];
    const prt_real t43 = t41 * t9 + t42 * t10;
    const prt_real t44 = PRT__R(-0.790569415042094833) * t40 + PRT__R(-0.612372435695794524549) * t43;
    const prt_real t45 = PRT__R(0.612372435695794524549) * t40 + PRT__R(-0.790569415042094833) * t43;
    const prt_real t46 = f[10];
    const prt_real t47 = f[14];
    const prt_real t48 = t46 * t11 + t47 * t14;
    const prt_real t49 = t26 * t45 + t29 * t48;
    const prt_real t50 = PRT__R(-0.790569415042094833) * t44 + PRT__R(0.612372435695794524549) * t49;
    const prt_real t51 = t4 * t22 + t5 * t6;
    const prt_real t52 = t42 * t9 - t41 * t10;
    const prt_real t53 = t38 * t37 - t36 * t39;
    const prt_real t54 = PRT__R(-0.25) * t52 + PRT__R(-0.968245836551854221295) * t53;
    const prt_real t55 = f[12];
    const prt_real t56 = t47 * t11 - t46 * t14;
    const prt_real t57 = PRT__R(-0.612372435695794524549) * t55 + PRT__R(-0.790569415042094833) * t56;
    const prt_real t58 = t7 * t54 + t16 * t57;
    const prt_real t59 = t7 * t26 - t16 * t29;
    const prt_real t60 = PRT__R(-0.968245836551854221295) * t52 + PRT__R(0.25) * t53;
    const prt_real t61 = t7 * t29 + t16 * t26;
    const prt_real t62 = PRT__R(-0.790569415042094833) * t55 + PRT__R(0.612372435695794524549) * t56;
    const prt_real t63 = t59 * t60 + t61 * t62;
    const prt_real t64 = PRT__R(-0.968245836551854221295) * t58 + PRT__R(0.25) * t63;
    out[9] = t35 * t50 + t51 * t64;
    const prt_real t65 = t26 * t48 - t29 * t45;
    const prt_real t66 = t59 * t62 - t61 * t60;
    const prt_real t67 = t7 * t57 - t16 * t54;
    const prt_real t68 = PRT__R(0.612372435695794524549) * t66 + PRT__R(-0.790569415042094833) * t67;
    out[10] = t6 * t65 + t22 * t68;
    const prt_real t69 = PRT__R(-0.612372435695794524549) * t44 + PRT__R(-0.790569415042094833) * t49;
    const prt_real t70 = PRT__R(-0.25) * t58 + PRT__R(-0.968245836551854221295) * t63;
    out[11] = t4 * t69 + t5 * t70;
    out[12] = PRT__R(-0.790569415042094833) * t66 + PRT__R(-0.612372435695794524549) * t67;
    out[13] = t4 * t70 - t5 * t69;
    out[14] = t6 * t68 - t22 * t65;
    out[15] = t35 * t64 - t51 * t50;
    const prt_real t71 = t4 * t35 - t5 * t51;
    const prt_real t72 = f[16];
    const prt_real t73 = t9 * t37 - t10 * t39;
    const prt_real t74 = f[24];
    const prt_real t75 = t9 * t39 + t10 * t37;
    const prt_real t76 = t72 * t73 + t74 * t75;
    const prt_real t77 = f[18];
    const prt_real t78 = f[22];
    const prt_real t79 = t77 * t11 + t78 * t14;
    const prt_real t80 = PRT__R(-0.935414346693485346396) * t76 + PRT__R(-0.3535533905932737622) * t79;
    const prt_real t81 = f[17];
    const prt_real t82 = f[23];
    const prt_real t83 = t81 * t37 + t82 * t39;
    const prt_real t84 = f[19];
    const prt_real t85 = f[21];
    const prt_real t86 = t84 * t9 + t85 * t10;
    const prt_real t87 = PRT__R(-0.661437827766147647625) * t83 + PRT__R(-0.75) * t86;
    const prt_real t88 = t7 * t80 + t16 * t87;
    const prt_real t89 = PRT__R(0.3535533905932737622) * t76 + PRT__R(-0.935414346693485346396) * t79;
    const prt_real t90 = PRT__R(0.75) * t83 + PRT__R(-0.661437827766147647625) * t86;
    const prt_real t91 = t59 * t89 + t61 * t90;
    const prt_real t92 = PRT__R(-0.935414346693485346396) * t88 + PRT__R(0.3535533905932737622) * t91;
    const prt_real t93 = t4 * t51 + t5 * t35;
    const prt_real t94 = f[20];
    const prt_real t95 = t78 * t11 - t77 * t14;
    const prt_real t96 = PRT__R(0.375) * t94 + PRT__R(0.559016994374947424102) * t95;
    const prt_real t97 = t74 * t73 - t72 * t75;
    const prt_real t98 = t96 + PRT__R(0.739509972887452005321) * t97;
    const prt_real t99 = (PRT__R(0.559016994374947424102) * t94 + PRT__R(0.5) * t95) + PRT__R(-0.661437827766147647625) * t97;
    const prt_real t100 = t85 * t9 - t84 * t10;
    const prt_real t101 = t82 * t37 - t81 * t39;
    const prt_real t102 = PRT__R(-0.3535533905932737622) * t100 + PRT__R(-0.935414346693485346396) * t101;
    const prt_real t103 = t26 * t99 + t29 * t102;
    const prt_real t104 = PRT__R(0.739509972887452005321) * t98 + PRT__R(-0.661437827766147647625) * t103;
    const prt_real t105 = t7 * t59 - t16 * t61;
    const prt_real t106 = PRT__R(0.739509972887452005321) * t94 + PRT__R(-0.661437827766147647625) * t95;
    const prt_real t107 = t106 + PRT__R(0.125) * t97;
    const prt_real t108 = t7 * t61 + t16 * t59;
    const prt_real t109 = PRT__R(-0.935414346693485346396) * t100 + PRT__R(0.3535533905932737622) * t101;
    const prt_real t110 = t105 * t107 + t108 * t109;
    const prt_real t111 = t104 + PRT__R(0.125) * t110;
    out[16] = t71 * t92 + t93 * t111;
    const prt_real t112 = t59 * t90 - t61 * t89;
    const prt_real t113 = t7 * t87 - t16 * t80;
    const prt_real t114 = PRT__R(0.75) * t112 + PRT__R(-0.661437827766147647625) * t113;
    const prt_real t115 = t105 * t109 - t108 * t107;
    const prt_real t116 = t26 * t102 - t29 * t99;
    const prt_real t117 = PRT__R(0.3535533905932737622) * t115 + PRT__R(-0.935414346693485346396) * t116;
    out[17] = t35 * t114 + t51 * t117;
    const prt_real t118 = PRT__R(-0.3535533905932737622) * t88 + PRT__R(-0.935414346693485346396) * t91;
    const prt_real t119 = (PRT__R(0.559016994374947424102) * t98 + PRT__R(0.5) * t103) + PRT__R(-0.661437827766147647625) * t110;
    out[18] = t6 * t118 + t22 * t119;
    const prt_real t120 = PRT__R(-0.661437827766147647625) * t112 + PRT__R(-0.75) * t113;
    const prt_real t121 = PRT__R(-0.935414346693485346396) * t115 + PRT__R(-0.3535533905932737622) * t116;
    out[19] = t4 * t120 + t5 * t121;
    const prt_real t122 = PRT__R(0.375) * t98 + PRT__R(0.559016994374947424102) * t103;
    out[20] = t122 + PRT__R(0.739509972887452005321) * t110;
    out[21] = t4 * t121 - t5 * t120;
    out[22] = t6 * t119 - t22 * t118;
    out[23] = t35 * t117 - t51 * t114;
    out[24] = t71 * t111 - t93 * t92;
    const prt_real t123 = t4 * t71 - t5 * t93;
    const prt_real t124 = f[25];
    const prt_real t125 = t9 * t73 - t10 * t75;
    const prt_real t126 = f[35];
    const prt_real t127 = t9 * t75 + t10 * t73;
    const prt_real t128 = t124 * t125 + t126 * t127;
    const prt_real t129 = f[27];
    const prt_real t130 = f[33];
    const prt_real t131 = t129 * t37 + t130 * t39;
    const prt_real t132 = PRT__R(0.701560760020114009797) * t128 + PRT__R(0.522912516583797217486) * t131;
    const prt_real t133 = f[29];
    const prt_real t134 = f[31];
    const prt_real t135 = t133 * t9 + t134 * t10;
    const prt_real t136 = t132 + PRT__R(0.484122918275927110647) * t135;
    const prt_real t137 = PRT__R(-0.684653196881457641821) * t128 + PRT__R(0.306186217847897262275) * t131;
    const prt_real t138 = t137 + PRT__R(0.661437827766147647625) * t135;
    const prt_real t139 = f[26];
    const prt_real t140 = f[34];
    const prt_real t141 = t139 * t73 + t140 * t75;
    const prt_real t142 = f[28];
    const prt_real t143 = f[32];
    const prt_real t144 = t142 * t11 + t143 * t14;
    const prt_real t145 = PRT__R(-0.866025403784438646764) * t141 + PRT__R(-0.5) * t144;
    const prt_real t146 = t26 * t138 + t29 * t145;
    const prt_real t147 = PRT__R(0.701560760020114009797) * t136 + PRT__R(-0.684653196881457641821) * t146;
    const prt_real t148 = PRT__R(0.19764235376052370825) * t128 + PRT__R(-0.795495128834865964951) * t131;
    const prt_real t149 = t148 + PRT__R(0.572821961869480000824) * t135;
    const prt_real t150 = PRT__R(0.5) * t141 + PRT__R(-0.866025403784438646764) * t144;
    const prt_real t151 = t105 * t149 + t108 * t150;
    const prt_real t152 = t147 + PRT__R(0.19764235376052370825) * t151;
    const prt_real t153 = t4 * t93 + t5 * t71;
    const prt_real t154 = t134 * t9 - t133 * t10;
    const prt_real t155 = t130 * t37 - t129 * t39;
    const prt_real t156 = PRT__R(0.125) * t154 + PRT__R(0.405046293650491264435) * t155;
    const prt_real t157 = t126 * t125 - t124 * t127;
    const prt_real t158 = t156 + PRT__R(0.905711046636839910857) * t157;
    const prt_real t159 = f[30];
    const prt_real t160 = t143 * t11 - t142 * t14;
    const prt_real t161 = PRT__R(0.484122918275927110647) * t159 + PRT__R(0.661437827766147647625) * t160;
    const prt_real t162 = t140 * t73 - t139 * t75;
    const prt_real t163 = t161 + PRT__R(0.572821961869480000824) * t162;
    const prt_real t164 = t7 * t158 + t16 * t163;
    const prt_real t165 = PRT__R(0.405046293650491264435) * t154 + PRT__R(0.8125) * t155;
    const prt_real t166 = t165 + PRT__R(-0.419262745781210568077) * t157;
    const prt_real t167 = PRT__R(0.522912516583797217486) * t159 + PRT__R(0.306186217847897262275) * t160;
    const prt_real t168 = t167 + PRT__R(-0.795495128834865964951) * t162;
    const prt_real t169 = t59 * t166 + t61 * t168;
    const prt_real t170 = PRT__R(0.905711046636839910857) * t164 + PRT__R(-0.419262745781210568077) * t169;
    const prt_real t171 = t7 * t105 - t16 * t108;
    const prt_real t172 = PRT__R(0.905711046636839910857) * t154 + PRT__R(-0.419262745781210568077) * t155;
    const prt_real t173 = t172 + PRT__R(0.0625) * t157;
    const prt_real t174 = t7 * t108 + t16 * t105;
    const prt_real t175 = PRT__R(0.701560760020114009797) * t159 + PRT__R(-0.684653196881457641821) * t160;
    const prt_real t176 = t175 + PRT__R(0.19764235376052370825) * t162;
    const prt_real t177 = t171 * t173 + t174 * t176;
    const prt_real t178 = t170 + PRT__R(0.0625) * t177;
    out[25] = t123 * t152 + t153 * t178;
    const prt_real t179 = t105 * t150 - t108 * t149;
    const prt_real t180 = t26 * t145 - t29 * t138;
    const prt_real t181 = PRT__R(0.5) * t179 + PRT__R(-0.866025403784438646764) * t180;
    const prt_real t182 = t171 * t176 - t174 * t173;
    const prt_real t183 = t59 * t168 - t61 * t166;
    const prt_real t184 = PRT__R(0.19764235376052370825) * t182 + PRT__R(-0.795495128834865964951) * t183;
    const prt_real t185 = t7 * t163 - t16 * t158;
    const prt_real t186 = t184 + PRT__R(0.572821961869480000824) * t185;
    out[26] = t71 * t181 + t93 * t186;
    const prt_real t187 = PRT__R(0.522912516583797217486) * t136 + PRT__R(0.306186217847897262275) * t146;
    const prt_real t188 = t187 + PRT__R(-0.795495128834865964951) * t151;
    const prt_real t189 = PRT__R(0.405046293650491264435) * t164 + PRT__R(0.8125) * t169;
    const prt_real t190 = t189 + PRT__R(-0.419262745781210568077) * t177;
    out[27] = t35 * t188 + t51 * t190;
    const prt_real t191 = PRT__R(-0.866025403784438646764) * t179 + PRT__R(-0.5) * t180;
    const prt_real t192 = PRT__R(-0.684653196881457641821) * t182 + PRT__R(0.306186217847897262275) * t183;
    const prt_real t193 = t192 + PRT__R(0.661437827766147647625) * t185;
    out[28] = t6 * t191 + t22 * t193;
    const prt_real t194 = PRT__R(0.484122918275927110647) * t136 + PRT__R(0.661437827766147647625) * t146;
    const prt_real t195 = t194 + PRT__R(0.572821961869480000824) * t151;
    const prt_real t196 = PRT__R(0.125) * t164 + PRT__R(0.405046293650491264435) * t169;
    const prt_real t197 = t196 + PRT__R(0.905711046636839910857) * t177;
    out[29] = t4 * t195 + t5 * t197;
    const prt_real t198 = PRT__R(0.701560760020114009797) * t182 + PRT__R(0.522912516583797217486) * t183;
    out[30] = t198 + PRT__R(0.484122918275927110647) * t185;
    out[31] = t4 * t197 - t5 * t195;
    out[32] = t6 * t193 - t22 * t191;
    out[33] = t35 * t190 - t51 * t188;
    out[34] = t71 * t186 - t93 * t181;
    out[35] = t123 * t178 - t153 * t152;
    const prt_real t199 = t4 * t123 - t5 * t153;
    const prt_real t200 = f[36];
    const prt_real t201 = t9 * t125 - t10 * t127;
    const prt_real t202 = f[48];
    const prt_real t203 = t9 * t127 + t10 * t125;
    const prt_real t204 = t200 * t201 + t202 * t203;
    const prt_real t205 = f[38];
    const prt_real t206 = f[46];
    const prt_real t207 = t205 * t73 + t206 * t75;
    const prt_real t208 = PRT__R(0.879452954966893041481) * t204 + PRT__R(0.433012701892219323382) * t207;
    const prt_real t209 = f[40];
    const prt_real t210 = f[44];
    const prt_real t211 = t209 * t11 + t210 * t14;
    const prt_real t212 = t208 + PRT__R(0.19764235376052370825) * t211;
    const prt_real t213 = f[37];
    const prt_real t214 = f[47];
    const prt_real t215 = t213 * t125 + t214 * t127;
    const prt_real t216 = f[39];
    const prt_real t217 = f[45];
    const prt_real t218 = t216 * t37 + t217 * t39;
    const prt_real t219 = PRT__R(0.507752400289747522529) * t215 + PRT__R(0.59292706128157112475) * t218;
    const prt_real t220 = f[41];
    const prt_real t221 = f[43];
    const prt_real t222 = t220 * t9 + t221 * t10;
    const prt_real t223 = t219 + PRT__R(0.625) * t222;
    const prt_real t224 = t7 * t212 + t16 * t223;
    const prt_real t225 = PRT__R(-0.463512405443478934294) * t204 + PRT__R(0.684653196881457641821) * t207;
    const prt_real t226 = t225 + PRT__R(0.5625) * t211;
    const prt_real t227 = PRT__R(-0.802827036166570563757) * t215 + PRT__R(0.0625) * t218;
    const prt_real t228 = t227 + PRT__R(0.59292706128157112475) * t222;
    const prt_real t229 = t59 * t226 + t61 * t228;
    const prt_real t230 = PRT__R(0.879452954966893041481) * t224 + PRT__R(-0.463512405443478934294) * t229;
    const prt_real t231 = PRT__R(0.108253175473054830845) * t204 + PRT__R(-0.586301969977928694321) * t207;
    const prt_real t232 = t231 + PRT__R(0.802827036166570563757) * t211;
    const prt_real t233 = PRT__R(0.3125) * t215 + PRT__R(-0.802827036166570563757) * t218;
    const prt_real t234 = t233 + PRT__R(0.507752400289747522529) * t222;
    const prt_real t235 = t171 * t232 + t174 * t234;
    const prt_real t236 = t230 + PRT__R(0.108253175473054830845) * t235;
    const prt_real t237 = t4 * t153 + t5 * t123;
    const prt_real t238 = f[42];
    const prt_real t239 = t210 * t11 - t209 * t14;
    const prt_real t240 = PRT__R(-0.3125) * t238 + PRT__R(-0.452855523318419955429) * t239;
    const prt_real t241 = t206 * t73 - t205 * t75;
    const prt_real t242 = t202 * t201 - t200 * t203;
    const prt_real t243 = (t240 + PRT__R(-0.496078370824610735719) * t241) + PRT__R(-0.671693289381396157476) * t242;
    const prt_real t244 = PRT__R(-0.452855523318419955429) * t238 + PRT__R(-0.53125) * t239;
    const prt_real t245 = (t244 + PRT__R(-0.171163299220364410455) * t241) + PRT__R(0.695268608165218401442) * t242;
    const prt_real t246 = t221 * t9 - t220 * t10;
    const prt_real t247 = t217 * t37 - t216 * t39;
    const prt_real t248 = PRT__R(0.19764235376052370825) * t246 + PRT__R(0.5625) * t247;
    const prt_real t249 = t214 * t125 - t213 * t127;
    const prt_real t250 = t248 + PRT__R(0.802827036166570563757) * t249;
    const prt_real t251 = t26 * t245 + t29 * t250;
    const prt_real t252 = PRT__R(-0.671693289381396157476) * t243 + PRT__R(0.695268608165218401442) * t251;
    const prt_real t253 = PRT__R(-0.496078370824610735719) * t238 + PRT__R(-0.171163299220364410455) * t239;
    const prt_real t254 = (t253 + PRT__R(0.8125) * t241) + PRT__R(-0.253876200144873761264) * t242;
    const prt_real t255 = PRT__R(0.433012701892219323382) * t246 + PRT__R(0.684653196881457641821) * t247;
    const prt_real t256 = t255 + PRT__R(-0.586301969977928694321) * t249;
    const prt_real t257 = t105 * t254 + t108 * t256;
    const prt_real t258 = t7 * t171 - t16 * t174;
    const prt_real t259 = PRT__R(-0.671693289381396157476) * t238 + PRT__R(0.695268608165218401442) * t239;
    const prt_real t260 = (t259 + PRT__R(-0.253876200144873761264) * t241) + PRT__R(0.03125) * t242;
    const prt_real t261 = t7 * t174 + t16 * t171;
    const prt_real t262 = PRT__R(0.879452954966893041481) * t246 + PRT__R(-0.463512405443478934294) * t247;
    const prt_real t263 = t262 + PRT__R(0.108253175473054830845) * t249;
    const prt_real t264 = t258 * t260 + t261 * t263;
    const prt_real t265 = (t252 + PRT__R(-0.253876200144873761264) * t257) + PRT__R(0.03125) * t264;
    out[36] = t199 * t236 + t237 * t265;
    const prt_real t266 = t171 * t234 - t174 * t232;
    const prt_real t267 = t59 * t228 - t61 * t226;
    const prt_real t268 = PRT__R(0.3125) * t266 + PRT__R(-0.802827036166570563757) * t267;
    const prt_real t269 = t7 * t223 - t16 * t212;
    const prt_real t270 = t268 + PRT__R(0.507752400289747522529) * t269;
    const prt_real t271 = t258 * t263 - t261 * t260;
    const prt_real t272 = t105 * t256 - t108 * t254;
    const prt_real t273 = PRT__R(0.108253175473054830845) * t271 + PRT__R(-0.586301969977928694321) * t272;
    const prt_real t274 = t26 * t250 - t29 * t245;
    const prt_real t275 = t273 + PRT__R(0.802827036166570563757) * t274;
    out[37] = t123 * t270 + t153 * t275;
    const prt_real t276 = PRT__R(0.433012701892219323382) * t224 + PRT__R(0.684653196881457641821) * t229;
    const prt_real t277 = t276 + PRT__R(-0.586301969977928694321) * t235;
    const prt_real t278 = PRT__R(-0.496078370824610735719) * t243 + PRT__R(-0.171163299220364410455) * t251;
    const prt_real t279 = (t278 + PRT__R(0.8125) * t257) + PRT__R(-0.253876200144873761264) * t264;
    out[38] = t71 * t277 + t93 * t279;
    const prt_real t280 = PRT__R(-0.802827036166570563757) * t266 + PRT__R(0.0625) * t267;
    const prt_real t281 = t280 + PRT__R(0.59292706128157112475) * t269;
    const prt_real t282 = PRT__R(-0.463512405443478934294) * t271 + PRT__R(0.684653196881457641821) * t272;
    const prt_real t283 = t282 + PRT__R(0.5625) * t274;
    out[39] = t35 * t281 + t51 * t283;
    const prt_real t284 = PRT__R(0.19764235376052370825) * t224 + PRT__R(0.5625) * t229;
    const prt_real t285 = t284 + PRT__R(0.802827036166570563757) * t235;
    const prt_real t286 = PRT__R(-0.452855523318419955429) * t243 + PRT__R(-0.53125) * t251;
    const prt_real t287 = (t286 + PRT__R(-0.171163299220364410455) * t257) + PRT__R(0.695268608165218401442) * t264;
    out[40] = t6 * t285 + t22 * t287;
    const prt_real t288 = PRT__R(0.507752400289747522529) * t266 + PRT__R(0.59292706128157112475) * t267;
    const prt_real t289 = t288 + PRT__R(0.625) * t269;
    const prt_real t290 = PRT__R(0.879452954966893041481) * t271 + PRT__R(0.433012701892219323382) * t272;
    const prt_real t291 = t290 + PRT__R(0.19764235376052370825) * t274;
    out[41] = t4 * t289 + t5 * t291;
    const prt_real t292 = PRT__R(-0.3125) * t243 + PRT__R(-0.452855523318419955429) * t251;
    out[42] = (t292 + PRT__R(-0.496078370824610735719) * t257) + PRT__R(-0.671693289381396157476) * t264;
    out[43] = t4 * t291 - t5 * t289;
    out[44] = t6 * t287 - t22 * t285;
    out[45] = t35 * t283 - t51 * t281;
    out[46] = t71 * t279 - t93 * t277;
    out[47] = t123 * t275 - t153 * t270;
    out[48] = t199 * t265 - t237 * t236;
    const prt_real t293 = t4 * t199 - t5 * t237;
    const prt_real t294 = f[49];
    const prt_real t295 = t9 * t201 - t10 * t203;
    const prt_real t296 = f[63];
    const prt_real t297 = t9 * t203 + t10 * t201;
    const prt_real t298 = t294 * t295 + t296 * t297;
    const prt_real t299 = f[51];
    const prt_real t300 = f[61];
    const prt_real t301 = t299 * t125 + t300 * t127;
    const prt_real t302 = PRT__R(-0.64725984928774934788) * t298 + PRT__R(-0.47495887979908323849) * t301;
    const prt_real t303 = f[53];
    const prt_real t304 = f[59];
    const prt_real t305 = t303 * t37 + t304 * t39;
    const prt_real t306 = f[55];
    const prt_real t307 = f[57];
    const prt_real t308 = t306 * t9 + t307 * t10;
    const prt_real t309 = (t302 + PRT__R(-0.429616471402110000618) * t305) + PRT__R(-0.413398642353842279766) * t308;
    const prt_real t310 = PRT__R(0.699120541287409177209) * t298 + PRT__R(-0.0732877462472410867901) * t301;
    const prt_real t311 = (t310 + PRT__R(-0.419844651329512592613) * t305) + PRT__R(-0.574099158464807366765) * t308;
    const prt_real t312 = f[50];
    const prt_real t313 = f[62];
    const prt_real t314 = t312 * t201 + t313 * t203;
    const prt_real t315 = f[52];
    const prt_real t316 = f[60];
    const prt_real t317 = t315 * t73 + t316 * t75;
    const prt_real t318 = PRT__R(0.747391296443837376321) * t314 + PRT__R(0.586301969977928694321) * t317;
    const prt_real t319 = f[54];
    const prt_real t320 = f[58];
    const prt_real t321 = t319 * t11 + t320 * t14;
    const prt_real t322 = t318 + PRT__R(0.3125) * t321;
    const prt_real t323 = t26 * t311 + t29 * t322;
    const prt_real t324 = PRT__R(-0.64725984928774934788) * t309 + PRT__R(0.699120541287409177209) * t323;
    const prt_real t325 = PRT__R(-0.29810600044279551536) * t298 + PRT__R(0.78125) * t301;
    const prt_real t326 = (t325 + PRT__R(0.103644524698606245285) * t305) + PRT__R(-0.538552748112940186861) * t308;
    const prt_real t327 = PRT__R(-0.637377439199098103754) * t314 + PRT__R(0.5) * t317;
    const prt_real t328 = t327 + PRT__R(0.586301969977928694321) * t321;
    const prt_real t329 = t105 * t326 + t108 * t328;
    const prt_real t330 = PRT__R(0.0584633966683428341497) * t298 + PRT__R(-0.398360899499436314846) * t301;
    const prt_real t331 = (t330 + PRT__R(0.792728180872863885852) * t305) + PRT__R(-0.457681828621150306643) * t308;
    const prt_real t332 = PRT__R(0.1875) * t314 + PRT__R(-0.637377439199098103754) * t317;
    const prt_real t333 = t332 + PRT__R(0.747391296443837376321) * t321;
    const prt_real t334 = t258 * t331 + t261 * t333;
    const prt_real t335 = (t324 + PRT__R(-0.29810600044279551536) * t329) + PRT__R(0.0584633966683428341497) * t334;
    const prt_real t336 = t4 * t237 + t5 * t199;
    const prt_real t337 = t307 * t9 - t306 * t10;
    const prt_real t338 = t304 * t37 - t303 * t39;
    const prt_real t339 = PRT__R(-0.078125) * t337 + PRT__R(-0.243569644814373369402) * t338;
    const prt_real t340 = t300 * t125 - t299 * t127;
    const prt_real t341 = t296 * t295 - t294 * t297;
    const prt_real t342 = (t339 + PRT__R(-0.448793956760783489051) * t340) + PRT__R(-0.856244297426266074633) * t341;
    const prt_real t343 = f[56];
    const prt_real t344 = t320 * t11 - t319 * t14;
    const prt_real t345 = PRT__R(-0.413398642353842279766) * t343 + PRT__R(-0.574099158464807366765) * t344;
    const prt_real t346 = t316 * t73 - t315 * t75;
    const prt_real t347 = t313 * t201 - t312 * t203;
    const prt_real t348 = (t345 + PRT__R(-0.538552748112940186861) * t346) + PRT__R(-0.457681828621150306643) * t347;
    const prt_real t349 = t7 * t342 + t16 * t348;
    const prt_real t350 = PRT__R(-0.243569644814373369402) * t337 + PRT__R(-0.609375) * t338;
    const prt_real t351 = (t350 + PRT__R(-0.570044885842334349067) * t340) + PRT__R(0.494352875611136705361) * t341;
    const prt_real t352 = PRT__R(-0.429616471402110000618) * t343 + PRT__R(-0.419844651329512592613) * t344;
    const prt_real t353 = (t352 + PRT__R(0.103644524698606245285) * t346) + PRT__R(0.792728180872863885852) * t347;
    const prt_real t354 = t59 * t351 + t61 * t353;
    const prt_real t355 = PRT__R(-0.856244297426266074633) * t349 + PRT__R(0.494352875611136705361) * t354;
    const prt_real t356 = PRT__R(-0.448793956760783489051) * t337 + PRT__R(-0.570044885842334349067) * t338;
    const prt_real t357 = (t356 + PRT__R(0.671875) * t340) + PRT__R(-0.14905300022139775768) * t341;
    const prt_real t358 = PRT__R(-0.47495887979908323849) * t343 + PRT__R(-0.0732877462472410867901) * t344;
    const prt_real t359 = (t358 + PRT__R(0.78125) * t346) + PRT__R(-0.398360899499436314846) * t347;
    const prt_real t360 = t171 * t357 + t174 * t359;
    const prt_real t361 = t7 * t258 - t16 * t261;
    const prt_real t362 = PRT__R(-0.856244297426266074633) * t337 + PRT__R(0.494352875611136705361) * t338;
    const prt_real t363 = (t362 + PRT__R(-0.14905300022139775768) * t340) + PRT__R(0.015625) * t341;
    const prt_real t364 = t7 * t261 + t16 * t258;
    const prt_real t365 = PRT__R(-0.64725984928774934788) * t343 + PRT__R(0.699120541287409177209) * t344;
    const prt_real t366 = (t365 + PRT__R(-0.29810600044279551536) * t346) + PRT__R(0.0584633966683428341497) * t347;
    const prt_real t367 = t361 * t363 + t364 * t366;
    const prt_real t368 = (t355 + PRT__R(-0.14905300022139775768) * t360) + PRT__R(0.015625) * t367;
    out[49] = t293 * t335 + t336 * t368;
    const prt_real t369 = t258 * t333 - t261 * t331;
    const prt_real t370 = t105 * t328 - t108 * t326;
    const prt_real t371 = PRT__R(0.1875) * t369 + PRT__R(-0.637377439199098103754) * t370;
    const prt_real t372 = t26 * t322 - t29 * t311;
    const prt_real t373 = t371 + PRT__R(0.747391296443837376321) * t372;
    const prt_real t374 = t361 * t366 - t364 * t363;
    const prt_real t375 = t171 * t359 - t174 * t357;
    const prt_real t376 = PRT__R(0.0584633966683428341497) * t374 + PRT__R(-0.398360899499436314846) * t375;
    const prt_real t377 = t59 * t353 - t61 * t351;
    const prt_real t378 = t7 * t348 - t16 * t342;
    const prt_real t379 = (t376 + PRT__R(0.792728180872863885852) * t377) + PRT__R(-0.457681828621150306643) * t378;
    out[50] = t199 * t373 + t237 * t379;
    const prt_real t380 = PRT__R(-0.47495887979908323849) * t309 + PRT__R(-0.0732877462472410867901) * t323;
    const prt_real t381 = (t380 + PRT__R(0.78125) * t329) + PRT__R(-0.398360899499436314846) * t334;
    const prt_real t382 = PRT__R(-0.448793956760783489051) * t349 + PRT__R(-0.570044885842334349067) * t354;
    const prt_real t383 = (t382 + PRT__R(0.671875) * t360) + PRT__R(-0.14905300022139775768) * t367;
    out[51] = t123 * t381 + t153 * t383;
    const prt_real t384 = PRT__R(-0.637377439199098103754) * t369 + PRT__R(0.5) * t370;
    const prt_real t385 = t384 + PRT__R(0.586301969977928694321) * t372;
    const prt_real t386 = PRT__R(-0.29810600044279551536) * t374 + PRT__R(0.78125) * t375;
    const prt_real t387 = (t386 + PRT__R(0.103644524698606245285) * t377) + PRT__R(-0.538552748112940186861) * t378;
    out[52] = t71 * t385 + t93 * t387;
    const prt_real t388 = PRT__R(-0.429616471402110000618) * t309 + PRT__R(-0.419844651329512592613) * t323;
    const prt_real t389 = (t388 + PRT__R(0.103644524698606245285) * t329) + PRT__R(0.792728180872863885852) * t334;
    const prt_real t390 = PRT__R(-0.243569644814373369402) * t349 + PRT__R(-0.609375) * t354;
    const prt_real t391 = (t390 + PRT__R(-0.570044885842334349067) * t360) + PRT__R(0.494352875611136705361) * t367;
    out[53] = t35 * t389 + t51 * t391;
    const prt_real t392 = PRT__R(0.747391296443837376321) * t369 + PRT__R(0.586301969977928694321) * t370;
    const prt_real t393 = t392 + PRT__R(0.3125) * t372;
    const prt_real t394 = PRT__R(0.699120541287409177209) * t374 + PRT__R(-0.0732877462472410867901) * t375;
    const prt_real t395 = (t394 + PRT__R(-0.419844651329512592613) * t377) + PRT__R(-0.574099158464807366765) * t378;
    out[54] = t6 * t393 + t22 * t395;
    const prt_real t396 = PRT__R(-0.413398642353842279766) * t309 + PRT__R(-0.574099158464807366765) * t323;
    const prt_real t397 = (t396 + PRT__R(-0.538552748112940186861) * t329) + PRT__R(-0.457681828621150306643) * t334;
    const prt_real t398 = PRT__R(-0.078125) * t349 + PRT__R(-0.243569644814373369402) * t354;
    const prt_real t399 = (t398 + PRT__R(-0.448793956760783489051) * t360) + PRT__R(-0.856244297426266074633) * t367;
    out[55] = t4 * t397 + t5 * t399;
    const prt_real t400 = PRT__R(-0.64725984928774934788) * t374 + PRT__R(-0.47495887979908323849) * t375;
    out[56] = (t400 + PRT__R(-0.429616471402110000618) * t377) + PRT__R(-0.413398642353842279766) * t378;
    out[57] = t4 * t399 - t5 * t397;
    out[58] = t6 * t395 - t22 * t393;
    out[59] = t35 * t391 - t51 * t389;
    out[60] = t71 * t387 - t93 * t385;
    out[61] = t123 * t383 - t153 * t381;
    out[62] = t199 * t379 - t237 * t373;
    out[63] = t293 * t368 - t336 * t335;
}

/* END GENERATED */
#else
/* BEGIN GENERATED: prt_codegen --table swap_yz */
/* y and z swapped in bands 2 and 3 */
PRT__INLINE void prt__swap_yz_3(prt__classes *v) {
    static const prt_real c[][4] = {
        { PRT__R(-0.612372435695794524549), PRT__R(0.612372435695794524549), PRT__R(-0.5), PRT__R(0.5) },
        { PRT__R(-0.790569415042094833), PRT__R(-0.790569415042094833), PRT__R(-0.866025403784438646764), PRT__R(-0.866025403784438646764) },
        { PRT__R(-0.25), PRT__R(0.25), PRT__R(1.0), 0 },
        { PRT__R(-0.968245836551854221295), PRT__R(-0.968245836551854221295), 0, 0 },
        { PRT__R(-0.612372435695794524549), PRT__R(0.612372435695794524549), PRT__R(1.0), 0 },
        { PRT__R(-0.790569415042094833), PRT__R(-0.790569415042094833), 0, 0 }
    };
    prt__quad even_cos = v->even_cos;
    prt__quad odd_cos = v->odd_cos;
    prt__quad even_sin = v->even_sin;
    prt__quad odd_sin = v->odd_sin;
    v->even_cos = prt__quad_load(c[0]) * PRT__QUAD_SHUFFLE(odd_sin, even_cos, 0, 1, 6, 7);
    v->even_cos += prt__quad_load(c[1]) * PRT__QUAD_SHUFFLE(odd_sin, even_cos, 1, 0, 7, 6);
    v->odd_cos = prt__quad_load(c[2]) * PRT__QUAD_SHUFFLE(odd_cos, even_sin, 0, 1, 7, 7);
    v->odd_cos += prt__quad_load(c[3]) * PRT__QUAD_SHUFFLE(odd_cos, even_sin, 1, 0, 7, 7);
    v->even_sin = PRT__QUAD_SHUFFLE(even_sin, odd_cos, 1, 1, 6, 6);
    v->odd_sin = prt__quad_load(c[4]) * PRT__QUAD_SHUFFLE(even_cos, odd_sin, 0, 1, 6, 6);
    v->odd_sin += prt__quad_load(c[5]) * PRT__QUAD_SHUFFLE(even_cos, odd_sin, 1, 0, 6, 6);
}

/* y and z swapped in band 4 */
PRT__INLINE void prt__swap_yz_4(prt__classes *v) {
    static const prt_real c[][4] = {
        { PRT__R(0.375), PRT__R(0.5), PRT__R(0.125), 0 },
        { PRT__R(0.559016994374947424102), PRT__R(-0.661437827766147647625), PRT__R(0.739509972887452005321), 0 },
        { PRT__R(0.739509972887452005321), PRT__R(0.559016994374947424102), PRT__R(-0.661437827766147647625), 0 },
        { PRT__R(-0.3535533905932737622), PRT__R(0.3535533905932737622), 0, 0 },
        { PRT__R(-0.935414346693485346396), PRT__R(-0.935414346693485346396), 0, 0 },
        { 0, PRT__R(-0.3535533905932737622), PRT__R(0.3535533905932737622), 0 },
        { 0, PRT__R(-0.935414346693485346396), PRT__R(-0.935414346693485346396), 0 },
        { PRT__R(-0.75), PRT__R(0.75), 0, 0 },
        { PRT__R(-0.661437827766147647625), PRT__R(-0.661437827766147647625), 0, 0 }
    };
    prt__quad even_cos = v->even_cos;
    prt__quad odd_cos = v->odd_cos;
    prt__quad even_sin = v->even_sin;
    prt__quad odd_sin = v->odd_sin;
    v->even_cos = prt__quad_load(c[0]) * even_cos;
    v->even_cos += prt__quad_load(c[1]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 1, 2, 0, 0);
    v->even_cos += prt__quad_load(c[2]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 2, 0, 1, 1);
    v->odd_cos = prt__quad_load(c[3]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 1, 2, 2, 2);
    v->odd_cos += prt__quad_load(c[4]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 2, 1, 1, 1);
    v->even_sin = prt__quad_load(c[5]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 0, 0, 1, 1);
    v->even_sin += prt__quad_load(c[6]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 1, 1, 0, 0);
    v->odd_sin = prt__quad_load(c[7]) * odd_sin;
    v->odd_sin += prt__quad_load(c[8]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 1, 0, 0, 0);
}

/* y and z swapped in band 5 */
PRT__INLINE void prt__swap_yz_5(prt__classes *v) {
    static const prt_real c[][4] = {
        { PRT__R(0.484122918275927110647), PRT__R(0.306186217847897262275), PRT__R(0.19764235376052370825), 0 },
        { PRT__R(0.522912516583797217486), PRT__R(-0.684653196881457641821), PRT__R(0.572821961869480000824), 0 },
        { PRT__R(0.701560760020114009797), PRT__R(0.661437827766147647625), PRT__R(-0.795495128834865964951), 0 },
        { PRT__R(0.125), PRT__R(0.8125), PRT__R(0.0625), 0 },
        { PRT__R(0.405046293650491264435), PRT__R(-0.419262745781210568077), PRT__R(0.905711046636839910857), 0 },
        { PRT__R(0.905711046636839910857), PRT__R(0.405046293650491264435), PRT__R(-0.419262745781210568077), 0 },
        { 0, PRT__R(-0.5), PRT__R(0.5), 0 },
        { 0, PRT__R(-0.866025403784438646764), PRT__R(-0.866025403784438646764), 0 },
        { PRT__R(0.484122918275927110647), PRT__R(0.306186217847897262275), PRT__R(0.19764235376052370825), 0 },
        { PRT__R(0.661437827766147647625), PRT__R(-0.795495128834865964951), PRT__R(0.701560760020114009797), 0 },
        { PRT__R(0.572821961869480000824), PRT__R(0.522912516583797217486), PRT__R(-0.684653196881457641821), 0 }
    };
    prt__quad even_cos = v->even_cos;
    prt__quad odd_cos = v->odd_cos;
    prt__quad even_sin = v->even_sin;
    prt__quad odd_sin = v->odd_sin;
    v->even_cos = prt__quad_load(c[0]) * odd_sin;
    v->even_cos += prt__quad_load(c[1]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 1, 2, 0, 0);
    v->even_cos += prt__quad_load(c[2]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 2, 0, 1, 1);
    v->odd_cos = prt__quad_load(c[3]) * odd_cos;
    v->odd_cos += prt__quad_load(c[4]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 1, 2, 0, 0);
    v->odd_cos += prt__quad_load(c[5]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 2, 0, 1, 1);
    v->even_sin = prt__quad_load(c[6]) * even_sin;
    v->even_sin += prt__quad_load(c[7]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 2, 2, 1, 1);
    v->odd_sin = prt__quad_load(c[8]) * even_cos;
    v->odd_sin += prt__quad_load(c[9]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 1, 2, 0, 0);
    v->odd_sin += prt__quad_load(c[10]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 2, 0, 1, 1);
}

/* y and z swapped in band 6 */
PRT__INLINE void prt__swap_yz_6(prt__classes *v) {
    static const prt_real c[][4] = {
        { PRT__R(-0.3125), PRT__R(-0.53125), PRT__R(0.8125), PRT__R(0.03125) },
        { PRT__R(-0.452855523318419955429), PRT__R(-0.171163299220364410455), PRT__R(-0.253876200144873761264), PRT__R(-0.671693289381396157476) },
        { PRT__R(-0.496078370824610735719), PRT__R(0.695268608165218401442), PRT__R(-0.496078370824610735719), PRT__R(0.695268608165218401442) },
        { PRT__R(-0.671693289381396157476), PRT__R(-0.452855523318419955429), PRT__R(-0.171163299220364410455), PRT__R(-0.253876200144873761264) },
        { PRT__R(0.19764235376052370825), PRT__R(0.684653196881457641821), PRT__R(0.108253175473054830845), 0 },
        { PRT__R(0.433012701892219323382), PRT__R(-0.463512405443478934294), PRT__R(0.802827036166570563757), 0 },
        { PRT__R(0.879452954966893041481), PRT__R(0.5625), PRT__R(-0.586301969977928694321), 0 },
        { 0, PRT__R(0.19764235376052370825), PRT__R(0.684653196881457641821), PRT__R(0.108253175473054830845) },
        { 0, PRT__R(0.5625), PRT__R(-0.586301969977928694321), PRT__R(0.879452954966893041481) },
        { 0, PRT__R(0.802827036166570563757), PRT__R(0.433012701892219323382), PRT__R(-0.463512405443478934294) },
        { PRT__R(0.625), PRT__R(0.0625), PRT__R(0.3125), 0 },
        { PRT__R(0.59292706128157112475), PRT__R(-0.802827036166570563757), PRT__R(0.507752400289747522529), 0 },
        { PRT__R(0.507752400289747522529), PRT__R(0.59292706128157112475), PRT__R(-0.802827036166570563757), 0 }
    };
    prt__quad even_cos = v->even_cos;
    prt__quad odd_cos = v->odd_cos;
    prt__quad even_sin = v->even_sin;
    prt__quad odd_sin = v->odd_sin;
    v->even_cos = prt__quad_load(c[0]) * even_cos;
    v->even_cos += prt__quad_load(c[1]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 1, 2, 3, 0);
    v->even_cos += prt__quad_load(c[2]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 2, 3, 0, 1);
    v->even_cos += prt__quad_load(c[3]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 3, 0, 1, 2);
    v->odd_cos = prt__quad_load(c[4]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 1, 2, 3, 3);
    v->odd_cos += prt__quad_load(c[5]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 2, 3, 1, 1);
    v->odd_cos += prt__quad_load(c[6]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 3, 1, 2, 2);
    v->even_sin = prt__quad_load(c[7]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 0, 0, 1, 2);
    v->even_sin += prt__quad_load(c[8]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 1, 1, 2, 0);
    v->even_sin += prt__quad_load(c[9]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 2, 2, 0, 1);
    v->odd_sin = prt__quad_load(c[10]) * odd_sin;
    v->odd_sin += prt__quad_load(c[11]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 1, 2, 0, 0);
    v->odd_sin += prt__quad_load(c[12]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 2, 0, 1, 1);
}

/* y and z swapped in band 7 */
PRT__INLINE void prt__swap_yz_7(prt__classes *v) {
    static const prt_real c[][4] = {
        { PRT__R(-0.413398642353842279766), PRT__R(-0.419844651329512592613), PRT__R(0.78125), PRT__R(0.0584633966683428341497) },
        { PRT__R(-0.429616471402110000618), PRT__R(-0.0732877462472410867901), PRT__R(-0.29810600044279551536), PRT__R(-0.457681828621150306643) },
        { PRT__R(-0.47495887979908323849), PRT__R(0.699120541287409177209), PRT__R(-0.538552748112940186861), PRT__R(0.792728180872863885852) },
        { PRT__R(-0.64725984928774934788), PRT__R(-0.574099158464807366765), PRT__R(0.103644524698606245285), PRT__R(-0.398360899499436314846) },
        { PRT__R(-0.078125), PRT__R(-0.609375), PRT__R(0.671875), PRT__R(0.015625) },
        { PRT__R(-0.243569644814373369402), PRT__R(-0.570044885842334349067), PRT__R(-0.14905300022139775768), PRT__R(-0.856244297426266074633) },
        { PRT__R(-0.448793956760783489051), PRT__R(0.494352875611136705361), PRT__R(-0.448793956760783489051), PRT__R(0.494352875611136705361) },
        { PRT__R(-0.856244297426266074633), PRT__R(-0.243569644814373369402), PRT__R(-0.570044885842334349067), PRT__R(-0.14905300022139775768) },
        { 0, PRT__R(0.3125), PRT__R(0.5), PRT__R(0.1875) },
        { 0, PRT__R(0.586301969977928694321), PRT__R(-0.637377439199098103754), PRT__R(0.747391296443837376321) },
        { 0, PRT__R(0.747391296443837376321), PRT__R(0.586301969977928694321), PRT__R(-0.637377439199098103754) },
        { PRT__R(-0.413398642353842279766), PRT__R(-0.419844651329512592613), PRT__R(0.78125), PRT__R(0.0584633966683428341497) },
        { PRT__R(-0.574099158464807366765), PRT__R(0.103644524698606245285), PRT__R(-0.398360899499436314846), PRT__R(-0.64725984928774934788) },
        { PRT__R(-0.538552748112940186861), PRT__R(0.792728180872863885852), PRT__R(-0.47495887979908323849), PRT__R(0.699120541287409177209) },
        { PRT__R(-0.457681828621150306643), PRT__R(-0.429616471402110000618), PRT__R(-0.0732877462472410867901), PRT__R(-0.29810600044279551536) }
    };
    prt__quad even_cos = v->even_cos;
    prt__quad odd_cos = v->odd_cos;
    prt__quad even_sin = v->even_sin;
    prt__quad odd_sin = v->odd_sin;
    v->even_cos = prt__quad_load(c[0]) * odd_sin;
    v->even_cos += prt__quad_load(c[1]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 1, 2, 3, 0);
    v->even_cos += prt__quad_load(c[2]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 2, 3, 0, 1);
    v->even_cos += prt__quad_load(c[3]) * PRT__QUAD_SHUFFLE(odd_sin, odd_sin, 3, 0, 1, 2);
    v->odd_cos = prt__quad_load(c[4]) * odd_cos;
    v->odd_cos += prt__quad_load(c[5]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 1, 2, 3, 0);
    v->odd_cos += prt__quad_load(c[6]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 2, 3, 0, 1);
    v->odd_cos += prt__quad_load(c[7]) * PRT__QUAD_SHUFFLE(odd_cos, odd_cos, 3, 0, 1, 2);
    v->even_sin = prt__quad_load(c[8]) * even_sin;
    v->even_sin += prt__quad_load(c[9]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 2, 2, 3, 1);
    v->even_sin += prt__quad_load(c[10]) * PRT__QUAD_SHUFFLE(even_sin, even_sin, 3, 3, 1, 2);
    v->odd_sin = prt__quad_load(c[11]) * even_cos;
    v->odd_sin += prt__quad_load(c[12]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 1, 2, 3, 0);
    v->odd_sin += prt__quad_load(c[13]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 2, 3, 0, 1);
    v->odd_sin += prt__quad_load(c[14]) * PRT__QUAD_SHUFFLE(even_cos, even_cos, 3, 0, 1, 2);
}

/* END GENERATED */
#endif

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
