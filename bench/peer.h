/* peer.h - benchmark a library of your own against prt.h, side by side in one run, without touching this tree.

   Write a C or C++ file anywhere, say /elsewhere/my_sh.c:

     #include "peer.h"
     #include "my_sh.h"

     static void run_eval(const bench_data *data, int bands, int items, long passes) {
         const float (*dir)[3] = (const float (*)[3])data->directions;
         float *y = (float *)data->out;
         int k;
         for (; passes > 0; passes--)
             for (k = 0; k < items; k++) {
                 my_sh_eval(bands, dir[k], y);
                 BENCH_KEEP(y);                    // after each call: its result is needed
             }
     }

     static const bench_peer rows[] = {
         { "eval",     "my library", sizeof(float), "2-6", run_eval },
         { "eval_soa", "my library", sizeof(float), "2-6", run_eval_soa },
     };
     BENCH_PEER_REGISTER(my_library, rows)

   and configure with

     cmake -S . -B build-peers -DPRT_BENCH_PEERS=/elsewhere/my_sh.c
           [-DPRT_BENCH_PEER_INCLUDES=/elsewhere/include] [-DPRT_BENCH_PEER_LIBRARIES=/elsewhere/libmy_sh.a]
     cmake --build build-peers --target prt_bench && build-peers/bench/prt_bench --filter eval

   (several values of one option are separated by semicolons). The file is compiled with the flags of the "native"
   rows. A row joins the group of the same job, bands and precision, and its operations and bytes are taken to be those
   of the job; the jobs are the lines of candidates.h. EACH jobs call once for each item and write all results to the
   same place, followed by BENCH_KEEP; BATCH jobs write their items one after the other: [items][n^2] for "eval_n",
   coefficient i of direction k at out[i * items + k] for "eval_soa". Everything that a library prepares once belongs
   outside of the timed loop. "rotate" turns data->f by data->rotation, "rotate_by" does it with matrices made before,
   "product" multiplies data->f and data->g. Whoever takes part in a job "eval...", "rotate" or "rotate_by" is checked
   before it is timed: its squares must sum to n^2 / (4 pi) a direction, or to those of data->f, which holds for every
   sign and order of the coefficients.

   The program `rotation` takes the rows of the job "rotate" too and puts them into the plot of error against time; there
   results are compared, so what stands in data->f and data->out must have the signs and the order of prt.h: change
   them outside of the loop. `rotation --peers bench/results/rotation-peers.csv` keeps what it found for docs/rotation.md. */
#ifndef BENCH_PEER_H
#define BENCH_PEER_H

#include "bench.h"

/* Makes `rows`, an array of bench_peer, take part; `id` is any name that no other peer uses. */
#define BENCH_PEER_REGISTER(id, rows) \
    __attribute__((constructor)) static void bench_register_##id(void) { \
        bench_add_peers(rows, (int)(sizeof(rows) / sizeof((rows)[0]))); \
    }

#endif
