#ifndef _POSIX_C_SOURCE
#  define _POSIX_C_SOURCE 200809L
#endif
#include "replacement.h"

#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int replacement_open(const char *path, replacement *r, why *w) {
    size_t size = strlen(path) + 32;
    r->path = path;
    r->file = NULL;
    r->temporary = (char *)malloc(size);
    if (!r->temporary) return why_set(w, "%s: out of memory", path);
    snprintf(r->temporary, size, "%s.%ld.tmp", path, (long)getpid());
    r->file = fopen(r->temporary, "wb");
    if (r->file) return 0;
    why_set(w, "%s: cannot be created: %s", path, strerror(errno));
    free(r->temporary);
    return -1;
}

void replacement_abandon(replacement *r) {
    if (r->file) fclose(r->file);
    unlink(r->temporary);
    free(r->temporary);
}

/* The rename itself reaches the disk only with its directory. Where a file system cannot sync a directory, the rename
   is still atomic, so a failure here is not one of the save. */
static void sync_directory(const char *path) {
    char *copy = strdup(path);
    int directory = copy ? open(dirname(copy), O_RDONLY) : -1;
    if (directory >= 0) {
        (void)fsync(directory);
        close(directory);
    }
    free(copy);
}

int replacement_commit(replacement *r, why *w) {
    int failed = fflush(r->file) || ferror(r->file) || fsync(fileno(r->file)), error = errno;
    if (fclose(r->file) && !failed) {
        failed = 1;
        error = errno;
    }
    r->file = NULL;
    if (!failed && rename(r->temporary, r->path)) {
        failed = 1;
        error = errno;
    }
    if (failed) {
        replacement_abandon(r);
        return why_set(w, "%s: cannot be written: %s", r->path, strerror(error));
    }
    free(r->temporary);
    sync_directory(r->path);
    return 0;
}

int replacement_possible(const char *path, uint64_t bytes, why *w) {
    replacement r;
    int error;
    if (replacement_open(path, &r, w)) return -1;
    error = bytes > INT64_MAX ? EFBIG : posix_fallocate(fileno(r.file), 0, (off_t)(bytes ? bytes : 1));
    replacement_abandon(&r);
    if (!error || error == EINVAL || error == EOPNOTSUPP) return 0;  /* the latter: this file system cannot tell */
    return why_set(w, "%s: there is no room for its %.1f MB: %s", path, (double)bytes * 1e-6, strerror(error));
}
