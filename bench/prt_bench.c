/* prt_bench.c - measures the candidates of candidates.h and whatever peers are plugged in (peer.h), prints the tables,
   and writes CSV. */
#include "configurations.h"

#include <stdlib.h>
#include <string.h>

typedef struct output {
    FILE *csv, *markdown;
    int header_written, failed;
} output;

static const char *precision(const bench_candidate *c) { return c->real_bytes == 4 ? "float" : "double"; }

static const char *ratio(double value, char text[16]) {
    if (value > 0) snprintf(text, 16, "%.*f", value < 10 ? 2 : value < 100 ? 1 : 0, value);
    else strcpy(text, "-");
    return text;
}

/* The row that the others of a group are compared with: the first, which is prt.h's own. */
static void print_group(const bench_row *rows, int count) {
    char a[16], b[16], c[16];
    int i;
    printf("\n%s, %s", rows[0].candidate->job, precision(rows[0].candidate));
    if (rows[0].bands) printf(", %d bands", rows[0].bands);
    printf(", %d items, %.0f bytes out each\n", rows[0].items, rows[0].bytes_written);
    printf("  %-34s %-15s %9s %9s %6s %9s %7s %7s %7s %7s\n", "", "build", "ns", "min", "+-%", "cycles", "/first",
           "/write", "/copy", "/peak");
    for (i = 0; i < count; i++)
        printf("  %-34s %-15s %9.2f %9.2f %6.1f %9.1f %7.2f %7s %7s %7s\n", rows[i].candidate->name,
               rows[i].candidate->build, rows[i].ns, rows[i].ns_min, 100 * rows[i].spread, rows[i].cycles,
               rows[i].ns / rows[0].ns, ratio(rows[i].of_write, a), ratio(rows[i].of_copy, b),
               ratio(rows[i].of_flops, c));
    fflush(stdout);
}

