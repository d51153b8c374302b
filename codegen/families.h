/* The families of kernels, a line each: X(name, description, bands from, to, forms).
     name         as after --emit, and as in prt.h
     description  the function describe_... of codegen/kernel_<room>.c
     bands        both 0: bands have no meaning to it
     forms        FORM_TEXT: printed in every language; the others are forms that prt.h needs (kernels.h) */
#ifndef PRT_CODEGEN_FAMILIES_H
#define PRT_CODEGEN_FAMILIES_H

#define FAMILIES(X) \
    X(sh_eval, sh_eval, 1, 10, FORM_ONE | FORM_SWEPT | FORM_TEXT) \
    X(sh_at, sh_at, 1, 10, FORM_ONE | FORM_TEXT) \
    X(ch_eval, ch_eval, 1, 10, FORM_ONE | FORM_SWEPT | FORM_TEXT) \
    X(ch_at, ch_at, 1, 10, FORM_ONE | FORM_TEXT) \
    X(sh_add_sample, sh_add_sample, 1, 10, FORM_TEXT) \
    X(sh_delta, sh_delta, 1, 10, FORM_TEXT) \
    X(sh_cone, sh_cone, 1, 10, FORM_TEXT) \
    X(sh_sphere, sh_sphere, 1, 10, FORM_TEXT) \
    X(sh_cosine_lobe, sh_cosine_lobe, 1, 10, FORM_TEXT) \
    X(sh_hemisphere, sh_hemisphere, 1, 10, FORM_TEXT) \
    X(sh_convolve, sh_convolve, 1, 10, FORM_TEXT) \
    X(sh_zonal_to, sh_zonal_to, 1, 10, FORM_TEXT) \
    X(sh_irradiance, sh_irradiance, 1, 10, FORM_TEXT) \
    X(sh_window_hann, sh_window_hann, 1, 10, FORM_TEXT) \
    X(sh_window_lanczos, sh_window_lanczos, 1, 10, FORM_TEXT) \
    X(sh_window_positive, sh_window_positive, 1, 10, FORM_TEXT) \
    X(sh_window_dering, sh_window_dering, 1, 10, FORM_TEXT) \
    X(sh_irradiance_packed, sh_irradiance_packed, 0, 0, FORM_TEXT) \
    X(sh_rotate, sh_rotate, 2, 8, FORM_DOUBLE) \
    X(sh_rotate, sh_rotate_matrix, 1, 8, FORM_TEXT) \
    X(sh_rotate_turned, sh_rotate, 2, 8, FORM_TEXT) \
    X(sh_turn, sh_turn, 0, 0, FORM_TEXT) \
    X(sh_rotate_z, sh_rotate_z, 1, 8, FORM_TEXT) \
    X(sh_rotation, sh_rotation, 1, 6, FORM_TEXT) \
    X(sh_rotate_by, sh_rotate_by, 1, 6, FORM_TEXT) \
    X(rotation_from_quaternion, rotation_from_quaternion, 0, 0, FORM_TEXT) \
    X(sh_dot, sh_dot, 1, 10, FORM_TEXT) \
    X(shade_diffuse, shade_diffuse, 1, 10, FORM_TEXT) \
    X(shade_diffuse_rgb, shade_diffuse_rgb, 1, 10, FORM_TEXT) \
    X(shade_diffuse_four, shade_diffuse_four, 0, 0, FORM_TEXT) \
    X(shade_glossy, shade_glossy, 1, 10, FORM_TEXT) \
    X(phong_zonal, phong_zonal, 1, 10, FORM_TEXT) \
    X(local_frame, local_frame, 0, 0, FORM_TEXT) \
    X(sh_product, sh_product, 1, 6, FORM_ONE | FORM_TEXT) \
    X(sh_products, sh_products, 1, 4, FORM_LANES) \
    X(point_parts, point_parts, 5, 5, FORM_STRIDED) \
    X(point_corners, point_corners, 5, 5, FORM_BLOCK) \
    X(point_octants, point_octants, 5, 5, FORM_BLOCK) \
    X(point_plane, point_plane, 5, 5, FORM_BLOCK) \
    X(point_coefficients, point_coefficients, 5, 5, FORM_STRIDED) \
    X(sh_square, sh_square, 1, 5, FORM_ONE | FORM_TEXT) \
    X(sh_rows, sh_rows, 3, 8, FORM_NODES) \
    X(sh_rows_block, sh_rows, 3, 8, FORM_BLOCK) \
    X(sh_terms, sh_terms, 3, 8, FORM_NODES) \
    X(row_product, row_product, 3, 8, FORM_BLOCK) \
    X(sh_product_zonal, sh_product_zonal, 1, 6, FORM_TEXT) \
    X(sh_product_matrix, sh_product_matrix, 1, 4, FORM_TEXT) \
    X(sh_product_by, sh_product_by, 1, 4, FORM_TEXT) \
    X(sh_mask_hann, sh_mask_hann, 1, 6, FORM_TEXT) \
    X(sh_mask_lanczos, sh_mask_lanczos, 1, 6, FORM_TEXT) \
    X(sh_mask_positive, sh_mask_positive, 1, 6, FORM_TEXT) \
    X(sh_mask_filter_hann, sh_mask_filter_hann, 1, 6, FORM_TEXT) \
    X(sh_mask_filter_lanczos, sh_mask_filter_lanczos, 1, 6, FORM_TEXT) \
    X(sh_mask_filter_positive, sh_mask_filter_positive, 1, 6, FORM_TEXT) \
    X(sh_exp_series, sh_exp_series, 1, 4, FORM_TEXT) \
    X(sh_exp_linear, sh_exp_linear, 1, 10, FORM_TEXT) \
    X(ch_from_sh, ch_from_sh, 1, 10, FORM_TEXT) \
    X(sh_from_ch, sh_from_ch, 1, 10, FORM_TEXT) \
    X(ch_from_moments, ch_from_moments, 1, 10, FORM_TEXT) \
    X(ch_to_moments, ch_to_moments, 1, 10, FORM_TEXT) \
    X(ch_dot, ch_dot, 1, 10, FORM_TEXT) \
    X(ch_rotate, ch_rotate, 1, 8, FORM_TEXT) \
    X(ch_product, ch_product, 1, 6, FORM_TEXT) \
    X(fiv_add, fiv_add, 0, 0, FORM_TEXT) \
    X(fiv_irradiance, fiv_irradiance, 0, 0, FORM_TEXT) \
    X(fiv_place, fiv_place, 0, 0, FORM_TEXT) \
    X(fiv_blend, fiv_blend, 0, 0, FORM_TEXT) \
    X(fiv_taken, fiv_taken, 0, 0, FORM_TEXT) \
    X(fiv_filled, fiv_filled, 0, 0, FORM_TEXT) \
    X(fiv_overlap, fiv_overlap, 0, 0, FORM_TEXT) \
    X(fiv_twice, fiv_twice, 0, 0, FORM_TEXT) \
    X(fiv_self, fiv_self, 0, 0, FORM_TEXT) \
    X(fiv_transfer, fiv_transfer, 1, 6, FORM_TEXT) \
    X(vo_direct, vo_direct, 0, 0, FORM_TEXT) \
    X(vo_pass, vo_pass, 0, 0, FORM_TEXT) \
    X(vo_pass_cap, vo_pass_cap, 0, 0, FORM_TEXT) \
    X(vo_sent, vo_sent, 0, 0, FORM_TEXT) \
    X(vo_bend, vo_bend, 0, 0, FORM_TEXT) \
    X(vo_unfold, vo_unfold, 0, 0, FORM_TEXT)

#endif
