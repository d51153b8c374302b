/* One line that says what went wrong, where, and what to do; handed up to the program, which prints it. */
#ifndef EXAMPLES_WHY_H
#define EXAMPLES_WHY_H

typedef struct why { char line[640]; } why;

/* Writes the line (printf's rules) and returns -1, so that a failing function can end with `return why_set(...)`. */
int why_set(why *w, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

#endif
