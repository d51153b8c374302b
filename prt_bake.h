/* prt_bake.h - v0.1.0 - precomputed radiance transfer, the baker - MIT or Unlicense, your choice (see end of file)

   WHAT IT IS
     What a tool needs before prt.h can light a scene: points on surfaces, sample sets, transfer vectors.
     Plain C99, also C++11; no dependency but prt.h and the C standard library; no I/O, no threads, no globals.
   WHAT IT IS NOT
     A ray tracer. You hand over a callback that traces rays in batches (Embree, OptiX, your own): see RAY CALLBACK.

   HOW TO INCLUDE
     Anywhere:                  #include "prt_bake.h"              (it includes prt.h)
     In exactly one C/C++ file: #define PRT_IMPLEMENTATION
                                #define PRT_BAKE_IMPLEMENTATION
                                #include "prt_bake.h"
     PRT_BAKE_IMPLEMENTATION asks for the functions of this header alone, PRT_IMPLEMENTATION for those of prt.h. The two
     may stand in one file, as above, or in two; with PRT_STATIC both must stand in each file that bakes.

   PIPELINE, the calls in order
     1. prt_points_from_vertices   a mesh's vertices become bake points: a position and a unit normal each
     2. prt_bake_desc              zero-initialise, then set what you do not want at its default
     3. prt_bake_transfer          rays in, transfer out: points[k] -> transfer[k][bands^2]; any part of the points at a
                                   time, in any thread, process or machine, with the same bits
     4. prt_bake_error             of two bakes with different seeds: their mean, and its standard error at each point
     5. prt_shade_diffuse (prt.h)  transfer and light -> exit radiance, at run time
     Rooms, by the tag to grep for: >>types, >>sample point sets, >>point bake points, >>direct transfer.

   A COMPLETE EXAMPLE
     #include <stdio.h>
     #define PRT_IMPLEMENTATION
     #define PRT_BAKE_IMPLEMENTATION
     #include "prt_bake.h"

     static int ball(void *user, int count, const prt_ray *rays, unsigned char *blocked) { // a unit ball at (0,0,2)
         int k;
         (void)user;
         for (k = 0; k < count; k++) {
             prt_vec3 o = rays[k].origin, d = rays[k].dir;
             prt_real along = -o.x * d.x - o.y * d.y + (2 - o.z) * d.z;                    // to the closest approach
             prt_real off2 = o.x * o.x + o.y * o.y + (2 - o.z) * (2 - o.z) - along * along;
             blocked[k] = (unsigned char)(along > 0 && off2 < 1);
         }
         return 0;
     }
     int main(void) {
         enum { BANDS = 5, N = PRT_SH_COUNT(BANDS) };
         prt_point points[2] = { { { 0, 0, 0 }, { 0, 0, 1 } }, { { 3, 0, 0 }, { 0, 0, 1 } } };
         prt_tracer tracer = { 0 };
         prt_bake_desc desc = { 0 };
         prt_real transfer[2 * N], light[3 * N];
         prt_rgb out[2];
         prt_result r;
         int c;
         tracer.occluded = ball;
         desc.tracer = &tracer;
         r = prt_bake_transfer(&desc, 2, points, 0, 2, transfer);
         if (r != PRT_OK) { fprintf(stderr, "bake: %s\n", prt_result_string(r)); return 1; }
         for (c = 0; c < 3; c++) prt_sh_hemisphere(BANDS, points[0].normal, 1, 1, light + c * N);  // white all round
         prt_shade_diffuse_n(BANDS, 2, transfer, light, out);
         printf("under the ball %.2f, beside it %.2f\n", out[0].g, out[1].g);                      // 0.75 and 0.96
         return 0;
     }

   RAY CALLBACK
     prt_tracer.occluded receives some rays and says of each whether anything lies on it between tmin and tmax.
     - A batch holds up to PRT_BAKE_BATCH rays, and more than PRT_BAKE_BATCH - 64 but for the last of a call, so that
       packet and stream tracers work at full width. Its rays start at few points and point everywhere: incoherent.
       How rays are dealt to batches depends on the range: a ray's answer must not depend on its batch.
     - Every number in a ray is finite. dir is of unit length within rounding; tmin is 0; tmax is FLT_MAX, which
       float and double hold alike. origin has moved off the surface by the bias already.
     - blocked[k] = 1 if something is hit, else 0 (any nonzero value counts as blocked). It is all 0 on entry.
     - Return 0. Anything else ends the bake with PRT_ERR_TRACE; points finished before stay valid.
     - It is called in the thread that called the bake; with several threads it must allow concurrent calls.
     - user is handed through untouched.

   THREADS
     Call prt_bake_transfer from several threads with the same points and transfer and different ranges (some hundred
     points a range balance the load). Nothing is shared between calls; the bits are those of a single call.

   HOW GOOD IS IT
     Bake twice with two seeds: a, b. prt_bake_error gives their mean and the standard error of it at each point. That
     counts what the rays cost, not what the bands leave out. docs/ has the error against the number of rays.

   CONFIG MACROS (beside those of prt.h)
     PRT_MALLOC(size), PRT_FREE(pointer)  both or neither [malloc, free]. One block a call, freed before it returns.
     PRT_BAKE_BATCH                       rays a callback [1024], at least 64

   LIMITS
     Scratch memory of a call (prt_bake_scratch_size): 53 KiB at 5 bands, 77 at 10, 400 to 590 at 64 by vector width
     (float; double: 104, 147, 634).
     points and rays a point are int; their product may exceed it.

   REFERENCES (beside those of prt.h)
     [Burley 2020]     Burley: Practical Hash-based Owen Scrambling. JCGT 9(4), 2020
     [Cranley 1976]    Cranley, Patterson: Randomization of Number Theoretic Methods for Multiple Integration. 1976
     [Duff 2017]       Duff et al.: Building an Orthonormal Basis, Revisited. JCGT 6(1), 2017
     [Marques 2013]    Marques et al.: Spherical Fibonacci Point Sets for Illumination Integrals. CGF 32(8), 2013
     [Steele 2014]     Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators. OOPSLA 2014
     [Thuermer 1998]   Thuermer, Wuethrich: Computing Vertex Normals from Polygonal Facets. JGT 3(1), 1998
*/
#ifndef PRT_BAKE_H_INCLUDED
#define PRT_BAKE_H_INCLUDED

#include "prt.h"

