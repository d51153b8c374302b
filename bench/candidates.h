/* candidates.h - the candidate table. One line adds a candidate:

     EACH (id, "job", "name", "bands", items, call, flops, reads, writes)    calls once for each item k, output to `out`
     BATCH(id, "job", "name", "bands", items, call, flops, reads, writes)    calls once for all `items` items

   `call` may use: n (bands), items, k (EACH only), DIR(k) (a prt_vec3), DIRS (prt_vec3[items]), X Y Z (the same as
   three arrays), F and G (coefficients, three planes apart by n^2), ROWS (rows of coefficients), IMAGE and CUBE,
   ROTATION, BLOCKS, MATRIX (of products with F, to 10 bands), PACKED(storage) (transfer, to 10 bands), OUT.
   `items`, `flops`, `reads` and `writes` are expressions in n, for one item; reads and writes count prt_reals.
   A multiply-add is two flops. Every public function of prt.h has a row; bench/missing.sh names those without. */

/* Room for the output of so many items with n^2 reals each: 1024 up to 16 bands, fewer beyond. */
#define ITEMS (n <= 16 ? 1024 : n <= 32 ? 256 : 64)
#define FEW (n <= 10 ? 64 : 4)
#define ALL "1-10,16,32,64"
#define LOW "1-10"

/* Evaluation: what codegen counted in each kernel, and beyond the kernels the recurrence: three operations a step and
   two products with the phasor for each pair (l,m), six for each turn of the phasor. */
#define RECURRENCE_FLOPS (1.5 * n * (n - 1) + 1.0 * n * n + 6.0 * (n - 1))
#define EVAL_FLOPS (n < BENCH_KERNELS ? bench_kernel_flops[n] : RECURRENCE_FLOPS)

