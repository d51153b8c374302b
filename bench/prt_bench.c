/* prt_bench.c - measures the candidates of candidates.h and whatever peers are plugged in (peer.h), prints the tables,
   and writes CSV. */
#include "command.h"
#include "configurations.h"

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

static const char about[] =
    "Every word of a filter is in a row's job, name, build, precision and bands; =word is a whole word of them:\n"
    "--filter \"=eval float =5 native\". Times are for one item, median of all rounds; +-% is half the interquartile\n"
    "range. /first compares with the first row, /write and /copy with memset and memcpy of the same output bytes,\n"
    "/peak with the multiply-adds of the same build at their peak rate, all measured in the same rounds.\n";

int main(int argc, char **argv) {
    bench_options options = { NULL, 31, 2e5 };
    output out = { NULL, NULL, 0, 0 };
    const char *csv = NULL, *markdown = NULL;
    int quick = 0, rounds = 0;
    const command_option known[] = {
        { "--filter", "WORDS", "only rows that have all of the words", &options.filter, NULL, 0, 0 },
        { "--csv", "FILE", "write every figure as comma-separated values", &csv, NULL, 0, 0 },
        { "--markdown", "FILE", "write the tables as markdown", &markdown, NULL, 0, 0 },
        { "--quick", NULL, "fewer and shorter rounds: rough figures in a tenth of the time", NULL, &quick, 0, 0 },
        { "--rounds", "N", "timed rounds of each row [31]", NULL, &rounds, 1, 1001 }
    };
    const command line = { "prt_bench", NULL, about, known, 5 };
    command_read(&line, argc, argv);
    if (quick) { options.rounds = 7; options.slice_ns = 5e4; }
    if (rounds) options.rounds = rounds;
    out.csv = command_open(&line, csv);
    out.markdown = command_open(&line, markdown);
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
    return command_close(&line, out.csv) | command_close(&line, out.markdown);
}
