#include "contact_sheet.h"

#include <stdio.h>
#include <string.h>

#include "text.h"

enum { MARGIN = 20, GAP = 8, LABEL = 116, HEAD = 84, CAPTION = 46, LINE = 19 };

typedef struct sheet { canvas c; text_font regular, bold; } sheet;

static void centred(sheet *s, const text_font *font, double size, int x, int width, int y, int grey, const char *line) {
    double wide = text_width(font, size, line);
    if (wide > width + GAP) { size *= (width + GAP) / wide; wide = width + GAP; }
    text_draw(&s->c, font, size, x + 0.5 * (width - wide), y, grey, line);
}

/* The lines of a row's name, around its middle. */
static void put_name(sheet *s, const char *name, int middle) {
    char line[64];
    int lines = 1, k;
    const char *at = name;
    for (; *at; at++) lines += *at == '\n';
    for (k = 0, at = name; k < lines; k++) {
        size_t length = strcspn(at, "\n");
        snprintf(line, sizeof line, "%.*s", (int)length, at);
        centred(s, k ? &s->regular : &s->bold, k ? 14 : 16, MARGIN, LABEL - 12, middle + 20 * k - 10 * (lines - 1),
                k ? 165 : 225, line);
        at += length + (at[length] == '\n');
    }
}

static int draw(const contact_sheet *d, sheet *s, int foot, why *w) {
    int width = 2 * MARGIN + LABEL + d->columns * (d->width + GAP) - GAP, row, column, k;
    int height = HEAD + d->rows * (d->height + CAPTION) + foot * LINE + MARGIN;
    if (canvas_create(width, height, &s->c, w) || text_font_load(0, &s->regular, w) || text_font_load(1, &s->bold, w))
        return -1;
    memset(s->c.rgb, 26, 3 * (size_t)width * (size_t)height);
    text_draw(&s->c, &s->bold, 23, MARGIN, MARGIN + 18, 245, d->title);
    for (column = 0; column < d->columns; column++)
        centred(s, &s->bold, 16, MARGIN + LABEL + column * (d->width + GAP), d->width, HEAD - 10, 225,
                d->heads[column]);
    for (row = 0; row < d->rows; row++) {
        int y = HEAD + row * (d->height + CAPTION);
        put_name(s, d->names[row], y + d->height / 2);
        for (column = 0; column < d->columns; column++) {
            const sheet_cell *cell = &d->cells[row * d->columns + column];
            int x = MARGIN + LABEL + column * (d->width + GAP);
            if (cell->shown) canvas_put_picture(&s->c, x, y, cell->shown, d->per_pixel, d->exposures[row]);
            centred(s, &s->bold, 14, x, d->width, y + d->height + 16, 235, cell->first);
            centred(s, &s->regular, 13, x, d->width, y + d->height + 32, 165, cell->second);
        }
    }
    for (k = 0; k < foot; k++)
        text_draw(&s->c, &s->regular, 14, MARGIN, height - MARGIN - (foot - 1 - k) * LINE, 150, d->foot[k]);
    return 0;
}

int contact_sheet_write(const contact_sheet *d, const char *path, why *w) {
    size_t length = strlen(path);
    sheet s;
    int failed, foot = 0;
    memset(&s, 0, sizeof s);
    while (foot < SHEET_LINES && d->foot[foot]) foot++;
    failed = draw(d, &s, foot, w);
    if (!failed) failed = length > 4 && strcmp(path + length - 4, ".jpg") == 0 ? canvas_write_jpg(&s.c, path, w)
                                                                               : canvas_write_png(&s.c, path, w);
    canvas_free(&s.c);
    text_font_free(&s.regular);
    text_font_free(&s.bold);
    return failed ? -1 : 0;
}