/* >>sh */
EACH (eval,         "eval",     "prt_sh_eval",          ALL, ITEMS, prt_sh_eval(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
EACH (eval_generic, "eval",     "recurrence, any band", ALL, ITEMS,
      prt__sh_recurrence(n, DIR(k), NULL, OUT, 1), RECURRENCE_FLOPS, 3, n * n)
EACH (eval_textbook, "eval",    "textbook K P",         "1-10,16", 64, textbook_sh(n, DIR(k), OUT), 0, 3, n * n)
BATCH(eval_n,       "eval_n",   "prt_sh_eval_n",        ALL, ITEMS,
      prt_sh_eval_n(n, items, DIRS, OUT), EVAL_FLOPS, 3, n * n)
BATCH(eval_soa,     "eval_soa", "prt_sh_eval_soa",      ALL, ITEMS,
      prt_sh_eval_soa(n, items, X, Y, Z, OUT, (size_t)items), EVAL_FLOPS, 3, n * n)
BATCH(eval_soa_pad, "eval_soa", "prt_sh_eval_soa, stride + 32", "1-10,16", ITEMS,
      prt_sh_eval_soa(n, items, X, Y, Z, OUT, (size_t)items + 32), EVAL_FLOPS, 3, n * n)
EACH (at,           "at",       "prt_sh_at",            ALL, ITEMS,
      OUT[0] = prt_sh_at(n, F, DIR(k)), EVAL_FLOPS + 2.0 * n * n, 3 + n * n, 1)
EACH (dot,          "dot",      "prt_sh_dot",           ALL, 64,
      OUT[0] = prt_sh_dot(n, F, G), 2.0 * n * n, 2 * n * n, 1)

/* >>project */
#define TEXELS (BENCH_IMAGE_WIDTH * BENCH_IMAGE_HEIGHT)
#define CUBE_TEXELS (6 * BENCH_CUBE_SIZE * BENCH_CUBE_SIZE)
EACH (add_sample,   "add_sample", "prt_sh_add_sample",  LOW, 1024,
      prt_sh_add_sample(n, DIR(k), (prt_real)1e-6, OUT), EVAL_FLOPS + 2.0 * n * n, 3 + n * n, n * n)
EACH (delta,        "delta",    "prt_sh_delta",         LOW, 1024,  prt_sh_delta(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
EACH (cone,         "cone",     "prt_sh_cone",          LOW, 1024,
      prt_sh_cone(n, DIR(k), (prt_real)0.3, OUT), 0, 3, n * n)
EACH (sphere,       "sphere",   "prt_sh_sphere",        LOW, 1024,
      prt_sh_sphere(n, DIR(k), (prt_real)0.3, OUT), 0, 3, n * n)
EACH (lobe,         "cosine_lobe", "prt_sh_cosine_lobe", LOW, 1024, prt_sh_cosine_lobe(n, DIR(k), OUT), 0, 3, n * n)
EACH (hemisphere,   "hemisphere", "prt_sh_hemisphere",  LOW, 1024,
      prt_sh_hemisphere(n, DIR(k), 1, 0, OUT), 0, 3, n * n)
BATCH(equirect,     "equirect", "prt_sh_project_equirect_rgb", LOW, TEXELS,
      prt_sh_project_equirect_rgb(n, BENCH_IMAGE_WIDTH, BENCH_IMAGE_HEIGHT, IMAGE, OUT), 0, 3, 0)
BATCH(cubemap,      "cubemap",  "prt_sh_project_cubemap_rgb", LOW, CUBE_TEXELS,
      prt_sh_project_cubemap_rgb(n, BENCH_CUBE_SIZE, CUBE, OUT), 0, 3, 0)
EACH (convolve,     "convolve", "prt_sh_convolve",      LOW, 64,
      prt_sh_convolve(n, F, G, OUT), 1.0 * n * n + 2 * n, n * n + n, n * n)
EACH (irradiance,   "irradiance", "prt_sh_irradiance",  LOW, 64,
      prt_sh_irradiance(n, F, OUT), 1.0 * n * n + n, n * n, n * n)

/* >>convert */
EACH (convert,      "convert",  "prt_sh_convert",       LOW, 64,
      prt_sh_convert(n, PRT_CONVENTION_SPLAT, PRT_CONVENTION_PRT, F, OUT), 0, n * n, n * n)
EACH (axes_xy,      "axes",     "prt_sh_convert_axes, z stays", ALL, FEW,
      prt_sh_convert_axes(n, PRT_AXES_UNREAL, PRT_AXES_BLENDER, F, OUT), 0, n * n, n * n)
EACH (axes_yz,      "axes",     "prt_sh_convert_axes, y up", ALL, FEW,
      prt_sh_convert_axes(n, PRT_AXES_OPENGL, PRT_AXES_BLENDER, F, OUT), 0, n * n, n * n)
EACH (map_axes,     "axes",     "prt_sh_map_axes, y up", ALL, FEW, prt_sh_map_axes(n, y_up, F, OUT), 0, n * n, n * n)
EACH (axes_map,     "axes_map", "prt_axes_map",         "0", 64,
      prt_axes_map(PRT_AXES_OPENGL, PRT_AXES_BLENDER, (int *)data->out), 0, 0, 0)
EACH (map_vector,   "axes_map", "prt_map_axes, a vector", "0", 1024,
      *(prt_vec3 *)OUT = prt_map_axes(y_up, DIR(k)), 0, 3, 3)
EACH (irr_pack,     "shader_constants", "prt_sh_pack_irradiance", "3", 64,
      prt_sh_pack_irradiance(3, F, OUT), 42, 27, 28)
EACH (irr_unpack,   "shader_constants", "prt_sh_unpack_irradiance", "3", 64,
      prt_sh_unpack_irradiance(F, OUT), 42, 28, 27)

/* >>window */
EACH (window,       "window",   "prt_sh_window, Hann",  LOW, 64,
      prt_sh_window(n, PRT_WINDOW_HANN, n, F, OUT), 0, n * n, n * n)
EACH (weight,       "window_weight", "prt_window_weight, positive", "2-10,16,32", 64,
      OUT[0] = prt_window_weight(PRT_WINDOW_POSITIVE, k % n, n), 0, 0, 1)
EACH (weight_hann,  "window_weight", "prt_window_weight, Hann", "2-10,16,32", 64,
      OUT[0] = prt_window_weight(PRT_WINDOW_HANN, k % n, n), 0, 0, 1)
EACH (minimum,      "minimum",  "prt_sh_minimum",       LOW, 4,     OUT[0] = prt_sh_minimum(n, F, NULL), 0, n * n, 1)

/* >>rotate: ROTATION is a fixed turn, BLOCKS its matrices, built before the clock runs */
#define BLOCK_FLOPS (2.0 * n * (4 * n * n - 1) / 3)
EACH (quaternion,   "quaternion", "prt_rotation_from_quaternion", "0", 64,
      prt_rotation_from_quaternion(quarter, OUT), 30, 4, 9)
EACH (block_count,  "rotation", "prt_sh_rotation_count", "5", 64,
      *(size_t *)data->out = prt_sh_rotation_count(n), 0, 0, 2)
EACH (rotation,     "rotation", "prt_sh_rotation",      ALL, 16,
      prt_sh_rotation(n, ROTATION, OUT), 0, 9, n * (4 * n * n - 1) / 3)
EACH (rotate_by,    "rotate_by", "prt_sh_rotate_by",    ALL, 16,
      prt_sh_rotate_by(n, BLOCKS, F, OUT), BLOCK_FLOPS, n * n, n * n)
BATCH(rotate_by_n,  "rotate_by_n", "prt_sh_rotate_by_n", ALL, ITEMS,
      prt_sh_rotate_by_n(n, BLOCKS, items, ROWS, OUT), BLOCK_FLOPS, n * n, n * n)
BATCH(rotate_by_soa, "rotate_by_n", "prt_sh_rotate_by_soa", ALL, ITEMS,
      prt_sh_rotate_by_soa(n, BLOCKS, items, ROWS, OUT, (size_t)items), BLOCK_FLOPS, n * n, n * n)
BATCH(rotate_by_rgb, "rotate_by_n", "prt_sh_rotate_by_n_rgb, a plane", ALL, (ITEMS / 4 * 3),
      prt_sh_rotate_by_n_rgb(n, BLOCKS, items / 3, ROWS, OUT), BLOCK_FLOPS, n * n, n * n)
EACH (rotate,       "rotate",   "prt_sh_rotate",        ALL, 16,
      prt_sh_rotate(n, ROTATION, F, OUT), 0, n * n + 9, n * n)
EACH (rotate_mirror, "rotate",  "prt_sh_rotate, a reflection", LOW, 16,
      prt_sh_rotate(n, mirror, F, OUT), 0, n * n + 9, n * n)
EACH (rotate_z,     "rotate_z", "prt_sh_rotate_z",      LOW, 64,
      prt_sh_rotate_z(n, (prt_real)0.7, F, OUT), 0, n * n, n * n)
EACH (zonal_to,     "zonal_to", "prt_sh_zonal_to",      LOW, 1024,
      prt_sh_zonal_to(n, F, DIR(k), OUT), EVAL_FLOPS + 1.0 * n * n + n, n + 3, n * n)

/* >>product: operations are those of the terms of the sum, about 0.4 n^5, in multiply-adds; the functions need fewer */
#define TERM_FLOPS (0.8 * n * n * n * n * n)
#define OTHER (ROWS + items)
EACH (triple,       "triple",   "prt_sh_triple",        "2-10,16,32,64", 16,
      *(double *)data->out = prt_sh_triple(n - 1, k % n, n / 2, 0, n - 1, k % n), 0, 0, 1)
EACH (product,      "product",  "prt_sh_product",       ALL, FEW,
      prt_sh_product(n, F, G, OUT), TERM_FLOPS, 2 * n * n, n * n)
EACH (product_grid, "product",  "loop for any bands",   ALL, FEW,
      prt__grid_product(n, F, G, OUT), TERM_FLOPS, 2 * n * n, n * n)
EACH (square,       "product",  "prt_sh_square",        ALL, FEW,    prt_sh_square(n, F, OUT), TERM_FLOPS, n * n, n * n)
EACH (zonal,        "product",  "prt_sh_product_zonal", ALL, FEW,
      prt_sh_product_zonal(n, F, G, OUT), 0, n * n + n, n * n)
BATCH(product_soa,  "product_soa", "prt_sh_product_soa", LOW, 256,
      prt_sh_product_soa(n, items, ROWS, OTHER, OUT, (size_t)items), TERM_FLOPS, 2 * n * n, n * n)
EACH (product_matrix, "product_matrix", "prt_sh_product_matrix", LOW, 4,
      prt_sh_product_matrix(n, F, OUT), 0, n * n, n * n * n * n)
BATCH(product_by_n, "product_by", "prt_sh_product_by_n", LOW, 256,
      prt_sh_product_by_n(n, MATRIX, items, ROWS, OUT), 2.0 * n * n * n * n, n * n, n * n)
EACH (product_by,   "product_by", "prt_sh_product_by",  LOW, 64,
      prt_sh_product_by(n, MATRIX, F, OUT), 2.0 * n * n * n * n, n * n, n * n)
EACH (mask_hann,    "mask",     "prt_sh_mask, Hann",    LOW, 64,
      prt_sh_mask(n, PRT_WINDOW_HANN, F, G, OUT), 0, 2 * n * n, n * n)
EACH (mask_filter,  "mask",     "prt_sh_mask_filter, positive", LOW, 64,
      prt_sh_mask_filter(n, PRT_WINDOW_POSITIVE, F, G, OUT), 0, 2 * n * n, n * n)
EACH (exp,          "exp",      "prt_sh_exp",           LOW, 64,    prt_sh_exp(n, F, OUT), 0, n * n, n * n)
EACH (exp_linear,   "exp",      "prt_sh_exp_linear",    LOW, 64,
      prt_sh_exp_linear(n, F, OUT), 4.0 * n * n, n * n, n * n)
EACH (log,          "log",      "prt_sh_log, 12 steps", LOW, 64,
      prt_sh_log(n, 12, (prt_real)0.02, F, OUT), 0, n * n, n * n)
EACH (dering,       "dering",   "prt_sh_dering",        LOW, 16,    prt_sh_dering(n, F, OUT, NULL), 0, n * n, n * n)

/* >>ch: the same recurrence with other factors */
EACH (ch_eval,      "ch_eval",  "prt_ch_eval",          ALL, ITEMS, prt_ch_eval(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_eval_n,    "ch_eval_n", "prt_ch_eval_n",       LOW, ITEMS,
      prt_ch_eval_n(n, items, DIRS, OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_eval_soa,  "ch_eval_soa", "prt_ch_eval_soa",   "1-10,12,16", ITEMS,
      prt_ch_eval_soa(n, items, X, Y, Z, OUT, (size_t)items), EVAL_FLOPS, 3, n * n)
EACH (ch_sh_eval,   "ch_eval",  "prt_sh_eval, to compare", ALL, ITEMS,
      prt_sh_eval(n, DIR(k), OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_sh_eval_n, "ch_eval_n", "prt_sh_eval_n, to compare", LOW, ITEMS,
      prt_sh_eval_n(n, items, DIRS, OUT), EVAL_FLOPS, 3, n * n)
BATCH(ch_sh_soa,    "ch_eval_soa", "prt_sh_eval_soa, to compare", "1-10,12,16", ITEMS,
      prt_sh_eval_soa(n, items, X, Y, Z, OUT, (size_t)items), EVAL_FLOPS, 3, n * n)
EACH (ch_at,        "ch_at",    "prt_ch_at",            LOW, ITEMS,
      OUT[0] = prt_ch_at(n, F, DIR(k)), EVAL_FLOPS + 2.0 * n * n, 3 + n * n, 1)
EACH (ch_from_sh,   "ch_from_sh", "prt_ch_from_sh",     LOW, 64,    prt_ch_from_sh(n, F, OUT), 0, n * n, n * n)
EACH (sh_from_ch,   "sh_from_ch", "prt_sh_from_ch",     LOW, 64,    prt_sh_from_ch(n, F, OUT), 0, n * n, n * n)
EACH (ch_moments,   "ch_moments", "prt_ch_from_moments", LOW, 64,   prt_ch_from_moments(n, F, OUT), 0, n * n, n * n)
EACH (ch_to_moments, "ch_moments", "prt_ch_to_moments", LOW, 64,    prt_ch_to_moments(n, F, OUT), 0, n * n, n * n)
EACH (ch_norm,      "ch_norm",  "prt_ch_norm",          "2-10,16,32,64", 64,
      *(double *)data->out = prt_ch_norm(n - 1, k % n), 0, 0, 1)
EACH (ch_rotate,    "ch_rotate", "prt_ch_rotate",       LOW, 16,
      prt_ch_rotate(n, ROTATION, F, OUT), 0, n * n + 9, n * n)
EACH (ch_product,   "ch_product", "prt_ch_product",     LOW, 16,    prt_ch_product(n, F, G, OUT), 0, 2 * n * n, n * n)
EACH (ch_dot,       "ch_dot",   "prt_ch_dot",           LOW, 64,    OUT[0] = prt_ch_dot(n, F, G), 0, 2 * n * n, 1)

/* >>shade */
BATCH(diffuse_n,    "diffuse_n", "prt_shade_diffuse_n", LOW, 1024,
      prt_shade_diffuse_n(n, items, ROWS, F, (prt_rgb *)OUT), 6.0 * n * n, n * n, 3)
EACH (diffuse,      "diffuse_n", "prt_shade_diffuse, point after point", LOW, 1024,
      prt_shade_diffuse(n, ROWS + k * n * n, F, (prt_rgb *)OUT), 6.0 * n * n, n * n, 3)
BATCH(diffuse_rgb, "diffuse_n", "prt_shade_diffuse_rgb_n", LOW, 1024,
      prt_shade_diffuse_rgb_n(n, items, ROWS, F, (prt_rgb *)OUT), 6.0 * n * n, 3.0 * n * n, 3)
EACH (diffuse_rgb1, "diffuse_n", "prt_shade_diffuse_rgb, point after point", LOW, 1024,
      prt_shade_diffuse_rgb(n, ROWS + k * 3 * n * n, F, (prt_rgb *)OUT), 6.0 * n * n, 3.0 * n * n, 3)
BATCH(packed_half, "diffuse_n", "prt_shade_packed_n, half", LOW, 1024,
      prt_shade_packed_n(&PACKED(HALF), 0, items, F, (prt_rgb *)OUT), 6.0 * n * n, 2.0 * n * n / sizeof(prt_real), 3)
BATCH(packed_16,   "diffuse_n", "prt_shade_packed_n, 16 bits", LOW, 1024,
      prt_shade_packed_n(&PACKED(16), 0, items, F, (prt_rgb *)OUT), 6.0 * n * n, 2.0 * n * n / sizeof(prt_real), 3)
BATCH(packed_8,    "diffuse_n", "prt_shade_packed_n, 8 bits", LOW, 1024,
      prt_shade_packed_n(&PACKED(8), 0, items, F, (prt_rgb *)OUT), 6.0 * n * n, 1.0 * n * n / sizeof(prt_real), 3)
BATCH(unpack_8,    "unpack", "prt_transfer_unpack, 8 bits", LOW, 1024,
      prt_transfer_unpack(&PACKED(8), 0, items, OUT), 2.0 * n * n, 1.0 * n * n / sizeof(prt_real), n * n)
BATCH(unpack_half, "unpack", "prt_transfer_unpack, half", LOW, 1024,
      prt_transfer_unpack(&PACKED(HALF), 0, items, OUT), 0, 2.0 * n * n / sizeof(prt_real), n * n)
BATCH(incident_n,   "incident_n", "prt_shade_incident_n", "1-6", (1024 / (n * n)),
      prt_shade_incident_n(n, n, 1, items, ROWS, F, OUT), 6.0 * n * n * n * n, n * n * n * n, 3 * n * n)
EACH (incident,     "incident_n", "prt_shade_incident, point after point", "1-6", (1024 / (n * n)),
      prt_shade_incident(n, n, 1, ROWS + k * n * n * n * n, F, OUT), 6.0 * n * n * n * n, n * n * n * n, 3 * n * n)
BATCH(glossy_n,     "glossy_n", "prt_shade_glossy_n",   LOW, 341,
      prt_shade_glossy_n(n, items, ROWS, G, DIRS, (prt_rgb *)OUT), EVAL_FLOPS + 7.0 * n * n, 3 * n * n, 3)
EACH (glossy,       "glossy_n", "prt_shade_glossy, point after point", LOW, 341,
      prt_shade_glossy(n, ROWS + 3 * k * n * n, G, DIR(k), (prt_rgb *)OUT), EVAL_FLOPS + 7.0 * n * n, 3 * n * n, 3)
EACH (phong,        "phong",    "prt_phong_zonal",      LOW, 64,    prt_phong_zonal(n, 12, OUT), 0, 1, n)
EACH (local_frame,  "local_frame", "prt_local_frame",   "0", 64,    prt_local_frame(DIR(k), OUT), 0, 3, 9)

/* >>fiv: an item is a receiver and an occluder; a lookup reads eight samples of nine. `bands` do not matter */
#define FIV_READS (8 * 9)
BATCH(fiv_shade_1,  "fiv_shade 1 occluder", "prt_fiv_shade_n", "0", FIV_RECEIVERS,
      FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 1, s->occluders, 0, (prt_rgb *)OUT),
      0, FIV_READS + 9, 3)
EACH (fiv_each_1,   "fiv_shade 1 occluder", "prt_fiv_shade, one by one", "0", FIV_RECEIVERS,
      FIV; prt_fiv_shade(s->totals[k], s->positions[k], s->normals[k], 1, s->occluders, 0, (prt_rgb *)OUT), 0,
      FIV_READS + 9, 3)
BATCH(fiv_bodies_p, "fiv_shade 1 occluder", "prt_fiv_shade_bodies_n, plain", "0", FIV_RECEIVERS,
      FIV; prt_fiv_shade_bodies_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 1, s->bodies, 0, (prt_rgb *)OUT),
      0, FIV_READS + 9, 3)
BATCH(fiv_bodies_h, "fiv_shade 1 occluder", "prt_fiv_shade_bodies_n, 16 bits", "0", FIV_RECEIVERS,
      FIV; prt_fiv_shade_bodies_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 1, s->bodies + 1, 0,
      (prt_rgb *)OUT), 0, FIV_READS * 2 / sizeof(prt_real) + 9, 3)
BATCH(fiv_bodies_b, "fiv_shade 1 occluder", "prt_fiv_shade_bodies_n, 8 bits", "0", FIV_RECEIVERS,
      FIV; prt_fiv_shade_bodies_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 1, s->bodies + 2, 0,
      (prt_rgb *)OUT), 0, FIV_READS / sizeof(prt_real) + 9, 3)
BATCH(fiv_bodies_t, "fiv_shade 1 occluder", "prt_fiv_shade_bodies_n, transfer of 4 bands", "0", FIV_RECEIVERS,
      FIV; prt_fiv_shade_bodies_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 1, s->bodies + 3, 0,
      (prt_rgb *)OUT), 0, 8 * FIV_HIDDEN + 9, 3)
BATCH(fiv_touch,    "fiv_shade 1 occluder", "the eight samples alone", "0", FIV_RECEIVERS,
      FIV; fiv_touch(s, OUT), 0, FIV_READS, 0)
BATCH(fiv_shade_10, "fiv_shade 10 occluders", "prt_fiv_shade_n", "0", FIV_RECEIVERS * 10,
      FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 10, s->occluders, 0, (prt_rgb *)OUT),
      0, FIV_READS, 0.3)
BATCH(fiv_plain_10, "fiv_shade 10 occluders", "without overlaps", "0", FIV_RECEIVERS * 10,
      FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 10, s->occluders, PRT_FIV_NO_OVERLAP,
      (prt_rgb *)OUT), 0, FIV_READS, 0.3)
