/* candidates.h - the candidate table. One line adds a candidate:

     EACH (id, "job", "name", "bands", items, call, flops, reads, writes)    calls once for each item k, output to `out`
     BATCH(id, "job", "name", "bands", items, call, flops, reads, writes)    calls once for all `items` items

   `call` may use: n (bands), items, k (EACH only), DIR(k) (a prt_vec3), DIRS (prt_vec3[items]), X Y Z (the same as three
   arrays), F and G (coefficients, three planes apart by n^2), ROWS (rows of coefficients), IMAGE and CUBE, ROTATION,
   BLOCKS, OUT.
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

/* >>project */
#define TEXELS (BENCH_IMAGE_WIDTH * BENCH_IMAGE_HEIGHT)
#define CUBE_TEXELS (6 * BENCH_CUBE_SIZE * BENCH_CUBE_SIZE)
EACH (add_sample,   "add_sample", "prt_sh_add_sample",  LOW, 1024,  prt_sh_add_sample(n, DIR(k), (prt_real)1e-6, OUT), EVAL_FLOPS + 2.0 * n * n, 3 + n * n, n * n)
EACH (delta,        "delta",    "prt_sh_delta",         LOW, 1024,  prt_sh_delta(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
EACH (cone,         "cone",     "prt_sh_cone",          LOW, 1024,  prt_sh_cone(n, DIR(k), (prt_real)0.3, OUT), 0, 3, n * n)
EACH (sphere,       "sphere",   "prt_sh_sphere",        LOW, 1024,  prt_sh_sphere(n, DIR(k), (prt_real)0.3, OUT), 0, 3, n * n)
EACH (lobe,         "cosine_lobe", "prt_sh_cosine_lobe", LOW, 1024, prt_sh_cosine_lobe(n, DIR(k), OUT), 0, 3, n * n)
EACH (hemisphere,   "hemisphere", "prt_sh_hemisphere",  LOW, 1024,  prt_sh_hemisphere(n, DIR(k), 1, 0, OUT), 0, 3, n * n)
BATCH(equirect,     "equirect", "prt_sh_project_equirect_rgb", LOW, TEXELS, prt_sh_project_equirect_rgb(n, BENCH_IMAGE_WIDTH, BENCH_IMAGE_HEIGHT, IMAGE, OUT), 0, 3, 0)
BATCH(cubemap,      "cubemap",  "prt_sh_project_cubemap_rgb", LOW, CUBE_TEXELS, prt_sh_project_cubemap_rgb(n, BENCH_CUBE_SIZE, CUBE, OUT), 0, 3, 0)
EACH (convolve,     "convolve", "prt_sh_convolve",      LOW, 64,    prt_sh_convolve(n, F, G, OUT), 1.0 * n * n + 2 * n, n * n + n, n * n)
EACH (irradiance,   "irradiance", "prt_sh_irradiance",  LOW, 64,    prt_sh_irradiance(n, F, OUT), 1.0 * n * n + n, n * n, n * n)

/* >>convert */
EACH (convert,      "convert",  "prt_sh_convert",       LOW, 64,    prt_sh_convert(n, PRT_CONVENTION_SPLAT, PRT_CONVENTION_PRT, F, OUT), 0, n * n, n * n)
EACH (axes_xy,      "axes",     "prt_sh_convert_axes, z stays", ALL, 64, prt_sh_convert_axes(n, PRT_AXES_UNREAL, PRT_AXES_BLENDER, F, OUT), 0, n * n, n * n)
EACH (axes_yz,      "axes",     "prt_sh_convert_axes, y up", ALL, 64, prt_sh_convert_axes(n, PRT_AXES_OPENGL, PRT_AXES_BLENDER, F, OUT), 0, n * n, n * n)

/* >>window */
EACH (window,       "window",   "prt_sh_window, Hann",  LOW, 64,    prt_sh_window(n, PRT_WINDOW_HANN, n, F, OUT), 0, n * n, n * n)

/* >>rotate: ROTATION is a fixed turn, BLOCKS its matrices, built before the clock runs */
#define BLOCK_FLOPS (2.0 * n * (4 * n * n - 1) / 3)
EACH (rotation,     "rotation", "prt_sh_rotation",      ALL, 16,    prt_sh_rotation(n, ROTATION, OUT), 0, 9, n * (4 * n * n - 1) / 3)
EACH (rotate_by,    "rotate_by", "prt_sh_rotate_by",    ALL, 16,    prt_sh_rotate_by(n, BLOCKS, F, OUT), BLOCK_FLOPS, n * n, n * n)
BATCH(rotate_by_n,  "rotate_by_n", "prt_sh_rotate_by_n", ALL, ITEMS, prt_sh_rotate_by_n(n, BLOCKS, items, ROWS, OUT), BLOCK_FLOPS, n * n, n * n)
BATCH(rotate_by_soa, "rotate_by_n", "prt_sh_rotate_by_soa", ALL, ITEMS, prt_sh_rotate_by_soa(n, BLOCKS, items, ROWS, OUT, (size_t)items), BLOCK_FLOPS, n * n, n * n)
EACH (rotate,       "rotate",   "prt_sh_rotate",        ALL, 16,    prt_sh_rotate(n, ROTATION, F, OUT), 0, n * n + 9, n * n)
EACH (rotate_z,     "rotate_z", "prt_sh_rotate_z",      LOW, 64,    prt_sh_rotate_z(n, (prt_real)0.7, F, OUT), 0, n * n, n * n)
EACH (zonal_to,     "zonal_to", "prt_sh_zonal_to",      LOW, 1024,  prt_sh_zonal_to(n, F, DIR(k), OUT), EVAL_FLOPS + 1.0 * n * n + n, n + 3, n * n)

/* >>product: operations are those of the terms of the sum, about 0.4 n^5, in multiply-adds; the functions need fewer */
#define TERM_FLOPS (0.8 * n * n * n * n * n)
#define OTHER (ROWS + items)
EACH (product,      "product",  "prt_sh_product",       ALL, 64,    prt_sh_product(n, F, G, OUT), TERM_FLOPS, 2 * n * n, n * n)
EACH (product_grid, "product",  "grid at any band",     ALL, 64,    prt__grid_product(n, F, G, OUT), TERM_FLOPS, 2 * n * n, n * n)
EACH (square,       "product",  "prt_sh_square",        ALL, 64,    prt_sh_square(n, F, OUT), TERM_FLOPS, n * n, n * n)
EACH (zonal,        "product",  "prt_sh_product_zonal", ALL, 64,    prt_sh_product_zonal(n, F, G, OUT), 0, n * n + n, n * n)
BATCH(product_soa,  "product_soa", "prt_sh_product_soa", LOW, 256,  prt_sh_product_soa(n, items, ROWS, OTHER, OUT, (size_t)items), TERM_FLOPS, 2 * n * n, n * n)
EACH (mask_hann,    "mask",     "prt_sh_mask, Hann",    LOW, 64,    prt_sh_mask(n, PRT_WINDOW_HANN, F, G, OUT), 0, 2 * n * n, n * n)
EACH (mask_filter,  "mask",     "prt_sh_mask_filter, positive", LOW, 64, prt_sh_mask_filter(n, PRT_WINDOW_POSITIVE, F, G, OUT), 0, 2 * n * n, n * n)
EACH (exp,          "exp",      "prt_sh_exp",           LOW, 64,    prt_sh_exp(n, F, OUT), 0, n * n, n * n)
EACH (exp_linear,   "exp",      "prt_sh_exp_linear",    LOW, 64,    prt_sh_exp_linear(n, F, OUT), 4.0 * n * n, n * n, n * n)
EACH (log,          "log",      "prt_sh_log, 12 steps", LOW, 64,    prt_sh_log(n, 12, (prt_real)0.02, F, OUT), 0, n * n, n * n)
EACH (dering,       "dering",   "prt_sh_dering",        LOW, 16,    prt_sh_dering(n, F, OUT, NULL), 0, n * n, n * n)

/* >>ch: the same recurrence with other factors */
EACH (ch_eval,      "ch_eval",  "prt_ch_eval",          ALL, ITEMS, prt_ch_eval(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_eval_n,    "ch_eval_n", "prt_ch_eval_n",       LOW, ITEMS, prt_ch_eval_n(n, items, DIRS, OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_eval_soa,  "ch_eval_soa", "prt_ch_eval_soa",   "1-10,12,16", ITEMS, prt_ch_eval_soa(n, items, X, Y, Z, OUT, (size_t)items), EVAL_FLOPS, 3, n * n)
EACH (ch_sh_eval,   "ch_eval",  "prt_sh_eval, to compare", ALL, ITEMS, prt_sh_eval(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_sh_eval_n, "ch_eval_n", "prt_sh_eval_n, to compare", LOW, ITEMS, prt_sh_eval_n(n, items, DIRS, OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_sh_soa,    "ch_eval_soa", "prt_sh_eval_soa, to compare", "1-10,12,16", ITEMS, prt_sh_eval_soa(n, items, X, Y, Z, OUT, (size_t)items), EVAL_FLOPS, 3, n * n)
EACH (ch_at,        "ch_at",    "prt_ch_at",            LOW, ITEMS, OUT[0] = prt_ch_at(n, F, DIR(k)), EVAL_FLOPS + 2.0 * n * n, 3 + n * n, 1)
EACH (ch_from_sh,   "ch_from_sh", "prt_ch_from_sh",     LOW, 64,    prt_ch_from_sh(n, F, OUT), 0, n * n, n * n)
EACH (sh_from_ch,   "sh_from_ch", "prt_sh_from_ch",     LOW, 64,    prt_sh_from_ch(n, F, OUT), 0, n * n, n * n)
EACH (ch_rotate,    "ch_rotate", "prt_ch_rotate",       LOW, 16,    prt_ch_rotate(n, ROTATION, F, OUT), 0, n * n + 9, n * n)
EACH (ch_product,   "ch_product", "prt_ch_product",     LOW, 16,    prt_ch_product(n, F, G, OUT), 0, 2 * n * n, n * n)
EACH (ch_dot,       "ch_dot",   "prt_ch_dot",           LOW, 64,    OUT[0] = prt_ch_dot(n, F, G), 0, 2 * n * n, 1)

/* >>shade */
BATCH(diffuse_n,    "diffuse_n", "prt_shade_diffuse_n", LOW, 1024,  prt_shade_diffuse_n(n, items, ROWS, F, (prt_rgb *)OUT), 6.0 * n * n, n * n, 3)

/* >>fiv: an item is a receiver and an occluder; a lookup reads eight samples of nine. `bands` do not matter */
#define FIV_READS (8 * 9)
BATCH(fiv_shade_1,  "fiv_shade 1 occluder", "prt_fiv_shade_n", "0", FIV_RECEIVERS, FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 1, s->occluders, 0, (prt_rgb *)OUT), 0, FIV_READS + 9, 3)
BATCH(fiv_each_1,   "fiv_shade 1 occluder", "prt_fiv_shade, one by one", "0", FIV_RECEIVERS, FIV; fiv_each(s, 1, (prt_rgb *)OUT), 0, FIV_READS + 9, 3)
BATCH(fiv_touch,    "fiv_shade 1 occluder", "the eight samples alone", "0", FIV_RECEIVERS, FIV; fiv_touch(s, OUT), 0, FIV_READS, 0)
BATCH(fiv_shade_10, "fiv_shade 10 occluders", "prt_fiv_shade_n", "0", FIV_RECEIVERS * 10, FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 10, s->occluders, 0, (prt_rgb *)OUT), 0, FIV_READS, 0.3)
BATCH(fiv_plain_10, "fiv_shade 10 occluders", "without overlaps", "0", FIV_RECEIVERS * 10, FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 10, s->occluders, PRT_FIV_NO_OVERLAP, (prt_rgb *)OUT), 0, FIV_READS, 0.3)
BATCH(fiv_each_10,  "fiv_shade 10 occluders", "prt_fiv_shade, one by one", "0", FIV_RECEIVERS * 10, FIV; fiv_each(s, 10, (prt_rgb *)OUT), 0, FIV_READS, 0.3)
BATCH(fiv_shade_60, "fiv_shade 60 occluders", "prt_fiv_shade_n", "0", FIV_RECEIVERS * 60, FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 60, s->occluders, 0, (prt_rgb *)OUT), 0, FIV_READS, 0.05)
BATCH(fiv_plain_60, "fiv_shade 60 occluders", "without overlaps", "0", FIV_RECEIVERS * 60, FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 60, s->occluders, PRT_FIV_NO_OVERLAP, (prt_rgb *)OUT), 0, FIV_READS, 0.05)
EACH (fiv_lookup,   "fiv_lookup", "prt_fiv_lookup",     "0", FIV_RECEIVERS, FIV; prt_fiv_lookup(&s->table, fiv_between(s, k, 0), (prt_fiv *)OUT), 0, FIV_READS, 9)
EACH (fiv_half,     "fiv_lookup", "prt_fiv_packed_lookup, 16 bits", "0", FIV_RECEIVERS, FIV; prt_fiv_packed_lookup(&s->packed16, fiv_between(s, k, 0), (prt_fiv *)OUT), 0, FIV_READS * 2 / sizeof(prt_real), 9)
EACH (fiv_byte,     "fiv_lookup", "prt_fiv_packed_lookup, 8 bits", "0", FIV_RECEIVERS, FIV; prt_fiv_packed_lookup(&s->packed8, fiv_between(s, k, 0), (prt_fiv *)OUT), 0, FIV_READS / sizeof(prt_real), 9)
EACH (fiv_transfer, "fiv_lookup", "prt_fiv_transfer_lookup, 4 bands", "0", FIV_RECEIVERS, FIV; prt_fiv_transfer_lookup(&s->transfer, NULL, s->vectors, fiv_between(s, k, 0), (prt_fiv *)OUT), 0, 8 * FIV_HIDDEN, 9)

/* >>vo: "bands" is the number of lights; five opaque occluders a point. Operations are the additions, multiplications and
   divisions of the vector code: for each point, occluder, light, and both; comparisons, masks and exponents are not counted */
#define LIT "1,2,4,8,16,32"
#define VO_FLOPS(occluder, both) (40.0 + (occluder) * VO_SEEN + 103.0 * n + (both) * (double)n * VO_SEEN)
#define VO_EYE (VO->lights[0].position)
#define VO_RGB ((prt_rgb *)OUT)
EACH (vo_dd_one,    "vo_dd",    "prt_vo_shade, point after point", LIT, VO_POINTS, prt_vo_shade(&VO->dd, VO->points + k, VO_EYE, VO_SEEN, VO->occluders + k * VO_SEEN, n, VO->lights, VO_RGB), VO_FLOPS(60, 65), 16 + 26 * VO_SEEN, 3)
BATCH(vo_dd_n,      "vo_dd",    "prt_vo_shade_n",       LIT, VO_POINTS, prt_vo_shade_n(&VO->dd, items, VO->points, VO_EYE, VO->first, VO->occluders, n, VO->lights, VO_RGB), VO_FLOPS(60, 65), 16 + 26 * VO_SEEN, 3)
BATCH(vo_dd_packed, "vo_dd",    "prt_vo_shade_packed_diffuse_n", LIT, VO_POINTS, prt_vo_shade_packed_diffuse_n(&VO->dd, 1, items, VO->points, VO_EYE, VO->first, VO->packed_diffuse, n, VO->lights, VO_RGB), VO_FLOPS(130, 65), 16 + 20.0 / sizeof(prt_real) * VO_SEEN, 3)
EACH (vo_all_one,   "vo_all",   "prt_vo_shade, point after point", LIT, VO_POINTS, prt_vo_shade(&VO->all, VO->points + k, VO_EYE, VO_SEEN, VO->occluders + k * VO_SEEN, n, VO->lights, VO_RGB), VO_FLOPS(155, 97), 16 + 26 * VO_SEEN, 3)
BATCH(vo_all_n,     "vo_all",   "prt_vo_shade_n",       LIT, VO_POINTS, prt_vo_shade_n(&VO->all, items, VO->points, VO_EYE, VO->first, VO->occluders, n, VO->lights, VO_RGB), VO_FLOPS(155, 97), 16 + 26 * VO_SEEN, 3)
BATCH(vo_all_packed, "vo_all",  "prt_vo_shade_packed_n", LIT, VO_POINTS, prt_vo_shade_packed_n(&VO->all, 1, items, VO->points, VO_EYE, VO->first, VO->packed, n, VO->lights, VO_RGB), VO_FLOPS(290, 97), 16 + 40.0 / sizeof(prt_real) * VO_SEEN, 3)
