/* command.c - see command.h. */
#include "command.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static void usage(const command *c, FILE *to) {
    int i;
    fprintf(to, "usage: %s%s%s%s\n", c->program, c->words ? " " : "", c->words ? c->words : "",
            c->count ? " [options]" : "");
    for (i = 0; i < c->count; i++) {
        const command_option *o = &c->options[i];
        char head[64];
        snprintf(head, sizeof head, "%s %s", o->name, o->value ? o->value : "");
        fprintf(to, "  %-26s %s\n", head, o->help);
    }
    if (c->about) fputs(c->about, to);
}

static void refuse(const command *c, const char *what, const char *why) {
    fprintf(stderr, "%s: %s: %s\n", c->program, what, why);
    usage(c, stderr);
    exit(2);
}

static void take(const command *c, const command_option *o, const char *value) {
    char why[96], *end;
    long number;
    if (o->value && !value) refuse(c, o->name, "wants a value");
    if (o->text) { *o->text = value; return; }
    if (!o->value) { *o->number = 1; return; }
    errno = 0;
    number = strtol(value, &end, 10);
    if (end == value || *end || errno || number < o->least || number > o->most) {
        snprintf(why, sizeof why, "must be a whole number from %d to %d", o->least, o->most);
        refuse(c, o->name, why);
    }
    *o->number = (int)number;
}

int command_read(const command *c, int argc, char **argv) {
    int words = 0, k, i;
    for (k = 1; k < argc; k++) {
        if (!strcmp(argv[k], "--help")) { usage(c, stdout); exit(0); }
        for (i = 0; i < c->count && strcmp(argv[k], c->options[i].name); i++) {}
        if (i < c->count) {
            take(c, &c->options[i], k + 1 < argc ? argv[k + 1] : NULL);
            k += c->options[i].value != NULL;
        } else if (argv[k][0] == '-' || !c->words) refuse(c, argv[k], "not understood");
        else argv[words++] = argv[k];
    }
    return words;
}

FILE *command_open(const command *c, const char *path) {
    FILE *f = path ? fopen(path, "w") : NULL;
    if (f || !path) return f;
    fprintf(stderr, "%s: cannot write %s: %s; choose a place that can be written\n", c->program, path, strerror(errno));
    exit(1);
}

int command_close(const command *c, FILE *f) {
    int failed;
    if (!f) return 0;
    failed = ferror(f) != 0;
    if (!fclose(f) && !failed) return 0;
    fprintf(stderr, "%s: could not write all of the output; is the disk full?\n", c->program);
    return 1;
}
