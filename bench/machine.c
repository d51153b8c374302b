/* machine.c - the machine's clock, and the processor's name for the stamps of tables. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

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
