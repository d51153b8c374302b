/* osmesa_context: an OpenGL 4.5 core context that needs no display, no window system and no GPU. */
#ifndef EXAMPLES_OSMESA_CONTEXT_H
#define EXAMPLES_OSMESA_CONTEXT_H

#include "why.h"

typedef struct osmesa_context { void *context, *pixels; } osmesa_context;

/* Makes the context, makes it current in this thread and loads `gl` (gl.h). Draw into framebuffer objects. */
int  osmesa_context_create(osmesa_context *c, why *w);
void osmesa_context_destroy(osmesa_context *c);

#endif
