#include "parallel.h"

#include <string.h>
#include <threads.h>

#include "progress.h"

enum { MOST_THREADS = 256 };

typedef struct shared { parallel *p; mtx_t lock; int next, finished, failed, running; } shared;

/* Counts what was finished and hands out the next items; 0: none are left, or the work is over. */
static int take(shared *s, int finished, int failed, int *first) {
    int count;
    mtx_lock(&s->lock);
    s->failed |= failed;
    s->finished += failed ? 0 : finished;
    *first = s->next;
    count = s->p->count - s->next < s->p->chunk ? s->p->count - s->next : s->p->chunk;
    if (s->failed || (s->p->stop && *s->p->stop)) count = 0;
    s->next += count;
    mtx_unlock(&s->lock);
    return count;
}

static int run_thread(void *user) {
    shared *s = (shared *)user;
    void *own = NULL;
    int failed = s->p->begin ? s->p->begin(s->p->user, &own) : 0, begun = !failed, first, count = 0;
    while ((count = take(s, count, failed, &first)) > 0) failed = s->p->work(s->p->user, own, first, count);
    if (begun && s->p->end) s->p->end(own);
    mtx_lock(&s->lock);
    s->running--;
    mtx_unlock(&s->lock);
    return 0;
}

static void watch(shared *s, progress *line) {
    const struct timespec pause = { 0, 5000000 };
    int running = 1;
    while (running) {
        thrd_sleep(&pause, NULL);
        mtx_lock(&s->lock);
        running = s->running;
        if (s->p->what) progress_show(line, s->finished);
        mtx_unlock(&s->lock);
    }
}

int parallel_run(parallel *p, why *w) {
    thrd_t thread[MOST_THREADS];
    shared s;
    progress line;
    int started = 0;
    memset(&s, 0, sizeof s);
    s.p = p;
    mtx_init(&s.lock, mtx_plain);
    progress_start(&line, p->what ? p->what : "", p->count, 0, p->unit ? p->unit : "", p->unit_per_item);
    mtx_lock(&s.lock);
    while (started < p->threads && started < MOST_THREADS &&
           thrd_create(&thread[started], run_thread, &s) == thrd_success)
        started++;
    s.running = started;
    mtx_unlock(&s.lock);
    watch(&s, &line);
    s.failed |= started == 0;
    while (started > 0) thrd_join(thread[--started], NULL);
    if (p->what) progress_end(&line, s.finished);
    mtx_destroy(&s.lock);
    p->done = s.finished;
    return s.failed ? why_set(w, "%s: failed: out of memory, or rays could not be traced", p->what ? p->what : "work")
                    : 0;
}

int parallel_all(parallel *p, why *w) {
    if (parallel_run(p, w)) return -1;
    return p->done == p->count ? 0 : why_set(w, "interrupted");
}
