/* ceilings.h - what the hardware can do at best, measured in the same rounds as the candidates. */
#ifndef BENCH_CEILINGS_H
#define BENCH_CEILINGS_H

#include "bench.h"

extern const bench_candidate bench_ceiling_write;   /* memset of the output bytes */
extern const bench_candidate bench_ceiling_copy;    /* memcpy of the output bytes */

/* Runs a memory ceiling: `items` times `chunk` bytes to the start of the output, `passes` times over. */
void bench_ceiling_run(const bench_candidate *ceiling, const bench_data *data, size_t chunk, int items, long passes);

/* Independent multiply-adds on the widest vectors of a build: one item is one operation. NULL for an unknown build:
   that of a peer is "native" unless it says otherwise. */
const bench_candidate *bench_ceiling_flops(const char *build, int real_bytes);

#endif
