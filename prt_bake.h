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
     2. prt_bake_desc              zero-initialise (= { 0 }; C++ = {}), then set what you do not want at its default
     3. prt_bake_transfer          rays in, transfer out: points[k] -> transfer[k][bands^2]; any part of the points at a
                                   time, in any thread, process or machine, with the same bits
     4. prt_bake_error             of two bakes with different seeds: their mean, and its standard error at each point
     5. prt_bake_bounces           where light that other surfaces reflect matters: interreflection, added to transfer
     6. prt_transfer_pack          to a half or a quarter of the memory, where that is precious
     7. prt_shade_diffuse (prt.h)  transfer and light -> exit radiance, at run time; prt_shade_diffuse_rgb after
                                   interreflection between coloured surfaces, prt_shade_packed_n from packed transfer
     For glossy surfaces: prt_bake_glossy makes a matrix a point; prt_shade_incident, prt_shade_glossy shade from it.
     For moving occluders (prt_fiv_shade): prt_fiv_distances, prt_bake_fiv_table, prt_bake_fiv_inside, prt_bake_fiv_total.
     For vector occluders (prt_vo_shade) instead: prt_bake_vo_ao, prt_bake_vo, prt_vo_compact.
     Rooms, by the tag to grep for: >>types, >>sample point sets, >>point bake points, >>direct transfer, >>bounce
     interreflection, >>glossy transfer matrices, >>pack storage, >>fiv fullsphere irradiance vectors, >>vo vector
     occluders, >>measure what a scene requires.

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
     prt_tracer.closest, for prt_bake_bounce, prt_bake_glossy, prt_bake_vo and prt_bake_fiv_inside, says what each ray
     meets first between tmin and tmax, by the same rules:
     - hits[k].object is -1 on entry; leave it so where nothing is met. Else fill all of hits[k]: normals point outward
       from closed objects, whichever side is met. object is an index into the objects of the desc; primitive, u and v
       are read where that object has groups or triangles.
     - A batch holds rays of one point: feelers, by PRT_BAKE_BATCH, and then those that follow from their hits.
       prt_bake_fiv_inside mixes points, and reads no more than whether object is below 0, and the normal.

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
     (float; double: 104, 147, 634). Of prt_bake_bounce: 78 KiB at 5 bands, 125 at 64 (double: 147, 210), and with
     three planes 221 (338). Of prt_bake_vo: 166 KiB (double: 267) and 164 bytes for each occluder of the scene.
     points and rays a point are int; their product may exceed it.

   REFERENCES (beside those of prt.h)
     [Burley 2020]     Burley: Practical Hash-based Owen Scrambling. JCGT 9(4), 2020
     [Chen 2005]       Chen: A Real-Time Global Illumination Algorithm based on Pre-Computed Radiance Transfer. MSc
                       thesis, National Chiao Tung University, 2005
     [Cranley 1976]    Cranley, Patterson: Randomization of Number Theoretic Methods for Multiple Integration. 1976
     [Duff 2017]       Duff et al.: Building an Orthonormal Basis, Revisited. JCGT 6(1), 2017
     [Marques 2013]    Marques et al.: Spherical Fibonacci Point Sets for Illumination Integrals. CGF 32(8), 2013
     [Miller 1955]     Miller: Note on the Bias of Information Estimates. Information Theory in Psychology, 1955
     [Shannon 1948]    Shannon: A Mathematical Theory of Communication. Bell System Technical Journal 27, 1948
     [Sherif 2013]     Sherif: Vector Occluders. MSc thesis, University of Ontario Institute of Technology, 2013
     [Steele 2014]     Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators. OOPSLA 2014
     [Thuermer 1998]   Thuermer, Wuethrich: Computing Vertex Normals from Polygonal Facets. JGT 3(1), 1998
     [Westin 1992]     Westin, Arvo, Torrance: Predicting Reflectance Functions from Complex Surfaces. SIGGRAPH 1992
     [Wigner 1959]     Wigner: Group Theory and its Application to the Quantum Mechanics of Atomic Spectra. 1959
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
    int bands;                         /* [5, or PRT_MAX_BANDS if that is less] */
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

/* ------------------------------------------------------------------------------------------------ >>bounce ---- */

/* Light that reaches a point by way of other diffuse surfaces [Sloan 2002, 5.2; Sherif 2013, 6.2; Chen 2005, equations
   2, 3]. Exit radiance at a point is albedo * sum_i (T0 + T1 + T2 + ...)_i L_i, with T0 from prt_bake_transfer and

     T(k)_i(x) = (1/pi) int max(0, N.w) albedo(y) T(k-1)_i(y) dw,  y = what the ray from x in direction w meets first,

   one further bounce each: what y reflects of the light L is albedo(y) T(k-1)(y).L. The albedo of x itself is left to
   shading. Each bounce is computed from the one before it alone (Jacobi), never in place, so no order plays a role. */
typedef struct prt_bounce_object {     /* zero-initialise: reflects nothing */
    int triangle_count;                /* prt_hit.primitive is below it where the object reflects */
    const uint32_t *triangles;         /* [triangle_count][3] corners of each primitive; NULL: reflects nothing */
    int first_point;                   /* row of corner 0 in `points`, added to each corner */
    int back_offset;                   /* 0: the back of a face (normal along the ray) is black, as inside closed
                                          objects. Else a sheet: the row of each corner's back, a point of its own with
                                          the normal reversed, lies so many rows further on (less: negative) */
    prt_rgb albedo;                    /* 0 ... 1 */
    const prt_rgb *albedos;            /* of each corner, by its number in triangles; times albedo. NULL: 1 */
} prt_bounce_object;

typedef struct prt_bounce_desc {       /* zero-initialise; 0 means the default in brackets */
    int bands;                         /* [5, or PRT_MAX_BANDS if that is less] */
    int samples;                       /* rays a point [1024] */
    uint64_t seed;
    prt_real bias, scene_radius;       /* as in prt_bake_desc */
    int planes;                        /* of what is written: 1, or 3 for r, g, b [prt_bounce_planes] */
    int previous_planes;               /* of what is read: 1, or 3 if planes is [1] */
    int object_count;
    const prt_bounce_object *objects;  /* [object_count], by prt_hit.object */
    const prt_tracer *tracer;          /* required, with `closest` */
    prt_progress progress; void *progress_user;
} prt_bounce_desc;

/* The planes that interreflection among these objects needs: 1 while all albedos are grey (r = g = b), for then one
   transfer vector serves all channels; 3 as soon as one is coloured. NULL: 1. Cost: a pass over the albedos. */
PRTDEF int prt_bounce_planes(int object_count, const prt_bounce_object *objects);

/* Bytes of [point_count][planes][bands^2] numbers; 0 if an argument is out of range or a size_t does not hold it. */
PRTDEF size_t prt_bounce_size(int bands, int planes, int point_count);

/* Bytes that prt_bake_bounce takes from PRT_MALLOC, in one piece; 0 if desc is NULL, or bands or planes are out of
   range. */
PRTDEF size_t prt_bake_bounce_scratch_size(const prt_bounce_desc *desc);

/* One further bounce at points[first ... first+count-1], from `previous`, the transfer of the bounce before at all
   points: previous[point_count][previous_planes][bands^2] (T0 at first), to the same rows of
   out[point_count][planes][bands^2]; no other row is touched. out must not overlap previous.

   T(k) = (1/samples) sum over the rays that hit of albedo * T(k-1), both interpolated between the corners of the
   face. Rays are those of prt_bake_transfer of the same samples and seed, so that its open rays and the hits here
   add up to all: in a white furnace (L = 1, albedos 1) the bounces add up to what exactly was missing.

   The bits of a row depend on desc, previous, its point and its index alone. Errors, before anything is written:
   PRT_ERR_NULL (desc); PRT_ERR_BANDS; PRT_ERR_COUNT (samples < 0; planes or previous_planes not 0, 1 or 3, or planes
   below previous_planes; object_count or a triangle_count < 0; a corner whose row, or its back's, is none of the
   points; a range as in prt_bake_transfer); PRT_ERR_CAPACITY; PRT_ERR_NULL (points, previous or out with
   count > 0; objects with object_count > 0; tracer or its `closest`); PRT_ERR_VALUE (an albedo outside 0 ... 1, or
   coloured where planes is 1; bias, scene_radius, points as in prt_bake_transfer); PRT_ERR_MEMORY. Then PRT_ERR_TRACE,
   when the callback fails or returns a hit that cannot be: an unknown object, t below 0, a normal that is not unit
   within 1e-3; at objects that reflect also a primitive out of range, u, v or u + v outside 0 ... 1 by more than 1e-3;
   numbers that are not finite; and PRT_ERR_CANCELLED. Points finished before stay valid. previous is not checked.
   Accuracy: as prt_bake_transfer's by rays (docs/bounce.md); interpolation assumes that T changes little across a face.
   Cost: one closest-hit ray a sample, and 3 planes bands^2 multiply-adds a hit. */
PRTDEF prt_result prt_bake_bounce(const prt_bounce_desc *desc, int point_count, const prt_point *points,
                                  const prt_real *previous, int first, int count, prt_real *out);

/* total += bounce, [point_count][total_planes or bounce_planes][bands^2]; one plane is added to each of three.
   *strength (may be NULL) = 2 sqrt(pi) times the largest T_0 of the bounce, over points and planes: what it can add at
   most to exit radiance at albedo 1, anywhere, under any light 0 <= L <= 1 (before that is cut to its bands). If no
   albedo exceeds a, all further bounces together add at most strength a/(1-a).
   Errors: PRT_ERR_BANDS; PRT_ERR_COUNT (point_count < 0, planes other than 1 or 3, fewer in total than in bounce);
   PRT_ERR_NULL (point_count > 0). total may be bounce. Cost: one pass. */
PRTDEF prt_result prt_bounce_add(int bands, int point_count, int bounce_planes, const prt_real *bounce,
                                 int total_planes, prt_real *total, prt_real *strength);

/* T0 and up to `bounces` bounces in one call: direct[point_count][previous_planes][bands^2] to
   total[point_count][planes][bands^2], which may be direct where both have as many planes. Stops after a bounce whose
   strength (prt_bounce_add) is at most `least`, >= 0. *made (may be NULL) receives the bounces made, also after
   PRT_ERR_CANCELLED and PRT_ERR_TRACE, when total holds T0 and the bounces that were completed. 0 bounces: total is T0.
   To share the work among threads, call prt_bake_bounce on ranges and prt_bounce_add in this order instead.
   Errors: as prt_bake_bounce; PRT_ERR_COUNT (bounces < 0); PRT_ERR_CAPACITY (bounces point_count exceeds an int);
   PRT_ERR_VALUE (least). progress counts points of all bounces. Memory: two further transfers, from PRT_MALLOC. */
PRTDEF prt_result prt_bake_bounces(const prt_bounce_desc *desc, int bounces, prt_real least, int point_count,
                                   const prt_point *points, const prt_real *direct, prt_real *total, int *made);

/* ------------------------------------------------------------------------------------------------ >>glossy ---- */

/* Transfer matrices for prt_shade_incident: what of a light arrives at a point, and from where, whatever its surface
   does with it.
     M_ij = int over N.w > 0 of Y_i(w) R_j(w) dw,  R_j(w) = Y_j(w) where the ray is open,
                                                   albedo(y) T_j(y) where it meets the diffuse surface y
   i < bands_out^2 counts arriving radiance, j < bands_in^2 light; T is the transfer of y, bounces included. Below the
   horizon nothing arrives. Glossy light that other surfaces send is left out: their diffuse part alone is reflected. */

/* Bytes of matrices[point_count][planes][bands_out^2][bands_in^2]; 0 if an argument is out of range or a size_t does
   not hold it. */
PRTDEF size_t prt_glossy_size(int bands_in, int bands_out, int planes, int point_count);

/* Matrices of points[first ... first+count-1] into the same places of matrices; no other is touched.
   desc       as for prt_bake_bounce; bands counts those of the light, samples defaults to [4096]. Its objects, planes
              and previous_planes (those of transfer) are read where transfer is given. Without a tracer all is open.
   bands_out  of arriving radiance; 0: as many as of the light
   transfer   [point_count][previous_planes][bands^2] of all points, for interreflection, which takes `closest`; NULL:
              shadows alone, which take `occluded`, and one plane
   Estimated over `samples` directions even over the hemisphere, a Fibonacci lattice shifted at random: unbiased.
   The bits of a matrix depend on desc, bands_out, transfer, its point and its index alone. Errors: as prt_bake_bounce,
   PRT_ERR_BANDS also for bands_out, PRT_ERR_NULL also for the callback that is needed; without transfer none of
   objects.
   Accuracy: 2-norm of the error .010 of that of the matrix at 1024 rays, .0026 at 4096 (5 bands under a ball,
   tests/test_bake_glossy.c). Cost: a ray a sample, and planes bands_out^2 bands_in^2 multiply-adds.
   Memory: the sums of one matrix in double, 64 values of each harmonic, and as prt_bake_bounce. */
PRTDEF prt_result prt_bake_glossy(const prt_bounce_desc *desc, int bands_out, int point_count, const prt_point *points,
                                  const prt_real *transfer, int first, int count, prt_real *matrices);

/* Multiplies, in place, what runs after a matrix [planes][bands_out^2][bands_in^2] into it: M := F R M. R turns what
   arrives by `rotation` (NULL: not), as prt_local_frame makes it; F are the factors sqrt(4 pi/(2l+1)) zonal_l of a
   BRDF's lobe (NULL: none). Shading then is prt_shade_incident and prt_shade_glossy with zonal NULL, dir in the turned axes.
   Errors: PRT_ERR_BANDS; PRT_ERR_COUNT (planes); PRT_ERR_NULL (matrix); PRT_ERR_ROTATION; PRT_ERR_VALUE (zonal is not
   finite). Cost: prt_sh_rotate for each of bands_in^2 columns. Stack: PRT_MAX_BANDS^2 prt_reals beside its own. */
PRTDEF prt_result prt_glossy_fold(int bands_in, int bands_out, int planes, const prt_real *rotation,
                                  const prt_real *zonal, prt_real *matrix);

/* The matrix of a BRDF in its local frame [Sloan 2002, 5.3; Westin 1992], for prt_shade_incident with one plane, from
   arriving radiance turned into that frame to exit radiance around the point:
     B_ij = int int over z > 0 of Y_i(v) f(w, v) w.z Y_j(w) dw dv,
   f(w, v) from the callback, for unit directions w to the light and v to the eye, z the normal. Estimated over samples
   x samples directions (0: 1024 each), v by a Fibonacci lattice even over the hemisphere, w by one that is cosine-
   distributed, another one for each v. matrix[bands_out^2][bands_in^2]. Errors: PRT_ERR_BANDS; PRT_ERR_COUNT (samples);
   PRT_ERR_NULL; PRT_ERR_VALUE (f is not finite, which ends it with nothing written); PRT_ERR_CAPACITY; PRT_ERR_MEMORY.
   Cost: samples^2 calls of f and bands_in^2 multiply-adds each. */
typedef prt_real prt_brdf(void *user, prt_vec3 to_light, prt_vec3 to_eye);
PRTDEF prt_result prt_glossy_brdf(int bands_in, int bands_out, int samples, prt_brdf *f, void *user, prt_real *matrix);

/* ------------------------------------------------------------------------------------------------ >>pack ---- */

/* Bytes of packed transfer, for prt_transfer_pack; 0 for a bad argument, or where a size_t does not hold them. */
PRTDEF size_t prt_transfer_packed_size(int bands, prt_storage storage, int point_count);

/* Packs transfer[point_count][bands^2] into data, of prt_transfer_packed_size, and describes it in *packed, which
   prt_shade_packed_n (prt.h) shades from. Each coefficient has a range of its own, [min, max] over the points
   ([Chapter 2010], 4.2): low_i = min, step_i = (max - min)/65535 or /255, q = the integer next to (v - low_i)/step_i.
   low, step   [bands^2]; NULL for PRT_STORAGE_HALF
   One call, one set of ranges: pack together what is shaded together, a mesh or an atlas.
   Errors, before anything is written: PRT_ERR_BANDS; PRT_ERR_COUNT; PRT_ERR_CAPACITY (the size overflows);
   PRT_ERR_NULL; PRT_ERR_VALUE (storage; a value not finite, beyond 65504 for halves, or a quarter of the
   largest number).
   Cost: two passes. Accuracy: step_i/2 and 2 ulp of the largest value of the coefficient; halves 2^-11 of the value,
   below 6.1e-5 2^-25 (tests/test_pack.c). What that is in pictures: docs/choose.md. */
PRTDEF prt_result prt_transfer_pack(int bands, prt_storage storage, int point_count, const prt_real *transfer,
                                    void *data, prt_real *low, prt_real *step, prt_packed_transfer *packed);

/* --------------------------------------------------------------------------------------------------- >>fiv ---- */

/* What >>fiv of prt.h looks up: the vectors of the part of an environment that an object hides, for a grid of places of
   the object around a receiver. */

typedef struct prt_fiv_env {           /* a distant environment, zero-initialise: a cube map, or else an image */
    int cube_size;                     /* > 0: six faces of cube_size^2 texels of 3 floats, linear, laid out and */
    const float *faces[6];             /* oriented as for prt_sh_project_cubemap_rgb */
    int width, height;                 /* else a latitude-longitude image, as for prt_sh_project_equirect_rgb */
    const float *equirect;
    prt_progress progress; void *progress_user;   /* of prt_bake_fiv_irradiance and _total, after every normal */
} prt_fiv_env;

typedef struct prt_fiv_desc {          /* zero-initialise; 0 means the default in brackets */
    int theta_count, phi_count, rho_count;   /* the grid, as in prt_fiv_table; each at least 1 */
    const prt_real *rho;               /* [rho_count] increasing, > 0: see prt_fiv_distances */
    prt_vec3 centre;                   /* bounding sphere of the object where the tracer has it */
    prt_real radius;                   /* > 0 */
    const prt_tracer *tracer;          /* `occluded` is required; `closest` for prt_bake_fiv_inside */
    const prt_fiv_env *env;            /* required by prt_bake_fiv_table */
    int rays;                          /* least number of rays into the cone, on average; 1: one a texel [256] */
    prt_progress progress; void *progress_user;   /* after every sample: done of count */
} prt_fiv_desc;

/* Samples of the grid, theta_count phi_count rho_count; 0 if desc is NULL, a count is below 1, or there are more than
   an int counts. Sample (k,i,j) stands at index (k theta_count + i) phi_count + j. */
PRTDEF int prt_bake_fiv_count(const prt_fiv_desc *desc);

/* rho[count] from nearest to farthest in geometric steps, for even error: between rho and q rho a linear interpolation
   of 1/rho^2, the law by which distant objects hide light, errs by at most e = (1+q^-2)/2 ((1+q)/2)^2 - 1, about
   3/4 (q-1)^2, of the value there, the same in every interval; equal steps err 4 times too much where 2 times too near.
   q = (farthest/nearest)^(1/(count-1)): 1.07 gives .0035, 1.15 .015. With one distance it is `nearest`.
   For objects that stand on receivers begin inside the bounding sphere, at half the radius, say; 1.05 radius will do
   for objects that float. Beyond `farthest` the lookup falls off by the same law.
   Errors: PRT_ERR_COUNT (count < 1); PRT_ERR_NULL; PRT_ERR_VALUE unless 0 < nearest < farthest < infinity. */
PRTDEF prt_result prt_fiv_distances(int count, prt_real nearest, prt_real farthest, prt_real *rho);

/* The vectors of samples first ... first+count-1 into the same places of samples[prt_bake_fiv_count]; no other is
   touched.
     FIV = sum of L v over the texels whose centre the object hides,  v = int w dw over the texel,
   v in closed form, half the integral of r x dr around the texel: half the sum of arc times normal over its edges. Rays
   start from where the receiver sees the object at (theta_i, phi_j, rho_k) and go through the texels whose centres lie
   inside the cone around the bounding sphere, no other, and through none that is black: under a full sky about
   c = texels (1 - sqrt(1 - (R/rho)^2))/2 of them, all where rho <= R. Where c < rays a texel gets s^2 rays through the
   centres of its parts, s = ceil(sqrt(rays/c)) up to 16, of which again only those inside the cone are traced, and its
   share of hits instead of all or nothing: far places are then as good as near ones. What a ray hits at any distance
   hides. The bits of a sample depend on desc and its index alone. Errors, in this order, before anything is written:
   PRT_ERR_NULL (desc); PRT_ERR_COUNT (grid, range, sizes of env, to 16384; rays < 0);
   PRT_ERR_NULL (rho, tracer, its occluded, env, its texels, samples); PRT_ERR_VALUE (rho not increasing from above 0,
   radius not above 0, centre not finite); PRT_ERR_CAPACITY; PRT_ERR_MEMORY; PRT_ERR_VALUE (a texel not finite). Then
   PRT_ERR_TRACE, PRT_ERR_CANCELLED: what is finished is valid.
   Memory: 53 bytes a texel (float; double 101), and PRT_BAKE_BATCH rays. Cost beside tracing, Zen 5: 15 ns a ray
   through a texel's centre, 30 through a part of it. */
