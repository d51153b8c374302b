/* program: what every program here does about its command line, its directories and being told to stop. */
#ifndef EXAMPLES_PROGRAM_H
#define EXAMPLES_PROGRAM_H

#include <signal.h>
#include <stddef.h>

#include "why.h"

enum { STOPPED = 130 };                            /* exit code of a program that a signal ended */

/* Set once a signal of stop_on has come. The second one is not waited for: it ends the program. */
extern volatile sig_atomic_t interrupted;
void stop_on(int number);

/* The whole number that an option wants, low ... high; text may be NULL. 0, or -1 and w, and *value is as it was. */
int parse_number(const char *name, const char *text, long low, long high, long *value, why *w);

int ends_with(const char *text, const char *end);

/* The directory is there, or is made. 0, or -1 and w. */
int make_directory(const char *path, why *w);

/* A new directory of its own among the temporary files, NAME- and six letters in $TMPDIR. 0, or -1. */
int make_temporary_directory(const char *name, char *path, size_t size);

#endif
