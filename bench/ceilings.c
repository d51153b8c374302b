/* ceilings.c - the memory ceilings, and the list of arithmetic ceilings, one from each build. */
#include "ceilings.h"
#include "configurations.h"

#include <string.h>

static int one(int bands) { (void)bands; return 1; }
static double none(int bands) { (void)bands; return 0; }

const bench_candidate bench_ceiling_write = { "ceiling", "write", "", 0, "", 0, one, NULL, none, none, none, 0 };
const bench_candidate bench_ceiling_copy  = { "ceiling", "copy",  "", 0, "", 0, one, NULL, none, none, none, 0 };

void bench_ceiling_run(const bench_candidate *ceiling, const bench_data *data, size_t chunk, int items, long passes) {
    int k;
    for (; passes > 0; passes--)
        for (k = 0; k < items; k++) {
            if (ceiling == &bench_ceiling_write) memset(data->out, 0, chunk);
            else memcpy(data->out, data->rows, chunk);
            BENCH_KEEP(data->out);
        }
}

const bench_candidate *bench_ceiling_flops(const char *build, int real_bytes) {
#define PEAK_OF(id) \
    { const bench_candidate *peak = bench_peak_##id(); \
      if (!strcmp(peak->build, build) && peak->real_bytes == real_bytes) return peak; }
    BENCH_CONFIGURATIONS(PEAK_OF)
#undef PEAK_OF
    return NULL;
}