PRTDEF prt_result prt_bake_fiv_table(const prt_fiv_desc *desc, int first, int count, prt_fiv *samples);

/* Bytes of samples[prt_bake_fiv_count][(bands+1)^2], 0 if an argument is out of range or a size_t does not hold it. */
PRTDEF size_t prt_bake_fiv_transfer_size(const prt_fiv_desc *desc, int bands);

/* The same for every light of `bands` bands, 1 ... PRT_MAX_BANDS - 1 (prt_fiv_transfer):
     samples[k][j] = int over the hidden directions of Y_j dw,  (bands+1)^2 of them,
   from desc->rays rays [1024] a sample, a Fibonacci lattice over the cap around the bounding sphere, moved at random
   from sample to sample. env is not read. Errors: as prt_bake_fiv_table without those of env, PRT_ERR_BANDS,
   PRT_ERR_CAPACITY. A batch holds rays of one sample only. Accuracy: as prt_bake_transfer's by rays, in units of the
   cap. */
PRTDEF prt_result prt_bake_fiv_transfer(const prt_fiv_desc *desc, int bands, int first, int count, prt_real *samples);

/* The transfer table made of a desc and what was baked from it, as prt_fiv_table_of. */
PRTDEF prt_fiv_transfer prt_fiv_transfer_of(const prt_fiv_desc *desc, int bands, const prt_real *samples,
                                            const unsigned char *inside);

/* Which samples lie inside the object, for the same range: inside[k] = 1 where more than half of 64 rays meet the back
   of a surface first (hit.normal along the ray), so that meshes with holes count as closed; 0 elsewhere and wherever
   rho > radius. Uses tracer->closest. Errors: as prt_bake_fiv_table, without env. */
PRTDEF prt_result prt_bake_fiv_inside(const prt_fiv_desc *desc, int first, int count, unsigned char *inside);

/* The table made of a desc and what was baked from it; inside may be NULL. What it points to stays yours. A zero table
   if desc is NULL. */
PRTDEF prt_fiv_table prt_fiv_table_of(const prt_fiv_desc *desc, const prt_fiv *samples, const unsigned char *inside);

/* The vectors of the whole environment (prt_fiv_self), exact: sum of L v over all texels.
   Errors: PRT_ERR_COUNT, PRT_ERR_NULL, PRT_ERR_VALUE (a texel not finite), PRT_ERR_CAPACITY, PRT_ERR_MEMORY. */
PRTDEF prt_result prt_bake_fiv_environment(const prt_fiv_env *env, prt_fiv *fiv);

/* I_tot(N) = int L max(0, N.w) dw for count unit normals, exact for texels of constant radiance: texels that the
   horizon cuts are clipped by it, in closed form. Cost: a multiply-add a texel and channel, and 0.3 us for each of the
   few that the horizon cuts. Errors: as prt_bake_fiv_environment, with PRT_ERR_COUNT (count < 0), PRT_ERR_VALUE (a
   normal not finite or not unit within 1e-3), PRT_ERR_CANCELLED by env->progress: what is finished is valid. */
PRTDEF prt_result prt_bake_fiv_irradiance(const prt_fiv_env *env, int count, const prt_vec3 *normals, prt_rgb *total);

/* The same at texels first ... first+count-1 of a cube texture total[6][size][size], to be read by prt_fiv_total or by
   a GPU: faces and rows as in prt_sh_project_cubemap_rgb, N through the centre of the texel.
   Errors: as prt_bake_fiv_irradiance; PRT_ERR_COUNT also for size < 1, 6 size^2 beyond an int, or a bad range. */
PRTDEF prt_result prt_bake_fiv_total(const prt_fiv_env *env, int size, int first, int count, prt_rgb *total);

/* ---------------------------------------------------------------------------------------------------- >>vo ---- */

/* Vector occluders for prt_vo_shade [Sherif 2013, chapter 7.2], in two passes over the same points: prt_bake_vo_ao,
   then prt_bake_vo. An occluder is a group of primitives of one object; prt_vo_split makes groups. */
typedef struct prt_vo_object {         /* zero-initialise; 0 means the default in brackets */
    prt_rgb diffuse, specular, transmissive;   /* each channel 0 ... 1 */
    prt_real refraction;               /* refractive index of the inside against the outside [1.5] */
    int primitive_count;               /* needed where groups or triangles are given */
    int group_count;                   /* occluders that the object falls into [1] */
    const int *groups;                 /* [primitive_count], each 0 ... group_count - 1; NULL: all 0 */
    const uint32_t *triangles;         /* [primitive_count][3]: the points (indices into `points`) at the corners of
                                          each primitive, where ambient occlusion is looked up; NULL: hits
                                          count as open */
} prt_vo_object;

typedef struct prt_vo_desc {           /* zero-initialise; 0 means the default in brackets */
    int samples;                       /* feeler rays a point, in each pass [4096] */
    int max_occluders;                 /* K: occluders kept a point, the strongest [5] */
    int max_bends;                     /* surfaces that a caustic path may meet before it counts as lost [8] */
    uint64_t seed;
    prt_real bias, scene_radius;       /* as in prt_bake_desc */
    prt_real least;                    /* occluders of a smaller form factor are dropped [0] */
    unsigned off;                      /* PRT_VO_NO_CAUSTIC | _NO_DD | _NO_DS | _NO_SS: what not to bake */
    int object_count;
    const prt_vo_object *objects;      /* [object_count], by prt_hit.object */
    const prt_tracer *tracer;          /* required. Pass 1 needs occluded; pass 2 closest, and for DS and SS occluded */
    prt_progress progress; void *progress_user;
} prt_vo_desc;

typedef struct prt_vo_row {            /* what prt_bake_vo kept of a point */
    int count, dropped;                /* occluders kept, and seen but dropped */
    prt_real dropped_factor;           /* sum of the form factors of the dropped ones */
} prt_vo_row;

/* Terms that no object of the scene can cause, as PRT_VO_NO_ flags for prt_vo_desc and prt_vo_params: NO_CAUSTIC where
   nothing is transmissive, NO_DD where no object has a diffuse colour, NO_DS and NO_SS where none has a specular one.
   prt_bake_vo leaves these out by itself. A NULL pointer or a count below 1: all four.
   NO_CAUSTIC saves the rays that are bent, and an exponential an occluder and light; NO_DS with NO_SS the any-hit
   rays of mirrors, and a third of the operations of shading; all three let an occluder be packed into 20 bytes
   instead of 40. */
PRTDEF unsigned prt_vo_unneeded(int object_count, const prt_vo_object *objects);

/* Bytes of occluders[point_count][max_occluders] (0: the default), or 0 if out of range or too large for a size_t. */
PRTDEF size_t prt_bake_vo_size(int max_occluders, int point_count);

/* Bytes that prt_bake_vo takes from PRT_MALLOC, in one piece; 0: desc is NULL, or a size does not fit. */
PRTDEF size_t prt_bake_vo_scratch_size(const prt_vo_desc *desc);

/* Pass 1, ambient occlusion: open[k] = the share of the cosine-weighted hemisphere over points[k] in which nothing is
   hit, 1 unoccluded, for k = first ... first+count-1; no other value is touched. It is prt_bake_transfer with one
   band, and so are ranges, bits, errors and progress; desc->objects is not read. */
PRTDEF prt_result prt_bake_vo_ao(const prt_vo_desc *desc, int point_count, const prt_point *points, int first,
                                 int count, prt_real *open);

/* Pass 2: occluders of points[first ... first+count-1] into the same rows of occluders[point_count][K] and
   rows[point_count]; no other row is touched; slots past rows[k].count are zero.
   open: pass 1 of all points, [point_count], or NULL where ambient occlusion shall count as 1.

   `samples` feeler rays w, cosine-distributed, so that each has F_ray = 1/samples (equation 7.1 with importance
   sampling). Of the rays that hit an occluder first, t away with the unit normal n turned towards the point,
     form_factor = sum F_ray             occlusion = sum w, made unit         position = mean of the hits
     diffuse_normal = sum F_ray AO n     AO interpolated between the corners of the primitive
     specular_normal = sum F_ray n       over hits whose mirror direction is open
     caustic = sum of the directions in which the ray reaches free space after refraction, made unit
     caustic_factor = sum F_ray          over rays that reach it
     transmissive = mean over these rays of the product of `transmissive` of every object that the ray entered;
                           where caustics are off, that of the object
     diffuse, specular = those of the object
   Refraction follows Snell's law with total internal reflection at objects whose `transmissive` is not black, which
   must be closed, with normals outward; nothing is lost by partial reflection. A ray ends at an opaque object.
   Rows are in order of falling form factor. The bits of a row depend on desc, open, its point and its index alone.

   Errors, before anything is written: PRT_ERR_NULL (desc); PRT_ERR_COUNT (samples, max_occluders, max_bends,
   object_count, primitive_count or group_count below 0; a range as in prt_bake_transfer; an entry of groups or
   triangles out of range); PRT_ERR_CAPACITY; PRT_ERR_NULL (rows, occluders or points with count > 0, objects with
   object_count > 0, tracer or a callback that is needed); PRT_ERR_VALUE (a material outside 0 ... 1 or not finite;
   refraction, least, bias, scene_radius negative or not finite; open outside 0 ... 1; points as in
   prt_bake_transfer); PRT_ERR_MEMORY. Then PRT_ERR_TRACE, when a callback fails or returns a hit that cannot be: an
   unknown object, a primitive out of range, t below 0, a normal that is not unit within 1e-3, numbers that are not
   finite; and PRT_ERR_CANCELLED. Points finished before stay valid. hits[k].object is -1 on entry. A batch holds rays
   of one point. Cost: samples rays, one any-hit ray for each hit on a specular object, and a few for each on a
   transmissive one; a sum of [occluders of the scene] a point. */
PRTDEF prt_result prt_bake_vo(const prt_vo_desc *desc, int point_count, const prt_point *points, const prt_real *open,
                              int first, int count, prt_vo_row *rows, prt_vo_occluder *occluders);

/* Rows of max_occluders (0: the default) slots each to the form that prt_vo_shade_n wants, in place: occluders one
   after the other, those of point k from first[k] to first[k+1] - 1. first[point_count + 1]; first[point_count] is
   their number.
   Errors: PRT_ERR_COUNT (point_count or max_occluders below 0; rows[k].count outside 0 ... K); PRT_ERR_CAPACITY (more
   than INT_MAX occluders); PRT_ERR_NULL. Cost: one pass. */
PRTDEF prt_result prt_vo_compact(int max_occluders, int point_count, const prt_vo_row *rows, prt_vo_occluder *occluders,
                                 int *first);

/* Splits an object into compact groups of faces, for prt_vo_object.groups, so that each is closer to the round cap
   for which its vectors stand; the thesis leaves this to the artist (7.4.1, 7.7.2). groups[mesh->triangle_count]
   receives 0 ... *made - 1, *made <= group_count: fewer where the mesh has fewer faces with area, or different places.
   k-means over the centroids of the faces, weighted by area (Lloyd), from seeds each of which is the centroid
   farthest from those before; `facing`, 0 ... 1, adds a distance between normals: |c - c'|^2 + facing r^2 |n - n'|^2,
   r half of the box's diagonal. 0 cuts by place alone; .1 also separates faces that look in opposite directions.
   Groups are numbered in the order of their first face; every group has a face. Faces without area go with the
   nearest group.
   Errors: PRT_ERR_COUNT (group_count < 1; those of prt_points_from_vertices); PRT_ERR_CAPACITY; PRT_ERR_NULL;
   PRT_ERR_VALUE (a position is not finite; facing outside 0 ... 1); PRT_ERR_MEMORY. mesh->normals is not read.
   Cost: up to 32 rounds of 10 operations a face and group; memory: 64 bytes a face and 88 a group, from PRT_MALLOC. */
PRTDEF prt_result prt_vo_split(const prt_mesh *mesh, int group_count, prt_real facing, int *groups, int *made);

/* ----------------------------------------------------------------------------------------------- >>measure ---- */

/* What a scene requires, measured before it is decided what to model: how much of light and transfer lies in which
   band, what leaving bands out or tracing fewer rays costs, how much there is to know about visibility. Sums are in
   double; nothing is allocated. examples/advise.c chooses a set-up by them. Errors of all: PRT_ERR_BANDS,
   PRT_ERR_COUNT, PRT_ERR_NULL (an array may be NULL where its count is 0), PRT_ERR_VALUE. A mean over no points
   is 0. */

/* Energy by band: energy[l] = (1/count) sum_k sum_m f_k(l,m)^2, l < bands, of f[count][bands^2]: transfer of points, or
   the planes of a light in colours (count 3). By Parseval's theorem sum_l energy[l] is the mean of int f^2 dw over what
   f has of these bands; what int f^2 exceeds it by lies in higher bands.
   Cost: a multiply-add a coefficient. Accuracy: n^2 count 1e-16, relative. */
PRTDEF prt_result prt_measure_energy(int bands, int count, const prt_real *f, double *energy);

/* What `kept` bands of the light under window w (width kept) lose of exit radiance, against all `bands` without window:
   *rms = root of the mean over points and colours of (sum_lm (1 - w(l)) T_lm L_lm)^2, w(l) = 0 for l >= kept; exact.
   transfer[point_count][bands^2], light three planes of bands^2. kept 0 ... bands (PRT_ERR_COUNT); 0 loses all: *rms is
   then the root mean square of exit radiance itself, the scale of the others. An unknown window: PRT_ERR_VALUE.
   Cost: 3 n^2 multiply-adds a point. Accuracy: that of prt_shade_diffuse in double. */
PRTDEF prt_result prt_measure_truncation(int bands, int kept, prt_window w, int point_count, const prt_real *transfer,
                                         const prt_real *light, double *rms);

/* The same for a light that turns: the mean is over all rotations R of the light, too, and band energies suffice, since
   entries of different rotation matrices are orthogonal and one of M^l has the mean square 1/(2l+1) [Wigner 1959]:
     E_R (T . R L)^2 = sum_l |T_l|^2 |L_l|^2/(2l+1),
     *rms^2 = sum_l (1 - w(l))^2 transfer_energy[l] light_energy[l]/(2l+1).
   Energies as prt_measure_energy gives them, [bands] each. Cost: bands. Error: 1e-15 bands, relative. */
PRTDEF prt_result prt_measure_truncation_turned(int bands, int kept, prt_window w, const double *transfer_energy,
                                                const double *light_energy, double *rms);

/* What the rays cost, under this light: of two bakes a, b of the same points with different seeds, the standard error
   of exit radiance by their mean (prt_bake_error), *error = root of the mean over points and colours of
   ((a-b).L/2)^2. One of the two alone errs by sqrt(2) of that. Its own relative error is about 1/sqrt(2 points).
   Sizes as above. To ask what fewer bands would give, hand over the light they leave (prt_sh_window). Cost: 3 n^2 multiply-adds a point. */
PRTDEF prt_result prt_measure_noise(int bands, int point_count, const prt_real *a, const prt_real *b,
                                    const prt_real *light, double *error);

/* Rays a point for the standard error `wanted`, where `rays` of them gave `error`, which falls as rays^-rate: 1/2 for
   independent rays, about 3/4 for prt_bake_transfer (docs/bake.md). rays (error/wanted)^(1/rate), rounded up, at least
   1 and at most INT_MAX. 0 unless rays >= 1, error >= 0, rate > 0, wanted > 0. */
PRTDEF int prt_measure_rays(int rays, double error, double rate, double wanted);

/* Shannon's entropy of a distribution, in bits: - sum p_k log2 p_k with p_k = share_k/sum of shares; shares at most 0
   or NaN count as 0; 0 where nothing is left. 2^H is the number of equal shares that say as little [Shannon 1948].
   {open, blocked} of a point: 0 where its rays all fare alike, 1 where a ray is as likely blocked as not. {open, form
   factors of its occluders} (prt_bake_vo): how many things the point sees in effect. Accuracy: count 1e-15. */
PRTDEF double prt_measure_entropy(int count, const prt_real *shares);

/* What there is to know about visibility. A ray of cosine distribution from a point is open with the chance p, the open
   share of its hemisphere, which band 0 of its transfer holds: p = T_0/Y(0,0). */
typedef struct prt_visibility {
    double open;                       /* mean of p: mean ambient occlusion, 1 where nothing hides anything */
    double entropy;                    /* mean of H(p, 1-p): bits a ray that are open when its point is known; what
                                          only a directional model (bands above the first) can tell. 0: p is 0 or 1
                                          everywhere */
    double information;                /* H(open, 1-open) - entropy >= 0: bits a ray that the point tells
                                          [Shannon 1948]; what ambient occlusion tells. 0: all points are alike */
} prt_visibility;

/* transfer[point_count][bands^2], of which band 0 is read. Cost: two logarithms a point. Accuracy: that of the bake;
   entropy of the noise of few rays is too low by about 1/(2 ln 2 rays) bits [Miller 1955]. */
PRTDEF prt_result prt_measure_visibility(int bands, int point_count, const prt_real *transfer, prt_visibility *out);

/* How many vector occluders points need: left[k] = mean over points of the form factor of what is beyond the k
   strongest occluders, k = 0 ... K, from what prt_bake_vo made with K = max_occluders (0: the default); left[0] is the
   mean blocked share, left[K] what the bake itself dropped. PRT_ERR_COUNT also for rows[k].count outside 0 ... K.
   Cost: an addition an occluder. */
PRTDEF prt_result prt_measure_occluders(int max_occluders, int point_count, const prt_vo_row *rows,
                                        const prt_vo_occluder *occluders, double *left);

#ifdef __cplusplus
}
#endif
#endif /* PRT_BAKE_H_INCLUDED */

/* ==================================================================================================================
   The interface ends here. Below stands the implementation, in the same order.
   ================================================================================================================== */

#if defined(PRT_BAKE_IMPLEMENTATION) && !defined(PRT_BAKE_IMPLEMENTATION_INCLUDED)
#define PRT_BAKE_IMPLEMENTATION_INCLUDED

#if defined(PRT_STATIC) && !defined(PRT_IMPLEMENTATION)
#  error "prt_bake.h: with PRT_STATIC define PRT_IMPLEMENTATION too, in each file that bakes"
#endif

#include "prt.h"                       /* again: its internals, where both headers were included before without any */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

PRT__STATIC void prt__steps_of_block(prt__steps *steps) {
    int k;
    for (k = 0; k < PRT__BLOCK; k++) {
        double angle = 2 * PRT__PI * prt__unit64((uint64_t)k * PRT__GOLDEN);
        steps->member[k] = (prt_real)k;
        steps->cosine[k] = (prt_real)cos(angle);
        steps->sine[k] = (prt_real)sin(angle);
    }
}

/* Members base ... base+count-1 of the lattice, cosine-mapped into the frame or, where lid > 0, evenly over the cap of
   height lid about its axis, to x, y, z; base is a multiple of 64, count at most 64. Whole vectors are written: finite
   numbers stand behind the last member, up to lane 64. */
PRT__INLINE void prt__lattice_block(const prt__lattice *s, const prt__steps *steps, const prt__frame *f, double lid,
                                    int base, int count, prt_real *x, prt_real *y, prt_real *z) {
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
        prt__vec depth = (low + along) * (prt_real)lid;
        prt__vec r = prt__vec_root(lid > 0 ? depth * (2 - depth) : low + along);
        prt__vec h = lid > 0 ? 1 - depth : prt__vec_root(high - along);
        prt__vec p = r * prt__vec_load(steps->cosine + k), q = r * prt__vec_load(steps->sine + k);
        prt__vec_store(x + k, p * t[0] + q * b[0] + h * n[0]);
        prt__vec_store(y + k, p * t[1] + q * b[1] + h * n[1]);
        prt__vec_store(z + k, p * t[2] + q * b[2] + h * n[2]);
    }
}

