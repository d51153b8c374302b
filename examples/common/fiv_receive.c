#include "fiv_receive.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "parallel.h"
#include "vector.h"

enum { MOST_BODIES = 64 };

typedef struct receive_job {
    const fiv_receive *f;
    picture           *out;
    int               turned;          /* some body is */
    prt_fiv_occluder  occluders[MOST_BODIES];    /* where none is */
} receive_job;

static prt_real positive(prt_real v) { return v > 0 ? v : 0; }

/* What body k hides, looked up in its own frame. */
static prt_result look_up(const fiv_receive *f, int k, const prt_point *at, prt_fiv_hidden *hidden) {
    const body *b = f->stage->bodies + k;
    prt_result result;
    hidden->to_centre = vec_add(b->position, -1, at->position);
    hidden->radius = f->tables[k]->radius;
    result = prt_fiv_lookup(f->tables[k], vec_turn_back(b->rotation, hidden->to_centre), &hidden->fiv);
    hidden->fiv.r = vec_turn(b->rotation, hidden->fiv.r);
    hidden->fiv.g = vec_turn(b->rotation, hidden->fiv.g);
    hidden->fiv.b = vec_turn(b->rotation, hidden->fiv.b);
    return result;
}

/* Without any treatment of occluders that the horizon cuts: total - sum of max(0, N.FIV), down to 0. */
static prt_rgb shade_plainly(prt_rgb total, prt_vec3 n, int count, const prt_fiv_hidden *hidden) {
    int k;
    for (k = 0; k < count; k++) {
        prt_rgb less = prt_fiv_irradiance(&hidden[k].fiv, n);
        if (vec_dot(hidden[k].to_centre, n) <= -(double)hidden[k].radius) continue;
        total.r -= positive(less.r); total.g -= positive(less.g); total.b -= positive(less.b);
    }
    total.r = positive(total.r); total.g = positive(total.g); total.b = positive(total.b);
    return total;
}

/* What a body leaves of the light at its own surface. */
static prt_result shade_self(const fiv_receive *f, int own, const prt_point *at, prt_rgb *out) {
    const body *b = f->stage->bodies + own;
    prt_fiv environment;
    environment.r = vec_turn_back(b->rotation, f->environment.r);
    environment.g = vec_turn_back(b->rotation, f->environment.g);
    environment.b = vec_turn_back(b->rotation, f->environment.b);
    return prt_fiv_self(&environment, f->self[own], vec_turn_back(b->rotation, vec_add(at->position, -1, b->position)),
                        vec_turn_back(b->rotation, at->normal), out);
}

/* A body's own shadow first, then what the others take from the rest. */
static prt_result shade(const receive_job *j, int which, const prt_point *at, prt_rgb *out) {
    const fiv_receive *f = j->f;
    prt_fiv_hidden hidden[MOST_BODIES];
    prt_rgb total = f->ground_total;
    prt_result result = PRT_OK;
    int k, count = 0;
    out->r = out->g = out->b = 0;
    if (which >= 0 && !f->self) return PRT_OK;
    if (which >= 0) result = shade_self(f, which, at, &total);
    else if (!j->turned && !(f->flags & FIV_NO_PARTIAL))
        return prt_fiv_shade(total, at->position, at->normal, f->stage->body_count, j->occluders, f->flags, out);
    for (k = 0; k < f->stage->body_count && result == PRT_OK; k++)
        if (k != which) result = look_up(f, k, at, &hidden[count++]);
    if (result != PRT_OK) return result;
    if (f->flags & FIV_NO_PARTIAL) {
        *out = shade_plainly(total, at->normal, count, hidden);
        return PRT_OK;
    }
    return prt_fiv_shade_vectors(total, at->normal, count, hidden, f->flags, out);
}

static int shade_rows(void *user, void *own, int first, int count) {
    const receive_job *j = (const receive_job *)user;
    size_t width = (size_t)j->f->receivers->width, k;
    (void)own;
    for (k = (size_t)first * width; k < (size_t)(first + count) * width; k++) {
        float *to = j->out->rgba + 4 * k;
        int which = j->f->receivers->body[k];
        prt_rgb e;
        memset(to, 0, 4 * sizeof *to);
        if (which < STAGE_GROUND) continue;
        if (shade(j, which, j->f->receivers->points + k, &e) != PRT_OK) return -1;
        to[0] = (float)e.r; to[1] = (float)e.g; to[2] = (float)e.b; to[3] = 1;
    }
    return 0;
}

static int is_turned(const body *b) {
    static const prt_real identity[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    int k;
    for (k = 0; k < 9; k++) if (fabs((double)(b->rotation[k] - identity[k])) > 1e-6) return 1;
    return 0;
}

int fiv_receive_run(const fiv_receive *f, picture *out, why *w) {
    receive_job j;
    parallel p;
    int k;
    if (f->stage->body_count > MOST_BODIES) return why_set(w, "more than %d bodies", MOST_BODIES);
    j.f = f;
    j.out = out;
    j.turned = 0;
    for (k = 0; k < f->stage->body_count; k++) {
        j.turned |= is_turned(f->stage->bodies + k);
        j.occluders[k].table = f->tables[k];
        j.occluders[k].position = f->stage->bodies[k].position;
    }
    memset(&p, 0, sizeof p);
    p.count = f->receivers->height;
    p.chunk = 4;
    p.threads = f->threads;
    p.stop = f->stop;
    p.work = shade_rows;
    p.user = &j;
    if (parallel_run(&p, w)) return -1;
    return p.done < p.count ? why_set(w, "interrupted") : 0;
}
