#define _POSIX_C_SOURCE 200809L
#include "plot.h"

#include <stdio.h>

FILE *plot_open(why *w) {
    FILE *to = popen("gnuplot 2>/dev/null", "w");
    if (!to) why_set(w, "gnuplot cannot be started: install gnuplot-nox");
    return to;
}

int plot_close(FILE *to, const char *path, why *w) {
    if (pclose(to) == 0) return 0;
    return why_set(w, "%s: cannot be drawn: gnuplot is missing or failed; install gnuplot-nox", path);
}

int plot_draw(const plot *p, const char *path, why *w) {
    FILE *to = plot_open(w);
    int k, i;
    if (!to) return -1;
    fprintf(
        to,
        "set terminal svg size 760,420 background rgb 'white'\nset output '%s'\nset title '%s'\nset xlabel '%s'\n"
        "set ylabel '%s'\nset grid\nset key outside right\n%s\nplot ",
        path, p->title, p->across, p->up, p->more);
    for (k = 0; k < p->series; k++)
        fprintf(to, "%s'-' with %s lw 2 title '%s'", k ? ", " : "", p->places > 20 ? "lines" : "linespoints",
                p->names[k]);
    fprintf(to, "\n");
    for (k = 0; k < p->series; k++) {
        for (i = 0; i < p->places; i++) fprintf(to, "%g %g\n", p->x[k][i], p->y[k][i]);
        fprintf(to, "e\n");
    }
    return plot_close(to, path, w);
}