BATCH(fiv_each_10,  "fiv_shade 10 occluders", "prt_fiv_shade, one by one", "0", FIV_RECEIVERS * 10,
      FIV; fiv_each(s, 10, (prt_rgb *)OUT), 0, FIV_READS, 0.3)
BATCH(fiv_shade_60, "fiv_shade 60 occluders", "prt_fiv_shade_n", "0", FIV_RECEIVERS * 60,
      FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 60, s->occluders, 0, (prt_rgb *)OUT),
      0, FIV_READS, 0.05)
BATCH(fiv_plain_60, "fiv_shade 60 occluders", "without overlaps", "0", FIV_RECEIVERS * 60,
      FIV; prt_fiv_shade_n(FIV_RECEIVERS, s->totals, s->positions, s->normals, 60, s->occluders, PRT_FIV_NO_OVERLAP,
      (prt_rgb *)OUT), 0, FIV_READS, 0.05)
EACH (fiv_lookup,   "fiv_lookup", "prt_fiv_lookup",     "0", FIV_RECEIVERS,
      FIV; prt_fiv_lookup(&s->table, fiv_between(s, k, 0), (prt_fiv *)OUT), 0, FIV_READS, 9)
EACH (fiv_half,     "fiv_lookup", "prt_fiv_packed_lookup, 16 bits", "0", FIV_RECEIVERS,
      FIV; prt_fiv_packed_lookup(&s->packed16, fiv_between(s, k, 0), (prt_fiv *)OUT), 0,
      FIV_READS * 2 / sizeof(prt_real), 9)
