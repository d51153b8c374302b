/* candidates.h - the candidate table. One line adds a candidate:

     EACH (id, "job", "name", "bands", items, call, flops, reads, writes)    calls once for each item k, output to `out`
     BATCH(id, "job", "name", "bands", items, call, flops, reads, writes)    calls once for all `items` items

   `call` may use: n (bands), items, k (EACH only), DIR(k) (a prt_vec3), DIRS (prt_vec3[items]), X Y Z (the same as three
   arrays), F and G (coefficients, three planes apart by n^2), ROWS (rows of coefficients), IMAGE and CUBE, OUT.
   `items`, `flops`, `reads` and `writes` are expressions in n, for one item; reads and writes count prt_reals.
   A multiply-add is two flops. */

/* Room for the output of so many items with n^2 reals each: 1024 up to 16 bands, fewer beyond. */
#define ITEMS (n <= 16 ? 1024 : n <= 32 ? 256 : 64)
#define ALL "1-10,16,32,64"
#define LOW "1-10"

/* Evaluation: what codegen counted in each kernel, and beyond the kernels the recurrence: three operations a step and two
   products with the phasor for each pair (l,m), six for each turn of the phasor. */
#define RECURRENCE_FLOPS (1.5 * n * (n - 1) + 1.0 * n * n + 6.0 * (n - 1))
#define EVAL_FLOPS (n < BENCH_KERNELS ? bench_kernel_flops[n] : RECURRENCE_FLOPS)

/* >>sh */
EACH (eval,         "eval",     "prt_sh_eval",          ALL, ITEMS, prt_sh_eval(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
EACH (eval_generic, "eval",     "recurrence, any band", ALL, ITEMS, prt__sh_recurrence(n, DIR(k), NULL, OUT, 1), RECURRENCE_FLOPS, 3, n * n)
EACH (eval_textbook, "eval",    "textbook K P",         "1-10,16", 64, textbook_sh(n, DIR(k), OUT), 0, 3, n * n)
BATCH(eval_n,       "eval_n",   "prt_sh_eval_n",        ALL, ITEMS, prt_sh_eval_n(n, items, DIRS, OUT), EVAL_FLOPS, 3, n * n)
BATCH(eval_soa,     "eval_soa", "prt_sh_eval_soa",      ALL, ITEMS, prt_sh_eval_soa(n, items, X, Y, Z, OUT, (size_t)items), EVAL_FLOPS, 3, n * n)
BATCH(eval_soa_pad, "eval_soa", "prt_sh_eval_soa, stride + 32", "1-10,16", ITEMS, prt_sh_eval_soa(n, items, X, Y, Z, OUT, (size_t)items + 32), EVAL_FLOPS, 3, n * n)
EACH (at,           "at",       "prt_sh_at",            ALL, ITEMS, OUT[0] = prt_sh_at(n, F, DIR(k)), EVAL_FLOPS + 2.0 * n * n, 3 + n * n, 1)
EACH (dot,          "dot",      "prt_sh_dot",           ALL, 64,    OUT[0] = prt_sh_dot(n, F, G), 2.0 * n * n, 2 * n * n, 1)

/* >>shade */
BATCH(diffuse_n,    "diffuse_n", "prt_shade_diffuse_n", LOW, 1024,  prt_shade_diffuse_n(n, items, ROWS, F, (prt_rgb *)OUT), 6.0 * n * n, n * n, 3)
