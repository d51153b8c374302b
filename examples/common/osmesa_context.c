#include "osmesa_context.h"

#include <GL/osmesa.h>
#include <stdlib.h>
#include <string.h>

/* gl.h declares the functions of OpenGL by other means than osmesa.h's <GL/gl.h>, so it stays out of this file. */
typedef void (*gl_pointer)(void);
int gl_load(gl_pointer (*address)(const char *name), why *w);

static gl_pointer address_of(const char *name) { return (gl_pointer)OSMesaGetProcAddress(name); }

int osmesa_context_create(osmesa_context *c, why *w) {
    static const int attributes[] = {
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 0, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
        OSMESA_CONTEXT_MAJOR_VERSION, 4, OSMESA_CONTEXT_MINOR_VERSION, 5, 0
    };
    memset(c, 0, sizeof *c);
    c->context = OSMesaCreateContextAttribs(attributes, NULL);
    if (!c->context)
        return why_set(w, "OSMesa: no OpenGL 4.5 core context: is GALLIUM_DRIVER set to another than llvmpipe?");
    c->pixels = calloc(16 * 16, 4);                        /* OSMesa insists on a picture; nothing is drawn there */
    if (!c->pixels || !OSMesaMakeCurrent((OSMesaContext)c->context, c->pixels, GL_UNSIGNED_BYTE, 16, 16)) {
        osmesa_context_destroy(c);
        return why_set(w, "OSMesa: the context cannot be made current");
    }
    if (gl_load(address_of, w) == 0) return 0;
    osmesa_context_destroy(c);
    return -1;
}

void osmesa_context_destroy(osmesa_context *c) {
    if (c->context) OSMesaDestroyContext((OSMesaContext)c->context);
    free(c->pixels);
    memset(c, 0, sizeof *c);
}
