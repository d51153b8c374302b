/* hello: bake and light three points on a floor under a ball, with no dependency but the two headers.
   cc -O2 -I.. hello.c -lm && ./a.out */
#include <stdio.h>
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"

typedef struct ball { prt_vec3 centre; prt_real radius; } ball;

static const ball balls[2] = { { { 0, 0, 1.2f }, 1 }, { { 2.5f, 0, 0.5f }, 0.5f } };

/* The ray callback: blocked[k] becomes 1 if ray k hits a ball. */
static int hits_a_ball(void *user, int count, const prt_ray *rays, unsigned char *blocked) {
    int k, i;
    (void)user;
    for (k = 0; k < count; k++) {
        for (i = 0; i < 2; i++) {
            prt_vec3 d = rays[k].dir, o = rays[k].origin, c = balls[i].centre;
            prt_real x = c.x - o.x, y = c.y - o.y, z = c.z - o.z, along = x * d.x + y * d.y + z * d.z;
            prt_real off = x * x + y * y + z * z - along * along;            /* squared distance from ray to centre */
            if (along > 0 && off < balls[i].radius * balls[i].radius) blocked[k] = 1;
        }
    }
    return 0;
}

int main(void) {
    enum { BANDS = 5, N = PRT_SH_COUNT(BANDS), POINTS = 3 };
    const prt_point points[POINTS] = { { { 0, 0, 0 }, { 0, 0, 1 } }, { { 1.2f, 0, 0 }, { 0, 0, 1 } },
                                       { { 5, 0, 0 }, { 0, 0, 1 } } };
    const prt_vec3 up = { 0, 0, 1 };
    prt_tracer tracer = { NULL, hits_a_ball, NULL };
    prt_bake_desc desc = { 0 };
    prt_real transfer[POINTS * N], light[3 * N];
    prt_rgb out[POINTS];
    prt_result result;
    int k;
    desc.bands = BANDS;
    desc.tracer = &tracer;
    result = prt_bake_transfer(&desc, POINTS, points, 0, POINTS, transfer);
    if (result != PRT_OK) return fprintf(stderr, "hello: %s\n", prt_result_string(result)), 1;
    prt_sh_hemisphere(BANDS, up, 0.9f, 0.2f, light);                         /* a sky: red, green and blue planes */
    prt_sh_hemisphere(BANDS, up, 1.0f, 0.2f, light + N);
    prt_sh_hemisphere(BANDS, up, 1.2f, 0.1f, light + 2 * N);
    prt_shade_diffuse_n(BANDS, POINTS, transfer, light, out);
    for (k = 0; k < POINTS; k++)
        printf("at x = %.1f: %.3f %.3f %.3f\n", points[k].position.x, out[k].r, out[k].g, out[k].b);
    return 0;
}
