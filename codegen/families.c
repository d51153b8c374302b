/* All families of kernels. */
#include "kernels.h"

const family families[] = {
    { "sh_eval", 1, 10, FORM_ONE | FORM_SWEPT | FORM_TEXT, describe_sh_eval },
    { "sh_at", 1, 10, FORM_ONE | FORM_TEXT, describe_sh_at },
    { "ch_eval", 1, 10, FORM_ONE | FORM_SWEPT | FORM_TEXT, describe_ch_eval },
    { "ch_at", 1, 10, FORM_ONE | FORM_TEXT, describe_ch_at },
    { "sh_delta", 1, 10, FORM_TEXT, describe_sh_delta },
    { "sh_cone", 1, 10, FORM_TEXT, describe_sh_cone },
    { "sh_sphere", 1, 10, FORM_TEXT, describe_sh_sphere },
    { "sh_cosine_lobe", 1, 10, FORM_TEXT, describe_sh_cosine_lobe },
    { "sh_hemisphere", 1, 10, FORM_TEXT, describe_sh_hemisphere },
    { "sh_convolve", 1, 10, FORM_TEXT, describe_sh_convolve },
    { "sh_irradiance", 1, 10, FORM_TEXT, describe_sh_irradiance },
    { "sh_window_hann", 1, 10, FORM_TEXT, describe_sh_window_hann },
    { "sh_window_lanczos", 1, 10, FORM_TEXT, describe_sh_window_lanczos },
    { "sh_window_positive", 1, 10, FORM_TEXT, describe_sh_window_positive },
    { "sh_rotate", 2, 8, FORM_ONE | FORM_TEXT, describe_sh_rotate },
    { "sh_dot", 1, 10, FORM_TEXT, describe_sh_dot },
    { "shade_diffuse", 1, 10, FORM_TEXT, describe_shade_diffuse },
    { "sh_product", 1, 6, FORM_ONE | FORM_LANES | FORM_TEXT, describe_sh_product },
    { "sh_square", 1, 5, FORM_ONE | FORM_TEXT, describe_sh_square },
    { "sh_rows", 3, 8, FORM_NODES | FORM_BLOCK, describe_sh_rows },
    { "sh_terms", 3, 8, FORM_NODES, describe_sh_terms },
    { "row_product", 3, 8, FORM_BLOCK, describe_row_product },
};
const int family_count = (int)(sizeof families / sizeof families[0]);
