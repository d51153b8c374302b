/* contact_sheet: pictures side by side, with heads, names and captions, as one JPEG or PNG. */
#ifndef EXAMPLES_CONTACT_SHEET_H
#define EXAMPLES_CONTACT_SHEET_H

#include "image.h"

enum { SHEET_LINES = 4 };

typedef struct sheet_cell { const picture *shown; char first[80], second[80]; } sheet_cell;   /* shown NULL: empty */

typedef struct contact_sheet {
    const char        *title;
    int               rows, columns, per_pixel;
    int               width, height;                       /* of a cell, in pixels */
    const char *const *heads;                              /* [columns] */
    const char *const *names;                              /* [rows]; a '\n' breaks the line */
    const double      *exposures;                          /* [rows] */
    const sheet_cell  *cells;                              /* [rows][columns] */
    const char        *foot[SHEET_LINES];                  /* as many as are not NULL */
} contact_sheet;

/* JPEG where the path ends in .jpg, else PNG. 0, or -1 with the reason in w. */
int contact_sheet_write(const contact_sheet *s, const char *path, why *w);

#endif
