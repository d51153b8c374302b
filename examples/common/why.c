#include "why.h"

#include <stdarg.h>
#include <stdio.h>

int why_set(why *w, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(w->line, sizeof w->line, format, args);
    va_end(args);
    return -1;
}
