/* fiv_receive: the irradiance of receivers (stage.h) from baked vectors, what a pixel shader would do. */
#ifndef EXAMPLES_FIV_RECEIVE_H
#define EXAMPLES_FIV_RECEIVE_H

#include "stage.h"

enum { FIV_NO_PARTIAL = 1 << 16 };     /* beside PRT_FIV_...: N.FIV also for occluders that the horizon cuts */

typedef struct fiv_receive {
    const stage           *stage;
    const receivers       *receivers;
    const prt_fiv_table   *const *tables;        /* [body_count] in the frame of the body: of the light as it sees it */
    const prt_fiv_table   *const *self;          /* [body_count] the same for self-shadow; NULL: bodies stay black */
    prt_fiv               environment;           /* prt_bake_fiv_environment, in the world */
    prt_rgb               ground_total;          /* irradiance of the open ground */
    unsigned              flags;
    int                   threads;
    volatile sig_atomic_t *stop;
} fiv_receive;

/* alpha as in truth_trace. 0, or -1 with the reason in w ("interrupted" where it was stopped). */
int fiv_receive_run(const fiv_receive *f, picture *out, why *w);

#endif