EACH (fiv_byte,     "fiv_lookup", "prt_fiv_packed_lookup, 8 bits", "0", FIV_RECEIVERS,
      FIV; prt_fiv_packed_lookup(&s->packed8, fiv_between(s, k, 0), (prt_fiv *)OUT), 0, FIV_READS / sizeof(prt_real),
      9)
EACH (fiv_transfer, "fiv_lookup", "prt_fiv_transfer_lookup, 4 bands", "0", FIV_RECEIVERS,
      FIV; prt_fiv_transfer_lookup(&s->transfer, NULL, s->vectors, fiv_between(s, k, 0), (prt_fiv *)OUT), 0,
      8 * FIV_HIDDEN, 9)
EACH (fiv_self,     "fiv_self", "prt_fiv_self",         "0", FIV_RECEIVERS,
      FIV; prt_fiv_self(s->samples, &s->table, DIR(k), s->normals[k], (prt_rgb *)OUT), 0, FIV_READS + 15, 3)
EACH (fiv_vectors,  "fiv_shade 10 occluders", "prt_fiv_shade_vectors, vectors given", "0", FIV_RECEIVERS * 10,
      FIV; if (k % 10 == 0) prt_fiv_shade_vectors(s->totals[0], s->normals[0], 10, s->found, 0, (prt_rgb *)OUT), 0,
      13, 0.3)
