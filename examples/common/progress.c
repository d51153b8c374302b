#define _POSIX_C_SOURCE 200809L
#include "progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

enum { BAR = 24 };

static double read_clock(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double seconds_now(void) { return read_clock(CLOCK_MONOTONIC); }
double processor_seconds(void) { return read_clock(CLOCK_PROCESS_CPUTIME_ID); }

void progress_start(progress *p, const char *what, double total, double already, const char *unit,
                    double unit_per_step) {
    p->what = what;
    p->unit = unit;
    p->total = total;
    p->already = already;
    p->unit_per_step = unit_per_step;
    p->started = p->shown = seconds_now();
    p->terminal = isatty(STDERR_FILENO);
}

static void print_rate(const progress *p, double rate) {
    static const char *const prefix[] = { "", "k", "M", "G" };
    int k = 0;
    while (rate >= 1000 && k < 3) {
        rate /= 1000;
        k++;
    }
    fprintf(stderr, "%.1f %s%s/s", rate, prefix[k], p->unit);
}

static void print_line(const progress *p, double done, double seconds) {
    double part = p->total > 0 ? done / p->total : 1, rate = seconds > 0 ? (done - p->already) / seconds : 0;
    int i;
    fprintf(stderr, "%s%s ", p->terminal ? "\r" : "", p->what);
    if (p->terminal) {
        fputc('[', stderr);
        for (i = 0; i < BAR; i++) fputc(i < (int)(part * BAR) ? '=' : ' ', stderr);
        fputs("] ", stderr);
    }
    fprintf(stderr, "%3d %%, ", (int)(100 * part));
    print_rate(p, rate * p->unit_per_step);
}

static void end_line(const progress *p) { fputs(p->terminal ? "\033[K" : "\n", stderr); }

void progress_show(progress *p, double done) {
    double now = seconds_now(), rate;
    if (now - p->shown < (p->terminal ? 0.2 : 10)) return;
    p->shown = now;
    print_line(p, done, now - p->started);
    rate = (done - p->already) / (now - p->started);
    if (rate > 0) {
        int left = (int)((p->total - done) / rate + 0.5);
        fprintf(stderr, ", %d:%02d left", left / 60, left % 60);
    }
    end_line(p);
}

void progress_end(progress *p, double done) {
    double seconds = seconds_now() - p->started;
    print_line(p, done, seconds);
    fprintf(stderr, ", took %.1f s", seconds);
    end_line(p);
    if (p->terminal) fputc('\n', stderr);
}