#ifdef __cplusplus
extern "C" {
#endif

#ifndef PRT_BAKE_BATCH
#  define PRT_BAKE_BATCH 1024
#endif

/* ------------------------------------------------------------------------------------------------- >>types ---- */

typedef struct prt_ray {
    prt_vec3 origin, dir;              /* dir is a unit vector */
    prt_real tmin, tmax;               /* the part of the ray that counts: tmin < t < tmax */
} prt_ray;

typedef struct prt_hit {
    prt_real t;                        /* distance along the ray */
    int object, primitive;             /* object < 0: missed, and nothing else is read */
    prt_real u, v;                     /* barycentric coordinates of the second and third corner */
    prt_vec3 normal;                   /* unit geometric normal */
} prt_hit;

typedef struct prt_tracer {            /* see RAY CALLBACK */
    void *user;
    int (*occluded)(void *user, int count, const prt_ray *rays, unsigned char *blocked);
    int (*closest) (void *user, int count, const prt_ray *rays, prt_hit *hits);
} prt_tracer;

typedef struct prt_point { prt_vec3 position, normal; } prt_point;   /* where to bake; the normal is a unit vector */

/* After every point: done = points finished in this call, total = count. Nonzero stops, even at the last:
   PRT_ERR_CANCELLED, and what is done stays valid. */
typedef int (*prt_progress)(void *user, int done, int total);

typedef struct prt_bake_desc {         /* zero-initialise; 0 means the default in brackets */
    int bands;                         /* [5] */
    int samples;                       /* rays a point [1024] */
    uint64_t seed;
    prt_real bias;                     /* ray offset along the normal, in scene units [1e-4 x scene_radius, or 1e-4] */
    prt_real scene_radius;             /* half the extent of the scene; only the default bias reads it */
    const prt_tracer *tracer;          /* required for shadowed transfer; NULL: unshadowed */
    prt_progress progress; void *progress_user;
} prt_bake_desc;

/* ------------------------------------------------------------------------------------------------ >>sample ---- */

/* Point sets in the unit square [0,1)^2. Each is a function of (set, total, seed, index): index chooses one of 2^64
   randomisations, so that a set per surface point costs no memory. Any total works. The error of transfer against
   rays for each: docs/bake.md. */
typedef enum prt_sample_set {
    PRT_SAMPLE_FIBONACCI = 0,          /* u = (k + a)/total, v = frac(k/golden ratio + b): a lattice, shifted at random
                                          by (a, b) [Cranley 1976]; on the sphere spherical Fibonacci [Marques 2013] */
    PRT_SAMPLE_SOBOL,                  /* the (0,2)-sequence, Owen scrambled by hashing [Burley 2020]; total is best a
                                          power of two */
    PRT_SAMPLE_JITTERED,               /* one random place in each cell of a grid [Chapter 2010, 3.3]; where total is no
                                          square the rows hold unequal numbers of cells, all of one area */
    PRT_SAMPLE_RANDOM,                 /* independent */
    PRT_SAMPLE_SET_COUNT
} prt_sample_set;

/* Members first ... first+count-1 of a set of `total` to u[count], v[count], each in [0,1), every one uniformly
   distributed over seeds (so that any mean of a function over a set is an unbiased estimate of its integral).
   0 <= first, 0 <= count, first + count <= total. Errors: PRT_ERR_COUNT; PRT_ERR_VALUE (set); PRT_ERR_NULL.
   Cost: 4 ns a member (Sobol 32, jittered 14). */
PRTDEF prt_result prt_sample_square(prt_sample_set set, int total, uint64_t seed, uint64_t index, int first, int count,
                                    prt_real *u, prt_real *v);

/* From the square, area onto measure: the sphere with density 1/(4 pi) and [Chapter 2010, 3.3]'s mapping
   theta = 2 acos(sqrt(1-u)), phi = 2 pi v (its pole turned to +z); the hemisphere about +z with density 1/(2 pi); the
   hemisphere with density cos(theta)/pi, theta = asin(sqrt(u)). Unit within 2 eps for u, v in [0,1]. */
PRTDEF prt_vec3 prt_sample_sphere    (prt_real u, prt_real v);
PRTDEF prt_vec3 prt_sample_hemisphere(prt_real u, prt_real v);
PRTDEF prt_vec3 prt_sample_cosine    (prt_real u, prt_real v);

/* The directions that prt_bake_transfer traces from points[index]: members first ... first+count-1 of the Fibonacci
   set, mapped by cosine about `normal`. Their order, azimuths included, is fixed by (total, seed, index, normal) alone.
   normal is unit within 1e-3 (PRT_ERR_VALUE), then normalised; each direction is unit within 6 eps.
   Errors: PRT_ERR_COUNT as above, PRT_ERR_NULL, PRT_ERR_VALUE. Cost: 0.7 us a call and 2 ns a direction. */
PRTDEF prt_result prt_sample_directions(int total, uint64_t seed, uint64_t index, prt_vec3 normal, int first, int count,
                                        prt_vec3 *dirs);

/* ------------------------------------------------------------------------------------------------- >>point ---- */

typedef struct prt_mesh {              /* zero-initialise; what it points to stays yours */
    int vertex_count;
    const prt_vec3 *positions;         /* [vertex_count], finite */
    const prt_vec3 *normals;           /* [vertex_count], of any length; NULL: none. Zero and non-finite: recomputed */
    int triangle_count;
    const uint32_t *triangles;         /* [triangle_count][3], counter-clockwise seen from outside */
    int area_weighted;                 /* faces share in a recomputed normal by 0: angle [Thuermer 1998], 1: area */
} prt_mesh;

typedef struct prt_mesh_report {
    int recomputed;                    /* normals taken from faces, for want of a usable one */
    int without;                       /* of these, in no usable triangle, or faces cancel: the normal is set to +z */
    int degenerate;                    /* triangles without area, left out of the normals */
    prt_vec3 centre;                   /* of the box around the positions */
    prt_real radius;                   /* half its diagonal: what prt_bake_desc.scene_radius wants */
} prt_mesh_report;

/* Points at the vertices, in their order: points[vertex_count], unit normals. report may be NULL.
   Normals that are given are normalised; where one is missing, zero or not finite, the sum over the faces around the
   vertex of face normal times angle at the vertex (or times area) takes its place. A triangle is degenerate if an edge
   has no length or the sine of the angle at its second corner is at most eps: scale plays no role, tiny and huge meshes
   are as good as any other.
   Errors: PRT_ERR_COUNT (a count below 0, an index >= vertex_count); PRT_ERR_NULL; PRT_ERR_VALUE (a position is not
   finite). Cost: 0.25 us a triangle. */
PRTDEF prt_result prt_points_from_vertices(const prt_mesh *mesh, prt_point *points, prt_mesh_report *report);

/* Whether points first ... first+count-1 can be baked: finite, normals unit within 1e-3. *bad (may be NULL) is the
   index of the first that cannot, or -1. Errors: PRT_ERR_COUNT unless 0 <= first, 0 <= count, first + count <=
   point_count; PRT_ERR_NULL; PRT_ERR_VALUE if one is bad. */
PRTDEF prt_result prt_points_check(int point_count, const prt_point *points, int first, int count, int *bad);

/* ------------------------------------------------------------------------------------------------ >>direct ---- */

/* Bytes of transfer[point_count][bands^2], 0 if an argument is out of range or the size does not fit a size_t. */
PRTDEF size_t prt_bake_transfer_size(int bands, int point_count);

/* Bytes that prt_bake_transfer takes from PRT_MALLOC, in one piece, for so many bands (0: the default), or 0. */
PRTDEF size_t prt_bake_scratch_size(int bands);

/* Transfer of points[first ... first+count-1] into the same rows of transfer[point_count][bands^2]; no other row is
   touched, and no other point is read. Without a tracer the same rays are sampled, all open.

   T_i = (1/pi) int V(w) max(0, N.w) Y_i(w) dw, estimated as (1/samples) sum_k V(w_k) Y_i(w_k) over cosine-distributed
   w_k (prt_sample_directions): unbiased for any number of rays. T_0 is Y(0,0) times the open share of the rays.
   V(w) = 0 where the tracer finds anything on the ray from position + bias * N in direction w. In float a bias below
   6e-8 of a coordinate is lost: give scene_radius, and keep the origin of coordinates near the scene.

   The bits of a row depend on desc, its point and its index alone: not on point_count, range, or threads.
   Errors, checked in this order, before anything is written: PRT_ERR_NULL (desc); PRT_ERR_BANDS; PRT_ERR_COUNT
   (samples < 0; not 0 <= first, 0 <= count, first + count <= point_count); PRT_ERR_CAPACITY (a size overflows);
   PRT_ERR_NULL (points or transfer with count > 0; a tracer without `occluded`); PRT_ERR_VALUE (bias or scene_radius
   negative or not finite; a point in the range is not finite, before or after the bias, or its normal not unit within
   1e-3); PRT_ERR_MEMORY. Then PRT_ERR_TRACE and PRT_ERR_CANCELLED, after which all points that were finished are valid.
   Accuracy: the 2-norm of the error falls a little faster than samples^-3/4; on the Stanford bunny .0034 at 600 rays;
   370 reach what takes 2500 samples in [Chapter 2010] (docs/bake.md). The arithmetic adds 5e-7 (float, 1e5 rays).
   Cost: samples rays a point, and at 5 bands 2.8 ns a ray on top with AVX-512, 5.0 with SSE2 (docs/bake.md). */
PRTDEF prt_result prt_bake_transfer(const prt_bake_desc *desc, int point_count, const prt_point *points, int first,
                                    int count, prt_real *transfer);

/* Two bakes a, b of the same points with different seeds, [point_count][bands^2] each: mean = (a + b)/2, which has the
   noise of a bake with twice the rays, and error[point_count], the standard error of the mean at each point, estimated
   as |a - b|/2 in the 2-norm of the coefficients: what exit radiance errs by under the worst light of norm 1. For one
   point it is rough; its root mean square over points is good. mean or error may be NULL; mean may be a or b.
   Errors: PRT_ERR_BANDS; PRT_ERR_COUNT; PRT_ERR_NULL (a or b with point_count > 0). Cost: one pass over both. */
PRTDEF prt_result prt_bake_error(int bands, int point_count, const prt_real *a, const prt_real *b, prt_real *mean,
                                 prt_real *error);

#ifdef __cplusplus
}
#endif
#endif /* PRT_BAKE_H_INCLUDED */