EACH (fiv_add,      "fiv_vector", "prt_fiv_add",        "0", FIV_RECEIVERS,
      FIV; prt_fiv_add((prt_fiv *)OUT, DIR(k), s->totals[k]), 18, 15, 9)
EACH (fiv_light,    "fiv_vector", "prt_fiv_irradiance", "0", FIV_RECEIVERS,
      FIV; *(prt_rgb *)OUT = prt_fiv_irradiance(&s->samples[k], DIR(k)), 15, 12, 3)
EACH (fiv_total,    "fiv_total", "prt_fiv_total, 6 x 16 x 16", "0", FIV_RECEIVERS,
      *(prt_rgb *)OUT = prt_fiv_total(16, (const prt_rgb *)data->rows, DIR(k)), 0, 15, 3)
EACH (fiv_relight,  "fiv_transfer_light", "prt_fiv_transfer_light", "2-9", 4,
      prt_fiv_transfer_light(n, ROTATION, F, OUT), 0, 3 * n * n, 9 * (n + 1) * (n + 1))
BATCH(fiv_samples,  "fiv_table", "prt_fiv_transfer_samples, 4 bands", "0", FIV_RECEIVERS,
      FIV; prt_fiv_transfer_samples(&s->transfer, s->vectors, 0, items, (prt_fiv *)OUT), 18.0 * FIV_HIDDEN,
      FIV_HIDDEN, 9)
