#define _XOPEN_SOURCE 700
#include "program.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

volatile sig_atomic_t interrupted;

static void on_interrupt(int number) {
    interrupted = 1;
    signal(number, SIG_DFL);
}

void stop_on(int number) { signal(number, on_interrupt); }

int parse_number(const char *name, const char *text, long low, long high, long *value, why *w) {
    char *end;
    long n;
    if (!text) return why_set(w, "%s wants a number (--help lists the options)", name);
    errno = 0;
    n = strtol(text, &end, 10);
    if (end == text || *end || errno || n < low || n > high)
        return why_set(w, "%s %s: must be a whole number from %ld to %ld", name, text, low, high);
    *value = n;
    return 0;
}

int ends_with(const char *text, const char *end) {
    size_t a = strlen(text), b = strlen(end);
    return a >= b && strcmp(text + a - b, end) == 0;
}

int make_directory(const char *path, why *w) {
    struct stat s;
    if (mkdir(path, 0777) == 0 || (errno == EEXIST && stat(path, &s) == 0 && S_ISDIR(s.st_mode))) return 0;
    return why_set(w, "%s: cannot be made a directory: %s; choose another", path,
                   strerror(errno == EEXIST ? ENOTDIR : errno));
}

int make_temporary_directory(const char *name, char *path, size_t size) {
    const char *place = getenv("TMPDIR");
    int length = snprintf(path, size, "%s/%s-XXXXXX", place && *place ? place : P_tmpdir, name);
    return length >= 0 && (size_t)length < size && mkdtemp(path) ? 0 : -1;
}
