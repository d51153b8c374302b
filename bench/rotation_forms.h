/* rotation_forms.h - what rotation.c asks of rotation_forms.c, which is compiled once for each id: float, double, and
   float without the machine's own vectors (portable). */
#ifndef ROTATION_FORMS_H
#define ROTATION_FORMS_H

#include "bench.h"

enum { ROTATION_BANDS = 128, ROTATION_TRIALS = 4, ROTATION_POINTS = 128, ROTATION_LARGEST = 32 };

/* Error and time of one way to compute something with so many bands. */
enum { TURNED_BANDS = 6, TURNED = TURNED_BANDS * TURNED_BANDS };

typedef struct rotation_point { const char *what, *form; int bands; double ns, error; } rotation_point;

/* What the result should be, from rotation.c: f turned by r, and the CH basis at d. */
typedef void rotation_truth(int bands, const double *r_or_d, const double *f, double *want);

#define ROTATION_FUNCTIONS(id) \
    /* the same point of somebody else's way to turn a vector (peer.h), job "rotate". */ \
    rotation_point rotation_peer_##id(rotation_truth *turned, const bench_peer *peer, int bands); \
    /* error[l] = largest |M M^T - 1| of band l over ROTATION_TRIALS rotations; 0 if there was no memory. */ \
    int rotation_blocks_##id(double *published, double *stabilised); \
    /* error against time of rotation and of CH; returns how many points. */ \
    int rotation_points_##id(rotation_truth *turned, rotation_truth *ch, rotation_point *points); \
    /* f after 1000 turns by r, one shot and by built blocks; `rounded`: by blocks of r as given, entries in float. */ \
    void rotation_turns_##id(const double *r, int rounded, const double *f, double *one_shot, double *blocks); \
    /* rates at 4 bands beyond the caches over that of memcpy: _n, _n_rgb, _soa; 0 if there was no memory. */ \
    int rotation_stream_##id(double rate[3]);
ROTATION_FUNCTIONS(float)
ROTATION_FUNCTIONS(double)
ROTATION_FUNCTIONS(portable)

#endif