BATCH(fiv_pack8,    "fiv_table", "prt_fiv_pack, 8 bits", "0", FIV_SAMPLES,
      FIV; prt_fiv_pack(&s->table, 8, data->out, fiv_low, fiv_step, &fiv_packed), 0, 9, 9.0 / sizeof(prt_real))
BATCH(fiv_pack16,   "fiv_table", "prt_fiv_pack, 16 bits", "0", FIV_SAMPLES,
      FIV; prt_fiv_pack(&s->table, 16, data->out, fiv_low, fiv_step, &fiv_packed), 0, 9, 18.0 / sizeof(prt_real))
BATCH(fiv_unpack8,  "fiv_table", "prt_fiv_unpack, 8 bits", "0", FIV_RECEIVERS,
      FIV; prt_fiv_unpack(&s->packed8, 0, items, (prt_fiv *)OUT), 18, 9.0 / sizeof(prt_real), 9)
BATCH(fiv_unpack16, "fiv_table", "prt_fiv_unpack, 16 bits", "0", FIV_RECEIVERS,
      FIV; prt_fiv_unpack(&s->packed16, 0, items, (prt_fiv *)OUT), 0, 18.0 / sizeof(prt_real), 9)
EACH (fiv_size,     "fiv_packed_size", "prt_fiv_packed_size", "0", 64,
      FIV; *(size_t *)data->out = prt_fiv_packed_size(&s->table, 8), 0, 0, 0)

