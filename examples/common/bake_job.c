#define _POSIX_C_SOURCE 200809L
#include "bake_job.h"

#include <stdlib.h>
#include <string.h>
#include <threads.h>
#include <time.h>
#include <unistd.h>

#include "progress.h"

enum { CHUNK = 32, MOST_THREADS = 256 };

/* What the threads share; everything below the lock is guarded by it. */
typedef struct shared_job {
    bake_job        *job;
    const unsigned char *before;       /* marks at the start: what need not be baked */
    mtx_t           lock;
    cnd_t           changed;
    int             next, finished, running;
    prt_result      result;            /* the first that is not PRT_OK */
} shared_job;

typedef struct worker { shared_job *shared; int first; } worker;

int processor_count(void) {
    long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count < 1 ? 1 : count > MOST_THREADS ? MOST_THREADS : (int)count;
}

static int point_finished(void *user, int done, int total) {
    worker *self = (worker *)user;
    shared_job *s = self->shared;
    int stop;
    (void)total;
    mtx_lock(&s->lock);
    s->job->done[self->first + done - 1] = 1;
    s->finished++;
    stop = s->result != PRT_OK || (s->job->stop && *s->job->stop);
    mtx_unlock(&s->lock);
    return stop;
}

/* The next range of points that nobody has baked or taken; 0 where the work is over. */
static int take_chunk(shared_job *s, int *first) {
    int count = 0, at;
    mtx_lock(&s->lock);
    if (s->job->stop && *s->job->stop && s->result == PRT_OK) s->result = PRT_ERR_CANCELLED;
    if (s->result == PRT_OK) {
        at = s->next;
        while (at < s->job->point_count && s->before[at]) at++;
        *first = at;
        while (at < s->job->point_count && !s->before[at] && count < CHUNK) { at++; count++; }
        s->next = at;
    }
    mtx_unlock(&s->lock);
    return count;
}

static int work(void *user) {
    worker self;
    bake_job *job;
    prt_bake_desc desc;
    int count;
    self.shared = (shared_job *)user;
    job = self.shared->job;
    desc = job->desc;
    desc.progress = point_finished;
    desc.progress_user = &self;
    while ((count = take_chunk(self.shared, &self.first)) > 0) {
        prt_result result = prt_bake_transfer(&desc, job->point_count, job->points, self.first, count, job->transfer);
        if (result == PRT_OK) continue;
        mtx_lock(&self.shared->lock);
        if (self.shared->result == PRT_OK) self.shared->result = result;
        mtx_unlock(&self.shared->lock);
    }
    mtx_lock(&self.shared->lock);
    self.shared->running--;
    cnd_signal(&self.shared->changed);
    mtx_unlock(&self.shared->lock);
    return 0;
}

/* Waits for the threads, shows progress, makes checkpoints. Holds the lock but while it sleeps or saves. */
static void watch(shared_job *s, progress *p, unsigned char *snapshot) {
    bake_job *job = s->job;
    double saved = seconds_now();
    mtx_lock(&s->lock);
    while (s->running > 0) {
        struct timespec until;
        timespec_get(&until, TIME_UTC);
        until.tv_nsec += 100000000;
        if (until.tv_nsec >= 1000000000) { until.tv_nsec -= 1000000000; until.tv_sec++; }
        cnd_timedwait(&s->changed, &s->lock, &until);
        if (job->what) progress_show(p, s->finished);
        if (!job->checkpoint || !(job->checkpoint_every > 0) || seconds_now() - saved < job->checkpoint_every) continue;
        memcpy(snapshot, job->done, (size_t)job->point_count);
        mtx_unlock(&s->lock);
        job->checkpoint(job->user, snapshot, job->transfer);         /* nobody writes a finished row again */
        saved = seconds_now();
        mtx_lock(&s->lock);
    }
    mtx_unlock(&s->lock);
}

static prt_result run_threads(shared_job *s, progress *p, unsigned char *snapshot) {
    thrd_t threads[MOST_THREADS];
    int wanted = s->job->threads < 1 ? 1 : s->job->threads > MOST_THREADS ? MOST_THREADS : s->job->threads, started = 0;
    mtx_lock(&s->lock);
    while (started < wanted && thrd_create(&threads[started], work, s) == thrd_success) started++;
    s->running = started;
    mtx_unlock(&s->lock);
    if (started == 0) return PRT_ERR_MEMORY;
    watch(s, p, snapshot);
    while (started > 0) thrd_join(threads[--started], NULL);
    return s->result;
}

prt_result bake_job_run(bake_job *job) {
    size_t count = (size_t)job->point_count;
    unsigned char *before = (unsigned char *)malloc(2 * count + 1);
    shared_job s;
    progress p;
    prt_result result;
    int i;
    if (!before) return PRT_ERR_MEMORY;
    memcpy(before, job->done, count);
    memset(&s, 0, sizeof s);
    s.job = job;
    s.before = before;
    for (i = 0; i < job->point_count; i++) s.finished += job->done[i] != 0;
    if (mtx_init(&s.lock, mtx_plain) != thrd_success || cnd_init(&s.changed) != thrd_success) {
        free(before);
        return PRT_ERR_MEMORY;
    }
    progress_start(&p, job->what, job->point_count, s.finished, "rays", job->desc.samples);
    result = run_threads(&s, &p, before + count);
    if (job->what) progress_end(&p, s.finished);
    if (result == PRT_ERR_CANCELLED && s.finished == job->point_count) result = PRT_OK;
    cnd_destroy(&s.changed);
    mtx_destroy(&s.lock);
    free(before);
    return result;
}
