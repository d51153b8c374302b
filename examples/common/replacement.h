/* replacement: writes a file so that its old content stays until the new one is whole and on the disk. The new content
   goes to a temporary file beside it, is synced, and takes the name: a full disk, a crash or a kill in between leaves
   the old file as it was. */
#ifndef EXAMPLES_REPLACEMENT_H
#define EXAMPLES_REPLACEMENT_H

#include <stdint.h>
#include <stdio.h>

#include "why.h"

typedef struct replacement { FILE *file; char *temporary; const char *path; } replacement;

/* Opens the temporary file; write to r->file, then end with one of the other two. path must outlive r. */
int  replacement_open(const char *path, replacement *r, why *w);
int  replacement_commit(replacement *r, why *w);
void replacement_abandon(replacement *r);

/* Finds out, before long work, whether a file of so many bytes can be written at path; leaves nothing behind. */
int  replacement_possible(const char *path, uint64_t bytes, why *w);

#endif