/* >>vo: "bands" is the number of lights; five opaque occluders a point. */
#define LIT "1,2,4,8,16,32"
#define VO_FLOPS(occluder, both) vo_operations(1, VO_SEEN, n, occluder, both)
#define VO_EYE (VO->lights[0].position)
#define VO_RGB ((prt_rgb *)OUT)
EACH (vo_dd_one,    "vo_dd",    "prt_vo_shade, point after point", LIT, VO_POINTS,
      prt_vo_shade(&VO->dd, VO->points + k, VO_EYE, VO_SEEN, VO->occluders + k * VO_SEEN, n, VO->lights, VO_RGB),
      VO_FLOPS(VO_DD_OCCLUDER, VO_DD_BOTH), 16 + 26 * VO_SEEN, 3)
BATCH(vo_dd_n,      "vo_dd",    "prt_vo_shade_n",       LIT, VO_POINTS,
      prt_vo_shade_n(&VO->dd, items, VO->points, VO_EYE, VO->first, VO->occluders, n, VO->lights, VO_RGB),
      VO_FLOPS(VO_DD_OCCLUDER, VO_DD_BOTH), 16 + 26 * VO_SEEN, 3)
BATCH(vo_dd_packed, "vo_dd",    "prt_vo_shade_packed_diffuse_n", LIT, VO_POINTS,
      prt_vo_shade_packed_diffuse_n(&VO->dd, 1, items, VO->points, VO_EYE, VO->first, VO->packed_diffuse, n,
      VO->lights, VO_RGB), VO_FLOPS(VO_DD_OCCLUDER + 70, VO_DD_BOTH), 16 + 20.0 / sizeof(prt_real) * VO_SEEN, 3)
BATCH(vo_dd_indexed, "vo_dd",   "prt_vo_shade_indexed_diffuse_n", LIT, VO_POINTS,
      prt_vo_shade_indexed_diffuse_n(&VO->dd, items, VO->points, VO_EYE, VO->first, VO->material_count_diffuse,
      VO->materials_diffuse, VO->indexed_diffuse, n, VO->lights, VO_RGB),
      VO_FLOPS(VO_DD_OCCLUDER + 5, VO_DD_BOTH), 16 + 10 * VO_SEEN, 3)
EACH (vo_all_one,   "vo_all",   "prt_vo_shade, point after point", LIT, VO_POINTS,
      prt_vo_shade(&VO->all, VO->points + k, VO_EYE, VO_SEEN, VO->occluders + k * VO_SEEN, n, VO->lights, VO_RGB),
      VO_FLOPS(VO_ALL_OCCLUDER, VO_ALL_BOTH), 16 + 26 * VO_SEEN, 3)
BATCH(vo_all_n,     "vo_all",   "prt_vo_shade_n",       LIT, VO_POINTS,
      prt_vo_shade_n(&VO->all, items, VO->points, VO_EYE, VO->first, VO->occluders, n, VO->lights, VO_RGB),
      VO_FLOPS(VO_ALL_OCCLUDER, VO_ALL_BOTH), 16 + 26 * VO_SEEN, 3)
BATCH(vo_all_packed, "vo_all",  "prt_vo_shade_packed_n", LIT, VO_POINTS,
      prt_vo_shade_packed_n(&VO->all, 1, items, VO->points, VO_EYE, VO->first, VO->packed, n, VO->lights, VO_RGB),
      VO_FLOPS(VO_ALL_OCCLUDER + 135, VO_ALL_BOTH), 16 + 40.0 / sizeof(prt_real) * VO_SEEN, 3)
BATCH(vo_all_indexed, "vo_all", "prt_vo_shade_indexed_n", LIT, VO_POINTS,
      prt_vo_shade_indexed_n(&VO->all, items, VO->points, VO_EYE, VO->first, VO->material_count, VO->materials,
      VO->indexed, n, VO->lights, VO_RGB), VO_FLOPS(VO_ALL_OCCLUDER + 10, VO_ALL_BOTH), 16 + 19 * VO_SEEN, 3)