/* ==================================================================================================================
   The interface ends here. Below stands the implementation, in the same order.
   ================================================================================================================== */

#if defined(PRT_BAKE_IMPLEMENTATION) && !defined(PRT_BAKE_IMPLEMENTATION_INCLUDED)
#define PRT_BAKE_IMPLEMENTATION_INCLUDED

#include "prt.h"                              /* once more: its private part, had it been included without any */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#if PRT__SIMD && defined(__SSE2__)
#  include <immintrin.h>
#endif

#if defined(PRT_MALLOC) != defined(PRT_FREE)
#  error "prt_bake.h: define both PRT_MALLOC and PRT_FREE, or neither"
#endif
#ifndef PRT_MALLOC
#  define PRT_MALLOC(size) malloc(size)
#  define PRT_FREE(pointer) free(pointer)
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------ >>sample ---- */

#define PRT__GOLDEN UINT64_C(0x9e3779b97f4a7c15)               /* 2^64 / golden ratio */

/* One of 2^64 well mixed values for each pair: the finaliser of [Steele 2014], once for each word. */
PRT__INLINE uint64_t prt__mix(uint64_t v) {
    v = (v ^ (v >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    v = (v ^ (v >> 27)) * UINT64_C(0x94d049bb133111eb);
    return v ^ (v >> 31);
}
PRT__INLINE uint64_t prt__hash(uint64_t a, uint64_t b) {
    return prt__mix(prt__mix(a + PRT__GOLDEN) + PRT__GOLDEN * b);
}

/* A 64-bit fraction as a number in [0,1): its leading 53 bits, so that nothing rounds up to 1. */
PRT__INLINE double prt__unit64(uint64_t fraction) { return (double)(fraction >> 11) * (1.0 / 9007199254740992.0); }

PRT__INLINE int prt__range_ok(int total, int first, int count) {
    return total >= 0 && first >= 0 && count >= 0 && count <= total && first <= total - count;
}

/* The Fibonacci lattice of `total` points, shifted by shift_u of a cell and by shift_v of a turn. */
typedef struct prt__lattice { double cell, shift_u; uint64_t shift_v; } prt__lattice;

PRT__STATIC prt__lattice prt__lattice_of(int total, uint64_t seed, uint64_t index) {
    prt__lattice s;
    uint64_t h = prt__hash(seed, index);
    s.cell = 1.0 / total;
    s.shift_u = prt__unit64(h);
    s.shift_v = prt__mix(h + PRT__GOLDEN);
    return s;
}

PRT__INLINE double   prt__lattice_u(const prt__lattice *s, int k) { return (k + s->shift_u) * s->cell; }
PRT__INLINE uint64_t prt__lattice_v(const prt__lattice *s, int k) { return (uint64_t)k * PRT__GOLDEN + s->shift_v; }

/* A fraction to prt_real without rounding up to 1. */
PRT__INLINE prt_real prt__below_one(double v) {
    prt_real r = (prt_real)v;
    return r < 1 ? r : 1 - PRT__EPS / 2;
}

PRT__STATIC uint32_t prt__reverse_bits(uint32_t v) {
    v = (v >> 16) | (v << 16);
    v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
    v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
    v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
    return ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
}

/* Owen scrambling of a fraction whose bits are given in reverse: each bit is flipped depending on those before it. */
PRT__STATIC uint32_t prt__owen_reversed(uint32_t v, uint32_t seed) {
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return prt__reverse_bits(v);
}

/* Second coordinate of the (0,2)-sequence: the Pascal matrix modulo 2 applied to k, as a fraction of 2^32. */
PRT__STATIC uint32_t prt__sobol_second(uint32_t k) {
    uint32_t column = 0x80000000u, sum = 0;
    for (; k; k >>= 1, column ^= column >> 1) if (k & 1) sum ^= column;
    return sum;
}

/* Cell k of the jittered grid: rows of height proportional to their cells. Of total = rows^2 it is the square grid. */
PRT__STATIC void prt__jittered(int total, int k, double random_u, double random_v, double *u, double *v) {
    int rows = (int)sqrt((double)total), row = (int)((double)k * rows / total), start, cells;
    while ((int64_t)(row + 1) * total / rows <= k) row++;
    while ((int64_t)row * total / rows > k) row--;
    start = (int)((int64_t)row * total / rows);
    cells = (int)((int64_t)(row + 1) * total / rows) - start;
    *u = (start + random_u * cells) / total;
    *v = (k - start + random_v) / cells;
}

PRT__STATIC void prt__square_member(prt_sample_set set, int total, uint64_t seed, uint64_t index, int k,
                                    prt_real *u, prt_real *v) {
    uint64_t base = prt__hash(seed, index), own = prt__hash(base, (uint64_t)k);
    double random_u = prt__unit64(own), random_v = prt__unit64(prt__mix(own + PRT__GOLDEN)), a = random_u, b = random_v;
    if (set == PRT_SAMPLE_FIBONACCI) {
        prt__lattice s = prt__lattice_of(total, seed, index);
        a = prt__lattice_u(&s, k);
        b = prt__unit64(prt__lattice_v(&s, k));
    } else if (set == PRT_SAMPLE_SOBOL) {
        uint32_t second = prt__reverse_bits(prt__sobol_second((uint32_t)k));
        a = prt__owen_reversed((uint32_t)k, (uint32_t)base) / 4294967296.0;
        b = prt__owen_reversed(second, (uint32_t)(base >> 32)) / 4294967296.0;
    } else if (set == PRT_SAMPLE_JITTERED) {
        prt__jittered(total, k, random_u, random_v, &a, &b);
    }
    *u = prt__below_one(a);
    *v = prt__below_one(b);
}

PRTDEF prt_result prt_sample_square(prt_sample_set set, int total, uint64_t seed, uint64_t index, int first, int count,
                                    prt_real *u, prt_real *v) {
    int k;
    if (!prt__range_ok(total, first, count)) return PRT_ERR_COUNT;
    if (count > 0 && (!u || !v)) return PRT_ERR_NULL;
    if ((int)set < 0 || set >= PRT_SAMPLE_SET_COUNT) return PRT_ERR_VALUE;
    for (k = 0; k < count; k++) prt__square_member(set, total, seed, index, first + k, u + k, v + k);
    return PRT_OK;
}

/* The unit vector of height z over a circle of radius r, at v turns. */
PRT__STATIC prt_vec3 prt__on_circle(double r, double z, prt_real v) {
    double angle = 2 * PRT__PI * (double)v;
    return prt__vec3((prt_real)(r * cos(angle)), (prt_real)(r * sin(angle)), (prt_real)z);
}
PRT__INLINE double prt__root_or_0(double v) { return v > 0 ? sqrt(v) : 0; }

PRTDEF prt_vec3 prt_sample_sphere(prt_real u, prt_real v) {
    double a = (double)u;
    return prt__on_circle(2 * prt__root_or_0(a * (1 - a)), 1 - 2 * a, v);
}
PRTDEF prt_vec3 prt_sample_hemisphere(prt_real u, prt_real v) {
    double a = (double)u;
    return prt__on_circle(prt__root_or_0(a * (2 - a)), 1 - a, v);
}
PRTDEF prt_vec3 prt_sample_cosine(prt_real u, prt_real v) {
    double a = (double)u;
    return prt__on_circle(prt__root_or_0(a), prt__root_or_0(1 - a), v);
}

/* Directions are made, and their harmonics summed, in blocks of so many consecutive members: within a block the
   lattice is that of the first block moved and turned, so that a table of one block serves them all. */
enum { PRT__BLOCK = 64 };
typedef struct prt__steps { prt_real member[PRT__BLOCK], cosine[PRT__BLOCK], sine[PRT__BLOCK]; } prt__steps;
typedef struct prt__frame { double t[3], b[3], n[3]; } prt__frame;

PRT__STATIC void prt__steps_of_block(prt__steps *steps) {
    int k;
    for (k = 0; k < PRT__BLOCK; k++) {
        double angle = 2 * PRT__PI * prt__unit64((uint64_t)k * PRT__GOLDEN);
        steps->member[k] = (prt_real)k;
        steps->cosine[k] = (prt_real)cos(angle);
        steps->sine[k] = (prt_real)sin(angle);
    }
}

/* A right-handed orthonormal frame about the normal, [Duff 2017]; the normal is normalised first. */
PRT__STATIC prt__frame prt__frame_about(prt_vec3 normal) {
    prt__frame f;
    double x = (double)normal.x, y = (double)normal.y, z = (double)normal.z, s = 1 / sqrt(x * x + y * y + z * z);
    double sign = z < 0 ? -1.0 : 1.0, a, b;
    x *= s; y *= s; z *= s;
    a = -1 / (sign + z);
    b = x * y * a;
    f.n[0] = x; f.n[1] = y; f.n[2] = z;
    f.t[0] = 1 + sign * x * x * a; f.t[1] = sign * b; f.t[2] = -sign * x;
    f.b[0] = b; f.b[1] = sign + y * y * a; f.b[2] = -y;
    return f;
}

/* Square root, of negative values 0. By intrinsics where the loop below is slow: a compiler may not widen sqrt, which
   reports errors through errno. */
PRT__INLINE prt__vec prt__vec_root(prt__vec v) {
#if PRT__SIMD && defined(__AVX512F__)                  /* maskz: g++ 12 takes the unmasked ones for uninitialised */
#  ifdef PRT_DOUBLE
    return _mm512_maskz_sqrt_pd(0xff, _mm512_maskz_max_pd(0xff, v, prt__vec_set(0)));
#  else
    return _mm512_maskz_sqrt_ps(0xffff, _mm512_maskz_max_ps(0xffff, v, prt__vec_set(0)));
#  endif
#elif PRT__SIMD && defined(__SSE2__)
#  ifdef __AVX__
#    define PRT__MM(name) _mm256_##name
#  else
#    define PRT__MM(name) _mm_##name
#  endif
#  ifdef PRT_DOUBLE
    return PRT__MM(sqrt_pd)(PRT__MM(max_pd)(v, prt__vec_set(0)));
#  else
    return PRT__MM(sqrt_ps)(PRT__MM(max_ps)(v, prt__vec_set(0)));
#  endif
#  undef PRT__MM
#else
    prt_real all[PRT__LANES];
    int k;
    prt__vec_store(all, v);
    for (k = 0; k < PRT__LANES; k++) all[k] = prt__sqrt(all[k] > 0 ? all[k] : 0);
    return prt__vec_load(all);
#endif
}

/* Members base ... base+count-1 of the lattice, cosine-mapped into the frame, to x, y, z; base is a multiple of 64,
   count at most 64. Whole vectors are written: finite numbers stand behind the last member, up to lane 64. */
PRT__STATIC void prt__cosine_block(const prt__lattice *s, const prt__steps *steps, const prt__frame *f, int base,
                                   int count, prt_real *x, prt_real *y, prt_real *z) {
    double angle = 2 * PRT__PI * prt__unit64(prt__lattice_v(s, base)), c = cos(angle), w = sin(angle);
    double u = prt__lattice_u(s, base);
    prt_real t[3], b[3], n[3];
    prt__vec low = prt__vec_set((prt_real)u), high = prt__vec_set((prt_real)(1 - u));   /* exact near the rim */
    prt__vec cell = prt__vec_set((prt_real)s->cell);
    int k;
    for (k = 0; k < 3; k++) {
        t[k] = (prt_real)(c * f->t[k] + w * f->b[k]);
        b[k] = (prt_real)(c * f->b[k] - w * f->t[k]);
        n[k] = (prt_real)f->n[k];
    }
    for (k = 0; k < count; k += PRT__LANES) {
        prt__vec along = prt__vec_load(steps->member + k) * cell;
        prt__vec r = prt__vec_root(low + along), h = prt__vec_root(high - along);
        prt__vec p = r * prt__vec_load(steps->cosine + k), q = r * prt__vec_load(steps->sine + k);
        prt__vec_store(x + k, p * t[0] + q * b[0] + h * n[0]);
        prt__vec_store(y + k, p * t[1] + q * b[1] + h * n[1]);
        prt__vec_store(z + k, p * t[2] + q * b[2] + h * n[2]);
    }
}

PRT__STATIC int prt__unit_within(prt_vec3 v) {                 /* 1e-3 of length 1; false for NaN */
    prt_real square = prt__dot3(v, v);
    return prt__finite(square) && square >= PRT__R(0.999 * 0.999) && square <= PRT__R(1.001 * 1.001);
}

PRTDEF prt_result prt_sample_directions(int total, uint64_t seed, uint64_t index, prt_vec3 normal, int first, int count,
                                        prt_vec3 *dirs) {
    prt_real x[PRT__BLOCK], y[PRT__BLOCK], z[PRT__BLOCK];
    prt__steps steps;
    prt__lattice s;
    prt__frame frame;
    int k, base = -1;
    if (!prt__range_ok(total, first, count)) return PRT_ERR_COUNT;
    if (count > 0 && !dirs) return PRT_ERR_NULL;
    if (!prt__unit_within(normal)) return PRT_ERR_VALUE;
    if (count == 0) return PRT_OK;
    prt__steps_of_block(&steps);
    s = prt__lattice_of(total, seed, index);
    frame = prt__frame_about(normal);
    for (k = 0; k < count; k++) {
        int lane = (first + k) % PRT__BLOCK;
        if (base != first + k - lane) {
            base = first + k - lane;
            prt__cosine_block(&s, &steps, &frame, base, PRT__BLOCK, x, y, z);
        }
        dirs[k] = prt__vec3(x[lane], y[lane], z[lane]);
    }
    return PRT_OK;
}

/* ------------------------------------------------------------------------------------------------- >>point ---- */

PRT__STATIC prt_result prt__mesh_check(const prt_mesh *mesh, const prt_point *points) {
    int k, corners;
    if (!mesh) return PRT_ERR_NULL;
    if (mesh->vertex_count < 0 || mesh->triangle_count < 0) return PRT_ERR_COUNT;
    if (mesh->vertex_count > 0 && (!mesh->positions || !points)) return PRT_ERR_NULL;
    if (mesh->triangle_count > 0 && !mesh->triangles) return PRT_ERR_NULL;
    for (k = 0; k < mesh->triangle_count; k++)
        for (corners = 0; corners < 3; corners++)
            if (mesh->triangles[(size_t)k * 3 + (size_t)corners] >= (uint32_t)mesh->vertex_count) return PRT_ERR_COUNT;
    for (k = 0; k < mesh->vertex_count; k++) if (!prt__finite3(mesh->positions[k])) return PRT_ERR_VALUE;
    return PRT_OK;
}

/* Length of v through its largest component, so that neither tiny nor huge vectors leave the range of double. */
PRT__STATIC double prt__length(const double v[3]) {
    double x = fabs(v[0]), y = fabs(v[1]), z = fabs(v[2]), most = x > y ? x : y;
    most = z > most ? z : most;
    if (!(most > 0)) return 0;
    x = v[0] / most; y = v[1] / most; z = v[2] / most;
    return most * sqrt(x * x + y * y + z * z);
}

/* v / its length, and 1; or 0 where v has no direction. */
PRT__STATIC int prt__normalise(const double v[3], double out[3]) {
    double length = prt__length(v);
    int k, ok = length > 0 && length <= DBL_MAX;
    for (k = 0; k < 3; k++) out[k] = ok ? v[k] / length : 0;
    return ok;
}

PRT__INLINE double prt__ddot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

PRT__STATIC void prt__box(const prt_mesh *mesh, prt_mesh_report *report) {
    double low[3] = { 0, 0, 0 }, high[3] = { 0, 0, 0 }, half[3];
    double radius;
    prt_real centre[3];
    int k, c;
    for (k = 0; k < mesh->vertex_count; k++) {
        double p[3];
        p[0] = (double)mesh->positions[k].x; p[1] = (double)mesh->positions[k].y; p[2] = (double)mesh->positions[k].z;
        for (c = 0; c < 3; c++) {
            if (k == 0 || p[c] < low[c]) low[c] = p[c];
            if (k == 0 || p[c] > high[c]) high[c] = p[c];
        }
    }
    for (c = 0; c < 3; c++) {
        half[c] = high[c] / 2 - low[c] / 2;
        centre[c] = (prt_real)(low[c] + half[c]);
    }
    report->centre = prt__vec3(centre[0], centre[1], centre[2]);
    radius = prt__length(half);
    report->radius = radius < (double)PRT__REAL_MAX ? (prt_real)radius : PRT__REAL_MAX;
}

/* Adds the triangle's unit normal, weighted by angle or by area in units of scale^2, to the normals of its corners, and
   the weight to their position.x, which holds no position yet; 0 if the triangle has no area. scale is a power of 2. */
PRT__STATIC int prt__add_face(const prt_mesh *mesh, const uint32_t *corner, double scale, prt_point *points) {
    double edge[3][3], unit[3][3], normal[3], cross[3];
    int k, area = 1;
    for (k = 0; k < 3; k++) {
        prt_vec3 a = mesh->positions[corner[k]], b = mesh->positions[corner[(k + 1) % 3]];
        edge[k][0] = (double)b.x / scale - (double)a.x / scale;
        edge[k][1] = (double)b.y / scale - (double)a.y / scale;
        edge[k][2] = (double)b.z / scale - (double)a.z / scale;
        area &= prt__normalise(edge[k], unit[k]);
    }
    for (k = 0; k < 3; k++)
        cross[k] = unit[0][(k + 1) % 3] * unit[1][(k + 2) % 3] - unit[0][(k + 2) % 3] * unit[1][(k + 1) % 3];
    if (!area || !(prt__length(cross) > (double)PRT__EPS)) return 0;
    prt__normalise(cross, normal);
    for (k = 0; k < 3; k++) {
        double weight = mesh->area_weighted ? prt__length(cross) * prt__length(edge[0]) * prt__length(edge[1])
                                            : acos(fmax(-1, fmin(1, -prt__ddot(unit[k], unit[(k + 2) % 3]))));
        prt_point *sum = &points[corner[k]];
        sum->normal.x += (prt_real)(weight * normal[0]);
        sum->normal.y += (prt_real)(weight * normal[1]);
        sum->normal.z += (prt_real)(weight * normal[2]);
        sum->position.x += (prt_real)weight;
    }
    return 1;
}

/* The given normal if it is usable, else the sum that stands in the point if its faces do not cancel, else +z. */
PRT__STATIC void prt__settle_normal(const prt_vec3 *given, prt_point *point, prt_mesh_report *report) {
    double v[3], unit[3];
    int ok = 0;
    if (given && prt__finite3(*given)) {
        v[0] = (double)given->x; v[1] = (double)given->y; v[2] = (double)given->z;
        ok = prt__normalise(v, unit);
    }
    if (!ok) {
        v[0] = (double)point->normal.x; v[1] = (double)point->normal.y; v[2] = (double)point->normal.z;
        ok = prt__length(v) > 16 * (double)PRT__EPS * (double)point->position.x && prt__normalise(v, unit);
        report->recomputed++;
        if (!ok) { report->without++; unit[0] = unit[1] = 0; unit[2] = 1; }
    }
    point->normal = prt__vec3((prt_real)unit[0], (prt_real)unit[1], (prt_real)unit[2]);
}

PRTDEF prt_result prt_points_from_vertices(const prt_mesh *mesh, prt_point *points, prt_mesh_report *report) {
    prt_result r = prt__mesh_check(mesh, points);
    prt_mesh_report own;
    double scale;
    int k, exponent;
    if (r != PRT_OK) return r;
    memset(&own, 0, sizeof own);
    prt__box(mesh, &own);
    frexp(own.radius > 0 ? (double)own.radius : 1, &exponent);
    scale = ldexp(1, exponent - 1);
    for (k = 0; k < mesh->vertex_count; k++) points[k].position = points[k].normal = prt__vec3(0, 0, 0);
    for (k = 0; k < mesh->triangle_count; k++)
        own.degenerate += !prt__add_face(mesh, mesh->triangles + (size_t)k * 3, scale, points);
    for (k = 0; k < mesh->vertex_count; k++) {
        prt__settle_normal(mesh->normals ? &mesh->normals[k] : 0, &points[k], &own);
        points[k].position = mesh->positions[k];
    }
    if (report) *report = own;
    return PRT_OK;
}

PRTDEF prt_result prt_points_check(int point_count, const prt_point *points, int first, int count, int *bad) {
    int k, where = -1;
    if (!prt__range_ok(point_count, first, count)) return PRT_ERR_COUNT;
    if (count > 0 && !points) return PRT_ERR_NULL;
    for (k = first; k < first + count && where < 0; k++)
        if (!prt__finite3(points[k].position) || !prt__unit_within(points[k].normal)) where = k;
    if (bad) *bad = where;
    return where < 0 ? PRT_OK : PRT_ERR_VALUE;
}

/* ------------------------------------------------------------------------------------------------ >>direct ---- */

typedef char prt__batch_holds_a_block[PRT_BAKE_BATCH >= PRT__BLOCK ? 1 : -1];

/* Samples of one point between two transfers of the running sums, vectors of prt_real, to the double ones: short enough
   for float, long enough to cost nothing. A multiple of PRT__BLOCK. */
enum { PRT__FLUSH = 1024 };

/* A bake in progress. Rays form one stream, point after point; the buffers hold up to PRT_BAKE_BATCH of it. */
typedef struct prt__bake {
    const prt_bake_desc *desc;
    const prt_point *points;
    prt_real *transfer;
    int bands, coefficients, samples, width;
    prt_real bias;
    prt_ray *rays;                     /* [PRT_BAKE_BATCH] */
    prt_real *x, *y, *z;               /* [PRT_BAKE_BATCH + PRT__BLOCK], their directions */
    unsigned char *blocked;            /* [PRT_BAKE_BATCH + PRT__BLOCK] */
    prt_real *basis;                   /* [coefficients][width] */
    prt_real *running;                 /* [coefficients][PRT__LANES] */
    double *sum;                       /* [coefficients] */
    prt__steps steps;
} prt__bake;

typedef struct prt__cursor { int point, sample; } prt__cursor; /* a place in the stream of rays */

enum { PRT__LINE = 64 };               /* bytes of a cache line */

/* Directions evaluated at a time: fewer where many bands would make the buffer large. */
PRT__STATIC int prt__bake_width(int bands) {
    int width = PRT__BLOCK;
    while (width * (int)sizeof(prt_real) > PRT__LINE && PRT_SH_COUNT(bands) > 16384 / width) width /= 2;
    return width;
}

/* The next piece of memory, on a cache line of its own: a vector that crosses two costs twice. Once a size does not
   fit, *used is SIZE_MAX and stays so. */
PRT__INLINE void *prt__carve(unsigned char *memory, size_t *used, size_t count, size_t size) {
    size_t room = SIZE_MAX - *used, at = *used;
    if (room < PRT__LINE || count > (room - PRT__LINE) / size) { *used = SIZE_MAX; return 0; }
    *used += (count * size + PRT__LINE - 1) / PRT__LINE * PRT__LINE;
    return memory ? memory + at : 0;
}

/* Lays the buffers out in memory, or only measures them where memory is NULL; SIZE_MAX: more than a size_t counts. */
PRT__STATIC size_t prt__bake_layout(prt__bake *b, unsigned char *memory) {
    size_t used = PRT__LINE, n = (size_t)b->coefficients, batch = PRT_BAKE_BATCH;
    if (memory) used -= (size_t)((uintptr_t)memory % PRT__LINE);
    b->rays = (prt_ray *)prt__carve(memory, &used, batch, sizeof *b->rays);
    b->x = (prt_real *)prt__carve(memory, &used, batch + PRT__BLOCK, sizeof *b->x);
    b->y = (prt_real *)prt__carve(memory, &used, batch + PRT__BLOCK, sizeof *b->y);
    b->z = (prt_real *)prt__carve(memory, &used, batch + PRT__BLOCK, sizeof *b->z);
    b->basis = (prt_real *)prt__carve(memory, &used, n, (size_t)b->width * sizeof *b->basis);
    b->running = (prt_real *)prt__carve(memory, &used, n, PRT__LANES * sizeof *b->running);
    b->sum = (double *)prt__carve(memory, &used, n, sizeof *b->sum);
    b->blocked = (unsigned char *)prt__carve(memory, &used, batch + PRT__BLOCK, 1);
    return used;
}

PRT__STATIC void prt__bake_shape(prt__bake *b, int bands) {
    b->bands = bands;
    b->coefficients = PRT_SH_COUNT(bands);
    b->width = prt__bake_width(bands);
}

enum { PRT__DEFAULT_BANDS = 5, PRT__DEFAULT_SAMPLES = 1024 };

PRTDEF size_t prt_bake_transfer_size(int bands, int point_count) {
    size_t row = (size_t)PRT_SH_COUNT(prt__bands_ok(bands) ? bands : 0) * sizeof(prt_real);
    return row == 0 || point_count < 0 || (size_t)point_count > SIZE_MAX / row ? 0 : row * (size_t)point_count;
}

PRTDEF size_t prt_bake_scratch_size(int bands) {
    prt__bake b;
    size_t size;
    if (bands == 0) bands = PRT__DEFAULT_BANDS;
    if (!prt__bands_ok(bands)) return 0;
    memset(&b, 0, sizeof b);
    prt__bake_shape(&b, bands);
    size = prt__bake_layout(&b, 0);
    return size < SIZE_MAX ? size : 0;
}

/* Where a point's rays start. */
PRT__INLINE prt_vec3 prt__bake_origin(const prt__bake *b, const prt_point *p) {
    return prt__vec3(p->position.x + b->bias * p->normal.x, p->position.y + b->bias * p->normal.y,
                     p->position.z + b->bias * p->normal.z);
}

PRT__STATIC void prt__bake_block_rays(prt__bake *b, const prt_point *point, int first, int count) {
    prt_ray ray;
    int k;
    ray.origin = prt__bake_origin(b, point);
    ray.tmin = 0;
    ray.tmax = PRT__R(FLT_MAX);
    for (k = first; k < first + count; k++) {
        ray.dir = prt__vec3(b->x[k], b->y[k], b->z[k]);
        b->rays[k] = ray;
    }
}

PRT__INLINE int prt__block_at(const prt__bake *b, prt__cursor at) {   /* members of the block that starts there */
    return b->samples - at.sample < PRT__BLOCK ? b->samples - at.sample : PRT__BLOCK;
}

PRT__INLINE void prt__advance(const prt__bake *b, prt__cursor *at, int count) {
    at->sample += count;
    if (at->sample == b->samples) { at->sample = 0; at->point++; }
}

/* Fills the buffers from `at` on, block by block, with as much as they hold of the points below `end`. */
PRT__STATIC int prt__bake_fill(prt__bake *b, prt__cursor *at, int end) {
    prt__lattice lattice;
    prt__frame frame;
    int queued = 0, point = -1;
    while (at->point < end) {
        int count = prt__block_at(b, *at);
        if (queued + count > PRT_BAKE_BATCH) break;
        if (point != at->point) {
            point = at->point;
            lattice = prt__lattice_of(b->samples, b->desc->seed, (uint64_t)point);
            frame = prt__frame_about(b->points[point].normal);
        }
        prt__cosine_block(&lattice, &b->steps, &frame, at->sample, count, b->x + queued, b->y + queued, b->z + queued);
        if (b->desc->tracer) prt__bake_block_rays(b, &b->points[point], queued, count);
        queued += count;
        prt__advance(b, at, count);
    }
    return queued;
}

/* running[i] += open . basis[i] over so many lanes, for each coefficient. Inlined for a constant width. */
PRT__INLINE void prt__bake_sum_rows(const prt__bake *b, int width, const prt_real *open) {
    const prt_real *row = b->basis;
    prt_real *running = b->running;
    int i, k;
    for (i = 0; i < b->coefficients; i++, row += width, running += PRT__LANES) {
        prt__vec sum = prt__vec_load(running);
        for (k = 0; k < width; k += PRT__LANES) sum += prt__vec_load(open + k) * prt__vec_load(row + k);
        prt__vec_store(running, sum);
    }
}

/* The basis of the block's open directions, added to the running sums. Lanes past the last member count as blocked. */
PRT__STATIC void prt__bake_add_block(prt__bake *b, int first, int count) {
    prt_real open[PRT__BLOCK];
    int k, from;
    if (!memchr(b->blocked + first, 0, (size_t)count)) return;
    for (k = 0; k < PRT__BLOCK; k++) open[k] = (prt_real)(b->blocked[first + k] == 0);
    for (k = count; k < PRT__BLOCK; k++) open[k] = 0;
    for (from = 0; from < count; from += b->width) {
        int lanes = count - from < b->width ? count - from : b->width, at = first + from;
        lanes = (lanes + PRT__LANES - 1) / PRT__LANES * PRT__LANES;
        prt_sh_eval_soa(b->bands, lanes, b->x + at, b->y + at, b->z + at, b->basis, (size_t)b->width);
        if (b->width == PRT__BLOCK) prt__bake_sum_rows(b, PRT__BLOCK, open);
        else prt__bake_sum_rows(b, b->width, open + from);
    }
}

PRT__STATIC void prt__bake_flush(prt__bake *b) {
    int i, k;
    for (i = 0; i < b->coefficients; i++) {
        prt_real *running = b->running + (size_t)i * PRT__LANES;
        for (k = 0; k < PRT__LANES; k++) {
            b->sum[i] += (double)running[k];
            running[k] = 0;
        }
    }
}

PRT__STATIC void prt__bake_finish(prt__bake *b, int point) {
    prt_real *row = b->transfer + (size_t)point * (size_t)b->coefficients;
    int i;
    for (i = 0; i < b->coefficients; i++) {
        row[i] = (prt_real)(b->sum[i] / b->samples);
        b->sum[i] = 0;
    }
}

/* Sums the queued rays from `at` on; finishes each point whose last ray is among them. */
PRT__STATIC prt_result prt__bake_drain(prt__bake *b, prt__cursor *at, int queued, int first, int count) {
    int k = 0;
    while (k < queued) {
        int members = prt__block_at(b, *at), point = at->point;
        prt__bake_add_block(b, k, members);
        k += members;
        prt__advance(b, at, members);
        if (at->sample % PRT__FLUSH == 0) prt__bake_flush(b);
        if (at->point == point) continue;
        prt__bake_finish(b, point);
        if (b->desc->progress && b->desc->progress(b->desc->progress_user, point - first + 1, count))
            return PRT_ERR_CANCELLED;
    }
    return PRT_OK;
}

PRT__STATIC prt_result prt__bake_range(prt__bake *b, int first, int count) {
    const prt_tracer *tracer = b->desc->tracer;
    prt__cursor filled, drained;
    prt_result r = PRT_OK;
    filled.point = drained.point = first;
    filled.sample = drained.sample = 0;
    while (r == PRT_OK && drained.point < first + count) {
        int queued = prt__bake_fill(b, &filled, first + count);
        memset(b->blocked, 0, (size_t)queued);
        if (tracer && tracer->occluded(tracer->user, queued, b->rays, b->blocked)) return PRT_ERR_TRACE;
        r = prt__bake_drain(b, &drained, queued, first, count);
    }
    return r;
}

/* Resolves the defaults of desc into b; the checks in the order that the interface promises. */
PRT__STATIC prt_result prt__bake_open(prt__bake *b, const prt_bake_desc *desc, int point_count, const prt_point *points,
                                      int first, int count, prt_real *transfer) {
    prt_result r;
    int bands, k;
    if (!desc) return PRT_ERR_NULL;
    bands = desc->bands ? desc->bands : PRT__DEFAULT_BANDS;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (desc->samples < 0 || !prt__range_ok(point_count, first, count)) return PRT_ERR_COUNT;
    if (count > 0 && !prt_bake_transfer_size(bands, point_count)) return PRT_ERR_CAPACITY;
    if (!prt_bake_scratch_size(bands)) return PRT_ERR_CAPACITY;
    if (count > 0 && (!points || !transfer)) return PRT_ERR_NULL;
    if (desc->tracer && !desc->tracer->occluded) return PRT_ERR_NULL;
    if (!(desc->bias >= 0 && prt__finite(desc->bias))) return PRT_ERR_VALUE;
    if (!(desc->scene_radius >= 0 && prt__finite(desc->scene_radius))) return PRT_ERR_VALUE;
    memset(b, 0, sizeof *b);
    b->desc = desc;
    b->points = points;
    b->transfer = transfer;
    b->samples = desc->samples ? desc->samples : PRT__DEFAULT_SAMPLES;
    b->bias = desc->bias;
    if (b->bias <= 0) b->bias = PRT__R(1e-4) * (desc->scene_radius > 0 ? desc->scene_radius : 1);
    prt__bake_shape(b, bands);
    r = prt_points_check(point_count, points, first, count, 0);
    for (k = first; r == PRT_OK && k < first + count; k++)
        if (!prt__finite3(prt__bake_origin(b, &points[k]))) r = PRT_ERR_VALUE;
    return r;
}

PRTDEF prt_result prt_bake_transfer(const prt_bake_desc *desc, int point_count, const prt_point *points, int first,
                                    int count, prt_real *transfer) {
    prt__bake b;
    prt_result r = prt__bake_open(&b, desc, point_count, points, first, count, transfer);
    size_t size;
    void *memory;
    if (r != PRT_OK || count == 0) return r;
    size = prt_bake_scratch_size(b.bands);
    memory = PRT_MALLOC(size);
    if (!memory) return PRT_ERR_MEMORY;
    memset(memory, 0, size);
    prt__bake_layout(&b, (unsigned char *)memory);
    prt__steps_of_block(&b.steps);
    r = prt__bake_range(&b, first, count);
    PRT_FREE(memory);
    return r;
}

PRTDEF prt_result prt_bake_error(int bands, int point_count, const prt_real *a, const prt_real *b, prt_real *mean,
                                 prt_real *error) {
    int k, i;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (point_count < 0) return PRT_ERR_COUNT;
    if (point_count > 0 && (!a || !b)) return PRT_ERR_NULL;
    for (k = 0; k < point_count; k++) {
        size_t row = (size_t)k * (size_t)PRT_SH_COUNT(bands);
        double square = 0;
        for (i = 0; i < PRT_SH_COUNT(bands); i++) {
            double one = (double)a[row + (size_t)i], two = (double)b[row + (size_t)i];
            square += (one - two) * (one - two);
            if (mean) mean[row + (size_t)i] = (prt_real)((one + two) / 2);
        }
        if (error) error[k] = (prt_real)(sqrt(square) / 2);
    }
    return PRT_OK;
}

#ifdef __cplusplus
}
#endif
#endif /* PRT_BAKE_IMPLEMENTATION */

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
