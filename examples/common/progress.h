/* progress: one line about long work: how far, how fast, how long still. On a terminal the line is rewritten a few
   times a second; elsewhere (a log, a pipe) a new line appears at most every ten seconds. Goes to stderr. */
#ifndef EXAMPLES_PROGRESS_H
#define EXAMPLES_PROGRESS_H

typedef struct progress {
    const char *what, *unit;           /* "bake", "rays" */
    double     total, already;         /* steps in all; steps done before this run, which say nothing about the speed */
    double     unit_per_step;
    double     started, shown;
    int        terminal;
} progress;

double seconds_now(void);              /* monotonic clock */
double processor_seconds(void);        /* of all threads of this process: what other programs do does not count */

void progress_start(progress *p, const char *what, double total, double already, const char *unit,
                    double unit_per_step);
void progress_show(progress *p, double done);
void progress_end(progress *p, double done);

#endif
