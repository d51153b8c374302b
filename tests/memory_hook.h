/* Allocations of the baker, counted, and failing on request; include it in the place of prt_bake.h. The counters are to be
   read by tests that run one thread. */
#ifndef PRT_TEST_MEMORY_HOOK_H
#define PRT_TEST_MEMORY_HOOK_H

#include <stddef.h>

static void *hooked_malloc(size_t size);
static void hooked_free(void *memory);
#define PRT_MALLOC(size) hooked_malloc(size)
#define PRT_FREE(memory) hooked_free(memory)
#define PRT_IMPLEMENTATION
#define PRT_BAKE_IMPLEMENTATION
#include "prt_bake.h"
#include <stdlib.h>

static struct { int calls, frees, fail; size_t size; } memory_hook;

static void *hooked_malloc(size_t size) {
    memory_hook.calls++;
    memory_hook.size = size;
    return memory_hook.fail ? NULL : malloc(size);
}
static void hooked_free(void *memory) {
    memory_hook.frees++;
    free(memory);
}

#endif
