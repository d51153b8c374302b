/* plot: curves through gnuplot, into an SVG. */
#ifndef EXAMPLES_PLOT_H
#define EXAMPLES_PLOT_H

#include <stdio.h>

#include "why.h"

enum { PLOT_SERIES = 8, PLOT_PLACES = 128 };

typedef struct plot {
    const char *title, *across, *up, *more;                /* more: further commands of gnuplot */
    int        series, places;
    const char *names[PLOT_SERIES];
    double     x[PLOT_SERIES][PLOT_PLACES], y[PLOT_SERIES][PLOT_PLACES];
} plot;

/* gnuplot, to be sent commands; NULL, and w, if it cannot be started. plot_close says with -1 and w that it failed to
   draw into `path`. */
FILE *plot_open(why *w);
int  plot_close(FILE *to, const char *path, why *w);

/* Writes the file; 0, or -1 with the reason in w. */
int plot_draw(const plot *p, const char *path, why *w);

#endif
