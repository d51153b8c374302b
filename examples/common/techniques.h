/* techniques: the ways to light a scene at its vertices that [Sherif 2013] compares in section 7.6: Phong without
   shadows, ambient occlusion, vector occluders, spherical and cpherical harmonics. Each is baked once, then shades all
   vertices under any point lights. */
#ifndef EXAMPLES_TECHNIQUES_H
#define EXAMPLES_TECHNIQUES_H

#include <signal.h>

#include "scene.h"

typedef enum technique {
    TECHNIQUE_PHONG,                   /* no shadows */
    TECHNIQUE_AO,                      /* Phong times ambient occlusion */
    TECHNIQUE_VO_DD,                   /* vector occluders: shadows as in the thesis, diffuse interreflection */
    TECHNIQUE_VO_DD_CAP,               /* the same with the cap law of shadows */
    TECHNIQUE_VO,                      /* VO/DD, and the interreflections of shining surfaces, DS and SS */
    TECHNIQUE_VO_CAP,
    TECHNIQUE_SH3, TECHNIQUE_SH6,      /* transfer with one bounce, lights as infinitely distant deltas */
    TECHNIQUE_CH3, TECHNIQUE_CH6,      /* as the thesis uses CH: inner products in the place of coefficients */
    TECHNIQUE_SH3_GLOSSY, TECHNIQUE_SH6_GLOSSY,            /* SH, and Phong's lobe from transfer matrices */
    TECHNIQUE_COUNT
} technique;

extern const char *const technique_names[TECHNIQUE_COUNT];

enum { TECHNIQUES_SH = 2, TECHNIQUES_PASSES = 2 };
static const int techniques_bands[TECHNIQUES_SH] = { 3, 6 };

typedef struct techniques {
    const scene         *scene;        /* the caller's, to be set */
    const embree_tracer *tracer;
    int                 rays, threads, most_occluders;     /* rays a vertex in each pass */
    int                 occluders_wanted;                  /* cut into so many in all, by area; 0: one a part */
    prt_real            bias;
    int                 shining;       /* bake DS and SS too */
    unsigned            off;           /* what else not to bake: PRT_VO_NO_... */
    int                 with_sh, with_time_of_dd;          /* with_time_of_dd: bake VO/DD once more for its time */
    int                 with_glossy;   /* matrices too: 3 bands^4 numbers a vertex */
    int                 matte;         /* shade as if nothing shone; may change between calls of techniques_shade */
    volatile sig_atomic_t *stop;

    prt_vo_object   objects[SCENE_PARTS];
    int             *groups;           /* [triangles] the occluder within its part */
    int             group_count;       /* occluders of the scene */
    prt_vo_point    *points, *matte_points;                /* the vertices with their materials */
    prt_real        *open;             /* ambient occlusion, 0 blocked ... 1 open */
    prt_vo_row      *rows;
    int             *first;            /* occluders of vertex k: first[k] ... first[k+1]-1 */
    prt_vo_occluder *occluders;
    prt_vo_indexed  *indexed;          /* the same, as they are kept: for VO/DD+DS+SS and for VO/DD */
    prt_vo_indexed_diffuse *indexed_diffuse;               /* NULL where something is transmissive */
    prt_vo_material materials[SCENE_PARTS], materials_diffuse[SCENE_PARTS];
    int             material_count, material_count_diffuse;
    prt_real        *transfer[TECHNIQUES_SH], *moments[TECHNIQUES_SH];   /* [points][3][bands^2], one bounce in it */
    double          ao_seconds, vo_seconds, vo_dd_seconds;
    prt_real        *matrices[TECHNIQUES_SH];  /* [points][3][bands^2][bands^2], of all that arrives, bounce included */
    double          sh_seconds[TECHNIQUES_SH][TECHNIQUES_PASSES], ch_seconds[TECHNIQUES_SH];
    double          glossy_seconds[TECHNIQUES_SH];
    int             occluder_count, dropped;
} techniques;

/* Bakes everything. 0, or -1 with the reason in w. */
int  techniques_bake(techniques *t, why *w);
void techniques_free(techniques *t);

/* Colours of all vertices, out[points]. *seconds (may be NULL): the time of the shading itself, which for SH and CH
   counts the projection of the lights. Lights of SH and CH stand in their direction from `centre`. */
int  techniques_shade(const techniques *t, technique which, prt_vec3 eye, prt_vec3 centre, int light_count,
                      const prt_point_light *lights, prt_rgb *out, double *seconds, why *w);

#endif