#define VO_POINT VO->points[k].position
EACH (vo_pack,      "vo_pack",  "prt_vo_pack, 5 occluders", "0", VO_POINTS,
      prt_vo_pack(1, VO_POINT, VO_SEEN, VO->occluders + k * VO_SEEN, (prt_vo_packed *)data->out), 0,
      3 + 26 * VO_SEEN, 40.0 * VO_SEEN / sizeof(prt_real))
EACH (vo_pack_dd,   "vo_pack",  "prt_vo_pack_diffuse, 5 occluders", "0", VO_POINTS,
      prt_vo_pack_diffuse(1, VO_POINT, VO_SEEN, VO->occluders + k * VO_SEEN, (prt_vo_packed_diffuse *)data->out), 0,
      3 + 26 * VO_SEEN, 20.0 * VO_SEEN / sizeof(prt_real))
EACH (vo_unpack,    "vo_pack",  "prt_vo_unpack, 5 occluders", "0", VO_POINTS,
      prt_vo_unpack(1, VO_POINT, VO_SEEN, VO->packed + k * VO_SEEN, (prt_vo_occluder *)OUT), 0,
      3 + 40.0 * VO_SEEN / sizeof(prt_real), 26 * VO_SEEN)
EACH (vo_unpack_dd, "vo_pack",  "prt_vo_unpack_diffuse, 5 occluders", "0", VO_POINTS,
      prt_vo_unpack_diffuse(1, VO_POINT, VO_SEEN, VO->packed_diffuse + k * VO_SEEN, (prt_vo_occluder *)OUT), 0,
      3 + 20.0 * VO_SEEN / sizeof(prt_real), 26 * VO_SEEN)
EACH (vo_index,     "vo_index", "prt_vo_index, 5 occluders", "0", VO_POINTS,
      int made = 0; prt_vo_index(VO_SEEN, VO->occluders + k * VO_SEEN, VO_COLORS, (prt_vo_material *)OUT, &made,
      (prt_vo_indexed *)((prt_vo_material *)OUT + VO_COLORS)), 0, 26 * VO_SEEN, 19 * VO_SEEN)
EACH (vo_index_dd,  "vo_index", "prt_vo_index_diffuse, 5 occluders", "0", VO_POINTS,
      int made = 0; prt_vo_index_diffuse(VO_SEEN, VO->occluders + k * VO_SEEN, VO_COLORS, (prt_vo_material *)OUT, &made,
      (prt_vo_indexed_diffuse *)((prt_vo_material *)OUT + VO_COLORS)), 0, 26 * VO_SEEN, 10 * VO_SEEN)
EACH (vo_expand,    "vo_index", "prt_vo_expand, 5 occluders", "0", VO_POINTS,
      prt_vo_expand(VO->material_count, VO->materials, VO_SEEN, VO->indexed + k * VO_SEEN, (prt_vo_occluder *)OUT), 0,
      19 * VO_SEEN, 26 * VO_SEEN)
EACH (vo_expand_dd, "vo_index", "prt_vo_expand_diffuse, 5 occluders", "0", VO_POINTS,
      prt_vo_expand_diffuse(VO->material_count_diffuse, VO->materials_diffuse, VO_SEEN,
      VO->indexed_diffuse + k * VO_SEEN, (prt_vo_occluder *)OUT), 0, 10 * VO_SEEN, 26 * VO_SEEN)
EACH (vo_size,      "vo_size",  "prt_vo_size", "0", 64,
      *(size_t *)data->out = prt_vo_size(PRT_VO_INDEXED, k, 5 * k, 6), 0, 0, 2)
EACH (vo_bend,      "vo_bend",  "prt_vo_bend, 5 occluders, 2 waves", "0", VO_POINTS,
      prt_vo_bend(2, VO->waves, 1, VO_POINT, VO_SEEN, VO->occluders + k * VO_SEEN, (prt_vo_occluder *)OUT),
      2 * 20 + 2 * 30 * VO_SEEN, 3 + 26 * VO_SEEN, 26 * VO_SEEN)

/* >>reference, and the text of a result: not made for speed */
EACH (reference,    "reference", "prt_reference_sh, band n - 1", LOW, 16,
      *(double *)data->out = prt_reference_sh(n - 1, k % n, DIR(k).x, DIR(k).y, DIR(k).z), 0, 3, 1)
EACH (reference_project, "reference", "prt_reference_project, n nodes", LOW, 1,
      prt_reference_project(n, n, one, NULL, OUT), 4.0 * n * n * n * n, 0, n * n)
EACH (result_text,  "result_string", "prt_result_string", "0", 64,
      *(const char **)data->out = prt_result_string((prt_result)(k % 4)), 0, 0, 2)