PRT__STATIC void prt__cosine_block(const prt__lattice *s, const prt__steps *steps, const prt__frame *f, int base,
                                   int count, prt_real *x, prt_real *y, prt_real *z) {
    prt__lattice_block(s, steps, f, 0, base, count, x, y, z);
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
PRT__INLINE prt_vec3 prt__narrow(const double v[3]) {
    return prt__vec3((prt_real)v[0], (prt_real)v[1], (prt_real)v[2]);
}

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
    point->normal = prt__narrow(unit);
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

enum { PRT__DEFAULT_BANDS = PRT_MAX_BANDS < 5 ? PRT_MAX_BANDS : 5, PRT__DEFAULT_SAMPLES = 1024 };

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
PRT__INLINE prt_vec3 prt__bake_origin(prt_real bias, const prt_point *p) {
    return prt__vec3(p->position.x + bias * p->normal.x, p->position.y + bias * p->normal.y,
                     p->position.z + bias * p->normal.z);
}

PRT__INLINE prt_real prt__bake_bias(prt_real bias, prt_real scene_radius) {   /* with the default in its place */
    return bias > 0 ? bias : PRT__R(1e-4) * (scene_radius > 0 ? scene_radius : 1);
}

/* Whether the points in the range can be baked, before and after the bias. */
PRT__STATIC prt_result prt__bake_points_check(prt_real bias, int point_count, const prt_point *points, int first,
                                              int count) {
    prt_result r = prt_points_check(point_count, points, first, count, 0);
    int k;
    for (k = first; r == PRT_OK && k < first + count; k++)
        if (!prt__finite3(prt__bake_origin(bias, &points[k]))) r = PRT_ERR_VALUE;
    return r;
}

PRT__STATIC void prt__bake_block_rays(prt__bake *b, const prt_point *point, int first, int count) {
    prt_ray ray;
    int k;
    ray.origin = prt__bake_origin(b->bias, point);
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
    int bands;
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
    b->bias = prt__bake_bias(desc->bias, desc->scene_radius);
    prt__bake_shape(b, bands);
    return prt__bake_points_check(b->bias, point_count, points, first, count);
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

/* ------------------------------------------------------------------------------------------------ >>bounce ---- */

/* Closest-hit rays go out in batches of one point. */
enum { PRT__POINT_BATCH = PRT_BAKE_BATCH / PRT__BLOCK * PRT__BLOCK };

typedef struct prt__feelers {
    prt_ray *rays;                     /* [PRT__POINT_BATCH] */
    prt_hit *hits;                     /* [PRT__POINT_BATCH] */
    prt_real *x, *y, *z;               /* [PRT__POINT_BATCH + PRT__BLOCK], directions */
    prt__steps steps;
} prt__feelers;

PRT__STATIC void prt__feelers_layout(prt__feelers *f, unsigned char *memory, size_t *used) {
    size_t batch = PRT__POINT_BATCH;
    f->rays = (prt_ray *)prt__carve(memory, used, batch, sizeof *f->rays);
    f->hits = (prt_hit *)prt__carve(memory, used, batch, sizeof *f->hits);
    f->x = (prt_real *)prt__carve(memory, used, batch + PRT__BLOCK, sizeof *f->x);
    f->y = (prt_real *)prt__carve(memory, used, batch + PRT__BLOCK, sizeof *f->y);
    f->z = (prt_real *)prt__carve(memory, used, batch + PRT__BLOCK, sizeof *f->z);
}

/* Rays along the directions in x, y, z, that have met nothing yet. */
PRT__STATIC void prt__start_rays(prt_vec3 origin, int count, const prt_real *x, const prt_real *y, const prt_real *z,
                                 prt_ray *rays, prt_hit *hits) {
    int k;
    for (k = 0; k < count; k++) {
        rays[k].origin = origin;
        rays[k].dir = prt__vec3(x[k], y[k], z[k]);
        rays[k].tmin = 0;
        rays[k].tmax = PRT__R(FLT_MAX);
        hits[k].object = -1;
    }
}
PRT__STATIC void prt__feelers_start(prt__feelers *f, prt_vec3 origin, int count) {
    prt__start_rays(origin, count, f->x, f->y, f->z, f->rays, f->hits);
}
PRT__STATIC int prt__feelers_trace(prt__feelers *f, const prt_tracer *tracer, prt_vec3 origin, int count) {
    prt__feelers_start(f, origin, count);
    return tracer->closest(tracer->user, count, f->rays, f->hits);
}

/* Members from ... from+count-1 of a point's directions: cosine-distributed, or evenly over a cap where lid > 0. */
PRT__STATIC void prt__feelers_aim(prt__feelers *f, const prt__lattice *lattice, const prt__frame *frame, double lid,
                                  int from, int count) {
    int k;
    for (k = 0; k < count; k += PRT__BLOCK)
        prt__lattice_block(lattice, &f->steps, frame, lid, from + k,
                           count - k < PRT__BLOCK ? count - k : (int)PRT__BLOCK, f->x + k, f->y + k, f->z + k);
}

PRT__STATIC int prt__not_negative(prt_real v) { return v >= 0 && prt__finite(v); }
PRT__STATIC int prt__grey(prt_rgb c) { return c.r == c.g && c.g == c.b; }
PRT__INLINE int prt__planes_ok(int planes) { return planes == 1 || planes == 3; }

/* Surfaces that reflect light, and the transfer of light to them. */
typedef struct prt__mirrors {
    int object_count, planes, previous_planes, coefficients;
    const prt_bounce_object *objects;
    const prt_real *previous;
} prt__mirrors;

/* What a hit sends back: three rows of transfer, their barycentric weights, and the albedo. */
typedef struct prt__reflection { const prt_real *row[3]; prt_real share[3], albedo[3]; } prt__reflection;

PRT__STATIC int prt__barycentric(prt_real u, prt_real v) {
    const prt_real slack = PRT__R(1e-3);
    return prt__finite(u) && prt__finite(v) && u >= -slack && v >= -slack && u + v <= 1 + slack;
}

/* 1 and the reflection, 0 where the hit reflects nothing, -1 where it cannot be. */
PRT__STATIC int prt__reflection_of(const prt__mirrors *m, prt_vec3 dir, const prt_hit *hit, prt__reflection *out) {
    const prt_bounce_object *o;
    const uint32_t *corner;
    prt_rgb albedo = { 0, 0, 0 };
    int back, k;
    if (hit->object >= m->object_count || !prt__not_negative(hit->t) || !prt__unit_within(hit->normal)) return -1;
    o = &m->objects[hit->object];
    if (!o->triangles) return 0;
    if (hit->primitive < 0 || hit->primitive >= o->triangle_count || !prt__barycentric(hit->u, hit->v)) return -1;
    back = prt__dot3(dir, hit->normal) > 0;
    if (back && !o->back_offset) return 0;
    corner = o->triangles + (size_t)hit->primitive * 3;
    out->share[0] = 1 - hit->u - hit->v; out->share[1] = hit->u; out->share[2] = hit->v;
    for (k = 0; k < 3; k++) {
        ptrdiff_t row = (ptrdiff_t)corner[k] + o->first_point + (back ? o->back_offset : 0);
        out->row[k] = m->previous + row * (ptrdiff_t)m->coefficients * m->previous_planes;
        if (!o->albedos) continue;
        albedo.r += out->share[k] * o->albedos[corner[k]].r;
        albedo.g += out->share[k] * o->albedos[corner[k]].g;
        albedo.b += out->share[k] * o->albedos[corner[k]].b;
    }
    if (!o->albedos) albedo.r = albedo.g = albedo.b = 1;
    out->albedo[0] = albedo.r * o->albedo.r;
    out->albedo[1] = albedo.g * o->albedo.g;
    out->albedo[2] = albedo.b * o->albedo.b;
    return 1;
}

/* sum += albedo * transfer of one plane, in blocks of a length that the compiler knows. */
PRT__STATIC void prt__add_reflection(int n, const prt__reflection *r, int plane, int from_plane,
                                     prt_real *PRT__RESTRICT sum) {
    const prt_real *a = r->row[0] + from_plane * n, *b = r->row[1] + from_plane * n, *c = r->row[2] + from_plane * n;
    prt_real wa = r->share[0] * r->albedo[plane], wb = r->share[1] * r->albedo[plane];
    prt_real wc = r->share[2] * r->albedo[plane];
    int i, k;
    for (i = 0; i + 8 <= n; i += 8)
        for (k = i; k < i + 8; k++) sum[k] += wa * a[k] + wb * b[k] + wc * c[k];
    for (; i < n; i++) sum[i] += wa * a[i] + wb * b[i] + wc * c[i];
}

/* The same for every plane: sum[planes][n]. */
PRT__STATIC void prt__add_reflections(const prt__mirrors *m, const prt__reflection *r, prt_real *sum) {
    int plane;
    for (plane = 0; plane < m->planes; plane++)
        prt__add_reflection(m->coefficients, r, plane, m->previous_planes == 3 ? plane : 0,
                            sum + (size_t)plane * (size_t)m->coefficients);
}

typedef struct prt__bounce {
    const prt_bounce_desc *desc;
    const prt_point *points;
    prt_real *out;
    int bands, samples;
    prt_real bias;
    prt__mirrors mirrors;
    prt__feelers feelers;
    prt_real *running;                 /* [planes][coefficients] */
    double *sum;                       /* the same */
} prt__bounce;

PRT__STATIC size_t prt__bounce_layout(prt__bounce *b, unsigned char *memory) {
    size_t used = PRT__LINE, n = (size_t)b->mirrors.coefficients * (size_t)b->mirrors.planes;
    if (memory) used -= (size_t)((uintptr_t)memory % PRT__LINE);
    prt__feelers_layout(&b->feelers, memory, &used);
    b->running = (prt_real *)prt__carve(memory, &used, n, sizeof *b->running);
    b->sum = (double *)prt__carve(memory, &used, n, sizeof *b->sum);
    return used;
}

/* Whether a colour of any albedo of the object is none, or a number is out of range: `ok` decides. */
PRT__STATIC int prt__albedos_all(const prt_bounce_object *o, int (*ok)(prt_rgb c)) {
    size_t k;
    if (!ok(o->albedo)) return 0;
    for (k = 0; o->triangles && o->albedos && k < 3 * (size_t)o->triangle_count; k++)
        if (!ok(o->albedos[o->triangles[k]])) return 0;
    return 1;
}

PRTDEF int prt_bounce_planes(int object_count, const prt_bounce_object *objects) {
    int k;
    for (k = 0; objects && k < object_count; k++)
        if (objects[k].triangles && !prt__albedos_all(&objects[k], prt__grey)) return 3;
    return 1;
}

PRTDEF size_t prt_bounce_size(int bands, int planes, int point_count) {
    size_t plane = prt_bake_transfer_size(bands, point_count);
    return !prt__planes_ok(planes) || plane > SIZE_MAX / 3 ? 0 : plane * (size_t)planes;
}

PRT__STATIC int prt__corners_ok(const prt_bounce_object *o, int point_count) {
    size_t k;
    for (k = 0; o->triangles && k < 3 * (size_t)o->triangle_count; k++) {
        int64_t row = (int64_t)o->triangles[k] + o->first_point, back = row + o->back_offset;
        if (row < 0 || row >= point_count || back < 0 || back >= point_count) return 0;
    }
    return 1;
}

/* Counts, then the defaults. */
PRT__STATIC prt_result prt__bounce_shape(prt__bounce *b, const prt_bounce_desc *desc) {
    int k;
    if (!desc) return PRT_ERR_NULL;
    memset(b, 0, sizeof *b);
    b->desc = desc;
    b->bands = desc->bands ? desc->bands : (int)PRT__DEFAULT_BANDS;
    if (!prt__bands_ok(b->bands)) return PRT_ERR_BANDS;
    b->mirrors.previous_planes = desc->previous_planes ? desc->previous_planes : 1;
    if (desc->samples < 0 || desc->object_count < 0) return PRT_ERR_COUNT;
    if (!prt__planes_ok(b->mirrors.previous_planes)) return PRT_ERR_COUNT;
    for (k = 0; desc->objects && k < desc->object_count; k++)
        if (desc->objects[k].triangle_count < 0) return PRT_ERR_COUNT;
    b->mirrors.planes = desc->planes ? desc->planes : prt_bounce_planes(desc->object_count, desc->objects);
    if (!desc->planes && b->mirrors.previous_planes == 3) b->mirrors.planes = 3;
    if (!prt__planes_ok(b->mirrors.planes) || b->mirrors.planes < b->mirrors.previous_planes) return PRT_ERR_COUNT;
    b->mirrors.object_count = desc->object_count;
    b->mirrors.objects = desc->objects;
    b->mirrors.coefficients = PRT_SH_COUNT(b->bands);
    b->samples = desc->samples ? desc->samples : (int)PRT__DEFAULT_SAMPLES;
    b->bias = prt__bake_bias(desc->bias, desc->scene_radius);
    return PRT_OK;
}

PRTDEF size_t prt_bake_bounce_scratch_size(const prt_bounce_desc *desc) {
    prt__bounce b;
    size_t size = prt__bounce_shape(&b, desc) == PRT_OK ? prt__bounce_layout(&b, 0) : 0;
    return size < SIZE_MAX ? size : 0;
}

PRT__STATIC prt_result prt__bounce_values(const prt__bounce *b, int point_count, int first, int count) {
    const prt_bounce_desc *desc = b->desc;
    int k;
    for (k = 0; k < b->mirrors.object_count; k++)
        if (!prt__albedos_all(&b->mirrors.objects[k], prt__rgb_within_1)) return PRT_ERR_VALUE;
    if (b->mirrors.planes == 1 && prt_bounce_planes(b->mirrors.object_count, b->mirrors.objects) == 3)
        return PRT_ERR_VALUE;
    if (!prt__not_negative(desc->bias) || !prt__not_negative(desc->scene_radius)) return PRT_ERR_VALUE;
    return prt__bake_points_check(b->bias, point_count, b->points, first, count);
}

PRT__STATIC prt_result prt__bounce_ranges(const prt__bounce *b, int point_count, int first, int count) {
    int k;
    if (!prt__range_ok(point_count, first, count)) return PRT_ERR_COUNT;
    for (k = 0; b->mirrors.objects && k < b->mirrors.object_count; k++)
        if (!prt__corners_ok(&b->mirrors.objects[k], point_count)) return PRT_ERR_COUNT;
    return PRT_OK;
}

/* Resolves the defaults of desc into b; the checks in the order that the interface promises. */
PRT__STATIC prt_result prt__bounce_open(prt__bounce *b, const prt_bounce_desc *desc, int point_count,
                                        const prt_point *points, const prt_real *previous, int first, int count,
                                        prt_real *out) {
    prt_result r = prt__bounce_shape(b, desc);
    if (r == PRT_OK) r = prt__bounce_ranges(b, point_count, first, count);
    if (r != PRT_OK) return r;
    if (count > 0 && !prt_bounce_size(b->bands, b->mirrors.planes, point_count)) return PRT_ERR_CAPACITY;
    if (count > 0 && (!points || !previous || !out)) return PRT_ERR_NULL;
    if (desc->object_count > 0 && !desc->objects) return PRT_ERR_NULL;
    if (!desc->tracer || !desc->tracer->closest) return PRT_ERR_NULL;
    b->points = points;
    b->mirrors.previous = previous;
    b->out = out;
    return prt__bounce_values(b, point_count, first, count);
}

PRT__STATIC void prt__bounce_flush(prt__bounce *b) {
    int i, n = b->mirrors.coefficients * b->mirrors.planes;
    for (i = 0; i < n; i++) {
        b->sum[i] += (double)b->running[i];
        b->running[i] = 0;
    }
}

/* Adds what the rays of a batch met; 0 unless one of the hits cannot be. */
PRT__STATIC int prt__bounce_batch(prt__bounce *b, int count) {
    prt__reflection reflection;
    int k;
    for (k = 0; k < count; k++) {
        int found = b->feelers.hits[k].object < 0 ? 0
                  : prt__reflection_of(&b->mirrors, b->feelers.rays[k].dir, &b->feelers.hits[k], &reflection);
        if (found < 0) return -1;
        if (found) prt__add_reflections(&b->mirrors, &reflection, b->running);
        if ((k + 1) % PRT__BLOCK == 0 || k + 1 == count) prt__bounce_flush(b);
    }
    return 0;
}

PRT__STATIC prt_result prt__bounce_point(prt__bounce *b, int point) {
    const prt_point *p = &b->points[point];
    prt__lattice lattice = prt__lattice_of(b->samples, b->desc->seed, (uint64_t)point);
    prt__frame frame = prt__frame_about(p->normal);
    size_t n = (size_t)b->mirrors.coefficients * (size_t)b->mirrors.planes, i;
    prt_real *row = b->out + (size_t)point * n;
    int from;
    memset(b->sum, 0, n * sizeof *b->sum);
    memset(b->running, 0, n * sizeof *b->running);
    for (from = 0; from < b->samples; from += PRT__POINT_BATCH) {
        int count = b->samples - from < PRT__POINT_BATCH ? b->samples - from : (int)PRT__POINT_BATCH;
        prt__feelers_aim(&b->feelers, &lattice, &frame, 0, from, count);
        if (prt__feelers_trace(&b->feelers, b->desc->tracer, prt__bake_origin(b->bias, p), count) ||
            prt__bounce_batch(b, count))
            return PRT_ERR_TRACE;
    }
    for (i = 0; i < n; i++) row[i] = (prt_real)(b->sum[i] / b->samples);
    return PRT_OK;
}

PRTDEF prt_result prt_bake_bounce(const prt_bounce_desc *desc, int point_count, const prt_point *points,
                                  const prt_real *previous, int first, int count, prt_real *out) {
    prt__bounce b;
    prt_result r = prt__bounce_open(&b, desc, point_count, points, previous, first, count, out);
    size_t size;
    void *memory;
    int k;
    if (r != PRT_OK || count == 0) return r;
    size = prt__bounce_layout(&b, 0);
    if (size == SIZE_MAX) return PRT_ERR_CAPACITY;
    memory = PRT_MALLOC(size);
    if (!memory) return PRT_ERR_MEMORY;
    prt__bounce_layout(&b, (unsigned char *)memory);
    prt__steps_of_block(&b.feelers.steps);
    for (k = first; r == PRT_OK && k < first + count; k++) {
        r = prt__bounce_point(&b, k);
        if (r == PRT_OK && desc->progress && desc->progress(desc->progress_user, k - first + 1, count))
            r = PRT_ERR_CANCELLED;
    }
    PRT_FREE(memory);
    return r;
}

PRTDEF prt_result prt_bounce_add(int bands, int point_count, int bounce_planes, const prt_real *bounce,
                                 int total_planes, prt_real *total, prt_real *strength) {
    size_t n, k;
    double most = 0;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (point_count < 0 || !prt__planes_ok(bounce_planes) || !prt__planes_ok(total_planes)) return PRT_ERR_COUNT;
    if (total_planes < bounce_planes) return PRT_ERR_COUNT;
    if (point_count > 0 && (!bounce || !total)) return PRT_ERR_NULL;
    n = (size_t)PRT_SH_COUNT(bands);
    for (k = 0; k < (size_t)point_count * (size_t)total_planes; k++) {
        const prt_real *from = bounce + (bounce_planes == total_planes ? k : k / 3) * n;
        double first = (double)from[0];
        size_t i;
        for (i = 0; i < n; i++) total[k * n + i] += from[i];
        if (!(first <= most)) most = first;
    }
    if (strength) *strength = (prt_real)(most * (2 * 1.77245385090551602729816748334114518));       /* over Y(0,0) */
    return PRT_OK;
}

/* Progress of one bounce told as that of all. */
typedef struct prt__bounces { const prt_bounce_desc *desc; int before, total; } prt__bounces;
PRT__STATIC int prt__bounces_done(void *user, int done, int total) {
    const prt__bounces *s = (const prt__bounces *)user;
    (void)total;
    return s->desc->progress ? s->desc->progress(s->desc->progress_user, s->before + done, s->total) : 0;
}

/* The bounces one after the other, buffer[0] and buffer[1] in turn. */
PRT__STATIC prt_result prt__bounces_run(const prt__bounce *b, int bounces, prt_real least, int point_count,
                                        const prt_real *direct, prt_real *const buffer[2], prt_real *total, int *made) {
    prt_bounce_desc desc = *b->desc;
    prt__bounces progress;
    prt_result r = PRT_OK;
    prt_real strength = 0;
    int k;
    progress.desc = b->desc;
    progress.total = bounces * point_count;
    desc.planes = b->mirrors.planes;
    desc.progress = prt__bounces_done;
    desc.progress_user = &progress;
    for (k = 0; k < bounces; k++) {
        prt_real *out = buffer[k % 2];
        progress.before = k * point_count;
        r = prt_bake_bounce(&desc, point_count, b->points, k ? buffer[1 - k % 2] : direct, 0, point_count, out);
        if (r != PRT_OK) break;
        desc.previous_planes = desc.planes;
        prt_bounce_add(b->bands, point_count, desc.planes, out, desc.planes, total, &strength);
        if (made) *made = k + 1;
        if (strength <= least) break;
    }
    return r;
}

PRTDEF prt_result prt_bake_bounces(const prt_bounce_desc *desc, int bounces, prt_real least, int point_count,
                                   const prt_point *points, const prt_real *direct, prt_real *total, int *made) {
    prt__bounce b;
    prt_real *buffer[2];
    size_t size, n, k;
    prt_result r = prt__bounce_open(&b, desc, point_count, points, direct, 0, point_count, total);
    if (r != PRT_OK) return r;
    if (bounces < 0) return PRT_ERR_COUNT;
    if (!prt__not_negative(least)) return PRT_ERR_VALUE;
    size = prt_bounce_size(b.bands, b.mirrors.planes, point_count);
    if ((point_count > 0 && bounces > INT_MAX / point_count) || size > SIZE_MAX / 2) return PRT_ERR_CAPACITY;
    buffer[0] = point_count > 0 ? (prt_real *)PRT_MALLOC(2 * size) : 0;
    if (!buffer[0] && point_count > 0) return PRT_ERR_MEMORY;
    if (made) *made = 0;
    if (point_count == 0) return PRT_OK;
    buffer[1] = buffer[0] + size / sizeof(prt_real);
    n = (size_t)b.mirrors.coefficients;
    for (k = 0; total != direct && k < (size_t)point_count * (size_t)b.mirrors.planes; k++)
        memcpy(total + k * n, direct + (b.mirrors.planes == b.mirrors.previous_planes ? k : k / 3) * n,
               n * sizeof *total);
    r = prt__bounces_run(&b, bounces, least, point_count, direct, buffer, total, made);
    PRT_FREE(buffer[0]);
    return r;
}

/* ------------------------------------------------------------------------------------------------ >>glossy ---- */

enum { PRT__GLOSSY_SAMPLES = 4096 };

PRTDEF size_t prt_glossy_size(int bands_in, int bands_out, int planes, int point_count) {
    size_t row = prt_bounce_size(bands_in, planes, point_count);
    size_t rows = (size_t)PRT_SH_COUNT(prt__bands_ok(bands_out) ? bands_out : 0);
    return rows == 0 || row > SIZE_MAX / rows ? 0 : row * rows;
}

/* A bounce whose light keeps its direction. */
typedef struct prt__glossy {
    prt__bounce of;                    /* desc, points, out, mirrors, feelers; sum holds a matrix */
    int bands, rows;                   /* of the harmonics that are evaluated: the more of in and out; bands_out^2 */
    int closest;                       /* hits reflect */
    unsigned char *blocked;            /* [PRT__POINT_BATCH] */
    prt_real *basis;                   /* [bands^2][PRT__BLOCK] */
    prt_real *answer;                  /* [planes][coefficients][PRT__BLOCK], what comes along each ray */
} prt__glossy;

PRT__STATIC size_t prt__glossy_layout(prt__glossy *g, unsigned char *memory) {
    size_t used = PRT__LINE, n = (size_t)g->of.mirrors.coefficients * (size_t)g->of.mirrors.planes;
    if (memory) used -= (size_t)((uintptr_t)memory % PRT__LINE);
    prt__feelers_layout(&g->of.feelers, memory, &used);
    g->blocked = (unsigned char *)prt__carve(memory, &used, PRT__POINT_BATCH, 1);
    g->basis = (prt_real *)prt__carve(memory, &used, (size_t)PRT_SH_COUNT(g->bands), PRT__BLOCK * sizeof *g->basis);
    g->answer = (prt_real *)prt__carve(memory, &used, n, PRT__BLOCK * sizeof *g->answer);
    g->of.running = (prt_real *)prt__carve(memory, &used, n, sizeof *g->of.running);
    g->of.sum = (double *)prt__carve(memory, &used, n * (size_t)g->rows, sizeof *g->of.sum);
    return used;
}

PRT__STATIC prt_result prt__glossy_open(prt__glossy *g, const prt_bounce_desc *desc, int bands_out, int point_count,
                                        const prt_point *points, const prt_real *transfer, int first, int count,
                                        prt_real *matrices) {
    prt_bounce_desc plain;
    prt_result r;
    memset(g, 0, sizeof *g);
    if (!desc) return PRT_ERR_NULL;
    plain = *desc;
    if (!transfer) {
        plain.objects = 0;
        plain.object_count = plain.planes = plain.previous_planes = 0;
    }
    r = prt__bounce_shape(&g->of, &plain);
    if (r != PRT_OK) return r;
    if (bands_out == 0) bands_out = g->of.bands;
    if (!prt__bands_ok(bands_out)) return PRT_ERR_BANDS;
    g->bands = bands_out > g->of.bands ? bands_out : g->of.bands;
    g->rows = PRT_SH_COUNT(bands_out);
    g->closest = transfer != 0;
    g->of.desc = desc;
    g->of.samples = desc->samples ? desc->samples : (int)PRT__GLOSSY_SAMPLES;
    r = prt__bounce_ranges(&g->of, point_count, first, count);
    if (r != PRT_OK) return r;
    if (count > 0 && !prt_glossy_size(g->of.bands, bands_out, g->of.mirrors.planes, point_count))
        return PRT_ERR_CAPACITY;
    if (count > 0 && (!points || !matrices)) return PRT_ERR_NULL;
    if (transfer && plain.object_count > 0 && !plain.objects) return PRT_ERR_NULL;
    if (desc->tracer ? !(transfer ? desc->tracer->closest != 0 : desc->tracer->occluded != 0) : transfer != 0)
        return PRT_ERR_NULL;
    g->of.points = points;
    g->of.mirrors.previous = transfer;
    g->of.out = matrices;
    return prt__bounce_values(&g->of, point_count, first, count);
}

/* Column k of answer[planes][coefficients][PRT__BLOCK]: the harmonics where the ray is open, else what is reflected. */
PRT__STATIC int prt__glossy_answer(prt__glossy *g, int ray, int k) {
    const prt__mirrors *m = &g->of.mirrors;
    const prt_hit *hit = &g->of.feelers.hits[ray];
    size_t n = (size_t)m->coefficients, all = n * (size_t)m->planes, i;
    prt__reflection reflection;
    int blocked = g->closest ? hit->object >= 0 : g->blocked[ray], found = 0;
    if (blocked && g->closest) {
        found = prt__reflection_of(m, g->of.feelers.rays[ray].dir, hit, &reflection);
        if (found < 0) return -1;
    }
    if (found) {
        memset(g->of.running, 0, all * sizeof *g->of.running);
        prt__add_reflections(m, &reflection, g->of.running);
    }
    for (i = 0; i < all; i++)
        g->answer[i * PRT__BLOCK + (size_t)k] =
            found ? g->of.running[i] : blocked ? 0 : g->basis[i % n * PRT__BLOCK + (size_t)k];
    return 0;
}

PRT__INLINE double prt__block_dot(const prt_real *f, const prt_real *g) {
    prt__oct sum;
    int k;
    memset(&sum, 0, sizeof sum);
    for (k = 0; k < PRT__BLOCK; k += 8) prt__oct_madd(&sum, f + k, g + k);
    return (double)prt__oct_sum(&sum);
}

/* sum += the block's harmonics times its answers; lanes past the last ray count as blocked. */
PRT__STATIC int prt__glossy_block(prt__glossy *g, int first, int count) {
    const prt__feelers *f = &g->of.feelers;
    int n = g->of.mirrors.coefficients, plane, i, j, k;
    double *sum = g->of.sum;
    prt_sh_eval_soa(g->bands, PRT__BLOCK, f->x + first, f->y + first, f->z + first, g->basis, PRT__BLOCK);
    for (k = 0; k < count; k++) if (prt__glossy_answer(g, first + k, k)) return -1;
    for (i = 0; i < n * g->of.mirrors.planes; i++)
        for (k = count; k < PRT__BLOCK; k++) g->answer[(size_t)i * PRT__BLOCK + (size_t)k] = 0;
    for (plane = 0; plane < g->of.mirrors.planes; plane++)
        for (i = 0; i < g->rows; i++)
            for (j = 0; j < n; j++)
                *sum++ += prt__block_dot(g->basis + (size_t)i * PRT__BLOCK,
                                         g->answer + (size_t)(plane * n + j) * PRT__BLOCK);
    return 0;
}

PRT__STATIC int prt__glossy_trace(prt__glossy *g, prt_vec3 origin, int count) {
    const prt_tracer *tracer = g->of.desc->tracer;
    prt__feelers_start(&g->of.feelers, origin, count);
    memset(g->blocked, 0, PRT__POINT_BATCH);
    if (!tracer) return 0;
    if (g->closest) return tracer->closest(tracer->user, count, g->of.feelers.rays, g->of.feelers.hits);
    return tracer->occluded(tracer->user, count, g->of.feelers.rays, g->blocked);
}

PRT__STATIC prt_result prt__glossy_point(prt__glossy *g, int point) {
    const prt_point *p = &g->of.points[point];
    prt__lattice lattice = prt__lattice_of(g->of.samples, g->of.desc->seed, (uint64_t)point);
    prt__frame frame = prt__frame_about(p->normal);
    size_t n = (size_t)g->of.mirrors.coefficients * (size_t)g->of.mirrors.planes * (size_t)g->rows, i;
    prt_real *matrix = g->of.out + (size_t)point * n;
    int from, k;
    memset(g->of.sum, 0, n * sizeof *g->of.sum);
    for (from = 0; from < g->of.samples; from += PRT__POINT_BATCH) {
        int count = g->of.samples - from < PRT__POINT_BATCH ? g->of.samples - from : (int)PRT__POINT_BATCH;
        prt__feelers_aim(&g->of.feelers, &lattice, &frame, 1, from, count);
        if (prt__glossy_trace(g, prt__bake_origin(g->of.bias, p), count)) return PRT_ERR_TRACE;
        for (k = 0; k < count; k += PRT__BLOCK)
            if (prt__glossy_block(g, k, count - k < PRT__BLOCK ? count - k : (int)PRT__BLOCK)) return PRT_ERR_TRACE;
    }
    for (i = 0; i < n; i++) matrix[i] = (prt_real)(g->of.sum[i] * (2 * PRT__PI / g->of.samples));
    return PRT_OK;
}

PRTDEF prt_result prt_bake_glossy(const prt_bounce_desc *desc, int bands_out, int point_count, const prt_point *points,
                                  const prt_real *transfer, int first, int count, prt_real *matrices) {
    prt__glossy g;
    prt_result r = prt__glossy_open(&g, desc, bands_out, point_count, points, transfer, first, count, matrices);
    size_t size;
    void *memory;
    int k;
    if (r != PRT_OK || count == 0) return r;
    size = prt__glossy_layout(&g, 0);
    if (size == SIZE_MAX) return PRT_ERR_CAPACITY;
    memory = PRT_MALLOC(size);
    if (!memory) return PRT_ERR_MEMORY;
    memset(memory, 0, size);
    prt__glossy_layout(&g, (unsigned char *)memory);
    prt__steps_of_block(&g.of.feelers.steps);
    for (k = first; r == PRT_OK && k < first + count; k++) {
        r = prt__glossy_point(&g, k);
        if (r == PRT_OK && desc->progress && desc->progress(desc->progress_user, k - first + 1, count))
            r = PRT_ERR_CANCELLED;
    }
    PRT_FREE(memory);
    return r;
}

/* A matrix of one plane times what follows it, column by column. */
PRT__STATIC prt_result prt__glossy_fold(int columns, int bands, const prt_real *rotation, const prt_real *zonal,
                                        prt_real *matrix) {
    prt_real column[PRT_SH_COUNT(PRT_MAX_BANDS)];
    prt_result r = PRT_OK;
    int k, i, l, rows = PRT_SH_COUNT(bands);
    for (k = 0; k < columns && r == PRT_OK; k++, matrix++) {
        for (i = 0; i < rows; i++) column[i] = matrix[(size_t)i * (size_t)columns];
        if (rotation) r = prt_sh_rotate(bands, rotation, column, column);
        for (l = 0; l < bands; l++) {
            prt_real factor = zonal ? (prt_real)sqrt(4 * PRT__PI / (2 * l + 1)) * zonal[l] : 1;
            for (i = l * l; i < PRT_SH_COUNT(l + 1); i++) matrix[(size_t)i * (size_t)columns] = factor * column[i];
        }
    }
    return r;
}

PRTDEF prt_result prt_glossy_fold(int bands_in, int bands_out, int planes, const prt_real *rotation,
                                  const prt_real *zonal, prt_real *matrix) {
    size_t columns, rows;
    int plane, l;
    prt_result r = PRT_OK;
    if (!prt__bands_ok(bands_in) || !prt__bands_ok(bands_out)) return PRT_ERR_BANDS;
    if (!prt__planes_ok(planes)) return PRT_ERR_COUNT;
    if (!matrix) return PRT_ERR_NULL;
    if (rotation && !prt__rotation_ok(rotation)) return PRT_ERR_ROTATION;
    for (l = 0; zonal && l < bands_out; l++) if (!prt__finite(zonal[l])) return PRT_ERR_VALUE;
    columns = (size_t)PRT_SH_COUNT(bands_in);
    rows = (size_t)PRT_SH_COUNT(bands_out);
    for (plane = 0; plane < planes && r == PRT_OK; plane++)
        r = prt__glossy_fold((int)columns, bands_out, rotation, zonal, matrix + (size_t)plane * rows * columns);
    return r;
}

/* answer_j = int f(w, v) w.z Y_j(w) dw over z > 0; 0 unless f is not finite somewhere. */
PRT__STATIC int prt__brdf_answer(int bands, int samples, int index, prt_brdf *f, void *user, prt_vec3 v,
                                 double *answer) {
    prt_real x[PRT__BLOCK], y[PRT__BLOCK], z[PRT__BLOCK], row[PRT_SH_COUNT(PRT_MAX_BANDS)];
    prt__steps steps;
    prt__lattice lattice = prt__lattice_of(samples, 0, (uint64_t)index + 1);
    prt__frame frame = prt__frame_about(prt__vec3(0, 0, 1));
    int n = PRT_SH_COUNT(bands), from, k, j;
    prt__steps_of_block(&steps);
    for (j = 0; j < n; j++) answer[j] = 0;
    for (from = 0; from < samples; from += PRT__BLOCK) {
        int count = samples - from < PRT__BLOCK ? samples - from : (int)PRT__BLOCK;
        prt__cosine_block(&lattice, &steps, &frame, from, count, x, y, z);
        for (k = 0; k < count; k++) {
            prt_vec3 w = prt__vec3(x[k], y[k], z[k]);
            prt_real value = f(user, w, v);
            if (!prt__finite(value)) return -1;
            prt_sh_eval(bands, w, row);
            for (j = 0; j < n; j++) answer[j] += PRT__PI / samples * (double)value * (double)row[j];
        }
    }
    return 0;
}

PRT__STATIC prt_result prt__brdf_sum(int bands_in, int bands_out, int samples, prt_brdf *f, void *user, double *answer,
                                     double *sum) {
    prt_real row[PRT_SH_COUNT(PRT_MAX_BANDS)], x[PRT__BLOCK], y[PRT__BLOCK], z[PRT__BLOCK];
    int in = PRT_SH_COUNT(bands_in), out = PRT_SH_COUNT(bands_out), k, i, j;
    prt__lattice lattice = prt__lattice_of(samples, 0, 0);
    prt__frame frame = prt__frame_about(prt__vec3(0, 0, 1));
    prt__steps steps;
    prt__steps_of_block(&steps);
    for (k = 0; k < samples; k++) {
        int lane = k % PRT__BLOCK;
        prt_vec3 v;
        if (lane == 0) prt__lattice_block(&lattice, &steps, &frame, 1, k, PRT__BLOCK, x, y, z);
        v = prt__vec3(x[lane], y[lane], z[lane]);
        if (prt__brdf_answer(bands_in, samples, k, f, user, v, answer)) return PRT_ERR_VALUE;
        prt_sh_eval(bands_out, v, row);
        for (i = 0; i < out; i++)
            for (j = 0; j < in; j++)
                sum[(size_t)i * (size_t)in + (size_t)j] += 2 * PRT__PI / samples * (double)row[i] * answer[j];
    }
    return PRT_OK;
}

PRTDEF prt_result prt_glossy_brdf(int bands_in, int bands_out, int samples, prt_brdf *f, void *user, prt_real *matrix) {
    size_t in, all, k;
    double *sum;
    prt_result r;
    if (!prt__bands_ok(bands_in) || !prt__bands_ok(bands_out)) return PRT_ERR_BANDS;
    if (samples < 0) return PRT_ERR_COUNT;
    if (!f || !matrix) return PRT_ERR_NULL;
    in = (size_t)PRT_SH_COUNT(bands_in);
    all = in * (size_t)PRT_SH_COUNT(bands_out);
    if (all > SIZE_MAX / sizeof *sum - in) return PRT_ERR_CAPACITY;
    sum = (double *)PRT_MALLOC((all + in) * sizeof *sum);
    if (!sum) return PRT_ERR_MEMORY;
    for (k = 0; k < all; k++) sum[k] = 0;
    r = prt__brdf_sum(bands_in, bands_out, samples ? samples : (int)PRT__DEFAULT_SAMPLES, f, user, sum + all, sum);
    for (k = 0; r == PRT_OK && k < all; k++) matrix[k] = (prt_real)sum[k];
    PRT_FREE(sum);
    return r;
}

/* ------------------------------------------------------------------------------------------------ >>pack ---- */

PRTDEF size_t prt_transfer_packed_size(int bands, prt_storage storage, int point_count) {
    size_t all = prt_bake_transfer_size(bands, point_count) / sizeof(prt_real);
    if (storage == PRT_STORAGE_8) return all;
    return (storage == PRT_STORAGE_HALF || storage == PRT_STORAGE_16) && all <= SIZE_MAX / 2 ? 2 * all : 0;
}

/* Least value and step of each coefficient, over the levels of its integers. */
PRT__STATIC void prt__pack_ranges(int n, int rows, const prt_real *transfer, prt_real levels, prt_real *low,
                                  prt_real *step) {
    int k, i;
    memcpy(low, transfer, (size_t)n * sizeof *low);
    memcpy(step, transfer, (size_t)n * sizeof *step);
    for (k = 1; k < rows; k++) {
        const prt_real *row = transfer + (size_t)k * (size_t)n;
        for (i = 0; i < n; i++) {
            if (row[i] < low[i]) low[i] = row[i];
            if (row[i] > step[i]) step[i] = row[i];
        }
    }
    for (i = 0; i < n; i++) step[i] = step[i] / levels - low[i] / levels;
}

PRT__STATIC int prt__pack_holds(size_t count, const prt_real *values, prt_real most) {
    size_t k;
    int ok = 1;
    for (k = 0; k < count; k++) ok &= values[k] <= most && values[k] >= -most;
    return ok;
}

PRT__STATIC unsigned prt__pack_integer(prt_real v, prt_real low, prt_real step, prt_real levels) {
    prt_real at = step > 0 ? (v - low) / step : 0;
    return (unsigned)(prt__clamp(at, 0, levels) + PRT__R(0.5));
}

PRT__STATIC void prt__pack_row(const prt_packed_transfer *p, int n, size_t row, const prt_real *transfer, void *data) {
    size_t at = row * (size_t)n;
    int i;
    for (i = 0; i < n; i++, at++) {
        if (p->storage == PRT_STORAGE_HALF) ((uint16_t *)data)[at] = (uint16_t)prt__half_of((double)transfer[at]);
        else if (p->storage == PRT_STORAGE_16)
            ((uint16_t *)data)[at] = (uint16_t)prt__pack_integer(transfer[at], p->low[i], p->step[i], 65535);
        else ((unsigned char *)data)[at] = (unsigned char)prt__pack_integer(transfer[at], p->low[i], p->step[i], 255);
    }
}

PRTDEF prt_result prt_transfer_pack(int bands, prt_storage storage, int point_count, const prt_real *transfer,
                                    void *data, prt_real *low, prt_real *step, prt_packed_transfer *packed) {
    size_t k, all;
    int n, half = storage == PRT_STORAGE_HALF;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (point_count < 0) return PRT_ERR_COUNT;
    if (point_count > 0 && !prt_bake_transfer_size(bands, point_count)) return PRT_ERR_CAPACITY;
    if (!packed || (!half && (!low || !step)) || (point_count > 0 && (!transfer || !data))) return PRT_ERR_NULL;
    if (!half && storage != PRT_STORAGE_16 && storage != PRT_STORAGE_8) return PRT_ERR_VALUE;
    n = PRT_SH_COUNT(bands);
    all = (size_t)n * (size_t)point_count;
    if (!prt__pack_holds(all, transfer, half ? 65504 : PRT__REAL_MAX / 4)) return PRT_ERR_VALUE;
    if (!half && point_count > 0)
        prt__pack_ranges(n, point_count, transfer, storage == PRT_STORAGE_16 ? 65535 : 255, low, step);
    packed->bands = bands;
    packed->storage = storage;
    packed->data = data;
    packed->low = low;
    packed->step = step;
    for (k = 0; k < (size_t)point_count; k++) prt__pack_row(packed, n, k, transfer, data);
    return PRT_OK;
}

/* --------------------------------------------------------------------------------------------------- >>fiv ---- */

/* A cell: a texel of an environment, or a part of one. Corners in order, edge k from corner k to the next; the edges of
   latitude-longitude cells with odd k are arcs of latitude, all others of great circles. */
typedef struct prt__cell { int latitude; double theta[4], phi[4], corner[4][3]; } prt__cell;

/* How an environment is cut into cells: `faces` grids of rows x columns, of which down x across make a texel. */
typedef struct prt__cells {
    const prt_fiv_env *env;
    int faces, rows, columns, down, across;
} prt__cells;

PRT__STATIC prt_result prt__cells_of(const prt_fiv_env *env, prt__cells *cells) {
    const int most = 1 << 14;                                  /* texels along a side, so that their number fits */
    int face;
    if (!env) return PRT_ERR_NULL;
    cells->env = env;
    if (env->cube_size != 0) {
        if (env->cube_size < 1 || env->cube_size > most) return PRT_ERR_COUNT;
        for (face = 0; face < 6; face++) if (!env->faces[face]) return PRT_ERR_NULL;
        cells->faces = 6;
        cells->down = cells->across = 1;
        cells->rows = cells->columns = env->cube_size;
        return PRT_OK;
    }
    if (env->width < 1 || env->height < 1 || env->width > most || env->height > most) return PRT_ERR_COUNT;
    if (!env->equirect) return PRT_ERR_NULL;
    cells->faces = 1;
    cells->down = env->height < 2 ? 2 : 1;                     /* a cell spans at most a right angle */
    cells->across = env->width < 4 ? (3 + env->width) / env->width : 1;
    cells->rows = env->height * cells->down;
    cells->columns = env->width * cells->across;
    return PRT_OK;
}

PRT__INLINE int prt__cells_count(const prt__cells *c) { return c->faces * c->rows * c->columns; }

PRT__INLINE const float *prt__cell_texel(const prt__cells *c, int face, int row, int column) {
    size_t width = (size_t)(c->columns / c->across);
    const float *texels = c->env->cube_size != 0 ? c->env->faces[face] : c->env->equirect;
    return texels + 3 * ((size_t)(row / c->down) * width + (size_t)(column / c->across));
}

/* The direction at place s, t, in -1 ... 1, of a cube map's face, as OpenGL has it. */
PRT__STATIC void prt__cube_direction(int face, double s, double t, double d[3]) {
    double sign = face & 1 ? -1 : 1, v[3];
    int axis = face / 2;
    v[0] = axis == 0 ? sign : axis == 1 ? s : sign * s;
    v[1] = axis == 1 ? sign : -t;
    v[2] = axis == 0 ? -sign * s : axis == 1 ? sign * t : sign;
    prt__normalise(v, d);
}

PRT__STATIC void prt__polar_direction(double theta, double phi, double d[3]) {
    d[0] = sin(theta) * cos(phi); d[1] = sin(theta) * sin(phi); d[2] = cos(theta);
}

/* The direction of a place in the grid, corners at whole numbers; its angles too where they say where it is. */
PRT__STATIC void prt__cells_direction(const prt__cells *c, int face, double row, double column, double *theta,
                                      double *phi, double d[3]) {
    *theta = *phi = 0;
    if (c->env->cube_size != 0) {
        prt__cube_direction(face, 2 * column / c->columns - 1, 2 * row / c->rows - 1, d);
        return;
    }
    *theta = PRT__PI * row / c->rows;
    *phi = 2 * PRT__PI * column / c->columns;
    prt__polar_direction(*theta, *phi, d);
}

PRT__STATIC void prt__cell_at(const prt__cells *c, int face, int row, int column, prt__cell *cell) {
    int k;
    cell->latitude = c->env->cube_size == 0;
    for (k = 0; k < 4; k++)
        prt__cells_direction(c, face, row + (k == 1 || k == 2), column + (k >= 2), &cell->theta[k], &cell->phi[k],
                             cell->corner[k]);
}

/* sum += half the integral of r x dr along an arc of a great circle: half its angle times its normal. */
PRT__STATIC void prt__add_great_arc(const double a[3], const double b[3], double sum[3]) {
    double n[3], sine;
    int k;
    for (k = 0; k < 3; k++) n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    sine = prt__length(n);
    if (!(sine > 0)) return;
    for (k = 0; k < 3; k++) sum[k] += atan2(sine, prt__ddot(a, b)) / 2 / sine * n[k];
}

/* The same along a circle of latitude. */
PRT__STATIC void prt__add_latitude_arc(double theta, double from, double to, double sum[3]) {
    double s = sin(theta), c = cos(theta);
    sum[0] -= c * s * (sin(to) - sin(from)) / 2;
    sum[1] += c * s * (cos(to) - cos(from)) / 2;
    sum[2] += s * s * (to - from) / 2;
}

/* int w dw over a cell = half the integral of r x dr around it (Stokes). The sign makes it point outwards. */
PRT__STATIC double prt__cell_vector(const prt__cell *cell, double vector[3]) {
    double towards = 0;
    int k;
    vector[0] = vector[1] = vector[2] = 0;
    for (k = 0; k < 4; k++) {
        if (cell->latitude && k % 2)
            prt__add_latitude_arc(cell->theta[k], cell->phi[k], cell->phi[(k + 1) % 4], vector);
        else prt__add_great_arc(cell->corner[k], cell->corner[(k + 1) % 4], vector);
    }
    for (k = 0; k < 4; k++) towards += prt__ddot(vector, cell->corner[k]);
    if (towards >= 0) return 1;
    for (k = 0; k < 3; k++) vector[k] = -vector[k];
    return -1;
}

/* A walk around a cell, over what lies above the horizon of n. Where the walk leaves that part and where it comes back,
   the horizon closes the loop; its share n.(r x dr)/2 is half the azimuth from there to here. */
typedef struct prt__clip { const double *n; double zero[3], side[3], sum[3], azimuth; } prt__clip;

PRT__STATIC void prt__clip_cross(prt__clip *c, const double p[3], int upwards) {
    double azimuth = atan2(prt__ddot(p, c->side), prt__ddot(p, c->zero));
    c->azimuth += upwards ? azimuth : -azimuth;
}

/* Heights fa and fb of the ends are given, so that edges that meet in a corner agree on which side it lies. */
PRT__STATIC void prt__clip_great_arc(prt__clip *c, const double a[3], double fa, const double b[3], double fb) {
    double p[3], at[3];
    int k;
    if ((fa > 0) == (fb > 0)) {
        if (fa > 0) prt__add_great_arc(a, b, c->sum);
        return;
    }
    for (k = 0; k < 3; k++) p[k] = (fb * a[k] - fa * b[k]) / (fb - fa);
    prt__normalise(p, at);
    prt__clip_cross(c, at, fb > 0);
    if (fa > 0) prt__add_great_arc(a, at, c->sum);
    else prt__add_great_arc(at, b, c->sum);
}

/* Where f(phi) = p cos phi + q sin phi + r changes sign between from and to, in walking order; at most two places. */
PRT__STATIC int prt__latitude_roots(double p, double q, double r, double from, double to, double root[2]) {
    double h = sqrt(p * p + q * q), middle = (from + to) / 2, half = fabs(to - from) / 2, peak, turn;
    int count = 0, k;
    if (!(fabs(r) < h)) return 0;
    peak = atan2(q, p);
    turn = acos(-r / h);
    for (k = 0; k < 2; k++) {
        double at = peak + (k ? turn : -turn);
        at -= 2 * PRT__PI * floor((at - middle) / (2 * PRT__PI) + 0.5);
        if (fabs(at - middle) < half) root[count++] = at;
    }
    if (count == 2 && (root[0] < root[1]) != (from < to)) { double t = root[0]; root[0] = root[1]; root[1] = t; }
    return count;
}

PRT__STATIC void prt__clip_latitude_arc(prt__clip *c, double theta, double from, double fa, double to, double fb) {
    double s = sin(theta), p = s * c->n[0], q = s * c->n[1], r = cos(theta) * c->n[2], at = from, d[3], root[2];
    int above = fa > 0, differ = above != (fb > 0), count = prt__latitude_roots(p, q, r, from, to, root), k;
    if (differ && count == 0) root[0] = fabs(fa) < fabs(fb) ? from : to;                    /* lost by rounding */
    if (differ && count == 2 && fabs(fa) < fabs(fb)) root[0] = root[1];
    if (!differ && count == 1) count = 0;
    for (k = 0; k < (differ ? 1 : count); k++) {
        if (above) prt__add_latitude_arc(theta, at, root[k], c->sum);
        above = !above;
        at = root[k];
        prt__polar_direction(theta, at, d);
        prt__clip_cross(c, d, above);
    }
    if (above) prt__add_latitude_arc(theta, at, to, c->sum);
}

/* int max(0, n.w) dw over a cell whose centre is given. */
PRT__STATIC double prt__cell_above(const prt__cell *cell, const double n[3], const double centre[3]) {
    double vector[3], sign = prt__cell_vector(cell, vector), along = prt__ddot(n, centre), flat[3], height[4];
    prt__clip c;
    int k;
    for (k = 0; k < 4; k++) height[k] = prt__ddot(n, cell->corner[k]);
    memset(&c, 0, sizeof c);
    c.n = n;
    for (k = 0; k < 3; k++) flat[k] = centre[k] - along * n[k];
    if (!prt__normalise(flat, c.zero)) return along > 0 ? prt__ddot(n, vector) : 0;
    for (k = 0; k < 3; k++) c.side[k] = n[(k + 1) % 3] * c.zero[(k + 2) % 3] - n[(k + 2) % 3] * c.zero[(k + 1) % 3];
    for (k = 0; k < 4; k++) {
        int next = (k + 1) % 4;
        if (cell->latitude && k % 2)
            prt__clip_latitude_arc(&c, cell->theta[k], cell->phi[k], height[k], cell->phi[next], height[next]);
        else prt__clip_great_arc(&c, cell->corner[k], height[k], cell->corner[next], height[next]);
    }
    return sign * (prt__ddot(n, c.sum) + c.azimuth / 2);
}

/* The cells of an environment as the baker uses them: tile after tile, each with a cone around its directions. */
enum { PRT__TILE = 8 };
typedef struct prt__tile { int first, count; double axis[3], cosine, sine; } prt__tile;
typedef struct prt__sky {
    prt__cells cells;
    int count, tiles;
    double reach;                      /* no cell extends further from its centre, radians */
    prt_vec3 *dir;                     /* [count] centres */
    prt_fiv *vectors;                  /* [count] L int w dw */
    int *place;                        /* [count] (face rows + row) columns + column */
    prt__tile *tile;                   /* [tiles] */
} prt__sky;

PRT__STATIC void prt__sky_shape(prt__sky *sky) {
    const prt__cells *c = &sky->cells;
    int down = (c->rows + PRT__TILE - 1) / PRT__TILE, across = (c->columns + PRT__TILE - 1) / PRT__TILE;
    double row = PRT__PI / c->rows, column = 2 * PRT__PI / c->columns;
    sky->count = prt__cells_count(c);
    sky->tiles = c->faces * down * across;
    sky->reach = c->faces == 6 ? atan(sqrt(2.0) / c->rows) : sqrt(row * row + column * column) / 2;
}

PRT__STATIC size_t prt__sky_layout(prt__sky *sky, unsigned char *memory, size_t used) {
    size_t n = (size_t)sky->count;
    sky->dir = (prt_vec3 *)prt__carve(memory, &used, n, sizeof *sky->dir);
    sky->vectors = (prt_fiv *)prt__carve(memory, &used, n, sizeof *sky->vectors);
    sky->place = (int *)prt__carve(memory, &used, n, sizeof *sky->place);
    sky->tile = (prt__tile *)prt__carve(memory, &used, (size_t)sky->tiles, sizeof *sky->tile);
    return used;
}

PRT__STATIC prt_vec3 prt__narrow_times(const double v[3], double factor) {
    double w[3];
    w[0] = v[0] * factor; w[1] = v[1] * factor; w[2] = v[2] * factor;
    return prt__narrow(w);
}

/* Appends one cell to the tile; 0 if its texel is not finite. */
PRT__STATIC int prt__sky_add(prt__sky *sky, prt__tile *tile, int face, int row, int column) {
    const prt__cells *c = &sky->cells;
    const float *texel = prt__cell_texel(c, face, row, column);
    double d[3], v[3], theta, phi;
    int at = tile->first + tile->count++, k, finite = 1;
    prt__cell cell;
    prt__cell_at(c, face, row, column, &cell);
    prt__cell_vector(&cell, v);
    prt__cells_direction(c, face, row + 0.5, column + 0.5, &theta, &phi, d);
    for (k = 0; k < 3; k++) {
        tile->axis[k] += d[k];
        finite &= prt__finite((prt_real)texel[k]);
    }
    sky->place[at] = (face * c->rows + row) * c->columns + column;
    sky->dir[at] = prt__narrow(d);
    sky->vectors[at].r = prt__narrow_times(v, (double)texel[0]);
    sky->vectors[at].g = prt__narrow_times(v, (double)texel[1]);
    sky->vectors[at].b = prt__narrow_times(v, (double)texel[2]);
    return finite;
}

PRT__STATIC double prt__cosine_of_sum(double cosine, double sine, double angle) {   /* cos(a + angle), -2 beyond pi */
    return cosine < -1 || cosine <= -cos(angle) ? -2 : cosine * cos(angle) - sine * sin(angle);
}

PRT__STATIC void prt__tile_cone(const prt__sky *sky, prt__tile *tile) {
    double axis[3], cosine = 1;
    int k;
    memcpy(axis, tile->axis, sizeof axis);
    if (!prt__normalise(axis, tile->axis)) { memset(tile->axis, 0, sizeof axis); cosine = -1; }
    for (k = tile->first; k < tile->first + tile->count; k++) {
        double d[3], along;
        d[0] = (double)sky->dir[k].x; d[1] = (double)sky->dir[k].y; d[2] = (double)sky->dir[k].z;
        along = prt__ddot(d, tile->axis);
        if (along < cosine) cosine = along;
    }
    cosine = prt__cosine_of_sum(cosine, prt__root_or_0((1 - cosine) * (1 + cosine)), sky->reach);
    tile->cosine = cosine < -1 ? -1 : cosine;
    tile->sine = prt__root_or_0((1 - tile->cosine) * (1 + tile->cosine));
}

/* Fills the lists; 0 if a texel is not finite. */
PRT__STATIC int prt__sky_fill(prt__sky *sky) {
    const prt__cells *c = &sky->cells;
    int face, top, left, row, column, tile = 0, filled = 0, finite = 1;
    for (face = 0; face < c->faces; face++)
        for (top = 0; top < c->rows; top += PRT__TILE)
            for (left = 0; left < c->columns; left += PRT__TILE) {
                prt__tile *t = &sky->tile[tile++];
                memset(t, 0, sizeof *t);
                t->first = filled;
                for (row = top; row < c->rows && row < top + PRT__TILE; row++)
                    for (column = left; column < c->columns && column < left + PRT__TILE; column++)
                        finite &= prt__sky_add(sky, t, face, row, column);
                filled += t->count;
                prt__tile_cone(sky, t);
            }
    return finite;
}

/* The lists of an environment, in one block of memory with `extra` bytes behind them, which begin at *used. */
PRT__STATIC prt_result prt__sky_open(prt__sky *sky, const prt_fiv_env *env, size_t extra, void **memory,
                                     size_t *used) {
    prt_result r = prt__cells_of(env, &sky->cells);
    size_t size;
    *memory = 0;
    if (r != PRT_OK) return r;
    prt__sky_shape(sky);
    size = prt__sky_layout(sky, 0, PRT__LINE);
    if (size > SIZE_MAX - extra) return PRT_ERR_CAPACITY;
    *memory = PRT_MALLOC(size + extra);
    if (!*memory) return PRT_ERR_MEMORY;
    *used = prt__sky_layout(sky, (unsigned char *)*memory, PRT__LINE - (size_t)((uintptr_t)*memory % PRT__LINE));
    if (prt__sky_fill(sky)) return PRT_OK;
    PRT_FREE(*memory);
    *memory = 0;
    return PRT_ERR_VALUE;
}

/* Nine sums, r g b of x y z each, as vectors. */
PRT__INLINE void prt__fiv_gather(double sum[9], const prt_fiv *v, double share) {
    prt_real part[9];
    int k;
    memcpy(part, v, sizeof part);
    for (k = 0; k < 9; k++) sum[k] += share * (double)part[k];
}
PRT__STATIC prt_fiv prt__fiv_from(const double sum[9]) {
    prt_fiv fiv;
    fiv.r = prt__narrow(sum); fiv.g = prt__narrow(sum + 3); fiv.b = prt__narrow(sum + 6);
    return fiv;
}

PRTDEF prt_result prt_bake_fiv_environment(const prt_fiv_env *env, prt_fiv *fiv) {
    prt__sky sky;
    void *memory;
    size_t used;
    double sum[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 };
    prt_result r;
    int k;
    if (env && !fiv) return prt__cells_of(env, &sky.cells) == PRT_ERR_COUNT ? PRT_ERR_COUNT : PRT_ERR_NULL;
    r = prt__sky_open(&sky, env, 0, &memory, &used);
    if (r != PRT_OK) return r;
    for (k = 0; k < sky.count; k++) prt__fiv_gather(sum, &sky.vectors[k], 1);
    *fiv = prt__fiv_from(sum);
    PRT_FREE(memory);
    return PRT_OK;
}

/* Irradiance of one normal: cells above the horizon by their vectors, those that it may cut by what is left of them. */
PRT__STATIC prt_rgb prt__sky_irradiance(const prt__sky *sky, const double n[3]) {
    const prt__cells *c = &sky->cells;
    double sum[9] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 }, cut[3] = { 0, 0, 0 }, band = sin(sky->reach) + 1e-6;
    prt_rgb out;
    int k, i;
    for (k = 0; k < sky->count; k++) {
        prt_vec3 d = sky->dir[k];
        double up = n[0] * (double)d.x + n[1] * (double)d.y + n[2] * (double)d.z, part, centre[3], theta, phi;
        int column = sky->place[k] % c->columns, row = sky->place[k] / c->columns % c->rows;
        int face = sky->place[k] / c->columns / c->rows;
        prt__cell cell;
        if (up > band) { prt__fiv_gather(sum, &sky->vectors[k], 1); continue; }
        if (up < -band) continue;
        prt__cell_at(c, face, row, column, &cell);
        prt__cells_direction(c, face, row + 0.5, column + 0.5, &theta, &phi, centre);
        part = prt__cell_above(&cell, n, centre);
        for (i = 0; i < 3; i++) cut[i] += part * (double)prt__cell_texel(c, face, row, column)[i];
    }
    out.r = (prt_real)(prt__ddot(n, sum) + cut[0]);
    out.g = (prt_real)(prt__ddot(n, sum + 3) + cut[1]);
    out.b = (prt_real)(prt__ddot(n, sum + 6) + cut[2]);
    return out;
}

PRT__STATIC prt_result prt__sky_told(const prt_fiv_env *env, int done, int count) {
    return env->progress && env->progress(env->progress_user, done, count) ? PRT_ERR_CANCELLED : PRT_OK;
}

PRTDEF prt_result prt_bake_fiv_irradiance(const prt_fiv_env *env, int count, const prt_vec3 *normals, prt_rgb *total) {
    prt__sky sky;
    void *memory;
    size_t used;
    prt_result r;
    int k;
    if (count < 0) return PRT_ERR_COUNT;
    r = prt__cells_of(env, &sky.cells);
    if (r != PRT_OK) return r;
    if (count > 0 && (!normals || !total)) return PRT_ERR_NULL;
    for (k = 0; k < count; k++) if (!prt__unit_within(normals[k])) return PRT_ERR_VALUE;
    if (count == 0) return PRT_OK;
    r = prt__sky_open(&sky, env, 0, &memory, &used);
    for (k = 0; r == PRT_OK && k < count; k++) {
        double v[3], n[3];
        v[0] = (double)normals[k].x; v[1] = (double)normals[k].y; v[2] = (double)normals[k].z;
        prt__normalise(v, n);
        total[k] = prt__sky_irradiance(&sky, n);
        r = prt__sky_told(env, k + 1, count);
    }
    if (memory) PRT_FREE(memory);
    return r;
}

PRTDEF prt_result prt_bake_fiv_total(const prt_fiv_env *env, int size, int first, int count, prt_rgb *total) {
    prt__sky sky;
    void *memory;
    size_t used;
    prt_result r;
    int k;
    if (size < 1 || size > INT_MAX / 6 / size || !prt__range_ok(6 * size * size, first, count)) return PRT_ERR_COUNT;
    r = prt__cells_of(env, &sky.cells);
    if (r != PRT_OK) return r;
    if (count > 0 && !total) return PRT_ERR_NULL;
    if (count == 0) return PRT_OK;
    r = prt__sky_open(&sky, env, 0, &memory, &used);
    for (k = first; r == PRT_OK && k < first + count; k++) {
        double n[3];
        prt__cube_direction(k / size / size, (2 * (k % size) + 1.0) / size - 1,
                            (2 * (k / size % size) + 1.0) / size - 1, n);
        total[k] = prt__sky_irradiance(&sky, n);
        r = prt__sky_told(env, k - first + 1, count);
    }
    if (memory) PRT_FREE(memory);
    return r;
}

PRTDEF prt_result prt_fiv_distances(int count, prt_real nearest, prt_real farthest, prt_real *rho) {
    double ratio;
    int k;
    if (count < 1) return PRT_ERR_COUNT;
    if (!rho) return PRT_ERR_NULL;
    if (!(nearest > 0 && farthest > nearest && prt__finite(farthest))) return PRT_ERR_VALUE;
    ratio = log((double)farthest / (double)nearest);
    for (k = 0; k < count; k++) rho[k] = (prt_real)((double)nearest * exp(count > 1 ? ratio * k / (count - 1) : 0));
    if (count > 1) rho[count - 1] = farthest;
    return PRT_OK;
}

PRTDEF int prt_bake_fiv_count(const prt_fiv_desc *desc) {
    if (!desc || desc->theta_count < 1 || desc->phi_count < 1 || desc->rho_count < 1) return 0;
    if (desc->theta_count > INT_MAX / desc->phi_count) return 0;
    if (desc->theta_count * desc->phi_count > INT_MAX / desc->rho_count) return 0;
    return desc->theta_count * desc->phi_count * desc->rho_count;
}

PRTDEF prt_fiv_table prt_fiv_table_of(const prt_fiv_desc *desc, const prt_fiv *samples, const unsigned char *inside) {
    prt_fiv_table table;
    memset(&table, 0, sizeof table);
    if (!desc) return table;
    table.theta_count = desc->theta_count;
    table.phi_count = desc->phi_count;
    table.rho_count = desc->rho_count;
    table.rho = desc->rho;
    table.radius = desc->radius;
    table.samples = samples;
    table.inside = inside;
    return table;
}

/* Direction of the object from the receiver at a sample, and its distance. Exact at the poles. */
PRT__STATIC double prt__fiv_place(const prt_fiv_desc *desc, int index, double dir[3]) {
    int j = index % desc->phi_count, i = index / desc->phi_count % desc->theta_count;
    int k = index / desc->phi_count / desc->theta_count;
    prt__polar_direction(desc->theta_count > 1 ? PRT__PI * i / (desc->theta_count - 1) : 0,
                         2 * PRT__PI * j / desc->phi_count, dir);
    if (i == 0 || i == desc->theta_count - 1) { dir[0] = dir[1] = 0; dir[2] = i == 0 ? 1 : -1; }
    return (double)desc->rho[k];
}

/* Where the receiver is, in the tracer's space. */
PRT__STATIC prt_vec3 prt__fiv_receiver(const prt_fiv_desc *desc, double distance, const double dir[3]) {
    double v[3];
    v[0] = (double)desc->centre.x - distance * dir[0];
    v[1] = (double)desc->centre.y - distance * dir[1];
    v[2] = (double)desc->centre.z - distance * dir[2];
    return prt__narrow(v);
}

/* The checks that all bakes of a grid share, and what one needs beside the grid. */
enum { PRT__FIV_SKY = 1, PRT__FIV_OCCLUDED = 2, PRT__FIV_CLOSEST = 4 };

PRT__STATIC prt_result prt__fiv_desc_check(const prt_fiv_desc *desc, int first, int count, const void *out, int needs) {
    int total = prt_bake_fiv_count(desc), k;
    prt__cells cells;
    prt_result r = PRT_OK;
    if (!desc) return PRT_ERR_NULL;
    if (total == 0 || !prt__range_ok(total, first, count) || desc->rays < 0) return PRT_ERR_COUNT;
    if (needs & PRT__FIV_SKY) r = prt__cells_of(desc->env, &cells);
    if (r != PRT_OK) return r;
    if (!desc->rho || !desc->tracer || (count > 0 && !out)) return PRT_ERR_NULL;
    if ((needs & PRT__FIV_OCCLUDED) && !desc->tracer->occluded) return PRT_ERR_NULL;
    if ((needs & PRT__FIV_CLOSEST) && !desc->tracer->closest) return PRT_ERR_NULL;
    if (!(desc->radius > 0 && prt__finite(desc->radius)) || !prt__finite3(desc->centre)) return PRT_ERR_VALUE;
    for (k = 0; k < desc->rho_count; k++)
        if (!(desc->rho[k] > (k ? desc->rho[k - 1] : 0) && prt__finite(desc->rho[k]))) return PRT_ERR_VALUE;
    return PRT_OK;
}

/* A table being baked. Rays form one stream, sample after sample; the buffers hold up to PRT_BAKE_BATCH of it. */
typedef struct prt__fiv_bake {
    const prt_fiv_desc *desc;
    prt_fiv *samples;
    prt__sky sky;
    int first, end, finished, queued;
    double sum[9];                     /* of the sample `finished` */
    prt_ray *rays;                     /* [PRT_BAKE_BATCH] */
    int *cell, *owner;                 /* [PRT_BAKE_BATCH] through which cell a ray goes, and its sample */
    double *share;                     /* [PRT_BAKE_BATCH] how much of the cell it stands for */
    unsigned char *blocked;            /* [PRT_BAKE_BATCH] */
} prt__fiv_bake;

PRT__STATIC size_t prt__fiv_bake_layout(prt__fiv_bake *b, unsigned char *memory, size_t used) {
    b->rays = (prt_ray *)prt__carve(memory, &used, PRT_BAKE_BATCH, sizeof *b->rays);
    b->cell = (int *)prt__carve(memory, &used, PRT_BAKE_BATCH, sizeof *b->cell);
    b->owner = (int *)prt__carve(memory, &used, PRT_BAKE_BATCH, sizeof *b->owner);
    b->share = (double *)prt__carve(memory, &used, PRT_BAKE_BATCH, sizeof *b->share);
    b->blocked = (unsigned char *)prt__carve(memory, &used, PRT_BAKE_BATCH, 1);
    return used;
}

/* Finishes samples up to `next`, which is the next to receive light. */
PRT__STATIC prt_result prt__fiv_finish(prt__fiv_bake *b, int next) {
    const prt_fiv_desc *desc = b->desc;
    while (b->finished < next) {
        b->samples[b->finished++] = prt__fiv_from(b->sum);
        memset(b->sum, 0, sizeof b->sum);
        if (desc->progress && desc->progress(desc->progress_user, b->finished - b->first, b->end - b->first))
            return PRT_ERR_CANCELLED;
    }
    return PRT_OK;
}

PRT__STATIC prt_result prt__fiv_drain(prt__fiv_bake *b) {
    const prt_tracer *tracer = b->desc->tracer;
    prt_result r = PRT_OK;
    int k;
    if (b->queued == 0) return PRT_OK;
    memset(b->blocked, 0, (size_t)b->queued);
    if (tracer->occluded(tracer->user, b->queued, b->rays, b->blocked)) return PRT_ERR_TRACE;
    for (k = 0; r == PRT_OK && k < b->queued; k++) {
        if (b->owner[k] != b->finished) r = prt__fiv_finish(b, b->owner[k]);
        if (b->blocked[k]) prt__fiv_gather(b->sum, &b->sky.vectors[b->cell[k]], b->share[k]);
    }
    b->queued = 0;
    return r;
}

/* A sample being traced: the cone around the bounding sphere, cosine -2 where it is everything, and texels in
   split^2. */
typedef struct prt__fiv_look {
    double axis[3], cosine, sine, share, near;  /* near: cosine of the cone with the reach of a cell around it */
    prt_vec3 toward;
    prt_real limit;
    prt_ray ray;
    int index, split;
} prt__fiv_look;

enum { PRT__FIV_RAYS = 256 };

PRT__STATIC void prt__fiv_look_at(const prt__fiv_bake *b, int index, prt__fiv_look *look) {
    const prt_fiv_desc *desc = b->desc;
    double distance = prt__fiv_place(desc, index, look->axis), radius = (double)desc->radius;
    double cells = b->sky.count, split;
    int inside = !(distance > radius);
    look->cosine = inside ? -2 : sqrt((distance - radius) * (distance + radius)) / distance;
    look->sine = inside ? 0 : radius / distance;
    if (!inside) cells *= look->sine * look->sine / (1 + look->cosine) / 2;
    split = ceil(sqrt((desc->rays ? desc->rays : (int)PRT__FIV_RAYS) / cells));
    look->split = desc->rays == 1 || split < 1 ? 1 : split < 16 ? (int)split : 16;
    look->share = 1.0 / look->split / look->split;
    look->near = look->split == 1 ? look->cosine : prt__cosine_of_sum(look->cosine, look->sine, b->sky.reach);
    look->toward = prt__narrow(look->axis);
    look->limit = (prt_real)look->cosine - 8 * PRT__EPS;
    look->ray.origin = prt__fiv_receiver(desc, distance, look->axis);
    look->ray.tmin = 0;
    look->ray.tmax = PRT__R(FLT_MAX);
    look->index = index;
}

PRT__STATIC prt_result prt__fiv_trace(prt__fiv_bake *b, prt__fiv_look *look, int cell, prt_vec3 dir) {
    if (prt__dot3(dir, look->toward) < look->limit) return PRT_OK;
    look->ray.dir = dir;
    b->rays[b->queued] = look->ray;
    b->cell[b->queued] = cell;
    b->share[b->queued] = look->share;
    b->owner[b->queued++] = look->index;
    return b->queued == PRT_BAKE_BATCH ? prt__fiv_drain(b) : PRT_OK;
}

PRT__STATIC prt_result prt__fiv_trace_parts(prt__fiv_bake *b, prt__fiv_look *look, int cell) {
    const prt__cells *c = &b->sky.cells;
    int place = b->sky.place[cell], column = place % c->columns, row = place / c->columns % c->rows, p, q;
    int face = place / c->columns / c->rows;
    double d[3], theta, phi, step = 1.0 / look->split;
    prt_result r = PRT_OK;
    for (p = 0; p < look->split; p++)
        for (q = 0; r == PRT_OK && q < look->split; q++) {
            prt__cells_direction(c, face, row + (p + 0.5) * step, column + (q + 0.5) * step, &theta, &phi, d);
            r = prt__fiv_trace(b, look, cell, prt__narrow(d));
        }
    return r;
}

PRT__INLINE int prt__fiv_meets(const prt__fiv_look *look, const prt__tile *t) {
    double both = look->cosine * t->cosine - look->sine * t->sine;
    return look->cosine < -1 || t->cosine <= -look->cosine || prt__ddot(look->axis, t->axis) >= both - 1e-6;
}

/* A cell without light changes nothing, whoever hides it. */
PRT__INLINE int prt__fiv_dark(const prt_fiv *v) {
    return v->r.x == 0 && v->r.y == 0 && v->r.z == 0 && v->g.x == 0 && v->g.y == 0 && v->g.z == 0 &&
           v->b.x == 0 && v->b.y == 0 && v->b.z == 0;
}

PRT__STATIC prt_result prt__fiv_sample(prt__fiv_bake *b, int index) {
    prt__fiv_look look;
    prt_result r = PRT_OK;
    int t, k;
    prt__fiv_look_at(b, index, &look);
    for (t = 0; t < b->sky.tiles; t++) {
        const prt__tile *tile = &b->sky.tile[t];
        if (!prt__fiv_meets(&look, tile)) continue;
        for (k = tile->first; r == PRT_OK && k < tile->first + tile->count; k++) {
            if (prt__fiv_dark(&b->sky.vectors[k])) continue;
            if (look.split == 1) r = prt__fiv_trace(b, &look, k, b->sky.dir[k]);
            else if ((double)prt__dot3(b->sky.dir[k], look.toward) >= look.near - 1e-6)
                r = prt__fiv_trace_parts(b, &look, k);
        }
    }
    return r;
}

PRTDEF prt_result prt_bake_fiv_table(const prt_fiv_desc *desc, int first, int count, prt_fiv *samples) {
    prt__fiv_bake b;
    prt_result r = prt__fiv_desc_check(desc, first, count, samples, PRT__FIV_SKY | PRT__FIV_OCCLUDED);
    size_t extra, used;
    void *memory;
    int k;
    if (r != PRT_OK || count == 0) return r;
    memset(&b, 0, sizeof b);
    b.desc = desc;
    b.samples = samples;
    b.first = b.finished = first;
    b.end = first + count;
    extra = prt__fiv_bake_layout(&b, 0, PRT__LINE);
    r = prt__sky_open(&b.sky, desc->env, extra, &memory, &used);
    if (r != PRT_OK) return r;
    prt__fiv_bake_layout(&b, (unsigned char *)memory, used);
    for (k = first; r == PRT_OK && k < b.end; k++) r = prt__fiv_sample(&b, k);
    if (r == PRT_OK) r = prt__fiv_drain(&b);
    if (r == PRT_OK) r = prt__fiv_finish(&b, b.end);
    PRT_FREE(memory);
    return r;
}

PRTDEF size_t prt_bake_fiv_transfer_size(const prt_fiv_desc *desc, int bands) {
    if (!prt__bands_ok(bands) || bands == PRT_MAX_BANDS) return 0;
    return prt_bake_transfer_size(bands + 1, prt_bake_fiv_count(desc));
}

PRTDEF prt_fiv_transfer prt_fiv_transfer_of(const prt_fiv_desc *desc, int bands, const prt_real *samples,
                                            const unsigned char *inside) {
    prt_fiv_table grid = prt_fiv_table_of(desc, 0, inside);
    prt_fiv_transfer t;
    t.bands = bands;
    t.theta_count = grid.theta_count; t.phi_count = grid.phi_count; t.rho_count = grid.rho_count;
    t.rho = grid.rho;
    t.radius = grid.radius;
    t.samples = samples;
    t.inside = inside;
    return t;
}

/* Queues rays from block `at` on of a sample's directions, as many as fit; returns their number. */
PRT__STATIC int prt__fiv_cap_rays(prt__bake *b, const prt__lattice *lattice, const prt__frame *frame, double lid,
                                  prt_vec3 origin, int at) {
    prt_ray ray;
    int queued = 0, count, k;
    ray.origin = origin;
    ray.tmin = 0;
    ray.tmax = PRT__R(FLT_MAX);
    for (; at < b->samples; at += count) {
        count = b->samples - at < PRT__BLOCK ? b->samples - at : PRT__BLOCK;
        if (queued + count > PRT_BAKE_BATCH) break;
        prt__lattice_block(lattice, &b->steps, frame, lid, at, count, b->x + queued, b->y + queued, b->z + queued);
        for (k = queued; k < queued + count; k++) {
            ray.dir = prt__vec3(b->x[k], b->y[k], b->z[k]);
            b->rays[k] = ray;
        }
        queued += count;
    }
    return queued;
}

/* Adds the basis in the directions of the queued rays that are blocked to the sums. */
PRT__STATIC void prt__fiv_add_blocked(prt__bake *b, int queued) {
    int k;
    for (k = 0; k < queued; k++) b->blocked[k] = (unsigned char)(b->blocked[k] == 0);          /* open ones are added */
    for (k = 0; k < queued; k += PRT__BLOCK) {
        prt__bake_add_block(b, k, queued - k < PRT__BLOCK ? queued - k : PRT__BLOCK);
        if ((k + PRT__BLOCK) % PRT__FLUSH == 0) prt__bake_flush(b);
    }
    prt__bake_flush(b);
}

/* One sample: V_j = cap/rays times the sum of Y_j over the rays that are blocked. */
PRT__STATIC prt_result prt__fiv_transfer_sample(prt__bake *b, const prt_fiv_desc *desc, int index, prt_real *row) {
    const prt_tracer *tracer = desc->tracer;
    double dir[3], distance = prt__fiv_place(desc, index, dir), radius = (double)desc->radius, lid = 2;
    prt__lattice lattice = prt__lattice_of(b->samples, 0, (uint64_t)index);
    prt__frame frame = prt__frame_about(prt__narrow(dir));
    prt_vec3 origin = prt__fiv_receiver(desc, distance, dir);
    int at = 0, queued, k;
    if (distance > radius) {                                   /* 1 - cos = sin^2/(1 + cos) */
        double cosine = sqrt((distance - radius) * (distance + radius)) / distance;
        lid = radius / distance * (radius / distance) / (1 + cosine);
    }
    for (k = 0; k < b->coefficients; k++) b->sum[k] = 0;
    for (; at < b->samples; at += queued) {
        queued = prt__fiv_cap_rays(b, &lattice, &frame, lid, origin, at);
        memset(b->blocked, 0, (size_t)queued);
        if (tracer->occluded(tracer->user, queued, b->rays, b->blocked)) return PRT_ERR_TRACE;
        prt__fiv_add_blocked(b, queued);
    }
    for (k = 0; k < b->coefficients; k++) row[k] = (prt_real)(b->sum[k] * (2 * PRT__PI * lid / b->samples));
    return PRT_OK;
}

PRTDEF prt_result prt_bake_fiv_transfer(const prt_fiv_desc *desc, int bands, int first, int count, prt_real *samples) {
    prt__bake b;
    prt_result r;
    size_t size;
    void *memory;
    int k;
    if (!desc) return PRT_ERR_NULL;
    if (!prt__bands_ok(bands) || bands == PRT_MAX_BANDS) return PRT_ERR_BANDS;
    r = prt__fiv_desc_check(desc, first, count, samples, PRT__FIV_OCCLUDED);
    if (r != PRT_OK || count == 0) return r;
    size = prt_bake_scratch_size(bands + 1);
    if (!size || !prt_bake_fiv_transfer_size(desc, bands)) return PRT_ERR_CAPACITY;
    memory = PRT_MALLOC(size);
    if (!memory) return PRT_ERR_MEMORY;
    memset(memory, 0, size);
    memset(&b, 0, sizeof b);
    b.samples = desc->rays ? desc->rays : (int)PRT__DEFAULT_SAMPLES;
    prt__bake_shape(&b, bands + 1);
    prt__bake_layout(&b, (unsigned char *)memory);
    prt__steps_of_block(&b.steps);
    for (k = first; r == PRT_OK && k < first + count; k++) {
        r = prt__fiv_transfer_sample(&b, desc, k, samples + (size_t)k * (size_t)b.coefficients);
        if (r == PRT_OK && desc->progress && desc->progress(desc->progress_user, k - first + 1, count))
            r = PRT_ERR_CANCELLED;
    }
    PRT_FREE(memory);
    return r;
}

/* Rays by which a sample decides whether it lies inside. */
enum { PRT__FIV_FEELERS = 64, PRT__FIV_FEELING = 16 };

/* The next samples that may lie inside, at most PRT__FIV_FEELING, are asked; returns the first that was not
   looked at. */
PRT__STATIC int prt__fiv_feel(const prt_fiv_desc *desc, const prt_vec3 *dirs, int at, int end, prt_ray *rays,
                              int *asked, int *count) {
    int k;
    *count = 0;
    for (; at < end && *count < PRT__FIV_FEELING; at++) {
        double dir[3], distance = prt__fiv_place(desc, at, dir);
        prt_ray ray;
        if (distance > (double)desc->radius) continue;
        ray.origin = prt__fiv_receiver(desc, distance, dir);
        ray.tmin = 0;
        ray.tmax = PRT__R(FLT_MAX);
        for (k = 0; k < PRT__FIV_FEELERS; k++) {
            ray.dir = dirs[k];
            rays[*count * PRT__FIV_FEELERS + k] = ray;
        }
        asked[(*count)++] = at;
    }
    return at;
}

PRT__STATIC unsigned char prt__fiv_enclosed(const prt_ray *rays, const prt_hit *hits) {
    int back = 0, k;
    for (k = 0; k < PRT__FIV_FEELERS; k++) back += hits[k].object >= 0 && prt__dot3(rays[k].dir, hits[k].normal) > 0;
    return 2 * back > PRT__FIV_FEELERS;
}

PRT__STATIC prt_result prt__fiv_inside_range(const prt_fiv_desc *desc, int first, int end, prt_ray *rays, prt_hit *hits,
                                             unsigned char *inside) {
    const prt_tracer *tracer = desc->tracer;
    prt_vec3 dirs[PRT__FIV_FEELERS];
    int asked[PRT__FIV_FEELING], at = first, done = first, count, k;
    for (k = 0; k < PRT__FIV_FEELERS; k++) {
        prt_real u, v;
        prt__square_member(PRT_SAMPLE_FIBONACCI, PRT__FIV_FEELERS, 0, 0, k, &u, &v);
        dirs[k] = prt_sample_sphere(u, v);
    }
    while (done < end) {
        at = prt__fiv_feel(desc, dirs, at, end, rays, asked, &count);
        for (k = 0; k < count * PRT__FIV_FEELERS; k++) hits[k].object = -1;
        if (count > 0 && tracer->closest(tracer->user, count * PRT__FIV_FEELERS, rays, hits)) return PRT_ERR_TRACE;
        for (k = 0; done < at; done++) {
            int felt = k < count && asked[k] == done;
            inside[done] = felt ? prt__fiv_enclosed(rays + k * PRT__FIV_FEELERS, hits + k * PRT__FIV_FEELERS) : 0;
            k += felt;
            if (desc->progress && desc->progress(desc->progress_user, done - first + 1, end - first))
                return PRT_ERR_CANCELLED;
        }
    }
    return PRT_OK;
}

PRTDEF prt_result prt_bake_fiv_inside(const prt_fiv_desc *desc, int first, int count, unsigned char *inside) {
    prt_result r = prt__fiv_desc_check(desc, first, count, inside, PRT__FIV_CLOSEST);
    size_t used = 0, size, n = PRT__FIV_FEELERS * PRT__FIV_FEELING;
    unsigned char *memory;
    if (r != PRT_OK || count == 0) return r;
    prt__carve(0, &used, n, sizeof(prt_ray));
    size = used + n * sizeof(prt_hit);
    memory = (unsigned char *)PRT_MALLOC(size);
    if (!memory) return PRT_ERR_MEMORY;
    memset(memory, 0, size);
    r = prt__fiv_inside_range(desc, first, first + count, (prt_ray *)(void *)memory, (prt_hit *)(void *)(memory + used),
                              inside);
    PRT_FREE(memory);
    return r;
}

/* ---------------------------------------------------------------------------------------------------- >>vo ---- */

enum { PRT__VO_SAMPLES = 4096, PRT__VO_OCCLUDERS = 5, PRT__VO_BENDS = 8 };
enum { PRT__VO_MIRRORS = PRT_VO_NO_DS | PRT_VO_NO_SS };         /* neither of them: no mirror rays */
enum { PRT__VO_BATCH = PRT__POINT_BATCH };

PRT__STATIC int prt__rgb_any(prt_rgb c) { return c.r > 0 || c.g > 0 || c.b > 0; }

PRTDEF unsigned prt_vo_unneeded(int object_count, const prt_vo_object *objects) {
    unsigned off = PRT_VO_NO_CAUSTIC | PRT_VO_NO_DD | PRT_VO_NO_DS | PRT_VO_NO_SS;
    int k;
    for (k = 0; objects && k < object_count; k++) {
        if (prt__rgb_any(objects[k].transmissive)) off &= ~(unsigned)PRT_VO_NO_CAUSTIC;
        if (prt__rgb_any(objects[k].diffuse)) off &= ~(unsigned)PRT_VO_NO_DD;
        if (prt__rgb_any(objects[k].specular)) off &= ~(unsigned)(PRT_VO_NO_DS | PRT_VO_NO_SS);
    }
    return off;
}

/* What the rays of a point found of one occluder; every ray counts 1. */
typedef struct prt__vo_sum {
    double hits, position[3], direction[3], diffuse_normal[3], specular_normal[3];
    double escaped, caustic[3], through[3];
} prt__vo_sum;

/* A ray on its way through transmissive objects, or to be tested for an open mirror direction. */
typedef struct prt__vo_path { int group; double normal[3], through[3]; } prt__vo_path;

typedef struct prt__vo_bake {
    const prt_vo_desc *desc;
    const prt_point *points;
    const prt_real *open;
    prt_vo_row *rows;
    prt_vo_occluder *occluders;
    int samples, keep, bends, groups;  /* groups: occluders of the whole scene */
    unsigned off;
    prt_real bias;
    prt_ray *rays, *next;              /* [PRT__VO_BATCH] each: feelers, and what follows from their hits */
    prt_hit *hits;                     /* [PRT__VO_BATCH] */
    prt__vo_path *paths;               /* [PRT__VO_BATCH], beside next */
    prt_real *x, *y, *z;               /* [PRT__VO_BATCH + PRT__BLOCK] */
    unsigned char *blocked;            /* [PRT__VO_BATCH] */
    prt__vo_sum *sums;                 /* [groups] */
    int *object_of, *base;             /* [groups], [object_count]: object of a group, first group of an object */
    int *order;                        /* [keep]: groups of a point in order of falling form factor */
    prt__steps steps;
} prt__vo_bake;

PRT__STATIC size_t prt__vo_layout(prt__vo_bake *b, unsigned char *memory) {
    size_t used = PRT__LINE, batch = PRT__VO_BATCH, groups = (size_t)b->groups;
    if (memory) used -= (size_t)((uintptr_t)memory % PRT__LINE);
    b->rays = (prt_ray *)prt__carve(memory, &used, batch, sizeof *b->rays);
    b->next = (prt_ray *)prt__carve(memory, &used, batch, sizeof *b->next);
    b->hits = (prt_hit *)prt__carve(memory, &used, batch, sizeof *b->hits);
    b->paths = (prt__vo_path *)prt__carve(memory, &used, batch, sizeof *b->paths);
    b->x = (prt_real *)prt__carve(memory, &used, batch + PRT__BLOCK, sizeof *b->x);
    b->y = (prt_real *)prt__carve(memory, &used, batch + PRT__BLOCK, sizeof *b->y);
    b->z = (prt_real *)prt__carve(memory, &used, batch + PRT__BLOCK, sizeof *b->z);
    b->blocked = (unsigned char *)prt__carve(memory, &used, batch, 1);
    b->sums = (prt__vo_sum *)prt__carve(memory, &used, groups, sizeof *b->sums);
    b->object_of = (int *)prt__carve(memory, &used, groups, sizeof *b->object_of);
    b->base = (int *)prt__carve(memory, &used, (size_t)b->desc->object_count, sizeof *b->base);
    b->order = (int *)prt__carve(memory, &used, (size_t)b->keep, sizeof *b->order);
    return used;
}

PRTDEF size_t prt_bake_vo_size(int max_occluders, int point_count) {
    size_t row;
    if (max_occluders < 0 || point_count < 0) return 0;
    row = (size_t)(max_occluders ? max_occluders : (int)PRT__VO_OCCLUDERS);
    if (row > SIZE_MAX / sizeof(prt_vo_occluder)) return 0;
    row *= sizeof(prt_vo_occluder);
    return (size_t)point_count > SIZE_MAX / row ? 0 : row * (size_t)point_count;
}

/* Defaults of desc, and the number of groups; PRT_ERR_CAPACITY if that does not fit an int. */
PRT__STATIC prt_result prt__vo_shape(prt__vo_bake *b, const prt_vo_desc *desc) {
    int k, groups = 0;
    memset(b, 0, sizeof *b);
    b->desc = desc;
    b->samples = desc->samples ? desc->samples : (int)PRT__VO_SAMPLES;
    b->keep = desc->max_occluders ? desc->max_occluders : (int)PRT__VO_OCCLUDERS;
    b->bends = desc->max_bends ? desc->max_bends : (int)PRT__VO_BENDS;
    for (k = 0; k < desc->object_count; k++) {
        int own = desc->objects[k].group_count ? desc->objects[k].group_count : 1;
        if (own > INT_MAX - groups) return PRT_ERR_CAPACITY;
        groups += own;
    }
    b->groups = groups;
    b->off = desc->off | prt_vo_unneeded(desc->object_count, desc->objects);
    return prt__vo_layout(b, 0) < SIZE_MAX ? PRT_OK : PRT_ERR_CAPACITY;
}

PRT__STATIC prt_result prt__vo_counts(const prt_vo_desc *desc) {
    int k;
    if (desc->samples < 0 || desc->max_occluders < 0 || desc->max_bends < 0) return PRT_ERR_COUNT;
    if (desc->object_count < 0) return PRT_ERR_COUNT;
    for (k = 0; desc->objects && k < desc->object_count; k++)
        if (desc->objects[k].primitive_count < 0 || desc->objects[k].group_count < 0) return PRT_ERR_COUNT;
    return desc->object_count > 0 && !desc->objects ? PRT_ERR_NULL : PRT_OK;
}

PRTDEF size_t prt_bake_vo_scratch_size(const prt_vo_desc *desc) {
    prt__vo_bake b;
    if (!desc || prt__vo_counts(desc) != PRT_OK || prt__vo_shape(&b, desc) != PRT_OK) return 0;
    return prt__vo_layout(&b, 0);
}

/* Pass 1 writes transfer of one band; this turns a row into a share, a whole number of rays, as soon as it stands
   there. */
typedef struct prt__vo_ao { const prt_vo_desc *desc; int samples; prt_real *open; } prt__vo_ao;
PRT__STATIC int prt__vo_ao_done(void *user, int done, int total) {
    const prt__vo_ao *ao = (const prt__vo_ao *)user;
    double share = (double)ao->open[done - 1] * (2 * 1.77245385090551602729816748334114518);    /* over Y(0,0) */
    ao->open[done - 1] = (prt_real)(floor(share * ao->samples + 0.5) / ao->samples);
    return ao->desc->progress ? ao->desc->progress(ao->desc->progress_user, done, total) : 0;
}

PRTDEF prt_result prt_bake_vo_ao(const prt_vo_desc *desc, int point_count, const prt_point *points, int first,
                                 int count, prt_real *open) {
    prt_bake_desc transfer;
    prt__vo_ao ao;
    if (!desc) return PRT_ERR_NULL;
    memset(&transfer, 0, sizeof transfer);
    transfer.bands = 1;
    transfer.samples = desc->samples ? desc->samples : (int)PRT__VO_SAMPLES;
    transfer.seed = desc->seed;
    transfer.bias = desc->bias;
    transfer.scene_radius = desc->scene_radius;
    transfer.tracer = desc->tracer;
    transfer.progress = prt__vo_ao_done;
    transfer.progress_user = &ao;
    ao.desc = desc;
    ao.samples = transfer.samples;
    ao.open = open ? open + first : NULL;
    return prt_bake_transfer(&transfer, point_count, points, first, count, open);
}

PRT__STATIC prt_result prt__vo_object_check(const prt_vo_object *o, int point_count) {
    int k, corner, groups = o->group_count ? o->group_count : 1;
    for (k = 0; k < o->primitive_count; k++) {
        if (o->groups && (o->groups[k] < 0 || o->groups[k] >= groups)) return PRT_ERR_COUNT;
        for (corner = 0; o->triangles && corner < 3; corner++)
            if (o->triangles[(size_t)k * 3 + (size_t)corner] >= (uint32_t)point_count) return PRT_ERR_COUNT;
    }
    if (!prt__rgb_within_1(o->diffuse) || !prt__rgb_within_1(o->specular) || !prt__rgb_within_1(o->transmissive))
        return PRT_ERR_VALUE;
    return prt__not_negative(o->refraction) ? PRT_OK : PRT_ERR_VALUE;
}

/* The first error of either kind over all objects: of counts before values. */
PRT__STATIC prt_result prt__vo_objects_check(const prt_vo_desc *desc, int point_count, prt_result kind) {
    int k;
    for (k = 0; k < desc->object_count; k++)
        if (prt__vo_object_check(&desc->objects[k], point_count) == kind) return kind;
    return PRT_OK;
}

PRT__STATIC prt_result prt__vo_values(const prt__vo_bake *b, int point_count, int first, int count) {
    const prt_vo_desc *desc = b->desc;
    int k;
    if (prt__vo_objects_check(desc, point_count, PRT_ERR_VALUE) != PRT_OK) return PRT_ERR_VALUE;
    if (!prt__not_negative(desc->bias) || !prt__not_negative(desc->scene_radius) || !prt__not_negative(desc->least))
        return PRT_ERR_VALUE;
    for (k = 0; b->open && k < point_count; k++) if (!(b->open[k] >= 0 && b->open[k] <= 1)) return PRT_ERR_VALUE;
    return prt__bake_points_check(b->bias, point_count, b->points, first, count);
}

/* Resolves the defaults of desc into b; the checks in the order that the interface promises. */
PRT__STATIC prt_result prt__vo_open(prt__vo_bake *b, const prt_vo_desc *desc, int point_count, const prt_point *points,
                                    const prt_real *open, int first, int count, prt_vo_row *rows,
                                    prt_vo_occluder *occluders) {
    prt_result r;
    if (!desc) return PRT_ERR_NULL;
    r = prt__vo_counts(desc);
    if (r != PRT_OK) return r;
    if (!prt__range_ok(point_count, first, count)) return PRT_ERR_COUNT;
    r = prt__vo_objects_check(desc, point_count, PRT_ERR_COUNT);
    if (r == PRT_OK) r = prt__vo_shape(b, desc);
    if (r != PRT_OK) return r;
    if (count > 0 && !prt_bake_vo_size(desc->max_occluders, point_count)) return PRT_ERR_CAPACITY;
    if (count > 0 && (!points || !rows || !occluders)) return PRT_ERR_NULL;
    if (!desc->tracer || !desc->tracer->closest) return PRT_ERR_NULL;
    if (!desc->tracer->occluded && (b->off & PRT__VO_MIRRORS) != PRT__VO_MIRRORS) return PRT_ERR_NULL;
    b->points = points;
    b->open = open;
    b->rows = rows;
    b->occluders = occluders;
    b->bias = prt__bake_bias(desc->bias, desc->scene_radius);
    return prt__vo_values(b, point_count, first, count);
}

PRT__STATIC void prt__vo_list_groups(prt__vo_bake *b) {
    int k, group = 0;
    for (k = 0; k < b->desc->object_count; k++) {
        int own = b->desc->objects[k].group_count ? b->desc->objects[k].group_count : 1;
        b->base[k] = group;
        for (; own > 0; own--) b->object_of[group++] = k;
    }
}

/* ---- rays ---- */

PRT__INLINE void prt__to_doubles(prt_vec3 v, double out[3]) {
    out[0] = (double)v.x; out[1] = (double)v.y; out[2] = (double)v.z;
}
PRT__INLINE void prt__add_scaled(double sum[3], const double v[3], double s) {
    sum[0] += s * v[0]; sum[1] += s * v[1]; sum[2] += s * v[2];
}

/* A hit in doubles: where, the unit normal as the tracer gave it, and the direction that met it. */
typedef struct prt__vo_event { double at[3], normal[3], dir[3]; } prt__vo_event;

/* Whether a hit can be; then what it is. */
PRT__STATIC int prt__vo_event_of(const prt__vo_bake *b, const prt_ray *ray, const prt_hit *hit, prt__vo_event *e) {
    const prt_vo_object *o;
    int k;
    if (hit->object >= b->desc->object_count) return 0;
    o = &b->desc->objects[hit->object];
    if ((o->groups || o->triangles) && (hit->primitive < 0 || hit->primitive >= o->primitive_count)) return 0;
    if (!prt__not_negative(hit->t) || !prt__unit_within(hit->normal)) return 0;
    if (o->triangles && !(prt__finite(hit->u) && prt__finite(hit->v))) return 0;
    prt__to_doubles(ray->origin, e->at);
    prt__to_doubles(ray->dir, e->dir);
    prt__to_doubles(hit->normal, e->normal);
    prt__add_scaled(e->at, e->dir, (double)hit->t);
    for (k = 0; k < 3; k++) if (!(fabs(e->at[k]) <= (double)PRT__REAL_MAX)) return 0;
    return 1;
}

/* A ray from a hit, lifted off the surface by the bias along `side`; tmin and tmax as everywhere. */
PRT__STATIC prt_ray prt__vo_ray_from(const prt__vo_bake *b, const double at[3], const double side[3], double sign,
                                     const double dir[3]) {
    prt_ray ray;
    double origin[3];
    int k;
    for (k = 0; k < 3; k++) origin[k] = at[k] + sign * (double)b->bias * side[k];
    ray.origin = prt__narrow(origin);
    ray.dir = prt__narrow(dir);
    ray.tmin = 0;
    ray.tmax = PRT__R(FLT_MAX);
    return ray;
}

/* Ambient occlusion at a hit. */
PRT__STATIC double prt__vo_open_at(const prt__vo_bake *b, const prt_hit *hit) {
    const prt_vo_object *o = &b->desc->objects[hit->object];
    const uint32_t *corner;
    double u = (double)hit->u, v = (double)hit->v, open;
    if (!b->open || !o->triangles) return 1;
    corner = o->triangles + (size_t)hit->primitive * 3;
    open = (1 - u - v) * (double)b->open[corner[0]] + u * (double)b->open[corner[1]] + v * (double)b->open[corner[2]];
    return open < 0 ? 0 : open > 1 ? 1 : open;
}

PRT__STATIC int prt__vo_group_of(const prt__vo_bake *b, const prt_hit *hit) {
    const prt_vo_object *o = &b->desc->objects[hit->object];
    return b->base[hit->object] + (o->groups ? o->groups[hit->primitive] : 0);
}

/* Snell's law. dir meets the surface with outward unit normal n of a body whose index, against outside, is
   `refraction`; dir becomes the direction behind it. Returns 1: it entered, -1: it left, 0: total internal
   reflection. */
PRT__STATIC int prt__vo_bend(double refraction, const double n[3], double dir[3]) {
    double along = prt__ddot(dir, n), sign = along < 0 ? 1 : -1, cosine = along < 0 ? -along : along;
    double ratio = along < 0 ? 1 / refraction : refraction, left = 1 - ratio * ratio * (1 - cosine * cosine), bent[3];
    int k;
    if (left < 0) {
        for (k = 0; k < 3; k++) bent[k] = dir[k] - 2 * along * n[k];
        prt__normalise(bent, dir);
        return 0;
    }
    for (k = 0; k < 3; k++) bent[k] = ratio * dir[k] + (ratio * cosine - sqrt(left)) * sign * n[k];
    prt__normalise(bent, dir);
    return along < 0 ? 1 : -1;
}

/* Adds path and ray number `at` to the rays that follow: what becomes of a ray that met a transmissive object. */
PRT__STATIC void prt__vo_follow(prt__vo_bake *b, int at, int object, const prt__vo_event *e, const prt__vo_path *path) {
    const prt_vo_object *o = &b->desc->objects[object];
    double refraction = o->refraction > 0 ? (double)o->refraction : 1.5, dir[3], inside;
    prt__vo_path *p = &b->paths[at];
    int entered;
    *p = *path;
    dir[0] = e->dir[0]; dir[1] = e->dir[1]; dir[2] = e->dir[2];
    entered = prt__vo_bend(refraction, e->normal, dir);
    if (entered > 0) {
        p->through[0] *= (double)o->transmissive.r;
        p->through[1] *= (double)o->transmissive.g;
        p->through[2] *= (double)o->transmissive.b;
    }
    inside = entered > 0 || (entered == 0 && prt__ddot(e->dir, e->normal) > 0) ? -1 : 1;
    b->next[at] = prt__vo_ray_from(b, e->at, e->normal, inside, dir);
}

/* Follows `count` rays until they reach free space, meet something opaque, or have been bent too often. */
PRT__STATIC prt_result prt__vo_caustics(prt__vo_bake *b, int count) {
    const prt_tracer *tracer = b->desc->tracer;
    int bend, k;
    for (bend = 1; count > 0; bend++) {
        int left = 0;
        for (k = 0; k < count; k++) b->hits[k].object = -1;
        if (tracer->closest(tracer->user, count, b->next, b->hits)) return PRT_ERR_TRACE;
        for (k = 0; k < count; k++) {
            prt__vo_path path = b->paths[k];
            prt__vo_event e;
            if (b->hits[k].object < 0) {
                prt__vo_sum *s = &b->sums[path.group];
                prt__to_doubles(b->next[k].dir, e.dir);
                prt__add_scaled(s->caustic, e.dir, 1);
                prt__add_scaled(s->through, path.through, 1);
                s->escaped++;
                continue;
            }
            if (!prt__vo_event_of(b, &b->next[k], &b->hits[k], &e)) return PRT_ERR_TRACE;
            if (bend < b->bends && prt__rgb_any(b->desc->objects[b->hits[k].object].transmissive))
                prt__vo_follow(b, left++, b->hits[k].object, &e, &path);
        }
        count = left;
    }
    return PRT_OK;
}

/* Counts the hits whose mirror direction is open. */
PRT__STATIC prt_result prt__vo_mirrors(prt__vo_bake *b, int count) {
    const prt_tracer *tracer = b->desc->tracer;
    int k;
    if (count == 0) return PRT_OK;
    memset(b->blocked, 0, (size_t)count);
    if (tracer->occluded(tracer->user, count, b->next, b->blocked)) return PRT_ERR_TRACE;
    for (k = 0; k < count; k++)
        if (!b->blocked[k]) prt__add_scaled(b->sums[b->paths[k].group].specular_normal, b->paths[k].normal, 1);
    return PRT_OK;
}

/* Adds a hit to the sums of its occluder; queues its mirror ray as number *mirrors where one is wanted. */
PRT__STATIC void prt__vo_add_hit(prt__vo_bake *b, const prt_hit *hit, const prt__vo_event *e, int *mirrors) {
    const prt_vo_object *o = &b->desc->objects[hit->object];
    int group = prt__vo_group_of(b, hit), k;
    prt__vo_sum *s = &b->sums[group];
    double along = prt__ddot(e->dir, e->normal), side = along > 0 ? -1 : 1, mirror[3];
    s->hits++;
    prt__add_scaled(s->position, e->at, 1);
    prt__add_scaled(s->direction, e->dir, 1);
    if (!(b->off & PRT_VO_NO_DD)) prt__add_scaled(s->diffuse_normal, e->normal, side * prt__vo_open_at(b, hit));
    if ((b->off & PRT__VO_MIRRORS) == PRT__VO_MIRRORS || !prt__rgb_any(o->specular)) return;
    for (k = 0; k < 3; k++) {
        mirror[k] = e->dir[k] - 2 * along * e->normal[k];
        b->paths[*mirrors].normal[k] = side * e->normal[k];
    }
    b->paths[*mirrors].group = group;
    b->next[(*mirrors)++] = prt__vo_ray_from(b, e->at, e->normal, side, mirror);
}

/* Traces `count` feeler rays of a point, whose directions stand in x, y, z, and all that follows from them. */
PRT__STATIC prt_result prt__vo_feel(prt__vo_bake *b, prt_vec3 origin, int count) {
    const prt_tracer *tracer = b->desc->tracer;
    int k, mirrors = 0, bent = 0;
    prt__vo_event e;
    prt__vo_path path;
    prt_result r;
    prt__start_rays(origin, count, b->x, b->y, b->z, b->rays, b->hits);
    if (tracer->closest(tracer->user, count, b->rays, b->hits)) return PRT_ERR_TRACE;
    for (k = 0; k < count; k++) {
        if (b->hits[k].object < 0) continue;
        if (!prt__vo_event_of(b, &b->rays[k], &b->hits[k], &e)) return PRT_ERR_TRACE;
        prt__vo_add_hit(b, &b->hits[k], &e, &mirrors);
    }
    r = prt__vo_mirrors(b, mirrors);
    if (r != PRT_OK || (b->off & PRT_VO_NO_CAUSTIC)) return r;
    for (k = 0; k < count; k++) {
        int object = b->hits[k].object;
        if (object < 0 || !prt__rgb_any(b->desc->objects[object].transmissive)) continue;
        prt__vo_event_of(b, &b->rays[k], &b->hits[k], &e);
        path.group = prt__vo_group_of(b, &b->hits[k]);
        path.through[0] = path.through[1] = path.through[2] = 1;
        path.normal[0] = path.normal[1] = path.normal[2] = 0;
        prt__vo_follow(b, bent++, object, &e, &path);
    }
    return prt__vo_caustics(b, bent);
}

/* ---- one point ---- */

PRT__STATIC prt_vec3 prt__vo_unit(const double v[3]) {
    double unit[3];
    prt__normalise(v, unit);
    return prt__narrow(unit);
}
PRT__STATIC prt_vec3 prt__vo_over(const double v[3], double count) {
    double mean[3];
    int k;
    for (k = 0; k < 3; k++) mean[k] = v[k] / count;
    return prt__narrow(mean);
}

PRT__STATIC prt_vo_occluder prt__vo_occluder_of(const prt__vo_bake *b, int group) {
    const prt__vo_sum *s = &b->sums[group];
    const prt_vo_object *o = &b->desc->objects[b->object_of[group]];
    prt_vo_occluder out;
    memset(&out, 0, sizeof out);
    out.position = prt__vo_over(s->position, s->hits);
    out.occlusion = prt__vo_unit(s->direction);
    out.form_factor = (prt_real)(s->hits / b->samples);
    if (!(b->off & PRT_VO_NO_DD)) {
        out.diffuse = o->diffuse;
        out.diffuse_normal = prt__vo_over(s->diffuse_normal, b->samples);
    }
    if ((b->off & PRT__VO_MIRRORS) != PRT__VO_MIRRORS) {
        out.specular = o->specular;
        out.specular_normal = prt__vo_over(s->specular_normal, b->samples);
    }
    if (b->off & PRT_VO_NO_CAUSTIC) {
        out.transmissive = o->transmissive;
    } else if (s->escaped > 0) {
        out.caustic = prt__vo_unit(s->caustic);
        out.caustic_factor = (prt_real)(s->escaped / b->samples);
        out.transmissive.r = (prt_real)(s->through[0] / s->escaped);
        out.transmissive.g = (prt_real)(s->through[1] / s->escaped);
        out.transmissive.b = (prt_real)(s->through[2] / s->escaped);
    }
    return out;
}

/* Keeps the strongest occluders of a point; of equal ones the first in the scene. */
PRT__STATIC void prt__vo_keep(prt__vo_bake *b, int point) {
    prt_vo_row row;
    prt_vo_occluder *out = b->occluders + (size_t)point * (size_t)b->keep;
    double lost = 0;
    int g, k;
    memset(&row, 0, sizeof row);
    for (g = 0; g < b->groups; g++) {
        double hits = b->sums[g].hits;
        if (!(hits > 0)) continue;
        if (hits / b->samples < (double)b->desc->least ||
            (row.count == b->keep && !(hits > b->sums[b->order[b->keep - 1]].hits))) {
            row.dropped++;
            lost += hits;
            continue;
        }
        if (row.count == b->keep) { row.dropped++; lost += b->sums[b->order[b->keep - 1]].hits; }
        else row.count++;
        for (k = row.count - 1; k > 0 && hits > b->sums[b->order[k - 1]].hits; k--) b->order[k] = b->order[k - 1];
        b->order[k] = g;
    }
    row.dropped_factor = (prt_real)(lost / b->samples);
    b->rows[point] = row;
    for (k = 0; k < row.count; k++) out[k] = prt__vo_occluder_of(b, b->order[k]);
    if (k < b->keep) memset(out + k, 0, (size_t)(b->keep - k) * sizeof *out);
}

PRT__STATIC prt_result prt__vo_bake_point(prt__vo_bake *b, int point) {
    const prt_point *p = &b->points[point];
    prt__lattice lattice = prt__lattice_of(b->samples, b->desc->seed, (uint64_t)point);
    prt__frame frame = prt__frame_about(p->normal);
    int from, k;
    if (b->groups > 0) memset(b->sums, 0, (size_t)b->groups * sizeof *b->sums);
    for (from = 0; from < b->samples; from += PRT__VO_BATCH) {
        int count = b->samples - from < PRT__VO_BATCH ? b->samples - from : (int)PRT__VO_BATCH;
        prt_result r;
        for (k = 0; k < count; k += PRT__BLOCK)
            prt__cosine_block(&lattice, &b->steps, &frame, from + k,
                              count - k < PRT__BLOCK ? count - k : (int)PRT__BLOCK, b->x + k, b->y + k, b->z + k);
        r = prt__vo_feel(b, prt__bake_origin(b->bias, p), count);
        if (r != PRT_OK) return r;
    }
    prt__vo_keep(b, point);
    return PRT_OK;
}

PRTDEF prt_result prt_bake_vo(const prt_vo_desc *desc, int point_count, const prt_point *points, const prt_real *open,
                              int first, int count, prt_vo_row *rows, prt_vo_occluder *occluders) {
    prt__vo_bake b;
    prt_result r = prt__vo_open(&b, desc, point_count, points, open, first, count, rows, occluders);
    size_t size;
    void *memory;
    int k;
    if (r != PRT_OK || count == 0) return r;
    size = prt__vo_layout(&b, 0);
    memory = PRT_MALLOC(size);
    if (!memory) return PRT_ERR_MEMORY;
    memset(memory, 0, size);
    prt__vo_layout(&b, (unsigned char *)memory);
    prt__steps_of_block(&b.steps);
    prt__vo_list_groups(&b);
    for (k = first; r == PRT_OK && k < first + count; k++) {
        r = prt__vo_bake_point(&b, k);
        if (r == PRT_OK && desc->progress && desc->progress(desc->progress_user, k - first + 1, count))
            r = PRT_ERR_CANCELLED;
    }
    PRT_FREE(memory);
    return r;
}

PRTDEF prt_result prt_vo_compact(int max_occluders, int point_count, const prt_vo_row *rows, prt_vo_occluder *occluders,
                                 int *first) {
    int keep = max_occluders ? max_occluders : (int)PRT__VO_OCCLUDERS, total = 0, k;
    if (max_occluders < 0 || point_count < 0) return PRT_ERR_COUNT;
    if (!first || (point_count > 0 && (!rows || !occluders))) return PRT_ERR_NULL;
    for (k = 0; k < point_count; k++) {
        if (rows[k].count < 0 || rows[k].count > keep) return PRT_ERR_COUNT;
        if (rows[k].count > INT_MAX - total) return PRT_ERR_CAPACITY;
        total += rows[k].count;
    }
    first[0] = 0;
    for (k = 0; k < point_count; k++) {
        if (rows[k].count > 0)
            memmove(occluders + first[k], occluders + (size_t)k * (size_t)keep,
                    (size_t)rows[k].count * sizeof *occluders);
        first[k + 1] = first[k] + rows[k].count;
    }
    return PRT_OK;
}

/* ---- splitting ---- */

enum { PRT__SPLIT_ROUNDS = 32, PRT__SPLIT_AXES = 6 };         /* axes: centroid, then normal */
typedef struct prt__split_face { double at[PRT__SPLIT_AXES], area; } prt__split_face;
typedef struct prt__split_group {
    double at[PRT__SPLIT_AXES], sum[PRT__SPLIT_AXES], area;
    int number;
} prt__split_group;

typedef struct prt__split {
    int faces, groups;
    prt__split_face *face;             /* [faces] */
    double *nearest;                   /* [faces]: square of the distance to the nearest seed */
    prt__split_group *group;           /* [groups] */
    int *of;                           /* [faces], the caller's */
} prt__split;

PRT__STATIC double prt__split_distance(const double *a, const double *b) {
    double sum = 0;
    int k;
    for (k = 0; k < PRT__SPLIT_AXES; k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

/* Places of the faces in units of the mesh's radius, so that squares neither overflow nor vanish. */
PRT__STATIC void prt__split_faces(prt__split *s, const prt_mesh *mesh, double facing) {
    prt_mesh_report box;
    double unit, weight = sqrt(facing);
    int k, c;
    prt__box(mesh, &box);
    unit = box.radius > 0 ? (double)box.radius : 1;
    for (k = 0; k < s->faces; k++) {
        const uint32_t *corner = mesh->triangles + (size_t)k * 3;
        prt__split_face *f = &s->face[k];
        double p[3][3], a[3], b[3], n[3], length;
        for (c = 0; c < 3; c++) {
            p[c][0] = (double)mesh->positions[corner[c]].x / unit - (double)box.centre.x / unit;
            p[c][1] = (double)mesh->positions[corner[c]].y / unit - (double)box.centre.y / unit;
            p[c][2] = (double)mesh->positions[corner[c]].z / unit - (double)box.centre.z / unit;
        }
        for (c = 0; c < 3; c++) { a[c] = p[1][c] - p[0][c]; b[c] = p[2][c] - p[0][c]; }
        n[0] = a[1] * b[2] - a[2] * b[1]; n[1] = a[2] * b[0] - a[0] * b[2]; n[2] = a[0] * b[1] - a[1] * b[0];
        length = prt__length(n);
        f->area = length / 2;
        for (c = 0; c < 3; c++) {
            f->at[c] = (p[0][c] + p[1][c] + p[2][c]) / 3;
            f->at[3 + c] = length > 0 ? weight * n[c] / length : 0;
        }
    }
}

/* Makes the face a seed. */
PRT__STATIC void prt__split_seed(prt__split *s, int face) {
    prt__split_group *g = &s->group[s->groups];
    int k;
    for (k = 0; k < PRT__SPLIT_AXES; k++) g->at[k] = s->face[face].at[k];
    for (k = 0; k < s->faces; k++) {
        double d = prt__split_distance(g->at, s->face[k].at);
        if (s->groups == 0 || d < s->nearest[k]) { s->nearest[k] = d; s->of[k] = s->groups; }
    }
    s->groups++;
}

/* The face with area that is farthest from all seeds, or -1 if all stand on one; the first seed is the face farthest
   from the centre. */
PRT__STATIC int prt__split_farthest(const prt__split *s) {
    static const double centre[PRT__SPLIT_AXES] = { 0, 0, 0, 0, 0, 0 };
    double most = 0;
    int k, face = -1;
    for (k = 0; k < s->faces; k++) {
        double d = s->groups ? s->nearest[k] : 1 + prt__split_distance(s->face[k].at, centre);
        if (s->face[k].area > 0 && d > most) { most = d; face = k; }
    }
    return face;
}

/* One round: each face to its nearest group, each group to the mean of its faces. Returns how many faces moved. */
PRT__STATIC int prt__split_round(prt__split *s) {
    int k, g, c, moved = 0;
    for (g = 0; g < s->groups; g++) { memset(s->group[g].sum, 0, sizeof s->group[g].sum); s->group[g].area = 0; }
    for (k = 0; k < s->faces; k++) {
        const prt__split_face *f = &s->face[k];
        double nearest = prt__split_distance(f->at, s->group[s->of[k]].at);
        int own = s->of[k];
        for (g = 0; g < s->groups; g++) {
            double d = prt__split_distance(f->at, s->group[g].at);
            if (d < nearest) { nearest = d; own = g; }
        }
        moved += own != s->of[k];
        s->of[k] = own;
        for (c = 0; c < PRT__SPLIT_AXES; c++) s->group[own].sum[c] += f->area * f->at[c];
        s->group[own].area += f->area;
    }
    for (g = 0; g < s->groups; g++)
        for (c = 0; c < PRT__SPLIT_AXES && s->group[g].area > 0; c++)
            s->group[g].at[c] = s->group[g].sum[c] / s->group[g].area;
    return moved;
}

/* Numbers the groups in the order of their first face; returns how many have one. */
PRT__STATIC int prt__split_number(prt__split *s) {
    int k, g, made = 0;
    for (g = 0; g < s->groups; g++) s->group[g].number = -1;
    for (k = 0; k < s->faces; k++) {
        prt__split_group *own = &s->group[s->of[k]];
        if (own->number < 0) own->number = made++;
        s->of[k] = own->number;
    }
    return made;
}

PRTDEF prt_result prt_vo_split(const prt_mesh *mesh, int group_count, prt_real facing, int *groups, int *made) {
    prt__split s;
    size_t used = PRT__LINE, size;
    unsigned char *memory;
    prt_point unused = { { 0, 0, 0 }, { 0, 0, 1 } };
    prt_result r;
    int round, face, most;
    if (!mesh) return PRT_ERR_NULL;
    if (group_count < 1) return PRT_ERR_COUNT;
    if (!made || (mesh->triangle_count > 0 && !groups)) return PRT_ERR_NULL;
    r = prt__mesh_check(mesh, &unused);
    if (r != PRT_OK) return r;
    if (!(facing >= 0 && facing <= 1)) return PRT_ERR_VALUE;
    memset(&s, 0, sizeof s);
    if (mesh->triangle_count == 0) { *made = 0; return PRT_OK; }
    s.faces = mesh->triangle_count;
    s.of = groups;
    most = group_count < s.faces ? group_count : s.faces;
    prt__carve(0, &used, (size_t)s.faces, sizeof *s.face);
    prt__carve(0, &used, (size_t)s.faces, sizeof *s.nearest);
    prt__carve(0, &used, (size_t)most, sizeof *s.group);
    if (used == SIZE_MAX) return PRT_ERR_CAPACITY;
    size = used;
    memory = (unsigned char *)PRT_MALLOC(size);
    if (!memory) return PRT_ERR_MEMORY;
    used = PRT__LINE - (size_t)((uintptr_t)memory % PRT__LINE);
    s.face = (prt__split_face *)prt__carve(memory, &used, (size_t)s.faces, sizeof *s.face);
    s.nearest = (double *)prt__carve(memory, &used, (size_t)s.faces, sizeof *s.nearest);
    s.group = (prt__split_group *)prt__carve(memory, &used, (size_t)most, sizeof *s.group);
    prt__split_faces(&s, mesh, (double)facing);
    while (s.groups < most && (face = prt__split_farthest(&s)) >= 0) prt__split_seed(&s, face);
    if (s.groups == 0) prt__split_seed(&s, 0);                 /* no face has an area */
    for (round = 0; round < PRT__SPLIT_ROUNDS && prt__split_round(&s) > 0; round++) continue;
    *made = prt__split_number(&s);
    PRT_FREE(memory);
    return PRT_OK;
}

/* ----------------------------------------------------------------------------------------------- >>measure ---- */

PRT__STATIC double prt__band_energy(int l, const prt_real *f) {
    double sum = 0;
    int i;
    for (i = l * l; i < (l + 1) * (l + 1); i++) sum += (double)f[i] * (double)f[i];
    return sum;
}

PRTDEF prt_result prt_measure_energy(int bands, int count, const prt_real *f, double *energy) {
    int k, l;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (count < 0) return PRT_ERR_COUNT;
    if (!energy || (count > 0 && !f)) return PRT_ERR_NULL;
    for (l = 0; l < bands; l++) energy[l] = 0;
    for (k = 0; k < count; k++)
        for (l = 0; l < bands; l++)
            energy[l] += prt__band_energy(l, f + (size_t)k * (size_t)PRT_SH_COUNT(bands)) / count;
    return PRT_OK;
}

/* lost[l] = 1 - w(l): the part of band l that so many bands and the window leave out */
PRT__STATIC prt_result prt__lost_weights(int bands, int kept, prt_window w, double *lost) {
    int l;
    if (!prt__window_ok(w)) return PRT_ERR_VALUE;
    if (kept > 0) prt__window_weights(w, kept, bands, lost);
    for (l = 0; l < bands; l++) lost[l] = l < kept ? 1 - lost[l] : 1;
    return PRT_OK;
}

/* sum over bands of weight[l] (T_l - U_l) . L_l; U may be NULL: 0 */
PRT__STATIC double prt__weighted_dot(int bands, const double *weight, const prt_real *t, const prt_real *u,
                                     const prt_real *light) {
    double sum = 0;
    int l, i;
    for (l = 0; l < bands; l++) {
        double band = 0;
        for (i = l * l; i < (l + 1) * (l + 1); i++)
            band += ((double)t[i] - (u ? (double)u[i] : 0)) * (double)light[i];
        sum += weight[l] * band;
    }
    return sum;
}

/* Root of the mean of that, squared, over points and colours */
PRT__STATIC double prt__radiance_rms(int bands, const double *weight, int point_count, const prt_real *t,
                                     const prt_real *u, const prt_real *light) {
    size_t row = (size_t)PRT_SH_COUNT(bands);
    double sum = 0;
    int k, c;
    for (k = 0; k < point_count; k++)
        for (c = 0; c < 3; c++) {
            double e = prt__weighted_dot(bands, weight, t + (size_t)k * row, u ? u + (size_t)k * row : NULL,
                                         light + (size_t)c * row);
            sum += e * e;
        }
    return point_count > 0 ? sqrt(sum / 3 / point_count) : 0;
}

PRTDEF prt_result prt_measure_truncation(int bands, int kept, prt_window w, int point_count, const prt_real *transfer,
                                         const prt_real *light, double *rms) {
    double lost[PRT_MAX_BANDS];
    prt_result r;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (kept < 0 || kept > bands || point_count < 0) return PRT_ERR_COUNT;
    if (!light || !rms || (point_count > 0 && !transfer)) return PRT_ERR_NULL;
    r = prt__lost_weights(bands, kept, w, lost);
    if (r == PRT_OK) *rms = prt__radiance_rms(bands, lost, point_count, transfer, NULL, light);
    return r;
}

PRTDEF prt_result prt_measure_truncation_turned(int bands, int kept, prt_window w, const double *transfer_energy,
                                                const double *light_energy, double *rms) {
    double lost[PRT_MAX_BANDS], sum = 0;
    prt_result r;
    int l;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (kept < 0 || kept > bands) return PRT_ERR_COUNT;
    if (!transfer_energy || !light_energy || !rms) return PRT_ERR_NULL;
    r = prt__lost_weights(bands, kept, w, lost);
    if (r != PRT_OK) return r;
    for (l = 0; l < bands; l++) sum += lost[l] * lost[l] * transfer_energy[l] * light_energy[l] / (2 * l + 1);
    *rms = sqrt(sum);
    return PRT_OK;
}

PRTDEF prt_result prt_measure_noise(int bands, int point_count, const prt_real *a, const prt_real *b,
                                    const prt_real *light, double *error) {
    double half[PRT_MAX_BANDS];
    int l;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (point_count < 0) return PRT_ERR_COUNT;
    if (!light || !error || (point_count > 0 && (!a || !b))) return PRT_ERR_NULL;
    for (l = 0; l < bands; l++) half[l] = 0.5;
    *error = prt__radiance_rms(bands, half, point_count, a, b, light);
    return PRT_OK;
}

PRTDEF int prt_measure_rays(int rays, double error, double rate, double wanted) {
    double needed;
    if (rays < 1 || !(error >= 0) || !(rate > 0) || !(wanted > 0)) return 0;
    needed = ceil(rays * pow(error / wanted, 1 / rate));
    return needed >= (double)INT_MAX ? INT_MAX : needed > 1 ? (int)needed : 1;
}

/* -p log2 p; 0 for what is no chance */
PRT__STATIC double prt__information(double p) { return p > 0 ? -p * log(p) / log(2.0) : 0; }

PRTDEF double prt_measure_entropy(int count, const prt_real *shares) {
    double sum = 0, entropy = 0;
    int k;
    if (count < 0 || !shares) return 0;
    for (k = 0; k < count; k++) if (shares[k] > 0) sum += (double)shares[k];
    for (k = 0; k < count; k++) if (shares[k] > 0) entropy += prt__information((double)shares[k] / sum);
    return entropy > 0 ? entropy : 0;
}

PRTDEF prt_result prt_measure_visibility(int bands, int point_count, const prt_real *transfer, prt_visibility *out) {
    double open = 0, entropy = 0;
    int k;
    if (!prt__bands_ok(bands)) return PRT_ERR_BANDS;
    if (point_count < 0) return PRT_ERR_COUNT;
    if (!out || (point_count > 0 && !transfer)) return PRT_ERR_NULL;
    for (k = 0; k < point_count; k++) {
        double p = (double)transfer[(size_t)k * (size_t)PRT_SH_COUNT(bands)] * 2 * sqrt(PRT__PI);
        open += p / point_count;
        entropy += (prt__information(p) + prt__information(1 - p)) / point_count;
    }
    out->open = open;
    out->entropy = entropy;
    out->information = point_count > 0 ? prt__information(open) + prt__information(1 - open) - entropy : 0;
    if (!(out->information > 0)) out->information = 0;
    return PRT_OK;
}

PRTDEF prt_result prt_measure_occluders(int max_occluders, int point_count, const prt_vo_row *rows,
                                        const prt_vo_occluder *occluders, double *left) {
    int keep = max_occluders ? max_occluders : (int)PRT__VO_OCCLUDERS, k, i;
    if (max_occluders < 0 || point_count < 0) return PRT_ERR_COUNT;
    if (!left || (point_count > 0 && (!rows || !occluders))) return PRT_ERR_NULL;
    for (k = 0; k < point_count; k++) if (rows[k].count < 0 || rows[k].count > keep) return PRT_ERR_COUNT;
    for (i = 0; i <= keep; i++) left[i] = 0;
    for (k = 0; k < point_count; k++) {
        const prt_vo_occluder *own = occluders + (size_t)k * (size_t)keep;
        double rest = (double)rows[k].dropped_factor;
        for (i = keep; i >= 0; i--) {
            if (i < rows[k].count) rest += (double)own[i].form_factor;
            left[i] += rest / point_count;
        }
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
