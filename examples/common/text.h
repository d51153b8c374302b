/* text: lines of UTF-8 on a canvas, with a TrueType font of the system. */
#ifndef EXAMPLES_TEXT_H
#define EXAMPLES_TEXT_H

#include "image.h"

typedef struct text_font { unsigned char *file; void *info; } text_font;

/* Loads the first of some usual sans-serif fonts (Debian's fonts-dejavu-core among them), bold if wanted. */
int    text_font_load(int bold, text_font *font, why *w);
void   text_font_free(text_font *font);

double text_width(const text_font *font, double size, const char *line);

/* Writes one line in this grey (0 black ... 255 white), its base line's left end at (x, y). size: pixels from ascent to
   descent. What lies outside the canvas is clipped. */
void   text_draw(canvas *c, const text_font *font, double size, double x, double y, int grey, const char *line);

#endif
