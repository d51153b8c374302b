/* machine.c - the machine's clock, the processor's name for the stamps of tables, and lists of bands. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

double bench_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

const char *bench_cpu_name(void) {
    static char name[256];
    char line[256], family[32] = "", model[32] = "";
    FILE *f;
    if (*name) return name;
    snprintf(name, sizeof name, "unknown processor");
    f = fopen("/proc/cpuinfo", "r");
    if (!f) return name;
    while (fgets(line, sizeof line, f) && line[0] != '\n') {
        char *value = strchr(line, ':');
        if (!value) continue;
        value[strcspn(value, "\n")] = 0;
        value += value[1] == ' ' ? 2 : 1;
        if (!strncmp(line, "model name", 10)) snprintf(name, sizeof name, "%.200s", value);
        else if (!strncmp(line, "cpu family", 10)) snprintf(family, sizeof family, "%.20s", value);
        else if (!strncmp(line, "model\t", 6)) snprintf(model, sizeof model, "%.20s", value);
    }
    fclose(f);
    if (*family) snprintf(name + strlen(name), sizeof name - strlen(name), " (family %s model %s)", family, model);
    return name;
}

int bench_has_band(const char *list, int bands) {
    while (*list) {
        char *end;
        long first = strtol(list, &end, 10), last = first;
        if (end == list) return 0;
        if (*end == '-') last = strtol(end + 1, &end, 10);
        if (bands >= first && bands <= last) return 1;
        list = *end == ',' ? end + 1 : end;
    }
    return 0;
}
