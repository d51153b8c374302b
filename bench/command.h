/* command.h - command lines and output files of the programs in bench/. */
#ifndef BENCH_COMMAND_H
#define BENCH_COMMAND_H

#include <stdio.h>

typedef struct command_option {
    const char *name, *value;          /* "--csv"; "FILE", or NULL where the option stands alone */
    const char *help;
    const char **text;                 /* receives the value; or, if this is NULL, */
    int *number;                       /* this does, 1 for an option that stands alone */
    int least, most;                   /* of the number */
} command_option;

typedef struct command {
    const char *program, *words;       /* "bake", "speed|error": what beside options is expected, NULL: nothing */
    const char *about;                 /* lines below the options in --help, or NULL */
    const command_option *options;
    int count;
} command;

/* Fills in what the options point to; words go to the front of argv, and their number is returned. --help prints and
   ends the program with 0, anything that is not understood with 2 and a line that says why. */
int command_read(const command *c, int argc, char **argv);

/* A file to write, NULL for a NULL path; or the program ends with 1. */
FILE *command_open(const command *c, const char *path);
/* 0, or 1 after saying that not all was written. NULL: 0. */
int command_close(const command *c, FILE *f);

#endif