static void markdown_group(FILE *f, const bench_row *rows, int count) {
    char a[16], b[16], c[16];
    int i;
    fprintf(f, "\n### %s, %s", rows[0].candidate->job, precision(rows[0].candidate));
    if (rows[0].bands) fprintf(f, ", %d bands", rows[0].bands);
    fprintf(f, "\n\n| | build | ns | +-%% | cycles | to first | to write | to copy | to peak |\n"
               "|---|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (i = 0; i < count; i++)
        fprintf(f, "| %s | %s | %.2f | %.1f | %.1f | %.2f | %s | %s | %s |\n", rows[i].candidate->name,
                rows[i].candidate->build, rows[i].ns, 100 * rows[i].spread, rows[i].cycles, rows[i].ns / rows[0].ns,
                ratio(rows[i].of_write, a), ratio(rows[i].of_copy, b), ratio(rows[i].of_flops, c));
}

static void csv_group(FILE *f, const bench_row *rows, int count) {
    int i;
    for (i = 0; i < count; i++) {
        const bench_candidate *c = rows[i].candidate;
        fprintf(f, "%s,\"%s\",%d,%s,%s,%d,%d,%.4f,%.4f,%.4f,%.3f,%.0f,%.0f,%.0f,%.4f,%.4f,%.4f\n", c->job, c->name,
                c->peer, c->build, precision(c), rows[i].bands, rows[i].items, rows[i].ns, rows[i].ns_min,
                rows[i].spread, rows[i].cycles, rows[i].flops, rows[i].bytes_read, rows[i].bytes_written,
                rows[i].of_write, rows[i].of_copy, rows[i].of_flops);
    }
}

/* What every output says of its origin, each line after `prefix`. */
static void stamp(FILE *f, const char *prefix) {
    fprintf(f, "%sprt.h %s\n%smachine: %s\n%scompiler: %s\n", prefix, BENCH_VERSION, prefix, bench_cpu_name(), prefix,
            BENCH_COMPILER);
#define FLAGS(id) fprintf(f, "%sflags of %s: %s\n", prefix, #id, bench_flags_##id());
    BENCH_CONFIGURATIONS(FLAGS)
#undef FLAGS
}

static void show(void *user, const bench_row *rows, int count) {
    output *out = (output *)user;
    if (!count) return;
    if (out->csv && !out->header_written) {
        stamp(out->csv, "# ");
        fprintf(out->csv, "job,name,peer,build,precision,bands,items,ns,ns_min,spread,cycles,flops,bytes_read,"
                          "bytes_written,of_write,of_copy,of_flops\n");
        out->header_written = 1;
    }
    print_group(rows, count);
    if (out->csv) csv_group(out->csv, rows, count);
    if (out->markdown) markdown_group(out->markdown, rows, count);
}

static void usage(FILE *f) {
    fputs("usage: prt_bench [--filter WORDS] [--csv FILE] [--markdown FILE] [--quick] [--rounds N]\n"
          "  --filter WORDS   only rows whose job, name, build, precision and bands contain each word;\n"
          "                   =word is a whole word: --filter \"=eval float =5 native\"\n"
          "  --csv FILE       write every figure as comma-separated values\n"
          "  --markdown FILE  write the tables as markdown\n"
          "  --quick          fewer and shorter rounds: rough figures in a tenth of the time\n"
          "  --rounds N       timed rounds of each row [31]\n"
          "Times are for one item, median of all rounds; +-% is half the interquartile range. /first compares with\n"
          "the first row, /write and /copy with memset and memcpy of the same output bytes, /peak with the\n"
          "multiply-adds of the same build at their peak rate, all measured in the same rounds.\n", f);
}

static FILE *open_output(const char *path) {
    FILE *f = fopen(path, "w");
    if (!f) {
        fprintf(stderr, "prt_bench: cannot write %s; choose a place that can be written\n", path);
        exit(1);
    }
    return f;
}

static const char *value_of(int argc, char **argv, int *i) {
    if (*i + 1 < argc) return argv[++*i];
    fprintf(stderr, "prt_bench: %s needs a value\n", argv[*i]);
    usage(stderr);
    exit(2);
}

static void parse(int argc, char **argv, bench_options *options, output *out) {
    int i;
    for (i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--filter")) options->filter = value_of(argc, argv, &i);
        else if (!strcmp(argv[i], "--csv")) out->csv = open_output(value_of(argc, argv, &i));
        else if (!strcmp(argv[i], "--markdown")) out->markdown = open_output(value_of(argc, argv, &i));
        else if (!strcmp(argv[i], "--quick")) { options->rounds = 7; options->slice_ns = 5e4; }
        else if (!strcmp(argv[i], "--rounds")) options->rounds = atoi(value_of(argc, argv, &i));
        else if (!strcmp(argv[i], "--help")) { usage(stdout); exit(0); }
        else {
            fprintf(stderr, "prt_bench: what is %s?\n", argv[i]);
            usage(stderr);
            exit(2);
        }
    }
    if (options->rounds < 1 || options->rounds > 1001) {
        fprintf(stderr, "prt_bench: --rounds takes 1 to 1001\n");
        exit(2);
    }
}

static int close_output(FILE *f) {
    int failed;
    if (!f) return 0;
    failed = ferror(f) != 0;
    return fclose(f) || failed;
}

int main(int argc, char **argv) {
    bench_options options = { NULL, 31, 2e5 };
    output out = { NULL, NULL, 0, 0 };
    parse(argc, argv, &options, &out);
#define ADD_ROWS(id) { int count; const bench_candidate *rows = bench_rows_##id(&count); bench_add(rows, count); }
    BENCH_CONFIGURATIONS(ADD_ROWS)
#undef ADD_ROWS
    stamp(stdout, "");
    if (out.markdown) stamp(out.markdown, "- ");
    if (!bench_run(&options, show, &out)) {
        fprintf(stderr, "prt_bench: nothing matches --filter %s\n", options.filter ? options.filter : "");
        return 1;
    }
    printf("\nclock: %.2f GHz (median)\n", bench_clock_ghz());
    if (out.csv) fprintf(out.csv, "# clock: %.3f GHz\n", bench_clock_ghz());
    if (close_output(out.csv) | close_output(out.markdown)) {
        fprintf(stderr, "prt_bench: could not write all of the output; is the disk full?\n");
        return 1;
    }
    return 0;
}
